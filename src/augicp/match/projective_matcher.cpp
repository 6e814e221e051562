// SPDX-License-Identifier: MIT
#include <algorithm>

#include "augicp/core/parallel.h"
#include "augicp/core/vectorized.h"
#include "augicp/match/agreement_count.h"
#include "augicp/match/matcher.h"
#include "augicp/match/pair_filter.h"
#include "augicp/sensor/projection.h"

namespace augicp {
namespace {

// The point in the pixel of a position in the camera frame; kNone if there is none.
std::int32_t pixel_of(const Vec3f& place, const Pinhole& camera, const IndexImage& index) {
  if (!(place.z() > 0.0f)) return IndexImage::kNone;
  const float u = static_cast<float>(camera.fx) * place.x() / place.z() + static_cast<float>(camera.cx) + 0.5f;
  const float v = static_cast<float>(camera.fy) * place.y() / place.z() + static_cast<float>(camera.cy) + 0.5f;
  const bool is_inside =
      u >= 0.0f && v >= 0.0f && u < static_cast<float>(index.width) && v < static_cast<float>(index.height);
  return is_inside ? index.at(static_cast<int>(u), static_cast<int>(v)) : IndexImage::kNone;
}

// A smaller share of points than this hardly occlude each other, and need no z-buffer.
constexpr std::size_t kPixelsPerSparsePoint = 16;

// Whether all, some or none of these pixels have a point in both images.
enum class Seen { InAll, InSome, InNone };
AUGICP_VECTORIZED Seen seen_in_both(const std::int32_t* __restrict a, const std::int32_t* __restrict b,
                                    std::size_t count) {
  std::int32_t any = 0, every = -1;  // kNone is negative; all indices are not
  for (std::size_t k = 0; k < count; ++k) any |= a[k] | b[k], every &= a[k] | b[k];
  return any >= 0 ? Seen::InAll : every < 0 ? Seen::InNone : Seen::InSome;
}

// The points of both images in at most kGatheredAtOnce pixels that have one in both, pixel by pixel.
void find_candidates(const std::int32_t* a, const std::int32_t* b, std::size_t num_pixels, IndexRuns& of_a,
                     IndexRuns& of_b) {
  std::size_t count = 0;
  const Seen seen = seen_in_both(a, b, num_pixels);
  if (seen == Seen::InAll) {
    std::copy_n(a, num_pixels, of_a.index);
    std::copy_n(b, num_pixels, of_b.index);
    count = num_pixels;
  } else if (seen == Seen::InSome) {
    for (std::size_t k = 0; k < num_pixels; ++k) {  // no branch: it would be unpredictable
      of_a.index[count] = static_cast<std::uint32_t>(a[k]);
      of_b.index[count] = static_cast<std::uint32_t>(b[k]);
      count += (a[k] | b[k]) >= 0 ? 1 : 0;
    }
  }
  of_a.count = of_b.count = count;
  find_runs(of_a);
  find_runs(of_b);
}

}  // namespace

ProjectiveMatcher::ProjectiveMatcher(const Cloud& target, const IndexImage& index, const Pinhole& camera)
    : target_(target), index_(index), camera_(camera) {
  camera.check();
}

std::vector<Correspondence> ProjectiveMatcher::match(const Cloud& source, const Rigid3& target_from_source,
                                                     const Gates& gates, int num_threads) const {
  gates.check();
  const PairFilter filter(source, target_, target_from_source, gates);
  if (source.size() * kPixelsPerSparsePoint < index_.index.size()) return match_points(source, filter);
  const IndexImage seen = project(source, target_from_source, camera_, index_.width, index_.height, num_threads);
  std::vector<std::vector<Correspondence>> of_block((seen.index.size() + kLightBlockSize - 1) / kLightBlockSize);
  const auto match_pixels = [&](std::size_t begin, std::size_t end) {
    std::vector<Correspondence>& pairs = of_block[begin / kLightBlockSize];
    pairs.reserve(end - begin);
    IndexRuns of_source, of_target;
    for (std::size_t pixel = begin; pixel < end; pixel += kGatheredAtOnce) {
      const std::size_t count = std::min(kGatheredAtOnce, end - pixel);
      find_candidates(&seen.index[pixel], &index_.index[pixel], count, of_source, of_target);
      if (of_source.count > 0) filter.append_passing(of_source, of_target, pairs);
    }
  };
  for_each_block(seen.index.size(), num_threads, match_pixels, kLightBlockSize);
  return joined(of_block);
}

std::vector<Correspondence> ProjectiveMatcher::match_points(const Cloud& source, const PairFilter& filter) const {
  std::vector<Correspondence> pairs;
  for (std::uint32_t j = 0; j < source.size(); ++j) {
    const Vec3f moved = filter.moved(j);
    const std::int32_t i = pixel_of(moved, camera_, index_);
    if (i == IndexImage::kNone) continue;
    if (filter.passes(j, moved, static_cast<std::uint32_t>(i))) pairs.push_back({j, static_cast<std::uint32_t>(i)});
  }
  return pairs;
}

std::vector<PointAgreement> ProjectiveMatcher::agreements(const Cloud& source, const Rigid3& target_from_source,
                                                          const AgreementTolerance& tolerance, int num_threads) const {
  tolerance.check();
  const SurfaceTest on_surface(source, target_, target_from_source, tolerance.min_cosine);
  const auto constant = static_cast<float>(tolerance.distance), per_depth = static_cast<float>(tolerance.per_depth);
  std::vector<PointAgreement> of_point(source.size(), PointAgreement::Unseen);
  const auto ask = [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const Vec3f moved = on_surface.moved(j);
      const std::int32_t i = pixel_of(moved, camera_, index_);
      if (i == IndexImage::kNone) continue;
      const float limit = constant + per_depth * moved.z(), behind = moved.z() - target_.points[i].z();
      if (std::abs(behind) > kNearPerTolerance * limit)
        of_point[j] = behind < 0.0f ? PointAgreement::Conflict : PointAgreement::Hidden;
      else
        of_point[j] = on_surface.agrees(j, moved, i, limit) ? PointAgreement::Agree : PointAgreement::Differ;
    }
  };
  for_each_block(source.size(), num_threads, ask, kLightBlockSize);
  return of_point;
}

}  // namespace augicp
