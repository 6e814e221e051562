// SPDX-License-Identifier: MIT
#include "augicp/registration/registration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stop_token>
#include <thread>
#include <tuple>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/error.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::NearPose;

using Pair = testing::ScanPair;

Pair room_pair(double angle_rad, double distance_m) {
  std::mt19937 generator(3);
  return testing::room_pair(testing::random_motion(generator, angle_rad, distance_m));
}

// The same without images.
Pair room_clouds() {
  Pair pair = room_pair(0.1, 0.1);
  return {scan_of(pair.source.cloud), scan_of(pair.target.cloud), pair.target_from_source};
}

Cloud scaled(Cloud cloud, float factor) {
  for (Vec3f& point : cloud.points) point *= factor;
  if (cloud.viewpoint) *cloud.viewpoint *= factor;
  return cloud;
}

TEST(Registration, DepthImagesOfARoomMeet) {
  const Pair pair = room_pair(0.1, 0.1);
  for (Preset preset : {Preset::Default, Preset::Paper}) {
    RegistrationOptions options;
    options.preset = preset;
    const AlignResult result = register_scans(pair.source, pair.target, Rigid3{}, options).result;
    EXPECT_EQ(result.status, AlignStatus::Converged);
    EXPECT_THAT(result.target_from_source, NearPose(pair.target_from_source, 0.01, 0.02));
  }
}

TEST(Registration, CloudsOfARoomMeetByEveryMethod) {
  const Pair pair = room_clouds();
  for (const auto& [method, word] : kWords<Method>) {
    if (method == Method::Point) continue;  // slides along walls
    RegistrationOptions options;
    options.method = method;
    const AlignResult result = register_scans(pair.source, pair.target, Rigid3{}, options).result;
    EXPECT_THAT(result.target_from_source, NearPose(pair.target_from_source, 0.01, 0.03)) << word;
  }
}

// One set of defaults for a bunny and a building: nothing may depend on the unit of length.
TEST(Registration, ScaleDoesNotMatter) {
  const Pair pair = room_clouds();
  const AlignResult expected = register_scans(pair.source, pair.target).result;
  for (float factor : {1.0f / 64.0f, 32.0f}) {  // powers of two: exact in float
    const AlignResult result =
        register_scans(scan_of(scaled(pair.source.cloud, factor)), scan_of(scaled(pair.target.cloud, factor))).result;
    Rigid3 pose = result.target_from_source;
    pose.translation /= static_cast<double>(factor);
    EXPECT_THAT(pose, NearPose(expected.target_from_source, 1e-4, 1e-4));
    EXPECT_EQ(result.status, expected.status);
  }
}

