// SPDX-License-Identifier: MIT
#include "augicp/core/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace augicp {
namespace {

const std::size_t kSizes[] = {0, 1, kBlockSize - 1, kBlockSize, kBlockSize + 1, 7 * kBlockSize + 3};

TEST(Parallel, EveryItemIsVisitedOnce) {
  for (std::size_t count : kSizes) {
    for (int num_threads : {0, 1, 2, 3, 8}) {
      std::vector<int> visits(count, 0);
      for_each_block(count, num_threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " items, " << num_threads << " threads";
    }
  }
}

// Terms of very different size: another order of additions would give other bits.
TEST(Parallel, SumHasTheSameBitsForAnyNumberOfThreads) {
  const auto term = [](std::size_t i) {
    return std::sin(static_cast<double>(i)) * std::pow(10.0, double(i % 17) - 8.0);
  };
  const auto block = [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    return sum;
  };
  for (std::size_t count : kSizes) {
    const double expected = blocked_sum<double>(count, 1, block);
    for (int num_threads = 2; num_threads <= 8; ++num_threads)
      EXPECT_EQ(blocked_sum<double>(count, num_threads, block), expected);
  }
}

TEST(Parallel, ExceptionReachesTheCaller) {
  const auto fail = [](std::size_t begin, std::size_t) {
    if (begin > 0) throw std::runtime_error("block");
  };
  EXPECT_THROW(for_each_block(10 * kBlockSize, 2, fail), std::runtime_error);
}

TEST(Parallel, BothReturnsTwoResults) {
  for (const int num_threads : {0, 1, 2, 8}) {
    const auto [number, word] = both(
        num_threads, [] { return 7; }, [] { return std::string("seven"); });
    EXPECT_EQ(number, 7);
    EXPECT_EQ(word, "seven");
  }
}

TEST(Parallel, AnExceptionOfEitherOfBothReachesTheCaller) {
  const auto fail = []() -> int { throw std::runtime_error("task"); };
  for (const int num_threads : {1, 2}) {
    EXPECT_THROW(both(num_threads, fail, [] { return 0; }), std::runtime_error);
    EXPECT_THROW(both(
                     num_threads, [] { return 0; }, fail),
                 std::runtime_error);
  }
}

TEST(Parallel, TwoTasksShareTheThreads) {
  EXPECT_EQ(half_of_threads(0), 0);  // all
  EXPECT_EQ(half_of_threads(1), 1);
  EXPECT_EQ(half_of_threads(2), 1);
  EXPECT_EQ(half_of_threads(5), 2);
}

TEST(Parallel, MoreThreadsThanThereAreIsSilent) {
  ::testing::internal::CaptureStderr();
  for_each_block(4 * kBlockSize, 1000, [](std::size_t, std::size_t) {});
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Parallel, NegativeThreadCountIsRefused) {
  EXPECT_THROW(for_each_block(1, -1, [](std::size_t, std::size_t) {}), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
