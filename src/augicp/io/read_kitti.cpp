// SPDX-License-Identifier: MIT
#include "augicp/io/read_kitti.h"

#include <optional>
#include <utility>

#include "augicp/core/check.h"
#include "augicp/io/binary_points.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::size_t kNumberBytes = 4;
constexpr int kNumKitti = 4, kMostColumns = 6;

double number_at(const FileBytes& file, std::size_t at) {
  return read_scalar(file.bytes.data() + at, ScalarType::Float32, ByteOrder::Little);
}

// The place of the first negative number in the columns from the fourth to end_column.
std::optional<std::size_t> negative_place(const FileBytes& file, std::size_t num_columns, std::size_t end_column) {
  for (std::size_t at = 0; at < file.bytes.size(); at += num_columns * kNumberBytes)
    for (std::size_t column = 3; column < end_column; ++column)
      if (number_at(file, at + column * kNumberBytes) < 0.0) return at + column * kNumberBytes;
  return std::nullopt;
}

bool divides(std::size_t num_columns, const FileBytes& file) {
  return file.bytes.size() % (num_columns * kNumberBytes) == 0;
}

void check_columns(const FileBytes& file, std::size_t num_columns) {
  const std::size_t stride = num_columns * kNumberBytes, excess = file.bytes.size() % stride;
  if (excess != 0)
    throw io_error_at_byte(
        file.path, file.bytes.size() - excess,
        fmt::format("expected points of {} float32 numbers, {} bytes, found {} bytes", num_columns, stride, excess));
  if (num_columns == 3) return;
  if (const auto at = negative_place(file, num_columns, 4))
    throw io_error_at_byte(file.path, *at,
                           fmt::format("expected x y z intensity of float32, found the intensity {}; is the number of "
                                       "columns another? It may be stated",
                                       number_at(file, *at)));
}

// The numbers of columns from 4 that the file fits.
std::vector<std::size_t> possible_columns(const FileBytes& file) {
  std::vector<std::size_t> possible;
  for (std::size_t columns = kNumKitti; columns <= kMostColumns; ++columns)
    if (divides(columns, file) && !negative_place(file, columns, columns)) possible.push_back(columns);
  return possible;
}

BinaryPoints points_of(const FileBytes& file, std::size_t num_columns, const ReadOptions& options, PointTable& table) {
  const std::size_t stride = num_columns * kNumberBytes;
  BinaryPoints points{file.bytes, ByteOrder::Little, {}, 1, file.bytes.size() / stride};
  const auto column_at = [&](std::size_t i) { return BinaryColumn{i * kNumberBytes, stride, 0, ScalarType::Float32}; };
  for (std::size_t axis = 0; axis < 3; ++axis) points.columns[axis] = column_at(axis);
  table.format = fmt::format("bin of {} float32 numbers a point", num_columns);
  table.num_points = points.row_length;
  if (num_columns == 3) return points;
  table.viewpoint = Vec3d::Zero();
  table.has_intensities = true;
  points.columns[7] = column_at(3);
  for (std::size_t i = 3; i < num_columns && options.keep_fields; ++i) {
    table.fields.push_back({i == 3 ? "intensity" : fmt::format("column_{}", i + 1), ScalarType::Float32, 1, {}});
    points.fields.push_back(column_at(i));
  }
  return points;
}

}  // namespace

CloudFile parse_kitti(const FileBytes& file, const ReadOptions& options) {
  const int stated = options.num_bin_columns;
  require(stated == 0 || (stated >= 3 && stated <= kMostColumns), "num_bin_columns", stated, "must be 0, 3, 4, 5 or 6");
  const std::vector<std::size_t> possible = stated == 0 ? possible_columns(file) : std::vector<std::size_t>{};
  const auto num_columns = static_cast<std::size_t>(stated != 0 ? stated : kNumKitti);
  const std::size_t taken = possible.empty() ? num_columns : possible.front();
  check_columns(file, taken);
  check_num_points(file.path, file.bytes.size() / (taken * kNumberBytes), options);
  PointTable table;
  const BinaryPoints points = points_of(file, taken, options, table);
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_points(points, builder); });
  if (possible.size() > 1)
    read.report.warnings.push_back(
        fmt::format("read as {} numbers a point, but {} would do too; state them", taken, possible[1]));
  return read;
}

}  // namespace augicp
