// SPDX-License-Identifier: MIT
#include "apps/augicp/text/odometry.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/augicp/text/evaluation.h"

namespace augicp::app {
namespace {

std::size_t num_with(const OdometryRun& run, FrameStatus status) {
  return static_cast<std::size_t>(std::count_if(run.rows.begin(), run.rows.end(),
                                                [&](const FrameRow& row) { return row.report.status == status; }));
}

double median_time_ms(const OdometryRun& run) {
  if (run.rows.empty()) return 0.0;
  std::vector<double> times;
  for (const FrameRow& row : run.rows) times.push_back(row.time_ms);
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

double frames_per_s(const OdometryRun& run) {
  return run.total_ms > 0.0 ? 1000.0 * static_cast<double>(run.rows.size()) / run.total_ms : 0.0;
}

std::string in_csv(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string counts_text(const OdometryRun& run) {
  std::string text;
  for (const auto& [status, word] : kWords<FrameStatus>)
    if (const std::size_t count = num_with(run, status); count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word);
  return text;
}

}  // namespace

int num_segments(const OdometryRun& run) { return static_cast<int>(num_with(run, FrameStatus::Started)); }

bool mostly_tracked(const OdometryRun& run) {
  return 2 * (num_with(run, FrameStatus::Tracked) + num_with(run, FrameStatus::Started)) >= run.rows.size();
}

Trajectory trajectory_of(const OdometryRun& run) {
  Trajectory trajectory;
  for (const FrameRow& row : run.rows)
    if (has_pose(row.report.status)) trajectory.push_back({row.report.stamp_s, row.report.world_from_camera});
  return trajectory;
}

std::string frames_csv(const OdometryRun& run) {
  std::string text =
      "frame,stamp_s,image,status,segment,keyframe,registration,pairs,iterations,overlap,rmse,strain,time_ms,problem\n";
  for (const FrameRow& row : run.rows) {
    const FrameReport& report = row.report;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{:.4g},{:.3f},{}\n", row.frame, report.stamp_s,
                        in_csv(row.image.filename().string()), name_of(report.status), report.segment,
                        report.is_keyframe ? 1 : 0, report.registration ? name_of(*report.registration) : "",
                        report.num_pairs, report.iterations, report.overlap, report.rmse, report.strain, row.time_ms,
                        in_csv(report.problem));
  }
  return text;
}

nlohmann::ordered_json metrics_json(const OdometryRun& run) {
  nlohmann::ordered_json json{{"sequence", run.sequence},
                              {"layout", run.layout},
                              {"num_frames", run.rows.size()},
                              {"num_poses", trajectory_of(run).size()}};
  if (!run.point_times.empty()) json["point_times"] = run.point_times;
  for (const auto& [status, word] : kWords<FrameStatus>) json["num_" + std::string(word)] = num_with(run, status);
  json["timing_ms"] = {{"total", run.total_ms}, {"median_frame", median_time_ms(run)}};
  json["frames_per_s"] = frames_per_s(run);
  if (run.evaluation) json["evaluation"] = evaluation_json(*run.evaluation);
  if (!run.evaluation_problem.empty()) json["evaluation_problem"] = run.evaluation_problem;
  json["version"] = AUGICP_VERSION;
  return json;
}

std::string summary_text(const OdometryRun& run) {
  std::string text = fmt::format("sequence   {} ({}, {} frames)\n", run.sequence, run.layout, run.rows.size());
  if (!run.point_times.empty()) text += fmt::format("times      {}\n", run.point_times);
  text += fmt::format("frames     {}\n", counts_text(run));
  text += fmt::format("time       {:.1f} s, {:.1f} frames/s, median {:.1f} ms a frame\n", run.total_ms / 1000.0,
                      frames_per_s(run), median_time_ms(run));
  const auto with_problem =
      std::find_if(run.rows.begin(), run.rows.end(), [](const FrameRow& row) { return !row.report.problem.empty(); });
  if (with_problem != run.rows.end()) text += fmt::format("problem    {}\n", with_problem->report.problem);
  if (!mostly_tracked(run)) text += "warning    less than half of the frames could be tracked\n";
  if (num_segments(run) > 1)
    text += fmt::format(
        "warning    the camera was lost: the trajectory has {} segments with no measured motion between them\n",
        num_segments(run));
  if (run.evaluation) text += evaluation_text(*run.evaluation);
  if (!run.evaluation_problem.empty()) text += fmt::format("truth      not compared: {}\n", run.evaluation_problem);
  return text;
}

}  // namespace augicp::app
