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

// The arms of WindowNeighbourhood, one entry a pixel, row-major: how far a pixel's window reaches in its own row and
// column. Empty where no point is seen. In memory that is somebody else's.
struct WindowSpans {
  int width = 0;
  int height = 0;
  std::span<Span> in_row, in_column;
};

// Fills spans of the image's size. As WindowNeighbourhood, which tests compare it with. Throws std::invalid_argument
// where an option is out of bounds or a side of the image is longer than 65535 pixels.
void find_window_spans(const Cloud& cloud, const IndexImage& index, const WindowOptions& options, int num_threads,
                       const WindowSpans& spans);

}  // namespace augicp
