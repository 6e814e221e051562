// SPDX-License-Identifier: MIT
#include "augicp/objective/intensity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "augicp/core/parallel.h"
#include "augicp/objective/linearize.h"
#include "augicp/testing/numeric_derivative.h"
#include "augicp/testing/plain_objective.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"
#include "augicp/testing/symmetric.h"

namespace augicp {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

struct GreyClouds {
  Cloud source, target;
  std::vector<Correspondence> pairs;
};

void add_brightness(Cloud& cloud, std::mt19937& generator) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.intensities.push_back(static_cast<float>(testing::uniform(generator, 0.0, 1.0)));
    cloud.intensity_gradients.push_back((3.0 * testing::random_direction(generator)).cast<float>());
  }
}

GreyClouds random_grey_pairs(std::size_t num_pairs, unsigned seed) {
  GreyClouds two{testing::random_extended_points(50, 1.0, seed), testing::random_extended_points(50, 1.0, seed + 1),
                 testing::random_pairs(num_pairs, 50, seed)};
  std::mt19937 generator(seed);
  add_brightness(two.source, generator);
  add_brightness(two.target, generator);
  return two;
}

std::vector<Rigid3> poses_of_grey_clouds() {
  std::mt19937 generator(17);
  std::vector<Rigid3> poses{Rigid3{}};
  for (double angle_rad : {0.01, 0.5, 3.0}) poses.push_back(testing::random_motion(generator, angle_rad, 0.7));
  return poses;
}

// The definition, one pair after the other.
double plain_residual(const GreyClouds& two, const Correspondence& pair, const Rigid3& pose) {
  const Vec3d q = pose * two.source.points[pair.source].cast<double>(),
              p = two.target.points[pair.target].cast<double>();
  return static_cast<double>(two.target.intensities[pair.target]) +
         two.target.intensity_gradients[pair.target].cast<double>().dot(q - p) -
         static_cast<double>(two.source.intensities[pair.source]);
}

NormalEquations linearize(const GreyClouds& two, const Rigid3& pose, const IntensityModel& model, int num_threads = 1) {
  return linearize_intensity({two.source, two.target, two.pairs, pose}, model, num_threads);
}

