// SPDX-License-Identifier: MIT
// Convergence experiments, as CSV and as text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "augicp/experiment/basin.h"
#include "augicp/experiment/sequence_errors.h"
#include "augicp/experiment/synthetic.h"
#include "augicp/experiment/time_offset.h"

namespace augicp::app {

// CSV with a header line; lengths in metres, angles in degrees, numbers that read back bit-identically.
std::string synthetic_csv(const std::vector<SyntheticRow>& rows);
std::string sequence_csv(std::span<const SequenceCurve> curves, const Trajectory& truth,
                         const std::vector<double>& time_offsets_s);
std::string curves_csv(std::span<const SequenceCurve> curves, const Trajectory& truth,
                       const std::vector<double>& time_offsets_s);
std::string basin_csv(const std::vector<BasinCell>& cells);

// As text.
std::string time_offset_text(const TimeOffset& found);
std::string basin_text(const std::vector<BasinCell>& cells, const BasinOptions& options);

}  // namespace augicp::app
