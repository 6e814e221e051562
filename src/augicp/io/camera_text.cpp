// SPDX-License-Identifier: MIT
#include "augicp/io/camera_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/json_numbers.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

using Numbers = std::optional<std::vector<double>>;

int image_side(const Numbers& numbers, const char* key) {
  constexpr double kMaxSide = 1 << 20;
  if (!numbers) return 0;
  const double side = numbers->size() == 1 ? numbers->front() : -1.0;
  if (!(side >= 0.0 && side <= kMaxSide))
    throw std::invalid_argument(fmt::format("camera: expected \"{}\" in pixels", key));
  return static_cast<int>(side);
}

// k1 k2 p1 p2, with or without k3.
Distortion distortion_of(const Numbers& numbers, const char* key) {
  if (!numbers) return {};
  std::vector<double> d = *numbers;
  if (d.size() == 4) d.push_back(0.0);
  if (d.size() != 5)
    throw std::invalid_argument(fmt::format("camera: expected \"{}\" with 5 numbers k1 k2 p1 p2 k3", key));
  return {d[0], d[1], d[2], d[3], d[4]};
}

// ---- JSON

Numbers json_value(std::string_view text, const char* key) { return json_numbers("camera", text, key); }

double one_number(std::string_view json, const char* key) {
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
    throw std::invalid_argument("camera: expected \"intrinsic_matrix\" with 9 numbers in the JSON");
  const bool is_by_rows = given[6] == 0.0 && given[7] == 0.0 && (given[2] != 0.0 || given[5] != 0.0);
  for (std::size_t i = 0; i < k.size(); ++i) k[i] = given[is_by_rows ? i : i % 3 * 3 + i / 3];
  return pinhole_from_matrix(k);
}

bool is_inverse_lens(std::string_view json) {
  return json.find("inverse_brown") != std::string_view::npos || json.find("Inverse Brown") != std::string_view::npos;
}

// librealsense's intrinsics. Its depth images have no distortion; the inverse model of colour is another than ours.
DepthCamera camera_of_realsense(std::string_view json) {
  DepthCamera camera{{one_number(json, "fx"), one_number(json, "fy"), 0.0, 0.0}, {}};
  const bool has_ppx = json_value(json, "ppx").has_value();
  camera.pinhole.cx = one_number(json, has_ppx ? "ppx" : "cx");
  camera.pinhole.cy = one_number(json, has_ppx ? "ppy" : "cy");
  camera.distortion = distortion_of(json_value(json, "coeffs"), "coeffs");
  if (!camera.distortion.is_none() && is_inverse_lens(json))
    throw std::invalid_argument("camera: expected the lens model Brown-Conrady, found its inverse");
  return camera;
}

// ---- YAML

// The text behind "key:" at the begin of a line, blanks before it aside; empty if there is none.
std::optional<std::string_view> behind_key(std::string_view text, std::string_view key) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (!content.starts_with(key) || !content.substr(key.size()).starts_with(':')) continue;
    return text.substr(static_cast<std::size_t>(content.data() - text.data()) + key.size() + 1);
  }
  return std::nullopt;
}

std::vector<double> numbers_in(std::string_view list) {
  std::string words(list);
  for (char& c : words)
    if (c == ',' || c == '\n' || c == '\r') c = ' ';
  std::vector<double> numbers;
  std::string_view rest = words;
  while (const auto field = next_field(rest)) {
    const auto number = parse_double(*field);
    if (!number) throw std::invalid_argument("camera: expected a number, found " + std::string(field->substr(0, 40)));
    numbers.push_back(*number);
  }
  return numbers;
}

// The number, the list in brackets, or the list under data: of a matrix.
Numbers yaml_value(std::string_view text, std::string_view key) {
  auto rest = behind_key(text, key);
  if (!rest) return std::nullopt;
  const std::string_view line = trimmed(rest->substr(0, rest->find_first_of("\r\n")));
  if (line.empty() || line.starts_with("!!") || line.starts_with('{')) {
    rest = behind_key(*rest, "data");
    if (!rest) throw std::invalid_argument(fmt::format("camera: expected data of \"{}\"", key));
  } else if (!line.starts_with('[')) {
    return numbers_in(line);
  }
  const std::size_t begin = rest->find('['), end = rest->find(']');
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin)
    throw std::invalid_argument(fmt::format("camera: expected a list in brackets of \"{}\"", key));
  return numbers_in(rest->substr(begin + 1, end - begin - 1));
}

Numbers first_value(std::string_view text, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (Numbers numbers = yaml_value(text, key)) return numbers;
  return std::nullopt;
}

void check_lens_model(std::string_view text) {
  const auto behind = behind_key(text, "distortion_model");
  if (!behind) return;
  const std::string_view model = behind->substr(0, behind->find_first_of("\r\n"));
  const bool is_known = model.find("plumb_bob") != std::string_view::npos ||
                        model.find("radtan") != std::string_view::npos || trimmed(model).empty() ||
                        trimmed(model) == "\"\"" || trimmed(model) == "''";
  if (!is_known)
    throw std::invalid_argument(fmt::format("camera: expected the lens model plumb_bob, found {}", trimmed(model)));
}

}  // namespace

Pinhole pinhole_from_matrix(std::span<const double, 9> rows) {
  const std::array<double, 9> expected{rows[0], 0.0, rows[2], 0.0, rows[4], rows[5], 0.0, 0.0, 1.0};
  if (!std::equal(expected.begin(), expected.end(), rows.begin()))
    throw std::invalid_argument("camera: expected the matrix fx 0 cx, 0 fy cy, 0 0 1 (no skew)");
  return {rows[0], rows[4], rows[2], rows[5]};
}

DepthCamera camera_from_json(std::string_view text) {
  const Numbers matrix = json_value(text, "intrinsic_matrix");
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

bool looks_like_yaml(std::string_view text) {
  return behind_key(text, "camera_matrix") || behind_key(text, "K") || behind_key(text, "k");
}

DepthCamera camera_from_yaml(std::string_view text) {
  check_lens_model(text);
  const std::vector<double> k = first_value(text, {"camera_matrix", "K", "k"}).value_or(std::vector<double>{});
  if (k.size() != 9)
    throw std::invalid_argument(fmt::format("camera: expected a 3x3 matrix, found {} numbers", k.size()));
  DepthCamera camera{pinhole_from_matrix(std::span<const double, 9>(k.data(), 9)), {}};
  const Numbers lens = first_value(text, {"distortion_coefficients", "D", "d"});
  if (!lens)
    throw std::invalid_argument("camera: expected \"distortion_coefficients\" in the YAML: the file may be cut");
  if (!lens->empty()) camera.distortion = distortion_of(lens, "distortion_coefficients");
  camera.pinhole.width = image_side(first_value(text, {"image_width", "width"}), "image_width");
  camera.pinhole.height = image_side(first_value(text, {"image_height", "height"}), "image_height");
  return camera;
}

}  // namespace augicp
