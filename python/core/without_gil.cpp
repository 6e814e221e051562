// SPDX-License-Identifier: MIT
#include "python/core/without_gil.h"

#include <list>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

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

struct Reports::Waiting {
  std::mutex mutex;
  std::vector<StageReport> reports;  // guarded by mutex
};

Reports::Reports(py::object listener) : listener_(std::move(listener)), waiting_(std::make_shared<Waiting>()) {}

StageListener Reports::on_stage() const {
  if (listener_.is_none()) return {};
  return [waiting = waiting_](const StageReport& report) {
    const std::lock_guard lock(waiting->mutex);
    waiting->reports.push_back(report);
  };
}

void Reports::call_listener() {
  std::vector<StageReport> reports;
  {
    const std::lock_guard lock(waiting_->mutex);
    reports.swap(waiting_->reports);
  }
  for (const auto& [stage, done, total] : reports) listener_(std::string(name_of(stage)), done, total);
}

void wait_or_leave(const std::function<bool()>& has_ended, std::stop_source& stop, const std::function<void()>& leave,
                   const std::function<void()>& between) {
  bool is_over = false;
  try {
    while (!is_over) {
      is_over = rests_until(has_ended);
      if (!is_over && PyErr_CheckSignals() != 0) throw py::error_already_set();  // never outside the main thread
      if (between) between();
    }
  } catch (...) {
    stop.request_stop();
    if (!is_over) leave();
    throw;
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
