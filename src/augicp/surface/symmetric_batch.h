// SPDX-License-Identifier: MIT
// Eigenvalues and eigenvectors of many symmetric 3 x 3 matrices at once, in closed form: what eigen_of_symmetric() does
// for one, to float's accuracy. Elements lie in arrays, one entry a matrix, so that compilers make vectors of them.
#pragma once

namespace augicp {

inline constexpr int kBatch = 32;

using BatchArray = float[kBatch];

struct SymmetricBatch {
  alignas(64) BatchArray xx, xy, xz, yy, yz, zz;
};

// l0 <= l1 <= l2, none negative, of positive semidefinite matrices; to some 1e-6 of their sum, and where two are closer
// than 1e-3 of it to each other, to the 3e-4 of it that tell them apart.
struct EigenvalueBatch {
  alignas(64) BatchArray l0, l1, l2;
};
void eigenvalues(const SymmetricBatch& matrices, EigenvalueBatch& values);

// Unit eigenvectors, of either sign, to given eigenvalues; zero where that eigenvalue has no single direction.
struct VectorBatch {
  alignas(64) BatchArray x, y, z;
};
void eigenvectors(const SymmetricBatch& matrices, const BatchArray& eigenvalue, VectorBatch& vectors);

}  // namespace augicp
