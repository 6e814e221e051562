// SPDX-License-Identifier: MIT
#include "benchmarks/stages/limits.h"

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

#include "augicp/core/vectorized.h"

namespace augicp::bench {
namespace {

constexpr int kRepetitions = 20;
constexpr std::size_t kArray = std::size_t{16} << 20;  // floats: 64 MB

// In processor time: what else the machine does should not count.
template <typename Work>
double shortest_s(const Work& work) {
  double shortest = 1e9;
  for (int k = 0; k < kRepetitions; ++k) {
    const std::clock_t start = std::clock();
    work();
    shortest = std::min(shortest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return shortest;
}

AUGICP_VECTORIZED void add(const float* __restrict b, const float* __restrict c, std::size_t count,
                           float* __restrict a) {
  for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + c[i];
}

// As many independent chains as hide the latency of an addition after a multiplication.
constexpr int kChains = 96;
constexpr int kSteps = 1 << 18;

AUGICP_VECTORIZED float multiply_and_add(float start) {
  float x[kChains];
  for (int c = 0; c < kChains; ++c) x[c] = start + static_cast<float>(c);
  for (int k = 0; k < kSteps; ++k)
    for (int c = 0; c < kChains; ++c) x[c] = x[c] * 0.999f + 0.5f;
  float sum = 0.0f;
  for (int c = 0; c < kChains; ++c) sum += x[c];
  return sum;
}

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("avx2,fma")]] float fused(float start) {
  float x[kChains];
  for (int c = 0; c < kChains; ++c) x[c] = start + static_cast<float>(c);
  for (int k = 0; k < kSteps; ++k)
    for (int c = 0; c < kChains; ++c) x[c] = __builtin_fmaf(x[c], 0.999f, 0.5f);
  float sum = 0.0f;
  for (int c = 0; c < kChains; ++c) sum += x[c];
  return sum;
}
#endif

volatile float sink = 0.0f;

}  // namespace

Limits measure_limits() {
  std::vector<float> a(kArray), b(kArray, 1.0f), c(kArray, 2.0f);
  Limits limits;
  limits.bytes_per_s = 3.0 * sizeof(float) * kArray / shortest_s([&] { add(b.data(), c.data(), kArray, a.data()); });
  limits.floats_per_s = 2.0 * kChains * kSteps / shortest_s([] { sink = multiply_and_add(sink); });
  return limits;
}

double fused_floats_per_s() {
#if defined(__x86_64__) && defined(__GNUC__)
  if (__builtin_cpu_supports("fma")) return 2.0 * kChains * kSteps / shortest_s([] { sink = fused(sink); });
#endif
  return 0.0;
}

}  // namespace augicp::bench
