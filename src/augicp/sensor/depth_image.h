// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"
#include "augicp/sensor/pinhole.h"

namespace augicp {

// Depth along the optical axis in metres, row-major; NaN if there is no reading.
struct DepthImage {
  int width = 0;
  int height = 0;
  std::vector<float> depth;

  float at(int u, int v) const { return depth[static_cast<std::size_t>(v) * width + u]; }
};

// A depth image from a sensor's values, row-major: metres = value / depth_scale. Integers: 0 and 65535 are no reading.
// Floats: values that are not finite or not above 0 are no reading. Both throw std::invalid_argument unless depth_scale
// is finite and above 0 and there are width * height values.
DepthImage depth_image(std::span<const std::uint16_t> values, int width, int height, double depth_scale);
DepthImage depth_image(std::span<const float> values, int width, int height, double depth_scale);

// Throws std::invalid_argument if the image's size is not the camera's, or its array's length is not width * height.
void check_size(const DepthImage& image, const Pinhole& camera);

// Readings outside this range count as no reading, metres.
struct DepthRange {
  double min = 0.0;
  double max = std::numeric_limits<double>::infinity();
};

// Noise of a depth camera: the variance of a reading at depth z is floor^2 + (per_depth_sq z^2)^2. Stereo and
// structured light lose precision with the square of the depth. The floor stands for errors that do not depend on it
// (calibration, time stamps, rolling shutter). The default is a Kinect's.
struct DepthNoise {
  double floor = 0.0012;         // standard deviation, metres
  double per_depth_sq = 0.0012;  // metres a square metre

  // The inverse of the variance at depth z, relative to that at depth zero: in (0, 1].
  double weight(double z) const;
};

// The points that a camera saw, and the pixel of each.
struct OrganizedCloud {
  Cloud cloud;  // in raster order; viewpoint at the camera
  IndexImage index;
};

// The positions of a depth image's readings in the camera frame, with their weights. Throws std::invalid_argument like
// check_size().
OrganizedCloud unproject(const DepthImage& image, const Pinhole& camera, const DepthRange& range = {},
                         const DepthNoise& noise = {});

}  // namespace augicp
