// SPDX-License-Identifier: MIT
// How often a status is right, on families of generated pairs: each stands for a class of inputs, none for a data set.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "augicp/experiment/pose_error.h"
#include "augicp/registration/options.h"

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
// depth cameras; twelve degenerate shapes as bare clouds; objects moved, half-turned, mirrored, unlike, and in part.
std::vector<TrustFamily> trust_families();

struct TrustRow {
  std::string family;
  int num_pairs = 0;
  int right_converged = 0, right_refused = 0;  // refused: any other status but Ambiguous and Degenerate
  int wrong_converged = 0, wrong_refused = 0;
  int ambiguous = 0, degenerate = 0;
  int named = 0;              // of the degenerate: with the true number of free motions, each within 5 degrees
  double largest_move = 0.0;  // of a degenerate result along what it names, in gyration radii
};

// A pair's outcome, added to the row. Exposed for tests.
void count_pair(const TrustPair& pair, const PoseError& right, const AlignResult& result, TrustRow& row);

// The distance that a result has moved from the guess along the motions that it calls free, in gyration radii of its
// paired points; 0 where it calls none free.
double move_along_free(const AlignResult& result, const Rigid3& guess, const Cloud& source, const Cloud& target);

// Registers the pairs of seeds first_seed .. first_seed + num_pairs - 1. on_pair is called after each from one thread.
TrustRow run_trust(const TrustFamily& family, unsigned first_seed, int num_pairs, const RegistrationOptions& options,
                   const std::function<void(unsigned seed, const AlignResult&)>& on_pair = {});

}  // namespace augicp::synthetic
