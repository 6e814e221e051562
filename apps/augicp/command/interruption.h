// SPDX-License-Identifier: MIT
// Ctrl-C and kill. The library does not handle signals; this defines how the command ends on them.
#pragma once

#include <functional>
#include <stop_token>

namespace augicp::app {

// From now on SIGINT, SIGTERM and SIGHUP end the process with exit code 128 + their number, at any stage: within
// milliseconds, or once the current file is complete. A second signal ends it at once. Signals that the parent ignores
// (nohup) stay ignored. REQUIRES: no other thread was started yet, because it would receive the signals.
void end_on_signals();

// While it exists, the first signal asks for a stop instead of ending the process, so that what was done can be kept. A
// second one ends it at once. At most one exists at a time.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  std::stop_token token() const { return source_.get_token(); }

  // The exit code of a command that a signal ended, 128 + its number; 0 if none came.
  int exit_code() const;

 private:
  std::stop_source source_;
};

// Calls write(), and delays signals until it returns. May be nested.
void write_whole(const std::function<void()>& write);

}  // namespace augicp::app
