// SPDX-License-Identifier: MIT
// The rules of shape.h for the windows of a batch of pixels, side by side.
#pragma once

#include <cstdint>

#include "augicp/surface/estimate_surface.h"
#include "augicp/surface/window_sums.h"

namespace augicp {

// Structures as numbers of the size of a float, so that compilers vectorise choices between them.
using StructureBatch = std::int32_t[kBatch];

// The structure of the points in each window by their eigenvalues, and whether any is an edge. A line may still be one
// along the line of sight.
bool structures_of_points(const WindowBatch& windows, const EigenvalueBatch& values, const SurfaceOptions& options,
                          StructureBatch& structures);

// Writes count pixels. The structure is None if the direction is zero. Normals have weight 1, tangents 0.
void write_shapes(const StructureBatch& structures, const VectorBatch& directions, int count, Direction* shapes,
                  Structure* structures_of_pixels);

// Whether the normals in any of the windows spread at least as much as in a crease; may return true if none does. Takes
// mean outer products.
bool may_spread(const WindowBatch& normals, const ShapeThresholds& thresholds);

// The second step for count pixels, all with their structure from the first step. Writes the tangent, weighted by the
// spread across it, if there may be a crease, else zero. Removes the structure of corners. Returns whether there may be
// a crease.
bool write_spreads(const WindowBatch& normals, const EigenvalueBatch& values, const VectorBatch& tangents,
                   const ShapeThresholds& thresholds, int count, Direction* spreads, Structure* structures);

}  // namespace augicp
