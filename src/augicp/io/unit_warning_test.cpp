// SPDX-License-Identifier: MIT
#include "augicp/io/unit_warning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace augicp {
namespace {

Cloud line(float length_m) {
  Cloud cloud;
  for (int i = 0; i < 100; ++i) cloud.points.push_back(Vec3f(length_m * static_cast<float>(i) / 100.0f, 0, 0));
  return cloud;
}

TEST(UnitWarning, NamesTheCloudInMillimetres) {
  EXPECT_THAT(unit_warning(line(2000.0f), line(3.0f)), ::testing::HasSubstr("the source is about 667 times"));
  EXPECT_THAT(unit_warning(line(3.0f), line(2000.0f)), ::testing::HasSubstr("the target is about 667 times"));
}

TEST(UnitWarning, NamesTheCloudInCentimetres) {
  EXPECT_THAT(unit_warning(line(300.0f), line(3.5f)),
              ::testing::HasSubstr("the source is about 86 times as large as the target: centimetres"));
}

TEST(UnitWarning, IsSilentOfOtherSizes) {
  for (const float length_m : {1.0f, 10.0f, 40.0f, 1e5f}) EXPECT_EQ(unit_warning(line(length_m), line(1.0f)), "");
  EXPECT_EQ(unit_warning(Cloud{}, line(1.0f)), "");
}

}  // namespace
}  // namespace augicp
