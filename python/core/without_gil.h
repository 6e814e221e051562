// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <future>
#include <memory>
#include <stop_token>

#include "augicp/registration/stage.h"

namespace augicp::python {

// Calls a Python function in the waiting thread with what the work reports, so that the work needs neither the GIL nor
// a Python object. Thread safety: report() may be called in any thread; call_listener() needs the GIL.
class Reports {
 public:
  // listener: called with a stage's word, the number of its items that are done, and their total; None: nobody listens.
  explicit Reports(pybind11::object listener);

  // What the options take. Refers to nothing of Python, and may outlive this object.
  StageListener on_stage() const;

  // Calls the listener for each report since the last call; what it raises is thrown.
  void call_listener();

 private:
  struct Waiting;
  pybind11::object listener_;
  std::shared_ptr<Waiting> waiting_;
};

// Waits, without the GIL and in short intervals, until has_ended(). Between the intervals Python's signal handlers and
// `between` (which may be empty) run, and once more at the end. If one raises (Ctrl-C: KeyboardInterrupt), it requests
// a stop, waits for the end, and rethrows.
void wait_until(const std::function<bool()>& has_ended, std::stop_source& stop);

// The same, but rethrows at once: the work ends later, at its next check, and leave() takes what keeps it alive.
void wait_or_leave(const std::function<bool()>& has_ended, std::stop_source& stop, const std::function<void()>& leave,
                   const std::function<void()>& between = {});

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
// others see, and refers to no object of Python. reports: of the work, or null.
template <typename Work>
auto without_gil_or_wait(Work work, Reports* reports = nullptr) {
  std::stop_source stop;
  auto run = [work = std::move(work), token = stop.get_token()] { return work(token); };
  auto result = std::make_shared<std::future<decltype(run())>>(std::async(std::launch::async, std::move(run)));
  const auto ended = [result] { return has_ended(*result); };
  wait_or_leave(
      ended, stop, [&] { keep_until_end(result, ended); },
      [&] {
        if (reports) reports->call_listener();
      });
  return result->get();
}

}  // namespace augicp::python
