// SPDX-License-Identifier: MIT
#pragma once

namespace augicp {

// A pinhole camera without distortion. Camera frame: x right, y down, z forward. Pixel (0, 0) is the centre of the
// first pixel. All values in pixels.
struct Pinhole {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  int width = 0;  // size of the images of this camera; 0: unknown, any size fits
  int height = 0;

  // Throws std::invalid_argument unless the focal lengths are from 0.001 to 1e6 and the centre is within 1e6 of zero.
  void check() const;
};

}  // namespace augicp
