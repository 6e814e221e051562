// SPDX-License-Identifier: MIT
#include "augicp/trust/observability.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// Directions are left out. On an extended surface the positions constrain the same motions, and with a long lever
// directions would make every translation look weak.
InformationModel without_softening(const InformationModel& softened) {
  InformationModel model = positions_only(softened);
  for (StructureInformation* row : {&model.none, &model.planar, &model.edge}) {
    Information& information = row->position;
    if (information.along < information.across) information.along = 0.0;
    if (information.across < information.along) information.across = 0.0;
  }
  return model;
}

// Information weaker than a plane's only keeps a step solvable.
InformationModel planes_alone(InformationModel model) {
  const double of_plane = model.planar.position.along;
  if (of_plane > model.none.position.along) model.none.position = {};
  if (of_plane > model.edge.position.across) model.edge.position = {};
  return model;
}

// Without planes: edges do not constrain motions along themselves.
InformationModel edges_alone(InformationModel model) {
  model.none.position = {};
  model.edge.position.along = 0.0;
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

// The increment about the frame's zero that is (t, r / gyration) about the centroid: a rotation w about c moves the
// zero by -w x c.
Mat6d increment_from_scaled(const Spread& spread) {
  Mat6d m = Mat6d::Identity();
  m.bottomRightCorner<3, 3>() /= spread.gyration;
  m.topRightCorner<3, 3>() = cross_matrix(spread.centroid) / spread.gyration;
  return m;
}

// This many pairs, evenly selected, give the information to a hundredth.
constexpr std::size_t kNumPairsAsked = 8192;

// The constraint of a point on motions by the information of its own surface: J^T Omega, with J for a motion about the
// centroid.
using Hold = Eigen::Matrix<double, 6, 3>;
Hold hold_of(const Information& information, const Vec3d& direction, const Vec3d& place, const Spread& spread) {
  const Mat3d omega = information.across * Mat3d::Identity() +
                      (information.along - information.across) * direction * direction.transpose();
  Hold hold;
  hold << omega, cross_matrix(place - spread.centroid) * omega / spread.gyration;
  return hold;
}

// Directions that differ by more than noise belong to two surfaces, and share no constraint.
double weight_of_angle(double cosine) {
  constexpr double kMaxSineSq = 0.03;  // of ten degrees
  return kMaxSineSq / std::max(kMaxSineSq, 1.0 - cosine * cosine);
}

// J^T Omega J of a pair, but with the J and the half of Omega that each of its two points measures. Their noise is
// independent and cancels in the sum. With the target's alone, noise would constrain the rotations of a sphere as much
// as those of a room.
Mat6d held_by(const PosedPairs& posed, const Correspondence& pair, const InformationModel& model,
              const Spread& spread) {
  const Cloud &source = posed.source, &target = posed.target;
  const Rigid3& pose = posed.target_from_source;
  const Structure structure = target.has_directions() ? target.structures[pair.target] : Structure::None;
  const Structure of_source = source.has_directions() ? source.structures[pair.source] : Structure::None;
  const Information& information = model.of(structure).position;
  const double largest = std::max(information.along, information.across);
  const bool knows_direction = information.along != information.across;
  if (largest == 0.0 || (knows_direction && of_source != structure)) return Mat6d::Zero();
  const Vec3d d = knows_direction ? Vec3d(target.directions[pair.target].cast<double>()) : Vec3d::Zero();
  const Vec3d l =
      knows_direction ? Vec3d(pose.rotation * source.directions[pair.source].cast<double>()) : Vec3d::Zero();
  const Hold of_target = hold_of(information, d, target.points[pair.target].cast<double>(), spread);
  const Hold of_moved = hold_of(information, l, pose * source.points[pair.source].cast<double>(), spread);
  const double weight = knows_direction ? weight_of_angle(d.dot(l)) : 1.0;
  const Mat6d both = weight * of_moved * of_target.transpose() / largest;
  return 0.5 * (both + both.transpose());
}

// The robust weights of the pairs' positions in the objective.
std::vector<double> robust_weights(const PairChi2& chi2, double kernel_chi2) {
  std::vector<double> weights;
  for (const float of_position : chi2.position)
    weights.push_back(std::min(1.0, kernel_chi2 / static_cast<double>(of_position)));
  return weights;
}

Mat6d held_by(const PosedPairs& posed, const InformationModel& model, const std::vector<double>& weights,
              const Spread& spread) {
  Mat6d held = Mat6d::Zero();
  const std::vector<float>& of_points = posed.target.weights;
  for (std::size_t k = 0; k < posed.size(); ++k) {
    const double of_target = of_points.empty() ? 1.0 : static_cast<double>(of_points[posed.pairs[k].target]);
    held += weights[k] * of_target * held_by(posed, posed.pairs[k], model, spread);
  }
  return held;
}

}  // namespace

Observability observability(const PosedPairs& posed, const Objective& objective) {
  if (posed.pairs.empty()) return {};
  const std::vector<Correspondence> some = evenly_chosen(posed.pairs, kNumPairsAsked);
  const PosedPairs asked = posed.with(some);
  const Spread spread = spread_of(posed.target, some);
  if (!(spread.gyration > 0.0)) return {};
  const Mat6d change = increment_from_scaled(spread);
  const std::vector<double> weights =
      robust_weights(chi2_of_pairs(asked, objective.information, 1), objective.kernel_chi2);
  const auto held_under = [&](const InformationModel& model) { return held_by(asked, model, weights, spread); };
  const InformationModel hard = without_softening(objective.information);
  Mat6d held = held_under(planes_alone(hard));
  if (held.isZero(0.0)) held = held_under(edges_alone(hard));
  if (held.isZero(0.0)) held = held_under(hard);
  if (objective.intensity.information > 0.0)
    held += change.transpose() * shared_intensity_information(asked, objective.intensity, 1) * change;
  const Eigen::SelfAdjointEigenSolver<Mat6d> solver(held);
  const double best = solver.eigenvalues()[5];
  if (!(best > 0.0)) return {};
  return {solver.eigenvalues().cwiseMax(0.0) / best, change * solver.eigenvectors(), spread.centroid, spread.gyration};
}

}  // namespace augicp
