// SPDX-License-Identifier: MIT
#include "augicp/objective/pair_batch.h"

#include <bit>
#include <cmath>

#include "augicp/core/vectorized.h"
#include "augicp/objective/pair_vectors.h"

namespace augicp {
namespace {

// Omega x for Omega = across I + (along - across) d d^T.
inline Vecf weighed(float along, float across, const Vecf& d, const Vecf& x) {
  return sum(scaled(across, x), scaled((along - across) * dot(d, x), d));
}

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

inline float position_chi2(const PairBatch& b, int k) {
  const Vecf e = at(b.position_error, k);
  return dot(e, weighed(b.along[k], b.across[k], at(b.target_direction, k), e));
}
inline float direction_chi2(const PairBatch& b, int k) {
  const Vecf e = at(b.direction_error, k);
  return dot(e, weighed(b.direction_along[k], b.direction_across[k], at(b.target_direction, k), e));
}

}  // namespace

AUGICP_VECTORIZED void chi2_of(const PairBatch& __restrict batch, BatchChi2& __restrict chi2) {
  for (int k = 0; k < kPairsPerBatch; ++k) {
    chi2.position[k] = position_chi2(batch, k);
    chi2.direction[k] = direction_chi2(batch, k);
  }
}

// Eq. (12) with a rotation vector for the increment, which removes the factor 2 of the quaternion's imaginary part:
// J = [-I  [q]x; 0  [m]x], q = T (+) p_j, m = R l_j. The position's part of J^T Omega J for Omega = a I + c d d^T is
// a [I  -[q]x; [q]x  |q|^2 I - q q^T]  +  c v v^T with v = (d, q x d); the direction's is the lower right of the same
// with m for q.
AUGICP_VECTORIZED void terms_of(const PairBatch& __restrict batch, float kernel_chi2, float kernel_direction_chi2,
                                PairTerms& __restrict terms) {
  const PairBatch& b = batch;
  auto& t = terms.term;
  using Terms = PairTerms;
  // In a loop of its own: each step of it waits for the one before, and processors look some hundred steps ahead.
  alignas(64) float gammas[kPairsPerBatch], direction_gammas[kPairsPerBatch];
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Robust of_direction = robust(direction_chi2(b, k), kernel_direction_chi2);
    const Robust of_pair = robust(position_chi2(b, k) + of_direction.loss, kernel_chi2);
    gammas[k] = of_pair.gamma;
    direction_gammas[k] = of_pair.gamma * of_direction.gamma;
    t[Terms::kCost][k] = 0.5f * of_pair.loss;
  }
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const float gamma = gammas[k], direction_gamma = direction_gammas[k];
    const Vecf d = at(b.target_direction, k), q = at(b.moved_point, k), m = at(b.moved_direction, k);
    const Vecf qd = cross(q, d), md = cross(m, d);
    const float a = gamma * b.across[k], c = gamma * (b.along[k] - b.across[k]);
    const float al = direction_gamma * b.direction_across[k],
                cl = direction_gamma * (b.direction_along[k] - b.direction_across[k]);
    const Vecf cd = scaled(c, d), cqd = scaled(c, qd), clmd = scaled(cl, md), aq = scaled(a, q), alm = scaled(al, m);
    const float diagonal = dot(aq, q) + dot(alm, m);
    t[Terms::kTt + 0][k] = a + cd.x * d.x;
    t[Terms::kTt + 1][k] = cd.x * d.y;
    t[Terms::kTt + 2][k] = cd.x * d.z;
    t[Terms::kTt + 3][k] = a + cd.y * d.y;
    t[Terms::kTt + 4][k] = cd.y * d.z;
    t[Terms::kTt + 5][k] = a + cd.z * d.z;
    t[Terms::kTr + 0][k] = cd.x * qd.x;
    t[Terms::kTr + 1][k] = cd.x * qd.y;
    t[Terms::kTr + 2][k] = cd.x * qd.z;
    t[Terms::kTr + 3][k] = cd.y * qd.x;
    t[Terms::kTr + 4][k] = cd.y * qd.y;
    t[Terms::kTr + 5][k] = cd.y * qd.z;
    t[Terms::kTr + 6][k] = cd.z * qd.x;
    t[Terms::kTr + 7][k] = cd.z * qd.y;
    t[Terms::kTr + 8][k] = cd.z * qd.z;
    t[Terms::kRr + 0][k] = diagonal + (cqd.x * qd.x - aq.x * q.x) + (clmd.x * md.x - alm.x * m.x);
    t[Terms::kRr + 1][k] = (cqd.x * qd.y - aq.x * q.y) + (clmd.x * md.y - alm.x * m.y);
    t[Terms::kRr + 2][k] = (cqd.x * qd.z - aq.x * q.z) + (clmd.x * md.z - alm.x * m.z);
    t[Terms::kRr + 3][k] = diagonal + (cqd.y * qd.y - aq.y * q.y) + (clmd.y * md.y - alm.y * m.y);
    t[Terms::kRr + 4][k] = (cqd.y * qd.z - aq.y * q.z) + (clmd.y * md.z - alm.y * m.z);
    t[Terms::kRr + 5][k] = diagonal + (cqd.z * qd.z - aq.z * q.z) + (clmd.z * md.z - alm.z * m.z);
    t[Terms::kAcrossPoint + 0][k] = aq.x;
    t[Terms::kAcrossPoint + 1][k] = aq.y;
    t[Terms::kAcrossPoint + 2][k] = aq.z;
    const Vecf force = scaled(gamma, weighed(b.along[k], b.across[k], d, at(b.position_error, k)));
    const Vecf turn =
        scaled(direction_gamma, weighed(b.direction_along[k], b.direction_across[k], d, at(b.direction_error, k)));
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
