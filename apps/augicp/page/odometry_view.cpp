// SPDX-License-Identifier: MIT
#include "apps/augicp/page/odometry_view.h"

#include <algorithm>

#include "apps/augicp/page/packing.h"
#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/thinning.h"

namespace augicp::app {
namespace {

constexpr std::size_t kMaxTruePoses = 5000;

// True poses farther apart in time are not joined by a line, seconds.
constexpr double kMaxGap_s = 1.0;

Trajectory during(const Trajectory& truth, const Trajectory& estimate, double offset_s) {
  Trajectory within;
  if (estimate.empty()) return within;
  for (const StampedPose& pose : truth)
    if (pose.stamp_s >= estimate.front().stamp_s + offset_s - 0.1 &&
        pose.stamp_s <= estimate.back().stamp_s + offset_s + 0.1)
      within.push_back(pose);
  Trajectory thinned;
  for (const std::uint32_t i : thinned_indices(within.size(), kMaxTruePoses)) thinned.push_back(within[i]);
  return thinned;
}

// The axis, with its sign, that is nearest to this direction.
Vec3d nearest_axis(const Vec3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return Vec3d::Unit(axis) * (direction[axis] < 0.0 ? -1.0 : 1.0);
}

// A camera looks along z with y down; a LiDAR has z up, and x ahead.
void orient(OdometryView& view, const Trajectory& in_truth, bool is_lidar) {
  const Vec3d own_up = is_lidar ? Vec3d(Vec3d::UnitZ()) : Vec3d(-Vec3d::UnitY());
  const Vec3d own_ahead = is_lidar ? Vec3d(Vec3d::UnitX()) : Vec3d(Vec3d::UnitZ());
  Vec3d up = Vec3d::Zero(), looks = Vec3d::Zero();
  for (const StampedPose& pose : in_truth) {
    up += pose.world_from_camera.rotation * own_up;
    looks += pose.world_from_camera.rotation * own_ahead;
  }
  if (up.norm() > 0.0) view.up = nearest_axis(up);
  view.ahead = std::abs(view.up.z()) > 0.5 ? Vec3d::UnitY() : Vec3d::UnitZ();
  view.right = (-view.up).cross(view.ahead);
  looks -= view.up * view.up.dot(looks);
  view.looks = looks.norm() > 1e-6 ? Vec3d(looks.normalized()) : view.ahead;
}

void add_line(std::vector<Vec3f>& lines, const Vec3d& from, const Vec3d& to) {
  lines.push_back(from.cast<float>());
  lines.push_back(to.cast<float>());
}

}  // namespace

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
    view.truth = during(*picture.sequence->truth, estimate, run.evaluation->options.association.time_offset_s);
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

std::string truth_lines(const OdometryView& view) {
  std::vector<Vec3f> lines;
  for (std::size_t i = 1; i < view.truth.size(); ++i)
    if (view.truth[i].stamp_s - view.truth[i - 1].stamp_s <= kMaxGap_s)
      add_line(lines, view.truth[i - 1].world_from_camera.translation - view.centre,
               view.truth[i].world_from_camera.translation - view.centre);
  return packed_points(lines);
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
