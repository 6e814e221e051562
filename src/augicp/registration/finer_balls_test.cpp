// SPDX-License-Identifier: MIT
#include "augicp/registration/finer_balls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

#include "augicp/geometry/rotation.h"
#include "augicp/synthetic/objects.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::NearPose;

const Rigid3 kSmallMotion{rotation_exp(Vec3d(0.02, -0.03, 0.05)), {0.02, -0.01, 0.01}};

synthetic::Object object_named(const std::string& name) {
  for (const synthetic::Object& object : synthetic::objects())
    if (object.name == name) return object;
  throw std::invalid_argument(name);
}

// An object drawn twice, of which the source is moved by kSmallMotion.
RawPair moved(const std::string& name, std::size_t num_points) {
  std::mt19937 generator(7);
  const synthetic::Object object = object_named(name);
  const Cloud source = synthetic::sampled(object, num_points, 0.0, generator);
  return {scan_of(transform(source, inverse(kSmallMotion))),
          scan_of(synthetic::sampled(object, num_points, 0.0, generator))};
}

Registration registered(const RawPair& pair, const RegistrationOptions& options = {}) {
  return register_scans(pair.source, pair.target, {}, options);
}

double derived_radius(const RawPair& pair) { return lengths_for(pair.source, pair.target, {}).radius; }

// In the first balls the legs are rods: only whole radii hold the seat in its plane.
TEST(FinerBalls, HoldAChairThatWiderOnesLetSlide) {
  const RawPair chair = moved("chair", 20000);
  const Registration registration = registered(chair);
  EXPECT_EQ(registration.result.status, AlignStatus::Converged);
  EXPECT_NEAR(registration.prepared.lengths.radius, 0.5 * derived_radius(chair), 1e-9);
  EXPECT_NEAR(registration.prepared.lengths.voxel_size, voxel_size_for(registration.prepared.lengths.radius), 1e-9);
  EXPECT_GT(registration.result.observability.weakest(), 1e-3);
  EXPECT_THAT(registration.result.target_from_source, NearPose(kSmallMotion, 5e-4, 5e-4));
  EXPECT_EQ(registration.result.history.size(), static_cast<std::size_t>(registration.result.iterations));
}

// Of a part that shows all of itself a little disagrees in smaller balls. It is a part all the same.
TEST(FinerBalls, APartIsOneInThemToo) {
  const RawPair table = moved("table", 20000);
  for (const Vec3d& towards_viewer :
       testing::cases({Vec3d(0.4, 0.7, 0.6), Vec3d(-0.6, 0.3, 0.7), Vec3d(0.2, -0.9, 0.4)}, 1)) {
    std::mt19937 generator(3);
    const Cloud side =
        synthetic::sampled_side(object_named("table"), 10000, 5e-4, towards_viewer.normalized(), 1.5, generator);
    const RawPair pair{scan_of(transform(side, inverse(kSmallMotion))), table.target};
    const Registration registration = registered(pair);
    EXPECT_NEAR(registration.prepared.lengths.radius, 0.5 * derived_radius(pair), 1e-9);
    EXPECT_THAT(registration.result.target_from_source, NearPose(kSmallMotion, 1e-3, 1e-3));
  }
}

// Three legs: turned by 120 degrees it fits as well, which wide balls do not show.
TEST(FinerBalls, ShowTheSymmetryOfAStool) {
  const Registration registration = registered(moved("stool", 20000));
  EXPECT_EQ(registration.result.status, AlignStatus::Ambiguous);
  EXPECT_THAT(registration.result.target_from_source, NearPose(kSmallMotion, 5e-4, 5e-4));
  EXPECT_FALSE(registration.result.runners_up.empty());
}

TEST(FinerBalls, AreNotAskedWhereTheFirstHoldAllMotions) {
  const testing::ScanPair pair = testing::room_pair(kSmallMotion);
  const RawPair clouds{scan_of(pair.source.cloud), scan_of(pair.target.cloud)};
  const Registration registration = registered(clouds);
  ASSERT_EQ(registration.result.status, AlignStatus::Converged);
  EXPECT_EQ(registration.prepared.lengths.radius, derived_radius(clouds));
}

TEST(FinerBalls, GivenLengthsImagesAndThePaperHaveNone) {
  const RawPair clouds = moved("brick", 100);
  const auto may = [&](auto change) {
    RegistrationOptions options;
    change(options);
    return may_have_finer_balls(clouds.source, clouds.target, options);
  };
  EXPECT_TRUE(may([](RegistrationOptions&) {}));
  EXPECT_FALSE(may([](RegistrationOptions& options) { options.radius = 0.1; }));
  EXPECT_FALSE(may([](RegistrationOptions& options) { options.voxel_size = 0.1; }));
  EXPECT_FALSE(may([](RegistrationOptions& options) { options.preset = Preset::Paper; }));
  const Scan image = testing::noisy_view(testing::room(), testing::room().world_from_camera, 1);
  EXPECT_FALSE(may_have_finer_balls(image, clouds.target, {}));
  EXPECT_FALSE(may_have_finer_balls(clouds.source, image, {}));
}

// Whoever takes the pairs of a found pose finds the points again.
TEST(FinerBalls, FindPoseSaysWhichLengthsItsPairsHave) {
  const RawPair chair = moved("chair", 20000);
  const auto found = find_pose(chair.source, chair.target);
  ASSERT_FALSE(found.empty());
  ASSERT_LT(found.front().lengths.radius, derived_radius(chair));
  const PreparedPair prepared = prepare_both(chair, found.front().lengths, {});
  for (const Correspondence& pair : found.front().result.pairs) {
    ASSERT_LT(pair.source, prepared.source.cloud.size());
    ASSERT_LT(pair.target, prepared.target.cloud.size());
  }
}

TEST(FinerBalls, AreTheSameOnAnyNumberOfThreads) {
  const RawPair chair = moved("chair", 8000);
  RegistrationOptions options;
  options.num_threads = 1;
  const Registration one = registered(chair, options);
  options.num_threads = 4;
  const Registration four = registered(chair, options);
  EXPECT_LT(one.prepared.lengths.radius, derived_radius(chair));
  EXPECT_EQ(one.result.target_from_source.matrix(), four.result.target_from_source.matrix());
}

}  // namespace
}  // namespace augicp
