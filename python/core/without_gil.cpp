// SPDX-License-Identifier: MIT
#include "python/core/without_gil.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

bool rests_until(const std::function<bool()>& has_ended) {
  const py::gil_scoped_release release;
  return has_ended();
}

}  // namespace

void wait_until(const std::function<bool()>& has_ended, std::stop_source& stop) {
  while (!rests_until(has_ended)) {
    if (PyErr_CheckSignals() == 0) continue;  // always 0 outside the main thread
    const py::error_already_set raised;       // takes the exception out of Python's hands for now
    stop.request_stop();
    while (!rests_until(has_ended)) continue;
    throw raised;
  }
}

}  // namespace augicp::python
