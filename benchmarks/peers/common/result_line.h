// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "benchmarks/peers/common/method.h"

namespace augicp::peers {

// Results as CSV, one line a job and method. What the peer did not tell is an empty field.
std::string result_header();
std::string result_line(const std::string& pair, const Peer& peer, const std::string& method, const Found& found);

}  // namespace augicp::peers
