// SPDX-License-Identifier: MIT
#include "apps/augicp/command/inputs.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "apps/augicp/command/depth_input.h"
#include "apps/augicp/command/folder_advice.h"
#include "apps/augicp/command/interruption.h"
#include "augicp/core/error.h"
#include "augicp/io/bag.h"
#include "augicp/io/bag_message_name.h"
#include "augicp/io/camera_file.h"
#include "augicp/io/depth_png.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/unit_warning.h"
#include "augicp/io/write_cloud.h"

namespace augicp::app {
namespace {

[[noreturn]] void refuse_topic(const std::string& topic, const std::filesystem::path& path) {
  throw std::invalid_argument(fmt::format("--topic {}: goes with a recording, and {} is none", topic, path.string()));
}

[[noreturn]] void refuse_recording(const std::filesystem::path& path) {
  const BagReader exists(path);
  throw IoError(
      fmt::format("{0}: is a recording, expected one cloud or depth image; its first is {1}, and 'augicp info {0}' "
                  "lists its topics for --topic; it is tracked by: augicp odometry {0}",
                  path.string(), BagMessageName{path, {}, 0}.text()));
}

Input input_of(const std::filesystem::path& path, const InputOptions& options, const std::filesystem::path& grey_path) {
  if (const auto message = parse_bag_message_name(path)) return read_message_input(*message, options, grey_path);
  if (is_bag(path)) refuse_recording(path);
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) throw IoError(folder_advice(path));
  if (is_depth_image(path, options)) return read_depth_input(path, options, grey_path);
  if (!grey_path.empty())
    throw std::invalid_argument(
        fmt::format("{}: an image goes with a depth image, not with a cloud", grey_path.string()));
  CloudFile file = read_cloud(path, options.read);
  return {scan_of(std::move(file.cloud)), std::move(file.report), std::move(file.fields), std::move(file.grid),
          std::move(file.las)};
}

}  // namespace

void add_input_options(CLI::App& command, InputOptions& options) {
  const std::string group = "Input";
  command
      .add_option("--camera", options.camera,
                  fmt::format("For depth images: a file, \"fx fy cx cy\" in pixels, or one of {}",
                              fmt::join(camera_names(), " ")))
      ->group(group);
  command.add_option("--depth-scale", options.depth_scale, "Pixel value of one metre: TUM 5000, most others 1000")
      ->default_str("that of the named camera, or 5000")
      ->group(group);
  command
      .add_option("--bin-columns", options.read.num_bin_columns,
                  "Numbers a point in .bin files: 3, 4 (KITTI), 5 (nuScenes) or 6; 0: found")
      ->capture_default_str()
      ->group(group);
  command
      .add_flag(
          "--sample-faces", options.read.sample_faces,
          "Take .ply files with faces as meshes: points on the faces, with exact normals (.stl, .obj, .glb always are)")
      ->group(group);
  command
      .add_option("--topic", options.topic,
                  "For recordings, as drive.mcap#12 (message 12, from 0): the topic (default: the only one)")
      ->group(group);
  command.add_option("--max-points", options.read.max_points, "Refuse clouds with more points")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->group(group);
}

void require_sequence(const std::filesystem::path& sequence, const std::string& topic) {
  if (is_bag(sequence)) return;
  if (!topic.empty()) refuse_topic(topic, sequence);
  std::error_code ignored;
  if (!std::filesystem::exists(sequence, ignored)) throw IoError(sequence.string() + ": no such folder or recording");
  if (std::filesystem::is_directory(sequence, ignored)) require_frames(sequence);
  if (!std::filesystem::is_regular_file(sequence, ignored)) return;
  const std::string text = sequence.string() + ": is a file, expected a folder or a recording; ";
  if (sequence.filename() == "depth.txt")
    throw IoError(text + "its folder is tracked by: augicp odometry " +
                  (sequence.has_parent_path() ? sequence.parent_path().string() : "."));
  throw IoError(text + "two files are registered by: augicp align SOURCE TARGET");
}

void warn_of_depth_scale(const DepthImage& image, const std::filesystem::path& path, double depth_scale) {
  if (const auto suspicion = depth_scale_suspicion(image, depth_scale))
    fmt::print(stderr, "augicp: warning: {}: {}; see --depth-scale\n", path.string(), *suspicion);
}

Input read_input(const std::filesystem::path& path, const InputOptions& options,
                 const std::filesystem::path& grey_path) {
  Input input = input_of(path, options, grey_path);
  for (const std::string& warning : input.report.warnings)
    fmt::print(stderr, "augicp: warning: {}: {}\n", path.string(), warning);
  return input;
}

void require_use_of(const InputOptions& options, const std::vector<std::filesystem::path>& inputs) {
  const auto any = [&](const auto& test) { return std::any_of(inputs.begin(), inputs.end(), test); };
  const bool has_message =
      any([](const std::filesystem::path& path) { return is_bag(path) || parse_bag_message_name(path); });
  if (!options.topic.empty() && !has_message) refuse_topic(options.topic, inputs.front());
  const bool has_image = any([&](const std::filesystem::path& path) { return is_depth_image(path, options); });
  if (!options.camera.empty() && !has_image && !has_message)
    throw std::invalid_argument(
        fmt::format("--camera {}: goes with a depth image (.png, .pgm, .pfm, .tif, .npy), and {} is none",
                    options.camera, inputs.front().string()));
}

void warn_of_units(const Cloud& source, const Cloud& target) {
  const std::string doubt = unit_warning(source, target);
  if (!doubt.empty()) fmt::print(stderr, "augicp: warning: {}\n", doubt);
}

void write_cloud_output(const std::string& path, const CloudFile& file, bool quiet) {
  std::vector<std::string> not_kept;
  write_whole([&] { not_kept = write_cloud(path, file); });
  for (const std::string& what : not_kept)
    if (!quiet) fmt::print(stderr, "augicp: warning: {}: not kept: {}\n", path, what);
}

DepthCamera sequence_camera(const DepthSequence& sequence, const std::string& folder, const std::string& asked_for) {
  if (asked_for.empty() && !sequence.camera_problem.empty()) throw IoError(sequence.camera_problem);
  if (asked_for.empty() && !sequence.camera)
    throw std::invalid_argument(
        fmt::format("{}: which camera? Give --camera: a file, numbers \"fx fy cx cy\" or one of {}", folder,
                    fmt::join(camera_names(), " ")));
  return asked_for.empty() ? *sequence.camera : read_camera(asked_for);
}

void require_extension(const std::string& output, const std::vector<std::string>& extensions,
                       const std::string& option) {
  const bool known = std::find(extensions.begin(), extensions.end(), lower_case_extension(output)) != extensions.end();
  if (output.empty() || known) return;
  throw std::invalid_argument(fmt::format("{} {}: must end in {}", option, output, fmt::join(extensions, " or ")));
}

void require_no_input_among(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    const auto message = parse_bag_message_name(input);
    const std::filesystem::path file = message ? message->bag : std::filesystem::path(input);
    for (const std::string& output : outputs) {
      std::error_code is_missing;  // then there is nothing to replace, nor in a device
      if (std::filesystem::is_regular_file(output, is_missing) && std::filesystem::equivalent(output, file, is_missing))
        throw std::invalid_argument(fmt::format("{}: is an input, and would be replaced", output));
    }
  }
}

}  // namespace augicp::app
