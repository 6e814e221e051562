// SPDX-License-Identifier: MIT
// From pairs of indices to batches of numbers.
#pragma once

#include <cstdint>
#include <span>

#include "augicp/cloud/posed_pairs.h"
#include "augicp/objective/information.h"
#include "augicp/objective/pair_batch.h"

namespace augicp {

// A number for each Structure.
struct ByStructure {
  float none, planar, edge;
  float of(std::int32_t structure) const {
    return structure == static_cast<std::int32_t>(Structure::Planar) ? planar
           : structure == static_cast<std::int32_t>(Structure::Edge) ? edge
                                                                     : none;
  }
};

// What all pairs share. Information is in a unit of its own, so that float holds it.
struct PairModel {
  double rotation[9];  // row by row
  double translation[3];
  ByStructure along, across, direction_along, direction_across;
  float one_sided;  // 1 where a normal and its opposite differ, else 0
};

class PairReader {
 public:
  // The clouds must outlive it. Of `posed` only the clouds and the pose are kept.
  PairReader(const PosedPairs& posed, const InformationModel& information);

  // At most kPairsPerBatch pairs of these clouds, under the pose.
  void read(std::span<const Correspondence> pairs, PairBatch& batch) const;

  double information_unit() const { return information_unit_; }

 private:
  const Cloud& source_;
  const Cloud& target_;
  double information_unit_;
  PairModel model_;
  bool compares_directions_;
};

}  // namespace augicp
