// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>  // also says whether this is glibc

// Before a function whose loops are worth it: it is compiled once more for AVX2, and the program takes the one its machine
// can run. Both give the same bits, because no additions are reordered and none are fused with multiplications. The
// choice is made by the loader, before sanitizers are up, so builds with those have the plain one only.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(AUGICP_NO_AVX2)
#define AUGICP_VECTORIZED [[gnu::target_clones("avx2", "default")]]
#else
#define AUGICP_VECTORIZED
#endif
