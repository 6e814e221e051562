// SPDX-License-Identifier: MIT
// Messages of ROS 1 and ROS 2: numbers, texts, headers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "augicp/io/scalar_type.h"

namespace augicp {

enum class MessageForm : std::uint8_t {
  Ros1,  // packed, little endian
  Cdr,   // ROS 2: aligned, behind four bytes that state the byte order
};

struct MessageHeader {
  std::int64_t stamp_ns = 0;
  std::string frame;  // name of the coordinate frame
};

// Takes numbers and texts from the front of a message. Throws IoError with source, type and byte where the message ends
// too soon. REQUIRES: source, type and message outlive it. Thread safety: none.
class MessageReader {
 public:
  MessageReader(const std::filesystem::path& source, std::string_view type, std::string_view message, MessageForm form);

  [[noreturn]] void fail(std::string_view what) const;

  // An integer, whole numbers of floats.
  std::uint64_t take(ScalarType type);
  double take_double();
  std::uint32_t take_count() { return static_cast<std::uint32_t>(take(ScalarType::Uint32)); }
  std::string take_text();
  std::string_view take_bytes(std::uint64_t count);
  MessageHeader take_header();

 private:
  const char* take_number(ScalarType type);
  void align(std::size_t size);

  const std::filesystem::path& source_;
  std::string_view type_, message_;
  MessageForm form_;
  ByteOrder order_ = ByteOrder::Little;
  std::size_t at_ = 0, begin_ = 0;
};

}  // namespace augicp
