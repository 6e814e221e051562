// SPDX-License-Identifier: MIT
#include "augicp/match/matcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/sensor/projection.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

using testing::random_extended_points;

constexpr Pinhole kMatchCamera{50.0, 60.0, 31.5, 23.5, 64, 48};

// The view of a camera, with arbitrary directions.
OrganizedCloud random_target(unsigned seed, const Pinhole& camera = kMatchCamera) {
  std::mt19937 generator(seed);
  DepthImage image{camera.width, camera.height,
                   std::vector<float>(static_cast<std::size_t>(camera.width) * camera.height)};
  for (float& depth : image.depth)
    depth = testing::uniform(generator, 0.0, 1.0) < 0.1 ? std::nanf("")
                                                        : static_cast<float>(testing::uniform(generator, 1.0, 1.3));
  OrganizedCloud seen = unproject(image, camera);
  const Cloud drawn = random_extended_points(seen.cloud.size(), 1.0, seed);
  seen.cloud.directions = drawn.directions;
  seen.cloud.structures = drawn.structures;
  return seen;
}

// The target in another order, a little apart, with directions that differ by up to half a radian.
Cloud source_near(const Cloud& target, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud source = target;
  for (Vec3f& point : source.points) point += 0.02f * testing::random_direction(generator).cast<float>();
  for (Vec3f& direction : source.directions)
    if (!direction.isZero())
      direction = (direction + 0.5f * testing::random_direction(generator).cast<float>()).normalized();
  std::rotate(source.structures.begin(), source.structures.begin() + 1, source.structures.begin() + 50);
  std::rotate(source.directions.begin(), source.directions.begin() + 1, source.directions.begin() + 50);
  std::reverse(source.points.begin(), source.points.end());
  std::reverse(source.directions.begin(), source.directions.end());
  std::reverse(source.structures.begin(), source.structures.end());
  return source;
}

// The gates in words, one after the other.
bool believed(const Cloud& source, const Cloud& target, const Correspondence& pair, const Rigid3& pose,
              const Gates& gates) {
  const auto [j, i] = pair;
  if ((target.points[i].cast<double>() - pose * source.points[j].cast<double>()).norm() > gates.max_distance)
    return false;
  const Structure of_source = source.structures[j], of_target = target.structures[i];
  if (of_source == Structure::None || of_target == Structure::None) return true;
  if (of_source != of_target) return !gates.same_structure;
  const double cosine = target.directions[i].cast<double>().dot(pose.rotation * source.directions[j].cast<double>());
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  const bool with_sign = of_target == Structure::Planar && source.viewpoint && target.viewpoint;
  return (with_sign ? angle : std::min(angle, std::numbers::pi - angle)) <= gates.max_angle;
}

std::vector<Correspondence> nearest_slowly(const Cloud& source, const Cloud& target, const Rigid3& pose,
                                           const Gates& gates) {
  std::vector<Correspondence> pairs;
  for (std::uint32_t j = 0; j < source.size(); ++j) {
    const Vec3d moved = pose * source.points[j].cast<double>();
    Correspondence nearest{j, 0};
    double smallest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < target.size(); ++i) {
      const double distance = (target.points[i].cast<double>() - moved).norm();
      if (distance < smallest) smallest = distance, nearest.target = i;
    }
    if (!target.empty() && believed(source, target, nearest, pose, gates)) pairs.push_back(nearest);
  }
  return pairs;
}

std::vector<Correspondence> projective_slowly(const Cloud& source, const OrganizedCloud& target, const Rigid3& pose,
                                              const Gates& gates, const Pinhole& camera = kMatchCamera) {
  const IndexImage seen = project(source, pose, camera, target.index.width, target.index.height, 1);
  std::vector<Correspondence> pairs;
  for (int v = 0; v < seen.height; ++v)
    for (int u = 0; u < seen.width; ++u) {
      const int j = seen.at(u, v), i = target.index.at(u, v);
      if (j < 0 || i < 0) continue;
      const Correspondence pair{static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i)};
      if (believed(source, target.cloud, pair, pose, gates)) pairs.push_back(pair);
    }
  return pairs;
}

