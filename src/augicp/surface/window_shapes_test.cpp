// SPDX-License-Identifier: MIT
#include "augicp/surface/window_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::random_motion;
using testing::uniform;

// Windows of normals with these eigenvalues of their mean outer product, rotated at random.
WindowBatch normals_with(std::mt19937& generator, const Vec3d& values) {
  WindowBatch windows;
  for (int k = 0; k < kBatch; ++k) {
    const Mat3d rotation = random_motion(generator, 3.0, 0.0).rotation.toRotationMatrix();
    const Eigen::Matrix3f m = (rotation * values.asDiagonal() * rotation.transpose()).cast<float>();
    windows.weight[k] = 20.0f;
    windows.matrix.xx[k] = m(0, 0), windows.matrix.xy[k] = m(0, 1), windows.matrix.xz[k] = m(0, 2);
    windows.matrix.yy[k] = m(1, 1), windows.matrix.yz[k] = m(1, 2), windows.matrix.zz[k] = m(2, 2);
  }
  return windows;
}

TEST(WindowShapes, NoSpreadIsOverlooked) {
  std::mt19937 generator(1);
  const ShapeThresholds thresholds;
  for (int turn = 0; turn < 200; ++turn) {
    const double across = uniform(generator, 1.001 * thresholds.min_crease, 0.5);
    const double along = uniform(generator, 0.0, std::min(across, 1.0 - 2.0 * across));
    EXPECT_TRUE(may_spread(normals_with(generator, {along, across, 1.0 - along - across}), thresholds))
        << across << ' ' << along;
  }
}

// Sums far down an image are rounded, so that eigenvalues may sum to a little more or less than 1.
TEST(WindowShapes, NoSpreadIsOverlookedWhereTheTraceIsRounded) {
  std::mt19937 generator(4);
  const ShapeThresholds thresholds;
  for (const double trace : {0.95, 0.98, 1.02, 1.05}) {
    const double across = 1.001 * thresholds.min_crease, below = 0.99 * thresholds.min_crease;
    EXPECT_TRUE(may_spread(normals_with(generator, {0.0, across, trace - across}), thresholds)) << trace;
    EXPECT_FALSE(may_spread(normals_with(generator, {0.0, below, trace - below}), thresholds)) << trace;
  }
}

// Where normals spread one way only, as they do beside a crease, the bound is exact; two ways it is up to twice too
// high.
TEST(WindowShapes, AlikeNormalsDoNotSpread) {
  std::mt19937 generator(2);
  const ShapeThresholds thresholds;
  const double below = 0.99 * thresholds.min_crease;
  EXPECT_FALSE(may_spread(normals_with(generator, {0.0, below, 1.0 - below}), thresholds));
  EXPECT_FALSE(may_spread(normals_with(generator, {0.48 * below, 0.48 * below, 1.0 - 0.96 * below}), thresholds));
  EXPECT_FALSE(may_spread(normals_with(generator, Vec3d::Zero()), thresholds));
}

struct Found {
  Direction spreads[kBatch];
  Structure structures[kBatch];
  bool any;
};

Found spreads_of(const Vec3d& eigenvalues_of_normals, Structure before, float num_normals,
                 const ShapeThresholds& thresholds = {}) {
  std::mt19937 generator(3);
  WindowBatch windows = normals_with(generator, eigenvalues_of_normals);
  std::fill_n(windows.weight, kBatch, num_normals);
  EigenvalueBatch values;
  VectorBatch tangents;
  eigenvalues(windows.matrix, values);
  eigenvectors(windows.matrix, values.l0, tangents);
  Found found;
  std::fill_n(found.structures, kBatch, before);
  found.any = write_spreads(windows, values, tangents, thresholds, kBatch, found.spreads, found.structures);
  return found;
}

