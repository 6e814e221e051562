// SPDX-License-Identifier: MIT
#include "augicp/io/trajectory_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "augicp/io/atomic_file.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using ::testing::HasSubstr;

constexpr const char* kTrajectory =
    "# ground truth\n"
    "1305031452.8795 1.2335 0.9177 1.5327 0.8639 0.3285 -0.1993 -0.3257\n"
    "1305031452.8895 1.2348 0.9170 1.5316 0.8656 0.3264 -0.1978 -0.3242\n"
    "1305031452.8995 1.2360 0.9165 1.5304 0.8673 0.3245 -0.1962 -0.3226\n";

Trajectory parse(const std::string& text) { return parse_tum_trajectory({"a.txt", text}).trajectory; }

// The message of the IoError for a text, or empty if it is read.
std::string trajectory_refusal(const std::string& text) {
  try {
    parse(text);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

std::string with_line(const std::string& line) { return kTrajectory + line + "\n"; }

void expect_same_bits(const Trajectory& a, const Trajectory& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].stamp_s, b[i].stamp_s);
    EXPECT_EQ(a[i].world_from_camera.translation, b[i].world_from_camera.translation);
    EXPECT_EQ(a[i].world_from_camera.rotation.coeffs(), b[i].world_from_camera.rotation.coeffs());
  }
}

TEST(TrajectoryFile, APoseIsThatOfTheCameraInTheWorld) {
  const Trajectory trajectory = parse("7.5 1 -2 3.5 0 0 0.70711 0.70711\n");  // a quarter turn about z
  ASSERT_EQ(trajectory.size(), 1u);
  EXPECT_EQ(trajectory[0].stamp_s, 7.5);
  EXPECT_THAT(trajectory[0].world_from_camera * Vec3d(1, 0, 0), testing::NearVector(Vec3d(1, -1, 3.5), 1e-12));
}

TEST(TrajectoryFile, SeparatorsLineEndsAndCommentsDoNotMatter) {
  const Trajectory expected = parse("1 1 2 3 0 0 0 1\n2 4 5 6 0 0 1 0\n");
  for (const char* text : {"1\t1 2  3 0 0 0 1\r\n2 4 5 6 0 0 1 0\r\n", "1,1,2,3,0,0,0,1\n2, 4, 5, 6, 0, 0, 1, 0\n",
                           "\xef\xbb\xbf# a comment\n\n 1 1 2 3 0 0 0 1 # another\n \n2 4 5 6 0 0 1 0",
                           "+1e0 1 2 3 0 0 0 1\r2 4 5 6 0 0 1 0\r"})
    expect_same_bits(parse(text), expected);
}

TEST(TrajectoryFile, FourDigitsOfAQuaternionAreEnough) {
  for (const StampedPose& pose : parse(kTrajectory)) EXPECT_NEAR(pose.world_from_camera.rotation.norm(), 1.0, 1e-15);
}

// robustness 6
TEST(TrajectoryFile, WriteThenReadGivesTheSameBits) {
  const testing::TemporaryFolder folder;
  std::mt19937 generator(3);
  Trajectory trajectory;
  for (const Rigid3& pose : testing::awkward_poses())
    trajectory.push_back({1305031452.0 + 0.1 * static_cast<double>(trajectory.size()), pose});
  for (int i = 0; i < 2000; ++i)
    trajectory.push_back({1305031500.0 + i / 30.0,
                          testing::random_motion(generator, testing::uniform(generator, 0.0, std::numbers::pi), 1e3)});
  write_tum_trajectory(folder / "poses.txt", trajectory);
  const TrajectoryFile read = read_tum_trajectory(folder / "poses.txt");
  EXPECT_THAT(read.warnings, ::testing::IsEmpty());
  expect_same_bits(read.trajectory, trajectory);
}

TEST(TrajectoryFile, StampsHaveSixDecimalsOrMore) {
  const testing::TemporaryFolder folder;
  const Trajectory trajectory = {{-1e11, {}}, {0.0, {}}, {1e-7, {}}, {0.5, {}}, {1305031452.8795, {}}, {1e11, {}}};
  write_tum_trajectory(folder / "poses.txt", trajectory);
  expect_same_bits(read_tum_trajectory(folder / "poses.txt").trajectory, trajectory);
  const std::string text = read_bytes(folder / "poses.txt").bytes;
  EXPECT_THAT(text, ::testing::StartsWith("# T_world_camera"));
  for (const char* line : {"\n# timestamp tx ty tz qx qy qz qw\n", "\n-100000000000.000000 ",
                           "\n0.000000 0 0 0 0 0 0 1\n", "\n0.0000001 ", "\n0.500000 ", "\n1305031452.879500 "})
    EXPECT_THAT(text, HasSubstr(line));
}

