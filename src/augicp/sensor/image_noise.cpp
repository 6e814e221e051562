// SPDX-License-Identifier: MIT
#include "augicp/sensor/image_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "augicp/core/median.h"

namespace augicp {
namespace {

// A few thousand triples tell a median to a few per cent.
constexpr std::size_t kNumTriples = 8192;

// Of the absolute value of a normal variable, and of a - 2 b + c, in standard deviations.
constexpr double kMedianAbsolute = 0.6745;
const double kOfTriple = std::sqrt(6.0);

}  // namespace

double noise_per_depth_sq(const Scan& image) {
  const IndexImage& index = image.view->index;
  const auto depth_at = [&](std::int32_t point) { return image.cloud.points[static_cast<std::size_t>(point)].z(); };
  const auto width = static_cast<std::size_t>(index.width);
  const std::size_t step = 1 + index.index.size() / kNumTriples;
  std::vector<float> deviations;
  for (std::size_t pixel = 0; pixel + 2 < index.index.size(); pixel += step) {
    if (pixel % width + 2 >= width) continue;
    const std::int32_t a = index.index[pixel], b = index.index[pixel + 1], c = index.index[pixel + 2];
    if ((a | b | c) < 0) continue;  // kNone is negative
    const float depth = depth_at(b);
    deviations.push_back(std::abs(depth_at(a) - 2.0f * depth + depth_at(c)) / (depth * depth));
  }
  return deviations.empty() ? 0.0 : upper_median(std::move(deviations)) / (kMedianAbsolute * kOfTriple);
}

}  // namespace augicp
