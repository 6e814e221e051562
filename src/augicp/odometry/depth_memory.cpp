// SPDX-License-Identifier: MIT
#include "augicp/odometry/depth_memory.h"

#include <cmath>
#include <string>

#include "augicp/registration/memory.h"

namespace augicp {
namespace {

// Measured: the peak of runs with images of 0.3 and 4.9 million pixels, all of them to every sixteenth used
// (docs/lab/first_hour.md). A pixel: the image and the one that is read meanwhile. One that is used: two frames and the
// model, with their statistics.
constexpr double kBytesWithoutImages = 1e7;
constexpr double kBytesPerPixel = 12.0;
constexpr double kBytesPerUsedPixel = 270.0;

// Megabytes, so that the text is the same in any locale.
std::string in_mb(double gb) { return std::to_string(std::llround(gb * 1000.0)); }

}  // namespace

double depth_memory_gb(int width, int height, int pixel_step) {
  const double num_pixels = static_cast<double>(width) * height;
  const double num_used = num_pixels / (static_cast<double>(pixel_step) * pixel_step);
  return (kBytesWithoutImages + kBytesPerPixel * num_pixels + kBytesPerUsedPixel * num_used) / kBytesPerGb;
}

void require_memory(int width, int height, int pixel_step, const OdometryOptions& options) {
  const double max_gb = allowed_gb(options.registration.max_memory_gb);
  const double needed_gb = depth_memory_gb(width, height, pixel_step);
  if (needed_gb <= max_gb) return;
  EnoughMemory enough;
  for (int step = pixel_step + 1; step < width && !enough.pixel_step; ++step)
    if (depth_memory_gb(width, height, step) <= max_gb) enough.pixel_step = step;
  throw TooMuchMemory("images of " + std::to_string(width) + " x " + std::to_string(height) + " pixels need about " +
                          in_mb(needed_gb) + " MB; " + in_mb(max_gb) + " MB are allowed",
                      enough);
}

}  // namespace augicp
