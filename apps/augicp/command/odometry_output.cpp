// SPDX-License-Identifier: MIT
#include "apps/augicp/command/odometry_output.h"

#include <algorithm>

#include "augicp/core/error.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

std::string folder_for(const std::string& sequence) {
  const fs::path path = fs::path(sequence).lexically_normal();
  const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
  return (name.empty() || name == "." || name == ".." ? "sequence" : name.string()) + "_odometry";
}

}  // namespace

fs::path made_output_folder(const std::string& output, const std::string& sequence) {
  const fs::path folder = output.empty() ? folder_for(sequence) : output;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder.string() + ": cannot be made: " + error.message());
  for (const char* name : {"trajectory.txt", "poses_kitti.txt", "frames.csv", "covariances.csv", "metrics.json"})
    fs::remove(folder / name, error);
  return folder;
}

void require_readable(const OdometryRun& run, const std::string& what) {
  const auto is_unreadable = [](const FrameRow& row) { return row.report.status == FrameStatus::Unreadable; };
  if (std::all_of(run.rows.begin(), run.rows.end(), is_unreadable))
    throw IoError("no " + what + " can be used; the first: " + run.rows.front().report.problem);
}

ExitCode exit_code_for(const OdometryRun& run) {
  const Trajectory trajectory = trajectory_of(run);
  if (trajectory.empty() || (trajectory.size() == 1 && run.rows.size() > 1)) return kRegistrationFailed;
  return num_segments(run) > 1 || !mostly_tracked(run) ? kDoubtful : kSuccess;
}

}  // namespace augicp::app
