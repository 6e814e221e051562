// SPDX-License-Identifier: MIT
#include "augicp/align/observability.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// Directions are left out: what they hold the positions of an extended surface hold too, and with a long lever they would
// make every translation look weak.
InformationModel without_softening(const InformationModel& softened) {
  InformationModel model = positions_only(softened);
  for (StructureInformation* row : {&model.none, &model.planar, &model.edge}) {
    Information& information = row->position;
    if (information.along < information.across) information.along = 0.0;
    if (information.across < information.along) information.across = 0.0;
  }
  // Points without structure hold a motion only where all points do (ICP); beside planes they are softening too.
  if (model.planar.position.along > model.none.position.along) model.none.position = {};
  if (model.planar.position.along > model.edge.position.across) model.edge.position = {};
  return model;
}

struct Spread {
  Vec3d centroid = Vec3d::Zero();
  double gyration = 0.0;
};

Spread spread_of(const Cloud& target, std::span<const Correspondence> pairs) {
  Spread spread;
  const auto count = static_cast<double>(pairs.size());
  for (const Correspondence& pair : pairs) spread.centroid += target.points[pair.target].cast<double>() / count;
  double sum_sq = 0.0;
  for (const Correspondence& pair : pairs)
    sum_sq += (target.points[pair.target].cast<double>() - spread.centroid).squaredNorm();
  spread.gyration = std::sqrt(sum_sq / count);
  return spread;
}

// The increment about the frame's zero that is (t, r / gyration) about the centroid: turning about c by w moves the zero
// by -w x c.
Mat6d increment_from_scaled(const Spread& spread) {
  Mat6d m = Mat6d::Identity();
  m.bottomRightCorner<3, 3>() /= spread.gyration;
  m.topRightCorner<3, 3>() = cross_matrix(spread.centroid) / spread.gyration;
  return m;
}

}  // namespace

Observability observability(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                            const Rigid3& target_from_source, const Objective& objective, int num_threads) {
  if (pairs.empty()) return {};
  const Spread spread = spread_of(target, pairs);
  if (!(spread.gyration > 0.0)) return {};
  const Objective hard{without_softening(objective.information), objective.kernel_chi2};
  Mat6d H = linearize(source, target, pairs, target_from_source, hard, num_threads).H;
  if (objective.intensity.information > 0.0)
    H += shared_intensity_information(source, target, pairs, target_from_source, objective.intensity, num_threads);
  const Mat6d change = increment_from_scaled(spread);
  const Eigen::SelfAdjointEigenSolver<Mat6d> solver(change.transpose() * H * change);
  const double best = solver.eigenvalues()[5];
  if (!(best > 0.0)) return {};
  return {solver.eigenvalues().cwiseMax(0.0) / best, change * solver.eigenvectors(), spread.centroid,
          spread.gyration};
}

}  // namespace augicp
