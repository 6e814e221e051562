// SPDX-License-Identifier: MIT
#include "augicp/surface/estimate_surface.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "augicp/core/parallel.h"
#include "augicp/surface/eigen_batch.h"
#include "augicp/surface/moments.h"

namespace augicp {
namespace {

// Collects matrices, at most kEigenBatch, and solves them at once.
class Solver {
 public:
  void add(const Mat3d& matrix) { matrices_[count_++] = matrix; }
  std::span<const Eigen3> solved() {
    eigen_of_symmetric(std::span(matrices_).first(count_), solved_);
    return std::span(solved_).first(std::exchange(count_, 0));
  }

 private:
  std::array<Mat3d, kEigenBatch> matrices_;
  std::array<Eigen3, kEigenBatch> solved_;
  std::size_t count_ = 0;
};

// A unit vector from the sensor to the point; zero if the position of the sensor is unknown.
Vec3d line_of_sight(const Cloud& cloud, std::size_t i) {
  if (!cloud.viewpoint) return Vec3d::Zero();
  return (cloud.points[i] - *cloud.viewpoint).cast<double>().stableNormalized();
}

// Adds the weight and the weighted outer product of a direction; its sign does not matter.
void add_direction(const Vec3d& direction, double weight, Eigen::Ref<Eigen::ArrayXd> moments) {
  moments[0] = weight;
  pack(weight * direction * direction.transpose(), moments.segment<6>(1));
}

// Only normals count: a wire beside a wall must not make the wall an edge.
Channels normal_moments(const std::vector<Shape>& shapes) {
  Channels moments = Channels::Zero(7, static_cast<Eigen::Index>(shapes.size()));
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (shapes[i].structure == Structure::Planar)
      add_direction(shapes[i].direction, 1.0, moments.col(static_cast<Eigen::Index>(i)));
  return moments;
}

// Only clear creases count, with larger weights in the middle of a crease than at its sides.
Channels tangent_moments(const std::vector<NormalSpread>& spreads, const ShapeThresholds& thresholds) {
  Channels moments = Channels::Zero(7, static_cast<Eigen::Index>(spreads.size()));
  for (std::size_t i = 0; i < spreads.size(); ++i)
    if (spreads[i].across >= thresholds.clear_crease && spreads[i].along <= thresholds.max_corner)
      add_direction(spreads[i].tangent, spreads[i].across, moments.col(static_cast<Eigen::Index>(i)));
  return moments;
}

// The first step; the only one of the paper's classifier.
std::vector<Shape> shapes_of_points(const Cloud& cloud, const Neighbourhood& neighbourhood,
                                    const SurfaceOptions& options, int num_threads) {
  const Channels sums = neighbourhood.sum(point_moments(cloud), num_threads);
  std::vector<Shape> shapes(cloud.size());
  const auto shape_of = [&](std::size_t i, const Gaussian& points, const Eigen3& eigen) {
    return options.classifier == Classifier::Eigenvalues
               ? shape_of_points(points, eigen, options.thresholds)
               : line_or_normal(points, eigen, line_of_sight(cloud, i), options.thresholds);
  };
  const auto find_shapes = [&](std::size_t begin, std::size_t end) {
    std::array<Gaussian, kEigenBatch> points;
    Solver solver;
    for (std::size_t first = begin; first < end; first += kEigenBatch) {
      const std::size_t count = std::min(kEigenBatch, end - first);
      for (std::size_t k = 0; k < count; ++k) {
        points[k] = gaussian_of(sums.col(static_cast<Eigen::Index>(first + k)));
        solver.add(points[k].covariance);
      }
      const std::span<const Eigen3> solved = solver.solved();
      for (std::size_t k = 0; k < count; ++k) shapes[first + k] = shape_of(first + k, points[k], solved[k]);
    }
  };
  for_each_block(cloud.size(), num_threads, find_shapes);
  return shapes;
}

// An upper bound of the sum of the two smaller eigenvalues of a mean outer product, without computing them: they sum to
// 1, and the largest is at least the sum of their squares.
double largest_spread(const Mat3d& mean_outer_normal) { return 1.0 - mean_outer_normal.squaredNorm(); }

// The second step. Zero for lines, if too few neighbours have a normal, and if normals agree too well for a crease.
std::vector<NormalSpread> normal_spreads(const std::vector<Shape>& shapes, const Neighbourhood& neighbourhood,
                                         const ShapeThresholds& thresholds, int num_threads) {
  const Channels sums = neighbourhood.sum(normal_moments(shapes), num_threads);
  const double least = std::min(thresholds.min_crease, thresholds.clear_crease);
  std::vector<NormalSpread> spreads(shapes.size());
  const auto find_spreads = [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> points;
    Solver solver;
    const auto solve = [&] {
      const std::span<const Eigen3> solved = solver.solved();
      for (std::size_t k = 0; k < points.size(); ++k) spreads[points[k]] = spread_of_normals(solved[k]);
      points.clear();
    };
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = sums.col(static_cast<Eigen::Index>(i));
      if (shapes[i].structure == Structure::Edge || column[0] < thresholds.min_points) continue;
      const Mat3d mean_outer_normal = unpack(column.segment<6>(1)) / column[0];
      if (largest_spread(mean_outer_normal) < least) continue;
      points.push_back(i);
      solver.add(mean_outer_normal);
      if (points.size() == kEigenBatch) solve();
    }
    solve();
  };
  for_each_block(shapes.size(), num_threads, find_spreads);
  return spreads;
}

// The third step: points on a crease become edges, points in a corner lose their structure.
void find_creases(std::vector<Shape>& shapes, const std::vector<NormalSpread>& spreads,
                  const Neighbourhood& neighbourhood, const ShapeThresholds& thresholds, int num_threads) {
  const Channels sums = neighbourhood.sum(tangent_moments(spreads, thresholds), num_threads);
  for_each_block(shapes.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = sums.col(static_cast<Eigen::Index>(i));
      if (spreads[i].across < thresholds.min_crease) continue;
      if (spreads[i].along > thresholds.max_corner)
        shapes[i] = {};
      else if (column[0] >= thresholds.clear_crease)
        shapes[i] = {Structure::Edge, eigen_of_symmetric(unpack(column.segment<6>(1))).vectors.col(2)};
    }
  });
}

void store(const std::vector<Shape>& shapes, Cloud& cloud) {
  cloud.directions.resize(cloud.size());
  cloud.structures.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.structures[i] = shapes[i].structure;
    cloud.directions[i] = shapes[i].direction.cast<float>();
    if (shapes[i].structure == Structure::Planar && cloud.viewpoint)
      point_towards(*cloud.viewpoint, cloud.points[i], cloud.directions[i]);
  }
}

}  // namespace

void estimate_surface(Cloud& cloud, const Neighbourhood& neighbourhood, const SurfaceOptions& options,
                      int num_threads) {
  std::vector<Shape> shapes = shapes_of_points(cloud, neighbourhood, options, num_threads);
  if (options.classifier == Classifier::Normals) {
    const auto spreads = normal_spreads(shapes, neighbourhood, options.thresholds, num_threads);
    find_creases(shapes, spreads, neighbourhood, options.thresholds, num_threads);
  }
  store(shapes, cloud);
}

}  // namespace augicp
