// SPDX-License-Identifier: MIT
#include "augicp/registration/judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/trust/beyond_planes.h"

namespace augicp {
namespace {

constexpr std::size_t kNumWitnesses = 4096;

// How far from a surface a point still is on it. On depth images: what a Kinect's noise at 4 m, its steps and a lens
// that is not quite known come to. Twice as much would call poses right that are off by a hand's breadth. Elsewhere as
// a part of the ball in which surfaces are estimated: twice the distance of thinned points.
constexpr double kDistancePerDepth = 0.015;
constexpr double kDistancePerRadius = 0.5;

Cloud witnesses(const Cloud& cloud) { return evenly_chosen(cloud, kNumWitnesses); }

AgreementTolerance tolerance_of(const Scan& scan, const Lengths& lengths) {
  if (scan.view) return {.distance = 0.0, .per_depth = kDistancePerDepth};
  return {.distance = kDistancePerRadius * lengths.radius, .per_depth = 0.0};
}

// What `scan` says of the points. nearest: a matcher of the scan by nearest points if there is one already.
Testimony testimony_of(const Scan& scan, const Matcher* nearest, const Cloud& points, const Rigid3& scan_from_points,
                       const Lengths& lengths, int num_threads) {
  const bool has_view = scan.view.has_value();
  std::unique_ptr<Matcher> own;
  if (has_view || !nearest) own = matcher_for(scan, has_view);
  const Matcher& matcher = own ? *own : *nearest;
  return {matcher.agreement(points, scan_from_points, tolerance_of(scan, lengths), num_threads), has_view};
}

// The last step of the loop, where the points are. A loop of one iteration has shown no small step.
void tell_last_step(const AlignResult& result, const Scan& source, const Scan& target, double extent,
                    Evidence& evidence) {
  const std::size_t count = result.history.size();
  if (count < 2) return;
  const Rigid3 before = without_origins(result.history[count - 2].target_from_source, source.cloud, target.cloud);
  const Rigid3 after = without_origins(result.target_from_source, source.cloud, target.cloud);
  evidence.last_step = (after.translation - before.translation).norm() / extent;
  evidence.last_rotation_step = angle_between(after, before);
}

// Both poses between the clouds' frames.
double moved(const Cloud& source, const Rigid3& from_pose, const Rigid3& to_pose) {
  Vec3d mean = Vec3d::Zero();
  for (const Vec3f& point : source.points) mean += point.cast<double>();
  mean /= static_cast<double>(source.size());
  double moved_sq = 0.0, spread_sq = 0.0;
  for (const Vec3f& point : source.points) {
    const Vec3d p = source.origin + point.cast<double>();
    moved_sq += (to_pose * p - from_pose * p).squaredNorm();
    spread_sq += (point.cast<double>() - mean).squaredNorm();
  }
  return std::sqrt(moved_sq / spread_sq);
}

}  // namespace

std::unique_ptr<Matcher> matcher_for(const Scan& scan, bool projective) {
  if (projective) return std::make_unique<ProjectiveMatcher>(scan.cloud, scan.view->index, scan.view->camera);
  return std::make_unique<NearestMatcher>(scan.cloud);
}

Evidence gather_evidence(const Scan& source, const Scan& target, const Matcher& matcher,
                         const Rigid3& target_from_source, const Lengths& lengths, const AlignOptions& options) {
  const Rigid3 pose = without_origins(target_from_source, source.cloud, target.cloud);
  const Cloud of_source = witnesses(source.cloud), of_target = witnesses(target.cloud);
  Evidence evidence;
  evidence.source_in_target = testimony_of(target, &matcher, of_source, pose, lengths, options.num_threads);
  evidence.target_in_source = testimony_of(source, nullptr, of_target, inverse(pose), lengths, options.num_threads);
  const auto pairs = matcher.match(of_source, pose, options.gates, options.num_threads);
  evidence.residuals = residuals(of_source, target.cloud, pairs, pose);
  const AgreementTolerance tolerance = tolerance_of(target, lengths);
  const auto agreeing = agreeing_points(of_source, target.cloud, pairs, pose, tolerance);
  evidence.beyond_planes = share_beyond_planes(target.cloud, agreeing, tolerance);
  return evidence;
}

AlignResult judged(AlignResult result, const Scan& source, const Scan& target, const Matcher& matcher,
                   const Rigid3& guess_target_from_source, const Lengths& lengths, const AlignOptions& options) {
  const AlignStatus reached = result.status;
  if (!has_pose(reached)) return result;
  Evidence evidence = gather_evidence(source, target, matcher, result.target_from_source, lengths, options);
  tell_last_step(result, source, target, lengths.extent, evidence);
  evidence.observability = result.observability.weakest();
  evidence.moved = moved(witnesses(source.cloud), guess_target_from_source, result.target_from_source);
  const Verdict verdict = decide(reached, evidence);
  result.status = verdict.status;
  result.doubts = verdict.doubts;
  result.evidence = evidence;
  return result;
}

}  // namespace augicp
