// SPDX-License-Identifier: MIT
#include "augicp/objective/linearize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include "augicp/core/parallel.h"
#include "augicp/testing/numeric_derivative.h"
#include "augicp/testing/plain_objective.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"
#include "augicp/testing/symmetric.h"

namespace augicp {
namespace {

using testing::plain_cost;
using testing::plain_pair;
using testing::PlainPair;
using testing::random_extended_points;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct NamedModel {
  std::string name;
  InformationModel model;
};

InformationModel both_parts_with_both_sides(InformationModel model) {
  model.position_sides = model.direction_sides = Sides::Both;
  return model;
}

const std::vector<NamedModel> kModels{
    {"point", point_information()},
    {"plane", plane_information()},
    {"gicp", gicp_information()},
    {"augmented", augmented_information()},
    {"default", default_information()},
    {"ndt", ndt_information()},
    {"a lever of 0.3 m", with_lever(augmented_information(), 0.3)},
    {"gicp, both sides", with_both_sides(gicp_information())},
    {"augmented, both sides", both_parts_with_both_sides(augmented_information())},
    {"both sides, a lever of 0.3 m", both_parts_with_both_sides(with_lever(augmented_information(), 0.3))},
    {"both sides, no lever", both_parts_with_both_sides(positions_only(augmented_information()))}};

struct TwoClouds {
  Cloud source, target;
  std::vector<Correspondence> pairs;
};

// Pairs of every two structures.
TwoClouds random_pairs(std::size_t num_pairs, unsigned seed) {
  return {random_extended_points(50, 1.0, seed), random_extended_points(50, 1.0, seed + 1),
          testing::random_pairs(num_pairs, 50, seed)};
}

NormalEquations linearize(const TwoClouds& two, const Rigid3& pose, const Objective& objective, int num_threads = 1) {
  return augicp::linearize({two.source, two.target, two.pairs, pose}, objective, num_threads);
}

std::vector<Rigid3> some_poses() {
  std::mt19937 generator(17);
  std::vector<Rigid3> poses{Rigid3{}};
  for (double angle_rad : {0.01, 0.5, 3.0}) poses.push_back(testing::random_motion(generator, angle_rad, 0.7));
  return poses;
}

// The largest difference, relative to the largest entry.
template <typename Matrix>
double relative_difference(const Matrix& a, const Matrix& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// A unit direction in float is one only to 1e-7, and so is an entry of Omega relative to the largest: random errors,
// most of which lie across a plane's normal, have a part along it that is some fifty times smaller than they are.
constexpr double kFloat = 1e-5;

// With both sides the information of two planes depends on their angle a as 1 / (2 epsilon + a^2): it changes by up to
// 1 / sqrt(2 epsilon), some 22 times, what float makes of the angle.
double tolerance_of(const InformationModel& model) {
  const bool is_both = model.position_sides == Sides::Both || model.direction_sides == Sides::Both;
  return is_both ? kFloat / std::sqrt(2.0 * kTable2Epsilon) : kFloat;
}

// Points are read in runs, and behind the last pair there may be others, whose squares overflow.
TEST(Linearize, PointsOfNoPairDoNotMatter) {
  TwoClouds two = random_pairs(0, 31);
  for (std::uint32_t k = 0; k < 10; ++k) two.pairs.push_back({k, k});
  const Rigid3 pose = some_poses()[2];
  const Objective objective{augmented_information()};
  const NormalEquations expected = linearize(two, pose, objective);
  for (std::size_t k = 10; k < two.source.size(); ++k) {
    two.source.points[k] = Vec3f::Constant(2e38f);
    two.target.points[k] = Vec3f::Constant(-2e38f);
  }
  const NormalEquations found = linearize(two, pose, objective);
  EXPECT_EQ(found.H, expected.H);
  EXPECT_EQ(found.b, expected.b);
  EXPECT_EQ(found.cost, expected.cost);
}

TEST(Linearize, CostIsThePlainOne) {
  const TwoClouds two = random_pairs(200, 1);
  for (const auto& [name, model] : kModels)
    for (double kernel_chi2 : {kInfinity, 100.0, 0.5, 1e-3})
      for (const Rigid3& pose : some_poses()) {
        const Objective objective{model, kernel_chi2, kernel_chi2 / 3.0};
        const double expected = plain_cost({two.source, two.target, two.pairs, pose}, objective);
        EXPECT_NEAR(linearize(two, pose, objective).cost, expected, tolerance_of(model) * expected)
            << name << ", K = " << kernel_chi2;
      }
}

TEST(Linearize, VectorIsTheGradientOfTheCost) {
  const TwoClouds two = random_pairs(200, 2);
  for (const auto& [name, model] : kModels)
    for (double kernel_chi2 : {kInfinity, 100.0, 0.5})
      for (const Rigid3& pose : some_poses()) {
        const Objective objective{model, kernel_chi2, kernel_chi2 / 3.0};
        const auto cost = [&](const Rigid3& moved) {  // the plain one, whose digits bear differences
          return plain_cost({two.source, two.target, two.pairs, moved}, objective, pose);
        };
        const Vec6d numeric = testing::numeric_gradient(cost, pose);
        EXPECT_LE(relative_difference(linearize(two, pose, objective).b, numeric), tolerance_of(model))
            << name << ", K = " << kernel_chi2;
      }
}

TEST(Linearize, MatrixIsThatOfTheNumericJacobians) {
  const TwoClouds two = random_pairs(60, 3);
  for (const auto& [name, model] : kModels)
    for (const Rigid3& pose : some_poses()) {
      Mat6d expected = Mat6d::Zero();
      for (const Correspondence& pair : two.pairs) {
        const auto error = [&, &of_model = model](const Rigid3& moved) {
          return plain_pair(two.source, two.target, pair, moved, of_model).error;
        };
        const Mat6d jacobian = testing::numeric_jacobian<6>(error, pose);
        expected += jacobian.transpose() * plain_pair(two.source, two.target, pair, pose, model).information * jacobian;
      }
      EXPECT_LE(relative_difference(linearize(two, pose, {model}).H, expected), tolerance_of(model)) << name;
    }
}

// With the kernel, H is the sum of every pair's own H times its gamma.
TEST(Linearize, KernelWeighsEachPairByGamma) {
  const TwoClouds two = random_pairs(60, 4);
  const double kernel_chi2 = 50.0;
  const Rigid3 pose = some_poses()[2];
  for (const auto& [name, model] : kModels) {
    Mat6d expected = Mat6d::Zero();
    for (const Correspondence& pair : two.pairs) {
      const TwoClouds alone{two.source, two.target, {pair}};
      const PlainPair plain = plain_pair(two.source, two.target, pair, pose, model);
      const double chi2 = plain.error.dot(plain.information * plain.error);
      expected += (chi2 < kernel_chi2 ? 1.0 : kernel_chi2 / chi2) * linearize(alone, pose, {model}).H;
    }
    EXPECT_LE(relative_difference(linearize(two, pose, {model, kernel_chi2}).H, expected), tolerance_of(model)) << name;
  }
}

TEST(Linearize, MatrixIsSymmetricAndHasNoNegativeEigenvalue) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const TwoClouds two = random_pairs(5, seed);
    for (const auto& [name, model] : kModels)
      for (const Rigid3& pose : some_poses()) {
        const Mat6d H = linearize(two, pose, {model, 10.0}).H;
        EXPECT_LE(relative_difference(Mat6d(H.transpose()), H), 1e-14) << name;
        const Vec6d eigenvalues = testing::eigenvalues_of(H);
        EXPECT_GE(eigenvalues[0], -1e-6 * eigenvalues[5]) << name;
      }
  }
}

Cloud moved(const Cloud& cloud, const Rigid3& motion) {
  Cloud result = cloud;
  for (Vec3f& point : result.points) point = (motion * point.cast<double>()).cast<float>();
  for (Vec3f& direction : result.directions) direction = (motion.rotation * direction.cast<double>()).cast<float>();
  for (PointGaussian& gaussian : result.gaussians) {
    const Mat3d rotation = motion.rotation.toRotationMatrix();
    gaussian.mean = (motion * gaussian.mean.cast<double>()).cast<float>();
    gaussian.information = (rotation * gaussian.information.cast<double>() * rotation.transpose()).cast<float>();
  }
  if (result.viewpoint) result.viewpoint = (motion * result.viewpoint->cast<double>()).cast<float>();
  return result;
}

// small_gicp once had a cost that changed with the orientation of the scene.
TEST(Linearize, CostStaysWhenTheWholeSceneMoves) {
  const TwoClouds two = random_pairs(200, 5);
  std::mt19937 generator(5);
  for (const auto& [name, model] : kModels)
    for (int i = 0; i < 5; ++i) {
      const Rigid3 motion = testing::random_motion(generator, 2.5, 3.0), pose = some_poses()[2];
      const TwoClouds moved_two{moved(two.source, motion), moved(two.target, motion), two.pairs};
      const Objective objective{model, 100.0};
      const double expected = linearize(two, pose, objective).cost;
      EXPECT_NEAR(linearize(moved_two, motion * pose * inverse(motion), objective).cost, expected, 1e-5 * expected)
          << name;
    }
}

TEST(Linearize, CostStaysWhenOnlyTheSourceFrameMoves) {
  const TwoClouds two = random_pairs(200, 6);
  std::mt19937 generator(6);
  for (const auto& [name, model] : kModels) {
    const Rigid3 motion = testing::random_motion(generator, 2.5, 3.0), pose = some_poses()[2];
    const TwoClouds moved_two{moved(two.source, motion), two.target, two.pairs};
    const double expected = linearize(two, pose, {model}).cost;
    EXPECT_NEAR(linearize(moved_two, pose * inverse(motion), {model}).cost, expected, 1e-5 * expected) << name;
  }
}

// The clouds change places, and with them the direction of the pose.
TEST(Linearize, CostOfBothSidesIsThatOfTheInverse) {
  TwoClouds two = random_pairs(200, 8);
  two.source.weights = two.target.weights;
  std::reverse(two.source.weights.begin(), two.source.weights.end());
  TwoClouds swapped{two.target, two.source, two.pairs};
  for (Correspondence& pair : swapped.pairs) std::swap(pair.source, pair.target);
  for (const auto& [name, model] : kModels) {
    if (model.position_sides != Sides::Both) continue;
    for (const Rigid3& pose : some_poses()) {
      const double expected = linearize(two, pose, {model, 100.0}).cost;
      EXPECT_NEAR(linearize(swapped, inverse(pose), {model, 100.0}).cost, expected, 1e-5 * expected) << name;
    }
  }
}

// Half of Table 2 where the points agree; less, the more their directions differ.
TEST(Linearize, BothSidesDoubtPlanesThatDiffer) {
  const auto cost = [](double angle_rad, const InformationModel& model) {
    Cloud source, target;
    target.points = {{0.0f, 0.0f, 0.1f}};
    target.directions = {{0.0f, 0.0f, 1.0f}};
    source.points = {Vec3f::Zero()};
    source.directions = {{static_cast<float>(std::sin(angle_rad)), 0.0f, static_cast<float>(std::cos(angle_rad))}};
    source.structures = target.structures = {Structure::Planar};
    const std::vector<Correspondence> pairs{{0, 0}};
    return augicp::linearize({source, target, pairs, {}}, {model}, 1).cost;
  };
  const InformationModel one = gicp_information(), both = with_both_sides(one);
  EXPECT_NEAR(cost(0.0, both), 0.5 * cost(0.0, one), 1e-5 * cost(0.0, one));
  for (double angle_rad : {0.05, 0.3, 1.0, 1.57}) {
    // Of [1, eps] and the same turned by an angle a, along the first normal: (C + C')^-1 by Cramer's rule.
    const double eps = kTable2Epsilon, sine_sq = std::pow(std::sin(angle_rad), 2);
    const double across = 2.0 - (1.0 - eps) * sine_sq, along = 2.0 * eps + (1.0 - eps) * sine_sq;
    const double mixed_sq = std::pow((1.0 - eps) * std::sin(angle_rad) * std::cos(angle_rad), 2);
    const double expected = 0.5 * 0.01 * across / (across * along - mixed_sq);
    EXPECT_NEAR(cost(angle_rad, both), expected, 1e-4 * expected) << angle_rad;
    EXPECT_LT(cost(angle_rad, both), 2.0 * eps / sine_sq * cost(0.0, one)) << angle_rad;
  }
}

TwoClouds with_opposite(TwoClouds two, Structure structure) {
  for (std::size_t i = 0; i < two.target.size(); i += 2)
    if (two.target.structures[i] == structure) two.target.directions[i] = -two.target.directions[i];
  return two;
}

TEST(Linearize, ATangentAndItsOppositeAreTheSame) {
  const TwoClouds two = random_pairs(200, 7);
  const Rigid3 pose = some_poses()[2];
  const NormalEquations expected = linearize(two, pose, {augmented_information()});
  const NormalEquations opposite = linearize(with_opposite(two, Structure::Edge), pose, {augmented_information()});
  EXPECT_DOUBLE_EQ(opposite.cost, expected.cost);
  EXPECT_LE(relative_difference(opposite.H, expected.H), 1e-14);
  EXPECT_LE(relative_difference(opposite.b, expected.b), 1e-14);
}

TEST(Linearize, ANormalAndItsOppositeDifferWhereBothSensorsAreKnown) {
  TwoClouds two = random_pairs(200, 8);
  const Rigid3 pose = some_poses()[2];
  const auto difference = [&] {
    return linearize(two, pose, {augmented_information()}).cost -
           linearize(with_opposite(two, Structure::Planar), pose, {augmented_information()}).cost;
  };
  EXPECT_GT(std::abs(difference()), 1e-3);
  two.source.viewpoint.reset();
  EXPECT_NEAR(difference(), 0.0, 1e-9);
  two.source.viewpoint = two.target.viewpoint;
  two.target.viewpoint.reset();
  EXPECT_NEAR(difference(), 0.0, 1e-9);
}

// A direction by a right angle: |l_i - R l_j|^2 = 2, of it 1 along (1) and 1 across (1000).
TEST(Linearize, ChiSquareOfAHandMadePair) {
  TwoClouds two;
  two.source.points = two.target.points = {Vec3f::Zero()};
  two.source.directions = {Vec3f::UnitY()};
  two.target.directions = {Vec3f::UnitX()};
  two.source.structures = two.target.structures = {Structure::Planar};
  two.target.points[0] = {0.1f, 0.2f, 0.0f};
  two.pairs = {{0, 0}};
  const PairChi2 chi2 = chi2_of_pairs({two.source, two.target, two.pairs, Rigid3{}}, augmented_information(), 1);
  EXPECT_NEAR(chi2.position[0], 0.1 * 0.1 * 1000.0 + 0.2 * 0.2, 1e-5);
  EXPECT_NEAR(chi2.direction[0], 1.0 + 1000.0, 1e-3);
}

TEST(Linearize, PairsOfDifferentStructureHaveNoLinearPart) {
  const TwoClouds two = random_pairs(200, 9);
  const Rigid3 pose = some_poses()[2];
  const PairChi2 chi2 = chi2_of_pairs({two.source, two.target, two.pairs, pose}, augmented_information(), 1);
  for (std::size_t k = 0; k < two.pairs.size(); ++k) {
    const Structure of_source = two.source.structures[two.pairs[k].source];
    const Structure of_target = two.target.structures[two.pairs[k].target];
    EXPECT_EQ(chi2.direction[k] >= 0.0f, of_source == of_target && of_target != Structure::None);
  }
  TwoClouds different = two;
  std::erase_if(different.pairs, [&](const Correspondence& pair) {
    return two.source.structures[pair.source] == two.target.structures[pair.target];
  });
  ASSERT_FALSE(different.pairs.empty());
  EXPECT_EQ(linearize(different, pose, {augmented_information()}).H,
            linearize(different, pose, {gicp_information()}).H);
}

TEST(Linearize, WithoutDirectionsInTheSourceThePositionsStillCount) {
  TwoClouds two = random_pairs(200, 10);
  const Rigid3 pose = some_poses()[2];
  const NormalEquations expected = linearize(two, pose, {gicp_information()});
  two.source.directions.clear();
  two.source.structures.clear();
  EXPECT_EQ(linearize(two, pose, {augmented_information()}).H, expected.H);
  EXPECT_EQ(linearize(two, pose, {augmented_information()}).cost, expected.cost);
}

TEST(Linearize, WithoutDirectionsInTheTargetEveryPointIsWithoutStructure) {
  TwoClouds two = random_pairs(200, 11);
  two.target.directions.clear();
  two.target.structures.clear();
  const Rigid3 pose = some_poses()[2];
  EXPECT_EQ(linearize(two, pose, {augmented_information()}).H, linearize(two, pose, {point_information()}).H);
}

TEST(Linearize, WeightOfATargetPointScalesItsPairs) {
  TwoClouds two = random_pairs(200, 12);
  two.target.weights.clear();
  const Rigid3 pose = some_poses()[2];
  const NormalEquations unweighted = linearize(two, pose, {augmented_information()});
  two.target.weights.assign(two.target.size(), 0.25f);
  const NormalEquations weighted = linearize(two, pose, {augmented_information()});
  EXPECT_LE(relative_difference(weighted.H, Mat6d(0.25 * unweighted.H)), 1e-14);
  EXPECT_LE(relative_difference(weighted.b, Vec6d(0.25 * unweighted.b)), 1e-14);
  EXPECT_NEAR(weighted.cost, 0.25 * unweighted.cost, 1e-12 * unweighted.cost);
}

TEST(Linearize, KnownMethodsAreSpecialCases) {
  const TwoClouds two = random_pairs(200, 13);
  const Rigid3 pose = some_poses()[2];
  double point = 0.0, plane = 0.0, gicp = 0.0;
  for (const auto& [j, i] : two.pairs) {
    const Vec3d error = two.target.points[i].cast<double>() - pose * two.source.points[j].cast<double>();
    const double along = two.target.directions[i].cast<double>().dot(error), all = error.squaredNorm();
    const double weight = 0.5 * static_cast<double>(two.target.weights[i]);
    const Structure structure = two.target.structures[i];
    point += weight * all;
    plane += weight * (structure == Structure::Planar ? along * along
                       : structure == Structure::Edge ? all - along * along
                                                      : 0.0);
    gicp += weight * (structure == Structure::Planar ? all + 999.0 * along * along
                      : structure == Structure::Edge ? 1000.0 * all - 999.0 * along * along
                                                     : all);
  }
  EXPECT_NEAR(linearize(two, pose, {point_information()}).cost, point, kFloat * point);
  EXPECT_NEAR(linearize(two, pose, {plane_information()}).cost, plane, kFloat * plane);
  EXPECT_NEAR(linearize(two, pose, {gicp_information()}).cost, gicp, kFloat * gicp);
}

// A Gaussian with the covariance of a disc is GICP's; one without information is none.
TEST(Linearize, NdtOfDiscsIsGicp) {
  TwoClouds two = random_pairs(200, 18);
  const Rigid3 pose = some_poses()[2];
  for (std::size_t i = 0; i < two.target.size(); ++i) {
    const Information of_structure = gicp_information().of(two.target.structures[i]).position;
    const Vec3d direction = two.target.directions[i].cast<double>();
    two.target.gaussians[i] = {two.target.points[i],
                               testing::information_matrix(of_structure, direction).cast<float>()};
  }
  const NormalEquations ndt = linearize(two, pose, {ndt_information(), 100.0});
  const NormalEquations gicp = linearize(two, pose, {gicp_information(), 100.0});
  EXPECT_LE(relative_difference(ndt.H, gicp.H), kFloat);
  EXPECT_LE(relative_difference(ndt.b, gicp.b), kFloat);
  EXPECT_NEAR(ndt.cost, gicp.cost, kFloat * gicp.cost);
  for (PointGaussian& gaussian : two.target.gaussians) gaussian.information.setZero();
  EXPECT_TRUE(linearize(two, pose, {ndt_information()}).H.isZero(0.0));
  EXPECT_EQ(linearize(two, pose, {ndt_information()}).cost, 0.0);
}

// One pair, distance apart along x: chi2 = distance^2.
TwoClouds one_pair(double distance) {
  TwoClouds two;
  two.source.points = {Vec3f::Zero()};
  two.target.points = {Vec3f(static_cast<float>(distance), 0.0f, 0.0f)};
  two.pairs = {{0, 0}};
  return two;
}

TEST(Linearize, GammaIsEquation13) {
  const Objective objective{point_information(), 4.0};
  for (const auto& [distance, gamma] : {std::pair{1.0, 1.0}, {2.0, 1.0}, {4.0, 0.25}, {8.0, 0.0625}}) {
    const NormalEquations equations = linearize(one_pair(distance), Rigid3{}, objective);
    EXPECT_DOUBLE_EQ(equations.H(0, 0), gamma);
    EXPECT_DOUBLE_EQ(equations.b[0], -gamma * distance);
  }
}

// A jump of the loss or of its slope at K would show as a difference far above the step.
TEST(Linearize, LossAndItsSlopeAreContinuousAtTheKernel) {
  const Objective objective{point_information(), 4.0};
  const NormalEquations below = linearize(one_pair(2.0 - 1e-6), Rigid3{}, objective);
  const NormalEquations above = linearize(one_pair(2.0 + 1e-6), Rigid3{}, objective);
  EXPECT_NEAR(below.cost, above.cost, 1e-5);
  EXPECT_NEAR(below.b[0], above.b[0], 1e-5);
  EXPECT_NE(below.cost, above.cost);
}

// Far beyond what a float holds: information has a unit of its own, and a kernel is never nearer to zero than chi2 can
// bear.
TEST(Linearize, NumbersOutOfTheRangeOfFloatAreHeld) {
  for (double scale : {1e-60, 1e-39, 1e39, 1e300}) {
    const InformationModel model{{{scale, scale}, {}}, {{scale, scale}, {}}, {{scale, scale}, {}}};
    const NormalEquations equations = linearize(one_pair(0.5), Rigid3{}, {model});
    EXPECT_NEAR(equations.H(0, 0) / scale, 1.0, 1e-7);
    EXPECT_NEAR(equations.cost / scale, 0.125, 1e-7);
    const TwoClouds perfect = one_pair(0.0);
    EXPECT_EQ(chi2_of_pairs({perfect.source, perfect.target, perfect.pairs, Rigid3{}}, model, 1).position[0], 0.0f);
  }
  const NormalEquations hardly = linearize(one_pair(3.0), Rigid3{}, {point_information(), 1e-45, 1e-45});
  EXPECT_GT(hardly.H(0, 0), 0.0);
  EXPECT_LT(hardly.b[0], 0.0);
}

TEST(Linearize, ChiSquareOfPairsAddsUpToTheCost) {
  const TwoClouds two = random_pairs(5000, 14);
  const Rigid3 pose = some_poses()[2];
  for (const auto& [name, model] : kModels) {
    const PairChi2 chi2 = chi2_of_pairs({two.source, two.target, two.pairs, pose}, model, 2);
    double sum = 0.0;
    for (std::size_t k = 0; k < two.pairs.size(); ++k)
      sum += static_cast<double>(chi2.position[k]) + std::max(0.0, static_cast<double>(chi2.direction[k]));
    EXPECT_NEAR(0.5 * sum, linearize(two, pose, {model}).cost, 1e-6 * sum) << name;
  }
}

TEST(Linearize, EveryPairCountsWhateverTheirNumber) {
  for (std::size_t num_pairs :
       {std::size_t{1}, kLightBlockSize - 1, kLightBlockSize, kLightBlockSize + 1, 3 * kLightBlockSize + 1}) {
    TwoClouds two = random_pairs(num_pairs, 15);
    two.target.weights.clear();
    const NormalEquations equations = linearize(two, Rigid3{}, {point_information()}, 3);
    EXPECT_EQ(equations.H(0, 0), static_cast<double>(num_pairs));
    EXPECT_EQ(equations.num_pairs, static_cast<std::int64_t>(num_pairs));
  }
}

TEST(Linearize, SameBitsForAnyNumberOfThreads) {
  for (std::size_t num_pairs : {kLightBlockSize - 1, kLightBlockSize + 1, 5 * kLightBlockSize + 7}) {
    for (const InformationModel& model : {augmented_information(), ndt_information()}) {
      const TwoClouds two = random_pairs(num_pairs, 16);
      const Rigid3 pose = some_poses()[2];
      const Objective objective{model, 100.0};
      const NormalEquations expected = linearize(two, pose, objective, 1);
      const PairChi2 chi2 = chi2_of_pairs({two.source, two.target, two.pairs, pose}, objective.information, 1);
      for (int num_threads = 2; num_threads <= 8; ++num_threads) {
        const NormalEquations equations = linearize(two, pose, objective, num_threads);
        EXPECT_EQ(equations.H, expected.H);
        EXPECT_EQ(equations.b, expected.b);
        EXPECT_EQ(equations.cost, expected.cost);
        const PairChi2 again =
            chi2_of_pairs({two.source, two.target, two.pairs, pose}, objective.information, num_threads);
        EXPECT_EQ(again.position, chi2.position);
        EXPECT_EQ(again.direction, chi2.direction);
      }
    }
  }
}

TEST(Linearize, NoPairsGiveZeros) {
  const NormalEquations equations = linearize(TwoClouds{}, Rigid3{}, {augmented_information(), 1.0});
  EXPECT_TRUE(equations.H.isZero(0.0));
  EXPECT_TRUE(equations.b.isZero(0.0));
  EXPECT_EQ(equations.cost, 0.0);
  EXPECT_EQ(equations.num_pairs, 0);
  EXPECT_TRUE(chi2_of_pairs({{}, {}, {}, Rigid3{}}, augmented_information(), 1).position.empty());
}

TEST(Linearize, BadKernelIsRefused) {
  for (double kernel_chi2 : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(linearize(one_pair(1.0), Rigid3{}, {point_information(), kernel_chi2}), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
