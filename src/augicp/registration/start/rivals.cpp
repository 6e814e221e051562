// SPDX-License-Identifier: MIT
#include "augicp/registration/start/rivals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/angles.h"
#include "augicp/geometry/rotation.h"
#include "augicp/registration/start/lead_on.h"
#include "augicp/registration/start/repeated_rotations.h"
#include "augicp/registration/thin_scan.h"

namespace augicp {
namespace {

// A few iterations tell which starts are worth leading on.
constexpr int kFirstIterations = 3, kIterations = 20;
constexpr std::size_t kMaxRivalsLedOn = 4;

// On few points a pose that fits as well is less plausible than the one found by chance, but not by more than this.
constexpr double kLessPlausible = 0.2;

// More iterations rarely make a start more plausible by more than this: after the first ones 83 rivals of 128 searches
// were at most 0.26 less plausible than the pose found (docs/lab/performance.md).
constexpr double kMaxGain = 0.2;
constexpr std::size_t kMaxRivals = 3;

constexpr std::size_t kEnoughPoints = 1000;

constexpr std::size_t kNumNormals = 512;  // that vote for the axes
const double kAlike = std::cos(10.0 * kRadPerDeg), kAcross = std::sin(10.0 * kRadPerDeg);

// What a few outliers add to a scene's bounds moves its centre.
constexpr double kBoundsQuantile = 0.01;

// Parts of the extent. A start within a quarter of a period finds a repetition.
constexpr double kShifts[] = {-0.3, -0.15, 0.15, 0.3};

constexpr std::size_t kNumCounted = 8192;                 // points, for what repeats itself
const double kQuarterTurns = std::sin(5.0 * kRadPerDeg);  // rotations within 2.5 degrees of one are tried anyway

std::vector<Vec3d> normals_of(const Cloud& cloud) {
  std::vector<Vec3d> normals;
  const Cloud few = evenly_chosen(cloud, kNumNormals);
  for (std::size_t i = 0; i < few.size() && few.has_directions(); ++i)
    if (few.structures[i] == Structure::Planar) normals.push_back(few.directions[i].cast<double>());
  return normals;
}

// The normal that most others share, whatever their signs; zero if there is none.
Vec3d most_shared(const std::vector<Vec3d>& normals) {
  Vec3d best = Vec3d::Zero();
  std::size_t num_best = 0;
  for (const Vec3d& axis : normals) {
    std::size_t count = 0;
    Vec3d sum = Vec3d::Zero();
    for (const Vec3d& normal : normals) {
      const double cosine = axis.dot(normal);
      if (std::abs(cosine) < kAlike) continue;
      ++count;
      sum += cosine > 0.0 ? normal : Vec3d(-normal);
    }
    if (count <= num_best) continue;
    num_best = count;
    best = sum.normalized();
  }
  return best;
}

// The middle between the bounds along the axes.
Vec3d centre_of(const Cloud& cloud, const Mat3d& axes) {
  Vec3d centre = Vec3d::Zero();
  std::vector<double> along(cloud.size());
  const auto tail = static_cast<std::ptrdiff_t>(kBoundsQuantile * static_cast<double>(cloud.size() - 1));
  for (int k = 0; k < 3; ++k) {
    std::transform(cloud.points.begin(), cloud.points.end(), along.begin(),
                   [&](const Vec3f& point) { return axes.col(k).dot(point.cast<double>()); });
    std::nth_element(along.begin(), along.begin() + tail, along.end());
    const double low = along[static_cast<std::size_t>(tail)];
    std::nth_element(along.begin(), along.end() - 1 - tail, along.end());
    centre += 0.5 * (low + *(along.end() - 1 - tail)) * axes.col(k);
  }
  return centre;
}

Rigid3 rotated(const Rigid3& pose, const RotationAxis& axis, double angle) {
  const Eigen::Quaterniond rotation = rotation_exp(angle * axis.direction);
  return Rigid3{rotation, axis.place - rotation * axis.place} * pose;
}

// By one of five bosses, or by a tooth. Both ways: one of the bosses may be missing.
void add_repeated(const Cloud& target, const RotationAxis& axis, const Rigid3& found, std::vector<Rigid3>& starts) {
  std::vector<RepeatedRotation> all = repeated_rotations(target, axis);
  std::erase_if(all, [](const auto& rotation) { return std::abs(std::sin(2.0 * rotation.angle)) < kQuarterTurns; });
  if (all.empty()) return;
  const auto smallest =
      std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.angle < b.angle; });
  for (const double angle : {all.front().angle, smallest->angle})
    for (const double sign : {1.0, -1.0}) starts.push_back(rotated(found, axis, sign * angle));
}

