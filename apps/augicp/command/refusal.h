// SPDX-License-Identifier: MIT
// What a user sees who has not yet found the right words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace augicp::app {

// Every subcommand with what it does and the first examples of its help.
std::string overview(const CLI::App& app);

// Why these arguments were refused, and what to write: the name that a mistyped subcommand or option resembles, or the
// place where the option belongs, or else CLI11's own message with an example.
std::string refusal(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error);

}  // namespace augicp::app
