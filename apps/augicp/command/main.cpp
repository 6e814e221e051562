// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "apps/augicp/command/command_line.h"
#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/own_words.h"
#include "apps/augicp/command/refusal.h"
#include "augicp/core/error.h"
#include "augicp/registration/memory.h"

namespace augicp::app {
namespace {

int fail(const char* message, ExitCode code) {
  fmt::print(stderr, "augicp: {}\n", message);
  return code;
}

int fail_to_print() { return fail("standard output cannot be written", kInvalidInput); }

int run(int argc, char** argv) {
  CLI::App app;
  int exit_code = kSuccess;
  set_up_command_line(app, exit_code);
  if (argc <= 1) {
    fmt::print("{}", overview(app));
    return fail("a subcommand is required", kUsage);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
      return app.exit(error);  // --help, --version
    fmt::print(stderr, "{}", refusal(app, {argv + 1, argv + argc}, error));
    return kUsage;
  } catch (const TooMuchMemory&) {
    throw;
  } catch (const std::invalid_argument& error) {
    return fail(in_words_of_options(app, error.what()).c_str(), kUsage);
  }
  return exit_code;
}

}  // namespace
}  // namespace augicp::app

int main(int argc, char** argv) {
  using namespace augicp::app;
  try {
    end_on_signals();
    const int code = run(argc, argv);
    // A full disk behind a redirection must not look like success.
    return std::fflush(stdout) == 0 && !std::ferror(stdout) ? code : fail_to_print();
  } catch (const augicp::IoError& error) {
    return fail(error.what(), kInvalidInput);
  } catch (const augicp::TooMuchMemory& error) {
    return fail(error.message({"--voxel-size", "--radius", "--max-memory"}).c_str(), kUsage);
  } catch (const std::invalid_argument& error) {
    return fail(error.what(), kUsage);
  } catch (const std::exception& error) {
    return std::ferror(stdout) ? fail_to_print() : fail(error.what(), kInternalError);  // printing much throws
  }
}
