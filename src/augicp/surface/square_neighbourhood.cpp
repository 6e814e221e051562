// SPDX-License-Identifier: MIT
#include "augicp/surface/square_neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/surface/arms.h"
#include "augicp/surface/blocks.h"

namespace augicp {
namespace {

// Column (v * (width + 1) + u) is the sum over the pixels above and left of (u, v).
Channels integral_image(const IndexImage& index, const Channels& values) {
  const Eigen::Index stride = index.width + 1;
  Channels integral = Channels::Zero(values.rows(), stride * (index.height + 1));
  for (int v = 0; v < index.height; ++v) {
    Eigen::ArrayXd row = Eigen::ArrayXd::Zero(values.rows());
    for (int u = 0; u < index.width; ++u) {
      if (index.at(u, v) != IndexImage::kNone) row += values.col(index.at(u, v));
      integral.col((v + 1) * stride + u + 1) = integral.col(v * stride + u + 1) + row;
    }
  }
  return integral;
}

}  // namespace

SquareNeighbourhood::SquareNeighbourhood(const Cloud& cloud, const IndexImage& index, const WindowOptions& options,
                                         double focal_length)
    : index_(index), half_side_px_(cloud.size()) {
  check(options);
  require_positive("focal_length", focal_length);
  const double largest = std::max(index.width, index.height);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double depth = static_cast<double>(cloud.points[i].z());
    const double side = kSquareHalfSide * ball_radius(cloud.points[i].z(), options) * focal_length / depth;
    half_side_px_[i] = static_cast<std::int32_t>(std::lround(std::clamp(side, 1.0, largest)));
  }
}

Channels SquareNeighbourhood::sum(const Channels& values, int num_threads) const {
  const Channels integral = integral_image(index_, values);
  Channels sums(values.rows(), values.cols());
  const auto at = [&](int u, int v) { return integral.col(Eigen::Index{v} * (index_.width + 1) + u); };
  for_each_block(
      static_cast<std::size_t>(index_.height), num_threads,
      [&](std::size_t begin, std::size_t end) {
        for (int v = static_cast<int>(begin); v < static_cast<int>(end); ++v)
          for (int u = 0; u < index_.width; ++u) {
            const std::int32_t i = index_.at(u, v);
            if (i == IndexImage::kNone) continue;
            const int half = half_side_px_[i];
            const int left = std::max(u - half, 0), right = std::min(u + half + 1, index_.width);
            const int top = std::max(v - half, 0), bottom = std::min(v + half + 1, index_.height);
            sums.col(i) = at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
          }
      },
      kRowsPerBlock);
  return sums;
}

}  // namespace augicp
