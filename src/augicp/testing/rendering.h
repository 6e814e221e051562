// SPDX-License-Identifier: MIT
// The view of a depth camera on a generated scene, and its noise.
#pragma once

#include <vector>

#include "augicp/sensor/depth_image.h"
#include "augicp/sensor/pinhole.h"
#include "augicp/testing/scene.h"

namespace augicp::testing {

// An exact depth image and the truth of each of its pixels, row-major like the depth.
struct Rendering {
  static constexpr int kNothing = -1;

  Pinhole camera;
  Rigid3 world_from_camera;
  DepthImage depth;           // NaN if the ray meets nothing
  std::vector<int> surface;   // number of the surface in the scene; kNothing if the ray meets nothing
  std::vector<Vec3f> normal;  // unit, camera frame, towards the camera; zero if the ray meets nothing
};

Rendering render(const Scene& scene, const Pinhole& camera, int width, int height, const Rigid3& world_from_camera);

// From the scene's own place, at the size of the camera.
Rendering render(const Scene& scene, const Pinhole& camera);

// A depth camera with the field of view of a Kinect (58 x 45 degrees) and images of this width, at 4:3.
Pinhole kinect_like_camera(int width = 320);

// The depth noise of the first Kinect: its standard deviation grows with depth squared (Khoshelham and Elberink,
// Sensors 2012: 1.425e-3 at 1 m; most report 1.2 to 1.5).
inline constexpr double kKinectSigmaAt1m = 0.0012;

// Adds normal noise with standard deviation sigma_at_1m * depth^2, metres.
void add_depth_noise(DepthImage& image, double sigma_at_1m, unsigned seed);

// The first Kinect's steps: 1/8 pixel of disparity at a focal length of 580 pixels and a base of 7.5 cm.
inline constexpr double kKinectStepAt1m = 0.125 / (580.0 * 0.075);

// Rounds inverse depth to steps of step_at_1m, which makes steps of step_at_1m * depth^2 in depth, metres.
void quantise_disparity(DepthImage& image, double step_at_1m = kKinectStepAt1m);

}  // namespace augicp::testing
