#pragma once

#include "core/vector.h"

namespace drape {

// Eigenvalues in no order, and an orthonormal eigenvector of each as a column.
struct SymmetricEigen {
  Vec3 values;
  Mat3 vectors;
};

// Of a symmetric matrix of finite values, by Jacobi's rotations (Golub and Van Loan, 8.5), to a few units in
// the last place of the largest value. Eigen's own solver rounds otherwise under another compiler; here every
// operation is written out, and the bits are the same.
SymmetricEigen symmetric_eigen(const Mat3& matrix);

}  // namespace drape
