// SPDX-License-Identifier: MIT
#include "augicp/align/beyond_planes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace augicp {
namespace {

constexpr int kNumPlanes = 3;
constexpr std::size_t kNumTried = 32;  // through so many points, for each of the three
constexpr int kNumFits = 3;            // a normal of one point is a few degrees off, which is much across a room

// Of a cloud's point; per_depth counts from where it was seen.
double allowed(const Cloud& cloud, std::uint32_t point, const AgreementTolerance& tolerance) {
  if (!(tolerance.per_depth > 0.0)) return tolerance.distance;
  const Vec3f seen_from = cloud.viewpoint.value_or(Vec3f::Zero());
  return tolerance.distance + tolerance.per_depth * static_cast<double>((cloud.points[point] - seen_from).norm());
}

struct Plane {
  Vec3d normal, point;
};

bool is_on(const Plane& plane, const Cloud& cloud, std::uint32_t point, const AgreementTolerance& tolerance) {
  return std::abs(plane.normal.dot(cloud.points[point].cast<double>() - plane.point)) <
         allowed(cloud, point, tolerance);
}

std::vector<std::uint32_t> points_on(const Plane& plane, const Cloud& cloud, std::span<const std::uint32_t> points,
                                     const AgreementTolerance& tolerance) {
  std::vector<std::uint32_t> on;
  for (const std::uint32_t i : points)
    if (is_on(plane, cloud, i, tolerance)) on.push_back(i);
  return on;
}

// Through the points' mean, along their two widest directions.
Plane fitted(const Cloud& cloud, std::span<const std::uint32_t> points) {
  Vec3d mean = Vec3d::Zero();
  for (const std::uint32_t i : points) mean += cloud.points[i].cast<double>();
  mean /= static_cast<double>(points.size());
  Mat3d scatter = Mat3d::Zero();
  for (const std::uint32_t i : points) {
    const Vec3d from_mean = cloud.points[i].cast<double>() - mean;
    scatter += from_mean * from_mean.transpose();
  }
  return {Eigen::SelfAdjointEigenSolver<Mat3d>(scatter).eigenvectors().col(0), mean};
}

// Where no point is planar, the plane has no normal.
Plane best_plane(const Cloud& cloud, std::span<const std::uint32_t> points, const AgreementTolerance& tolerance) {
  Plane best{Vec3d::Zero(), Vec3d::Zero()};
  std::vector<std::uint32_t> on_best;
  const auto keep_better = [&](const Plane& plane) {
    std::vector<std::uint32_t> on = points_on(plane, cloud, points, tolerance);
    if (on.size() <= on_best.size()) return;
    best = plane;
    on_best = std::move(on);
  };
  const std::size_t step = (points.size() + kNumTried - 1) / kNumTried;
  for (std::size_t k = 0; k < points.size(); k += step)
    if (cloud.structures[points[k]] == Structure::Planar)
      keep_better({cloud.directions[points[k]].cast<double>(), cloud.points[points[k]].cast<double>()});
  for (int k = 0; k < kNumFits && on_best.size() >= 3; ++k) keep_better(fitted(cloud, on_best));
  return best;
}

}  // namespace

std::vector<std::uint32_t> agreeing_points(const Cloud& source, const Cloud& target,
                                           std::span<const Correspondence> pairs, const Rigid3& target_from_source,
                                           const AgreementTolerance& tolerance) {
  std::vector<std::uint32_t> agreeing;
  if (!source.has_directions() || !target.has_directions()) return agreeing;
  const Mat3d rotation = target_from_source.rotation.toRotationMatrix();
  for (const Correspondence& pair : pairs) {
    const bool both_planar =
        source.structures[pair.source] == Structure::Planar && target.structures[pair.target] == Structure::Planar;
    const Vec3d direction = target.directions[pair.target].cast<double>();
    const Vec3d error =
        target_from_source * source.points[pair.source].cast<double>() - target.points[pair.target].cast<double>();
    const double off = both_planar ? std::abs(direction.dot(error)) : error.norm();
    const double cosine =
        both_planar ? std::abs(direction.dot(rotation * source.directions[pair.source].cast<double>())) : 1.0;
    if (off < allowed(target, pair.target, tolerance) && cosine >= tolerance.min_cosine)
      agreeing.push_back(pair.target);
  }
  return agreeing;
}

double share_beyond_planes(const Cloud& cloud, std::span<const std::uint32_t> points,
                           const AgreementTolerance& tolerance) {
  if (points.empty() || !cloud.has_directions()) return 1.0;
  std::vector<std::uint32_t> rest(points.begin(), points.end());
  for (int k = 0; k < kNumPlanes && !rest.empty(); ++k) {
    const Plane plane = best_plane(cloud, rest, tolerance);
    if (plane.normal.isZero()) break;
    std::erase_if(rest, [&](std::uint32_t i) { return is_on(plane, cloud, i, tolerance); });
  }
  return static_cast<double>(rest.size()) / static_cast<double>(points.size());
}

}  // namespace augicp
