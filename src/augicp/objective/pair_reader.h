// SPDX-License-Identifier: MIT
// From pairs of indices to batches of numbers.
#pragma once

#include <span>

#include "augicp/cloud/posed_pairs.h"
#include "augicp/objective/information.h"
#include "augicp/objective/pair_batch.h"
#include "augicp/objective/pair_information.h"

namespace augicp {

// What all pairs share.
struct PairModel {
  double rotation[9];  // row by row
  double translation[3];
  InformationTable positions, directions;  // in a unit of their own, so that float holds them
  bool signed_normals;                     // a normal and its opposite differ
};

class PairReader {
 public:
  // The clouds must outlive it. Of `posed` only the clouds and the pose are kept.
  PairReader(const PosedPairs& posed, const InformationModel& information);

  // At most kPairsPerBatch pairs of these clouds, under the pose.
  void read(std::span<const Correspondence> pairs, PairBatch& batch) const;

  double information_unit() const { return information_unit_; }

 private:
  bool weighs_by_gaussians() const { return model_.positions.sides == Sides::TargetGaussian; }

  const Cloud& source_;
  const Cloud& target_;
  double information_unit_;
  bool compares_directions_;
  PairModel model_;
};

}  // namespace augicp
