// SPDX-License-Identifier: MIT
// Descriptors of points by the pairs of extended points around them: R. B. Rusu, N. Blodow, M. Beetz, "Fast Point
// Feature Histograms (FPFH) for 3D registration", ICRA 2009; of two radii, and for normals without signs.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "augicp/global/key_cloud.h"

namespace augicp {

// Histograms of the three angles of a pair, for a small and for a large ball. Each is scaled to sum one and its square
// root taken, so that the dot product of two descriptors compares them, from 0 to kDescriptorNorm.
inline constexpr std::size_t kBins = 11, kHistograms = 3, kBalls = 2;
inline constexpr std::size_t kDescriptorSize = kBins * kHistograms * kBalls;
inline constexpr float kDescriptorNorm = kHistograms * kBalls;
using Descriptor = std::array<float, kDescriptorSize>;

// The descriptors of some points of a KeyCloud.
struct KeyPoints {
  std::vector<Vec3f> points;
  std::vector<Vec3f> normals;
  std::vector<Descriptor> descriptors;

  std::size_t size() const { return points.size(); }
};

// Of at most max_count points with a normal, those around which the surface varies most; in the order of the cloud.
// Without signs, the normal of each is oriented so that the surface bends away from it, as seen in the descriptor: a
// surface and its mirror image on the other side then have the same descriptor. The result is bit-identical for any
// number of threads.
KeyPoints described(const KeyCloud& cloud, std::size_t max_count, int num_threads);

}  // namespace augicp
