// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>

#include "augicp/core/error.h"

namespace augicp {

// Throws Interrupted if an end was asked for. Called between the steps of long work, in the caller's thread or in one
// of a parallel loop, which hands the exception on. A token that belongs to no source never asks.
inline void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Interrupted();
}

}  // namespace augicp
