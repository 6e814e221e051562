// SPDX-License-Identifier: MIT
#include "augicp/surface/window_sums.h"

#include "augicp/core/vectorized.h"
#include "augicp/surface/vectors.h"

namespace augicp {
namespace {

// The channels of a pixel: wide vectors, and one of half the size for the rest (none for 8 floats, two of 10 doubles).
template <typename Number, int kChannels>
struct Pixel {
  static constexpr int kLanes = Wide<Number>::kLanes, kNumWide = kChannels / kLanes, kRest = kChannels % kLanes;
  static_assert(kRest == 0 || kRest == kLanes / 2);
  typename Wide<Number>::Vector wide[kNumWide];
  typename Vectors<Number, 16>::Vector rest;

  AUGICP_INLINE void read(const Number* from) {
    for (int w = 0; w < kNumWide; ++w) load(from + w * kLanes, wide[w]);
    if constexpr (kRest > 0) load(from + kNumWide * kLanes, rest);
  }
  AUGICP_INLINE void write(Number* to) const {
    for (int w = 0; w < kNumWide; ++w) store(wide[w], to + w * kLanes);
    if constexpr (kRest > 0) store(rest, to + kNumWide * kLanes);
  }
  AUGICP_INLINE void add(const Pixel& other) {
    for (int w = 0; w < kNumWide; ++w) wide[w] += other.wide[w];
    if constexpr (kRest > 0) rest += other.rest;
  }
  AUGICP_INLINE void subtract(const Pixel& other) {
    for (int w = 0; w < kNumWide; ++w) wide[w] -= other.wide[w];
    if constexpr (kRest > 0) rest -= other.rest;
  }
};

// Writes the running sum for each pixel.
template <typename Number, int kChannels>
class PrefixSum {
 public:
  AUGICP_INLINE explicit PrefixSum(Number* prefix) : next_(prefix) { write(); }
  AUGICP_INLINE void add(const Pixel<Number, kChannels>& value) { sum_.add(value); }
  AUGICP_INLINE void write() { sum_.write(next_), next_ += kChannels; }

