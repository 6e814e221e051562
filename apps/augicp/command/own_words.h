// SPDX-License-Identifier: MIT
// Messages of CLI11 and of the library, in words that name the option and the remedy.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace augicp::app {

// As a user writes it: "augicp experiment basin".
std::string full_name(const CLI::App& command);

// What CLI11 found wrong with the words for this command. A sentence without its full stop.
std::string in_own_words(const CLI::App& command, const CLI::ParseError& error);

// The library's "num_threads = -1.000000: must be ..." in the words of the subcommand that was called: "--threads -1:
// must be ...". The option is the one with that value, also in degrees or percent; of several the one with the name.
// Messages that fit no option are left as they are.
std::string in_words_of_options(const CLI::App& app, const std::string& message);

}  // namespace augicp::app
