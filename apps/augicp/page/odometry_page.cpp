// SPDX-License-Identifier: MIT
#include "apps/augicp/page/odometry_page.h"

#include <fmt/core.h>

#include "apps/augicp/page/kept.h"
#include "apps/augicp/page/odometry_view.h"
#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/status_strip.h"
#include "apps/augicp/page/trajectory_lines.h"
#include "apps/augicp/text/evaluation.h"
#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

double seconds(const OdometryRun& run, double stamp_s) { return stamp_s - run.rows.front().report.stamp_s; }

std::vector<Chart> error_charts(const OdometryPicture& picture) {
  const EvaluationOptions& options = picture.run.evaluation->options;
  const std::vector<MatchedPose> poses =
      match_poses(trajectory_of(picture.run), *picture.sequence->truth, options.association, options.truth);
  const PoseErrors errors = absolute_errors(poses, picture.run.evaluation->alignment.target_from_source);
  Chart position{"Position error, after alignment", "time, s", "m"}, rotation{"Rotation error", "time, s", "degrees"};
  position.meaning = "Distance of each position from the true one, after one rigid motion of the whole trajectory.";
  rotation.meaning = "Angle between each rotation and the true one, after the same motion.";
  position.series = {{"position error, m", errors.translation}};
  rotation.series = {{"rotation error, degrees", errors.rotation}};
  for (double& angle : rotation.series[0].y) angle *= kDegPerRad;
  for (const MatchedPose& pose : poses)
    position.x.push_back(seconds(picture.run, pose.stamp_s - options.association.time_offset_s));
  rotation.x = position.x;
  for (Chart* chart : {&position, &rotation}) chart->y_range = AxisRange{0.0, y_range_of(*chart).high};
  return {position, rotation};
}

std::vector<Chart> charts_of(const OdometryPicture& picture) {
  std::vector<Chart> charts;
  if (picture.run.evaluation && picture.sequence) charts = error_charts(picture);
  const std::string model = picture.is_lidar() ? "map" : "local model";
  Chart overlap{"Overlap with the " + model, "time, s", "%"};
  Chart distance{"RMS distance of correspondences", "time, s", "mm"};
  overlap.meaning = "The part of a frame's points that have a correspondence in the " + model + ".";
  distance.meaning = "From point to point. It is mostly the spacing of the points, not an error of the pose.";
  overlap.series = {{"overlap, %"}};
  distance.series = {{"RMS, mm"}};
  overlap.y_range = AxisRange{0.0, 100.0};
  double last_s = -1.0;
  for (const FrameRow& row : picture.run.rows) {
    const double time_s = seconds(picture.run, row.report.stamp_s);
    if (!row.report.registration || !(time_s > last_s)) continue;  // charts go forward in time
    last_s = time_s;
    for (Chart* chart : {&overlap, &distance}) chart->x.push_back(time_s);
    overlap.series[0].y.push_back(100.0 * row.report.overlap);
    distance.series[0].y.push_back(1000.0 * row.report.rmse);
  }
  charts.push_back(overlap);
  charts.push_back(distance);
  return charts;
}

