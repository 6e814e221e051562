// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "augicp/cloud/cloud.h"

namespace augicp {

// Per-point quantities, one column a point.
using Channels = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic>;

// Which points count as near each point of a cloud: the one thing in which depth images and other clouds differ when
// surfaces are estimated. Const calls may run concurrently.
class Neighbourhood {
 public:
  virtual ~Neighbourhood() = default;

  // Column i of the result is the sum of the columns of `values` over the neighbours of point i, itself among them.
  virtual Channels sum(const Channels& values, int num_threads) const = 0;
};

}  // namespace augicp
