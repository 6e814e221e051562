// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "augicp/align/align.h"
#include "augicp/registration/options.h"

namespace augicp::python {

// Python's augicp.Result: what was found, and the options it was found with, lengths as they were derived.
struct Result {
  AlignResult found;
  RegistrationOptions options;
};

}  // namespace augicp::python
