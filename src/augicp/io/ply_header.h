// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "augicp/io/file_bytes.h"
#include "augicp/io/scalar_type.h"

namespace augicp {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::Float32;
  std::optional<ScalarType> list_length;  // lists: the type of the length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_lists() const;
  std::uint64_t stride() const;  // bytes of one record without lists
};

enum class PlyEncoding : std::uint8_t { Ascii, BinaryLittleEndian, BinaryBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t body_offset = 0;
  std::uint64_t num_lines = 0;
};

// Lines may have up to 64 KB, comments any length. Throws IoError with the line.
PlyHeader parse_ply_header(const FileBytes& file);

}  // namespace augicp
