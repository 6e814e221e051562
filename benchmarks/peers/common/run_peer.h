// SPDX-License-Identifier: MIT
#pragma once

#include "benchmarks/peers/common/method.h"

namespace augicp::peers {

// The whole program of a peer: `PROGRAM JOBS RESULTS [METHOD...]` runs the named methods (all without names) on every
// job and writes a line for each of both. Returns the exit code; errors go to stderr.
int run_peer(int argc, char** argv, const Peer& peer);

}  // namespace augicp::peers
