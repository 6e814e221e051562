// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "apps/augicp/text/odometry.h"
#include "augicp/io/depth_sequence.h"

namespace augicp::app {

// The local model after a frame of a depth camera, or a scan of a LiDAR, downsampled.
struct KeptModel {
  std::size_t row = 0;  // index in OdometryRun::rows
  Rigid3 world_from_model;
  Cloud cloud;
};

// The content of the page of `augicp odometry --report`. A view. REQUIRES: all of it outlives the picture.
struct OdometryPicture {
  const OdometryRun& run;
  const std::vector<KeptModel>& models;
  const DepthSequence* sequence = nullptr;  // none: a LiDAR's
  double depth_scale = 0.0;

  bool is_lidar() const { return sequence == nullptr; }
};

}  // namespace augicp::app
