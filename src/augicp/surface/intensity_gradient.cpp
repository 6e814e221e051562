// SPDX-License-Identifier: MIT
#include "augicp/surface/intensity_gradient.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/search/kd_tree.h"

namespace augicp {
namespace {

constexpr std::size_t kNumNeighbours = 20;  // the point itself among them
constexpr std::size_t kMinNeighbours = 6;   // a slope and its height are three numbers; as many again tell how well it fits
constexpr std::size_t kPointsPerBlock = 256;

// A slope counts where each of its two numbers explains so many times the variance of what is left. Even noise passes in about
// one case in a thousand (the F distribution's percentile for 2 and 17 degrees of freedom); with one in a hundred, whose slopes are
// by their choice the steepest, the noise of a bare wall would hold it.
constexpr double kMinSignificance = 10.7;

// Points whose spread across is less than this part of that along lie on a line.
constexpr double kMinSpread = 0.05;

using Matrix2 = Eigen::Matrix2d;
using Vector2 = Eigen::Vector2d;

// Sums of the neighbours' places in the tangent plane and of their intensities, relative to the point's own.
struct Moments {
  double count = 0.0, value = 0.0, value_sq = 0.0;
  Vector2 place = Vector2::Zero(), place_value = Vector2::Zero();
  Matrix2 place_sq = Matrix2::Zero();

  void add(const Vector2& u, double v) {
    count += 1.0;
    value += v;
    value_sq += v * v;
    place += u;
    place_value += u * v;
    place_sq += u * u.transpose();
  }
};

Vector2 significant_slope(const Moments& m) {
  const Matrix2 spread = m.place_sq - m.place * m.place.transpose() / m.count;
  const Vector2 joint = m.place_value - m.place * (m.value / m.count);
  const Eigen::SelfAdjointEigenSolver<Matrix2> solver(spread);
  const Vector2 along = solver.eigenvalues();
  if (!(along[0] > kMinSpread * kMinSpread * along[1])) return Vector2::Zero();
  const Vector2 slope = spread.inverse() * joint;
  const double total = m.value_sq - m.value * m.value / m.count, explained = slope.dot(joint);
  const double left = std::max(0.0, total - explained);
  const bool stands_out = explained / 2.0 > kMinSignificance * left / (m.count - 3.0);
  return stands_out ? slope : Vector2::Zero();
}

class Estimator {
 public:
  Estimator(const Cloud& cloud, double radius)
      : cloud_(cloud), tree_(cloud), radius_sq_(static_cast<float>(radius * radius)) {}

  Vec3f gradient(std::size_t i) const {
    const auto here = static_cast<double>(cloud_.intensities[i]);
    if (cloud_.structures[i] != Structure::Planar || std::isnan(here)) return Vec3f::Zero();
    const Vec3d normal = cloud_.directions[i].cast<double>();
    const Vec3d first = normal.unitOrthogonal(), second = normal.cross(first);
    Moments moments;
    for (const Neighbour& near : tree_.nearest_k(cloud_.points[i], kNumNeighbours)) {
      const auto there = static_cast<double>(cloud_.intensities[near.index]);
      if (near.distance_sq >= radius_sq_ || std::isnan(there)) continue;
      const Vec3d apart = (cloud_.points[near.index] - cloud_.points[i]).cast<double>();
      moments.add({apart.dot(first), apart.dot(second)}, there - here);
    }
    if (moments.count < static_cast<double>(kMinNeighbours)) return Vec3f::Zero();
    const Vector2 slope = significant_slope(moments);
    return (slope[0] * first + slope[1] * second).cast<float>();
  }

 private:
  const Cloud& cloud_;
  KdTree tree_;
  float radius_sq_;
};

}  // namespace

void estimate_intensity_gradients(Cloud& cloud, double radius, int num_threads) {
  require_positive("radius", radius);
  if (!cloud.empty() && !(cloud.has_intensities() && cloud.has_directions()))
    throw std::invalid_argument("cloud: must have intensities and directions");
  cloud.intensity_gradients.assign(cloud.size(), Vec3f::Zero());
  if (cloud.empty()) return;
  const Estimator estimator(cloud, radius);
  const auto estimate = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) cloud.intensity_gradients[i] = estimator.gradient(i);
  };
  for_each_block(cloud.size(), num_threads, estimate, kPointsPerBlock);
}

}  // namespace augicp
