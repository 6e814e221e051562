// SPDX-License-Identifier: MIT
#include "augicp/registration/start/repeated_turns.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace augicp {
namespace {

constexpr int kNumAngles = 120;                // of 3 degrees
constexpr int kNumHeights = 8, kNumRadii = 8;  // rings about the axis

// The least part of what varies about the axis that is found again, and how far that is beyond chance.
constexpr double kMinFoundAgain = 0.5, kMinDeviations = 4.0;

using Rings = Eigen::Array<double, Eigen::Dynamic, kNumAngles, Eigen::RowMajor>;  // number of points, a ring each row

struct Cylindrical {
  double height, radius, angle;  // angle: 0 to 2 pi
};

std::vector<Cylindrical> about(const Cloud& cloud, const TurningAxis& axis) {
  const Vec3d across = axis.direction.unitOrthogonal(), third = axis.direction.cross(across);
  std::vector<Cylindrical> points;
  points.reserve(cloud.size());
  for (const Vec3f& point : cloud.points) {
    const Vec3d from_axis = point.cast<double>() - axis.place;
    const double x = across.dot(from_axis), y = third.dot(from_axis);
    points.push_back({axis.direction.dot(from_axis), std::hypot(x, y), std::atan2(y, x) + std::numbers::pi});
  }
  return points;
}

// A point counts in the two nearest angles, so that a period need not be a number of them.
void count_point(double angle, Eigen::Ref<Eigen::Array<double, 1, kNumAngles>> ring) {
  const double place = 0.5 * angle / std::numbers::pi * kNumAngles, below = std::floor(place);
  const int at = static_cast<int>(below) % kNumAngles;
  ring(at) += 1.0 - (place - below);
  ring((at + 1) % kNumAngles) += place - below;
}

int bin(double part, int count) { return std::clamp(static_cast<int>(part * count), 0, count - 1); }

Rings rings_of(const std::vector<Cylindrical>& points) {
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(),
                                                     [](const auto& a, const auto& b) { return a.height < b.height; });
  const double widest = std::max_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
                          return a.radius < b.radius;
                        })->radius;
  const double low = lowest->height, tall = std::max(highest->height - low, 1e-12);
  Rings rings = Rings::Zero(kNumHeights * kNumRadii, kNumAngles);
  for (const Cylindrical& point : points) {
    const int ring = bin((point.height - low) / tall, kNumHeights) * kNumRadii +
                     bin(point.radius / std::max(widest, 1e-12), kNumRadii);
    count_point(point.angle, rings.row(ring));
  }
  return rings;
}

// For each turn by whole bins up to half a turn, the sum over bins of the product before and after.
std::vector<double> correlation(const Rings& rings) {
  std::vector<double> of_turn;
  for (int turn = 0; turn <= kNumAngles / 2; ++turn)
    of_turn.push_back((rings.rightCols(kNumAngles - turn) * rings.leftCols(kNumAngles - turn)).sum() +
                      (rings.leftCols(turn) * rings.rightCols(turn)).sum());
  return of_turn;
}

}  // namespace

std::vector<RepeatedTurn> repeated_turns(const Cloud& cloud, const TurningAxis& axis) {
  if (cloud.empty()) return {};
  Rings rings = rings_of(about(cloud, axis));
  const Eigen::ArrayXd mean = rings.rowwise().mean();
  rings.colwise() -= mean;
  const std::vector<double> of_turn = correlation(rings);
  // Random points, each shared by two angles, vary the counts by two thirds of their mean. Evenly spread points vary
  // them less.
  const double varies = std::max(of_turn.front() - kNumAngles * mean.sum() * 2.0 / 3.0, 0.0);
  const double by_chance = std::sqrt(kNumAngles * mean.square().sum());
  std::vector<RepeatedTurn> turns;
  for (int k = 1; k <= kNumAngles / 2; ++k) {
    const double here = of_turn[k], before = of_turn[k - 1], after = of_turn[k < kNumAngles / 2 ? k + 1 : k - 1];
    if (here < before || here < after) continue;
    if (here < kMinFoundAgain * varies || here < kMinDeviations * by_chance) continue;
    turns.push_back({2.0 * std::numbers::pi * k / kNumAngles, here / of_turn.front()});
  }
  std::sort(turns.begin(), turns.end(), [](const RepeatedTurn& a, const RepeatedTurn& b) {
    return a.resemblance != b.resemblance ? a.resemblance > b.resemblance : a.angle < b.angle;
  });
  return turns;
}

}  // namespace augicp