struct Case {
  Gates gates;
  bool source_viewpoint;
  bool target_viewpoint;
};

std::vector<Case> cases() {
  Gates open, distance, angle, same, all;
  distance.max_distance = 0.03;
  angle.max_angle = 0.4;
  same.same_structure = true;
  all = {.max_distance = 0.1, .max_angle = 0.4, .same_structure = true};
  std::vector<Case> cases;
  for (const Gates& gates : {open, distance, angle, same, all})
    for (bool source_viewpoint : {true, false})
      for (bool target_viewpoint : {true, false}) cases.push_back({gates, source_viewpoint, target_viewpoint});
  return cases;
}

void drop_unknown_viewpoints(const Case& one, Cloud& source, Cloud& target) {
  if (!one.source_viewpoint) source.viewpoint.reset();
  if (!one.target_viewpoint) target.viewpoint.reset();
}

// Half of the source's directions are flipped, so that signs matter.
Cloud with_some_opposite(Cloud cloud) {
  for (std::size_t i = 0; i < cloud.size(); i += 2) cloud.directions[i] = -cloud.directions[i];
  return cloud;
}

TEST(NearestMatcher, PairsAreTheBruteForceOnesInSourceOrder) {
  std::mt19937 generator(1);
  for (const Case& one : cases()) {
    Cloud target = random_extended_points(300, 0.2, 1), source = with_some_opposite(source_near(target, 2));
    drop_unknown_viewpoints(one, source, target);
    const Rigid3 pose = testing::random_motion(generator, 0.05, 0.01);
    const auto pairs = NearestMatcher(target).match(source, pose, one.gates, 1);
    EXPECT_EQ(pairs, nearest_slowly(source, target, pose, one.gates));
    EXPECT_GT(pairs.size(), 20u);
  }
}

// Poses one after the other, far and near, with closing and opening gates: the memory changes nothing.
TEST(Matcher, SessionOfManyPosesIsThatOfEachForAnyNumberOfThreads) {
  const OrganizedCloud target = random_target(5);
  const Cloud source = source_near(target.cloud, 6);
  const NearestMatcher nearest(target.cloud);
  const ProjectiveMatcher projective(target.cloud, target.index, kMatchCamera);
  for (const Matcher* matcher : {static_cast<const Matcher*>(&nearest), static_cast<const Matcher*>(&projective)}) {
    const std::unique_ptr<MatchSession> session = matcher->session(source);
    int num_threads = 0;
    std::mt19937 generator(7);
    for (const double size : {0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 0.0, 0.1}) {
      const Rigid3 pose = testing::random_motion(generator, size, size);
      Gates gates;
      gates.max_distance = 0.02 + size;
      EXPECT_EQ(session->match(pose, gates, ++num_threads), matcher->match(source, pose, gates, 1)) << size;
    }
  }
}

// Near poses and far ones, under gates that hide some points or all, and coordinates whose squares leave float.
TEST(Matcher, PairsUnderEachOfSeveralPosesAreThoseOfEachAlone) {
  std::mt19937 generator(21);
  for (const double size : {1e-22, 1.0, 100.0, 1e20})
    for (const double part : {0.0, 1e-3, 0.05, 3.0}) {
      Cloud target = random_extended_points(1500, 1.0, 1), source = random_extended_points(700, 1.0, 2);
      for (Cloud* cloud : {&target, &source})
        for (Vec3f& point : cloud->points) point *= static_cast<float>(size);
      std::vector<Rigid3> poses{Rigid3{}};
      for (int k = 0; k < 12; ++k) poses.push_back(testing::random_motion(generator, 0.3 * part, part * size));
      const NearestMatcher matcher(target);
      for (const double max_distance : {0.05 * size, size, std::numeric_limits<double>::infinity()}) {
        Gates gates;
        gates.max_distance = max_distance;
        const auto pairs = matcher.match_each(source, poses, gates, 2);
        ASSERT_EQ(pairs.size(), poses.size());
        for (std::size_t k = 0; k < poses.size(); ++k)
          EXPECT_EQ(pairs[k], matcher.match(source, poses[k], gates, 1)) << size << " " << part << " " << max_distance;
      }
      EXPECT_TRUE(matcher.match_each(source, {}, {}, 1).empty());
    }
}

