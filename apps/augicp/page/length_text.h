// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace augicp::app {

// Metres with three digits, in the unit of km, m, cm, mm and um in which the number is at least 1, and a space that
// does not break.
std::string length_text(double length_m);

}  // namespace augicp::app
