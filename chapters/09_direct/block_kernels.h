// Small dense blocks of 1 to 6 rows: the arithmetic of the factorisation. Given, there is nothing
// to edit here.
#pragma once

#include "chapters/09_direct/direct.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Factors a symmetric n x n block as D = L d L^T (Eq. 9-7), in place in its lower triangle. After
/// it, L is below the diagonal (the diagonal of L is 1), and inverse(d, original) is on it.
template <class Number, class PivotInverse>
void factor_block(Number* D, int n, const Number* original, PivotInverse inverse);

/// x = D^-1 x, with the factor of the n x n block D.
template <class Number>
void divide(const Number* D, int n, Number* x);

/// B = A D^-1 for m x n numbers A, with the factor of the n x n block D.
template <class Number>
void divide_rows(const Number* A, int m, const Number* D, int n, Number* B);

/// C -= A B^T, of m x n numbers A and p x n numbers B.
template <class Number>
void subtract_product(const Number* A, int m, const Number* B, int p, int n, Number* C);

/// y -= A x, of m x n numbers A.
template <class Number>
void subtract_times(const Number* A, int m, int n, const Number* x, Number* y);

/// y -= A^T x, of m x n numbers A.
template <class Number>
void subtract_transposed_times(const Number* A, int m, int n, const Number* x, Number* y);

}  // namespace joints
/// @}

#ifndef JOINTS_OF_READER  // a reader waits for the compiler: joint_matrix.cpp has them compiled
#include "chapters/09_direct/block_kernels_inline.h"
#endif
