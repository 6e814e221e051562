// SPDX-License-Identifier: MIT
#include "augicp/registration/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/median.h"
#include "augicp/core/parallel.h"
#include "augicp/sensor/image_noise.h"
#include "augicp/trust/beyond_planes.h"
#include "augicp/trust/contradiction.h"
#include "augicp/trust/free_motions.h"

namespace augicp {
namespace {

constexpr std::size_t kNumWitnesses = 4096;

// How far from a surface a point still is on it. On depth images: what a Kinect's noise at 4 m, its steps and a lens
// that is not quite known come to. Twice as much would call poses right that are off by a hand's breadth. Elsewhere as
// a part of the ball in which surfaces are estimated: twice the distance of thinned points.
constexpr double kDistancePerDepth = 0.015;
constexpr double kDistancePerRadius = 0.5;

// A noisier camera's readings are near a surface within this many standard deviations: those of two readings.
constexpr double kDistancePerNoise = 3.0;

// A part of the depth, at the image's median depth.
double noise_per_depth(const Scan& image) {
  std::vector<float> depths;
  for (const Vec3f& point : evenly_chosen(image.cloud, kNumWitnesses).points) depths.push_back(point.z());
  return depths.empty() ? 0.0 : kDistancePerNoise * noise_per_depth_sq(image) * upper_median(std::move(depths));
}

Cloud witnesses(const Cloud& cloud) { return evenly_chosen(cloud, kNumWitnesses); }

std::optional<RangeImage> sights_of(const Scan& scan, const Lengths& lengths) {
  return lines_of_sight(scan.cloud, static_cast<float>(kDistancePerRadius * lengths.radius), scan.place_is_known);
}

// Whether a camera, a file or the scan's rays give the place of the sensor. An assumed place may be wrong: from inside
// a model, no point of it lies behind others either.
bool has_known_place(const Scan& scan) { return scan.view || scan.place_is_known || scan.cloud.viewpoint; }

// The same without lines of sight: a point that is hidden from a wrong place may contradict.
std::vector<PointAgreement> without_hidden(std::vector<PointAgreement> said) {
  std::replace(said.begin(), said.end(), PointAgreement::Hidden, PointAgreement::Unseen);
  return said;
}

// Unseen points count as hidden: a camera gives no evidence about what is out of its view, or has no reading.
std::vector<PointAgreement> without_unseen(std::vector<PointAgreement> said) {
  std::replace(said.begin(), said.end(), PointAgreement::Unseen, PointAgreement::Hidden);
  return said;
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

constexpr double kMaxMoveAlongFree = 0.01;  // gyration radii

}  // namespace

AgreementTolerance tolerance_of(const Scan& scan, const Lengths& lengths) {
  if (scan.view) return {.distance = 0.0, .per_depth = std::max(kDistancePerDepth, noise_per_depth(scan))};
  return {.distance = kDistancePerRadius * lengths.radius, .per_depth = 0.0};
}

std::unique_ptr<ScanMatcher> matcher_for(const Scan& scan, bool projective, const Lengths& lengths) {
  if (projective) return std::make_unique<ProjectiveMatcher>(scan.cloud, scan.view->index, scan.view->camera);
  if (scan.view) return std::make_unique<NearestMatcher>(scan.cloud);
  return std::make_unique<NearestMatcher>(scan.cloud, sights_of(scan, lengths));
}

std::unique_ptr<ScanMatcher> matcher_of_source(const ScanPair& pair) {
  return matcher_for(pair.source, pair.source.view.has_value(), pair.lengths);
}

std::optional<Vec3f> sensor_place(const Scan& scan, const Lengths& lengths) {
  if (scan.view) return scan.cloud.viewpoint;
  const auto seen = sights_of(scan, lengths);
  if (!seen) return std::nullopt;
  return seen->place();
}

Judge::Judge(const ScanPair& pair, const ScanMatcher& matcher, const std::optional<Rigid3>& guess_target_from_source,
             const AlignOptions& options, std::unique_ptr<ScanMatcher> source_says)
    : pair_(pair),
      matcher_(matcher),
      guess_target_from_source_(guess_target_from_source),
      options_(options),
      on_source_(tolerance_of(pair.source, pair.lengths)),
      on_target_(tolerance_of(pair.target, pair.lengths)),
      of_source_(witnesses(pair.source.cloud)),
      of_target_(witnesses(pair.target.cloud)),
      target_says_(pair.target.view ? matcher_for(pair.target, true, pair.lengths) : nullptr),
      source_says_(source_says ? std::move(source_says) : matcher_of_source(pair)) {
  const bool know_free_space =
      (target_says_ ? *target_says_ : matcher_).knows_free_space() && source_says_->knows_free_space();
  // A pose that is found without a guess is far from it.
  if (know_free_space && guess_target_from_source) return;
  on_planes_of_source_ = on_large_planes(of_source_, kDistancePerRadius * pair.lengths.radius);
  on_planes_of_target_ = on_large_planes(of_target_, kDistancePerRadius * pair.lengths.radius);
}

Judge::Side Judge::source_in_target() const {
  return {of_source_, on_planes_of_source_, pair_.target, target_says_ ? *target_says_ : matcher_, on_target_};
}

Judge::Side Judge::target_in_source() const {
  return {of_target_, on_planes_of_target_, pair_.source, *source_says_, on_source_};
}

std::vector<PointAgreement> Judge::agreements(const Rigid3& target_from_source) const {
  const int num_threads = options_.num_threads, half = half_of_threads(num_threads);
  const auto said = [&](const Side& side, const Rigid3& pose) {
    return side.other_says.agreements(side.asked, pose, side.on_other, half);
  };
  auto [of_point, back] = both(
      num_threads, [&] { return said(source_in_target(), target_from_source); },
      [&] { return said(target_in_source(), inverse(target_from_source)); });
  of_point.insert(of_point.end(), back.begin(), back.end());
  return of_point;
}

Testimony Judge::testimony(const Side& side, const PosedCloud& other, bool is_far_from_guess, int num_threads) const {
  const auto of_point = side.other_says.agreements(side.asked, other.this_from_asked, side.on_other, num_threads);
  Testimony testimony{counted(of_point), side.other_says.knows_free_space()};
  if (!testimony.knows_free_space || !has_known_place(side.other))
    testimony.contradicting = contradicting_share(side.asked, without_hidden(of_point), other);
  const bool is_asked_near = !on_planes_of_source_.empty();
  // Far from the guess although the free space is known: the planes of another room fit as well.
  if (is_asked_near || is_far_from_guess)
    testimony.off_planes = agreement_off_planes(
        side.other.view ? without_unseen(of_point) : of_point,
        is_asked_near ? side.on_planes : on_large_planes(side.asked, kDistancePerRadius * other.radius));
  return testimony;
}

void Judge::ask_pairs(const Rigid3& target_from_source, int num_threads, Evidence& evidence) const {
  const auto pairs = matcher_.match(of_source_, target_from_source, options_.gates, num_threads);
  const PosedPairs posed{of_source_, pair_.target.cloud, pairs, target_from_source};
  evidence.residuals = residuals(posed);
  evidence.beyond_planes = share_beyond_planes(pair_.target.cloud, agreeing_points(posed, on_target_), on_target_);
}

Evidence Judge::evidence(const Rigid3& target_from_source) const {
  const int num_threads = options_.num_threads, half = half_of_threads(num_threads);
  const double radius = pair_.lengths.radius;
  Evidence evidence;
  evidence.known_part = pair_.known_part;
  evidence.moved = guess_target_from_source_ ? moved(of_source_, *guess_target_from_source_, target_from_source)
                                             : kMovedFromAnywhere;
  const bool is_far = evidence.moved > VerdictLimits{}.max_moved_near_guess;
  const PosedCloud target{of_target_, target_from_source, radius},
      source{of_source_, inverse(target_from_source), radius};
  const std::array<std::function<void()>, 3> tasks{
      [&] { ask_pairs(target_from_source, half, evidence); },  // the longest first
      [&] { evidence.source_in_target = testimony(source_in_target(), target, is_far, half); },
      [&] { evidence.target_in_source = testimony(target_in_source(), source, is_far, half); }};
  for_each_block(
      tasks.size(), num_threads, [&](std::size_t task, std::size_t) { tasks[task](); }, 1);
  return evidence;
}

AlignResult Judge::judged(AlignResult result) const {
  const AlignStatus reached = result.status;
  if (!has_pose(reached)) return result;
  Evidence evidence = this->evidence(result.target_from_source);
  add_last_step(result, pair_.lengths.extent, evidence);
  evidence.observability = result.observability.weakest();
  const Verdict verdict = decide(reached, evidence);
  const bool has_left = guess_target_from_source_ && has_left_along_free(result, *guess_target_from_source_);
  result.status = has_left ? AlignStatus::Doubtful : verdict.status;
  result.doubts = verdict.doubts;
  if (has_left) result.doubts.push_back(Doubt::LeftGuess);
  result.evidence = evidence;
  return result;
}

bool has_left_along_free(const AlignResult& result, const Rigid3& guess_target_from_source) {
  const Vec6d moved = increment_between(guess_target_from_source, result.target_from_source);
  return moved_along(result.observability, static_cast<int>(result.free_motions.size()), moved) > kMaxMoveAlongFree;
}

bool is_supported(const AlignResult& judged) {
  return judged.status == AlignStatus::Converged || (judged.status == AlignStatus::Degenerate && judged.doubts.empty());
}

bool is_better(const AlignResult& judged, const AlignResult& than_judged) {
  if (!judged.evidence || !than_judged.evidence) return judged.evidence.has_value();
  if (is_supported(judged) != is_supported(than_judged)) return is_supported(judged);
  const auto badness = [](const Evidence& evidence) { return std::pair(excess(evidence), strain(evidence)); };
  return badness(*judged.evidence) < badness(*than_judged.evidence);
}

}  // namespace augicp
