// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include "augicp/geometry/rigid3.h"

namespace augicp::testing {

// Fails on NaN: every comparison is written so that NaN does not satisfy it.
MATCHER_P3(NearPose, expected, angle_rad, distance_m, "") {
  const double angle = angle_between(expected, arg);
  const double distance = (expected.translation - arg.translation).norm();
  *result_listener << "which is " << angle << " rad and " << distance << " m away";
  return angle <= angle_rad && distance <= distance_m;
}

MATCHER_P2(NearVector, expected, tolerance, "") {
  const double distance = (arg - expected).norm();
  *result_listener << "which is [" << arg.transpose() << "], " << distance << " away from [" << expected.transpose()
                   << "]";
  return distance <= tolerance;
}

}  // namespace augicp::testing
