// SPDX-License-Identifier: MIT
#include "augicp/io/scan_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "augicp/core/error.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

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

// The only one.
std::string warning(const ScanSequence& sequence) {
  EXPECT_EQ(sequence.warnings.size(), 1u);
  return sequence.warnings.empty() ? "" : sequence.warnings[0];
}

std::string refusal(const fs::path& folder) {
  try {
    read_scan_sequence(folder, 10.0);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(ScanSequence, NumbersInNamesGiveOrderAndStamps) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"scan10.pcd", "scan9.pcd", "scan12.PCD", "map.ply"}) write(folder.path() / name, "");
  const ScanSequence sequence = read_scan_sequence(folder.path(), 10.0);
  EXPECT_EQ(sequence.layout, "scans");
  EXPECT_EQ(names(sequence), (std::vector<std::string>{"scan9.pcd", "scan10.pcd", "scan12.PCD"}));
  EXPECT_EQ(stamps(sequence), (std::vector<double>{0.9, 1.0, 1.2}));
  EXPECT_FALSE(sequence.has_stamps);
  EXPECT_EQ(warning(sequence), folder.path().string() +
                                   ": 3 .pcd scans are read, and 1 .ply left out: scans of one kind "
                                   "in a folder of their own are all read");
}

TEST(ScanSequence, EveryOtherKindIsCounted) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"0.bin", "1.bin", "0.pcd", "1.PCD", "0.las", "notes.txt"})
    write(folder.path() / "velodyne" / name, "");
  for (const char* name : {"0.ply", "1.ply", "2.ply"}) write(folder.path() / name, "");
  const ScanSequence sequence = read_scan_sequence(folder.path(), 10.0);
  EXPECT_EQ(names(sequence), (std::vector<std::string>{"0.bin", "1.bin"}));
  EXPECT_THAT(warning(sequence),
              HasSubstr("2 .bin scans are read, and 1 .las, 2 .pcd and 3 .ply outside of it left out"));
}

TEST(ScanSequence, CloudsThatAreNoSequenceAreNamed) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"0.las", "1.las", "a.xyz"}) write(folder.path() / name, "");
  EXPECT_THAT(refusal(folder.path()), HasSubstr("found 2 .las, 1 .xyz, which no sequence is read from"));
}

TEST(ScanSequence, AListThatCountsBothKindsTellsOfBoth) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"0.bin", "1.pcd", "2.bin"}) write(folder.path() / name, "");
  write(folder.path() / "times.txt", "0.0\n0.1\n0.2\n");
  EXPECT_THAT(refusal(folder.path()),
              AllOf(HasSubstr("expected 2 times, one a scan, found 3"), HasSubstr("1 .pcd left out")));
}

TEST(ScanSequence, AMapAmongTheScansIsNamed) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"0.ply", "1.ply", "2.ply", "map.ply"}) write(folder.path() / name, "");
  EXPECT_THAT(
      warning(read_scan_sequence(folder.path(), 10.0)),
      HasSubstr("without a number in the name are 1 of 4 scans, the first is map.ply; they are tracked as well"));
}

TEST(ScanSequence, NamesThatAreStampsAreStamps) {
  const testing::TemporaryFolder points, nanoseconds;
  for (const char* name : {"1403636579.763555584.pcd", "1403636579.9.pcd", "1403636579.863555584.pcd"})
    write(points.path() / name, "");
  const ScanSequence first = read_scan_sequence(points.path(), 10.0);
  EXPECT_TRUE(first.has_stamps);
  EXPECT_EQ(stamps(first), (std::vector<double>{1403636579.763555584, 1403636579.863555584, 1403636579.9}));
  EXPECT_TRUE(first.warnings.empty());
  for (const char* name : {"scan_1403636579763555584.pcd", "scan_1403636579863555584.pcd"})
    write(nanoseconds.path() / name, "");
  const ScanSequence second = read_scan_sequence(nanoseconds.path(), 10.0);
  EXPECT_TRUE(second.has_stamps);
  EXPECT_NEAR(second.scans[1].stamp_s, 1403636579.863555584, 1e-6);
  EXPECT_THAT(warning(second), HasSubstr("of the names, the stamps are read as nanoseconds"));
}

TEST(ScanSequence, NumbersOfNamesInNoUnitAreNamedAndNotUsed) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"20240101120000.pcd", "20240101120001.pcd"}) write(folder.path() / name, "");
  const ScanSequence sequence = read_scan_sequence(folder.path(), 10.0);
  EXPECT_FALSE(sequence.has_stamps);
  EXPECT_EQ(stamps(sequence), (std::vector<double>{0.0, 0.1}));
  EXPECT_THAT(warning(sequence), HasSubstr("the numbers in the names are not used: expected seconds"));
}

TEST(ScanSequence, TimesInOtherUnitsBecomeSecondsAloud) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"0.bin", "1.bin", "2.bin"}) write(folder.path() / name, "");
  for (const char* text :
       {"0\n100000000\n200000000\n", "1403636579763555584\n1403636579863555584\n1403636579963555584\n"}) {
    write(folder.path() / "times.txt", text);
    const ScanSequence sequence = read_scan_sequence(folder.path(), 10.0);
    EXPECT_NEAR(sequence.scans[2].stamp_s - sequence.scans[0].stamp_s, 0.2, 1e-6);
    EXPECT_THAT(warning(sequence), HasSubstr("times.txt: the stamps are read as nanoseconds"));
  }
  write(folder.path() / "times.txt", "0\n1e15\n2e15\n");
  EXPECT_THAT(refusal(folder.path()), HasSubstr("times.txt: expected seconds, found stamps that are 1e+15 apart"));
}

// As in lists of depth images: the odometry reports which scans are out of order.
TEST(ScanSequence, TimesAreNeverReordered) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"0.bin", "1.bin", "2.bin"}) write(folder.path() / name, "");
  write(folder.path() / "times.txt", "0.0\n0.2\n0.1\n");
  EXPECT_EQ(stamps(read_scan_sequence(folder.path(), 10.0)), (std::vector<double>{0.0, 0.2, 0.1}));
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
  for (const char* text : {"0.0\n", "0.0\nnow\n", "0.0\nnan\n"}) {
    write(folder.path() / "times.txt", text);
    EXPECT_THROW(read_scan_sequence(folder.path(), 10.0), IoError) << text;
  }
}

}  // namespace
}  // namespace augicp
