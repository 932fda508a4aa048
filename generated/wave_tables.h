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
#include "runtime/core/inline.h"

/* The polynomial of degree 109 through 110 enclosed samples is off by 2.1e-17 at most, proved: |J| is below 40 on
 * the ellipse with foci 0 and 7/4 and half axes that add up to 1.5 times 7/8 (tests/gen/test_waves.c). Keeping 40
 * terms, rounded to doubles, adds 1.3e-16 at most, proved. J is between 0.65 and 3.84. */
#define COR_WAVE_FACTOR_END 1.75
#define COR_WAVE_FACTOR_TERMS 40
COR_INLINE const double *cor_rows_wave_factor(int i)
{
    static const double row[1][40] = {
        /* c_0, c_1, ... */
        {
         0x1.b68f080de5f12p+0, /* 1.713119986909025005417107 */
         0x1.8c3fea02ad6dep+0, /* 1.547850251821209166536164 */
         0x1.27a4575d4cf6bp-1, /* 0.5774256993667966630923161 */
         0x1.69cf8e06047d1p-4, /* 0.08833270528728510984084465 */
         0x1.5647f90805fp-10, /* 0.001305698942820343599890975 */
         -0x1.78e6c17d4e178p-12, /* -0.0003594411753798025348227707 */
         0x1.51511263f0826p-14, /* 0.00008042256518961450758274656 */
         -0x1.68d3d30e7eda7p-17, /* -0.00001075349566991604993357583 */
         -0x1.b94118d24c151p-21, /* -8.219001535244792475958940e-7 */
         0x1.f46b2489f3d27p-21, /* 9.321021405775320202628342e-7 */
         -0x1.185fe02a2512cp-22, /* -2.611191144499712320112229e-7 */
         0x1.fcc08b9c50901p-26, /* 2.961327148885243502641802e-8 */
         0x1.01681c8eb286p-28, /* 3.745760270270970576761394e-9 */
         -0x1.defff3a33e9c2p-31, /* -8.712955811749939687716071e-10 */
         -0x1.10b3c95b350fcp-30, /* -9.920851560417889621594618e-10 */
         0x1.8ae573abb775ep-31, /* 7.183121783707095502330531e-10 */
         -0x1.126b945416237p-32, /* -2.495837471203466661897362e-10 */
         0x1.a593f3b9ed20fp-35, /* 4.792786259233847544862469e-11 */
         -0x1.8afab04409a62p-40, /* -1.403248191786010360455277e-12 */
         -0x1.faaf4a1d7af0fp-40, /* -1.800105752130142609927818e-12 */
         0x1.546b6990934efp-43, /* 1.511766620955060904713596e-13 */
         0x1.4da3611c68fcbp-42, /* 2.963302497124627531141121e-13 */
         -0x1.88575f1c3ce1ep-43, /* -1.742345356961233546515245e-13 */
         0x1.c88c1a98ad7d1p-45, /* 5.068693030061578185170689e-14 */
         -0x1.d8dabc95db03ap-48, /* -6.562173583474620727924644e-15 */
         -0x1.216cf590afa94p-50, /* -1.004146842159854747987381e-15 */
         0x1.40adc064b42f2p-51, /* 5.562888985217951757614523e-16 */
         0x1.a8ad7b37a6c0bp-56, /* 2.302182215469608603271293e-17 */
         -0x1.cbc9542818525p-54, /* -9.970029150746904570171268e-17 */
         0x1.a1d96cfc30056p-55, /* 4.530331396815898926899087e-17 */
         -0x1.7b135815cec4cp-57, /* -1.027486371872905865426504e-17 */
         0x1.dd4196061cb8ep-62, /* 4.042517218127127565504724e-19 */
         0x1.3931bf236a6e5p-61, /* 5.305718205916704216736926e-19 */
         -0x1.44d03b3a5c8a7p-63, /* -1.375638273418333777885834e-19 */
         -0x1.16b844f2cc98ap-65, /* -2.951060692564531805925136e-20 */
         0x1.32d5a7dace33fp-65, /* 3.248737615162195766843996e-20 */
         -0x1.b20ddd67249dep-67, /* -1.148931793955200889401006e-20 */
         0x1.0ec1b331d6924p-69, /* 1.791717150222752244272576e-21 */
         0x1.19a1087b74e14p-72, /* 2.329580782455885279965613e-22 */
         -0x1.c8fd9586a38eap-73 /* -1.890068668482691884795709e-22 */
        }
    };
    return row[i];
}

#endif
