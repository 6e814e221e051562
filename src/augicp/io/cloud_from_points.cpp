// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_from_points.h"

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"

namespace augicp {

CloudFile cloud_from_points(const PointSource& points) {
  if (const std::uint64_t limit = ReadOptions{}.max_points; points.count > limit)
    throw std::invalid_argument(fmt::format("{} points: expected at most {}; thin them first", points.count, limit));
  PointTable table;
  table.format = "points in memory";
  table.num_points = points.count;
  table.has_normals = static_cast<bool>(points.normal);
  table.viewpoint = points.viewpoint;
  return build_any_cloud(table, [&](CloudBuilder& builder) {
    for (std::size_t i = 0; i < points.count; ++i) {
      const Vec3d position = points.position(i), normal = points.normal ? points.normal(i) : Vec3d(Vec3d::Zero());
      const Structure structure = points.structure ? points.structure(i) : Structure::Planar;
      builder.add({position.x(), position.y(), position.z(), normal.x(), normal.y(), normal.z(),
                   static_cast<double>(structure)});
    }
  });
}

}  // namespace augicp
