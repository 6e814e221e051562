// SPDX-License-Identifier: MIT
// Which correspondences support a pose. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/correspondence.h"
#include "augicp/global/descriptors.h"

namespace augicp {

// The points and normals of correspondences, a column for each coordinate: a pose is asked about all of them at once.
class PairColumns {
 public:
  PairColumns(const KeyPoints& source, const KeyPoints& target, std::span<const Correspondence> pairs);

  // The correspondences, in ascending order, whose points are within a distance (metres) under a pose and whose normals
  // have at least this cosine.
  std::vector<std::uint32_t> supporting(const Rigid3& target_from_source, double distance, double cosine) const;

 private:
  std::size_t size_;
  std::array<std::vector<float>, 6> source_, target_;  // x y z nx ny nz, padded
};

}  // namespace augicp
