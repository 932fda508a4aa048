/* SPDX-License-Identifier: MIT */
/* The assumptions of the proofs of rounding errors about the C library (docs/theory.md, 18), in units of the last
 * place. They are hypotheses of goals.cpp and disk_bounds.cpp, and tests/accuracy/test_libm.c measures them. Also the
 * errors of the stages of the disk's contact law. goals.cpp states them as goals for Gappa,
 * tests/accuracy/test_polynomials.c proves the error of the series, and disk_bounds.cpp adds them. */
#ifndef COR_TESTS_PROOF_ERRORS_H
#define COR_TESTS_PROOF_ERRORS_H

/* 64 ulp are a relative error of 2^-46. One cube root is cut to 26 bits, the other is in a term below 6e-8. */
#define COR_PROOF_CBRT_ULP 64
#define COR_PROOF_LOG_ULP 1
#define COR_PROOF_LOG1P_ULP 1
/* if log has an error up to this number, t(q) is within 2 ulp */
#define COR_PROOF_LOG_NEAR_ULP 0.55

/* the error of ln(limit/x) far from the limit, without the error of log(m); |ln(m)| < 0.3466 */
#define COR_PROOF_FAR 0x1p-80
/* the error of the quotient's remainder near the limit, relative to the quotient */
#define COR_PROOF_NEAR 0x1p-74
/* the error of a correction of a square root, relative to the root */
#define COR_PROOF_ROOT 0x1p-70
/* rounding error of the series without its first term, relative to this part; p is below COR_PROOF_SERIES_MAX_P */
#define COR_PROOF_SERIES (5.1 * 0x1p-53)
#define COR_PROOF_SERIES_MAX_P 0.4473
/* |t - ln(1 + t) - p^2/2| of the series in real arithmetic, relative to p^3 */
#define COR_PROOF_SERIES_DEFECT 0x1p-55
/* rounding in the polynomial that starts the iteration, relative */
#define COR_PROOF_START 0x1p-48
/* |r| in the first step, relative to y; tests/proof/disk_bounds.cpp proves it */
#define COR_PROOF_FIRST_RESIDUAL 0.009
/* rounding in the first step, relative to y */
#define COR_PROOF_STEP 0x1p-44
/* |r| in Newton's step, relative to the lower end of the cell of y; tests/proof/disk_bounds.cpp proves it */
#define COR_PROOF_SECOND_RESIDUAL 0x1p-32
/* rounding in Newton's step, relative to y */
#define COR_PROOF_NEWTON 0x1p-82
/* the absolute errors of 1 + t after the series, of 1 + t after Newton's step, and of 1/2 + q */
#define COR_PROOF_SUM_SERIES 0x1p-56
#define COR_PROOF_SUM_NEWTON 0x1p-72
#define COR_PROOF_SUM_HALF 0x1p-95
#define COR_PROOF_SERIES_MAX_LOW 0.09
/* the relative error of products and quotients of pairs, and of products by a double before they are rounded */
#define COR_PROOF_PAIRS 0x1p-68
/* the relative error of cor_inline_pair_times for pairs with |lo| <= 2^-53 hi */
#define COR_PROOF_PAIR_TIMES 0x1p-101

#endif
