// SPDX-License-Identifier: MIT
#include "augicp/eval/coverage.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "augicp/core/median.h"

namespace augicp {
namespace {

// A missing pose doubles the time between two. Cameras wait up to half as long again.
constexpr double kHolePerUsualGap = 1.75;

void count_holes(const Trajectory& estimate, Coverage& coverage) {
  if (estimate.size() < 3) return;
  std::vector<double> gaps_s;
  for (std::size_t i = 1; i < estimate.size(); ++i) gaps_s.push_back(estimate[i].stamp_s - estimate[i - 1].stamp_s);
  const double usual_s = upper_median(gaps_s);
  for (const double gap_s : gaps_s) {
    if (!(gap_s > kHolePerUsualGap * usual_s)) continue;
    ++coverage.num_holes;
    coverage.num_missing += static_cast<std::size_t>(std::round(gap_s / usual_s)) - 1;
    coverage.longest_hole_s = std::max(coverage.longest_hole_s, gap_s);
  }
}

}  // namespace

Coverage coverage_of(const Trajectory& estimate, const Trajectory& truth, std::size_t num_matched,
                     const AssociationOptions& options, TruthReading reading) {
  Coverage coverage;
  if (truth.empty()) return coverage;
  const double tolerance_s = reading == TruthReading::Nearest ? options.max_difference_s : 0.0;
  const double first_s = truth.front().stamp_s - tolerance_s, last_s = truth.back().stamp_s + tolerance_s;
  for (const StampedPose& pose : estimate) {
    const double stamp_s = pose.stamp_s + options.time_offset_s;
    coverage.num_outside += stamp_s < first_s || stamp_s > last_s;
  }
  coverage.num_unmatched = estimate.size() - std::min(estimate.size(), num_matched + coverage.num_outside);
  count_holes(estimate, coverage);
  return coverage;
}

}  // namespace augicp
