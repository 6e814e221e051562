// SPDX-License-Identifier: MIT
#include "augicp/cloud/gather.h"

#include <algorithm>
#include <cstring>

#include "augicp/core/prefetch.h"
#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

// If runs are shorter on average, reading one by one is faster.
constexpr std::size_t kMinMeanRun = 3;

bool has_long_runs(const IndexRuns& runs) { return kMinMeanRun * runs.num_runs < runs.count; }

// If runs are long, later reads are mostly farther on in memory.
template <typename Entry>
void fetch_ahead(std::span<const Entry> entries, const IndexRuns& runs) {
  constexpr std::size_t kEntriesAhead = 2048;  // takes the time of about thirty calls
  const std::size_t first = runs.index[0] + kEntriesAhead;
  if (first + kGatheredAtOnce <= entries.size()) prefetch(&entries[first], kGatheredAtOnce);
}

// starts[k]: 1 if index[k] does not follow index[k - 1].
AUGICP_VECTORIZED void mark_starts(const std::uint32_t* __restrict index, std::uint8_t* __restrict starts) {
  starts[0] = 1;
  for (std::size_t k = 1; k < kGatheredAtOnce; ++k) starts[k] = index[k] != index[k - 1] + 1 ? 1 : 0;
}

AUGICP_VECTORIZED void split(const Correspondence* __restrict pairs, std::size_t count,
                             std::uint32_t* __restrict source, std::uint32_t* __restrict target) {
  for (std::size_t k = 0; k < count; ++k) source[k] = pairs[k].source, target[k] = pairs[k].target;
}

// Calls copy(first index, destination of the first entry, count) for parts of all runs. Parts are whole units if that
// reads nothing beyond the end of the array, else single entries.
template <typename Copy>
AUGICP_INLINE void for_each_part(const IndexRuns& runs, std::size_t size, const Copy& copy) {
  for (std::size_t r = 0; r < runs.num_runs; ++r) {
    const std::size_t at = runs.begin[r], length = runs.begin[r + 1] - at, first = runs.index[at];
    const std::size_t units = (length + kGatherUnit - 1) / kGatherUnit;
    if (first + units * kGatherUnit <= size)
      copy(first, at, units * kGatherUnit);
    else
      for (std::size_t l = 0; l < length; ++l) copy(first + l, at + l, 1);
  }
}

AUGICP_VECTORIZED void gather_vectors(const float* __restrict xyz, std::size_t size, const IndexRuns& __restrict runs,
                                      float* __restrict x, float* __restrict y, float* __restrict z) {
  for_each_part(runs, size, [&](std::size_t first, std::size_t at, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) {
      x[at + l] = xyz[3 * (first + l)];
      y[at + l] = xyz[3 * (first + l) + 1];
      z[at + l] = xyz[3 * (first + l) + 2];
    }
  });
}

AUGICP_VECTORIZED void gather_numbers(const float* __restrict from, std::size_t size, const IndexRuns& __restrict runs,
                                      float* __restrict to) {
  for_each_part(runs, size, [&](std::size_t first, std::size_t at, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) to[at + l] = from[first + l];
  });
}

AUGICP_VECTORIZED void gather_bytes(const std::uint8_t* __restrict from, std::size_t size,
                                    const IndexRuns& __restrict runs, std::int32_t* __restrict to) {
  for_each_part(runs, size, [&](std::size_t first, std::size_t at, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) to[at + l] = from[first + l];
  });
}

}  // namespace

void find_runs(IndexRuns& runs) {
  std::uint8_t starts[kGatheredAtOnce];
  mark_starts(runs.index, starts);
  runs.num_runs = 0;
  std::uint64_t eight;
  for (std::size_t k = 0; k < runs.count; k += sizeof(eight)) {
    std::memcpy(&eight, starts + k, sizeof(eight));
    if (eight == 0) continue;  // the usual case
    for (std::size_t l = k; l < std::min(k + sizeof(eight), runs.count); ++l) {
      runs.begin[runs.num_runs] = static_cast<std::uint8_t>(l);
      runs.num_runs += starts[l];
    }
  }
  runs.begin[runs.num_runs] = static_cast<std::uint8_t>(runs.count);
}

void find_runs(std::span<const Correspondence> pairs, IndexRuns& of_source, IndexRuns& of_target) {
  split(pairs.data(), pairs.size(), of_source.index, of_target.index);
  of_source.count = of_target.count = pairs.size();
  find_runs(of_source);
  find_runs(of_target);
}

void gather(std::span<const Vec3f> vectors, const IndexRuns& runs, Column<float> (&columns)[3]) {
  if (has_long_runs(runs)) {
    fetch_ahead(vectors, runs);
    return gather_vectors(vectors.data()->data(), vectors.size(), runs, columns[0], columns[1], columns[2]);
  }
  for (std::size_t k = 0; k < runs.count; ++k)
    for (int axis = 0; axis < 3; ++axis) columns[axis][k] = vectors[runs.index[k]][axis];
}

void gather(std::span<const float> numbers, const IndexRuns& runs, Column<float>& column) {
  if (has_long_runs(runs)) {
    fetch_ahead(numbers, runs);
    return gather_numbers(numbers.data(), numbers.size(), runs, column);
  }
  for (std::size_t k = 0; k < runs.count; ++k) column[k] = numbers[runs.index[k]];
}

void gather(std::span<const Structure> structures, const IndexRuns& runs, Column<std::int32_t>& column) {
  static_assert(sizeof(Structure) == 1);
  if (has_long_runs(runs)) {
    fetch_ahead(structures, runs);
    return gather_bytes(reinterpret_cast<const std::uint8_t*>(structures.data()), structures.size(), runs, column);
  }
  for (std::size_t k = 0; k < runs.count; ++k) column[k] = static_cast<std::int32_t>(structures[runs.index[k]]);
}

}  // namespace augicp
