// SPDX-License-Identifier: MIT
#include "augicp/core/median.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace augicp {
namespace {

double by_sorting(std::vector<float> values) {
  std::erase_if(values, [](float value) { return std::signbit(value); });
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : static_cast<double>(values[values.size() / 2]);
}

// Errors of all sizes, a quarter of them marked as none.
std::vector<float> errors(std::size_t count, double spread) {
  std::mt19937 generator(5);
  std::vector<float> values(count);
  for (float& value : values) {
    const double u = static_cast<double>(generator()) / 4294967296.0;
    value = generator() % 4 == 0 ? -1.0f : static_cast<float>(std::exp(spread * (u - 0.5)));
  }
  return values;
}

TEST(Median, IsThatOfSorting) {
  for (std::size_t count : {0u, 1u, 2u, 5u, 100u, 4096u, 4097u, 100000u, 100001u})
    for (double spread : {0.0, 1e-3, 1.0, 80.0}) {
      const std::vector<float> values = errors(count, spread);
      EXPECT_EQ(median(values), by_sorting(values)) << count << " values over exp " << spread;
    }
}

TEST(Median, OfNoErrorsIsZero) {
  EXPECT_EQ(median({}), 0.0);
  EXPECT_EQ(median(std::vector<float>(3, -1.0f)), 0.0);
  EXPECT_EQ(median(std::vector<float>(9000, -1.0f)), 0.0);
}

TEST(Median, OfZerosAndInfinities) {
  EXPECT_EQ(median(std::vector<float>(9000, 0.0f)), 0.0);
  EXPECT_EQ(median(std::vector<float>(9000, std::numeric_limits<float>::infinity())),
            std::numeric_limits<double>::infinity());
}

TEST(Median, RanksAreThoseOfTheSortedValues) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (const std::size_t count : {1u, 2u, 7u, 100u}) {
    std::vector<double> values(count);
    for (double& value : values) value = any(generator);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t rank = 0; rank < count; ++rank) EXPECT_EQ(value_at_rank(values, rank), sorted[rank]);
    EXPECT_EQ(upper_median(values), sorted[count / 2]);
  }
}

}  // namespace
}  // namespace augicp
