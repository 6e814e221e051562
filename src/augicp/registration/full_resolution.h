// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "augicp/registration/judge.h"
#include "augicp/registration/options.h"
#include "augicp/registration/prepared_pair.h"

namespace augicp {

class MotionProbe;

// Not set: there is none.
using Guess = std::optional<Rigid3>;

// The loop at full resolution and its verdict, from one start after the other. Poses are between the scans' points. The
// scans must outlive it.
class FullResolution {
 public:
  // guess: where the search for the pose began.
  FullResolution(const ScanPair& pair, const Guess& guess_target_from_source, const RegistrationOptions& options);

  // Motions that the scans say nothing of are free, whatever the information of noisy surfaces: along them the result
  // is at the guess, or at the start if there is none. Motions of which clouds say something are not, however little
  // information there is. turn: for the listener of the options.
  AlignResult from(const Rigid3& start_target_from_source, Turn turn = {}) const;

  // The pose to which a few points of the source lead within a few iterations. One that was found on few points of both
  // scans is off by up to their spacing.
  Rigid3 refined(const Rigid3& target_from_source) const;

  // Whether a pose found on few points is near enough to a supported one to be led on. A rival of a pose lies far from
  // the guess by its nature: it counts as if it had moved no farther than that pose, see Evidence::moved.
  bool is_promising(const Rigid3& target_from_source, double max_moved = kMovedFromAnywhere) const;

 private:
  using Matchers = std::pair<std::unique_ptr<ScanMatcher>, std::unique_ptr<ScanMatcher>>;  // of target and source
  FullResolution(const ScanPair& pair, const Guess& guess_target_from_source, const RegistrationOptions& options,
                 Matchers matchers);

  double doubtful_information(const AlignResult& result) const;
  bool is_doubtful(const AlignResult& result) const;
  bool can_be_asked(const AlignResult& result) const;
  AlignResult aligned(const Rigid3& start_target_from_source, const std::optional<FreeDirections>& free) const;
  FreeDirections free_directions(const AlignResult& result, const MotionProbe& probe) const;
  bool is_gain(const AlignResult& again, const AlignResult& result, const MotionProbe& probe) const;
  AlignResult found_from(const Rigid3& start_target_from_source) const;
  AlignResult asked(AlignResult first, const Rigid3& start_target_from_source) const;
  AlignResult held_where_idle(AlignResult result, const Rigid3& start_target_from_source) const;
  Rigid3 at_guess_along(const FreeDirections& free, const Rigid3& target_from_source) const;

  ScanPair pair_;
  Guess guess_target_from_source_;
  bool is_paper_;
  AlignOptions align_by_;
  StageListener on_stage_;
  std::unique_ptr<ScanMatcher> matcher_;
  Judge judge_;
};

}  // namespace augicp
