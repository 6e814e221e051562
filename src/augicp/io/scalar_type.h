// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace augicp {

// The storage of a number in a binary file.
enum class ScalarType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };

enum class ByteOrder : std::uint8_t { Little, Big };

std::size_t num_bytes(ScalarType type);

// The number in the num_bytes(type) bytes at `bytes`.
double read_scalar(const char* bytes, ScalarType type, ByteOrder order);

}  // namespace augicp
