// SPDX-License-Identifier: MIT
#include "augicp/match/nearby_poses.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "augicp/core/parallel.h"
#include "augicp/match/pair_filter.h"

namespace augicp {
namespace {

// Distances have a relative error of about 3e-7, except if their squares leave the range of float.
constexpr float kSure = 1.0f + 1e-5f, kShortest = 1e-15f, kLongest = 1e18f;

constexpr std::uint32_t kNoPoint = UINT32_MAX;

// Finds the nearest points to several places near each other.
class PlacesSearch {
 public:
  PlacesSearch(const KdTree& tree, float max_distance_sq) : tree_(tree), max_distance_sq_(max_distance_sq) {}

  // For each place the nearest target point at a squared distance below the limit; kNoPoint if there is none.
  const std::vector<std::uint32_t>& nearest(std::span<const Vec3f> places);

 private:
  bool find_candidates(const Vec3f& middle, float moved);
  std::uint32_t nearest_candidate(const Vec3f& place) const;
  std::uint32_t nearest_of_all(const Vec3f& place) const;

  const KdTree& tree_;
  float max_distance_sq_;
  std::uint32_t likely_ = 0;
  std::vector<std::uint32_t> candidates_, nearest_;
};

// All points that may be nearest to a place within `moved` of the middle. The one that is nearest to the middle is at
// most d + moved from the place, so the nearest to the place is at most d + 2 moved from the middle. False if distances
// are too large or too small for float.
bool PlacesSearch::find_candidates(const Vec3f& middle, float moved) {
  candidates_.clear();
  const float reach = kSure * (std::sqrt(max_distance_sq_) + moved);
  if (!(reach < kLongest)) return false;
  const std::optional<Neighbour> first = tree_.nearest(middle, reach * reach, likely_);
  if (!first) return reach > kShortest;
  likely_ = first->index;
  const float within = std::min(reach, kSure * (std::sqrt(first->distance_sq) + 2.0f * moved));
  if (!(within > kShortest)) return false;
  tree_.append_within(middle, kSure * within * within, candidates_);
  return true;
}

std::uint32_t PlacesSearch::nearest_candidate(const Vec3f& place) const {
  Neighbour nearest{kNoPoint, max_distance_sq_};
  for (const std::uint32_t index : candidates_) {
    const float distance_sq = tree_.distance_sq(place, index);
    const bool is_nearer = distance_sq < nearest.distance_sq ||
                           (distance_sq == nearest.distance_sq && nearest.index != kNoPoint && index < nearest.index);
    if (is_nearer) nearest = {index, distance_sq};
  }
  return nearest.index;
}

std::uint32_t PlacesSearch::nearest_of_all(const Vec3f& place) const {
  const std::optional<Neighbour> found = tree_.nearest(place, max_distance_sq_);
  return found ? found->index : kNoPoint;
}

const std::vector<std::uint32_t>& PlacesSearch::nearest(std::span<const Vec3f> places) {
  Vec3f middle = Vec3f::Zero();
  for (const Vec3f& place : places) middle += place / static_cast<float>(places.size());
  float moved_sq = 0.0f;
  for (const Vec3f& place : places) moved_sq = std::max(moved_sq, (place - middle).squaredNorm());
  const bool are_candidates = find_candidates(middle, std::sqrt(moved_sq));
  nearest_.clear();
  for (const Vec3f& place : places)
    nearest_.push_back(are_candidates ? nearest_candidate(place) : nearest_of_all(place));
  return nearest_;
}

}  // namespace

std::vector<std::vector<Correspondence>> match_nearby(const Cloud& source, const Cloud& target, const KdTree& tree,
                                                      std::span<const Rigid3> poses, const Gates& gates,
                                                      int num_threads) {
  gates.check();
  if (poses.empty()) return {};
  std::vector<PairFilter> filters;
  for (const Rigid3& pose : poses) filters.emplace_back(source, target, pose, gates);
  const std::size_t num_blocks = (source.size() + kSearchesPerBlock - 1) / kSearchesPerBlock;
  using Blocks = std::vector<std::vector<Correspondence>>;
  std::vector<Blocks> of_pose(poses.size(), Blocks(num_blocks));
  const auto match_block = [&](std::size_t begin, std::size_t end) {
    PlacesSearch search(tree, filters.front().max_distance_sq());
    std::vector<Vec3f> places(poses.size());
    for (auto j = static_cast<std::uint32_t>(begin); j < end; ++j) {
      for (std::size_t k = 0; k < poses.size(); ++k) places[k] = filters[k].moved(j);
      const std::vector<std::uint32_t>& nearest = search.nearest(places);
      for (std::size_t k = 0; k < poses.size(); ++k)
        if (nearest[k] != kNoPoint && filters[k].passes(j, places[k], nearest[k]))
          of_pose[k][begin / kSearchesPerBlock].push_back({j, nearest[k]});
    }
  };
  for_each_block(source.size(), num_threads, match_block, kSearchesPerBlock);
  std::vector<std::vector<Correspondence>> pairs;
  pairs.reserve(of_pose.size());
  for (const Blocks& blocks : of_pose) pairs.push_back(joined(blocks));
  return pairs;
}

}  // namespace augicp
