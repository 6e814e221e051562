// SPDX-License-Identifier: MIT
// Places in LAS files. Source: ASPRS, LAS Specification 1.4 - R15.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/io/scalar_type.h"

namespace augicp::las {

// Offsets in the header.
inline constexpr std::size_t kMinorVersion = 25, kHeaderSize = 94, kPointsOffset = 96, kNumVlrs = 100,
                             kPointFormat = 104, kRecordLength = 105, kLegacyNumPoints = 107, kScale = 131,
                             kOffset = 155, kBounds = 179, kWaveforms = 227, kEvlrs = 235, kNumEvlrs = 243,
                             kNumPoints = 247;

// Sizes of the header by minor version, of the header of a variable length record, and of an extended one.
inline constexpr std::size_t kHeaderSizes[] = {227, 227, 227, 235, 375};
inline constexpr std::size_t kVlrHeader = 54, kEvlrHeader = 60;

// The bytes of a record by point format, without extra bytes.
inline constexpr std::size_t kRecordSizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
inline constexpr int kNumFormats = 11;

// A number of a record, or bits of one byte of it.
struct Dimension {
  std::string_view name;
  std::size_t offset = 0;
  ScalarType type = ScalarType::Uint8;
  int shift = 0;
  int num_bits = 0;  // 0: the whole number
};

// The dimensions of a format beside the position and the waveform.
std::vector<Dimension> dimensions_of(int point_format);

// Formats whose points refer to a waveform.
bool has_waveform(int point_format);

// An additional number of each record, as the extra bytes' description states it.
struct ExtraDimension {
  std::string name;
  ScalarType type = ScalarType::Uint8;
  std::size_t count = 1;
  bool is_scaled = false;
  double scale = 1.0, offset = 0.0;
};

// The descriptions in the head of a file; empty if there are none. Ends before the first that is not understood.
std::vector<ExtraDimension> extra_dimensions(std::string_view head);

// The little-endian number at an offset. REQUIRES: offset + sizeof(T) <= bytes.size().
template <typename T>
T number_at(std::string_view bytes, std::size_t offset) {
  char native[sizeof(T)];
  std::memcpy(native, bytes.data() + offset, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(native, native + sizeof(T));
  T value;
  std::memcpy(&value, native, sizeof(T));
  return value;
}

// Writes the number there. REQUIRES: as above.
template <typename T>
void set_number(std::string& bytes, std::size_t offset, T value) {
  char native[sizeof(T)];
  std::memcpy(native, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(native, native + sizeof(T));
  std::memcpy(bytes.data() + offset, native, sizeof(T));
}

}  // namespace augicp::las
