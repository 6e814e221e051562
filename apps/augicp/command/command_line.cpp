// SPDX-License-Identifier: MIT
#include "apps/augicp/command/command_line.h"

#include <fmt/core.h>

#include <string>

#include "apps/augicp/command/align.h"
#include "apps/augicp/command/evaluate.h"
#include "apps/augicp/command/experiment.h"
#include "apps/augicp/command/info.h"
#include "apps/augicp/command/number_checks.h"
#include "apps/augicp/command/odometry.h"
#include "apps/augicp/command/surface.h"
#include "apps/augicp/command/unpack.h"
#include "apps/augicp/command/version.h"

namespace augicp::app {
namespace {

// CLI11 takes any text after an option as its value; `--json --quiet` would write a file of that name.
void refuse_options_as_values(CLI::App& app) {
  const CLI::Validator no_option(
      [](const std::string& value) {
        return value.starts_with("--")
                   ? fmt::format("expected a value, found {} (a file of that name is ./{})", value, value)
                   : std::string();
      },
      "");
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0 && !option->get_positional()) option->check(no_option);
  for (CLI::App* subcommand : app.get_subcommands({})) refuse_options_as_values(*subcommand);
}

}  // namespace

void set_up_command_line(CLI::App& app, int& exit_code) {
  app.description(
      "Rigid registration of 3D point clouds with augmented measurements: positions, normals and tangents.");
  app.set_version_flag("-V,--version", version_text, "Print version, commit, compiler and instructions, and exit");
  app.set_config("--config", "", "Read options from a TOML file, a section for each subcommand; flags win over it");
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 success, 1 internal error, 2 usage, 3 unreadable input or unwritable output, 4 registration "
      "failed,\n"
      "            5 result found but degenerate, doubtful or ambiguous, 130 interrupted, 143 terminated.");
  add_align_command(app, exit_code);
  add_evaluate_command(app, exit_code);
  add_experiment_command(app, exit_code);
  add_info_command(app, exit_code);
  add_odometry_command(app, exit_code);
  add_surface_command(app, exit_code);
  add_unpack_command(app, exit_code);
  refuse_options_as_values(app);
  check_numbers(app);
}

}  // namespace augicp::app
