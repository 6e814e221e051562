// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/sensor/pinhole.h"

namespace augicp {

// Projects a cloud into a camera: the index of the point that each pixel sees. If several points fall on a pixel, the
// nearest to the camera wins (a z-buffer), and among equally near ones the lowest index. camera_from_points maps the
// cloud's points, without their origin, into the camera frame. Bit-identical for any number of threads.
IndexImage project(const Cloud& cloud, const Rigid3& camera_from_points, const Pinhole& camera, int width, int height,
                   int num_threads = 0);

}  // namespace augicp
