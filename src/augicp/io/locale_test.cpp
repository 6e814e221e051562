// SPDX-License-Identifier: MIT
// Files of poses and cameras in a locale with a decimal comma; clouds and single numbers have their own test.
#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "augicp/io/camera_file.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/io/transform_file.h"
#include "augicp/testing/decimal_comma.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

class Locale : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::DecimalComma::exists()) GTEST_SKIP() << "no locale de_DE.UTF-8, and the build could make none";
  }
};

TEST_F(Locale, HasACommaForPrintfAndStreams) {
  const testing::DecimalComma comma;
  char text[8];
  std::snprintf(text, sizeof(text), "%.1f", 1.5);
  EXPECT_STREQ(text, "1,5");
  std::ostringstream stream;
  stream << 1.5;
  EXPECT_EQ(stream.str(), "1,5");
}

// Every pose as a transform and as a line of a trajectory, and all of it as it stands in the files.
std::string written(const std::filesystem::path& folder) {
  std::string bytes;
  Trajectory trajectory;
  for (const Rigid3& pose : testing::awkward_poses()) {
    write_transform(folder / "T.txt", pose);
    bytes += read_bytes(folder / "T.txt").bytes;
    trajectory.push_back({0.125 + static_cast<double>(trajectory.size()), pose});
  }
  write_tum_trajectory(folder / "poses.txt", trajectory);
  return bytes + read_bytes(folder / "poses.txt").bytes;
}

// robustness 6
TEST_F(Locale, PosesAreWrittenWithTheSameBytes) {
  const testing::TemporaryFolder folder;
  const std::string expected = written(folder.path());
  const testing::DecimalComma comma;
  EXPECT_EQ(written(folder.path()), expected);
}

TEST_F(Locale, PosesAndCamerasAreReadWithAPoint) {
  const testing::DecimalComma comma;
  EXPECT_EQ(parse_transform(R"({"T_target_source": [1,0,0,0.5, 0,1,0,-2.25, 0,0,1,1.5e-3, 0,0,0,1]})").translation,
            Vec3d(0.5, -2.25, 1.5e-3));
  EXPECT_EQ(parse_transform("1 0 0 0.5 0 1 0 -2.25 0 0 1 1.5e-3 0 0 0 1").translation, Vec3d(0.5, -2.25, 1.5e-3));
  EXPECT_EQ(parse_tum_trajectory({"", "1.5 0.5 0 0 0 0 0 1\n"}).trajectory[0].stamp_s, 1.5);
  EXPECT_EQ(parse_camera({"", R"({"intrinsic_matrix": [585,0,0, 0,586.5,0, 320,240.25,1]})"}).pinhole.fy, 586.5);
  EXPECT_EQ(read_camera("585 586.5 320 240.25").pinhole.fy, 586.5);
}

}  // namespace
}  // namespace augicp
