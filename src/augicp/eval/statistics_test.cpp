// SPDX-License-Identifier: MIT
#include "augicp/eval/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace augicp {
namespace {

TEST(Statistics, OfAnOddCount) {
  const Statistics s = statistics_of(std::vector{3.0, -1.0, 10.0, 2.0, 1.0});
  EXPECT_EQ(s.count, 5u);
  EXPECT_DOUBLE_EQ(s.sse, 115.0);
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(23.0));
  EXPECT_DOUBLE_EQ(s.mean, 3.0);
  EXPECT_DOUBLE_EQ(s.median, 2.0);
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(14.0));  // (0 + 16 + 49 + 1 + 4) / 5
  EXPECT_DOUBLE_EQ(s.min, -1.0);
  EXPECT_DOUBLE_EQ(s.max, 10.0);
}

TEST(Statistics, MedianOfAnEvenCountIsTheMeanOfTheMiddleTwo) {
  EXPECT_DOUBLE_EQ(statistics_of(std::vector{4.0, 100.0, 1.0, 3.0}).median, 3.5);
  EXPECT_DOUBLE_EQ(statistics_of(std::vector{2.0, 1.0}).median, 1.5);
}

TEST(Statistics, OfOneValue) {
  const Statistics s = statistics_of(std::vector{2.5});
  EXPECT_EQ(s.count, 1u);
  for (const double value : {s.rmse, s.mean, s.median, s.min, s.max}) EXPECT_EQ(value, 2.5);
  EXPECT_EQ(s.std, 0.0);
}

TEST(Statistics, RmseIsMeanAndSpreadTogether) {
  const Statistics s = statistics_of(std::vector{0.1, 0.4, 0.9, 1.7, 0.3, 0.2});
  EXPECT_NEAR(s.rmse * s.rmse, s.mean * s.mean + s.std * s.std, 1e-15);
}

TEST(Statistics, OfNothingOrWithoutNumbersIsRefused) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(statistics_of({}), std::invalid_argument);
  for (const double value : {inf, std::numeric_limits<double>::quiet_NaN(), 1e200})
    EXPECT_THROW(statistics_of(std::vector{1.0, value}), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