 private:
  Pixel<Number, kChannels> sum_ = {};
  Number* next_;
};

// The channels of a point and of a direction, as element-wise products of two vectors.
AUGICP_INLINE void multiply_out(const Vec3f& p, Pixel<double, 10>& value) {
  const Vectors<float, 16>::Vector one_xyz = {1.0f, p.x(), p.y(), p.z()};
  const Wide<double>::Vector a = __builtin_convertvector(one_xyz, Wide<double>::Vector);
  value.wide[0] = a;
  value.wide[1] = __builtin_shufflevector(a, a, 1, 1, 1, 2) * __builtin_shufflevector(a, a, 1, 2, 3, 2);
  value.rest = __builtin_shufflevector(a, a, 2, 3) * __builtin_shufflevector(a, a, 3, 3);
}
AUGICP_INLINE void multiply_out(const Direction& direction, float least_weight, Pixel<float, 8>& value) {
  Vectors<float, 16>::Vector d;
  load(direction.xyz, d);
  const Vectors<float, 16>::Vector one = {1.0f, 0.0f, 0.0f, 0.0f};
  const float weight = direction.weight >= least_weight ? direction.weight : 0.0f;
  value.wide[0] = __builtin_shufflevector(d, one, 4, 0, 0, 0, 1, 1, 2, 2) * weight *
                  __builtin_shufflevector(d, one, 4, 0, 1, 2, 1, 2, 2, 5);
}

template <typename Moments, typename Number = typename Moments::Number>
AUGICP_INLINE void add_row_to(const Number* prefix, const Span* spans, int count, Number* sums) {
  constexpr std::size_t kChannels = Moments::kChannels, kStride = kBatch * kChannels;
  Pixel<Number, kChannels> sum, end, begin;
  for (int k = 0; k < count; ++k) {
    end.read(prefix + spans[k].end * kChannels);
    begin.read(prefix + spans[k].begin * kChannels);
    end.subtract(begin);
    sum.read(sums + k * kChannels);
    sum.add(end);
    sum.write(sums + kStride + k * kChannels);
  }
}

// Transposes rows to columns in three steps: columns of two rows, of four, of all.
AUGICP_INLINE void transpose(Wide<float>::Vector (&rows)[8]) {
  Wide<float>::Vector two[8], four[8];
  for (int k = 0; k < 8; k += 2) {
    two[k] = __builtin_shufflevector(rows[k], rows[k + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    two[k + 1] = __builtin_shufflevector(rows[k], rows[k + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int k = 0; k < 8; k += 4)
    for (int half = 0; half < 2; ++half) {
      four[k + 2 * half] = __builtin_shufflevector(two[k + half], two[k + 2 + half], 0, 1, 8, 9, 4, 5, 12, 13);
      four[k + 2 * half + 1] = __builtin_shufflevector(two[k + half], two[k + 2 + half], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    rows[k] = __builtin_shufflevector(four[k], four[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    rows[k + 4] = __builtin_shufflevector(four[k], four[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

// Points: xx, xy, xz, yy, yz, zz of their covariance, their number, 0.
AUGICP_INLINE void summarize(const Pixel<double, 10>& sums, Wide<float>::Vector& window) {
  const Wide<double>::Vector& first = sums.wide[0];
  const double count = first[0], inverse = 1.0 / (count > 1.0 ? count : 1.0);
  const Wide<double>::Vector mean = first * inverse,
                             xx_to_yy = sums.wide[1] * inverse - __builtin_shufflevector(mean, mean, 1, 1, 1, 2) *
                                                                     __builtin_shufflevector(mean, mean, 1, 2, 3, 2);
  const Vectors<double, 16>::Vector yz_zz = sums.rest * inverse - __builtin_shufflevector(mean, mean, 2, 3) *
                                                                      __builtin_shufflevector(mean, mean, 3, 3),
                                    count_0 = {count, 0.0};
  using Half = Vectors<float, 16>::Vector;
  const Half low = __builtin_convertvector(xx_to_yy, Half);
  const Half high = __builtin_convertvector(__builtin_shufflevector(yz_zz, count_0, 0, 1, 2, 3), Half);
  window = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
// Directions: the same sums, and their weight.
AUGICP_INLINE void summarize(const Pixel<float, 8>& sums, Wide<float>::Vector& window) {
  window = __builtin_shufflevector(sums.wide[0], sums.wide[0], 1, 2, 3, 4, 5, 6, 0, 7);
}

template <typename Moments, typename Number = typename Moments::Number>
AUGICP_INLINE void look_into(const Number* prefix, const Span* spans, WindowBatch& windows) {
  constexpr std::size_t kChannels = Moments::kChannels, kStride = kBatch * kChannels;
  constexpr int kLanes = Wide<float>::kLanes;
  static_assert(kBatch % kLanes == 0);
  SymmetricBatch& m = windows.matrix;
  for (int k = 0; k < kBatch; k += kLanes) {
    Wide<float>::Vector rows[kLanes];
    Pixel<Number, kChannels> sums, before;
    for (int lane = 0; lane < kLanes; ++lane) {
      const Number* const column = prefix + (k + lane) * kChannels;
      sums.read(column + spans[k + lane].end * kStride);
      before.read(column + spans[k + lane].begin * kStride);
      sums.subtract(before);
      summarize(sums, rows[lane]);
    }
    transpose(rows);
    store(rows[0], m.xx + k), store(rows[1], m.xy + k), store(rows[2], m.xz + k);
    store(rows[3], m.yy + k), store(rows[4], m.yz + k), store(rows[5], m.zz + k);
    store(rows[6], windows.weight + k);
  }
}

}  // namespace

AUGICP_VECTORIZED void accumulate(const Vec3f* points, const std::int32_t* index, int count, double* prefix) {
  PrefixSum<double, PointMoments::kChannels> sum(prefix);
  Pixel<double, PointMoments::kChannels> value;
  for (int k = 0; k < count; ++k) {
    if (index[k] != IndexImage::kNone) {
      multiply_out(points[index[k]], value);
      sum.add(value);
    }
    sum.write();
  }
}
AUGICP_VECTORIZED void accumulate(const Direction* directions, int count, float least_weight, float* prefix) {
  PrefixSum<float, DirectionMoments::kChannels> sum(prefix);
  Pixel<float, DirectionMoments::kChannels> value;
  for (int k = 0; k < count; ++k) {
    multiply_out(directions[k], least_weight, value);
    sum.add(value);
    sum.write();
  }
}

AUGICP_VECTORIZED Span around(const Span* spans, int count) {
  constexpr std::uint16_t kNowhere = 0xffff;  // the begin of an empty span
  std::uint16_t begin = kNowhere, end = 0;
  for (int k = 0; k < count; ++k) {
    const std::uint16_t first = spans[k].end == 0 ? kNowhere : spans[k].begin;
    begin = first < begin ? first : begin;
    end = spans[k].end > end ? spans[k].end : end;
  }
  return end == 0 ? Span{} : Span{begin, end};
}

AUGICP_VECTORIZED void add_row(const double* prefix, const Span* spans, int count, double* sums, PointMoments) {
  add_row_to<PointMoments>(prefix, spans, count, sums);
}
AUGICP_VECTORIZED void add_row(const float* prefix, const Span* spans, int count, float* sums, DirectionMoments) {
  add_row_to<DirectionMoments>(prefix, spans, count, sums);
}

AUGICP_VECTORIZED void look_into_windows(const double* prefix, const Span* spans, WindowBatch& windows, PointMoments) {
  look_into<PointMoments>(prefix, spans, windows);
}
AUGICP_VECTORIZED void look_into_windows(const float* prefix, const Span* spans, WindowBatch& windows,
                                         DirectionMoments) {
  look_into<DirectionMoments>(prefix, spans, windows);
  SymmetricBatch& m = windows.matrix;
  for (int k = 0; k < kBatch; ++k) {
    const float inverse = windows.weight[k] > 0.0f ? 1.0f / windows.weight[k] : 0.0f;
    m.xx[k] *= inverse, m.xy[k] *= inverse, m.xz[k] *= inverse;
    m.yy[k] *= inverse, m.yz[k] *= inverse, m.zz[k] *= inverse;
  }
}

}  // namespace augicp
