// SPDX-License-Identifier: MIT
#include "augicp/cloud/cloud.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

Cloud small_cloud() {
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, 1.0f}, {1.0f, -2.0f, 3.0f}};
  cloud.directions = {{0.0f, 0.0f, -1.0f}, {1.0f, 0.0f, 0.0f}};
  cloud.structures = {Structure::Planar, Structure::Edge};
  cloud.intensities = {0.5f, 7.0f};
  cloud.intensity_gradients = {{2.0f, 0.0f, 0.0f}, {0.0f, -3.0f, 1.0f}};
  Eigen::Matrix3f information;
  information << 4.0f, 1.0f, 0.0f, 1.0f, 3.0f, -1.0f, 0.0f, -1.0f, 2.0f;
  cloud.gaussians = {{{0.5f, 0.0f, 1.0f}, information}, {{1.0f, -2.0f, 2.5f}, 2.0f * information}};
  cloud.origin = {10.0, 20.0, 30.0};
  cloud.viewpoint = Vec3f(0.0f, 0.0f, 0.0f);
  return cloud;
}

TEST(Cloud, TransformMovesPointsAndTurnsDirections) {
  const Cloud cloud = small_cloud();
  for (const Rigid3& b_from_a : testing::awkward_poses()) {
    const Cloud moved = transform(cloud, b_from_a);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Vec3d expected = b_from_a * (cloud.origin + cloud.points[i].cast<double>());
      EXPECT_THAT(moved.origin + moved.points[i].cast<double>(), testing::NearVector(expected, 1e-6));
      EXPECT_THAT(moved.directions[i].cast<double>(),
                  testing::NearVector(b_from_a.rotation * cloud.directions[i].cast<double>(), 1e-6));
      EXPECT_THAT(moved.intensity_gradients[i].cast<double>(),
                  testing::NearVector(b_from_a.rotation * cloud.intensity_gradients[i].cast<double>(), 2e-6));
    }
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const PointGaussian &before = cloud.gaussians[i], &after = moved.gaussians[i];
      EXPECT_THAT(moved.origin + after.mean.cast<double>(),
                  testing::NearVector(b_from_a * (cloud.origin + before.mean.cast<double>()), 1e-6));
      for (const Vec3d& error : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(1, 2, -3)}) {
        const Vec3d turned = b_from_a.rotation * error;
        EXPECT_NEAR(turned.dot(after.information.cast<double>() * turned),
                    error.dot(before.information.cast<double>() * error), 1e-4);
      }
    }
    EXPECT_EQ(moved.intensities, cloud.intensities);
    EXPECT_THAT(moved.origin + moved.viewpoint->cast<double>(), testing::NearVector(b_from_a * cloud.origin, 1e-6));
  }
}

TEST(Cloud, FarOriginCostsNoPrecision) {
  Cloud cloud = small_cloud();
  const std::vector<Vec3f> before = cloud.points;
  cloud = transform(cloud, Rigid3{Eigen::Quaterniond::Identity(), Vec3d(5e6, 4e5, 1e3)});
  EXPECT_EQ(cloud.points, before);
}

TEST(Cloud, OriginsComposeBothWays) {
  Cloud source = small_cloud(), target = small_cloud();
  target.origin = {-5.0, 7.0, 1e6};
  for (const Rigid3& target_from_source : testing::awkward_poses()) {
    const Rigid3 between_points = without_origins(target_from_source, source, target);
    const Vec3d point = source.points[1].cast<double>();
    EXPECT_THAT(target.origin + between_points * point,
                testing::NearVector(target_from_source * (source.origin + point), 1e-9));
    EXPECT_THAT(with_origins(between_points, source, target), testing::NearPose(target_from_source, 1e-14, 1e-9));
  }
}

TEST(Cloud, BoundsHoldEveryPoint) {
  const Bounds box = bounds(small_cloud());
  EXPECT_EQ(box.min, Vec3f(0.0f, -2.0f, 1.0f));
  EXPECT_EQ(box.max, Vec3f(1.0f, 0.0f, 3.0f));
  EXPECT_DOUBLE_EQ(box.diagonal(), 3.0);
  EXPECT_EQ(bounds(Cloud{}).diagonal(), 0.0);
}

TEST(Cloud, BoundsAreThoseOfAnyNumberOfPoints) {
  std::mt19937 generator(1);
  std::normal_distribution<float> normal(3.0f, 1.0f);
  Cloud cloud;
  Bounds expected{Vec3f::Constant(std::numeric_limits<float>::infinity()),
                  Vec3f::Constant(-std::numeric_limits<float>::infinity())};
  for (int count = 1; count < 200; ++count) {
    cloud.points.emplace_back(normal(generator), -normal(generator), normal(generator));
    expected.min = expected.min.cwiseMin(cloud.points.back());
    expected.max = expected.max.cwiseMax(cloud.points.back());
    EXPECT_EQ(bounds(cloud).min, expected.min);
    EXPECT_EQ(bounds(cloud).max, expected.max);
  }
}

}  // namespace
}  // namespace augicp
