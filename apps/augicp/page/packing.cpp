// SPDX-License-Identifier: MIT
#include "apps/augicp/page/packing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "apps/augicp/page/base64.h"
#include "apps/augicp/page/deflate.h"

namespace augicp::app {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(float) == 4);

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t kChunk = 1024;  // points that share a step
constexpr float kSteps = 65535.0f;
constexpr std::size_t kMaxSamples = 20000;

template <typename Value>
void put(Bytes& bytes, const Value& value) {
  const auto raw = std::bit_cast<std::array<std::uint8_t, sizeof(Value)>>(value);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

void put_planes(Bytes& bytes, const std::vector<std::uint16_t>& values) {
  for (const std::uint16_t value : values) bytes.push_back(static_cast<std::uint8_t>(value & 255));
  for (const std::uint16_t value : values) bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

std::string in_base64(const Bytes& bytes) { return base64(deflated(bytes)); }

// The longest side of a box around 98 of 100 points along each axis.
float usual_extent(std::span<const Vec3f> points) {
  float extent = 0.0f;
  const std::size_t stride = points.size() / kMaxSamples + 1;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (std::size_t i = 0; i < points.size(); i += stride) values.push_back(points[i][axis]);
    std::sort(values.begin(), values.end());
    const std::size_t strays = values.size() / 100;
    if (!values.empty()) extent = std::max(extent, values[values.size() - 1 - strays] - values[strays]);
  }
  return extent;
}

struct Chunk {
  Vec3f least = Vec3f::Zero();
  float step = 1.0f;
};

Chunk chunk_of(std::span<const Vec3f> points, float usual_step) {
  Vec3f least = points.front(), most = points.front();
  for (const Vec3f& point : points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  const float needed = (most - least).maxCoeff() / kSteps;
  const float step = std::max(usual_step, needed);
  return {least, step > 0.0f && std::isfinite(step) ? step : 1.0f};
}

std::int8_t in_127ths(float value) {
  return static_cast<std::int8_t>(std::lround(127.0f * std::clamp(value, -1.0f, 1.0f)));
}

// The lower half of the octahedron is folded over the upper one's edges.
std::array<std::int8_t, 2> on_octahedron(const Vec3f& direction) {
  const float sum = direction.cwiseAbs().sum();
  if (!(sum > 0.0f) || !std::isfinite(sum)) return {0, 0};
  const Vec3f on = direction / sum;
  const auto fold = [&](float own, float other) { return std::copysign(1.0f - std::abs(other), own); };
  std::array<std::int8_t, 2> place = on.z() < 0.0f
                                         ? std::array{in_127ths(fold(on.x(), on.y())), in_127ths(fold(on.y(), on.x()))}
                                         : std::array{in_127ths(on.x()), in_127ths(on.y())};
  if (place[0] == 0 && place[1] == 0) place[0] = 1;  // zeros are for zero
  return place;
}

}  // namespace

std::string packed_points(std::span<const Vec3f> points) {
  Bytes bytes;
  put(bytes, static_cast<std::uint32_t>(points.size()));
  const float usual_step = usual_extent(points) / kSteps;
  std::array<std::vector<std::uint16_t>, 3> axes;
  for (std::size_t begin = 0; begin < points.size(); begin += kChunk) {
    const auto part = points.subspan(begin, std::min(kChunk, points.size() - begin));
    const Chunk chunk = chunk_of(part, usual_step);
    for (const float value : {chunk.least.x(), chunk.least.y(), chunk.least.z(), chunk.step}) put(bytes, value);
    std::array<std::uint16_t, 3> before{};
    for (const Vec3f& point : part)
      for (std::size_t k = 0; k < 3; ++k) {
        const float steps = (point[static_cast<int>(k)] - chunk.least[static_cast<int>(k)]) / chunk.step;
        const auto value = static_cast<std::uint16_t>(std::clamp(std::round(steps), 0.0f, kSteps));
        axes[k].push_back(static_cast<std::uint16_t>(value - before[k]));
        before[k] = value;
      }
  }
  for (const std::vector<std::uint16_t>& axis : axes) put_planes(bytes, axis);
  return in_base64(bytes);
}

std::string packed_numbers(std::span<const float> values) {
  constexpr float kMost = 32767.0f;
  constexpr std::uint16_t kNone = 0x8000;
  float largest = 0.0f;
  for (const float value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  Bytes bytes;
  put(bytes, largest);
  std::vector<std::uint16_t> shares;
  for (const float value : values) {
    const bool is_number = std::isfinite(value);
    const float share = is_number && largest > 0.0f ? std::round(kMost * (value / largest)) : 0.0f;
    shares.push_back(is_number ? static_cast<std::uint16_t>(static_cast<std::int16_t>(share)) : kNone);
  }
  put_planes(bytes, shares);
  return in_base64(bytes);
}

std::string packed_directions(std::span<const Vec3f> directions) {
  Bytes first, second;
  for (const Vec3f& direction : directions) {
    const auto place = on_octahedron(direction);
    first.push_back(static_cast<std::uint8_t>(place[0]));
    second.push_back(static_cast<std::uint8_t>(place[1]));
  }
  first.insert(first.end(), second.begin(), second.end());
  return in_base64(first);
}

std::string packed_bytes(std::span<const std::uint8_t> bytes) { return in_base64({bytes.begin(), bytes.end()}); }

}  // namespace augicp::app
