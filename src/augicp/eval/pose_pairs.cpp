// SPDX-License-Identifier: MIT
#include "augicp/eval/pose_pairs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// The progress of each pose along the trajectory; never decreasing.
std::vector<double> progress_of(std::span<const MatchedPose> poses, DeltaUnit unit) {
  std::vector<double> progress(poses.size(), 0.0);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (unit == DeltaUnit::Frames) progress[i] = static_cast<double>(i);
    if (unit == DeltaUnit::Seconds) progress[i] = poses[i].stamp_s;
    if (unit == DeltaUnit::Metres && i > 0)
      progress[i] = progress[i - 1] + (poses[i].truth.translation - poses[i - 1].truth.translation).norm();
  }
  return progress;
}

// The first pose after begin that is at least a distance away from it; progress.size() if there is none.
std::size_t first_at(std::span<const double> progress, std::size_t begin, double distance) {
  const auto is_before = [&](double value) { return value - progress[begin] < distance; };
  const auto behind = progress.begin() + static_cast<std::ptrdiff_t>(begin) + 1;
  return static_cast<std::size_t>(std::partition_point(behind, progress.end(), is_before) - progress.begin());
}

// The pose after begin whose distance from it is nearest to delta; empty after the last pose.
std::optional<std::size_t> nearest_to(std::span<const double> progress, std::size_t begin, double delta) {
  const auto distance = [&](std::size_t i) { return progress[i] - progress[begin]; };
  const std::size_t above = first_at(progress, begin, delta);
  if (above == begin + 1) return above < progress.size() ? std::optional(above) : std::nullopt;
  const std::size_t below =
      first_at(progress, begin, distance(above - 1));  // the first pose while the camera stands still
  const bool above_is_nearer = above < progress.size() && distance(above) - delta < delta - distance(below);
  return above_is_nearer ? above : below;
}

std::vector<PosePair> from_every_pose(std::span<const double> progress, double delta, double tolerance) {
  std::vector<PosePair> pairs;
  for (std::size_t i = 0; i < progress.size(); ++i)
    if (const auto j = nearest_to(progress, i, delta))
      if (std::abs(progress[*j] - progress[i] - delta) <= tolerance) pairs.push_back({i, *j});
  return pairs;
}

std::vector<PosePair> one_after_the_other(std::span<const double> progress, double delta) {
  std::vector<PosePair> pairs;
  if (progress.empty()) return pairs;
  std::size_t begin = 0;
  for (std::size_t end; (end = first_at(progress, begin, delta)) < progress.size(); begin = end)
    pairs.push_back({begin, end});
  return pairs;
}

}  // namespace

void DeltaOptions::check() const {
  require_positive("delta", delta);
  require(unit != DeltaUnit::Frames || delta == std::floor(delta), "delta", delta, "must be a whole number of frames");
}

std::vector<PosePair> pairs_at_delta(std::span<const MatchedPose> poses, const DeltaOptions& options) {
  options.check();
  constexpr double kTolerance = 0.1;
  const std::vector<double> progress = progress_of(poses, options.unit);
  if (options.consecutive) return one_after_the_other(progress, options.delta);
  return from_every_pose(progress, options.delta, options.unit == DeltaUnit::Frames ? 0.0 : kTolerance * options.delta);
}

}  // namespace augicp
