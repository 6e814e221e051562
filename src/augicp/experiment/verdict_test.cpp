// SPDX-License-Identifier: MIT
#include "augicp/experiment/verdict.h"

#include <gtest/gtest.h>

namespace augicp {
namespace {

VerdictPair pair_with(PairTruth truth, AlignStatus status, double conflicting) {
  VerdictPair pair;
  pair.truth = truth;
  pair.status = status;
  pair.without_verdict = AlignStatus::Converged;
  const auto conflict = static_cast<std::int64_t>(1000.0 * conflicting);
  const Testimony side{{.agree = 1000 - conflict, .conflict = conflict}, true};
  pair.evidence.emplace();
  pair.evidence->source_in_target = pair.evidence->target_in_source = side;
  return pair;
}

const std::vector<VerdictPair> kPairs{
    pair_with(PairTruth::Right, AlignStatus::Converged, 0.01), pair_with(PairTruth::Right, AlignStatus::Doubtful, 0.06),
    pair_with(PairTruth::Wrong, AlignStatus::Doubtful, 0.08), pair_with(PairTruth::Apart, AlignStatus::Doubtful, 0.16)};

TEST(VerdictExperiment, ConfusionCountsEveryPairOnce) {
  const std::vector<ConfusionRow> rows = confusion(kPairs);
  std::size_t total = 0;
  for (const ConfusionRow& row : rows) total += row.num_pairs;
  EXPECT_EQ(total, kPairs.size());
  const ConfusionRow& right = rows[static_cast<std::size_t>(PairTruth::Right)];
  EXPECT_EQ(right.num_converged, 1u);
  EXPECT_EQ(right.num_doubtful, 1u);
  EXPECT_EQ(rows[static_cast<std::size_t>(PairTruth::Apart)].num_converged, 0u);
  EXPECT_EQ(rows[static_cast<std::size_t>(PairTruth::Apart)].num_converged_without_verdict, 1u);
}

TEST(VerdictExperiment, RocRunsFromNothingToEverything) {
  const std::vector<RocPoint> points = roc(kPairs);
  EXPECT_EQ(points.front().right_refused, 1.0);
  EXPECT_EQ(points.front().apart_accepted, 0.0);
  EXPECT_EQ(points.back().right_refused, 0.0);
  EXPECT_EQ(points.back().wrong_accepted, 1.0);
  for (const RocPoint& point : points) {
    const auto share_beyond = [&](std::size_t pair) {
      return strain(*kPairs[pair].evidence) > point.max_strain ? 1.0 : 0.0;
    };
    EXPECT_EQ(point.right_refused, 0.5 * (share_beyond(0) + share_beyond(1))) << point.max_strain;
    EXPECT_EQ(point.apart_accepted, 1.0 - share_beyond(3)) << point.max_strain;
  }
}

TEST(VerdictExperiment, OptionsAreChecked) {
  VerdictOptions options;
  options.gaps = {0};
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
