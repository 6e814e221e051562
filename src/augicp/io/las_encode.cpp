// SPDX-License-Identifier: MIT
// LAS records of a cloud from another format.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "augicp/io/cloud_rows.h"
#include "augicp/io/field_layout.h"
#include "augicp/io/format.h"
#include "augicp/io/las_format.h"
#include "augicp/io/write_las.h"

namespace augicp {
namespace {

using las::set_number;

constexpr std::size_t kDescription = 192;  // bytes that describe an extra dimension
constexpr std::size_t kMaxExtra = 65'535 / kDescription;

// A column with a place in the record, and one without.
struct Placed {
  const PointField* field;
  las::Dimension dimension;
};

struct Layout {
  int point_format = 6;
  std::vector<Placed> placed;
  PointFields extra;
};

// Whether every value fits into the dimension as it is.
bool fits(const PointField& field, const las::Dimension& dimension) {
  if (field.count != 1) return false;
  if (dimension.type == ScalarType::Float64)
    return field.type == ScalarType::Float64 || field.type == ScalarType::Float32;
  const bool is_signed = dimension.type == ScalarType::Int16;
  const double limit = std::exp2(dimension.num_bits > 0 ? dimension.num_bits : 8.0 * double(num_bytes(dimension.type)));
  for (std::size_t row = 0; row < field.num_rows(); ++row) {
    const double value = field.at(row);
    if (std::trunc(value) != value) return false;  // and not NaN
    if (value < (is_signed ? -limit / 2 : 0.0) || value >= (is_signed ? limit / 2 : limit)) return false;
  }
  return true;
}

bool has_colours(const PointFields& fields) {
  for (const char* name : {"red", "green", "blue"}) {
    const PointField* const field = fields.find(name);
    if (!field || !fits(*field, {name, 0, ScalarType::Uint16})) return false;
  }
  return true;
}

Layout layout_of(const PointFields& fields) {
  Layout layout;
  layout.point_format = has_colours(fields) ? 7 : 6;
  const std::vector<las::Dimension> dimensions = las::dimensions_of(layout.point_format);
  for (const PointField& field : fields.fields) {
    const auto known = std::find_if(dimensions.begin(), dimensions.end(),
                                    [&](const las::Dimension& d) { return d.name == lower_case(field.name); });
    if (known != dimensions.end() && fits(field, *known)) {
      layout.placed.push_back({&field, *known});
    } else {
      layout.extra.fields.push_back(field);
    }
  }
  return layout;
}

void set_value(std::string& records, std::size_t at, const las::Dimension& dimension, double value) {
  with_type(dimension.type, [&](auto zero) {
    using T = decltype(zero);
    if (dimension.num_bits == 0) return set_number(records, at, static_cast<T>(value));
    records[at] =
        static_cast<char>(static_cast<std::uint8_t>(records[at]) | static_cast<int>(value) << dimension.shift);
  });
}

// LAS has colours of 16 bits: the largest of 8 becomes the largest.
double las_value(const Placed& placed, std::size_t row) {
  constexpr double kEightToSixteenBits = 257.0;
  const bool is_colour =
      placed.dimension.name == "red" || placed.dimension.name == "green" || placed.dimension.name == "blue";
  const bool is_byte = placed.field->type == ScalarType::Uint8;
  return placed.field->at(row) * (is_colour && is_byte ? kEightToSixteenBits : 1.0);
}

int type_code(ScalarType type) {
  constexpr int kCodes[] = {2, 1, 4, 3, 6, 5, 8, 7, 9, 10};
  return kCodes[static_cast<std::size_t>(type)];
}

std::string header_of(int point_format, std::size_t record_length, std::size_t num_points,
                      const std::vector<RowColumn>& extra) {
  const std::size_t vlr = extra.empty() ? 0 : las::kVlrHeader + kDescription * extra.size();
  constexpr std::size_t kSize = las::kHeaderSizes[4];
  std::string head(kSize + vlr, '\0');
  head.replace(0, 4, "LASF");
  set_number<std::uint16_t>(head, 6,
                            16);  // global encoding: a coordinate system, were there one, would be text
  head.replace(24, 2, "\x01\x04");
  head.replace(58, 6, "augicp");
  set_number<std::uint16_t>(head, las::kHeaderSize, kSize);
  set_number(head, las::kPointsOffset, static_cast<std::uint32_t>(head.size()));
  set_number<std::uint32_t>(head, las::kNumVlrs, extra.empty() ? 0 : 1);
  set_number(head, las::kPointFormat, static_cast<std::uint8_t>(point_format));
  set_number(head, las::kRecordLength, static_cast<std::uint16_t>(record_length));
  set_number(head, las::kNumPoints, static_cast<std::uint64_t>(num_points));
  if (extra.empty()) return head;
  head.replace(kSize + 2, 9, "LASF_Spec");
  set_number<std::uint16_t>(head, kSize + 18, 4);
  set_number(head, kSize + 20, static_cast<std::uint16_t>(kDescription * extra.size()));
  for (std::size_t i = 0; i < extra.size(); ++i) {
    const std::size_t at = kSize + las::kVlrHeader + kDescription * i;
    head[at + 2] = static_cast<char>(type_code(extra[i].type));
    const std::string name = extra[i].name.substr(0, 31);
    head.replace(at + 4, name.size(), name);
  }
  return head;
}

double step_for(const Cloud& cloud) {
  const double extent = bounds(cloud).diagonal();
  return extent > 0.0 ? std::pow(10.0, std::ceil(std::log10(extent)) - 9.0) : 1e-3;
}

// The fields, and the cloud's intensities if none has them. LAS has a place for whole numbers.
PointFields with_intensities(PointFields fields, const Cloud& cloud) {
  if (!cloud.has_intensities() || fields.find("intensity") || fields.find("scalar_intensity")) return fields;
  PointField field{"intensity", ScalarType::Float32, 1, {}};
  field.values.resize(cloud.size() * field.row_bytes());
  std::memcpy(field.values.data(), cloud.intensities.data(), field.values.size());
  fields.fields.push_back(std::move(field));
  return fields;
}

// The directions and further columns of each point, as bytes.
std::vector<RowPart> extra_parts(const Cloud& cloud, const PointFields& fields, const Layout& layout) {
  std::vector<RowPart> parts = row_parts(cloud, layout.extra, nullptr, FileEncoding::Binary);
  parts.erase(parts.begin());  // the positions
  const bool is_placed = fields.find("intensity") && !layout.extra.find("intensity");
  if (is_placed) std::erase_if(parts, [](const RowPart& part) { return part.columns[0].name == "intensity"; });
  return parts;
}

// A name that LAS has for something else gets a mark.
std::vector<RowColumn> extra_columns(const std::vector<RowPart>& parts, int point_format) {
  std::vector<RowColumn> columns = columns_of(parts);
  for (RowColumn& column : columns)
    for (const las::Dimension& dimension : las::dimensions_of(point_format))
      if (lower_case(column.name) == dimension.name) column.name += '_';
  return columns;
}

}  // namespace

LasRecords las_records_of(const CloudFile& file) {
  constexpr std::size_t kReturns = 14;
  const PointFields given = file.grid ? without_empty_cells(file.fields, *file.grid) : file.fields;
  const PointFields fields = fields_for_las(with_intensities(given, file.cloud));
  const Layout layout = layout_of(fields);
  const std::vector<RowPart> parts = extra_parts(file.cloud, fields, layout);
  const std::vector<RowColumn> extra = extra_columns(parts, layout.point_format);
  if (extra.size() > kMaxExtra)
    throw std::invalid_argument(
        fmt::format("fields: expected at most {} extra columns, found {}", kMaxExtra, extra.size()));
  LasRecords las;
  std::size_t extra_bytes = 0;
  for (const RowColumn& column : extra) extra_bytes += num_bytes(column.type);
  const std::size_t fixed = las::kRecordSizes[layout.point_format];
  las.point_format = layout.point_format;
  las.record_length = fixed + extra_bytes;
  las.scale = Vec3d::Constant(step_for(file.cloud));
  las.records.reserve(file.cloud.size() * las.record_length);
  for (std::size_t i = 0; i < file.cloud.size(); ++i) {
    las.records.append(fixed, '\0');
    if (!fields.find("return_number")) las.records[i * las.record_length + kReturns] = 0x11;  // the first of one
    for (const RowPart& part : parts) part.append({static_cast<std::int32_t>(i), i}, las.records);
    for (const Placed& placed : layout.placed)
      set_value(las.records, i * las.record_length + placed.dimension.offset, placed.dimension, las_value(placed, i));
  }
  las.head = header_of(layout.point_format, las.record_length, file.cloud.size(), extra);
  for (std::size_t axis = 0; axis < 3; ++axis)
    set_number(las.head, las::kScale + 8 * axis, las.scale[static_cast<int>(axis)]);
  return las;
}

}  // namespace augicp
