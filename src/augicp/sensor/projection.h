// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/sensor/pinhole.h"

namespace augicp {

// Which point of the cloud a camera would see in each pixel, were nothing but these points there: where several fall on
// one pixel, the nearest to the camera (a z-buffer); the lowest index among equally near. camera_from_points maps the
// cloud's points, without their origin, into the camera frame. The result is the same for any number of threads.
IndexImage project(const Cloud& cloud, const Rigid3& camera_from_points, const Pinhole& camera, int width, int height,
                   int num_threads = 0);

}  // namespace augicp
