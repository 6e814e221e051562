// SPDX-License-Identifier: MIT
// Clouds in the form that a page draws: around its zero, downsampled, packed.
#pragma once

#include <nlohmann/json.hpp>

#include "apps/augicp/page/align_picture.h"

namespace augicp::app {

// The page's frame: the target's, with its zero at the centre of the target's points, so that float is precise enough.
struct CloudFrame {
  const Cloud* source = nullptr;
  const Cloud* target = nullptr;
  Vec3f centre = Vec3f::Zero();       // of the target's points, relative to its origin
  Vec3d target_zero = Vec3d::Zero();  // the page's zero in the target's frame
  double extent = 1.0;                // of the visible points, metres, above 0
};
CloudFrame frame_of(const Scan& source, const Scan& target);

// For the source's points as stored, without their origin.
Rigid3 page_from_source(const CloudFrame& frame, const Rigid3& target_from_source);

// Both clouds; the source's points with their signed distances from the target's surface under the final pose, and the
// direction in which each is measured.
struct PairedClouds {
  nlohmann::ordered_json source, target;
  std::string pairs;  // some correspondences: a source point and its target point in the page, in turn
};
PairedClouds paired_clouds(const AlignPicture& picture, const CloudFrame& frame);

// The component-wise median in the cloud's frame; zero for an empty cloud.
Vec3d middle_of(const Cloud& cloud);

}  // namespace augicp::app
