// SPDX-License-Identifier: MIT
// Errors of a trajectory, as text and as JSON: the output of `evaluate`, and a part of that of other subcommands.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "augicp/eval/evaluate.h"

namespace augicp::app {

// Whether both trajectories are in one frame: errors without alignment mean something only then.
bool shares_frame(const Evaluation& evaluation);

// What the errors leave out, a sentence each.
std::vector<std::string> coverage_warnings(const Coverage& coverage);

// Some lines and a table.
std::string evaluation_text(const Evaluation& evaluation);

// All of it; docs/evaluation.md explains the fields.
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation);

}  // namespace augicp::app
