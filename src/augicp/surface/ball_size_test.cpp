// SPDX-License-Identifier: MIT
#include "augicp/surface/ball_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

// By searching every ball.
double searched_size(const Cloud& cloud, double radius) {
  const Channels ones = Channels::Ones(1, static_cast<Eigen::Index>(cloud.size()));
  return BallNeighbourhood(cloud, {radius, 0, 0.0}, 0).sum(ones, 0).mean();
}

double estimated_size(const Cloud& cloud, double radius) {
  return mean_ball_size(cloud, CellGrid(cloud, radius), radius);
}

// Points near a sensor are a hundred times as dense as those far from it.
Cloud uneven_cloud(unsigned seed) {
  Cloud cloud = testing::random_points(6000, 1.0, seed);
  for (Vec3f& point : cloud.points) point *= std::pow(point.norm(), 2.0f);
  return cloud;
}

TEST(BallSize, IsNearTheSizeOfAllBalls) {
  for (unsigned seed = 1; seed <= 5; ++seed)
    for (const Cloud& cloud : {testing::random_points(5000, 1.0, seed), uneven_cloud(seed)})
      for (double radius : {0.05, 0.2, 0.5}) {
        const double searched = searched_size(cloud, radius);
        EXPECT_NEAR(estimated_size(cloud, radius), searched, 0.2 * searched) << "radius " << radius;
      }
}

TEST(BallSize, OfEqualPointsIsTheirNumber) {
  Cloud equal;
  equal.points.assign(100000, Vec3f(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(estimated_size(equal, 0.1), 100000.0);
}

TEST(BallSize, OfFewPointsIsExactWhereEachIsAsked) {
  Cloud pair;
  pair.points = {Vec3f(0.0f, 0.0f, 0.0f), Vec3f(0.0f, 0.0f, 0.5f)};
  EXPECT_EQ(estimated_size(pair, 0.4), 1.0);
  EXPECT_EQ(estimated_size(pair, 0.6), 2.0);
  EXPECT_EQ(estimated_size(Cloud{}, 0.6), 0.0);
  EXPECT_EQ(estimated_size(pair, 1e-25), 0.0);  // its square is zero in float
}

}  // namespace
}  // namespace augicp
