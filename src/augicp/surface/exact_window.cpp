// SPDX-License-Identifier: MIT
#include "augicp/core/parallel.h"
#include "augicp/surface/arms.h"
#include "augicp/surface/blocks.h"
#include "augicp/surface/window_neighbourhood.h"

namespace augicp {
namespace {

// The ray of a row that is nearest to the centre is not exactly the one in the centre's column.
constexpr double kSlack = 1.5;

// The run of each point within its row and within its column.
struct Runs {
  std::vector<std::int32_t> in_row, in_column;
};

Runs find_runs(const Cloud& cloud, const IndexImage& index, double max_step_per_depth) {
  Runs runs{std::vector<std::int32_t>(cloud.size()), std::vector<std::int32_t>(cloud.size())};
  for (bool along_rows : {true, false}) {
    for (int which = 0; which < (along_rows ? index.height : index.width); ++which) {
      const Line line = image_line(cloud, index, along_rows, which, max_step_per_depth);
      for (std::size_t k = 0; k < line.point.size(); ++k)
        (along_rows ? runs.in_row : runs.in_column)[line.point[k]] = line.run[k];
    }
  }
  return runs;
}

// The distance from the centre to the ray of a point. It grows with the pixel distance, so a search that moves away
// from the centre may stop once it exceeds the ball.
double distance_to_ray(const Vec3f& centre, const Vec3f& seen) {
  return static_cast<double>(centre.cross(seen.normalized()).norm());
}

// Appends the points of row v in the ball around centre, from column u in both directions within the run of (u, v).
void collect_row(const Cloud& cloud, const IndexImage& index, const Runs& runs, int u, int v, const Vec3f& centre,
                 double radius, std::vector<std::uint32_t>& found) {
  const std::int32_t run = runs.in_row[index.at(u, v)];
  const auto walk = [&](int start, int step) {
    for (int k = start; k >= 0 && k < index.width; k += step) {
      const std::int32_t i = index.at(k, v);
      if (i == IndexImage::kNone) continue;
      if (runs.in_row[i] != run || distance_to_ray(centre, cloud.points[i]) > kSlack * radius) return;
      if (static_cast<double>((cloud.points[i] - centre).norm()) <= radius)
        found.push_back(static_cast<std::uint32_t>(i));
    }
  };
  walk(u, 1);
  walk(u - 1, -1);
}

void collect(const Cloud& cloud, const IndexImage& index, const Runs& runs, int u, int v, double radius,
             std::vector<std::uint32_t>& found) {
  const std::int32_t centre = index.at(u, v);
  const auto walk = [&](int start, int step) {
    for (int k = start; k >= 0 && k < index.height; k += step) {
      const std::int32_t i = index.at(u, k);
      if (i == IndexImage::kNone) continue;
      if (runs.in_column[i] != runs.in_column[centre]) return;
      if (distance_to_ray(cloud.points[centre], cloud.points[i]) > kSlack * radius) return;
      collect_row(cloud, index, runs, u, k, cloud.points[centre], radius, found);
    }
  };
  walk(v, 1);
  walk(v - 1, -1);
}

}  // namespace

ExactWindowNeighbourhood::ExactWindowNeighbourhood(const Cloud& cloud, const IndexImage& index,
                                                   const WindowOptions& options, int num_threads)
    : neighbours_(cloud.size()) {
  check(options);
  const Runs runs = find_runs(cloud, index, options.max_step_per_depth);
  for_each_block(
      index.index.size(), num_threads,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
          const std::int32_t centre = index.index[pixel];
          if (centre == IndexImage::kNone) continue;
          const int u = static_cast<int>(pixel) % index.width, v = static_cast<int>(pixel) / index.width;
          collect(cloud, index, runs, u, v, ball_radius(cloud.points[centre].z(), options), neighbours_[centre]);
        }
      },
      kPointsPerBlock);
}

Channels ExactWindowNeighbourhood::sum(const Channels& values, int num_threads) const {
  Channels sums = Channels::Zero(values.rows(), values.cols());
  for_each_block(neighbours_.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::uint32_t k : neighbours_[i]) sums.col(static_cast<Eigen::Index>(i)) += values.col(k);
  });
  return sums;
}

}  // namespace augicp
