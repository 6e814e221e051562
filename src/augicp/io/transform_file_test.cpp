// SPDX-License-Identifier: MIT
#include "augicp/io/transform_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "augicp/io/atomic_file.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

// A quarter turn about z: x becomes y.
Rigid3 quarter_turn() { return {Eigen::Quaterniond(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)), Vec3d(1.0, -2.0, 3.5)}; }

std::string transform_refusal(std::string_view text) {
  try {
    parse_transform(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(TransformFile, EveryFormMeansTheSameMotion) {
  for (const char* text :
       {"0 -1 0 1\n1 0 0 -2\n0 0 1 3.5\n0 0 0 1\n", "# a comment\r\n0 -1 0 1 # row\r\n1 0 0 -2\r\n0 0 1 3.5\r\n0 0 0 1",
        "0 -1 0 1 1 0 0 -2 0 0 1 3.5\n", "1 -2 3.5 0 0 0.70711 0.70711", "1, -2, 3.5, 0, 0, 0.70711, 0.70711\n",
        R"({"status": "converged", "T_target_source": [[0,-1,0,1],[1,0,0,-2],[0,0,1,3.5],[0,0,0,1]]})",
        R"( {"T_target_source": [0,-1,0,1, 1,0,0,-2, 0,0,1,3.5, 0,0,0,1]})"})
    EXPECT_THAT(parse_transform(text), testing::NearPose(quarter_turn(), 1e-7, 1e-12)) << text;
  EXPECT_THAT(parse_transform("1 -2 3.5 0 0 0.70711 0.70711") * Vec3d(1, 0, 0),
              testing::NearVector(Vec3d(1, -1, 3.5), 1e-7));
}

// robustness 6
TEST(TransformFile, WriteThenReadIsIdentity) {
  const testing::TemporaryFolder folder;
  for (const Rigid3& pose : testing::awkward_poses()) {
    write_transform(folder / "T.txt", pose);
    EXPECT_THAT(read_transform(folder / "T.txt"), testing::NearPose(pose, 1e-14, 0.0));
  }
  EXPECT_THAT(read_bytes(folder / "T.txt").bytes,
              ::testing::StartsWith("# T_target_source maps source coordinates into the target frame\n"));
}

// robustness 14
TEST(TransformFile, WhatIsNotARigidMotionIsRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "found 0 numbers"},
      {"1 2 3", "found 3 numbers"},
      {"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1", "line 1: expected at most 16 numbers"},
      {"1 0 0 0\n0 1 0 x\n0 0 1 0", "line 2: expected a number, found 'x'"},
      {"1 0 0 0 0 1 0 0 0 0 -1 0", "reflection"},
      {"2 0 0 0 0 1 0 0 0 0 1 0", "not orthonormal"},
      {"1 0 0 nan 0 1 0 0 0 0 1 0", "not finite"},
      {"1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1", "last row"},
      {"0 0 0 0 0 0 0", "found length 0"},
      {"0 0 0 0 0 0 1.01", "found length 1.01"},
      {"0 0 0 nan 0 0 1", "found length nan"},
      {"0 inf 0 0 0 0 1", "translation is not finite"},
      {"{", "JSON is damaged"},
      {"{}", "expected the key \"T_target_source\""},
      {R"({"T_target_source": [1, "2"]})", "expected numbers"},
      {R"({"T_target_source": [[1, 2]]})", "expected 16 numbers in \"T_target_source\", found 2"},
      {R"({"T_target_source": [[[1]]]})", "expected numbers"},
      {R"({"T_target_source": 1})", "found 1"}};
  for (const auto& [text, message] : cases) EXPECT_THAT(transform_refusal(text), ::testing::HasSubstr(message)) << text;
}

TEST(TransformFile, NothingMayStandBehindTheJson) {
  const std::string json = R"({"T_target_source": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})";
  EXPECT_EQ(transform_refusal(json + "\n"), "");
  EXPECT_THAT(transform_refusal(json + "x"), ::testing::HasSubstr("JSON is damaged"));
  EXPECT_THAT(transform_refusal(json + std::string(3, '\0')), ::testing::HasSubstr("JSON is damaged"));
}

TEST(TransformFile, DeeplyNestedJsonIsRefused) {
  EXPECT_NE(transform_refusal("{\"T_target_source\": " + std::string(100000, '[') + std::string(100000, ']') + "}"),
            "");
}

// robustness 9
TEST(TransformFile, FileErrorsNameThePath) {
  const testing::TemporaryFolder folder;
  write_file(folder / "T.txt", "1 2\n3 x");
  for (const char* name : {"T.txt", "absent.txt", ""}) {
    try {
      read_transform(folder / name);
      ADD_FAILURE() << name;
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr((folder / name).string()));
    }
  }
}

}  // namespace
}  // namespace augicp
