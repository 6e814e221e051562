// SPDX-License-Identifier: MIT
#include "augicp/experiment/synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace augicp {
namespace {

SyntheticOptions small_synthetic_options() {
  SyntheticOptions options;
  options.num_points = 5000;
  options.outlier_shares = {0.5};
  options.point_noises = {0.01};
  options.normal_noises_rad = {options.normal_noises_rad[1]};
  options.iterations = 12;
  options.num_seeds = 3;
  return options;
}

std::vector<double> rotation_curve(const std::vector<SyntheticRow>& rows, Method method) {
  std::vector<double> curve;
  for (const SyntheticRow& row : rows)
    if (row.method == method) curve.push_back(row.rotation.mean);
  return curve;
}

// The paper's claim, under the K of the authors' program. At the ends all agree: the guess is the same, and true pairs
// tell every method the truth. Between them the order must hold.
TEST(Synthetic, AugmentedIsAheadOfGicpAndGicpOfPointWhileTheyConverge) {
  SyntheticOptions options = small_synthetic_options();
  options.kernel_chi2 = 1000.0;
  const auto rows = run_synthetic(options, [] {});
  const auto point = rotation_curve(rows, Method::Point), gicp = rotation_curve(rows, Method::Gicp),
             augmented = rotation_curve(rows, Method::Augmented);
  for (std::size_t i = 1; i <= 3; ++i) {
    EXPECT_LT(augmented[i], gicp[i]) << "after iteration " << i;
    EXPECT_LT(gicp[i], point[i]) << "after iteration " << i;
  }
}

// The iteration after which the mean rotation error stays below.
int iterations_to(const std::vector<double>& curve, double limit_rad) {
  const auto last_above = std::find_if(curve.rbegin(), curve.rend(), [&](double error) { return error >= limit_rad; });
  return static_cast<int>(curve.rend() - last_above);
}

// Nineteen of twenty pairs are false, and the median pair says nothing of the true ones.
TEST(Synthetic, TheDefaultFindsFewTruePairsInFewerIterationsThanThePaper) {
  constexpr double kReached = 0.017453292519943295;  // 1 degree
  SyntheticOptions options = small_synthetic_options();
  options.iterations = 20;
  options.methods = {Method::Gicp, Method::Augmented};
  for (const double share : {0.0, 0.5, 0.9, 0.95, 0.99}) {
    options.outlier_shares = {share};
    options.preset = Preset::Paper;
    const auto paper = run_synthetic(options, [] {});
    options.preset = Preset::Default;
    const auto ours = run_synthetic(options, [] {});
    for (const Method method : options.methods) {
      const auto ours_curve = rotation_curve(ours, method);
      EXPECT_LE(iterations_to(ours_curve, kReached), iterations_to(rotation_curve(paper, method), kReached))
          << share << " of the pairs are false";
      EXPECT_LT(ours_curve.back(), kReached) << share << " of the pairs are false";
    }
  }
}

TEST(Synthetic, EveryRunStartsThirtyDegreesAway) {
  for (const SyntheticRow& row : run_synthetic(small_synthetic_options(), [] {})) {
    if (row.iteration > 0) continue;
    EXPECT_NEAR(row.rotation.mean, 0.5235987755982988, 1e-12);
    EXPECT_NEAR(row.translation.mean, 1.0, 1e-12);
    EXPECT_LT(row.rotation.half_width, 1e-7);  // the root of a rounding error
  }
}

TEST(Synthetic, SameBitsForAnyNumberOfThreadsAndAgain) {
  SyntheticOptions options = small_synthetic_options();
  const auto rows = run_synthetic(options, [] {});
  options.num_threads = 3;
  const auto again = run_synthetic(options, [] {});
  ASSERT_EQ(rows.size(), 4u * 13u);
  ASSERT_EQ(again.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(again[i].rotation.mean, rows[i].rotation.mean);
    EXPECT_EQ(again[i].translation.half_width, rows[i].translation.half_width);
  }
}

TEST(Synthetic, OneReportForEveryRun) {
  std::size_t num_reported = 0;
  const SyntheticOptions options = small_synthetic_options();
  run_synthetic(options, [&] { ++num_reported; });
  EXPECT_EQ(num_reported, num_runs(options));
}

TEST(Synthetic, RefusesOptionsOutOfRange) {
  SyntheticOptions options = small_synthetic_options();
  options.outlier_shares = {1.5};
  EXPECT_THROW(run_synthetic(options, [] {}), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
