// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/augicp/page/align_picture.h"

namespace augicp::app {

// The HTML of `augicp align --report`. The same bytes for any number of threads: it has neither times nor a count of
// threads.
std::string align_page(const AlignPicture& picture);

}  // namespace augicp::app
