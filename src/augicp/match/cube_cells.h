// SPDX-License-Identifier: MIT
// Directions in cells: the pixels of the six faces of a cube around a place.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "augicp/core/types.h"

namespace augicp {

struct FacePoint {
  int face;    // 0 to 5: axis x, y, z, and three more for its negative side
  float u, v;  // in [-1, 1] on the face
};

// Where a direction (of any length but zero) meets the cube.
inline FacePoint on_cube(const Vec3f& direction) {
  int axis = 0;
  const float largest = direction.cwiseAbs().maxCoeff(&axis);
  const int face = direction[axis] < 0.0f ? axis + 3 : axis;
  return {face, direction[(axis + 1) % 3] / largest, direction[(axis + 2) % 3] / largest};
}

// u and v may lie beyond the face's border; the direction then meets another face.
inline Vec3f direction_of(const FacePoint& at) {
  const int axis = at.face % 3;
  Vec3f direction;
  direction[axis] = at.face < 3 ? 1.0f : -1.0f;
  direction[(axis + 1) % 3] = at.u;
  direction[(axis + 2) % 3] = at.v;
  return direction;
}

inline std::size_t num_cube_cells(int cells_per_edge) { return std::size_t{6} * cells_per_edge * cells_per_edge; }

// The column or row of a coordinate on a face.
inline int cell_along(float x, int cells_per_edge) {
  return std::clamp(static_cast<int>((x + 1.0f) * 0.5f * static_cast<float>(cells_per_edge)), 0, cells_per_edge - 1);
}

inline std::size_t cell_of(const FacePoint& at, int cells_per_edge) {
  const std::size_t row = static_cast<std::size_t>(at.face) * cells_per_edge + cell_along(at.v, cells_per_edge);
  return row * cells_per_edge + cell_along(at.u, cells_per_edge);
}

// The cell and the eight around it; at the cube's corners some are the same.
inline std::array<std::size_t, 9> cells_around(const FacePoint& at, int cells_per_edge) {
  const float step = 2.0f / static_cast<float>(cells_per_edge);
  const std::array<float, 3> steps{-step, 0.0f, step};
  std::array<std::size_t, 9> cells{};
  std::size_t k = 0;
  if (std::abs(at.u) + step < 1.0f && std::abs(at.v) + step < 1.0f) {  // all on the face
    std::array<std::size_t, 3> columns{};
    for (std::size_t column = 0; column < 3; ++column)
      columns[column] = static_cast<std::size_t>(cell_along(at.u + steps[column], cells_per_edge));
    for (const float dv : steps) {
      const std::size_t row =
          static_cast<std::size_t>(at.face) * cells_per_edge + cell_along(at.v + dv, cells_per_edge);
      for (const std::size_t column : columns) cells[k++] = row * cells_per_edge + column;
    }
    return cells;
  }
  for (const float dv : steps)
    for (const float du : steps)
      cells[k++] = cell_of(on_cube(direction_of({at.face, at.u + du, at.v + dv})), cells_per_edge);
  return cells;
}

}  // namespace augicp
