// SPDX-License-Identifier: MIT
#include "augicp/testing/rolling_camera.h"

#include "augicp/geometry/rotation.h"

namespace augicp::testing {

std::vector<float> render_row(const Scene& scene, const Pinhole& camera, int v, const Rigid3& world_from_camera) {
  const Pinhole of_row{camera.fx, camera.fy, camera.cx, camera.cy - v, camera.width, 1};
  return render(scene, of_row, of_row.width, of_row.height, world_from_camera).depth.depth;
}

DepthImage render_rolling(const Scene& scene, const Pinhole& camera, const Rigid3& world_from_middle,
                          const Rigid3& first_from_last) {
  DepthImage image{camera.width, camera.height, {}};
  for (int v = 0; v < camera.height; ++v) {
    const double share = (v + 0.5) / camera.height - 0.5;
    const Rigid3 middle_from_row{rotation_exp(share * rotation_log(first_from_last.rotation)),
                                 share * first_from_last.translation};
    const std::vector<float> row = render_row(scene, camera, v, world_from_middle * middle_from_row);
    image.depth.insert(image.depth.end(), row.begin(), row.end());
  }
  return image;
}

}  // namespace augicp::testing
