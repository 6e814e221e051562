// SPDX-License-Identifier: MIT
#include "augicp/io/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

// Follows a link, so that it remains a link when its file is replaced.
std::filesystem::path behind_links(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target;
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path), target_(behind_links(path)) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(target_, error);
  if (std::filesystem::is_directory(status)) throw io_error(path_, "expected a file to write, found a directory");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    stream_ = std::fopen(target_.c_str(), "wb");
    if (stream_ == nullptr) fail("cannot be opened for writing");
    return;
  }
  constexpr int kMaxAttempts = 1000;  // other writers of this process may use some names
  for (int attempt = 0; stream_ == nullptr && attempt < kMaxAttempts; ++attempt) {
    // Not derived from the file's name, which may have the maximal length.
    temporary_ = target_.parent_path() / fmt::format(".augicp-{}-{}.partial", ::getpid(), attempt);
    stream_ = std::fopen(temporary_.c_str(), "wbx");
    if (stream_ == nullptr && errno != EEXIST) break;
  }
  if (stream_ == nullptr) fail("cannot be written");
}

AtomicFile::~AtomicFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail("cannot be written");
}

void AtomicFile::commit() {
  // Some file systems report a full disk only on close.
  if (std::fclose(std::exchange(stream_, nullptr)) != 0) fail("cannot be written");
  if (temporary_.empty()) return;
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) throw io_error(path_, "cannot be written: " + error.message());
  temporary_.clear();
}

void AtomicFile::fail(std::string_view what) const {
  throw io_error(path_, fmt::format("{}: {}", what, std::generic_category().message(errno)));
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace augicp
