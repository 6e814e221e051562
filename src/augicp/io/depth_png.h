// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "augicp/io/file_bytes.h"
#include "augicp/sensor/depth_image.h"

namespace augicp {

// A depth image from a PNG of 16-bit grey values: metres = value / depth_scale (TUM: 5000, most others: 1000); 0 and
// 65535 are no reading. Throws IoError for any other kind of PNG and for a damaged one, and std::invalid_argument
// unless depth_scale is above 0.
DepthImage read_depth_png(const std::filesystem::path& path, double depth_scale);

// The same for a file in memory.
DepthImage parse_depth_png(const FileBytes& file, double depth_scale);

// Advice if the median reading is below 5 cm or above 200 m: then the depth scale is wrong by a factor. Empty if all is
// well or there are no readings. depth_scale is for the message.
std::optional<std::string> depth_scale_problem(const DepthImage& image, double depth_scale);

// Why another depth scale is likely: readings (but for a hundredth at each end) nearer than 0.2 or farther than 10 m,
// beyond the range of depth cameras. Empty if nothing suggests one. A suspicion only: there are cameras for other
// ranges.
std::optional<std::string> depth_scale_suspicion(const DepthImage& image, double depth_scale);

// Whether an image has enough readings to judge the depth scale: a few speckles in a black image do not suffice.
bool tells_depth_scale(const DepthImage& image);

// Throws IoError with that advice. path is for the message.
void check_depth_scale(const DepthImage& image, const std::filesystem::path& path, double depth_scale);

// Writes round(depth * depth_scale); 0 for no reading and for values beyond 16 bits. Throws IoError; throws
// std::invalid_argument if the array's length is not width * height or the image is empty.
void write_depth_png(const std::filesystem::path& path, const DepthImage& image, double depth_scale);

}  // namespace augicp
