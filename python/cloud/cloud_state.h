// SPDX-License-Identifier: MIT
// The content of a pickled augicp.Cloud: the bytes of its arrays, so that it comes back bit-identical.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "python/cloud/cloud.h"

namespace augicp::python {

pybind11::tuple state_of(const ColouredScan& scan);

// Throws std::invalid_argument for a state that state_of() cannot have made.
std::shared_ptr<ColouredScan> scan_of_state(const pybind11::tuple& state);

}  // namespace augicp::python
