// SPDX-License-Identifier: MIT
#include "apps/augicp/page/odometry_view.h"

#include <algorithm>

#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/trajectory_lines.h"

namespace augicp::app {
namespace {

// The axis, with its sign, that is nearest to this direction.
Vec3d nearest_axis(const Vec3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return Vec3d::Unit(axis) * (direction[axis] < 0.0 ? -1.0 : 1.0);
}

}  // namespace

void orient(OdometryView& view, const Trajectory& in_page, bool is_lidar) {
  const Vec3d own_up = is_lidar ? Vec3d(Vec3d::UnitZ()) : Vec3d(-Vec3d::UnitY());
  const Vec3d own_ahead = is_lidar ? Vec3d(Vec3d::UnitX()) : Vec3d(Vec3d::UnitZ());
  Vec3d up = Vec3d::Zero(), looks = Vec3d::Zero();
  for (const StampedPose& pose : in_page) {
    up += pose.world_from_camera.rotation * own_up;
    looks += pose.world_from_camera.rotation * own_ahead;
  }
  if (up.norm() > 0.0) view.up = nearest_axis(up);
  view.ahead = std::abs(view.up.z()) > 0.5 ? Vec3d::UnitY() : Vec3d::UnitZ();
  view.right = (-view.up).cross(view.ahead);
  looks -= view.up * view.up.dot(looks);
  view.looks = looks.norm() > 1e-6 ? Vec3d(looks.normalized()) : view.ahead;
}

Rigid3 OdometryView::page_from(const Rigid3& world_from_body) const {
  Rigid3 pose = truth_from_world * world_from_body;
  pose.translation -= centre;
  return pose;
}

OdometryView view_of(const OdometryPicture& picture) {
  OdometryView view;
  const OdometryRun& run = picture.run;
  Trajectory estimate = trajectory_of(run);
  if (run.evaluation && picture.sequence) {
    view.truth_from_world = run.evaluation->alignment.target_from_source;
    const double offset_s = run.evaluation->options.association.time_offset_s;
    if (!estimate.empty())
      view.truth =
          during(*picture.sequence->truth, estimate.front().stamp_s + offset_s, estimate.back().stamp_s + offset_s);
  }
  for (StampedPose& pose : estimate) pose.world_from_camera = view.truth_from_world * pose.world_from_camera;
  if (estimate.empty()) return view;
  orient(view, estimate, picture.is_lidar());
  Eigen::AlignedBox3d box;
  for (const StampedPose& pose : estimate) box.extend(pose.world_from_camera.translation);
  view.centre = box.center();
  const double least = 0.3;  // for a camera that hardly moved, show the surroundings
  view.extent = std::clamp(box.diagonal().norm(), least, 1e6);
  return view;
}

nlohmann::ordered_json camera_json(const OdometryView& view) {
  return {{"up", numbers(view.up)}, {"ahead", numbers(view.looks)}};
}

std::string top_view_svg(const OdometryRun& run, const OdometryView& view) {
  Path truth{"ground truth", {}}, estimate{"estimate", {}};
  for (const StampedPose& pose : view.truth)
    truth.points.push_back(view.from_above(pose.world_from_camera.translation - view.centre));
  for (const FrameRow& row : run.rows)
    if (has_pose(row.report.status))
      estimate.points.push_back(view.from_above(view.page_from(row.report.world_from_camera).translation));
  const std::vector<Path> paths = truth.points.empty() ? std::vector{Path{}, estimate} : std::vector{truth, estimate};
  return paths_svg("Trajectory from above", "m", "m", paths);
}

}  // namespace augicp::app
