// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>  // defines __GLIBC__ on glibc

// Marks a function that is compiled twice more, for AVX2 and for AVX-512. The loader picks the version for the machine.
// Results are bit-identical: no additions are reordered, and none are fused with multiplications. The loader picks
// before sanitizers are initialised, so builds with sanitizers have the plain version only.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(AUGICP_NO_AVX2)
#if __GNUC__ >= 12 && !defined(AUGICP_NO_AVX512)
#define AUGICP_VECTORIZED [[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#define AUGICP_HAS_AVX512
#else
#define AUGICP_VECTORIZED [[gnu::target_clones("avx2", "default")]]
#endif
#define AUGICP_HAS_AVX2
#else
#define AUGICP_VECTORIZED
#endif

// Inlined into functions that are compiled for several instruction sets, so compiled for each of them.
#define AUGICP_INLINE [[gnu::always_inline]] inline
