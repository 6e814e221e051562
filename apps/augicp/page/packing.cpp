// SPDX-License-Identifier: MIT
#include "apps/augicp/page/packing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "apps/augicp/page/base64.h"

namespace augicp::app {
namespace {

std::int8_t in_127ths(float value) {
  return static_cast<std::int8_t>(std::lround(127.0f * std::clamp(std::isnan(value) ? 0.0f : value, -1.0f, 1.0f)));
}

}  // namespace

std::string packed_points(std::span<const Vec3f> points) {
  static_assert(std::endian::native == std::endian::little && sizeof(Vec3f) == 12);
  return base64(std::as_bytes(points));
}

std::string packed_directions(std::span<const Vec3f> directions) {
  std::vector<std::int8_t> values;
  values.reserve(3 * directions.size());
  for (const Vec3f& direction : directions)
    for (const float value : direction) values.push_back(in_127ths(value));
  return base64(std::as_bytes(std::span(values)));
}

std::string packed_bytes(std::span<const std::uint8_t> bytes) { return base64(std::as_bytes(bytes)); }

}  // namespace augicp::app
