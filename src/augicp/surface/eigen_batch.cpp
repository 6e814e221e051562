// SPDX-License-Identifier: MIT
#include "augicp/surface/eigen_batch.h"

#include <cmath>

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

using Numbers = double[kEigenBatch];

// The elements of matrices divided by their traces; those beyond the last matrix are zero.
struct Elements {
  alignas(64) Numbers xx, xy, xz, yy, yz, zz, trace;
};

struct Solutions {
  alignas(64) Numbers l0, l1, l2;              // ascending, parts of the trace
  alignas(64) Numbers x0, y0, z0, x2, y2, z2;  // unit eigenvectors of l0 and l2
};

constexpr double kThird = 1.0 / 3.0;
constexpr double kTiny = 1e-300;

// Nearer eigenvalues have no clear vector of their own.
constexpr double kMinGap = 1e-3;

AUGICP_INLINE double at_least(double bound, double x) { return x > bound ? x : bound; }
AUGICP_INLINE double at_most(double bound, double x) { return x < bound ? x : bound; }

// acos(r) / 3 for r in [-1, 1] to 2e-8: Abramowitz and Stegun 4.4.46, as in symmetric_batch.cpp, there in float.
AUGICP_INLINE double third_of_arc_cosine(double r) {
  const double a = std::abs(r);
  const double series =
      1.5707963050 +
      a * (-0.2145988016 +
           a * (0.0889789874 +
                a * (-0.0501743046 +
                     a * (0.0308918810 + a * (-0.0170881256 + a * (0.0066700901 + a * -0.0012624911))))));
  const double of_positive = std::sqrt(1.0 - a) * series;
  return (r < 0.0 ? 3.14159265358979 - of_positive : of_positive) * kThird;
}

// For angles up to pi / 3, to 1e-7.
AUGICP_INLINE double cosine(double angle) {
  const double s = angle * angle;
  return 1.0 + s * (-1.0 / 2 + s * (1.0 / 24 + s * (-1.0 / 720 + s * (1.0 / 40320 + s * (-1.0 / 3628800)))));
}

// One step of Newton's method for a root of x^3 - 3 p^2 x - 2 q. At a double root it stays.
AUGICP_INLINE double improved(double x, double p_sq, double q) {
  const double slope = 3.0 * (x * x - p_sq), value = x * (x * x - 3.0 * p_sq) - 2.0 * q;
  return x - (slope > 1e-6 * p_sq ? value / at_least(kTiny, slope) : 0.0);
}

struct Vector {
  double x, y, z;
};

// A vector orthogonal to the rows of A - lambda I: the longest of their cross products.
AUGICP_INLINE Vector orthogonal_to_rows(double a, double b, double c, double d, double e, double f) {
  const double x01 = d * f - e * b, y01 = e * d - a * f, z01 = a * b - d * d;
  const double x02 = d * c - e * f, y02 = e * e - a * c, z02 = a * f - d * e;
  const double x12 = b * c - f * f, y12 = f * e - d * c, z12 = d * f - b * e;
  const double n01 = x01 * x01 + y01 * y01 + z01 * z01, n02 = x02 * x02 + y02 * y02 + z02 * z02,
               n12 = x12 * x12 + y12 * y12 + z12 * z12;
  double x = x01, y = y01, z = z01, n = n01;
  x = n02 > n ? x02 : x, y = n02 > n ? y02 : y, z = n02 > n ? z02 : z, n = n02 > n ? n02 : n;
  x = n12 > n ? x12 : x, y = n12 > n ? y12 : y, z = n12 > n ? z12 : z, n = n12 > n ? n12 : n;
  const double inverse = 1.0 / std::sqrt(at_least(kTiny, n));
  return {x * inverse, y * inverse, z * inverse};
}

// The trigonometric solution of the characteristic cubic (O. K. Smith, "Eigenvalues of a symmetric 3 x 3 matrix",
// 1961), improved by Newton's method.
AUGICP_VECTORIZED void solve(const Elements& __restrict m, Solutions& __restrict s) {
  for (std::size_t k = 0; k < kEigenBatch; ++k) {
    const double a = m.xx[k] - kThird, b = m.yy[k] - kThird, c = m.zz[k] - kThird;
    const double d = m.xy[k], e = m.xz[k], f = m.yz[k];
    const double p_sq = (a * a + b * b + c * c + 2.0 * (d * d + e * e + f * f)) * (1.0 / 6.0);
    const double p = std::sqrt(p_sq);
    const double q = 0.5 * (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e));
    const double angle = third_of_arc_cosine(at_least(-1.0, at_most(1.0, q / at_least(kTiny, p_sq * p))));
    const double l2 = improved(improved(2.0 * p * cosine(angle), p_sq, q), p_sq, q);
    const double l0 = improved(improved(-2.0 * p * cosine(3.14159265358979 * kThird - angle), p_sq, q), p_sq, q);
    s.l0[k] = at_least(0.0, kThird + l0);
    s.l1[k] = at_least(0.0, kThird - l0 - l2);
    s.l2[k] = kThird + l2;
    const Vector v0 = orthogonal_to_rows(a - l0, b - l0, c - l0, d, e, f);
    const Vector v2 = orthogonal_to_rows(a - l2, b - l2, c - l2, d, e, f);
    s.x0[k] = v0.x, s.y0[k] = v0.y, s.z0[k] = v0.z;
    s.x2[k] = v2.x, s.y2[k] = v2.y, s.z2[k] = v2.z;
  }
}

Elements elements_of(std::span<const Mat3d> matrices) {
  Elements m{};
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    const Mat3d& matrix = matrices[k];
    m.trace[k] = matrix.trace();
    const double scale = m.trace[k] > 0.0 ? 1.0 / m.trace[k] : 0.0;
    m.xx[k] = scale * matrix(0, 0), m.xy[k] = scale * matrix(0, 1), m.xz[k] = scale * matrix(0, 2);
    m.yy[k] = scale * matrix(1, 1), m.yz[k] = scale * matrix(1, 2), m.zz[k] = scale * matrix(2, 2);
  }
  return m;
}

bool is_clear(const Solutions& s, std::size_t k) {
  return s.l1[k] - s.l0[k] > kMinGap && s.l2[k] - s.l1[k] > kMinGap;  // false also where they are not finite
}

}  // namespace

void eigen_of_symmetric(std::span<const Mat3d> matrices, std::span<Eigen3> solved) {
  const Elements m = elements_of(matrices);
  Solutions s;
  solve(m, s);
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    if (!is_clear(s, k)) {
      solved[k] = eigen_of_symmetric(matrices[k]);
      continue;
    }
    const Vec3d first(s.x0[k], s.y0[k], s.z0[k]), last(s.x2[k], s.y2[k], s.z2[k]);
    solved[k].values = m.trace[k] * Vec3d(s.l0[k], s.l1[k], s.l2[k]);
    solved[k].vectors << first, last.cross(first), last;
  }
}

}  // namespace augicp
