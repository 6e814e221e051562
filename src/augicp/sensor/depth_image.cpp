// SPDX-License-Identifier: MIT
#include "augicp/sensor/depth_image.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// The largest value means "out of range" in data that use it (7-Scenes); no sensor measures that far.
constexpr std::uint16_t kOutOfRange = 65535;

float metres(std::uint16_t value, double depth_scale) {
  const bool is_reading = value != 0 && value != kOutOfRange;
  return is_reading ? static_cast<float>(value / depth_scale) : std::numeric_limits<float>::quiet_NaN();
}

float metres(float value, double depth_scale) {
  const bool is_reading = std::isfinite(value) && value > 0.0f;
  return is_reading ? static_cast<float>(static_cast<double>(value) / depth_scale)
                    : std::numeric_limits<float>::quiet_NaN();
}

template <typename Value>
DepthImage image_of(std::span<const Value> values, int width, int height, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  DepthImage image{width, height, {}};
  image.depth.reserve(values.size());
  for (const Value value : values) image.depth.push_back(metres(value, depth_scale));
  check_size(image, Pinhole{1.0, 1.0, 0.0, 0.0});
  return image;
}

}  // namespace

DepthImage depth_image(std::span<const std::uint16_t> values, int width, int height, double depth_scale) {
  return image_of(values, width, height, depth_scale);
}

DepthImage depth_image(std::span<const float> values, int width, int height, double depth_scale) {
  return image_of(values, width, height, depth_scale);
}

void check_size(const DepthImage& image, const Pinhole& camera) {
  camera.check();
  if (image.width < 0 || image.height < 0 || image.depth.size() != static_cast<std::size_t>(image.width) * image.height)
    throw std::invalid_argument("depth image: the array does not hold width * height values");
  const bool fits =
      (camera.width == 0 || camera.width == image.width) && (camera.height == 0 || camera.height == image.height);
  if (fits) return;
  throw std::invalid_argument("depth image is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                              " pixels, the camera's are " + std::to_string(camera.width) + " x " +
                              std::to_string(camera.height));
}

double DepthNoise::weight(double z) const {
  const double grown = per_depth_sq * z * z;
  return floor * floor / (floor * floor + grown * grown);
}

OrganizedCloud unproject(const DepthImage& image, const Pinhole& camera, const DepthRange& range,
                         const DepthNoise& noise) {
  require_positive("noise floor", noise.floor);
  require_not_negative("noise per_depth_sq", noise.per_depth_sq);
  check_size(image, camera);
  OrganizedCloud result{{}, IndexImage(image.width, image.height)};
  Cloud& cloud = result.cloud;
  cloud.viewpoint = Vec3f::Zero();
  cloud.points.reserve(image.depth.size());
  std::size_t pixel = 0;
  for (int v = 0; v < image.height; ++v) {
    const double y = (v - camera.cy) / camera.fy;
    for (int u = 0; u < image.width; ++u, ++pixel) {
      const double z = image.depth[pixel];
      if (!(z > range.min && z <= range.max && z < std::numeric_limits<float>::max())) continue;  // NaN fails too
      result.index.index[pixel] = static_cast<std::int32_t>(cloud.points.size());
      cloud.weights.push_back(static_cast<float>(noise.weight(z)));
      cloud.points.push_back((z * Vec3d((u - camera.cx) / camera.fx, y, 1.0)).cast<float>());
    }
  }
  return result;
}

}  // namespace augicp
