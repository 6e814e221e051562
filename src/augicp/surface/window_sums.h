// SPDX-License-Identifier: MIT
// The loops of window_passes.h, compiled for several instruction sets.
#pragma once

#include <cstdint>

#include "augicp/surface/symmetric_batch.h"
#include "augicp/surface/window_spans.h"

namespace augicp {

// The summed quantities and their types. Positions need double: their squares reach 25 m^2, a surface is flat to 1e-6
// m^2, and a prefix sum over a column has some hundred thousand of them. Directions are at most 1 each, and need 1e-3.
struct PointMoments {  // count, sum, upper triangle of the sum of outer products
  using Number = double;
  static constexpr int kChannels = 10;
};
struct DirectionMoments {  // weight, weighted upper triangle, 0
  using Number = float;
  static constexpr int kChannels = 8;
};

// A unit vector and its weight or structure, one entry per pixel.
struct Direction {
  float xyz[3];
  float weight;  // 0: none
};

// The contents of the windows of a batch of pixels: the number of points and their covariance, or the weight of the
// directions and their mean outer product. Zero for an empty window.
struct WindowBatch {
  alignas(64) BatchArray weight;
  SymmetricBatch matrix;
};

// prefix[k + 1] = prefix[k] + channels of pixel k, for count pixels, from prefix[0] = 0 on. For points, `index` selects
// them; for directions, only those with at least least_weight count.
void accumulate(const Vec3f* points, const std::int32_t* index, int count, double* prefix);
void accumulate(const Direction* directions, int count, float least_weight, float* prefix);

// From the first to the last pixel of any of these spans; empty if all are empty.
Span around(const Span* spans, int count);

// sums[stride + k] = sums[k] + prefix[spans[k].end] - prefix[spans[k].begin] for count pixels of a row of kBatch.
void add_row(const double* prefix, const Span* spans, int count, double* sums, PointMoments);
void add_row(const float* prefix, const Span* spans, int count, float* sums, DirectionMoments);

// The sums between the rows of their spans for kBatch neighbouring pixels, each with its own column of prefix sums:
// rows of kBatch pixels.
void look_into_windows(const double* prefix, const Span* spans, WindowBatch& windows, PointMoments);
void look_into_windows(const float* prefix, const Span* spans, WindowBatch& windows, DirectionMoments);

}  // namespace augicp
