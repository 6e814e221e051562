// SPDX-License-Identifier: MIT
#include "augicp/surface/noise.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/check.h"
#include "augicp/core/median.h"
#include "augicp/core/parallel.h"
#include "augicp/search/kd_tree.h"
#include "augicp/surface/shape.h"

namespace augicp {
namespace {

// Neighbours come from this many points of the cloud, taken evenly: as they are, not averaged, so that they keep their
// noise, and far enough apart for a plane to be wider than its noise.
constexpr std::size_t kNumPoints = 32768;
constexpr std::size_t kNumAsked = 2048;

// Neighbours of a point: the fewest that are spread in two directions and wider than thick. A single scan line, or a
// patch smaller than its noise, shows no plane.
constexpr std::size_t kFewest = 24, kMost = 384;
constexpr double kMinSpreadRatio = 0.1;  // of the eigenvalues l1 / l2
constexpr double kMaxThickness = 0.1;    // l0 / l1

// Rays that graze the surface: their noise lies almost along it.
constexpr double kMinCosine = 0.4;

// The median of a chi-squared variable per degree of freedom (Wilson and Hilferty).
double median_chi2(double dof) { return std::pow(1.0 - 2.0 / (9.0 * dof), 3.0); }

Gaussian gaussian_of(const Cloud& cloud, const std::vector<Neighbour>& neighbours, std::size_t count, const Vec3f& at) {
  Gaussian gaussian;
  gaussian.count = static_cast<double>(count);
  Mat3d outer = Mat3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3d offset = (cloud.points[neighbours[k].index] - at).cast<double>();
    gaussian.mean += offset / gaussian.count;
    outer += offset * offset.transpose() / gaussian.count;
  }
  gaussian.covariance = outer - gaussian.mean * gaussian.mean.transpose();
  return gaussian;
}

struct PointNoise {
  double variance = 0.0;      // along the line of sight, m^2; across the surface where the sensor's place is unknown
  double range = 0.0;         // metres
  double direction_sq = 0.0;  // of the normal, rad^2
};

std::optional<PointNoise> noise_of(const Cloud& cloud, const Gaussian& points, const Eigen3& eigen, const Vec3f& at,
                                   double widening) {
  const double dof = points.count - 3.0;
  const double across = eigen.values[0] * points.count / (dof * median_chi2(dof));
  PointNoise noise{across, 0.0, across / (points.count * eigen.values[1]) * widening};
  if (!cloud.viewpoint) return noise;
  const Vec3d ray = (at - *cloud.viewpoint).cast<double>();
  const double cosine = std::abs(ray.normalized().dot(eigen.vectors.col(0)));
  if (!(cosine > kMinCosine)) return std::nullopt;
  noise.range = ray.norm();
  noise.variance /= cosine * cosine;
  return noise;
}

// Of the plane around one point. A normal's variance falls with the fourth power of the ball's radius: with the number
// of points, and with their spread.
std::optional<PointNoise> noise_at(const Cloud& cloud, const KdTree& tree, const Vec3f& at, double radius) {
  const std::vector<Neighbour> neighbours = tree.nearest_k(at, kMost);
  for (std::size_t count = kFewest; count <= neighbours.size(); count *= 2) {
    const Gaussian points = gaussian_of(cloud, neighbours, count, at);
    const Eigen3 eigen = eigen_of_symmetric(points.covariance);
    const Vec3d& l = eigen.values;
    if (l[1] < kMinSpreadRatio * l[2] || !(l[0] < kMaxThickness * l[1])) continue;
    const double reach_sq = static_cast<double>(neighbours[count - 1].distance_sq);
    return noise_of(cloud, points, eigen, at, reach_sq * reach_sq / std::pow(radius, 4.0));
  }
  return std::nullopt;
}

double median_of(const std::vector<PointNoise>& measured, double PointNoise::*member) {
  std::vector<float> values;
  for (const PointNoise& noise : measured) values.push_back(static_cast<float>(noise.*member));
  return median(values);
}

// Both parts of the range noise, from the medians of the nearer and the farther half of the points.
void fit_range_noise(std::vector<PointNoise> measured, ScanNoise& noise) {
  const auto middle = measured.begin() + static_cast<std::ptrdiff_t>(measured.size() / 2);
  std::nth_element(measured.begin(), middle, measured.end(),
                   [](const PointNoise& a, const PointNoise& b) { return a.range < b.range; });
  const std::vector<PointNoise> near(measured.begin(), middle), far(middle, measured.end());
  const auto of = [](const std::vector<PointNoise>& half) {
    return std::pair{std::pow(median_of(half, &PointNoise::range), 4.0), median_of(half, &PointNoise::variance)};
  };
  const auto [near_range_4, near_variance] = of(near);
  const auto [far_range_4, far_variance] = of(far);
  const double grown = std::max(0.0, far_variance - near_variance), spread = far_range_4 - near_range_4;
  // Neither part may be negative.
  const double steepest = near_range_4 > 0.0 ? near_variance / near_range_4 : 0.0;
  const double slope = spread > 0.0 ? std::min(grown / spread, steepest) : 0.0;
  noise.per_m2 = std::sqrt(slope);
  noise.constant = std::sqrt(
      std::max(0.0, slope > 0.0 ? near_variance - slope * near_range_4 : median_of(measured, &PointNoise::variance)));
}

}  // namespace

// Not by std::hypot, which rounds differently from one C library to the next.
double ScanNoise::range_sigma(double range) const {
  const double growing = per_m2 * range * range;
  return std::sqrt(constant * constant + growing * growing);
}

ScanNoise measured_noise(const Cloud& cloud, double radius, int num_threads) {
  require_positive("radius", radius);
  const Cloud points = evenly_chosen(cloud, kNumPoints), asked = evenly_chosen(cloud, kNumAsked);
  if (points.size() < kFewest) return {};
  const KdTree tree(points);
  std::vector<std::optional<PointNoise>> at(asked.size());
  for_each_block(asked.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) at[i] = noise_at(points, tree, asked.points[i], radius);
  });
  std::vector<PointNoise> measured;
  for (const auto& noise : at)
    if (noise) measured.push_back(*noise);
  ScanNoise noise;
  noise.num_measured = measured.size();
  if (measured.size() < 2) return {};
  // The neighbours were thinned: the ball of the whole cloud holds as many more points.
  const double thinning = static_cast<double>(points.size()) / static_cast<double>(cloud.size());
  noise.direction = std::sqrt(thinning * median_of(measured, &PointNoise::direction_sq));
  fit_range_noise(std::move(measured), noise);
  return noise;
}

}  // namespace augicp
