// SPDX-License-Identifier: MIT
// How far trajectories drift, as text and as JSON: KITTI's errors over segments, errors against known motions, and a
// table of several estimates. docs/evaluation.md explains the fields.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "augicp/eval/evaluate.h"
#include "augicp/eval/pair_errors.h"

namespace augicp::app {

std::string segments_text(const SegmentErrors& errors);
nlohmann::ordered_json segments_json(const SegmentErrors& errors);  // null without a segment

// num_pairs: how many motions are known; the estimate may be shorter.
std::string gaps_text(std::span<const GapError> errors, std::size_t num_pairs);
nlohmann::ordered_json gaps_json(std::span<const GapError> errors);

// An estimate, and its errors against what is known of the truth.
struct Compared {
  std::string estimate;  // the file, as named
  std::optional<Evaluation> evaluation;
  std::optional<std::vector<GapError>> of_gap;
  std::uint64_t num_repeated_estimate = 0, num_repeated_truth = 0;  // poses left out, see TrajectoryFile
};

// A line for each estimate.
std::string comparison_text(std::span<const Compared> estimates);

}  // namespace augicp::app
