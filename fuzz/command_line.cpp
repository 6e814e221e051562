// SPDX-License-Identifier: MIT
// The command's options, without the work behind them. The input is a configuration file after an empty line, and
// arguments before it, one a line.
#include "apps/augicp/command/command_line.h"

#include <sstream>
#include <string>
#include <vector>

#include "fuzz/promises.h"

namespace {

// Ends the parsing where the work would begin.
[[noreturn]] void stop_before_the_work() { throw CLI::Success(); }

// Only what the input holds is read as configuration, not a file it names.
bool names_a_file(const std::string& argument) { return argument.starts_with("--config"); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream input(std::string(data, data + size));
  std::vector<std::string> arguments;
  for (std::string line; std::getline(input, line) && !line.empty();)
    if (!names_a_file(line)) arguments.insert(arguments.begin(), line);  // CLI11 takes them from the back
  CLI::App app;
  int exit_code = 0;
  augicp::app::set_up_command_line(app, exit_code);
  app.parse_complete_callback(stop_before_the_work);
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    augicp::fuzz::expect(app.exit(error, out, err) == 0 || !err.str().empty(), "wrong usage is explained");
  }
  try {
    app.parse_from_stream(input);
  } catch (const CLI::ParseError&) {
  }
  return 0;
}
