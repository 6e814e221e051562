// SPDX-License-Identifier: MIT
#include "augicp/trust/free_motions.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

namespace augicp {
namespace {

// A free direction is a pure translation if its rotational share is below this, in the metric of observability.h. Noise
// gives a translation a share of a hundredth; a rotation about an axis three gyration radii away has this share.
constexpr double kMaxTurnOfTranslation = 0.3;

// A rotation with a pitch below this many gyration radii per radian counts as a pure rotation.
constexpr double kMaxPitchOfRotation = 0.1;

using Subspace = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Increments as columns: about the centroid, rotations times the radius of gyration. The directions are orthonormal
// again.
Subspace scaled(Subspace increments, const Observability& observability) {
  for (Eigen::Index k = 0; k < increments.cols(); ++k) {
    const Vec3d turn = increments.col(k).tail<3>();
    increments.col(k).head<3>() += turn.cross(observability.centroid);
    increments.col(k).tail<3>() = observability.gyration * turn;
  }
  return increments;
}

Subspace scaled_free(const Observability& observability, int num_free) {
  return scaled(observability.directions.leftCols(num_free), observability);
}

FreeMotion motion_of(const Vec6d& direction, const Observability& observability) {
  const Vec3d& centroid = observability.centroid;
  const Vec3d translation = direction.head<3>(), turn = direction.tail<3>() / observability.gyration;
  if (direction.tail<3>().norm() < kMaxTurnOfTranslation)
    return {FreeMotion::Kind::Translation, translation.normalized(), centroid, 0.0};
  FreeMotion motion{FreeMotion::Kind::Rotation, turn.normalized(),
                    centroid + turn.cross(translation) / turn.squaredNorm(),
                    turn.dot(translation) / turn.squaredNorm()};
  if (std::abs(motion.pitch) < kMaxPitchOfRotation * observability.gyration)
    motion.pitch = 0.0;
  else
    motion.kind = FreeMotion::Kind::Screw;
  return motion;
}

}  // namespace

std::vector<FreeMotion> free_motions(const Observability& observability, int num_free) {
  if (num_free <= 0 || !(observability.gyration > 0.0)) return {};
  // Any rotation of the basis within the free directions spans the same space. This one puts all rotation into as few
  // directions as possible, so that the others are pure translations.
  const Subspace free = scaled_free(observability, num_free);
  const Eigen::MatrixXd turns = free.bottomRows<3>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(turns, Eigen::ComputeFullV);
  const Subspace basis = free * svd.matrixV();
  std::vector<FreeMotion> motions;
  for (int k = num_free - 1; k >= 0; --k) motions.push_back(motion_of(basis.col(k), observability));
  return motions;
}

double moved_along(const Observability& observability, int num_free, const Vec6d& increment) {
  if (num_free <= 0 || !(observability.gyration > 0.0)) return 0.0;
  const Eigen::VectorXd along =
      scaled_free(observability, num_free).transpose() * scaled(increment, observability).col(0);
  return along.norm() / observability.gyration;
}

}  // namespace augicp
