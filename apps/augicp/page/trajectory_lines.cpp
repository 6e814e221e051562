// SPDX-License-Identifier: MIT
#include "apps/augicp/page/trajectory_lines.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "apps/augicp/page/packing.h"
#include "apps/augicp/page/thinning.h"
#include "augicp/core/median.h"

namespace augicp::app {
namespace {

constexpr std::size_t kMaxPoses = 5000;

// Poses farther apart in time, and than several usual gaps, are not joined by a line. Seconds.
constexpr double kMaxGap_s = 1.0;
constexpr double kMaxUsualGaps = 4.0;

// Poses this far outside of a time still belong to it, seconds.
constexpr double kMargin_s = 0.1;

double max_gap_s(const Trajectory& trajectory) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < trajectory.size(); ++i) gaps.push_back(trajectory[i].stamp_s - trajectory[i - 1].stamp_s);
  return gaps.empty() ? kMaxGap_s : std::max(kMaxGap_s, kMaxUsualGaps * upper_median(std::move(gaps)));
}

}  // namespace

Trajectory during(const Trajectory& trajectory, double first_s, double last_s) {
  Trajectory within;
  for (const StampedPose& pose : trajectory)
    if (pose.stamp_s >= first_s - kMargin_s && pose.stamp_s <= last_s + kMargin_s) within.push_back(pose);
  Trajectory thinned;
  for (const std::uint32_t i : thinned_indices(within.size(), kMaxPoses)) thinned.push_back(within[i]);
  return thinned;
}

std::string trajectory_lines(const Trajectory& trajectory, const Vec3d& centre) {
  std::vector<Vec3f> lines;
  const double longest_s = max_gap_s(trajectory);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    if (trajectory[i].stamp_s - trajectory[i - 1].stamp_s > longest_s) continue;
    for (const StampedPose& end : {trajectory[i - 1], trajectory[i]})
      lines.push_back((end.world_from_camera.translation - centre).cast<float>());
  }
  return packed_points(lines);
}

}  // namespace augicp::app
