// SPDX-License-Identifier: MIT
#include "augicp/io/bag_topics.h"

#include "augicp/io/atomic_file.h"
#include "augicp/io/bag_testing.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/scan_sequence.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using ::testing::HasSubstr;

class RecordingFile : public ::testing::Test {
 protected:
  RecordingFile() {
    write_file(path(), testing::mcap());
    write_file(folder_ / "a.bag", testing::rosbag1());
  }

  std::string path(const std::string& message = "") const { return (folder_ / "a.mcap").string() + message; }

  static std::string refusal(const std::filesystem::path& path) {
    try {
      read_cloud(path);
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  }

  const testing::TemporaryFolder folder_;
};

TEST_F(RecordingFile, ItsCloudsAreReadByName) {
  const std::vector<Vec3f> expected{{0, 2, -3}, {2, 2, -3}};
  for (const char* message : {"#0", "#1", "#/points#0", "#/points#1"})
    EXPECT_EQ(read_cloud(path(message)).cloud.points, expected) << message;
  EXPECT_EQ(read_cloud((folder_ / "a.bag").string() + "#1").cloud.points, expected);
  EXPECT_TRUE(read_cloud(path("#1"), {.keep_fields = true}).fields.find("ring"));
}

TEST_F(RecordingFile, WhatItDoesNotHaveIsSaid) {
  EXPECT_THAT(refusal(path("#2")), HasSubstr("has no message 2 of /points: the last of its 2 messages is 1"));
  EXPECT_THAT(refusal(path("#/nothing#0")), HasSubstr("has no messages of the topic /nothing"));
  EXPECT_THAT(refusal(path("#/other#0")), HasSubstr("#/other#0: is a a/B, expected a sensor_msgs/PointCloud2"));
  EXPECT_THAT(refusal(path()), HasSubstr("the first of its clouds is " + path("#0")));
}

TEST_F(RecordingFile, ASequenceNamesItsScansSo) {
  const ScanSequence sequence = read_scan_sequence(path(), 10.0, "");
  ASSERT_EQ(sequence.scans.size(), 2u);
  ScanReader reader(sequence);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(reader.read(i, {}).cloud.points, read_cloud(sequence.scans[i].path).cloud.points);
  EXPECT_EQ(sequence.scans[1].path, path("#/points#1"));
  EXPECT_THROW(read_scan_sequence(path(), 10.0, "/other"), IoError);
  EXPECT_THROW(read_scan_sequence(folder_.path(), 10.0, "/points"), IoError);
}

}  // namespace
}  // namespace augicp
