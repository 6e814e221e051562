// SPDX-License-Identifier: MIT
// Measures how often the verdict is right: pairs with a known answer, and the status of each.
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

// A sequence of depth images, with its true trajectory if it has one.
struct VerdictSequence {
  std::string name;
  DepthSequence sequence;
  DepthCamera camera;
};

struct VerdictOptions {
  // Pairs within a sequence with truth: these numbers of frames apart, with every N-th frame a target, from the
  // identity.
  std::vector<std::size_t> gaps{1, 10, 20};
  std::size_t every = 1;

  // Number of pairs of frames drawn from two different sequences, which must have no surface in common.
  std::size_t num_across = 0;
  unsigned seed = 1;

  int pixel_step = 4;
  double time_offset_s = 0.0;  // the truth is read at stamp + offset
  bool as_clouds = false;      // without cameras: bare points, and nearest neighbours

  // A result is right within these, wrong beyond twice of either, and near in between.
  PoseError right{0.05, 0.05235987755982989};  // 5 cm, 3 degrees

  // A right result with less true overlap than this may be refused.
  double min_true_overlap = 0.3;

  RegistrationOptions registration;

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

enum class PairTruth {
  Apart,        // no common surface
  Wrong,        // the pose is wrong
  Near,         // the pose is neither right nor clearly wrong
  RightLittle,  // right, with little overlap
  Right,
};
template <>
inline constexpr auto kWords<PairTruth> = std::to_array<Word<PairTruth>>({{PairTruth::Apart, "apart"},
                                                                          {PairTruth::Wrong, "wrong"},
                                                                          {PairTruth::Near, "near"},
                                                                          {PairTruth::RightLittle,
                                                                           "right_little_overlap"},
                                                                          {PairTruth::Right, "right"}});

struct VerdictPair {
  std::string target_sequence, source_sequence;
  std::size_t target = 0, source = 0;  // numbers of the frames
  PairTruth truth = PairTruth::Apart;
  std::optional<PoseError> error;
  double true_overlap = 0.0;  // share of the source's points that the target sees under the true motion
  AlignStatus status = AlignStatus::TooFewPairs;
  AlignStatus without_verdict = AlignStatus::TooFewPairs;  // status of the iteration alone
  std::vector<Doubt> doubts;                               // as AlignResult::doubts
  std::optional<Evidence> evidence;
  std::optional<double> nees;  // the normalised error squared, over six: 1 on average if the covariance is right
};

// Pairs within, then pairs across. on_pair is called after each.
std::vector<VerdictPair> run_verdict(std::span<const VerdictSequence> sequences, const VerdictOptions& options,
                                     const std::function<void()>& on_pair);
std::size_t num_pairs(std::span<const VerdictSequence> sequences, const VerdictOptions& options);

// For each truth, the number of pairs with each status.
struct ConfusionRow {
  PairTruth truth = PairTruth::Apart;
  std::size_t num_pairs = 0;
  std::size_t num_converged = 0, num_doubtful = 0, num_degenerate = 0, num_iteration_limit = 0, num_failed = 0;
  std::size_t num_converged_without_verdict = 0;  // status of the iteration alone
};
std::vector<ConfusionRow> confusion(std::span<const VerdictPair> pairs);

// The results accepted if a strain up to this were allowed (1: the limits in use).
struct RocPoint {
  double max_strain = 0.0;
  double apart_accepted = 0.0, wrong_accepted = 0.0, right_refused = 0.0;  // shares
};
std::vector<RocPoint> roc(std::span<const VerdictPair> pairs);

}  // namespace augicp
