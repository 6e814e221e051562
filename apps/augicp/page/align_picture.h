// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "apps/augicp/text/align.h"
#include "augicp/io/write_cloud.h"

namespace augicp::app {

// Of each point of the prepared scans; empty: unknown.
struct PairColours {
  std::vector<Colour> source, target;
};

// The content of the page of `augicp align --report`. A view. REQUIRES: all of it outlives the picture.
struct AlignPicture {
  const AlignReport& report;
  const Rigid3& initial;  // target_from_source
  const PreparedPair& prepared;
  PairColours colours{};
};

}  // namespace augicp::app
