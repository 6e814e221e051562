// SPDX-License-Identifier: MIT
#include "augicp/io/pose_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "augicp/io/format.h"
#include "augicp/io/pose_file.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TrajectoryFile parse(const std::string& text) { return parse_poses(FileBytes{"a.csv", text}).content; }

std::string table_refusal(const std::string& text) {
  try {
    parse(text);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

// The same two poses, whatever the columns are called and however they are ordered.
void expect_the_poses(const std::string& text) {
  SCOPED_TRACE(text);
  const Trajectory found = parse(text).trajectory;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].stamp_s, 1403636579.763555584, 1e-6);
  EXPECT_NEAR(found[1].stamp_s - found[0].stamp_s, 0.005, 1e-6);
  EXPECT_THAT(found[1].world_from_camera.translation, testing::NearVector(Vec3d(1, 2, 3), 0.0));
  const Eigen::Quaterniond& q = found[1].world_from_camera.rotation;
  EXPECT_THAT(Vec3d(q.x(), q.y(), q.z()), testing::NearVector(Vec3d(0.6, 0, 0), 1e-15));
  EXPECT_NEAR(q.w(), 0.8, 1e-15);
}

TEST(PoseTable, ColumnsAreFoundByTheirNames) {
  const std::string euroc =
      "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], "
      "v_RS_R_x [m s^-1], b_w_RS_S_x [rad s^-1]\n"
      "1403636579763555584,0,0,0,1,0,0,0,7,8\n1403636579768555584,1,2,3,0.8,0.6,0,0,7,8\n";
  expect_the_poses(euroc);
  expect_the_poses(
      "qx;qy;qz;qw;x;y;z;time_s\n0;0;0;1;0;0;0;1403636579.763555584\n0.6;0;0;0.8;1;2;3;1403636579.768555584\n");
  expect_the_poses(
      "%time,field.header.seq,field.pose.position.x,field.pose.position.y,field.pose.position.z,"
      "field.pose.orientation.x,field.pose.orientation.y,field.pose.orientation.z,field.pose.orientation.w\n"
      "1403636579763555584,0,0,0,0,0,0,0,1\n1403636579768555584,1,1,2,3,0.6,0,0,0.8\n");
  expect_the_poses(
      "\"timestamp\",\"tx\",\"ty\",\"tz\",\"qw\",\"qx\",\"qy\",\"qz\"\n"
      "1403636579763.555584,0,0,0,1,0,0,0\n1403636579768.555584,1,2,3,0.8,0.6,0,0\n");
}

TEST(PoseTable, JsonLinesHaveTheSameNames) {
  expect_the_poses(
      "{\"timestamp\": 1403636579.763555584, \"position\": [0, 0, 0], \"orientation_wxyz\": [1, 0, 0, 0]}\n"
      "{\"timestamp\": 1403636579.768555584, \"position\": [1, 2, 3], \"orientation_wxyz\": [0.8, 0.6, 0, 0]}\n");
  expect_the_poses(
      "{\"stamp_ns\": 1403636579763555584, \"pose\": {\"position\": {\"x\": 0, \"y\": 0, \"z\": 0}, "
      "\"orientation\": {\"x\": 0, \"y\": 0, \"z\": 0, \"w\": 1}}}\n"
      "{\"stamp_ns\": 1403636579768555584, \"pose\": {\"position\": {\"x\": 1, \"y\": 2, \"z\": 3}, "
      "\"orientation\": {\"x\": 0.6, \"y\": 0, \"z\": 0, \"w\": 0.8}}}\n");
  EXPECT_THAT(table_refusal("{\"t\": 1, \"position\": [0, 0, 0], \"orientation\": [1, 0, 0, 0]}\n"),
              HasSubstr("line 1: expected a stamp, a position and a quaternion by name"))
      << "the order of the quaternion is not stated";
  EXPECT_THAT(table_refusal("{\"t\": 1\n"), HasSubstr("line 1: expected a JSON object"));
  EXPECT_THAT(table_refusal(std::string("{\"t\": ") + std::string(10000, '[') + "\n"), HasSubstr("line 1"));
}

