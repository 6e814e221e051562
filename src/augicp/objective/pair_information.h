// SPDX-License-Identifier: MIT
// Omega^p and Omega^l of a batch of pairs, from the structures, directions and weights of one or both points.
#pragma once

#include <cstdint>

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

// One column of Table 2 in float. For Sides::Target the numbers are information; for Sides::Both they are variances,
// and the information is `scale` times the inverse of a sum of them.
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

}  // namespace augicp
