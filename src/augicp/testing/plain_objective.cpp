// SPDX-License-Identifier: MIT
#include "augicp/testing/plain_objective.h"

#include <cmath>

namespace augicp::testing {
namespace {

double sign_for(const Cloud& source, const Cloud& target, Structure structure, double cosine) {
  const bool opposites_differ = structure == Structure::Planar && source.viewpoint && target.viewpoint;
  return opposites_differ || cosine >= 0.0 ? 1.0 : -1.0;
}

// A point's structure, with its direction turned.
struct Extended {
  Structure structure = Structure::None;
  Vec3d direction = Vec3d::Zero();
  double weight = 1.0;
};
Extended extended(const Cloud& cloud, std::uint32_t index, const Eigen::Quaterniond& rotation) {
  Extended point;
  if (!cloud.weights.empty()) point.weight = static_cast<double>(cloud.weights[index]);
  if (!cloud.has_directions() || cloud.structures[index] == Structure::None) return point;
  point.structure = cloud.structures[index];
  point.direction = rotation * cloud.directions[index].cast<double>();
  return point;
}

Mat3d pair_information(const Extended& target, const Extended& source, Information StructureInformation::*part,
                       const InformationModel& model, Sides sides) {
  const auto of = [&](const Extended& point) -> Mat3d {
    return point.weight * information_matrix(model.of(point.structure).*part, point.direction);
  };
  if (sides == Sides::Target || of(target).isZero(0.0)) return of(target);
  return (of(target).inverse() + of(source).inverse()).inverse();
}

}  // namespace

Mat3d information_matrix(const Information& information, const Vec3d& direction) {
  if (direction.isZero()) return information.across * Mat3d::Identity();
  Mat3d frame;  // its columns
  frame.col(0) = direction.normalized();
  frame.col(1) = frame.col(0).unitOrthogonal();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame * Vec3d(information.along, information.across, information.across).asDiagonal() * frame.transpose();
}

PlainPair plain_pair(const Cloud& source, const Cloud& target, const Correspondence& pair,
                     const Rigid3& target_from_source, const InformationModel& model) {
  const auto [j, i] = pair;
  const Extended of_target = extended(target, i, Eigen::Quaterniond::Identity());
  const Extended of_source = extended(source, j, target_from_source.rotation);
  const bool has_both = source.has_directions() && target.has_directions();
  PlainPair plain{Vec6d::Zero(), Mat6d::Zero()};
  const bool by_gaussian = model.position_sides == Sides::TargetGaussian;
  const Vec3f& place = by_gaussian ? target.gaussians[i].mean : target.points[i];
  plain.error.head<3>() = place.cast<double>() - target_from_source * source.points[j].cast<double>();
  plain.information.topLeftCorner<3, 3>() =
      by_gaussian ? of_target.weight * target.gaussians[i].information.cast<double>()
                  : pair_information(of_target, of_source, &StructureInformation::position, model,
                                     has_both ? model.position_sides : Sides::Target);
  if (has_both && of_target.structure != Structure::None && of_source.structure == of_target.structure) {
    const double cosine = of_target.direction.dot(of_source.direction);
    plain.error.tail<3>() =
        of_target.direction - sign_for(source, target, of_target.structure, cosine) * of_source.direction;
    plain.information.bottomRightCorner<3, 3>() =
        pair_information(of_target, of_source, &StructureInformation::direction, model, model.direction_sides);
  }
  return plain;
}

double plain_loss(double chi2, double kernel_chi2) {
  return chi2 < kernel_chi2 ? chi2 : kernel_chi2 + kernel_chi2 * std::log(chi2 / kernel_chi2);
}

double plain_cost(const PosedPairs& posed, const Objective& objective) {
  return plain_cost(posed, objective, posed.target_from_source);
}

double plain_cost(const PosedPairs& posed, const Objective& objective, const Rigid3& pose_of_information) {
  double cost = 0.0;
  for (const Correspondence& pair : posed.pairs) {
    const auto under = [&](const Rigid3& pose) {
      return plain_pair(posed.source, posed.target, pair, pose, objective.information);
    };
    PlainPair plain = under(posed.target_from_source);
    plain.information = under(pose_of_information).information;
    const Vec3d of_position = plain.error.head<3>(), of_direction = plain.error.tail<3>();
    const double direction_loss = plain_loss(
        of_direction.dot(plain.information.bottomRightCorner<3, 3>() * of_direction), objective.kernel_direction_chi2);
    cost += 0.5 * plain_loss(of_position.dot(plain.information.topLeftCorner<3, 3>() * of_position) + direction_loss,
                             objective.kernel_chi2);
  }
  return cost;
}

}  // namespace augicp::testing
