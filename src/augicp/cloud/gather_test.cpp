// SPDX-License-Identifier: MIT
#include "augicp/cloud/gather.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace augicp {
namespace {

// A cloud with numbers that identify their point.
Cloud numbered(std::size_t size) {
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i) {
    const auto number = static_cast<float>(i);
    cloud.points.emplace_back(number, number + 0.25f, number + 0.5f);
    cloud.weights.push_back(-number);
    cloud.structures.push_back(static_cast<Structure>(i % 3));
  }
  return cloud;
}

void expect_gathered(const Cloud& cloud, const IndexRuns& runs) {
  Column<float> xyz[3], weights;
  Column<std::int32_t> structures;
  gather(cloud.points, runs, xyz);
  gather(cloud.weights, runs, weights);
  gather(cloud.structures, runs, structures);
  for (std::size_t k = 0; k < runs.count; ++k) {
    const std::uint32_t i = runs.index[k];
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(xyz[axis][k], cloud.points[i][axis]) << k;
    EXPECT_EQ(weights[k], cloud.weights[i]) << k;
    EXPECT_EQ(structures[k], static_cast<std::int32_t>(cloud.structures[i])) << k;
  }
}

// Runs of about mean_length at random places, up to the very last point.
IndexRuns random_runs(std::mt19937& generator, std::size_t count, std::size_t size, int mean_length) {
  IndexRuns runs;
  runs.count = count;
  std::uint32_t next = static_cast<std::uint32_t>(size - std::min<std::size_t>(size, 20));
  for (std::size_t k = 0; k < count; ++k, ++next) {
    if (next >= size || generator() % mean_length == 0) next = static_cast<std::uint32_t>(generator() % size);
    runs.index[k] = next;
  }
  find_runs(runs);
  return runs;
}

TEST(Gather, ReadsWhatEachIndexPointsTo) {
  std::mt19937 generator(5);
  for (const std::size_t size : {1, 15, 16, 17, 40, 1000, 5000}) {  // of the last, what comes next is asked for ahead
    const Cloud cloud = numbered(size);
    for (const std::size_t count : {1, 2, 15, 16, 17, 63, 64})
      for (const int mean_length : {1, 2, 4, 20, 1000})
        expect_gathered(cloud, random_runs(generator, count, size, mean_length));
  }
}

TEST(Gather, ReadsNothing) {
  IndexRuns runs;
  find_runs(runs);
  EXPECT_EQ(runs.num_runs, 0u);
  expect_gathered(Cloud{}, runs);
}

TEST(IndexRuns, CoverTheIndicesInOrder) {
  std::mt19937 generator(6);
  for (const std::size_t count : {1, 8, 9, 63, 64})
    for (const int mean_length : {1, 3, 20, 1000}) {
      const IndexRuns runs = random_runs(generator, count, 500, mean_length);
      EXPECT_EQ(runs.begin[0], 0);
      EXPECT_EQ(runs.begin[runs.num_runs], count);
      for (std::size_t r = 0; r < runs.num_runs; ++r) {
        EXPECT_LT(runs.begin[r], runs.begin[r + 1]);
        for (std::size_t k = runs.begin[r] + 1u; k < runs.begin[r + 1]; ++k)
          EXPECT_EQ(runs.index[k], runs.index[k - 1] + 1);
      }
      for (std::size_t r = 1; r < runs.num_runs; ++r)
        EXPECT_NE(runs.index[runs.begin[r]], runs.index[runs.begin[r] - 1u] + 1);
    }
}

TEST(IndexRuns, OfPairsAreThoseOfEachSide) {
  const std::vector<Correspondence> pairs{{7, 1}, {8, 2}, {9, 4}, {3, 5}};
  IndexRuns of_source, of_target;
  find_runs(pairs, of_source, of_target);
  ASSERT_EQ(of_source.num_runs, 2u);
  ASSERT_EQ(of_target.num_runs, 2u);
  EXPECT_EQ(of_source.begin[1], 3);
  EXPECT_EQ(of_target.begin[1], 2);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    EXPECT_EQ(of_source.index[k], pairs[k].source);
    EXPECT_EQ(of_target.index[k], pairs[k].target);
  }
}

}  // namespace
}  // namespace augicp
