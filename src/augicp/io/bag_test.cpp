// SPDX-License-Identifier: MIT
#include "augicp/io/bag.h"

#include "augicp/io/atomic_file.h"
#include "augicp/io/bag_testing.h"
#include "augicp/io/decompress.h"
#include "augicp/io/natural_order.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const ReadOptions kKeepBagFields{.keep_fields = true};

std::string refusal_of_message(const std::string& message, MessageForm form) {
  try {
    parse_point_cloud2("bag /points", message, form, {});
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(PointCloud2, BothFormsHoldTheSameCloud) {
  for (const bool is_cdr : {true, false})
    for (const std::uint32_t point_step : {20u, 27u}) {
      const MessageForm form = is_cdr ? MessageForm::Cdr : MessageForm::Ros1;
      const PointCloud2 read =
          parse_point_cloud2("bag", testing::point_cloud2(is_cdr, point_step), form, kKeepBagFields);
      EXPECT_EQ(read.stamp_ns, 7'000'000'008);
      EXPECT_EQ(read.frame, "lidar");
      EXPECT_EQ(read.file.cloud.points, (std::vector<Vec3f>{{0, 2, -3}, {2, 2, -3}}));
      EXPECT_EQ(read.file.report.num_not_finite, 1u);
      ASSERT_EQ(read.file.fields.fields.size(), 2u);
      EXPECT_EQ(read.file.fields.find("ring")->at(1), 12.0);
      EXPECT_EQ(read.file.fields.find("t")->at(1), 2000.0);
    }
}

// robustness 1: all but the last byte, is_dense, counts.
TEST(PointCloud2, CutsAreRefused) {
  for (const bool is_cdr : {true, false}) {
    const std::string message = testing::point_cloud2(is_cdr);
    const MessageForm form = is_cdr ? MessageForm::Cdr : MessageForm::Ros1;
    for (std::size_t length = 0; length + 1 < message.size(); ++length)
      EXPECT_THAT(refusal_of_message(message.substr(0, length), form), HasSubstr("bag /points")) << length;
  }
}

TEST(PointCloud2, FieldsLieWithinTheirPoint) {
  const std::string message = testing::point_cloud2(true);
  EXPECT_THAT(refusal_of_message(testing::with(message, std::string("\x14\0\0\0", 4), std::string("\x13\0\0\0", 4)),
                                 MessageForm::Cdr),
              HasSubstr("field 't' within the 19 bytes"));
  EXPECT_THAT(refusal_of_message("\x07\x07\x07\x07", MessageForm::Cdr), HasSubstr("expected CDR"));
}

void expect_the_recording(const std::filesystem::path& path) {
  SCOPED_TRACE(path);
  std::vector<std::string> seen;
  visit_messages(path, [&](const BagMessage& message) {
    seen.push_back(fmt::format("{} {} {} {}", message.topic, message.type, message.stamp_ns, message.data.size()));
    return true;
  });
  const bool is_cdr = path.extension() != ".bag";
  const std::string cloud = fmt::format(" {}", testing::point_cloud2(is_cdr).size());
  EXPECT_THAT(seen, ElementsAre("/points sensor_msgs/PointCloud2 4" + cloud, "/other a/B 5 2",
                                "/points sensor_msgs/PointCloud2 6" + cloud));
  const std::vector<BagTopic> topics = bag_topics(path);
  ASSERT_EQ(topics.size(), 2u);
  EXPECT_EQ(topics[1].num_messages, 2u);
  std::size_t count = 0;
  visit_messages(path, [&](const BagMessage&) { return ++count < 2; });
  EXPECT_EQ(count, 2u) << "the visitor ends the visit";
}

TEST(Bag, EveryMessageIsShown) {
  const testing::TemporaryFolder folder;
  write_file(folder / "a.mcap", testing::mcap());
  write_file(folder / "a.bag", testing::rosbag1());
  expect_the_recording(folder / "a.mcap");
  expect_the_recording(folder / "a.bag");
  EXPECT_TRUE(is_bag(folder / "a.bag"));
  EXPECT_FALSE(is_bag(folder.path()));
  std::filesystem::create_directory(folder / "rosbag2");
  write_file(folder / "rosbag2" / "metadata.yaml", "rosbag2_bagfile_information:\n");
  write_file(folder / "rosbag2" / "rosbag2_0.mcap", testing::mcap());
  EXPECT_TRUE(is_bag(folder / "rosbag2"));
  expect_the_recording(folder / "rosbag2");
}

std::string refusal_of_bag(const std::filesystem::path& path, const std::string& bytes) {
  write_file(path, bytes);
  try {
    bag_topics(path);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

// robustness 1: behind the end of the data there is an index that is not needed.
TEST(Bag, CutsAreRefused) {
  const testing::TemporaryFolder folder;
  const std::string mcap = testing::mcap(), bag = testing::rosbag1();
  const std::size_t end_of_data = mcap.size() - 8 - 29 - 4;
  for (std::size_t length = 0; length < end_of_data; length += 3)
    EXPECT_NE(refusal_of_bag(folder / "a.mcap", mcap.substr(0, length)), "") << length;
  std::size_t num_read = 0;
  for (std::size_t length = 0; length < bag.size(); ++length)
    num_read += refusal_of_bag(folder / "a.bag", bag.substr(0, length)).empty();
  EXPECT_EQ(num_read, 3u) << "a bag cut between two records is a shorter one";
}

TEST(Bag, WhatIsNotReadIsSaid) {
  const testing::TemporaryFolder folder;
  EXPECT_THAT(refusal_of_bag(folder / "a.mcap", testing::mcap("xz")), HasSubstr("mcap compress --compression none"));
  EXPECT_THAT(refusal_of_bag(folder / "a.bag", testing::rosbag1("xz")), HasSubstr("rosbag decompress"));
  EXPECT_THAT(refusal_of_bag(folder / "a.bag", testing::with(testing::rosbag1(), testing::packed<std::uint64_t>({4109}),
                                                             std::string(8, '\0'))),
              HasSubstr("rosbag reindex"));
  EXPECT_THAT(refusal_of_bag(folder / "a.db3", "no database"), HasSubstr("a.db3"));
  EXPECT_THROW(bag_topics(folder / "nothing.bag"), IoError);
}

TEST(Bag, NoCompressedPartIsLeftOut) {
  const testing::TemporaryFolder folder;
  write_file(folder / "metadata.yaml", "rosbag2_bagfile_information:\n");
  write_file(folder / "bag_0.mcap", testing::mcap());
  write_file(folder / "bag_1.mcap.zstd", "(");
  EXPECT_TRUE(is_bag(folder.path()));
  try {
    bag_topics(folder.path());
    FAIL() << "a part was left out";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bag_1.mcap.zstd: is compressed as a whole; first run 'zstd -d "));
  }
  write_file(folder / "bag_1.mcap", testing::mcap());
  EXPECT_EQ(bag_topics(folder.path())[1].num_messages, 4u);
}

TEST(Bag, CompressedChunksHoldTheSame) {
  const testing::TemporaryFolder folder;
  for (const char* compression : {"lz4", "zstd"}) {
    if (!can_decompress(compression)) continue;
    write_file(folder / "a.mcap", testing::mcap(compression));
    expect_the_recording(folder / "a.mcap");
    write_file(folder / "a.bag", testing::rosbag1(compression));
    expect_the_recording(folder / "a.bag");
  }
}

// One block of zstd may state a run of 128 KiB in four bytes.
TEST(Decompress, ContentIsBounded) {
  if (!can_decompress("zstd")) GTEST_SKIP() << "built without zstd";
  const auto runs = [](std::uint32_t num_blocks) {
    std::string bytes("\x28\xb5\x2f\xfd\0\x58", 6);
    for (std::uint32_t i = 1; i <= num_blocks; ++i)
      bytes += testing::u32((1u << 17) << 3 | 1u << 1 | (i == num_blocks ? 1u : 0u)).substr(0, 3) + "a";
    return bytes;
  };
  EXPECT_EQ(decompressed("bag", "zstd", runs(100), std::nullopt), std::string(100 << 17, 'a'));
  EXPECT_THROW(decompressed("bag", "zstd", runs(257), std::nullopt), IoError) << "more than 32 MiB of 1 KB";
  EXPECT_THROW(decompressed("bag", "zstd", runs(1), 1u << 30), IoError);
}

TEST(Decompress, DamageIsRefused) {
  const std::string content = "the content of a chunk";
  for (const std::string compression : {"lz4", "zstd"}) {
    if (!can_decompress(compression)) continue;
    const std::string whole = testing::compressed(compression, content);
    EXPECT_EQ(decompressed("bag", compression, whole, content.size()), content);
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_THROW(decompressed("bag", compression, whole.substr(0, length), content.size()), IoError) << length;
    EXPECT_THROW(decompressed("bag", compression, whole + "x", content.size()), IoError);
    for (const std::size_t size : {content.size() - 1, content.size() + 1})
      EXPECT_THROW(decompressed("bag", compression, whole, size), IoError);
  }
}

TEST(NaturalOrder, NumbersCompareAsNumbers) {
  EXPECT_TRUE(naturally_before("bag_2.db3", "bag_10.db3"));
  EXPECT_FALSE(naturally_before("bag_10.db3", "bag_2.db3"));
}

// Files of other programs, where they are.
TEST(Bag, PublicFiles) {
  const std::filesystem::path shared = std::filesystem::path(AUGICP_SHARED_DATA_DIR) / "formats";
  if (!std::filesystem::is_directory(shared)) GTEST_SKIP() << "no folder " << shared;
  EXPECT_TRUE(bag_topics(shared / "rosbag1/no-messages.bag").empty());
  for (const char* compression : {"lz4", "bz2"})
    if (can_decompress(compression)) {
      const std::vector<BagTopic> topics = bag_topics(shared / fmt::format("rosbag1/example-{}.bag", compression));
      ASSERT_EQ(topics.size(), 9u);
      EXPECT_EQ(topics[1].name, "/tf");
      EXPECT_EQ(topics[1].num_messages, 2688u);
    }
  const std::string message = read_bytes(shared / "dds_pointcloud2/dds_message.bin").bytes;
  const PointCloud2 read = parse_point_cloud2("dds", message, MessageForm::Cdr, kKeepBagFields);
  EXPECT_EQ(read.frame, "lidar_link");
  EXPECT_EQ(read.file.report.num_declared, 64000u);
  EXPECT_EQ(read.file.fields.find("ring")->type, ScalarType::Uint16);
  EXPECT_NEAR(read.file.fields.find("timestamp")->at(0), 1e-9 * static_cast<double>(read.stamp_ns), 0.2);
}

}  // namespace
}  // namespace augicp
