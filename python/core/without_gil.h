// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <future>
#include <memory>
#include <stop_token>

namespace augicp::python {

// Waits, without the GIL and in short intervals, until has_ended(). Between the intervals Python's signal handlers run.
// If one raises (Ctrl-C: KeyboardInterrupt), it requests a stop, waits for the end, and rethrows.
void wait_until(const std::function<bool()>& has_ended, std::stop_source& stop);

// The same, but rethrows at once: the work ends later, at its next check, and leave() takes what keeps it alive.
void wait_or_leave(const std::function<bool()>& has_ended, std::stop_source& stop, const std::function<void()>& leave);

// Keeps work that nobody waits for, until it has ended. Its destructor waits for the end; when Python exits, all of
// them are destroyed.
void keep_until_end(std::shared_ptr<void> running, std::function<bool()> has_ended);
void wait_for_kept_at_exit();

template <typename Result>
bool has_ended(const std::future<Result>& result) {
  return result.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
}

// Runs work(stop token) in a separate thread while this one waits as above; rethrows its exception. REQUIRES: this
// thread has the GIL, and work does not use Python.
template <typename Work>
auto without_gil(const Work& work) {
  std::stop_source stop;
  auto result = std::async(std::launch::async, [&] { return work(stop.get_token()); });
  wait_until([&] { return has_ended(result); }, stop);
  return result.get();
}

// The same for work that owns all it uses: Ctrl-C does not wait for it. REQUIRES: also, work changes nothing that
// others see, and refers to no object of Python.
template <typename Work>
auto without_gil_or_wait(Work work) {
  std::stop_source stop;
  auto run = [work = std::move(work), token = stop.get_token()] { return work(token); };
  auto result = std::make_shared<std::future<decltype(run())>>(std::async(std::launch::async, std::move(run)));
  const auto ended = [result] { return has_ended(*result); };
  wait_or_leave(ended, stop, [&] { keep_until_end(result, ended); });
  return result->get();
}

}  // namespace augicp::python
