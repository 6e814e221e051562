// SPDX-License-Identifier: MIT
#include "augicp/io/bag_message_name.h"

#include <gmock/gmock.h>

#include "augicp/core/error.h"
#include "augicp/io/atomic_file.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

void expect_name(const std::filesystem::path& path, const BagMessageName& expected) {
  const auto name = parse_bag_message_name(path);
  ASSERT_TRUE(name) << path;
  EXPECT_EQ(name->bag, expected.bag);
  EXPECT_EQ(name->topic, expected.topic);
  EXPECT_EQ(name->number, expected.number);
  EXPECT_EQ(name->text(), path.string());
}

TEST(BagMessageName, NumbersAndTopicsAreFound) {
  expect_name("drive.mcap#12", {"drive.mcap", "", 12});
  expect_name("/data/drive.BAG#/points#0", {"/data/drive.BAG", "/points", 0});
  expect_name("drive.db3#/a/b#7", {"drive.db3", "/a/b", 7});
  expect_name("run#2/drive.mcap#/points#3", {"run#2/drive.mcap", "/points", 3});
}

TEST(BagMessageName, FoldersOfRosbag2HaveMessages) {
  const testing::TemporaryFolder folder;
  const std::filesystem::path bag = folder / "bag";
  std::filesystem::create_directory(bag);
  EXPECT_FALSE(parse_bag_message_name(bag.string() + "#3"));
  write_file(bag / "metadata.yaml", "");
  write_file(bag / "bag_0.mcap", "");
  expect_name(bag.string() + "#3", {bag, "", 3});
  EXPECT_FALSE(parse_bag_message_name(bag.string() + "#3/scan.ply"));
}

TEST(BagMessageName, OtherPathsAreNone) {
  for (const char* path : {"scan.ply", "scan#1.ply", "drive.mcap", "run#2/drive.mcap", "a.mcap.d#2/b.ply", "#1", ""})
    EXPECT_FALSE(parse_bag_message_name(path)) << path;
}

TEST(BagMessageName, ARecordingWithSomethingElseIsRefused) {
  for (const char* path : {"drive.mcap#", "drive.mcap#last", "drive.mcap#/points", "drive.mcap#-1", "drive.mcap##1"})
    EXPECT_THROW(parse_bag_message_name(path), IoError) << path;
}

}  // namespace
}  // namespace augicp