TEST(ProjectiveMatcher, PairsAreThoseOfALoopOverPixels) {
  std::mt19937 generator(2);
  for (const Case& one : cases()) {
    OrganizedCloud target = random_target(3);
    Cloud source = with_some_opposite(source_near(target.cloud, 4));
    drop_unknown_viewpoints(one, source, target.cloud);
    const Rigid3 pose = testing::random_motion(generator, 0.02, 0.02);
    const auto pairs = ProjectiveMatcher(target.cloud, target.index, kMatchCamera).match(source, pose, one.gates, 1);
    EXPECT_EQ(pairs, projective_slowly(source, target, pose, one.gates));
    EXPECT_GT(pairs.size(), 20u);
  }
}

// The target's points moved along their rays, with other directions: each is seen in its own pixel, in the order of
// pixels.
Cloud source_along_rays(const Cloud& target, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud source = source_near(target, seed);
  for (std::size_t i = 0; i < target.size(); ++i)
    source.points[i] = static_cast<float>(testing::uniform(generator, 0.96, 1.04)) * target.points[i];
  return source;
}

TEST(ProjectiveMatcher, PairsOfPointsSideBySideAreThoseOfALoopOverPixels) {
  for (const Case& one : cases()) {
    OrganizedCloud target = random_target(3);
    Cloud source = with_some_opposite(source_along_rays(target.cloud, 5));
    drop_unknown_viewpoints(one, source, target.cloud);
    const auto pairs =
        ProjectiveMatcher(target.cloud, target.index, kMatchCamera).match(source, Rigid3{}, one.gates, 1);
    EXPECT_EQ(pairs, projective_slowly(source, target, Rigid3{}, one.gates));
    EXPECT_GT(pairs.size(), 500u);
  }
}

// The view of a camera on a wall, without directions: a point in every pixel except the omitted ones.
OrganizedCloud wall_without(float depth, const std::vector<int>& pixels) {
  DepthImage image{kMatchCamera.width, kMatchCamera.height,
                   std::vector<float>(kMatchCamera.width * kMatchCamera.height, depth)};
  for (const int pixel : pixels) image.depth[pixel] = std::nanf("");
  OrganizedCloud seen = unproject(image, kMatchCamera);
  seen.cloud.directions.assign(seen.cloud.size(), Vec3f::Zero());
  seen.cloud.structures.assign(seen.cloud.size(), Structure::None);
  return seen;
}

TEST(ProjectiveMatcher, HolesOfOneImageAloneMakeNoPairs) {
  const OrganizedCloud whole = wall_without(1.0f, {}), holes = wall_without(1.0f, {0, 70, 71, 700, 3071});
  for (const auto& [source, target] : {std::pair{whole, holes}, {holes, whole}, {holes, holes}}) {
    const auto pairs =
        ProjectiveMatcher(target.cloud, target.index, kMatchCamera).match(source.cloud, Rigid3{}, Gates{}, 1);
    EXPECT_EQ(pairs, projective_slowly(source.cloud, target, Rigid3{}, Gates{}));
    EXPECT_EQ(pairs.size(), holes.cloud.size());
  }
}

