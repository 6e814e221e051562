// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>  // also says whether this is glibc

// Before a function whose loops are worth it: it is compiled twice more, for AVX2 and for AVX-512, and the program
// takes the one its machine can run. All give the same bits, because no additions are reordered and none are fused with
// multiplications. The choice is made by the loader, before sanitizers are up, so builds with those have the plain one
// only.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(AUGICP_NO_AVX2)
#if __GNUC__ >= 12 && !defined(AUGICP_NO_AVX512)
#define AUGICP_VECTORIZED [[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#else
#define AUGICP_VECTORIZED [[gnu::target_clones("avx2", "default")]]
#endif
#else
#define AUGICP_VECTORIZED
#endif

// Inlined into functions that are compiled for several instruction sets, so that it is compiled for each of them too.
#define AUGICP_INLINE [[gnu::always_inline]] inline
