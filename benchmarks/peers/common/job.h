// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "augicp/geometry/rigid3.h"
#include "augicp/sensor/depth_camera.h"

namespace augicp::peers {

// One registration to run.
struct Job {
  std::string pair;  // the name under which its result is found again
  std::filesystem::path source;
  std::filesystem::path target;

  std::string scene;  // by its name each peer finds its settings

  std::optional<DepthCamera> camera;  // of two depth images; nothing: both files are clouds
  double depth_scale = 0.0;           // pixel value of one metre, with a camera only

  // target_from_source. Nothing: what the same method found for the job before, the guess of constant velocity in a
  // sequence; the identity for the first job and after one without a result.
  std::optional<Rigid3> guess;
};

// The jobs of a file with a line for each, after the header
//   pair,source,target,scene,camera,depth_scale,guess
// camera is a name or numbers (see read_camera), or "-" for clouds; guess is "tx ty tz qx qy qz qw" or "previous".
// Throws IoError.
std::vector<Job> read_jobs(const std::filesystem::path& path);

}  // namespace augicp::peers
