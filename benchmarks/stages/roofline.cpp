// SPDX-License-Identifier: MIT
// Prints what one core of this machine can do at best.
#include <cstdio>

#include "benchmarks/stages/limits.h"

int main() {
  const augicp::bench::Limits limits = augicp::bench::measure_limits();
  std::printf("memory                       %7.1f GB/s\n", limits.bytes_per_s * 1e-9);
  std::printf("float multiply, add          %7.1f GFLOP/s\n", limits.floats_per_s * 1e-9);
  std::printf("float fused multiply-add     %7.1f GFLOP/s, not used: see docs/architecture.md\n",
              augicp::bench::fused_floats_per_s() * 1e-9);
}
