// SPDX-License-Identifier: MIT
// Sequences of LiDAR scans: folders, and topics of recordings.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "augicp/io/cloud_file.h"

namespace augicp {

struct ScanFile {
  double stamp_s = 0.0;
  std::filesystem::path path;  // of a recording: the name of the message, see read_cloud()
};

struct ScanSequence {
  bool has_stamps = false;      // from a list, names or messages; else the stamps are made from numbers and a rate
  std::string layout;           // "KITTI odometry", "KITTI raw", "scans" or "recording"
  std::vector<ScanFile> scans;  // in natural order (2.bin before 10.bin); if the names are stamps in that of the stamps
  std::filesystem::path bag{};  // of a recording, and its topic; else empty
  std::string topic{};
  std::vector<std::string> warnings{};  // what was left out, and stamps that are not as expected; each names its file
};

// The .bin, .pcd and .ply files of a folder, of its folder velodyne/ (KITTI odometry) or of its folder
// velodyne_points/data/ (KITTI raw); of several kinds of files, the one of which there are most. Empty if there are
// none. Throws IoError if the folder cannot be listed.
std::vector<std::filesystem::path> find_scans(const std::filesystem::path& folder);

// Of most LiDARs: for scans that say nothing of their time.
inline constexpr double kUsualScansPerS = 10.0;

// The scans with their stamps: from times.txt (seconds, a line a scan) beside the scans or in a folder above, or from
// KITTI raw's timestamps.txt; else the number in which each name ends, if all have a decimal point or are too large for
// the number of a frame; else that number / scans_per_s, if all names have one and they ascend; else the place /
// scans_per_s. Stamps of a list need not ascend. Other units than seconds: see bring_into_seconds(). Scans are not
// opened. Throws IoError if there are no scans, or if a list of stamps has another number of lines than there are
// scans, or a unit that does not suit; and std::invalid_argument unless scans_per_s is above 0.
ScanSequence read_scan_sequence(const std::filesystem::path& folder, double scans_per_s);

// The same, or of a recording the clouds of a topic, see scans_of_topic(). topic: empty for a folder, or if the
// recording has only one of clouds. Throws IoError.
ScanSequence read_scan_sequence(const std::filesystem::path& folder_or_bag, double scans_per_s,
                                const std::string& topic);

// The clouds of a topic of a recording, in the order of the recording.
ScanSequence scans_of_topic(const std::filesystem::path& bag, const std::string& topic,
                            const std::vector<double>& stamps_s);

class TopicReader;

// Reads the scans of a sequence. Those of a recording are best read in ascending order, see TopicReader. Thread safety:
// none.
class ScanReader {
 public:
  explicit ScanReader(const ScanSequence& sequence);
  ~ScanReader();

  // Throws IoError for a scan that cannot be read. REQUIRES: a number below the sequence's length.
  CloudFile read(std::size_t scan, const ReadOptions& options);

 private:
  std::vector<ScanFile> scans_;
  std::unique_ptr<TopicReader> topic_;
};

}  // namespace augicp
