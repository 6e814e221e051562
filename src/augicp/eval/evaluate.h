// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "augicp/eval/coverage.h"
#include "augicp/eval/segment_errors.h"
#include "augicp/eval/statistics.h"
#include "augicp/eval/trajectory_error.h"

namespace augicp {

struct EvaluationOptions {
  AssociationOptions association{};
  TruthReading truth = TruthReading::Nearest;
  Alignment alignment = Alignment::Rigid;
  DeltaOptions delta{};
  SegmentOptions segments{};

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

struct PoseStatistics {
  Statistics translation, rotation;  // metres, radians
};

// Errors of an estimated trajectory against the true one.
struct Evaluation {
  EvaluationOptions options;
  std::size_t num_estimate = 0, num_truth = 0;     // poses in the inputs
  std::size_t num_matched = 0;                     // poses of the estimate with a true pose of the same moment
  double matched_share = 0.0;                      // num_matched / num_estimate
  Coverage coverage;                               // what the errors leave out
  double first_stamp_s = 0.0, last_stamp_s = 0.0;  // of the matched poses, in the clock of the truth
  PoseStatistics absolute;                         // not aligned
  RigidFit alignment;                              // maps the estimate's world to the true one
  std::optional<PoseStatistics> aligned;           // absolute, after the alignment; empty for Alignment::None
  std::optional<PoseStatistics> relative;          // with the alignment's scale; empty if no two poses are delta apart
  SegmentErrors segments;                          // KITTI's, of the matched poses, without scale
};

// Compares two trajectories world_from_camera, each in its own world. Throws std::invalid_argument for options out of
// range, and if the trajectories cannot be compared: see match_poses, fit_rigid and statistics_of.
Evaluation evaluate(const Trajectory& estimate, const Trajectory& truth, const EvaluationOptions& options = {});

}  // namespace augicp
