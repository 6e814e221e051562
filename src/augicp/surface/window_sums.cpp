// SPDX-License-Identifier: MIT
#include "augicp/surface/window_sums.h"

#include <cstring>

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

// Inlined into functions that are compiled for several instruction sets, so that it is compiled for each of them too.
#define AUGICP_INLINE [[gnu::always_inline]] inline

// So many bytes at a time, as compilers do not by themselves; where a machine has no such vectors they make several of them.
// Arrays need no alignment, and vectors are never passed by value.
template <typename Number, int kBytes>
struct Vectors {
  using Vector [[gnu::vector_size(kBytes)]] = Number;
  static constexpr int kLanes = kBytes / static_cast<int>(sizeof(Number));
};
template <typename Number>
using Wide = Vectors<Number, 32>;

template <typename Vector, typename Number>
AUGICP_INLINE void load(const Number* from, Vector& vector) {
  std::memcpy(&vector, from, sizeof vector);
}
template <typename Vector, typename Number>
AUGICP_INLINE void store(const Vector& vector, Number* to) {
  std::memcpy(to, &vector, sizeof vector);
}

// The channels of a pixel: wide vectors, and one of half the size for what is left (none of 8 floats, two of 10 doubles).
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

template <int kChannels, typename Number>
AUGICP_INLINE void accumulate_channels(const Number* values, int count, Number* prefix) {
  Pixel<Number, kChannels> sum, value;
  sum.read(prefix);
  for (int k = 0; k < count; ++k) {
    value.read(values + k * kChannels);
    sum.add(value);
    sum.write(prefix + (k + 1) * kChannels);
  }
}

template <int kChannels, typename Number>
AUGICP_INLINE void row_differences(const Number* prefix, const Span* spans, int count, Number* sums) {
  Pixel<Number, kChannels> end, begin;
  for (int k = 0; k < count; ++k) {
    end.read(prefix + spans[k].end * kChannels);
    begin.read(prefix + spans[k].begin * kChannels);
    end.subtract(begin);
    end.write(sums + k * kChannels);
  }
}

// Rows become columns: the first vector gets what comes first in each.
AUGICP_INLINE void transpose(Vectors<double, 16>::Vector (&rows)[2]) {
  const auto first = __builtin_shufflevector(rows[0], rows[1], 0, 2);
  rows[1] = __builtin_shufflevector(rows[0], rows[1], 1, 3);
  rows[0] = first;
}
AUGICP_INLINE void transpose(Wide<double>::Vector (&rows)[4]) {
  const auto even01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6),
             odd01 = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7),
             even23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6),
             odd23 = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
  rows[0] = __builtin_shufflevector(even01, even23, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
  rows[2] = __builtin_shufflevector(even01, even23, 2, 3, 6, 7);
  rows[3] = __builtin_shufflevector(odd01, odd23, 2, 3, 6, 7);
}
// In three steps: columns of two rows, of four, of all.
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

// Of kLanes pixels from k on, kLanes channels from c on.
template <int kBytes, typename Moments, typename Number = typename Moments::Number>
AUGICP_INLINE void block_differences(const Number* prefix, const Span* spans, int k, int c, SumBatch<Moments>& sums) {
  constexpr int kLanes = Vectors<Number, kBytes>::kLanes, kChannels = Moments::kChannels;
  typename Vectors<Number, kBytes>::Vector rows[kLanes], before;
  for (int lane = 0; lane < kLanes; ++lane) {
    const Number* const pixel = prefix + (k + lane) * kChannels + c;
    load(pixel + spans[k + lane].end * (kBatch * kChannels), rows[lane]);
    load(pixel + spans[k + lane].begin * (kBatch * kChannels), before);
    rows[lane] -= before;
  }
  transpose(rows);
  for (int channel = 0; channel < kLanes; ++channel) store(rows[channel], &sums.channel[c + channel][k]);
}

template <typename Moments, typename Number = typename Moments::Number>
AUGICP_INLINE void column_differences(const Number* prefix, const Span* spans, SumBatch<Moments>& sums) {
  using Pixel = Pixel<Number, Moments::kChannels>;
  constexpr int kWide = Pixel::kNumWide * Pixel::kLanes;
  for (int k = 0; k < kBatch; k += Pixel::kLanes)
    for (int c = 0; c < kWide; c += Pixel::kLanes) block_differences<32>(prefix, spans, k, c, sums);
  if constexpr (Pixel::kRest > 0)
    for (int k = 0; k < kBatch; k += Pixel::kRest) block_differences<16>(prefix, spans, k, kWide, sums);
}

template <typename Number>
AUGICP_INLINE void add_numbers(const Number* __restrict numbers, int count, Number* __restrict sum) {
  for (int k = 0; k < count; ++k) sum[k] += numbers[k];
}

}  // namespace

AUGICP_VECTORIZED void accumulate(const double* values, int count, double* prefix, PointMoments) {
  accumulate_channels<PointMoments::kChannels>(values, count, prefix);
}
AUGICP_VECTORIZED void accumulate(const float* values, int count, float* prefix, DirectionMoments) {
  accumulate_channels<DirectionMoments::kChannels>(values, count, prefix);
}

AUGICP_VECTORIZED void add(const double* numbers, int count, double* sum) { add_numbers(numbers, count, sum); }
AUGICP_VECTORIZED void add(const float* numbers, int count, float* sum) { add_numbers(numbers, count, sum); }

AUGICP_VECTORIZED void differences(const double* prefix, const Span* spans, int count, double* sums, PointMoments) {
  row_differences<PointMoments::kChannels>(prefix, spans, count, sums);
}
AUGICP_VECTORIZED void differences(const float* prefix, const Span* spans, int count, float* sums, DirectionMoments) {
  row_differences<DirectionMoments::kChannels>(prefix, spans, count, sums);
}
AUGICP_VECTORIZED void differences(const double* prefix, const Span* spans, SumBatch<PointMoments>& sums) {
  column_differences(prefix, spans, sums);
}
AUGICP_VECTORIZED void differences(const float* prefix, const Span* spans, SumBatch<DirectionMoments>& sums) {
  column_differences(prefix, spans, sums);
}

}  // namespace augicp
