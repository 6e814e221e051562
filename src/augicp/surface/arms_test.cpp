// SPDX-License-Identifier: MIT
#include "augicp/surface/arms.h"

#include <gmock/gmock.h>

namespace augicp {
namespace {

using ::testing::ElementsAre;

constexpr float kMissing = 0.0f;

struct LineCase {
  Cloud cloud;
  IndexImage index;
};

// One row of pixels 1 mm apart at these depths.
LineCase row_of(const std::vector<float>& depths) {
  LineCase row{{}, IndexImage(static_cast<int>(depths.size()), 1)};
  for (std::size_t k = 0; k < depths.size(); ++k) {
    if (depths[k] == kMissing) continue;
    row.index.index[k] = static_cast<std::int32_t>(row.cloud.size());
    row.cloud.points.emplace_back(0.001f * static_cast<float>(k), 0.0f, depths[k]);
  }
  return row;
}

Line line_of(const LineCase& row) { return image_line(row.cloud, row.index, true, 0, 0.02); }

TEST(Arms, StepInDepthEndsARun) {
  EXPECT_THAT(line_of(row_of({1.0f, 1.01f, 1.05f, 1.05f})).run, ElementsAre(0, 0, 1, 1));
}

TEST(Arms, MissingReadingsDoNotEndARun) {
  const Line line = line_of(row_of({1.0f, kMissing, kMissing, 1.05f, 1.05f}));
  EXPECT_THAT(line.run, ElementsAre(0, 0, 0));  // 5 cm over three pixels is less than 2 cm a pixel
  EXPECT_THAT(line.position, ElementsAre(0, 3, 4));
}

TEST(Arms, ReachAsFarAsTheBallAndNotAcrossAStep) {
  const LineCase row = row_of({1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.5f});
  const Reach reach = reach_along(line_of(row), row.cloud, std::vector<double>(row.cloud.size(), 0.0025));
  EXPECT_THAT(reach.first, ElementsAre(0, 0, 0, 1, 2, 5));
  EXPECT_THAT(reach.last, ElementsAre(2, 3, 4, 4, 4, 5));
}

// The last entry is near the first but not near the second: a search that only went outwards would leave the line.
TEST(Arms, SearchEndsWhereTheNeighboursReachIsTooFar) {
  const LineCase row = row_of({1.0f, 1.007f, 0.994f});
  const Reach reach = reach_along(line_of(row), row.cloud, {0.01, 0.01, 0.01});
  EXPECT_THAT(reach.first, ElementsAre(0, 0, 0));
  EXPECT_THAT(reach.last, ElementsAre(2, 1, 2));
}

TEST(Arms, EmptyLineHasNoReach) {
  const LineCase row = row_of({kMissing, kMissing});
  EXPECT_TRUE(reach_along(line_of(row), row.cloud, {}).first.empty());
}

}  // namespace
}  // namespace augicp
