// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "augicp/io/write_cloud.h"
#include "augicp/sensor/scan.h"

namespace augicp::python {

// Python's augicp.Cloud: a cloud, its pixels if it comes from a depth image, and colours, which no algorithm sees.
// Immutable once made, so that arrays may share its memory, and several threads may use it.
struct ColouredScan : Scan {
  std::vector<Colour> colours;  // empty, or one per point

  ColouredScan() = default;
  explicit ColouredScan(Scan scan, std::vector<Colour> its_colours = {})
      : Scan(std::move(scan)), colours(std::move(its_colours)) {}
};
using SharedScan = std::shared_ptr<const ColouredScan>;

// An existing augicp.Cloud, or the cloud of an (N, 3) array of points. Throws WrongType or std::invalid_argument; name
// is that of the argument.
SharedScan scan_from(const pybind11::object& given, const std::string& name);

// A new augicp.Cloud.
pybind11::object cloud_of(Scan scan);

// The cloud of a file or of arrays, with its colours.
ColouredScan coloured_scan_of(CloudFile file);

}  // namespace augicp::python
