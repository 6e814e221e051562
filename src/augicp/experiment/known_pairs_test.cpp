// SPDX-License-Identifier: MIT
#include "augicp/experiment/known_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace augicp {
namespace {

Vec3d point_error(const KnownPairs& known, const Correspondence& pair) {
  return known.target.points[pair.target].cast<double>() -
         known.target_from_source * known.source.points[pair.source].cast<double>();
}

TEST(KnownPairs, WithoutNoiseNothingRemainsUnderTheTruth) {
  const KnownPairs known = make_known_pairs({});
  ASSERT_EQ(known.pairs.size(), 20000u);
  for (const Correspondence& pair : known.pairs) {
    EXPECT_LE(point_error(known, pair).norm(), 3e-6);
    const Vec3d turned = known.target_from_source.rotation * known.source.directions[pair.source].cast<double>();
    EXPECT_LE((known.target.directions[pair.target].cast<double>() - turned).norm(), 5e-7);
    EXPECT_EQ(known.source.structures[pair.source], known.target.structures[pair.target]);
  }
}

TEST(KnownPairs, TruthIsThirtyDegreesAndOneMetreAway) {
  const KnownPairs known = make_known_pairs({});
  EXPECT_NEAR(angle_between(known.target_from_source, Rigid3{}), std::numbers::pi / 6.0, 1e-12);
  EXPECT_NEAR(known.target_from_source.translation.norm(), 1.0, 1e-12);
}

TEST(KnownPairs, EveryStructureIsThere) {
  const KnownPairs known = make_known_pairs({});
  std::vector<int> count(3, 0);
  for (std::size_t i = 0; i < known.target.size(); ++i) {
    const Structure structure = known.target.structures[i];
    ++count[static_cast<int>(structure)];
    EXPECT_NEAR(known.target.directions[i].norm(), structure == Structure::None ? 0.0 : 1.0, 1e-6);
  }
  EXPECT_NEAR(count[static_cast<int>(Structure::None)], 2000, 200);
  EXPECT_NEAR(count[static_cast<int>(Structure::Planar)], 14000, 400);
  EXPECT_NEAR(count[static_cast<int>(Structure::Edge)], 4000, 300);
}

TEST(KnownPairs, NormalsPointToTheSensorInBothClouds) {
  const KnownPairs known = make_known_pairs({});
  for (const Cloud* cloud : {&known.source, &known.target}) {
    ASSERT_TRUE(cloud->viewpoint);
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      if (cloud->structures[i] != Structure::Planar) continue;
      EXPECT_GT(cloud->directions[i].dot(*cloud->viewpoint - cloud->points[i]), 0.0f);
    }
  }
}

TEST(KnownPairs, NoiseHasTheStatedSize) {
  KnownPairsOptions options;
  options.point_noise_m = 0.02;
  options.normal_noise_rad = 0.1;
  const KnownPairs known = make_known_pairs(options);
  double squared_distance = 0.0, squared_angle = 0.0;
  int num_planar = 0;
  for (const Correspondence& pair : known.pairs) {
    squared_distance += point_error(known, pair).squaredNorm();
    if (known.target.structures[pair.target] != Structure::Planar) continue;
    const Vec3f& normal = known.target.directions[pair.target];  // the exact one is along an axis
    squared_angle += std::pow(std::acos(std::min(1.0f, normal.cwiseAbs().maxCoeff())), 2);
    ++num_planar;
  }
  // Three coordinates, and noise on both sides.
  const double per_coordinate = std::sqrt(squared_distance / (6.0 * static_cast<double>(known.pairs.size())));
  EXPECT_NEAR(per_coordinate, 0.02, 0.0004);
  EXPECT_NEAR(std::sqrt(squared_angle / num_planar), 0.1, 0.003);
}

TEST(KnownPairs, StatedShareOfPairsIsFalse) {
  for (double share : {0.5, 0.9}) {
    KnownPairsOptions options;
    options.outlier_share = share;
    const KnownPairs known = make_known_pairs(options);
    int num_false = 0;
    for (std::uint32_t i = 0; i < known.pairs.size(); ++i) {
      EXPECT_EQ(known.pairs[i].source, i);
      num_false += known.pairs[i].target != i;
    }
    EXPECT_NEAR(num_false / 20000.0, share, 0.015);
  }
}

TEST(KnownPairs, SeedDecidesEverything) {
  KnownPairsOptions options{.num_points = 100, .point_noise_m = 0.01, .seed = 5};
  EXPECT_EQ(make_known_pairs(options).source.points, make_known_pairs(options).source.points);
  const KnownPairs first = make_known_pairs(options);
  options.seed = 6;
  EXPECT_NE(make_known_pairs(options).source.points, first.source.points);
}

TEST(KnownPairs, NoPointsGiveNoPairs) { EXPECT_TRUE(make_known_pairs({.num_points = 0}).pairs.empty()); }

}  // namespace
}  // namespace augicp
