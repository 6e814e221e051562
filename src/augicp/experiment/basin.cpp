// SPDX-License-Identifier: MIT
#include "augicp/experiment/basin.h"

#include <algorithm>

#include "augicp/core/angles.h"
#include "augicp/core/check.h"
#include "augicp/experiment/random.h"

namespace augicp {
namespace {

constexpr double kLimit_rad = 2.0 * kRadPerDeg;

void check_axis(const std::vector<double>& values, const char* name) {
  require(!values.empty(), name, 0.0, "expected some, found none");
  for (const double value : values) require_not_negative(name, value);
  require(std::is_sorted(values.begin(), values.end()), name, values.front(), "must be ascending");
}

Vec3d middle_of(const Cloud& cloud) {
  return cloud.empty() ? cloud.origin : Vec3d(cloud.origin + median_point(cloud).cast<double>());
}

// About the centroid of the points: a rotation about zero would move far clouds by much more than the distance.
Rigid3 disturbed(const Rigid3& truth, const Rigid3& motion, const Vec3d& middle) {
  return truth * Rigid3{motion.rotation, middle + motion.translation - motion.rotation * middle};
}

// Weights of the trapezoidal rule for the mean over an axis.
std::vector<double> trapezoid_weights(const std::vector<double>& places) {
  const double length = places.back() - places.front();
  std::vector<double> weights(places.size(), length > 0.0 ? 0.0 : 1.0 / static_cast<double>(places.size()));
  for (std::size_t i = 0; length > 0.0 && i + 1 < places.size(); ++i) {
    const double half = 0.5 * (places[i + 1] - places[i]) / length;
    weights[i] += half;
    weights[i + 1] += half;
  }
  return weights;
}

}  // namespace

void BasinOptions::check() const {
  check_axis(angles_rad, "angles");
  check_axis(distances, "distances");
  require(num_starts > 0, "num_starts", 0.0, "must be at least 1");
  if (limit) {
    require_positive("limit of translation", limit->translation);
    require_positive("limit of rotation", limit->rotation);
  }
  registration.check();
}

PoseError basin_limit(const Scan& source, const Scan& target, const BasinOptions& options) {
  return options.limit.value_or(PoseError{lengths_for(source, target, options.registration).radius, kLimit_rad});
}

std::vector<BasinCell> run_basin(const Scan& source, const Scan& target, const Rigid3& true_target_from_source,
                                 const BasinOptions& options, const std::function<void()>& on_start) {
  options.check();
  const PreparedPair prepared = prepare_pair(source, target, options.registration);
  const PoseError limit = basin_limit(source, target, options);
  const Vec3d middle = middle_of(source.cloud);
  std::mt19937 generator(options.seed);
  std::vector<BasinCell> cells;
  for (const double angle_rad : options.angles_rad)
    for (const double distance : options.distances) {
      std::size_t num_success = 0, iterations = 0;
      for (std::size_t i = 0; i < options.num_starts; ++i) {
        const Rigid3 start = disturbed(true_target_from_source, random_motion(generator, angle_rad, distance), middle);
        const AlignResult result = register_prepared(prepared, start, options.registration);
        num_success += is_within(pose_error(result.target_from_source, true_target_from_source), limit);
        iterations += static_cast<std::size_t>(result.iterations);
        on_start();
      }
      const auto count = static_cast<double>(options.num_starts);
      cells.push_back(
          {angle_rad, distance, static_cast<double>(num_success) / count, static_cast<double>(iterations) / count});
    }
  return cells;
}

double area_under(std::span<const BasinCell> cells, const BasinOptions& options) {
  const std::vector<double> rows = trapezoid_weights(options.angles_rad);
  const std::vector<double> columns = trapezoid_weights(options.distances);
  require(cells.size() == rows.size() * columns.size(), "cells", static_cast<double>(cells.size()),
          "must be one for each angle and distance");
  double area = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    area += rows[i / columns.size()] * columns[i % columns.size()] * cells[i].success;
  return area;
}

}  // namespace augicp
