// SPDX-License-Identifier: MIT
// What `augicp align --report` shows.
#pragma once

#include <string>

#include "apps/augicp/report_result.h"

namespace augicp::app {

struct AlignPicture {
  const AlignReport& report;
  const Rigid3& initial;  // target_from_source
  const PreparedPair& prepared;
};

// The same bytes for any number of threads: no times, and no count of threads, in it.
void write_align_page(const std::string& path, const AlignPicture& picture);

}  // namespace augicp::app
