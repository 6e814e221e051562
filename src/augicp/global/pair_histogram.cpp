// SPDX-License-Identifier: MIT
#include "augicp/global/pair_histogram.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "augicp/core/vectorized.h"
#include "augicp/global/dot.h"
#include "augicp/global/packed_bits.h"

namespace augicp {
namespace {

// Shares a value between the two bins around it: a little noise then changes a histogram a little. place: see place_of.
void add_at(float place, float* histogram) {
  const std::size_t bin = std::min(static_cast<std::size_t>(place), kBins - 2);
  const float share = place - static_cast<float>(bin);
  histogram[bin] += 1.0f - share;
  histogram[bin + 1] += share;
}

// Where a value in [-1, 1] is among the middles of the bins.
AUGICP_INLINE float place_of(float value) {
  const float place = 0.5f * (value + 1.0f) * static_cast<float>(kBins) - 0.5f;
  const float above = place > 0.0f ? place : 0.0f, last = static_cast<float>(kBins - 1);
  return above < last ? above : last;
}

// Grows with the angle of (x, y) from -1 at -pi to 1 at pi, and is cheaper.
AUGICP_INLINE float like_angle(float x, float y) {
  const float sum = std::abs(x) + std::abs(y);
  const float quarter = 0.5f * y / sum;
  const float behind = (y >= 0.0f ? 1.0f : -1.0f) - quarter;
  const float angle = x >= 0.0f ? quarter : behind;
  return sum > 0.0f ? angle : 0.0f;
}

// Points around one side by side: their offsets from it, and their normals. Filled up with zeros.
struct Batch {
  static constexpr std::size_t kSize = 32;
  alignas(64) float x[kSize], y[kSize], z[kSize], nx[kSize], ny[kSize], nz[kSize];

  Batch(const Vec3f& from, const ExtendedPoints& support, std::span<const std::uint32_t> around) {
    for (std::size_t k = 0; k < kSize; ++k) {
      const bool is_there = k < around.size();
      const Vec3f offset = is_there ? Vec3f(support.points[around[k]] - from) : Vec3f(Vec3f::Zero());
      const Vec3f normal = is_there ? support.normals[around[k]] : Vec3f(Vec3f::Zero());
      x[k] = offset.x(), y[k] = offset.y(), z[k] = offset.z();
      nx[k] = normal.x(), ny[k] = normal.y(), nz[k] = normal.z();
    }
  }
};

// What a point and those of a batch have in common. Where is_pair is 0, the rest means nothing: a point in the same
// place, or without a normal.
struct Pairs {
  alignas(64) std::int32_t is_pair[Batch::kSize];
  alignas(64) std::int32_t turns[Batch::kSize];  // the other's normal is on the other side, see are_on_same_side()
  alignas(64) float distance[Batch::kSize];
};

AUGICP_INLINE void compare(const Vec3f& u, const Batch& batch, bool has_signs, Pairs& pairs) {
  const float ux = u.x(), uy = u.y(), uz = u.z();
  const std::int32_t may_turn = number(!has_signs);
  for (std::size_t k = 0; k < Batch::kSize; ++k) {
    const float x = batch.x[k], y = batch.y[k], z = batch.z[k];
    const float nx = batch.nx[k], ny = batch.ny[k], nz = batch.nz[k];
    const float length_sq = dot(x, y, z, x, y, z);
    const float along = dot(ux, uy, uz, x, y, z), other_along = dot(nx, ny, nz, x, y, z);
    const float cosine = dot(ux, uy, uz, nx, ny, nz);
    pairs.distance[k] = std::sqrt(length_sq);
    pairs.turns[k] = may_turn & number(!(cosine * length_sq >= 2.0f * along * other_along));
    pairs.is_pair[k] =
        number(pairs.distance[k] > 0.0f) & (number(nx != 0.0f) | number(ny != 0.0f) | number(nz != 0.0f));
  }
}

// Places in the three histograms.
struct Places {
  alignas(64) float alpha[Batch::kSize], phi[Batch::kSize], theta[Batch::kSize];
};

AUGICP_VECTORIZED
void find_places(const Vec3f& u, const Batch& batch, bool has_signs, Pairs& pairs, Places& places) {
  compare(u, batch, has_signs, pairs);
  const float ux = u.x(), uy = u.y(), uz = u.z();
  for (std::size_t k = 0; k < Batch::kSize; ++k) {
    const float sign = pairs.turns[k] != 0 ? -1.0f : 1.0f, distance = pairs.distance[k];
    const float nx = sign * batch.nx[k], ny = sign * batch.ny[k], nz = sign * batch.nz[k];
    const float tx = batch.x[k] / distance, ty = batch.y[k] / distance, tz = batch.z[k] / distance;
    const float ax = ty * uz - tz * uy, ay = tz * ux - tx * uz, az = tx * uy - ty * ux;
    const float length = std::sqrt(dot(ax, ay, az, ax, ay, az));
    const float vx = ax / length, vy = ay / length, vz = az / length;
    const float wx = uy * vz - uz * vy, wy = uz * vx - ux * vz, wz = ux * vy - uy * vx;
    places.alpha[k] = place_of(dot(vx, vy, vz, nx, ny, nz));
    places.phi[k] = place_of(dot(ux, uy, uz, tx, ty, tz));
    places.theta[k] = place_of(like_angle(dot(ux, uy, uz, nx, ny, nz), dot(wx, wy, wz, nx, ny, nz)));
    // A point on the first one's normal has no frame.
    pairs.is_pair[k] &= number(!(length < 1e-3f));
  }
}

AUGICP_VECTORIZED
void compare_all(const Vec3f& u, const Batch& batch, bool has_signs, Pairs& pairs) {
  compare(u, batch, has_signs, pairs);
}

// sum[b] += weight * row[b] for one row after the other.
AUGICP_VECTORIZED
void add_weighted(const float* const* rows, const float* weights, std::size_t count, float* sum) {
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t b = 0; b < kBins * kHistograms; ++b) sum[b] += weights[k] * rows[k][b];
}

float count_of(const PairHistogram& histogram) {
  float count = 0.0f;
  for (std::size_t b = 0; b < kBins; ++b) count += histogram.bins[b];
  return count;
}

}  // namespace

