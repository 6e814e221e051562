// SPDX-License-Identifier: MIT
// Whole files in memory, and the sentences that say what is wrong with them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "augicp/core/error.h"

namespace augicp {

struct FileBytes {
  std::filesystem::path path;  // for messages
  std::string bytes;
};

inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 34;

// Throws IoError where path is not a regular file, cannot be read or holds more than max_bytes.
FileBytes read_bytes(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxFileBytes);

// The extension with its point, in lower case whatever the locale: ".ply" of "a.PLY".
std::string lower_case_extension(const std::filesystem::path& path);

// Errors to throw: "path: what", "path: line 3: what", "path: byte 17: what". Lines count from 1, bytes from 0.
IoError io_error(const std::filesystem::path& path, std::string_view what);
IoError io_error_at_line(const std::filesystem::path& path, std::uint64_t line, std::string_view what);
IoError io_error_at_byte(const std::filesystem::path& path, std::uint64_t byte, std::string_view what);

// Text of a file for a message: in quotes, cut to 40 characters, unprintable bytes as '?'.
std::string in_quotes(std::string_view text);

}  // namespace augicp
