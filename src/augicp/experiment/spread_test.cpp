// SPDX-License-Identifier: MIT
#include "augicp/experiment/spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "augicp/experiment/random.h"

namespace augicp {
namespace {

TEST(Quantile, LiesStraightBetweenNeighbours) {
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.9), 3.7);
  EXPECT_DOUBLE_EQ(quantile({7.0}, 0.3), 7.0);
  EXPECT_THROW(quantile({}, 0.5), std::invalid_argument);
  EXPECT_THROW(quantile({1.0}, 1.5), std::invalid_argument);
}

// As printed in tables of the distribution.
TEST(StudentQuantile, AgreesWithTables) {
  EXPECT_NEAR(student_quantile(0.975, 1), 12.7062, 1e-4);
  EXPECT_NEAR(student_quantile(0.975, 2), 4.3027, 1e-4);
  EXPECT_NEAR(student_quantile(0.975, 4), 2.7764, 1e-4);
  EXPECT_NEAR(student_quantile(0.975, 9), 2.2622, 1e-4);
  EXPECT_NEAR(student_quantile(0.95, 30), 1.6973, 1e-4);
}

TEST(MeanInterval, HoldsTheMeanInNineteenOfTwenty) {
  std::mt19937 generator(11);
  int num_held = 0;
  constexpr int kTrials = 4000;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::vector<double> values{3.0 + gaussian(generator), 3.0 + gaussian(generator), 3.0 + gaussian(generator)};
    const MeanInterval interval = mean_interval(values);
    num_held += std::abs(interval.mean - 3.0) < interval.half_width;
  }
  EXPECT_NEAR(num_held / static_cast<double>(kTrials), 0.95, 0.012);
}

TEST(MeanInterval, OfOneValueIsUnknown) { EXPECT_TRUE(std::isinf(mean_interval(std::vector<double>{1.0}).half_width)); }

}  // namespace
}  // namespace augicp
