// SPDX-License-Identifier: MIT
#include "augicp/io/scalar_type.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace augicp {
namespace {

template <typename T>
double read_as(const char* bytes, ByteOrder order) {
  char native[sizeof(T)];
  std::memcpy(native, bytes, sizeof(T));
  constexpr ByteOrder kNative = std::endian::native == std::endian::little ? ByteOrder::Little : ByteOrder::Big;
  if (order != kNative) std::reverse(native, native + sizeof(T));
  T value;
  std::memcpy(&value, native, sizeof(T));
  return static_cast<double>(value);
}

}  // namespace

std::size_t num_bytes(ScalarType type) {
  constexpr std::size_t kNumBytes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kNumBytes[static_cast<std::size_t>(type)];
}

double read_scalar(const char* bytes, ScalarType type, ByteOrder order) {
  switch (type) {
    case ScalarType::Int8:
      return read_as<std::int8_t>(bytes, order);
    case ScalarType::Uint8:
      return read_as<std::uint8_t>(bytes, order);
    case ScalarType::Int16:
      return read_as<std::int16_t>(bytes, order);
    case ScalarType::Uint16:
      return read_as<std::uint16_t>(bytes, order);
    case ScalarType::Int32:
      return read_as<std::int32_t>(bytes, order);
    case ScalarType::Uint32:
      return read_as<std::uint32_t>(bytes, order);
    case ScalarType::Int64:
      return read_as<std::int64_t>(bytes, order);
    case ScalarType::Uint64:
      return read_as<std::uint64_t>(bytes, order);
    case ScalarType::Float32:
      return read_as<float>(bytes, order);
    case ScalarType::Float64:
      return read_as<double>(bytes, order);
  }
  assert(false);
  return 0.0;
}

}  // namespace augicp
