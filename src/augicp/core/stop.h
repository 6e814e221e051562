// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>

#include "augicp/core/error.h"

namespace augicp {

// Throws Interrupted if an end was requested. Called between the steps of long work, in the caller's thread or in a
// thread of a parallel loop, which forwards the exception. A token without a source never requests an end.
inline void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Interrupted();
}

}  // namespace augicp
