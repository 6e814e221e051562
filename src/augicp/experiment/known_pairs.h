// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/correspondence.h"

namespace augicp {

struct KnownPairsOptions {
  std::size_t num_points = 20000;
  double outlier_share = 0.0;     // of the pairs, in [0, 1]: these get a target drawn at random
  double point_noise_m = 0.0;     // standard deviation of each coordinate
  double normal_noise_rad = 0.0;  // standard deviation of the angle by which a direction is turned, about a random axis
  unsigned seed = 1;
};

// Table 4 in small: the pairs are known, so that only the objective and the solver are under test.
struct KnownPairs {
  Cloud source;
  Cloud target;
  std::vector<Correspondence> pairs;  // one for each source point, in order
  Rigid3 target_from_source;          // 30 degrees and 1 m, about axes drawn from the seed
};

// A room of 10 x 8 x 3 m about the origin of the target frame: of its points 70 % lie on walls, with normals to the
// inside, 20 % on the room's edges, with tangents of random sign, and 10 % anywhere, without direction. Both clouds
// have noise of their own.
KnownPairs make_known_pairs(const KnownPairsOptions& options);

}  // namespace augicp
