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

// What a scan says of points.
struct Asked {
  const Scan& scan;
  const ScanMatcher* nearest;  // of the scan by nearest points if there is one already
  AgreementTolerance tolerance;
};
Testimony testimony_of(const Asked& asked, const Cloud& points, const Rigid3& scan_from_points, int num_threads) {
  const bool has_view = asked.scan.view.has_value();
  std::unique_ptr<ScanMatcher> own;
  if (has_view || !asked.nearest) own = matcher_for(asked.scan, has_view);
  const ScanMatcher& matcher = own ? *own : *asked.nearest;
  return {matcher.agreement(points, scan_from_points, asked.tolerance, num_threads), has_view};
}

// The last step of the loop, where the points are. A loop of one iteration has shown no small step.
void add_last_step(const AlignResult& result, double extent, Evidence& evidence) {
  const std::size_t count = result.history.size();
  if (count < 2) return;
  const Rigid3 &before = result.history[count - 2].target_from_source, &after = result.target_from_source;
  evidence.last_step = (after.translation - before.translation).norm() / extent;
  evidence.last_rotation_step = angle_between(after, before);
}

// How far a motion from one pose to another takes the source's points, in units of their spread.
double moved(const Cloud& source, const Rigid3& from_pose, const Rigid3& to_pose) {
  Vec3d mean = Vec3d::Zero();
  for (const Vec3f& point : source.points) mean += point.cast<double>();
  mean /= static_cast<double>(source.size());
  double moved_sq = 0.0, spread_sq = 0.0;
  for (const Vec3f& point : source.points) {
    const Vec3d p = point.cast<double>();
    moved_sq += (to_pose * p - from_pose * p).squaredNorm();
    spread_sq += (point.cast<double>() - mean).squaredNorm();
  }
  return std::sqrt(moved_sq / spread_sq);
}

}  // namespace

std::unique_ptr<ScanMatcher> matcher_for(const Scan& scan, bool projective) {
  if (projective) return std::make_unique<ProjectiveMatcher>(scan.cloud, scan.view->index, scan.view->camera);
  return std::make_unique<NearestMatcher>(scan.cloud);
}

Evidence gather_evidence(const ScanPair& pair, const ScanMatcher& matcher, const Rigid3& target_from_source,
                         const AlignOptions& options) {
  const Scan &source = pair.source, &target = pair.target;
  const Cloud of_source = witnesses(source.cloud), of_target = witnesses(target.cloud);
  Evidence evidence;
  const AgreementTolerance tolerance = tolerance_of(target, pair.lengths);
  evidence.source_in_target =
      testimony_of({target, &matcher, tolerance}, of_source, target_from_source, options.num_threads);
  evidence.target_in_source = testimony_of({source, nullptr, tolerance_of(source, pair.lengths)}, of_target,
                                           inverse(target_from_source), options.num_threads);
  const auto pairs = matcher.match(of_source, target_from_source, options.gates, options.num_threads);
  const PosedPairs posed{of_source, target.cloud, pairs, target_from_source};
  evidence.residuals = residuals(posed);
  const auto agreeing = agreeing_points(posed, tolerance);
  evidence.beyond_planes = share_beyond_planes(target.cloud, agreeing, tolerance);
  return evidence;
}

AlignResult judged(AlignResult result, const ScanPair& pair, const ScanMatcher& matcher,
                   const Rigid3& guess_target_from_source, const AlignOptions& options) {
  const AlignStatus reached = result.status;
  if (!has_pose(reached)) return result;
  Evidence evidence = gather_evidence(pair, matcher, result.target_from_source, options);
  add_last_step(result, pair.lengths.extent, evidence);
  evidence.observability = result.observability.weakest();
  evidence.moved = moved(witnesses(pair.source.cloud), guess_target_from_source, result.target_from_source);
  const Verdict verdict = decide(reached, evidence);
  result.status = verdict.status;
  result.doubts = verdict.doubts;
  result.evidence = evidence;
  return result;
}

}  // namespace augicp
