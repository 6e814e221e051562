// SPDX-License-Identifier: MIT
#include "augicp/experiment/sequence_errors.h"

#include <algorithm>
#include <tuple>

#include "augicp/core/angles.h"

namespace augicp {
namespace {

constexpr PoseError kSuccess{0.05, 2.0 * kRadPerDeg};
constexpr PoseError kNarrowSuccess{0.02, 1.0 * kRadPerDeg};

using Kind = std::tuple<std::size_t, Preset, Method>;
Kind kind_of(const SequenceCurve& curve) { return {curve.gap(), curve.preset, curve.method}; }

std::vector<Kind> kinds_of(std::span<const SequenceCurve> curves) {
  std::vector<Kind> kinds;
  for (const SequenceCurve& curve : curves)
    if (std::find(kinds.begin(), kinds.end(), kind_of(curve)) == kinds.end()) kinds.push_back(kind_of(curve));
  return kinds;
}

// [pair][iteration]
std::vector<std::vector<PoseError>> errors_of(std::span<const SequenceCurve> curves, const Kind& kind,
                                              const Trajectory& truth, double time_offset_s) {
  std::vector<std::vector<PoseError>> errors;
  for (const SequenceCurve& curve : curves) {
    if (kind_of(curve) != kind) continue;
    const auto motion = true_motion(curve, truth, time_offset_s);
    if (!motion) continue;
    errors.emplace_back();
    for (const Rigid3& pose : curve.path) errors.back().push_back(pose_error(pose, *motion));
  }
  return errors;
}

SequenceRow row_of(const std::vector<std::vector<PoseError>>& errors, std::size_t iteration) {
  SequenceRow row;
  row.iteration = static_cast<int>(iteration);
  row.num_pairs = errors.size();
  std::vector<double> translations, rotations;
  std::size_t num_success = 0, num_narrow = 0;
  for (const std::vector<PoseError>& of_pair : errors) {
    const PoseError& error = of_pair[iteration];
    translations.push_back(error.translation);
    rotations.push_back(error.rotation);
    num_success += is_within(error, kSuccess);
    num_narrow += is_within(error, kNarrowSuccess);
  }
  row.translation = spread_of(translations);
  row.rotation = spread_of(rotations);
  row.success = static_cast<double>(num_success) / static_cast<double>(errors.size());
  row.success_narrow = static_cast<double>(num_narrow) / static_cast<double>(errors.size());
  return row;
}

}  // namespace

std::optional<Rigid3> true_motion(const SequenceCurve& curve, const Trajectory& truth, double time_offset_s) {
  const auto target = pose_at(truth, curve.target_stamp_s + time_offset_s, kMaxTruthGap_s);
  const auto source = pose_at(truth, curve.source_stamp_s + time_offset_s, kMaxTruthGap_s);
  if (!target || !source) return std::nullopt;
  return inverse(*target) * *source;
}

std::vector<SequenceRow> summarize(std::span<const SequenceCurve> curves, const Trajectory& truth,
                                   double time_offset_s) {
  std::vector<SequenceRow> rows;
  for (const Kind& kind : kinds_of(curves)) {
    const auto errors = errors_of(curves, kind, truth, time_offset_s);
    if (errors.empty()) continue;
    for (std::size_t i = 0; i < errors.front().size(); ++i) {
      SequenceRow row = row_of(errors, i);
      row.time_offset_s = time_offset_s;
      std::tie(row.gap, row.preset, row.method) = kind;
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace augicp
