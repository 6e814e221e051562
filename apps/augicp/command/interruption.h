// SPDX-License-Identifier: MIT
// Ctrl-C and kill. The library knows no signals; how the command ends on them is decided here.
#pragma once

#include <functional>

namespace augicp::app {

// From now on SIGINT, SIGTERM and SIGHUP end the process with exit code 128 + their number, whatever it is busy with:
// within milliseconds, or once the file that is being written is whole. A second signal ends it at once. What the
// parent chose to ignore (nohup) stays ignored. To be called before any other thread is started: those would take the
// signals.
void end_on_signals();

// Calls write(), and lets a signal wait until it returns. May be nested.
void write_whole(const std::function<void()>& write);

}  // namespace augicp::app
