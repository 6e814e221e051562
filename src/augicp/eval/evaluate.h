// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "augicp/eval/statistics.h"
#include "augicp/eval/trajectory_error.h"

namespace augicp {

struct EvaluationOptions {
  AssociationOptions association{};
  TruthReading truth = TruthReading::Nearest;
  Alignment alignment = Alignment::Rigid;
  DeltaOptions delta{};

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

struct PoseStatistics {
  Statistics translation, rotation;  // metres, radians
};

// How far an estimated trajectory is from the true one.
struct Evaluation {
  EvaluationOptions options;
  std::size_t num_estimate = 0, num_truth = 0;     // poses that were given
  std::size_t num_matched = 0;                     // of the estimate, with a true pose of the same moment
  double matched_share = 0.0;                      // num_matched / num_estimate
  double first_stamp_s = 0.0, last_stamp_s = 0.0;  // of the matched poses, by the truth's clock
  PoseStatistics absolute;                         // the worlds as they are, not aligned
  RigidFit alignment;                              // from the estimate's world to the true one
  std::optional<PoseStatistics> aligned;           // absolute, after the alignment; nothing for Alignment::None
  std::optional<PoseStatistics> relative;          // with the alignment's scale; nothing where no pair is delta apart
};

// Both trajectories are world_from_camera, each in its own world. Throws std::invalid_argument for options out of
// range, and where the trajectories cannot be compared: see match_poses, fit_rigid and statistics_of.
Evaluation evaluate(const Trajectory& estimate, const Trajectory& truth, const EvaluationOptions& options = {});

}  // namespace augicp
