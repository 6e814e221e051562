// SPDX-License-Identifier: MIT
#include "augicp/trust/beyond_planes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace augicp {
namespace {

constexpr int kNumPlanes = 3;
constexpr std::size_t kNumTried = 32;  // number of points for candidate planes, for each of the three
constexpr int kNumLargePlanes = 6;
constexpr double kMinShareOfPlane = 0.02, kMinShareCompared = 0.05;
constexpr std::size_t kNumFitted = 1024;  // of the points: enough for the planes of the most of them

constexpr int kNumFits = 3;  // the normal of one point is a few degrees off, which is far off across a room

// The tolerance at a cloud's point; per_depth is relative to the viewpoint.
double allowed(const Cloud& cloud, std::uint32_t point, const AgreementTolerance& tolerance) {
  if (!(tolerance.per_depth > 0.0)) return tolerance.distance;
  const Vec3f seen_from = cloud.viewpoint.value_or(Vec3f::Zero());
  return tolerance.distance + tolerance.per_depth * static_cast<double>((cloud.points[point] - seen_from).norm());
}

struct Plane {
  Vec3d normal, point;
};

// The data of a point, copied for repeated reading.
struct Candidate {
  Vec3d place;
  double allowed;
  std::uint32_t point;
};

bool is_on(const Plane& plane, const Candidate& candidate) {
  return std::abs(plane.normal.dot(candidate.place - plane.point)) < candidate.allowed;
}

std::size_t num_on(const Plane& plane, std::span<const Candidate> candidates) {
  std::size_t count = 0;
  for (const Candidate& candidate : candidates) count += is_on(plane, candidate) ? 1 : 0;
  return count;
}

// The plane through the mean of the points on a plane, along their two widest directions.
Plane fitted(const Plane& plane, std::span<const Candidate> candidates) {
  Vec3d mean = Vec3d::Zero();
  std::vector<Vec3d> on;
  for (const Candidate& candidate : candidates)
    if (is_on(plane, candidate)) on.push_back(candidate.place);
  for (const Vec3d& place : on) mean += place;
  mean /= static_cast<double>(on.size());
  Mat3d scatter = Mat3d::Zero();
  for (const Vec3d& place : on) scatter += (place - mean) * (place - mean).transpose();
  return {Eigen::SelfAdjointEigenSolver<Mat3d>(scatter).eigenvectors().col(0), mean};
}

// Without a planar point, the plane has no normal.
Plane best_plane(const Cloud& cloud, std::span<const Candidate> candidates) {
  Plane best{Vec3d::Zero(), Vec3d::Zero()};
  std::size_t num_on_best = 0;
  const auto keep_better = [&](const Plane& plane) {
    const std::size_t count = num_on(plane, candidates);
    if (count <= num_on_best) return;
    best = plane;
    num_on_best = count;
  };
  const std::size_t step = (candidates.size() + kNumTried - 1) / kNumTried;
  for (std::size_t k = 0; k < candidates.size(); k += step) {
    const std::uint32_t i = candidates[k].point;
    if (cloud.structures[i] == Structure::Planar)
      keep_better({cloud.directions[i].cast<double>(), candidates[k].place});
  }
  for (int k = 0; k < kNumFits && num_on_best >= 3; ++k) keep_better(fitted(best, candidates));
  return best;
}

bool may_be_asked(PointAgreement said) { return said != PointAgreement::Hidden && said != PointAgreement::Conflict; }

}  // namespace

std::vector<std::uint32_t> agreeing_points(const PosedPairs& posed, const AgreementTolerance& tolerance) {
  const Cloud &source = posed.source, &target = posed.target;
  std::vector<std::uint32_t> agreeing;
  if (!source.has_directions() || !target.has_directions()) return agreeing;
  const Mat3d rotation = posed.target_from_source.rotation.toRotationMatrix();
  for (const Correspondence& pair : posed.pairs) {
    const bool both_planar =
        source.structures[pair.source] == Structure::Planar && target.structures[pair.target] == Structure::Planar;
    const Vec3d direction = target.directions[pair.target].cast<double>();
    const Vec3d error = posed.target_from_source * source.points[pair.source].cast<double>() -
                        target.points[pair.target].cast<double>();
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
  std::vector<Candidate> rest;
  rest.reserve(points.size());
  for (const std::uint32_t i : points)
    rest.push_back({cloud.points[i].cast<double>(), allowed(cloud, i, tolerance), i});
  for (int k = 0; k < kNumPlanes && !rest.empty(); ++k) {
    const Plane plane = best_plane(cloud, rest);
    if (plane.normal.isZero()) break;
    std::erase_if(rest, [&](const Candidate& candidate) { return is_on(plane, candidate); });
  }
  return static_cast<double>(rest.size()) / static_cast<double>(points.size());
}

std::vector<bool> on_large_planes(const Cloud& cloud, double distance) {
  std::vector<bool> is_on_plane(cloud.size(), false);
  if (!cloud.has_directions()) return is_on_plane;
  const std::size_t step = (cloud.size() + kNumFitted - 1) / kNumFitted;
  std::vector<Candidate> rest;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    rest.push_back({cloud.points[i].cast<double>(), distance, static_cast<std::uint32_t>(i)});
  const double fewest = kMinShareOfPlane * static_cast<double>(rest.size());
  for (int k = 0; k < kNumLargePlanes && !rest.empty(); ++k) {
    const Plane plane = best_plane(cloud, rest);
    const std::size_t num_left = rest.size();
    std::erase_if(rest, [&](const Candidate& candidate) { return is_on(plane, candidate); });
    if (plane.normal.isZero() || static_cast<double>(num_left - rest.size()) < fewest) break;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (std::abs(plane.normal.dot(cloud.points[i].cast<double>() - plane.point)) < distance) is_on_plane[i] = true;
  }
  return is_on_plane;
}

double agreement_off_planes(std::span<const PointAgreement> said, const std::vector<bool>& is_on_plane) {
  std::array<double, 2> num_asked{}, num_agreeing{};  // off, on
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (!may_be_asked(said[i])) continue;
    num_asked[is_on_plane[i]] += 1.0;
    if (said[i] == PointAgreement::Agree) num_agreeing[is_on_plane[i]] += 1.0;
  }
  const double fewest = std::max(1.0, kMinShareCompared * static_cast<double>(said.size()));
  if (num_asked[0] < fewest || num_asked[1] < fewest || num_agreeing[1] < fewest) return 1.0;
  return num_agreeing[0] / num_asked[0] * num_asked[1] / num_agreeing[1];
}

}  // namespace augicp
