// SPDX-License-Identifier: MIT
// What the readers of recordings share.
#pragma once

#include <cstdio>
#include <memory>

#include "augicp/io/bag.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The messages of one file, see BagReader.
class MessageSource {
 public:
  virtual ~MessageSource() = default;
  virtual std::optional<BagMessage> next() = 0;
};

std::unique_ptr<MessageSource> open_rosbag1(const std::filesystem::path& path);
std::unique_ptr<MessageSource> open_mcap(const std::filesystem::path& path);
std::unique_ptr<MessageSource> open_sqlite(const std::filesystem::path& path);

// "sensor_msgs/msg/PointCloud2" as "sensor_msgs/PointCloud2".
std::string plain_type(std::string_view type);

// A file that is read from its front, in parts. Thread safety: none.
class FileStream {
 public:
  explicit FileStream(const std::filesystem::path& path);

  std::uint64_t offset() const { return offset_; }
  std::uint64_t num_left() const { return size_ - offset_; }

  // The next bytes. Throws IoError if the file has fewer.
  std::string read(std::uint64_t count);
  void skip(std::uint64_t count);

 private:
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
  std::uint64_t size_ = 0, offset_ = 0;
};

// Takes little-endian numbers and texts from the front of bytes. Throws IoError with the path where they end too soon.
// REQUIRES: path and bytes outlive it.
class ByteReader {
 public:
  ByteReader(const std::filesystem::path& path, std::string_view bytes) : path_(&path), rest_(bytes) {}

  bool at_end() const { return rest_.empty(); }
  std::string_view take(std::uint64_t count);
  std::uint64_t take_number(std::size_t num_bytes);
  std::string_view take_text() { return take(take_number(4)); }
  std::string_view rest() const { return rest_; }

 private:
  const std::filesystem::path* path_;
  std::string_view rest_;
};

}  // namespace augicp
