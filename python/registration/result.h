// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "augicp/align/align.h"
#include "augicp/registration/options.h"

namespace augicp::python {

// Python's augicp.Result: the result, and the options used, with derived lengths.
struct Result {
  AlignResult found;
  RegistrationOptions options;
  Vec3d reference_point = Vec3d::Zero();  // about which increments of the covariance rotate: the target's origin
};

}  // namespace augicp::python
