// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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
  std::vector<std::string> warnings;  // possible problems of a file that was read completely
  std::uint64_t num_repeated = 0;     // poses that were left out because their stamp is that of the one before
};

// A trajectory in the form of the TUM RGB-D benchmark: `timestamp tx ty tz qx qy qz qw` per line, the pose of the
// camera in the world (T_world_camera), seconds and metres, separated by blanks or commas; '#' starts a comment. Of
// poses with equal stamps the first is kept, with a warning. Throws IoError naming the line if it has not 8 finite
// numbers, if its quaternion is not of unit length (see pose_numbers.h), or if its stamp is below the one before or too
// large for seconds; also if there is no pose.
TrajectoryFile parse_tum_trajectory(const FileBytes& file);
TrajectoryFile read_tum_trajectory(const std::filesystem::path& path);

// Writes the same form, after a comment that names the columns. Every number has enough digits to read back as the same
// double, and stamps have at least 6 decimals. An empty trajectory gives a file without poses. Throws IoError; throws
// std::invalid_argument for stamps out of order or too large, and for poses that are not finite, because these would
// not read back.
void write_tum_trajectory(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace augicp
