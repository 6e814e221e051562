// SPDX-License-Identifier: MIT
#include "augicp/align/scout.h"

#include <gtest/gtest.h>

#include "augicp/geometry/rotation.h"
#include "augicp/match/matcher.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

using testing::NearPose;

// A cloud beside itself, moved a little.
const Cloud kTarget = testing::random_points(600, 1.0, 7);
const Cloud kSource = transform(kTarget, Rigid3{rotation_exp({0.01, -0.02, 0.015}), {0.02, -0.01, 0.015}});

AlignOptions plain_options() {
  AlignOptions options;
  options.information = point_information();
  options.num_threads = 1;
  return options;
}

std::optional<Rigid3> pose_of(const AlignOptions& options, const KnowsPose& is_known) {
  const NearestMatcher matcher(kTarget);
  const auto session = matcher.session(kSource);
  return scouted({kSource, matcher, *session}, Rigid3{}, options, is_known);
}

TEST(Scout, FindsThePoseOfTheWholeAlignment) {
  const AlignResult whole = align(kSource, NearestMatcher(kTarget), Rigid3{}, plain_options());
  const auto pose = pose_of(plain_options(), [](const Rigid3&) { return false; });
  ASSERT_TRUE(pose);
  EXPECT_THAT(*pose, NearPose(whole.target_from_source, 0.0, 0.0));
}

TEST(Scout, EndsAtAKnownPose) {
  int num_asked = 0;
  EXPECT_FALSE(pose_of(plain_options(), [&](const Rigid3&) { return ++num_asked >= 2; }));
  EXPECT_EQ(num_asked, 3);  // after two steps, and in the end
}

TEST(Scout, FindsNothingWhereNothingIsNear) {
  AlignOptions options = plain_options();
  options.gates.max_distance = 1e-6;
  EXPECT_FALSE(pose_of(options, [](const Rigid3&) { return false; }));
}

}  // namespace
}  // namespace augicp
