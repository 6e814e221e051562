// SPDX-License-Identifier: MIT
#include "augicp/io/camera_file.h"

#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "augicp/io/camera_text.h"
#include "augicp/io/format.h"
#include "augicp/io/number_list.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

// If the second number is above this, it is a focal length, pixels.
constexpr double kMaxSkew = 10.0;

// The 3x3 part of a 4x4 matrix, whose other numbers are those of the identity.
std::vector<double> upper_left(const std::vector<double>& n) {
  const bool is_identity =
      n[3] == 0.0 && n[7] == 0.0 && n[11] == 0.0 && n[12] == 0.0 && n[13] == 0.0 && n[14] == 0.0 && n[15] == 1.0;
  if (!is_identity)
    throw std::invalid_argument("camera: expected a 4x4 or 3x4 matrix with the last row and column of the identity");
  return {n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10]};
}

std::vector<double> camera_numbers(std::string_view text) {
  try {
    return parse_number_list("camera", text, /*max_count=*/16);
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(
        std::string(fault.what()) +
        "; a camera is numbers, a matrix, JSON, or YAML with camera_matrix, K, intrinsics or fx fy cx cy");
  }
}

DepthCamera from_numbers(std::string_view text) {
  std::vector<double> n = camera_numbers(text);
  if (n.size() == 12) n.insert(n.end(), {0.0, 0.0, 0.0, 1.0});  // 3 x 4
  if (n.size() == 16) n = upper_left(n);
  const Pinhole pinhole = n.size() >= 4 ? Pinhole{n[0], n[1], n[2], n[3]} : Pinhole{};
  if (n.size() == 4) return {pinhole, {}};
  // Nine numbers are a pinhole with a lens, or a matrix. The second number of a matrix is the skew, never a focal
  // length.
  if (n.size() == 9 && std::abs(n[1]) > kMaxSkew) return {pinhole, {n[4], n[5], n[6], n[7], n[8]}};
  if (n.size() == 9) return {pinhole_from_matrix(std::span<const double, 9>(n.data(), 9)), {}};
  throw std::invalid_argument(fmt::format(
      "camera: expected fx fy cx cy, with or without k1 k2 p1 p2 k3, or a 3x3 or 4x4 matrix, found {} numbers",
      n.size()));
}

DepthCamera camera_in(std::string_view text) {
  if (starts_like_json(text)) return camera_from_json(text);
  return looks_like_yaml(text) ? camera_from_yaml(text) : from_numbers(text);
}

bool starts_with_a_number(std::string_view text) {
  const auto field = next_field(text, separator_of(text));
  return field && parse_double(*field);
}

}  // namespace

DepthCamera parse_camera(const FileBytes& file) {
  try {
    const DepthCamera camera = camera_in(file.bytes);
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

std::optional<double> depth_scale_of_camera(const std::string& name) {
  constexpr double kTum = 5000.0, kOthers = 1000.0;
  if (!camera_by_name(name)) return std::nullopt;
  return name.starts_with("tum-") ? kTum : kOthers;
}

}  // namespace augicp
