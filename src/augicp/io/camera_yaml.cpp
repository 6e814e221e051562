// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>
#include <string>

#include "augicp/io/camera_parts.h"
#include "augicp/io/camera_text.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

constexpr const char* kMatrixKeys[] = {"camera_matrix", "K", "k"};
constexpr const char* kListKey = "intrinsics";
constexpr const char* kFirstLabel = "fx";

// Whether the word is the key, alone or as a member of a camera: "fx", "Camera.fx", "Camera1.fx".
bool is_key(std::string_view word, std::string_view key) {
  const std::size_t point = word.rfind('.');
  if (point == std::string_view::npos) return word == key;
  return word.starts_with("Camera") && word.substr(point + 1) == key;
}

// The text behind "key:" or "key =" at the begin of a line, blanks before it aside; empty if there is none.
std::optional<std::string_view> behind_key(std::string_view text, std::string_view key) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    const std::size_t end = content.find_first_of(":= \t");
    if (end == std::string_view::npos || !is_key(content.substr(0, end), key)) continue;
    const std::size_t sign = content.find_first_not_of(" \t", end);
    if (sign == std::string_view::npos || (content[sign] != ':' && content[sign] != '=')) continue;
    return text.substr(static_cast<std::size_t>(content.data() - text.data()) + sign + 1);
  }
  return std::nullopt;
}

std::string_view first_line(std::string_view text) { return trimmed(text.substr(0, text.find_first_of("\r\n"))); }

std::vector<double> numbers_in(std::string_view list) {
  std::string words(list);
  for (char& c : words)
    if (c == ',' || c == '\n' || c == '\r') c = ' ';
  std::vector<double> numbers;
  std::string_view rest = words;
  while (const auto field = next_field(rest)) {
    const auto number = parse_double(*field);
    if (!number) throw std::invalid_argument("camera: expected a number, found " + in_quotes(*field));
    numbers.push_back(*number);
  }
  return numbers;
}

// "- 525.0" a line; empty if the next line is none.
std::vector<double> items_in(std::string_view rest) {
  std::vector<double> numbers;
  TextLines lines(rest);
  while (const auto line = lines.next_not_blank()) {
    const std::string_view content = trimmed(*line);
    if (!content.starts_with('-')) break;
    const auto number = parse_double(trimmed(content.substr(1)));
    if (!number) throw std::invalid_argument("camera: expected '- number', found " + in_quotes(content));
    numbers.push_back(*number);
  }
  return numbers;
}

// The number, the list in brackets or of items, or the list under data: of a matrix.
Numbers yaml_value(std::string_view text, std::string_view key) {
  auto rest = behind_key(text, key);
  if (!rest) return std::nullopt;
  const std::string_view line = first_line(*rest);
  if (line.empty() || line.starts_with("!!") || line.starts_with('{')) {
    if (std::vector<double> items = line.empty() ? items_in(*rest) : std::vector<double>{}; !items.empty())
      return items;
    rest = behind_key(*rest, "data");
    if (!rest) throw std::invalid_argument(fmt::format("camera: expected data of \"{}\"", key));
  } else if (!line.starts_with('[')) {
    return numbers_in(line.substr(0, line.find('#')));
  }
  const std::size_t begin = rest->find('['), end = rest->find(']');
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin)
    throw std::invalid_argument(fmt::format("camera: expected a list in brackets of \"{}\"", key));
  return numbers_in(rest->substr(begin + 1, end - begin - 1));
}

// A model that the text states is one of these words, in whatever quotes, or nothing.
void check_model(std::string_view text, const char* key, std::initializer_list<std::string_view> known) {
  const auto behind = behind_key(text, key);
  if (!behind) return;
  const std::string_view model = first_line(*behind), name = model.substr(0, model.find('#'));
  const bool is_nothing = name.find_first_not_of(" \t\"'") == std::string_view::npos;
  const auto is_in_name = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
  if (!is_nothing && std::none_of(known.begin(), known.end(), is_in_name))
    throw std::invalid_argument(
        fmt::format("camera: expected the {} {}, found {}", key, *known.begin(), in_quotes(name)));
}

