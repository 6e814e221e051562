// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

enum ExitCode {
  kSuccess = 0,
  kInternalError = 1,
  kUsage = 2,
  kInvalidInput = 3,
  kRegistrationFailed = 4,
  kDoubtful = 5,
};

// Each adds its subcommand; when that was chosen, its exit code is in exit_code after parsing.
void add_align_command(CLI::App& app, int& exit_code);
void add_evaluate_command(CLI::App& app, int& exit_code);
void add_experiment_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_odometry_command(CLI::App& app, int& exit_code);
void add_surface_command(CLI::App& app, int& exit_code);

}  // namespace augicp::app
