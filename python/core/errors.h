// SPDX-License-Identifier: MIT
// The library's exceptions in Python: all derive from augicp.Error, and from Python's own class for the case.
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>

namespace augicp::python {

// An argument of a wrong kind: augicp.ArgumentTypeError, a TypeError.
class WrongType : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace augicp::python
