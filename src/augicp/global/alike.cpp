// SPDX-License-Identifier: MIT
#include "augicp/global/alike.h"

#include <algorithm>
#include <utility>

#include "augicp/core/parallel.h"
#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

// Queries that share each load of the others' descriptors, and others whose sums stay in registers.
constexpr std::size_t kRows = 4, kColumns = 32, kQueriesPerBlock = 64;

// Descriptors side by side: number k of descriptor j at [k * width + j], padded with zeros to whole columns.
struct SideBySide {
  std::size_t count = 0, width = 0;
  std::vector<float> numbers;

  explicit SideBySide(const std::vector<Descriptor>& descriptors)
      : count(descriptors.size()),
        width((count + kColumns - 1) / kColumns * kColumns),
        numbers(kDescriptorSize * width) {
    for (std::size_t j = 0; j < count; ++j)
      for (std::size_t k = 0; k < kDescriptorSize; ++k) numbers[k * width + j] = descriptors[j][k];
  }
};

// The dot products of kRows descriptors with all others: sums[row * width + j].
AUGICP_VECTORIZED
void dot_products(const Descriptor* rows, const float* numbers, std::size_t width, float* sums) {
  for (std::size_t begin = 0; begin < width; begin += kColumns) {
    float sum[kRows][kColumns] = {};
    for (std::size_t k = 0; k < kDescriptorSize; ++k) {
      const float* column = numbers + k * width + begin;
      for (std::size_t r = 0; r < kRows; ++r)
        for (std::size_t j = 0; j < kColumns; ++j) sum[r][j] += rows[r][k] * column[j];
    }
    for (std::size_t r = 0; r < kRows; ++r)
      for (std::size_t j = 0; j < kColumns; ++j) sums[r * width + begin + j] = sum[r][j];
  }
}

// The indices of the largest values, largest first; of equal ones the lower index.
std::vector<std::uint32_t> largest(std::span<const float> values, std::size_t count) {
  std::vector<std::pair<float, std::uint32_t>> best;
  for (std::uint32_t j = 0; j < values.size(); ++j) {
    if (best.size() == count && values[j] <= best.back().first) continue;
    const auto place =
        std::find_if(best.begin(), best.end(), [&](const auto& other) { return values[j] > other.first; });
    best.insert(place, {values[j], j});
    if (best.size() > count) best.pop_back();
  }
  std::vector<std::uint32_t> indices;
  for (const auto& [value, index] : best) indices.push_back(index);
  return indices;
}

std::vector<std::vector<std::uint32_t>> most_alike(const std::vector<Descriptor>& queries, const SideBySide& others,
                                                   std::size_t count, int num_threads) {
  std::vector<std::vector<std::uint32_t>> found(queries.size());
  const auto search = [&](std::size_t begin, std::size_t end) {
    std::vector<float> sums(kRows * others.width);
    for (std::size_t i = begin; i < end; i += kRows) {
      Descriptor rows[kRows] = {};
      const std::size_t num_rows = std::min(kRows, end - i);
      std::copy_n(queries.begin() + static_cast<std::ptrdiff_t>(i), num_rows, rows);
      dot_products(rows, others.numbers.data(), others.width, sums.data());
      for (std::size_t r = 0; r < num_rows; ++r)
        found[i + r] = largest({sums.data() + r * others.width, others.count}, count);
    }
  };
  for_each_block(queries.size(), num_threads, search, kQueriesPerBlock);
  return found;
}

}  // namespace

std::vector<Correspondence> alike_pairs(const KeyPoints& source, const KeyPoints& target, std::size_t count,
                                        int num_threads) {
  const auto of_source = most_alike(source.descriptors, SideBySide(target.descriptors), count, num_threads);
  const auto of_target = most_alike(target.descriptors, SideBySide(source.descriptors), count, num_threads);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < of_source.size(); ++i)
    for (const std::uint32_t j : of_source[i]) pairs.emplace_back(i, j);
  for (std::uint32_t j = 0; j < of_target.size(); ++j)
    for (const std::uint32_t i : of_target[j]) pairs.emplace_back(i, j);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<Correspondence> alike;
  for (const auto& [i, j] : pairs) alike.push_back({i, j});
  return alike;
}

}  // namespace augicp
