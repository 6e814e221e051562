// SPDX-License-Identifier: MIT
#include "augicp/io/camera_parts.h"

#include <stdexcept>

#include "augicp/io/format.h"

namespace augicp {

int image_side(const Numbers& numbers, const char* key) {
  constexpr double kMaxSide = 1 << 20;
  if (!numbers) return 0;
  const double side = numbers->size() == 1 ? numbers->front() : -1.0;
  if (!(side >= 0.0 && side <= kMaxSide))
    throw std::invalid_argument(fmt::format("camera: expected \"{}\" in pixels", key));
  return static_cast<int>(side);
}

// k1 k2 p1 p2, with or without k3.
Distortion distortion_of(const Numbers& numbers, const char* key) {
  if (!numbers) return {};
  std::vector<double> d = *numbers;
  if (d.size() == 4) d.push_back(0.0);
  if (d.size() != 5)
    throw std::invalid_argument(fmt::format("camera: expected \"{}\" with 5 numbers k1 k2 p1 p2 k3", key));
  return {d[0], d[1], d[2], d[3], d[4]};
}

}  // namespace augicp
