// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_from_points.h"

#include <algorithm>
#include <array>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"

namespace augicp {

namespace {

PointTable table_of(const PointSource& points) {
  PointTable table;
  table.format = "points in memory";
  table.num_points = points.count;
  table.has_normals = static_cast<bool>(points.normal);
  table.has_intensities = static_cast<bool>(points.intensity);
  table.viewpoint = points.viewpoint;
  if (points.colour) table.fields = colour_fields({});
  return table;
}

Vec3d position_of(const PointSource& points, std::size_t i) {
  if (!points.positions) return points.position(i);
  Vec3d position;
  points.positions(i, std::span(&position, 1));
  return position;
}

PointValues values_of(const PointSource& points, std::size_t i) {
  const Vec3d position = position_of(points, i), normal = points.normal ? points.normal(i) : Vec3d(Vec3d::Zero());
  const Structure structure = points.structure ? points.structure(i) : Structure::Planar;
  return {position.x(),
          position.y(),
          position.z(),
          normal.x(),
          normal.y(),
          normal.z(),
          static_cast<double>(structure),
          points.intensity ? points.intensity(i) : 0.0};
}

void add_colour(const Colour& colour, std::vector<PointField>& fields) {
  for (std::size_t k = 0; k < colour.size(); ++k) fields[k].values.push_back(static_cast<char>(colour[k]));
}

bool has_positions_alone(const PointSource& points) {
  return points.positions && !points.normal && !points.intensity && !points.colour;
}

void add_positions(const PointSource& points, CloudBuilder& builder) {
  std::array<Vec3d, 256> block;
  PointValues values{};
  for (std::size_t first = 0; first < points.count; first += block.size()) {
    const std::span some = std::span(block).first(std::min(block.size(), points.count - first));
    points.positions(first, some);
    for (const Vec3d& position : some) {
      std::copy_n(position.data(), 3, values.begin());
      builder.add(values);
    }
  }
}

}  // namespace

CloudFile cloud_from_points(const PointSource& points) {
  if (const std::uint64_t limit = ReadOptions{}.max_points; points.count > limit)
    throw std::invalid_argument(fmt::format("{} points: expected at most {}; thin them first", points.count, limit));
  return build_any_cloud(table_of(points), [&](CloudBuilder& builder) {
    if (has_positions_alone(points)) return add_positions(points, builder);
    for (std::size_t i = 0; i < points.count; ++i)
      if (builder.add(values_of(points, i)) && points.colour) add_colour(points.colour(i), builder.fields());
  });
}

}  // namespace augicp
