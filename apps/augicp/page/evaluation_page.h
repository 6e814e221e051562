// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "augicp/eval/evaluate.h"

namespace augicp::app {

struct EvaluatedRun {
  std::string name;
  Trajectory estimate, truth;  // truth: with the stamps that it was compared at
  Evaluation evaluation;
};

// The HTML of `augicp evaluate --report`: one or several estimates over the ground truth of the first, each aligned to
// it, with their errors over time. REQUIRES: at least one run.
std::string evaluation_page(const std::string& truth_name, const std::vector<EvaluatedRun>& runs);

}  // namespace augicp::app
