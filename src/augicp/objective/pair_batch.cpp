// SPDX-License-Identifier: MIT
#include "augicp/objective/pair_batch.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

template <typename Number>
struct Vec {
  Number x, y, z;
};
using Vecf = Vec<float>;
using Vecd = Vec<double>;

inline Vecf at(const PairBatch::Array<float> (&a)[3], int k) { return {a[0][k], a[1][k], a[2][k]}; }
inline Vecd wide(const Vecf& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
inline void put(PairBatch::Array<float> (&a)[3], int k, const Vecf& v) { a[0][k] = v.x, a[1][k] = v.y, a[2][k] = v.z; }
inline void put(PairBatch::Array<float> (&a)[3], int k, const Vecd& v) {
  put(a, k, Vecf{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}
template <typename Number>
inline Number dot(const Vec<Number>& a, const Vec<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vecf cross(const Vecf& a, const Vecf& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename Number>
inline Vec<Number> scaled(Number s, const Vec<Number>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <typename Number>
inline Vec<Number> sum(const Vec<Number>& a, const Vec<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Number>
inline Vec<Number> difference(const Vec<Number>& a, const Vec<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Number>
inline Vec<Number> turned(const Number* r, const Vec<Number>& a) {
  return {r[0] * a.x + r[1] * a.y + r[2] * a.z, r[3] * a.x + r[4] * a.y + r[5] * a.z,
          r[6] * a.x + r[7] * a.y + r[8] * a.z};
}

// Omega x for Omega = across I + (along - across) d d^T.
inline Vecf weighed(float along, float across, const Vecf& d, const Vecf& x) {
  return sum(scaled(across, x), scaled((along - across) * dot(d, x), d));
}

// The natural logarithm of a number of at least 1 to the last digit or so, without branches, so that loops with it can be
// made of vectors: x = 2^e m with m about 1, and log m = 2 artanh((m - 1) / (m + 1)).
inline float log_of(float x) {
  constexpr std::uint32_t kMantissa = 0x007fffff, kOne = 0x3f800000;
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const float mantissa = std::bit_cast<float>((bits & kMantissa) | kOne);
  const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits >> 23) - 127);
  const bool is_upper = mantissa > 1.41421356f;
  const float f = (is_upper ? 0.5f * mantissa : mantissa) - 1.0f, e = is_upper ? exponent + 1.0f : exponent;
  const float s = f / (2.0f + f), z = s * s;
  return e * 0.693147181f + 2.0f * s * (1.0f + z * (1.0f / 3.0f + z * (1.0f / 5.0f + z * (1.0f / 7.0f + z * (1.0f / 9.0f)))));
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

constexpr auto kNone = static_cast<std::int32_t>(Structure::None), kPlanar = static_cast<std::int32_t>(Structure::Planar);

AUGICP_VECTORIZED void move_batch(const PairModel& __restrict model, PairBatch& __restrict b) {
  const double* const t = model.translation;
  float rotation[9];
  for (int i = 0; i < 9; ++i) rotation[i] = static_cast<float>(model.rotation[i]);
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vecd q = sum(turned(model.rotation, wide(at(b.source_point, k))), {t[0], t[1], t[2]});
    put(b.moved_point, k, q);
    put(b.position_error, k, difference(wide(at(b.target_point, k)), q));
  }
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vecf d = at(b.target_direction, k), l = turned(rotation, at(b.source_direction, k));
    // Eq. (7), but with the sign chosen first: a tangent and its opposite are the same edge.
    const bool is_opposite = (dot(l, d) < 0.0f) & ((b.structure[k] != kPlanar) | (model.one_sided == 0.0f));
    const Vecf m = scaled(is_opposite ? -1.0f : 1.0f, l);
    put(b.moved_direction, k, m);
    put(b.direction_error, k, difference(d, m));
  }
}

AUGICP_VECTORIZED void weigh_batch(const PairModel& __restrict model, PairBatch& __restrict b) {
  const ByStructure along = model.along, across = model.across, direction_along = model.direction_along,
                    direction_across = model.direction_across;
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const std::int32_t structure = b.structure[k];
    const float weight = b.weight[k], compared = b.compares[k] * weight;
    b.along[k] = weight * along.of(structure);
    b.across[k] = weight * across.of(structure);
    b.direction_along[k] = compared * direction_along.of(structure);
    b.direction_across[k] = compared * direction_across.of(structure);
  }
}

// A power of two about the largest information, so that the numbers in it have the same digits.
double unit_of(const InformationModel& model) {
  double largest = 0.0;
  for (const StructureInformation* row : {&model.none, &model.planar, &model.edge})
    for (const Information& information : {row->position, row->direction})
      largest = std::max({largest, information.along, information.across});
  return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

PairModel pair_model(const Rigid3& pose, const InformationModel& information, double unit, bool signed_normals) {
  PairModel model{};
  const Mat3d rotation = pose.rotation.toRotationMatrix();
  for (int i = 0; i < 9; ++i) model.rotation[i] = rotation(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) model.translation[i] = pose.translation[i];
  const auto table = [&](Information StructureInformation::*part, double Information::*number) {
    const auto of = [&](const StructureInformation& row) { return static_cast<float>(row.*part.*number / unit); };
    return ByStructure{of(information.none), of(information.planar), of(information.edge)};
  };
  model.along = table(&StructureInformation::position, &Information::along);
  model.across = table(&StructureInformation::position, &Information::across);
  model.direction_along = table(&StructureInformation::direction, &Information::along);
  model.direction_across = table(&StructureInformation::direction, &Information::across);
  model.one_sided = signed_normals ? 1.0f : 0.0f;
  return model;
}

void put(PairBatch::Array<float> (&a)[3], std::size_t k, const Vec3f& v) {
  a[0][k] = v.x(), a[1][k] = v.y(), a[2][k] = v.z();
}

}  // namespace

PairReader::PairReader(const Cloud& source, const Cloud& target, const Rigid3& target_from_source,
                       const InformationModel& information)
    : source_(source),
      target_(target),
      information_unit_(unit_of(information)),
      model_(pair_model(target_from_source, information, information_unit_, normals_have_signs(source, target))),
      compares_directions_(source.has_directions() && target.has_directions()) {}

void PairReader::gather(std::span<const Correspondence> pairs, PairBatch& batch) const {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [j, i] = pairs[k];
    put(batch.source_point, k, source_.points[j]);
    put(batch.target_point, k, target_.points[i]);
    batch.weight[k] = target_.weights.empty() ? 1.0f : target_.weights[i];
  }
  if (target_.has_directions())
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const std::uint32_t i = pairs[k].target;
      put(batch.target_direction, k, target_.directions[i]);
      batch.structure[k] = static_cast<std::int32_t>(target_.structures[i]);
    }
  if (compares_directions_)
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const std::uint32_t j = pairs[k].source;
      put(batch.source_direction, k, source_.directions[j]);
      // Where the structures differ the linear error has no meaning: Omega^l = 0.
      const auto structure = static_cast<std::int32_t>(source_.structures[j]);
      batch.compares[k] = structure != kNone && structure == batch.structure[k] ? 1.0f : 0.0f;
    }
}

void PairReader::read(std::span<const Correspondence> pairs, PairBatch& batch) const {
  gather(pairs, batch);
  std::fill(batch.weight + pairs.size(), batch.weight + kPairsPerBatch, 0.0f);
  std::fill(batch.compares + pairs.size(), batch.compares + kPairsPerBatch, 0.0f);
  move_batch(model_, batch);
  weigh_batch(model_, batch);
}

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
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Robust of_direction = robust(direction_chi2(b, k), kernel_direction_chi2);
    const Robust of_pair = robust(position_chi2(b, k) + of_direction.loss, kernel_chi2);
    const float gamma = of_pair.gamma, direction_gamma = gamma * of_direction.gamma;
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
    t[Terms::kCost][k] = 0.5f * of_pair.loss;
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
