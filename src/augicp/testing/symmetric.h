// SPDX-License-Identifier: MIT
// Eigenvalues of symmetric matrices, compiled once: each file of tests that decomposes one itself takes ten seconds
// longer to compile under sanitizers.
#pragma once

#include "augicp/core/types.h"

namespace augicp::testing {

// Ascending.
Vec6d eigenvalues_of(const Mat6d& symmetric);

// The positive semidefinite root. Negative eigenvalues count as zero.
Mat6d sqrt_of(const Mat6d& symmetric);

}  // namespace augicp::testing
