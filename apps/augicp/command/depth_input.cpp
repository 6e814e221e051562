// SPDX-License-Identifier: MIT
#include "apps/augicp/command/depth_input.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "augicp/core/error.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/camera_file.h"
#include "augicp/io/depth_file.h"
#include "augicp/io/grey_png.h"
#include "augicp/io/ros_image.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

struct SeenImage {
  DepthImage image;
  DepthCamera camera;
  double depth_scale = 0.0;
  std::string format;
};

GreyImage read_grey_input(const fs::path& path, const DepthImage& depth) {
  GreyImage grey = read_grey_png(path);
  if (grey.width != depth.width || grey.height != depth.height)
    throw IoError(fmt::format("{}: expected {} x {} pixels as in the depth image, found {} x {}", path.string(),
                              depth.width, depth.height, grey.width, grey.height));
  return grey;
}

// The library's own message names no file.
void check_fits(const fs::path& path, const DepthImage& image, const DepthCamera& camera) {
  try {
    check_size(image, camera.pinhole);
  } catch (const std::invalid_argument& error) {
    throw IoError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

Input input_of(const fs::path& path, const SeenImage& seen, const fs::path& grey_path) {
  const auto& [image, camera, depth_scale, format] = seen;
  check_depth_scale(image, path, depth_scale);
  warn_of_depth_scale(image, path, depth_scale);
  check_fits(path, image, camera);
  Input input{grey_path.empty() ? scan_of(image, camera) : scan_of(image, read_grey_input(grey_path, image), camera),
              {}};
  input.report.format = fmt::format("{} depth {} x {}", format, image.width, image.height);
  input.report.num_declared = image.depth.size();
  input.report.num_not_finite = image.depth.size() - input.scan.cloud.size();
  return input;
}

[[noreturn]] void ask_for_camera(const fs::path& path) {
  throw std::invalid_argument(
      fmt::format("{}: a depth image needs --camera: a file, numbers \"fx fy cx cy\" or one of {}", path.string(),
                  fmt::join(camera_names(), " ")));
}

std::string topic_of(const BagMessageName& name, const InputOptions& options) {
  if (!name.topic.empty()) return name.topic;
  if (!options.topic.empty()) return options.topic;
  const std::string types[] = {kPointCloud2, kImage, kCompressedImage};
  return chosen_topic(name.bag, {}, types).name;
}

DepthCamera camera_of_message(const BagMessageName& name, const std::string& topic, const InputOptions& options) {
  if (!options.camera.empty()) return read_camera(options.camera);
  const auto camera = camera_of_topic(name.bag, topic);
  if (!camera) ask_for_camera(name.text());
  return *camera;
}

Input cloud_input_of(const fs::path& source, const BagMessage& message, const InputOptions& options) {
  if (!options.camera.empty())
    throw std::invalid_argument(
        fmt::format("--camera {}: goes with a depth image, and {} is a cloud", options.camera, source.string()));
  CloudFile file = parse_cloud_message(source, message, options.read);
  return {scan_of(std::move(file.cloud)), std::move(file.report), std::move(file.fields), std::move(file.grid), {}};
}

}  // namespace

bool is_depth_image(const fs::path& path, const InputOptions& options) {
  return is_image_file(path) || (lower_case_extension(path) == ".npy" && !options.camera.empty());
}

Input read_depth_input(const fs::path& path, const InputOptions& options, const fs::path& grey_path) {
  if (options.camera.empty()) ask_for_camera(path);
  constexpr double kTumDepthScale = 5000.0;
  const double depth_scale =
      options.depth_scale.value_or(depth_scale_of_camera(options.camera).value_or(kTumDepthScale));
  return input_of(path,
                  {read_depth_image(path, depth_scale), read_camera(options.camera), depth_scale,
                   lower_case_extension(path).substr(1)},
                  grey_path);
}

Input read_message_input(const BagMessageName& name, const InputOptions& options, const fs::path& grey_path) {
  constexpr double kPerMetre = 1000.0;  // ROS has millimetres (REP 118)
  const std::string topic = topic_of(name, options);
  const fs::path source = BagMessageName{name.bag, topic, name.number}.text();
  TopicReader reader(name.bag, topic);
  const BagMessage message = reader.message(name.number);
  const bool is_image = message.type == kImage || message.type == kCompressedImage;
  if (!is_image && !grey_path.empty())
    throw std::invalid_argument(
        fmt::format("{}: an image goes with a depth image, not with a cloud", grey_path.string()));
  if (!is_image) return cloud_input_of(source, message, options);
  const double depth_scale = options.depth_scale.value_or(kPerMetre);
  return input_of(source,
                  {parse_depth_message(source, message.type, message.data, message.form, depth_scale),
                   camera_of_message(name, topic, options), depth_scale, std::string(message.type)},
                  grey_path);
}

}  // namespace augicp::app
