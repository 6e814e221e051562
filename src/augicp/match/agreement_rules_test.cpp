// SPDX-License-Identifier: MIT
// Agreement of a target with a single point, in words and in numbers, for both matchers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "augicp/match/matcher.h"

namespace augicp {
namespace {

constexpr Pinhole kRuleCamera{50.0, 50.0, 31.5, 23.5, 64, 48};
constexpr double kRuleTolerance = 0.01;  // metres
constexpr float kRuleDepth = 2.0f;

enum class Said { Agrees, Differs, Conflicts, Hidden, Unseen };

Said said_in(const Agreement& agreement) {
  EXPECT_EQ(agreement.total(), 1);
  if (agreement.agree == 1) return Said::Agrees;
  if (agreement.differ == 1) return Said::Differs;
  if (agreement.conflict == 1) return Said::Conflicts;
  return agreement.hidden == 1 ? Said::Hidden : Said::Unseen;
}

// A target of one point in the middle of the image, its direction towards the camera, and a source of one point beside
// it.
struct OnePoint {
  Vec3f offset = Vec3f::Zero();  // of the source point from the target's, metres
  Structure of_source = Structure::Planar, of_target = Structure::Planar;
  double turned_deg = 0.0;  // the source's direction about y
  bool has_viewpoints = true;
  Rigid3 target_from_source = {};

  Cloud target() const {
    Cloud cloud;
    cloud.points = {Vec3f(0.02f, 0.02f, kRuleDepth)};
    cloud.directions = {Vec3f(0, 0, -1)};
    cloud.structures = {of_target};
    if (has_viewpoints) cloud.viewpoint = Vec3f::Zero();
    return cloud;
  }

