// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "augicp/sensor/scan.h"

namespace augicp::python {

// Python's augicp.Cloud is a Scan: a cloud and, if it comes from a depth image, its pixels. Immutable once made, so
// that arrays may share its memory, and several threads may use it.
using SharedScan = std::shared_ptr<const Scan>;

// An existing augicp.Cloud, or the cloud of an (N, 3) array of points. Throws WrongType or std::invalid_argument; name
// is that of the argument.
SharedScan scan_from(const pybind11::object& given, const std::string& name);

// A new augicp.Cloud.
pybind11::object cloud_of(Scan scan);

}  // namespace augicp::python
