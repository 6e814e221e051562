// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "augicp/align/align.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"
#include "augicp/trust/covariance.h"

namespace augicp {
namespace {

constexpr double kCorrelation = 0.2;

AlignOptions gated_by(double gate) {
  AlignOptions options;
  options.information = point_information();
  options.gates.max_distance = gate;
  options.num_threads = 1;
  return options;
}

// A gate that closes and opens again, from one guess after another: what the session remembers changes no bit.
TEST(KnownClouds, AreAlignedAsIfNothingWereKnown) {
  const Cloud target = testing::random_points(3000, 1.0, 1);
  const NearestMatcher matcher(target);
  std::mt19937 generator(2);
  const Cloud source = transform(testing::random_points(1500, 1.0, 3), testing::random_motion(generator, 0.1, 0.05));
  const std::unique_ptr<MatchSession> session = matcher.session(source);
  for (const double gate : {0.5, 0.05, 0.3, 0.1}) {
    const Rigid3 guess = testing::random_motion(generator, 0.1, 0.05);
    const AlignResult known = align({source, matcher, *session}, guess, gated_by(gate));
    const AlignResult fresh = align(source, matcher, guess, gated_by(gate));
    EXPECT_EQ(known.target_from_source.matrix(), fresh.target_from_source.matrix()) << gate;
    EXPECT_EQ(known.iterations, fresh.iterations) << gate;
    EXPECT_EQ(known.pairs, fresh.pairs) << gate;
  }
}

// The covariance may be had afterwards, for the one result of several that counts.
TEST(KnownClouds, AResultHasWhatItsCovarianceNeeds) {
  const Cloud target = testing::random_points(3000, 1.0, 4);
  const NearestMatcher matcher(target);
  std::mt19937 generator(5);
  const Cloud source = transform(target, testing::random_motion(generator, 0.01, 0.005));
  AlignOptions options = gated_by(0.3);
  const AlignResult without = align(source, matcher, Rigid3{}, options);
  options.correlation_length = kCorrelation;
  const AlignResult with = align(source, matcher, Rigid3{}, options);
  ASSERT_TRUE(with.covariance.has_value());
  EXPECT_FALSE(without.covariance.has_value());
  const PosedPairs posed{source, target, without.pairs, without.target_from_source};
  EXPECT_EQ(
      covariance(matcher, {posed, options.gates, without.objective}, kCorrelation, without.observability.directions, 1),
      with.covariance);
}

}  // namespace
}  // namespace augicp
