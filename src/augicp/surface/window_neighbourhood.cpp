// SPDX-License-Identifier: MIT
#include "augicp/surface/window_neighbourhood.h"

#include "augicp/core/parallel.h"
#include "augicp/surface/arms.h"

namespace augicp {
namespace {

constexpr std::size_t kLinesPerBlock = 8;

std::vector<double> half_sides(const Cloud& cloud, const WindowOptions& options) {
  std::vector<double> sides(cloud.size());
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = kSquareHalfSide * ball_radius(cloud.points[i].z(), options);
  return sides;
}

// result(:, i) = prefix[last] - prefix[first - 1] along every row or column of the image.
void sum_along(const IndexImage& index, const std::vector<Arms>& arms, bool along_rows, const Channels& values,
               Channels& sums, int num_threads) {
  const int num_lines = along_rows ? index.height : index.width, length = along_rows ? index.width : index.height;
  for_each_block(
      static_cast<std::size_t>(num_lines), num_threads,
      [&](std::size_t begin, std::size_t end) {
        Channels prefix(values.rows(), length + 1);
        for (int which = static_cast<int>(begin); which < static_cast<int>(end); ++which) {
          prefix.col(0).setZero();
          const auto point_at = [&](int k) { return along_rows ? index.at(k, which) : index.at(which, k); };
          for (int k = 0; k < length; ++k) {
            prefix.col(k + 1) = prefix.col(k);
            if (point_at(k) != IndexImage::kNone) prefix.col(k + 1) += values.col(point_at(k));
          }
          for (int k = 0; k < length; ++k) {
            const std::int32_t i = point_at(k);
            if (i == IndexImage::kNone) continue;
            const int before = along_rows ? arms[i].left : arms[i].up,
                      after = along_rows ? arms[i].right : arms[i].down;
            sums.col(i) = prefix.col(k + after + 1) - prefix.col(k - before);
          }
        }
      },
      kLinesPerBlock);
}

}  // namespace

WindowNeighbourhood::WindowNeighbourhood(const Cloud& cloud, const IndexImage& index, const WindowOptions& options,
                                         int num_threads)
    : index_(index), arms_(cloud.size()) {
  check(options);
  const std::vector<double> sides = half_sides(cloud, options);
  for (bool along_rows : {true, false}) {
    for_each_block(
        static_cast<std::size_t>(along_rows ? index.height : index.width), num_threads,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t which = begin; which < end; ++which) {
            const Line line = image_line(cloud, index, along_rows, static_cast<int>(which), options.max_step_per_depth);
            const Reach reach = reach_along(line, cloud, sides);
            for (std::size_t i = 0; i < line.point.size(); ++i) {
              Arms& arms = arms_[line.point[i]];
              (along_rows ? arms.left : arms.up) =
                  static_cast<std::int16_t>(line.position[i] - line.position[reach.first[i]]);
              (along_rows ? arms.right : arms.down) =
                  static_cast<std::int16_t>(line.position[reach.last[i]] - line.position[i]);
            }
          }
        },
        kLinesPerBlock);
  }
}

Channels WindowNeighbourhood::sum(const Channels& values, int num_threads) const {
  Channels over_rows(values.rows(), values.cols()), sums(values.rows(), values.cols());
  sum_along(index_, arms_, true, values, over_rows, num_threads);
  sum_along(index_, arms_, false, over_rows, sums, num_threads);
  return sums;
}

}  // namespace augicp
