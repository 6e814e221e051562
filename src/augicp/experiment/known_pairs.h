// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/correspondence.h"

namespace augicp {

struct KnownPairsOptions {
  std::size_t num_points = 20000;
  double outlier_share = 0.0;  // share of the pairs, in [0, 1], that get a random target
  double point_noise_m = 0.0;  // standard deviation of each coordinate
  double normal_noise_rad =
      0.0;  // standard deviation of the angle by which a direction is rotated, about a random axis
  unsigned seed = 1;
};

// A small version of Table 4: the pairs are known, so that only the objective and the solver are tested.
struct KnownPairs {
  Cloud source;
  Cloud target;
  std::vector<Correspondence> pairs;  // one per source point, in order
  Rigid3 target_from_source;          // 30 degrees and 1 m, about axes drawn from the seed
};

// A room of 10 x 8 x 3 m about the origin of the target frame. 70 % of its points are on walls, with normals to the
// inside, 20 % on the edges of the room, with tangents of random sign, and 10 % anywhere, without direction. The noise
// of the two clouds is independent.
KnownPairs make_known_pairs(const KnownPairsOptions& options);

}  // namespace augicp
