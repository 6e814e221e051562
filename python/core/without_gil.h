// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <future>
#include <stop_token>

namespace augicp::python {

// Waits, without the GIL and in short intervals, until has_ended(). Between the intervals Python's signal handlers run.
// If one raises (Ctrl-C: KeyboardInterrupt), it requests a stop, waits for the end, and rethrows.
void wait_until(const std::function<bool()>& has_ended, std::stop_source& stop);

// Runs work(stop token) in a separate thread while this one waits as above; rethrows its exception. REQUIRES: this
// thread has the GIL, and work does not use Python.
template <typename Work>
auto without_gil(const Work& work) {
  std::stop_source stop;
  auto result = std::async(std::launch::async, [&] { return work(stop.get_token()); });
  wait_until([&] { return result.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready; }, stop);
  return result.get();
}

}  // namespace augicp::python
