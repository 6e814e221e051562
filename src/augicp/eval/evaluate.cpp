// SPDX-License-Identifier: MIT
#include "augicp/eval/evaluate.h"

namespace augicp {
namespace {

PoseStatistics statistics_of(const PoseErrors& errors) {
  return {augicp::statistics_of(errors.translation), augicp::statistics_of(errors.rotation)};
}

SegmentErrors segment_errors_of(std::span<const MatchedPose> poses, const SegmentOptions& options) {
  std::vector<Rigid3> truth, estimate;
  for (const MatchedPose& pose : poses) truth.push_back(pose.truth), estimate.push_back(pose.estimate);
  return segment_errors(truth, estimate, options);
}

}  // namespace

void EvaluationOptions::check() const {
  association.check();
  delta.check();
  segments.check();
}

Evaluation evaluate(const Trajectory& estimate, const Trajectory& truth, const EvaluationOptions& options) {
  options.check();
  const std::vector<MatchedPose> poses = match_poses(estimate, truth, options.association, options.truth);
  Evaluation evaluation;
  evaluation.options = options;
  evaluation.num_estimate = estimate.size();
  evaluation.num_truth = truth.size();
  evaluation.num_matched = poses.size();
  evaluation.matched_share = static_cast<double>(poses.size()) / static_cast<double>(estimate.size());
  evaluation.coverage = coverage_of(estimate, truth, poses.size(), options.association, options.truth);
  evaluation.first_stamp_s = poses.front().stamp_s;
  evaluation.last_stamp_s = poses.back().stamp_s;
  evaluation.absolute = statistics_of(absolute_errors(poses));
  evaluation.alignment = align_to_truth(poses, options.alignment);
  const Similarity3& truth_from_estimate = evaluation.alignment.target_from_source;
  if (options.alignment != Alignment::None)
    evaluation.aligned = statistics_of(absolute_errors(poses, truth_from_estimate));
  const std::vector<PosePair> pairs = pairs_at_delta(poses, options.delta);
  if (!pairs.empty()) evaluation.relative = statistics_of(relative_errors(poses, pairs, truth_from_estimate.scale));
  evaluation.segments = segment_errors_of(poses, options.segments);
  return evaluation;
}

}  // namespace augicp
