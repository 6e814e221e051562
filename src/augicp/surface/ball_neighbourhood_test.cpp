// SPDX-License-Identifier: MIT
#include "augicp/surface/ball_neighbourhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::uniform;

Cloud random_cloud(int count, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  for (int i = 0; i < count; ++i)
    cloud.points.push_back(
        Vec3d(uniform(generator, 0, 1), uniform(generator, 0, 1), uniform(generator, 0, 0.2)).cast<float>());
  return cloud;
}

Channels random_channels(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  Channels values(3, static_cast<Eigen::Index>(count));
  for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = uniform(generator, -1, 1);
  return values;
}

// All points within the radius; if there are too few, the nearest min_points of those within max_radius.
Channels brute_force_sum(const Cloud& cloud, const BallOptions& options, const Channels& values) {
  Channels sums = Channels::Zero(values.rows(), values.cols());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::vector<std::pair<float, std::size_t>> by_distance;
    for (std::size_t k = 0; k < cloud.size(); ++k)
      by_distance.emplace_back((cloud.points[k] - cloud.points[i]).squaredNorm(), k);
    std::sort(by_distance.begin(), by_distance.end());
    const double max_radius = std::max(options.radius, options.max_radius);
    for (std::size_t rank = 0; rank < by_distance.size(); ++rank) {
      const double distance = std::sqrt(static_cast<double>(by_distance[rank].first));
      if (distance < options.radius || (rank < options.min_points && distance < max_radius))
        sums.col(static_cast<Eigen::Index>(i)) += values.col(static_cast<Eigen::Index>(by_distance[rank].second));
    }
  }
  return sums;
}

TEST(BallNeighbourhood, EqualsBruteForce) {
  for (const BallOptions& options : {BallOptions{0.1, 0, 0.0}, BallOptions{0.05, 10, 0.3}, BallOptions{0.05, 10, 0.07},
                                     BallOptions{1e-6, 5, 10.0}, BallOptions{10.0, 0, 0.0}}) {
    for (int count : {1, 2, 7, 300}) {
      const Cloud cloud = random_cloud(count, 3);
      const Channels values = random_channels(cloud.size(), 4);
      const Channels sums = BallNeighbourhood(cloud, options, 0).sum(values, 0);
      EXPECT_LT((sums - brute_force_sum(cloud, options, values)).abs().maxCoeff(), 1e-12)
          << count << " points, radius " << options.radius << ", at least " << options.min_points;
    }
  }
}

TEST(BallNeighbourhood, DuplicatesCountOneByOne) {
  Cloud cloud;
  cloud.points.assign(20, Vec3f(1.0f, 2.0f, 3.0f));
  const Channels ones = Channels::Ones(1, 20);
  EXPECT_TRUE((BallNeighbourhood(cloud, {0.01, 0, 0.0}, 0).sum(ones, 0) == 20.0).all());
}

// A ball whose squared radius rounds to zero in float is empty, and takes no time on any number of points.
TEST(BallNeighbourhood, BallsTooSmallForFloatAreEmpty) {
  Cloud cloud;
  cloud.points.assign(200000, Vec3f(1.0f, 2.0f, 3.0f));
  const Channels ones = Channels::Ones(1, 200000);
  EXPECT_TRUE((BallNeighbourhood(cloud, {1e-25, 0, 0.0}, 0).sum(ones, 0) == 0.0).all());
}

TEST(BallNeighbourhood, EmptyCloudHasNoSums) {
  EXPECT_EQ(BallNeighbourhood(Cloud{}, {0.1, 5, 1.0}, 0).sum(Channels(2, 0), 0).cols(), 0);
}

TEST(BallNeighbourhood, ThreadsDoNotChangeTheBits) {
  const Cloud cloud = random_cloud(3000, 5);
  const Channels values = random_channels(cloud.size(), 6);
  const Channels expected = BallNeighbourhood(cloud, {0.05, 8, 0.1}, 1).sum(values, 1);
  for (int num_threads : {2, 3, 8})
    EXPECT_TRUE((BallNeighbourhood(cloud, {0.05, 8, 0.1}, num_threads).sum(values, num_threads) == expected).all());
}

TEST(BallNeighbourhood, RefusesBadOptions) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const BallOptions& options : {BallOptions{0.0, 0, 0.0}, BallOptions{-1.0, 0, 0.0}, BallOptions{nan, 0, 0.0},
                                     BallOptions{inf, 0, 0.0}, BallOptions{0.1, 0, nan}, BallOptions{0.1, 0, -1.0}})
    EXPECT_THROW(BallNeighbourhood(random_cloud(3, 1), options, 0), std::invalid_argument);
}

// A million points in one place would have 10^12 neighbours. Refused early, by any number of threads.
TEST(BallNeighbourhood, ListsThatWouldFillTheMemoryAreRefused) {
  Cloud equal;
  equal.points.assign(4200, Vec3f(1.0f, 2.0f, 3.0f));  // the square is above 2^24
  for (int num_threads : {1, 2, 3}) EXPECT_THROW(BallNeighbourhood(equal, {0.1}, num_threads), std::invalid_argument);
  equal.points.resize(4000);
  EXPECT_NO_THROW(BallNeighbourhood(equal, {0.1}, 0));
}

}  // namespace
}  // namespace augicp
