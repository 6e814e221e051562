// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

// Makes every option of the command and its subcommands that takes numbers refuse what is none: signs of counts, NaN,
// numbers that no variable can hold. CLI11 takes -1 for a count of 1.8e19, and 010 for 8. REQUIRES: all options are
// there.
void check_numbers(CLI::App& app);

}  // namespace augicp::app
