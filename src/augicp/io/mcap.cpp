// SPDX-License-Identifier: MIT
// MCAP files, from their front. Source: https://mcap.dev/spec
#include <map>

#include "augicp/io/bag_parts.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::string_view kMagic = "\x89MCAP0\r\n";

enum Opcode : std::uint8_t { kFooter = 2, kSchema = 3, kChannel = 4, kMessage = 5, kChunk = 6, kDataEnd = 15 };

struct Channel {
  std::string topic, type;
  MessageForm form = MessageForm::Cdr;
};

class McapReader {
 public:
  McapReader(const std::filesystem::path& path, const MessageVisitor& visit)
      : path_(path), visit_(visit), file_(path) {}

  void read() {
    if (file_.num_left() < kMagic.size() || file_.read(kMagic.size()) != kMagic)
      throw io_error_at_byte(path_, 0, "expected the mark of an MCAP file");
    while (goes_on_) {
      const std::string head = file_.read(kHead);
      ByteReader reader(path_, head);
      const auto opcode = static_cast<std::uint8_t>(reader.take_number(1));
      const std::uint64_t length = reader.take_number(8);
      if (opcode == kDataEnd || opcode == kFooter) return;
      if (opcode == kSchema || opcode == kChannel || opcode == kMessage || opcode == kChunk) {
        take_record(opcode, file_.read(length));
      } else {
        file_.skip(length);
      }
    }
  }

 private:
  static constexpr std::size_t kHead = 9;

  void take_record(std::uint8_t opcode, std::string_view content) {
    ByteReader reader(path_, content);
    if (opcode == kSchema) add_schema(reader);
    if (opcode == kChannel) add_channel(reader);
    if (opcode == kMessage) show_message(reader);
    if (opcode == kChunk) take_chunk(reader);
  }

  void add_schema(ByteReader& reader) {
    const std::uint64_t id = reader.take_number(2);
    schemas_[id] = plain_type(reader.take_text());
  }

  void add_channel(ByteReader& reader) {
    const std::uint64_t id = reader.take_number(2), schema = reader.take_number(2);
    Channel channel;
    channel.topic = reader.take_text();
    channel.form = reader.take_text() == "ros1" ? MessageForm::Ros1 : MessageForm::Cdr;
    if (const auto found = schemas_.find(schema); found != schemas_.end()) channel.type = found->second;
    channels_[id] = std::move(channel);
  }

  void show_message(ByteReader& reader) {
    const auto channel = channels_.find(reader.take_number(2));
    if (channel == channels_.end()) throw io_error(path_, "expected a channel before its messages");
    reader.take_number(4);  // a running number
    const auto stamp_ns = static_cast<std::int64_t>(reader.take_number(8));
    reader.take_number(8);  // when it was published
    const Channel& from = channel->second;
    goes_on_ = goes_on_ && visit_({from.topic, from.type, from.form, stamp_ns, reader.rest()});
  }

  void take_chunk(ByteReader& reader) {
    reader.take_number(8);  // the first stamp
    reader.take_number(8);  // the last one
    const std::uint64_t uncompressed = reader.take_number(8);
    reader.take_number(4);  // checksum
    const std::string_view compression = reader.take_text();
    if (!compression.empty())
      throw io_error(path_, fmt::format("its chunks are compressed ({}), which this reader lacks; first run "
                                        "'mcap compress --compression none IN -o OUT'",
                                        compression));
    const std::string_view records = reader.take(reader.take_number(8));
    if (records.size() != uncompressed)
      throw io_error(path_, fmt::format("expected a chunk of {} bytes, found {}", uncompressed, records.size()));
    ByteReader inner(path_, records);
    while (!inner.at_end() && goes_on_) {
      const auto opcode = static_cast<std::uint8_t>(inner.take_number(1));
      const std::string_view content = inner.take(inner.take_number(8));
      if (opcode == kChunk) throw io_error(path_, "expected no chunk within another");
      take_record(opcode, content);
    }
  }

  const std::filesystem::path& path_;
  const MessageVisitor& visit_;
  FileStream file_;
  std::map<std::uint64_t, std::string> schemas_;
  std::map<std::uint64_t, Channel> channels_;
  bool goes_on_ = true;
};

}  // namespace

void visit_mcap(const std::filesystem::path& path, const MessageVisitor& visit) { McapReader(path, visit).read(); }

}  // namespace augicp
