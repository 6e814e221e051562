// SPDX-License-Identifier: MIT
#include "augicp/io/read_pcd.h"

#include <lzf.h>

#include <utility>

#include "augicp/io/binary_points.h"
#include "augicp/io/format.h"
#include "augicp/io/pcd_header.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

IoError cut_short(const FileBytes& file, std::uint64_t num_points) {
  return io_error_at_byte(file.path, file.bytes.size(),
                          fmt::format("expected {} points, the file ends here", num_points));
}

PointColumns point_columns(const FileBytes& file, const PcdHeader& header) {
  std::vector<std::string> names;
  for (const PcdField& field : header.fields) names.push_back(field.name);
  PointColumns columns = find_columns(file.path, names);
  if (columns.has_intensities() && header.fields[columns.of_role[7]].count != 1) columns.of_role[7] = kNoColumn;
  for (const std::size_t column : columns.of_role)
    if (column != kNoColumn && header.fields[column].count != 1)
      throw io_error(file.path, fmt::format("expected COUNT 1 of field {}, found {}", in_quotes(names[column]),
                                            header.fields[column].count));
  return columns;
}

bool is_field(const PcdHeader& header, const PointColumns& columns, std::size_t field) {
  return columns.is_field(field) && !header.fields[field].is_padding();
}

std::vector<PointField> declared_fields(const PcdHeader& header, const PointColumns& columns) {
  std::vector<PointField> declared;
  for (std::size_t i = 0; i < header.fields.size(); ++i)
    if (const PcdField& field = header.fields[i]; is_field(header, columns, i))
      declared.push_back({field.name, field.type, field.count, {}});
  return declared;
}

CloudFile read_ascii(const FileBytes& file, const PcdHeader& header, PointColumns columns, const PointTable& table) {
  // A field of several numbers has one column of text per number.
  std::vector<std::size_t> first_column;
  std::size_t num_columns = 0;
  for (const PcdField& field : header.fields)
    first_column.push_back(std::exchange(num_columns, num_columns + field.count));
  const PointColumns fields_of_roles = columns;
  for (std::size_t& column : columns.of_role)
    if (column != kNoColumn) column = first_column[column];

  const std::string_view body = std::string_view(file.bytes).substr(header.body_offset);
  if (header.num_points > (body.size() + 1) / (2 * num_columns)) throw cut_short(file, header.num_points);
  const TextLines lines(body);
  TextLines behind = lines;
  const char separator = separator_of(behind.next_not_blank().value_or(""));
  TextPoints points{columns, num_columns, separator, true, header.num_points};
  for (std::size_t i = 0; i < header.fields.size() && !table.fields.empty(); ++i)
    if (is_field(header, fields_of_roles, i)) points.fields.push_back(first_column[i]);
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) {
    behind = lines;
    add_points(file, points, behind, header.num_lines, builder);
  });
  if (behind.next_not_blank()) read.report.warnings.push_back("lines after the declared points were not read");
  if (!ends_with_a_line_end(file.bytes)) read.report.warnings.push_back(kNoLineEndWarning);
  return read;
}

BinaryPoints in_bytes(std::string_view bytes, const PcdHeader& header) {
  const std::size_t num_rows = header.height, row_length = header.width;
  return {bytes, ByteOrder::Little, {}, num_rows, row_length};
}

void warn_of_excess(std::uint64_t num_bytes, CloudFile& read) {
  if (num_bytes > 0)
    read.report.warnings.push_back(fmt::format("{} bytes after the declared points were not read", num_bytes));
}

CloudFile read_binary(const FileBytes& file, const PcdHeader& header, const PointColumns& columns,
                      const PointTable& table) {
  std::uint64_t stride = 0;
  for (const PcdField& field : header.fields) stride += field.bytes();
  const std::uint64_t num_left = file.bytes.size() - header.body_offset;
  if (header.num_points > num_left / stride) throw cut_short(file, header.num_points);

  BinaryPoints points = in_bytes(file.bytes, header);
  std::size_t offset = header.body_offset;
  for (std::size_t column = 0; column < header.fields.size(); ++column) {
    const PcdField& field = header.fields[column];
    for (std::size_t role = 0; role < kNumRoles; ++role)
      if (columns.of_role[role] == column) points.columns[role] = {offset, stride, stride * header.width, field.type};
    if (!table.fields.empty() && is_field(header, columns, column))
      points.fields.push_back({offset, stride, stride * header.width, field.type});
    offset += field.bytes();
  }
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_points(points, builder); });
  warn_of_excess(num_left - header.num_points * stride, read);
  return read;
}

