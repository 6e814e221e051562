// SPDX-License-Identifier: MIT
#include "augicp/trust/contradiction.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
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

// What points count that belong to a part which begins at borders of both kinds. Fragments of real rooms, fused from
// images by poses that are centimetres off, have 2.8 % of such points under right poses, mirrored rooms 3.4 % and more.
constexpr double kWeightOfMixed = 0.6;

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

using Indices = std::vector<std::uint32_t>;

// Of each point off the other's surface: neighbours that are off it too, and those that agree, the border.
struct Links {
  std::vector<Indices> off, border;
};

Links links_of(const Cloud& cloud, std::span<const PointAgreement> said, float reach) {
  const KdTree tree(cloud);
  Links links{std::vector<Indices>(cloud.size()), std::vector<Indices>(cloud.size())};
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (!is_off(said[i])) continue;
    for (const Neighbour& next : tree.nearest_k(cloud.points[i], kLinked + 1)) {
      if (next.distance_sq > reach * reach) break;
      if (said[next.index] == PointAgreement::Agree) links.border[i].push_back(next.index);
      if (!is_off(said[next.index]) || next.index == i) continue;
      links.off[i].push_back(next.index);
      links.off[next.index].push_back(i);
    }
  }
  return links;
}

template <class GoesOn>
bool half_of(const Indices& border, const GoesOn& goes_on) {
  return 2 * static_cast<std::size_t>(std::count_if(border.begin(), border.end(), goes_on)) >= border.size();
}

// The points of the border that are linked to a point or to its neighbours off the surface. May repeat.
Indices border_around(std::uint32_t point, const Links& links) {
  Indices border = links.border[point];
  for (const std::uint32_t next : links.off[point])
    border.insert(border.end(), links.border[next].begin(), links.border[next].end());
  return border;
}

// Whether each point off the surface lies beside a place where the other surface goes on: at least half of the border
// around it does, or around the nearest point, in links, that has a border.
template <class GoesOn>
std::vector<bool> beside_what_goes_on(const Links& links, const GoesOn& goes_on) {
  std::vector<bool> is_beside(links.off.size(), false), is_found(links.off.size(), false);
  Indices found;  // the nearer to the border, the earlier
  for (std::uint32_t i = 0; i < links.border.size(); ++i) {
    if (links.border[i].empty()) continue;
    is_beside[i] = half_of(border_around(i, links), goes_on);
    is_found[i] = true;
    found.push_back(i);
  }
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const std::uint32_t next : links.off[found[k]]) {
      if (is_found[next]) continue;
      is_beside[next] = is_beside[found[k]];
      is_found[next] = true;
      found.push_back(next);
    }
  return is_beside;
}

// The size of the largest connected part of the points that are marked, of those whose border contradicts.
template <class GoesOn>
double largest_part(std::vector<bool> marked, const Links& links, const GoesOn& goes_on) {
  std::size_t largest = kFewestInPart - 1;
  for (std::uint32_t first = 0; first < marked.size(); ++first) {
    if (!marked[first]) continue;
    Indices part{first}, border;
    marked[first] = false;
    for (std::size_t k = 0; k < part.size(); ++k) {
      border.insert(border.end(), links.border[part[k]].begin(), links.border[part[k]].end());
      for (const std::uint32_t next : links.off[part[k]])
        if (marked[next]) marked[next] = false, part.push_back(next);
    }
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    if (part.size() > largest && border.size() >= kFewestOnBorder && half_of(border, goes_on)) largest = part.size();
  }
  return largest < kFewestInPart ? 0.0 : static_cast<double>(largest);
}

}  // namespace

double contradicting_share(const Cloud& cloud, std::span<const PointAgreement> said, const PosedCloud& other) {
  std::vector<bool> are_off(cloud.size());
  std::transform(said.begin(), said.end(), are_off.begin(), is_off);
  if (static_cast<std::size_t>(std::count(are_off.begin(), are_off.end(), true)) < kFewestInPart) return 0.0;
  const auto reach = static_cast<float>(kReachPerRadius * other.radius);
  const KdTree other_tree(other.cloud);
  const Rigid3f pose(other.this_from_asked);
  std::vector<std::optional<bool>> known(cloud.size());
  const auto goes_on = [&](std::uint32_t i) {
    if (!known[i]) known[i] = goes_on_around(pose * cloud.points[i], other.cloud, other_tree, reach);
    return *known[i];
  };
  const Links links = links_of(cloud, said, reach);
  const double mixed = kWeightOfMixed * largest_part(beside_what_goes_on(links, goes_on), links, goes_on);
  return std::max(mixed, largest_part(std::move(are_off), links, goes_on)) / static_cast<double>(cloud.size());
}

}  // namespace augicp
