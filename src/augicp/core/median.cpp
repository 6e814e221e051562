// SPDX-License-Identifier: MIT
#include "augicp/core/median.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace augicp {
namespace {

// The bit patterns of positive floats are in the order of their values. The upper bits distinguish values by an eighth
// of their size. A coarse histogram is cheaper overall, although its middle bin has more values.
constexpr std::uint32_t kSign = 0x80000000u;
constexpr int kLowerBits = 20;

// For fewer values, sorting costs less than the histogram.
constexpr std::size_t kFewValues = 4096;

std::vector<float> values_in(std::span<const float> values, std::uint32_t first_bits, std::uint32_t last_bits) {
  std::vector<float> chosen(values.size());
  std::size_t count = 0;
  for (const float value : values) {  // no branch: it would be unpredictable
    const auto bits = std::bit_cast<std::uint32_t>(value);
    chosen[count] = value;
    count += bits >= first_bits && bits <= last_bits ? 1 : 0;
  }
  chosen.resize(count);
  return chosen;
}

double at_rank(std::vector<float> values, std::size_t rank) {
  return static_cast<double>(value_at_rank(std::move(values), rank));
}

}  // namespace

double median(std::span<const float> values) {
  if (values.size() <= kFewValues) {
    std::vector<float> chosen = values_in(values, 0, kSign - 1);
    const std::size_t rank = chosen.size() / 2;
    return chosen.empty() ? 0.0 : at_rank(std::move(chosen), rank);
  }
  std::vector<std::uint32_t> counts(std::size_t{1} << (32 - kLowerBits));
  for (const float value : values) ++counts[std::bit_cast<std::uint32_t>(value) >> kLowerBits];
  std::size_t num_chosen = 0;
  for (std::uint32_t bin = 0; bin < kSign >> kLowerBits; ++bin) num_chosen += counts[bin];
  if (num_chosen == 0) return 0.0;
  std::size_t rank = num_chosen / 2;
  std::uint32_t bin = 0;
  while (rank >= counts[bin]) rank -= counts[bin++];
  const std::uint32_t first_bits = bin << kLowerBits;
  return at_rank(values_in(values, first_bits, first_bits | ((1u << kLowerBits) - 1)), rank);
}

}  // namespace augicp
