// SPDX-License-Identifier: MIT
// Table 2: how much each part of a pair's error counts, as two numbers and a direction, never a stored matrix.
#pragma once

#include <array>

#include "augicp/cloud/cloud.h"

namespace augicp {

// Omega = across * I + (along - across) d d^T, with d the unit direction of a point.
struct Information {
  double along = 0.0;
  double across = 0.0;
};

// One row of Table 2.
struct StructureInformation {
  Information position;   // Omega^p, per square metre
  Information direction;  // Omega^l
};

// Where the information of a pair comes from.
enum class Sides {
  Target,  // Table 2: Omega_i of the target point alone

  // Of positions only: Eq. (2), as NDT has it. The error is that from the mean of the target point's Gaussian, and
  // Omega is the inverse of its covariance. REQUIRES: the target has Gaussians (Cloud::gaussians).
  TargetGaussian,

  // Both points': (Omega_i^-1 + R Omega_j^-1 R^T)^-1, as GICP has it (Segal, Haehnel and Thrun 2009). Where the
  // directions agree it is half of Omega_i. Where they differ by an angle a, the information along a normal falls by
  // epsilon / sin^2 a: such a pair is not believed, and no kernel is needed for that. Steps take it for constant.
  // Clouds without directions have the target's alone.
  Both,
};

// What the methods differ in, and all they differ in.
struct InformationModel {
  StructureInformation none, planar, edge;
  Sides position_sides = Sides::Target, direction_sides = Sides::Target;

  const StructureInformation& of(Structure structure) const {
    return structure == Structure::Planar ? planar : structure == Structure::Edge ? edge : none;
  }

  // Throws std::invalid_argument unless every number is finite and at least 0. Directions have no Gaussian. With both
  // sides every number of a part is above 0, or all of a row's direction are 0: what has no information has no
  // covariance.
  void check() const;
};

// The softening of Table 2: information of a plane across its normal, and of an edge along its tangent, is this part of
// the other.
inline constexpr double kTable2Epsilon = 1e-3;

InformationModel point_information();                                     // ICP: every direction counts alike
InformationModel plane_information();                                     // distance to the plane or to the edge only
InformationModel gicp_information(double epsilon = kTable2Epsilon);       // Omega^p of Table 2, Omega^l = 0
InformationModel augmented_information(double epsilon = kTable2Epsilon);  // Table 2 as printed

// The default: Table 2, but an edge's position counts no more than that of a point without structure. Table 2 lets it
// count fully across its tangent, which is right for a point on the crease itself; those within a ball of it, which the
// classifier cannot tell from it, would then pull along their surface as in plain ICP (docs/lab/results.md has the
// figures).
InformationModel default_information(double epsilon = kTable2Epsilon);

// The model with the positions' information from both points.
InformationModel with_both_sides(const InformationModel& model);

// NDT: the Gaussians' information. The model's numbers are those of a disc as wide as its ball, for the test of free
// motions; they must be in the unit of the Gaussians.
InformationModel ndt_information(double epsilon = kTable2Epsilon);

// The model with its linear part for a lever: an error of the direction by one radian counts as much as one of the
// position by lever metres, each in the direction it knows best. Table 2 as printed has a lever of 1 m, whatever the
// size of the scene.
InformationModel with_lever(const InformationModel& model, double lever_m);

// The same model without its linear part.
inline InformationModel positions_only(const InformationModel& model) { return with_lever(model, 0.0); }

}  // namespace augicp
