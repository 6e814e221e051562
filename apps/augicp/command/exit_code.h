// SPDX-License-Identifier: MIT
#pragma once

namespace augicp::app {

enum ExitCode {
  kSuccess = 0,
  kInternalError = 1,
  kUsage = 2,
  kInvalidInput = 3,
  kRegistrationFailed = 4,
  kDoubtful = 5,
};

}  // namespace augicp::app