  Cloud source() const {
    Cloud cloud = target();
    const double angle = turned_deg * std::numbers::pi / 180.0;
    cloud.points[0] += offset;
    cloud.points[0] = (inverse(target_from_source) * cloud.points[0].cast<double>()).cast<float>();
    cloud.directions[0] = Vec3f(static_cast<float>(std::sin(angle)), 0.0f, -static_cast<float>(std::cos(angle)));
    cloud.structures[0] = of_source;
    return cloud;
  }
};

Said camera_says(const OnePoint& point) {
  const Cloud target = point.target();
  IndexImage index(kRuleCamera.width, kRuleCamera.height);
  index.index[24 * kRuleCamera.width + 32] = 0;
  return said_in(ProjectiveMatcher(target, index, kRuleCamera)
                     .agreement(point.source(), point.target_from_source, {.distance = kRuleTolerance}, 1));
}

Said nearest_says(const OnePoint& point) {
  const Cloud target = point.target();
  return said_in(
      NearestMatcher(target).agreement(point.source(), point.target_from_source, {.distance = kRuleTolerance}, 1));
}

void expect_both(const OnePoint& point, Said said) {
  EXPECT_EQ(camera_says(point), said) << point.offset.transpose() << ", " << point.turned_deg << " degrees";
  EXPECT_EQ(nearest_says(point), said) << point.offset.transpose() << ", " << point.turned_deg << " degrees";
}

constexpr float kTol = static_cast<float>(kRuleTolerance);

TEST(AgreementRules, NearIsWithinThreeTolerances) {
  for (const float side : {-1.0f, 1.0f}) {
    expect_both({.offset = {0, 0, side * 0.9f * kTol}}, Said::Agrees);
    expect_both({.offset = {0, 0, side * 1.1f * kTol}}, Said::Differs);
    expect_both({.offset = {0, 0, side * 2.9f * kTol}}, Said::Differs);
    const OnePoint far{.offset = {0, 0, side * 3.1f * kTol}};
    EXPECT_EQ(camera_says(far), side < 0.0f ? Said::Conflicts : Said::Hidden);
    EXPECT_EQ(nearest_says(far), Said::Unseen);
  }
}

// Along a plane a point may stand anywhere near; beside an edge, or a point without structure, it may not.
TEST(AgreementRules, OnlyPlanesReachBeyondTheTolerance) {
  const Vec3f beside(1.5f * kTol, 0, 0);
  for (const Structure of_source : {Structure::Planar, Structure::Edge, Structure::None}) {
    expect_both({.offset = beside, .of_source = of_source}, Said::Agrees);
    expect_both({.offset = beside, .of_source = of_source, .of_target = Structure::Edge}, Said::Differs);
    expect_both({.offset = beside, .of_source = of_source, .of_target = Structure::None}, Said::Differs);
    expect_both({.offset = 0.5f * beside, .of_source = of_source, .of_target = Structure::Edge}, Said::Agrees);
  }
}

// The default cosine is 0.85, that of 31.8 degrees.
TEST(AgreementRules, NormalsAreComparedBetweenPlanes) {
  expect_both({.turned_deg = 31.0}, Said::Agrees);
  expect_both({.turned_deg = 33.0}, Said::Differs);
  expect_both({.of_source = Structure::Edge, .turned_deg = 33.0}, Said::Agrees);
  expect_both({.of_target = Structure::Edge, .turned_deg = 33.0}, Said::Agrees);
}

TEST(AgreementRules, OppositeNormalsDifferWhereTheirSignsAreKnown) {
  expect_both({.turned_deg = 180.0}, Said::Differs);
  expect_both({.turned_deg = 180.0, .has_viewpoints = false}, Said::Agrees);
  expect_both({.turned_deg = 147.0, .has_viewpoints = false}, Said::Differs);
}

TEST(AgreementRules, NormalsTurnWithThePose) {
  const Rigid3 pose{Eigen::Quaterniond(Eigen::AngleAxisd(0.9, Vec3d::UnitY())), {0.3, 0.1, 0.2}};
  const double degrees = 0.9 * 180.0 / std::numbers::pi;
  expect_both({.turned_deg = degrees, .target_from_source = pose}, Said::Agrees);
  expect_both({.turned_deg = -degrees, .target_from_source = pose}, Said::Differs);
}

TEST(AgreementRules, WithoutDirectionsOnlyTheDistanceCounts) {
  const OnePoint point{.offset = Vec3f(1.5f * kTol, 0, 0), .turned_deg = 90.0};
  for (const bool of_source : {true, false}) {
    Cloud source = point.source(), target = point.target();
    Cloud& bare = of_source ? source : target;
    bare.directions.clear();
    bare.structures.clear();
    const NearestMatcher matcher(target);
    EXPECT_EQ(said_in(matcher.agreement(source, {}, {.distance = kRuleTolerance}, 1)), Said::Differs);
    EXPECT_EQ(said_in(matcher.agreement(source, {}, {.distance = 2.0 * kRuleTolerance}, 1)), Said::Agrees);
  }
}

// Every point falls on the pixel whose centre is nearest: neighbours in these stairs differ by ten tolerances.
TEST(AgreementRules, APixelReachesHalfWayToItsNeighbours) {
  const auto stair = [](int u, int v) { return 1.0f + 0.4f * static_cast<float>((u + 2 * v) % 5); };
  DepthImage image{kRuleCamera.width, kRuleCamera.height, {}};
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) image.depth.push_back(stair(u, v));
  const OrganizedCloud target = unproject(image, kRuleCamera);
  for (const double du : {-0.45, 0.45})
    for (const double dv : {-0.45, 0.45}) {
      Cloud source = target.cloud;
      for (Vec3f& point : source.points)
        point += Vec3f(static_cast<float>(du / kRuleCamera.fx) * point.z(),
                       static_cast<float>(dv / kRuleCamera.fy) * point.z(), 0);
      const Agreement agreement =
          ProjectiveMatcher(target.cloud, target.index, kRuleCamera).agreement(source, {}, {.distance = 0.04}, 1);
      EXPECT_EQ(agreement.agree, static_cast<std::int64_t>(source.size())) << du << " " << dv;
    }
}

// It begins half a pixel before the centres of its first pixels and ends half a pixel after the last. Exact, because
// every number here is a sum of powers of two.
TEST(AgreementRules, AnImageBeginsAndEndsHalfAPixelAroundItsCentres) {
  constexpr Pinhole kExact{64.0, 64.0, 31.5, 23.5, 64, 48};
  const OrganizedCloud target = unproject({64, 48, std::vector<float>(64 * 48, kRuleDepth)}, kExact);
  const ProjectiveMatcher matcher(target.cloud, target.index, kExact);
  const float left = -0.5f, right = 0.5f, top = -0.375f, bottom = 0.375f, inward = 1.0f / 1024.0f;
  const auto is_seen = [&](float x, float y) {
    Cloud point;
    point.points = {Vec3f(x * kRuleDepth, y * kRuleDepth, kRuleDepth)};
    return matcher.agreement(point, {}, {.distance = kRuleTolerance}, 1).unseen == 0;
  };
  EXPECT_TRUE(is_seen(left, 0.0f));
  EXPECT_TRUE(is_seen(0.0f, top));
  EXPECT_TRUE(is_seen(right - inward, bottom - inward));
  for (const auto& [x, y] : {std::pair{right, 0.0f}, {0.0f, bottom}, {left - inward, 0.0f}, {0.0f, top - inward}})
    EXPECT_FALSE(is_seen(x, y)) << x << " " << y;
}

TEST(AgreementRules, TolerancesOutOfTheirRangeAreRefused) {
  for (const AgreementTolerance& bad :
       {AgreementTolerance{.distance = 0.1, .min_cosine = 1.5}, AgreementTolerance{.distance = 0.1, .min_cosine = -1.5},
        AgreementTolerance{.distance = 0.1, .per_depth = -0.1}})
    EXPECT_THROW(bad.check(), std::invalid_argument);
  for (const AgreementTolerance& good :
       {AgreementTolerance{.distance = 0.1, .min_cosine = 1.0}, AgreementTolerance{.distance = 0.1, .min_cosine = -1.0},
        AgreementTolerance{.distance = 0.0, .per_depth = 1e-3}})
    EXPECT_NO_THROW(good.check());
}

}  // namespace
}  // namespace augicp
