// SPDX-License-Identifier: MIT
#include "augicp/odometry/skew_trial.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_set>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/match/matcher.h"
#include "augicp/odometry/surface_map.h"
#include "augicp/odometry/sweep_kernel.h"

namespace augicp {
namespace {

constexpr double kMapCellsPerVoxel = 4.0;
constexpr double kCellsPerVoxel = 2.0;

// Points farther than this are left out: their cells would not fit into a key. Voxels.
constexpr double kKeyReachVoxels = 1 << 17;

constexpr std::size_t kMinPairs = 50;
constexpr int kMaxSkewIterations = 12;
constexpr double kMinSkewStep = 1e-4;
constexpr double kMaxShare = 5.0;  // no minimum beyond

// The least width of the kernel, voxels.
constexpr double kMinSkewKernel = 0.02;

// Errors of points in one cell of this many voxels may be correlated in any way.
constexpr double kErrorCellVoxels = 2.0;

constexpr double kRidge = 1e-9;

constexpr int kNumVotes = 8;
constexpr int kMaxTrials = 40;

using Vec7d = Eigen::Matrix<double, 7, 1>;
using Mat7d = Eigen::Matrix<double, 7, 7>;
using Key = std::uint64_t;

Key cell_of(const Vec3f& point, double size) {
  constexpr std::int64_t kZero = 1 << 20;
  Key key = 0;
  for (int k = 0; k < 3; ++k)
    key = key << 21 |
          static_cast<Key>(static_cast<std::int64_t>(std::floor(static_cast<double>(point[k]) / size)) + kZero);
  return key;
}

// The first point of each cell.
std::vector<std::uint32_t> first_of_cells(const Cloud& cloud, double size, double reach) {
  std::vector<std::uint32_t> chosen;
  std::unordered_set<Key> seen;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (static_cast<double>(cloud.points[i].cwiseAbs().maxCoeff()) < reach &&
        seen.insert(cell_of(cloud.points[i], size)).second)
      chosen.push_back(i);
  return chosen;
}

Cloud moved(const SkewedScan& scan, double share) {
  Cloud cloud = scan.cloud;
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.points[i] += static_cast<float>(share) * scan.movement[i];
  return cloud;
}

struct Row {
  double error;
  Vec7d gradient;  // with the increment of T and with the share
  Key cell;
};

std::vector<Row> rows_at(const SkewedScan& reference, const SkewedScan& scan, const Rigid3& T, double share,
                         double voxel_size, int num_threads) {
  const Cloud target = moved(reference, share), source = moved(scan, share);
  Gates gates;
  gates.max_distance = voxel_size;
  std::vector<Row> rows;
  for (const Correspondence& pair : NearestMatcher(target).match(source, T, gates, num_threads)) {
    const Vec3d n = target.directions[pair.target].cast<double>();
    const Vec3d q = target.points[pair.target].cast<double>();
    const Vec3d p = T * source.points[pair.source].cast<double>();
    const Vec3d movement =
        T.rotation * scan.movement[pair.source].cast<double>() - reference.movement[pair.target].cast<double>();
    Row row{n.dot(p - q), {}, cell_of(target.points[pair.target], kErrorCellVoxels * voxel_size)};
    row.gradient << n, p.cross(n), n.dot(movement);
    rows.push_back(row);
  }
  return rows;
}

double kernel_width(const std::vector<Row>& rows, double voxel_size) {
  return std::max(kKernelPerMedian * median_size(rows), kMinSkewKernel * voxel_size);
}

struct Step {
  Vec7d increment;
  double deviation;  // of the share
};

// With the weights of the Geman-McClure kernel, and the sandwich of covariance.h.
Step step_from(const std::vector<Row>& rows, double kernel) {
  Mat7d H = Mat7d::Zero(), spread = Mat7d::Zero();
  Vec7d b = Vec7d::Zero();
  std::map<Key, Vec7d> of_cell;
  for (const Row& row : rows) {
    const double weight = kernel_weight(row.error, kernel);
    H += weight * row.gradient * row.gradient.transpose();
    const Vec7d gradient = weight * row.error * row.gradient;
    b += gradient;
    of_cell.try_emplace(row.cell, Vec7d::Zero()).first->second += gradient;
  }
  for (const auto& [cell, gradient] : of_cell) spread += gradient * gradient.transpose();
  H += kRidge * H.trace() * Mat7d::Identity();
  const Mat7d inverse = H.inverse();
  return {-H.ldlt().solve(b), std::sqrt((inverse * spread * inverse)(6, 6))};
}

}  // namespace

SkewedScan skewed_scan(const Cloud& scan, const SweepShares& shares, const SweepMotion& motion,
                       const Rigid3& world_from_sensor, double voxel_size) {
  const double reach = kKeyReachVoxels * voxel_size;
  SurfaceMapOptions options;
  options.voxel_size = voxel_size;
  SurfaceMap own(options);
  own.add(select(scan, first_of_cells(scan, voxel_size / kMapCellsPerVoxel, reach)), Rigid3{});
  const std::vector<std::uint32_t> chosen = first_of_cells(scan, voxel_size / kCellsPerVoxel, reach);
  Cloud cloud = select(scan, chosen);
  own.describe(cloud, Rigid3{});
  std::vector<std::uint32_t> planar;
  SweepShares planar_shares;
  for (std::uint32_t k = 0; k < cloud.size(); ++k) {
    if (cloud.structures[k] != Structure::Planar) continue;
    planar.push_back(k);
    planar_shares.push_back(shares[chosen[k]]);
  }
  SkewedScan skewed{select(cloud, planar), {}, world_from_sensor};
  const Cloud straight = without_skew(skewed.cloud, planar_shares, motion, 1);
  for (std::size_t i = 0; i < straight.size(); ++i)
    skewed.movement.push_back(straight.points[i] - skewed.cloud.points[i]);
  return skewed;
}

std::optional<SkewEstimate> estimate_skew(const SkewedScan& reference, const SkewedScan& scan, double voxel_size,
                                          int num_threads) {
  Rigid3 T =
      without_origins(inverse(reference.world_from_sensor) * scan.world_from_sensor, scan.cloud, reference.cloud);
  double share = 0.5;
  std::optional<SkewEstimate> found;
  for (int iteration = 0; iteration < kMaxSkewIterations; ++iteration) {
    const std::vector<Row> rows = rows_at(reference, scan, T, share, voxel_size, num_threads);
    if (rows.size() < kMinPairs) return std::nullopt;
    const Step step = step_from(rows, kernel_width(rows, voxel_size));
    T = retract(T, step.increment.head<6>());
    share += step.increment[6];
    if (!(std::abs(share) < kMaxShare)) return std::nullopt;
    found = {share, step.deviation};
    if (step.increment.norm() < kMinSkewStep) break;
  }
  return found;
}

void SkewVotes::add(const std::optional<SkewEstimate>& estimate, bool is_change_free) {
  ++num_tried_;
  if (!estimate || !estimate->counts()) return;
  if (is_change_free && estimate->is_clear() && !estimate->is_skewed()) majority_ = 0;
  ++(estimate->is_skewed() ? num_for_ : num_against_);
}

bool SkewVotes::is_decided() const { return num_tried_ >= kMaxTrials || num_for_ + num_against_ >= kNumVotes; }

}  // namespace augicp
