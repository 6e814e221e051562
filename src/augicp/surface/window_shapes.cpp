// SPDX-License-Identifier: MIT
#include "augicp/surface/window_shapes.h"

#include <algorithm>

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

// Rounding of products of numbers near 1.
constexpr float kRounding = 1e-6f;

constexpr auto kNone = static_cast<std::int32_t>(Structure::None),
               kPlanar = static_cast<std::int32_t>(Structure::Planar),
               kEdge = static_cast<std::int32_t>(Structure::Edge);

AUGICP_VECTORIZED void lines_and_normals(const WindowBatch& windows, const EigenvalueBatch& values,
                                         const ShapeThresholds& thresholds, StructureBatch& structures) {
  const auto min_points = static_cast<float>(thresholds.min_points);
  for (int k = 0; k < kBatch; ++k) {
    const float l0 = values.l0[k], l1 = values.l1[k], l2 = values.l2[k];
    const std::int32_t if_no_line = is_thick(l0, l1, thresholds) ? kNone : kPlanar;
    const std::int32_t if_enough = is_line(l1, l2, thresholds) ? kEdge : if_no_line;
    structures[k] = windows.weight[k] >= min_points && l2 > 0.0f ? if_enough : kNone;
  }
}

AUGICP_INLINE void write(const VectorBatch& vectors, const BatchArray& weights, int count, Direction* directions) {
  for (int k = 0; k < count; ++k) directions[k] = {{vectors.x[k], vectors.y[k], vectors.z[k]}, weights[k]};
}

// The paper's classifier.
void by_eigenvalues(const WindowBatch& windows, const EigenvalueBatch& values, const ShapeThresholds& thresholds,
                    StructureBatch& structures) {
  const auto min_points = static_cast<float>(thresholds.min_points);
  for (int k = 0; k < kBatch; ++k) {
    const bool enough = windows.weight[k] >= min_points && values.l2[k] > 0.0f;
    structures[k] =
        enough ? static_cast<std::int32_t>(structure_of_points(values.l0[k], values.l1[k], values.l2[k], thresholds))
               : kNone;
  }
}

}  // namespace

bool structures_of_points(const WindowBatch& windows, const EigenvalueBatch& values, const SurfaceOptions& options,
                          StructureBatch& structures) {
  if (options.classifier == Classifier::Eigenvalues)
    by_eigenvalues(windows, values, options.thresholds, structures);
  else
    lines_and_normals(windows, values, options.thresholds, structures);
  return std::find(structures, structures + kBatch, kEdge) != structures + kBatch;
}

AUGICP_VECTORIZED void write_shapes(const StructureBatch& structures, const VectorBatch& directions, int count,
                                    Direction* shapes, Structure* structures_of_pixels) {
  VectorBatch kept;
  BatchArray weights;
  StructureBatch found;
  for (int k = 0; k < kBatch; ++k) {
    const float x = directions.x[k], y = directions.y[k], z = directions.z[k];
    const bool is_unit = x * x + y * y + z * z > 0.5f;  // else zero, or NaN after an overflow of sums
    found[k] = is_unit ? structures[k] : kNone;
    kept.x[k] = found[k] == kNone ? 0.0f : x;
    kept.y[k] = found[k] == kNone ? 0.0f : y;
    kept.z[k] = found[k] == kNone ? 0.0f : z;
    weights[k] = found[k] == kPlanar ? 1.0f : 0.0f;
  }
  write(kept, weights, count, shapes);
  for (int k = 0; k < count; ++k) structures_of_pixels[k] = static_cast<Structure>(found[k]);
}

// For eigenvalues with the sum t: l1 (t - l1) <= l1 (l0 + l2) + l0 l2, which is half of t^2 minus the sum of their
// squares. The left side grows with l1, which is at most t / 2. t is 1 up to the rounding of prefix sums.
AUGICP_VECTORIZED bool may_spread(const WindowBatch& normals, const ShapeThresholds& thresholds) {
  const auto least = static_cast<float>(std::min(thresholds.min_crease, thresholds.clear_crease));
  const SymmetricBatch& m = normals.matrix;
  std::int32_t any = 0;
  for (int k = 0; k < kBatch; ++k) {
    const float trace = m.xx[k] + m.yy[k] + m.zz[k];
    const float squares = m.xx[k] * m.xx[k] + m.yy[k] * m.yy[k] + m.zz[k] * m.zz[k] +
                          2.0f * (m.xy[k] * m.xy[k] + m.xz[k] * m.xz[k] + m.yz[k] * m.yz[k]);
    const bool is_wide = trace * trace - squares >= 2.0f * least * (trace - least) - kRounding;
    any |= ((trace > least) & is_wide) ? 1 : 0;
  }
  return any != 0;
}

AUGICP_VECTORIZED bool write_spreads(const WindowBatch& normals, const EigenvalueBatch& values,
                                     const VectorBatch& tangents, const ShapeThresholds& thresholds, int count,
                                     Direction* spreads, Structure* structures) {
  const auto min_crease = static_cast<float>(thresholds.min_crease),
             least = std::min(min_crease, static_cast<float>(thresholds.clear_crease)),
             max_corner = static_cast<float>(thresholds.max_corner),
             min_points = static_cast<float>(thresholds.min_points);
  VectorBatch kept;
  BatchArray weights;
  StructureBatch found{};
  for (int k = 0; k < count; ++k) found[k] = static_cast<std::int32_t>(structures[k]);
  std::int32_t any = 0;
  for (int k = 0; k < kBatch; ++k) {
    const float across = values.l1[k], along = values.l0[k];
    const bool spread = (across >= least) & (normals.weight[k] >= min_points) & (found[k] != kEdge);
    const bool crease = spread & (along <= max_corner), wide = across >= min_crease;
    kept.x[k] = crease ? tangents.x[k] : 0.0f;
    kept.y[k] = crease ? tangents.y[k] : 0.0f;
    kept.z[k] = crease ? tangents.z[k] : 0.0f;
    weights[k] = crease ? across : 0.0f;
    any |= (crease & wide) ? 1 : 0;
    found[k] = (spread & !crease & wide) ? kNone : found[k];
  }
  write(kept, weights, count, spreads);
  for (int k = 0; k < count; ++k) structures[k] = static_cast<Structure>(found[k]);
  return any != 0;
}

}  // namespace augicp
