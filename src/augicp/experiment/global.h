// SPDX-License-Identifier: MIT
// Measures registration without a guess: how often it finds the pose, how far off, and how often its status is right.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "augicp/experiment/fragments.h"
#include "augicp/experiment/pose_error.h"
#include "augicp/registration/options.h"
#include "augicp/trust/verdict.h"

namespace augicp {

struct GlobalPair {
  std::string family, source_name, target_name;
  const Cloud* source = nullptr;  // must outlive the pair
  const Cloud* target = nullptr;
  std::optional<Rigid3> target_from_source;  // not set: they have no common surface
  double length_scale = 1.0;                 // of the lengths in GlobalOptions::found and fine
};

struct GlobalOptions {
  int num_rotations = 1;  // of the source of each pair, uniform among all; at least 1
  unsigned seed = 1;
  PoseError found{0.3, 0.26179938779914943};  // 30 cm and 15 degrees, as 3DMatch
  PoseError fine{0.05, 0.05235987755982989};  // 5 cm and 3 degrees
  RegistrationOptions registration;

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

struct GlobalOutcome {
  std::string family, source_name, target_name;
  std::optional<PoseError> error;  // not set: there is no common surface
  AlignStatus status = AlignStatus::TooFewPairs;
  double time_ms = 0.0;                             // of preparation and registration, by the clock that is given
  double length_scale = 1.0;                        // of the pair
  std::optional<Evidence> evidence = std::nullopt;  // of the pose, if there is one
};

// The source of each pair is moved by a random rotation and translation first, and the place of its sensor with it.
// now_ms: a clock. on_pair is called after each registration.
std::vector<GlobalOutcome> run_global(std::span<const GlobalPair> pairs, const GlobalOptions& options,
                                      const std::function<double()>& now_ms, const std::function<void()>& on_pair);

// A family of one table. Errors are medians of what was found.
struct GlobalRow {
  std::string family;
  std::size_t num_pairs = 0, num_found = 0, num_fine = 0;
  std::size_t right_converged = 0, wrong_converged = 0, ambiguous = 0, others = 0;  // right: found
  PoseError median_error;
  double median_ms = 0.0;
};
std::vector<GlobalRow> summary(std::span<const GlobalOutcome> outcomes, const GlobalOptions& options);

// Pairs of the fragments of one sequence that share no frame: those with at least a 30 % overlap, and those with 10 to
// 30 %, as two families with this name.
std::vector<GlobalPair> pairs_of_fragments(const std::string& name, const std::vector<Fragment>& fragments,
                                           std::size_t frames_each);

}  // namespace augicp
