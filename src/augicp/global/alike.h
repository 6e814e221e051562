// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "augicp/cloud/correspondence.h"
#include "augicp/global/descriptors.h"

namespace augicp {

// Pairs of points with similar descriptors: of each source point the most similar target point, and of each target
// point the most similar source point; each pair once, in ascending order. All are compared with all. The result is
// bit-identical for any number of threads.
std::vector<Correspondence> alike_pairs(const KeyPoints& source, const KeyPoints& target, int num_threads);

}  // namespace augicp
