// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "augicp/match/matcher.h"

namespace augicp::testing {

// Gives the same pairs under every pose and gate. REQUIRES: the target outlives it.
class FixedPairs final : public Matcher {
 public:
  FixedPairs(const Cloud& target, std::vector<Correspondence> pairs) : target_(target), pairs_(std::move(pairs)) {}
  const Cloud& target() const override { return target_; }
  std::vector<Correspondence> match(const Cloud&, const Rigid3&, const Gates&, int) const override { return pairs_; }

 private:
  const Cloud& target_;
  std::vector<Correspondence> pairs_;
};

}  // namespace augicp::testing
