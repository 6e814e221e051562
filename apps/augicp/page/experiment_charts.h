// SPDX-License-Identifier: MIT
// Curves from the rows of the experiments.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "apps/augicp/page/chart.h"
#include "augicp/experiment/basin.h"
#include "augicp/experiment/sequence_errors.h"
#include "augicp/experiment/synthetic.h"
#include "augicp/experiment/verdict.h"

namespace augicp::app {

struct Quantity {
  std::string name;
  std::vector<Chart> charts;  // each with the same series
};

std::vector<Quantity> synthetic_quantities(const std::vector<SyntheticRow>& rows);
std::vector<Quantity> sequence_quantities(std::span<const SequenceCurve> curves, const Trajectory& truth,
                                          const std::vector<double>& time_offsets_s);
std::vector<Quantity> basin_quantities(const std::vector<BasinCell>& cells);
std::vector<Quantity> verdict_quantities(std::span<const VerdictPair> pairs);

}  // namespace augicp::app
