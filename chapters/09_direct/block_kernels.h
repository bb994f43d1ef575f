// Small dense blocks of 1 to 6 rows: the arithmetic of the factorisation. Given, there is nothing
// to edit here.
#pragma once

#include "chapters/09_direct/direct.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Factors a symmetric n x n block as D = l d l^T (Eq. 9-7), in place in its lower triangle. After
/// it, l is below the diagonal (the diagonal of l is 1), and inverse(d, original) is on it.
void factor_block(double* D, int n, const double* original, PivotInverse inverse);

/// x = D^-1 x, with the factor of the n x n block D.
void divide(const double* D, int n, double* x);

/// B = A D^-1 for m x n numbers A, with the factor of the n x n block D.
void divide_rows(const double* A, int m, const double* D, int n, double* B);

/// C -= A B^T, of m x n numbers A and p x n numbers B.
void subtract_product(const double* A, int m, const double* B, int p, int n, double* C);

/// y -= A x, of m x n numbers A.
void subtract_times(const double* A, int m, int n, const double* x, double* y);

/// y -= A^T x, of m x n numbers A.
void subtract_transposed_times(const double* A, int m, int n, const double* x, double* y);

}  // namespace joints
/// @}
