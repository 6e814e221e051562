// SPDX-License-Identifier: MIT
#include "augicp/io/las_records.h"

#include "augicp/io/format.h"
#include "augicp/io/las_format.h"

namespace augicp {
namespace {

PointField column_of(const LasRecords& las, const las::Dimension& dimension) {
  PointField field{std::string(dimension.name), dimension.type, 1, {}};
  const std::size_t size = num_bytes(dimension.type);
  field.values.reserve(las.num_points() * size);
  for (std::size_t at = dimension.offset; at < las.records.size(); at += las.record_length) {
    char number[8];
    copy_scalar(las.records.data() + at, dimension.type, ByteOrder::Little, number);
    if (dimension.num_bits > 0) {
      const int bits = static_cast<std::uint8_t>(number[0]) >> dimension.shift;
      number[0] = static_cast<char>(bits & ((1 << dimension.num_bits) - 1));
    }
    field.values.append(number, size);
  }
  return field;
}

PointField column_of(const LasRecords& las, const las::ExtraDimension& extra, std::size_t offset) {
  PointField field{extra.name, extra.is_scaled ? ScalarType::Float64 : extra.type, extra.count, {}};
  const std::size_t size = num_bytes(extra.type);
  for (std::size_t at = offset; at < las.records.size(); at += las.record_length)
    for (std::size_t k = 0; k < extra.count; ++k) {
      const char* const bytes = las.records.data() + at + k * size;
      char number[8];
      copy_scalar(bytes, extra.type, ByteOrder::Little, number);
      if (extra.is_scaled) {
        const double value = read_scalar(bytes, extra.type, ByteOrder::Little) * extra.scale + extra.offset;
        std::memcpy(number, &value, sizeof(value));
      }
      field.values.append(number, num_bytes(field.type));
    }
  return field;
}

// Extra bytes as they are described, and those that are not as bytes.
void add_extra_columns(const LasRecords& las, PointFields& fields) {
  std::size_t at = las::kRecordSizes[las.point_format];
  for (const las::ExtraDimension& extra : las::extra_dimensions(las.head)) {
    const std::size_t size = extra.count * num_bytes(extra.type);
    if (at + size > las.record_length) break;
    fields.fields.push_back(column_of(las, extra, at));
    at += size;
  }
  if (at < las.record_length)
    fields.fields.push_back(column_of(las, {"extra_bytes", ScalarType::Uint8, las.record_length - at}, at));
}

}  // namespace

PointFields fields_of(const LasRecords& las) {
  PointFields fields;
  for (const las::Dimension& dimension : las::dimensions_of(las.point_format))
    fields.fields.push_back(column_of(las, dimension));
  add_extra_columns(las, fields);
  const auto num_records = las::number_at<std::uint32_t>(las.head, las::kNumVlrs);
  if (num_records > 0)
    fields.not_kept.push_back(
        fmt::format("the {} variable length records, among them the coordinate system", num_records));
  if (las::has_waveform(las.point_format)) fields.not_kept.push_back("the waveforms");
  return fields;
}

}  // namespace augicp
