// SPDX-License-Identifier: MIT
#include "augicp/trust/contradiction.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "augicp/core/angles.h"
#include "augicp/search/kd_tree.h"

namespace augicp {
namespace {

// Neighbours that a part goes on to, and is bordered by.
constexpr std::size_t kLinked = 8;

// A smaller part, or one with a shorter border, may be noise.
constexpr std::size_t kFewestInPart = 8, kFewestOnBorder = 3;

// Whether a surface goes on to all sides of a place is seen in this many neighbours: no gap between their directions is
// wider than the angle. Of 24 directions at random one set in a hundred has such a gap. At a border it is 180 degrees,
// and between two scan lines it is wider too.
constexpr std::size_t kAround = 16;
constexpr double kWidestGap = 120.0 * kRadPerDeg;

// Points farther apart than this many balls are neither connected nor a surface.
constexpr double kReachPerRadius = 2.0;

// The least share of a part's border at which the other surface goes on.
constexpr double kMinGoingOn = 0.5;

bool is_off(PointAgreement said) {
  return said == PointAgreement::Differ || said == PointAgreement::Unseen || said == PointAgreement::Conflict;
}

// The two directions in which neighbours are spread most: the surface's, and across an edge those of both its faces.
Eigen::Matrix<double, 3, 2> spread_of(const Cloud& cloud, const std::vector<Neighbour>& neighbours) {
  Vec3d mean = Vec3d::Zero();
  for (const Neighbour& one : neighbours) mean += cloud.points[one.index].cast<double>();
  mean /= static_cast<double>(neighbours.size());
  Mat3d outer = Mat3d::Zero();
  for (const Neighbour& one : neighbours) {
    const Vec3d offset = cloud.points[one.index].cast<double>() - mean;
    outer += offset * offset.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Mat3d>(outer).eigenvectors().rightCols<2>();
}

// The widest angle without a direction, radians.
double widest_gap(std::array<double, kAround> angles) {
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2.0 * std::numbers::pi - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k) widest = std::max(widest, angles[k] - angles[k - 1]);
  return widest;
}

bool goes_on_around(const Vec3f& place, const Cloud& cloud, const KdTree& tree, float reach) {
  const std::vector<Neighbour> neighbours = tree.nearest_k(place, kAround);
  if (neighbours.size() < kAround || neighbours.back().distance_sq > reach * reach) return false;
  const Eigen::Matrix<double, 3, 2> spread = spread_of(cloud, neighbours);
  std::array<double, kAround> angles;
  for (std::size_t k = 0; k < kAround; ++k) {
    const Vec3d offset = (cloud.points[neighbours[k].index] - place).cast<double>();
    const Eigen::Vector2d across = spread.transpose() * offset;
    angles[k] = std::atan2(across.y(), across.x());
  }
  return widest_gap(angles) < kWidestGap;
}

// Indices of the points of a connected part that does not agree, and of those beside it that agree.
struct Part {
  std::vector<std::uint32_t> inside, border;
};

// Finds one part after another.
struct PartFinder {
  const Cloud& cloud;
  const KdTree tree;
  std::span<const PointAgreement> said;
  float reach;
  std::vector<bool> visited;

  Part part_from(std::uint32_t first);
};

Part PartFinder::part_from(std::uint32_t first) {
  Part part{{first}, {}};
  visited[first] = true;
  for (std::size_t k = 0; k < part.inside.size(); ++k)
    for (const Neighbour& next : tree.nearest_k(cloud.points[part.inside[k]], kLinked + 1)) {
      if (next.distance_sq > reach * reach) break;
      if (said[next.index] == PointAgreement::Agree) part.border.push_back(next.index);
      if (!is_off(said[next.index]) || visited[next.index]) continue;
      visited[next.index] = true;
      part.inside.push_back(next.index);
    }
  std::sort(part.border.begin(), part.border.end());
  part.border.erase(std::unique(part.border.begin(), part.border.end()), part.border.end());
  return part;
}

}  // namespace

double contradicting_share(const Cloud& cloud, std::span<const PointAgreement> said, const PosedCloud& other) {
  if (static_cast<std::size_t>(std::count_if(said.begin(), said.end(), is_off)) < kFewestInPart) return 0.0;
  const auto reach = static_cast<float>(kReachPerRadius * other.radius);
  const KdTree other_tree(other.cloud);
  const Rigid3f pose(other.this_from_asked);
  PartFinder finder{cloud, KdTree(cloud), said, reach, std::vector<bool>(cloud.size(), false)};
  std::size_t largest = 0;
  for (std::uint32_t first = 0; first < cloud.size(); ++first) {
    if (finder.visited[first] || !is_off(said[first])) continue;
    const Part part = finder.part_from(first);
    if (part.inside.size() < std::max(kFewestInPart, largest + 1) || part.border.size() < kFewestOnBorder) continue;
    const auto going_on = std::count_if(part.border.begin(), part.border.end(), [&](std::uint32_t i) {
      return goes_on_around(pose * cloud.points[i], other.cloud, other_tree, reach);
    });
    if (static_cast<double>(going_on) >= kMinGoingOn * static_cast<double>(part.border.size()))
      largest = part.inside.size();
  }
  return static_cast<double>(largest) / static_cast<double>(cloud.size());
}

}  // namespace augicp
