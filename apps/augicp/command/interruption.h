// SPDX-License-Identifier: MIT
// Ctrl-C and kill. The library does not handle signals; this defines how the command ends on them.
#pragma once

#include <functional>

namespace augicp::app {

// From now on SIGINT, SIGTERM and SIGHUP end the process with exit code 128 + their number, at any stage: within
// milliseconds, or once the current file is complete. A second signal ends it at once. Signals that the parent ignores
// (nohup) stay ignored. REQUIRES: no other thread was started yet, because it would receive the signals.
void end_on_signals();

// Calls write(), and delays signals until it returns. May be nested.
void write_whole(const std::function<void()>& write);

}  // namespace augicp::app
