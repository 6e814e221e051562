// SPDX-License-Identifier: MIT
// Recordings for tests: writers that share nothing with the readers.
#pragma once

#include <string>
#include <vector>

#include "augicp/io/reader_testing.h"

namespace augicp::testing {

inline std::string u32(std::uint32_t value) { return packed<std::uint32_t>({value}); }
inline std::string text_of(const std::string& text) { return u32(static_cast<std::uint32_t>(text.size())) + text; }

// Bytes of a message; CDR aligns numbers to their size, from behind its four bytes, and ends its texts with a zero.
class MessageWriter {
 public:
  explicit MessageWriter(bool is_cdr) : is_cdr_(is_cdr), bytes_(is_cdr ? std::string("\0\1\0\0", 4) : "") {}

  void number(std::uint32_t value) {
    while (is_cdr_ && bytes_.size() % 4 != 0) bytes_ += '\0';
    bytes_ += u32(value);
  }
  void byte(int value) { bytes_ += static_cast<char>(value); }
  void text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size() + (is_cdr_ ? 1 : 0)));
    bytes_ += is_cdr_ ? text + '\0' : text;
  }
  void raw(const std::string& bytes) { bytes_ += bytes; }
  const std::string& bytes() const { return bytes_; }

 private:
  bool is_cdr_;
  std::string bytes_;
};

// Three points x y z ring t, of which one is not finite, in rows with a gap behind each. Stamp: 7 s + 8 ns.
inline std::string point_cloud2(bool is_cdr, std::uint32_t point_step = 20) {
  MessageWriter message(is_cdr);
  if (!is_cdr) message.number(99);
  message.number(7);
  message.number(8);
  message.text("lidar");
  message.number(1);
  message.number(3);
  const std::pair<const char*, std::array<int, 2>> fields[] = {
      {"x", {0, 7}}, {"y", {4, 7}}, {"z", {8, 7}}, {"ring", {12, 4}}, {"t", {16, 6}}};
  message.number(5);
  for (const auto& [name, place] : fields) {
    message.text(name);
    message.number(static_cast<std::uint32_t>(place[0]));
    message.byte(place[1]);
    message.number(1);
  }
  message.byte(0);
  message.number(point_step);
  message.number(3 * point_step + 4);
  std::string data;
  for (std::uint32_t i = 0; i < 3; ++i) {
    data += packed<float>({i == 1 ? NAN : float(i), 2, -3}) +
            packed<std::uint16_t>({static_cast<std::uint16_t>(10 + i), 0});
    data += u32(1000 * i) + std::string(point_step - 20, '\0');
  }
  message.number(static_cast<std::uint32_t>(data.size()));
  message.raw(data);
  message.byte(1);
  return message.bytes();
}

inline std::string mcap_record(int opcode, const std::string& content) {
  return static_cast<char>(opcode) + packed<std::uint64_t>({content.size()}) + content;
}

// Frames of lz4 and zstd with one block as it is, not compressed, of less than 128 KiB.
inline std::string lz4_frame(const std::string& content) {
  const auto size = static_cast<std::uint32_t>(content.size());
  return "\x04\x22\x4d\x18\x60\x40\x82" + u32(size | 0x80000000u) + content + u32(0);
}
inline std::string zstd_frame(const std::string& content) {
  const auto size = static_cast<std::uint32_t>(content.size());
  return std::string("\x28\xb5\x2f\xfd\0\x58", 6) + u32(size << 3 | 1u).substr(0, 3) + content;
}
inline std::string compressed(const std::string& compression, const std::string& content) {
  return compression == "lz4" ? lz4_frame(content) : compression == "zstd" ? zstd_frame(content) : content;
}

// Two clouds and another message, some of them in a chunk.
inline std::string mcap(const std::string& compression = "") {
  const std::string magic("\x89MCAP0\r\n", 8), cloud = point_cloud2(true);
  const auto message = [](std::uint16_t channel, std::uint64_t stamp, const std::string& data) {
    return mcap_record(5, packed<std::uint16_t>({channel}) + u32(0) + packed<std::uint64_t>({stamp, stamp}) + data);
  };
  const auto channel = [](std::uint16_t id, std::uint16_t schema, const std::string& topic) {
    return mcap_record(4, packed<std::uint16_t>({id, schema}) + text_of(topic) + text_of("cdr") + u32(0));
  };
  const auto schema = [](std::uint16_t id, const std::string& name) {
    return mcap_record(3, packed<std::uint16_t>({id}) + text_of(name) + text_of("ros2msg") + text_of("uint8 a"));
  };
  const std::string chunk = channel(2, 2, "/other") + message(2, 5, "ab") + message(1, 6, cloud);
  const std::string stored = compressed(compression, chunk);
  return magic + mcap_record(1, text_of("ros2") + text_of("test")) + schema(1, "sensor_msgs/msg/PointCloud2") +
         schema(2, "a/msg/B") + channel(1, 1, "/points") + message(1, 4, cloud) +
         mcap_record(6, packed<std::uint64_t>({5, 6, chunk.size()}) + u32(0) + text_of(compression) +
                            packed<std::uint64_t>({stored.size()}) + stored) +
         mcap_record(15, u32(0)) + mcap_record(2, std::string(20, '\0')) + magic;
}

inline std::string ros1_header(const std::vector<std::pair<std::string, std::string>>& fields) {
  std::string bytes;
  for (const auto& [name, value] : fields) bytes += text_of(name + "=" + value);
  return text_of(bytes);
}

// The same clouds as a bag of ROS 1.
inline std::string rosbag1(const std::string& compression = "none") {
  const auto op = [](int code) {
    return std::pair<std::string, std::string>{"op", std::string(1, static_cast<char>(code))};
  };
  const auto connection = [&](std::uint32_t id, const std::string& topic, const std::string& type) {
    return ros1_header({op(7), {"conn", u32(id)}, {"topic", topic}}) +
           ros1_header({{"topic", topic}, {"type", type}, {"md5sum", "x"}});
  };
  const auto message = [&](std::uint32_t id, std::uint32_t nanoseconds, const std::string& data) {
    return ros1_header({op(2), {"conn", u32(id)}, {"time", u32(0) + u32(nanoseconds)}}) + text_of(data);
  };
  const std::string chunk = connection(1, "/points", "sensor_msgs/PointCloud2") + message(1, 4, point_cloud2(false)) +
                            connection(2, "/other", "a/B") + message(2, 5, "ab") + message(1, 6, point_cloud2(false));
  const std::string index = packed<std::uint64_t>({4096 + 13});
  return "#ROSBAG V2.0\n" +
         ros1_header({op(3), {"index_pos", index}, {"conn_count", u32(2)}, {"chunk_count", u32(1)}}) +
         text_of(std::string(50, ' ')) +
         ros1_header({op(5), {"compression", compression}, {"size", u32(static_cast<std::uint32_t>(chunk.size()))}}) +
         text_of(compressed(compression, chunk)) +
         ros1_header({op(4), {"ver", u32(1)}, {"conn", u32(1)}, {"count", u32(0)}}) + text_of("");
}

}  // namespace augicp::testing
