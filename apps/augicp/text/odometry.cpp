// SPDX-License-Identifier: MIT
#include "apps/augicp/text/odometry.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/augicp/text/evaluation.h"
#include "augicp/core/median.h"

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

std::string drift_in_csv(const FrameReport& report) {
  if (!report.drift) return ",,";
  return fmt::format("{:.4g},{:.4g},{:.4g}", report.drift->drift_m, report.drift->drift_deg, report.drift->expected_m);
}

// What the scans that were checked against a keyframe farther back have drifted by; empty if none was.
struct SelfCheckSummary {
  std::size_t num_checked = 0, num_contradicted = 0;
  double median_drift_m = 0.0, max_drift_m = 0.0, max_drift_deg = 0.0;
};

SelfCheckSummary self_check_of(const OdometryRun& run) {
  SelfCheckSummary summary;
  std::vector<double> drifts;
  for (const FrameRow& row : run.rows) {
    if (!row.report.drift) continue;
    drifts.push_back(row.report.drift->drift_m);
    summary.num_contradicted += row.report.drift->contradicts;
    summary.max_drift_deg = std::max(summary.max_drift_deg, row.report.drift->drift_deg);
  }
  summary.num_checked = drifts.size();
  if (drifts.empty()) return summary;
  summary.max_drift_m = *std::max_element(drifts.begin(), drifts.end());
  summary.median_drift_m = upper_median(drifts);
  return summary;
}

nlohmann::ordered_json self_check_json(const SelfCheckSummary& summary) {
  return {{"num_checked", summary.num_checked},
          {"num_contradicted", summary.num_contradicted},
          {"median_drift_m", summary.median_drift_m},
          {"max_drift_m", summary.max_drift_m},
          {"max_drift_deg", summary.max_drift_deg}};
}

std::string self_check_text(const SelfCheckSummary& summary) {
  return fmt::format(
      "drift      {} scan{} against keyframes farther back: {:.1f} cm (median), {:.1f} cm and {:.2f} "
      "degrees (largest), {} contradicted\n",
      summary.num_checked, summary.num_checked == 1 ? "" : "s", 100.0 * summary.median_drift_m,
      100.0 * summary.max_drift_m, summary.max_drift_deg, summary.num_contradicted);
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
      "frame,stamp_s,image,status,segment,keyframe,registration,pairs,iterations,overlap,rmse,strain,drift_m,drift_deg,"
      "drift_expected_m,time_ms,problem\n";
  for (const FrameRow& row : run.rows) {
    const FrameReport& report = row.report;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{:.4g},{},{:.3f},{}\n", row.frame, report.stamp_s,
                        in_csv(row.image.filename().string()), name_of(report.status), report.segment,
                        report.is_keyframe ? 1 : 0, report.registration ? name_of(*report.registration) : "",
                        report.num_pairs, report.iterations, report.overlap, report.rmse, report.strain,
                        drift_in_csv(report), row.time_ms, in_csv(report.problem));
  }
  return text;
}

std::string voxels_text(const MapVoxels& voxels) {
  return fmt::format("{:.4g} m, {}", voxels.size_m, voxels.are_derived ? "derived from the first scan" : "given");
}

nlohmann::ordered_json metrics_json(const OdometryRun& run) {
  nlohmann::ordered_json json{{"sequence", run.sequence},
                              {"layout", run.layout},
                              {"num_frames", run.rows.size()},
                              {"num_poses", trajectory_of(run).size()}};
  if (!run.point_times.empty()) json["point_times"] = run.point_times;
  if (run.map_voxels)
    json["map_voxel"] = {{"size_m", run.map_voxels->size_m}, {"derived", run.map_voxels->are_derived}};
  for (const auto& [status, word] : kWords<FrameStatus>) json["num_" + std::string(word)] = num_with(run, status);
  if (const SelfCheckSummary check = self_check_of(run); check.num_checked > 0)
    json["self_check"] = self_check_json(check);
  json["timing_ms"] = {{"total", run.total_ms}, {"median_frame", median_time_ms(run)}};
  json["frames_per_s"] = frames_per_s(run);
  if (run.evaluation) json["evaluation"] = evaluation_json(*run.evaluation);
  if (!run.ended_early.empty()) json["ended_early"] = run.ended_early;
  if (!run.evaluation_problem.empty()) json["evaluation_problem"] = run.evaluation_problem;
  if (!run.warnings.empty()) json["warnings"] = run.warnings;
  json["version"] = AUGICP_VERSION;
  return json;
}

std::string summary_text(const OdometryRun& run) {
  std::string text = fmt::format("sequence   {} ({}, {} frames)\n", run.sequence, run.layout, run.rows.size());
  if (!run.point_times.empty()) text += fmt::format("times      {}\n", run.point_times);
  if (run.map_voxels) text += fmt::format("voxels     {}\n", voxels_text(*run.map_voxels));
  text += fmt::format("frames     {}\n", counts_text(run));
  if (const SelfCheckSummary check = self_check_of(run); check.num_checked > 0) text += self_check_text(check);
  text += fmt::format("time       {:.1f} s, {:.1f} frames/s, median {:.1f} ms a frame\n", run.total_ms / 1000.0,
                      frames_per_s(run), median_time_ms(run));
  const auto with_problem =
      std::find_if(run.rows.begin(), run.rows.end(), [](const FrameRow& row) { return !row.report.problem.empty(); });
  if (with_problem != run.rows.end()) text += fmt::format("problem    {}\n", with_problem->report.problem);
  if (!mostly_tracked(run)) text += "warning    less than half of the frames could be tracked\n";
  if (num_segments(run) > 1)
    text += fmt::format(
        "warning    the sensor was lost: the trajectory has {} segments with no measured motion between them\n",
        num_segments(run));
  if (!run.advice.empty()) text += fmt::format("warning    {}\n", run.advice);
  if (run.evaluation) {
    text += evaluation_text(*run.evaluation);
    for (const std::string& warning : coverage_warnings(run.evaluation->coverage))
      text += fmt::format("warning    {}\n", warning);
  }
  if (!run.evaluation_problem.empty()) text += fmt::format("truth      not compared: {}\n", run.evaluation_problem);
  return text;
}

}  // namespace augicp::app
