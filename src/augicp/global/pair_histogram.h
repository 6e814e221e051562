// SPDX-License-Identifier: MIT
// The histograms of one point's pairs with the points around it. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/global/descriptors.h"

namespace augicp {

struct ExtendedPoint {
  const Vec3f& point;
  const Vec3f& normal;
};
struct ExtendedPoints {
  const std::vector<Vec3f>& points;
  const std::vector<Vec3f>& normals;
  ExtendedPoint operator[](std::size_t i) const { return {points[i], normals[i]}; }
};

// Three histograms one after the other: of alpha, phi and theta in the frame of the first point's normal.
struct PairHistogram {
  std::array<float, kBins * kHistograms> bins{};

  PairHistogram& operator+=(const PairHistogram& other);

  // The mean of phi, in bins from the middle: below 0 if the surface bends away from the normal. 0 for no pairs.
  float bend() const;

  // Square roots of each histogram scaled to sum one; zeros for no pairs.
  void write_roots(float* roots) const;
};

// With all normals turned around: phi and theta change their signs.
PairHistogram opposite(const PairHistogram& histogram);

// Whether the normal of the second point is on the same side of the surface as the first one's. It is a guess from the
// two points alone, exact on a plane, a sphere and at a crease: the second normal is the mirror image of the first in
// the plane half way between the points.
bool are_on_same_side(const ExtendedPoint& first, const ExtendedPoint& second);

// The histograms of some points, and their opposites.
struct SidedHistograms {
  std::vector<PairHistogram> same, other;

  explicit SidedHistograms(std::vector<PairHistogram> histograms);
};

PairHistogram pair_histogram(const ExtendedPoint& first, const ExtendedPoints& support,
                             std::span<const std::uint32_t> around, bool has_signs);

// The mean of the histograms of the points around, each scaled to one pair, weighted by the inverse of their distance.
PairHistogram mean_around(const ExtendedPoint& first, const ExtendedPoints& support, const SidedHistograms& theirs,
                          std::span<const std::uint32_t> around, bool has_signs);

}  // namespace augicp
