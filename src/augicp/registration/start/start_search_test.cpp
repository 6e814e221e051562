// SPDX-License-Identifier: MIT
#include "augicp/registration/start/start_search.h"

#include <gmock/gmock.h>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

using testing::NearPose;

using Pair = testing::ScanPair;

// The camera turned by so much, and moved, between the images.
Pair room_pair(double angle_rad) {
  return testing::room_pair({rotation_exp(angle_rad * Vec3d(0.6, 0.64, 0.48)), {0.1, -0.05, 0.1}});
}

RegistrationOptions without_search() {
  RegistrationOptions options;
  options.search = false;
  return options;
}

TEST(Search, ImagesMeetFromFarther) {
  const Pair pair = room_pair(0.6);
  EXPECT_THAT(register_scans(pair.source, pair.target, {}, without_search()).result.target_from_source,
              ::testing::Not(NearPose(pair.target_from_source, 0.1, 0.1)));
  EXPECT_THAT(register_scans(pair.source, pair.target).result.target_from_source,
              NearPose(pair.target_from_source, 0.02, 0.05));
}

TEST(Search, CloudsMeetFromFarther) {
  const Pair pair = room_pair(0.2);
  const Scan source = scan_of(pair.source.cloud), target = scan_of(pair.target.cloud);
  std::mt19937 generator(1);
  for (int trial = 0; trial < testing::repeats(3, 1); ++trial) {
    const Vec3d middle = median_point(source.cloud).cast<double>();
    const Rigid3 turn = testing::random_motion(generator, 1.2, 0.0);
    const Rigid3 guess = pair.target_from_source * Rigid3{turn.rotation, middle - turn.rotation * middle};
    EXPECT_THAT(register_scans(source, target, guess).result.target_from_source,
                NearPose(pair.target_from_source, 0.02, 0.03));
  }
}

// Turned by half a right angle and moved aside, lines of sight lead nowhere: only what nearest points pulled together
// does.
TEST(Search, ImagesAreFoundFromAside) {
  const Pair pair = room_pair(0.1);
  for (const Rigid3& off : {Rigid3{rotation_exp({0.58, -0.64, 0.27}), {-0.4, 0.3, -0.3}},
                            Rigid3{rotation_exp({-0.35, -0.2, 0.8}), {-0.55, 0.1, -0.15}},
                            Rigid3{rotation_exp({0.43, 0.8, -0.04}), {0.0, -0.8, -0.9}}})
    EXPECT_THAT(register_scans(pair.source, pair.target, pair.target_from_source * off).result.target_from_source,
                NearPose(pair.target_from_source, 0.02, 0.05))
        << off.translation.transpose();
}

// A good guess stays what it is worth.
TEST(Search, AGoodGuessIsNotMadeWorse) {
  const Pair pair = room_pair(0.1);
  const Rigid3 with = register_scans(pair.source, pair.target, pair.target_from_source).result.target_from_source;
  const Rigid3 without =
      register_scans(pair.source, pair.target, pair.target_from_source, without_search()).result.target_from_source;
  EXPECT_THAT(with, NearPose(without, 1e-3, 2e-3));
}

// If the evidence does not support what the search finds, the result of the guess competes with it.
TEST(Search, NothingIsWorseThanWhatTheGuessLeadsTo) {
  std::mt19937 generator(5);
  const Pair pair = room_pair(0.2);
  for (const bool as_clouds : {false, true})
    for (int trial = 3 - testing::repeats(3, 1); trial < 3; ++trial) {
      const Scan source = as_clouds ? scan_of(pair.source.cloud) : pair.source,
                 target = as_clouds ? scan_of(pair.target.cloud) : pair.target;
      const Rigid3 guess = pair.target_from_source * testing::random_motion(generator, 0.3 * trial, 0.2 * trial);
      const AlignResult with = register_scans(source, target, guess).result;
      const AlignResult without = register_scans(source, target, guess, without_search()).result;
      EXPECT_TRUE(is_supported(with) || !is_better(without, with)) << trial;
    }
}

TEST(Search, NothingToFindGivesTheGuessBack) {
  const Pair pair = room_pair(0.1);
  const Lengths lengths = lengths_for(pair.source, pair.target, {});
  const Scan target = prepare(pair.target, lengths, {});
  Scan one = target;
  one.view.reset();
  one.cloud.points.resize(1), one.cloud.directions.resize(1), one.cloud.structures.resize(1), one.cloud.weights.clear();
  const Rigid3 guess{rotation_exp({0.1, 0.2, 0.3}), {1, 2, 3}};
  EXPECT_THAT(search_starts({one, target, lengths}, guess, {}).front(), NearPose(guess, 0.0, 0.0));
}

TEST(Search, ThreadsFindTheSameBits) {
  const Pair pair = room_pair(0.6);
  RegistrationOptions options;
  options.num_threads = 1;
  const Rigid3 expected = register_scans(pair.source, pair.target, {}, options).result.target_from_source;
  options.num_threads = 5;
  EXPECT_EQ(register_scans(pair.source, pair.target, {}, options).result.target_from_source.matrix(),
            expected.matrix());
}

TEST(Search, ThePaperDoesNotSearch) {
  const Pair pair = room_pair(0.6);
  RegistrationOptions paper;
  paper.preset = Preset::Paper;
  RegistrationOptions plain = paper;
  plain.search = plain.coarse_to_fine = plain.rolling_shutter = false;
  EXPECT_EQ(register_scans(pair.source, pair.target, {}, paper).result.target_from_source.matrix(),
            register_scans(pair.source, pair.target, {}, plain).result.target_from_source.matrix());
}

}  // namespace
}  // namespace augicp
