// SPDX-License-Identifier: MIT
// The benchmark of trust, as CSV and as text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "augicp/synthetic/trust_benchmark.h"

namespace augicp::app {

struct TrustResults {
  std::string family;
  std::vector<synthetic::TrustOutcome> outcomes;
};

// A line for each pair, with a header line; lengths in metres, angles in degrees.
std::string trust_csv(std::span<const TrustResults> results);

// For each family, the shares that other limits of the strain would accept and refuse.
std::string trust_roc_csv(std::span<const TrustResults> results);

// A table with a line for each family.
std::string trust_text(std::span<const TrustResults> results);

}  // namespace augicp::app
