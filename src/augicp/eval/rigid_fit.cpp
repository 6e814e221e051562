// SPDX-License-Identifier: MIT
#include "augicp/eval/rigid_fit.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace augicp {
namespace {

// Umeyama 1991, equations 34 to 38.
struct Moments {
  Vec3d source_mean = Vec3d::Zero(), target_mean = Vec3d::Zero();
  double source_variance = 0.0, target_variance = 0.0;
  Mat3d covariance = Mat3d::Zero();  // target times source
};

Moments moments_of(std::span<const Vec3d> source, std::span<const Vec3d> target) {
  if (source.empty() || source.size() != target.size())
    throw std::invalid_argument("fit: expected as many source as target points, found " +
                                std::to_string(source.size()) + " and " + std::to_string(target.size()));
  const double count = static_cast<double>(source.size());
  Moments moments;
  for (std::size_t i = 0; i < source.size(); ++i) {
    moments.source_mean += source[i] / count;
    moments.target_mean += target[i] / count;
  }
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Vec3d of_source = source[i] - moments.source_mean, of_target = target[i] - moments.target_mean;
    moments.source_variance += of_source.squaredNorm() / count;
    moments.target_variance += of_target.squaredNorm() / count;
    moments.covariance += of_target * of_source.transpose() / count;
  }
  if (!moments.covariance.allFinite() || !std::isfinite(moments.source_variance) ||
      !std::isfinite(moments.target_variance))
    throw std::invalid_argument("fit: the coordinates or their squares are not finite");
  return moments;
}

struct Turn {
  Eigen::Quaterniond rotation;
  double trace = 0.0;   // trace of D S, for the scale
  double second = 0.0;  // second singular value: it constrains the rotation about the best line
  bool unique = true;   // to within rounding
};

// Equations 39, 40 and 43.
Turn turn_of(const Mat3d& covariance) {
  const Eigen::JacobiSVD<Mat3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3d &u = svd.matrixU(), &v = svd.matrixV();
  const Vec3d& d = svd.singularValues();
  if (d(0) == 0.0) return {Eigen::Quaterniond::Identity(), 0.0, 0.0, false};
  // The second singular value falls with the square of the distance from the line.
  constexpr double kFlat = 1e-12;
  if (d(1) <= kFlat * d(0)) return {Eigen::Quaterniond::FromTwoVectors(v.col(0), u.col(0)), d(0), d(1), false};
  const Vec3d signs(1.0, 1.0, u.determinant() * v.determinant() < 0.0 ? -1.0 : 1.0);
  const Mat3d rotation = u * signs.asDiagonal() * v.transpose();
  const bool unique = signs(2) > 0.0 || d(1) - d(2) > kFlat * d(0);
  return {Eigen::Quaterniond(rotation).normalized(), d.dot(signs), d(1), unique};
}

// The mean of the squares that are left: equation 41 before the minimum over the scale.
double mean_squared_residual(const Moments& moments, const Turn& turn, double scale) {
  const double left = moments.target_variance + scale * (scale * moments.source_variance - 2.0 * turn.trace);
  return std::max(0.0, left);
}

// Umeyama 1991, equation 41. Both sets must spread farther from their best line than the
// residual of the fit, or the rotation about that line fits the errors.
RigidFit fit_of(const Moments& moments, const Turn& turn, double scale) {
  const Vec3d translation = moments.target_mean - turn.rotation * (scale * moments.source_mean);
  const bool unique = turn.unique && scale * turn.second > mean_squared_residual(moments, turn, scale);
  return {{scale, {turn.rotation, translation}}, unique};
}

}  // namespace

Vec3d operator*(const Similarity3& b_from_a, const Vec3d& x_in_a) {
  return b_from_a.motion * (b_from_a.scale * x_in_a);
}

Rigid3 operator*(const Similarity3& b_from_a, const Rigid3& a_from_body) {
  return b_from_a.motion * Rigid3{a_from_body.rotation, b_from_a.scale * a_from_body.translation};
}

RigidFit fit_rigid(std::span<const Vec3d> source, std::span<const Vec3d> target) {
  const Moments moments = moments_of(source, target);
  return fit_of(moments, turn_of(moments.covariance), 1.0);
}

RigidFit fit_similarity(std::span<const Vec3d> source, std::span<const Vec3d> target) {
  const Moments moments = moments_of(source, target);
  const Turn turn = turn_of(moments.covariance);
  const bool has_extent = moments.source_variance > 0.0;
  return fit_of(moments, turn, has_extent ? turn.trace / moments.source_variance : 1.0);  // equation 42
}

}  // namespace augicp
