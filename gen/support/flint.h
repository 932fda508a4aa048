/* SPDX-License-Identifier: MIT */
/* This file hides the differences between installations of FLINT. FLINT 3 has Arb in flint/. With FLINT 2.9, Arb is a
 * separate library with headers at the top level. CMake sets COR_FLINT_HAS_ARB. Every header whose functions or macros
 * are used is included by name (tests/hygiene/run). The headers that it includes differ between versions of FLINT. */
#ifndef COR_GEN_SUPPORT_FLINT_H
#define COR_GEN_SUPPORT_FLINT_H

#include <gmp.h>
#include <mpfr.h>

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz.h>
#include <flint/fmpz_vec.h>
#include <flint/longlong.h>
#include <flint/ulong_extras.h>

#ifdef COR_FLINT_HAS_ARB
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_poly.h>
#include <flint/arb.h>
#include <flint/arb_hypgeom.h>
#include <flint/arb_mat.h>
#include <flint/arb_poly.h>
#include <flint/arf.h>
#include <flint/mag.h>
#else
#include <acb.h>
#include <acb_calc.h>
#include <acb_poly.h>
#include <arb.h>
#include <arb_hypgeom.h>
#include <arb_mat.h>
#include <arb_poly.h>
#include <arf.h>
#include <fmpz_extras.h>
#include <mag.h>
#endif

#endif
