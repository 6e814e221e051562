// SPDX-License-Identifier: MIT
// What a pickled augicp.Cloud holds: the bytes of its arrays, so that it comes back with the same bits.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "augicp/sensor/scan.h"

namespace augicp::python {

pybind11::tuple state_of(const Scan& scan);

// Throws std::invalid_argument for what state_of() cannot have made.
std::shared_ptr<Scan> scan_of_state(const pybind11::tuple& state);

}  // namespace augicp::python
