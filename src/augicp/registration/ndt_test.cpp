// SPDX-License-Identifier: MIT
// Registration with NDT's objective, Eq. (2): points against the Gaussians of the target.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "augicp/registration/registration.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/gaussians.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

RegistrationOptions ndt() {
  RegistrationOptions options;
  options.method = Method::Ndt;
  return options;
}

testing::ScanPair drawn_pair(unsigned seed, bool as_clouds) {
  std::mt19937 generator(seed);
  testing::ScanPair pair = testing::room_pair(testing::random_motion(generator, 0.05, 0.05));
  if (as_clouds) pair.source = scan_of(pair.source.cloud), pair.target = scan_of(pair.target.cloud);
  return pair;
}

TEST(Ndt, ImagesAndCloudsMeet) {
  for (const Preset preset : {Preset::Default, Preset::Paper})
    for (const bool as_clouds : {false, true})
      for (const unsigned seed : testing::cases({1u, 2u, 3u}, 1)) {
        const testing::ScanPair pair = drawn_pair(seed, as_clouds);
        RegistrationOptions options = ndt();
        options.preset = preset;
        const AlignResult result = register_scans(pair.source, pair.target, {}, options).result;
        EXPECT_EQ(result.status, AlignStatus::Converged) << seed << as_clouds;
        EXPECT_THAT(result.target_from_source, testing::NearPose(pair.target_from_source, 0.01, 0.03)) << seed;
        EXPECT_TRUE(result.covariance || preset == Preset::Paper) << seed << as_clouds;
      }
}

TEST(Ndt, SameBitsForAnyNumberOfThreads) {
  for (const bool as_clouds : {false, true}) {
    const testing::ScanPair pair = drawn_pair(4, as_clouds);
    RegistrationOptions options = ndt();
    options.num_threads = 1;
    const AlignResult expected = register_scans(pair.source, pair.target, {}, options).result;
    for (const int num_threads : {2, 3, 8}) {
      options.num_threads = num_threads;
      const AlignResult result = register_scans(pair.source, pair.target, {}, options).result;
      EXPECT_EQ(result.target_from_source.matrix(), expected.target_from_source.matrix()) << num_threads;
      EXPECT_EQ(result.information, expected.information) << num_threads;
    }
  }
}

// One set of defaults for a bunny and a building.
TEST(Ndt, TheUnitOfLengthDoesNotMatter) {
  testing::ScanPair pair = drawn_pair(5, true);
  const AlignResult expected = register_scans(pair.source, pair.target, {}, ndt()).result;
  for (Scan* scan : {&pair.source, &pair.target}) {
    for (Vec3f& point : scan->cloud.points) point *= 32.0f;
    if (scan->cloud.viewpoint) *scan->cloud.viewpoint *= 32.0f;
  }
  Rigid3 pose = register_scans(pair.source, pair.target, {}, ndt()).result.target_from_source;
  pose.translation /= 32.0;
  EXPECT_THAT(pose, testing::NearPose(expected.target_from_source, 1e-4, 1e-4));
}

// Of a flat square the rest is the softening: a thousandth, as in Table 2.
TEST(Ndt, APlaneHoldsExactlyItsThreeMotions) {
  Cloud target = testing::random_points(4000, 1.0, 6);
  for (Vec3f& point : target.points) point.z() = 0.0f;
  const double radius = 0.2;
  estimate_gaussians(target, BallNeighbourhood(target, {radius, 0, 0.0}, 1), radius, 1);
  std::vector<Correspondence> pairs;
  for (std::uint32_t i = 0; i < target.size(); ++i) pairs.push_back({i, i});
  const Mat6d H = linearize({target, target, pairs, {}}, {ndt_information()}, 1).H;
  const Eigen::SelfAdjointEigenSolver<Mat6d> eigen(H);
  const Vec6d& values = eigen.eigenvalues();
  EXPECT_LT(values[2], 0.01 * values[3]);
  Mat6d held = Mat6d::Zero();  // height, and the two turns out of the plane
  for (const int k : {2, 3, 4}) held(k, k) = 1.0;
  for (int k = 0; k < 6; ++k) EXPECT_NEAR((held * eigen.eigenvectors().col(k)).norm(), k < 3 ? 0.0 : 1.0, 0.05) << k;
}

// A scan that was prepared for another method.
TEST(Ndt, WithoutGaussiansItIsRefused) {
  const testing::ScanPair pair = drawn_pair(1, true);
  const PreparedPair prepared = prepare_pair(pair.source, pair.target, RegistrationOptions{});
  EXPECT_FALSE(prepared.target.cloud.has_gaussians());
  EXPECT_THROW(register_prepared(prepared, Rigid3{}, ndt()), std::invalid_argument);
  EXPECT_NO_THROW(register_prepared(prepare_pair(pair.source, pair.target, ndt()), Rigid3{}, RegistrationOptions{}));
}

// They take neither the given directions' place, nor are they estimated twice.
TEST(Ndt, CloudsThatHaveDirectionsKeepThem) {
  const testing::ScanPair pair = drawn_pair(1, true);
  const PreparedPair with_surface = prepare_pair(pair.source, pair.target, RegistrationOptions{});
  const Scan both = prepare(with_surface.target, with_surface.lengths, ndt());
  ASSERT_TRUE(both.cloud.has_gaussians());
  Cloud marked = both.cloud;
  for (PointGaussian& gaussian : marked.gaussians) gaussian.information *= 2.0f;
  const Scan again = prepare(scan_of(marked), with_surface.lengths, ndt());
  EXPECT_EQ(again.cloud.gaussians.front().information, marked.gaussians.front().information);
}

}  // namespace
}  // namespace augicp