TEST(ProjectiveMatcher, TheDistanceGateIsWhereItIsSaidToBe) {
  const OrganizedCloud source = wall_without(1.0f, {}), target = wall_without(1.25f, {});
  const ProjectiveMatcher matcher(target.cloud, target.index, kMatchCamera);
  const double farthest = 0.25 * std::hypot(31.5 / 50.0, 23.5 / 60.0, 1.0);  // in the image's corners
  Gates gates;
  gates.max_distance = 1.0001 * farthest;
  EXPECT_EQ(matcher.match(source.cloud, Rigid3{}, gates, 1).size(), target.cloud.size());
  gates.max_distance = 0.9999 * farthest;
  EXPECT_EQ(matcher.match(source.cloud, Rigid3{}, gates, 1).size(), target.cloud.size() - 4);
}

// More pixels than in one block: the results of blocks are joined without gaps.
TEST(ProjectiveMatcher, BlocksOfPixelsJoin) {
  const Pinhole camera{200.0, 200.0, 109.5, 89.5, 220, 180};
  const OrganizedCloud target = random_target(6, camera);
  ASSERT_GT(target.index.index.size(), 2 * kLightBlockSize);
  const Cloud source = source_near(target.cloud, 7);
  const Rigid3 pose{Eigen::Quaterniond::Identity(), {0.01, 0.0, 0.0}};
  EXPECT_EQ(ProjectiveMatcher(target.cloud, target.index, camera).match(source, pose, Gates{}, 2),
            projective_slowly(source, target, pose, Gates{}, camera));
}

// Few points are looked up one by one: a pair of all points is found again if its source point is among the few, and no
// other pair is but of points that others hid.
TEST(ProjectiveMatcher, FewPointsFindWhatTheyFindAmongAll) {
  const OrganizedCloud target = random_target(3);
  const Cloud all = source_near(target.cloud, 4);
  std::vector<std::uint32_t> few;
  for (std::uint32_t j = 0; j < all.size(); j += 20) few.push_back(j);
  const Rigid3 pose{Eigen::Quaterniond::Identity(), {0.01, 0.0, 0.0}};
  const ProjectiveMatcher matcher(target.cloud, target.index, kMatchCamera);
  const auto pairs_of_all = matcher.match(all, pose, Gates{}, 1),
             pairs_of_few = matcher.match(select(all, few), pose, Gates{}, 1);
  const IndexImage seen = project(all, pose, kMatchCamera, kMatchCamera.width, kMatchCamera.height, 1);
  std::size_t num_again = 0;
  for (const Correspondence& pair : pairs_of_few) {
    const Correspondence same{few[pair.source], pair.target};
    if (std::find(pairs_of_all.begin(), pairs_of_all.end(), same) != pairs_of_all.end())
      ++num_again;
    else
      EXPECT_EQ(std::find(seen.index.begin(), seen.index.end(), static_cast<std::int32_t>(same.source)),
                seen.index.end());
  }
  const auto is_of_few = [](const Correspondence& pair) { return pair.source % 20 == 0; };
  EXPECT_EQ(num_again, static_cast<std::size_t>(std::count_if(pairs_of_all.begin(), pairs_of_all.end(), is_of_few)));
  EXPECT_GT(num_again, 30u);
}

TEST(ProjectiveMatcher, AnImagePairsWithItself) {
  const OrganizedCloud target = random_target(5);
  const auto pairs =
      ProjectiveMatcher(target.cloud, target.index, kMatchCamera).match(target.cloud, Rigid3{}, Gates{}, 2);
  ASSERT_EQ(pairs.size(), target.cloud.size());
  for (std::uint32_t k = 0; k < pairs.size(); ++k) EXPECT_EQ(pairs[k], (Correspondence{k, k}));
}

// One pair whose directions differ by degrees; both matchers are asked.
struct OnePair {
  Cloud source;
  OrganizedCloud target;

