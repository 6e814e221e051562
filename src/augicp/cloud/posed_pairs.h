// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/correspondence.h"

namespace augicp {

// Pairs of points of two clouds under a pose: the input of an objective, its weights and the verdict. A view. REQUIRES:
// the clouds and the pairs outlive it.
struct PosedPairs {
  const Cloud& source;
  const Cloud& target;
  std::span<const Correspondence> pairs;  // every index is below the size of its cloud
  Rigid3 target_from_source;              // between the clouds' points, without their origins; metres

  std::size_t size() const { return pairs.size(); }

  // The same clouds and pose with other pairs.
  PosedPairs with(std::span<const Correspondence> others) const { return {source, target, others, target_from_source}; }
};

}  // namespace augicp
