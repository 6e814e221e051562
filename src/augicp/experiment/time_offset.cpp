// SPDX-License-Identifier: MIT
#include "augicp/experiment/time_offset.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "augicp/core/check.h"
#include "augicp/eval/statistics.h"
#include "augicp/experiment/sequence_errors.h"

namespace augicp {
namespace {

// Offsets are multiples of 0.1 ms: first every 2 ms is tried, then each step around the best.
constexpr double kStep_s = 1e-4;
constexpr int kReach = 1000, kCoarse = 20;
constexpr std::size_t kMinPairs = 9;  // three per third

using Curves = std::vector<const SequenceCurve*>;

std::vector<double> disagreements(const Curves& curves, const Trajectory& truth, double offset_s) {
  std::vector<double> angles;
  for (const SequenceCurve* curve : curves)
    angles.push_back(angle_between(curve->path.back(), *true_motion(*curve, truth, offset_s)));
  return angles;
}

double median_disagreement(const Curves& curves, const Trajectory& truth, double offset_s) {
  return quantile(disagreements(curves, truth, offset_s), 0.5);
}

// Mean of the better nine tenths. Some registrations fail; a median would depend on one or two pairs.
double robust_disagreement(const Curves& curves, const Trajectory& truth, double offset_s) {
  std::vector<double> angles = disagreements(curves, truth, offset_s);
  std::sort(angles.begin(), angles.end());
  angles.resize(angles.size() - angles.size() / 10);
  return statistics_of(angles).mean;
}

double best_offset(const Curves& curves, const Trajectory& truth) {
  int best = 0;
  double least = robust_disagreement(curves, truth, 0.0);
  const auto search = [&](int low, int high, int step) {
    for (int k = std::max(low, -kReach); k <= std::min(high, kReach); k += step) {
      const double disagreement = robust_disagreement(curves, truth, k * kStep_s);
      if (disagreement < least) {
        least = disagreement;
        best = k;
      }
    }
  };
  search(-kReach, kReach, kCoarse);
  search(best - kCoarse, best + kCoarse, 1);
  return best * kStep_s;
}

double spread_of_thirds(const Curves& curves, const Trajectory& truth) {
  std::vector<double> offsets;
  for (std::size_t first = 0; first < 3; ++first) {
    Curves third;
    for (std::size_t i = first; i < curves.size(); i += 3) third.push_back(curves[i]);
    offsets.push_back(best_offset(third, truth));
  }
  const auto [least, largest] = std::minmax_element(offsets.begin(), offsets.end());
  return *largest - *least;
}

}  // namespace

SequenceOptions time_offset_options(const SequenceOptions& options) {
  SequenceOptions offset_options;
  offset_options.gaps = {1};
  offset_options.presets = {Preset::Default};
  offset_options.methods = {Method::Augmented};
  offset_options.iterations = 20;
  offset_options.max_targets = 100;
  offset_options.pixel_step = std::max(2, options.pixel_step);
  offset_options.registration.radius = options.registration.radius;
  offset_options.registration.num_threads = options.registration.num_threads;
  return offset_options;
}

TimeOffset find_time_offset(std::span<const SequenceCurve> curves, const Trajectory& truth) {
  Curves usable;
  for (const SequenceCurve& curve : curves)
    if (true_motion(curve, truth, -kReach * kStep_s) && true_motion(curve, truth, 0.0) &&
        true_motion(curve, truth, kReach * kStep_s))
      usable.push_back(&curve);
  require(usable.size() >= kMinPairs, "pairs for the time offset", static_cast<double>(usable.size()),
          "must be at least 9 with a true motion within 0.1 s");
  TimeOffset found;
  found.offset_s = best_offset(usable, truth);
  found.spread_s = spread_of_thirds(usable, truth);
  found.median_rotation = median_disagreement(usable, truth, found.offset_s);
  found.median_rotation_at_0 = median_disagreement(usable, truth, 0.0);
  found.num_pairs = usable.size();
  return found;
}

}  // namespace augicp
