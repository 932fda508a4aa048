/* SPDX-License-Identifier: MIT */
/* Collisions of viscoelastic spheres, x'' + beta sqrt(x) x' + x^(3/2) = 0, both ends of contact, for
 * every beta: rows of short polynomials around the nodes of uniform grids, and what follows at large
 * beta. Evaluated by runtime/sphere/eval.h. Source: docs/derivation.md, 4 to 6 and 8; form:
 * docs/header-format.md.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check
 *
 * Each double is the one nearest to its coefficient: proved; corgen tables --digits prints 25 digits of
 * each. Errors of the rows stand above each table and behind each row, those of the formulas for large
 * beta above the formulas, proved for every argument (docs/derivation.md, 8). The rows interpolate
 * polynomials of high degree through collisions enclosed to 76 bits or more (proved). Errors of
 * evaluation: include/cor/sphere.h. */
#ifndef COR_GENERATED_SPHERE_TABLES_H
#define COR_GENERATED_SPHERE_TABLES_H

#include "runtime/core/rows.h"

/* A row: value = c_0 + (c_0' + s (c_1 + c_2 t + ... + c_n t^(n-1))), t = y - node, in columns c_0,
 * c_0', c_1, ..., c_n. s = t; only in the rows of eps and of the loss at zero force from
 * node 1/4 on s = beta - node^2. c_0' is the remainder of c_0 at the node. */

/* eps at zero overlap, beta < 7: 57 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 7.0625.
 * Relative error of the approximation: 2^-56.5 at most, proved for the whole cell of each row. */
#define COR_ROWS_EPS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_EPS_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_EPS_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_EPS_ZERO_OVERLAP_ROWS 57
#define COR_ROWS_EPS_ZERO_OVERLAP_END 7.0
COR_ROWS(double, cor_rows_eps_zero_overlap, 57, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1p+0, 0x0p+0, -0x1.27486ca320b83p+0, 0x1.98b665097f1f7p-1, -0x1.0bb743932d0eap-1, 0x1.651cccc3a8fa2p-2,
     -0x1.dd628d8647c9bp-3, 0x1.40e28923b034cp-3, -0x1.b16c5b6707735p-4, 0x1.25b646c5163e6p-4, -0x1.899dc9913df42p-5,
     0x1.baeac54c6bc1dp-6}, /* [0] 0 <= y <= 0.0625, degree 10, 57.9 bits */
    {0x1.bc152f7d4a847p-1, -0x1.7581c18c017e4p-57, -0x1.f3ac99dbaab57p-1, 0x1.42fd8376623fp-1, -0x1.84b7f1172a872p-2,
     0x1.de6d6dc448439p-3, -0x1.266157552f64ap-3, 0x1.6c2b9110916bdp-4, -0x1.c47ef5db8638dp-5, 0x1.1a2895514f75fp-5,
     -0x1.6286ba4d5c1d2p-6, 0x1.bd1e14fd43f2fp-7}, /* [1] 0.0625 <= y <= 0.1875, degree 10, 58.6 bits */
    {0x1.82515567ec311p-1, -0x1.c18fca3321765p-55, -0x1.ab2f5cb7de25fp-1, 0x1.040816978b53p-1, -0x1.20fbb0d6caa7bp-2,
     0x1.4a703a7ad621p-3, -0x1.78c8b7f5a90e1p-4, 0x1.afb6b628c7812p-5, -0x1.f0cbfb3ec394fp-6, 0x1.1eb8072a7ba01p-6,
     -0x1.4d384edd9ffc5p-7, 0x1.83119d23e7a2ep-8}, /* [2] 0.1875 <= y <= 0.3125, degree 10, 58.1 bits */
    {0x1.50b81d18d7824p-1, 0x1.f595dc3e0e92fp-55, -0x1.705b9240e282bp-1, 0x1.a98604c3a5614p-2, -0x1.b6715eadc382p-3,
     0x1.d492180116a6p-4, -0x1.f1d60bce17ddp-5, 0x1.0996e3fdbe8aep-5, -0x1.1cb96865cd79bp-6, 0x1.31ded9d6ac413p-7,
     -0x1.4abf9ef357125p-8, 0x1.657e3fc3cee6cp-9}, /* [3] 0.3125 <= y <= 0.4375, degree 10, 57.2 bits */
    {0x1.25cc577b82b6bp-1, -0x1.48de4e11a649cp-58, -0x1.3fe201b1600a4p-1, 0x1.61317ba39f64cp-2, -0x1.526d7ee549e7p-3,
     0x1.53d642eba50c2p-4, -0x1.521be518d427ep-5, 0x1.516969b837466p-6, -0x1.52c97aa2b4ec8p-7, 0x1.5448ce09e8a9p-8,
     -0x1.5822f8ab7b343p-9, 0x1.5bd0dbaaddf27p-10}, /* [4] 0.4375 <= y <= 0.5625, degree 10, 57.7 bits */
    {0x1.006aac70c4537p-1, -0x1.c335956ee9d7bp-55, -0x1.176449d178c96p-1, 0x1.28f2d2ebb1f14p-2, -0x1.09315335f7ee9p-3,
     0x1.f6c23d90f4f39p-5, -0x1.d69b82bac4075p-6, 0x1.b8b0d46889b31p-7, -0x1.a09304df7de0bp-8, 0x1.88a6f18e9102cp-9,
     -0x1.7519cccf4a939p-10, 0x1.6223cbd08819bp-11}, /* [5] 0.5625 <= y <= 0.6875, degree 10, 56.8 bits */
    {0x1.bf617b554b2c2p-2, -0x1.aa1c2865f84a4p-59, -0x1.ea4decbf1ca3ap-2, 0x1.f92d6a64a6dbfp-3, -0x1.a521538654a54p-4,
     0x1.7a55b22cbe6a3p-5, -0x1.4ecaa1423a93ap-6, 0x1.26c0428260e3cp-7, -0x1.07b9e1e88074ap-8, 0x1.d3d23c986acd1p-10,
     -0x1.a362a4cdfd51fp-11, 0x1.77623a4d0ae05p-12}, /* [6] 0.6875 <= y <= 0.8125, degree 10, 57.7 bits */
    {0x1.85d84168149e5p-2, -0x1.d173930f0f6d2p-57, -0x1.afbf3035ab5e8p-2, 0x1.b253f140fa382p-3, -0x1.52507c44c50a8p-4,
     0x1.20f4cfbab46e2p-5, -0x1.e61d51d5fa084p-7, 0x1.9264a93e3a1c7p-8, -0x1.56e9d1ca1adf8p-9, 0x1.1eb32e18dd1c6p-10,
     -0x1.e6914a21a2c5ap-12, 0x1.9ca9a03feec4cp-13}, /* [7] 0.8125 <= y <= 0.9375, degree 10, 59.5 bits */
    {0x1.531cde3a293a4p-2, 0x1.9709e258a8598p-57, -0x1.7d27de916678ep-2, 0x1.791da53feeda6p-3, -0x1.12abfc513fd3ep-4,
     0x1.beedc49b00503p-6, -0x1.67d94aebc2616p-7, 0x1.175628941f6b9p-8, -0x1.c8e9f2aaa88aep-10, 0x1.688aec679b413p-11,
     -0x1.21ed15fc2b2bap-12, 0x1.d59f42e38df82p-14}, /* [8] 0.9375 <= y <= 1.0625, degree 10, 57.6 bits */
    {0x1.264971acdc8edp-2, 0x1.2a441936834ep-56, -0x1.5107a259cd74p-2, 0x1.4a715db32ebb4p-3, -0x1.c26aca0997cbbp-5,
     0x1.5d1159fbc5e23p-6, -0x1.0fa042e4a06a1p-7, 0x1.88f2aa8062c66p-9, -0x1.3750c5a10ca51p-10, 0x1.d0df3e218cd5ap-12,
     -0x1.606ed8eb5a6c6p-13, 0x1.151464aea38a8p-14}, /* [9] 1.0625 <= y <= 1.1875, degree 10, 59.5 bits */
    {0x1.fd450c85d8756p-3, 0x1.1475ca48aacc9p-58, -0x1.2a33f8e6549c7p-2, 0x1.23ff0e20a26a3p-3, -0x1.74e0eab6c0028p-5,
     0x1.127b27fafeba5p-6, -0x1.a290632ea797fp-8, 0x1.16f6b2cbb7b09p-9, -0x1.b07f829e8b25ep-11, 0x1.3465dbe1caabcp-12,
     -0x1.af666e93ef4c9p-14, 0x1.554dc42107d57p-15}, /* [10] 1.1875 <= y <= 1.3125, degree 10, 57.7 bits */
    {0x1.b71b7a3ebf42bp-3, -0x1.2551a48069862p-58, -0x1.07c30b92bd24bp-2, 0x1.0403d62e81719p-3, -0x1.37ce6378c4bcap-5,
     0x1.b0cfb53f7828ep-7, -0x1.49c58d9e57985p-8, 0x1.8e85dc6b3fd4fp-10, -0x1.301d062b95357p-11, 0x1.aa5c6aa97ae68p-13,
     -0x1.02f5dc29a84c6p-14, 0x1.bb09556995757p-16}, /* [11] 1.3125 <= y <= 1.4375, degree 10, 56.9 bits */
    {0x1.791569d7e013fp-3, 0x1.4e4b3fc948dap-62, -0x1.d1f987d9911a1p-3, 0x1.d241d35679a68p-4, -0x1.07b2730c0c815p-5,
     0x1.543d9834b33edp-7, -0x1.0a2d3713a08f4p-8, 0x1.1e7746529b9a7p-10, -0x1.a98756820328cp-12, 0x1.3b216b5074ee3p-13,
     -0x1.20c4eb13ac9e3p-15, 0x1.2ceeee8e3c10fp-16}, /* [12] 1.4375 <= y <= 1.5625, degree 10, 61.5 bits */
    {0x1.425b0a58a0578p-3, 0x1.f9704c03dc4e1p-63, -0x1.9aa05d0bf5cf9p-3, 0x1.a47dd9044431dp-4, -0x1.c415bc0fdf6e2p-6,
     0x1.089fcbabfabf5p-7, -0x1.b85969f73ae96p-9, 0x1.a2b86ecfe9d09p-11, -0x1.1c3adce713c22p-12, 0x1.0151bea0b3631p-13,
     -0x1.0ba49f5d030b5p-16, 0x1.89fee77c90b4ap-17}, /* [13] 1.5625 <= y <= 1.6875, degree 10, 58.4 bits */
    {0x1.1234b44ee6155p-3, -0x1.038d59aec5c47p-60, -0x1.6897c24411117p-3, 0x1.7cf3c6b945d28p-4, -0x1.8a0d893cb79f5p-6,
     0x1.92d379d5eb31fp-8, -0x1.73ca99590e036p-9, 0x1.416d78cda1392p-11, -0x1.44e9275b5e958p-13, 0x1.d3ecd834c43fap-14,
     -0x1.6867ec782a669p-18, 0x1.45c4300e2fc7p-18}, /* [14] 1.6875 <= y <= 1.8125, degree 10, 57.8 bits */
    {0x1.d00781a96d188p-4, 0x1.062981c3a9324p-62, -0x1.3b30f2aee1258p-3, 0x1.5a26ea9dd3283p-4, -0x1.5e965f27ec849p-6,
     0x1.277ce0e491929p-8, -0x1.3c9b0506e755cp-9, 0x1.1391f4bf13c6ap-11, -0x1.7f9e731ad4951p-15, 0x1.c05f044c8c4a9p-14,
     -0x1.5855dcc96a1adp-18, -0x1.563ec7cb68d44p-18}, /* [15] 1.8125 <= y <= 1.9375, degree 10, 57.0 bits */
    {0x1.8679221830622p-4, 0x1.fa038042434abp-60, -0x1.11e8fe0ed1889p-3, 0x1.3ad494a7ccde3p-4, -0x1.3f808e18ff5d9p-6,
     0x1.9911fdb4181e8p-9, -0x1.0965e24c90778p-9, 0x1.167939a8d908ap-11, 0x1.d927a0456591fp-15, 0x1.8d1c525ef6b09p-14,
     -0x1.47db320698962p-16, -0x1.325e90180f397p-16}, /* [16] 1.9375 <= y <= 2.0625, degree 10, 56.6 bits */
    {0x1.46c301556ef58p-4, -0x1.66e5a3d619c6p-59, -0x1.d8c44461f6d82p-4, 0x1.1debf35c15cd3p-4, -0x1.2ac4ba728bc95p-6,
     0x1.0438091b5b23dp-9, -0x1.a3000c893004dp-10, 0x1.43d4f164d2b08p-11, 0x1.1b54fbb8649b8p-13, 0x1.ddf9cdf28be4bp-15,
     -0x1.a2f5e64463ad8p-15, -0x1.e8c6a07176bf9p-16}, /* [17] 2.0625 <= y <= 2.1875, degree 10, 57.3 bits */
    {0x1.0ffd45a9e2ce9p-4, -0x1.1f02fe5eb6427p-59, -0x1.94bb3e98f40ap-4, 0x1.028e67b652d1ep-4, -0x1.1e2e5a5144cdfp-6,
     0x1.2b21a7a47caa3p-10, -0x1.1cc55ef312821p-10, 0x1.89c965ed6ae59p-11, 0x1.4950c5d84833dp-13,
     -0x1.4f8c3335a3917p-16, -0x1.687ffd2c0c4dbp-14, -0x1.9c926360d6381p-16},
     /* [18] 2.1875 <= y <= 2.3125, degree 10, 60.1 bits */
    {0x1.c29928acf76fp-5, 0x1.c13bde0a9614bp-60, -0x1.576a14a14c7a5p-4, 0x1.d02df1a5e44edp-5, -0x1.171cce7b94e6cp-6,
     0x1.53dbee610ae2p-11, -0x1.f39d875377372p-12, 0x1.c54a9013f3ea4p-11, 0x1.6139dc3dc20aap-14, -0x1.0cf39110144ffp-13,
     -0x1.9f5d6d475e8eep-14, 0x1.28d0af86452e7p-17}, /* [19] 2.3125 <= y <= 2.4375, degree 10, 57.3 bits */
    {0x1.73b9e309cb62fp-5, -0x1.4cfa6ab1478afp-60, -0x1.20a4ce953247fp-4, 0x1.9c4b31d278f8ep-5, -0x1.127601d09e3dbp-6,
     0x1.23a52595b62afp-11, 0x1.7f0c1df997fbcp-13, 0x1.c679e79fcf5ddp-11, -0x1.8d9e86d1abe3ep-14,
     -0x1.d05397d905bb2p-13, -0x1.c6776156d2fe3p-15, 0x1.0c351284ecbdap-14},
     /* [20] 2.4375 <= y <= 2.5625, degree 10, 56.5 bits */
    {0x1.31bd8c511d411p-5, -0x1.912e8a6c8073fp-61, -0x1.e09bac8027589p-5, 0x1.69506537fee26p-5, -0x1.0ce6bddb20968p-6,
     0x1.c48d7b6346532p-11, 0x1.9706b40088b5dp-11, 0x1.657ecb0219b7p-11, -0x1.590db030851dep-12, -0x1.dbfc961bde23bp-13,
     0x1.b38975a39159p-15, 0x1.9860a7cc2e709p-14}, /* [21] 2.5625 <= y <= 2.6875, degree 10, 58.4 bits */
    {0x1.f6193ba07182dp-6, 0x1.22ca1541aee8ap-63, -0x1.8c849c9324a86p-5, 0x1.37b36230962f8p-5, -0x1.03755bd0d5aep-6,
     0x1.84865fc6bcffap-10, 0x1.2f5fb19748ecdp-10, 0x1.43052f562318bp-12, -0x1.0899f2c1f79bap-11,
     -0x1.b37c177ae17d5p-14, 0x1.4cc55d9cf655dp-13, 0x1.f882ad8aa517p-15},
     /* [22] 2.6875 <= y <= 2.8125, degree 10, 57.5 bits */
    {0x1.9c35a0511cb44p-6, 0x1.9f57c9fd7cfd9p-61, -0x1.44912e768ffabp-5, 0x1.0861d84fe6b8ep-5, -0x1.e875b7f82f716p-7,
     0x1.25dc6a92a5ed4p-9, 0x1.3eede6b994f16p-10, -0x1.3be2aa00bd76ep-13, -0x1.0b51f4d067a94p-11, 0x1.96d186d74ff98p-14,
     0x1.72f5360fedaf2p-13, -0x1.244a0bb1b33ffp-15}, /* [23] 2.8125 <= y <= 2.9375, degree 10, 58.3 bits */
    {0x1.52dcb8bfb7073p-6, 0x1.a849935bcd0a8p-65, -0x1.080a5688ce251p-5, 0x1.b8ff3cd83c737p-6, -0x1.bdd3946352228p-7,
     0x1.80a1e403a1359p-9, 0x1.f32341895f72p-11, -0x1.14c9fa88107f5p-11, -0x1.565441f57b8a8p-12, 0x1.07f38222da345p-12,
     0x1.5978a73b5e9p-14, -0x1.b81651b908e66p-14}, /* [24] 2.9375 <= y <= 3.0625, degree 10, 58.0 bits */
    {0x1.1751c951ad496p-6, 0x1.2bbb6a572e71ep-60, -0x1.abe33b1adbfb4p-6, 0x1.6a2e95b6969dep-6, -0x1.89a01d58afb06p-7,
     0x1.bc12d1a655567p-9, 0x1.f56d1ffe6f67p-12, -0x1.6ca04099af6b4p-11, -0x1.c2296570f7109p-15, 0x1.19fe3ddd4a507p-12,
     -0x1.95b09fd75e525p-15, -0x1.7a0b5f8d90a24p-14}, /* [25] 3.0625 <= y <= 3.1875, degree 10, 59.8 bits */
    {0x1.ce3e7265c400dp-7, 0x1.b0e4e02ba8bc6p-61, -0x1.5a2068155fc56p-6, 0x1.25b13f465c4f2p-6, -0x1.508f085a662dfp-7,
     0x1.cdf8980ca8718p-9, -0x1.1ad151fabb17fp-15, -0x1.4dd8fba70cfddp-11, 0x1.65429671bb09bp-13, 0x1.5b75c39fed2d9p-13,
     -0x1.f50756c30faa2p-14, -0x1.597ee7265251cp-16}, /* [26] 3.1875 <= y <= 3.3125, degree 10, 57.0 bits */
    {0x1.8042cb7d61ff6p-7, -0x1.74a25b3719e4ap-61, -0x1.18249833c7644p-6, 0x1.d7e8a524059bp-7, -0x1.17be8b8e82ac1p-7,
     0x1.b97bd69a4c43bp-9, -0x1.ce73652b74e43p-12, -0x1.c864bc403dac4p-12, 0x1.18ae4a143dc31p-12, 0x1.092201de70bf3p-15,
     -0x1.bea10f89c4e8cp-14, 0x1.23ac43bc71c38p-15}, /* [27] 3.3125 <= y <= 3.4375, degree 10, 56.5 bits */
    {0x1.41142e7d5d614p-7, 0x1.70a80be778c6fp-61, -0x1.c69457864a9c2p-7, 0x1.7905eac8eff5bp-7, -0x1.c698c27a5542bp-8,
     0x1.8a674372b0b1bp-9, -0x1.6412ca1331a1bp-11, -0x1.a900897032918p-13, 0x1.04f469be737d2p-12,
     -0x1.ecb077cab1d6fp-15, -0x1.b14c9f6652aa1p-15, 0x1.82aa74486c0a7p-15},
     /* [28] 3.4375 <= y <= 3.5625, degree 10, 59.1 bits */
    {0x1.0dba10b7ed75p-7, -0x1.c57e33c3a6ffp-61, -0x1.723c74126b749p-7, 0x1.2c9379a908d1fp-7, -0x1.6b565d629452ep-8,
     0x1.4e9e45fe870cfp-9, -0x1.8cf82b0d76d9ep-11, -0x1.19f24638a4434p-16, 0x1.6721013ae1a4dp-13,
     -0x1.6e2755a59874fp-14, -0x1.8a698f8d16d72p-19, 0x1.eddc82365b77fp-16},
     /* [29] 3.5625 <= y <= 3.6875, degree 10, 58.6 bits */
    {0x1.c79e06cb9096fp-8, 0x1.cc8c884f3bbe8p-62, -0x1.2efc0b0ee131cp-7, 0x1.df9e8790cb211p-8, -0x1.1f64997cd1f53p-8,
     0x1.116a6b606c0f4p-9, -0x1.7b108a64bff21p-11, 0x1.91475bdcd8835p-14, 0x1.712d7d0d15a7bp-14, -0x1.397f09de3f12bp-14,
     0x1.5c1ab43e9dfdap-16, 0x1.395761056679cp-17}, /* [30] 3.6875 <= y <= 3.8125, degree 10, 57.1 bits */
    {0x1.82d5fa234a4d4p-8, 0x1.b277f7b4d89a5p-64, -0x1.f2863b7c62774p-8, 0x1.7fc3931b6b4adp-8, -0x1.c4500c003c4f8p-9,
     0x1.b3844bad1bdc3p-10, -0x1.4a399e9576a85p-11, 0x1.2d6e8bbc9fabbp-13, 0x1.b9b77ad74e53p-16, -0x1.933e3c1bf8aa3p-15,
     0x1.935db013938dep-16, -0x1.4d83dfc2f897bp-19}, /* [31] 3.8125 <= y <= 3.9375, degree 10, 60.8 bits */
    {0x1.4a19aae5a8b39p-8, -0x1.90d0fabecd26fp-62, -0x1.9c61e7c51b795p-8, 0x1.34644f833b366p-8, -0x1.6393c8ab2a6efp-9,
     0x1.556eb67e7db7ap-10, -0x1.0f8f3b27a0453p-11, 0x1.39884d366faffp-13, -0x1.31a39998d5fecp-17,
     -0x1.921c2e08fb6fp-16, 0x1.2e34d30b0807cp-16, -0x1.9a727c6549063p-18},
     /* [32] 3.9375 <= y <= 4.0625, degree 10, 57.5 bits */
    {0x1.1b0b2e7cceb13p-8, -0x1.baaf509260bcp-67, -0x1.56fdbaa81a2bep-8, 0x1.f2310aa81c4bp-9, -0x1.18138c0ac00cp-9,
     0x1.09807d333b753p-10, -0x1.aee550357d34ap-12, 0x1.185cf8e72898ep-13, -0x1.99186cb81c5a6p-16,
     -0x1.0c4d39fb3591bp-17, 0x1.61cb4e3ed3d28p-17, -0x1.6c77b99e36d3p-18},
     /* [33] 4.0625 <= y <= 4.1875, degree 10, 57.6 bits */
    {0x1.e79b8d45c6efbp-9, 0x1.fd19c150692e7p-63, -0x1.1ecb529c1d5cp-8, 0x1.949e4dff8746bp-9, -0x1.baec0be448802p-10,
     0x1.9bd9943ebc3b7p-11, -0x1.4ec49902df0a6p-12, 0x1.ceb8566cad931p-14, -0x1.cf70c8102d903p-16,
     0x1.efedd74801df4p-22, 0x1.4a22f01df2b8dp-18, -0x1.da10fc9649eeap-19},
     /* [34] 4.1875 <= y <= 4.3125, degree 10, 58.2 bits */
    {0x1.a5d296098b514p-9, 0x1.16f2a82c90066p-64, -0x1.e20f19ab59dd4p-9, 0x1.4a74e1c63a437p-9, -0x1.5ff7d35e629f1p-10,
     0x1.3fd056e68d0dep-11, -0x1.0153ac7623994p-12, 0x1.6ce2ce96a7d7fp-14, -0x1.a57ba47c76b97p-16,
     0x1.0716b2ed3b1dcp-18, 0x1.ad7675d0237e7p-20, -0x1.f5d7a2c6dff5fp-20},
     /* [35] 4.3125 <= y <= 4.4375, degree 10, 58.1 bits */
    {0x1.6e674a12c913ep-9, 0x1.58964d3095a6cp-64, -0x1.971b5212f384p-9, 0x1.0f5ea2055a9ddp-9, -0x1.193ae26ae6484p-10,
     0x1.f273f0a9f0f3cp-12, -0x1.8a2238de3d29cp-13, 0x1.18a0b634f51e1p-14, -0x1.5ad1d12b0a7abp-16,
     0x1.3a2c52c7b0f3ep-18, -0x1.496b5e7d471fp-27, -0x1.aedfd49cc6774p-21},
     /* [36] 4.4375 <= y <= 4.5625, degree 10, 58.0 bits */
    {0x1.3f7ec15fb0807p-9, -0x1.eb08159e0c1ffp-63, -0x1.5965bbe987645p-9, 0x1.c00f27c1af341p-10, -0x1.c3f5f9ff8567p-11,
     0x1.8654a3d2ea79p-12, -0x1.2e0fb7f82bb9bp-13, 0x1.aa6625ac0e072p-15, -0x1.0ee364ec10819p-16, 0x1.1dc3ac6affb9ap-18,
     -0x1.4bcec069c415fp-21, -0x1.ff6dc3b4142cbp-23}, /* [37] 4.5625 <= y <= 4.6875, degree 10, 61.0 bits */
    {0x1.179c91f417c43p-9, -0x1.0a9efcf14f2b3p-64, -0x1.2653bda2f352bp-9, 0x1.73c60ebdc926fp-10, -0x1.6d34801991381p-11,
     0x1.33584a42fe0cep-12, -0x1.d093b0e8d1b9ap-14, 0x1.4295dc36b839dp-15, -0x1.9bd7aaeb026cbp-17,
     0x1.d121155afbd58p-19, -0x1.8b43d9a9ab386p-21, 0x1.86e12544921edp-27},
     /* [38] 4.6875 <= y <= 4.8125, degree 10, 59.5 bits */
    {0x1.eb1c95556708cp-10, 0x1.f2225fe93e566p-64, -0x1.f7b425c538035p-10, 0x1.35f80cb513c3cp-10,
     -0x1.28b50283e801ep-11, 0x1.e6c50ac261dc7p-13, -0x1.6700eddb2de5p-14, 0x1.e86dbee568007p-16,
     -0x1.3525b4c97e051p-17, 0x1.667bfbc1fdf3p-19, -0x1.611bee76efd69p-21, 0x1.9da0c3a3cd2b5p-24},
     /* [39] 4.8125 <= y <= 4.9375, degree 10, 59.3 bits */
    {0x1.b0b7660eb45e3p-10, -0x1.cca3f0165dffep-68, -0x1.b0b75ae324e4bp-10, 0x1.03a101f3aafdcp-10,
     -0x1.e4a17d89d176bp-12, 0x1.83a907216727dp-13, -0x1.16f59ee8de4cap-14, 0x1.730edafa7fc2fp-16,
     -0x1.ce457b094a791p-18, 0x1.0cf6da8c21662p-19, -0x1.1a2a4a433314fp-21, 0x1.cfa53ec0d44f2p-24},
     /* [40] 4.9375 <= y <= 5.0625, degree 10, 58.0 bits */
    {0x1.7e755062e677ep-10, -0x1.9be8edc04e95ep-64, -0x1.752144deefe53p-10, 0x1.b4d5a7537fd5cp-11,
     -0x1.8dc3d75c890dap-12, 0x1.366fbfc7ad4aep-13, -0x1.b405cab63c5f8p-15, 0x1.1b4a3182c4e52p-16,
     -0x1.59f8486dde033p-18, 0x1.8ee4c478d43dcp-20, -0x1.abf7ad1c94c2bp-22, 0x1.9011c2fbfbc9ap-24},
     /* [41] 5.0625 <= y <= 5.1875, degree 10, 58.4 bits */
    {0x1.530b6d4ac1b6fp-10, 0x1.d89ae933b6f8dp-64, -0x1.42e64ec0a24f6p-10, 0x1.71072c0292a38p-11,
     -0x1.480623247acacp-12, 0x1.f3d654eea11ccp-14, -0x1.56b6757eabbd1p-15, 0x1.b2fe01a30124p-17,
     -0x1.03e6c407ab097p-18, 0x1.26df01889031bp-20, -0x1.3cac5e3c2d328p-22, 0x1.37fa8874b82dep-24},
     /* [42] 5.1875 <= y <= 5.3125, degree 10, 61.3 bits */
    {0x1.2d699042e2b61p-10, -0x1.946bc85fbdbf7p-64, -0x1.186232948735p-10, 0x1.38fc7d33d02cep-11, -0x1.0fbd60ca706cp-12,
     0x1.94727ce4ab7d8p-14, -0x1.0ee01d3f94991p-15, 0x1.4fe80e4ec83cap-17, -0x1.887df8f88d686p-19,
     0x1.b4ab8f749313fp-21, -0x1.d00a9f37d962p-23, 0x1.d0a030a66923ap-25},
     /* [43] 5.3125 <= y <= 5.4375, degree 10, 58.7 bits */
    {0x1.0caecf6522156p-10, 0x1.52b8e0ee932e5p-64, -0x1.e883a77b3d3b1p-11, 0x1.0a765a99bb395p-11,
     -0x1.c42da6d4ac7a8p-13, 0x1.48db2f4400b4ap-14, -0x1.ae7f1ff922d8cp-16, 0x1.04e33b763386fp-17,
     -0x1.2a0da363581b9p-19, 0x1.44ac3a446ce3cp-21, -0x1.535fc1e120f38p-23, 0x1.52f35bb7511d4p-25},
     /* [44] 5.4375 <= y <= 5.5625, degree 10, 58.1 bits */
    {0x1.e040f55ab6cacp-11, -0x1.49aafea5acf68p-65, -0x1.aae46846b5ba3p-11, 0x1.c75a086b6808ep-12,
     -0x1.79c5f132d2239p-13, 0x1.0ca3754bb6fe1p-14, -0x1.57db03f533afp-16, 0x1.97855b84ca771p-18,
     -0x1.c75325811a30fp-20, 0x1.e56141596371ep-22, -0x1.f19e41fdbc196p-24, 0x1.eaf7fb5e1c379p-26},
     /* [45] 5.5625 <= y <= 5.6875, degree 10, 58.9 bits */
    {0x1.ae45e832ab0c3p-11, 0x1.210f3b39af00fp-66, -0x1.7626871e5c883p-11, 0x1.866afc309be9ep-12,
     -0x1.3cdc6407e1938p-13, 0x1.b8d98e5ea784dp-15, -0x1.14028447c5ee7p-16, 0x1.4002106b0914p-18,
     -0x1.5dcdb858b7d96p-20, 0x1.6cebd33b871fbp-22, -0x1.6e80b19726c28p-24, 0x1.63806fe0a8d4cp-26},
     /* [46] 5.6875 <= y <= 5.8125, degree 10, 59.3 bits */
    {0x1.8267f9eedbdc4p-11, -0x1.615e380588ee6p-65, -0x1.48db36bfbe521p-11, 0x1.4fda6e5ab08a7p-12,
     -0x1.0ac6ec5650e44p-13, 0x1.6b45557bc5143p-15, -0x1.bd33219172531p-17, 0x1.f93076fc1d994p-19,
     -0x1.0e3f709f48405p-20, 0x1.13f88c9b61a9dp-22, -0x1.0f6ee09b93cbfp-24, 0x1.02466d0f64fb4p-26},
     /* [47] 5.8125 <= y <= 5.9375, degree 10, 57.6 bits */
    {0x1.5bcc4cebffafcp-11, -0x1.111346f70ddf3p-66, -0x1.21d4eac481b7dp-11, 0x1.21d4eac2bb5edp-12,
     -0x1.c2d96d14d7733p-14, 0x1.2c90f2d5927bcp-15, -0x1.68adeb764b5c8p-17, 0x1.90c11d361f026p-19,
     -0x1.a3d5b7ec99ebp-21, 0x1.a3d1cb9442dbap-23, -0x1.946947f1c69e5p-25, 0x1.792c3686bb306p-27},
     /* [48] 5.9375 <= y <= 6.0625, degree 10, 58.7 bits */
    {0x1.39ba4d7ea9308p-11, 0x1.c203e7c9462d4p-69, -0x1.001ab2331d1afp-11, 0x1.f5c15d1f5b6a7p-13,
     -0x1.7e4a2e8b50dccp-14, 0x1.f351374997d0ep-16, -0x1.2579eb0667222p-17, 0x1.3f6e06af58ceap-19,
     -0x1.47cf7bdf9714ep-21, 0x1.411dc1d414a18p-23, -0x1.2f0b1fce99679p-25, 0x1.14fbce781c658p-27},
     /* [49] 6.0625 <= y <= 6.1875, degree 10, 57.2 bits */
    {0x1.1b95c4bca7e17p-11, -0x1.ed561da4abe98p-65, -0x1.c5bc6dfaa1a87p-12, 0x1.b3962c2399b72p-13,
     -0x1.453cedc0442c1p-14, 0x1.a04dfd0d58f6bp-16, -0x1.df953b79bc163p-18, 0x1.ff8e18c9e61dfp-20,
     -0x1.013d27623aa57p-21, 0x1.ede57979a471p-24, -0x1.c8c97c75347dbp-26, 0x1.993a57c14fd55p-28},
     /* [50] 6.1875 <= y <= 6.3125, degree 10, 58.9 bits */
    {0x1.00da0920ed3ep-11, 0x1.be0bf5d3c482cp-65, -0x1.92e795d94af38p-12, 0x1.7b3450cc7691cp-13, -0x1.159666a608cabp-14,
     0x1.5c5858a3f1b1fp-16, -0x1.896cd0625b901p-18, 0x1.9b6cc4b6142f1p-20, -0x1.95a998567fb4fp-22,
     0x1.7dcca50950808p-24, -0x1.5a30096fe79e5p-26, 0x1.30155c8a58689p-28},
     /* [51] 6.3125 <= y <= 6.4375, degree 10, 59.8 bits */
    {0x1.d22c25cc2e7cep-12, 0x1.b3036ac3c1819p-66, -0x1.66981d133738cp-12, 0x1.4b0290fe08d47p-13,
     -0x1.db4be3e2c0498p-15, 0x1.247d788a8bp-16, -0x1.43fd32c76b828p-18, 0x1.4c4be5099dda2p-20, -0x1.41577200dff26p-22,
     0x1.289f7346aa1f2p-24, -0x1.07c7c93428864p-26, 0x1.c67f7ff8b41f1p-29},
     /* [52] 6.4375 <= y <= 6.5625, degree 10, 58.4 bits */
    {0x1.a7d28d3bb6c3bp-12, 0x1.4a2f444c22ee1p-66, -0x1.3fddb30b416ecp-12, 0x1.21b0a2272c292p-13, -0x1.981ddf9c950cp-15,
     0x1.ecd1f5de6fed5p-17, -0x1.0bcbeee4e2d7ep-18, 0x1.0d7b1a317deadp-20, -0x1.ff5c20a620ecbp-23,
     0x1.cf1e4948dfbf8p-25, -0x1.94109647b1127p-27, 0x1.558a62df08898p-29},
     /* [53] 6.5625 <= y <= 6.6875, degree 10, 62.0 bits */
    {0x1.8201a48cac1dfp-12, -0x1.08f551d8c2badp-66, -0x1.1dee40ffe7c7ap-12, 0x1.fc523aaa7f58bp-14,
     -0x1.5f6e940416b1ep-15, 0x1.a0830e3da2344p-17, -0x1.bc4786a736ad1p-19, 0x1.b6cb6232095a3p-21,
     -0x1.989ce0e8d8cffp-23, 0x1.6b361c4641b35p-25, -0x1.37062e8281eddp-27, 0x1.020787b6ef244p-29},
     /* [54] 6.6875 <= y <= 6.8125, degree 10, 57.8 bits */
    {0x1.602b0143ce447p-12, -0x1.9394e52d7c68dp-67, -0x1.001f46bcf319fp-12, 0x1.bf0cb3531ca18p-14,
     -0x1.2f73acec63a82p-15, 0x1.611b8cb5f5554p-17, -0x1.71cccb3764e86p-19, 0x1.66980adea9084p-21,
     -0x1.47db764741df8p-23, 0x1.1e214680ccf76p-25, -0x1.e11e8b39089dp-28, 0x1.87e2d053f31c4p-30},
     /* [55] 6.8125 <= y <= 6.9375, degree 10, 59.4 bits */
    {0x1.41d3d8d6db42p-12, 0x1.200a48d200ee4p-67, -0x1.cbc0eca0a6f06p-13, 0x1.8a1313f76a82p-14, -0x1.06b762a4f193ap-15,
     0x1.2c3f4c2a3778bp-17, -0x1.34d36448a802cp-19, 0x1.261ea8a65739dp-21, -0x1.081b86c2e6583p-23,
     0x1.c4c1795f842ecp-26, -0x1.75d86bad7e8bfp-28, 0x1.2b122331e30d7p-30}
     /* [56] 6.9375 <= y <= 7.0625, degree 10, 59.0 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_eps_zero_overlap)

/* eps at zero force, beta < 16: 65 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 4.03125.
 * Relative error of the approximation: 2^-57.5 at most, proved for the whole cell of each row. */
#define COR_ROWS_EPS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_EPS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_EPS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_EPS_ZERO_FORCE_ROWS 65
#define COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS 4
#define COR_ROWS_EPS_ZERO_FORCE_END 16.0
COR_ROWS(double, cor_rows_eps_zero_force, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1p+0, 0x0p+0, 0x1.7b49eee64908dp-71, -0x1.27486ca320b83p+0, 0x1.3194d76087196p-48, 0x1.98b665097b4dap-1,
     0x1.11111117461e9p-2, -0x1.0bb74505f4d45p-1, -0x1.d8730e5a92773p-2, 0x1.64f7c360b1afdp-2, 0x1.d3243327f4531p-2,
     -0x1.a23e0583e2d74p-3}, /* [0] 0 <= y <= 0.03125, degree 10, 64.1 bits */
    {0x1.fdb30f4bed1f4p-1, 0x1.d94455e34e1f8p-58, -0x1.25a6b577d59fap-3, -0x1.225c06ed5ea88p+0, 0x1.a85adf71264bp-3,
     0x1.b1e43a156e3e8p-1, 0x1.3a00d003d5e36p-5, -0x1.5b1beb7722f5cp-1, -0x1.d618db19019ccp-3, 0x1.2017403e44004p-1,
     0x1.20d3321df5cd3p-2, -0x1.8ddadf4847a56p-2}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 62.5 bits */
    {0x1.f6e00f909fb8ep-1, 0x1.0472b252dfcap-57, -0x1.20ac291eec851p-2, -0x1.13587f1e42fd5p+0, 0x1.ab2c58820abcp-2,
     0x1.a3011121134fep-1, -0x1.d010755e96c3cp-3, -0x1.6cbf35060d23fp-1, 0x1.42dc5a8f25956p-4, 0x1.493c38efa4a22p-1,
     -0x1.776a26d24f624p-7, -0x1.0bc128f7ad3edp-1}, /* [2] 0.09375 <= y <= 0.15625, degree 10, 60.2 bits */
    {0x1.ebc2f1040d806p-1, 0x1.b3dd4209093dep-55, -0x1.a48af957ffd25p-2, -0x1.f5305891aa2d7p-1, 0x1.3810536d0765fp-1,
     0x1.6a11d7fbb9668p-1, -0x1.ea1ecc7308eccp-2, -0x1.380f8ebaca43ep-1, 0x1.889c3d72e599p-2, 0x1.172e8cf39076cp-1,
     -0x1.508ebb939e462p-2, -0x1.d2f04d4043fcfp-2}, /* [3] 0.15625 <= y <= 0.21875, degree 10, 60.3 bits */
    {0x1.dcbe437c15588p-1, -0x1.e1e0622d06bb5p-59, -0x1.0cee0abd829e2p+0, 0x1.9c038e8692fabp-2, 0x1.73317d7abc318p-1,
     -0x1.982602bfb0f96p-2, -0x1.14edfaa18f51fp-1, 0x1.349816d03018dp-2, 0x1.2fa9777c2f1aep-1, -0x1.33a5589e4117dp-1,
     0x1.fa1d5464a8576p-4, -0x1.499f820bf33f2p-1}, /* [4] 0.21875 <= y <= 0.28125, degree 10, 61.1 bits */
    {0x1.ca55f851fefe3p-1, -0x1.f8de0b0597bc3p-55, -0x1.fd8a10a0e9f5fp-1, 0x1.eb55282cd1e99p-2, 0x1.3e76fadbd7a32p-1,
     -0x1.088193a51e301p-1, -0x1.944aa3221e12ap-2, 0x1.d5b0477690b17p-2, 0x1.516ea2fa51087p-2, -0x1.24a764b91f161p-1,
     0x1.eb578bd47a3dfp-7, 0x1.74de72ee9796bp-3}, /* [5] 0.28125 <= y <= 0.34375, degree 10, 61.1 bits */
    {0x1.b526e01ce7a6dp-1, 0x1.cbdb190b3d351p-57, -0x1.dcd7531f52a95p-1, 0x1.13ce864441207p-1, 0x1.ff8b352a0ef6ap-2,
     -0x1.2c32a6a37c7cfp-1, -0x1.c131f106c0012p-3, 0x1.08dee1e23879p-1, 0x1.4897aa92b04d7p-4, -0x1.0732a3cefee1ap-1,
     0x1.3a0a3289f8548p-3, 0x1.2698adac4d621p-2}, /* [6] 0.34375 <= y <= 0.40625, degree 10, 61.4 bits */
    {0x1.9ddc0cf5b16e3p-1, -0x1.aa0b4dc5709e5p-57, -0x1.b906ab7715bc3p-1, 0x1.277567bce9c8fp-1, 0x1.7a06da01799edp-2,
     -0x1.35db41cb17a61p-1, -0x1.7534b27399afdp-5, 0x1.f332d2053bb1fp-2, -0x1.f5247ef4651c9p-4, -0x1.8928256ac4ac9p-2,
     0x1.1e514f3d2951bp-2, 0x1.5f1bc270acc19p-3}, /* [7] 0.40625 <= y <= 0.46875, degree 10, 60.2 bits */
    {0x1.8523973890cdcp-1, -0x1.56973072376cep-55, -0x1.9369f75597f62p-1, 0x1.30a3d878580eap-1, 0x1.ef47f463a0e78p-3,
     -0x1.284d2788f430ep-1, 0x1.9efd46e5d29e8p-4, 0x1.93f7e78e5d03ap-2, -0x1.0099c7a8d5e06p-2, -0x1.b6fc7ca95e264p-3,
     0x1.455b3ec990cdep-2, 0x1.b1079a69b8e0ap-8}, /* [8] 0.46875 <= y <= 0.53125, degree 10, 58.9 bits */
    {0x1.6ba43e413d3a7p-1, 0x1.f0e831c88eacbp-56, -0x1.6d44536f57507p-1, 0x1.3038b59a1f2f5p-1, 0x1.02f9e60e8d0f5p-3,
     -0x1.0933594f212ap-1, 0x1.a6bfbf64e6df1p-3, 0x1.15396426b9333p-2, -0x1.323803766d954p-2, -0x1.b9b0bcab9f133p-5,
     0x1.151dc59efb8d8p-2, -0x1.d6b10c39a23f5p-4}, /* [9] 0.53125 <= y <= 0.59375, degree 10, 62.8 bits */
    {0x1.51f50b0ee0804p-1, 0x1.63ad3e280336cp-56, -0x1.47b2829c2ac8ep-1, 0x1.27af09d3d1f3bp-1, 0x1.d9d1ca1dd639cp-6,
     -0x1.bed5858a27a12p-2, 0x1.10551e666782bp-2, 0x1.2ae70326622d2p-3, -0x1.2181627831786p-2, 0x1.0127244057a1bp-4,
     0x1.6ae425297989dp-3, -0x1.4b5c212eb067ap-3}, /* [10] 0.59375 <= y <= 0.65625, degree 10, 60.1 bits */
    {0x1.3897994c66f46p-1, 0x1.641715b3e4489p-55, -0x1.239be52e002f2p-1, 0x1.18d5fdfb3df1bp-1, -0x1.891001495cd53p-5,
     -0x1.6305302855612p-2, 0x1.23ab420159541p-2, 0x1.4e609bbd9bb4dp-5, -0x1.d0c1e499136e4p-3, 0x1.fe5e2aa3cbb1bp-4,
     0x1.465ed80d0d2f7p-4, -0x1.2ca9de7124d55p-3}, /* [11] 0.65625 <= y <= 0.71875, degree 10, 61.6 bits */
    {0x1.1ff5244dcc614p-1, 0x1.f155f88787538p-57, -0x1.01ac3dd02d399p-1, 0x1.058e3d794bap-1, -0x1.aa938266e6075p-4,
     -0x1.0978e368dfb54p-2, 0x1.17873f80f3eafp-2, -0x1.1e118259fd2bcp-5, -0x1.40fc285057f87p-3, 0x1.1d2fb850d3da3p-3,
     0x1.50561c6889239p-8, -0x1.9cc144ba9e9f3p-4}, /* [12] 0.71875 <= y <= 0.78125, degree 10, 57.7 bits */
    {0x1.085e0993e066fp-1, 0x1.cfa556a69dc66p-57, -0x1.c4a9cb66aac49p-2, 0x1.df2d7546c4447p-2, -0x1.2192ae11cd1p-3,
     -0x1.7286220971069p-3, 0x1.eee2417db376p-3, -0x1.4a045b6636246p-4, -0x1.7256ff213d9a7p-4, 0x1.f8f1261131f1p-4,
     -0x1.36d93851d3065p-5, -0x1.a3d555e8f5cadp-5}, /* [13] 0.78125 <= y <= 0.84375, degree 10, 59.7 bits */
    {0x1.e41663113af8p-2, -0x1.9158dfcb6c91dp-57, -0x1.8ba6739f9e4efp-2, 0x1.b0d8f887044abp-2, -0x1.4d2520fb85f16p-3,
     -0x1.d884700260261p-4, 0x1.9b6cd14f49b1cp-3, -0x1.9dc89b3efec9dp-4, -0x1.359c7636342f8p-5, 0x1.7e59644274ea2p-4,
     -0x1.b936f45e6e835p-5, -0x1.bb6a424ab531p-7}, /* [14] 0.84375 <= y <= 0.90625, degree 10, 60.2 bits */
    {0x1.ba417312a948ap-2, 0x1.0ae6bec28b5a2p-57, -0x1.5873d43c65be3p-2, 0x1.82785ab4db42fp-2, -0x1.5ee5770fba718p-3,
     -0x1.0494a8c5c382dp-4, 0x1.443ad94afdf1ep-3, -0x1.a77af41d213f3p-4, -0x1.b0a656175f683p-10, 0x1.f8bdae2794e72p-5,
     -0x1.aa867b8d501c1p-5, 0x1.16faa1fbb6bd7p-7}, /* [15] 0.90625 <= y <= 0.96875, degree 10, 60.0 bits */
    {0x1.93628b47103cep-2, 0x1.ec92734f4c65fp-56, -0x1.2af65df6da66dp-2, 0x1.55c2bd8752c83p-2, -0x1.5d8e439ede80cp-3,
     -0x1.990b4016f9d68p-6, 0x1.e69eaa501fc49p-4, -0x1.83b3cd2ea2c9p-4, 0x1.4149f33c0061dp-6, 0x1.1cdbe79c3a1d3p-5,
     -0x1.55b91d38565bdp-5, 0x1.2038652fc6523p-6}, /* [16] 0.96875 <= y <= 1.03125, degree 10, 62.0 bits */
    {0x1.6f82fd54e5349p-2, 0x1.17f387af745dp-56, -0x1.02e4f8d04ad19p-2, 0x1.2bdd36f3f7db8p-2, -0x1.4f112ce3e69a5p-3,
     0x1.2ffb68476d803p-9, 0x1.5bd7ad06256c5p-4, -0x1.497ad5541460ap-4, 0x1.e36071a745377p-6, 0x1.f19e23dfa9ba2p-7,
     -0x1.df211727706bfp-6, 0x1.2e98b7b62e52ep-6}, /* [17] 1.03125 <= y <= 1.09375, degree 10, 57.5 bits */
    {0x1.4e96cbf1aa71dp-2, -0x1.d4cc30802897fp-57, -0x1.bfb38483ddc86p-3, 0x1.0573e3de85cc3p-2, -0x1.384e670524b75p-3,
     0x1.4d85b6f5cb88ap-6, 0x1.d762d610a3818p-5, -0x1.08d924607491cp-4, 0x1.0489a525cc933p-5, 0x1.5348963a7b818p-9,
     -0x1.297ccd2744ac7p-6, 0x1.f7fd9d98b5a29p-7}, /* [18] 1.09375 <= y <= 1.15625, degree 10, 60.8 bits */
    {0x1.30829556bb398p-2, 0x1.67088862b6dcap-58, -0x1.82bee903d5ac4p-3, 0x1.c5aac65271b5bp-3, -0x1.1d0902287464ep-3,
     0x1.001abba22eacp-5, 0x1.2ab14c386ccc1p-5, -0x1.970470b0995d2p-5, 0x1.e672a350d5ef8p-6, -0x1.245bdd357d203p-8,
     -0x1.403da29c5fe0fp-7, 0x1.6d21f3c2d3845p-7}, /* [19] 1.15625 <= y <= 1.21875, degree 10, 58.9 bits */
    {0x1.15208fc9d2274p-2, 0x1.56b07d64d61cep-57, -0x1.4df6e353d1128p-3, 0x1.881937d72bce7p-3, -0x1.ffff0dd723727p-4,
     0x1.2e82f76506a0cp-5, 0x1.5695b1050594ep-6, -0x1.2cafe6a652b86p-5, 0x1.a1435e088843ap-6, -0x1.f527c5f2dc1f9p-8,
     -0x1.0f5928c34293cp-8, 0x1.da34e4acd973fp-8}, /* [20] 1.21875 <= y <= 1.28125, degree 10, 57.8 bits */
    {0x1.f8891dcce991cp-3, 0x1.64cc6eaaabd72p-59, -0x1.20699f9a498e6p-3, 0x1.51ed616f6c125p-3, -0x1.c62b9cc22fac9p-4,
     0x1.3ed1d43dd0aa1p-5, 0x1.44530a168faacp-7, -0x1.ac130ef2162fbp-6, 0x1.51cf35dc8a326p-6, -0x1.14472d1dc1335p-7,
     -0x1.88726f8544bdbp-11, 0x1.147cbfabe1543p-8}, /* [21] 1.28125 <= y <= 1.34375, degree 10, 62.4 bits */
    {0x1.cb7e425de4de6p-3, 0x1.9b4ec85fc59fep-57, -0x1.f263ba88f8b19p-4, 0x1.22a8d66b75085p-3, -0x1.8f0694c3d8a59p-4,
     0x1.3b195ed411883p-5, 0x1.3ea964d0cd2bap-9, -0x1.253b873efb53fp-6, 0x1.05de16a8d8fc1p-6, -0x1.02d941fb11ce3p-7,
     0x1.122d42cc22e32p-10, 0x1.191b341a9b586p-9}, /* [22] 1.34375 <= y <= 1.40625, degree 10, 59.1 bits */
    {0x1.a2bfc54c38cd4p-3, -0x1.7abcf74a3056p-58, -0x1.aef89b9d245a2p-4, 0x1.f35d1dfaab61bp-4, -0x1.5bfcab0e611cdp-4,
     0x1.2ae6b3d8cfa4dp-5, -0x1.376f3ae021946p-9, -0x1.8057cc2fb5f49p-7, 0x1.87fefa6dde67cp-7, -0x1.bbca0a3c09864p-8,
     0x1.db1d824b478b9p-10, 0x1.bd053f7a3ec41p-11}, /* [23] 1.40625 <= y <= 1.46875, degree 10, 58.2 bits */
    {0x1.7dee4c701e098p-3, 0x1.be5681b197246p-58, -0x1.75145b48fe687p-4, 0x1.acaad84c71861p-4, -0x1.2dc21631988bfp-4,
     0x1.13aa3b7397ee6p-5, -0x1.58a667be8b141p-8, -0x1.db6fc02814779p-8, 0x1.1c9a17e66a6d2p-7, -0x1.6724e7a0f2529p-8,
     0x1.03744c1773f69p-9, 0x1.e0741fc294418p-14}, /* [24] 1.46875 <= y <= 1.53125, degree 10, 58.4 bits */
    {0x1.5cae2f1013832p-3, -0x1.92ecda83385f7p-57, -0x1.4363e3ff8039dp-4, 0x1.6fe9490e34573p-4, -0x1.048d4abc14091p-4,
     0x1.f250a05f93ab5p-6, -0x1.bd5ea6be24862p-8, -0x1.0d22f11bc9bb3p-8, 0x1.91acc98cdfa09p-8, -0x1.16e23bb4449d7p-8,
     0x1.e16b5181fe9a2p-10, -0x1.07cf3f433f061p-12}, /* [25] 1.53125 <= y <= 1.59375, degree 10, 59.3 bits */
    {0x1.3ea8e7418458p-3, 0x1.aef45b0c5834p-57, -0x1.18bd6df3f687ep-4, 0x1.3bd71e6ac251p-4, -0x1.c0871232c14b8p-5,
     0x1.bbc1f77313cfap-6, -0x1.e68d0d36ec702p-8, -0x1.0105c4b15c09fp-9, 0x1.136004c3f79efp-8, -0x1.a3852a96f5958p-9,
     0x1.998b9e69d734ep-10, -0x1.9f0d7e5dbc186p-12}, /* [26] 1.59375 <= y <= 1.65625, degree 10, 58.5 bits */
    {0x1.238de5394f56ep-3, 0x1.afea892e59647p-59, -0x1.e83bb49359d62p-5, 0x1.0f4c236eedb3p-4, -0x1.813291df5d121p-5,
     0x1.86cebbf97c90ap-6, -0x1.e930590c3e976p-8, -0x1.2032683675823p-11, 0x1.6d9172944716dp-9, -0x1.335a3d545985ap-9,
     0x1.49cdb4bdd5a81p-10, -0x1.b61267cf48bd4p-12}, /* [27] 1.65625 <= y <= 1.71875, degree 10, 59.1 bits */
    {0x1.0b12ef4d4b5d8p-3, -0x1.d41c052171013p-57, -0x1.a94a84a9c97abp-5, 0x1.d27ae000948efp-5, -0x1.4a51da6381c9bp-5,
     0x1.554e427786baep-6, -0x1.d436e2f8d7e4ep-8, 0x1.61994e99b4bdcp-12, 0x1.d237892f7e836p-10, -0x1.b80f56b879ab2p-10,
     0x1.ff26c131ff95dp-11, -0x1.8e8d80253e1c3p-12}, /* [28] 1.71875 <= y <= 1.78125, degree 10, 58.6 bits */
    {0x1.e9e8611403b63p-4, 0x1.527b1e0b24d05p-61, -0x1.73266c1757604p-5, 0x1.917cfefb4e0b5p-5, -0x1.1b041c9ecb56p-5,
     0x1.2832b4bfa701fp-6, -0x1.b1f3b2c505039p-8, 0x1.c274c68b6720bp-11, 0x1.19136c276735cp-10, -0x1.343c134ea4aeep-10,
     0x1.80d15ca4f2676p-11, -0x1.4ed7adf37ff78p-12}, /* [29] 1.78125 <= y <= 1.84375, degree 10, 58.3 bits */
    {0x1.c1e81ff89e52cp-4, 0x1.f1b650977571dp-58, -0x1.4485f2ac096e2p-5, 0x1.5a00ab1bf03bap-5, -0x1.e4cd4aca5f82p-6,
     0x1.ffadc81fd5b0ep-7, -0x1.8954f5dfe2219p-8, 0x1.292e7b9ad5e8cp-10, 0x1.35771f5c9dadfp-11, -0x1.a64a196a4288ap-11,
     0x1.1b17a909ec795p-11, -0x1.0b86ce2cf0d35p-12}, /* [30] 1.84375 <= y <= 1.90625, degree 10, 59.8 bits */
    {0x1.9db5c8aa10cb5p-4, 0x1.1966d1606e399p-58, -0x1.1c4fe13bc60f5p-5, 0x1.2a9f040dae679p-5, -0x1.9f41a4bf66498p-6,
     0x1.b86bd27d38677p-7, -0x1.5ed927981a78cp-8, 0x1.466d096789ddap-10, 0x1.1b1cc3da27311p-12, -0x1.1a34d3864205ep-11,
     0x1.9873c674a51ddp-12, -0x1.9cd1aae0a2935p-13}, /* [31] 1.90625 <= y <= 1.96875, degree 10, 60.0 bits */
    {0x1.7ced24ad3b376p-4, 0x1.c17314530e112p-58, -0x1.f3295cf1f3c2fp-6, 0x1.022324ba38d18p-5, -0x1.63d5679e4f8dep-6,
     0x1.7a23b2f173cecp-7, -0x1.35498544b4135p-8, 0x1.4893cea759949p-10, 0x1.0c8633128c1c3p-14, -0x1.6e04be40f3afcp-12,
     0x1.2186a21cfedfep-12, -0x1.365ac6ecc81ap-13}, /* [32] 1.96875 <= y <= 2.03125, degree 10, 58.5 bits */
    {0x1.5f3440d0330bep-4, -0x1.5203607f167cap-59, -0x1.b7112f3a3380dp-6, 0x1.bf093834436bep-6, -0x1.3120445ea6b71p-6,
     0x1.441bf98a764adp-7, -0x1.0e43d2ef15b05p-8, 0x1.3a695f448f185p-10, -0x1.07025d6854052p-14, -0x1.c806b4a8ba64ep-13,
     0x1.9391dc81f2863p-13, -0x1.c93ea1c58e15ap-14}, /* [33] 2.03125 <= y <= 2.09375, degree 10, 59.3 bits */
    {0x1.443a8d12e7f55p-4, -0x1.839fbc54d47fep-58, -0x1.82fcd46f9f4e9p-6, 0x1.83c3e1b822bfep-6, -0x1.05e31ae91bfd4p-6,
     0x1.158010a34259ep-7, -0x1.d53b89ae65ad3p-9, 0x1.233427ee059acp-10, -0x1.1c493dd514cfap-13, -0x1.0b895840326p-13,
     0x1.14643a03b5c07p-13, -0x1.4b36f4c0d985ep-14}, /* [34] 2.09375 <= y <= 2.15625, degree 10, 60.3 bits */
    {0x1.2bb7ff1ae4378p-4, 0x1.72f414f0c39bcp-58, -0x1.55c5f231b2ca6p-6, 0x1.50f6e8bab8d16p-6, -0x1.c20da3c24cf8fp-7,
     0x1.daec219d319f6p-8, -0x1.955686f6538adp-9, 0x1.07be9acbb54abp-10, -0x1.69f2d4fa006bap-13, -0x1.1ae0dc1363ef6p-14,
     0x1.7344a9c161ec5p-14, -0x1.d8de9544009dap-15}, /* [35] 2.15625 <= y <= 2.21875, degree 10, 58.6 bits */
    {0x1.156c3d874f56cp-4, -0x1.5eff2b3ff8191p-58, -0x1.2e725fcb30309p-6, 0x1.255d11cebff47p-6, -0x1.8333383e0b8b1p-7,
     0x1.9657cdd9eab88p-8, -0x1.5cde441825013p-9, 0x1.d62f400a7b463p-11, -0x1.87026e6e94e2dp-13, -0x1.d9425b4a12713p-16,
     0x1.e71f532b8c818p-15, -0x1.4d053486c13e9p-15}, /* [36] 2.21875 <= y <= 2.28125, degree 10, 58.1 bits */
    {0x1.011dd7fbbaa4ep-4, -0x1.d2fe2a0436a6bp-58, -0x1.0c2d6bb0a0999p-6, 0x1.ffc5a80d60f1cp-7, -0x1.4d96ef009acdfp-7,
     0x1.5bbd4b8108f23p-8, -0x1.2b78798997124p-9, 0x1.9e3c311f30d6bp-11, -0x1.85bf8c5f7ae2bp-13, -0x1.cc90a3c1d7a54p-19,
     0x1.35e7a1f506686p-15, -0x1.cedcd83ff3064p-16}, /* [37] 2.28125 <= y <= 2.34375, degree 10, 58.3 bits */
    {0x1.dd331be70e56cp-5, 0x1.0c829c919e2e7p-59, -0x1.dc843cc46686bp-7, 0x1.bf3de228c7621p-7, -0x1.1fd4ce54f358cp-7,
     0x1.29bc0cf45b724p-8, -0x1.0097077968cebp-9, 0x1.69c89f38fecbcp-11, -0x1.728ea256ea1bp-13, 0x1.81a9838647289p-17,
     0x1.79729f67071d9p-16, -0x1.3d317a843a92ep-16}, /* [38] 2.34375 <= y <= 2.40625, degree 10, 58.6 bits */
    {0x1.bb634a6bed274p-5, 0x1.f3d64f2370f69p-59, -0x1.a82cb4ce23374p-7, 0x1.87981156ae931p-7, -0x1.f17ae35125316p-8,
     0x1.fe35f72b293fbp-9, -0x1.b72923e912c25p-10, 0x1.39eb996a2c6f2p-11, -0x1.55ae1f59151eep-13, 0x1.4c8bd8c477f89p-16,
     0x1.acd4d81f06732p-17, -0x1.abefbb08c3ed6p-17}, /* [39] 2.40625 <= y <= 2.46875, degree 10, 59.4 bits */
    {0x1.9c7a9fdf3135p-5, -0x1.9510960afe92dp-59, -0x1.7a4d766623ffep-7, 0x1.57862545ef842p-7, -0x1.ae9e0ad6eab89p-8,
     0x1.b58f63ac9093dp-9, -0x1.778cf378a0e83p-10, 0x1.0f0f4d9fa781dp-11, -0x1.3479d14981a22p-13, 0x1.8faeac35e6daap-16,
     0x1.ab8fe53f813b9p-18, -0x1.1b3e5c4ca1d9p-17}, /* [40] 2.46875 <= y <= 2.53125, degree 10, 58.3 bits */
    {0x1.803043d96dbc9p-5, -0x1.396bf96ba3ce2p-62, -0x1.52062f3895d86p-7, 0x1.2ded4f5a9f9d9p-7, -0x1.755dc5e3bb753p-8,
     0x1.77a8148db32acp-9, -0x1.410f477ecb38p-10, 0x1.d265eb94cec13p-12, -0x1.12528c42130e6p-13, 0x1.a482ffb97ac51p-16,
     0x1.2e0e75bb67b35p-19, -0x1.6de4dd2422447p-18}, /* [41] 2.53125 <= y <= 2.59375, degree 10, 58.5 bits */
    {0x1.66432838ea0ebp-5, 0x1.e81ed8350f708p-62, -0x1.2e971f3b956fep-7, 0x1.09ddff5f47edfp-7, -0x1.4447bd5b114b5p-8,
     0x1.42e5afa04907fp-9, -0x1.127cf48c20337p-10, 0x1.902e36464f1aep-12, -0x1.e2842307a5832p-14, 0x1.9ce99638c5d55p-16,
     -0x1.496a36104f92bp-22, -0x1.c8f3a9bfced95p-19}, /* [42] 2.59375 <= y <= 2.65625, degree 10, 60.4 bits */
    {0x1.4e792aab9ad3ap-5, 0x1.fd87cf64eb7d2p-60, -0x1.0f5c206f293b3p-7, 0x1.d51a36dbfd1f1p-8, -0x1.1a229365cc168p-8,
     0x1.15e89b6f06bc2p-9, -0x1.d57f51f73cb06p-11, 0x1.56b584e36c1d9p-12, -0x1.a4db73f65a3b4p-14, 0x1.84ded8609c973p-16,
     -0x1.e612be6756c7fp-20, -0x1.0f2b82f0bf712p-19}, /* [43] 2.65625 <= y <= 2.71875, degree 10, 59.4 bits */
    {0x1.389e4e858bdedp-5, 0x1.3649dbb360051p-59, -0x1.e790ec83a5527p-8, 0x1.9e9c8d6cf094ap-8, -0x1.ebca75c826f29p-9,
     0x1.df09a676a6a5bp-10, -0x1.91bfa5011257p-11, 0x1.251c6b1344e3dp-12, -0x1.6ccba09969035p-14, 0x1.644725b3deaa4p-16,
     -0x1.5f3c4d76a4aaep-19, -0x1.272d9de88ccd9p-20}, /* [44] 2.71875 <= y <= 2.78125, degree 10, 61.4 bits */
    {0x1.24840ca5773c4p-5, -0x1.506b508522bc1p-62, -0x1.b6c68a8f9b75bp-8, 0x1.6f1e1e9fab526p-8, -0x1.ad5f0d19f047cp-9,
     0x1.9d763b3ce2593p-10, -0x1.58084949df531p-11, 0x1.f4faf596dacbap-13, -0x1.3ab7bc8f69e2fp-14,
     0x1.403625c8806c3p-16, -0x1.8eb4934d94636p-19, -0x1.0c368ecba6b11p-21},
     /* [45] 2.78125 <= y <= 2.84375, degree 10, 61.2 bits */
    {0x1.1200b738c2b86p-5, -0x1.77b82a83631c3p-61, -0x1.8b89314205396p-8, 0x1.45a5c011fd255p-8, -0x1.77879d19f0c5p-9,
     0x1.6565ae2a38001p-10, -0x1.26df8b42a8299p-11, 0x1.abf681db49335p-13, -0x1.0e8ec4cadca6p-14, 0x1.1bd5645e71192p-16,
     -0x1.97f046f012e18p-19, -0x1.0028057a97606p-23}, /* [46] 2.84375 <= y <= 2.90625, degree 10, 59.9 bits */
    {0x1.00eeef4d71a2ep-5, 0x1.51cc2e1ea2b0ap-60, -0x1.6525bd0120855p-8, 0x1.215f2f96ca078p-8, -0x1.49031573316e7p-9,
     0x1.3568c9cfbd565p-10, -0x1.f9ff2da40a324p-12, 0x1.6d9006582a1e4p-13, -0x1.cff91bd425deep-15, 0x1.f20acec43086p-17,
     -0x1.8a1d4c6176461p-19, 0x1.e1d3400f1a1bbp-24}, /* [47] 2.90625 <= y <= 2.96875, degree 10, 59.0 bits */
    {0x1.e25a548b7a1e6p-6, -0x1.b632898ec7593p-63, -0x1.430191a13aadfp-8, 0x1.019558dde45fep-8, -0x1.20c181c145753p-9,
     0x1.0c48a66696112p-10, -0x1.b2a1d20b8f9c3p-12, 0x1.3852e95cc4b2ep-13, -0x1.8d139fb8c6ap-15, 0x1.b19a8497292cep-17,
     -0x1.6f544c53fecbap-19, 0x1.06385e91fbdb3p-22}, /* [48] 2.96875 <= y <= 3.03125, degree 10, 58.3 bits */
    {0x1.c53a8ad3aa18p-6, -0x1.574e14ae2ecc5p-60, -0x1.249703e484bdp-8, 0x1.cb5b0aea98fd2p-9, -0x1.fbb8a548109aep-10,
     0x1.d1fc5a1b15a24p-11, -0x1.75c979d1aba68p-12, 0x1.0af3c1f32b256p-13, -0x1.5361525862016p-15,
     0x1.774e62240b625p-17, -0x1.4e2cf6c66e1e8p-19, 0x1.4de387175b793p-22},
     /* [49] 3.03125 <= y <= 3.09375, degree 10, 58.5 bits */
    {0x1.aa484bfc03d26p-6, 0x1.3a252664e65cp-61, -0x1.0972505481e43p-8, 0x1.9a46a2d2ebc72p-9, -0x1.bf1fbb7cd05b8p-10,
     0x1.955590486aedap-11, -0x1.41df7f5104ce8p-12, 0x1.c89f3842dab27p-14, -0x1.21d2ae81c8476p-15,
     0x1.43695d63feb25p-17, -0x1.2ada3bada3b4dp-19, 0x1.689a3264aaaecp-22},
     /* [50] 3.09375 <= y <= 3.15625, degree 10, 59.4 bits */
    {0x1.9152c8d84f6abp-6, 0x1.289ec5d33ec06p-60, -0x1.e25e11d9cbfbep-9, 0x1.6f0a8965ac24cp-9, -0x1.8a6bcb15e2654p-10,
     0x1.612443a5db0fap-11, -0x1.158a68602129bp-12, 0x1.86d2fdff3344ep-14, -0x1.eec6ed1ee7818p-16,
     0x1.15c2f4e01aa1fp-17, -0x1.07f0cc9c75bbbp-19, 0x1.676cbe7bfeb34p-22},
     /* [51] 3.15625 <= y <= 3.21875, degree 10, 59.1 bits */
    {0x1.7a2e026ce39dfp-6, -0x1.1cfcddda5ff93p-60, -0x1.b6ebcd6d4f577p-9, 0x1.48e3ed6337ebfp-9, -0x1.5c8200594b15fp-10,
     0x1.3429a160a4638p-11, -0x1.df4a5def92221p-13, 0x1.4ece216a3d5fcp-14, -0x1.a645d13fb56d3p-16,
     0x1.dbeb4492762cep-18, -0x1.cde1a8c04ea7bp-20, 0x1.55ccfd9c945cfp-22},
     /* [52] 3.21875 <= y <= 3.28125, degree 10, 59.6 bits */
    {0x1.64b2451a0b3a1p-6, -0x1.a6833812c7bdap-63, -0x1.8ff5df05dd9e8p-9, 0x1.272b4a9431716p-9, -0x1.3471744b668d8p-10,
     0x1.0d57a719aad9ep-11, -0x1.9e6f23350db34p-13, 0x1.1f19c744d8551p-14, -0x1.686f183ba2eap-16, 0x1.96fa3bc9df4f1p-18,
     -0x1.9149ac70eec35p-20, 0x1.3b4a8458a96c5p-22}, /* [53] 3.28125 <= y <= 3.34375, degree 10, 61.8 bits */
    {0x1.50bbb303766dcp-6, -0x1.8b8c7dd4202f4p-60, -0x1.6cf7c50e2ee26p-9, 0x1.095059b7cef6fp-9, -0x1.116cae14ef199p-10,
     0x1.d792fedf4310fp-12, -0x1.66dec2864743fp-13, 0x1.eceb07655dbe4p-15, -0x1.33c07b22a6b61p-16,
     0x1.5b933fd8411ecp-18, -0x1.5ac50c69c56b6p-20, 0x1.1ccad1d989422p-22},
     /* [54] 3.34375 <= y <= 3.40625, degree 10, 59.1 bits */
    {0x1.3e29dbe5d4863p-6, 0x1.b7e1e736befb6p-60, -0x1.4d7dc1822abfp-9, 0x1.ddad4586cb104p-10, -0x1.e5885b574bc9dp-11,
     0x1.9d7a1fb07d379p-12, -0x1.373573539b2f9p-13, 0x1.a7a0a0ea2e8bbp-15, -0x1.06e724202e097p-16,
     0x1.2897704392e09p-18, -0x1.2a6d687ca7614p-20, 0x1.fac6f5c00eaf1p-23},
     /* [55] 3.40625 <= y <= 3.46875, degree 10, 59.2 bits */
    {0x1.2cdf60c2cd19fp-6, 0x1.09b225bf56828p-60, -0x1.31228fae800dp-9, 0x1.aea52e722a376p-10, -0x1.afc3a9e18c94p-11,
     0x1.6b1b1459b03fep-12, -0x1.0e46191f494a1p-13, 0x1.6c842d14cce4cp-15, -0x1.c1792efbe3cd9p-17,
     0x1.f9ecdb769d67dp-19, -0x1.00056cf4b1292p-20, 0x1.bde3a78bc796bp-23},
     /* [56] 3.46875 <= y <= 3.53125, degree 10, 61.4 bits */
    {0x1.1cc1a1fbeebap-6, -0x1.bea708222f32bp-60, -0x1.178d6f4d26a76p-9, 0x1.84ce3d5c03937p-10, -0x1.808a1687455a6p-11,
     0x1.3f5db464e98f7p-12, -0x1.d6239e7e7c81dp-14, 0x1.3a0bc351fd962p-15, -0x1.80855dc9a8dffp-17,
     0x1.af6b6c8c8e666p-19, -0x1.b63f59d6b86b1p-21, 0x1.850788bc7e2eep-23},
     /* [57] 3.53125 <= y <= 3.59375, degree 10, 58.5 bits */
    {0x1.0db876a030722p-6, -0x1.764692e73e56p-60, -0x1.007077e655aap-9, 0x1.5f8706699c2a2p-10, -0x1.56fefaa12c519p-11,
     0x1.195399c3e0f12p-12, -0x1.99817468f0a9cp-14, 0x1.0ee9838703584p-15, -0x1.493e7d197592cp-17,
     0x1.6fe7b8f2d8a69p-19, -0x1.766fa40cb2077p-21, 0x1.513f89afde6fap-23},
     /* [58] 3.59375 <= y <= 3.65625, degree 10, 58.3 bits */
    {0x1.ff5bd7ab85ca4p-7, -0x1.05d7efd00dc2cp-62, -0x1.d70e52ea78177p-10, 0x1.3e435cc8216c6p-10,
     -0x1.3264bf96aa49fp-11, 0x1.f06350a91c451p-13, -0x1.6537e48fb9a21p-14, 0x1.d4054ff6d6d87p-16,
     -0x1.1a2f81b898347p-17, 0x1.39d2536f32fe5p-19, -0x1.3f850c7b983e4p-21, 0x1.22ebdb929b47ep-23},
     /* [59] 3.65625 <= y <= 3.71875, degree 10, 61.1 bits */
    {0x1.e51c16d7340fep-7, -0x1.d6f431749ca4ep-63, -0x1.b12a621edf425p-10, 0x1.2089546641925p-10,
     -0x1.12183fcaf11abp-11, 0x1.b695392a9d838p-13, -0x1.3810bea9dc5d2p-14, 0x1.94cf9a6cb44acp-16,
     -0x1.e434f761b4fc7p-18, 0x1.0bcd6ccb84a74p-19, -0x1.106e4532f0d26p-21, 0x1.f40467ccd1928p-24},
     /* [60] 3.71875 <= y <= 3.78125, degree 10, 61.7 bits */
    {0x1.cc8d517788195p-7, 0x1.f6dfc5f9376cbp-62, -0x1.8ecab38881713p-10, 0x1.05eeb5fdddbf5p-10, -0x1.eb19bf2aebddep-12,
     0x1.8414eed6268p-13, -0x1.1104c46a0e27p-14, 0x1.5e9ca2d447904p-16, -0x1.9fe2293c2e133p-18, 0x1.c9529eee22c5fp-20,
     -0x1.d054ee1c822ccp-22, 0x1.ac741071e3a24p-24}, /* [61] 3.78125 <= y <= 3.84375, degree 10, 58.8 bits */
    {0x1.b58e664374b0cp-7, 0x1.8837c2d773f2fp-64, -0x1.6f914644634c9p-10, 0x1.dc2da71a3b2c7p-11, -0x1.b89281538d9fp-12,
     0x1.57e546eaad568p-13, -0x1.de68b2e1b0bd4p-15, 0x1.301556f16cc07p-16, -0x1.659ba9d54486fp-18,
     0x1.86c012b382628p-20, -0x1.8b9de9045f499p-22, 0x1.6e5348af8d4a1p-24},
     /* [62] 3.84375 <= y <= 3.90625, degree 10, 60.1 bits */
    {0x1.a0011abd88e83p-7, -0x1.91261180cd29ep-61, -0x1.532aefade17dep-10, 0x1.b1615c8a41436p-11,
     -0x1.8bc8ee5fc7118p-12, 0x1.312d6c2039762p-13, -0x1.a3c2b53bf4d18p-15, 0x1.081734bf26761p-16,
     -0x1.33dc66c92183ap-18, 0x1.4e21a595b50afp-20, -0x1.5112f45a60089p-22, 0x1.38b1d0e33870bp-24},
     /* [63] 3.90625 <= y <= 3.96875, degree 10, 58.8 bits */
    {0x1.8bc9d2b540fe4p-7, -0x1.8100781370d5p-61, -0x1.394dff73c078ap-10, 0x1.8aeac2bf539d3p-11, -0x1.640757bc3e066p-12,
     0x1.0f3365def8832p-13, -0x1.70d3dd5451083p-15, 0x1.cb583fadd8a8bp-17, -0x1.095acdb3d4ab1p-18,
     0x1.1df712c027e6ep-20, -0x1.1f409bbb2649fp-22, 0x1.0a9a0af41ca4p-24}
     /* [64] 3.96875 <= y <= 4.03125, degree 10, 59.3 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_eps_zero_force)

/* eps at zero overlap by x = beta^5, 2^-40 <= x < 2^14: 432 rows of degree 10 in y = beta^5 2^-k, 8 to each octave k = -40 ... 13.
 * Relative error of the approximation: 2^-53.8 at most, proved for the whole cell of each row. */
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_FIRST 9.094947017729282e-13
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_FIRST_OCTAVE (-40)
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_ROWS 432
#define COR_ROWS_POWER_EPS_ZERO_OVERLAP_END 16384.0
COR_ROWS(double, cor_rows_power_eps_zero_overlap, 432, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.fdabdc8d2a61ep-1, -0x1.9fb723b328081p-58, -0x1.bfa1c7b43a87p-11, 0x1.518027dc0ea81p-12, -0x1.7d59cebde629ep-13,
     0x1.f69dda231c3e2p-14, -0x1.67952ffed1508p-14, 0x1.0ec7e5c8a64fep-14, -0x1.a65d8d0e3db75p-15,
     0x1.51ebe9e62115fp-15, -0x1.158a89393b304p-15, 0x1.cbd6c88a473fdp-16},
     /* [0] 1 <= y <= 1.125 2^-40, degree 10, 67.4 bits */
    {0x1.fd9e7d3af560fp-1, -0x1.a456173c3935bp-55, -0x1.9978c7cc338afp-11, 0x1.143d5c7dcfe4cp-12,
     -0x1.17470ac1698d8p-13, 0x1.495754eab2a89p-14, -0x1.a5a22a4123c0dp-15, 0x1.1c162c5d037e5p-15,
     -0x1.8c7a90341dcbdp-16, 0x1.1bd20bb05e72bp-16, -0x1.a09269dae2964p-17, 0x1.34c28d21c9062p-17},
     /* [1] 1.125 <= y <= 1.25 2^-40, degree 10, 68.3 bits */
    {0x1.fd923371b0d8p-1, 0x1.5455faf76e133p-59, -0x1.79ec164da418ep-11, 0x1.cd5c7420b4cfbp-13, -0x1.a604301bb5b5bp-14,
     0x1.c245e66144b96p-15, -0x1.04c72a98c6c28p-15, 0x1.3df1f288b7aaap-16, -0x1.9179788daa0ap-17, 0x1.0406aeccea2f6p-17,
     -0x1.58f5a3d13815bp-18, 0x1.cea6ddbecb25ep-19}, /* [2] 1.25 <= y <= 1.375 2^-40, degree 10, 69.2 bits */
    {0x1.fd86d13909504p-1, 0x1.6edd3643b9db6p-56, -0x1.5f5bb74c76fb1p-11, 0x1.87a4e0dc0e144p-13, -0x1.47188a67b6329p-14,
     0x1.3ea6aa5d3f2c3p-15, -0x1.5100aacc17751p-16, 0x1.7726dc5ebea0bp-17, -0x1.b08515b0380a6p-18,
     0x1.ff8c8e036400cp-19, -0x1.35956b475f8b2p-19, 0x1.7b187f9d3bcd7p-20},
     /* [3] 1.375 <= y <= 1.5 2^-40, degree 10, 68.6 bits */
    {0x1.fd7c3372e2207p-1, -0x1.0e3e6a0570718p-55, -0x1.48a742d756479p-11, 0x1.5109851466c5ap-13,
     -0x1.02f8d028edd0fp-14, 0x1.d0354d076ed5bp-16, -0x1.c3ab2c77f4921p-17, 0x1.ce9350ea2079cp-18,
     -0x1.eaa61d0d6c6f2p-19, 0x1.0af027a9c413dp-19, -0x1.29142c034af44p-20, 0x1.4ead2cb3cd6f6p-21},
     /* [4] 1.5 <= y <= 1.625 2^-40, degree 10, 72.2 bits */
    {0x1.fd723ea5fef9p-1, -0x1.fdb64ed2cb152p-57, -0x1.350028be600d5p-11, 0x1.256abe976b043p-13, -0x1.a1833d64f29aap-15,
     0x1.5a7ad3c1dfdf7p-16, -0x1.382642beff717p-17, 0x1.2801df1473e09p-18, -0x1.22b7252fbfabp-19, 0x1.24e5987800097p-20,
     -0x1.2db00fa85c91p-21, 0x1.3ab0bcb31855ep-22}, /* [5] 1.625 <= y <= 1.75 2^-40, degree 10, 68.3 bits */
    {0x1.fd68dce5641c3p-1, 0x1.8ee2403fc5fe7p-55, -0x1.23ce63dfface7p-11, 0x1.01fc516db44d4p-13, -0x1.55c81cf11f47dp-15,
     0x1.0812c88ca2fd8p-16, -0x1.bb00a9afafe43p-18, 0x1.871f5c2b276cp-19, -0x1.65a3a587ba2d3p-20, 0x1.4f793698fd37bp-21,
     -0x1.4198bcff72becp-22, 0x1.3851f3a71c1f8p-23}, /* [6] 1.75 <= y <= 1.875 2^-40, degree 10, 68.6 bits */
    {0x1.fd5ffc6527b67p-1, -0x1.391e7bfe87a73p-56, -0x1.149f776287373p-11, 0x1.c993b9ad53731p-14,
     -0x1.1b8c52915a07cp-15, 0x1.99e4a1ac0795p-17, -0x1.41a1e13c3e55ep-18, 0x1.09a565dbf984bp-19,
     -0x1.c677b6c8c33ccp-21, 0x1.8ecc43f86cb17p-22, -0x1.658879393486ep-23, 0x1.44d11e3296b5bp-24},
     /* [7] 1.875 <= y <= 2 2^-40, degree 10, 68.2 bits */
    {0x1.fd537e9bfe2f9p-1, 0x1.6a1f0009d7eb1p-55, -0x1.00e36f8e1a7dcp-10, 0x1.83733af132719p-12, -0x1.b5d1d6b2546c7p-13,
     0x1.20883c400fbd4p-13, -0x1.9cdaee679f541p-14, 0x1.36e744c4d9a8p-14, -0x1.e4f4d88618b6fp-15, 0x1.8400f1edff6f1p-15,
     -0x1.3ead96e27a39cp-15, 0x1.08001f88d4791p-15}, /* [8] 1 <= y <= 1.125 2^-39, degree 10, 66.8 bits */
    {0x1.fd442579054eap-1, 0x1.40c10fda7e86dp-57, -0x1.d5f826f10ba13p-11, 0x1.3d1e4c186f85bp-12, -0x1.40a0bc789061ep-13,
     0x1.7a1e7518c9c9dp-14, -0x1.e417f375f0cf5p-15, 0x1.462d68038267fp-15, -0x1.c73aa373532f3p-16,
     0x1.45e1a24c70913p-16, -0x1.de4fb705dacd9p-17, 0x1.628633311703p-17},
     /* [9] 1.125 <= y <= 1.25 2^-39, degree 10, 67.7 bits */
    {0x1.fd360af10878bp-1, -0x1.af0d200aefe4p-56, -0x1.b1c04e71fb583p-11, 0x1.08d05e7405a16p-12, -0x1.e47ed8b3c8eb7p-14,
     0x1.027a6b9469f78p-14, -0x1.2b6801bdc4db9p-15, 0x1.6d0c87be80f3dp-16, -0x1.ccf5faaaa9698p-17,
     0x1.2a8ee2069863bp-17, -0x1.8c14fe953d7f8p-18, 0x1.099c55b9476c6p-18},
     /* [10] 1.25 <= y <= 1.375 2^-39, degree 10, 67.8 bits */
    {0x1.fd28fa3d53e82p-1, 0x1.e6e941bbc9707p-57, -0x1.9341bdfa85c9bp-11, 0x1.c196f2d2104dep-13, -0x1.7784a969ee9d4p-14,
     0x1.6dd6985cd1e52p-15, -0x1.82eb14e1116cdp-16, 0x1.aeba22bc0b5a1p-17, -0x1.f09a1d6f57b6ep-18,
     0x1.25ac9358588d6p-18, -0x1.6375ed6d3989cp-19, 0x1.b3472b13767eap-20},
     /* [11] 1.375 <= y <= 1.5 2^-39, degree 10, 71.9 bits */
    {0x1.fd1ccb0cdc914p-1, 0x1.2137625c1f2e2p-59, -0x1.793157c40627p-11, 0x1.82e6335fc9df3p-13, -0x1.294e78568c569p-14,
     0x1.0a790239afb14p-15, -0x1.03482c8aa743dp-16, 0x1.098c7867fcc18p-17, -0x1.19ab64011a77ap-18,
     0x1.327d52581177bp-19, -0x1.5519a36d5f3c7p-20, 0x1.8045e330a707dp-21},
     /* [12] 1.5 <= y <= 1.625 2^-39, degree 10, 69.3 bits */
    {0x1.fd115dd540cbap-1, -0x1.03f873e1f5d05p-55, -0x1.62a1f51f214fp-11, 0x1.50d282117b6a7p-13, -0x1.df4fa211a90fp-15,
     0x1.8dc7f5fb4033ep-16, -0x1.6660c8a9f1f08p-17, 0x1.53da4a9f3842fp-18, -0x1.4dc8601594416p-19,
     0x1.504ac7c51e186p-20, -0x1.5a63be847d57bp-21, 0x1.695299a1b2ba9p-22},
     /* [13] 1.625 <= y <= 1.75 2^-39, degree 10, 70.0 bits */
    {0x1.fd06996aad573p-1, 0x1.ff589a8c86e27p-56, -0x1.4ee50e75a5617p-11, 0x1.28258f596396ep-13, -0x1.885e0c9f19f5ep-15,
     0x1.2f2bba9fa6bd1p-16, -0x1.fc9b3dddb19f2p-18, 0x1.c10da9927d644p-19, -0x1.9a9e32402f1f4p-20,
     0x1.812c9b33370e8p-21, -0x1.713efc9ab37c4p-22, 0x1.66994ea8f1a6fp-23},
     /* [14] 1.75 <= y <= 1.875 2^-39, degree 10, 68.5 bits */
    {0x1.fcfc695ee4d03p-1, -0x1.476321ba222a4p-56, -0x1.3d773372fb41p-11, 0x1.06a0e01792f94p-13, -0x1.4583250324eccp-15,
     0x1.d6938d244b6fap-17, -0x1.71428b2d9e0b9p-18, 0x1.30fd71630050bp-19, -0x1.04e4ad0384167p-20,
     0x1.c9e097f730161p-22, -0x1.9a81258e120ep-23, 0x1.74f1ef6d9a902p-24},
     /* [15] 1.875 <= y <= 2 2^-39, degree 10, 68.8 bits */
    {0x1.fcee13787de76p-1, -0x1.3e7f7c28d4c9ap-55, -0x1.26cff7448c98ap-10, 0x1.bcc0763a98986p-12,
     -0x1.f69c19c1debaap-13, 0x1.4b3eb0262424fp-13, -0x1.d9fc84fe3ecd1p-14, 0x1.64f2613692d2p-14,
     -0x1.1664a7f810fb4p-14, 0x1.bd7ae0da129e9p-15, -0x1.6de3bd82a34fap-15, 0x1.2f1d6bb6d2487p-15},
     /* [16] 1 <= y <= 1.125 2^-38, degree 10, 67.2 bits */
    {0x1.fcdc76548d724p-1, 0x1.93343e28466a7p-56, -0x1.0dab5be81cc41p-10, 0x1.6c033c33b8205p-12, -0x1.7012032301b61p-13,
     0x1.b2168594eb5c6p-14, -0x1.15e210dca25a1p-14, 0x1.767a75d91654ap-15, -0x1.0553314c2dadap-15,
     0x1.7626b2646f6dbp-16, -0x1.12954aa41d73p-16, 0x1.970be17aa6177p-17},
     /* [17] 1.125 <= y <= 1.25 2^-38, degree 10, 69.6 bits */
    {0x1.fccc46e8e290cp-1, 0x1.71d1a8e2432c9p-55, -0x1.f1c3dc9915eafp-11, 0x1.2ff82107a064cp-12, -0x1.1616c571911ddp-13,
     0x1.28bc0781c0d5dp-14, -0x1.57bb2638da342p-15, 0x1.a31a00d57333dp-16, -0x1.089cd00c96f65p-16,
     0x1.56c6fc99d8de7p-17, -0x1.c6c058a487dc3p-18, 0x1.30f52014c4f1p-18},
     /* [18] 1.25 <= y <= 1.375 2^-38, degree 10, 69.0 bits */
    {0x1.fcbd489fba8acp-1, 0x1.a92291f8c6c97p-57, -0x1.cec314838597cp-11, 0x1.02078ae886635p-12, -0x1.af126eb357c43p-14,
     0x1.a3fad5691ddd3p-15, -0x1.bc31a2372f649p-16, 0x1.ee7feb801c0ep-17, -0x1.1d11c65e7bb57p-17, 0x1.512aaf5bab8acp-18,
     -0x1.981bf72eb6debp-19, 0x1.f3c1208afe584p-20}, /* [19] 1.375 <= y <= 1.5 2^-38, degree 10, 70.5 bits */
    {0x1.fcaf4d31136b1p-1, -0x1.cbe4b1f34c869p-57, -0x1.b0d8406603c44p-11, 0x1.bc1833756b568p-13,
     -0x1.55493506f58bfp-14, 0x1.31e7d9cc3c8d6p-15, -0x1.29a91ba1dab26p-16, 0x1.30dccac915f96p-17,
     -0x1.43604ef1dde49p-18, 0x1.5fe08347f07ebp-19, -0x1.879e4f1634e3bp-20, 0x1.b930c400c3f97p-21},
     /* [20] 1.5 <= y <= 1.625 2^-38, degree 10, 69.6 bits */
    {0x1.fca2306813123p-1, -0x1.a9c8eb6e5a639p-55, -0x1.96f3211a941b6p-11, 0x1.829c36c415938p-13,
     -0x1.131aa0a94d966p-14, 0x1.c8a40e7475e56p-16, -0x1.9b6bc9c4c3fa7p-17, 0x1.8629dd3226635p-18,
     -0x1.7f33db255c608p-19, 0x1.8216fd6c5013dp-20, -0x1.8db0252bce2dfp-21, 0x1.9ed669a746adp-22},
     /* [21] 1.625 <= y <= 1.75 2^-38, degree 10, 68.9 bits */
    {0x1.fc95d55fb90a5p-1, 0x1.610584254d9a8p-57, -0x1.804b5b82d143ep-11, 0x1.53eb19612c30bp-13, -0x1.c26653182c5dfp-15,
     0x1.5c0723c51cea2p-16, -0x1.23f090e14fd54p-17, 0x1.01c349bca9674p-18, -0x1.d76906484ae35p-20,
     0x1.ba34f7dd90cf9p-21, -0x1.a7ed1a96edbfdp-22, 0x1.9bb510bcd4b0bp-23},
     /* [22] 1.75 <= y <= 1.875 2^-38, degree 10, 68.5 bits */
    {0x1.fc8a24a42e245p-1, -0x1.4c9f89cda3963p-56, -0x1.6c4a0c7dd1005p-11, 0x1.2d71599969488p-13, -0x1.75a72f5f75b3p-15,
     0x1.0e195a3ead37ep-16, -0x1.a7e80a173d6b4p-18, 0x1.5e225c9d8cb7cp-19, -0x1.2b8435a8d418cp-20,
     0x1.06d5eb8c7d251p-21, -0x1.d74a81d4e8e86p-23, 0x1.ac2cd784a4cf7p-24},
     /* [23] 1.875 <= y <= 2 2^-38, degree 10, 70.4 bits */
    {0x1.fc79b18071f1p-1, -0x1.609b22ca23b93p-57, -0x1.5249c8294a7a3p-10, 0x1.fe799ab8e01d2p-12, -0x1.207799a5ebfaap-12,
     0x1.7c3f752ce2363p-13, -0x1.100fffd436cddp-13, 0x1.99c6edcd4de1cp-14, -0x1.3f9a8b5a1c67bp-14,
     0x1.ff6ede09bab83p-15, -0x1.a410c6368e2bap-15, 0x1.5c001834974b8p-15},
     /* [24] 1 <= y <= 1.125 2^-37, degree 10, 66.7 bits */
    {0x1.fc657b766b7b4p-1, -0x1.5f68520351cc7p-57, -0x1.356e12179286ap-10, 0x1.a1cc0ce770f73p-12,
     -0x1.a67e2b61e3b8dp-13, 0x1.f24c384dcd308p-14, -0x1.3effa279f579fp-14, 0x1.ade5c808b6292p-15,
     -0x1.2c0143db5479cp-15, 0x1.ad89e111219b9p-16, -0x1.3b3c5b64289aap-16, 0x1.d3510177ab5ddp-17},
     /* [25] 1.125 <= y <= 1.25 2^-37, degree 10, 67.6 bits */
    {0x1.fc52e92e20b5ap-1, 0x1.1dce3d501a253p-59, -0x1.1d926dadb053bp-10, 0x1.5ce0509a6be88p-12, -0x1.3f33c197cd271p-13,
     0x1.549f56e2aabe3p-14, -0x1.8a95934a07ae9p-15, 0x1.e11e5db852955p-16, -0x1.2fc685c3d6bc3p-16,
     0x1.89840520a37c9p-17, -0x1.05094032cd2cbp-17, 0x1.5e1b90c0b32p-18},
     /* [26] 1.25 <= y <= 1.375 2^-37, degree 10, 67.5 bits */
    {0x1.fc41b51caa183p-1, 0x1.ea0afd6e8758cp-56, -0x1.097c2a3635962p-10, 0x1.28251c0872276p-12, -0x1.eecbb7f6231a2p-14,
     0x1.e21709218d7dp-15, -0x1.fde767b3783dcp-16, 0x1.1bd56a3d5b4c5p-16, -0x1.4741a09aeb97dp-17, 0x1.83120b207d6d2p-18,
     -0x1.d48536b71d251p-19, 0x1.1ede9a5faf4e8p-19}, /* [27] 1.375 <= y <= 1.5 2^-37, degree 10, 67.3 bits */
    {0x1.fc31aa2278628p-1, 0x1.85285548effc1p-55, -0x1.f0a2383109ddp-11, 0x1.fdb0144cfe87bp-13, -0x1.87bb64cceec5ep-14,
     0x1.5f24343e2811p-15, -0x1.55b0a1d2aa8dbp-16, 0x1.5df7904827cc5p-17, -0x1.733a6cdf5357p-18, 0x1.93f43490f0c4dp-19,
     -0x1.c195819a8023dp-20, 0x1.fa8018f7222ecp-21}, /* [28] 1.5 <= y <= 1.625 2^-37, degree 10, 68.0 bits */
    {0x1.fc229eb092b43p-1, 0x1.b4acfc90f4195p-55, -0x1.d2ea04cdadf08p-11, 0x1.bbb4ff0f4113p-13, -0x1.3bc389617559cp-14,
     0x1.0614927270bbep-15, -0x1.d845cfbf27fb9p-17, 0x1.bfe2492e982cdp-18, -0x1.b7e736cd4e2dp-19, 0x1.bb39d7a220fedp-20,
     -0x1.c88c4199f5be5p-21, 0x1.dc3df9ccc6f0ap-22}, /* [29] 1.625 <= y <= 1.75 2^-37, degree 10, 68.8 bits */
    {0x1.fc14719ca73eap-1, -0x1.a63c02244b947p-55, -0x1.b8e9bec0b3aa5p-11, 0x1.861d4fbf8cab5p-13,
     -0x1.027b2365dca43p-14, 0x1.8f7bdd026b138p-16, -0x1.4f1db4200d9e4p-17, 0x1.27e4a90dcb8e9p-18,
     -0x1.0e942b0874687p-19, 0x1.fba4a2bab8d96p-21, -0x1.e6aa46756d805p-22, 0x1.d8a4fc128f2c2p-23},
     /* [30] 1.75 <= y <= 1.875 2^-37, degree 10, 71.5 bits */
    {0x1.fc0707fb8cd8ep-1, -0x1.85645408175f8p-56, -0x1.a1f4339f7dbbfp-11, 0x1.59f3f9f07f9ccp-13,
     -0x1.acde69f0bb613p-15, 0x1.3607b65151e7ap-16, -0x1.e69867090efd1p-18, 0x1.91ecdfd9ff3fap-19,
     -0x1.57d40acc1133dp-20, 0x1.2db9ffcd8062dp-21, -0x1.0e8484e9858a7p-22, 0x1.eb8bbb1b1941dp-24},
     /* [31] 1.875 <= y <= 2 2^-37, degree 10, 68.4 bits */
    {0x1.fbf4288a4b657p-1, -0x1.8cad679fe6948p-55, -0x1.841d26ac791d1p-10, 0x1.24eb972163781p-11,
     -0x1.4b16fd7e2bcf9p-12, 0x1.b47507f82647bp-13, -0x1.384ac23a1e7a9p-13, 0x1.d66268b01a35p-14,
     -0x1.6ee20262bcffep-14, 0x1.258cf41a93d7cp-14, -0x1.e2394041e47a5p-15, 0x1.8f80244d67a49p-15},
     /* [32] 1 <= y <= 1.125 2^-36, degree 10, 66.4 bits */
    {0x1.fbdcf882ccf67p-1, -0x1.8a623bdd08e93p-57, -0x1.62fed1a40632bp-10, 0x1.df784982b4b37p-12,
     -0x1.e4e8d87f9c719p-13, 0x1.1df94cc974c3cp-13, -0x1.6e299bdec6b0ap-14, 0x1.ed791fa360416p-15,
     -0x1.5861325293806p-15, 0x1.ed153e1c0ff8p-16, -0x1.69e076f5a5ed8p-16, 0x1.0c3bb9738399fp-16},
     /* [33] 1.125 <= y <= 1.25 2^-36, degree 10, 67.4 bits */
    {0x1.fbc7aa336d5b2p-1, 0x1.7d17cb4b118dfp-55, -0x1.479daad630ef3p-10, 0x1.905e21bcdd21dp-12, -0x1.6e5a63e87427ap-13,
     0x1.86f6176abc317p-14, -0x1.c4eab5c3da325p-15, 0x1.14216c4d4898ep-15, -0x1.5cb3fefdb7acbp-16,
     0x1.c3b995d1bd734p-17, -0x1.2ba772db42986p-17, 0x1.91e8b37959218p-18},
     /* [34] 1.25 <= y <= 1.375 2^-36, degree 10, 67.0 bits */
    {0x1.fbb3edcb5164cp-1, -0x1.61c14ff1e5259p-57, -0x1.30907f05d34b8p-10, 0x1.53d902bf9e748p-12,
     -0x1.1bf012727bce6p-13, 0x1.14a9edc083b8cp-14, -0x1.24a362544c7f7p-15, 0x1.45ccad383729p-16,
     -0x1.77a6e5f0e8502p-17, 0x1.bc52215a4692p-18, -0x1.0ce9e32b4ffa3p-18, 0x1.494f734575f1p-19},
     /* [35] 1.375 <= y <= 1.5 2^-36, degree 10, 67.5 bits */
    {0x1.fba1865229a75p-1, -0x1.71307bf00e513p-55, -0x1.1cdce4f645a2ap-10, 0x1.24726afe843a6p-12,
     -0x1.c19540681ea9bp-14, 0x1.930603468965ep-15, -0x1.8831499cdd3cdp-16, 0x1.91b4bd9301c59p-17,
     -0x1.aa1f14eb9298cp-18, 0x1.cfb231d04eb24p-19, -0x1.020abbcb208fep-19, 0x1.22b6c7e40e8eep-20},
     /* [36] 1.5 <= y <= 1.625 2^-36, degree 10, 68.0 bits */
    {0x1.fb904415b9ad6p-1, -0x1.d3e0d53735014p-55, -0x1.0bcf851f13862p-10, 0x1.fd2b680cb6b6cp-13,
     -0x1.6a640f3da340ap-14, 0x1.2cccb168a1d8bp-15, -0x1.0f08d96f9e85dp-16, 0x1.010be53f8b1e1p-17,
     -0x1.f8f214792de3bp-19, 0x1.fcc548c962f2ap-20, -0x1.06093eb206c97p-20, 0x1.11580bc7646fdp-21},
     /* [37] 1.625 <= y <= 1.75 2^-36, degree 10, 67.7 bits */
    {0x1.fb800105e5182p-1, 0x1.dead8ba1b0c78p-56, -0x1.f9c8c8da47a1ep-11, 0x1.bfa9e9d83b6e4p-13, -0x1.28a54528f1ce3p-14,
     0x1.ca7f4cb069875p-16, -0x1.80a34e6a4eb9ap-17, 0x1.53a15a178f413p-18, -0x1.36951023878a1p-19,
     0x1.235a9cee8a607p-20, -0x1.1751b44d023a9p-21, 0x1.0f46c1a84f529p-22},
     /* [38] 1.75 <= y <= 1.875 2^-36, degree 10, 68.9 bits */
    {0x1.fb709e3dfa73bp-1, -0x1.910d66fcd8b98p-55, -0x1.df703d221d073p-11, 0x1.8cfb6df1edcdp-13, -0x1.ec2f5d4e9013dp-15,
     0x1.63d334c66e155p-16, -0x1.173f7feee7bc2p-17, 0x1.cd54a2185c3dap-19, -0x1.8aa848d4b02f2p-20,
     0x1.5a56db72bd255p-21, -0x1.36858fdbb314p-22, 0x1.1a1f4f4e023abp-23},
     /* [39] 1.875 <= y <= 2 2^-36, degree 10, 68.0 bits */
    {0x1.fb5af82015a5ep-1, -0x1.f082288ce4e06p-55, -0x1.bd327d265a5ap-10, 0x1.501ed18e37015p-11, -0x1.7bf6bd8fcac46p-12,
     0x1.f4eb309e26d8dp-13, -0x1.666e8989a1efep-13, 0x1.0df33b8228c13p-13, -0x1.a51d3ded96bbbp-14,
     0x1.50f329810eec6p-14, -0x1.14c383e231e06p-14, 0x1.ca94821d7f6c4p-15},
     /* [40] 1 <= y <= 1.125 2^-35, degree 10, 66.5 bits */
    {0x1.fb405f239e68ap-1, -0x1.0e1e3fa5dfb92p-55, -0x1.9731e11bda56ep-10, 0x1.1315adb853f9fp-11,
     -0x1.163d2ec56716dp-12, 0x1.483421505d8a1p-13, -0x1.a440eb41e4bf1p-14, 0x1.1b320d762b929p-14,
     -0x1.8b4723c6652dep-15, 0x1.1afc6e60310f7p-15, -0x1.9f60f9849fcdfp-16, 0x1.33e54a7b4bc6ap-16},
     /* [41] 1.125 <= y <= 1.25 2^-35, degree 10, 66.6 bits */
    {0x1.fb27eee760921p-1, 0x1.6df0dcd02ecaap-55, -0x1.77c74a647d922p-10, 0x1.cb64ac66c6701p-12, -0x1.a46a5a1af91aap-13,
     0x1.c0afbeeb96dcap-14, -0x1.03e847e3e55b3p-14, 0x1.3ced7d8ec8b09p-15, -0x1.903be5759efp-16, 0x1.033f07b454c27p-16,
     -0x1.57f398b9ac331p-17, 0x1.cd54a00badae9p-18}, /* [42] 1.25 <= y <= 1.375 2^-35, degree 10, 67.4 bits */
    {0x1.fb114bd2fcd07p-1, 0x1.403ef87790f01p-55, -0x1.5d542fe22359cp-10, 0x1.85f1675da97a6p-12, -0x1.45d51299ad6e6p-13,
     0x1.3d81f9b6c3a08p-14, -0x1.4fdb5c0adb871p-15, 0x1.75ede9e8f711cp-16, -0x1.af28b000155e8p-17,
     0x1.fdfc95c75b8c4p-18, -0x1.34a996e56aac4p-18, 0x1.79fe4295a35ecp-19},
     /* [43] 1.375 <= y <= 1.5 2^-35, degree 10, 67.7 bits */
    {0x1.fafc2feefa551p-1, 0x1.51e9860ee8373p-57, -0x1.46b92fc04a3d7p-10, 0x1.4f8c7c850e85dp-12, -0x1.01f46beab18b9p-13,
     0x1.ce83c3be24583p-15, -0x1.c21b79eabf2e1p-16, 0x1.cd0af87048d51p-17, -0x1.e91443d1119abp-18,
     0x1.0a1bf0e34149cp-18, -0x1.282e110c86463p-19, 0x1.4dafd23a94c6cp-20},
     /* [44] 1.5 <= y <= 1.625 2^-35, degree 10, 67.8 bits */
    {0x1.fae8647f9dd18p-1, 0x1.f0136f839c019p-57, -0x1.332878e11bee5p-10, 0x1.2419e69372c63p-12, -0x1.9fd8f303966acp-14,
     0x1.59323cbb63ba1p-15, -0x1.370dc1bb4f381p-16, 0x1.2702ebf45d496p-17, -0x1.21c55cac961b6p-18,
     0x1.23f92472910c4p-19, -0x1.2cc2c4236ee7cp-20, 0x1.39bed2c0ed5d2p-21},
     /* [45] 1.625 <= y <= 1.75 2^-35, degree 10, 67.4 bits */
    {0x1.fad5bdd75513dp-1, 0x1.656d5950c390dp-56, -0x1.220a950c579a7p-10, 0x1.00cfe760aee56p-12, -0x1.546623dd2187p-14,
     0x1.0714c06bd94eap-15, -0x1.b96cdbcc61b39p-17, 0x1.85c9a72a139fp-18, -0x1.6475ef2e599a5p-19, 0x1.4e66801d64707p-20,
     -0x1.409825f46fdc6p-21, 0x1.375e68d1312edp-22}, /* [46] 1.75 <= y <= 1.875 2^-35, degree 10, 67.8 bits */
    {0x1.fac41882dfdd6p-1, -0x1.8803d8897aeb2p-55, -0x1.12ed74a813537p-10, 0x1.c777c4fbd2e0dp-13,
     -0x1.1a62bb2b4dd97p-14, 0x1.98550c31bde38p-16, -0x1.4078c8330324fp-17, 0x1.08ba34ff26542p-18,
     -0x1.c4f32e78efc77p-20, 0x1.8d815310b0becp-21, -0x1.6467632840e9bp-22, 0x1.43d06f89d25cbp-23},
     /* [47] 1.875 <= y <= 2 2^-35, degree 10, 66.9 bits */
    {0x1.faab447fd9af5p-1, -0x1.47fa5f7f30a4ep-55, -0x1.fe91d9c400f99p-10, 0x1.81a18984c3d0dp-11,
     -0x1.b3fdcc4d7ae6bp-12, 0x1.1f69bb90cd1bep-12, -0x1.9b567afbd3af9p-13, 0x1.35cee4479f206p-13,
     -0x1.e34e89eead4c1p-14, 0x1.82b8f9586c965p-14, -0x1.3da72e62b1908p-14, 0x1.072ba9020db2cp-14},
     /* [48] 1 <= y <= 1.125 2^-34, degree 10, 66.1 bits */
    {0x1.fa8cc3d3bc365p-1, -0x1.c45b6932bafd3p-58, -0x1.d2f85d3608601p-10, 0x1.3b989a1b104a6p-11,
     -0x1.3f424b8987338p-12, 0x1.789e94bc83b52p-13, -0x1.e246428164ac3p-14, 0x1.4500a8953523p-14, -0x1.c5a553e0f622p-15,
     0x1.44c7feb9020b4p-15, -0x1.dcbd008693b4dp-16, 0x1.6162780443d69p-16},
     /* [49] 1.125 <= y <= 1.25 2^-34, degree 10, 67.3 bits */
    {0x1.fa70bd4f2e5cp-1, -0x1.3b196faae9f47p-57, -0x1.aeed7750de724p-10, 0x1.078465eada7ccp-11, -0x1.e262a270f587fp-13,
     0x1.016eb81695f78p-13, -0x1.2a422d801bdedp-14, 0x1.6bb52844ff21dp-15, -0x1.cb534ac8ddb68p-16,
     0x1.2987a7f4ced5bp-16, -0x1.8ac0c6d3e5e08p-17, 0x1.08bd5a78d7fabp-17},
     /* [50] 1.25 <= y <= 1.375 2^-34, degree 10, 68.3 bits */
    {0x1.fa56c7d925e05p-1, -0x1.4b7d99ce92eb4p-56, -0x1.9095793f26ab4p-10, 0x1.bf590a712bcedp-12,
     -0x1.75da4d1ae0057p-13, 0x1.6c54c55b0603bp-14, -0x1.81686c031de1ep-15, 0x1.ad1d91ae78f89p-16,
     -0x1.eececc81752ddp-17, 0x1.24a4ea334e633p-17, -0x1.623f007f59af7p-18, 0x1.b1d30c81fb2d3p-19},
     /* [51] 1.375 <= y <= 1.5 2^-34, degree 10, 67.4 bits */
    {0x1.fa3e932a2c056p-1, 0x1.2c2b0591d46a2p-55, -0x1.76a69ebf86252p-10, 0x1.80f00cfee0f39p-12, -0x1.27f741966fea2p-13,
     0x1.095b44ff56c56p-14, -0x1.0240b90ea18edp-15, 0x1.0889dab57ed68p-16, -0x1.18a2808a732e4p-17, 0x1.31658abc93bbp-18,
     -0x1.53ea439ebb53ep-19, 0x1.7ef7db2d92d8bp-20}, /* [52] 1.5 <= y <= 1.625 2^-34, degree 10, 68.4 bits */
    {0x1.fa27e075a42b2p-1, -0x1.c42c2f6570189p-56, -0x1.6034bd00b5bc8p-10, 0x1.4f169a45ad59bp-12,
     -0x1.dd1dc336b007ep-14, 0x1.8c16d3cb8d125p-15, -0x1.64ef03a445c3fp-16, 0x1.528a31b888ee1p-17,
     -0x1.4c899fee28e49p-18, 0x1.4f130c5029405p-19, -0x1.592ae5203dc4bp-20, 0x1.6813a7bbee46dp-21},
     /* [53] 1.625 <= y <= 1.75 2^-34, degree 10, 66.9 bits */
    {0x1.fa127d9e6bedcp-1, -0x1.ceffd7094abb4p-57, -0x1.4c9208ce38162p-10, 0x1.2699ab81cbe05p-12,
     -0x1.868b810de5a7dp-14, 0x1.2ddce14029248p-15, -0x1.fa86f0e0913eap-17, 0x1.bf4b332d7312cp-18,
     -0x1.991071c4c5fa8p-19, 0x1.7fc2703220a2dp-20, -0x1.6fecb401882b6p-21, 0x1.655838194fb91p-22},
     /* [54] 1.75 <= y <= 1.875 2^-34, degree 10, 68.1 bits */
    {0x1.f9fe41f83dd5ep-1, 0x1.64406728945c7p-56, -0x1.3b3ba1d517262p-10, 0x1.053d19d5920a6p-12, -0x1.43faeae8f2f54p-14,
     0x1.d484da042112cp-16, -0x1.6fbae8fcc7de4p-17, 0x1.2fc766ca6cc2cp-18, -0x1.03e493285852ep-19,
     0x1.c82c4d5f3f5c2p-21, -0x1.9904066d84058p-22, 0x1.739f86f23d693p-23},
     /* [55] 1.875 <= y <= 2 2^-34, degree 10, 69.2 bits */
    {0x1.f9e1ca444f2c9p-1, -0x1.6374cc156583p-56, -0x1.24b35d75c2f0fp-9, 0x1.ba5aca6755a0bp-11, -0x1.f4333bddc9749p-12,
     0x1.49c50cea6a9ddp-12, -0x1.d7fc795b85784p-13, 0x1.6380c73830b1ep-13, -0x1.154e4c23a5623p-13,
     0x1.bbca827361f0bp-14, -0x1.6c89cbab6b0ecp-14, 0x1.2e0550bc75419p-14},
     /* [56] 1 <= y <= 1.125 2^-33, degree 10, 66.6 bits */
    {0x1.f9bed14dd19a1p-1, -0x1.b0a7cf931575bp-55, -0x1.0bb1d4ec111fep-9, 0x1.6a01b9de4130ap-11, -0x1.6e4426a320193p-12,
     0x1.b01c8c6f58218p-13, -0x1.14af245ce2cfdp-13, 0x1.74ee0390fc72bp-14, -0x1.04480ad3d6889p-14,
     0x1.74b36a7545e84p-15, -0x1.118bd6e776d5bp-15, 0x1.958b4723fe0ecp-16},
     /* [57] 1.125 <= y <= 1.25 2^-33, degree 10, 67.2 bits */
    {0x1.f99eafc0e054p-1, 0x1.6e2c68976c586p-55, -0x1.ee0c08e5fac98p-10, 0x1.2e42b24e486aep-11, -0x1.14b2cbadd098ap-12,
     0x1.275b30b1e5028p-13, -0x1.5637d942aaf45p-14, 0x1.a1556096f2466p-15, -0x1.0788d9e54f56ep-15,
     0x1.556bfc15543fap-16, -0x1.c4ffd6b7665f9p-17, 0x1.2fcf29e3e0e79p-17},
     /* [58] 1.25 <= y <= 1.375 2^-33, degree 10, 68.4 bits */
    {0x1.f980ed0b5215fp-1, -0x1.58f9f603af262p-58, -0x1.cb3e13fb60308p-10, 0x1.008d701557704p-11,
     -0x1.ace08a23bfddfp-13, 0x1.a1fe5092299e8p-14, -0x1.ba33fb43030e6p-15, 0x1.ec6018398c7ffp-16,
     -0x1.1be30a2626d29p-16, 0x1.4fcf1df4efcd9p-17, -0x1.968214b290b0ep-18, 0x1.f1d68fbc76f51p-19},
     /* [59] 1.375 <= y <= 1.5 2^-33, degree 10, 68.5 bits */
    {0x1.f9652d149156bp-1, 0x1.c92f5d6759801p-55, -0x1.ad7f735637503p-10, 0x1.b9828f0d1f5c5p-12, -0x1.5384e6b6fdaf2p-13,
     0x1.306f407a32e51p-14, -0x1.284ddca9ca37fp-15, 0x1.2f87e727f9ffbp-16, -0x1.4203235f3b24dp-17,
     0x1.5e6fb3bd8677dp-18, -0x1.860e629932559p-19, 0x1.b7786b1b60e43p-20},
     /* [60] 1.5 <= y <= 1.625 2^-33, degree 10, 69.8 bits */
    {0x1.f94b27d1ffcd2p-1, 0x1.fee5fd429111p-55, -0x1.93c133c65b8e2p-10, 0x1.805354260d44ep-12, -0x1.11a8672b71081p-13,
     0x1.c669346bc59fep-15, -0x1.99846a66dd4e9p-16, 0x1.846eda0df1415p-17, -0x1.7d8fb14ee78p-18, 0x1.807c10a6d0468p-19,
     -0x1.8c13bcb62329dp-20, 0x1.9d31f5aa4df71p-21}, /* [61] 1.625 <= y <= 1.75 2^-33, degree 10, 67.6 bits */
    {0x1.f932a3c6b9fc5p-1, 0x1.85d4fc51ab878p-55, -0x1.7d3bf2757ec57p-10, 0x1.51e17d4ec8349p-12, -0x1.bfff8259ada0bp-14,
     0x1.5a4dd4890c02dp-15, -0x1.2291c6125f6c4p-16, 0x1.009a69e3765a7p-17, -0x1.d55cbb93cd64ap-19,
     0x1.b85790dccb18ap-20, -0x1.a62f2c6f206fep-21, 0x1.9a0dcaf0eebefp-22},
     /* [62] 1.75 <= y <= 1.875 2^-33, degree 10, 71.3 bits */
    {0x1.f91b724a99204p-1, 0x1.3ca1f10db5662p-56, -0x1.69598a0db25c9p-10, 0x1.2b9c9ab7e2897p-12, -0x1.73a250c4c1f92p-14,
     0x1.0cbe47ac1e9cp-15, -0x1.a5e3dd8524227p-17, 0x1.5c89b4c38e825p-18, -0x1.2a32a34cc3c1fp-19, 0x1.05b65e6d8f12p-20,
     -0x1.d5541d2290383p-22, 0x1.aa6ebe333fe23p-23}, /* [63] 1.875 <= y <= 2 2^-33, degree 10, 67.0 bits */
    {0x1.f8fad099ab7bcp-1, -0x1.a7e1195f3272bp-55, -0x1.4f8212c0ccc1dp-9, 0x1.fb5117d1a64b2p-11, -0x1.1ee12986b9007p-11,
     0x1.7a4dc65e942cp-12, -0x1.0ebe915efcaa9p-12, 0x1.97dfc7614564ap-13, -0x1.3e2ba439d6d8ep-13, 0x1.fd34f242d8a5cp-14,
     -0x1.a248c265e6ad3p-14, 0x1.5a8edbca614b7p-14}, /* [64] 1 <= y <= 1.125 2^-32, degree 10, 65.8 bits */
    {0x1.f8d2ba8300c54p-1, 0x1.0cd2ac1ff3541p-55, -0x1.32d49213ca882p-9, 0x1.9f278693c7516p-11, -0x1.a41d91f2f0873p-12,
     0x1.efb16c8e0f304p-13, -0x1.3d6b209e26ccbp-13, 0x1.abdb42ff8ff8dp-14, -0x1.2aa124fd490d1p-14,
     0x1.aba07dda5a1fbp-15, -0x1.39de74070f688p-15, 0x1.d1560832f3e15p-16},
     /* [65] 1.125 <= y <= 1.25 2^-32, degree 10, 66.3 bits */
    {0x1.f8ade6a182f6cp-1, 0x1.e416ef527276dp-59, -0x1.1b1ff14e58428p-9, 0x1.5aa009245353cp-11, -0x1.3d5eb249909cp-12,
     0x1.52ce5ce3c753ep-13, -0x1.88972605a9923p-14, 0x1.dec9d0a5f2ff2p-15, -0x1.2e5acbd4d6176p-15,
     0x1.87baa5016d547p-16, -0x1.03e1a89339d17p-16, 0x1.5c9814a16bd09p-17},
     /* [66] 1.25 <= y <= 1.375 2^-32, degree 10, 69.7 bits */
    {0x1.f88bcaa977e82p-1, 0x1.737dfc4ad5894p-55, -0x1.072b284132777p-9, 0x1.263301053151fp-11, -0x1.ebe7589643936p-13,
     0x1.df78eaf50dbe2p-14, -0x1.fb47bebd5b8cfp-15, 0x1.1a6f0c3860543p-15, -0x1.45b29ee2ca5b8p-16,
     0x1.8147ee5f60d97p-17, -0x1.d268f2f0cdf72p-18, 0x1.1d9b4a4b9b99bp-18},
     /* [67] 1.375 <= y <= 1.5 2^-32, degree 10, 68.2 bits */
    {0x1.f86bfcf91fb4p-1, 0x1.42e947176bf06p-55, -0x1.ec3a6ec948dbep-10, 0x1.fa4878f9d77f3p-12, -0x1.85676e76b8e04p-13,
     0x1.5d33f06a54b0ap-14, -0x1.53e7036bd160fp-15, 0x1.5c364c328e719p-16, -0x1.716e39d012043p-17,
     0x1.920e1a60c30e3p-18, -0x1.bf8661657803bp-19, 0x1.f83bad19eedfbp-20},
     /* [68] 1.5 <= y <= 1.625 2^-32, degree 10, 67.7 bits */
    {0x1.f84e2aefd2348p-1, -0x1.834a99c36b3fap-55, -0x1.ceb571086f8a3p-10, 0x1.b8b2863069845p-12,
     -0x1.39dbbc82a62dbp-13, 0x1.049c7565befacp-14, -0x1.d5c38a0a42afap-16, 0x1.bd9a70b9b8c05p-17,
     -0x1.b5bd74f7452b7p-18, 0x1.b91c3de97e365p-19, -0x1.c66caf41d0493p-20, 0x1.da13c93f131c9p-21},
     /* [69] 1.625 <= y <= 1.75 2^-32, degree 10, 66.9 bits */
    {0x1.f832129e87057p-1, 0x1.149110655fc5p-56, -0x1.b4e2a2ea11718p-10, 0x1.836e35871ecb9p-12, -0x1.00e61cdc7ea8p-13,
     0x1.8d3659556ad24p-15, -0x1.4d4f6dcd5270ap-16, 0x1.265d6aab887f2p-17, -0x1.0d3aad509c535p-18,
     0x1.f92f6d8ff7de9p-20, -0x1.e45e8779a2736p-21, 0x1.d677165a0831ep-22},
     /* [70] 1.75 <= y <= 1.875 2^-32, degree 10, 68.0 bits */
    {0x1.f8177e82a037bp-1, -0x1.45c1dda67fedcp-55, -0x1.9e15cc1b6d621p-10, 0x1.578a86392b8ccp-12,
     -0x1.aa356cd038becp-14, 0x1.343e61e7ffa0dp-15, -0x1.e3f032f268571p-17, 0x1.8fd253694e8b8p-18,
     -0x1.561726e68619p-19, 0x1.2c3f048bc0be8p-20, -0x1.0d397100165a4p-21, 0x1.e93fc1849427bp-23},
     /* [71] 1.875 <= y <= 2 2^-32, degree 10, 68.4 bits */
    {0x1.f7f219e4fba14p-1, -0x1.63f8c385b8362p-55, -0x1.80747d95deee2p-9, 0x1.22d71ab60ba87p-10, -0x1.48ff83497374ap-11,
     0x1.b1e543371ac8p-12, -0x1.368e1c01d43d6p-12, 0x1.d3e06e601a6ebp-13, -0x1.6cfe79609bc92p-13, 0x1.24156510499b1p-13,
     -0x1.dfe03c285fed9p-14, 0x1.8d997c2b4f5ccp-14}, /* [72] 1 <= y <= 1.125 2^-31, degree 10, 66.2 bits */
    {0x1.f7c42b005e7bp-1, -0x1.a4b81ccb3f1cbp-57, -0x1.5f9305f0cacp-9, 0x1.dbfd33fe1b419p-11, -0x1.e1c70cf782667p-12,
     0x1.1c4203a6e870ap-12, -0x1.6c14962ff569bp-13, 0x1.eac88e01f4f8dp-14, -0x1.569127d12ed9dp-14,
     0x1.ea9047b4c68d9p-15, -0x1.681350026251p-15, 0x1.0aeda27e764c8p-15},
     /* [73] 1.125 <= y <= 1.25 2^-31, degree 10, 65.9 bits */
    {0x1.f799f88eebf7dp-1, 0x1.5a3410335b593p-56, -0x1.4465421e3f7aep-9, 0x1.8d671d113d051p-11, -0x1.6bf07341528afp-12,
     0x1.8491749c6eabdp-13, -0x1.c24a22a9175f6p-14, 0x1.12985ec895f94p-14, -0x1.5ad4ac32ee04bp-15,
     0x1.c15ed383c388ep-16, -0x1.2a21e29a58ec3p-16, 0x1.8fea0467ec6a9p-17},
     /* [74] 1.25 <= y <= 1.375 2^-31, degree 10, 66.7 bits */
    {0x1.f772e3f927f3ep-1, -0x1.242517a0b7166p-55, -0x1.2d842e39e9588p-9, 0x1.5148fa21991ap-11, -0x1.1a08670484c2ep-12,
     0x1.12f07ab7c4343p-13, -0x1.22e8e1c7deae9p-14, 0x1.43f4730fa339cp-15, -0x1.7599181d8e23ep-16,
     0x1.b9f669fdba587p-17, -0x1.0b85e2b9f12bdp-17, 0x1.47a559d7f348fp-18},
     /* [75] 1.375 <= y <= 1.5 2^-31, degree 10, 66.7 bits */
    {0x1.f74e741dc48a8p-1, -0x1.2427bc5999f11p-55, -0x1.19f6ec611ccb3p-9, 0x1.2234752da2905p-11, -0x1.be842cae0a165p-13,
     0x1.90782fc47d7e6p-14, -0x1.85d6538d9b87fp-15, 0x1.8f64bf7a38a42p-16, -0x1.a7c0a7003e32p-17, 0x1.cd319b181ccf4p-18,
     -0x1.00af659653eaep-18, 0x1.213850abac4dep-19}, /* [76] 1.5 <= y <= 1.625 2^-31, degree 10, 66.8 bits */
    {0x1.f72c4a3d54e06p-1, -0x1.7ba4711bfbcc6p-55, -0x1.090b453756c4p-9, 0x1.f934b62e2c2d2p-12, -0x1.67e17bcf329d5p-13,
     0x1.2add2d6a9f82p-14, -0x1.0d61ba5aa533fp-15, 0x1.ff167b1ebf45fp-17, -0x1.f61861313c38bp-18, 0x1.f9fb92f1b1f41p-19,
     -0x1.04a3141c24664p-19, 0x1.0feadf5bfbe98p-20}, /* [77] 1.625 <= y <= 1.75 2^-31, degree 10, 67.4 bits */
    {0x1.f70c1abd791b2p-1, -0x1.2890dfdd4d6abp-55, -0x1.f47c2a5db8f94p-10, 0x1.bc210a2aca27cp-12,
     -0x1.268fbee896865p-13, 0x1.c78131686bb43p-15, -0x1.7e423ca5aa109p-16, 0x1.519dd607a316bp-17,
     -0x1.34cdcf2aec926p-18, 0x1.21bc0aca7913ap-19, -0x1.15ce70212c09cp-20, 0x1.0dd7257d71dafp-21},
     /* [78] 1.75 <= y <= 1.875 2^-31, degree 10, 67.0 bits */
    {0x1.f6eda8431179bp-1, -0x1.305ca05662367p-55, -0x1.da59396ccb862p-10, 0x1.89ce4d6f90152p-12,
     -0x1.e8ae584b78814p-14, 0x1.6178b7a19ba79p-15, -0x1.157f6878dd244p-16, 0x1.ca8f09752c245p-18,
     -0x1.885e102d76ed1p-19, 0x1.586376183b3a4p-20, -0x1.34d1465589513p-21, 0x1.189be3388c9ffp-22},
     /* [79] 1.875 <= y <= 2 2^-31, degree 10, 67.1 bits */
    {0x1.f6c2d2c961093p-1, 0x1.023362f6d77ffp-55, -0x1.b8623faf4951ep-9, 0x1.4d619c150453fp-10, -0x1.79356a6e75ad1p-11,
     0x1.f18b4d61280ecp-12, -0x1.6424b7e2c60ddp-12, 0x1.0c4c4e5c75645p-12, -0x1.a2a01d9463c24p-13, 0x1.4f0449f34912p-13,
     -0x1.1337859070bc7p-13, 0x1.c81332b13fc0dp-14}, /* [80] 1 <= y <= 1.125 2^-30, degree 10, 65.3 bits */
    {0x1.f68e35afa77b9p-1, 0x1.6d3f1d8f824b3p-55, -0x1.92b1c9acd2e7ep-9, 0x1.10cafd397a9ap-10, -0x1.142d2559e0d08p-11,
     0x1.45f173718eef5p-12, -0x1.a182b1b968aedp-13, 0x1.196c7296b0cp-13, -0x1.88e3b81a9c093p-14, 0x1.195382dace297p-14,
     -0x1.9d014fae71fc4p-15, 0x1.322d0b6f3b04p-15}, /* [81] 1.125 <= y <= 1.25 2^-30, degree 10, 68.0 bits */
    {0x1.f65de0e285c0ep-1, 0x1.9ee4a8936260bp-55, -0x1.738add132f92dp-9, 0x1.c77d3d7eeddaep-11, -0x1.a13c7858a40eap-12,
     0x1.bd88bc742768ep-13, -0x1.022d41ab7e90dp-13, 0x1.3ae7a5bcc763fp-14, -0x1.8dc45bafa30cep-15,
     0x1.01b1ed1ea4188p-15, -0x1.55f247bd9e19ep-16, 0x1.cab3b0b7c9c7cp-17},
     /* [82] 1.25 <= y <= 1.375 2^-30, degree 10, 69.3 bits */
    {0x1.f6311e8fe4378p-1, 0x1.2cebcb1514505p-55, -0x1.5951d19837864p-9, 0x1.82919bb04cdf3p-11, -0x1.4352ca437e15ep-12,
     0x1.3b3c7bce51009p-13, -0x1.4d946cd5e09bdp-14, 0x1.737fc6d69413ap-15, -0x1.ac73ed520c074p-16,
     0x1.fae12311305cbp-17, -0x1.32d4822a13957p-17, 0x1.77cccc243f737p-18},
     /* [83] 1.375 <= y <= 1.5 2^-30, degree 10, 67.1 bits */
    {0x1.f60763d9de019p-1, -0x1.7b7f1e97ad801p-56, -0x1.42e94e2eff8f1p-9, 0x1.4c98c8939e5a2p-11, -0x1.ffdee4ed61424p-13,
     0x1.cb268c4235d24p-14, -0x1.bf012e6e1fe8dp-15, 0x1.c9ff119400b02p-16, -0x1.e5f54c71b8f0ap-17,
     0x1.0875ef98983d9p-17, -0x1.266469f23ed84p-18, 0x1.4bb7dd8ed8009p-19},
     /* [84] 1.5 <= y <= 1.625 2^-30, degree 10, 66.7 bits */
    {0x1.f5e044225b91bp-1, -0x1.479a8d6b088c9p-55, -0x1.2f84fd4f5d242p-9, 0x1.217ded017e463p-11, -0x1.9c8ab325d604cp-13,
     0x1.56a59070f0a78p-14, -0x1.34e062224a1ecp-15, 0x1.25082ebecd7ebp-16, -0x1.1fe4af9b468e6p-17,
     0x1.2222fa3266dbdp-18, -0x1.2aeadad72b372p-19, 0x1.37dda9bfe87dbp-20},
     /* [85] 1.625 <= y <= 1.75 2^-30, degree 10, 70.3 bits */
    {0x1.f5bb68be7ee0cp-1, 0x1.f94a97f17d41dp-59, -0x1.1e8e84a24e65dp-9, 0x1.fcf87c7f3f65dp-12, -0x1.51a786eadf5ccp-13,
     0x1.051c38ec1bbep-14, -0x1.b64a8ea68a1cp-16, 0x1.8322890fffa5dp-17, -0x1.621e2b184b136p-18, 0x1.4c444e31b6ed6p-19,
     -0x1.3e99e805264a1p-20, 0x1.357a0c81a73c2p-21}, /* [86] 1.75 <= y <= 1.875 2^-30, degree 10, 66.8 bits */
    {0x1.f5988b58fd2p-1, 0x1.aa4daa5fe6568p-56, -0x1.0f94ad8b55cbdp-9, 0x1.c349453aabc9p-12, -0x1.18141778fd499p-13,
     0x1.953b836d73308p-15, -0x1.3e2a8b1b4e36bp-16, 0x1.06e6d272850ebp-17, -0x1.c1eee41ea3e23p-19,
     0x1.8aef62ea06c2ap-20, -0x1.622891c95eb2p-21, 0x1.41d1fb0d75884p-22},
     /* [87] 1.875 <= y <= 2 2^-30, degree 10, 70.1 bits */
    {0x1.f5677f7e9695ep-1, -0x1.28457659b597p-57, -0x1.f83d781915a88p-9, 0x1.7e066b6fe64c6p-10, -0x1.b05cfec0ef51dp-11,
     0x1.1d30d774041a7p-11, -0x1.9852d93356489p-12, 0x1.33a1c6dd12fc9p-12, -0x1.e00735f59f78ap-13,
     0x1.802d035f49e73p-13, -0x1.3b9d773b06465p-13, 0x1.05852fd18d6a5p-13},
     /* [88] 1 <= y <= 1.125 2^-29, degree 10, 65.2 bits */
    {0x1.f52b41e83bf6dp-1, 0x1.378f80be7b89fp-55, -0x1.cd0d7e23d815ep-9, 0x1.389449134a7a3p-10, -0x1.3c8afbfddaab2p-11,
     0x1.75a476db6c2afp-12, -0x1.dea95624f1858p-13, 0x1.42ab275c95474p-13, -0x1.c27fe49887e6ap-14,
     0x1.42983667ff7c4p-14, -0x1.d99c71368032bp-15, 0x1.5f1e732847e1fp-15},
     /* [89] 1.125 <= y <= 1.25 2^-29, degree 10, 66.3 bits */
    {0x1.f4f3ec83c12f3p-1, 0x1.bf822bae6afb8p-55, -0x1.a95baa7fece14p-9, 0x1.04f29a8f1a66ep-10, -0x1.de32f8debf59dp-12,
     0x1.feb6a7183cf27p-13, -0x1.27faad575f5c1p-13, 0x1.690b0f41178cap-14, -0x1.c813625662321p-15,
     0x1.277c8900ee536p-15, -0x1.881c88efff2b8p-16, 0x1.0702135490999p-16},
     /* [90] 1.25 <= y <= 1.375 2^-29, degree 10, 66.9 bits */
    {0x1.f4c0aeeccb6adp-1, 0x1.03738fd50b319p-55, -0x1.8b5018b9dd561p-9, 0x1.bae80bf83d0b3p-11, -0x1.728c9f141c3d8p-12,
     0x1.695701bf54cccp-13, -0x1.7e68ac78360d1p-14, 0x1.a9ea1f7250057p-15, -0x1.eb3e45d5f8e64p-16,
     0x1.2298fe23b4c62p-16, -0x1.5fd50dce88fdp-17, 0x1.aeef5f7d65aa5p-18},
     /* [91] 1.375 <= y <= 1.5 2^-29, degree 10, 66.9 bits */
    {0x1.f490e9fbf3ffdp-1, -0x1.227d6c91ac652p-56, -0x1.71a3b263f3bbcp-9, 0x1.7d0d60aa920dbp-11, -0x1.254e976de5dc9p-12,
     0x1.072438db21f72p-13, -0x1.0035ae19b01b9p-14, 0x1.06883f35b2453p-15, -0x1.16944e36166cbp-16,
     0x1.2f39a66cc876cp-17, -0x1.518f63449453dp-18, 0x1.7c5ff54e8c6b9p-19},
     /* [92] 1.5 <= y <= 1.625 2^-29, degree 10, 66.7 bits */
    {0x1.f464213635cd9p-1, -0x1.c9b3ca06e69bbp-57, -0x1.5b6c408ab133ap-9, 0x1.4ba76ed98e73bp-11, -0x1.d8c39a0ba37bap-13,
     0x1.88bb6168b9e23p-14, -0x1.6210f9c0eb237p-15, 0x1.4feec8714dc91p-16, -0x1.4a107fa4c500dp-17,
     0x1.4ca7bbb2dec28p-18, -0x1.56bd406220794p-19, 0x1.6599cdb190bd2p-20},
     /* [93] 1.625 <= y <= 1.75 2^-29, degree 10, 68.2 bits */
    {0x1.f439f14961ecbp-1, -0x1.46ff0ab2d9233p-55, -0x1.47fd6dcc353c2p-9, 0x1.2389b4f0342dfp-11, -0x1.82ee7b89f8c4dp-13,
     0x1.2b4487a4b072bp-14, -0x1.f6665f1042034p-16, 0x1.bbccc71db906ep-17, -0x1.95fa7a75d98eap-18,
     0x1.7cf2fe0ebcc12p-19, -0x1.6d4c955b93716p-20, 0x1.62da2a9ed57b7p-21},
     /* [94] 1.75 <= y <= 1.875 2^-29, degree 10, 66.4 bits */
    {0x1.f412099c1b196p-1, 0x1.b800efb43f4f9p-56, -0x1.36d57790ad765p-9, 0x1.027caba921be9p-11, -0x1.40f1567b8dbacp-13,
     0x1.d06ffa21f37a3p-15, -0x1.6cb1a1a129659p-16, 0x1.2d5fdab5c5711p-17, -0x1.01e7fc7139cfap-18,
     0x1.c4c9b071ce704p-20, -0x1.960edc13cb1f8p-21, 0x1.70ff1d77ef08ap-22},
     /* [95] 1.875 <= y <= 2 2^-29, degree 10, 66.0 bits */
    {0x1.f3d9e77860d17p-1, 0x1.711089f40280bp-55, -0x1.208a82bc42bebp-8, 0x1.b59bf455fe6fep-10, -0x1.ef6c83144667dp-11,
     0x1.46d80039182d4p-11, -0x1.d4045baaafa67p-12, 0x1.60a31519dcd0ap-12, -0x1.1325948ad038cp-12,
     0x1.b86fcc4d59da2p-13, -0x1.69da99986fb18p-13, 0x1.2bd8d12e851a3p-13},
     /* [96] 1 <= y <= 1.125 2^-28, degree 10, 64.7 bits */
    {0x1.f394f6d273e2p-1, -0x1.ee195d218846bp-55, -0x1.07ce66d8ea1f7p-8, 0x1.6609681b3228p-10, -0x1.6ab0db8205fecp-11,
     0x1.ac312158cd273p-12, -0x1.124e2e82355dcp-12, 0x1.71db2925e7e5p-13, -0x1.0235aabbb649bp-13, 0x1.71d224f8188c6p-14,
     -0x1.0f7c9e2b44d77p-14, 0x1.928f48be12dc5p-15}, /* [97] 1.125 <= y <= 1.25 2^-28, degree 10, 65.4 bits */
    {0x1.f355a50e920dap-1, -0x1.179512c18154dp-56, -0x1.e6ba62413427ep-9, 0x1.2ae120dbaf3dbp-10, -0x1.11f178c155053p-11,
     0x1.249f9427f7284p-12, -0x1.533789e7b7a6dp-13, 0x1.9dd328e263147p-14, -0x1.0565107a0c5c1p-14,
     0x1.52bb065a12367p-15, -0x1.c1852bdc71cdfp-16, 0x1.2d874de98d584p-16},
     /* [98] 1.25 <= y <= 1.375 2^-28, degree 10, 65.7 bits */
    {0x1.f31b036833eep-1, 0x1.838c89307f296p-55, -0x1.c450fca71499fp-9, 0x1.fb42d2531fcb8p-11, -0x1.a88767f105de1p-12,
     0x1.9e0e2e1fe3039p-13, -0x1.b6411b72c4999p-14, 0x1.e8290cd8f861p-15, -0x1.198a309186cf6p-15, 0x1.4d1d20373b5e9p-16,
     -0x1.935437feff1b3p-17, 0x1.ee08562a2096dp-18}, /* [99] 1.375 <= y <= 1.5 2^-28, degree 10, 67.9 bits */
    {0x1.f2e45b876c5f4p-1, -0x1.7ecdea066bf2p-55, -0x1.a6e9cc0c5a2b7p-9, 0x1.b465d501f3311p-11, -0x1.500501e2810b8p-12,
     0x1.2d84c2087516ep-13, -0x1.259d35bad2a98p-14, 0x1.2ce39c0bcf178p-15, -0x1.3f4e375cd3a7dp-16,
     0x1.5b93a19f17feep-17, -0x1.82f465e3622b7p-18, 0x1.b40e06fc0d302p-19},
     /* [100] 1.5 <= y <= 1.625 2^-28, degree 10, 70.7 bits */
    {0x1.f2b11ecfb4da3p-1, -0x1.0140af943033p-57, -0x1.8d786f521e447p-9, 0x1.7bcea017c909cp-11, -0x1.0ecb332569f99p-12,
     0x1.c1fdd1ec6bcf5p-14, -0x1.95bdfe5abe74ep-15, 0x1.810010c008194p-16, -0x1.7a4dfc946c2b2p-17,
     0x1.7d4c7ec8cfb21p-18, -0x1.88e10ed22da41p-19, 0x1.99ef2a49853ecp-20},
     /* [101] 1.625 <= y <= 1.75 2^-28, degree 10, 66.3 bits */
    {0x1.f280db78bdd5ap-1, -0x1.5c7ead0a78e33p-55, -0x1.77376fbf4cbcp-9, 0x1.4dda1716dcf86p-11, -0x1.bb3e1565ced04p-13,
     0x1.56e34d6ef3fefp-14, -0x1.1fda4402acc17p-15, 0x1.fc9b2b6db29c5p-17, -0x1.d14c877aeeaa3p-18,
     0x1.b4a429629adddp-19, -0x1.a2ba0b3a8b3a2p-20, 0x1.96c57d0ac2db3p-21},
     /* [102] 1.75 <= y <= 1.875 2^-28, degree 10, 67.5 bits */
    {0x1.f253352dd774ep-1, 0x1.4a05b1a891bf8p-56, -0x1.6392202034765p-9, 0x1.27fde0772b5b1p-11, -0x1.6fa2f964d566fp-13,
     0x1.0a0e9555ebb1fp-14, -0x1.a1e493e38e041p-16, 0x1.595f41fff9cd5p-17, -0x1.2794f654cb892p-18,
     0x1.037bc8907772cp-19, -0x1.d16f030184f7ep-21, 0x1.a6f935f4a9d4ep-22},
     /* [103] 1.875 <= y <= 2 2^-28, degree 10, 70.3 bits */
    {0x1.f212ff7048299p-1, 0x1.95486e7f3c397p-56, -0x1.4a0b50d864f46p-8, 0x1.f512facf45p-10, -0x1.1bbc9d3375db2p-10,
     0x1.7673d3d40fa82p-11, -0x1.0c21bce3b0764p-11, 0x1.9419cfd0b1f8fp-12, -0x1.3b53e39672c56p-12,
     0x1.f8ca392d50a87p-13, -0x1.9ebfd53807e9fp-13, 0x1.57b2014dc7c12p-13},
     /* [104] 1 <= y <= 1.125 2^-27, degree 10, 65.5 bits */
    {0x1.f1c4253220ee8p-1, -0x1.959d7680ef1d1p-55, -0x1.2db9233fb7582p-8, 0x1.99eea6eba2a9bp-10, -0x1.9f691ec946d3dp-11,
     0x1.ea88bbadb61c2p-12, -0x1.3a4981c6e5934p-12, 0x1.a7cf5c5074afcp-13, -0x1.27e6d7bb85d2bp-13,
     0x1.a7d5b8e86425fp-14, -0x1.372837f121a0ap-14, 0x1.cd67f8e5b171cp-15},
     /* [105] 1.125 <= y <= 1.25 2^-27, degree 10, 65.6 bits */
    {0x1.f17bba661182dp-1, -0x1.096bb716adf1fp-57, -0x1.16519897c3714p-8, 0x1.562d886545a26p-10, -0x1.39be999ef5acep-11,
     0x1.4f359637a4ca9p-12, -0x1.84a3d00d1579bp-13, 0x1.da2b5b129add3p-14, -0x1.2b899a28e4ca5p-14,
     0x1.842f86bb29ddfp-15, -0x1.019746d695bdfp-15, 0x1.599742d5ad1e8p-16},
     /* [106] 1.25 <= y <= 1.375 2^-27, degree 10, 68.4 bits */
    {0x1.f138ad946ee9bp-1, -0x1.961a9bbd2c977p-59, -0x1.029ef175aac7p-8, 0x1.225b29bc4441ap-10, -0x1.e62eb5dde30ddp-12,
     0x1.da4a263a6f703p-13, -0x1.f6152d9878574p-14, 0x1.17a8d2d104fc9p-14, -0x1.429b992a7b053p-15,
     0x1.7dbb7dbf46b53p-16, -0x1.ce395bc1537a5p-17, 0x1.1b19e3e4580eap-17},
     /* [107] 1.375 <= y <= 1.5 2^-27, degree 10, 66.1 bits */
    {0x1.f0fa2de86c313p-1, -0x1.d09d79ce13c6cp-58, -0x1.e39500f7c6ed1p-9, 0x1.f38f44150ed84p-11, -0x1.80ccb0e3739eap-12,
     0x1.595d8ca09eb27p-13, -0x1.505c9c323307cp-14, 0x1.58bc105af2c82p-15, -0x1.6dde066dc1fa5p-16,
     0x1.8e4a4c09ad80dp-17, -0x1.bb70ff1ec248ep-18, 0x1.f3bc5f351eb3bp-19},
     /* [108] 1.5 <= y <= 1.625 2^-27, degree 10, 67.2 bits */
    {0x1.f0bf98106154bp-1, -0x1.91053db3803ap-56, -0x1.c67520f6a6d5bp-9, 0x1.b2c15523cecb4p-11, -0x1.361717e342cfap-12,
     0x1.01b409033cccep-13, -0x1.d0cb95bcfa79dp-15, 0x1.b915b316a2d7cp-16, -0x1.b173f5ac8901ep-17,
     0x1.b4ea8af3d4218p-18, -0x1.c236d3b7cf24ep-19, 0x1.d5c8a7a813c65p-20},
     /* [109] 1.625 <= y <= 1.75 2^-27, degree 10, 66.4 bits */
    {0x1.f08869c0239e4p-1, 0x1.943c845d71d56p-56, -0x1.acfc162f2cce2p-9, 0x1.7e21df00c5cdcp-11, -0x1.fb8a946bb1a55p-13,
     0x1.88b78edee2021p-14, -0x1.49bc1231467d7p-15, 0x1.23565f511a9bp-16, -0x1.0a8e08b7b045ep-17, 0x1.f45035a88f519p-19,
     -0x1.dfd138b3bf4f3p-20, 0x1.d224bc72a24c7p-21}, /* [110] 1.75 <= y <= 1.875 2^-27, degree 10, 68.5 bits */
    {0x1.f054393d7fc9bp-1, 0x1.38491872420d2p-55, -0x1.967f9745ad53ap-9, 0x1.52c7e3cc0c28bp-11, -0x1.a4f32b96ecb1ep-13,
     0x1.30b579d08c666p-14, -0x1.dead7f51ce214p-16, 0x1.8ba79c5efb511p-17, -0x1.52a5a4c23fef4p-18,
     0x1.294fe398330fdp-19, -0x1.0aa9197440ba3p-20, 0x1.e4b1e44b7cd27p-22},
     /* [111] 1.875 <= y <= 2 2^-27, degree 10, 74.0 bits */
    {0x1.f00ad1fbd0574p-1, 0x1.c6ff5d718b874p-58, -0x1.794857c472e0ep-8, 0x1.1ebc6c28f3416p-9, -0x1.44dd267616198p-10,
     0x1.acd3f821c85ccp-11, -0x1.331defa09bae9p-11, 0x1.cee914c97222bp-12, -0x1.69408fa778364p-12,
     0x1.212d2ce93a81fp-12, -0x1.db38f342ffc44p-13, 0x1.89d4ac3328568p-13},
     /* [112] 1 <= y <= 1.125 2^-26, degree 10, 64.6 bits */
    {0x1.efb0afc735feap-1, -0x1.1553ae1cd709fp-55, -0x1.58def426c4261p-8, 0x1.d51f7b6bad665p-10, -0x1.db96bc8b3586bp-11,
     0x1.18dd32a511be5p-11, -0x1.67f5b9c9b4048p-12, 0x1.e5753d67c26bfp-13, -0x1.52fa0eec01557p-13, 0x1.e59277769389p-14,
     -0x1.64817084d997p-14, 0x1.08576c20ed826p-14}, /* [113] 1.125 <= y <= 1.25 2^-26, degree 10, 66.1 bits */
    {0x1.ef5deae6bd2f5p-1, -0x1.bba517f4135e8p-55, -0x1.3e1689d0342d7p-8, 0x1.878e517ac0f24p-10, -0x1.672bb965e1dbdp-11,
     0x1.7fd60fb049b8ap-12, -0x1.bd1761949dc37p-13, 0x1.0f8e504f961b5p-13, -0x1.571f7e40a5abp-14, 0x1.bcb4dadb79949p-15,
     -0x1.271e06305a27ep-15, 0x1.8bf5f451ba997p-16}, /* [114] 1.25 <= y <= 1.375 2^-26, degree 10, 65.3 bits */
    {0x1.ef114a476cfacp-1, -0x1.2a9b4bf544b0bp-55, -0x1.278c67082c0bcp-8, 0x1.4c3b9a60a37p-10, -0x1.16453d91966afp-11,
     0x1.0f87c3516537ep-12, -0x1.1f7d857500ecp-13, 0x1.404dd7910b5f4p-14, -0x1.71880faad935bp-15, 0x1.b54ac1fafb14ap-16,
     -0x1.08c4a4c86b192p-16, 0x1.44590edcd1922p-17}, /* [115] 1.375 <= y <= 1.5 2^-26, degree 10, 66.8 bits */
    {0x1.eec9ded9ad6cbp-1, 0x1.3bc3245986fbp-55, -0x1.144abb99de11cp-8, 0x1.1dc92a1b4c674p-10, -0x1.b875f3918d6d3p-12,
     0x1.8b6bddf31257dp-13, -0x1.812dc3a4d0c1ap-14, 0x1.8ad150424f025p-15, -0x1.a31031afe7965p-16,
     0x1.c83d21fd6aa3bp-17, -0x1.fbfedc8cb96dfp-18, 0x1.1e4299490d0a9p-18},
     /* [116] 1.5 <= y <= 1.625 2^-26, degree 10, 65.5 bits */
    {0x1.ee86edaa873f6p-1, -0x1.770471b50d893p-56, -0x1.03a189cf023dbp-8, 0x1.f1652b3253957p-11, -0x1.62ece570c23efp-12,
     0x1.2709f20d74e53p-13, -0x1.0a1d0146fbcbfp-14, 0x1.f9246c16b9a0cp-16, -0x1.f074215bdde92p-17,
     0x1.f47686bb5a4e7p-18, -0x1.01ddc4ed108ffp-18, 0x1.0d17854e94ffbp-19},
     /* [117] 1.625 <= y <= 1.75 2^-26, degree 10, 65.3 bits */
    {0x1.ee47e195c675cp-1, 0x1.51abc60d26eadp-55, -0x1.ea1eb01c53bdfp-9, 0x1.b52a49c4f92f3p-11, -0x1.2272a589c0f89p-12,
     0x1.c1977bb977bdep-14, -0x1.798dff63b39adp-15, 0x1.4da20f9821c11p-16, -0x1.3148e3c27c0b5p-17,
     0x1.1e875e626bcbap-18, -0x1.12cf9bb6e552p-19, 0x1.0aff11b9d57fbp-20},
     /* [118] 1.75 <= y <= 1.875 2^-26, degree 10, 67.2 bits */
    {0x1.ee0c41987f738p-1, -0x1.0d7ff2c343e6fp-55, -0x1.d065589f95bb4p-9, 0x1.838ca142c935p-11, -0x1.e1c41271bbba8p-13,
     0x1.5cd27c3c55b5p-14, -0x1.1209964aee843p-15, 0x1.c5138bb20693cp-17, -0x1.83d621b6c083cp-18, 0x1.548701b1ba067p-19,
     -0x1.31717e83b86a5p-20, 0x1.159cabee955bfp-21}, /* [119] 1.875 <= y <= 2 2^-26, degree 10, 67.3 bits */
    {0x1.edb866fb35f74p-1, 0x1.3065b78e2f627p-55, -0x1.aef9c2a58b0dcp-8, 0x1.47fcc80cdb76fp-9, -0x1.73c5cca46249p-10,
     0x1.eae10fcb6ffd8p-11, -0x1.5f9ee0eb74623p-11, 0x1.0907fc1fb7706p-11, -0x1.9db3b65d87708p-12,
     0x1.4b30f9cc35d2cp-12, -0x1.1027a9b6745f3p-12, 0x1.c31d6fd72bcd9p-13},
     /* [120] 1 <= y <= 1.125 2^-25, degree 10, 64.8 bits */
    {0x1.ed51729706ca9p-1, -0x1.a200c2b4fde41p-55, -0x1.89e71a0a1e6a1p-8, 0x1.0c481380a1737p-9, -0x1.101ba3a4c7f69p-10,
     0x1.417ad70007191p-11, -0x1.9c17277d529c7p-12, 0x1.15ebb06321e3fp-12, -0x1.842a774189b6ep-13,
     0x1.160ad47da2d99p-13, -0x1.984ebca0c20ecp-14, 0x1.2ec593e4bb9f5p-14},
     /* [121] 1.125 <= y <= 1.25 2^-25, degree 10, 65.0 bits */
    {0x1.ecf2ea90cc234p-1, 0x1.8e77a11648f63p-56, -0x1.6b455b1448a0bp-8, 0x1.bfce75d3afcb8p-10, -0x1.9af79bec2d216p-11,
     0x1.b74fb218d2c78p-12, -0x1.fd842e20aa848p-13, 0x1.36e821e4232b6p-13, -0x1.88e39944c589fp-14,
     0x1.fd40e657c2f39p-15, -0x1.51faa30fa2d55p-15, 0x1.c57fe4f86a64fp-16},
     /* [122] 1.25 <= y <= 1.375 2^-25, degree 10, 65.1 bits */
    {0x1.ec9b68ab6edabp-1, -0x1.f5d1bade0c5bep-55, -0x1.517e8c3354875p-8, 0x1.7bee40b5ac8d9p-10, -0x1.3e60a0be7ae49p-11,
     0x1.36c0e44705f63p-12, -0x1.491522de39149p-13, 0x1.6eb26447a465dp-14, -0x1.a71a65bc14926p-15,
     0x1.f4bc0cc3a4cc2p-16, -0x1.2f34928d1e43ep-16, 0x1.7375d44b87fbcp-17},
     /* [123] 1.375 <= y <= 1.5 2^-25, degree 10, 65.3 bits */
    {0x1.ec49db5fdaa2p-1, 0x1.957af6a4b0a41p-57, -0x1.3b7958456b6cep-8, 0x1.46ca7dc2893cfp-10, -0x1.f7e91d9616435p-12,
     0x1.c4834a6a97626p-13, -0x1.b8e0ca1e92e6dp-14, 0x1.c3fa3dcdc8fa6p-15, -0x1.dfca1df48b0cdp-16, 0x1.05338827b09cp-16,
     -0x1.22db408f28cd6p-17, 0x1.47d2ddb85c618p-18}, /* [124] 1.5 <= y <= 1.625 2^-25, degree 10, 65.5 bits */
    {0x1.ebfd6ccad016cp-1, 0x1.8f1d8bc911ed5p-57, -0x1.286c56cf6316cp-8, 0x1.1c5c83ce974b3p-10, -0x1.96073b3049b4dp-12,
     0x1.519e0d7985b65p-13, -0x1.3094072b3c219p-14, 0x1.211f396250699p-15, -0x1.1c2ec9e8c078cp-16,
     0x1.1e8183b3f5b9cp-17, -0x1.2745a74b6cd2ep-18, 0x1.3425ec0d2912fp-19},
     /* [125] 1.625 <= y <= 1.75 2^-25, degree 10, 67.9 bits */
    {0x1.ebb5724d555ebp-1, 0x1.35d1d4829396fp-57, -0x1.17c35d8c0d99bp-8, 0x1.f3d29d18d2055p-11, -0x1.4c3f6116fff1dp-12,
     0x1.013925a1f42e7p-13, -0x1.b01af752b5803p-15, 0x1.7de5519412c03p-16, -0x1.5d7d2232b6bbap-17,
     0x1.480cb873d9d23p-18, -0x1.3aa912259bfebp-19, 0x1.31bc213f7f6bbp-20},
     /* [126] 1.75 <= y <= 1.875 2^-25, degree 10, 65.0 bits */
    {0x1.eb71617906522p-1, -0x1.a4752dff63ff9p-55, -0x1.090ee1e27095dp-8, 0x1.bb1164df278a8p-11, -0x1.1388c48c9dd83p-12,
     0x1.8f1ebb1f58113p-14, -0x1.399dbadda376ap-15, 0x1.034bebb851b8ap-16, -0x1.bbf939f9f4191p-18,
     0x1.85db2407d2354p-19, -0x1.5db83b4cee6cap-20, 0x1.3de09b586419p-21},
     /* [127] 1.875 <= y <= 2 2^-25, degree 10, 66.6 bits */
    {0x1.eb11aa59cbc42p-1, -0x1.108f0ec835296p-56, -0x1.ebe8f739c4e7ap-8, 0x1.76f0c92c1bef2p-9, -0x1.a9382552699fap-10,
     0x1.18cf54fd01b9cp-10, -0x1.926070eb59fe7p-11, 0x1.2f55f4c179181p-11, -0x1.d98d7e61700dep-12,
     0x1.7b24ddee36a19p-12, -0x1.3796534cf6148p-12, 0x1.0241f68306f6p-12},
     /* [128] 1 <= y <= 1.125 2^-24, degree 10, 64.6 bits */
    {0x1.ea9c299fa9f14p-1, -0x1.365e20ce8529cp-56, -0x1.c1883e1862e05p-8, 0x1.32a788cb9b5cbp-9, -0x1.37325eb7d0311p-10,
     0x1.6fc6843e9e835p-11, -0x1.d7890c3b0b774p-12, 0x1.3e0ff1653d3e1p-12, -0x1.bc4990d0553dcp-13,
     0x1.3e467ebf19d2ep-13, -0x1.d36e9ac89ccedp-14, 0x1.5aa40f43eeadp-14},
     /* [129] 1.125 <= y <= 1.25 2^-24, degree 10, 65.7 bits */
    {0x1.ea3049b40bbc2p-1, -0x1.f13611e0bc407p-61, -0x1.9e854fa61b2b4p-8, 0x1.ffce795ea8806p-10, -0x1.d5f63ed8ecd87p-11,
     0x1.f688c8539ec61p-12, -0x1.237c1f6d074edp-12, 0x1.63c942f104638p-13, -0x1.c1a9361648332p-14,
     0x1.23737e6831724p-14, -0x1.82e4aab7560c5p-15, 0x1.039628ec313e3p-15},
     /* [130] 1.25 <= y <= 1.375 2^-24, degree 10, 65.9 bits */
    {0x1.e9cc70e7a6c4dp-1, 0x1.aaf5311550dc2p-56, -0x1.810fbf9787538p-8, 0x1.b230af99cfa22p-10, -0x1.6c0d0f8356cbdp-11,
     0x1.6372bc4c53e9dp-12, -0x1.787f36281a857p-13, 0x1.a399bc2159727p-14, -0x1.e43564d32bad3p-15,
     0x1.1e8e9c320a34bp-15, -0x1.5b109e4e5da66p-16, 0x1.a93a19aacea9fp-17},
     /* [131] 1.375 <= y <= 1.5 2^-24, degree 10, 66.9 bits */
    {0x1.e96f6672628ebp-1, 0x1.f059d9f39e1bp-60, -0x1.67e5be89833d4p-8, 0x1.756df137a81ebp-10, -0x1.20140257bfb0fp-11,
     0x1.02c7a2ce0573fp-12, -0x1.f85db64d25a35p-14, 0x1.02935f646c6f4p-14, -0x1.128615863be36p-15,
     0x1.2af0634d207c8p-16, -0x1.4ce8f879d1facp-17, 0x1.7740a917a271fp-18},
     /* [132] 1.5 <= y <= 1.625 2^-24, degree 10, 65.9 bits */
    {0x1.e91835c410c18p-1, 0x1.6e13f7d2687a7p-55, -0x1.5220edfa377c7p-8, 0x1.44eb1da57a551p-10, -0x1.d03515f29af36p-12,
     0x1.821f6e8efcabfp-13, -0x1.5c6aa55707cc9p-14, 0x1.4acae1d51f738p-15, -0x1.452f8f7a25b2p-16, 0x1.47e187def8354p-17,
     -0x1.51f2056f5e1dap-18, 0x1.60b6182c12c0ep-19}, /* [133] 1.625 <= y <= 1.75 2^-24, degree 10, 65.3 bits */
    {0x1.e8c61bc90c8fbp-1, -0x1.e5281798f4c26p-56, -0x1.3f17d88e90cbap-8, 0x1.1d888ca8cdba3p-10, -0x1.7bd44640399c3p-12,
     0x1.2628f48b9e5cfp-13, -0x1.ee44fb697d9e4p-15, 0x1.b4e9a73854dffp-16, -0x1.8fe4753e1742fp-17,
     0x1.776774e6af22ap-18, -0x1.681df3ef897a9p-19, 0x1.5dee6452a0f21p-20},
     /* [134] 1.75 <= y <= 1.875 2^-24, degree 10, 65.8 bits */
    {0x1.e8787a3e434c9p-1, -0x1.e01dab951b8b9p-57, -0x1.2e4aee2180e3ep-8, 0x1.fa2fa5cca56e5p-11, -0x1.3af94b6461a75p-12,
     0x1.c867e544dc049p-14, -0x1.66b6bdf318922p-15, 0x1.28a2b2326d558p-16, -0x1.fbfa350544999p-18,
     0x1.be1c16d73155cp-19, -0x1.9038a1644680cp-20, 0x1.6bcfbb150af62p-21},
     /* [135] 1.875 <= y <= 2 2^-24, degree 10, 64.9 bits */
    {0x1.e80b52d3d91fp-1, -0x1.23f298c5c3bd5p-55, -0x1.187822870edb7p-7, 0x1.ac4f7bb417297p-9, -0x1.e60a7e9b8df44p-10,
     0x1.41167baa5d9b9p-10, -0x1.cc33a37b1199ap-11, 0x1.5afd770660004p-11, -0x1.0ee3f7edea0dbp-11,
     0x1.b1d237fe08e92p-12, -0x1.648ec96842f72p-12, 0x1.278e84b7f0c1ap-12},
     /* [136] 1 <= y <= 1.125 2^-23, degree 10, 63.5 bits */
    {0x1.e78557b44210fp-1, -0x1.c5a43680f2c79p-57, -0x1.004408459a0a9p-7, 0x1.5e42d7bdb8a44p-9, -0x1.63ab8058ebb5cp-10,
     0x1.a47bf4bd0a4bfp-11, -0x1.0d9f913f6fd9bp-11, 0x1.6bcd53a312a0fp-12, -0x1.fc40e032c1ae3p-13,
     0x1.6c2487af8027bp-13, -0x1.0b6cbf28182ddp-13, 0x1.8cabed1ef8adp-14},
     /* [137] 1.125 <= y <= 1.25 2^-23, degree 10, 64.0 bits */
    {0x1.e70a5be63353fp-1, 0x1.a379927bfdf9bp-55, -0x1.d88b29b02a96ep-8, 0x1.24428a64b0c2ap-9, -0x1.0c88f1899c263p-10,
     0x1.1f404bc131d1ep-11, -0x1.4d4fc3dbb0f44p-12, 0x1.96ea858b8d096p-13, -0x1.012dd7e923295p-13,
     0x1.4d6d0de72a038p-14, -0x1.baa8f2e88bc3bp-15, 0x1.2907ab0fdc9d7p-15},
     /* [138] 1.25 <= y <= 1.375 2^-23, degree 10, 65.1 bits */
    {0x1.e6988b33466adp-1, -0x1.b535eefc7f798p-59, -0x1.b6e699fb947d6p-8, 0x1.efd30731388cbp-10, -0x1.9fff1bde24f94p-11,
     0x1.9651091a8d804p-12, -0x1.ae7ca4d15db4ep-13, 0x1.dfdcf64cb7323p-14, -0x1.14eac0c6a657cp-14,
     0x1.47cd7c848f3c4p-15, -0x1.8d0fdc25a2396p-16, 0x1.e6873624e09fbp-17},
     /* [139] 1.375 <= y <= 1.5 2^-23, degree 10, 64.9 bits */
    {0x1.e62e802d442c8p-1, -0x1.730601bfe7c0cp-55, -0x1.9a2a7f4ab05aep-8, 0x1.aa6592ad17796p-10, -0x1.49278f6bdd9cep-11,
     0x1.27ca362a02c43p-12, -0x1.2052f56994abfp-13, 0x1.27b0b01a5875bp-14, -0x1.39f9c90512745p-15, 0x1.55f16ee4ff6cp-16,
     -0x1.7cd799693445p-17, 0x1.ad522de7fe8d6p-18}, /* [140] 1.5 <= y <= 1.625 2^-23, degree 10, 67.6 bits */
    {0x1.e5cb2361599c7p-1, -0x1.5754f7e8d6ddcp-55, -0x1.814f858a1f085p-8, 0x1.72f88acc09466p-10, -0x1.092d5424a6482p-11,
     0x1.b94fbd7eb453cp-13, -0x1.8e51ff6b2227dp-14, 0x1.7a3f13ceb12c6p-15, -0x1.73e4bbec86cc7p-16,
     0x1.77062d8593de2p-17, -0x1.8293f6b397b07p-18, 0x1.9381bf7ff698ep-19},
     /* [141] 1.625 <= y <= 1.75 2^-23, degree 10, 65.7 bits */
    {0x1.e56d95ed3126ep-1, -0x1.69e3035a26faep-55, -0x1.6b93fcaf6ba01p-8, 0x1.45f9b45a01761p-10, -0x1.b1eb4974e6d5bp-12,
     0x1.502e2597b0504p-13, -0x1.1a8339fa1d017p-14, 0x1.f38eb4ec437fap-16, -0x1.c94d39f92d8f1p-17,
     0x1.ad5a9968307eap-18, -0x1.9bea649deb6d1p-19, 0x1.904d8f0f3cca8p-20},
     /* [142] 1.75 <= y <= 1.875 2^-23, degree 10, 65.7 bits */
    {0x1.e51523022ba22p-1, -0x1.0ad600046001ep-60, -0x1.58661a2ee0e47p-8, 0x1.20eaad1617cffp-10, -0x1.67cd3895474eep-12,
     0x1.04c89baed9596p-13, -0x1.9a09bf839b659p-15, 0x1.53257455f822ap-16, -0x1.226f34ec73e55p-17,
     0x1.fe30ebee8be77p-19, -0x1.c9c32e82399c4p-20, 0x1.a028800d521e9p-21},
     /* [143] 1.875 <= y <= 2 2^-23, degree 10, 65.3 bits */
    {0x1.e498c9c101063p-1, 0x1.dd2494c885af7p-55, -0x1.3f7ce4f3624b6p-7, 0x1.e8e0f5344022cp-9, -0x1.159449fdd2da1p-9,
     0x1.6ee50bdb93fabp-10, -0x1.06ffdf6731238p-10, 0x1.8caec41feec91p-11, -0x1.35bc49478079ep-11,
     0x1.f018cceb4887bp-12, -0x1.97ca0cd1b5237p-12, 0x1.520e81e358ddp-12},
     /* [144] 1 <= y <= 1.125 2^-22, degree 10, 64.4 bits */
    {0x1.e4002e8ef75f4p-1, 0x1.505bfcab9cf1dp-56, -0x1.23dd141d72108p-7, 0x1.8fbc5ab1c32efp-9, -0x1.96325ed7a919ap-10,
     0x1.e06a2bd6c4659p-11, -0x1.34236b79ce785p-11, 0x1.9fdb9d00583fcp-12, -0x1.2289af5d692edp-12,
     0x1.a05fccd30a9c4p-13, -0x1.31d1c3d9a6b69p-13, 0x1.c5ab05dd4b50ep-14},
     /* [145] 1.125 <= y <= 1.25 2^-22, degree 10, 65.6 bits */
    {0x1.e374205d46dcdp-1, 0x1.083609a1954e1p-55, -0x1.0d0c03e3d4b3p-7, 0x1.4d7fa31082eeep-9, -0x1.32a5d26c590f3p-10,
     0x1.48282c8d768b1p-11, -0x1.7ce2a855bb2efp-12, 0x1.d1186aac23d9bp-13, -0x1.25ffe9d456fd9p-13,
     0x1.7d376cc2ae4ffp-14, -0x1.fa2af6d3b2e6cp-15, 0x1.53adeb9000d3ep-15},
     /* [146] 1.25 <= y <= 1.375 2^-22, degree 10, 65.6 bits */
    {0x1.e2f2887891045p-1, 0x1.4be903ef0396ap-56, -0x1.f3b4cb8d12f68p-8, 0x1.1adbf70b8ec64p-9, -0x1.dafcc44570429p-11,
     0x1.d021a19d85486p-12, -0x1.ebe24c95f4bc4p-13, 0x1.12360c24a33c5p-13, -0x1.3c892303cd3a5p-14,
     0x1.76c156cbe1e6ep-15, -0x1.c5fd7951eb5d9p-16, 0x1.162bbb0ca4095p-16},
     /* [147] 1.375 <= y <= 1.5 2^-22, degree 10, 65.1 bits */
    {0x1.e279cebcb786ap-1, -0x1.9ea599c628efbp-55, -0x1.d2ec327a59922p-8, 0x1.e67313c969599p-10, -0x1.77cb05863731dp-11,
     0x1.51d8adde4b4fp-12, -0x1.496a9b807a61cp-13, 0x1.51e84f99463c8p-14, -0x1.66ddf638c2aap-15, 0x1.86e3d40ab49c1p-16,
     -0x1.b3693c8da139ep-17, 0x1.eae36e49c6942p-18}, /* [148] 1.5 <= y <= 1.625 2^-22, degree 10, 66.0 bits */
    {0x1.e208b419ddaa8p-1, -0x1.520ca2da3b88ep-56, -0x1.b691736caa93cp-8, 0x1.a72c510ab1fd8p-10, -0x1.2eb8db60b2efep-11,
     0x1.f803c9aca08ccp-13, -0x1.c70d43e8f20e1p-14, 0x1.b03760e504a43p-15, -0x1.a908782e4dd55p-16,
     0x1.acaca249e2b48p-17, -0x1.b9efc32251cebp-18, 0x1.cd56e7f8cfb3dp-19},
     /* [149] 1.625 <= y <= 1.75 2^-22, degree 10, 65.3 bits */
    {0x1.e19e3a1bb3584p-1, -0x1.73dfeb2b92acap-55, -0x1.9dc75669afd1p-8, 0x1.73cf277902c2ap-10, -0x1.ef4fc7dc57eddp-12,
     0x1.7fea1e3d3e638p-13, -0x1.42b98cb5c8104p-14, 0x1.1d659d281f1c7p-15, -0x1.054dbe25ca09fp-16,
     0x1.eabdf0f393e01p-18, -0x1.d6decb9c86817p-19, 0x1.c9a54fce30f31p-20},
     /* [150] 1.75 <= y <= 1.875 2^-22, degree 10, 66.8 bits */
    {0x1.e139925c37de4p-1, -0x1.5943328afa192p-58, -0x1.87e75b7915acap-8, 0x1.49824e8fb908p-10, -0x1.9aac6687fdec8p-12,
     0x1.29ca0523456c4p-13, -0x1.d45e0cfd3cb07p-15, 0x1.837b15bafe24fp-16, -0x1.4be33c6f1dc62p-17,
     0x1.238c95cfc0c18p-18, -0x1.059f5a488d753p-19, 0x1.dbbdf8328a45cp-21},
     /* [151] 1.875 <= y <= 2 2^-22, degree 10, 66.2 bits */
    {0x1.e0ac154052d9bp-1, -0x1.1c36c94a296b5p-55, -0x1.6b7ea23f5424fp-7, 0x1.16bef93f12fe2p-8, -0x1.3cc9daa6b937cp-9,
     0x1.a2e96289db5b5p-10, -0x1.2c6180ffeeefp-10, 0x1.c52c07ecf4d64p-11, -0x1.61e8d30c18dc5p-11, 0x1.1b77ef671bb1ap-11,
     -0x1.d214c5cbcf71p-12, 0x1.826c976be64a9p-12}, /* [152] 1 <= y <= 1.125 2^-21, degree 10, 63.4 bits */
    {0x1.dffe7986c8a4bp-1, 0x1.8f1a5e3c98486p-57, -0x1.4bfef0f940a4p-7, 0x1.c7c3a606991bbp-9, -0x1.cf81bdb562ce8p-10,
     0x1.1239e72e56403p-10, -0x1.5fe400b37ac13p-11, 0x1.db0508f7168f9p-12, -0x1.4bef42c76d326p-12,
     0x1.dbc69405546bfp-13, -0x1.5d7ef0810357ep-13, 0x1.034288dcc76e5p-13},
     /* [153] 1.125 <= y <= 1.25 2^-21, degree 10, 63.7 bits */
    {0x1.df5f2d2bf963p-1, -0x1.f7b47dc364d6dp-57, -0x1.31fba8856590fp-7, 0x1.7c2fc275b5ee9p-9, -0x1.5dddb561fdc43p-10,
     0x1.7695cb44c46cp-11, -0x1.b2ea7ccb9d5a4p-12, 0x1.0999e1c892978p-12, -0x1.4fda6ba66946p-13, 0x1.b38e690ea3332p-14,
     -0x1.2132f1d912dc3p-14, 0x1.84328581fc36dp-15}, /* [154] 1.25 <= y <= 1.375 2^-21, degree 10, 64.9 bits */
    {0x1.decbce14a130dp-1, 0x1.c6526c2f3acf2p-55, -0x1.1c1a8a4cf1a2ep-7, 0x1.4269e530e0f42p-9, -0x1.0eeea90a61bcdp-10,
     0x1.08de51dc8eb76p-11, -0x1.18ccb7423eab2p-12, 0x1.39275f95a47aap-13, -0x1.698fa1c322392p-14,
     0x1.ac21d5ac14e83p-15, -0x1.035cce6749747p-15, 0x1.3ddfa3b5274b7p-16},
     /* [155] 1.375 <= y <= 1.5 2^-21, degree 10, 65.4 bits */
    {0x1.de428a9d3bc49p-1, 0x1.47d5313f1f374p-55, -0x1.096bbe046e8eep-7, 0x1.153384e7c18ap-9, -0x1.aca79f1acecdcp-11,
     0x1.818f6d26641aep-12, -0x1.7811270c787e5p-13, 0x1.81dbd0c4be087p-14, -0x1.99e016a24315p-15, 0x1.be863830530abp-16,
     -0x1.f173d9c22e144p-17, 0x1.18739a6d2ad5ap-17}, /* [156] 1.5 <= y <= 1.625 2^-21, degree 10, 63.9 bits */
    {0x1.ddc1f6ce49bd2p-1, -0x1.9dc58ce8e1e6fp-57, -0x1.f2873df198198p-8, 0x1.e23a9c9106b95p-10, -0x1.59449f372ab1ap-11,
     0x1.1f91cb2ab8461p-12, -0x1.03b8f77f968b5p-13, 0x1.ed816f7e19f69p-15, -0x1.e5674145a23f4p-16,
     0x1.e9a5054f9e8b4p-17, -0x1.f8dda18e6f614p-18, 0x1.078c61b0c08eep-18},
     /* [157] 1.625 <= y <= 1.75 2^-21, degree 10, 69.9 bits */
    {0x1.dd48f06bf000bp-1, 0x1.be4b7ec24cf35p-55, -0x1.d647e7009e394p-8, 0x1.a7a6255928602p-10, -0x1.1a6f1670fedaap-11,
     0x1.b60cab475022cp-13, -0x1.705c1f3ce92d1p-14, 0x1.45d6c4a7e4389p-15, -0x1.2a64c5b6f8304p-16,
     0x1.183f5b0ea094ep-17, -0x1.0cf0487ee8cd4p-18, 0x1.056b0dfc067edp-19},
     /* [158] 1.75 <= y <= 1.875 2^-21, degree 10, 66.0 bits */
    {0x1.dcd68c10d2df9p-1, 0x1.c6c095abcfe91p-56, -0x1.bd5b7a5263857p-8, 0x1.7769308f87351p-10, -0x1.d44c96bf21105p-12,
     0x1.53bfddbd49a4p-13, -0x1.0b46a46700f63p-14, 0x1.ba5a47f3adfebp-16, -0x1.7af77abbf8911p-17, 0x1.4cf6c75b42ba2p-18,
     -0x1.2ad48e80ba0cdp-19, 0x1.0fbc4941c61a4p-20}, /* [159] 1.875 <= y <= 2 2^-21, degree 10, 65.6 bits */
    {0x1.dc35c696645e1p-1, -0x1.d71db0af7e3ddp-56, -0x1.9cfe3fec66446p-7, 0x1.3d87510f06285p-8, -0x1.69311099a9a63p-9,
     0x1.dde106c682a7fp-10, -0x1.56c95f29e2da2p-10, 0x1.02a4cbc3c1e19p-10, -0x1.94115d26fedcbp-11,
     0x1.43b365b496a61p-11, -0x1.0a27f021857e1p-11, 0x1.b9648cb6e3387p-12},
     /* [160] 1 <= y <= 1.125 2^-20, degree 10, 63.6 bits */
    {0x1.db708cce2311ep-1, 0x1.cea1f17789943p-56, -0x1.791d7849bca2ap-7, 0x1.038a37f694867p-8, -0x1.08319d466286p-9,
     0x1.38c76bb9e3ebcp-10, -0x1.91826efcbb1b4p-11, 0x1.0f133923906e2p-11, -0x1.7aed5dfdd112dp-12,
     0x1.0f9d7ccf6f9f4p-12, -0x1.8f1bc3868703fp-13, 0x1.281a2b92b6452p-13},
     /* [161] 1.125 <= y <= 1.25 2^-20, degree 10, 63.7 bits */
    {0x1.dabb9f57fecdep-1, -0x1.bf4059560bd5p-56, -0x1.5b7db351f5785p-7, 0x1.b0ede2bb833fep-9, -0x1.8ec77202e05c2p-10,
     0x1.ab2fcefbdf87p-11, -0x1.f02ce466b7c3p-12, 0x1.2f18e3fce2bf1p-12, -0x1.7f5a553c3975ap-13, 0x1.f13fa58e6c776p-14,
     -0x1.4a3693202bf26p-14, 0x1.bb4fae77ebb67p-15}, /* [162] 1.25 <= y <= 1.375 2^-20, degree 10, 65.1 bits */
    {0x1.da1446bd7fb7ap-1, 0x1.a3a7d053d5b48p-55, -0x1.42940ab648d42p-7, 0x1.6f15791297a07p-9, -0x1.34c43c4006556p-10,
     0x1.2e05fd03daaa4p-11, -0x1.404fbb517e76fp-12, 0x1.65520fabdb1efp-13, -0x1.9ca6262c92688p-14, 0x1.e8b7ddf9c127p-15,
     -0x1.281ce8c82bb18p-15, 0x1.6af6edb31a85cp-16}, /* [163] 1.375 <= y <= 1.5 2^-20, degree 10, 66.6 bits */
    {0x1.d978704a330b5p-1, -0x1.83b7a0036a3abp-55, -0x1.2d4efbbb78284p-7, 0x1.3b8fa2cc8fe01p-9, -0x1.e8733ce9d15b9p-11,
     0x1.b79782d97bd21p-12, -0x1.acef2ec3e4da3p-13, 0x1.b83b0b88da8c9p-14, -0x1.d3bd619f2bdb5p-15,
     0x1.fda8ee0fd36fap-16, -0x1.1bf0cd8882cbcp-16, 0x1.4033c796dded1p-17},
     /* [164] 1.5 <= y <= 1.625 2^-20, degree 10, 65.2 bits */
    {0x1.d8e67d3943bbbp-1, -0x1.d21e45894fe21p-56, -0x1.1aead061166fap-7, 0x1.12715d3ce3fcp-9, -0x1.89620e12a1841p-11,
     0x1.47d4d3c40b86fp-12, -0x1.2833b6fb78347p-13, 0x1.197e6a9a8b9f7p-14, -0x1.14eff59e28c36p-15, 0x1.176945e023acp-16,
     -0x1.2024fd78be12p-17, 0x1.2ce0084c66c53p-18}, /* [165] 1.625 <= y <= 1.75 2^-20, degree 10, 66.3 bits */
    {0x1.d85d22d6fbfe4p-1, 0x1.201983d97f9c4p-55, -0x1.0ad7a06b768aap-7, 0x1.e22563a15bb38p-10, -0x1.41c16161cc11dp-11,
     0x1.f353688a0c0bp-13, -0x1.a40e195e0df7fp-14, 0x1.73ad9f1021691p-15, -0x1.5473f4c04d502p-16, 0x1.3fcfd53a69a38p-17,
     -0x1.32f529ef53c3dp-18, 0x1.2a6abfe9d373fp-19}, /* [166] 1.75 <= y <= 1.875 2^-20, degree 10, 64.7 bits */
    {0x1.d7db54f3d3749p-1, 0x1.a8311988c39bcp-56, -0x1.f95243e010df9p-8, 0x1.ab31eb97dd589p-10, -0x1.0ab832c8d1409p-11,
     0x1.833c54c920998p-13, -0x1.30c17348b28e4p-14, 0x1.f8894b62e596ep-16, -0x1.b0581c9e188c5p-17,
     0x1.7bf002d2c4c09p-18, -0x1.550bc9837eac6p-19, 0x1.362b30dc070c4p-20},
     /* [167] 1.875 <= y <= 2 2^-20, degree 10, 65.7 bits */
    {0x1.d724ef176ffbap-1, 0x1.d07706835a0fep-55, -0x1.d47ef90e083b9p-7, 0x1.69442857070c9p-8, -0x1.9b5ea1a0b3a25p-9,
     0x1.104bee2b824afp-9, -0x1.86cd472c707fcp-10, 0x1.26f6c803c2429p-10, -0x1.ccec2de5ccaf5p-11, 0x1.71527b8863cp-11,
     -0x1.2fb84d805666cp-11, 0x1.f7c36afbf7b1bp-12}, /* [168] 1 <= y <= 1.125 2^-19, degree 10, 63.5 bits */
    {0x1.d6453bac65426p-1, 0x1.0670204bf1131p-55, -0x1.abae20c06e0f7p-7, 0x1.273a442c772d2p-8, -0x1.2cd6f1fbc3dcap-9,
     0x1.6461b39b15a43p-10, -0x1.c9ac7a3415aaep-11, 0x1.3517679442509p-11, -0x1.b02d70293bf7dp-12,
     0x1.35d96102da1c7p-12, -0x1.c75e9b49fd5e4p-13, 0x1.51e4de3b2d14dp-13},
     /* [169] 1.125 <= y <= 1.25 2^-19, degree 10, 63.6 bits */
    {0x1.d5781252a9974p-1, 0x1.27fde4f6b5cdbp-55, -0x1.89fc62a1547bp-7, 0x1.ec5cf18bc690bp-9, -0x1.c6039da418f0ep-10,
     0x1.e6a8d9e70c18fp-11, -0x1.1abf57403f574p-11, 0x1.598db2266980bp-12, -0x1.b529ac5714abbp-13,
     0x1.1b952b99c2c31p-13, -0x1.78b61de1f81c1p-14, 0x1.f9d02ef95fa4fp-15},
     /* [170] 1.25 <= y <= 1.375 2^-19, degree 10, 65.6 bits */
    {0x1.d4ba5b2b7da6dp-1, -0x1.504931326d65ap-58, -0x1.6da7d2f214b22p-7, 0x1.a1673d19dc58ep-9, -0x1.5f7a368f5add2p-10,
     0x1.5804fbad8f3a8p-11, -0x1.6d026e4a7ce6cp-12, 0x1.975108e6f552dp-13, -0x1.d6825215b9645p-14,
     0x1.16ae9bd3749e6p-14, -0x1.51c4613d7e3edp-15, 0x1.9e167d94b39c4p-16},
     /* [171] 1.375 <= y <= 1.5 2^-19, degree 10, 66.8 bits */
    {0x1.d409ba0b2e6fdp-1, -0x1.2321c1f805902p-61, -0x1.5578dfe813d85p-7, 0x1.66c1fb0451538p-9, -0x1.15f766c3126fap-10,
     0x1.f4a5921965f2fp-12, -0x1.e8b9b336f93aep-13, 0x1.f5c3747a85ef9p-14, -0x1.0aa1218af9f38p-14,
     0x1.2296c2f040a43p-15, -0x1.43d8423665c32p-16, 0x1.6d42c6defc00ep-17},
     /* [172] 1.5 <= y <= 1.625 2^-19, degree 10, 64.1 bits */
    {0x1.d36456d52dd1cp-1, -0x1.68bfcf2e86ae6p-55, -0x1.4090a038710cp-7, 0x1.37f640e1331c1p-9, -0x1.bfab2c1a24ccp-11,
     0x1.7550a2f721d8ap-12, -0x1.5172f19e3981fp-13, 0x1.40cd148664a4dp-14, -0x1.3bb1746ccd47bp-15,
     0x1.3e957861a877cp-16, -0x1.489a7d8595372p-17, 0x1.572d64791fda7p-18},
     /* [173] 1.625 <= y <= 1.75 2^-19, degree 10, 63.9 bits */
    {0x1.d2c8b92b7efd2p-1, 0x1.eeaf4264c42b5p-57, -0x1.2e4b314109c8bp-7, 0x1.11fd59a8feecp-9, -0x1.6e1bb10846c86p-11,
     0x1.1c442d7429677p-12, -0x1.de7e313f37b6fp-14, 0x1.a787f4bb048fbp-15, -0x1.840e2807971c8p-16,
     0x1.6c9c2d52dfb38p-17, -0x1.5e05aefed1cb4p-18, 0x1.5456dbdd7a5efp-19},
     /* [174] 1.75 <= y <= 1.875 2^-19, degree 10, 64.0 bits */
    {0x1.d235afe100122p-1, -0x1.56949972168afp-56, -0x1.1e2d449b1ae12p-7, 0x1.e57510177ce4bp-10, -0x1.2f72a546841c5p-11,
     0x1.b8daf629ce5b1p-13, -0x1.5b1d5c54d94c3p-14, 0x1.1f6e7abf691fcp-15, -0x1.ecbe8362f5d1dp-17,
     0x1.b11d5fca9fa19p-18, -0x1.84dae86af4e16p-19, 0x1.61b54e81463c5p-20},
     /* [175] 1.875 <= y <= 2 2^-19, degree 10, 68.6 bits */
    {0x1.d1671e96e36bbp-1, -0x1.0af29787c6c51p-59, -0x1.094146f7e4638p-6, 0x1.9a74ce032fba1p-8, -0x1.d3ef396f31259p-9,
     0x1.35f336741370bp-9, -0x1.bd0d29c901191p-10, 0x1.50074abd65224p-10, -0x1.069e9cce1c7e2p-10, 0x1.a4f45bd8fcc98p-11,
     -0x1.5a3fe63a7cd66p-11, 0x1.1f337f81f1968p-11}, /* [176] 1 <= y <= 1.125 2^-18, degree 10, 63.7 bits */
    {0x1.d069d8c72b124p-1, -0x1.9b34bf8498451p-55, -0x1.e4246645b028ep-7, 0x1.4f584b09e7dcdp-8, -0x1.5621d8918ba43p-9,
     0x1.9594abc11aa7fp-10, -0x1.048da1652c047p-10, 0x1.600eddeb4b243p-11, -0x1.ec65473132d4dp-12,
     0x1.611b26c17b2e5p-12, -0x1.038607ea87ba9p-12, 0x1.8135fc45e7e2bp-13},
     /* [177] 1.125 <= y <= 1.25 2^-18, degree 10, 63.7 bits */
    {0x1.cf81a201c8f75p-1, 0x1.4441c4d1eab39p-56, -0x1.bddf9b2d912f6p-7, 0x1.17927cd5ddd4ap-8, -0x1.021d439cdc8edp-9,
     0x1.14dee35abf8eep-10, -0x1.41e110247222dp-11, 0x1.8985b92f2e056p-12, -0x1.f1fe8de65a22fp-13,
     0x1.431f18ea811c7p-13, -0x1.ad52bbe151d8p-14, 0x1.204756b42f429p-14},
     /* [178] 1.25 <= y <= 1.375 2^-18, degree 10, 65.7 bits */
    {0x1.ceaaf5cae377cp-1, 0x1.9b0729ea792fbp-59, -0x1.9db42dee59ac5p-7, 0x1.d9eb9bd71195bp-9, -0x1.8f91515e0d573p-10,
     0x1.875f5abb57d2fp-11, -0x1.9f756429e0ae9p-12, 0x1.cfc9695cac769p-13, -0x1.0bf32faa50f06p-13,
     0x1.3d7db222b700cp-14, -0x1.80e2802b047f3p-15, 0x1.d7efdc0c19ae1p-16},
     /* [179] 1.375 <= y <= 1.5 2^-18, degree 10, 64.9 bits */
    {0x1.cde3253a69c75p-1, 0x1.ccac404b67458p-57, -0x1.823fa0b0aa93ep-7, 0x1.97419c123b853p-9, -0x1.3bf1cdb867003p-10,
     0x1.1cbbe80d9ddb4p-11, -0x1.161839e3e5428p-12, 0x1.1d9f50f42b6f9p-13, -0x1.2fa47e0097293p-14, 0x1.4b02be8dc7f4p-15,
     -0x1.70f894fb757ap-16, 0x1.a03bfe0d0be4ap-17}, /* [180] 1.5 <= y <= 1.625 2^-18, degree 10, 66.7 bits */
    {0x1.cd2817a5a748dp-1, 0x1.1723a98a85841p-55, -0x1.6a845fafca0a7p-7, 0x1.62122cd527576p-9, -0x1.fcc052d9fbf88p-11,
     0x1.a891af1b5bca3p-12, -0x1.7ff9dd7583379p-13, 0x1.6d2c8198cf154p-14, -0x1.6778485e0d4c5p-15,
     0x1.6ada7524987e8p-16, -0x1.765893607e6b7p-17, 0x1.8705682a7d82ep-18},
     /* [181] 1.625 <= y <= 1.75 2^-18, degree 10, 68.6 bits */
    {0x1.cc78214a4c939p-1, -0x1.2534a0b7aa688p-57, -0x1.55c8040c98c3fp-7, 0x1.36ebb5433814cp-9, -0x1.9fffd19b84602p-11,
     0x1.433fbb5acb561p-12, -0x1.1032703a39bap-13, 0x1.e20d25027313fp-15, -0x1.b9cfb86c5066ap-16, 0x1.9f399ed700f5p-17,
     -0x1.8eb303c6623e9p-18, 0x1.83be248dbd5d5p-19}, /* [182] 1.75 <= y <= 1.875 2^-18, degree 10, 66.0 bits */
    {0x1.cbd1e75d62414p-1, -0x1.25f497cd82b16p-55, -0x1.437e53aa98445p-7, 0x1.1366f24f58ff8p-9, -0x1.58c02c0a5f573p-11,
     0x1.f53ead8c621ddp-13, -0x1.8adf1dc4dd3abp-14, 0x1.471b5c66f740ap-15, -0x1.1877e2a257e42p-16,
     0x1.ed2ee7ba73e4dp-18, -0x1.bae21cc433f6fp-19, 0x1.92ee08d2ca788p-20},
     /* [183] 1.875 <= y <= 2 2^-18, degree 10, 64.4 bits */
    {0x1.cae86f07b227ep-1, 0x1.046826784dab3p-57, -0x1.2bc20a924a846p-6, 0x1.d19a60c24f7ap-8, -0x1.09c26ea6a917bp-8,
     0x1.60577d2c31cf1p-9, -0x1.fa314717b8ef2p-10, 0x1.7e58b104f7ae3p-10, -0x1.2aea37316ce0fp-10, 0x1.df426fcce46c9p-11,
     -0x1.8a4c079b4331fp-11, 0x1.471e3c9ef13efp-11}, /* [184] 1 <= y <= 1.125 2^-17, degree 10, 62.7 bits */
    {0x1.c9ca444489f7fp-1, 0x1.a8a7e1cd63803p-56, -0x1.1176777ca5cbcp-6, 0x1.7c4ba0483b55fp-8, -0x1.8486c0b83f177p-9,
     0x1.ccf2183feedb2p-10, -0x1.28487fb1043ecp-10, 0x1.90805f400b8c3p-11, -0x1.182aabc4e33b5p-11,
     0x1.91ef2e2bfb883p-12, -0x1.277aba3115ea8p-12, 0x1.b6aac5e5c4addp-13},
     /* [185] 1.125 <= y <= 1.25 2^-17, degree 10, 63.4 bits */
    {0x1.c8c3fb3cfd33cp-1, -0x1.8369ff120c2b1p-58, -0x1.f78854ecdd37ap-7, 0x1.3cf77b94c6e7fp-8, -0x1.250c892b86e8fp-9,
     0x1.3a9961fab4e84p-10, -0x1.6df1ff73c135cp-11, 0x1.bf95be665494bp-12, -0x1.1b4caa0e5fb8fp-12,
     0x1.6fbc9c0dcfbf4p-13, -0x1.e8b7ad84fc633p-14, 0x1.483a04cad297dp-14},
     /* [186] 1.25 <= y <= 1.375 2^-17, degree 10, 63.9 bits */
    {0x1.c7d19572e7818p-1, -0x1.5d0d1e4a30c71p-55, -0x1.d31070cce32fp-7, 0x1.0c979db89c143p-8, -0x1.c58d5ed044877p-10,
     0x1.bc9de93fd385p-11, -0x1.d83f8943b3544p-12, 0x1.07b43fc02a7b5p-12, -0x1.30cf82b45620dp-13, 0x1.6944abcb6e8c1p-14,
     -0x1.b60f3bce7c355p-15, 0x1.0c9fe2dff2628p-15}, /* [187] 1.375 <= y <= 1.5 2^-17, degree 10, 64.1 bits */
    {0x1.c6f007182e9cfp-1, -0x1.50368a0cad403p-55, -0x1.b3f27ed14f691p-7, 0x1.cd855470c095ep-9, -0x1.668f9743cdf47p-10,
     0x1.436966b79284ap-11, -0x1.3c0d92b088bbfp-12, 0x1.44bfdbae653b9p-13, -0x1.595b9158d053ap-14,
     0x1.7897df2398616p-15, -0x1.a3e20ec0abf1dp-16, 0x1.d9c4581a2b852p-17},
     /* [188] 1.5 <= y <= 1.625 2^-17, degree 10, 64.8 bits */
    {0x1.c61cef0d96469p-1, 0x1.23c767cc449fep-58, -0x1.990e715fb5c22p-7, 0x1.912abfc53614ap-9, -0x1.20a263b6d3ee8p-10,
     0x1.e228c6e08594fp-12, -0x1.b450d6f508445p-13, 0x1.9f224769482c7p-14, -0x1.98cb03a68e5afp-15,
     0x1.9cc2a55975ecep-16, -0x1.a9f04f68fa2cp-17, 0x1.bd01a5fa81e0ap-18},
     /* [189] 1.625 <= y <= 1.75 2^-17, degree 10, 65.8 bits */
    {0x1.c55667e822389p-1, -0x1.ab4b0b9020893p-55, -0x1.81909381a30d4p-7, 0x1.6035a038f3472p-9, -0x1.d7f191d985f9p-11,
     0x1.6f095effa172cp-12, -0x1.3540bc39e7934p-13, 0x1.11f5e6ede96c8p-14, -0x1.f65c829e3d407p-16,
     0x1.d84524d9a4b1ap-17, -0x1.c59655989b44bp-18, 0x1.b9379f8aca861p-19},
     /* [190] 1.75 <= y <= 1.875 2^-17, degree 10, 64.1 bits */
    {0x1.c49ae83020f9bp-1, 0x1.3d32356736ca7p-55, -0x1.6cd9a8934e554p-7, 0x1.37eae049e8d3p-9, -0x1.870caf3d351fap-11,
     0x1.1c875780d5b93p-12, -0x1.c0901c6586947p-14, 0x1.73c0adcdbb285p-15, -0x1.3edd0b62efde6p-16,
     0x1.186ebd68edd1ep-17, -0x1.f7ca2a148d6f9p-19, 0x1.ca7112670931bp-20},
     /* [191] 1.875 <= y <= 2 2^-17, degree 10, 64.8 bits */
    {0x1.c393a1b580fecp-1, 0x1.de76a62eb648fp-56, -0x1.51f896b418edcp-6, 0x1.0799e300c0affp-7, -0x1.2d618681ec4fbp-8,
     0x1.8fec7e8ed4a08p-9, -0x1.1f73a2d3217bcp-9, 0x1.b27261bb32047p-10, -0x1.53c5684c03cc3p-10, 0x1.10771c38341bdp-10,
     -0x1.c0713ac252db1p-11, 0x1.741eee7898c52p-11}, /* [192] 1 <= y <= 1.125 2^-16, degree 10, 63.3 bits */
    {0x1.c2510c4cd1e45p-1, -0x1.c22851213c9d6p-56, -0x1.343399cea354bp-6, 0x1.ae7930f33960ep-8, -0x1.b87a9e01627d3p-9,
     0x1.0587409e1351fp-9, -0x1.506ab5d735b23p-10, 0x1.c6f76e97ecbdcp-11, -0x1.3e62f09c3214bp-11, 0x1.c8e81f075ebb9p-12,
     -0x1.4ffb1bb21370cp-12, 0x1.f2e88aefa48f6p-13}, /* [193] 1.125 <= y <= 1.25 2^-16, degree 10, 63.0 bits */
    {0x1.c1297f616c33ap-1, -0x1.07db4c5cd718fp-55, -0x1.1ba5542031c5cp-6, 0x1.66af8143a6ed5p-8, -0x1.4c26114ca7baap-9,
     0x1.64e77cc8720abp-10, -0x1.9f6b7ccddcefcp-11, 0x1.fc574c3c78c1p-12, -0x1.41e0c844b4a17p-12, 0x1.a1f208aa804ffp-13,
     -0x1.15cc0060a021cp-13, 0x1.753a3bd38ca63p-14}, /* [194] 1.25 <= y <= 1.375 2^-16, degree 10, 63.4 bits */
    {0x1.c01873dc8c9a9p-1, -0x1.c875e5e250c64p-56, -0x1.0703af80a4032p-6, 0x1.2fdcf692b857bp-8, -0x1.00f8d1d66d55p-9,
     0x1.f84b0b079d82ep-11, -0x1.0bfd88d425272p-11, 0x1.2b7051aa45ffdp-12, -0x1.5a400b4a7f7d8p-13,
     0x1.9a83dadfc669ap-14, -0x1.f1e913afede09p-15, 0x1.3165d7bc61da3p-15},
     /* [195] 1.375 <= y <= 1.5 2^-16, degree 10, 63.5 bits */
    {0x1.bf1a75fc3f58ep-1, 0x1.2c54d7376921p-56, -0x1.ead475a733ca1p-7, 0x1.04ff9ff254069p-8, -0x1.9636b0245b7bp-10,
     0x1.6ebe59f2ee47p-11, -0x1.66a29b613cb88p-12, 0x1.70afb102825a6p-13, -0x1.883cd46804c95p-14, 0x1.abda47e1225e1p-15,
     -0x1.dd2ad423ab466p-16, 0x1.0d43fe52bd81cp-16}, /* [196] 1.5 <= y <= 1.625 2^-16, degree 10, 64.9 bits */
    {0x1.be2cd39776f95p-1, -0x1.8a6073d011eb1p-55, -0x1.cc6b3c551500ep-7, 0x1.c5a111c7fc4e5p-9, -0x1.46ececbda94a4p-10,
     0x1.1153b6ad7107fp-11, -0x1.ef025f7d4a7afp-13, 0x1.d7372016d6828p-14, -0x1.d034313b4696fp-15,
     0x1.d4dd322a25a7ap-16, -0x1.e3f850c8a641ep-17, 0x1.f9c217497ca07p-18},
     /* [197] 1.625 <= y <= 1.75 2^-16, degree 10, 66.3 bits */
    {0x1.bd4d66cd3ec6ep-1, -0x1.1a70a160ee321p-62, -0x1.b1dba5b05d0cfp-7, 0x1.8e2ea017c9108p-9, -0x1.0b3957f8bba3cp-10,
     0x1.a00e49dd33968p-12, -0x1.5ecae1bcd9b47p-13, 0x1.36eb1abeb0bcap-14, -0x1.1d2e6a037a3ebp-15,
     0x1.0c3060d6846c4p-16, -0x1.01a72d45f7c62p-17, 0x1.f5604cf1872edp-19},
     /* [198] 1.75 <= y <= 1.875 2^-16, degree 10, 65.0 bits */
    {0x1.bc7a71fd205b5p-1, -0x1.b52baa42af1aap-56, -0x1.9a712bf970912p-7, 0x1.608ed96ad9cdp-9, -0x1.bac204b4804bep-11,
     0x1.4278fc112451fp-12, -0x1.fcbb24bb5f21ep-14, 0x1.a5d5fd1bf68adp-15, -0x1.69f86458a03cp-16, 0x1.3e73bed1e1945p-17,
     -0x1.1e20c947f03eep-18, 0x1.046ffbf142c91p-19}, /* [199] 1.875 <= y <= 2 2^-16, degree 10, 64.1 bits */
    {0x1.bb525338e60bcp-1, -0x1.2803b889eb464p-56, -0x1.7c10a9db87233p-6, 0x1.29dc1694f051p-7, -0x1.5524a80f7c53cp-8,
     0x1.c525514cc2a33p-9, -0x1.45eef3a853d71p-9, 0x1.ecddc94356f31p-10, -0x1.819f06e73c499p-10, 0x1.3556fa747b0fap-10,
     -0x1.fd48a74bce705p-11, 0x1.a6b6ef0bf9dafp-11}, /* [200] 1 <= y <= 1.125 2^-15, degree 10, 62.2 bits */
    {0x1.b9e7a52a64829p-1, -0x1.75e2eff279b75p-55, -0x1.5a6ebb33adf0dp-6, 0x1.e63ee9ddd10d6p-8, -0x1.f26ecca9e906dp-9,
     0x1.283e65da91846p-9, -0x1.7d5848c72dc7cp-10, 0x1.020082cc10487p-10, -0x1.69414e7487b8p-11, 0x1.034dfcae6a637p-11,
     -0x1.7d77e44637c73p-12, 0x1.1b4ce171ceb63p-12}, /* [201] 1.125 <= y <= 1.25 2^-15, degree 10, 62.6 bits */
    {0x1.b89b80535076p-1, -0x1.d80b2a70f9672p-57, -0x1.3eb32653c1492p-6, 0x1.95063c6adfa73p-8, -0x1.77bd1f73ad858p-9,
     0x1.942b2be685748p-10, -0x1.d6c6819fdda2bp-11, 0x1.203272b0fee28p-11, -0x1.6d20c1db96f4dp-12,
     0x1.da463acc4a6bcp-13, -0x1.3b5584dfbd54bp-13, 0x1.a7c57c05df2e9p-14},
     /* [202] 1.25 <= y <= 1.375 2^-15, degree 10, 63.2 bits */
    {0x1.b768c546f7d74p-1, 0x1.dff9a9ac512dep-55, -0x1.27680ed71364fp-6, 0x1.5703f2b053623p-8, -0x1.229de6611f4f3p-9,
     0x1.1d771d6335f7dp-10, -0x1.2fa08783b220ap-11, 0x1.53724c752e339p-12, -0x1.88afbb84edac4p-13,
     0x1.d1bd9480ffb05p-14, -0x1.1a88e51eae832p-14, 0x1.5aaef6e400bbap-15},
     /* [203] 1.375 <= y <= 1.5 2^-15, degree 10, 63.5 bits */
    {0x1.b64b8c6690801p-1, 0x1.64c915c4cd85ep-56, -0x1.138aca00ef72p-6, 0x1.268b6c92003dp-8, -0x1.cb481bc458495p-10,
     0x1.9f1b4b0881497p-11, -0x1.963be081a0b98p-12, 0x1.a1db00f70c04p-13, -0x1.bcbf7e82f978ap-14, 0x1.e54fbf3067bf3p-15,
     -0x1.0eb5d44666704p-15, 0x1.319b67c398575p-16}, /* [204] 1.5 <= y <= 1.625 2^-15, degree 10, 65.4 bits */
    {0x1.b540c942eab6dp-1, 0x1.fdd31161aa13fp-57, -0x1.02626f084e825p-6, 0x1.ffcc771737997p-9, -0x1.718c1a80a74abp-10,
     0x1.354d610fbc2ebp-11, -0x1.184b6ad474b94p-12, 0x1.0af98bb18fbe8p-13, -0x1.071f6250c5f4ep-14,
     0x1.09dd4c0ce107fp-15, -0x1.1284b265a0015p-16, 0x1.1ef4dcc2954a6p-17},
     /* [205] 1.625 <= y <= 1.75 2^-15, degree 10, 64.4 bits */
    {0x1.b4460e35c8d41p-1, 0x1.13fc65c6124e9p-58, -0x1.e6ce4d237d161p-7, 0x1.c12139633ef3bp-9, -0x1.2dfea5697fa8fp-10,
     0x1.d6b7e9fe50bcfp-12, -0x1.8d2fe956e98dp-13, 0x1.603e90c09a704p-14, -0x1.433c77ba33fc3p-15, 0x1.3017bd9a8b1c6p-16,
     -0x1.243dd08c969acp-17, 0x1.1c6bda9ee5a2ep-18}, /* [206] 1.75 <= y <= 1.875 2^-15, degree 10, 63.8 bits */
    {0x1.b3596392d7725p-1, 0x1.73a518317fb95p-55, -0x1.cc659d8edb2bap-7, 0x1.8d93104a7ca0cp-9, -0x1.f4434232e40d2p-11,
     0x1.6cc489a322c89p-12, -0x1.1ff3eb652d31ap-13, 0x1.ddd1710351afep-15, -0x1.9a333c289409p-16, 0x1.6905fca365a89p-17,
     -0x1.447c32d49e13p-18, 0x1.276f3a911ff3p-19}, /* [207] 1.875 <= y <= 2 2^-15, degree 10, 65.3 bits */
    {0x1.b20d4beb7e5adp-1, -0x1.30e0a0261bb56p-55, -0x1.aa2596c91950cp-6, 0x1.4fc7eccb97f9fp-7, -0x1.8155ebbe2f9bp-8,
     0x1.0037f498ba89ep-8, -0x1.70df81d0c236ap-9, 0x1.1711079503c8p-9, -0x1.b4e50e97bad31p-10, 0x1.5e9be0869907cp-10,
     -0x1.20b61cea9c9e8p-10, 0x1.df68ddd66541fp-11}, /* [208] 1 <= y <= 1.125 2^-14, degree 10, 62.4 bits */
    {0x1.b076bee265852p-1, -0x1.5e3f7e6d83a13p-63, -0x1.843d6ff9811cep-6, 0x1.11f6da088fcbbp-7, -0x1.1965c5e9ea445p-8,
     0x1.4ee417cd32c9ap-9, -0x1.af71c2c4a58f6p-10, 0x1.2413786e892aep-10, -0x1.992a475746c3cp-11, 0x1.25cfec3895856p-11,
     -0x1.b061ce8a7cd99p-12, 0x1.4134e2a49eed7p-12}, /* [209] 1.125 <= y <= 1.25 2^-14, degree 10, 63.1 bits */
    {0x1.af029adaa9c3dp-1, -0x1.5ea1809a5d7f3p-56, -0x1.64feb379fac03p-6, 0x1.c83be3307582ep-8, -0x1.a81d86e73463ap-9,
     0x1.c8c092abd8d6ep-10, -0x1.0a3b872e3214dp-10, 0x1.462a58114de8dp-11, -0x1.9d6fd774340e6p-12,
     0x1.0c9f4bbd64b81p-12, -0x1.6553a3adb860ep-13, 0x1.e0595c9e001ddp-14},
     /* [210] 1.25 <= y <= 1.375 2^-14, degree 10, 64.8 bits */
    {0x1.adab1746331ffp-1, -0x1.9a3904bd4ec06p-56, -0x1.4ac2ccb10ff4dp-6, 0x1.824078cff6b68p-8, -0x1.47ee9bb5c87f5p-9,
     0x1.4282f8a34953bp-10, -0x1.5751adf07f72dp-11, 0x1.801090303e061p-12, -0x1.bc8701a83fc16p-13, 0x1.07b91402d2p-13,
     -0x1.4014d7c266c73p-14, 0x1.88e010d84f968p-15}, /* [211] 1.375 <= y <= 1.5 2^-14, degree 10, 63.2 bits */
    {0x1.ac6bcbf99b371p-1, 0x1.165ff1f3cba9dp-55, -0x1.34657291f6cecp-6, 0x1.4b90a87ecbf29p-8, -0x1.030d46a7ae8dcp-9,
     0x1.d4d9b256a23dep-11, -0x1.cb389c1a4c5b4p-12, 0x1.d8a9c7b7cfb69p-13, -0x1.f75767c5e965p-14, 0x1.12bdafe7a4384p-14,
     -0x1.329da6d22e21fp-15, 0x1.5a3fb2928c7f1p-16}, /* [212] 1.5 <= y <= 1.625 2^-14, degree 10, 64.8 bits */
    {0x1.ab41486d2f5d8p-1, -0x1.330475d8a78dep-55, -0x1.2115c340de2d7p-6, 0x1.1ff9e0e22ade7p-8, -0x1.a0c386954dc9ep-10,
     0x1.5d4252ea6de8dp-11, -0x1.3cc74e9867f4dp-12, 0x1.2dec21136e28p-13, -0x1.29b89034b948ep-14, 0x1.2cf3e9d326774p-15,
     -0x1.36dcdce804099p-16, 0x1.450cda2280b01p-17}, /* [213] 1.625 <= y <= 1.75 2^-14, degree 10, 66.5 bits */
    {0x1.aa28cf725d10cp-1, -0x1.a151b57d5eaabp-55, -0x1.103a55436b14ep-6, 0x1.f948f2620aad2p-9, -0x1.547e47b4c0898p-10,
     0x1.09b34e44c0722p-11, -0x1.c0c8c87ea0d11p-13, 0x1.8e445e9e45da5p-14, -0x1.6da96913a1ea7p-15,
     0x1.5827dc9d31d3ap-16, -0x1.4addac11dc66cp-17, 0x1.421d7fcc60eebp-18},
     /* [214] 1.75 <= y <= 1.875 2^-14, degree 10, 64.5 bits */
    {0x1.a9202912f6bdap-1, -0x1.fd94b282029f1p-55, -0x1.015fd82f5499fp-6, 0x1.bf2a0689b2b96p-9, -0x1.19f34bf572d04p-10,
     0x1.9bb2e03983bbp-12, -0x1.454a38924fe41p-13, 0x1.0e11717d620f3p-14, -0x1.cff281a768313p-16, 0x1.9881e5fc185a4p-17,
     -0x1.6f4d2c0f8b44p-18, 0x1.4e86a06cbd15bp-19}, /* [215] 1.875 <= y <= 2 2^-14, degree 10, 62.9 bits */
    {0x1.a7acf30d8ef13p-1, 0x1.06db65bfdde2cp-56, -0x1.dc3bd7de1fd4ep-6, 0x1.7985793d5b8cfp-7, -0x1.b234ecc0a0234p-8,
     0x1.21178e98369dfp-8, -0x1.a093b4053a4a1p-9, 0x1.3b5f1de83a112p-9, -0x1.ee003c0c5fbdcp-10, 0x1.8c9d66c7cb055p-10,
     -0x1.46b89ff33f3f9p-10, 0x1.0f5a24eedf6d1p-10}, /* [216] 1 <= y <= 1.125 2^-13, degree 10, 62.1 bits */
    {0x1.a5e6be81f6001p-1, 0x1.0f727a2e2c1b1p-55, -0x1.b19fd8e52c291p-6, 0x1.33e0ea4f961f6p-7, -0x1.3cf466aaf15fcp-8,
     0x1.79b61c6a27569p-9, -0x1.e70f5410247cbp-10, 0x1.49f4c2a5f76abp-10, -0x1.ce7cc8b1bc55dp-11, 0x1.4c410c813aa37p-11,
     -0x1.e9256e989e3f2p-12, 0x1.6b7f658122bfbp-12}, /* [217] 1.125 <= y <= 1.25 2^-13, degree 10, 62.5 bits */
    {0x1.a447359d8f4d5p-1, 0x1.790b004622237p-57, -0x1.8e84ce0d93df8p-6, 0x1.003f60d4311a7p-7, -0x1.dd86268ec5f8cp-9,
     0x1.017c377eb1be6p-9, -0x1.2c730265a402fp-10, 0x1.7058a29796043p-11, -0x1.d32b094775d32p-12, 0x1.2facc7f8fcda9p-12,
     -0x1.941da98acc709p-13, 0x1.0fb77841a35b3p-13}, /* [218] 1.25 <= y <= 1.375 2^-13, degree 10, 62.6 bits */
    {0x1.a2c7d50321987p-1, -0x1.c5d8a68b66116p-55, -0x1.710e2bed37aa8p-6, 0x1.b1b6b5642bd36p-8, -0x1.71192334176bap-9,
     0x1.6b7fd27bb7c09p-10, -0x1.8352431e2274bp-11, 0x1.b19a283fa00afp-12, -0x1.f626f8a3089dep-13,
     0x1.2a0d2e20d7bbap-13, -0x1.69e4938fcb136p-14, 0x1.bc59c016eb376p-15},
     /* [219] 1.375 <= y <= 1.5 2^-13, degree 10, 62.7 bits */
    {0x1.a163a6a74669ep-1, -0x1.9b082da370469p-55, -0x1.57f273a665721p-6, 0x1.742bfaae72333p-8, -0x1.2379bab912fbp-9,
     0x1.0823071c2b7cbp-10, -0x1.02f69ab77628cp-11, 0x1.0abd3111d25b6p-12, -0x1.1c37bda13f034p-13,
     0x1.366bde8b2688fp-14, -0x1.5a9416a18316fp-15, 0x1.8784072ec0449p-16},
     /* [220] 1.5 <= y <= 1.625 2^-13, degree 10, 64.5 bits */
    {0x1.a016cb9e05e68p-1, 0x1.eafe52d63da3dp-55, -0x1.42463f328474bp-6, 0x1.43226aebb0a6ap-8, -0x1.d4c8654172444p-10,
     0x1.896965826ca86p-11, -0x1.652d34a2910c1p-12, 0x1.54add9f873189p-13, -0x1.502333352e9b6p-14,
     0x1.53f3ec1429685p-15, -0x1.5f4b29a0b505dp-16, 0x1.6f755893d5de6p-17},
     /* [221] 1.625 <= y <= 1.75 2^-13, degree 10, 63.9 bits */
    {0x1.9ede2f116f644p-1, 0x1.3a356c16fe47cp-55, -0x1.2f5cb8e63608fp-6, 0x1.1b656f294c85cp-8, -0x1.7ee1aebd80fb3p-10,
     0x1.2b35656059b6fp-11, -0x1.f9e2d76602175p-13, 0x1.c14795ea5a5c6p-14, -0x1.9cbeedccaa618p-15,
     0x1.84a9d6004b246p-16, -0x1.75d01c03d070cp-17, 0x1.6c0f1d602b043p-18},
     /* [222] 1.75 <= y <= 1.875 2^-13, degree 10, 63.0 bits */
    {0x1.9db7523c81d88p-1, -0x1.4a6a02c534b0ep-58, -0x1.1eb400512a87bp-6, 0x1.f571e582ea07bp-9, -0x1.3cf6be0ba2472p-10,
     0x1.cf8014511120fp-12, -0x1.6e96d70a10454p-13, 0x1.3096b1b7a979ep-14, -0x1.05c8b2583e4adp-15,
     0x1.cd3c403d9a0fbp-17, -0x1.9ee362888c3ebp-18, 0x1.7a017af06382ap-19},
     /* [223] 1.875 <= y <= 2 2^-13, degree 10, 62.9 bits */
    {0x1.9c19eadef75f8p-1, 0x1.a60c3ef8cf082p-60, -0x1.091ccc3b64223p-5, 0x1.a72b1365a0a09p-7, -0x1.e7f0ab87c335ep-8,
     0x1.4559792893c1cp-8, -0x1.d54e1e84b5f5ap-9, 0x1.6390c0af7fbe1p-9, -0x1.16a71bc5a792dp-9, 0x1.bfab2611cea57p-10,
     -0x1.70f0921cb6ccep-10, 0x1.3287e893b44a3p-10}, /* [224] 1 <= y <= 1.125 2^-12, degree 10, 61.4 bits */
    {0x1.9a20615898575p-1, 0x1.fb87b9ae6eb2bp-56, -0x1.e279d1b3081ffp-6, 0x1.58ecc5686f4dfp-7, -0x1.640291183c381p-8,
     0x1.a8e542222de4p-9, -0x1.123d3f62bb926p-9, 0x1.73dbafdfa66a9p-10, -0x1.04c64a2ccb71cp-10, 0x1.76e14776c02b3p-11,
     -0x1.1412cf3c5efa7p-11, 0x1.9a78ecf1d510bp-12}, /* [225] 1.125 <= y <= 1.25 2^-12, degree 10, 62.7 bits */
    {0x1.98522ae5429a4p-1, 0x1.5349295fdcad7p-55, -0x1.bb27c0c66c9bbp-6, 0x1.1ef1aa93453a1p-7, -0x1.0c10fcc3c05d9p-8,
     0x1.21887e7671cb6p-9, -0x1.52349a8a418afp-10, 0x1.9ef825f1fbc45p-11, -0x1.0751aa17d8bdp-11, 0x1.5683adfb37914p-12,
     -0x1.c8023af91a682p-13, 0x1.32ba4c5ac3f0ap-13}, /* [226] 1.25 <= y <= 1.375 2^-12, degree 10, 62.9 bits */
    {0x1.96a7f70c84544p-1, 0x1.cd55347d8dfa5p-56, -0x1.9a2b68e1d27a9p-6, 0x1.e5745c97fb095p-8, -0x1.9e3bc373fceecp-9,
     0x1.9896cd66e526cp-10, -0x1.b3d6b343e96dbp-11, 0x1.e8512c6fe58bbp-12, -0x1.1af18d0a9b9cfp-12,
     0x1.501014f5d903cp-13, -0x1.983c07568c807p-14, 0x1.f57341b4f2f76p-15},
     /* [227] 1.375 <= y <= 1.5 2^-12, degree 10, 62.7 bits */
    {0x1.951c3421abb81p-1, -0x1.7d7034a3e74ep-55, -0x1.7e12570f1d57p-6, 0x1.a066439711af5p-8, -0x1.46ff2bcaaa647p-9,
     0x1.28cc32197544cp-10, -0x1.234e18ec2f9e1p-11, 0x1.2c4d444252075p-12, -0x1.40313b512d981p-13,
     0x1.5de797c1d5ad2p-14, -0x1.86d7fc19a969dp-15, 0x1.b9b2ccbaa187dp-16},
     /* [228] 1.5 <= y <= 1.625 2^-12, degree 10, 63.8 bits */
    {0x1.93aa8a3aaa7cfp-1, -0x1.0d7e82ba2fa0dp-56, -0x1.65d3fc15677a6p-6, 0x1.69653b240a482p-8, -0x1.06dd3dda321fp-9,
     0x1.b9e9b5a52c7c9p-11, -0x1.91a8b02be671p-12, 0x1.7f6e34154fd73p-13, -0x1.7a92e2456a6edp-14, 0x1.7f1580110e1dbp-15,
     -0x1.8c0d34710db13p-16, 0x1.9e7204ffbf10ap-17}, /* [229] 1.625 <= y <= 1.75 2^-12, degree 10, 63.2 bits */
    {0x1.924f8482b0a6ep-1, 0x1.cfac7bbe7b836p-55, -0x1.50ae2a2ef65cfp-6, 0x1.3cd64e976fd1ap-8, -0x1.ad40573e2b0d2p-10,
     0x1.4ffe1e4b78c4p-11, -0x1.1c5c606d11eb9p-12, 0x1.f98432d490a61p-14, -0x1.d0b9fd6961519p-15, 0x1.b5dbb010805bdp-16,
     -0x1.a5549958f43f9p-17, 0x1.9a81bf7e45d79p-18}, /* [230] 1.75 <= y <= 1.875 2^-12, degree 10, 62.7 bits */
    {0x1.910856b77e28ep-1, 0x1.75f2da738e21cp-58, -0x1.3e0f02e34f881p-6, 0x1.18363e36504dfp-8, -0x1.633d7eb8517e7p-10,
     0x1.042a530cc0f35p-11, -0x1.9c0235d7928efp-13, 0x1.569f73f327a5dp-14, -0x1.26ad31eacf9b6p-15,
     0x1.03be1875de7b6p-16, -0x1.d3831ac8f9554p-18, 0x1.aa215f29f36efp-19},
     /* [231] 1.875 <= y <= 2 2^-12, degree 10, 63.7 bits */
    {0x1.8f3ddb71210f5p-1, -0x1.3e0a8382da275p-60, -0x1.25ef2c0ba2635p-5, 0x1.d8b688475234p-7, -0x1.11500348f6a5ep-7,
     0x1.6d177b534f247p-8, -0x1.079f66222b766p-8, 0x1.8fd0afc809754p-9, -0x1.398d08b4f49f8p-9, 0x1.f806d558befc3p-10,
     -0x1.9f97fab8e61e6p-10, 0x1.5970b6333fb85p-10}, /* [232] 1 <= y <= 1.125 2^-11, degree 10, 61.3 bits */
    {0x1.8d0d8fc105df4p-1, 0x1.39f77d938a7ebp-55, -0x1.0b45acd33cd21p-5, 0x1.8114f09258008p-7, -0x1.8e9d4e2979863p-8,
     0x1.dc8efc284410ap-9, -0x1.33f30ea084452p-9, 0x1.a1f173307eb97p-10, -0x1.254d8b3eb2448p-10, 0x1.a5e43c1d52e2fp-11,
     -0x1.36da20d792d07p-11, 0x1.ce621d6ace86p-12}, /* [233] 1.125 <= y <= 1.25 2^-11, degree 10, 61.8 bits */
    {0x1.8b0da2aa2d9eap-1, 0x1.286f9570953a1p-55, -0x1.eaa85ae0b0ccbp-6, 0x1.402d778d44d9ep-7, -0x1.2bffd10a0bc39p-8,
     0x1.449692d46d404p-9, -0x1.7b9cb23f9e375p-10, 0x1.d2334b1cf941fp-11, -0x1.280b2bb87b3b8p-11, 0x1.81505148a781dp-12,
     -0x1.00a09f636f74cp-12, 0x1.5962ff50d5e07p-13}, /* [234] 1.25 <= y <= 1.375 2^-11, degree 10, 63.4 bits */
    {0x1.8935e40fc0ccp-1, -0x1.97bb0a8111208p-55, -0x1.c5dc4fc9ddadep-6, 0x1.0eb459e91b0e4p-7, -0x1.cf5e40d1d00f5p-9,
     0x1.c9dd295004383p-10, -0x1.e9000e6da2772p-11, 0x1.1231d4f089d55p-11, -0x1.3dfc9d67f59f4p-12,
     0x1.79eab6f266639p-13, -0x1.cb5156866680dp-14, 0x1.1a39e5851a536p-14},
     /* [235] 1.375 <= y <= 1.5 2^-11, degree 10, 64.0 bits */
    {0x1.878018c0d9707p-1, -0x1.1f345022fdefdp-55, -0x1.a687fdfa071c5p-6, 0x1.d02dc10d5d50bp-8, -0x1.6da126c349443p-9,
     0x1.4c7584061eb11p-10, -0x1.46b6b53b73321p-11, 0x1.511f3dce698fp-12, -0x1.67b8dd8646c3p-13, 0x1.895901cb125d3p-14,
     -0x1.b79a73f0d3f7cp-15, 0x1.f107b406b5195p-16}, /* [236] 1.5 <= y <= 1.625 2^-11, degree 10, 62.9 bits */
    {0x1.85e7652a85d3ap-1, 0x1.9f45637b1ae63p-55, -0x1.8b82fb1595113p-6, 0x1.92b028dd17ea1p-8, -0x1.25cdd1f46c87dp-9,
     0x1.eed3b74e7ec0dp-11, -0x1.c2526fba7545bp-12, 0x1.ae4befa2eee79p-13, -0x1.a92bbcaac277dp-14,
     0x1.ae82165460e51p-15, -0x1.bd52304e94afcp-16, 0x1.d2383aab01867p-17},
     /* [237] 1.625 <= y <= 1.75 2^-11, degree 10, 63.0 bits */
    {0x1.8467ec1adda5p-1, -0x1.06b9cd9c88582p-55, -0x1.73f3cd4d0ab92p-6, 0x1.60e4ecd43897bp-8, -0x1.df98d300b77f6p-10,
     0x1.7817bec068f1ep-11, -0x1.3eb4e2a8fc099p-12, 0x1.1b8fc433f5f9dp-13, -0x1.04e203f342916p-14,
     0x1.ebea169940b5cp-16, -0x1.d99acb810dfep-17, 0x1.cda7ca02f7411p-18},
     /* [238] 1.75 <= y <= 1.875 2^-11, degree 10, 63.8 bits */
    {0x1.82fe8d23a4e4ep-1, 0x1.1bd08c3461f8ap-56, -0x1.5f37251a7b922p-6, 0x1.37faf7bfe03d6p-8, -0x1.8cc415d36d103p-10,
     0x1.231e9e80776bbp-11, -0x1.cda074c714fdbp-13, 0x1.8042f775aecc3p-14, -0x1.4abf4a7f0d372p-15,
     0x1.23b9db2024f1ap-16, -0x1.06af450b7436ap-17, 0x1.df183517d0804p-19},
     /* [239] 1.875 <= y <= 2 2^-11, degree 10, 65.6 bits */
    {0x1.810470bc986bbp-1, -0x1.c0d6998172104p-56, -0x1.445cf7e9ae1fap-5, 0x1.07029c8ebe407p-6, -0x1.311c601a89e7p-7,
     0x1.9857468f9ff7cp-8, -0x1.273d7fb1c97a7p-8, 0x1.c036b4a0c73cp-9, -0x1.5fc96f0e804a9p-9, 0x1.1aee716047662p-9,
     -0x1.d2d834ee7dec2p-10, 0x1.843a51a644bf2p-10}, /* [240] 1 <= y <= 1.125 2^-10, degree 10, 61.7 bits */
    {0x1.7e9a63bb998b7p-1, 0x1.f5bb050268679p-55, -0x1.26b43e67ce378p-5, 0x1.ac38e7150b9cbp-7, -0x1.bcb8cf5093c06p-8,
     0x1.0a5ad5ccf8456p-8, -0x1.58b2513c21ddbp-9, 0x1.d44aaa844ca5ep-10, -0x1.48e73e4ccec44p-10, 0x1.d96af411be9f8p-11,
     -0x1.5d04947b1cbf7p-11, 0x1.03b489098c1bdp-11}, /* [241] 1.125 <= y <= 1.25 2^-10, degree 10, 62.6 bits */
    {0x1.7c6620e43429dp-1, 0x1.27de84ef9ad17p-57, -0x1.0e4f4aa71b709p-5, 0x1.63d47e966b79bp-7, -0x1.4e83b718e7d14p-8,
     0x1.6aa4f396259ep-9, -0x1.a8b3153629929p-10, 0x1.050e612bb6345p-10, -0x1.4bd29d02ddd4cp-11, 0x1.b02d6ac384b27p-12,
     -0x1.20021ed6b27e5p-12, 0x1.83d0fc69d9edfp-13}, /* [242] 1.25 <= y <= 1.375 2^-10, degree 10, 62.1 bits */
    {0x1.7a5e8632f06eap-1, 0x1.cdfaf3dec2164p-56, -0x1.f3bc7fb2ad1e6p-6, 0x1.2cadc01a90fdcp-7, -0x1.02350f63c65e4p-8,
     0x1.ff4cbd580f6bp-10, -0x1.116a13275dab9p-10, 0x1.32f17afae770fp-11, -0x1.6443d45620892p-12, 0x1.a7b42e2d0cedbp-13,
     -0x1.01a2f854bc307p-13, 0x1.3cc51638ccb38p-14}, /* [243] 1.375 <= y <= 1.5 2^-10, degree 10, 64.9 bits */
    {0x1.787ca1550f507p-1, -0x1.2557c9bc358bep-55, -0x1.d0f26a3850fa6p-6, 0x1.01a723ea98e7ep-7, -0x1.974ae1714a1d6p-9,
     0x1.7317cf0ad68fbp-10, -0x1.6d31b7d15d2d8p-11, 0x1.793b21656315bp-12, -0x1.92dd02169b34ep-13,
     0x1.b8d52a94668e6p-14, -0x1.ecf8305fe045fp-15, 0x1.16d42261d4ac5p-15},
     /* [244] 1.5 <= y <= 1.625 2^-10, degree 10, 64.0 bits */
    {0x1.76bb08a4d7d86p-1, -0x1.ec84a8a39cd4fp-55, -0x1.b2f562704f502p-6, 0x1.bed2c34b4d1ccp-8, -0x1.4722f4b63da4bp-9,
     0x1.140c7ea003dep-10, -0x1.f728e107fca29p-12, 0x1.e14e24db743a4p-13, -0x1.dbfbb09d1aa85p-14, 0x1.e24dae54062d4p-15,
     -0x1.f33411a7692afp-16, 0x1.0573fa4c25afap-16}, /* [245] 1.625 <= y <= 1.75 2^-10, degree 10, 62.5 bits */
    {0x1.75156e70b6931p-1, -0x1.f401c314e0b76p-56, -0x1.98d2b3f7611a7p-6, 0x1.87643d61dc196p-8, -0x1.0ae458fb4c41cp-9,
     0x1.a374a7ec97836p-11, -0x1.63f7a099523bfp-12, 0x1.3d0f89e0f9664p-13, -0x1.23f552e4d6395p-14,
     0x1.1374510792014p-15, -0x1.095d99e112134p-16, 0x1.02cef5b59052p-17},
     /* [246] 1.75 <= y <= 1.875 2^-10, degree 10, 62.8 bits */
    {0x1.738857a601cafp-1, 0x1.1cdaa9647312fp-56, -0x1.81d43076fe34cp-6, 0x1.59dd259f6b902p-8, -0x1.b96b573215f3cp-10,
     0x1.449073e50940ep-11, -0x1.01b4e25be99dap-12, 0x1.ad827f51e477ep-14, -0x1.720584f547388p-15,
     0x1.469b36d5a2802p-16, -0x1.2646d2567b338p-17, 0x1.0c806b8cad6e3p-18},
     /* [247] 1.875 <= y <= 2 2^-10, degree 10, 64.0 bits */
    {0x1.715c8e5df1867p-1, 0x1.98cea27d876eep-57, -0x1.6411b6adb0e0bp-5, 0x1.2365ab65bf047p-6, -0x1.534294998778dp-7,
     0x1.c7039845ff065p-8, -0x1.4979b07cb0bd8p-8, 0x1.f4c048eaf1709p-9, -0x1.89602a871db31p-9, 0x1.3c9db5c7c3959p-9,
     -0x1.05614a62d7d31p-9, 0x1.b2f73b6f9ca44p-10}, /* [248] 1 <= y <= 1.125 2^-9, degree 10, 60.8 bits */
    {0x1.6eb6654d6a2f5p-1, 0x1.299ae26e59518p-57, -0x1.433895e07ab6ap-5, 0x1.da15fe0764947p-7, -0x1.ee28e3690d55ap-8,
     0x1.289bcf4cd0e95p-8, -0x1.806e48738ec68p-9, 0x1.056fd03c41348p-9, -0x1.6f937bb42f2cfp-10, 0x1.08be20367960bp-10,
     -0x1.869b78f7c9d87p-11, 0x1.22d096bcfebaap-11}, /* [249] 1.125 <= y <= 1.25 2^-9, degree 10, 61.5 bits */
    {0x1.6c4bc9a75a867p-1, 0x1.eb7d1ed51a49cp-55, -0x1.28391caeff121p-5, 0x1.89aba2da57b8dp-7, -0x1.7377fe63c56bap-8,
     0x1.9399039a62b1fp-9, -0x1.d963d3121c807p-10, 0x1.235368fd38dc4p-10, -0x1.72a4deebe42f3p-11, 0x1.e31d0fcffefabp-12,
     -0x1.422a8e61ffb22p-12, 0x1.b20f1886ed8eep-13}, /* [250] 1.25 <= y <= 1.375 2^-9, degree 10, 63.0 bits */
    {0x1.6a12963215174p-1, -0x1.9b03b72348efcp-55, -0x1.119d5ede5ac45p-5, 0x1.4c7191286ab21p-7, -0x1.1e90ee4719ba1p-8,
     0x1.1c5da3291ed3ep-9, -0x1.309a288167137p-10, 0x1.565cb39bc48bp-11, -0x1.8dc0adc2a57a2p-12, 0x1.d96acd600032dp-13,
     -0x1.200f1a2818f4dp-13, 0x1.626151a04f91fp-14}, /* [251] 1.375 <= y <= 1.5 2^-9, degree 10, 61.6 bits */
    {0x1.680314a5b0372p-1, 0x1.92619b2560ab4p-58, -0x1.fcc6a39fe3c13p-6, 0x1.1cb46a836b7e8p-7, -0x1.c3c8528fa0a9ep-9,
     0x1.9c913b881860dp-10, -0x1.96a7936e221d4p-11, 0x1.a4907d9f5f2e4p-12, -0x1.c192fd2941c8fp-13,
     0x1.ec56c0bc1300fp-14, -0x1.1378b4f5e2589p-14, 0x1.37cd6ad17d273p-15},
     /* [252] 1.5 <= y <= 1.625 2^-9, degree 10, 63.6 bits */
    {0x1.6617438a17715p-1, 0x1.7a6502b2f1599p-56, -0x1.dba5e01f17064p-6, 0x1.ed770c0536d5bp-8, -0x1.6ab03a68c4d14p-9,
     0x1.32c167829d8dbp-10, -0x1.1803d19eb8233p-11, 0x1.0c2e11ab7e4c8p-12, -0x1.097941424f91fp-13,
     0x1.0d376a6141f34p-14, -0x1.16d7abfc18694p-15, 0x1.2441a372b08f2p-16},
     /* [253] 1.625 <= y <= 1.75 2^-9, degree 10, 63.6 bits */
    {0x1.644a5d1c293ep-1, -0x1.e4b429f84c3b2p-56, -0x1.becaacacc2b36p-6, 0x1.b005fc8f12d41p-8, -0x1.27c1bde5832e9p-9,
     0x1.d1e82e524a6c4p-11, -0x1.8c0845edc6527p-12, 0x1.612edef6a10a8p-13, -0x1.458ae322e2f34p-14,
     0x1.3364537a110b4p-15, -0x1.285732e3769ebp-16, 0x1.21314fa3effc6p-17},
     /* [254] 1.75 <= y <= 1.875 2^-9, degree 10, 62.6 bits */
    {0x1.629885a858899p-1, -0x1.50685cdcc5b45p-56, -0x1.a56aa1016ce36p-6, 0x1.7d9531bfea3c9p-8, -0x1.e8f0efb57def1p-10,
     0x1.685b045716a6p-11, -0x1.1e98ce08b624fp-12, 0x1.de42069f1eabbp-14, -0x1.9c6e297843231p-15, 0x1.6c575147a8ceep-16,
     -0x1.48822ab8a566bp-17, 0x1.2beb1b7fe428dp-18}, /* [255] 1.875 <= y <= 2 2^-9, degree 10, 64.7 bits */
    {0x1.6039b8318a63fp-1, 0x1.31dc5f9a47619p-56, -0x1.849831c60110ep-5, 0x1.41454b611790bp-6, -0x1.778c5baea74efp-7,
     0x1.f8e476a47c6c6p-8, -0x1.6e345ecff7719p-8, 0x1.16a4070707466p-8, -0x1.b63abd5448a05p-9, 0x1.6103c90993b3fp-9,
     -0x1.23a3d49fbbb01p-9, 0x1.e59f780bd0188p-10}, /* [256] 1 <= y <= 1.125 2^-8, degree 10, 61.4 bits */
    {0x1.5d55fb4150dabp-1, 0x1.c20a3634b6d42p-56, -0x1.6064cb617bbc3p-5, 0x1.051ff610ed06fp-6, -0x1.114c5907878dcp-7,
     0x1.48e27a90023dbp-8, -0x1.aafda928b3973p-9, 0x1.22c1ae3b4aad2p-9, -0x1.99391b4e57317p-10, 0x1.26fde105da9f6p-10,
     -0x1.b38ef036261c6p-11, 0x1.447caf6ddafa8p-11}, /* [257] 1.125 <= y <= 1.25 2^-8, degree 10, 62.2 bits */
    {0x1.5ab3d919c491ap-1, -0x1.b1aa079970f4ep-57, -0x1.42aa0a394029fp-5, 0x1.b154d33580fb3p-7, -0x1.9a98f0bd1ea96p-8,
     0x1.bf382d41c0f2dp-9, -0x1.06bb929fe136cp-9, 0x1.43ccae1b9417bp-10, -0x1.9c64cb2721f41p-11, 0x1.0d003d4c0d23ap-11,
     -0x1.67099b03d5167p-12, 0x1.e40c440e924p-13}, /* [258] 1.25 <= y <= 1.375 2^-8, degree 10, 61.5 bits */
    {0x1.584819c51f3f7p-1, 0x1.4cf0055b277ebp-57, -0x1.29c96df737edap-5, 0x1.6dad2e6e9a438p-7, -0x1.3c8bbd7c1822dp-8,
     0x1.3ae861507e131p-9, -0x1.51e97eafd7157p-10, 0x1.7c4f4c461fcaap-11, -0x1.ba502b63f2432p-12, 0x1.077605cbfa16dp-12,
     -0x1.40dbd259a0fe3p-13, 0x1.8afd6e94472ap-14}, /* [259] 1.375 <= y <= 1.5 2^-8, degree 10, 62.3 bits */
    {0x1.560a37a32014bp-1, 0x1.ef5912b749a67p-56, -0x1.14a51aabf6559p-5, 0x1.38f573dd5b316p-7, -0x1.f2bec57653458p-9,
     0x1.c89e4f71546d2p-10, -0x1.c2e0f2c1becb5p-11, 0x1.d2ef35c9601efp-12, -0x1.f3af63e11112bp-13,
     0x1.11dad39f31178p-13, -0x1.32b03d52780ddp-14, 0x1.5b5dfacfff79bp-15},
     /* [260] 1.5 <= y <= 1.625 2^-8, degree 10, 65.3 bits */
    {0x1.53f390d6d2e6bp-1, 0x1.9b6e17d3efd6ep-57, -0x1.0271539afcfe8p-5, 0x1.0f0d078f7eb4cp-7, -0x1.9029da47567a3p-9,
     0x1.5353ea4c28362p-10, -0x1.364efcbab88f5p-11, 0x1.299a1ffeea938p-12, -0x1.26ec582b6368ep-13,
     0x1.2b5ab4882ea32p-14, -0x1.364cc2a90c792p-15, 0x1.457234e331afp-16},
     /* [261] 1.625 <= y <= 1.75 2^-8, degree 10, 61.8 bits */
    {0x1.51fee0f362b95p-1, 0x1.9ac409f926ccp-55, -0x1.e531ae4934954p-6, 0x1.da54477d50983p-8, -0x1.46248c57e50cep-9,
     0x1.018f64b113b07p-10, -0x1.b6aabdeb8a161p-12, 0x1.87bfe0d4a9fc7p-13, -0x1.697e40cbdf8c6p-14,
     0x1.55a754730180fp-15, -0x1.49a1706750409p-16, 0x1.41e626ac0c405p-17},
     /* [262] 1.75 <= y <= 1.875 2^-8, degree 10, 62.5 bits */
    {0x1.5027e679a9627p-1, -0x1.24e4f42775162p-55, -0x1.c95770a35accbp-6, 0x1.a2b8526933955p-8, -0x1.0d73c2d1fc097p-9,
     0x1.8e3b25c89e4fdp-11, -0x1.3d4e7d43ea0b6p-12, 0x1.0920086ef032p-13, -0x1.c9c82ac4dc3c1p-15, 0x1.94c86523e87abp-16,
     -0x1.6d439c57c999fp-17, 0x1.4db48ced9a9afp-18}, /* [263] 1.875 <= y <= 2 2^-8, degree 10, 62.4 bits */
    {0x1.4d95aae49a867p-1, 0x1.97d8f9136defp-55, -0x1.a556ba9e882c1p-5, 0x1.6044799c47881p-6, -0x1.9da2068ef3aa3p-7,
     0x1.16cb67c5f82e9p-7, -0x1.952fd0ab2bbd4p-8, 0x1.34be2423a7596p-8, -0x1.e620cb3de9f37p-9, 0x1.87f8adc78daf5p-9,
     -0x1.44169b8440932p-9, 0x1.0e041d9db10c6p-9}, /* [264] 1 <= y <= 1.125 2^-7, degree 10, 61.0 bits */
    {0x1.4a740aa530163p-1, 0x1.ebbc45085fbe8p-59, -0x1.7da9e039e19a4p-5, 0x1.1e0cb8c416a9bp-6, -0x1.2cc112325ba9dp-7,
     0x1.6aea67be4c06p-8, -0x1.d8136d49e0e02p-9, 0x1.41ecde647ef25p-9, -0x1.c59eb207b387ap-10, 0x1.474fe36253492p-10,
     -0x1.e3ae71d270d6dp-11, 0x1.68987d3a3dbb2p-11}, /* [265] 1.125 <= y <= 1.25 2^-7, degree 10, 62.2 bits */
    {0x1.479a48f0d12ebp-1, 0x1.48806b832aa52p-56, -0x1.5d1c2f2aea1c5p-5, 0x1.da4915630b009p-7, -0x1.c37d753de865ap-8,
     0x1.ed2098f1856dbp-9, -0x1.2244535103e1cp-9, 0x1.6643727c5c9e5p-10, -0x1.c8d428606e2a9p-11, 0x1.2a476752c499fp-11,
     -0x1.8e737fb6c9e0dp-12, 0x1.0cc99b84b864cp-12}, /* [266] 1.25 <= y <= 1.375 2^-7, degree 10, 61.4 bits */
    {0x1.44fc0e5d58d4ep-1, 0x1.a21719888a585p-59, -0x1.41e4665ad87e1p-5, 0x1.8feb402faee69p-7, -0x1.5bd167b115585p-8,
     0x1.5afea40030192p-9, -0x1.75143d4ef4cb8p-10, 0x1.a4854a041ffacp-11, -0x1.e9ab4c124ee66p-12, 0x1.23f5beddaff0dp-12,
     -0x1.63def18ef2549p-13, 0x1.b66a30457d591p-14}, /* [267] 1.375 <= y <= 1.5 2^-7, degree 10, 61.9 bits */
    {0x1.428ffcc695059p-1, 0x1.2a517ab46021ep-56, -0x1.2ac768a3dc642p-5, 0x1.5603233c898d9p-7, -0x1.11d2aacc872c2p-8,
     0x1.f6d2a1d495314p-10, -0x1.f17f496c3cbdbp-11, 0x1.01ffd5a4124a4p-11, -0x1.146ec8a0eff87p-12,
     0x1.2f4eccbe3ceb1p-13, -0x1.53f7abf2da751p-14, 0x1.81593cbad1e6dp-15},
     /* [268] 1.5 <= y <= 1.625 2^-7, degree 10, 62.3 bits */
    {0x1.404ecb21c8f9ap-1, -0x1.d58bfc59a556p-55, -0x1.16e4c64683843p-5, 0x1.280274f0c639cp-7, -0x1.b71ebb873a5aap-9,
     0x1.7570ac1d7b5bdp-10, -0x1.563250fdb639fp-11, 0x1.48b0f25b6c30ap-12, -0x1.4622bc57c1096p-13,
     0x1.4b6034c84940dp-14, -0x1.57cb3ea944aeep-15, 0x1.68d945757f12dp-16},
     /* [269] 1.625 <= y <= 1.75 2^-7, degree 10, 61.2 bits */
    {0x1.3e32b13745a4p-1, 0x1.68007c6bbd14fp-57, -0x1.05982dfbc953ep-5, 0x1.02d5d18a1e248p-7, -0x1.65ae2047752f9p-9,
     0x1.1b4b002672915p-10, -0x1.e37c127a5968p-12, 0x1.b072d44b5bea8p-13, -0x1.8f8c766efd854p-14, 0x1.7a035f6e1a4e7p-15,
     -0x1.6d08e5b71145dp-16, 0x1.64bf1f13b0076p-17}, /* [270] 1.75 <= y <= 1.875 2^-7, degree 10, 62.0 bits */
    {0x1.3c3703c933068p-1, -0x1.4c9a4886a762ep-57, -0x1.ecccf3f5fd762p-6, 0x1.c8b3609a77579p-8, -0x1.2757765e0cd73p-9,
     0x1.b5c9246b8d3fp-11, -0x1.5d8c162d09774p-12, 0x1.2486743ecbccbp-13, -0x1.f9bb79ab84d8fp-15, 0x1.bfa6e7813d655p-16,
     -0x1.944f93fbba6a1p-17, 0x1.71aa550389d7dp-18}, /* [271] 1.875 <= y <= 2 2^-7, degree 10, 63.6 bits */
    {0x1.39721ace310fbp-1, -0x1.d9f87b611eea4p-62, -0x1.c58c775f13a54p-5, 0x1.7fe41fb43cf52p-6, -0x1.c5049f3c78008p-7,
     0x1.3241f866a06dep-7, -0x1.be09b503445f8p-8, 0x1.546a6187f3ec6p-8, -0x1.0c5800dddf61dp-8, 0x1.b1333e2f2b56dp-9,
     -0x1.66819ba8f149fp-9, 0x1.2aed57e3e42f8p-9}, /* [272] 1 <= y <= 1.125 2^-6, degree 10, 60.3 bits */
    {0x1.3613ba8d7ac33p-1, -0x1.92c47f6c63f7ep-58, -0x1.9a5582adb2248p-5, 0x1.3766e366f3c5bp-6, -0x1.4912cb2b7680dp-7,
     0x1.8e4d350c4dd7dp-8, -0x1.039bb4450c1f6p-8, 0x1.62a6863065e85p-9, -0x1.f46316e5655acp-10, 0x1.69732c566f226p-10,
     -0x1.0b5050e52b36dp-10, 0x1.8ee5bc631ae2ap-11}, /* [273] 1.125 <= y <= 1.25 2^-6, degree 10, 61.3 bits */
    {0x1.3303984bab4e6p-1, 0x1.5e8c0f5c4d8d4p-57, -0x1.76e97e3b8d10bp-5, 0x1.01e9a54dc9bb8p-6, -0x1.ed90fcb0c1cfbp-8,
     0x1.0e60f553966ep-8, -0x1.3eff2b5176a92p-9, 0x1.8a608f1e61c63p-10, -0x1.f78c3498b32a7p-11, 0x1.49259a92ea8e2p-11,
     -0x1.b81a57b3a1097p-12, 0x1.2920addad6fb3p-12}, /* [274] 1.25 <= y <= 1.375 2^-6, degree 10, 62.1 bits */
    {0x1.3034346eaa81bp-1, 0x1.dc583a5b083c2p-55, -0x1.5952be7f0a439p-5, 0x1.b28f7754eeecp-7, -0x1.7bec31824c11p-8,
     0x1.7c377e8c23355p-9, -0x1.99b3cb5d87b7dp-10, 0x1.ce9445a5e145ep-11, -0x1.0daf90a4743c7p-11, 0x1.41f49e8b64851p-12,
     -0x1.88cf6b193f844p-13, 0x1.e452e8d77323fp-14}, /* [275] 1.375 <= y <= 1.5 2^-6, degree 10, 61.4 bits */
    {0x1.2d9b5241a7a3cp-1, 0x1.57e1b30585292p-60, -0x1.4037d2b55d7d7p-5, 0x1.7355018e86c67p-7, -0x1.2adef627d5c84p-8,
     0x1.1348dce0f123bp-9, -0x1.10faacf5cb05p-10, 0x1.1b9d58810e868p-11, -0x1.304b669cf7c89p-12, 0x1.4e42240097a8ep-13,
     -0x1.77062b08ef55fp-14, 0x1.a9714ed02735p-15}, /* [276] 1.5 <= y <= 1.625 2^-6, degree 10, 61.1 bits */
    {0x1.2b30fd418fdb6p-1, 0x1.8a8b8b159edeap-55, -0x1.2aa2e112d4147p-5, 0x1.41237c47cb8dap-7, -0x1.def2f99afc8bep-9,
     0x1.98a07080a7ffdp-10, -0x1.7749d9ca0bb68p-11, 0x1.6919b76b4031fp-12, -0x1.66ca42d9b784p-13, 0x1.6cf99ef01228dp-14,
     -0x1.7b069f06cab22p-15, 0x1.8e2aea4a4f5e4p-16}, /* [277] 1.625 <= y <= 1.75 2^-6, degree 10, 62.6 bits */
    {0x1.28eee651b0989p-1, -0x1.848916f4cbb84p-55, -0x1.17e00b0dc65cfp-5, 0x1.189b0a57688ccp-7, -0x1.85dce17ae91eap-9,
     0x1.35ca55b63227ep-10, -0x1.08f5aed0d2247p-11, 0x1.dacf8ff0a1417p-13, -0x1.b74dc93ca32dcp-14,
     0x1.a01c3b78774f4p-15, -0x1.92398896bef67p-16, 0x1.896e6c6438abdp-17},
     /* [278] 1.75 <= y <= 1.875 2^-6, degree 10, 62.0 bits */
    {0x1.26cff62ea527dp-1, 0x1.565145a74d03fp-55, -0x1.076899c57994p-5, 0x1.eec6acc482db4p-8, -0x1.41b68f53db567p-9,
     0x1.de72e21580025p-11, -0x1.7ee65dcf9e79dp-12, 0x1.4100e8c8dc9f5p-13, -0x1.15e095d03aa6bp-14,
     0x1.ec826c4230f55p-16, -0x1.bd461502becf6p-17, 0x1.97792e516a231p-18},
     /* [279] 1.875 <= y <= 2 2^-6, degree 10, 62.5 bits */
    {0x1.23da8aabef6f6p-1, -0x1.15bff433cd19bp-55, -0x1.e450158650156p-5, 0x1.9f7fc29d87125p-6, -0x1.ed08b43bb9172p-7,
     0x1.4e6cc31a6bdc5p-7, -0x1.e834dbce0cfbdp-8, 0x1.754460abc9d24p-8, -0x1.26a9f1e5db5b8p-8, 0x1.dc4262346e878p-9,
     -0x1.8a8c321dbf019p-9, 0x1.4945237d0ffe2p-9}, /* [280] 1 <= y <= 1.125 2^-5, degree 10, 60.7 bits */
    {0x1.20424d0c12c86p-1, 0x1.fdd431c1212c8p-57, -0x1.b5911ce1a9ecap-5, 0x1.50a5cde58caa7p-6, -0x1.65c14f3138b4fp-7,
     0x1.b27d8736500b7p-8, -0x1.1bdf96302d5cap-8, 0x1.8481e2dafa053p-9, -0x1.127af201de51bp-9, 0x1.8d050e5c4557dp-10,
     -0x1.25ed7419f1f95p-10, 0x1.b701dad2568fp-11}, /* [281] 1.125 <= y <= 1.25 2^-5, degree 10, 61.3 bits */
    {0x1.1cfea642e2baap-1, 0x1.92449e9eaf929p-56, -0x1.8f4b164128236p-5, 0x1.16862a36ccd52p-6, -0x1.0c072a78b69a2p-7,
     0x1.26ab543b03666p-8, -0x1.5c800cc921dfp-9, 0x1.afa6e4071250bp-10, -0x1.13fb2015497e2p-10, 0x1.693d738f95167p-11,
     -0x1.e3874de7d896ep-12, 0x1.46beb7f49c4aap-12}, /* [282] 1.25 <= y <= 1.375 2^-5, degree 10, 61.2 bits */
    {0x1.1a00eb1bb50e9p-1, -0x1.3683b4ce41f88p-55, -0x1.6f5af613c9566p-5, 0x1.d4d387c6215fap-7, -0x1.9c40ea5dd7ac2p-8,
     0x1.9e048fe007c85p-9, -0x1.bf397f6434a2ap-10, 0x1.f9e50b228e848p-11, -0x1.2762858766d95p-11, 0x1.61142a0be659bp-12,
     -0x1.af3f57b19380bp-13, 0x1.0a1af8a63ffa4p-13}, /* [283] 1.375 <= y <= 1.5 2^-5, degree 10, 62.8 bits */
    {0x1.173dfe65a78e8p-1, 0x1.6af724c4fd1e5p-55, -0x1.5448650ad7914p-5, 0x1.903ed6a5a3873p-7, -0x1.4407c26f1a71p-8,
     0x1.2b8462439ab88p-9, -0x1.29c0288ce4725p-10, 0x1.35f0f2eeeb2cap-11, -0x1.4d0cda5095938p-12, 0x1.6e4fc968cc73fp-13,
     -0x1.9b6f72ae8ff71p-14, 0x1.d3307caaa86aep-15}, /* [284] 1.5 <= y <= 1.625 2^-5, degree 10, 62.2 bits */
    {0x1.14ad3f21e72e5p-1, -0x1.d8a28a75fc133p-55, -0x1.3d07c533dbf95p-5, 0x1.59d8fd2347479p-7, -0x1.036dbf1faba12p-8,
     0x1.bc4394ca3c4c1p-10, -0x1.990cb1373864ap-11, 0x1.8a5854b10035fp-12, -0x1.886dfe3468d84p-13,
     0x1.8fb59ca07f879p-14, -0x1.9f8e54f8c077ep-15, 0x1.b4f5b0a19e741p-16},
     /* [285] 1.625 <= y <= 1.75 2^-5, degree 10, 61.4 bits */
    {0x1.1247d6dac31fap-1, -0x1.ee9166b5de848p-56, -0x1.28d5729ecf218p-5, 0x1.2df4004f9c8ccp-7, -0x1.a608d5ee48876p-9,
     0x1.509228ea0659ep-10, -0x1.2099b7e0f605cp-11, 0x1.0317ae07ae799p-12, -0x1.e02fc073a6e86p-14,
     0x1.c76d89b1b2003p-15, -0x1.b8b8d519633b2p-16, 0x1.af80f22ce4d0fp-17},
     /* [286] 1.75 <= y <= 1.875 2^-5, degree 10, 61.2 bits */
    {0x1.1008422d0b56fp-1, 0x1.29ac1a6858873p-57, -0x1.171f0217293abp-5, 0x1.0a01b7e2ad9b1p-7, -0x1.5c0467e399887p-9,
     0x1.03bb6fcd7e5bep-10, -0x1.a0cc3f0612964p-12, 0x1.5e1c776884fbcp-13, -0x1.2f8e086e1a269p-14,
     0x1.0d5d66be8ea01p-15, -0x1.e79c5533ee835p-17, 0x1.bea6f8c0dcffdp-18},
     /* [287] 1.875 <= y <= 2 2^-5, degree 10, 62.4 bits */
    {0x1.0ce62856b89fep-1, 0x1.655c98688bb68p-55, -0x1.00480bb0d8904p-4, 0x1.be4b9960eb232p-6, -0x1.0a693a0827cb8p-6,
     0x1.6ac17d657ae04p-7, -0x1.0979dc07ac34fp-7, 0x1.96c2ee2dddc7ep-8, -0x1.419f12347d4e6p-8, 0x1.04434cf406198p-8,
     -0x1.afb791e56cdf3p-9, 0x1.68a59b689d0fp-9}, /* [288] 1 <= y <= 1.125 2^-4, degree 10, 60.2 bits */
    {0x1.0918fb13e926fp-1, -0x1.a98d7697ac8fep-55, -0x1.ce625544e5a0dp-5, 0x1.69213b99a0c51p-6, -0x1.82296f5fafcb4p-7,
     0x1.d6c2fea829841p-8, -0x1.3463f9fc01cebp-8, 0x1.a6ebbac77db46p-9, -0x1.2b484c0625f0cp-9, 0x1.b17bf2732718fp-10,
     -0x1.414cb608421bep-10, 0x1.e05fcbcf69a4dp-11}, /* [289] 1.125 <= y <= 1.25 2^-4, degree 10, 60.7 bits */
    {0x1.05a68ca5eadeap-1, -0x1.5d1c5a829812p-56, -0x1.a559e5c18b834p-5, 0x1.2a6ca1a0e1c76p-6, -0x1.20fe0cbd0be74p-7,
     0x1.3eef892bf1b27p-8, -0x1.7a384e92ec26bp-9, 0x1.d56e7c15b3ffap-10, -0x1.2ca281b2451f4p-10, 0x1.8a0dfdd10b57dp-11,
     -0x1.080a19c006ad7p-11, 0x1.653748665a241p-12}, /* [290] 1.25 <= y <= 1.375 2^-4, degree 10, 60.9 bits */
    {0x1.027f099259265p-1, -0x1.da70eee741d98p-58, -0x1.832651ea1b144p-5, 0x1.f5c5e6d14c86cp-7, -0x1.bc0c6a9694a1bp-8,
     0x1.bfae99ec52872p-9, -0x1.e4ea46d191582p-10, 0x1.12d71081ffb6cp-10, -0x1.417dea2835d69p-11, 0x1.80d303f09830ap-12,
     -0x1.d69665d58b2b6p-13, 0x1.22aec6cafc75ap-13}, /* [291] 1.375 <= y <= 1.5 2^-4, degree 10, 62.5 bits */
    {0x1.ff2ceeed16bf9p-2, 0x1.b5833eef41f93p-61, -0x1.66306d9bedb66p-5, 0x1.abefcdf736ad8p-7, -0x1.5cb148fc7fe6dp-8,
     0x1.4394f8e4d446ep-9, -0x1.429120ca39326p-10, 0x1.507ca1c0b705ap-11, -0x1.6a315bfc7919fp-12, 0x1.8eee6277a64a4p-13,
     -0x1.c09e9f804fcccp-14, 0x1.fdf32932a4914p-15}, /* [292] 1.5 <= y <= 1.625 2^-4, degree 10, 63.3 bits */
    {0x1.f9c717e2ba9d4p-2, -0x1.1d644a6b719b8p-57, -0x1.4d56f3f587566p-5, 0x1.716c775b1aa06p-7, -0x1.16edaff6caaefp-8,
     0x1.df8ed34c6aec4p-10, -0x1.bac9629ec27cdp-11, 0x1.abc975cecae48p-12, -0x1.aa71f8460f12cp-13,
     0x1.b2fb29046fbffp-14, -0x1.c4c8b0ef7500bp-15, 0x1.dc9d10274e73dp-16},
     /* [293] 1.625 <= y <= 1.75 2^-4, degree 10, 61.6 bits */
    {0x1.f4bdd81dbf74fp-2, 0x1.66fd603e39016p-56, -0x1.37c69c33068eep-5, 0x1.423fba684941bp-7, -0x1.c561afb814bccp-9,
     0x1.6b06462cd6237p-10, -0x1.382af8ebac9afp-11, 0x1.18dbfbebabe36p-12, -0x1.04b80b6db26fdp-13,
     0x1.ef45a2fc5d99ap-15, -0x1.dfe0905a93ec9p-16, 0x1.d658e9d9208a3p-17},
     /* [294] 1.75 <= y <= 1.875 2^-4, degree 10, 62.2 bits */
    {0x1.f00555cb61b5ep-2, 0x1.1e267ae8c044dp-56, -0x1.24e166f846f36p-5, 0x1.1ba5b33d93782p-7, -0x1.7593439490d33p-9,
     0x1.17f0721f7212ep-10, -0x1.c283704a0faa2p-12, 0x1.7b43642f6b67fp-13, -0x1.4969429cd471ap-14,
     0x1.24bd22e22bc54p-15, -0x1.094b8bba0883ep-16, 0x1.e68d510788fc3p-18},
     /* [295] 1.875 <= y <= 2 2^-4, degree 10, 60.9 bits */
    {0x1.e973398c58b2p-2, 0x1.623600d9484abp-56, -0x1.0c8a501dc76b5p-4, 0x1.db547dd5a844dp-6, -0x1.1da9e36333f9dp-6,
     0x1.86929c338c0b3p-7, -0x1.1eaa329f82728p-7, 0x1.b834752b33c4dp-8, -0x1.5cb0350a680b9p-8, 0x1.1a964471dd31dp-8,
     -0x1.d559f4cd47af5p-9, 0x1.888505b1599b5p-9}, /* [296] 1 <= y <= 1.125 2^-3, degree 10, 59.4 bits */
    {0x1.e17d81cb0ed64p-2, -0x1.4033a5accabd4p-57, -0x1.e3acd7e15c61dp-5, 0x1.801191f96e7a5p-6, -0x1.9d83eb9a841cbp-7,
     0x1.fa37cb577ec8ap-8, -0x1.4c9938111ef82p-8, 0x1.c926f2826e545p-9, -0x1.4418933adacefp-9, 0x1.d6230dc8aca4fp-10,
     -0x1.5cec233c9e3cap-10, 0x1.052155f640c3ep-10}, /* [297] 1.125 <= y <= 1.25 2^-3, degree 10, 60.3 bits */
    {0x1.da48d1bb82c8ap-2, -0x1.2c2be16f4f59dp-61, -0x1.b8106ab008999p-5, 0x1.3cf609ee11ea7p-6, -0x1.3515badfb0451p-7,
     0x1.568f2279e25f3p-8, -0x1.9774551066c61p-9, 0x1.fae1099917246p-10, -0x1.4537c01caa9b6p-10, 0x1.aaef0462d612p-11,
     -0x1.1e7317f1a0b55p-11, 0x1.83fa4ee2b38b3p-12}, /* [298] 1.25 <= y <= 1.375 2^-3, degree 10, 60.7 bits */
    {0x1.d3b348f79d7f9p-2, 0x1.121774e80ebb1p-57, -0x1.93c28e4e580ap-5, 0x1.0a255acd78b03p-6, -0x1.da62e5ceb6f5cp-8,
     0x1.e053c46f9a2c2p-9, -0x1.04edf7010d6ap-9, 0x1.2877fcce56688p-10, -0x1.5b7148b464b15p-11, 0x1.a089850f8fddfp-12,
     -0x1.fe0d58f48af81p-13, 0x1.3b6d005b68fb1p-13}, /* [299] 1.375 <= y <= 1.5 2^-3, degree 10, 60.9 bits */
    {0x1.cda34b8b1d8e5p-2, 0x1.101cbc2bb0158p-56, -0x1.750e1f0def858p-5, 0x1.c57378a881a2dp-7, -0x1.7420298efe18ap-8,
     0x1.5ad52686ad0edp-9, -0x1.5acf6fbc0e847p-10, 0x1.6aa1676012074p-11, -0x1.87135844ede47p-12, 0x1.af6cf4493d69ap-13,
     -0x1.e5d21ccfda336p-14, 0x1.14716b99af212p-14}, /* [300] 1.5 <= y <= 1.625 2^-3, degree 10, 62.4 bits */
    {0x1.c805020d261edp-2, 0x1.3e48849f0065dp-56, -0x1.5abce11a0e23cp-5, 0x1.87091791a5e0dp-7, -0x1.2961d27181d31p-8,
     0x1.00c4f5e544407p-9, -0x1.dba3e649eb46bp-11, 0x1.cca004b98ebd8p-12, -0x1.cc10355e046e3p-13, 0x1.d60620653f94fp-14,
     -0x1.e9eef5eadaf43p-15, 0x1.022a7d2508c7fp-15}, /* [301] 1.625 <= y <= 1.75 2^-3, degree 10, 61.6 bits */
    {0x1.c2c8bb401f943p-2, -0x1.81ab23ee54629p-56, -0x1.43ec740a1d35p-5, 0x1.54c323259f3e5p-7, -0x1.e2eed494ae891p-9,
     0x1.8468ac5700878p-10, -0x1.4f0c6cf24c4cbp-11, 0x1.2e2c44a392f48p-12, -0x1.190ca789bcf9dp-13,
     0x1.0b60f2183e5c9p-14, -0x1.036d6972b17abp-15, 0x1.fd29b17513716p-17},
     /* [302] 1.75 <= y <= 1.875 2^-3, degree 10, 62.6 bits */
    {0x1.bde1d5eedf10cp-2, 0x1.e6dc989146036p-57, -0x1.2ff3b6b45a7c6p-5, 0x1.2ba974c72c18ep-7, -0x1.8d948167a152fp-9,
     0x1.2b447a86584eap-10, -0x1.e326d190a3f94p-12, 0x1.97bb3eff8ca01p-13, -0x1.62d532a017079p-14,
     0x1.3bd8a6902b8c1p-15, -0x1.1ea3407848103p-16, 0x1.072ab52385403p-17},
     /* [303] 1.875 <= y <= 2 2^-3, degree 10, 61.4 bits */
    {0x1.b7118186affb5p-2, 0x1.56e2dff4bfb8ep-57, -0x1.1641121d2d366p-4, 0x1.f581f0d1469a4p-6, -0x1.2fa67bc2e88ccp-6,
     0x1.a10edb7d24ab2p-7, -0x1.331777f3241afp-7, 0x1.d8bd0f742ec0dp-8, -0x1.773438f6528a3p-8, 0x1.3094a5e079c3p-8,
     -0x1.fa9b2e649c775p-9, 0x1.a832b07f08d77p-9}, /* [304] 1 <= y <= 1.125 2^-2, degree 10, 59.5 bits */
    {0x1.aed41b4239deep-2, 0x1.dcfa3f3f8e954p-58, -0x1.f434c7df5fd1ap-5, 0x1.9491b91a32f03p-6, -0x1.b6e63de336785p-7,
     0x1.0de43ad3a2382p-7, -0x1.63d0a65aff4c2p-8, 0x1.ea4ae210415e3p-9, -0x1.5c4b6d11405ebp-9, 0x1.fa17aae714a36p-10,
     -0x1.7827736bbe1bfp-10, 0x1.19dcf787e7a81p-10}, /* [305] 1.125 <= y <= 1.25 2^-2, degree 10, 60.9 bits */
    {0x1.a7620dacd39a2p-2, 0x1.587baeb54779fp-56, -0x1.c64cea4a201a7p-5, 0x1.4d6391878b1d8p-6, -0x1.479ce05cbf557p-7,
     0x1.6ccd352715538p-8, -0x1.b35af34a43744p-9, 0x1.0f7c33461a568p-9, -0x1.5d17291aed52dp-10, 0x1.cb0ee2a3dcf93p-11,
     -0x1.34752b1bdc959p-11, 0x1.a25183ca1d18dp-12}, /* [306] 1.25 <= y <= 1.375 2^-2, degree 10, 61.3 bits */
    {0x1.a097695816387p-2, -0x1.2ea76c240ff79p-57, -0x1.a023e20a48a2ap-5, 0x1.178f74b592e8p-6, -0x1.f631710954b83p-8,
     0x1.fee80db48c2bdp-9, -0x1.167a5535b09fcp-9, 0x1.3d39c91e112fbp-10, -0x1.748b17cf327ffp-11, 0x1.bf67dbc7aa282p-12,
     -0x1.1255a64b1d64cp-12, 0x1.53bed91ea0da5p-13}, /* [307] 1.375 <= y <= 1.5 2^-2, degree 10, 61.3 bits */
    {0x1.9a590d1734fa9p-2, 0x1.c75e6769ee81cp-56, -0x1.7fe8636b3a995p-5, 0x1.dbb4af94c2f29p-7, -0x1.897ad1014250bp-8,
     0x1.70816433dbd8ap-9, -0x1.71bda64b6ea82p-10, 0x1.839eaa688f97p-11, -0x1.a2e84a755ca2p-12, 0x1.cef1302724ce5p-13,
     -0x1.050ca70c85d42p-13, 0x1.29798acdf989p-14}, /* [308] 1.5 <= y <= 1.625 2^-2, degree 10, 62.4 bits */
    {0x1.9491fa83edf68p-2, -0x1.2f18fcdbedff1p-56, -0x1.6450997a35a2dp-5, 0x1.99be591fb6ffep-7, -0x1.3a1ae695025c9p-8,
     0x1.108857d3d5bdap-9, -0x1.fa95c07406552p-11, 0x1.ebe49ce4ec85cp-12, -0x1.ec5799fff7eb9p-13, 0x1.f7e5a568dcedep-14,
     -0x1.07059f8592bdap-14, 0x1.158f9ef47c04p-15}, /* [309] 1.625 <= y <= 1.75 2^-2, degree 10, 60.6 bits */
    {0x1.8f319be6c0aafp-2, 0x1.048ca3dbf0664p-57, -0x1.4c6c1977c9ee3p-5, 0x1.64ab70ace51fdp-7, -0x1.fd91a6a84ba25p-9,
     0x1.9bda88f380d21p-10, -0x1.648376dddaaacp-11, 0x1.4264997c7dd9bp-12, -0x1.2c80d19279743p-13,
     0x1.1e668f59153fap-14, -0x1.165007ae80489p-15, 0x1.117abb9562033p-16},
     /* [310] 1.75 <= y <= 1.875 2^-2, degree 10, 61.5 bits */
    {0x1.8a2a9bc980396p-2, 0x1.638a35a750291p-57, -0x1.37877358ae734p-5, 0x1.3952aad83d39cp-7, -0x1.a31aa8480b25ep-9,
     0x1.3d0a901fbf9e1p-10, -0x1.00d38295c4c88p-11, 0x1.b2a4cd88b01abp-13, -0x1.7b1406042fb3ep-14,
     0x1.520a8662bcc75p-15, -0x1.3342173081dedp-16, 0x1.1a7af13de226bp-17},
     /* [311] 1.875 <= y <= 2 2^-2, degree 10, 61.2 bits */
    {0x1.8330651c9c725p-2, -0x1.fb955ed359181p-56, -0x1.1caddc124397cp-4, 0x1.05ccfd309d3cfp-5, -0x1.3fa81758dcf3fp-6,
     0x1.b942c1f519173p-7, -0x1.46133f70a2681p-7, 0x1.f756bbeff1acp-8, -0x1.905fbe9bfaba9p-8, 0x1.459cafd898824p-8,
     -0x1.0f39a679056a3p-8, 0x1.c6d576987f2f5p-9}, /* [312] 1 <= y <= 1.125 2^-1, degree 10, 59.3 bits */
    {0x1.7ac4a983fc036p-2, -0x1.f23f827bb4c2bp-56, -0x1.fea09cfa17c27p-5, 0x1.a5a265cb5ea6p-6, -0x1.cd456893e7f66p-7,
     0x1.1d1b1df00c4bep-7, -0x1.793d8be11b5cdp-8, 0x1.04a1f8983cbcfp-8, -0x1.73212dc4e91d5p-9, 0x1.0e2453b76be54p-9,
     -0x1.92375098e8fffp-10, 0x1.2dcfec3060374p-10}, /* [313] 1.125 <= y <= 1.25 2^-1, degree 10, 61.0 bits */
    {0x1.732cde46e52fdp-2, 0x1.ea09bf3e07e59p-57, -0x1.ced2ed24f958dp-5, 0x1.5ae1676033584p-6, -0x1.57ca86d75cf06p-7,
     0x1.80d033e851ea7p-8, -0x1.cceee2de39004p-9, 0x1.203fd275a2d02p-9, -0x1.737e1a992da2bp-10, 0x1.e972627c88c59p-11,
     -0x1.496a73931a2f4p-11, 0x1.bf5f9118de217p-12}, /* [314] 1.25 <= y <= 1.375 2^-1, degree 10, 61.2 bits */
    {0x1.6c434547c5311p-2, 0x1.39f9303f540f4p-56, -0x1.a72626ccae16p-5, 0x1.226e92f4c440ap-6, -0x1.0720e1674e0f4p-7,
     0x1.0d1c15978ed91p-8, -0x1.2676aa86ba26ep-9, 0x1.50660d2b127a4p-10, -0x1.8bf940c5edf0ap-11, 0x1.dc76361a42ecp-12,
     -0x1.24a2b3858eb62p-12, 0x1.6aee20f9a80c7p-13}, /* [315] 1.375 <= y <= 1.5 2^-1, degree 10, 61.8 bits */
    {0x1.65eb6ac94d0ep-2, -0x1.03c1061940caep-57, -0x1.85afbc306d41fp-5, 0x1.ed81c978fd913p-7, -0x1.9bcc95a17ba54p-8,
     0x1.83ba63341985fp-9, -0x1.8680bca937038p-10, 0x1.9a93728a15d87p-11, -0x1.bcc193826ed23p-12, 0x1.ec77e65a736fbp-13,
     -0x1.162a4af372d37p-13, 0x1.3d7085f21ccf4p-14}, /* [316] 1.5 <= y <= 1.625 2^-1, degree 10, 61.0 bits */
    {0x1.600f5212ec911p-2, 0x1.2e4d10c9c7ff3p-58, -0x1.69146415ac3edp-5, 0x1.a883b390d4095p-7, -0x1.485483dbbe91fp-8,
     0x1.1e6b4f9f69823p-9, -0x1.0b384a57e8ccfp-10, 0x1.043bb09495112p-11, -0x1.0516966ccc9eap-12, 0x1.0bbe72ccc9744p-13,
     -0x1.17fc68befe5a4p-14, 0x1.27e5b537ae5ddp-15}, /* [317] 1.625 <= y <= 1.75 2^-1, degree 10, 61.2 bits */
    {0x1.5a9da2259656ep-2, 0x1.c8d8b40a6e4b5p-56, -0x1.505748cd6ff4cp-5, 0x1.71115f5cf3f03p-7, -0x1.0a04f4f32fa34p-8,
     0x1.b05f2083c196dp-10, -0x1.77b9dc90dd2bfp-11, 0x1.54c6e6e051f74p-12, -0x1.3e666dccf1e78p-13, 0x1.3010619b2912p-14,
     -0x1.27fbd9701853bp-15, 0x1.2346b29e515efp-16}, /* [318] 1.75 <= y <= 1.875 2^-1, degree 10, 61.4 bits */
    {0x1.55886cc6ba6d9p-2, 0x1.2ab96a629c1b2p-56, -0x1.3abbec1452a24p-5, 0x1.43d55f08df0aep-7, -0x1.b51d249ad49b9p-9,
     0x1.4c7f1b029d794p-10, -0x1.0e66c19661c61p-11, 0x1.cafe1457dcf1fp-13, -0x1.9148806775454p-14,
     0x1.66908939fe741p-15, -0x1.467a187b5b555p-16, 0x1.2c999aeb2c52bp-17},
     /* [319] 1.875 <= y <= 2 2^-1, degree 10, 60.7 bits */
    {0x1.4e7db7c480e11p-2, -0x1.36ab1f5621875p-56, -0x1.1f01838c38c87p-4, 0x1.0e22f5ebf3fcfp-5, -0x1.4ce3b29a5cce7p-6,
     0x1.ce1c2495f123cp-7, -0x1.56d6ce54864a5p-7, 0x1.096a0522a5ec2p-7, -0x1.a746d4e12458ep-8, 0x1.58f159ce2d8fcp-8,
     -0x1.1fd5ea0e5f937p-8, 0x1.e36c6958c63f1p-9}, /* [320] 1 <= y <= 1.125 2^0, degree 10, 58.8 bits */
    {0x1.46032988f313cp-2, 0x1.a162721113cf3p-57, -0x1.00bc489a8bd52p-4, 0x1.b22de364adacdp-6, -0x1.df7a71e47a55bp-7,
     0x1.2a0df9371b3f2p-7, -0x1.8bf7dd1e257dcp-8, 0x1.126b5e8b9b525p-8, -0x1.87bcade3548a9p-9, 0x1.1dbc4bc702c8cp-9,
     -0x1.aa3292a3a379ep-10, 0x1.404d6c269c48fp-10}, /* [321] 1.125 <= y <= 1.25 2^0, degree 10, 60.6 bits */
    {0x1.3e62de766890ep-2, 0x1.5937c7ee88c0ap-58, -0x1.d04a3ffce31a6p-5, 0x1.6489c7c5775d4p-6, -0x1.64c1894d9e16ep-7,
     0x1.91a56a1d26916p-8, -0x1.e31260c008da4p-9, 0x1.2f0b74169072ap-9, -0x1.878d18b4a91c3p-10, 0x1.027b81bc19ff1p-10,
     -0x1.5c91e6d9e3ffp-11, 0x1.da21684ce340cp-12}, /* [322] 1.25 <= y <= 1.375 2^0, degree 10, 60.7 bits */
    {0x1.3775a24b89fb3p-2, -0x1.801e1a644ae76p-57, -0x1.a78b81ea405fbp-5, 0x1.2a01589a45d13p-6, -0x1.109fcddf06f75p-7,
     0x1.18775073a1eabp-8, -0x1.342b2a3f7f646p-9, 0x1.612de941ef052p-10, -0x1.a0cb956d664fep-11, 0x1.f697451bec5b6p-12,
     -0x1.3540b76adfebfp-12, 0x1.80269597d9c3bp-13}, /* [323] 1.375 <= y <= 1.5 2^0, degree 10, 60.1 bits */
    {0x1.311df3ba3483dp-2, -0x1.846e2fe769463p-60, -0x1.853ca3514d2c5p-5, 0x1.f990a72d2f136p-7, -0x1.aa0a0592ce272p-8,
     0x1.9388dadbafc3p-9, -0x1.982380b7427bcp-10, 0x1.ae8195e263215p-11, -0x1.d38f7a5aa04c4p-12, 0x1.036bf2d9bbfa6p-12,
     -0x1.259c0e5811761p-13, 0x1.4f9b142fc7fc1p-14}, /* [324] 1.5 <= y <= 1.625 2^0, degree 10, 61.2 bits */
    {0x1.2b450ea103d2dp-2, 0x1.08053a789354fp-56, -0x1.67f3e8583a66ep-5, 0x1.b23bed0409d58p-7, -0x1.533892da37d9ap-8,
     0x1.29b65a0d01b15p-9, -0x1.16f1868ac3878p-10, 0x1.108a1eee805adp-11, -0x1.1227ee801bf6fp-12, 0x1.19c33f3c5f0a8p-13,
     -0x1.273399904a81bp-14, 0x1.387cd0708297dp-15}, /* [325] 1.625 <= y <= 1.75 2^0, degree 10, 60.9 bits */
    {0x1.25d9033513ee6p-2, 0x1.97b5e2e245c8ep-56, -0x1.4eaa5158d790ap-5, 0x1.78fbed5428193p-7, -0x1.127db87de1fa2p-8,
     0x1.c0e048edaa45dp-10, -0x1.87c15a095b1d8p-11, 0x1.647de0a0005a2p-12, -0x1.4df8983a5890cp-13,
     0x1.3fa48219f1a97p-14, -0x1.37bdd8a849259p-15, 0x1.334a588f2e11ep-16},
     /* [326] 1.75 <= y <= 1.875 2^0, degree 10, 62.4 bits */
    {0x1.20cb6f0d3a08dp-2, 0x1.4364d368bef51p-56, -0x1.389c0b7cb4274p-5, 0x1.4a5635e63631p-7, -0x1.c27cf6f416889p-9,
     0x1.58cb67b8f1421p-10, -0x1.19a0f4009a21p-11, 0x1.dfa670689bfefp-13, -0x1.a47936d314a4dp-14, 0x1.788e3ebe38782p-15,
     -0x1.5784a0ba0fc87p-16, 0x1.3cd1963d3f79ap-17}, /* [327] 1.875 <= y <= 2 2^0, degree 10, 61.0 bits */
    {0x1.19cf23fd3c968p-2, 0x1.539eeb867a4a1p-57, -0x1.1c59c8ca4758ap-4, 0x1.130adc3c121bap-5, -0x1.567dc3b5e9461p-6,
     0x1.de6f26657590cp-7, -0x1.64869a8af66b5p-7, 0x1.14f28c0272ce7p-7, -0x1.bae09a3c8fedp-8, 0x1.69bd0313384a8p-8,
     -0x1.2e71e37f4cbb6p-8, 0x1.fcd1dd9e6f444p-9}, /* [328] 1 <= y <= 1.125 2^1, degree 10, 58.3 bits */
    {0x1.116c021dbc22ap-2, 0x1.ed5d89fa022e6p-56, -0x1.fb2187f722f9bp-5, 0x1.b90a4a2ef931p-6, -0x1.ec477d49e1eedp-7,
     0x1.33fa4d536349cp-7, -0x1.9b006ef3b525p-8, 0x1.1dd2c4dccd4c7p-8, -0x1.9926e1d9f7dfep-9, 0x1.2b214b6c724e4p-9,
     -0x1.bf11880b6592fp-10, 0x1.509106a9702b5p-10}, /* [329] 1.125 <= y <= 1.25 2^1, degree 10, 59.6 bits */
    {0x1.09e69b9dfd1eap-2, -0x1.9fe9899d9dbbp-57, -0x1.c939a1cfaeb33p-5, 0x1.696660e17dacep-6, -0x1.6d944fe16c684p-7,
     0x1.9e457b2616328p-8, -0x1.f48c736ef5e12p-9, 0x1.3b1cd4ae283d7p-9, -0x1.984b969f21876p-10, 0x1.0e2bcf71e045cp-10,
     -0x1.6d123421a13e4p-11, 0x1.f171e345de244p-12}, /* [330] 1.25 <= y <= 1.375 2^1, degree 10, 60.6 bits */
    {0x1.0316b8aea97f6p-2, 0x1.46800f141b0efp-57, -0x1.9ff6f0137e555p-5, 0x1.2d78834260cfep-6, -0x1.16df2d0f66265p-7,
     0x1.20cd09ca0b2e2p-8, -0x1.3ecf3e80dfb62p-9, 0x1.6eadcc0cad3b6p-10, -0x1.b1f80405b47eap-11, 0x1.06467e568e478p-11,
     -0x1.436d9eeec7a4dp-12, 0x1.9279088dcd6d6p-13}, /* [331] 1.375 <= y <= 1.5 2^1, degree 10, 62.1 bits */
    {0x1.f9bc463fb56bbp-3, -0x1.7ffac0780e25dp-58, -0x1.7d4a056758fe3p-5, 0x1.fe7f5ca43cb5dp-7, -0x1.b31522315857cp-8,
     0x1.9ee215b777927p-9, -0x1.a59b35b4e0df9p-10, 0x1.be5270edea1a2p-11, -0x1.e6260ce9d0ff4p-12, 0x1.0e638c318f9d9p-12,
     -0x1.32a8a04f2d30fp-13, 0x1.5f26f97a58618p-14}, /* [332] 1.5 <= y <= 1.625 2^1, degree 10, 61.0 bits */
    {0x1.ee4b2b21adcecp-3, 0x1.02f867bc770cbp-57, -0x1.5fbea38a8276bp-5, 0x1.b5b510b537e5ap-7, -0x1.59e28e49524e7p-8,
     0x1.31a409199fd3ap-9, -0x1.1fbf9ebdb74c6p-10, 0x1.1a2c80bf7d2b4p-11, -0x1.1caf321d5bb5bp-12, 0x1.254d1eb89293ep-13,
     -0x1.33efee6b78c56p-14, 0x1.469021b663aa2p-15}, /* [333] 1.625 <= y <= 1.75 2^1, degree 10, 60.3 bits */
    {0x1.e3b583ebaee53p-3, 0x1.fbc38e14bacc5p-58, -0x1.46468fea48075p-5, 0x1.7b5fc706a5da8p-7, -0x1.17799608065e4p-8,
     0x1.cc336bb7cc0afp-10, -0x1.9398254634ffbp-11, 0x1.70a10eda263dbp-12, -0x1.5a5f4f53206acp-13,
     0x1.4c55c68633ed7p-14, -0x1.44cf600067537p-15, 0x1.40c336d3bf77bp-16},
     /* [334] 1.75 <= y <= 1.875 2^1, degree 10, 60.1 bits */
    {0x1.d9de000289e6p-3, 0x1.62fc2e7253feap-57, -0x1.3018deca8a05dp-5, 0x1.4be96fe039edep-7, -0x1.ca08aad59f84fp-9,
     0x1.610975d50e4e3p-10, -0x1.21c83be658c8fp-11, 0x1.ef641b2b38b2ap-13, -0x1.b39543fc9337fp-14,
     0x1.87110d127cf7ap-15, -0x1.6585e921cc4e4p-16, 0x1.4a5988634c7a8p-17},
     /* [335] 1.875 <= y <= 2 2^1, degree 10, 60.8 bits */
    {0x1.cc4c44a23fb3dp-3, -0x1.222d7cddc8259p-57, -0x1.13bbfbd7f6524p-4, 0x1.13be8396de3a6p-5, -0x1.5b8d02edf8c0cp-6,
     0x1.e8fb645c2e467p-7, -0x1.6e3669b4fe8c2p-7, 0x1.1d8f01c592898p-7, -0x1.ca0c4d1e4e224p-8, 0x1.771575b53049p-8,
     -0x1.3a4b0e439d351p-8, 0x1.08e05029d17b3p-8}, /* [336] 1 <= y <= 1.125 2^2, degree 10, 58.3 bits */
    {0x1.bc1049db164c1p-3, 0x1.56425e913e39bp-57, -0x1.e9d2c47188114p-5, 0x1.b8f5bb0ffbf2dp-6, -0x1.f25b4f99106f6p-7,
     0x1.3a10e67b9e9bdp-7, -0x1.a545ac964ea15p-8, 0x1.261b7ba4f79cdp-8, -0x1.a6539f9ba209bp-9, 0x1.35908e85d6a2ap-9,
     -0x1.cfb2ea1251b8ep-10, 0x1.5dc23c0d54024p-10}, /* [337] 1.125 <= y <= 1.25 2^2, degree 10, 59.2 bits */
    {0x1.ad8fbd92fa409p-3, 0x1.51512b0e92307p-58, -0x1.b7fcfbeafba7p-5, 0x1.686c06ecf8754p-6, -0x1.714709283a637p-7,
     0x1.a59880ced6c88p-8, -0x1.000748262a516p-8, 0x1.43a30ea875f42p-9, -0x1.a4acc7fa83a24p-10, 0x1.171959e4cdap-10,
     -0x1.79fded1771c22p-11, 0x1.0207a35aceaa4p-11}, /* [338] 1.25 <= y <= 1.375 2^2, degree 10, 60.9 bits */
    {0x1.a0794575f6972p-3, -0x1.abe65fb466b81p-58, -0x1.8ee30c9ac5a19p-5, 0x1.2bf24a1c0cba3p-6, -0x1.191ddf0492dafp-7,
     0x1.25595bf58608ap-8, -0x1.458d0c8360a8bp-9, 0x1.77f1ba6f4443p-10, -0x1.be5fbd128dd6fp-11, 0x1.0e7f62d88a2e8p-11,
     -0x1.4e5623830e1b3p-12, 0x1.a0dff2e9292b6p-13}, /* [339] 1.375 <= y <= 1.5 2^2, degree 10, 61.1 bits */
    {0x1.948fe6767ced8p-3, -0x1.41db9ea36b91cp-57, -0x1.6c6ca09f9c7acp-5, 0x1.faca86da13138p-7, -0x1.b5bf054adb5e2p-8,
     0x1.a4ab9b13c85efp-9, -0x1.adcc1a18d03d7p-10, 0x1.c8dc0e3568e76p-11, -0x1.f342e4a05d556p-12, 0x1.16707a4d48a99p-12,
     -0x1.3c86e90e50d38p-13, 0x1.6b2f196485d1ep-14}, /* [340] 1.5 <= y <= 1.625 2^2, degree 10, 60.7 bits */
    {0x1.89a4bff5c3bbp-3, 0x1.535b2bb73993p-58, -0x1.4f1fe46e00e0bp-5, 0x1.b19e895c788dfp-7, -0x1.5b60655ba6db1p-8,
     0x1.356385f25258bp-9, -0x1.24e04e64a15a1p-10, 0x1.2065e43ff896fp-11, -0x1.23ef009d431d9p-12, 0x1.2d9a1167e1565p-13,
     -0x1.3d66c8a545602p-14, 0x1.5149d32c2caabp-15}, /* [341] 1.625 <= y <= 1.75 2^2, degree 10, 60.4 bits */
    {0x1.7f9303fc46263p-3, -0x1.5fe374a9ea049p-57, -0x1.35eb09d4babedp-5, 0x1.77154487c117p-7, -0x1.1833f07fe28e6p-8,
     0x1.d11cff5fcc177p-10, -0x1.9a2cf7196e285p-11, 0x1.7838ebaf9990fp-12, -0x1.62b383b15903ap-13,
     0x1.5547b9fac175bp-14, -0x1.4e5a0faa626b4p-15, 0x1.4ade971a295e1p-16},
     /* [342] 1.75 <= y <= 1.875 2^2, degree 10, 60.2 bits */
    {0x1.763d474ab0299p-3, -0x1.9fa6249d8a61bp-58, -0x1.2002d15cb6f87p-5, 0x1.4788de934f893p-7, -0x1.ca7c5448175f3p-9,
     0x1.6446645bf2847p-10, -0x1.2617d5f8d5f85p-11, 0x1.f8e993637f367p-13, -0x1.bd79559adb469p-14,
     0x1.9114d9cb8db93p-15, -0x1.6f9153f7a3dd5p-16, 0x1.5457ce0053f76p-17},
     /* [343] 1.875 <= y <= 2 2^2, degree 10, 60.3 bits */
    {0x1.696a1cfe5bc13p-3, -0x1.24c00039ab308p-61, -0x1.040f2899fb21fp-4, 0x1.0f5f9cb063641p-5, -0x1.5b19b422038a2p-6,
     0x1.ec6ecabccf436p-7, -0x1.72ec947542c3p-7, 0x1.227e7576fc94ep-7, -0x1.d3967f1eef3c2p-8, 0x1.800053b1ff6aap-8,
     -0x1.4290a604e3f65p-8, 0x1.106d2d4aba617p-8}, /* [344] 1 <= y <= 1.125 2^3, degree 10, 58.3 bits */
    {0x1.5a249aa754928p-3, -0x1.ae4bc67860222p-57, -0x1.cb8cbb674bbd3p-5, 0x1.b082c5da0e7f3p-6, -0x1.f04ee0d0f6443p-7,
     0x1.3b773637f8d66p-7, -0x1.a9a6f01b17635p-8, 0x1.2a7de73fe929ep-8, -0x1.ae263d5a7803p-9, 0x1.3c3a93a9de4f7p-9,
     -0x1.dae15e77bd633p-10, 0x1.66f83c0fb5e07p-10}, /* [345] 1.125 <= y <= 1.25 2^3, degree 10, 59.5 bits */
    {0x1.4c9216b883ddfp-3, 0x1.bb15e446aa1ap-57, -0x1.9abe9f0f77bffp-5, 0x1.60679bc8087ddp-6, -0x1.6eccc5ae01d5dp-7,
     0x1.a67733ae0cafcp-8, -0x1.021c12be3069p-8, 0x1.47c18ff90cf61p-9, -0x1.ab940637f669fp-10, 0x1.1c88564c62b0cp-10,
     -0x1.8257f2f5db9cap-11, 0x1.0850b833f2cdep-11}, /* [346] 1.25 <= y <= 1.375 2^3, degree 10, 59.3 bits */
    {0x1.4061a370ac6bdp-3, 0x1.b56025d37446ep-58, -0x1.729da8bc988bdp-5, 0x1.2467d563cea26p-6, -0x1.168ce32804e15p-7,
     0x1.254d7f1bd7176p-8, -0x1.47835a58318d7p-9, 0x1.7bf875b49cc73p-10, -0x1.c4d39eb07b621p-11, 0x1.133fae53977abp-11,
     -0x1.55199f151e37ep-12, 0x1.aa44628f4e29fp-13}, /* [347] 1.375 <= y <= 1.5 2^3, degree 10, 60.0 bits */
    {0x1.3556bec9da307p-3, 0x1.13da2796934f5p-57, -0x1.5110e3d1f04dp-5, 0x1.eca9635804d29p-7, -0x1.b0c1b246a6b5dp-8,
     0x1.a3baf8eb21706p-9, -0x1.af8b6d6bdd966p-10, 0x1.cce49b0570fd3p-11, -0x1.f991cb7773f77p-12, 0x1.1ad624683b20bp-12,
     -0x1.4261904b033cap-13, 0x1.72bfae2c53fddp-14}, /* [348] 1.5 <= y <= 1.625 2^3, degree 10, 61.2 bits */
    {0x1.2b430199bf047p-3, 0x1.b99142627c29bp-58, -0x1.349edfa0fbc59p-5, 0x1.a4665f2144d3ap-7, -0x1.56ac6ae2c332p-8,
     0x1.3417e4210389fp-9, -0x1.25870cd141581p-10, 0x1.226f6e85a1eadp-11, -0x1.271fc37e846a2p-12, 0x1.31dd2fb4d8e7cp-13,
     -0x1.42c19a3cfd337p-14, 0x1.57c6dba96c087p-15}, /* [349] 1.625 <= y <= 1.75 2^3, degree 10, 59.9 bits */
    {0x1.22021236f7dd8p-3, 0x1.eb764f789523cp-60, -0x1.1c36a4712fe0cp-5, 0x1.6ab6c60cc5e96p-7, -0x1.13d73852d0ee5p-8,
     0x1.ce4eb7bd2383fp-10, -0x1.9a600423acadcp-11, 0x1.7a4115aad5cd6p-12, -0x1.6601ee4cb9198p-13,
     0x1.5991d3c0104dap-14, -0x1.537b46255a1e7p-15, 0x1.50bd2b0ec78f6p-16},
     /* [350] 1.75 <= y <= 1.875 2^3, degree 10, 61.2 bits */
    {0x1.1976f229cc07p-3, 0x1.6d78607922106p-57, -0x1.070df5c5695b7p-5, 0x1.3bf3551e56cdcp-7, -0x1.c276505f6612dp-9,
     0x1.61806fe144b72p-10, -0x1.25c071719b7fp-11, 0x1.fad81b5ba83f7p-13, -0x1.c0f2ed2c044b2p-14, 0x1.95879914aad47p-15,
     -0x1.74ad159633654p-16, 0x1.59e620dc8a393p-17}, /* [351] 1.875 <= y <= 2 2^3, degree 10, 59.5 bits */
    {0x1.0dc8f278ed891p-3, -0x1.52d1f43da9473p-57, -0x1.d846b58be7fbdp-5, 0x1.04d8acfcf96aap-5, -0x1.54132b771d472p-6,
     0x1.e7617f31577fbp-7, -0x1.71a1c694883f7p-7, 0x1.22f5fdbd54ed1p-7, -0x1.d63bfd425a57p-8, 0x1.83762ac881074p-8,
     -0x1.4666a4f0a4a4bp-8, 0x1.14568e828ab51p-8}, /* [352] 1 <= y <= 1.125 2^4, degree 10, 57.8 bits */
    {0x1.fff0232ab2a47p-4, 0x1.2a70cb89e3ecep-58, -0x1.9e2f205b71b87p-5, 0x1.9dde168c031ecp-6, -0x1.e4925eb1d627dp-7,
     0x1.37438f4b1a0a7p-7, -0x1.a6f32817b395ap-8, 0x1.2a27fd4921286p-8, -0x1.af739815c7484p-9, 0x1.3e453fd5c3e2bp-9,
     -0x1.df577747101d5p-10, 0x1.6b3fa48dc8182p-10}, /* [353] 1.125 <= y <= 1.25 2^4, degree 10, 58.6 bits */
    {0x1.e78f04043145dp-4, -0x1.0e4d9f5ffba3cp-59, -0x1.6f9463d2eb687p-5, 0x1.4fc72051ea003p-6, -0x1.64f63ffff28afp-7,
     0x1.9fa44ae80c558p-8, -0x1.ff93a446350d2p-9, 0x1.468ffecad3859p-9, -0x1.abd6291f06404p-10, 0x1.1db38256bd1d4p-10,
     -0x1.8516430b65827p-11, 0x1.0adf2aba0054ap-11}, /* [354] 1.25 <= y <= 1.375 2^4, degree 10, 58.9 bits */
    {0x1.d1d0b78a27e0bp-4, 0x1.822c07048253dp-61, -0x1.496b97c83c7abp-5, 0x1.1579644b58045p-6, -0x1.0e3fab51ea297p-7,
     0x1.1fca0e0971114p-8, -0x1.43c2d4d04be1p-9, 0x1.79b2994f29736p-10, -0x1.c414e7752894dp-11, 0x1.13c791a683987p-11,
     -0x1.56cc24cadd39ep-12, 0x1.ad813500f1c89p-13}, /* [355] 1.375 <= y <= 1.5 2^4, degree 10, 59.5 bits */
    {0x1.be3fa0648c4aep-4, -0x1.653b33bb91117p-58, -0x1.29a50847582f8p-5, 0x1.d1abbb64852b3p-7, -0x1.a2a365a953193p-8,
     0x1.9acbe56725c3p-9, -0x1.a99ab651d6af8p-10, 0x1.c920653fddc95p-11, -0x1.f7acafa27a37ep-12, 0x1.1ace6ce7650b5p-12,
     -0x1.43589ab779715p-13, 0x1.74d8bc472cec9p-14}, /* [356] 1.5 <= y <= 1.625 2^4, degree 10, 58.8 bits */
    {0x1.ac81d191938f2p-4, 0x1.6e3f2cce29026p-63, -0x1.0ecec0d989e64p-5, 0x1.8bdc4b80d2787p-7, -0x1.4a92efab4ecf1p-8,
     0x1.2ccf9f8048406p-9, -0x1.20d90eb4bda3ep-10, 0x1.1f767e7b9f92ep-11, -0x1.256f295ee2269p-12, 0x1.313f1df4fade4p-13,
     -0x1.431f235c05db9p-14, 0x1.5918ecd5dc2b8p-15}, /* [357] 1.625 <= y <= 1.75 2^4, degree 10, 59.2 bits */
    {0x1.9c510cfa643dap-4, 0x1.101cfd4679203p-58, -0x1.efbbbd12eceabp-6, 0x1.54488a399af72p-7, -0x1.0964809c60cffp-8,
     0x1.c258cb8575ba9p-10, -0x1.92fc4da306d19p-11, 0x1.75a519151788p-12, -0x1.6349d4588dceap-13, 0x1.583f7d8da6d24p-14,
     -0x1.53450682199ep-15, 0x1.51749806adb17p-16}, /* [358] 1.75 <= y <= 1.875 2^4, degree 10, 59.7 bits */
    {0x1.8d7572d5539f3p-4, 0x1.fdcb78f165783p-59, -0x1.c81a3c26ef0fep-6, 0x1.2758e846779bbp-7, -0x1.b049df393aa87p-9,
     0x1.579a2146597ffp-10, -0x1.1fe29bb875bafp-11, 0x1.f3ba5a4634b7cp-13, -0x1.bcbe0f336ee13p-14,
     0x1.9348c0edc0a48p-15, -0x1.73d2bd5cc45e2p-16, 0x1.5a12d19a2c66fp-17},
     /* [359] 1.875 <= y <= 2 2^4, degree 10, 61.1 bits */
    {0x1.794b436ae7a9p-4, 0x1.d5f54f41bf0dcp-58, -0x1.95e88c3ddc8b9p-5, 0x1.e51ec055d9a62p-6, -0x1.4526c2d36d08bp-6,
     0x1.d840d4633d861p-7, -0x1.6938757aeba8ep-7, 0x1.1e1cb7170e54ep-7, -0x1.d0a62ae8171a8p-8, 0x1.806116926105ep-8,
     -0x1.44e5a2909cd45p-8, 0x1.13da3a34e0e44p-8}, /* [360] 1 <= y <= 1.125 2^5, degree 10, 57.6 bits */
    {0x1.61ac92e0e13ebp-4, -0x1.42d5ff4850a55p-58, -0x1.6010b5533d8bp-5, 0x1.7e41933c3748fp-6, -0x1.cd246cca839cep-7,
     0x1.2c6c9bd71ebb4p-7, -0x1.9bdcb985d263dp-8, 0x1.2437e2be4d617p-8, -0x1.a8fd386de6dc8p-9, 0x1.3ac9d4f20423p-9,
     -0x1.dbbe2d6706b59p-10, 0x1.6995a8480525p-10}, /* [361] 1.125 <= y <= 1.25 2^5, degree 10, 57.9 bits */
    {0x1.4d0f20655bbb7p-4, -0x1.3c1adfa18a581p-61, -0x1.352844389324cp-5, 0x1.3419bdd5c50f7p-6, -0x1.523087c462a7cp-7,
     0x1.8fb1deaf1b64ap-8, -0x1.f084f3fd97fffp-9, 0x1.3f12eb3fc173ep-9, -0x1.a43330fd2653dp-10, 0x1.19c9703249a09p-10,
     -0x1.811fd3f66caddp-11, 0x1.08f457e79ffa7p-11}, /* [362] 1.25 <= y <= 1.375 2^5, degree 10, 58.3 bits */
    {0x1.3add05ce69b88p-4, 0x1.9787869408fadp-58, -0x1.124089e086cf2p-5, 0x1.f9f4019ac59edp-7, -0x1.fde19ed307386p-8,
     0x1.13c9229eb74ccp-8, -0x1.394114f72a15p-9, 0x1.6ff8835030b63p-10, -0x1.bacce5846debfp-11, 0x1.0f4a9eada7fb2p-11,
     -0x1.5273bab14f082p-12, 0x1.a9610cae35736p-13}, /* [363] 1.375 <= y <= 1.5 2^5, degree 10, 59.0 bits */
    {0x1.2aa709af8c94bp-4, 0x1.839011153c267p-58, -0x1.eabd92ad8ea18p-6, 0x1.a5e690c2ab24bp-7, -0x1.894a01adf46bdp-8,
     0x1.885b867b21d9ap-9, -0x1.9a942d1918b66p-10, 0x1.bc23a56799eeep-11, -0x1.ec108d3fe7c37p-12, 0x1.15854bc398934p-12,
     -0x1.3e7df1d430a5ap-13, 0x1.706b7094f1185p-14}, /* [364] 1.5 <= y <= 1.625 2^5, degree 10, 59.1 bits */
    {0x1.1c187e3b4a2ap-4, -0x1.1970323e6cee7p-60, -0x1.ba41f283c2346p-6, 0x1.6471f0d45fbd4p-7, -0x1.354e29b54196ap-8,
     0x1.1e65436b836b5p-9, -0x1.15de37c0d41e2p-10, 0x1.16927aeba1272p-11, -0x1.1df89eea9e097p-12, 0x1.2ad85c3972198p-13,
     -0x1.3d8f1e88d3d9ep-14, 0x1.5443358cc6c42p-15}, /* [365] 1.625 <= y <= 1.75 2^5, degree 10, 59.1 bits */
    {0x1.0eef8434de32ep-4, -0x1.97a3b3e737c9ap-59, -0x1.911111bc61ba5p-6, 0x1.308af710fcc3bp-7, -0x1.eead6398c3e14p-9,
     0x1.ab7397ded4968p-10, -0x1.82a011f434035p-11, 0x1.69318c39b5fedp-12, -0x1.59729d471364bp-13,
     0x1.504896f707ff6p-14, -0x1.4cb883e3b2fd9p-15, 0x1.4c0b806cfe164p-16},
     /* [366] 1.75 <= y <= 1.875 2^5, degree 10, 59.8 bits */
    {0x1.02f7eb9490b8bp-4, -0x1.01e35d2ccd4fbp-58, -0x1.6db3cfbe0255bp-6, 0x1.06be01c69004ap-7, -0x1.9152461251a14p-9,
     0x1.452a83afb267p-10, -0x1.137c0358c80f4p-11, 0x1.e1ee418dd34f7p-13, -0x1.af769859c4b82p-14, 0x1.891f403fb18c6p-15,
     -0x1.6be8395e2c633p-16, 0x1.53dbe4e955b35p-17}, /* [367] 1.875 <= y <= 2 2^5, degree 10, 62.2 bits */
    {0x1.e5cece2c1974fp-5, 0x1.caf0132f84458p-63, -0x1.413ddd42f2d37p-5, 0x1.abbd74a921399p-6, -0x1.2c236c203c466p-6,
     0x1.bcfebcf912402p-7, -0x1.58618743521cap-7, 0x1.12fd3b0aa0373p-7, -0x1.c1591fe89dccap-8, 0x1.75915dd07e232p-8,
     -0x1.3d1368339d2b4p-8, 0x1.0e27d4c95e925p-8}, /* [368] 1 <= y <= 1.125 2^6, degree 10, 56.7 bits */
    {0x1.c0b9dbf4ee872p-5, 0x1.1aa12b5184c71p-59, -0x1.12088a5af36fdp-5, 0x1.4d1fe13fbceb9p-6, -0x1.a67dc999eeb1ep-7,
     0x1.198706a16bea4p-7, -0x1.86d3c9e81f0c5p-8, 0x1.17aa8564d0c73p-8, -0x1.995ddcaedd5fbp-9, 0x1.30c99836b8b83p-9,
     -0x1.ce9f7fd53309fp-10, 0x1.60e4ac7f65fbp-10}, /* [369] 1.125 <= y <= 1.25 2^6, degree 10, 58.1 bits */
    {0x1.a0e2471c11c52p-5, 0x1.ece2359fd77c4p-59, -0x1.d9b21a958ca4ep-6, 0x1.096c2b971e3c5p-6, -0x1.338f2d7f3ff8fp-7,
     0x1.7490ccd737041p-8, -0x1.d512ccc41b3bep-9, 0x1.302601947982ep-9, -0x1.934002b518e39p-10, 0x1.0fe096232c467p-10,
     -0x1.753f801f29967p-11, 0x1.01c0b9661b5fdp-11}, /* [370] 1.25 <= y <= 1.375 2^6, degree 10, 58.8 bits */
    {0x1.85363ec71346dp-5, 0x1.979a7b8aa0f0dp-60, -0x1.9de2d51839256p-6, 0x1.aeeef25f203fcp-7, -0x1.cc4cdd27ab72fp-8,
     0x1.ff792b640247p-9, -0x1.26af3eb317999p-9, 0x1.5d6de3c2401ffp-10, -0x1.a772644ec5856p-11, 0x1.04e28fcc5a747p-11,
     -0x1.46faf0d200f54p-12, 0x1.9c9086549e858p-13}, /* [371] 1.375 <= y <= 1.5 2^6, degree 10, 59.8 bits */
    {0x1.6cec18c71563ap-5, 0x1.e9c0165a9fc58p-60, -0x1.6cf491279ae63p-6, 0x1.635207e7efd6ep-7, -0x1.6071b595a1b89p-8,
     0x1.69fbe09707b9ep-9, -0x1.80a9933f1ff9cp-10, 0x1.a43c06126d16dp-11, -0x1.d4fc919e4cd3cp-12, 0x1.0a0989f6fe5b4p-12,
     -0x1.32c6f695f03dbp-13, 0x1.644c54524a4f1p-14}, /* [372] 1.5 <= y <= 1.625 2^6, degree 10, 60.5 bits */
    {0x1.576b6e1b4e559p-5, -0x1.0fa712a1729e6p-60, -0x1.445817e95c043p-6, 0x1.28dea0607ddb3p-7, -0x1.1325a03c8a77ep-8,
     0x1.06e5355f9a19ep-9, -0x1.034c0b80b4722p-10, 0x1.06a9e6c0bc99ep-11, -0x1.0fb05ac8c9df2p-12, 0x1.1d9efff6e1beep-13,
     -0x1.3102105ac52d2p-14, 0x1.482be9c1267e8p-15}, /* [373] 1.625 <= y <= 1.75 2^6, degree 10, 58.6 bits */
    {0x1.443e908a449fcp-5, 0x1.51111107ff12ap-60, -0x1.2238b056240fbp-6, 0x1.f5b9fc627056ap-8, -0x1.b4cd1ee863482p-9,
     0x1.86698a0f92f3fp-10, -0x1.6763e0a765493p-11, 0x1.536d22b55fd12p-12, -0x1.473060a8a56d1p-13,
     0x1.407ae805484c2p-14, -0x1.3eb34a6b4fc34p-15, 0x1.3f69b2a0e65bfp-16},
     /* [374] 1.75 <= y <= 1.875 2^6, degree 10, 61.0 bits */
    {0x1.3308f4b3d6479p-5, -0x1.7e33528d52bffp-60, -0x1.053ebe10976ecp-6, 0x1.ac2bb7d24a363p-8, -0x1.5fbd146e5ec8p-9,
     0x1.2780c6771ae37p-10, -0x1.fe3656170ed62p-12, 0x1.c36af6b1faeaap-13, -0x1.97736aa64ac23p-14,
     0x1.759ced6848f6cp-15, -0x1.5ba934dca0e01p-16, 0x1.461d24709dab1p-17},
     /* [375] 1.875 <= y <= 2 2^6, degree 10, 59.8 bits */
    {0x1.1c4a5f3580085p-5, 0x1.bdd99c2fb93dp-59, -0x1.c29921b4894cdp-6, 0x1.56f58dc78a5c8p-6, -0x1.041c541151a19p-6,
     0x1.9159dc382f2a4p-7, -0x1.3d1eb9dd8fd6dp-7, 0x1.005dfd339cfedp-7, -0x1.a6897d59a719cp-8, 0x1.619f6fe4981acp-8,
     -0x1.2dccb2bfc2b95p-8, 0x1.02509100b8881p-8}, /* [376] 1 <= y <= 1.125 2^7, degree 10, 56.0 bits */
    {0x1.029366802416cp-5, -0x1.0b8a7cca22fa9p-62, -0x1.77a7e80dc076cp-6, 0x1.058b4fa3da996p-6, -0x1.68a04febae562p-7,
     0x1.f6a7f3a7314ccp-8, -0x1.653b61196f841p-8, 0x1.03270b5110e3p-8, -0x1.7ede4c7747277p-9, 0x1.1f12c2eb1dd73p-9,
     -0x1.b64162a85fda7p-10, 0x1.4fe90a47f1b8dp-10}, /* [377] 1.125 <= y <= 1.25 2^7, degree 10, 57.5 bits */
    {0x1.d9f50bff9b33ep-6, 0x1.34ce7ff8e977ap-60, -0x1.3dd6acdeb1e24p-6, 0x1.9858d21874d87p-7, -0x1.02851d0804b79p-7,
     0x1.492175d9ff51fp-8, -0x1.a994234867ec3p-9, 0x1.182f54f0b022dp-9, -0x1.77362bf97c1eep-10, 0x1.fdbae11c8a685p-11,
     -0x1.60031dc4c496ap-11, 0x1.e89e93da093f7p-12}, /* [378] 1.25 <= y <= 1.375 2^7, degree 10, 58.8 bits */
    {0x1.b52f08f60d2b4p-6, -0x1.ae3ef4e7a3e49p-63, -0x1.10454179af034p-6, 0x1.44fb41911646ep-7, -0x1.7cf4a8ec5b39fp-8,
     0x1.bf008eef2b7c6p-9, -0x1.095a3d0a37783p-9, 0x1.400972ed5ad54p-10, -0x1.880e74e5de3afp-11, 0x1.e6ea8f6c4a825p-12,
     -0x1.33122433d38e5p-12, 0x1.8579c93a0b57dp-13}, /* [379] 1.375 <= y <= 1.5 2^7, degree 10, 58.3 bits */
    {0x1.9583f9049a901p-6, -0x1.aa189f9890ae8p-61, -0x1.d76cf09e9e99ap-7, 0x1.06dd91217639p-7, -0x1.1f2ec67cac723p-8,
     0x1.38df1325be3c4p-9, -0x1.57b663ba1608ep-10, 0x1.7eaa9dbb57638p-11, -0x1.b021faf54c6b5p-12, 0x1.ee626b138d993p-13,
     -0x1.1eeebafe0bd5dp-13, 0x1.4f117df25daf2p-14}, /* [380] 1.5 <= y <= 1.625 2^7, degree 10, 58.6 bits */
    {0x1.79f948d668e53p-6, 0x1.a20c6ff9a4c68p-61, -0x1.9be0996c3a2d3p-7, 0x1.af2f3550d03afp-8, -0x1.b97591280eaap-9,
     0x1.c15093bab48d9p-10, -0x1.cbb8692e88df2p-11, 0x1.db94d41c01b4cp-12, -0x1.f2503064f1d82p-13,
     0x1.08479be088f1dp-13, -0x1.1c2ba055d7d52p-14, 0x1.337bc67e5e9cbp-15},
     /* [381] 1.625 <= y <= 1.75 2^7, degree 10, 59.6 bits */
    {0x1.61d07d6f4fe7bp-6, 0x1.5d57937713f82p-61, -0x1.6abf143d5bbcp-7, 0x1.65eb3f34c73e5p-8, -0x1.5901b6df82267p-9,
     0x1.49c379bb04657p-10, -0x1.3bfca8ef9c5fp-11, 0x1.3176d717c032fp-12, -0x1.2aa5bca2ea7aap-13, 0x1.27541b46554ap-14,
     -0x1.27d0fcd3dbe55p-15, 0x1.2a38365cddbbfp-16}, /* [382] 1.75 <= y <= 1.875 2^7, degree 10, 59.9 bits */
    {0x1.4c761e72d29acp-6, 0x1.3d15faa30c27bp-60, -0x1.41c001a03fa0ap-7, 0x1.2c407fbe59fdfp-8, -0x1.11900653942cfp-9,
     0x1.ed4b77828c1fcp-11, -0x1.bccdce38b582p-12, 0x1.93c848bc47d96p-13, -0x1.7229385d8dd3p-14, 0x1.56eb6fb15bd2dp-15,
     -0x1.41875565abff8p-16, 0x1.2f70469b39bdep-17}, /* [383] 1.875 <= y <= 2 2^7, degree 10, 58.6 bits */
    {0x1.30ba7a68e18fbp-6, 0x1.56a098774bc1dp-60, -0x1.0fee4d130497ep-6, 0x1.d564115c3136bp-7, -0x1.8b75237a36f88p-7,
     0x1.48f341ac1876fp-7, -0x1.10d280dcce496p-7, 0x1.c64a3b82211c4p-8, -0x1.7d1f897656dd2p-8, 0x1.42a8e27f0c0e9p-8,
     -0x1.15aab0b5abf1dp-8, 0x1.de60e719f445ap-9}, /* [384] 1 <= y <= 1.125 2^8, degree 10, 55.4 bits */
    {0x1.120dec1b2c5cdp-6, 0x1.eda11dd7afb2dp-62, -0x1.bac6f27bd5f0ap-7, 0x1.5b5465778a61cp-7, -0x1.0a2105c2be346p-7,
     0x1.91e8e526e466bp-8, -0x1.2da7176245d17p-8, 0x1.c513b1ffbf229p-9, -0x1.55ebbbfa3b84cp-9, 0x1.03e0a5877f4a7p-9,
     -0x1.907957b6c79e5p-10, 0x1.351aca4f75859p-10}, /* [385] 1.125 <= y <= 1.25 2^8, degree 10, 56.5 bits */
    {0x1.f1b6b67a9a3dfp-7, -0x1.352dcead67d1dp-63, -0x1.6f03d64c7c61cp-7, 0x1.07ca8b9086673p-7, -0x1.72da9fe5eecfdp-8,
     0x1.00ad18fb0ddb2p-8, -0x1.6063b465abb7bp-9, 0x1.e2ce22933e4a1p-10, -0x1.4b8b685b65cfbp-10, 0x1.c9b3d5f18a724p-11,
     -0x1.3f82134cd9199p-11, 0x1.bef1eef964ee1p-12}, /* [386] 1.25 <= y <= 1.375 2^8, degree 10, 57.2 bits */
    {0x1.c7a012537877p-7, -0x1.61bb4e766c26fp-61, -0x1.34da9ba67bbf9p-7, 0x1.9987538155952p-8, -0x1.09f40897906dcp-8,
     0x1.540b5fb083e39p-9, -0x1.ae96a192e54c7p-10, 0x1.0f816ed88ce7p-10, -0x1.567eb8a183464p-11, 0x1.b17b39ed05df3p-12,
     -0x1.14d1576e83e4ep-12, 0x1.622d0a341843ap-13}, /* [387] 1.375 <= y <= 1.5 2^8, degree 10, 58.1 bits */
    {0x1.a3fa3ce8b4966p-7, -0x1.0ff7569f61b0dp-61, -0x1.074ac0b4578c6p-7, 0x1.43db64bc19ccap-8, -0x1.86dec0e498a85p-9,
     0x1.d0846354f9fd5p-10, -0x1.111f4372ab509p-10, 0x1.3f5e3162bd9e9p-11, -0x1.74e4b74a1e384p-12,
     0x1.b41b004686d5dp-13, -0x1.00d43949d8d34p-13, 0x1.2ee9f7c653609p-14},
     /* [388] 1.5 <= y <= 1.625 2^8, degree 10, 58.0 bits */
    {0x1.856b212b13dp-7, 0x1.72d8670c536d7p-64, -0x1.c5f33b94b4ed7p-8, 0x1.0441452a656bep-8, -0x1.2550e794588b6p-9,
     0x1.45b0eff7a99efp-10, -0x1.65af47d7936bdp-11, 0x1.862d1017d8cb7p-12, -0x1.a8616e368aebbp-13,
     0x1.cda97bcf0e09bp-14, -0x1.f8e356546f683p-15, 0x1.144d6b4c7dd36p-15},
     /* [389] 1.625 <= y <= 1.75 2^8, degree 10, 60.8 bits */
    {0x1.6af22765d00cp-7, -0x1.952e286c4d10ep-61, -0x1.8b2ce0ff2fa48p-8, 0x1.a8331fc0c8b57p-9, -0x1.c0543015861f8p-10,
     0x1.d32d9f01f3ecbp-11, -0x1.e17089125af83p-12, 0x1.ec6bf919993fap-13, -0x1.f59f0953f3e07p-14,
     0x1.fe6f93038a826p-15, -0x1.04abefcd181c5p-15, 0x1.0a493fa619543p-16},
     /* [390] 1.75 <= y <= 1.875 2^8, degree 10, 60.0 bits */
    {0x1.53cd3e1824d9fp-7, 0x1.f8a44edf1522bp-61, -0x1.5afb6982fbcabp-8, 0x1.5e03fdac6a063p-9, -0x1.5c2ddd4d41292p-10,
     0x1.55c89a7e1d086p-11, -0x1.4bd64dc48c56p-12, 0x1.3f9dd1f7e3b12p-13, -0x1.3256b2df14afdp-14, 0x1.24fc087e48761p-15,
     -0x1.18df02cce67dap-16, 0x1.0d207252d036fp-17}, /* [391] 1.875 <= y <= 2 2^8, degree 10, 59.2 bits */
    {0x1.3615f557b653p-7, 0x1.367251869946fp-61, -0x1.218616469c5c8p-7, 0x1.0bb55c6064647p-7, -0x1.e943a779b919bp-8,
     0x1.b9cc7f7e388d5p-8, -0x1.8ac3d6cf64fa8p-8, 0x1.5dd34d441d9b5p-8, -0x1.343553dd1619ap-8, 0x1.0ea325b8dd05bp-8,
     -0x1.de4dae3c24529p-9, 0x1.a3ad2b7eab767p-9}, /* [392] 1 <= y <= 1.125 2^9, degree 10, 54.5 bits */
    {0x1.15a6221a2d758p-7, 0x1.f00ce3fa3cc8fp-61, -0x1.d119e7aa023e9p-8, 0x1.82c2938b6c3bcp-8, -0x1.3e9e62a6ee2ep-8,
     0x1.03d8abbcdd9efp-8, -0x1.a3cbd9cb0dd5p-9, 0x1.50572b67bd183p-9, -0x1.0bc41ae8030ecp-9, 0x1.a879a6b402058p-10,
     -0x1.51a4993dcb7cp-10, 0x1.0aae910e13834p-10}, /* [393] 1.125 <= y <= 1.25 2^9, degree 10, 56.2 bits */
    {0x1.f6a382573bd96p-8, -0x1.42e541f4ae483p-64, -0x1.7d8b864b86e1ep-8, 0x1.2014459316445p-8, -0x1.afd17e33c2879p-9,
     0x1.40eb49027df0dp-9, -0x1.d8fa67f1c4e1dp-10, 0x1.59ddbfa39c4f9p-10, -0x1.f6928636330e7p-11, 0x1.6b55c4c6c1a3dp-11,
     -0x1.071953cfd95c9p-11, 0x1.7a58ba416fd3p-12}, /* [394] 1.25 <= y <= 1.375 2^9, degree 10, 57.0 bits */
    {0x1.cb0f9cf290f8ap-8, -0x1.357b156ad2d37p-62, -0x1.3e85bc2b26ab1p-8, 0x1.b8415536411fp-9, -0x1.2e7df1aa2e1a2p-9,
     0x1.9cc75a62872f8p-10, -0x1.179173fd5d167p-10, 0x1.780702371efb2p-11, -0x1.f69b9c6084bfap-12, 0x1.4e2bc286c1b3p-12,
     -0x1.bc80c138147fbp-13, 0x1.25917b2e4f083p-13}, /* [395] 1.375 <= y <= 1.5 2^9, degree 10, 57.4 bits */
    {0x1.a669bac81170ep-8, 0x1.7de1abbaf61e1p-63, -0x1.0dd9f70624c68p-8, 0x1.57bf6252f3a46p-9, -0x1.b3e12cbdb6b6bp-10,
     0x1.12c4032d71fdep-10, -0x1.583772c3dcb5ep-11, 0x1.ac7dc2fce4135p-12, -0x1.092158883aff3p-12,
     0x1.466c68b55bdb6p-13, -0x1.91ab0948ca951p-14, 0x1.eae2c29859e32p-15},
     /* [396] 1.5 <= y <= 1.625 2^9, degree 10, 59.0 bits */
    {0x1.872b79bf6ac6dp-8, 0x1.c432cad3e28dcp-63, -0x1.cf012f668c1e1p-9, 0x1.11655d8a7ff35p-9, -0x1.41b543945b111p-10,
     0x1.78c595cdadfcep-11, -0x1.b6e0151502e41p-12, 0x1.fc577ac9922f7p-13, -0x1.24cd96efba3d6p-13,
     0x1.4fa589356045fp-14, -0x1.8057b41cad5fep-15, 0x1.b534781e84723p-16},
     /* [397] 1.625 <= y <= 1.75 2^9, degree 10, 59.0 bits */
    {0x1.6c38b93f2e1d3p-8, -0x1.e67354834a758p-65, -0x1.918579e6dc129p-9, 0x1.b9e1842aafc8fp-10, -0x1.e4e9f10bf043bp-11,
     0x1.090a2a318da57p-11, -0x1.20653f6654999p-12, 0x1.38422d38587a3p-13, -0x1.506d0459f9174p-14,
     0x1.68c7e9df2385bp-15, -0x1.825bda9fc4372p-16, 0x1.9b25cce1d45bp-17},
     /* [398] 1.75 <= y <= 1.875 2^9, degree 10, 59.0 bits */
    {0x1.54bde4d6a1de1p-8, 0x1.6e16e52210c18p-63, -0x1.5f7decf8d4056p-9, 0x1.6a1b0fb158858p-10, -0x1.743326b29a377p-11,
     0x1.7d5cea1c0b8e2p-12, -0x1.853ba471adce8p-13, 0x1.8b8d0d94bce42p-14, -0x1.902f192c0d51p-15, 0x1.932025750b8c4p-16,
     -0x1.9575391c688efp-17, 0x1.95603882d2dc7p-18}, /* [399] 1.875 <= y <= 2 2^9, degree 10, 60.3 bits */
    {0x1.36b132b6234ebp-8, -0x1.7fb9248489501p-63, -0x1.2449f372e48afp-8, 0x1.12bb89d1f913ep-8, -0x1.01d1a7a1704bep-8,
     0x1.e2c17506ea8cbp-9, -0x1.c29bc026260e6p-9, 0x1.a3224f2d675eep-9, -0x1.8463a96423c1dp-9, 0x1.668c0c8564e65p-9,
     -0x1.4c835ec918f41p-9, 0x1.30ce13ff8950bp-9}, /* [400] 1 <= y <= 1.125 2^10, degree 10, 54.1 bits */
    {0x1.15ff7bfea166bp-8, 0x1.8349561e045e4p-62, -0x1.d417ca3187d56p-9, 0x1.89e0af0e0080fp-9, -0x1.4b178f2a06f67p-9,
     0x1.15dfb7925c6b1p-9, -0x1.d16c16a6164c9p-10, 0x1.84c361fa2e5a5p-10, -0x1.43c6865e6c74cp-10, 0x1.0cd238ded1ceep-10,
     -0x1.bff79427944bcp-11, 0x1.71a49666ab47ap-11}, /* [401] 1.125 <= y <= 1.25 2^10, degree 10, 55.7 bits */
    {0x1.f70dae3e333e9p-9, -0x1.ee50d90fa1c4fp-63, -0x1.7f39933aa6cfbp-9, 0x1.23d82e9e00d7p-9, -0x1.bc3736ba7a514p-10,
     0x1.51b4fb2ffec01p-10, -0x1.0058a1e377984p-10, 0x1.846c8d6890187p-11, -0x1.259bcc1be82c4p-11,
     0x1.bac6fef6a93a8p-12, -0x1.4ed50c23f146cp-12, 0x1.f64cecc097667p-13},
     /* [402] 1.25 <= y <= 1.375 2^10, degree 10, 56.9 bits */
    {0x1.cb50724106647p-9, 0x1.5ad5e9cf760b9p-66, -0x1.3f7f1265731b3p-9, 0x1.bc639532f92d4p-10, -0x1.34eb2de38a6d1p-10,
     0x1.ad2d68a0822a4p-11, -0x1.29cde728a537ep-11, 0x1.9cb3a489a60f4p-12, -0x1.1d778d77c29acp-12,
     0x1.8a23ff8aa2fc2p-13, -0x1.10c452927348p-13, 0x1.76f5ced5accfp-14},
     /* [403] 1.375 <= y <= 1.5 2^10, degree 10, 57.2 bits */
    {0x1.a6924800c751cp-9, -0x1.3ee88e6c2dfc2p-63, -0x1.0e6e9dfbc9a73p-9, 0x1.5a173d38ac7a3p-10, -0x1.baca65b0d6263p-11,
     0x1.1b1c9e92ca5f5p-11, -0x1.69c101a17f21cp-12, 0x1.cdc139d3ab706p-13, -0x1.264ef480bf64ap-13,
     0x1.7695cd2f65102p-14, -0x1.ddcdd362a6873p-15, 0x1.2ef894da723dcp-15},
     /* [404] 1.5 <= y <= 1.625 2^10, degree 10, 58.7 bits */
    {0x1.8745621ff8b04p-9, -0x1.768db5b8b940fp-63, -0x1.cfb6d7e14943ap-10, 0x1.12c31881d2d14p-10,
     -0x1.458b6f88e5a87p-11, 0x1.81940f7220cc8p-12, -0x1.c86e54fd97a61p-13, 0x1.0df0f9ba6a24cp-13,
     -0x1.3ef90f551cd2bp-14, 0x1.7873be26eb5f3p-15, -0x1.bd2b90d0b52dap-16, 0x1.05ec11262b369p-16},
     /* [405] 1.625 <= y <= 1.75 2^10, degree 10, 60.4 bits */
    {0x1.6c49976ccaf86p-9, -0x1.654cc6b886a74p-64, -0x1.91f6ebe836c94p-10, 0x1.bb839e47526e1p-11,
     -0x1.e94ba9e61baf3p-12, 0x1.0dd5e2579ea8p-12, -0x1.297f837e78cd9p-13, 0x1.47cea1a2bf891p-14,
     -0x1.68ecde79eb479p-15, 0x1.8d02c9c9804a3p-16, -0x1.b57f9babf24bfp-17, 0x1.e016d049733d6p-18},
     /* [406] 1.75 <= y <= 1.875 2^10, degree 10, 58.4 bits */
    {0x1.54c910732b5a7p-9, -0x1.c03b5d689a3f4p-63, -0x1.5fc62b9870f4dp-10, 0x1.6b1a9c35586b2p-11,
     -0x1.76c404d1f65c9p-12, 0x1.82bc47eed725ep-13, -0x1.8ef8fdb8ce1c2p-14, 0x1.9b6b88662bec8p-15,
     -0x1.a8017ad77695dp-16, 0x1.b4a6aa05b5686p-17, -0x1.c26dfded5a88cp-18, 0x1.cef6fa3e5c092p-19},
     /* [407] 1.875 <= y <= 2 2^10, degree 10, 60.0 bits */
    {0x1.36b76412be997p-9, 0x1.83693314c6f54p-63, -0x1.246fe0e6df728p-9, 0x1.133a3f74f19fp-9, -0x1.030484ec5da9cp-9,
     0x1.e779842334a26p-10, -0x1.caa274673b48dp-10, 0x1.af617cb0bc1fcp-10, -0x1.9593947a95cf7p-10,
     0x1.7d20e700a5798p-10, -0x1.6906b8200e858p-10, 0x1.52c87016b08dp-10},
     /* [408] 1 <= y <= 1.125 2^11, degree 10, 53.9 bits */
    {0x1.1602701b50496p-9, 0x1.7d47a06eae042p-65, -0x1.d439a7531e805p-10, 0x1.8a4a4102b97e1p-10, -0x1.4c0574c05f862p-10,
     0x1.17924cad45155p-10, -0x1.d6c4c0f4c3dd4p-11, 0x1.8c4cb130acdc4p-11, -0x1.4d8707e7d5dddp-11,
     0x1.189d1a212f699p-11, -0x1.db45f428491dcp-12, 0x1.8f80e03e73eb9p-12},
     /* [409] 1.125 <= y <= 1.25 2^11, degree 10, 55.5 bits */
    {0x1.f710a0c85c428p-10, 0x1.55717fa6c0b1p-66, -0x1.7f497d5e849b7p-10, 0x1.2406c92777decp-10, -0x1.bcfc038e0e68p-11,
     0x1.53050d9acea2dp-11, -0x1.02464be21fe5fp-11, 0x1.897c5652da3cap-12, -0x1.2bb22fe8f9004p-12,
     0x1.c87050f50ac6fp-13, -0x1.5d76cb03765adp-13, 0x1.09f556648f7b2p-13},
     /* [410] 1.25 <= y <= 1.375 2^11, degree 10, 56.8 bits */
    {0x1.cb51f996df688p-10, -0x1.62e9dfa134362p-64, -0x1.3f86e2df81b0dp-10, 0x1.bc8eced210412p-11,
     -0x1.35412f7a42638p-11, 0x1.ae41a6926400bp-12, -0x1.2b4ac8ab706e8p-12, 0x1.a05c6ce1f166ap-13,
     -0x1.219592d1db544p-13, 0x1.92c5c5dbecb78p-14, -0x1.19619dc95030cp-14, 0x1.8735c69f04b63p-15},
     /* [411] 1.375 <= y <= 1.5 2^11, degree 10, 57.6 bits */
    {0x1.a69319e66116p-10, 0x1.f7d1181d22db2p-64, -0x1.0e729a3940ccap-10, 0x1.5a2c27c8162e7p-11, -0x1.bb1936b4b24efp-12,
     0x1.1b94408e0e1f7p-12, -0x1.6af8474bdcc3ep-13, 0x1.d09272dca313cp-14, -0x1.294a555b7bc92p-14,
     0x1.7c75629113df7p-15, -0x1.e8cb08c20c5adp-16, 0x1.38afdb4355c1ap-16},
     /* [412] 1.5 <= y <= 1.625 2^11, degree 10, 58.4 bits */
    {0x1.8745d61389affp-10, 0x1.4301da4c81c38p-64, -0x1.cfbb0ba64f832p-11, 0x1.12cd9979b8eep-11, -0x1.45b1118b48182p-12,
     0x1.82007ff8ed731p-13, -0x1.c979bb390d77bp-14, 0x1.0f16257bd05b3p-14, -0x1.41439faf42482p-15,
     0x1.7cb65d299326dp-16, -0x1.c4ae2101f14f6p-17, 0x1.0c2d6afc1cbe7p-17},
     /* [413] 1.625 <= y <= 1.75 2^11, degree 10, 59.5 bits */
    {0x1.6c49d92d40becp-10, 0x1.e4ef8d0bb66abp-67, -0x1.91f933f5de81fp-11, 0x1.bb8e84cd48bbdp-12, -0x1.e970ed70240cp-13,
     0x1.0e090851a555fp-13, -0x1.29f78094aa16p-14, 0x1.48c89b41c295bp-15, -0x1.6ac77a1d93b84p-16, 0x1.90474491729adp-17,
     -0x1.baf2f61cabc66p-18, 0x1.e8adfbcae4e25p-19}, /* [414] 1.75 <= y <= 1.875 2^11, degree 10, 58.5 bits */
    {0x1.54c9369e1ed71p-10, 0x1.6c006515e3ec9p-64, -0x1.5fc771186a9bep-11, 0x1.6b206eeb7719ap-12,
     -0x1.76d71239520fcp-13, 0x1.82ee44d0d5495p-14, -0x1.8f68ebc1adf88p-15, 0x1.9c49d69c73b3ep-16,
     -0x1.a9936997e3d5bp-17, 0x1.b7488ef6066d4p-18, -0x1.c699c3f9f912fp-19, 0x1.d53514ddf0424p-20},
     /* [415] 1.875 <= y <= 2 2^11, degree 10, 60.6 bits */
    {0x1.36b7759f5b1b3p-10, -0x1.67f76be622603p-64, -0x1.24706e53e9146p-10, 0x1.133ca22d2fdcfp-10,
     -0x1.030bdd2f434d4p-10, 0x1.e79db698700cbp-11, -0x1.caee70c3217fcp-11, 0x1.afeebd57823ffp-11,
     -0x1.968237a4b1059p-11, 0x1.7e964d2ccc6cdp-11, -0x1.6b35603d3ad45p-11, 0x1.55d1fe70f9034p-11},
     /* [416] 1 <= y <= 1.125 2^12, degree 10, 53.9 bits */
    {0x1.160276bd2d5f6p-10, -0x1.1201bc1b677dbp-66, -0x1.d43a0b26b5032p-11, 0x1.8a4bd28f15918p-11,
     -0x1.4c09f193173a5p-11, 0x1.179c8d65e074cp-11, -0x1.d6ec94df83439p-12, 0x1.8c910fa45cd18p-12,
     -0x1.4df1813c03b8p-12, 0x1.193669b791021p-12, -0x1.dcea395dfd246p-13, 0x1.9199aba47dbb6p-13},
     /* [417] 1.125 <= y <= 1.25 2^12, degree 10, 55.6 bits */
    {0x1.f710a61cc6b57p-11, 0x1.8bbb3a2b20eb6p-68, -0x1.7f49a3137162bp-11, 0x1.2407576c385ccp-11,
     -0x1.bcfefd89b21edp-12, 0x1.530b67f41323ap-12, -0x1.0251cd702634cp-12, 0x1.89a11c22b712bp-13,
     -0x1.2be769cbfab9bp-13, 0x1.c8fe901d7d32dp-14, -0x1.5e2b146e987afp-14, 0x1.0aca814649781p-14},
     /* [418] 1.25 <= y <= 1.375 2^12, degree 10, 57.2 bits */
    {0x1.cb51fbd882dbap-11, -0x1.ac40fceeb1888p-65, -0x1.3f86f1f63b1b6p-11, 0x1.bc8f3a3b79a87p-12,
     -0x1.35423e54d5343p-12, 0x1.ae45e562dbb28p-13, -0x1.2b51ffe804947p-13, 0x1.a07208c15f0cbp-14,
     -0x1.21b2d712a8c83p-14, 0x1.930edc60853a5p-15, -0x1.19b7ebc9edaeep-15, 0x1.87f40f1158e89p-16},
     /* [419] 1.375 <= y <= 1.5 2^12, degree 10, 57.8 bits */
    {0x1.a6931ae63cc37p-11, 0x1.5b5ac137be007p-68, -0x1.0e72a091d766dp-11, 0x1.5a2c529a2a64p-12, -0x1.bb1a03119f654p-13,
     0x1.1b95c3f3285a6p-13, -0x1.6afd21be1e875p-14, 0x1.d0a0246ead9dap-15, -0x1.295bc9024fd4p-15, 0x1.7c9e587e104b6p-16,
     -0x1.e925b91650428p-17, 0x1.390d9fc1cbbd7p-17}, /* [420] 1.5 <= y <= 1.625 2^12, degree 10, 58.3 bits */
    {0x1.8745d68971391p-11, -0x1.3d2b728fa89fdp-66, -0x1.cfbb11398a3d7p-12, 0x1.12cdab607322ap-12,
     -0x1.45b162bbcb56ap-13, 0x1.8201a413dc3ffp-14, -0x1.c97d33169c7efp-15, 0x1.0f1ac71928803p-15,
     -0x1.414ec8dea1521p-16, 0x1.7ccf1a805baa6p-17, -0x1.c4e1bfaafe8dap-18, 0x1.0c5fbaadd3cc4p-18},
     /* [421] 1.625 <= y <= 1.75 2^12, degree 10, 58.9 bits */
    {0x1.6c49d965854e1p-11, 0x1.9e51f8483f9a5p-65, -0x1.91f9368149e44p-12, 0x1.bb8e94688628ep-13,
     -0x1.e97130f23a97bp-14, 0x1.0e097bff29ae2p-14, -0x1.29f8cf196a61ap-15, 0x1.48cbec46bad7cp-16,
     -0x1.6acf10745bd8ap-17, 0x1.905737b94f7a4p-18, -0x1.bb1276cb3bacfp-19, 0x1.e8e81ed066da4p-20},
     /* [422] 1.75 <= y <= 1.875 2^12, degree 10, 58.5 bits */
    {0x1.54c936b9d3226p-11, -0x1.d350c4a34d445p-67, -0x1.5fc7724c0e765p-12, 0x1.6b2075fae2cfbp-13,
     -0x1.76d72f7185277p-14, 0x1.82eea482e47c2p-15, -0x1.8f69f3ec6eb51p-16, 0x1.9c4c55f74bd8ap-17,
     -0x1.a998db0cf81ecp-18, 0x1.b753730f46bfbp-19, -0x1.c6ae34bfdd48fp-20, 0x1.d558ed7d70627p-21},
     /* [423] 1.875 <= y <= 2 2^12, degree 10, 61.5 bits */
    {0x1.36b775a96f869p-11, 0x1.4477e410ec033p-71, -0x1.24706ebd8c52fp-11, 0x1.133ca475e91dp-11, -0x1.030be613676dap-11,
     0x1.e79ded4967e8fp-12, -0x1.caeefe54d0ebcp-12, 0x1.afeffe2d6e53bp-12, -0x1.9684c55ee73ffp-12,
     0x1.7e9b12e175406p-12, -0x1.6b3de1cfbd6a8p-12, 0x1.55dfdf15374ccp-12},
     /* [424] 1 <= y <= 1.125 2^13, degree 10, 53.8 bits */
    {0x1.160276c00604p-11, 0x1.10e8935c605a4p-65, -0x1.d43a0b5e57625p-12, 0x1.8a4bd3adacd06p-12, -0x1.4c09f59f53a7fp-12,
     0x1.179c98f0bbf58p-12, -0x1.d6eccc2db35ccp-13, 0x1.8c91837465ecbp-13, -0x1.4df25af4c792ap-13,
     0x1.1937e0896e9c2p-13, -0x1.dcef01aed611p-14, 0x1.91a0d7555300cp-14},
     /* [425] 1.125 <= y <= 1.25 2^13, degree 10, 55.6 bits */
    {0x1.f710a61e85p-12, 0x1.9a3c4e0a6818cp-66, -0x1.7f49a32370ca1p-12, 0x1.240757b976457p-12, -0x1.bcfeff945c998p-13,
     0x1.530b6d646ef19p-13, -0x1.0251d997b8289p-13, 0x1.89a14b8d04ec1p-14, -0x1.2be7bcb72f8f4p-14, 0x1.c8ff99556a73p-15,
     -0x1.5e2ca51fb276bp-15, 0x1.0accae33cf939p-15}, /* [426] 1.25 <= y <= 1.375 2^13, degree 10, 56.8 bits */
    {0x1.cb51fbd9154e5p-12, -0x1.e894afeaafaccp-66, -0x1.3f86f1fb300c2p-12, 0x1.bc8f3a689a175p-13,
     -0x1.35423ee48f409p-13, 0x1.ae45e832b58c3p-14, -0x1.2b5205ce3788ap-14, 0x1.a0721e54f1ec3p-15,
     -0x1.21b2fa688a5cp-15, 0x1.930f4617c37f3p-16, -0x1.19b880aae36cdp-16, 0x1.87f5916f42b2dp-17},
     /* [427] 1.375 <= y <= 1.5 2^13, degree 10, 58.4 bits */
    {0x1.a6931ae66fc59p-12, 0x1.4e7fdd1e42681p-66, -0x1.0e72a0937ab19p-12, 0x1.5a2c52a84ab5cp-13,
     -0x1.bb1a0366c1d11p-14, 0x1.1b95c4bc9cac4p-14, -0x1.6afd24dbe0f93p-15, 0x1.d0a02f2d52b4ap-16,
     -0x1.295bd994679c7p-16, 0x1.7c9e8720eb9abp-17, -0x1.e926344d0eab9p-18, 0x1.390e35e59f2e3p-18},
     /* [428] 1.5 <= y <= 1.625 2^13, degree 10, 58.3 bits */
    {0x1.8745d68983f08p-12, 0x1.c321f0bf82791p-67, -0x1.cfbb113aaf508p-13, 0x1.12cdab65256a5p-13,
     -0x1.45b162d6afe34p-14, 0x1.8201a48ca6c34p-15, -0x1.c97d34dc1712ap-16, 0x1.0f1ac9fd8f6c5p-16,
     -0x1.414ed14f5e367p-17, 0x1.7ccf30f4825cp-18, -0x1.c4e1f79b8c195p-19, 0x1.0c5ffb0229e93p-19},
     /* [429] 1.625 <= y <= 1.75 2^13, degree 10, 59.5 bits */
    {0x1.6c49d9658c7fp-12, 0x1.a374c16913976p-68, -0x1.91f93681b581dp-13, 0x1.bb8e946bd10e3p-14, -0x1.e9713104355aep-15,
     0x1.0e097c25a0eebp-15, -0x1.29f8cfa2d9b05p-16, 0x1.48cbedf16f89ep-17, -0x1.6acf15135273p-18, 0x1.9057436443a73p-19,
     -0x1.bb129253a35e6p-20, 0x1.e8e85ad47c252p-21}, /* [430] 1.75 <= y <= 1.875 2^13, degree 10, 59.5 bits */
    {0x1.54c936b9d6034p-12, 0x1.18cd9a15a3497p-69, -0x1.5fc7724c37c0dp-13, 0x1.6b2075fc1880fp-14,
     -0x1.76d72f77d6f23p-15, 0x1.82eea49cbc5eap-16, -0x1.8f69f4449a0a6p-17, 0x1.9c4c56fc775d3p-18,
     -0x1.a998ddbf30aefp-19, 0x1.b753798b55172p-20, -0x1.c6ae434c767d1p-21, 0x1.d5590ba86c64ep-22}
     /* [431] 1.875 <= y <= 2 2^13, degree 10, 58.3 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_power_eps_zero_overlap)

/* eps at zero force by x = beta^5, 2^-40 <= x < 2^20: 480 rows of degree 10 in y = beta^5 2^-k, 8 to each octave k = -40 ... 19.
 * Relative error of the approximation: 2^-57.4 at most, proved for the whole cell of each row. */
#define COR_ROWS_POWER_EPS_ZERO_FORCE_FIRST 9.094947017729282e-13
#define COR_ROWS_POWER_EPS_ZERO_FORCE_FIRST_OCTAVE (-40)
#define COR_ROWS_POWER_EPS_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_POWER_EPS_ZERO_FORCE_ROWS 480
#define COR_ROWS_POWER_EPS_ZERO_FORCE_END 1048576.0
COR_ROWS(double, cor_rows_power_eps_zero_force, 480, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.fdabe5499647bp-1, 0x1.66490e4993b65p-55, -0x1.bf91617a226dap-11, 0x1.517868a8b771fp-12, -0x1.7d5282c43c172p-13,
     0x1.f69543a449d0cp-14, -0x1.678f8731e43f9p-14, 0x1.0ec3e6e7840d9p-14, -0x1.a657a40493f8cp-15,
     0x1.51e764bab8a4ap-15, -0x1.1586f7be3b72ep-15, 0x1.cbd11291a85ebp-16},
     /* [0] 1 <= y <= 1.125 2^-40, degree 10, 67.1 bits */
    {0x1.fd9e8676e9e5ap-1, -0x1.5ae7ec20d9ccfp-57, -0x1.996945870a2adp-11, 0x1.1436ce41177ep-12, -0x1.17418464ac444p-13,
     0x1.49518381ae16p-14, -0x1.a59b4dd8de12cp-15, 0x1.1c11d6d5d309ap-15, -0x1.8c74d3be107a4p-16, 0x1.1bce1ed3b9aa7p-16,
     -0x1.a08ce02a183d8p-17, 0x1.34be961ed2e5fp-17}, /* [1] 1.125 <= y <= 1.25 2^-40, degree 10, 69.6 bits */
    {0x1.fd923d2699e4cp-1, -0x1.fd01f8d7f119p-55, -0x1.79dd5691fec19p-11, 0x1.cd512be39cd86p-13, -0x1.a5fb95c840226p-14,
     0x1.c23db40d8bd81p-15, -0x1.04c2cb2ec7db2p-15, 0x1.3decf2f26cd37p-16, -0x1.91737c4c8b9a3p-17,
     0x1.0402fa241f9c5p-17, -0x1.58f0ea013d0c1p-18, 0x1.cea0be69e93f9p-19},
     /* [2] 1.25 <= y <= 1.375 2^-40, degree 10, 68.6 bits */
    {0x1.fd86db613ea84p-1, 0x1.888c84c181e84p-60, -0x1.5f4da01f4cb18p-11, 0x1.879b095034513p-13, -0x1.4711b03f3c916p-14,
     0x1.3ea0b45cbf1b5p-15, -0x1.50fadc3095a22p-16, 0x1.7720cccf7d1fdp-17, -0x1.b07e754f24442p-18,
     0x1.ff85101e32377p-19, -0x1.35910f762d614p-19, 0x1.7b1357c7cb481p-20},
     /* [3] 1.375 <= y <= 1.5 2^-40, degree 10, 68.9 bits */
    {0x1.fd7c3e0974ffbp-1, 0x1.8260b4162d004p-55, -0x1.4899bf8cf5e3dp-11, 0x1.5100d5fa4b3d4p-13, -0x1.02f34031ab7b5p-14,
     0x1.d02c65b36be5fp-16, -0x1.c3a3319c98be9p-17, 0x1.ce8ba75d49378p-18, -0x1.ea9e67fa7a424p-19,
     0x1.0aec25876b32cp-19, -0x1.290fe21f8f05cp-20, 0x1.4ea881fb2ee98p-21},
     /* [4] 1.5 <= y <= 1.625 2^-40, degree 10, 71.1 bits */
    {0x1.fd7249a69596cp-1, 0x1.8218ec525680cp-55, -0x1.34f32892d5838p-11, 0x1.2563020f4446ep-13, -0x1.a17a101e8baadp-15,
     0x1.5a7406ca91216p-16, -0x1.38209df92cf06p-17, 0x1.27fcda9100963p-18, -0x1.22b278d4b7497p-19,
     0x1.24e1184490752p-20, -0x1.2dab9aae034f3p-21, 0x1.3aac3f12c6731p-22},
     /* [5] 1.625 <= y <= 1.75 2^-40, degree 10, 70.5 bits */
    {0x1.fd68e84c1e7ffp-1, -0x1.dbc81872ac948p-55, -0x1.23c1d90130265p-11, 0x1.01f55e5df3fe5p-13,
     -0x1.55c070294fbbdp-15, 0x1.080d7ced18ae1p-16, -0x1.baf87adee559bp-18, 0x1.871896282bd66p-19,
     -0x1.659dc5e6bd368p-20, 0x1.4f73f25530445p-21, -0x1.4193e25c0e9e2p-22, 0x1.384d65f44b653p-23},
     /* [6] 1.75 <= y <= 1.875 2^-40, degree 10, 70.1 bits */
    {0x1.fd60082e8b047p-1, -0x1.d04c7b710b653p-55, -0x1.149356430be21p-11, 0x1.c987268cf6c46p-14,
     -0x1.1b85d3a4cd365p-15, 0x1.99dc3eff487cp-17, -0x1.419bd1a173a05p-18, 0x1.09a0b45b37ef5p-19, -0x1.c670197964b9p-21,
     0x1.8ec5e0d6da0ffp-22, -0x1.6582f7cdab33ep-23, 0x1.44cc495a33f0ep-24},
     /* [7] 1.875 <= y <= 2 2^-40, degree 10, 72.6 bits */
    {0x1.fd538af38ef2bp-1, -0x1.b9e2ce40107cdp-57, -0x1.00d7db2eb808dp-10, 0x1.836848acbcb8bp-12,
     -0x1.b5c786f0d783bp-13, 0x1.20822abd83aa9p-13, -0x1.9cd2eecf556b4p-14, 0x1.36e19f16a074ap-14,
     -0x1.e4ec7e0872c02p-15, 0x1.83fa8e626ab37p-15, -0x1.3ea88bbffe2a3p-15, 0x1.07fc16542782ap-15},
     /* [8] 1 <= y <= 1.125 2^-39, degree 10, 66.5 bits */
    {0x1.fd443284afc7dp-1, 0x1.ddb935452fadcp-57, -0x1.d5e2404bfbee7p-11, 0x1.3d1508c9b0a1cp-12, -0x1.4098edc73ad4bp-13,
     0x1.7a163c3905f9ep-14, -0x1.e40e4128f7ebdp-15, 0x1.462747e3f97dap-15, -0x1.c73287fdaaba2p-16,
     0x1.45dc160b2bc96p-16, -0x1.de47e3404529ap-17, 0x1.6280988ca6507p-17},
     /* [9] 1.125 <= y <= 1.25 2^-39, degree 10, 68.4 bits */
    {0x1.fd3618a78114p-1, -0x1.a71edc0f5621cp-63, -0x1.b1ab7aac9ca1fp-11, 0x1.08c865fc0e65p-12, -0x1.e472b08dcc07p-14,
     0x1.0274a0e51ce03p-14, -0x1.2b61d3b6a782ap-15, 0x1.6d05774ba42aap-16, -0x1.cced85122f27fp-17,
     0x1.2a89a538f5a38p-17, -0x1.8c0e50a5ab9a4p-18, 0x1.0998021571f1fp-18},
     /* [10] 1.25 <= y <= 1.375 2^-39, degree 10, 68.6 bits */
    {0x1.fd2908969c5bdp-1, 0x1.9c67d9ddde6e5p-55, -0x1.932dd85e22721p-11, 0x1.c1890ae2c58b3p-13, -0x1.777afa9d812f8p-14,
     0x1.6dce2bd5ba35p-15, -0x1.82e2dfefa0f97p-16, 0x1.aeb191ee65fap-17, -0x1.f090bfe7086f1p-18, 0x1.25a74804007ap-18,
     -0x1.636fc45c129d6p-19, 0x1.b33fe1a19645ap-20}, /* [11] 1.375 <= y <= 1.5 2^-39, degree 10, 68.7 bits */
    {0x1.fd1cda01fcab2p-1, -0x1.40d94cfd18b07p-58, -0x1.791e431aee309p-11, 0x1.82d9ee577f815p-13, -0x1.29469c29183ap-14,
     0x1.0a72b7af74fc4p-15, -0x1.03428907215fap-16, 0x1.09870e4d54b6dp-17, -0x1.19a5f1b92714ep-18,
     0x1.3277a81242a16p-19, -0x1.551393b6d37dbp-20, 0x1.803f4a985743ap-21},
     /* [12] 1.5 <= y <= 1.625 2^-39, degree 10, 68.5 bits */
    {0x1.fd116d6012df8p-1, 0x1.b0f4e153fc678p-56, -0x1.628f99b874751p-11, 0x1.50c793ce07fdcp-13, -0x1.df42aa65a51dcp-15,
     0x1.8dbe59ba34367p-16, -0x1.6658cee39ba9fp-17, 0x1.53d333455bb1bp-18, -0x1.4dc1c5481bfe4p-19,
     0x1.50446b569a067p-20, -0x1.5a5d71eb9846fp-21, 0x1.694c40c9af0dcp-22},
     /* [13] 1.625 <= y <= 1.75 2^-39, degree 10, 70.5 bits */
    {0x1.fd06a985b7da9p-1, 0x1.313fff06a8454p-56, -0x1.4ed358c9d9f41p-11, 0x1.281bbdc62f54ap-13, -0x1.8853344bff1e7p-15,
     0x1.2f243ef07250fp-16, -0x1.fc8fad7892b98p-18, 0x1.c10416fcc90edp-19, -0x1.9a95e533518adp-20,
     0x1.812529af20024p-21, -0x1.7138205761e28p-22, 0x1.6692df1d48899p-23},
     /* [14] 1.75 <= y <= 1.875 2^-39, degree 10, 68.6 bits */
    {0x1.fcfc7a053d195p-1, -0x1.9a38fe12a211ep-55, -0x1.3d66132f11832p-11, 0x1.0697fe064e7dap-13,
     -0x1.4579f740341ebp-15, 0x1.d687b39f51f59p-17, -0x1.7139fa786ee91p-18, 0x1.30f6cf621f752p-19,
     -0x1.04df4b907f11ap-20, 0x1.c9d79109dc239p-22, -0x1.9a795d971b76ap-23, 0x1.74eb1b575dd0ep-24},
     /* [15] 1.875 <= y <= 2 2^-39, degree 10, 69.4 bits */
    {0x1.fcee24e794a77p-1, -0x1.31e878552cb29p-56, -0x1.26bf9ddc0aae2p-10, 0x1.bcb0ff1fae191p-12,
     -0x1.f68d87c2f8e39p-13, 0x1.4b361ce08afa2p-13, -0x1.d9f13765ccc5p-14, 0x1.64ea66280b3ap-14, -0x1.165ec0db62366p-14,
     0x1.bd71d95e164fp-15, -0x1.6ddc9cbe008c5p-15, 0x1.2f17b774d72a5p-15},
     /* [16] 1 <= y <= 1.125 2^-38, degree 10, 66.6 bits */
    {0x1.fcdc88c1ebcffp-1, -0x1.7c50f0229917p-56, -0x1.0d9be607ffdc1p-10, 0x1.6bf6260a739fbp-12, -0x1.7006fb05c7909p-13,
     0x1.b20ae73a336aap-14, -0x1.15db36efecb13p-14, 0x1.7671cdc9f27f6p-15, -0x1.054d76bf5c426p-15, 0x1.761edb3414b8p-16,
     -0x1.128fc2b0c4dc6p-16, 0x1.9703f5e38d177p-17}, /* [17] 1.125 <= y <= 1.25 2^-38, degree 10, 67.0 bits */
    {0x1.fccc5a4766b2fp-1, 0x1.fff15bafd3cf2p-55, -0x1.f1a6752eac552p-11, 0x1.2fecde556af98p-12, -0x1.160e2ec79cecbp-13,
     0x1.28b3d863b616ap-14, -0x1.57b26a9f64eeep-15, 0x1.a310052f9dca9p-16, -0x1.0896d5d44b521p-16, 0x1.56bf95b94e5ep-17,
     -0x1.c6b6e80c3feb6p-18, 0x1.30ef02aa8252p-18}, /* [18] 1.25 <= y <= 1.375 2^-38, degree 10, 68.2 bits */
    {0x1.fcbd5ce419862p-1, -0x1.c8f3bb5f199b7p-57, -0x1.cea6fd8ef3d0dp-11, 0x1.01fdb8493473ep-12,
     -0x1.af04c05350333p-14, 0x1.a3eeee2939a8ap-15, -0x1.bc26095e030f4p-16, 0x1.ee73d0bc5adf5p-17,
     -0x1.1d0b28489e7dep-17, 0x1.512333f9e9c1fp-18, -0x1.98134264e9c61p-19, 0x1.f3b6d429a0575p-20},
     /* [19] 1.375 <= y <= 1.5 2^-38, degree 10, 68.3 bits */
    {0x1.fcaf625174a69p-1, -0x1.b1ba901bcfb7cp-57, -0x1.b0bd50a1d0352p-11, 0x1.bc06de171f89bp-13,
     -0x1.553e19ffdf36ap-14, 0x1.31def61482914p-15, -0x1.29a123d37c6c4p-16, 0x1.30d52408c6906p-17,
     -0x1.43589c956a85p-18, 0x1.5fd881bf5bcc4p-19, -0x1.8795be27b6694p-20, 0x1.b92771961cdcbp-21},
     /* [20] 1.5 <= y <= 1.625 2^-38, degree 10, 69.6 bits */
    {0x1.fca2465bc768fp-1, 0x1.eb2173bca055ap-56, -0x1.96d9370d9c4b5p-11, 0x1.828cc5b236f7p-13, -0x1.1311777e9b38p-14,
     0x1.c8967a1fbbf6ep-16, -0x1.9b60849af7556p-17, 0x1.861fd7e443588p-18, -0x1.7f2a85c694aa3p-19,
     0x1.820e0023c790ep-20, -0x1.8da73e3879649p-21, 0x1.9ecd715b9365bp-22},
     /* [21] 1.625 <= y <= 1.75 2^-38, degree 10, 69.7 bits */
    {0x1.fc95ec1f048bep-1, -0x1.d01ead16243d6p-57, -0x1.80325b9547605p-11, 0x1.53dd3a8a718f8p-13, -0x1.c257008113a1p-15,
     0x1.5bfc90f2a5639p-16, -0x1.23e865498b477p-17, 0x1.01bc86463503ap-18, -0x1.d75d4b48c56d7p-20,
     0x1.ba2a73099e813p-21, -0x1.a7e368a22772p-22, 0x1.9babf861cbe02p-23},
     /* [22] 1.75 <= y <= 1.875 2^-38, degree 10, 68.6 bits */
    {0x1.fc8a3c281ebeep-1, -0x1.e5b0cf07bed3p-55, -0x1.6c31df9f50cb9p-11, 0x1.2d64cd26dbd3cp-13, -0x1.759a37810a495p-15,
     0x1.0e10fb1ec23c3p-16, -0x1.a7dbefb843b29p-18, 0x1.5e18fd307a377p-19, -0x1.2b7c9b25ccd61p-20,
     0x1.06cf8ab14937cp-21, -0x1.d73f82cee7cfap-23, 0x1.ac2331191b6cap-24},
     /* [23] 1.875 <= y <= 2 2^-38, degree 10, 69.0 bits */
    {0x1.fc79ca1fc08bcp-1, -0x1.e68c80f69edc7p-56, -0x1.5232b434160c1p-10, 0x1.fe63c208603a5p-12,
     -0x1.206d4eba0bd78p-12, 0x1.7c335763c44ecp-13, -0x1.1008037c76935p-13, 0x1.99bba6d42335ep-14,
     -0x1.3f9233fd008f3p-14, 0x1.ff621b955c5f7p-15, -0x1.a406b38130af7p-15, 0x1.5bf808938f2ep-15},
     /* [24] 1 <= y <= 1.125 2^-37, degree 10, 66.5 bits */
    {0x1.fc65957ca68cep-1, -0x1.cad5f265ffe98p-56, -0x1.35583f8bdbf89p-10, 0x1.a1b99089dc62dp-12,
     -0x1.a66e957b943fap-13, 0x1.f23bcdcebe121p-14, -0x1.3ef5f435040ecp-14, 0x1.add98ca783339p-15,
     -0x1.2bf92b801eecap-15, 0x1.ad7eccac62b0cp-16, -0x1.3b348a71ee796p-16, 0x1.d345d02234578p-17},
     /* [25] 1.125 <= y <= 1.25 2^-37, degree 10, 67.7 bits */
    {0x1.fc530488bb5d6p-1, 0x1.cd81ba3ba996ap-55, -0x1.1d7dad681125ep-10, 0x1.5cd068aa11934p-12, -0x1.3f279f640311bp-13,
     0x1.5493c6ba431ap-14, -0x1.8a893c79eacb3p-15, 0x1.e110428c8191bp-16, -0x1.2fbe137919a3ap-16, 0x1.89798f7c5a95dp-17,
     -0x1.050294b90a657p-17, 0x1.5e12ec95c1448p-18}, /* [26] 1.25 <= y <= 1.375 2^-37, degree 10, 68.2 bits */
    {0x1.fc41d1bbb0c77p-1, 0x1.e1b2684a26046p-58, -0x1.09685791e9287p-10, 0x1.28173c179e608p-12, -0x1.eeb86402baef9p-14,
     0x1.e20637cb9f627p-15, -0x1.fdd704e7b7191p-16, 0x1.1bccdcf8c9babp-16, -0x1.473846cc2633ap-17,
     0x1.8307788ca750bp-18, -0x1.d478e933f3926p-19, 0x1.1ed75399123b4p-19},
     /* [27] 1.375 <= y <= 1.5 2^-37, degree 10, 68.9 bits */
    {0x1.fc31c7f802b72p-1, 0x1.5df4e0c8004a7p-56, -0x1.f07c33dcca86ep-11, 0x1.fd97989496712p-13, -0x1.87abb468645fbp-14,
     0x1.5f17a50679407p-15, -0x1.55a55fbfc3afdp-16, 0x1.5decc09e582bfp-17, -0x1.732f8cb729e71p-18,
     0x1.93e8e47633d3ep-19, -0x1.c18966cd2a50ap-20, 0x1.fa72ecb0588edp-21},
     /* [28] 1.5 <= y <= 1.625 2^-37, degree 10, 68.2 bits */
    {0x1.fc22bdb05c84fp-1, 0x1.679131b56a7b2p-55, -0x1.d2c5722403939p-11, 0x1.bb9f2f82a82edp-13, -0x1.3bb6986104ab4p-14,
     0x1.060afabd7f954p-15, -0x1.d835e35014b7bp-17, 0x1.bfd420865d141p-18, -0x1.b7da069f30fa8p-19,
     0x1.bb2d23d578155p-20, -0x1.c87fad4982a1dp-21, 0x1.dc314ce9ebcf7p-22},
     /* [29] 1.625 <= y <= 1.75 2^-37, degree 10, 70.3 bits */
    {0x1.fc1491bbc3f5cp-1, 0x1.8483dd4fa5ca3p-55, -0x1.b8c676c69f7d7p-11, 0x1.8609b86c7fe94p-13, -0x1.027050bb71f93p-14,
     0x1.8f6cecd3060b9p-16, -0x1.4f1228f68e9fcp-17, 0x1.27db1a9ba6b1p-18, -0x1.0e8be170eeb4p-19, 0x1.fb95c5b55eb9ap-21,
     -0x1.e69c935312821p-22, 0x1.d89821eb924eep-23}, /* [30] 1.75 <= y <= 1.875 2^-37, degree 10, 68.3 bits */
    {0x1.fc0729302d0e8p-1, -0x1.a35eab70eac42p-60, -0x1.a1d215c00776fp-11, 0x1.59e240a5b8b6p-13, -0x1.accc1820104c9p-15,
     0x1.35fbe28ffe0a3p-16, -0x1.e6874d79db56ep-18, 0x1.91dfa1a85377ap-19, -0x1.57c94c71381e3p-20,
     0x1.2db0fc91d633cp-21, -0x1.0e7cc00bdbd9cp-22, 0x1.eb7e183e2be32p-24},
     /* [31] 1.875 <= y <= 2 2^-37, degree 10, 68.8 bits */
    {0x1.fbf44b4ece7fep-1, -0x1.11bb0f313d9cp-57, -0x1.83fc958ed9c7cp-10, 0x1.24dc29a3e77c3p-11, -0x1.4b087358a3ba6p-12,
     0x1.b463e9eca078ep-13, -0x1.383f79e97a964p-13, 0x1.d65279b2f928dp-14, -0x1.6ed6393d465ccp-14,
     0x1.2583f06227213p-14, -0x1.e22b0480e815p-15, 0x1.8f74c04e23273p-15},
     /* [32] 1 <= y <= 1.125 2^-36, degree 10, 66.8 bits */
    {0x1.fbdd1d41cd3d8p-1, 0x1.a85306d08f494p-55, -0x1.62e006791f36dp-10, 0x1.df5e2dd3ca2bcp-12, -0x1.e4d2d46c7b6f1p-13,
     0x1.1dedb451dccfcp-13, -0x1.6e1bee910f98bp-14, 0x1.ed67d76c0fbep-15, -0x1.5855c242f0636p-15, 0x1.ed05966a7d55bp-16,
     -0x1.69d56ba58d097p-16, 0x1.0c33d1119920cp-16}, /* [33] 1.125 <= y <= 1.25 2^-36, degree 10, 67.5 bits */
    {0x1.fbc7d0d2b7cc3p-1, 0x1.f9afd2fa32c2fp-55, -0x1.47806307c07f3p-10, 0x1.9047aaf3fd44fp-12, -0x1.6e49403be645ep-13,
     0x1.86e5c1a4e4132p-14, -0x1.c4d947141b25dp-15, 0x1.1417754d9014fp-15, -0x1.5ca80fea6549fp-16, 0x1.c3aace80c49fp-17,
     -0x1.2b9e0641a900ep-17, 0x1.91dc7db28e85ap-18}, /* [34] 1.25 <= y <= 1.375 2^-36, degree 10, 67.5 bits */
    {0x1.fbb416345ecd2p-1, -0x1.c730927ee4ea2p-55, -0x1.307486d101e71p-10, 0x1.53c56a7b16b6ap-12,
     -0x1.1be26be70ef21p-13, 0x1.149e0cc4f53cp-14, -0x1.2497cf3cb41bap-15, 0x1.45c098320a578p-16,
     -0x1.7799afd1798d1p-17, 0x1.bc4331375a02fp-18, -0x1.0ce1322217ec7p-18, 0x1.49452b3993206p-19},
     /* [35] 1.375 <= y <= 1.5 2^-36, degree 10, 67.1 bits */
    {0x1.fba1b07155d54p-1, 0x1.5ee22ccab0b49p-55, -0x1.1cc2132d34755p-10, 0x1.24612144c7683p-12, -0x1.c17f17473f946p-14,
     0x1.92f4455bbcb0ap-15, -0x1.8821620b270d1p-16, 0x1.91a577738e32ap-17, -0x1.aa0fb759cefdfp-18,
     0x1.cfa235f526506p-19, -0x1.02022e9db50a2p-19, 0x1.22ad7976a213cp-20},
     /* [36] 1.5 <= y <= 1.625 2^-36, degree 10, 67.8 bits */
    {0x1.fb906fd9b2009p-1, 0x1.e7240134ff1bfp-55, -0x1.0bb5b85c18404p-10, 0x1.fd0c9afa13f74p-13, -0x1.6a51c7bc7a6d5p-14,
     0x1.2cbf2475eccd7p-15, -0x1.0efd9a0ca0f92p-16, 0x1.0101e4d9f8ebfp-17, -0x1.f8df728aaba5bp-19,
     0x1.fcb3567149724p-20, -0x1.06005bb502207p-20, 0x1.114f1761a4969p-21},
     /* [37] 1.625 <= y <= 1.75 2^-36, degree 10, 67.9 bits */
    {0x1.fb802e5f3c3bdp-1, 0x1.b9c414042f2eep-55, -0x1.f99702517af4bp-11, 0x1.bf8e3f5d09853p-13, -0x1.2895fbc1c268ap-14,
     0x1.ca6a32b53e7d1p-16, -0x1.8092ffb9d231ap-17, 0x1.5393d9e306285p-18, -0x1.36895ac18a23p-19, 0x1.23501cfbe9453p-20,
     -0x1.174806b8d9463p-21, 0x1.0f3dad4fc4234p-22}, /* [38] 1.75 <= y <= 1.875 2^-36, degree 10, 70.4 bits */
    {0x1.fb70cd1ed5e05p-1, 0x1.ad1caf09a72b3p-55, -0x1.df401b9156caap-11, 0x1.8ce266a69f0bbp-13, -0x1.ec157d545fbcep-15,
     0x1.63c27fe2636abp-16, -0x1.17336bf09bcb9p-17, 0x1.cd41ecae5ae2p-19, -0x1.8a991b2f4ab34p-20, 0x1.5a4a1fbbd20dbp-21,
     -0x1.367a95ddce71bp-22, 0x1.1a15ad32422b4p-23}, /* [39] 1.875 <= y <= 2 2^-36, degree 10, 68.7 bits */
    {0x1.fb5b29351481ep-1, 0x1.5698b7816c5d5p-56, -0x1.bd048bda84e66p-10, 0x1.5009087937ff7p-11, -0x1.7be2347621ca3p-12,
     0x1.f4d302d834961p-13, -0x1.665e996ceae3ep-13, 0x1.0de7fa51b2094p-13, -0x1.a50c9771fcb29p-14,
     0x1.50e66d29393cdp-14, -0x1.14b975de9dc4dp-14, 0x1.ca846a319b6fp-15},
     /* [40] 1 <= y <= 1.125 2^-35, degree 10, 66.1 bits */
    {0x1.fb4093031b25ap-1, -0x1.4aeee60f0932bp-57, -0x1.970670d2a59a7p-10, 0x1.13033edbe2aa7p-11,
     -0x1.162da2bc955efp-12, 0x1.4823c0602567dp-13, -0x1.a42d9958a3efep-14, 0x1.1b25d87f3c1bfp-14,
     -0x1.8b36fb3e7d25dp-15, 0x1.1af15f689da15p-15, -0x1.9f515f135d80bp-16, 0x1.33da1e5b34297p-16},
     /* [41] 1.125 <= y <= 1.25 2^-35, degree 10, 66.9 bits */
    {0x1.fb28256c5c842p-1, 0x1.0d4c8b3e6dfa5p-57, -0x1.779dfd12b8ad2p-10, 0x1.cb44f43c0caafp-12, -0x1.a452255f61185p-13,
     0x1.c098ac57a8641p-14, -0x1.03dbf7fcc9488p-14, 0x1.3cdf69ef3ca96p-15, -0x1.902b0995d560cp-16,
     0x1.0334974a0909ep-16, -0x1.57e64842aa83cp-17, 0x1.cd435fea6d65dp-18},
     /* [42] 1.25 <= y <= 1.375 2^-35, degree 10, 67.0 bits */
    {0x1.fb1184dda89dfp-1, -0x1.8ec84fd1f69cbp-55, -0x1.5d2cbc6d8e955p-10, 0x1.85d5bc8c5535bp-12,
     -0x1.45c1cb5c7ebd7p-13, 0x1.3d71328d6eafp-14, -0x1.4fcb029783b7ap-15, 0x1.75dcd8b1d0abfp-16,
     -0x1.af16063462b3fp-17, 0x1.fde77b6259e77p-18, -0x1.349d4f79ecf29p-18, 0x1.79efbc11de415p-19},
     /* [43] 1.375 <= y <= 1.5 2^-35, degree 10, 68.5 bits */
    {0x1.fafc6b639a545p-1, -0x1.210744cb9f3abp-55, -0x1.46935c00eb4a6p-10, 0x1.4f7413b283455p-12,
     -0x1.01e4c6043d9a4p-13, 0x1.ce6ab4c294857p-15, -0x1.c20502d3d1094p-16, 0x1.ccf56517dbe28p-17,
     -0x1.e8fe8f1dc9fc3p-18, 0x1.0a10a6a322762p-18, -0x1.2821fc57a53bap-19, 0x1.4da2ac6df12cp-20},
     /* [44] 1.5 <= y <= 1.625 2^-35, degree 10, 68.7 bits */
    {0x1.fae8a245bc9dap-1, 0x1.ba0ab4dde96a3p-56, -0x1.330415acc951fp-10, 0x1.2404281fac19ep-12, -0x1.9fbf2296fa63ep-14,
     0x1.591f194dd727dp-15, -0x1.36fddead174bap-16, 0x1.26f4cb43d4a3cp-17, -0x1.21b833a51ce86p-18,
     0x1.23ec7752bd90bp-19, -0x1.2cb63641de39cp-20, 0x1.39b22c3269174p-21},
     /* [45] 1.625 <= y <= 1.75 2^-35, degree 10, 67.3 bits */
    {0x1.fad5fdd92aa04p-1, 0x1.e04816450949ep-55, -0x1.21e77b82887edp-10, 0x1.00bc5fa1cbfedp-12, -0x1.54508d7233e5ep-14,
     0x1.0705d9b409d1ep-15, -0x1.b955d34490b3cp-17, 0x1.85b6952ee291ap-18, -0x1.6465651d3fd1ep-19, 0x1.4e57ab0470edp-20,
     -0x1.408a79ed8c4ddp-21, 0x1.3751952cdec6bp-22}, /* [46] 1.75 <= y <= 1.875 2^-35, degree 10, 67.1 bits */
    {0x1.fac45aacdcf32p-1, -0x1.4f44604e50076p-55, -0x1.12cb844a3f9ap-10, 0x1.c7546ef7879bdp-13, -0x1.1a5076255e0a1p-14,
     0x1.983d73e071cb1p-16, -0x1.4067b8fe6df73p-17, 0x1.08acfe76d009ep-18, -0x1.c4ddbdbd9a6aap-20,
     0x1.8d6f56565ef16p-21, -0x1.6457e19854f6bp-22, 0x1.43c2d3ad0c89p-23},
     /* [47] 1.875 <= y <= 2 2^-35, degree 10, 69.2 bits */
    {0x1.faab89c567d58p-1, 0x1.f68d3a560652ep-57, -0x1.fe5110069d76ep-10, 0x1.8182c7deb31bap-11, -0x1.b3e0ccb1b4e4ap-12,
     0x1.1f58a8b86b119p-12, -0x1.9b3ff845b158ap-13, 0x1.35befeae6d315p-13, -0x1.e33705066f22p-14, 0x1.82a6fbd3b7b1dp-14,
     -0x1.3d98fa40eef4ap-14, 0x1.07204af782e2ep-14}, /* [48] 1 <= y <= 1.125 2^-34, degree 10, 66.9 bits */
    {0x1.fa8d0d08d4f6dp-1, 0x1.f3517891ba30bp-55, -0x1.d2bb1c6c6b612p-10, 0x1.3b7e945723bd8p-11, -0x1.3f2c5779e8c58p-12,
     0x1.788773517081cp-13, -0x1.e22af926bbbdep-14, 0x1.44ef6ac815b24p-14, -0x1.c58e810a2e061p-15,
     0x1.44b85fd6d4d12p-15, -0x1.dca6f5fedf7a8p-16, 0x1.6152afb54e1cep-16},
     /* [49] 1.125 <= y <= 1.25 2^-34, degree 10, 66.9 bits */
    {0x1.fa710a3f97a6bp-1, 0x1.290413f5e35cp-55, -0x1.aeb33aaf476a5p-10, 0x1.076e025fb95c4p-11, -0x1.e240748836152p-13,
     0x1.015e6d7749827p-13, -0x1.2a30ca082f5e7p-14, 0x1.6ba1468686c4fp-15, -0x1.cb3b7ac62283fp-16,
     0x1.2978e9201c611p-16, -0x1.8aadf828a6b9fp-17, 0x1.08b12b5b565bfp-17},
     /* [50] 1.25 <= y <= 1.375 2^-34, degree 10, 68.2 bits */
    {0x1.fa571857f7e1bp-1, 0x1.87c38426a9adbp-58, -0x1.905dd98ca8a46p-10, 0x1.bf31fc179f20bp-12, -0x1.75bf14a64a337p-13,
     0x1.6c3d13e800df5p-14, -0x1.815154ffbfa14p-15, 0x1.ad0576c3a45c7p-16, -0x1.eeb47033c8905p-17,
     0x1.249602cc82414p-17, -0x1.622da8511c97ap-18, 0x1.b1be87d700638p-19},
     /* [51] 1.375 <= y <= 1.5 2^-34, degree 10, 69.1 bits */
    {0x1.fa3ee710409a4p-1, -0x1.876fa60c4ae84p-56, -0x1.767149de968d7p-10, 0x1.80cd9836ea57bp-12,
     -0x1.27e1297d91cb6p-13, 0x1.0949939f439ddp-14, -0x1.0230dc1648f02p-15, 0x1.087a9e4fba94cp-16,
     -0x1.18932c6601f01p-17, 0x1.315598626da53p-18, -0x1.53d9332956f3fp-19, 0x1.7ee548d6d1f86p-20},
     /* [52] 1.5 <= y <= 1.625 2^-34, degree 10, 68.4 bits */
    {0x1.fa2837a074cacp-1, 0x1.a0fde6bd739fdp-55, -0x1.600170594d38dp-10, 0x1.4ef7e8f2346abp-12, -0x1.dcf950bd05e89p-14,
     0x1.8bfbcd5ae684dp-15, -0x1.64d89417bc2cap-16, 0x1.52763ddca83dap-17, -0x1.4c77099b9bc2ap-18,
     0x1.4f0124ce5461dp-19, -0x1.59192997f244ep-20, 0x1.6801c9371dc62p-21},
     /* [53] 1.625 <= y <= 1.75 2^-34, degree 10, 68.7 bits */
    {0x1.fa12d7ef39b78p-1, 0x1.770cde238fcc6p-55, -0x1.4c608d7c47e9ep-10, 0x1.267e1a4eea5b3p-12, -0x1.866d067484657p-14,
     0x1.2dc7d6a31a285p-15, -0x1.fa6669e3e31c4p-17, 0x1.bf30447aac7fbp-18, -0x1.98f915cdcdbecp-19,
     0x1.7fad7d29eb5dap-20, -0x1.6fd964631dd1fp-21, 0x1.654619fa19053p-22},
     /* [54] 1.75 <= y <= 1.875 2^-34, degree 10, 67.5 bits */
    {0x1.f9fe9f536d0adp-1, 0x1.c5fe05d31de69p-55, -0x1.3b0bc9f7e776fp-10, 0x1.052429b87475p-12, -0x1.43e11fb20aeacp-14,
     0x1.d46388e56c15fp-16, -0x1.6fa2d1ceff081p-17, 0x1.2fb4bdd068309p-18, -0x1.03d56f3bf2e51p-19,
     0x1.c812e5c0b4ad3p-21, -0x1.98ee1fb518866p-22, 0x1.738c4e1852ac6p-23},
     /* [55] 1.875 <= y <= 2 2^-34, degree 10, 67.1 bits */
    {0x1.f9e22c00f5747p-1, 0x1.a8124a5c7cb87p-55, -0x1.2485b3d1d035ap-9, 0x1.ba2f6159370c9p-11, -0x1.f40a4b3d378bcp-12,
     0x1.49acf15277c4ep-12, -0x1.d7dcafba2533p-13, 0x1.636a5415b4bbep-13, -0x1.153db0857c708p-13, 0x1.bbb119df79acp-14,
     -0x1.6c75bc04032b7p-14, 0x1.2df5427bf2b65p-14}, /* [56] 1 <= y <= 1.125 2^-33, degree 10, 66.5 bits */
    {0x1.f9bf3896a5ccp-1, 0x1.056796b561406p-57, -0x1.0b86a9e738617p-9, 0x1.69dcffb6d1019p-11, -0x1.6e25288f3db4bp-12,
     0x1.affbe3be6604bp-13, -0x1.149be07471422p-13, 0x1.74d5aa8b39d4bp-14, -0x1.0437ed1412181p-14,
     0x1.749d5ad38f50fp-15, -0x1.117c4647b19bap-15, 0x1.9574fc9e6963p-16},
     /* [57] 1.125 <= y <= 1.25 2^-33, degree 10, 67.7 bits */
    {0x1.f99f1c4c2c6dbp-1, 0x1.d2712e55e6a2ep-56, -0x1.edb9f4a1287f1p-10, 0x1.2e23195cd1113p-11, -0x1.149aab971a079p-12,
     0x1.274430375add8p-13, -0x1.561f4baa1f9f3p-14, 0x1.a1394d3c1e251p-15, -0x1.0778097fb83e9p-15,
     0x1.555729072fdd8p-16, -0x1.c4e546e20e1e6p-17, 0x1.2fbdf49311c27p-17},
     /* [58] 1.25 <= y <= 1.375 2^-33, degree 10, 69.1 bits */
    {0x1.f9815e99b5fafp-1, 0x1.441203cd01f68p-55, -0x1.caefafc3824fdp-10, 0x1.0071e100a11cbp-11, -0x1.acba1d26841a3p-13,
     0x1.a1dcdd0e46604p-14, -0x1.ba1360fca24b4p-15, 0x1.ec3e0e5b11fcep-16, -0x1.1bd06d4b03ff3p-16,
     0x1.4fba11bdfd3fbp-17, -0x1.966995ea5baacp-18, 0x1.f1b995411d87bp-19},
     /* [59] 1.375 <= y <= 1.5 2^-33, degree 10, 68.0 bits */
    {0x1.f965a36ecd47fp-1, -0x1.27690da23962ep-62, -0x1.ad344b404c777p-10, 0x1.b951ef2c94345p-12,
     -0x1.5365b68e4519ap-13, 0x1.305645da022f6p-14, -0x1.283776c732161p-15, 0x1.2f726398f6a5p-16,
     -0x1.41ed7df985b72p-17, 0x1.5e592eaae8918p-18, -0x1.85f6494031472p-19, 0x1.b75e309478dc8p-20},
     /* [60] 1.5 <= y <= 1.625 2^-33, degree 10, 69.5 bits */
    {0x1.f94ba2c75ad9dp-1, -0x1.a43227c36e828p-57, -0x1.9378e9d153c74p-10, 0x1.802804448031dp-12,
     -0x1.118eade66287dp-13, 0x1.c6430d24e8c83p-15, -0x1.9964bd00ada47p-16, 0x1.8452adabdc86cp-17,
     -0x1.7d7572184fbbep-18, 0x1.8062c7feb7a4p-19, -0x1.8bfab1e776a1bp-20, 0x1.9d18b93be7709p-21},
     /* [61] 1.625 <= y <= 1.75 2^-33, degree 10, 68.8 bits */
    {0x1.f933232bd1211p-1, 0x1.a88bf245bf874p-55, -0x1.7cf63925fd172p-10, 0x1.51ba96d72de3bp-12, -0x1.bfd47ccd193abp-14,
     0x1.5a30200ac374p-15, -0x1.227acfb6c5411p-16, 0x1.008766485c219p-17, -0x1.d53bbf7833aa8p-19, 0x1.b839fb8c8bb01p-20,
     -0x1.a613e71c8fefbp-21, 0x1.99f434d0f06b1p-22}, /* [62] 1.75 <= y <= 1.875 2^-33, degree 10, 67.2 bits */
    {0x1.f91bf5f87701cp-1, -0x1.5fe9f8388d0bcp-55, -0x1.691620a1c20cap-10, 0x1.2b796a506ec4fp-12,
     -0x1.737de86b18621p-14, 0x1.0ca6c35e49969p-15, -0x1.a5c1da640b038p-17, 0x1.5c6f5be326edcp-18,
     -0x1.2a1d4259b7cf8p-19, 0x1.05a46e8838a31p-20, -0x1.d5352f8a866bdp-22, 0x1.aa5398ed01bf7p-23},
     /* [63] 1.875 <= y <= 2 2^-33, degree 10, 69.5 bits */
    {0x1.f8fb5a73a4a65p-1, -0x1.8325628c3fb59p-62, -0x1.4f41bd015fe12p-9, 0x1.fb13d7393499fp-11, -0x1.1ec445290f041p-11,
     0x1.7a2bbe2f5b7bcp-12, -0x1.0ea820fef2394p-12, 0x1.97c014ed4176ep-13, -0x1.3e1430f486499p-13,
     0x1.fd11115f6e43bp-14, -0x1.a22c6e389ef37p-14, 0x1.5a782f67ad53fp-14},
     /* [64] 1 <= y <= 1.125 2^-32, degree 10, 66.1 bits */
    {0x1.f8d34c2dcee86p-1, -0x1.98644c2cc6a17p-57, -0x1.3297c167e9ad9p-9, 0x1.9ef3b4c1b68bbp-11, -0x1.a3f1d401abed4p-12,
     0x1.ef8352981d9dfp-13, -0x1.3d4fedfdef8f1p-13, 0x1.abb8e2d67e9d7p-14, -0x1.2a8a63a6c57edp-14,
     0x1.ab81574d6a165p-15, -0x1.39c8796f74c7fp-15, 0x1.d1368dde54b88p-16},
     /* [65] 1.125 <= y <= 1.25 2^-32, degree 10, 68.4 bits */
    {0x1.f8ae7fb525afdp-1, 0x1.434b4e88da589p-55, -0x1.1ae62169b2012p-9, 0x1.5a7374b6f791ep-11, -0x1.3d3ca5e12448ep-12,
     0x1.52ade504f9f03p-13, -0x1.88747ca3f68afp-14, 0x1.dea22d7261d16p-15, -0x1.2e430e735169p-15, 0x1.879d3db43c675p-16,
     -0x1.03cee7c834d93p-16, 0x1.5c7fc7f462789p-17}, /* [66] 1.25 <= y <= 1.375 2^-32, degree 10, 68.9 bits */
    {0x1.f88c6acc851dp-1, 0x1.6dff42f25a2c2p-56, -0x1.06f3f24fefa02p-9, 0x1.260c1fabf952cp-11, -0x1.ebb11e0553ad3p-13,
     0x1.df49b390cd1fep-14, -0x1.fb19b8aead8bp-15, 0x1.1a57053c6aebfp-15, -0x1.45985795e7ffep-16, 0x1.812a36961465fp-17,
     -0x1.d2465ca5126cbp-18, 0x1.1d86d4ae697a2p-18}, /* [67] 1.375 <= y <= 1.5 2^-32, degree 10, 65.9 bits */
    {0x1.f86ca3dda54a9p-1, -0x1.b28bde01a6181p-56, -0x1.ebd0933646913p-10, 0x1.fa03e0283b9c7p-12,
     -0x1.853b6b1fcde72p-13, 0x1.5d10aeb3b7705p-14, -0x1.53c765675d72p-15, 0x1.5c17ed068769ap-16, -0x1.714faa5de7dcp-17,
     0x1.91ee4eb7634f9p-18, -0x1.bf645a8e8d178p-19, 0x1.f816a42299bbap-20},
     /* [68] 1.5 <= y <= 1.625 2^-32, degree 10, 67.8 bits */
    {0x1.f84ed85113faep-1, -0x1.665b8b5271ce3p-55, -0x1.ce4fa11bfeacdp-10, 0x1.b8756c94e9945p-12,
     -0x1.39b76f9bb3928p-13, 0x1.04818894f1de2p-14, -0x1.d596d30c8a986p-16, 0x1.bd72ab15d6335p-17,
     -0x1.b59866e89b504p-18, 0x1.b8f88b73c90d7p-19, -0x1.c64953b69c10dp-20, 0x1.d9f02749a238p-21},
     /* [69] 1.625 <= y <= 1.75 2^-32, degree 10, 68.0 bits */
    {0x1.f832c63f505f6p-1, 0x1.81cf046efdceap-55, -0x1.b480714d315e9p-10, 0x1.833755af6ec83p-12, -0x1.00c7c223045e1p-13,
     0x1.8d0c6c95befc7p-15, -0x1.4d2f044ef860dp-16, 0x1.2642934da552dp-17, -0x1.0d2364d91ddc6p-18,
     0x1.f905a9644131bp-20, -0x1.e43806a440d7bp-21, 0x1.d652f5f5c550dp-22},
     /* [70] 1.75 <= y <= 1.875 2^-32, degree 10, 67.7 bits */
    {0x1.f818382bfc49bp-1, -0x1.e871c594d22e5p-56, -0x1.9db6dd6c981a6p-10, 0x1.5758e303e304bp-12,
     -0x1.aa020d0fd2f5ep-14, 0x1.341d3143ca33dp-15, -0x1.e3c030dd81b28p-17, 0x1.8fad223969918p-18,
     -0x1.55f8f8ab62146p-19, 0x1.2c25b1c11b941p-20, -0x1.0d239bc0eab14p-21, 0x1.e9196dc38ade9p-23},
     /* [71] 1.875 <= y <= 2 2^-32, degree 10, 70.3 bits */
    {0x1.f7f2dc3f6eae4p-1, 0x1.6d22138788ef1p-55, -0x1.8019e5f6f8f4p-9, 0x1.22abe7c292798p-10, -0x1.48d6bedd3f25p-11,
     0x1.b1b53be90f55fp-12, -0x1.366e7022819f9p-12, 0x1.d3b3b043b108ep-13, -0x1.6cdd5ec430996p-13,
     0x1.23fc11b4d90dep-13, -0x1.dfb83d7411e0cp-14, 0x1.8d797924c4db2p-14},
     /* [72] 1 <= y <= 1.125 2^-31, degree 10, 65.9 bits */
    {0x1.f7c4f85c1f43ep-1, -0x1.aefa20a7c3544p-56, -0x1.5f3d654677003p-9, 0x1.dbb41d4d71b2p-11, -0x1.e189554052e9p-12,
     0x1.1c217c20622dp-12, -0x1.6bee33419e7f1p-13, 0x1.ea98087fe73bap-14, -0x1.567108b924624p-14, 0x1.ea644e1fd4748p-15,
     -0x1.67f448a13b457p-15, 0x1.0ad76a0f19a7ap-15}, /* [73] 1.125 <= y <= 1.25 2^-31, degree 10, 66.1 bits */
    {0x1.f79ad0594a39ap-1, -0x1.d98ccd26baa0cp-57, -0x1.4413ddbdeeeap-9, 0x1.8d283d5bfcd84p-11, -0x1.6bc0696f55356p-12,
     0x1.8463a351dca36p-13, -0x1.c219376e94189p-14, 0x1.127c65a0bd4cfp-14, -0x1.5ab329a40d9d7p-15,
     0x1.c13551b1fe587p-16, -0x1.2a07694a7fc4p-16, 0x1.8fc7b6447b5a7p-17},
     /* [74] 1.25 <= y <= 1.375 2^-31, degree 10, 66.6 bits */
    {0x1.f773c5b40830fp-1, 0x1.6a7a10f73973fp-56, -0x1.2d36750fb4f8ap-9, 0x1.511224f784c82p-11, -0x1.19e2261d9b716p-12,
     0x1.12cf2a806f69cp-13, -0x1.22c867efc68b3p-14, 0x1.43d2898a82e52p-15, -0x1.7574007d8322fp-16,
     0x1.b9cc76eb002cbp-17, -0x1.0b6d7918cb3a5p-17, 0x1.478877cb941e5p-18},
     /* [75] 1.375 <= y <= 1.5 2^-31, degree 10, 66.3 bits */
    {0x1.f74f5f5b398a2p-1, 0x1.6cad3a25e096p-61, -0x1.19ac6b06e9497p-9, 0x1.220416c982ef6p-11, -0x1.be4615231a8d1p-13,
     0x1.9046701fc0263p-14, -0x1.85a9b5185c1fap-15, 0x1.8f39e1f14e22cp-16, -0x1.a79584847fec1p-17,
     0x1.cd04b9979bca5p-18, -0x1.00976166d4bfp-18, 0x1.211e2ca1dd60ep-19},
     /* [76] 1.5 <= y <= 1.625 2^-31, degree 10, 65.9 bits */
    {0x1.f72d3e9c6fefap-1, -0x1.519ec7519f431p-56, -0x1.08c39e19afc26p-9, 0x1.f8de8ce643972p-12, -0x1.67ae463ad4897p-13,
     0x1.2ab72fb7ebb5p-14, -0x1.0d422d7f16c3cp-15, 0x1.fede59a7e89fp-17, -0x1.f5e4146800955p-18, 0x1.f9c92ff92742dp-19,
     -0x1.048a1fa2c23a6p-19, 0x1.0fd1b8e7251fep-20}, /* [77] 1.625 <= y <= 1.75 2^-31, degree 10, 70.9 bits */
    {0x1.f70d17e7ead83p-1, 0x1.ff41f9563e8a3p-55, -0x1.f3f1f65c4ea44p-10, 0x1.bbd3a92f5625dp-12, -0x1.2664ed12ab171p-13,
     0x1.c7460a19e6dd5p-15, -0x1.7e147fca7d2b4p-16, 0x1.5177f4ae3db8ap-17, -0x1.34acf2b3d3b9bp-18,
     0x1.219e90fb07016p-19, -0x1.15b3437abeafcp-20, 0x1.0dbda5f798acdp-21},
     /* [78] 1.75 <= y <= 1.875 2^-31, degree 10, 68.4 bits */
    {0x1.f6eeadeb5b428p-1, 0x1.9dc7b572e060dp-55, -0x1.d9d39ebcf77afp-10, 0x1.89884f99477b7p-12, -0x1.e865e04d33293p-14,
     0x1.6149e3b8c818bp-15, -0x1.155d894417439p-16, 0x1.ca5a8ce072c84p-18, -0x1.883377d96bfbdp-19,
     0x1.583fb81aafcdfp-20, -0x1.34b2751955ab6p-21, 0x1.1880d63fd9818p-22},
     /* [79] 1.875 <= y <= 2 2^-31, degree 10, 67.0 bits */
    {0x1.f6c3e4ad088cp-1, -0x1.52da3cfd01e97p-55, -0x1.b7e2c39c92f04p-9, 0x1.4d24b33d22f3fp-10, -0x1.78fbe96a0c946p-11,
     0x1.f1478ab373734p-12, -0x1.63f8076c297e1p-12, 0x1.0c2cbc7dcc7a7p-12, -0x1.a271657d9252ep-13,
     0x1.4ee08b800c997p-13, -0x1.131b4bd7feeddp-13, 0x1.c7e6034587963p-14},
     /* [80] 1 <= y <= 1.125 2^-30, degree 10, 66.2 bits */
    {0x1.f68f570fb2858p-1, -0x1.a2f48a9ec404fp-55, -0x1.92394d8e91b0cp-9, 0x1.1097775240a8fp-10, -0x1.14019eec46c2ep-11,
     0x1.45c38f4b302b9p-12, -0x1.a14c88529046ep-13, 0x1.194a369038182p-13, -0x1.88b6638591645p-14, 0x1.19347ae12afbp-14,
     -0x1.9cd5847a90c6bp-15, 0x1.320dae751392ap-15}, /* [81] 1.125 <= y <= 1.25 2^-30, degree 10, 66.3 bits */
    {0x1.f65f10f024109p-1, 0x1.6b957d0368288p-57, -0x1.731859a03241ep-9, 0x1.c72499eb0d2a6p-11, -0x1.a0f8b7b5e85c8p-12,
     0x1.bd481a0c680fdp-13, -0x1.020abf333adb8p-13, 0x1.3ac02d0c65d3bp-14, -0x1.8d9511fd140fbp-15,
     0x1.0194a343c022ep-15, -0x1.55cceab4146a8p-16, 0x1.ca83459b53bc7p-17},
     /* [82] 1.25 <= y <= 1.375 2^-30, degree 10, 66.1 bits */
    {0x1.f6325c994cc19p-1, 0x1.d7ed7166812f6p-55, -0x1.58e47a32e1e6bp-9, 0x1.82444f5ff3ebbp-11, -0x1.431cd7372234ap-12,
     0x1.3b0d7daefde0bp-13, -0x1.4d669b65f124dp-14, 0x1.734fed5c3b6dap-15, -0x1.ac3f96085c49dp-16,
     0x1.faa5f01d57e84p-17, -0x1.32b20e31f7e72p-17, 0x1.77a40890c656fp-18},
     /* [83] 1.375 <= y <= 1.5 2^-30, degree 10, 66.5 bits */
    {0x1.f608af4419c8fp-1, -0x1.8d2a7a7164fd7p-56, -0x1.42808017a48bep-9, 0x1.4c5499f4c8f1ep-11, -0x1.ff87544d09d49p-13,
     0x1.cae05fcdbd1bap-14, -0x1.bec23bea2081fp-15, 0x1.c9c296b4acbf3p-16, -0x1.e5b86ef6d6f2p-17, 0x1.085644e9442d7p-17,
     -0x1.26428572c4117p-18, 0x1.4b92f916473bfp-19}, /* [84] 1.5 <= y <= 1.625 2^-30, degree 10, 66.9 bits */
    {0x1.f5e19c64c6ef8p-1, -0x1.d8fc231342cp-57, -0x1.2f20348ed7b7p-9, 0x1.2141337744216p-11, -0x1.9c427c3a3827fp-13,
     0x1.566ffa43af113p-14, -0x1.34b3dff0c0236p-15, 0x1.24e095f8847ebp-16, -0x1.1fbfc9d2d8294p-17,
     0x1.21ff6d564a3bdp-18, -0x1.2ac7a389ba3d2p-19, 0x1.37ba2b739f1f6p-20},
     /* [85] 1.625 <= y <= 1.75 2^-30, degree 10, 69.2 bits */
    {0x1.f5bccd5f7102bp-1, -0x1.b5570462f2e35p-55, -0x1.1e2d547675e2fp-9, 0x1.fc8b6bde27fcbp-12, -0x1.516b255a09af4p-13,
     0x1.04f28173224e9p-14, -0x1.b60a094ffc94p-16, 0x1.82ed17c32b97ap-17, -0x1.61efcd814d1ebp-18, 0x1.4c1ab6a6f2ccp-19,
     -0x1.3e738f3925d74p-20, 0x1.355610cafe7ffp-21}, /* [86] 1.75 <= y <= 1.875 2^-30, degree 10, 66.5 bits */
    {0x1.f599fbeb3b92ap-1, 0x1.c085657a5a093p-56, -0x1.0f36bb10d8cc3p-9, 0x1.c2e69f4d0f22dp-12, -0x1.17e0ffaa1db09p-13,
     0x1.94f977a2c59f6p-15, -0x1.3dfac34e99d1cp-16, 0x1.06c1cc657f7dep-17, -0x1.c1b2cb1c06aaep-19,
     0x1.8abcf42dc0681p-20, -0x1.61fd154f98d1dp-21, 0x1.41abcebc6d5f1p-22},
     /* [87] 1.875 <= y <= 2 2^-30, degree 10, 65.9 bits */
    {0x1.f56901446689ep-1, -0x1.5a00bc5e3a68ep-55, -0x1.f78a331a5e7f2p-9, 0x1.7db093d36079ep-10, -0x1.b00bea3a95506p-11,
     0x1.1d010f29f5149p-11, -0x1.9813cfcb8abd3p-12, 0x1.33753d9e45e14p-12, -0x1.dfc54c1bdbb5fp-13,
     0x1.7ffa9489ae0cdp-13, -0x1.3b75a374cbc53p-13, 0x1.05654e57ca8abp-13},
     /* [88] 1 <= y <= 1.125 2^-29, degree 10, 65.4 bits */
    {0x1.f52cd9746e747p-1, 0x1.98c810e146f34p-56, -0x1.cc641685338ap-9, 0x1.384bad7af1c63p-10, -0x1.3c4d9e5110858p-11,
     0x1.7563bf18b0641p-12, -0x1.de5cf160be382p-13, 0x1.427adc7aeaa5ep-13, -0x1.c23ff131fdd6fp-14,
     0x1.426c6e6f68117p-14, -0x1.d95ea69319a29p-15, 0x1.5ef231eb1652fp-15},
     /* [89] 1.125 <= y <= 1.25 2^-29, degree 10, 67.5 bits */
    {0x1.f4f598b2e370fp-1, 0x1.0a4859adf4e04p-57, -0x1.a8baad0c4e725p-9, 0x1.04b426e574b5bp-10, -0x1.ddd3743f45f92p-12,
     0x1.fe5b81f5992fdp-13, -0x1.27ca013d02a4dp-13, 0x1.68d361ea0f96ep-14, -0x1.c7d0acd38beaap-15,
     0x1.275336f6493f6p-15, -0x1.87e7d19e0a857p-16, 0x1.06dfeab52fe57p-16},
     /* [90] 1.25 <= y <= 1.375 2^-29, degree 10, 66.1 bits */
    {0x1.f4c26ec4579fdp-1, -0x1.128cbd105aac2p-55, -0x1.8ab664f900307p-9, 0x1.ba7b21938f22bp-11, -0x1.72409143ad50ap-12,
     0x1.6914be35c7d97p-13, -0x1.7e280e24a5e06p-14, 0x1.a9a6a1905b7c1p-15, -0x1.eaf470538c63dp-16,
     0x1.226f3c3e835e1p-16, -0x1.5fa4723e9b08dp-17, 0x1.aeb5dbbb87e05p-18},
     /* [91] 1.375 <= y <= 1.5 2^-29, degree 10, 66.0 bits */
    {0x1.f492bca1904ffp-1, 0x1.8677357b60b8cp-59, -0x1.711062e746abep-9, 0x1.7cad500ee10dp-11, -0x1.2510df9d4c797p-12,
     0x1.06f2bfbf757f6p-13, -0x1.00094b45f85b2p-14, 0x1.065d986790034p-15, -0x1.166960ca263c7p-16,
     0x1.2f0cfa6d249dep-17, -0x1.515f929dd6fb9p-18, 0x1.7c2be87231029p-19},
     /* [92] 1.5 <= y <= 1.625 2^-29, degree 10, 66.4 bits */
    {0x1.f46605e95db9ap-1, -0x1.36dc37ee30a08p-55, -0x1.5ade9b4ba61d1p-9, 0x1.4b51e1502a1bbp-11, -0x1.d85dcf4003ef3p-13,
     0x1.886fd36c6c53cp-14, -0x1.61d235af16b21p-15, 0x1.4fb6efc3281a9p-16, -0x1.49dc743261314p-17,
     0x1.4c7595bb226adp-18, -0x1.568b923c62ac5p-19, 0x1.6567baa442aedp-20},
     /* [93] 1.625 <= y <= 1.75 2^-29, degree 10, 66.0 bits */
    {0x1.f43be75eae9bdp-1, 0x1.0b0b4c8c32744p-56, -0x1.4774d97cf97acp-9, 0x1.233ce1d9fb7bfp-11, -0x1.82995fe69d047p-13,
     0x1.2b09b6bf7ebacp-14, -0x1.f60b634e8f7c2p-16, 0x1.bb816813aea02p-17, -0x1.95b914d370e51p-18,
     0x1.7cb852d79bc55p-19, -0x1.6d167d03deab3p-20, 0x1.62a76715d1991p-21},
     /* [94] 1.75 <= y <= 1.875 2^-29, degree 10, 67.0 bits */
    {0x1.f4141079ab688p-1, 0x1.5c26f002b9319p-57, -0x1.365174159e629p-9, 0x1.02372fe832e5fp-11, -0x1.40a953282952cp-13,
     0x1.d012dcf92646cp-15, -0x1.6c6e41c164b2cp-16, 0x1.2d2ba41acb003p-17, -0x1.01bd9ad3c5788p-18,
     0x1.c4828d725b53dp-20, -0x1.95d184447bb48p-21, 0x1.70c9438313432p-22},
     /* [95] 1.875 <= y <= 2 2^-29, degree 10, 67.8 bits */
    {0x1.f3dc06816bb68p-1, 0x1.c03cb0fa90d04p-60, -0x1.200c9263a5a41p-8, 0x1.b523094e87c3cp-10, -0x1.eefa3dab87a9ep-11,
     0x1.4694a3bf4f9fbp-11, -0x1.d3ab79cf1e51cp-12, 0x1.6064471e2777cp-12, -0x1.12f71996b016p-12, 0x1.b828aa0ea3d6fp-13,
     -0x1.69a26bcdafdc6p-13, 0x1.2babd831918abp-13}, /* [96] 1 <= y <= 1.125 2^-28, degree 10, 64.3 bits */
    {0x1.f39734730e87p-1, 0x1.1c7fdc662d8ap-56, -0x1.0757690de1a36p-8, 0x1.65a323d47dcbap-10, -0x1.6a5a60a7baf7fp-11,
     0x1.abd5e69d657a7p-12, -0x1.121853d9ab20ap-12, 0x1.719710320f249p-13, -0x1.020892cf912f5p-13,
     0x1.719465803d528p-14, -0x1.0f510a3944434p-14, 0x1.9250dc106d7cp-15},
     /* [97] 1.125 <= y <= 1.25 2^-28, degree 10, 65.2 bits */
    {0x1.f357ffac3c484p-1, -0x1.9e4d2eb78a5c8p-56, -0x1.e5d840a6239d1p-9, 0x1.2a892c6862b3ep-10, -0x1.11ae2c1192457p-11,
     0x1.245f57790021bp-12, -0x1.52f2eb59b2172p-13, 0x1.9d84a76195b1ap-14, -0x1.053607584628dp-14,
     0x1.5280c025ea396p-15, -0x1.c13ad1fe8cecep-16, 0x1.2d571faa331d5p-16},
     /* [98] 1.25 <= y <= 1.375 2^-28, degree 10, 67.3 bits */
    {0x1.f31d79a219c27p-1, 0x1.8848cc6514762p-58, -0x1.c3791e8784dedp-9, 0x1.faa970c90f36cp-11, -0x1.a81c3de961327p-12,
     0x1.9db0c886e3ce7p-13, -0x1.b5e6030510c6p-14, 0x1.e7c9e404621d8p-15, -0x1.19562210a187bp-15, 0x1.4ce23d09e0fd7p-16,
     -0x1.930faa695ff53p-17, 0x1.edb73763f31e4p-18}, /* [99] 1.375 <= y <= 1.5 2^-28, degree 10, 67.2 bits */
    {0x1.f2e6ec2a0f2eep-1, -0x1.251d9e3ff3cacp-57, -0x1.a61aee1fdc8bbp-9, 0x1.b3de8ed0797ffp-11, -0x1.4fae0c778e8d8p-12,
     0x1.2d3f07f617f3dp-13, -0x1.255ea3ecdaad8p-14, 0x1.2ca779f15d798p-15, -0x1.3f11aff3a92a4p-16,
     0x1.5b54a30aa83c5p-17, -0x1.82b0f748007cep-18, 0x1.b3c49e1b42886p-19},
     /* [100] 1.5 <= y <= 1.625 2^-28, degree 10, 68.4 bits */
    {0x1.f2b3c8cbfc553p-1, 0x1.899d9289d1f24p-56, -0x1.8cb18b7deecdfp-9, 0x1.7b56296c29283p-11, -0x1.0e837e398002fp-12,
     0x1.c19356fd58eb5p-14, -0x1.956584ddb194ep-15, 0x1.80b155401bbdap-16, -0x1.7a049afeccd47p-17,
     0x1.7d05c8049ef22p-18, -0x1.889aff99dcccp-19, 0x1.99a88b8e01a7bp-20},
     /* [101] 1.625 <= y <= 1.75 2^-28, degree 10, 66.4 bits */
    {0x1.f2839ddd51dadp-1, -0x1.b9429068e0944p-56, -0x1.7677ae0675e6ap-9, 0x1.4d6dec6ab782bp-11, -0x1.bac62ecf5b5eep-13,
     0x1.56906a9bde7fep-14, -0x1.1f9a24ce5a919p-15, 0x1.fc30ea768ff4ap-17, -0x1.d0f05367b5b0bp-18, 0x1.b4516fbf4653p-19,
     -0x1.a26dc30142a1bp-20, 0x1.967de6270f7c4p-21}, /* [102] 1.75 <= y <= 1.875 2^-28, degree 10, 70.7 bits */
    {0x1.f2560f220f93ep-1, -0x1.5fac742536f4cp-55, -0x1.62d8cc07e48aep-9, 0x1.279c0d581a1b9p-11, -0x1.6f3d86eb6643bp-13,
     0x1.09ccf9f67b521p-14, -0x1.a1859d9a33f76p-16, 0x1.5915a7632489p-17, -0x1.2759361017f7dp-18, 0x1.0349a1fed2961p-19,
     -0x1.d118832959756p-21, 0x1.a6ad451e7de68p-22}, /* [103] 1.875 <= y <= 2 2^-28, degree 10, 65.9 bits */
    {0x1.f215fb524154dp-1, -0x1.0286f0f492006p-58, -0x1.495a8a1c3154ap-8, 0x1.f468c15c5291p-10, -0x1.1b6c2191f1cp-10,
     0x1.7614e8f770dd1p-11, -0x1.0be31a83b0dcbp-11, 0x1.93c148672a27cp-12, -0x1.3b125ce475028p-12,
     0x1.f865ee8ca94a7p-13, -0x1.9e709ea50a40bp-13, 0x1.577296a61420ep-13},
     /* [104] 1 <= y <= 1.125 2^-27, degree 10, 64.3 bits */
    {0x1.f1c74c0416467p-1, -0x1.2d0366c18267p-56, -0x1.2d12242c1d32p-8, 0x1.995eb30b3ae15p-10, -0x1.9eef501dd6019p-11,
     0x1.ea0831b11f8d6p-12, -0x1.39fd9cb2f7425p-12, 0x1.a76f60c61a36bp-13, -0x1.27a746b641c8ap-13,
     0x1.a77eab8058badp-14, -0x1.36eac6ee4d03p-14, 0x1.cd0ff3c3fa2b8p-15},
     /* [105] 1.125 <= y <= 1.25 2^-27, degree 10, 64.8 bits */
    {0x1.f17f09e62e589p-1, 0x1.d32318f8d7edcp-58, -0x1.15b2f0c2c86d6p-8, 0x1.55b1bcd377cb4p-10, -0x1.395fd0f318562p-11,
     0x1.4edb1601305ecp-12, -0x1.84431ddd1b441p-13, 0x1.d9bcb5d0e5a2cp-14, -0x1.2b474d5c0a3c7p-14,
     0x1.83dd605a5a274p-15, -0x1.0162dd8a3361ep-15, 0x1.5953544f9bf63p-16},
     /* [106] 1.25 <= y <= 1.375 2^-27, degree 10, 66.2 bits */
    {0x1.f13c23d21938p-1, 0x1.ec996f3440903p-56, -0x1.0207829e28c29p-8, 0x1.21ef3b5ad4455p-10, -0x1.e597cb1410a1bp-12,
     0x1.d9c69363d00acp-13, -0x1.f594d16d50056p-14, 0x1.1765c4ed2bd36p-14, -0x1.425239b1484afp-15,
     0x1.7d687b566add3p-16, -0x1.cdd8b72cd73c2p-17, 0x1.1ae0b4c87d0b5p-17},
     /* [107] 1.375 <= y <= 1.5 2^-27, degree 10, 66.3 bits */
    {0x1.f0fdc932e23f2p-1, 0x1.87201e00fe1dap-56, -0x1.e272cdfd80891p-9, 0x1.f2d0e6f4f7dp-11, -0x1.80523cd41dd2ep-12,
     0x1.58fb53d91e2a4p-13, -0x1.500473598276ep-14, 0x1.586752b05a67cp-15, -0x1.6d88b7296104p-16, 0x1.8df180cb34dbdp-17,
     -0x1.bb11f06a27047p-18, 0x1.f354e14b17baap-19}, /* [108] 1.5 <= y <= 1.625 2^-27, degree 10, 66.9 bits */
    {0x1.f0c356ea23c65p-1, 0x1.6fe21766f3dffp-55, -0x1.c55e2799cb547p-9, 0x1.b217d2fb5bad4p-11, -0x1.35b21fcb03da2p-12,
     0x1.01690ad672eap-13, -0x1.d04eeecd669c4p-15, 0x1.b8a6c12559bd9p-16, -0x1.b10c8aa4837dfp-17, 0x1.b486df7dea7acp-18,
     -0x1.c1d4121e76c05p-19, 0x1.d56519c98b991p-20}, /* [109] 1.625 <= y <= 1.75 2^-27, degree 10, 67.6 bits */
    {0x1.f08c4ad597b71p-1, -0x1.36cf829bfb599p-55, -0x1.abef264e6667ap-9, 0x1.7d89ad5ab7ae1p-11, -0x1.fae1c296389e5p-13,
     0x1.8842d03a24badp-14, -0x1.4961bc0690a61p-15, 0x1.230b8351e9439p-16, -0x1.0a4d109ff0a5ep-17, 0x1.f3db9db01ac2p-19,
     -0x1.df65b2e6f2562p-20, 0x1.d1bfd1f1f636dp-21}, /* [110] 1.75 <= y <= 1.875 2^-27, degree 10, 68.4 bits */
    {0x1.f0583b5dcd33cp-1, 0x1.1f698d6d730fap-55, -0x1.957bb2c38010bp-9, 0x1.523e41c7396dep-11, -0x1.a4645779d7a5p-13,
     0x1.305912e3df0d5p-14, -0x1.de27b82180e3bp-16, 0x1.8b3fe72c70c8ap-17, -0x1.5251716d63cbbp-18,
     0x1.2909359ff9fa9p-19, -0x1.0a6c23d868d27p-20, 0x1.e446d8b7ef4b9p-22},
     /* [111] 1.875 <= y <= 2 2^-27, degree 10, 69.8 bits */
    {0x1.f00f03af7ee68p-1, 0x1.f3bbd9234a7b8p-56, -0x1.78507b651e563p-8, 0x1.1e44afda8c811p-9, -0x1.446bd8d500fbep-10,
     0x1.ac4e4bcd36b8ep-11, -0x1.32c5b4cd5167cp-11, 0x1.ce6c5a50f57d9p-12, -0x1.68e43a869670bp-12,
     0x1.20e681e2d3641p-12, -0x1.dac94ee295894p-13, 0x1.897b496ad3f8p-13},
     /* [112] 1 <= y <= 1.125 2^-26, degree 10, 64.3 bits */
    {0x1.efb51dad706c4p-1, -0x1.c2703cbde59bbp-55, -0x1.57f4d9b59332bp-8, 0x1.d454fe8a5f8fcp-10, -0x1.daeb4661504fp-11,
     0x1.1882b1efd26fcp-11, -0x1.678ad3780c74fp-12, 0x1.e4ee0589e14a5p-13, -0x1.52a07e9767d8p-13, 0x1.e517cc3145564p-14,
     -0x1.642ad9f7d30b4p-14, 0x1.08196516016f8p-14}, /* [113] 1.125 <= y <= 1.25 2^-26, degree 10, 64.7 bits */
    {0x1.ef6291d2b7aeep-1, 0x1.868213205bb6ap-55, -0x1.3d382ab3c5a9fp-8, 0x1.86e0342627565p-10, -0x1.66a65095cf442p-11,
     0x1.7f56a1a0e287ap-12, -0x1.bc8f31980a2d1p-13, 0x1.0f4061dee13f5p-13, -0x1.56c215c2d8defp-14,
     0x1.bc411a463ef63p-15, -0x1.26d42ad66a4cp-15, 0x1.8b9637e99f4edp-16},
     /* [114] 1.25 <= y <= 1.375 2^-26, degree 10, 67.5 bits */
    {0x1.ef16277eb20eap-1, -0x1.be6deead51c1bp-56, -0x1.26b83057f9ab5p-8, 0x1.4ba3d0f8f70f5p-10, -0x1.15db0a82c34adp-11,
     0x1.0f2b23a3fea86p-12, -0x1.1f2322f8537c7p-13, 0x1.3fef644af68a5p-14, -0x1.7120b207be902p-15,
     0x1.b4d5cd674119bp-16, -0x1.08808e02109aap-16, 0x1.44087959dcb31p-17},
     /* [115] 1.375 <= y <= 1.5 2^-26, degree 10, 65.4 bits */
    {0x1.eeceeffba37bdp-1, -0x1.32d779b0fd843p-59, -0x1.137f6cf5f68dbp-8, 0x1.1d4351f91bc6p-10, -0x1.b7c9a05793ccap-12,
     0x1.8ae196561294ap-13, -0x1.80b19e34a7761p-14, 0x1.8a59f566007cep-15, -0x1.a29805266645ap-16,
     0x1.c7c00909d9906p-17, -0x1.fb78ed085cbc5p-18, 0x1.1df9aeba8a092p-18},
     /* [116] 1.5 <= y <= 1.625 2^-26, degree 10, 65.2 bits */
    {0x1.ee8c309eb842p-1, 0x1.ecba5f3deea9dp-56, -0x1.02de1f828a0eap-8, 0x1.f076d405570e4p-11, -0x1.625ed0f90a5a5p-12,
     0x1.26a0602d7642ap-13, -0x1.09c53e4ca1635p-14, 0x1.f8882b6252e4ap-16, -0x1.efe274ceebd2bp-17,
     0x1.f3ea1d5fdb23ep-18, -0x1.0198331dc5a66p-18, 0x1.0cd161fedd55p-19},
     /* [117] 1.625 <= y <= 1.75 2^-26, degree 10, 66.1 bits */
    {0x1.ee4d547eb0517p-1, 0x1.5b7ff45e009ffp-57, -0x1.e8a5f83c0bae8p-9, 0x1.b4544fa1a29afp-11, -0x1.21fbe0803a919p-12,
     0x1.c0f3262ce084dp-14, -0x1.790ecd5e1d9c3p-15, 0x1.4d38a30bb854p-16, -0x1.30ed6143cbd14p-17, 0x1.1e353f2304948p-18,
     -0x1.1283de05783a3p-19, 0x1.0ab7f9c452bb9p-20}, /* [118] 1.75 <= y <= 1.875 2^-26, degree 10, 67.2 bits */
    {0x1.ee11e2c989223p-1, 0x1.1e67e21847f46p-55, -0x1.cef957e99abafp-9, 0x1.82cb23f168d96p-11, -0x1.e0fb1e1b009fcp-13,
     0x1.5c506ccc35df5p-14, -0x1.11ab696e712c9p-15, 0x1.c48180be171cep-17, -0x1.835f8a727c187p-18,
     0x1.54237247fc303p-19, -0x1.311b9de1cb8bap-20, 0x1.1551439026a25p-21},
     /* [119] 1.875 <= y <= 2 2^-26, degree 10, 66.5 bits */
    {0x1.edbe4acd0532ap-1, 0x1.57b70d848f57p-55, -0x1.ad9eabddec23cp-8, 0x1.475478b9a7f0bp-9, -0x1.732666c6c695dp-10,
     0x1.ea24ed580f434p-11, -0x1.5f22aadf8df2ep-11, 0x1.08b02b75ba0dfp-11, -0x1.9d31ad990ae6bp-12,
     0x1.4acd7070b61d1p-12, -0x1.0fd907a5ff826p-12, 0x1.c29f82b0e962fp-13},
     /* [120] 1 <= y <= 1.125 2^-25, degree 10, 64.3 bits */
    {0x1.ed57aab26ca32p-1, -0x1.5e39a647118b5p-58, -0x1.889f59a0b415cp-8, 0x1.0bb9c78449823p-9, -0x1.0fa30b9dac86cp-10,
     0x1.40fb7a6d82db8p-11, -0x1.9b80acc9e805dp-12, 0x1.158c7f795583bp-12, -0x1.83ac57c661b2p-13, 0x1.15b472a4caceap-13,
     -0x1.97d4c638eff42p-14, 0x1.2e6e338955d88p-14}, /* [121] 1.125 <= y <= 1.25 2^-25, degree 10, 64.9 bits */
    {0x1.ecf9727f67d3dp-1, -0x1.9094903f444e6p-55, -0x1.6a0e178a2f4a1p-8, 0x1.bed9c6a2f282cp-10, -0x1.9a3bf7e4d034dp-11,
     0x1.b69c62c372d04p-12, -0x1.fcc47ddcea7edp-13, 0x1.367a6afa3d417p-13, -0x1.886012d7b2dc3p-14,
     0x1.fc9de3faaf2a2p-15, -0x1.51929d8e0852fp-15, 0x1.c4f90b7393fb1p-16},
     /* [122] 1.25 <= y <= 1.375 2^-25, degree 10, 65.7 bits */
    {0x1.eca23c97b2fp-1, -0x1.74570790bf779p-56, -0x1.50558ed6c4b89p-8, 0x1.7b18f895f2ac2p-10, -0x1.3dcb45f788e99p-11,
     0x1.363e9218019b5p-12, -0x1.4895ed84d354fp-13, 0x1.6e2d6ebb987e2p-14, -0x1.a688dcf453bdep-15,
     0x1.f4175bf8ed62cp-16, -0x1.2ed4ae8fe1482p-16, 0x1.73045497c55edp-17},
     /* [123] 1.375 <= y <= 1.5 2^-25, degree 10, 66.5 bits */
    {0x1.ec50f7f29b3e1p-1, 0x1.2e2d46e7a6cb9p-55, -0x1.3a5cde86040edp-8, 0x1.460e7120813e4p-10, -0x1.f6f6c99e93fc2p-12,
     0x1.c3c0bfba960fcp-13, -0x1.b8321444ac0c3p-14, 0x1.c3523c9e3ef0bp-15, -0x1.df20ee2932c3ep-16,
     0x1.04db75dac8bbdp-16, -0x1.227cf27ffbf43p-17, 0x1.476c2c93b7745p-18},
     /* [124] 1.5 <= y <= 1.625 2^-25, degree 10, 65.0 bits */
    {0x1.ec04cf12544abp-1, -0x1.5a8a98fe9dd01p-57, -0x1.275af37816ca7p-8, 0x1.1bb5197ea7199p-10, -0x1.953f73da7952dp-12,
     0x1.51098aac12986p-13, -0x1.301887f2bb3dbp-14, 0x1.20b142daa5ffep-15, -0x1.1bc840a5d71aap-16,
     0x1.1e1eab15af10cp-17, -0x1.26e3b0f880d6bp-18, 0x1.33c3263e9a7f8p-19},
     /* [125] 1.625 <= y <= 1.75 2^-25, degree 10, 67.7 bits */
    {0x1.ebbd17aaca087p-1, -0x1.bd072f875caf6p-55, -0x1.16bbe3bbb4fecp-8, 0x1.f2a60a02d9b25p-11, -0x1.4b986428482ccp-12,
     0x1.00c591217191p-13, -0x1.af67fdd4482f9p-15, 0x1.7d50f1c9b69f9p-16, -0x1.5cfc51cba381bp-17, 0x1.47991ab45bd52p-18,
     -0x1.3a3e6ce185881p-19, 0x1.3158047d4e9cfp-20}, /* [126] 1.75 <= y <= 1.875 2^-25, degree 10, 69.8 bits */
    {0x1.eb7947925d87dp-1, 0x1.a312f75fef74bp-55, -0x1.0810563d0b5d6p-8, 0x1.ba019f9ebd63fp-11, -0x1.12fb82866621fp-12,
     0x1.8e67cb9eea45p-14, -0x1.39193a035e05p-15, 0x1.02e5282d126efp-16, -0x1.bb524d553b6e2p-18, 0x1.854efb920b285p-19,
     -0x1.5d3f522113448p-20, 0x1.3d766cf71379ep-21}, /* [127] 1.875 <= y <= 2 2^-25, degree 10, 67.4 bits */
    {0x1.eb19eda01f5f9p-1, 0x1.a65df3dace7abp-56, -0x1.ea03a1416759dp-8, 0x1.760469a74559cp-9, -0x1.a858140442ecbp-10,
     0x1.184b092bb823ep-10, -0x1.91b1b1d228cb4p-11, 0x1.2eda6262ff398p-11, -0x1.d8d67a72d3cffp-12,
     0x1.7a98c1173063ep-12, -0x1.37279f9d1f9b7p-12, 0x1.01e94fdf3758ep-12},
     /* [128] 1 <= y <= 1.125 2^-24, degree 10, 64.1 bits */
    {0x1.eaa4e2be2fd33p-1, 0x1.85fbd703035cbp-56, -0x1.bfbe0fd6772f1p-8, 0x1.31dfb9c42b5f4p-9, -0x1.3688df83d629ap-10,
     0x1.6f136b0102708p-11, -0x1.d6b55f023e095p-12, 0x1.3d8a01d19cfe2p-12, -0x1.bb98131bfaa57p-13,
     0x1.3dcce97c49c95p-13, -0x1.d2c2eb860774ap-14, 0x1.5a290c3b43f46p-14},
     /* [129] 1.125 <= y <= 1.25 2^-24, degree 10, 66.4 bits */
    {0x1.ea397266aa70ep-1, -0x1.1624bbec60cc7p-56, -0x1.9cd247c70af28p-8, 0x1.fe76f24d034f6p-10, -0x1.d4ee8be338267p-11,
     0x1.f58ca99a1babcp-12, -0x1.22f550a7313b7p-12, 0x1.632ee831ad1ecp-13, -0x1.c0f022f4e0dbbp-14,
     0x1.2300c98219c3dp-14, -0x1.8252405df5e5fp-15, 0x1.03373ed0a88eap-15},
     /* [130] 1.25 <= y <= 1.375 2^-24, degree 10, 64.8 bits */
    {0x1.e9d603cc4cb0dp-1, 0x1.c168d2748a92ap-57, -0x1.7f70c1b429ff4p-8, 0x1.b1054982034c8p-10, -0x1.6b3b30f68c5adp-11,
     0x1.62bb8436cca1ep-12, -0x1.77cc4eb6f33dfp-13, 0x1.a2deb23c5d43fp-14, -0x1.e368a012b5d1bp-15,
     0x1.1e1abb183bf1dp-15, -0x1.5a89a8d6bc184p-16, 0x1.a89a573db209fp-17},
     /* [131] 1.375 <= y <= 1.5 2^-24, degree 10, 65.3 bits */
    {0x1.e9795ed89782ap-1, -0x1.f801128f874a2p-56, -0x1.665851820a508p-8, 0x1.7465ff5a660e6p-10, -0x1.1f69c56eb6778p-11,
     0x1.023ee563d5a87p-12, -0x1.f7680677aef26p-14, 0x1.021d36cff93c1p-14, -0x1.120f12102bf85p-15,
     0x1.2a747600d82a8p-16, -0x1.4c64411de247ap-17, 0x1.76b01fce350ebp-18},
     /* [132] 1.5 <= y <= 1.625 2^-24, degree 10, 65.1 bits */
    {0x1.e9228f89e8782p-1, -0x1.968c27a4e75e5p-55, -0x1.50a310ae6a7f2p-8, 0x1.4400292db7f39p-10, -0x1.cf1c6be621442p-12,
     0x1.814eae2493d8bp-13, -0x1.5bbcfe5127848p-14, 0x1.4a30385f474fbp-15, -0x1.449f50ad7a349p-16,
     0x1.4756741d38d36p-17, -0x1.51682b2e9d2c8p-18, 0x1.602b15bb73271p-19},
     /* [133] 1.625 <= y <= 1.75 2^-24, degree 10, 66.8 bits */
    {0x1.e8d0d3411272ap-1, -0x1.0a4a7c58092fep-59, -0x1.3da7e44b402ebp-8, 0x1.1cb5a7f4cffa4p-10, -0x1.7ae9b320bcb34p-12,
     0x1.258681bacc8bcp-13, -0x1.ed49579731f8ap-15, 0x1.b418fba597357p-16, -0x1.8f2f42721935dp-17,
     0x1.76c4cbcac66a2p-18, -0x1.6787e458e5299p-19, 0x1.5d6181c7f6a61p-20},
     /* [134] 1.75 <= y <= 1.875 2^-24, degree 10, 65.9 bits */
    {0x1.e8838c1b9ed5p-1, -0x1.8aab69c3523a8p-55, -0x1.2ce781ce3239cp-8, 0x1.f8b2523e786a6p-11, -0x1.3a32e1d43daebp-12,
     0x1.c766ccde17f9fp-14, -0x1.65fc74b420286p-15, 0x1.28122ea55eff6p-16, -0x1.fb0f6ad563abep-18,
     0x1.bd56ea24912a7p-19, -0x1.8f8e8234b7ab7p-20, 0x1.6b3a50becf5b4p-21},
     /* [135] 1.875 <= y <= 2 2^-24, degree 10, 65.9 bits */
    {0x1.e816e6c7509b9p-1, 0x1.baaa96a5384d5p-55, -0x1.1725604bad70fp-7, 0x1.ab03df8d60cd8p-9, -0x1.e4cfcebc3f7ep-10,
     0x1.405c93ea7c3cfp-10, -0x1.cb3dfd8b6e8fdp-11, 0x1.5a4fb54223bc5p-11, -0x1.0e63453327ee7p-11,
     0x1.b10d20a96fe3ep-12, -0x1.63f30b377a075p-12, 0x1.2711c865dd4c7p-12},
     /* [136] 1 <= y <= 1.125 2^-23, degree 10, 63.6 bits */
    {0x1.e7919023b43f1p-1, -0x1.16cc025299e09p-55, -0x1.fe08a3d05033fp-8, 0x1.5d2a94b81f2f4p-9, -0x1.62bd7e2fc8759p-10,
     0x1.a38051dbdbcd1p-11, -0x1.0d0ace7ea579ap-11, 0x1.6b110576d5826p-12, -0x1.fb4747cec188ap-13,
     0x1.6b798652773c3p-13, -0x1.0af3fe09de0ffp-13, 0x1.8bfedd0e4da61p-14},
     /* [137] 1.125 <= y <= 1.25 2^-23, degree 10, 65.8 bits */
    {0x1.e71730079f155p-1, 0x1.351f34877515fp-56, -0x1.d62c34e966cadp-8, 0x1.2351a823c7e9dp-9, -0x1.0bcfd3a7e8376p-10,
     0x1.1e8f34175ad9p-11, -0x1.4c924f792a2d1p-12, 0x1.96118900d1dcp-13, -0x1.00abba8724866p-13, 0x1.4ccbbd1de68efp-14,
     -0x1.b9db02449caedp-15, 0x1.2882263a36a03p-15}, /* [138] 1.25 <= y <= 1.375 2^-23, degree 10, 67.3 bits */
    {0x1.e6a5f37a0a28dp-1, -0x1.6fccb46f434bdp-55, -0x1.b4a3bf00c2664p-8, 0x1.ee2f36970acb7p-10, -0x1.9ed87e0864b98p-11,
     0x1.954fad363495cp-12, -0x1.ad813f3a38b38p-13, 0x1.ded60f06775ebp-14, -0x1.145acee7904ep-14, 0x1.472a89e5f48b8p-15,
     -0x1.8c520dacd0061p-16, 0x1.e5a67edfb2d39p-17}, /* [139] 1.375 <= y <= 1.5 2^-23, degree 10, 65.7 bits */
    {0x1.e63c760613ee1p-1, -0x1.b6cb218bac5dp-59, -0x1.9800455166243p-8, 0x1.a8f38694d6447p-10, -0x1.48389be09d769p-11,
     0x1.270a29787636p-12, -0x1.1fa65b7c89dc5p-13, 0x1.270a9ed5032a1p-14, -0x1.39527a4d5d069p-15, 0x1.55432f98ff3f5p-16,
     -0x1.7c1cf6e4f1911p-17, 0x1.ac86e51ef27a3p-18}, /* [140] 1.5 <= y <= 1.625 2^-23, degree 10, 65.6 bits */
    {0x1.e5d9a1010232dp-1, -0x1.9640c3f7b5851p-57, -0x1.7f3b1c541f941p-8, 0x1.71af2f00f6448p-10, -0x1.086860a290e73p-11,
     0x1.b82a953ee56cbp-13, -0x1.8d5e084200544p-14, 0x1.7965ba19cb267p-15, -0x1.7319f9a81b82cp-16,
     0x1.7642a57efdaa3p-17, -0x1.81d21f806b0c8p-18, 0x1.92be40fae2ce6p-19},
     /* [141] 1.625 <= y <= 1.75 2^-23, degree 10, 69.1 bits */
    {0x1.e57c962bf761p-1, 0x1.3851927e5e223p-55, -0x1.699312fd7db4ap-8, 0x1.44d21d18d6d48p-10, -0x1.b0a21b42ce67bp-12,
     0x1.4f4a09c676577p-13, -0x1.19d27a6fd4b96p-14, 0x1.f2697bf56aa3ap-16, -0x1.c84e8c077b3bfp-17, 0x1.ac75ee637649p-18,
     -0x1.9b17674530a57p-19, 0x1.8f877180ab929p-20}, /* [142] 1.75 <= y <= 1.875 2^-23, degree 10, 67.6 bits */
    {0x1.e524a13fe91dap-1, 0x1.71a9be6d48ca9p-55, -0x1.5676c0801af74p-8, 0x1.1fdf79143024cp-10, -0x1.66b6d127195cbp-12,
     0x1.04141ecb69ee3p-13, -0x1.99041532093bbp-15, 0x1.525a66e2b64d1p-16, -0x1.21ca38034f216p-17,
     0x1.fd1bc1a31a0e6p-19, -0x1.c8d4013b71c6fp-20, 0x1.9f5667c2134e9p-21},
     /* [143] 1.875 <= y <= 2 2^-23, degree 10, 64.9 bits */
    {0x1.e4a8fd455801cp-1, 0x1.b476cfa345d14p-55, -0x1.3da4e56f0daa8p-7, 0x1.e7104e756ab7fp-9, -0x1.14b78b4a68e1fp-9,
     0x1.6de00fa2b0364p-10, -0x1.06535efcd2139p-10, 0x1.8bbaa7b0a3e59p-11, -0x1.35076f1ca9ee6p-11,
     0x1.ef03c8cc9a0d1p-12, -0x1.96ef1ce5e8ffp-12, 0x1.515f224778b6p-12},
     /* [144] 1 <= y <= 1.125 2^-22, degree 10, 64.1 bits */
    {0x1.e41147374b8a9p-1, -0x1.81d0315474a81p-55, -0x1.221fc3f03afa3p-7, 0x1.8e33bc41af2dfp-9, -0x1.94e484a141d6bp-10,
     0x1.df08f7e759818p-11, -0x1.3352863a95c0cp-11, 0x1.9ed31a66cc0d5p-12, -0x1.21da56ec51d83p-12,
     0x1.9f6f7b6bfdb66p-13, -0x1.31280966977dcp-13, 0x1.c4b7bc6b4e6aap-14},
     /* [145] 1.125 <= y <= 1.25 2^-22, degree 10, 64.7 bits */
    {0x1.e38611d98a714p-1, 0x1.ceb3ca597afe9p-55, -0x1.0b657142c5ca5p-7, 0x1.4c2e3fac62833p-9, -0x1.31a2344667826p-10,
     0x1.472fa428c9af4p-11, -0x1.7bd8a831525b7p-12, 0x1.cfe7a9346281ep-13, -0x1.25491f23a6b3ap-13,
     0x1.7c54c0e7baa0cp-14, -0x1.f90989d1c897p-15, 0x1.52f23f0170e0fp-15},
     /* [146] 1.25 <= y <= 1.375 2^-22, degree 10, 64.1 bits */
    {0x1.e3054835db098p-1, -0x1.55b8da8c185b3p-55, -0x1.f08f0136395b9p-8, 0x1.19b60433c9021p-9, -0x1.d95fa52830edfp-11,
     0x1.ceb880fbf2ec2p-12, -0x1.ea8160a0e2697p-13, 0x1.117d72cc5d37cp-13, -0x1.3bbef0e6ab07p-14, 0x1.75dc66e0b137dp-15,
     -0x1.c4f2c0cebfb32p-16, 0x1.158dd186bcf3ap-16}, /* [147] 1.375 <= y <= 1.5 2^-22, degree 10, 65.0 bits */
    {0x1.e28d5385c6efcp-1, 0x1.7ee857a9a4a87p-55, -0x1.cfe8e4c1af14fp-8, 0x1.e46cf602075d7p-10, -0x1.767c01343dccdp-11,
     0x1.50cb3af66f9a4p-12, -0x1.4878553a735e9p-13, 0x1.50ff20f652a42p-14, -0x1.65f2f9ef902c2p-15,
     0x1.85ef0b069c393p-16, -0x1.b263005c40ef4p-17, 0x1.e9c5c1f61065fp-18},
     /* [148] 1.5 <= y <= 1.625 2^-22, degree 10, 65.1 bits */
    {0x1.e21cf5d201e5fp-1, 0x1.2b915a745e384p-55, -0x1.b3acb08363c4p-8, 0x1.a55f3e3f334d5p-10, -0x1.2da4c36e4fa33p-11,
     0x1.f66888f4c4a42p-13, -0x1.c5b6dc1fe4313p-14, 0x1.af0638e9dd7f5p-15, -0x1.a7ebb91a88a59p-16,
     0x1.ab99fa3947397p-17, -0x1.b8df6e2ecdec5p-18, 0x1.cc443533c1ab1p-19},
     /* [149] 1.625 <= y <= 1.75 2^-22, degree 10, 64.9 bits */
    {0x1.e1b3318b68522p-1, -0x1.619daa908c872p-55, -0x1.9afddeac08a48p-8, 0x1.72316a2585a4cp-10, -0x1.ed82620b0dcd2p-12,
     0x1.7eaa27f3de0acp-13, -0x1.41c182e823661p-14, 0x1.1c97cbd3c3ee2p-15, -0x1.049aee285f541p-16,
     0x1.e97cc545ccc5ep-18, -0x1.d5b6662a27856p-19, 0x1.c88ef4da5b8a2p-20},
     /* [150] 1.75 <= y <= 1.875 2^-22, degree 10, 65.9 bits */
    {0x1.e14f390a06bf2p-1, -0x1.c823708bbf1dap-56, -0x1.8536785fc73d8p-8, 0x1.480c5acd9859ap-10, -0x1.992638bf84895p-12,
     0x1.28cce208bcff1p-13, -0x1.d2eee22cd37edp-15, 0x1.825e0fd4ad465p-16, -0x1.4afb9475d10edp-17,
     0x1.22c9f5dbbbeabp-18, -0x1.04f75f0fab93bp-19, 0x1.da96cf2e4c3c3p-21},
     /* [151] 1.875 <= y <= 2 2^-22, degree 10, 65.4 bits */
    {0x1.e0c2b7fe1fb1cp-1, -0x1.bb7a5ba5b647fp-56, -0x1.68ee6ccbcefdap-7, 0x1.1579e5c716945p-8, -0x1.3b948975cb5cp-9,
     0x1.a17b68262c555p-10, -0x1.2b6f7c974bbf5p-10, 0x1.c3d56c5135237p-11, -0x1.60eaeda39c97bp-11,
     0x1.1ab570d9e05dbp-11, -0x1.d0e1476f4fb5p-12, 0x1.81763de0344bdp-12},
     /* [152] 1 <= y <= 1.125 2^-21, degree 10, 63.6 bits */
    {0x1.e0165ac6caafp-1, -0x1.196de8dc17142p-57, -0x1.499410f38143dp-7, 0x1.c59e6bc69c355p-9, -0x1.cdae083c3775p-10,
     0x1.11424dd97b695p-10, -0x1.5ebefaa90cb4bp-11, 0x1.d991dcb3c3cep-12, -0x1.4af923111025p-12, 0x1.da752d23bbd51p-13,
     -0x1.5c9098c41287ep-13, 0x1.0297afc9dc273p-13}, /* [153] 1.125 <= y <= 1.25 2^-21, degree 10, 64.0 bits */
    {0x1.df783bb4cdad1p-1, -0x1.feb67c23feb6p-56, -0x1.2fb0973f952a6p-7, 0x1.7a57e65c5e17bp-9, -0x1.5c7211bb74f06p-10,
     0x1.7539687f1875dp-11, -0x1.b1756c8381195p-12, 0x1.08c417b88b45cp-12, -0x1.4ed9e2644dcd9p-13,
     0x1.b2503740d2469p-14, -0x1.2067c281f6b31p-14, 0x1.832af8a4b23b1p-15},
     /* [154] 1.25 <= y <= 1.375 2^-21, degree 10, 66.6 bits */
    {0x1.dee5fb1c76691p-1, 0x1.1ccc84c4a5562p-55, -0x1.19eafd84a6fc5p-7, 0x1.40cedff4e393fp-9, -0x1.0dcd638b665b3p-10,
     0x1.07e140c1bc56cp-11, -0x1.17d54505a837fp-12, 0x1.38246a6eaac55p-13, -0x1.6873e77927836p-14,
     0x1.aae0810490fa6p-15, -0x1.02a1961426c92p-15, 0x1.3d01e9b9d93a8p-16},
     /* [155] 1.375 <= y <= 1.5 2^-21, degree 10, 64.4 bits */
    {0x1.de5dc943f7608p-1, -0x1.7e89264b9f17p-57, -0x1.07544d0c22382p-7, 0x1.13c95b1c3af2cp-9, -0x1.aad289794cdbap-11,
     0x1.8015d79ea9232p-12, -0x1.76bd779728e29p-13, 0x1.8094c016a1714p-14, -0x1.989664ab57f59p-15,
     0x1.bd2eb07dbdf8cp-16, -0x1.f003c116a7cbap-17, 0x1.17ab11bda42f1p-17},
     /* [156] 1.5 <= y <= 1.625 2^-21, degree 10, 64.2 bits */
    {0x1.ddde3bbcb1e8cp-1, -0x1.be3e07cb2a077p-55, -0x1.ee830db49961ap-8, 0x1.dfb62638e29fep-10, -0x1.57c21a231fefep-11,
     0x1.1e71afe690491p-12, -0x1.02c8f6368717bp-13, 0x1.ebd5796d369d5p-15, -0x1.e3d7cb101154cp-16,
     0x1.e8239dcb90157p-17, -0x1.f75f684781fb9p-18, 0x1.06cb92ee8486bp-18},
     /* [157] 1.625 <= y <= 1.75 2^-21, degree 10, 66.7 bits */
    {0x1.dd66318ba7937p-1, -0x1.acb6eee7c7489p-61, -0x1.d269dc327a0edp-8, 0x1.a563f1bae5208p-10, -0x1.192c2ab56bce4p-11,
     0x1.b44c6d2e32a7p-13, -0x1.6f0072a87890bp-14, 0x1.44b6287b0abc7p-15, -0x1.2969f3a0aca76p-16, 0x1.175e0b656a9eep-17,
     -0x1.0c204e9b2366dp-18, 0x1.04a7b393ad5c8p-19}, /* [158] 1.75 <= y <= 1.875 2^-21, degree 10, 67.8 bits */
    {0x1.dcf4c05588a13p-1, -0x1.f227bc942bd5ep-58, -0x1.b99fc8c74632bp-8, 0x1.755ead34a052ep-10, -0x1.d22a835eb7d43p-12,
     0x1.525d494bfb365p-13, -0x1.0a455866ca41ap-14, 0x1.b8caa6aa79902p-16, -0x1.79b2923e6a482p-17,
     0x1.4be5bcd7eccddp-18, -0x1.29e8d7a6133e8p-19, 0x1.0eed291344a2ap-20},
     /* [159] 1.875 <= y <= 2 2^-21, degree 10, 65.2 bits */
    {0x1.dc55587afe12dp-1, 0x1.93acfec7a857ep-56, -0x1.99703622dc239p-7, 0x1.3bc1339ba9b03p-8, -0x1.67803ee044f4bp-9,
     0x1.dbe07ab172abbp-10, -0x1.55763cb3a52dp-10, 0x1.01b4a68f52602p-10, -0x1.92ad51c3c04c5p-11, 0x1.42a294bbe745p-11,
     -0x1.09503ac80d1cbp-11, 0x1.b80ada343bc5fp-12}, /* [160] 1 <= y <= 1.125 2^-20, degree 10, 63.2 bits */
    {0x1.db91d8505214bp-1, -0x1.018cab0aaaf2ap-55, -0x1.75c393e23bc07p-7, 0x1.020ab4a92b56cp-8, -0x1.06ea77e30e63p-9,
     0x1.376cbd6bf677ap-10, -0x1.8fe7e9552e666p-11, 0x1.0e0f1bb1d3bf9p-11, -0x1.799449f70ada1p-12,
     0x1.0eb0e562553f8p-12, -0x1.8dcd6d7c320e1p-13, 0x1.272a77428da7p-13},
     /* [161] 1.125 <= y <= 1.25 2^-20, degree 10, 66.0 bits */
    {0x1.dade8c69c2a3fp-1, -0x1.f702499fa6323p-55, -0x1.5850393cd48d4p-7, 0x1.ae5b148423f73p-9, -0x1.8ccadaa8bccep-10,
     0x1.a9481c16c434bp-11, -0x1.ee22563e5d1b1p-12, 0x1.2ded4d7292351p-12, -0x1.7df2b86e45252p-13,
     0x1.ef817a5462492p-14, -0x1.49199ab858892p-14, 0x1.b9ddf95ce8864p-15},
     /* [162] 1.25 <= y <= 1.375 2^-20, degree 10, 65.0 bits */
    {0x1.da38c0b916396p-1, -0x1.d854e45969a33p-55, -0x1.3f8cfae4dfd56p-7, 0x1.6cd7bfdf67976p-9, -0x1.332fbd9a66c5dp-10,
     0x1.2ca3caf58cf35p-11, -0x1.3ef53164687a3p-12, 0x1.63e73d7e7683ap-13, -0x1.9b187c43757e4p-14,
     0x1.e6f55f807f168p-15, -0x1.27165efc2af0bp-15, 0x1.69bff04e8a389p-16},
     /* [163] 1.375 <= y <= 1.5 2^-20, degree 10, 64.6 bits */
    {0x1.d99e6536b5a9fp-1, 0x1.b6e5815cf6529p-55, -0x1.2a6991e232684p-7, 0x1.3996395cdaa14p-9, -0x1.e5e36f4b12082p-11,
     0x1.b587225f9f9a2p-12, -0x1.ab138bf722a16p-13, 0x1.b670df9908804p-14, -0x1.d1ef5cce32c1fp-15,
     0x1.fbc7629fdde5ap-16, -0x1.1aeec0048e96dp-16, 0x1.3f1a8ddca709ap-17},
     /* [164] 1.5 <= y <= 1.625 2^-20, degree 10, 64.3 bits */
    {0x1.d90ddd431e478p-1, 0x1.fe96336719213p-56, -0x1.1823302014a47p-7, 0x1.10afc6402cc05p-9, -0x1.8745c7be21444p-11,
     0x1.4641bacbc5a5ep-12, -0x1.26e3b4f819406p-13, 0x1.1852b49182abcp-14, -0x1.13d81b5eb2e69p-15,
     0x1.165b30994673bp-16, -0x1.1f1911ed4e3cdp-17, 0x1.2bd1ad9e454dep-18},
     /* [165] 1.625 <= y <= 1.75 2^-20, degree 10, 69.8 bits */
    {0x1.d885dfeb257a9p-1, 0x1.cbaa401def5cbp-55, -0x1.082a9c0d5cb69p-7, 0x1.defed2077cdb6p-10, -0x1.3ffe14f8c815cp-11,
     0x1.f0e05c0d93ecfp-13, -0x1.a2276d3aa98e2p-14, 0x1.72197034f4a34p-15, -0x1.5314913a0d401p-16,
     0x1.3e94169988e8ap-17, -0x1.31d1a3a6f0895p-18, 0x1.2958dc506d0c7p-19},
     /* [166] 1.75 <= y <= 1.875 2^-20, degree 10, 64.0 bits */
    {0x1.d80562731c361p-1, 0x1.5893fd402d164p-55, -0x1.f428243ef0c1cp-8, 0x1.a8592c412b4f9p-10, -0x1.093aad272bd4p-11,
     0x1.814c61d28d6f7p-13, -0x1.2f5956a035f35p-14, 0x1.f659b592f7d02p-16, -0x1.ae90fd17d0a5p-17, 0x1.7a716d556060dp-18,
     -0x1.53c16bfc0d264p-19, 0x1.3508d4bdb94e3p-20}, /* [167] 1.875 <= y <= 2 2^-20, degree 10, 65.6 bits */
    {0x1.d750e02afd1d2p-1, 0x1.2c204ddb366c4p-55, -0x1.cf9484276083cp-7, 0x1.66caf93ebc95ep-8, -0x1.9901fb88fc75dp-9,
     0x1.0ee58eb9b926dp-9, -0x1.84f2b879f8223p-10, 0x1.25a6946284d78p-10, -0x1.caf9883ed586ep-11, 0x1.6fd447f5c6fecp-11,
     -0x1.2e8a072aedd9p-11, 0x1.f5dee1a53d0d3p-12}, /* [168] 1 <= y <= 1.125 2^-19, degree 10, 63.9 bits */
    {0x1.d6738f4a8e20bp-1, 0x1.29d3b8c3627cap-58, -0x1.a70c5e37d25e3p-7, 0x1.2523b336977a6p-8, -0x1.2b0e0d307c7ffp-9,
     0x1.627d07828773cp-10, -0x1.c76e2aa88ecdep-11, 0x1.33ab5499f5e6fp-11, -0x1.ae4a420b37fd8p-12,
     0x1.348dffa17bf7ep-12, -0x1.c58a3257f7821p-13, 0x1.5094f681a3eaap-13},
     /* [169] 1.125 <= y <= 1.25 2^-19, degree 10, 64.9 bits */
    {0x1.d5a8a6f3e63dp-1, -0x1.0c9bc81a03e0cp-55, -0x1.8598867588264p-7, 0x1.e8c6eece4f57fp-9, -0x1.c33d80069e66ap-10,
     0x1.e3ff31a53e6adp-11, -0x1.1951e6dc57d11p-11, 0x1.57ea7673d824ep-12, -0x1.b3323efd97214p-13,
     0x1.1a5cc55f6ae9bp-13, -0x1.7726f25accbc5p-14, 0x1.f7ca330633272p-15},
     /* [170] 1.25 <= y <= 1.375 2^-19, degree 10, 64.0 bits */
    {0x1.d4ed140a508b2p-1, 0x1.b641068642106p-61, -0x1.69797c681b02dp-7, 0x1.9e4802516346dp-9, -0x1.5d4593e9d7c42p-10,
     0x1.5616088c353fp-11, -0x1.6b1dd76b539ddp-12, 0x1.95556aa6c3729p-13, -0x1.d455bb4ca4a0ep-14, 0x1.15733d4a84253p-14,
     -0x1.5054b29e62d98p-15, 0x1.9c62d9aca1fb8p-16}, /* [171] 1.375 <= y <= 1.5 2^-19, degree 10, 63.9 bits */
    {0x1.d43e7e1e39c52p-1, 0x1.d717bfdefe3cap-56, -0x1.51796791b7d5ap-7, 0x1.640218c38d5d3p-9, -0x1.142dc9347e1fap-10,
     0x1.f1c35fd969e2ap-12, -0x1.e620b6f6cef96p-13, 0x1.f3428d562460ap-14, -0x1.095ddb6a53394p-14,
     0x1.2145b6a571034p-15, -0x1.426eeb5452832p-16, 0x1.6bb8e54cbdd15p-17},
     /* [172] 1.5 <= y <= 1.625 2^-19, degree 10, 64.1 bits */
    {0x1.d39b1011ccbacp-1, 0x1.663f3c4a4fb4bp-60, -0x1.3cbaa2b5acaeep-7, 0x1.35844422d36dfp-9, -0x1.bcb954ce1582dp-11,
     0x1.731d93e67c10ap-12, -0x1.4f9d420c611e4p-13, 0x1.3f29e8c818e0ap-14, -0x1.3a29e5474693fp-15,
     0x1.3d1b73dcb544bp-16, -0x1.472364bc75c7ap-17, 0x1.55b2cbbfd020dp-18},
     /* [173] 1.625 <= y <= 1.75 2^-19, degree 10, 65.2 bits */
    {0x1.d30153f8f8b8p-1, -0x1.9968698c65f5bp-56, -0x1.2a9a3f3352fbfp-7, 0x1.0fcbf759742fep-9, -0x1.6ba61fcd3994dp-11,
     0x1.1a8e514650a5p-12, -0x1.dbd604c6b1012p-14, 0x1.a552c3edb85b6p-15, -0x1.8222958c19166p-16, 0x1.6ae2514f56883p-17,
     -0x1.5c6d99c0674d4p-18, 0x1.52d75e30c0faap-19}, /* [174] 1.75 <= y <= 1.875 2^-19, degree 10, 63.9 bits */
    {0x1.d2701aad6643ep-1, 0x1.ea384c73d6822p-55, -0x1.1a9daa5301a18p-7, 0x1.e17ed8b5776c8p-10, -0x1.2d5e84a42d4ebp-11,
     0x1.b62673be1c671p-13, -0x1.5926266f356d4p-14, 0x1.1de74aa1bed02p-15, -0x1.ea41eb0ae9ce9p-17,
     0x1.af060e5e3638ap-18, -0x1.830c8515c68ecp-19, 0x1.601ecf50a93ddp-20},
     /* [175] 1.875 <= y <= 2 2^-19, degree 10, 63.8 bits */
    {0x1.d1a42416b10eep-1, -0x1.e9ac3006edc2p-56, -0x1.05ddf8a2c2e1bp-6, 0x1.9703dbaf973a1p-8, -0x1.d0a41da145a29p-9,
     0x1.33feed7c3edc7p-9, -0x1.ba762ea6d89d5p-10, 0x1.4e3156ed3e156p-10, -0x1.0541f30c69459p-10, 0x1.a2ddaf645ce9ap-11,
     -0x1.5898e92701882p-11, 0x1.1de064b3001d8p-11}, /* [176] 1 <= y <= 1.125 2^-18, degree 10, 62.3 bits */
    {0x1.d0aa279665c73p-1, 0x1.30cf9db6d7dc9p-55, -0x1.ddc2e94d51594p-7, 0x1.4c70d5c3c2c25p-8, -0x1.53a4f8fa7eb36p-9,
     0x1.92f046ce50674p-10, -0x1.02fc92bcb99dap-10, 0x1.5e121741b626cp-11, -0x1.e9c1c1bab8076p-12,
     0x1.5f4bb07a99e82p-12, -0x1.023e60472fccbp-12, 0x1.7f5fedb9d4112p-13},
     /* [177] 1.125 <= y <= 1.25 2^-18, degree 10, 63.7 bits */
    {0x1.cfc50b7e95ffp-1, -0x1.3b47ffbd868aep-58, -0x1.b7d43109cb26ap-7, 0x1.151457087eff9p-8, -0x1.002e7db94f1c2p-9,
     0x1.13035e8b2a2dbp-10, -0x1.3fe2cda3b6d2p-11, 0x1.873c02b88975ep-12, -0x1.ef3ee4eb26112p-13, 0x1.416a4866bf41fp-13,
     -0x1.ab246acc28cd2p-14, 0x1.1edcfdd6d65ffp-14}, /* [178] 1.25 <= y <= 1.375 2^-18, degree 10, 66.2 bits */
    {0x1.cef151f508dcep-1, -0x1.07700e7ef192fp-55, -0x1.97f329e673f2fp-7, 0x1.d594cff16e91cp-9, -0x1.8c7eb802025adp-10,
     0x1.84acfc47e9377p-11, -0x1.9cd0ed14b135ep-12, 0x1.cd046104acb53p-13, -0x1.0a6e4a001988fp-13, 0x1.3bc4d2b5ab86p-14,
     -0x1.7ee0554c34b48p-15, 0x1.d58e7e7381f2ep-16}, /* [179] 1.375 <= y <= 1.5 2^-18, degree 10, 64.0 bits */
    {0x1.ce2c5145df253p-1, 0x1.6cceac6b2e4b3p-57, -0x1.7cbfbdacd4c46p-7, 0x1.936f9f9abf29ap-9, -0x1.3974762406c13p-10,
     0x1.1ab933b324d63p-11, -0x1.14482f8ba5869p-12, 0x1.1bdfcfa81557bp-13, -0x1.2de0d53482518p-14,
     0x1.492ba8efad9aap-15, -0x1.6eff61f0e7591p-16, 0x1.9e1524b01a24bp-17},
     /* [180] 1.5 <= y <= 1.625 2^-18, degree 10, 64.9 bits */
    {0x1.cd73f4f26535fp-1, -0x1.6945293ad8c3cp-56, -0x1.653e1c8ca7db8p-7, 0x1.5eacaa7e9dcacp-9, -0x1.f8a6ac06fe441p-11,
     0x1.a580adeba3bdbp-12, -0x1.7d6a7dadf8b5dp-13, 0x1.6ae3425c36a06p-14, -0x1.6555534a5fa39p-15, 0x1.68ca35c41867p-16,
     -0x1.744c3ccb58718p-17, 0x1.84f407248bf0bp-18}, /* [181] 1.625 <= y <= 1.75 2^-18, degree 10, 64.7 bits */
    {0x1.ccc6949ff3299p-1, -0x1.448417cbafc5dp-58, -0x1.50b533e1faae2p-7, 0x1.33e02481aa215p-9, -0x1.9c9368b9a1fafp-11,
     0x1.40dd67f98d95fp-12, -0x1.0e57fe88f76cfp-13, 0x1.def82cb582ep-15, -0x1.b7212efa242fap-16, 0x1.9cd044d00f559p-17,
     -0x1.8c78aa1124be3p-18, 0x1.81a602a4b0f4cp-19}, /* [182] 1.75 <= y <= 1.875 2^-18, degree 10, 67.9 bits */
    {0x1.cc22d855dbf76p-1, 0x1.e29d4958dfe11p-55, -0x1.3e99cf3458c1fp-7, 0x1.10a6edef46bdfp-9, -0x1.55db919ee34e3p-11,
     0x1.f179983b55cb1p-13, -0x1.88213c7a86659p-14, 0x1.44f962cfdab9cp-15, -0x1.16bb6c5f1c814p-16,
     0x1.ea431a0173d24p-18, -0x1.b85bf80717ccep-19, 0x1.90b5d455f98bfp-20},
     /* [183] 1.875 <= y <= 2 2^-18, degree 10, 65.8 bits */
    {0x1.cb3cf3c9ef21ep-1, 0x1.1e6ffaeda78dcp-55, -0x1.271b028f642a1p-6, 0x1.ccd3cc3e1a8c8p-8, -0x1.0777e73b95158p-8,
     0x1.5d9e7cc982407p-9, -0x1.f694cb941418ap-10, 0x1.7bc8f3de895e2p-10, -0x1.29037887de09p-10, 0x1.dc57b5b17c5fep-11,
     -0x1.87fd13d357ecfp-11, 0x1.45445693326fbp-11}, /* [184] 1 <= y <= 1.125 2^-17, degree 10, 63.0 bits */
    {0x1.ca234bfc6e907p-1, 0x1.474565626b617p-57, -0x1.0d15971942527p-6, 0x1.78444e247a83dp-8, -0x1.8110f9e1900e9p-9,
     0x1.c944106b041a3p-10, -0x1.26196f3588416p-10, 0x1.8dbaaed736fcap-11, -0x1.165349b4d1a7bp-11,
     0x1.8f681889910efp-12, -0x1.25b1182121079p-12, 0x1.b41a0cdfe42ecp-13},
     /* [185] 1.125 <= y <= 1.25 2^-17, degree 10, 62.6 bits */
    {0x1.c921453a2d584p-1, -0x1.7545ad38d04e3p-59, -0x1.ef3df4a6a9edbp-7, 0x1.39829ae0ae288p-8, -0x1.225ca2af6a382p-9,
     0x1.3803540fe62e5p-10, -0x1.6b2aec038d04ap-11, 0x1.bc64f87a1c851p-12, -0x1.1961c80e040d8p-12,
     0x1.6d5ae4af4a8c7p-13, -0x1.e5ac1582e40e5p-14, 0x1.463fe83ccfa75p-14},
     /* [186] 1.25 <= y <= 1.375 2^-17, degree 10, 63.9 bits */
    {0x1.c832ea3dc3b8bp-1, -0x1.59e527d5b5256p-60, -0x1.cb2d35a379a2p-7, 0x1.0995c5086b867p-8, -0x1.c148168ab6f65p-10,
     0x1.b8dd02d4ddb49p-11, -0x1.d4911b5eade0ap-12, 0x1.05c6027c1a102p-12, -0x1.2eb10cbc4e545p-13,
     0x1.66dd7158b0b8fp-14, -0x1.b34175c43027bp-15, 0x1.0af66b02f36fbp-15},
     /* [187] 1.375 <= y <= 1.5 2^-17, degree 10, 63.9 bits */
    {0x1.c755367505a5fp-1, 0x1.c8bfade573553p-55, -0x1.ac698665dc595p-7, 0x1.c83a33654d4fdp-9, -0x1.631a06bd09f89p-10,
     0x1.409d336e74b07p-11, -0x1.3987416cc81aap-12, 0x1.425022da633ecp-13, -0x1.56e5b6655e0ccp-14,
     0x1.7606a2bf75419p-15, -0x1.a120f657fd6b1p-16, 0x1.d6c34a7c75c78p-17},
     /* [188] 1.5 <= y <= 1.625 2^-17, degree 10, 66.1 bits */
    {0x1.c685ce8cea993p-1, -0x1.ea2feb62dfdabp-55, -0x1.91d54e4fbcb55p-7, 0x1.8c7652fec5991p-9, -0x1.1dc95e89e58fbp-10,
     0x1.dde4be74ca10ap-12, -0x1.b0c04157da6bcp-13, 0x1.9bf2c410bd346p-14, -0x1.95d06f0c4e55fp-15, 0x1.99e1d1963c8dp-16,
     -0x1.a714a86eaf49cp-17, 0x1.ba1eb8f1a4da8p-18}, /* [189] 1.625 <= y <= 1.75 2^-17, degree 10, 63.9 bits */
    {0x1.c5c2d1d570b5ep-1, -0x1.4a02a19f77a4ap-56, -0x1.7a9eb1c9ad418p-7, 0x1.5bfe1f6b33734p-9, -0x1.d330801b8a5dep-11,
     0x1.6bb88b9cdec68p-12, -0x1.32ac3de4e719bp-13, 0x1.0fd053dd5b4d9p-14, -0x1.f29f8703c2b17p-16,
     0x1.d4e834c7ef8f3p-17, -0x1.c27aa2db86748p-18, 0x1.b64b6a848b02ap-19},
     /* [190] 1.75 <= y <= 1.875 2^-17, degree 10, 65.0 bits */
    {0x1.c50abac217493p-1, -0x1.15fae13d8c03p-59, -0x1.6627e01ef1419p-7, 0x1.341c461d94028p-9, -0x1.8308785fb0c81p-11,
     0x1.19e86417bbe29p-12, -0x1.bcbf353fc7e47p-14, 0x1.70c83730fe80bp-15, -0x1.3c719ef09df1cp-16,
     0x1.16656906a9d81p-17, -0x1.f444e5a91aa32p-19, 0x1.c758405e37025p-20},
     /* [191] 1.875 <= y <= 2 2^-17, degree 10, 66.2 bits */
    {0x1.c40858f350febp-1, 0x1.d913b28774b35p-55, -0x1.4b9be8043ca66p-6, 0x1.044bffd9e003dp-7, -0x1.2a3382a0baecep-8,
     0x1.8c23aa30211fep-9, -0x1.1cf07830cd641p-9, 0x1.aee14d323428ap-10, -0x1.511f3f7f772e2p-10, 0x1.0e6eac68e2d9ep-10,
     -0x1.bd39297135a1cp-11, 0x1.7189ddfa51a3dp-11}, /* [192] 1 <= y <= 1.125 2^-16, degree 10, 63.1 bits */
    {0x1.c2cbee5133cc3p-1, -0x1.105f9aab3a748p-55, -0x1.2e37f8f76225bp-6, 0x1.a8e6ccb78d09cp-8, -0x1.b3add4968fb42p-9,
     0x1.02f8ce7ceb9d7p-9, -0x1.4d611e2eb84cbp-10, 0x1.c31b96073a6c8p-11, -0x1.3bd26957e6283p-11, 0x1.c56271ae46217p-12,
     -0x1.4d7d28e7af7b5p-12, 0x1.ef54bd96dd186p-13}, /* [193] 1.125 <= y <= 1.25 2^-16, degree 10, 63.1 bits */
    {0x1.c1aa32b3d1a63p-1, 0x1.894ae34afa699p-56, -0x1.15fc3c1cdb61bp-6, 0x1.61e839c1165abp-8, -0x1.486c2b3724c5fp-9,
     0x1.614ff22979eaap-10, -0x1.9b8ecf4f3c80cp-11, 0x1.f7e6c665ecf8bp-12, -0x1.3f35505629e1bp-12,
     0x1.9ea0b0af1a082p-13, -0x1.13acc8157c0adp-13, 0x1.7278aab10f2a3p-14},
     /* [194] 1.25 <= y <= 1.375 2^-16, degree 10, 63.0 bits */
    {0x1.c09eabcebd51bp-1, -0x1.a12dd666df80ap-55, -0x1.01a1df29e7191p-6, 0x1.2bb52aa2a3b4p-8, -0x1.fc062c46a67d9p-10,
     0x1.f314e32227536p-11, -0x1.096e922cc6dfp-11, 0x1.28c0ceac26489p-12, -0x1.574cfc7b5505ap-13, 0x1.972b143300ff7p-14,
     -0x1.ee0111a9712c1p-15, 0x1.2f14dc99fa055p-15}, /* [195] 1.375 <= y <= 1.5 2^-16, degree 10, 64.2 bits */
    {0x1.bfa5efe79fe61p-1, -0x1.d405c160d20adp-55, -0x1.e08d882d865dep-7, 0x1.0157b956f224bp-8, -0x1.916b94e1e57cfp-10,
     0x1.6adc443d7d713p-11, -0x1.632087ef4c799p-12, 0x1.6d4c500753c53p-13, -0x1.84d05e8218016p-14,
     0x1.a8473fe18eac1p-15, -0x1.d954bd86a04ep-16, 0x1.0b2c35aac2e58p-16},
     /* [196] 1.5 <= y <= 1.625 2^-16, degree 10, 64.1 bits */
    {0x1.bebd54de71c0fp-1, -0x1.d6b92bc5f425cp-57, -0x1.c2928f1af183ap-7, 0x1.bf220fc71b285p-9, -0x1.42fb11e906feap-10,
     0x1.0e5e1274d7c9dp-11, -0x1.ea0eabcba6c24p-13, 0x1.d2c956b849c2fp-14, -0x1.cc0f51207124p-15, 0x1.d0db9cc7073d1p-16,
     -0x1.dffd7caadd0d3p-17, 0x1.f5bcbf478d26cp-18}, /* [197] 1.625 <= y <= 1.75 2^-16, degree 10, 65.9 bits */
    {0x1.bde2bb6004d9p-1, -0x1.e87e39d225b68p-55, -0x1.a86556b571558p-7, 0x1.885ca2ba74d4bp-9, -0x1.07eea6322485dp-10,
     0x1.9b74cf4989d42p-12, -0x1.5b359cf9d45bdp-13, 0x1.33ef3d7925f66p-14, -0x1.1a94eaadd32c6p-15,
     0x1.09d95abb10edbp-16, -0x1.fefa98bcaa7p-18, 0x1.f14e432c27155p-19},
     /* [198] 1.75 <= y <= 1.875 2^-16, degree 10, 65.1 bits */
    {0x1.bd146b3954ea1p-1, -0x1.9661845608bp-58, -0x1.9153522a19f26p-7, 0x1.5b4e1acdc4de5p-9, -0x1.b532927e148a7p-11,
     0x1.3ed68079337a5p-12, -0x1.f76eccfefd07cp-14, 0x1.a1b542cce658dp-15, -0x1.669b152ab7802p-16,
     0x1.3b9e723c2a52dp-17, -0x1.1bad8f22e98aap-18, 0x1.02480414cba7p-19},
     /* [199] 1.875 <= y <= 2 2^-16, degree 10, 68.8 bits */
    {0x1.bbf2f5c7d1accp-1, -0x1.40d16a1a7a019p-56, -0x1.736834b616d7ep-6, 0x1.254d7fbfbb1f4p-7, -0x1.50be35dd91527p-8,
     0x1.bfe63e07e6445p-9, -0x1.42724a6d82936p-9, 0x1.e7e96a71fba67p-10, -0x1.7df05a9bb6f4fp-10, 0x1.32832688f5e59p-10,
     -0x1.f8ce002d5036bp-11, 0x1.a31ebae03a103p-11}, /* [200] 1 <= y <= 1.125 2^-15, degree 10, 62.4 bits */
    {0x1.ba90ab5df175fp-1, -0x1.9a1451684df83p-55, -0x1.524c15d2de6bfp-6, 0x1.de90e2c594593p-8, -0x1.ebcb402a6e253p-9,
     0x1.24b3925aa0db1p-9, -0x1.7921865eb0fbep-10, 0x1.fea55e14afe2dp-11, -0x1.65b1119524f38p-11, 0x1.00db337a43679p-11,
     -0x1.7a008d53251ap-12, 0x1.18cfb773eb67cp-12}, /* [201] 1.125 <= y <= 1.25 2^-15, degree 10, 63.2 bits */
    {0x1.b94c6ed906172p-1, -0x1.067758f51e1eep-57, -0x1.37023b89ba5c6p-6, 0x1.8e71123e92f1fp-8, -0x1.7296644d2e014p-9,
     0x1.8f3190a9686abp-10, -0x1.d16b75e4d5a37p-11, 0x1.1d1db410c9de7p-11, -0x1.696b702a6e0b4p-12,
     0x1.d5a9d69a2a863p-13, -0x1.386234125eb69p-13, 0x1.a3f007bc56616p-14},
     /* [202] 1.25 <= y <= 1.375 2^-15, degree 10, 62.7 bits */
    {0x1.b821327c36813p-1, 0x1.73099ae707ce3p-55, -0x1.20194f76d1bb9p-6, 0x1.514b374292e56p-8, -0x1.1e86d0aedf478p-9,
     0x1.19db8cb4f7e3dp-10, -0x1.2c1499ceca971p-11, 0x1.4fb860343935cp-12, -0x1.8497567e0f745p-13, 0x1.cd17414c82ebp-14,
     -0x1.17d1e4bc46003p-14, 0x1.5776610b66a53p-15}, /* [203] 1.375 <= y <= 1.5 2^-15, degree 10, 65.7 bits */
    {0x1.b70b1c85ac625p-1, 0x1.2050fe8c5d58cp-56, -0x1.0c91def0dbf12p-6, 0x1.2183644a485cfp-8, -0x1.c4a9199e188d3p-10,
     0x1.99bb80244f69ap-11, -0x1.915f5fdaf502fp-12, 0x1.9d27ea943c34cp-13, -0x1.b7feec30e6184p-14,
     0x1.e058e1c551d61p-15, -0x1.0c0b7ce1a29c8p-15, 0x1.2eb2938ee8f2dp-16},
     /* [204] 1.5 <= y <= 1.625 2^-15, degree 10, 63.6 bits */
    {0x1.b6072ba03b3e3p-1, -0x1.6707b98443968p-55, -0x1.f76abb1a68304p-7, 0x1.f6dcc13c78a5cp-9, -0x1.6c19b75e191dp-10,
     0x1.31352f61de4fdp-11, -0x1.14dd59db97176p-12, 0x1.07e77d3b0c44fp-13, -0x1.043f54d0bbdc8p-14,
     0x1.07154ce39ab03p-15, -0x1.0fc1078c531d1p-16, 0x1.1c29948afaf01p-17},
     /* [205] 1.625 <= y <= 1.75 2^-15, degree 10, 64.1 bits */
    {0x1.b512fb32c4f65p-1, 0x1.3f4738897b741p-57, -0x1.d9fb74f344969p-7, 0x1.b9205f2e9c412p-9, -0x1.29737ce073b65p-10,
     0x1.d05b69afd3813p-12, -0x1.88399f9a3b24fp-13, 0x1.5c1bb3664f47cp-14, -0x1.3fa1438e8a06cp-15,
     0x1.2cd83ddc7b726p-16, -0x1.213c958afadc6p-17, 0x1.1997f07c673cfp-18},
     /* [206] 1.75 <= y <= 1.875 2^-15, degree 10, 64.4 bits */
    {0x1.b42c9b0f2af0bp-1, 0x1.18d7b808487cbp-58, -0x1.c00c62369ec0dp-7, 0x1.865aa853b54f4p-9, -0x1.ec972a25831bp-11,
     0x1.67be0b0c18628p-12, -0x1.1c4905dca1277p-13, 0x1.d8190546731b5p-15, -0x1.9588b6f33aa3p-16, 0x1.651777e69a574p-17,
     -0x1.4115524cf8232p-18, 0x1.2470808b59ddep-19}, /* [207] 1.875 <= y <= 2 2^-15, degree 10, 65.7 bits */
    {0x1.b2e98865a36afp-1, 0x1.80f68afee468bp-56, -0x1.9e6daccf454dcp-6, 0x1.49854889a8dc2p-7, -0x1.7b446030180b2p-8,
     0x1.f92fc7001f527p-9, -0x1.6c0c2b7d76f16p-9, 0x1.13a28471f270cp-9, -0x1.afca30f99015p-10, 0x1.5aafc4c06d6f4p-10,
     -0x1.1d9a5aeb1f25bp-10, 0x1.da6b125ba861ap-11}, /* [208] 1 <= y <= 1.125 2^-14, degree 10, 63.0 bits */
    {0x1.b15e54c2a763ap-1, -0x1.4afb0ce146038p-55, -0x1.793d4a51621fap-6, 0x1.0cb1512a9979fp-7, -0x1.14d27dabdf5a3p-8,
     0x1.49ff88a2d676dp-9, -0x1.a99da4dfe1141p-10, 0x1.205de17e39caep-10, -0x1.943a3228b36c4p-11, 0x1.226ad322971bep-11,
     -0x1.ab92c00a541cdp-12, 0x1.3dc07f9741aap-12}, /* [209] 1.125 <= y <= 1.25 2^-14, degree 10, 62.8 bits */
    {0x1.aff4e0d26bb0cp-1, 0x1.2ad8890676d89p-55, -0x1.5a9aa39d530b7p-6, 0x1.bf33d7ad3f76ep-8, -0x1.a104d83e5d439p-9,
     0x1.c1e2454612c2p-10, -0x1.0687c5577f90bp-10, 0x1.41e6be28d3e8dp-11, -0x1.984cf08a9e23ap-12, 0x1.096d45f7cc93dp-12,
     -0x1.613c2ba86fad5p-13, 0x1.db07a28f1f2cep-14}, /* [210] 1.25 <= y <= 1.375 2^-14, degree 10, 64.1 bits */
    {0x1.aea77c664ed09p-1, -0x1.ef398368886ecp-59, -0x1.40e56345d600ep-6, 0x1.7a68053953344p-8, -0x1.424cdea8bd2afp-9,
     0x1.3d888355fad52p-10, -0x1.526afbdb4a476p-11, 0x1.7ae8e7e39002fp-12, -0x1.b6db73dcdd25bp-13,
     0x1.04807d3209a26p-13, -0x1.3c5160e629f0bp-14, 0x1.846867f379c89p-15},
     /* [211] 1.375 <= y <= 1.5 2^-14, degree 10, 62.9 bits */
    {0x1.ad71d26add0a3p-1, -0x1.ae093e6fed343p-57, -0x1.2afdb1b7942cap-6, 0x1.44ab734377e4cp-8, -0x1.fcfdc6d3010bbp-10,
     0x1.cd7003123d91p-11, -0x1.c4817cf4c1356p-12, 0x1.d22a122baec5cp-13, -0x1.f0c3a0bbd211ap-14, 0x1.0f4d9ef87887ep-14,
     -0x1.2eec119062c4p-15, 0x1.56370224fbbe1p-16}, /* [212] 1.5 <= y <= 1.625 2^-14, degree 10, 63.2 bits */
    {0x1.ac5081a0c1eecp-1, -0x1.6e9882cc7f65bp-55, -0x1.1815eeeca3e22p-6, 0x1.19db0da8f84c7p-8, -0x1.994553fdfa966p-10,
     0x1.579d17c93618dp-11, -0x1.380ad4d874345p-12, 0x1.29ad831dc671ep-13, -0x1.25be3224224bp-14, 0x1.291a23af74015p-15,
     -0x1.3308815a41ebfp-16, 0x1.412d724a08022p-17}, /* [213] 1.625 <= y <= 1.75 2^-14, degree 10, 65.7 bits */
    {0x1.ab40d94dc0e01p-1, -0x1.1168bafa3e86bp-56, -0x1.0797244448325p-6, 0x1.ee53d0fed5ddap-9, -0x1.4e3ed682b7f03p-10,
     0x1.05510f44e0b0ep-11, -0x1.b9ef5693bd544p-13, 0x1.888d21f3af6c5p-14, -0x1.68ac87a5684b5p-15, 0x1.53a900392f5p-16,
     -0x1.46b45bdbf1d37p-17, 0x1.3e326e7c3b8d6p-18}, /* [214] 1.75 <= y <= 1.875 2^-14, degree 10, 62.7 bits */
    {0x1.aa40abc9f7ca6p-1, -0x1.8c6a6415414b4p-57, -0x1.f21fc585d7808p-7, 0x1.b548790690be2p-9, -0x1.14ad6dc36dde7p-10,
     0x1.94c66587a013cp-12, -0x1.403aa72ba789ep-13, 0x1.0a1def5ce48a7p-14, -0x1.c97ee223aaecbp-16,
     0x1.931137692b0e2p-17, -0x1.6a9770f828343p-18, 0x1.4a608aad87aa6p-19},
     /* [215] 1.875 <= y <= 2 2^-14, degree 10, 64.7 bits */
    {0x1.a8d998f80c455p-1, -0x1.2520301ddbef1p-55, -0x1.cc789eec2ef15p-6, 0x1.70f5a4ec484e7p-7, -0x1.a9deb041765a3p-8,
     0x1.1c198e0332beap-8, -0x1.99ebe5a8ecb4cp-9, 0x1.36a20de14cacap-9, -0x1.e6f21178a03b5p-10, 0x1.8730a4e7a3235p-10,
     -0x1.426b58b257e2bp-10, 0x1.0be57bc681ceap-10}, /* [216] 1 <= y <= 1.125 2^-13, degree 10, 61.9 bits */
    {0x1.a722a66ad6b9ap-1, 0x1.db02993387a09p-56, -0x1.a2d7daa3af2b9p-6, 0x1.2cacaf959658fp-7, -0x1.36ac682c026b7p-8,
     0x1.72fa57a30e88dp-9, -0x1.df0693b20299cp-10, 0x1.44d649fa4001dp-10, -0x1.c7aab07a80224p-11, 0x1.478fa62bc48ecp-11,
     -0x1.e27e983e4730dp-12, 0x1.66b76c0294bedp-12}, /* [217] 1.125 <= y <= 1.25 2^-13, degree 10, 62.9 bits */
    {0x1.a5917824b997dp-1, -0x1.0f3e48158ebf4p-60, -0x1.8092096d312b2p-6, 0x1.f4297655c0a34p-8, -0x1.d3c9ae6493021p-9,
     0x1.f9860e19eb33dp-10, -0x1.2759512be8bc3p-10, 0x1.6a76f5caf66p-11, -0x1.cc13a58ad223ap-12, 0x1.2b42877fd5cd3p-12,
     -0x1.8e7572a2d0895p-13, 0x1.0c099912c94f1p-13}, /* [218] 1.25 <= y <= 1.375 2^-13, degree 10, 62.6 bits */
    {0x1.a41fac3bfce98p-1, 0x1.abaee4e199035p-56, -0x1.63d3382070534p-6, 0x1.a701d2dc5c2d8p-8, -0x1.69603c646ce81p-9,
     0x1.64a7dc722aff8p-10, -0x1.7c9294625f414p-11, 0x1.aa7eca45789b1p-12, -0x1.ee53d6ffc276p-13, 0x1.259a5d0b3aa8dp-13,
     -0x1.64b115642253ep-14, 0x1.b62c56d9b0a32p-15}, /* [219] 1.375 <= y <= 1.5 2^-13, degree 10, 62.7 bits */
    {0x1.a2c866d5b89fp-1, -0x1.917a0ef1a0617p-56, -0x1.4b5804033ce52p-6, 0x1.6ac48a3d65343p-8, -0x1.1d3b4100b75fbp-9,
     0x1.030b54d9db1p-10, -0x1.fcaf224c69cb8p-12, 0x1.0642dad64e85bp-12, -0x1.17ae7111975d4p-13, 0x1.31acf0def005ep-14,
     -0x1.5579d6322c1a6p-15, 0x1.81f0a09488f08p-16}, /* [220] 1.5 <= y <= 1.625 2^-13, degree 10, 62.7 bits */
    {0x1.a187ddf944d91p-1, 0x1.6b898c7fa68bcp-56, -0x1.36398110b29dbp-6, 0x1.3acac8d4737adp-8, -0x1.ca84f0ace7c31p-10,
     0x1.81a8990dc427fp-11, -0x1.5ea92d34263d5p-12, 0x1.4ed511705c674p-13, -0x1.4aa708c0626c6p-14,
     0x1.4ea398b0a4528p-15, -0x1.5a016336a3079p-16, 0x1.6a1b842b6313ep-17},
     /* [221] 1.625 <= y <= 1.75 2^-13, degree 10, 64.0 bits */
    {0x1.a05b0de1244bdp-1, -0x1.cc631aa87b488p-57, -0x1.23ce36b97f122p-6, 0x1.13eebe57a868bp-8, -0x1.7653e4ff6b299p-10,
     0x1.2530d8b5ea3cp-11, -0x1.f0779738251dap-13, 0x1.b968d14e41ca8p-14, -0x1.95defc51f421cp-15, 0x1.7e7648701442dp-16,
     -0x1.70118bff5103dp-17, 0x1.66a5a80ced347p-18}, /* [222] 1.75 <= y <= 1.875 2^-13, degree 10, 66.0 bits */
    {0x1.9f3f85e55ba18p-1, -0x1.37a3d2a400602p-55, -0x1.1396d998cc3bap-6, 0x1.e7fdb916b9b5p-9, -0x1.35bf7c1f491d3p-10,
     0x1.c5fff2652ef5p-12, -0x1.67a1f09193cp-13, 0x1.2b2671fdcf4c8p-14, -0x1.0156e113d63c4p-15, 0x1.c5bbca0eb7a12p-17,
     -0x1.98638e0cfc8c9p-18, 0x1.7446fdeece752p-19}, /* [223] 1.875 <= y <= 2 2^-13, degree 10, 63.0 bits */
    {0x1.9db256e8eb8ep-1, 0x1.cde5e69843394p-56, -0x1.fd2bad40ffe25p-6, 0x1.9b84ec749eff9p-7, -0x1.dc89e505b12b5p-8,
     0x1.3e80e050bc65ap-8, -0x1.cc29591dc8c15p-9, 0x1.5d0bf6fe41591p-9, -0x1.11cb75176fc52p-9, 0x1.b8310a82036acp-10,
     -0x1.6b0198dbe3f43p-10, 0x1.2dc2f703d7082p-10}, /* [224] 1 <= y <= 1.125 2^-12, degree 10, 62.1 bits */
    {0x1.9bcd2b87d2739p-1, 0x1.957d699f287a6p-55, -0x1.cec190b69d9d1p-6, 0x1.4f21d0915ca98p-7, -0x1.5b6d3590bdf3cp-8,
     0x1.9fab11496136p-9, -0x1.0cb960c926ae5p-9, 0x1.6cd2114a4cf22p-10, -0x1.0014c0de5ef35p-10, 0x1.706a6806b9cf8p-11,
     -0x1.0f7d27bf6002bp-11, 0x1.93e0a83cc23aap-12}, /* [225] 1.125 <= y <= 1.25 2^-12, degree 10, 64.3 bits */
    {0x1.9a1218b21bfd2p-1, 0x1.fe2494973dfacp-56, -0x1.a8913a8760fafp-6, 0x1.1691819017cadp-7, -0x1.056b36e76a3b6p-8,
     0x1.1b10916036858p-9, -0x1.4b352074b0473p-10, 0x1.96e36745e1d86p-11, -0x1.027129c2dc38ep-11, 0x1.506fad4499302p-12,
     -0x1.c036fe8656a7p-13, 0x1.2da7d49f7b808p-13}, /* [226] 1.25 <= y <= 1.375 2^-12, degree 10, 64.8 bits */
    {0x1.9879fba1dad5fp-1, -0x1.f92d1f8509fe9p-55, -0x1.888e74388eeeap-6, 0x1.d6ec79c2c89ddp-8, -0x1.93b20dcabb792p-9,
     0x1.8f390ee71b61dp-10, -0x1.aa959c08fe59ap-11, 0x1.de8ed04985771p-12, -0x1.1590ab4181bd4p-12,
     0x1.49f1190c7e2edp-13, -0x1.911286646f04dp-14, 0x1.ecf02fe4fc62p-15},
     /* [227] 1.375 <= y <= 1.5 2^-12, degree 10, 63.8 bits */
    {0x1.96ff666ad932ap-1, -0x1.04071246a301ep-56, -0x1.6d4f2849642fp-6, 0x1.93a5438aab2dcp-8, -0x1.3e7b3beb48b44p-9,
     0x1.21d4fa5e33d7ap-10, -0x1.1cf8bbe2fdfacp-11, 0x1.2627edd68be72p-12, -0x1.39f58e206808ep-13,
     0x1.5760aff319bf5p-14, -0x1.7fd2155206554p-15, 0x1.b204d876fc28bp-16},
     /* [228] 1.5 <= y <= 1.625 2^-12, degree 10, 63.4 bits */
    {0x1.959e1db7d7fp-1, 0x1.2a83c05c15a9ep-55, -0x1.55d0e78ce83c1p-6, 0x1.5e16cd734eff8p-8, -0x1.ffbd5f15bdce6p-10,
     0x1.af50567db1c22p-11, -0x1.88bbcdea6ffbdp-12, 0x1.7768e146ce498p-13, -0x1.730a667add619p-14,
     0x1.77c779ac4c1f1p-15, -0x1.84c6b6d25361p-16, 0x1.97142b26c40f3p-17},
     /* [229] 1.625 <= y <= 1.75 2^-12, degree 10, 62.6 bits */
    {0x1.9452c3f7f7a85p-1, -0x1.3a9fc4d30c5e4p-57, -0x1.41561dce0ee4ap-6, 0x1.32ba61e9c34c5p-8, -0x1.a19967f36d17ep-10,
     0x1.47c524e62c139p-11, -0x1.15e9b12e57ap-12, 0x1.eeb98f105f62p-14, -0x1.c749f29ed9085p-15, 0x1.ad563a668c4a9p-16,
     -0x1.9d6e469426767p-17, 0x1.930f277619e42p-18}, /* [230] 1.75 <= y <= 1.875 2^-12, degree 10, 62.9 bits */
    {0x1.931aa02420c5ep-1, 0x1.c49aae936bf5cp-56, -0x1.2f507413c3b7cp-6, 0x1.0f1b2b4b91ee9p-8, -0x1.596a7a2440264p-10,
     0x1.fb5b0a59a1163p-12, -0x1.927cff290ad2fp-13, 0x1.4f2b3cc53f1a9p-14, -0x1.2093db6ebab14p-15,
     0x1.fd2e59374edd7p-17, -0x1.ca93e64ec78fdp-18, 0x1.a2400b10b8c79p-19},
     /* [231] 1.875 <= y <= 2 2^-12, degree 10, 63.7 bits */
    {0x1.9165a69bbec65p-1, 0x1.5be1921b48b3ap-56, -0x1.17fbd58dcc104p-5, 0x1.c8f531d8236a2p-7, -0x1.098e8b1539255p-7,
     0x1.63bf8e703ae47p-8, -0x1.015eb81cb7aaap-8, 0x1.86e2d89d3112bp-9, -0x1.32e3793c4e4cfp-9, 0x1.edc337628ff12p-10,
     -0x1.97710c0795f55p-10, 0x1.52e20ea5a9833p-10}, /* [232] 1 <= y <= 1.125 2^-11, degree 10, 61.7 bits */
    {0x1.8f5053f222fep-1, -0x1.81ca016a5241p-57, -0x1.fc7289a4f509ep-6, 0x1.73d9d00cfb66dp-7, -0x1.82f28ef5f8fffp-8,
     0x1.cff9ca841c31bp-9, -0x1.2c69a24a64dap-9, 0x1.984f84d6e2da7p-10, -0x1.1edeeef793974p-10, 0x1.9d061408d9672p-11,
     -0x1.308ebc1844894p-11, 0x1.c5527d49669b6p-12}, /* [233] 1.125 <= y <= 1.25 2^-11, degree 10, 62.8 bits */
    {0x1.8d69b6e8a6514p-1, -0x1.cd9ca925f45efp-55, -0x1.d216cf35e6aa1p-6, 0x1.34df44ce19144p-7, -0x1.22f89fb3efaadp-8,
     0x1.3bc636bf85b91p-9, -0x1.720e49b00f13fp-10, 0x1.c725b3469d3d9p-11, -0x1.215d56b075d11p-11, 0x1.78fb2aee7aa0dp-12,
     -0x1.f68f906f91446p-13, 0x1.526c09c2bcee9p-13}, /* [234] 1.25 <= y <= 1.375 2^-11, degree 10, 62.9 bits */
    {0x1.8ba9dd79cdde9p-1, -0x1.0a45b33499ff4p-59, -0x1.ae9b7d012da34p-6, 0x1.04e801583de9ap-7, -0x1.c1114f1248f22p-9,
     0x1.bd1c55dd88013p-10, -0x1.dc5f0b9f70ed5p-11, 0x1.0b8652846b8ap-11, -0x1.36a021350f6d3p-12, 0x1.7187cbabe817fp-13,
     -0x1.c17f096d146d8p-14, 0x1.1462ada81848ap-14}, /* [235] 1.375 <= y <= 1.5 2^-11, degree 10, 65.3 bits */
    {0x1.8a0abcfe85121p-1, 0x1.5b4ecb9593202p-55, -0x1.906cbdb16447p-6, 0x1.befe2678c8427p-8, -0x1.6214fe2652444p-9,
     0x1.42fb0fce2c5b7p-10, -0x1.3e137b83dbbb6p-11, 0x1.48b9edc2928d6p-12, -0x1.5f322f40056cp-13, 0x1.8068fbf2a8dcdp-14,
     -0x1.adfa5056e6bebp-15, 0x1.e67f2a5871321p-16}, /* [236] 1.5 <= y <= 1.625 2^-11, degree 10, 63.1 bits */
    {0x1.8887a0a9f892fp-1, -0x1.78864e43a5ff5p-55, -0x1.766a7d6702474p-6, 0x1.8376e98b6dc2fp-8, -0x1.1c5356c8220b2p-9,
     0x1.e069e52cf9199p-11, -0x1.b6282277aace4p-12, 0x1.a3588016ab35p-13, -0x1.9edf3f64223bfp-14, 0x1.a482bf1cc8433p-15,
     -0x1.b35ad420946c8p-16, 0x1.c81ed989ed11cp-17}, /* [237] 1.625 <= y <= 1.75 2^-11, degree 10, 65.7 bits */
    {0x1.871ccad47bea6p-1, 0x1.45576366c4fc3p-56, -0x1.5fc184390943cp-6, 0x1.534ae87b71399p-8, -0x1.cfd1120219d8ap-10,
     0x1.6ceaf385aa675p-11, -0x1.35ec3fd31fca4p-12, 0x1.1432d434839cfp-13, -0x1.fcdeac1fb41bp-15, 0x1.e041fd90e1291p-16,
     -0x1.cec9d1ac3a8c8p-17, 0x1.c373330cff2bdp-18}, /* [238] 1.75 <= y <= 1.875 2^-11, degree 10, 63.4 bits */
    {0x1.85c7351d87b3dp-1, 0x1.b17e95b126e66p-55, -0x1.4bd34ef34ca8p-6, 0x1.2bbcb2867375bp-8, -0x1.7f78168972e2dp-10,
     0x1.1a4ebda8a8335p-11, -0x1.c0aa1f68b4c95p-13, 0x1.76185719d5821p-14, -0x1.426adc39bafebp-15,
     0x1.1cae8025f3bf2p-16, -0x1.00922815f6c1dp-17, 0x1.d44d1b8d9432fp-19},
     /* [239] 1.875 <= y <= 2 2^-11, degree 10, 65.1 bits */
    {0x1.83e95ca7fc89p-1, -0x1.13bd42464f119p-55, -0x1.320a3e2963692p-5, 0x1.f8db677152f01p-7, -0x1.269f653e1d7c1p-7,
     0x1.8ba8ddb907c63p-8, -0x1.1ebbbe9639acap-8, 0x1.b40b3d948885p-9, -0x1.56b19d6ab248ep-9, 0x1.13eb4357527dap-9,
     -0x1.c7b1e1aed29d1p-10, 0x1.7b4084d515e02p-10}, /* [240] 1 <= y <= 1.125 2^-10, degree 10, 61.3 bits */
    {0x1.81a2b600ca9cfp-1, 0x1.653954e0340b2p-57, -0x1.159789959848cp-5, 0x1.9a78855b62d34p-7, -0x1.acf604f25c8c7p-8,
     0x1.01d2fc87c37c2p-8, -0x1.4e73b1b839a39p-9, 0x1.c72cac6fa2b9p-10, -0x1.4021c3cf7ad39p-10, 0x1.cd4f8ac6b2f43p-11,
     -0x1.546a65ec39572p-11, 0x1.fb0455fbb1656p-12}, /* [241] 1.125 <= y <= 1.25 2^-10, degree 10, 61.6 bits */
    {0x1.7f8f9f51b70f6p-1, 0x1.4d040d62d787fp-56, -0x1.fc71d5f338466p-6, 0x1.54adb2ae1bba1p-7, -0x1.4254897a9d1e2p-8,
     0x1.5eb437844d555p-9, -0x1.9bb885629a462p-10, 0x1.fb12a22e2448bp-11, -0x1.42b8b7927ca3cp-11, 0x1.a4cf3ba2d728cp-12,
     -0x1.18b4c79478a68p-12, 0x1.7a4c0592e4b19p-13}, /* [242] 1.25 <= y <= 1.375 2^-10, degree 10, 62.5 bits */
    {0x1.7da74a6f4c7bcp-1, 0x1.23ee9a49b4db7p-56, -0x1.d552ccc4e26c9p-6, 0x1.1f8f78fc5195fp-7, -0x1.f121bb8b6b308p-9,
     0x1.ee0976144f8ep-10, -0x1.08d857d0b9584p-10, 0x1.29dfdbd460ebdp-11, -0x1.5a3dc75abdeep-12, 0x1.9c453d2e4b64bp-13,
     -0x1.f5dea11a452fep-14, 0x1.34cac0e256394p-14}, /* [243] 1.375 <= y <= 1.5 2^-10, degree 10, 63.1 bits */
    {0x1.7be3068208a53p-1, -0x1.2a069ef1ec871p-55, -0x1.b411944f6d7d7p-6, 0x1.ec5176a888c4p-8, -0x1.87bc23e5baddbp-9,
     0x1.6645e11c6ccf7p-10, -0x1.617b144bc3077p-11, 0x1.6dd2d5aaf9c44p-12, -0x1.8742e56d07433p-13,
     0x1.aca7def09d785p-14, -0x1.dfd7738535627p-15, 0x1.0fa3a69e1eb2cp-15},
     /* [244] 1.5 <= y <= 1.625 2^-10, degree 10, 64.7 bits */
    {0x1.7a3d9e278582dp-1, -0x1.36ee319767cbcp-55, -0x1.976e8270d16a2p-6, 0x1.aa7a7f1f7083bp-8, -0x1.3a606344bcaf3p-9,
     0x1.0a4ef095a6af4p-10, -0x1.e6ac74b2a57f3p-12, 0x1.d26f8fafd7e5p-13, -0x1.cdfa4c8afd8cdp-14, 0x1.d4b0d89c3b30ep-15,
     -0x1.e59e6dd11cdf2p-16, 0x1.fd20c2c5fd34dp-17}, /* [245] 1.625 <= y <= 1.75 2^-10, degree 10, 62.8 bits */
    {0x1.78b2ee288592cp-1, 0x1.fa06fc59a7bd7p-56, -0x1.7e7f58c4a346ep-6, 0x1.753ac303fc391p-8, -0x1.004728bc31f19p-9,
     0x1.945cad99b14bep-11, -0x1.581249f954b88p-12, 0x1.3311b02649722p-13, -0x1.1b31df7361498p-14,
     0x1.0b85e23471dd1p-15, -0x1.01ff855c1a335p-16, 0x1.f7b389e78cbc8p-18},
     /* [246] 1.75 <= y <= 1.875 2^-10, degree 10, 62.8 bits */
    {0x1.773f9e823c40ep-1, 0x1.aab30d01ec681p-58, -0x1.689464a41d445p-6, 0x1.49874e7286cc2p-8, -0x1.a78b6406bb964p-10,
     0x1.38ab79ee33b18p-11, -0x1.f1de7724d5293p-13, 0x1.9fb8cc3052b95p-14, -0x1.66b4efe747384p-15,
     0x1.3d0679430ed21p-16, -0x1.1df3cd098cc83p-17, 0x1.052595c5e5acep-18},
     /* [247] 1.875 <= y <= 2 2^-10, degree 10, 62.7 bits */
    {0x1.75389d1663105p-1, -0x1.e2e0245c4e8f7p-56, -0x1.4c3e1c67a8e6p-5, 0x1.154b5d064a88ap-6, -0x1.452cbc7df0a3ep-7,
     0x1.b5e9934c625b2p-8, -0x1.3df8a951318a8p-8, 0x1.e442864676e1p-9, -0x1.7d08ab48047fap-9, 0x1.3315f39990644p-9,
     -0x1.fb970d3e5238cp-10, 0x1.a6bdefa49bacp-10}, /* [248] 1 <= y <= 1.125 2^-9, degree 10, 61.1 bits */
    {0x1.72c072234a2e3p-1, 0x1.efda9f0210a04p-60, -0x1.2d01e27c1345fp-5, 0x1.c275b1fad89eap-7, -0x1.d904d22b83e63p-8,
     0x1.1d1e0343dd285p-8, -0x1.7297613e6a33bp-9, 0x1.f91dcaffc3d9bp-10, -0x1.63aeb24c10f3ap-10, 0x1.0085f50f861b2p-10,
     -0x1.7ae9f96a43c83p-11, 0x1.1a6218a047bf6p-11}, /* [249] 1.125 <= y <= 1.25 2^-9, degree 10, 62.5 bits */
    {0x1.7080ddad3ba82p-1, 0x1.b14473e766438p-55, -0x1.135f584322a53p-5, 0x1.7587a45f307f9p-7, -0x1.6324b7a80558p-8,
     0x1.838798ec48d4ap-9, -0x1.c7dfb757fa18dp-10, 0x1.1927cb3ab72b3p-10, -0x1.66506e47e5124p-11, 0x1.d3b1107526326p-12,
     -0x1.383fa2e891c1dp-12, 0x1.a51df538abbddp-13}, /* [250] 1.25 <= y <= 1.375 2^-9, degree 10, 62.5 bits */
    {0x1.6e702ae36bd82p-1, -0x1.11d4db36b84f8p-58, -0x1.fbde6ea88d293p-6, 0x1.3b06a633f477dp-7, -0x1.11a9476cd145bp-8,
     0x1.10c2f8c79ce49p-9, -0x1.250c2aba19e5fp-10, 0x1.4a1b70097e27fp-11, -0x1.802f2da24a899p-12, 0x1.c9eb3f9f2f804p-13,
     -0x1.16f6bb924e5aap-13, 0x1.578ace9f59ff7p-14}, /* [251] 1.375 <= y <= 1.5 2^-9, degree 10, 62.7 bits */
    {0x1.6c86fb303ea13p-1, -0x1.6cba7147140f8p-55, -0x1.d773ac1b06a61p-6, 0x1.0d75e00798b1bp-7, -0x1.aefa91545830ep-9,
     0x1.8b58e027d2c5ap-10, -0x1.86dfa518e39b8p-11, 0x1.952961799716ap-12, -0x1.b1e1a2993f966p-13,
     0x1.dbd852fb517fep-14, -0x1.0a91e27528eccp-14, 0x1.2e0ae4b3f69ep-15},
     /* [252] 1.5 <= y <= 1.625 2^-9, degree 10, 62.4 bits */
    {0x1.6abf930810d94p-1, -0x1.42e54351e2fe5p-60, -0x1.b81d878fb16e1p-6, 0x1.d28241fe7b9f2p-8, -0x1.59a410c657416p-9,
     0x1.25aecac64c26ep-10, -0x1.0ceb0ed1059f7p-11, 0x1.0226177a8a644p-12, -0x1.0002388914e9ep-13,
     0x1.0400efa4fc78fp-14, -0x1.0da330dab4375p-15, 0x1.1ae915bdde99fp-16},
     /* [253] 1.625 <= y <= 1.75 2^-9, degree 10, 64.3 bits */
    {0x1.6915656f2258bp-1, 0x1.b2291ddcd2126p-56, -0x1.9cd996d78afedp-6, 0x1.97fb6f29e530cp-8, -0x1.1996a0042a069p-9,
     0x1.bdaa610231ecdp-11, -0x1.7c07ae6c76e87p-12, 0x1.53b62f731f638p-13, -0x1.39b4ac5a3bc31p-14,
     0x1.28a9d07ad32dep-15, -0x1.1e5ccafc70402p-16, 0x1.17c268557321cp-17},
     /* [254] 1.75 <= y <= 1.875 2^-9, degree 10, 62.6 bits */
    {0x1.6784c585207e2p-1, -0x1.fc05fadc9f98fp-55, -0x1.84e62461a980ap-6, 0x1.67faa2ec10a35p-8, -0x1.d1197c7734e66p-10,
     0x1.586a910ab5718p-11, -0x1.12ce1192d261p-12, 0x1.cbae35603bcaep-14, -0x1.8d284b3bd0b5p-15, 0x1.5f63a325ce759p-16,
     -0x1.3d3dc8e7ab6a9p-17, 0x1.21f3e9e5b29cfp-18}, /* [255] 1.875 <= y <= 2 2^-9, degree 10, 63.6 bits */
    {0x1.65554cdb1518ep-1, -0x1.f19a4b482bedap-55, -0x1.65f50f2253447p-5, 0x1.2ea4a343b8506p-6, -0x1.64c842294a27fp-7,
     0x1.e1ffc65ca2662p-8, -0x1.5ec1650450816p-8, 0x1.0b8a91c021a6bp-8, -0x1.a595dc1cf75b7p-9, 0x1.54248f3d4cce1p-9,
     -0x1.1961d69a85f4ap-9, 0x1.d512dce6daedp-10}, /* [256] 1 <= y <= 1.125 2^-8, degree 10, 61.5 bits */
    {0x1.62aca4ff74de1p-1, 0x1.d747ee459aab1p-56, -0x1.43e29f25b4c2fp-5, 0x1.eb17737ffafap-7, -0x1.033c0ed25e131p-7,
     0x1.3985741c975ffp-8, -0x1.986d8b45af206p-9, 0x1.16d1a6aed6f01p-9, -0x1.89338333f836ap-10, 0x1.1be6fd9545ee4p-10,
     -0x1.a3c2e260de988p-11, 0x1.39156a80ddf06p-11}, /* [257] 1.125 <= y <= 1.25 2^-8, degree 10, 63.1 bits */
    {0x1.6041af0028d93p-1, -0x1.663ad766e4c0fp-55, -0x1.27f3b741e1882p-5, 0x1.96cecd6570602p-7, -0x1.84e79c41cbe66p-8,
     0x1.a9c33c67f6163p-9, -0x1.f5ff48d6c9bfdp-10, 0x1.3623be2426c23p-10, -0x1.8bcd294b4939p-11, 0x1.029b9ff4fd523p-11,
     -0x1.59a6fe09da13ap-12, 0x1.d28fa250ff584p-13}, /* [258] 1.25 <= y <= 1.375 2^-8, degree 10, 61.6 bits */
    {0x1.5e09c860fc36dp-1, -0x1.85c6454692e9ap-55, -0x1.109d6a05529b7p-5, 0x1.56c4e35d1aea8p-7, -0x1.2b6b15524a616p-8,
     0x1.2b6dc3fba49d9p-9, -0x1.42726f24b16a3p-10, 0x1.6bddc6afc3b2ap-11, -0x1.a81251ba24c78p-12, 0x1.fa0d64dd96ccep-13,
     -0x1.349833acb3955p-13, 0x1.7c5bdf05bc39ep-14}, /* [259] 1.375 <= y <= 1.5 2^-8, degree 10, 61.7 bits */
    {0x1.5bfcdff9af112p-1, -0x1.32f648a52eb2dp-61, -0x1.f99f6be6613aep-6, 0x1.24ef3241bf04cp-7, -0x1.d72a1911f978dp-9,
     0x1.b1abebf7831c4p-10, -0x1.adc6fe97257f2p-11, 0x1.be494b658c9d3p-12, -0x1.de9b2bad6b575p-13,
     0x1.06c258214cb6dp-13, -0x1.26b2026b9da1p-14, 0x1.4e33c36b36aaap-15},
     /* [260] 1.5 <= y <= 1.625 2^-8, degree 10, 62.6 bits */
    {0x1.5a14b0af6e79bp-1, 0x1.3a63f9ead4c12p-56, -0x1.d791f41b55bbep-6, 0x1.fabbd1d45b627p-8, -0x1.7995f75ecbecfp-9,
     0x1.41ec9e2f8a3fp-10, -0x1.277bec146e558p-11, 0x1.1c2a9cb07bbf7p-12, -0x1.1a385f31a418ap-13, 0x1.1ef81c4752e63p-14,
     -0x1.29e866dbea1eep-15, 0x1.38d969ad3763cp-16}, /* [261] 1.625 <= y <= 1.75 2^-8, degree 10, 64.1 bits */
    {0x1.584c4152e9b7ep-1, -0x1.a957a7ecc729fp-55, -0x1.b9f70b640efc3p-6, 0x1.bad1e2c286d77p-8, -0x1.3365743a405b2p-9,
     0x1.e83287a14223dp-11, -0x1.a14ea113b74a2p-12, 0x1.75b8853216f4cp-13, -0x1.599e934b5d481p-14,
     0x1.473de6c01eaeep-15, -0x1.3c352e6100524p-16, 0x1.3531977747636p-17},
     /* [262] 1.75 <= y <= 1.875 2^-8, degree 10, 64.8 bits */
    {0x1.569f8e61dd634p-1, -0x1.1999a58281023p-57, -0x1.9ffa6b0d47653p-6, 0x1.866f2caf9888dp-8, -0x1.fb6358b9e3c5bp-10,
     0x1.790c671fefe98p-11, -0x1.2d9456aa47a94p-12, 0x1.f96849a3c0dfp-14, -0x1.b550b9d568695p-15, 0x1.83659b2ed75e6p-16,
     -0x1.5e1e2f7dd3426p-17, 0x1.404ac8695c443p-18}, /* [263] 1.875 <= y <= 2 2^-8, degree 10, 63.1 bits */
    {0x1.54497a36e9d7cp-1, 0x1.71b5053053417p-56, -0x1.7e6f7df91fb55p-5, 0x1.47e9db796da67p-6, -0x1.84dba47cfc9b1p-7,
     0x1.0799c31bcc655p-7, -0x1.809af572e9178p-8, 0x1.25ea7cb728a16p-8, -0x1.cfd8f435de5bbp-9, 0x1.76b5d6218ebdfp-9,
     -0x1.364ffb2cd3a3p-9, 0x1.02e3b7e479bbcp-9}, /* [264] 1 <= y <= 1.125 2^-7, degree 10, 60.7 bits */
    {0x1.5172cb28ecfap-1, 0x1.d830a632ff3e3p-62, -0x1.598a8340204bap-5, 0x1.09b7a157e85fp-6, -0x1.1a3778d0719d6p-7,
     0x1.568d81ee0ca88p-8, -0x1.bf616c72a46aap-9, 0x1.320007a0d9d4ap-9, -0x1.b0332538b963fp-10, 0x1.3875bc2ef45d2p-10,
     -0x1.ce7e04152f9e3p-11, 0x1.5947bacf445c7p-11}, /* [265] 1.125 <= y <= 1.25 2^-7, degree 10, 61.0 bits */
    {0x1.4edee040e1c11p-1, 0x1.a04ee200ed7cap-55, -0x1.3b547ef2ba261p-5, 0x1.b7b9ad1339d97p-7, -0x1.a6f0258a717edp-8,
     0x1.d0b9fd0b0ebf4p-9, -0x1.12ad2451be7d2p-9, 0x1.54102387de82cp-10, -0x1.b2ac140679ad5p-11, 0x1.1c6019bbb05dap-11,
     -0x1.7c8467f4dcd1dp-12, 0x1.010eb1b320b25p-12}, /* [266] 1.25 <= y <= 1.375 2^-7, degree 10, 62.2 bits */
    {0x1.4c8226fb4bcbcp-1, -0x1.18ad78ad32048p-55, -0x1.221e1dd48fb29p-5, 0x1.721d7ec781e66p-7, -0x1.454e0e43f6fdep-8,
     0x1.46882b74a7733p-9, -0x1.608e3ff4cb73dp-10, 0x1.8ea2e6c412736p-11, -0x1.d1563d36c46f3p-12, 0x1.1603e927ceep-12,
     -0x1.5374bbc51a00bp-13, 0x1.a2ce3f9b55badp-14}, /* [267] 1.375 <= y <= 1.5 2^-7, degree 10, 61.2 bits */
    {0x1.4a53da68ae7c1p-1, -0x1.18c4bdfc5b1cfp-55, -0x1.0cbe9679c4998p-5, 0x1.3bfee4662a92bp-7, -0x1.ff7025c299c7ap-9,
     0x1.d885e5256dc53p-10, -0x1.d586618ee7faap-11, 0x1.e88c2bfeb82e5p-12, -0x1.06637bde4ce7ep-12,
     0x1.207eac9114112p-13, -0x1.43ee4ebbcc57ep-14, 0x1.6fb89c7b5681p-15},
     /* [268] 1.5 <= y <= 1.625 2^-7, degree 10, 61.5 bits */
    {0x1.484d2b59a944bp-1, 0x1.e1b5036c0bd1fp-61, -0x1.f4c5a8bf6ef17p-6, 0x1.11104d37e4482p-7, -0x1.9983d938b2d2p-9,
     0x1.5e7c2ceeb0f9fp-10, -0x1.4290bc228579dp-11, 0x1.36d8bc77ba45ep-12, -0x1.35398d3e5d881p-13,
     0x1.3adb4e5f2a673p-14, -0x1.473d2a1029ef3p-15, 0x1.57ff2f5a93e9p-16},
     /* [269] 1.625 <= y <= 1.75 2^-7, degree 10, 63.2 bits */
    {0x1.4668b44f8f27dp-1, 0x1.59a6b2cbd78fep-57, -0x1.d4e1056ac87a3p-6, 0x1.dcd5f0edeb4ap-8, -0x1.4d20412f90531p-9,
     0x1.098e439e08d87p-10, -0x1.c73a09633c458p-12, 0x1.9886a551e1501p-13, -0x1.7a6f94ef1b574p-14,
     0x1.66cec51ddb66fp-15, -0x1.5b1e2f32094b1p-16, 0x1.53c38560f9cdep-17},
     /* [270] 1.75 <= y <= 1.875 2^-7, degree 10, 63.4 bits */
    {0x1.44a21b4a3799dp-1, -0x1.08f79259e6131p-55, -0x1.b8e83a1d6ce0cp-6, 0x1.a41609f5b3f79p-8, -0x1.12b91d46857e4p-9,
     0x1.99e6e65661591p-11, -0x1.48c29be795316p-12, 0x1.140ebf6a45396p-13, -0x1.de88ba446ed85p-15,
     0x1.a8809d82bdc1bp-16, -0x1.801c2dac1952fp-17, 0x1.5fc023c10191dp-18},
     /* [271] 1.875 <= y <= 2 2^-7, degree 10, 62.6 bits */
    {0x1.4228971131d23p-1, -0x1.2db1953f4a132p-55, -0x1.94d650282d26fp-5, 0x1.606ad377ae6ebp-6, -0x1.a4a6307848465p-7,
     0x1.1e48d53418696p-7, -0x1.a2debfa08fe63p-8, 0x1.40c897ced94ep-8, -0x1.fb1d399571bap-9, 0x1.9a3e5ab166afap-9,
     -0x1.54275cad0af41p-9, 0x1.1c15293b74a1bp-9}, /* [272] 1 <= y <= 1.125 2^-6, degree 10, 60.4 bits */
    {0x1.3f27f017a9215p-1, -0x1.b23d099610528p-55, -0x1.6d36711f4d82dp-5, 0x1.1d2d8383c2e84p-6, -0x1.30e5be9f6ce7ap-7,
     0x1.73941670df636p-8, -0x1.e6ab948d79267p-9, 0x1.4d98ac2770f51p-9, -0x1.d7ff7206cbc5dp-10, 0x1.55b9b3e9323f1p-10,
     -0x1.fa70347a48948p-11, 0x1.7a7e03bc6a151p-11}, /* [273] 1.125 <= y <= 1.25 2^-6, degree 10, 62.2 bits */
    {0x1.3c6ef20c2c059p-1, -0x1.1ff04d804c9p-56, -0x1.4ccf2b713aae2p-5, 0x1.d7550732e2495p-7, -0x1.c8642c318eccfp-8,
     0x1.f78b137b84569p-9, -0x1.2a7ad91552cd3p-9, 0x1.72594ac36a59ep-10, -0x1.da38e3693ff73p-11, 0x1.36b4e005d7f07p-11,
     -0x1.a0466658327a9p-12, 0x1.1984d9a0a4d12p-12}, /* [274] 1.25 <= y <= 1.375 2^-6, degree 10, 61.2 bits */
    {0x1.39f11df02a7d4p-1, -0x1.3b66046c67d42p-56, -0x1.31ccd53e29d58p-5, 0x1.8c416c310a6f9p-7, -0x1.5ea7b40c161b1p-8,
     0x1.6171335ceb0b3p-9, -0x1.7ebb02fb9389ep-10, 0x1.b1b98ea93e964p-11, -0x1.fb34f9bc01816p-12, 0x1.2f7bb236af5fbp-12,
     -0x1.7306cf0015638p-13, 0x1.ca42e4170e6a1p-14}, /* [275] 1.375 <= y <= 1.5 2^-6, degree 10, 62.3 bits */
    {0x1.37a4fe6659058p-1, 0x1.7656752eea956p-55, -0x1.1aedfdc6f1b8cp-5, 0x1.51f2796072aaap-7, -0x1.135e73ba5ab7ep-8,
     0x1.fef9e32084f44p-10, -0x1.fd3e62a8ed631p-11, 0x1.098a1a6a3476bp-11, -0x1.1dc05c53a87edp-12,
     0x1.3aa8767de9c54p-13, -0x1.61c41fda00fe7p-14, 0x1.920a10d7cbd9bp-15},
     /* [276] 1.5 <= y <= 1.625 2^-6, degree 10, 63.1 bits */
    {0x1.35833d3caa98fp-1, -0x1.4ba1d744555a5p-55, -0x1.074e42a39d21fp-5, 0x1.23bcc574970ep-7, -0x1.b8915f5fb6eecp-9,
     0x1.7aab19807e9c3p-10, -0x1.5d8d62d0b6c66p-11, 0x1.51a0b0bb9bc08p-12, -0x1.507c83cc3848ep-13,
     0x1.5723f9da70631p-14, -0x1.651a7e606667ap-15, 0x1.77d11700f9f6fp-16},
     /* [277] 1.625 <= y <= 1.75 2^-6, degree 10, 62.5 bits */
    {0x1.33860b6b8bec1p-1, -0x1.4de4c52adc90fp-58, -0x1.ec8da0219db19p-6, 0x1.fcf604acbd365p-8, -0x1.6611d0d95601bp-9,
     0x1.1eab39c5dc2b1p-10, -0x1.ecea379cac388p-12, 0x1.bb606d463755fp-13, -0x1.9b7cad97d15adp-14,
     0x1.86c020a23f01cp-15, -0x1.7a85b18cd07fbp-16, 0x1.72edabc1e96bap-17},
     /* [278] 1.75 <= y <= 1.875 2^-6, degree 10, 63.1 bits */
    {0x1.31a8baf352ec7p-1, -0x1.479ef3ee3ea03p-56, -0x1.ceb5c65ef8684p-6, 0x1.bffcaaca6d0d2p-8, -0x1.270c276803c05p-9,
     0x1.ba2416bc9032fp-11, -0x1.63b51a1fd435p-12, 0x1.2b631ab2dadbbp-13, -0x1.03fa3f3ba3bdep-14, 0x1.cdf8844e12836p-16,
     -0x1.a293175c4fd75p-17, 0x1.7fc1ca3624d87p-18}, /* [279] 1.875 <= y <= 2 2^-6, degree 10, 63.5 bits */
    {0x1.2f1058b09ccd8p-1, 0x1.af461ac2e43acp-55, -0x1.a844a412d67f9p-5, 0x1.775a63cf81058p-6, -0x1.c33dd3a8e4fb7p-7,
     0x1.347540407aea6p-7, -0x1.c4b83d20793b2p-8, 0x1.5b88978673a02p-8, -0x1.133a4c7cd5a9cp-8, 0x1.be0401313a00cp-9,
     -0x1.725291597b15bp-9, 0x1.35a4a461b24ddp-9}, /* [280] 1 <= y <= 1.125 2^-5, degree 10, 60.9 bits */
    {0x1.2beb7ae1ddd69p-1, 0x1.5c3616f715a31p-55, -0x1.7e18b24f7f3b5p-5, 0x1.2f45e7735d50dp-6, -0x1.469abce103a37p-7,
     0x1.8fd07c0d64cd3p-8, -0x1.06a7ed48fc065p-8, 0x1.68f538abd6993p-9, -0x1.ffb52e445f007p-10, 0x1.7313a73e6544ap-10,
     -0x1.135a4a6c11764p-10, 0x1.9c1204b45eb0dp-11}, /* [281] 1.125 <= y <= 1.25 2^-5, degree 10, 61.0 bits */
    {0x1.2912d3370ba63p-1, 0x1.f2aa2273eb959p-56, -0x1.5ba91eaba2aeap-5, 0x1.f48a27461cdbdp-7, -0x1.e83ee3f12b4acp-8,
     0x1.0e9124a51455ap-8, -0x1.41cb5145e2f98p-9, 0x1.9042ced590ed5p-10, -0x1.00c5278cf28bap-10, 0x1.5105c8f38c8fcp-11,
     -0x1.c42c3173d99cdp-12, 0x1.322b69f072a33p-12}, /* [282] 1.25 <= y <= 1.375 2^-5, degree 10, 62.2 bits */
    {0x1.267900da25ccap-1, -0x1.f77f84b9b0c1cp-56, -0x1.3efef5fa3fcf4p-5, 0x1.a44515058c2dap-7, -0x1.76ad998f42a05p-8,
     0x1.7b6467a747695p-9, -0x1.9c2bb1706e8e4p-10, 0x1.d441458bc42edp-11, -0x1.125825851d0c4p-11, 0x1.48da65a3e11cp-12,
     -0x1.929ee6209778ap-13, 0x1.f1e6993bdbc72p-14}, /* [283] 1.375 <= y <= 1.5 2^-5, degree 10, 61.6 bits */
    {0x1.2413e6c74875ap-1, -0x1.71b7934f791fbp-55, -0x1.26c0f20d41decp-5, 0x1.660028869dfabp-7, -0x1.25e7d62ef1a8cp-8,
     0x1.11f44ee4743cp-9, -0x1.11ed40a3a58eap-10, 0x1.1e652d1de4a43p-11, -0x1.34d299cc5df99p-12, 0x1.54a3e2304af8ep-13,
     -0x1.7f88ebcb76f39p-14, 0x1.b46b238f70982p-15}, /* [284] 1.5 <= y <= 1.625 2^-5, degree 10, 62.8 bits */
    {0x1.21dbaf1bfd3fcp-1, -0x1.edecbd4c7bb1fp-55, -0x1.11fa07c45e5b5p-5, 0x1.34b48ab3b4646p-7, -0x1.d5bc15e60706cp-9,
     0x1.95a25b80468d2p-10, -0x1.77b1cffcf544p-11, 0x1.6bceaf2d28c03p-12, -0x1.6b53434d59836p-13, 0x1.73257dfbe784ep-14,
     -0x1.82d15631fed9p-15, 0x1.979b53a3a96aap-16}, /* [285] 1.625 <= y <= 1.75 2^-5, degree 10, 61.3 bits */
    {0x1.1fca2773026f4p-1, -0x1.68fb3e7a1e387p-55, -0x1.ffeecfaea29b1p-6, 0x1.0d0035021c672p-7, -0x1.7d66bbdc40e89p-9,
     0x1.32cbec583b5e7p-10, -0x1.08a6bbc084281p-11, 0x1.dd56ed2d75d09p-13, -0x1.bbee471f805afp-14,
     0x1.a64a9a1e4e1adp-15, -0x1.99af59457e44bp-16, 0x1.91fbbfdeea093p-17},
     /* [286] 1.75 <= y <= 1.875 2^-5, degree 10, 63.7 bits */
    {0x1.1dda530c5e9e2p-1, 0x1.67c842bae97c7p-57, -0x1.e066f562c27b5p-6, 0x1.d9157444247f8p-8, -0x1.39fba136810b4p-9,
     0x1.d8c4b30e17068p-11, -0x1.7da46ef7c8914p-12, 0x1.420e22b3cf4b9p-13, -0x1.18403078a4bc7p-14,
     0x1.f2de94f86b8dfp-16, -0x1.c4afc9ce6fbcbp-17, 0x1.9f9284a5c648p-18},
     /* [287] 1.875 <= y <= 2 2^-5, degree 10, 62.7 bits */
    {0x1.1b290d0be0d9bp-1, -0x1.c751c0baa8e4cp-59, -0x1.b7d587f8cf36ep-5, 0x1.8bd636b84a95bp-6, -0x1.df94ca6a471f8p-7,
     0x1.496b1f12825bfp-7, -0x1.e52682927a9e6p-8, 0x1.756a7b25f60efp-8, -0x1.285b539ea7c88p-8, 0x1.e11c5e230a7a5p-9,
     -0x1.90136f32029a3p-9, 0x1.4ef693cfdd511p-9}, /* [288] 1 <= y <= 1.125 2^-4, degree 10, 60.1 bits */
    {0x1.17e7690942c87p-1, 0x1.9837735cef5fap-55, -0x1.8b65c76ad3a04p-5, 0x1.3f49b6d37d16bp-6, -0x1.5a91c44fa708ep-7,
     0x1.aa56eb99ae413p-8, -0x1.190ffc6b90023p-8, 0x1.834b0a2d0d435p-9, -0x1.131ded01972dep-9, 0x1.8fbcbf5ee5a41p-10,
     -0x1.291536568adcp-10, 0x1.bd30185d978e3p-11}, /* [289] 1.125 <= y <= 1.25 2^-4, degree 10, 60.7 bits */
    {0x1.14f602cd4d3d3p-1, 0x1.51a17ffd07da6p-55, -0x1.672ba38d2164cp-5, 0x1.071572441b22dp-6, -0x1.02ac51a7e4bc5p-7,
     0x1.201ecf14e2374p-8, -0x1.57e33f314a093p-9, 0x1.ace8f2a0ad039p-10, -0x1.13c1492a6122fp-10, 0x1.6a9b404507213p-11,
     -0x1.e7447fdc5ac5dp-12, 0x1.4a62284836e52p-12}, /* [290] 1.25 <= y <= 1.375 2^-4, degree 10, 62.3 bits */
    {0x1.1246aa618d53ep-1, -0x1.1b4d47f0f4366p-55, -0x1.490f16e7d9a5ep-5, 0x1.b92b065bbca99p-7, -0x1.8c7be77a9158dp-8,
     0x1.937e5bd3e99e3p-9, -0x1.b7ee10890736ap-10, 0x1.f52c901424a2p-11, -0x1.26497490abc71p-11, 0x1.616a56b06be53p-12,
     -0x1.b162dc68cdfd1p-13, 0x1.0c5846097ef12p-13}, /* [291] 1.375 <= y <= 1.5 2^-4, degree 10, 61.1 bits */
    {0x1.0fceaa0562cfcp-1, 0x1.aeb28256046ebp-56, -0x1.2fa0a5d5f2c65p-5, 0x1.77506bd021ec3p-7, -0x1.36a0f2c890423p-8,
     0x1.2303d34569dep-9, -0x1.240b1171ac5d2p-10, 0x1.3230dd1da94cfp-11, -0x1.4aea2e976d028p-12, 0x1.6db26d72213ccp-13,
     -0x1.9c6a1da02363p-14, 0x1.d5f0652259a61p-15}, /* [292] 1.5 <= y <= 1.625 2^-4, degree 10, 64.0 bits */
    {0x1.0d85b83da0c57p-1, -0x1.8e26340f53ed8p-56, -0x1.19dbd4eeb129cp-5, 0x1.433e318abdb5dp-7, -0x1.efe4d02b827c9p-9,
     0x1.ae6c18e0f691fp-10, -0x1.901ddd5e66837p-11, 0x1.848d7e0199707p-12, -0x1.84ecb0ba1b361p-13,
     0x1.8e0e0a86ac3b9p-14, -0x1.9f8acfeb7b349p-15, 0x1.b67f3c933b839p-16},
     /* [293] 1.625 <= y <= 1.75 2^-4, degree 10, 62.3 bits */
    {0x1.0b65493b33751p-1, 0x1.44422b161e685p-55, -0x1.0702c8e2ea5afp-5, 0x1.19596ffbf1133p-7, -0x1.92357b2c22428p-9,
     0x1.4535a4dafe687p-10, -0x1.19930dbf58dd8p-11, 0x1.fd504fec7e91bp-13, -0x1.dac2b31835daap-14,
     0x1.c47d30ac747cep-15, -0x1.b7b53205fd6edp-16, 0x1.b00fb713672p-17},
     /* [294] 1.75 <= y <= 1.875 2^-4, degree 10, 64.1 bits */
    {0x1.096819ca18a48p-1, -0x1.39a24c784af5ap-59, -0x1.ed0fa08479a63p-6, 0x1.ee45ea1325e77p-8, -0x1.4ac71ceb5f225p-9,
     0x1.f4a80948112d6p-11, -0x1.95aa604e64163p-12, 0x1.5750770d2f22fp-13, -0x1.2b724a59904d4p-14, 0x1.0b09d88f8485p-15,
     -0x1.e571d1ad98e91p-17, 0x1.be4a7b71a6013p-18}, /* [295] 1.875 <= y <= 2 2^-4, degree 10, 65.1 bits */
    {0x1.06a539e46d8p-1, -0x1.6d0950114a211p-55, -0x1.c2b4ff1bf8ae5p-5, 0x1.9cf32b5fa6257p-6, -0x1.f88502fede63ep-7,
     0x1.5c607d70c910ep-7, -0x1.0181835b4c522p-7, 0x1.8d8e884744602p-8, -0x1.3c42ae7aa0987p-8, 0x1.0137bda0def52p-8,
     -0x1.ac8495c1e9a1ep-9, 0x1.674da8c12cdep-9}, /* [296] 1 <= y <= 1.125 2^-3, degree 10, 59.9 bits */
    {0x1.034fcd0284179p-1, 0x1.235a80de9a7bdp-56, -0x1.9464003e3bbc2p-5, 0x1.4c7cbec38d2edp-6, -0x1.6bf67455b2eaep-7,
     0x1.c22114b0fcb9ap-8, -0x1.29e23655297d5p-8, 0x1.9bb007b735158p-9, -0x1.2525848cbdbe2p-9, 0x1.aac98551436b8p-10,
     -0x1.3dbc35d646d53p-10, 0x1.dcd8e6dd19d9dp-11}, /* [297] 1.125 <= y <= 1.25 2^-3, degree 10, 60.8 bits */
    {0x1.004df0a8174a2p-1, 0x1.5c670e6d8f127p-55, -0x1.6eb24e9acd26bp-5, 0x1.1181d71a63de3p-6, -0x1.0f3a785258018p-7,
     0x1.2fbce27c3795p-8, -0x1.6bef77e9eea8dp-9, 0x1.c746a9179abc6p-10, -0x1.256ad3b4ebd8ap-10, 0x1.829d896b99f3fp-11,
     -0x1.04387774d7119p-11, 0x1.61693dc331b72p-12}, /* [298] 1.25 <= y <= 1.375 2^-3, degree 10, 62.1 bits */
    {0x1.fb21824a7c211p-2, -0x1.c5458c06d8c5p-56, -0x1.4f6a53853abe3p-5, 0x1.c9f39ee06e3dep-7, -0x1.9f20b4685248p-8,
     0x1.a8c6057635a9bp-9, -0x1.d0f30776bd072p-10, 0x1.09a45e208a6f2p-10, -0x1.38bc01d09c39bp-11, 0x1.78578262852f9p-12,
     -0x1.ce51931e3f887p-13, 0x1.1eb2eded5852bp-13}, /* [299] 1.375 <= y <= 1.5 2^-3, degree 10, 61.4 bits */
    {0x1.f61a0ae392a15p-2, -0x1.83d66a73ba434p-57, -0x1.3508e086f3fp-5, 0x1.850bc08f7695dp-7, -0x1.44ccdf8f27a89p-8,
     0x1.31f7da27ff6afp-9, -0x1.34443a417ba52p-10, 0x1.4430fddc417bbp-11, -0x1.5f3d5944623d3p-12, 0x1.84f733b0105aap-13,
     -0x1.b77115eee7bbbp-14, 0x1.f583adb0328cdp-15}, /* [300] 1.5 <= y <= 1.625 2^-3, degree 10, 62.5 bits */
    {0x1.f174233c31843p-2, -0x1.43012744a06f8p-61, -0x1.1e7be326ac8e2p-5, 0x1.4ea1d3fd5e56ap-7, -0x1.02ef8c81ff89p-8,
     0x1.c3fec4ab02273p-10, -0x1.a5d9f60759c0bp-11, 0x1.9aed884a3bce8p-12, -0x1.9c5a9205d422cp-13,
     0x1.a6ebcc38477d1p-14, -0x1.ba4cc07b11e8fp-15, 0x1.d3774e883a6p-16},
     /* [301] 1.625 <= y <= 1.75 2^-3, degree 10, 61.5 bits */
    {0x1.ed221cbd3b1d2p-2, -0x1.ec7bcab770b18p-57, -0x1.0afbd8b7dbbc2p-5, 0x1.22e8228692a65p-7, -0x1.a38b5ef526ef4p-9,
     0x1.551ff9116521p-10, -0x1.288babd59c878p-11, 0x1.0d08df795af44p-12, -0x1.f6d609a3ae017p-14, 0x1.e043aac1528b2p-15,
     -0x1.d38cff05a089dp-16, 0x1.cc2635ecd08ccp-17}, /* [302] 1.75 <= y <= 1.875 2^-3, degree 10, 62.6 bits */
    {0x1.e918fb0ca4b9ep-2, -0x1.ab65664b09c3bp-56, -0x1.f3e810517b339p-6, 0x1.fe7a1daf23318p-8, -0x1.58a7e7d374b35p-9,
     0x1.064d0642e0b17p-10, -0x1.aacb93019a24fp-12, 0x1.6a55782489822p-13, -0x1.3cd7deda3e7e5p-14,
     0x1.1b283f09d40f7p-15, -0x1.01d8e79290935p-16, 0x1.dadc450498623p-18},
     /* [303] 1.875 <= y <= 2 2^-3, degree 10, 62.3 bits */
    {0x1.e380cdf2486acp-2, -0x1.1b62164ebf0c4p-58, -0x1.c832cd19b2ee2p-5, 0x1.a9ce02f61274bp-6, -0x1.0670cacabcc78p-6,
     0x1.6c7fa82265cep-7, -0x1.0e8761a484cf1p-7, 0x1.a2fe13c29b6d6p-8, -0x1.4e2ca15152093p-8, 0x1.10603e6a2c4eap-8,
     -0x1.c69fb71e61975p-9, 0x1.7dcf75b29922ap-9}, /* [304] 1 <= y <= 1.125 2^-2, degree 10, 59.8 bits */
    {0x1.dcc2e98cba797p-2, -0x1.9fa80db7c9bd6p-57, -0x1.987c613891951p-5, 0x1.562b838eb56efp-6, -0x1.79f1eb84c8b79p-7,
     0x1.d61c3e146b699p-8, -0x1.3866604d68d77p-8, 0x1.b124811d48701p-9, -0x1.353b62d8cf605p-9, 0x1.c331da617f652p-10,
     -0x1.508b94dd811cap-10, 0x1.f9e861b53bcb9p-11}, /* [305] 1.125 <= y <= 1.25 2^-2, degree 10, 60.3 bits */
    {0x1.d6b107abc5c2cp-2, 0x1.546fd3c9bbe73p-56, -0x1.71ba4d3f8fb28p-5, 0x1.18f96c05251fp-6, -0x1.192b76a4e8ccap-7,
     0x1.3cb3148a0d85cp-8, -0x1.7d0f80bba2891p-9, 0x1.de41440504e98p-10, -0x1.350b560b37fafp-10, 0x1.981c9f8769166p-11,
     -0x1.1337be66d8f54p-11, 0x1.7666fb26f610ap-12}, /* [306] 1.25 <= y <= 1.375 2^-2, degree 10, 62.0 bits */
    {0x1.d12c41cb1991fp-2, 0x1.bf09488278d1ap-57, -0x1.519e42c47d79dp-5, 0x1.d5b0f36d6963p-7, -0x1.adac27db633c5p-8,
     0x1.ba3b5499b91b1p-9, -0x1.e61ccb8f55c51p-10, 0x1.16a62984f97abp-10, -0x1.48ed3f68ab5f2p-11, 0x1.8cb7ced511ebep-12,
     -0x1.e84c134a83949p-13, 0x1.2f51eb0967296p-13}, /* [307] 1.375 <= y <= 1.5 2^-2, degree 10, 62.7 bits */
    {0x1.cc1d57423882dp-2, 0x1.cd060412ea33bp-56, -0x1.3694cd706ba1dp-5, 0x1.8e6bd4f6e5638p-7, -0x1.4fb20a77c8984p-8,
     0x1.3e1937ad54bf8p-9, -0x1.41dc05089eb16p-10, 0x1.539ceae2222f2p-11, -0x1.70f1aa2f339c8p-12, 0x1.9980015f6a086p-13,
     -0x1.cf8c78a9c09ep-14, 0x1.08f6e30b4c5d7p-14}, /* [308] 1.5 <= y <= 1.625 2^-2, degree 10, 60.7 bits */
    {0x1.c772578a3137fp-2, 0x1.bd47c694871bp-56, -0x1.1f80c1aed0fe3p-5, 0x1.56380bcf3eeb5p-7, -0x1.0b4331f6fb466p-8,
     0x1.d54dbbd0b11a5p-10, -0x1.b7e507c65672ep-11, 0x1.adf121ffdfe78p-12, -0x1.b09cb7e2cb43p-13, 0x1.bcb758bb91285p-14,
     -0x1.d203a565c2c54p-15, 0x1.ed60c9bbecdafp-16}, /* [309] 1.625 <= y <= 1.75 2^-2, degree 10, 62.8 bits */
    {0x1.c31d20b4cb2fep-2, 0x1.4f8323381622bp-57, -0x1.0b92d1320ad0ap-5, 0x1.291d772a9f4d1p-7, -0x1.b07e161b68fc6p-9,
     0x1.61c1ae85ebb95p-10, -0x1.34dcc30c3f194p-11, 0x1.192809869cccep-12, -0x1.0778304bba427p-13,
     0x1.f8730104996cep-15, -0x1.ec13508639ac6p-16, 0x1.e520978307378p-17},
     /* [310] 1.75 <= y <= 1.875 2^-2, degree 10, 61.1 bits */
    {0x1.bf125d98aa472p-2, 0x1.3037424f0962cp-58, -0x1.f4614b39a05ap-6, 0x1.045e01b6c71f9p-7, -0x1.62dfb4b8073b7p-9,
     0x1.0fb3d289813c6p-10, -0x1.bc0690e78dd31p-12, 0x1.7a3ee8bd7f575p-13, -0x1.4bacc7ae9e387p-14,
     0x1.291a5672c2017p-15, -0x1.0f1722e5b787ap-16, 0x1.f41fc9ead586p-18},
     /* [311] 1.875 <= y <= 2 2^-2, degree 10, 62.6 bits */
    {0x1.b97a1652e0f7fp-2, 0x1.fac11d65b948p-57, -0x1.c7d4c22f4468dp-5, 0x1.b19f10ab82a56p-6, -0x1.0dc6d0e271b85p-6,
     0x1.78f5bf49bbfd3p-7, -0x1.190300ec4194dp-7, 0x1.b4b99341115bap-8, -0x1.5d4b0c7747addp-8, 0x1.1d5e96cc7c77cp-8,
     -0x1.dd49983009316p-9, 0x1.918dc8dca5482p-9}, /* [312] 1 <= y <= 1.125 2^-1, degree 10, 59.7 bits */
    {0x1.b2bf694f91957p-2, 0x1.a96dafe37da27p-56, -0x1.974ab7b1a393bp-5, 0x1.5bbb40293a231p-6, -0x1.83bbab5c94e12p-7,
     0x1.e53cbeae9b882p-8, -0x1.43e3b715aa7ap-8, 0x1.c2a27b0b13c12p-9, -0x1.42a1e62560ba2p-9, 0x1.d7deae9f4e8ep-10,
     -0x1.60b21846f96f9p-10, 0x1.09918f5d7fda6p-10}, /* [313] 1.125 <= y <= 1.25 2^-1, degree 10, 60.2 bits */
    {0x1.acb38e5110b61p-2, 0x1.670688650a0afp-56, -0x1.6ff0a85d8abbp-5, 0x1.1d0189715f947p-6, -0x1.1fed7dc50acd5p-7,
     0x1.464ff9043b3a2p-8, -0x1.8a64a95c3a2ccp-9, 0x1.f0ba1270e5758p-10, -0x1.41e68b7fb34eap-10, 0x1.aa1d488cc0a89p-11,
     -0x1.1ff583730f7c8p-11, 0x1.88725e1b05985p-12}, /* [314] 1.25 <= y <= 1.375 2^-1, degree 10, 60.6 bits */
    {0x1.a736d8394f42fp-2, 0x1.9e053205122e8p-56, -0x1.4f65b5714ceafp-5, 0x1.db9d0998d3968p-7, -0x1.b744666abd248p-8,
     0x1.c6ea875bf9ef9p-9, -0x1.f652bd777bf7ap-10, 0x1.20f63003efeecp-10, -0x1.56163ac9d7488p-11, 0x1.9d98565b32cd1p-12,
     -0x1.fe24ec123a805p-13, 0x1.3d78f829c0fc8p-13}, /* [315] 1.375 <= y <= 1.5 2^-1, degree 10, 61.0 bits */
    {0x1.a2317bafe0fe6p-2, 0x1.75509832f7857p-60, -0x1.340a722f3fe23p-5, 0x1.92ce6f0e2765p-7, -0x1.56a9ff96a2d6dp-8,
     0x1.46bb69541b87cp-9, -0x1.4c1aef38f8764p-10, 0x1.5face772a568ep-11, -0x1.7f29aaa957d39p-12, 0x1.aa5397aef6324p-13,
     -0x1.e39f65fdf73ep-14, 0x1.14f36c451ba3p-14}, /* [316] 1.5 <= y <= 1.625 2^-1, degree 10, 61.1 bits */
    {0x1.9d9124c966f24p-2, 0x1.2d25a0a921ba3p-56, -0x1.1cb9b3fdd6f1ap-5, 0x1.597a31bc84bep-7, -0x1.106bb8883ad03p-8,
     0x1.e15e92fae06fap-10, -0x1.c547623759429p-11, 0x1.bc9debcf01586p-12, -0x1.c0b17ee9c4ca4p-13,
     0x1.ce63b4fd7c55bp-14, -0x1.e59286670b566p-15, 0x1.0185d03e9326p-15},
     /* [317] 1.625 <= y <= 1.75 2^-1, degree 10, 61.6 bits */
    {0x1.994768d2fc313p-2, -0x1.fe68b6862a35ap-57, -0x1.089eac537957cp-5, 0x1.2b886c0b66b32p-7, -0x1.b84067cdf322fp-9,
     0x1.6a610750e7f85p-10, -0x1.3dda967d44642p-11, 0x1.22638e6ffa13p-12, -0x1.10ed38d987569p-13, 0x1.05ee0c5371836p-14,
     -0x1.000e6bcdee3f3p-15, 0x1.f9d5284c07cp-17}, /* [318] 1.75 <= y <= 1.875 2^-1, degree 10, 61.6 bits */
    {0x1.9548bc6822832p-2, -0x1.8703bac656543p-56, -0x1.ee36474e150dbp-6, 0x1.06260d2e2eaafp-7, -0x1.68c9bc1ccd878p-9,
     0x1.15fc06620eb9ep-10, -0x1.c8678b79fe785p-12, 0x1.8634eb139732fp-13, -0x1.572eb58ea158p-14, 0x1.342ed0c16df03p-15,
     -0x1.19cfa2355a31ep-16, 0x1.0471c4940b7fap-17}, /* [319] 1.875 <= y <= 2 2^-1, degree 10, 61.6 bits */
    {0x1.8fc3644d3c6ccp-2, 0x1.4902a06a1618bp-56, -0x1.c165d222223e6p-5, 0x1.b3cea8f3d354bp-6, -0x1.11cb46dcac46cp-6,
     0x1.810496810935ep-7, -0x1.205cf63ba4d61p-7, 0x1.c1cb933c2719ap-8, -0x1.68d3e14e3a12fp-8, 0x1.278a42a2576a4p-8,
     -0x1.ef640835e879ep-9, 0x1.a1951d4f082adp-9}, /* [320] 1 <= y <= 1.125 2^0, degree 10, 59.3 bits */
    {0x1.8922e26a15a34p-2, 0x1.f78b8f71c0c5cp-60, -0x1.90aa699d76afcp-5, 0x1.5cba24143a6bbp-6, -0x1.88ac95950884dp-7,
     0x1.ee9561c7aa7bp-8, -0x1.4bb0048c230b9p-8, 0x1.cf31d4c099147p-9, -0x1.4ca1977db0677p-9, 0x1.e7bd5c25c467bp-10,
     -0x1.6d5ed918e5f51p-10, 0x1.13a52d4b95396p-10}, /* [321] 1.125 <= y <= 1.25 2^0, degree 10, 60.7 bits */
    {0x1.8331b6b6b3d1ap-2, -0x1.bf9d49448f93fp-56, -0x1.693d3feccfc8fp-5, 0x1.1d42e0594fccep-6, -0x1.2309858006a8dp-7,
     0x1.4bf8ee307e596p-8, -0x1.9324c297de146p-9, 0x1.fda51eabb8c85p-10, -0x1.4b488a1b2f805p-10, 0x1.b7ab2147fea41p-11,
     -0x1.29c95db0abbd9p-11, 0x1.96a26f52febdep-12}, /* [322] 1.25 <= y <= 1.375 2^0, degree 10, 60.5 bits */
    {0x1.7dcfd370832aep-2, 0x1.5b680bfafb415p-56, -0x1.48b2335ce1a3cp-5, 0x1.db2f8779eac81p-7, -0x1.bb3b2c361202dp-8,
     0x1.ce028ff9cce05p-9, -0x1.004cccf3d65d5p-9, 0x1.27fbb62c0efddp-10, -0x1.5f7b09d5fbf48p-11, 0x1.aa0f657e56378p-12,
     -0x1.075acc2e25fc2p-12, 0x1.486dbc8fd05b6p-13}, /* [323] 1.375 <= y <= 1.5 2^0, degree 10, 60.8 bits */
    {0x1.78e53021a9299p-2, 0x1.856aa1a89fbe7p-56, -0x1.2d62eeaf83633p-5, 0x1.91c78836e4a43p-7, -0x1.59323e04ed001p-8,
     0x1.4b4cc6aab59f6p-9, -0x1.525ed8a0e7294p-10, 0x1.67aacd8a1fd6cp-11, -0x1.89167bebb47d6p-12, 0x1.b684a54c13a9cp-13,
     -0x1.f29649594954bp-14, 0x1.1e16be76cabcbp-14}, /* [324] 1.5 <= y <= 1.625 2^0, degree 10, 61.5 bits */
    {0x1.745f51e267701p-2, 0x1.772440e4e9b06p-56, -0x1.1625e767a414bp-5, 0x1.5811a8ff1ec0ap-7, -0x1.12057e7d7837ap-8,
     0x1.e7610b46c0146p-10, -0x1.cd2902773bedap-11, 0x1.c6123332b064dp-12, -0x1.cbaaca597d2a2p-13,
     0x1.daf34ff9448c2p-14, -0x1.f3e8509c87d87p-15, 0x1.09a8360c7b67fp-15},
     /* [325] 1.625 <= y <= 1.75 2^0, degree 10, 63.6 bits */
    {0x1.702fb53284ce8p-2, -0x1.0b1ce2b8de627p-58, -0x1.022377d369b91p-5, 0x1.29e2df6c6804dp-7, -0x1.ba37acef4787ap-9,
     0x1.6e65d71062f32p-10, -0x1.42f13f6910869p-11, 0x1.282af025c5336p-12, -0x1.173bbe89fb328p-13,
     0x1.0cb1f74e91cf3p-14, -0x1.0746ad770bf23p-15, 0x1.0492961bf2cf3p-16},
     /* [326] 1.75 <= y <= 1.875 2^0, degree 10, 60.9 bits */
    {0x1.6c4abf2c5f3dep-2, -0x1.f80ea00e30b21p-57, -0x1.e1770de753ba5p-6, 0x1.045bf0f99577p-7, -0x1.69ec3de45aaaap-9,
     0x1.18b44ad5d55b3p-10, -0x1.cf1f1ac5a96dep-12, 0x1.8d79258ac02cdp-13, -0x1.5eada8b36cc4fp-14,
     0x1.3bc1a63730cc8p-15, -0x1.21680a8dbd87ep-16, 0x1.0c01d952e848bp-17},
     /* [327] 1.875 <= y <= 2 2^0, degree 10, 63.0 bits */
    {0x1.66eb20d670feep-2, -0x1.4e67152808001p-56, -0x1.b4ff529a6d113p-5, 0x1.b00750ce799ffp-6, -0x1.12272c0814c91p-6,
     0x1.8415efe517aa3p-7, -0x1.2416bc4a659f5p-7, 0x1.c95f0602e4a7bp-8, -0x1.7012b5ddd1436p-8, 0x1.2e496aa5f10adp-8,
     -0x1.fbe4eedee94cfp-9, 0x1.acff913e3b10dp-9}, /* [328] 1 <= y <= 1.125 2^1, degree 10, 59.2 bits */
    {0x1.607b45900a74cp-2, -0x1.7f528d7f7a4e1p-56, -0x1.84bdb45904141p-5, 0x1.58ed5a82e4bb7p-6, -0x1.885183cfeb6a7p-7,
     0x1.f1700544fe707p-8, -0x1.4f4053e0ab42ap-8, 0x1.d5ff7e13c516ap-9, -0x1.52999dba9ff52p-9, 0x1.f1d759c529247p-10,
     -0x1.75d2a9b4ac52ep-10, 0x1.1a9ad4bab1348p-10}, /* [329] 1.125 <= y <= 1.25 2^1, degree 10, 60.6 bits */
    {0x1.5ab8db88d40b9p-2, -0x1.a079868c47da6p-59, -0x1.5dc87b1a3f3a1p-5, 0x1.19948637d3574p-6, -0x1.2230d854f56b2p-7,
     0x1.4d3a89146ea47p-8, -0x1.96ae719990e68p-9, 0x1.021171a423dfap-9, -0x1.509652acc34b9p-10, 0x1.bfee4a8969314p-11,
     -0x1.301b7b6bf9bdfp-11, 0x1.a0219ac9285c8p-12}, /* [330] 1.25 <= y <= 1.375 2^1, degree 10, 61.4 bits */
    {0x1.5583e365d2b9ap-2, 0x1.719969303260ap-59, -0x1.3db06ee452a1ap-5, 0x1.d42f656bc8916p-7, -0x1.b9220d1804b22p-8,
     0x1.ceebc026180a5p-9, -0x1.0216a458f97cp-9, 0x1.2b39bb812adeep-10, -0x1.647c806d2d206p-11, 0x1.b151b8812b3a3p-12,
     -0x1.0c7c31426c312p-12, 0x1.4f87aec2a312dp-13}, /* [331] 1.375 <= y <= 1.5 2^1, degree 10, 60.7 bits */
    {0x1.50c46b6d933a9p-2, 0x1.32ddb2d5dee26p-60, -0x1.22cdf15cd3dep-5, 0x1.8b2fac5ffecedp-7, -0x1.56fbae2f5cb6p-8,
     0x1.4b669a3d78795p-9, -0x1.542bfe61911bbp-10, 0x1.6b044a4f667d3p-11, -0x1.8e0bbfee5d962p-12, 0x1.bd47d1e32b3c2p-13,
     -0x1.fb7fa11cbea2cp-14, 0x1.23d162d596debp-14}, /* [332] 1.5 <= y <= 1.625 2^1, degree 10, 61.5 bits */
    {0x1.4c68129543416p-2, 0x1.9dd21db9d244p-56, -0x1.0bf716b0158b1p-5, 0x1.51e3af45b48bcp-7, -0x1.0fd6e5daa3807p-8,
     0x1.e6c67df56e2bcp-10, -0x1.cee89ae54c3c9p-11, 0x1.c99bf65296647p-12, -0x1.d0c55f739b73dp-13,
     0x1.e19008cd22138p-14, -0x1.fc18e66ec2f73p-15, 0x1.0e9560d67ccb7p-15},
     /* [333] 1.625 <= y <= 1.75 2^1, degree 10, 62.1 bits */
    {0x1.48606fbb0468ap-2, 0x1.6f9645ca74729p-56, -0x1.f0a898bc2592dp-6, 0x1.241b5e4de239bp-7, -0x1.b60ecca71fa53p-9,
     0x1.6d6ae82dab64fp-10, -0x1.43b4b4cb0d274p-11, 0x1.2a0e465340ffp-12, -0x1.19f0daa15d93cp-13, 0x1.100f7244c26ddp-14,
     -0x1.0b39250c2c521p-15, 0x1.090b7653e3475p-16}, /* [334] 1.75 <= y <= 1.875 2^1, degree 10, 62.3 bits */
    {0x1.44a2018b19fa1p-2, 0x1.e8d90f51c68e8p-57, -0x1.ce8b8ac49eeb5p-6, 0x1.fdea471b68139p-8, -0x1.6607b3e6c04a5p-9,
     0x1.17937d00b86a7p-10, -0x1.cf99106b67cc5p-12, 0x1.8f7acf98e99e2p-13, -0x1.619dcaba30eacp-14,
     0x1.3f4c2b9757927p-15, -0x1.255e4d000460ep-16, 0x1.104291dfe624fp-17},
     /* [335] 1.875 <= y <= 2 2^1, degree 10, 61.8 bits */
    {0x1.3f79ad9b8f582p-2, -0x1.066def3324f32p-59, -0x1.a30a6e4af5356p-5, 0x1.a64280c67ee6dp-6, -0x1.0eb0eb71dd11bp-6,
     0x1.81cd4d4402d96p-7, -0x1.23d8ebc31b787p-7, 0x1.cad630ffe2c4dp-8, -0x1.727b79191357fp-8, 0x1.312052d34393ap-8,
     -0x1.00f818c73376bp-8, 0x1.b30aaa4dbaca5p-9}, /* [336] 1 <= y <= 1.125 2^2, degree 10, 59.4 bits */
    {0x1.394f4f4529318p-2, 0x1.aed6c554211adp-56, -0x1.73edc24474d1p-5, 0x1.505a587cbf37fp-6, -0x1.827a75c032554p-7,
     0x1.ed63c6bac9dfap-8, -0x1.4e38f6b964a5fp-8, 0x1.d674c4491e36ep-9, -0x1.5410daeb84e83p-9, 0x1.f56ba05ae192ap-10,
     -0x1.797334df5189p-10, 0x1.1df7ea6bc72a4p-10}, /* [337] 1.125 <= y <= 1.25 2^2, degree 10, 60.9 bits */
    {0x1.33ce16a74d5dep-2, -0x1.6bf0777c69e85p-57, -0x1.4dfa5cad179aap-5, 0x1.1202ddf65d42cp-6, -0x1.1d47c4a2fc007p-7,
     0x1.49d6fc4c8ed43p-8, -0x1.949c398b12986p-9, 0x1.01ccc531d689dp-9, -0x1.515eb19844bd6p-10, 0x1.c2422d7efe6c3p-11,
     -0x1.3274304e4701ap-11, 0x1.a443014818897p-12}, /* [338] 1.25 <= y <= 1.375 2^2, degree 10, 61.0 bits */
    {0x1.2ed685677d323p-2, 0x1.135edd6c168a8p-56, -0x1.2ec69908caec8p-5, 0x1.c6bd5523ca17ep-7, -0x1.b0d9e959cbe98p-8,
     0x1.c95b280109847p-9, -0x1.004c3fc504d37p-9, 0x1.2a5d6539eb732p-10, -0x1.64a9e352507d6p-11, 0x1.b2c860aab0d81p-12,
     -0x1.0e11e5494750dp-12, 0x1.524146f413454p-13}, /* [339] 1.375 <= y <= 1.5 2^2, degree 10, 60.8 bits */
    {0x1.2a511669c9637p-2, 0x1.3163473156bf6p-56, -0x1.14af79c27883bp-5, 0x1.7f2be234bf9f7p-7, -0x1.4ff60b6ab3ee2p-8,
     0x1.46da8b4054cddp-9, -0x1.513c32ee2a52cp-10, 0x1.695c12628068ep-11, -0x1.8d93229a651efp-12, 0x1.be0a12923ecfdp-13,
     -0x1.fda5c6ffc9da6p-14, 0x1.25b40e7886f14p-14}, /* [340] 1.5 <= y <= 1.625 2^2, degree 10, 60.6 bits */
    {0x1.262bc4760caf1p-2, -0x1.a0d85dd2c5ad8p-58, -0x1.fd1dbb78ccfdp-6, 0x1.471768f89d699p-7, -0x1.09d8e89ddae99p-8,
     0x1.df54e635e59d2p-10, -0x1.ca2fca2be9e8dp-11, 0x1.c6ce333b2db55p-12, -0x1.cf7f6b153723bp-13,
     0x1.e1a31dbc47799p-14, -0x1.fd76c8f9f23e2p-15, 0x1.0fea65e95407ap-15},
     /* [341] 1.625 <= y <= 1.75 2^2, degree 10, 61.9 bits */
    {0x1.225874804127bp-2, -0x1.9fc9111978c48p-57, -0x1.d720988dc27a9p-6, 0x1.1a59c84496a72p-7, -0x1.abc354b75995dp-9,
     0x1.674bc8aad6a27p-10, -0x1.3fee94f54a09cp-11, 0x1.27cbde8f1394dp-12, -0x1.18c29968b0045p-13,
     0x1.0fb5c318497cfp-14, -0x1.0b8ec560e0601p-15, 0x1.09f850c39c554p-16},
     /* [342] 1.75 <= y <= 1.875 2^2, degree 10, 62.3 bits */
    {0x1.1ecbe80b1b6f3p-2, -0x1.7faf15d433c18p-56, -0x1.b62d070087985p-6, 0x1.ec32c23ad2ae9p-8, -0x1.5d20f197c7a11p-9,
     0x1.1282de102cd0bp-10, -0x1.c98fb6aa22392p-12, 0x1.8be89c1cff1d7p-13, -0x1.5fa816ebe8a3p-14, 0x1.3e749bd8ebb85p-15,
     -0x1.25573e56e3f5bp-16, 0x1.10d871bef2d3dp-17}, /* [343] 1.875 <= y <= 2 2^2, degree 10, 62.5 bits */
    {0x1.19ea4e5e7127ap-2, 0x1.db2ca43621d12p-56, -0x1.8c3913618f03ep-5, 0x1.96cd61af957d4p-6, -0x1.07736154a4702p-6,
     0x1.7a153ec4e9df6p-7, -0x1.1f7ee0c86bd7dp-7, 0x1.c5dea55b69facp-8, -0x1.6fbb808e3f768p-8, 0x1.2fbff02452982p-8,
     -0x1.007875cf387bep-8, 0x1.b32d125a6955ap-9}, /* [344] 1 <= y <= 1.125 2^3, degree 10, 59.5 bits */
    {0x1.14178e7d306bdp-2, -0x1.e89a81d765115p-56, -0x1.5ee325e365738p-5, 0x1.43497e34d7d45p-6, -0x1.7743729db2a0ep-7,
     0x1.e264cb0a866c8p-8, -0x1.487a26c89215ep-8, 0x1.d04af6c2c68c1p-9, -0x1.50c512fa77ec9p-9, 0x1.f20605be1f693p-10,
     -0x1.77dd2309cad8cp-10, 0x1.1d697d419bb89p-10}, /* [345] 1.125 <= y <= 1.25 2^3, degree 10, 60.6 bits */
    {0x1.0ee76661a799ep-2, -0x1.2caf2d4c45ab1p-56, -0x1.3a72c11fd9263p-5, 0x1.06d0dfe907c26p-6, -0x1.146b5ee521159p-7,
     0x1.41cfd921339f9p-8, -0x1.8cd2f053793e9p-9, 0x1.fbc98c2b2bfbfp-10, -0x1.4d68c5259942dp-10, 0x1.be49e21f23015p-11,
     -0x1.308a5d1553b5dp-11, 0x1.a296c2ac8dac3p-12}, /* [346] 1.25 <= y <= 1.375 2^3, degree 10, 61.4 bits */
    {0x1.0a3b489da634cp-2, 0x1.02a47ae70acb3p-58, -0x1.1c8c85a09e3b4p-5, 0x1.b3548df4a6875p-7, -0x1.a29a86284649ap-8,
     0x1.bd5f0e04358b6p-9, -0x1.f5c60aff628adp-10, 0x1.254967ef57ae8p-10, -0x1.5fcfb9d08eefbp-11, 0x1.ae23e6ed19dc8p-12,
     -0x1.0be1a813f0766p-12, 0x1.5048019ab6d3cp-13}, /* [347] 1.375 <= y <= 1.5 2^3, degree 10, 61.1 bits */
    {0x1.05fc6fe86291ap-2, -0x1.4373b2e5484b2p-56, -0x1.0397f9f54519p-5, 0x1.6e2d4bff2ee9p-7, -0x1.4454f255420fdp-8,
     0x1.3dbacd5a9ed3bp-9, -0x1.4989951925443p-10, 0x1.629716749c0a1p-11, -0x1.877c467334dcfp-12, 0x1.b883b642c84a4p-13,
     -0x1.f8a5bf3cee404p-14, 0x1.237d3ee130047p-14}, /* [348] 1.5 <= y <= 1.625 2^3, degree 10, 62.9 bits */
    {0x1.0219724de6898p-2, 0x1.256fea7a1d973p-56, -0x1.dcedcf2e137d5p-6, 0x1.3814ba8961767p-7, -0x1.003a77c42d3eap-8,
     0x1.d131ddff3b578p-10, -0x1.bf00ccd7e8ebbp-11, 0x1.bd90c4277ce95p-12, -0x1.c7aa6303d45cep-13,
     0x1.dae91cc68b582p-14, -0x1.f7a94ef3adc11p-15, 0x1.0d6ff8e2c3de5p-15},
     /* [349] 1.625 <= y <= 1.75 2^3, degree 10, 61.2 bits */
    {0x1.fd0968806ca5cp-3, -0x1.c9ca5cee8b2ap-60, -0x1.b8b5d0cba20edp-6, 0x1.0cfda413ada31p-7, -0x1.9ba9ef9e1b20bp-9,
     0x1.5c2c4b20ad612p-10, -0x1.37a71fcd322b9p-11, 0x1.215a11929477ep-12, -0x1.139a66403cad2p-13, 0x1.0b842a34a2ebp-14,
     -0x1.081e17c72b1a3p-15, 0x1.0728014fc3474p-16}, /* [350] 1.75 <= y <= 1.875 2^3, degree 10, 61.6 bits */
    {0x1.f666c28ac27edp-3, -0x1.9bf7e5fabdae3p-58, -0x1.9956ee0e32521p-6, 0x1.d44152314fbabp-8, -0x1.4f8408af7d7c4p-9,
     0x1.09a3456a48b1fp-10, -0x1.bd17d83fa311p-12, 0x1.82bd4157b2cc6p-13, -0x1.58b6e759f0d2ap-14, 0x1.391a74d750b8ep-15,
     -0x1.212ab4251c6fbp-16, 0x1.0d95dfbc1b8cdp-17}, /* [351] 1.875 <= y <= 2 2^3, degree 10, 63.0 bits */
    {0x1.ed4a2e7dd48cap-3, 0x1.a3cc8c12a68c1p-57, -0x1.717720d334406p-5, 0x1.8244326d6d162p-6, -0x1.f95e7b47a81fbp-7,
     0x1.6d257c7227a3ap-7, -0x1.171d8ec6abd8fp-7, 0x1.ba7e914d35626p-8, -0x1.67c5e3702650dp-8, 0x1.2a111fcbb2ab5p-8,
     -0x1.f8adbe6760ceep-9, 0x1.ad28c13a70a9fp-9}, /* [352] 1 <= y <= 1.125 2^4, degree 10, 59.2 bits */
    {0x1.e2711a01db5f5p-3, -0x1.e722a33c9346ep-58, -0x1.4677a029929afp-5, 0x1.324132ac3b9abp-6, -0x1.67151b63a04a9p-7,
     0x1.d0ca583eab0c7p-8, -0x1.3e26c4f457f7ep-8, 0x1.c397a947e6e9cp-9, -0x1.48b554aa8341cp-9, 0x1.e7906729bf77p-10,
     -0x1.70f2245dcc925p-10, 0x1.18cf99c727b2dp-10}, /* [353] 1.125 <= y <= 1.25 2^4, degree 10, 59.8 bits */
    {0x1.d8cc1b11c5e27p-3, 0x1.5c3fd77d5ebd7p-63, -0x1.23fbc1e43287dp-5, 0x1.f0e66ee292109p-7, -0x1.07f0faa4606b4p-7,
     0x1.3569166dc30b8p-8, -0x1.7f88b2ec4ba31p-9, 0x1.ecd9acdae539ep-10, -0x1.44bd706e72c05p-10, 0x1.b3fe8235e05bp-11,
     -0x1.2a4e2502d4317p-11, 0x1.9af9c242b9a28p-12}, /* [354] 1.25 <= y <= 1.375 2^4, degree 10, 61.1 bits */
    {0x1.d020c6b280387p-3, 0x1.b415d7a6cd266p-58, -0x1.07bea8aeb93e1p-5, 0x1.9ac157963ee83p-7, -0x1.8ef06d9b2fbffp-8,
     0x1.ab61c697974c4p-9, -0x1.e4082d2d08fa1p-10, 0x1.1c1c2e372927fp-10, -0x1.5600e8c3c35c9p-11, 0x1.a3691edce3324p-12,
     -0x1.05e4932a095f8p-12, 0x1.4988608e84901p-13}, /* [355] 1.375 <= y <= 1.5 2^4, degree 10, 60.3 bits */
    {0x1.c843a9cdab264p-3, -0x1.f4f22476d7fbdp-57, -0x1.e06fcf87fb2cap-6, 0x1.58e82583fe0d9p-7, -0x1.348d477926482p-8,
     0x1.305b416542778p-9, -0x1.3d52854936251p-10, 0x1.56e30eee99243p-11, -0x1.7be5fae97b9e4p-12, 0x1.acc4901cf30fep-13,
     -0x1.ec7edbe5d5d64p-14, 0x1.1d2312ab613bap-14}, /* [356] 1.5 <= y <= 1.625 2^4, degree 10, 62.0 bits */
    {0x1.c11399d581cd5p-3, -0x1.b1a68a88a0f77p-58, -0x1.b8aa1781e5204p-6, 0x1.257bc7b2b8ee7p-7, -0x1.e6bb747c83e29p-9,
     0x1.bce3082a35b3ep-10, -0x1.adbaba00306ffp-11, 0x1.ae278864bd46bp-12, -0x1.b974b886b4501p-13,
     0x1.cd7e0070dfa8fp-14, -0x1.eabb403876d77p-15, 0x1.0723052cafa47p-15},
     /* [357] 1.625 <= y <= 1.75 2^4, degree 10, 63.6 bits */
    {0x1.ba76b765f1a0ep-3, -0x1.7d1e33b7bbea6p-59, -0x1.96a102a266497p-6, 0x1.f92c46743d743p-8, -0x1.8668ea91845d3p-9,
     0x1.4c77f6fc58e1ep-10, -0x1.2b276b9c3d821p-11, 0x1.16eb40c9b0fdap-12, -0x1.0a9a513deaadfp-13,
     0x1.03902a0767a27p-14, -0x1.00f2635ea0941p-15, 0x1.009d1024aae8ap-16},
     /* [358] 1.75 <= y <= 1.875 2^4, degree 10, 62.5 bits */
    {0x1.b458736bf8377p-3, -0x1.ca6a72adc2794p-57, -0x1.7931079afd29p-6, 0x1.b71785ca8aef1p-8, -0x1.3dbf04ce5843ap-9,
     0x1.fa98248529162p-11, -0x1.aaa2e37e47cfp-12, 0x1.7443f71e4f03dp-13, -0x1.4cfbd6c0d19cap-14, 0x1.2f5d33e9ead8ep-15,
     -0x1.18ead08fa02a6p-16, 0x1.0682cac754c7bp-17}, /* [359] 1.875 <= y <= 2 2^4, degree 10, 62.2 bits */
    {0x1.abf4ffa980b09p-3, -0x1.1a7299f7dd1edp-57, -0x1.53d5f6111dc68p-5, 0x1.6984bcac7ccccp-6, -0x1.ddac6ac7ffbdp-7,
     0x1.5b803d043d3a8p-7, -0x1.0b03f206d4f5dp-7, 0x1.a9188709a7d29p-8, -0x1.5ad88f515f99ep-8, 0x1.203a3b451b2d7p-8,
     -0x1.e95439028e19fp-9, 0x1.a11614d8812c4p-9}, /* [360] 1 <= y <= 1.125 2^5, degree 10, 58.7 bits */
    {0x1.a1fd62175763ep-3, -0x1.52394419f6131p-58, -0x1.2ba34619b0d05p-5, 0x1.1dfa0594d7b4bp-6, -0x1.529c6580fe021p-7,
     0x1.b94992a789ecap-8, -0x1.2fa3998c99e4ep-8, 0x1.b0ced64158551p-9, -0x1.3c256a080f074p-9, 0x1.d65a13d17f068p-10,
     -0x1.64e00a329c319p-10, 0x1.1043a61ee6046p-10}, /* [361] 1.125 <= y <= 1.25 2^5, degree 10, 59.4 bits */
    {0x1.99257b3d5dc4p-3, -0x1.262f8493097b6p-58, -0x1.0b783f3d82507p-5, 0x1.cf0ba6dddaad9p-7, -0x1.f0be46323230bp-8,
     0x1.25246e2e66703p-8, -0x1.6d429bc42a4b6p-9, 0x1.d75795bc1cfa2p-10, -0x1.37a9a7037cc54p-10, 0x1.a3b45e69b8c6cp-11,
     -0x1.1fedbb1e9a7aap-11, 0x1.8d9db7b58c21p-12}, /* [362] 1.25 <= y <= 1.375 2^5, degree 10, 59.8 bits */
    {0x1.91364135e67afp-3, -0x1.50239156337efp-57, -0x1.e25bb46bed8e3p-6, 0x1.7e0e99118de6cp-7, -0x1.76b102f5b789bp-8,
     0x1.9421dfb9f07bbp-9, -0x1.cc141f2265678p-10, 0x1.0f2f44506a4ep-10, -0x1.479808d7a2f62p-11, 0x1.92f4e0c45e1a6p-12,
     -0x1.f89515be82ad4p-13, 0x1.3e33728072e01p-13}, /* [363] 1.375 <= y <= 1.5 2^5, degree 10, 61.6 bits */
    {0x1.8a06d99cac8d6p-3, 0x1.80e72744af8d8p-57, -0x1.b6a12d53b6082p-6, 0x1.404362e33d981p-7, -0x1.214b156b20aefp-8,
     0x1.1f4af314f201dp-9, -0x1.2d15b9c66b2bap-10, 0x1.46b4bf8edcb1cp-11, -0x1.6b3e99744b491p-12, 0x1.9b368c0bdc85dp-13,
     -0x1.d997d6e52195bp-14, 0x1.12d74dcd7f70ap-14}, /* [364] 1.5 <= y <= 1.625 2^5, degree 10, 62.7 bits */
    {0x1.837823fe86d7dp-3, -0x1.81a18ca17f8c1p-57, -0x1.91ba3f941bd6ap-6, 0x1.101653fe819d6p-7, -0x1.c79ecd4087d15p-9,
     0x1.a3434a8f6fc62p-10, -0x1.9712fa87144bap-11, 0x1.992f00368e999p-12, -0x1.a5690bf3468ep-13, 0x1.b9deb7dd2e25dp-14,
     -0x1.d71ea10cf40eap-15, 0x1.fa6f6e410459dp-16}, /* [365] 1.625 <= y <= 1.75 2^5, degree 10, 60.8 bits */
    {0x1.7d71e2c1edbd8p-3, -0x1.26ce8989b8096p-57, -0x1.72322d31a4cf6p-6, 0x1.d3aa068fd23e6p-8, -0x1.6ce95d1d71442p-9,
     0x1.38d91c8c8e05p-10, -0x1.1af40d438e8bp-11, 0x1.08eae6e109c9bp-12, -0x1.fc37c47baaf17p-14, 0x1.f04b74c069b77p-15,
     -0x1.ec9a0c33c925fp-16, 0x1.ed2011375bbe2p-17}, /* [366] 1.75 <= y <= 1.875 2^5, degree 10, 62.8 bits */
    {0x1.77e0da7fb8bbdp-3, -0x1.5b2f6c3de068ep-57, -0x1.56f664a63a74p-6, 0x1.95f0d49f88599p-8, -0x1.28951c2b89bf6p-9,
     0x1.dc07834dc1072p-11, -0x1.92f63c954f2f2p-12, 0x1.61139fa57a96bp-13, -0x1.3ced77c790669p-14,
     0x1.219bd7018a4e8p-15, -0x1.0ce4d1fd61807p-16, 0x1.f7bce7faf06b3p-18},
     /* [367] 1.875 <= y <= 2 2^5, degree 10, 61.7 bits */
    {0x1.7041f98364d52p-3, 0x1.3715e94512d22p-57, -0x1.34756f7cb2276p-5, 0x1.4d99ec76ae897p-6, -0x1.bd0145cac8053p-7,
     0x1.45e6e0155452p-7, -0x1.f7696c93bd316p-8, 0x1.92647e22fafacp-8, -0x1.4978b6da88a78p-8, 0x1.129da68e2506dp-8,
     -0x1.d378a774016f4p-9, 0x1.8f6551f346e04p-9}, /* [368] 1 <= y <= 1.125 2^6, degree 10, 58.4 bits */
    {0x1.67385c3e03505p-3, -0x1.982506a741439p-57, -0x1.0f67d13dd0878p-5, 0x1.074db1296ad48p-6, -0x1.3abaa79d06cecp-7,
     0x1.9ce555a6e1f51p-8, -0x1.1d8edb64a6b69p-8, 0x1.98b9f1b15dc4cp-9, -0x1.2b99472e34d28p-9, 0x1.bf13811945f42p-10,
     -0x1.541f2f3630379p-10, 0x1.0418461e4fbbep-10}, /* [369] 1.125 <= y <= 1.25 2^6, degree 10, 59.8 bits */
    {0x1.5f37acc7a163cp-3, -0x1.168fcb5bdfbd2p-58, -0x1.e3a248bfb05d8p-6, 0x1.a97b1cd310f29p-7, -0x1.ccc238a7901d4p-8,
     0x1.11b599ba5ed29p-8, -0x1.56c93923957ccp-9, 0x1.bc2c580b960cep-10, -0x1.26b8bfd4ef261p-10, 0x1.8e159617e8948p-11,
     -0x1.11d306fe8870ep-11, 0x1.7b0790cc2a2efp-12}, /* [370] 1.25 <= y <= 1.375 2^6, degree 10, 61.0 bits */
    {0x1.580cce54912f4p-3, -0x1.a6db8fead3338p-58, -0x1.b35c852365de5p-6, 0x1.5e6d58a5f122bp-7, -0x1.5ae699fea411fp-8,
     0x1.78a0a31820665p-9, -0x1.aef201e62520dp-10, 0x1.fe1fa01cd7677p-11, -0x1.35304f8abe59p-11, 0x1.7d7576f66b456p-12,
     -0x1.deeea268e12aep-13, 0x1.2ebc740c1bbddp-13}, /* [371] 1.375 <= y <= 1.5 2^6, degree 10, 60.5 bits */
    {0x1.5191e3deb5245p-3, -0x1.6e99c48bd81fcp-59, -0x1.8b4920ac14b6ap-6, 0x1.25438c625c8f8p-7, -0x1.0b61741558c53p-8,
     0x1.0b46d98f3e74ap-9, -0x1.1986d4d3b16acp-10, 0x1.32bde189ce4c4p-11, -0x1.563b04fe5996fp-12, 0x1.8495ad9b79079p-13,
     -0x1.c0b7d5c67d3b7p-14, 0x1.05047131a0b11p-14}, /* [372] 1.5 <= y <= 1.625 2^6, degree 10, 61.2 bits */
    {0x1.4baa216c9950ap-3, -0x1.32ae2e2d334bep-58, -0x1.6985170879522p-6, 0x1.f18ab4963db96p-8, -0x1.a473273d0ea79p-9,
     0x1.856e663848658p-10, -0x1.7c04bd6f4bb5ap-11, 0x1.7f8e81f8a0534p-12, -0x1.8c628345fb6a6p-13,
     0x1.a0df435f01fa2p-14, -0x1.bda45f235a825p-15, 0x1.e02c235c4482fp-16},
     /* [373] 1.625 <= y <= 1.75 2^6, degree 10, 60.7 bits */
    {0x1.463f236388eb1p-3, -0x1.23c63f9b1b60ep-59, -0x1.4cb5ddd8b17fbp-6, 0x1.aafccbc001a6fp-8, -0x1.50414e6159b04p-9,
     0x1.2228e0ff8db3bp-10, -0x1.07c0e2a609abep-11, 0x1.efe7f17861de2p-13, -0x1.dd50c5e66aa7cp-14,
     0x1.d3821e6dbe367p-15, -0x1.d140deea85abcp-16, 0x1.d2d6f555b2865p-17},
     /* [374] 1.75 <= y <= 1.875 2^6, degree 10, 61.9 bits */
    {0x1.413f2d55d86ecp-3, -0x1.b193dfff75d18p-57, -0x1.33dc95e74922p-6, 0x1.72260f817ff58p-8, -0x1.10ec62c8af976p-9,
     0x1.b8e69472a3282p-11, -0x1.7718ece7a7f13p-12, 0x1.4a011ad5c1d5ep-13, -0x1.293cee1515597p-14,
     0x1.106cded0cec39p-15, -0x1.fb35d2ec0db24p-17, 0x1.dc356cebf7281p-18},
     /* [375] 1.875 <= y <= 2 2^6, degree 10, 60.8 bits */
    {0x1.3a696b84682cap-3, 0x1.040ae631cd098p-57, -0x1.146d916acb888p-5, 0x1.2fa3cd0727892p-6, -0x1.98be8449a6416p-7,
     0x1.2d47b0e54538fp-7, -0x1.d3b3f98921486p-8, 0x1.775eea9e6a5f3p-8, -0x1.3466e2afdc10dp-8, 0x1.01d148a81ea0bp-8,
     -0x1.b809bde524146p-9, 0x1.78d5c4964ffebp-9}, /* [376] 1 <= y <= 1.125 2^7, degree 10, 58.4 bits */
    {0x1.32521da0d16d7p-3, 0x1.5f756f48cb895p-60, -0x1.e579fb770a686p-6, 0x1.de4761110d709p-7, -0x1.2070910a0322p-7,
     0x1.7cd5bbece8f41p-8, -0x1.08b145fb7aabap-8, 0x1.7c65260933b7fp-9, -0x1.17c8faedef192p-9, 0x1.a2be8f2deb90dp-10,
     -0x1.3f6810b54a83dp-10, 0x1.e9a4f3f3b07afp-11}, /* [377] 1.125 <= y <= 1.25 2^7, degree 10, 59.6 bits */
    {0x1.2b2b7342e3c7fp-3, -0x1.c9409550311f2p-59, -0x1.afc7f26980409p-6, 0x1.81b068c3c7bc3p-7, -0x1.a56deede697d5p-8,
     0x1.f7e2a7aead94dp-9, -0x1.3d159024018f2p-9, 0x1.9c8686a177631p-10, -0x1.12a78bbceb5d1p-10, 0x1.74129fe3c64bfp-11,
     -0x1.009a3ea1b6432p-11, 0x1.6403fafae9242p-12}, /* [378] 1.25 <= y <= 1.375 2^7, degree 10, 60.9 bits */
    {0x1.24c69eaa201f2p-3, -0x1.c6d5b58519e62p-57, -0x1.840f7f4a31cabp-6, 0x1.3d1a095b08aacp-7, -0x1.3cb7d308ddde7p-8,
     0x1.5a09c97662dabp-9, -0x1.8de3cd200a6eep-10, 0x1.d8e2729ec4007p-11, -0x1.1f97090dfe711p-11, 0x1.63da8bd233d16p-12,
     -0x1.bff2ff1d665cdp-13, 0x1.1bce9f487aa98p-13}, /* [379] 1.375 <= y <= 1.5 2^7, degree 10, 61.0 bits */
    {0x1.1f010508c6032p-3, -0x1.d6092fedba29p-57, -0x1.5fd305b6e693dp-6, 0x1.08f4272e5fb6ap-7, -0x1.e76e360052989p-9,
     0x1.ea500f76336f4p-10, -0x1.037d53fb6cc5ap-10, 0x1.1bdc460b3dba8p-11, -0x1.3dc59e32a9193p-12,
     0x1.69de8bcc69b3ep-13, -0x1.a2f423bd74315p-14, 0x1.e8884596de056p-15},
     /* [380] 1.5 <= y <= 1.625 2^7, degree 10, 60.1 bits */
    {0x1.19c0609daafbcp-3, -0x1.2e4a2396735cep-57, -0x1.41570b29444dep-6, 0x1.c0db7207fc582p-8, -0x1.7ea84d269d447p-9,
     0x1.64a64a7cbd00ep-10, -0x1.5db91b6e4e30ep-11, 0x1.62623871eb5c9p-12, -0x1.6f7808e945302p-13,
     0x1.8396ccfea993bp-14, -0x1.9f68f0d4ae324p-15, 0x1.c0a0dbaadf6a8p-16},
     /* [381] 1.625 <= y <= 1.75 2^7, degree 10, 60.6 bits */
    {0x1.14f04c919e76ep-3, -0x1.92adaa48b8905p-59, -0x1.275de83b8dffbp-6, 0x1.80b03e1b13d9fp-8, -0x1.319a67a39e711p-9,
     0x1.095ae4c99a346p-10, -0x1.e4c0006817434p-12, 0x1.c98445a5b8d77p-13, -0x1.b9d7a55d0750ep-14,
     0x1.b205bc405cfcfp-15, -0x1.b10ad9ac231e1p-16, 0x1.b38446ac18eb8p-17},
     /* [382] 1.75 <= y <= 1.875 2^7, degree 10, 60.0 bits */
    {0x1.1080a72538e95p-3, 0x1.eca91d8b5e69ap-57, -0x1.10fe5676d874ap-6, 0x1.4d104b6d2bbaap-8, -0x1.ef71f306cf5edp-10,
     0x1.92aca92c35008p-11, -0x1.583ab4c9e9668p-12, 0x1.300afcc6bc03cp-13, -0x1.12c50e3fdd72fp-14,
     0x1.f920118593055p-16, -0x1.d76ff3cd53c87p-17, 0x1.bba2d82f0a676p-18},
     /* [383] 1.875 <= y <= 2 2^7, degree 10, 60.3 bits */
    {0x1.0a724b8d4744ep-3, -0x1.be35367cd28acp-62, -0x1.e97759396b4f8p-6, 0x1.10bf910f0e01fp-6, -0x1.7256afb7f9f63p-7,
     0x1.12a7c57a8c1abp-7, -0x1.ac6a909598d8fp-8, 0x1.5930b0958b07ap-8, -0x1.1c8c90a89fa4cp-8, 0x1.dd208818d99a1p-9,
     -0x1.9839f9e29b3d8p-9, 0x1.5e63c287847dep-9}, /* [384] 1 <= y <= 1.125 2^8, degree 10, 58.6 bits */
    {0x1.034a358e8346fp-3, 0x1.fe738df23320ep-58, -0x1.ad00b13c06bf7p-6, 0x1.acbca6047f57fp-7, -0x1.04c76c186a1f4p-7,
     0x1.5a6b603ec8d07p-8, -0x1.e3d672f731748p-9, 0x1.5d05d6b9cb01ep-9, -0x1.018f1acd7de03p-9, 0x1.8295e48bff07ep-10,
     -0x1.27a1b8acaf083p-10, 0x1.c63a00cc17a1dp-11}, /* [385] 1.125 <= y <= 1.25 2^8, degree 10, 59.8 bits */
    {0x1.f9f3b61c8c1f5p-4, -0x1.90af50d259133p-58, -0x1.7ce9a10e22181p-6, 0x1.591a844550a48p-7, -0x1.7c4984fdbae89p-8,
     0x1.c973d6ccefebfp-9, -0x1.2139d4e0272a6p-9, 0x1.79bd8bf6167ddp-10, -0x1.f8a4a4b65e496p-11, 0x1.56cb49202f55fp-11,
     -0x1.da05ecb08298dp-12, 0x1.4993de1768345p-12}, /* [386] 1.25 <= y <= 1.375 2^8, degree 10, 59.9 bits */
    {0x1.eeade80d0e6a3p-4, 0x1.7be0e0837c3d9p-58, -0x1.55d31a3adbd68p-6, 0x1.1b43889c0a471p-7, -0x1.1d4e1ecbd0389p-8,
     0x1.399858ac25201p-9, -0x1.6a4765afebdb8p-10, 0x1.b0387a46e0a1cp-11, -0x1.07b80dd45fdd9p-11, 0x1.473e3f280da54p-12,
     -0x1.9cf9be0e6396ep-13, 0x1.063cc9ff7586fp-13}, /* [387] 1.375 <= y <= 1.5 2^8, degree 10, 61.3 bits */
    {0x1.e48498d1507ebp-4, -0x1.b0086c7b1525fp-60, -0x1.357aabfccc4adp-6, 0x1.d8a5d0aec3fb4p-8, -0x1.b665502bfbee8p-9,
     0x1.bba063bc87d85p-10, -0x1.d7c15971bb54bp-11, 0x1.0305023f47003p-11, -0x1.22e805a84d039p-12,
     0x1.4c3632fb9c16cp-13, -0x1.8195a36d16a1bp-14, 0x1.c2a0e8c8f95b8p-15},
     /* [388] 1.5 <= y <= 1.625 2^8, degree 10, 60.6 bits */
    {0x1.db487b526ecfcp-4, -0x1.f43e0b4b29fccp-58, -0x1.1a4eb479e6f0bp-6, 0x1.8fcd5c94fbf2cp-8, -0x1.57aa9289dade5p-9,
     0x1.423673112626dp-10, -0x1.3d6bdb0901e3fp-11, 0x1.42e096bd5d0a9p-12, -0x1.4fe1ec073ad4p-13, 0x1.63450fa1755e1p-14,
     -0x1.7db91d0a5e8ecp-15, 0x1.9d2ae5e746658p-16}, /* [389] 1.625 <= y <= 1.75 2^8, degree 10, 60.2 bits */
    {0x1.d2d4e63f33e44p-4, 0x1.b9e230e11a9ebp-58, -0x1.032ff9068a666p-6, 0x1.56359a7aaa2d7p-8, -0x1.121915ec75d49p-9,
     0x1.decf92c1c1398p-11, -0x1.b75d21f658f7dp-12, 0x1.a040b16ee623ap-13, -0x1.934966a4c0944p-14,
     0x1.8d42326de20bfp-15, -0x1.8d592097d2ad8p-16, 0x1.9081b9bad097bp-17},
     /* [390] 1.75 <= y <= 1.875 2^8, degree 10, 62.0 bits */
    {0x1.cb0ce4158edfap-4, -0x1.9350d634986dbp-58, -0x1.de97b1909440cp-7, 0x1.27ef455530b0bp-8, -0x1.bbd1c59110e33p-10,
     0x1.6ad5aa3caa08fp-11, -0x1.379895b775c9dp-12, 0x1.14420701d4173p-13, -0x1.f4ebafecb7ebdp-15,
     0x1.cdb84b3f5161dp-16, -0x1.affe9a5dd82f1p-17, 0x1.976b6681efbacp-18},
     /* [391] 1.875 <= y <= 2 2^8, degree 10, 61.2 bits */
    {0x1.c070ed449f801p-4, 0x1.ed93e0147fd4ep-60, -0x1.ac69a8322c12p-6, 0x1.e3e5be3d8a9f3p-7, -0x1.4b2f45ef6282dp-7,
     0x1.ee18f23e5004dp-8, -0x1.831c5b1b33f3fp-8, 0x1.3913efbcdc58p-8, -0x1.02e673b97865ep-8, 0x1.b352a940e149cp-9,
     -0x1.756285bcbba49p-9, 0x1.41309296c3ad6p-9}, /* [392] 1 <= y <= 1.125 2^9, degree 10, 58.5 bits */
    {0x1.b3eca2125cb14p-4, 0x1.8e8c5f8d77052p-58, -0x1.76d3f7af70e76p-6, 0x1.7b958ac644526p-7, -0x1.d17805c43db1dp-8,
     0x1.36f2d1741d661p-8, -0x1.b441de45b4011p-9, 0x1.3bde997ce002dp-9, -0x1.d3a92ee6bb679p-10, 0x1.5fef81d08ed4cp-10,
     -0x1.0dcbed703583ap-10, 0x1.9f7036323bcedp-11}, /* [393] 1.125 <= y <= 1.25 2^9, degree 10, 59.8 bits */
    {0x1.a8e65f4b1707ep-4, -0x1.3a25ab0d0aaf8p-58, -0x1.4c4993f333a73p-6, 0x1.31029c6282c74p-7, -0x1.52c681cb13cf1p-8,
     0x1.99d8c58a71c45p-9, -0x1.04498e05550b6p-9, 0x1.5532e9b5da238p-10, -0x1.c941616cab889p-11, 0x1.377403fb8384bp-11,
     -0x1.afbc51fb39526p-12, 0x1.2cd4114d0424dp-12}, /* [394] 1.25 <= y <= 1.375 2^9, degree 10, 60.0 bits */
    {0x1.9f12bba8467f3p-4, -0x1.95308c6072d9bp-61, -0x1.29c45f7e0c1d4p-6, 0x1.f3edc6137aa8cp-8, -0x1.fb7e0aa44805bp-9,
     0x1.187cc86ae108bp-9, -0x1.457893c00b3d6p-10, 0x1.85ba514ae2f6ap-11, -0x1.dd10d5d90ef94p-12, 0x1.28cb330f29163p-12,
     -0x1.7774d21174221p-13, 0x1.dddb2804dda55p-14}, /* [395] 1.375 <= y <= 1.5 2^9, degree 10, 61.0 bits */
    {0x1.963a28ed57c54p-4, -0x1.604204871c4bp-59, -0x1.0d3e762a8b982p-6, 0x1.a07e642cd83e4p-8, -0x1.8552b06d93bfap-9,
     0x1.8c2ee29d805dap-10, -0x1.a729611549d7cp-11, 0x1.d25df80e33accp-12, -0x1.06b34e734fd8p-12, 0x1.2ccf6ae940db1p-13,
     -0x1.5dfa6797053a1p-14, 0x1.99e503f1708cep-15}, /* [396] 1.5 <= y <= 1.625 2^9, degree 10, 60.9 bits */
    {0x1.8e329c664e2cap-4, 0x1.6b274c74f9a3bp-59, -0x1.eaa1ae5b75f97p-7, 0x1.5fd860a515628p-8, -0x1.30c80ab24f7e9p-9,
     0x1.1f59888a28e13p-10, -0x1.1c510880607dfp-11, 0x1.223f7a0165bc2p-12, -0x1.2ede29eb5a6b2p-13,
     0x1.41356dab69536p-14, -0x1.59f3728894124p-15, 0x1.773fc28285801p-16},
     /* [397] 1.625 <= y <= 1.75 2^9, degree 10, 62.8 bits */
    {0x1.86db8c4e1c779p-4, 0x1.be3d01eafa017p-58, -0x1.c1f64c74e5444p-7, 0x1.2cccd9bc487f5p-8, -0x1.e58eddc5bf47ap-10,
     0x1.aa7369a16fff4p-11, -0x1.890527d858842p-12, 0x1.75aeebea604eap-13, -0x1.6b2696c1ea043p-14,
     0x1.66ad3e401c544p-15, -0x1.679c387f5e69ap-16, 0x1.6b3d5e97eb8a1p-17},
     /* [398] 1.75 <= y <= 1.875 2^9, degree 10, 61.8 bits */
    {0x1.801b4d9d69107p-4, -0x1.2978d7ee0b58cp-63, -0x1.9f034e3c28bfp-7, 0x1.03d614082168ep-8, -0x1.88a6472468ee7p-10,
     0x1.42c4c0dd0b12p-11, -0x1.1662f9345c6fep-12, 0x1.ef6420f5a5eecp-14, -0x1.c27f24433d377p-15, 0x1.a05801d02592cp-16,
     -0x1.8675db9c5955cp-17, 0x1.71070fc21aee4p-18}, /* [399] 1.875 <= y <= 2 2^9, degree 10, 61.2 bits */
    {0x1.76e9c4d26861p-4, 0x1.a24ac24215be9p-59, -0x1.72fcb33bb1f42p-6, 0x1.a83928d88d9e7p-7, -0x1.24880af6cbf15p-7,
     0x1.b6cf561586599p-8, -0x1.5944b16eb25dbp-8, 0x1.1839d6bc8f466p-8, -0x1.d0dd8886c5a18p-9, 0x1.87d9542420cc8p-9,
     -0x1.50e45f80ce27ep-9, 0x1.22683352e0c23p-9}, /* [400] 1 <= y <= 1.125 2^10, degree 10, 58.0 bits */
    {0x1.6c1542eac7f86p-4, -0x1.b3fb2e145653p-58, -0x1.440d6229c6686p-6, 0x1.4c2b55d8ecc47p-7, -0x1.9a5b826111d84p-8,
     0x1.139c1f3abc12fp-8, -0x1.84514268cc2ddp-9, 0x1.1a24e25d1eb8dp-9, -0x1.a2fa391deb0bfp-10, 0x1.3c1f3a9c12a06p-10,
     -0x1.e5d1599cbfb78p-11, 0x1.76d0ba69669dfp-11}, /* [401] 1.125 <= y <= 1.25 2^10, degree 10, 59.4 bits */
    {0x1.628f1803caff1p-4, -0x1.4377527b93f73p-59, -0x1.1edae93921f52p-6, 0x1.0a7a9896a62ebp-7, -0x1.2a27fb52c5116p-8,
     0x1.6aa13be01acb1p-9, -0x1.ce890d544e816p-10, 0x1.3035f199f020dp-10, -0x1.98e4dd1ff2e2bp-11, 0x1.173bb3891580fp-11,
     -0x1.83f82d5634d66p-12, 0x1.0ee438f051cb2p-12}, /* [402] 1.25 <= y <= 1.375 2^10, degree 10, 60.7 bits */
    {0x1.5a14d4bb71ddbp-4, 0x1.2bfe06208da72p-60, -0x1.00b79eadb0434p-6, 0x1.b4235c3652663p-8, -0x1.bdf597e1333adp-9,
     0x1.ef8f8be807896p-10, -0x1.20b70431ffcd7p-10, 0x1.5ae7a41844402p-11, -0x1.a9e4e8f633b99p-12,
     0x1.09a3932e4eeb3p-12, -0x1.50d0ec15da423p-13, 0x1.ad8ea46277783p-14},
     /* [403] 1.375 <= y <= 1.5 2^10, degree 10, 61.7 bits */
    {0x1.52759c45f822bp-4, 0x1.b63fa43f7940cp-58, -0x1.cfb32714498c7p-7, 0x1.6ade7ae7875f1p-8, -0x1.55a437148b6c6p-9,
     0x1.5d7b2447e243cp-10, -0x1.76d1c5595df25p-11, 0x1.9e7fd15ecced6p-12, -0x1.d4545215d0f35p-13,
     0x1.0cd17429188a5p-13, -0x1.39782f3aae83ap-14, 0x1.6fe251449146fp-15},
     /* [404] 1.5 <= y <= 1.625 2^10, degree 10, 63.0 bits */
    {0x1.4b8c829bd27a6p-4, 0x1.e379559c1c61ep-58, -0x1.a607a8123fa56p-7, 0x1.322c68e644bffp-8, -0x1.0b1ce7532355fp-9,
     0x1.fa48fea988a9ep-11, -0x1.f6fdc9bc27af3p-12, 0x1.019cbf152384dp-12, -0x1.0d976c9d83776p-13,
     0x1.1ea4104da1063p-14, -0x1.356b21925efcdp-15, 0x1.504d71a6f2704p-16},
     /* [405] 1.625 <= y <= 1.75 2^10, degree 10, 60.3 bits */
    {0x1.453cfe39bdf9p-4, -0x1.87471d5f5be11p-58, -0x1.82a8b84534df8p-7, 0x1.05767c66033ffp-8, -0x1.a90c0a7a01d4ap-10,
     0x1.773a4dd31b471p-11, -0x1.5b37ae54729eap-12, 0x1.4b3eabad80ba5p-13, -0x1.42d58aeb63e0fp-14, 0x1.3fa897720e9ap-15,
     -0x1.4135cbc2b9aa3p-16, 0x1.451af39350e3ap-17}, /* [406] 1.75 <= y <= 1.875 2^10, degree 10, 61.9 bits */
    {0x1.3f7093378fd47p-4, 0x1.6ed1ef6df10a3p-58, -0x1.644bbd8d29a02p-7, 0x1.c33ef32922cfcp-9, -0x1.5757ba4d4b759p-10,
     0x1.1badde96e509dp-11, -0x1.eb5180472a87ep-13, 0x1.b69cfb1c3c263p-14, -0x1.9000fc94dcd46p-15,
     0x1.729a48cd27f0ap-16, -0x1.5c5697a6bd2fbp-17, 0x1.49e0679c964c7p-18},
     /* [407] 1.875 <= y <= 2 2^10, degree 10, 64.0 bits */
    {0x1.378d4efb3f57ep-4, 0x1.a356c5bb476a7p-59, -0x1.3e17faafefe9ep-6, 0x1.6fd7d5a0aec3p-7, -0x1.fed4336dbe582p-8,
     0x1.8111ecd84456cp-8, -0x1.3031c3904b5c7p-8, 0x1.ef69e5b3c709cp-9, -0x1.9c15423c02dcfp-9, 0x1.5c37b1d51e61ap-9,
     -0x1.2c0c5095ffeccp-9, 0x1.0328f5f2f6401p-9}, /* [408] 1 <= y <= 1.125 2^11, degree 10, 57.9 bits */
    {0x1.2e45e2fc4c22ep-4, -0x1.dc4a4e28ce70fp-58, -0x1.156e20d296f76p-6, 0x1.1f89b42567eeep-7, -0x1.65a712e6cb237p-8,
     0x1.e2d22d26fce96p-9, -0x1.557987523fb9fp-9, 0x1.f1d77b2bab8fap-10, -0x1.72ad3db7b2666p-10, 0x1.185d331dd4123p-10,
     -0x1.afd06205c7dd3p-11, 0x1.4dce1abb7f6c2p-11}, /* [409] 1.125 <= y <= 1.25 2^11, degree 10, 59.5 bits */
    {0x1.261fe77032535p-4, -0x1.e6671a6e79611p-58, -0x1.ea8261df40ab1p-7, 0x1.cca81aa4abe0bp-8, -0x1.03735643688fep-8,
     0x1.3d1c6b16249a7p-9, -0x1.960de574a91f9p-10, 0x1.0bed72b3a15b5p-10, -0x1.691f93a779159p-11, 0x1.ee6b0be69dbe4p-12,
     -0x1.58390d651642ap-12, 0x1.e1a0dd91b4cb3p-13}, /* [410] 1.25 <= y <= 1.375 2^11, degree 10, 61.6 bits */
    {0x1.1ee17f2995396p-4, 0x1.a8db318f73f0fp-58, -0x1.b671f2fbfe82bp-7, 0x1.7876c4487ee66p-8, -0x1.83837c7e7b7a2p-9,
     0x1.b0b7348712071p-10, -0x1.fa26540901c9fp-11, 0x1.310e6fa027a87p-11, -0x1.778b8f4b8cb55p-12,
     0x1.d598cad198bacp-13, -0x1.2a5a8d7556487p-13, 0x1.7d3d1a8e39cf9p-14},
     /* [411] 1.375 <= y <= 1.5 2^11, degree 10, 60.2 bits */
    {0x1.18602bd39da7ep-4, 0x1.af1f55b48571cp-58, -0x1.8b8a87ea89b5dp-7, 0x1.38d653530814ep-8, -0x1.287bc1a04b998p-9,
     0x1.30c07766b3349p-10, -0x1.4818f9221d7a1p-11, 0x1.6bfbd8cdbe903p-12, -0x1.9c5f69bbae905p-13, 0x1.da86ff6d6099p-14,
     -0x1.1543bb4e32b11p-14, 0x1.460475a40bed7p-15}, /* [412] 1.5 <= y <= 1.625 2^11, degree 10, 62.8 bits */
    {0x1.127bdcbe77c4ap-4, -0x1.38830bdedb59ap-59, -0x1.67a2eb10ed6dep-7, 0x1.07a9f82db9fd1p-8, -0x1.cf105604d69e2p-10,
     0x1.b8f1efb930e95p-11, -0x1.b7bcc0cf86b81p-12, 0x1.c3d9c9b50b7f7p-13, -0x1.da2373c70cbb8p-14,
     0x1.f950e1ffb5913p-15, -0x1.11500a9c3b26fp-15, 0x1.299fc67c3ed18p-16},
     /* [413] 1.625 <= y <= 1.75 2^11, degree 10, 60.9 bits */
    {0x1.0d1bd1535a087p-4, -0x1.3af1d921976bbp-61, -0x1.493122f3639aap-7, 0x1.c1dbf42f0aa64p-9, -0x1.7006f69eb74eap-10,
     0x1.466ea763147a2p-11, -0x1.2f33419319648p-12, 0x1.2227f554550aap-13, -0x1.1b8bcbf017644p-14,
     0x1.196a7c376b322p-15, -0x1.1b603c94bec77p-16, 0x1.1f5a7c5337d16p-17},
     /* [414] 1.75 <= y <= 1.875 2^11, degree 10, 61.8 bits */
    {0x1.082c8ec9c287ap-4, 0x1.1da1f05961e1dp-61, -0x1.2f156384cdfd4p-7, 0x1.83d3667eb9abbp-9, -0x1.28fbdb97a692ep-10,
     0x1.ed0f9de19b9aap-12, -0x1.ac92483968155p-13, 0x1.7fc8993ea7ffbp-14, -0x1.5eee63221e5b4p-15,
     0x1.45e50e289fbf7p-16, -0x1.32f4731bf5443p-17, 0x1.233b3923d9ec2p-18},
     /* [415] 1.875 <= y <= 2 2^11, degree 10, 60.3 bits */
    {0x1.0177dd8c95902p-4, -0x1.52c378627949fp-59, -0x1.0e458251f6f0dp-6, 0x1.3bbb8521b26cap-7, -0x1.b93ea75ac8d53p-8,
     0x1.4e29c138e20b5p-8, -0x1.08f40783c5646p-8, 0x1.b0d4368a3731fp-9, -0x1.68f902c586ca2p-9, 0x1.31bb758d5d50bp-9,
     -0x1.07fd1b0463ab2p-9, 0x1.c8e002c493ec5p-10}, /* [416] 1 <= y <= 1.125 2^12, degree 10, 58.1 bits */
    {0x1.f32deac54eabep-5, 0x1.5bcc29da61075p-62, -0x1.d6ca520b1f819p-7, 0x1.ecd7a4a66c758p-8, -0x1.346d01a47e39fp-8,
     0x1.a246631f4f99cp-9, -0x1.28e6bab651b1fp-9, 0x1.b22b0b9f2f3f9p-10, -0x1.441b836b4afe4p-10, 0x1.eb66557561efcp-11,
     -0x1.7b339e4e4fa73p-11, 0x1.25abff3be26ebp-11}, /* [417] 1.125 <= y <= 1.25 2^12, degree 10, 59.8 bits */
    {0x1.e55c3d7b0b26bp-5, 0x1.477fb20cc1575p-60, -0x1.9fadaf0cadff3p-7, 0x1.8a3dc57a4f90dp-8, -0x1.bed3914f426d3p-9,
     0x1.124cecf608714p-9, -0x1.607fbd5bf2dadp-10, 0x1.d29275f4301edp-11, -0x1.3b3d6b993a451p-11, 0x1.b0924f33c83e6p-12,
     -0x1.2dc6542303a8fp-12, 0x1.a7009b1491c13p-13}, /* [418] 1.25 <= y <= 1.375 2^12, degree 10, 60.1 bits */
    {0x1.d916f63c1057bp-5, -0x1.8b2ed63b74fdcp-68, -0x1.7325d110feb71p-7, 0x1.41c9f6075395p-8, -0x1.4d4021bc1b8cdp-9,
     0x1.75c97fc86eb7dp-10, -0x1.b6c65845277c3p-11, 0x1.093b75990f908p-11, -0x1.4759506bb45b8p-12,
     0x1.9a3e566ae543fp-13, -0x1.052aa6008284dp-13, 0x1.4e52104fb2d98p-14},
     /* [419] 1.375 <= y <= 1.5 2^12, degree 10, 60.0 bits */
    {0x1.ce14f0d24d4a4p-5, -0x1.9adb1549fede9p-62, -0x1.4e7ebbb6b8bfcp-7, 0x1.0b1a77d592c7fp-8, -0x1.fd53d36559a87p-10,
     0x1.06ec753232c9ep-10, -0x1.1c0f8b96099bap-11, 0x1.3c0dbd8f3eb4ep-12, -0x1.66f8ccc506dd9p-13,
     0x1.9dfd90cced1f7p-14, -0x1.e4bef223064a2p-15, 0x1.1d7f8dfc0877p-15},
     /* [420] 1.5 <= y <= 1.625 2^12, degree 10, 60.5 bits */
    {0x1.c41f0e0a82f98p-5, -0x1.8d6770f529b02p-62, -0x1.2fdace35e8bedp-7, 0x1.c1c6e82f42371p-9, -0x1.8d50a250d44edp-10,
     0x1.7bfe3f348e53ep-11, -0x1.7c45aece4b49cp-12, 0x1.87e1b20750214p-13, -0x1.9c3ca385e18f7p-14,
     0x1.b84e5d4e50525p-15, -0x1.dd3c9ab701696p-16, 0x1.044d7be9fa945p-16},
     /* [421] 1.625 <= y <= 1.75 2^12, degree 10, 61.6 bits */
    {0x1.bb0acd7abde94p-5, 0x1.735d5d08d5af1p-62, -0x1.15e64b4ef2f5ap-7, 0x1.7f571925abf62p-9, -0x1.3b74d6b8e6222p-10,
     0x1.19042f2172bc5p-11, -0x1.05ead5327a2d4p-12, 0x1.f6bd94c7ef6f4p-14, -0x1.ec809b00150cdp-15,
     0x1.e9dd2f8b8cb9ap-16, -0x1.ee3c7dc74a291p-17, 0x1.f60d38c810162p-18},
     /* [422] 1.75 <= y <= 1.875 2^12, degree 10, 60.5 bits */
    {0x1.b2b6c577cd9ap-5, -0x1.6f05f24bfc0f1p-59, -0x1.ff52968d94baap-8, 0x1.4a31275a26a89p-9, -0x1.fca6b8ed87c12p-11,
     0x1.a80d98435414dp-12, -0x1.71d9b36d9da96p-13, 0x1.4c24de9c45f94p-14, -0x1.3074f61ec5e7ap-15,
     0x1.1b585fdfff8eap-16, -0x1.0b64c13b49064p-17, 0x1.fc4680d957cb2p-19},
     /* [423] 1.875 <= y <= 2 2^12, degree 10, 63.3 bits */
    {0x1.a768204c475a3p-5, 0x1.74aa9852d3315p-59, -0x1.c77bc73e45c7bp-7, 0x1.0c7df1d8bec86p-7, -0x1.7962ca0860deep-8,
     0x1.1f03aae5bf5f8p-8, -0x1.c8ad7c232e795p-9, 0x1.7611345de2b53p-9, -0x1.38b9015e2492dp-9, 0x1.096e2fce8fb04p-9,
     -0x1.cb4337343b34cp-10, 0x1.8e18e8095cd06p-10}, /* [424] 1 <= y <= 1.125 2^13, degree 10, 58.1 bits */
    {0x1.9a23341416edp-5, 0x1.98650104c91e2p-59, -0x1.8c355d37cc576p-7, 0x1.a2825f233d159p-8, -0x1.07643f373a7e9p-8,
     0x1.66b1a5f39f34fp-9, -0x1.feea22865dceap-10, 0x1.769a0388243f3p-10, -0x1.184f415793ca4p-10, 0x1.a9e36d1e178d8p-11,
     -0x1.494586f4854c9p-11, 0x1.fedf7e2637c7bp-12}, /* [425] 1.125 <= y <= 1.25 2^13, degree 10, 59.4 bits */
    {0x1.8e839d862ce35p-5, -0x1.570f03880b559p-62, -0x1.5d700c8a3033fp-7, 0x1.4e5c0ef6f23d5p-8, -0x1.7d12db5900d19p-9,
     0x1.d5ccac8f99c65p-10, -0x1.2edb939657dbep-10, 0x1.91f7538f33dd1p-11, -0x1.103ae4e3b7b9ep-11,
     0x1.76543c9b32d5ap-12, -0x1.05a1b23a58954p-12, 0x1.6f5930a3f5771p-13},
     /* [426] 1.25 <= y <= 1.375 2^13, degree 10, 59.5 bits */
    {0x1.84343bfdb9d9fp-5, -0x1.c3c0c2c474a55p-65, -0x1.37b112490c76p-7, 0x1.109ad8736c8fbp-8, -0x1.1bdeb45e59237p-9,
     0x1.3fb1f6f6b1576p-10, -0x1.787f110f612fcp-11, 0x1.c867e66c59885p-12, -0x1.1a4dfee6be1b9p-12,
     0x1.6284da9d105eep-13, -0x1.c4379714a5189p-14, 0x1.21ec471b8791bp-14},
     /* [427] 1.375 <= y <= 1.5 2^13, degree 10, 59.6 bits */
    {0x1.7af6b6cae2af8p-5, -0x1.ef9c3daf256d9p-59, -0x1.18a8245933162p-7, 0x1.c41824c9928p-9, -0x1.b16268a790bbcp-10,
     0x1.c13d6986d1b61p-11, -0x1.e6e9aedaff0fcp-12, 0x1.0f9a3a008648ap-12, -0x1.3532557b808c5p-13,
     0x1.654f8252712f3p-14, -0x1.a3249a092876bp-15, 0x1.ee8832c6b0506p-16},
     /* [428] 1.5 <= y <= 1.625 2^13, degree 10, 59.9 bits */
    {0x1.729c1f5a268b1p-5, 0x1.7ff45936ed5bp-59, -0x1.fd79e27421db1p-8, 0x1.7c49bf748246p-9, -0x1.51bcec20966ep-10,
     0x1.444c408e7b984p-11, -0x1.4590ff6631831p-12, 0x1.50655dc027357p-13, -0x1.62ad8cb0d0a92p-14,
     0x1.7b9701dd07f31p-15, -0x1.9c2becd5b4798p-16, 0x1.c25bf2c42e8f7p-17},
     /* [429] 1.625 <= y <= 1.75 2^13, degree 10, 60.8 bits */
    {0x1.6b004f98364b3p-5, -0x1.479fa87363045p-60, -0x1.d19ab4eb2c44ap-8, 0x1.43d6acaf2c646p-9, -0x1.0be8cf4853541p-10,
     0x1.df32f0acee2d3p-12, -0x1.c008dde1715adp-13, 0x1.af1f78099a838p-14, -0x1.a74ca72c2ff18p-15, 0x1.a5deebc3d761p-16,
     -0x1.aa65e8abd9291p-17, 0x1.b1d6e36f87bfep-18}, /* [430] 1.75 <= y <= 1.875 2^13, degree 10, 61.9 bits */
    {0x1.6406e3658b8f2p-5, -0x1.823d9dd418b61p-62, -0x1.ac0bc80c5f239p-8, 0x1.16b83cd6dc082p-9, -0x1.af9eee98371c1p-11,
     0x1.693c933f86c5cp-12, -0x1.3c0b5913e15f1p-13, 0x1.1c90089871575p-14, -0x1.056d5aa4aff43p-15,
     0x1.e78f4e856b0d6p-17, -0x1.cced724501181p-18, 0x1.b6c732b5b26d3p-19},
     /* [431] 1.875 <= y <= 2 2^13, degree 10, 61.1 bits */
    {0x1.5a90d6342baf9p-5, -0x1.ce31a7ce1a843p-61, -0x1.7cefbf4317697p-7, 0x1.c4c91c6ee82a1p-8, -0x1.3fdd5382131aap-8,
     0x1.e867d3c4a71f5p-9, -0x1.85c0d29a1aa45p-9, 0x1.4011e4aa22ba1p-9, -0x1.0c2c70f1e54a3p-9, 0x1.c8200de58100cp-10,
     -0x1.8b4df9ad144f8p-10, 0x1.5732df5a4356cp-10}, /* [432] 1 <= y <= 1.125 2^14, degree 10, 58.1 bits */
    {0x1.4f797b29db8edp-5, -0x1.f8066f29fd77p-59, -0x1.4afcb337fcbc1p-7, 0x1.606f5eb5368aap-8, -0x1.bde0f495c888ap-9,
     0x1.30c0d4a669a65p-9, -0x1.b36563f38eef7p-10, 0x1.400a311e86795p-10, -0x1.e0024dac53164p-11, 0x1.6d5a1f0c6b231p-11,
     -0x1.1af5a7b842a4ep-11, 0x1.b7b3e4fbe6d31p-12}, /* [433] 1.125 <= y <= 1.25 2^14, degree 10, 58.9 bits */
    {0x1.45c4f60b99244p-5, 0x1.983fd05ca70c4p-59, -0x1.239f5b152af79p-7, 0x1.194042cf75895p-8, -0x1.4227df63b80a9p-9,
     0x1.8ea4bbe8845abp-10, -0x1.01c0c96fd30d2p-10, 0x1.56f48d54c4cdap-11, -0x1.d187d784fb761p-12, 0x1.40ab9f3e21c8p-12,
     -0x1.c105e9ed9f117p-13, 0x1.3bb6ce71943adp-13}, /* [434] 1.25 <= y <= 1.375 2^14, degree 10, 60.8 bits */
    {0x1.3d2b4287d7c8cp-5, -0x1.aec7984751aacp-59, -0x1.03e348a842723p-7, 0x1.ca24ba3cc0cd5p-9, -0x1.df704f36ac9bdp-10,
     0x1.0ef701cc2cd93p-10, -0x1.400c07ce5fa02p-11, 0x1.84ee789cf582ep-12, -0x1.e229514c0c4d2p-13,
     0x1.2f512bc2e26dbp-13, -0x1.838f081adb7eap-14, 0x1.f1b1b6346fafap-15},
     /* [435] 1.375 <= y <= 1.5 2^14, degree 10, 59.2 bits */
    {0x1.3577b1df879b6p-5, 0x1.879dadc5f7f05p-60, -0x1.d3a4446c9c506p-8, 0x1.7b8c4b1130f14p-9, -0x1.6d9e721d9f0a7p-10,
     0x1.7c5eddfdf82f1p-11, -0x1.9d776e31cc675p-12, 0x1.ce64055d09c37p-13, -0x1.07bfe8fd7ed63p-13,
     0x1.315b31de8955ep-14, -0x1.66cbb115fbbcep-15, 0x1.a7f775216f134p-16},
     /* [436] 1.5 <= y <= 1.625 2^14, degree 10, 61.6 bits */
    {0x1.2e82a674940c9p-5, -0x1.ae4578856ef34p-59, -0x1.a823f1eb5751dp-8, 0x1.3eff04c9b48dcp-9, -0x1.1cac0123c7c8p-10,
     0x1.1252e9d1c2d31p-11, -0x1.143038a87a1e4p-12, 0x1.1e100b944c678p-13, -0x1.2e3c7717f27cp-14, 0x1.440ebb77c53eep-15,
     -0x1.60740725bf10cp-16, 0x1.81ae4ac0b53ap-17}, /* [437] 1.625 <= y <= 1.75 2^14, degree 10, 60.6 bits */
    {0x1.282da445250f5p-5, -0x1.6021d4afe4ae7p-60, -0x1.835a81f34b35ap-8, 0x1.0f6f6ec4d2ea1p-9, -0x1.c341c3e82f277p-11,
     0x1.95011a79d4223p-12, -0x1.7bbde7a847521p-13, 0x1.6e475f5361c66p-14, -0x1.685f3ec4d624ep-15,
     0x1.67ceb7311ed41p-16, -0x1.6c4331556d969p-17, 0x1.732a5d15d4be7p-18},
     /* [438] 1.75 <= y <= 1.875 2^14, degree 10, 60.5 bits */
    {0x1.2260bf694b428p-5, -0x1.85caa158efff7p-59, -0x1.63e24be3f0659p-8, 0x1.d2e6fa52f994cp-10, -0x1.6b39d6185d761p-11,
     0x1.310fe8fde3705p-12, -0x1.0ba61a760e4a9p-13, 0x1.e31d036038c1fp-15, -0x1.bcbd6cfa42d9bp-16,
     0x1.9f76c0dc1ff62p-17, -0x1.89679c75d4a31p-18, 0x1.770bfe37409a1p-19},
     /* [439] 1.875 <= y <= 2 2^14, degree 10, 64.2 bits */
    {0x1.1a83e139c08a5p-5, -0x1.a7015cba8517fp-64, -0x1.3c71d7e1a9a6ap-7, 0x1.7ae061b538da7p-8, -0x1.0ce5c93052fd7p-8,
     0x1.9c011e8ae2e4fp-9, -0x1.49b26623ca753p-9, 0x1.0f619c02a7b1cp-9, -0x1.c7ac5dde10c18p-10, 0x1.84348e568695bp-10,
     -0x1.50fba9c08a23p-10, 0x1.24fc72cecc2cap-10}, /* [440] 1 <= y <= 1.125 2^15, degree 10, 57.9 bits */
    {0x1.114e6af05b6d8p-5, -0x1.80e0b2cb2cfcap-59, -0x1.12ac1a7a38be6p-7, 0x1.2690df5ca83a1p-8, -0x1.765e6c51b32p-9,
     0x1.00bf49419ffadp-9, -0x1.6fcfcd5d15f66p-10, 0x1.0efb1338079abp-10, -0x1.973b7dbf9852ap-11, 0x1.368016a01429dp-11,
     -0x1.e1b7510ba55dbp-12, 0x1.76cf72c29e919p-12}, /* [441] 1.125 <= y <= 1.25 2^15, degree 10, 59.7 bits */
    {0x1.09418b4a9d53ep-5, 0x1.9b815c2f9207fp-59, -0x1.e39353fd13a47p-8, 0x1.d5a8f285808d6p-9, -0x1.0e312a96b908fp-9,
     0x1.4f76242c11f21p-10, -0x1.b2f7d868aa162p-11, 0x1.22071ebb41a1bp-11, -0x1.8a7437a5df976p-12,
     0x1.102dabaacc90ep-12, -0x1.7db6e8cb12128p-13, 0x1.0cc394f35eaacp-13},
     /* [442] 1.25 <= y <= 1.375 2^15, degree 10, 60.0 bits */
    {0x1.0220d1dc9d898p-5, -0x1.68cd7c1cdaa66p-61, -0x1.ae9b1382ff63dp-8, 0x1.7e2d0f4f1904bp-9, -0x1.91b5e4bef5762p-10,
     0x1.c7917d9c9259bp-11, -0x1.0dc1ed9e96935p-11, 0x1.488c26fdfef6p-12, -0x1.981615550c79ap-13, 0x1.01276ad619a79p-13,
     -0x1.49140ff093b4ep-14, 0x1.a72dbfd7025bp-15}, /* [443] 1.375 <= y <= 1.5 2^15, degree 10, 62.6 bits */
    {0x1.f78028132bc1cp-6, 0x1.82af49ffda6cep-63, -0x1.8322568b5987bp-8, 0x1.3c59e22e68edp-9, -0x1.32125546e0528p-10,
     0x1.3f750c509644ap-11, -0x1.5c294f7665c02p-12, 0x1.8636a65dfd7f6p-13, -0x1.be0127bfc1407p-14,
     0x1.029d2d6b0ee57p-14, -0x1.3055426bb0fe8p-15, 0x1.681a31faed2c9p-16},
     /* [444] 1.5 <= y <= 1.625 2^15, degree 10, 60.9 bits */
    {0x1.ebfc474c95ddp-6, -0x1.6f87e2b7531bdp-60, -0x1.5ee3b9bf7e0dbp-8, 0x1.09ae5e2c45991p-9, -0x1.dc3b0dbbcffbbp-11,
     0x1.cc650fb95cbb4p-12, -0x1.d0b8c0a48e6d5p-13, 0x1.e2619ee9b1ac6p-14, -0x1.fe9c7fe837bb1p-15,
     0x1.12314c3726bebp-15, -0x1.2aaa2715111e6p-16, 0x1.474330e8dd246p-17},
     /* [445] 1.625 <= y <= 1.75 2^15, degree 10, 61.7 bits */
    {0x1.e182fc08f8635p-6, -0x1.c63fbed7fed55p-60, -0x1.4042efc3f27dp-8, 0x1.c3d3715e46c21p-10, -0x1.792d095b97885p-11,
     0x1.539798691f183p-12, -0x1.3f392d87988f9p-13, 0x1.3491228205d5bp-14, -0x1.30279d06bb791p-15,
     0x1.302d2bb49f16fp-16, -0x1.3465db187e0ebp-17, 0x1.3aa978d35525cp-18},
     /* [446] 1.75 <= y <= 1.875 2^15, degree 10, 61.9 bits */
    {0x1.d7ec44e4b787p-6, 0x1.e870fdcf3dd2ep-60, -0x1.2613f15e522efp-8, 0x1.8459ad83e9393p-10, -0x1.2f6372ebcf1f3p-11,
     0x1.ff3707d9504a9p-13, -0x1.c1a7119865a99p-14, 0x1.96ae036979d0bp-15, -0x1.7710d246e5115p-16, 0x1.5ef1f7ac72adp-17,
     -0x1.4ccc3dd9fad71p-18, 0x1.3db014d4647eep-19}, /* [447] 1.875 <= y <= 2 2^15, degree 10, 61.4 bits */
    {0x1.caeef33012d97p-6, 0x1.acbf897e7979ep-61, -0x1.0549b99ced47p-7, 0x1.3adbf2a78802cp-8, -0x1.c0c7395a1939fp-9,
     0x1.58df7b2ae76b7p-9, -0x1.14a9f9c1d20fap-9, 0x1.c8693c9889c0cp-10, -0x1.7fdf324692992p-10, 0x1.478f06e5e397p-10,
     -0x1.1cc0a6e88c6bdp-10, 0x1.efcba5fff5a56p-11}, /* [448] 1 <= y <= 1.125 2^16, degree 10, 57.7 bits */
    {0x1.bbbb9a1dfd83ap-6, 0x1.34aedb5907f55p-60, -0x1.c52eb970ec404p-8, 0x1.e91533e7ecc6p-9, -0x1.380e3a06a18d4p-9,
     0x1.ad532803eddd9p-10, -0x1.34462d8327b6dp-10, 0x1.c72b4212cdd95p-11, -0x1.56a015461f0a1p-11,
     0x1.05a6abe2e3d05p-11, -0x1.9682933d99a97p-12, 0x1.3cb347b0bc291p-12},
     /* [449] 1.125 <= y <= 1.25 2^16, degree 10, 59.3 bits */
    {0x1.ae74b8134f5d7p-6, -0x1.6e4ea1b421a2p-62, -0x1.8e9b6d09da7b9p-8, 0x1.858b4c5a98e0ep-9, -0x1.c1fec7f5f8807p-10,
     0x1.182f4179a4645p-10, -0x1.6c2b4d1574c13p-11, 0x1.e69fda2dc78c9p-12, -0x1.4b7f9bbce052bp-12,
     0x1.ca2f90cc19247p-13, -0x1.41bd96351d763p-13, 0x1.c5a54b07a91c1p-14},
     /* [450] 1.25 <= y <= 1.375 2^16, degree 10, 61.1 bits */
    {0x1.a2b59587f571bp-6, -0x1.a8e6cf1b06cfp-60, -0x1.62b0d5ee75d46p-8, 0x1.3cb97656bd0ep-9, -0x1.4e391f4c6797dp-10,
     0x1.7c260c50bf8dfp-11, -0x1.c343f9d7352b1p-12, 0x1.135acfa6d0d43p-12, -0x1.569b710b7f22dp-13,
     0x1.b071f7267dcbap-14, -0x1.1514c983b9652p-14, 0x1.64c1ce549a65ep-15},
     /* [451] 1.375 <= y <= 1.5 2^16, degree 10, 60.1 bits */
    {0x1.9834aac31aaebp-6, 0x1.e03a719811d63p-61, -0x1.3ead5bfde79b6p-8, 0x1.05fab159f82aap-9, -0x1.fce60261a0ebfp-11,
     0x1.0a591c1102092p-11, -0x1.22f58e57c788bp-12, 0x1.46be8a7ab0fcbp-13, -0x1.76190d1b34f31p-14,
     0x1.b27e2cb99d1c6p-15, -0x1.00003528c72a7p-15, 0x1.2f49379138701p-16},
     /* [452] 1.5 <= y <= 1.625 2^16, degree 10, 61.1 bits */
    {0x1.8ebac651295dep-6, -0x1.a7213a39c75d9p-60, -0x1.20ac06459024bp-8, 0x1.b7bd87c85df2cp-10, -0x1.8b9f5f5553a78p-11,
     0x1.7f90146990d7ap-12, -0x1.840fcf18ccdcfp-13, 0x1.93976c4dd8227p-14, -0x1.abee2cccf4c79p-15,
     0x1.cc45ca5f56ff7p-16, -0x1.f606fa60c2504p-17, 0x1.1362203e1dc7dp-17},
     /* [453] 1.625 <= y <= 1.75 2^16, degree 10, 59.9 bits */
    {0x1.861d8135d95dep-6, -0x1.c2f2c8c6079cep-60, -0x1.07552ebf7c9bep-8, 0x1.75b01f0231989p-10, -0x1.3920473d52efep-11,
     0x1.1ab8f4ed5ede6p-12, -0x1.0a5f07262e645p-13, 0x1.01f95371ad2a9p-14, -0x1.fd6add6178e24p-16,
     0x1.fe345b9c24c7ep-17, -0x1.02fc8e020eeefp-17, 0x1.08909ed65f93ep-18},
     /* [454] 1.75 <= y <= 1.875 2^16, degree 10, 59.9 bits */
    {0x1.7e3ba20801a8bp-6, 0x1.7d7df7c1071e1p-61, -0x1.e35de5d4b8cc6p-9, 0x1.4101d51a05c63p-10, -0x1.f76dd8826668bp-12,
     0x1.a95489a57c466p-13, -0x1.76f464719b0f5p-14, 0x1.53c3e425495edp-15, -0x1.39de86311eb9ep-16,
     0x1.261cc94409036p-17, -0x1.17454a70acd55p-18, 0x1.0ae88a04e7774p-19},
     /* [455] 1.875 <= y <= 2 2^16, degree 10, 60.8 bits */
    {0x1.738fb22d8e3c1p-6, -0x1.b4cdf30c429c2p-61, -0x1.ad2e031c22dcp-8, 0x1.040ed43f47e71p-8, -0x1.74078d06b9176p-9,
     0x1.1eae5d111cc76p-9, -0x1.ccfc09d5a7555p-10, 0x1.7cf4237cb553fp-10, -0x1.40ed5f5f5d535p-10, 0x1.123dc51078fddp-10,
     -0x1.dd6dd980c8bfcp-11, 0x1.a01fc24e535bep-11}, /* [456] 1 <= y <= 1.125 2^17, degree 10, 57.7 bits */
    {0x1.6715199026a7fp-6, -0x1.0e71cf1963d03p-60, -0x1.73e3d6f1d5e34p-8, 0x1.93963fab877bfp-9, -0x1.026eb99aa9a44p-9,
     0x1.6482c5ff8636ap-10, -0x1.008c70db67229p-10, 0x1.7b7dee90af19ap-11, -0x1.1e1d7e2354619p-11,
     0x1.b59be799a3af4p-12, -0x1.5460b403a64c9p-12, 0x1.097bee6503938p-12},
     /* [457] 1.125 <= y <= 1.25 2^17, degree 10, 58.8 bits */
    {0x1.5c30e633bc8cfp-6, -0x1.cf4abd3310222p-60, -0x1.46df701ad4a0dp-8, 0x1.41300606e450bp-9, -0x1.7457b69eb638dp-10,
     0x1.d0e69c5f0e795p-11, -0x1.2ec6394863f72p-11, 0x1.9550e9fc37d28p-12, -0x1.148ad9d1c63e6p-12,
     0x1.7ec2054a0b9e3p-13, -0x1.0d1ce736ca73ep-13, 0x1.7bdf5736b7c86p-14},
     /* [458] 1.25 <= y <= 1.375 2^17, degree 10, 59.2 bits */
    {0x1.528fb6f49e7c7p-6, 0x1.9998c1f3bd9a4p-60, -0x1.22acfc1e9ae0cp-8, 0x1.04f4edcb9f862p-9, -0x1.1454ff58e973ep-10,
     0x1.3b1fad49f4dd7p-11, -0x1.76dd847bb62cap-12, 0x1.ca498490457dcp-13, -0x1.1d8cb7fc95cc8p-13,
     0x1.68eb3f59819b6p-14, -0x1.cf13aa92eb3a4p-15, 0x1.2a7394dbfc0aap-15},
     /* [459] 1.375 <= y <= 1.5 2^17, degree 10, 59.7 bits */
    {0x1.49f4b990195e5p-6, 0x1.aa3a65505e3d7p-60, -0x1.05034a4272d9dp-8, 0x1.af6b4bb51f789p-10, -0x1.a474498b1e777p-11,
     0x1.b93fb5f3a2d98p-12, -0x1.e3060f9e0ffa2p-13, 0x1.0fb0f2617033ep-13, -0x1.378a2f1e38ce7p-14, 0x1.6a52c152dbadp-15,
     -0x1.ab7a87efe60fep-16, 0x1.fafedd55ceaaap-17}, /* [460] 1.5 <= y <= 1.625 2^17, degree 10, 61.0 bits */
    {0x1.42324f82670b5p-6, 0x1.00bddf7d5249ap-60, -0x1.d8a0eb11eaa84p-9, 0x1.69dc05bdc5c3ap-10, -0x1.46a7a29e6536p-11,
     0x1.3d8064fa911e1p-12, -0x1.41e2837cfb53dp-13, 0x1.4f5889d1530c3p-14, -0x1.641a80c672b16p-15, 0x1.7f86f424d035p-16,
     -0x1.a2d2ba28452aep-17, 0x1.cbfc2f3e46fd8p-18}, /* [461] 1.625 <= y <= 1.75 2^17, degree 10, 61.4 bits */
    {0x1.3b2572e033077p-6, -0x1.52bae576830ep-60, -0x1.aeefd5dec7cbfp-9, 0x1.3356656a4644p-10, -0x1.026321e663bfcp-11,
     0x1.d3c45641d368bp-13, -0x1.b99b54e592c43p-14, 0x1.ac6aac492ba3p-15, -0x1.a79f4bfb000e9p-16, 0x1.a8d5bdbcd5935p-17,
     -0x1.afd0f6d39e58ap-18, 0x1.b99797b5ccb5bp-19}, /* [462] 1.75 <= y <= 1.875 2^17, degree 10, 60.2 bits */
    {0x1.34b2b6cd4f064p-6, -0x1.3f0289a7f050ep-60, -0x1.8b55bf244860fp-9, 0x1.07e0a821b7409p-10, -0x1.9f325791cc5c8p-12,
     0x1.5fa79188217a2p-13, -0x1.36a0422ca7681p-14, 0x1.19f31d90b2728p-15, -0x1.04d7b648fdf52p-16,
     0x1.e97bb37f4a17cp-18, -0x1.d1541734b166ep-19, 0x1.bd341fc0abf9p-20},
     /* [463] 1.875 <= y <= 2 2^17, degree 10, 60.2 bits */
    {0x1.2bf8fda912996p-6, 0x1.3a2278f584d17p-61, -0x1.5ece7da67f55cp-8, 0x1.ab41d01e1e23bp-9, -0x1.32993f4adc84cp-9,
     0x1.d9ac4d3f4793fp-10, -0x1.7d95b075dfc86p-10, 0x1.3bdcee016f48ep-10, -0x1.0a7a32b5b05bbp-10,
     0x1.c80206409f638p-11, -0x1.8d65c26e6a55p-11, 0x1.5abb64eed6bb9p-11},
     /* [464] 1 <= y <= 1.125 2^18, degree 10, 57.4 bits */
    {0x1.21c6af80a2ac8p-6, -0x1.a213be654966fp-60, -0x1.2fc388f47d0ebp-8, 0x1.4b4365a401459p-9, -0x1.a9964497246c3p-10,
     0x1.26408d78f7771p-10, -0x1.a84fc449cd9dbp-11, 0x1.3a56579946cc6p-11, -0x1.daa8148eb61bap-12,
     0x1.6b723e6479a18p-12, -0x1.1b041e2829c74p-12, 0x1.b9f1187487fbep-13},
     /* [465] 1.125 <= y <= 1.25 2^18, degree 10, 59.2 bits */
    {0x1.18e1f633c264ep-6, -0x1.1e54ac03c0e16p-61, -0x1.0ad3a92eaba64p-8, 0x1.0770e6baba2e3p-9, -0x1.32596d2f77cecp-10,
     0x1.7f6645650de36p-11, -0x1.f45699abf10dcp-12, 0x1.4f6e8d2aeb5f7p-12, -0x1.ca5c2ea2c9cd4p-13,
     0x1.3d98a406321fdp-13, -0x1.bf19039c08f6fp-14, 0x1.3bdfedede175fp-14},
     /* [466] 1.25 <= y <= 1.375 2^18, degree 10, 59.2 bits */
    {0x1.11062fd7bfa28p-6, 0x1.36f52de4a8ca4p-60, -0x1.da4b3ff4fb7f2p-9, 0x1.abcdd4bfa5613p-10, -0x1.c6654db7de26dp-11,
     0x1.03b08436c7e95p-11, -0x1.357fa4be81816p-12, 0x1.7af88a2f22132p-13, -0x1.d8e7f49e7c9e6p-14,
     0x1.2b3a1713cf433p-14, -0x1.80589e63e228dp-15, 0x1.efe9ce6a5a7e5p-16},
     /* [467] 1.375 <= y <= 1.5 2^18, degree 10, 60.3 bits */
    {0x1.0a015593f3cb2p-6, 0x1.3ad3947fbab0cp-60, -0x1.a9adef7dc4bedp-9, 0x1.616c433fdfbadp-10, -0x1.597a4be28b3ddp-11,
     0x1.6b6332d0e951p-12, -0x1.8e85c2d4fc7dep-13, 0x1.c104d3d0a6d71p-14, -0x1.01c92a4885e94p-14, 0x1.2c2a90879ccafp-15,
     -0x1.628752737b81fp-16, 0x1.a4e38dd738d5bp-17}, /* [468] 1.5 <= y <= 1.625 2^18, degree 10, 61.2 bits */
    {0x1.03ade8051186ap-6, 0x1.ce5a31eb4d6cp-61, -0x1.81392a6b86de5p-9, 0x1.28487b2ed23b2p-10, -0x1.0c408c3c6f432p-11,
     0x1.0551af8dfcb9bp-12, -0x1.09684200681ffp-13, 0x1.14ee2deed824bp-14, -0x1.2676d646573fp-15, 0x1.3d84185acb09bp-16,
     -0x1.5b1bab8eba247p-17, 0x1.7d976bd4d94bcp-18}, /* [469] 1.625 <= y <= 1.75 2^18, degree 10, 60.0 bits */
    {0x1.fbde43cf6a15p-7, 0x1.d8897a2c2271fp-61, -0x1.5f1856e844188p-9, 0x1.f70a827ae96b3p-11, -0x1.a828b719ceab9p-12,
     0x1.80c862bde799dp-13, -0x1.6be9f4ab66bdp-14, 0x1.61942b402144fp-15, -0x1.5e1502699592cp-16, 0x1.5f7e842eec162p-17,
     -0x1.65a5d19b210dfp-18, 0x1.6e18454ebf155p-19}, /* [470] 1.75 <= y <= 1.875 2^18, degree 10, 62.3 bits */
    {0x1.f15cfdeb9a7ccp-7, 0x1.6d92242a638ep-63, -0x1.41f722bb45476p-9, 0x1.afb72ffb07d29p-11, -0x1.549f42a771a1dp-12,
     0x1.211f59bf46168p-13, -0x1.ffaecc0b5c235p-15, 0x1.d123d458db257p-16, -0x1.aee0fbb00c76ep-17,
     0x1.94bfa388f484fp-18, -0x1.812d43dda31d6p-19, 0x1.70de0829966aap-20},
     /* [471] 1.875 <= y <= 2 2^18, degree 10, 59.9 bits */
    {0x1.e3279ae1b5c3bp-7, -0x1.3cd8dfe745e56p-61, -0x1.1d8d0fd8768afp-8, 0x1.5d4b5dd6531b8p-9, -0x1.f6babd5825f2fp-10,
     0x1.852c66d877885p-10, -0x1.3a0ee0f761028p-10, 0x1.04595fd16c3c5p-10, -0x1.b7d9282dbac3ap-11, 0x1.78c57353d08dp-11,
     -0x1.48af7308f5782p-11, 0x1.1f0c15b83af71p-11}, /* [472] 1 <= y <= 1.125 2^19, degree 10, 57.8 bits */
    {0x1.d28f6cc762379p-7, 0x1.46cc3ab495d1bp-62, -0x1.ee361ff18037cp-9, 0x1.0e9f8c01c5e8fp-9, -0x1.5ca59d1f21a57p-10,
     0x1.e31fa857ebc5ap-11, -0x1.5cecef68c1fcp-11, 0x1.02dcd0ae11867p-11, -0x1.8760eef9a6983p-12, 0x1.2c037dae104e7p-12,
     -0x1.d3b72d408f907p-13, 0x1.6d8330c547d05p-13}, /* [473] 1.125 <= y <= 1.25 2^19, degree 10, 58.8 bits */
    {0x1.c4184c2e378e5p-7, -0x1.fd33df1da1bd3p-62, -0x1.b1e115e118528p-9, 0x1.ae294567f941ap-10, -0x1.f5969a92d6664p-11,
     0x1.3a84b7e93fce4p-11, -0x1.9b226c349e24ap-12, 0x1.1404ccc0fa98fp-12, -0x1.79a34f10717acp-13,
     0x1.05f3407d9f05ap-13, -0x1.7120ccc07aeb9p-14, 0x1.0505f1730eab5p-14},
     /* [474] 1.25 <= y <= 1.375 2^19, degree 10, 59.3 bits */
    {0x1.b751ce3c37defp-7, 0x1.4bf4aa4493042p-62, -0x1.816e058d177b7p-9, 0x1.5d13167b1af2ep-10, -0x1.73c40de79f4bcp-11,
     0x1.a9cafd8f5e84p-12, -0x1.fc4b994c0a0e4p-13, 0x1.37a0e54fb45dep-13, -0x1.8557b82ba7727p-14, 0x1.ed3c5ca92609cp-15,
     -0x1.3d14bd96ceb41p-15, 0x1.997be09132fc7p-16}, /* [475] 1.375 <= y <= 1.5 2^19, degree 10, 60.1 bits */
    {0x1.abea0f9ed388bp-7, -0x1.a87d872530991p-62, -0x1.59c5936fb081fp-9, 0x1.203c4f3482555p-10, -0x1.1a7f9d38f4331p-11,
     0x1.29bc5a7078175p-12, -0x1.470d307aafe0cp-13, 0x1.70ff2e8b1b119p-14, -0x1.a831bb878fe7ep-15,
     0x1.ee74b33786bc4p-16, -0x1.244882e8a743bp-16, 0x1.5b4b6163cbb5bp-17},
     /* [476] 1.5 <= y <= 1.625 2^19, degree 10, 61.7 bits */
    {0x1.a1a3b87fee81p-7, -0x1.0fe8b2929d37p-69, -0x1.38c8fce17f7ep-9, 0x1.e30c0e6345774p-11, -0x1.b67b69186562bp-12,
     0x1.abfd0b556f2c1p-13, -0x1.b3609ffb61518p-14, 0x1.c6e4cef58f4f8p-15, -0x1.e443a60a1dedap-16,
     0x1.055c226f2aa71p-16, -0x1.1dfd1f847a0a1p-17, 0x1.3aab8d68a8e94p-18},
     /* [477] 1.625 <= y <= 1.75 2^19, degree 10, 61.7 bits */
    {0x1.984fbe4b39c5dp-7, 0x1.34123e8a17576p-62, -0x1.1cf866c3be179p-9, 0x1.99e51cec559eap-11, -0x1.5a81089d89a52p-12,
     0x1.3af2204199d44p-13, -0x1.2a55551bef7c3p-14, 0x1.223f3fa5767b7p-15, -0x1.1fb5d2b18627bp-16,
     0x1.212b2bd8f1162p-17, -0x1.26817a68214a7p-18, 0x1.2db78ca78578cp-19},
     /* [478] 1.75 <= y <= 1.875 2^19, degree 10, 59.6 bits */
    {0x1.8fc954afbc22dp-7, 0x1.a24a557032667p-61, -0x1.053d2f52d9d3bp-9, 0x1.5fa3c80ddbd6ap-11, -0x1.1624c0e455578p-12,
     0x1.d91569eaa86ebp-14, -0x1.a346f75277a2bp-15, 0x1.7da42e56c2b01p-16, -0x1.61ef94292a305p-17,
     0x1.4ccf745cbe30bp-18, -0x1.3d025a2932f59p-19, 0x1.2fd71c7af5ca6p-20}
     /* [479] 1.875 <= y <= 2 2^19, degree 10, 62.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_power_eps_zero_force)

/* (1 - eps)/beta at zero overlap, beta < 7: 57 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 7.0625.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. */
#define COR_ROWS_LOSS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_LOSS_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_LOSS_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_LOSS_ZERO_OVERLAP_ROWS 57
#define COR_ROWS_LOSS_ZERO_OVERLAP_END 7.0
COR_ROWS(double, cor_rows_loss_zero_overlap, 57, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.27486c8p+0, 0x1.1905c1608e8f4p-27, -0x1.98b665097f1f8p-1, 0x1.0bb743932d2d3p-1, -0x1.651cccc3d9d9p-2,
     0x1.dd628dadfcdacp-3, -0x1.40e292678987p-3, 0x1.b16efd3921bbfp-4, -0x1.25f18370304cep-4, 0x1.8fe9088c02348p-5,
     -0x1.0cd91ebb07539p-5, 0x1.2f4b1a1ec31c2p-6}, /* [0] 0 <= y <= 0.0625, degree 10, 60.1 bits */
    {0x1.0fab42p+0, 0x1.5abdc8bac0e0cp-29, -0x1.5d4f51d00938ep-1, 0x1.a51ce59a6f9e9p-2, -0x1.0327a41a214e3p-2,
     0x1.3f0ed37fd2c66p-3, -0x1.8ad7c397e401p-4, 0x1.eac328752953p-5, -0x1.321c61cc158a6p-5, 0x1.7f3cc7ac61772p-6,
     -0x1.e3256cdac062cp-7, 0x1.303abeebb3f53p-7}, /* [1] 0.0625 <= y <= 0.1875, degree 10, 59.0 bits */
    {0x1.f6baaa8p-1, -0x1.fb0c423e7035dp-29, -0x1.2e2d36a1c457ap-1, 0x1.51290051c824fp-2, -0x1.816a7bd7e8b12p-3,
     0x1.b7d20ae89481p-4, -0x1.f84a97fe766f5p-5, 0x1.224f8756bbb8bp-5, -0x1.4f4a0c57af171p-6, 0x1.849029699bccbp-7,
     -0x1.c50e50617d696p-8, 0x1.07f2ccf6427b1p-8}, /* [2] 0.1875 <= y <= 0.3125, degree 10, 59.0 bits */
    {0x1.d36a5dp-1, 0x1.316a495c46c28p-29, -0x1.082772308b052p-1, 0x1.1217a9a3d7182p-2, -0x1.24a536efc628cp-3,
     0x1.3740e4fbe4742p-4, -0x1.4c74a5e42f714p-5, 0x1.649eb4cd04ccfp-6, -0x1.7f7034bad7b06p-7, 0x1.9db1e4c0e7b2ep-8,
     -0x1.c0b72f9ad56fp-9, 0x1.e684ff255ed53p-10}, /* [3] 0.3125 <= y <= 0.4375, degree 10, 58.2 bits */
    {0x1.b46751p-1, 0x1.1f5254291bc9cp-30, -0x1.d2153d5e6a217p-2, 0x1.c38f06eb2af2dp-3, -0x1.c48620178376ap-4,
     0x1.c2bf74af79aap-5, -0x1.c28e3e71a6f8ap-6, 0x1.c49352e5bec8fp-7, -0x1.c7265eb4d7544p-8, 0x1.cb7642abbab6p-9,
     -0x1.d1ea24dcf2cc4p-10, 0x1.d86524c840f37p-11}, /* [4] 0.4375 <= y <= 0.5625, degree 10, 60.2 bits */
    {0x1.98eeecp-1, 0x1.85f7a8b47bd56p-29, -0x1.9e886dafaf03dp-2, 0x1.7845227329d51p-3, -0x1.6372972a38fd2p-4,
     0x1.4d04b46bfb3dep-5, -0x1.38afd69e7da1fp-6, 0x1.277e27ba4f4e1p-7, -0x1.170e74ba3a367p-8, 0x1.08bcbfd638adap-9,
     -0x1.f8257a53c3fc8p-11, 0x1.e00561a3e3d5bp-12}, /* [5] 0.5625 <= y <= 0.6875, degree 10, 58.7 bits */
    {0x1.8069aep-1, -0x1.c6e640a63a5f9p-28, -0x1.735c93bee2659p-2, 0x1.3cba5176d2945p-3, -0x1.1b19bf346b38dp-4,
     0x1.f4fa20a04013ep-6, -0x1.bb2953ada7218p-7, 0x1.8bc2d87365fa1p-8, -0x1.60178a3e4a824p-9, 0x1.3b267530384d4p-10,
     -0x1.1adf63507076bp-11, 0x1.fba17634d83fep-13}, /* [6] 0.6875 <= y <= 0.8125, degree 10, 59.4 bits */
    {0x1.6a5fda8p-1, 0x1.ff437d45d165fp-29, -0x1.4edc05c28eef1p-2, 0x1.0d04b04ddf992p-3, -0x1.c88209eb603bcp-5,
     0x1.7ef9a993d1d6p-6, -0x1.3fd00185c7481p-7, 0x1.0f1f420f3bf2p-8, -0x1.c79cae739592bp-10, 0x1.8215b7aaca362p-11,
     -0x1.47f42860c330ep-12, 0x1.15fe809414c81p-13}, /* [7] 0.8125 <= y <= 0.9375, degree 10, 59.5 bits */
    {0x1.567191p-1, -0x1.d149d219709e2p-29, -0x1.2fbb4334704cep-2, 0x1.ccb1c251e37edp-4, -0x1.740b8c0147469p-5,
     0x1.292953678e3dp-6, -0x1.d4f2b7ca89255p-8, 0x1.7b391e6cd3738p-9, -0x1.2d881f444fff2p-10, 0x1.e50aa442097d5p-12,
     -0x1.87c37e33a149p-13, 0x1.39e7b983ae785p-14}, /* [8] 0.9375 <= y <= 1.0625, degree 10, 59.6 bits */
    {0x1.445123p-1, -0x1.831034bb3cac1p-28, -0x1.14fb3bcbf070cp-2, 0x1.8d5e66ebe7605p-4, -0x1.32100361f7ee5p-5,
     0x1.d3a84f9cbc67dp-7, -0x1.5c80169e9ca63p-8, 0x1.0e44e5fd30772p-9, -0x1.9781a63378f9ep-11, 0x1.373c7e7692c7p-12,
     -0x1.e1a61d7ce0ec9p-14, 0x1.6badba522dec3p-15}, /* [9] 1.0625 <= y <= 1.1875, degree 10, 58.9 bits */
    {0x1.33befd8p-1, -0x1.2b4aad3b6250fp-33, -0x1.fba99cf22149fp-3, 0x1.5910e48264993p-4, -0x1.fb9afd49a8444p-6,
     0x1.74ffbbb10f432p-7, -0x1.05f276909f29fp-8, 0x1.87e39088d76bdp-10, -0x1.190600d690513p-11, 0x1.95d6a2deeff2bp-13,
     -0x1.310fba484cf21p-14, 0x1.ae1c4d7f495efp-16}, /* [10] 1.1875 <= y <= 1.3125, degree 10, 59.7 bits */
    {0x1.2486a4p-1, -0x1.6d12f84fc21b7p-30, -0x1.d354b4dad3e29p-3, 0x1.2d8ce6cc1ad2fp-4, -0x1.a7b3831675abap-6,
     0x1.2d8552210df33p-7, -0x1.8d7bc3d8154a2p-9, 0x1.2052ab1ad9456p-10, -0x1.8c6914da02613p-12, 0x1.0a842dd91e724p-13,
     -0x1.8f91fbc5f5328p-15, 0x1.02fc18d322d1fp-16}, /* [11] 1.3125 <= y <= 1.4375, degree 10, 60.8 bits */
    {0x1.167c6e8p-1, -0x1.1fd56feae261ep-28, -0x1.affacbb9ad74p-3, 0x1.092282bdeb81p-4, -0x1.636e18950dfe4p-6,
     0x1.ee28cbf1e0fdp-8, -0x1.2ffa1bd3a84ffp-9, 0x1.aca6971b9c074p-11, -0x1.1fd92bcb694c2p-12, 0x1.5b6be5b3278e9p-14,
     -0x1.0f3d718607932p-15, 0x1.420ff0a7bfeafp-17}, /* [12] 1.4375 <= y <= 1.5625, degree 10, 60.1 bits */
    {0x1.097bd7p-1, 0x1.83addd88a1938p-31, -0x1.90ce26cc7943ep-3, 0x1.d511ca8f9b7d7p-5, -0x1.2b1c36ce5d414p-6,
     0x1.9a94788ac4a19p-8, -0x1.d4b0a64d83fdcp-10, 0x1.3f2cd741eb2e1p-11, -0x1.b3d716bff750fp-13, 0x1.b76f9dd6ce99bp-15,
     -0x1.78ce4ced0a634p-16, 0x1.ba9ab4244e755p-18}, /* [13] 1.5625 <= y <= 1.6875, degree 10, 59.9 bits */
    {0x1.facc5fp-2, -0x1.d8e95547fbf0cp-29, -0x1.752521deb0579p-3, 0x1.a1876a4dd58e6p-5, -0x1.f8017ab5a88ccp-7,
     0x1.59d1fd79f116ap-8, -0x1.6d8ab8b19f148p-10, 0x1.d42dae61d7ed9p-12, -0x1.5d65c645c4344p-13, 0x1.07d9f2ac4de6cp-15,
     -0x1.f531ca22b20c8p-17, 0x1.82a439441995p-18}, /* [14] 1.6875 <= y <= 1.8125, degree 10, 61.3 bits */
    {0x1.e44344p-2, 0x1.7161b99881f5ep-31, -0x1.5c71e948a4c79p-3, 0x1.761ed547f5c31p-5, -0x1.a829ea0887763p-7,
     0x1.26d90a39dc743p-8, -0x1.234bcc3087e4bp-10, 0x1.477d7b5773361p-12, -0x1.2a2c63fe418adp-13, 0x1.3bae6e4430a27p-16,
     -0x1.ec20307b94e4p-18, 0x1.bcff73590b371p-18}, /* [15] 1.8125 <= y <= 1.9375, degree 10, 58.9 bits */
    {0x1.cf30db8p-2, 0x1.e7cf9dde05fc8p-29, -0x1.463c5cb5912f7p-3, 0x1.51a424c35580bp-5, -0x1.63c7bb6daba09p-7,
     0x1.fb0678014b31ep-9, -0x1.e3412b6b21588p-11, 0x1.998fe384909fcp-13, -0x1.07ecd31297a9dp-13, 0x1.057aa78c7148dp-16,
     0x1.0428eaaacf8ffp-19, 0x1.11d972c2b29adp-17}, /* [16] 1.9375 <= y <= 2.0625, degree 10, 58.9 bits */
    {0x1.bb70968p-2, -0x1.194955a05e816p-30, -0x1.321daaab3a136p-3, 0x1.331d89641c909p-5, -0x1.28e7daaafd7ccp-7,
     0x1.b46ce29e66f82p-9, -0x1.ab27446e56ce2p-11, 0x1.84f9b114c4336p-14, -0x1.c1b64b4d5ea65p-14, 0x1.8ca8446210645p-16,
     0x1.9e16aa8ec6391p-17, 0x1.0928bf36a6a2p-17}, /* [17] 2.0625 <= y <= 2.1875, degree 10, 59.2 bits */
    {0x1.a8e3dcp-2, -0x1.7a90b79a7388ep-29, -0x1.1fbd6025b9b08p-3, 0x1.19b5a412c79bap-5, -0x1.ecde1895d99d4p-8,
     0x1.73a17ed26cd7bp-9, -0x1.978c1b491bf62p-11, 0x1.87697bf73aba9p-17, -0x1.3a7849d6a56b4p-14, 0x1.62184d039af1cp-15,
     0x1.45f880a56879p-16, 0x1.33ea429a67178p-19}, /* [18] 2.1875 <= y <= 2.3125, degree 10, 59.9 bits */
    {0x1.977134p-2, -0x1.f7fc64a32975dp-29, -0x1.0ecfbb7318b34p-3, 0x1.04a8d5f542bbdp-5, -0x1.97ed3f0bb0238p-8,
     0x1.33be1bffa0a7cp-9, -0x1.9d1f052f6dc77p-11, -0x1.0e9e9a396cb4dp-15, -0x1.6f04eb5566a5ep-16,
     0x1.091e77fb952bbp-14, 0x1.fb7bea09e6feep-17, -0x1.52a6fd4a2ac36p-17},
     /* [19] 2.3125 <= y <= 2.4375, degree 10, 59.3 bits */
    {0x1.8703818p-2, -0x1.a9456b157011ep-31, -0x1.fe2a161575377p-4, 0x1.e66d95138df8p-6, -0x1.5325b86b19394p-8,
     0x1.e44e85f3d0b97p-10, -0x1.a9c007bea07a3p-11, -0x1.6fb1980f24fb3p-16, 0x1.87a1ad826e18ap-15,
     0x1.252289f9ee8f4p-14, -0x1.9fb7312d46108p-18, -0x1.838f65835726ap-16},
     /* [20] 2.4375 <= y <= 2.5625, degree 10, 60.1 bits */
    {0x1.7789428p-2, -0x1.3ea67b83b50e7p-31, -0x1.e0b3815e82dd1p-4, 0x1.c935cd5929c8fp-6, -0x1.1ef260c00e12p-8,
     0x1.5f0d3ef95d60fp-10, -0x1.a6868ceb5f52cp-11, 0x1.8c600ba63a907p-15, 0x1.c24b649e6f462p-14, 0x1.7e3b42bdf1843p-15,
     -0x1.36d054fa66d26p-15, -0x1.817aa690b89aap-16}, /* [21] 2.5625 <= y <= 2.6875, degree 10, 63.7 bits */
    {0x1.68f3ca8p-2, -0x1.c014a36bbd583p-29, -0x1.c4ed66d9987dep-4, 0x1.b01cab47b666p-6, -0x1.f643cfe57676ap-9,
     0x1.c000e8bd3a214p-11, -0x1.7f8bbe83fcc7bp-11, 0x1.42f609f5b33fp-13, 0x1.0b6f2b8c83a18p-13, -0x1.211dd057b3b43p-17,
     -0x1.c9afcc12dbdb4p-15, -0x1.106dd9febf6c5p-19}, /* [22] 2.6875 <= y <= 2.8125, degree 10, 60.4 bits */
    {0x1.5b367c8p-2, 0x1.e6a4ff44e243fp-33, -0x1.aaa1dccf475ccp-4, 0x1.99a843b126f54p-6, -0x1.cc51d2a9e7802p-9,
     0x1.cf306f8ea0349p-12, -0x1.2e6b233964cb3p-11, 0x1.09508f1ceca2p-12, 0x1.76b712c33dd33p-14, -0x1.0fd67835c202fp-14,
     -0x1.47be48823f5f3p-15, 0x1.af53b502bc1c6p-16}, /* [23] 2.8125 <= y <= 2.9375, degree 10, 61.0 bits */
    {0x1.4e46118p-2, -0x1.ff3d68808d6dep-33, -0x1.91b108e3dfab6p-4, 0x1.8496f7926b68bp-6, -0x1.b9cdce575b6e4p-9,
     0x1.30ea3713e12e5p-13, -0x1.7f93df92fac18p-12, 0x1.38629c365e956p-12, 0x1.3f6a33c9c56fbp-17,
     -0x1.6d3e6fac35d33p-14, 0x1.87adbb190ed01p-20, 0x1.214fbc886be54p-15},
     /* [24] 2.9375 <= y <= 3.0625, degree 10, 59.6 bits */
    {0x1.4217f7p-2, -0x1.2bc9ce4d8ca0ep-29, -0x1.7a0c7eec9ae9ap-4, 0x1.7001166510f88p-6, -0x1.b64013c469365p-9,
     -0x1.dd098ff9a3e3fp-17, -0x1.375f3fb64f454p-13, 0x1.1b2e1f0ee359fp-12, -0x1.2271a71a0abc2p-14,
     -0x1.0c02572765ec7p-14, 0x1.2ce4350795cacp-15, 0x1.23538b919f1fap-16},
     /* [25] 3.0625 <= y <= 3.1875, degree 10, 60.5 bits */
    {0x1.36a1dc8p-2, -0x1.f7ed8a1ab254cp-31, -0x1.63b1074d6f7f3p-4, 0x1.5b684449a7e6bp-6, -0x1.b8ee27a88205ep-9,
     -0x1.9e576a2a570d2p-15, 0x1.ad05603166e3fp-16, 0x1.8a6376f315e0ep-13, -0x1.ce8da4b36ab8cp-14,
     -0x1.1dfd659926f0ap-16, 0x1.607d6d715dfaap-15, -0x1.ba712bfb930cep-18},
     /* [26] 3.1875 <= y <= 3.3125, degree 10, 61.0 bits */
    {0x1.2bd9748p-2, 0x1.132825f951f73p-29, -0x1.4ea0331b727p-4, 0x1.46ae5cfebfb02p-6, -0x1.bace6febd63c1p-9,
     0x1.914d6a1ec7923p-19, 0x1.102fe03c4a188p-13, 0x1.7b9d63b6a1ed1p-14, -0x1.bd23503385897p-14, 0x1.727483df2c084p-16,
     0x1.a46f30cfd62f9p-16, -0x1.296a956adff8cp-16}, /* [27] 3.3125 <= y <= 3.4375, degree 10, 59.5 bits */
    {0x1.21b464p-2, 0x1.40302fe8bb3dbp-29, -0x1.3adb263216814p-4, 0x1.31f99c65ae4c1p-6, -0x1.b79a1aeba6de5p-9,
     0x1.9d3e8d768197cp-14, 0x1.5be7f754d7d18p-13, 0x1.607052c63124cp-17, -0x1.36d25826182ap-14, 0x1.3e61792b1c0afp-15,
     0x1.095936be14b88p-18, -0x1.dfcf8cb70e0b2p-17}, /* [28] 3.4375 <= y <= 3.5625, degree 10, 59.9 bits */
    {0x1.1828538p-2, 0x1.be598e007d1ap-29, -0x1.285f61341a4d6p-4, 0x1.1d92b2c112faap-6, -0x1.adc4a66ae0e61p-9,
     0x1.a3f8d5baedacap-13, 0x1.422e4cd50efb7p-13, -0x1.3c9ee9fdc4e8ep-15, -0x1.34efdde083607p-15, 0x1.1f3d63a22014p-15,
     -0x1.213bfc8016464p-17, -0x1.815f7721710c3p-18}, /* [29] 3.5625 <= y <= 3.6875, degree 10, 60.2 bits */
    {0x1.0f2b13p-2, 0x1.5f9d504d17ed4p-29, -0x1.17258b8c40ab3p-4, 0x1.09c82569d109cp-6, -0x1.9db9978e1ac4bp-9,
     0x1.2b53917285c75p-12, 0x1.e963bf4b37cbep-14, -0x1.db05ec59a24c6p-15, -0x1.18e336dfb79d6p-17,
     0x1.73d900c6a006ep-16, -0x1.8006026f22ceep-17, 0x1.2d93c1c321fb6p-21},
     /* [30] 3.6875 <= y <= 3.8125, degree 10, 61.6 bits */
    {0x1.06b2cp-2, 0x1.8347a9ff8fe11p-32, -0x1.0721b4be0bf47p-4, 0x1.edb8bd00afff8p-7, -0x1.88ec1ad75bc77p-9,
     0x1.69a0f18e0c135p-12, 0x1.3475fb762a4c3p-14, -0x1.d65c6cdeaa22ep-15, 0x1.018d4fde43abap-17, 0x1.5dc931b1f77c2p-17,
     -0x1.2ab468109b2c3p-17, 0x1.8a68a52aaccb7p-19}, /* [31] 3.8125 <= y <= 3.9375, degree 10, 61.3 bits */
    {0x1.fd6bcc8p-3, 0x1.51a574c764344p-30, -0x1.f088bd6c0bd2dp-5, 0x1.c9fc337ba46cp-7, -0x1.71174150d9cdfp-9,
     0x1.8cbfcc2335e44p-12, 0x1.24bd5453786fcp-15, -0x1.82b7a24b4dcbep-15, 0x1.cf20bc5b29691p-17, 0x1.55179fb6cd789p-19,
     -0x1.594ddd0fdc078p-18, 0x1.79e02cba90ae8p-19}, /* [32] 3.9375 <= y <= 4.0625, degree 10, 62.4 bits */
    {0x1.ee573p-3, 0x1.0fb569a0035a9p-30, -0x1.d4f7861bd722cp-5, 0x1.a88ff5c33b82p-7, -0x1.57ccad55dc98bp-9,
     0x1.994e6a27439f4p-12, 0x1.4ef6ab6fd7f5fp-18, -0x1.1a0489f30ee18p-15, 0x1.d7d24fc7bffd3p-17,
     -0x1.8ab4875e23b48p-20, -0x1.27d175aa01475p-19, 0x1.f0d9a73969bbcp-20},
     /* [33] 4.0625 <= y <= 4.1875, degree 10, 63.2 bits */
    {0x1.e016f5p-3, 0x1.057a26203c939p-30, -0x1.bb69faddef63bp-5, 0x1.89879c3a51d22p-7, -0x1.3e45bed0bcf23p-9,
     0x1.954a125c5660ap-12, -0x1.097e05177e44ap-16, -0x1.7508502485a77p-16, 0x1.89a2761108f53p-17,
     -0x1.8110d755ea5d2p-19, -0x1.042f358b97f56p-21, 0x1.fb6663bd57f29p-21},
     /* [34] 4.1875 <= y <= 4.3125, degree 10, 60.1 bits */
    {0x1.d29b97p-3, 0x1.e2785cc39849ep-30, -0x1.a3b9eca610211p-5, 0x1.6cddd2c7041a6p-7, -0x1.255e07a3db38ep-9,
     0x1.863e12215061ap-12, -0x1.e61765314277dp-16, -0x1.bd01c087eff4fp-17, 0x1.2664d500e9f9ap-17,
     -0x1.856de1575757dp-19, 0x1.3e95fc050e983p-22, 0x1.8201f4d1ec46cp-22},
     /* [35] 4.3125 <= y <= 4.4375, degree 10, 60.4 bits */
    {0x1.c5d6c08p-3, 0x1.0db34dab7b142p-30, -0x1.8dc21133096dfp-5, 0x1.527c948266e72p-7, -0x1.0da115847ac56p-9,
     0x1.7092d453fa0c5p-12, -0x1.30e69c419c5ddp-15, -0x1.c7bde3d5dfc41p-18, 0x1.998f604726ba7p-18,
     -0x1.41a8c15bee148p-19, 0x1.1efe646b9bba6p-21, 0x1.ff93560423f58p-25},
     /* [36] 4.4375 <= y <= 4.5625, degree 10, 59.8 bits */
    {0x1.b9bb3f8p-3, -0x1.39f0037870f83p-30, -0x1.795ed6d7720f9p-5, 0x1.3a43c6928081bp-7, -0x1.eebb81a383c08p-10,
     0x1.577b1c4423934p-12, -0x1.4ce30767ca3bp-15, -0x1.438068b4cedddp-19, 0x1.0d413e126ec4bp-18,
     -0x1.e004406c7b3cfp-20, 0x1.1762d88f39fcfp-21, -0x1.061aa56b98be3p-24},
     /* [37] 4.5625 <= y <= 4.6875, degree 10, 62.6 bits */
    {0x1.ae3cf58p-3, -0x1.5db068a419d45p-31, -0x1.666edd0307b96p-5, 0x1.240e0a91c4946p-7, -0x1.c570701b3bcbbp-10,
     0x1.3d23ad164db65p-12, -0x1.5284a321b9b0fp-15, 0x1.ad584ea1d6a62p-22, 0x1.4f841c76e0288p-19,
     -0x1.511d22734f27cp-20, 0x1.c2835272decfdp-22, -0x1.85aa68186d083p-24},
     /* [38] 4.6875 <= y <= 4.8125, degree 10, 59.7 bits */
    {0x1.a350c68p-3, -0x1.66d6a77f477e8p-30, -0x1.54d32c55023d9p-5, 0x1.0fb409caf4341p-7, -0x1.9f70c79b6bd21p-10,
     0x1.22f2fe92f9191p-12, -0x1.4a2bead8cbceap-15, 0x1.1a1daf41f23c8p-19, 0x1.87941ef861127p-20,
     -0x1.c6c9e1d71f944p-21, 0x1.4b9fbccb1f7ffp-22, -0x1.64f2d02ab8a7ep-24},
     /* [39] 4.8125 <= y <= 4.9375, degree 10, 61.9 bits */
    {0x1.98ec838p-3, -0x1.e7229e4f2d712p-32, -0x1.446f43c8cd4ddp-5, 0x1.fa1d2c5b7fefdp-8, -0x1.7ca8dd358246dp-10,
     0x1.09c2fd0ddde7ep-12, -0x1.39a28885c12f4p-15, 0x1.99f056819dc5bp-19, 0x1.9baed6d4e82dcp-21,
     -0x1.29820d0115f4bp-21, 0x1.d002a7f0f5c65p-23, -0x1.16554fba2548dp-24},
     /* [40] 4.9375 <= y <= 5.0625, degree 10, 66.1 bits */
    {0x1.8f06d88p-3, -0x1.30881ed26af1cp-32, -0x1.35290ade3cc73p-5, 0x1.d7efedaa0a95bp-8, -0x1.5cf0259f6bb8ep-10,
     0x1.e41c603c0975ep-13, -0x1.24c3d8a117fefp-15, 0x1.d7ca2511d2e1ep-19, 0x1.57a60972c2c38p-22,
     -0x1.7a628eb323121p-22, 0x1.3add96828e277p-23, -0x1.91df95daf523dp-25},
     /* [41] 5.0625 <= y <= 5.1875, degree 10, 59.6 bits */
    {0x1.8597388p-3, 0x1.9699dd2adf2e3p-31, -0x1.26e8b3cc1ebdep-5, 0x1.b89947c943bbfp-8, -0x1.4012f8118317dp-10,
     0x1.b820dfa26f463p-13, -0x1.0e0eac63976c7p-15, 0x1.eb9bf3bf83783p-19, 0x1.57b146a3a490dp-25,
     -0x1.d1b197fc75d94p-23, 0x1.a2f0e5fff3c08p-24, -0x1.167211b2899adp-25},
     /* [42] 5.1875 <= y <= 5.3125, degree 10, 61.9 bits */
    {0x1.7c95cdp-3, -0x1.7dcd0e0610e92p-30, -0x1.1998952609e81p-5, 0x1.9bd7463d5d409p-8, -0x1.25d8e25fc9193p-10,
     0x1.8fbb21970f731p-13, -0x1.ee2856bd37345p-16, 0x1.e583707fbd26cp-19, -0x1.14e6ac9382a6ep-23,
     -0x1.1172862f6702p-23, 0x1.1295f6e7a21bdp-24, -0x1.793a173da457ep-26},
     /* [43] 5.3125 <= y <= 5.4375, degree 10, 64.6 bits */
    {0x1.73fb638p-3, -0x1.440eeec9e0d9ep-30, -0x1.0d24ffc5d38f3p-5, 0x1.816d4f109e036p-8, -0x1.0e08a4416effbp-10,
     0x1.6ae15efbe734fp-13, -0x1.c18dca29cca45p-16, 0x1.d028facf8fd2bp-19, -0x1.e33850ae9fb15p-23,
     -0x1.2888f19864511p-24, 0x1.62df535bdcb63p-25, -0x1.f89939824e14ep-27},
     /* [44] 5.4375 <= y <= 5.5625, degree 10, 59.6 bits */
    {0x1.6bc1608p-3, 0x1.4da0ea6da025fp-32, -0x1.017c140187568p-5, 0x1.692416aba5b97p-8, -0x1.f0d531f78d063p-11,
     0x1.496ca1a39df93p-13, -0x1.97627ec876a64p-16, 0x1.b27ecca99f56p-19, -0x1.26299502449c2p-22,
     -0x1.0ff4284e64bedp-25, 0x1.c2d8e0684f129p-26, -0x1.4ede2c02471e3p-27},
     /* [45] 5.5625 <= y <= 5.6875, degree 10, 59.5 bits */
    {0x1.63e1b1p-3, 0x1.e8a33cf3c6e91p-32, -0x1.ed1b300b574a4p-6, 0x1.52c967075c6b9p-8, -0x1.c99431f3a34c7p-11,
     0x1.2b25fb2aefe18p-13, -0x1.703467d632b42p-16, 0x1.90fa47f9a78f7p-19, -0x1.3a8a55d4219c2p-22,
     -0x1.186155b9dbe8fp-27, 0x1.1786e076acb5bp-26, -0x1.b9c24e267cc9ep-28},
     /* [46] 5.6875 <= y <= 5.8125, degree 10, 62.4 bits */
    {0x1.5c56bd8p-3, -0x1.c145412be2b1cp-30, -0x1.d895a0c59284dp-6, 0x1.3e2fce548801dp-8, -0x1.a5ec609b0203ap-11,
     0x1.0fcf0238b22d3p-13, -0x1.4c3ba904e67cfp-16, 0x1.6e69abc5f8e73p-19, -0x1.3af252a761588p-22,
     0x1.a8960b6779cfap-28, 0x1.4db7751a061cp-27, -0x1.2173d99b81c92p-28},
     /* [47] 5.8125 <= y <= 5.9375, degree 10, 64.5 bits */
    {0x1.551b5ep-3, -0x1.9a3ffe53f49f3p-32, -0x1.c54cb6b5e1fdcp-6, 0x1.2b2e42073a0aep-8, -0x1.8583d06e88e6cp-11,
     0x1.ee4e570194febp-14, -0x1.2b7b110c862fep-16, 0x1.4c83e732586a2p-19, -0x1.2f68a2b101e19p-22,
     0x1.f2a944cf57be2p-27, 0x1.754ced5c6bd3bp-28, -0x1.77e1c8cdf4d84p-29},
     /* [48] 5.9375 <= y <= 6.0625, degree 10, 60.4 bits */
    {0x1.4e2ad2p-3, -0x1.719e760bc2744p-31, -0x1.b3281e51e48c7p-6, 0x1.199fbe6d7bf93p-8, -0x1.680899bb2d55ep-11,
     0x1.c1de1f59f652cp-14, -0x1.0dd57973b19bap-16, 0x1.2c48c755e926ep-19, -0x1.1d2afbed4f56p-22, 0x1.4582e34c759a9p-26,
     0x1.6ed99b2d1fb3fp-29, -0x1.e18ff1f9f9a92p-30}, /* [49] 6.0625 <= y <= 6.1875, degree 10, 62.4 bits */
    {0x1.4780b5p-3, -0x1.4dbe4786ebe4bp-30, -0x1.a211b68e7459ep-6, 0x1.0962e7d0c0bc7p-8, -0x1.4d30949bd69e7p-11,
     0x1.99d4a9db6b504p-14, -0x1.e637787fc0d07p-17, 0x1.0e4117efb0abfp-19, -0x1.079be97d1e68bp-22,
     0x1.66bed4c97e343p-26, 0x1.f6ead32689c0fp-31, -0x1.2e23a5371e731p-30},
     /* [50] 6.1875 <= y <= 6.3125, degree 10, 61.0 bits */
    {0x1.4118f7p-3, -0x1.a87acbe6f864ep-31, -0x1.91f5593a69024p-6, 0x1.f4b3601f233dap-9, -0x1.34b8e4f72f099p-11,
     0x1.75c16c2abe192p-14, -0x1.b62b72601de2fp-17, 0x1.e552a2de90c51p-20, -0x1.e1c410891abb2p-23,
     0x1.6d022fb5445dep-26, -0x1.77a5695af0272p-33, -0x1.6edd1aaa0a0cap-31},
     /* [51] 6.3125 <= y <= 6.4375, degree 10, 61.3 bits */
    {0x1.3aefd5p-3, 0x1.c15af715995b1p-30, -0x1.82c0a8d0c717cp-6, 0x1.d8d204885c564p-9, -0x1.1e656f5e0aaa8p-11,
     0x1.553cf0bd2f2a8p-14, -0x1.8b10246358c4fp-17, 0x1.b31be22a06334p-20, -0x1.b4a4f38e11eep-23, 0x1.62df0c3499af4p-26,
     -0x1.c021765e03e7dp-31, -0x1.a57eef3c8c734p-32}, /* [52] 6.4375 <= y <= 6.5625, degree 10, 60.4 bits */
    {0x1.3501d3p-3, 0x1.06802c37b9433p-30, -0x1.7462e35aeabd6p-6, 0x1.bef0ea5eed27ep-9, -0x1.0a00455c10329p-11,
     0x1.37e90b7e4b68ep-14, -0x1.646f749a8d5cbp-17, 0x1.85bc7587afd89p-20, -0x1.89703bda4329bp-23,
     0x1.4f4940a44784ap-26, -0x1.41bd6ea8553ffp-30, -0x1.b45625895572p-33},
     /* [53] 6.5625 <= y <= 6.6875, degree 10, 61.0 bits */
    {0x1.2f4bb4p-3, 0x1.b18b08ed68f5cp-33, -0x1.66ccb9f479264p-6, 0x1.a6e40928115d8p-9, -0x1.eeb2248e3a163p-12,
     0x1.1d709ee15d0c3p-14, -0x1.41d82917ddf3bp-17, 0x1.5cf11ff2a78bfp-20, -0x1.61068957296c8p-23,
     0x1.36c84e8b5fff9p-26, -0x1.70043da26d745p-30, -0x1.5eea3d2498a73p-34},
     /* [54] 6.6875 <= y <= 6.8125, degree 10, 60.3 bits */
    {0x1.29ca76p-3, -0x1.c04ee6b605a3ep-31, -0x1.59f02c830a001p-6, 0x1.9083a2b08a57cp-9, -0x1.cc891be9b671p-12,
     0x1.0587204cd0bdep-14, -0x1.22e0436ea4c08p-17, 0x1.3864f53d5afb6p-20, -0x1.3bd33ab6ff3bcp-23,
     0x1.1c448ce753c5bp-26, -0x1.7da47ed5fa90ep-30, -0x1.7d6d994e09dfdp-38},
     /* [55] 6.8125 <= y <= 6.9375, degree 10, 60.3 bits */
    {0x1.247b4c8p-3, -0x1.a07ac66edcb6ep-30, -0x1.4dc06937c08f6p-6, 0x1.7babd028e5e1p-9, -0x1.ad37f0b4f01e8p-12,
     0x1.dfcff4f1d9957p-15, -0x1.072623d0bf839p-17, 0x1.17bbaf2bd4a48p-20, -0x1.19f722a1bedc2p-23,
     0x1.0191163d7e198p-26, -0x1.771cfb151523cp-30, 0x1.5b9f48a0e3ffep-35}
     /* [56] 6.9375 <= y <= 7.0625, degree 10, 61.9 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_loss_zero_overlap)

/* (1 - eps)/beta at zero force, beta < 16: 65 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 4.03125.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. */
#define COR_ROWS_LOSS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_LOSS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_LOSS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_LOSS_ZERO_FORCE_ROWS 65
#define COR_ROWS_LOSS_ZERO_FORCE_PLAIN_ROWS 4
#define COR_ROWS_LOSS_ZERO_FORCE_END 16.0
COR_ROWS(double, cor_rows_loss_zero_force, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.27486c8p+0, 0x1.1905c1608e8f4p-27, 0x1.3406fcabdfbd3p-71, -0x1.98b665097f1f8p-1, -0x1.11111111110d3p-2,
     0x1.0bb743932a102p-1, 0x1.d873e10a0f39ep-2, -0x1.651ccf1ee8d49p-2, -0x1.cf3472382461p-2, 0x1.2ba859a162c11p-3,
     0x1.7bb79de2d42d6p-2, -0x1.5efcf847d2577p-9}, /* [0] 0 <= y <= 0.03125, degree 10, 66.2 bits */
    {0x1.26785ap+0, 0x1.2e0bf135dd50ep-29, -0x1.a34923357fd21p-4, -0x1.ab81ab4d6ed69p-1, -0x1.eaf05f5d72ef5p-4,
     0x1.4932b5765b155p-1, 0x1.2f507577d0592p-2, -0x1.0bd1559f899bbp-1, -0x1.4f87aa0026bd5p-2, 0x1.6507b826d5659p-2,
     0x1.4f9eeb1a6897p-2, -0x1.635678774f432p-3}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 62.2 bits */
    {0x1.23fe0ep+0, -0x1.3f71c208e564ap-28, -0x1.a8f2668e2f64dp-3, -0x1.aefdccaa35b2ap-1, 0x1.9782344fac5dap-5,
     0x1.67acadf8e7c51p-1, 0x1.419d28128b36ap-4, -0x1.3e988c4a6b43ap-1, -0x1.d211703e9d607p-4, 0x1.f662b710c68fbp-2,
     0x1.3ec21c8daf91ep-3, -0x1.7408ccc95caeap-2}, /* [2] 0.09375 <= y <= 0.15625, degree 10, 64.4 bits */
    {0x1.1fd62a8p+0, -0x1.df1d288d41d59p-29, -0x1.3eeb5e64c1c1bp-2, -0x1.a1c2f50e2f85cp-1, 0x1.cd8a84bde3aa5p-3,
     0x1.6158f56813ce5p-1, -0x1.420a36d68319p-3, -0x1.3b9ad60fa055ap-1, 0x1.22db44bea6da1p-3, 0x1.0466cde12a979p-1,
     -0x1.91eabd6d36cfp-4, -0x1.ae79034e04b05p-2}, /* [3] 0.15625 <= y <= 0.21875, degree 10, 62.2 bits */
    {0x1.1a0de4p+0, 0x1.f553c03c3c0c4p-28, -0x1.a3fb2c3a53bc5p-1, 0x1.fde76cf030628p-4, 0x1.0eb37f09475a2p-1,
     0x1.3f150f4c73fe6p-3, -0x1.0d41327b2ea42p+0, 0x1.197f16f32a6dep+0, -0x1.7531f406b28cep+0, 0x1.d7758e877ea8cp+1,
     -0x1.036abba94ce24p+3, 0x1.f39b1658e945bp+3}, /* [4] 0.21875 <= y <= 0.28125, degree 10, 59.2 bits */
    {0x1.12c2b68p+0, 0x1.70cd184d5ae85p-27, -0x1.996a1bf8b149p-1, 0x1.a284b400ef7f3p-3, 0x1.05b21e96918fep-1,
     -0x1.2dbc4fc00ac4ep-4, -0x1.70674fc3f9607p-1, 0x1.5332e18738ea3p-1, -0x1.f84ab05a6031p-3, 0x1.4a46ed312c731p-1,
     -0x1.c252bb562f9p+0, 0x1.5c2f24d413175p+1}, /* [5] 0.28125 <= y <= 0.34375, degree 10, 62.4 bits */
    {0x1.0a20718p+0, -0x1.fa96d949bee92p-28, -0x1.8a0b19d0bc51fp-1, 0x1.188b64e7c8b98p-2, 0x1.d64a4cb5dde61p-2,
     -0x1.d36f2cf4c4e57p-3, -0x1.f4a817ce13b15p-2, 0x1.1a8dd731c1b8dp-1, -0x1.2ec640a46f8afp-5, -0x1.25b4c80da4e6dp-4,
     -0x1.cb1510e4d84b7p-2, 0x1.ae5db86466b62p-1}, /* [6] 0.34375 <= y <= 0.40625, degree 10, 62.0 bits */
    {0x1.005de88p+0, 0x1.84fdaf4ac8605p-28, -0x1.76a2baa4c667p-1, 0x1.51ffd1c412fcep-2, 0x1.8a6c7c02aacd8p-2,
     -0x1.4b451db80533bp-2, -0x1.2e8f426e62c5dp-2, 0x1.f9c9ea1867f2p-2, -0x1.339a0347a40a5p-4, -0x1.d9ca6b758c2f4p-3,
     -0x1.e81c8c5af1d28p-7, 0x1.814aba36eeb88p-2}, /* [7] 0.40625 <= y <= 0.46875, degree 10, 61.1 bits */
    {0x1.eb71a3p-1, 0x1.dbcc915697307p-29, -0x1.601eaf20934bfp-1, 0x1.7bd6b541d9ea8p-2, 0x1.330abb35f1603p-2,
     -0x1.791c85978b691p-2, -0x1.0d6c3add455cbp-3, 0x1.af6aedd7ec1d5p-2, -0x1.40d6f118b4ba2p-3, -0x1.9c091332b905fp-3,
     0x1.428f9fe26e9afp-3, 0x1.2cd4c604b6099p-3}, /* [8] 0.46875 <= y <= 0.53125, degree 10, 60.6 bits */
    {0x1.d4e2c98p-1, -0x1.15074a399b049p-30, -0x1.477cb7684d4cap-1, 0x1.95d13407b2bd1p-2, 0x1.b3c7eea23f9dp-3,
     -0x1.7cf9936a855acp-2, -0x1.0e5409c25b27p-9, 0x1.4f69a24b360a1p-2, -0x1.b432f4f2d0309p-3, -0x1.b870442aaa906p-4,
     0x1.96e0909325398p-3, -0x1.b3ed89263d0eep-9}, /* [9] 0.53125 <= y <= 0.59375, degree 10, 61.0 bits */
    {0x1.bd8cb08p-1, -0x1.1f5c7e6fcffb4p-32, -0x1.2db3a8a7e7a95p-1, 0x1.a0fd9eae647aep-2, 0x1.0d10495bed592p-3,
     -0x1.621a4f5640947p-2, 0x1.6e399a8210c7fp-4, 0x1.cddb264f4137dp-3, -0x1.d070651d7f559p-3, -0x1.94d9e6c613d74p-7,
     0x1.542b4bf79a837p-3, -0x1.5cc99b65cd206p-4}, /* [10] 0.59375 <= y <= 0.65625, degree 10, 59.2 bits */
    {0x1.a5e33a8p-1, 0x1.bb60bdad709dcp-29, -0x1.13a17fd94dfd5p-1, 0x1.9f5709c718819p-2, 0x1.eff485f3b1a22p-5,
     -0x1.33f7472dcc965p-2, 0x1.274f0f5584616p-3, 0x1.0b3004f826ec4p-3, -0x1.a2c5456fe239ep-3, 0x1.c43b7a015c74p-5,
     0x1.a89e4a3181d61p-4, -0x1.b72676ae128f6p-4}, /* [11] 0.65625 <= y <= 0.71875, degree 10, 61.1 bits */
    {0x1.8e4c31p-1, 0x1.e66c5fe45ec78p-28, -0x1.f3ffd349567a8p-2, 0x1.935b1ff7d9b86p-2, 0x1.6e3c62ebe2266p-9,
     -0x1.f9835b70db5eap-3, 0x1.57fbb9fc817ebp-3, 0x1.b22bb230ce0a5p-5, -0x1.4a556f7aada74p-3, 0x1.69da58bbab3f8p-4,
     0x1.5bbeb068c223ep-5, -0x1.738dff39057e1p-4}, /* [12] 0.71875 <= y <= 0.78125, degree 10, 59.9 bits */
    {0x1.771cb98p-1, -0x1.c683964eb3c1ap-30, -0x1.c2be5715183fbp-2, 0x1.7faaefb07def6p-2, -0x1.527742b05fc47p-5,
     -0x1.88ccefb71fc9cp-3, 0x1.596c6e2b08a3cp-3, -0x1.53b9695d272dcp-9, -0x1.cb5eeb8f0005p-4, 0x1.7df50918026e2p-4,
     -0x1.dbf528dc47cb4p-10, -0x1.e2d0534fe4846p-5}, /* [13] 0.78125 <= y <= 0.84375, degree 10, 59.5 bits */
    {0x1.6098908p-1, -0x1.bd48fab6262b2p-28, -0x1.944ca33067c47p-2, 0x1.66c2cd218ec2bp-2, -0x1.2995f1e392ebfp-4,
     -0x1.207da02301311p-3, 0x1.3c60a70760411p-3, -0x1.307946ba7fd3dp-5, -0x1.144a9bf3a452ap-4, 0x1.4af7d665dd3e7p-4,
     -0x1.aa007b2915a68p-6, -0x1.d05ceecce0f53p-6}, /* [14] 0.84375 <= y <= 0.90625, degree 10, 58.8 bits */
    {0x1.4af2a9p-1, -0x1.4db2f0252f20fp-29, -0x1.692e11c028d5bp-2, 0x1.4accd4482efe8p-2, -0x1.7c92c95fe509bp-4,
     -0x1.8d22a02c90881p-4, 0x1.0f369eca66004p-3, -0x1.beff6c7d1a7p-5, -0x1.0958409ae7266p-5, 0x1.f45ea663a17e6p-5,
     -0x1.1735c8fcd5171p-5, -0x1.a6f2bd7fcbbfbp-8}, /* [15] 0.90625 <= y <= 0.96875, degree 10, 58.5 bits */
    {0x1.364eba8p-1, -0x1.1c40f39ec9273p-28, -0x1.41a716c2155c5p-2, 0x1.2d8b6ffcd7f06p-2, -0x1.aaa29da0ad18bp-4,
     -0x1.f54b69588e308p-5, 0x1.b94f5caa23ebp-4, -0x1.e88a6ef34faa2p-5, -0x1.08bbb0b8df611p-7, 0x1.500c662a582fap-5,
     -0x1.07c7005fbfc33p-5, 0x1.7a3ed8a2d6152p-8}, /* [16] 0.96875 <= y <= 1.03125, degree 10, 58.2 bits */
    {0x1.22c3538p-1, 0x1.ffb63955ef461p-30, -0x1.1dca918c91c75p-2, 0x1.105623bb90518p-2, -0x1.bc4a05181aebdp-4,
     -0x1.12201b3845edbp-5, 0x1.576f21a75770dp-4, -0x1.d263af8760168p-5, 0x1.bb0ddfbc5a521p-8, 0x1.8d5fb037a83a1p-6,
     -0x1.a59417ed5716dp-6, 0x1.5a48c6babfaeep-7}, /* [17] 1.03125 <= y <= 1.09375, degree 10, 59.6 bits */
    {0x1.105c21p-1, 0x1.a88ffa511b2a5p-28, -0x1.fb0d6edd8ff72p-3, 0x1.e8444d33baba4p-3, -0x1.b9454867cc905p-4,
     -0x1.a7dafe4e1ff07p-7, 0x1.009f2cf442f52p-4, -0x1.9a2ed225c8eddp-5, 0x1.d7535dd84353fp-7, 0x1.87732985ecd48p-7,
     -0x1.2b4d2ddc8523ap-6, 0x1.63fcde31a281dp-7}, /* [18] 1.09375 <= y <= 1.15625, degree 10, 59.7 bits */
    {0x1.fe38518p-2, -0x1.8315d6e6a0748p-29, -0x1.c160f5158dbbfp-3, 0x1.b3226485d8eecp-3, -0x1.a81bf6c7ce78fp-4,
     0x1.95ace55d1b8aep-10, 0x1.705714c99b841p-5, -0x1.54b838a04a146p-5, 0x1.18511495d462fp-6, 0x1.f7a4c9011c425p-9,
     -0x1.7f16b2c7495bp-7, 0x1.28782d0393966p-7}, /* [19] 1.15625 <= y <= 1.21875, degree 10, 60.6 bits */
    {0x1.ddffa4p-2, -0x1.9243b8bf94a3p-32, -0x1.8e19d9ffc084fp-3, 0x1.8204be2e36b7p-3, -0x1.8e032c337901dp-4,
     0x1.6f4c9bdff4a74p-7, 0x1.f9d16ead66d1dp-6, -0x1.0efb8bf29cc9ep-5, 0x1.145f5f856674fp-6, -0x1.e4e834195afa7p-11,
     -0x1.b5e2a7c32465fp-8, 0x1.b33ca36b8333ep-8}, /* [20] 1.21875 <= y <= 1.28125, degree 10, 58.8 bits */
    {0x1.bffd5a8p-2, 0x1.da180f1153f26p-30, -0x1.60b119e82f484p-3, 0x1.5544cb817cd54p-3, -0x1.6eeff44b0832ap-4,
     0x1.199293c3ce243p-6, 0x1.48d430e69092fp-6, -0x1.a007449b7a8ecp-6, 0x1.edee4b923256p-7, -0x1.b513b3dcb5cb3p-9,
     -0x1.a97c2c8e2d5d9p-9, 0x1.2220f192e635p-8}, /* [21] 1.28125 <= y <= 1.34375, degree 10, 58.6 bits */
    {0x1.a419d98p-2, -0x1.ab25ce11d40f1p-29, -0x1.38994cdc6af32p-3, 0x1.2cf3b2386e966p-3, -0x1.4dc23192e1268p-4,
     0x1.4f172d6e0f4a5p-6, 0x1.8b525de3f4931p-7, -0x1.35a580ae0bdadp-6, 0x1.9ead660169f72p-7, -0x1.15640126002b2p-8,
     -0x1.1feafbdae502dp-10, 0x1.61b11c74a4616p-9}, /* [22] 1.34375 <= y <= 1.40625, degree 10, 58.9 bits */
    {0x1.8a3929p-2, -0x1.7037c095216ffp-29, -0x1.15462d68b5e73p-3, 0x1.08f1945ad6849p-3, -0x1.2c780b35f78e6p-4,
     0x1.65295ba71964ep-6, 0x1.9e2dd3dc60bfep-8, -0x1.bfcffde7be227p-7, 0x1.4d20805da3f1fp-7, -0x1.16c6cd8e014b1p-8,
     0x1.e7c24696e82bep-14, 0x1.85150d5ffafadp-10}, /* [23] 1.40625 <= y <= 1.46875, degree 10, 58.3 bits */
    {0x1.723cd28p-2, 0x1.1c06fa9e44b55p-30, -0x1.ec6314e2ac265p-4, 0x1.d1ff49efcf85cp-4, -0x1.0c604f6fa0d46p-4,
     0x1.65dd6125d38f3p-6, 0x1.32099d477e026p-9, -0x1.3a7643a273209p-7, 0x1.02c9ee58e3275p-7, -0x1.f5ec8f0976ac6p-9,
     0x1.75ccfb532a0d3p-11, 0x1.6ed18fa810122p-11}, /* [24] 1.46875 <= y <= 1.53125, degree 10, 59.8 bits */
    {0x1.5c05498p-2, 0x1.52ca06610b68bp-33, -0x1.b5bc858c1e58ap-4, 0x1.999b2cc2d5318p-4, -0x1.dc8dcf5624bcap-5,
     0x1.58c5030bab47cp-6, -0x1.5398e64b82f15p-12, -0x1.ab76e2235bd52p-8, 0x1.875277c022c75p-8, -0x1.a724ef74cc4e1p-9,
     0x1.e8f7b7abc1b27p-11, 0x1.e53b47398ee93p-13}, /* [25] 1.53125 <= y <= 1.59375, degree 10, 61.7 bits */
    {0x1.4772f4p-2, 0x1.716762248d90dp-32, -0x1.85b3a5ebf9ea2p-4, 0x1.680656a834399p-4, -0x1.a5330f9d03e9ep-5,
     0x1.4362adfa354b3p-6, -0x1.0778a6508d2bfp-9, -0x1.170f1065f5c12p-8, 0x1.210fa363178dfp-8, -0x1.554e25829b238p-9,
     0x1.ededc3eb1fc0dp-11, -0x1.89bcea253de91p-16}, /* [26] 1.59375 <= y <= 1.65625, degree 10, 59.6 bits */
    {0x1.3466e9p-2, -0x1.4d3df4ccba596p-31, -0x1.5b79c7a7bdbf8p-4, 0x1.3c8d794b3814dp-4, -0x1.7309110c99cdep-5,
     0x1.299a5caf1fb4bp-6, -0x1.896c83e4e5a5ep-9, -0x1.587ba14834b59p-9, 0x1.a20edeadf4a22p-9, -0x1.0a92e6e5dd6b5p-9,
     0x1.bcbb7ef6dd8a2p-11, -0x1.2ea4a08840b18p-13}, /* [27] 1.65625 <= y <= 1.71875, degree 10, 62.4 bits */
    {0x1.22c3708p-2, -0x1.e76a65ba70a6cp-31, -0x1.36565ddad589cp-4, 0x1.1682e36cf0affp-4, -0x1.46118339edb26p-5,
     0x1.0e1526aa84b37p-6, -0x1.cc03592bc719ap-9, -0x1.84735d6c4d9dcp-10, 0x1.28102790606f5p-9, -0x1.962e7fd607404p-10,
     0x1.76c9d278a6212p-11, -0x1.87ae461af5f35p-13}, /* [28] 1.71875 <= y <= 1.78125, degree 10, 58.3 bits */
    {0x1.126c568p-2, -0x1.0f887ff6a9648p-29, -0x1.15a5f09ace66ep-4, 0x1.ea872c909a237p-5, -0x1.1e17238763b9ap-5,
     0x1.e527160ac957cp-7, -0x1.e3cd348acc0ecp-9, -0x1.6c9a3b771738p-11, 0x1.9a2377f54e736p-10, -0x1.2f3f707acf9f8p-10,
     0x1.2e72186aa9645p-11, -0x1.8852481acb726p-13}, /* [29] 1.78125 <= y <= 1.84375, degree 10, 58.5 bits */
    {0x1.03471ap-2, 0x1.5e156f0eeb098p-29, -0x1.f1b12c00950ccp-5, 0x1.b073f9b6aed96p-5, -0x1.f589274500805p-6,
     0x1.b05d0101f9eedp-7, -0x1.dfb7282a8c15bp-9, -0x1.680b0216c50dcp-13, 0x1.14e5cc9a92315p-10, -0x1.bcfe7d52d994ep-11,
     0x1.d95a604d1a1c1p-12, -0x1.5f14258d81c11p-13}, /* [30] 1.84375 <= y <= 1.90625, degree 10, 59.1 bits */
    {0x1.ea760ap-3, 0x1.190700fe0abcp-32, -0x1.bee05f9baa70ap-5, 0x1.7dbe0ce690edep-5, -0x1.b7684a97e22c8p-6,
     0x1.7f12717bc4859p-7, -0x1.ca5d9065f9a43p-9, 0x1.57d021b50afebp-13, 0x1.69fab91180c29p-11, -0x1.416060fefa409p-11,
     0x1.69f5f5e91e1cfp-12, -0x1.26aab6cf34826p-13}, /* [31] 1.90625 <= y <= 1.96875, degree 10, 60.6 bits */
    {0x1.d0625b8p-3, -0x1.5a766ece0b98ap-31, -0x1.91fd2fcc1a20bp-5, 0x1.5174669d8bec5p-5, -0x1.80f4db6d76e4fp-6,
     0x1.51ec638104e9bp-7, -0x1.ab231486b8064p-9, 0x1.8121b9869bff8p-12, 0x1.c45c056777927p-12, -0x1.c9234846f91d9p-12,
     0x1.0fca4d09284fdp-12, -0x1.da8e6227e9e11p-14}, /* [32] 1.96875 <= y <= 2.03125, degree 10, 59.7 bits */
    {0x1.b828df8p-3, 0x1.96f7ba8b4c6cep-30, -0x1.6a47ad0f5ec35p-5, 0x1.2ac1f3b8d5badp-5, -0x1.515a262233f5ap-6,
     0x1.29246ca595256p-7, -0x1.870d7011e03aep-9, 0x1.f6b8dc28f0d8dp-12, 0x1.07643faeb7a0bp-12, -0x1.3ffcf6a55acap-12,
     0x1.92160d126a0f6p-13, -0x1.7336a37579902p-14}, /* [33] 2.03125 <= y <= 2.09375, degree 10, 61.5 bits */
    {0x1.a1a2b5p-3, 0x1.e9a2667aa4bb6p-33, -0x1.4718e4f5fd027p-5, 0x1.08eb9868d505p-5, -0x1.27cde0b27d0bap-6,
     0x1.04af488f2f0c9p-7, -0x1.616f01623b9bfp-9, 0x1.15ed025f8962fp-11, 0x1.0cf3998280497p-13, -0x1.b8130f4cb901ap-13,
     0x1.2596675aa4bcdp-13, -0x1.1c38a12a62cacp-14}, /* [34] 2.09375 <= y <= 2.15625, degree 10, 58.7 bits */
    {0x1.8cac33p-3, 0x1.5a406bcbad8e3p-31, -0x1.27dfc7d5b9ee6p-5, 0x1.d69bb9bf1660bp-6, -0x1.0394c6c23a00dp-6,
     0x1.c8afa894412f6p-8, -0x1.3c660a09ccbe4p-9, 0x1.1b602c9b23d9dp-11, 0x1.84e973172925ep-15, -0x1.283719796b34fp-13,
     0x1.a7b0014263218p-14, -0x1.ac17b85393ae1p-15}, /* [35] 2.15625 <= y <= 2.21875, degree 10, 58.8 bits */
    {0x1.7924b78p-3, 0x1.b00216fb35affp-32, -0x1.0c1e5b5240d2bp-5, 0x1.a2b4f75343d7ap-6, -0x1.c8097db565e04p-7,
     0x1.8fa31c7d280edp-8, -0x1.193a6c8995425p-9, 0x1.13856e2add71cp-11, -0x1.b262ded8c2e5ap-18, -0x1.83e3624a0f3bap-14,
     0x1.2e3dace5358bbp-14, -0x1.3e2465f759f6ap-15}, /* [36] 2.21875 <= y <= 2.28125, degree 10, 63.7 bits */
    {0x1.66ee7p-3, -0x1.63d757964faecp-30, -0x1.e6ce759b4ebcap-6, 0x1.752bf403aaab9p-6, -0x1.910acae087177p-7,
     0x1.5d89f3dad22ep-8, -0x1.f14349b7eb544p-10, 0x1.03c3e62eb02fcp-11, -0x1.4779a35c7c055p-15, -0x1.e89aa0a696af3p-15,
     0x1.aa2944e77903dp-15, -0x1.d3a3e0d80d27bp-16}, /* [37] 2.28125 <= y <= 2.34375, degree 10, 59.6 bits */
    {0x1.55ee22p-3, 0x1.c3593b4bcf0ep-30, -0x1.bab6c5bd8b573p-6, 0x1.4d2ac41c5b27fp-6, -0x1.611f3070fddd5p-7,
     0x1.31af5e1a2c9cdp-8, -0x1.b5debe4f223dp-10, 0x1.df8eb6ebf87c5p-12, -0x1.e3d4f00005d04p-15, -0x1.21cdc7e4a90bdp-15,
     0x1.2895ccb278d7ap-15, -0x1.545ff7e7b270fp-16}, /* [38] 2.34375 <= y <= 2.40625, degree 10, 59.1 bits */
    {0x1.460af88p-3, -0x1.6828c8623ab08p-30, -0x1.935085557697dp-6, 0x1.29f857bee9c23p-6, -0x1.3758d7f99687dp-7,
     0x1.0b62c6ce63fa9p-8, -0x1.806f76d42fcc4p-10, 0x1.b400ff665f2d8p-12, -0x1.18b31037be1e9p-14,
     -0x1.34d8251c5e037p-16, 0x1.96a0279f525bbp-16, -0x1.eb177d1e642b7p-17},
     /* [39] 2.40625 <= y <= 2.46875, degree 10, 61.9 bits */
    {0x1.372e4b8p-3, 0x1.9baafd80d7b41p-33, -0x1.700c19c29f428p-6, 0x1.0af4b5776201bp-6, -0x1.12e7a8988007ap-7,
     0x1.d3fb89ae75c12p-9, -0x1.50ce43eeb261ap-10, 0x1.880580f3b16b8p-12, -0x1.2588af12b80fep-14,
     -0x1.006e728e682eap-17, 0x1.119163d2ce252p-16, -0x1.5f393656df998p-17},
     /* [40] 2.46875 <= y <= 2.53125, degree 10, 59.3 bits */
    {0x1.2943748p-3, -0x1.27e0da40147ebp-30, -0x1.506c83764db3dp-6, 0x1.df2b3e4e94753p-7, -0x1.e62caf45ac271p-8,
     0x1.99ce800a11e78p-9, -0x1.26a52ce5e7872p-10, 0x1.5d903ed26e0d3p-12, -0x1.21d2308665aep-14, -0x1.5fd4a82b8e1e7p-21,
     0x1.67194a2db83f2p-17, -0x1.f1f08d4c636efp-18}, /* [41] 2.53125 <= y <= 2.59375, degree 10, 59.2 bits */
    {0x1.1c379dp-3, 0x1.14843871e2d5dp-33, -0x1.3404d6dc1f077p-6, 0x1.aec73ab9c228ap-7, -0x1.ae8eeba82fc88p-8,
     0x1.672983c11bdf5p-9, -0x1.018568867ce08p-10, 0x1.35c384bfba8b1p-12, -0x1.140dd3505f0a9p-14, 0x1.f0e8ab2d5ffddp-19,
     0x1.c72ca5c36d2d5p-18, -0x1.5d933793ba1dap-18}, /* [42] 2.59375 <= y <= 2.65625, degree 10, 59.3 bits */
    {0x1.0ff997p-3, 0x1.e53fdffa779b5p-30, -0x1.1a760dcd00ddep-6, 0x1.83eed3f6478bep-7, -0x1.7de53974f3576p-8,
     0x1.3b1537927e685p-9, -0x1.c1eba78dbb364p-11, 0x1.1134c13e7b5ccp-12, -0x1.00a6ea6ca7e92p-14, 0x1.a3b516513543ep-18,
     0x1.1161ac4aced99p-18, -0x1.e56799b1dcbb1p-19}, /* [43] 2.65625 <= y <= 2.71875, degree 10, 59.1 bits */
    {0x1.0479b58p-3, -0x1.e5a6ddcac9515p-33, -0x1.036d262aa1087p-6, 0x1.5def630e9ada4p-7, -0x1.5343a089cb13cp-8,
     0x1.14b6ae5788dffp-9, -0x1.88f85f7fc580cp-11, 0x1.e039b7301fefep-13, -0x1.d522fc093907ap-15, 0x1.fd0ca8fee4df4p-18,
     0x1.2b0e646744bd6p-19, -0x1.4c7f3019d37d1p-19}, /* [44] 2.71875 <= y <= 2.78125, degree 10, 59.2 bits */
    {0x1.f3534e8p-4, 0x1.bfcbcbca39802p-31, -0x1.dd4306c26ec08p-7, 0x1.3c2e43d9cd58ap-7, -0x1.2dde3bd40fbd4p-8,
     0x1.e69afa936a728p-10, -0x1.57459369d0891p-11, 0x1.a4f39195e505ep-13, -0x1.a7756637db9a2p-15,
     0x1.1013baa2e3c28p-17, 0x1.0ac2a28baaa23p-20, -0x1.bfc5887a0d2e5p-20},
     /* [45] 2.78125 <= y <= 2.84375, degree 10, 59.3 bits */
    {0x1.def8b28p-4, 0x1.e3321da57932p-32, -0x1.b7a71365367f1p-7, 0x1.1e257b5739ecap-7, -0x1.0d04f8632ba52p-8,
     0x1.ac62d10f9801fp-10, -0x1.2bf76ba7d5fcap-11, 0x1.704b34f56139ap-13, -0x1.7ab2c13587b27p-15,
     0x1.102cac1f57fd7p-17, 0x1.94c493c22a3a2p-23, -0x1.26aa0aac4d5fcp-20},
     /* [46] 2.84375 <= y <= 2.90625, degree 10, 60.5 bits */
    {0x1.cbcbaep-4, -0x1.3362eff7c296cp-35, -0x1.9596d68f7f4fbp-7, 0x1.0360d5c97dd95p-7, -0x1.e03fa52d87908p-9,
     0x1.799fda895d259p-10, -0x1.0644d9e76a415p-11, 0x1.41cc36f1a707cp-13, -0x1.504ed803a928bp-15,
     0x1.057f328ecdb4fp-17, -0x1.55d00fda5899ap-22, -0x1.77634a5222229p-21},
     /* [47] 2.90625 <= y <= 2.96875, degree 10, 59.2 bits */
    {0x1.b9b661p-4, 0x1.a81dc05ca2776p-31, -0x1.76b04017f1d2dp-7, 0x1.d6f6d9ce61f2p-8, -0x1.ad5713f30f663p-9,
     0x1.4d53a74ebbe1ep-10, -0x1.caf178a348005p-12, 0x1.18ee63fb31abap-13, -0x1.2914aa7bc8cb1p-15, 0x1.e935284dfceap-18,
     -0x1.4cd0be14b2c64p-21, -0x1.c6f5f56aa405dp-22}, /* [48] 2.96875 <= y <= 3.03125, degree 10, 61.2 bits */
    {0x1.a8a4c5p-4, 0x1.68073af770f5cp-31, -0x1.5a9d0486f5894p-7, 0x1.ac3b10199584ep-8, -0x1.806d83baa5636p-9,
     0x1.26a1c2658fbd2p-10, -0x1.91e35f8a6fe7cp-12, 0x1.ea46799a533c4p-14, -0x1.055f5294a79bfp-15,
     0x1.c11e01bea6b54p-18, -0x1.a404243f6fbcbp-21, -0x1.fa3b3813664eap-23},
     /* [49] 3.03125 <= y <= 3.09375, degree 10, 59.4 bits */
    {0x1.98847f8p-4, -0x1.7c28604993ff6p-35, -0x1.41111545d5dd9p-7, 0x1.85f593eaa5d46p-8, -0x1.58bf079713609p-9,
     0x1.04cb722edcebcp-10, -0x1.6042316977017p-12, 0x1.abbcdfa71cfe6p-14, -0x1.ca833737de0d7p-16, 0x1.96c07ab2b9dfp-18,
     -0x1.c97fd2b34c5c6p-21, -0x1.d6e0aaae989c7p-24}, /* [50] 3.09375 <= y <= 3.15625, degree 10, 59.6 bits */
    {0x1.8944bbp-4, -0x1.b37cc8ec577ebp-31, -0x1.29c94ed23d3dcp-7, 0x1.63a14211b0277p-8, -0x1.35a2318fc2906p-9,
     0x1.ce57c15d748afp-11, -0x1.35137afbe619bp-12, 0x1.7535cf4c23765p-14, -0x1.9142968c4af8ap-16,
     0x1.6caf1badaee52p-18, -0x1.cebbbfa5b089ep-21, -0x1.cfb093ef1a482p-26},
     /* [51] 3.15625 <= y <= 3.21875, degree 10, 59.0 bits */
    {0x1.7ad603p-4, -0x1.c7c8e31910bcap-34, -0x1.148a553f36d26p-7, 0x1.44c9e178105a3p-8, -0x1.16845db8bdb44p-9,
     0x1.9a695b9c3949ap-11, -0x1.0f7c5bda3e179p-12, 0x1.45bb1bd26494bp-14, -0x1.5e936f26334a6p-16,
     0x1.447bdc707bf68p-18, -0x1.bfd1b5f626bffp-21, 0x1.b4527293448dap-26},
     /* [52] 3.21875 <= y <= 3.28125, degree 10, 58.8 bits */
    {0x1.6d2a25p-4, -0x1.d7bbe9c8d5e4ap-32, -0x1.011f9868808f3p-7, 0x1.2909d78bf1a9ep-8, -0x1.f5cd04afcf3f6p-10,
     0x1.6cd5d04d4e74cp-11, -0x1.dd7c789992285p-13, 0x1.1c6d15ce321cap-14, -0x1.31f07f626dbc6p-16,
     0x1.1f0a71833e0f7p-18, -0x1.a50bb92ba62b3p-21, 0x1.e90b38a7fe5dcp-25},
     /* [53] 3.28125 <= y <= 3.34375, degree 10, 58.7 bits */
    {0x1.603411p-4, 0x1.20c0b7016fb48p-31, -0x1.deb4f4633da0ep-8, 0x1.1008302d1f4c7p-8, -0x1.c4b4e6d0a0c91p-10,
     0x1.44c8cb40407fbp-11, -0x1.a467321afecffp-13, 0x1.f10631a3f2adap-15, -0x1.0ac90149cd1bep-16,
     0x1.f9944059c536cp-19, -0x1.8402a83d2b315p-21, 0x1.3f0a9a21b77c4p-24},
     /* [54] 3.34375 <= y <= 3.40625, degree 10, 59.7 bits */
    {0x1.53e7c2p-4, -0x1.988e4391caf17p-31, -0x1.be2323f8b49adp-8, 0x1.f2edd9e77bcaep-9, -0x1.9901136ed0828p-10,
     0x1.218ae70342898p-11, -0x1.729a00aea1cd1p-13, 0x1.b295cad2ba084p-15, -0x1.d11656bc0e717p-17,
     0x1.bbbc318221a54p-19, -0x1.606bacb36d62ep-21, 0x1.60d4b5efcb31ap-24},
     /* [55] 3.40625 <= y <= 3.46875, degree 10, 62.5 bits */
    {0x1.483a228p-4, 0x1.8c2584962794bp-32, -0x1.a040126cced0dp-8, 0x1.ca2322d5bb9ep-9, -0x1.720b3f6eb6f23p-10,
     0x1.027daa00d5c48p-11, -0x1.471c9d056b26fp-13, 0x1.7c4e8fa11b2cap-15, -0x1.9555485a1ecd8p-17,
     0x1.8472c850b8baep-19, -0x1.3caae61b34fcbp-21, 0x1.6807ea6f37cb4p-24},
     /* [56] 3.46875 <= y <= 3.53125, degree 10, 61.0 bits */
    {0x1.3d20fb8p-4, -0x1.f0a10630b88dbp-34, -0x1.84ca1aefca236p-8, 0x1.a537c6baf9fc9p-9, -0x1.4f42afc7b62d4p-10,
     0x1.ce301d962f527p-12, -0x1.21185fd28d47ap-13, 0x1.4d1cc21003cbap-15, -0x1.61486e471d0eep-17,
     0x1.53640be31a755p-19, -0x1.1a3bb50193016p-21, 0x1.5e76a3d6a2961p-24},
     /* [57] 3.53125 <= y <= 3.59375, degree 10, 60.4 bits */
    {0x1.3292ddp-4, 0x1.61131bfd3cbe5p-31, -0x1.6b86aa5f8104dp-8, 0x1.83c1af460318bp-9, -0x1.302944634720cp-10,
     0x1.9dc70d56fd082p-12, -0x1.ffa7a1a784724p-14, 0x1.240f94600b2cfp-15, -0x1.33ff6954d132p-17, 0x1.281bd91e4ab88p-19,
     -0x1.f3f51ffedef5ep-22, 0x1.4ae187be596d9p-24}, /* [58] 3.59375 <= y <= 3.65625, degree 10, 60.0 bits */
    {0x1.28870f8p-4, 0x1.eda64b4a0f6bcp-31, -0x1.544168961374fp-8, 0x1.656349edba98bp-9, -0x1.1450eee3295adp-10,
     0x1.72f2cdba58c5p-12, -0x1.c55d76a3a02acp-14, 0x1.00556b4e9037ap-15, -0x1.0ca14082b35efp-17, 0x1.021715d7fe2a3p-19,
     -0x1.b8b209b9c3542p-22, 0x1.31dd535ae3d3bp-24}, /* [59] 3.65625 <= y <= 3.71875, degree 10, 59.5 bits */
    {0x1.1ef5828p-4, 0x1.219f000268084p-31, -0x1.3ecb7d475c999p-8, 0x1.49c9eeb7fc514p-9, -0x1.f6b30b584d0eap-11,
     0x1.4d0164ae99c84p-12, -0x1.923d7d5f2128ap-14, 0x1.c2708deca052ep-16, -0x1.d4d87325820dfp-18,
     0x1.c19db580f2b06p-20, -0x1.830443d4e9406p-22, 0x1.16779ebe4cc2cp-24},
     /* [60] 3.71875 <= y <= 3.78125, degree 10, 62.8 bits */
    {0x1.15d6be8p-4, -0x1.3e9c763dc57c9p-32, -0x1.2afaeca8a4c9p-8, 0x1.30ac7ebb0e3f9p-9, -0x1.c9ddcb9ae8038p-11,
     0x1.2b58672dab2b6p-12, -0x1.65589fba9f7b7p-14, 0x1.8c34d56ac6c04p-16, -0x1.99698e6c31401p-18,
     0x1.877ee6815173bp-20, -0x1.52e78a3f9a87fp-22, 0x1.f5593557bf9c5p-25},
     /* [61] 3.78125 <= y <= 3.84375, degree 10, 61.3 bits */
    {0x1.0d23d78p-4, 0x1.c8e4c8464696p-31, -0x1.18aa08a867688p-8, 0x1.19ca326025903p-9, -0x1.a18eb098e0755p-11,
     0x1.0d71b6a9a0e4fp-12, -0x1.3de03ff4743c9p-14, 0x1.5ce6a02b97f1dp-16, -0x1.65c7e8396f251p-18,
     0x1.54d90b26af13cp-20, -0x1.282015ab6203ep-22, 0x1.bf75da261d79ap-25},
     /* [62] 3.84375 <= y <= 3.90625, degree 10, 59.8 bits */
    {0x1.04d6638p-4, 0x1.3d917124341ffp-38, -0x1.07b6f3f1e7ffep-8, 0x1.04e9909bcbfep-9, -0x1.7d4462112fcf2p-11,
     0x1.e5b169ecce2efp-13, -0x1.1b21b9411831fp-14, 0x1.3399d163d672fp-16, -0x1.38eb1ec0eb671p-18,
     0x1.28c6a18c04137p-20, -0x1.025257d920e7cp-22, 0x1.8cbe64804e7cap-25},
     /* [63] 3.90625 <= y <= 3.96875, degree 10, 60.1 bits */
    {0x1.f9d0d88p-5, 0x1.a957e038c0804p-32, -0x1.f00668b98cf84p-9, 0x1.e3af12a3925b6p-10, -0x1.5c8d3db74d2d1p-11,
     0x1.b64fbbbee1a45p-13, -0x1.f904fbf1313bdp-15, 0x1.0f825c1451823p-16, -0x1.11ec8d43b93b8p-18,
     0x1.02774d5f0b314p-20, -0x1.c225c9b459823p-23, 0x1.5dfc0b73a5508p-25}
     /* [64] 3.96875 <= y <= 4.03125, degree 10, 61.7 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_loss_zero_force)

/* duration at zero overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-58.2 at most, proved for the whole cell of each row. */
#define COR_ROWS_DURATION_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_DURATION_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_DURATION_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_DURATION_ZERO_OVERLAP_ROWS 65
#define COR_ROWS_DURATION_ZERO_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_duration_zero_overlap, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be991a8f0b41p+1, 0x1.5d0edcf22037ep-54, 0x1.7c188c46208fdp-2, 0x1.ad809e048caedp-3, 0x1.7c28e9570753cp-8,
     0x1.bb639ac79891p-6, -0x1.f4c900748189ap-8, 0x1.a3ed55e2c4e63p-8, -0x1.cfe5bf73ac343p-9, 0x1.2a1cfe11b6bb4p-9,
     -0x1.748fb24a610d9p-10, 0x1.8d5558c79eab7p-11}, /* [0] 0 <= y <= 0.0625, degree 10, 62.4 bits */
    {0x1.a245e8b491ffp+1, 0x1.b9bf70776c5abp-56, 0x1.b2452b18536c2p-2, 0x1.b6e43ec8543c1p-3, 0x1.2cd5b8e018956p-6,
     0x1.8256f124d6b75p-6, -0x1.f046acdccd3eap-9, 0x1.0d5895f7538a4p-8, -0x1.f1a42217d5abbp-10, 0x1.2d232b0d7693p-10,
     -0x1.60f3691aa01f7p-11, 0x1.9be2bd6daebdep-12}, /* [1] 0.0625 <= y <= 0.1875, degree 10, 60.7 bits */
    {0x1.a97e12b8f592dp+1, -0x1.40f187079bc7p-55, 0x1.ea32974d4b11ep-2, 0x1.c965d29c63195p-3, 0x1.e6b48ef2b357dp-6,
     0x1.698202e9ebd68p-6, -0x1.3f957144485d9p-10, 0x1.76abefc24ccf2p-9, -0x1.1399b8f111e53p-10, 0x1.3e6c9cbead97ep-11,
     -0x1.617a45a66bd44p-12, 0x1.6fce0ef60414p-13}, /* [2] 0.1875 <= y <= 0.3125, degree 10, 60.8 bits */
    {0x1.b19b4a36258c4p+1, 0x1.ab10b4a77c89p-53, 0x1.127ca368390d8p-1, 0x1.e46b7e15dd4dp-3, 0x1.4d049a2495aaap-5,
     0x1.66f969c8162p-6, 0x1.4e034876bf2ccp-11, 0x1.1ab535ccf2566p-9, -0x1.3a0d836204c7ap-11, 0x1.55354fb55b382p-12,
     -0x1.84696b0d0e4adp-13, 0x1.4e53f740b2d31p-14}, /* [3] 0.3125 <= y <= 0.4375, degree 10, 61.6 bits */
    {0x1.baab115426f57p+1, -0x1.72552c7cc15f4p-53, 0x1.31d3b52d04c8p-1, 0x1.03f1a9de2893fp-2, 0x1.a83ab8eaadbc3p-5,
     0x1.75309f4a96a77p-6, 0x1.11c327277762ap-9, 0x1.ca4e5b0d8d328p-10, -0x1.7bc3f2552283ap-12, 0x1.51252c9117dffp-13,
     -0x1.edd046c38d5c9p-14, 0x1.16e95adf3ce7dp-15}, /* [4] 0.4375 <= y <= 0.5625, degree 10, 61.4 bits */
    {0x1.c4bf2784ddd16p+1, -0x1.1a8eec854e315p-54, 0x1.53a7c979ece0cp-1, 0x1.1a10843341aecp-2, 0x1.045e41e89a943p-4,
     0x1.90ec66287d4c4p-6, 0x1.afe8f2feb42d1p-9, 0x1.84fb0251a8f64p-10, -0x1.122eb6fecf799p-12, 0x1.7a004067ac8b3p-15,
     -0x1.88fdf993ca699p-14, 0x1.e9dda042e9e25p-18}, /* [5] 0.5625 <= y <= 0.6875, degree 10, 59.9 bits */
    {0x1.cfedb28d341f3p+1, 0x1.f65b20e4b2a66p-56, 0x1.788a060554c77p-1, 0x1.34e4fdb786412p-2, 0x1.38d22e023a277p-4,
     0x1.b8140a1743db5p-6, 0x1.1b67010a0a667p-8, 0x1.4a317f34f48c6p-10, -0x1.197f37a27587dp-12, -0x1.f2e42719236fcp-15,
     -0x1.92ab364897ff2p-14, -0x1.53a1d893576bbp-17}, /* [6] 0.6875 <= y <= 0.8125, degree 10, 60.4 bits */
    {0x1.dc5190ace3a8ap+1, -0x1.46cbd29953aap-53, 0x1.a1181adf7a383p-1, 0x1.54e41d9bad1b3p-2, 0x1.72ca3d05e3a0dp-4,
     0x1.e8df8945a4861p-6, 0x1.52ea2d594ebb1p-8, 0x1.017ed05eda5c9p-10, -0x1.93cc8db7b8646p-12, -0x1.74f0669d02586p-13,
     -0x1.ec78e6af98c8fp-14, -0x1.8c2f2cf14262p-16}, /* [7] 0.8125 <= y <= 0.9375, degree 10, 61.5 bits */
    {0x1.ea0acd321d6fep+1, -0x1.fee0afde506aep-54, 0x1.ce003563ab48bp-1, 0x1.7a9fbc5a9a58ep-2, 0x1.b359e41224c47p-4,
     0x1.108e4c4ad774fp-5, 0x1.7963d731a6e64p-8, 0x1.1ec0244b9445p-11, -0x1.4cfae73200fe9p-11, -0x1.58f62b579fe41p-12,
     -0x1.41bd804b34969p-13, -0x1.157035d42ad52p-15}, /* [8] 0.9375 <= y <= 1.0625, degree 10, 61.0 bits */
    {0x1.f93f31c3b86p+1, -0x1.fb2ec979218cap-53, 0x1.00021a160d146p+0, 0x1.a6bfb8fd02396p-2, 0x1.fb3d0256263dp-4,
     0x1.2eaecb0a48048p-5, 0x1.83ee58fbfe104p-8, -0x1.78b2dd60036c3p-13, -0x1.1571f81173c78p-10, -0x1.13978067fe7f1p-11,
     -0x1.9b9fc24ebbba1p-13, -0x1.16369585c5394p-15}, /* [9] 1.0625 <= y <= 1.1875, degree 10, 59.5 bits */
    {0x1.050d76b150fb1p+2, -0x1.618d2d8236acdp-53, 0x1.1bfde67f122c1p+0, 0x1.d9f76e8b8c7b7p-2, 0x1.255057a72905dp-3,
     0x1.4bf8ebf475fddp-5, 0x1.6029dd05ed34ep-8, -0x1.66feff01d9334p-10, -0x1.be0943d4c800dp-10, -0x1.91e30d40ba05fp-11,
     -0x1.dc30749177063p-13, -0x1.698451d41a79ap-17}, /* [10] 1.1875 <= y <= 1.3125, degree 10, 59.8 bits */
    {0x1.0e68a32af571fp+2, -0x1.7a8531235d5bap-53, 0x1.3b6a7e81e34d9p+0, 0x1.0a7a26c2c3ab5p-1, 0x1.5063448109558p-3,
     0x1.63c9d5da77112p-5, 0x1.e49ded1802f6cp-9, -0x1.a77e07f721d07p-9, -0x1.5433611d0d5e3p-9, -0x1.0abb670d967d5p-10,
     -0x1.ab8939962b74dp-13, 0x1.e80a8ba73eda3p-15}, /* [11] 1.3125 <= y <= 1.4375, degree 10, 59.9 bits */
    {0x1.18cea2a338f2dp+2, 0x1.040eeb4f57ffp-52, 0x1.5ec8d56f4832fp+0, 0x1.2c20d26c96ba6p-1, 0x1.7dbca3db2accep-3,
     0x1.6ee9d241c16f9p-5, 0x1.404820f3e918p-12, -0x1.87af2f63487ebp-8, -0x1.e5f35455985bcp-9, -0x1.34ba03e4f03a3p-10,
     -0x1.9006b4be3150dp-15, 0x1.b4519235e525dp-13}, /* [12] 1.4375 <= y <= 1.5625, degree 10, 61.0 bits */
    {0x1.24611e7741391p+2, -0x1.cc8b62b3e604ap-53, 0x1.86a06b786fb15p+0, 0x1.520e7654c6e0cp-1, 0x1.ab26d284b689dp-3,
     0x1.62c2d44a02441p-5, -0x1.69e3bc9256529p-8, -0x1.3ede4680d5a75p-7, -0x1.3dea749182e4cp-8, -0x1.0ec60154e72ebp-10,
     0x1.7c63751088cf9p-12, 0x1.e91b5cc7a996ep-12}, /* [13] 1.5625 <= y <= 1.6875, degree 10, 61.9 bits */
    {0x1.314601227a2b8p+2, -0x1.8fd053541ac26p-56, 0x1.b3788f73c9c3cp+0, 0x1.7c1b03e4e5de3p-1, 0x1.d4dcf06ad403bp-3,
     0x1.30f552bcf52d7p-5, -0x1.db7612c24cc12p-7, -0x1.d5ee822b386d9p-7, -0x1.6be23991fd5dfp-8, -0x1.d01f3afc5cd51p-13,
     0x1.2f078f6df173bp-10, 0x1.a66c00eeaf8dfp-11}, /* [14] 1.6875 <= y <= 1.8125, degree 10, 60.3 bits */
    {0x1.3fa74a996a3b9p+2, 0x1.77d93ea2ae30bp-52, 0x1.e5ccf2f88bd06p+0, 0x1.a9acab7f68fdp-1, 0x1.f51863e70d527p-3,
     0x1.901169a2541abp-6, -0x1.bb8302451f85ep-6, -0x1.38523fb1801a7p-6, -0x1.424eb511233a9p-8, 0x1.c0db8ac5582c8p-10,
     0x1.31b9d2d8eb1bdp-9, 0x1.0d7947ba56bf7p-10}, /* [15] 1.8125 <= y <= 1.9375, degree 10, 60.2 bits */
    {0x1.4fb27222166bp+2, 0x1.5d7f15635c8ecp-55, 0x1.0efe234214d44p+1, 0x1.d9842cdbd46cep-1, 0x1.01eab89a54e86p-2,
     0x1.666f99da4209cp-9, -0x1.5de8e6bdcf969p-5, -0x1.6b6e30d84acb3p-6, -0x1.b2afa0c3ad6b9p-10, 0x1.49812812beedep-8,
     0x1.c87f5b2dbb91cp-9, 0x1.5b2a667181bc6p-11}, /* [16] 1.9375 <= y <= 2.0625, degree 10, 58.4 bits */
    {0x1.619722bc4ad49p+2, 0x1.cf0c2c1caa55bp-53, 0x1.2e1821b547288p+1, 0x1.04c4ddec3be6ap+0, 0x1.f72e9b5887aebp-3,
     -0x1.ddfc098d1642cp-6, -0x1.e53d0a54565dap-5, -0x1.55689ea1a1e06p-6, 0x1.634d1d1e0c219p-8, 0x1.2b6250d2c8f7ap-7,
     0x1.c694dd7677eep-9, -0x1.e6e81c246cbf5p-11}, /* [17] 2.0625 <= y <= 2.1875, degree 10, 60.5 bits */
    {0x1.758520a94d1cep+2, -0x1.324841c17f3dp-54, 0x1.50202b6e9e1f5p+1, 0x1.1b57487bdd94p+0, 0x1.c4d0bb5c7b571p-3,
     -0x1.20ede863148eap-4, -0x1.26db6b556fc54p-4, -0x1.7c122905049b1p-7, 0x1.089789b1e7246p-6, 0x1.8229391b6dbccp-7,
     0x1.369ecd7b31d44p-11, -0x1.f3a432427c8dcp-9}, /* [18] 2.1875 <= y <= 2.3125, degree 10, 60.4 bits */
    {0x1.8ba93c52ce9a4p+2, 0x1.38738701b609cp-53, 0x1.74c9b3355ac9bp+1, 0x1.2e8181f2f771ap+0, 0x1.64f174338c0c2p-3,
     -0x1.df01e74ae2901p-4, -0x1.2f902cda8abccp-4, 0x1.ef94e41856d98p-8, 0x1.bdd53321f3f6p-6, 0x1.2aa5ccd50ecd8p-7,
     -0x1.817aa56db495p-8, -0x1.954466cf9de33p-8}, /* [19] 2.3125 <= y <= 2.4375, degree 10, 59.1 bits */
    {0x1.a4296bbe5c7b1p+2, -0x1.d0fbe5df8ac77p-53, 0x1.9b84c37cc7792p+1, 0x1.3c127707b962bp+0, 0x1.ad2af70106f55p-4,
     -0x1.46aa5731f467ep-3, -0x1.e13a98e50813p-5, 0x1.17274079cf71ep-5, 0x1.02a1a2c8e3d6fp-5, -0x1.d0875344b2bf1p-10,
     -0x1.abda9d89d2139p-7, -0x1.18d12366d76ap-8}, /* [20] 2.4375 <= y <= 2.5625, degree 10, 59.4 bits */
    {0x1.bf207a848d9dfp+2, 0x1.c1546590c0c65p-53, 0x1.c37d0ef1d0325p+1, 0x1.420bc2a29af3bp+0, 0x1.1dbb9c304d1bfp-6,
     -0x1.7d406856dbf7cp-3, -0x1.8030d99c170aep-6, 0x1.e0381b37fcdf7p-5, 0x1.652a8b7a5567p-6, -0x1.263bb80512405p-6,
     -0x1.c817544bb1215p-7, 0x1.e77358bc6770ep-9}, /* [21] 2.5625 <= y <= 2.6875, degree 10, 59.0 bits */
    {0x1.dc9a256d892bap+2, 0x1.2ebe0b31f9c7ep-52, 0x1.eba916fb5812cp+1, 0x1.3f316f0dd4c02p+0, -0x1.3ad3932132f09p-4,
     -0x1.7cce94ff3e6e8p-3, 0x1.9ec733215b11p-6, 0x1.15da3b67f3af4p-4, -0x1.5294a47a23cd6p-9, -0x1.d8318aa3c0511p-6,
     -0x1.c4aa1e9dc906ap-9, 0x1.91804a79eed9ap-7}, /* [22] 2.6875 <= y <= 2.8125, degree 10, 60.4 bits */
    {0x1.fc90b88e15b84p+2, 0x1.68d852328074fp-52, 0x1.097582cfb4082p+2, 0x1.338a6d5bde21dp+0, -0x1.4e6f85de1fdd6p-3,
     -0x1.3d37e4628d091p-3, 0x1.27aae51242f76p-4, 0x1.b2a7d1c1f9371p-5, -0x1.f098507a00688p-6, -0x1.81cb27c6c2a15p-6,
     0x1.9e712e915e4a5p-7, 0x1.760511afa075dp-7}, /* [23] 2.8125 <= y <= 2.9375, degree 10, 58.2 bits */
    {0x1.0f7692808fd62p+3, 0x1.86538f8ac510ep-51, 0x1.1c1e82ecfe4a5p+2, 0x1.208d40c589705p+0, -0x1.d24deb7b9776ep-3,
     -0x1.989c156b7df64p-4, 0x1.994b0484dd243p-4, 0x1.34427ff902b63p-6, -0x1.6d1ebaeeaf1d5p-5, -0x1.c78650a399c6p-9,
     0x1.4f56c3007ac5p-6, 0x1.3cbdc89fdf001p-14}, /* [24] 2.9375 <= y <= 3.0625, degree 10, 58.3 bits */
    {0x1.21c4f020acb33p+3, -0x1.5d482474eeb88p-51, 0x1.2d6dbdf0d56e5p+2, 0x1.08cf3b6ef28ddp+0, -0x1.0be091aaefecfp-2,
     -0x1.2649fd7b75ff6p-5, 0x1.98283bc46a3e4p-4, -0x1.2e6f0af0b4577p-6, -0x1.30c1c0291070bp-5, 0x1.13989653152d4p-6,
     0x1.b291196d06da5p-7, -0x1.52cb47f300843p-7}, /* [25] 3.0625 <= y <= 3.1875, degree 10, 58.2 bits */
    {0x1.351bf7e86e067p+3, 0x1.4d87eb8e6aee6p-53, 0x1.3d2f1c38aef51p+2, 0x1.de9e4c70ad045p-1, -0x1.0f5b7c704d4c3p-2,
     0x1.44ab593f4a626p-6, 0x1.36508965b9e5cp-4, -0x1.58667c95db434p-5, -0x1.fd0d9ca5f1604p-7, 0x1.861ce5b1daa84p-6,
     -0x1.b95a338890e04p-11, -0x1.55bad0ff9da3p-7}, /* [26] 3.1875 <= y <= 3.3125, degree 10, 58.6 bits */
    {0x1.496262766d793p+3, 0x1.c47093fda8d7ap-51, 0x1.4b5c759372c1bp+2, 0x1.ad5d6fd54236fp-1, -0x1.f5bbac84541d2p-3,
     0x1.d00d58121a8aep-5, 0x1.5516378d5984dp-5, -0x1.777ccc7330732p-5, 0x1.74eb3a10bcc1ap-8, 0x1.15df1a4a628cap-6,
     -0x1.3eb411634073ap-7, -0x1.b479e72dc69dfp-9}, /* [27] 3.3125 <= y <= 3.4375, degree 10, 58.4 bits */
    {0x1.5e7fb503592dap+3, -0x1.c267a57475adcp-51, 0x1.58132dc3c4246p+2, 0x1.81613399bd065p-1, -0x1.b1eae1d5dd70bp-3,
     0x1.293b7890de85fp-4, 0x1.5d77927d38f7bp-7, -0x1.1fd710d61df8ep-5, 0x1.131f43ea03c43p-6, 0x1.5940a6b5f3b24p-8,
     -0x1.3e38932ff8ac2p-7, 0x1.5e3148b6bd4c7p-9}, /* [28] 3.4375 <= y <= 3.5625, degree 10, 58.6 bits */
    {0x1.745e01e95b5a9p+3, -0x1.b794284b0b4bdp-51, 0x1.6384e6b7d9192p+2, 0x1.5c3ac73a6d58ep-1, -0x1.66b38a6a73a98p-3,
     0x1.27bb0f2947e03p-4, -0x1.43a151b0b804bp-7, -0x1.4099c5886ab22p-6, 0x1.1cb87a4723a21p-6, -0x1.a299ddc522dedp-9,
     -0x1.48bd0bf2f45f6p-8, 0x1.0eaab60c23366p-8}, /* [29] 3.5625 <= y <= 3.6875, degree 10, 58.9 bits */
    {0x1.8aeab5d164d1dp+3, -0x1.61276fea21832p-51, 0x1.6de937c071f8ep+2, 0x1.3defde0c76c72p-1, -0x1.213454c85c6bp-3,
     0x1.003d09d69e712p-4, -0x1.3c964946c4786p-6, -0x1.a20896b69e1f2p-8, 0x1.92599aa231027p-7, -0x1.9460c72bdfc2p-8,
     -0x1.3dee8414d8a69p-11, 0x1.5fd2227f89096p-9}, /* [30] 3.6875 <= y <= 3.8125, degree 10, 60.6 bits */
    {0x1.a216a19d32085p+3, 0x1.9cbd0b0eb7f4fp-52, 0x1.7773de6aec32bp+2, 0x1.25a017ba58463p-1, -0x1.cf4a60a3601d6p-4,
     0x1.974e4037f17d7p-5, -0x1.540455b263d18p-6, 0x1.b9f6ceb6edfc3p-10, 0x1.9c337014718a7p-8, -0x1.623316d30737ap-8,
     0x1.983164d380229p-10, 0x1.c0a007de37123p-11}, /* [31] 3.8125 <= y <= 3.9375, degree 10, 59.5 bits */
    {0x1.b9d5906533f8cp+3, -0x1.a62f08010c5dep-52, 0x1.804ff618e84a7p+2, 0x1.1217b3ea61426p-1, -0x1.764ab095a47a5p-4,
     0x1.331b4c42c157cp-5, -0x1.264dafdefc588p-6, 0x1.4f00eb0f0e201p-8, 0x1.eefd3ac6a131bp-10, -0x1.b6644acd9b7e9p-9,
     0x1.e99f64c1d0b6dp-10, -0x1.bd18ffbbbab7ep-13}, /* [32] 3.9375 <= y <= 4.0625, degree 10, 59.0 bits */
    {0x1.d21db17f4dd69p+3, -0x1.d90a2e2801ed5p-56, 0x1.889efa428b12ep+2, 0x1.022d723fa052bp-1, -0x1.3425fc648999ep-4,
     0x1.c331f3520934p-6, -0x1.c4daeabd024e9p-7, 0x1.6e7170573737fp-8, -0x1.fa2e9cda63976p-12, -0x1.88ae4d6f52eep-10,
     0x1.61183c1794f32p-10, -0x1.1361f2bfbd8adp-11}, /* [33] 4.0625 <= y <= 4.1875, degree 10, 60.0 bits */
    {0x1.eae7059c75238p+3, -0x1.aa1f6fd65549fp-51, 0x1.9079e28efd584p+2, 0x1.e9da9daccde72p-2, -0x1.03b9945c9fa5fp-4,
     0x1.4a445b353a2dep-6, -0x1.44c5e0ecef709p-7, 0x1.34872756689d8p-8, -0x1.60c8c084d37p-10, -0x1.6c3fab7df41f8p-12,
     0x1.77d4f1b334ce9p-11, -0x1.d50aca5094105p-12}, /* [34] 4.1875 <= y <= 4.3125, degree 10, 60.3 bits */
    {0x1.0215728c47fdbp+4, -0x1.0385e1ca047edp-51, 0x1.97f2ff799e76p+2, 0x1.d34228bd9819dp-2, -0x1.c0291229cf984p-5,
     0x1.ea939b0f69b57p-7, -0x1.c058f55ee2b65p-8, 0x1.c768993b9c38ap-9, -0x1.6b21cadb7f12ap-10, 0x1.82a787c81a639p-13,
     0x1.19d60156f1729p-12, -0x1.191c3486def4ep-12}, /* [35] 4.3125 <= y <= 4.4375, degree 10, 60.6 bits */
    {0x1.0ef1d240daa52p+4, 0x1.3b15e9145b474p-51, 0x1.9f17ce53d1adep+2, 0x1.bf903f8b21acbp-2, -0x1.8a93bd61eba3p-5,
     0x1.762e025844abcp-7, -0x1.319e09b35d147p-8, 0x1.3749d1d5159b5p-9, -0x1.2146a4bbb41ffp-10, 0x1.5f444582cb961p-12,
     0x1.0b48f6f8e2e5dp-15, -0x1.fa534211ebe6bp-14}, /* [36] 4.4375 <= y <= 4.5625, degree 10, 62.8 bits */
    {0x1.1c0629daf69cp+4, 0x1.b2c5a961e3169p-50, 0x1.a5f2717a933cbp+2, 0x1.ae142f7346d0ap-2, -0x1.6116160a659b8p-5,
     0x1.26a17a93c4edap-7, -0x1.a4674262f4fc9p-9, 0x1.97e1b6ce1bcd1p-10, -0x1.955f1c795e2afp-11, 0x1.43dfc2e7a07d2p-12,
     -0x1.f068cf9504e65p-15, -0x1.218439ee63c5fp-15}, /* [37] 4.5625 <= y <= 4.6875, degree 10, 59.1 bits */
    {0x1.29504898b9302p+4, -0x1.a344337040223p-52, 0x1.ac8abf78b9f13p+2, 0x1.9e5512c4d9509p-2, -0x1.3fea3d0948984p-5,
     0x1.dea685738c85ap-8, -0x1.2889f6cf7e973p-9, 0x1.0711b6bdab837p-10, -0x1.07b1f686d4045p-11, 0x1.e0063a012b9adp-13,
     -0x1.38acbbf37cbfcp-14, 0x1.ffd747726f202p-19}, /* [38] 4.6875 <= y <= 4.8125, degree 10, 60.0 bits */
    {0x1.36ce35b8316dep+4, -0x1.82f051f5911dcp-50, 0x1.b2e6fa43ba39bp+2, 0x1.8ffee38419998p-2, -0x1.249b360c55d68p-5,
     0x1.8f6182a49f5f5p-8, -0x1.b1105f39e179cp-10, 0x1.55aebb7ed8067p-11, -0x1.49700ab6c9e6dp-12, 0x1.3d58764fe9aebp-13,
     -0x1.fef646c1e330bp-15, 0x1.f851c28c257ccp-17}, /* [39] 4.8125 <= y <= 4.9375, degree 10, 61.2 bits */
    {0x1.447e25d43420ap+4, 0x1.d4adf5f13babdp-51, 0x1.b90c46f7de64bp+2, 0x1.82d57fe5e0b1p-2, -0x1.0d922f82011bp-5,
     0x1.5478e965547e6p-8, -0x1.48142b8f45756p-10, 0x1.c6df9191c0a98p-12, -0x1.95d12a7167489p-13, 0x1.88b65ae0eac7ap-14,
     -0x1.5ea505679d9ccp-15, 0x1.e6110740882eap-17}, /* [40] 4.9375 <= y <= 5.0625, degree 10, 60.3 bits */
    {0x1.525e734a0996fp+4, -0x1.1db96f2b4d3fcp-50, 0x1.befefb672b6e1p+2, 0x1.76ac4d8874d7ep-2, -0x1.f388b27b847f2p-6,
     0x1.2719f13e99e75p-8, -0x1.010f2633f1ca5p-10, 0x1.39d5dbeca18bdp-12, -0x1.f81efba0eb9dp-14, 0x1.d56f8894910b2p-15,
     -0x1.b520ab3963e75p-16, 0x1.61c11fa000eeep-17}, /* [41] 5.0625 <= y <= 5.1875, degree 10, 59.8 bits */
    {0x1.606d9898615efp+4, -0x1.0daf996351678p-51, 0x1.c4c2d0f43946fp+2, 0x1.6b61028a909dp-2, -0x1.d0fb01331aa37p-6,
     0x1.030d1cbbfa9d2p-8, -0x1.9e4725581cf32p-11, 0x1.c28d8021fc8cdp-13, -0x1.4172a72c07007p-14, 0x1.1607b5c56f596p-15,
     -0x1.01cc3fbd4b105p-16, 0x1.c1fa299508d23p-18}, /* [42] 5.1875 <= y <= 5.3125, degree 10, 63.1 bits */
    {0x1.6eaa2c0d959b9p+4, 0x1.8522989190264p-50, 0x1.ca5b06dd5cff4p+2, 0x1.60d86b75a5281p-2, -0x1.b27e8ab9dabadp-6,
     0x1.cb5a153fc46ebp-9, -0x1.554e3e1ea58cap-11, 0x1.4fb3e5a89733p-13, -0x1.a99d2273d04a9p-15, 0x1.4d894d7ca9536p-16,
     -0x1.282e99bdb4d5cp-17, 0x1.08e379db6634cp-18}, /* [43] 5.3125 <= y <= 5.4375, degree 10, 64.0 bits */
    {0x1.7d12dc5be6b8fp+4, -0x1.3b74ba887aef8p-52, 0x1.cfca7a3c0ca5cp+2, 0x1.56fc65202ec5bp-2, -0x1.975b00fcba985p-6,
     0x1.9a86b9a95edd1p-9, -0x1.1e13ce367f9abp-11, 0x1.023043ee07222p-13, -0x1.25a6ddaf1b9b1p-15, 0x1.9c2979f9d84ccp-17,
     -0x1.539cd86ba2e23p-18, 0x1.2acba221b786cp-19}, /* [44] 5.4375 <= y <= 5.5625, degree 10, 62.1 bits */
    {0x1.8ba66dd1a33bbp+4, -0x1.8060c744f3c3ap-55, 0x1.d513b77a3e30dp+2, 0x1.4dba8e00f1008p-2, -0x1.7f052e9f484edp-6,
     0x1.7151fd4136a01p-9, -0x1.e61dc0dc54b18p-12, 0x1.976535b191f0cp-14, -0x1.a54ca07dc9281p-16, 0x1.08fef77af780ap-17,
     -0x1.8cc015568317fp-19, 0x1.4baabd21edbe2p-20}, /* [45] 5.5625 <= y <= 5.6875, degree 10, 60.9 bits */
    {0x1.9a63b80aa4d71p+4, 0x1.946a77225231ap-51, 0x1.da39077b54e85p+2, 0x1.4503657ba116bp-2, -0x1.6910d0497edb2p-6,
     0x1.4e1e1c2f49e28p-9, -0x1.a18cc735536a6p-12, 0x1.47ef3335a36ap-14, -0x1.386f3d713fbfap-16, 0x1.63873f94af18ep-18,
     -0x1.df852af2e1b79p-20, 0x1.72b4e7c97b831p-21}, /* [46] 5.6875 <= y <= 5.8125, degree 10, 62.6 bits */
    {0x1.a949a3fe9d0bdp+4, 0x1.0eb2802b72421p-52, 0x1.df3c79d3f2e17p+2, 0x1.3cc9aec26ca31p-2, -0x1.5527b8e22ddd2p-6,
     0x1.2fbe1919794e4p-9, -0x1.69ea187d8139cp-12, 0x1.0c3762d48f165p-14, -0x1.dc08fcd35214fp-17, 0x1.f01c138056fbbp-19,
     -0x1.2e3ae1afe68b9p-20, 0x1.a92d759493cc3p-22}, /* [47] 5.8125 <= y <= 5.9375, degree 10, 60.2 bits */
    {0x1.b8572a584d35fp+4, -0x1.88b2712b1c7e6p-51, 0x1.e41fece9a1dp+2, 0x1.3501feceb9739p-2, -0x1.43040b355399p-6,
     0x1.1550286d0115ep-9, -0x1.3c1d50a89260fp-12, 0x1.bc78b41f94bb6p-15, -0x1.727e1abb58c19p-17, 0x1.65db4d572da29p-19,
     -0x1.8dacfe9a63d7cp-21, 0x1.fad8eac0ce24p-23}, /* [48] 5.9375 <= y <= 6.0625, degree 10, 61.0 bits */
    {0x1.c78b5207432cdp+4, -0x1.c51352a39852ep-50, 0x1.e8e514875825fp+2, 0x1.2da266ff1045dp-2, -0x1.326c4d4d1360dp-6,
     0x1.fc4d5849980cfp-10, -0x1.15f5ebe757f54p-12, 0x1.744909401bb56p-15, -0x1.255869973ce6ap-17,
     0x1.092e10415b6a5p-19, -0x1.0ff09d4ce1d9ep-21, 0x1.3ba57fa958af5p-23},
     /* [49] 6.0625 <= y <= 6.1875, degree 10, 60.6 bits */
    {0x1.d6e52f0156fa9p+4, -0x1.c25d3e559d25cp-50, 0x1.ed8d7f4667f75p+2, 0x1.26a23387802b1p-2, -0x1.2330a39178a6fp-6,
     0x1.d372fdd490b6dp-10, -0x1.ebb5fd5713fd4p-13, 0x1.3aba7c21c0aa4p-15, -0x1.d7212472c276fp-18,
     0x1.9194c4c381742p-20, -0x1.801fb91266a5bp-22, 0x1.9a2eb4944dc97p-24},
     /* [50] 6.1875 <= y <= 6.3125, degree 10, 60.2 bits */
    {0x1.e663e12ba8e6p+4, 0x1.190e8482fdaf7p-50, 0x1.f21a9b0f177e6p+2, 0x1.1ff9b815f4fbcp-2, -0x1.1528cca665b35p-6,
     0x1.af384fc94b95ep-10, -0x1.b5356d79f4013p-13, 0x1.0c3c282dd317ap-15, -0x1.7ede1b43e140dp-18,
     0x1.3572157ce2056p-20, -0x1.16773c947f416p-22, 0x1.14903d1d32b13p-24},
     /* [51] 6.3125 <= y <= 6.4375, degree 10, 60.9 bits */
    {0x1.f6069364aa7e3p+4, 0x1.e1521094b334bp-52, 0x1.f68db8e1c0cefp+2, 0x1.19a226ef227ap-2, -0x1.08329ffe3b6bep-6,
     0x1.8eee2a050d9a8p-10, -0x1.869783c880891p-13, 0x1.cc8465be54114p-16, -0x1.3a5d73d1980ep-18, 0x1.e3e75904c82c7p-21,
     -0x1.9c54a656cfb02p-23, 0x1.807c52f665abp-25}, /* [52] 6.4375 <= y <= 6.5625, degree 10, 62.1 bits */
    {0x1.02e63d5507baep+5, -0x1.d94bbe5ec9757p-50, 0x1.fae8100ce8124p+2, 0x1.13956ff161c96p-2, -0x1.f861d03fb49d1p-7,
     0x1.72058f00a4701p-10, -0x1.5e7260e709f38p-13, 0x1.8ddf9a67ee16bp-16, -0x1.047965930a846p-18,
     0x1.7f1a8f2a01ffap-21, -0x1.369a38e5e452dp-23, 0x1.11ecc12c412a1p-25},
     /* [53] 6.5625 <= y <= 6.6875, degree 10, 60.2 bits */
    {0x1.0ada6aab40e8cp+5, -0x1.5f77099e64ecfp-49, 0x1.ff2ac0ec045a7p+2, 0x1.0dce25a91d6cdp-2, -0x1.e214fe217b079p-7,
     0x1.58089b23e21f3p-10, -0x1.3ba98571ba8fap-13, 0x1.59c2a18046117p-16, -0x1.b329082518728p-19,
     0x1.329f7554ba055p-21, -0x1.dad3b1c73f8edp-24, 0x1.8e395887e12d5p-26},
     /* [54] 6.6875 <= y <= 6.8125, degree 10, 63.2 bits */
    {0x1.12df7539dc36ep+5, -0x1.ca4042323619cp-50, 0x1.01ab6ba239c4ap+3, 0x1.084767213ca92p-2, -0x1.cd53370e457e1p-7,
     0x1.40954437edd04p-10, -0x1.1d5a9ea1dd639p-13, 0x1.2e1242a7129a5p-16, -0x1.6e2bd0b34bde7p-19,
     0x1.ef98beda38d1fp-22, -0x1.6f8e44a44618ep-24, 0x1.2658d42b6188dp-26},
     /* [55] 6.8125 <= y <= 6.9375, degree 10, 63.4 bits */
    {0x1.1af5048f13a2ap+5, -0x1.068b08ad6f62p-49, 0x1.03b6a628ba59ap+3, 0x1.02fccd7161632p-2, -0x1.b9f6857f8340bp-7,
     0x1.2b595f095fba2p-10, -0x1.02cfbff3735efp-13, 0x1.09300bb257ad4p-16, -0x1.362da0b2eaf78p-19,
     0x1.940654aa82518p-22, -0x1.1fb6326da980ap-24, 0x1.b9691625df8cap-27},
     /* [56] 6.9375 <= y <= 7.0625, degree 10, 65.1 bits */
    {0x1.231ac3fbfca16p+5, -0x1.b5e034b6f9827p-49, 0x1.05b7844647209p+3, 0x1.fbd4b8934414p-3, -0x1.a7ddac88ca632p-7,
     0x1.180f913ed909p-10, -0x1.d6eaa1153bdc2p-14, 0x1.d3b32e34b7e71p-17, -0x1.085a75d167e99p-19, 0x1.4bfdc0e2259f6p-22,
     -0x1.c6f453a5ca8fcp-25, 0x1.4f280bb5f754ep-27}, /* [57] 7.0625 <= y <= 7.1875, degree 10, 61.2 bits */
    {0x1.2b506254b1c64p+5, 0x1.3cb0ba9de0c2bp-54, 0x1.07ae729e90e97p+3, 0x1.f218e9d0423f9p-3, -0x1.96eb6e9227cb2p-7,
     0x1.067cf14338d98p-10, -0x1.ada51e6c46585p-14, 0x1.9e22d2118f51dp-17, -0x1.c520f96ab44cdp-20,
     0x1.12c8a51a0f6f3p-22, -0x1.6afc2676f033ep-25, 0x1.01588cd22246ap-27},
     /* [58] 7.1875 <= y <= 7.3125, degree 10, 59.9 bits */
    {0x1.339591b657e61p+5, 0x1.13f66841f44bdp-49, 0x1.099bd6ebf3467p+3, 0x1.e8bf960ba001bp-3, -0x1.8705f5d0f116cp-7,
     0x1.ecde50ce30416p-11, -0x1.8907de175546dp-14, 0x1.701c8f07eb0d3p-17, -0x1.865e7de7575a4p-20,
     0x1.c9e89d53353f1p-23, -0x1.2404deb0b9455p-25, 0x1.8f390cbe7d219p-28},
     /* [59] 7.3125 <= y <= 7.4375, degree 10, 60.1 bits */
    {0x1.3bea07524d0d7p+5, 0x1.2b330c7457b28p-49, 0x1.0b80109ab59a7p+3, 0x1.dfc2b6c08b8f4p-3, -0x1.781657657074p-7,
     0x1.cf75ef5f470e3p-11, -0x1.686d959125271p-14, 0x1.485e1ac9423ecp-17, -0x1.51eb144988321p-20, 0x1.7fe47c2aa58p-23,
     -0x1.d973cac73af4bp-26, 0x1.3888e9bb8caafp-28}, /* [60] 7.4375 <= y <= 7.5625, degree 10, 59.5 bits */
    {0x1.444d7b3de9881p+5, -0x1.970cbf6e006cap-49, 0x1.0d5b7952c010bp+3, 0x1.d71cc7326ae2p-3, -0x1.6a082bb4457eep-7,
     0x1.b4761093b1db1p-11, -0x1.4b4c28d3489efp-14, 0x1.25e349b379c54p-17, -0x1.25d26df4b7317p-20,
     0x1.43aec17d09672p-23, -0x1.82855c245d476p-26, 0x1.ed846021e0f61p-29},
     /* [61] 7.5625 <= y <= 7.6875, degree 10, 59.6 bits */
    {0x1.4cbfa84650a3fp+5, 0x1.cb820c585dbe4p-49, 0x1.0f2e65723476ep+3, 0x1.cec8b664a9f32p-3, -0x1.5cc937d0520d4p-7,
     0x1.9b9ded2884991p-11, -0x1.312f816f3d971p-14, 0x1.07d88760c8a23p-17, -0x1.008b65f0c859ep-20,
     0x1.125e96244df9ap-23, -0x1.3d9f5582798a1p-26, 0x1.88b95bf751a99p-29},
     /* [62] 7.6875 <= y <= 7.8125, degree 10, 62.1 bits */
    {0x1.55404bc7e0b2bp+5, -0x1.a04baa2f43cafp-50, 0x1.10f9247af41e3p+3, 0x1.c6c1daef28c9cp-3, -0x1.504924b6d781cp-7,
     0x1.84b515ef33f37p-11, -0x1.19b581008f084p-14, 0x1.db212afbfd181p-18, -0x1.c1bcfe89596efp-21,
     0x1.d3731a9c07fd5p-24, -0x1.0699acdd99ddep-26, 0x1.3acdcf8189952p-29},
     /* [63] 7.8125 <= y <= 7.9375, degree 10, 60.9 bits */
    {0x1.5dcf2588e0b8ap+5, 0x1.3a735591cba26p-49, 0x1.12bc0174c89d8p+3, 0x1.bf03e8644d795p-3, -0x1.447941d1cc136p-7,
     0x1.6f8a2dbff6745p-11, -0x1.048acb6a7c091p-14, 0x1.acf964a31ddc5p-18, -0x1.8ba6180391ee8p-21,
     0x1.900db34e2626bp-24, -0x1.b4b299c654acdp-27, 0x1.fc21258a1c44fp-30}
     /* [64] 7.9375 <= y <= 8.0625, degree 10, 65.6 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_duration_zero_overlap)

/* duration at zero force, beta < 8: 46 rows of degree 10 in y = sqrt(beta), nodes 0 + i 0.0625, 0 <= y <= 2.84375.
 * Relative error of the approximation: 2^-60.3 at most, proved for the whole cell of each row. */
#define COR_ROWS_DURATION_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_DURATION_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_DURATION_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_DURATION_ZERO_FORCE_ROWS 46
#define COR_ROWS_DURATION_ZERO_FORCE_END 8.0
COR_ROWS(double, cor_rows_duration_zero_force, 46, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be991a8f0b41p+1, 0x1.5d0edcf204a57p-54, 0x1.04b6ba7815d9dp-74, -0x1.41f3b9dcefb82p-1, 0x1.86708528fa01dp-52,
     0x1.ad809e048b771p-3, 0x1.f9a4ef2dce50fp-36, 0x1.7c28daa01cb1fp-8, -0x1.d41cff2aa27d3p-4, 0x1.bb34f77f69c66p-6,
     0x1.0f33513d288a5p-4, -0x1.8b72b1a2005e3p-7}, /* [0] 0 <= y <= 0.03125, degree 10, 65.8 bits */
    {0x1.9b992f925b5adp+1, 0x1.a5533d7a684d8p-55, -0x1.411cfd30f30b1p-4, -0x1.3f6f9760e68cp-1, 0x1.ad3fbb1878c63p-5,
     0x1.ac460e59a0c28p-3, -0x1.b7759845ce583p-8, -0x1.47105dcedfbdep-5, -0x1.783f14743fdf7p-4, 0x1.f88f5a355efc9p-5,
     0x1.be120b19eb7abp-5, -0x1.e79c5f9299081p-6}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 63.8 bits */
    {0x1.9aa94b2eae937p+1, -0x1.b9979782e9cc6p-54, -0x1.3e99b12ef3ac9p-3, -0x1.37e90117e6147p-1, 0x1.aab418b583b96p-4,
     0x1.a1bb1b8816b86p-3, -0x1.cf3cb625dbb2fp-6, -0x1.286b3ff8d487cp-4, -0x1.bdf4463e93445p-5, 0x1.5edb6a342c5d4p-4,
     0x1.d59a7a0b8f7f8p-6, -0x1.a6f00dc2bdd5ep-5}, /* [2] 0.09375 <= y <= 0.15625, degree 10, 63.4 bits */
    {0x1.991da66f68768p+1, 0x1.869f6d7e8ae3dp-54, -0x1.d7a7109be9d3ep-3, -0x1.2b81877fc3f57p-1, 0x1.3abfbc4c2bdbep-3,
     0x1.8631231b9cd9ap-3, -0x1.e09359c9be629p-5, -0x1.61e6a1bfa9724p-4, -0x1.2d0fa768762ebp-7, 0x1.789ed56715523p-4,
     -0x1.dcc40faaccecp-8, -0x1.edd995dfcfd4bp-5}, /* [3] 0.15625 <= y <= 0.21875, degree 10, 64.4 bits */
    {0x1.96fc719c7feb8p+1, -0x1.66f00f3b8584cp-53, -0x1.34ac520bf88dfp-2, -0x1.1a8c9f5da8a7fp-1, 0x1.96bd5c94c0118p-3,
     0x1.5650d90f22beep-3, -0x1.730dfb6b99c1ap-4, -0x1.4a90395f2affdp-4, 0x1.16d0e31349971p-5, 0x1.3dfd3d6e45f4ep-4,
     -0x1.5a525eb2ac478p-5, -0x1.8b5618a28980ep-5}, /* [4] 0.21875 <= y <= 0.28125, degree 10, 62.1 bits */
    {0x1.944e212f6e7dfp+1, -0x1.933fa7ea49212p-53, -0x1.78c481724e8f7p-2, -0x1.059993a3f47b6p-1, 0x1.e44f47bd133ddp-3,
     0x1.13686d8ae65ep-3, -0x1.df9c11e56b069p-4, -0x1.ddd6a5f6ed1abp-5, 0x1.0cf6f826bf307p-4, 0x1.7fad3150a9cfbp-5,
     -0x1.06197e7b498d6p-4, -0x1.3cc7058ca04a8p-6}, /* [5] 0.28125 <= y <= 0.34375, degree 10, 62.0 bits */
    {0x1.911d2656b60acp+1, -0x1.8353a308a9cf2p-58, -0x1.b7346e5ed2b3ep-2, -0x1.dadf92b164882p-2, 0x1.0fa4c5286452fp-2,
     0x1.8568d81e48b1dp-4, -0x1.1084a81375506p-3, -0x1.a7428dc987288p-6, 0x1.46a635707068bp-4, 0x1.325e933a322dap-7,
     -0x1.0cc0236619b78p-4, 0x1.bb57eac7a952cp-7}, /* [6] 0.34375 <= y <= 0.40625, degree 10, 67.4 bits */
    {0x1.8d758be9441e5p+1, 0x1.42083036b011ap-54, -0x1.ef4bccd11e597p-2, -0x1.a5fedb125173fp-2, 0x1.2292e04f1fcf1p-2,
     0x1.af5f5aded8eccp-5, -0x1.16f2e10ce0e9bp-3, 0x1.201c533b3ca74p-7, 0x1.366537470163dp-4, -0x1.83b7a919fb658p-6,
     -0x1.9310e5ba9b2aap-5, 0x1.2b0c2fd99c604p-5}, /* [7] 0.40625 <= y <= 0.46875, degree 10, 64.3 bits */
    {0x1.89647f4242a7ap+1, -0x1.47efca6bbb528p-53, -0x1.104c94428e07p-1, -0x1.6e960b904bde4p-2, 0x1.2ab0959a9a1fep-2,
     0x1.6fd6f4c216513p-7, -0x1.044d779734f6ap-3, 0x1.3b2b4210302bdp-5, 0x1.dc95e9ae950fbp-5, -0x1.6b14a0215cd87p-5,
     -0x1.81e93f51050bap-6, 0x1.5e32b796147b6p-5}, /* [8] 0.46875 <= y <= 0.53125, degree 10, 64.3 bits */
    {0x1.84f7d001d913dp+1, -0x1.b2a7cd8b7a59dp-53, -0x1.2575b97d3e064p-1, -0x1.369eb76e7c139p-2, 0x1.28b37e8328fd9p-2,
     -0x1.a69244643fe7p-6, -0x1.bc96eb2df0e7cp-4, 0x1.e11bb1b9ede3bp-5, 0x1.15e7df3957d72p-5, -0x1.9c8cff543e843p-5,
     0x1.2b8a27505f4d5p-10, 0x1.19f7bb80a27fbp-5}, /* [9] 0.53125 <= y <= 0.59375, degree 10, 60.8 bits */
    {0x1.803d728846d15p+1, 0x1.5db8a9e695644p-53, -0x1.3726ef05d5944p-1, -0x1.ffbaa02730c95p-3, 0x1.1e10f53348194p-2,
     -0x1.cb069289519e4p-5, -0x1.59c332a19a04bp-4, 0x1.174c94b08dd7fp-4, 0x1.419c9a940603ap-7, -0x1.6c7dfdded448fp-5,
     0x1.26b804f7d6305p-6, 0x1.3769ce83c0a0bp-6}, /* [10] 0.59375 <= y <= 0.65625, degree 10, 61.1 bits */
    {0x1.7b430f73e47ebp+1, 0x1.bc5cf765301fep-53, -0x1.457fa19bd321fp-1, -0x1.97889b8d828ebp-3, 0x1.0cb0676d5339ap-2,
     -0x1.410a32aba66f6p-4, -0x1.e01f3ce93309bp-5, 0x1.16ad662655d5p-4, -0x1.35cac615cea32p-7, -0x1.058b77d7c077bp-5,
     0x1.99fb95dcb316cp-6, 0x1.0a02593420519p-8}, /* [11] 0.65625 <= y <= 0.71875, degree 10, 60.8 bits */
    {0x1.7615a74ccffc2p+1, -0x1.e2821acc1641bp-55, -0x1.50b36f51ecfe3p-1, -0x1.36cc8e458bc9ep-3, 0x1.ed39ed4578f13p-3,
     -0x1.7c30327fe396bp-4, -0x1.18a4eb8119bc1p-5, 0x1.f31e7126d4fc7p-5, -0x1.662acfcf1a38fp-6, -0x1.2389e6ab14469p-6,
     0x1.8ad879305fa9cp-6, -0x1.8d1bf30a5ab18p-8}, /* [12] 0.71875 <= y <= 0.78125, degree 10, 60.5 bits */
    {0x1.70c14de08403ep+1, 0x1.e2ecacf830b76p-54, -0x1.5904162706bap-1, -0x1.bdd6158abcc3cp-4, 0x1.bb8bb5704fc42p-3,
     -0x1.9a3f6dbead359p-4, -0x1.b72b255b5b701p-7, 0x1.98afced5a012cp-5, -0x1.c400030381a3bp-6, -0x1.71197f989a992p-8,
     0x1.318f9b02a4039p-6, -0x1.58a71989d5713p-7}, /* [13] 0.78125 <= y <= 0.84375, degree 10, 61.5 bits */
    {0x1.6b50fd7bac8eap+1, -0x1.5c3126e60017cp-56, -0x1.5ebbb0cfca07bp-1, -0x1.21361a7d26f21p-4, 0x1.87a92db7ab4e8p-3,
     -0x1.a0693fc7c01bp-4, 0x1.89174cd49bc65p-9, 0x1.339dca96e1fb9p-5, -0x1.cc59dee4b00fbp-6, 0x1.82eefef500a17p-9,
     0x1.848afe0cfef85p-7, -0x1.5dbbc1c81e19ap-7}, /* [14] 0.84375 <= y <= 0.90625, degree 10, 62.6 bits */
    {0x1.65ce7fb836f78p+1, 0x1.0b8a2422981e2p-55, -0x1.6227bf220ad24p-1, -0x1.30120b308b52p-5, 0x1.5431d127eeddap-3,
     -0x1.94867da06e088p-4, 0x1.e62881a4dc79cp-7, 0x1.a68ef6602bc7ap-6, -0x1.9dc7a94e71868p-6, 0x1.01247789ab2ccp-7,
     0x1.7b8f65b1343aap-8, -0x1.16d26b4b407c3p-7}, /* [15] 0.90625 <= y <= 0.96875, degree 10, 61.6 bits */
    {0x1.604268229c3dfp+1, 0x1.91d69f3650ab3p-53, -0x1.639537790d555p-1, -0x1.0e2eb3578ca21p-7, 0x1.230c0a774c5bdp-3,
     -0x1.7c313062b62a1p-4, 0x1.718100dbce4f8p-6, 0x1.011e19499de96p-6, -0x1.53ebb7d66cb99p-6, 0x1.401c7d9458c5fp-7,
     0x1.644bde950dc57p-10, -0x1.7321e3f41c999p-8}, /* [16] 0.96875 <= y <= 1.03125, degree 10, 64.1 bits */
    {0x1.5ab41c708ec65p+1, 0x1.c6c939e884f0cp-55, -0x1.634daadcb720bp-1, 0x1.0aca6e607a463p-6, 0x1.eaecd3ab1c13cp-4,
     -0x1.5c3dc58ab53b8p-4, 0x1.b83fc986b9d15p-6, 0x1.f85f7f162455bp-8, -0x1.032ccbabc7277p-6, 0x1.3d8d18e0b6002p-7,
     -0x1.62659cd1c2ea6p-10, -0x1.973288f0ae1bp-9}, /* [17] 1.03125 <= y <= 1.09375, degree 10, 61.0 bits */
    {0x1.5529e6265951cp+1, -0x1.dcbfe542e32b2p-53, -0x1.6195637f2196bp-1, 0x1.2db7c56c3a40ep-5, 0x1.9849163144e3p-4,
     -0x1.38830770007eap-4, 0x1.d4640c2cc9303p-6, 0x1.d790834e73e2ep-10, -0x1.7050e74bf3e3p-7, 0x1.169228fe239d8p-7,
     -0x1.5dcb09f1a3f97p-9, -0x1.42030850f9a1fp-10}, /* [18] 1.09375 <= y <= 1.15625, degree 10, 60.8 bits */
    {0x1.4fa90a1296d8ep+1, 0x1.7263c06cf99f6p-53, -0x1.5eaa53424d87bp-1, 0x1.b8bfd445a353fp-5, 0x1.4ebeaf0c3c114p-4,
     -0x1.13d83aeba9cf8p-4, 0x1.d2270e2d8a4b7p-6, -0x1.267b2445785eep-9, -0x1.e4660a49bee5ep-8, 0x1.c19806df041e7p-8,
     -0x1.8dddebf36746p-9, -0x1.b2938b99adf57p-15}, /* [19] 1.15625 <= y <= 1.21875, degree 10, 61.3 bits */
    {0x1.4a35e2bf61627p+1, 0x1.59025d891f55ap-53, -0x1.5ac3a28b12f81p-1, 0x1.14f4c0de87c94p-4, 0x1.0e46bbcb99be9p-4,
     -0x1.e064489a7049fp-5, 0x1.bbdb2a7d92a11p-6, -0x1.3a0d518d656c7p-8, -0x1.1f55a8d1ca6fcp-8, 0x1.53d621c65f78bp-8,
     -0x1.75ab2c5a7554cp-9, 0x1.2870023cae3ccp-11}, /* [20] 1.21875 <= y <= 1.28125, degree 10, 61.5 bits */
    {0x1.44d3fbb3ded65p+1, 0x1.e6af9062d8c84p-53, -0x1.5611b2320a0ebp-1, 0x1.4244f5b3e34a2p-4, 0x1.acea3f42298ep-5,
     -0x1.9d9a8aa4257f4p-5, 0x1.999865aad512bp-6, -0x1.964a98dce131ep-8, -0x1.1ce9b8c3be056p-9, 0x1.e4d84b1e9ce09p-9,
     -0x1.3b9d2f3e69a1fp-9, 0x1.a549d3feded5fp-11}, /* [21] 1.28125 <= y <= 1.34375, degree 10, 60.9 bits */
    {0x1.3f862c094ddb5p+1, 0x1.4abedfc4feef9p-53, -0x1.50be6a1153887p-1, 0x1.65e094cf29765p-4, 0x1.4d420f7677648p-5,
     -0x1.60b3c743fed86p-5, 0x1.71570799a8767p-6, -0x1.bd2a80618c23cp-8, -0x1.4eeb248e508c1p-11, 0x1.463ea303401dfp-9,
     -0x1.f0354b0f7c85dp-10, 0x1.ad1e0e749b71bp-11}, /* [22] 1.34375 <= y <= 1.40625, degree 10, 60.4 bits */
    {0x1.3a4eaf60af11ap+1, -0x1.49df5597c3425p-55, -0x1.4aedb5c443deep-1, 0x1.8134bccb4201dp-4, 0x1.f80b9aefcab82p-6,
     -0x1.2a4731a61e5cp-5, 0x1.473f89bd19dfap-6, -0x1.c003e30266359p-8, 0x1.7ca3b03a783afp-12, 0x1.99ee65f4e23ap-10,
     -0x1.710e24cb422fp-10, 0x1.7ab3f922718efp-11}, /* [23] 1.40625 <= y <= 1.46875, degree 10, 61.3 bits */
    {0x1.352f3cafe3d1ap+1, -0x1.52ece22c4c8a6p-56, -0x1.44be1903bf106p-1, 0x1.9587f2fde6f95p-4, 0x1.6f259ee2a8d94p-6,
     -0x1.f4c73eea1fa23p-6, 0x1.1e0b19bd808acp-6, -0x1.ac24b0786eb02p-8, 0x1.fb14817339aecp-11, 0x1.d352748fcfe3bp-11,
     -0x1.05af32b4ce97ap-10, 0x1.331407bbc1f7p-11}, /* [24] 1.46875 <= y <= 1.53125, degree 10, 61.2 bits */
    {0x1.30291aa97f8a4p+1, 0x1.d19c033ea91bcp-53, -0x1.3e494bcb1223bp-1, 0x1.a3f9b17c4ead7p-4, 0x1.f93996acd5682p-7,
     -0x1.a183216c5ea22p-6, 0x1.eec021f08da2fp-7, -0x1.8b3f43074b671p-8, 0x1.51d13dd448975p-10, 0x1.bd7919c6f3f32p-12,
     -0x1.625388d3ebb27p-11, 0x1.d5991f7382311p-12}, /* [25] 1.53125 <= y <= 1.59375, degree 10, 62.9 bits */
    {0x1.2b3d31b69b5eep+1, -0x1.62006e9041c51p-53, -0x1.37a4d3d509387p-1, 0x1.ad8401e1eb396p-4, 0x1.3ada6f93dd437p-7,
     -0x1.59cf83e1029eep-6, 0x1.a841bb74a94eep-7, -0x1.6412788ce8058p-8, 0x1.73ccb5c3cba76p-10, 0x1.e7a52fde99b2p-14,
     -0x1.c7e0d64ef8042p-12, 0x1.570f9c2c8298bp-12}, /* [26] 1.59375 <= y <= 1.65625, degree 10, 63.0 bits */
    {0x1.266c1b9b3337ep+1, -0x1.d40f5aea2cb5ap-53, -0x1.30e295101e9p-1, 0x1.b2fe483466692p-4, 0x1.3b5a2e022ed24p-8,
     -0x1.1c895d61e68ap-6, 0x1.695531f102b6dp-7, -0x1.3b17bd6476624p-8, 0x1.75564382b8733p-10, -0x1.416de68ffec7ap-14,
     -0x1.12a790d51065bp-12, 0x1.e1fe44ac445c2p-13}, /* [27] 1.65625 <= y <= 1.71875, degree 10, 60.7 bits */
    {0x1.21b630f0edc5p+1, 0x1.d4624c757103bp-55, -0x1.2a115591890eap-1, 0x1.b520a390f98f4p-4, 0x1.cc723624a4588p-11,
     -0x1.d0fe250f4952p-7, 0x1.32082e1e0b6f5p-7, -0x1.131d79de66d72p-8, 0x1.6341b4c0b14cbp-10, -0x1.8a75300e3e997p-13,
     -0x1.2b1a37e9a47cbp-13, 0x1.462fcf83e833ep-13}, /* [28] 1.71875 <= y <= 1.78125, degree 10, 60.3 bits */
    {0x1.1d1b94add1edep+1, 0x1.0296c5be9e6b9p-54, -0x1.233d338ca5a6bp-1, 0x1.b4877db3c5d8bp-4, -0x1.30a82cdca49bap-9,
     -0x1.790b9ffedaff3p-7, 0x1.01ffa05da2ac9p-7, -0x1.db8974e5db545p-9, 0x1.466ec2f00e887p-10, -0x1.002f7797b619ap-12,
     -0x1.09a6111b1e54cp-14, 0x1.a83320c918b6ep-14}, /* [29] 1.78125 <= y <= 1.84375, degree 10, 61.0 bits */
    {0x1.189c3def8c3e7p+1, -0x1.2f4bc6a165adfp-53, -0x1.1c700d1ff1ea9p-1, 0x1.b1b7085dd133p-4, -0x1.41d034bd97a3bp-8,
     -0x1.2f0bfd37fa7aep-7, 0x1.b14d8d0cdeb35p-8, -0x1.97c369916f76dp-9, 0x1.24c65a60950dcp-10, -0x1.1565f28ae250ep-12,
     -0x1.afdd5943db996p-17, 0x1.06bd0cc4fa9bfp-14}, /* [30] 1.84375 <= y <= 1.90625, degree 10, 63.7 bits */
    {0x1.14380042e87e9p+1, 0x1.5f08d56dd30ddp-56, -0x1.15b1da93a6bebp-1, 0x1.ad1e82883e6fdp-4, -0x1.c95e41092af31p-8,
     -0x1.e2069c8d0c685p-8, 0x1.6a9d1e573b9ecp-8, -0x1.5b859c4c3b02fp-9, 0x1.020dbd86074cbp-10, -0x1.132b449f291c6p-12,
     0x1.258a5f69b1ecp-16, 0x1.2ff579a294ec9p-15}, /* [31] 1.90625 <= y <= 1.96875, degree 10, 60.4 bits */
    {0x1.0fee929bb8d21p+1, 0x1.93434651fbcacp-55, -0x1.0f08fc171318dp-1, 0x1.a71b31b3db463p-4, -0x1.1a4331235b8d6p-7,
     -0x1.7a5b76a49482ap-8, 0x1.2e835aa961795p-8, -0x1.26c62542cfdd5p-9, 0x1.c11729c1c8fb1p-11, -0x1.0353bdc343c47p-12,
     0x1.1f7b66cecc54dp-15, 0x1.3930ea0eb4f53p-16}, /* [32] 1.96875 <= y <= 2.03125, degree 10, 61.5 bits */
    {0x1.0bbf952cb5796p+1, -0x1.177043333bbf9p-53, -0x1.087a7c3eb38c7p-1, 0x1.9ffb07b40652ep-4, -0x1.43fe72b62166p-7,
     -0x1.23fec803a0398p-8, 0x1.f74305087b375p-9, -0x1.f233d5cab40cap-10, 0x1.8306a2e80f8cbp-11, -0x1.d8d8700f2f9a3p-13,
     0x1.6181cf1fb2fcp-15, 0x1.eef8c2a4a92p-18}, /* [33] 2.03125 <= y <= 2.09375, degree 10, 61.6 bits */
    {0x1.07aa9649b1fd5p+1, -0x1.1ecf88d14ca3bp-53, -0x1.020a48932be65p-1, 0x1.97fef4e22d7fp-4, -0x1.63dec70b19ef4p-7,
     -0x1.b8856418d569bp-9, 0x1.a164854146ec7p-9, -0x1.a3c612739ef14p-10, 0x1.4b1c96e4dd4a1p-11, -0x1.a55959c513cp-13,
     0x1.746a271fa84c6p-15, 0x1.c43af2440ed8ep-22}, /* [34] 2.09375 <= y <= 2.15625, degree 10, 61.2 bits */
    {0x1.03af167950f35p+1, 0x1.e2e965a594537p-53, -0x1.f776c2efb192bp-2, 0x1.8f5ceb17dd18bp-4, -0x1.7b927b348d86fp-7,
     -0x1.41b439f3adb93p-9, 0x1.592068fe15c2ep-9, -0x1.60dd890810558p-10, 0x1.19b4a4539b3d4p-11, -0x1.715fb743c261dp-13,
     0x1.6b09eb6a50d45p-15, -0x1.e4747a14f74d1p-19}, /* [35] 2.15625 <= y <= 2.21875, degree 10, 61.0 bits */
    {0x1.ff9917acde0eap+0, -0x1.1aca8f1145b38p-54, -0x1.eb200531e842bp-2, 0x1.86419827914a1p-4, -0x1.8c83bbec9e183p-7,
     -0x1.bf3957419cc9ep-10, 0x1.1c6fc93dba393p-9, -0x1.281025048c7c7p-10, 0x1.dd51e6b4e811dp-12,
     -0x1.3ff31a82947ebp-13, 0x1.51ec695e42c69p-15, -0x1.7fe014ae725e9p-18},
     /* [36] 2.21875 <= y <= 2.28125, degree 10, 61.8 bits */
    {0x1.f804c9b9ee61p+0, -0x1.ee67b52612409p-56, -0x1.df1389e8183aep-2, 0x1.7cd1df8c5721fp-4, -0x1.97e2b8b59df4p-7,
     -0x1.1dd20084b8487p-10, 0x1.d31c9276c4881p-10, -0x1.f009b167428cfp-11, 0x1.93169f23470afp-12,
     -0x1.12ac2b20a652ep-13, 0x1.3132025d83916p-15, -0x1.bb6fcb885cd29p-18},
     /* [37] 2.28125 <= y <= 2.34375, degree 10, 61.9 bits */
    {0x1.f0a015738b2a7p+0, -0x1.627251f2a4353p-54, -0x1.d35376dc490d2p-2, 0x1.732c1b30b13f4p-4, -0x1.9eae7b86b5039p-7,
     -0x1.331c09907d5dp-11, 0x1.7deb62dce3c73p-10, -0x1.9efe2d7a7d637p-11, 0x1.539469b86af59p-12,
     -0x1.d472ccc36a0c8p-14, 0x1.0df1fc45b2782p-15, -0x1.c4a629ff67064p-18},
     /* [38] 2.34375 <= y <= 2.40625, degree 10, 61.0 bits */
    {0x1.e969c6635f397p+0, -0x1.4cc20c5f4bf04p-54, -0x1.c7e11597cc257p-2, 0x1.69692ad6f264bp-4, -0x1.a1bc8a5ad474dp-7,
     -0x1.6d579c43e4ffcp-13, 0x1.36b0178d46b59p-10, -0x1.5ac797cefd6c3p-11, 0x1.1d9020ecb0878p-12,
     -0x1.8d72e1a20b556p-14, 0x1.d6714486bd911p-16, -0x1.b0c26b2c4b00cp-18},
     /* [39] 2.40625 <= y <= 2.46875, degree 10, 60.9 bits */
    {0x1.e260a46161eeap+0, 0x1.17566185a9d73p-56, -0x1.bcbcfb86775d5p-2, 0x1.5f9d591303b56p-4, -0x1.a1bf6fae68a33p-7,
     0x1.4ec69afa2273ap-13, 0x1.f664e4eb91bcfp-11, -0x1.2174b0e0fb55p-11, 0x1.dfa4d9798a646p-13, -0x1.4fee8939a493p-14,
     0x1.9573ce9ea134p-16, -0x1.8d699facf924dp-18}, /* [40] 2.46875 <= y <= 2.53125, degree 10, 61.9 bits */
    {0x1.db83761f2b065p+0, 0x1.3d85e4069a31bp-56, -0x1.b1e72b86d2fdbp-2, 0x1.55d91c0cfc33fp-4, -0x1.9f4c49c277e08p-7,
     0x1.c16d17db2478bp-12, 0x1.932257f4a39d2p-11, -0x1.e2acce328ffbfp-12, 0x1.926ed716cd01cp-13,
     -0x1.1b22be00d5a81p-14, 0x1.5a98f3a2edb5bp-16, -0x1.6357a36fbf6e2p-18},
     /* [41] 2.53125 <= y <= 2.59375, degree 10, 62.1 bits */
    {0x1.d4d1033867021p+0, -0x1.20a066e9211e5p-58, -0x1.a75f31f296b94p-2, 0x1.4c29b78454f42p-4, -0x1.9adf804d98a73p-7,
     0x1.515ff199beee7p-11, 0x1.406c01c150b18p-11, -0x1.91f53cb956d6ap-12, 0x1.516cf0501fe09p-13,
     -0x1.dc4a5a436da01p-15, 0x1.267a62d79328ep-16, -0x1.37dc559684715p-18},
     /* [42] 2.59375 <= y <= 2.65625, degree 10, 62.8 bits */
    {0x1.ce4815dcb93ecp+0, -0x1.8d7b0b76696p-54, -0x1.9d243c01fe273p-2, 0x1.4299c4d28f418p-4, -0x1.94e0be66b9a1p-7,
     0x1.aa6bad2d1abaep-11, 0x1.f72b67cc8bf5fp-12, -0x1.4e4bb2a30079bp-12, 0x1.1aca07b70d44bp-13,
     -0x1.90053199aa05dp-15, 0x1.f21a3f3dc4cafp-17, -0x1.0e0bd2bbf2798p-18},
     /* [43] 2.65625 <= y <= 2.71875, degree 10, 61.2 bits */
    {0x1.c7e77c2416e8ep+0, 0x1.8ccbc7490387p-58, -0x1.93352b493d2cep-2, 0x1.3931a501353a2p-4, -0x1.8da64bc0434e5p-7,
     0x1.efd349a53a9b9p-11, 0x1.84c0b40af8083p-12, -0x1.159939b7d9112p-12, 0x1.d9d9f847173bep-14, -0x1.4fa1047529bfp-15,
     0x1.a3d4004c917ap-17, -0x1.cf123bb674e2dp-19}, /* [44] 2.71875 <= y <= 2.78125, degree 10, 62.1 bits */
    {0x1.c1ae091be6d3bp+0, 0x1.609e17a8506f2p-56, -0x1.8990a5f12fa34p-2, 0x1.2ff7e06d9f3ffp-4, -0x1.8577dd412b7c3p-7,
     0x1.1275b80162e54p-10, 0x1.25d25d9f5e398p-12, -0x1.cc34304864bcdp-13, 0x1.8cea50822586cp-14,
     -0x1.196d354f967e2p-15, 0x1.60f7eaa299628p-17, -0x1.8a1d8ee3922f6p-19}
     /* [45] 2.78125 <= y <= 2.84375, degree 10, 63.5 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_duration_zero_force)

/* largest overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-58.1 at most, proved for the whole cell of each row. */
#define COR_ROWS_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_MAX_OVERLAP_STEP 0.125
#define COR_ROWS_MAX_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_MAX_OVERLAP_ROWS 65
#define COR_ROWS_MAX_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_max_overlap, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.17e693ae45eacp+0, -0x1.0143225363a73p-54, -0x1.0247e9726460cp-1, 0x1.22dc2c535cbf9p-2, -0x1.5c9cb625f67d8p-3,
     0x1.b02182f14b356p-4, -0x1.11cff4e9fbeafp-4, 0x1.60945283b95b4p-5, -0x1.cb94308c7b33bp-6, 0x1.2e3b8f5a1cd9cp-6,
     -0x1.8ae7707563bd2p-7, 0x1.b3eeeaac77906p-8}, /* [0] 0 <= y <= 0.0625, degree 10, 58.1 bits */
    {0x1.08d0b7eba8138p+0, -0x1.f64496b8790a3p-54, -0x1.c33fe4a5e2671p-2, 0x1.d4dcc3a12fd4ap-3, -0x1.02f618cddf0e2p-3,
     0x1.2795bab5d2b25p-4, -0x1.58b0c32b9ceb1p-5, 0x1.9836b4a9416c3p-6, -0x1.e930d210bad86p-7, 0x1.27e2b1dcb6ae1p-7,
     -0x1.6a07ce28be75cp-8, 0x1.bc2efb5af7d28p-9}, /* [1] 0.0625 <= y <= 0.1875, degree 10, 58.9 bits */
    {0x1.f724169a6983bp-1, 0x1.420358d2f23bbp-55, -0x1.8e2ea347773dap-2, 0x1.8017ea497fbc7p-3, -0x1.8989da5c319cap-4,
     0x1.a053797246851p-5, -0x1.c1b2fa2bb2efp-6, 0x1.ed15ff50ee996p-7, -0x1.117207b066ee7p-7, 0x1.320fff268eb3p-8,
     -0x1.5a3aa9c726ebep-9, 0x1.88e1ffc0759fp-10}, /* [2] 0.1875 <= y <= 0.3125, degree 10, 61.3 bits */
    {0x1.dfaa31b8032abp-1, -0x1.7a0bd307e3352p-57, -0x1.62684c1e5039fp-2, 0x1.3f114a33a485bp-3, -0x1.30e0d2accbeeep-4,
     0x1.2c97e7d9c70e7p-5, -0x1.2e72311676ab9p-6, 0x1.34c81adc5e6eep-7, -0x1.3ec8209ea5685p-8, 0x1.4c0937531ef33p-9,
     -0x1.5d504ade2f1c2p-10, 0x1.70b967137d772p-11}, /* [3] 0.3125 <= y <= 0.4375, degree 10, 59.7 bits */
    {0x1.cab0cb05fef98p-1, -0x1.94b6b3951a247p-57, -0x1.3dd31be2b5919p-2, 0x1.0c46419351d14p-3, -0x1.e06190630d283p-5,
     0x1.bb8780572bf7dp-6, -0x1.a1b5850ca4ac2p-7, 0x1.8f06e37cfb5fbp-8, -0x1.8156dcda8a20ap-9, 0x1.7758d320a4653p-10,
     -0x1.71164ac093798p-11, 0x1.6c37d192cb0d2p-12}, /* [4] 0.4375 <= y <= 0.5625, degree 10, 60.3 bits */
    {0x1.b7d1adef216c6p-1, -0x1.addaf54880949p-55, -0x1.1ee7437a40066p-2, 0x1.c7efe154ac134p-4, -0x1.800dfb154c8fp-5,
     0x1.4d719de35871fp-6, -0x1.272e870359211p-7, 0x1.08f7658619677p-8, -0x1.e0c08736e91c5p-10, 0x1.b7d29e4c17e8ap-11,
     -0x1.9603cb25fee73p-12, 0x1.782f9345150c6p-13}, /* [5] 0.5625 <= y <= 0.6875, degree 10, 59.1 bits */
    {0x1.a6bbcf350a79ep-1, -0x1.ef5464aa3fe22p-58, -0x1.04815f8576aacp-2, 0x1.8713d044a16b9p-4, -0x1.370c4880c1ef5p-5,
     0x1.fdc466c836c89p-7, -0x1.a9c27e1182bfap-8, 0x1.68771bd94456p-9, -0x1.345c208e3f565p-10, 0x1.09f6f553c64f4p-11,
     -0x1.cec29d21f60bfp-13, 0x1.941bd3350e4c5p-14}, /* [6] 0.6875 <= y <= 0.8125, degree 10, 58.6 bits */
    {0x1.972e03e22c7b8p-1, 0x1.255ce0540ddd3p-57, -0x1.db899a17812cfp-3, 0x1.523f95d28a7fcp-4, -0x1.fdad475daa031p-6,
     0x1.8b764764454c9p-7, -0x1.38a4ea5ea5c3p-8, 0x1.f4f98d162d7d9p-10, -0x1.9576d800f2863p-11, 0x1.4ad0492295328p-12,
     -0x1.102513aea6573p-13, 0x1.c17d1a39a9e0bp-15}, /* [7] 0.8125 <= y <= 0.9375, degree 10, 62.5 bits */
    {0x1.88f33e5dd6096p-1, 0x1.37c83f0f062bdp-58, -0x1.b40f9dc2acc13p-3, 0x1.26bee087a0be7p-4, -0x1.a5e6a8eaa22afp-6,
     0x1.36ddf57890b04p-7, -0x1.d2a247d66f32ep-9, 0x1.62d6fa136318ep-10, -0x1.1085d9b60bcf3p-11, 0x1.a5ea9821c0609p-13,
     -0x1.4935dc16f6c63p-14, 0x1.01e0ed4d78c14p-15}, /* [8] 0.9375 <= y <= 1.0625, degree 10, 60.5 bits */
    {0x1.7bdfd381ec906p-1, 0x1.375e88828a238p-55, -0x1.918be7bb06466p-3, 0x1.0291cfdea3c3dp-4, -0x1.607fd9c4351cfp-6,
     0x1.ee94ab02e7f54p-8, -0x1.6153ed39d41c9p-9, 0x1.ff5f21d34e725p-11, -0x1.75ae42fbef54cp-12, 0x1.132edcee0bea3p-13,
     -0x1.986bff90a7899p-15, 0x1.304842fa02589p-16}, /* [9] 1.0625 <= y <= 1.1875, degree 10, 59.6 bits */
    {0x1.6fcf765b1ad9p-1, 0x1.b3663201ae29dp-55, -0x1.732d27223a9d2p-3, 0x1.c87004d0d2ea2p-5, -0x1.28fffee6a11fdp-6,
     0x1.8dafba2b55a01p-8, -0x1.0f120d6cbf944p-9, 0x1.763e4323296a7p-11, -0x1.04d485f6b8c2p-12, 0x1.6e57c51103c6p-14,
     -0x1.0330c07ce1aa1p-15, 0x1.7036e8ab6e9e7p-17}, /* [10] 1.1875 <= y <= 1.3125, degree 10, 61.0 bits */
    {0x1.64a3b4d17ecf6p-1, -0x1.dbb19b4487141p-55, -0x1.584c0dfcdc4fap-3, 0x1.95198920db41ap-5, -0x1.f85184d112237p-7,
     0x1.42ead10adae2dp-8, -0x1.a4eb926495061p-10, 0x1.15c72b15f8fdap-11, -0x1.7219f68d3804bp-13, 0x1.f0cd41e422734p-15,
     -0x1.4fdb0648bfb64p-16, 0x1.c7e8d6f641e36p-18}, /* [11] 1.3125 <= y <= 1.4375, degree 10, 61.1 bits */
    {0x1.5a42d0e9efe8fp-1, -0x1.2def818353aep-62, -0x1.40617e89c27b1p-3, 0x1.695cb87cbaadfp-5, -0x1.af2da7f1f772bp-7,
     0x1.088eb85f2ce4fp-8, -0x1.4a6247d1721a3p-10, 0x1.a1b2e48452698p-12, -0x1.0a8204e204e13p-13, 0x1.5696e0e4a1073p-15,
     -0x1.bb7ee512806dcp-17, 0x1.2034fa7bb959cp-18}, /* [12] 1.4375 <= y <= 1.5625, degree 10, 61.8 bits */
    {0x1.5096dd9c735f3p-1, -0x1.56ea8da7214dp-55, -0x1.2aff51771c046p-3, 0x1.43d9633bea007p-5, -0x1.7303ebffdf712p-7,
     0x1.b50dccb36653ap-9, -0x1.05ec80ff5cd9ap-10, 0x1.3dc6e9e23de4fp-12, -0x1.8515cbc0d61c2p-14, 0x1.dfd96e67a302ep-16,
     -0x1.29ed3a7e796d3p-17, 0x1.736d59282e2e1p-19}, /* [13] 1.5625 <= y <= 1.6875, degree 10, 61.5 bits */
    {0x1.478d0db63251cp-1, -0x1.3010a4a6cf8f7p-56, -0x1.17caf258a406cp-3, 0x1.2379e254e8274p-5, -0x1.4122c5d55dba5p-7,
     0x1.6bbdc3ea68871p-9, -0x1.a321e77a23a19p-11, 0x1.e8cae2c7c838fp-13, -0x1.1f999d61bac52p-14, 0x1.54dc1f3262f6fp-16,
     -0x1.96b14efdf9858p-18, 0x1.e72cb932c3601p-20}, /* [14] 1.6875 <= y <= 1.8125, degree 10, 63.8 bits */
    {0x1.3f1528481fe22p-1, -0x1.ce866820de55dp-59, -0x1.06794dd629364p-3, 0x1.0761318be6f34p-5, -0x1.177b260bb5fbep-7,
     0x1.30d712dcb9c65p-9, -0x1.5234a922c42fcp-11, 0x1.7bb4780f62dcdp-13, -0x1.ae1d01f7c6163p-15, 0x1.eaa5b10809208p-17,
     -0x1.19af844a787b6p-18, 0x1.44b965f570f8ap-20}, /* [15] 1.8125 <= y <= 1.9375, degree 10, 59.3 bits */
    {0x1.37211999973bep-1, 0x1.8dcaaeeabe736p-56, -0x1.ed976b97cf557p-4, 0x1.ddbb9f38253b2p-6, -0x1.e8ebda305f7ap-8,
     0x1.0121012d44c9bp-9, -0x1.130e680710bf2p-11, 0x1.29b60a4c75e7cp-13, -0x1.4515120c923bep-15, 0x1.6570512f8c635p-17,
     -0x1.8b89f9b8d9c34p-19, 0x1.b76fffa95a929p-21}, /* [16] 1.9375 <= y <= 2.0625, degree 10, 61.1 bits */
    {0x1.2fa49a004d40bp-1, -0x1.89089b3fe9342p-56, -0x1.d11af5ab07b9dp-4, 0x1.b2c0003cecad4p-6, -0x1.adab1cf20f1b7p-8,
     0x1.b4600f57cbb15p-10, -0x1.c2abe2275ad75p-12, 0x1.d6e20b87f7768p-14, -0x1.f04dc05753deep-16,
     0x1.0758413c245f4p-17, -0x1.1939ffb4eb5d8p-19, 0x1.2d82bd980e26dp-21},
     /* [17] 2.0625 <= y <= 2.1875, degree 10, 60.3 bits */
    {0x1.2894e5b4710d9p-1, 0x1.117d9493d2183p-55, -0x1.b7241a81d123bp-4, 0x1.8ce4f6253fcc7p-6, -0x1.7b403c3970bf8p-8,
     0x1.745bcbb1534fep-10, -0x1.73b8ddf6b0a5ap-12, 0x1.7763c3528f1a2p-14, -0x1.7e5f857297115p-16, 0x1.88213e2c8877p-18,
     -0x1.949e79705ebd6p-20, 0x1.a326d9f2d32f6p-22}, /* [18] 2.1875 <= y <= 2.3125, degree 10, 62.3 bits */
    {0x1.21e881f1b9fd2p-1, -0x1.2c5b24400602p-55, -0x1.9f67085a3cce8p-4, 0x1.6b69c0a365b75p-6, -0x1.501e84e03b5f4p-8,
     0x1.3f64662a85d2ap-10, -0x1.348dbe19bc3cfp-12, 0x1.2d82739fbbcbfp-14, -0x1.292639e016561p-16,
     0x1.26d139bf2a921p-18, -0x1.2647356ad6c63p-20, 0x1.26e4b394a81bfp-22},
     /* [19] 2.3125 <= y <= 2.4375, degree 10, 63.3 bits */
    {0x1.1b970c9a2959ap-1, 0x1.021d2dbf2ccbdp-56, -0x1.89a2e513a4b3cp-4, 0x1.4daeeeab02d67p-6, -0x1.2b08a94a4ec8bp-8,
     0x1.134c6e4046fdcp-10, -0x1.01a4d882e50c7p-12, 0x1.e7bdde7a56be8p-15, -0x1.d19564c93f4ebp-17,
     0x1.bf61ebdb0431cp-19, -0x1.b075276c6a3acp-21, 0x1.a3aa49f4f4644p-23},
     /* [20] 2.4375 <= y <= 2.5625, degree 10, 60.5 bits */
    {0x1.15991436dab68p-1, 0x1.4aeb7e1cc6b6ep-55, -0x1.759ff004feeebp-4, 0x1.332fcc0366099p-6, -0x1.0aff029e124a4p-8,
     0x1.dcc2521011edp-11, -0x1.b0ab3500720a4p-13, 0x1.8d195fc7c7366p-15, -0x1.6f843c1aec9dcp-17, 0x1.565f6ef10d10bp-19,
     -0x1.40d26e468bb3cp-21, 0x1.2dcc5010c4c7bp-23}, /* [21] 2.5625 <= y <= 2.6875, degree 10, 61.9 bits */
    {0x1.0fe7f6afba5b8p-1, 0x1.2b11c93950ba8p-59, -0x1.632e00d80494ep-4, 0x1.1b7d41b4a9fb4p-6, -0x1.de645b1a6262ap-9,
     0x1.9e99c1709c0dbp-11, -0x1.6d336fdb019dbp-13, 0x1.454d25ac079f1p-15, -0x1.242cd80000646p-17,
     0x1.0821420cd24a4p-19, -0x1.e050bac81ed56p-22, 0x1.b66a35410feeep-24},
     /* [22] 2.6875 <= y <= 2.8125, degree 10, 63.6 bits */
    {0x1.0a7dc5706054fp-1, 0x1.9f75a7d8d510bp-55, -0x1.52234f2f6e539p-4, 0x1.0639cf741f451p-6, -0x1.adf1b2e33a423p-9,
     0x1.6a02002f59c9fp-11, -0x1.35c65189de086p-13, 0x1.0c09495da0176p-15, -0x1.d3ad225bfb7cep-18,
     0x1.9aa30fe2f4309p-20, -0x1.6a9c2adc54cd9p-22, 0x1.416f7f2505724p-24},
     /* [23] 2.8125 <= y <= 2.9375, degree 10, 60.9 bits */
    {0x1.05552df70bd11p-1, -0x1.e93646333594p-55, -0x1.425b73b495d19p-4, 0x1.e62cb7ad009c8p-7, -0x1.838feb2aeea7ap-9,
     0x1.3d4b8d3de5adcp-11, -0x1.07fbae7bdf8fcp-13, 0x1.bc20d38d127e3p-16, -0x1.78aaaa5c52dfcp-18,
     0x1.417e5c3daab26p-20, -0x1.13f20c789591cp-22, 0x1.db8528f0ad66cp-25},
     /* [24] 2.9375 <= y <= 3.0625, degree 10, 63.6 bits */
    {0x1.00696600c5c86p-1, -0x1.077ed830a12ccp-57, -0x1.33b696bd6238fp-4, 0x1.c39f540513cfp-7, -0x1.5e59473aeefbfp-9,
     0x1.171c16fbc0f2ep-11, -0x1.c3e61ab2854ffp-14, 0x1.71dc700001d1ap-16, -0x1.312e32bd99e23p-18,
     0x1.fad02ff6cc7d6p-21, -0x1.a72b42092d6b8p-23, 0x1.62ae111d19ce7p-25},
     /* [25] 3.0625 <= y <= 3.1875, degree 10, 62.2 bits */
    {0x1.f76c355ea66bcp-2, 0x1.4d6b2826dd648p-56, -0x1.2618c368433edp-4, 0x1.a4589fcfc0005p-7, -0x1.3d8eff38b5598p-9,
     0x1.ecb7e49744ebp-12, -0x1.84664902025bbp-14, 0x1.3585f9336b356p-16, -0x1.f15173d21f1ebp-19, 0x1.920992ea5976dp-21,
     -0x1.46cb3b426d762p-23, 0x1.0aa4aeb008ecfp-25}, /* [26] 3.1875 <= y <= 3.3125, degree 10, 61.6 bits */
    {0x1.ee6ec44bdfcc1p-2, -0x1.ea724df51801ap-57, -0x1.19695810264edp-4, 0x1.87f621f6f2446p-7, -0x1.2091d7b4bece6p-9,
     0x1.b44fea59de6e9p-12, -0x1.4f237599947edp-14, 0x1.043b79d96a3d3p-16, -0x1.9761affc487fap-19,
     0x1.40db796bca3c3p-21, -0x1.fc28e2e71af2bp-24, 0x1.93ecaf4dc4d4ap-26},
     /* [27] 3.3125 <= y <= 3.4375, degree 10, 64.4 bits */
    {0x1.e5d35e661f02fp-2, -0x1.68acb27b00377p-56, -0x1.0d928e828135ap-4, 0x1.6e23103baf574p-7, -0x1.06dc471083045p-9,
     0x1.838d2c85f6328p-12, -0x1.224337bba07a4p-14, 0x1.b782b7b43218cp-17, -0x1.4f679f8bcd40fp-19,
     0x1.018b049916ec7p-21, -0x1.8da1f92f735c2p-24, 0x1.341e4fbf1e751p-26},
     /* [28] 3.4375 <= y <= 3.5625, degree 10, 60.4 bits */
    {0x1.dd938d628e4cfp-2, 0x1.145ab93ef17e5p-57, -0x1.0281178dd6c8fp-4, 0x1.56962080df6d2p-7, -0x1.dffb9ba70ec5cp-10,
     0x1.593f019d3021cp-12, -0x1.f893f4c9e191p-15, 0x1.74b3eb202b6dfp-17, -0x1.157a4afa4ad68p-19, 0x1.9fb48ce51f68dp-22,
     -0x1.390c2482d011fp-24, 0x1.d9404a98ad1fcp-27}, /* [29] 3.5625 <= y <= 3.6875, degree 10, 63.2 bits */
    {0x1.d5a96cb28ac3ap-2, 0x1.f586e86b4e4adp-56, -0x1.f0478ccd63b3dp-5, 0x1.410fbe2a53a92p-7, -0x1.b72e7ada2d4e6p-10,
     0x1.346a0845b1451p-12, -0x1.b80ca3abd96b9p-15, 0x1.3d4f36c2cfdcfp-17, -0x1.cd37cd5963f33p-20,
     0x1.513e5eb68e515p-22, -0x1.efc69605ef0d9p-25, 0x1.6dc6ed8166997p-27},
     /* [30] 3.6875 <= y <= 3.8125, degree 10, 62.1 bits */
    {0x1.ce0f99969f8aep-2, -0x1.989f42e246c98p-56, -0x1.dcd69229d5bf3p-5, 0x1.2d588fc23cf74p-7, -0x1.92af72be4e3c6p-10,
     0x1.143ddae052aa8p-12, -0x1.81025ad3dde6ep-15, 0x1.0f2c9c4b52738p-17, -0x1.80fd621f1883bp-20,
     0x1.12f22c03e7855p-22, -0x1.8ac144e442091p-25, 0x1.1c7099c28dabep-27},
     /* [31] 3.8125 <= y <= 3.9375, degree 10, 61.5 bits */
    {0x1.c6c12541a3075p-2, -0x1.4cb5c5225d681p-56, -0x1.ca93d74f3d604p-5, 0x1.1b403d5d78c23p-7, -0x1.71f4961c431ebp-10,
     0x1.f019de40b3217p-13, -0x1.51e3590539b5cp-15, 0x1.d12bde98d0af3p-18, -0x1.42b33caa87f6dp-20,
     0x1.c26df0f783addp-23, -0x1.3bfa267b82be4p-25, 0x1.bcf5934948e97p-28},
     /* [32] 3.9375 <= y <= 4.0625, degree 10, 61.8 bits */
    {0x1.bfb988bd4e0d1p-2, -0x1.c10db50a3e1p-56, -0x1.b966c8b99466bp-5, 0x1.0a9c6b7e54268p-7, -0x1.5487d3348f8p-10,
     0x1.be8c46014fca3p-13, -0x1.29676238cd748p-15, 0x1.905af3a999561p-18, -0x1.0f90b69d450ep-20, 0x1.729eca7fcdb18p-23,
     -0x1.fc63711d2557dp-26, 0x1.5df861440c99fp-28}, /* [33] 4.0625 <= y <= 4.1875, degree 10, 61.1 bits */
    {0x1.b8f49a4ed2048p-2, -0x1.bc414ed2318bdp-57, -0x1.a9394e81e844cp-5, 0x1.f68fc17a94546p-8, -0x1.3a03bc1c27c67p-10,
     0x1.92df2eae563b8p-13, -0x1.06810d7becaabp-15, 0x1.59b55d056ff84p-18, -0x1.cace10782a461p-21,
     0x1.3243f192186cep-23, -0x1.9af39cd09d9f2p-26, 0x1.14b92c2a51822p-28},
     /* [34] 4.1875 <= y <= 4.3125, degree 10, 62.6 bits */
    {0x1.b26e8424aef71p-2, -0x1.c70a4b41d1d72p-56, -0x1.99f78021c2147p-5, 0x1.da439ced0efb5p-8, -0x1.2210e2d19d8a2p-10,
     0x1.6c451e4fff999p-13, -0x1.d0a47fa86cf0cp-16, 0x1.2b76bd10e5f1p-18, -0x1.84fb5542729fcp-21, 0x1.fc416b9c824fbp-24,
     -0x1.4db7e9bea3a43p-26, 0x1.b7d6e119885edp-29}, /* [35] 4.3125 <= y <= 4.4375, degree 10, 61.9 bits */
    {0x1.ac23bc1fd3cffp-2, 0x1.bce680411ded3p-56, -0x1.8b8f62bde53eep-5, 0x1.c01a6c887aaafp-8, -0x1.0c63ac16e0f5cp-10,
     0x1.4a1037d2c054ep-13, -0x1.9c462f93e62a7p-16, 0x1.0430a7a6e10bp-18, -0x1.4aef01b107db2p-21, 0x1.a7652e22c8af2p-24,
     -0x1.1031caa59370fp-26, 0x1.5f413ef3ffe6ap-29}, /* [36] 4.4375 <= y <= 4.5625, degree 10, 61.5 bits */
    {0x1.a610fc914cbd1p-2, 0x1.6fb8a7ff0027fp-56, -0x1.7df0b0551c274p-5, 0x1.a7e0ce859c762p-8, -0x1.f175047e01b6bp-11,
     0x1.2bacd77109ff6p-13, -0x1.6eb57763a4302p-16, 0x1.c571ed70a8936p-19, -0x1.1a7cfbb048c73p-21,
     0x1.62096c473f047p-24, -0x1.bde6bd1289e8bp-27, 0x1.19d20eef4d781p-29},
     /* [37] 4.5625 <= y <= 4.6875, degree 10, 62.6 bits */
    {0x1.a0333dcbbb231p-2, 0x1.0dc27cf2296aap-56, -0x1.710ca6780cd6fp-5, 0x1.91691e1ffb138p-8, -0x1.cdb8abba9ffbp-11,
     0x1.109d305a81341p-13, -0x1.46f33e48d3742p-16, 0x1.8c3809c006b64p-19, -0x1.e3d0790dd0de7p-22,
     0x1.291d20d6a7f58p-24, -0x1.6eb5ff2bef7a8p-27, 0x1.c63f591d677e9p-30},
     /* [38] 4.6875 <= y <= 4.8125, degree 10, 65.1 bits */
    {0x1.9a87b06cc5613p-2, -0x1.27df7dd41ed0fp-56, -0x1.64d5db69b3745p-5, 0x1.7c8ab67045d28p-8, -0x1.ad2ebbe528738p-11,
     0x1.f0eb6f56a8ccap-14, -0x1.2429db3727ca7p-16, 0x1.5b23c699031cdp-19, -0x1.9f95fe0600d2p-22, 0x1.f46c0a97c93b8p-25,
     -0x1.2ec1d91174378p-27, 0x1.6fa888ca8e27ep-30}, /* [39] 4.8125 <= y <= 4.9375, degree 10, 63.4 bits */
    {0x1.950bb846cb577p-2, -0x1.c54d2bb3eba97p-58, -0x1.594018b7ecbcdp-5, 0x1.692150be25158p-8, -0x1.8f80182b73f16p-11,
     0x1.c5b4680e1da41p-14, -0x1.05a5b696fde45p-16, 0x1.30ebb5a239718p-19, -0x1.6608bf8ce3eb7p-22,
     0x1.a6d59bb16c90ap-25, -0x1.f5c8196270a09p-28, 0x1.2acda7ac4b495p-30},
     /* [40] 4.9375 <= y <= 5.0625, degree 10, 63.7 bits */
    {0x1.8fbce7d69e24p-2, -0x1.aaf3fb097321bp-56, -0x1.4e403a829b6a8p-5, 0x1.570c79dcdefc5p-8, -0x1.746056b03030fp-11,
     0x1.9ef6a3a2f6f5ap-14, -0x1.d59eaecab93bp-17, 0x1.0c7f660c417d8p-19, -0x1.35543bc71b766p-22, 0x1.666ceceeb8p-25,
     -0x1.a150441d74bcp-28, 0x1.e79d61df9fe5cp-31}, /* [41] 5.0625 <= y <= 5.1875, degree 10, 61.8 bits */
    {0x1.8a98fc33dcf92p-2, -0x1.3548f1421eb72p-57, -0x1.43cc12c81c8c4p-5, 0x1.462f1aedfd58ap-8, -0x1.5b8c44dbba358p-11,
     0x1.7c294561b077dp-14, -0x1.a64d210f09742p-17, 0x1.d9f9696eacbe4p-20, -0x1.0bfb00980e59bp-22,
     0x1.30c4aaaeb2339p-25, -0x1.5c43ab7f57819p-28, 0x1.8f630c78b51f9p-31},
     /* [42] 5.1875 <= y <= 5.3125, degree 10, 62.9 bits */
    {0x1.859dd96d075cap-2, 0x1.df51a964b96c6p-59, -0x1.39da50284886bp-5, 0x1.366f1286b5cddp-8, -0x1.44c8a61a702fbp-11,
     0x1.5cd5e86f28113p-14, -0x1.7c7d276917e8cp-17, 0x1.a34e87895653fp-20, -0x1.d18a8ef45bf8dp-23,
     0x1.03ea866f12bc1p-25, -0x1.239b919cfedb2p-28, 0x1.48536d878756ap-31},
     /* [43] 5.3125 <= y <= 5.4375, degree 10, 62.5 bits */
    {0x1.80c9874262d5ap-2, -0x1.5ef0ca5baba95p-57, -0x1.306267a539779p-5, 0x1.27b4dbb811d3dp-8, -0x1.2fe1232e3b08bp-11,
     0x1.4095db46a2e3ep-14, -0x1.57757820a0983p-17, 0x1.73c345e9cd38bp-20, -0x1.95668d4f8f0a3p-23,
     0x1.bc9a6c28e885ap-26, -0x1.e9e72653ca59p-29, 0x1.0edd708db2c46p-31},
     /* [44] 5.4375 <= y <= 5.5625, degree 10, 60.6 bits */
    {0x1.7c1a2e348f834p-2, 0x1.c4d3658d15245p-57, -0x1.275c80fb554cp-5, 0x1.19eb40e4d9e05p-8, -0x1.1ca76206536fap-11,
     0x1.270fcf9d3b44dp-14, -0x1.3697d8bc064afp-17, 0x1.4a4f9a8fa292ep-20, -0x1.61e4c19686a47p-23,
     0x1.7d50909efaf8ep-26, -0x1.9ccb1da2c82f9p-29, 0x1.c0754870587d5p-32},
     /* [45] 5.5625 <= y <= 5.6875, degree 10, 61.8 bits */
    {0x1.778e14dd21b85p-2, -0x1.834672376f466p-58, -0x1.1ec1653957bc4p-5, 0x1.0cff18a7e32ddp-8, -0x1.0af23f82d3e1ap-11,
     0x1.0ff5e9ebb1f79p-14, -0x1.195cc887b76aap-17, 0x1.261569bc38cf5p-20, -0x1.35a91f78e2581p-23,
     0x1.47e8d9d234f8ap-26, -0x1.5cdbe5164046bp-29, 0x1.7473f94c800f1p-32},
     /* [46] 5.6875 <= y <= 5.8125, degree 10, 61.5 bits */
    {0x1.73239d88d982dp-2, 0x1.e24474c22245ap-57, -0x1.168a6f4dda1ddp-5, 0x1.00df0b555bd6cp-8, -0x1.f53a4b691a0c4p-12,
     0x1.f6083fb3ecf3ap-15, -0x1.fe9fd7f37b274p-18, 0x1.06594b983a025p-20, -0x1.0f931a720e932p-23,
     0x1.1ab64c28c492bp-26, -0x1.27ad4237202a2p-29, 0x1.36523b0f86455p-32},
     /* [47] 5.8125 <= y <= 5.9375, degree 10, 63.2 bits */
    {0x1.6ed9440c2505ep-2, 0x1.b5d9b59cb38fap-56, -0x1.0eb17e4a8d218p-5, 0x1.eaf6bfba197f2p-9, -0x1.d70ef43732b26p-12,
     0x1.cffdafe2ffd6fp-15, -0x1.d01a29babf579p-18, 0x1.d4f95247e188cp-21, -0x1.dd6565eefeff7p-24,
     0x1.e8b471aac4082p-27, -0x1.f69997095f42dp-30, 0x1.0359723187fb6p-32},
     /* [48] 5.9375 <= y <= 6.0625, degree 10, 61.3 bits */
    {0x1.6aad9bcb872bfp-2, 0x1.6ab4217e9c707p-57, -0x1.0730e9265e3d6p-5, 0x1.d58b9e094c63p-9, -0x1.bb284057cddf6p-12,
     0x1.ad637f043ddbfp-15, -0x1.a67b94d215e45p-18, 0x1.a3f1d8c396379p-21, -0x1.a47f55c099b93p-24,
     0x1.a769ed2eb17f2p-27, -0x1.ac512d1b65e74p-30, 0x1.b2c9fd94952d5p-33},
     /* [49] 6.0625 <= y <= 6.1875, degree 10, 60.5 bits */
    {0x1.669f4df247a69p-2, -0x1.ad1a4bb4c18bap-58, -0x1.000373cf61becp-5, 0x1.c162b833e467ep-9, -0x1.a15219fed4043p-12,
     0x1.8ddd9b5672ac9p-15, -0x1.812e741df423cp-18, 0x1.78b71c00bf7fep-21, -0x1.7324dbba9e171p-24,
     0x1.6fb38bcb46461p-27, -0x1.6df6b1a37b9b7p-30, 0x1.6d806912eb394p-33},
     /* [50] 6.1875 <= y <= 6.3125, degree 10, 61.3 bits */
    {0x1.62ad17d28087bp-2, -0x1.ed2a8938339b6p-56, -0x1.f2488ac79f72fp-6, 0x1.ae6464bd79ffcp-9, -0x1.895dd342179ccp-12,
     0x1.711ad838d7f2cp-15, -0x1.5fb0fcae86f2fp-18, 0x1.5285abdd02e43p-21, -0x1.483ca88322ca5p-24,
     0x1.400a5c013e964p-27, -0x1.3979c1c85d277p-30, 0x1.341c6c85c1c23p-33},
     /* [51] 6.3125 <= y <= 6.4375, degree 10, 62.3 bits */
    {0x1.5ed5c96a35423p-2, 0x1.7cc09a0432ba1p-56, -0x1.e51dbeddbd5b2p-6, 0x1.9c7b0d1944ee1p-9, -0x1.7321838ea8067p-12,
     0x1.56d37ee2c144cp-15, -0x1.419259469acd2p-18, 0x1.30b659eeca26p-21, -0x1.22d9f3c8429dcp-24, 0x1.172a94b83986ap-27,
     -0x1.0d2bc66f34068p-30, 0x1.046e932de1a55p-33}, /* [52] 6.4375 <= y <= 6.5625, degree 10, 61.7 bits */
    {0x1.5b184409a21c7p-2, 0x1.0b825ea84aa99p-57, -0x1.d87e2c15e6d0bp-6, 0x1.8b92f7cd69e7fp-9, -0x1.5e777a5d748d8p-12,
     0x1.3ec8143b4aca5p-15, -0x1.26703b25617fcp-18, 0x1.12b9c8ae362bap-21, -0x1.0234e3e3de127p-24,
     0x1.e80e7b12449f8p-28, -0x1.cf596a12618e9p-31, 0x1.b9696390d9b67p-34},
     /* [53] 6.5625 <= y <= 6.6875, degree 10, 64.8 bits */
    {0x1.57737917650e2p-2, -0x1.d6b49703a0bbdp-56, -0x1.cc62119d37ap-6, 0x1.7b9a18c5d7455p-9, -0x1.4b3dc41a27754p-12,
     0x1.28c04b76b470ep-15, -0x1.0df4cc102920fp-18, 0x1.f02976582fadbp-22, -0x1.cb48b0ba0990bp-25,
     0x1.ab80812e9b1c2p-28, -0x1.8fb7a470a9691p-31, 0x1.7706a0dc27937p-34},
     /* [54] 6.6875 <= y <= 6.8125, degree 10, 63.3 bits */
    {0x1.53e668ef842adp-2, -0x1.1125679771adp-56, -0x1.c0c238da6b34ap-6, 0x1.6c7fe70c37fbfp-9, -0x1.3955bea911df9p-12,
     0x1.148a1e8970335p-15, -0x1.efa9e28122e72p-19, 0x1.c0ba04e08d338p-22, -0x1.9931a4c940a2ap-25,
     0x1.7734cc8983a24p-28, -0x1.59972ab33044fp-31, 0x1.3f67fe2b2ffedp-34},
     /* [55] 6.8125 <= y <= 6.9375, degree 10, 63.1 bits */
    {0x1.507021daac301p-2, 0x1.e6594473a5cefp-57, -0x1.b597e9ee22ae5p-6, 0x1.5e353736f6e48p-9, -0x1.28a3bb5e6d686p-12,
     0x1.01f906a9902dfp-15, -0x1.c79da39b2c771p-19, 0x1.966dd8a681ed8p-22, -0x1.6d3089220881bp-25, 0x1.49f1adbd352ep-28,
     -0x1.2b6fff85ccd02p-31, 0x1.10aeeab034142p-34}, /* [56] 6.9375 <= y <= 7.0625, degree 10, 63.6 bits */
    {0x1.4d0fbf1b4d5f8p-2, 0x1.df2052a7aad73p-56, -0x1.aadce14ed192dp-6, 0x1.50ac19f96641cp-9, -0x1.190eac8dd12aap-12,
     0x1.e1caa015bc10dp-16, -0x1.a3512b0e6a2cap-19, 0x1.70a63a04483cbp-22, -0x1.46753c64bba85p-25,
     0x1.22afa7a78cbcap-28, -0x1.03fdc3a182392p-31, 0x1.d2aa8a3906896p-35},
     /* [57] 7.0625 <= y <= 7.1875, degree 10, 61.3 bits */
    {0x1.49c4680e7efb3p-2, -0x1.54fac629a1559p-57, -0x1.a08b46615a598p-6, 0x1.43d7be5398084p-9, -0x1.0a7fdd1f7a857p-12,
     0x1.c25709951ea3ep-16, -0x1.825ea6559b3e8p-19, 0x1.4ed9814681b96p-22, -0x1.244ddea5224ep-25, 0x1.0090d54e4ede6p-28,
     -0x1.c466975d93327p-32, 0x1.90381c3e6ce56p-35}, /* [58] 7.1875 <= y <= 7.3125, degree 10, 62.0 bits */
    {0x1.468d4f5ecbcc7p-2, -0x1.5900bfc0d900cp-56, -0x1.969da2f32817dp-6, 0x1.37ac56f1e16ep-9, -0x1.f9c561a8c560ep-13,
     0x1.a557d74aa0bep-16, -0x1.646c4cd13a289p-19, 0x1.30900bfecb5e9p-22, -0x1.062212ab21694p-25, 0x1.c5b3c2ea3c39ap-29,
     -0x1.8a614008a2814p-32, 0x1.57fb58cbb306ap-35}, /* [59] 7.3125 <= y <= 7.4375, degree 10, 61.8 bits */
    {0x1.4369b2473d2c5p-2, 0x1.79308a116c457p-56, -0x1.8d0edb7dd5b11p-6, 0x1.2c1f025ae49f8p-9, -0x1.e048d8280362bp-13,
     0x1.8a942f376c253p-16, -0x1.492acef6190c1p-19, 0x1.1561ababb72d2p-22, -0x1.d6de168e3bca6p-26,
     0x1.91d884990ab69p-29, -0x1.5875cf3fb901ep-32, 0x1.2845f88e25c9ep-35},
     /* [60] 7.4375 <= y <= 7.5625, degree 10, 61.8 bits */
    {0x1.4058d7e526fdap-2, -0x1.d31695f56b068p-56, -0x1.83da281f47dc7p-6, 0x1.2125b597b5601p-9, -0x1.c868049162f8dp-13,
     0x1.71d90c367f9e5p-16, -0x1.3053fe3aa9416p-19, 0x1.f9e6f2ea2ce67p-23, -0x1.a7888071b3fc5p-26,
     0x1.6482f6ddc7fd1p-29, -0x1.2d6bb5f92b68ap-32, 0x1.ff6a48ddd6aadp-36},
     /* [61] 7.5625 <= y <= 7.6875, degree 10, 61.6 bits */
    {0x1.3d5a10975eb84p-2, 0x1.b4383d1019acep-58, -0x1.7afb0e3395ecap-6, 0x1.16b7290c96b78p-9, -0x1.b203d3e6644b1p-13,
     0x1.5af893423b5a4p-16, -0x1.19a9a51757077p-19, 0x1.cdebfcaa5ac2ap-23, -0x1.7d815a249843ap-26,
     0x1.3cce69991e1d9p-29, -0x1.083ce101afa52p-32, 0x1.ba46e4226017cp-36},
     /* [62] 7.6875 <= y <= 7.8125, degree 10, 61.8 bits */
    {0x1.3a6cb569aabdfp-2, 0x1.9cf6b54eea10ep-56, -0x1.726d5a8042e2p-6, 0x1.0ccac74230143p-9, -0x1.9cffeb77ddb1cp-13,
     0x1.45c97e369f001p-16, -0x1.04f487d9ccd15p-19, 0x1.a64743e70e6b3p-23, -0x1.58210411a98bbp-26,
     0x1.19f7fde9cc913p-29, -0x1.d01a12b6bd66p-33, 0x1.7f3b3f692fbbap-36},
     /* [63] 7.8125 <= y <= 7.9375, degree 10, 64.1 bits */
    {0x1.3790278b563f3p-2, -0x1.2a7245b9aee26p-56, -0x1.6a2d1be228438p-6, 0x1.03589d672b339p-9, -0x1.894263c46d73fp-13,
     0x1.3226991e4e663p-16, -0x1.e407106df72e2p-20, 0x1.827ea9ae52cdfp-23, -0x1.36d6663128c18p-26,
     0x1.f6b293b0a4e08p-30, -0x1.98453425da01ap-33, 0x1.4cb2fb837f03ep-36}
     /* [64] 7.9375 <= y <= 8.0625, degree 10, 62.6 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_max_overlap)

/* time of the largest overlap, beta < 8: 65 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 8.0625.
 * Relative error of the approximation: 2^-60.6 at most, proved for the whole cell of each row. */
#define COR_ROWS_TIME_OF_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_TIME_OF_MAX_OVERLAP_STEP 0.125
#define COR_ROWS_TIME_OF_MAX_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_TIME_OF_MAX_OVERLAP_ROWS 65
#define COR_ROWS_TIME_OF_MAX_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_time_of_max_overlap, 65, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be991a8f0b41p+0, 0x1.5d0edcf23be6dp-55, -0x1.25a109d18ca25p-2, 0x1.ad809e048caecp-4, -0x1.8ed1e3e50f3c7p-5,
     0x1.a0aa0c303ba07p-6, -0x1.d2811e4b4fdcep-7, 0x1.113556b0d5e74p-7, -0x1.4a47399201e78p-8, 0x1.986d6205dc86cp-9,
     -0x1.fb48ccb022159p-10, 0x1.0da1cbc3151f8p-10}, /* [0] 0 <= y <= 0.0625, degree 10, 61.0 bits */
    {0x1.93220f99da4b9p+0, -0x1.39ada9c9a660fp-62, -0x1.0cef55a0a2a01p-2, 0x1.6b76a14e5e6eap-4, -0x1.3685b8d1d0af3p-5,
     0x1.2a04876d42d47p-6, -0x1.3250834429e84p-7, 0x1.4946d5f883d23p-8, -0x1.6d449f64f2f8fp-9, 0x1.9eb7514c1a8fep-10,
     -0x1.e0f6063abf273p-11, 0x1.19eaa1e97788bp-11}, /* [1] 0.0625 <= y <= 0.1875, degree 10, 64.4 bits */
    {0x1.8b10de8322aa4p+0, -0x1.51db60b352fcep-56, -0x1.efce70752fc76p-3, 0x1.378bccbdbad0cp-4, -0x1.ed19ed9d5a778p-6,
     0x1.b5b7847d5cda6p-7, -0x1.9fdd371bb2906p-8, 0x1.9d17ca451265p-9, -0x1.a7626cb7d3495p-10, 0x1.bc178b057b06bp-11,
     -0x1.db8b854025e9ap-12, 0x1.017d68a958b87p-12}, /* [2] 0.1875 <= y <= 0.3125, degree 10, 63.5 bits */
    {0x1.839be128607f3p+0, -0x1.fa0bfddd9d98fp-56, -0x1.cb8dae687caf1p-3, 0x1.0dfbaa9a608c3p-4, -0x1.8e1ab0eaff614p-6,
     0x1.48c4f4c353e92p-7, -0x1.226a66405ae8ap-8, 0x1.0c2357473c0d3p-9, -0x1.feccd8ce7f6b8p-11, 0x1.f1e1cd9aff3afp-12,
     -0x1.ef353c4ad1ed7p-13, 0x1.f24a708f97efep-14}, /* [3] 0.3125 <= y <= 0.4375, degree 10, 62.0 bits */
    {0x1.7cae34177005bp+0, -0x1.0817547eac1fep-55, -0x1.abfcef87117b3p-3, 0x1.d85fef580d667p-5, -0x1.46123d9e7c129p-6,
     0x1.f790918120534p-8, -0x1.9faa49759d896p-9, 0x1.668584b6b413p-10, -0x1.3ef742bc4b6ep-11, 0x1.225e05598f4c2p-12,
     -0x1.0da24c237dd4bp-13, 0x1.fabe0aeb74c55p-15}, /* [4] 0.4375 <= y <= 0.5625, degree 10, 62.1 bits */
    {0x1.7636de215cdbcp+0, -0x1.4f330ac7d4a94p-55, -0x1.90427ae95b1bdp-3, 0x1.a0ab0ea61f1d6p-5, -0x1.0e7265e6d1e14p-6,
     0x1.883b4cca2114fp-8, -0x1.2fe0a0888c069p-9, 0x1.ebdc94590a0cep-11, -0x1.9a886f3a2f869p-12, 0x1.5e94e28e584b9p-13,
     -0x1.314ae7b74030ap-14, 0x1.0d16c18ce9428p-15}, /* [5] 0.5625 <= y <= 0.6875, degree 10, 60.9 bits */
    {0x1.7027e41530964p+0, 0x1.0d77989a9be4ap-54, -0x1.77b6580009ac4p-3, 0x1.72360dfb22af6p-5, -0x1.c59b2e2b21d5dp-7,
     0x1.3618af7393ac1p-8, -0x1.c4b7b0f08e73cp-10, 0x1.591d770de85b3p-11, -0x1.0f48c96af91b6p-12, 0x1.b453e4826cda8p-14,
     -0x1.65b760ce04c38p-15, 0x1.28e3a4f82de7p-16}, /* [6] 0.6875 <= y <= 0.8125, degree 10, 60.7 bits */
    {0x1.6a759e65388b4p+0, 0x1.e3c02fdaac65p-55, -0x1.61d4d59de8aeep-3, 0x1.4b0fc9c53878cp-5, -0x1.80260f4ef0aecp-7,
     0x1.f0d5dbde63626p-9, -0x1.56e19ccee806ap-10, 0x1.ee1b50c788e34p-12, -0x1.6f0ce6f43e2b5p-13, 0x1.16ed1a0480321p-14,
     -0x1.b0103dbbb7426p-16, 0x1.52d1ab24c5978p-17}, /* [7] 0.8125 <= y <= 0.9375, degree 10, 63.9 bits */
    {0x1.65163bc489238p+0, 0x1.e0253d464e79bp-55, -0x1.4e353a2ee0da1p-3, 0x1.29c34bb14a4a6p-5, -0x1.482efb84d33e6p-7,
     0x1.92bac2fbfa998p-9, -0x1.0792b79f645c4p-10, 0x1.681823d3fcbcbp-12, -0x1.fb229da9c11dcp-14, 0x1.6d46a979a7755p-15,
     -0x1.0c18d710c30d3p-16, 0x1.8e8194e18e11ep-18}, /* [8] 0.9375 <= y <= 1.0625, degree 10, 61.3 bits */
    {0x1.6001632db8b77p+0, -0x1.6cf46e091e036p-55, -0x1.3c832f8efbf72p-3, 0x1.0d344943b0d3fp-5, -0x1.1a950e6510303p-7,
     0x1.49eb56e8e9a51p-9, -0x1.9aa65346fc3b4p-11, 0x1.0aad88a4d55cdp-12, -0x1.64fe392161268p-14, 0x1.e8c7c3728230cp-16,
     -0x1.54e6e873b410ep-17, 0x1.e1918614dbadep-19}, /* [9] 1.0625 <= y <= 1.1875, degree 10, 61.5 bits */
    {0x1.5b2fec5047e5dp+0, 0x1.b80ebd02c0c9cp-57, -0x1.2c7a05c931f4ap-3, 0x1.e90de87f2d23dp-6, -0x1.ea194536f7e5p-8,
     0x1.10ddb10de7cc9p-9, -0x1.43c4793ae15dcp-11, 0x1.90c2bd53cbadcp-13, -0x1.ff35f4d8343b3p-15, 0x1.4d728ad7dbf97p-16,
     -0x1.bb19e7583151ep-18, 0x1.2a2b790278716p-19}, /* [10] 1.1875 <= y <= 1.3125, degree 10, 61.2 bits */
    {0x1.569ba84407b1cp+0, -0x1.d02c353aabe49p-55, -0x1.1de139c22f21fp-3, 0x1.be1e5409eaf3bp-6, -0x1.abbfa5b06f6ap-8,
     0x1.c749537f9339bp-10, -0x1.0211284c7a12bp-11, 0x1.311e167c3cb59p-13, -0x1.73b5109d6d473p-15,
     0x1.cf0fd5b365153p-17, -0x1.25c37764f533ep-18, 0x1.798274abf808ep-20},
     /* [11] 1.3125 <= y <= 1.4375, degree 10, 62.3 bits */
    {0x1.523f3641599f3p+0, -0x1.9724395985b11p-54, -0x1.1089df13a2c9cp-3, 0x1.988916ec6b35cp-6, -0x1.77877240c2c1ap-8,
     0x1.7ed7d69cc31ap-10, -0x1.9f82311be3c19p-12, 0x1.d6346cca2f314p-14, -0x1.121835ba310ffp-15, 0x1.46bed48e3224cp-17,
     -0x1.8ca67907fd954p-19, 0x1.e7b787aa82c59p-21}, /* [12] 1.4375 <= y <= 1.5625, degree 10, 60.6 bits */
    {0x1.4e15e15bf57efp+0, 0x1.89d99341a2cbbp-54, -0x1.044cac0f87935p-3, 0x1.7773d5323319p-6, -0x1.4b7630413aabcp-8,
     0x1.444352081281dp-10, -0x1.518f15e996a0fp-12, 0x1.6e4e25b8f8e8p-14, -0x1.99759d515e22fp-16, 0x1.d3f5106a041ddp-18,
     -0x1.1045b59ab5bd9p-19, 0x1.40edbb8e0d2fp-21}, /* [13] 1.5625 <= y <= 1.6875, degree 10, 62.1 bits */
    {0x1.4a1b85162fbcp+0, -0x1.aecbdc2b1ceep-55, -0x1.f210f6b260514p-4, 0x1.5a2e0ddaf24edp-6, -0x1.2603bea9feb1p-8,
     0x1.147a26ad4f8c1p-10, -0x1.1488f270e2dd9p-12, 0x1.2041703353805p-14, -0x1.357848def6301p-16,
     0x1.53a9d1d91e81cp-18, -0x1.7b8a3fc6d0d7ep-20, 0x1.ad97a03aa7b34p-22},
     /* [14] 1.6875 <= y <= 1.8125, degree 10, 62.2 bits */
    {0x1.464c773837b9ap+0, 0x1.3f987003943abp-55, -0x1.dd4247fd15063p-4, 0x1.4027d29c37a0ap-6, -0x1.05fd47a343e4ap-8,
     0x1.da5d1a67516ebp-11, -0x1.c8975df035fd4p-13, 0x1.c9e890d0e9455p-15, -0x1.d8e9f3df3f605p-17,
     0x1.f345c1730f84cp-19, -0x1.0c483880dbbdfp-20, 0x1.240fd10425c81p-22},
     /* [15] 1.8125 <= y <= 1.9375, degree 10, 61.6 bits */
    {0x1.42a575bfd20d6p+0, 0x1.f6f7d6fe3f399p-58, -0x1.c9fd24165873cp-4, 0x1.28ead129f4ffap-6, -0x1.d4e0b09117157p-9,
     0x1.99415755f6424p-11, -0x1.7ba390c9ab304p-13, 0x1.6ed83cc7e7912p-15, -0x1.6cfe9c7991ed8p-17,
     0x1.7332a91874514p-19, -0x1.803e3295728c9p-21, 0x1.92e9c4aa30789p-23},
     /* [16] 1.9375 <= y <= 2.0625, degree 10, 63.3 bits */
    {0x1.3f23980806324p+0, -0x1.c4c7b4760af9fp-54, -0x1.b8181f7f1f4f9p-4, 0x1.14150a48195b1p-6, -0x1.a537447bae53bp-9,
     0x1.62f1a46113928p-11, -0x1.3dbfed13af9cap-13, 0x1.283e2b1202a2bp-15, -0x1.1c5823bda60d3p-17,
     0x1.16f2023510958p-19, -0x1.1680d87c71f34p-21, 0x1.19ad2a8b73a78p-23},
     /* [17] 2.0625 <= y <= 2.1875, degree 10, 63.8 bits */
    {0x1.3bc4427e726fcp+0, -0x1.7139f99ad746ap-54, -0x1.a76f67c660747p-4, 0x1.0154c41153253p-6, -0x1.7bc776e55eb4dp-9,
     0x1.355953b0b013ep-11, -0x1.0b9716df98a0cp-13, 0x1.e204a8fa6f772p-16, -0x1.bee4663313301p-18,
     0x1.a76e86d9d6becp-20, -0x1.9847b32694833p-22, 0x1.8eca19b8e26c3p-24},
     /* [18] 2.1875 <= y <= 2.3125, degree 10, 61.7 bits */
    {0x1.38851c63b75dbp+0, 0x1.b58c67fa8f454p-56, -0x1.97e3d95e7c725p-4, 0x1.e0cacc4e10de3p-7, -0x1.5795706d9f459p-9,
     0x1.0ed7d61c4a0d2p-11, -0x1.c54a108dc0cbdp-14, 0x1.8ade11b2df1dcp-16, -0x1.6208fa2a27469p-18, 0x1.445fcb12b0ecp-20,
     -0x1.2e699e4bb5d23p-22, 0x1.1d9a983664c7dp-24}, /* [19] 2.3125 <= y <= 2.4375, degree 10, 62.6 bits */
    {0x1.35640731e61ccp+0, 0x1.7edc4e0f4f088p-54, -0x1.895a41f1df0d3p-4, 0x1.c21a0aba1d0f8p-7, -0x1.37d3ab204d144p-9,
     0x1.dc49502ffc713p-12, -0x1.81fdf9811035cp-14, 0x1.45921a40d2f7dp-16, -0x1.1a9a1c9229cdp-18, 0x1.f54ec02bf5767p-21,
     -0x1.c4652ff9c392fp-23, 0x1.9d8ff72dbcdcdp-25}, /* [20] 2.4375 <= y <= 2.5625, degree 10, 61.6 bits */
    {0x1.325f1759f6067p+0, 0x1.da9f988d0e728p-55, -0x1.7bbac5a4c146p-4, 0x1.a634e8c53772bp-7, -0x1.1bd94c1d160a2p-9,
     0x1.a4755273dc9c4p-12, -0x1.4a5728447aaf2p-14, 0x1.0e108f72bfd82p-16, -0x1.c65f3d0a6beb2p-19,
     0x1.8688bf87220acp-21, -0x1.557e9ce36af4bp-23, 0x1.2e7e258bb554cp-25},
     /* [21] 2.5625 <= y <= 2.6875, degree 10, 62.0 bits */
    {0x1.2f748e1a04093p+0, 0x1.54a8bf10cdfe9p-54, -0x1.6ef05ffac7359p-4, 0x1.8cc774510ea15p-7, -0x1.031ab8d70e1f8p-9,
     0x1.74918163d2a48p-12, -0x1.1c0c52b33ae98p-14, 0x1.c298a00f8a515p-17, -0x1.6fb5fd717ed7ep-19,
     0x1.3290e77e98d64p-21, -0x1.0401776ba37bap-23, 0x1.bec28a93a8c45p-26},
     /* [22] 2.6875 <= y <= 2.8125, degree 10, 62.1 bits */
    {0x1.2ca2d43aead9p+0, -0x1.62ef6406d0154p-55, -0x1.62e87ac76b9efp-4, 0x1.7589ad99a9eb5p-7, -0x1.da47ae7341cdap-10,
     0x1.4b4cacc3e7249p-12, -0x1.eaa7f969f870ap-15, 0x1.79eb062f149f9p-17, -0x1.2b72158110edap-19,
     0x1.e4c4189fd1f04p-22, -0x1.8f234c0ad1a32p-24, 0x1.4ce5e2ac29242p-26},
     /* [23] 2.8125 <= y <= 2.9375, degree 10, 61.5 bits */
    {0x1.29e8758da326dp+0, 0x1.7ad624a443fap-54, -0x1.579296d2cc9d1p-4, 0x1.603d8b40aa0c5p-7, -0x1.b3271f37aecc5p-10,
     0x1.2795300af982ep-12, -0x1.a98bc925dcaa8p-15, 0x1.3e8fe5e76982dp-17, -0x1.ea972130fdd8ap-20,
     0x1.81df42801554fp-22, -0x1.34b3f62d407f5p-24, 0x1.f45571d90f84dp-27},
     /* [24] 2.9375 <= y <= 3.0625, degree 10, 63.4 bits */
    {0x1.27441d08898f7p+0, -0x1.0b4a0f461e744p-58, -0x1.4ce002cf84a02p-4, 0x1.4cad5e2d6dd37p-7, -0x1.903086d30bcd2p-10,
     0x1.088b9ca37adecp-12, -0x1.7288b62fda862p-15, 0x1.0dcebc232108cp-17, -0x1.941d9e307d404p-20,
     0x1.351df3e53e68bp-22, -0x1.e0f636130f54ap-25, 0x1.7b031e18e054dp-27},
     /* [25] 3.0625 <= y <= 3.1875, degree 10, 63.1 bits */
    {0x1.24b4916aad858p+0, 0x1.cbe15d41096d5p-54, -0x1.42c39df70179bp-4, 0x1.3aaa811fe69f3p-7, -0x1.70d9fed438d4p-10,
     0x1.daf0ebcc8d2ddp-13, -0x1.43d6a8121aa88p-15, 0x1.cb16426fec497p-18, -0x1.4ea37fd13578ap-20,
     0x1.f240993607593p-23, -0x1.7939d193db5cap-25, 0x1.2149dd086d194p-27},
     /* [26] 3.1875 <= y <= 3.3125, degree 10, 63.2 bits */
    {0x1.2238b2500dd06p+0, 0x1.e505153e929e4p-54, -0x1.3931a42f671a8p-4, 0x1.2a0c4477b64b9p-7, -0x1.54ae7df847926p-10,
     0x1.ab887593b4a84p-13, -0x1.1c07444ca13cdp-15, 0x1.883dae3f0f875p-18, -0x1.167d4c8e5c012p-20,
     0x1.93da6a472042ep-23, -0x1.29c61585f32d6p-25, 0x1.bcc8b252e4314p-28},
     /* [27] 3.3125 <= y <= 3.4375, degree 10, 61.5 bits */
    {0x1.1fcf75a56f1a4p+0, 0x1.9daf067f7e023p-54, -0x1.301f820b6a8a3p-4, 0x1.1aaf0a2c446bbp-7, -0x1.3b4a4041e9d91p-10,
     0x1.81e25b834b0a6p-13, -0x1.f3e511a082ff5p-16, 0x1.507b8015e71bap-18, -0x1.d1b76792186c4p-21,
     0x1.491d4dd2974dap-23, -0x1.d8fd113699f8p-26, 0x1.5843ec1445219p-28},
     /* [28] 3.4375 <= y <= 3.5625, degree 10, 61.8 bits */
    {0x1.1d77e56d7f988p+0, 0x1.20cbd4111f88dp-54, -0x1.2783af49a8e7fp-4, 0x1.0c7388946a6c2p-7, -0x1.2457dfdf896cfp-10,
     0x1.5d2ce19df91bbp-13, -0x1.b94fe6e91674cp-16, 0x1.21c1f6d6181eep-18, -0x1.87282c3917957p-21,
     0x1.0d969c058194dp-23, -0x1.79d550dc9bf08p-26, 0x1.0c2d590743ccp-28},
     /* [29] 3.5625 <= y <= 3.6875, degree 10, 64.0 bits */
    {0x1.1b311dcb6a7b8p+0, -0x1.7d01e51062988p-55, -0x1.1f558ebba70eep-4, 0x1.fe7c593bfbe17p-8, -0x1.0f8df985cc8f9p-10,
     0x1.3cb84dabef557p-13, -0x1.86c62116f0956p-16, 0x1.f4dcde508027cp-19, -0x1.49efebbb19dp-21, 0x1.bbd1a946b4d6ap-24,
     -0x1.2f7cdb22e1661p-26, 0x1.a463295603d61p-29}, /* [30] 3.6875 <= y <= 3.8125, degree 10, 61.1 bits */
    {0x1.18fa4b48f6dd4p+0, 0x1.9d46b565178e4p-54, -0x1.178d52b13666cp-4, 0x1.e5ed2b3fb302ap-8, -0x1.f95a7eece863dp-11,
     0x1.1ff0bdf4a0396p-13, -0x1.5b05339272985p-16, 0x1.b263567014382p-19, -0x1.176e21b16b60bp-21,
     0x1.6f0738eef9da2p-24, -0x1.ea1aaa917f6e4p-27, 0x1.4b6bf9467c6acp-29},
     /* [31] 3.8125 <= y <= 3.9375, degree 10, 61.7 bits */
    {0x1.16d2a94fe923bp+0, 0x1.8739ddda632cap-58, -0x1.1023e52eaf738p-4, 0x1.cf0e4c43b7601p-8, -0x1.d6fdc9c00ff92p-11,
     0x1.06593a77554e8p-13, -0x1.35030e796caaap-16, 0x1.79fb83e055344p-19, -0x1.db24aac279661p-22,
     0x1.30df21f201163p-24, -0x1.8db7c5e4ab4d4p-27, 0x1.06bd91499065fp-29},
     /* [32] 3.9375 <= y <= 4.0625, degree 10, 61.6 bits */
    {0x1.14b980cfae646p+0, 0x1.b890d83fb7aa9p-54, -0x1.0912d355bb0c1p-4, 0x1.b9b94bc710bd2p-8, -0x1.b7a6a050beb21p-11,
     0x1.df0f78e26ae35p-14, -0x1.13e339ab5be1ap-16, 0x1.49f08a5abc163p-19, -0x1.9575bb0494f8ap-22,
     0x1.fca0c21c1c0dap-25, -0x1.4449e13e8527cp-27, 0x1.a2ccd2d668577p-30},
     /* [33] 4.0625 <= y <= 4.1875, degree 10, 62.0 bits */
    {0x1.12ae27096e3b2p+0, -0x1.80fc3016d622bp-54, -0x1.02543b8318fdbp-4, 0x1.a5cbe4475f0a2p-8, -0x1.9b020ce33809p-11,
     0x1.b643efd8ba8dp-14, -0x1.eddc7250092dp-17, 0x1.20df23dd51f9p-19, -0x1.5b37ac1684f97p-22, 0x1.a9ff50ea7793dp-25,
     -0x1.099f6c5c1407ep-27, 0x1.4f78f64c25daap-30}, /* [34] 4.1875 <= y <= 4.3125, degree 10, 61.1 bits */
    {0x1.10affc7d84545p+0, -0x1.d4c935811282fp-56, -0x1.f7c57b72bf77p-5, 0x1.9327737b841e1p-8, -0x1.80c78b12a1d05p-11,
     0x1.91b57e0e7a6abp-14, -0x1.bb156cb7d1e6bp-17, 0x1.fb4a12db0f539p-20, -0x1.2a584578d308fp-22,
     0x1.662bb0ccda9cbp-25, -0x1.b509b58398d6ep-28, 0x1.0e07832fe2a98p-30},
     /* [35] 4.3125 <= y <= 4.4375, degree 10, 66.0 bits */
    {0x1.0ebe6bf620e46p+0, 0x1.6c31f73a0906fp-56, -0x1.eb72dc0454866p-5, 0x1.81b0864aaef12p-8, -0x1.68b7875615fb9p-11,
     0x1.70dfbf5632d83p-14, -0x1.8e7013f606f69p-17, 0x1.bea7fe783d7b3p-20, -0x1.012de1ed5ee0bp-22,
     0x1.2e4207d11a39bp-25, -0x1.69098ee06992ep-28, 0x1.b4b9b8199d0cfp-31},
     /* [36] 4.4375 <= y <= 4.5625, degree 10, 64.6 bits */
    {0x1.0cd8e9ab6dap+0, 0x1.683293c4386a6p-54, -0x1.dfa790facce8bp-5, 0x1.714e75494f3dep-8, -0x1.529a1c7536d8p-11,
     0x1.5350c68ce45d9p-14, -0x1.6713b3aaae392p-17, 0x1.8a4f534e54c5p-20, -0x1.bcc25ca1c564dp-23, 0x1.fff4b4bfd14ecp-26,
     -0x1.2b721e9886c5bp-28, 0x1.62bc5a94bc3e7p-31}, /* [37] 4.5625 <= y <= 4.6875, degree 10, 65.3 bits */
    {0x1.0afef27e195cep+0, 0x1.38561f2f65d8fp-54, -0x1.d45b4dc43b987p-5, 0x1.61eb0f1925cbp-8, -0x1.3e3e03eaa5c8ep-11,
     0x1.38a63ac266ebfp-14, -0x1.44491fbb73a61p-17, 0x1.5cfb0e26865a2p-20, -0x1.81b7f48735bd7p-23,
     0x1.b30ac65360cdap-26, -0x1.f2a094a77e37ap-29, 0x1.215e46d0848a9p-31},
     /* [38] 4.6875 <= y <= 4.8125, degree 10, 62.7 bits */
    {0x1.09300b459be9p+0, 0x1.6d7ea6dbea8f1p-54, -0x1.c9866e7b4f27bp-5, 0x1.53724e806d3f1p-8, -0x1.2b77b05481eb1p-11,
     0x1.208af3d7b7285p-14, -0x1.2574fa0446b69p-17, 0x1.359d256af28f5p-20, -0x1.4f77c083510cbp-23,
     0x1.72e3b40bc2b31p-26, -0x1.a0ad150e5ad99p-29, 0x1.da068887b0abcp-32},
     /* [39] 4.8125 <= y <= 4.9375, degree 10, 62.7 bits */
    {0x1.076bc02fe1a02p+0, -0x1.ea5db5e3b2bp-57, -0x1.bf21e78c39d1ep-5, 0x1.45d21a6c13a2cp-8, -0x1.1a208ac2bb15fp-11,
     0x1.0ab4fe9858c0fp-14, -0x1.0a130937a80d5p-17, 0x1.1354644e51c4dp-20, -0x1.248fb6a3470d9p-23,
     0x1.3d300c223c54fp-26, -0x1.5d6c91cdfe8ffp-29, 0x1.85c9737179fb2p-32},
     /* [40] 4.9375 <= y <= 5.0625, degree 10, 62.6 bits */
    {0x1.05b1a4305dd26p+0, 0x1.b43d500dba393p-55, -0x1.b5273736ebf4cp-5, 0x1.38fa0e5ee6bb6p-8, -0x1.0a164d0a1c4ap-11,
     0x1.edc7ea66a2de2p-15, -0x1.e364d3e87c054p-18, 0x1.eac8973a6216p-21, -0x1.ffa06d05832p-24, 0x1.101413274e241p-26,
     -0x1.26059072df53cp-29, 0x1.41bada2d47e1dp-32}, /* [41] 5.0625 <= y <= 5.1875, degree 10, 62.4 bits */
    {0x1.0401507cc6a22p+0, 0x1.bab2d6fce012cp-56, -0x1.ab9058b059f0bp-5, 0x1.2cdb4a0f19e4ep-8, -0x1.f674e8a9dc66fp-12,
     0x1.c9bf39901a81ep-15, -0x1.b7e4dde10a058p-18, 0x1.b65d134045881p-21, -0x1.c07e4e9ec0033p-24,
     0x1.d41efe26a8a24p-27, -0x1.f06c6bbc50a6bp-30, 0x1.0a8571930871dp-32},
     /* [42] 5.1875 <= y <= 5.3125, degree 10, 62.3 bits */
    {0x1.025a6415f693p+0, -0x1.b4280ff60feecp-55, -0x1.a257b8ada464p-5, 0x1.216847278acd1p-8, -0x1.dae3900bc189ep-12,
     0x1.a8ed77754d393p-15, -0x1.91001c7fd2747p-18, 0x1.885b673bfb16bp-21, -0x1.8a1b87815d40fp-24,
     0x1.93d53c02822afp-27, -0x1.a4656b7278c16p-30, 0x1.bb1e4f49ae0cap-33},
     /* [43] 5.3125 <= y <= 5.4375, degree 10, 63.6 bits */
    {0x1.00bc835ba13fep+0, -0x1.1b1cc5364bf9bp-55, -0x1.99782b2b9e14fp-5, 0x1.1694b44ce5c1dp-8, -0x1.c147e3660d5a7p-12,
     0x1.8afc3dc222db3p-15, -0x1.6e27818f2f8c8p-18, 0x1.5fe1fd4cd5e9p-21, -0x1.5b20f81e74281p-24, 0x1.5d4f40c5cc277p-27,
     -0x1.651740bcffe7cp-30, 0x1.719b4326aacd2p-33}, /* [44] 5.4375 <= y <= 5.5625, degree 10, 63.8 bits */
    {0x1.fe4eaf5365c68p-1, -0x1.8f0a6dc22d59cp-55, -0x1.90ece24b985b2p-5, 0x1.0c5554aa0ae6dp-8, -0x1.a976471bf6d4dp-12,
     0x1.6f9f8af72acb9p-15, -0x1.4edf7cf5ae276p-18, 0x1.3c3187c1e16c1p-21, -0x1.3270f338522c1p-24,
     0x1.2eee1f81fba28p-27, -0x1.303437702d8dfp-30, 0x1.3565ecf98ae72p-33},
     /* [45] 5.5625 <= y <= 5.6875, degree 10, 62.2 bits */
    {0x1.fb351dfcad558p-1, 0x1.6d533921160ccp-55, -0x1.88b16623cb6c9p-5, 0x1.029fe36446075p-8, -0x1.934796057131ap-12,
     0x1.56945ad4b2b7ep-15, -0x1.32bd0c89fbb7p-18, 0x1.1ca74f97bdd0dp-21, -0x1.0f1cd5a0df00dp-24, 0x1.075d779058968p-27,
     -0x1.03e14323a1402p-30, 0x1.03a1a674727c1p-33}, /* [46] 5.6875 <= y <= 5.8125, degree 10, 66.2 bits */
    {0x1.f82bb74f7e3c2p-1, -0x1.55ced1e0ee108p-55, -0x1.80c18d664767ap-5, 0x1.f2d5f4e0574bep-9, -0x1.7e989b6b24205p-12,
     0x1.3f9f748936e86p-15, -0x1.196347d23ef42p-18, 0x1.00b888ed25627p-21, -0x1.e0b9482b35e58p-25,
     0x1.cb0a14deed872p-28, -0x1.bd3c431ba9fc7p-31, 0x1.b5353b498c5b9p-34},
     /* [47] 5.8125 <= y <= 5.9375, degree 10, 62.6 bits */
    {0x1.f531e7f1cde5ep-1, 0x1.69e6891df6e18p-55, -0x1.791976c54110fp-5, 0x1.e15bf8a84d1cap-9, -0x1.6b499ead14fe9p-12,
     0x1.2a8c65d9a6478p-15, -0x1.02815195ce84fp-18, 0x1.cfdcf5c270f76p-22, -0x1.ab10879005b9ap-25,
     0x1.90fab78bb1394p-28, -0x1.7e65dfad51417p-31, 0x1.71320869cafd6p-34},
     /* [48] 5.9375 <= y <= 6.0625, degree 10, 62.1 bits */
    {0x1.f24724093044ep-1, -0x1.85d2d2ff3330ap-57, -0x1.71b582fedf388p-5, 0x1.d0c200ed56882p-9, -0x1.593dfe001be37p-12,
     0x1.172ca407f9d62p-15, -0x1.dba13ac6cec08p-19, 0x1.a3c6a56cff6bcp-22, -0x1.7c23f389e29b1p-25,
     0x1.5f0d21c75206ep-28, -0x1.49432b829a2d2p-31, 0x1.38a4c49bb5589p-34},
     /* [49] 6.0625 <= y <= 6.1875, degree 10, 63.2 bits */
    {0x1.ef6ae6bc36fp-1, 0x1.e8c5cf87a2b9bp-57, -0x1.6a924f7d83a5dp-5, 0x1.c0f98348702e6p-9, -0x1.485bd6178a7f4p-12,
     0x1.0556cc7f03ea7p-15, -0x1.b626f517fd983p-19, 0x1.7c7f046d0d9b5p-22, -0x1.5303df18e1652p-25, 0x1.34024eb4e91ep-28,
     -0x1.1c34b52b8dee5p-31, 0x1.097a2e7e2a497p-34}, /* [50] 6.1875 <= y <= 6.3125, degree 10, 62.5 bits */
    {0x1.ec9cb1be09373p-1, -0x1.3a604ff9f5b3bp-58, -0x1.63acb17bf80fcp-5, 0x1.b1f51d0a758cap-9, -0x1.388bb4e784217p-12,
     0x1.e9cc00a0e700bp-16, -0x1.9427b185f2f73p-19, 0x1.596f1f69d9269p-22, -0x1.2ee5125a18c4cp-25, 0x1.0ed031c9b6d1p-28,
     -0x1.ebcb734928b77p-32, 0x1.c40b631d616ddp-35}, /* [51] 6.3125 <= y <= 6.4375, degree 10, 62.2 bits */
    {0x1.e9dc0ce33c383p-1, 0x1.b10960d657bb3p-57, -0x1.5d01b19efd64ap-5, 0x1.a3a8778c142cdp-9, -0x1.29b855f4ce53fp-12,
     0x1.cb72accfb730ap-16, -0x1.75447979cf499p-19, 0x1.3a148632bfa01p-22, -0x1.0f1ac81c01fb5p-25,
     0x1.dd3085863a48fp-29, -0x1.aa7b9f4d0c345p-32, 0x1.81d8ada2306d7p-35},
     /* [52] 6.4375 <= y <= 6.5625, degree 10, 64.0 bits */
    {0x1.e72885bf0d2d9p-1, 0x1.c561ecca73acap-55, -0x1.568e87f787218p-5, 0x1.96082f77563b1p-9, -0x1.1bce66e30dd9p-12,
     0x1.af66c20935208p-16, -0x1.5929b9c5108bcp-19, 0x1.1dfe3ea851d9ep-22, -0x1.e6237815b42d3p-26,
     0x1.a53fad67c3693p-29, -0x1.72aafc5341e9ap-32, 0x1.4a288a48d72f2p-35},
     /* [53] 6.5625 <= y <= 6.6875, degree 10, 62.3 bits */
    {0x1.e481af4838066p-1, -0x1.bb2b8f42058eep-57, -0x1.5050986278f09p-5, 0x1.8909beaeb21ddp-9, -0x1.0ebc5324a282dp-12,
     0x1.9573873886f16p-16, -0x1.3f8dbf2a1b799p-19, 0x1.04ca3597116afp-22, -0x1.b4982bc4c1643p-26,
     0x1.7493d1ce19d81p-29, -0x1.42da3ac625179p-32, 0x1.1b2f8f8dbdb24p-35},
     /* [54] 6.6875 <= y <= 6.8125, degree 10, 63.7 bits */
    {0x1.e1e72184b949ep-1, -0x1.0430ed6fe59b8p-55, -0x1.4a456f3c13bf8p-5, 0x1.7ca36881e2714p-9, -0x1.027215d96832p-12,
     0x1.7d69ad7b45787p-16, -0x1.282f6b47ac0abp-19, 0x1.dc462f5b3f362p-23, -0x1.88bc10dc41199p-26,
     0x1.4a241486cf6e3p-29, -0x1.19cb0bbe3effep-32, 0x1.e6ec3fece34d4p-36},
     /* [55] 6.8125 <= y <= 6.9375, degree 10, 62.8 bits */
    {0x1.df58793bdcc08p-1, 0x1.99f2732b318f5p-57, -0x1.446abe5e68d53p-5, 0x1.70cc27eb5056ep-9, -0x1.edc22219f372cp-13,
     0x1.671eafdcc3a6cp-16, -0x1.12d5190157b64p-19, 0x1.b37d0186c8b54p-23, -0x1.61d606951e2b4p-26,
     0x1.25107a992836bp-29, -0x1.ece8b44d35534p-33, 0x1.a3905c1722f23p-36},
     /* [56] 6.9375 <= y <= 7.0625, degree 10, 63.9 bits */
    {0x1.dcd557ae0aa4cp-1, -0x1.6661ac38cae2ap-60, -0x1.3ebe5a632bcddp-5, 0x1.657b9f99db123p-9, -0x1.d7f7d345a94bp-13,
     0x1.526c479cf3fe8p-16, -0x1.fe975203dd011p-20, 0x1.8eb6e5c8b4a13p-23, -0x1.3f46b99aaee35p-26,
     0x1.049b21c98384fp-29, -0x1.aff1903081b77p-33, 0x1.6a50a6e24aa9cp-36},
     /* [57] 7.0625 <= y <= 7.1875, degree 10, 62.2 bits */
    {0x1.da5d6251d3875p-1, -0x1.e266705bc714ep-56, -0x1.393e38221d627p-5, 0x1.5aaa0b92807cp-9, -0x1.c36cceafbb0dfp-13,
     0x1.3f2ff220462d3p-16, -0x1.dacb6062195d8p-20, 0x1.6d82126a152d5p-23, -0x1.2084bd34a1f01p-26,
     0x1.d045555d92beap-30, -0x1.7b3df4c7b9601p-33, 0x1.398b06e2425e3p-36},
     /* [58] 7.1875 <= y <= 7.3125, degree 10, 62.6 bits */
    {0x1.d7f04295c7d58p-1, 0x1.6fd52587a382ap-55, -0x1.33e86a660d394p-5, 0x1.5050343c0cb67p-9, -0x1.b00ab0ac13bd7p-13,
     0x1.2d4a861660bcbp-16, -0x1.b9f585f230238p-20, 0x1.4f7ab9bfcd8eep-23, -0x1.051946fdde6dcp-26,
     0x1.9e3b3a4fc237ap-30, -0x1.4d96ab0e5d8fp-33, 0x1.0fe59687c839bp-36},
     /* [59] 7.3125 <= y <= 7.4375, degree 10, 66.3 bits */
    {0x1.d58da5a6b344cp-1, -0x1.862ff3d665a85p-55, -0x1.2ebb1fd31ca9ap-5, 0x1.466762acaf0c1p-9, -0x1.9dbcefd2045e8p-13,
     0x1.1c9fd5c3b0efep-16, -0x1.9bcdb221e5db2p-20, 0x1.344927ea10226p-23, -0x1.d93ae1c25ab98p-27,
     0x1.722d31341698bp-30, -0x1.25f5c5ce2d0fp-33, 0x1.d882c6b1cfe54p-37},
     /* [60] 7.4375 <= y <= 7.5625, degree 10, 62.0 bits */
    {0x1.d3353c39de778p-1, 0x1.9f0fa2c9064dfp-58, -0x1.29b4a0f982cb8p-5, 0x1.3ce95616416d9p-9, -0x1.8c70afe3d46f1p-13,
     0x1.0d165ca8a92bfp-16, -0x1.80138c5af84b8p-20, 0x1.1ba027169da6cp-23, -0x1.ad6fd49e05f3ap-27,
     0x1.4b52551812554p-30, -0x1.037e48c6c5cd5p-33, 0x1.9b5f7f5ca8b26p-37},
     /* [61] 7.5625 <= y <= 7.6875, degree 10, 61.8 bits */
    {0x1.d0e6ba5b022adp-1, 0x1.2972f14385d4ep-56, -0x1.24d34e9096361p-5, 0x1.33d03a325530cp-9, -0x1.7c14998b2bb4cp-13,
     0x1.fd2dee079ce0bp-17, -0x1.668d8922c98efp-20, 0x1.053b9f2c1e859p-23, -0x1.86360ba8fd105p-27,
     0x1.28fe5aed13fe9p-30, -0x1.caeaa1283f994p-34, 0x1.66d341d78b38p-37},
     /* [62] 7.6875 <= y <= 7.8125, degree 10, 62.6 bits */
    {0x1.cea1d73d9f392p-1, -0x1.f845ec40715a1p-55, -0x1.20159fd654f02p-5, 0x1.2b169e92cb825p-9, -0x1.6c98b65744f8fp-13,
     0x1.e21943c71a6e7p-17, -0x1.4f081dd702e74p-20, 0x1.e1becf46b0b69p-24, -0x1.6306274143c44p-27,
     0x1.0a9d2ed5a0868p-30, -0x1.9678e41aa1591p-34, 0x1.39913e6d3d8e6p-37},
     /* [63] 7.8125 <= y <= 7.9375, degree 10, 63.0 bits */
    {0x1.cc664d1175e8p-1, 0x1.2d36baee96f4dp-56, -0x1.1b7a211009692p-5, 0x1.22b76ebef75dcp-9, -0x1.5dee507d05e87p-13,
     0x1.c8c88557ef656p-17, -0x1.39550eb207257p-20, 0x1.bcac87b78df7fp-24, -0x1.4369f8883208fp-27,
     0x1.df5e9335a8db4p-31, -0x1.689a2cf8b4fb9p-34, 0x1.1282866ecf9bep-37}
     /* [64] 7.9375 <= y <= 8.0625, degree 10, 63.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_time_of_max_overlap)

/* eps beta^(5/3) at zero force, beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-59.6 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_FIRST 2.125
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_STEP 0.25
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_PER_UNIT 4.0
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_ROWS 32
#define COR_ROWS_TAIL_EPS_ZERO_FORCE_END 10.0
COR_ROWS(double, cor_rows_tail_eps_zero_force, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.21fb98ea07f73p+0, 0x1.fd89335c5e90bp-55, 0x1.90e4977fc94d3p-3, -0x1.649a08e8a2143p-4, 0x1.ae3b0804d2ba8p-7,
     0x1.3051215142e74p-8, -0x1.6b500c91dcacap-9, 0x1.9f1a3f128bf7p-12, 0x1.220e289d65f6dp-13, -0x1.41a1f7dc95f6fp-14,
     0x1.647a92dd27032p-17, 0x1.c5dfded857c92p-19}, /* [0] 2 <= y <= 2.25, degree 10, 59.6 bits */
    {0x1.2d2c9a1b02df5p+0, 0x1.339df057f0014p-58, 0x1.3d45deea40a79p-3, -0x1.36cdf764fdafp-4, 0x1.09152641beab4p-6,
     0x1.a4fcdcc1db7e1p-10, -0x1.0db59e43a32d8p-9, 0x1.107da9e5025b1p-11, 0x1.b86a41461a179p-17, -0x1.8dc7fe1bb046bp-15,
     0x1.ca71970cf1ff8p-17, -0x1.08da79a9d2c5ap-21}, /* [1] 2.25 <= y <= 2.5, degree 10, 59.8 bits */
    {0x1.35f0d61760b11p+0, 0x1.9b9014dda77f5p-54, 0x1.ebd40c8a2d3e7p-4, -0x1.03d3c00b93dfep-4, 0x1.10f9cb9f8c368p-6,
     -0x1.fa91b92a14715p-12, -0x1.53b329f01dc33p-10, 0x1.f41cbdeed41d9p-12, -0x1.bab643a50c90dp-15,
     -0x1.4be67e6e2ce0cp-16, 0x1.59e9f54e5c52bp-17, -0x1.ef70f6b5ac187p-20},
     /* [2] 2.5 <= y <= 2.75, degree 10, 60.5 bits */
    {0x1.3cad2f270e08dp+0, 0x1.08dc8beb97561p-54, 0x1.767e82aec4e33p-4, -0x1.a43647ccd2b79p-5, 0x1.fc33606e05ea4p-7,
     -0x1.babad90e46708p-10, -0x1.5b4a049f632abp-11, 0x1.7b897d4077bbp-12, -0x1.30d523ba50aa6p-14,
     -0x1.f7fd5a618e6e6p-20, 0x1.7c97ef797cc1ep-18, -0x1.cca1dae4a0d8p-20},
     /* [3] 2.75 <= y <= 3, degree 10, 61.0 bits */
    {0x1.41c4778852693p+0, -0x1.7d525a895cd81p-55, 0x1.18dffd4cb9061p-4, -0x1.4acc8b6ab32bap-5, 0x1.baaca19738cabp-7,
     -0x1.229cbe9844b54p-9, -0x1.c1078443d54eep-13, 0x1.f2485868c5582p-13, -0x1.1786f99d23e81p-14,
     0x1.b944676730c5cp-18, 0x1.1c33dd37ae66ap-19, -0x1.28bc8895cc1bep-20},
     /* [4] 3 <= y <= 3.25, degree 10, 63.5 bits */
    {0x1.458fd2b490271p+0, 0x1.18c6f5e7d3da1p-55, 0x1.9ff11ab59fb79p-5, -0x1.fd8f281539803p-6, 0x1.6fc89ba28d7c9p-7,
     -0x1.2d02bc1fd0c91p-9, 0x1.015c7a902dda4p-14, 0x1.19f1c00a7aa7ep-13, -0x1.a7e7040a7771ep-15, 0x1.26a9d13ff397ap-17,
     0x1.9dab2aed18456p-24, -0x1.21bc7d35ebed6p-21}, /* [5] 3.25 <= y <= 3.5, degree 10, 61.2 bits */
    {0x1.485b3a651e701p+0, 0x1.b4a10b9adee59p-54, 0x1.30a1b380d171bp-5, -0x1.817ae6310281p-6, 0x1.26f41d819f83bp-7,
     -0x1.15bf1e253a153p-9, 0x1.ac789f4adbbb3p-13, 0x1.005f36bc343b3p-14, -0x1.19aacfcf9fe68p-15, 0x1.07bbe284ff082p-17,
     -0x1.945d81f120a46p-21, -0x1.75f994705478p-23}, /* [6] 3.5 <= y <= 3.75, degree 10, 62.7 bits */
    {0x1.4a64cf64ad0cp+0, 0x1.9fca1c0b701b6p-55, 0x1.ba135c197f4c6p-6, -0x1.1f5210d7e503cp-6, 0x1.cc61685dc5e24p-8,
     -0x1.ddcc998efa3dcp-10, 0x1.0ef353e615126p-12, 0x1.f80863ab78b5ap-17, -0x1.4bd0ccf68c9aap-16,
     0x1.8a6f3deeb0bdep-18, -0x1.f1e00afa23fep-21, 0x1.5a835a61d8e69p-27},
     /* [7] 3.75 <= y <= 4, degree 10, 62.2 bits */
    {0x1.4bddcc95c8b1p+0, -0x1.e17e22b1db7c5p-54, 0x1.3e368023b53b8p-6, -0x1.a70e348c5e674p-7, 0x1.5faa3a762b4e5p-8,
     -0x1.87e1137f880a1p-10, 0x1.10472d7ec2a4fp-12, -0x1.6046d89d5c71p-17, -0x1.51301283a1c4p-17, 0x1.05c79d8bfef8ep-18,
     -0x1.ad68388499e78p-21, 0x1.4f492564c700fp-24}, /* [8] 4 <= y <= 4.25, degree 10, 62.9 bits */
    {0x1.4cec4233b61eap+0, -0x1.313ea6906a4bdp-60, 0x1.c6f7ff54ff90ap-7, -0x1.343f408e495c9p-7, 0x1.0809f5cffe01ep-8,
     -0x1.368ee5cc2ce69p-10, 0x1.ea3e9ef723a15p-13, -0x1.752208f1f5e1dp-16, -0x1.0528b241098ep-18,
     0x1.39ba4d7a99e4ep-19, -0x1.3ac1d116b3f71p-21, 0x1.73bf145841327p-24},
     /* [9] 4.25 <= y <= 4.5, degree 10, 64.5 bits */
    {0x1.4dad0c8bb76fcp+0, -0x1.319381bdc3c2dp-54, 0x1.435159596c55fp-7, -0x1.bd46946fc677cp-8, 0x1.86fbc38a4b2b1p-9,
     -0x1.dfa9acf1903bp-11, 0x1.9d4c718feaa21p-13, -0x1.ae81c87e2ea99p-16, -0x1.964f464d0393ap-22,
     0x1.4fcad00633308p-20, -0x1.9edd5ad69b636p-22, 0x1.32c5f143c4031p-24},
     /* [10] 4.5 <= y <= 4.75, degree 10, 63.4 bits */
    {0x1.4e35b5f119724p+0, 0x1.0dfc1b49ca03dp-54, 0x1.c925bd464191ap-8, -0x1.3f38b94ef3293p-8, 0x1.1e29932de11c3p-9,
     -0x1.6b125c240d188p-11, 0x1.4d78138cee698p-13, -0x1.9c76c41e5d82cp-16, 0x1.723a69c4bce14p-20,
     0x1.2eddd3367f6e2p-21, -0x1.f4c1c5743687cp-23, 0x1.b74a4459f0c29p-25},
     /* [11] 4.75 <= y <= 5, degree 10, 63.8 bits */
    {0x1.4e961d473ebe3p+0, 0x1.1650c5fa86d4p-54, 0x1.41b8dcf10f254p-8, -0x1.c6c9969df3472p-9, 0x1.9ee232ef192cfp-10,
     -0x1.0e7be42fef66p-11, 0x1.04bf735f85165p-13, -0x1.67e28dce493b3p-16, 0x1.15e1bc096c09p-19, 0x1.64fb63417abb2p-23,
     -0x1.13d004b881256p-23, 0x1.1e7a4e1632a2fp-25}, /* [12] 5 <= y <= 5.25, degree 10, 64.2 bits */
    {0x1.4ed9d4380a731p+0, 0x1.094a8cc01e374p-55, 0x1.c30596e8525edp-9, -0x1.422d3a95a94e2p-9, 0x1.2a54cc8cce91ap-10,
     -0x1.8dde1272b7d64p-12, 0x1.8e504524bec6bp-14, -0x1.289f819eda9c1p-16, 0x1.2340ca953d4ffp-19,
     -0x1.68ae21bbdcbbbp-25, -0x1.0c857d9e899dp-24, 0x1.5a47e961d49ffp-26},
     /* [13] 5.25 <= y <= 5.5, degree 10, 65.1 bits */
    {0x1.4f0936745530fp+0, 0x1.9e3ac3d272bbfp-54, 0x1.3b0612eed7862p-9, -0x1.c64674b7d9f3ep-10, 0x1.aa1aa241b90c5p-11,
     -0x1.218ca93e54611p-12, 0x1.2ac311d1eaa2dp-14, -0x1.d689785f4419cp-17, 0x1.099566fbf4253p-19,
     -0x1.21b41d197ce02p-23, -0x1.9c7fef7af3a7bp-26, 0x1.83e3876210c19p-27},
     /* [14] 5.5 <= y <= 5.75, degree 10, 65.1 bits */
    {0x1.4f2a422df7fp+0, -0x1.1b065bcbd510dp-54, 0x1.b6ad4a5668e06p-10, -0x1.3eeb3ba3a7bcdp-10, 0x1.2e82a2e5daed8p-11,
     -0x1.a1c198156a5dap-13, 0x1.b9ca74c8a7b0cp-15, -0x1.6b0b566df50bp-17, 0x1.c12b684af8593p-20,
     -0x1.5db74c46e3941p-23, -0x1.c4377cfa505e8p-29, 0x1.8ace6f1d3f3bcp-28},
     /* [15] 5.75 <= y <= 6, degree 10, 65.1 bits */
    {0x1.4f413c5aede74p+0, -0x1.2257a662040dcp-56, 0x1.30915edc2afc3p-10, -0x1.be1ecb2df3c7p-11, 0x1.ab57b18a80a23p-12,
     -0x1.2b24b078afef1p-13, 0x1.42dfc07b8f81ep-15, -0x1.125b57590a2f7p-17, 0x1.6a323966ad9d8p-20,
     -0x1.522a20dac2eeep-23, 0x1.c79775455fccfp-28, 0x1.56ab829c22508p-29},
     /* [16] 6 <= y <= 6.25, degree 10, 65.1 bits */
    {0x1.4f512b4941226p+0, 0x1.654ed2def0c16p-56, 0x1.a5d5c26c05683p-11, -0x1.36fee4d7248c2p-11, 0x1.2c802f90f0ae8p-12,
     -0x1.a9b92ae29149ep-14, 0x1.d371a7899aa8bp-16, -0x1.980bd88d0819fp-18, 0x1.1aa9cecaa652dp-20,
     -0x1.271caff63c541p-23, 0x1.656471ac0454dp-27, 0x1.874ddcea77af6p-31},
     /* [17] 6.25 <= y <= 6.5, degree 10, 65.3 bits */
    {0x1.4f5c30e172af1p+0, -0x1.eb784576c409ap-54, 0x1.23735f529c26dp-11, -0x1.b0507ba3dcf99p-12, 0x1.a4f5eca20f089p-13,
     -0x1.2d4af5a7808ap-14, 0x1.4faf447d3c22p-16, -0x1.2b935ffd93de4p-18, 0x1.aecb1282bf895p-21, -0x1.e540af43f0522p-24,
     0x1.7787288051c9ap-27, -0x1.8a5b32e1531edp-33}, /* [18] 6.5 <= y <= 6.75, degree 10, 65.4 bits */
    {0x1.4f63cc64f4e12p+0, -0x1.9bbf7a8c9c6fep-58, 0x1.91e29f0932757p-12, -0x1.2bae12e83db51p-12, 0x1.25d4e5de14105p-13,
     -0x1.a874c4c32390cp-15, 0x1.dee3250b413d3p-17, -0x1.b3522e6cf6f2p-19, 0x1.426288258867ap-21,
     -0x1.7fa8ca17737abp-24, 0x1.5523fe50dd9ffp-27, -0x1.33fc9a094bec8p-31},
     /* [19] 6.75 <= y <= 7, degree 10, 65.5 bits */
    {0x1.4f6909e3ade75p+0, 0x1.b10431ff9f877p-54, 0x1.148c9ebd744edp-12, -0x1.9e79efb869a2dp-13, 0x1.98ebf9bc80318p-14,
     -0x1.29c0472ffcb57p-15, 0x1.539fbea488549p-17, -0x1.3993387029ae4p-19, 0x1.dbb8676be02b3p-22,
     -0x1.2716bc735b3dep-24, 0x1.1f191d62df155p-27, -0x1.6e763adbde523p-31},
     /* [20] 7 <= y <= 7.25, degree 10, 65.6 bits */
    {0x1.4f6ca43c8d7dp+0, -0x1.9b1320826ab2bp-54, 0x1.7bee8fff569efp-13, -0x1.1dff4535e85bap-13, 0x1.1bc1902501b73p-14,
     -0x1.a037bfd76d98bp-16, 0x1.df5238cf320bdp-18, -0x1.c0803888e5eb8p-20, 0x1.5b055826d7c52p-22,
     -0x1.bcbe552ef5d7dp-25, 0x1.cceb69b10f531p-28, -0x1.5e95a4d5a6e0bp-31},
     /* [21] 7.25 <= y <= 7.5, degree 10, 65.6 bits */
    {0x1.4f6f1d52359f8p+0, -0x1.d8ad9f21d9f03p-56, 0x1.048e8f4f9ff74p-13, -0x1.89e6a84a8f181p-14, 0x1.88d18430f3e79p-15,
     -0x1.21f7dbcad60d8p-16, 0x1.50c5569040133p-18, -0x1.3ec68a085651p-20, 0x1.f594e0f5eb26fp-23,
     -0x1.49e9e4b32d774p-25, 0x1.6649fd9a653dfp-28, -0x1.2f70a1752bb09p-31},
     /* [22] 7.5 <= y <= 7.75, degree 10, 65.6 bits */
    {0x1.4f70cf2e1b0dep+0, -0x1.133934736fefep-54, 0x1.64d7bd35096bp-14, -0x1.0ec33cfbb1fecp-14, 0x1.0f4859f6224acp-15,
     -0x1.92db6029fd275p-17, 0x1.d76be8e26187ap-19, -0x1.c2c13f2f49c89p-21, 0x1.67b034463abbp-23,
     -0x1.e3660ac4635efp-26, 0x1.101cf465ddef1p-28, -0x1.efbea9447732dp-32},
     /* [23] 7.75 <= y <= 8, degree 10, 65.6 bits */
    {0x1.4f71f813c2ebp+0, 0x1.854563e80a5ep-54, 0x1.e807b816cdf72p-15, -0x1.739ce3caf2a3dp-15, 0x1.75eca2ee6d9c6p-16,
     -0x1.171e41bbd50e3p-17, 0x1.48d6381ef759p-19, -0x1.3d3a477196bb5p-21, 0x1.003fd0cf1cb64p-23,
     -0x1.5e9534868bb23p-26, 0x1.96221e83f0df3p-29, -0x1.85f7f399b3254p-32},
     /* [24] 8 <= y <= 8.25, degree 10, 65.6 bits */
    {0x1.4f72c2f9d5a9fp+0, 0x1.4b18bea87820cp-54, 0x1.4d4abadd6f752p-15, -0x1.fd3c8dd21d8e4p-16, 0x1.0136b2ffdb419p-16,
     -0x1.81dc48fa9fb4cp-18, 0x1.c95e50e2312bcp-20, -0x1.bcb762c92214p-22, 0x1.6b12495d09a2dp-24,
     -0x1.f849f5c3ab50ep-27, 0x1.2af35c0f10a06p-29, -0x1.2abad792ce7ffp-32},
     /* [25] 8.25 <= y <= 8.5, degree 10, 65.6 bits */
    {0x1.4f734d7689b04p+0, -0x1.7e58cf848adfap-54, 0x1.c6af17b2e22fep-16, -0x1.5c69f4bd0e0b2p-16, 0x1.613f952cdfcdcp-17,
     -0x1.0a23eae92fd3ap-18, 0x1.3d34b031775d4p-20, -0x1.369d07cc59bb9p-22, 0x1.ffef087907c1p-25,
     -0x1.6828ade3c4b07p-27, 0x1.b34b36d31898p-30, -0x1.c0c47034b3113p-33},
     /* [26] 8.5 <= y <= 8.75, degree 10, 65.6 bits */
    {0x1.4f73abe05180cp+0, -0x1.9855c99ae42fap-56, 0x1.35cbc7048208ap-16, -0x1.dc209e603001p-17, 0x1.e45d147d7c989p-18,
     -0x1.6e69960076c52p-19, 0x1.b6ea266393ef7p-21, -0x1.b086b11cc8363p-23, 0x1.6763928e233dap-25,
     -0x1.ff62c4878d01bp-28, 0x1.3a11203567699p-30, -0x1.4c04d35869637p-33},
     /* [27] 8.75 <= y <= 9, degree 10, 65.6 bits */
    {0x1.4f73ec2c08a41p+0, 0x1.249db84a4af17p-55, 0x1.a5b5ee03b05e6p-17, -0x1.44ecbeb960a69p-17, 0x1.4b94ed7439545p-18,
     -0x1.f78ef88cf93b7p-20, 0x1.2efc4709e416cp-21, -0x1.2c4aa10388beap-23, 0x1.f6b7d62d53984p-26,
     -0x1.69323000065abp-28, 0x1.c1cf8516e3e0ep-31, -0x1.e56d6f72a686cp-34},
     /* [28] 9 <= y <= 9.25, degree 10, 65.6 bits */
    {0x1.4f7417e9b6bcep+0, 0x1.9b2b203e2495ap-57, 0x1.1ebe749f93b7ap-17, -0x1.baf74f6d33227p-18, 0x1.c55c772950f6bp-19,
     -0x1.597291a0f16a5p-20, 0x1.a175066e247p-22, -0x1.9fe7bca395278p-24, 0x1.5e710c1c2b06p-26, -0x1.fbf5105dd6bc3p-29,
     0x1.40125b4bab6p-31, -0x1.5f6b9abc6b727p-34}, /* [29] 9.25 <= y <= 9.5, degree 10, 65.6 bits */
    {0x1.4f7435a447eb5p+0, -0x1.1cd2d64db82f7p-58, 0x1.85956949c7e24p-18, -0x1.2d9e700d17d1bp-18, 0x1.3589d496b2246p-19,
     -0x1.d93d904ddf2ccp-21, 0x1.1f0e12242cd34p-22, -0x1.1f59915452b58p-24, 0x1.e72321cb6a31bp-27,
     -0x1.63c701f9786a1p-29, 0x1.c508760a4d358p-32, -0x1.f8bb94f49ee1p-35},
     /* [30] 9.5 <= y <= 9.75, degree 10, 65.6 bits */
    {0x1.4f7449d42dbeep+0, -0x1.5db95fa8c573cp-54, 0x1.086bff9ae199cp-18, -0x1.9a5548608701ap-19, 0x1.a62e5aa807a01p-20,
     -0x1.43b25b8eb5823p-21, 0x1.8a19b2f7c13a6p-23, -0x1.8c39f99e47d9bp-25, 0x1.51ad5618ce9c4p-27,
     -0x1.f0a6cd8a73a85p-30, 0x1.3f0f32520ace3p-32, -0x1.69dbc5873d9b5p-35}
     /* [31] 9.75 <= y <= 10, degree 10, 65.6 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_eps_zero_force)

/* duration/beta at zero overlap, beta > exp(2): 64 rows of degree 10 in y = ln(beta), nodes 2.0625 + i 0.125, 2 <= y <= 10.
 * Relative error of the approximation: 2^-57.6 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_FIRST 2.0625
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_STEP 0.125
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_PER_UNIT 8.0
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_ROWS 64
#define COR_ROWS_TAIL_DURATION_ZERO_OVERLAP_END 10.0
COR_ROWS(double, cor_rows_tail_duration_zero_overlap, 64, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.5a6e19e5daa9bp+2, 0x1.dedde502abe9ep-53, 0x1.8e7f9f6327f41p+1, 0x1.899e49f1dd0bdp-3, -0x1.e267874317277p-4,
     0x1.eba572d3653d1p-5, -0x1.e3750cdacfcf2p-6, 0x1.04fadba730342p-6, -0x1.486f447b0f3a2p-7, 0x1.db14a34699a7fp-8,
     -0x1.80a69d3df7c79p-8, 0x1.4f279462dd8d6p-8}, /* [0] 2 <= y <= 2.125, degree 10, 57.6 bits */
    {0x1.7383bcc08a16cp+2, -0x1.0d48153749a7fp-52, 0x1.93ff7728ca56ap+1, 0x1.399e2b785b7e6p-3, -0x1.7822ccc27f0d2p-4,
     0x1.6e6567caa1969p-5, -0x1.4b064c6e50ed3p-6, 0x1.39f7b780035ebp-7, -0x1.51bc13227706bp-8, 0x1.9e650b5e00e43p-9,
     -0x1.1b212eac4ad8p-9, 0x1.9f820ace12363p-10}, /* [1] 2.125 <= y <= 2.25, degree 10, 58.3 bits */
    {0x1.8ce8230e57e54p+2, -0x1.309ef00c6d9ecp-53, 0x1.986394b8f00d2p+1, 0x1.f5dfe961b7dfap-4, -0x1.281861fc98792p-4,
     0x1.16d86fc731fc5p-5, -0x1.d87b1be737ed2p-7, 0x1.94521d735198p-8, -0x1.7d703fde8de3cp-9, 0x1.96c790d5f8978p-10,
     -0x1.e22671aa491efp-11, 0x1.32ba6ddfd34bcp-11}, /* [2] 2.25 <= y <= 2.375, degree 10, 57.9 bits */
    {0x1.a68b8b422b462p+2, 0x1.637b4a0d60b98p-55, 0x1.9be87762c3af4p+1, 0x1.92d781c1ab529p-4, -0x1.d56f18b52a831p-5,
     0x1.aedb001b64725p-6, -0x1.5b629b8b18bafp-7, 0x1.11bc1a824357fp-8, -0x1.ce2db7bea2791p-10, 0x1.b3f03a3f95bc8p-11,
     -0x1.c86e7fabd7495p-12, 0x1.00d7933c27157p-12}, /* [3] 2.375 <= y <= 2.5, degree 10, 58.1 bits */
    {0x1.c0618463e9c26p+2, 0x1.76927d23c6b68p-54, 0x1.9ebc767a7c7a9p+1, 0x1.4421a2371182dp-4, -0x1.7610e8b72915fp-5,
     0x1.509209398e73ap-6, -0x1.05182b5c14316p-7, 0x1.810665a1adfedp-9, -0x1.27c5374ffa238p-10, 0x1.f46253dd816a6p-12,
     -0x1.d4dd68244830ep-13, 0x1.d94bedab94706p-14}, /* [4] 2.5 <= y <= 2.625, degree 10, 59.2 bits */
    {0x1.da602be450604p+2, 0x1.15935c5a31bdap-52, 0x1.a1038b89eaf2ep+1, 0x1.0549460246a5p-4, -0x1.2b415973d678p-5,
     0x1.091d9f7cd17a3p-6, -0x1.8f0b9ac5fefacp-8, 0x1.16da8ed890d19p-9, -0x1.8b741febd66d9p-11, 0x1.2f91ce27d88cp-12,
     -0x1.0122ba2afe52cp-13, 0x1.d673044c7bac3p-15}, /* [5] 2.625 <= y <= 2.75, degree 10, 59.8 bits */
    {0x1.f47f9dc2a2637p+2, -0x1.2f4d40d63eae6p-55, 0x1.a2d9eb0d63b73p+1, 0x1.a5dd6988d9d35p-5, -0x1.e046e221400e4p-6,
     0x1.a453cc63d1739p-7, -0x1.34d74ff64e243p-8, 0x1.9d4ced48d8c7fp-10, -0x1.11de2f751f6ecp-11, 0x1.81a37a3f6ee44p-13,
     -0x1.29bd05913cb9cp-14, 0x1.f19048a3de80ep-16}, /* [6] 2.75 <= y <= 2.875, degree 10, 60.5 bits */
    {0x1.075cc3e4dd163p+3, -0x1.c9dee3154e2ffp-51, 0x1.a455dc871ab3ep+1, 0x1.54f481509a5d3p-5, -0x1.8251860652939p-6,
     0x1.4ed8fbaeed5d7p-7, -0x1.e2c858ccebef7p-9, 0x1.37e13502074bcp-10, -0x1.86688a6411376p-12, 0x1.fd24f211921dcp-14,
     -0x1.68e5373ad9473p-15, 0x1.152c139e5d37ap-16}, /* [7] 2.875 <= y <= 3, degree 10, 58.7 bits */
    {0x1.14846b081cdffp+3, 0x1.6c29127012aa2p-52, 0x1.a589131d95c6bp+1, 0x1.13d0190ee1d35p-5, -0x1.3752cb3db1babp-6,
     0x1.0bc7643a1c8aap-7, -0x1.7c4221832cd8p-9, 0x1.dd80c17a202f4p-11, -0x1.1ce8dbe9ecca7p-12, 0x1.5b42717132ef6p-14,
     -0x1.c6fd1435cb824p-16, 0x1.42d6b92e064f3p-17}, /* [8] 3 <= y <= 3.125, degree 10, 60.0 bits */
    {0x1.21b4b90e1cap+3, 0x1.ac2e7356c30b6p-52, 0x1.a681aea4668ecp+1, 0x1.be8e2096f56c8p-6, -0x1.f68464cd47cdcp-7,
     0x1.ad95e1723503p-8, -0x1.2d535d27b16b8p-9, 0x1.71bff72583dd1p-11, -0x1.a7f71c22078b6p-13, 0x1.e70ca0464f5d2p-15,
     -0x1.28c878ad138e5p-16, 0x1.86d5b429658b1p-18}, /* [9] 3.125 <= y <= 3.25, degree 10, 60.5 bits */
    {0x1.2eec0805dab59p+3, -0x1.cddf0ef134a38p-51, 0x1.a74afe958393ep+1, 0x1.69b4cd3aefd86p-6, -0x1.960aca32f25cp-7,
     0x1.5968ad80fd0f6p-8, -0x1.dfd9e8a37042ap-10, 0x1.20f2a3cc7e1a9p-11, -0x1.407fd04922098p-13, 0x1.5dbffa686c2a6p-15,
     -0x1.8ef632226785ep-17, 0x1.e985f125d96b8p-19}, /* [10] 3.25 <= y <= 3.375, degree 10, 59.8 bits */
    {0x1.3c290338b3013p+3, 0x1.98d7999e3867dp-51, 0x1.a7ee17f517a2dp+1, 0x1.251d59ce3201dp-6, -0x1.4865abd212ab9p-7,
     0x1.1641b2f5bdf1dp-8, -0x1.7f88e75c826edp-10, 0x1.c6f0b2b517a89p-12, -0x1.eaeee09fbd996p-14, 0x1.00473a910b261p-15,
     -0x1.1356e41f0f283p-17, 0x1.3bfff142ecbf1p-19}, /* [11] 3.375 <= y <= 3.5, degree 10, 60.0 bits */
    {0x1.496a973bc0c28p+3, 0x1.af4858bb79b01p-54, 0x1.a87249c86c8c7p+1, 0x1.db3cabaf4407ep-7, -0x1.09ccb975a365fp-7,
     0x1.c100b588bfe7p-9, -0x1.337cb85b2a55p-10, 0x1.6845193f87fb2p-12, -0x1.7c0c3ebaeba22p-14, 0x1.7e124640d9c11p-16,
     -0x1.8501fc468dd2bp-18, 0x1.a33f08752f2b2p-20}, /* [12] 3.5 <= y <= 3.625, degree 10, 59.8 bits */
    {0x1.56afe53b8ff22p+3, -0x1.8d67699eb5aa8p-52, 0x1.a8dd785a3845ep+1, 0x1.815fd2c824536p-7, -0x1.ae87576b5a467p-8,
     0x1.6ab4456cb967fp-9, -0x1.ee3e1f7df29ep-11, 0x1.1ea9b6ec7da4ep-12, -0x1.28cd1d0d432d8p-14, 0x1.20f7e41107baep-16,
     -0x1.187fd7cef6993p-18, 0x1.1d0e6a9f1ad7bp-20}, /* [13] 3.625 <= y <= 3.75, degree 10, 59.6 bits */
    {0x1.63f838d18c2eep+3, 0x1.c584a817f0371p-53, 0x1.a934653d5da8dp+1, 0x1.389440fdbf097p-7, -0x1.5cd7feb1869cp-8,
     0x1.254796a0358dep-9, -0x1.8dfe42bd93e4ap-11, 0x1.c9f281bb193ddp-13, -0x1.d2ebbe00bca15p-15, 0x1.ba7b9c6a2074ep-17,
     -0x1.9bdd2ae0a83e1p-19, 0x1.8c66bb37eddd3p-21}, /* [14] 3.75 <= y <= 3.875, degree 10, 59.4 bits */
    {0x1.7142ffdb7ec5p+3, 0x1.d9ec0cef19507p-53, 0x1.a97ae86e40153p+1, 0x1.fb2af5d90fc41p-8, -0x1.1ac492970cd95p-8,
     0x1.daa9591179f5ap-10, -0x1.40fe7b61aa36p-11, 0x1.6eed292c4aaafp-13, -0x1.717046847495dp-15, 0x1.5644be9731ecp-17,
     -0x1.3328e126488c3p-19, 0x1.19441fdd8b617p-21}, /* [15] 3.875 <= y <= 4, degree 10, 59.2 bits */
    {0x1.7e8fc3ebc82ebp+3, -0x1.b69bdca62c26fp-51, 0x1.a9b41dd944388p+1, 0x1.9b82e327d5c2ap-8, -0x1.ca8f7c66b0017p-9,
     0x1.805ade713b285p-10, -0x1.0338c19546891p-11, 0x1.26bc85df5cfecp-13, -0x1.25b6e3b73c80ep-15,
     0x1.0b0746d0534ddp-17, -0x1.d06bb270ec86ap-20, 0x1.96869a61ceaefp-22},
     /* [16] 4 <= y <= 4.125, degree 10, 61.9 bits */
    {0x1.8bde24ffe31e4p+3, 0x1.a255818797624p-53, 0x1.a9e289c3215e5p+1, 0x1.4df05f3f31b1cp-8, -0x1.73ea60486407bp-9,
     0x1.3763bb186e22p-10, -0x1.a31ab48c77059p-12, 0x1.da7664050ba19p-14, -0x1.d4db019057ddfp-16, 0x1.a3a2b07856a36p-18,
     -0x1.633af6f144867p-20, 0x1.2aa8961b75a27p-22}, /* [17] 4.125 <= y <= 4.25, degree 10, 60.5 bits */
    {0x1.992dd53c37cp+3, -0x1.f4cb6a69262b8p-52, 0x1.aa0835fc0203ep+1, 0x1.0f047451fea63p-8, -0x1.2db45cfeb6ec6p-9,
     0x1.f8c2de5010d1dp-11, -0x1.5314c8b741332p-12, 0x1.7e855979b3ccdp-14, -0x1.7769c71169771p-16,
     0x1.4bae7485f7319p-18, -0x1.1270d55fa47e3p-20, 0x1.bd4f4369ad469p-23},
     /* [18] 4.25 <= y <= 4.375, degree 10, 60.2 bits */
    {0x1.a67e9579c1d8fp+3, 0x1.f9b4d398e1f02p-53, 0x1.aa26c958bb321p+1, 0x1.b7f0a819cdf27p-9, -0x1.e9940817ca766p-10,
     0x1.993ece8877362p-11, -0x1.12859ec46fbdbp-12, 0x1.34cebe095300fp-14, -0x1.2d607ed0ee317p-16,
     0x1.0771a8ce0f891p-18, -0x1.aba8fa66b89c6p-21, 0x1.505153cee5c1fp-23},
     /* [19] 4.375 <= y <= 4.5, degree 10, 60.3 bits */
    {0x1.b3d0327c8caa4p+3, -0x1.d835c445c2d58p-52, 0x1.aa3f9a9ab01dcp+1, 0x1.651978911b949p-9, -0x1.8d4669794ef0cp-10,
     0x1.4be4e6ca1ea9ep-11, -0x1.bcc03061b29a4p-13, 0x1.f323461486eb6p-15, -0x1.e4e8d0c15418p-17, 0x1.a42cc2e6a30c6p-19,
     -0x1.4f99960047b2ap-21, 0x1.00e687c761fc5p-23}, /* [20] 4.5 <= y <= 4.625, degree 10, 59.7 bits */
    {0x1.c12282b244a9p+3, 0x1.6a6c1c4a8129dp-51, 0x1.aa53bfafdf7a8p+1, 0x1.21dfa92276628p-9, -0x1.4268e697172dep-10,
     0x1.0d38eab8c1886p-11, -0x1.686d5ed0030acp-13, 0x1.93bde9d97e5e7p-15, -0x1.86c72e81e84d7p-17,
     0x1.502ecb86c1f2cp-19, -0x1.08f06c96344afp-21, 0x1.8c5a82e39c21fp-24},
     /* [21] 4.625 <= y <= 4.75, degree 10, 61.3 bits */
    {0x1.ce75645ea030ap+3, 0x1.b4f3f8ca758bbp-51, 0x1.aa641a03f36c1p+1, 0x1.d6a0babd1d7d4p-10, -0x1.05ad0a27d22c1p-10,
     0x1.b4d9036116a1ep-12, -0x1.24320c6282d15p-13, 0x1.46cf79e6d6a1dp-15, -0x1.3b5c98fd44b59p-17,
     0x1.0db5ab95543f2p-19, -0x1.a46828e0d0e76p-22, 0x1.3459fc47b84eep-24},
     /* [22] 4.75 <= y <= 4.875, degree 10, 60.0 bits */
    {0x1.dbc8bc20898acp+3, 0x1.7063b0c7d1199p-51, 0x1.aa716075579b1p+1, 0x1.7e0f7ce7a9507p-10, -0x1.a8cbdbddfb177p-11,
     0x1.6278d149d71e2p-12, -0x1.d9e5f4575deecp-14, 0x1.08b0d069f34f2p-15, -0x1.fd94be0e340cdp-18,
     0x1.b1b8666669744p-20, -0x1.4ef01efba7123p-22, 0x1.e340edfdbaa1p-25},
     /* [23] 4.875 <= y <= 5, degree 10, 60.0 bits */
    {0x1.e91c73bf117p+3, 0x1.acdca5d1fd177p-52, 0x1.aa7c2763b36b8p+1, 0x1.362b712d3ac55p-10, -0x1.58d210acdd015p-11,
     0x1.1fa9d4a957e9fp-12, -0x1.80630cf6ade0dp-14, 0x1.acf535d6b0af1p-16, -0x1.9c16a17a0310dp-18,
     0x1.5d5d7e813e6c7p-20, -0x1.0bc2fd8818705p-22, 0x1.7d002adc74ba2p-25},
     /* [24] 5 <= y <= 5.125, degree 10, 61.9 bits */
    {0x1.f67079307aea8p+3, 0x1.c5907f642a50ep-52, 0x1.aa84e735c5f8dp+1, 0x1.f79fe2c346be3p-11, -0x1.17ea3f4214f1fp-11,
     0x1.d2eff9e3c533fp-13, -0x1.37d7929a141e3p-14, 0x1.5bb779166e4e6p-16, -0x1.4d7fd4840665p-18, 0x1.19d53d1bca7e6p-20,
     -0x1.ad546a263b54ap-23, 0x1.2dedd0dfd0f89p-25}, /* [25] 5.125 <= y <= 5.25, degree 10, 60.1 bits */
    {0x1.01e25ee82a3e4p+4, 0x1.114a130a8011bp-50, 0x1.aa8c01a21a25bp+1, 0x1.98e08a595aee8p-11, -0x1.c678882f18291p-12,
     0x1.7aff565fc8f4fp-13, -0x1.fa0e20672bdc3p-15, 0x1.19f2e7090238bp-16, -0x1.0e1037ae51eefp-18,
     0x1.c7421172a00efp-21, -0x1.58fef4c05b545p-23, 0x1.e098bb47e740ep-26},
     /* [26] 5.25 <= y <= 5.375, degree 10, 62.1 bits */
    {0x1.088c9addd873ap+4, 0x1.26a7aacbdd6c9p-52, 0x1.aa91c5f7491bap+1, 0x1.4bf5b5722f5b1p-11, -0x1.70f39c4e39021p-12,
     0x1.33a384118bdbep-13, -0x1.9aa9b152ca971p-15, 0x1.c95af4b3c2738p-17, -0x1.b59af290e796fp-19,
     0x1.700fbaee8a445p-21, -0x1.15c1dc3b0ae5ap-23, 0x1.7fde0b5128b15p-26},
     /* [27] 5.375 <= y <= 5.5, degree 10, 60.6 bits */
    {0x1.0f36eba6235f4p+4, -0x1.d6e19f417055ep-52, 0x1.aa967494b8fa9p+1, 0x1.0d83f5ef46aap-11, -0x1.2b884c197e3aep-12,
     0x1.f374eac95897p-14, -0x1.4d4939bf9bdbep-15, 0x1.7304ad762d4aep-17, -0x1.62afd596679eep-19, 0x1.29cdd83e635cap-21,
     -0x1.bff20af0c09a2p-24, 0x1.33839daa84d2cp-26}, /* [28] 5.5 <= y <= 5.625, degree 10, 60.0 bits */
    {0x1.15e14d564f1e6p+4, 0x1.458ec24ac91f7p-51, 0x1.aa9a41bb545c2p+1, 0x1.b5a3ad46a787fp-12, -0x1.e65bf882b8dfap-13,
     0x1.9574770f41485p-14, -0x1.0e82c4a844a63p-15, 0x1.2d0772189924ep-17, -0x1.1f93106c739d3p-19,
     0x1.e23acd68bdb85p-22, -0x1.69ab07d25cd62p-24, 0x1.ede5dc91fff5fp-27},
     /* [29] 5.625 <= y <= 5.75, degree 10, 60.3 bits */
    {0x1.1c8bbcc048a08p+4, 0x1.d407c6bc9f6d1p-51, 0x1.aa9d57d621dcep+1, 0x1.63528e4c516fbp-12, -0x1.8add40291b2f5p-13,
     0x1.4927f4dccffd1p-14, -0x1.b725f72631672p-16, 0x1.e88d005d1fb43p-18, -0x1.d272326230a84p-20,
     0x1.86a3fed60e402p-22, -0x1.24504375952dp-24, 0x1.8d6d27e35e7dp-27},
     /* [30] 5.75 <= y <= 5.875, degree 10, 60.6 bits */
    {0x1.2336374f23a69p+4, -0x1.175be55af3deap-50, 0x1.aa9fd95488623p+1, 0x1.207da4462d569p-12, -0x1.4095faddbed3ep-13,
     0x1.0b38f360f731ap-14, -0x1.647a15e3faef2p-16, 0x1.8c7c7bf873debp-18, -0x1.7a5eb992b0412p-20,
     0x1.3c954fe7f6108p-22, -0x1.d8eb43687becdp-25, 0x1.4054a227d8ed4p-27},
     /* [31] 5.875 <= y <= 6, degree 10, 60.2 bits */
    {0x1.29e0baea48affp+4, 0x1.d987a5b0a5ee2p-50, 0x1.aaa1e22b2142ep+1, 0x1.d4760f4645033p-13, -0x1.04486e044308p-13,
     0x1.b1e4db7a45e11p-15, -0x1.2161a83461dc3p-16, 0x1.41cc9408d8651p-18, -0x1.32fa95973b61dp-20,
     0x1.00a7d612febd7p-22, -0x1.7ed20bf2eeb28p-25, 0x1.02898aaf06ee7p-27},
     /* [32] 6 <= y <= 6.125, degree 10, 61.0 bits */
    {0x1.308b45de100ep+4, 0x1.d97b7b0a6969ep-51, 0x1.aaa3890c00c33p+1, 0x1.7c5a724c99aecp-13, -0x1.a6a66775d51ffp-14,
     0x1.60445ef9fc8afp-15, -0x1.d5d898506fc2bp-17, 0x1.05331fac00451p-18, -0x1.f22fd45cd76dep-21,
     0x1.a0433a91f6494p-23, -0x1.36101aba03975p-25, 0x1.a1c8e83a2b542p-28},
     /* [33] 6.125 <= y <= 6.25, degree 10, 60.6 bits */
    {0x1.3735d6c8c4519p+4, -0x1.aa270055a9985p-51, 0x1.aaa4e06427c1ap+1, 0x1.34d15d77926b6p-13, -0x1.572776558c0cep-14,
     0x1.1e0020fcbd30ep-15, -0x1.7d6ff004ab0ep-17, 0x1.a80c76878b7ap-19, -0x1.944b0fe2a6965p-21, 0x1.51a3f35821ff7p-23,
     -0x1.f67fbfd2c4485p-26, 0x1.51df6086b979bp-28}, /* [34] 6.25 <= y <= 6.375, degree 10, 60.5 bits */
    {0x1.3de06c8b37b3ep+4, -0x1.cd37300fc8c04p-50, 0x1.aaa5f72938f1fp+1, 0x1.f579765510ee4p-14, -0x1.169cbb4e0ab8p-14,
     0x1.d0679e50b6558p-16, -0x1.35abd5f72f4d2p-17, 0x1.583afd6c8289cp-19, -0x1.482071a02cd09p-21,
     0x1.11eb66b6a8bdep-23, -0x1.9755cb2266955p-26, 0x1.117413e7d55efp-28},
     /* [35] 6.375 <= y <= 6.5, degree 10, 61.1 bits */
    {0x1.448b063c402a9p+4, -0x1.345408681c7a1p-50, 0x1.aaa6d9807234dp+1, 0x1.9729401a8f66bp-14, -0x1.c46be3d7dd14bp-15,
     0x1.790d301c74b81p-16, -0x1.f6d33899cab1cp-18, 0x1.17726dace749p-19, -0x1.0a5479709003cp-21, 0x1.bc844a4ba5b96p-24,
     -0x1.4a4afa6c5a5c9p-26, 0x1.bae3114397d91p-29}, /* [36] 6.5 <= y <= 6.625, degree 10, 61.9 bits */
    {0x1.4b35a31e8e538p+4, -0x1.887554f03dfaap-51, 0x1.aaa7914637079p+1, 0x1.4a960dead6fep-14, -0x1.6f54ccd6f6196p-15,
     0x1.3221ad88f885ap-16, -0x1.983c0bbf92178p-18, 0x1.c5b9b44e83a08p-20, -0x1.b05eb15d1842dp-22,
     0x1.68b9d92cc28a3p-24, -0x1.0be3c90a9e079p-26, 0x1.66d0d37b427a6p-29},
     /* [37] 6.625 <= y <= 6.75, degree 10, 60.8 bits */
    {0x1.51e042986dbebp+4, -0x1.a66690f643bedp-50, 0x1.aaa8267c18204p+1, 0x1.0c69bfbdd95f8p-14, -0x1.2a3edb074fa25p-15,
     0x1.f11ae9640ffd7p-17, -0x1.4b71419c86274p-18, 0x1.705b22a54fbecp-20, -0x1.5efaf459899fp-22, 0x1.24c246bc2b2d5p-24,
     -0x1.b2a4965c718d1p-27, 0x1.22d56b5e6bf96p-29}, /* [38] 6.75 <= y <= 6.875, degree 10, 64.2 bits */
    {0x1.588ae42d127c9p+4, -0x1.6ea9e5006241dp-51, 0x1.aaa89fa2263c6p+1, 0x1.b3ddc36c58fd8p-15, -0x1.e44eb2a266306p-16,
     0x1.939bd97b71565p-17, -0x1.0d19257f3234bp-18, 0x1.2b0e1eebe52edp-20, -0x1.1cec59885288cp-22,
     0x1.db3c0bb2c79dap-25, -0x1.60a6e867dd78ap-27, 0x1.d7a3b9e60008bp-30},
     /* [39] 6.875 <= y <= 7, degree 10, 62.4 bits */
    {0x1.5f358777292f6p+4, -0x1.216e183bad98fp-50, 0x1.aaa901ff7635fp+1, 0x1.61e4e1e33640ap-15, -0x1.89392788af6c4p-16,
     0x1.47b2e1bc87debp-17, -0x1.b4f72f28b42edp-19, 0x1.e597b5267e62ep-21, -0x1.ce9cd771c1815p-23, 0x1.81bfe5146688p-25,
     -0x1.1e29ece46114cp-27, 0x1.7e7dd4e36f763p-30}, /* [40] 7 <= y <= 7.125, degree 10, 62.8 bits */
    {0x1.65e02c246cf07p+4, -0x1.9787b84da33edp-51, 0x1.aaa951dd0058ep+1, 0x1.1f56a227e52a5p-15, -0x1.3f451a021e5e7p-16,
     0x1.0a1110031ec45p-17, -0x1.62c722bca0359p-19, 0x1.8a3f4d89a3dfbp-21, -0x1.779173ba162d1p-23,
     0x1.3921ac6429b15p-25, -0x1.d07acfd8815c4p-28, 0x1.363d1b731702fp-30},
     /* [41] 7.125 <= y <= 7.25, degree 10, 60.6 bits */
    {0x1.6c8ad1f211c76p+4, -0x1.a20cea8b99bf8p-50, 0x1.aaa992b56c58dp+1, 0x1.d29980a09e3a2p-16, -0x1.0339aed38f7a3p-16,
     0x1.b00da1e0ebabbp-18, -0x1.200cdbcad53c1p-19, 0x1.4016aa67a25c4p-21, -0x1.30e893280866dp-23,
     0x1.fc63862d359f9p-26, -0x1.78fdaced14b31p-28, 0x1.f771d3a7f1e3cp-31},
     /* [42] 7.25 <= y <= 7.375, degree 10, 61.9 bits */
    {0x1.733578a9dbb58p+4, -0x1.890bac61b2bp-51, 0x1.aaa9c75bdf7a4p+1, 0x1.7ad928d0b7abcp-16, -0x1.a4f2681834f04p-17,
     0x1.5ecbde9369ccap-18, -0x1.d3bf7696519bbp-20, 0x1.03e1abf7421e3p-21, -0x1.ef183997f9886p-24,
     0x1.9cb703d536a4ep-26, -0x1.31fe5ceb1d16dp-28, 0x1.98949994b7caap-31},
     /* [43] 7.375 <= y <= 7.5, degree 10, 61.4 bits */
    {0x1.79e0201fc1dfp+4, -0x1.5210d77f7db51p-51, 0x1.aaa9f21b7e0abp+1, 0x1.33999f4e6d7bfp-16, -0x1.55c7df867cc84p-17,
     0x1.1cd274d83615ap-18, -0x1.7bc68d34a8d87p-20, 0x1.a600568fbb10bp-22, -0x1.91f5d8c478d05p-24,
     0x1.4f0eb643856f2p-26, -0x1.f0c25991792c8p-29, 0x1.4b82cf989d589p-31},
     /* [44] 7.5 <= y <= 7.625, degree 10, 61.6 bits */
    {0x1.808ac83003763p+4, -0x1.83aff22d3ccfdp-50, 0x1.aaaa14d0ffbd5p+1, 0x1.f380a9bcd7669p-17, -0x1.1580dab8b2cf7p-17,
     0x1.ce830b4eb89d2p-19, -0x1.345985f34873cp-20, 0x1.56a127b5c725cp-22, -0x1.4659765bff516p-24,
     0x1.1004bd773aee7p-26, -0x1.9345600c6830dp-29, 0x1.0cfded7786ecdp-31},
     /* [45] 7.625 <= y <= 7.75, degree 10, 60.6 bits */
    {0x1.873570bd99036p+4, 0x1.4d94e569b133fp-50, 0x1.aaaa30ff74546p+1, 0x1.9590544773b4cp-17, -0x1.c2a101b0c1d21p-18,
     0x1.77873d79f0c05p-19, -0x1.f4b72b512a246p-21, 0x1.16300a41f9f3p-22, -0x1.08f6c9ee21217p-24, 0x1.b9af099e8c0ccp-27,
     -0x1.47627e174db3cp-29, 0x1.b4e31eb84d9fdp-32}, /* [46] 7.75 <= y <= 7.875, degree 10, 61.9 bits */
    {0x1.8de019b0f0aa5p+4, -0x1.6050cb5345231p-52, 0x1.aaaa47e1204c6p+1, 0x1.494aa88f7912bp-17, -0x1.6de19937ce83cp-18,
     0x1.30e75e94f8e5bp-19, -0x1.968bb3d70ebcbp-21, 0x1.c3bbd96323299p-23, -0x1.ae4106659f346p-25,
     0x1.66983ff6ea266p-27, -0x1.09c13cf4ac1d5p-29, 0x1.62b510aead916p-32},
     /* [47] 7.875 <= y <= 8, degree 10, 60.9 bits */
    {0x1.948ac2f6e7517p+4, 0x1.394d93154ea2cp-50, 0x1.aaaa5a752da2cp+1, 0x1.0b5d162f66dccp-17, -0x1.29125ff235ec5p-18,
     0x1.ef1f8d9e44979p-20, -0x1.4a1645dac1d9cp-21, 0x1.6ec626e5e60dep-23, -0x1.5d54489124f96p-25,
     0x1.23251a2e75eedp-27, -0x1.af8285c680fdp-30, 0x1.1f938c2aec21dp-32},
     /* [48] 8 <= y <= 8.125, degree 10, 61.4 bits */
    {0x1.9b356c7ff3391p+4, -0x1.960c10431599ap-50, 0x1.aaaa698ac96fbp+1, 0x1.b22a07d5f43d4p-18, -0x1.e267f4ebf640cp-19,
     0x1.9201e8c3bca47p-20, -0x1.0c02171f3b482p-21, 0x1.29cb3f40d6982p-23, -0x1.1ba04fe94b334p-25,
     0x1.d8c1ab291248fp-28, -0x1.5e65951ba3283p-30, 0x1.d32169adb0e05p-33},
     /* [49] 8.125 <= y <= 8.25, degree 10, 60.9 bits */
    {0x1.a1e0163f76b47p+4, 0x1.a9d527bd64fb8p-50, 0x1.aaaa75ca2a4fbp+1, 0x1.60837396eacacp-18, -0x1.87aebe67fd802p-19,
     0x1.46675b3a52792p-20, -0x1.b3358cb0a894p-22, 0x1.e39341b934d94p-24, -0x1.cc90e494d7ba2p-26, 0x1.7fd32ec3a6113p-28,
     -0x1.1c6ba65a1cd57p-30, 0x1.7c30c33a2fe3ap-33}, /* [50] 8.25 <= y <= 8.375, degree 10, 62.2 bits */
    {0x1.a88ac02b337a6p+4, 0x1.85905bf4a3fd6p-52, 0x1.aaaa7fbbe4457p+1, 0x1.1e37e7af78a9cp-18, -0x1.3e05632cc3387p-19,
     0x1.0904c175c64cp-20, -0x1.615c618f5f523p-22, 0x1.88a11495fffabp-24, -0x1.75f207a7ea66ap-26, 0x1.37a5e846f3da4p-28,
     -0x1.cdb91383b31b4p-31, 0x1.336f528c15fefp-33}, /* [51] 8.375 <= y <= 8.5, degree 10, 62.0 bits */
    {0x1.af356a3ad86a2p+4, 0x1.f9d77a2657878p-52, 0x1.aaaa87cedbcf4p+1, 0x1.d0c833aa86453p-19, -0x1.023670839bcd2p-19,
     0x1.ae5b15516da31p-21, -0x1.1ee7dc5980c3ep-22, 0x1.3ec9c2a4e0a2dp-24, -0x1.2f9d1c31ddce6p-26,
     0x1.fa0ffc3b9254dp-29, -0x1.772ed42668348p-31, 0x1.f2546722829efp-34},
     /* [52] 8.5 <= y <= 8.625, degree 10, 63.3 bits */
    {0x1.b5e01467a4cccp+4, 0x1.acff4db85144ap-50, 0x1.aaaa8e5d1a898p+1, 0x1.795f91b4ea81ep-19, -0x1.a34de1dc141b1p-20,
     0x1.5d6bcc8f6245ap-21, -0x1.d1e5ad9409c8ep-23, 0x1.02d5acceae55fp-24, -0x1.ed0790227f9ep-27, 0x1.9ad580cb2403p-29,
     -0x1.306f3d9bc1505p-31, 0x1.9a31cd9d7dfbp-34}, /* [53] 8.625 <= y <= 8.75, degree 10, 61.1 bits */
    {0x1.bc8abeac1d076p+4, -0x1.0c73e347b3e7p-50, 0x1.aaaa93afbb3efp+1, 0x1.32672d7a33247p-19, -0x1.5472bbba09c87p-20,
     0x1.1bb518fb947f1p-21, -0x1.7a473260ecda4p-23, 0x1.a44fe327858p-25, -0x1.904edb906c298p-27, 0x1.4da347c51709cp-29,
     -0x1.edb1b4d0b91d4p-32, 0x1.46a58902d2b72p-34}, /* [54] 8.75 <= y <= 8.875, degree 10, 61.3 bits */
    {0x1.c3356903cd76bp+4, -0x1.abac028c319a8p-51, 0x1.aaaa980219236p+1, 0x1.f18f36a61f46bp-20, -0x1.146c115295359p-20,
     0x1.ccb450297a2d6p-22, -0x1.33232894fcf07p-23, 0x1.554420bd80fffp-25, -0x1.4502e81eaae37p-27,
     0x1.0edc90e620343p-29, -0x1.92a70b3e277bp-32, 0x1.07daaea5bd2ecp-34},
     /* [55] 8.875 <= y <= 9, degree 10, 62.0 bits */
    {0x1.c9e0136b18cabp+4, -0x1.2ac67b7fac514p-50, 0x1.aaaa9b8465bdcp+1, 0x1.93fc8c8130982p-20, -0x1.c0dfccf7770b8p-21,
     0x1.760ff722aa2d6p-22, -0x1.f2c045907aa3fp-24, 0x1.151607231f40ap-25, -0x1.07e744fbb6b7cp-27, 0x1.b7a93d4892ep-30,
     -0x1.44bc006889658p-32, 0x1.d0f6ad86d003fp-35}, /* [56] 9 <= y <= 9.125, degree 10, 61.4 bits */
    {0x1.d08abddf0fb7ep+4, 0x1.7be635a76f4ccp-51, 0x1.aaaa9e5dc2556p+1, 0x1.4802e44063576p-20, -0x1.6c750afa9486bp-21,
     0x1.2fb6f57db7f1cp-22, -0x1.94f434829500dp-24, 0x1.c1f2b392f9c1fp-26, -0x1.ac8437a59f4d1p-28,
     0x1.657f584b94c37p-30, -0x1.088229fbf5317p-32, 0x1.260459f64598fp-35},
     /* [57] 9.125 <= y <= 9.25, degree 10, 62.2 bits */
    {0x1.d735685d503d8p+4, -0x1.c782def462308p-50, 0x1.aaaaa0adf44dap+1, 0x1.0a530301cb7b4p-20, -0x1.27ea7dfdda90ep-21,
     0x1.ed3198107e1cap-23, -0x1.48cbdf28fe819p-24, 0x1.6d55d60f8171dp-26, -0x1.5bee607f3b9c1p-28,
     0x1.2147f4561ea77p-30, -0x1.b41f42ac9256ap-33, 0x1.7b366d770d4ffp-35},
     /* [58] 9.25 <= y <= 9.375, degree 10, 61.1 bits */
    {0x1.dde012e3eb12dp+4, -0x1.e237745f489fap-50, 0x1.aaaaa28ec770ep+1, 0x1.b07a0699c2bbfp-21, -0x1.e087a12a08b4cp-22,
     0x1.90711cbec283cp-23, -0x1.0af62d070466dp-24, 0x1.289df594cc85dp-26, -0x1.1a889c7f7ebfcp-28,
     0x1.d95a0e2129433p-31, -0x1.4812d6179e18dp-33, 0x1.2691f4477a8afp-37},
     /* [59] 9.375 <= y <= 9.5, degree 10, 61.0 bits */
    {0x1.e48abd714e145p+4, -0x1.d9d8ff4ce8d41p-50, 0x1.aaaaa4152d9a1p+1, 0x1.5f24bc4362bc7p-21, -0x1.8628d90164083p-22,
     0x1.452212705f134p-23, -0x1.b182d2d4f7c42p-25, 0x1.e1b641ec770cdp-27, -0x1.caa72f7d1eacp-29, 0x1.77b7ca371658bp-31,
     -0x1.53f86e3c3f31ap-33, 0x1.53af05d68413cp-34}, /* [60] 9.5 <= y <= 9.625, degree 10, 61.9 bits */
    {0x1.eb35680432bf2p+4, 0x1.096f56d23c67ep-50, 0x1.aaaaa5522845p+1, 0x1.1d1b2cc810fbp-21, -0x1.3cc8e102db451p-22,
     0x1.07fcc8dd30352p-23, -0x1.5ffc7b89cc1c9p-25, 0x1.87071933e2e5ap-27, -0x1.73ec9ce59ec8ap-29, 0x1.50870d73eafdp-31,
     -0x1.09719aa4aec99p-34, -0x1.c566a1d3ebd3cp-32}, /* [61] 9.625 <= y <= 9.75, degree 10, 61.3 bits */
    {0x1.f1e0129b8ff83p+4, -0x1.5788f1df77313p-51, 0x1.aaaaa6538632p+1, 0x1.cef9dfe4433c7p-22, -0x1.0135803e06b6cp-22,
     0x1.acaeb0f4fadfcp-24, -0x1.1dc74ec3299a6p-25, 0x1.3d67e50028e65p-27, -0x1.375555de03ee3p-29,
     0x1.5ddc95392f366p-32, 0x1.228232c89d736p-30, 0x1.dd152b5bece07p-28},
     /* [62] 9.75 <= y <= 9.875, degree 10, 60.8 bits */
    {0x1.f88abd368e7f9p+4, 0x1.482ed8745f69cp-52, 0x1.aaaaa7247d5eep+1, 0x1.77e836abd620cp-22, -0x1.a1acb43ef59f5p-23,
     0x1.5c116e47032a5p-24, -0x1.cfcb2d1d661fep-26, 0x1.00651e89b5027p-27, -0x1.2b76d9bf39ebfp-28,
     -0x1.01e275f344eaep-25, -0x1.03e6682b92a3fp-22, -0x1.203fefff14853p-20}
     /* [63] 9.875 <= y <= 10, degree 10, 63.5 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_duration_zero_overlap)

/* duration beta^(2/3) at zero force, beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-57.7 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_FIRST 2.125
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_STEP 0.25
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_PER_UNIT 4.0
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_ROWS 32
#define COR_ROWS_TAIL_DURATION_ZERO_FORCE_END 10.0
COR_ROWS(double, cor_rows_tail_duration_zero_force, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.c772f8828a511p+2, 0x1.7a8a204bcfe29p-53, 0x1.42cb7da371d6p+1, 0x1.47f1ef06bb8cp-3, -0x1.f9496898b0b3bp-6,
     0x1.6ad949c80f8e9p-11, 0x1.b3c271e7970acp-11, -0x1.4c0cc8f9d1221p-14, -0x1.ba55fa34836dcp-16,
     0x1.8b38b6dc1305bp-19, 0x1.e51b234360583p-20, -0x1.96cecd58a592fp-22},
     /* [0] 2 <= y <= 2.25, degree 10, 57.7 bits */
    {0x1.f0688ab0bbbb3p+2, 0x1.fd667c15ee296p-56, 0x1.4c4f805929587p+1, 0x1.195c811e9bb92p-3, -0x1.e5e5e2e9875d2p-6,
     0x1.aecd64e86a48fp-10, 0x1.651f5b965cc2bp-11, -0x1.ef6bf0589e126p-14, -0x1.20740ce997d18p-16,
     0x1.85c8e0c0cd4a7p-18, 0x1.7aa1b93c2cd83p-21, -0x1.e8bf5c5283b5ap-22},
     /* [1] 2.25 <= y <= 2.5, degree 10, 58.6 bits */
    {0x1.0d3bd77dfdae1p+3, 0x1.1ac235800e90fp-51, 0x1.5467f55a82cc4p+1, 0x1.da8c2018515f9p-4, -0x1.c4a2bc72fd11bp-6,
     0x1.3778c5decf621p-9, 0x1.fe60d3358da8fp-12, -0x1.204f3071a2fa3p-13, -0x1.425ddc9f11c38p-18, 0x1.a05b1d277ecd4p-18,
     -0x1.3ac662a3c5dbp-22, -0x1.5a1d81d609705p-22}, /* [2] 2.5 <= y <= 2.75, degree 10, 59.1 bits */
    {0x1.22ba3376cc58cp+3, 0x1.efb660c708127p-51, 0x1.5b2d8fa959eb6p+1, 0x1.899b449966cc6p-4, -0x1.996d40deba7d2p-6,
     0x1.76324f4185b32p-9, 0x1.24fff9da1b32ap-12, -0x1.1c78f548ddd86p-13, 0x1.af2062c463efp-18, 0x1.42ec4c048fdadp-18,
     -0x1.ccad1e7eb3642p-21, -0x1.16cd18ed58614p-23}, /* [3] 2.75 <= y <= 3, degree 10, 58.1 bits */
    {0x1.389b24e3904ccp+3, 0x1.4a31bdfe75acbp-53, 0x1.60c073c62e7d6p+1, 0x1.415efd7c4a70ap-4, -0x1.68778cc41d8ccp-6,
     0x1.93ed85a5f997p-9, 0x1.71ba5939c5bfcp-14, -0x1.eb889f077bc53p-14, 0x1.d41633dd381e4p-17, 0x1.667fc19d08c5cp-19,
     -0x1.05fc5bfbd65abp-20, 0x1.a7d31408b6ba2p-26}, /* [4] 3 <= y <= 3.25, degree 10, 61.4 bits */
    {0x1.4ecca06eb6b3cp+3, 0x1.a8a0abbb1177bp-51, 0x1.65451b81d0b83p+1, 0x1.028bead02ea1cp-4, -0x1.35a3dac875956p-6,
     0x1.950cd30422dfbp-9, -0x1.1af2b5fc2d275p-14, -0x1.76c1bbb20240fp-14, 0x1.205e3c236a9c4p-16, 0x1.5542c52462912p-21,
     -0x1.abe2c9ff602fp-21, 0x1.c880d2994979bp-24}, /* [5] 3.25 <= y <= 3.5, degree 10, 59.3 bits */
    {0x1.653ef17ec21cep+3, 0x1.d69bf4ff75efcp-54, 0x1.68e172bc1761cp+1, 0x1.9a585990baf81p-5, -0x1.041e44c85d03cp-6,
     0x1.8042cd41d4546p-9, -0x1.76d478075c5bbp-13, -0x1.efdc36e074d59p-15, 0x1.1b338ad52f9e8p-16,
     -0x1.be08209fa50fcp-21, -0x1.0bf54174a0b95p-21, 0x1.08d2c013fb8cp-23},
     /* [6] 3.5 <= y <= 3.75, degree 10, 60.8 bits */
    {0x1.7be4bd92d6f01p+3, 0x1.8dceacbf14be1p-53, 0x1.6bba792d302ffp+1, 0x1.418d722ab0116p-5, -0x1.ac5cf7d7c4569p-7,
     0x1.5ce30145e133dp-9, -0x1.0225577b3d393p-12, -0x1.08ead94188e52p-15, 0x1.e086645508af3p-17,
     -0x1.b30e0417dc4a6p-20, -0x1.c93735ffa4072p-23, 0x1.b3ef2885317f9p-24},
     /* [7] 3.75 <= y <= 4, degree 10, 61.1 bits */
    {0x1.92b2e6e94325dp+3, -0x1.5c58469eba24dp-52, 0x1.6df28c7ea9ea6p+1, 0x1.f22ac0409ffap-6, -0x1.5a7215317bea3p-7,
     0x1.31a2efb592d72p-9, -0x1.21ae45b2a63bfp-12, -0x1.40ab0b4d82c21p-17, 0x1.69921df145791p-17,
     -0x1.ef6e9ae0eb1e6p-20, -0x1.a40aa6b9a9389p-29, 0x1.1a3e0888e7973p-24},
     /* [8] 4 <= y <= 4.25, degree 10, 59.8 bits */
    {0x1.a9a0591d884cdp+3, 0x1.8f60aa8b9d291p-52, 0x1.6fa85ad0d2b89p+1, 0x1.7ddd15243f27bp-6, -0x1.13bf4a2618844p-7,
     0x1.03e7f94afc9dep-9, -0x1.238fb191c664bp-12, 0x1.9a68577e051abp-18, 0x1.e22fea67f24efp-18, -0x1.c8439e8ee19c1p-20,
     0x1.f9c5e607270d2p-24, 0x1.13e80c65779dcp-25}, /* [9] 4.25 <= y <= 4.5, degree 10, 62.3 bits */
    {0x1.c0a5c9a1b22aap+3, -0x1.c250f3215d2d8p-52, 0x1.70f6667f14b39p+1, 0x1.21f01202fde8bp-6, -0x1.b0bf2d39d0807p-8,
     0x1.af1d60f62956cp-10, -0x1.118b93392124ap-12, 0x1.0a9f3005ad501p-16, 0x1.1311fa25c5cc8p-18,
     -0x1.6f75fed5de311p-20, 0x1.6352851073ae4p-23, 0x1.0af6bceff57bap-27},
     /* [10] 4.5 <= y <= 4.75, degree 10, 61.0 bits */
    {0x1.d7bd741cf7071p+3, 0x1.4ed2908f7dc64p-51, 0x1.71f2f8f76cbd1p+1, 0x1.b48056036149ap-7, -0x1.4f4bc2e2d97d9p-8,
     0x1.5e084a0b39271p-10, -0x1.e827b30f8d3d1p-13, 0x1.5e7b501334d53p-16, 0x1.d331d15865d2bp-20,
     -0x1.09b546c6d961ap-20, 0x1.62ad2b4e7a751p-23, -0x1.bc976d2fed426p-28},
     /* [11] 4.75 <= y <= 5, degree 10, 61.8 bits */
    {0x1.eee2d880e6655p+3, -0x1.e4dc8ef719ec5p-51, 0x1.72b06101e58a4p+1, 0x1.4605bb16d9f45p-7, -0x1.00e1cc865828ep-8,
     0x1.171370fb5cccep-10, -0x1.a34c8e0748997p-13, 0x1.780bd2d945a45p-16, 0x1.f4d40c9d9b0d5p-24,
     -0x1.598ac7d364e46p-21, 0x1.2c497e8a0ae3fp-23, -0x1.b4b0b62c93905p-27},
     /* [12] 5 <= y <= 5.25, degree 10, 59.3 bits */
    {0x1.03093f44e182bp+4, -0x1.9058e83eec7dep-52, 0x1.733d5d32ff2dcp+1, 0x1.e395d1082b4e3p-8, -0x1.85b0644d73fbep-9,
     0x1.b61676af6d21dp-11, -0x1.5d834be830b17p-13, 0x1.6b78a2fa4c9dbp-16, -0x1.d8e666b82b06bp-21,
     -0x1.89a9d5701ca82p-22, 0x1.c6eafa1887686p-24, -0x1.d9f72e1c795fap-27},
     /* [13] 5.25 <= y <= 5.5, degree 10, 59.0 bits */
    {0x1.0ea4e05021e9cp+4, 0x1.e701c2882e1e2p-50, 0x1.73a59a37c68a6p+1, 0x1.645cc98a17a45p-8, -0x1.24f3611960fcep-9,
     0x1.5337035f51569p-11, -0x1.1c5b672b127b2p-13, 0x1.48fd80099a41bp-16, -0x1.782049b8ca511p-20,
     -0x1.64941ca06c1a5p-23, 0x1.3a041db4b2dd5p-24, -0x1.a206a92865c85p-27},
     /* [14] 5.5 <= y <= 5.75, degree 10, 59.9 bits */
    {0x1.1a434f646314p+4, -0x1.72994e2a867c3p-56, 0x1.73f233f2ed90bp+1, 0x1.05176e3f8bc9p-8, -0x1.b4f4868c49747p-10,
     0x1.03920fae768e5p-11, -0x1.c586e4ce5c53bp-14, 0x1.1c6cc8cb5a698p-16, -0x1.aaf0f93f5e1cdp-20,
     -0x1.1f6796c6a10cep-25, 0x1.8a8c20dab07e4p-25, -0x1.46b2dbc3d7a89p-27},
     /* [15] 5.75 <= y <= 6, degree 10, 62.2 bits */
    {0x1.25e3ccb801c35p+4, 0x1.894438fba4b3cp-51, 0x1.742a2ebd967ddp+1, 0x1.7c922e4f248d7p-9, -0x1.438de3d184b6ep-10,
     0x1.8929cb1e98be5p-12, -0x1.63a91cba18f68p-14, 0x1.db443b5bd913ap-17, -0x1.a59f3325d1813p-20,
     0x1.8831842c31eadp-25, 0x1.b7e122bffb4f1p-26, -0x1.d2e7ea003238p-28},
     /* [16] 6 <= y <= 6.25, degree 10, 60.7 bits */
    {0x1.3185c9b1fdb49p+4, -0x1.f8a5c9b2fa244p-51, 0x1.7452e30cd7df1p+1, 0x1.140922712aed6p-9, -0x1.dc1a6f3be4dacp-11,
     0x1.270efa48aa494p-12, -0x1.12fb1c0bb70a7p-14, 0x1.82aba5f1471fdp-17, -0x1.80c699edeae69p-20,
     0x1.72f3fe9bd7957p-24, 0x1.8f08e7dc600bbp-27, -0x1.341764c1e45ep-28},
     /* [17] 6.25 <= y <= 6.5, degree 10, 61.3 bits */
    {0x1.3d28dd04bce56p+4, -0x1.9336ec7bdecd6p-53, 0x1.747059375bfcp+1, 0x1.8eadb07d24efbp-10, -0x1.5c44dde861907p-11,
     0x1.b7518cbbd9d81p-13, -0x1.a411a783845p-15, 0x1.33f854283a05fp-17, -0x1.4d6c0099a164dp-20, 0x1.b4725ec44762dp-24,
     0x1.76d72cb78214fp-29, -0x1.7558cb0b624fap-29}, /* [18] 6.5 <= y <= 6.75, degree 10, 60.3 bits */
    {0x1.48ccb966da105p+4, -0x1.0d859eda99d1ap-50, 0x1.74859552de91dp+1, 0x1.1ec1074b1d3aep-10, -0x1.fadc7f0c5445dp-12,
     0x1.44b9ee32bed5p-13, -0x1.3d80f6aa29f9bp-15, 0x1.e21b48940acb4p-18, -0x1.166c231af5831p-20, 0x1.b351e465fbadcp-24,
     -0x1.4ab0a1d3f2831p-29, -0x1.93dd00af74254p-30}, /* [19] 6.75 <= y <= 7, degree 10, 62.6 bits */
    {0x1.5471266f2613p+4, -0x1.188cc211cfbcdp-50, 0x1.7494d46a3d0ebp+1, 0x1.9afcc6cbddcf8p-11, -0x1.6f179114f0d39p-12,
     0x1.dcff2c73f4bffp-14, -0x1.db9828d9d642ap-16, 0x1.73eaa15df6d61p-18, -0x1.c42e41c1c6377p-21,
     0x1.8de2f529b9108p-24, -0x1.55fbb6ca1fdb7p-28, -0x1.64724b9dce45p-31},
     /* [20] 7 <= y <= 7.25, degree 10, 59.9 bits */
    {0x1.6015fb25dd85ep+4, 0x1.16492506f7583p-50, 0x1.749fbceac01e9p+1, 0x1.2586c1a72912p-11, -0x1.08b86699a10dcp-12,
     0x1.5c564f0dc0827p-14, -0x1.615b0952b126fp-16, 0x1.1b69db597cd8p-18, -0x1.673c5e9036e27p-21, 0x1.582f84405a31ap-24,
     -0x1.9671192a74b9bp-28, -0x1.41081a36d4768p-33}, /* [21] 7.25 <= y <= 7.5, degree 10, 61.3 bits */
    {0x1.6bbb19ecfe6a1p+4, 0x1.274e70a4eef0cp-53, 0x1.74a784565dfb5p+1, 0x1.a1f6ccbd2336cp-12, -0x1.7c4b0d79683d8p-13,
     0x1.fa25c750aefb1p-15, -0x1.04aec27d73c0dp-16, 0x1.ab6ec6faaa0fdp-19, -0x1.1866e1387b5f5p-21,
     0x1.1e89e80c20a33p-24, -0x1.94e0adb392843p-28, 0x1.2803bc499023ep-33},
     /* [22] 7.5 <= y <= 7.75, degree 10, 59.7 bits */
    {0x1.77606d71ed574p+4, -0x1.9f3072070957fp-50, 0x1.74ad0c362789cp+1, 0x1.28b80d838c88dp-12, -0x1.102d6972213d9p-13,
     0x1.6e044d0760a7cp-15, -0x1.7e378c0c2e864p-17, 0x1.3f68479ac84cap-19, -0x1.af6ac8e959bbcp-22,
     0x1.cfbd934d96033p-25, -0x1.708360cef0ca9p-28, 0x1.28dd1e044babep-32},
     /* [23] 7.75 <= y <= 8, degree 10, 61.2 bits */
    {0x1.8305e669aeff2p+4, 0x1.7b3fc810d9656p-50, 0x1.74b0f8135444cp+1, 0x1.a42989655ab9cp-13, -0x1.844e6c587651bp-14,
     0x1.0790813499104p-15, -0x1.16a2a12233271p-17, 0x1.d99a74316184ap-20, -0x1.47dcc5df5dc26p-22,
     0x1.6f1d2c11944b2p-25, -0x1.3d373d46a755fp-28, 0x1.5b9154aeb023cp-32},
     /* [24] 8 <= y <= 8.25, degree 10, 60.2 bits */
    {0x1.8eab79e628a8p+4, -0x1.f1ee710af55d6p-50, 0x1.74b3bdfadab5dp+1, 0x1.28bd608e58207p-13, -0x1.14254961b9f2ap-14,
     0x1.7a1e09ebc382p-16, -0x1.9433b0a889a31p-18, 0x1.5caf043ea4d46p-20, -0x1.ed315e9e06db4p-23, 0x1.1d922e481ada4p-25,
     -0x1.06ccdd60eb957p-28, 0x1.56635c5c51a5ep-32}, /* [25] 8.25 <= y <= 8.5, degree 10, 59.7 bits */
    {0x1.9a51201de7c2bp+4, -0x1.8aac3249ba22p-50, 0x1.74b5b2cb7961cp+1, 0x1.a22c0062e4b93p-14, -0x1.87a7922f3103cp-15,
     0x1.0e45ccf84391p-16, -0x1.23d7de6ca4e5cp-18, 0x1.fe45305b0800ap-21, -0x1.6fa7bd02a025cp-23, 0x1.b5f4ea2a234cbp-26,
     -0x1.a76023298ec1bp-29, 0x1.34d5b7983ca23p-32}, /* [26] 8.5 <= y <= 8.75, degree 10, 61.5 bits */
    {0x1.a5f6d388ef8c1p+4, 0x1.adcaf32fe714cp-50, 0x1.74b7134f313c1p+1, 0x1.26024e37b17dfp-14, -0x1.150319b63ac9ap-15,
     0x1.811f3bfa57daap-17, -0x1.a3b1e4a46c5dep-19, 0x1.73526722286f1p-21, -0x1.0ff4c77da65cep-23,
     0x1.4bd6b17e8ee87p-26, -0x1.4dc099c869d3ep-29, 0x1.07d8f6548dfafp-32},
     /* [27] 8.75 <= y <= 9, degree 10, 60.5 bits */
    {0x1.b19c903c32fa9p+4, -0x1.ff8b271944dc2p-50, 0x1.74b80aea81ef1p+1, 0x1.9c95b3549361ep-15, -0x1.86e635a4238bep-16,
     0x1.119178e9bf614p-17, -0x1.2ca4714650238p-19, 0x1.0ce13343f3b04p-21, -0x1.8f9b971182c1ap-24, 0x1.f1cd0836e73p-27,
     -0x1.02a14dabf1d19p-29, 0x1.b261ebe2e03cdp-33}, /* [28] 9 <= y <= 9.25, degree 10, 60.0 bits */
    {0x1.bd425372f723bp+4, 0x1.943072efabf48p-50, 0x1.74b8b87e12afbp+1, 0x1.20f08780a812fp-15, -0x1.132d83062c3e5p-16,
     0x1.8394aae0ba847p-18, -0x1.ad3cffd67ce39p-20, 0x1.83ab8bc2d4684p-22, -0x1.23d3f5cef5dep-24, 0x1.722704ef253cep-27,
     -0x1.8b45e1ff663a6p-30, 0x1.5bfa63c8b54e5p-33}, /* [29] 9.25 <= y <= 9.5, degree 10, 64.8 bits */
    {0x1.c8e81b39a6336p+4, 0x1.2700104acb29ap-50, 0x1.74b931f277eadp+1, 0x1.93f8f1fb60ad1p-16, -0x1.829b42824517ep-17,
     0x1.11d9fc5f3ce5bp-18, -0x1.3173561c6c671p-20, 0x1.165863f38b0e2p-22, -0x1.a7f54548f0459p-25,
     0x1.112b06cb6e406p-27, -0x1.2a90b71f0d06fp-30, 0x1.1103131417f14p-33},
     /* [30] 9.5 <= y <= 9.75, degree 10, 59.9 bits */
    {0x1.d48de630deadfp+4, 0x1.5fd1c20b1870ap-50, 0x1.74b986c87df73p+1, 0x1.19eca568fb51ep-16, -0x1.0f09d38be8daap-17,
     0x1.821126bc8df0fp-19, -0x1.b174d4a96c0b9p-21, 0x1.8e3c023b02ccfp-23, -0x1.327af6994a0eep-25,
     0x1.90882e88b98e9p-28, -0x1.be7d22d5af911p-31, 0x1.aaf07bc28dd03p-34}
     /* [31] 9.75 <= y <= 10, degree 10, 60.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_duration_zero_force)

/* largest overlap beta^(2/3), beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-60.3 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_MAX_OVERLAP_FIRST 2.125
#define COR_ROWS_TAIL_MAX_OVERLAP_STEP 0.25
#define COR_ROWS_TAIL_MAX_OVERLAP_PER_UNIT 4.0
#define COR_ROWS_TAIL_MAX_OVERLAP_ROWS 32
#define COR_ROWS_TAIL_MAX_OVERLAP_END 10.0
COR_ROWS(double, cor_rows_tail_max_overlap, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.38c01efa711b2p+0, -0x1.7f050766732efp-54, 0x1.9826e62bcde55p-4, -0x1.80e64d71cd3d4p-5, 0x1.399405882c796p-7,
     0x1.a79d2b77d8af1p-11, -0x1.f82807453dab9p-11, 0x1.7eeda7b59e327p-13, 0x1.ca56a7bbbf877p-16,
     -0x1.516b458d9ec9bp-16, 0x1.7934151eb0ecfp-19, 0x1.a3095171808eep-21},
     /* [0] 2 <= y <= 2.25, degree 10, 61.0 bits */
    {0x1.3e6a3a045433fp+0, 0x1.c2a3ac378b2a6p-55, 0x1.3f693639e189bp-4, -0x1.44c2e331f56f5p-5, 0x1.425192a233b68p-7,
     -0x1.bebc2392cda58p-13, -0x1.5e2d883395e5ap-11, 0x1.a226524d031ecp-13, -0x1.7496b4bdc63c1p-18,
     -0x1.a294052271223p-17, 0x1.e29b19dc63f41p-19, -0x1.461f9c122a60bp-24},
     /* [1] 2.25 <= y <= 2.5, degree 10, 60.3 bits */
    {0x1.42cf77dfc6b4cp+0, -0x1.bdb89c56239bp-57, 0x1.eb57f189160b8p-5, -0x1.09bde12d301a5p-5, 0x1.2fa80ff1472ffp-7,
     -0x1.c68dddcf887a5p-11, -0x1.9403673a48f61p-12, 0x1.6998939e33643p-13, -0x1.7e27ee45e4ef2p-16,
     -0x1.5264fd93c2e91p-18, 0x1.7def7507db3cdp-19, -0x1.e221853e002abp-22},
     /* [2] 2.5 <= y <= 2.75, degree 10, 61.6 bits */
    {0x1.462a879f83026p+0, -0x1.ccbd2790d984p-54, 0x1.74357e77ebb8bp-5, -0x1.a7c49c6fbd33ap-6, 0x1.0d0325f3ce733p-7,
     -0x1.3ab2b47094655p-10, -0x1.4ee2bb3cfcee7p-13, 0x1.0a85687cb5708p-13, -0x1.cac453f701454p-16,
     0x1.8993e6746c94bp-26, 0x1.bb34377dcc91fp-20, -0x1.f3af5c05c5e5ep-22},
     /* [3] 2.75 <= y <= 3, degree 10, 61.7 bits */
    {0x1.48b118c2326cdp+0, -0x1.67604ebf0e0f6p-54, 0x1.163e102b344e4p-5, -0x1.4a8f600f1340ep-6, 0x1.c72b4e476c3acp-8,
     -0x1.53a98e86f7cc5p-10, -0x1.1b68a481884d6p-18, 0x1.540e4f922449p-14, -0x1.9978ea28f251fp-16,
     0x1.547f9e783dd9ap-19, 0x1.5ac0c7af606b7p-21, -0x1.5fa71843e4e69p-22},
     /* [4] 3 <= y <= 3.25, degree 10, 61.5 bits */
    {0x1.4a91b90a6ea2p+0, 0x1.502d05e3fdfb6p-56, 0x1.9b384890c62e9p-6, -0x1.fa3c2fda1e721p-7, 0x1.73883b9052bcdp-8,
     -0x1.446be11b8d2c2p-10, 0x1.705777224ea0fp-14, 0x1.6c1ea5f25703dp-15, -0x1.3517e8ebdc7aap-16,
     0x1.af51395b86332p-19, 0x1.a0046adb75057p-26, -0x1.75e4666ab1517p-23},
     /* [5] 3.25 <= y <= 3.5, degree 10, 62.4 bits */
    {0x1.4bf3286c36e21p+0, -0x1.07ccee04edb6p-56, 0x1.2cd7563015a77p-6, -0x1.7d98b3432525ap-7, 0x1.26c25eaa0d417p-8,
     -0x1.1f63ab8d01375p-10, 0x1.13d8b28f412e6p-13, 0x1.1820d4471205bp-16, -0x1.99caf4f4aeb94p-17,
     0x1.8407d25a030f4p-19, -0x1.18a1b56c767dbp-22, -0x1.0e0240547a978p-24},
     /* [6] 3.5 <= y <= 3.75, degree 10, 63.9 bits */
    {0x1.4cf4a212bd8cfp+0, 0x1.608144894e7f3p-54, 0x1.b45bf96eeb18cp-7, -0x1.1bd5d022f8671p-7, 0x1.c91588db07ed5p-9,
     -0x1.e379ab27f513ep-11, 0x1.2bc36377bc14ep-13, 0x1.4e09d6fb5c443p-31, -0x1.dcb4829d49db4p-18,
     0x1.264f6ded5f928p-19, -0x1.643c8ea0f9bb9p-22, -0x1.952818e5f4fb6p-31},
     /* [7] 3.75 <= y <= 4, degree 10, 63.2 bits */
    {0x1.4daead671a96bp+0, -0x1.4b04ce0d30cd7p-54, 0x1.3a11ed8400eadp-7, -0x1.a178c101ca897p-8, 0x1.5bcff70c45e6bp-9,
     -0x1.878ae8f09cce2p-11, 0x1.1be577fd7bdc9p-13, -0x1.2ecac177d46dbp-17, -0x1.cf1fe0ddc59dp-19,
     0x1.8bc66ee9efcdbp-20, -0x1.3d1d61dee8abp-22, 0x1.b252df94aa46ep-26},
     /* [8] 4 <= y <= 4.25, degree 10, 63.2 bits */
    {0x1.4e3427ade2052p+0, 0x1.89933bb6960e6p-54, 0x1.c11f46395d66dp-8, -0x1.300c4ebc2b653p-8, 0x1.049842086014fp-9,
     -0x1.340e87070e141p-11, 0x1.f0da528564365p-14, -0x1.af17e3d7f4467p-17, -0x1.2b33577679519p-20,
     0x1.dd59ac92d736dp-21, -0x1.de020ea45b9eap-23, 0x1.06cbed7982f9fp-25},
     /* [9] 4.25 <= y <= 4.5, degree 10, 64.6 bits */
    {0x1.4e93534c5c943p+0, 0x1.aaf778ed90998p-54, 0x1.3f44cf4927ce3p-8, -0x1.b7348e434d84ep-9, 0x1.817d179bf3b87p-10,
     -0x1.d9e35356881fap-12, 0x1.9cb8c7ebdab59p-14, -0x1.c54de97c70088p-17, 0x1.d6aff2a4318eep-23,
     0x1.fac2bd12c1841p-22, -0x1.4249f5a42ab58p-23, 0x1.c80ce118f7c22p-26},
     /* [10] 4.5 <= y <= 4.75, degree 10, 64.5 bits */
    {0x1.4ed6d04943896p+0, -0x1.3950ce4a57d76p-54, 0x1.c39d24f24fc03p-9, -0x1.3af2b642542f3p-9, 0x1.1a0bb6830d7e6p-10,
     -0x1.65f325dd34ce6p-12, 0x1.4a61f08e7f2ap-14, -0x1.a2a18f0339f5cp-17, 0x1.d454b4c71dff4p-21, 0x1.b3d8099a2bbc7p-23,
     -0x1.8b86c3ad2338ap-24, 0x1.52dd98f9b05fbp-26}, /* [11] 4.75 <= y <= 5, degree 10, 65.1 bits */
    {0x1.4f0671423e5eap+0, -0x1.70d92da28d9c7p-55, 0x1.3dfa358b00dfbp-9, -0x1.c0e14156ec195p-10, 0x1.98f37a1d542fap-11,
     -0x1.0a6c1977c42b8p-12, 0x1.0143fd247cf18p-14, -0x1.6709395124a45p-17, 0x1.28a25fee0dab4p-20,
     0x1.83686f9fb3412p-25, -0x1.b716cbf8c509ap-25, 0x1.c7015bf522231p-27},
     /* [12] 5 <= y <= 5.25, degree 10, 65.2 bits */
    {0x1.4f27e9cd3c447p+0, 0x1.7f13e96fc05bap-54, 0x1.bdfd3e50c3c31p-10, -0x1.3e2576312d29ep-10, 0x1.262a6ca8dc6f9p-11,
     -0x1.87cf3622422dbp-13, 0x1.88347ac5da663p-15, -0x1.2569bc4c960f8p-17, 0x1.27fd3b298ac74p-20,
     -0x1.431c119412f3ap-25, -0x1.a7a3067fa0e9cp-26, 0x1.193f17bb30f52p-27},
     /* [13] 5.25 <= y <= 5.5, degree 10, 65.6 bits */
    {0x1.4f3f589d3d644p+0, 0x1.9639083a125d6p-54, 0x1.37a8d6f31385bp-10, -0x1.c0d3cb1613efbp-11, 0x1.a45b9af38bb3ep-12,
     -0x1.1d3334f53a266p-13, 0x1.25f3ffb579b8p-15, -0x1.cf824b8e15eb6p-18, 0x1.088e479b17696p-20,
     -0x1.3c2005900d404p-24, -0x1.31c7cb2e4297dp-27, 0x1.40094c3660d3ap-28},
     /* [14] 5.5 <= y <= 5.75, degree 10, 66.1 bits */
    {0x1.4f4fb23c60545p+0, 0x1.e4cc54f706811p-54, 0x1.b2323860e5995p-11, -0x1.3b43089ca177p-11, 0x1.2a98ba1ad5073p-12,
     -0x1.9baa610d86982p-14, 0x1.b2a7ea4cbe264p-16, -0x1.64f695a1f06e3p-18, 0x1.bb681a30db4adp-21,
     -0x1.63ca5b29f81ap-24, -0x1.5e0d3fbde5c42p-32, 0x1.47e4adeec925fp-29},
     /* [15] 5.75 <= y <= 6, degree 10, 66.1 bits */
    {0x1.4f5b11e6e34e8p+0, -0x1.56009cd7299p-55, 0x1.2d979b37d3a1cp-11, -0x1.b93c1fa984cdep-12, 0x1.a60f2b7b3d06cp-13,
     -0x1.26f39ecdd7ad6p-14, 0x1.3dc58198a296p-16, -0x1.0d9bf6ca4b036p-18, 0x1.641a11b298087p-21,
     -0x1.50197f2fd5affp-24, 0x1.045d583cf5dc4p-28, 0x1.190587a4d8ed7p-30},
     /* [16] 6 <= y <= 6.25, degree 10, 66.3 bits */
    {0x1.4f62f5d91a7fdp+0, -0x1.c2cd63eaed6f1p-56, 0x1.a1e40b9340838p-12, -0x1.33be8668d4f59p-12, 0x1.28f5334e82769p-13,
     -0x1.a405f3d6ce9f5p-15, 0x1.cc51e83025a02p-17, -0x1.910ae02cead67p-19, 0x1.15783866b6e13p-21,
     -0x1.22925db170475p-24, 0x1.6c00e26ad8dc8p-28, 0x1.2095d92356a1p-32},
     /* [17] 6.25 <= y <= 6.5, degree 10, 66.7 bits */
    {0x1.4f686bb7e69fap+0, -0x1.ca8b7b89b7fb3p-54, 0x1.20d72d6c47651p-12, -0x1.abff7434e06d3p-13, 0x1.a03b3bd0737f9p-14,
     -0x1.297355492ef2cp-15, 0x1.4acafe997e324p-17, -0x1.26966f8ced1b8p-19, 0x1.a6c1a0fd7b597p-22,
     -0x1.dbfe4d1386e5fp-25, 0x1.740d7703a7995p-28, -0x1.0b6fe7c07711dp-33},
     /* [18] 6.5 <= y <= 6.75, degree 10, 66.7 bits */
    {0x1.4f6c30ecd4ff9p+0, 0x1.2a752a56fd1dep-56, 0x1.8e6f31c9d082bp-13, -0x1.28d1fa3f8851dp-13, 0x1.22af9eb0cf97fp-14,
     -0x1.a34ee4875f1f8p-16, 0x1.d83f30c6d5416p-18, -0x1.ac60d0d998891p-20, 0x1.3c7e091b6d774p-22,
     -0x1.77e4f1e9ffb02p-25, 0x1.4ecbd108a6836p-28, -0x1.39d9324d6d3b9p-32},
     /* [19] 6.75 <= y <= 7, degree 10, 66.7 bits */
    {0x1.4f6eca05d11d4p+0, 0x1.279de500eb43dp-54, 0x1.124514e1ac5dp-13, -0x1.9ab13d5f5356fp-14, 0x1.94bf657888f8dp-15,
     -0x1.26515f90c9767p-16, 0x1.4f275a4ab0f4p-18, -0x1.34d199b0d494ap-20, 0x1.d35cdf195d59ep-23,
     -0x1.21231615db535p-25, 0x1.18d9a3e6da2c5p-28, -0x1.695409c4b2912p-32},
     /* [20] 7 <= y <= 7.25, degree 10, 66.8 bits */
    {0x1.4f7093772107bp+0, -0x1.b1995b8588ea5p-54, 0x1.78ec1859b7283p-14, -0x1.1b7f0909d82cap-14, 0x1.18fddb3671807p-15,
     -0x1.9ba73e5651418p-17, 0x1.d9567b910c513p-19, -0x1.ba0e2a9038079p-21, 0x1.5538f6947de83p-23,
     -0x1.b411d80e7dfap-26, 0x1.c29a839479915p-29, -0x1.569880ce3aa08p-32},
     /* [21] 7.25 <= y <= 7.5, degree 10, 66.8 bits */
    {0x1.4f71cd8b8a467p+0, -0x1.6f7429e9f7759p-55, 0x1.029220993474p-14, -0x1.8698fac0dbcacp-15, 0x1.8529544542141p-16,
     -0x1.1ef0e99869924p-17, 0x1.4cc89345f2e4dp-19, -0x1.3a712f22cbccp-21, 0x1.eda7bc4a2ac95p-24,
     -0x1.43c9fbb83a936p-26, 0x1.5e743aacddcb3p-29, -0x1.27d9496915fdep-32},
     /* [22] 7.5 <= y <= 7.75, degree 10, 66.7 bits */
    {0x1.4f72a4d988d83p+0, -0x1.dbac99c6e51dcp-54, 0x1.6238e73666304p-15, -0x1.0c95022510953p-15, 0x1.0cddb80db7ccbp-16,
     -0x1.8ed93c858edb4p-18, 0x1.d21f91c06be2bp-20, -0x1.bcf5da5badf82p-22, 0x1.6253a844f3fap-24,
     -0x1.daed2fc2ac21ap-27, 0x1.0a701f7148491p-29, -0x1.e36a5726181a9p-33},
     /* [23] 7.75 <= y <= 8, degree 10, 66.8 bits */
    {0x1.4f733839fb509p+0, 0x1.98fe1e9a1f095p-54, 0x1.e492c9d425c57p-16, -0x1.70bc31c6b11efp-16, 0x1.72bb9b2fd277ep-17,
     -0x1.1477b573ed61fp-18, 0x1.455314b13bff5p-20, -0x1.395e7487121bcp-22, 0x1.f94c69c320062p-25,
     -0x1.58ce279c8ee2ap-27, 0x1.8e26e0af383c8p-30, -0x1.7cb18b65019d3p-33},
     /* [24] 8 <= y <= 8.25, degree 10, 66.8 bits */
    {0x1.4f739cf80eaffp+0, -0x1.7d55b139a27p-56, 0x1.4b0323c2dc591p-16, -0x1.f97099597c076p-17, 0x1.fe36de5353016p-18,
     -0x1.7e5bad0b442adp-19, 0x1.c4b81975f791bp-21, -0x1.b79786995eb17p-23, 0x1.66431b609f6e2p-25,
     -0x1.f07c64208f0c9p-28, 0x1.257258b275683p-30, -0x1.240d9d5b6f8d5p-33},
     /* [25] 8.25 <= y <= 8.5, degree 10, 66.8 bits */
    {0x1.4f73e1bf136a7p+0, -0x1.d936ad183eeafp-54, 0x1.c3ad72428e601p-17, -0x1.59e8e83bed799p-17, 0x1.5e77f7bd0dcfp-18,
     -0x1.07d3ead8f31a9p-19, 0x1.3a21d2a36f83bp-21, -0x1.3337ba710213ap-23, 0x1.f9887261373d8p-26,
     -0x1.62ed0c6a85d3ap-28, 0x1.abcd95441d6d3p-31, -0x1.b76acdf664223p-34},
     /* [26] 8.5 <= y <= 8.75, degree 10, 66.8 bits */
    {0x1.4f7410a547ac1p+0, 0x1.d296006ac34cbp-55, 0x1.33d04e3a92ff7p-17, -0x1.d8d321b6dce48p-18, 0x1.e0b243d3c971ep-19,
     -0x1.6b5c2f0936c26p-20, 0x1.b2da96caacfdp-22, -0x1.ac084fb09defcp-24, 0x1.6324176570ab1p-26,
     -0x1.f866c8a43d82ep-29, 0x1.3504351c3bf37p-31, -0x1.459723d564b1dp-34},
     /* [27] 8.75 <= y <= 9, degree 10, 66.8 bits */
    {0x1.4f74309741b99p+0, -0x1.f777932cca559p-55, 0x1.a318c128a6f68p-18, -0x1.42bf3ccc738f1p-18, 0x1.4929c2871bdeep-19,
     -0x1.f387e7056b7a2p-21, 0x1.2c4df9b1b4e2bp-22, -0x1.295243c1bad1dp-24, 0x1.f11726fd4a9eep-27,
     -0x1.648d2ac2b32c9p-29, 0x1.bb0b612c7396ap-32, -0x1.dcb2858f64b5p-35},
     /* [28] 9 <= y <= 9.25, degree 10, 66.8 bits */
    {0x1.4f744653e4219p+0, 0x1.f2dc14de2c54ap-54, 0x1.1d0545085e0abp-18, -0x1.b81820d7d5a08p-19, 0x1.c22bdc49e50c7p-20,
     -0x1.56ca78cf9829p-21, 0x1.9deb3b34f2bfep-23, -0x1.9bfb58d30d5b7p-25, 0x1.5ab80ef9644d4p-27,
     -0x1.f5cb9bf7eb3e8p-30, 0x1.3b8f66e241956p-32, -0x1.598b26ce32066p-35},
     /* [29] 9.25 <= y <= 9.5, degree 10, 66.8 bits */
    {0x1.4f74551a9f8f5p+0, -0x1.0d7aceae84772p-55, 0x1.834fae35b4304p-19, -0x1.2bb9b891f8198p-19, 0x1.336f60cf36109p-20,
     -0x1.d5bc85325f328p-22, 0x1.1cb881d26a5c2p-23, -0x1.1cc28fb120bc8p-25, 0x1.e23799bb1656ap-28,
     -0x1.5fb27d4a4c5aep-30, 0x1.bf0940d1e2ca8p-33, -0x1.f0de5b9a9ed0bp-36},
     /* [30] 9.5 <= y <= 9.75, degree 10, 66.8 bits */
    {0x1.4f745f23b45f7p+0, -0x1.f97611409d966p-54, 0x1.06ec7b48cf71cp-19, -0x1.97d62463595b4p-20, 0x1.a3684f6f66e57p-21,
     -0x1.4162d423e7a8ep-22, 0x1.87056cbcce44dp-24, -0x1.88cf0029487afp-26, 0x1.4e6d8e1e17ed5p-28,
     -0x1.eb41eb07c4f88p-31, 0x1.3b34f27a51e45p-33, -0x1.5f50144520185p-36}
     /* [31] 9.75 <= y <= 10, degree 10, 66.8 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_max_overlap)

/* time of the largest overlap beta^(2/3), beta > exp(2): 32 rows of degree 10 in y = ln(beta), nodes 2.125 + i 0.25, 2 <= y <= 10.
 * Relative error of the approximation: 2^-58.3 at most, proved for the whole cell of each row. */
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_FIRST 2.125
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_STEP 0.25
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_PER_UNIT 4.0
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_ROWS 32
#define COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP_END 10.0
COR_ROWS(double, cor_rows_tail_time_of_max_overlap, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.d3f205742e7e1p+1, 0x1.100d54c7a7db3p-55, 0x1.4c1daf24c10e1p+0, 0x1.2a617d2d757b2p-4, -0x1.1ad7e74c1aa4ep-6,
     0x1.64e3ecee91a92p-10, 0x1.96dddd4b14b94p-12, -0x1.f2afa591926e3p-14, 0x1.383b71e1e90fp-18, 0x1.f0993c0b6c94cp-19,
     -0x1.b3b4ad91da997p-21, 0x1.29ca2cd9672ffp-25}, /* [0] 2 <= y <= 2.25, degree 10, 60.6 bits */
    {0x1.fe0244e4bfd5fp+1, 0x1.8069d8dc9d662p-54, 0x1.54a2a04f0e8eep+0, 0x1.ef517871636cdp-5, -0x1.0128e2045df68p-6,
     0x1.c7b90bc17e02cp-10, 0x1.ca7f646c72ae8p-13, -0x1.b9b3e01dd3be8p-14, 0x1.59dfe19648c28p-17, 0x1.0ce855e715ef5p-19,
     -0x1.6fade100b55c6p-21, 0x1.066d78d5ed38p-24}, /* [1] 2.25 <= y <= 2.5, degree 10, 59.4 bits */
    {0x1.14854f48c0c2bp+2, -0x1.f677e9f73bc5cp-52, 0x1.5ba66404a814dp+0, 0x1.94747a047a029p-5, -0x1.c5e7d3febe07bp-7,
     0x1.f715090d43f7p-10, 0x1.3d30a47322899p-14, -0x1.62e3fb93393f4p-14, 0x1.b09b61a5e1361p-17, 0x1.58f1e46ad60dep-21,
     -0x1.185aa8b4cc559p-21, 0x1.217a2dfcc0cbcp-24}, /* [2] 2.5 <= y <= 2.75, degree 10, 58.3 bits */
    {0x1.2a6ed7f3ecc7ep+2, 0x1.072ae71cfc6f4p-57, 0x1.6155ec278288bp+0, 0x1.454d333627bdcp-5, -0x1.864785b7c3658p-7,
     0x1.fcf259fcb5d78p-10, -0x1.1da499b53b3bbp-15, -0x1.022f0f49a037p-14, 0x1.b88e47344454bp-17,
     -0x1.6f7093db87edap-22, -0x1.7b7cbd146faebp-22, 0x1.1e5028e19155dp-24},
     /* [3] 2.75 <= y <= 3, degree 10, 58.7 bits */
    {0x1.40a9f369e8decp+2, 0x1.658d9b475f77dp-52, 0x1.65e0a9158aa74p+0, 0x1.0204774b6a43ap-5, -0x1.47ee469af5f06p-7,
     0x1.e4820d5068bb9p-10, -0x1.cbbc644f179f8p-14, -0x1.4c16225e47081p-15, 0x1.8b075491ac39bp-17,
     -0x1.004b4341fa2ccp-20, -0x1.a11b2c760b373p-23, 0x1.ffc17048972dbp-25},
     /* [4] 3 <= y <= 3.25, degree 10, 58.3 bits */
    {0x1.5725cc79301dcp+2, 0x1.ceb9a9da6a71dp-52, 0x1.69752c25c7618p+0, 0x1.941a0c27762f4p-6, -0x1.0df76e9bb9327p-7,
     0x1.b879d3229000bp-10, -0x1.43eb11ecb4055p-13, -0x1.5e0a422a7154dp-16, 0x1.3fde6ea4b085ep-17,
     -0x1.4b864238e77e5p-20, -0x1.0527e68894effp-24, 0x1.8ded66912b5aep-25},
     /* [5] 3.25 <= y <= 3.5, degree 10, 58.4 bits */
    {0x1.6dd45fce3c07dp+2, 0x1.2affcc6e48be6p-52, 0x1.6c3ed0f578977p+0, 0x1.38c68c40e93b3p-6, -0x1.b47cab4f54fd8p-8,
     0x1.82034a310e4e2p-10, -0x1.6d9e27658d02bp-13, -0x1.ac9f5fd2b6db2p-18, 0x1.d6278179c66ccp-18,
     -0x1.512fc0d04ad52p-20, 0x1.2a508b2a55eabp-25, 0x1.010c683dd25c9p-25},
     /* [6] 3.5 <= y <= 3.75, degree 10, 59.9 bits */
    {0x1.84aa3c31d590fp+2, 0x1.f2d309dd1aea4p-54, 0x1.6e64552a62cabp+0, 0x1.df0ffb890a5ffp-7, -0x1.5b327d3757d92p-8,
     0x1.483b31a16f52ep-10, -0x1.70ae40879168ap-13, 0x1.f6596f299b5d7p-19, 0x1.3617bdfafbe85p-18,
     -0x1.298da1947ef7cp-20, 0x1.80ba79bac564ap-24, 0x1.ee39ee09e0507p-27},
     /* [7] 3.75 <= y <= 4, degree 10, 61.3 bits */
    {0x1.9b9e329e7aeddp+2, 0x1.fccc45643d397p-53, 0x1.7007337dd4402p+0, 0x1.6b5bf89e78aaep-7, -0x1.1039db51862c5p-8,
     0x1.102177fad171p-10, -0x1.5a1f93e9514e3p-13, 0x1.501ab0b9ca474p-17, 0x1.6087309754204p-19, -0x1.d781c66cadfedp-21,
     0x1.d778a8376fc08p-24, 0x1.584bb810b63a3p-29}, /* [8] 4 <= y <= 4.25, degree 10, 58.8 bits */
    {0x1.b2a900d4123ebp+2, -0x1.53f65b08bbddfp-53, 0x1.7143901bd8ce7p+0, 0x1.1134d7f469a73p-7, -0x1.a574aa9661c89p-9,
     0x1.b9a7d723b7bfap-11, -0x1.34e1b2f673fdap-13, 0x1.bb9fd203dd60ap-17, 0x1.2c1711cc871e2p-20,
     -0x1.533e73f671043p-21, 0x1.c71266565ddabp-24, -0x1.4b9168eb10864p-28},
     /* [9] 4.25 <= y <= 4.5, degree 10, 59.5 bits */
    {0x1.c9c4fdf88f7ap+2, 0x1.68d73d92ebe44p-52, 0x1.72308663e2794p+0, 0x1.979d03fb49e18p-8, -0x1.428cd975650c2p-9,
     0x1.5fdd7aa0321f3p-11, -0x1.09448af2b1722p-13, 0x1.dcacec5e7a673p-17, 0x1.5e505cc40641ap-24,
     -0x1.b931ee2d1e2f6p-22, 0x1.7e48a334c65bp-24, -0x1.189b5cb7f6785p-27},
     /* [10] 4.5 <= y <= 4.75, degree 10, 59.1 bits */
    {0x1.e0edce0a7379ep+2, 0x1.5ed50fd1901b7p-52, 0x1.72e0af5f081aap+0, 0x1.2de8f181965cdp-8, -0x1.e8bb0888e5808p-10,
     0x1.13ebe97b8b2e8p-11, -0x1.ba0aee4791891p-14, 0x1.cd0699b8a6e6ep-17, -0x1.2a65e3ae57deap-21,
     -0x1.f7cf6a354426bp-23, 0x1.21b8db73a8beep-24, -0x1.2ba9ed3dd6a47p-27},
     /* [11] 4.75 <= y <= 5, degree 10, 60.5 bits */
    {0x1.f8201ea9d43fap+2, -0x1.88d3acdf62fa9p-53, 0x1.7362c1b797419p+0, 0x1.bc5be4f54d859p-9, -0x1.6eef3c357ea2fp-10,
     0x1.aad565b2ffb02p-12, -0x1.676409a0c2ae6p-14, 0x1.a158a6e9f0fb6p-17, -0x1.dd703b535730ap-21,
     -0x1.ca374813d1af4p-24, 0x1.9133e33702db4p-25, -0x1.08d658e17892ap-27},
     /* [12] 5 <= y <= 5.25, degree 10, 61.8 bits */
    {0x1.07acb70afc425p+3, -0x1.924e78675668cp-52, 0x1.73c2356ddfee8p+0, 0x1.451ac434ff2eep-9, -0x1.1147714722049p-10,
     0x1.46374a91c06d2p-12, -0x1.1e563912ffa99p-14, 0x1.68b6d0acdc666p-17, -0x1.0f7be348a4bb4p-20,
     -0x1.77692cf8a48e4p-26, 0x1.f9cac863b016fp-26, -0x1.a0433c9f0bd7bp-28},
     /* [13] 5.25 <= y <= 5.5, degree 10, 60.2 bits */
    {0x1.134bee12454edp+3, 0x1.aad37fb794bf9p-52, 0x1.7407dda54125p+0, 0x1.d9322a77189cfp-10, -0x1.9421b9fb020ecp-11,
     0x1.ed710b8cf9459p-13, -0x1.c0977c9c4512ep-15, 0x1.2d2ea848a4cc2p-17, -0x1.0c473da632b7cp-20,
     0x1.f0f9dc3891036p-26, 0x1.1abcd110bffdcp-26, -0x1.2b0abe3ac885p-28},
     /* [14] 5.5 <= y <= 5.75, degree 10, 59.5 bits */
    {0x1.1eed0228f565ap+3, 0x1.c79890d60ea0ap-53, 0x1.743a712d6df03p+0, 0x1.56b80339fa99fp-10, -0x1.28e4fd9d6d922p-11,
     0x1.71c73a9432873p-13, -0x1.5a615810cec0cp-15, 0x1.e99d8f1234b69p-18, -0x1.e9a128ef69cfdp-21,
     0x1.d97aa6e2bc69ap-25, 0x1.00f9b63ce6dc8p-27, -0x1.8c36ac8bf5285p-29},
     /* [15] 5.75 <= y <= 6, degree 10, 60.8 bits */
    {0x1.2a8f6fdd21042p+3, 0x1.2ff8d4102f723p-57, 0x1.745efedcbb549p+0, 0x1.ee43eda4e5cadp-11, -0x1.b1b2941893318p-12,
     0x1.12ddab3d5e2d4p-13, -0x1.08304f24176c3p-15, 0x1.857e9faeb8e61p-18, -0x1.a8059dc784d89p-21,
     0x1.16f04adf18256p-24, 0x1.e359cc8f7c66p-30, -0x1.e1328ac4e434p-30},
     /* [16] 6 <= y <= 6.25, degree 10, 62.0 bits */
    {0x1.3632d6da848fdp+3, -0x1.95c5a9dbf356fp-51, 0x1.74794dad32588p+0, 0x1.62fccd0be087cp-11, -0x1.3b1cad0db7441p-12,
     0x1.95b2ffe61da19p-14, -0x1.8ebf4aae97a7ep-16, 0x1.306f382fd6242p-18, -0x1.61b6fc2109ce2p-21,
     0x1.16376883f7e72p-24, -0x1.aa3ad667ff2ffp-30, -0x1.044ea08e05656p-30},
     /* [17] 6.25 <= y <= 6.5, degree 10, 59.5 bits */
    {0x1.41d6f0ed3256p+3, -0x1.3e553d49977d6p-54, 0x1.748c2a3475a75p+0, 0x1.fc0bd9c864a02p-12, -0x1.c7bc30599aefep-13,
     0x1.297da0aeb99a3p-14, -0x1.2a285684c19e5p-16, 0x1.d4f7dd20805e1p-19, -0x1.1ed85ee0a83eap-21,
     0x1.fc3120856720dp-25, -0x1.b898709ef4fecp-29, -0x1.ca07d23b70655p-32},
     /* [18] 6.5 <= y <= 6.75, degree 10, 62.0 bits */
    {0x1.4d7b8b2d3eea7p+3, -0x1.5f3565d03cac4p-51, 0x1.7499a3d9bba64p+0, 0x1.6a53c93ce4e04p-12, -0x1.4823d545a2d25p-13,
     0x1.b1caf1ec6d02cp-15, -0x1.ba4d20b505697p-17, 0x1.64c428ec590ffp-19, -0x1.c70c60a0a822ep-22,
     0x1.b70b04c9b807bp-25, -0x1.0585c007ca88ep-28, -0x1.93c5947e407ecp-34},
     /* [19] 6.75 <= y <= 7, degree 10, 59.4 bits */
    {0x1.592080dbd5ep+3, -0x1.aad376d022fd9p-51, 0x1.74a33c69c65f7p+0, 0x1.019a8d5c1d49dp-12, -0x1.d6af99b3a72cap-14,
     0x1.3aa5a08023532p-15, -0x1.45bda1699367ep-17, 0x1.0c8da6da4f61bp-19, -0x1.629087dd267e2p-22,
     0x1.6cea33f52d83fp-25, -0x1.0418f69a7c992p-28, 0x1.884c878ff1c38p-34},
     /* [20] 7 <= y <= 7.25, degree 10, 60.1 bits */
    {0x1.64c5b78ee9714p+3, 0x1.c4be0752dd825p-53, 0x1.74aa0c90dc45dp+0, 0x1.6d3fe34c6b01dp-13, -0x1.505e483a239e5p-14,
     0x1.c655a33750f67p-16, -0x1.dcc7d63cdef94p-18, 0x1.90a1a85105c72p-20, -0x1.103faf4d57c6ep-22,
     0x1.26bdd0b7872aep-25, -0x1.d88cedc01ce94p-29, 0x1.82fccba067bebp-33},
     /* [21] 7.25 <= y <= 7.5, degree 10, 59.8 bits */
    {0x1.706b1c5bf3223p+3, -0x1.70d7fbf7cf7e4p-51, 0x1.74aedf7ed854cp+0, 0x1.0240d9933f8ep-13, -0x1.df2e574c0782ep-15,
     0x1.46a3a2cffea37p-16, -0x1.5af8f1ad03371p-18, 0x1.28786da51e705p-20, -0x1.9cfdc571c440cp-23,
     0x1.d1b53269f6939p-26, -0x1.95e11ce718bdfp-29, 0x1.c2a8a817db965p-33},
     /* [22] 7.5 <= y <= 7.75, degree 10, 59.9 bits */
    {0x1.7c10a1c30b297p+3, -0x1.c637a13c184bp-51, 0x1.74b247a3d0ee2p+0, 0x1.6c4daca1f8bc9p-14, -0x1.544833e00388p-15,
     0x1.d3df042ca8112p-17, -0x1.f6799945a8372p-19, 0x1.b3bc37dc36f14p-21, -0x1.360148c6d0979p-23,
     0x1.697dd6018c1c8p-26, -0x1.4f766540d8b5ep-29, 0x1.ba3eb8d414a2fp-33},
     /* [23] 7.75 <= y <= 8, degree 10, 60.0 bits */
    {0x1.87b63e29b0697p+3, -0x1.0071cce4dd7d2p-53, 0x1.74b4ae1c6b60ep+0, 0x1.005cfdc5ad088p-14, -0x1.e1f117a6acfd2p-16,
     0x1.4de9d6fa1e2cdp-17, -0x1.6a301bb3dd56ap-19, 0x1.3e3e961a07721p-21, -0x1.cd43806022308p-24, 0x1.14964b592936p-26,
     -0x1.0d8dfa9223d02p-29, 0x1.8d8d41f3cb14p-33}, /* [24] 8 <= y <= 8.25, degree 10, 62.0 bits */
    {0x1.935beac00a99dp+3, -0x1.90c091b69ea5p-53, 0x1.74b65e144c9fdp+0, 0x1.680a1c9cb4429p-15, -0x1.5467c4d22d4f5p-16,
     0x1.db17926c4d7b4p-18, -0x1.03ff8c812aba4p-19, 0x1.ce543bfd0b33cp-22, -0x1.5484079128f94p-24,
     0x1.a235f9e8577cbp-27, -0x1.a7ec3b761b64ap-30, 0x1.528bd64254974p-33},
     /* [25] 8.25 <= y <= 8.5, degree 10, 59.8 bits */
    {0x1.9f01a2b4841a9p+3, 0x1.2d491f3d60f25p-52, 0x1.74b78d1f1a357p+0, 0x1.f8a2557fa9907p-16, -0x1.dfb78345c55e9p-17,
     0x1.50fbf61b1f218p-18, -0x1.73e418921c2ecp-20, 0x1.4e2e9ec763b4dp-22, -0x1.f35bb58d5da63p-25,
     0x1.38fe263c969cfp-27, -0x1.47adc5e177cccp-30, 0x1.15cf5ee4c5c14p-33},
     /* [26] 8.5 <= y <= 8.75, degree 10, 59.7 bits */
    {0x1.aaa762a0ab9d7p+3, -0x1.562595115b927p-51, 0x1.74b8614e35ca6p+0, 0x1.60fcdee575afdp-16, -0x1.5144176a52637p-17,
     0x1.dcbf3dc0bd069p-19, -0x1.091062240836cp-20, 0x1.e0fb9cc647114p-23, -0x1.6bf7451a26faap-25,
     0x1.d073bf78bd0b4p-28, -0x1.f38d8328f3d94p-31, 0x1.bbbeef83788ebp-34},
     /* [27] 8.75 <= y <= 9, degree 10, 60.4 bits */
    {0x1.b64d281fbba4ep+3, 0x1.d079afad31bbp-51, 0x1.74b8f59a433b9p+0, 0x1.ecf4ed9ccd3b1p-17, -0x1.d93e251016523p-18,
     0x1.5063665c78458p-19, -0x1.78ab12032886ep-21, 0x1.58c1bd0250195p-23, -0x1.07e07f46fd49ep-25,
     0x1.5606d2bd3ad8fp-28, -0x1.7867cad7f853ap-31, 0x1.5b1d57a6e61dcp-34},
     /* [28] 9 <= y <= 9.25, degree 10, 60.0 bits */
    {0x1.c1f2f183436e3p+3, 0x1.ee49ccdd230fbp-51, 0x1.74b95d1254168p+0, 0x1.57a4f150a45bcp-17, -0x1.4b5fa08114bd6p-18,
     0x1.d998206ef02e4p-20, -0x1.0add069ad6eebp-21, 0x1.ec6fca3274261p-24, -0x1.7ccf321f967b5p-26,
     0x1.f473201c91d14p-29, -0x1.18dbb92ba838p-31, 0x1.0b18900b5230bp-34},
     /* [29] 9.25 <= y <= 9.5, degree 10, 59.9 bits */
    {0x1.cd98bd9d83305p+3, 0x1.13c471879fe59p-51, 0x1.74b9a525b55e6p+0, 0x1.de5e1fd4da474p-18, -0x1.cf3843c403622p-19,
     0x1.4ca7d2f507295p-20, -0x1.79227fa7fb6e1p-22, 0x1.5e866e9a45467p-24, -0x1.119b250b565cap-26,
     0x1.6c03b66228dcfp-29, -0x1.9fa41f44745bdp-32, 0x1.9592bb5c68756p-35},
     /* [30] 9.5 <= y <= 9.75, degree 10, 60.1 bits */
    {0x1.d93e8b9b592e8p+3, 0x1.08033bfbbd0bep-51, 0x1.74b9d7474a1dfp+0, 0x1.4c76c32328da1p-18, -0x1.4334d3d839fe6p-19,
     0x1.d25e456ae44d6p-21, -0x1.09d4ee2fea7e3p-22, 0x1.f181a3eb453ap-25, -0x1.87a4fdcb5e222p-27, 0x1.076af1c84fb11p-29,
     -0x1.31baaa297de91p-32, 0x1.2257750b21de4p-35} /* [31] 9.75 <= y <= 10, degree 10, 60.2 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tail_time_of_max_overlap)

/* beta/(1 - eps) at zero overlap, 1 - eps < 1/2: 9 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-57.1 at most, proved for the whole cell of each row. */
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_ROWS 9
#define COR_ROWS_NEAR_BETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_near_beta_zero_overlap, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.bbe2dc8p-1, -0x1.d8263ab5294cdp-28, 0x1.0a54ea8fc9eedp-1, 0x1.50b4cee1b16f6p-2, 0x1.c477e70cbd7dcp-3,
     0x1.42f0fa3233359p-3, 0x1.e74dd0e4b36e1p-4, 0x1.81b5b28a5e45ap-4, 0x1.3d8babc788cb2p-4, 0x1.0dcd5c351b96ep-4,
     0x1.d124a778fb65ep-5, 0x1.e016022bf8cd2p-5}, /* [0] 0 <= y <= 0.03125, degree 10, 59.8 bits */
    {0x1.cd37ecp-1, -0x1.a96efb09550bbp-30, 0x1.20c90447c8287p-1, 0x1.7f3b1a2b5b86p-2, 0x1.0fe0b9929cd7ap-2,
     0x1.9be620fd46476p-3, 0x1.4b1823f20ba73p-3, 0x1.17db1caf1462cp-3, 0x1.ec9bccf73c416p-4, 0x1.bf6c7581275d3p-4,
     0x1.a1453e690496dp-4, 0x1.8b9b6963cb1bbp-4}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 60.0 bits */
    {0x1.e00d05p-1, 0x1.d03bf2cb27051p-28, 0x1.3a6fff4a95ef8p-1, 0x1.b77948ac7548dp-2, 0x1.4a966279cdcdp-2,
     0x1.0b1149b9153c5p-2, 0x1.cbc1cafaf49dcp-3, 0x1.a11451052956cp-3, 0x1.8a551312d7ad2p-3, 0x1.80ccc4a235461p-3,
     0x1.8197794971b89p-3, 0x1.8886b4c6a6e8bp-3}, /* [2] 0.09375 <= y <= 0.15625, degree 10, 59.3 bits */
    {0x1.f49aa38p-1, 0x1.64dfb3dcdf779p-28, 0x1.57fb4044427d1p-1, 0x1.fc54e12ea591p-2, 0x1.97780630eb5aep-2,
     0x1.610a301d1bfcfp-2, 0x1.474ee6621f028p-2, 0x1.40845d50cbf16p-2, 0x1.47589fff5eef8p-2, 0x1.5908cf1c7bbd2p-2,
     0x1.75797e59e8dc7p-2, 0x1.9a57cb0941d65p-2}, /* [3] 0.15625 <= y <= 0.21875, degree 10, 61.8 bits */
    {0x1.0592fc8p+0, 0x1.31b8cb14c18bfp-27, 0x1.7a5356db9aa08p-1, 0x1.28f167bffd779p-1, 0x1.fe464ce11369dp-2,
     0x1.dd51f165660dp-2, 0x1.dfe68a5e2a377p-2, 0x1.fea66dec3c809p-2, 0x1.1b7b2bfdfa54p-1, 0x1.44bde884c53d1p-1,
     0x1.7e0c733f2e4f1p-1, 0x1.c7c7d41bc8f58p-1}, /* [4] 0.21875 <= y <= 0.28125, degree 10, 60.5 bits */
    {0x1.1202888p+0, 0x1.dca96ac70bd71p-30, 0x1.a2afaf75fe4d6p-1, 0x1.5f067dfc1cb65p-1, 0x1.4597cb93dfbddp-1,
     0x1.4b6d2528a5476p-1, 0x1.6c3ff91c3d808p-1, 0x1.a86a3b391da4ap-1, 0x1.0208296ed43dbp+0, 0x1.439144bd83534p+0,
     0x1.a0be2f025288bp+0, 0x1.0fd28ada44dcfp+1}, /* [5] 0.28125 <= y <= 0.34375, degree 10, 59.0 bits */
    {0x1.1fd268p+0, -0x1.3ae7ddf3b807ep-32, 0x1.d2bbedc95a977p-1, 0x1.a4d6fd7956fe4p-1, 0x1.a910b4d0743d9p-1,
     0x1.db56b96faa19ep-1, 0x1.203e8898a34c4p+0, 0x1.731c29ff44ea1p+0, 0x1.f28313b8a5b1dp+0, 0x1.591180f0d5706p+1,
     0x1.eac5dfbceb37bp+1, 0x1.60fb4a3598257p+2}, /* [6] 0.34375 <= y <= 0.40625, degree 10, 59.6 bits */
    {0x1.2f48fc8p+0, 0x1.af8ff8523b1f3p-27, 0x1.066aa626b7768p+0, 0x1.00a3dd0cbda13p+0, 0x1.1d548d232a249p+0,
     0x1.62a00e69d0f66p+0, 0x1.e0059607e209bp+0, 0x1.5929729650b12p+1, 0x1.02cbc10b2848p+2, 0x1.8f9bea9db5788p+2,
     0x1.3d1d646ce278dp+3, 0x1.fc268b06af7abp+3}, /* [7] 0.40625 <= y <= 0.46875, degree 10, 58.3 bits */
    {0x1.40c3a4p+0, -0x1.3b41a369617a7p-27, 0x1.2a3a4a3faad42p+0, 0x1.3fce050c1db3ep+0, 0x1.8cc2d74b9d73dp+0,
     0x1.15ff938e2880fp+1, 0x1.a9d9c68772219p+1, 0x1.5a93c3c9d3b9fp+2, 0x1.25d23456ec99cp+3, 0x1.003c0fe476b37p+4,
     0x1.cbce0037e1694p+4, 0x1.9f97c95b41bf7p+5} /* [8] 0.46875 <= y <= 0.53125, degree 10, 57.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_near_beta_zero_overlap)

/* beta/(1 - eps) at zero force, 1 - eps < 1/2: 24 rows of degree 10 in y = sqrt(1 - eps), nodes 0 + i 0.03125, 0 <= y <= 0.734375.
 * Relative error of the approximation: 2^-56.4 at most, proved for the whole cell of each row. */
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_STEP 0.03125
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_PER_UNIT 32.0
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_ROWS 24
#define COR_ROWS_NEAR_BETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_near_beta_zero_force, 24, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.bbe2dc8p-1, -0x1.d8263ab5294cdp-28, 0x1.b3c687363e21p-80, 0x1.0a54ea8fc9eedp-1, 0x1.4b5d05069ecbcp-3,
     0x1.50b4cee1b176p-2, 0x1.8da2d2d4a8eaep-3, 0x1.2f891c3ab7c41p-2, 0x1.2595a5f518828p-3, 0x1.367a1652a347p-2,
     0x1.ee3fcf1544547p-4, 0x1.1dba1f806318bp-2}, /* [0] 0 <= y <= 0.015625, degree 10, 66.7 bits */
    {0x1.bc2622p-1, -0x1.81aa3eebcd1fep-29, 0x1.0e8d3cdd433bep-5, 0x1.131df6074104bp-1, 0x1.a3cdf22eef25ep-3,
     0x1.74655d6618147p-2, 0x1.0349f79c7cd32p-2, 0x1.5882b7c4056aap-2, 0x1.cba4a3e113e62p-3, 0x1.6635a2efad877p-2,
     0x1.b643bf42ca01cp-3, 0x1.54787090596b3p-2}, /* [1] 0.015625 <= y <= 0.046875, degree 10, 64.3 bits */
    {0x1.bcf30ep-1, -0x1.739cc1c90c84bp-28, 0x1.137b2fb610c5ep-4, 0x1.1e16dd2250e38p-1, 0x1.0333d139effcdp-2,
     0x1.a23a075feeaa3p-2, 0x1.493d2d2bfbae5p-2, 0x1.953649d8aab7bp-2, 0x1.48677202d76d7p-2, 0x1.b426dce692bcfp-2,
     0x1.5517a5f8239dap-2, 0x1.c00401d4530c6p-2}, /* [2] 0.046875 <= y <= 0.078125, degree 10, 63.4 bits */
    {0x1.be4f1f8p-1, -0x1.622302a46c5c4p-28, 0x1.a5c6301d87011p-4, 0x1.2b8497ea75b72p-1, 0x1.3af47b83988d8p-2,
     0x1.dbfcbc58eb0fp-2, 0x1.9cbdaf6e9784fp-2, 0x1.e9f2186c1569ap-2, 0x1.c332bba7d202bp-2, 0x1.14eff1cf512aap-1,
     0x1.f94b2194730bfp-2, 0x1.335212f646e53p-1}, /* [3] 0.078125 <= y <= 0.109375, degree 10, 62.7 bits */
    {0x1.c04111p-1, -0x1.6aa352a69781cp-29, 0x1.1fbb7a67d2016p-3, 0x1.3bbe1a12d4eaap-1, 0x1.7acc9568e6d8ep-2,
     0x1.1216839cb6901p-1, 0x1.016f7c77f892p-1, 0x1.2e9bb6fd6f22fp-1, 0x1.30efa58512eb6p-1, 0x1.6b1d0130d7f31p-1,
     0x1.6f404e02382a3p-1, 0x1.b31e7ebf169c4p-1}, /* [4] 0.109375 <= y <= 0.140625, degree 10, 61.9 bits */
    {0x1.c2d104p-1, -0x1.3df3b94438349p-28, 0x1.7106c7230b73fp-3, 0x1.4f30186853e14p-1, 0x1.c4bd7de724e57p-2,
     0x1.3f18ad549f22fp-1, 0x1.4118a352605d8p-1, 0x1.7c46c8c21708dp-1, 0x1.9a5d7683a6658p-1, 0x1.e8004df620db4p-1,
     0x1.09deb1c38b87bp+0, 0x1.3bcc3f6324c02p+0}, /* [5] 0.140625 <= y <= 0.171875, degree 10, 62.7 bits */
    {0x1.c608b7p-1, -0x1.ed16e8fb9c907p-28, 0x1.c7a3707d3a1acp-3, 0x1.66622b7667b3fp-1, 0x1.0da3b7328b7e4p-1,
     0x1.774fa82b2121dp-1, 0x1.91b777c5390bdp-1, 0x1.e4e2f2947c7c4p-1, 0x1.14cc8bb9325d8p+0, 0x1.4e91d4544c458p+0,
     0x1.82a0e82d3599p+0, 0x1.d42fada63dfd8p+0}, /* [6] 0.171875 <= y <= 0.203125, degree 10, 63.6 bits */
    {0x1.c9f3c98p-1, 0x1.daaa4ec1ad627p-28, 0x1.124aef29418c4p-2, 0x1.81fdbcf14c911p-1, 0x1.40cac2b7e2896p-1,
     0x1.bdd240250d448p-1, 0x1.f93ada7c03b4dp-1, 0x1.393bca4cb74a5p+0, 0x1.77ecc48e48ff5p+0, 0x1.d2e1b55b8b2cbp+0,
     0x1.1bc4d56fab294p+1, 0x1.61d94af8a6bc2p+1}, /* [7] 0.203125 <= y <= 0.234375, degree 10, 62.0 bits */
    {0x1.cea0138p-1, -0x1.f56d95617038p-29, 0x1.4488ff2f2dc33p-2, 0x1.a2d75effd47ccp-1, 0x1.7ddcd9832cd38p-1,
     0x1.0b67b3e45459dp+0, 0x1.3fed688c3eba3p+0, 0x1.99d76e31fc7f6p+0, 0x1.01bc20eaf9e7p+1, 0x1.4b2f09e153d2bp+1,
     0x1.a5e51f80c2eecp+1, 0x1.108fd1dc3235bp+2}, /* [8] 0.234375 <= y <= 0.265625, degree 10, 63.8 bits */
    {0x1.d41e0b8p-1, 0x1.488ddb6d308d7p-28, 0x1.7b43c7571fae8p-2, 0x1.c9fb74b7b7fcp-1, 0x1.c77fe61822cadp-1,
     0x1.43fed72f3e8bcp+0, 0x1.9895fe8ea9e47p+0, 0x1.0f8e59bb9f305p+1, 0x1.6595fe279215p+1, 0x1.dda741f90fff8p+1,
     0x1.3e74d106e039fp+2, 0x1.ac29ad1f33a7bp+2}, /* [9] 0.265625 <= y <= 0.296875, degree 10, 60.8 bits */
    {0x1.da8153p-1, -0x1.939a46ea47e3p-28, 0x1.b7590f1b8397ep-2, 0x1.f8bf7eb2d7869p-1, 0x1.1098ad47cf8e5p+0,
     0x1.8ca024b5e8d42p+0, 0x1.07715709fc584p+1, 0x1.6ca8884b8e63fp+1, 0x1.f6e675fa2f1c7p+1, 0x1.5e6429ba82b9cp+2,
     0x1.e935840334dd6p+2, 0x1.574d86168c74p+3}, /* [10] 0.296875 <= y <= 0.328125, degree 10, 60.9 bits */
    {0x1.e1e15dp-1, 0x1.c553879a07846p-31, 0x1.f9d7139883f8cp-2, 0x1.186d010b4234fp+0, 0x1.47cd196903204p+0,
     0x1.eacf80904dfbdp+0, 0x1.5774b0206d144p+1, 0x1.f0a384630a4a9p+1, 0x1.67137444515bdp+2, 0x1.05c37b8c262d3p+3,
     0x1.7f264d81ff892p+3, 0x1.1971ae39c3801p+4}, /* [11] 0.328125 <= y <= 0.359375, degree 10, 61.2 bits */
    {0x1.ea5a4fp-1, 0x1.9df42fd1eae3cp-28, 0x1.22055070c740ap-1, 0x1.3a41fed284a09p+0, 0x1.8c84bfc5dbdfbp+0,
     0x1.33303c3fef1a6p+1, 0x1.c54b894d0cb6ep+1, 0x1.576500fa29be5p+2, 0x1.04c844baa049ep+3, 0x1.8ee857a4aa2a3p+3,
     0x1.32a3609f2438dp+4, 0x1.d8c56d10576a5p+4}, /* [12] 0.359375 <= y <= 0.390625, degree 10, 59.8 bits */
    {0x1.f40e1d8p-1, -0x1.94e315991a0d2p-28, 0x1.4bc91624e558ap-1, 0x1.6354386b9179ep+0, 0x1.e3153359e40ap+0,
     0x1.854e8e6689327p+1, 0x1.2f419fbb887a4p+2, 0x1.e2dd4e42c512ep+2, 0x1.8203cd8c49fc1p+3, 0x1.3699cc9f0659cp+4,
     0x1.f6b460a8a53adp+4, 0x1.97ca1a0ccc1dbp+5}, /* [13] 0.390625 <= y <= 0.421875, degree 10, 60.7 bits */
    {0x1.ff26028p-1, 0x1.fe05336062e6ep-28, 0x1.7b3c0d06aa357p-1, 0x1.95947fe53055p+0, 0x1.28c5f059c2394p+1,
     0x1.f40d6e3924f2dp+1, 0x1.9c047cfdaa65p+2, 0x1.59cc8a8e7a1a5p+3, 0x1.23c22b1a2a1p+4, 0x1.ef631237b0b6p+4,
     0x1.a72ccf050ecfap+5, 0x1.6a402f21b7ff6p+6}, /* [14] 0.421875 <= y <= 0.453125, degree 10, 60.0 bits */
    {0x1.05ea3b8p+0, 0x1.9871d4c078fb1p-27, 0x1.b1abbba2bddep-1, 0x1.d3a176279bd8p+0, 0x1.70419d293f61ap+1,
     0x1.45ed730851d78p+2, 0x1.1cbbab1156136p+3, 0x1.f985b57f9928cp+3, 0x1.c37fb8513e78p+4, 0x1.95b42931ad66fp+5,
     0x1.6ef47d1249016p+6, 0x1.4c86a0ec82034p+7}, /* [15] 0.453125 <= y <= 0.484375, degree 10, 63.0 bits */
    {0x1.0d2beap+0, 0x1.b6850deb3fb38p-27, 0x1.f0c81fa7e3c1fp-1, 0x1.1089ac9f315cbp+1, 0x1.ce3a26bf9ac11p+1,
     0x1.afe3063462c0fp+2, 0x1.9134f9f232482p+3, 0x1.7a134d33842d5p+4, 0x1.66a9f265b1f69p+5, 0x1.564f1df2cfb4dp+6,
     0x1.48f97aa07e683p+7, 0x1.3cac115fd6f18p+8}, /* [16] 0.484375 <= y <= 0.515625, degree 10, 59.9 bits */
    {0x1.157efbp+0, 0x1.66ac139e468e5p-28, 0x1.1d64d02de34a9p+0, 0x1.41783d19d6ecep+1, 0x1.25f6dfa9416fdp+2,
     0x1.23720d5049b71p+3, 0x1.20e6d1d344accp+4, 0x1.2229f03e38bbbp+5, 0x1.25831bc2af3b3p+6, 0x1.2ab400d1ad6c8p+7,
     0x1.3239956816d21p+8, 0x1.3a5bc4a3b1fd8p+9}, /* [17] 0.515625 <= y <= 0.546875, degree 10, 61.1 bits */
    {0x1.1f14a9p+0, -0x1.bbf0c682d57cp-27, 0x1.4954b2ecc1ffbp+0, 0x1.803268e4b8c05p+1, 0x1.7bb3c0510092ap+2,
     0x1.9198e3b34ec4ap+3, 0x1.aa8bf5630504cp+4, 0x1.caad949628cb2p+5, 0x1.f0eb55ba895bp+6, 0x1.0ed31a0613ee3p+8,
     0x1.29837db4632d2p+9, 0x1.47299de63780cp+10}, /* [18] 0.546875 <= y <= 0.578125, degree 10, 59.5 bits */
    {0x1.2a2c1c8p+0, -0x1.b685e0e720026p-27, 0x1.7e3b90fbf5569p+0, 0x1.d1f5f716d5464p+1, 0x1.f34cf99491ba1p+2,
     0x1.1b5641897a392p+4, 0x1.440506a81bf83p+5, 0x1.76f964ebd1f6cp+6, 0x1.b54e8f1dde062p+7, 0x1.0095454c267e4p+9,
     0x1.2f9d8665d0279p+10, 0x1.677ab7b69232p+11}, /* [19] 0.578125 <= y <= 0.609375, degree 10, 60.1 bits */
    {0x1.3717bf8p+0, -0x1.0475b2c0be579p-27, 0x1.beefbd73796dap+0, 0x1.1f5130301b665p+2, 0x1.4f3ca3001b485p+3,
     0x1.9aee95919a2b9p+4, 0x1.fce2eac4748ap+5, 0x1.3ec90169cd4b5p+7, 0x1.92965b011a851p+8, 0x1.ff9ea70c43f64p+9,
     0x1.4808c88511eb6p+11, 0x1.a4ab39b44e619p+12}, /* [20] 0.609375 <= y <= 0.640625, degree 10, 59.2 bits */
    {0x1.46453f8p+0, 0x1.b372d033de994p-27, 0x1.07c16e09ca65cp+1, 0x1.69362d1c80592p+2, 0x1.cd7412b182ed1p+3,
     0x1.33bc42289696ap+5, 0x1.9f7fde2469c81p+6, 0x1.1bc37f359216dp+8, 0x1.86c3f3e2b4afep+9, 0x1.0ec733174ec0ep+11,
     0x1.7afbf1c416449p+12, 0x1.0909ee1a74936p+14}, /* [21] 0.640625 <= y <= 0.671875, degree 10, 58.9 bits */
    {0x1.584a048p+0, -0x1.c14a1bd0e0dcep-27, 0x1.3afc82188d567p+1, 0x1.d07bb39a7fb09p+2, 0x1.47255f5238f38p+4,
     0x1.dee126264df59p+5, 0x1.635f4efe3cd96p+7, 0x1.0acc8e6fe1adap+9, 0x1.93f617f8c440bp+10, 0x1.33ced631d65dcp+12,
     0x1.da3e4744f1752p+13, 0x1.6cbf28c6e3e8fp+15}, /* [22] 0.671875 <= y <= 0.703125, degree 10, 57.9 bits */
    {0x1.6df74c8p+0, 0x1.8ab1720786c8dp-28, 0x1.7dc590582fba9p+1, 0x1.32d25d785ee7ap+3, 0x1.e0db494bd040dp+4,
     0x1.863f4f120af8p+6, 0x1.418696a77ebcap+8, 0x1.0c09630500d54p+10, 0x1.c2b7f8a2b7d56p+11, 0x1.7d7653d3defa3p+13,
     0x1.46ded498f29bap+15, 0x1.1746a337ca9fep+17} /* [23] 0.703125 <= y <= 0.734375, degree 10, 56.4 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_near_beta_zero_force)

/* beta at zero overlap by eps, 2^-12 <= eps < 2^-1: 88 rows of degree 10 in y = eps 2^-k, 8 to each octave k = -12 ... -2.
 * Relative error of the approximation: 2^-57.5 at most, proved for the whole cell of each row. */
#define COR_ROWS_BETA_ZERO_OVERLAP_FIRST 0.000244140625
#define COR_ROWS_BETA_ZERO_OVERLAP_FIRST_OCTAVE (-12)
#define COR_ROWS_BETA_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_BETA_ZERO_OVERLAP_ROWS 88
#define COR_ROWS_BETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_beta_zero_overlap, 88, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.cf540e7ecc548p+2, 0x1.0a60b8b0e3de9p-53, -0x1.5cdbe6c5df1e9p+0, 0x1.8a0165039ea0ep-1, -0x1.0ff0e658cff36p-1,
     0x1.9982dc619802dp-2, -0x1.43c13587881a9p-2, 0x1.08151094a6135p-2, -0x1.b846e6b900a15p-3, 0x1.74f0b2b607705p-3,
     -0x1.422e22480ad98p-3, 0x1.170001c49cda6p-3}, /* [0] 1 <= y <= 1.125 2^-12, degree 10, 58.6 bits */
    {0x1.c522a5b43857ep+2, -0x1.8150885912485p-52, -0x1.314526dfcfb9fp+0, 0x1.347bc645df622p-1, -0x1.7d0111a0d705bp-2,
     0x1.00ad2ee84fb75p-2, -0x1.6b2134060d70bp-3, 0x1.09055e91d09e8p-3, -0x1.8b55bb4054a82p-4, 0x1.2b9f41f38e0dcp-4,
     -0x1.ce80eee34e683p-5, 0x1.66596cfaeea36p-5}, /* [1] 1.125 <= y <= 1.25 2^-12, degree 10, 59.4 bits */
    {0x1.bc27be37d100ep+2, 0x1.fdc5dad6c2d8bp-53, -0x1.0eb9237c3b208p+0, 0x1.ef0965757367dp-2, -0x1.149789252cc72p-2,
     0x1.512dc2016de9bp-3, -0x1.af96bb06b5cfdp-4, 0x1.1cfc513e4e454p-4, -0x1.80a16f4d0d4acp-5, 0x1.07bf22af3265ap-5,
     -0x1.6ff46ef3d32bcp-6, 0x1.01efd862f9ae1p-6}, /* [2] 1.25 <= y <= 1.375 2^-12, degree 10, 60.1 bits */
    {0x1.b425aeda061bcp+2, -0x1.1f54432ba6639p-57, -0x1.e573675911f01p-1, 0x1.953ef219613f3p-2, -0x1.9d77e00226308p-3,
     0x1.cc3549785cff3p-4, -0x1.0cebf036b228bp-4, 0x1.4443d2419e974p-5, -0x1.8f96c044c35fcp-6, 0x1.f45acaeaad5a2p-7,
     -0x1.3e6ab4ca05efcp-7, 0x1.9798ec86da2e2p-8}, /* [3] 1.375 <= y <= 1.5 2^-12, degree 10, 61.4 bits */
    {0x1.acef265628025p+2, 0x1.e36a398e110d6p-52, -0x1.b73a8576f1b3ap-1, 0x1.5153db3ca0c62p-2, -0x1.3ca35d267b90dp-3,
     0x1.443cc9e1bfa1ep-4, -0x1.5c9ebfb5339c9p-5, 0x1.82bc64b69dd45p-6, -0x1.b6724101aa957p-7, 0x1.f9170ec4fda9fp-8,
     -0x1.27883b05013aep-8, 0x1.5c092f6fd9145p-9}, /* [4] 1.5 <= y <= 1.625 2^-12, degree 10, 61.7 bits */
    {0x1.a661eaa0a9451p+2, 0x1.87e4e9c45f538p-52, -0x1.907b2e1b2ce7p-1, 0x1.1cc95f5d47052p-2, -0x1.ef0956c1c696p-4,
     0x1.d55e301feaaadp-5, -0x1.d34826d7c61fbp-6, 0x1.dff933e895baap-7, -0x1.f7d7fbf91da0fp-8, 0x1.0cb7736f0e6cep-8,
     -0x1.23056951d37fp-9, 0x1.3d5593c7f41aap-10}, /* [5] 1.625 <= y <= 1.75 2^-12, degree 10, 64.9 bits */
    {0x1.a063896aea7b1p+2, 0x1.75a7614024e91p-54, -0x1.6f922107df19bp-1, 0x1.e6b6e6e1cd668p-3, -0x1.89d8dbc906df7p-4,
     0x1.5bac0357355bfp-5, -0x1.4241834a2bd7fp-6, 0x1.342e2c56f99c7p-7, -0x1.2d324197bc32fp-8, 0x1.2b1e7b9735bfdp-9,
     -0x1.2d7cf62ec8a42p-10, 0x1.3212dd24f66b5p-11}, /* [6] 1.75 <= y <= 1.875 2^-12, degree 10, 60.8 bits */
    {0x1.9adf2d273b999p+2, 0x1.65f22eebe34dp-52, -0x1.534cf2167db97p-1, 0x1.a44b7e750459p-3, -0x1.3e28a1caac0f5p-4,
     0x1.06bcce4732e68p-5, -0x1.c7a3416922d71p-7, 0x1.979fd0cec0881p-8, -0x1.74af374522a14p-9, 0x1.5a3c603154b96p-10,
     -0x1.465c17ee60dcdp-11, 0x1.35f24a648ded9p-12}, /* [7] 1.875 <= y <= 2 2^-12, degree 10, 60.7 bits */
    {0x1.9359caeecbd5bp+2, 0x1.716481a71452ap-55, -0x1.2fb30b3e58f21p+0, 0x1.57006d1321528p-1, -0x1.d97a100af45e7p-2,
     0x1.64800c12a9938p-2, -0x1.19d8488615064p-2, 0x1.cbcb411ed5e82p-3, -0x1.7f4889e28a698p-3, 0x1.44a9cfa3f8e7ap-3,
     -0x1.187962cc8441cp-3, 0x1.e5c46b3c89ea8p-4}, /* [8] 1 <= y <= 1.125 2^-11, degree 10, 58.6 bits */
    {0x1.8a7a2b80d35c4p+2, -0x1.026718846fb9cp-52, -0x1.09c0c9c54c57cp+0, 0x1.0c8cec3af6cb6p-1, -0x1.4baef3445cb85p-2,
     0x1.bee65536b7929p-3, -0x1.3c1f6d8d02ef6p-3, 0x1.cd6da621a1871p-4, -0x1.5828b4e344819p-4, 0x1.04d6106a9c6c3p-4,
     -0x1.92a1ffc0e91bcp-5, 0x1.37f6114fb3deap-5}, /* [9] 1.125 <= y <= 1.25 2^-11, degree 10, 60.5 bits */
    {0x1.82a8db8880a4ap+2, -0x1.a2f39f1b8df7cp-53, -0x1.d75b41429bf07p-1, 0x1.aef458eadbd57p-2, -0x1.e193149079e7p-3,
     0x1.2587f8f7a8775p-3, -0x1.77b84930a9dcdp-4, 0x1.f030536d3035ep-5, -0x1.4ed723cc9e0c3p-5, 0x1.cb35a4940a99p-6,
     -0x1.4052c2150accfp-6, 0x1.c1181ec3196dp-7}, /* [10] 1.25 <= y <= 1.375 2^-11, degree 10, 60.6 bits */
    {0x1.7bb02d386a1ccp+2, 0x1.742629492ed1bp-53, -0x1.a69c05cff3512p-1, 0x1.60c97ad1d3165p-2, -0x1.67f1ed6e561ap-3,
     0x1.90a26c373c4fdp-4, -0x1.d438427c1f44ap-5, 0x1.1a49fcbb6d02fp-5, -0x1.5bdcc0ddc1d2fp-6, 0x1.b3958304fe222p-7,
     -0x1.1532ac61623bp-7, 0x1.62d58843537c9p-8}, /* [11] 1.375 <= y <= 1.5 2^-11, degree 10, 60.7 bits */
    {0x1.7568ad12f2f45p+2, 0x1.24dabe9766635p-53, -0x1.7e5ee67aef555p-1, 0x1.25a923aa0d132p-2, -0x1.13a6467b1e35fp-3,
     0x1.1a43dd4a6ba69p-4, -0x1.2f7dcf1f086fep-5, 0x1.50ac54421742p-6, -0x1.7db08ec755483p-7, 0x1.b7b4d999cba05p-8,
     -0x1.014692f606002p-8, 0x1.2efb9ad3746a4p-9}, /* [12] 1.5 <= y <= 1.625 2^-11, degree 10, 62.0 bits */
    {0x1.6fb48f4a72acp+2, 0x1.40f19aa7a881dp-53, -0x1.5ca39cbade7a3p-1, 0x1.efd7a032aa7c8p-3, -0x1.aef44c8508f9p-4,
     0x1.989bc6651544ep-5, -0x1.96cae07a095b2p-6, 0x1.a1d7554035a5p-7, -0x1.b69f149df0912p-8, 0x1.d3dcdf9360d69p-9,
     -0x1.fab27dc3f51c5p-10, 0x1.14416b25c10b2p-10}, /* [13] 1.625 <= y <= 1.75 2^-11, degree 10, 62.0 bits */
    {0x1.6a7ccdf9dbfe9p+2, 0x1.0b9b0fa8da817p-52, -0x1.3ffd2de6f7e8ep-1, 0x1.a7b5a4b55f932p-3, -0x1.56dd23d269474p-4,
     0x1.2eaa7d2c68dap-5, -0x1.188a42f65174dp-6, 0x1.0c495d2c6946ep-7, -0x1.0634e51382d2bp-8, 0x1.0465f5b382178p-9,
     -0x1.0675ee014276bp-10, 0x1.0a73ded7a0af8p-11}, /* [14] 1.75 <= y <= 1.875 2^-11, degree 10, 61.9 bits */
    {0x1.65af460065a7bp+2, -0x1.34d7454d31573p-53, -0x1.2760d8668a824p-1, 0x1.6de351036adecp-3, -0x1.14f9280a5a0cap-4,
     0x1.c973da0153d02p-6, -0x1.8ca7dd54f80bdp-7, 0x1.62db86acf62c6p-8, -0x1.4470ce1447e6fp-9, 0x1.2d6a72b23b088p-10,
     -0x1.1c1cd712b31e2p-11, 0x1.0dd2f530ad708p-12}, /* [15] 1.875 <= y <= 2 2^-11, degree 10, 62.3 bits */
    {0x1.5f23212d3b796p+2, 0x1.291c9a47443p-52, -0x1.0862bbb47e42bp+0, 0x1.2a99abfdcd75dp-1, -0x1.9c2f809a60a4cp-2,
     0x1.3659f2a2dda57p-2, -0x1.eab8741c27543p-3, 0x1.90461b30e3bf5p-3, -0x1.4daae332d930cp-3, 0x1.1aa2c6df54915p-3,
     -0x1.e85579becae5ep-4, 0x1.a6e28cdeceeddp-4}, /* [16] 1 <= y <= 1.125 2^-10, degree 10, 58.6 bits */
    {0x1.5769912d1886dp+2, 0x1.520467f42e1d5p-53, -0x1.ceb3f74933bbbp-1, 0x1.d392d045f803p-2, -0x1.20bf4d5dd869fp-2,
     0x1.850c6f88704dcp-3, -0x1.133374dfe99e3p-3, 0x1.91b255dd3562bp-4, -0x1.2b9b9810d24ap-4, 0x1.c62466d1d353ep-5,
     -0x1.5e832191c54f6p-5, 0x1.0f93f7e8db9fdp-5}, /* [17] 1.125 <= y <= 1.25 2^-10, degree 10, 60.0 bits */
    {0x1.509b52cc16645p+2, 0x1.9bb75bdd73dd3p-54, -0x1.9a56f3751acbap-1, 0x1.772ae567b9961p-2, -0x1.a33c3ed8bfcacp-3,
     0x1.ff1114961ffbep-4, -0x1.47155eaa16cfbp-4, 0x1.aff5156bbd97ep-5, -0x1.237ed3f0e409cp-5, 0x1.8fc3df5ffd40ap-6,
     -0x1.16db8d56926ccp-6, 0x1.86f59096af90ep-7}, /* [18] 1.25 <= y <= 1.375 2^-10, degree 10, 61.7 bits */
    {0x1.4a89ab196d28ep+2, -0x1.e3e023bcfe458p-53, -0x1.6fe72726f014dp-1, 0x1.331e67108d49bp-2, -0x1.3959d47c26cebp-3,
     0x1.5cc58ba489f3bp-4, -0x1.979c13402662bp-5, 0x1.eb7e64766460ep-6, -0x1.2ed4e43878fecp-6, 0x1.7b32a907c5ba5p-7,
     -0x1.e2a133c36002p-8, 0x1.34e6abb34085bp-8}, /* [19] 1.375 <= y <= 1.5 2^-10, degree 10, 60.5 bits */
    {0x1.451241f44ed71p+2, -0x1.3781e94b72c31p-52, -0x1.4cdf834fe5221p-1, 0x1.ff4ad760228efp-3, -0x1.dfef6e889af98p-4,
     0x1.eb7329da3e17p-5, -0x1.08348f6aa6fc4p-5, 0x1.251753715e09p-6, -0x1.4c47aaa413bep-7, 0x1.7ec95e428f996p-8,
     -0x1.bff1698c36ecbp-9, 0x1.07c30c7b1dcfbp-9}, /* [20] 1.5 <= y <= 1.625 2^-10, degree 10, 60.5 bits */
    {0x1.401b26f51f1b5p+2, 0x1.0d6e627a768ecp-52, -0x1.2f82121d975b2p-1, 0x1.afa7a0f9e096bp-3, -0x1.772b7224bf8cp-4,
     0x1.63b634629dd33p-5, -0x1.6222788a293e3p-6, 0x1.6bc091da41acap-7, -0x1.7dd77f51544dbp-8, 0x1.974c49159998bp-9,
     -0x1.b91b069a8f54dp-10, 0x1.e0fd2a3a2d802p-11}, /* [21] 1.625 <= y <= 1.75 2^-10, degree 10, 60.7 bits */
    {0x1.3b904f2711608p+2, -0x1.011c6dcab2f47p-52, -0x1.1691186e85fa4p-1, 0x1.70dbef5bdd84bp-3, -0x1.2a7bb379fa639p-4,
     0x1.077ba992a59e5p-5, -0x1.e8736582185f7p-7, 0x1.d31d74e4c9187p-8, -0x1.c8871e5a60a69p-9, 0x1.c5611a975897bp-10,
     -0x1.c8f871c4494f4p-11, 0x1.cfebca8d7b37bp-12}, /* [22] 1.75 <= y <= 1.875 2^-10, degree 10, 61.3 bits */
    {0x1.3761f06e61969p+2, -0x1.66424adbc6187p-52, -0x1.01245d40476dfp-1, 0x1.3e859a530eb81p-3, -0x1.e23ef01771cd3p-5,
     0x1.8e3aa10e67bc4p-6, -0x1.594f814a19c48p-7, 0x1.34ec2d2dfde9ep-8, -0x1.1a7116a4c5d28p-9, 0x1.0665b78bd9d4cp-10,
     -0x1.eeab2bd055888p-12, 0x1.d5ca826c32f1dp-13}, /* [23] 1.875 <= y <= 2 2^-10, degree 10, 60.9 bits */
    {0x1.31aec4cacbcf1p+2, 0x1.d666572fa1e24p-53, -0x1.cc52c3bbd3966p-1, 0x1.03f17f1e7fb71p-1, -0x1.66d69d5a53a78p-2,
     0x1.0e2b5ae85570ep-2, -0x1.ab32f7b29ecf8p-3, 0x1.5c76082f861e6p-3, -0x1.227976d29c29ap-3, 0x1.ec18b5c1942c6p-4,
     -0x1.a91e6b55213d3p-4, 0x1.70248914988f4p-4}, /* [24] 1 <= y <= 1.125 2^-9, degree 10, 58.6 bits */
    {0x1.2af531b5ebc24p+2, -0x1.b0c7c6365ac1dp-54, -0x1.92cefc3f4a5d6p-1, 0x1.97090c41a98a1p-2, -0x1.f6c3fc479158cp-3,
     0x1.52abdcf12b0abp-3, -0x1.df2742ddc6d48p-4, 0x1.5db3a162557b1p-4, -0x1.04d315972feecp-4, 0x1.8b5a48e26665fp-5,
     -0x1.31234676b1da7p-5, 0x1.d8d823e64304dp-6}, /* [25] 1.125 <= y <= 1.25 2^-9, degree 10, 60.5 bits */
    {0x1.25087894ad005p+2, 0x1.8ec0521815464p-53, -0x1.6539af339298ep-1, 0x1.4695e18a2ee26p-2, -0x1.6d001ceee03ecp-3,
     0x1.bce13a89260d8p-4, -0x1.1cbd81e6dcd3ep-4, 0x1.780c40e279cdep-5, -0x1.fb8710d0bf8dcp-6, 0x1.5c03e054c8715p-6,
     -0x1.e5846821a67d1p-7, 0x1.54595001ca03ep-7}, /* [26] 1.25 <= y <= 1.375 2^-9, degree 10, 60.1 bits */
    {0x1.1fbfea4f9a39dp+2, 0x1.d7801cab0700bp-52, -0x1.4048d9afab7c3p-1, 0x1.0b569cb7f9046p-2, -0x1.10d4702bac68bp-3,
     0x1.2f98953ee6aa4p-4, -0x1.62d5da2e96a91p-5, 0x1.abe15a5b86e6ep-6, -0x1.07a28b8230fc9p-6, 0x1.4a1c8b1a645eap-7,
     -0x1.a426bbf3d15fbp-8, 0x1.0ce9a488f3ba9p-8}, /* [27] 1.375 <= y <= 1.5 2^-9, degree 10, 62.7 bits */
    {0x1.1afd9ffc6af4ap+2, 0x1.63ebd6f3afc39p-53, -0x1.21caf8387178p-1, 0x1.bd0a6a6c80034p-3, -0x1.a1e7a39f37397p-4,
     0x1.abc8c29612cb3p-5, -0x1.cbfbae1b41837p-6, 0x1.fe504ff8421a8p-7, -0x1.21465e28d8b5ep-7, 0x1.4d3ce8628e299p-8,
     -0x1.85f4891e41864p-9, 0x1.cb3b9bd60c76dp-10}, /* [28] 1.5 <= y <= 1.625 2^-9, degree 10, 60.0 bits */
    {0x1.16ab03b6430dap+2, 0x1.dd6c2baf268fep-52, -0x1.083bd983dadc3p-1, 0x1.77b16500ab478p-3, -0x1.46b646bce2b78p-4,
     0x1.35a03085ea9c3p-5, -0x1.344381f06c329p-6, 0x1.3caba5997dd4ep-7, -0x1.4c6d18ed55895p-8, 0x1.62948aca22ffp-9,
     -0x1.8001132022806p-10, 0x1.a2b8b6441da89p-11}, /* [29] 1.625 <= y <= 1.75 2^-9, degree 10, 60.0 bits */
    {0x1.12b6a180eb6a7p+2, -0x1.3947f54a6addp-57, -0x1.e50dd8331752cp-2, 0x1.41014c1cdf0bbp-3, -0x1.03f6137f76614p-4,
     0x1.cab0b3d56418p-6, -0x1.a92975b962e45p-7, 0x1.96a601600a44cp-8, -0x1.8d737431b533p-9, 0x1.8ab3e05fc9e3bp-10,
     -0x1.8dd172ce30d73p-11, 0x1.93dd02e443dfbp-12}, /* [30] 1.75 <= y <= 1.875 2^-9, degree 10, 62.2 bits */
    {0x1.0f12b927b7c2ep+2, 0x1.831822293d91bp-52, -0x1.bfc41a8ef1092p-2, 0x1.1529569d17994p-3, -0x1.a410b1d6aaa97p-5,
     0x1.5aa2f0a059563p-6, -0x1.2c8d5f3010d5cp-7, 0x1.0ced22a06a668p-8, -0x1.ebc9cf998fde2p-10, 0x1.c8e206ecd865fp-11,
     -0x1.aea4288cdfde7p-12, 0x1.98f982011d712p-13}, /* [31] 1.875 <= y <= 2 2^-9, degree 10, 61.3 bits */
    {0x1.0a1c3c33a647ep+2, 0x1.8278df1d33396p-52, -0x1.90d155b5301e7p-1, 0x1.c442cb148e511p-2, -0x1.38a4be0b747edp-2,
     0x1.d65c354a7e302p-3, -0x1.73cb357d83b97p-3, 0x1.2f538f0b28d7cp-3, -0x1.f9c60b4fbdc2bp-4, 0x1.ac6d659002834p-4,
     -0x1.721a39be4522dp-4, 0x1.407d1de26b8ep-4}, /* [32] 1 <= y <= 1.125 2^-8, degree 10, 58.4 bits */
    {0x1.0441188087adcp+2, -0x1.58a821a0f69f1p-52, -0x1.5ecb8b42fffb4p-1, 0x1.61ebdd825e618p-2, -0x1.b632640c34b9cp-3,
     0x1.26db63e02eb83p-3, -0x1.a0f6c7accd6ffp-4, 0x1.305df6640423dp-4, -0x1.c6210b0100842p-5, 0x1.5835a80c613e3p-5,
     -0x1.09a8f390e822bp-5, 0x1.9ba65510ee5fbp-6}, /* [33] 1.125 <= y <= 1.25 2^-8, degree 10, 59.6 bits */
    {0x1.fe3027fb6fa6fp+1, 0x1.a64c824ca0ad4p-53, -0x1.372be6f4c8d82p-1, 0x1.1bca90d6e2b42p-2, -0x1.3e3d9a27b9101p-3,
     0x1.836e0ca5f4159p-4, -0x1.ef887d7f39105p-5, 0x1.473e1c10267b9p-5, -0x1.b9cb431e4c277p-6, 0x1.2efed05835f39p-6,
     -0x1.a6b89633dd0e4p-7, 0x1.2850b1a31a416p-7}, /* [34] 1.25 <= y <= 1.375 2^-8, degree 10, 61.2 bits */
    {0x1.f4fb6f87f4fa7p+1, -0x1.f8197292d7b71p-53, -0x1.171540622bed7p-1, 0x1.d04057706b4c3p-3, -0x1.dbeaee0269289p-4,
     0x1.087e15c38b293p-4, -0x1.34c2e3c80ecp-5, 0x1.74476be3fbd0bp-6, -0x1.cae8f7c313271p-7, 0x1.1f6505950633bp-7,
     -0x1.6dd1fed2faea9p-8, 0x1.d44495f9c610ap-9}, /* [35] 1.375 <= y <= 1.5 2^-8, degree 10, 60.2 bits */
    {0x1.ecafe134d228ap+1, -0x1.cc96337241cd7p-53, -0x1.f93d0705cd9a1p-2, 0x1.820f9e099818fp-3, -0x1.6c97dbb7bde52p-4,
     0x1.74ddcd3cbb91fp-5, -0x1.904c6ab81fd2cp-6, 0x1.bbec87d88cac2p-7, -0x1.f770c6dfdf126p-8, 0x1.22163a6ac06f7p-8,
     -0x1.53873bbf34aa5p-9, 0x1.8fdc21b789c06p-10}, /* [36] 1.5 <= y <= 1.625 2^-8, degree 10, 61.3 bits */
    {0x1.e52615feb4ac5p+1, 0x1.cc8d2e4b76bbep-54, -0x1.cceadb21d5b33p-2, 0x1.458dcffddc0cep-3, -0x1.1d162ba849a14p-4,
     0x1.0e079c45f6cd1p-5, -0x1.0c535ad1cf929p-6, 0x1.1370097f576adp-7, -0x1.2133bc546ca35p-8, 0x1.349d8cfb92a26p-9,
     -0x1.4e549cf747bd2p-10, 0x1.6c98f559d0e4bp-11}, /* [37] 1.625 <= y <= 1.75 2^-8, degree 10, 61.6 bits */
    {0x1.de3f993eb74b5p+1, 0x1.1a8bf617022c1p-54, -0x1.a751bf6dc5b67p-2, 0x1.15d4e869b9d3dp-3, -0x1.c5b5df5feadb6p-5,
     0x1.90475bb0d3fe5p-6, -0x1.72355694ae5e7p-7, 0x1.61ae3a07952ffp-8, -0x1.59b03abaaf574p-9, 0x1.5776460852a27p-10,
     -0x1.5a522ede88281p-11, 0x1.5fa8a6a40b50ep-12}, /* [38] 1.75 <= y <= 1.875 2^-8, degree 10, 63.9 bits */
    {0x1.d7e46b5d8777ap+1, -0x1.0de5711c0add6p-53, -0x1.871109e28dbc6p-2, 0x1.df2518003f8a5p-4, -0x1.6e8afcf486cdp-5,
     0x1.2eb00382bd0edp-6, -0x1.05d4138d566abp-7, 0x1.d3d0a31a9fd4fp-9, -0x1.aba4dea41350dp-10, 0x1.8d7777f5dd3d1p-11,
     -0x1.76d53d73f4e46p-12, 0x1.6417735659f3bp-13}, /* [39] 1.875 <= y <= 2 2^-8, degree 10, 60.9 bits */
    {0x1.cf37ce9c73be2p+1, 0x1.715987360464dp-54, -0x1.5e86b577d9625p-1, 0x1.8619eb3f5d71ep-2, -0x1.10b31bbcbbe49p-2,
     0x1.9b1af03af2a73p-3, -0x1.442f76d67b7edp-3, 0x1.07e70d4d48383p-3, -0x1.b7b2eed64781cp-4, 0x1.748d651b44931p-4,
     -0x1.4206e1d8d0645p-4, 0x1.16ff5f2529f18p-4}, /* [40] 1 <= y <= 1.125 2^-7, degree 10, 58.2 bits */
    {0x1.c4f71105cd3dp+1, 0x1.d526c7d8273cfp-55, -0x1.3370af0a714cep-1, 0x1.305d75a45ea57p-2, -0x1.7dcbeb1afbef7p-3,
     0x1.01f9d9b94e3b3p-3, -0x1.6c1bdb7d8c75cp-4, 0x1.0905a131b77a4p-4, -0x1.8aca3a8475bf5p-5, 0x1.2b29a081c4b26p-5,
     -0x1.ce05d20d54c01p-6, 0x1.66315d50b7073p-6}, /* [41] 1.125 <= y <= 1.25 2^-7, degree 10, 59.8 bits */
    {0x1.bbe8b90604dddp+1, 0x1.07bdb78139881p-53, -0x1.116a39aeaccdfp-1, 0x1.e69d75202dccep-3, -0x1.14cf606163e96p-3,
     0x1.532e5e38c5d5bp-4, -0x1.b168feef148c9p-5, 0x1.1d4c8b6bc3494p-5, -0x1.80397d917a1d1p-6, 0x1.07437974867a3p-6,
     -0x1.6f5b34aeef74ap-7, 0x1.01adb3d36c95p-7}, /* [42] 1.25 <= y <= 1.375 2^-7, degree 10, 59.9 bits */
    {0x1.b3cf052de908ap+1, 0x1.e9421e0c48a8bp-53, -0x1.ebe3723aa310ep-2, 0x1.8cd3e61870ffap-3, -0x1.9d09efc44e039p-4,
     0x1.cf28868c6a781p-5, -0x1.0e76af603956ap-5, 0x1.45141b0794b8ep-6, -0x1.8f7637a5e753ep-7, 0x1.f372892a9f4d8p-8,
     -0x1.3dc03bb878f0ep-8, 0x1.96ed7f19e90c7p-9}, /* [43] 1.375 <= y <= 1.5 2^-7, degree 10, 61.9 bits */
    {0x1.ac7ca42427705p+1, -0x1.3906eea5d5e6ep-53, -0x1.beb5fa06edcbfp-2, 0x1.490d4ad776d55p-3, -0x1.3b956884d9a61p-4,
     0x1.4651da3a7db4ep-5, -0x1.5f17e290b3b61p-6, 0x1.845298c5ac4b6p-7, -0x1.b6cb6c3674147p-8, 0x1.f85fa78684af9p-9,
     -0x1.26d9455ae89b6p-9, 0x1.5b43749dac2f9p-10}, /* [44] 1.5 <= y <= 1.625 2^-7, degree 10, 61.1 bits */
    {0x1.a5cf6dabe5891p+1, -0x1.7d2f355034e8fp-53, -0x1.98fbd15dee6ffp-2, 0x1.14c076c97c2d3p-3, -0x1.ec10811f29e85p-5,
     0x1.d82a5ddeeb163p-6, -0x1.d71c3ee496779p-7, 0x1.e2bb87e92f471p-8, -0x1.f8f394b7c528ap-9, 0x1.0c8b1b058c6eep-9,
     -0x1.22609b660f82bp-10, 0x1.3c81036ecf5b3p-11}, /* [45] 1.625 <= y <= 1.75 2^-7, degree 10, 61.2 bits */
    {0x1.9fad0df2d59dcp+1, 0x1.b3fd900e16f5ep-54, -0x1.790f1ba8ac0a3p-2, 0x1.d7424a33c57ap-4, -0x1.864ff85a1676dp-5,
     0x1.5d6cd0be2f89p-6, -0x1.4524ab84a2e41p-7, 0x1.367044bc13dc7p-8, -0x1.2e569b5b1cc47p-9, 0x1.2b42253fc1995p-10,
     -0x1.2cf531ebf00bep-11, 0x1.313b68c5e528bp-12}, /* [46] 1.75 <= y <= 1.875 2^-7, degree 10, 61.8 bits */
    {0x1.9a00d6756e019p+1, 0x1.ae1b89de8e055p-53, -0x1.5dbbb7e2cc0dbp-2, 0x1.958963a7bae58p-4, -0x1.3a49bf4a9f685p-5,
     0x1.07b60c4f35d3cp-6, -0x1.cbe68f1cc5b6ap-8, 0x1.9b3058b4fb0a9p-9, -0x1.76b8d5e5895adp-10, 0x1.5adfa8cff6666p-11,
     -0x1.460b8cab336fdp-12, 0x1.35264c931ab18p-13}, /* [47] 1.875 <= y <= 2 2^-7, degree 10, 61.0 bits */
    {0x1.9238cfa2e599dp+1, -0x1.3919d5b119b01p-53, -0x1.3b76a2c2c0d38p-1, 0x1.495e255db0bdbp-2, -0x1.d153945dd0082p-3,
     0x1.64dd2d0391e47p-3, -0x1.1c728ee2f2e36p-3, 0x1.d095dd1b75dcfp-4, -0x1.82529a01acd37p-4, 0x1.4608c03579f1cp-4,
     -0x1.18af7997eefd5p-4, 0x1.e4efd720c4559p-5}, /* [48] 1 <= y <= 1.125 2^-6, degree 10, 58.6 bits */
    {0x1.88f4839b8220bp+1, -0x1.1096af1017297p-53, -0x1.172035b9ff5f7p-1, 0x1.0070b97727434p-2, -0x1.43ad162d0eee6p-3,
     0x1.bd4fc4482cfefp-4, -0x1.3e9738085512fp-4, 0x1.d2cafef37d66fp-5, -0x1.5bda9d959496cp-5, 0x1.06ce87683b777p-5,
     -0x1.942493d61d382p-6, 0x1.381808fc2320dp-6}, /* [49] 1.125 <= y <= 1.25 2^-6, degree 10, 59.7 bits */
    {0x1.80b2694b3a22bp+1, 0x1.610198cd1f914p-53, -0x1.f4f21006ab147p-2, 0x1.99a48a58c7c12p-3, -0x1.d2a62bbf056ebp-4,
     0x1.22eb1813aa36fp-4, -0x1.79a6cdc1188a3p-5, 0x1.f5f089e77e094p-6, -0x1.5315207999917p-6, 0x1.d0119abcea54bp-7,
     -0x1.4293d28cc956bp-7, 0x1.c29584b390fc3p-8}, /* [50] 1.25 <= y <= 1.375 2^-6, degree 10, 60.5 bits */
    {0x1.793e4624ce5adp+1, 0x1.1b0b94a6b227ap-53, -0x1.c6b1658af1fbbp-2, 0x1.4e24eb7151911p-3, -0x1.5a6dca52daf9ap-4,
     0x1.8abfcbd10c2aap-5, -0x1.d4ed99907ba48p-6, 0x1.1d39863acead5p-6, -0x1.609610f477f3ep-7, 0x1.b93a03dd62e9dp-8,
     -0x1.18034f1f5506bp-8, 0x1.6525ad150180ap-9}, /* [51] 1.375 <= y <= 1.5 2^-6, degree 10, 60.7 bits */
    {0x1.7271fbf2f6b12p+1, 0x1.1dab832f47deap-54, -0x1.a0a1c5f4af219p-2, 0x1.1569e695c69e3p-3, -0x1.079bb0a37a76fp-4,
     0x1.146ebd99287acp-5, -0x1.2ea367b14083cp-6, 0x1.53712fbe5996dp-7, -0x1.82d4f44cef726p-8, 0x1.be14d3b1993b2p-9,
     -0x1.0490d528fad68p-9, 0x1.31e787d1675f2p-10}, /* [52] 1.5 <= y <= 1.625 2^-6, degree 10, 61.2 bits */
    {0x1.6c30f196618c6p+1, -0x1.c4395c8566548p-54, -0x1.80cbb430bb7cap-2, 0x1.d398789b8117cp-4, -0x1.99b2f3c69ed1ep-5,
     0x1.8db9b80fb11c3p-6, -0x1.93b3944928c8ap-7, 0x1.a409e1112148ap-8, -0x1.bc139ec206538p-9, 0x1.daf59e6549b36p-10,
     -0x1.011642ef9df78p-10, 0x1.17af0121dea7bp-11}, /* [53] 1.625 <= y <= 1.75 2^-6, degree 10, 64.8 bits */
    {0x1.6665312fdb0dap+1, 0x1.1c30dcbec36bap-55, -0x1.65caaa00ad228p-2, 0x1.8f337a7fcf7a1p-4, -0x1.44334edbf42adp-5,
     0x1.24d679194a06p-6, -0x1.14fd04e745279p-7, 0x1.0cbd7e06424eep-8, -0x1.08fcd0da317f8p-9, 0x1.084ded298a0b1p-10,
     -0x1.0aa7e0063f895p-11, 0x1.0e5ab008daee5p-12}, /* [54] 1.75 <= y <= 1.875 2^-6, degree 10, 63.4 bits */
    {0x1.60fd8721047fdp+1, -0x1.150163b6182aap-54, -0x1.4e9ba9f69b90dp-2, 0x1.58a8427686349p-4, -0x1.04a09370e6aebp-5,
     0x1.b80770a4a6d23p-7, -0x1.85936cd69167ap-8, 0x1.620959dc621d7p-9, -0x1.47133a0291716p-10, 0x1.31a89c59473f8p-11,
     -0x1.20cad26b544f3p-12, 0x1.1235d6991948fp-13}, /* [55] 1.875 <= y <= 2 2^-6, degree 10, 62.7 bits */
    {0x1.598071d006b9fp+1, -0x1.7f4fda5bb0126p-53, -0x1.31676c7f29ff7p-1, 0x1.1989390a5315bp-2, -0x1.816c9b36a8caep-3,
     0x1.2814e20b06d8fp-3, -0x1.de2473b74dfb3p-4, 0x1.8cbc84f5adeb5p-4, -0x1.4ed24a5c67668p-4, 0x1.1de284c28158dp-4,
     -0x1.f01bfb9def762p-5, 0x1.ae4435591fb68p-5}, /* [56] 1 <= y <= 1.125 2^-5, degree 10, 58.5 bits */
    {0x1.5076fca428bd5p+1, 0x1.2bea10a3172d2p-54, -0x1.12371c56a8938p-1, 0x1.ba4241996cf9bp-3, -0x1.0c35bfdd1fd2bp-3,
     0x1.6f816cf592ae1p-4, -0x1.0964f61f51fbbp-4, 0x1.8a7b897d2c4b1p-5, -0x1.2a70cb35db04ep-5, 0x1.c9090bd736acep-6,
     -0x1.6322e75aa4c82p-6, 0x1.1431d604be0b6p-6}, /* [57] 1.125 <= y <= 1.25 2^-5, degree 10, 58.9 bits */
    {0x1.484c1b36b0fc8p+1, -0x1.e56883078aebep-54, -0x1.f2ca1944ade9ap-2, 0x1.64a2494c95633p-3, -0x1.8388efd6d7a84p-4,
     0x1.dea53c016d76p-5, -0x1.38653a22f14d5p-5, 0x1.a446470217e9p-6, -0x1.20067271b0741p-6, 0x1.8fc2fe8e2e048p-7,
     -0x1.194bf0877d6acp-7, 0x1.8ca6bd73f46e8p-8}, /* [58] 1.25 <= y <= 1.375 2^-5, degree 10, 60.0 bits */
    {0x1.40d47be7e98cfp+1, 0x1.b98a8e081f5ap-53, -0x1.ca53d70420b4cp-2, 0x1.25d5f276dc08p-3, -0x1.20b70d318c676p-4,
     0x1.4447316f92b54p-5, -0x1.81e2a56a382fap-6, 0x1.d9eb4f6f1e12bp-7, -0x1.28c01cefbb595p-7, 0x1.7883f7d619de9p-8,
     -0x1.e427ab42b7567p-9, 0x1.3830043ceb268p-9}, /* [59] 1.375 <= y <= 1.5 2^-5, degree 10, 60.2 bits */
    {0x1.39f06aa466e16p+1, 0x1.09fd6abe601ccp-55, -0x1.a8b112a69ba43p-2, 0x1.ecea43f23da3ap-4, -0x1.b95f53ae12a7fp-5,
     0x1.c62d4725e9ea5p-6, -0x1.f04cf2bfc3e8ep-7, 0x1.1838e040d1c5cp-7, -0x1.42f0665831dc9p-8, 0x1.7944574744196p-9,
     -0x1.be8cd35e8f85bp-10, 0x1.094386d8a2a9ep-10}, /* [60] 1.5 <= y <= 1.625 2^-5, degree 10, 63.8 bits */
    {0x1.3388060a0cabp+1, -0x1.577006ff3dbcbp-54, -0x1.8c442f8d894d1p-2, 0x1.a3b51625f7bb1p-4, -0x1.58c97a140bbc3p-5,
     0x1.471d0109c5df8p-6, -0x1.4a49cad6906c3p-7, 0x1.590d35f9e4e69p-8, -0x1.702b5785a3699p-9, 0x1.8e6e6928f41f5p-10,
     -0x1.b4d0f2f5c1f7cp-11, 0x1.e1087e987d3afp-12}, /* [61] 1.625 <= y <= 1.75 2^-5, degree 10, 61.0 bits */
    {0x1.2d88e0d32396ap+1, -0x1.b1a6ac995dfdcp-56, -0x1.73e8267441277p-2, 0x1.69fe0bc47fe66p-4, -0x1.126730c16bdffp-5,
     0x1.e2b28f4910fa7p-7, -0x1.c4c4318f0d97bp-8, 0x1.b7e94a2139e76p-9, -0x1.b4dec4d1a5a2bp-10, 0x1.b841e262c9ca6p-11,
     -0x1.c1751593a9a01p-12, 0x1.cd3104675318fp-13}, /* [62] 1.75 <= y <= 1.875 2^-5, degree 10, 60.3 bits */
    {0x1.27e477acb1f6ap+1, 0x1.211a3f5e273e6p-54, -0x1.5ec7c4d8b147p-2, 0x1.3bb127e2ad4dfp-4, -0x1.bbe1c05230fd1p-6,
     0x1.6bac318568072p-7, -0x1.3e6174fb86ba3p-8, 0x1.21075e8679913p-9, -0x1.0c5f401605995p-10, 0x1.f9fe76c67950bp-12,
     -0x1.e33ec61dacc82p-13, 0x1.d0247ce7f8c62p-14}, /* [63] 1.875 <= y <= 2 2^-5, degree 10, 61.1 bits */
    {0x1.1fff23260239p+1, 0x1.edf27331a3e19p-53, -0x1.43d6a3b56a5d3p-1, 0x1.05b29a585c4a1p-2, -0x1.4b5c01815f68bp-3,
     0x1.ebf25ecf444dfp-4, -0x1.874ad85afee43p-4, 0x1.43378ae8ff1ddp-4, -0x1.11579e5ac0eebp-4, 0x1.d5b91641fa299p-5,
     -0x1.9b43308ea9b18p-5, 0x1.685e6be9e6492p-5}, /* [64] 1 <= y <= 1.125 2^-4, degree 10, 58.6 bits */
    {0x1.1659cc42b0c41p+1, 0x1.4ff73e91d5dfdp-53, -0x1.2695013184119p-1, 0x1.a2e3bc47b4686p-3, -0x1.d340034464228p-4,
     0x1.33cee6b3f8d13p-4, -0x1.b409e9aea272ep-5, 0x1.4152af6b4284dp-5, -0x1.e56dc7eddda0dp-6, 0x1.74da4e2af2ac6p-6,
     -0x1.2391c2ecb43cdp-6, 0x1.c9499a622a4d9p-7}, /* [65] 1.125 <= y <= 1.25 2^-4, degree 10, 58.8 bits */
    {0x1.0d871d94f101cp+1, 0x1.37b67ddbe250ap-56, -0x1.0ede5cd7adf02p-1, 0x1.57d6dee39ca83p-3, -0x1.56089f941e8a9p-4,
     0x1.9484932addc4ep-5, -0x1.02042366d667bp-5, 0x1.57035cc077e0bp-6, -0x1.d3ecb86c39ed9p-7, 0x1.44c9951e77d81p-7,
     -0x1.cacb3c355d284p-8, 0x1.45742aad0eb5dp-8}, /* [66] 1.25 <= y <= 1.375 2^-4, degree 10, 61.2 bits */
    {0x1.056125f27eae3p+1, -0x1.7443bcc1d87fep-54, -0x1.f66800bb91b4ap-2, 0x1.2011bcf9d6685p-3, -0x1.022688b17feb7p-4,
     0x1.14a78909f5452p-5, -0x1.40c1b028c1486p-6, 0x1.8427ee4729416p-7, -0x1.e2754f711a5aep-8, 0x1.31549ea38c549p-8,
     -0x1.892314408e256p-9, 0x1.fd05d2d5e7975p-10}, /* [67] 1.375 <= y <= 1.5 2^-4, degree 10, 61.7 bits */
    {0x1.fb97848b2a2a9p+0, -0x1.2af683f24e118p-55, -0x1.d52cd126c6fcp-2, 0x1.eae4f24f379edp-4, -0x1.8fb310e20ddcbp-5,
     0x1.8737776fd71b9p-6, -0x1.9f708735109e4p-7, 0x1.cd1f4952f8a04p-8, -0x1.0716e7d715d19p-8, 0x1.31e699b61ed02p-9,
     -0x1.69c2b1344286cp-10, 0x1.aea55e1dd4a39p-11}, /* [68] 1.5 <= y <= 1.625 2^-4, degree 10, 60.0 bits */
    {0x1.ed62f42dfd87ap+0, -0x1.dc549e3bfa94dp-56, -0x1.b8a8e67410503p-2, 0x1.a83394f3df64dp-4, -0x1.3c1f9a0255062p-5,
     0x1.1c7daf0603135p-6, -0x1.1685c5b542356p-7, 0x1.1d6783e990a09p-8, -0x1.2ce7732ba5cc8p-9, 0x1.4372e6f222466p-10,
     -0x1.619ae3acd35fap-11, 0x1.85745545cf363p-12}, /* [69] 1.625 <= y <= 1.75 2^-4, degree 10, 64.3 bits */
    {0x1.e0030c697896p+0, -0x1.acdfb0d250155p-56, -0x1.9fded3730a6d4p-2, 0x1.72f9d538efd5bp-4, -0x1.fd438ef5cf835p-6,
     0x1.a7d2ded0b0e08p-7, -0x1.80b475b35df1fp-8, 0x1.6df78094b7184p-9, -0x1.66795a7aeb9bap-10, 0x1.6630feaeea75dp-11,
     -0x1.6c017823c2912p-12, 0x1.74f076e665306p-13}, /* [70] 1.75 <= y <= 1.875 2^-4, degree 10, 60.0 bits */
    {0x1.d35d0be01f9a5p+0, -0x1.ccfb1f8b1b092p-54, -0x1.8a146c78af038p-2, 0x1.47c49fa6989a3p-4, -0x1.a0b8f88bccd81p-6,
     0x1.4253abe5f5665p-7, -0x1.109831833fa7p-8, 0x1.e3d0d32c183bep-10, -0x1.ba6a72e382972p-11, 0x1.9ce4c8e405ab2p-12,
     -0x1.87ec76d3c907dp-13, 0x1.774aef233f65ep-14}, /* [71] 1.875 <= y <= 2 2^-4, degree 10, 60.7 bits */
    {0x1.c192358dea916p+0, 0x1.97923c87f93a1p-56, -0x1.6ddb58723909bp-1, 0x1.14aad6f04aa92p-2, -0x1.3c589fc22fac9p-3,
     0x1.ba0b55e1aac9fp-4, -0x1.52de4d10fc6ap-4, 0x1.1113e623c95d6p-4, -0x1.c5f83400b3982p-5, 0x1.8163c26aeb1b6p-5,
     -0x1.4eaf19c30ed3bp-5, 0x1.23d00c4a789f1p-5}, /* [72] 1 <= y <= 1.125 2^-3, degree 10, 58.3 bits */
    {0x1.abb6f8e0f80e7p+0, -0x1.a0a5d41a1df6cp-56, -0x1.4e9853f79bb2p-1, 0x1.c48d81098afefp-3, -0x1.c79b8da3a8b15p-4,
     0x1.197d9c8f4cd08p-4, -0x1.7f4c0eeb9d59ep-5, 0x1.12f38413f1503p-5, -0x1.97657b1f227d5p-6, 0x1.3482e3a7369acp-6,
     -0x1.dd8d0749a2ac7p-7, 0x1.73d23f42590b4p-7}, /* [73] 1.125 <= y <= 1.25 2^-3, degree 10, 58.7 bits */
    {0x1.97a28105d1b6dp+0, 0x1.66509eaf2c77ep-54, -0x1.34bb4834cf5fcp-1, 0x1.7aac21296828bp-3, -0x1.543142364b2d1p-4,
     0x1.782e7529e8c08p-5, -0x1.cc336d870dbc2p-6, 0x1.293ab58fd7bedp-6, -0x1.8d0234c1ea682p-7, 0x1.0f39b2faced6p-7,
     -0x1.7a8a85de838a4p-8, 0x1.0a24c45a8dbdep-8}, /* [74] 1.25 <= y <= 1.375 2^-3, degree 10, 59.4 bits */
    {0x1.850a2fd1049cep+0, 0x1.730a95ce9c0d9p-54, -0x1.1ee3e3256eafep-1, 0x1.42b388ce592a1p-3, -0x1.0598052be544ep-4,
     0x1.056a9928388p-5, -0x1.220a5a5b231cfp-6, 0x1.5480385f70261p-7, -0x1.9dd1f9cc440d5p-8, 0x1.016a7b05cade5p-8,
     -0x1.47041cdb297d9p-9, 0x1.a30fe473796f2p-10}, /* [75] 1.375 <= y <= 1.5 2^-3, degree 10, 58.9 bits */
    {0x1.73b598e6255a9p+0, 0x1.749d893727624p-54, -0x1.0c22fbc12c5e4p-1, 0x1.1724486ed41bbp-3, -0x1.9c34df787a2e8p-5,
     0x1.77597f2dca6cp-6, -0x1.7cad194c2623dp-7, 0x1.99578cebae86fp-8, -0x1.c82da83fce538p-9, 0x1.0460fb9e043b7p-9,
     -0x1.2f77ae44fb6cbp-10, 0x1.651f975ff3f15p-11}, /* [76] 1.5 <= y <= 1.625 2^-3, degree 10, 61.1 bits */
    {0x1.6378e2be2610dp+0, 0x1.e36cf418d8278p-54, -0x1.f7a0434866f93p-2, 0x1.e8f2ad3e1c1ffp-4, -0x1.4b75886cb76aep-5,
     0x1.14f77828d6b78p-6, -0x1.027c96f6a251ep-7, 0x1.004614505c1dap-8, -0x1.079bef395a5eep-9, 0x1.15f08f0d44fe6p-10,
     -0x1.2b2bc16651054p-11, 0x1.456b019b04252p-12}, /* [77] 1.625 <= y <= 1.75 2^-3, degree 10, 61.9 bits */
    {0x1.543130e9308f2p+0, -0x1.4f95cacf73951p-55, -0x1.dae203567f119p-2, 0x1.b0b6a8b663d93p-4, -0x1.0f30c76e5d6ap-5,
     0x1.a26f830b0166ep-7, -0x1.696cdb6da59cfp-8, 0x1.4c41cda06d13ap-9, -0x1.3d3cc3fbffdc4p-10, 0x1.36abeec2336p-11,
     -0x1.369a4ccb73812p-12, 0x1.3a065b4a25e4fp-13}, /* [78] 1.75 <= y <= 1.875 2^-3, degree 10, 60.5 bits */
    {0x1.45c24357d56f2p+0, -0x1.f58eeca461cc1p-57, -0x1.c154e1a6d52bdp-2, 0x1.825cdb4e312cp-4, -0x1.c26c199f308d5p-6,
     0x1.428bb8e1f1a83p-7, -0x1.032213a49c51cp-8, 0x1.bbf0cc4245d0bp-10, -0x1.8b5fc443d4a9cp-11, 0x1.6961c9c714f98p-12,
     -0x1.513e9a66d7aa3p-13, 0x1.3e73150dd33f5p-14}, /* [79] 1.875 <= y <= 2 2^-3, degree 10, 59.7 bits */
    {0x1.31807a864533ap+0, -0x1.1a08310934313p-55, -0x1.9fd611dc822fep-1, 0x1.4a9300d9e1fa9p-2, -0x1.5d0e026efdd7fp-3,
     0x1.c2f75336d0166p-4, -0x1.47a06c08a213dp-4, 0x1.fcd4b10bf4e28p-5, -0x1.9b72a8dc29b4p-5, 0x1.55c5083591f2ap-5,
     -0x1.2380e4c96b538p-5, 0x1.f4d871936f4e5p-6}, /* [80] 1 <= y <= 1.125 2^-2, degree 10, 57.5 bits */
    {0x1.18b97928eadd3p+0, -0x1.15ab7a7dde66cp-55, -0x1.7a3594d3882f4p-1, 0x1.124cdbc8e3f8bp-2, -0x1.01b168e5c2b71p-3,
     0x1.2636b67a9d64fp-4, -0x1.7a914796dc04fp-5, 0x1.051c209666a7p-5, -0x1.77d31e25472aap-6, 0x1.162bf6f1c30aap-6,
     -0x1.a6830012f3d78p-7, 0x1.43d3fab7a65dap-7}, /* [81] 1.125 <= y <= 1.25 2^-2, degree 10, 59.6 bits */
    {0x1.0219620dc57cp+0, 0x1.72645920031fdp-54, -0x1.5aae337f6fd82p-1, 0x1.d01ee1b52e379p-3, -0x1.897428325e3a1p-4,
     0x1.92342981cef48p-5, -0x1.cfc661b29845cp-6, 0x1.1f6560c72966dp-6, -0x1.745e7e5725743p-7, 0x1.f0cbb4fee20b4p-8,
     -0x1.53ea5ce36c4b8p-8, 0x1.d629e74c2bc9fp-9}, /* [82] 1.25 <= y <= 1.375 2^-2, degree 10, 58.1 bits */
    {0x1.da95fc966507bp-1, -0x1.852f9bbe6a99bp-56, -0x1.3fcc5211100cap-1, 0x1.8ec2b580668dcp-3, -0x1.349027b8aa22cp-4,
     0x1.1d824001c2f12p-5, -0x1.29f34c59b4ea7p-6, 0x1.4ee842bf8d0e5p-7, -0x1.8a42f828a575p-8, 0x1.de7bf219489ecp-9,
     -0x1.29c9fdf75426bp-9, 0x1.7722dc8879af9p-10}, /* [83] 1.375 <= y <= 1.5 2^-2, degree 10, 60.4 bits */
    {0x1.b418f8225346bp-1, 0x1.9a27c50b5d709p-55, -0x1.288dfdb7349bcp-1, 0x1.5af04d37fb2a8p-3, -0x1.eec103a8828fbp-5,
     0x1.a2342e798129dp-6, -0x1.8e49e3b63c993p-7, 0x1.993cbafa8281bp-8, -0x1.b92052b9d9db2p-9, 0x1.eac559df5e302p-10,
     -0x1.1807c7c329f45p-10, 0x1.43c660a9df39fp-11}, /* [84] 1.5 <= y <= 1.625 2^-2, degree 10, 60.7 bits */
    {0x1.9053781809ff4p-1, -0x1.86beb015254fap-55, -0x1.1439b4ad61f6dp-1, 0x1.31034eb559917p-3, -0x1.93f98ec71bdcfp-5,
     0x1.3a698f7aea1acp-6, -0x1.133cdc378035fp-7, 0x1.0440ac02bf5e7p-8, -0x1.028e7908a23e1p-9, 0x1.096c12589b7b2p-10,
     -0x1.178ec75f2200bp-11, 0x1.2a9c0f6d287bep-12}, /* [85] 1.625 <= y <= 1.75 2^-2, degree 10, 57.8 bits */
    {0x1.6ef13a1a06293p-1, -0x1.90a19a9865db6p-56, -0x1.0246159fc12b5p-1, 0x1.0e84269636b55p-3, -0x1.4efa46aee59b5p-5,
     0x1.e363336ba2752p-7, -0x1.87647fed20861p-8, 0x1.568dbf764cef9p-9, -0x1.3b6e4270c8983p-10, 0x1.2c73ed0d42967p-11,
     -0x1.25bc4dbd3d2a3p-12, 0x1.237b4c364b2abp-13}, /* [86] 1.75 <= y <= 1.875 2^-2, degree 10, 57.8 bits */
    {0x1.4facf6c6a6221p-1, 0x1.70d57b2c27145p-55, -0x1.e495b2c8bc94ap-2, 0x1.e3728381009b9p-4, -0x1.19706c91dd83dp-5,
     0x1.7abe155851c19p-7, -0x1.1d34015c4afe2p-8, 0x1.d0721c5d6d133p-10, -0x1.8e55b2b2b2afp-11, 0x1.61c3149d3f527p-12,
     -0x1.429a34411c8d7p-13, 0x1.2ad84d7aa8d5cp-14} /* [87] 1.875 <= y <= 2 2^-2, degree 10, 59.3 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_beta_zero_overlap)

/* beta at zero force by eps, 2^-23 <= eps < 2^-1: 176 rows of degree 10 in y = eps 2^-k, 8 to each octave k = -23 ... -2.
 * Relative error of the approximation: 2^-55.1 at most, proved for the whole cell of each row. */
#define COR_ROWS_BETA_ZERO_FORCE_FIRST 1.1920928955078125e-07
#define COR_ROWS_BETA_ZERO_FORCE_FIRST_OCTAVE (-23)
#define COR_ROWS_BETA_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_BETA_ZERO_FORCE_ROWS 176
#define COR_ROWS_BETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_beta_zero_force, 176, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.f97a6b8795122p+13, 0x1.a4d93a91b152cp-41, -0x1.1d727baba4c2ap+13, 0x1.add98528939bap+12,
     -0x1.5e9f588e19151p+12, 0x1.28ff70fc0df3fp+12, -0x1.012a485880977p+12, 0x1.c3cdcbbefbe8ep+11,
     -0x1.90eb6ac2204aap+11, 0x1.667819c961acbp+11, -0x1.44fd23846f8c8p+11, 0x1.25a73e387afc5p+11},
     /* [0] 1 <= y <= 1.125 2^-23, degree 10, 55.8 bits */
    {0x1.d8d88783205c2p+13, -0x1.c28fa838fad2dp-45, -0x1.ddd30cbf2f391p+12, 0x1.41e70fe8b5c7cp+12,
     -0x1.d5dd60ec26633p+11, 0x1.641ba63458861p+11, -0x1.13e3d5f993483p+11, 0x1.b1adffb1f338bp+10,
     -0x1.58548b9a7a91ep+10, 0x1.1376d157afcacp+10, -0x1.be2db96d806ccp+9, 0x1.68b75b7a17a91p+9},
     /* [1] 1.125 <= y <= 1.25 2^-23, degree 10, 57.6 bits */
    {0x1.bd497bfbf31bep+13, 0x1.830bb666510c9p-45, -0x1.971eeb222822fp+12, 0x1.f04c9fdd73a44p+11,
     -0x1.47b70d9363abep+11, 0x1.c17010723a95bp+10, -0x1.3b08d1bb564cap+10, 0x1.c00c8a2dca187p+9, -0x1.41dc569f8bde3p+9,
     0x1.d1ee7cbb357eep+8, -0x1.55019e4c41b7fp+8, 0x1.f2dc98ea794a7p+7},
     /* [2] 1.25 <= y <= 1.375 2^-23, degree 10, 58.3 bits */
    {0x1.a5a21d928464ap+13, 0x1.b779cfd27d948p-42, -0x1.5ff925db1ac25p+12, 0x1.87c2e1c28b51p+11, -0x1.d8626f0fab19cp+10,
     0x1.27c0f610dda75p+10, -0x1.7a9096109bb8p+9, 0x1.eb95e7baf1744p+8, -0x1.426ddc81a7b63p+8, 0x1.aa2acb2d90bf7p+7,
     -0x1.1c882b42377b7p+7, 0x1.7c0c159f77db3p+6}, /* [3] 1.375 <= y <= 1.5 2^-23, degree 10, 58.7 bits */
    {0x1.910eebac33d31p+13, 0x1.9678eb199b0fap-41, -0x1.340389a302ebdp+12, 0x1.3b67eaf4def53p+11,
     -0x1.5de3e71eb5361p+10, 0x1.9312d2b66d01fp+9, -0x1.daa8cc0b285bbp+8, 0x1.1b87a44726af4p+8, -0x1.562dabc0ead9cp+7,
     0x1.a016c1d4743cbp+6, -0x1.fed02d6a2a2e2p+5, 0x1.39da086ca9477p+5},
     /* [4] 1.5 <= y <= 1.625 2^-23, degree 10, 59.0 bits */
    {0x1.7ef5b4361b2edp+13, -0x1.bc6a84e6653e4p-41, -0x1.1053f522bc3ccp+12, 0x1.023501980268p+11,
     -0x1.0938542165547p+10, 0x1.1ae6be69d7054p+9, -0x1.34779c1dbb0d3p+8, 0x1.5537d2751377p+7, -0x1.7d4bda99bd0b4p+6,
     0x1.ad4fb54fa1d57p+5, -0x1.e7bf3665484a5p+4, 0x1.157adbe50046fp+4},
     /* [5] 1.625 <= y <= 1.75 2^-23, degree 10, 58.9 bits */
    {0x1.6ee31f3e7e001p+13, 0x1.e0198836d0802p-42, -0x1.e5cfa887cf776p+11, 0x1.acda88c079cf6p+10, -0x1.9a1f3ce59a8bfp+9,
     0x1.974b2666d9fdp+8, -0x1.9d7920da9397ep+7, 0x1.a9d46e761ba6ap+6, -0x1.bb079743c8796p+5, 0x1.d06ad1884b1e9p+4,
     -0x1.eb08e5fba769fp+3, 0x1.0415854e924a9p+3}, /* [6] 1.75 <= y <= 1.875 2^-23, degree 10, 62.5 bits */
    {0x1.607efdc66e94ap+13, 0x1.605044a7b8cdbp-42, -0x1.b4a4614fdcc2bp+11, 0x1.6894e151b060fp+10, -0x1.4295b068bd6bdp+9,
     0x1.2bb10b83f5a6fp+8, -0x1.1c9c3d54ce671p+7, 0x1.123487709d71ep+6, -0x1.0ae02b9823e4dp+5, 0x1.05b5d73456e76p+4,
     -0x1.02c4c02e2d8bdp+3, 0x1.006f81f247ce7p+2}, /* [7] 1.875 <= y <= 2 2^-23, degree 10, 62.1 bits */
    {0x1.4d7da38fd11f6p+13, -0x1.70d6254aef3f4p-42, -0x1.78a66ea70ed6dp+12, 0x1.1b985a206c54p+12,
     -0x1.cea6312fb058ap+11, 0x1.87e41aa85553p+11, -0x1.5354de1c12a3ap+11, 0x1.2a1455d7c6937p+11,
     -0x1.088220e1beacep+11, 0x1.d900be93911b3p+10, -0x1.acd34a5aa07cbp+10, 0x1.837a558e2398dp+10},
     /* [8] 1 <= y <= 1.125 2^-22, degree 10, 55.8 bits */
    {0x1.37f61f3edc6f7p+13, 0x1.3285bf45c0f48p-41, -0x1.3b3f2f295c108p+12, 0x1.a8c0cf5e95934p+11,
     -0x1.35fec5e194c4bp+11, 0x1.d5e32d6747e25p+10, -0x1.6c0a00489738dp+10, 0x1.1e1f361c44c43p+10,
     -0x1.c658b6e99e712p+9, 0x1.6b7a2562365e4p+9, -0x1.265e3d844d9c4p+9, 0x1.dbf7cc91a2db1p+8},
     /* [9] 1.125 <= y <= 1.25 2^-22, degree 10, 57.4 bits */
    {0x1.25c7862934cb1p+13, -0x1.49f1a0a20a4eep-42, -0x1.0c998be435bfap+12, 0x1.476f814a9b2aap+11,
     -0x1.b06c36f7513f4p+10, 0x1.2884b541446b7p+10, -0x1.9fb0c574018eap+9, 0x1.279a24fae1dc8p+9, -0x1.a8b2a1d97a1bbp+8,
     0x1.33667618e36a3p+8, -0x1.c1f5e86af3fcbp+7, 0x1.4920423d3b3aap+7},
     /* [10] 1.25 <= y <= 1.375 2^-22, degree 10, 59.1 bits */
    {0x1.162c777928423p+13, -0x1.cfa1c4697f367p-42, -0x1.d06e933be9a1dp+11, 0x1.027755b352bbdp+11,
     -0x1.37a85abcad27cp+10, 0x1.863fdf40be233p+9, -0x1.f384f207a3f8dp+8, 0x1.44535862ca5c4p+8, -0x1.a972a6eb3051ap+7,
     0x1.192a5e418a609p+7, -0x1.7771302b51af9p+6, 0x1.f579af98e4e35p+5},
     /* [11] 1.375 <= y <= 1.5 2^-22, degree 10, 59.5 bits */
    {0x1.0899690e674ecp+13, 0x1.0d0b832fa8a6cp-41, -0x1.966d57387669ap+11, 0x1.a02e49cd613ccp+10, -0x1.cdaedec3db7ddp+9,
     0x1.09edee15de026p+9, -0x1.3928901aa19c8p+8, 0x1.761eb42cc2563p+7, -0x1.c381d5ab35a04p+6, 0x1.12842de70fd08p+6,
     -0x1.5102d4bb51bd3p+5, 0x1.9e213c5588b54p+4}, /* [12] 1.5 <= y <= 1.625 2^-22, degree 10, 61.8 bits */
    {0x1.f9513f73bbbdcp+12, 0x1.340a36e372922p-42, -0x1.6756dd5a3d689p+11, 0x1.54b4d835a6089p+10, -0x1.5df5c59bd569bp+9,
     0x1.754a680fccf43p+8, -0x1.970667efb0e38p+7, 0x1.c23d705980e42p+6, -0x1.f71fa19a7e2ecp+5, 0x1.1b3d6a406525dp+5,
     -0x1.41cb01daf5428p+4, 0x1.6e231148d1ba4p+3}, /* [13] 1.625 <= y <= 1.75 2^-22, degree 10, 61.0 bits */
    {0x1.e41c0498d1dc5p+12, 0x1.e1e009d9a6f4fp-42, -0x1.4084280edf61cp+11, 0x1.1af0239f5b0f8p+10, -0x1.0e946897442abp+9,
     0x1.0cb6aeb2f609dp+8, -0x1.10ca65406c917p+7, 0x1.18f1652f64f1fp+6, -0x1.244a6550cbe8cp+5, 0x1.3266b2acd6b64p+4,
     -0x1.43f65042dfeffp+3, 0x1.572eda3de6637p+2}, /* [14] 1.75 <= y <= 1.875 2^-22, degree 10, 62.0 bits */
    {0x1.d11ec5a6ce5eap+12, -0x1.e156b184eb47bp-44, -0x1.2013a531ec4dbp+11, 0x1.dbca5e05d7872p+9, -0x1.a9a73b7b2b21cp+8,
     0x1.8b720db9b77d1p+7, -0x1.778baf01b0fd2p+6, 0x1.69d0e473636c2p+5, -0x1.602504f51f839p+4, 0x1.59543165a45b9p+3,
     -0x1.55727bbeab063p+2, 0x1.525e6a4dc853bp+1}, /* [15] 1.875 <= y <= 2 2^-22, degree 10, 60.1 bits */
    {0x1.b80ae46b6261ap+12, 0x1.0d5ad2c7c7df4p-44, -0x1.f0fe5842ad86cp+11, 0x1.7634cc6bfe6f9p+11,
     -0x1.313c18e1fcdc1p+11, 0x1.028d3e8d768dfp+11, -0x1.bfc02f7992f71p+10, 0x1.895178e3dd371p+10,
     -0x1.5d0557ef00f8p+10, 0x1.3810ca463df35p+10, -0x1.1aeb54b00d1dbp+10, 0x1.ff47b97bf4859p+9},
     /* [16] 1 <= y <= 1.125 2^-21, degree 10, 55.7 bits */
    {0x1.9ba26424e00d9p+12, 0x1.f17eb525cb984p-43, -0x1.9ff8a8b9cf1dbp+11, 0x1.183b970a27fcap+11,
     -0x1.990a9350fa8cbp+10, 0x1.36029b3d54204p+10, -0x1.e05a411af8347p+9, 0x1.798a4bd69308fp+9, -0x1.2bc1c9be3f0b7p+9,
     0x1.df9c6c9ee2fe2p+8, -0x1.846bcf1bffdfp+8, 0x1.3a05940634f82p+8},
     /* [17] 1.125 <= y <= 1.25 2^-21, degree 10, 57.2 bits */
    {0x1.83a49a2496638p+12, -0x1.d421c529c0653p-42, -0x1.626b8fecbd944p+11, 0x1.b00ddc94751ap+10,
     -0x1.1d4af0b4b4084p+10, 0x1.87422d5d937ecp+9, -0x1.1240e7fdd4ceap+9, 0x1.860ca810a79ddp+8, -0x1.1832339e03e92p+8,
     0x1.959dfbb84ce0fp+7, -0x1.28dd027fedcep+7, 0x1.b248d0fcf1d15p+6},
     /* [18] 1.25 <= y <= 1.375 2^-21, degree 10, 57.8 bits */
    {0x1.6f0d153020be7p+12, -0x1.162869a06947cp-44, -0x1.326950724c526p+11, 0x1.550c64b6be11cp+10,
     -0x1.9b3c24927e20bp+9, 0x1.01780038d10f6p+9, -0x1.498f58e5cc16fp+8, 0x1.abf344909969p+7, -0x1.18b0e3886c19ep+7,
     0x1.73000b90a3457p+6, -0x1.ef6622793d954p+5, 0x1.4ad9b31e451f3p+5},
     /* [19] 1.375 <= y <= 1.5 2^-21, degree 10, 58.6 bits */
    {0x1.5d23b5a0934bdp+12, -0x1.78b74b0dc05f4p-43, -0x1.0c2476f8f1cd2p+11, 0x1.1293c22b16172p+10,
     -0x1.3098f05b34f22p+9, 0x1.5ee567d77d728p+8, -0x1.9d3716d08a55p+7, 0x1.eda783f19ee58p+6, -0x1.29e23af5acf4ap+6,
     0x1.6a39fe98f52f9p+5, -0x1.bcb058073b512p+4, 0x1.11394d7f34e78p+4},
     /* [20] 1.5 <= y <= 1.625 2^-21, degree 10, 58.6 bits */
    {0x1.4d623f412c349p+12, -0x1.7160aaa887633p-42, -0x1.da26f03850de3p+10, 0x1.c190b4356f8bbp+9, -0x1.cdc67c5467c0cp+8,
     0x1.ec8f68c3ab4dbp+7, -0x1.0c8955f32f411p+7, 0x1.290c36a86ad1fp+6, -0x1.4bf016ad0998fp+5, 0x1.75bcc4d6eff8cp+4,
     -0x1.a89bc630c98c9p+3, 0x1.e31ee87bc0e2ep+2}, /* [21] 1.625 <= y <= 1.75 2^-21, degree 10, 59.5 bits */
    {0x1.3f64487a6b001p+12, 0x1.0108e557b207p-43, -0x1.a6ecb8ad9e597p+10, 0x1.7556e0b293427p+9, -0x1.650845f408e4bp+8,
     0x1.6291e4e74e787p+7, -0x1.67f312ce67a5p+6, 0x1.72b4e18df7142p+5, -0x1.81ae0c8811cdbp+4, 0x1.944c820fd04e4p+3,
     -0x1.ab7881c462d53p+2, 0x1.c4d5322c09bd6p+1}, /* [22] 1.75 <= y <= 1.875 2^-21, degree 10, 59.3 bits */
    {0x1.32dd0c9a8c3a1p+12, 0x1.d1e9dffd2e473p-44, -0x1.7c1ed77b0afa4p+10, 0x1.39e7ae2d944fbp+9, -0x1.18d39ce6520d9p+8,
     0x1.04e59a24cb798p+7, -0x1.ef8920406f2bap+5, 0x1.dd6b52209b9a5p+4, -0x1.d0a8613cc3315p+3, 0x1.c7aa100943f0ap+2,
     -0x1.c28ad9f32dd33p+1, 0x1.be7afc84fdbdep+0}, /* [23] 1.875 <= y <= 2 2^-21, degree 10, 61.2 bits */
    {0x1.22517f4a6249p+12, 0x1.8a9d0c744768bp-43, -0x1.47e4f2d18003ap+11, 0x1.edc4c833933bep+10, -0x1.92c28e13f894ep+10,
     0x1.552947f720c4ap+10, -0x1.2767cb48c4539p+10, 0x1.037e4d8241c24p+10, -0x1.cc89343afe49bp+9, 0x1.9bc5ebb7ce475p+9,
     -0x1.755075daa14ap+9, 0x1.5151b6c2b8065p+9}, /* [24] 1 <= y <= 1.125 2^-20, degree 10, 55.8 bits */
    {0x1.0f936c1e94c84p+12, -0x1.41c78ad30b50cp-45, -0x1.127085be61429p+11, 0x1.71c51465084a3p+10,
     -0x1.0ddde9e5b5036p+10, 0x1.990fa7209fc08p+9, -0x1.3cea270abd02bp+9, 0x1.f22ae2535e8f9p+8, -0x1.8b8827af000a3p+8,
     0x1.3c6ce5744c1ccp+8, -0x1.00432fd7aadfap+8, 0x1.9e5ab627ea315p+7},
     /* [25] 1.125 <= y <= 1.25 2^-20, degree 10, 57.1 bits */
    {0x1.ff7eae26f555ap+11, -0x1.4557dcadd7df7p-43, -0x1.d3a96710e920fp+10, 0x1.1d0cc23b49d43p+10,
     -0x1.787245463f79bp+9, 0x1.0222702bd4df5p+9, -0x1.69e1421ed10a3p+8, 0x1.0156372850245p+8, -0x1.71b89b24f2648p+7,
     0x1.0b9b8b477a73bp+7, -0x1.87b6afcde9251p+6, 0x1.1e855d6c67619p+6},
     /* [26] 1.25 <= y <= 1.375 2^-20, degree 10, 58.9 bits */
    {0x1.e452d8644e741p+11, 0x1.b3b282eb7f62dp-44, -0x1.94504c92bb39bp+10, 0x1.c2044b50343a1p+9, -0x1.0f506be868ed6p+9,
     0x1.53bb78c5f6d5fp+8, -0x1.b2db72ec25ac8p+7, 0x1.1a578eba1dc4dp+7, -0x1.725fc62c8e8fdp+6, 0x1.e989b0c0a3ffbp+5,
     -0x1.46d76ee9eb615p+5, 0x1.b48f51a302068p+4}, /* [27] 1.375 <= y <= 1.5 2^-20, degree 10, 58.9 bits */
    {0x1.ccb063084f37fp+11, -0x1.7aa0a8d7f3c6p-44, -0x1.61d142062092p+10, 0x1.6a4eafb3a7876p+9, -0x1.91eb4ca6b8076p+8,
     0x1.cf02b5119f36ep+7, -0x1.109edb4f3cefbp+7, 0x1.45b0ca928dc98p+6, -0x1.890f6291b176cp+5, 0x1.ddf602ec90fecp+4,
     -0x1.2562a502801bdp+4, 0x1.688569250cbccp+3}, /* [28] 1.5 <= y <= 1.625 2^-20, degree 10, 59.2 bits */
    {0x1.b7e62e2f67bd4p+11, -0x1.437ccab7ad2d5p-43, -0x1.38d332ff1ab76p+10, 0x1.289a5d1cd551dp+9, -0x1.30a890ba578b1p+8,
     0x1.44f8046be6339p+7, -0x1.625613d2008bfp+6, 0x1.87f4ffe6b956dp+5, -0x1.b5fead5bfc819p+4, 0x1.ed264f15f327dp+3,
     -0x1.1823225366d79p+3, 0x1.3ebdad819bfc7p+2}, /* [29] 1.625 <= y <= 1.75 2^-20, degree 10, 59.0 bits */
    {0x1.a56fbb148c0fap+11, 0x1.76a8bba3c6616p-45, -0x1.170706d4af6ddp+10, 0x1.eca00c653c2a3p+8, -0x1.d71b889812724p+7,
     0x1.d3dbb459e88d2p+6, -0x1.daf4e1f7b167cp+5, 0x1.e9268a82324fcp+4, -0x1.fce86da1c51f5p+3, 0x1.0abce6d111b1dp+3,
     -0x1.1a068f3ca0de5p+2, 0x1.2ac222b27b949p+1}, /* [30] 1.75 <= y <= 1.875 2^-20, degree 10, 58.7 bits */
    {0x1.94e7bdcd08534p+11, 0x1.91f48f6e30374p-44, -0x1.f59304156a9a9p+9, 0x1.9e33730ed2825p+8, -0x1.728dad6349d42p+7,
     0x1.58417ec99bb61p+6, -0x1.46ee8e8533ed4p+5, 0x1.3afabbca229fdp+4, -0x1.328f5901709ffp+3, 0x1.2ca060eeba484p+2,
     -0x1.293f4c1bc8e95p+1, 0x1.26913d1e3eb0cp+0}, /* [31] 1.875 <= y <= 2 2^-20, degree 10, 59.6 bits */
    {0x1.7f12dec8da8eep+11, -0x1.9cd1d97fffb1ep-45, -0x1.b0a94c79d3686p+10, 0x1.45c43d3e783cdp+10,
     -0x1.09b90e283f142p+10, 0x1.c22a5b65482fap+9, -0x1.85ca47c15e34fp+9, 0x1.56675f7d602eap+9, -0x1.2fd731ddf30bap+9,
     0x1.0fab49fb12f67p+9, -0x1.ec97668d1f6e4p+8, 0x1.bd1875638c6bep+8},
     /* [32] 1 <= y <= 1.125 2^-19, degree 10, 55.8 bits */
    {0x1.6657bd404d2f8p+11, -0x1.ffceed64aeabep-43, -0x1.6a208c609ac11p+10, 0x1.e7ea594d1ac6ap+9, -0x1.64178e0066b5ep+9,
     0x1.0de1498a310adp+9, -0x1.a22bfadcc8859p+8, 0x1.48ab127a3d752p+8, -0x1.04f431cdec402p+8, 0x1.a186aa758e2d3p+7,
     -0x1.5223f876cca8p+7, 0x1.115f3e9729b96p+7}, /* [33] 1.125 <= y <= 1.25 2^-19, degree 10, 57.4 bits */
    {0x1.5174f43411ba3p+11, -0x1.244decc600999p-45, -0x1.348b25229651fp+10, 0x1.782063e21e3bbp+9, -0x1.f0b98e60d7148p+8,
     0x1.549c69d971097p+8, -0x1.dd81002e1135ap+7, 0x1.538ee6fcbe541p+7, -0x1.e7d9ad9fcb6adp+6, 0x1.611c4e57b8498p+6,
     -0x1.026f4c97d7c24p+6, 0x1.7a111e6c04cb7p+5}, /* [34] 1.25 <= y <= 1.375 2^-19, degree 10, 58.2 bits */
    {0x1.3f87c913fa59ap+11, -0x1.40e71cb5ef45ep-43, -0x1.0abfd12aed4fdp+10, 0x1.28e6b5b0b9cd6p+9, -0x1.660078a52d0d7p+8,
     0x1.c047b519051a6p+7, -0x1.1ee62b45ffdfp+7, 0x1.748d89d52bc51p+6, -0x1.e8b64424ff82ap+5, 0x1.42f98a52d27c3p+5,
     -0x1.af453056e32f8p+4, 0x1.2005b2062642p+4}, /* [35] 1.375 <= y <= 1.5 2^-19, degree 10, 58.9 bits */
    {0x1.2feff1cb0ea3p+11, 0x1.97fa4e385df7ep-43, -0x1.d2de3fe0b0bfbp+9, 0x1.de11a5e512e04p+8, -0x1.092b149c9ff05p+8,
     0x1.317938ef36befp+7, -0x1.67b9b34048ba3p+6, 0x1.adc072c66adc1p+5, -0x1.0352bc1cb6588p+5, 0x1.3b563e9d2cf0ap+4,
     -0x1.831fe156b7442p+3, 0x1.dbb5f635247fp+2}, /* [36] 1.5 <= y <= 1.625 2^-19, degree 10, 61.1 bits */
    {0x1.2238927aef90dp+11, 0x1.a167b4d666668p-44, -0x1.9cc7360c4d536p+9, 0x1.875f0d662a38fp+8, -0x1.920008558d315p+7,
     0x1.acccb46a0a491p+6, -0x1.d38cd26a3dbdep+5, 0x1.029871b1da51dp+5, -0x1.20f816b9da06bp+4, 0x1.455b922abf088p+3,
     -0x1.71a4c1cc97357p+2, 0x1.a494da8670003p+1}, /* [37] 1.625 <= y <= 1.75 2^-19, degree 10, 60.6 bits */
    {0x1.160a410ca9f8cp+11, -0x1.ccbc3746c139dp-45, -0x1.702e8fb9705fcp+9, 0x1.450338980fe19p+8, -0x1.36d0d82dbb165p+7,
     0x1.34abfe747da37p+6, -0x1.395adbd6b0b83p+5, 0x1.42b829e69d374p+4, -0x1.4fc11d5c0a193p+3, 0x1.5ff68c4530a7p+2,
     -0x1.7422a55fec05p+1, 0x1.8a36daf24975dp+0}, /* [38] 1.75 <= y <= 1.875 2^-19, degree 10, 59.3 bits */
    {0x1.0b2228c714909p+11, 0x1.4b1454601ab83p-44, -0x1.4aeb1e7b0ae1fp+9, 0x1.114592d56c586p+8, -0x1.e8f30b73fb5acp+6,
     0x1.c63fc842f4befp+5, -0x1.af63cb52ff2fp+4, 0x1.9f9e4d2d9cd7ap+3, -0x1.94823b3732edep+2, 0x1.8cadeca1f8614p+1,
     -0x1.88386e72b2e1ap+0, 0x1.84af29b7787bdp-1}, /* [39] 1.875 <= y <= 2 2^-19, degree 10, 59.9 bits */
    {0x1.f975b18694ccap+10, -0x1.814fb38b31265p-45, -0x1.1d73e15355d26p+10, 0x1.adda73ede29a4p+9, -0x1.5e9fd75a6f2a7p+9,
     0x1.28ffc12b422b5p+9, -0x1.012a7ff624366p+9, 0x1.c3ce1d73a54f2p+8, -0x1.90eba92b9e43p+8, 0x1.66784ad617df6p+8,
     -0x1.44fd4b2b32221p+8, 0x1.25a75e9ce312fp+8}, /* [40] 1 <= y <= 1.125 2^-18, degree 10, 55.7 bits */
    {0x1.d8d3a28d5002bp+10, 0x1.cbb3e2c413088p-47, -0x1.ddd5a1be1b5abp+9, 0x1.41e7d5b1833c6p+9, -0x1.d5de1cfbb6114p+8,
     0x1.641c10a54ffbap+8, -0x1.13e4180babe23p+8, 0x1.b1ae568ea1f77p+7, -0x1.5854c6fa60112p+7, 0x1.1376fb1903736p+7,
     -0x1.be2df5c19bc09p+6, 0x1.68b7879336e33p+6}, /* [41] 1.125 <= y <= 1.25 2^-18, degree 10, 57.5 bits */
    {0x1.bd446f2bcee47p+10, -0x1.cd886c5fe5bcp-45, -0x1.972152b633271p+9, 0x1.f04dedbdd0f51p+8, -0x1.47b79d43e15d4p+8,
     0x1.c170a3a7448d5p+7, -0x1.3b09246bcc92ap+7, 0x1.c00cec8cf40cap+6, -0x1.41dc9377fff8bp+6, 0x1.d1eeca2af3cdp+5,
     -0x1.5501d0ddcda0ap+5, 0x1.f2dcdbce63f4dp+4}, /* [42] 1.25 <= y <= 1.375 2^-18, degree 10, 58.6 bits */
    {0x1.a59ceb861cf5dp+10, -0x1.d150d8931c052p-45, -0x1.5ffb66cd90f79p+9, 0x1.87c3ffed49929p+8, -0x1.d8635010d920ep+7,
     0x1.27c15f542e1dfp+7, -0x1.7a91020ef75f3p+6, 0x1.eb965d0cc85d3p+5, -0x1.426e1ec4ebd4ap+5, 0x1.aa2b182ecb179p+4,
     -0x1.1c885924963a1p+4, 0x1.7c0c4d0abf33p+3}, /* [43] 1.375 <= y <= 1.5 2^-18, degree 10, 59.4 bits */
    {0x1.910996a1858e5p+10, 0x1.fad1a3785ab46p-45, -0x1.3405a94269de2p+9, 0x1.3b68e36410deap+8, -0x1.5de49ae940a08p+7,
     0x1.93136d841b1a7p+6, -0x1.daa95e2eb929fp+5, 0x1.1b87ed510de85p+5, -0x1.562df7aa936adp+4, 0x1.a01712ff98442p+3,
     -0x1.fed0865d1d5b1p+2, 0x1.39da39d88d2d6p+2}, /* [44] 1.5 <= y <= 1.625 2^-18, degree 10, 60.6 bits */
    {0x1.7ef03e1f3b38cp+10, -0x1.e9d6be4d2a396p-44, -0x1.1055f7ab90ee6p+9, 0x1.0235db9e8e3d8p+8, -0x1.0938e64a0ec6ep+7,
     0x1.1ae732f6f2e8dp+6, -0x1.3478020297e39p+5, 0x1.553830c67ac8ep+4, -0x1.7d4c35609548bp+3, 0x1.ad500f30a9b0fp+2,
     -0x1.e7bf918f7f535p+1, 0x1.157b0acc1dfdfp+1}, /* [45] 1.625 <= y <= 1.75 2^-18, degree 10, 59.9 bits */
    {0x1.6edd89d06347fp+10, -0x1.3455adb93c62ap-46, -0x1.e5d37a4e3c269p+8, 0x1.acdc0affc298ap+7, -0x1.9a202e11091c8p+6,
     0x1.974bd97e85ddbp+5, -0x1.9d79b2a5f49b6p+4, 0x1.a9d4ec1f72b8bp+3, -0x1.bb0807e0a5cb4p+2, 0x1.d06b3959835b3p+1,
     -0x1.eb0947feca069p+0, 0x1.0415b441d0b12p+0}, /* [46] 1.75 <= y <= 1.875 2^-18, degree 10, 60.5 bits */
    {0x1.60794a840bf8fp+10, 0x1.8087699a24fe7p-49, -0x1.b4a80577c9767p+8, 0x1.68963a3717061p+7, -0x1.429679f136c6fp+6,
     0x1.2bb1978c4f555p+5, -0x1.1c9ca7fd24068p+4, 0x1.1234dd728380cp+3, -0x1.0ae073b4463d3p+2, 0x1.05b61565d53b4p+1,
     -0x1.02c4f7187fe04p+0, 0x1.006fb32a702eep-1}, /* [47] 1.875 <= y <= 2 2^-18, degree 10, 61.0 bits */
    {0x1.4d77c60b9b05dp+10, 0x1.f29e091420704p-46, -0x1.78a9d707d5dc2p+9, 0x1.1b9980efe1026p+9, -0x1.cea76b7c9c827p+8,
     0x1.87e4e1d5b6a58p+8, -0x1.53556875255b2p+8, 0x1.2a14bb93a39e7p+8, -0x1.08826ea8c50c8p+8, 0x1.d90138e9d9dfep+7,
     -0x1.acd3ad4f7804ap+7, 0x1.837aa66fe7746p+7}, /* [48] 1 <= y <= 1.125 2^-17, degree 10, 55.7 bits */
    {0x1.37f00d5dcc888p+10, -0x1.6e06d4f653aa1p-45, -0x1.3b4254805ec54p+9, 0x1.a8c2b76d42b76p+8, -0x1.35ffaecf49ef8p+8,
     0x1.d5e435a522cebp+7, -0x1.6c0aa48ba90a1p+7, 0x1.1e1fa23497d17p+7, -0x1.c6594ad183a7fp+6, 0x1.6b7a8d792df25p+6,
     -0x1.265e88c225367p+6, 0x1.dbf83aa0098dp+5}, /* [49] 1.125 <= y <= 1.25 2^-17, degree 10, 57.1 bits */
    {0x1.25c143bf9037p+10, 0x1.ca77d1e4ee527p-47, -0x1.0c9c7936847c5p+9, 0x1.47711cf5a09aap+8, -0x1.b06d9ab30d73p+7,
     0x1.28856be079608p+7, -0x1.9fb192ecb9f4ap+6, 0x1.279a9f563fb32p+6, -0x1.a8b339588de2p+5, 0x1.3366d692124b4p+5,
     -0x1.c1f6667f4182ep+4, 0x1.492095abafd8cp+4}, /* [50] 1.25 <= y <= 1.375 2^-17, degree 10, 58.6 bits */
    {0x1.162607c12361bp+10, -0x1.0a95b1f00e81ep-44, -0x1.d0740ea449b08p+8, 0x1.0278b653a2ef3p+8, -0x1.37a9711be76d1p+7,
     0x1.8640e44b6c6cdp+6, -0x1.f385fe40065dp+5, 0x1.4453ea3e3faeap+5, -0x1.a9734bd44644bp+4, 0x1.192abe264c7c6p+4,
     -0x1.7771a2853e3fbp+3, 0x1.f57a39c943adep+2}, /* [51] 1.375 <= y <= 1.5 2^-17, degree 10, 58.8 bits */
    {0x1.0892cecb4f22p+10, 0x1.155f955b63a9fp-44, -0x1.9672808628841p+8, 0x1.a030adb69fb75p+7, -0x1.cdb09b68d7b75p+6,
     0x1.09eeadf1991b2p+6, -0x1.39294580ce696p+5, 0x1.761f69b4f011dp+4, -0x1.c382928442713p+3, 0x1.128492f0ab28dp+3,
     -0x1.510343868726cp+2, 0x1.9e21b7850b75bp+1}, /* [52] 1.5 <= y <= 1.625 2^-17, degree 10, 59.2 bits */
    {0x1.f943baa23990fp+9, 0x1.33bd6033dcc5cp-45, -0x1.675bbf07603abp+8, 0x1.54b6f0ef01226p+7, -0x1.5df72ee7bbdb3p+6,
     0x1.754b88d57c2f6p+5, -0x1.970764c9b9b49p+4, 0x1.c23e5aacd52cp+3, -0x1.f72083571bb22p+2, 0x1.1b3dda16d6c0fp+2,
     -0x1.41cb735de99dbp+1, 0x1.6e23862642973p+0}, /* [53] 1.625 <= y <= 1.75 2^-17, degree 10, 59.7 bits */
    {0x1.e40e33afb3f43p+9, 0x1.2d6f316993ebfp-47, -0x1.4088ca9d273edp+8, 0x1.1af1fecdbe039p+7, -0x1.0e9592896cf47p+6,
     0x1.0cb78c787726ep+5, -0x1.10cb1a1378a6ep+4, 0x1.18f20139529ep+3, -0x1.244af1485abfbp+2, 0x1.326733cf640fp+1,
     -0x1.43f6ca417c997p+0, 0x1.572f4f2f45bb2p-1}, /* [54] 1.75 <= y <= 1.875 2^-17, degree 10, 59.7 bits */
    {0x1.d110ac5e2e452p+9, 0x1.5dc54933401fp-46, -0x1.20180fa41e191p+8, 0x1.dbcdae3bfc63ap+6, -0x1.a9a92d3a279abp+5,
     0x1.8b7368657141ap+4, -0x1.778cb779ec4d2p+3, 0x1.69d1b9f8c5cf3p+2, -0x1.6025b8259ae3dp+1, 0x1.5954cc10b947p+0,
     -0x1.5573046783d84p-1, 0x1.525ee4dbe918ep-2}, /* [55] 1.875 <= y <= 2 2^-17, degree 10, 64.2 bits */
    {0x1.b7fc64b0fe89ap+9, -0x1.5058aba890906p-46, -0x1.f1069a302be8dp+8, 0x1.7637a0f7a770cp+8, -0x1.313d9cc8187ecp+8,
     0x1.028e34f66bc35p+8, -0x1.bfc186584b845p+7, 0x1.8952755386217p+7, -0x1.5d06191cc0ac5p+7, 0x1.3811625265603p+7,
     -0x1.1aebcfc29e1f3p+7, 0x1.ff4882c9a98e5p+6}, /* [56] 1 <= y <= 1.125 2^-16, degree 10, 55.8 bits */
    {0x1.9b93659ad85ap+9, 0x1.1f1660927dd97p-50, -0x1.a00045f69ac49p+8, 0x1.183dee48838c1p+8, -0x1.990cd1d77c494p+7,
     0x1.3603e1ec06929p+7, -0x1.e05bd7efe5766p+6, 0x1.798b57e49ec6p+6, -0x1.2bc281501f58ap+6, 0x1.df9d6f3518d08p+5,
     -0x1.846c8a28c479fp+5, 0x1.3a061ce7aa64dp+5}, /* [57] 1.125 <= y <= 1.25 2^-16, degree 10, 57.1 bits */
    {0x1.839526322a99ap+9, -0x1.986fdb0937dcp-47, -0x1.6272a3a75821p+8, 0x1.b011ceb635244p+7, -0x1.1d4ca72018038p+7,
     0x1.8743f0a2f2512p+6, -0x1.1241e64a30559p+6, 0x1.860dd7509b261p+5, -0x1.1832ef8a54c61p+5, 0x1.959eeb41ff4d5p+4,
     -0x1.28dd9f2247db6p+4, 0x1.b249a06a3c49ep+3}, /* [58] 1.25 <= y <= 1.375 2^-16, degree 10, 58.1 bits */
    {0x1.6efd33c0aafcfp+9, 0x1.7f5e720f49c19p-50, -0x1.326fef5fcd4b7p+8, 0x1.550fc55bd5acdp+7, -0x1.9b3ed24c78e76p+6,
     0x1.0179428fe980ap+6, -0x1.4990a4acb504ep+5, 0x1.abf4adde629bfp+4, -0x1.18b1affde593cp+4, 0x1.7300f98bbe251p+3,
     -0x1.ef673e76db7c4p+2, 0x1.4ada5ed1c3c1bp+2}, /* [59] 1.375 <= y <= 1.5 2^-16, degree 10, 59.3 bits */
    {0x1.5d136d7a6ccafp+9, 0x1.c6354fd49a33ap-46, -0x1.0c2ab145cda75p+8, 0x1.1296afe12fea1p+7, -0x1.309b13b206f98p+6,
     0x1.5ee74168d7a4ap+5, -0x1.9d38d75a36e2dp+4, 0x1.eda94565f4433p+3, -0x1.29e324fc69b3bp+3, 0x1.6a3af93aa248ap+2,
     -0x1.bcb16b0f75d7cp+1, 0x1.1139e67d29065p+1}, /* [60] 1.5 <= y <= 1.625 2^-16, degree 10, 59.2 bits */
    {0x1.4d51964377d19p+9, -0x1.f616236adb8cp-45, -0x1.da32b55c0e6dbp+7, 0x1.c195d6937c57bp+6, -0x1.cdc9f5540b951p+5,
     0x1.ec923130221d8p+4, -0x1.0c8a8e68a2bebp+4, 0x1.290d589bb226ap+3, -0x1.4bf12e4ae0cd8p+2, 0x1.75bdda2477ae4p+1,
     -0x1.a89cdfd9cb8fcp+0, 0x1.e3200aa5e5cb5p-1}, /* [61] 1.625 <= y <= 1.75 2^-16, degree 10, 60.1 bits */
    {0x1.3f5343ca517a4p+9, -0x1.2f8638f83d7f1p-46, -0x1.a6f7e349e785p+7, 0x1.755b6babfde9dp+6, -0x1.650b22b264b87p+5,
     0x1.629407c598abap+4, -0x1.67f4d18265261p+3, 0x1.72b6638c34852p+2, -0x1.81af672315658p+1, 0x1.944dc21fb6cfep+0,
     -0x1.ab79b05b5a09bp-1, 0x1.c4d6546ae14eap-2}, /* [62] 1.75 <= y <= 1.875 2^-16, degree 10, 59.7 bits */
    {0x1.32cbb0c52b5dap+9, -0x1.e997a0d65facfp-46, -0x1.7c2978cddbfaap+7, 0x1.39ebbb924a81fp+6, -0x1.18d600a903a8fp+5,
     0x1.04e745619c532p+4, -0x1.ef8bad4fe5482p+2, 0x1.dd6d62196d7d4p+1, -0x1.d0aa1ccbc8d25p+0, 0x1.c7ab8f3c76a12p-1,
     -0x1.c28c2cc98a91ep-2, 0x1.be7c2c9548235p-3}, /* [63] 1.875 <= y <= 2 2^-16, degree 10, 59.3 bits */
    {0x1.223fa8379ccbfp+9, -0x1.1c57ddf1da77p-46, -0x1.47eee077ee811p+8, 0x1.edcbb31a609bp+7, -0x1.92c646edd9b57p+7,
     0x1.552ba6ef13243p+7, -0x1.2769725c03503p+7, 0x1.037f856dc114dp+7, -0x1.cc8b1227375b9p+6, 0x1.9bc76438e0903p+6,
     -0x1.7551a6d84dee2p+6, 0x1.5152b05aa85d2p+6}, /* [64] 1 <= y <= 1.125 2^-15, degree 10, 55.8 bits */
    {0x1.0f80fcadee164p+9, 0x1.a9c4f543de1f2p-45, -0x1.1279aa39a0d97p+8, 0x1.71cacb9fc6b0dp+7, -0x1.0de0aaf2a20dcp+7,
     0x1.9912cb33c257dp+6, -0x1.3cec1cac344ffp+6, 0x1.f22d784c46f29p+5, -0x1.8b89ed868ed9ap+5, 0x1.3c6e256722787p+5,
     -0x1.00441775f2b1ep+5, 0x1.9e5c095fe2724p+4}, /* [65] 1.125 <= y <= 1.25 2^-15, degree 10, 56.9 bits */
    {0x1.ff58b5801acacp+8, 0x1.d8214650f12fep-46, -0x1.d3ba60689464fp+7, 0x1.1d11926680069p+7, -0x1.7876787ca8a6fp+6,
     0x1.02249b23a6cdfp+6, -0x1.69e3b4ce5773p+5, 0x1.0157ad5c078fap+5, -0x1.71ba6b7592c99p+4, 0x1.0b9cb37aa86e3p+4,
     -0x1.87b8337c4e01ap+3, 0x1.1e865e4c455b5p+3}, /* [66] 1.25 <= y <= 1.375 2^-15, degree 10, 58.6 bits */
    {0x1.e42bd94a02e24p+8, -0x1.c481ddfc90479p-46, -0x1.94602914d7c89p+7, 0x1.c20c86f8f01f2p+6, -0x1.0f53b42aadb0dp+6,
     0x1.53be9111c4d2dp+5, -0x1.b2dea40898846p+4, 0x1.1a594c4ca97f8p+4, -0x1.7261bf0daacdfp+3, 0x1.e98bfcf8c047dp+2,
     -0x1.46d8ce2b95a54p+2, 0x1.b490faac5db72p+1}, /* [67] 1.375 <= y <= 1.5 2^-15, degree 10, 60.4 bits */
    {0x1.cc886dfe53452p+8, -0x1.8d3d135f85749p-48, -0x1.61e029560f159p+7, 0x1.6a55d1c8b2512p+6, -0x1.91f0891ee40bcp+5,
     0x1.cf07405b01df3p+4, -0x1.10a10352fd0aep+4, 0x1.45b2f48bc9b11p+3, -0x1.8911a426439c4p+2, 0x1.ddf86e1694c63p+1,
     -0x1.2563f90320512p+1, 0x1.6886e3adc6dcep+0}, /* [68] 1.5 <= y <= 1.625 2^-15, degree 10, 59.0 bits */
    {0x1.b7bd518304c37p+8, -0x1.8d9401a27f3f3p-48, -0x1.38e144b30c0eep+7, 0x1.28a09ca887035p+6, -0x1.30acd0a61bfbdp+5,
     0x1.44fb6eec7a15ep+4, -0x1.6259147c05df8p+3, 0x1.87f7ca4825009p+2, -0x1.b6015f1bcfd65p+1, 0x1.ed28fbcda8efap+0,
     -0x1.18247e5b0138ap+0, 0x1.3ebf144d61d3ep-1}, /* [69] 1.625 <= y <= 1.75 2^-15, degree 10, 59.8 bits */
    {0x1.a546034bb40d8p+8, 0x1.dec1c52be3319p-47, -0x1.17145c8a56c1cp+7, 0x1.ecab190e979a3p+5, -0x1.d72288ee28e3dp+4,
     0x1.d3e0f22e75bbep+3, -0x1.daf92c4ff5ecep+2, 0x1.e92a410cf6597p+1, -0x1.fcebc4387e9fep+0, 0x1.0abe71c8a30cbp+0,
     -0x1.1a0804f59c7ddp-1, 0x1.2ac3896f639c5p-2}, /* [70] 1.75 <= y <= 1.875 2^-15, degree 10, 58.9 bits */
    {0x1.94bd35f9a6327p+8, 0x1.37a659ca9e57bp-46, -0x1.f5ac61b140259p+6, 0x1.9e3d4ca02ea9dp+5, -0x1.729384f26d6cap+4,
     0x1.5845968a710b7p+3, -0x1.46f1b0fe7fc9dp+2, 0x1.3afd45932317fp+1, -0x1.32917b93d0868p+0, 0x1.2ca2399b738a4p-1,
     -0x1.2940ee6beep-2, 0x1.2692b4c74e14dp-3}, /* [71] 1.875 <= y <= 2 2^-15, degree 10, 61.9 bits */
    {0x1.7ee73112dcf31p+8, -0x1.4fa5b968422e7p-46, -0x1.b0c0f58e1d37bp+7, 0x1.45cca381116b4p+7, -0x1.09bd99f01f487p+7,
     0x1.c2302ad4f3669p+6, -0x1.85ce56c7d96ap+6, 0x1.566a5ec1b16cbp+6, -0x1.2fd97e690fd3fp+6, 0x1.0fad1a1c5afb5p+6,
     -0x1.ec9a572933355p+5, 0x1.bd1addc2a6adp+5}, /* [72] 1 <= y <= 1.125 2^-14, degree 10, 55.8 bits */
    {0x1.662aa4b800311p+8, -0x1.bc4638dd2a72dp-46, -0x1.6a364d345962fp+7, 0x1.e7f8369db9ad6p+6, -0x1.641e468fcd089p+6,
     0x1.0de521e2ba6edp+6, -0x1.a230c9c4b2117p+5, 0x1.48ae3ffc53e62p+5, -0x1.04f66042080c2p+5, 0x1.a189beafee7dp+4,
     -0x1.5226339838db7p+4, 0x1.1160e1239fc86p+4}, /* [73] 1.125 <= y <= 1.25 2^-14, degree 10, 57.3 bits */
    {0x1.51468cb30c96bp+8, 0x1.fff4b0f704033p-46, -0x1.349f4f1ec4811p+7, 0x1.782c0d9459463p+6, -0x1.f0c3cbe20ea47p+5,
     0x1.54a1b780ea22dp+5, -0x1.dd8700bf839b4p+4, 0x1.53927e0752233p+4, -0x1.e7de237c8c51ap+3, 0x1.611f278e7a274p+3,
     -0x1.02712a3f29e1fp+3, 0x1.7a1397e5ba19bp+2}, /* [74] 1.25 <= y <= 1.375 2^-14, degree 10, 58.6 bits */
    {0x1.3f582a02f50b5p+8, -0x1.622062c386169p-47, -0x1.0ad2a239999acp+7, 0x1.28f0acc01b6e5p+6, -0x1.660877943b84dp+5,
     0x1.c04f45d9d35a1p+4, -0x1.1eea1448d94bbp+4, 0x1.7491cf67a393ap+3, -0x1.e8bb1cf0857e6p+2, 0x1.42fc5decd620fp+2,
     -0x1.af489158e2d07p+1, 0x1.2007bdcab8c9fp+1}, /* [75] 1.375 <= y <= 1.5 2^-14, degree 10, 58.7 bits */
    {0x1.2fbf2f275a9bcp+8, 0x1.e35cea7da621ap-46, -0x1.d30190b3b401ep+6, 0x1.de22e655d12cfp+5, -0x1.0931741177cd5p+5,
     0x1.317ec5ba3a03ep+4, -0x1.67befad71ceecp+3, 0x1.adc5c1854d8ebp+2, -0x1.035581679a85cp+2, 0x1.3b5937d3390dcp+1,
     -0x1.832326245bdf2p+0, 0x1.dbb99a99e1a5ap-1}, /* [76] 1.5 <= y <= 1.625 2^-14, degree 10, 60.9 bits */
    {0x1.2206bd9021ce6p+8, 0x1.f2717182db379p-46, -0x1.9ce88278a93d6p+6, 0x1.876e269cffd0bp+5, -0x1.920a5e8ace93fp+4,
     0x1.acd50b227c5c6p+3, -0x1.d3942b4485b5ep+2, 0x1.029bdd4123a68p+2, -0x1.20fb6545f9efdp+1, 0x1.455edb7ef89b8p+0,
     -0x1.71a819e370d53p-1, 0x1.a4984dd395874p-2}, /* [77] 1.625 <= y <= 1.75 2^-14, degree 10, 60.9 bits */
    {0x1.15d768fc56e6fp+8, -0x1.ff257959096fap-46, -0x1.704e160e3a10cp+6, 0x1.45108f744a36dp+5, -0x1.36d95a72faa78p+4,
     0x1.34b263288d51cp+3, -0x1.39601acf05027p+2, 0x1.42bcb63d4d0bbp+1, -0x1.4fc535a47173bp+0, 0x1.5ffa565d742ddp-1,
     -0x1.74263c300d29ep-2, 0x1.8a3a4da88f2cp-3}, /* [78] 1.75 <= y <= 1.875 2^-14, degree 10, 60.0 bits */
    {0x1.0aee5aee81adep+8, -0x1.4828bba2b1e7cp-46, -0x1.4b0911fa911f5p+6, 0x1.11517498c3bcbp+5, -0x1.e9013c3747bedp+3,
     0x1.c649c2b70eep+2, -0x1.af6b749ce1546p+1, 0x1.9fa4842fd9b04p+0, -0x1.9487776c92552p-1, 0x1.8cb27500e6ffep-2,
     -0x1.883c72626801p-3, 0x1.84b2c5a03c3b2p-4}, /* [79] 1.875 <= y <= 2 2^-14, degree 10, 59.9 bits */
    {0x1.f90b6055deb5fp+7, 0x1.17651da545bbap-48, -0x1.1d8fc6860210bp+7, 0x1.adeeb1f28956ep+6, -0x1.5eaadf8fa0033p+6,
     0x1.2906d4d30b022p+6, -0x1.012f74a8ee20ep+6, 0x1.c3d572aeaeaa9p+5, -0x1.90f14b3c5933fp+5, 0x1.667cbd6c07b89p+5,
     -0x1.4500e73ee5c2p+5, 0x1.25aa54116af85p+5}, /* [80] 1 <= y <= 1.125 2^-13, degree 10, 55.6 bits */
    {0x1.d865faa454032p+7, 0x1.fba23cfcbfd5fp-49, -0x1.de08d4425f5a1p+6, 0x1.41f884b9e3da5p+6, -0x1.d5ee6783f51d6p+5,
     0x1.64256bed0ecd9p+5, -0x1.13e9f58db6bc7p+5, 0x1.b1b61b0d6b18p+4, -0x1.585a1e1495768p+4, 0x1.137ac11409b4dp+4,
     -0x1.be336f10c7cc1p+3, 0x1.68bb8b6cd5679p+3}, /* [81] 1.125 <= y <= 1.25 2^-13, degree 10, 57.2 bits */
    {0x1.bcd3b39205f7dp+7, 0x1.c06b1ea984a91p-47, -0x1.9750b2b1b6dbep+6, 0x1.f069f65675879p+5, -0x1.47c4030b55aafp+5,
     0x1.c17d881cfce63p+4, -0x1.3b10751447e2ap+4, 0x1.c015b10ef03cap+3, -0x1.41e207f40e049p+3, 0x1.d1f5c40bd2246p+2,
     -0x1.550663e7d1de6p+2, 0x1.f2e2ee463c2cp+1}, /* [82] 1.25 <= y <= 1.375 2^-13, degree 10, 58.9 bits */
    {0x1.a529548090d0ap+7, 0x1.f4225fe2710b4p-47, -0x1.60278a2cb04afp+6, 0x1.87dbeca14f5dfp+5, -0x1.d876a7722323bp+4,
     0x1.27ca8f51ed557p+4, -0x1.7a9a87e904241p+3, 0x1.eba0c9a68e2c9p+2, -0x1.42740b13099e8p+2, 0x1.aa3202fe1c35p+1,
     -0x1.1c8c7cb86721fp+1, 0x1.7c1151642e3e1p+0}, /* [83] 1.375 <= y <= 1.5 2^-13, degree 10, 58.4 bits */
    {0x1.9093542e881d4p+7, 0x1.ef75d7eefe9fep-49, -0x1.342f04d12f9cap+6, 0x1.3b7d932ad1802p+5, -0x1.5df401975bd6ep+4,
     0x1.9320e567e4d04p+3, -0x1.dab637378cdc8p+2, 0x1.1b8e65ea06309p+2, -0x1.5634bbfc5265ep+1, 0x1.a01e588bce1cp+0,
     -0x1.fed8870791332p-1, 0x1.39deb04451a77p-1}, /* [84] 1.5 <= y <= 1.625 2^-13, degree 10, 60.1 bits */
    {0x1.7e7779b963c43p+7, -0x1.77791587d5cebp-48, -0x1.107ce8534aad9p+6, 0x1.0247f19e2fbf3p+5, -0x1.094560f79bee7p+4,
     0x1.1af14f1880723p+3, -0x1.3480f0c9f7633p+2, 0x1.5540863f0e9e6p+1, -0x1.7d544782ff02cp+0, 0x1.ad581750fad5p-1,
     -0x1.e7c7c01b0d36cp-2, 0x1.157f446532dp-2}, /* [85] 1.625 <= y <= 1.75 2^-13, degree 10, 60.6 bits */
    {0x1.6e6267b7fa112p+7, -0x1.3d5668dc7697ap-47, -0x1.e61d1c4344fadp+5, 0x1.acfbf80b7e693p+4, -0x1.9a34b52ee6717p+3,
     0x1.975b572a3f96ap+2, -0x1.9d8671f6b2262p+1, 0x1.a9dfff5c10b1dp+0, -0x1.bb1204bcb1a73p-1, 0x1.d0747ab2890bfp-2,
     -0x1.eb120ea64aa96p-3, 0x1.0419ec7fdda6cp-3}, /* [86] 1.75 <= y <= 1.875 2^-13, degree 10, 59.5 bits */
    {0x1.5ffbeab5a583ep+7, 0x1.2a31777d8d1f4p-47, -0x1.b4ede3bd206a7p+5, 0x1.68b2a381a2b8ap+4, -0x1.42a79485140cfp+3,
     0x1.2bbdabff6f3cep+2, -0x1.1ca5f54895b9ep+1, 0x1.123c6d51a1668p+0, -0x1.0ae6d527d3ec7p-1, 0x1.05bb9d9a4a899p-2,
     -0x1.02c9df1e41626p-3, 0x1.00741d32267acp-4}, /* [87] 1.875 <= y <= 2 2^-13, degree 10, 60.8 bits */
    {0x1.4cf73e172158ap+7, -0x1.366db059667afp-48, -0x1.78eacba914ed2p+6, 0x1.1bb1ac3abc929p+6, -0x1.cec1fbe61675fp+5,
     0x1.87f5ffcd5ad61p+5, -0x1.53616e51358b6p+5, 0x1.2a1da5a95f20fp+5, -0x1.08894abe5859dp+5, 0x1.d90c11d78c5b1p+4,
     -0x1.acdc7dc00bb3p+4, 0x1.8381e1e1e1fc2p+4}, /* [88] 1 <= y <= 1.125 2^-12, degree 10, 55.8 bits */
    {0x1.376ba362be872p+7, 0x1.40eb0f887e33bp-48, -0x1.3b7dce443ac22p+6, 0x1.a8ea7dea48f64p+5, -0x1.361344f4a92b4p+5,
     0x1.d5facffe754c9p+4, -0x1.6c18daf161478p+4, 0x1.1e2910dfc35aep+4, -0x1.c66648e22b606p+3, 0x1.6b83bf056ecc2p+3,
     -0x1.266535f03b649p+3, 0x1.dc020890d4a11p+2}, /* [89] 1.125 <= y <= 1.25 2^-12, degree 10, 57.4 bits */
    {0x1.253947a5e966ap+7, 0x1.206bb753508d1p-48, -0x1.0cd36564fc04cp+6, 0x1.47927acab2cafp+5, -0x1.b08b606f0af2cp+4,
     0x1.2894f9c247744p+4, -0x1.9fc347c6cf9cfp+3, 0x1.27a5421944681p+3, -0x1.a8c07b91fca95p+2, 0x1.336f541ae4f15p+2,
     -0x1.c2018c848ca25p+1, 0x1.4927fdee8e19dp+1}, /* [90] 1.25 <= y <= 1.375 2^-12, degree 10, 58.1 bits */
    {0x1.159abc831b0ccp+7, 0x1.7456104983429p-50, -0x1.d0da33e55b618p+5, 0x1.029525d93d6e1p+5, -0x1.37c0a346c19abp+4,
     0x1.86570955939edp+3, -0x1.f39d053d52674p+2, 0x1.44608c6140194p+2, -0x1.a981aded2e22bp+1, 0x1.19332773f68d3p+1,
     -0x1.777bb6b0d53f7p+0, 0x1.f58674b05b39cp-1}, /* [91] 1.375 <= y <= 1.5 2^-12, degree 10, 58.7 bits */
    {0x1.08046d746d5e1p+7, 0x1.77f8c0c40d56fp-49, -0x1.96d20ad516002p+5, 0x1.a061c996b4458p+4, -0x1.cdd581a47dab2p+3,
     0x1.09fee4f9f862ep+3, -0x1.3938ca5f32283p+2, 0x1.762f157585a64p+1, -0x1.c392fd9484f13p+0, 0x1.128d68b87244dp+0,
     -0x1.510cffe263d8bp-1, 0x1.9e2c9647cd3dcp-2}, /* [92] 1.5 <= y <= 1.625 2^-12, degree 10, 60.3 bits */
    {0x1.f8212e3b9e6bap+6, 0x1.b3a247c0b00d4p-51, -0x1.67b58d01bf3a6p+5, 0x1.54e1d280c9bd4p+4, -0x1.5e150ce05bbb1p+3,
     0x1.7563dabf6e77ap+2, -0x1.971cf45617848p+1, 0x1.c25284eb8c9f8p+0, -0x1.f734144ccb4a4p-1, 0x1.1b479a5993bd4p-1,
     -0x1.41d565a170363p-2, 0x1.6e2dced58bebfp-3}, /* [93] 1.625 <= y <= 1.75 2^-12, degree 10, 60.0 bits */
    {0x1.e2e6338431123p+6, 0x1.031f9bbac452bp-50, -0x1.40dd904f7a51ap+5, 0x1.1b17cc4970bfcp+4, -0x1.0eae1cdcc318ep+3,
     0x1.0cca29fb4139ep+2, -0x1.10da790e71c74p+1, 0x1.18ff64a13c682p+0, -0x1.24570a3e2bb86p-1, 0x1.32726e3c6303fp-2,
     -0x1.4401737f464e3p-3, 0x1.573992c20fe4ep-4}, /* [94] 1.75 <= y <= 1.875 2^-12, degree 10, 58.8 bits */
    {0x1.cfe3842e10eeep+6, -0x1.f03964660f4a3p-49, -0x1.206860e6b92f7p+5, 0x1.dc10e2f3b638dp+3, -0x1.a9d208192e5aep+2,
     0x1.8b906a52deb38p+1, -0x1.77a321b7f28a9p+0, 0x1.69e3fed4bcaccp-1, -0x1.60352a47bce89p-2, 0x1.596235e0a9e8cp-3,
     -0x1.557eedfd54229p-4, 0x1.52699fbd098cp-5}, /* [95] 1.875 <= y <= 2 2^-12, degree 10, 60.6 bits */
    {0x1.b6c7fc73576bp+6, -0x1.b5dea7e61f4d4p-50, -0x1.f19ba02672474p+5, 0x1.7670b553055f1p+5, -0x1.315d4ba5fcea8p+5,
     0x1.02a2bbc4ac573p+5, -0x1.bfde76b61a5edp+4, 0x1.8967f8b4d8285p+4, -0x1.5d16afc4843eap+4, 0x1.381e85913e114p+4,
     -0x1.1af68078c4264p+4, 0x1.ff5a132c96c4fp+3}, /* [96] 1 <= y <= 1.125 2^-11, degree 10, 55.7 bits */
    {0x1.9a5617d1c45fcp+6, 0x1.afe2af9ea489p-48, -0x1.a0885e0c58972p+5, 0x1.186cce3d00706p+5, -0x1.993b767e847bp+4,
     0x1.361ef25ae05acp+4, -0x1.e07e013ca70a7p+3, 0x1.79a21388cf4abp+3, -0x1.2bd231df5fa5dp+3, 0x1.dfb3ad3cdf7dcp+2,
     -0x1.847cb739b9171p+2, 0x1.3a12013933cc7p+2}, /* [97] 1.125 <= y <= 1.25 2^-11, degree 10, 57.4 bits */
    {0x1.824faf376db62p+6, 0x1.c8627c598fa0bp-48, -0x1.62f002f8b4e31p+5, 0x1.b0604e850678dp+4, -0x1.1d700c247ef39p+4,
     0x1.876922e3e64c9p+3, -0x1.125726d465c22p+3, 0x1.8627717770e71p+2, -0x1.1842eda02003cp+2, 0x1.95b36fe049358p+1,
     -0x1.28eb1ccaf90cap+1, 0x1.b25b93882dfb5p+0}, /* [98] 1.25 <= y <= 1.375 2^-11, degree 10, 58.7 bits */
    {0x1.6db0312979f27p+6, 0x1.4354e3fdb4d98p-48, -0x1.32e4420221d2ap+5, 0x1.55528deb255a5p+4, -0x1.9b75e4c612b4p+3,
     0x1.0193b425f4e85p+3, -0x1.49ac3f8b27b47p+2, 0x1.ac130e197c3a2p+1, -0x1.18c3047966528p+1, 0x1.731547d5517b9p+0,
     -0x1.ef7f9cb0b0821p-1, 0x1.4ae92c93967c7p-1}, /* [99] 1.375 <= y <= 1.5 2^-11, degree 10, 58.3 bits */
    {0x1.5bbf654226b55p+6, -0x1.a4c94c4540ad6p-48, -0x1.0c9743d3de4c2p+5, 0x1.12d043078b3aap+4, -0x1.30c6d20413d23p+3,
     0x1.5f0deefc9bc5p+2, -0x1.9d5e01ce17246p+1, 0x1.edcee90243e8dp+0, -0x1.29f6e7ffdfc5ep+0, 0x1.6a5048097772p-1,
     -0x1.bcc8ef43ce559p-2, 0x1.11470bbe4cd2ap-2}, /* [100] 1.5 <= y <= 1.625 2^-11, degree 10, 61.6 bits */
    {0x1.4bf6fbde102bbp+6, 0x1.6d4a600357fd3p-48, -0x1.dafe6a272ae61p+4, 0x1.c1fa3b39475efp+3, -0x1.ce10ae269b2f2p+2,
     0x1.eccc22ca2681fp+1, -0x1.0ca458930143ap+1, 0x1.292589cc33aep+0, -0x1.4c08b5841d32p-1, 0x1.75d558e34f49dp-2,
     -0x1.a8b4e0c373793p-3, 0x1.e338e4a7f6d5dp-4}, /* [101] 1.625 <= y <= 1.75 2^-11, degree 10, 61.6 bits */
    {0x1.3df27bd6903aep+6, -0x1.2dc03adc602f5p-50, -0x1.a7b7d21f50062p+4, 0x1.75b3cbb3f5e92p+3, -0x1.65452c47ad8ffp+2,
     0x1.62c0555e4618bp+1, -0x1.68198d83c95d9p+0, 0x1.72d67b7115e11p-1, -0x1.81cc7877b0d56p-2, 0x1.9468c9fe50456p-3,
     -0x1.ab936546c8874p-4, 0x1.c4ef1cdcf697ep-5}, /* [102] 1.75 <= y <= 1.875 2^-11, degree 10, 60.0 bits */
    {0x1.316513cf86486p+6, 0x1.a3949c0da35a4p-49, -0x1.7cdeff580109fp+4, 0x1.3a3a2e6856e3bp+3, -0x1.190641b4d3ba6p+2,
     0x1.0509c0b701f02p+1, -0x1.efc1318b6db41p-1, 0x1.dd9922daea8fp-2, -0x1.d0cf317ba3a8fp-3, 0x1.c7cbd2e251f91p-4,
     -0x1.c2a8e039a12cbp-5, 0x1.be960feda382dp-6}, /* [103] 1.875 <= y <= 2 2^-11, degree 10, 61.4 bits */
    {0x1.20d0dc6f34991p+6, 0x1.baa1bc7d9c5e2p-48, -0x1.4896dc853ed4bp+5, 0x1.ee50b1fc208fep+4, -0x1.9310febfb358ep+4,
     0x1.555c61521324bp+4, -0x1.278bf210a6194p+4, 0x1.03993fcf0e55ap+4, -0x1.ccb2d891b14abp+3, 0x1.9be6f4981c09ep+3,
     -0x1.756b610db569p+3, 0x1.5167da9c5171p+3}, /* [104] 1 <= y <= 1.125 2^-10, degree 10, 55.7 bits */
    {0x1.0e082d7fb9898p+6, 0x1.e775eb6ef7e4ap-48, -0x1.13129ad878abbp+5, 0x1.7237bfcac48c1p+4, -0x1.0e178dc2d836bp+4,
     0x1.9952ec468aca6p+3, -0x1.3d14c46a9eaa3p+3, 0x1.f263c1a7e7351p+2, -0x1.8baf7d9217b62p+2, 0x1.3c88d385d997ep+2,
     -0x1.00578767ccf7ap+2, 0x1.9e78a84e082a8p+1}, /* [105] 1.125 <= y <= 1.25 2^-10, degree 10, 57.1 bits */
    {0x1.fc54c62d38dadp+5, -0x1.403453f4e164fp-49, -0x1.d4d35ce279a4ap+4, 0x1.1d6c98c587919p+4, -0x1.78c99c4d8c595p+3,
     0x1.02509969b190bp+3, -0x1.6a1635ddda60ep+2, 0x1.0176336daa1dap+2, -0x1.71e0a746b1793p+1, 0x1.0bb5479817577p+1,
     -0x1.87d8948ae66cfp+0, 0x1.1e9bf0f6af763p+0}, /* [106] 1.25 <= y <= 1.375 2^-10, degree 10, 58.4 bits */
    {0x1.e117067c01e34p+5, 0x1.f8d64ba38d397p-49, -0x1.95642e6dc6832p+4, 0x1.c2a714c0dfdaep+3, -0x1.0f9444d38f1e3p+3,
     0x1.53fd04a244e03p+2, -0x1.b32025234fc8dp+1, 0x1.1a7d7681d21b9p+1, -0x1.728b1f77162e9p+0, 0x1.e9bc934ed8622p-1,
     -0x1.46f6032a3031fp-1, 0x1.b4b48566c508p-2}, /* [107] 1.375 <= y <= 1.5 2^-10, degree 10, 59.6 bits */
    {0x1.c963edcbb4314p+5, 0x1.b492d6b5d81b8p-49, -0x1.62d2437d25889p+4, 0x1.6adacc8ebfaf3p+3, -0x1.9256ee28dc8dap+2,
     0x1.cf62756e22dddp+1, -0x1.10cd0c25d195ep+1, 0x1.45dfb58662927p+0, -0x1.8940c3eeb2f65p-1, 0x1.de2b5abbdb7cep-2,
     -0x1.2580206e7b775p-2, 0x1.68a66a47085c6p-3}, /* [108] 1.5 <= y <= 1.625 2^-10, degree 10, 59.9 bits */
    {0x1.b48a2e9871ac5p+5, -0x1.f6cb65a188007p-49, -0x1.39c3dd7c65f21p+4, 0x1.2914557d465e8p+3, -0x1.30ff74d90878ap+2,
     0x1.453fa7b0127e6p+1, -0x1.62961c9039773p+0, 0x1.88313fd62154p-1, -0x1.b6396958a1168p-2, 0x1.ed61128e2b887p-3,
     -0x1.184133206077p-3, 0x1.3edcd90d3119ep-4}, /* [109] 1.625 <= y <= 1.75 2^-10, degree 10, 58.8 bits */
    {0x1.a20525a3bb54bp+5, 0x1.b6808a33bb758p-49, -0x1.17e966348b05ep+4, 0x1.ed7679b811d83p+2, -0x1.d7a9f7da78fafp+1,
     0x1.d44920c1a07e9p+0, -0x1.db4fff36ddad8p-1, 0x1.e97663ef66af1p-2, -0x1.fd30ec730c495p-3, 0x1.0adeacc303618p-3,
     -0x1.1a26bb1778407p-4, 0x1.2ae1319cea51cp-5}, /* [110] 1.75 <= y <= 1.875 2^-10, degree 10, 60.0 bits */
    {0x1.916f695d6c49p+5, -0x1.059777247da99p-50, -0x1.f73e86c8f0ddp+3, 0x1.9ef18772cfb42p+2, -0x1.7303f5f0c33aap+1,
     0x1.589691e298f49p+0, -0x1.4730dc64d925p-1, 0x1.3b311cc277ab8p-2, -0x1.32bd8c03c5406p-3, 0x1.2cc8a81d6a814p-4,
     -0x1.29632fbda3fe7p-5, 0x1.26b1a8028ab9dp-6}, /* [111] 1.875 <= y <= 2 2^-10, degree 10, 59.7 bits */
    {0x1.7b874a5ed90cdp+5, 0x1.608f81de92d1ep-49, -0x1.b23407fcda2c7p+4, 0x1.46650c6278306p+4, -0x1.0a147a3e3918ep+4,
     0x1.c2a265d982db8p+3, -0x1.861fa512936bbp+3, 0x1.56a73dcb9f202p+3, -0x1.3008b0534b629p+3, 0x1.0fd2a5437308ep+3,
     -0x1.ecd7ab3e472f4p+2, 0x1.bd4d681416d54p+2}, /* [112] 1 <= y <= 1.125 2^-9, degree 10, 55.7 bits */
    {0x1.62b4a99a7cc1dp+5, 0x1.92816f139a5fdp-49, -0x1.6b86f11f7825cp+4, 0x1.e8f1316241d43p+3, -0x1.649d962cfde21p+3,
     0x1.0e30210356e4p+3, -0x1.a2906716f3de6p+2, 0x1.48ee57f327bc6p+2, -0x1.0522dcea201a7p+2, 0x1.a1c919dd6a37ep+1,
     -0x1.525474ccde2adp+1, 0x1.1182fea7a82p+1}, /* [113] 1.125 <= y <= 1.25 2^-9, degree 10, 57.5 bits */
    {0x1.4dbc717d952fbp+5, -0x1.e27cf9f9913bdp-51, -0x1.35d38b598dfdbp+4, 0x1.78fb7e27f5cdep+3, -0x1.f18430c0ae315p+2,
     0x1.550865806b19dp+2, -0x1.ddfd8caac65ap+1, 0x1.53da6fcf81212p+1, -0x1.e8388b997037p+0, 0x1.61596c7758254p+0,
     -0x1.0297a13b72188p+0, 0x1.7a46f1637e437p-1}, /* [114] 1.25 <= y <= 1.375 2^-9, degree 10, 57.8 bits */
    {0x1.3bbb8f33ac1c8p+5, 0x1.3dcc6a26191f9p-52, -0x1.0bef02782632dp+4, 0x1.29a0559331a3ep+3, -0x1.669d8c6da159fp+2,
     0x1.c0e0beee296acp+1, -0x1.1f36d1395cdd4p+1, 0x1.74e6e7cdc468ap+0, -0x1.e91ccb14fe65bp-1, 0x1.4335df1b9527ep-1,
     -0x1.af8ddb7dcbc4fp-2, 0x1.2031faf9a928p-2}, /* [115] 1.375 <= y <= 1.5 2^-9, degree 10, 58.2 bits */
    {0x1.2c1175342eaa9p+5, 0x1.d898b032d127fp-49, -0x1.d511a2458efe4p+3, 0x1.df50741dd9e34p+2, -0x1.09a76c8dd8c82p+2,
     0x1.31e8cd96cc425p+1, -0x1.6825f9b97974dp+0, 0x1.ae2ee44df068ap-1, -0x1.038d0b94bd7ebp-1, 0x1.3b9566af7668ep-2,
     -0x1.8365d8d04c6b9p-3, 0x1.dc046f4da2f89p-4}, /* [116] 1.5 <= y <= 1.625 2^-9, degree 10, 61.7 bits */
    {0x1.1e4912dbbdd42p+5, 0x1.ecb90103caa2ep-49, -0x1.9ed574dd3d4dep+3, 0x1.8873fa1ccc498p+2, -0x1.92c86c0c5597cp+1,
     0x1.ad73622932396p+0, -0x1.d422b068e82d7p-1, 0x1.02df40e2aacdep-1, -0x1.213d592c67721p-2, 0x1.45a10d7f14c84p-3,
     -0x1.71ec0461eb116p-4, 0x1.a4dedf9eb02efp-5}, /* [117] 1.625 <= y <= 1.75 2^-9, degree 10, 59.3 bits */
    {0x1.120ad3f91903p+5, -0x1.343106bd516d1p-49, -0x1.721c632f040ccp+3, 0x1.45f624a8ac863p+2, -0x1.3774cb4f2d1f7p+1,
     0x1.352b1626bed15p+0, -0x1.39c552d588e8cp-1, 0x1.4315e08482c3ap-2, -0x1.50167d077330ep-3, 0x1.6046504df8677p-4,
     -0x1.746ecdde46591p-5, 0x1.8a8085e01ce44p-6}, /* [118] 1.75 <= y <= 1.875 2^-9, degree 10, 60.6 bits */
    {0x1.0713c1aaaab75p+5, -0x1.94118c3b189dep-49, -0x1.4cbc6275617bep+3, 0x1.121c7e6951ff8p+2, -0x1.ea02e238d04a4p+0,
     0x1.c7051a8c71374p-1, -0x1.affe865cbdbfap-2, 0x1.a01dc5e1fe667p-3, -0x1.94eee8283ca06p-4, 0x1.8d0cf054d3904p-5,
     -0x1.888d4ade5ff41p-6, 0x1.84fbf7fe0ea18p-7}, /* [119] 1.875 <= y <= 2 2^-9, degree 10, 59.6 bits */
    {0x1.f12f0da60fbffp+4, -0x1.5174b26fa209bp-52, -0x1.1f2022585c1d3p+4, 0x1.af451a2241efp+3, -0x1.5f717163bbad4p+3,
     0x1.298aa9d1dcadcp+3, -0x1.018de7c99014cp+3, 0x1.c4638cb9196c2p+2, -0x1.915fe0f7808a5p+2, 0x1.66d4f97ec16cfp+2,
     -0x1.454927092d0dp+2, 0x1.25e5febecdf7bp+2}, /* [120] 1 <= y <= 1.125 2^-8, degree 10, 55.6 bits */
    {0x1.d05a1b6e7186dp+4, -0x1.348cd5658c2f3p-51, -0x1.e0dc538d54716p+3, 0x1.430f348d4a3b6p+3, -0x1.d7107d91f3b83p+2,
     0x1.64d20aaaef24ep+2, -0x1.1458be50fe699p+2, 0x1.b24b5df7a2584p+1, -0x1.58c21e16bf612p+1, 0x1.13c50a5c241adp+1,
     -0x1.bea02fa336fe5p+0, 0x1.690bee88dbc32p+0}, /* [121] 1.125 <= y <= 1.25 2^-8, degree 10, 57.3 bits */
    {0x1.b49ca803ba671p+4, -0x1.1c9d6dce4efb3p-51, -0x1.99e4b5a648179p+3, 0x1.f238d106141dp+2, -0x1.489e924005a8p+2,
     0x1.c269413800a91p+1, -0x1.3b997b47a0e38p+1, 0x1.c0bcdbbd4c221p+0, -0x1.424b7ae99454dp+0, 0x1.d27e215f68b1p-1,
     -0x1.5560a648d13cp-1, 0x1.f35bb2c8d56acp-2}, /* [122] 1.25 <= y <= 1.375 2^-8, degree 10, 59.1 bits */
    {0x1.9ccabe0361bf1p+4, 0x1.3dbfcc722771fp-51, -0x1.62866518d6482p+3, 0x1.8962ab019914ep+2, -0x1.d9c874819cd47p+1,
     0x1.2871229efad58p+1, -0x1.7b4b879e57f77p+0, 0x1.ec6617feb2739p-1, -0x1.42e5bf8893fe3p-1, 0x1.aab8547463477p-2,
     -0x1.1cdda2224c6bfp-2, 0x1.7c747b82011d5p-3}, /* [123] 1.375 <= y <= 1.5 2^-8, degree 10, 58.7 bits */
    {0x1.881042dc9cc4bp+4, -0x1.f93a368593024p-50, -0x1.3660b0704eaf5p+3, 0x1.3ccc01bffc041p+2, -0x1.5efea34c34c5cp+1,
     0x1.941329b899033p+0, -0x1.dba34673fe029p-1, 0x1.1c080ad77cbd7p-1, -0x1.56b5cb08102e6p-2, 0x1.a0aaaadb92d2fp-3,
     -0x1.ff747aa671281p-4, 0x1.3a3661d1ecbd3p-4}, /* [124] 1.5 <= y <= 1.625 2^-8, degree 10, 58.5 bits */
    {0x1.75d28c5657e2cp+4, -0x1.4071d9e90d511p-51, -0x1.1287adc06beeep+3, 0x1.0369885c8b14ep+2, -0x1.0a1ba3e4e7c7p+1,
     0x1.1ba5cf8642203p+0, -0x1.3524a094dbf76p-1, 0x1.55dc2c1ceb5bfp-2, -0x1.7ded4302cfda4p-3, 0x1.adf22afc8ac68p-4,
     -0x1.e8664a44bb0ep-5, 0x1.15d1d61421a5bp-5}, /* [125] 1.625 <= y <= 1.75 2^-8, degree 10, 59.0 bits */
    {0x1.659de2db83ba3p+4, 0x1.47e615876616bp-51, -0x1.e9eef2b739217p+2, 0x1.aef686a39e111p+1, -0x1.9b92656cf7fffp+0,
     0x1.986df5c77fb09p-1, -0x1.9e6e81762702fp-2, 0x1.aaad92b8c2fbep-3, -0x1.bbce3b503b92bp-4, 0x1.d1250951e058cp-5,
     -0x1.ebbb32011b9dp-6, 0x1.046bf5cec92c2p-6}, /* [126] 1.75 <= y <= 1.875 2^-8, degree 10, 61.3 bits */
    {0x1.5719ca01c9b9p+4, -0x1.42f29456a1119p-50, -0x1.b88441072c815p+2, 0x1.6a718ae2a850ap+1, -0x1.43c8c443148a9p+0,
     0x1.2c9261404bd76p-1, -0x1.1d4e3e0fa237ap-2, 0x1.12c7f89ee6eep-3, -0x1.0b5e67a955214p-4, 0x1.0624960fa66abp-5,
     -0x1.0327f2315a84fp-6, 0x1.00c981950bb34p-7}, /* [127] 1.875 <= y <= 2 2^-8, degree 10, 61.6 bits */
    {0x1.43ebeb3d6c605p+4, 0x1.482603f5bf22fp-52, -0x1.7c345952a0cecp+3, 0x1.1d2937f6a423fp+3, -0x1.d07e61003d36bp+2,
     0x1.892087facade1p+2, -0x1.543905fce6882p+2, 0x1.2ac0c8f3e1e41p+2, -0x1.0908d47a08d59p+2, 0x1.d9d85940f406fp+1,
     -0x1.ad8448c5c8585p+1, 0x1.840cd180c0c7ap+1}, /* [128] 1 <= y <= 1.125 2^-7, degree 10, 55.7 bits */
    {0x1.2e2e7380e4881p+4, -0x1.309f8add54d81p-51, -0x1.3e72d71640077p+3, 0x1.ab4b3cc2986a7p+2, -0x1.3756a68c6a4b6p+2,
     0x1.d7805d5d3c0f8p+1, -0x1.6d14ed0f2cad7p+1, 0x1.1ed3e8be29572p+1, -0x1.c7557d359a1f6p+0, 0x1.6c2f43a34ad19p+0,
     -0x1.26e32a06553ffp+0, 0x1.dcbcbea06d706p-1}, /* [129] 1.125 <= y <= 1.25 2^-7, degree 10, 57.4 bits */
    {0x1.1bcf025a93982p+4, 0x1.5058b245bb128p-50, -0x1.0f8339bf30689p+3, 0x1.498a08cf5bc61p+2, -0x1.b270f7fb15fcbp+1,
     0x1.299e1b2d43bfdp+1, -0x1.a0fa21c0abd44p+0, 0x1.28640fefd80e1p+0, -0x1.a9b260c52e763p-1, 0x1.340c5ae088587p-1,
     -0x1.c2d21c5d2efb3p-2, 0x1.49b3e9ac3a5b7p-2}, /* [130] 1.25 <= y <= 1.375 2^-7, degree 10, 58.2 bits */
    {0x1.0c075514d8bd7p+4, 0x1.cf9460147508bp-52, -0x1.d5c667c182099p+2, 0x1.043cb8b2a869ep+2, -0x1.3936ae2303af9p+1,
     0x1.87cca2473ff0ap+0, -0x1.f52d720a96feap-1, 0x1.45412a7e66c7ep-1, -0x1.aa85ddfcd1042p-2, 0x1.19cd7535695edp-2,
     -0x1.7836ca5099924p-3, 0x1.f66bbac18fc26p-4}, /* [131] 1.375 <= y <= 1.5 2^-7, degree 10, 59.4 bits */
    {0x1.fc966bef5532ap+3, 0x1.a885325de695ap-51, -0x1.9b5c71dd21d9bp+2, 0x1.a33469a4649dbp+1, -0x1.d0222f70724d7p+0,
     0x1.0b0dd0915026dp+0, -0x1.3a443e07b2bcdp-1, 0x1.77435e87a2845p-2, -0x1.c4b99f9c1cd36p-3, 0x1.132e3ff849a09p-3,
     -0x1.51c061a879c69p-4, 0x1.9ef6ec3801608p-5}, /* [132] 1.5 <= y <= 1.625 2^-7, degree 10, 59.0 bits */
    {0x1.e468c8a537e6bp+3, -0x1.47e48db354faep-53, -0x1.6bec084ded854p+2, 0x1.5751944e7f2b9p+1, -0x1.5fecbfcce68f1p+0,
     0x1.76f67d6ca219ep-1, -0x1.988d63e217de1p-2, 0x1.c3b33738f0b9ep-3, -0x1.f8908ee9afdp-4, 0x1.1bf7d682b7bap-4,
     -0x1.428b62b1ce2e9p-5, 0x1.6eebf249aa902p-6}, /* [133] 1.625 <= y <= 1.75 2^-7, degree 10, 59.0 bits */
    {0x1.ceecb9fc8e7f9p+3, 0x1.4229f44aeae55p-52, -0x1.44cb3c88da26cp+2, 0x1.1d37b919cf506p+1, -0x1.102dfddaa9dfcp+0,
     0x1.0dfbb042a9b4dp-1, -0x1.11df0808691e3p-2, 0x1.19e7cbe1de346p-3, -0x1.252cf4efde56ep-4, 0x1.333bf964ccad2p-5,
     -0x1.44c33b2e51ca9p-6, 0x1.57f6221b0e76ap-7}, /* [134] 1.75 <= y <= 1.875 2^-7, degree 10, 59.3 bits */
    {0x1.bbad38f3b1fd9p+3, 0x1.40a368380cc07p-51, -0x1.2416478c9439fp+2, 0x1.dfcdee015c7f4p+0, -0x1.ac4b528ac7babp-1,
     0x1.8d68952865bf9p-2, -0x1.791c3176b1b8bp-3, 0x1.6b1ed7e91a854p-4, -0x1.61446d3714a33p-5, 0x1.5a5167a4bfdc6p-6,
     -0x1.5656180f585bbp-7, 0x1.532d8c75b26dbp-8}, /* [135] 1.875 <= y <= 2 2^-7, degree 10, 59.8 bits */
    {0x1.a23d59d32e9e5p+3, -0x1.a9d623b6026b8p-51, -0x1.f85341c6f05d6p+2, 0x1.7991c237caccdp+2, -0x1.33421f5bea6dap+2,
     0x1.03ecf5e60a0abp+2, -0x1.c1c001c482d9cp+1, 0x1.8ad6f5b70d767p+1, -0x1.5e37336bb129ep+1, 0x1.3906a279ab2afp+1,
     -0x1.1bb5e4974c3ap+1, 0x1.004c074e72c65p+1}, /* [136] 1 <= y <= 1.125 2^-6, degree 10, 55.8 bits */
    {0x1.8565cd725eb14p+3, 0x1.d86be617c96c7p-52, -0x1.a68c257225449p+2, 0x1.1af2e47e8667ap+2, -0x1.9bf9eac93bcep+1,
     0x1.37cc1216f89a1p+1, -0x1.e2aed5db7b784p+0, 0x1.7b20fbe1dcd7cp+0, -0x1.2cdfced679b52p+0, 0x1.e13824a2d6975p-1,
     -0x1.859b1e5adcff6p-1, 0x1.3ae6ff768918fp-1}, /* [137] 1.125 <= y <= 1.25 2^-6, degree 10, 57.2 bits */
    {0x1.6d03e2f2ee9dfp+3, -0x1.cf3229882985fp-52, -0x1.68613626fb48dp+2, 0x1.b48870112db5dp+1, -0x1.1f7d4832b40ep+1,
     0x1.89af06259abf8p+0, -0x1.13afb646e7b8bp+0, 0x1.87d1a12a622bbp-1, -0x1.1952afe7ddb09p-1, 0x1.9715f8d69cc08p-2,
     -0x1.29d7854bcc91ep-2, 0x1.b399e15678226p-3}, /* [138] 1.25 <= y <= 1.375 2^-6, degree 10, 58.1 bits */
    {0x1.58113c67ee93ep+3, 0x1.296c6f43073b1p-51, -0x1.37dbb617e69ep+2, 0x1.58cdfc08670acp+1, -0x1.9e9bf581a28e8p+0,
     0x1.032c36738b0d2p+0, -0x1.4b669afa6c283p-1, 0x1.ae072bb789e88p-2, -0x1.19e67040861b7p-2, 0x1.7470a6e355b18p-3,
     -0x1.f12686e773292p-4, 0x1.4bed4121d4364p-4}, /* [139] 1.375 <= y <= 1.5 2^-6, degree 10, 59.5 bits */
    {0x1.45d44549ae2bep+3, -0x1.1fb48200f8479p-51, -0x1.11280004e292bp+2, 0x1.15c5c056f14a5p+1, -0x1.333edcc58e2c9p+0,
     0x1.615c6dfb8888p-1, -0x1.9fab10b692c95p-2, 0x1.f03439f724465p-3, -0x1.2b3ff6fcf0b36p-3, 0x1.6bb9604c4a4dp-4,
     -0x1.be5d617b27b22p-5, 0x1.122bfa18982bp-5}, /* [140] 1.5 <= y <= 1.625 2^-6, degree 10, 58.5 bits */
    {0x1.35c5a04b178eep+3, -0x1.77392fac17f5ep-51, -0x1.e370418e5bbe7p+1, 0x1.c7114121b8041p+0, -0x1.d2022e1f58dc9p-1,
     0x1.f036f646908dfp-2, -0x1.0e38e138155bcp-2, 0x1.2aabe7642830bp-3, -0x1.4d8cdb1f74b25p-4, 0x1.775ffa54ed776p-5,
     -0x1.aa4e2ccadf72fp-6, 0x1.e4e61cfa730dcp-7}, /* [141] 1.625 <= y <= 1.75 2^-6, degree 10, 60.5 bits */
    {0x1.277fff1ce34b7p+3, 0x1.fa0028338e9c8p-52, -0x1.af91d150d859ep+1, 0x1.7a203afba5554p+0, -0x1.687822710b9d5p-1,
     0x1.6556317504b21p-2, -0x1.6a541f46cd1c1p-3, 0x1.74d78eefe501bp-4, -0x1.83a7c9a989ddfp-5, 0x1.962afba71988p-6,
     -0x1.ad462d976335ep-7, 0x1.c697cab6c3e23p-8}, /* [142] 1.75 <= y <= 1.875 2^-6, degree 10, 59.9 bits */
    {0x1.1ab5e4f64ba3fp+3, -0x1.12c3a3c8985b1p-52, -0x1.84346e7ca7c2fp+1, 0x1.3e1b49e3af94cp+0, -0x1.1ba7c48917f7dp-1,
     0x1.0707bea1a3276p-2, -0x1.f2f8ae9ec1513p-4, 0x1.e04e763f0f56cp-5, -0x1.d32876e9f6361p-6, 0x1.c9e0def435a53p-7,
     -0x1.c48a8c4fd7363p-8, 0x1.c04e5d0b9c336p-9}, /* [143] 1.875 <= y <= 2 2^-6, degree 10, 59.1 bits */
    {0x1.09cdc746b7e9fp+3, 0x1.450254915a97cp-51, -0x1.4f424f983d59dp+2, 0x1.f4c7c8aee8716p+1, -0x1.9713e89138695p+1,
     0x1.5822eae5e1bcp+1, -0x1.2997ce7b2cf4p+1, 0x1.052bdf86a4385p+1, -0x1.cf30298835254p+0, 0x1.9dea82c1f7a62p+0,
     -0x1.77167a8449d29p+0, 0x1.52cc0f53a976cp+0}, /* [144] 1 <= y <= 1.125 2^-5, degree 10, 55.7 bits */
    {0x1.ed40c41549799p+2, 0x1.b7d47b1eee92ep-52, -0x1.1904bf6b18a7ep+2, 0x1.77676bce0f06p+1, -0x1.10fbaa6c69863p+1,
     0x1.9ce9c1ccd817bp+0, -0x1.3f740ef453dedp+0, 0x1.f5a837aac86ccp-1, -0x1.8e0086ada3e1ep-1, 0x1.3e367af348588p-1,
     -0x1.0195d2dcec66p-1, 0x1.a05404356be4ap-2}, /* [145] 1.125 <= y <= 1.25 2^-5, degree 10, 56.9 bits */
    {0x1.ccd09e454c1b4p+2, -0x1.30a4490ee4df7p-52, -0x1.df8b2b8ab661cp+1, 0x1.21ac8c2a17eaap+1, -0x1.7d172e4f4d651p+0,
     0x1.04bcc63cde13p+0, -0x1.6cfd3c1baec5ep-1, 0x1.0345cd0a962a8p-1, -0x1.74340fe0edb89p-2, 0x1.0d3beb75d1647p-2,
     -0x1.89e41e1499783p-3, 0x1.1ffddf5ef295ap-3}, /* [146] 1.25 <= y <= 1.375 2^-5, degree 10, 58.8 bits */
    {0x1.b0ef60e2759f8p+2, 0x1.9f1db16f5307fp-53, -0x1.9f239a90dc761p+1, 0x1.c9bd8abb0e57ap+0, -0x1.12ddde9097f3bp+0,
     0x1.57602eb6e1a7dp-1, -0x1.b6d6487c09cffp-2, 0x1.1c9b6a81e3ceep-2, -0x1.750746c60fb55p-3, 0x1.ecb75e2a60f18p-4,
     -0x1.48c8b13d45fe2p-4, 0x1.b6f4fb2e10dc9p-5}, /* [147] 1.375 <= y <= 1.5 2^-5, degree 10, 58.7 bits */
    {0x1.98a7050a2cb33p+2, 0x1.491ade90da584p-52, -0x1.6bc10b16e4415p+1, 0x1.70da1e581ac2p+0, -0x1.9779681138a82p-1,
     0x1.d443175155324p-2, -0x1.1343534c7a2edp-2, 0x1.4875f8c2ff834p-3, -0x1.8c0c9f02874a7p-4, 0x1.e141a8ecc41e1p-5,
     -0x1.273cfe9a0de01p-5, 0x1.6aa0409646138p-6}, /* [148] 1.5 <= y <= 1.625 2^-5, degree 10, 61.1 bits */
    {0x1.83440b1e2ae68p+2, -0x1.f2d5688e52f36p-52, -0x1.420100f49825bp+1, 0x1.2e37a740c393ep+0, -0x1.35153c61b2a2dp-1,
     0x1.48d93c8b8c1d5p-2, -0x1.65f4c9d0112e9p-3, 0x1.8b79793095197p-4, -0x1.b98317e810bd2p-5, 0x1.f0be1607a929p-6,
     -0x1.1a020ac62d12ap-6, 0x1.40b5a5f9ea57dp-7}, /* [149] 1.625 <= y <= 1.75 2^-5, degree 10, 58.6 bits */
    {0x1.7040154dfd2cbp+2, -0x1.870cdef49ee9ap-52, -0x1.1f8d8a19700b9p+1, 0x1.f65c4990a2492p-1, -0x1.de44be2b50854p-2,
     0x1.d9b6d7cdbb68cp-3, -0x1.e00cc4369c00bp-4, 0x1.edc341ff7f31bp-5, -0x1.009a3f7c6de39p-5, 0x1.0cc859a71ad6bp-6,
     -0x1.1c02284973477p-7, 0x1.2cb3b0efedd0dp-8}, /* [150] 1.75 <= y <= 1.875 2^-5, degree 10, 59.5 bits */
    {0x1.5f34576e17105p+2, 0x1.161a7e4a24c02p-55, -0x1.02be4fd51651bp+1, 0x1.a6b82a0b12246p-1, -0x1.786dce527d274p-2,
     0x1.5cc1f5e4288f5p-3, -0x1.4a9954f19d509p-4, 0x1.3e16b34a99a99p-5, -0x1.35459b5bde5d5p-6, 0x1.2f0ad4dd0ac01p-7,
     -0x1.2b7074b97844p-8, 0x1.289409472744dp-9}, /* [151] 1.875 <= y <= 2 2^-5, degree 10, 59.7 bits */
    {0x1.48a9866018c63p+2, 0x1.491c69e05bbf6p-52, -0x1.bf1e36f69a084p+1, 0x1.4cd7c8cf8ceddp+1, -0x1.0e300e7a201dbp+1,
     0x1.c86acfba418afp+0, -0x1.8a70dbe5abd31p+0, 0x1.5a00ed0a28506p+0, -0x1.32b4ced0ed315p+0, 0x1.11ffa4f8bee1dp+0,
     -0x1.f077a824440ecp-1, 0x1.c05705b90b67ap-1}, /* [152] 1 <= y <= 1.125 2^-4, degree 10, 55.6 bits */
    {0x1.2f143669b8afcp+2, 0x1.6485831f73a5cp-55, -0x1.77008e3594924p+1, 0x1.f339f0320a123p+0, -0x1.6a80bf21e64cap+0,
     0x1.11e80c9443d9fp+0, -0x1.a78acd8a85345p-1, 0x1.4c64adfee477cp-1, -0x1.079c44c15ddap-1, 0x1.a564fb271c5fdp-2,
     -0x1.5504c3bf9f87ep-2, 0x1.13877812c7ee7p-2}, /* [153] 1.125 <= y <= 1.25 2^-4, degree 10, 56.9 bits */
    {0x1.196dfe8fa34a5p+2, 0x1.b42e6a7b6bb86p-52, -0x1.402405c7d52efp+1, 0x1.815d4ad88fc52p+0, -0x1.fa3bcffb9084ep-1,
     0x1.5a06edf9094d5p-1, -0x1.e40d2ae8fcacfp-2, 0x1.57ac451ed1a5bp-2, -0x1.ed2a947c3b22ep-3, 0x1.649da8accf4b1p-3,
     -0x1.04cb3b968f05p-3, 0x1.7d44c272b5af9p-4}, /* [154] 1.25 <= y <= 1.375 2^-4, degree 10, 58.4 bits */
    {0x1.06cff43ad2c8ap+2, 0x1.44cf9e48230e8p-53, -0x1.154b2249c591bp+1, 0x1.3094dd14443c8p+0, -0x1.6d3e69c7c0eacp-1,
     0x1.c7d428a5575bcp-2, -0x1.231267326beap-2, 0x1.7958febb4dd2dp-3, -0x1.ee5fb49b1aa5dp-4, 0x1.4662ef2b945a9p-4,
     -0x1.b376944c59efdp-5, 0x1.229f2c01e5754p-5}, /* [155] 1.375 <= y <= 1.5 2^-4, degree 10, 57.9 bits */
    {0x1.ed2d52704acddp+1, 0x1.59b1026ac7a39p-56, -0x1.e6315287fee1p+0, 0x1.eb07e5c172741p-1, -0x1.0ecec2673f201p-1,
     0x1.36e4603abe7b6p-2, -0x1.6d3eb8c54b77ep-3, 0x1.b397f56af44e4p-4, -0x1.067fdea384bd7p-4, 0x1.3edc8832df185p-5,
     -0x1.871c30d78efecp-6, 0x1.e04295fc8f21ep-7}, /* [156] 1.5 <= y <= 1.625 2^-4, degree 10, 61.0 bits */
    {0x1.d095aea059a1cp+1, 0x1.161d649e69c12p-54, -0x1.ae9ad45a26797p+0, 0x1.9272aba575e96p-1, -0x1.9af329ff1fb35p-2,
     0x1.b4c6c101c9d0fp-3, -0x1.db15892118b89p-4, 0x1.064a88058bb63p-4, -0x1.24b18c9980e9fp-5, 0x1.492ff1ca6272ep-6,
     -0x1.75a7736d8a532p-7, 0x1.a8d290f5d3a5ep-8}, /* [157] 1.625 <= y <= 1.75 2^-4, degree 10, 59.5 bits */
    {0x1.b7265dd38aecap+1, -0x1.2fb1b8a93f41p-54, -0x1.80b8b837cad5dp+0, 0x1.4e94cd3e88b07p-1, -0x1.3e087cea45c23p-2,
     0x1.3aabc498570a3p-3, -0x1.3ea319e003b6bp-4, 0x1.478c8fe26aaa6p-5, -0x1.544a31e98cdf9p-6, 0x1.644edbe709dd3p-7,
     -0x1.785f71af7c9cbp-8, 0x1.8e63769d618b7p-9}, /* [158] 1.75 <= y <= 1.875 2^-4, degree 10, 58.7 bits */
    {0x1.a056ae8aa7559p+1, 0x1.ada3badc141f4p-56, -0x1.5a57541889dfcp+0, 0x1.199dad057e6ecp-1, -0x1.f4c1255327069p-3,
     0x1.cf715debd5036p-4, -0x1.b6f8c1ce15f1fp-5, 0x1.a61c158aee225p-6, -0x1.9a3742528db05p-7, 0x1.91cc2922a7652p-8,
     -0x1.8ce4273bf3f7ep-9, 0x1.88fd991585585p-10}, /* [159] 1.875 <= y <= 2 2^-4, degree 10, 60.6 bits */
    {0x1.8227869592c33p+1, -0x1.2b0c9a413a456p-54, -0x1.2b73e03acc0eap+1, 0x1.bba68a003eb7dp+0, -0x1.678e08d38d786p+0,
     0x1.2f5a983c7aa57p+0, -0x1.05f3ccd185396p+0, 0x1.cb49a88ae2413p-1, -0x1.96ecddc33c572p-1, 0x1.6b6261cfa33d8p-1,
     -0x1.491a1e7bb14cp-1, 0x1.291d1d1e56eabp-1}, /* [160] 1 <= y <= 1.125 2^-3, degree 10, 55.3 bits */
    {0x1.5fdf02d964837p+1, -0x1.fee7fcc43d41fp-55, -0x1.f6c26563021d9p+0, 0x1.4cde41dadd576p+0, -0x1.e29f043d6dc2cp-1,
     0x1.6c40134be02a3p-1, -0x1.196358050f469p-1, 0x1.b961edda89c24p-2, -0x1.5dde51bbdbbe8p-2, 0x1.17863198af4a3p-2,
     -0x1.c4418e4f6c07bp-3, 0x1.6d4b79644be4dp-3}, /* [161] 1.125 <= y <= 1.25 2^-3, degree 10, 56.7 bits */
    {0x1.42d57601f41b5p+1, -0x1.8d499232d4e83p-54, -0x1.ad95a3b242558p+0, 0x1.010ec3f6f925fp+0, -0x1.51212a4f83655p-1,
     0x1.cc55fa53816cdp-2, -0x1.41b466db5302bp-2, 0x1.c8843005f0fe1p-3, -0x1.47601d8c42d6p-3, 0x1.d9413d24407a6p-4,
     -0x1.59f6faf479b6dp-4, 0x1.f9a05e8d78d38p-5}, /* [162] 1.25 <= y <= 1.375 2^-3, degree 10, 58.3 bits */
    {0x1.29d763f43df2bp+1, -0x1.8445292fb3435p-53, -0x1.746944eedd2e1p+0, 0x1.967fe0f93749cp-1, -0x1.e6a97ed546abfp-2,
     0x1.2f505983d9384p-2, -0x1.83074ea265f57p-3, 0x1.f5688c63fb3fp-4, -0x1.4846e0c42fa1bp-4, 0x1.b14395e03c9c8p-5,
     -0x1.20eb6270aa59cp-5, 0x1.8184355d2d16bp-6}, /* [163] 1.375 <= y <= 1.5 2^-3, degree 10, 58.1 bits */
    {0x1.140b16cd24c46p+1, -0x1.db8bd1aa70b86p-53, -0x1.46c364296e0f7p+0, 0x1.47c8c6484185fp-1, -0x1.68f6d6a0f0758p-2,
     0x1.9de1ba29b6b0ep-3, -0x1.e5cefae0f47dap-4, 0x1.217d3cb8b9e59p-4, -0x1.5cb67e73e5ff5p-5, 0x1.a7641e906e381p-6,
     -0x1.038f87077ee9cp-6, 0x1.3e9e649df0d36p-7}, /* [164] 1.5 <= y <= 1.625 2^-3, degree 10, 58.7 bits */
    {0x1.00d19b82acec7p+1, 0x1.f6987ebd39dcp-55, -0x1.21a66ceed50fcp+0, 0x1.0cbcd4a9d2c62p-1, -0x1.11f9bcd81c649p-2,
     0x1.22d3725722213p-3, -0x1.3c0c0cac401fcp-4, 0x1.5cbaaf6b31053p-5, -0x1.84edf1bf4108p-6, 0x1.b53741ca5e60cp-7,
     -0x1.f0137c5d8e5bdp-8, 0x1.19e86134d278p-8}, /* [165] 1.625 <= y <= 1.75 2^-3, degree 10, 57.8 bits */
    {0x1.df67c48aa3407p+0, 0x1.b507c023f617fp-54, -0x1.0301be01cfc2ap+0, 0x1.bef815668d101p-2, -0x1.a83269f71292dp-3,
     0x1.a32b958c05eacp-4, -0x1.a81054f889d64p-5, 0x1.b39c5e9a7aaffp-6, -0x1.c44ac8434df5fp-7, 0x1.d95aa9be60e68p-8,
     -0x1.f3ce0ba004c6ep-9, 0x1.086d5e0a90c59p-9}, /* [166] 1.75 <= y <= 1.875 2^-3, degree 10, 58.2 bits */
    {0x1.c0ad8bfcd470dp+0, -0x1.8835bc6d1f768p-55, -0x1.d2bbf628082c2p-1, 0x1.78500115a0638p-2, -0x1.4e0f97595deep-3,
     0x1.34c2e19c2f334p-4, -0x1.242f87091c646p-5, 0x1.18c19c81f2014p-6, -0x1.10af194e535f3p-7, 0x1.0af4e2668af49p-8,
     -0x1.0796152ae29e5p-9, 0x1.04e6db64f6e7bp-10}, /* [167] 1.875 <= y <= 2 2^-3, degree 10, 59.0 bits */
    {0x1.97f9c582e2ec6p+0, 0x1.56252ac6a32b7p-54, -0x1.94116c136ad42p+0, 0x1.288564838a145p+0, -0x1.dff14f7a55c9bp-1,
     0x1.945eb1cd8a1eap-1, -0x1.5cda0b3e85fe2p-1, 0x1.319885769d051p-1, -0x1.0e975d3f088bcp-1, 0x1.e3081c32eac76p-2,
     -0x1.b5456d6868cf5p-2, 0x1.8a9f65e8fbaf7p-2}, /* [168] 1 <= y <= 1.125 2^-2, degree 10, 55.1 bits */
    {0x1.69ad19bf69f77p+0, -0x1.a5403c4bae285p-54, -0x1.53cb8694816cdp+0, 0x1.bd20c871c9802p-1, -0x1.4249a724c48ap-1,
     0x1.e5c7cf26f5062p-2, -0x1.76e9996387293p-2, 0x1.25d08a5569473p-2, -0x1.d180b4141b194p-3, 0x1.73b710a3d26f2p-3,
     -0x1.2c92bd4bcebfdp-3, 0x1.e55e9c347cdfap-4}, /* [169] 1.125 <= y <= 1.25 2^-2, degree 10, 56.3 bits */
    {0x1.4264447424618p+0, 0x1.ae8ccd3116113p-60, -0x1.22dc77bcc29a6p+0, 0x1.57da21539a4b4p-1, -0x1.c2804abb344bdp-2,
     0x1.3318ef5daa6e2p-2, -0x1.acd135b1f64dap-3, 0x1.3003dab924af6p-3, -0x1.b3c03137b92p-4, 0x1.3acad240beaadp-4,
     -0x1.cc08ef6ac54dbp-5, 0x1.500966c4f9744p-5}, /* [170] 1.25 <= y <= 1.375 2^-2, degree 10, 58.3 bits */
    {0x1.2084839d9385bp+0, 0x1.b76aa2b2386f4p-54, -0x1.f93c96a7ddeb8p-1, 0x1.0fee80c8be886p-1, -0x1.45541d8e64d7fp-2,
     0x1.94da20577df12p-3, -0x1.020d30e71a945p-3, 0x1.4e0a0bfc5e5ffp-4, -0x1.b51d50e8828a9p-5, 0x1.204bbee8ee792p-5,
     -0x1.8050d292e28fp-6, 0x1.004ca66d300acp-6}, /* [171] 1.375 <= y <= 1.5 2^-2, degree 10, 58.2 bits */
    {0x1.02eadab51c447p+0, 0x1.0a37a3f40ef43p-55, -0x1.bc28e1c02df09p-1, 0x1.b698c669452a7p-2, -0x1.e2da0da2217d3p-3,
     0x1.1450b0f942c67p-3, -0x1.440a2c339dd67p-4, 0x1.81daa735cd35ap-5, -0x1.d07d6237b648dp-6, 0x1.19d255080237fp-6,
     -0x1.596085e9ef92ap-7, 0x1.a7c8c4c490a95p-8}, /* [172] 1.5 <= y <= 1.625 2^-2, degree 10, 60.4 bits */
    {0x1.d185755903d4fp-1, -0x1.130aaccbe5517p-56, -0x1.8a7fcd24ffb56p-1, 0x1.67978406e4ef1p-2, -0x1.6eaf0dc93112fp-3,
     0x1.847139527fa12p-4, -0x1.a5c5fd6daa2bep-5, 0x1.d0f779cade5f7p-6, -0x1.031dc4358c213p-6, 0x1.231da7d3859dp-7,
     -0x1.4a25db0379013p-8, 0x1.7711af228f074p-9}, /* [173] 1.625 <= y <= 1.75 2^-2, degree 10, 61.1 bits */
    {0x1.a2d9ac69d2936p-1, -0x1.866b1ff4d183ep-55, -0x1.617f691e47df3p-1, 0x1.2b028dba9a263p-2, -0x1.1c06ee6baeb7p-3,
     0x1.1801535ccc48p-4, -0x1.1b1199a149e54p-5, 0x1.227d80332cf7cp-6, -0x1.2d6d9422e8ba2p-7, 0x1.3b455abca7aa2p-8,
     -0x1.4cba8edb5a75cp-9, 0x1.5fe953b4bd633p-10}, /* [174] 1.75 <= y <= 1.875 2^-2, degree 10, 59.9 bits */
    {0x1.78de5245c1c69p-1, -0x1.c1e46e234e7d2p-56, -0x1.3f324df18c0e2p-1, 0x1.f75feefe297d6p-3, -0x1.bf9eed7099887p-4,
     0x1.9c95a49071544p-5, -0x1.863a58c2d7e1dp-6, 0x1.768bbafd2a0bap-7, -0x1.6b9356845fde5p-8, 0x1.63b351f30d594p-9,
     -0x1.5f0ce5e47419cp-10, 0x1.5b4f8fc1e132ap-11} /* [175] 1.875 <= y <= 2 2^-2, degree 10, 58.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_beta_zero_force)

/* h*^5 as two doubles: eps = h*^5 beta^-5 at zero overlap, exact in double precision from beta = 7
 * on. Proved. */
COR_INLINE const double *cor_rows_h_star_5(int i)
{
    static const double row[1][2] = {
    {0x1.4a22ed0407533p+2, -0x1.86cf183f4083p-53} /* h*^5, and what that double lacks */
    };
    return row[i];
}

/* u = ln(beta) >= 10: a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3),
 * mu = beta^(-5/3), through nine enclosed collisions with u = 9.5 ... 13.5.
 * Relative error, proved for every finite double: below 2^-64.9. */
COR_INLINE const double *cor_rows_far_eps_zero_force(int i)
{
    static const double row[1][11] = {
    {0x1.4f747439b348ap+0, 0x1.d8e054c4a03e9p-54, 0x1.f39489511c756p-75, -0x1.c16bd4dd4ccebp-129, 0x1.15890b886286bp+1,
     -0x1.e869522d13029p+1, 0x1.a190f812a719cp-42, 0x1.6b8fad17ab1ep+2, -0x1.6fe5671f9ffeap+3, 0x1.63a407eb710d4p+1,
     -0x1.82174e9fa2b65p-16} /* eps beta^(5/3) at zero force */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_duration_zero_overlap(int i)
{
    static const double row[1][11] = {
    {-0x1.975430d1b4c57p+0, 0x1.bf7a08d7b296bp-54, 0x1.aaaaaaaaaaaabp+1, -0x1.555555189c73fp-53, 0x1.f72eae568df97p+1,
     -0x1.4332717d8e98dp-42, 0x1.89b0af7fb84f1p-47, 0x1.3bb99a78a3fd3p+1, -0x1.5d06d937da87fp-13, 0x1.2168f3ba9b7dcp-16,
     -0x1.4500d3a68daf8p-21} /* duration/beta at zero overlap */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_duration_zero_force(int i)
{
    static const double row[1][11] = {
    {0x1.0efc91e66f1p-1, -0x1.8993ea8f69f2bp-56, 0x1.74ba48401c89ap+1, -0x1.3a78e07c66649p-54, -0x1.7658661de9c85p-3,
     0x1.6813e00be249ap+0, 0x1.0f56f4c3c0dfp+1, 0x1.60849fa6864d1p+2, -0x1.6a6ba7c8d085bp+2, 0x1.ae92b83bd6dbep+2,
     0x1.07275ebb16c0ep+1} /* duration beta^(2/3) at zero force */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_max_overlap(int i)
{
    static const double row[1][11] = {
    {0x1.4f747439b348ap+0, 0x1.d8e14748dda3cp-54, -0x1.7ddbc4ce4d59dp-80, 0x1.720e471966d17p-134, 0x1.2da16d6370f13p+0,
     -0x1.e869522d0d76p+0, -0x1.ce23cfacdde25p-48, 0x1.b09c3fda75f71p+1, -0x1.76e687f39c356p+2, 0x1.638efcca052fep-1,
     -0x1.223b8b594a7fdp-23} /* largest overlap beta^(2/3) */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_far_time_of_max_overlap(int i)
{
    static const double row[1][11] = {
    {0x1.a5121cd00a446p-2, 0x1.90581a2e7fd1bp-57, 0x1.74ba48401c89ap+0, -0x1.3a7c17437a6d2p-55, -0x1.fae5a14a4d122p-3,
     0x1.40d6c011dd32fp+0, 0x1.0f56f4c3b9bfbp-1, 0x1.d132219cacd62p+0, -0x1.fb74f5ca6af73p-1, 0x1.275d550adae55p+1,
     0x1.07271f15bdd3dp-2} /* time of the largest overlap beta^(2/3) */
    };
    return row[i];
}

/* eps < 2^-23 at zero force: beta = (a/eps)^(3/5) (1 + e (b_0 + b_1 v + b_2 v^2) + e^2 (c_0 + ... +
 * c_4 v^4)), e = eps/a, v = -(3/5) ln(e), from the coefficients of far_eps_zero_force by formal
 * inversion. Columns a, a', b_0, ..., c_4.
 * Relative error, proved for every finite double: below 2^-55.7. */
COR_INLINE const double *cor_rows_far_beta_zero_force(int i)
{
    static const double row[1][10] = {
    {0x1.4f747439b348ap+0, 0x1.d8e054c4a03e9p-54, 0x1.fc515db6323cp-1, -0x1.bf45f04cf3f63p+0, 0x1.7e652fb4bfdcdp-43,
     -0x1.1ad739e53efe5p+0, 0x1.2e832a79ce2a4p+2, -0x1.354ec6eaa7b9dp+2, -0x1.6192332b13f84p-17, -0x1.1d99112f0d0d2p-84}
     /* beta at zero force */
    };
    return row[i];
}

#endif
