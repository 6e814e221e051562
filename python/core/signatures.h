// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace augicp::python {

// The signature that pybind11 writes, as inspect.signature() reads it: without types, and with the keyword options and
// their defaults in the place of **kwargs. Empty if `line` is none.
//
//   "add(self: Odometry, depth: object, stamp: object = None) -> object"  ->  "add(self, depth, stamp=None)"
std::string text_signature(const std::string& line, const pybind11::dict& options);

// Gives every function and method of the module such a signature, at the head of its docstring. options: the keyword
// options and defaults of those that take some, by their names ("align", "Odometry.__init__").
// REQUIRES: all of the module is bound.
void set_text_signatures(const pybind11::module_& module, const pybind11::dict& options);

}  // namespace augicp::python
