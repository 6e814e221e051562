// SPDX-License-Identifier: MIT
#include "augicp/geometry/trajectory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace augicp {

void check_order(const Trajectory& trajectory) {
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const double stamp_s = trajectory[i].stamp_s;
    if (!std::isfinite(stamp_s))
      throw std::invalid_argument("trajectory: the stamp of pose " + std::to_string(i) + " is not finite");
    if (i > 0 && stamp_s <= trajectory[i - 1].stamp_s)
      throw std::invalid_argument("trajectory: expected stamps that increase, found " + std::to_string(stamp_s) +
                                  " s after " + std::to_string(trajectory[i - 1].stamp_s) + " s at pose " +
                                  std::to_string(i));
  }
}

Rigid3 interpolate(const Rigid3& first, const Rigid3& second, double share) {
  return {first.rotation.slerp(share, second.rotation).normalized(),
          (1.0 - share) * first.translation + share * second.translation};
}

std::optional<Rigid3> pose_at(const Trajectory& trajectory, double stamp_s, double max_gap_s) {
  const auto after = std::lower_bound(trajectory.begin(), trajectory.end(), stamp_s,
                                      [](const StampedPose& pose, double stamp) { return pose.stamp_s < stamp; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->stamp_s == stamp_s) return after->world_from_camera;
  if (after == trajectory.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap_s = after->stamp_s - before->stamp_s;
  if (!(gap_s <= max_gap_s)) return std::nullopt;
  return interpolate(before->world_from_camera, after->world_from_camera, (stamp_s - before->stamp_s) / gap_s);
}

}  // namespace augicp
