// SPDX-License-Identifier: MIT
#include "augicp/io/depth_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "augicp/io/atomic_file.h"
#include "augicp/io/depth_png.h"
#include "augicp/io/file_bytes.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

DepthImage flat(float depth) { return {2, 2, {depth, depth, depth, depth}}; }

std::string folder_refusal(const fs::path& folder) {
  try {
    read_depth_sequence(folder);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(DepthSequence, TumFoldersListTheirImages) {
  const testing::TemporaryFolder folder;
  write_file(folder / "depth.txt", "# depth maps\r\n10.5 depth/a.png\r\n\r\n10.6\tdepth/b.png\r\n");
  write_file(folder / "groundtruth.txt", "10.4 1 2 3 0 0 0 1\n10.7 1 2 4 0 0 0 1\n");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_EQ(sequence.layout, "TUM");
  EXPECT_EQ(sequence.depth_scale, 5000.0);
  ASSERT_EQ(sequence.frames.size(), 2u);
  EXPECT_EQ(sequence.frames[1].stamp_s, 10.6);
  EXPECT_EQ(sequence.frames[1].path, folder.path() / "depth/b.png");
  ASSERT_TRUE(sequence.truth);
  EXPECT_EQ(sequence.truth->size(), 2u);
  EXPECT_FALSE(sequence.camera);
}

TEST(DepthSequence, StampsInOtherUnitsBecomeSecondsAloud) {
  const testing::TemporaryFolder folder;
  write_file(folder / "depth.txt", "1305031453374.1 a.png\n1305031453407.4 b.png\n");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_NEAR(sequence.frames[1].stamp_s, 1305031453.4074, 1e-6);
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_THAT(sequence.warnings[0], HasSubstr("depth.txt: the stamps are read as milliseconds"));
}

TEST(DepthSequence, ImagesThatAreLeftOutAreNamed) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"1.png", "2.png", "1.pgm"}) write_file(folder / name, "");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_EQ(sequence.frames.size(), 2u);
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_THAT(sequence.warnings[0], HasSubstr("2 .png images are read, and left out are 1 .pgm"));
}

// robustness 17: what is out of order stays so, for the odometry to see.
TEST(DepthSequence, StampsAreNeverReordered) {
  const testing::TemporaryFolder folder;
  write_file(folder / "depth.txt", "3 a.png\n2 b.png\n2 c.png\n");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_EQ(sequence.frames[0].stamp_s, 3.0);
  EXPECT_EQ(sequence.frames[2].stamp_s, 2.0);
}

TEST(DepthSequence, SevenScenesFoldersHaveAPoseAnImage) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"frame-000000.depth.png", "frame-000003.depth.png", "frame-000001.depth.png"})
    write_file(folder / name, "");
  write_file(folder / "frame-000003.pose.txt", "1 0 0 7\n0 1 0 8\n0 0 1 9\n0 0 0 1\n");
  write_file(folder / "frame-000001.pose.txt", "-1.#IND -1.#IND -1.#IND -1.#IND\n");
  const DepthSequence sequence = read_depth_sequence(folder.path(), 10.0);
  EXPECT_EQ(sequence.layout, "7-Scenes");
  EXPECT_EQ(sequence.depth_scale, 1000.0);
  ASSERT_EQ(sequence.frames.size(), 3u);
  EXPECT_EQ(sequence.frames[1].path.filename(), "frame-000001.depth.png");
  EXPECT_EQ(sequence.frames[2].stamp_s, 0.3);
  ASSERT_TRUE(sequence.truth);
  ASSERT_EQ(sequence.truth->size(), 1u);
  EXPECT_EQ(sequence.truth->front().stamp_s, 0.3);
  EXPECT_EQ(sequence.truth->front().world_from_camera.translation, Vec3d(7, 8, 9));
  ASSERT_TRUE(sequence.camera);
  EXPECT_EQ(sequence.camera->pinhole.fx, 585.0);
}

TEST(DepthSequence, NumbersSortAsNumbers) {
  const testing::TemporaryFolder folder;
  fs::create_directory(folder / "depth");
  for (const char* name : {"depth/10.png", "depth/9.png", "depth/notes.txt", "depth/mask.png"})
    write_file(folder / name, "");
  write_file(folder / "camera.txt", "500 501 320 240\n");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_EQ(sequence.layout, "numbered");
  ASSERT_EQ(sequence.frames.size(), 2u);
  EXPECT_EQ(sequence.frames[0].path.filename(), "9.png");
  ASSERT_TRUE(sequence.camera);
  EXPECT_EQ(sequence.camera->pinhole.fy, 501.0);
}

// Pointed at the images of a TUM folder, one level too deep.
TEST(DepthSequence, NamesThatAreStampsAreStamps) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"1305031453.374112.png", "1305031454.005.PNG", "1305031453.404816.png"})
    write_file(folder / name, "");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  ASSERT_EQ(sequence.frames.size(), 3u);
  EXPECT_EQ(sequence.frames[0].stamp_s, 1305031453.374112);
  EXPECT_EQ(sequence.frames[1].stamp_s, 1305031453.404816);
  EXPECT_EQ(sequence.frames[2].stamp_s, 1305031454.005);
  write_file(folder / "1305031453374.png", "");
  EXPECT_THAT(folder_refusal(folder.path()), HasSubstr("write a depth.txt"));
}

