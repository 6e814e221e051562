// SPDX-License-Identifier: MIT
#include "augicp/io/field_layout.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::array<const char*, 4> kChannels{"red", "green", "blue", "alpha"};
constexpr std::array<int, 4> kShifts{16, 8, 0, 24};  // of the channels in PCL's packed colour, 0xaarrggbb

std::uint32_t packed_at(const PointField& field, std::size_t row) {
  std::uint32_t packed = 0;
  std::memcpy(&packed, field.values.data() + row * sizeof(packed), sizeof(packed));
  return packed;
}

bool is_packed_colour(const PointField& field) {
  const std::string name = lower_case(field.name);
  return (name == "rgb" || name == "rgba") && field.count == 1 && num_bytes(field.type) == sizeof(std::uint32_t);
}

std::vector<PointField> unpacked(const PointField& field) {
  const std::size_t num_channels = lower_case(field.name) == "rgba" ? 4 : 3;
  std::vector<PointField> channels;
  for (std::size_t channel = 0; channel < num_channels; ++channel) {
    PointField part{kChannels[channel], ScalarType::Uint8, 1, {}};
    for (std::size_t row = 0; row < field.num_rows(); ++row)
      part.values.push_back(static_cast<char>(packed_at(field, row) >> kShifts[channel] & 0xff));
    channels.push_back(std::move(part));
  }
  return channels;
}

std::vector<PointField> split(const PointField& field) {
  std::vector<PointField> parts;
  const std::size_t size = num_bytes(field.type);
  for (std::size_t k = 0; k < field.count; ++k) {
    PointField part{fmt::format("{}_{}", field.name, k), field.type, 1, {}};
    part.values.reserve(field.num_rows() * size);
    for (std::size_t row = 0; row < field.num_rows(); ++row)
      part.values.append(field.values, row * field.row_bytes() + k * size, size);
    parts.push_back(std::move(part));
  }
  return parts;
}

bool is_wide(const PointField& field) { return field.type == ScalarType::Int64 || field.type == ScalarType::Uint64; }

// As double; digits beyond its 53 bits are named.
PointField as_double(const PointField& field, std::vector<std::string>& not_kept) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  PointField wide{field.name, ScalarType::Float64, field.count, {}};
  wide.values.reserve(field.values.size());
  bool is_rounded = false;
  for (std::size_t i = 0; i < field.num_rows() * field.count; ++i) {
    const double value = field.at(i / field.count, i % field.count);
    is_rounded = is_rounded || std::abs(value) > kExact;
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    wide.values.append(bytes, sizeof(value));
  }
  if (is_rounded)
    not_kept.push_back(fmt::format("the last digits of column '{}': PLY has no integers of 64 bits", field.name));
  return wide;
}

// Names are words, and each is there once. Positions and directions are the cloud's.
void make_names_unique(std::vector<PointField>& fields) {
  std::set<std::string> taken{"x",        "y",        "z",         "nx",        "ny",        "nz",       "normal_x",
                              "normal_y", "normal_z", "structure", "tangent_x", "tangent_y", "tangent_z"};
  for (PointField& field : fields) {
    std::replace_if(
        field.name.begin(), field.name.end(), [](char c) { return c <= ' ' || c > '~'; }, '_');
    if (field.name.empty()) field.name = "column";
    const std::string name = field.name;
    for (int i = 2; !taken.insert(lower_case(field.name)).second; ++i) field.name = fmt::format("{}_{}", name, i);
  }
}

// The packed field in place of the channels, if there are red, green and blue of 8 bits.
void pack_colours(std::vector<PointField>& fields) {
  std::array<const PointField*, 4> channels{};
  for (const PointField& field : fields)
    for (std::size_t i = 0; i < channels.size(); ++i)
      if (lower_case(field.name) == kChannels[i] && field.type == ScalarType::Uint8 && field.count == 1)
        channels[i] = &field;
  if (!channels[0] || !channels[1] || !channels[2]) return;
  const bool has_alpha = channels[3] != nullptr;
  PointField packed{has_alpha ? "rgba" : "rgb", has_alpha ? ScalarType::Uint32 : ScalarType::Float32, 1, {}};
  for (std::size_t row = 0; row < channels[0]->num_rows(); ++row) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < channels.size(); ++i)
      if (channels[i]) value |= std::uint32_t{static_cast<std::uint8_t>(channels[i]->values[row])} << kShifts[i];
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    packed.values.append(bytes, sizeof(value));
  }
  std::vector<PointField> others;
  for (PointField& field : fields)
    if (std::find(channels.begin(), channels.end(), &field) == channels.end()) others.push_back(std::move(field));
  others.push_back(std::move(packed));
  fields = std::move(others);
}

// A column a number, with colours in columns of their own.
std::vector<PointField> single_columns(std::vector<PointField> fields) {
  std::vector<PointField> single;
  for (PointField& field : fields) {
    if (!is_packed_colour(field) && field.count == 1) {
      single.push_back(std::move(field));
      continue;
    }
    for (PointField& part : is_packed_colour(field) ? unpacked(field) : split(field)) single.push_back(std::move(part));
  }
  return single;
}

}  // namespace

PointFields fields_of(const CloudFile& file) { return file.las ? fields_of(*file.las) : file.fields; }

PointFields without_empty_cells(const PointFields& fields, const IndexImage& grid) {
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < grid.index.size(); ++i)
    if (grid.index[i] != IndexImage::kNone) rows.push_back(static_cast<std::uint32_t>(i));
  return select(fields, rows);
}

PointFields fields_for_ply(PointFields fields) {
  fields.fields = single_columns(std::move(fields.fields));
  for (PointField& field : fields.fields)
    if (is_wide(field)) field = as_double(field, fields.not_kept);
  make_names_unique(fields.fields);
  return fields;
}

PointFields fields_for_las(PointFields fields) {
  fields.fields = single_columns(std::move(fields.fields));
  make_names_unique(fields.fields);
  return fields;
}

PointFields fields_for_pcd(PointFields fields) {
  pack_colours(fields.fields);
  make_names_unique(fields.fields);
  return fields;
}

}  // namespace augicp
