// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace augicp {

// A file that appears whole or not at all. Bytes go to a temporary file in the same folder, which takes the place of
// path on commit(); without commit() nothing is left behind. What is not a regular file (a pipe, /dev/stdout) is
// written directly. Every failure, a full disk too, is an IoError. Not for concurrent use.
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

  std::filesystem::path path_;       // as the caller named it
  std::filesystem::path target_;     // behind symbolic links
  std::filesystem::path temporary_;  // empty where the target is written directly
  std::FILE* stream_ = nullptr;
};

// The whole file in one call.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace augicp
