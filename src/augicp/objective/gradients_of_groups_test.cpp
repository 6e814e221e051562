// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "augicp/objective/linearize.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

constexpr std::size_t kNumPairs = 3000, kNumGroups = 600;
const Objective kObjective{with_lever(augmented_information(), 0.3), 2.0, 1.0};

Cloud random_bright_points(unsigned seed) {
  Cloud cloud = testing::random_extended_points(50, 1.0, seed);
  std::mt19937 generator(seed);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.intensities.push_back(static_cast<float>(testing::uniform(generator, 0.0, 1.0)));
    cloud.intensity_gradients.push_back(testing::random_direction(generator).cast<float>());
  }
  return cloud;
}

struct Groups {
  Cloud source = random_bright_points(1), target = random_bright_points(2);
  std::vector<Correspondence> pairs = testing::random_pairs(kNumPairs, 50, 3);
  std::vector<std::size_t> begin;
  Rigid3 pose;

  // Groups of no pair to some dozens.
  Groups() {
    std::mt19937 generator(4);
    pose = testing::random_motion(generator, 0.5, 0.7);
    begin = {0, kNumPairs};
    while (begin.size() <= kNumGroups) begin.push_back(generator() % kNumPairs);
    std::sort(begin.begin(), begin.end());
  }

  std::vector<Vec6d> gradients(const Objective& objective, int num_threads = 1) const {
    return gradients_of_groups({source, target, pairs, pose}, begin, objective, num_threads);
  }

  Vec6d one_by_one(std::size_t group, const Objective& objective) const {
    const auto of_group = std::span(pairs).subspan(begin[group], begin[group + 1] - begin[group]);
    return linearize({source, target, of_group, pose}, objective, 1).b;
  }
};

TEST(GradientsOfGroups, AreThoseOfEachGroupAlone) {
  const Groups groups;
  Objective with_intensity = kObjective;
  with_intensity.intensity = {.information = 50.0, .kernel_chi2 = 1.0};
  for (const Objective& objective : {kObjective, with_intensity}) {
    const std::vector<Vec6d> gradients = groups.gradients(objective);
    ASSERT_EQ(gradients.size(), kNumGroups);
    for (std::size_t group = 0; group < kNumGroups; ++group) {
      const Vec6d expected = groups.one_by_one(group, objective);
      EXPECT_LT((gradients[group] - expected).norm(), 1e-5 * (1.0 + expected.norm())) << group;
    }
  }
}

TEST(GradientsOfGroups, SameBitsForAnyNumberOfThreads) {
  const Groups groups;
  const std::vector<Vec6d> alone = groups.gradients(kObjective);
  for (int num_threads : {2, 3, 8}) EXPECT_EQ(groups.gradients(kObjective, num_threads), alone);
}

TEST(GradientsOfGroups, OfNoPairsAreZero) {
  const Groups groups;
  const std::array<std::size_t, 3> begin{0, 0, 0};
  const auto gradients = gradients_of_groups({groups.source, groups.target, {}, groups.pose}, begin, kObjective, 1);
  EXPECT_EQ(gradients, std::vector<Vec6d>(2, Vec6d::Zero()));
}

}  // namespace
}  // namespace augicp
