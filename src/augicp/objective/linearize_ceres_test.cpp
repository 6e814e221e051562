// SPDX-License-Identifier: MIT
// The normal equations against another library's: residuals with sqrt information, derivatives by dual numbers.
#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include "augicp/objective/linearize.h"
#include "augicp/testing/plain_objective.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"
#include "augicp/testing/symmetric.h"

namespace augicp {
namespace {

// sqrt(Omega) e of Eq. (8), as a function of the increment to a pose: translation, then rotation vector, on the left.
struct WhitenedError {
  Vec3d moved_point, moved_direction;  // under the pose, before the increment; the direction's sign is chosen
  Vec3d target_point, target_direction;
  Mat6d sqrt_information;

  template <typename T>
  bool operator()(const T* increment, T* residual) const {
    using Vec3 = Eigen::Matrix<T, 3, 1>;
    const Vec3 point_before = moved_point.cast<T>(), direction_before = moved_direction.cast<T>();
    Vec3 point, direction;
    ceres::AngleAxisRotatePoint(increment + 3, point_before.data(), point.data());
    ceres::AngleAxisRotatePoint(increment + 3, direction_before.data(), direction.data());
    Eigen::Matrix<T, 6, 1> error;
    error << target_point.cast<T>() - point - Eigen::Map<const Vec3>(increment), target_direction.cast<T>() - direction;
    Eigen::Map<Eigen::Matrix<T, 6, 1>>(residual, 6) = sqrt_information.cast<T>() * error;
    return true;
  }
};

// Eq. (13) as Ceres wants it: value, first and second derivative.
class CauchyTail : public ceres::LossFunction {
 public:
  explicit CauchyTail(double kernel_chi2) : kernel_chi2_(kernel_chi2) {}
  void Evaluate(double chi2, double out[3]) const override {
    const bool inside = chi2 < kernel_chi2_;
    out[0] = testing::plain_loss(chi2, kernel_chi2_);
    out[1] = inside ? 1.0 : kernel_chi2_ / chi2;
    out[2] = inside ? 0.0 : -kernel_chi2_ / (chi2 * chi2);
  }

 private:
  double kernel_chi2_;
};

WhitenedError whitened_error(const Cloud& source, const Cloud& target, const Correspondence& pair, const Rigid3& pose,
                             const InformationModel& model) {
  const testing::PlainPair plain = testing::plain_pair(source, target, pair, pose, model);
  WhitenedError error;
  error.moved_point = pose * source.points[pair.source].cast<double>();
  error.target_point = error.moved_point + plain.error.head<3>();
  error.target_direction = target.directions[pair.target].cast<double>();
  error.moved_direction = error.target_direction - plain.error.tail<3>();
  error.sqrt_information = testing::sqrt_of(plain.information);
  return error;
}

struct Evaluation {
  double cost = 0.0;
  Vec6d gradient = Vec6d::Zero();
  Mat6d matrix = Mat6d::Zero();  // J^T J, with the kernel only in its first-order weight
};

class CeresProblem {
 public:
  CeresProblem(const Cloud& source, const Cloud& target, const std::vector<Correspondence>& pairs, const Rigid3& pose,
               const Objective& objective)
      : loss_(objective.kernel_chi2) {
    for (const Correspondence& pair : pairs) {
      const WhitenedError error = whitened_error(source, target, pair, pose, objective.information);
      functions_.push_back(
          std::make_unique<ceres::AutoDiffCostFunction<WhitenedError, 6, 6>>(new WhitenedError(error)));
    }
  }

  Evaluation evaluate() const {
    Evaluation sum;
    const double increment[6] = {};
    const double* parameters[] = {increment};
    for (const auto& function : functions_) {
      Vec6d residual;
      Eigen::Matrix<double, 6, 6, Eigen::RowMajor> jacobian;
      double* jacobians[] = {jacobian.data()};
      EXPECT_TRUE(function->Evaluate(parameters, residual.data(), jacobians));
      double loss[3];
      loss_.Evaluate(residual.squaredNorm(), loss);
      sum.cost += 0.5 * loss[0];
      sum.gradient += loss[1] * jacobian.transpose() * residual;
      sum.matrix += loss[1] * jacobian.transpose() * jacobian;
    }
    return sum;
  }

  // By Ceres alone, its own way with the loss.
  Evaluation evaluate_by_ceres() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(options);
    double increment[6] = {};
    for (const auto& function : functions_) problem.AddResidualBlock(function.get(), &loss_, increment);
    Evaluation whole;
    std::vector<double> gradient;
    EXPECT_TRUE(problem.Evaluate({}, &whole.cost, nullptr, &gradient, nullptr));
    whole.gradient = Eigen::Map<const Vec6d>(gradient.data());
    return whole;
  }

 private:
  CauchyTail loss_;
  std::vector<std::unique_ptr<ceres::CostFunction>> functions_;
};

TEST(LinearizeAgainstCeres, CostGradientAndMatrixAgree) {
  const Cloud source = testing::random_extended_points(60, 1.0, 21),
              target = testing::random_extended_points(60, 1.0, 22);
  std::mt19937 generator(23);
  const std::vector<Correspondence> pairs = testing::random_pairs(100, 60, 24);
  for (const InformationModel& model :
       {point_information(), plane_information(), gicp_information(), augmented_information(), default_information(),
        with_lever(augmented_information(), 0.3), with_both_sides(augmented_information()), ndt_information()}) {
    for (double kernel_chi2 : {std::numeric_limits<double>::infinity(), 30.0}) {
      for (double angle_rad : {0.0, 0.1, 2.0, 3.1}) {
        const Rigid3 pose = testing::random_motion(generator, angle_rad, 0.5);
        const Objective objective{model, kernel_chi2};
        const NormalEquations ours = linearize({source, target, pairs, pose}, objective, 1);
        CeresProblem problem(source, target, pairs, pose, objective);
        const Evaluation theirs = problem.evaluate(), whole = problem.evaluate_by_ceres();
        // Float directions have unit length to 1e-7 only, and information from both sides magnifies it, see
        // linearize_test.cpp.
        const double relative = model.position_sides == Sides::Both ? 2.2e-4 : 1e-5;
        EXPECT_NEAR(ours.cost, whole.cost, relative * whole.cost);
        EXPECT_LE((ours.b - whole.gradient).norm(), relative * whole.gradient.norm());
        EXPECT_LE((ours.b - theirs.gradient).norm(), relative * theirs.gradient.norm());
        EXPECT_LE((ours.H - theirs.matrix).norm(), relative * theirs.matrix.norm());
      }
    }
  }
}

}  // namespace
}  // namespace augicp
