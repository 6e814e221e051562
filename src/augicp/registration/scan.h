// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "augicp/sensor/depth_image.h"

namespace augicp {

// One input of a registration: a cloud, and where it came from a depth image, the pixels and the camera.
struct Scan {
  struct View {
    IndexImage index;
    Pinhole camera;
  };

  Cloud cloud;
  std::optional<View> view;
};

inline Scan scan_of(Cloud cloud) { return {std::move(cloud), std::nullopt}; }

// See unproject().
inline Scan scan_of(const DepthImage& image, const Pinhole& camera, const DepthRange& range = {},
                    const DepthNoise& noise = {}) {
  OrganizedCloud seen = unproject(image, camera, range, noise);
  return {std::move(seen.cloud), Scan::View{std::move(seen.index), camera}};
}

}  // namespace augicp
