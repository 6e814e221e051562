// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "augicp/registration/lengths.h"
#include "augicp/trust/verdict.h"

namespace augicp {

// Two scans as they came.
struct RawPair {
  Scan source, target;
};

// Two prepared scans, and the lengths of their preparation; see prepare_pair().
struct PreparedPair {
  Scan source, target;
  Lengths lengths;
  std::optional<RawPair> raw = std::nullopt;  // for smaller balls, see finer_balls.h; absent if there are none
};

// A view of two prepared scans: a sequence registers each scan with several others, without copies. Either may be
// empty. REQUIRES: the scans outlive it.
struct ScanPair {
  const Scan& source;
  const Scan& target;
  Lengths lengths;
  Part known_part = Part::None;

  ScanPair(const Scan& source_scan, const Scan& target_scan, const Lengths& pair_lengths)
      : source(source_scan), target(target_scan), lengths(pair_lengths) {}
  ScanPair(const PreparedPair& pair)  // NOLINT(google-explicit-constructor): a view of the same two scans
      : ScanPair(pair.source, pair.target, pair.lengths) {}
};

}  // namespace augicp
