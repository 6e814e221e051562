// SPDX-License-Identifier: MIT
// Bags of ROS 1, version 2.0, from their front. Source: http://wiki.ros.org/Bags/Format/2.0
#include <map>
#include <optional>

#include "augicp/io/bag_parts.h"
#include "augicp/io/decompress.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";

enum Operation : std::uint8_t { kMessageData = 2, kBagHeader = 3, kChunk = 5, kConnection = 7 };

// A header: fields "name=value", each behind its length.
using Header = std::map<std::string_view, std::string_view, std::less<>>;

struct Connection {
  std::string topic, type;
};

class RosbagReader : public MessageSource {
 public:
  explicit RosbagReader(const std::filesystem::path& path) : path_(path), file_(path) {
    if (file_.num_left() < kMagic.size() || file_.read(kMagic.size()) != kMagic)
      throw io_error_at_byte(path_, 0, "expected '#ROSBAG V2.0', the mark of a bag");
  }

  std::optional<BagMessage> next() override {
    while (!in_chunk_.at_end() || file_.num_left() > 0) {
      const auto message = in_chunk_.at_end() ? from_file() : from_chunk();
      if (message) return message;
    }
    return std::nullopt;
  }

 private:
  std::optional<BagMessage> from_file() {
    const std::string header = take_part();
    data_ = take_part();
    return take_record(header, data_, /*in_chunk=*/false);
  }

  std::optional<BagMessage> from_chunk() {
    const std::string_view header = in_chunk_.take_text(), data = in_chunk_.take_text();
    return take_record(header, data, /*in_chunk=*/true);
  }

  std::string take_part() {
    const std::string length = file_.read(4);
    return file_.read(ByteReader(path_, length).take_number(4));
  }

  Header fields_of(std::string_view bytes) const {
    Header header;
    ByteReader reader(path_, bytes);
    while (!reader.at_end()) {
      const std::string_view field = reader.take_text();
      const std::size_t at = field.find('=');
      if (at == std::string_view::npos) throw io_error(path_, "expected name=value in a header");
      header.emplace(field.substr(0, at), field.substr(at + 1));
    }
    return header;
  }

  std::string_view value(const Header& header, std::string_view name) const {
    const auto found = header.find(name);
    if (found == header.end()) throw io_error(path_, fmt::format("expected '{}' in a header", name));
    return found->second;
  }

  std::uint64_t number(const Header& header, std::string_view name, std::size_t num_bytes) const {
    return ByteReader(path_, value(header, name)).take_number(num_bytes);
  }

  std::optional<BagMessage> take_record(std::string_view header_bytes, std::string_view data, bool in_chunk) {
    const Header header = fields_of(header_bytes);
    const std::uint64_t operation = number(header, "op", 1);
    if (operation == kBagHeader && number(header, "index_pos", 8) == 0)
      throw io_error(path_, "the recording did not end, so the bag has no index; run 'rosbag reindex'");
    if (operation == kConnection) add_connection(header, data);
    if (operation == kMessageData) return message_in(header, data);
    if (operation != kChunk) return std::nullopt;
    if (in_chunk) throw io_error(path_, "expected no chunk within another");
    open_chunk(header, data);
    return std::nullopt;
  }

  void add_connection(const Header& header, std::string_view data) {
    const Header inner = fields_of(data);
    connections_[number(header, "conn", 4)] = {std::string(value(header, "topic")), plain_type(value(inner, "type"))};
  }

  BagMessage message_in(const Header& header, std::string_view data) const {
    constexpr std::int64_t kNanoseconds = 1'000'000'000;
    const auto connection = connections_.find(number(header, "conn", 4));
    if (connection == connections_.end()) throw io_error(path_, "expected a connection before its messages");
    ByteReader time(path_, value(header, "time"));
    const auto seconds = static_cast<std::int64_t>(time.take_number(4));
    const std::int64_t stamp_ns = seconds * kNanoseconds + static_cast<std::int64_t>(time.take_number(4));
    const Connection& from = connection->second;
    return {from.topic, from.type, MessageForm::Ros1, stamp_ns, data};
  }

  void open_chunk(const Header& header, std::string_view data) {
    const std::string_view stated = value(header, "compression");
    const std::string compression(stated == "none" ? "" : stated);
    if (!can_decompress(compression))
      throw io_error(path_,
                     fmt::format("its chunks are compressed ({}), which this build lacks; run 'rosbag decompress'",
                                 in_quotes(compression)));
    chunk_ = decompressed(path_, compression, data, number(header, "size", 4));
    in_chunk_ = ByteReader(path_, chunk_);
  }

  const std::filesystem::path path_;
  FileStream file_;
  std::map<std::uint64_t, Connection> connections_;
  std::string data_, chunk_;
  ByteReader in_chunk_{path_, {}};
};

}  // namespace

std::unique_ptr<MessageSource> open_rosbag1(const std::filesystem::path& path) {
  return std::make_unique<RosbagReader>(path);
}

}  // namespace augicp
