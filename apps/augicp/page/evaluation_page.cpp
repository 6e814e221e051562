// SPDX-License-Identifier: MIT
#include "apps/augicp/page/evaluation_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "apps/augicp/page/odometry_view.h"
#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/thinning.h"
#include "apps/augicp/page/trajectory_lines.h"
#include "apps/augicp/text/evaluation.h"
#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

constexpr std::size_t kMaxMoments = 5000;

// A camera's up direction stays the same while it looks around, and so does a LiDAR's own axis: whichever of the two is
// steadier. A difference below this is none.
constexpr double kSteadier = 0.02;

// Errors of one run at its own moments, ascending.
struct Errors {
  std::vector<double> stamps_s;  // in the clock of the truth
  PoseErrors of;
};

Errors errors_of(const EvaluatedRun& run) {
  const EvaluationOptions& options = run.evaluation.options;
  const std::vector<MatchedPose> poses = match_poses(run.estimate, run.truth, options.association, options.truth);
  Errors errors{{}, absolute_errors(poses, run.evaluation.alignment.target_from_source)};
  for (const MatchedPose& pose : poses) errors.stamps_s.push_back(pose.stamp_s);
  return errors;
}

// The moments of all runs, downsampled.
std::vector<double> moments_of(const std::vector<Errors>& all) {
  std::vector<double> every, kept;
  for (const Errors& errors : all) every.insert(every.end(), errors.stamps_s.begin(), errors.stamps_s.end());
  std::sort(every.begin(), every.end());
  every.erase(std::unique(every.begin(), every.end()), every.end());
  for (const std::uint32_t i : thinned_indices(every.size(), kMaxMoments)) kept.push_back(every[i]);
  return kept;
}

// The polyline through (stamps_s, values) at a moment; NaN before its beginning and behind its end.
double value_at(const std::vector<double>& stamps_s, const std::vector<double>& values, double moment_s) {
  const auto next = std::lower_bound(stamps_s.begin(), stamps_s.end(), moment_s);
  if (next == stamps_s.end()) return std::numeric_limits<double>::quiet_NaN();
  const auto i = static_cast<std::size_t>(next - stamps_s.begin());
  if (*next == moment_s) return values[i];
  if (i == 0) return std::numeric_limits<double>::quiet_NaN();
  const double share = (moment_s - stamps_s[i - 1]) / (stamps_s[i] - stamps_s[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

std::vector<Chart> charts_of(const std::vector<EvaluatedRun>& runs) {
  std::vector<Errors> all;
  for (const EvaluatedRun& run : runs) all.push_back(errors_of(run));
  const std::vector<double> moments = moments_of(all);
  Chart position{"Position error", "time, s", "m"}, rotation{"Rotation error", "time, s", "degrees"};
  position.meaning = "Distance of each position from the true one, after the alignment.";
  rotation.meaning = "Angle between each rotation and the true one, after the alignment.";
  for (const double moment_s : moments) position.x.push_back(moment_s - moments.front());
  rotation.x = position.x;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ChartSeries metres{runs[i].name}, degrees{runs[i].name};
    for (const double moment_s : moments) {
      metres.y.push_back(value_at(all[i].stamps_s, all[i].of.translation, moment_s));
      degrees.y.push_back(kDegPerRad * value_at(all[i].stamps_s, all[i].of.rotation, moment_s));
    }
    position.series.push_back(std::move(metres));
    rotation.series.push_back(std::move(degrees));
  }
  for (Chart* chart : {&position, &rotation}) chart->y_range = AxisRange{0.0, y_range_of(*chart).high};
  return {position, rotation};
}

std::string rmse_text(const std::optional<PoseStatistics>& errors) {
  // A narrow column breaks between the two, not before a unit.
  return errors ? fmt::format("{:.4f}\u00a0m, {:.3f}°", errors->translation.rmse, kDegPerRad * errors->rotation.rmse)
                : "–";
}

std::string table_html(const std::vector<EvaluatedRun>& runs) {
  std::vector<Heading> head{"estimate",
                            {"poses compared", "Poses of the estimate with a true pose of the same moment."},
                            {"ATE", "Root mean square of position and rotation errors, after the alignment."},
                            {"RPE", "The same of the motions between two poses."}};
  const bool has_own_frames =
      std::none_of(runs.begin(), runs.end(), [](const EvaluatedRun& run) { return shares_frame(run.evaluation); });
  if (!has_own_frames) head.push_back({"not aligned", "The same as ATE, without alignment, if both are in one frame."});
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, estimate, truth, evaluation] : runs) {
    rows.push_back({name, fmt::format("{}\u00a0of\u00a0{}", evaluation.num_matched, evaluation.num_estimate),
                    rmse_text(evaluation.aligned), rmse_text(evaluation.relative)});
    if (!has_own_frames)
      rows.back().push_back(shares_frame(evaluation) ? rmse_text(evaluation.absolute) : "another frame");
  }
  return html_table(head, rows);
}

