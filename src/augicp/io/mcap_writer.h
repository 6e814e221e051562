// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "augicp/io/atomic_file.h"
#include "augicp/io/ros_messages.h"

namespace augicp {

// Writes a recording of ROS 2 as MCAP, whole or absent: plain chunks with indices, and a summary, so that programs can
// jump within it. Thread safety: none. Source: https://mcap.dev/spec
class McapWriter {
 public:
  // Throws IoError, as all others do.
  explicit McapWriter(const std::filesystem::path& path);

  // The number of a topic, for write().
  std::uint16_t add_topic(std::string_view topic, const RosType& type);

  // A message in CDR. Stamps may have any order. Throws std::invalid_argument for a stamp before 1970.
  void write(std::uint16_t topic, std::int64_t stamp_ns, std::string_view message);

  // Without it nothing remains.
  void commit();

 private:
  struct Stamps {
    std::uint64_t first = 0, last = 0;
    std::uint64_t count = 0;
    void add(std::uint64_t stamp_ns);
  };
  // The places of the messages of a topic in the chunk, with their stamps.
  using Entries = std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>>;

  void put(std::string_view bytes);
  void put_chunk();
  void put_chunk_index(std::uint64_t begin, std::uint64_t length, const std::map<std::uint16_t, std::uint64_t>& indices,
                       std::uint64_t indices_length);
  void put_summary();
  std::string statistics() const;

  AtomicFile file_;
  std::uint64_t offset_ = 0;
  std::string schemas_, channels_, chunk_, chunk_indices_;  // records
  std::map<std::string, std::uint16_t, std::less<>> schema_of_;
  std::map<std::uint16_t, std::uint64_t> num_messages_;  // by topic
  Entries entries_;
  Stamps in_chunk_, all_;
  std::uint32_t num_chunks_ = 0;
};

}  // namespace augicp
