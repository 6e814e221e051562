// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "augicp/sensor/depth_camera.h"

namespace augicp::python {

// An augicp.Camera, or text for read_camera(). Throws WrongType, IoError or std::invalid_argument.
DepthCamera camera_from(const pybind11::object& given);

}  // namespace augicp::python
