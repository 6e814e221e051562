// SPDX-License-Identifier: MIT
// Reads the data at a list of indices into arrays that compilers vectorise. Neighbouring pixels mostly have
// neighbouring points in memory; such runs of indices are read as blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/correspondence.h"

namespace augicp {

inline constexpr std::size_t kGatheredAtOnce = 64;

// Runs are copied in units of this many entries. The next run overwrites the surplus of a unit; the last run has room
// for it.
inline constexpr std::size_t kGatherUnit = 16;

// One number per entry. Entries behind the last one are unspecified.
template <typename Number>
using Column = Number[kGatheredAtOnce + kGatherUnit];

// At most kGatheredAtOnce indices, cut into runs of consecutive ones.
struct IndexRuns {
  alignas(64) std::uint32_t index[kGatheredAtOnce] = {};
  std::size_t count = 0;
  std::size_t num_runs = 0;
  std::uint8_t begin[kGatheredAtOnce + 1] = {};  // begin of each run, and the end of the last one
};

// Cuts index[0], ..., index[count - 1] into runs. REQUIRES: these are set.
void find_runs(IndexRuns& runs);

// The indices of at most kGatheredAtOnce pairs, cut into runs.
void find_runs(std::span<const Correspondence> pairs, IndexRuns& of_source, IndexRuns& of_target);

// Copies the data at the indices. REQUIRES: every index is below the size of the array.
void gather(std::span<const Vec3f> vectors, const IndexRuns& runs, Column<float> (&columns)[3]);
void gather(std::span<const float> numbers, const IndexRuns& runs, Column<float>& column);
void gather(std::span<const Structure> structures, const IndexRuns& runs, Column<std::int32_t>& column);

}  // namespace augicp
