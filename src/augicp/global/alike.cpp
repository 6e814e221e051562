// SPDX-License-Identifier: MIT
#include "augicp/global/alike.h"

#include <algorithm>
#include <limits>
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

// The largest number seen at each place, and which row it was of; of equal ones the first row.
struct LargestOf {
  std::vector<float> number;
  std::vector<std::uint32_t> row;

  explicit LargestOf(std::size_t width) : number(width, -std::numeric_limits<float>::infinity()), row(width, 0) {}
};

AUGICP_VECTORIZED
void take_larger(const float* numbers, std::size_t width, std::uint32_t row, float* largest, std::uint32_t* rows) {
  for (std::size_t j = 0; j < width; ++j) {
    const bool is_larger = numbers[j] > largest[j];
    largest[j] = is_larger ? numbers[j] : largest[j];
    rows[j] = is_larger ? row : rows[j];
  }
}

std::uint32_t index_of_largest(std::span<const float> numbers) {
  return static_cast<std::uint32_t>(std::max_element(numbers.begin(), numbers.end()) - numbers.begin());
}

// Each query's most similar other, and each other's most similar query. All queries of a block before the next ones.
struct MostAlike {
  std::vector<std::uint32_t> of_query, of_other;
};
MostAlike most_alike(const std::vector<Descriptor>& queries, const SideBySide& others, int num_threads) {
  const std::size_t num_blocks = (queries.size() + kQueriesPerBlock - 1) / kQueriesPerBlock;
  std::vector<LargestOf> of_block(num_blocks, LargestOf(others.width));
  MostAlike found{std::vector<std::uint32_t>(queries.size()), {}};
  const auto search = [&](std::size_t begin, std::size_t end) {
    LargestOf& of_others = of_block[begin / kQueriesPerBlock];
    std::vector<float> sums(kRows * others.width);
    for (std::size_t i = begin; i < end; i += kRows) {
      Descriptor rows[kRows] = {};
      const std::size_t num_rows = std::min(kRows, end - i);
      std::copy_n(queries.begin() + static_cast<std::ptrdiff_t>(i), num_rows, rows);
      dot_products(rows, others.numbers.data(), others.width, sums.data());
      for (std::size_t r = 0; r < num_rows; ++r) {
        const float* of_row = sums.data() + r * others.width;
        found.of_query[i + r] = index_of_largest({of_row, others.count});
        take_larger(of_row, others.width, static_cast<std::uint32_t>(i + r), of_others.number.data(),
                    of_others.row.data());
      }
    }
  };
  for_each_block(queries.size(), num_threads, search, kQueriesPerBlock);
  LargestOf all(others.width);
  for (const LargestOf& block : of_block)
    for (std::size_t j = 0; j < others.count; ++j)
      if (block.number[j] > all.number[j]) all.number[j] = block.number[j], all.row[j] = block.row[j];
  found.of_other.assign(all.row.begin(), all.row.begin() + static_cast<std::ptrdiff_t>(others.count));
  return found;
}

}  // namespace

std::vector<Correspondence> alike_pairs(const KeyPoints& source, const KeyPoints& target, int num_threads) {
  if (source.size() == 0 || target.size() == 0) return {};
  const MostAlike found = most_alike(source.descriptors, SideBySide(target.descriptors), num_threads);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < source.size(); ++i) pairs.emplace_back(i, found.of_query[i]);
  for (std::uint32_t j = 0; j < target.size(); ++j) pairs.emplace_back(found.of_other[j], j);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<Correspondence> alike;
  for (const auto& [i, j] : pairs) alike.push_back({i, j});
  return alike;
}

}  // namespace augicp
