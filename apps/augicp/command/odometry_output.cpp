// SPDX-License-Identifier: MIT
#include "apps/augicp/command/odometry_output.h"

#include <algorithm>
#include <exception>

#include "augicp/core/error.h"
#include "augicp/io/bag.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

std::string folder_for(const std::string& sequence) {
  const fs::path path = fs::path(sequence).lexically_normal();
  const fs::path last = path.has_filename() ? path.filename() : path.parent_path().filename();
  const fs::path name = is_bag(path) ? last.stem() : last;
  return (name.empty() || name == "." || name == ".." ? "sequence" : name.string()) + "_odometry";
}

}  // namespace

fs::path output_folder(const std::string& output, const std::string& sequence) {
  return output.empty() ? folder_for(sequence) : output;
}

OutputFolder::OutputFolder(const std::string& output, const std::string& sequence)
    : path_(output_folder(output, sequence)), num_exceptions_(std::uncaught_exceptions()) {
  std::error_code error;
  is_new_ = !fs::exists(path_, error);
  fs::create_directories(path_, error);
  if (error) throw IoError(path_.string() + ": cannot be made: " + error.message());
  for (const char* name : {"trajectory.txt", "poses_kitti.txt", "frames.csv", "covariances.csv", "metrics.json"})
    fs::remove(path_ / name, error);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (is_new_ && std::uncaught_exceptions() > num_exceptions_) fs::remove_all(path_, ignored);
}

void require_readable(const OdometryRun& run, const std::string& what) {
  const auto is_unreadable = [](const FrameRow& row) { return row.report.status == FrameStatus::Unreadable; };
  if (std::all_of(run.rows.begin(), run.rows.end(), is_unreadable))
    throw IoError("no " + what + " can be used; the first: " + run.rows.front().report.problem);
}

int exit_code_for(const OdometryRun& run) {
  if (run.interrupted_code != 0) return run.interrupted_code;
  const Trajectory trajectory = trajectory_of(run);
  if (trajectory.empty() || (trajectory.size() == 1 && run.rows.size() > 1)) return kRegistrationFailed;
  return num_segments(run) > 1 || !mostly_tracked(run) || !run.ended_early.empty() ? kDoubtful : kSuccess;
}

}  // namespace augicp::app
