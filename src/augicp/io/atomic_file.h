// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace augicp {

// A file that is whole or absent. Bytes go to a temporary file in the same folder, which commit() renames to path;
// without commit() nothing remains. Targets that are no regular files (a pipe, /dev/stdout) are written directly. Every
// failure, such as a full disk, throws IoError. Thread safety: none.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  [[noreturn]] void fail(std::string_view what) const;

  std::filesystem::path path_;       // as given by the caller
  std::filesystem::path target_;     // with symbolic links resolved
  std::filesystem::path temporary_;  // empty if the target is written directly
  std::FILE* stream_ = nullptr;
};

// Writes the whole file in one call.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace augicp
