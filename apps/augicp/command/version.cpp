// SPDX-License-Identifier: MIT
#include "apps/augicp/command/version.h"

#include <fmt/core.h>

#include <string_view>

#include "apps/augicp/command/commit.h"
#include "apps/augicp/page/report_bundle.h"
#include "augicp/core/instruction_set.h"

namespace augicp::app {

std::string version_text() {
  const std::string_view commit = kCommit;
  return fmt::format("augicp {}\ncommit        {}\ncompiler      {}\ninstructions  {}\nreports       {}",
                     AUGICP_VERSION, commit.empty() ? "unknown" : commit, kCompiler, instruction_set(),
                     report_bundle().script.empty() ? "without 3D views: built without Node" : "with 3D views");
}

}  // namespace augicp::app
