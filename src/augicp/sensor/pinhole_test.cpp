// SPDX-License-Identifier: MIT
#include "augicp/sensor/pinhole.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace augicp {
namespace {

TEST(Pinhole, EveryNamedCameraIsUsable) {
  EXPECT_GE(camera_names().size(), 4u);
  for (const std::string& name : camera_names()) {
    const auto camera = camera_by_name(name);
    ASSERT_TRUE(camera) << name;
    EXPECT_NO_THROW(camera->check()) << name;
  }
}

TEST(Pinhole, UnknownNameGivesNothing) { EXPECT_FALSE(camera_by_name("tum-fr9")); }

TEST(Pinhole, FocalLengthMustBePositive) {
  EXPECT_THROW((Pinhole{0.0, 525.0, 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((Pinhole{525.0, -1.0, 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((Pinhole{1e300, 525.0, 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((Pinhole{525.0, 525.0, 1e300, 0.0}.check()), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
