// SPDX-License-Identifier: MIT
#include "augicp/shutter/rolling_shutter.h"

#include "augicp/geometry/rotation.h"
#include "augicp/sensor/projection.h"

namespace augicp {

Rigid3 part_of(const Rigid3& motion, double share) {
  return {rotation_exp(share * rotation_log(motion.rotation)), share * motion.translation};
}

Scan without_skew(const Scan& scan, const Rigid3& first_from_last, int num_threads) {
  Scan straight = scan;
  Cloud& cloud = straight.cloud;
  const IndexImage& seen = scan.view->index;
  for (int v = 0; v < seen.height; ++v) {
    const Rigid3f middle_from_row(part_of(first_from_last, (v + 0.5) / seen.height - 0.5));
    for (int u = 0; u < seen.width; ++u) {
      const std::int32_t i = seen.at(u, v);
      if (i == IndexImage::kNone) continue;
      cloud.points[i] = middle_from_row * scan.cloud.points[i];
      if (scan.cloud.has_directions()) cloud.directions[i] = middle_from_row.rotation * scan.cloud.directions[i];
      if (scan.cloud.has_intensity_gradients())
        cloud.intensity_gradients[i] = middle_from_row.rotation * scan.cloud.intensity_gradients[i];
      if (scan.cloud.has_gaussians()) cloud.gaussians[i] = middle_from_row * scan.cloud.gaussians[i];
    }
  }
  straight.view->index = project(cloud, Rigid3{}, scan.view->camera, seen.width, seen.height, num_threads);
  return straight;
}

}  // namespace augicp
