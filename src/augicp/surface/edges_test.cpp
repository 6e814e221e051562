// SPDX-License-Identifier: MIT
// The goal for edges, measured on generated depth images of a Kinect's size, without and with its noise:
//
//   found  of the points of a crease at least 90 % are edges with a tangent within 5 degrees of the crease;
//   false  of the points beside a depth discontinuity at most 2 % are edges.
//
// The points of a crease are those within one radius of a crease of which both sides are seen, as long as the crease is
// straight there: it runs on for a radius both ways from the foot of the point, and no other crease with another
// tangent is within a radius of the point. The points beside a discontinuity are those within a radius, in pixels, of a
// jump in depth; points within two radii of a crease that is seen are left out, for their neighbours' neighbours lie on
// it. All distances are between true points, not noisy ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "augicp/surface/estimate_surface.h"
#include "augicp/surface/window_neighbourhood.h"
#include "augicp/testing/edge_truth.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using namespace augicp::testing;

constexpr double kRadius = 0.05;  // of the ball, metres
constexpr double kJump = 0.1;     // in depth, metres
constexpr double kMaxTangentErrorDeg = 5.0;

double angle_between_lines_deg(const Vec3d& a, const Vec3d& b) {
  return std::acos(std::min(1.0, std::abs(a.normalized().dot(b.normalized())))) * 180.0 / std::numbers::pi;
}

double distance_to(const Crease& crease, const Vec3d& point) { return nearest_crease({crease}, point).distance; }

// Whether the crease nearest to the point is the only one there and goes on as it is for a radius both ways.
bool is_straight_near(const std::vector<Crease>& creases, const NearestCrease& nearest, const Vec3d& point) {
  std::vector<Crease> along;  // the nearest crease, and pieces that carry it on
  for (const Crease& crease : creases) {
    if (angle_between_lines_deg(crease.tangent(), nearest.tangent) <= kMaxTangentErrorDeg)
      along.push_back(crease);
    else if (distance_to(crease, point) <= kRadius)
      return false;
  }
  const auto goes_on = [&](double shift) {
    return nearest_crease(along, point + shift * nearest.tangent).distance <= nearest.distance + 0.1 * kRadius;
  };
  return goes_on(kRadius) && goes_on(-kRadius);
}

struct EdgeShares {
  int num_crease = 0, num_found = 0;  // points of creases; those of them that are edges with the right tangent
  int num_beside = 0, num_false = 0;  // points beside a discontinuity; those of them that are edges
  int num_plain = 0, num_plain_false = 0;  // points far from both; those of them that are not planar
  double found() const { return static_cast<double>(num_found) / std::max(num_crease, 1); }
  double false_beside() const { return static_cast<double>(num_false) / std::max(num_beside, 1); }
  double false_plain() const { return static_cast<double>(num_plain_false) / std::max(num_plain, 1); }
};

// A jump is looked for within the radius' size in pixels at the middle of the depths that these scenes have.
int radius_px(const Rendering& seen) { return static_cast<int>(std::lround(kRadius * seen.camera.fx / 1.5)); }

EdgeShares edge_shares(const Scene& scene, const Rendering& seen, const OrganizedCloud& estimated) {
  const OrganizedCloud truth = unproject(seen.depth, seen.camera);
  const std::vector<Crease> creases = visible_creases(scene, seen, kRadius);
  const std::vector<bool> beside = beside_discontinuity(seen, radius_px(seen), kJump);
  EdgeShares shares;
  for (std::size_t pixel = 0; pixel < seen.surface.size(); ++pixel) {
    const std::int32_t i = truth.index.index[pixel];
    if (i == IndexImage::kNone) continue;
    const Vec3d point = truth.cloud.points[i].cast<double>();
    const Structure structure = estimated.cloud.structures[i];
    const bool is_edge = structure == Structure::Edge;
    const NearestCrease nearest = nearest_crease(creases, point);
    if (nearest.distance <= kRadius && is_straight_near(creases, nearest, point)) {
      ++shares.num_crease;
      shares.num_found += is_edge && angle_between_lines_deg(estimated.cloud.directions[i].cast<double>(),
                                                             nearest.tangent) <= kMaxTangentErrorDeg;
    } else if (nearest.distance > 2.0 * kRadius) {
      ++(beside[pixel] ? shares.num_beside : shares.num_plain);
      if (beside[pixel]) shares.num_false += is_edge;
      else shares.num_plain_false += structure != Structure::Planar;
    }
  }
  return shares;
}

struct EdgeCase {
  std::string name;
  std::function<Scene()> scene;
  double noise;  // standard deviation at 1 m, metres
  int width = 640;
};

OrganizedCloud with_surface(DepthImage depth, const EdgeCase& c, const Pinhole& camera) {
  if (c.noise > 0.0) add_depth_noise(depth, c.noise, 1);
  OrganizedCloud seen = unproject(depth, camera);
  WindowOptions options;
  options.radius = kRadius;
  estimate_surface(seen.cloud, WindowNeighbourhood(seen.cloud, seen.index, options, 0), {}, 0);
  return seen;
}

std::string percent(double share) { return std::to_string(std::lround(1000.0 * share) / 10.0).substr(0, 4) + " %"; }

class Edges : public ::testing::TestWithParam<EdgeCase> {};

TEST_P(Edges, FoundOnCreasesAndNotBesideJumps) {
  const Scene scene = GetParam().scene();
  const Rendering seen = render(scene, kinect_like_camera(GetParam().width));
  const EdgeShares shares = edge_shares(scene, seen, with_surface(seen.depth, GetParam(), seen.camera));
  RecordProperty("found", percent(shares.found()));
  RecordProperty("false_beside", percent(shares.false_beside()));
  RecordProperty("false_plain", percent(shares.false_plain()));
  printf("%-24s crease %6d found %s   beside %6d false %s   plain %6d not planar %s\n", GetParam().name.c_str(), shares.num_crease, percent(shares.found()).c_str(), shares.num_beside, percent(shares.false_beside()).c_str(), shares.num_plain, percent(shares.false_plain()).c_str());
  if (shares.num_crease > 0) {
    EXPECT_GE(shares.found(), 0.9) << "of " << shares.num_crease;
  }
  EXPECT_LE(shares.false_beside(), 0.02) << "of " << shares.num_beside;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Edges,
                         ::testing::Values(EdgeCase{"BoxOnTable", box_on_table, 0.0},
                                           EdgeCase{"BoxOnTableNoisy", box_on_table, kKinectSigmaAt1m},
                                           EdgeCase{"RoomCorner", room_corner, 0.0},
                                           EdgeCase{"RoomCornerNoisy", room_corner, kKinectSigmaAt1m},
                                           EdgeCase{"Wire", wire, 0.0}, EdgeCase{"WireNoisy", wire, kKinectSigmaAt1m},
                                           EdgeCase{"DepthStep", depth_step, 0.0},
                                           EdgeCase{"DepthStepNoisy", depth_step, kKinectSigmaAt1m}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace augicp
