// SPDX-License-Identifier: MIT
#include "augicp/registration/final_pass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

// Wide enough for more points than the first voxels keep.
constexpr int kWidth = 240;

// A generated room from two places, as clouds.
testing::ScanPair room_clouds(unsigned seed) {
  std::mt19937 generator(seed);
  const testing::Scene scene = testing::room(seed);
  const Rigid3 motion = testing::random_motion(generator, 0.15, 0.15);
  const Rigid3& place = scene.world_from_camera;
  return {scan_of(testing::noisy_view(scene, place * motion, 2 * seed + 1, kWidth).cloud),
          scan_of(testing::noisy_view(scene, place, 2 * seed + 2, kWidth).cloud), motion};
}

RegistrationOptions near_options(bool final_pass) {
  RegistrationOptions options;
  options.search = false;
  options.final_pass = final_pass;
  return options;
}

Registration registered(const testing::ScanPair& pair, const RegistrationOptions& options) {
  return register_scans(pair.source, pair.target, pair.target_from_source, options);
}

bool is_final(const Registration& registration, const Registration& first) {
  return registration.prepared.lengths.radius < first.prepared.lengths.radius;
}

double rms_error(const testing::ScanPair& pair, const Rigid3& target_from_source) {
  double sum = 0.0;
  for (const Vec3f& point : pair.source.cloud.points)
    sum += (target_from_source * point.cast<double>() - pair.target_from_source * point.cast<double>()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(pair.source.cloud.size()));
}

constexpr unsigned kSeeds[] = {1, 2, 3, 4, 5, 6};

// What the result says of the scans and of its own way.
void expect_whole(const Registration& with, const Registration& first) {
  EXPECT_FALSE(with.prepared.raw);
  EXPECT_NEAR(with.prepared.lengths.radius, 0.7 * first.prepared.lengths.radius, 1e-9);
  EXPECT_GT(with.prepared.source.cloud.size(), first.prepared.source.cloud.size());
  for (const Correspondence& found : with.result.pairs) {
    ASSERT_LT(found.source, with.prepared.source.cloud.size());
    ASSERT_LT(found.target, with.prepared.target.cloud.size());
  }
  EXPECT_EQ(with.result.history.size(), static_cast<std::size_t>(with.result.iterations));
  EXPECT_GT(with.result.iterations, first.result.iterations);
  EXPECT_EQ(with.result.history.back().target_from_source.matrix(), with.result.target_from_source.matrix());
}

void expect_none_without_covariance(const testing::ScanPair& pair, const Registration& first) {
  RegistrationOptions options = near_options(true);
  options.covariance = false;
  EXPECT_FALSE(is_final(registered(pair, options), first));
}

TEST(FinalPass, IsKeptWholeOrNotAtAllWithTheSameStatusAndNotFartherFromTheTruth) {
  int num_kept = 0;
  double with_error = 0.0, first_error = 0.0;
  for (const unsigned seed : kSeeds) {
    SCOPED_TRACE(seed);
    const testing::ScanPair pair = room_clouds(seed);
    const Registration with = registered(pair, near_options(true)), first = registered(pair, near_options(false));
    with_error += rms_error(pair, with.result.target_from_source);
    first_error += rms_error(pair, first.result.target_from_source);
    EXPECT_EQ(with.result.status, first.result.status);
    if (is_final(with, first)) {
      if (++num_kept == 1) expect_none_without_covariance(pair, first);
      expect_whole(with, first);
    } else {
      EXPECT_EQ(with.result.target_from_source.matrix(), first.result.target_from_source.matrix());
    }
  }
  EXPECT_GE(num_kept, 1);
  EXPECT_LT(with_error, 1.1 * first_error);  // not farther, whatever chance does to a few rooms
}

TEST(FinalPass, TheIterationsOfBothStayWithinTheLimit) {
  const testing::ScanPair pair = room_clouds(kSeeds[0]);
  RegistrationOptions options = near_options(false);
  options.max_iterations = registered(pair, options).result.iterations + 1;
  options.final_pass = true;
  EXPECT_LE(registered(pair, options).result.iterations, options.max_iterations);
}

TEST(FinalPass, IsTheSameOnAnyNumberOfThreads) {
  const testing::ScanPair pair = room_clouds(kSeeds[0]);
  RegistrationOptions options = near_options(true);
  options.num_threads = 1;
  const Registration one = registered(pair, options);
  options.num_threads = 4;
  const Registration four = registered(pair, options);
  EXPECT_EQ(one.result.target_from_source.matrix(), four.result.target_from_source.matrix());
  EXPECT_EQ(*one.result.covariance, *four.result.covariance);
}

// A pose between frames: the points' origins change it, and not what it does to the points.
TEST(FinalPass, FarOriginsDoNotChangeTheMotionOfThePoints) {
  testing::ScanPair pair = room_clouds(kSeeds[0]);
  const Rigid3 near = registered(pair, near_options(true)).result.target_from_source;
  const Vec3d shift(5e5, -2e5, 100.0);
  pair.source.cloud.origin = pair.target.cloud.origin = shift;
  const Rigid3 shifted{Eigen::Quaterniond::Identity(), shift};
  pair.target_from_source = shifted * pair.target_from_source * inverse(shifted);
  const Registration far = registered(pair, near_options(true));
  const Rigid3 back = inverse(shifted) * far.result.target_from_source * shifted;
  EXPECT_LT(increment_between(near, back).norm(), 1e-6);
  const Rigid3 last = inverse(shifted) * far.result.history.back().target_from_source * shifted;
  EXPECT_LT(increment_between(near, last).norm(), 1e-6);
}

}  // namespace
}  // namespace augicp
