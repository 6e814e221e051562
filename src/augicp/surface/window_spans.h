// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"
#include "augicp/surface/window_neighbourhood.h"

namespace augicp {

// The pixels [begin, end) of a row or column.
struct Span {
  std::uint16_t begin = 0, end = 0;
  bool operator==(const Span&) const = default;
};

// The arms of WindowNeighbourhood, one entry per pixel, row-major: the reach of a pixel's window in its own row and
// column. Empty if no point is seen. Does not own its memory.
struct WindowSpans {
  int width = 0;
  int height = 0;
  std::span<Span> in_row, in_column;
};

// Fills spans of the image's size, as WindowNeighbourhood does; tests compare both. Throws std::invalid_argument if an
// option is out of its range, or a side of the image is longer than 65535 pixels.
void find_window_spans(const Cloud& cloud, const IndexImage& index, const WindowOptions& options, int num_threads,
                       const WindowSpans& spans);

}  // namespace augicp
