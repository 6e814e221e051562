// SPDX-License-Identifier: MIT
#include "augicp/io/las_format.h"

#include <optional>

namespace augicp::las {
namespace {

using enum ScalarType;

constexpr Dimension kLegacy[] = {{"intensity", 12, Uint16},
                                 {"return_number", 14, Uint8, 0, 3},
                                 {"number_of_returns", 14, Uint8, 3, 3},
                                 {"scan_direction_flag", 14, Uint8, 6, 1},
                                 {"edge_of_flight_line", 14, Uint8, 7, 1},
                                 {"classification", 15, Uint8, 0, 5},
                                 {"synthetic", 15, Uint8, 5, 1},
                                 {"key_point", 15, Uint8, 6, 1},
                                 {"withheld", 15, Uint8, 7, 1},
                                 {"scan_angle_rank", 16, Int8},
                                 {"user_data", 17, Uint8},
                                 {"point_source_id", 18, Uint16}};

constexpr Dimension kExtended[] = {{"intensity", 12, Uint16},
                                   {"return_number", 14, Uint8, 0, 4},
                                   {"number_of_returns", 14, Uint8, 4, 4},
                                   {"synthetic", 15, Uint8, 0, 1},
                                   {"key_point", 15, Uint8, 1, 1},
                                   {"withheld", 15, Uint8, 2, 1},
                                   {"overlap", 15, Uint8, 3, 1},
                                   {"scanner_channel", 15, Uint8, 4, 2},
                                   {"scan_direction_flag", 15, Uint8, 6, 1},
                                   {"edge_of_flight_line", 15, Uint8, 7, 1},
                                   {"classification", 16, Uint8},
                                   {"user_data", 17, Uint8},
                                   {"scan_angle", 18, Int16},
                                   {"point_source_id", 20, Uint16},
                                   {"gps_time", 22, Float64}};

constexpr std::size_t kNone = 0;
constexpr std::size_t kTimeOffset[] = {kNone, 20, kNone, 20, 20, 20, kNone, kNone, kNone, kNone, kNone};
constexpr std::size_t kColourOffset[] = {kNone, kNone, 20, 28, kNone, 28, kNone, 30, 30, kNone, 30};
constexpr std::size_t kInfraredOffset[] = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, 36, kNone, 36};

// Text in a field of fixed length, ended by a zero.
std::string text_at(std::string_view bytes, std::size_t offset, std::size_t length) {
  const std::string_view field = bytes.substr(offset, length);
  return std::string(field.substr(0, field.find('\0')));
}

// The payload of the record that describes extra bytes.
std::string_view extra_bytes_payload(std::string_view head) {
  std::size_t at = number_at<std::uint16_t>(head, kHeaderSize);
  for (std::uint32_t i = 0; i < number_at<std::uint32_t>(head, kNumVlrs); ++i) {
    if (at + kVlrHeader > head.size()) return {};
    const std::size_t length = number_at<std::uint16_t>(head, at + 20);
    const bool is_it = text_at(head, at + 2, 16) == "LASF_Spec" && number_at<std::uint16_t>(head, at + 18) == 4;
    at += kVlrHeader;
    if (is_it) return head.substr(at, length);
    at += length;
  }
  return {};
}

std::optional<ExtraDimension> described(std::string_view description) {
  constexpr ScalarType kTypes[] = {Uint8, Int8, Uint16, Int16, Uint32, Int32, Uint64, Int64, Float32, Float64};
  constexpr int kNumTypes = 10, kHasScale = 8, kHasOffset = 16;
  const int code = static_cast<std::uint8_t>(description[2]), options = static_cast<std::uint8_t>(description[3]);
  ExtraDimension extra{text_at(description, 4, 32)};
  if (code == 0) {  // so many bytes of unknown meaning
    extra.count = static_cast<std::size_t>(options);
    return options > 0 ? std::optional(extra) : std::nullopt;
  }
  if (code > 3 * kNumTypes) return std::nullopt;
  extra.type = kTypes[(code - 1) % kNumTypes];
  extra.count = static_cast<std::size_t>((code - 1) / kNumTypes + 1);
  extra.is_scaled = extra.count == 1 && (options & (kHasScale | kHasOffset)) != 0;
  if (options & kHasScale) extra.scale = number_at<double>(description, 112);
  if (options & kHasOffset) extra.offset = number_at<double>(description, 136);
  return extra;
}

}  // namespace

std::vector<Dimension> dimensions_of(int point_format) {
  std::vector<Dimension> all;
  if (point_format < 6) {
    all.assign(std::begin(kLegacy), std::end(kLegacy));
  } else {
    all.assign(std::begin(kExtended), std::end(kExtended));
  }
  if (const std::size_t at = kTimeOffset[point_format]; at != kNone) all.push_back({"gps_time", at, Float64});
  if (const std::size_t at = kColourOffset[point_format]; at != kNone)
    for (std::size_t i = 0; i < 3; ++i) all.push_back({i == 0 ? "red" : i == 1 ? "green" : "blue", at + 2 * i, Uint16});
  if (const std::size_t at = kInfraredOffset[point_format]; at != kNone) all.push_back({"nir", at, Uint16});
  return all;
}

bool has_waveform(int point_format) {
  return point_format == 4 || point_format == 5 || point_format == 9 || point_format == 10;
}

std::vector<ExtraDimension> extra_dimensions(std::string_view head) {
  constexpr std::size_t kDescription = 192;
  const std::string_view payload = extra_bytes_payload(head);
  std::vector<ExtraDimension> all;
  for (std::size_t at = 0; at + kDescription <= payload.size(); at += kDescription) {
    const auto extra = described(payload.substr(at, kDescription));
    if (!extra) break;
    all.push_back(*extra);
  }
  return all;
}

}  // namespace augicp::las
