// SPDX-License-Identifier: MIT
#include "augicp/io/scan_sequence.h"

#include <algorithm>

#include "augicp/core/check.h"
#include "augicp/io/bag.h"
#include "augicp/io/bag_message_name.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/scan_files.h"
#include "augicp/io/scan_stamps.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

std::string layout_of(const fs::path& folder, const fs::path& scan) {
  if (scan.parent_path() == folder) return "scans";
  return scan.parent_path().filename() == "velodyne" ? "KITTI odometry" : "KITTI raw";
}

// That a list has other times than there are scans is clear only with what was left out.
ScanStamps stamps_of(const fs::path& folder, const ScanFiles& files, double scans_per_s) {
  try {
    return scan_stamps(folder, files.scans, scans_per_s);
  } catch (const IoError& error) {
    if (files.left_out.empty()) throw;
    throw IoError(error.what() + ("; " + files.left_out));
  }
}

}  // namespace

ScanSequence read_scan_sequence(const fs::path& folder, double scans_per_s) {
  require_positive("scans_per_s", scans_per_s);
  const ScanFiles files = scan_files_in(folder);
  if (files.scans.empty())
    throw io_error(folder, "expected scans (.bin, .pcd or .ply), found " +
                               (files.left_out.empty() ? "none" : files.left_out + ", which no sequence is read from"));
  const ScanStamps stamps = stamps_of(folder, files, scans_per_s);
  ScanSequence sequence;
  sequence.layout = layout_of(folder, files.scans.front());
  sequence.has_stamps = stamps.are_measured;
  for (std::size_t i = 0; i < files.scans.size(); ++i) sequence.scans.push_back({stamps.stamps_s[i], files.scans[i]});
  if (!files.left_out.empty()) sequence.warnings.push_back(folder.string() + ": " + files.left_out);
  sequence.warnings.insert(sequence.warnings.end(), stamps.warnings.begin(), stamps.warnings.end());
  if (stamps.are_of_names)
    std::stable_sort(sequence.scans.begin(), sequence.scans.end(),
                     [](const ScanFile& a, const ScanFile& b) { return a.stamp_s < b.stamp_s; });
  return sequence;
}

ScanSequence scans_of_topic(const fs::path& bag, const std::string& topic, const std::vector<double>& stamps_s) {
  ScanSequence sequence{true, "recording", {}, bag, topic, {}};
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
