// SPDX-License-Identifier: MIT
// Directions in cells: the pixels of the six faces of a cube around a place.
#pragma once

#include <algorithm>
#include <array>
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

inline std::size_t cell_of(const FacePoint& at, int cells_per_edge) {
  const auto along = [=](float x) {
    return std::clamp(static_cast<int>((x + 1.0f) * 0.5f * static_cast<float>(cells_per_edge)), 0, cells_per_edge - 1);
  };
  return (static_cast<std::size_t>(at.face) * cells_per_edge + along(at.v)) * cells_per_edge + along(at.u);
}

// The cell and the eight around it; at the cube's corners some are the same.
inline std::array<std::size_t, 9> cells_around(const FacePoint& at, int cells_per_edge) {
  const float step = 2.0f / static_cast<float>(cells_per_edge);
  std::array<std::size_t, 9> cells{};
  std::size_t k = 0;
  for (const float dv : {-step, 0.0f, step})
    for (const float du : {-step, 0.0f, step})
      cells[k++] = cell_of(on_cube(direction_of({at.face, at.u + du, at.v + dv})), cells_per_edge);
  return cells;
}

}  // namespace augicp
