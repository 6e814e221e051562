// SPDX-License-Identifier: MIT
// What a list of indices points to, as arrays of numbers of which compilers make vectors. Pixels side by side mostly
// hold points side by side in memory: such runs are read as blocks, several numbers at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/correspondence.h"

namespace augicp {

inline constexpr std::size_t kGatheredAtOnce = 64;

// Runs are copied in units of so many entries. What a unit holds beyond its run the next run overwrites; behind the
// last one there is room for it.
inline constexpr std::size_t kGatherUnit = 16;

// One number of each entry. Those behind the last entry are numbers of some points or as they were before.
template <typename Number>
using Column = Number[kGatheredAtOnce + kGatherUnit];

// At most kGatheredAtOnce indices, cut into runs of consecutive ones.
struct IndexRuns {
  alignas(64) std::uint32_t index[kGatheredAtOnce] = {};
  std::size_t count = 0;
  std::size_t num_runs = 0;
  std::uint8_t begin[kGatheredAtOnce + 1] = {};  // of each run, and the end of the last
};

// Cuts index[0], ..., index[count - 1], which are set already.
void find_runs(IndexRuns& runs);

// The indices of at most kGatheredAtOnce pairs, cut into runs.
void find_runs(std::span<const Correspondence> pairs, IndexRuns& of_source, IndexRuns& of_target);

// Every index must be below the size of what is read.
void gather(std::span<const Vec3f> vectors, const IndexRuns& runs, Column<float> (&columns)[3]);
void gather(std::span<const float> numbers, const IndexRuns& runs, Column<float>& column);
void gather(std::span<const Structure> structures, const IndexRuns& runs, Column<std::int32_t>& column);

}  // namespace augicp
