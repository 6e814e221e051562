// SPDX-License-Identifier: MIT
#include "augicp/align/damped_step.h"

#include <gtest/gtest.h>

#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

NormalEquations some_equations(double metres_per_unit = 1.0) {
  Cloud source = testing::random_extended_points(100, 1.0, 1), target = testing::random_extended_points(100, 1.0, 2);
  for (Cloud* cloud : {&source, &target})
    for (Vec3f& point : cloud->points) point /= static_cast<float>(metres_per_unit);
  // The linear part has no unit; for the position to weigh alike against it, information changes by the square.
  InformationModel model = augmented_information();
  for (StructureInformation* row : {&model.none, &model.planar, &model.edge}) {
    row->position.along *= metres_per_unit * metres_per_unit;
    row->position.across *= metres_per_unit * metres_per_unit;
  }
  return linearize({source, target, testing::random_pairs(300, 100, 3), Rigid3{}}, {model}, 1);
}

TEST(DampedStep, SolvesTheSystem) {
  const NormalEquations equations = some_equations();
  const Vec6d step = damped_step(equations, 0.0);
  EXPECT_LE((equations.H * step + equations.b).norm(), 1e-10 * equations.b.norm());
}

TEST(DampedStep, GoesDownhill) {
  const NormalEquations equations = some_equations();
  for (double damping : {0.0, 1e-3, 1.0, 100.0}) EXPECT_LT(damped_step(equations, damping).dot(equations.b), 0.0);
}

TEST(DampedStep, DampingIsAShareOfEachBlocksMeanDiagonal) {
  const NormalEquations equations = some_equations();
  const double damping = 0.3;
  Mat6d damped = equations.H;
  for (int i = 0; i < 3; ++i) {
    damped(i, i) += damping * (equations.H(0, 0) + equations.H(1, 1) + equations.H(2, 2)) / 3.0;
    damped(i + 3, i + 3) += damping * (equations.H(3, 3) + equations.H(4, 4) + equations.H(5, 5)) / 3.0;
  }
  EXPECT_LE((damped * damped_step(equations, damping) + equations.b).norm(), 1e-10 * equations.b.norm());
}

TEST(DampedStep, MoreDampingMakesShorterSteps) {
  const NormalEquations equations = some_equations();
  EXPECT_LT(damped_step(equations, 1.0).norm(), damped_step(equations, 0.1).norm());
  EXPECT_LT(damped_step(equations, 1e6).norm(), 1e-5);
}

TEST(DampedStep, SameMotionWhateverTheUnitOfLength) {
  for (double damping : {0.0, 0.1, 1.0}) {
    const Vec6d in_metres = damped_step(some_equations(), damping);
    const Vec6d in_millimetres = damped_step(some_equations(1e-3), damping);
    EXPECT_LE((1e-3 * in_millimetres.head<3>() - in_metres.head<3>()).norm(), 1e-6 * in_metres.head<3>().norm());
    EXPECT_LE((in_millimetres.tail<3>() - in_metres.tail<3>()).norm(), 1e-6 * in_metres.tail<3>().norm());
  }
}

// One plane constrains three of the six motions; damping keeps the others at zero.
TEST(DampedStep, WhatTheDataDoNotFixStaysStill) {
  NormalEquations equations;
  equations.H.diagonal() << 0.0, 0.0, 4.0, 2.0, 2.0, 0.0;
  equations.b << 0.0, 0.0, 4.0, 2.0, 0.0, 0.0;
  const Vec6d step = damped_step(equations, 1e-6);
  Vec6d expected;
  expected << 0.0, 0.0, -1.0, -1.0, 0.0, 0.0;
  EXPECT_LE((step - expected).norm(), 1e-5);
}

}  // namespace
}  // namespace augicp
