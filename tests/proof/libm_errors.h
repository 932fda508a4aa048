/* SPDX-License-Identifier: MIT */
/* What the proofs of rounding errors assume of the C library (docs/theory.md, 18): bounds on the errors of its
 * functions, in units of the last place. tests/proof/goals.cpp and tests/proof/disk_bounds.cpp have them as hypotheses,
 * tests/accuracy/test_libm.c measures the platform's functions. */
#ifndef COR_TESTS_PROOF_LIBM_ERRORS_H
#define COR_TESTS_PROOF_LIBM_ERRORS_H

/* A relative error of 2^-46. The evaluator cuts one root to 26 bits and squares the other in a term below 6e-8. */
#define COR_PROOF_CBRT_ULP 64
#define COR_PROOF_LOG_ULP 1
#define COR_PROOF_LOG1P_ULP 1
/* of log, where t(q) is within 2 ulp */
#define COR_PROOF_LOG_NEAR_ULP 0.55

#endif