PairHistogram& PairHistogram::operator+=(const PairHistogram& other) {
  for (std::size_t b = 0; b < bins.size(); ++b) bins[b] += other.bins[b];
  return *this;
}

float PairHistogram::bend() const {
  const float count = count_of(*this);
  if (!(count > 0.0f)) return 0.0f;
  float sum = 0.0f;
  for (std::size_t b = 0; b < kBins; ++b)
    sum += (static_cast<float>(b) - static_cast<float>(kBins / 2)) * bins[kBins + b];
  return sum / count;
}

void PairHistogram::write_roots(float* roots) const {
  const float count = count_of(*this);
  for (std::size_t b = 0; b < bins.size(); ++b) roots[b] = count > 0.0f ? std::sqrt(bins[b] / count) : 0.0f;
}

PairHistogram opposite(const PairHistogram& histogram) {
  PairHistogram turned = histogram;
  for (std::size_t k = 1; k < kHistograms; ++k)
    std::reverse(turned.bins.begin() + static_cast<std::ptrdiff_t>(k * kBins),
                 turned.bins.begin() + static_cast<std::ptrdiff_t>((k + 1) * kBins));
  return turned;
}

bool are_on_same_side(const ExtendedPoint& first, const ExtendedPoint& second) {
  const Vec3f offset = second.point - first.point;
  const float length_sq = offset.squaredNorm();
  const float along = first.normal.dot(offset), other_along = second.normal.dot(offset);
  return first.normal.dot(second.normal) * length_sq >= 2.0f * along * other_along;
}

SidedHistograms::SidedHistograms(std::vector<PairHistogram> histograms) : same(std::move(histograms)) {
  other.reserve(same.size());
  for (const PairHistogram& one : same) other.push_back(opposite(one));
}

PairHistogram pair_histogram(const ExtendedPoint& first, const ExtendedPoints& support,
                             std::span<const std::uint32_t> around, bool has_signs) {
  PairHistogram histogram;
  if (first.normal.isZero()) return histogram;
  float* bins = histogram.bins.data();
  for (std::size_t begin = 0; begin < around.size(); begin += Batch::kSize) {
    const std::size_t count = std::min(Batch::kSize, around.size() - begin);
    Pairs pairs;
    Places places;
    find_places(first.normal, {first.point, support, around.subspan(begin, count)}, has_signs, pairs, places);
    for (std::size_t k = 0; k < count; ++k) {
      if (pairs.is_pair[k] == 0) continue;
      add_at(places.alpha[k], bins);
      add_at(places.phi[k], bins + kBins);
      add_at(places.theta[k], bins + 2 * kBins);
    }
  }
  const float count = count_of(histogram);
  for (float& bin : histogram.bins) bin /= std::max(1.0f, count);
  return histogram;
}

PairHistogram mean_around(const ExtendedPoint& first, const ExtendedPoints& support, const SidedHistograms& theirs,
                          std::span<const std::uint32_t> around, bool has_signs) {
  PairHistogram mean;
  float sum = 0.0f;
  for (std::size_t begin = 0; begin < around.size(); begin += Batch::kSize) {
    const auto of_batch = around.subspan(begin, std::min(Batch::kSize, around.size() - begin));
    Pairs pairs;
    compare_all(first.normal, {first.point, support, of_batch}, has_signs, pairs);
    const float* rows[Batch::kSize];
    float weights[Batch::kSize];
    std::size_t count = 0;
    for (std::size_t k = 0; k < of_batch.size(); ++k) {
      if (pairs.is_pair[k] == 0) continue;
      rows[count] = (pairs.turns[k] != 0 ? theirs.other : theirs.same)[of_batch[k]].bins.data();
      weights[count] = 1.0f / pairs.distance[k];
      sum += weights[count++];
    }
    add_weighted(rows, weights, count, mean.bins.data());
  }
  for (float& bin : mean.bins) bin /= std::max(sum, 1e-30f);
  return mean;
}

}  // namespace augicp
