// SPDX-License-Identifier: MIT
// What Python sees of the library's exceptions: all derive from augicp.Error, and from Python's own class for the case.
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>

namespace augicp::python {

// An argument of a kind that cannot be used: augicp.ArgumentTypeError, a TypeError.
class WrongType : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace augicp::python
