// SPDX-License-Identifier: MIT
// Depth images and local models of some frames, in small.
#pragma once

#include <cstdint>
#include <vector>

#include "apps/augicp/page/odometry_view.h"

namespace augicp::app {

KeptModel kept_model(std::size_t row, const Odometry& odometry);

// A LiDAR's scan in its sensor's frame.
KeptModel kept_scan(std::size_t row, const Rigid3& world_from_sensor, const Cloud& scan);

// The rows with a depth image and local model in the page, ascending: all of a short run; of a long one a number that
// keeps the file below 15 MB.
std::vector<std::uint32_t> kept_rows(std::size_t num_rows);

// The depth images, read a second time, and the local models of the kept frames.
nlohmann::ordered_json kept_json(const OdometryPicture& picture, const OdometryView& view);

}  // namespace augicp::app
