// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "augicp/cloud/cloud.h"

namespace augicp::python {

// Arrays of points to a cloud, see cloud_from_points(). normals, structures, viewpoint: or None.
struct PointArrays {
  pybind11::object points, normals = pybind11::none(), structures = pybind11::none(), viewpoint = pybind11::none();
};
Cloud cloud_from(const PointArrays& arrays, const std::string& name);

}  // namespace augicp::python
