// SPDX-License-Identifier: MIT
#include "augicp/io/write_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "augicp/io/atomic_file.h"
#include "augicp/io/read_cloud.h"
#include "augicp/testing/decimal_comma.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

Cloud random_cloud(const Vec3d& origin, bool has_directions) {
  std::mt19937 generator(11);
  Cloud cloud;
  cloud.origin = origin;
  for (int i = 0; i < 500; ++i) {
    cloud.points.push_back((10.0 * testing::random_direction(generator)).cast<float>());
    if (!has_directions) continue;
    cloud.intensities.push_back(static_cast<float>(testing::uniform(generator, -1.0, 300.0)));
    const auto structure = static_cast<Structure>(i % 3);
    cloud.structures.push_back(structure);
    cloud.directions.push_back(structure == Structure::None
                                   ? Vec3f(Vec3f::Zero())
                                   : Vec3f(testing::random_direction(generator).cast<float>()));
  }
  return cloud;
}

void write(const std::filesystem::path& path, const Cloud& cloud, FileEncoding encoding) {
  if (path.extension() == ".ply") return write_ply(path, cloud, {}, encoding);
  write_pcd(path, cloud, encoding);
}

void expect_equal(const Cloud& found, const Cloud& expected) {
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_EQ(found.structures, expected.structures);
  EXPECT_EQ(found.has_directions(), expected.has_directions());
  EXPECT_EQ(found.intensities, expected.intensities);
  if (expected.origin.isZero(0.0)) {
    EXPECT_EQ(found.points, expected.points);
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    // The origin may be another, and float then rounds elsewhere: of 10 m, to a micrometre.
    const Vec3d place = expected.origin + expected.points[i].cast<double>();
    EXPECT_THAT(found.origin + found.points[i].cast<double>(), testing::NearVector(place, 1e-6));
    if (found.has_directions()) {
      EXPECT_LE((found.directions[i] - expected.directions[i]).norm(), 1e-7f);  // normalised again
    }
  }
}

constexpr const char* kNames[] = {"cloud.ply", "cloud.pcd"};
constexpr FileEncoding kEncodings[] = {FileEncoding::Binary, FileEncoding::Ascii};

// Without directions, and with unknown intensities, which do not equal themselves.
TEST(WriteCloud, IntensitiesSurvive) {
  const testing::TemporaryFolder folder;
  for (const char* name : kNames)
    for (const FileEncoding encoding : kEncodings) {
      Cloud cloud = random_cloud(Vec3d::Zero(), false);
      for (std::size_t i = 0; i < cloud.size(); ++i) cloud.intensities.push_back(0.1f * static_cast<float>(i));
      cloud.intensities[7] = std::numeric_limits<float>::quiet_NaN();
      write(folder / name, cloud, encoding);
      const std::vector<float> found = read_cloud(folder / name).cloud.intensities;
      ASSERT_EQ(found.size(), cloud.size());
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_TRUE(i == 7 ? std::isnan(found[i]) : found[i] == cloud.intensities[i]) << name << " " << i;
      cloud.intensities.pop_back();
      EXPECT_THROW(write(folder / name, cloud, encoding), std::invalid_argument);
    }
}

// robustness 6
TEST(WriteCloud, WriteThenReadIsIdentity) {
  const testing::TemporaryFolder folder;
  for (const char* name : kNames)
    for (const FileEncoding encoding : kEncodings)
      for (const bool has_directions : {false, true})
        for (const double offset : {0.0, 1024.0, 1e6, 1e7}) {
          SCOPED_TRACE(std::string(name) + (encoding == FileEncoding::Ascii ? " ascii " : " binary ") +
                       std::to_string(offset));
          const Cloud cloud = random_cloud(Vec3d(offset, -offset, 0.5 * offset), has_directions);
          write(folder / name, cloud, encoding);
          const CloudFile file = read_cloud(folder / name);
          expect_equal(file.cloud, cloud);
          EXPECT_THAT(file.report.warnings, ::testing::IsEmpty());
        }
}

