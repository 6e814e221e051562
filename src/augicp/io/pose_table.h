// SPDX-License-Identifier: MIT
// Trajectories whose columns have names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "augicp/io/pose_columns.h"
#include "augicp/io/trajectory_file.h"

namespace augicp {

// The header of a table of poses: its first line that is no number, or a comment before the first line.
struct PoseHeader {
  std::vector<std::string> names;  // empty if none names a pose
  bool is_comment = false;
};
PoseHeader pose_header(const FileBytes& file);

// A table with such a header: EuRoC's .csv, a spreadsheet, an exported topic. Stamps have the unit that their name
// states, or the one that their magnitude suggests, with a warning that names it. Throws IoError with the line, as
// parse_tum_trajectory() does.
TrajectoryFile parse_pose_table(const FileBytes& file, const std::vector<std::string>& names);

// A JSON object a line, with the same names. Members of objects have them joined by points (pose.position.x); a list of
// three numbers has x y z, one of four the order that its name ends in (orientation_xyzw, q_wxyz).
TrajectoryFile parse_pose_objects(const FileBytes& file);

}  // namespace augicp
