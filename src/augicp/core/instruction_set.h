// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace augicp {

// The instructions that vectorized functions (core/vectorized.h) use on this machine: "AVX-512", "AVX2" or "baseline".
// Results do not depend on it. Thread safety: may be called concurrently.
std::string_view instruction_set();

}  // namespace augicp