struct Decompressed {
  std::string bytes;
  std::uint64_t num_behind = 0;  // bytes of the file after the data, except PCL's padding
};

// The body is two lengths, then LZF. Throws IoError for impossible lengths, before allocating.
Decompressed decompress(const FileBytes& file, std::size_t offset, std::uint64_t expected_bytes) {
  constexpr std::size_t kLengths = 8;
  constexpr std::uint64_t kMaxRatio = 88;  // three bytes of LZF expand to at most 264
  const std::uint64_t num_left = file.bytes.size() - offset;
  if (num_left < kLengths)
    throw io_error_at_byte(file.path, file.bytes.size(), "expected the lengths of the data, the file ends here");
  const auto length = [&](std::size_t at) {
    return read_scalar(file.bytes.data() + offset + at, ScalarType::Uint32, ByteOrder::Little);
  };
  const auto compressed = static_cast<std::uint64_t>(length(0)), uncompressed = static_cast<std::uint64_t>(length(4));
  if (compressed > num_left - kLengths)
    throw io_error_at_byte(
        file.path, offset,
        fmt::format("expected {} compressed bytes, the file has {}", compressed, num_left - kLengths));
  if (uncompressed != expected_bytes || uncompressed > compressed * kMaxRatio)
    throw io_error_at_byte(file.path, offset + 4,
                           fmt::format("expected {} uncompressed bytes, found {} stated for {} compressed",
                                       expected_bytes, uncompressed, compressed));
  std::string bytes(uncompressed, '\0');
  const unsigned int found =
      lzf_decompress(file.bytes.data() + offset + kLengths, static_cast<unsigned int>(compressed), bytes.data(),
                     static_cast<unsigned int>(uncompressed));
  if (found != uncompressed) throw io_error_at_byte(file.path, offset + kLengths, "the compressed data are damaged");
  const std::string_view behind = std::string_view(file.bytes).substr(offset + kLengths + compressed);
  // PCL pads its files with zeros to a whole page of memory.
  const bool is_padding = behind.find_first_not_of('\0') == std::string_view::npos;
  return {std::move(bytes), is_padding ? 0 : behind.size()};
}

CloudFile read_compressed(const FileBytes& file, const PcdHeader& header, const PointColumns& columns,
                          const PointTable& table) {
  // Field after field, each for all points. Padding is not stored.
  BinaryPoints points = in_bytes({}, header);
  constexpr std::uint64_t kMaxBytes = 0xffffffff;  // the limit of the stated length
  std::uint64_t offset = 0;
  for (std::size_t column = 0; column < header.fields.size(); ++column) {
    const PcdField& field = header.fields[column];
    if (field.is_padding()) continue;
    for (std::size_t role = 0; role < kNumRoles; ++role)
      if (columns.of_role[role] == column)
        points.columns[role] = {offset, field.bytes(), field.bytes() * header.width, field.type};
    if (!table.fields.empty() && is_field(header, columns, column))
      points.fields.push_back({offset, field.bytes(), field.bytes() * header.width, field.type});
    if (header.num_points > (kMaxBytes - offset) / field.bytes()) throw cut_short(file, header.num_points);
    offset += field.bytes() * header.num_points;
  }
  const Decompressed body = decompress(file, header.body_offset, offset);
  points.bytes = body.bytes;
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_points(points, builder); });
  warn_of_excess(body.num_behind, read);
  return read;
}

}  // namespace

CloudFile parse_pcd(const FileBytes& file, const ReadOptions& options) {
  const PcdHeader header = parse_pcd_header(file);
  check_num_points(file.path, header.num_points, options);
  const PointColumns columns = point_columns(file, header);
  PointTable table{"pcd ascii", header.num_points, columns.has_normals(),
                   0,           header.viewpoint,  columns.has_intensities()};
  if (options.keep_fields) table.fields = declared_fields(header, columns);
  if (header.height > 1) table.width = static_cast<int>(header.width);
  if (header.encoding == PcdEncoding::Ascii) return read_ascii(file, header, columns, table);
  table.format = header.encoding == PcdEncoding::Binary ? "pcd binary" : "pcd binary_compressed";
  return header.encoding == PcdEncoding::Binary ? read_binary(file, header, columns, table)
                                                : read_compressed(file, header, columns, table);
}

}  // namespace augicp
