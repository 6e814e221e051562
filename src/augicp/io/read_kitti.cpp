// SPDX-License-Identifier: MIT
#include "augicp/io/read_kitti.h"

#include "augicp/core/check.h"
#include "augicp/io/binary_points.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::size_t kNumberBytes = 4;

// The format has no signature. But intensities are never negative, and coordinates are.
void check_intensities(const FileBytes& file, std::size_t stride) {
  for (std::size_t at = 3 * kNumberBytes; at < file.bytes.size(); at += stride) {
    const double intensity = read_scalar(file.bytes.data() + at, ScalarType::Float32, ByteOrder::Little);
    if (intensity < 0.0)
      throw io_error_at_byte(file.path, at,
                             fmt::format("expected x y z intensity of float32, found the intensity {}", intensity));
  }
}

}  // namespace

CloudFile parse_kitti(const FileBytes& file, const ReadOptions& options) {
  const int num_columns = options.num_bin_columns;
  require(num_columns == 3 || num_columns == 4, "num_bin_columns", num_columns, "must be 3 or 4");
  const std::size_t stride = static_cast<std::size_t>(num_columns) * kNumberBytes;
  const std::size_t excess = file.bytes.size() % stride;
  if (excess != 0)
    throw io_error_at_byte(
        file.path, file.bytes.size() - excess,
        fmt::format("expected points of {} float32 numbers, {} bytes, found {} bytes", num_columns, stride, excess));
  check_num_points(file.path, file.bytes.size() / stride, options);
  const bool is_sweep = num_columns == 4;
  if (is_sweep) check_intensities(file, stride);

  BinaryPoints points{file.bytes, ByteOrder::Little, {}, 1, file.bytes.size() / stride};
  for (std::size_t axis = 0; axis < 3; ++axis)
    points.columns[axis] = {axis * kNumberBytes, stride, 0, ScalarType::Float32};
  PointTable table{"kitti bin", points.row_length, false, 0, std::nullopt};
  if (is_sweep) {
    table.viewpoint = Vec3d::Zero();
    table.has_intensities = true;
    points.columns[7] = {3 * kNumberBytes, stride, 0, ScalarType::Float32};
    if (options.keep_fields) {
      table.fields = {{"intensity", ScalarType::Float32, 1, {}}};
      points.fields = {*points.columns[7]};
    }
  }
  return build_cloud(file, table, [&](CloudBuilder& builder) { add_points(points, builder); });
}

}  // namespace augicp
