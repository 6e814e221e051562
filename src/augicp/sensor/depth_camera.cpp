// SPDX-License-Identifier: MIT
#include "augicp/sensor/depth_camera.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "augicp/core/check.h"
#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

struct NamedCamera {
  std::string_view name;
  DepthCamera camera;
};

// A first-generation Kinect reads a frame from top to bottom in about a frame period. On TUM fr1, 0.8 to 1.2 of it work
// equally well; without it the error per frame is up to a third larger. Not for 7-Scenes: some images are repeated
// under new numbers, so velocities between frames are meaningless.
constexpr double kKinectReadout_s = 1.0 / 30.0;

// TUM RGB-D: the published calibrations of the colour camera. Its lens applies to the depth, which is registered to
// colour; fr3's images were undistorted by the authors. tum-default: the ROS default that the data set recommends.
// 7-Scenes and PrimeSense: the factory values that those data sets state.
constexpr std::array<NamedCamera, 6> kCameras{{
    {"tum-default", {{525.0, 525.0, 319.5, 239.5, 640, 480}, {}, kKinectReadout_s}},
    {"tum-fr1", {{517.3, 516.5, 318.6, 255.3, 640, 480}, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633}, kKinectReadout_s}},
    {"tum-fr2",
     {{520.9, 521.0, 325.1, 249.7, 640, 480}, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172}, kKinectReadout_s}},
    {"tum-fr3", {{535.4, 539.2, 320.1, 247.6, 640, 480}, {}, kKinectReadout_s}},
    {"7scenes", {{585.0, 585.0, 320.0, 240.0, 640, 480}, {}, 0.0}},
    {"primesense", {{525.0, 525.0, 319.5, 239.5, 640, 480}, {}, 0.0}},
}};

struct Seen {
  double x, y;
};
inline Seen distorted(const Distortion& d, double x, double y) {
  const double r_sq = x * x + y * y;
  const double radial = 1.0 + r_sq * (d.k1 + r_sq * (d.k2 + r_sq * d.k3));
  return {x * radial + 2.0 * d.p1 * x * y + d.p2 * (r_sq + 2.0 * x * x),
          y * radial + d.p1 * (r_sq + 2.0 * y * y) + 2.0 * d.p2 * x * y};
}

// For a row of width pixels of the ideal image: the row-major index of each in the camera's image, -1 outside.
AUGICP_VECTORIZED void find_row(const DepthCamera& camera, const Pinhole& ideal, int v, int width,
                                std::int32_t* __restrict place) {
  const Pinhole pinhole = camera.pinhole;
  const Distortion lens = camera.distortion;
  const double image_width = pinhole.width, image_height = pinhole.height, y = (v - ideal.cy) / ideal.fy;
  for (int u = 0; u < width; ++u) {
    const Seen seen = distorted(lens, (u - ideal.cx) / ideal.fx, y);
    // The pixel of a coordinate. Comparisons come first, so that huge values never reach the conversion.
    const double column = pinhole.fx * seen.x + pinhole.cx + 0.5, row = pinhole.fy * seen.y + pinhole.cy + 0.5;
    const bool inside = (column >= 0.0) & (column < image_width) & (row >= 0.0) & (row < image_height);
    place[u] = static_cast<std::int32_t>(inside ? row : 0.0) * pinhole.width +
               static_cast<std::int32_t>(inside ? column : 0.0);
    place[u] = inside ? place[u] : -1;
  }
}

// The values of the camera's image as thinned(camera.pinhole, step) would see them; NaN outside.
std::vector<float> rectified(const std::vector<float>& values, int width, int height, const DepthCamera& camera,
                             int step) {
  const Pinhole seen_by = thinned(camera.pinhole, step);
  DepthCamera whole = camera;  // the camera's image size may be unknown
  whole.pinhole.width = width, whole.pinhole.height = height;
  const int num_rows = height / step, num_columns = width / step;
  std::vector<float> result(static_cast<std::size_t>(num_columns) * num_rows);
  std::vector<std::int32_t> place(static_cast<std::size_t>(num_columns));
  float* value = result.data();
  for (int v = 0; v < num_rows; ++v) {
    find_row(whole, seen_by, v, num_columns, place.data());
    for (const std::int32_t from : place) *value++ = from < 0 ? std::numeric_limits<float>::quiet_NaN() : values[from];
  }
  return result;
}

}  // namespace

Eigen::Vector2d Distortion::operator()(const Eigen::Vector2d& ideal) const {
  const Seen seen = distorted(*this, ideal.x(), ideal.y());
  return {seen.x, seen.y};
}

void DepthCamera::check() const {
  pinhole.check();
  constexpr double kMaxCoefficient = 100.0;
  for (const auto& [name, value] :
       {std::pair{"k1", distortion.k1}, std::pair{"k2", distortion.k2}, std::pair{"p1", distortion.p1},
        std::pair{"p2", distortion.p2}, std::pair{"k3", distortion.k3}})
    require(std::abs(value) <= kMaxCoefficient, name, value, "must be from -100 to 100");
  require(readout_s >= 0.0 && readout_s <= 1.0, "readout_s", readout_s, "must be from 0 to 1 s");
}

std::optional<DepthCamera> camera_by_name(std::string_view name) {
  for (const NamedCamera& entry : kCameras)
    if (entry.name == name) return entry.camera;
  return std::nullopt;
}

std::vector<std::string> camera_names() {
  std::vector<std::string> names;
  for (const NamedCamera& entry : kCameras) names.emplace_back(entry.name);
  return names;
}

Pinhole thinned(const Pinhole& camera, int step) {
  require(step >= 1, "step", step, "must be at least 1");
  const double scale = 1.0 / step;
  return {camera.fx * scale, camera.fy * scale,   camera.cx * scale,
          camera.cy * scale, camera.width / step, camera.height / step};
}

DepthImage rectify(const DepthImage& image, const DepthCamera& camera, int step) {
  camera.check();
  check_size(image, camera.pinhole);
  if (step == 1 && camera.distortion.is_none()) return image;
  return {image.width / step, image.height / step, rectified(image.depth, image.width, image.height, camera, step)};
}

GreyImage rectify(const GreyImage& image, const DepthCamera& camera, int step) {
  camera.check();
  check_size(image);
  check_size(DepthImage{image.width, image.height, image.value}, camera.pinhole);
  if (step == 1 && camera.distortion.is_none()) return image;
  return {image.width / step, image.height / step, rectified(image.value, image.width, image.height, camera, step)};
}

}  // namespace augicp
