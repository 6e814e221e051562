// SPDX-License-Identifier: MIT
#include "apps/augicp/page/nearest_rows.h"

#include <limits>

#include "augicp/search/kd_tree.h"

namespace augicp::app {

std::vector<std::uint32_t> nearest_rows(const Cloud& cloud, const Cloud& others) {
  const KdTree tree(others);
  const Vec3d offset = cloud.origin - others.origin;
  std::vector<std::uint32_t> rows;
  rows.reserve(cloud.size());
  for (const Vec3f& point : cloud.points) {
    const Vec3f query = (offset + point.cast<double>()).cast<float>();
    rows.push_back(tree.nearest(query, std::numeric_limits<float>::infinity()).value_or(Neighbour{}).index);
  }
  return rows;
}

std::vector<Colour> nearest_colours(const Cloud& cloud, const Cloud& others, const std::vector<Colour>& colours) {
  std::vector<Colour> nearest;
  if (colours.empty()) return nearest;
  nearest.reserve(cloud.size());
  for (const std::uint32_t row : nearest_rows(cloud, others)) nearest.push_back(colours[row]);
  return nearest;
}

}  // namespace augicp::app
