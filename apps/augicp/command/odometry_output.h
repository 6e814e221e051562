// SPDX-License-Identifier: MIT
// What `augicp odometry` does with its result, for depth cameras and LiDARs.
#pragma once

#include <filesystem>
#include <string>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/text/odometry.h"
#include "augicp/registration/memory.h"

namespace augicp::app {

// The options that change the memory of an odometry.
inline constexpr MemoryOptionNames kMemoryOptions{"--map-voxel", "--radius", "--max-memory", "--pixel-step"};

// The folder of the results: `output`, or the name of the sequence and "_odometry" if that is empty.
std::filesystem::path output_folder(const std::string& output, const std::string& sequence);

// This folder. It is made if missing, and results of another run are removed from it. If an exception ends its scope, a
// folder that was made is removed again.
class OutputFolder {
 public:
  // Throws IoError.
  OutputFolder(const std::string& output, const std::string& sequence);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool is_new_;
  int num_exceptions_;
};

// Throws IoError if every frame is unreadable: then the frames are not the reason. what: the word for a frame.
void require_readable(const OdometryRun& run, const std::string& what);

int exit_code_for(const OdometryRun& run);

}  // namespace augicp::app
