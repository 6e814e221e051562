// SPDX-License-Identifier: MIT
#include "augicp/surface/symmetric_batch.h"

#include <cmath>

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

// A sum of eigenvalues below this counts as a zero matrix.
constexpr float kTiny = 1e-30f;

// cos(acos(r) / 3) and sin(acos(r) / 3) for r in [-1, 1]. acos: Abramowitz and Stegun 4.4.46, to 2e-8; the angle is at
// most pi / 3, where the Taylor series below are good to 1e-7.
struct CosSin {
  float cos, sin;
};
inline CosSin third_of_arc_cosine(float r) {
  const float a = std::abs(r);
  const float series =
      1.5707963050f +
      a * (-0.2145988016f +
           a * (0.0889789874f +
                a * (-0.0501743046f +
                     a * (0.0308918810f + a * (-0.0170881256f + a * (0.0066700901f + a * -0.0012624911f))))));
  const float of_positive = std::sqrt(1.0f - a) * series;
  const float angle = (r < 0.0f ? 3.14159265f - of_positive : of_positive) * (1.0f / 3.0f);
  const float s = angle * angle;
  const float cosine =
      1.0f + s * (-0.5f + s * (1.0f / 24.0f + s * (-1.0f / 720.0f + s * (1.0f / 40320.0f + s * (-1.0f / 3628800.0f)))));
  const float sine =
      angle * (1.0f + s * (-1.0f / 6.0f + s * (1.0f / 120.0f + s * (-1.0f / 5040.0f + s * (1.0f / 362880.0f)))));
  return {cosine, sine};
}

inline float at_least(float bound, float x) { return x > bound ? x : bound; }
inline float at_most(float bound, float x) { return x < bound ? x : bound; }

}  // namespace

// The trigonometric solution of the characteristic cubic, for the matrix divided by its trace: O. K. Smith,
// "Eigenvalues of a symmetric 3 x 3 matrix", 1961.
AUGICP_VECTORIZED void eigenvalues(const SymmetricBatch& matrices, EigenvalueBatch& values) {
  const SymmetricBatch& m = matrices;
  for (int k = 0; k < kBatch; ++k) {
    const float trace = at_least(kTiny, m.xx[k] + m.yy[k] + m.zz[k]);
    const float scale = 1.0f / trace;
    constexpr float kThird = 1.0f / 3.0f;
    const float a = m.xx[k] * scale - kThird, b = m.yy[k] * scale - kThird, c = m.zz[k] * scale - kThird;
    const float d = m.xy[k] * scale, e = m.xz[k] * scale, f = m.yz[k] * scale;
    const float p_sq = (a * a + b * b + c * c + 2.0f * (d * d + e * e + f * f)) * (1.0f / 6.0f);
    const float p = std::sqrt(p_sq);
    const float half_det = 0.5f * (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e));
    const float r = at_least(-1.0f, at_most(1.0f, half_det / at_least(kTiny, p_sq * p)));
    const CosSin third = third_of_arc_cosine(r);
    constexpr float kHalfRootThree = 0.866025404f;
    const float l0 = kThird - p * (third.cos + 2.0f * kHalfRootThree * third.sin), l2 = kThird + 2.0f * p * third.cos;
    const float l1 = kThird - p * (third.cos - 2.0f * kHalfRootThree * third.sin);
    values.l0[k] = trace * at_least(0.0f, l0);
    values.l1[k] = trace * at_least(0.0f, l1);
    values.l2[k] = trace * l2;
  }
}

// A vector orthogonal to the rows of A - lambda I: the longest of their cross products.
AUGICP_VECTORIZED void eigenvectors(const SymmetricBatch& matrices, const BatchArray& eigenvalue,
                                    VectorBatch& vectors) {
  const SymmetricBatch& m = matrices;
  for (int k = 0; k < kBatch; ++k) {
    const float trace = m.xx[k] + m.yy[k] + m.zz[k];
    const float scale = 1.0f / at_least(kTiny, trace), l = eigenvalue[k] * scale;
    const float a = m.xx[k] * scale - l, b = m.yy[k] * scale - l, c = m.zz[k] * scale - l;
    const float d = m.xy[k] * scale, e = m.xz[k] * scale, f = m.yz[k] * scale;
    const float x01 = d * f - e * b, y01 = e * d - a * f, z01 = a * b - d * d;
    const float x02 = d * c - e * f, y02 = e * e - a * c, z02 = a * f - d * e;
    const float x12 = b * c - f * f, y12 = f * e - d * c, z12 = d * f - b * e;
    const float n01 = x01 * x01 + y01 * y01 + z01 * z01, n02 = x02 * x02 + y02 * y02 + z02 * z02,
                n12 = x12 * x12 + y12 * y12 + z12 * z12;
    float x = x01, y = y01, z = z01, n = n01;
    x = n02 > n ? x02 : x, y = n02 > n ? y02 : y, z = n02 > n ? z02 : z, n = n02 > n ? n02 : n;
    x = n12 > n ? x12 : x, y = n12 > n ? y12 : y, z = n12 > n ? z12 : z, n = n12 > n ? n12 : n;
    // Cross products shorter than their rounding errors have no direction.
    const float inverse = n > 1e-13f ? 1.0f / std::sqrt(at_least(kTiny, n)) : 0.0f;
    vectors.x[k] = x * inverse;
    vectors.y[k] = y * inverse;
    vectors.z[k] = z * inverse;
  }
}

}  // namespace augicp
