// SPDX-License-Identifier: MIT
#include "augicp/match/range_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "augicp/match/cube_cells.h"
#include "augicp/match/matcher.h"

namespace augicp {
namespace {

constexpr float kRangeTolerance = 0.1f;
constexpr std::size_t kNumRays = 40000;

// The nearest surface of a box from -half to half along a ray from a place within it.
float range_within(const Vec3f& place, const Vec3f& ray, const Vec3f& half) {
  float range = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (ray[axis] != 0.0f)
      range = std::min(range, ((ray[axis] > 0.0f ? half[axis] : -half[axis]) - place[axis]) / ray[axis]);
  return range;
}

// The same from without; infinity if the ray misses it.
float range_to(const Vec3f& place, const Vec3f& ray, const Vec3f& centre, float half) {
  const Eigen::Array3f one = (centre - place).array() - half, other = one + 2.0f * half;
  const Eigen::Array3f to_one = one / ray.array(), to_other = other / ray.array();
  const float enter = to_one.min(to_other).maxCoeff(), leave = to_one.max(to_other).minCoeff();
  return enter < leave && enter > 0.0f ? enter : std::numeric_limits<float>::infinity();
}

Vec3f random_ray(std::mt19937& generator) {
  std::normal_distribution<float> normal;
  return Vec3f(normal(generator), normal(generator), normal(generator)).normalized();
}

// A room of 6 x 4 x 3 m with a cube of 0.8 m in it, seen all around from a place; relative to that place.
const Vec3f kHalfRoom(3.0f, 2.0f, 1.5f), kCube(1.5f, 0.5f, -0.8f);
Cloud room_from(const Vec3f& place, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  for (std::size_t k = 0; k < kNumRays; ++k) {
    const Vec3f ray = random_ray(generator);
    const float range = std::min(range_within(place, ray, kHalfRoom), range_to(place, ray, kCube, 0.4f));
    cloud.points.push_back(range * ray);
  }
  return cloud;
}

double share_of(Sight sight, const RangeImage& image, const Cloud& points, const Vec3f& moved) {
  const auto count = std::count_if(points.points.begin(), points.points.end(),
                                   [&](const Vec3f& p) { return image.sight(p + moved, kRangeTolerance) == sight; });
  return static_cast<double>(count) / static_cast<double>(points.size());
}

// Within a face the neighbours are found without a way round the cube's edges.
TEST(CubeCells, AroundAreThoseOfTheDirectionsAround) {
  std::mt19937 generator(5);
  for (const int cells_per_edge : {8, 64, 256})
    for (int repetition = 0; repetition < 2000; ++repetition) {
      const FacePoint at = on_cube(random_ray(generator));
      const auto around = cells_around(at, cells_per_edge);
      const float step = 2.0f / static_cast<float>(cells_per_edge);
      std::size_t k = 0;
      for (const float dv : {-step, 0.0f, step})
        for (const float du : {-step, 0.0f, step})
          EXPECT_EQ(around[k++], cell_of(on_cube(direction_of({at.face, at.u + du, at.v + dv})), cells_per_edge));
    }
}

TEST(RangeImage, OwnPointsAreAtTheSurface) {
  const Cloud room = room_from(Vec3f::Zero(), 1);
  const RangeImage image(room, Vec3f::Zero());
  EXPECT_EQ(share_of(Sight::AtSurface, image, room, Vec3f::Zero()), 1.0);
}

// Along one ray: free, at the surface, hidden, in this order.
TEST(RangeImage, NearerIsFreeAndFartherIsHidden) {
  const Cloud room = room_from(Vec3f::Zero(), 1);
  const RangeImage image(room, Vec3f::Zero());
  for (const Vec3f& axis : {Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, -1), Vec3f(-1, 0, 0)}) {
    const float range = range_within(Vec3f::Zero(), axis, kHalfRoom);
    EXPECT_EQ(image.sight((range - 0.5f) * axis, kRangeTolerance), Sight::Free);
    EXPECT_EQ(image.sight(range * axis, kRangeTolerance), Sight::AtSurface);
    EXPECT_EQ(image.sight((range + 0.5f) * axis, kRangeTolerance), Sight::Hidden);
  }
}

TEST(RangeImage, WhereNothingWasSeenIsOutOfView) {
  Cloud half = room_from(Vec3f::Zero(), 1);
  std::erase_if(half.points, [](const Vec3f& point) { return point.x() < 0.0f; });
  const RangeImage image(half, Vec3f::Zero());
  EXPECT_EQ(image.sight({-1.0f, 0.0f, 0.0f}, kRangeTolerance), Sight::OutOfView);
  EXPECT_EQ(image.sight({1.0f, 0.0f, 0.0f}, kRangeTolerance), Sight::Free);
  EXPECT_EQ(image.sight(Vec3f::Zero(), kRangeTolerance), Sight::OutOfView);  // no line of sight has a direction there
}

// What one place sees lies in no other place's free space, if the pose is right; if it is not, much does.
TEST(RangeImage, OnlyWrongPosesPutSurfacesIntoFreeSpace) {
  const Vec3f elsewhere(-0.6f, 0.4f, 0.3f);
  const Cloud target = room_from(Vec3f::Zero(), 1), source = room_from(elsewhere, 2);
  const RangeImage image(target, Vec3f::Zero());
  EXPECT_LT(share_of(Sight::Free, image, source, elsewhere), 0.002);
  EXPECT_GT(share_of(Sight::Free, image, source, elsewhere + Vec3f(0.5f, 0.0f, 0.0f)), 0.05);
  EXPECT_GT(share_of(Sight::Free, image, source, elsewhere + Vec3f(0.0f, 0.0f, 0.3f)), 0.05);
}

// Moved and turned with its place, it says the same. Cells are fixed to the axes, so that single points near their
// borders may change.
TEST(RangeImage, DependsOnTheScanAlone) {
  const Cloud room = room_from(Vec3f::Zero(), 1), other = room_from({-0.6f, 0.4f, 0.3f}, 2);
  const Rigid3 b_from_a{Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3d(1, 2, 3).normalized())), {4, 5, 6}};
  const Cloud moved = transform(room, b_from_a), other_moved = transform(other, b_from_a);
  const RangeImage image(room, Vec3f::Zero()), image_moved(moved, (b_from_a.translation - moved.origin).cast<float>());
  std::size_t num_alike = 0;
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Vec3f place = (other_moved.origin - moved.origin).cast<float>() + other_moved.points[i];
    if (image.sight(other.points[i], kRangeTolerance) == image_moved.sight(place, kRangeTolerance)) ++num_alike;
  }
  EXPECT_GT(static_cast<double>(num_alike) / static_cast<double>(other.size()), 0.97);
}

