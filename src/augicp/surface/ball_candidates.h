// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// Points among which the neighbours of several others are looked for, as arrays, so that compilers make vectors of
// their distances.
class BallCandidates {
 public:
  // To be filled; then read() fetches the points.
  std::vector<std::uint32_t>& index() { return index_; }
  void read(const Cloud& cloud);

  // Appends those nearer to the centre than the square root of radius_sq, in the same order; says how many they are.
  std::size_t append_in_ball(const Vec3f& centre, float radius_sq, std::vector<std::uint32_t>& neighbours);

 private:
  std::vector<std::uint32_t> index_;
  std::vector<float> x_, y_, z_, distance_sq_;
};

}  // namespace augicp
