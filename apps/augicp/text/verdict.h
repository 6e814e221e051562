// SPDX-License-Identifier: MIT
// The experiment on the verdict, as CSV and as text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "augicp/experiment/verdict.h"

namespace augicp::app {

// CSV with a header line; lengths in metres, angles in degrees.
std::string verdict_csv(std::span<const VerdictPair> pairs);
std::string roc_csv(const std::vector<RocPoint>& points);

// As text.
std::string confusion_text(const std::vector<ConfusionRow>& rows);

}  // namespace augicp::app
