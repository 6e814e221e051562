// SPDX-License-Identifier: MIT
#include "augicp/io/camera_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "augicp/io/atomic_file.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

std::string camera_refusal(const std::string& text) {
  try {
    parse_camera({"camera.txt", text});
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

void expect_camera(const DepthCamera& depth_camera, int width, int height) {
  const Pinhole& camera = depth_camera.pinhole;
  EXPECT_EQ(camera.fx, 585.0);
  EXPECT_EQ(camera.fy, 586.5);
  EXPECT_EQ(camera.cx, 320.0);
  EXPECT_EQ(camera.cy, 240.25);
  EXPECT_EQ(camera.width, width);
  EXPECT_EQ(camera.height, height);
}

TEST(CameraFile, EveryFormMeansTheSameCamera) {
  const testing::TemporaryFolder folder;
  write_file(folder / "c.txt", "585 586.5 320 240.25\n");
  expect_camera(read_camera((folder / "c.txt").string()), 0, 0);
  expect_camera(read_camera("585 586.5 320 240.25"), 0, 0);
  expect_camera(read_camera("585,586.5,320,240.25"), 0, 0);
  expect_camera(parse_camera({"", "5.85e+02 0 3.2e+02\n0 586.5 240.25\n0 0 1\n"}), 0, 0);
  expect_camera(
      parse_camera({"", R"({"width": 640, "height": 480, "intrinsic_matrix": [585,0,0, 0,586.5,0, 320,240.25,1]})"}),
      640, 480);
}

TEST(CameraFile, ALensFollowsThePinhole) {
  const DepthCamera from_numbers = read_camera("585 586.5 320 240.25 0.1 -0.2 0.003 0.004 0.5");
  expect_camera(from_numbers, 0, 0);
  const DepthCamera from_json = parse_camera({"", R"({"intrinsic_matrix": [585,0,0, 0,586.5,0, 320,240.25,1],
      "distortion": [0.1, -0.2, 0.003, 0.004, 0.5], "readout_s": 0.03})"});
  expect_camera(from_json, 0, 0);
  EXPECT_EQ(from_numbers.readout_s, 0.0);
  EXPECT_EQ(from_json.readout_s, 0.03);
  for (const Distortion& lens : {from_numbers.distortion, from_json.distortion}) {
    EXPECT_EQ(lens.k1, 0.1);
    EXPECT_EQ(lens.k2, -0.2);
    EXPECT_EQ(lens.p1, 0.003);
    EXPECT_EQ(lens.p2, 0.004);
    EXPECT_EQ(lens.k3, 0.5);
  }
}

// As ScanNet, librealsense, ROS and OpenCV write them.
TEST(CameraFile, OtherProgramsWriteTheSameCamera) {
  expect_camera(parse_camera({"", "585 0 320 0\n0 586.5 240.25 0\n0 0 1 0\n0 0 0 1\n"}), 0, 0);
  expect_camera(
      parse_camera(
          {"", R"({"width": 640, "height": 480, "intrinsic_matrix": [[585,0,320], [0,586.5,240.25], [0,0,1]]})"}),
      640, 480);
  expect_camera(parse_camera({"", R"({"width": 640, "height": 480, "fx": 585, "fy": 586.5, "ppx": 320, "ppy": 240.25,
      "model": "distortion.inverse_brown_conrady", "coeffs": [0, 0, 0, 0, 0]})"}),
                640, 480);
  const std::string ros =
      "image_width: 640\nimage_height: 480\ncamera_name: depth\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
      "  data: [585, 0, 320, 0, 586.5, 240.25,\n    0, 0, 1]\ndistortion_model: plumb_bob\ndistortion_coefficients:\n"
      "  rows: 1\n  cols: 5\n  data: [0.1, -0.2, 0.003, 0.004, 0.5]\n";
  expect_camera(parse_camera({"", ros}), 640, 480);
  EXPECT_EQ(parse_camera({"", ros}).distortion.p2, 0.004);
  expect_camera(
      parse_camera(
          {"",
           "height: 480\nwidth: 640\ndistortion_model: \"\"\nd: []\nk: [585, 0, 320, 0, 586.5, 240.25, 0, 0, 1]\n"}),
      640, 480);
  expect_camera(parse_camera({"",
                              "%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                              "   data: [ 585., 0., 320., 0., 586.5,\n       240.25, 0., 0., 1. ]\n"
                              "distortion_coefficients: !!opencv-matrix\n   data: [ 0., 0., 0., 0. ]\n"}),
                0, 0);
}

// As kalibr, EuRoC, ORB-SLAM, ros2 topic echo, Open3D's views and people write them.
TEST(CameraFile, FormsOfRobotsAndNotesAreRead) {
  const char* matrix = R"("height": 480, "width": 640, "intrinsic_matrix": [585,0,0, 0,586.5,0, 320,240.25,1])";
  for (const std::string& text :
       {std::string("cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.1, 0, 0, 0]\n  distortion_model: radtan\n"
                    "  intrinsics: [585.0, 586.5, 320, 240.25]\n  resolution: [640, 480]\n"),
        std::string(
            "sensor_type: camera\nresolution: [640, 480]\nintrinsics: [585, 586.5, 320, 240.25] #fu, fv, cu, cv\n"
            "distortion_model: radial-tangential\ndistortion_coefficients: [0.1, 0, 0, 0]\n"),
        std::string("%YAML:1.0\nCamera.type: \"PinHole\"\nCamera.fx: 585 # pixels\nCamera.fy: 586.5\nCamera.cx: 320\n"
                    "Camera.cy: 240.25\nCamera.k1: 0.1\nCamera.width: 640\nCamera.height: 480\n"),
        std::string(
            "height: 480\nwidth: 640\ndistortion_model: plumb_bob\nd:\n- 0.1\n- 0\n- 0\n- 0\n- 0\nk:\n- 585.0\n- 0\n"
            "- 320\n- 0\n- 586.5\n- 240.25\n- 0\n- 0\n- 1\nr:\n- 1\n")}) {
    expect_camera(parse_camera({"", text}), 640, 480);
    EXPECT_EQ(parse_camera({"", text}).distortion.k1, 0.1) << text;
  }
  expect_camera(parse_camera({"", std::string(R"({"extrinsic": [1], "intrinsic": {)") + matrix + "}}"}), 640, 480);
  for (const char* text :
       {"fx: 585\nfy: 586.5\ncx: 320\ncy: 240.25\n", "fx=585\nfy = 586.5\ncx=320\ncy=240.25\n",
        R"({"K": [[585,0,320], [0,586.5,240.25], [0,0,1]]})",
        R"({"camera_matrix": [585,0,320, 0,586.5,240.25, 0,0,1]})",
        "[[585.   0.   320.  ]\n [  0.  586.5 240.25]\n [  0.    0.    1.  ]]\n",
        "[[585, 0, 320],\n [0, 586.5, 240.25],\n [0, 0, 1]]\n", "585 0 320 0\n0 586.5 240.25 0\n0 0 1 0\n"})
    expect_camera(parse_camera({"", text}), 0, 0);
}

TEST(CameraFile, NamesBringTheirDepthScale) {
  for (const std::string& name : camera_names()) EXPECT_TRUE(depth_scale_of_camera(name)) << name;
  EXPECT_EQ(depth_scale_of_camera("tum-fr1"), 5000.0);
  EXPECT_EQ(depth_scale_of_camera("7scenes"), 1000.0);
  EXPECT_FALSE(depth_scale_of_camera("585 586.5 320 240.25"));
}

TEST(CameraFile, KnownNamesComeWithTheirImageSize) { EXPECT_EQ(read_camera("tum-fr1").pinhole.width, 640); }

TEST(CameraFile, AnUnknownNameListsTheKnownOnes) {
  try {
    read_camera("tum-fr9");
    ADD_FAILURE();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("camera 'tum-fr9'"));
    for (const std::string& name : camera_names()) EXPECT_THAT(error.what(), ::testing::HasSubstr(name));
  }
}

// robustness 1
TEST(CameraFile, DeepJsonIsRefused) {
  constexpr std::size_t kDeep = 400000;
  const std::string lists = std::string(kDeep, '[') + std::string(kDeep, ']');
  EXPECT_THAT(camera_refusal(R"({"intrinsic": {"a": )" + lists + "}}"), ::testing::HasSubstr("less deep than"));
}

TEST(CameraFile, WhatIsNoCameraIsRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "found 0 numbers"},
      {"1 2 3", "found 3 numbers"},
      {"585 x 320 240", "line 1: expected a number, found 'x'"},
      {"0 585 320 240", "fx"},
      {"585 nan 320 240", "fy"},
      {"585 1 320 0 585 240 0 0 1", "no skew"},
      {"585 0 320 1 0 585 240 0 0 0 1 0 0 0 0 1", "of the identity"},
      {"camera_matrix:\n  rows: 3\n", "expected data"},
      {"k: [585, 0, 320\n", "list in brackets"},
      {"k: [585, 0, 320]\n", "found 3 numbers"},
      {"k: [585, 0, 320, 0, 586.5, 240.25, 0, 0, 1]\n", "may be cut"},
      {"k: [585, x, 320]\n", "expected a number"},
      {"distortion_model: equidistant\nk: [585, 0, 320, 0, 586.5, 240.25, 0, 0, 1]\n", "plumb_bob"},
      {R"({"fx": 1, "fy": 1, "ppx": 1})", "\"ppy\""},
      {R"({"fx": 500, "fy": 500, "ppx": 1, "ppy": 1, "model": "Inverse Brown Conrady", "coeffs": [0.1,0,0,0,0]})",
       "inverse"},
      {"cam0:\n  intrinsics: [1, 1, 1, 1]\ncam1:\n  intrinsics: [1, 1, 1, 1]\n", "expected one camera"},
      {"intrinsics: [585, 586.5, 320]\n", "fx fy cx cy"},
      {"camera_model: omni\nintrinsics: [585, 586.5, 320, 240]\n", "expected the camera_model pinhole, found 'omni'"},
      {"Camera.type: \"KannalaBrandt8\"\nCamera.fx: 585\n", "expected the type PinHole"},
      {"fx: 585\nfy: 585\ncx: 320\n", "expected \"cy\" with one number"},
      {"intrinsics: [585, 586.5, 320, 240]\nresolution: [640]\n", "a width and a height"},
      {"k:\n- 585\n- 1 2\n", "expected '- number'"},
      {"585 0 320 1\n0 586.5 240.25 0\n0 0 1 0\n", "3x4 matrix with the last row"},
      {"{", "JSON is damaged"},
      {"{}", "expected \"intrinsic_matrix\""},
      {R"({"intrinsic_matrix": [1, 2]})", "expected \"intrinsic_matrix\""},
      {R"({"intrinsic_matrix": [585,0,0, 0,585,0, 320,240,"1"]})", "expected numbers"},
      {"585 585 320 240 1e9 0 0 0 0", "k1"},
      {R"({"distortion": [1, 2], "intrinsic_matrix": [585,0,0, 0,585,0, 320,240,1]})", "k1 k2 p1 p2 k3"},
      {R"({"readout_s": [1, 2], "intrinsic_matrix": [585,0,0, 0,585,0, 320,240,1]})", "one number of seconds"},
      {R"({"readout_s": -1, "intrinsic_matrix": [585,0,0, 0,585,0, 320,240,1]})", "readout_s"},
      {R"({"width": 1e99, "intrinsic_matrix": [585,0,0, 0,585,0, 320,240,1]})", "expected \"width\" in pixels"},
      {R"({"width": -1, "intrinsic_matrix": [585,0,0, 0,585,0, 320,240,1]})", "expected \"width\" in pixels"}};
  for (const auto& [text, message] : cases) EXPECT_THAT(camera_refusal(text), ::testing::HasSubstr(message)) << text;
  try {
    read_camera("585 585 320");
    ADD_FAILURE();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("'585 585 320': camera: expected fx"));
  }
  EXPECT_THROW(read_camera(std::filesystem::temp_directory_path().string()), IoError);
}

}  // namespace
}  // namespace augicp
