// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "augicp/sensor/depth_camera.h"

namespace augicp {

// One input of a registration: a cloud and, if it comes from a depth image, the pixels and the camera.
struct Scan {
  struct View {
    IndexImage index;
    Pinhole camera;
    bool rolling_shutter = false;  // whether the rows were read one after the other
  };

  Cloud cloud;
  std::optional<View> view;

  // Whether a cloud without a view is known to be one sensor's scan from its assumed place, see match/ray_spacing.h.
  // Found by prepare(), before it thins the cloud.
  bool place_is_known = false;
};

inline Scan scan_of(Cloud cloud) { return {std::move(cloud), std::nullopt}; }

// A scan from an image of a pinhole camera. See unproject().
inline Scan scan_of(const DepthImage& image, const Pinhole& camera, const DepthRange& range = {},
                    const DepthNoise& noise = {}) {
  OrganizedCloud seen = unproject(image, camera, range, noise);
  return {std::move(seen.cloud), Scan::View{std::move(seen.index), camera, false}};
}

// A scan from an image of a real camera; the lens is removed, see rectify().
inline Scan scan_of(const DepthImage& image, const DepthCamera& camera, int step = 1, const DepthRange& range = {}) {
  Scan scan = scan_of(rectify(image, camera, step), thinned(camera.pinhole, step), range);
  scan.view->rolling_shutter = camera.readout_s > 0.0;
  return scan;
}

// The same with the brightness of a colour image that is registered to the depth image. Throws std::invalid_argument if
// their sizes differ.
inline Scan scan_of(const DepthImage& image, const GreyImage& colour, const DepthCamera& camera, int step = 1,
                    const DepthRange& range = {}) {
  Scan scan = scan_of(image, camera, step, range);
  add_intensities(scan.cloud, scan.view->index, rectify(colour, camera, step));
  return scan;
}

}  // namespace augicp
