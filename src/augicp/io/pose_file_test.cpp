// SPDX-License-Identifier: MIT
#include "augicp/io/pose_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace augicp {
namespace {

using ::testing::HasSubstr;

PoseFile parsed_poses(const std::string& text) { return parse_poses({"poses.txt", text}); }

std::string pose_fault(const std::string& text) {
  try {
    parsed_poses(text);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

// A quarter turn about z, moved to (1 2 3).
const std::string kPoseRows = "0 -1 0 1  1 0 0 2  0 0 1 3";

TEST(Poses, KittisRowsAreAPose) {
  const PoseFile read = parsed_poses("# poses\n" + kPoseRows + "\n" + kPoseRows + "\n");
  ASSERT_EQ(read.content.trajectory.size(), 2u);
  EXPECT_FALSE(read.has_stamps);
  EXPECT_EQ(read.content.trajectory[1].stamp_s, 1.0);
  const Rigid3& pose = read.content.trajectory[0].world_from_camera;
  EXPECT_TRUE((pose * Vec3d(1.0, 0.0, 0.0)).isApprox(Vec3d(1.0, 3.0, 3.0), 1e-12));
}

TEST(Poses, AThirteenthValueInFrontIsTheStamp) {
  const PoseFile read = parsed_poses("0.5 " + kPoseRows + "\n0.75,0,-1,0,1,1,0,0,2,0,0,1,3\n");
  EXPECT_TRUE(read.has_stamps);
  EXPECT_EQ(read.content.trajectory[1].stamp_s, 0.75);
}

TEST(Poses, AllFourRowsAreReadToo) {
  const PoseFile plain = parsed_poses(kPoseRows + " 0 0 0 1\n"),
                 timed = parsed_poses("0.5 " + kPoseRows + " 0 0 0 1\n");
  EXPECT_FALSE(plain.has_stamps);
  EXPECT_TRUE(timed.has_stamps);
  EXPECT_EQ(timed.content.trajectory[0].stamp_s, 0.5);
  for (const PoseFile& read : {plain, timed})
    EXPECT_EQ(read.content.trajectory[0].world_from_camera.translation, Vec3d(1.0, 2.0, 3.0));
  EXPECT_THAT(pose_fault(kPoseRows + " 0 0 1 1\n"), HasSubstr("line 1: expected the last row 0 0 0 1"));
}

// As of tables with names.
TEST(Poses, StampsTooLargeForSecondsAreReadByMagnitude) {
  const PoseFile read =
      parsed_poses("# my run\n1403636579763000000 1 2 3 0 0 0 1\n1403636579768000000 1 2 3 0 0 0 1\n");
  EXPECT_NEAR(read.content.trajectory[1].stamp_s, 1403636579.768, 1e-6);
  EXPECT_THAT(read.content.warnings, ::testing::ElementsAre("the stamps are read as nanoseconds"));
}

TEST(Poses, WordsThatNameNoPoseAreShown) {
  EXPECT_THAT(pose_fault("timestamp,x,y,z\n1,2,3,4\n"), HasSubstr("columns with the names timestamp tx"));
  EXPECT_THAT(pose_fault("[{\"t\": 1}]\n"), HasSubstr("one object a line"));
}

TEST(Poses, LinesOfCommentsHaveSeveralMarks) {
  EXPECT_EQ(parsed_poses("% made by\n// a program\n# of ours\n0.5 1 2 3 0 0 0 1\n").content.trajectory.size(), 1u);
}

TEST(Poses, TumTrajectoriesAreRead) {
  const PoseFile read = parsed_poses("0.5 1 2 3 0 0 0 1\n");
  EXPECT_TRUE(read.has_stamps);
  EXPECT_EQ(read.content.trajectory[0].world_from_camera.translation, Vec3d(1.0, 2.0, 3.0));
}

TEST(Poses, FaultsNameTheLine) {
  EXPECT_THAT(pose_fault(kPoseRows + "\n" + kPoseRows + " 4\n"), HasSubstr("line 2: expected 12 values"));
  EXPECT_THAT(pose_fault(kPoseRows + "\n1 0 0 0 0 1 0 0 0 0 -1 0\n"),
              HasSubstr("line 2: transform: not a rigid motion"));
  EXPECT_THAT(pose_fault("1 0 0 0 0 x 0 0 0 0 1 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(pose_fault("1 " + kPoseRows + "\n1 " + kPoseRows + "\n"),
              HasSubstr("line 2: expected timestamps that increase"));
  EXPECT_THAT(pose_fault("1 2 3\n"), HasSubstr("line 1: expected 8 values"));
  EXPECT_THAT(pose_fault("# nothing\n"), HasSubstr("expected poses"));
}

TEST(Poses, OneFilesStampsServeTheOther) {
  PoseFile timed = parsed_poses("0.5 " + kPoseRows + "\n0.75 " + kPoseRows + "\n"),
           plain = parsed_poses(kPoseRows + "\n" + kPoseRows + "\n");
  PoseFile longer = parsed_poses(kPoseRows + "\n" + kPoseRows + "\n" + kPoseRows + "\n");
  share_stamps(longer, timed);
  EXPECT_FALSE(longer.has_stamps);
  share_stamps(plain, timed);
  EXPECT_EQ(plain.content.trajectory[1].stamp_s, 0.75);
  EXPECT_TRUE(plain.has_stamps);
}

}  // namespace
}  // namespace augicp
