// SPDX-License-Identifier: MIT
#include "augicp/io/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "augicp/io/field_layout.h"

namespace augicp {
namespace {

constexpr double kLargestByte = 255.0, kLargestOf16Bits = 65535.0;

bool is_colour(const PointField& field) {
  constexpr std::array kNames{"red", "green", "blue", "rgb", "rgba"};
  const std::string name = lower_case(field.name);
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

// The colour columns alone, a row each point, each channel in a column of its own.
PointFields channels_of(const CloudFile& file) {
  PointFields fields = fields_of(file);
  std::erase_if(fields.fields, [](const PointField& field) { return !is_colour(field); });
  if (file.grid) fields = without_empty_cells(fields, *file.grid);
  return fields_for_las(std::move(fields));
}

double largest_of(std::size_t count, const std::function<double(std::size_t, std::size_t)>& channel) {
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) largest = std::fmax(largest, channel(i, k));  // NaN is passed over
  return largest;
}

std::uint8_t byte_of(double share) {
  const double byte = std::round(kLargestByte * share);
  return byte > 0.0 ? static_cast<std::uint8_t>(std::min(byte, kLargestByte)) : std::uint8_t{0};  // NaN fails
}

}  // namespace

std::vector<Colour> colours_from(std::size_t count, bool is_floating,
                                 const std::function<double(std::size_t, std::size_t)>& channel) {
  const double largest = largest_of(count, channel);
  const double one = is_floating && largest <= 1.0 ? 1.0 : largest <= kLargestByte ? kLargestByte : kLargestOf16Bits;
  std::vector<Colour> colours(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) colours[i][k] = byte_of(channel(i, k) / one);
  return colours;
}

std::vector<Colour> colours_of(const CloudFile& file) {
  const PointFields fields = channels_of(file);
  const std::array channels{fields.find("red"), fields.find("green"), fields.find("blue")};
  for (const PointField* channel : channels)
    if (!channel || channel->num_rows() != file.cloud.size()) return {};
  return colours_from(file.cloud.size(), is_floating(channels[0]->type),
                      [&](std::size_t i, std::size_t k) { return channels[k]->at(i); });
}

}  // namespace augicp
