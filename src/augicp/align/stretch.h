// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/align/align.h"

namespace augicp {

// Lengthens the steps of a loop that creeps: where most points slide on their partners' surfaces, such as a mug's body
// while its handle turns, hundreds of equal steps would follow each other. Besl and McKay (1992, section IV.C)
// extrapolate when three steps are aligned. Here a step is doubled, and doubled again up to options.max_stretch, as
// long as the increments neither turn nor shrink: were the error to fall by a constant factor, it would not be
// overshot. An increment that turns or shrinks is taken as it is.
class Stretch {
 public:
  explicit Stretch(const AlignOptions& options) : options_(options) {}

  // What to move by instead of the next increment of the loop; both metres and radians.
  Vec6d of(const Vec6d& increment);

 private:
  const AlignOptions& options_;
  Vec6d last_ = Vec6d::Zero();  // in units of the smallest steps
  double factor_ = 1.0;
};

}  // namespace augicp
