// SPDX-License-Identifier: MIT
// The benchmark of trust as a page: a row of counts for each family, and what other limits would accept and refuse.
#pragma once

#include <span>
#include <string>

#include "apps/augicp/text/trust.h"

namespace augicp::app {

std::string trust_page(std::span<const TrustResults> results);

}  // namespace augicp::app
