// SPDX-License-Identifier: MIT
// Does the verdict keep its word? Pairs whose answer is known, and what the status says of each.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/align/align.h"
#include "augicp/experiment/pose_error.h"
#include "augicp/io/depth_sequence.h"
#include "augicp/registration/options.h"

namespace augicp {

// A sequence of depth images, with its true trajectory where it has one.
struct VerdictSequence {
  std::string name;
  DepthSequence sequence;
  DepthCamera camera;
};

struct VerdictOptions {
  // Pairs within a sequence with truth: frames so many apart, every so many frames a target, from the identity.
  std::vector<std::size_t> gaps{1, 10, 20};
  std::size_t every = 1;

  // So many pairs of frames drawn from two different sequences, which must show nothing in common.
  std::size_t num_across = 0;
  unsigned seed = 1;

  int pixel_step = 4;
  double time_offset_s = 0.0;  // truth is read at stamp + offset
  bool as_clouds = false;      // without cameras: bare points, and nearest neighbours

  // A result is right within these, and wrong beyond twice of either; what lies between is near.
  PoseError right{0.05, 0.05235987755982989};  // 5 cm, 3 degrees

  // A right result with less true overlap may be refused.
  double min_true_overlap = 0.3;

  RegistrationOptions registration;

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

enum class PairTruth {
  Apart,        // no common surface
  Wrong,        // the pose found is wrong
  Near,         // it is neither right nor clearly wrong
  RightLittle,  // right, with little overlap
  Right,
};
std::string_view name_of(PairTruth truth);

struct VerdictPair {
  std::string target_sequence, source_sequence;
  std::size_t target = 0, source = 0;  // numbers of the frames
  PairTruth truth = PairTruth::Apart;
  std::optional<PoseError> error;
  double true_overlap = 0.0;  // share of the source's points that the target sees again under the true motion
  AlignStatus status = AlignStatus::TooFewPairs;
  AlignStatus without_verdict = AlignStatus::TooFewPairs;  // what the loop alone would have said
  std::optional<Evidence> evidence;
  std::optional<double> nees;  // the normalised error squared, over six: 1 on average where the covariance is right
};

// Pairs within, then pairs across. on_pair is called after each.
std::vector<VerdictPair> run_verdict(std::span<const VerdictSequence> sequences, const VerdictOptions& options,
                                     const std::function<void()>& on_pair);
std::size_t num_pairs(std::span<const VerdictSequence> sequences, const VerdictOptions& options);

// Of each truth, how many pairs have each status.
struct ConfusionRow {
  PairTruth truth = PairTruth::Apart;
  std::size_t num_pairs = 0;
  std::size_t num_converged = 0, num_doubtful = 0, num_degenerate = 0, num_iteration_limit = 0, num_failed = 0;
  std::size_t num_converged_without_verdict = 0;  // the loop's own word
};
std::vector<ConfusionRow> confusion(std::span<const VerdictPair> pairs);

// What would be accepted if a strain up to this were allowed (1: the limits as they are).
struct RocPoint {
  double max_strain = 0.0;
  double apart_accepted = 0.0, wrong_accepted = 0.0, right_refused = 0.0;  // shares
};
std::vector<RocPoint> roc(std::span<const VerdictPair> pairs);

}  // namespace augicp
