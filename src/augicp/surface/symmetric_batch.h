// SPDX-License-Identifier: MIT
// Eigenvalues and eigenvectors of many symmetric 3 x 3 matrices at once, in closed form: eigen_of_symmetric() to the
// accuracy of float. Elements are arrays with one entry per matrix, so that compilers vectorise.
#pragma once

namespace augicp {

inline constexpr int kBatch = 32;

using BatchArray = float[kBatch];

struct SymmetricBatch {
  alignas(64) BatchArray xx, xy, xz, yy, yz, zz;
};

// l0 <= l1 <= l2, all at least 0, of positive semidefinite matrices. Accuracy: 1e-6 of their sum. If two are closer
// than 1e-3 of the sum to each other: 3e-4 of the sum.
struct EigenvalueBatch {
  alignas(64) BatchArray l0, l1, l2;
};
void eigenvalues(const SymmetricBatch& matrices, EigenvalueBatch& values);

// Unit eigenvectors of given eigenvalues, of either sign; zero if that eigenvalue has no single direction.
struct VectorBatch {
  alignas(64) BatchArray x, y, z;
};
void eigenvectors(const SymmetricBatch& matrices, const BatchArray& eigenvalue, VectorBatch& vectors);

}  // namespace augicp
