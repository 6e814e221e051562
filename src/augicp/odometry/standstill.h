// SPDX-License-Identifier: MIT
// A sensor that stands still measures one pose again and again: the mean of its poses is more certain than each.
#pragma once

#include <cstddef>
#include <deque>

#include "augicp/core/types.h"
#include "augicp/geometry/rigid3.h"

namespace augicp {

// The last poses of a sensor while nothing shows that it moves. Not for concurrent use.
class Standstill {
 public:
  // Enough for a fifth of the noise. The more there are, the slower is a creeping that they do not show.
  static constexpr std::size_t kMaxPoses = 30;

  // The next pose, with the covariance of its increment about the sensor's place. Returns the mean of the last poses if
  // the sensor stands still: all of them may be of one place. The last one is within its certainty of the mean of those
  // before, and so are the means of the later and the earlier half of each other, which creeping shows sooner.
  // Otherwise the sensor moves, until several poses in a row may be of one place again, and the pose itself is
  // returned. A sensor stands still at first.
  Rigid3 add(const Rigid3& world_from_sensor, const Mat6d& covariance);

  // The sensor moves.
  void forget() { poses_.clear(), stands_ = false; }

 private:
  struct Measured {
    Rigid3 world_from_sensor;
    Mat6d covariance;
  };

  std::deque<Measured> poses_;  // that may be of one place
  bool stands_ = true;
};

}  // namespace augicp
