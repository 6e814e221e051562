// SPDX-License-Identifier: MIT
#include "apps/augicp/page/kept.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "apps/augicp/page/packing.h"
#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/thinning.h"
#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/error.h"

namespace augicp::app {
namespace {

// An image of 160 x 120 and a model of 4000 points take 111 kB of a file, and so do 150 frames with their poses and
// curves. A page keeps fewer images of a long run, so that it stays below 15 MB for up to 19 000 frames.
constexpr std::size_t kMaxKept = 100;
constexpr std::size_t kFramesPerKept = 150;
constexpr std::size_t kBudget = 128;  // kept frames' bytes in all
constexpr std::size_t kMaxModelPoints = 4000;
constexpr int kMaxColumns = 160;

struct SmallImage {
  int width = 0, height = 0;
  std::vector<float> depth;
};

std::optional<SmallImage> read_small(const DepthFrameFile& frame, double depth_scale) try {
  const DepthImage image = read_depth_frame(frame, depth_scale);
  // By the longer side, so that odd shapes stay small too.
  const int step = std::max(1, (std::max(image.width, image.height) + kMaxColumns - 1) / kMaxColumns);
  SmallImage small{(image.width + step - 1) / step, (image.height + step - 1) / step, {}};
  for (int v = 0; v < image.height; v += step)
    for (int u = 0; u < image.width; u += step) small.depth.push_back(image.at(u, v));
  return small;
} catch (const IoError&) {
  return std::nullopt;  // the frame's status has the reason
}

// A depth above nearly all readings; 0 if there are none.
float far_depth(const SmallImage& image) {
  std::vector<float> readings;
  for (const float depth : image.depth)
    if (std::isfinite(depth)) readings.push_back(depth);
  if (readings.empty()) return 0.0f;
  const auto place = readings.begin() + static_cast<std::ptrdiff_t>(readings.size() * 49 / 50);
  std::nth_element(readings.begin(), place, readings.end());
  return *place;
}

std::string packed_depth(const SmallImage& image, float far) {
  std::vector<std::uint8_t> values;
  for (const float depth : image.depth)
    values.push_back(
        std::isfinite(depth) ? static_cast<std::uint8_t>(1.5f + 253.0f * std::clamp(depth / far, 0.0f, 1.0f)) : 0);
  return packed_bytes(values);
}

nlohmann::ordered_json frame_json(const OdometryPicture& picture, std::size_t row, float& far) {
  const FrameRow& frame = picture.run.rows[row];
  nlohmann::ordered_json json{{"frame", row}, {"width", 0}, {"height", 0}, {"text", ""}};
  if (picture.is_lidar()) return json;
  const std::optional<SmallImage> image = read_small(picture.sequence->frames[frame.frame], picture.depth_scale);
  if (image && far == 0.0f) far = far_depth(*image);
  if (!image || far == 0.0f) {
    json["text"] = fmt::format("Frame {}: no depth image", frame.frame);
    return json;
  }
  json["width"] = image->width;
  json["height"] = image->height;
  json["depth"] = packed_depth(*image, far);
  json["text"] = fmt::format("Frame {}, depth 0 to {:.1f} m", frame.frame, far);
  return json;
}

// A sensor's cloud has no origin but zero.
nlohmann::ordered_json model_json(const Cloud& cloud) {
  if (!cloud.has_directions()) return {{"points", packed_points(cloud.points)}};
  std::vector<std::uint8_t> structures;
  for (const Structure structure : cloud.structures) structures.push_back(static_cast<std::uint8_t>(structure));
  return {{"points", packed_points(cloud.points)},
          {"directions", packed_directions(cloud.directions)},
          {"structures", packed_bytes(structures)}};
}

}  // namespace

std::vector<std::uint32_t> kept_rows(std::size_t num_rows) {
  const std::size_t taken = std::min(kBudget - 1, num_rows / kFramesPerKept);
  return thinned_indices(num_rows, std::min(kMaxKept, kBudget - taken));
}

KeptModel kept_scan(std::size_t row, const Rigid3& world_from_sensor, const Cloud& scan) {
  KeptModel kept{row, world_from_sensor, {}};
  const Vec3f origin = scan.origin.cast<float>();
  for (const std::uint32_t i : thinned_indices(scan.size(), kMaxModelPoints))
    kept.cloud.points.push_back(scan.points[i] + origin);
  return kept;
}

KeptModel kept_model(std::size_t row, const Odometry& odometry) {
  KeptModel kept{row, odometry.world_from_reference(), {}};
  if (!odometry.reference()) return kept;
  const Cloud& cloud = odometry.reference()->scan.cloud;
  kept.cloud = select(cloud, thinned_indices(cloud.size(), kMaxModelPoints));
  return kept;
}

nlohmann::ordered_json kept_json(const OdometryPicture& picture, const OdometryView& view) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  float far = 0.0f;  // from the first image with readings, so that colours mean the same in all
  for (const KeptModel& model : picture.models) {
    nlohmann::ordered_json frame = frame_json(picture, model.row, far);
    frame["model"] = model_json(model.cloud);
    frame["model_extent"] = bounds(model.cloud).diagonal();
    frame["model_pose"] = pose_numbers(view.page_from(model.world_from_model));
    json.push_back(std::move(frame));
  }
  return json;
}

}  // namespace augicp::app
