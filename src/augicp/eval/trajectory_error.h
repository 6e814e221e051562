// SPDX-License-Identifier: MIT
// The two errors of J. Sturm et al., "A Benchmark for the Evaluation of RGB-D SLAM Systems" (IROS 2012): absolute (ATE;
// of positions and orientations together also called APE) and relative (RPE).
#pragma once

#include <span>
#include <vector>

#include "augicp/core/words.h"
#include "augicp/eval/pose_pairs.h"
#include "augicp/eval/rigid_fit.h"

namespace augicp {

// How the estimate's world is aligned with the true one.
enum class Alignment {
  None,        // not aligned
  Origin,      // the first poses are made equal
  Rigid,       // least squares over the positions of all poses
  Similarity,  // the same with a scale, for estimates of unknown scale
};
template <>
inline constexpr auto kWords<Alignment> = std::to_array<Word<Alignment>>({{Alignment::None, "none"},
                                                                          {Alignment::Origin, "origin"},
                                                                          {Alignment::Rigid, "rigid"},
                                                                          {Alignment::Similarity, "similarity"}});

// The motion from the estimate's world to the true one. Throws std::invalid_argument for no poses; see also fit_rigid.
RigidFit align_to_truth(std::span<const MatchedPose> poses, Alignment alignment);

struct PoseErrors {
  std::vector<double> translation, rotation;  // metres; radians in [0, pi]
};

// For each pose, with E = truth^-1 (truth_from_estimate * estimate): the length of E's translation, which is the
// distance between the two positions, and the angle of its rotation.
PoseErrors absolute_errors(std::span<const MatchedPose> poses, const Similarity3& truth_from_estimate = {});

// For each pair i, j, with E = (truth_i^-1 truth_j)^-1 (estimate_i^-1 estimate_j): the length of E's translation and
// the angle of its rotation. Neither depends on the frames of the worlds. The estimate's positions are multiplied by
// scale first.
PoseErrors relative_errors(std::span<const MatchedPose> poses, std::span<const PosePair> pairs, double scale = 1.0);

}  // namespace augicp
