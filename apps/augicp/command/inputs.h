// SPDX-License-Identifier: MIT
// Reads the clouds that the arguments of a subcommand name.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "augicp/io/cloud_file.h"
#include "augicp/io/depth_sequence.h"
#include "augicp/sensor/scan.h"

namespace augicp::app {

struct InputOptions {
  std::string camera;                 // name, file or "fx fy cx cy"; for depth images
  std::optional<double> depth_scale;  // pixel value at one metre; empty: that of the named camera, or 5000
  std::string topic;                  // of recordings; empty: the only one
  ReadOptions read;
};

void add_input_options(CLI::App& command, InputOptions& options);

// A file that was read: the fields of CloudFile, with a scan in place of the cloud. Depth images have no grid: their
// pixels are in the scan's view.
struct Input {
  Scan scan;
  ReadReport report;
  PointFields fields{};
  std::optional<IndexImage> grid{};
  std::optional<LasRecords> las{};
};

// A depth image (.png, .pgm, or with a camera .npy), a cloud, or a message of a recording ("drive.mcap#12"). grey_path:
// an image registered to the depth image, or empty. Throws IoError, also if the sizes of the two images differ, and
// std::invalid_argument for a depth image without a camera or a cloud with an image.
Input read_input(const std::filesystem::path& path, const InputOptions& options,
                 const std::filesystem::path& grey_path = {});

// Throws IoError if a sequence is a file and no recording: two files are registered by `align`. Throws
// std::invalid_argument for a topic (may be empty) of what is no recording.
void require_sequence(const std::filesystem::path& sequence, const std::string& topic);

// Throws std::invalid_argument if there is a camera, and none of the inputs is a depth image, or a topic, and none is
// of a recording. Files are not opened.
void require_use_of(const InputOptions& options, const std::vector<std::filesystem::path>& inputs);

// Warns on stderr if one of the clouds is about a thousand times as large as the other, as millimetres among metres
// are.
void warn_of_units(const Cloud& source, const Cloud& target);

// Writes a cloud with the fields of its input to .ply, .pcd or .las, see write_cloud(). Parts of the input that the
// output lacks become a warning on stderr each, unless it is to be quiet. Throws IoError.
void write_cloud_output(const std::string& path, const CloudFile& file, bool quiet);

// Says on stderr if another depth scale is likely, see depth_scale_suspicion().
void warn_of_depth_scale(const DepthImage& image, const std::filesystem::path& path, double depth_scale);

// The given camera, see read_camera, or else the sequence's own. Throws std::invalid_argument if there is none, and
// IoError if its file is damaged; folder is for the message.
DepthCamera sequence_camera(const DepthSequence& sequence, const std::string& folder, const std::string& asked_for);

// Throws std::invalid_argument unless the output is empty (not requested) or ends in one of these. Called before any
// work.
void require_extension(const std::string& output, const std::vector<std::string>& extensions,
                       const std::string& option = "--output");

// Throws std::invalid_argument if writing one of the outputs would replace a file that is read, under any of its names.
// Empty names, "-" and devices are no files; of a cloud of a recording, drive.mcap#12, the recording is meant. Called
// before any work.
void require_no_input_among(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

}  // namespace augicp::app
