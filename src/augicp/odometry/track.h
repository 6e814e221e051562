// SPDX-License-Identifier: MIT
// A whole sequence: the next frame is read and prepared while the present one is registered.
#pragma once

#include <functional>

#include "augicp/odometry/odometry.h"
#include "augicp/sensor/frame_source.h"

namespace augicp {

// Calls on_frame, in the calling thread, with the report of every frame in order; the same for any number of threads.
// An image of another size than the camera's makes its frame Unreadable. Throws Interrupted, once all its threads have
// ended, after a request to options.registration.stop.
void track(FrameSource& source, const DepthCamera& camera, const OdometryOptions& options,
           const std::function<void(const FrameReport&)>& on_frame);

// The same for those who want to see what the tracker knows after the frame too.
void track(FrameSource& source, const DepthCamera& camera, const OdometryOptions& options,
           const std::function<void(const FrameReport&, const Odometry&)>& on_frame);

}  // namespace augicp
