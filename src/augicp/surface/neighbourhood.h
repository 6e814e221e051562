// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "augicp/cloud/cloud.h"

namespace augicp {

// Per-point quantities, one column per point.
using Channels = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic>;

// Which points are near each point of a cloud. This is the only difference between depth images and other clouds in
// surface estimation. Thread safety: const calls may run concurrently.
class Neighbourhood {
 public:
  virtual ~Neighbourhood() = default;

  // Column i of the result is the sum of the columns of `values` over the neighbours of point i, including point i.
  virtual Channels sum(const Channels& values, int num_threads) const = 0;
};

}  // namespace augicp
