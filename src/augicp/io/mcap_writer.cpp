// SPDX-License-Identifier: MIT
#include "augicp/io/mcap_writer.h"

#include <algorithm>
#include <stdexcept>

#include "augicp/io/cdr_writer.h"
#include "augicp/io/mcap_format.h"

namespace augicp {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{4} << 20;
constexpr std::uint32_t kNoChecksum = 0;

// The content of a record.
class Content {
 public:
  template <typename T>
  Content& number(T value) {
    append_number(bytes_, value);
    return *this;
  }
  Content& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    return raw(text);
  }
  Content& raw(std::string_view bytes) {
    bytes_.append(bytes);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

  std::string record(mcap::Opcode opcode) const {
    std::string record(1, static_cast<char>(opcode));
    append_number(record, std::uint64_t{bytes_.size()});
    return record += bytes_;
  }

 private:
  std::string bytes_;
};

}  // namespace

void McapWriter::Stamps::add(std::uint64_t stamp_ns) {
  first = count == 0 ? stamp_ns : std::min(first, stamp_ns);
  last = std::max(last, stamp_ns);
  ++count;
}

McapWriter::McapWriter(const std::filesystem::path& path) : file_(path) {
  put(mcap::kMagic);
  put(Content().text("ros2").text("augicp").record(mcap::kHeader));
}

std::uint16_t McapWriter::add_topic(std::string_view topic, const RosType& type) {
  auto schema = schema_of_.find(type.name);
  if (schema == schema_of_.end()) {
    const auto id = static_cast<std::uint16_t>(schema_of_.size() + 1);  // 0 is none
    schema = schema_of_.emplace(type.name, id).first;
    const std::string record =
        Content().number(id).text(type.name).text("ros2msg").text(type.definition).record(mcap::kSchema);
    schemas_ += record;
    chunk_ += record;
  }
  const auto id = static_cast<std::uint16_t>(num_messages_.size());
  num_messages_[id] = 0;
  const std::string record = Content()
                                 .number(id)
                                 .number(schema->second)
                                 .text(topic)
                                 .text("cdr")
                                 .number(std::uint32_t{0})
                                 .record(mcap::kChannel);
  channels_ += record;
  chunk_ += record;
  return id;
}

void McapWriter::write(std::uint16_t topic, std::int64_t stamp_ns, std::string_view message) {
  if (stamp_ns < 0) throw std::invalid_argument("stamp: MCAP has none before 1970");
  const auto stamp = static_cast<std::uint64_t>(stamp_ns);
  entries_[topic].emplace_back(stamp, chunk_.size());
  const auto number = static_cast<std::uint32_t>(num_messages_.at(topic)++);
  chunk_ += Content().number(topic).number(number).number(stamp).number(stamp).raw(message).record(mcap::kMessage);
  in_chunk_.add(stamp);
  all_.add(stamp);
  if (chunk_.size() >= kChunkBytes) put_chunk();
}

void McapWriter::commit() {
  if (!chunk_.empty()) put_chunk();
  put(Content().number(kNoChecksum).record(mcap::kDataEnd));
  put_summary();
  put(mcap::kMagic);
  file_.commit();
}

void McapWriter::put(std::string_view bytes) {
  file_.write(bytes);
  offset_ += bytes.size();
}

void McapWriter::put_chunk() {
  const std::uint64_t begin = offset_, size = chunk_.size();
  put(Content()
          .number(in_chunk_.first)
          .number(in_chunk_.last)
          .number(size)
          .number(kNoChecksum)
          .text("")
          .number(size)
          .raw(chunk_)
          .record(mcap::kChunk));
  const std::uint64_t end = offset_;
  std::map<std::uint16_t, std::uint64_t> indices;
  for (const auto& [topic, entries] : entries_) {
    indices[topic] = offset_;
    Content index;
    index.number(topic).number(static_cast<std::uint32_t>(16 * entries.size()));
    for (const auto& [stamp, place] : entries) index.number(stamp).number(place);
    put(index.record(mcap::kMessageIndex));
  }
  put_chunk_index(begin, end - begin, indices, offset_ - end);
  ++num_chunks_;
  chunk_.clear();
  entries_.clear();
  in_chunk_ = {};
}

void McapWriter::put_chunk_index(std::uint64_t begin, std::uint64_t length,
                                 const std::map<std::uint16_t, std::uint64_t>& indices, std::uint64_t indices_length) {
  Content index;
  index.number(in_chunk_.first).number(in_chunk_.last).number(begin).number(length);
  index.number(static_cast<std::uint32_t>(10 * indices.size()));
  for (const auto& [topic, place] : indices) index.number(topic).number(place);
  index.number(indices_length).text("").number(std::uint64_t{chunk_.size()}).number(std::uint64_t{chunk_.size()});
  chunk_indices_ += index.record(mcap::kChunkIndex);
}

std::string McapWriter::statistics() const {
  Content content;
  content.number(all_.count).number(static_cast<std::uint16_t>(schema_of_.size()));
  content.number(static_cast<std::uint32_t>(num_messages_.size()));
  content.number(std::uint32_t{0}).number(std::uint32_t{0}).number(num_chunks_);  // attachments, metadata, chunks
  content.number(all_.first).number(all_.last).number(static_cast<std::uint32_t>(10 * num_messages_.size()));
  for (const auto& [topic, count] : num_messages_) content.number(topic).number(count);
  return content.record(mcap::kStatistics);
}

void McapWriter::put_summary() {
  const std::uint64_t begin = offset_;
  std::string offsets;
  const std::pair<mcap::Opcode, std::string> groups[] = {{mcap::kSchema, schemas_},
                                                         {mcap::kChannel, channels_},
                                                         {mcap::kStatistics, statistics()},
                                                         {mcap::kChunkIndex, chunk_indices_}};
  for (const auto& [opcode, records] : groups) {
    if (records.empty()) continue;
    offsets += Content()
                   .number(static_cast<std::uint8_t>(opcode))
                   .number(offset_)
                   .number(std::uint64_t{records.size()})
                   .record(mcap::kSummaryOffset);
    put(records);
  }
  const std::uint64_t place_of_offsets = offset_;
  put(offsets);
  put(Content().number(begin).number(place_of_offsets).number(kNoChecksum).record(mcap::kFooter));
}

}  // namespace augicp
