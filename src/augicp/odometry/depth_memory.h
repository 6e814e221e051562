// SPDX-License-Identifier: MIT
// The memory that tracking a depth camera needs: it does not grow with the number of frames.
#pragma once

#include "augicp/odometry/odometry.h"

namespace augicp {

// 10^9 bytes, for images of this size of which every pixel_step-th pixel and row is used. REQUIRES: pixel_step >= 1.
double depth_memory_gb(int width, int height, int pixel_step);

// Throws TooMuchMemory if images of this size need more than options.registration.max_memory_gb allows. Its pixel step
// is enough.
void require_memory(int width, int height, int pixel_step, const OdometryOptions& options);

}  // namespace augicp
