// SPDX-License-Identifier: MIT
#include "augicp/experiment/global.h"

#include <gmock/gmock.h>

#include "augicp/synthetic/objects.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

Cloud bracket(unsigned seed) {
  const auto all = synthetic::objects();
  std::mt19937 generator(seed);
  for (const auto& object : all)
    if (object.name == "bracket") return synthetic::sampled(object, 8000, 0.0005, generator);
  return {};
}

double no_time() { return 0.0; }

TEST(GlobalExperiment, APairThatMeetsIsFoundAndFine) {
  const Cloud source = bracket(1), target = bracket(2);
  GlobalOptions options;
  options.num_rotations = 3;
  options.registration.global = true;
  const std::vector<GlobalPair> pairs{{"brackets", "1", "2", &source, &target, Rigid3{}, 0.1}};
  int num_calls = 0;
  const auto rows = summary(run_global(pairs, options, no_time, [&] { ++num_calls; }), options);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(num_calls, 3);
  EXPECT_EQ(rows[0].num_pairs, 3u);
  EXPECT_EQ(rows[0].num_found, 3u);
  EXPECT_EQ(rows[0].num_fine, 3u);
  EXPECT_EQ(rows[0].wrong_converged, 0u);
  EXPECT_LT(rows[0].median_error.translation, 0.005);
}

// Counted by hand.
TEST(GlobalExperiment, OutcomesAreCountedByFamily) {
  const GlobalOptions options;
  const PoseError fine{0.01, 0.01}, found{0.2, 0.1}, wrong{1.0, 0.01};
  using enum AlignStatus;
  const std::vector<GlobalOutcome> outcomes{{"a", "", "", fine, Converged, 1.0},
                                            {"a", "", "", found, Ambiguous, 2.0},
                                            {"a", "", "", wrong, Converged, 9.0},
                                            {"b", "", "", {}, Converged, 4.0},
                                            {"b", "", "", {}, Doubtful, 4.0}};
  const auto rows = summary(outcomes, options);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].num_pairs, 3u);
  EXPECT_EQ(rows[0].num_found, 2u);
  EXPECT_EQ(rows[0].num_fine, 1u);
  EXPECT_EQ(rows[0].right_converged, 1u);
  EXPECT_EQ(rows[0].wrong_converged, 1u);
  EXPECT_EQ(rows[0].ambiguous, 1u);
  EXPECT_EQ(rows[0].median_ms, 2.0);
  EXPECT_EQ(rows[1].wrong_converged, 1u);
  EXPECT_EQ(rows[1].others, 1u);
}

TEST(GlobalExperiment, LengthsOfFoundAndFineAreScaled) {
  const PoseError error{0.04, 0.01};
  const auto row_of = [&](double length_scale) {
    const std::vector<GlobalOutcome> outcomes{{"a", "", "", error, AlignStatus::Converged, 1.0, length_scale}};
    return summary(outcomes, {}).front();
  };
  EXPECT_EQ(row_of(1.0).num_fine, 1u);
  EXPECT_EQ(row_of(0.5).num_fine, 0u);
  EXPECT_EQ(row_of(0.5).num_found, 1u);
  EXPECT_EQ(row_of(0.1).num_found, 0u);
  EXPECT_EQ(row_of(0.1).wrong_converged, 1u);
}

TEST(GlobalExperiment, OverlapIsOfTheCloudThatSharesLess) {
  Cloud line, half;
  for (int k = 0; k < 100; ++k) line.points.emplace_back(0.1f * static_cast<float>(k), 0.0f, 0.0f);
  half.points.assign(line.points.begin(), line.points.begin() + 50);
  EXPECT_NEAR(overlap_of(line, half, {}, 0.05), 0.5, 0.01);
  EXPECT_NEAR(overlap_of(half, line, {}, 0.05), 0.5, 0.01);
  const Rigid3 away{Eigen::Quaterniond::Identity(), {0.0, 1.0, 0.0}};
  EXPECT_EQ(overlap_of(line, half, away, 0.05), 0.0);
  EXPECT_EQ(overlap_of({}, line, {}, 0.05), 0.0);
}

TEST(GlobalExperiment, FragmentsWithoutTruthAreRefused) {
  EXPECT_THROW(fragments_of({}, {}, {}), std::invalid_argument);
  FragmentOptions options;
  options.every = 0;
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
