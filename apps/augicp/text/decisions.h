// SPDX-License-Identifier: MIT
// What a registration does and why, for people.
#pragma once

#include <string>

#include "apps/augicp/text/align.h"

namespace augicp::app {

// What a registration does, while it does it: "judging pose 2 of 4".
std::string stage_text(Stage stage, Turn turn);

// A line for each length with its origin, for the points that were compared, for each step with its time, and for the
// reason to stop.
std::string decisions_text(const AlignReport& report);

}  // namespace augicp::app
