// SPDX-License-Identifier: MIT
// Sums over the windows of a depth image in two passes of prefix sums, along rows and then along columns, as in
// WindowNeighbourhood, but pixel by pixel in an order that stays in the cache, and with a number of channels that the
// compiler knows. Channels of a pixel lie side by side: both ends of a span are then each one read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "augicp/core/parallel.h"
#include "augicp/surface/symmetric_batch.h"
#include "augicp/surface/window_spans.h"

namespace augicp {

// What is summed. Positions need double: their squares reach 25 m^2 while a surface is flat to 1e-6 m^2, and a prefix
// sum over a column holds some hundred thousand of them.
struct PointMoments {  // count, sum, upper triangle of the sum of outer products
  using Number = double;
  static constexpr int kChannels = 10;
};
struct DirectionMoments {  // weight, weighted upper triangle, 0: at most 1 each, and looked at to 1e-3
  using Number = float;
  static constexpr int kChannels = 8;
};

// One channel after the other for the pixels of a batch, so that what follows is done on several pixels at once.
template <typename Moments>
struct SumBatch {
  alignas(64) typename Moments::Number channel[Moments::kChannels][kBatch];
};

// The loops themselves, for both kinds.
//
// prefix[k + 1] = prefix[k] + values[k] for count pixels.
void accumulate(const double* values, int count, double* prefix, PointMoments);
void accumulate(const float* values, int count, float* prefix, DirectionMoments);

// Of count numbers, the channels of whole pixels.
void add(const double* a, const double* b, int count, double* sum);
void add(const float* a, const float* b, int count, float* sum);

// Pixel k's sum is prefix[spans[k].end] - prefix[spans[k].begin].
void differences(const double* prefix, const Span* spans, int count, double* sums, PointMoments);
void differences(const float* prefix, const Span* spans, int count, float* sums, DirectionMoments);

// The same for kBatch pixels side by side, each with its own column of prefix sums: rows of kBatch pixels.
void differences(const double* prefix, const Span* spans, SumBatch<PointMoments>& sums);
void differences(const float* prefix, const Span* spans, SumBatch<DirectionMoments>& sums);

inline constexpr std::size_t kRowsPerBlock = 8;

// Every pixel's sum over its span in its row. values_of_row(v, values) writes the channels of row v, zero where nothing
// counts, and says whether there are any but zeros.
template <typename Moments, typename ValuesOfRow>
std::unique_ptr<typename Moments::Number[]> sums_over_rows(const WindowSpans& spans, int num_threads,
                                                           const ValuesOfRow& values_of_row) {
  using Number = typename Moments::Number;
  constexpr std::size_t kChannels = Moments::kChannels;
  const auto width = static_cast<std::size_t>(spans.width);
  auto sums = std::make_unique_for_overwrite<Number[]>(width * spans.height * kChannels);
  for_each_block(
      static_cast<std::size_t>(spans.height), num_threads,
      [&](std::size_t begin, std::size_t end) {
        const auto values = std::make_unique<Number[]>(width * kChannels);
        const auto prefix = std::make_unique<Number[]>((width + 1) * kChannels);
        for (std::size_t v = begin; v < end; ++v) {
          Number* const row = &sums[v * width * kChannels];
          if (!values_of_row(v, values.get())) {
            std::fill_n(row, width * kChannels, Number{0});
            continue;
          }
          accumulate(values.get(), spans.width, prefix.get(), Moments{});
          differences(prefix.get(), &spans.in_row[v * width], spans.width, row, Moments{});
        }
      },
      kRowsPerBlock);
  return sums;
}

// Calls use(v, u, count, sums) for pixels u to u + count - 1 of every row v, with the sums of what lies in their windows;
// concurrently for different columns. Sums of entries from count on are zero. wanted(v, u, count) may say that nobody
// asks for these.
template <typename Moments, typename Wanted, typename Use>
void sum_over_columns(const WindowSpans& spans, const typename Moments::Number* sums_of_rows, int num_threads,
                      const Wanted& wanted, const Use& use) {
  using Number = typename Moments::Number;
  constexpr std::size_t kStride = std::size_t{kBatch} * Moments::kChannels;
  const auto width = static_cast<std::size_t>(spans.width), height = static_cast<std::size_t>(spans.height);
  for_each_block(
      width, num_threads,
      [&](std::size_t begin, std::size_t end) {
        const int count = static_cast<int>(end - begin), numbers = count * Moments::kChannels;
        const auto prefix = std::make_unique_for_overwrite<Number[]>((height + 1) * kStride);
        std::fill_n(prefix.get(), kStride, Number{0});
        for (std::size_t v = 0; v < height; ++v)
          add(&prefix[v * kStride], sums_of_rows + (v * width + begin) * Moments::kChannels, numbers,
              &prefix[(v + 1) * kStride]);
        SumBatch<Moments> sums;
        Span column_spans[kBatch] = {};  // those beyond the image are empty
        for (std::size_t v = 0; v < height; ++v) {
          if (!wanted(v, begin, count)) continue;
          std::copy_n(&spans.in_column[v * width + begin], count, column_spans);
          differences(prefix.get(), column_spans, sums);
          use(v, begin, count, sums);
        }
      },
      kBatch);
}

}  // namespace augicp
