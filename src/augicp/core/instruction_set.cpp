// SPDX-License-Identifier: MIT
#include "augicp/core/instruction_set.h"

#include "augicp/core/vectorized.h"

namespace augicp {

std::string_view instruction_set() {
#ifdef AUGICP_HAS_AVX512
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return "AVX-512";
#endif
#ifdef AUGICP_HAS_AVX2
  if (__builtin_cpu_supports("avx2")) return "AVX2";
#endif
  return "baseline";
}

}  // namespace augicp
