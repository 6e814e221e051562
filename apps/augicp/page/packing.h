// SPDX-License-Identifier: MIT
// Arrays in the form that the page reads: base64 of little-endian numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "augicp/core/types.h"

namespace augicp::app {

// Three float32 per point.
std::string packed_points(std::span<const Vec3f> points);

// Three int8 per direction, 127 for 1: within half a degree, which is not visible.
std::string packed_directions(std::span<const Vec3f> directions);

std::string packed_bytes(std::span<const std::uint8_t> bytes);

}  // namespace augicp::app
