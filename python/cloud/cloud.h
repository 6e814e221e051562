// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "augicp/sensor/scan.h"

namespace augicp::python {

// Python's augicp.Cloud is a Scan: a cloud, and of a depth image the pixels too. Nothing changes one after it is made,
// so that arrays may show its memory, and several threads may use it.
using SharedScan = std::shared_ptr<const Scan>;

// An augicp.Cloud as it is, or the cloud of an (N, 3) array of points. Throws WrongType or std::invalid_argument; name
// says which argument it was.
SharedScan scan_from(const pybind11::object& given, const std::string& name);

// A new augicp.Cloud.
pybind11::object cloud_of(Scan scan);

}  // namespace augicp::python
