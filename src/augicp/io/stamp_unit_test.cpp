// SPDX-License-Identifier: MIT
#include "augicp/io/stamp_unit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace augicp {
namespace {

using ::testing::HasSubstr;

std::vector<double> every(double gap, double first, int count) {
  std::vector<double> stamps;
  for (int i = 0; i < count; ++i) stamps.push_back(first + gap * i);
  return stamps;
}

constexpr double kDate_s = 1.7e9;

TEST(StampUnit, SecondsStayAsTheyAre) {
  for (const double gap_s : {1e-3, 1.0 / 30.0, 0.1, 1.0, 5.0})
    for (const double first_s : {0.0, -3.0, kDate_s}) {
      std::vector<double> stamps = every(gap_s, first_s, 5);
      const std::vector<double> before = stamps;
      EXPECT_EQ(bring_into_seconds(stamps), "");
      EXPECT_EQ(stamps, before);
    }
  std::vector<double> none;
  EXPECT_EQ(bring_into_seconds(none), "");
}

// From zero, as dates, and as the time since a machine was started, six minutes and an hour ago.
TEST(StampUnit, TheUnitThatSuitsIsTakenAndSaid) {
  for (const double gap_s : {1.0 / 90.0, 1.0 / 30.0, 0.1, 1.0})
    for (const double first_s : {0.0, 400.0, 3600.0, kDate_s})
      for (const auto& [per_s, name] : {std::pair{1e6, "microseconds"}, std::pair{1e9, "nanoseconds"}}) {
        std::vector<double> stamps = every(gap_s * per_s, first_s * per_s, 9);
        EXPECT_THAT(bring_into_seconds(stamps), HasSubstr(std::string("are read as ") + name));
        EXPECT_NEAR(stamps[8], first_s + 8 * gap_s, 1e-6);
      }
  std::vector<double> milliseconds = every(100.0, kDate_s * 1e3, 9), one{kDate_s * 1e9};
  EXPECT_THAT(bring_into_seconds(milliseconds), HasSubstr("are read as milliseconds"));
  EXPECT_NEAR(milliseconds[8], kDate_s + 0.8, 1e-6);
  EXPECT_THAT(bring_into_seconds(one), HasSubstr("are read as nanoseconds"));
  EXPECT_NEAR(one[0], kDate_s, 1e-6);
}

TEST(StampUnit, FramesOutOfOrderTellTheUnitToo) {
  std::vector<double> stamps = every(1e8, 0.0, 9);
  std::swap(stamps[3], stamps[4]);
  EXPECT_THAT(bring_into_seconds(stamps), HasSubstr("nanoseconds: as seconds they would be 1e+08 s apart"));
  EXPECT_EQ(stamps[3], 0.4);
  EXPECT_EQ(stamps[4], 0.3);
}

// A time lapse has a frame each minute: that cannot be told from milliseconds.
TEST(StampUnit, WhatMayBeSecondsIsSuspectedAtMost) {
  std::vector<double> stamps = every(100.0, 0.0, 5);
  EXPECT_THAT(bring_into_seconds(stamps), HasSubstr("100 s apart by their stamps, which are read as seconds"));
  EXPECT_EQ(stamps[4], 400.0);
  std::vector<double> dates = every(100.0, kDate_s, 5);
  EXPECT_EQ(bring_into_seconds(dates), "");
}

TEST(StampUnit, WhatSuitsSeveralUnitsOrNoneIsRefused) {
  for (const auto& [gap, first, words] :
       {std::tuple{3e6, kDate_s * 1e6, "microseconds or nanoseconds?"}, std::tuple{1e15, 0.0, "which suit no unit"}}) {
    std::vector<double> stamps = every(gap, first, 5);
    const std::vector<double> before = stamps;
    try {
      bring_into_seconds(stamps);
      ADD_FAILURE() << gap;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr(words));
    }
    EXPECT_EQ(stamps, before);
  }
}

}  // namespace
}  // namespace augicp
