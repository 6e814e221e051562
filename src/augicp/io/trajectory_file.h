// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "augicp/geometry/trajectory.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// Seconds since 1970 stay below it until the year 5138; milliseconds since 1970 passed it in 1973.
inline constexpr double kMaxStamp_s = 1e11;

struct TrajectoryFile {
  Trajectory trajectory;              // at least one pose, in the order of the stamps
  std::vector<std::string> warnings;  // what may be wrong with the file though all of it was read
};

// A trajectory in the form of the TUM RGB-D benchmark: `timestamp tx ty tz qx qy qz qw` a line, the pose of the camera
// in the world (T_world_camera), seconds and metres, separated by blanks or commas; '#' starts a comment. Throws
// IoError naming the line: where it has not 8 finite numbers, its quaternion is not of unit length (see
// pose_numbers.h), its stamp is not above the one before or too large for seconds; also where there is no pose at all.
TrajectoryFile parse_tum_trajectory(const FileBytes& file);
TrajectoryFile read_tum_trajectory(const std::filesystem::path& path);

// The same form, behind a comment that names the columns. Every number has the digits to be read back as the same
// double, stamps at least 6 decimals. Throws std::invalid_argument for what could not be read back: stamps out of order
// or too large, poses that are not finite. An empty trajectory gives a file without poses. Throws IoError.
void write_tum_trajectory(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace augicp
