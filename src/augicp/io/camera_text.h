// SPDX-License-Identifier: MIT
// Cameras in the texts that other programs write.
#pragma once

#include <span>
#include <string_view>

#include "augicp/sensor/depth_camera.h"

namespace augicp {

// JSON of Open3D (intrinsic_matrix column by column, or row by row, also within "intrinsic"), with a matrix
// camera_matrix or K, or of a RealSense camera (fx, fy, ppx or cx, ppy or cy, coeffs, model); "distortion" and
// "readout_s" may follow. Throws std::invalid_argument.
DepthCamera camera_from_json(std::string_view text);

// YAML of ROS (camera_matrix with data, or k; distortion_coefficients or d; image_width or width) or of OpenCV; of
// kalibr and EuRoC (intrinsics with fx fy cx cy); of ORB-SLAM (Camera.fx) and other lines "fx: 525" or "fx = 525".
// Throws std::invalid_argument, also for several cameras in one file and for models other than a pinhole with
// plumb_bob.
DepthCamera camera_from_yaml(std::string_view text);

// Whether the text has the keys of such a file.
bool looks_like_yaml(std::string_view text);

// A matrix row by row: fx 0 cx, 0 fy cy, 0 0 1. Throws std::invalid_argument for any other.
Pinhole pinhole_from_matrix(std::span<const double, 9> rows);

}  // namespace augicp
