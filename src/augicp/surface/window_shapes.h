// SPDX-License-Identifier: MIT
// The rules of shape.h for the windows of a batch of pixels, side by side.
#pragma once

#include <cstdint>

#include "augicp/surface/estimate_surface.h"
#include "augicp/surface/window_sums.h"

namespace augicp {

// Structures as numbers of the size of a float, which compilers choose between side by side with floats.
using StructureBatch = std::int32_t[kBatch];

// What the points in each window look like by their eigenvalues, and whether any are edges. A line may still be one
// along the line of sight.
bool structures_of_points(const WindowBatch& windows, const EigenvalueBatch& values, const SurfaceOptions& options,
                          StructureBatch& structures);

// Writes count pixels. None where the direction is zero; normals weigh 1, tangents 0.
void write_shapes(const StructureBatch& structures, const VectorBatch& directions, int count, Direction* shapes,
                  Structure* structures_of_pixels);

// Whether normals spread in any of the windows at least as much as a crease asks for; may say so where they do not. Of
// mean outer products.
bool may_spread(const WindowBatch& normals, const ShapeThresholds& thresholds);

// The second step for count pixels, of which all have their structure from the first: writes the tangent where there
// may be a crease, with the spread across it for a weight, else zero; takes the structure from corners. Whether there
// may be any crease in the middle or at the side of one.
bool write_spreads(const WindowBatch& normals, const EigenvalueBatch& values, const VectorBatch& tangents,
                   const ShapeThresholds& thresholds, int count, Direction* spreads, Structure* structures);

}  // namespace augicp