// target: on few points, for its axes; whole: all of its points.
std::vector<Rigid3> rival_starts(const Cloud& target, const Cloud& whole, const Rigid3& found, double extent) {
  const Mat3d axes = scene_axes(target);
  const Vec3d centre = centre_of(target, axes);
  std::vector<Rigid3> starts;
  for (int k = 0; k < 3; ++k) {
    const Vec3d axis = axes.col(k);
    for (const double angle : {0.5 * std::numbers::pi, std::numbers::pi, -0.5 * std::numbers::pi})
      starts.push_back(rotated(found, {centre, axis}, angle));
    for (const double shift : kShifts)
      starts.push_back(Rigid3{Eigen::Quaterniond::Identity(), shift * extent * axis} * found);
  }
  const Cloud counted = evenly_chosen(whole, kNumCounted);
  const RotationAxis principal = principal_axis(target);  // which is evenly dense
  add_repeated(counted, principal, found, starts);
  if (std::abs(principal.direction.dot(axes.col(0))) < kAlike)  // of a scan from one side
    add_repeated(counted, {principal.place, axes.col(0)}, found, starts);
  return starts;
}

// Objects keep few points in the voxels of a search, and their legs and walls are thinner than these.
PreparedPair on_enough_points(const ScanPair& pair, int num_threads) {
  PreparedPair coarse = coarser(pair, kCoarseColumns, kCoarseVoxels, num_threads);
  if (std::min(coarse.source.cloud.size(), coarse.target.cloud.size()) >= kEnoughPoints) return coarse;
  return coarser(pair, kCoarseColumns, 0.5 * kCoarseVoxels, num_threads);
}

void erase_hopeless(std::vector<Hypothesis>& hypotheses, double least_plausible) {
  std::erase_if(hypotheses, [&](const Hypothesis& rival) { return rival.plausibility < least_plausible; });
}

// Where the starts lead that are worth it after the first iterations.
std::vector<Hypothesis> led_rivals(const ScanMatch& match, const std::vector<Rigid3>& starts, const KnowsPose& is_back,
                                   double least_plausible) {
  AlignOptions by = match.usual_options();
  by.max_iterations = kFirstIterations;
  auto begun = scouted(match, starts, by, is_back);
  erase_hopeless(begun, least_plausible - kMaxGain);
  std::vector<Rigid3> best;
  for (const Hypothesis& start : best_of(std::move(begun), kMaxRivalsLedOn, match.scans().lengths.radius, kSameAngle))
    best.push_back(start.target_from_source);
  by.max_iterations = kIterations;
  return scouted(match, best, by, is_back);
}

}  // namespace

bool differ_clearly(const Cloud& source, const Rigid3& a, const Rigid3& b, double limit) {
  const Mat3d turned = a.rotation.toRotationMatrix() - b.rotation.toRotationMatrix();
  const Vec3d shifted = a.translation - b.translation;
  double moved_sq = 0.0;
  for (const Vec3f& point : source.points) moved_sq += (turned * point.cast<double>() + shifted).squaredNorm();
  return moved_sq > limit * limit * static_cast<double>(source.size());
}

Mat3d scene_axes(const Cloud& cloud) {
  std::vector<Vec3d> normals = normals_of(cloud);
  const Vec3d first = most_shared(normals);
  std::erase_if(normals, [&](const Vec3d& normal) { return std::abs(normal.dot(first)) > kAcross; });
  const Vec3d second = most_shared(normals);
  if (first.isZero() || second.isZero()) return Mat3d::Identity();
  Mat3d axes;
  axes.col(0) = first;
  axes.col(1) = (second - first.dot(second) * first).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

std::vector<Rigid3> search_rivals(const ScanPair& pair, const Rigid3& found_target_from_source,
                                  const RegistrationOptions& options) {
  const PreparedPair coarse = on_enough_points(pair, options.num_threads);
  const ScanMatch match(coarse, options);
  const auto is_back = [&](const Rigid3& pose) {  // where most starts lead, and soon
    return !differ_clearly(coarse.source.cloud, pose, found_target_from_source,
                           kClearlyPerRadius * pair.lengths.radius);
  };
  const double least = match.plausibility(found_target_from_source, options.num_threads) - kLessPlausible;
  const std::vector<Rigid3> starts =
      rival_starts(coarse.target.cloud, pair.target.cloud, found_target_from_source, pair.lengths.extent);
  // Few points may lose a start that fits: where legs are thin. So the starts themselves are rivals, too.
  auto led = led_rivals(match, starts, is_back, least), unmoved = as_they_are(match, starts, options.num_threads);
  std::vector<Rigid3> rivals;
  for (std::vector<Hypothesis>* some : {&led, &unmoved}) {
    erase_hopeless(*some, least);
    for (const Hypothesis& rival : best_of(std::move(*some), kMaxRivals, pair.lengths.radius, kSameAngle))
      rivals.push_back(rival.target_from_source);
  }
  return rivals;
}

}  // namespace augicp
