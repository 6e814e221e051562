// SPDX-License-Identifier: MIT
// What `augicp experiment ... --report` shows: a grid of curves for each quantity.
#pragma once

#include <string>
#include <vector>

#include "apps/augicp/report_experiment.h"
#include "augicp/report/chart.h"

namespace augicp::app {

struct Quantity {
  std::string name;
  std::vector<Chart> charts;  // with the same series each
};

std::vector<Quantity> synthetic_quantities(const std::vector<SyntheticRow>& rows);
std::vector<Quantity> sequence_quantities(std::span<const SequenceCurve> curves, const Trajectory& truth,
                                          const std::vector<double>& time_offsets_s);
std::vector<Quantity> basin_quantities(const std::vector<BasinCell>& cells);
std::vector<Quantity> verdict_quantities(std::span<const VerdictPair> pairs);

// table: HTML below the curves. Nothing for an empty path: no page was asked for.
void write_experiment_page(const std::string& path, const std::vector<std::string>& lines,
                           std::vector<Quantity> quantities, const std::string& table = {});

std::string confusion_html(const std::vector<ConfusionRow>& rows);

}  // namespace augicp::app
