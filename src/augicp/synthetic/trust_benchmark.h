// SPDX-License-Identifier: MIT
// How often a status is right, on families of generated pairs: each stands for a class of inputs, none for a data set.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "augicp/core/words.h"
#include "augicp/experiment/pose_error.h"
#include "augicp/registration/options.h"
#include "augicp/trust/verdict.h"

namespace augicp::synthetic {

struct TrustPair {
  Scan source, target;
  std::optional<Rigid3> target_from_source;  // not set: the two have no common surface
  Rigid3 guess;                              // target_from_source to start from
  std::vector<Vec6d> free_motions;           // a basis of what no data constrain: increments about the target's zero
};

struct TrustFamily {
  std::string name;
  std::function<TrustPair(unsigned seed)> draw;
  PoseError right;  // a pose nearer to the truth than this is right
};

// Corridors, tunnels, colonnades, fields and streets seen by LiDARs of many kinds; corridors, walls and rooms seen by
// depth cameras; twelve degenerate shapes as bare clouds; objects moved, half-turned, mirrored, unlike, and in part;
// whole rooms half-turned and mirrored.
std::vector<TrustFamily> trust_families();

// What became of a pair.
struct TrustOutcome {
  unsigned seed = 0;
  AlignStatus status = AlignStatus::TooFewPairs;
  std::optional<PoseError> error;  // not set: the pair has no common surface
  bool is_right = false;
  std::optional<Evidence> evidence;
  double strain = 0.0;            // of the evidence; infinite without
  bool is_named = false;          // degenerate, with the true number of free motions, each within 5 degrees
  double moved_along_free = 0.0;  // from the guess along the motions that it calls free, in gyration radii
};
TrustOutcome outcome_of(unsigned seed, const TrustPair& pair, const PoseError& right, const AlignResult& result);

// Registers the pairs of these seeds, side by side on options.num_threads threads. on_pair is called after each, from
// one thread at a time. The outcomes are in the order of the seeds.
std::vector<TrustOutcome> run_trust(const TrustFamily& family, std::span<const unsigned> seeds,
                                    const RegistrationOptions& options, const std::function<void()>& on_pair = {});

// Limits are chosen on the pairs with odd seeds, and reported are those with even ones.
enum class TrustHalf { Choose, Report };
}  // namespace augicp::synthetic

namespace augicp {
template <>
inline constexpr auto kWords<synthetic::TrustHalf> = std::to_array<Word<synthetic::TrustHalf>>(
    {{synthetic::TrustHalf::Choose, "choose"}, {synthetic::TrustHalf::Report, "report"}});
}  // namespace augicp

namespace augicp::synthetic {

// The first `count` seeds of a half from `first` on.
std::vector<unsigned> trust_seeds(TrustHalf half, unsigned first, std::size_t count);

struct TrustRow {
  std::size_t num_pairs = 0;
  std::size_t right_converged = 0, right_refused = 0;  // refused: any other status but Ambiguous and Degenerate
  std::size_t wrong_converged = 0, wrong_refused = 0;
  std::size_t ambiguous = 0, degenerate = 0;
  std::size_t named = 0;      // of the degenerate
  double largest_move = 0.0;  // of a degenerate result along what it names, in gyration radii
};
TrustRow row_of(std::span<const TrustOutcome> outcomes);

// The outcomes that were accepted if a strain up to max_strain were (1: the limits in use): shares of the wrong and of
// the right among those that are Converged or Doubtful.
struct TrustRocPoint {
  double max_strain = 0.0;
  double wrong_accepted = 0.0, right_refused = 0.0;
};
std::vector<TrustRocPoint> trust_roc(std::span<const TrustOutcome> outcomes);

// The distance that a result has moved from the guess along the motions that it calls free, in gyration radii of its
// paired points; 0 where it calls none free.
double move_along_free(const AlignResult& result, const Rigid3& guess, const Cloud& source, const Cloud& target);

}  // namespace augicp::synthetic
