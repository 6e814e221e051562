// SPDX-License-Identifier: MIT
// Table 4 of the paper in small: the pairs are known, a share of them is false, and only the objective differs.
#include "augicp/experiment/known_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "augicp/align/damped_step.h"
#include "augicp/objective/linearize.h"
#include "augicp/testing/fixed_pairs.h"

namespace augicp {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kNumSeeds = 5;
constexpr double kReached = 0.02;  // rad

using Errors = std::vector<double>;

void add_rotation_errors(const KnownPairs& known, const Objective& objective, Errors& errors) {
  const testing::FixedPairs matcher(known.target, known.pairs);
  Rigid3 pose;
  for (double& error : errors) {
    error += angle_between(pose, known.target_from_source) / kNumSeeds;
    const auto pairs = matcher.match(known.source, pose, {}, 0);
    pose = retract(pose, damped_step(linearize({known.source, known.target, pairs, pose}, objective, 0), 1e-6));
  }
}

// For each objective: mean rotation error over the seeds before the first iteration and after each. Few false pairs
// need few iterations.
std::vector<Errors> mean_rotation_errors(KnownPairsOptions options, const std::vector<Objective>& objectives) {
  std::vector<Errors> errors(objectives.size(), Errors(options.outlier_share > 0.5 ? 9 : 5, 0.0));
  for (options.seed = 1; options.seed <= kNumSeeds; ++options.seed) {
    const KnownPairs known = make_known_pairs(options);
    for (std::size_t k = 0; k < objectives.size(); ++k) add_rotation_errors(known, objectives[k], errors[k]);
  }
  return errors;
}

KnownPairsOptions options_with(double outlier_share, double normal_noise_deg = 5.0) {
  return {.outlier_share = outlier_share, .point_noise_m = 0.01, .normal_noise_rad = normal_noise_deg * kDegree};
}

// Iterations until the error is below kReached, with the last one counted in part, as if the error fell by a constant
// factor along it; infinity if it never is.
double iterations_needed(const Errors& errors) {
  for (std::size_t k = 1; k < errors.size(); ++k)
    if (errors[k] < kReached)
      return static_cast<double>(k) - std::log(kReached / errors[k]) / std::log(errors[k - 1] / errors[k]);
  return std::numeric_limits<double>::infinity();
}

void record(const std::string& method, const Errors& errors) {
  ::testing::Test::RecordProperty(method + "_iterations", std::to_string(iterations_needed(errors)));
  ::testing::Test::RecordProperty(method + "_error_after_3", std::to_string(errors[3]));
}

// Upper limit of augmented's iterations, relative to GICP's. Table 2's lever of 1 m is short in a room of 10 m, so with
// the K of the authors' program the gain is small. The narrower K, the more directions help to recognise false pairs
// early.
struct Case {
  std::string name;
  double outlier_share;
  double normal_noise_deg;
  double kernel_chi2;
  double max_share_of_gicp;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class KnownPairsAgainstGicp : public ::testing::TestWithParam<Case> {};

TEST_P(KnownPairsAgainstGicp, AugmentedTurnsIntoPlaceInFewerIterations) {
  const auto& [name, outlier_share, normal_noise_deg, kernel_chi2, max_share] = GetParam();
  const auto options = options_with(outlier_share, normal_noise_deg);
  const auto errors =
      mean_rotation_errors(options, {{gicp_information(), kernel_chi2}, {augmented_information(), kernel_chi2}});
  const Errors &gicp = errors[0], &augmented = errors[1];
  record("gicp", gicp);
  record("augmented", augmented);
  EXPECT_LE(iterations_needed(augmented), max_share * iterations_needed(gicp));
  for (std::size_t k = 1; gicp[k - 1] > kReached; ++k) EXPECT_LT(augmented[k], gicp[k]) << "after iteration " << k;
}

INSTANTIATE_TEST_SUITE_P(
    Table4, KnownPairsAgainstGicp,
    ::testing::Values(Case{"TruePairs", 0.0, 5.0, 1000.0, 1.0}, Case{"Half", 0.5, 5.0, 1000.0, 0.93},
                      Case{"HalfRoughNormals", 0.5, 20.0, 1000.0, 1.0}, Case{"Nine", 0.9, 5.0, 1000.0, 0.93},
                      Case{"NineRoughNormals", 0.9, 20.0, 1000.0, 0.97}, Case{"HalfNarrowKernel", 0.5, 5.0, 100.0, 0.8},
                      Case{"NineNarrowKernel", 0.9, 5.0, 100.0, 0.7}),
    [](const auto& one) { return one.param.name; });

// Under the same K, but not under the same kernel: a distance of 1 m counts 1000 times more across a plane in GICP than
// in plain ICP, to which K = 1000 is no kernel at all. Under K = 1 plain ICP, which true pairs tell all there is to
// know, is the faster one: what slows it elsewhere is its pairs.
TEST(KnownPairsAgainstPoint, GicpTurnsIntoPlaceInFewerIterationsUnderTheSameKOnly) {
  for (double outlier_share : {0.5, 0.9}) {
    const auto options = options_with(outlier_share);
    const std::string percent = std::to_string(std::lround(100.0 * outlier_share));
    const auto errors = mean_rotation_errors(
        options, {{gicp_information(), 1000.0}, {point_information(), 1000.0}, {point_information(), 1.0}});
    const Errors &gicp = errors[0], &same_k = errors[1], &same_kernel = errors[2];
    record("point_" + percent, same_k);
    record("point_with_kernel_" + percent, same_kernel);
    EXPECT_LT(iterations_needed(gicp), 0.6 * iterations_needed(same_k));
    EXPECT_LT(iterations_needed(same_kernel), iterations_needed(gicp));
  }
}

}  // namespace
}  // namespace augicp
