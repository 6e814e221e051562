// SPDX-License-Identifier: MIT
#include "augicp/shutter/readout_motion.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "augicp/core/angles.h"
#include "augicp/core/median.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

using Vec18 = Eigen::Matrix<double, 18, 1>;
using Mat18 = Eigen::Matrix<double, 18, 18>;

// Rotation and translation of a hand-held camera during a readout of a thirtieth of a second (standard deviations).
constexpr double kUsualTurn = 3.0 * kRadPerDeg;
constexpr double kUsualShift = 0.005;

// Errors of neighbouring points of a depth image are correlated, so its thousands of pairs count like this number of
// independent ones. Chosen on fr1/desk; a quarter and four times the number are hardly worse.
constexpr double kIndependentPairs = 15.0;

constexpr std::size_t kMinPairs = 300;
constexpr double kOutlierSigmas = 2.0;

// The distance of a pair along the target's normal, its derivative by the eighteen unknowns, and its relative
// information.
struct PlaneError {
  Vec18 derivative;
  double error, information;
};

// The time of readout of each point.
std::vector<float> readout_times(const Scan& scan) {
  const IndexImage& seen = scan.view->index;
  std::vector<float> times(scan.cloud.size());
  for (std::size_t pixel = 0; pixel < seen.index.size(); ++pixel)
    if (seen.index[pixel] != IndexImage::kNone)
      times[seen.index[pixel]] =
          (static_cast<float>(pixel / seen.width) + 0.5f) / static_cast<float>(seen.height) - 0.5f;
  return times;
}

std::vector<PlaneError> plane_errors(const SkewedPair& scans, std::span<const Correspondence> pairs,
                                     const Rigid3& pose) {
  const Cloud &source = scans.straight_source.cloud, &target = scans.straight_target.cloud;
  if (!target.has_directions()) return {};
  const std::vector<float> source_times = readout_times(scans.source), target_times = readout_times(scans.target);
  const Mat3d rotation = pose.rotation.toRotationMatrix();
  std::vector<PlaneError> errors;
  for (const auto [j, i] : pairs) {
    if (target.structures[i] != Structure::Planar) continue;
    const Vec3d moved = rotation * source.points[j].cast<double>() + pose.translation;
    const Vec3d normal = target.directions[i].cast<double>();
    Vec6d of_pose;
    of_pose << normal, moved.cross(normal);
    PlaneError e;
    e.derivative << of_pose, static_cast<double>(source_times[j]) * of_pose,
        -static_cast<double>(target_times[i]) * of_pose;
    e.error = normal.dot(target.points[i].cast<double>() - moved);
    e.information = target.weights.empty() ? 1.0 : static_cast<double>(target.weights[i]);
    errors.push_back(e);
  }
  return errors;
}

double typical_error(const std::vector<PlaneError>& errors) {
  std::vector<float> sizes;
  for (const PlaneError& e : errors) sizes.push_back(static_cast<float>(std::abs(e.error) * std::sqrt(e.information)));
  return static_cast<float>(kSigmaPerMedian) * median(sizes);
}

// An increment of a pose, expressed in the frame that the motion leads to.
Vec6d seen_from(const Rigid3& b_from_a, const Vec6d& increment_in_a) {
  const Vec3d turn = b_from_a.rotation * increment_in_a.tail<3>();
  Vec6d increment;
  increment << b_from_a.rotation * increment_in_a.head<3>() + b_from_a.translation.cross(turn), turn;
  return increment;
}

Vec6d increment_of(const Rigid3& motion) {
  Vec6d increment;
  increment << motion.translation, rotation_log(motion.rotation);
  return increment;
}

Rigid3 motion_of(const Vec6d& increment) { return {rotation_exp(increment.tail<3>()), increment.head<3>()}; }

}  // namespace

ReadoutMotion improved(const ReadoutMotion& so_far, const SkewedPair& scans, std::span<const Correspondence> pairs,
                       const Rigid3& target_from_source) {
  const std::vector<PlaneError> errors = plane_errors(scans, pairs, target_from_source);
  const double sigma = typical_error(errors);
  if (errors.size() < kMinPairs || !(sigma > 0.0)) return so_far;
  Vec6d source = seen_from(target_from_source, increment_of(so_far.source)), target = increment_of(so_far.target);
  Mat18 H = Mat18::Zero();
  Vec18 b = Vec18::Zero();
  const double scale = kIndependentPairs / (static_cast<double>(errors.size()) * sigma * sigma);
  for (const PlaneError& e : errors) {
    const double sigmas = std::abs(e.error) * std::sqrt(e.information) / sigma;
    const double robust = sigmas > kOutlierSigmas ? std::pow(kOutlierSigmas / sigmas, 2) : 1.0;
    H.selfadjointView<Eigen::Lower>().rankUpdate(e.derivative, scale * robust * e.information);
    b += scale * robust * e.information * e.error * e.derivative;
  }
  Vec6d usual;
  usual << Vec3d::Constant(std::pow(kUsualShift, -2)), Vec3d::Constant(std::pow(kUsualTurn, -2));
  H.diagonal().segment<6>(6) += usual;
  H.diagonal().segment<6>(12) += usual;
  b.segment<6>(6) -= usual.cwiseProduct(source);
  b.segment<6>(12) -= usual.cwiseProduct(target);
  const Vec18 step = H.selfadjointView<Eigen::Lower>().ldlt().solve(b);
  if (!step.allFinite()) return so_far;
  source += step.segment<6>(6);
  target += step.segment<6>(12);
  return {motion_of(seen_from(inverse(target_from_source), source)), motion_of(target)};
}

}  // namespace augicp
