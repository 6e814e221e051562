// SPDX-License-Identifier: MIT
// Bags of ROS 1, version 2.0, from their front. Source: http://wiki.ros.org/Bags/Format/2.0
#include <map>
#include <optional>

#include "augicp/io/bag_parts.h"
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

class RosbagReader {
 public:
  RosbagReader(const std::filesystem::path& path, const MessageVisitor& visit)
      : path_(path), visit_(visit), file_(path) {}

  void read() {
    if (file_.num_left() < kMagic.size() || file_.read(kMagic.size()) != kMagic)
      throw io_error_at_byte(path_, 0, "expected '#ROSBAG V2.0', the mark of a bag");
    while (goes_on_ && file_.num_left() > 0) {
      const std::string header = take_part(), data = take_part();
      take_record(header, data, /*in_chunk=*/false);
    }
  }

 private:
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

  void take_record(std::string_view header_bytes, std::string_view data, bool in_chunk) {
    const Header header = fields_of(header_bytes);
    const std::uint64_t operation = number(header, "op", 1);
    if (operation == kBagHeader && number(header, "index_pos", 8) == 0)
      throw io_error(path_, "the recording did not end, so the bag has no index; run 'rosbag reindex'");
    if (operation == kConnection) add_connection(header, data);
    if (operation == kMessageData) show_message(header, data);
    if (operation != kChunk) return;
    if (in_chunk) throw io_error(path_, "expected no chunk within another");
    take_chunk(header, data);
  }

  void add_connection(const Header& header, std::string_view data) {
    const Header inner = fields_of(data);
    connections_[number(header, "conn", 4)] = {std::string(value(header, "topic")), plain_type(value(inner, "type"))};
  }

  void show_message(const Header& header, std::string_view data) {
    constexpr std::int64_t kNanoseconds = 1'000'000'000;
    const auto connection = connections_.find(number(header, "conn", 4));
    if (connection == connections_.end()) throw io_error(path_, "expected a connection before its messages");
    ByteReader time(path_, value(header, "time"));
    const auto seconds = static_cast<std::int64_t>(time.take_number(4));
    const std::int64_t stamp_ns = seconds * kNanoseconds + static_cast<std::int64_t>(time.take_number(4));
    const Connection& from = connection->second;
    goes_on_ = goes_on_ && visit_({from.topic, from.type, MessageForm::Ros1, stamp_ns, data});
  }

  void take_chunk(const Header& header, std::string_view data) {
    if (const std::string_view compression = value(header, "compression"); compression != "none")
      throw io_error(path_,
                     fmt::format("its chunks are compressed ({}), which this reader lacks; run 'rosbag decompress'",
                                 in_quotes(compression)));
    if (data.size() != number(header, "size", 4)) throw io_error(path_, "expected a chunk of its stated size");
    ByteReader reader(path_, data);
    while (!reader.at_end() && goes_on_) {
      const std::string_view inner_header = reader.take_text(), inner_data = reader.take_text();
      take_record(inner_header, inner_data, /*in_chunk=*/true);
    }
  }

  const std::filesystem::path& path_;
  const MessageVisitor& visit_;
  FileStream file_;
  std::map<std::uint64_t, Connection> connections_;
  bool goes_on_ = true;
};

}  // namespace

void visit_rosbag1(const std::filesystem::path& path, const MessageVisitor& visit) { RosbagReader(path, visit).read(); }

}  // namespace augicp
