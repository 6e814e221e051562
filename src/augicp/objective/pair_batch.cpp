// SPDX-License-Identifier: MIT
#include "augicp/objective/pair_batch.h"

#include <bit>
#include <cmath>

#include "augicp/core/vectorized.h"
#include "augicp/objective/pair_vectors.h"

namespace augicp {
namespace {

// The natural logarithm of a number of at least 1 to the last digit or so, without branches, so that loops with it can
// be made of vectors: x = 2^e m with m about 1, and log m = 2 artanh((m - 1) / (m + 1)).
inline float log_of(float x) {
  constexpr std::uint32_t kMantissa = 0x007fffff, kOne = 0x3f800000;
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const float mantissa = std::bit_cast<float>((bits & kMantissa) | kOne);
  const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits >> 23) - 127);
  const bool is_upper = mantissa > 1.41421356f;
  const float f = (is_upper ? 0.5f * mantissa : mantissa) - 1.0f, e = is_upper ? exponent + 1.0f : exponent;
  const float s = f / (2.0f + f), z = s * s;
  return e * 0.693147181f +
         2.0f * s * (1.0f + z * (1.0f / 3.0f + z * (1.0f / 5.0f + z * (1.0f / 7.0f + z * (1.0f / 9.0f)))));
}

// Eq. (13), and the loss that has it as its derivative.
struct Robust {
  float gamma, loss;
};
inline Robust robust(float chi2, float kernel_chi2) {
  const bool is_within = chi2 < kernel_chi2;
  const float ratio = is_within ? 1.0f : chi2 / kernel_chi2;
  return {1.0f / ratio, is_within ? chi2 : kernel_chi2 * (1.0f + log_of(ratio))};
}

inline float chi2_at(const PairBatch::Symmetric& information, const PairBatch::Array<float> (&error)[3], int k) {
  const Vecf e = at(error, k);
  return dot(e, product(at(information, k), e));
}

}  // namespace

AUGICP_VECTORIZED void chi2_of(const PairBatch& __restrict batch, BatchChi2& __restrict chi2) {
  for (int k = 0; k < kPairsPerBatch; ++k) {
    chi2.position[k] = chi2_at(batch.position_information, batch.position_error, k);
    chi2.direction[k] = chi2_at(batch.direction_information, batch.direction_error, k);
  }
}

// Eq. (12) with a rotation vector for the increment, which removes the factor 2 of the quaternion's imaginary part:
// J = [-I  [q]x; 0  [m]x], q = T (+) p_j, m = R l_j. The position's part of J^T Omega J is [Omega  B; B^T  [q]x B] with
// B = -Omega [q]x, whose rows are q x (row of Omega); the direction's is the lower right of the same with m for q.
AUGICP_VECTORIZED void terms_of(const PairBatch& __restrict batch, float kernel_chi2, float kernel_direction_chi2,
                                PairTerms& __restrict terms) {
  const PairBatch& b = batch;
  auto& t = terms.term;
  using Terms = PairTerms;
  // In a loop of its own: each step of it waits for the one before, and processors look some hundred steps ahead.
  alignas(64) float gammas[kPairsPerBatch], direction_gammas[kPairsPerBatch];
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Robust of_direction = robust(chi2_at(b.direction_information, b.direction_error, k), kernel_direction_chi2);
    const Robust of_pair =
        robust(chi2_at(b.position_information, b.position_error, k) + of_direction.loss, kernel_chi2);
    gammas[k] = of_pair.gamma;
    direction_gammas[k] = of_pair.gamma * of_direction.gamma;
    t[Terms::kCost][k] = 0.5f * of_pair.loss;
  }
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vecf q = at(b.moved_point, k), m = at(b.moved_direction, k);
    const Symmetric p = scaled(gammas[k], at(b.position_information, k));
    const Symmetric l = scaled(direction_gammas[k], at(b.direction_information, k));
    const Vecf px = cross(q, p.x()), py = cross(q, p.y()), pz = cross(q, p.z());  // rows of B
    const Vecf lx = cross(m, l.x()), ly = cross(m, l.y()), lz = cross(m, l.z());
    t[Terms::kTt + 0][k] = p.xx;
    t[Terms::kTt + 1][k] = p.xy;
    t[Terms::kTt + 2][k] = p.xz;
    t[Terms::kTt + 3][k] = p.yy;
    t[Terms::kTt + 4][k] = p.yz;
    t[Terms::kTt + 5][k] = p.zz;
    t[Terms::kTr + 0][k] = px.x;
    t[Terms::kTr + 1][k] = px.y;
    t[Terms::kTr + 2][k] = px.z;
    t[Terms::kTr + 3][k] = py.x;
    t[Terms::kTr + 4][k] = py.y;
    t[Terms::kTr + 5][k] = py.z;
    t[Terms::kTr + 6][k] = pz.x;
    t[Terms::kTr + 7][k] = pz.y;
    t[Terms::kTr + 8][k] = pz.z;
    t[Terms::kRr + 0][k] = (q.y * pz.x - q.z * py.x) + (m.y * lz.x - m.z * ly.x);
    t[Terms::kRr + 1][k] = (q.y * pz.y - q.z * py.y) + (m.y * lz.y - m.z * ly.y);
    t[Terms::kRr + 2][k] = (q.y * pz.z - q.z * py.z) + (m.y * lz.z - m.z * ly.z);
    t[Terms::kRr + 3][k] = (q.z * px.y - q.x * pz.y) + (m.z * lx.y - m.x * lz.y);
    t[Terms::kRr + 4][k] = (q.z * px.z - q.x * pz.z) + (m.z * lx.z - m.x * lz.z);
    t[Terms::kRr + 5][k] = (q.x * py.z - q.y * px.z) + (m.x * ly.z - m.y * lx.z);
    const Vecf force = product(p, at(b.position_error, k)), turn = product(l, at(b.direction_error, k));
    const Vecf torque = sum(cross(q, force), cross(m, turn));
    t[Terms::kBt + 0][k] = -force.x;
    t[Terms::kBt + 1][k] = -force.y;
    t[Terms::kBt + 2][k] = -force.z;
    t[Terms::kBr + 0][k] = -torque.x;
    t[Terms::kBr + 1][k] = -torque.y;
    t[Terms::kBr + 2][k] = -torque.z;
  }
}

AUGICP_VECTORIZED void add_terms(const PairTerms& __restrict terms, TermLanes& __restrict lanes) {
  for (int t = 0; t < PairTerms::kCount; ++t) {
    float sums[kLanes] = {};
    for (int k = 0; k < kPairsPerBatch; k += kLanes)
      for (int lane = 0; lane < kLanes; ++lane) sums[lane] += terms.term[t][k + lane];
    for (int lane = 0; lane < kLanes; ++lane) lanes[t][lane] += static_cast<double>(sums[lane]);
  }
}

}  // namespace augicp
