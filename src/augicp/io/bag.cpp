// SPDX-License-Identifier: MIT
#include "augicp/io/bag.h"

#include <algorithm>
#include <cerrno>
#include <map>
#include <system_error>

#include "augicp/io/bag_parts.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

bool is_bag_file(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".bag" || extension == ".mcap" || extension == ".db3";
}

// The parts of a folder of rosbag2, in the order of their names.
std::vector<fs::path> parts_of(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_bag_file(entry->path())) parts.push_back(entry->path());
  if (error) throw io_error(folder, "cannot be listed: " + error.message());
  std::sort(parts.begin(), parts.end());
  return parts;
}

void visit_file(const fs::path& path, const MessageVisitor& visit) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".bag") return visit_rosbag1(path, visit);
  if (extension == ".mcap") return visit_mcap(path, visit);
  if (extension == ".db3") return visit_sqlite(path, visit);
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
    throw io_error(path_, fmt::format("expected {} bytes, a record has {} more", count, rest_.size()));
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

void visit_messages(const fs::path& bag, const MessageVisitor& visit) {
  std::error_code ignored;
  if (!fs::is_directory(bag, ignored)) return visit_file(bag, visit);
  bool goes_on = true;
  for (const fs::path& part : parts_of(bag))
    if (goes_on) visit_file(part, [&](const BagMessage& message) { return goes_on = visit(message); });
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
