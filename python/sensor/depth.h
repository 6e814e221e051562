// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "augicp/sensor/depth_image.h"

namespace augicp::python {

// The depth image in a (height, width) array, or in the file of a path. Integers from 0 to 65535, and files, require
// depth_scale, the value of one metre. Floats are metres, unless depth_scale is given. Throws WrongType,
// std::invalid_argument or IoError.
DepthImage depth_image_from(const pybind11::object& given, std::optional<double> depth_scale);

// Throws std::invalid_argument if the readings show that the scale is wrong, see depth_scale_problem().
void check_scale(const DepthImage& image, std::optional<double> depth_scale);

}  // namespace augicp::python
