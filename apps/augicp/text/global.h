// SPDX-License-Identifier: MIT
// Registrations without a guess, as CSV and as text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "augicp/experiment/global.h"

namespace augicp::app {

// A row per registration; metres, degrees, milliseconds. Errors of pairs without common surface are nan.
std::string global_csv(std::span<const GlobalOutcome> outcomes);

// A row per family.
std::string global_text(const std::vector<GlobalRow>& rows);

}  // namespace augicp::app