nlohmann::ordered_json frames_json(const OdometryRun& run, const OdometryView& view) {
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();
  for (const FrameRow& row : run.rows) {
    const FrameReport& report = row.report;
    const double time_s = seconds(run, report.stamp_s);
    std::string text = fmt::format("Frame {}, {:.2f} s: {}", row.frame, time_s, name_of(report.status));
    if (report.is_keyframe) text += ", keyframe";
    if (!report.problem.empty()) text += ": " + report.problem;
    nlohmann::ordered_json frame{{"text", text},
                                 {"time", time_s},
                                 {"pose", nullptr},
                                 {"top", nullptr},
                                 {"status", status_class(report.status)},
                                 {"segment", report.segment}};
    if (has_pose(report.status)) {
      const Rigid3 pose = view.page_from(report.world_from_camera);
      const Eigen::Vector2d top = view.from_above(pose.translation);
      frame["pose"] = pose_numbers(pose);
      frame["top"] = {top.x(), top.y()};
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<std::string> table_row(const std::string& name, const Statistics& statistics, double unit) {
  std::vector<std::string> row{name};
  for (const double value : {statistics.rmse, statistics.mean, statistics.median, statistics.std, statistics.max})
    row.push_back(fmt::format("{:.{}f}", unit * value,
                              unit == 1.0 ? 4 : 3));  // a tenth of a millimetre, a thousandth of a degree
  return row;
}

std::string errors_html(const Evaluation& evaluation) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& name, const PoseStatistics& errors) {
    rows.push_back(table_row(name + ", m", errors.translation, 1.0));
    rows.push_back(table_row(name + ", °", errors.rotation, kDegPerRad));
  };
  if (evaluation.aligned) add("Whole trajectory (ATE)", *evaluation.aligned);
  if (evaluation.relative) add("From frame to frame (RPE)", *evaluation.relative);
  std::string html = fmt::format("<p>{} of {} poses have a true one of the same moment.</p>\n", evaluation.num_matched,
                                 evaluation.num_estimate);
  if (shares_frame(evaluation))
    add("Without alignment", evaluation.absolute);
  else
    html += "<p>The two trajectories are in different frames. Errors are measured after alignment.</p>\n";
  return html + html_table({"",
                            {"RMSE", "Root of the mean squared error."},
                            {"mean", "The mean error."},
                            {"median", "Half of the errors are smaller."},
                            {"std", "Standard deviation of the errors about their mean."},
                            {"max", "The largest error."}},
                           rows);
}

std::string kept_text(const OdometryPicture& picture) {
  if (picture.models.size() == picture.run.rows.size()) return {};
  return fmt::format("<p>{} kept for {} of {} frames; the last one before the frame chosen is shown.</p>\n",
                     picture.is_lidar() ? "Scans are" : "Depth image and local model are", picture.models.size(),
                     picture.run.rows.size());
}

std::string side_html(const OdometryPicture& picture, const OdometryView& view, const std::vector<Chart>& charts) {
  const OdometryRun& run = picture.run;
  std::string side = section_html("Frames", strip_html(run) + kept_text(picture));
  if (run.evaluation) side += section_html("Errors against the ground truth", errors_html(*run.evaluation));
  if (!run.evaluation_problem.empty())
    side += section_html("Not compared with the ground truth", "<p>" + escaped_html(run.evaluation_problem) + "</p>\n");
  side += section_html("Over time", figures_html(charts));
  const std::vector<std::string> names =
      view.truth.empty() ? std::vector<std::string>{} : std::vector<std::string>{"ground truth", "estimate"};
  return side + section_html("From above", legend_html(names) + top_view_svg(run, view));
}

PageHead head_of(const OdometryRun& run) {
  const bool is_good = mostly_tracked(run) && num_segments(run) == 1;
  PageHead head{run.point_times.empty() ? "Odometry" : "LiDAR odometry",
                is_good                 ? "tracked"
                : num_segments(run) > 1 ? "lost in between"
                                        : "hardly tracked",
                is_good ? "good" : "warn",
                {"Sequence: " + run.sequence}};
  head.lines.push_back(fmt::format("{} frames, {} with a pose", run.rows.size(), trajectory_of(run).size()));
  if (!run.point_times.empty()) head.lines.push_back("Times of the points: " + run.point_times);
  if (run.map_voxels) head.lines.push_back("Voxels of the map: " + voxels_text(*run.map_voxels));
  for (const std::string& warning : run.warnings) head.lines.push_back("Warning: " + warning);
  return head;
}

}  // namespace

std::string odometry_page(const OdometryPicture& picture) {
  const OdometryView view = view_of(picture);
  const std::vector<Chart> charts = charts_of(picture);
  const std::string body = "<main class=\"staged\">\n<div id=\"stage\"></div>\n<div class=\"side\">\n" +
                           side_html(picture, view, charts) + "</div>\n</main>\n";
  nlohmann::ordered_json data{{"frames", frames_json(picture.run, view)},
                              {"kept", kept_json(picture, view)},
                              {"lidar", picture.is_lidar()},
                              {"has_truth", !view.truth.empty()},
                              {"truth", trajectory_lines(view.truth, view.centre)},
                              {"extent", view.extent},
                              {"zero", numbers(view.centre)},
                              {"view", camera_json(view)}};
  return whole_page(head_of(picture.run), "odometry", body, charts, std::move(data));
}

}  // namespace augicp::app
