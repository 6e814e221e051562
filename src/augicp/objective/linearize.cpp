// SPDX-License-Identifier: MIT
#include "augicp/objective/linearize.h"

#include <cmath>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// One pair under a pose: the errors of Eq. (8) and what weighs them.
struct PairError {
  Vec3d moved_point;      // T (+) p_j
  Vec3d moved_direction;  // R l_j, its sign chosen
  Vec3d target_direction;
  Vec3d position_error;   // p_i - T (+) p_j
  Vec3d direction_error;  // l_i - R l_j
  Information position, direction;
  bool compares_directions = false;
};

Information scaled(const Information& information, double weight) {
  return {weight * information.along, weight * information.across};
}

// Omega x, without Omega.
Vec3d weigh(const Information& information, const Vec3d& d, const Vec3d& x) {
  return information.across * x + ((information.along - information.across) * d.dot(x)) * d;
}

class PairErrors {
 public:
  PairErrors(const Cloud& source, const Cloud& target, const Rigid3& target_from_source, const InformationModel& information)
      : source_(source),
        target_(target),
        information_(information),
        rotation_(target_from_source.rotation.toRotationMatrix()),
        translation_(target_from_source.translation),
        compares_directions_(source.has_directions() && target.has_directions()),
        signed_normals_(normals_have_signs(source, target)) {}

  PairError of(const Correspondence& pair) const {
    PairError e;
    const double weight = target_.weights.empty() ? 1.0 : static_cast<double>(target_.weights[pair.target]);
    const Structure structure = target_.has_directions() ? target_.structures[pair.target] : Structure::None;
    e.moved_point = rotation_ * source_.points[pair.source].cast<double>() + translation_;
    e.position_error = target_.points[pair.target].cast<double>() - e.moved_point;
    e.position = scaled(information_.of(structure).position, weight);
    e.target_direction = Vec3d::Zero();
    e.moved_direction = e.direction_error = Vec3d::Zero();
    if (structure == Structure::None) return e;
    e.target_direction = target_.directions[pair.target].cast<double>();
    // Where the structures differ the linear error has no meaning: Omega^l = 0.
    if (!compares_directions_ || source_.structures[pair.source] != structure) return e;
    e.compares_directions = true;
    e.direction = scaled(information_.of(structure).direction, weight);
    e.moved_direction = rotation_ * source_.directions[pair.source].cast<double>();
    // Eq. (7), but with the sign chosen first: a tangent and its opposite are the same edge.
    const bool with_sign = structure == Structure::Planar && signed_normals_;
    if (!with_sign && e.moved_direction.dot(e.target_direction) < 0.0) e.moved_direction = -e.moved_direction;
    e.direction_error = e.target_direction - e.moved_direction;
    return e;
  }

 private:
  const Cloud& source_;
  const Cloud& target_;
  const InformationModel& information_;
  Mat3d rotation_;
  Vec3d translation_;
  bool compares_directions_;
  bool signed_normals_;
};

double position_chi2(const PairError& e) {
  return e.position_error.dot(weigh(e.position, e.target_direction, e.position_error));
}
double direction_chi2(const PairError& e) {
  return e.direction_error.dot(weigh(e.direction, e.target_direction, e.direction_error));
}

// The sums behind H and b by their blocks: tt and rr are symmetric.
struct BlockSums {
  Mat3d tt = Mat3d::Zero(), tr = Mat3d::Zero(), rr = Mat3d::Zero();
  Vec3d b_t = Vec3d::Zero(), b_r = Vec3d::Zero();
  double cost = 0.0;

  BlockSums& operator+=(const BlockSums& other) {
    tt += other.tt;
    tr += other.tr;
    rr += other.rr;
    b_t += other.b_t;
    b_r += other.b_r;
    cost += other.cost;
    return *this;
  }

