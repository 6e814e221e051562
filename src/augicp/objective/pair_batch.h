// SPDX-License-Identifier: MIT
// The errors of Eq. (8) and their parts of Eq. (14) for a batch of pairs at once. Every quantity is an array with one
// entry a pair, so that compilers make vectors of them; arithmetic is double, each pair's as if it were alone.
#pragma once

#include <cstdint>
#include <span>

#include "augicp/cloud/correspondence.h"
#include "augicp/objective/information.h"

namespace augicp {

inline constexpr int kPairsPerBatch = 64;
inline constexpr int kLanes = 4;

// Pairs under a pose. Entries beyond the last pair are zero, and so are all their terms.
struct PairBatch {
  template <typename Number>
  using Array = Number[kPairsPerBatch];

  // As read: T has yet to be applied. Directions are zero where they are not compared, target_direction where the
  // target point has none.
  alignas(64) Array<float> source_point[3], source_direction[3], target_point[3], target_direction[3];
  alignas(64) Array<double> along, across;                      // of the positions' information
  alignas(64) Array<double> direction_along, direction_across;  // of the directions'
  alignas(64) Array<double> one_sided;                          // 1 where a direction and its opposite differ, else 0
  Array<bool> compares;                                         // whether directions are compared

  // Computed from these.
  alignas(64) Array<double> moved_point[3];      // q = T (+) p_j
  alignas(64) Array<double> moved_direction[3];  // m = R l_j, its sign chosen
  alignas(64) Array<double> position_error[3];   // p_i - q
  alignas(64) Array<double> direction_error[3];  // l_i - m
};

class PairReader {
 public:
  // All of them must outlive it. target_from_source maps between the clouds' points, without their origins.
  PairReader(const Cloud& source, const Cloud& target, const Rigid3& target_from_source,
             const InformationModel& information);

  // At most kPairsPerBatch pairs.
  void read(std::span<const Correspondence> pairs, PairBatch& batch) const;
  void move(PairBatch& batch) const;

 private:
  const Cloud& source_;
  const Cloud& target_;
  const InformationModel& information_;
  double rotation_[9];  // row by row
  double translation_[3];
  bool target_has_directions_;
  bool compares_directions_;
  bool signed_normals_;
};

// chi2 = e^T Omega e in its two parts.
struct BatchChi2 {
  alignas(64) PairBatch::Array<double> position, direction;
};
void chi2_of(const PairBatch& batch, BatchChi2& chi2);

// What each pair adds to H, b and the cost, by blocks: tt and rr are upper triangles row by row, tr is whole but for
// the cross matrix of the sum of across * q.
struct PairTerms {
  static constexpr int kTt = 0, kTr = 6, kRr = 15, kAcrossPoint = 21, kBt = 24, kBr = 27, kCost = 30, kCount = 31;
  alignas(64) PairBatch::Array<double> term[kCount];
};
void terms_of(const PairBatch& batch, double kernel_chi2, double kernel_direction_chi2, PairTerms& terms);

// lanes[t][k % kLanes] += terms.term[t][k].
using TermLanes = double[PairTerms::kCount][kLanes];
void add_terms(const PairTerms& terms, TermLanes& lanes);

}  // namespace augicp
