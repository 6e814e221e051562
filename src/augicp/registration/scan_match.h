// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "augicp/align/scout.h"
#include "augicp/match/matcher.h"
#include "augicp/registration/options.h"
#include "augicp/registration/prepared_pair.h"

namespace augicp {

// Whether pairs are found through the target's camera. Throws std::invalid_argument if that is requested and there is
// no camera.
bool is_projective(const Scan& target, Association association);

// Two prepared scans, with matchers in both directions. Poses are between the clouds' points. REQUIRES: the scans
// outlive it. Thread safety: const calls may run concurrently.
class ScanMatch {
 public:
  ScanMatch(const ScanPair& pair, const RegistrationOptions& options);
  ScanMatch(const ScanMatch&) = delete;
  ScanMatch& operator=(const ScanMatch&) = delete;

  const ScanPair& scans() const { return scans_; }

  AlignResult align(const Rigid3& guess, const AlignOptions& options) const;

  // The pose alone; empty if there is none, or a known one on the way. See align/scout.h.
  std::optional<Rigid3> scouted(const Rigid3& guess, const AlignOptions& options, const KnowsPose& is_known) const;

  // The options of the registration for these scans.
  AlignOptions usual_options() const;

  // See plausibility(const Agreement&): of the source in the target and of the target in the source.
  double plausibility(const Rigid3& target_from_source, int num_threads) const;

  // With the first gate.
  std::vector<Correspondence> pairs(const Rigid3& target_from_source) const;

 private:
  ScanPair scans_;
  RegistrationOptions options_;
  std::unique_ptr<ScanMatcher> in_target_, in_source_;
};

}  // namespace augicp
