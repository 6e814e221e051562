// SPDX-License-Identifier: MIT
#include "augicp/io/bag.h"

#include <algorithm>
#include <cerrno>
#include <map>
#include <system_error>

#include "augicp/io/bag_parts.h"
#include "augicp/io/decompress.h"
#include "augicp/io/format.h"
#include "augicp/io/natural_order.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

bool is_bag_file(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".bag" || extension == ".mcap" || extension == ".db3";
}

// "rosbag2_0.db3.zstd"
bool is_compressed_bag_file(const fs::path& path) {
  return lower_case_extension(path) == ".zstd" && is_bag_file(path.stem());
}

// The parts of a folder of rosbag2, compressed ones too, in the natural order of their names.
std::vector<fs::path> parts_of(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_bag_file(entry->path()) || is_compressed_bag_file(entry->path())) parts.push_back(entry->path());
  if (error) throw io_error(folder, "cannot be listed: " + error.message());
  std::sort(parts.begin(), parts.end(), [](const fs::path& a, const fs::path& b) {
    return naturally_before(a.filename().string(), b.filename().string());
  });
  return parts;
}

// Without compressed parts that are there uncompressed too. Throws IoError for others: no part is left out.
std::vector<fs::path> readable_parts(const fs::path& folder) {
  std::vector<fs::path> parts = parts_of(folder);
  std::erase_if(parts, [](const fs::path& part) {
    std::error_code ignored;
    if (!is_compressed_bag_file(part)) return false;
    if (!fs::exists(fs::path(part).replace_extension(), ignored))
      throw io_error(part, "is compressed as a whole; first run 'zstd -d " + part.string() + "'");
    return true;
  });
  return parts;
}

std::vector<fs::path> files_of(const fs::path& bag) {
  std::error_code ignored;
  return fs::is_directory(bag, ignored) ? readable_parts(bag) : std::vector<fs::path>{bag};
}

std::unique_ptr<MessageSource> opened(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".bag") return open_rosbag1(path);
  if (extension == ".mcap") return open_mcap(path);
  if (extension == ".db3") return open_sqlite(path);
  throw io_error(path, "expected a recording: .bag, .db3 or .mcap, or a folder of rosbag2");
}

}  // namespace

std::string plain_type(std::string_view type) {
  const std::size_t at = type.find("/msg/");
  return at == std::string_view::npos ? std::string(type)
                                      : std::string(type.substr(0, at)) + std::string(type.substr(at + 4));
}

FileStream::FileStream(const fs::path& path) : path_(path), stream_(nullptr, &std::fclose) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw io_error(path, error ? error.message() : "expected a regular file");
  size_ = fs::file_size(path, error);
  if (error) throw io_error(path, error.message());
  stream_.reset(std::fopen(path.c_str(), "rb"));
  if (!stream_) throw io_error(path, "cannot be opened: " + std::generic_category().message(errno));
}

std::string FileStream::read(std::uint64_t count) {
  constexpr std::uint64_t kMostAtOnce = std::uint64_t{1} << 31;
  if (count > num_left())
    throw io_error_at_byte(path_, offset_, fmt::format("expected {} bytes, the file has {} more", count, num_left()));
  if (count > kMostAtOnce)
    throw io_error_at_byte(path_, offset_, fmt::format("expected less than 2 GiB, found {}", count));
  std::string bytes(count, '\0');
  if (std::fread(bytes.data(), 1, count, stream_.get()) != count)
    throw io_error_at_byte(path_, offset_, "cannot be read");
  offset_ += count;
  return bytes;
}

void FileStream::skip(std::uint64_t count) {
  if (count > num_left())
    throw io_error_at_byte(path_, offset_, fmt::format("expected {} bytes, the file has {} more", count, num_left()));
  if (std::fseek(stream_.get(), static_cast<long>(count), SEEK_CUR) != 0)
    throw io_error_at_byte(path_, offset_, "cannot be read");
  offset_ += count;
}

std::string_view ByteReader::take(std::uint64_t count) {
  if (count > rest_.size())
    throw io_error(*path_, fmt::format("expected {} bytes, a record has {} more", count, rest_.size()));
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::uint64_t ByteReader::take_number(std::size_t num_bytes) {
  const std::string_view bytes = take(num_bytes);
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < num_bytes; ++i) number |= std::uint64_t{static_cast<std::uint8_t>(bytes[i])} << (8 * i);
  return number;
}

bool is_bag(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return is_bag_file(path);
  return fs::exists(path / "metadata.yaml", ignored) && !parts_of(path).empty();
}

BagReader::BagReader(const fs::path& bag) : files_(files_of(bag)) {
  if (!files_.empty()) source_ = opened(files_[next_file_++]);
}

BagReader::~BagReader() = default;
BagReader::BagReader(BagReader&&) noexcept = default;
BagReader& BagReader::operator=(BagReader&&) noexcept = default;

std::optional<BagMessage> BagReader::next() {
  while (source_) {
    std::optional<BagMessage> message = source_->next();
    if (message && message->form == MessageForm::Cdr && begins_as_zstd(message->data)) {
      decompressed_ = decompressed(files_[next_file_ - 1], "zstd", message->data, std::nullopt);
      message->data = decompressed_;
    }
    if (message) return message;
    source_ = next_file_ < files_.size() ? opened(files_[next_file_++]) : nullptr;
  }
  return std::nullopt;
}

void visit_messages(const fs::path& bag, const std::function<bool(const BagMessage&)>& visit) {
  BagReader reader(bag);
  while (const auto message = reader.next())
    if (!visit(*message)) return;
}

std::vector<BagTopic> bag_topics(const fs::path& bag) {
  std::map<std::string, BagTopic, std::less<>> by_name;
  visit_messages(bag, [&](const BagMessage& message) {
    auto entry = by_name.find(message.topic);
    if (entry == by_name.end())
      entry = by_name.emplace(message.topic, BagTopic{std::string(message.topic), std::string(message.type)}).first;
    ++entry->second.num_messages;
    return true;
  });
  std::vector<BagTopic> topics;
  for (const auto& [name, topic] : by_name) topics.push_back(topic);
  return topics;
}

}  // namespace augicp
