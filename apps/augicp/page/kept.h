// SPDX-License-Identifier: MIT
// Depth images and local models of some frames, in small.
#pragma once

#include <cstdint>
#include <vector>

#include "apps/augicp/page/odometry_view.h"

namespace augicp::app {

KeptModel kept_model(std::size_t row, const Odometry& odometry);

// The rows whose depth image and local model the page has, ascending: all of a short run, of a long one so many that
// the file stays below 15 MB.
std::vector<std::uint32_t> kept_rows(std::size_t num_rows);

// The depth images, read once more, and the local models of the frames that are kept.
nlohmann::ordered_json kept_json(const OdometryPicture& picture, const OdometryView& view);

}  // namespace augicp::app
