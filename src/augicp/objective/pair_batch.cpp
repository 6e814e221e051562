// SPDX-License-Identifier: MIT
#include "augicp/objective/pair_batch.h"

#include <bit>
#include <cmath>

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

struct Vec {
  double x, y, z;
};
inline Vec at(const PairBatch::Array<double> (&a)[3], int k) { return {a[0][k], a[1][k], a[2][k]}; }
inline Vec at(const PairBatch::Array<float> (&a)[3], int k) {
  return {static_cast<double>(a[0][k]), static_cast<double>(a[1][k]), static_cast<double>(a[2][k])};
}
inline void put(PairBatch::Array<double> (&a)[3], int k, const Vec& v) { a[0][k] = v.x, a[1][k] = v.y, a[2][k] = v.z; }
inline double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec scaled(double s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec sum(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec difference(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec turned(const double* rotation, const Vec& a) {
  const double* const r = rotation;
  return {r[0] * a.x + r[1] * a.y + r[2] * a.z, r[3] * a.x + r[4] * a.y + r[5] * a.z,
          r[6] * a.x + r[7] * a.y + r[8] * a.z};
}

// Omega x for Omega = across I + (along - across) d d^T.
inline Vec weighed(double along, double across, const Vec& d, const Vec& x) {
  return sum(scaled(across, x), scaled((along - across) * dot(d, x), d));
}

// The natural logarithm of a positive, finite, normal number to the last digit or so, by the series of fdlibm's e_log.c
// (Sun Microsystems 1993) but without its branches, so that loops with it can be made of vectors.
inline double log_of(double x) {
  constexpr std::uint64_t kMantissa = 0x000fffffffffffff, kOne = 0x3ff0000000000000, kTwo52 = 0x4330000000000000;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const double mantissa = std::bit_cast<double>((bits & kMantissa) | kOne);
  // The exponent as the lowest digits of a number whose unit they are.
  const double exponent = std::bit_cast<double>((bits >> 52) | kTwo52) - (4503599627370496.0 + 1023.0);
  const bool is_upper = mantissa > 1.4142135623730951;
  const double f = (is_upper ? 0.5 * mantissa : mantissa) - 1.0, e = is_upper ? exponent + 1.0 : exponent;
  const double s = f / (2.0 + f), z = s * s, w = z * z;
  const double even = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const double odd =
      z * (6.666666666666735130e-01 +
           w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  const double half_sq = 0.5 * f * f;
  return e * 6.93147180369123816490e-01 -
         ((half_sq - (s * (half_sq + (even + odd)) + e * 1.90821492927058770002e-10)) - f);
}

// Eq. (13), and the loss that has it as its derivative.
struct Robust {
  double gamma, loss;
};
inline Robust robust(double chi2, double kernel_chi2) {
  const bool is_within = chi2 < kernel_chi2;
  const double ratio = is_within ? 1.0 : chi2 / kernel_chi2;
  return {1.0 / ratio, is_within ? chi2 : kernel_chi2 * (1.0 + log_of(ratio))};
}

inline double position_chi2(const PairBatch& b, int k) {
  const Vec e = at(b.position_error, k);
  return dot(e, weighed(b.along[k], b.across[k], at(b.target_direction, k), e));
}
inline double direction_chi2(const PairBatch& b, int k) {
  const Vec e = at(b.direction_error, k);
  return dot(e, weighed(b.direction_along[k], b.direction_across[k], at(b.target_direction, k), e));
}

AUGICP_VECTORIZED void move_batch(const double* __restrict rotation, const double* __restrict translation,
                                  PairBatch& __restrict b) {
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vec q = sum(turned(rotation, at(b.source_point, k)), {translation[0], translation[1], translation[2]});
    const Vec d = at(b.target_direction, k);
    const Vec l = turned(rotation, at(b.source_direction, k));
    // Eq. (7), but with the sign chosen first: a tangent and its opposite are the same edge.
    const double side = dot(l, d) < 0.0 && b.one_sided[k] == 0.0 ? -1.0 : 1.0;
    const Vec m = scaled(side, l);
    put(b.moved_point, k, q);
    put(b.moved_direction, k, m);
    put(b.position_error, k, difference(at(b.target_point, k), q));
    put(b.direction_error, k, difference(d, m));
  }
}

}  // namespace

PairReader::PairReader(const Cloud& source, const Cloud& target, const Rigid3& target_from_source,
                       const InformationModel& information)
    : source_(source),
      target_(target),
      information_(information),
      target_has_directions_(target.has_directions()),
      compares_directions_(source.has_directions() && target.has_directions()),
      signed_normals_(normals_have_signs(source, target)) {
  const Mat3d rotation = target_from_source.rotation.toRotationMatrix();
  for (int i = 0; i < 9; ++i) rotation_[i] = rotation(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) translation_[i] = target_from_source.translation[i];
}

void PairReader::read(std::span<const Correspondence> pairs, PairBatch& batch) const {
  if (pairs.size() < kPairsPerBatch) batch = {};
  const auto put = [](PairBatch::Array<float>(&array)[3], std::size_t k, const Vec3f& v) {
    array[0][k] = v.x(), array[1][k] = v.y(), array[2][k] = v.z();
  };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [j, i] = pairs[k];
    const double weight = target_.weights.empty() ? 1.0 : static_cast<double>(target_.weights[i]);
    const Structure structure = target_has_directions_ ? target_.structures[i] : Structure::None;
    // Where the structures differ the linear error has no meaning: Omega^l = 0.
    const bool compares = compares_directions_ && structure != Structure::None && source_.structures[j] == structure;
    const StructureInformation& information = information_.of(structure);
    put(batch.source_point, k, source_.points[j]);
    put(batch.target_point, k, target_.points[i]);
    put(batch.source_direction, k, compares ? source_.directions[j] : Vec3f(Vec3f::Zero()));
    put(batch.target_direction, k, structure != Structure::None ? target_.directions[i] : Vec3f(Vec3f::Zero()));
    batch.along[k] = weight * information.position.along;
    batch.across[k] = weight * information.position.across;
    batch.direction_along[k] = compares ? weight * information.direction.along : 0.0;
    batch.direction_across[k] = compares ? weight * information.direction.across : 0.0;
    batch.one_sided[k] = structure == Structure::Planar && signed_normals_ ? 1.0 : 0.0;
    batch.compares[k] = compares;
  }
}

void PairReader::move(PairBatch& batch) const { move_batch(rotation_, translation_, batch); }

AUGICP_VECTORIZED void chi2_of(const PairBatch& batch, BatchChi2& chi2) {
  for (int k = 0; k < kPairsPerBatch; ++k) {
    chi2.position[k] = position_chi2(batch, k);
    chi2.direction[k] = direction_chi2(batch, k);
  }
}

// Eq. (12) with a rotation vector for the increment, which removes the factor 2 of the quaternion's imaginary part:
// J = [-I  [q]x; 0  [m]x], q = T (+) p_j, m = R l_j. The position's part of J^T Omega J for Omega = a I + c d d^T is
// a [I  -[q]x; [q]x  |q|^2 I - q q^T]  +  c v v^T with v = (d, q x d); the direction's is the lower right of the same
// with m for q.
AUGICP_VECTORIZED void terms_of(const PairBatch& batch, double kernel_chi2, double kernel_direction_chi2,
                                PairTerms& __restrict terms) {
  const PairBatch& b = batch;
  auto& t = terms.term;
  using Terms = PairTerms;
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Robust of_direction = robust(direction_chi2(b, k), kernel_direction_chi2);
    const Robust of_pair = robust(position_chi2(b, k) + of_direction.loss, kernel_chi2);
    const double gamma = of_pair.gamma, direction_gamma = gamma * of_direction.gamma;
    const Vec d = at(b.target_direction, k), q = at(b.moved_point, k), m = at(b.moved_direction, k);
    const Vec qd = cross(q, d), md = cross(m, d);
    const double a = gamma * b.across[k], c = gamma * (b.along[k] - b.across[k]);
    const double al = direction_gamma * b.direction_across[k],
                 cl = direction_gamma * (b.direction_along[k] - b.direction_across[k]);
    const Vec cd = scaled(c, d), cqd = scaled(c, qd), clmd = scaled(cl, md), aq = scaled(a, q), alm = scaled(al, m);
    const double diagonal = dot(aq, q) + dot(alm, m);
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
    const Vec force = scaled(gamma, weighed(b.along[k], b.across[k], d, at(b.position_error, k)));
    const Vec turn =
        scaled(direction_gamma, weighed(b.direction_along[k], b.direction_across[k], d, at(b.direction_error, k)));
    const Vec torque = sum(cross(q, force), cross(m, turn));
    t[Terms::kBt + 0][k] = -force.x;
    t[Terms::kBt + 1][k] = -force.y;
    t[Terms::kBt + 2][k] = -force.z;
    t[Terms::kBr + 0][k] = -torque.x;
    t[Terms::kBr + 1][k] = -torque.y;
    t[Terms::kBr + 2][k] = -torque.z;
    t[Terms::kCost][k] = 0.5 * of_pair.loss;
  }
}

AUGICP_VECTORIZED void add_terms(const PairTerms& __restrict terms, TermLanes& __restrict lanes) {
  for (int t = 0; t < PairTerms::kCount; ++t) {
    double sums[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) sums[lane] = lanes[t][lane];
    for (int k = 0; k < kPairsPerBatch; k += kLanes)
      for (int lane = 0; lane < kLanes; ++lane) sums[lane] += terms.term[t][k + lane];
    for (int lane = 0; lane < kLanes; ++lane) lanes[t][lane] = sums[lane];
  }
}

}  // namespace augicp
