// SPDX-License-Identifier: MIT
#include "augicp/experiment/fragments.h"

#include <algorithm>
#include <stdexcept>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/check.h"
#include "augicp/experiment/pose_error.h"
#include "augicp/search/kd_tree.h"

namespace augicp {
namespace {

// More points than that say nothing more about an overlap.
constexpr std::size_t kMaxCompared = 5000;

std::optional<Rigid3> pose_of(const DepthSequence& sequence, std::size_t frame, double offset_s) {
  return pose_at(*sequence.truth, sequence.frames[frame].stamp_s + offset_s, kMaxTruthGap_s);
}

std::optional<Fragment> fused(const DepthSequence& sequence, const DepthCamera& camera, std::size_t first,
                              const FragmentOptions& options) {
  const auto begin = sequence.frames.begin() + static_cast<std::ptrdiff_t>(first);
  DepthSequenceReader reader({begin, begin + static_cast<std::ptrdiff_t>(options.frames_each)}, sequence.depth_scale);
  std::optional<Fragment> fragment;
  for (std::size_t k = first; const auto frame = reader.next(); ++k) {
    const auto world_from_camera = pose_of(sequence, k, options.time_offset_s);
    if (!frame->problem.empty() || !world_from_camera) continue;
    if (!fragment) fragment = Fragment{first, {}, *world_from_camera};
    const DepthRange range{.max = options.max_depth};
    const Cloud seen = scan_of(frame->image, camera, options.pixel_step, range).cloud;
    const Rigid3f moves(inverse(fragment->world_from_fragment) * *world_from_camera);
    for (const Vec3f& point : seen.points) fragment->cloud.points.push_back(moves * point);
  }
  if (!fragment || fragment->cloud.empty()) return std::nullopt;
  fragment->cloud = downsample(fragment->cloud, options.voxel_size);
  return fragment;
}

double share_near(const Cloud& source, const KdTree& target, const Rigid3& target_from_source, double distance) {
  const Cloud compared = evenly_chosen(source, kMaxCompared);
  const Rigid3f moves(target_from_source);
  const auto distance_sq = static_cast<float>(distance * distance);
  const auto count = std::count_if(compared.points.begin(), compared.points.end(),
                                   [&](const Vec3f& point) { return target.nearest(moves * point, distance_sq); });
  return static_cast<double>(count) / static_cast<double>(compared.size());
}

}  // namespace

void FragmentOptions::check() const {
  require(frames_each >= 1, "frames_each", static_cast<double>(frames_each), "must be at least 1");
  require(every >= 1, "every", static_cast<double>(every), "must be at least 1");
  require(pixel_step >= 1, "pixel_step", pixel_step, "must be at least 1");
  require_positive("max_depth", max_depth);
  require_positive("voxel_size", voxel_size);
}

std::vector<Fragment> fragments_of(const DepthSequence& sequence, const DepthCamera& camera,
                                   const FragmentOptions& options) {
  options.check();
  if (!sequence.truth) throw std::invalid_argument("a sequence without true poses has no fragments");
  std::vector<Fragment> fragments;
  for (std::size_t first = 0; first + options.frames_each <= sequence.frames.size(); first += options.every)
    if (auto fragment = fused(sequence, camera, first, options)) fragments.push_back(std::move(*fragment));
  return fragments;
}

double overlap_of(const Cloud& source, const Cloud& target, const Rigid3& target_from_source, double distance) {
  if (source.empty() || target.empty()) return 0.0;
  const Rigid3 pose = without_origins(target_from_source, source, target);
  return std::min(share_near(source, KdTree(target), pose, distance),
                  share_near(target, KdTree(source), inverse(pose), distance));
}

}  // namespace augicp
