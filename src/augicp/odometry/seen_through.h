// SPDX-License-Identifier: MIT
// Which surfaces of a map are gone: a scan has measured what lies behind them, along rays that cross them.
#pragma once

#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// The planes of `surfaces` (one a voxel) that several rays of the scan cross near their point and leave far behind,
// and on which no ray ends; ascending indices. Surfaces that nearer ones hide, and edges, are not among them.
//
// scan: in the sensor's frame, its rays begin at zero. voxel_size: metres. The result depends on the clouds alone.
std::vector<std::uint32_t> seen_through(const Cloud& surfaces, const Cloud& scan, const Rigid3& map_from_scan,
                                        double voxel_size);

}  // namespace augicp
