// SPDX-License-Identifier: MIT
#include "augicp/odometry/standstill.h"

#include <Eigen/Cholesky>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// Of the squared distance of two poses in deviations, a chi-squared number of six degrees of freedom, the 0.999
// quantile.
constexpr double kMaxChi2 = 22.5;

// Halves of fewer poses tell no more than the last one, and a sensor that has moved stands still after this many.
constexpr std::size_t kMinPoses = 4;

// From pose a to pose b, with a rotation about the sensor's place.
Vec6d apart(const Rigid3& a, const Rigid3& b) {
  Vec6d increment;
  increment << b.translation - a.translation, rotation_log(b.rotation * a.rotation.conjugate());
  return increment;
}

struct Mean {
  Rigid3 pose;
  Mat6d covariance;
};

template <typename Iterator>
Mean mean_of(Iterator begin, Iterator end) {
  const Rigid3& first = begin->world_from_sensor;
  const auto count = static_cast<double>(end - begin);
  Vec6d sum = Vec6d::Zero();
  Mat6d covariances = Mat6d::Zero();
  for (Iterator k = begin; k != end; ++k) {
    sum += apart(first, k->world_from_sensor);
    covariances += k->covariance;
  }
  const Vec6d mean = sum / count;
  const Rigid3 pose{rotation_exp(Vec3d(mean.tail<3>())) * first.rotation, first.translation + mean.head<3>()};
  return {pose, covariances / (count * count)};
}

bool may_be_one_place(const Mean& a, const Mean& b) {
  const Vec6d difference = apart(a.pose, b.pose);
  const Eigen::LDLT<Mat6d> covariance(a.covariance + b.covariance);
  return covariance.isPositive() && difference.dot(covariance.solve(difference)) <= kMaxChi2;
}

}  // namespace

Rigid3 Standstill::add(const Rigid3& world_from_sensor, const Mat6d& covariance) {
  poses_.push_back({world_from_sensor, covariance});
  if (poses_.size() > kMaxPoses) poses_.pop_front();
  const auto begin = poses_.begin(), end = poses_.end(), half = begin + static_cast<std::ptrdiff_t>(poses_.size() / 2);
  const bool are_of_one_place =
      poses_.size() == 1 || (may_be_one_place(mean_of(begin, end - 1), mean_of(end - 1, end)) &&
                             (poses_.size() < kMinPoses || may_be_one_place(mean_of(begin, half), mean_of(half, end))));
  if (!are_of_one_place) poses_.erase(begin, end - 1);
  stands_ = are_of_one_place && (stands_ || poses_.size() >= kMinPoses);
  return stands_ ? mean_of(poses_.begin(), poses_.end()).pose : world_from_sensor;
}

}  // namespace augicp
