// SPDX-License-Identifier: MIT
#include "augicp/testing/plain_objective.h"

#include <cmath>

namespace augicp::testing {
namespace {

double sign_for(const Cloud& source, const Cloud& target, Structure structure, double cosine) {
  const bool opposites_differ = structure == Structure::Planar && source.viewpoint && target.viewpoint;
  return opposites_differ || cosine >= 0.0 ? 1.0 : -1.0;
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
  PlainPair plain{Vec6d::Zero(), Mat6d::Zero()};
  plain.error.head<3>() = target.points[i].cast<double>() - target_from_source * source.points[j].cast<double>();
  const bool has_direction = target.has_directions() && target.structures[i] != Structure::None;
  const Structure structure = has_direction ? target.structures[i] : Structure::None;
  const Vec3d direction = has_direction ? Vec3d(target.directions[i].cast<double>()) : Vec3d(Vec3d::Zero());
  plain.information.topLeftCorner<3, 3>() = information_matrix(model.of(structure).position, direction);
  if (has_direction && source.has_directions() && source.structures[j] == structure) {
    const Vec3d turned = target_from_source.rotation * source.directions[j].cast<double>();
    plain.error.tail<3>() = direction - sign_for(source, target, structure, direction.dot(turned)) * turned;
    plain.information.bottomRightCorner<3, 3>() = information_matrix(model.of(structure).direction, direction);
  }
  if (!target.weights.empty()) plain.information *= static_cast<double>(target.weights[i]);
  return plain;
}

double plain_loss(double chi2, double kernel_chi2) {
  return chi2 < kernel_chi2 ? chi2 : kernel_chi2 + kernel_chi2 * std::log(chi2 / kernel_chi2);
}

double plain_cost(const PosedPairs& posed, const Objective& objective) {
  double cost = 0.0;
  for (const Correspondence& pair : posed.pairs) {
    const PlainPair plain =
        plain_pair(posed.source, posed.target, pair, posed.target_from_source, objective.information);
    const Vec3d of_position = plain.error.head<3>(), of_direction = plain.error.tail<3>();
    const double direction_loss = plain_loss(
        of_direction.dot(plain.information.bottomRightCorner<3, 3>() * of_direction), objective.kernel_direction_chi2);
    cost += 0.5 * plain_loss(of_position.dot(plain.information.topLeftCorner<3, 3>() * of_position) + direction_loss,
                             objective.kernel_chi2);
  }
  return cost;
}

}  // namespace augicp::testing
