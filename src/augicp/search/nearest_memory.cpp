// SPDX-License-Identifier: MIT
#include "augicp/search/nearest_memory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace augicp {
namespace {

// Distances have a relative error of about 3e-7, except if their squares leave the range of float.
constexpr float kSure = 1.0f - 1e-5f, kShortest = 1e-15f, kLongest = 1e18f;

// Searches reach this much farther than is asked: a query without a point in reach is not searched for again until it
// has moved by a part of the difference.
constexpr float kReach = 1.2f;

// Whether a point at `distance` is closer to the query than every point that was beyond `others_beyond` before the
// query moved.
bool is_surely_nearer(float distance, float others_beyond, float moved) {
  return others_beyond > kShortest && distance + moved < kSure * others_beyond;
}

bool is_before(const Neighbour& a, const Neighbour& b) {
  return std::tie(a.distance_sq, a.index) < std::tie(b.distance_sq, b.index);
}

}  // namespace

Neighbour NearestMemory::nearest_known(const Known& known, const Vec3f& place) const {
  Neighbour nearest{kNone, std::numeric_limits<float>::infinity()};
  for (const std::uint32_t index : known.nearest)
    if (index != kNone) nearest = std::min(nearest, {index, tree_.distance_sq(place, index)}, is_before);
  return nearest;
}

std::optional<Neighbour> NearestMemory::nearest(std::size_t query, const Vec3f& place, float max_distance_sq,
                                                std::size_t likely) {
  Known& known = known_[query];
  const Neighbour nearest = nearest_known(known, place);
  const float nearest_sq = std::min(nearest.distance_sq, max_distance_sq), moved = (place - known.place).norm();
  if (is_surely_nearer(std::sqrt(nearest_sq), known.others_beyond, moved))
    return nearest.distance_sq < max_distance_sq ? std::optional(nearest) : std::nullopt;
  const bool is_known = known.nearest.back() != kNone;
  const float reach_sq = kReach * kReach * max_distance_sq;
  const NearestFew found = tree_.nearest_few(place, reach_sq, is_known ? known.nearest : known_[likely].nearest);
  for (std::size_t k = 0; k < kFew; ++k) known.nearest[k] = found[k] ? found[k]->index : kNone;
  const float beyond_sq = found.back() ? found.back()->distance_sq : reach_sq;
  known.others_beyond = std::min(std::sqrt(beyond_sq), kLongest);
  known.place = place;
  return found.front() && found.front()->distance_sq < max_distance_sq ? found.front() : std::nullopt;
}

}  // namespace augicp
