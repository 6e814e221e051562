// SPDX-License-Identifier: MIT
#include "augicp/io/camera_text.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "augicp/io/camera_parts.h"
#include "augicp/io/format.h"
#include "augicp/io/json_numbers.h"

namespace augicp {
namespace {

Numbers json_value(std::string_view text, const char* key) { return json_numbers("camera", text, key); }

double one_json_number(std::string_view json, const char* key) {
  const Numbers numbers = json_value(json, key);
  if (!numbers || numbers->size() != 1)
    throw std::invalid_argument(fmt::format("camera: expected \"{}\" to be one number", key));
  return numbers->front();
}

double readout_of(std::string_view json) {
  const std::vector<double> readout = json_value(json, "readout_s").value_or(std::vector<double>{0.0});
  if (readout.size() != 1) throw std::invalid_argument("camera: expected \"readout_s\" to be one number of seconds");
  return readout.front();
}

// Column by column, as Open3D writes it, or row by row: the last row is 0 0 1.
Pinhole pinhole_of_intrinsic_matrix(const std::vector<double>& given) {
  std::array<double, 9> k{};
  if (given.size() != k.size())
    throw std::invalid_argument(
        "camera: expected \"intrinsic_matrix\", \"camera_matrix\" or \"K\" with 9 numbers in the JSON, or \"fx\" "
        "\"fy\" \"cx\" "
        "\"cy\"");
  const bool is_by_rows = given[6] == 0.0 && given[7] == 0.0 && (given[2] != 0.0 || given[5] != 0.0);
  for (std::size_t i = 0; i < k.size(); ++i) k[i] = given[is_by_rows ? i : i % 3 * 3 + i / 3];
  return pinhole_from_matrix(k);
}

bool is_inverse_lens(std::string_view json) {
  return json.find("inverse_brown") != std::string_view::npos || json.find("Inverse Brown") != std::string_view::npos;
}

// librealsense's intrinsics. Its depth images have no distortion; the inverse model of colour is another than ours.
DepthCamera camera_of_realsense(std::string_view json) {
  DepthCamera camera{{one_json_number(json, "fx"), one_json_number(json, "fy"), 0.0, 0.0}, {}};
  const bool has_ppx = json_value(json, "ppx").has_value();
  camera.pinhole.cx = one_json_number(json, has_ppx ? "ppx" : "cx");
  camera.pinhole.cy = one_json_number(json, has_ppx ? "ppy" : "cy");
  camera.distortion = distortion_of(json_value(json, "coeffs"), "coeffs");
  if (!camera.distortion.is_none() && is_inverse_lens(json))
    throw std::invalid_argument("camera: expected the lens model Brown-Conrady, found its inverse");
  return camera;
}

}  // namespace

Pinhole pinhole_from_matrix(std::span<const double, 9> rows) {
  const std::array<double, 9> expected{rows[0], 0.0, rows[2], 0.0, rows[4], rows[5], 0.0, 0.0, 1.0};
  if (!std::equal(expected.begin(), expected.end(), rows.begin()))
    throw std::invalid_argument("camera: expected the matrix fx 0 cx, 0 fy cy, 0 0 1 (no skew)");
  return {rows[0], rows[4], rows[2], rows[5]};
}

DepthCamera camera_from_json(std::string_view given) {
  const std::string nested = json_object("camera", given, "intrinsic").value_or(std::string());
  const std::string_view text = nested.empty() ? given : nested;
  const Numbers matrix =
      first_value({"intrinsic_matrix", "camera_matrix", "K"}, [&](const char* key) { return json_value(text, key); });
  const bool is_realsense = !matrix && json_value(text, "fx").has_value();
  DepthCamera camera = is_realsense
                           ? camera_of_realsense(text)
                           : DepthCamera{pinhole_of_intrinsic_matrix(matrix.value_or(std::vector<double>{})), {}};
  if (const Numbers lens = json_value(text, "distortion")) camera.distortion = distortion_of(lens, "distortion");
  camera.readout_s = readout_of(text);
  camera.pinhole.width = image_side(json_value(text, "width"), "width");
  camera.pinhole.height = image_side(json_value(text, "height"), "height");
  return camera;
}

}  // namespace augicp
