// SPDX-License-Identifier: MIT
#include "augicp/registration/lengths.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

using testing::random_points;

// By sorting all.
float sorted_at(std::vector<float> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::vector<Cloud> clouds() {
  std::vector<Cloud> clouds;
  for (std::size_t count : {1, 2, 3, 10, 1001, 20000}) clouds.push_back(random_points(count, 2.0, 1));
  Cloud shifted = random_points(500, 1.0, 2), equal, wide = random_points(500, 1.0, 3);
  for (Vec3f& point : shifted.points) point -= Vec3f(1e6f, -30.0f, 0.0f);
  equal.points.assign(100, Vec3f(0.0f, -1.0f, 1e18f));
  for (std::size_t i = 0; i < wide.size(); ++i) wide.points[i] *= i % 3 == 0 ? 1e18f : i % 3 == 1 ? 1e-30f : 0.0f;
  Cloud uneven = random_points(16384, 1.0, 4);  // every 32nd point, of which a sample may consist, is far off
  for (std::size_t i = 0; i < uneven.size(); i += 32) uneven.points[i] *= 100.0f;
  clouds.insert(clouds.end(), {shifted, equal, wide, uneven});
  return clouds;
}

TEST(Lengths, MedianAndExtentAreThoseOfTheSortedNumbers) {
  for (const Cloud& cloud : clouds()) {
    const Vec3f median = median_point(cloud);
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<float> coordinates;
      for (const Vec3f& point : cloud.points) coordinates.push_back(point[axis]);
      EXPECT_EQ(median[axis], sorted_at(coordinates, 0.5));
    }
    std::vector<float> distances;
    for (const Vec3f& point : cloud.points) distances.push_back((point - median).norm());
    EXPECT_EQ(robust_extent({cloud, {}}), 2.0 * static_cast<double>(sorted_at(distances, 0.8)));
  }
}

}  // namespace
}  // namespace augicp
