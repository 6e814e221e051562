// SPDX-License-Identifier: MIT
// The result of `augicp odometry`, as files and as text.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "augicp/eval/evaluate.h"
#include "augicp/odometry/odometry.h"

namespace augicp::app {

struct FrameRow {
  std::size_t frame = 0;  // in the sequence, from 0
  std::filesystem::path image;
  FrameReport report;
  double time_ms = 0.0;  // from the end of the frame before to the end of this one
};

// The voxels of a LiDAR's map.
struct MapVoxels {
  double size_m = 0.0;
  bool are_derived = true;  // from the first scan with points; else given
};

struct OdometryRun {
  std::string sequence, layout;
  std::vector<FrameRow> rows;
  double total_ms = 0.0;
  std::optional<Evaluation> evaluation;
  std::string evaluation_problem;            // why there is no evaluation although a truth was given
  std::string point_times = {};              // of a LiDAR: how the times of its points are known; else empty
  std::string ended_early = {};              // why frames at the end were left out; else empty
  std::string advice = {};                   // why it may have failed from the start
  std::string map_files = {};                // that were written, for people
  std::optional<MapVoxels> map_voxels = {};  // of a LiDAR, once a scan had points
  std::vector<std::string> warnings = {};    // on the input: what was left out, stamps in other units
  int interrupted_code = 0;                  // the exit code of a signal that ended it; else 0
};

// The frames that have a pose.
Trajectory trajectory_of(const OdometryRun& run);

int num_segments(const OdometryRun& run);

// Whether at least half of the frames are tracked, or start a segment.
bool mostly_tracked(const OdometryRun& run);

std::string frames_csv(const OdometryRun& run);
nlohmann::ordered_json metrics_json(const OdometryRun& run);
// "0.512 m, derived from the first scan"
std::string voxels_text(const MapVoxels& voxels);

std::string summary_text(const OdometryRun& run);

}  // namespace augicp::app
