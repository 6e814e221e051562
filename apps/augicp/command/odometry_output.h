// SPDX-License-Identifier: MIT
// What `augicp odometry` does with its result, for depth cameras and LiDARs.
#pragma once

#include <filesystem>
#include <string>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/text/odometry.h"

namespace augicp::app {

// The folder of the results: `output`, or the name of the sequence and "_odometry" if that is empty. It is made if
// missing, and results of another run are removed from it. Throws IoError.
std::filesystem::path made_output_folder(const std::string& output, const std::string& sequence);

// Throws IoError if every frame is unreadable: then the frames are not the reason. what: the word for a frame.
void require_readable(const OdometryRun& run, const std::string& what);

ExitCode exit_code_for(const OdometryRun& run);

}  // namespace augicp::app
