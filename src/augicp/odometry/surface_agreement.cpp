// SPDX-License-Identifier: MIT
#include "augicp/odometry/surface_agreement.h"

#include <cmath>

namespace augicp {
namespace {

double distance_from_surface(const Cloud& target, std::uint32_t point, const Vec3d& place) {
  const Vec3d apart = place - target.points[point].cast<double>();
  const Vec3d direction = target.directions[point].cast<double>();
  const double along = direction.dot(apart);
  return target.structures[point] == Structure::Edge ? (apart - along * direction).norm() : std::abs(along);
}

}  // namespace

SurfaceAgreement surface_agreement(const PosedPairs& posed, double on_surface) {
  const Rigid3& pose = posed.target_from_source;
  std::size_t num_on = 0;
  double sum_sq = 0.0;
  for (const Correspondence& pair : posed.pairs) {
    const double off =
        distance_from_surface(posed.target, pair.target, pose * posed.source.points[pair.source].cast<double>());
    if (off > on_surface) continue;
    ++num_on;
    sum_sq += off * off;
  }
  if (num_on == 0) return {};
  return {static_cast<double>(num_on) / static_cast<double>(posed.source.size()),
          std::sqrt(sum_sq / static_cast<double>(num_on))};
}

}  // namespace augicp
