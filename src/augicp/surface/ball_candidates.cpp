// SPDX-License-Identifier: MIT
#include "augicp/surface/ball_candidates.h"

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

AUGICP_VECTORIZED void measure_distances(const float* __restrict x, const float* __restrict y,
                                         const float* __restrict z, std::size_t count, float px, float py, float pz,
                                         float* __restrict distance_sq) {
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - px, dy = y[k] - py, dz = z[k] - pz;
    distance_sq[k] = dx * dx + dy * dy + dz * dz;
  }
}

}  // namespace

void BallCandidates::read(const Cloud& cloud) {
  for (std::vector<float>* numbers : {&x_, &y_, &z_, &distance_sq_}) numbers->resize(index_.size());
  for (std::size_t k = 0; k < index_.size(); ++k) {
    const Vec3f& point = cloud.points[index_[k]];
    x_[k] = point.x(), y_[k] = point.y(), z_[k] = point.z();
  }
}

std::size_t BallCandidates::append_in_ball(const Vec3f& centre, float radius_sq,
                                           std::vector<std::uint32_t>& neighbours) {
  const std::size_t count = index_.size(), first = neighbours.size();
  measure_distances(x_.data(), y_.data(), z_.data(), count, centre.x(), centre.y(), centre.z(), distance_sq_.data());
  neighbours.resize(first + count);
  std::size_t next = first;
  for (std::size_t k = 0; k < count; ++k) {  // no branch: a third of them would be mispredicted
    neighbours[next] = index_[k];
    next += distance_sq_[k] < radius_sq ? 1 : 0;
  }
  neighbours.resize(next);
  return next - first;
}

}  // namespace augicp
