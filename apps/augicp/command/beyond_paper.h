// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "augicp/registration/options.h"

namespace augicp::app {

// Brightness as a third measurement, for the subcommands whose inputs have any.
inline void add_intensity(CLI::App& command, RegistrationOptions& options) {
  command
      .add_flag("--intensity,!--no-intensity", options.intensity,
                "Brightness counts too, where both inputs have it (default: off)")
      ->group("Beyond the paper");
}

// What of a registration goes beyond the paper's loop can be switched off, or on where it is off.
inline void add_beyond_paper(CLI::App& command, RegistrationOptions& options) {
  const std::string group = "Beyond the paper";
  const auto add = [&](const std::string& name, bool& value, const std::string& text) {
    command.add_flag("--" + name + ",!--no-" + name, value, text + (value ? " (default: on)" : " (default: off)"))
        ->group(group);
  };
  add("search", options.search, "Other guesses are tried where the given one leads nowhere convincing");
  add("coarse-to-fine", options.coarse_to_fine, "Large images are aligned thinned first");
  add("rolling-shutter", options.rolling_shutter, "What a rolling shutter bends is straightened");
}

}  // namespace augicp::app
