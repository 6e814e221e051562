// SPDX-License-Identifier: MIT
// Arrays in the form that the page reads: little-endian numbers, deflated (RFC 1950), in base64. Numbers are stored by
// planes: the low bytes of all values before their high bytes, so that what is alike lies together.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "augicp/core/types.h"

namespace augicp::app {

// Points in 16 bits an axis, in steps of 1/65535 of the extent of nearly all of them. Points that are far from the
// others have coarser steps and coarsen at most 1023 others. uint32 count; for each 1024 points the least coordinates
// and the step, four float32; then the planes of x, y and z, as differences from the point before in the same 1024.
std::string packed_points(std::span<const Vec3f> points);

// 1/32767 of the largest magnitude, which is the first float32; then the planes of int16; -32768 stands for NaN.
std::string packed_numbers(std::span<const float> values);

// Two int8 per direction, on the octahedron of unit directions: within a degree, which is not visible. Two zeros for
// zero.
std::string packed_directions(std::span<const Vec3f> directions);

std::string packed_bytes(std::span<const std::uint8_t> bytes);

}  // namespace augicp::app
