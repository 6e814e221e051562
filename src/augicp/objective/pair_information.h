// SPDX-License-Identifier: MIT
// Omega^p and Omega^l of a batch of pairs, from the structures, directions and weights of one or both points.
#pragma once

#include <cstdint>
#include <span>

#include "augicp/cloud/correspondence.h"
#include "augicp/objective/information.h"
#include "augicp/objective/pair_batch.h"

namespace augicp {

// A number for each Structure.
struct ByStructure {
  float none, planar, edge;
  float of(std::int32_t structure) const {
    return structure == static_cast<std::int32_t>(Structure::Planar) ? planar
           : structure == static_cast<std::int32_t>(Structure::Edge) ? edge
                                                                     : none;
  }
};

// One column of Table 2 in float. For Sides::Both the numbers are variances, and the information is `scale` times the
// inverse of a sum of them. Otherwise they are information.
struct InformationTable {
  ByStructure along, across;
  float scale;
  Sides sides;
};

// `unit` is a number of the order of the model's largest information. A part that is zero throughout stays zero.
InformationTable information_table(const InformationModel& model, Information StructureInformation::*part, Sides sides,
                                   double unit);

// Set position_information; direction_information and compares. The batch is moved already.
void weigh_positions(const InformationTable& table, PairBatch& batch);
void weigh_directions(const InformationTable& table, PairBatch& batch);

// Eq. (2): sets position_information to the Gaussians' of the pairs' target points, times per_unit.
void weigh_by_gaussians(std::span<const PointGaussian> of_target, std::span<const Correspondence> pairs, float per_unit,
                        PairBatch& batch);

}  // namespace augicp
