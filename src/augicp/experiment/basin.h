// SPDX-License-Identifier: MIT
// The basin of convergence: from which starts a registration finds the truth.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "augicp/experiment/pose_error.h"
#include "augicp/registration/registration.h"

namespace augicp {

struct BasinOptions {
  // Each ascending and at least 0. A start is the truth, rotated by the angle about an axis through the centroid of the
  // source and moved by the distance, both in random directions.
  std::vector<double> angles_rad{};
  std::vector<double> distances{};  // metres

  std::size_t num_starts = 10;  // per angle and distance
  unsigned seed = 1;

  // A start that ends within this of the truth is a success. Empty: the radius of the ball for surface estimation, and
  // 2 degrees.
  std::optional<PoseError> limit;

  RegistrationOptions registration;

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

struct BasinCell {
  double angle_rad = 0.0, distance = 0.0;
  double success = 0.0;          // share of the starts that succeed
  double mean_iterations = 0.0;  // of all starts
};

// One cell per angle and distance, distances changing first. The scans are prepared once. on_start is called after each
// start.
std::vector<BasinCell> run_basin(const Scan& source, const Scan& target, const Rigid3& true_target_from_source,
                                 const BasinOptions& options, const std::function<void()>& on_start);

// The limit that run_basin uses for these scans.
PoseError basin_limit(const Scan& source, const Scan& target, const BasinOptions& options);

// The mean success over the surface, linear between the cells of run_basin, in [0, 1]. An axis with a single value
// counts as that value.
double area_under(std::span<const BasinCell> cells, const BasinOptions& options);

}  // namespace augicp
