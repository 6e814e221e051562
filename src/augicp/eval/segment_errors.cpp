// SPDX-License-Identifier: MIT
#include "augicp/eval/segment_errors.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "augicp/core/check.h"

namespace augicp {
namespace {

std::vector<double> path_lengths(std::span<const Rigid3> poses) {
  std::vector<double> lengths(poses.size(), 0.0);
  for (std::size_t i = 1; i < poses.size(); ++i)
    lengths[i] = lengths[i - 1] + (poses[i].translation - poses[i - 1].translation).norm();
  return lengths;
}

Rigid3 motion(std::span<const Rigid3> poses, std::size_t first, std::size_t second) {
  return inverse(poses[first]) * poses[second];
}

SegmentError mean_of(double length, std::size_t count, double translation, double rotation) {
  const double each = count == 0 ? 0.0 : 1.0 / static_cast<double>(count);
  return {length, count, translation * each, rotation * each};
}

}  // namespace

void SegmentOptions::check() const {
  for (const double length : lengths) require_positive("segment length", length);
  require(step >= 1, "step", static_cast<double>(step), "must be at least 1");
}

SegmentErrors segment_errors(std::span<const Rigid3> truth, std::span<const Rigid3> estimate,
                             const SegmentOptions& options) {
  options.check();
  if (truth.size() != estimate.size())
    throw std::invalid_argument(std::to_string(estimate.size()) + " estimated poses for " +
                                std::to_string(truth.size()) + " true ones");
  const std::vector<double> path = path_lengths(truth);
  SegmentErrors errors;
  double all_translation = 0.0, all_rotation = 0.0;
  for (const double length : options.lengths) {
    double translation = 0.0, rotation = 0.0;
    std::size_t count = 0;
    for (std::size_t first = 0; first < truth.size(); first += options.step) {
      const auto end = std::upper_bound(path.begin(), path.end(), path[first] + length);
      if (end == path.end()) break;
      const auto last = static_cast<std::size_t>(end - path.begin());
      const Rigid3 error = inverse(motion(estimate, first, last)) * motion(truth, first, last);
      translation += error.translation.norm() / length;
      rotation += angle_between(error, Rigid3{}) / length;
      ++count;
    }
    if (count == 0) continue;
    errors.of_length.push_back(mean_of(length, count, translation, rotation));
    errors.all.num_segments += count;
    all_translation += translation;
    all_rotation += rotation;
  }
  errors.all = mean_of(0.0, errors.all.num_segments, all_translation, all_rotation);
  return errors;
}

}  // namespace augicp