TEST(WriteCloud, MoreThanABufferHoldsSurvives) {
  const testing::TemporaryFolder folder;
  Cloud cloud = random_cloud(Vec3d::Zero(), false);
  const std::vector<Vec3f> few = cloud.points;
  while (cloud.size() < 200000) cloud.points.insert(cloud.points.end(), few.begin(), few.end());
  for (const FileEncoding encoding : kEncodings) {
    write(folder / "cloud.ply", cloud, encoding);
    EXPECT_EQ(read_cloud(folder / "cloud.ply").cloud.points, cloud.points);
  }
}

// robustness 6
TEST(WriteCloud, TheLocaleDoesNotMatter) {
  if (!testing::DecimalComma::exists()) GTEST_SKIP() << "no locale de_DE.UTF-8, and the build could make none";
  const testing::DecimalComma comma;
  const testing::TemporaryFolder folder;
  const Cloud cloud = random_cloud(Vec3d(1e6, 0.5, 0.0), true);
  for (const char* name : kNames) {
    write(folder / name, cloud, FileEncoding::Ascii);
    expect_equal(read_cloud(folder / name).cloud, cloud);
  }
}

TEST(WriteCloud, ColoursFollowThePositions) {
  const testing::TemporaryFolder folder;
  Cloud cloud;
  cloud.points = {{1, 2, 3}, {0.1f, 0, -1}};
  write_ply(folder / "c.ply", cloud, std::vector<Colour>{{255, 0, 1}, {2, 3, 4}}, FileEncoding::Ascii);
  EXPECT_EQ(
      read_bytes(folder / "c.ply").bytes,
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n1 2 3 255 0 1\n0.1 0 -1 2 3 4\n");
}

TEST(WriteCloud, PcdKeepsTheViewpoint) {
  const testing::TemporaryFolder folder;
  Cloud cloud = random_cloud(Vec3d(1e6, 0.0, 0.0), false);
  cloud.viewpoint = Vec3f(0.5f, 1.5f, -20.0f);
  write_pcd(folder / "c.pcd", cloud);
  const Cloud found = read_cloud(folder / "c.pcd").cloud;
  ASSERT_TRUE(found.viewpoint);
  EXPECT_EQ(Vec3d(found.origin + found.viewpoint->cast<double>()), Vec3d(1e6 + 0.5, 1.5, -20.0));
}

TEST(WriteCloud, ArgumentsAreChecked) {
  const testing::TemporaryFolder folder;
  const Cloud cloud = random_cloud(Vec3d::Zero(), false);
  EXPECT_THROW(write_cloud(folder / "c.ply", Cloud{}), std::invalid_argument);
  EXPECT_THROW(write_ply(folder / "c.ply", cloud, std::vector<Colour>(3)), std::invalid_argument);
  EXPECT_THROW(write_cloud(folder / "c.xyz", cloud), IoError);
  Cloud without_structures = random_cloud(Vec3d::Zero(), true);
  without_structures.structures.clear();
  EXPECT_THROW(write_cloud(folder / "c.ply", without_structures), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// robustness 9
TEST(WriteCloud, AFullDiskIsAnErrorAndLeavesNothing) {
  const testing::TemporaryFolder folder;
  const Cloud cloud = random_cloud(Vec3d::Zero(), true);
  EXPECT_THROW(write_cloud(folder / "absent" / "c.ply", cloud), IoError);
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_THROW(write_ply("/dev/full", cloud), IoError);
  EXPECT_THROW(write_pcd("/dev/full", cloud), IoError);
}

TEST(ReadCloud, AnUnknownExtensionIsRefusedWithTheKnownOnes) {
  const testing::TemporaryFolder folder;
  write_file(folder / "cloud.off", "OFF\n");
  try {
    read_cloud(folder / "cloud.off");
    FAIL() << "no error";
  } catch (const IoError& error) {
    for (const char* part :
         {"cloud.off", ".ply .pcd .las .laz .xyz", ".stl .obj .glb .gltf", "found '.off'", "export it as .ply"})
      EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
  }
}

}  // namespace
}  // namespace augicp
