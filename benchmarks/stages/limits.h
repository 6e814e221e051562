// SPDX-License-Identifier: MIT
// What one core of this machine can do at best, measured, and what a stage would take at that rate.
#pragma once

namespace augicp::bench {

struct Limits {
  double bytes_per_s = 0.0;   // from and to memory: a[i] = b[i] + c[i] over arrays beyond the caches
  double floats_per_s = 0.0;  // float additions and multiplications in registers, with AVX2 where the machine has it
};

// Takes about a second.
Limits measure_limits();

// The same with fused multiplications and additions, which augicp does not use: 0 where the machine has none.
double fused_floats_per_s();

}  // namespace augicp::bench
