// SPDX-License-Identifier: MIT
// One function for each file that adds to the module.
#pragma once

#include <pybind11/pybind11.h>

namespace augicp::python {

void bind_align(pybind11::module_& module);
void bind_surface(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_sequence(pybind11::module_& module);
void bind_odometry(pybind11::module_& module);
void bind_evaluate(pybind11::module_& module);

}  // namespace augicp::python