// Files of several cameras do not say which one is meant.
void require_one(std::string_view text, const char* key) {
  if (behind_key(*behind_key(text, key), key))
    throw std::invalid_argument(fmt::format("camera: expected one camera, found \"{}\" twice", key));
}

double one_yaml_number(std::string_view text, const char* key) {
  const Numbers numbers = yaml_value(text, key);
  if (!numbers || numbers->size() != 1)
    throw std::invalid_argument(fmt::format("camera: expected \"{}\" with one number", key));
  return numbers->front();
}

// The matrix of ROS and OpenCV. Its lens follows in every such file.
DepthCamera camera_of_matrix(std::string_view text, const std::vector<double>& k) {
  if (k.size() != 9)
    throw std::invalid_argument(fmt::format("camera: expected a 3x3 matrix, found {} numbers", k.size()));
  DepthCamera camera{pinhole_from_matrix(std::span<const double, 9>(k.data(), 9)), {}};
  const Numbers lens =
      first_value({"distortion_coefficients", "D", "d"}, [&](const char* key) { return yaml_value(text, key); });
  if (!lens)
    throw std::invalid_argument("camera: expected \"distortion_coefficients\" in the YAML: the file may be cut");
  if (!lens->empty()) camera.distortion = distortion_of(lens, "distortion_coefficients");
  return camera;
}

// The list of kalibr and EuRoC.
DepthCamera camera_of_list(std::string_view text) {
  require_one(text, kListKey);
  const std::vector<double> f = yaml_value(text, kListKey).value();
  if (f.size() != 4) throw std::invalid_argument(fmt::format("camera: expected \"{}\" with fx fy cx cy", kListKey));
  const Numbers lens = first_value({"distortion_coeffs", "distortion_coefficients"},
                                   [&](const char* key) { return yaml_value(text, key); });
  return {{f[0], f[1], f[2], f[3]}, lens && !lens->empty() ? distortion_of(lens, "distortion_coeffs") : Distortion{}};
}

// One line a number: fx, Camera.fx (ORB-SLAM), fx = 525.
DepthCamera camera_of_labels(std::string_view text) {
  require_one(text, kFirstLabel);
  DepthCamera camera{{one_yaml_number(text, "fx"), one_yaml_number(text, "fy"), one_yaml_number(text, "cx"),
                      one_yaml_number(text, "cy")},
                     {}};
  std::vector<double> lens;
  for (const char* key : {"k1", "k2", "p1", "p2", "k3"})
    lens.push_back(behind_key(text, key) ? one_yaml_number(text, key) : 0);
  camera.distortion = distortion_of(lens, "k1");
  return camera;
}

void add_size(std::string_view text, Pinhole& pinhole) {
  const auto value_of = [&](const char* key) { return yaml_value(text, key); };
  const Numbers both = value_of("resolution");
  if (both && both->size() != 2)
    throw std::invalid_argument("camera: expected \"resolution\" with a width and a height");
  const auto side = [&](std::size_t place, std::initializer_list<const char*> keys) {
    return image_side(both ? Numbers(std::vector<double>{(*both)[place]}) : first_value(keys, value_of), *keys.begin());
  };
  pinhole.width = side(0, {"image_width", "width"});
  pinhole.height = side(1, {"image_height", "height"});
}

}  // namespace

bool looks_like_yaml(std::string_view text) {
  const auto has = [&](const char* key) { return behind_key(text, key).has_value(); };
  return std::any_of(std::begin(kMatrixKeys), std::end(kMatrixKeys), has) || has(kListKey) || has(kFirstLabel);
}

DepthCamera camera_from_yaml(std::string_view text) {
  check_model(text, "distortion_model", {"plumb_bob", "radtan", "radial-tangential", "none"});
  check_model(text, "camera_model", {"pinhole", "Pinhole"});
  check_model(text, "type", {"PinHole", "Pinhole", "Rectified"});
  const Numbers matrix = first_value({kMatrixKeys[0], kMatrixKeys[1], kMatrixKeys[2]},
                                     [&](const char* key) { return yaml_value(text, key); });
  DepthCamera camera = matrix                       ? camera_of_matrix(text, *matrix)
                       : behind_key(text, kListKey) ? camera_of_list(text)
                                                    : camera_of_labels(text);
  add_size(text, camera.pinhole);
  return camera;
}

}  // namespace augicp
