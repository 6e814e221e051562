// SPDX-License-Identifier: MIT
// What `augicp odometry --report` shows.
#pragma once

#include <string>
#include <vector>

#include "apps/augicp/report_odometry.h"
#include "augicp/io/depth_sequence.h"

namespace augicp::app {

// The local model after a frame, thinned.
struct KeptModel {
  std::size_t row = 0;  // of OdometryRun::rows
  Rigid3 world_from_model;
  Cloud cloud;
};
KeptModel kept_model(std::size_t row, const Odometry& odometry);

// The rows whose depth image and local model the page has, ascending: all of a short run, of a long one so many that
// the file stays below 15 MB.
std::vector<std::uint32_t> kept_rows(std::size_t num_rows);

struct OdometryPicture {
  const OdometryRun& run;
  const DepthSequence& sequence;
  double depth_scale = 0.0;
  const std::vector<KeptModel>& models;
};
void write_odometry_page(const std::string& path, const OdometryPicture& picture);

}  // namespace augicp::app
