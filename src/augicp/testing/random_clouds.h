// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/correspondence.h"

namespace augicp::testing {

// Points uniform in a cube about zero, without directions.
Cloud random_points(std::size_t count, double half_extent_m, unsigned seed);

// The same with random directions, Gaussians, and weights in (0.1, 1], with all structures in turn, and a viewpoint.
// The directions and Gaussians are unrelated to any surface or to the viewpoint: for laws that must be true for any.
Cloud random_extended_points(std::size_t count, double half_extent_m, unsigned seed);

// Random pairs: any source point of num_points with any target point of num_points.
std::vector<Correspondence> random_pairs(std::size_t num_pairs, std::size_t num_points, unsigned seed);

}  // namespace augicp::testing
