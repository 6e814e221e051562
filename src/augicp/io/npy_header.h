// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "augicp/io/file_bytes.h"
#include "augicp/io/scalar_type.h"

namespace augicp {

// A named member of the items of a structured array.
struct NpyMember {
  std::string name;
  ScalarType type = ScalarType::Float32;
  ByteOrder order = ByteOrder::Little;
  std::size_t count = 1;
  std::size_t offset = 0;  // in the item, bytes
};

struct NpyHeader {
  ScalarType type = ScalarType::Float64;  // of plain arrays
  ByteOrder order = ByteOrder::Little;
  bool is_half = false;            // plain arrays: the numbers are float16, and type is Float32
  std::vector<NpyMember> members;  // structured arrays: not empty
  std::size_t item_bytes = 0;
  bool is_fortran = false;
  std::vector<std::uint64_t> shape;  // plain: (N, C) or (H, W, C); structured: (N) or (H, W)
  std::size_t body_offset = 0;

  bool is_structured() const { return !members.empty(); }
};

// Of an array of points. Versions 1 to 3. Throws IoError with the byte.
NpyHeader parse_npy_header(const FileBytes& file);

// Of an image, of the shape (H, W).
NpyHeader parse_npy_image_header(const FileBytes& file);

// The number of IEEE 754's binary16.
float number_of_half(std::uint16_t half);

}  // namespace augicp
