// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/sensor/depth_image.h"
#include "augicp/sensor/grey_image.h"

namespace augicp {

// Lens distortion of normalised image coordinates x/z, y/z, after Brown 1966. Coefficients and their order are those of
// OpenCV and ROS ("plumb_bob"). All zero: no distortion.
struct Distortion {
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;

  // The distorted coordinates of an ideal (pinhole) point.
  Eigen::Vector2d operator()(const Eigen::Vector2d& ideal) const;

  bool is_none() const { return k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0 && k3 == 0.0; }
};

// A real depth camera. All code beyond this header works on the images of an ideal pinhole: see rectify().
struct DepthCamera {
  Pinhole pinhole;
  Distortion distortion;

  // Rolling shutter: the time from the readout of the first row to that of the last, seconds. 0: all rows at once.
  double readout_s = 0.0;

  // Throws std::invalid_argument if the pinhole does, if a coefficient is not finite or above 100 in magnitude, or if
  // the readout is outside 0 to 1 s.
  void check() const;
};

// The camera called name ("tum-fr1", ...); empty if there is none.
std::optional<DepthCamera> camera_by_name(std::string_view name);

// Every name that camera_by_name knows.
std::vector<std::string> camera_names();

// The pinhole of an image with every step-th pixel of every step-th row. Throws std::invalid_argument unless step is at
// least 1.
Pinhole thinned(const Pinhole& camera, int step);

// The image that thinned(camera.pinhole, step) would see instead of the camera. Each pixel takes the reading of the
// pixel that its ray falls on, or none if the ray misses the image. Readings are never mixed. Throws
// std::invalid_argument if the sizes of image and camera differ.
DepthImage rectify(const DepthImage& image, const DepthCamera& camera, int step = 1);

// The same for an image registered to the camera's depth images: each pixel takes the brightness of the pixel that its
// depth comes from.
GreyImage rectify(const GreyImage& image, const DepthCamera& camera, int step = 1);

}  // namespace augicp
