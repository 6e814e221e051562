// SPDX-License-Identifier: MIT
#include "augicp/io/scan_sequence.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "augicp/core/check.h"
#include "augicp/io/bag.h"
#include "augicp/io/bag_message_name.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/natural_order.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEndings[] = {".bin", ".pcd", ".ply"};

// Every number with a decimal point or more digits is a stamp in some unit, or no number of a frame.
constexpr double kMaxNumber = 1e9;

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

std::vector<fs::path> scans_in(const fs::path& folder) {
  std::vector<std::vector<fs::path>> of_kind(std::size(kEndings));
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    for (std::size_t kind = 0; kind < std::size(kEndings); ++kind)
      if (ending_of(entry->path()) == kEndings[kind]) of_kind[kind].push_back(entry->path());
  if (error) throw io_error(folder, "cannot be listed: " + error.message());
  std::vector<fs::path> most = *std::max_element(of_kind.begin(), of_kind.end(),
                                                 [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::sort(most.begin(), most.end(), [](const fs::path& a, const fs::path& b) {
    return naturally_before(a.filename().string(), b.filename().string());
  });
  return most;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// Seconds: a number, or the last field "hours:minutes:seconds" of a date; days count through the date's last two
// digits.
std::optional<double> stamp_in(std::string_view line) {
  if (line.find(':') == std::string_view::npos) return parse_double(line);
  std::string_view rest = line;
  const auto date = next_field(rest);
  if (!date || date->size() < 2) return std::nullopt;
  double stamp_s = parse_double(date->substr(date->size() - 2)).value_or(0.0);
  for (const int per_one : {24, 60, 60}) {
    const auto part = next_field(rest, ':');
    const auto value = part ? parse_double(*part) : std::nullopt;
    if (!value) return std::nullopt;
    stamp_s = stamp_s * per_one + *value;
  }
  return stamp_s;
}

std::vector<double> read_stamps(const fs::path& path, std::size_t num_scans) {
  const FileBytes file = read_bytes(path);
  TextLines lines(without_bom(file.bytes));
  std::vector<double> stamps;
  while (const auto line = lines.next_not_blank()) {
    const std::string_view text = trimmed(*line);
    if (text.front() == '#') continue;
    const auto stamp_s = stamp_in(text);
    if (!stamp_s || !std::isfinite(*stamp_s))
      throw io_error_at_line(path, lines.line(), "expected a time in seconds, found " + in_quotes(text));
    if (!stamps.empty() && *stamp_s <= stamps.back())
      throw io_error_at_line(path, lines.line(), "expected a time after the one before, found " + in_quotes(text));
    stamps.push_back(*stamp_s);
  }
  if (stamps.size() != num_scans)
    throw io_error(path, fmt::format("expected {} times, one a scan, found {}", num_scans, stamps.size()));
  return stamps;
}

std::optional<fs::path> stamps_file(const fs::path& folder, const fs::path& scan) {
  for (const fs::path& place : {scan.parent_path(), scan.parent_path().parent_path(), folder})
    for (const char* name : {"times.txt", "timestamps.txt"})
      if (std::error_code ignored; fs::is_regular_file(place / name, ignored)) return place / name;
  return std::nullopt;
}

// The numbers at the ends of the names; empty unless all have one and they ascend.
std::vector<double> numbers_of(const std::vector<fs::path>& scans) {
  std::vector<double> numbers;
  for (const fs::path& scan : scans) {
    const std::string stem = scan.stem().string();
    const std::size_t before = stem.find_last_not_of("0123456789");
    const auto number = parse_double(std::string_view(stem).substr(before == std::string::npos ? 0 : before + 1));
    if (!number || *number > kMaxNumber || (!numbers.empty() && *number <= numbers.back())) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

std::vector<fs::path> find_scans(const fs::path& folder) {
  for (const char* inner : {"velodyne", "velodyne_points/data"})
    if (is_folder(folder / inner))
      if (std::vector<fs::path> scans = scans_in(folder / inner); !scans.empty()) return scans;
  return scans_in(folder);
}

ScanSequence read_scan_sequence(const fs::path& folder, double scans_per_s) {
  require_positive("scans_per_s", scans_per_s);
  const std::vector<fs::path> scans = find_scans(folder);
  if (scans.empty()) throw io_error(folder, "expected scans (.bin, .pcd or .ply), found none");
  const std::string parent = scans.front().parent_path().filename().string();
  ScanSequence sequence;
  sequence.layout = scans.front().parent_path() == folder ? "scans"
                    : parent == "velodyne"                ? "KITTI odometry"
                                                          : "KITTI raw";
  const auto list = stamps_file(folder, scans.front());
  sequence.has_stamps = list.has_value();
  std::vector<double> stamps = list ? read_stamps(*list, scans.size()) : numbers_of(scans);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const double stamp_s = list ? stamps[i] : (stamps.empty() ? static_cast<double>(i) : stamps[i]) / scans_per_s;
    sequence.scans.push_back({stamp_s, scans[i]});
  }
  return sequence;
}

ScanSequence scans_of_topic(const fs::path& bag, const std::string& topic, const std::vector<double>& stamps_s) {
  ScanSequence sequence{true, "recording", {}, bag, topic};
  for (std::size_t i = 0; i < stamps_s.size(); ++i)
    sequence.scans.push_back({stamps_s[i], BagMessageName{bag, topic, i}.text()});
  return sequence;
}

ScanSequence read_scan_sequence(const fs::path& folder_or_bag, double scans_per_s, const std::string& topic) {
  if (!is_bag(folder_or_bag)) {
    if (!topic.empty()) throw io_error(folder_or_bag, "expected a recording that has " + topic);
    return read_scan_sequence(folder_or_bag, scans_per_s);
  }
  const std::string clouds[] = {kPointCloud2};
  const StampedTopic chosen = chosen_topic(folder_or_bag, topic, clouds);
  return scans_of_topic(folder_or_bag, chosen.name, chosen.stamps_s);
}

ScanReader::ScanReader(const ScanSequence& sequence) : scans_(sequence.scans) {
  if (!sequence.topic.empty()) topic_ = std::make_unique<TopicReader>(sequence.bag, sequence.topic);
}

ScanReader::~ScanReader() = default;

CloudFile ScanReader::read(std::size_t scan, const ReadOptions& options) {
  const fs::path& path = scans_[scan].path;
  if (!topic_) return read_cloud(path, options);
  return parse_cloud_message(path, topic_->message(scan), options);
}

}  // namespace augicp
