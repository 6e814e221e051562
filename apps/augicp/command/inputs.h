// SPDX-License-Identifier: MIT
// From the arguments of a subcommand to clouds.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "augicp/io/cloud_file.h"
#include "augicp/io/depth_sequence.h"
#include "augicp/sensor/scan.h"

namespace augicp::app {

struct InputOptions {
  std::string camera;           // name, file or "fx fy cx cy"; for depth images
  double depth_scale = 5000.0;  // value of a pixel at one metre
  ReadOptions read;
};

void add_input_options(CLI::App& command, InputOptions& options);

struct Input {
  Scan scan;
  ReadReport report;
};

// A depth image (.png) or a cloud. grey_path: of an image registered to the depth image, or empty. Throws IoError, also
// where the two images differ in size, and std::invalid_argument for a depth image without a camera or a cloud with an
// image.
Input read_input(const std::filesystem::path& path, const InputOptions& options,
                 const std::filesystem::path& grey_path = {});

// The camera asked for, see read_camera, or where none is the sequence's own. Throws std::invalid_argument where that
// has none and IoError where its file is damaged; folder is for the message.
DepthCamera sequence_camera(const DepthSequence& sequence, const std::string& folder, const std::string& asked_for);

// Throws std::invalid_argument unless the output is empty (not asked for) or ends in one of these, before any work is
// done.
void require_extension(const std::string& output, const std::vector<std::string>& extensions);

}  // namespace augicp::app
