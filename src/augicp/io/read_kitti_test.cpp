// SPDX-License-Identifier: MIT
#include "augicp/io/read_kitti.h"

#include <limits>
#include <stdexcept>

#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using testing::expect_refused;
using testing::packed;
using testing::parse;
using Points = std::vector<Vec3f>;

constexpr float kNanFloat = std::numeric_limits<float>::quiet_NaN();

std::string sweep() { return packed<float>({1, -2, 3, 0.5f, kNanFloat, 0, 0, 0, 4, 5, -6, 0}); }

TEST(ReadKitti, PointsAreSeenFromZero) {
  const CloudFile file = parse("a.bin", sweep());
  EXPECT_EQ(file.cloud.points, (Points{{1, -2, 3}, {4, 5, -6}}));
  EXPECT_EQ(file.cloud.viewpoint, Vec3f(0, 0, 0));
  EXPECT_EQ(file.report.num_declared, 3u);
  EXPECT_EQ(file.report.num_not_finite, 1u);
  EXPECT_EQ(file.cloud.intensities, (std::vector<float>{0.5f, 0.0f}));
}

TEST(ReadKitti, BarePositionsAreReadWhenAskedFor) {
  const CloudFile file = parse("a.bin", packed<float>({1, -2, -3, 4, 5, -6}), {.num_bin_columns = 3});
  EXPECT_EQ(file.cloud.points, (Points{{1, -2, -3}, {4, 5, -6}}));
  EXPECT_FALSE(file.cloud.viewpoint);
  EXPECT_TRUE(file.cloud.intensities.empty());
  for (const int wrong : {-1, 1, 2, 7})
    EXPECT_THROW(parse("a.bin", sweep(), {.num_bin_columns = wrong}), std::invalid_argument);
}

// Points whose coordinates are negative in turn: as another number of columns one would be an intensity.
std::string points_of(std::size_t num_columns, std::size_t num_points) {
  std::vector<float> numbers;
  for (std::size_t i = 0; i < num_points; ++i)
    for (std::size_t column = 0; column < num_columns; ++column) {
      const bool is_negative = column < 3 && i % 3 == column;
      numbers.push_back((is_negative ? -1.0f : 1.0f) * static_cast<float>(1 + i + column));
    }
  return packed<float>(numbers);
}

TEST(ReadKitti, TheNumberOfColumnsIsFound) {
  for (std::size_t num_columns = 4; num_columns <= 6; ++num_columns) {
    const CloudFile file = parse("a.pcd.bin", points_of(num_columns, 60), {.keep_fields = true});
    EXPECT_EQ(file.report.format, fmt::format("bin of {} float32 numbers a point", num_columns));
    EXPECT_EQ(file.cloud.size(), 60u);
    EXPECT_EQ(file.cloud.points[1], Vec3f(2, -3, 4));
    EXPECT_EQ(file.cloud.intensities[1], 5.0f);
    ASSERT_EQ(file.fields.fields.size(), num_columns - 3);
    EXPECT_EQ(file.fields.fields.back().at(1), static_cast<double>(num_columns + 1));
    EXPECT_TRUE(file.report.warnings.empty());
  }
}

TEST(ReadKitti, SeveralThatFitAreAWarning) {
  const std::string positive = packed<float>(std::vector<float>(60, 1.0f));
  const CloudFile file = parse("a.bin", positive);
  EXPECT_EQ(file.cloud.size(), 15u) << "as KITTI has them";
  ASSERT_EQ(file.report.warnings.size(), 1u);
  EXPECT_THAT(file.report.warnings[0], ::testing::HasSubstr("5 would do too"));
  EXPECT_TRUE(parse("a.bin", positive, {.num_bin_columns = 4}).report.warnings.empty());
  EXPECT_EQ(parse("a.bin", positive, {.num_bin_columns = 6}).cloud.size(), 10u);
}

// robustness 1. A file cut at a whole number of points is a shorter file.
TEST(ReadKitti, CutsWithinAPointAreErrors) {
  for (std::size_t length = 0; length < sweep().size(); ++length)
    EXPECT_EQ(testing::refusal("a.bin", sweep().substr(0, length), {.num_bin_columns = 4}).empty(),
              length > 0 && length % 16 == 0)
        << length;
  expect_refused("a.bin", sweep() + "1234", "byte 48: expected points of 4 float32 numbers, 16 bytes, found 4 bytes");
}

TEST(ReadKitti, NegativeIntensitiesGiveOtherLayoutsAway) {
  expect_refused("a.bin", packed<float>({1, 2, 3, -4}),
                 "byte 12: expected x y z intensity of float32, found the intensity -4");
}

// robustness 2, 4
TEST(ReadKitti, EmptyFullAndNotFiniteFilesAreErrors) {
  expect_refused("a.bin", "", "holds no points");
  expect_refused("a.bin", packed<float>({kNanFloat, 0, 0, 0}), "none of its 1 points is finite");
  EXPECT_NE(testing::refusal("a.bin", sweep(), {.max_points = 2}), "");
}

// Coordinates that are float already lose nothing.
TEST(ReadKitti, FarCoordinatesLoseNothing) {
  for (const float offset : {1e3f, 1e6f, 1e7f}) {
    const Cloud cloud = parse("a.bin", packed<float>({offset, -offset, 1, 0, offset + 1, -offset - 1, 2, 0})).cloud;
    EXPECT_EQ(testing::places(cloud)[1] - testing::places(cloud)[0], Vec3d(1, -1, 1));
    EXPECT_EQ(cloud.origin + cloud.viewpoint->cast<double>(), Vec3d::Zero());
  }
}

}  // namespace
}  // namespace augicp
