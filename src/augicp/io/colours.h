// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "augicp/io/cloud_file.h"
#include "augicp/io/write_cloud.h"

namespace augicp {

// The colour of each point of a file, in the order of the points; empty if it has none, or was read without
// ReadOptions::keep_fields. Colours are columns red, green and blue, or PCL's packed rgb or rgba, in either case.
//
// Bytes are taken as they are. Other numbers state no unit, so the largest of all tells it: up to 1 in floating-point
// columns they are shares, up to 255 bytes, and beyond that integers of 16 bits, as in LAS. NaN becomes 0.
std::vector<Colour> colours_of(const CloudFile& file);

// The bytes of numbers under the same rule; channel(i, k) is number k of point i.
std::vector<Colour> colours_from(std::size_t count, bool is_floating,
                                 const std::function<double(std::size_t, std::size_t)>& channel);

}  // namespace augicp