// robustness 16: results are bit-identical under a permutation of the points, and for any number of threads.
TEST(Registration, OrderAndThreadsDoNotMatter) {
  const Pair pair = room_clouds();
  const AlignResult expected = register_scans(pair.source, pair.target).result;
  std::vector<std::uint32_t> order(pair.source.cloud.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  const Scan shuffled = scan_of(select(pair.source.cloud, order));
  for (int num_threads : {1, 2, 3, 8}) {
    RegistrationOptions options;
    options.num_threads = num_threads;
    const AlignResult result = register_scans(shuffled, pair.target, Rigid3{}, options).result;
    EXPECT_EQ(result.target_from_source.matrix(), expected.target_from_source.matrix()) << num_threads;
  }
}

// robustness 15: far coordinates. The pose is compared at the points.
TEST(Registration, FarOriginsDoNotMatter) {
  Pair pair = room_clouds();
  const AlignResult near = register_scans(pair.source, pair.target).result;
  for (double offset : {1e3, 1e6, 1e7}) {
    const Vec3d shift(offset, -offset, 0.5 * offset);
    Scan source = pair.source, target = pair.target;
    source.cloud.origin = target.cloud.origin = shift;
    const Rigid3 guess{Eigen::Quaterniond::Identity(), Vec3d::Zero()};
    const AlignResult far = register_scans(source, target, guess).result;
    const Vec3d point = source.cloud.points.front().cast<double>();
    const Vec3d moved_near = near.target_from_source * point;
    EXPECT_THAT(far.target_from_source * (shift + point) - shift, testing::NearVector(moved_near, 1e-6)) << offset;
  }
}

// robustness 10: nothing to register is a failure, and the guess is kept.
TEST(Registration, HopelessInputFails) {
  const Pair pair = room_clouds();
  Cloud equal;
  equal.points.assign(5000, Vec3f(1.0f, 2.0f, 3.0f));
  const Rigid3 guess{Eigen::Quaterniond::Identity(), Vec3d(1.0, 2.0, 3.0)};
  std::vector<Scan> hopeless{Scan{}, scan_of(equal)};
  for (std::size_t count = 1; count <= 5; ++count) {
    Cloud few;
    few.points.assign(pair.source.cloud.points.begin(),
                      pair.source.cloud.points.begin() + static_cast<std::ptrdiff_t>(count));
    hopeless.push_back(scan_of(few));
  }
  for (const Scan& scan : hopeless) {
    for (const AlignResult& result :
         {register_scans(scan, pair.target, guess).result, register_scans(pair.target, scan, guess).result,
          register_scans(scan, scan, guess).result}) {
      EXPECT_TRUE(result.status == AlignStatus::TooFewPairs || result.status == AlignStatus::NoOverlap)
          << name_of(result.status) << " for " << scan.cloud.size() << " points";
      EXPECT_THAT(result.target_from_source, NearPose(guess, 0.0, 0.0));
    }
  }
}

// robustness 10, 12: clouds on which code that is fast on others could take quadratic time. With this many points that
// would be hours.
TEST(Registration, PathologicalCloudsEnd) {
  constexpr std::size_t kCount = 100000;
  const auto cloud_of = [](const auto& place) {
    Cloud cloud;
    for (std::size_t i = 0; i < kCount; ++i) cloud.points.push_back(place(i));
    return scan_of(cloud);
  };
  const Cloud room = room_clouds().source.cloud;
  const auto in_room = [&](std::size_t i) { return room.points[i % room.size()]; };
  const auto on_line = [](std::size_t i) { return Vec3f(1e-4f * static_cast<float>(i) * Vec3f(1.0f, 0.3f, 0.2f)); };
  const Vec3f far(1e6f, 0.0f, 0.0f);
  const std::tuple<const char*, Scan, AlignStatus> cases[] = {
      {"equal points", cloud_of([](std::size_t) { return Vec3f(1.0f, 2.0f, 3.0f); }), AlignStatus::TooFewPairs},
      {"a line", cloud_of(on_line), AlignStatus::Degenerate},
      {"a far outlier", cloud_of([&](std::size_t i) { return i == 0 ? far : in_room(i); }), AlignStatus::Converged},
      {"duplicates", cloud_of([&](std::size_t i) { return in_room(i < kCount / 2 ? i : 0); }), AlignStatus::Converged}};
  for (const auto& [name, scan, expected] : cases)
    EXPECT_EQ(name_of(register_scans(scan, scan).result.status), name_of(expected)) << name;
}

// One "no reading" at zero in a cloud of far coordinates must not cost the other points.
TEST(Registration, AFarOutlierChangesNothing) {
  const Pair pair = room_clouds();
  RegistrationOptions options;
  options.final_pass = false;  // two results lie millimetres apart if one of them keeps it by a hair
  const AlignResult expected = register_scans(pair.source, pair.target, Rigid3{}, options).result;
  for (float distance : {1e5f, 1e6f, 1e9f}) {
    Scan source = pair.source;
    source.cloud.points.emplace_back(distance, 0.0f, 0.0f);
    source.cloud.weights.push_back(1.0f);
    EXPECT_THAT(register_scans(source, pair.target, Rigid3{}, options).result.target_from_source,
                NearPose(expected.target_from_source, 1e-3, 2e-3));
  }
}

TEST(Registration, ProjectiveNeedsAnImage) {
  const Pair pair = room_clouds();
  RegistrationOptions options;
  options.association = Association::Projective;
  EXPECT_THROW(register_scans(pair.source, pair.target, Rigid3{}, options), std::invalid_argument);
}

TEST(Registration, OptionsOutOfRangeAreRefused) {
  const auto refused = [](const auto& change) {
    RegistrationOptions options;
    change(options);
    EXPECT_THROW(register_scans({}, {}, Rigid3{}, options), std::invalid_argument);
  };
  refused([](RegistrationOptions& o) { o.radius = 0.0; });
  refused([](RegistrationOptions& o) { o.voxel_size = -1.0; });
  refused([](RegistrationOptions& o) { o.max_distance = std::nan(""); });
  refused([](RegistrationOptions& o) { o.max_angle = 0.0; });
  refused([](RegistrationOptions& o) { o.max_iterations = 0; });
  refused([](RegistrationOptions& o) { o.min_step = -1e-9; });
  refused([](RegistrationOptions& o) { o.kernel_chi2 = 0.0; });
  refused([](RegistrationOptions& o) { o.lever = -0.1; });
  refused([](RegistrationOptions& o) { o.damping = -1.0; });
  refused([](RegistrationOptions& o) { o.num_threads = -1; });
}

TEST(Registration, WhatIsChosenByHandIsStrongerThanThePreset) {
  for (const Preset preset : {Preset::Default, Preset::Paper}) {
    RegistrationOptions options;
    options.preset = preset;
    options.classifier = preset == Preset::Paper ? Classifier::Normals : Classifier::Eigenvalues;
    options.kernel_chi2 = 30.0;
    options.lever = 0.2;
    options.damping = 0.5;
    const AlignOptions align = align_options(Lengths{}, /*projective=*/true, options);
    EXPECT_EQ(surface_options(options).classifier, *options.classifier);
    EXPECT_EQ(align.kernel_chi2, 30.0);
    EXPECT_EQ(align.lever, 0.2);
    EXPECT_EQ(align.damping, 0.5);
  }
}

TEST(Lengths, FollowTheCloud) {
  const Pair pair = room_clouds();
  const Lengths lengths = derive_lengths(pair.source, pair.target);
  const Lengths swapped = derive_lengths(pair.target, pair.source);
  EXPECT_DOUBLE_EQ(lengths.radius, swapped.radius);
  Scan with_outlier = pair.source;
  with_outlier.cloud.points.emplace_back(1e6f, 0.0f, 0.0f);
  EXPECT_NEAR(robust_extent(with_outlier), robust_extent(pair.source), 5e-3 * robust_extent(pair.source));
  EXPECT_EQ(robust_extent(Scan{}), 0.0);
}

// A wall leaves motions free, and the status is Degenerate.
TEST(Registration, OneWallIsDegenerate) {
  const Pinhole camera = testing::kinect_like_camera(160);
  const DepthImage wall = testing::render(testing::single_plane(), camera).depth;
  EXPECT_EQ(register_scans(scan_of(wall, camera), scan_of(wall, camera)).result.status, AlignStatus::Degenerate);
}

TEST(RegistrationInterrupted, ByATokenThatIsAlreadyStopped) {
  const Pair pair = room_clouds();
  std::stop_source stop;
  RegistrationOptions options;
  options.stop = stop.get_token();
  const Lengths lengths = lengths_for(pair.source, pair.target, options);
  const Scan source = prepare(pair.source, lengths, options), target = prepare(pair.target, lengths, options);
  stop.request_stop();
  EXPECT_THROW(prepare(pair.source, lengths, options), Interrupted);
  EXPECT_THROW(register_prepared({source, target, lengths}, Rigid3{}, options), Interrupted);
  EXPECT_THROW(register_scans(pair.source, pair.target, Rigid3{}, options), Interrupted);
}

// It would go on for ever: the request ends it, whenever it comes.
TEST(RegistrationInterrupted, FromAnotherThread) {
  for (const Pair& pair : {room_pair(0.1, 0.1), room_clouds()}) {
    RegistrationOptions options;
    options.min_step = 0.0;
    options.max_iterations = std::numeric_limits<int>::max();
    std::stop_source stop;
    options.stop = stop.get_token();
    const std::jthread asking([&stop] { stop.request_stop(); });
    EXPECT_THROW(register_scans(pair.source, pair.target, Rigid3{}, options), Interrupted);
  }
}

// The result suffices to draw it: the pairs are indices of the prepared scans, and a prepared pair gives the same
// result.
TEST(Registration, TheDoorReturnsWhatItKnows) {
  const Pair pair = room_clouds();
  RegistrationOptions options;
  options.final_pass = false;
  const Registration found = register_scans(pair.source, pair.target, Rigid3{}, options);
  const Lengths expected = lengths_for(pair.source, pair.target, {});
  EXPECT_EQ(found.prepared.lengths.radius, expected.radius);
  EXPECT_EQ(static_cast<std::int64_t>(found.result.pairs.size()), found.result.num_pairs);
  const Cloud &source = found.prepared.source.cloud, &target = found.prepared.target.cloud;
  const Rigid3f pose(without_origins(found.result.target_from_source, source, target));
  double sum_sq = 0.0;
  for (const auto [j, i] : found.result.pairs)
    sum_sq += static_cast<double>((pose * source.points.at(j) - target.points.at(i)).squaredNorm());
  EXPECT_NEAR(std::sqrt(sum_sq / static_cast<double>(found.result.num_pairs)), found.result.rmse, 1e-6);
  const Registration again = register_pair(found.prepared);
  EXPECT_EQ(again.result.target_from_source.matrix(), found.result.target_from_source.matrix());
}

}  // namespace
}  // namespace augicp
