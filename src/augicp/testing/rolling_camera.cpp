// SPDX-License-Identifier: MIT
#include "augicp/testing/rolling_camera.h"

#include "augicp/geometry/rotation.h"

namespace augicp::testing {

DepthImage render_rolling(const Scene& scene, const Pinhole& camera, const Rigid3& world_from_middle,
                          const Rigid3& first_from_last) {
  DepthImage image{camera.width, camera.height, {}};
  for (int v = 0; v < camera.height; ++v) {
    const double share = (v + 0.5) / camera.height - 0.5;
    const Rigid3 middle_from_row{rotation_exp(share * rotation_log(first_from_last.rotation)),
                                 share * first_from_last.translation};
    const DepthImage row =
        render(scene, camera, camera.width, camera.height, world_from_middle * middle_from_row).depth;
    for (int u = 0; u < camera.width; ++u) image.depth.push_back(row.at(u, v));
  }
  return image;
}

}  // namespace augicp::testing
