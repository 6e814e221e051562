// SPDX-License-Identifier: MIT
#include "augicp/io/read_ply.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "augicp/io/binary_points.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/ply_header.h"
#include "augicp/io/ply_mesh.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

using Elements = std::span<const PlyElement>;

IoError cut_short(const FileBytes& file, const PlyElement& element) {
  return io_error_at_byte(
      file.path, file.bytes.size(),
      fmt::format("expected {} of element {}, the file ends here", element.count, in_quotes(element.name)));
}

// ---- binary bodies

ByteOrder byte_order(const PlyHeader& header) {
  return header.encoding == PlyEncoding::BinaryBigEndian ? ByteOrder::Big : ByteOrder::Little;
}

// The offset after a record with lists.
std::uint64_t skip_record(const FileBytes& file, const PlyElement& element, std::uint64_t offset, ByteOrder order) {
  const auto take = [&](std::uint64_t num) {
    if (num > file.bytes.size() - offset) throw cut_short(file, element);
    return std::exchange(offset, offset + num);
  };
  for (const PlyProperty& property : element.properties) {
    std::uint64_t count = 1;
    if (property.list_length) {
      const std::uint64_t at = take(num_bytes(*property.list_length));
      const double length = read_scalar(file.bytes.data() + at, *property.list_length, order);
      if (length < 0.0) throw io_error_at_byte(file.path, at, fmt::format("expected a list length, found {}", length));
      count = static_cast<std::uint64_t>(length);
    }
    take(count * num_bytes(property.type));  // count is below 2^32
  }
  return offset;
}

// The offset after an element's records. Throws IoError if the file ends before.
std::uint64_t skip_binary(const FileBytes& file, const PlyElement& element, std::uint64_t offset, ByteOrder order) {
  if (element.properties.empty()) return offset;
  if (!element.has_lists()) {
    if (element.count > (file.bytes.size() - offset) / element.stride()) throw cut_short(file, element);
    return offset + element.count * element.stride();
  }
  for (std::uint64_t i = 0; i < element.count; ++i) offset = skip_record(file, element, offset, order);
  return offset;
}

BinaryPoints binary_points(const FileBytes& file, const PlyElement& vertex, const PointColumns& columns,
                           std::uint64_t offset, ByteOrder order, bool with_fields) {
  BinaryPoints points{file.bytes, order, {}, 1, vertex.count};
  for (std::size_t column = 0; column < vertex.properties.size(); ++column) {
    const ScalarType type = vertex.properties[column].type;
    for (std::size_t role = 0; role < kNumRoles; ++role)
      if (columns.of_role[role] == column) points.columns[role] = {offset, vertex.stride(), 0, type};
    if (with_fields && columns.is_field(column)) points.fields.push_back({offset, vertex.stride(), 0, type});
    offset += num_bytes(type);
  }
  return points;
}

CloudFile read_binary(const FileBytes& file, const PlyHeader& header, Elements before, const PlyElement& vertex,
                      Elements after, const PointColumns& columns, const PointTable& table) {
  const ByteOrder order = byte_order(header);
  std::uint64_t offset = header.body_offset;
  for (const PlyElement& element : before) offset = skip_binary(file, element, offset, order);
  const std::uint64_t begin = offset;
  offset = skip_binary(file, vertex, begin, order);
  for (const PlyElement& element : after) offset = skip_binary(file, element, offset, order);

  const BinaryPoints points = binary_points(file, vertex, columns, begin, order, !table.fields.empty());
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_points(points, builder); });
  if (const std::uint64_t excess = file.bytes.size() - offset; excess > 0)
    read.report.warnings.push_back(fmt::format("{} bytes after the declared elements were not read", excess));
  return read;
}

// ---- text bodies

void skip_text_record(const FileBytes& file, const PlyElement& element, std::string_view line, std::uint64_t number) {
  std::string_view rest = line;
  const auto take = [&] {
    const auto field = next_field(rest);
    if (!field)
      throw io_error_at_line(
          file.path, number,
          fmt::format("expected more values of element {}, found {}", in_quotes(element.name), in_quotes(line)));
    return *field;
  };
  for (const PlyProperty& property : element.properties) {
    std::uint64_t count = 1;
    if (property.list_length) {
      const std::string_view field = take();
      const auto length = parse_count(field);
      if (!length) throw io_error_at_line(file.path, number, "expected a list length, found " + in_quotes(field));
      count = *length;
    }
    for (std::uint64_t i = 0; i < count; ++i) take();
  }
}

