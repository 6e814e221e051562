// SPDX-License-Identifier: MIT
// Readers of depth images beside depth_png.h, and what they share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "augicp/io/depth_png.h"

namespace augicp {

// All throw IoError. REQUIRES: depth_scale above 0.

// .pgm: binary (P5), 16 bits; values as in a PNG.
DepthImage parse_depth_pgm(const FileBytes& file, double depth_scale);

// .pfm: one channel (Pf) of float32 metres, of either byte order, the lowest row first.
DepthImage parse_depth_pfm(const FileBytes& file, double depth_scale);

// .tif: see tiff_directory.h; integers as in a PNG, floats are metres.
DepthImage parse_depth_tiff(const FileBytes& file, double depth_scale);

// Throws IoError unless the image has 1 to 16384 pixels a side.
void check_image_sides(const FileBytes& file, std::uint64_t width, std::uint64_t height);

// Integers have a scale, and 65535 is no reading; floats are metres, and infinity is no reading.
struct DepthUnit {
  std::optional<double> depth_scale;
};

// value_at(v, u) is the value in row v and column u; it is called row by row, from left to right.
DepthImage depth_of_values(std::size_t width, std::size_t height, const DepthUnit& unit,
                           const std::function<double(std::size_t, std::size_t)>& value_at);

}  // namespace augicp
