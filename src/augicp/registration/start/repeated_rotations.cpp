// SPDX-License-Identifier: MIT
#include "augicp/registration/start/repeated_rotations.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "augicp/core/median.h"

namespace augicp {
namespace {

constexpr int kNumAngles = 120;                // of 3 degrees
constexpr int kNumHeights = 8, kNumRadii = 8;  // rings about the axis
constexpr Eigen::Index kNumRings = Eigen::Index{kNumHeights} * kNumRadii;

// The least part of what varies about the axis that is found again, and by how many standard deviations that exceeds
// chance.
constexpr double kMinFoundAgain = 0.5, kMinDeviations = 4.0;

constexpr double kOutliers = 0.01;  // at most this part of the points lies beyond the bins

using Rings = Eigen::Array<double, Eigen::Dynamic, kNumAngles, Eigen::RowMajor>;  // number of points, a ring each row

struct Cylindrical {
  double height, radius, angle;  // angle: 0 to 2 pi
};

std::vector<Cylindrical> about(const Cloud& cloud, const RotationAxis& axis) {
  const Vec3d across = axis.direction.unitOrthogonal(), third = axis.direction.cross(across);
  std::vector<Cylindrical> points;
  points.reserve(cloud.size());
  for (const Vec3f& point : cloud.points) {
    const Vec3d from_axis = point.cast<double>() - axis.place;
    const double x = across.dot(from_axis), y = third.dot(from_axis);
    points.push_back({axis.direction.dot(from_axis), std::hypot(x, y), std::atan2(y, x) + std::numbers::pi});
  }
  return points;
}

// The two bins whose centres are nearest, and the second one's part of a point.
struct Share {
  int first, second;
  double of_second;
};
Share share_of(double place, double from, double to, int count) {
  const double part = to > from ? std::clamp((place - from) / (to - from), 0.0, 1.0) : 0.0, at = part * (count - 1);
  const int first = std::clamp(static_cast<int>(at), 0, count - 2);
  return {first, first + 1, at - first};
}
Share share_of_angle(double angle) {
  const double at = 0.5 * angle / std::numbers::pi * kNumAngles, first = std::floor(at);
  return {static_cast<int>(first) % kNumAngles, (static_cast<int>(first) + 1) % kNumAngles, at - first};
}

struct Counts {
  Rings rings = Rings::Zero(kNumRings, kNumAngles);
  double variance = 0.0;  // summed over bins, of points at random
};

// The value that this part of all is below.
double value_above(std::vector<double> values, double part) {
  const auto rank = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1));
  return value_at_rank(std::move(values), rank);
}

// Each point is shared by bins. So neither a face on a border of them nor a period between them matters. Outliers count
// in the outermost bins.
Counts counted_about(const std::vector<Cylindrical>& points) {
  std::vector<double> heights, radii;
  for (const Cylindrical& point : points) {
    heights.push_back(point.height);
    radii.push_back(point.radius);
  }
  const double low = value_above(heights, kOutliers), high = value_above(heights, 1.0 - kOutliers),
               wide = value_above(radii, 1.0 - kOutliers);
  Counts counts;
  for (const Cylindrical& point : points) {
    const Share height = share_of(point.height, low, high, kNumHeights),
                radius = share_of(point.radius, 0.0, wide, kNumRadii), angle = share_of_angle(point.angle);
    const auto add = [&](int h, int r, int a, double part) {
      counts.rings(h * kNumRadii + r, a) += part;
      counts.variance += part * part;
    };
    for (const auto& [h, of_h] : {std::pair{height.first, 1.0 - height.of_second}, {height.second, height.of_second}})
      for (const auto& [r, of_r] : {std::pair{radius.first, 1.0 - radius.of_second}, {radius.second, radius.of_second}})
        for (const auto& [a, of_a] : {std::pair{angle.first, 1.0 - angle.of_second}, {angle.second, angle.of_second}})
          add(h, r, a, of_h * of_r * of_a);
  }
  return counts;
}

// What varies about the axis: without each ring's mean, and without what has one period a ring. So a tilted axis shows,
// or one that is off the middle.
Rings variation(Rings rings) {
  rings.colwise() -= rings.rowwise().mean().eval();
  using Ring = Eigen::Matrix<double, 1, kNumAngles>;
  const Ring angles = Ring::LinSpaced(0.0, 2.0 * std::numbers::pi * (kNumAngles - 1) / kNumAngles);
  for (const Ring& wave : {Ring(angles.array().cos()), Ring(angles.array().sin())})
    rings.matrix() -= (2.0 / kNumAngles * rings.matrix() * wave.transpose()).eval() * wave;
  return rings;
}

// For each rotation by whole bins, up to half of them, the sum over bins of the product before and after.
std::vector<double> correlation(const Rings& rings) {
  std::vector<double> of_rotation;
  for (int bins = 0; bins <= kNumAngles / 2; ++bins)
    of_rotation.push_back((rings.rightCols(kNumAngles - bins) * rings.leftCols(kNumAngles - bins)).sum() +
                          (rings.leftCols(bins) * rings.rightCols(bins)).sum());
  return of_rotation;
}

}  // namespace

std::vector<RepeatedRotation> repeated_rotations(const Cloud& cloud, const RotationAxis& axis) {
  if (cloud.empty()) return {};
  const Counts counts = counted_about(about(cloud, axis));
  const std::vector<double> of_rotation = correlation(variation(counts.rings));
  // Evenly spread points vary less than points at random.
  const double varies = std::max(of_rotation.front() - counts.variance, 0.0);
  const double by_chance = std::sqrt(kNumAngles * counts.rings.rowwise().mean().square().sum());
  std::vector<RepeatedRotation> rotations;
  for (int k = 1; k <= kNumAngles / 2; ++k) {
    const double here = of_rotation[k], before = of_rotation[k - 1],
                 after = of_rotation[k < kNumAngles / 2 ? k + 1 : k - 1];
    if (here < before || here < after) continue;
    if (here < kMinFoundAgain * varies || here < kMinDeviations * by_chance) continue;
    rotations.push_back({2.0 * std::numbers::pi * k / kNumAngles, here / of_rotation.front()});
  }
  std::sort(rotations.begin(), rotations.end(), [](const RepeatedRotation& a, const RepeatedRotation& b) {
    return a.resemblance != b.resemblance ? a.resemblance > b.resemblance : a.angle < b.angle;
  });
  return rotations;
}

}  // namespace augicp