Trajectory in_truth(const EvaluatedRun& run) {
  Trajectory moved = during(run.estimate, run.estimate.front().stamp_s, run.estimate.back().stamp_s);
  for (StampedPose& pose : moved)
    pose.world_from_camera = run.evaluation.alignment.target_from_source * pose.world_from_camera;
  return moved;
}

bool is_lidar(const Trajectory& poses) {
  Vec3d z = Vec3d::Zero(), y = Vec3d::Zero();
  for (const StampedPose& pose : poses) {
    z += pose.world_from_camera.rotation * Vec3d::UnitZ();
    y += pose.world_from_camera.rotation * Vec3d::UnitY();
  }
  return z.norm() > (1.0 + kSteadier) * y.norm();
}

// The estimates in the truth's world, and the truth behind them.
std::vector<Trajectory> paths_of(const std::vector<EvaluatedRun>& runs) {
  std::vector<Trajectory> paths;
  double first_s = std::numeric_limits<double>::infinity(), last_s = -first_s;
  for (const EvaluatedRun& run : runs) {
    paths.push_back(in_truth(run));
    first_s = std::min(first_s, run.evaluation.first_stamp_s);
    last_s = std::max(last_s, run.evaluation.last_stamp_s);
  }
  paths.push_back(during(runs.front().truth, first_s, last_s));
  return paths;
}

OdometryView view_of(const std::vector<Trajectory>& paths) {
  OdometryView view;
  Eigen::AlignedBox3d box;
  for (const Trajectory& path : paths)
    for (const StampedPose& pose : path) box.extend(pose.world_from_camera.translation);
  orient(view, paths.back(), is_lidar(paths.back()));
  view.centre = box.center();
  return view;
}

std::string top_view_html(const OdometryView& view, const std::vector<Trajectory>& paths,
                          const std::vector<std::string>& names) {
  std::vector<Path> drawn;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Path path{names[i], {}};
    for (const StampedPose& pose : paths[i])
      path.points.push_back(view.from_above(pose.world_from_camera.translation - view.centre));
    drawn.push_back(std::move(path));
  }
  return legend_html(names) + paths_svg("Trajectories from above", "m", "m", drawn);
}

nlohmann::ordered_json paths_json(const OdometryView& view, const std::vector<Trajectory>& paths,
                                  const std::vector<std::string>& names) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < paths.size(); ++i)
    json.push_back({{"name", names[i]}, {"lines", trajectory_lines(paths[i], view.centre)}});
  return json;
}

}  // namespace

std::string evaluation_page(const std::string& truth_name, const std::vector<EvaluatedRun>& runs) {
  const std::vector<Trajectory> paths = paths_of(runs);
  const OdometryView view = view_of(paths);
  const std::vector<Chart> charts = charts_of(runs);
  PageHead head{"Trajectories", "", "", {"Ground truth: " + truth_name}};
  std::vector<std::string> names;
  for (const EvaluatedRun& run : runs) names.push_back(run.name);
  head.lines.push_back("Alignment: " + std::string(name_of(runs.front().evaluation.options.alignment)));
  const std::string key = legend_html(names);
  names.emplace_back("ground truth");
  const std::string body = "<main class=\"staged\">\n<div id=\"stage\"></div>\n<div class=\"side\">\n" +
                           section_html("Errors against the ground truth", table_html(runs)) +
                           section_html("Over time", key + figures_html(charts)) +
                           section_html("From above", top_view_html(view, paths, names)) + "</div>\n</main>\n";
  return whole_page(
      head, "trajectories", body, charts,
      {{"paths", paths_json(view, paths, names)}, {"zero", numbers(view.centre)}, {"view", camera_json(view)}});
}

}  // namespace augicp::app
