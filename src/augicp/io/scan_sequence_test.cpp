// SPDX-License-Identifier: MIT
#include "augicp/io/scan_sequence.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "augicp/core/error.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

std::vector<std::string> names(const ScanSequence& sequence) {
  std::vector<std::string> all;
  for (const ScanFile& scan : sequence.scans) all.push_back(scan.path.filename().string());
  return all;
}

std::vector<double> stamps(const ScanSequence& sequence) {
  std::vector<double> all;
  for (const ScanFile& scan : sequence.scans) all.push_back(scan.stamp_s);
  return all;
}

TEST(ScanSequence, NumbersInNamesGiveOrderAndStamps) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"scan10.pcd", "scan9.pcd", "scan12.PCD", "map.ply"}) write(folder.path() / name, "");
  const ScanSequence sequence = read_scan_sequence(folder.path(), 10.0);
  EXPECT_EQ(sequence.layout, "scans");
  EXPECT_EQ(names(sequence), (std::vector<std::string>{"scan9.pcd", "scan10.pcd", "scan12.PCD"}));
  EXPECT_EQ(stamps(sequence), (std::vector<double>{0.9, 1.0, 1.2}));
}

TEST(ScanSequence, NamesWithoutNumbersCountFromZero) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"b.ply", "a.ply"}) write(folder.path() / name, "");
  const ScanSequence sequence = read_scan_sequence(folder.path(), 2.0);
  EXPECT_EQ(names(sequence), (std::vector<std::string>{"a.ply", "b.ply"}));
  EXPECT_EQ(stamps(sequence), (std::vector<double>{0.0, 0.5}));
  EXPECT_FALSE(sequence.has_stamps);
}

TEST(ScanSequence, KittiLayoutsHaveTheirTimes) {
  const testing::TemporaryFolder odometry, raw;
  for (const char* name : {"000000.bin", "000001.bin"}) write(odometry.path() / "velodyne" / name, "");
  write(odometry.path() / "times.txt", "0.0\n1.037e-01\n");
  for (const char* name : {"0000000000.bin", "0000000001.bin"})
    write(raw.path() / "velodyne_points" / "data" / name, "");
  write(raw.path() / "velodyne_points" / "timestamps.txt",
        "2011-09-26 13:59:59.964389445\n2011-09-26 14:00:00.067389445\n");
  const ScanSequence first = read_scan_sequence(odometry.path(), 10.0);
  EXPECT_EQ(first.layout, "KITTI odometry");
  EXPECT_TRUE(first.has_stamps);
  EXPECT_EQ(stamps(first), (std::vector<double>{0.0, 0.1037}));
  const ScanSequence second = read_scan_sequence(raw.path(), 10.0);
  EXPECT_EQ(second.layout, "KITTI raw");
  EXPECT_NEAR(second.scans[1].stamp_s - second.scans[0].stamp_s, 0.103, 1e-6);
}

TEST(ScanSequence, DamagedListsAndEmptyFoldersAreRefused) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(read_scan_sequence(folder.path(), 10.0), IoError);
  EXPECT_THROW(read_scan_sequence(folder.path() / "missing", 10.0), IoError);
  for (const char* name : {"0.bin", "1.bin"}) write(folder.path() / name, "");
  EXPECT_THROW(read_scan_sequence(folder.path(), 0.0), std::invalid_argument);
  for (const char* text : {"0.0\n", "0.0\nnow\n", "1.0\n0.5\n"}) {
    write(folder.path() / "times.txt", text);
    EXPECT_THROW(read_scan_sequence(folder.path(), 10.0), IoError) << text;
  }
}

}  // namespace
}  // namespace augicp
