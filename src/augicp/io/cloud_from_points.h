// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "augicp/io/cloud_file.h"

namespace augicp {

// Points that are in memory, in another program's arrays for instance.
struct PointSource {
  std::size_t count = 0;
  std::function<Vec3d(std::size_t)> position;       // metres; what is not finite is dropped
  std::function<Vec3d(std::size_t)> normal;         // of any length; empty: there are none
  std::function<Structure(std::size_t)> structure;  // of each normal; empty: all Planar
  std::optional<Vec3d> viewpoint;                   // metres
};

// The cloud of these points, by the rules of CloudFile, so that it equals what is read from a file with the same
// numbers; but it may be empty. Asks for every point once or twice, in order. Throws std::invalid_argument for more
// points than ReadOptions allow, before it asks for any.
CloudFile cloud_from_points(const PointSource& points);

}  // namespace augicp
