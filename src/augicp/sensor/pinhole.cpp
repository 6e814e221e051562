// SPDX-License-Identifier: MIT
#include "augicp/sensor/pinhole.h"

#include <array>
#include <cmath>
#include <utility>

#include "augicp/core/check.h"

namespace augicp {
namespace {

struct NamedCamera {
  std::string_view name;
  Pinhole camera;
};

// TUM RGB-D: the data set's published calibrations and the ROS default it recommends; 7-Scenes and PrimeSense: the
// factory values those data sets state.
constexpr std::array<NamedCamera, 6> kCameras{{
    {"tum-default", {525.0, 525.0, 319.5, 239.5, 640, 480}},
    {"tum-fr1", {517.3, 516.5, 318.6, 255.3, 640, 480}},
    {"tum-fr2", {520.9, 521.0, 325.1, 249.7, 640, 480}},
    {"tum-fr3", {535.4, 539.2, 320.1, 247.6, 640, 480}},
    {"7scenes", {585.0, 585.0, 320.0, 240.0, 640, 480}},
    {"primesense", {525.0, 525.0, 319.5, 239.5, 640, 480}},
}};

}  // namespace

void Pinhole::check() const {
  // Far beyond any camera, and within what the projection's floats can hold.
  constexpr double kMin = 1e-3, kMax = 1e6;
  for (const auto& [name, value] : {std::pair{"fx", fx}, std::pair{"fy", fy}})
    require(value >= kMin && value <= kMax, name, value, "must be from 0.001 to 1e6 pixels");
  for (const auto& [name, value] : {std::pair{"cx", cx}, std::pair{"cy", cy}})
    require(std::abs(value) <= kMax, name, value, "must be from -1e6 to 1e6 pixels");
}

std::optional<Pinhole> camera_by_name(std::string_view name) {
  for (const NamedCamera& entry : kCameras)
    if (entry.name == name) return entry.camera;
  return std::nullopt;
}

std::vector<std::string> camera_names() {
  std::vector<std::string> names;
  for (const NamedCamera& entry : kCameras) names.emplace_back(entry.name);
  return names;
}

}  // namespace augicp
