// SPDX-License-Identifier: MIT
// Which columns of a table are a pose, by their names.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace augicp {

struct PoseColumns {
  // Of timestamp tx ty tz qx qy qz qw.
  std::array<std::size_t, 8> of_value{};
  double stamps_per_s = 0.0;                 // 1, 1e3, 1e6 or 1e9 if the name of the stamp states its unit; 0 if not
  std::optional<std::size_t> nanoseconds{};  // to add to a stamp of whole seconds, as in ROS

  // Whether the table is the form of TUM: these eight and no others, in this order.
  bool are_tum(std::size_t num_columns) const;
};

// Understands the names of EuRoC ("#timestamp [ns]", "p_RS_R_x [m]", "q_RS_w []"), of ROS ("pose.position.x",
// "orientation.w") and plain ones ("time_s", "tx", "x", "qw"), in either case. Of several stamps or positions the first
// counts, but of stamps in two columns, whole seconds and nanoseconds, these two. Empty if one of the eight is missing.
std::optional<PoseColumns> find_pose_columns(std::span<const std::string> names);

}  // namespace augicp
