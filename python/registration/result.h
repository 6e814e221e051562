// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "augicp/align/align.h"
#include "augicp/registration/options.h"
#include "python/cloud/cloud.h"

namespace augicp::python {

// What a report draws beside the result, shared by the results of one call.
struct ResultInputs {
  SharedScan source, target;
  Rigid3 initial;  // target_from_source
  std::string source_name, target_name;
};

// Python's augicp.Result: the result, and the options used, with derived lengths.
struct Result {
  AlignResult found;
  RegistrationOptions options;
  Vec3d reference_point = Vec3d::Zero();       // about which increments of the covariance rotate: the target's origin
  std::shared_ptr<const ResultInputs> inputs;  // none after copying and pickling
};

}  // namespace augicp::python
