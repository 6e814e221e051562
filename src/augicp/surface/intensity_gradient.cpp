// SPDX-License-Identifier: MIT
#include "augicp/surface/intensity_gradient.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/search/kd_tree.h"
#include "augicp/surface/blocks.h"

namespace augicp {
namespace {

constexpr std::size_t kNumNeighbours = 20;  // including the point itself
constexpr std::size_t kMinNeighbours =
    6;                          // a slope and its height are three numbers; three more show how well they fit
constexpr int kHalfWindow = 2;  // images: a window of 25 pixels

// A slope counts if each of its two numbers explains this many times the residual variance. Noise passes in about one
// case in a thousand (the percentile of the F distribution with 2 and 17 degrees of freedom). Those that pass are the
// steepest, so few may pass.
constexpr double kMinSignificance = 10.7;

// Points lie on a line if their spread across it is below this share of that along it.
constexpr double kMinSpread = 0.05;

using Matrix2 = Eigen::Matrix2d;
using Vector2 = Eigen::Vector2d;

// Sums of the neighbours' positions in the tangent plane and of their intensities, relative to the point's own.
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
  Estimator(const Cloud& cloud, double radius) : cloud_(cloud), radius_sq_(radius * radius) {}

  // near: indices of the points around the point.
  Vec3f gradient(std::size_t i, std::span<const std::uint32_t> near) const {
    const auto here = static_cast<double>(cloud_.intensities[i]);
    if (cloud_.structures[i] != Structure::Planar || std::isnan(here)) return Vec3f::Zero();
    const Vec3d normal = cloud_.directions[i].cast<double>();
    const Vec3d first = normal.unitOrthogonal(), second = normal.cross(first);
    Moments moments;
    for (const std::uint32_t k : near) {
      const auto there = static_cast<double>(cloud_.intensities[k]);
      const Vec3d apart = (cloud_.points[k] - cloud_.points[i]).cast<double>();
      if (!(apart.squaredNorm() < radius_sq_) || std::isnan(there)) continue;
      moments.add({apart.dot(first), apart.dot(second)}, there - here);
    }
    if (moments.count < static_cast<double>(kMinNeighbours)) return Vec3f::Zero();
    const Vector2 slope = significant_slope(moments);
    return (slope[0] * first + slope[1] * second).cast<float>();
  }

 private:
  const Cloud& cloud_;
  double radius_sq_;
};

// Throws std::invalid_argument if the cloud lacks the inputs. Returns false for an empty cloud.
bool begin_estimate(Cloud& cloud, double radius) {
  require_positive("radius", radius);
  if (!cloud.empty() && !(cloud.has_intensities() && cloud.has_directions()))
    throw std::invalid_argument("cloud: must have intensities and directions");
  cloud.intensity_gradients.assign(cloud.size(), Vec3f::Zero());
  return !cloud.empty();
}

// Finds the points in the window around a pixel.
void find_in_window(const IndexImage& seen, int u, int v, std::vector<std::uint32_t>& near) {
  near.clear();
  for (int row = std::max(0, v - kHalfWindow); row <= std::min(seen.height - 1, v + kHalfWindow); ++row)
    for (int column = std::max(0, u - kHalfWindow); column <= std::min(seen.width - 1, u + kHalfWindow); ++column)
      if (const std::int32_t k = seen.at(column, row); k != IndexImage::kNone)
        near.push_back(static_cast<std::uint32_t>(k));
}

}  // namespace

void estimate_intensity_gradients(Cloud& cloud, double radius, int num_threads) {
  if (!begin_estimate(cloud, radius)) return;
  const Estimator estimator(cloud, radius);
  const KdTree tree(cloud);
  const auto estimate = [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> near;
    for (std::size_t i = begin; i < end; ++i) {
      near.clear();
      for (const Neighbour& found : tree.nearest_k(cloud.points[i], kNumNeighbours)) near.push_back(found.index);
      cloud.intensity_gradients[i] = estimator.gradient(i, near);
    }
  };
  for_each_block(cloud.size(), num_threads, estimate, kPointsPerBlock);
}

void estimate_intensity_gradients(Cloud& cloud, const IndexImage& seen, double radius, int num_threads) {
  if (!begin_estimate(cloud, radius)) return;
  const Estimator estimator(cloud, radius);
  const auto estimate_rows = [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> near;
    for (int v = static_cast<int>(begin); v < static_cast<int>(end); ++v)
      for (int u = 0; u < seen.width; ++u) {
        const std::int32_t i = seen.at(u, v);
        if (i == IndexImage::kNone || cloud.structures[i] != Structure::Planar) continue;
        find_in_window(seen, u, v, near);
        cloud.intensity_gradients[i] = estimator.gradient(static_cast<std::size_t>(i), near);
      }
  };
  for_each_block(static_cast<std::size_t>(seen.height), num_threads, estimate_rows, kRowsPerBlock);
}

}  // namespace augicp