TEST(WindowShapes, CreasesKeepTheirTangentAndCornersLoseTheirStructure) {
  const Found crease = spreads_of({0.0, 0.2, 0.8}, Structure::Planar, 8.0f);
  EXPECT_TRUE(crease.any);
  EXPECT_NEAR(crease.spreads[5].weight, 0.2f, 1e-5f);
  EXPECT_NEAR(Vec3f(crease.spreads[5].xyz).norm(), 1.0f, 1e-5f);
  EXPECT_EQ(crease.structures[5], Structure::Planar);
  const Found corner = spreads_of({0.1, 0.2, 0.7}, Structure::Planar, 8.0f);
  EXPECT_FALSE(corner.any);
  EXPECT_EQ(corner.spreads[5].weight, 0.0f);
  EXPECT_EQ(corner.structures[5], Structure::None);
}

// The middle of a crease may be asked for less than its sides: it has a spread, but only sides begin a search for
// creases, and only they lose a structure.
TEST(WindowShapes, WhatIsClearButNotWideIsKept) {
  ShapeThresholds thresholds;
  thresholds.min_crease = 0.3;
  const Found crease = spreads_of({0.0, 0.2, 0.8}, Structure::Planar, 8.0f, thresholds);
  EXPECT_FALSE(crease.any);
  EXPECT_NEAR(crease.spreads[5].weight, 0.2f, 1e-5f);
  const Found corner = spreads_of({0.1, 0.2, 0.7}, Structure::Planar, 8.0f, thresholds);
  EXPECT_EQ(corner.structures[5], Structure::Planar);
  std::mt19937 generator(5);
  EXPECT_TRUE(may_spread(normals_with(generator, {0.0, 0.2, 0.8}), thresholds));
}

TEST(WindowShapes, LinesAndFewNormalsHaveNoSpread) {
  for (const Found& found :
       {spreads_of({0.0, 0.2, 0.8}, Structure::Edge, 8.0f), spreads_of({0.1, 0.2, 0.7}, Structure::Edge, 8.0f)}) {
    EXPECT_FALSE(found.any);
    EXPECT_EQ(found.spreads[5].weight, 0.0f);
    EXPECT_EQ(found.structures[5], Structure::Edge);
  }
  const Found few = spreads_of({0.1, 0.2, 0.7}, Structure::Planar, 7.0f);
  EXPECT_EQ(few.spreads[5].weight, 0.0f);
  EXPECT_EQ(few.structures[5], Structure::Planar);
}

// Windows of too few points may have any direction.
TEST(WindowShapes, WhatHasNoStructureHasNoDirection) {
  StructureBatch structures = {};
  VectorBatch directions = {};
  std::fill_n(directions.x, kBatch, std::nanf(""));
  structures[1] = static_cast<std::int32_t>(Structure::Planar), directions.x[1] = 0.0f, directions.z[1] = -1.0f;
  structures[2] = static_cast<std::int32_t>(Structure::Edge), directions.x[2] = 0.0f, directions.y[2] = 1.0f;
  structures[3] = static_cast<std::int32_t>(Structure::Planar), directions.x[3] = 0.0f;  // no direction
  structures[4] = static_cast<std::int32_t>(Structure::Edge);                            // sums that overflowed
  Direction shapes[kBatch];
  Structure found[kBatch];
  write_shapes(structures, directions, 5, shapes, found);
  const auto expect = [&](int k, Structure structure, const Vec3f& direction, float weight) {
    EXPECT_EQ(found[k], structure) << k;
    EXPECT_EQ(Vec3f(shapes[k].xyz), direction) << k;
    EXPECT_EQ(shapes[k].weight, weight) << k;
  };
  expect(0, Structure::None, Vec3f::Zero(), 0.0f);
  expect(1, Structure::Planar, -Vec3f::UnitZ(), 1.0f);
  expect(2, Structure::Edge, Vec3f::UnitY(), 0.0f);
  expect(3, Structure::None, Vec3f::Zero(), 0.0f);
  expect(4, Structure::None, Vec3f::Zero(), 0.0f);
}

}  // namespace
}  // namespace augicp
