// SPDX-License-Identifier: MIT
#include "python/core/without_gil.h"

#include <list>
#include <mutex>
#include <utility>

namespace augicp::python {
namespace {

namespace py = pybind11;

bool rests_until(const std::function<bool()>& has_ended) {
  const py::gil_scoped_release release;
  return has_ended();
}

struct Kept {
  std::shared_ptr<void> running;
  std::function<bool()> has_ended;
};

std::mutex kept_mutex;
std::list<Kept> kept;  // guarded by kept_mutex

}  // namespace

void wait_or_leave(const std::function<bool()>& has_ended, std::stop_source& stop, const std::function<void()>& leave) {
  while (!rests_until(has_ended)) {
    if (PyErr_CheckSignals() == 0) continue;  // always 0 outside the main thread
    const py::error_already_set raised;       // takes the exception out of Python's hands for now
    stop.request_stop();
    leave();
    throw raised;
  }
}

void wait_until(const std::function<bool()>& has_ended, std::stop_source& stop) {
  wait_or_leave(has_ended, stop, [&] {
    while (!rests_until(has_ended)) continue;
  });
}

void keep_until_end(std::shared_ptr<void> running, std::function<bool()> has_ended) {
  const std::lock_guard lock(kept_mutex);
  kept.remove_if([](const Kept& work) { return work.has_ended(); });
  kept.push_back({std::move(running), std::move(has_ended)});
}

void wait_for_kept_at_exit() {
  const auto wait = py::cpp_function([] {
    const py::gil_scoped_release release;
    const std::lock_guard lock(kept_mutex);
    kept.clear();
  });
  py::module_::import("atexit").attr("register")(wait);
}

}  // namespace augicp::python
