// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <future>
#include <stop_token>

namespace augicp::python {

// Waits, without the GIL and in short rests, until has_ended(). Between the rests Python's signal handlers run: where
// one raises (Ctrl-C: KeyboardInterrupt), stop is asked for, the end waited for, and the exception goes on from here.
void wait_until(const std::function<bool()>& has_ended, std::stop_source& stop);

// work(stop token), done by a thread of its own while this one, which must hold the GIL, waits as above. work must not
// touch Python. What it throws is thrown here.
template <typename Work>
auto without_gil(const Work& work) {
  std::stop_source stop;
  auto result = std::async(std::launch::async, [&] { return work(stop.get_token()); });
  wait_until([&] { return result.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready; }, stop);
  return result.get();
}

}  // namespace augicp::python
