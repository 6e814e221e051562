// SPDX-License-Identifier: MIT
#include "augicp/surface/arms.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/check.h"

namespace augicp {

void check(const WindowOptions& options) {
  require_positive("radius", options.radius);
  require_not_negative("radius_per_depth", options.radius_per_depth);
  require_positive("max_step_per_depth", options.max_step_per_depth);
}

double ball_radius(float depth, const WindowOptions& options) {
  return std::max(options.radius, options.radius_per_depth * static_cast<double>(depth));
}

Line image_line(const Cloud& cloud, const IndexImage& index, bool along_rows, int which, double max_step_per_depth) {
  Line line;
  const int length = along_rows ? index.width : index.height;
  std::int32_t run = 0;
  for (int k = 0; k < length; ++k) {
    const std::int32_t point = along_rows ? index.at(k, which) : index.at(which, k);
    if (point == IndexImage::kNone) continue;
    if (!line.point.empty() && is_step(cloud.points[line.point.back()].z(), cloud.points[point].z(),
                                       k - line.position.back(), max_step_per_depth))
      ++run;
    line.position.push_back(k);
    line.point.push_back(point);
    line.run.push_back(run);
  }
  return line;
}

Reach reach_along(const Line& line, const Cloud& cloud, const std::vector<double>& half_side) {
  const auto count = static_cast<std::int32_t>(line.point.size());
  Reach reach{std::vector<std::int32_t>(count), std::vector<std::int32_t>(count)};
  // Neighbouring entries have a similar reach. So each search starts at the end of the last one and moves inwards, at
  // most to the entry itself, then outwards. First ends are searched from left to right and last ends from right to
  // left. The start is then rather too far out than too far in, so one noisy entry does not cut an arm short.
  const auto end_of = [&](std::int32_t i, std::int32_t start, std::int32_t outwards) {
    const Vec3f& centre = cloud.points[line.point[i]];
    const double limit = half_side[line.point[i]];
    const auto belongs = [&](std::int32_t k) {
      return k >= 0 && k < count && line.run[k] == line.run[i] &&
             static_cast<double>((cloud.points[line.point[k]] - centre).squaredNorm()) <= limit * limit;
    };
    std::int32_t end = start;
    while (end != i && !belongs(end)) end -= outwards;
    while (belongs(end + outwards)) end += outwards;
    return end;
  };
  for (std::int32_t i = 0; i < count; ++i) reach.first[i] = end_of(i, i == 0 ? i : reach.first[i - 1], -1);
  for (std::int32_t i = count - 1; i >= 0; --i) reach.last[i] = end_of(i, i == count - 1 ? i : reach.last[i + 1], 1);
  return reach;
}

}  // namespace augicp
