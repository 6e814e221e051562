// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "apps/augicp/text/odometry.h"
#include "augicp/io/depth_sequence.h"

namespace augicp::app {

// The local model after a frame, thinned.
struct KeptModel {
  std::size_t row = 0;  // of OdometryRun::rows
  Rigid3 world_from_model;
  Cloud cloud;
};

// What the page of `augicp odometry --report` is drawn from. A view: all of it must outlive the picture.
struct OdometryPicture {
  const OdometryRun& run;
  const DepthSequence& sequence;
  double depth_scale = 0.0;
  const std::vector<KeptModel>& models;
};

}  // namespace augicp::app
