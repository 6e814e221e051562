// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "augicp/sensor/depth_image.h"

namespace augicp {

// Where nothing says how many frames a second there were.
inline constexpr double kUsualFramesPerS = 30.0;

struct DepthFrame {
  double stamp_s = 0.0;
  DepthImage image;
  std::string problem;  // not empty: the image could not be read, and why
};

// Where the frames of a sequence come from. next() is called from one thread at a time, though not always the same.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // The next frame, or nothing after the last. What it throws ends the run.
  virtual std::optional<DepthFrame> next() = 0;
};

}  // namespace augicp
