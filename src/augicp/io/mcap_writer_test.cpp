// SPDX-License-Identifier: MIT
#include "augicp/io/mcap_writer.h"

#include "augicp/io/bag.h"
#include "augicp/io/point_cloud2.h"
#include "augicp/io/reader_testing.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

CloudFile cloud_of(const std::vector<Vec3f>& points) {
  CloudFile file;
  file.cloud.points = points;
  return file;
}

PointField wide_field(std::size_t num_rows) {
  PointField field{"stamp", ScalarType::Uint64, 1, {}};
  for (std::uint64_t i = 0; i < num_rows; ++i) field.values += testing::packed<std::uint64_t>({1000 + i});
  return field;
}

PointCloud2 read_back(const std::string& message) {
  ReadOptions options;
  options.keep_fields = true;
  return parse_point_cloud2("message", message, MessageForm::Cdr, options);
}

TEST(RosMessages, CloudsAreReadBack) {
  CloudFile file = cloud_of({{1, 2, 3}, {4, 5, 6}, {-1, 0.5f, 2}});
  file.fields.fields.push_back(wide_field(3));
  const PointCloud2 read = read_back(point_cloud2_message({-1, "lidar"}, file));
  EXPECT_EQ(read.stamp_ns, -1);
  EXPECT_EQ(read.frame, "lidar");
  EXPECT_EQ(read.file.cloud.points, file.cloud.points);
  ASSERT_NE(read.file.fields.find("stamp"), nullptr);
  EXPECT_EQ(read.file.fields.find("stamp")->type, ScalarType::Float64);
  EXPECT_EQ(read.file.fields.find("stamp")->at(2), 1002.0);
}

TEST(RosMessages, GridsStayGrids) {
  CloudFile file = cloud_of({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  file.grid = IndexImage(2, 2);
  file.grid->index = {0, IndexImage::kNone, 1, 2};
  const PointCloud2 read = read_back(point_cloud2_message({5, "camera"}, file));
  EXPECT_EQ(read.file.cloud.points, file.cloud.points);
  ASSERT_TRUE(read.file.grid);
  EXPECT_EQ(read.file.grid->index, file.grid->index);
}

TEST(RosMessages, LargeCoordinatesKeepTheirMillimetres) {
  CloudFile file = cloud_of({{0.001f, 2, 3}, {0.002f, 5, 6}});
  file.cloud.origin = {4.5e6, 5.4e6, 100.0};
  const Cloud read = read_back(point_cloud2_message({5, "map"}, file)).file.cloud;
  const Vec3d difference = read.origin + read.points[1].cast<double>() - read.origin - read.points[0].cast<double>();
  EXPECT_NEAR(difference.x(), 0.001, 1e-6);
}

TEST(McapWriter, EveryMessageIsReadBack) {
  const testing::TemporaryFolder folder;
  McapWriter writer(folder / "a.mcap");
  const std::uint16_t points = writer.add_topic("/points", point_cloud2_type());
  const std::uint16_t tf = writer.add_topic("/tf", tf_type()), more = writer.add_topic("/more", point_cloud2_type());
  // Several chunks.
  const std::string message = point_cloud2_message({7, "lidar"}, cloud_of(std::vector<Vec3f>(100'000, {1, 2, 3})));
  for (int i = 0; i < 9; ++i) writer.write(i % 2 == 0 ? points : more, 10 - i, message);
  writer.write(tf, 3, tf_message({3, "map"}, "lidar", {}));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mcap"));
  writer.commit();
  EXPECT_THROW(writer.write(tf, -1, ""), std::invalid_argument);
  BagReader reader(folder / "a.mcap");
  for (int i = 0; i < 9; ++i) {
    const auto read = reader.next();
    ASSERT_TRUE(read);
    EXPECT_EQ(read->topic, i % 2 == 0 ? "/points" : "/more");
    EXPECT_EQ(read->type, "sensor_msgs/PointCloud2");
    EXPECT_EQ(read->stamp_ns, 10 - i);
    EXPECT_EQ(read->data, message);
  }
  EXPECT_EQ(reader.next()->type, "tf2_msgs/TFMessage");
  EXPECT_FALSE(reader.next());
}

}  // namespace
}  // namespace augicp
