// SPDX-License-Identifier: MIT
#include "augicp/search/nearest_memory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace augicp {
namespace {

// Distances are known to some 3e-7 of their length, but where their squares leave the range of float.
constexpr float kSure = 1.0f - 1e-5f, kShortest = 1e-15f, kLongest = 1e18f;

// Is a point at `distance` nearer to where the query is now than all that were beyond `others_beyond` of where it was?
bool is_surely_nearer(float distance, float others_beyond, float moved) {
  return others_beyond > kShortest && distance + moved < kSure * others_beyond;
}

}  // namespace

std::optional<Neighbour> NearestMemory::nearest(std::size_t query, const Vec3f& place, float max_distance_sq,
                                                std::size_t likely) {
  Known& known = known_[query];
  const bool is_known = known.nearest[0] != kNone;
  Neighbour same{known.nearest[0], std::numeric_limits<float>::infinity()};
  if (is_known) same.distance_sq = tree_.distance_sq(place, same.index);
  const float nearest_sq = std::min(same.distance_sq, max_distance_sq), moved = (place - known.place).norm();
  if (is_surely_nearer(std::sqrt(nearest_sq), known.others_beyond, moved))
    return same.distance_sq < max_distance_sq ? std::optional(same) : std::nullopt;
  const NearestTwo found = tree_.nearest_two(place, max_distance_sq, is_known ? known.nearest : known_[likely].nearest);
  const auto index_of = [](const std::optional<Neighbour>& point) { return point ? point->index : kNone; };
  const float next_sq = found.next ? found.next->distance_sq : max_distance_sq;
  known = {place, {index_of(found.nearest), index_of(found.next)}, std::min(std::sqrt(next_sq), kLongest)};
  return found.nearest;
}

}  // namespace augicp