// robustness 8: each with the number of its line, which is 5.
TEST(TrajectoryFile, WhatIsNoPoseOfATrajectoryIsRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"1305031453 1 2 3 0 0 1", "expected 8 values, timestamp tx ty tz qx qy qz qw, found 7"},
      {"1305031453 1 2 3 0 0 0 1 9", "expected 8 values, timestamp tx ty tz qx qy qz qw, found 9"},
      {"1305031453 1 2 3 0 0 0 one", "expected a number, found 'one'"},
      {"1305031453 1 2 3 0 0 0 1,0", "expected 8 values"},
      {"1305031453 1 2 nan 0 0 0 1", "expected a finite number, found 'nan'"},
      {"1305031453 1 2 3 0 0 0 inf", "expected a finite number, found 'inf'"},
      {"1305031453 1 2 1e400 0 0 0 1", "expected a finite number, found '1e400'"},
      {"nan 1 2 3 0 0 0 1", "expected a finite number, found 'nan'"},
      {"1305031453 1 2 3 0 0 0 0", "expected a quaternion qx qy qz qw of length 1, found length 0"},
      {"1305031453 1 2 3 0 0 0 1.01", "found length 1.01"},
      {"1305031453 1 2 3 1e300 0 0 1", "expected a quaternion"},
      {"1305031452 1 2 3 0 0 0 1", "expected timestamps that increase, found 1305031452 after 1305031452.8995"},
      {"1305031452900 1 2 3 0 0 0 1", "expected a timestamp in seconds, found 1305031452900: milliseconds?"},
      {"1305031452900000 1 2 3 0 0 0 1", "found 1305031452900000: microseconds?"},
      {"1305031452900000000 1 2 3 0 0 0 1", "nanoseconds?"}};
  for (const auto& [line, message] : cases) {
    EXPECT_THAT(trajectory_refusal(with_line(line)), HasSubstr(message)) << line;
    EXPECT_THAT(trajectory_refusal(with_line(line)), HasSubstr("a.txt: line 5: ")) << line;
  }
}

// robustness 1
TEST(TrajectoryFile, AFileWithoutPosesIsRefused) {
  for (const char* text : {"", "\n", "# timestamp tx ty tz qx qy qz qw\n"})
    EXPECT_THAT(trajectory_refusal(text), HasSubstr("a.txt: expected poses")) << text;
  EXPECT_THAT(trajectory_refusal(std::string("\0\0\0\0", 4)), HasSubstr("byte 0: expected text"));
}

// robustness 1. A file cut between lines is a shorter file.
TEST(TrajectoryFile, ACutWithinALineIsSeen) {
  const std::string text = kTrajectory;
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string cut = text.substr(0, length);
    if (!trajectory_refusal(cut).empty()) continue;
    const TrajectoryFile read = parse_tum_trajectory({"a.txt", cut});
    EXPECT_EQ(read.warnings.size(), cut.ends_with('\n') ? 0u : 1u) << length;
    EXPECT_EQ(read.trajectory.size(), std::count(cut.begin(), cut.end(), '\n') - (cut.ends_with('\n') ? 1 : 0))
        << length;
  }
}

// robustness 1, 8
TEST(TrajectoryFile, DamagedFilesAreRefusedOrKeepThePromises) {
  std::mt19937 generator(9);
  for (int mutant = 0; mutant < 20000; ++mutant) {
    std::string text = kTrajectory;
    for (unsigned i = 0; i <= generator() % 3; ++i)
      text[generator() % text.size()] = "0123456789.-e \t,#\n\rn"[generator() % 20];
    if (!trajectory_refusal(text).empty()) continue;
    const Trajectory trajectory = parse(text);
    EXPECT_FALSE(trajectory.empty());
    EXPECT_NO_THROW(check_order(trajectory)) << text;
    for (const StampedPose& pose : trajectory) {
      EXPECT_NEAR(pose.world_from_camera.rotation.norm(), 1.0, 1e-14) << text;
      EXPECT_TRUE(pose.world_from_camera.translation.allFinite()) << text;
    }
  }
}

// robustness 9
TEST(TrajectoryFile, FileErrorsNameThePath) {
  const testing::TemporaryFolder folder;
  write_file(folder / "poses.txt", "1 2\n");
  for (const char* name : {"poses.txt", "absent.txt", ""}) {
    try {
      read_tum_trajectory(folder / name);
      ADD_FAILURE() << name;
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), HasSubstr((folder / name).string()));
    }
  }
  EXPECT_THROW(write_tum_trajectory("/dev/full", parse(kTrajectory)), IoError);
}

TEST(TrajectoryFile, WhatCouldNotBeReadBackIsNotWritten) {
  const testing::TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Rigid3 not_finite{Eigen::Quaterniond::Identity(), {nan, 0.0, 0.0}};
  const Rigid3 not_turned{Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0), Vec3d::Zero()};
  for (const Trajectory& trajectory : {Trajectory{{2.0, {}}, {1.0, {}}}, Trajectory{{nan, {}}}, Trajectory{{1e12, {}}},
                                       Trajectory{{1.0, not_finite}}, Trajectory{{1.0, not_turned}}})
    EXPECT_THROW(write_tum_trajectory(folder / "poses.txt", trajectory), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "poses.txt"));
}

TEST(TrajectoryFile, OfEqualStampsTheFirstPoseIsKept) {
  const TrajectoryFile read = parse_tum_trajectory({"t.txt",
                                                    "1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n2 9 0 0 0 0 0 1\n"
                                                    "2 8 0 0 0 0 0 1\n3 3 0 0 0 0 0 1\n"});
  ASSERT_EQ(read.trajectory.size(), 3u);
  EXPECT_EQ(read.trajectory[1].world_from_camera.translation.x(), 2.0);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_EQ(read.warnings[0],
            "2 poses repeat the stamp before, first in line 3: of equal stamps the first pose is kept");
}

}  // namespace
}  // namespace augicp
