// SPDX-License-Identifier: MIT
#include "augicp/registration/start/hypotheses.h"

#include <algorithm>
#include <array>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

constexpr double kCostOfConflict = 6.0;
constexpr double kCostOfMismatch = 3.0;

}  // namespace

double plausibility(const Agreement& agreement) {
  if (agreement.total() == 0) return 0.0;
  const double against = kCostOfConflict * static_cast<double>(agreement.conflict) +
                         kCostOfMismatch * static_cast<double>(agreement.hidden + agreement.differ);
  return (static_cast<double>(agreement.agree) - against) / static_cast<double>(agreement.total());
}

std::vector<Rigid3> turned(const Rigid3& guess, const Vec3d& place_in_target, const std::vector<double>& angles_rad) {
  constexpr std::array<std::array<int, 3>, 7> kHalfOfAxes{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}};
  std::vector<Rigid3> guesses{guess};
  for (const double angle_rad : angles_rad)
    for (const auto& [x, y, z] : kHalfOfAxes)
      for (const double sign : {1.0, -1.0}) {
        const Eigen::Quaterniond turn = rotation_exp(sign * angle_rad * Vec3d(x, y, z).normalized());
        guesses.push_back(Rigid3{turn, place_in_target - turn * place_in_target} * guess);
      }
  return guesses;
}

std::vector<Hypothesis> best_of(std::vector<Hypothesis> hypotheses, std::size_t max_count, double min_distance,
                                double min_angle_rad) {
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.plausibility > b.plausibility; });
  std::vector<Hypothesis> best;
  for (const Hypothesis& candidate : hypotheses) {
    if (best.size() == max_count) break;
    const bool is_known = std::any_of(best.begin(), best.end(), [&](const Hypothesis& other) {
      const Rigid3 &a = candidate.target_from_source, &b = other.target_from_source;
      return (a.translation - b.translation).norm() < min_distance && angle_between(a, b) < min_angle_rad;
    });
    if (!is_known) best.push_back(candidate);
  }
  return best;
}

}  // namespace augicp
