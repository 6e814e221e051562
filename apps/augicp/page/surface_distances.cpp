// SPDX-License-Identifier: MIT
#include "apps/augicp/page/surface_distances.h"

#include <limits>

namespace augicp::app {
namespace {

struct Signed {
  float metres = 0.0f;
  Vec3f direction = Vec3f::Zero();
};

Signed off_surface(const Vec3f& from_target_point, const Cloud& target, std::uint32_t i) {
  const Structure structure = target.has_directions() ? target.structures[i] : Structure::None;
  if (structure == Structure::Planar) return {from_target_point.dot(target.directions[i]), target.directions[i]};
  Vec3f across = from_target_point;
  if (structure == Structure::Edge) across -= target.directions[i] * target.directions[i].dot(across);
  const float length = across.norm();
  return {length, length > 0.0f ? Vec3f(across / length) : Vec3f::Zero()};
}

}  // namespace

SurfaceDistances surface_distances(const AlignPicture& picture) {
  const Cloud &source = picture.prepared.source.cloud, &target = picture.prepared.target.cloud;
  SurfaceDistances distances{std::vector<float>(source.size(), std::numeric_limits<float>::quiet_NaN()),
                             std::vector<Vec3f>(source.size(), Vec3f::Zero())};
  const AlignResult& result = picture.report.result;
  if (!has_pose(result.status)) return distances;
  const Rigid3 between_points = without_origins(result.target_from_source, source, target);
  for (const Correspondence& pair : result.pairs) {
    const Vec3d moved = between_points * source.points[pair.source].cast<double>();
    const Vec3f apart = (moved - target.points[pair.target].cast<double>()).cast<float>();
    const Signed off = off_surface(apart, target, pair.target);
    distances.metres[pair.source] = off.metres;
    distances.directions[pair.source] = off.direction;
  }
  return distances;
}

}  // namespace augicp::app
