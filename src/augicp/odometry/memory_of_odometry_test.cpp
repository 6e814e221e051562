// SPDX-License-Identifier: MIT
// The bounds on memory of both odometries: refused before any work, with advice that is enough.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <string>

#include "augicp/odometry/depth_memory.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"

namespace augicp {
namespace {

constexpr double kVoxel = 0.1;

// Scans of a sensor that walks along a street, with voxels far smaller than the derived ones.
Cloud scan_at(int k) {
  const testing::Scene street = synthetic::street(5);
  synthetic::Lidar lidar;
  lidar.num_rings = 32;
  lidar.num_azimuths = 360;
  const Rigid3 place = street.world_from_camera * Rigid3{Eigen::Quaterniond::Identity(), {0.5 * k, 0.0, 0.0}};
  return synthetic::scan(street, lidar, place, static_cast<unsigned>(k + 1));
}

LidarOptions options_with(double max_memory_gb, double voxel_size = kVoxel) {
  LidarOptions options;
  options.num_threads = 1;
  options.voxel_size = voxel_size;
  options.max_memory_gb = max_memory_gb;
  return options;
}

// The number after a word of an error's message; NaN if it is not there.
double number_after(const std::string& word, const std::string& message) {
  std::smatch found;
  const bool has_it = std::regex_search(message, found, std::regex(word + " ([0-9.]+)"));
  return has_it ? std::stod(found[1]) : std::numeric_limits<double>::quiet_NaN();
}

template <typename Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const TooMuchMemory& error) {
    return error.what();
  }
  return "";
}

TEST(MemoryOfOdometry, GrowsWithEachOfItsParts) {
  const LidarMemory memory{100, 100, 100};
  EXPECT_GT((LidarMemory{200, 100, 100}.gb()), memory.gb());
  EXPECT_GT((LidarMemory{100, 200, 100}.gb()), memory.gb());
  EXPECT_GT((LidarMemory{100, 100, 200}.gb()), memory.gb());
}

TEST(MemoryOfOdometry, AScanBeyondTheBoundIsRefusedAndTheAdviceIsEnough) {
  const Cloud scan = scan_at(0);
  LidarOdometry odometry(options_with(0.025));
  const std::string message = refusal([&] { odometry.add(0.0, scan); });
  EXPECT_EQ(odometry.num_voxels(), 0u);
  EXPECT_EQ(odometry.voxel_size(), 0.0);
  const double enough = number_after("use voxel_size", message);
  ASSERT_GT(enough, kVoxel) << message;
  LidarOdometry coarser(options_with(0.025, enough));
  EXPECT_EQ(coarser.add(0.0, scan).status, FrameStatus::Started);
}

// The bound leaves room for the first scan, and not for the map that grows. What was done before stays.
TEST(MemoryOfOdometry, AMapThatGrowsBeyondTheBoundKeepsWhatItHas) {
  LidarOdometry measured(options_with(1.0));
  measured.add(0.0, scan_at(0));
  const double max_gb = measured.memory_gb() + 0.012;
  LidarOdometry odometry(options_with(max_gb)), unbounded(options_with(std::numeric_limits<double>::infinity()));
  std::string message;
  int k = 0;
  for (; k < 40 && message.empty(); ++k) {
    const Cloud scan = scan_at(k);
    const std::size_t before = odometry.num_voxels();
    FrameReport report;
    message = refusal([&] { report = odometry.add(0.1 * k, scan); });
    if (message.empty()) {
      EXPECT_EQ(report.world_from_camera.matrix(), unbounded.add(0.1 * k, scan).world_from_camera.matrix());
    } else {
      EXPECT_EQ(odometry.num_voxels(), before);
    }
  }
  EXPECT_GT(k, 2);
  EXPECT_THAT(message, ::testing::HasSubstr("max_memory_gb"));
  EXPECT_FALSE(odometry.map().empty());
}

TEST(MemoryOfOdometry, ImagesBeyondTheBoundAreRefusedAndTheAdviceIsEnough) {
  OdometryOptions options;
  options.registration.max_memory_gb = 0.1;
  const std::string message = refusal([&] { require_memory(4000, 3000, 1, options); });
  EXPECT_THAT(message, ::testing::HasSubstr("4000 x 3000"));
  EXPECT_TRUE(std::isnan(number_after("pixel_step", message)));  // the image alone is too large
  options.registration.max_memory_gb = 0.5;
  const double enough = number_after("use pixel_step", refusal([&] { require_memory(4000, 3000, 1, options); }));
  ASSERT_GT(enough, 1.0);
  EXPECT_NO_THROW(require_memory(4000, 3000, static_cast<int>(enough), options));
  EXPECT_THROW(require_memory(4000, 3000, static_cast<int>(enough) - 1, options), TooMuchMemory);
}

}  // namespace
}  // namespace augicp
