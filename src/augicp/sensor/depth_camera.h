// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/sensor/depth_image.h"
#include "augicp/sensor/grey_image.h"

namespace augicp {

// What a lens does to a ray, after Brown 1966, with the coefficients and in the order that OpenCV and ROS use
// ("plumb_bob"). Of normalised image coordinates x/z, y/z. All zero: nothing.
struct Distortion {
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;

  // Where the ray through the ideal point is seen.
  Eigen::Vector2d operator()(const Eigen::Vector2d& ideal) const;

  bool is_none() const { return k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0 && k3 == 0.0; }
};

// A depth camera as it is. Everything beyond this header works on the images of an ideal pinhole: see rectify().
struct DepthCamera {
  Pinhole pinhole;
  Distortion distortion;

  // A rolling shutter reads the first row of an image so much earlier than the last, seconds. 0: all at once.
  double readout_s = 0.0;

  // Throws std::invalid_argument where the pinhole does, for coefficients that are not finite or above 100 in
  // magnitude, and for a readout outside 0 to 1 s.
  void check() const;
};

// The camera called name ("tum-fr1", ...), or nothing.
std::optional<DepthCamera> camera_by_name(std::string_view name);

// Every name that camera_by_name knows.
std::vector<std::string> camera_names();

// The pinhole that would have seen every step-th pixel of every step-th row. Throws std::invalid_argument unless step
// is at least 1.
Pinhole thinned(const Pinhole& camera, int step);

// What thinned(camera.pinhole, step) would have seen in place of the camera: each pixel's reading is that of the pixel
// of image that its ray falls on, none outside. Readings are never mixed. Throws std::invalid_argument where the
// image's size is not the camera's.
DepthImage rectify(const DepthImage& image, const DepthCamera& camera, int step = 1);

// The same of an image registered to the camera's depth images: each pixel's brightness is that of the pixel its depth
// came from.
GreyImage rectify(const GreyImage& image, const DepthCamera& camera, int step = 1);

}  // namespace augicp
