// SPDX-License-Identifier: MIT
// A trajectory in the form that a page draws.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "apps/augicp/page/chart.h"
#include "apps/augicp/page/odometry_picture.h"

namespace augicp::app {

// The page's frame: the true world if there is one, with the estimate aligned to it, else the estimate's world; its
// zero is in the middle of the trajectory.
struct OdometryView {
  Similarity3 truth_from_world;
  Vec3d centre = Vec3d::Zero();
  double extent = 1.0;           // of the trajectory, metres, above 0
  Vec3d up = -Vec3d::UnitY();    // the axis, or its opposite, that is most upwards for the camera
  Vec3d right = Vec3d::UnitX();  // right in a view from above
  Vec3d ahead = Vec3d::UnitZ();  // up in that view
  Vec3d looks = Vec3d::UnitZ();  // the camera's mean viewing direction
  Trajectory truth;              // during the run, downsampled

  Rigid3 page_from(const Rigid3& world_from_body) const;
  Eigen::Vector2d from_above(const Vec3d& in_page) const { return {right.dot(in_page), ahead.dot(in_page)}; }
};
OdometryView view_of(const OdometryPicture& picture);

// Sets the directions of the view by poses in the page's frame. A camera looks along z with y down; a LiDAR has z up,
// and x ahead.
void orient(OdometryView& view, const Trajectory& in_page, bool is_lidar);

nlohmann::ordered_json camera_json(const OdometryView& view);
std::string top_view_svg(const OdometryRun& run, const OdometryView& view);

}  // namespace augicp::app
