// SPDX-License-Identifier: MIT
#pragma once

#include "apps/augicp/text/align.h"

namespace augicp::app {

// The content of the page of `augicp align --report`. A view. REQUIRES: all of it outlives the picture.
struct AlignPicture {
  const AlignReport& report;
  const Rigid3& initial;  // target_from_source
  const PreparedPair& prepared;
};

}  // namespace augicp::app
