// SPDX-License-Identifier: MIT
#include "augicp/objective/information.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace augicp {
namespace {

void expect_is(const Information& information, double along, double across) {
  EXPECT_DOUBLE_EQ(information.along, along);
  EXPECT_DOUBLE_EQ(information.across, across);
}

TEST(Information, AugmentedIsTable2) {
  const InformationModel table2 = augmented_information();
  expect_is(table2.planar.position, 1000.0, 1.0);
  expect_is(table2.planar.direction, 1.0, 1000.0);
  expect_is(table2.edge.position, 1.0, 1000.0);
  expect_is(table2.edge.direction, 1.0, 1000.0);
  expect_is(table2.none.position, 1.0, 1.0);
  expect_is(table2.none.direction, 0.0, 0.0);
}

TEST(Information, OtherMethodsDifferInNumbersOnly) {
  const InformationModel table2 = augmented_information(0.01), gicp = gicp_information(0.01),
                         point = point_information();
  for (Structure structure : {Structure::None, Structure::Planar, Structure::Edge}) {
    expect_is(gicp.of(structure).position, table2.of(structure).position.along, table2.of(structure).position.across);
    expect_is(gicp.of(structure).direction, 0.0, 0.0);
    expect_is(point.of(structure).position, 1.0, 1.0);
    expect_is(point.of(structure).direction, 0.0, 0.0);
  }
  const InformationModel plane = plane_information();
  expect_is(plane.planar.position, 1.0, 0.0);
  expect_is(plane.edge.position, 0.0, 1.0);
  expect_is(plane.none.position, 0.0, 0.0);
}

TEST(Information, DefaultDiffersFromTable2InAnEdgesPositionOnly) {
  const InformationModel ours = default_information(), table2 = augmented_information();
  expect_is(ours.edge.position, 1.0, 1.0);
  expect_is(ours.edge.direction, table2.edge.direction.along, table2.edge.direction.across);
  expect_is(ours.planar.position, table2.planar.position.along, table2.planar.position.across);
  expect_is(ours.planar.direction, table2.planar.direction.along, table2.planar.direction.across);
}

// Twice the lever: an error of the direction is worth twice the distance, four times the chi2.
TEST(Information, LeverScalesTheLinearPartByItsSquare) {
  const InformationModel scaled = with_lever(augmented_information(), 2.0);
  expect_is(scaled.planar.position, 1000.0, 1.0);
  expect_is(scaled.planar.direction, 4.0, 4000.0);
  expect_is(scaled.edge.direction, 4.0, 4000.0);
  expect_is(positions_only(augmented_information()).planar.direction, 0.0, 0.0);
}

TEST(Information, WithoutInformationThereIsNoCovarianceToAdd) {
  EXPECT_THROW(with_both_sides(plane_information()).check(), std::invalid_argument);
  EXPECT_NO_THROW(with_both_sides(gicp_information()).check());
  EXPECT_NO_THROW(ndt_information().check());
  InformationModel of_directions = augmented_information();
  of_directions.direction_sides = Sides::TargetGaussian;
  EXPECT_THROW(of_directions.check(), std::invalid_argument);
  InformationModel model = augmented_information();
  model.direction_sides = Sides::Both;
  EXPECT_NO_THROW(model.check());
  EXPECT_NO_THROW(positions_only(model).check());
  model.edge.direction.along = 0.0;
  EXPECT_THROW(model.check(), std::invalid_argument);
}

TEST(Information, BadNumbersAreRefused) {
  for (double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    InformationModel model = augmented_information();
    model.edge.direction.across = bad;
    EXPECT_THROW(model.check(), std::invalid_argument);
    model = augmented_information();
    model.none.position.along = bad;
    EXPECT_THROW(model.check(), std::invalid_argument);
    EXPECT_THROW(gicp_information(bad), std::invalid_argument);
    EXPECT_THROW(with_lever(model, bad), std::invalid_argument);
  }
  EXPECT_THROW(gicp_information(0.0), std::invalid_argument);
  EXPECT_NO_THROW(plane_information().check());
}

}  // namespace
}  // namespace augicp
