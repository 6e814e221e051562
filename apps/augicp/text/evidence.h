// SPDX-License-Identifier: MIT
// The evidence of a pose as columns of CSV, the same in every table.
#pragma once

#include <optional>
#include <string>

#include "augicp/trust/verdict.h"

namespace augicp::app {

// "strain,free_space_1,...": _1 is the source in the target, _2 the target in the source. Seen to
// off_planes are shares of 1.
std::string evidence_header();

// As many fields, all empty without evidence.
std::string evidence_csv(const std::optional<Evidence>& evidence);

}  // namespace augicp::app
