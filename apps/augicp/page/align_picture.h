// SPDX-License-Identifier: MIT
#pragma once

#include "apps/augicp/text/align.h"

namespace augicp::app {

// What the page of `augicp align --report` is drawn from. A view: all of it must outlive the picture.
struct AlignPicture {
  const AlignReport& report;
  const Rigid3& initial;  // target_from_source
  const PreparedPair& prepared;
};

}  // namespace augicp::app
