// SPDX-License-Identifier: MIT
#include "augicp/trust/residuals.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "augicp/core/median.h"

namespace augicp {
namespace {

ResidualStatistics statistics_of(const std::vector<float>& errors) {
  return {static_cast<std::int64_t>(errors.size()), median(errors)};
}

float angle_of(float cosine) { return std::acos(std::clamp(cosine, -1.0f, 1.0f)); }

}  // namespace

Residuals residuals(const PosedPairs& posed) {
  const Cloud &source = posed.source, &target = posed.target;
  if (!source.has_directions() || !target.has_directions()) return {};
  const Rigid3f pose(posed.target_from_source);
  const bool with_sign = normals_have_signs(source, target);
  std::vector<float> distances, normal_angles, tangent_angles;
  for (const Correspondence& pair : posed.pairs) {
    const Structure structure = target.structures[pair.target];
    const Vec3f& direction = target.directions[pair.target];
    if (structure == Structure::Planar) {
      const Vec3f error = pose * source.points[pair.source] - target.points[pair.target];
      distances.push_back(std::abs(direction.dot(error)));
    }
    if (structure == Structure::None || source.structures[pair.source] != structure) continue;
    const float cosine = direction.dot(pose.rotation * source.directions[pair.source]);
    if (structure == Structure::Planar)
      normal_angles.push_back(angle_of(with_sign ? cosine : std::abs(cosine)));
    else
      tangent_angles.push_back(angle_of(std::abs(cosine)));
  }
  return {statistics_of(distances), statistics_of(normal_angles), statistics_of(tangent_angles)};
}

}  // namespace augicp
