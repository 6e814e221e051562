// SPDX-License-Identifier: MIT
// robustness 13: what spoils clouds may spoil the result too, but a wrong pose is never called converged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

const Rigid3 kLargeMotion{Eigen::Quaterniond(Eigen::AngleAxisd(0.12, Vec3d(0.6, 0.64, 0.48))), {0.1, -0.05, 0.1}};

bool is_near(const Rigid3& found, const Rigid3& expected) {
  return angle_between(found, expected) < 0.05 && (found.translation - expected.translation).norm() < 0.1;
}

// The pair as bare clouds, the source corrupted. True if the pose is right.
bool registers(const std::function<void(Cloud&, std::mt19937&)>& spoil) {
  const testing::ScanPair pair = testing::room_pair(kLargeMotion);
  Cloud source = pair.source.cloud;
  std::mt19937 generator(5);
  spoil(source, generator);
  const AlignResult result = register_scans(scan_of(source), scan_of(pair.target.cloud)).result;
  const bool is_right = is_near(result.target_from_source, pair.target_from_source);
  EXPECT_TRUE(is_right || result.status != AlignStatus::Converged);
  return is_right;
}

Vec3f anywhere(const Bounds& box, std::mt19937& generator) {
  Vec3f point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(testing::uniform(generator, box.min[axis], box.max[axis]));
  return point;
}

TEST(Robustness13, TenfoldNoise) {
  EXPECT_TRUE(registers([](Cloud& cloud, std::mt19937& generator) {
    for (Vec3f& point : cloud.points)
      for (int axis = 0; axis < 3; ++axis)
        point[axis] += static_cast<float>(10.0 * testing::kKinectSigmaAt1m * testing::gaussian(generator));
  }));
}

Cloud one_of(std::uint32_t step, const Cloud& cloud) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < cloud.size(); i += step) chosen.push_back(i);
  return select(cloud, chosen);
}

// On every sixth point, because vain searches take long.
TEST(Robustness13, OutliersFromATenthToFourFifths) {
  for (const double share : testing::cases({0.8, 0.1, 0.4}, 1)) {
    const bool is_right = registers([&](Cloud& cloud, std::mt19937& generator) {
      cloud = one_of(6, cloud);
      const Bounds box = bounds(cloud);
      for (Vec3f& point : cloud.points)
        if (testing::uniform(generator, 0.0, 1.0) < share) point = anywhere(box, generator);
    });
    EXPECT_TRUE(is_right || share > 0.1) << share;
  }
}

TEST(Robustness13, AThirdMoves) {
  registers([](Cloud& cloud, std::mt19937&) {
    const Bounds box = bounds(cloud);
    const float limit = box.min.x() + 0.3f * (box.max.x() - box.min.x());
    for (Vec3f& point : cloud.points)
      if (point.x() < limit) point += Vec3f(0.0f, 0.3f, 0.0f);
  });
}

// Normals from the file, half of them flipped: without the sensor's position their sign has no meaning.
TEST(Robustness13, NormalsTurnedRound) {
  const testing::ScanPair pair = testing::room_pair(kLargeMotion);
  const Lengths lengths = lengths_for(pair.source, pair.target, {});
  Scan source = scan_of(prepare(pair.source, lengths, {}).cloud),
       target = scan_of(prepare(pair.target, lengths, {}).cloud);
  source.cloud.viewpoint.reset();
  target.cloud.viewpoint.reset();
  std::mt19937 generator(5);
  for (Vec3f& direction : source.cloud.directions)
    if (generator() % 2 == 0) direction = -direction;
  EXPECT_TRUE(is_near(register_scans(source, target).result.target_from_source, pair.target_from_source));
}

TEST(Robustness13, OnePointOfAHundred) {
  registers([](Cloud& cloud, std::mt19937&) { cloud = one_of(100, cloud); });
}

}  // namespace
}  // namespace augicp
