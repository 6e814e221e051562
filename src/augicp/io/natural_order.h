// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace augicp {

// Whether a name comes before another: runs of digits compare as numbers (2 before 10), everything else as text.
bool naturally_before(const std::string& a, const std::string& b);

}  // namespace augicp