TEST(DepthSequence, PathsInAListMayHaveBlanks) {
  const testing::TemporaryFolder folder;
  write_file(folder / "depth.txt", "1.0  my images/a 1.png \n");
  EXPECT_EQ(read_depth_sequence(folder.path()).frames[0].path, folder.path() / "my images/a 1.png");
}

TEST(DepthSequence, ADamagedTruthIsToldAndDoesNotStopAnyone) {
  const testing::TemporaryFolder folder;
  write_file(folder / "depth.txt", "1.0 a.png\n");
  write_file(folder / "groundtruth.txt", "1.0 2.0\n");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_FALSE(sequence.truth);
  EXPECT_THAT(sequence.truth_problem, HasSubstr("groundtruth.txt: line 1"));
}

TEST(DepthSequence, ADamagedCameraIsToldAndIsNotTheLayouts) {
  const testing::TemporaryFolder folder;
  write_file(folder / "frame-000000.depth.png", "");
  write_file(folder / "camera.json", "{");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_FALSE(sequence.camera);
  EXPECT_THAT(sequence.camera_problem, HasSubstr("camera.json: camera: the JSON is damaged"));
}

TEST(DepthSequence, AFoldersCameraComesWhole) {
  const testing::TemporaryFolder folder;
  write_file(folder / "frame-000000.depth.png", "");
  write_file(
      folder / "camera.json",
      R"({"intrinsic_matrix": [585,0,0, 0,586.5,0, 320,240,1], "distortion": [0.1,0,0,0,0], "readout_s": 0.02})");
  const DepthSequence sequence = read_depth_sequence(folder.path());
  EXPECT_EQ(sequence.camera->pinhole.fy, 586.5);
  EXPECT_EQ(sequence.camera->distortion.k1, 0.1);
  EXPECT_EQ(sequence.camera->readout_s, 0.02);
}

TEST(DepthSequence, WhatIsNoSequenceIsRefused) {
  const testing::TemporaryFolder folder;
  EXPECT_THAT(folder_refusal(folder / "missing"), HasSubstr("expected a folder of depth images"));
  EXPECT_THAT(folder_refusal(folder.path()), HasSubstr("found no image"));
  write_file(folder / "1.png", "");
  write_file(folder / "01.png", "");
  EXPECT_THAT(folder_refusal(folder.path()), HasSubstr("expected one image a number"));
  for (const auto& [list, message] : {std::pair{"1.0 a.png\nx b.png\n", "line 2: expected a time stamp"},
                                      std::pair{"nan a.png\n", "line 1: expected a time stamp"},
                                      std::pair{"1.0\n", "line 1: expected a time stamp and a path"},
                                      std::pair{"0 a.png\n1e15 b.png\n", "depth.txt: expected seconds, found stamps"},
                                      std::pair{"# nothing\n", "found no image"}}) {
    write_file(folder / "depth.txt", list);
    EXPECT_THAT(folder_refusal(folder.path()), HasSubstr(message)) << list;
  }
  EXPECT_THROW(read_depth_sequence(folder.path(), 0.0), std::invalid_argument);
}

// robustness 17: a truncated PNG in the middle.
TEST(DepthSequenceReader, GoesOnAfterADamagedImage) {
  const testing::TemporaryFolder folder;
  std::vector<DepthFrameFile> files;
  for (const char* name : {"0.png", "1.png", "2.png", "3.png"}) files.push_back({double(files.size()), folder / name});
  write_depth_png(files[0].path, flat(1.0f), 1000.0);
  write_depth_png(files[3].path, flat(2.0f), 1000.0);
  const std::string whole = read_bytes(files[0].path).bytes;
  write_file(files[1].path, whole.substr(0, whole.size() / 2));
  DepthSequenceReader reader(files, 1000.0);
  EXPECT_EQ(reader.next()->image.at(0, 0), 1.0f);
  const auto damaged = reader.next(), missing = reader.next(), last = reader.next();
  EXPECT_THAT(damaged->problem, HasSubstr("1.png"));
  EXPECT_THAT(missing->problem, HasSubstr("2.png"));
  EXPECT_EQ(last->problem, "");
  EXPECT_EQ(last->stamp_s, 3.0);
  EXPECT_EQ(last->image.at(1, 1), 2.0f);
  EXPECT_FALSE(reader.next());
}

TEST(DepthSequenceReader, AWrongDepthScaleEndsTheRunAtTheFirstImageWithReadings) {
  const testing::TemporaryFolder folder;
  write_depth_png(folder / "0.png", flat(std::numeric_limits<float>::quiet_NaN()), 1000.0);
  DepthImage speckle{20, 10, std::vector<float>(200, std::numeric_limits<float>::quiet_NaN())};
  speckle.depth[7] = 0.001f;
  write_depth_png(folder / "speckle.png", speckle, 1000.0);
  write_depth_png(folder / "1.png", flat(1.0f), 1000.0);
  DepthSequenceReader reader({{0.0, folder / "0.png"}, {0.5, folder / "speckle.png"}, {1.0, folder / "1.png"}}, 1.0);
  EXPECT_EQ(reader.next()->problem, "");
  EXPECT_EQ(reader.next()->problem, "");
  EXPECT_THROW(reader.next(), IoError);
  EXPECT_THROW(DepthSequenceReader({}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
