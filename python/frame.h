// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace augicp::python {

// Adds augicp.Frame.
void bind_frame(pybind11::module_& module);

}  // namespace augicp::python
