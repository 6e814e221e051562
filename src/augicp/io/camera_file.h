// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "augicp/io/file_bytes.h"
#include "augicp/sensor/depth_camera.h"

namespace augicp {

// A camera from text of a user: a known name ("tum-fr1", ...), numbers "fx fy cx cy", optionally followed by the lens
// "k1 k2 p1 p2 k3", or the path of a file. The file has such numbers, a 3x3 or 4x4 intrinsic matrix, JSON of Open3D or
// of a RealSense camera, or YAML of ROS, see camera_text.h. Throws IoError for any other file, and for an unknown name,
// with the known names.
DepthCamera read_camera(const std::string& name_or_path_or_numbers);

// The pixel value of one metre in the images of a known name; empty for other text.
std::optional<double> depth_scale_of_camera(const std::string& name);

// The content of such a file. Throws IoError.
DepthCamera parse_camera(const FileBytes& file);

}  // namespace augicp
