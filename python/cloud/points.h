// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "augicp/io/cloud_file.h"

namespace augicp::python {

// Arrays of points to a cloud, see cloud_from_points(). All but points: or None.
struct PointArrays {
  pybind11::object points, normals = pybind11::none(), structures = pybind11::none(), viewpoint = pybind11::none(),
                           intensities = pybind11::none(), colors = pybind11::none();
};
CloudFile cloud_from(const PointArrays& arrays, const std::string& name);

}  // namespace augicp::python
