// SPDX-License-Identifier: MIT
#include "augicp/synthetic/trust_benchmark.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "augicp/search/kd_tree.h"
#include "augicp/synthetic/objects.h"

namespace augicp::synthetic {
namespace {

// The median distance of the moved source's points to the nearest target point, metres.
double median_distance(const TrustPair& pair, const Rigid3& target_from_source) {
  const KdTree tree(pair.target.cloud);
  std::vector<float> distances;
  for (std::size_t i = 0; i < pair.source.cloud.size(); i += 17) {
    const Vec3d moved = target_from_source * pair.source.cloud.points[i].cast<double>();
    distances.push_back(tree.nearest(moved.cast<float>(), 1e6f)->distance_sq);
  }
  std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2),
                   distances.end());
  return std::sqrt(static_cast<double>(distances[distances.size() / 2]));
}

TEST(TrustFamilies, AreDrawnFromTheirSeedAlone) {
  std::set<std::string> names;
  for (const TrustFamily& family : trust_families()) {
    const TrustPair first = family.draw(5), again = family.draw(5), other = family.draw(6);
    EXPECT_EQ(first.source.cloud.points, again.source.cloud.points) << family.name;
    EXPECT_NE(first.source.cloud.points, other.source.cloud.points) << family.name;
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
  }
}

// Under the pose that is called true the clouds meet, closer than under one that is not.
TEST(TrustFamilies, TheTruthIsTrue) {
  const Rigid3 off{Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vec3d(0.6, 0.0, 0.8))), {0.2, 0.3, -0.2}};
  for (const TrustFamily& family : trust_families()) {
    const TrustPair pair = family.draw(3);
    if (!pair.target_from_source) continue;
    const double at_truth = median_distance(pair, *pair.target_from_source);
    EXPECT_LT(at_truth, 0.5 * median_distance(pair, off * *pair.target_from_source)) << family.name;
  }
}

TEST(TrustRow, CountsEachOutcomeOnce) {
  TrustPair pair;
  pair.target_from_source = Rigid3{};
  const PoseError right{0.01, 0.01};
  const auto with = [](AlignStatus status, double error) {
    AlignResult result;
    result.status = status;
    result.target_from_source.translation.x() = error;
    return result;
  };
  TrustRow row;
  count_pair(pair, right, with(AlignStatus::Converged, 0.0), row);
  count_pair(pair, right, with(AlignStatus::Converged, 0.1), row);
  count_pair(pair, right, with(AlignStatus::Doubtful, 0.0), row);
  count_pair(pair, right, with(AlignStatus::NoOverlap, 0.1), row);
  count_pair(pair, right, with(AlignStatus::Degenerate, 0.1), row);
  EXPECT_EQ(row.num_pairs, 5);
  EXPECT_EQ(row.right_converged, 1);
  EXPECT_EQ(row.wrong_converged, 1);
  EXPECT_EQ(row.right_refused, 1);
  EXPECT_EQ(row.wrong_refused, 1);
  EXPECT_EQ(row.degenerate, 1);
}

// Without a common surface no pose is right.
TEST(TrustRow, NothingIsRightWithoutATruth) {
  AlignResult result;
  result.status = AlignStatus::Converged;
  TrustRow row;
  count_pair({}, {1e9, 1e9}, result, row);
  EXPECT_EQ(row.wrong_converged, 1);
  EXPECT_EQ(row.right_converged, 0);
}

TEST(Objects, HavePointsOnAllSidesAndOnlyTheSeenOnesOnOne) {
  std::mt19937 generator(1);
  const auto all = objects();
  EXPECT_GE(all.size(), 10u);
  for (const Object& object : all) {
    const Cloud whole = sampled(object, 2000, 0.0, generator);
    EXPECT_EQ(whole.size(), 2000u);
    EXPECT_GT(bounds(whole).diagonal(), 0.2) << object.name;
    EXPECT_LT(bounds(whole).diagonal(), 2.0) << object.name;
  }
  // Of a box seen from above, the bottom is missing.
  const Cloud top = sampled_side(all[5], 500, 0.0, Vec3d::UnitZ(), 5.0, generator);
  EXPECT_EQ(all[5].name, "box");
  for (const Vec3f& point : top.points) EXPECT_GT(point.z(), -0.04f + 1e-4f);
}

}  // namespace
}  // namespace augicp::synthetic
