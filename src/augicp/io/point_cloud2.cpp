// SPDX-License-Identifier: MIT
#include "augicp/io/point_cloud2.h"

#include <optional>
#include <vector>

#include "augicp/io/binary_points.h"
#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"
#include "augicp/io/message_reader.h"

namespace augicp {
namespace {

constexpr std::uint32_t kMaxFields = 1024;

struct Field {
  std::string name;
  std::uint32_t offset = 0;
  ScalarType type = ScalarType::Float32;
  std::uint32_t count = 1;
};

struct Layout {
  std::int64_t stamp_ns = 0;
  std::string frame;
  std::uint64_t height = 0, width = 0;
  std::vector<Field> fields;
  bool is_big_endian = false;
  std::uint64_t point_step = 0, row_step = 0;
  std::string_view data;
};

std::optional<ScalarType> type_of(std::uint64_t code) {
  using enum ScalarType;
  constexpr ScalarType kTypes[] = {Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64};
  return code >= 1 && code <= std::size(kTypes) ? std::optional(kTypes[code - 1]) : std::nullopt;
}

std::vector<Field> take_fields(MessageReader& reader) {
  const std::uint32_t count = reader.take_count();
  if (count > kMaxFields) reader.fail(fmt::format("expected at most {} fields, found {}", kMaxFields, count));
  std::vector<Field> fields;
  for (std::uint32_t i = 0; i < count; ++i) {
    Field field;
    field.name = reader.take_text();
    field.offset = reader.take_count();
    const auto type = type_of(reader.take(ScalarType::Uint8));
    field.count = reader.take_count();
    if (!type) reader.fail("expected a type from 1 to 8 of field " + in_quotes(field.name));
    field.type = *type;
    fields.push_back(std::move(field));
  }
  return fields;
}

Layout layout_of(MessageReader& reader) {
  Layout layout;
  const MessageHeader header = reader.take_header();
  layout.stamp_ns = header.stamp_ns;
  layout.frame = header.frame;
  layout.height = reader.take_count();
  layout.width = reader.take_count();
  layout.fields = take_fields(reader);
  layout.is_big_endian = reader.take(ScalarType::Uint8) != 0;
  layout.point_step = reader.take_count();
  layout.row_step = reader.take_count();
  layout.data = reader.take_bytes(reader.take_count());
  return layout;
}

void check_steps(const MessageReader& reader, const Layout& layout) {
  for (const Field& field : layout.fields) {
    const std::uint64_t size = std::uint64_t{field.count} * num_bytes(field.type);
    if (field.count == 0 || field.offset > layout.point_step || size > layout.point_step - field.offset)
      reader.fail(
          fmt::format("expected field {} within the {} bytes of a point", in_quotes(field.name), layout.point_step));
  }
  // A single row may state anything as its length.
  const std::uint64_t row_bytes = layout.width * layout.point_step;
  const std::uint64_t needed = layout.height == 0 ? 0 : (layout.height - 1) * layout.row_step + row_bytes;
  if (layout.height > 1 && layout.row_step < row_bytes)
    reader.fail(fmt::format("expected rows of {} bytes at least, found {}", row_bytes, layout.row_step));
  if (layout.width > 0 && row_bytes / layout.width != layout.point_step) reader.fail("expected smaller points");
  if (needed > layout.data.size())
    reader.fail(fmt::format("expected {} bytes of points, found {}", needed, layout.data.size()));
}

}  // namespace

PointCloud2 parse_point_cloud2(const std::filesystem::path& source, std::string_view message, MessageForm form,
                               const ReadOptions& options) {
  MessageReader reader(source, "PointCloud2", message, form);
  const Layout layout = layout_of(reader);
  check_steps(reader, layout);
  check_num_points(source, layout.width * layout.height, options);

  std::vector<std::string> names;
  for (const Field& field : layout.fields) names.push_back(field.name);
  const PointColumns columns = find_columns(source, names);
  PointTable table;
  table.format = "PointCloud2";
  table.num_points = layout.width * layout.height;
  table.has_normals = columns.has_normals();
  table.has_intensities = columns.has_intensities();
  table.width = layout.height > 1 ? static_cast<int>(layout.width) : 0;
  BinaryPoints points{
      layout.data, layout.is_big_endian ? ByteOrder::Big : ByteOrder::Little, {}, layout.height, layout.width};
  for (std::size_t i = 0; i < layout.fields.size(); ++i) {
    const Field& field = layout.fields[i];
    const BinaryColumn column{field.offset, layout.point_step, layout.row_step, field.type};
    for (std::size_t role = 0; role < kNumRoles; ++role)
      if (columns.of_role[role] == i) points.columns[role] = column;
    if (!options.keep_fields || !columns.is_field(i)) continue;
    table.fields.push_back({field.name, field.type, field.count, {}});
    points.fields.push_back(column);
  }
  return {build_cloud({source, {}}, table, [&](CloudBuilder& builder) { add_points(points, builder); }),
          layout.stamp_ns, layout.frame};
}

}  // namespace augicp
