// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/lengths.h"

namespace augicp {

// The radius that goes with a given voxel size, metres: four voxels, or four times the spacing of the points if they
// are sparser than that, but then at most the derived radius. Depth images are not downsampled: the derived radius.
double radius_for(double voxel_size, const Scan& source, const Scan& target, const Lengths& derived,
                  int num_threads = 1);

}  // namespace augicp
