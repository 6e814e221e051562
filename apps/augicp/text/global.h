// SPDX-License-Identifier: MIT
// Registrations without a guess, as CSV and as text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "augicp/experiment/global.h"

namespace augicp::app {

// A row per registration; metres, degrees, milliseconds. Errors of pairs without common surface are nan. The
// evidence is empty if there is none; its columns 1 are of the source in the target, 2 of the target in the source.
std::string global_csv(std::span<const GlobalOutcome> outcomes);

// A row per family.
std::string global_text(const std::vector<GlobalRow>& rows);

}  // namespace augicp::app
