// SPDX-License-Identifier: MIT
// Sums over the windows of a depth image, by prefix sums along rows and then along columns, as in WindowNeighbourhood.
// Two differences make them fast: they run over strips of columns, so that all sums stay in the cache, and the number
// of channels is known at compile time. The channels of a pixel are contiguous, so each end of a span is one read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "augicp/core/parallel.h"
#include "augicp/core/prefetch.h"
#include "augicp/surface/window_sums.h"

namespace augicp {

// Prefetches count pixels from (u, v) on, of a row further down the image: the rows of a strip are farther apart than
// processors prefetch by themselves.
template <typename Pixel>
void fetch_rows_ahead(const Pixel* image, std::size_t width, std::size_t height, std::size_t v, std::size_t u,
                      int count) {
  constexpr std::size_t kRowsAhead = 6;
  if (v + kRowsAhead < height) prefetch(image + (v + kRowsAhead) * width + u, static_cast<std::size_t>(count));
}

// Prefix sums down a strip of kBatch columns: row v has the sum over the spans of its pixels in the rows above v. Sums
// along a row cover both sides of the strip as far as these spans reach.
template <typename Moments>
class StripSums {
 public:
  using Number = typename Moments::Number;
  static constexpr std::size_t kStride = std::size_t{kBatch} * Moments::kChannels;  // from row to row

  explicit StripSums(const WindowSpans& spans)
      : spans_(spans),
        along_row_(std::make_unique_for_overwrite<Number[]>((to_size(spans.width) + 1) * Moments::kChannels)),
        sums_(std::make_unique_for_overwrite<Number[]>((to_size(spans.height) + 1) * kStride)) {
    // Empty spans begin and end at 0.
    std::fill_n(along_row_.get(), Moments::kChannels, Number{0});
    std::fill_n(sums_.get(), kStride, Number{0});
  }

  // For count columns from u on. For the others only row 0 is set, which empty spans read. accumulate_row(v, part,
  // prefix) calls accumulate() for a part of row v.
  template <typename AccumulateRow>
  void add_up(std::size_t u, int count, const AccumulateRow& accumulate_row) {
    for (std::size_t v = 0; v < to_size(spans_.height); ++v) {
      fetch_rows_ahead(spans_.in_row.data(), to_size(spans_.width), to_size(spans_.height), v, u, count);
      const Span* const in_row = &spans_.in_row[v * to_size(spans_.width) + u];
      const Span part = around(in_row, count);
      accumulate_row(v, part, &along_row_[part.begin * std::size_t{Moments::kChannels}]);
      add_row(along_row_.get(), in_row, count, &sums_[v * kStride], Moments{});
    }
  }
  const Number* data() const { return sums_.get(); }

 private:
  static std::size_t to_size(int side) { return static_cast<std::size_t>(side); }

  const WindowSpans& spans_;
  std::unique_ptr<Number[]> along_row_, sums_;
};

// Calls use(v, u, count, windows) for pixels u to u + count - 1 of every row v, with the sums over their windows.
// Thread safety: calls for different columns run concurrently. Entries from count on are zero. wanted(v, u) returns
// false to skip these pixels.
template <typename Moments, typename AccumulateRow, typename Wanted, typename Use>
void for_each_window(const WindowSpans& spans, int num_threads, const AccumulateRow& accumulate_row,
                     const Wanted& wanted, const Use& use) {
  const auto width = static_cast<std::size_t>(spans.width), height = static_cast<std::size_t>(spans.height);
  const auto look_into_strip = [&](std::size_t begin, std::size_t end) {
    std::size_t first_wanted = 0;
    while (first_wanted < height && !wanted(first_wanted, begin)) ++first_wanted;
    if (first_wanted == height) return;
    const int count = static_cast<int>(end - begin);
    StripSums<Moments> sums(spans);
    sums.add_up(begin, count, accumulate_row);
    WindowBatch windows;
    Span padded[kBatch] = {};  // spans beyond the image are empty
    for (std::size_t v = first_wanted; v < height; ++v) {
      fetch_rows_ahead(spans.in_column.data(), width, height, v, begin, count);
      if (!wanted(v, begin)) continue;
      const Span* column_spans = &spans.in_column[v * width + begin];
      if (count < kBatch) column_spans = std::copy_n(column_spans, count, padded) - count;
      look_into_windows(sums.data(), column_spans, windows, Moments{});
      use(v, begin, count, windows);
    }
  };
  for_each_block(width, num_threads, look_into_strip, kBatch);
}

}  // namespace augicp
