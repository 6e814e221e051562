// SPDX-License-Identifier: MIT
// Vectors of three numbers of one entry of a batch: all inline, so that loops over entries can be made of vectors.
#pragma once

#include "augicp/objective/pair_batch.h"

namespace augicp {

template <typename Number>
struct Vec {
  Number x, y, z;
};
using Vecf = Vec<float>;
using Vecd = Vec<double>;

inline Vecf at(const PairBatch::Array<float> (&a)[3], int k) { return {a[0][k], a[1][k], a[2][k]}; }
inline Vecd wide(const Vecf& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
inline void put(PairBatch::Array<float> (&a)[3], int k, const Vecf& v) { a[0][k] = v.x, a[1][k] = v.y, a[2][k] = v.z; }
inline void put(PairBatch::Array<float> (&a)[3], int k, const Vecd& v) {
  put(a, k, Vecf{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

// Rows of a symmetric matrix.
struct Symmetric {
  float xx, xy, xz, yy, yz, zz;
  Vecf x() const { return {xx, xy, xz}; }
  Vecf y() const { return {xy, yy, yz}; }
  Vecf z() const { return {xz, yz, zz}; }
};
inline Symmetric at(const PairBatch::Symmetric& a, int k) {
  return {a[0][k], a[1][k], a[2][k], a[3][k], a[4][k], a[5][k]};
}
inline void put(PairBatch::Symmetric& a, int k, const Symmetric& m) {
  a[0][k] = m.xx, a[1][k] = m.xy, a[2][k] = m.xz, a[3][k] = m.yy, a[4][k] = m.yz, a[5][k] = m.zz;
}
inline Symmetric scaled(float s, const Symmetric& m) {
  return {s * m.xx, s * m.xy, s * m.xz, s * m.yy, s * m.yz, s * m.zz};
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
inline Vecf product(const Symmetric& m, const Vecf& a) { return {dot(m.x(), a), dot(m.y(), a), dot(m.z(), a)}; }

}  // namespace augicp
