// SPDX-License-Identifier: MIT
#include "augicp/global/consistency.h"

#include <array>
#include <bit>
#include <cmath>

#include "augicp/core/parallel.h"
#include "augicp/core/vectorized.h"
#include "augicp/global/packed_bits.h"

namespace augicp {
namespace {

constexpr std::size_t kBits = kBitsPerWord, kRowsPerBlock = kBits;

// A column for each coordinate of the points and normals of one side of the pairs.
struct Columns {
  std::vector<float> x, y, z, nx, ny, nz;

  Columns(const KeyPoints& keys, std::span<const Correspondence> pairs, std::uint32_t Correspondence::*side,
          std::size_t padded) {
    for (std::vector<float>* column : {&x, &y, &z, &nx, &ny, &nz}) column->resize(padded);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Vec3f &point = keys.points[pairs[i].*side], &normal = keys.normals[pairs[i].*side];
      x[i] = point.x(), y[i] = point.y(), z[i] = point.z();
      nx[i] = normal.x(), ny[i] = normal.y(), nz[i] = normal.z();
    }
  }
};

struct View {
  const float *x, *y, *z, *nx, *ny, *nz;
  explicit View(const Columns& of)
      : x(of.x.data()), y(of.y.data()), z(of.z.data()), nx(of.nx.data()), ny(of.ny.data()), nz(of.nz.data()) {}
};

// What a pair of extended points has whatever the frame: their distance, and three cosines.
struct Invariants {
  alignas(64) float distance[kBits], first[kBits], second[kBits], between[kBits];
};

AUGICP_INLINE void invariants(const View& of, std::size_t a, std::size_t begin, Invariants& found) {
  const float ax = of.x[a], ay = of.y[a], az = of.z[a], anx = of.nx[a], any = of.ny[a], anz = of.nz[a];
  for (std::size_t k = 0; k < kBits; ++k) {
    const std::size_t b = begin + k;
    const float dx = of.x[b] - ax, dy = of.y[b] - ay, dz = of.z[b] - az;
    const float distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const float inverse = 1.0f / (distance + 1e-20f);
    found.distance[k] = distance;
    found.first[k] = (anx * dx + any * dy + anz * dz) * inverse;
    found.second[k] = (of.nx[b] * dx + of.ny[b] * dy + of.nz[b] * dz) * inverse;
    found.between[k] = anx * of.nx[b] + any * of.ny[b] + anz * of.nz[b];
  }
}

struct Limits {
  float distance, min_distance, cosine;
};

// The words of row a from first_word on.
AUGICP_VECTORIZED
void consistent_bits(const View& source, const View& target, std::size_t a, std::size_t first_word, std::size_t words,
                     const Limits& limits, std::uint64_t* bits) {
  Invariants s, t;
  alignas(64) std::int32_t is_consistent[kBits];
  for (std::size_t word = first_word; word < words; ++word) {
    invariants(source, a, word * kBits, s);
    invariants(target, a, word * kBits, t);
    for (std::size_t k = 0; k < kBits; ++k)
      is_consistent[k] = number(std::abs(s.distance[k] - t.distance[k]) <= limits.distance) &
                         number(s.distance[k] >= limits.min_distance) & number(t.distance[k] >= limits.min_distance) &
                         number(std::abs(s.first[k] - t.first[k]) <= limits.cosine) &
                         number(std::abs(s.second[k] - t.second[k]) <= limits.cosine) &
                         number(std::abs(s.between[k] - t.between[k]) <= limits.cosine);
    bits[word] = packed_bits(is_consistent);
  }
}

// Bit k of word i becomes bit i of word k: H. S. Warren, "Hacker's Delight", 7-3.
void transpose(std::array<std::uint64_t, kBits>& words) {
  std::uint64_t mask = 0x00000000ffffffffu;
  for (std::size_t width = kBits / 2; width != 0; width /= 2, mask ^= mask << width)
    for (std::size_t k = 0; k < kBits; k = ((k | width) + 1) & ~width) {
      const std::uint64_t swapped = (words[k] >> width ^ words[k | width]) & mask;
      words[k] ^= swapped << width;
      words[k | width] ^= swapped;
    }
}

AUGICP_VECTORIZED
int common_bits(const std::uint64_t* a, const std::uint64_t* b, std::size_t words) {
  std::int64_t count = 0;
  for (std::size_t w = 0; w < words; ++w) count += std::popcount(a[w] & b[w]);
  return static_cast<int>(count);
}

}  // namespace

ConsistencyGraph::ConsistencyGraph(const KeyPoints& source, const KeyPoints& target,
                                   std::span<const Correspondence> pairs, const ConsistencyLimits& limits,
                                   int num_threads)
    : size_(pairs.size()), words_((pairs.size() + kBits - 1) / kBits), bits_(size_ * words_) {
  const Columns of_source(source, pairs, &Correspondence::source, words_ * kBits),
      of_target(target, pairs, &Correspondence::target, words_ * kBits);
  const View from(of_source), to(of_target);
  const Limits within{static_cast<float>(limits.distance), static_cast<float>(limits.min_distance),
                      static_cast<float>(limits.cosine)};
  // The columns beyond the last correspondence are padding.
  const std::size_t in_last = size_ % kBits;
  const std::uint64_t last_word = in_last == 0 ? ~std::uint64_t{0} : (std::uint64_t{1} << in_last) - 1;
  // Consistency is symmetric, also in the last bit: the words above the diagonal, and those below from them.
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a) {
      std::uint64_t* const bits = bits_.data() + a * words_;
      consistent_bits(from, to, a, a / kBits, words_, within, bits);
      bits[words_ - 1] &= last_word;
      bits[a / kBits] &= ~(std::uint64_t{1} << (a % kBits));
    }
  };
  for_each_block(size_, num_threads, fill, kRowsPerBlock);
  const auto mirror = [&](std::size_t begin, std::size_t end) {
    std::array<std::uint64_t, kBits> words;
    for (std::size_t above = 0; above < begin / kBits; ++above) {
      for (std::size_t k = 0; k < kBits; ++k) words[k] = bits_[(above * kBits + k) * words_ + begin / kBits];
      transpose(words);
      for (std::size_t a = begin; a < end; ++a) bits_[a * words_ + above] = words[a - begin];
    }
  };
  for_each_block(size_, num_threads, mirror, kBits);
}

std::vector<std::uint32_t> ConsistencyGraph::consistent_with(std::size_t a) const {
  std::vector<std::uint32_t> others;
  for (std::size_t w = 0; w < words_; ++w) append_set_bits(row(a)[w], w, others);
  return others;
}

int ConsistencyGraph::num_common(std::size_t a, std::size_t b) const { return common_bits(row(a), row(b), words_); }

}  // namespace augicp