void skip_text(const FileBytes& file, const PlyHeader& header, Elements elements, TextLines& lines) {
  for (const PlyElement& element : elements) {
    if (element.properties.empty()) continue;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      const auto line = lines.next_not_blank();
      if (!line) throw cut_short(file, element);
      skip_text_record(file, element, *line, header.num_lines + lines.line());
    }
  }
}

// The shortest line has one digit and one separator per value; the last line has no line end.
void check_text_size(const FileBytes& file, const PlyHeader& header, const PlyElement& vertex) {
  const std::uint64_t num_left = file.bytes.size() - header.body_offset;
  if (vertex.count > (num_left + 1) / (2 * vertex.properties.size())) throw cut_short(file, vertex);
}

CloudFile read_text(const FileBytes& file, const PlyHeader& header, Elements before, const PlyElement& vertex,
                    Elements after, const PointColumns& columns, const PointTable& table) {
  check_text_size(file, header, vertex);
  TextLines lines(std::string_view(file.bytes).substr(header.body_offset));
  skip_text(file, header, before, lines);
  TextPoints points{columns, vertex.properties.size(), ' ', false, vertex.count};
  for (std::size_t i = 0; i < vertex.properties.size() && !table.fields.empty(); ++i)
    if (columns.is_field(i)) points.fields.push_back(i);
  TextLines behind = lines;
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) {
    behind = lines;
    add_points(file, points, behind, header.num_lines, builder);
  });
  skip_text(file, header, after, behind);
  if (behind.next_not_blank()) read.report.warnings.push_back("lines after the declared elements were not read");
  if (!ends_with_a_line_end(file.bytes)) read.report.warnings.push_back(kNoLineEndWarning);
  return read;
}

void check_no_lists(const FileBytes& file, const PlyElement& vertex) {
  for (const PlyProperty& property : vertex.properties)
    if (property.list_length)
      throw io_error(file.path, fmt::format("expected single numbers of element 'vertex', found the list {}",
                                            in_quotes(property.name)));
}

std::vector<PointField> declared_fields(const PlyElement& vertex, const PointColumns& columns) {
  std::vector<PointField> fields;
  for (std::size_t i = 0; i < vertex.properties.size(); ++i)
    if (columns.is_field(i)) fields.push_back({vertex.properties[i].name, vertex.properties[i].type, 1, {}});
  return fields;
}

std::vector<std::string> other_elements(Elements elements) {
  std::vector<std::string> sentences;
  for (const PlyElement& element : elements)
    if (element.name != "vertex" && element.count > 0 && !element.properties.empty())
      sentences.push_back(fmt::format("the {} records of element {}", element.count, in_quotes(element.name)));
  return sentences;
}

}  // namespace

CloudFile parse_ply(const FileBytes& file, const ReadOptions& options) {
  const PlyHeader header = parse_ply_header(file);
  if (options.sample_faces && has_faces(header)) return sampled_ply(file, header, options);
  const Elements elements(header.elements);
  const auto vertex =
      std::find_if(elements.begin(), elements.end(), [](const PlyElement& e) { return e.name == "vertex"; });
  if (vertex == elements.end()) throw io_error(file.path, "expected an element 'vertex', found none");
  check_num_points(file.path, vertex->count, options);
  check_no_lists(file, *vertex);
  std::vector<std::string> names;
  for (const PlyProperty& property : vertex->properties) names.push_back(property.name);
  const PointColumns columns = find_columns(file.path, names);

  const Elements before(elements.begin(), vertex), after(std::next(vertex), elements.end());
  PointTable table{"ply ascii", vertex->count, columns.has_normals(), 0, std::nullopt, columns.has_intensities()};
  if (options.keep_fields) table.fields = declared_fields(*vertex, columns);
  const bool is_text = header.encoding == PlyEncoding::Ascii;
  if (!is_text)
    table.format = byte_order(header) == ByteOrder::Big ? "ply binary_big_endian" : "ply binary_little_endian";
  CloudFile read = is_text ? read_text(file, header, before, *vertex, after, columns, table)
                           : read_binary(file, header, before, *vertex, after, columns, table);
  if (options.keep_fields)
    for (std::string& what : other_elements(elements)) read.fields.not_kept.push_back(std::move(what));
  return read;
}

}  // namespace augicp
