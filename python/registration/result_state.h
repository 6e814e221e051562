// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "python/registration/result.h"

namespace augicp::python {

// All of a result, for pickle and copy: numbers in one float64 array, its options as a dict.
pybind11::tuple state_of_result(const Result& result);

// Throws std::invalid_argument for what state_of_result() did not make.
Result result_of_state(const pybind11::tuple& state);

}  // namespace augicp::python