  OnePair(Structure of_source, Structure of_target, double degrees) {
    target.index = IndexImage(64, 48);
    target.index.index[24 * 64 + 32] = 0;
    target.cloud.points = {Vec3f(0.01f, 0.01f, 1.0f)};
    target.cloud.structures = {of_target};
    target.cloud.directions = {of_target == Structure::None ? Vec3f::Zero() : Vec3f(0.0f, 0.0f, -1.0f)};
    target.cloud.viewpoint = Vec3f::Zero();
    source = target.cloud;
    source.structures = {of_source};
    const double angle = degrees * std::numbers::pi / 180.0;
    source.directions = {of_source == Structure::None
                             ? Vec3f::Zero()
                             : Vec3f(static_cast<float>(std::sin(angle)), 0.0f, -static_cast<float>(std::cos(angle)))};
  }

  bool passes(const Gates& gates, const Rigid3& pose = {}) const {
    const auto nearest = NearestMatcher(target.cloud).match(source, pose, gates, 1);
    const auto projective = ProjectiveMatcher(target.cloud, target.index, kMatchCamera).match(source, pose, gates, 1);
    EXPECT_EQ(nearest, projective);
    return !nearest.empty();
  }
};

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(Gates, PairsTooFarApartAreDropped) {
  const OnePair pair(Structure::None, Structure::None, 0.0);
  Gates gates;
  gates.max_distance = 0.1;
  for (const auto& [distance, passes] : {std::pair{0.0, true}, {0.099, true}, {0.101, false}})
    EXPECT_EQ(pair.passes(gates, {Eigen::Quaterniond::Identity(), Vec3d(0.0, 0.0, distance)}), passes) << distance;
}

TEST(Gates, NormalsCompareWithTheirSignWhereBothSensorsAreKnown) {
  for (const auto& [degrees, passes] :
       {std::pair{29.0, true}, {31.0, false}, {90.0, false}, {151.0, false}, {180.0, false}})
    EXPECT_EQ(OnePair(Structure::Planar, Structure::Planar, degrees).passes({.max_angle = 30.0 * kDegree}), passes)
        << degrees;
}

TEST(Gates, NormalsCompareWithoutSignWhereASensorIsUnknown) {
  for (bool of_source : {true, false})
    for (const auto& [degrees, passes] :
         {std::pair{29.0, true}, {31.0, false}, {149.0, false}, {151.0, true}, {180.0, true}}) {
      OnePair pair(Structure::Planar, Structure::Planar, degrees);
      (of_source ? pair.source : pair.target.cloud).viewpoint.reset();
      EXPECT_EQ(pair.passes({.max_angle = 30.0 * kDegree}), passes) << degrees;
    }
}

TEST(Gates, TangentsCompareWithoutSign) {
  for (const auto& [degrees, passes] :
       {std::pair{29.0, true}, {31.0, false}, {149.0, false}, {151.0, true}, {180.0, true}})
    EXPECT_EQ(OnePair(Structure::Edge, Structure::Edge, degrees).passes({.max_angle = 30.0 * kDegree}), passes)
        << degrees;
}

TEST(Gates, SourceDirectionsTurnWithThePose) {
  const OnePair pair(Structure::Planar, Structure::Planar, 40.0);
  // About y through the point itself, by the angle between the directions.
  const Eigen::Quaterniond back(Eigen::AngleAxisd(40.0 * kDegree, Vec3d::UnitY()));
  const Vec3d point = pair.source.points[0].cast<double>();
  EXPECT_TRUE(pair.passes({.max_angle = 1.0 * kDegree}, {back, point - back * point}));
  EXPECT_FALSE(pair.passes({.max_angle = 30.0 * kDegree}, {back.inverse(), point - back.inverse() * point}));
}

