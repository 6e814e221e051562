// SPDX-License-Identifier: MIT
// Files of poses in any of the usual forms.
#pragma once

#include <filesystem>

#include "augicp/io/trajectory_file.h"

namespace augicp {

// The forms: a JSON object a line, or a table whose header names the columns (EuRoC, spreadsheets, exported topics),
// see pose_table.h; else by the number of values in the first line that has any:
//    8  timestamp tx ty tz qx qy qz qw (TUM), see trajectory_file.h
//   12  the first three rows of a pose, row by row (KITTI)
//   13  a timestamp in seconds, then these twelve
//   16, 17  the same with all four rows
// A file of TUM's form whose stamps are too large for seconds is read in the unit that their magnitude suggests, with a
// warning, as tables are.
struct PoseFile {
  TrajectoryFile content;
  bool has_stamps = true;  // false: 12 or 16 values a line; each stamp is then the number of its pose, from 0
};

// Values are separated by blanks or commas; '#' starts a comment, '%' and '//' a line of one. Throws IoError naming the
// line whose values are not finite, or differ in number from the first line, whose pose is not rigid (see
// rigid3_from_matrix), or whose stamp is not above the one before; also if there is no pose.
PoseFile parse_poses(const FileBytes& file);
PoseFile read_poses(const std::filesystem::path& path);

// Two files that are to be compared, where only one has stamps and both have the same number of poses: the other one
// takes these stamps. Otherwise nothing changes.
void share_stamps(PoseFile& a, PoseFile& b);

}  // namespace augicp
