// SPDX-License-Identifier: MIT
#include "augicp/core/parallel.h"
#include "augicp/match/agreement_count.h"
#include "augicp/match/matcher.h"
#include "augicp/match/nearby_poses.h"
#include "augicp/match/pair_filter.h"
#include "augicp/search/nearest_memory.h"

namespace augicp {
namespace {

// find(j, place): the target point nearest to source point j, which the pose moves to that place. Each block has a
// copy, which may remember what it found for the point before: neighbours in memory mostly are neighbours in space.
template <typename Find>
std::vector<Correspondence> match_nearest(const Cloud& source, const PairFilter& filter, int num_threads,
                                          const Find& find) {
  std::vector<std::vector<Correspondence>> of_block((source.size() + kSearchesPerBlock - 1) / kSearchesPerBlock);
  const auto match_block = [&](std::size_t begin, std::size_t end) {
    std::vector<Correspondence>& pairs = of_block[begin / kSearchesPerBlock];
    Find find_in_block = find;
    for (auto j = static_cast<std::uint32_t>(begin); j < end; ++j) {
      const Vec3f moved = filter.moved(j);
      const std::optional<Neighbour> found = find_in_block(j, moved);
      if (found && filter.passes(j, moved, found->index)) pairs.push_back({j, found->index});
    }
  };
  for_each_block(source.size(), num_threads, match_block, kSearchesPerBlock);
  return joined(of_block);
}

class NearestSession final : public MatchSession {
 public:
  NearestSession(const Cloud& source, const Cloud& target, const KdTree& tree)
      : source_(source), target_(target), memory_(tree, source.size()) {}

  std::vector<Correspondence> match(const Rigid3& target_from_source, const Gates& gates, int num_threads) override {
    gates.check();
    const PairFilter filter(source_, target_, target_from_source, gates);
    const auto find = [&, likely = std::optional<std::uint32_t>()](std::uint32_t j, const Vec3f& moved) mutable {
      const auto found = memory_.nearest(j, moved, filter.max_distance_sq(), likely.value_or(j));
      if (found) likely = j;
      return found;
    };
    return match_nearest(source_, filter, num_threads, find);
  }

 private:
  const Cloud& source_;
  const Cloud& target_;
  NearestMemory memory_;
};

// What is said of a point that does not agree. Far from the sensor a ball meets one scan line alone, which looks like
// an edge: a point between two such lines, as far from the sensor as they are, lies where nothing was measured.
PointAgreement off_surface(Sight sight, bool is_near, bool is_near_edge) {
  if (sight == Sight::Free) return PointAgreement::Conflict;
  if (sight == Sight::Hidden) return PointAgreement::Hidden;
  if (sight == Sight::AtSurface && is_near_edge) return PointAgreement::Unseen;
  return is_near ? PointAgreement::Differ : PointAgreement::Unseen;
}

}  // namespace

NearestMatcher::NearestMatcher(const Cloud& target, std::optional<RangeImage> lines_of_sight)
    : target_(target), tree_(target), lines_of_sight_(std::move(lines_of_sight)) {}

std::vector<Correspondence> NearestMatcher::match(const Cloud& source, const Rigid3& target_from_source,
                                                  const Gates& gates, int num_threads) const {
  gates.check();
  const PairFilter filter(source, target_, target_from_source, gates);
  const auto find = [&, likely = std::uint32_t{0}](std::uint32_t, const Vec3f& moved) mutable {
    const auto found = tree_.nearest(moved, filter.max_distance_sq(), likely);
    if (found) likely = found->index;
    return found;
  };
  return match_nearest(source, filter, num_threads, find);
}

std::unique_ptr<MatchSession> NearestMatcher::session(const Cloud& source) const {
  return std::make_unique<NearestSession>(source, target_, tree_);
}

std::vector<std::vector<Correspondence>> NearestMatcher::match_each(const Cloud& source, std::span<const Rigid3> poses,
                                                                    const Gates& gates, int num_threads) const {
  return match_nearby(source, target_, tree_, poses, gates, num_threads);
}

std::vector<PointAgreement> NearestMatcher::agreements(const Cloud& source, const Rigid3& target_from_source,
                                                       const AgreementTolerance& tolerance, int num_threads) const {
  tolerance.check();
  const SurfaceTest on_surface(source, target_, target_from_source, tolerance.min_cosine);
  const auto limit = static_cast<float>(tolerance.distance);
  const float reach = kNearPerTolerance * limit;
  std::vector<PointAgreement> of_point(source.size());
  const auto is_edge = [&](std::size_t i) {
    return target_.has_directions() && target_.structures[i] == Structure::Edge;
  };
  const auto ask = [&](std::size_t begin, std::size_t end) {
    std::uint32_t likely = 0;
    for (std::size_t j = begin; j < end; ++j) {
      const Vec3f moved = on_surface.moved(j);
      const auto found = tree_.nearest(moved, reach * reach, likely);
      if (found) likely = found->index;
      of_point[j] = found && on_surface.agrees(j, moved, found->index, limit)
                        ? PointAgreement::Agree
                        : off_surface(lines_of_sight_ ? lines_of_sight_->sight(moved, limit) : Sight::OutOfView,
                                      found.has_value(), found && is_edge(found->index));
    }
  };
  for_each_block(source.size(), num_threads, ask);
  return of_point;
}

}  // namespace augicp
