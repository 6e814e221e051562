// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// The points among which the neighbours of several others are searched, as arrays, so that compilers vectorise their
// distances.
class BallCandidates {
 public:
  // Fill this, then read() fetches the points.
  std::vector<std::uint32_t>& index() { return index_; }
  void read(const Cloud& cloud);

  // Appends the candidates closer to the centre than the square root of radius_sq, in their order, and returns their
  // number.
  std::size_t append_in_ball(const Vec3f& centre, float radius_sq, std::vector<std::uint32_t>& neighbours);

 private:
  std::vector<std::uint32_t> index_;
  std::vector<float> x_, y_, z_, distance_sq_;
};

}  // namespace augicp
