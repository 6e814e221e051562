// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace augicp {

// The storage of a number in a file.
enum class ScalarType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };

enum class ByteOrder : std::uint8_t { Little, Big };

inline constexpr ByteOrder kNativeOrder =
    std::endian::native == std::endian::little ? ByteOrder::Little : ByteOrder::Big;

std::size_t num_bytes(ScalarType type);

inline bool is_floating(ScalarType type) { return type >= ScalarType::Float32; }

// Calls visit with a zero of the C++ type, and returns its result.
template <typename Visit>
auto with_type(ScalarType type, const Visit& visit) {
  switch (type) {
    case ScalarType::Int8:
      return visit(std::int8_t{});
    case ScalarType::Uint8:
      return visit(std::uint8_t{});
    case ScalarType::Int16:
      return visit(std::int16_t{});
    case ScalarType::Uint16:
      return visit(std::uint16_t{});
    case ScalarType::Int32:
      return visit(std::int32_t{});
    case ScalarType::Uint32:
      return visit(std::uint32_t{});
    case ScalarType::Int64:
      return visit(std::int64_t{});
    case ScalarType::Uint64:
      return visit(std::uint64_t{});
    case ScalarType::Float32:
      return visit(float{});
    case ScalarType::Float64:
      break;
  }
  return visit(double{});
}

// The number in the num_bytes(type) bytes at `bytes`.
double read_scalar(const char* bytes, ScalarType type, ByteOrder order);

// Copies the bytes of one number, from that order into the machine's own.
void copy_scalar(const char* bytes, ScalarType type, ByteOrder order, char* native);

}  // namespace augicp
