// SPDX-License-Identifier: MIT
#include "augicp/eval/trajectory_error.h"

#include <stdexcept>

namespace augicp {
namespace {

void add(PoseErrors& errors, const Rigid3& truth, const Rigid3& estimate) {
  errors.translation.push_back((inverse(truth) * estimate).translation.norm());
  errors.rotation.push_back(angle_between(truth, estimate));
}

std::vector<Vec3d> positions(std::span<const MatchedPose> poses, Rigid3 MatchedPose::*which) {
  std::vector<Vec3d> positions;
  for (const MatchedPose& pose : poses) positions.push_back((pose.*which).translation);
  return positions;
}

}  // namespace

RigidFit align_to_truth(std::span<const MatchedPose> poses, Alignment alignment) {
  if (poses.empty()) throw std::invalid_argument("alignment: expected poses, found none");
  if (alignment == Alignment::None) return {};
  if (alignment == Alignment::Origin) return {{1.0, poses[0].truth * inverse(poses[0].estimate)}};
  const std::vector<Vec3d> estimate = positions(poses, &MatchedPose::estimate);
  const std::vector<Vec3d> truth = positions(poses, &MatchedPose::truth);
  return alignment == Alignment::Similarity ? fit_similarity(estimate, truth) : fit_rigid(estimate, truth);
}

PoseErrors absolute_errors(std::span<const MatchedPose> poses, const Similarity3& truth_from_estimate) {
  PoseErrors errors;
  for (const MatchedPose& pose : poses) add(errors, pose.truth, truth_from_estimate * pose.estimate);
  return errors;
}

PoseErrors relative_errors(std::span<const MatchedPose> poses, std::span<const PosePair> pairs, double scale) {
  const auto step = [](const Rigid3& world_from_first, const Rigid3& world_from_second) {
    return inverse(world_from_first) * world_from_second;
  };
  PoseErrors errors;
  for (const auto& [i, j] : pairs) {
    Rigid3 estimated = step(poses[i].estimate, poses[j].estimate);
    estimated.translation *= scale;
    add(errors, step(poses[i].truth, poses[j].truth), estimated);
  }
  return errors;
}

}  // namespace augicp
