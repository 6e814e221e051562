// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace augicp {

// Appends a number, little endian.
template <typename T>
requires std::is_arithmetic_v<T>
void append_number(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof(T));
  out.append(bytes, sizeof(T));
}

// Writes a message of ROS 2: little endian, each number aligned to its size from behind the four bytes that say so.
class CdrWriter {
 public:
  template <typename T>
  void number(T value) {
    while ((bytes_.size() - kHead) % sizeof(T) != 0) bytes_ += '\0';
    append_number(bytes_, value);
  }

  // Texts end in a zero, which counts.
  void text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.append(text) += '\0';
  }

  void bytes(std::string_view bytes) {
    number(static_cast<std::uint32_t>(bytes.size()));
    bytes_.append(bytes);
  }

  std::string taken() && { return std::move(bytes_); }

 private:
  static constexpr std::size_t kHead = 4;
  std::string bytes_{"\0\1\0\0", kHead};
};

}  // namespace augicp
