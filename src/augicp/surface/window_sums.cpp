// SPDX-License-Identifier: MIT
#include "augicp/surface/window_sums.h"

#include <cstring>

namespace augicp {
namespace {

// Sixteen bytes at a time, which every machine can: compilers do not find these by themselves. Arrays need no
// alignment.
template <typename Number>
struct Lanes;
template <>
struct Lanes<float> {
  using Vector [[gnu::vector_size(16)]] = float;
  static constexpr int kCount = 4;
};
template <>
struct Lanes<double> {
  using Vector [[gnu::vector_size(16)]] = double;
  static constexpr int kCount = 2;
};

template <typename Number>
typename Lanes<Number>::Vector load(const Number* from) {
  typename Lanes<Number>::Vector vector;
  std::memcpy(&vector, from, sizeof vector);
  return vector;
}
template <typename Vector, typename Number>
void store(const Vector& vector, Number* to) {
  std::memcpy(to, &vector, sizeof vector);
}

template <int kChannels, typename Number>
void accumulate_channels(const Number* values, int count, Number* prefix) {
  constexpr int kLanes = Lanes<Number>::kCount;
  typename Lanes<Number>::Vector sum[kChannels / kLanes];
  for (int c = 0; c < kChannels; c += kLanes) sum[c / kLanes] = load(prefix + c);
  for (int k = 0; k < count; ++k)
    for (int c = 0; c < kChannels; c += kLanes) {
      sum[c / kLanes] += load(values + k * kChannels + c);
      store(sum[c / kLanes], prefix + (k + 1) * kChannels + c);
    }
}

// Pixels of either kind fill their vectors.
template <typename Number>
void add_numbers(const Number* numbers, int count, Number* sum) {
  for (int k = 0; k < count; k += Lanes<Number>::kCount) store(load(numbers + k) + load(sum + k), sum + k);
}

template <int kChannels, typename Number>
void row_differences(const Number* prefix, const Span* spans, int count, Number* sums) {
  constexpr int kLanes = Lanes<Number>::kCount;
  for (int k = 0; k < count; ++k) {
    const Number *const end = prefix + spans[k].end * kChannels, *const begin = prefix + spans[k].begin * kChannels;
    for (int c = 0; c < kChannels; c += kLanes) store(load(end + c) - load(begin + c), sums + k * kChannels + c);
  }
}

// Rows become columns.
void store_transposed(const Lanes<double>::Vector (&rows)[2], double* to, std::size_t stride) {
  store(__builtin_shufflevector(rows[0], rows[1], 0, 2), to);
  store(__builtin_shufflevector(rows[0], rows[1], 1, 3), to + stride);
}
void store_transposed(const Lanes<float>::Vector (&rows)[4], float* to, std::size_t stride) {
  const auto even01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5),
             even23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5),
             odd01 = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7),
             odd23 = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  store(__builtin_shufflevector(even01, even23, 0, 1, 4, 5), to);
  store(__builtin_shufflevector(even01, even23, 2, 3, 6, 7), to + stride);
  store(__builtin_shufflevector(odd01, odd23, 0, 1, 4, 5), to + 2 * stride);
  store(__builtin_shufflevector(odd01, odd23, 2, 3, 6, 7), to + 3 * stride);
}

template <typename Moments, typename Number = typename Moments::Number>
void column_differences(const Number* prefix, const Span* spans, SumBatch<Moments>& sums) {
  constexpr int kChannels = Moments::kChannels, kLanes = Lanes<Number>::kCount;
  for (int k = 0; k < kBatch; k += kLanes)
    for (int c = 0; c < kChannels; c += kLanes) {
      typename Lanes<Number>::Vector rows[kLanes];
      for (int lane = 0; lane < kLanes; ++lane) {
        const Number* const pixel = prefix + (k + lane) * kChannels + c;
        rows[lane] = load(pixel + spans[k + lane].end * (kBatch * kChannels)) -
                     load(pixel + spans[k + lane].begin * (kBatch * kChannels));
      }
      store_transposed(rows, &sums.channel[c][k], kBatch);
    }
}

}  // namespace

void accumulate(const double* values, int count, double* prefix, PointMoments) {
  accumulate_channels<PointMoments::kChannels>(values, count, prefix);
}
void accumulate(const float* values, int count, float* prefix, DirectionMoments) {
  accumulate_channels<DirectionMoments::kChannels>(values, count, prefix);
}

void add(const double* numbers, int count, double* sum) { add_numbers(numbers, count, sum); }
void add(const float* numbers, int count, float* sum) { add_numbers(numbers, count, sum); }

void differences(const double* prefix, const Span* spans, int count, double* sums, PointMoments) {
  row_differences<PointMoments::kChannels>(prefix, spans, count, sums);
}
void differences(const float* prefix, const Span* spans, int count, float* sums, DirectionMoments) {
  row_differences<DirectionMoments::kChannels>(prefix, spans, count, sums);
}
void differences(const double* prefix, const Span* spans, SumBatch<PointMoments>& sums) {
  column_differences(prefix, spans, sums);
}
void differences(const float* prefix, const Span* spans, SumBatch<DirectionMoments>& sums) {
  column_differences(prefix, spans, sums);
}

}  // namespace augicp
