// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "augicp/io/file_bytes.h"
#include "augicp/sensor/depth_camera.h"

namespace augicp {

// A camera from text of a user: a known name ("tum-fr1", ...), numbers "fx fy cx cy", optionally followed by the lens
// "k1 k2 p1 p2 k3", or the path of a file. The file has such numbers, a 3x3 intrinsic matrix, or JSON as Open3D writes
// it (width, height, and intrinsic_matrix column by column), optionally with "distortion" (five coefficients) and
// "readout_s". Throws IoError for any other file, and for an unknown name, with the known names.
DepthCamera read_camera(const std::string& name_or_path_or_numbers);

// The content of such a file. Throws IoError.
DepthCamera parse_camera(const FileBytes& file);

}  // namespace augicp
