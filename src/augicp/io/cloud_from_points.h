// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "augicp/io/cloud_file.h"
#include "augicp/io/write_cloud.h"

namespace augicp {

// Points in memory, for instance in the arrays of another program.
struct PointSource {
  std::size_t count = 0;
  std::function<Vec3d(std::size_t)> position;       // metres; points that are not finite are dropped
  std::function<Vec3d(std::size_t)> normal;         // of any length; empty: no normals
  std::function<Structure(std::size_t)> structure;  // for each normal; empty: all Planar
  std::function<double(std::size_t)> intensity;     // in any unit, NaN if unknown; empty: no intensities
  std::function<Colour(std::size_t)> colour;        // empty: no colours
  std::optional<Vec3d> viewpoint;                   // metres

  // Writes positions from an index on, if set; `position` is then not needed. Points that have nothing else are read
  // faster.
  std::function<void(std::size_t first, std::span<Vec3d> positions)> positions{};
};

// The cloud of these points, by the rules of CloudFile: it equals the cloud of a file with the same numbers, except
// that it may be empty. Colours become the columns red, green and blue of its fields. Reads every point once or twice,
// in order. Throws std::invalid_argument for more points than ReadOptions allows, before it reads any.
CloudFile cloud_from_points(const PointSource& points);

}  // namespace augicp
