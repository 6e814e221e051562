// SPDX-License-Identifier: MIT
#include "augicp/odometry/shown_motion.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/median.h"
#include "augicp/odometry/sweep_kernel.h"

namespace augicp {
namespace {

constexpr std::size_t kMinPlanarPairs = 50;

using Vec18d = Eigen::Matrix<double, 18, 1>;  // a, b, c, each a shift and a turn
using Mat18d = Eigen::Matrix<double, 18, 18>;

struct MotionRow {
  double error;
  Vec18d gradient;
};

std::vector<MotionRow> rows_of(const PosedPairs& posed, const SweepShares& shares) {
  const Rigid3& pose = posed.target_from_source;
  std::vector<MotionRow> rows;
  for (const Correspondence& pair : posed.pairs) {
    if (posed.target.structures[pair.target] != Structure::Planar) continue;
    const Vec3d p = posed.source.points[pair.source].cast<double>();
    const Vec3d n = posed.target.directions[pair.target].cast<double>();
    const Vec3d n_sensor = pose.rotation.conjugate() * n;
    const double s = static_cast<double>(shares[pair.source]) - 0.5;
    Eigen::Matrix<double, 6, 1> J;
    J << n_sensor, (posed.source.origin + p).cross(n_sensor);
    MotionRow row{n.dot(pose * p - posed.target.points[pair.target].cast<double>()), {}};
    row.gradient << J, s * J, 0.5 * s * s * J;
    rows.push_back(row);
  }
  return rows;
}

// Of the errors, as if each cell had one.
double variance_of(double median_error, const Cloud& source, double correlation) {
  const double num_cells = static_cast<double>(count_voxels(source, correlation));
  return std::pow(kSigmaPerMedian * median_error, 2) * static_cast<double>(source.size()) / num_cells;
}

}  // namespace

std::optional<SweepMotion> shown_motion(const PosedPairs& posed, const SweepShares& shares, const MotionPrior& prior) {
  const std::vector<MotionRow> rows = rows_of(posed, shares);
  if (rows.size() < kMinPlanarPairs) return std::nullopt;
  const double median_error = median_size(rows);
  if (!(median_error > 0.0)) return prior.motion;
  Mat18d H = Mat18d::Zero();
  Vec18d b = Vec18d::Zero();
  for (const MotionRow& row : rows) {
    const double weight = kernel_weight(row.error, kKernelPerMedian * median_error);
    H += weight * row.gradient * row.gradient.transpose();
    b += weight * row.error * row.gradient;
  }
  const double precision = variance_of(median_error, posed.source, prior.correlation) / std::pow(prior.sigma, 2);
  for (const int order : {6, 12}) {
    H.diagonal().segment<3>(order).array() += precision;
    H.diagonal().segment<3>(order + 3).array() += precision * std::pow(prior.typical_distance, 2);
  }
  const Vec18d step = -H.ldlt().solve(b);
  SweepMotion motion = prior.motion;
  motion.velocity += step.segment<3>(6), motion.rotation += step.segment<3>(9);
  motion.acceleration += step.segment<3>(12), motion.angular_acceleration += step.segment<3>(15);
  return motion;
}

}  // namespace augicp
