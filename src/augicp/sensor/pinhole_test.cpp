// SPDX-License-Identifier: MIT
#include "augicp/sensor/pinhole.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace augicp {
namespace {

TEST(Pinhole, FocalLengthMustBePositive) {
  EXPECT_THROW((Pinhole{0.0, 525.0, 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((Pinhole{525.0, -1.0, 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((Pinhole{1e300, 525.0, 0.0, 0.0}.check()), std::invalid_argument);
  EXPECT_THROW((Pinhole{525.0, 525.0, 1e300, 0.0}.check()), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
