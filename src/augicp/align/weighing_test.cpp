// SPDX-License-Identifier: MIT
#include "augicp/align/weighing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace augicp {
namespace {

// Five pairs; the last two compare no directions.
const PairChi2 kChi2{{4.0f, 16.0f, 1.0f, 100.0f, 200.0f}, {4.0f, 1.0f, 9.0f, -1.0f, -1.0f}};

AlignOptions weighed_by(std::optional<double> lever, double kernel_per_median = 8.0) {
  AlignOptions options;
  options.lever = lever;
  options.kernel_per_median = kernel_per_median;
  return options;
}

TEST(Weighing, LeverIsTheRatioOfTheMedianErrors) {
  // Of the three pairs that compare directions both medians are 4.
  EXPECT_DOUBLE_EQ(weigh_pairs(kChi2, {}).lever, 1.0);
  PairChi2 farther = kChi2;
  for (float& chi2 : farther.position) chi2 *= 9.0f;
  EXPECT_DOUBLE_EQ(weigh_pairs(farther, {}).lever, 3.0);
  PairChi2 rougher = kChi2;
  for (float& chi2 : rougher.direction) chi2 *= 4.0f;
  EXPECT_DOUBLE_EQ(weigh_pairs(rougher, {}).lever, 0.5);
}

// Three pairs under the identity whose brightness differs by offset + 0, 0.1 and -0.2.
struct BrightPairs {
  Cloud source, target;
  std::vector<Correspondence> pairs{{0, 0}, {1, 1}, {2, 2}};
};

BrightPairs bright_pairs(float offset, float gradient) {
  BrightPairs two;
  two.source.points = two.target.points = {Vec3f::Zero(), Vec3f::UnitX(), Vec3f::UnitY()};
  two.source.intensities = {0.5f, 0.5f, 0.5f};
  two.target.intensities = {0.5f + offset, 0.6f + offset, 0.3f + offset};
  two.target.intensity_gradients.assign(3, Vec3f(gradient, 0.0f, 0.0f));
  return two;
}

IntensityModel weigh(const BrightPairs& two, double weight = 1.0) {
  AlignOptions options;
  options.intensity_weight = weight;
  return weigh_intensities({two.source, two.target, two.pairs, Rigid3{}}, kChi2, options);
}

TEST(Weighing, IntensitiesCountAsMuchAsPositions) {
  const IntensityModel model =
      weigh(bright_pairs(0.2f, 0.01f));  // medians: 16 of the positions, 0.01 of the brightness
  EXPECT_NEAR(model.offset, 0.2, 1e-6);
  EXPECT_NEAR(model.information, 16.0 / 0.01, 1e-2);
  EXPECT_NEAR(model.kernel_chi2, AlignOptions{}.kernel_intensity_per_median * 16.0, 1e-4);
  EXPECT_NEAR(weigh(bright_pairs(0.2f, 0.01f), 0.5).information, 8.0 / 0.01, 1e-2);
}

TEST(Weighing, AGradientHoldsNoMoreFirmlyThanAPlane) {
  const double along = AlignOptions{}.information.planar.position.along;
  EXPECT_NEAR(weigh(bright_pairs(0.0f, 20.0f)).information, along / 400.0, 1e-6 * along);
  BrightPairs perfect = bright_pairs(0.0f, 20.0f);
  perfect.target.intensities = perfect.source.intensities;
  EXPECT_NEAR(weigh(perfect).information, along / 400.0, 1e-6 * along);
}

TEST(Weighing, IntensitiesAreOffWhereNotAskedForOrMissing) {
  BrightPairs two = bright_pairs(0.0f, 1.0f);
  EXPECT_EQ(weigh(two, 0.0).information, 0.0);
  two.target.intensity_gradients.assign(3, Vec3f::Zero());
  EXPECT_EQ(weigh(two).information, 0.0);
  two.source.intensities.clear();
  EXPECT_EQ(weigh(two).information, 0.0);
}

// One true pair among ten false ones whose errors are alike: their median has nothing to do with it.
TEST(Weighing, ALowQuantileIsThatOfTheFewTruePairs) {
  PairChi2 chi2{{0.01f}, std::vector<float>(11, -1.0f)};
  for (int k = 0; k < 10; ++k) chi2.position.push_back(100.0f + static_cast<float>(k));
  AlignOptions options = weighed_by(0.0);
  EXPECT_DOUBLE_EQ(weigh_pairs(chi2, options).kernel_chi2, 8.0 * 104.0);
  options.kernel_quantile = 0.05;
  EXPECT_FLOAT_EQ(static_cast<float>(weigh_pairs(chi2, options).kernel_chi2), 8.0f * 0.01f);
}

TEST(Weighing, LeverIsCapped) {
  AlignOptions options;
  options.max_lever = 0.25;
  EXPECT_DOUBLE_EQ(weigh_pairs(kChi2, options).lever, 0.25);
  options.max_lever = 2.0;
  EXPECT_DOUBLE_EQ(weigh_pairs(kChi2, options).lever, 1.0);
}

TEST(Weighing, FixedLeverIsTaken) { EXPECT_DOUBLE_EQ(weigh_pairs(kChi2, weighed_by(7.0)).lever, 7.0); }

TEST(Weighing, KernelIsAMultipleOfTheMedianUnderTheLever) {
  // Lever 1: 8, 17, 10, 100, 200. Lever 10: 404, 116, 901, 100, 200. Lever 0: 4, 16, 1, 100, 200.
  EXPECT_DOUBLE_EQ(weigh_pairs(kChi2, {}).kernel_chi2, 8.0 * 17.0);
  EXPECT_DOUBLE_EQ(weigh_pairs(kChi2, weighed_by(10.0, 2.0)).kernel_chi2, 2.0 * 200.0);
  EXPECT_DOUBLE_EQ(weigh_pairs(kChi2, weighed_by(0.0, 1.0)).kernel_chi2, 16.0);
}

TEST(Weighing, FixedKernelIsTaken) {
  AlignOptions options;
  options.kernel_chi2 = 5.0;
  const Weighing weighing = weigh_pairs(kChi2, options);
  EXPECT_DOUBLE_EQ(weighing.kernel_chi2, 5.0);
  EXPECT_DOUBLE_EQ(weighing.lever, 1.0);
}

// Perfect directions have a median of zero, and infinity times zero is no kernel.
TEST(Weighing, WithoutAKernelDirectionsCountInFullHoweverWellTheyFit) {
  AlignOptions options = weighed_by(1.0);
  options.kernel_direction_per_median = std::numeric_limits<double>::infinity();
  const PairChi2 perfect{{1.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 0.0f}};
  EXPECT_EQ(weigh_pairs(perfect, options).kernel_direction_chi2, std::numeric_limits<double>::infinity());
}

TEST(Weighing, NoDirectionComparedGivesNoLever) {
  const Weighing weighing = weigh_pairs({{1.0f, 2.0f, 3.0f}, {-1.0f, -1.0f, -1.0f}}, weighed_by(std::nullopt, 1.0));
  EXPECT_EQ(weighing.lever, 0.0);
  EXPECT_DOUBLE_EQ(weighing.kernel_chi2, 2.0);
}

// A cloud against itself: there is nothing to weigh, and everything must stay a number, K above 0.
TEST(Weighing, PerfectFitStaysANumber) {
  for (const PairChi2& chi2 : {PairChi2{{0.0f, 0.0f}, {0.0f, 0.0f}}, PairChi2{{1.0f, 1.0f}, {0.0f, 0.0f}},
                               PairChi2{{0.0f, 0.0f}, {1.0f, 1.0f}}, PairChi2{}}) {
    const Weighing weighing = weigh_pairs(chi2, {});
    EXPECT_TRUE(std::isfinite(weighing.lever));
    EXPECT_TRUE(std::isfinite(weighing.kernel_chi2));
    EXPECT_GT(weighing.kernel_chi2, 0.0);
  }
}

TEST(Weighing, LessThanHalfOfFalsePairsChangeLittle) {
  PairChi2 chi2;
  for (int k = 0; k < 100; ++k) {
    chi2.position.push_back(k < 45 ? 1e6f : 1.0f);
    chi2.direction.push_back(k < 45 ? 1e3f : 4.0f);
  }
  EXPECT_DOUBLE_EQ(weigh_pairs(chi2, {}).lever, 0.5);
  EXPECT_DOUBLE_EQ(weigh_pairs(chi2, weighed_by(std::nullopt, 1.0)).kernel_chi2, 2.0);
}

}  // namespace
}  // namespace augicp