template <typename Matrix>
double largest_relative_difference(const Matrix& a, const Matrix& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

const std::vector<IntensityModel> kIntensityModels{
    {1.0}, {200.0}, {200.0, 30.0}, {200.0, 30.0, 0.4}, {5.0, 1e-3, -0.2}};

TEST(Intensity, CostAndResidualsAreTheDefinition) {
  const GreyClouds two = random_grey_pairs(200, 1);
  for (const Rigid3& pose : poses_of_grey_clouds()) {
    const std::vector<float> residuals = intensity_residuals({two.source, two.target, two.pairs, pose}, 1);
    double cost = 0.0;
    for (std::size_t k = 0; k < two.pairs.size(); ++k) {
      const double r = plain_residual(two, two.pairs[k], pose);
      EXPECT_NEAR(residuals[k], r, 1e-6);
      cost += 0.5 * 3.0 * (r - 0.25) * (r - 0.25);
    }
    EXPECT_NEAR(linearize(two, pose, {3.0, std::numeric_limits<double>::infinity(), 0.25}).cost, cost, 1e-9 * cost);
  }
}

TEST(Intensity, VectorIsTheGradientOfTheCost) {
  const GreyClouds two = random_grey_pairs(200, 2);
  for (const IntensityModel& model : kIntensityModels)
    for (const Rigid3& pose : poses_of_grey_clouds()) {
      const auto cost = [&](const Rigid3& moved) { return linearize(two, moved, model).cost; };
      EXPECT_LE(largest_relative_difference(linearize(two, pose, model).b, testing::numeric_gradient(cost, pose)), 1e-6)
          << model.kernel_chi2;
    }
}

// The same through the whole objective, positions and directions beside it.
TEST(Intensity, VectorOfTheWholeObjectiveIsTheGradientOfItsCost) {
  const GreyClouds two = random_grey_pairs(200, 3);
  for (const IntensityModel& model : kIntensityModels)
    for (const Rigid3& pose : poses_of_grey_clouds()) {
      const Objective objective{augmented_information(), 100.0, 50.0, model};
      const auto at = [&](const Rigid3& moved) {
        return augicp::linearize({two.source, two.target, two.pairs, moved}, objective, 1);
      };
      const auto cost = [&](const Rigid3& moved) {  // in double, whose digits bear differences
        return testing::plain_cost({two.source, two.target, two.pairs, moved}, objective) +
               linearize(two, moved, model).cost;
      };
      EXPECT_NEAR(at(pose).cost, cost(pose), 2e-6 * cost(pose));
      EXPECT_LE(largest_relative_difference(at(pose).b, testing::numeric_gradient(cost, pose)), 2e-6);
      EXPECT_EQ(at(pose).num_intensity_pairs, at(pose).num_pairs);
    }
}

// H of a pose and an offset together, by numeric Jacobians; the offset then eliminated by a full inverse.
TEST(Intensity, MatrixIsThatOfAPoseWhoseOffsetIsFoundToo) {
  const GreyClouds two = random_grey_pairs(60, 4);
  const IntensityModel model{7.0};
  for (const Rigid3& pose : poses_of_grey_clouds()) {
    Eigen::Matrix<double, 7, 7> joint = Eigen::Matrix<double, 7, 7>::Zero();
    for (const Correspondence& pair : two.pairs) {
      const auto error = [&](const Rigid3& moved) {
        return Eigen::Matrix<double, 1, 1>(plain_residual(two, pair, moved));
      };
      Eigen::Matrix<double, 7, 1> row;
      row << testing::numeric_jacobian<1>(error, pose).transpose(), -1.0;
      joint += model.information * row * row.transpose();
    }
    const Mat6d covariance = joint.inverse().topLeftCorner<6, 6>();
    EXPECT_LE(largest_relative_difference(Mat6d(linearize(two, pose, model).H), Mat6d(covariance.inverse())), 1e-6);
  }
}

TEST(Intensity, MatrixIsSymmetricAndHasNoNegativeEigenvalue) {
  for (unsigned seed = 0; seed < 5; ++seed)
    for (const IntensityModel& model : kIntensityModels) {
      const Mat6d H = linearize(random_grey_pairs(5, seed), poses_of_grey_clouds()[2], model).H;
      EXPECT_LE(largest_relative_difference(Mat6d(H.transpose()), H), 1e-14);
      const Vec6d eigenvalues = testing::eigenvalues_of(H);
      EXPECT_GE(eigenvalues[0], -1e-9 * eigenvalues[5]);
    }
}

// Along an even ramp a shift and a change of exposure look the same.
TEST(Intensity, ARampHoldsNothing) {
  GreyClouds two = random_grey_pairs(200, 5);
  for (Vec3f& gradient : two.target.intensity_gradients) gradient = Vec3f(2.0f, 0.0f, 0.0f);
  const Mat6d H = linearize(two, Rigid3{}, {1.0}).H;
  EXPECT_NEAR(H(0, 0), 0.0, 1e-9);
  EXPECT_GT(H(4, 4), 1.0);  // a turn about y moves points along the ramp by their own amounts
}

// The same gradients on both sides are known to both; unlike ones, as noise makes them, to neither.
TEST(Intensity, WhatBothKnowIsTheMatrixWhereTheyAgreeAndLittleWhereTheyDoNot) {
  const IntensityModel model{200.0, 30.0, 0.1};
  for (const Rigid3& pose : poses_of_grey_clouds()) {
    GreyClouds unlike = random_grey_pairs(5000, 12), alike = unlike;
    alike.source.points.clear(), alike.source.intensity_gradients.clear();
    for (std::size_t i = 0; i < alike.target.size(); ++i) {
      alike.source.points.push_back((inverse(pose) * alike.target.points[i].cast<double>()).cast<float>());
      alike.source.intensity_gradients.push_back(
          (inverse(pose).rotation * alike.target.intensity_gradients[i].cast<double>()).cast<float>());
    }
    for (Correspondence& pair : alike.pairs) pair.source = pair.target;
    const auto shared = [&](const GreyClouds& two, int num_threads) {
      return shared_intensity_information({two.source, two.target, two.pairs, pose}, model, num_threads);
    };
    EXPECT_LE(largest_relative_difference(shared(alike, 1), linearize(alike, pose, model).H), 1e-5);
    EXPECT_LE(shared(unlike, 1).trace(), 0.1 * linearize(unlike, pose, model).H.trace());
    EXPECT_EQ(shared(unlike, 3), shared(unlike, 1));
    unlike.source.intensity_gradients.clear();
    EXPECT_TRUE(shared(unlike, 1).isZero(0.0));
  }
}

TEST(Intensity, CostStaysWhenTheWholeSceneMoves) {
  const GreyClouds two = random_grey_pairs(200, 6);
  std::mt19937 generator(6);
  const IntensityModel model{200.0, 30.0, 0.1};
  for (int i = 0; i < 5; ++i) {
    const Rigid3 motion = testing::random_motion(generator, 2.5, 3.0), pose = poses_of_grey_clouds()[2];
    GreyClouds moved{transform(two.source, motion), transform(two.target, motion), two.pairs};
    for (Cloud* cloud : {&moved.source, &moved.target}) {
      for (Vec3f& point : cloud->points) point += cloud->origin.cast<float>();
      cloud->origin.setZero();
    }
    const double expected = linearize(two, pose, model).cost;
    EXPECT_NEAR(linearize(moved, motion * pose * inverse(motion), model).cost, expected, 1e-5 * expected);
  }
}

TEST(Intensity, TheUnitOfIntensityDoesNotMatter) {
  GreyClouds two = random_grey_pairs(200, 7);
  const NormalEquations expected = linearize(two, poses_of_grey_clouds()[2], {200.0, 30.0, 0.1});
  for (Cloud* cloud : {&two.source, &two.target}) {
    for (float& intensity : cloud->intensities) intensity *= 256.0f;
    for (Vec3f& gradient : cloud->intensity_gradients) gradient *= 256.0f;
  }
  const NormalEquations equations = linearize(two, poses_of_grey_clouds()[2], {200.0 / (256.0 * 256.0), 30.0, 25.6});
  EXPECT_NEAR(equations.cost, expected.cost, 1e-9 * expected.cost);
  EXPECT_LE(largest_relative_difference(equations.H, expected.H), 1e-9);
}

TEST(Intensity, PairsWithSomethingUnknownDoNotCount) {
  GreyClouds two = random_grey_pairs(200, 8);
  const auto& [source, target] = two.pairs[0];
  const auto left = [&] { return linearize(two, Rigid3{}, {1.0}).num_intensity_pairs; };
  EXPECT_EQ(left(), 200);
  two.source.intensities[source] = kUnknown;
  const auto fewer = left();
  EXPECT_LT(fewer, 200);
  two.target.intensity_gradients[two.pairs[1].target].setZero();
  EXPECT_LT(left(), fewer);
  EXPECT_TRUE(std::isnan(intensity_residuals({two.source, two.target, two.pairs, Rigid3{}}, 1)[0]));
  EXPECT_TRUE(linearize(two, Rigid3{}, {1.0}).H.allFinite());
}

// Clouds with brightness and gradients, but no comparable pair: nothing is constrained, and nothing is divided by zero.
TEST(Intensity, WhereNoPairIsKnownNothingIsHeld) {
  GreyClouds two = random_grey_pairs(50, 12);
  for (Vec3f& gradient : two.target.intensity_gradients) gradient.setZero();
  const NormalEquations equations = linearize(two, {}, {200.0, 30.0});
  EXPECT_EQ(equations.H, Mat6d(Mat6d::Zero()));
  EXPECT_EQ(equations.b, Vec6d(Vec6d::Zero()));
  EXPECT_EQ(equations.num_intensity_pairs, 0);
  EXPECT_EQ(shared_intensity_information({two.source, two.target, two.pairs, {}}, {200.0, 30.0}, 1),
            Mat6d(Mat6d::Zero()));
}

TEST(Intensity, WithoutItOnEitherSideThereIsNone) {
  const GreyClouds two = random_grey_pairs(20, 9);
  for (int without = 0; without < 3; ++without) {
    GreyClouds bare = two;
    if (without == 0) bare.source.intensities.clear();
    if (without == 1) bare.target.intensities.clear();
    if (without == 2) bare.target.intensity_gradients.clear();
    EXPECT_FALSE(compares_intensities(bare.source, bare.target));
    const Objective with{augmented_information(), 100.0, 50.0, {1.0}}, geometry{augmented_information(), 100.0, 50.0};
    const NormalEquations both = augicp::linearize({bare.source, bare.target, bare.pairs, Rigid3{}}, with, 1);
    const NormalEquations alone = augicp::linearize({bare.source, bare.target, bare.pairs, Rigid3{}}, geometry, 1);
    EXPECT_EQ(both.H, alone.H);
    EXPECT_EQ(both.cost, alone.cost);
    EXPECT_EQ(both.num_intensity_pairs, 0);
  }
}

TEST(Intensity, SameBitsForAnyNumberOfThreads) {
  const GreyClouds two = random_grey_pairs(3 * kLightBlockSize + 7, 10);
  const IntensityModel model{200.0, 30.0, 0.1};
  const NormalEquations expected = linearize(two, poses_of_grey_clouds()[2], model);
  EXPECT_EQ(expected.num_intensity_pairs, static_cast<std::int64_t>(two.pairs.size()));
  for (int num_threads = 2; num_threads <= 8; ++num_threads) {
    const NormalEquations equations = linearize(two, poses_of_grey_clouds()[2], model, num_threads);
    EXPECT_EQ(equations.H, expected.H);
    EXPECT_EQ(equations.b, expected.b);
    EXPECT_EQ(equations.cost, expected.cost);
  }
}

TEST(Intensity, BadNumbersAreRefused) {
  const GreyClouds two = random_grey_pairs(5, 11);
  for (const IntensityModel& bad : {IntensityModel{-1.0}, IntensityModel{1.0, 0.0}, IntensityModel{1.0, std::nan("")},
                                    IntensityModel{1.0, 1.0, std::nan("")}})
    EXPECT_THROW(linearize(two, Rigid3{}, bad), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
