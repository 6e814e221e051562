// SPDX-License-Identifier: MIT
#include "augicp/global/pair_histogram.h"

#include <algorithm>
#include <cmath>

namespace augicp {
namespace {

// Shares a value in [-1, 1] between the two bins around it: a little noise then changes a histogram a little.
void add_to(float* histogram, float value) {
  const float place =
      std::clamp(0.5f * (value + 1.0f) * static_cast<float>(kBins) - 0.5f, 0.0f, static_cast<float>(kBins - 1));
  const std::size_t bin = std::min(static_cast<std::size_t>(place), kBins - 2);
  const float share = place - static_cast<float>(bin);
  histogram[bin] += 1.0f - share;
  histogram[bin + 1] += share;
}

// Grows with the angle of (x, y) from -1 at -pi to 1 at pi, and is cheaper.
float like_angle(float x, float y) {
  const float sum = std::abs(x) + std::abs(y);
  if (!(sum > 0.0f)) return 0.0f;
  const float quarter = 0.5f * y / sum;
  return x >= 0.0f ? quarter : (y >= 0.0f ? 1.0f - quarter : -1.0f - quarter);
}

void add_pair(const ExtendedPoint& first, const Vec3f& towards, const Vec3f& other_normal, PairHistogram& histogram) {
  const Vec3f& u = first.normal;
  const Vec3f across = towards.cross(u);
  const float length = across.norm();
  if (length < 1e-3f) return;  // the second point is on the first one's normal: no frame
  const Vec3f v = across / length, w = u.cross(v);
  float* bins = histogram.bins.data();
  add_to(bins, v.dot(other_normal));
  add_to(bins + kBins, u.dot(towards));
  add_to(bins + 2 * kBins, like_angle(u.dot(other_normal), w.dot(other_normal)));
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

PairHistogram pair_histogram(const ExtendedPoint& first, const ExtendedPoints& support,
                             std::span<const std::uint32_t> around, bool has_signs) {
  PairHistogram histogram;
  if (first.normal.isZero()) return histogram;
  for (const std::uint32_t j : around) {
    const ExtendedPoint second = support[j];
    const Vec3f offset = second.point - first.point;
    const float distance = offset.norm();
    if (!(distance > 0.0f) || second.normal.isZero()) continue;
    const bool turns = !has_signs && !are_on_same_side(first, second);
    add_pair(first, offset / distance, turns ? Vec3f(-second.normal) : second.normal, histogram);
  }
  const float count = count_of(histogram);
  for (float& bin : histogram.bins) bin /= std::max(1.0f, count);
  return histogram;
}

PairHistogram mean_around(const ExtendedPoint& first, const ExtendedPoints& support,
                          const std::vector<PairHistogram>& theirs, std::span<const std::uint32_t> around,
                          bool has_signs) {
  PairHistogram mean;
  float sum = 0.0f;
  for (const std::uint32_t j : around) {
    const ExtendedPoint second = support[j];
    const float distance = (second.point - first.point).norm();
    if (!(distance > 0.0f) || second.normal.isZero()) continue;
    const float weight = 1.0f / distance;
    sum += weight;
    const bool turns = !has_signs && !are_on_same_side(first, second);
    const PairHistogram& other = turns ? opposite(theirs[j]) : theirs[j];
    for (std::size_t b = 0; b < mean.bins.size(); ++b) mean.bins[b] += weight * other.bins[b];
  }
  for (float& bin : mean.bins) bin /= std::max(sum, 1e-30f);
  return mean;
}

}  // namespace augicp
