// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "augicp/io/file_bytes.h"
#include "augicp/sensor/depth_camera.h"

namespace augicp {

// A camera from what a user may write: a known name ("tum-fr1", ...), numbers "fx fy cx cy" with or without a lens's
// "k1 k2 p1 p2 k3" behind them, or the path of a file with such numbers, a 3x3 intrinsic matrix, or JSON as Open3D
// writes it (width, height, and intrinsic_matrix column by column), to which "distortion" (the five) and "readout_s"
// may be added. Throws IoError for a file that is none of these and for an unknown name, with the known ones.
DepthCamera read_camera(const std::string& name_or_path_or_numbers);

// The content of such a file. Throws IoError.
DepthCamera parse_camera(const FileBytes& file);

}  // namespace augicp
