// SPDX-License-Identifier: MIT
#include "augicp/io/scalar_type.h"

#include <algorithm>
#include <cstring>

namespace augicp {
namespace {

template <typename T>
double read_as(const char* bytes, ByteOrder order) {
  char native[sizeof(T)];
  std::memcpy(native, bytes, sizeof(T));
  if (order != kNativeOrder) std::reverse(native, native + sizeof(T));
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
  return with_type(type, [&](auto zero) { return read_as<decltype(zero)>(bytes, order); });
}

void copy_scalar(const char* bytes, ScalarType type, ByteOrder order, char* native) {
  const std::size_t size = num_bytes(type);
  std::memcpy(native, bytes, size);
  if (order != kNativeOrder) std::reverse(native, native + size);
}

}  // namespace augicp
