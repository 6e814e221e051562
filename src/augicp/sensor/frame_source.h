// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "augicp/sensor/depth_image.h"

namespace augicp {

// The frame rate if none is given, per second.
inline constexpr double kUsualFramesPerS = 30.0;

struct DepthFrame {
  double stamp_s = 0.0;
  DepthImage image;
  std::string problem;  // why the image could not be read; empty if it could
};

// A source of the frames of a sequence. Thread safety: one thread at a time calls next(), though not always the same
// thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // The next frame; empty after the last. An exception ends the run.
  virtual std::optional<DepthFrame> next() = 0;
};

}  // namespace augicp
