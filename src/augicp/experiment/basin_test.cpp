// SPDX-License-Identifier: MIT
#include "augicp/experiment/basin.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "augicp/testing/rendering.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

BasinOptions small_options() {
  BasinOptions options;
  options.angles_rad = {0.0, 0.05, std::numbers::pi};
  options.distances = {0.0, 0.02};
  options.num_starts = 2;
  return options;
}

Scan box_scan() {
  const testing::Rendering seen = testing::render(testing::box_on_table(), testing::kinect_like_camera(100));
  return scan_of(seen.depth, seen.camera);
}

TEST(Basin, NearStartsComeHomeAndHalfTurnsDoNot) {
  const Scan scan = box_scan();
  BasinOptions options = small_options();
  options.registration.search = false;  // it would find every start's way home
  const auto cells = run_basin(scan, scan, {}, options, [] {});
  ASSERT_EQ(cells.size(), 6u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(cells[i].success, 1.0) << "cell " << i;
  EXPECT_LT(cells[5].success, 1.0);
  EXPECT_LE(cells[0].mean_iterations, cells[3].mean_iterations);
}

TEST(Basin, SameBitsForAnyNumberOfThreads) {
  const Scan scan = box_scan();
  BasinOptions options = small_options();
  options.angles_rad = {0.05, std::numbers::pi};
  options.distances = {0.02};
  options.num_starts = testing::repeats(2, 1);
  options.registration.num_threads = 1;
  const auto cells = run_basin(scan, scan, {}, options, [] {});
  options.registration.num_threads = 3;
  const auto again = run_basin(scan, scan, {}, options, [] {});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(again[i].success, cells[i].success);
    EXPECT_EQ(again[i].mean_iterations, cells[i].mean_iterations);
  }
}

std::vector<BasinCell> with_success(const std::vector<double>& shares) {
  std::vector<BasinCell> cells;
  for (const double share : shares) cells.push_back({.success = share});
  return cells;
}

TEST(BasinArea, IsTheMeanOfTheSurface) {
  BasinOptions options;
  options.angles_rad = {0.0, 1.0, 3.0};
  options.distances = {0.0, 2.0};
  EXPECT_DOUBLE_EQ(area_under(with_success({1, 1, 1, 1, 1, 1}), options), 1.0);
  // Falls from 1 to 0 between 1 and 3: (1 + 1) / 3.
  EXPECT_DOUBLE_EQ(area_under(with_success({1, 1, 1, 1, 0, 0}), options), 2.0 / 3.0);
  options.distances = {0.5};
  EXPECT_DOUBLE_EQ(area_under(with_success({1, 1, 0}), options), 2.0 / 3.0);
  EXPECT_THROW(area_under(with_success({1.0}), options), std::invalid_argument);
}

TEST(Basin, RefusesAxesThatDoNotAscend) {
  BasinOptions options = small_options();
  options.distances = {1.0, 0.0};
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
