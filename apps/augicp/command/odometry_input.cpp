// SPDX-License-Identifier: MIT
#include "apps/augicp/command/odometry_input.h"

#include <fmt/core.h>

#include "augicp/core/error.h"
#include "augicp/io/bag.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

bool holds_depth_images(const std::string& folder) {
  try {
    read_depth_sequence(folder, 1.0);
    return true;
  } catch (const IoError&) {
    return false;
  }
}

// The scans of a folder whose depth images are tracked because both are there.
std::string scans_beside(const OdometryArguments& arguments) {
  if (arguments.sensor != Sensor::Auto) return {};
  const std::vector<fs::path> scans = find_scans(arguments.sequence);
  if (scans.empty()) return {};
  return fmt::format("{}: its depth images are tracked, and its {} {} scans left out: --sensor lidar tracks these",
                     arguments.sequence, scans.size(), scans.front().extension().string());
}

}  // namespace

std::optional<StampedTopic> topic_of(const OdometryArguments& arguments) {
  if (!is_bag(arguments.sequence)) return std::nullopt;
  std::vector<std::string> types;
  if (arguments.sensor != Sensor::Depth) types.emplace_back(kPointCloud2);
  if (arguments.sensor != Sensor::Lidar) types.insert(types.end(), {kImage, kCompressedImage});
  return chosen_topic(arguments.sequence, arguments.topic, types);
}

bool is_lidar(const OdometryArguments& arguments, const std::optional<StampedTopic>& topic) {
  if (topic) return topic->type == kPointCloud2;
  if (arguments.sensor != Sensor::Auto) return arguments.sensor == Sensor::Lidar;
  if (!arguments.camera.empty()) return false;  // the folder may be damaged
  std::error_code not_a_folder;
  if (!fs::is_directory(arguments.sequence, not_a_folder)) return false;
  return !find_scans(arguments.sequence).empty() && !holds_depth_images(arguments.sequence);
}

ScanSequence scans_of(const OdometryArguments& arguments, const std::optional<StampedTopic>& topic) {
  return topic ? scans_of_topic(arguments.sequence, topic->name, topic->stamps_s)
               : read_scan_sequence(arguments.sequence, arguments.frames_per_s.value_or(kUsualScansPerS));
}

DepthSequence images_of(const OdometryArguments& arguments, const std::optional<StampedTopic>& topic) {
  if (topic) return depth_of_topic(arguments.sequence, *topic);
  DepthSequence sequence = read_depth_sequence(arguments.sequence, arguments.frames_per_s.value_or(kUsualFramesPerS));
  if (const std::string scans = scans_beside(arguments); !scans.empty()) sequence.warnings.push_back(scans);
  return sequence;
}

void print_warnings(const std::vector<std::string>& warnings, bool is_quiet) {
  if (is_quiet) return;
  for (const std::string& warning : warnings) fmt::print(stderr, "augicp: warning: {}\n", warning);
}

}  // namespace augicp::app
