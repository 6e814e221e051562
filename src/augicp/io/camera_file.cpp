// SPDX-License-Identifier: MIT
#include "augicp/io/camera_file.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/json_numbers.h"
#include "augicp/io/number_list.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

// If the second number is above this, it is a focal length, pixels.
constexpr double kMaxSkew = 10.0;

// A matrix row by row: fx 0 cx, 0 fy cy, 0 0 1.
Pinhole from_matrix(const std::array<double, 9>& k) {
  const std::array<double, 9> expected{k[0], 0.0, k[2], 0.0, k[4], k[5], 0.0, 0.0, 1.0};
  if (k != expected) throw std::invalid_argument("camera: expected the matrix fx 0 cx, 0 fy cy, 0 0 1 (no skew)");
  return {k[0], k[4], k[2], k[5]};
}

DepthCamera from_numbers(std::string_view text) {
  const std::vector<double> n = parse_number_list("camera", text, /*max_count=*/9);
  const Pinhole pinhole = n.size() >= 4 ? Pinhole{n[0], n[1], n[2], n[3]} : Pinhole{};
  if (n.size() == 4) return {pinhole, {}};
  // Nine numbers are a pinhole with a lens, or a matrix. The second number of a matrix is the skew, never a focal
  // length.
  if (n.size() == 9 && std::abs(n[1]) > kMaxSkew) return {pinhole, {n[4], n[5], n[6], n[7], n[8]}};
  if (n.size() == 9) return {from_matrix({n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]}), {}};
  throw std::invalid_argument(fmt::format(
      "camera: expected fx fy cx cy, with or without k1 k2 p1 p2 k3, or a 3x3 matrix, found {} numbers", n.size()));
}

int image_side(std::string_view json, const char* key) {
  constexpr double kMaxSide = 1 << 20;
  const auto numbers = json_numbers("camera", json, key);
  if (!numbers) return 0;
  const double side = numbers->size() == 1 ? numbers->front() : -1.0;
  if (!(side >= 0.0 && side <= kMaxSide))
    throw std::invalid_argument(fmt::format("camera: expected \"{}\" in pixels", key));
  return static_cast<int>(side);
}

Distortion distortion_of(std::string_view json) {
  const std::vector<double> d = json_numbers("camera", json, "distortion").value_or(std::vector<double>(5, 0.0));
  if (d.size() != 5) throw std::invalid_argument("camera: expected \"distortion\" with 5 numbers k1 k2 p1 p2 k3");
  return {d[0], d[1], d[2], d[3], d[4]};
}

double readout_of(std::string_view json) {
  const std::vector<double> readout = json_numbers("camera", json, "readout_s").value_or(std::vector<double>{0.0});
  if (readout.size() != 1) throw std::invalid_argument("camera: expected \"readout_s\" to be one number of seconds");
  return readout.front();
}

DepthCamera from_json(std::string_view text) {
  const std::vector<double> columns = json_numbers("camera", text, "intrinsic_matrix").value_or(std::vector<double>{});
  std::array<double, 9> k{};
  if (columns.size() != k.size())
    throw std::invalid_argument("camera: expected \"intrinsic_matrix\" with 9 numbers in the JSON");
  for (std::size_t i = 0; i < k.size(); ++i) k[i % 3 * 3 + i / 3] = columns[i];
  DepthCamera camera{from_matrix(k), distortion_of(text), readout_of(text)};
  camera.pinhole.width = image_side(text, "width");
  camera.pinhole.height = image_side(text, "height");
  return camera;
}

bool starts_with_a_number(std::string_view text) {
  const auto field = next_field(text, separator_of(text));
  return field && parse_double(*field);
}

}  // namespace

DepthCamera parse_camera(const FileBytes& file) {
  try {
    const DepthCamera camera = starts_like_json(file.bytes) ? from_json(file.bytes) : from_numbers(file.bytes);
    camera.check();
    return camera;
  } catch (const std::invalid_argument& error) {
    throw io_error(file.path, error.what());
  }
}

DepthCamera read_camera(const std::string& name_or_path_or_numbers) {
  if (const auto camera = camera_by_name(name_or_path_or_numbers)) return *camera;
  std::error_code ignored;
  if (std::filesystem::exists(name_or_path_or_numbers, ignored)) {
    constexpr std::uint64_t kMaxBytes = 1 << 20;
    return parse_camera(read_bytes(name_or_path_or_numbers, kMaxBytes));
  }
  if (starts_with_a_number(name_or_path_or_numbers))
    return parse_camera({in_quotes(name_or_path_or_numbers), name_or_path_or_numbers});
  throw IoError(fmt::format("camera {}: no such file, and no known name. Known are {}",
                            in_quotes(name_or_path_or_numbers), fmt::join(camera_names(), " ")));
}

}  // namespace augicp
