// SPDX-License-Identifier: MIT
#include "augicp/align/stretch.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/angles.h"

namespace augicp {
namespace {

// Besl and McKay take 10 degrees. A long step upsets the pairs, and the next one turns by more for that alone.
const double kAligned = std::cos(30.0 * kRadPerDeg);

// Of an error that falls by a constant factor, a step that leaves this share is less than 0.3 of the way: twice as long
// it is less than 0.6.
constexpr double kMinShareLeft = 0.7;

}  // namespace

Vec6d Stretch::of(const Vec6d& increment) {
  Vec6d now = increment;
  now.head<3>() /= options_.min_translation_step;
  now.tail<3>() /= options_.min_rotation_step;
  const double length = now.norm(), last_length = last_.norm();
  if (!(now.dot(last_) > kAligned * length * last_length))
    factor_ = 1.0;
  else
    factor_ = length >= kMinShareLeft * last_length ? std::min(2.0 * factor_, options_.max_stretch)
                                                    : std::max(0.5 * factor_, 1.0);
  last_ = now;
  return factor_ * increment;
}

}  // namespace augicp
