// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "augicp/geometry/rigid3.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// A rigid motion as text, in any of these forms; '#' starts a comment:
//   16 numbers   a homogeneous matrix, row by row (the last row 0 0 0 1)
//   12 numbers   its first three rows, as in KITTI's pose files
//   7 numbers    tx ty tz qx qy qz qw, the quaternion of unit length to within 1e-3
//   JSON         an object with the matrix as "T_target_source", an array of rows or of 16 numbers
// Throws std::invalid_argument for anything else, and if the motion is not rigid (see rigid3_from_matrix).
Rigid3 parse_transform(std::string_view text);

// The same from a file. Throws IoError.
Rigid3 read_transform(const std::filesystem::path& path);

// Writes four lines of four numbers with 17 digits, after a comment that states the direction.
void write_transform(const std::filesystem::path& path, const Rigid3& target_from_source);

}  // namespace augicp
