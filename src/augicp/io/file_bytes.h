// SPDX-License-Identifier: MIT
// Whole files in memory, and the messages of their errors.
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

// Throws IoError if path is not a regular file, cannot be read, or has more than max_bytes.
FileBytes read_bytes(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxFileBytes);

// The extension with its point, in lower case in any locale: ".ply" for "a.PLY".
std::string lower_case_extension(const std::filesystem::path& path);

// Errors to throw: "path: what", "path: line 3: what", "path: byte 17: what". Lines count from 1, bytes from 0.
IoError io_error(const std::filesystem::path& path, std::string_view what);
IoError io_error_at_line(const std::filesystem::path& path, std::uint64_t line, std::string_view what);
IoError io_error_at_byte(const std::filesystem::path& path, std::uint64_t byte, std::string_view what);

// Text of a file for a message: in quotes, cut to 40 characters, with '?' for unprintable bytes.
std::string in_quotes(std::string_view text);

}  // namespace augicp
