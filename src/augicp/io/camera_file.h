// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "augicp/io/file_bytes.h"
#include "augicp/sensor/pinhole.h"

namespace augicp {

// A camera from what a user may write: a known name ("tum-fr1", ...), four numbers "fx fy cx cy", or the path of a file
// with four numbers, a 3x3 intrinsic matrix, or JSON as Open3D writes it (width, height, and intrinsic_matrix column by
// column). Throws IoError for a file that is none of these and for an unknown name, with the known ones.
Pinhole read_camera(const std::string& name_or_path_or_numbers);

// The content of such a file. Throws IoError.
Pinhole parse_camera(const FileBytes& file);

}  // namespace augicp
