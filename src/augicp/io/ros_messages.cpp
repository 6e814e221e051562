// SPDX-License-Identifier: MIT
#include "augicp/io/ros_messages.h"

#include <limits>
#include <stdexcept>
#include <vector>

#include "augicp/io/cdr_writer.h"
#include "augicp/io/cloud_rows.h"
#include "augicp/io/field_layout.h"

namespace augicp {
namespace {

void put_header(CdrWriter& message, const StampedFrame& header) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  // Rounded down, so that the rest is not negative.
  std::int64_t seconds = header.stamp_ns / kNanoseconds, rest = header.stamp_ns % kNanoseconds;
  if (rest < 0) --seconds, rest += kNanoseconds;
  message.number(static_cast<std::int32_t>(seconds));
  message.number(static_cast<std::uint32_t>(rest));
  message.text(header.frame);
}

void put_vector(CdrWriter& message, const Vec3d& vector) {
  for (int axis = 0; axis < 3; ++axis) message.number(vector[axis]);
}

void put_pose(CdrWriter& message, const Rigid3& pose) {
  put_vector(message, pose.translation);
  for (const double part : {pose.rotation.x(), pose.rotation.y(), pose.rotation.z(), pose.rotation.w()})
    message.number(part);
}

void put_matrix(CdrWriter& message, const Mat6d& matrix) {
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) message.number(matrix(i, k));
}

std::uint8_t code_of(ScalarType type) {
  switch (type) {
    case ScalarType::Int8:
      return 1;
    case ScalarType::Uint8:
      return 2;
    case ScalarType::Int16:
      return 3;
    case ScalarType::Uint16:
      return 4;
    case ScalarType::Int32:
      return 5;
    case ScalarType::Uint32:
      return 6;
    case ScalarType::Float32:
      return 7;
    default:
      return 8;  // double; fields of 64-bit integers are widened before
  }
}

bool is_wide_integer(const PointField& field) {
  return field.type == ScalarType::Int64 || field.type == ScalarType::Uint64;
}

PointFields fields_for_message(PointFields fields) {
  fields = fields_for_pcd(std::move(fields));
  for (PointField& field : fields.fields) {
    if (!is_wide_integer(field)) continue;
    std::string values;
    for (std::size_t row = 0; row < field.num_rows(); ++row)
      for (std::size_t k = 0; k < field.count; ++k) {
        const double value = field.at(row, k);
        values.append(reinterpret_cast<const char*>(&value), sizeof(value));
      }
    field = {field.name, ScalarType::Float64, field.count, std::move(values)};
  }
  return fields;
}

std::string rows_of(const std::vector<RowPart>& parts, std::size_t num_points, const IndexImage* grid) {
  std::string rows;
  const std::size_t num_rows = grid ? grid->index.size() : num_points;
  for (std::size_t i = 0; i < num_rows; ++i)
    for (const RowPart& part : parts) part.append({grid ? grid->index[i] : static_cast<std::int32_t>(i), i}, rows);
  return rows;
}

// The sizes and fields of the message, and the lengths of a point and of a row.
void put_layout(CdrWriter& message, const std::vector<RowColumn>& columns, std::uint32_t height, std::uint32_t width) {
  message.number(height);
  message.number(width);
  message.number(static_cast<std::uint32_t>(columns.size()));
  std::uint32_t offset = 0;
  for (const RowColumn& column : columns) {
    message.text(column.name);
    message.number(offset);
    message.number(code_of(column.type));
    message.number(static_cast<std::uint32_t>(column.count));
    offset += static_cast<std::uint32_t>(column.count * num_bytes(column.type));
  }
  message.number(std::uint8_t{0});  // little endian
  message.number(offset);
  message.number(offset * width);
}

}  // namespace

std::string point_cloud2_message(const StampedFrame& header, const CloudFile& file) {
  const IndexImage* grid = file.grid ? &*file.grid : nullptr;
  const PointFields fields = fields_for_message(fields_of(file));
  const std::vector<RowPart> parts = row_parts(file.cloud, fields, grid, FileEncoding::Binary);
  const std::string rows = rows_of(parts, file.cloud.size(), grid);
  if (rows.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("cloud: must have less than 4 GiB for a PointCloud2");
  CdrWriter message;
  put_header(message, header);
  const auto width = static_cast<std::uint32_t>(grid ? static_cast<std::size_t>(grid->width) : file.cloud.size());
  put_layout(message, columns_of(parts), grid ? static_cast<std::uint32_t>(grid->height) : 1, width);
  message.bytes(rows);
  message.number(static_cast<std::uint8_t>(grid ? 0 : 1));  // whether every point is finite
  return std::move(message).taken();
}

std::string tf_message(const StampedFrame& parent, const std::string& child, const Rigid3& parent_from_child) {
  CdrWriter message;
  message.number(std::uint32_t{1});
  put_header(message, parent);
  message.text(child);
  put_pose(message, parent_from_child);
  return std::move(message).taken();
}

std::string odometry_message(const StampedFrame& parent, const std::string& child, const Rigid3& parent_from_child,
                             const std::optional<Mat6d>& covariance, const Twist& twist) {
  CdrWriter message;
  put_header(message, parent);
  message.text(child);
  put_pose(message, parent_from_child);
  put_matrix(message, covariance.value_or(Mat6d::Zero()));
  put_vector(message, twist.linear);
  put_vector(message, twist.angular);
  put_matrix(message, Mat6d::Zero());
  return std::move(message).taken();
}

}  // namespace augicp
