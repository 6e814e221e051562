// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/correspondence.h"

namespace augicp::testing {

// Points uniform in a cube about zero, without directions.
Cloud random_points(std::size_t count, double half_extent_m, unsigned seed);

// The same with random directions and weights in (0.1, 1], every structure by turns, and a viewpoint. Nothing ties the
// directions to a surface or to the viewpoint: for what must hold whatever they are.
Cloud random_extended_points(std::size_t count, double half_extent_m, unsigned seed);

// Any source point of num_points with any target point of as many.
std::vector<Correspondence> random_pairs(std::size_t num_pairs, std::size_t num_points, unsigned seed);

}  // namespace augicp::testing
