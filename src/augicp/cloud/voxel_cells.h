// SPDX-License-Identifier: MIT
// Cells of a voxel grid and their keys, within this module. Called once per point.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "augicp/cloud/cloud.h"

namespace augicp {

inline constexpr double kMaxCells = 1 << 21;  // three axes of 21 bits fit one 64-bit key

// Every third bit of the result is a bit of the lowest 21 of x.
inline std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// Positions in whole parts of a cell from the corner of the grid. The sum of integers does not depend on their order.
inline constexpr int kPartBits = 30;
inline constexpr std::int64_t kParts = std::int64_t{1} << kPartBits;
using Parts = std::array<std::int64_t, 3>;
inline constexpr double kMaxPart = kMaxCells * static_cast<double>(kParts) - 1.0;

class VoxelCells {
 public:
  VoxelCells(const Vec3f& min, double cell);

  Parts parts(const Vec3f& point) const {
    // Offsets from the minimum are never negative, so truncation equals floor.
    const auto axis = [&](int k) {
      const double parts = (static_cast<double>(point[k]) - min_[k]) * parts_per_metre_;
      return static_cast<std::int64_t>(std::min(parts, kMaxPart));
    };
    return {axis(0), axis(1), axis(2)};
  }

  // Of several points at once.
  void write_parts(std::span<const Vec3f> points, std::span<Parts> written) const;

  Vec3d place(const Vec3d& parts) const { return min_ + parts / parts_per_metre_; }

 private:
  Vec3d min_;
  double parts_per_metre_;
};

// The place of a cell on the curve.
inline std::uint64_t morton_key(const Parts& parts) {
  const auto axis = [&](int k) { return spread_bits(static_cast<std::uint64_t>(parts[k] >> kPartBits)); };
  return axis(0) | axis(1) << 1 | axis(2) << 2;
}

// Of the cloud, which has a point; voxel_size is positive. Throws std::invalid_argument if the cloud spans too many
// voxels.
VoxelCells voxel_cells(const Cloud& cloud, double voxel_size);

}  // namespace augicp
