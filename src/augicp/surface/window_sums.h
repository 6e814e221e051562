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

// sum[k] += numbers[k] for count numbers, the channels of whole pixels.
void add(const double* numbers, int count, double* sum);
void add(const float* numbers, int count, float* sum);

// Pixel k's sum is prefix[spans[k].end] - prefix[spans[k].begin].
void differences(const double* prefix, const Span* spans, int count, double* sums, PointMoments);
void differences(const float* prefix, const Span* spans, int count, float* sums, DirectionMoments);

// The same for kBatch pixels side by side, each with its own column of prefix sums: rows of kBatch pixels.
void differences(const double* prefix, const Span* spans, SumBatch<PointMoments>& sums);
void differences(const float* prefix, const Span* spans, SumBatch<DirectionMoments>& sums);

inline constexpr std::size_t kRowsPerBlock = 8;

// Channels of every pixel, for work along columns: the image is cut into strips of kBatch columns, and a strip's rows
// follow one another in memory. A row of zeros comes before each strip's first.
template <typename Moments>
class StripImage {
 public:
  using Number = typename Moments::Number;
  static constexpr std::size_t kStride = std::size_t{kBatch} * Moments::kChannels;  // from row to row

  StripImage(int width, int height)
      : num_strips_((static_cast<std::size_t>(width) + kBatch - 1) / kBatch),
        rows_(static_cast<std::size_t>(height) + 1),
        numbers_(std::make_unique_for_overwrite<Number[]>(num_strips_ * rows_ * kStride)) {
    for (std::size_t strip = 0; strip < num_strips_; ++strip) std::fill_n(before(strip), kStride, Number{0});
  }

  std::size_t num_strips() const { return num_strips_; }
  Number* before(std::size_t strip) { return &numbers_[strip * rows_ * kStride]; }
  Number* row(std::size_t strip, std::size_t v) { return before(strip) + (v + 1) * kStride; }

 private:
  std::size_t num_strips_;
  std::size_t rows_;
  std::unique_ptr<Number[]> numbers_;
};

// Calls body(strip, its first column, number of its columns).
template <typename Body>
void for_each_strip(std::size_t width, const Body& body) {
  for (std::size_t u = 0; u < width; u += kBatch)
    body(u / kBatch, u, static_cast<int>(std::min<std::size_t>(kBatch, width - u)));
}

// Every pixel's sum over its span in its row. values_of_row(v, values) writes the channels of row v, zero where nothing
// counts, and says whether there are any but zeros.
template <typename Moments, typename ValuesOfRow>
StripImage<Moments> sums_over_rows(const WindowSpans& spans, int num_threads, const ValuesOfRow& values_of_row) {
  using Number = typename Moments::Number;
  constexpr std::size_t kChannels = Moments::kChannels;
  const auto width = static_cast<std::size_t>(spans.width);
  StripImage<Moments> sums(spans.width, spans.height);
  for_each_block(
      static_cast<std::size_t>(spans.height), num_threads,
      [&](std::size_t begin, std::size_t end) {
        const auto values = std::make_unique<Number[]>(width * kChannels);
        const auto prefix = std::make_unique<Number[]>((width + 1) * kChannels);
        for (std::size_t v = begin; v < end; ++v) {
          const bool any = values_of_row(v, values.get());
          if (any) accumulate(values.get(), spans.width, prefix.get(), Moments{});
          for_each_strip(width, [&](std::size_t strip, std::size_t u, int count) {
            if (any)
              differences(prefix.get(), &spans.in_row[v * width + u], count, sums.row(strip, v), Moments{});
            else
              std::fill_n(sums.row(strip, v), count * kChannels, Number{0});
          });
        }
      },
      kRowsPerBlock);
  return sums;
}

// Calls use(v, u, count, sums) for pixels u to u + count - 1 of every row v, with the sums of what lies in their
// windows; concurrently for different columns. Sums of entries from count on are zero. wanted(v, u, count) may say that
// nobody asks for these. Consumes the sums of rows.
template <typename Moments, typename Wanted, typename Use>
void sum_over_columns(const WindowSpans& spans, StripImage<Moments> sums_of_rows, int num_threads, const Wanted& wanted,
                      const Use& use) {
  constexpr std::size_t kStride = StripImage<Moments>::kStride;
  const auto width = static_cast<std::size_t>(spans.width), height = static_cast<std::size_t>(spans.height);
  const auto sum_strip = [&](std::size_t begin, std::size_t end) {
    const int count = static_cast<int>(end - begin);
    auto* const prefix = sums_of_rows.before(begin / kBatch);
    for (std::size_t v = 0; v < height; ++v)
      add(prefix + v * kStride, count * Moments::kChannels, prefix + (v + 1) * kStride);
    SumBatch<Moments> sums;
    Span padded[kBatch] = {};  // those beyond the image are empty
    for (std::size_t v = 0; v < height; ++v) {
      if (!wanted(v, begin, count)) continue;
      const Span* column_spans = &spans.in_column[v * width + begin];
      if (count < kBatch) column_spans = std::copy_n(column_spans, count, padded) - count;
      differences(prefix, column_spans, sums);
      use(v, begin, count, sums);
    }
  };
  for_each_block(width, num_threads, sum_strip, kBatch);
}

}  // namespace augicp
