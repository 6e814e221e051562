// SPDX-License-Identifier: MIT
// Tracks a whole sequence: the next frame is read and prepared during the registration of the present one.
#pragma once

#include <functional>

#include "augicp/odometry/odometry.h"
#include "augicp/sensor/frame_source.h"

namespace augicp {

// Calls on_frame, in the calling thread, with the report of every frame in order; bit-identical for any number of
// threads. An image whose size is not the camera's makes its frame Unreadable. Throws TooMuchMemory, and Interrupted
// after a request to options.registration.stop, once all its threads have ended.
void track(FrameSource& source, const DepthCamera& camera, const OdometryOptions& options,
           const std::function<void(const FrameReport&)>& on_frame);

// The same, with the state of the tracker after each frame.
void track(FrameSource& source, const DepthCamera& camera, const OdometryOptions& options,
           const std::function<void(const FrameReport&, const Odometry&)>& on_frame);

}  // namespace augicp
