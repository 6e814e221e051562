// SPDX-License-Identifier: MIT
#include "augicp/io/write_las.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "augicp/io/atomic_file.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/las_format.h"

namespace augicp {
namespace {

Vec3d position_in_frame(const Cloud& cloud, std::size_t i) { return cloud.origin + cloud.points[i].cast<double>(); }

struct Box {
  Vec3d min = Vec3d::Constant(std::numeric_limits<double>::infinity());
  Vec3d max = -min;
};

Box box_of(const Cloud& cloud) {
  Box box;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    box.min = box.min.cwiseMin(position_in_frame(cloud, i));
    box.max = box.max.cwiseMax(position_in_frame(cloud, i));
  }
  return box;
}

bool fit(const Box& box, const Vec3d& scale, const Vec3d& offset) {
  constexpr double kLargest = std::numeric_limits<std::int32_t>::max();
  const Vec3d steps = (box.min - offset).cwiseAbs().cwiseMax((box.max - offset).cwiseAbs()).cwiseQuotient(scale);
  return (steps.array().abs() < kLargest).all();
}

// The middle of the box, in whole steps of the scale.
Vec3d middle_of(const Box& box, const Vec3d& scale) {
  const Vec3d middle = 0.5 * (box.min + box.max);
  return middle.cwiseQuotient(scale).array().round().matrix().cwiseProduct(scale);
}

void set_vector(std::string& head, std::size_t at, const Vec3d& vector) {
  for (std::size_t axis = 0; axis < 3; ++axis) las::set_number(head, at + 8 * axis, vector[static_cast<int>(axis)]);
}

// The integers of all positions, and the bounds of what they mean.
void set_positions(LasRecords& las, const Cloud& cloud) {
  Box box;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3d steps = (position_in_frame(cloud, i) - las.offset).cwiseQuotient(las.scale).array().round();
    for (int axis = 0; axis < 3; ++axis)
      las::set_number(las.records, i * las.record_length + 4 * static_cast<std::size_t>(axis),
                      static_cast<std::int32_t>(steps[axis]));
    const Vec3d position = steps.cwiseProduct(las.scale) + las.offset;
    box.min = box.min.cwiseMin(position);
    box.max = box.max.cwiseMax(position);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t at = las::kBounds + 16 * static_cast<std::size_t>(axis);
    las::set_number(las.head, at, box.max[axis]);
    las::set_number(las.head, at + 8, box.min[axis]);
  }
}

}  // namespace

std::vector<std::string> write_las(const std::filesystem::path& path, const CloudFile& file) {
  if (file.cloud.empty()) throw std::invalid_argument("cloud: must hold points to be written");
  std::vector<std::string> not_kept = file.fields.not_kept;
  if (file.grid)
    not_kept.push_back(fmt::format("the grid of {} x {} cells: LAS has none", file.grid->width, file.grid->height));
  LasRecords las = file.las ? *file.las : las_records_of(file);
  if (las.num_points() != file.cloud.size())
    throw std::invalid_argument(fmt::format("las: expected {} records, found {}", file.cloud.size(), las.num_points()));
  const Box box = box_of(file.cloud);
  if (!fit(box, las.scale, las.offset)) las.offset = middle_of(box, las.scale);
  if (!fit(box, las.scale, las.offset))
    throw io_error(path, fmt::format("the positions span more than the integers of LAS in steps of {}", las.scale.x()));
  set_vector(las.head, las::kOffset, las.offset);
  set_positions(las, file.cloud);
  if (las::has_waveform(las.point_format)) not_kept.push_back("the direction of each waveform: it is not moved");
  AtomicFile out(path);
  out.write(las.head);
  out.write(las.records);
  out.write(las.tail);
  out.commit();
  return not_kept;
}

}  // namespace augicp
