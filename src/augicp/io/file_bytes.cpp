// SPDX-License-Identifier: MIT
#include "augicp/io/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "augicp/io/format.h"

namespace augicp {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::uint64_t checked_size(const std::filesystem::path& path, std::uint64_t max_bytes) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) throw io_error(path, "no such file");
  if (!std::filesystem::exists(status)) throw io_error(path, error.message());
  if (std::filesystem::is_directory(status)) throw io_error(path, "expected a file, found a directory");
  if (!std::filesystem::is_regular_file(status)) throw io_error(path, "expected a regular file");
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) throw io_error(path, error.message());
  if (size > max_bytes) throw io_error(path, fmt::format("expected at most {} bytes, found {}", max_bytes, size));
  return size;
}

}  // namespace

FileBytes read_bytes(const std::filesystem::path& path, std::uint64_t max_bytes) {
  FileBytes file{path, std::string(checked_size(path, max_bytes), '\0')};
  const File stream(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!stream) throw io_error(path, "cannot be opened: " + std::generic_category().message(errno));
  const std::size_t num_read = std::fread(file.bytes.data(), 1, file.bytes.size(), stream.get());
  if (num_read != file.bytes.size())
    throw io_error_at_byte(path, num_read, fmt::format("expected {} bytes, the file ends here", file.bytes.size()));
  return file;
}

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

IoError io_error(const std::filesystem::path& path, std::string_view what) {
  return IoError(fmt::format("{}: {}", path.string(), what));
}

IoError io_error_at_line(const std::filesystem::path& path, std::uint64_t line, std::string_view what) {
  return IoError(fmt::format("{}: line {}: {}", path.string(), line, what));
}

IoError io_error_at_byte(const std::filesystem::path& path, std::uint64_t byte, std::string_view what) {
  return IoError(fmt::format("{}: byte {}: {}", path.string(), byte, what));
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMaxLength = 40;
  std::string shown(text.substr(0, kMaxLength));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + shown + (text.size() > kMaxLength ? "...'" : "'");
}

}  // namespace augicp
