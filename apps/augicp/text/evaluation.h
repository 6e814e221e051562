// SPDX-License-Identifier: MIT
// How far a trajectory is from the truth, for people and for programs: what `evaluate` prints, and who else has both.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "augicp/eval/evaluate.h"

namespace augicp::app {

// Some lines and a table.
std::string evaluation_text(const Evaluation& evaluation);

// All of it; the fields are explained in docs/evaluation.md.
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation);

}  // namespace augicp::app
