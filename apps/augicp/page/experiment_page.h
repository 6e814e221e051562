// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/augicp/page/experiment_charts.h"

namespace augicp::app {

// The HTML of `augicp experiment ... --report`: a grid of curves for each quantity. table: HTML below the curves.
std::string experiment_page(const std::vector<std::string>& lines, std::vector<Quantity> quantities,
                            const std::string& table = {});

std::string confusion_html(const std::vector<ConfusionRow>& rows);

}  // namespace augicp::app