  // Eq. (12) with a rotation vector for the increment, which removes the factor 2 of the quaternion's imaginary part:
  // J = [-I  [q]x; 0  [m]x], q = T (+) p_j, m = R l_j. The position's part of J^T Omega J for Omega = a I + c d d^T is
  // a [I  -[q]x; [q]x  |q|^2 I - q q^T]  +  c v v^T with v = (d, q x d).
  void add_position(const PairError& e, double gamma) {
    const Vec3d& q = e.moved_point;
    const Vec3d q_cross_d = q.cross(e.target_direction);
    const double a = gamma * e.position.across, c = gamma * (e.position.along - e.position.across);
    tt += c * e.target_direction * e.target_direction.transpose();
    tt.diagonal().array() += a;
    tr += c * e.target_direction * q_cross_d.transpose() - a * cross_matrix(q);
    rr += c * q_cross_d * q_cross_d.transpose() - a * q * q.transpose();
    rr.diagonal().array() += a * q.squaredNorm();
    const Vec3d weighted = gamma * weigh(e.position, e.target_direction, e.position_error);
    b_t -= weighted;
    b_r -= q.cross(weighted);
  }

  void add_direction(const PairError& e, double gamma) {
    const Vec3d& m = e.moved_direction;
    const Vec3d m_cross_d = m.cross(e.target_direction);
    const double a = gamma * e.direction.across, c = gamma * (e.direction.along - e.direction.across);
    rr += c * m_cross_d * m_cross_d.transpose() - a * m * m.transpose();
    rr.diagonal().array() += a * m.squaredNorm();
    b_r -= m.cross(gamma * weigh(e.direction, e.target_direction, e.direction_error));
  }
};

// Eq. (13), and the loss that has it as its derivative.
struct Robust {
  double gamma;
  double loss;
};
Robust robust(double chi2, double kernel_chi2) {
  if (chi2 < kernel_chi2) return {1.0, chi2};
  return {kernel_chi2 / chi2, kernel_chi2 * (1.0 + std::log(chi2 / kernel_chi2))};
}

}  // namespace

NormalEquations linearize(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                          const Rigid3& target_from_source, const Objective& objective, int num_threads) {
  require(objective.kernel_chi2 > 0.0, "kernel_chi2", objective.kernel_chi2, "must be above 0");
  require(objective.kernel_direction_chi2 > 0.0, "kernel_direction_chi2", objective.kernel_direction_chi2,
          "must be above 0");
  const PairErrors errors(source, target, target_from_source, objective.information);
  const BlockSums sums = blocked_sum<BlockSums>(pairs.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    BlockSums block;
    for (const Correspondence& pair : pairs.subspan(begin, end - begin)) {
      const PairError e = errors.of(pair);
      const Robust direction = robust(direction_chi2(e), objective.kernel_direction_chi2);
      const auto [gamma, loss] = robust(position_chi2(e) + direction.loss, objective.kernel_chi2);
      block.add_position(e, gamma);
      block.add_direction(e, gamma * direction.gamma);
      block.cost += 0.5 * loss;
    }
    return block;
  });
  NormalEquations equations;
  equations.H << sums.tt, sums.tr, sums.tr.transpose(), sums.rr;
  equations.b << sums.b_t, sums.b_r;
  equations.cost = sums.cost;
  equations.num_pairs = static_cast<std::int64_t>(pairs.size());
  return equations;
}

PairChi2 chi2_of_pairs(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                       const Rigid3& target_from_source, const InformationModel& information, int num_threads) {
  const PairErrors errors(source, target, target_from_source, information);
  PairChi2 chi2{std::vector<float>(pairs.size()), std::vector<float>(pairs.size())};
  for_each_block(pairs.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const PairError e = errors.of(pairs[k]);
      chi2.position[k] = static_cast<float>(position_chi2(e));
      chi2.direction[k] = e.compares_directions ? static_cast<float>(direction_chi2(e)) : -1.0f;
    }
  });
  return chi2;
}

}  // namespace augicp
