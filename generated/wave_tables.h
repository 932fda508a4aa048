/* SPDX-License-Identifier: MIT */
/* J(nu) of a half-space, the part of its compliance that radiates elastic waves, as a Chebyshev series in
 * tau = sqrt(1 - 2 nu): J = sum c_k T_k(8 tau/7 - 1), 0 <= tau <= sqrt(3), -1 <= nu <= 1/2. Evaluated by
 * runtime/sphere/waves.c. Source: docs/laws.md.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check
 *
 * Error: proved, see below. */
#ifndef COR_GENERATED_WAVE_TABLES_H
#define COR_GENERATED_WAVE_TABLES_H
#include "runtime/number/inline.h"

/* The polynomial of degree 109 through 110 enclosed samples is off by 2.1e-17 at most, proved: |J| is below 40 on
 * the ellipse with foci 0 and 7/4 and half axes that add up to 1.5 times 7/8 (tests/gen/test_waves.c). Keeping 40
 * terms, rounded to doubles, adds 1.3e-16 at most, proved. J is between 0.65 and 3.84. */
#define COR_WAVE_FACTOR_END 1.75
#define COR_WAVE_FACTOR_TERMS 40
COR_INLINE const double *cor_rows_wave_factor(int i)
{
    static const double row[1][40] = {
    {0x1.b68f080de5f12p+0,0x1.8c3fea02ad6dep+0,0x1.27a4575d4cf6bp-1,0x1.69cf8e06047d1p-4,0x1.5647f90805fp-10,
    -0x1.78e6c17d4e178p-12,0x1.51511263f0826p-14,-0x1.68d3d30e7eda7p-17,-0x1.b94118d24c151p-21,0x1.f46b2489f3d27p-21,
    -0x1.185fe02a2512cp-22,0x1.fcc08b9c50901p-26,0x1.01681c8eb286p-28,-0x1.defff3a33e9c2p-31,-0x1.10b3c95b350fcp-30,
    0x1.8ae573abb775ep-31,-0x1.126b945416237p-32,0x1.a593f3b9ed20fp-35,-0x1.8afab04409a62p-40,-0x1.faaf4a1d7af0fp-40,
    0x1.546b6990934efp-43,0x1.4da3611c68fcbp-42,-0x1.88575f1c3ce1ep-43,0x1.c88c1a98ad7d1p-45,-0x1.d8dabc95db03ap-48,
    -0x1.216cf590afa94p-50,0x1.40adc064b42f2p-51,0x1.a8ad7b37a6c0bp-56,-0x1.cbc9542818525p-54,0x1.a1d96cfc30056p-55,
    -0x1.7b135815cec4cp-57,0x1.dd4196061cb8ep-62,0x1.3931bf236a6e5p-61,-0x1.44d03b3a5c8a7p-63,-0x1.16b844f2cc98ap-65,
    0x1.32d5a7dace33fp-65,-0x1.b20ddd67249dep-67,0x1.0ec1b331d6924p-69,0x1.19a1087b74e14p-72,-0x1.c8fd9586a38eap-73}
    };
    return row[i];
}

#endif
