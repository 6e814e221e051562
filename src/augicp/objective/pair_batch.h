// SPDX-License-Identifier: MIT
// The errors of Eq. (8) and their parts of Eq. (14) for a batch of pairs at once. Every quantity is an array with one
// entry a pair, so that compilers make vectors of them, each pair's as if it were alone. Errors are differences of
// places that lie metres from zero, and are made in double; what is made of errors has the digits of a float, which
// leaves the pose where all of it is zero untouched.
#pragma once

#include <cstdint>

#include "augicp/cloud/gather.h"

namespace augicp {

inline constexpr int kPairsPerBatch = kGatheredAtOnce;
inline constexpr int kLanes = 8;

// Pairs under a pose. Entries beyond the last pair are finite, and all their terms are zero.
struct PairBatch {
  template <typename Number>
  using Array = Column<Number>;

  // A symmetric 3x3 matrix a pair: the upper triangle, row by row.
  using Symmetric = Array<float>[6];

  // As read: T has yet to be applied. target_point is the mean of its Gaussian where that weighs the pair.
  // target_direction is zero where the target point has none.
  alignas(64) Array<float> source_point[3]{}, source_direction[3]{}, target_point[3]{}, target_direction[3]{};
  alignas(64) Array<float> weight{}, source_weight{};               // weight: the target point's
  alignas(64) Array<std::int32_t> source_structure{}, structure{};  // structure: the target point's

  // Computed from these.
  alignas(64) Array<float> compares;            // 1 where directions are compared, else 0
  alignas(64) Array<float> moved_point[3];      // q = T (+) p_j
  alignas(64) Array<float> moved_direction[3];  // m = R l_j, its sign chosen
  alignas(64) Array<float> position_error[3];   // p_i - q
  alignas(64) Array<float> direction_error[3];  // l_i - m
  alignas(64) Symmetric position_information;   // Omega^p
  alignas(64) Symmetric direction_information;  // Omega^l, zero where directions are not compared
};

// chi2 = e^T Omega e in its two parts.
struct BatchChi2 {
  alignas(64) PairBatch::Array<float> position, direction;
};
void chi2_of(const PairBatch& batch, BatchChi2& chi2);

// What each pair adds to H, b and the cost, by blocks: tt and rr are upper triangles row by row, tr is whole.
struct PairTerms {
  static constexpr int kTt = 0, kTr = 6, kRr = 15, kBt = 21, kBr = 24, kCost = 27, kCount = 28;
  alignas(64) float term[kCount][kPairsPerBatch];
};
// Kernels are in the batch's unit, and above 0.
void terms_of(const PairBatch& batch, float kernel_chi2, float kernel_direction_chi2, PairTerms& terms);

// lanes[t][k % kLanes] += terms.term[t][k].
using TermLanes = double[PairTerms::kCount][kLanes];
void add_terms(const PairTerms& terms, TermLanes& lanes);

}  // namespace augicp
