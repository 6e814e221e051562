// SPDX-License-Identifier: MIT
// MCAP files, from their front. Source: https://mcap.dev/spec
#include <map>

#include "augicp/io/bag_parts.h"
#include "augicp/io/decompress.h"
#include "augicp/io/format.h"
#include "augicp/io/mcap_format.h"

namespace augicp {
namespace {

struct Channel {
  std::string topic, type;
  MessageForm form = MessageForm::Cdr;
};

class McapReader : public MessageSource {
 public:
  explicit McapReader(const std::filesystem::path& path) : path_(path), file_(path) {
    if (file_.num_left() < mcap::kMagic.size() || file_.read(mcap::kMagic.size()) != mcap::kMagic)
      throw io_error_at_byte(path_, 0, "expected the mark of an MCAP file");
  }

  std::optional<BagMessage> next() override {
    while (!is_at_end_) {
      const auto message = in_chunk_.at_end() ? from_file() : from_chunk();
      if (message) return message;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kHead = 9;

  std::optional<BagMessage> from_file() {
    const std::string head = file_.read(kHead);
    ByteReader reader(path_, head);
    const auto opcode = static_cast<std::uint8_t>(reader.take_number(1));
    const std::uint64_t length = reader.take_number(8);
    is_at_end_ = opcode == mcap::kDataEnd || opcode == mcap::kFooter;
    if (is_at_end_) return std::nullopt;
    if (opcode == mcap::kSchema || opcode == mcap::kChannel || opcode == mcap::kMessage || opcode == mcap::kChunk) {
      record_ = file_.read(length);
      return take_record(opcode, record_);
    }
    file_.skip(length);
    return std::nullopt;
  }

  std::optional<BagMessage> from_chunk() {
    const auto opcode = static_cast<std::uint8_t>(in_chunk_.take_number(1));
    const std::string_view content = in_chunk_.take(in_chunk_.take_number(8));
    if (opcode == mcap::kChunk) throw io_error(path_, "expected no chunk within another");
    return take_record(opcode, content);
  }

  std::optional<BagMessage> take_record(std::uint8_t opcode, std::string_view content) {
    ByteReader reader(path_, content);
    if (opcode == mcap::kSchema) add_schema(reader);
    if (opcode == mcap::kChannel) add_channel(reader);
    if (opcode == mcap::kChunk) open_chunk(reader);
    return opcode == mcap::kMessage ? std::optional(message_in(reader)) : std::nullopt;
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

  BagMessage message_in(ByteReader& reader) const {
    const auto channel = channels_.find(reader.take_number(2));
    if (channel == channels_.end()) throw io_error(path_, "expected a channel before its messages");
    reader.take_number(4);  // a running number
    const auto stamp_ns = static_cast<std::int64_t>(reader.take_number(8));
    reader.take_number(8);  // when it was published
    const Channel& from = channel->second;
    return {from.topic, from.type, from.form, stamp_ns, reader.rest()};
  }

  void open_chunk(ByteReader& reader) {
    reader.take_number(8);  // the first stamp
    reader.take_number(8);  // the last one
    const std::uint64_t uncompressed = reader.take_number(8);
    reader.take_number(4);  // checksum
    const std::string compression(reader.take_text());
    const std::string_view records = reader.take(reader.take_number(8));
    if (!can_decompress(compression))
      throw io_error(path_, fmt::format("its chunks are compressed ({}), which this build lacks; first run "
                                        "'mcap compress --compression none IN -o OUT'",
                                        in_quotes(compression)));
    chunk_ = decompressed(path_, compression, records, uncompressed);
    in_chunk_ = ByteReader(path_, chunk_);
  }

  const std::filesystem::path path_;
  FileStream file_;
  std::map<std::uint64_t, std::string> schemas_;
  std::map<std::uint64_t, Channel> channels_;
  std::string record_, chunk_;
  ByteReader in_chunk_{path_, {}};
  bool is_at_end_ = false;
};

}  // namespace

std::unique_ptr<MessageSource> open_mcap(const std::filesystem::path& path) {
  return std::make_unique<McapReader>(path);
}

}  // namespace augicp