// A name that states the unit counts more than the magnitude, and only a guess is said.
TEST(PoseTable, UnitsAreStatedOrSaid) {
  const std::string header = "tx,ty,tz,qx,qy,qz,qw", pose = ",0,0,0,0,0,0,1\n";
  const auto stamps = [&](const std::string& name, const std::string& stamp) {
    return parse(name + "," + header + "\n" + stamp + pose);
  };
  EXPECT_EQ(stamps("timestamp [ns]", "500000000").trajectory[0].stamp_s, 0.5);
  EXPECT_THAT(stamps("timestamp [ns]", "500000000").warnings, IsEmpty());
  EXPECT_EQ(stamps("time_ms", "1500").trajectory[0].stamp_s, 1.5);
  EXPECT_EQ(stamps("t", "1500").trajectory[0].stamp_s, 1500);
  EXPECT_NEAR(stamps("t", "1403636579763").trajectory[0].stamp_s, 1403636579.763, 1e-6);
  EXPECT_THAT(stamps("t", "1403636579763").warnings, ElementsAre("the stamps are read as milliseconds"));
  EXPECT_THAT(stamps("t", "1403636579763555").warnings, ElementsAre("the stamps are read as microseconds"));
  EXPECT_THAT(table_refusal("time_s," + header + "\n1403636579763" + pose),
              HasSubstr("line 2: expected a timestamp in seconds"));
}

// Of ROS: another stamp before them does not count.
TEST(PoseTable, SecondsAndNanosecondsInTwoColumnsAreOneStamp) {
  for (
      const char* text :
      {"header.stamp.sec,header.stamp.nanosec,x,y,z,qx,qy,qz,qw\n12,250000000,1,2,3,0,0,0,1\n",
       "time,secs,nsecs,x,y,z,qx,qy,qz,qw\n99,12,250000000,1,2,3,0,0,0,1\n",
       R"({"stamp": {"sec": 12, "nanosec": 250000000}, "x": 1, "y": 2, "z": 3, "qx": 0, "qy": 0, "qz": 0, "qw": 1})"}) {
    const TrajectoryFile read = parse(text);
    EXPECT_EQ(read.trajectory[0].stamp_s, 12.25) << text;
    EXPECT_EQ(read.trajectory[0].world_from_camera.translation, Vec3d(1, 2, 3)) << text;
  }
}

TEST(PoseTable, DamageNamesItsLine) {
  const std::string header = "t,x,y,z,qx,qy,qz,qw\n";
  EXPECT_THAT(table_refusal(header + "1,0,0,0,0,0,0,1\n2,0,0,0,0,0,1\n"), HasSubstr("line 3: expected 8 values"));
  EXPECT_THAT(table_refusal(header + "1,0,0,0,0,0,0,2\n"), HasSubstr("line 2: "));
  EXPECT_THAT(table_refusal(header + "2,0,0,0,0,0,0,1\n1,0,0,0,0,0,0,1\n"), HasSubstr("line 3: expected timestamps"));
  EXPECT_THAT(table_refusal(header + "2,0,nan,0,0,0,0,1\n"), HasSubstr("finite"));
  EXPECT_THAT(table_refusal(header), HasSubstr("found none"));
  EXPECT_THAT(table_refusal("stamp.nanosec,x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n"), HasSubstr("stamp.nanosec"))
      << "a part of a second";
  EXPECT_THAT(parse(header + "1,0,0,0,0,0,0,1\n1,5,0,0,0,0,0,1\n").warnings, ElementsAre(HasSubstr("repeat")));
  EXPECT_THAT(parse(header + "1,0,0,0,0,0,0,1").warnings, ElementsAre(HasSubstr("no end")));
}

TEST(PoseTable, TumStaysTum) {
  const Trajectory found = parse("# timestamp tx ty tz qx qy qz qw\n1 0 0 0 0 0 0 1 # good\n").trajectory;
  EXPECT_EQ(found.size(), 1u);
}

}  // namespace
}  // namespace augicp
