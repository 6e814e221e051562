// SPDX-License-Identifier: MIT
// Sums over the windows of a depth image in two passes of prefix sums, along rows and then along columns, as in
// WindowNeighbourhood, but pixel by pixel in an order that stays in the cache, and with a number of channels that the
// compiler knows. Channels of a pixel lie side by side: both ends of a span are then each one read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "augicp/core/parallel.h"
#include "augicp/surface/window_sums.h"

namespace augicp {

inline constexpr std::size_t kRowsPerBlock = 8;

// Sums over rows, for work along columns: the image is cut into strips of kBatch columns, and a strip's rows follow one
// another in memory.
template <typename Moments>
class StripImage {
 public:
  using Number = typename Moments::Number;
  static constexpr std::size_t kStride = std::size_t{kBatch} * Moments::kChannels;  // from row to row

  StripImage(int width, int height)
      : height_(static_cast<std::size_t>(height)),
        numbers_(std::make_unique_for_overwrite<Number[]>((static_cast<std::size_t>(width) + kBatch - 1) / kBatch *
                                                          height_ * kStride)) {}
  Number* row(std::size_t strip, std::size_t v) { return &numbers_[(strip * height_ + v) * kStride]; }
  const Number* row(std::size_t strip, std::size_t v) const { return &numbers_[(strip * height_ + v) * kStride]; }

 private:
  std::size_t height_;
  std::unique_ptr<Number[]> numbers_;
};

// Has count pixels from (u, v) on brought to the cache, of a row some rows farther down an image: a strip's rows lie
// farther apart in an image than processors look ahead by themselves.
template <typename Pixel>
void fetch_ahead(const Pixel* image, std::size_t width, std::size_t height, std::size_t v, std::size_t u, int count) {
  constexpr std::size_t kRowsAhead = 6, kLineBytes = 64;
  if (v + kRowsAhead >= height) return;
  const auto* const bytes = reinterpret_cast<const char*>(image + (v + kRowsAhead) * width + u);
  for (std::size_t k = 0; k < static_cast<std::size_t>(count) * sizeof(Pixel); k += kLineBytes)
    __builtin_prefetch(bytes + k);
}

// Calls body(strip, its first column, number of its columns).
template <typename Body>
void for_each_strip(std::size_t width, const Body& body) {
  for (std::size_t u = 0; u < width; u += kBatch)
    body(u / kBatch, u, static_cast<int>(std::min<std::size_t>(kBatch, width - u)));
}

// Every pixel's sum over its span in its row. accumulate_row(v, prefix) calls accumulate() for row v.
template <typename Moments, typename AccumulateRow>
StripImage<Moments> sums_over_rows(const WindowSpans& spans, int num_threads, const AccumulateRow& accumulate_row) {
  using Number = typename Moments::Number;
  constexpr std::size_t kChannels = Moments::kChannels;
  const auto width = static_cast<std::size_t>(spans.width);
  StripImage<Moments> sums(spans.width, spans.height);
  for_each_block(
      static_cast<std::size_t>(spans.height), num_threads,
      [&](std::size_t begin, std::size_t end) {
        const auto prefix = std::make_unique_for_overwrite<Number[]>((width + 1) * kChannels);
        for (std::size_t v = begin; v < end; ++v) {
          accumulate_row(v, prefix.get());
          const bool any = prefix[width * kChannels] > Number{0};
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

// Calls use(v, u, count, windows) for pixels u to u + count - 1 of every row v, with what lies in their windows;
// concurrently for different columns. Entries from count on are zero. wanted(v, u) may say that nobody asks for these.
template <typename Moments, typename Wanted, typename Use>
void sum_over_columns(const WindowSpans& spans, const StripImage<Moments>& sums_of_rows, int num_threads,
                      const Wanted& wanted, const Use& use) {
  using Number = typename Moments::Number;
  constexpr std::size_t kStride = StripImage<Moments>::kStride;
  const auto width = static_cast<std::size_t>(spans.width), height = static_cast<std::size_t>(spans.height);
  const auto sum_strip = [&](std::size_t begin, std::size_t end) {
    std::size_t first_wanted = 0;
    while (first_wanted < height && !wanted(first_wanted, begin)) ++first_wanted;
    if (first_wanted == height) return;
    const int count = static_cast<int>(end - begin);
    const auto prefix = std::make_unique_for_overwrite<Number[]>((height + 1) * kStride);  // stays in the cache
    std::fill_n(prefix.get(), kStride, Number{0});
    for (std::size_t v = 0; v < height; ++v)
      add(&prefix[v * kStride], sums_of_rows.row(begin / kBatch, v), count * Moments::kChannels,
          &prefix[(v + 1) * kStride]);
    WindowBatch windows;
    Span padded[kBatch] = {};  // those beyond the image are empty
    for (std::size_t v = first_wanted; v < height; ++v) {
      fetch_ahead(spans.in_column.data(), width, height, v, begin, count);
      if (!wanted(v, begin)) continue;
      const Span* column_spans = &spans.in_column[v * width + begin];
      if (count < kBatch) column_spans = std::copy_n(column_spans, count, padded) - count;
      look_into_windows(prefix.get(), column_spans, windows, Moments{});
      use(v, begin, count, windows);
    }
  };
  for_each_block(width, num_threads, sum_strip, kBatch);
}

}  // namespace augicp
