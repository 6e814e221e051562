// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "augicp/core/types.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/scalar_type.h"

namespace augicp {

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::Float32;
  std::uint64_t count = 1;  // numbers per point in this field

  std::uint64_t bytes() const { return count * num_bytes(type); }
  bool is_padding() const { return name == "_"; }
};

enum class PcdEncoding : std::uint8_t { Ascii, Binary, BinaryCompressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t width = 0;
  std::uint64_t height = 1;  // 1: not organised
  std::uint64_t num_points = 0;
  std::optional<Vec3d> viewpoint;  // empty if the file states the default pose, as most files do
  PcdEncoding encoding = PcdEncoding::Ascii;
  std::size_t body_offset = 0;
  std::uint64_t num_lines = 0;
};

// Versions 0.5 to 0.7. Throws IoError with the line.
PcdHeader parse_pcd_header(const FileBytes& file);

}  // namespace augicp