TEST(Gates, PlanesAndEdgesPairUnlessStructuresMustBeTheSame) {
  constexpr Structure kNone = Structure::None, kPlanar = Structure::Planar, kEdge = Structure::Edge;
  for (const auto& [of_source, of_target, same] : {std::tuple{kPlanar, kPlanar, true},
                                                   {kEdge, kEdge, true},
                                                   {kPlanar, kEdge, false},
                                                   {kEdge, kPlanar, false},
                                                   {kNone, kPlanar, true},
                                                   {kPlanar, kNone, true},
                                                   {kNone, kEdge, true},
                                                   {kEdge, kNone, true},
                                                   {kNone, kNone, true}}) {
    const OnePair pair(of_source, of_target, 0.0);
    EXPECT_EQ(pair.passes({.same_structure = true}), same);
    EXPECT_TRUE(pair.passes({.max_angle = 0.1}));
  }
}

TEST(Gates, CloudsWithoutDirectionsPassAllButTheDistance) {
  OnePair pair(Structure::Planar, Structure::Edge, 90.0);
  pair.source.directions.clear();
  pair.source.structures.clear();
  EXPECT_TRUE(pair.passes({.max_angle = 0.1, .same_structure = true}));
}

TEST(Gates, BadOnesAreRefused) {
  const OnePair pair(Structure::None, Structure::None, 0.0);
  for (double bad : {0.0, -1.0, std::nan("")}) {
    for (const Gates& gates : {Gates{.max_distance = bad}, Gates{.max_angle = bad}}) {
      EXPECT_THROW(NearestMatcher(pair.target.cloud).match(pair.source, {}, gates, 1), std::invalid_argument);
      EXPECT_THROW(
          ProjectiveMatcher(pair.target.cloud, pair.target.index, kMatchCamera).match(pair.source, {}, gates, 1),
          std::invalid_argument);
    }
  }
}

TEST(Matcher, EmptyCloudsGiveNoPairs) {
  const OrganizedCloud target = random_target(6), nothing{{}, IndexImage(64, 48)};
  EXPECT_TRUE(NearestMatcher(target.cloud).match({}, {}, {}, 2).empty());
  EXPECT_TRUE(NearestMatcher(nothing.cloud).match(target.cloud, {}, {}, 2).empty());
  EXPECT_TRUE(ProjectiveMatcher(target.cloud, target.index, kMatchCamera).match({}, {}, {}, 2).empty());
  EXPECT_TRUE(ProjectiveMatcher(nothing.cloud, nothing.index, kMatchCamera).match(target.cloud, {}, {}, 2).empty());
}

TEST(Matcher, SameForAnyNumberOfThreads) {
  constexpr Pinhole kLargeCamera{200.0, 240.0, 127.5, 95.5, 256, 192};  // three blocks of pixels
  const OrganizedCloud target = random_target(7, kLargeCamera);
  const Cloud source = random_extended_points(2 * kLightBlockSize + 5, 1.0, 8);
  const Rigid3 pose{Eigen::Quaterniond::Identity(), Vec3d(0.0, 0.0, 1.2)};
  const Gates gates{.max_distance = 0.2, .max_angle = 0.8, .same_structure = true};
  const NearestMatcher nearest(target.cloud);
  const ProjectiveMatcher projective(target.cloud, target.index, kLargeCamera);
  for (const Matcher* matcher : {static_cast<const Matcher*>(&nearest), static_cast<const Matcher*>(&projective)}) {
    const auto expected = matcher->match(source, pose, gates, 1);
    EXPECT_GT(expected.size(), 100u);
    for (int num_threads = 2; num_threads <= 8; ++num_threads)
      EXPECT_EQ(matcher->match(source, pose, gates, num_threads), expected);
  }
}

TEST(Matcher, AllPairsAreKeptWhateverTheirNumber) {
  for (std::size_t count : {std::size_t{1}, kBlockSize - 1, kBlockSize, kBlockSize + 1}) {
    const Cloud cloud = random_extended_points(count, 1.0, 9);
    EXPECT_EQ(NearestMatcher(cloud).match(cloud, {}, {}, 3).size(), count);
  }
}

}  // namespace
}  // namespace augicp