TEST(LinesOfSight, AreKnownOnlyFromThePlaceOfTheSensor) {
  const Cloud room = room_from(Vec3f::Zero(), 1);
  EXPECT_TRUE(lines_of_sight(room, kRangeTolerance));
  Cloud elsewhere = room;
  for (Vec3f& point : elsewhere.points) point += Vec3f(-1.4f, 0.5f, 0.6f);
  EXPECT_FALSE(lines_of_sight(elsewhere, kRangeTolerance));
  elsewhere.viewpoint = Vec3f(-1.4f, 0.5f, 0.6f);
  ASSERT_TRUE(lines_of_sight(elsewhere, kRangeTolerance));
  EXPECT_EQ(lines_of_sight(elsewhere, kRangeTolerance)->place(), *elsewhere.viewpoint);
  EXPECT_FALSE(lines_of_sight(Cloud{}, kRangeTolerance));
}

// Points relative to an origin are seen from the zero of their frame, not from the origin.
TEST(LinesOfSight, OriginsAreNotPlacesOfSensors) {
  Cloud room = room_from(Vec3f::Zero(), 1);
  for (Vec3f& point : room.points) point -= Vec3f(1.0f, 0.0f, 0.0f);
  room.origin = Vec3d(1.0, 0.0, 0.0);
  ASSERT_TRUE(lines_of_sight(room, kRangeTolerance));
  EXPECT_EQ(lines_of_sight(room, kRangeTolerance)->place(), Vec3f(-1.0f, 0.0f, 0.0f));
}

// A merged model hides one side behind the other from wherever it is seen.
TEST(LinesOfSight, AClosedObjectSeenFromOutsideHasNone) {
  std::mt19937 generator(3);
  Cloud ball;
  for (std::size_t k = 0; k < 5000; ++k) ball.points.push_back(Vec3f(3.0f, 0.0f, 0.0f) + random_ray(generator));
  EXPECT_FALSE(lines_of_sight(ball, kRangeTolerance));
}

// The nearest points of a target with lines of sight see through what those of a bare one do not see.
TEST(LinesOfSight, TellFreeAndHiddenFromUnseen) {
  const Cloud room = room_from(Vec3f::Zero(), 1);
  const Cloud within = [&] {
    Cloud half = room;
    for (Vec3f& point : half.points) point *= 0.7f;
    return half;
  }();
  const AgreementTolerance tolerance{.distance = 0.05};
  const NearestMatcher bare(room), sighted(room, lines_of_sight(room, kRangeTolerance));
  const Agreement of_bare = bare.agreement(within, {}, tolerance, 1),
                  of_sighted = sighted.agreement(within, {}, tolerance, 1);
  EXPECT_FALSE(bare.knows_free_space());
  EXPECT_TRUE(sighted.knows_free_space());
  EXPECT_EQ(of_bare.conflict, 0);
  EXPECT_GT(of_sighted.conflict, of_sighted.total() * 9 / 10);
  EXPECT_EQ(of_sighted.agree, of_bare.agree);
  EXPECT_EQ(of_sighted.total(), of_bare.total());
}

}  // namespace
}  // namespace augicp
