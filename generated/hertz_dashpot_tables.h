/* SPDX-License-Identifier: MIT */
/* Hertz's contact with a constant dashpot, x'' + beta x' + x^(3/2) = 0, x(0) = 0, x'(0) = 1,
 * both ends of contact, for every beta. Evaluated by runtime/core/law_eval.h. Source: docs/derivation.md, 9;
 * form: docs/header-format.md.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check
 *
 * Each double is the one nearest to its coefficient: proved; corgen tables --digits prints 25 digits of
 * each. In the functions
 * eps, loss and largest overlap are within 1 unit of the last place, times and inverse within 2: sampled against
 * enclosed collisions (tests/law/run, tests/table). The interpolants behind the rows go through collisions enclosed
 * to 80 bits (proved); between them they are off by 8.0e-20 at most (sampled). Errors of the rows stand above each
 * table and beside each row (sampled). */
#ifndef COR_GENERATED_HERTZ_DASHPOT_TABLES_H
#define COR_GENERATED_HERTZ_DASHPOT_TABLES_H

#include "runtime/core/law_eval.h"
#include "runtime/core/rows.h"

/* A row: value = c_0 + (c_0' + t (c_1 + c_2 t + ... + c_n t^(n-1))), t = y - node, in columns c_0,
 * c_0', c_1, ..., c_n. c_0' is the remainder of c_0 at the node. */

/* (1 - eps)/beta at zero overlap, beta < 1/8: 3 rows of degree 10 in y = beta, nodes 0 + i 0.0625, 0 <= y <= 0.15625.
 * Relative error of the approximation: 2^-59.8 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_OVERLAP_ROWS 3
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_OVERLAP_END 0.125
COR_ROWS(double, cor_rows_hertz_dashpot_near_loss_zero_overlap, 3, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.c9ae3p+0, 0x1.10b72bf79765dp-28, -0x1.474c8c0db13a4p+0, 0x1.607041d9fd3c2p-1, -0x1.51a8668daa3cbp-2,
     0x1.0639b7446f5aap-3, -0x1.728222d886de4p-5, 0x1.7505d6ab77a4bp-7, -0x1.64aa93fb7f0f4p-9, -0x1.aa5e0bfebc2bbp-13,
     0x1.898ab6a86529cp-21, -0x1.c8099300702c2p-13}, /* [0] 0 <= y <= 0.03125, degree 10, 60.7 bits */
    {0x1.b5e479p+0, -0x1.fa828d59d03a4p-28, -0x1.323acd40b99a8p+0, 0x1.4243ab508ef3ap-1, -0x1.32a2225912a9dp-2,
     0x1.d531e75fa2984p-4, -0x1.5163a669ec3e8p-5, 0x1.4d42d9e92778fp-7, -0x1.72d47c8c5afa2p-9, -0x1.fcd572ab70771p-13,
     -0x1.335b9531114acp-13, -0x1.1981930e38d35p-12}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 60.4 bits */
    {0x1.a35d4p+0, 0x1.99a87d13636b6p-30, -0x1.1ef56b2090149p+0, 0x1.26d77bd284f59p-1, -0x1.16e8222a0c476p-2,
     0x1.a2d18df6073dep-4, -0x1.3413c962fceaep-5, 0x1.23b41ce266a98p-7, -0x1.868ce0f9e64b8p-9, -0x1.8c5282e23aac9p-12,
     -0x1.6ce63cc1c31ccp-12, -0x1.98957c5cd633ap-12} /* [2] 0.09375 <= y <= 0.15625, degree 10, 59.8 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_loss_zero_overlap)

/* eps at zero overlap, 2^-3 <= beta < 0.627988: 37 rows of degree 10 in y = beta 2^-k, 16 to each octave k = -3 ... -1.
 * Relative error of the approximation: 2^-58.2 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_OVERLAP_FIRST 0.125
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_OVERLAP_FIRST_OCTAVE (-3)
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_OVERLAP_OCTAVE_BITS 4
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_OVERLAP_ROWS 37
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_OVERLAP_END 0.6279881355201693
COR_ROWS(double, cor_rows_hertz_dashpot_middle_eps_zero_overlap, 37, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.942bcad424325p-1, -0x1.694eb5c5d4894p-58, -0x1.7d6721cfaf671p-3, 0x1.0ae963ae12493p-6, -0x1.13574883ba013p-10,
     0x1.07e050b155a21p-14, -0x1.8c1249de637d6p-19, 0x1.290fc082174dp-23, -0x1.14652694ae2d3p-28, 0x1.903cc6c7d5abp-33,
     0x1.70530553b8c65p-36, -0x1.cc686d50724a2p-32}, /* [0] 1 <= y <= 1.0625 2^-3, degree 10, 63.3 bits */
    {0x1.8e3e7d058178p-1, 0x1.812e739ea3554p-55, -0x1.7941e8155d179p-3, 0x1.07b58562be226p-6, -0x1.0f3f780b30001p-10,
     0x1.040acd8a07697p-14, -0x1.85272b9c2ba41p-19, 0x1.25535224b1f66p-23, -0x1.0e211eb9ac68bp-28,
     0x1.92f06c238016fp-33, 0x1.e8a4e20f69178p-39, -0x1.0796db1682bdep-40},
     /* [1] 1.0625 <= y <= 1.125 2^-3, degree 10, 62.3 bits */
    {0x1.8861aa9f759fap-1, 0x1.115915dae1039p-56, -0x1.75296563dedd7p-3, 0x1.048dd7aa3c60cp-6, -0x1.0b36db2cd1521p-10,
     0x1.00467a6014783p-14, -0x1.7e5235f2df6b8p-19, 0x1.21acece6e6288p-23, -0x1.07cc9975727f6p-28,
     0x1.976a7a7da6127p-33, 0x1.0b2734d8ecc1dp-38, 0x1.4a59b0897c185p-42},
     /* [2] 1.125 <= y <= 1.1875 2^-3, degree 10, 62.0 bits */
    {0x1.82952126e8dbbp-1, 0x1.ee34eedfaaeb7p-55, -0x1.711d695395fa7p-3, 0x1.01722d50704d2p-6, -0x1.073d2d9696925p-10,
     0x1.f92640e7b9fb2p-15, -0x1.7792e3f14eaffp-19, 0x1.1e1ccfd66ed0ep-23, -0x1.016557e948fb6p-28,
     0x1.9c4654ad3382fp-33, 0x1.1fa88ed9998dp-38, 0x1.2244cc44ba39ep-41},
     /* [3] 1.1875 <= y <= 1.25 2^-3, degree 10, 60.8 bits */
    {0x1.7cd8aee0fa59dp-1, -0x1.6de90f0c8fd85p-55, -0x1.6d1dc4301bea6p-3, 0x1.fcc4b3d9dac69p-7, -0x1.03522bcedba16p-10,
     0x1.f1e114a8043b8p-15, -0x1.70e8af1c92139p-19, 0x1.1aa33f157fc0cp-23, -0x1.f5d3beea974bcp-29,
     0x1.a1868f5226ed8p-33, 0x1.3625cc63e5659p-38, 0x1.35e2075b60fdfp-41},
     /* [4] 1.25 <= y <= 1.3125 2^-3, degree 10, 60.9 bits */
    {0x1.772c22d039b83p-1, -0x1.4b2a5fdb78a84p-56, -0x1.692a46f518aa6p-3, 0x1.f6bc63c0ec0b5p-7, -0x1.feeb265e3d7c7p-11,
     0x1.eabd07c2c8e51p-15, -0x1.6a530f50fd554p-19, 0x1.1740842e8c03p-23, -0x1.e8b1276c4fec2p-29, 0x1.a7321b25b8392p-33,
     0x1.4f2a181525cfp-38, 0x1.46b600c2fee86p-41}, /* [5] 1.3125 <= y <= 1.375 2^-3, degree 10, 62.7 bits */
    {0x1.718f4cb1ed0efp-1, -0x1.bf3cece9fe875p-55, -0x1.6542c34b22e51p-3, 0x1.f0cb14a514181p-7, -0x1.f74e43bd5e0a9p-11,
     0x1.e3b9b4a6e7631p-15, -0x1.63d17aa04732fp-19, 0x1.13f4ee8bb9886p-23, -0x1.db5f68c41780fp-29,
     0x1.ad51c2f355c5dp-33, 0x1.6a18d1d0d4e88p-38, 0x1.6a6971875139p-41},
     /* [6] 1.375 <= y <= 1.4375 2^-3, degree 10, 60.9 bits */
    {0x1.6c01fcfb63649p-1, -0x1.70353d6b288dbp-55, -0x1.61670b84a9c55p-3, 0x1.eaf0725e0ac33p-7, -0x1.efcd2d9a92064p-11,
     0x1.dcd6b879ad02ep-15, -0x1.5d63652ccd44bp-19, 0x1.10c0d3f5d14a1p-23, -0x1.cddab8cd4cd4ep-29,
     0x1.b3f00e2e2a496p-33, 0x1.8739819e3f6ap-38, 0x1.81a157e55ee08p-41},
     /* [7] 1.4375 <= y <= 1.5 2^-3, degree 10, 60.5 bits */
    {0x1.668404d75368dp-1, -0x1.24ff427ae970dp-55, -0x1.5d96f29ae82d3p-3, 0x1.e52c2a479dd3p-7, -0x1.e867635b3fd58p-11,
     0x1.d613b320e3e19p-15, -0x1.57084101c1b8bp-19, 0x1.0da4911f3ac07p-23, -0x1.c01efd132e68dp-29,
     0x1.bb16ad47e1152p-33, 0x1.a6ed5e6bb63c8p-38, 0x1.a71db5e56020dp-41},
     /* [8] 1.5 <= y <= 1.5625 2^-3, degree 10, 61.1 bits */
    {0x1.61153623465p-1, 0x1.602a2c069dda4p-57, -0x1.59d24c2ae1113p-3, 0x1.df7deb3d2fcedp-7, -0x1.e11c65dfa3c37p-11,
     0x1.cf70474db1302p-15, -0x1.50bf7de80b9d1p-19, 0x1.0aa08a334d96ap-23, -0x1.b227c27e44251p-29, 0x1.c2d16004c58p-33,
     0x1.c8e10573ab8b5p-38, 0x1.c5168f9563ed6p-41}, /* [9] 1.5625 <= y <= 1.625 2^-3, degree 10, 60.5 bits */
    {0x1.5bb5636d0eab4p-1, 0x1.5009ed8104b38p-55, -0x1.5618ec7264b3fp-3, 0x1.d9e565955857cp-7, -0x1.d9ebb7778b64ap-11,
     0x1.c8ec1a8853dc2p-15, -0x1.4a888937940d9p-19, 0x1.07b52b7511c75p-23, -0x1.a3f03c5d00447p-29,
     0x1.cb2c60707003ap-33, 0x1.ee3d47b348eacp-38, 0x1.deaad62461ddep-41},
     /* [10] 1.625 <= y <= 1.6875 2^-3, degree 10, 61.1 bits */
    {0x1.56645ff04b1a6p-1, -0x1.192864e4644b3p-56, -0x1.526aa84d1e7f1p-3, 0x1.d4624b1da698dp-7, -0x1.d2d4dbd6e021p-11,
     0x1.c286d53cd615p-15, -0x1.4462cda4c99c7p-19, 0x1.04e2e9e7974c2p-23, -0x1.95733ce3f6bb3p-29, 0x1.d4311ac2eed51p-33,
     0x1.0ceaae0279aa8p-37, 0x1.05201a03419e1p-39}, /* [11] 1.6875 <= y <= 1.75 2^-3, degree 10, 64.5 bits */
    {0x1.5121ff93f4b58p-1, -0x1.ee47b312b2d2p-56, -0x1.4ec75531ab35p-3, 0x1.cef44f168664fp-7, -0x1.cbd75809fcf1ap-11,
     0x1.bc4022c8c562bp-15, -0x1.3e4db309a414ep-19, 0x1.022a44282ef81p-23, -0x1.86b4169a215b9p-29,
     0x1.d99efe9f77cbap-33, 0x1.0fec771deeb32p-33, 0x1.2fab9103c48f8p-30},
     /* [12] 1.75 <= y <= 1.8125 2^-3, degree 10, 64.5 bits */
    {0x1.4bee16e7f90dfp-1, 0x1.4f33245a9525p-55, -0x1.4b2ec92eb7353p-3, 0x1.c99b262f48a87p-7, -0x1.c4f2b269cb0dbp-11,
     0x1.b617b18a06c2ep-15, -0x1.38489e2c9b417p-19, 0x1.ff1784f19ff7ep-24, -0x1.7791bb4627f04p-29,
     0x1.e881e27ad813dp-33, 0x1.31da39ad58521p-37, 0x1.d0d7cb359341fp-39},
     /* [13] 1.8125 <= y <= 1.875 2^-3, degree 10, 61.4 bits */
    {0x1.46c87b22dfa64p-1, -0x1.da1ff201cde6p-56, -0x1.47a0dae8248b8p-3, 0x1.c45686824fdfcp-7, -0x1.be26728fa0e99p-11,
     0x1.b00d32eedd453p-15, -0x1.3252f07ce45e8p-19, 0x1.fa0ff210f95c1p-24, -0x1.6820b29992833p-29,
     0x1.f3e84baa8ba6ap-33, 0x1.50faf58467954p-37, 0x1.48de7d54904c2p-40},
     /* [14] 1.875 <= y <= 1.9375 2^-3, degree 10, 60.6 bits */
    {0x1.41b1021f7ac28p-1, 0x1.09a5358192f8ep-56, -0x1.441d61943881dp-3, 0x1.bf2627916153fp-7, -0x1.b7722148de8c3p-11,
     0x1.aa205b873c956p-15, -0x1.2c6c07d18a71fp-19, 0x1.f53f0eb2a6be9p-24, -0x1.5850cdbb3f268p-29,
     0x1.001cf95b6baeep-32, 0x1.6c41e6ca22f75p-37, 0x1.6a3b80cc52615p-40},
     /* [15] 1.9375 <= y <= 2 2^-3, degree 10, 60.6 bits */
    {0x1.3a27f3227261p-1, -0x1.1e84cefdac81dp-55, -0x1.3eeb6f04b8242p-2, 0x1.b782f75f51b81p-5, -0x1.ad8f84c810e48p-8,
     0x1.a17414cf3defdp-11, -0x1.23abefd6e9ef6p-14, 0x1.ee6f3d4dd7b65p-18, -0x1.3fd63bb0b5c07p-22,
     0x1.0a4c74f0dd90dp-24, 0x1.9949cba38c7cdp-28, 0x1.97275642de697p-30},
     /* [16] 1 <= y <= 1.0625 2^-2, degree 10, 60.5 bits */
    {0x1.304bda8f9e21dp-1, -0x1.a019eff219af6p-55, -0x1.3821520d5e7f3p-2, 0x1.ad9862e5cfb8ep-5, -0x1.a0b0dd2789e92p-8,
     0x1.9648f95270e6fp-11, -0x1.182ea4b7b260ap-14, 0x1.e62711c728218p-18, -0x1.1d9a13f8fafd8p-22,
     0x1.19dd39fc75092p-24, 0x1.de21f60b2c599p-28, 0x1.dc18402943ccp-30},
     /* [17] 1.0625 <= y <= 1.125 2^-2, degree 10, 59.2 bits */
    {0x1.26a575d44cff6p-1, 0x1.a32391df0b3b8p-56, -0x1.317e4659deb01p-2, 0x1.a3f9fde2d984ep-5, -0x1.9429c552c93d6p-8,
     0x1.8b8fd3cf5814cp-11, -0x1.0ce02d83d2309p-14, 0x1.ded5b8adec5bep-18, -0x1.f285fed68dffbp-23,
     0x1.2c0ce0c4aa9e4p-24, 0x1.175d167d0785dp-27, 0x1.16e48e23e3df3p-29},
     /* [18] 1.125 <= y <= 1.1875 2^-2, degree 10, 59.9 bits */
    {0x1.1d33911e8200fp-1, -0x1.074bd6863fb94p-59, -0x1.2b011f38eb9a4p-2, 0x1.9aa5c5988ac35p-5, -0x1.87f6b49ccc1e4p-8,
     0x1.8146ed84b2ccp-11, -0x1.01ba92b4564aap-14, 0x1.d88b2416e84bdp-18, -0x1.a4ec450209893p-23, 0x1.414e9f7f652f8p-24,
     0x1.469fc5ee38552p-27, 0x1.476cd0da9e0c1p-29}, /* [19] 1.1875 <= y <= 1.25 2^-2, degree 10, 64.0 bits */
    {0x1.13f501e20f632p-1, 0x1.c89cbb6122a5ep-55, -0x1.24a8b7d9fc8b6p-2, 0x1.9199cc55d01ebp-5, -0x1.7c142f1abdc27p-8,
     0x1.776ccd54c1344p-11, -0x1.ed6eea7112295p-15, 0x1.d359f77f4f78bp-18, -0x1.5191d8521c15bp-23,
     0x1.5a2b4f4b16fe9p-24, 0x1.7e2c13ae08c66p-27, 0x1.814acc156a572p-29},
     /* [20] 1.25 <= y <= 1.3125 2^-2, degree 10, 60.1 bits */
    {0x1.0ae8a69adfb97p-1, -0x1.f169279c44f7ap-56, -0x1.1e73f2f9ab3b3p-2, 0x1.88d4392fc32ep-5, -0x1.707ec3a5cd779p-8,
     0x1.6e003c25ed05dp-11, -0x1.d79ff9df69279p-15, 0x1.cf57ffe214329p-18, -0x1.eef861f5031dbp-24,
     0x1.7746253c08071p-24, 0x1.bf9fe4eb43ddap-27, 0x1.c692ee62c6d9fp-29},
     /* [21] 1.3125 <= y <= 1.375 2^-2, degree 10, 59.1 bits */
    {0x1.020d6691d7f58p-1, 0x1.eb053f236622cp-55, -0x1.1861ba8f13e0ap-2, 0x1.805347c76a1d4p-5, -0x1.653309b71b44ap-8,
     0x1.65004a019f3d1p-11, -0x1.c1f9881e7f8e3p-15, 0x1.cc9ec2f3b1416p-18, -0x1.2b082a8015bf8p-24,
     0x1.996291478b58fp-24, 0x1.067af7a6196b4p-26, 0x1.0cf0e99730a93p-28},
     /* [22] 1.375 <= y <= 1.4375 2^-2, degree 10, 59.6 bits */
    {0x1.f2c4634896212p-2, -0x1.929c70f635262p-56, -0x1.1270ff7a03ec7p-2, 0x1.7815481cd1638p-5, -0x1.5a2d9f1746fd4p-8,
     0x1.5c6c5412ee834p-11, -0x1.ac6b7db6ad3c3p-15, 0x1.cb4c2aad17b8ap-18, -0x1.52654702e6901p-26,
     0x1.c16b93b95b5edp-24, 0x1.344e84ecc3276p-26, 0x1.3f37bff138f5fp-28},
     /* [23] 1.4375 <= y <= 1.5 2^-2, degree 10, 60.7 bits */
    {0x1.e1cc001bf3763p-2, 0x1.90d369566bd63p-56, -0x1.0ca0b931bfd0ap-2, 0x1.70189e709fe95p-5, -0x1.4f6b255a0693dp-8,
     0x1.54440bad7afb6p-11, -0x1.96e43deb5134p-15, 0x1.cb835395fbc07p-18, 0x1.2f1e43b003487p-25, 0x1.f07ceb4dcdae1p-24,
     0x1.6acb7f4e785b1p-26, 0x1.7c1d53969fc42p-28}, /* [24] 1.5 <= y <= 1.5625 2^-2, degree 10, 60.4 bits */
    {0x1.d12fa46b34961p-2, 0x1.97fbf553ba53dp-59, -0x1.06efe57423578p-2, 0x1.685bc33577affp-5, -0x1.44e83f1cc38a5p-8,
     0x1.4c877e5a78d3fp-11, -0x1.8150793cde2e3p-15, 0x1.ce78d9cab9632p-18, 0x1.46029b81975fdp-23,
     -0x1.25c918e355847p-16, -0x1.97899ea846fb4p-16, 0x1.d0d3f9d4f9de9p-8},
     /* [25] 1.5625 <= y <= 1.625 2^-2, degree 10, 60.0 bits */
    {0x1.c0ed60f7ce2d5p-2, -0x1.2115d7cc75e01p-58, -0x1.015d87f4da555p-2, 0x1.60dd4312af9d9p-5, -0x1.3aa18cfda930bp-8,
     0x1.45372087e401bp-11, -0x1.6b9a6cdafb7c2p-15, 0x1.d13bd2fbef524p-18, 0x1.6104ff645e959p-23, 0x1.2460e5b387442p-23,
     0x1.357fb599dc46ap-24, 0x1.7196335e3ad9ap-22}, /* [26] 1.625 <= y <= 1.6875 2^-2, degree 10, 60.4 bits */
    {0x1.b103561a67338p-2, 0x1.9cb6979f1ff11p-56, -0x1.f7d15418d184dp-3, 0x1.599bbefa39a29p-5, -0x1.3093aa3e441b9p-8,
     0x1.3e53d6fd4debp-11, -0x1.55aa5e9b23cbdp-15, 0x1.d72652bb78b8dp-18, 0x1.0239ab06f2742p-22, 0x1.5aff064b76892p-23,
     0x1.1103b21f743fcp-25, 0x1.51a70a43b58abp-25}, /* [27] 1.6875 <= y <= 1.75 2^-2, degree 10, 60.0 bits */
    {0x1.a16fb36b164d8p-2, 0x1.951c130118cfcp-56, -0x1.ed20b4cd62c2ap-3, 0x1.5295ec53da146p-5, -0x1.26bb2902de48ap-8,
     0x1.37df06511b22dp-11, -0x1.3f655102e5663p-15, 0x1.df7255ba857aep-18, 0x1.5e995015eb8bap-22, 0x1.89a1ab02bf3c9p-23,
     0x1.641c00065b139p-25, 0x1.f074077d032f4p-28}, /* [28] 1.75 <= y <= 1.8125 2^-2, degree 10, 61.2 bits */
    {0x1.9230b76ebd236p-2, -0x1.94693c04e3a74p-56, -0x1.e2a759614176ep-3, 0x1.4bca95403a73dp-5, -0x1.1d148e1c3419ep-8,
     0x1.31daa1e6f4f91p-11, -0x1.28ace113c97a3p-15, 0x1.ea701a7ad79e7p-18, 0x1.c7992244ea7cbp-22, 0x1.c00bf62925d01p-23,
     0x1.a93f68170954p-25, 0x1.025da233b74d2p-26}, /* [29] 1.8125 <= y <= 1.875 2^-2, degree 10, 60.1 bits */
    {0x1.8344af49927ebp-2, -0x1.6b1d0028da591p-57, -0x1.d86372892e63cp-3, 0x1.453898f6d7bd9p-5, -0x1.139c4c45d9fep-8,
     0x1.2c493f16b9731p-11, -0x1.115e8a3f08adfp-15, 0x1.f87f98e924a73p-18, 0x1.1fc73600559d4p-21, 0x1.00c436305506ep-22,
     0x1.fbbbe21096f5p-25, 0x1.1fc6359c74b4dp-26}, /* [30] 1.875 <= y <= 1.9375 2^-2, degree 10, 65.3 bits */
    {0x1.74a9f676f2c02p-2, 0x1.837b3f6d8ad3bp-56, -0x1.ce5339aa3f902p-3, 0x1.3edeec425d02p-5, -0x1.0a4ebebeef425p-8,
     0x1.272e2bbf707c8p-11, -0x1.f2a5b724eb6d1p-16, 0x1.0509d02c0962cp-17, 0x1.64b68a9ce0fc1p-21, 0x1.27e9e9dea0458p-22,
     0x1.310de643886ddp-24, 0x1.6ce11515b129cp-26}, /* [31] 1.9375 <= y <= 2 2^-2, degree 10, 60.4 bits */
    {0x1.5f56e0aa8b22ep-2, 0x1.a54130ef4f5a3p-59, -0x1.bf97fba320372p-2, 0x1.35bfecb5ba503p-3, -0x1.f94472d65898bp-6,
     0x1.206cae6a19bedp-7, -0x1.a6f27c7f38d4cp-11, 0x1.161f3bde2a576p-11, 0x1.e0f482b8a3fa8p-14, 0x1.72315d98a5709p-14,
     0x1.94b58c8e0f8c7p-15, 0x1.ef1fb1a5f3877p-16}, /* [32] 1 <= y <= 1.0625 2^-1, degree 10, 58.8 bits */
    {0x1.43f65098fc0e3p-2, 0x1.4817263737d2ep-57, -0x1.ac987cc049d74p-2, 0x1.2a53830e963bdp-3, -0x1.d5afe4805f2a4p-6,
     0x1.1937bf2d3421dp-7, -0x1.3908d7c7c103bp-11, 0x1.360ed81f62a96p-11, 0x1.5d456f0cf7ff6p-13, 0x1.fd3bb50278721p-14,
     0x1.2b9842d94626cp-14, 0x1.80de5f7746b3ep-15}, /* [33] 1.0625 <= y <= 1.125 2^-1, degree 10, 59.7 bits */
    {0x1.29c0259f2dd13p-2, -0x1.3be147c684b65p-56, -0x1.9a4925edeb47p-2, 0x1.1fba279a867cfp-3, -0x1.b2de3bea39a5fp-6,
     0x1.144a5b38670a7p-7, -0x1.794d9993356cap-12, 0x1.6412d57cb79fp-11, 0x1.f4cb87910abbp-13, 0x1.669d7a20d6efcp-13,
     0x1.c4a494379c036p-14, 0x1.32dd7977bce5dp-14}, /* [34] 1.125 <= y <= 1.1875 2^-1, degree 10, 58.6 bits */
    {0x1.10a9c613043adp-2, -0x1.72d9e99021ea4p-56, -0x1.889ce61dd82a5p-2, 0x1.15f02db8c02fp-3, -0x1.9081688af4b28p-6,
     0x1.11fbaefebc734p-7, -0x1.5c132ea05f093p-14, 0x1.a5f2d4a8ba939p-11, 0x1.667d9505a1ca8p-12, 0x1.02d331f6d641bp-12,
     0x1.5df8dbee5a75ep-13, 0x1.f685c01956e84p-14}, /* [35] 1.1875 <= y <= 1.25 2^-1, degree 10, 58.2 bits */
    {0x1.f152cfabe992p-3, 0x1.490b5860b6ef3p-58, -0x1.7786d7a99b5a5p-2, 0x1.0cf3e22913142p-3, -0x1.6e3e3cc54da55p-6,
     0x1.12c89ce6f11b3p-7, 0x1.06c1f6ba7c9cbp-12, 0x1.0244e94ce0d15p-10, 0x1.0256d833b4fa6p-11, 0x1.7f816ab0daad3p-12,
     0x1.15de715f2eff1p-12, 0x1.a7ff0950c2ebfp-13} /* [36] 1.25 <= y <= 1.3125 2^-1, degree 10, 58.2 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_middle_eps_zero_overlap)

/* eps at zero overlap, 2^-53 <= beta_c - beta < 2^-1: 416 rows of degree 10 in y = (beta_c - beta) 2^-k, 8 to each octave k = -53 ... -2.
 * Relative error of the approximation: 2^-57.3 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_BELOW_EPS_ZERO_OVERLAP_FIRST 1.1102230246251565e-16
#define COR_ROWS_HERTZ_DASHPOT_BELOW_EPS_ZERO_OVERLAP_FIRST_OCTAVE (-53)
#define COR_ROWS_HERTZ_DASHPOT_BELOW_EPS_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_BELOW_EPS_ZERO_OVERLAP_ROWS 416
#define COR_ROWS_HERTZ_DASHPOT_BELOW_EPS_ZERO_OVERLAP_END 0.5000000000004547
COR_ROWS(double, cor_rows_hertz_dashpot_below_eps_zero_overlap, 416, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.c267bda9a2b3dp-56, 0x1.dcd834bf821cp-110, 0x1.a7e92b22dc367p-56, 0x1.cd5e27fdcd993p-84, -0x1.217c4da5266c5p-86,
     0x1.98af7c5ff8a75p-88, -0x1.80a5297e5e5c1p-89, 0x1.a65aff8edbe78p-90, -0x1.ff14ea00c32ep-91, 0x1.4ab3128db7042p-91,
     -0x1.c3d8236f6a04ep-92, 0x1.3f09aa0e1f846p-92}, /* [0] 1 <= y <= 1.125 2^-53, degree 10, 57.9 bits */
    {0x1.f764e30e6f676p-56, -0x1.c8500b4d83339p-110, 0x1.a7e92b29de619p-56, 0x1.b4690692bac1bp-84,
     -0x1.ea011920dd3cep-87, 0x1.3579f4b8df8fep-88, -0x1.049c98130d754p-89, 0x1.000a205f7145ep-90,
     -0x1.1536e3535a0d2p-91, 0x1.40fc1ed1ffab7p-92, -0x1.8802ea1c83e19p-93, 0x1.ef485f077b821p-94},
     /* [1] 1.125 <= y <= 1.25 2^-53, degree 10, 59.0 bits */
    {0x1.1631043a0b3b1p-55, 0x1.9f769fca68b84p-109, 0x1.a7e92b30845a9p-56, 0x1.9f1be50b5d4b5p-84,
     -0x1.a5b2a3721c787p-87, 0x1.e1f0ba7db2329p-89, -0x1.6f315104f454ep-90, 0x1.4664b99bccef5p-91,
     -0x1.3fbb37e719ba7p-92, 0x1.4ef4d9a263828p-93, -0x1.71d839c238eadp-94, 0x1.a6c1b9d4a4d4p-95},
     /* [2] 1.25 <= y <= 1.375 2^-53, degree 10, 72.3 bits */
    {0x1.30af96ed46989p-55, 0x1.c955843e8c421p-110, 0x1.a7e92b36db087p-56, 0x1.8ca67dd0d2ed7p-84,
     -0x1.6fe84bc7362a8p-87, 0x1.7fe743b2630e4p-89, -0x1.0b102f05324e7p-90, 0x1.b17e7145ad16bp-92,
     -0x1.83b86b52d53e7p-93, 0x1.72dce369538ebp-94, -0x1.75ad960b26906p-95, 0x1.85fbfa3e5578ap-96},
     /* [3] 1.375 <= y <= 1.5 2^-53, degree 10, 60.8 bits */
    {0x1.4b2e29a0e52bbp-55, 0x1.88664d1e3d714p-109, 0x1.a7e92b3cec90ep-56, 0x1.7c74236388b9dp-84,
     -0x1.44a754bd0f93fp-87, 0x1.37aae080e5941p-89, -0x1.8eef33bd6b8bp-91, 0x1.29defa2fbc0e6p-92,
     -0x1.ea35b3b48facfp-94, 0x1.af626deb2a0eap-95, -0x1.8fb7bdb7209aep-96, 0x1.7fc7492bea9dfp-97},
     /* [4] 1.5 <= y <= 1.625 2^-53, degree 10, 58.7 bits */
    {0x1.65acbc54e2e5ap-55, 0x1.c5a5a2602b929p-110, 0x1.a7e92b42c11aap-56, 0x1.6e177ac03c851p-84,
     -0x1.2141ec014ead3p-87, 0x1.011e26f0abb87p-89, -0x1.30bb7070e57c6p-91, 0x1.a55bab31d6fbfp-93,
     -0x1.4108cae6b641bp-94, 0x1.05955fbfc24c9p-95, -0x1.c0b4a2b14f332p-97, 0x1.8ee4baff682c5p-98},
     /* [5] 1.625 <= y <= 1.75 2^-53, degree 10, 64.2 bits */
    {0x1.802b4f093c2d8p-55, -0x1.073dfce911c5dp-109, 0x1.a7e92b485f503p-56, 0x1.613e0c2941e8dp-84,
     -0x1.03db38012047dp-87, 0x1.ae1b65386b436p-90, -0x1.da99d0aa52773p-92, 0x1.317d7d6ed2883p-93,
     -0x1.b1678827e6ed4p-95, 0x1.48ca1da977ef4p-96, -0x1.0679df637dac1p-97, 0x1.b27c176e9814cp-99},
     /* [6] 1.75 <= y <= 1.875 2^-53, degree 10, 58.8 bits */
    {0x1.9aa9e1bdedcb9p-55, 0x1.0b7767314d202p-110, 0x1.a7e92b4dccbap-56, 0x1.55a851a4ba61p-84, -0x1.d63ceefc6ba3ap-88,
     0x1.6c0e241c29553p-90, -0x1.77cc8843d672dp-92, 0x1.c49338ac87436p-94, -0x1.2c537c67cb5bep-95,
     0x1.aa44efab0254dp-97, -0x1.3e45a4a0c90edp-98, 0x1.ecd98029587d5p-100},
     /* [7] 1.875 <= y <= 2 2^-53, degree 10, 60.2 bits */
    {0x1.c267bdcd97955p-55, 0x1.88426f3af05b3p-110, 0x1.a7e92b559f57p-55, 0x1.463c8197faed2p-82, -0x1.9964f7ff64f62p-85,
     0x1.20fbfa2135a3p-86, -0x1.0ffc36b0b3642p-87, 0x1.2aa6824cdf27ap-88, -0x1.6963adeebba95p-89, 0x1.d3ae091d17a07p-90,
     -0x1.3f8096894a75p-90, 0x1.c330163657bdep-91}, /* [8] 1 <= y <= 1.125 2^-52, degree 10, 57.7 bits */
    {0x1.f764e338eb8ddp-55, -0x1.70918ad5fa6d3p-110, 0x1.a7e92b5f88ad8p-55, 0x1.3496b569c99e4p-82,
     -0x1.5a7c408b3dcc5p-85, 0x1.b5aa6c1f1e1c1p-87, -0x1.708f83652a41p-88, 0x1.6a18392e24bcap-89,
     -0x1.880a575cda4c9p-90, 0x1.c5f0f0ec446dep-91, -0x1.1531a82c3fef7p-91, 0x1.5e37c8144b47dp-92},
     /* [9] 1.125 <= y <= 1.25 2^-52, degree 10, 58.2 bits */
    {0x1.16310452ba29fp-54, -0x1.3ec0d2ca4dc66p-112, 0x1.a7e92b68efa19p-55, 0x1.2586c3412db2p-82,
     -0x1.2a2f7531cd22cp-85, 0x1.54c885a55e8dap-87, -0x1.03a4f80a1c819p-88, 0x1.cd970e36df35bp-90,
     -0x1.c42b1b548f57fp-91, 0x1.d9b331e0c6faep-92, -0x1.058509ca0df17p-92, 0x1.2aef299286c84p-93},
     /* [10] 1.25 <= y <= 1.375 2^-52, degree 10, 59.5 bits */
    {0x1.30af97099165bp-54, 0x1.5d6ec5faf7b3bp-108, 0x1.a7e92b71e6725p-55, 0x1.187965e36c089p-82,
     -0x1.04265aed75d38p-85, 0x1.0f75ef5595cb5p-87, -0x1.79af369aee345p-89, 0x1.3286c815cd8e2p-90,
     -0x1.1228e36e49663p-91, 0x1.063d59351369ep-92, -0x1.083af61557ed7p-93, 0x1.13c2b4d06d7c5p-94},
     /* [11] 1.375 <= y <= 1.5 2^-52, degree 10, 59.3 bits */
    {0x1.4b2e29c0f4ef3p-54, -0x1.af7ade4ad7568p-111, 0x1.a7e92b7a7b796p-55, 0x1.0d057bc54e72ep-82,
     -0x1.cb212c47874d4p-86, 0x1.b8c3af37d71ccp-88, -0x1.1a16d670dd796p-89, 0x1.a540d2eb34481p-91,
     -0x1.5aa172ddca449p-92, 0x1.3108ef84a06ep-93, -0x1.1aa4a48d58807p-94, 0x1.0f5f53e3ab9d6p-95},
     /* [12] 1.5 <= y <= 1.625 2^-52, degree 10, 59.1 bits */
    {0x1.65acbc78df093p-54, 0x1.ba5b587c9d744p-109, 0x1.a7e92b82ba3e1p-55, 0x1.02ddb1702e205p-82,
     -0x1.991267bac1bc5p-86, 0x1.6b9e94bdc878dp-88, -0x1.aef4d60d1ecbcp-90, 0x1.29f1f5e595a7ap-91,
     -0x1.c602d9690ce8dp-93, 0x1.71ef576a767f9p-94, -0x1.3d4864ad4ea24p-95, 0x1.1a0f6fa7e6931p-96},
     /* [13] 1.625 <= y <= 1.75 2^-52, degree 10, 58.9 bits */
    {0x1.802b4f314a9d7p-54, 0x1.0c4add6c8bbabp-109, 0x1.a7e92b8aac2d8p-55, 0x1.f38f6d4563f34p-83,
     -0x1.6f7e0a19d79e4p-86, 0x1.3021afc760b16p-88, -0x1.4f97edf8221a7p-90, 0x1.b00743e895f7dp-92,
     -0x1.327694c227b0fp-93, 0x1.d0fa8541f15acp-95, -0x1.73327ccf4f13ap-96, 0x1.333a23e3e9ef7p-97},
     /* [14] 1.75 <= y <= 1.875 2^-52, degree 10, 58.7 bits */
    {0x1.9aa9e1ea331f1p-54, 0x1.f4b2ca475f856p-112, 0x1.a7e92b92591bp-55, 0x1.e32d40d172c9ap-83, -0x1.4c822cf4fe2ddp-86,
     0x1.016d09c3bad46p-88, -0x1.09bae0ae43edcp-90, 0x1.4004d77444191p-92, -0x1.a8b9ab51fcc31p-94,
     0x1.2d6afba1f67bfp-95, -0x1.c21aca05bbeap-97, 0x1.5c7f4fac2b0ebp-98},
     /* [15] 1.875 <= y <= 2 2^-52, degree 10, 60.0 bits */
    {0x1.c267be007140ap-54, 0x1.3399b3d9dd1ecp-108, 0x1.a7e92b9d693aap-54, 0x1.cd5e33eec860cp-81,
     -0x1.217c4e200e932p-83, 0x1.98af7ce8ef958p-85, -0x1.80a52a3092d6p-86, 0x1.a65b01144d80ap-87,
     -0x1.ff14ede885dbdp-88, 0x1.4ab3179698a85p-88, -0x1.c3d83028419a5p-89, 0x1.3f09b951089a8p-89},
     /* [16] 1 <= y <= 1.125 2^-51, degree 10, 60.0 bits */
    {0x1.f764e37500c16p-54, 0x1.dfb809f9446e3p-108, 0x1.a7e92bab6d914p-54, 0x1.b4691278e606dp-81,
     -0x1.ea0119f9eb456p-84, 0x1.3579f51a90008p-85, -0x1.049c986b6d472p-86, 0x1.000a20ead4b3dp-87,
     -0x1.1536e47b6fafdp-88, 0x1.40fc2177aad1dp-89, -0x1.8802f02b4695ap-90, 0x1.ef486c4a4dbd4p-91},
     /* [17] 1.125 <= y <= 1.25 2^-51, degree 10, 57.9 bits */
    {0x1.16310475a27c7p-53, -0x1.21cd94d7e22c2p-108, 0x1.a7e92bb8b983bp-54, 0x1.9f1bf0e7e25afp-81,
     -0x1.a5b2a435a4c24p-84, 0x1.e1f0bb164377ep-86, -0x1.6f31516fcfb5bp-87, 0x1.4664ba15683f4p-88,
     -0x1.3fbb38b262dc1p-89, 0x1.4ef4db35b3ddep-90, -0x1.71d83d042504ep-91, 0x1.a6c1c060680d6p-92},
     /* [18] 1.25 <= y <= 1.375 2^-51, degree 10, 59.7 bits */
    {0x1.30af973194445p-53, 0x1.da28cc3195ffep-108, 0x1.a7e92bc566dfdp-54, 0x1.8ca689a49874dp-81,
     -0x1.6fe84c798229fp-84, 0x1.7fe7442f4c809p-86, -0x1.0b102f4ee03e8p-87, 0x1.b17e71c5b3a46p-89,
     -0x1.83b86bf654586p-90, 0x1.72dce4785af82p-91, -0x1.75ad97fe8c784p-92, 0x1.85fbfdd73429ep-93},
     /* [19] 1.375 <= y <= 1.5 2^-51, degree 10, 58.5 bits */
    {0x1.4b2e29ee4c779p-53, -0x1.5d66f27a6a1c1p-107, 0x1.a7e92bd189f1p-54, 0x1.7c742f2f4b0afp-81, -0x1.44a755610b95p-84,
     0x1.37aae0e9f4b61p-86, -0x1.8eef342b3f324p-88, 0x1.29defa7e0c733p-89, -0x1.ea35b44f6104ep-91,
     0x1.af626eba49ac9p-92, -0x1.8fb7bf02bdb3p-93, 0x1.7fc74b5863ec2p-94},
     /* [20] 1.5 <= y <= 1.625 2^-51, degree 10, 61.5 bits */
    {0x1.65acbcabc2f86p-53, -0x1.820cd3d4118c3p-108, 0x1.a7e92bdd3304fp-54, 0x1.6e17868499caep-81,
     -0x1.2141ec9925388p-84, 0x1.011e274a947a1p-86, -0x1.30bb70c68cf13p-88, 0x1.a55bab9c11856p-90,
     -0x1.4108cb3bcef43p-91, 0x1.0595601a8f189p-92, -0x1.c0b4a3a6672ddp-94, 0x1.8ee4bc6f51ca5p-95},
     /* [21] 1.625 <= y <= 1.75 2^-51, degree 10, 58.6 bits */
    {0x1.802b4f69f0951p-53, -0x1.351374e6e8636p-107, 0x1.a7e92be86f706p-54, 0x1.613e17e6c164cp-81,
     -0x1.03db388e80957p-84, 0x1.ae1b65d442e14p-87, -0x1.da99d133bb17ap-89, 0x1.317d7dbbbc40ap-90,
     -0x1.b167889126fb1p-92, 0x1.48ca1e04c1f94p-93, -0x1.0679dfc91f81cp-94, 0x1.b27c1879197aep-96},
     /* [22] 1.75 <= y <= 1.875 2^-51, degree 10, 58.9 bits */
    {0x1.9aa9e228cede4p-53, -0x1.435a5b340260cp-107, 0x1.a7e92bf34a447p-54, 0x1.55a85d5bd13d3p-81,
     -0x1.d63cf004f26fdp-85, 0x1.6c0e24a495721p-87, -0x1.77cc88b42e319p-89, 0x1.c49339209287p-91,
     -0x1.2c537cae83a22p-92, 0x1.aa44f0129ae7bp-94, -0x1.3e45a4ffdeacp-95, 0x1.ecd980fe26453p-97},
     /* [23] 1.875 <= y <= 2 2^-51, degree 10, 59.0 bits */
    {0x1.c267be485b055p-53, -0x1.886fedb780dd5p-108, 0x1.a7e92c02ef7fp-53, 0x1.463c8d46313f2p-79,
     -0x1.9964f8f097be1p-82, 0x1.20fbfa92ad582p-83, -0x1.0ffc3705eda72p-84, 0x1.2aa6829ca790fp-85,
     -0x1.6963ae44971eep-86, 0x1.d3ae0985fe0dcp-87, -0x1.3f8096d50f787p-87, 0x1.c33016ba1fbdbp-88},
     /* [24] 1 <= y <= 1.125 2^-50, degree 10, 61.9 bits */
    {0x1.f764e3c9f9107p-53, -0x1.48bf572624eb2p-107, 0x1.a7e92c16c22cbp-53, 0x1.3496c10d4f82fp-79,
     -0x1.5a7c41630dabcp-82, 0x1.b5aa6cd4dc7c2p-84, -0x1.708f83df7a15ep-85, 0x1.6a183994ac0bap-86,
     -0x1.880a57bea7c43p-87, 0x1.c5f0f152b549fp-88, -0x1.1531a8677f60fp-88, 0x1.5e37c861a63dbp-89},
     /* [25] 1.125 <= y <= 1.25 2^-50, degree 10, 57.9 bits */
    {0x1.163104a7005b7p-52, -0x1.f0e189497e9a3p-106, 0x1.a7e92c2990159p-53, 0x1.2586cedb154a3p-79,
     -0x1.2a2f75f50ebe7p-82, 0x1.54c8863a28c73p-84, -0x1.03a4f864cae3cp-85, 0x1.cd970ec0bd53dp-87,
     -0x1.c42b1bcbbfac1p-88, 0x1.d9b33250e4f54p-89, -0x1.05850a029eb58p-89, 0x1.2aef29cfc761bp-90},
     /* [26] 1.25 <= y <= 1.375 2^-50, degree 10, 58.7 bits */
    {0x1.30af976a29e02p-52, -0x1.27f74e87749ffp-112, 0x1.a7e92c3b7db7bp-53, 0x1.187971749587bp-79,
     -0x1.04265b9fbc33bp-82, 0x1.0f75efd19ef01p-84, -0x1.79af372507227p-86, 0x1.3286c875cfbd8p-87,
     -0x1.1228e3ba4fb73p-88, 0x1.063d59768740dp-89, -0x1.083af6514041bp-90, 0x1.13c2b509f766ap-91},
     /* [27] 1.375 <= y <= 1.5 2^-50, degree 10, 58.1 bits */
    {0x1.4b2e2a2e6c005p-52, -0x1.3d81d96f90fabp-106, 0x1.a7e92c4ca7c6ap-53, 0x1.0d05874e749b9p-79,
     -0x1.cb212d8f8d08bp-83, 0x1.b8c3b009cba89p-85, -0x1.1a16d6dc67465p-86, 0x1.a540d374e37a2p-88,
     -0x1.5aa17342568bdp-89, 0x1.3108efd493c34p-90, -0x1.1aa4a4d0d68d7p-91, 0x1.0f5f541f08b02p-92},
     /* [28] 1.5 <= y <= 1.625 2^-50, degree 10, 61.8 bits */
    {0x1.65acbcf3bb419p-52, 0x1.b8df5105f179cp-106, 0x1.a7e92c5d2550ap-53, 0x1.02ddbcf1eeebap-79,
     -0x1.991268ea7abf8p-83, 0x1.6b9e9571c6987p-85, -0x1.aef4d6b7d63c9p-87, 0x1.29f1f64acf94ep-88,
     -0x1.c602d9f225809p-90, 0x1.71ef57cfb7c7cp-91, -0x1.3d4864fcc7d44p-92, 0x1.1a0f6fe8d580bp-93},
     /* [29] 1.625 <= y <= 1.75 2^-50, degree 10, 59.0 bits */
    {0x1.802b4fba0d776p-52, 0x1.76d1e7e5376c1p-107, 0x1.a7e92c6d09304p-53, 0x1.f38f843b298acp-80,
     -0x1.6f7e0b349e348p-83, 0x1.3021b06364bc6p-85, -0x1.4f97ee81e3d7bp-87, 0x1.b0074480b1448p-89,
     -0x1.32769522200c9p-90, 0x1.d0fa85c633fa4p-92, -0x1.73327d304cee1p-93, 0x1.333a242e0bc83p-94},
     /* [30] 1.75 <= y <= 1.875 2^-50, degree 10, 58.9 bits */
    {0x1.9aa9e2815988p-52, -0x1.82f64e9c64c7bp-106, 0x1.a7e92c7c630cp-53, 0x1.e32d57ba66f71p-80, -0x1.4c822dfd866b9p-83,
     0x1.016d0a4c42b16p-85, -0x1.09bae11f0761cp-87, 0x1.4004d7e8bb857p-89, -0x1.a8b9abdb82a08p-91,
     0x1.2d6afbfab82b1p-92, -0x1.c21aca7fd0ff1p-94, 0x1.5c7f5003d2fd8p-95},
     /* [31] 1.875 <= y <= 2 2^-50, degree 10, 58.9 bits */
    {0x1.c267beae0e5f4p-52, -0x1.29aa599673ff7p-109, 0x1.a7e92c92834c5p-52, 0x1.cd5e4ac5fb81fp-78,
     -0x1.217c4f113fa47p-80, 0x1.98af7dcbeec0ep-82, -0x1.80a52adb7e36ap-83, 0x1.a65b01b539722p-84,
     -0x1.ff14ee95c3e61p-85, 0x1.4ab317fc9dcc8p-85, -0x1.c3d830a8e2e0ep-86, 0x1.3f09b9a59fe41p-86},
     /* [32] 1 <= y <= 1.125 2^-49, degree 10, 58.3 bits */
    {0x1.f764e442237bcp-52, -0x1.116dd82f70619p-107, 0x1.a7e92cae8bfb1p-52, 0x1.b469293ab8801p-78,
     -0x1.ea011ba986d89p-81, 0x1.3579f5d04955fp-82, -0x1.049c98e5d84bbp-83, 0x1.000a2151ee2a5p-84,
     -0x1.1536e4deb6af7p-85, 0x1.40fc21e0491c9p-86, -0x1.8802f0a1511b3p-87, 0x1.ef486cd599d39p-88},
     /* [33] 1.125 <= y <= 1.25 2^-49, degree 10, 59.7 bits */
    {0x1.163104ecd102ep-51, 0x1.8cbfc4ed52634p-105, 0x1.a7e92cc923e14p-52, 0x1.9f1c079678633p-78,
     -0x1.a5b2a5bc2595ep-81, 0x1.e1f0bc3fc8aa2p-83, -0x1.6f31522524ccfp-84, 0x1.4664ba9f8f2a7p-85,
     -0x1.3fbb392ab573dp-86, 0x1.4ef4dba861a7ep-87, -0x1.71d83d7922b5dp-88, 0x1.a6c1c0dd6a38p-89},
     /* [34] 1.25 <= y <= 1.375 2^-49, degree 10, 58.6 bits */
    {0x1.30af97ba2fa06p-51, -0x1.f1f45b5d0acb6p-106, 0x1.a7e92ce27e9afp-52, 0x1.8ca6a041b25d2p-78,
     -0x1.6fe84dde0e2aep-81, 0x1.7fe74527544f8p-83, -0x1.0b102fd8e6c2bp-84, 0x1.b17e7285b7842p-86,
     -0x1.83b86c8efd2bep-87, 0x1.72dce4fd273e7p-88, -0x1.75ad987a236ecp-89, 0x1.85fbfe4fc4e3fp-90},
     /* [35] 1.375 <= y <= 1.5 2^-49, degree 10, 58.2 bits */
    {0x1.4b2e2a891b149p-51, -0x1.6852f5230059fp-105, 0x1.a7e92cfac4becp-52, 0x1.7c7445bc5e48fp-78,
     -0x1.44a756a911885p-81, 0x1.37aae1bbe40f6p-83, -0x1.8eef350235e4cp-85, 0x1.29defb079bff5p-86,
     -0x1.ea35b51896da2p-88, 0x1.af626f5b45f11p-89, -0x1.8fb7bf8c78cf8p-90, 0x1.7fc74bd3f43p-91},
     /* [36] 1.5 <= y <= 1.625 2^-49, degree 10, 59.4 bits */
    {0x1.65acbd598324p-51, 0x1.995766d1940b5p-105, 0x1.a7e92d1216e8p-52, 0x1.6e179d02e2489p-78, -0x1.2141edc8dedbap-81,
     0x1.011e27fe90fc7p-83, -0x1.30bb71713331dp-85, 0x1.a55bac664c98p-87, -0x1.4108cbc4bf7f3p-88, 0x1.0595607ffd38fp-89,
     -0x1.c0b4a447017cp-91, 0x1.8ee4bcf4ac289p-92}, /* [37] 1.625 <= y <= 1.75 2^-49, degree 10, 58.5 bits */
    {0x1.802b502b596b5p-51, 0x1.9be5c9112b849p-109, 0x1.a7e92d288fc04p-52, 0x1.613e2e574ddb3p-78,
     -0x1.03db39a947dc7p-81, 0x1.ae1b670c4ba15p-84, -0x1.da99d2472de72p-86, 0x1.317d7e53b20b2p-87,
     -0x1.b1678950c1c07p-89, 0x1.48ca1e88e0d96p-90, -0x1.0679e02a76bfbp-91, 0x1.b27c190f8bdffp-93},
     /* [38] 1.75 <= y <= 1.875 2^-49, degree 10, 60.4 bits */
    {0x1.9aa9e2fe910bbp-51, 0x1.01d99a9f700b7p-105, 0x1.a7e92d3e4569dp-52, 0x1.55a873bf8c41dp-78,
     -0x1.d63cf21604184p-82, 0x1.6c0e25b5a7838p-84, -0x1.77cc8995af464p-86, 0x1.c4933a0956f12p-88,
     -0x1.2c537d37cbc3ep-89, 0x1.aa44f0c3b59b4p-91, -0x1.3e45a579e5112p-92, 0x1.ecd981ae8833dp-94},
     /* [39] 1.875 <= y <= 2 2^-49, degree 10, 58.7 bits */
    {0x1.c267bf3de1ef1p-51, -0x1.fb0eb30286559p-105, 0x1.a7e92d5d8fe11p-51, 0x1.463ca3982b2f2p-76,
     -0x1.9964fad2fa8e1p-79, 0x1.20fbfb75af332p-80, -0x1.0ffc37b0da91fp-81, 0x1.2aa6833d85ef8p-82,
     -0x1.6963aef19bd47p-83, 0x1.d3ae0a5181be7p-84, -0x1.3f8097554b3fep-84, 0x1.c33017631fafep-85},
     /* [40] 1 <= y <= 1.125 2^-48, degree 10, 59.5 bits */
    {0x1.f764e4ec1421dp-51, 0x1.111a77bc261b8p-106, 0x1.a7e92d85353f4p-51, 0x1.3496d749e8c68p-76,
     -0x1.5a7c4312a95a9p-79, 0x1.b5aa6e4052b5dp-81, -0x1.708f84d456f05p-82, 0x1.6a183a62dffap-83,
     -0x1.880a588519411p-84, 0x1.c5f0f2239210cp-85, -0x1.1531a8dd24f9p-85, 0x1.5e37c8ec5a02dp-86},
     /* [41] 1.125 <= y <= 1.25 2^-48, degree 10, 58.3 bits */
    {0x1.1631054f8cc5cp-50, 0x1.1ff740af4af96p-105, 0x1.a7e92daad113bp-51, 0x1.2586e504721dbp-76,
     -0x1.2a2f777b8f5bfp-79, 0x1.54c88763af9f4p-81, -0x1.03a4f91a25121p-82, 0x1.cd970fd517b61p-84,
     -0x1.c42b1cbc62182p-85, 0x1.d9b333360e7fap-86, -0x1.05850a7756ec7p-86, 0x1.2aef2a4c470a2p-87},
     /* [42] 1.25 <= y <= 1.375 2^-48, degree 10, 59.6 bits */
    {0x1.30af982b5adddp-50, 0x1.87e3047c4db35p-106, 0x1.a7e92dceac5adp-51, 0x1.1879878c763eap-76,
     -0x1.04265d0447df5p-79, 0x1.0f75f0c9a729cp-81, -0x1.79af383919e32p-83, 0x1.3286c935de0a6p-84,
     -0x1.1228e4530161ap-85, 0x1.063d59fb4de4fp-86, -0x1.083af6ccb1388p-87, 0x1.13c2b5823011dp-88},
     /* [43] 1.375 <= y <= 1.5 2^-48, degree 10, 64.2 bits */
    {0x1.4b2e2b095a2cfp-50, 0x1.eb5ce6c077115p-105, 0x1.a7e92df1007b6p-51, 0x1.0d059d564eac4p-76,
     -0x1.cb21301f9840bp-80, 0x1.b8c3b1ada9ef6p-82, -0x1.1a16d7b360878p-83, 0x1.a540d4880f8d2p-85,
     -0x1.5aa1740b9d016p-86, 0x1.3108f07599b72p-87, -0x1.1aa4a55a85568p-88, 0x1.0f5f549a670d9p-89},
     /* [44] 1.5 <= y <= 1.625 2^-48, degree 10, 59.4 bits */
    {0x1.65acbde973be8p-50, 0x1.d7c93d2b67401p-105, 0x1.a7e92e11fb923p-51, 0x1.02ddd2eafe3fep-76,
     -0x1.99126b49ed6dep-80, 0x1.6b9e96d9beb56p-82, -0x1.aef4d80d24352p-84, 0x1.29f1f715118b9p-85,
     -0x1.c602db041cdadp-87, 0x1.71ef589aa9b07p-88, -0x1.3d48659d69eb7p-89, 0x1.1a0f706e1c21bp-90},
     /* [45] 1.625 <= y <= 1.75 2^-48, degree 10, 59.5 bits */
    {0x1.802b50cb93394p-50, -0x1.202b06edc60fdp-109, 0x1.a7e92e31c3541p-51, 0x1.f38fb011d02b3p-77,
     -0x1.6f7e0d6a2c498p-80, 0x1.3021b19b6c82ep-82, -0x1.4f97ef95564f3p-84, 0x1.b00745b0a30dcp-86,
     -0x1.327695e1c7b79p-87, 0x1.d0fa86ce90b27p-89, -0x1.73327df3130ep-90, 0x1.333a24c481cd8p-91},
     /* [46] 1.75 <= y <= 1.875 2^-48, degree 10, 59.3 bits */
    {0x1.9aa9e3afa669cp-50, -0x1.140b5e7f5de1dp-105, 0x1.a7e92e50770e5p-51, 0x1.e32d83776ab8fp-77,
     -0x1.4c82300e97b88p-80, 0x1.016d0b5d53e83p-82, -0x1.09bae2008763cp-84, 0x1.4004d8d181f54p-86,
     -0x1.a8b9acee20547p-88, 0x1.2d6afcabe5da7p-89, -0x1.c21acb7402291p-91, 0x1.5c7f50b44af77p-92},
     /* [47] 1.875 <= y <= 2 2^-48, degree 10, 64.3 bits */
    {0x1.c267c00948af9p-50, 0x1.53b17daf44457p-105, 0x1.a7e92e7cb7932p-50, 0x1.cd5e765f7d1fap-75,
     -0x1.217c50f3a23b5p-77, 0x1.98af7f91f1515p-79, -0x1.80a52c3155a54p-80, 0x1.a65b02f6f4ff7p-81,
     -0x1.ff14efefd51f4p-82, 0x1.4ab318c830fc6p-82, -0x1.c3d831a97ea87p-83, 0x1.3f09ba4ebea45p-83},
     /* [48] 1 <= y <= 1.125 2^-47, degree 10, 61.9 bits */
    {0x1.f764e5dc69083p-50, 0x1.514fa75df5a81p-104, 0x1.a7e92eb4c8f6p-50, 0x1.b46954a978c8dp-75, -0x1.ea011f08bdf77p-78,
     0x1.3579f73bbf0ep-79, -0x1.049c99dab3856p-80, 0x1.000a22201fbdap-81, -0x1.1536e5a527b0bp-82, 0x1.40fc22b12cb04p-83,
     -0x1.8802f18cb27d8p-84, 0x1.ef486deb2f67ep-85}, /* [49] 1.125 <= y <= 1.25 2^-47, degree 10, 60.6 bits */
    {0x1.163105db2e1e5p-49, 0x1.7352178bb2e93p-104, 0x1.a7e92ee9f8c7ep-50, 0x1.9f1c32debfce4p-75, -0x1.a5b2a8c926a5p-78,
     0x1.e1f0be92d6199p-80, -0x1.6f31538fd7797p-81, 0x1.4664bbb3e6153p-82, -0x1.3fbb3a1b543c6p-83,
     0x1.4ef4dc8d8b643p-84, -0x1.71d83e629d78fp-85, 0x1.a6c1c1d68555dp-86},
     /* [50] 1.25 <= y <= 1.375 2^-47, degree 10, 58.9 bits */
    {0x1.30af98cb6669cp-49, -0x1.f5b8fd02ea9b8p-106, 0x1.a7e92f1cae409p-50, 0x1.8ca6cb6701912p-75,
     -0x1.6fe850a72557dp-78, 0x1.7fe7471764dcfp-80, -0x1.0b1030ecf8d6bp-81, 0x1.b17e7405d0215p-83,
     -0x1.83b86dc05ab41p-84, 0x1.72dce606aff35p-85, -0x1.75ad997106f16p-86, 0x1.85fbff4043ca2p-87},
     /* [51] 1.375 <= y <= 1.5 2^-47, degree 10, 58.2 bits */
    {0x1.4b2e2bbeb862fp-49, 0x1.10e364af2b1eap-104, 0x1.a7e92f4d3a8d9p-50, 0x1.7c7470c1a0328p-75,
     -0x1.44a759391c909p-78, 0x1.37aae35fc28e2p-80, -0x1.8eef36b02822cp-82, 0x1.29defc1ac61f6p-83,
     -0x1.ea35b6ab1ca12p-85, 0x1.af62709d49dd5p-86, -0x1.8fb7c09fd1a71p-87, 0x1.7fc74ccab4377p-88},
     /* [52] 1.5 <= y <= 1.625 2^-47, degree 10, 59.7 bits */
    {0x1.65acbeb503931p-49, 0x1.b45c06753b5ebp-103, 0x1.a7e92f7bdee57p-50, 0x1.6e17c7ea8ebbbp-75,
     -0x1.2141f02851531p-78, 0x1.011e29668950cp-80, -0x1.30bb72c68162dp-82, 0x1.a55badfacef9fp-84,
     -0x1.4108ccd6b2fe9p-85, 0x1.0595614ae9f3bp-86, -0x1.c0b4a5883c571p-88, 0x1.8ee4bdff3559cp-89},
     /* [53] 1.625 <= y <= 1.75 2^-47, degree 10, 59.0 bits */
    {0x1.802b51ae2b333p-49, -0x1.5ca764dc19dfep-104, 0x1.a7e92fa8d09b6p-50, 0x1.613e59238248fp-75,
     -0x1.03db3bded5b44p-78, 0x1.ae1b697c5b837p-81, -0x1.da99d46e139a6p-83, 0x1.317d7f83a37e6p-84,
     -0x1.b1678ad00d611p-86, 0x1.48ca1f9137a36p-87, -0x1.0679e0ed36846p-88, 0x1.b27c1a3c6e71bp-90},
     /* [54] 1.75 <= y <= 1.875 2^-47, degree 10, 58.6 bits */
    {0x1.9aa9e4aa1585dp-49, -0x1.b6da3d27a96eap-104, 0x1.a7e92fd43bf3cp-50, 0x1.55a89e721dd3fp-75,
     -0x1.d63cf638262f3p-79, 0x1.6c0e27d7ca26cp-81, -0x1.77cc8b58b010cp-83, 0x1.c4933bdae43bbp-85,
     -0x1.2c537e4a67f63p-86, 0x1.aa44f2260abd3p-88, -0x1.3e45a66e0ea4ep-89, 0x1.ecd9830f6a982p-91},
     /* [55] 1.875 <= y <= 2 2^-47, degree 10, 60.1 bits */
    {0x1.c267c128efe7ep-49, -0x1.cd765e360687fp-103, 0x1.a7e93012d0ea4p-49, 0x1.463cce273aa1dp-73,
     -0x1.9964fe97bf32ep-76, 0x1.20fbfd3bb1d02p-77, -0x1.0ffc3906b293dp-78, 0x1.2aa6847f4257p-79,
     -0x1.6963b04bace3ep-80, 0x1.d3ae0be8a4216p-81, -0x1.3f809855e0e22p-81, 0x1.c33018b550681p-82},
     /* [56] 1 <= y <= 1.125 2^-46, degree 10, 58.1 bits */
    {0x1.f764e7304a732p-49, -0x1.e4527405e608cp-104, 0x1.a7e930621bb15p-49, 0x1.349701ae36eabp-73,
     -0x1.5a7c4671dff22p-76, 0x1.b5aa71173dfb9p-78, -0x1.708f86be0df21p-79, 0x1.6a183bff4478bp-80,
     -0x1.880a5a11fca3bp-81, 0x1.c5f0f3c558acp-82, -0x1.1531a9c883783p-82, 0x1.5e37ca01e7ffep-83},
     /* [57] 1.125 <= y <= 1.25 2^-46, degree 10, 58.8 bits */
    {0x1.163106a0a5b6cp-48, 0x1.b42501933d874p-104, 0x1.a7e930ad5364cp-49, 0x1.25870f42476a5p-73,
     -0x1.2a2f7a888feb1p-76, 0x1.54c889b6bcc9p-78, -0x1.03a4fa84d7e8cp-79, 0x1.cd9711fdc7117p-81,
     -0x1.c42b1e9da201dp-82, 0x1.d9b3350063c0cp-83, -0x1.05850b60d115fp-83, 0x1.2aef2b455e815p-84},
     /* [58] 1.25 <= y <= 1.375 2^-46, degree 10, 59.9 bits */
    {0x1.30af99adbcfb1p-48, -0x1.6228d48dda288p-102, 0x1.a7e930f509fd9p-49, 0x1.1879b1a7535ap-73,
     -0x1.04265fcd5e956p-76, 0x1.0f75f2b9b76d6p-78, -0x1.79af3a613df81p-80, 0x1.3286cab5f75a5p-81,
     -0x1.1228e5846059cp-82, 0x1.063d5b04d8432p-83, -0x1.083af7c395adp-84, 0x1.13c2b672ae01p-85},
     /* [59] 1.375 <= y <= 1.5 2^-46, degree 10, 58.2 bits */
    {0x1.4b2e2cbf36ae2p-48, 0x1.b4c5bbab18da9p-104, 0x1.a7e93139b2493p-49, 0x1.0d05c7511e82ap-73, -0x1.cb21353fad75p-77,
     0x1.b8c3b4f566671p-79, -0x1.1a16d96152885p-80, 0x1.a540d6ae6442fp-82, -0x1.5aa1759e244a1p-83,
     0x1.3108f1b79fc91p-84, -0x1.1aa4a66de02b5p-85, 0x1.0f5f559127ec4p-86},
     /* [60] 1.5 <= y <= 1.625 2^-46, degree 10, 60.5 bits */
    {0x1.65acbfd4e4e6cp-48, -0x1.036ef8565069p-102, 0x1.a7e9317ba8814p-49, 0x1.02ddfcc838a4bp-73, -0x1.99127008d19p-77,
     0x1.6b9e99a9aeed5p-79, -0x1.aef4dab7c0099p-81, 0x1.29f1f8a993ecep-82, -0x1.c602dd280537ep-84,
     0x1.71ef5a30858e2p-85, -0x1.3d4866dea7787p-86, 0x1.1a0f7178a766p-87},
     /* [61] 1.625 <= y <= 1.75 2^-46, degree 10, 60.6 bits */
    {0x1.802b52ee9ef25p-48, 0x1.931fcce67a11bp-102, 0x1.a7e931bb380f8p-49, 0x1.f390039554f36p-74,
     -0x1.6f7e11d547394p-77, 0x1.3021b40b7c09ep-79, -0x1.4f97f1bc3b7ffp-81, 0x1.b007481085909p-83,
     -0x1.3276976113d4ep-84, 0x1.d0fa88df40b97p-86, -0x1.73327f7895bebp-87, 0x1.333a25f1674fp-88},
     /* [62] 1.75 <= y <= 1.875 2^-46, degree 10, 60.2 bits */
    {0x1.9aa9e60c406a2p-48, -0x1.2ca4bfbd304dbp-102, 0x1.a7e931f89f8e6p-49, 0x1.e32dd6c7a9d2bp-74,
     -0x1.4c823430b919cp-77, 0x1.016d0d7f76431p-79, -0x1.09bae3c387c1dp-81, 0x1.4004daa30ec0dp-83,
     -0x1.a8b9af1358d68p-85, 0x1.2d6afe0e3c1b6p-86, -0x1.c21acd5c58b72p-88, 0x1.5c7f521530e7p-89},
     /* [63] 1.875 <= y <= 2 2^-46, degree 10, 58.9 bits */
    {0x1.c267c2bfbd993p-48, -0x1.4d9909f9c95e7p-102, 0x1.a7e9325120a7ap-48, 0x1.cd5ec968b806dp-72,
     -0x1.217c54b86635dp-74, 0x1.98af831df625p-76, -0x1.80a52edd05155p-77, 0x1.a65b057a6cebep-78,
     -0x1.ff14f2a3f6941p-79, 0x1.4ab31a5f53d2ap-79, -0x1.c3d833aaac4f2p-80, 0x1.3f09bba0f2455p-80},
     /* [64] 1 <= y <= 1.125 2^-45, degree 10, 59.7 bits */
    {0x1.f764e910f47bep-48, 0x1.e49b31c2d54f4p-102, 0x1.a7e932c143822p-48, 0x1.b469a75d31228p-72,
     -0x1.ea0125c729e6dp-75, 0x1.3579fa12aa1p-76, -0x1.049c9bc46a391p-77, 0x1.000a23bc83acp-78, -0x1.1536e7320a5f4p-79,
     0x1.40fc2452f2ea3p-80, -0x1.8802f36370393p-81, 0x1.ef4870164e51fp-82},
     /* [65] 1.125 <= y <= 1.25 2^-45, degree 10, 58.0 bits */
    {0x1.163107b7e88c7p-47, -0x1.459e45aeaffa3p-101, 0x1.a7e9332ba33a7p-48, 0x1.9f1c854586875p-72,
     -0x1.a5b2aee326921p-75, 0x1.e1f0c338f0083p-77, -0x1.6f3156653cdc6p-78, 0x1.4664bddc94d44p-79,
     -0x1.3fbb3bfc9334bp-80, 0x1.4ef4de57dfb6bp-81, -0x1.71d840359174dp-82, 0x1.a6c1c3c8b5462p-83},
     /* [66] 1.25 <= y <= 1.375 2^-45, degree 10, 61.6 bits */
    {0x1.30af9aedd43e9p-47, 0x1.ae1dace40de8p-102, 0x1.a7e933910e406p-48, 0x1.8ca71d87d7f5dp-72, -0x1.6fe85639519e4p-75,
     0x1.7fe74af7850f5p-77, -0x1.0b1033151ccb1p-78, 0x1.b17e7706022c4p-80, -0x1.83b87023178ebp-81,
     0x1.72dce819c360bp-82, -0x1.75ad9b5ececc9p-83, 0x1.85fc01213f6bfp-84},
     /* [67] 1.375 <= y <= 1.5 2^-45, degree 10, 58.8 bits */
    {0x1.4b2e2e29f34d9p-47, 0x1.28410c42891p-102, 0x1.a7e933f226eefp-48, 0x1.7c74c2a25c1abp-72, -0x1.44a75e5930a93p-75,
     0x1.37aae6a77eb7cp-77, -0x1.8eef3a0c0c086p-79, 0x1.29defe411a9a5p-80, -0x1.ea35b9d02a0fep-82,
     0x1.af627321546ebp-83, -0x1.8fb7c2c685c4ep-84, 0x1.7fc74eb834e77p-85},
     /* [68] 1.5 <= y <= 1.625 2^-45, degree 10, 62.5 bits */
    {0x1.65acc16c04cbcp-47, -0x1.0425c3bd6e379p-101, 0x1.a7e9344f6fb31p-48, 0x1.6e1819901fcdep-72,
     -0x1.2141f4e734631p-75, 0x1.011e2c36793dep-77, -0x1.30bb75711d27ep-79, 0x1.a55bb123d3a13p-81,
     -0x1.4108cefa9ad24p-82, 0x1.059562e0c4f0cp-83, -0x1.c0b4a80ab5894p-85, 0x1.8ee4c0144a45bp-86},
     /* [69] 1.625 <= y <= 1.75 2^-45, degree 10, 61.3 bits */
    {0x1.802b54b3cf2b1p-47, -0x1.3b4fe19a11519p-105, 0x1.a7e934a953335p-48, 0x1.613eaa9223664p-72,
     -0x1.03db4049ef9b2p-75, 0x1.ae1b6e5c7a003p-78, -0x1.da99d8bbdddebp-80, 0x1.317d81e3860ddp-81,
     -0x1.b1678dcea52fdp-83, 0x1.48ca21a1e6bc2p-84, -0x1.0679e272b81d4p-85, 0x1.b27c1c96376f1p-87},
     /* [70] 1.75 <= y <= 1.875 2^-45, degree 10, 61.1 bits */
    {0x1.9aa9e8011ef0cp-47, -0x1.49286caeb97efp-101, 0x1.a7e9350029f87p-48, 0x1.55a8efad794f1p-72,
     -0x1.d63cfe7c66f1ap-76, 0x1.6c0e2c1c0e506p-78, -0x1.77cc8edeb0a7ep-80, 0x1.c4933f7dfe062p-82,
     -0x1.2c53806fa063p-83, 0x1.aa44f4eab64fep-85, -0x1.3e45a85663fe2p-86, 0x1.ecd985d1341e6p-88},
     /* [71] 1.875 <= y <= 2 2^-45, degree 10, 60.1 bits */
    {0x1.c267c4ff0c67dp-47, 0x1.ca8abbb6c654cp-101, 0x1.a7e9357d5403ep-47, 0x1.463d1f1b91fbfp-70,
     -0x1.9965062145415p-73, 0x1.20fc00c7b622p-74, -0x1.0ffc3bb261d0ap-75, 0x1.2aa68702ba6ffp-76,
     -0x1.6963b2ffce981p-77, 0x1.d3ae0f16e9427p-78, -0x1.3f809a570d95ep-78, 0x1.c3301b59b5b4ap-79},
     /* [72] 1 <= y <= 1.125 2^-44, degree 10, 57.8 bits */
    {0x1.f764ebb8b7c6dp-47, 0x1.5957000ca4e46p-106, 0x1.a7e9361be9ba7p-47, 0x1.3497524d0bcd6p-70,
     -0x1.5a7c4d304a191p-73, 0x1.b5aa76c5132p-75, -0x1.708f8a917ade8p-76, 0x1.6a183f380c672p-77, -0x1.880a5d2bc2affp-78,
     0x1.c5f0f708e533ap-79, -0x1.1531ab9f40b93p-79, 0x1.5e37cc2d05c34p-80},
     /* [73] 1.125 <= y <= 1.25 2^-44, degree 10, 57.9 bits */
    {0x1.16310942d8049p-46, -0x1.54ec0b4785804p-101, 0x1.a7e936b259498p-47, 0x1.25875f942ac13p-70,
     -0x1.2a2f80a28e294p-73, 0x1.54c88e5cd5fe1p-75, -0x1.03a4fd5a3cd7dp-76, 0x1.cd97164f2424ep-78,
     -0x1.c42b226021125p-79, 0x1.d9b338950d115p-80, -0x1.05850d33c4ee3p-80, 0x1.2aef2d378dcd6p-81},
     /* [74] 1.25 <= y <= 1.375 2^-44, degree 10, 67.7 bits */
    {0x1.30af9cb281b66p-46, -0x1.00046a20766ecp-103, 0x1.a7e93741c6a32p-47, 0x1.187a01b346702p-70,
     -0x1.0426655f89421p-73, 0x1.0f75f699d7063p-75, -0x1.79af3eb185364p-77, 0x1.3286cdb628901p-78,
     -0x1.1228e7e71dfbap-79, 0x1.063d5d17ec5d4p-80, -0x1.083af9b15db07p-81, 0x1.13c2b853a954ap-82},
     /* [75] 1.375 <= y <= 1.5 2^-44, degree 10, 59.4 bits */
    {0x1.4b2e302af0485p-46, -0x1.fc9e7d1b36859p-103, 0x1.a7e937cb17627p-47, 0x1.0d06171cf72fp-70,
     -0x1.cb213f7fd2969p-74, 0x1.b8c3bb84ddae4p-76, -0x1.1a16dcbd36216p-77, 0x1.a540dafb0b03fp-79,
     -0x1.5aa178c332a91p-80, 0x1.3108f43bab75fp-81, -0x1.1aa4a89494c4dp-82, 0x1.0f5f577ea891p-83},
     /* [76] 1.5 <= y <= 1.625 2^-44, degree 10, 59.3 bits */
    {0x1.65acc3abc7e7cp-46, 0x1.72ce4a60e3695p-101, 0x1.a7e9384f03fa6p-47, 0x1.02de4c58e68d2p-70,
     -0x1.9912798694c0fp-74, 0x1.6b9e9f498dc21p-76, -0x1.aef4e00cf7de9p-78, 0x1.29f1fbd296128p-79,
     -0x1.c602e16fd5c6ep-81, 0x1.71ef5d5c3d362p-82, -0x1.3d48696121927p-83, 0x1.1a0f738dbc88bp-84},
     /* [77] 1.625 <= y <= 1.75 2^-44, degree 10, 59.4 bits */
    {0x1.802b5734b72fbp-46, 0x1.c5a0e4b65debdp-101, 0x1.a7e938ce233eap-47, 0x1.f390a248d0fdp-71, -0x1.6f7e1aab783a1p-74,
     0x1.3021b8eb99624p-76, -0x1.4f97f60a07067p-78, 0x1.b0074cd045716p-80, -0x1.32769a5fabd32p-81,
     0x1.d0fa8d00a157cp-83, -0x1.733282839a701p-84, 0x1.333a284b30d49p-85},
     /* [78] 1.75 <= y <= 1.875 2^-44, degree 10, 61.2 bits */
    {0x1.9aa9eac575527p-46, 0x1.13ab4f1723837p-100, 0x1.a7e93948f264p-47, 0x1.e32e75149ab87p-71, -0x1.4c823c74f737dp-74,
     0x1.016d11c3b9023p-76, -0x1.09bae7498a96cp-78, 0x1.4004de462356ap-80, -0x1.a8b9b35dc90acp-82,
     0x1.2d6b00d2e95aap-83, -0x1.c21ad12d05c38p-85, 0x1.5c7f54d6fb679p-86},
     /* [79] 1.875 <= y <= 2 2^-44, degree 10, 58.9 bits */
    {0x1.c267c82ca8821p-46, -0x1.f2ad97b5bbfeap-100, 0x1.a7e939f9f4d1bp-46, 0x1.cd5f6727a0d77p-69,
     -0x1.217c5c41e9f33p-71, 0x1.98af8a35fa90fp-73, -0x1.80a534346ae06p-74, 0x1.a65b0a815377ap-75,
     -0x1.ff14f80c36d63p-76, 0x1.4ab31d8d9aac3p-76, -0x1.c3d837ad08cf2p-77, 0x1.3f09be45590a5p-77},
     /* [80] 1 <= y <= 1.125 2^-43, degree 10, 57.7 bits */
    {0x1.f764ef7a0cbccp-46, -0x1.4fa63f432f7f1p-101, 0x1.a7e93ada3ad56p-46, 0x1.b46a44711543fp-69,
     -0x1.ea0133440199ap-72, 0x1.3579ffb9a43f2p-73, -0x1.049c9edc0d97ap-74, 0x1.000a8796b8e8p-75,
     -0x1.153aa4f765b42p-76, 0x1.3f1e282e0901dp-77, -0x1.81d22692782aap-78, 0x1.42465517198f2p-77},
     /* [81] 1.125 <= y <= 1.25 2^-43, degree 10, 60.8 bits */
    {0x1.16310b715e3adp-45, 0x1.b430f6ed3674ep-100, 0x1.a7e93baefa947p-46, 0x1.9f1d21bf87c45p-69,
     -0x1.a5b2bb171fb03p-72, 0x1.e1f0cc853b744p-74, -0x1.6f315c10a101dp-75, 0x1.4664c230629f9p-76,
     -0x1.3fbb3fc6ed034p-77, 0x1.4ef4e202395a5p-78, -0x1.71d84411be9b6p-79, 0x1.a6c1c8289a862p-80},
     /* [82] 1.25 <= y <= 1.375 2^-43, degree 10, 59.1 bits */
    {0x1.30af9f32b0e39p-45, -0x1.6173887c71543p-101, 0x1.a7e93c79d0ee6p-46, 0x1.8ca7b975f8e3ep-69,
     -0x1.6fe8615da260dp-72, 0x1.7fe752b7c5131p-74, -0x1.0b1037658178dp-75, 0x1.b17e7d078bba1p-77,
     -0x1.83b874ec84742p-78, 0x1.72dcec4ae8a9ep-79, -0x1.75ad9f5541e4dp-80, 0x1.85fc051e091c4p-81},
     /* [83] 1.375 <= y <= 1.5 2^-43, degree 10, 60.1 bits */
    {0x1.4b2e33006a4adp-45, 0x1.942994418d70bp-99, 0x1.a7e93d3c02996p-46, 0x1.7c755e10486b8p-69, -0x1.44a76899516b6p-72,
     0x1.37aaed36f31f2p-74, -0x1.8eef40c3d5fc8p-76, 0x1.29df028dfbe08p-77, -0x1.ea35c01c29547p-79,
     0x1.af62782f0a404p-80, -0x1.8fb7c721d0979p-81, 0x1.7fc752b10181ap-82},
     /* [84] 1.5 <= y <= 1.625 2^-43, degree 10, 59.5 bits */
    {0x1.65acc6da08955p-45, -0x1.320b7f2e6eaabp-101, 0x1.a7e93df6946f4p-46, 0x1.6e18b487b6c92p-69,
     -0x1.2141fe64f38b8p-72, 0x1.011e31d655bfdp-74, -0x1.30bb7ac64e66dp-76, 0x1.a55bb775e1fc3p-78,
     -0x1.4108d342c9f29p-79, 0x1.0595660ddadacp-80, -0x1.c0b4ad16e30c5p-82, 0x1.8ee4c44e1cdb3p-83},
     /* [85] 1.625 <= y <= 1.75 2^-43, degree 10, 60.1 bits */
    {0x1.802b5abf18a6fp-45, 0x1.a9aa3c2e7c20ap-100, 0x1.a7e93eaa5bbd2p-46, 0x1.613f451bdac93p-69,
     -0x1.03db49201cccep-72, 0x1.ae1b781cb222bp-75, -0x1.da99e1576850cp-77, 0x1.317d86a33f264p-78,
     -0x1.b16793cbdf481p-80, 0x1.48ca25c3d447fp-81, -0x1.0679e57f88f61p-82, 0x1.b27c215213779p-84},
     /* [86] 1.75 <= y <= 1.875 2^-43, degree 10, 58.7 bits */
    {0x1.9aa9eeaf338a2p-45, -0x1.40f43385c9e3cp-99, 0x1.a7e93f5809948p-46, 0x1.55a989d0a5bb2p-69,
     -0x1.d63d0f04dbc42p-73, 0x1.6c0e34a493073p-75, -0x1.77cc95eaac0b4p-77, 0x1.c49346c41deb4p-79,
     -0x1.2c5384b9fd88cp-80, 0x1.aa44fa7421d38p-82, -0x1.3e45ac27d227ap-83, 0x1.ecd98b58fea95p-85},
     /* [87] 1.875 <= y <= 2 2^-43, degree 10, 61.8 bits */
    {0x1.c267ccab47851p-45, 0x1.2f713b194c03dp-99, 0x1.a7e940525e1eep-45, 0x1.463db8b0b6958p-67, -0x1.9965153445412p-70,
     0x1.20fc07dfbc031p-71, -0x1.0ffc4109be45ep-72, 0x1.2aa68c09a2ae2p-73, -0x1.6963b867f7292p-74,
     0x1.d3ae15733be75p-75, -0x1.3f809e595beb5p-75, 0x1.c33020a3465cp-76},
     /* [88] 1 <= y <= 1.125 2^-42, degree 10, 58.0 bits */
    {0x1.f764f4c9950f8p-45, -0x1.1f6623f41fe4ep-100, 0x1.a7e9418f8a252p-45, 0x1.3497eb372c058p-67,
     -0x1.5a7c5aad12ed8p-70, 0x1.b5aa8220b8918p-72, -0x1.708f9238538fcp-73, 0x1.6a1845a999effp-74,
     -0x1.880a635f4080ap-75, 0x1.c5f0fd8fd194ep-76, -0x1.1531af4c88d21p-76, 0x1.5e37d082f9fc2p-77},
     /* [89] 1.125 <= y <= 1.25 2^-42, degree 10, 58.0 bits */
    {0x1.16310e873e39dp-44, 0x1.cd9f007919e5ep-99, 0x1.a7e942bc69dbep-45, 0x1.2587f7e46867fp-67, -0x1.2a2f8cd67fc2p-70,
     0x1.54c897a903e01p-72, -0x1.03a5030505b54p-73, 0x1.cd971ef1dfa0cp-75, -0x1.c42b29e51ab1ap-76,
     0x1.d9b33fbe4ba75p-77, -0x1.058510d98d51ap-77, 0x1.2aef311ba70f4p-78},
     /* [90] 1.25 <= y <= 1.375 2^-42, degree 10, 58.8 bits */
    {0x1.30afa2bc0d16cp-44, 0x1.cfb919eebeacbp-98, 0x1.a7e943db45273p-45, 0x1.187a9977a414bp-67, -0x1.04267083d4434p-70,
     0x1.0f75fe5a120cbp-72, -0x1.79af475211018p-74, 0x1.3286d3b68d02cp-75, -0x1.1228ecac991dfp-76,
     0x1.063d613e128dcp-77, -0x1.083afd8ce11bfp-78, 0x1.13c2bc1579f4ep-79},
     /* [91] 1.375 <= y <= 1.5 2^-42, degree 10, 58.9 bits */
    {0x1.4b2e370265bd7p-44, 0x1.e7a5bc0700d48p-100, 0x1.a7e944ede73d5p-45, 0x1.0d06ae6120794p-67,
     -0x1.cb21540009256p-71, 0x1.b8c3c8a3c4dc6p-73, -0x1.1a16e374f9dfcp-74, 0x1.a540e3945c94p-76,
     -0x1.5aa17f0d4f3cdp-77, 0x1.3108f943c44d2p-78, -0x1.1aa4ace1fcd7fp-79, 0x1.0f5f5b599b8a7p-80},
     /* [92] 1.5 <= y <= 1.625 2^-42, degree 10, 58.6 bits */
    {0x1.65accb599088ap-44, -0x1.96dbd6ff5a487p-98, 0x1.a7e945f5c1043p-45, 0x1.02dee326bac3p-67, -0x1.99128c8208483p-71,
     0x1.6b9eaa89453e2p-73, -0x1.aef4eab75f13p-75, 0x1.29f202249ea5cp-76, -0x1.c602e9ff754cep-78, 0x1.71ef63b3ae084p-79,
     -0x1.3d486e661a308p-80, 0x1.1a0f77b7e6a54p-81}, /* [93] 1.625 <= y <= 1.75 2^-42, degree 10, 60.5 bits */
    {0x1.802b5fc0eaae2p-44, 0x1.f35d23b8091d3p-98, 0x1.a7e946f400235p-45, 0x1.f391cf08bab83p-68, -0x1.6f7e2c57c8103p-71,
     0x1.3021c2abcf59p-73, -0x1.4f97fea593f0bp-75, 0x1.b007564fce893p-77, -0x1.3276a05cda0a5p-78, 0x1.d0fa9543614e1p-80,
     -0x1.73328899a97b4p-81, 0x1.333a2cfecb00ep-82}, /* [94] 1.75 <= y <= 1.875 2^-42, degree 10, 60.1 bits */
    {0x1.9aa9f437e292cp-44, -0x1.e2854c7874d74p-99, 0x1.a7e947e99f045p-45, 0x1.e32fa1076f02fp-68,
     -0x1.4c824cfd61c4ep-71, 0x1.016d1a4c3b7ffp-73, -0x1.09baee55844cdp-75, 0x1.4004e58c5681p-77,
     -0x1.a8b9bbf2a7243p-79, 0x1.2d6b065c408ecp-80, -0x1.c21ad8ce63675p-82, 0x1.5c7f5a5a9a315p-83},
     /* [95] 1.875 <= y <= 2 2^-42, degree 10, 58.8 bits */
    {0x1.c267d30682721p-44, 0x1.c80060ca98587p-100, 0x1.a7e9494ba4c03p-44, 0x1.cd6091fe66327p-66,
     -0x1.217c6b54e0064p-68, 0x1.98af986603ad9p-70, -0x1.80a53ee318cdcp-71, 0x1.a65b148f3532ap-72,
     -0x1.ff1502dcb8071p-73, 0x1.4ab323ea219a7p-73, -0x1.c3d83fb1bdfb1p-74, 0x1.3f09c38e2bffep-74},
     /* [96] 1 <= y <= 1.125 2^-41, degree 10, 58.2 bits */
    {0x1.f764fc4c425dcp-44, -0x1.42e578e909d45p-98, 0x1.a7e94b0c31f1bp-44, 0x1.b46b6df1d2b88p-66,
     -0x1.ea014e3d78efep-69, 0x1.357a0b1c1f182p-70, -0x1.049ca73eabbddp-71, 0x1.000a2d66d6851p-72,
     -0x1.1536f07f560cfp-73, 0x1.40fc2e1d938edp-74, -0x1.8802fe6bde8f1p-75, 0x1.ef487d1907778p-76},
     /* [97] 1.125 <= y <= 1.25 2^-41, degree 10, 61.5 bits */
    {0x1.163112e44cb58p-43, -0x1.718fd668ff0ep-99, 0x1.a7e94cb5b298cp-44, 0x1.9f1e4a0c80ee7p-66, -0x1.a5b2d37ef090bp-69,
     0x1.e1f0df1d7549fp-71, -0x1.6f31676592bcdp-72, 0x1.4664cad0a6d14p-73, -0x1.3fbb474407d89p-74,
     0x1.4ef4e915d440cp-75, -0x1.71d84b2743907p-76, 0x1.a6c1cf75d021ap-77},
     /* [98] 1.25 <= y <= 1.375 2^-41, degree 10, 58.5 bits */
    {0x1.30afa7bc6de73p-43, 0x1.93c469cca7683p-99, 0x1.a7e94e4b60745p-44, 0x1.8ca8e0ab32d4ep-66, -0x1.6fe877a6284f6p-69,
     0x1.7fe7623832d39p-71, -0x1.0b104005ec26cp-72, 0x1.b17e89072502dp-74, -0x1.83b87e737e599p-75,
     0x1.72dcf48c321ffp-76, -0x1.75ada6f177837p-77, 0x1.85fc0c671e9ccp-78},
     /* [99] 1.375 <= y <= 1.5 2^-41, degree 10, 58.6 bits */
    {0x1.4b2e3cad5ca87p-43, 0x1.03a33d1b77b0ap-99, 0x1.a7e94fcfc4f11p-44, 0x1.7c7684451a645p-66, -0x1.44a77d19788e4p-69,
     0x1.37aafa55d6a43p-71, -0x1.8eef4e3355c1cp-73, 0x1.29df0b270e503p-74, -0x1.ea35ccae72581p-76,
     0x1.af6282398d7cfp-77, -0x1.8fb7cfaeb7dbap-78, 0x1.7fc75a4931e05p-79},
     /* [100] 1.5 <= y <= 1.625 2^-41, degree 10, 59.2 bits */
    {0x1.65acd1b615427p-43, 0x1.5c542bbc8fbfap-97, 0x1.a7e95144e9c28p-44, 0x1.6e19d9cfdf4fbp-66, -0x1.214211605815dp-69,
     0x1.011e3d1609b01p-71, -0x1.30bb8570b880bp-73, 0x1.a55bc419e443ep-75, -0x1.4108dbd203e52p-76,
     0x1.05956c63e336fp-77, -0x1.c0b4b71985fabp-79, 0x1.8ee4cc92c09d7p-80},
     /* [101] 1.625 <= y <= 1.75 2^-41, degree 10, 59.9 bits */
    {0x1.802b66d5b17d2p-43, 0x1.a20bf5859bb3fp-97, 0x1.a7e952ac79831p-44, 0x1.6140698845504p-66, -0x1.03db5acc5e1ffp-69,
     0x1.ae1b8b9d15eabp-72, -0x1.da99f28e88b85p-74, 0x1.317d9022cc5d8p-75, -0x1.b1679fc62b25cp-77,
     0x1.48ca2e05fcc57p-78, -0x1.0679eb93be2f9p-79, 0x1.b27c2ab0e64bfp-81},
     /* [102] 1.75 <= y <= 1.875 2^-41, degree 10, 59.8 bits */
    {0x1.9aa9fc0b636d2p-43, 0x1.300c8614ea247p-97, 0x1.a7e95407d655ep-44, 0x1.55aaad6ffb7c7p-66, -0x1.d63d301594ebcp-70,
     0x1.6c0e45b58ef6ap-72, -0x1.77cca402a4811p-74, 0x1.c49355508a1ecp-76, -0x1.2c538d4eebeb2p-77, 0x1.aa450586b59cp-79,
     -0x1.3e45b3c8603bep-80, 0x1.ecd9965be63fbp-82}, /* [103] 1.875 <= y <= 2 2^-41, degree 10, 61.1 bits */
    {0x1.c267dc03c5c3cp-43, 0x1.e7e998993ec17p-97, 0x1.a7e955fc811f3p-43, 0x1.463edb33fe5afp-64, -0x1.9965335a1741cp-67,
     0x1.20fc160fbaf86p-68, -0x1.0ffc4bb87115p-69, 0x1.2aa6961780553p-70, -0x1.6963c3388e725p-71, 0x1.d3ae222c80362p-72,
     -0x1.3f80a65e16361p-72, 0x1.c3302b34104f3p-73}, /* [104] 1 <= y <= 1.125 2^-40, degree 10, 58.1 bits */
    {0x1.f76506eb59991p-43, -0x1.72e4bace754a3p-97, 0x1.a7e95876db6f5p-43, 0x1.34990c646d1dep-64,
     -0x1.5a7c75a679849p-67, 0x1.b5aa98d7ee525p-69, -0x1.708fa185f6995p-70, 0x1.6a18528cae376p-71,
     -0x1.880a6fc658813p-72, 0x1.c5f10a9e26408p-73, -0x1.1531b6a7acd7bp-73, 0x1.5e37d92fb5167p-74},
     /* [105] 1.125 <= y <= 1.25 2^-40, degree 10, 59.5 bits */
    {0x1.1631191010b51p-42, -0x1.932c7d21afeb3p-97, 0x1.a7e95ad09d1e1p-43, 0x1.258917dde6539p-64,
     -0x1.2a2fa53e3a43dp-67, 0x1.54c8aa414e73bp-69, -0x1.03a50e5a8cbd9p-70, 0x1.cd97303741bdap-72,
     -0x1.c42b38ef070a6p-73, 0x1.d9b34e10f6a3bp-74, -0x1.0585182577d69p-74, 0x1.2aef38e4a6dbbp-75},
     /* [106] 1.25 <= y <= 1.375 2^-40, degree 10, 58.9 bits */
    {0x1.30afaecf2b175p-42, 0x1.e55d4bba1038ep-98, 0x1.a7e95d0e55f38p-43, 0x1.187bb85963d81p-64, -0x1.042686cc438cbp-67,
     0x1.0f760dda79b07p-69, -0x1.79af58931a165p-71, 0x1.3286dfb7467cp-72, -0x1.1228f637817c2p-73, 0x1.063d698a5a8d9p-74,
     -0x1.083b054407fbp-75, 0x1.13c2c3998a407p-76}, /* [107] 1.375 <= y <= 1.5 2^-40, degree 10, 59.8 bits */
    {0x1.4b2e44b15930ep-42, 0x1.715b8912ef94ep-98, 0x1.a7e95f339c5c7p-43, 0x1.0d07cc42794e6p-64, -0x1.cb217d002c2bap-68,
     0x1.b8c3e2e17a23cp-70, -0x1.1a16f0e47799p-71, 0x1.a540f4c6eb4eap-73, -0x1.5aa18ba175422p-74, 0x1.31090353e23f7p-75,
     -0x1.1aa4b57cc7e2bp-76, 0x1.0f5f630fa85c3p-77}, /* [108] 1.5 <= y <= 1.625 2^-40, degree 10, 59.2 bits */
    {0x1.65acdab52bb72p-42, 0x1.e1550e0a88b98p-96, 0x1.a7e9614352251p-43, 0x1.02e0001b6b22ep-64, -0x1.9912b278a836bp-68,
     0x1.6b9ec1089da8p-70, -0x1.aef5000c2049dp-72, 0x1.29f20ec8a1cep-73, -0x1.c602fb1e9ef8cp-75, 0x1.71ef706274df2p-76,
     -0x1.3d48786ff18ep-77, 0x1.1a0f800c356ecp-78}, /* [109] 1.625 <= y <= 1.75 2^-40, degree 10, 62.0 bits */
    {0x1.802b70d95d15ep-42, -0x1.b2ea6edd5e9d5p-96, 0x1.a7e9633fd29c5p-43, 0x1.f394073aa15cp-65, -0x1.6f7e4fb023516p-68,
     0x1.3021d62c26692p-70, -0x1.4f980fdca51aep-72, 0x1.b007694ecba85p-74, -0x1.3276ac572b27p-75, 0x1.d0faa5c8c4cf1p-77,
     -0x1.733294c5a3c0dp-78, 0x1.333a3665e11a7p-79}, /* [110] 1.75 <= y <= 1.875 2^-40, degree 10, 60.8 bits */
    {0x1.9aaa071cca162p-42, -0x1.537e5994c01bcp-96, 0x1.a7e9652b1295bp-43, 0x1.e331d79f2deaep-65,
     -0x1.4c826e0df4fd1p-68, 0x1.016d2b5d2caefp-70, -0x1.09bafc6d729fep-72, 0x1.4004f418ab7d1p-74,
     -0x1.a8b9cd1c56b7fp-76, 0x1.2d6b116ee1c47p-77, -0x1.c21ae810f8044p-79, 0x1.5c7f6561ad0d5p-80},
     /* [111] 1.875 <= y <= 2 2^-40, degree 10, 59.4 bits */
    {0x1.c267e8ba45e9dp-42, -0x1.b278f0077ae6p-96, 0x1.a7e967ef215dbp-42, 0x1.cd62c65e0bbc8p-63, -0x1.217c897a8deccp-65,
     0x1.98afb4c5efa0ap-67, -0x1.80a5544073484p-68, 0x1.a65b28aadc0a6p-69, -0x1.ff15187dac38dp-70,
     0x1.4ab330a328aa6p-70, -0x1.c3d84fbb101cep-71, 0x1.3f09ce1fb0295p-71},
     /* [112] 1 <= y <= 1.125 2^-39, degree 10, 57.8 bits */
    {0x1.f76515f0c1033p-42, 0x1.df6f107f17c33p-97, 0x1.a7e96b704026bp-42, 0x1.b46d9fa56e316p-63, -0x1.ea018430020b6p-66,
     0x1.357a21d3458b8p-67, -0x1.049cb68c47f5cp-68, 0x1.000a3a49e51d1p-69, -0x1.1536fce65e541p-70,
     0x1.40fc3b2bb83a8p-71, -0x1.88030d21ba81dp-72, 0x1.ef488e71e0f72p-73},
     /* [113] 1.125 <= y <= 1.25 2^-39, degree 10, 58.8 bits */
    {0x1.163121ca35762p-41, -0x1.6d2761fd9b258p-98, 0x1.a7e96ec345d5cp-42, 0x1.9f2079589928dp-63,
     -0x1.a5b3044e25165p-66, 0x1.e1f1044def9f2p-68, -0x1.6f317e1095d15p-69, 0x1.4664dc16044f4p-70,
     -0x1.3fbb564deeb4fp-71, 0x1.4ef4f768694a1p-72, -0x1.71d859bed588ep-73, 0x1.a6c1df073ce68p-74},
     /* [114] 1.25 <= y <= 1.375 2^-39, degree 10, 59.4 bits */
    {0x1.30afb8cff606bp-41, 0x1.56d52dfb855a1p-96, 0x1.a7e971eea5e95p-42, 0x1.8cab0dc7d1b14p-63, -0x1.6fe8a436c98a4p-66,
     0x1.7fe78138ea7a3p-68, -0x1.0b105146ebbb6p-69, 0x1.b17ea10890b0ap-71, -0x1.83b891894de3p-72, 0x1.72dd0524bd481p-73,
     -0x1.75adb65fa91ap-74, 0x1.85fc1b6eee032p-75}, /* [115] 1.375 <= y <= 1.5 2^-39, degree 10, 59.1 bits */
    {0x1.4b2e500751fcp-41, 0x1.7b860faae7af7p-96, 0x1.a7e974f7733afp-42, 0x1.7c78af60ee335p-63, -0x1.44a7a61961035p-66,
     0x1.37ab1493770d4p-68, -0x1.8eef691240dbap-70, 0x1.29df1c5996241p-71, -0x1.ea35e5d6bc67ep-73,
     0x1.af629659ccb88p-74, -0x1.8fb7e0e449cb1p-75, 0x1.7fc769b52b30dp-76},
     /* [116] 1.5 <= y <= 1.625 2^-39, degree 10, 60.9 bits */
    {0x1.65ace76e41e84p-41, 0x1.1f9dfadf56426p-97, 0x1.a7e977e1c1323p-42, 0x1.6e1c031264e4p-63, -0x1.21423756bfe84p-66,
     0x1.011e53954f96fp-68, -0x1.30bb9ac56bdaap-70, 0x1.a55bdd61de047p-72, -0x1.4108ecf129f6cp-73,
     0x1.05957912ac7fbp-74, -0x1.c0b4cb2d3cc02p-76, 0x1.8ee4dd3b5aec3p-77},
     /* [117] 1.625 <= y <= 1.75 2^-39, degree 10, 59.5 bits */
    {0x1.802b7f02f95bp-41, 0x1.455c384dbf897p-97, 0x1.a7e97ab0e5041p-42, 0x1.61429113535c9p-63, -0x1.03db7e248374ap-66,
     0x1.ae1bb29da3p-69, -0x1.da9a14fc93b6ap-71, 0x1.317da321beaf8p-72, -0x1.b167b7bac4d62p-74, 0x1.48ca3e8b60ebcp-75,
     -0x1.0679f7bfbe88fp-76, 0x1.b27c3d7f1e71ep-78}, /* [118] 1.75 <= y <= 1.875 2^-39, degree 10, 59.4 bits */
    {0x1.9aaa16c3dc7d5p-41, -0x1.5164d497d3ed9p-96, 0x1.a7e97d67a2f73p-42, 0x1.55acd360e448p-63, -0x1.d63d7236536d7p-67,
     0x1.6c0e67d753a2dp-69, -0x1.77ccc0326d848p-71, 0x1.c4937269222f9p-73, -0x1.2c539e789351cp-74,
     0x1.aa451babf4851p-76, -0x1.3e45c30afa19ap-77, 0x1.ecd9ac6a1e2ecp-79},
     /* [119] 1.875 <= y <= 2 2^-39, degree 10, 59.4 bits */
    {0x1.c267fab4e08eep-41, 0x1.a6ef03bfb5df8p-99, 0x1.a7e98150fef83p-41, 0x1.4640feecd1583p-61, -0x1.99656fa5104bdp-64,
     0x1.20fc326f8d4b1p-65, -0x1.0ffc6115bc417p-66, 0x1.2aa6aa331a165p-67, -0x1.6963d8d975d9ep-68, 0x1.d3ae3b9e83dap-69,
     -0x1.3f80b667681c3p-69, 0x1.c3304057249f9p-70}, /* [120] 1 <= y <= 1.125 2^-38, degree 10, 57.9 bits */
    {0x1.f7652b2f08595p-41, 0x1.6656263a8d0a9p-95, 0x1.a7e98645bc22p-41, 0x1.349b2d713a86fp-61, -0x1.5a7cab98a5bafp-64,
     0x1.b5aac6461032cp-66, -0x1.708fc021186b8p-67, 0x1.6a186c52ba416p-68, -0x1.880a889458ea6p-69,
     0x1.c5f124ba5fc82p-70, -0x1.1531c55d82b25p-70, 0x1.5e37ea888e8d1p-71},
     /* [121] 1.125 <= y <= 1.25 2^-38, degree 10, 58.4 bits */
    {0x1.16312e21cc95fp-40, 0x1.bb8bd43f4dd67p-94, 0x1.a7e98af947fecp-41, 0x1.258b368334ba4p-61, -0x1.2a2fd60d16ddbp-64,
     0x1.54c8cf71a3f1fp-66, -0x1.03a525057e811p-67, 0x1.cd9752c1e5946p-69, -0x1.c42b5702c1082p-70,
     0x1.d9b36ab60d7cep-71, -0x1.058526bd00a53p-71, 0x1.2aef48760ceebp-72},
     /* [122] 1.25 <= y <= 1.375 2^-38, degree 10, 59.1 bits */
    {0x1.30afc6f5827a7p-40, -0x1.f686c8c36bf94p-94, 0x1.a7e98f74c21fdp-41, 0x1.187dd4cf3ce56p-61,
     -0x1.0426b35c9126bp-64, 0x1.0f762cdb114f1p-66, -0x1.79af7b14fde86p-68, 0x1.3286f7b8a1e1cp-69,
     -0x1.1229094d44b47p-70, 0x1.063d7a22da928p-71, -0x1.083b14b22ebb1p-72, 0x1.13c2d2a14fc3dp-73},
     /* [123] 1.375 <= y <= 1.5 2^-38, degree 10, 61.5 bits */
    {0x1.4b2e600f60549p-40, -0x1.9996a640cbad4p-95, 0x1.a7e993bf575f7p-41, 0x1.0d09e6b78b22dp-61,
     -0x1.cb21ceff5d56dp-65, 0x1.b8c4175c8295p-67, -0x1.1a170bc34c964p-68, 0x1.a541172be3205p-70,
     -0x1.5aa1a4c9af4aep-71, 0x1.31091774146f2p-72, -0x1.1aa4c6b24dc02p-73, 0x1.0f5f727b96416p-74},
     /* [124] 1.5 <= y <= 1.625 2^-38, degree 10, 58.6 bits */
    {0x1.65acf96c878ecp-40, -0x1.b2d2301fb3af6p-95, 0x1.a7e997decb56cp-41, 0x1.02e218b73266ep-61,
     -0x1.9912fe64dec11p-65, 0x1.6b9eee06f75b1p-67, -0x1.aef52ab5628c8p-69, 0x1.29f2281089853p-70,
     -0x1.c6031d5cd54a8p-72, 0x1.71ef89bff797ap-73, -0x1.3d488c839adf9p-74, 0x1.1a0f90b4c365ep-75},
     /* [125] 1.625 <= y <= 1.75 2^-38, degree 10, 58.8 bits */
    {0x1.802b930a6cfffp-40, -0x1.2f02eaebac511p-94, 0x1.a7e99bd7d4a44p-41, 0x1.f398350347dcep-62,
     -0x1.6f7e965fdacddp-65, 0x1.3021fd2c86991p-67, -0x1.4f98324a919f2p-69, 0x1.b0078f4c94472p-71,
     -0x1.3276c44bb55e9p-72, 0x1.d0fac6d378f68p-74, -0x1.7332ad1d9506ap-75, 0x1.333a49340c01bp-76},
     /* [126] 1.75 <= y <= 1.875 2^-38, degree 10, 63.1 bits */
    {0x1.9aaa2ce6ca39fp-40, 0x1.9df0a278850c6p-95, 0x1.a7e99fae5cef4p-41, 0x1.e336023390afep-62, -0x1.4c82b02e25a66p-65,
     0x1.016d4d7ec8d7ap-67, -0x1.09bb189d21d7bp-69, 0x1.400511312d572p-71, -0x1.a8b9ef6f8ed18p-73,
     0x1.2d6b279413471p-74, -0x1.c21b0696194fcp-76, 0x1.5c7f7b6fd67a4p-77},
     /* [127] 1.875 <= y <= 2 2^-38, degree 10, 58.6 bits */
    {0x1.c268142207b17p-40, 0x1.4f37c28e2d229p-94, 0x1.a7e9a53686f86p-40, 0x1.cd66ec824c9cfp-60, -0x1.217cc5c50030ep-62,
     0x1.98afed854e055p-64, -0x1.80a57efae0b58p-65, 0x1.a65b50e1ef425p-66, -0x1.ff1543bf5d129p-67,
     0x1.4ab34a151ca66p-67, -0x1.c3d86fcda1475p-68, 0x1.3f09e342b7d1ap-68},
     /* [128] 1 <= y <= 1.125 2^-37, degree 10, 58.2 bits */
    {0x1.f765493a0775p-40, -0x1.1674e2773df54p-94, 0x1.a7e9ac38d518p-40, 0x1.b471c071b0288p-60, -0x1.ea01f0135d07dp-63,
     0x1.357a4f412c4a8p-64, -0x1.049cd5274ae1p-65, 0x1.000a540fdb2bep-66, -0x1.153715b44c634p-67, 0x1.40fc5547e0ceap-68,
     -0x1.88032a8d5504p-69, 0x1.ef48b12380856p-70}, /* [129] 1.125 <= y <= 1.25 2^-37, degree 10, 59.7 bits */
    {0x1.16313f9633741p-39, 0x1.cefbf0feb169p-93, 0x1.a7e9b2def0ef8p-40, 0x1.9f249555e8a84p-60, -0x1.a5b365eaee865p-63,
     0x1.e1f14eae355dbp-65, -0x1.6f31ab66496cp-66, 0x1.4664fea089224p-67, -0x1.3fbb7461910d6p-68, 0x1.4ef5140d6c4acp-69,
     -0x1.71d876edd53b5p-70, 0x1.a6c1fe29f7a7dp-71}, /* [130] 1.25 <= y <= 1.375 2^-37, degree 10, 60.1 bits */
    {0x1.30afdaf73b6cdp-39, -0x1.bebdd477fde57p-95, 0x1.a7e9b935c17dcp-40, 0x1.8caf25664172ep-60,
     -0x1.6fe8fd5680c47p-63, 0x1.7fe7bf39c1d0dp-65, -0x1.0b1073c8a98f9p-66, 0x1.b17ed10b1a70ap-68,
     -0x1.83b8b7b4b4b66p-69, 0x1.72dd2655a4dafp-70, -0x1.75add53be2675p-71, 0x1.85fc397e67789p-72},
     /* [131] 1.375 <= y <= 1.5 2^-37, degree 10, 60.2 bits */
    {0x1.4b2e76bb7b34fp-39, -0x1.d89b138607799p-93, 0x1.a7e9bf476c775p-40, 0x1.7c7cc2fdd9f3cp-60,
     -0x1.44a7f817b880bp-63, 0x1.37ab490e3244dp-65, -0x1.8eef9ecfad738p-67, 0x1.29df3ebe6c6f2p-68,
     -0x1.ea36182704edp-70, 0x1.af62be9a11c7bp-71, -0x1.8fb8034f3d868p-72, 0x1.7fc7888cf3c99p-73},
     /* [132] 1.5 <= y <= 1.625 2^-37, degree 10, 58.6 bits */
    {0x1.65ad12dee3efcp-39, 0x1.e5e550c1e9f03p-93, 0x1.a7e9c51c18accp-40, 0x1.6e2012fcc57ffp-60, -0x1.2142834225dc5p-63,
     0x1.011e809364c22p-65, -0x1.30bbc56e7bb55p-67, 0x1.a55c0ff17a75fp-69, -0x1.41090f2f41833p-70,
     0x1.059592701a916p-71, -0x1.c0b4f35471c57p-73, 0x1.8ee4fe8c60be4p-74},
     /* [133] 1.625 <= y <= 1.75 2^-37, degree 10, 59.8 bits */
    {0x1.802baf5ddcbbap-39, 0x1.a31b23f441ebbp-93, 0x1.a7e9caba70895p-40, 0x1.61469d8ed587p-60, -0x1.03dbc4d372753p-63,
     0x1.ae1c009de8b16p-66, -0x1.da9a59d818c99p-68, 0x1.317dc91f5fcadp-69, -0x1.b167e7a3accacp-71,
     0x1.48ca5f95f91f6p-72, -0x1.067a10179cf8cp-73, 0x1.b27c631b59ca1p-75},
     /* [134] 1.75 <= y <= 1.875 2^-37, degree 10, 58.8 bits */
    {0x1.9aaa4c352de9cp-39, -0x1.40d64a265045cp-94, 0x1.a7e9d027fc9bp-40, 0x1.55b0dca82beffp-60, -0x1.d63df6753257ep-64,
     0x1.6c0eac1a1d524p-66, -0x1.77ccf89185298p-68, 0x1.c493ac99e79cbp-70, -0x1.2c53c0cbaa9d7p-71,
     0x1.aa4547f630d44p-73, -0x1.3e45e19002cfdp-74, 0x1.ecd9d8865064bp-76},
     /* [135] 1.875 <= y <= 2 2^-37, degree 10, 60.3 bits */
    {0x1.c2683817884f4p-39, 0x1.2548729427725p-96, 0x1.a7e9d7faccc73p-39, 0x1.464503c404584p-58, -0x1.9965e83885ba4p-61,
     0x1.20fc6b2e8bce6p-62, -0x1.0ffc8bcff1c5cp-63, 0x1.2aa6d26a0086dp-64, -0x1.6964041afbb97p-65,
     0x1.d3ae6e823d771p-66, -0x1.3f80d679de29cp-66, 0x1.c3306a9d12b3bp-67},
     /* [136] 1 <= y <= 1.125 2^-36, degree 10, 58.0 bits */
    {0x1.f76573b6f3c08p-39, 0x1.cc54b319e119fp-94, 0x1.a7e9e1e4672bap-39, 0x1.349f2cf07f4b3p-58, -0x1.5a7d177aa7997p-61,
     0x1.b5ab21213c45cp-63, -0x1.708ffd56ca0f1p-64, 0x1.6a189fde6a222p-65, -0x1.880aba30016a9p-66,
     0x1.c5f158f27f21bp-67, -0x1.1531e2c9030b4p-67, 0x1.5e380d3a111efp-68},
     /* [137] 1.125 <= y <= 1.25 2^-36, degree 10, 58.6 bits */
    {0x1.163158459aa0dp-38, -0x1.127ba78888aa9p-92, 0x1.a7e9eb4b9ecd9p-39, 0x1.258f313396c14p-58,
     -0x1.2a3037a899daap-61, 0x1.54c919d15f729p-63, -0x1.03a5525af0db6p-64, 0x1.cd9797d69ad7cp-66,
     -0x1.c42b9329c4713p-67, 0x1.d9b3a3ffda9c1p-68, -0x1.058543ebe5503p-68, 0x1.2aef6798ac78ap-69},
     /* [138] 1.25 <= y <= 1.375 2^-36, degree 10, 58.7 bits */
    {0x1.30aff7429855p-38, -0x1.ad519792a181cp-93, 0x1.a7e9f442b2d38p-39, 0x1.1881cb20ce193p-58, -0x1.04270c7b12079p-61,
     0x1.0f766adb70936p-63, -0x1.79afc0181209bp-65, 0x1.328727baee8ap-66, -0x1.12292f788073fp-67, 0x1.063d9b539ff3ep-68,
     -0x1.083b338e4a6b9p-69, 0x1.13c2f0b0adf96p-70}, /* [139] 1.375 <= y <= 1.5 2^-36, degree 10, 60.8 bits */
    {0x1.4b2e96cbe7efcp-38, 0x1.1d39cd49e67f6p-94, 0x1.a7e9fcd7fcf5p-39, 0x1.0d0dd907a68b7p-58, -0x1.cb2272f9bbc15p-62,
     0x1.b8c4805125fb2p-64, -0x1.1a1741806572p-65, 0x1.a5415bf534cc8p-67, -0x1.5aa1d719bce76p-68, 0x1.31093fb42e907p-69,
     -0x1.1aa4e91d1f5dp-70, 0x1.0f5f915341ff6p-71}, /* [140] 1.5 <= y <= 1.625 2^-36, degree 10, 61.4 bits */
    {0x1.65ad36dbcc43cp-38, 0x1.ce2e88d0ed1c6p-92, 0x1.a7ea051704674p-39, 0x1.02e60754d0425p-58, -0x1.9913963972f1fp-62,
     0x1.6b9f480266646p-64, -0x1.aef58006f8937p-66, 0x1.29f25a9fe0be5p-67, -0x1.c60361d8b161fp-69,
     0x1.71efbc7a9bd05p-70, -0x1.3d48b4aaa6d81p-71, 0x1.1a0fb205a9227p-72},
     /* [141] 1.625 <= y <= 1.75 2^-36, degree 10, 62.4 bits */
    {0x1.802bd76d2efd2p-38, -0x1.aa0910b1903bfp-93, 0x1.a7ea0d0936694p-39, 0x1.f3a00b60e0c5fp-59,
     -0x1.6f7f23bb973d7p-62, 0x1.30224b2c24a35p-64, -0x1.4f987725a3e9fp-66, 0x1.b007db476aff8p-68,
     -0x1.3276f4346155dp-69, 0x1.d0fb08e85e343p-71, -0x1.7332ddcd1ea23p-72, 0x1.333a6ed0221f9p-73},
     /* [142] 1.75 <= y <= 1.875 2^-36, degree 10, 59.8 bits */
    {0x1.9aaa787b833dcp-38, -0x1.6d66818dfb37p-94, 0x1.a7ea14b6664bdp-39, 0x1.e33dd228cdad5p-59, -0x1.4c83346af6e51p-62,
     0x1.016d91c0fb5a9p-64, -0x1.09bb50fbd8a24p-66, 0x1.40054b619de12p-68, -0x1.a8ba341564c61p-70,
     0x1.2d6b53de1bae7p-71, -0x1.c21b439fe89b4p-73, 0x1.5c7fa78bdbda7p-74},
     /* [143] 1.875 <= y <= 2 2^-36, degree 10, 60.0 bits */
    {0x1.c2686af26888ap-38, 0x1.ad055bc7281f9p-93, 0x1.a7ea1fc6e922bp-38, 0x1.cd6eb397844dap-57, -0x1.217d3e5682545p-59,
     0x1.98b05f0245141p-61, -0x1.80a5d46eb2a92p-62, 0x1.a65ba14f41ba1p-63, -0x1.ff159a41f43d1p-64, 0x1.4ab37cf8980dp-64,
     -0x1.c3d8aff245081p-65, 0x1.3f0a0d8879438p-65}, /* [144] 1 <= y <= 1.125 2^-35, degree 10, 57.8 bits */
    {0x1.f765afcda757ap-38, 0x1.223556929b887p-92, 0x1.a7ea2dcbc36f2p-38, 0x1.b4797cd738be1p-57, -0x1.ea02c7d3b63cbp-60,
     0x1.357aaa1b7bf11p-61, -0x1.049d125c893cfp-62, 0x1.000a879b3881bp-63, -0x1.1537474fae7efp-64,
     0x1.40fc897fbcef3p-65, -0x1.880365640fe38p-66, 0x1.ef48f68638bf1p-67},
     /* [145] 1.125 <= y <= 1.25 2^-35, degree 10, 57.9 bits */
    {0x1.16317b2ed6a14p-37, -0x1.4aded43fa688fp-92, 0x1.a7ea3b1838da2p-38, 0x1.9f2c481dd687fp-57,
     -0x1.a5b4291e7cf0cp-60, 0x1.e1f1e36c32f98p-62, -0x1.6f3206107b878p-63, 0x1.466543b4caa1ap-64,
     -0x1.3fbbb0883b0f6p-65, 0x1.4ef54d56ec214p-66, -0x1.71d8b14b56007p-67, 0x1.a6c23c6eee7dbp-68},
     /* [146] 1.25 <= y <= 1.375 2^-35, degree 10, 60.1 bits */
    {0x1.30b01f468dee5p-37, 0x1.103051d18549ap-93, 0x1.a7ea47c617697p-38, 0x1.8cb6cf70b638fp-57, -0x1.6fe9af9036e94p-60,
     0x1.7fe83b3938abdp-62, -0x1.0b10b8cb301a8p-63, 0x1.b17f310f0c1c6p-65, -0x1.83b9040ab5e68p-66,
     0x1.72dd68b6d22b8p-67, -0x1.75ae12f3c9b0ep-68, 0x1.85fc759cdb1fbp-69},
     /* [147] 1.375 <= y <= 1.5 2^-35, degree 10, 58.9 bits */
    {0x1.4b2ec424b8af4p-37, -0x1.e7a1b35e192dp-91, 0x1.a7ea53e9aa8c7p-38, 0x1.7c84650589c38p-57, -0x1.44a89c0ef1b0ap-60,
     0x1.37abb201b5c8dp-62, -0x1.8ef00a48fa4b5p-64, 0x1.29df8387416f7p-65, -0x1.ea367cc67e25fp-67,
     0x1.af630f19d0395p-68, -0x1.8fb8482483d74p-69, 0x1.7fc7c63bfd9e7p-70},
     /* [148] 1.5 <= y <= 1.625 2^-35, degree 10, 58.9 bits */
    {0x1.65ad69c13926bp-37, 0x1.abb4e30750a05p-92, 0x1.a7ea5f933fe99p-38, 0x1.6e27ad9f9f24bp-57, -0x1.21431b13b6b7p-60,
     0x1.011eda8dd4567p-62, -0x1.30bc1abf55b19p-64, 0x1.a55c750f6b3bdp-66, -0x1.410953aaab70cp-67,
     0x1.0595c52a71d92p-68, -0x1.c0b543a219508p-70, 0x1.8ee5412dd5389p-71},
     /* [149] 1.625 <= y <= 1.75 2^-35, degree 10, 59.8 bits */
    {0x1.802c1014dd8d8p-37, 0x1.54451bcac4d8bp-91, 0x1.a7ea6ad02c5bep-38, 0x1.614e31542fcd6p-57, -0x1.03dc522c49c31p-60,
     0x1.ae1c9c9b5b83dp-63, -0x1.da9ae38d0400ep-65, 0x1.317e1519a3657p-66, -0x1.b16847745fc91p-68,
     0x1.48caa1aa76c97p-69, -0x1.067a40c6e01c6p-70, 0x1.b27cae53206e2p-72},
     /* [150] 1.75 <= y <= 1.875 2^-35, degree 10, 58.7 bits */
    {0x1.9aaab7193682bp-37, -0x1.2ce2932cae8d8p-93, 0x1.a7ea75ab81039p-38, 0x1.55b86a054c62bp-57,
     -0x1.d63efee940d5dp-61, 0x1.6c0f349ce610fp-63, -0x1.77cd694dea6d3p-65, 0x1.c49420f9e095dp-67,
     -0x1.2c54057106d67p-68, 0x1.aa45a089b281ep-70, -0x1.3e461e9976f66p-71, 0x1.ecda30bde02cp-73},
     /* [151] 1.875 <= y <= 2 2^-35, degree 10, 64.4 bits */
    {0x1.c268b2de8446dp-37, -0x1.2188af573af8bp-91, 0x1.a7ea85517bc63p-37, 0x1.464c88415066cp-55,
     -0x1.9966d9563df0fp-58, 0x1.20fcdcaa1dadp-59, -0x1.0ffce142f2e7cp-60, 0x1.2aa722d6abe1bp-61,
     -0x1.69645a9cf3177p-62, 0x1.d3aed44888ce5p-63, -0x1.3f81169e1dfc8p-63, 0x1.c330bf281a8a7p-64},
     /* [152] 1 <= y <= 1.125 2^-34, degree 10, 58.4 bits */
    {0x1.f76604c8def12p-37, 0x1.aef76b7e552a4p-93, 0x1.a7ea9925287ffp-37, 0x1.34a6a6be59d5ep-55, -0x1.5a7def36069f1p-58,
     0x1.b5abd6d382888p-60, -0x1.709077c00c487p-61, 0x1.6a1906f443ba6p-62, -0x1.880b1d6605381p-63,
     0x1.c5f1c1617e863p-64, -0x1.15321d9f5d763p-64, 0x1.5e38529c5ef5fp-65},
     /* [153] 1.125 <= y <= 1.25 2^-34, degree 10, 60.5 bits */
    {0x1.1631ac8e7a577p-36, 0x1.5d4053d56261fp-92, 0x1.a7eaabf40f128p-37, 0x1.2596a16410a4bp-55, -0x1.2a30fad773935p-58,
     0x1.54c9ae8d5a933p-60, -0x1.03a5ad042f4acp-61, 0x1.cd9821fde253cp-63, -0x1.c42c0b7624be9p-64,
     0x1.d9b416920665bp-65, -0x1.05857e4901ff6p-65, 0x1.2aefa5dd3f506p-66},
     /* [154] 1.25 <= y <= 1.375 2^-34, degree 10, 58.2 bits */
    {0x1.30b057de468dep-36, 0x1.84176e6e18987p-91, 0x1.a7eabde2adda6p-37, 0x1.1889329405eb5p-55, -0x1.0427beb04f62ap-58,
     0x1.0f76e6d928cafp-60, -0x1.79b04a1b9ca8cp-62, 0x1.328787bdfbaf5p-63, -0x1.12297bcde0bc6p-64,
     0x1.063dddb44d95fp-65, -0x1.083b7145c387dp-66, 0x1.13c32ccebd029p-67},
     /* [155] 1.375 <= y <= 1.5 2^-34, degree 10, 58.8 bits */
    {0x1.4b2f0446bdf9p-36, -0x1.7e31fb94b65cbp-92, 0x1.a7eacf0db853ap-37, 0x1.0d1538784ddp-55, -0x1.cb23badfa52edp-59,
     0x1.b8c552351c5dbp-61, -0x1.1a17acf879e0cp-62, 0x1.a541e5858a8dep-64, -0x1.5aa23bb85a1e6p-65,
     0x1.310990334c88ap-66, -0x1.1aa52df1e6449p-67, 0x1.0f5fcf01e0ac8p-68},
     /* [156] 1.5 <= y <= 1.625 2^-34, degree 10, 58.8 bits */
    {0x1.65adb1bc66362p-36, -0x1.3cde474dfa2bbp-90, 0x1.a7eadf8c3cf34p-37, 0x1.02ed5f60d377p-55, -0x1.9914c5d46813p-59,
     0x1.6b9ffbf48d6d1p-61, -0x1.aef62aa6ab3e5p-63, 0x1.29f2bfbcce45ep-64, -0x1.c603eace4f5cbp-66,
     0x1.71f021ee795c8p-67, -0x1.3d4904f7b4c3bp-68, 0x1.1a0ff4a6a5e2ep-69},
     /* [157] 1.625 <= y <= 1.75 2^-34, degree 10, 59.7 bits */
    {0x1.802c60351295fp-36, -0x1.39ebeb49b678ep-91, 0x1.a7eaef7116406p-37, 0x1.f3aeadbe48929p-56,
     -0x1.6f803e656b919p-59, 0x1.3022e727288ddp-61, -0x1.4f9900d8e3a0bp-63, 0x1.b008733a5f3b1p-65,
     -0x1.327754043474bp-66, 0x1.d0fb8d1040ce4p-68, -0x1.73333f2ae4eaep-69, 0x1.333aba075d603p-70},
     /* [158] 1.75 <= y <= 1.875 2^-34, degree 10, 59.6 bits */
    {0x1.9aab0fa7a9559p-36, 0x1.68b09d68c00aap-92, 0x1.a7eafecbeae4ap-37, 0x1.e34c67b61e4afp-56, -0x1.4c843cd77507p-59,
     0x1.016e1a419287cp-61, -0x1.09bbc1b6d5a59p-63, 0x1.4005bfc0583bdp-65, -0x1.a8babd5ed279cp-67,
     0x1.2d6bac70dbb8ep-68, -0x1.c21bbdb1d95a6p-70, 0x1.5c7fffc2c374ap-71},
     /* [159] 1.875 <= y <= 2 2^-34, degree 10, 60.0 bits */
    {0x1.c269189666f35p-36, -0x1.38e79c5ca4b1fp-90, 0x1.a7eb14ed9f28dp-36, 0x1.cd7d3765b0c24p-54,
     -0x1.217e2f6d0c2acp-56, 0x1.98b141f59bb2p-58, -0x1.80a67f527d0efp-59, 0x1.a65c4226cbf76p-60,
     -0x1.ff1647442fb53p-61, 0x1.4ab3e2bdfbb89p-61, -0x1.c3d93039b6578p-62, 0x1.3f0a6212d9a2cp-62},
     /* [160] 1 <= y <= 1.125 2^-33, degree 10, 58.3 bits */
    {0x1.f7667cf8ecaa4p-36, -0x1.93453f70bf8a2p-90, 0x1.a7eb30f83b508p-36, 0x1.b487eb4727044p-54,
     -0x1.ea04773ae0d31p-57, 0x1.357b612a6e2a7p-58, -0x1.049da458a8453p-59, 0x1.fff55b973ac7fp-61,
     -0x1.14cc7461335c7p-61, 0x1.8ccb9368b91ffp-62, -0x1.1969e376c5ad8p-62, -0x1.e2320a1abcb38p-58},
     /* [161] 1.125 <= y <= 1.25 2^-33, degree 10, 58.4 bits */
    {0x1.1631f2628ebbp-35, 0x1.adea9193d574ep-89, 0x1.a7eb4b920c713p-36, 0x1.9f3aa353a2f75p-54, -0x1.a5b5af6f69da3p-57,
     0x1.e1f30cde34864p-59, -0x1.6f32bb5da56a9p-60, 0x1.4665cdcf8167fp-61, -0x1.3fbc28b089699p-62,
     0x1.4ef5bf8883fe2p-63, -0x1.71d92516a7eefp-64, 0x1.a6c2b6db6acfdp-65},
     /* [162] 1.25 <= y <= 1.375 2^-33, degree 10, 58.6 bits */
    {0x1.30b0a7e81e2bap-35, -0x1.aef5d7f80baeep-90, 0x1.a7eb64eeaeb53p-36, 0x1.8cc5192c93b46p-54,
     -0x1.6feb13ee94fb3p-57, 0x1.7fe9332fdc33ep-59, -0x1.0b1142cc20a5p-60, 0x1.b17ff10d824b9p-62, -0x1.83b99ca21b53p-63,
     0x1.72dded46228a2p-64, -0x1.75ae8deb243e5p-65, 0x1.85fcecd5db472p-66},
     /* [163] 1.375 <= y <= 1.5 2^-33, degree 10, 59.2 bits */
    {0x1.4b2f5efaa2cdbp-35, 0x1.32e310cbf2df9p-89, 0x1.a7eb7d36b915p-36, 0x1.7c929ebcd41p-54, -0x1.44a9e3e94cf2p-57,
     0x1.37ac83e185eaap-59, -0x1.8ef0e135b7b91p-61, 0x1.29e00d14bb81cp-62, -0x1.ea3745f8c80c5p-64,
     0x1.af63affd31849p-65, -0x1.8fb8d18f2f8c8p-66, 0x1.7fc84114c2591p-67},
     /* [164] 1.5 <= y <= 1.625 2^-33, degree 10, 59.5 bits */
    {0x1.65ae1789e116cp-35, 0x1.734e038f8d3d9p-89, 0x1.a7eb948ac6f2fp-36, 0x1.6e35d88e28fecp-54, -0x1.21444aa39aa5ep-57,
     0x1.011f8e7c4d01ep-59, -0x1.30bcc55c5f661p-61, 0x1.a55d3f465ac2fp-63, -0x1.4109dc9cdd35bp-64,
     0x1.05962a96f5147p-65, -0x1.c0b5e41a410ccp-67, 0x1.8ee5c62918749p-68},
     /* [165] 1.625 <= y <= 1.75 2^-33, degree 10, 59.1 bits */
    {0x1.802cd18775699p-35, -0x1.86ea7f72a92c4p-89, 0x1.a7ebab0582176p-36, 0x1.615c4e889d2f9p-54,
     -0x1.03dd6ccb7c72ap-57, 0x1.ae1dd48ac877fp-60, -0x1.da9bf6ef152cfp-62, 0x1.317ead0a9f344p-63,
     -0x1.b1690711548abp-65, 0x1.48cb25ce35e1ep-66, -0x1.067aa21b7316cp-67, 0x1.b27d449b0a886p-69},
     /* [166] 1.75 <= y <= 1.875 2^-33, degree 10, 58.5 bits */
    {0x1.9aab8ce680f64p-35, 0x1.3f52cf9e670f3p-89, 0x1.a7ebc0bd0cd26p-36, 0x1.55c67a6a1fc4dp-54, -0x1.d6410fadc2ac7p-58,
     0x1.6c1045981d3cep-60, -0x1.77ce4ac01c8eap-62, 0x1.c49509b441b32p-64, -0x1.2c548eb8f7847p-65,
     0x1.aa4651ac9d9d5p-67, -0x1.3e4698a680cf7p-68, 0x1.ecdae116c6f29p-70},
     /* [167] 1.875 <= y <= 2 2^-33, degree 10, 62.3 bits */
    {0x1.c269a872bd4d3p-35, -0x1.3f7496c3924f6p-91, 0x1.a7ebe00a5308fp-35, 0x1.465a86e7b3219p-52,
     -0x1.9968bb6fe1c6ap-55, 0x1.20fdbf9848689p-56, -0x1.0ffd8c23b5422p-57, 0x1.2aa7c3abe7157p-58,
     -0x1.6965079d4586fp-59, 0x1.d3af9fd1af105p-60, -0x1.3f8196e42babdp-60, 0x1.c331683752c9bp-61},
     /* [168] 1 <= y <= 1.125 2^-32, degree 10, 57.9 bits */
    {0x1.f76726f47a001p-35, 0x1.c045d4c6c598dp-90, 0x1.a7ec07b36af5p-35, 0x1.34b49007626e5p-52, -0x1.5a7f9e8d0682dp-55,
     0x1.b5ad4228f7e8ep-57, -0x1.70916c8aa2696p-58, 0x1.6a19d51a4bda1p-59, -0x1.880be3cd64963p-60,
     0x1.c5f2923b9147bp-61, -0x1.1532934a794f3p-61, 0x1.5e38dd5f68715p-62},
     /* [169] 1.125 <= y <= 1.25 2^-32, degree 10, 59.4 bits */
    {0x1.16325524f23fdp-34, 0x1.04404bb43ce85p-88, 0x1.a7ec2d52f40a8p-35, 0x1.25a47773ca1bap-52, -0x1.2a3281172759fp-55,
     0x1.54cad7f868572p-57, -0x1.03a6625088827p-58, 0x1.cd993644701d9p-60, -0x1.c42cfc08befa2p-61,
     0x1.d9b4fbb156261p-62, -0x1.0585f3013e7acp-62, 0x1.2af022650a171p-63},
     /* [170] 1.25 <= y <= 1.375 2^-32, degree 10, 59.2 bits */
    {0x1.30b1191b45db3p-34, -0x1.58e62e6e7677ep-88, 0x1.a7ec5131eb407p-35, 0x1.1896f72a9a013p-52,
     -0x1.042922fe4b1a1p-55, 0x1.0f77dec965f0cp-57, -0x1.79b15e18f9b32p-59, 0x1.328847be4b846p-60,
     -0x1.122a14748263cp-61, 0x1.063e627270eedp-62, -0x1.083becb226a6dp-63, 0x1.13c3a508fb398p-64},
     /* [171] 1.375 <= y <= 1.5 2^-32, degree 10, 58.2 bits */
    {0x1.4b2fdf430b694p-34, 0x1.7a41b737d3364p-98, 0x1.a7ec7389b7c1fp-35, 0x1.0d22ed0b0eb45p-52, -0x1.cb264a7519a18p-56,
     0x1.b8c6f5e95d787p-58, -0x1.1a1883e0ca0a9p-59, 0x1.a542f89d9ff6bp-61, -0x1.5aa304eff00ccp-62,
     0x1.310a312d65228p-63, -0x1.1aa5b798405f2p-64, 0x1.0f604a5cae4a5p-65},
     /* [172] 1.5 <= y <= 1.625 2^-32, degree 10, 59.5 bits */
    {0x1.65aea7854e04bp-34, 0x1.924cfbf280681p-90, 0x1.a7ec948876a4p-35, 0x1.02fb052b8b5c3p-52, -0x1.991724d644a79p-56,
     0x1.6ba163c768cd2p-58, -0x1.aef77fd92e046p-60, 0x1.29f389f0264d5p-61, -0x1.c604fcb19ff96p-63,
     0x1.71f0ecd0cab58p-64, -0x1.3d49a58dd4beap-65, 0x1.1a1079e59f62bp-66},
     /* [173] 1.625 <= y <= 1.75 2^-32, degree 10, 64.6 bits */
    {0x1.802d71cdb4315p-34, 0x1.83bff4c5b483fp-90, 0x1.a7ecb453dd197p-35, 0x1.f3c9dde0df2cbp-53, -0x1.6f82738716945p-56,
     0x1.30241f0d943e8p-58, -0x1.4f9a1434a70e7p-60, 0x1.b009a31633b0cp-62, -0x1.3278139e28ebep-63,
     0x1.d0fc9558c67f4p-65, -0x1.733401e16d3bep-66, 0x1.333b50723111cp-67},
     /* [174] 1.75 <= y <= 1.875 2^-32, degree 10, 64.8 bits */
    {0x1.9aac3e0a0a4dep-34, -0x1.1a0a0c9140849p-89, 0x1.a7ecd30b3894dp-35, 0x1.e3677e3ad31c8p-53,
     -0x1.4c864d804dcfcp-56, 0x1.016f2b34af353p-58, -0x1.09bca323c168fp-60, 0x1.4006a875dd0a3p-62,
     -0x1.a8bbcfe94ddfcp-64, 0x1.2d6c5d9162627p-65, -0x1.c21cb1cf478ecp-67, 0x1.5c80b02c2304ep-68},
     /* [175] 1.875 <= y <= 2 2^-32, degree 10, 59.0 bits */
    {0x1.c26a73ea75382p-34, -0x1.5318caebfe1efp-93, 0x1.a7ecff5129896p-34, 0x1.cd982a6f6922cp-51,
     -0x1.2180116c70971p-53, 0x1.98b307c3ec3aep-55, -0x1.80a7d50bc03ddp-56, 0x1.a65d83ca77537p-57,
     -0x1.ff17a13db171ep-58, 0x1.4ab4ae42d9ef2p-58, -0x1.c3da30c19e32ep-59, 0x1.3f0b0b2335e2p-59},
     /* [176] 1 <= y <= 1.125 2^-31, degree 10, 58.3 bits */
    {0x1.f768175e73d5cp-34, 0x1.4451e8635b362p-91, 0x1.a7ed3769bd81bp-34, 0x1.b4a2b3988f5cp-51, -0x1.ea07d5b9adea8p-54,
     0x1.357ccb143b659p-55, -0x1.049e818886b14p-56, 0x1.000bbcd172dc2p-57, -0x1.153870e80da5bp-58,
     0x1.40fdc2c3769bfp-59, -0x1.8804c6607d0dfp-60, 0x1.ef4a96c93da9cp-61},
     /* [177] 1.125 <= y <= 1.25 2^-31, degree 10, 58.4 bits */
    {0x1.1632e0d319dffp-33, -0x1.4a07e0c428b29p-89, 0x1.a7ed6ca0b65cp-34, 0x1.9f554534a98a5p-51, -0x1.a5b8bbc048bb9p-54,
     0x1.e1f55fa09ef7dp-56, -0x1.6f3425ef7fcbcp-57, 0x1.4666e21ac2396p-58, -0x1.3fbd1961164c4p-59,
     0x1.4ef6a502cf768p-60, -0x1.71da0f6fff47ap-61, 0x1.a6c3b20056267p-62},
     /* [178] 1.25 <= y <= 1.375 2^-31, degree 10, 58.4 bits */
    {0x1.30b1b9361d2ebp-33, -0x1.e4ddc261a5bb5p-88, 0x1.a7ed9f5d4ce8ap-34, 0x1.8cdf981d6fb64p-51,
     -0x1.6feddc5e5644ep-54, 0x1.7feb22fee118ap-56, -0x1.0b1256c2704dap-57, 0x1.b181710a61bdbp-59,
     -0x1.83bacdfabc1d5p-60, 0x1.72def6ee0f0f6p-61, -0x1.75af85359c704p-62, 0x1.85fdde472a5efp-63},
     /* [179] 1.375 <= y <= 1.5 2^-31, degree 10, 62.7 bits */
    {0x1.4b3094b33fdedp-33, -0x1.f7b6c2a69d82ep-88, 0x1.a7edcff0af7eep-34, 0x1.7cacfda80fa95p-51,
     -0x1.44ac7354981a6p-54, 0x1.37ae278661cf1p-56, -0x1.8ef28efa26341p-58, 0x1.29e120272ea5ep-59,
     -0x1.ea38d867f4bdcp-61, 0x1.af64f204588d1p-62, -0x1.8fb9e5146a5a2p-63, 0x1.7fc9384907087p-64},
     /* [180] 1.5 <= y <= 1.625 2^-31, degree 10, 59.4 bits */
    {0x1.65af732a0a9b2p-33, -0x1.70ebe9bf64a95p-88, 0x1.a7edfe9c15393p-34, 0x1.6e5019eb41722p-51,
     -0x1.2146a97d1dd6bp-54, 0x1.0120f64181a73p-56, -0x1.30be1a84b6aa2p-58, 0x1.a55ed3a3036f1p-60,
     -0x1.410aee7bdd30fp-61, 0x1.0596f57b7bdc3p-62, -0x1.c0b72560fec78p-64, 0x1.8ee6d0e7ce4fep-65},
     /* [181] 1.625 <= y <= 1.75 2^-31, degree 10, 59.3 bits */
    {0x1.802e547db5edfp-33, -0x1.db75d39dfed4p-87, 0x1.a7ee2b94d1f18p-34, 0x1.61767474b6c78p-51, -0x1.03dfa1c66afap-54,
     0x1.ae20443f39a1fp-57, -0x1.da9e1d95aa49ep-59, 0x1.317fdcde5d247p-60, -0x1.b16a863cb48bep-62,
     0x1.48cc2e13e901ap-63, -0x1.067b64d68710dp-64, 0x1.b27e719090f23p-66},
     /* [182] 1.75 <= y <= 1.875 2^-31, degree 10, 59.0 bits */
    {0x1.9aad38948400dp-33, -0x1.ee592c704f319p-87, 0x1.a7ee57072a86bp-34, 0x1.55e086ba1f94bp-51,
     -0x1.d64530b4e014cp-55, 0x1.6c1267685df09p-57, -0x1.77d00d8bb6d1dp-59, 0x1.c496db127d975p-61,
     -0x1.2c55a13c9f3cp-62, 0x1.aa47b3e690ddcp-64, -0x1.3e478cc2c778dp-65, 0x1.ecdc41f66c046p-67},
     /* [183] 1.875 <= y <= 2 2^-31, degree 10, 59.2 bits */
    {0x1.c26b93b270c44p-33, 0x1.441010ccec93ap-87, 0x1.a7ee95a695e25p-33, 0x1.46746fbf440e2p-49, -0x1.996c7f27eb316p-52,
     0x1.20ff8553960b9p-53, -0x1.0ffee1d1c77ecp-54, 0x1.2aa90546726f6p-55, -0x1.6966618dbdb99p-56,
     0x1.d3b136d15b255p-57, -0x1.3f829766bca64p-57, 0x1.c332ba5579221p-58},
     /* [184] 1 <= y <= 1.125 2^-30, degree 10, 58.4 bits */
    {0x1.f7696b688f8cfp-33, 0x1.9c2f1f857a6fbp-88, 0x1.a7eee4ff3a806p-33, 0x1.34ce4e29d7487p-49, -0x1.5a82fcc75970bp-52,
     0x1.b5b0189c5ab82p-54, -0x1.70935602a315ap-55, 0x1.6a1b71515601cp-56, -0x1.880d70899109ap-57,
     0x1.c5f433dc457b1p-58, -0x1.15337e9536255p-58, 0x1.5e39f2d83a3f3p-59},
     /* [185] 1.125 <= y <= 1.25 2^-30, degree 10, 58.1 bits */
    {0x1.1633a6636bf17p-32, 0x1.9b6f02a037657p-86, 0x1.a7ef3044b751dp-33, 0x1.25be0f28e549ep-49, -0x1.2a358d294d2f5p-52,
     0x1.54cd2a9f02205p-54, -0x1.03a7ccd2a5e5bp-55, 0x1.cd9b5eb448a1ap-57, -0x1.c42edd1724e29p-58,
     0x1.d9b6c5db4156dp-59, -0x1.0586dc66cd648p-59, 0x1.2af11b67d2f09p-60},
     /* [186] 1.25 <= y <= 1.375 2^-30, degree 10, 59.8 bits */
    {0x1.30b29baa33339p-32, -0x1.8033281835441p-86, 0x1.a7ef7809073c5p-33, 0x1.18b06bf2678a8p-49,
     -0x1.042beb32888d9p-52, 0x1.0f79ce80a8041p-54, -0x1.79b385efe3067p-56, 0x1.3289c7a9bf122p-57,
     -0x1.122b45b2dfdcp-58, 0x1.063f6be2c6f5ap-59, -0x1.083ce38004c11p-60, 0x1.13c4957222d4ep-61},
     /* [187] 1.375 <= y <= 1.5 2^-30, degree 10, 59.7 bits */
    {0x1.4b319554442f3p-32, 0x1.5b0421874f04ep-87, 0x1.a7efbcbef962bp-33, 0x1.0d3c41cff4fb9p-49, -0x1.cb2b68da35d46p-53,
     0x1.b8ca3d0980844p-55, -0x1.1a1a31947659fp-56, 0x1.a5451eae413b5p-58, -0x1.5aa4974abefe3p-59,
     0x1.310b7312d2359p-60, -0x1.1aa6cad90d69fp-61, 0x1.0f6141078bb32p-62},
     /* [188] 1.5 <= y <= 1.625 2^-30, degree 10, 59.2 bits */
    {0x1.65b09333b4998p-32, -0x1.a564bd96806ep-86, 0x1.a7effec2c89a8p-33, 0x1.03143c64e8616p-49, -0x1.991be21cb5742p-53,
     0x1.6ba4332cf488fp-55, -0x1.aefa2a0ea1ea6p-57, 0x1.29f51e3ecea71p-58, -0x1.c607205b7d0aap-60,
     0x1.71f2828236b0bp-61, -0x1.3d4ae6ac105a6p-62, 0x1.1a118458657fdp-63},
     /* [189] 1.625 <= y <= 1.75 2^-30, degree 10, 61.0 bits */
    {0x1.802f951fd103bp-32, 0x1.980b506da7ae3p-86, 0x1.a7f03e5fdfdb7p-33, 0x1.f3fc157697e0ep-50, -0x1.6f86dd14b9be5p-53,
     0x1.30268ea109a84p-55, -0x1.4f9c3ac48f9a1p-57, 0x1.b00c02a88a56ap-59, -0x1.327992bd39daep-60,
     0x1.d0fea5cfe2786p-62, -0x1.7335873d087f3p-63, 0x1.333c7d3b3e403p-64},
     /* [190] 1.75 <= y <= 1.875 2^-30, degree 10, 59.8 bits */
    {0x1.9aae9af431bd9p-32, 0x1.bfd76316769cfp-87, 0x1.a7f07bd4da88ap-33, 0x1.e399829d2313cp-50, -0x1.4c8a6e231b37dp-53,
     0x1.01714ce735f38p-55, -0x1.09be65dc33ea9p-57, 0x1.400879c370e4fp-59, -0x1.a8bdf4df6bd99p-61,
     0x1.2d6dbfc0701f5p-62, -0x1.c21e99f38027fp-64, 0x1.5c8210efc958dp-65},
     /* [191] 1.875 <= y <= 2 2^-30, degree 10, 59.8 bits */
    {0x1.c26d2abf51c67p-32, -0x1.1d425082c1a03p-92, 0x1.a7f0d46a16841p-32, 0x1.cdc9e7e7b92b2p-48,
     -0x1.2183d4c5593a4p-50, 0x1.98b6930711989p-52, -0x1.80aa804993d52p-53, 0x1.a66006e75ff7fp-54,
     -0x1.ff1a55081d129p-55, 0x1.4ab64536e7111p-55, -0x1.c3dc31b864dc2p-56, 0x1.3f0c5d34bfb24p-56},
     /* [192] 1 <= y <= 1.125 2^-29, degree 10, 58.0 bits */
    {0x1.f76b4c610df0bp-32, 0x1.3bd763c4de08ap-87, 0x1.a7f144a7a2f3ep-32, 0x1.b4d41baf498a2p-48, -0x1.ea0e917bdbf7p-51,
     0x1.357fa15c6286cp-52, -0x1.04a06ae9b49acp-53, 0x1.000d58f8150eep-54, -0x1.1539fd965a1d6p-55,
     0x1.40ff6457649c7p-56, -0x1.88069ce9915aep-57, 0x1.ef4cc1adabfb1p-58},
     /* [193] 1.125 <= y <= 1.25 2^-29, degree 10, 62.6 bits */
    {0x1.1634bdd5ebfd3p-31, -0x1.ace0802cf5556p-85, 0x1.a7f1af21e4eacp-32, 0x1.9f866078d07c7p-48,
     -0x1.a5bed33c1a0c5p-51, 0x1.e1fa04a3e9205p-53, -0x1.6f36fad06aee7p-54, 0x1.46690a7392ef5p-55,
     -0x1.3fbefa5da98edp-56, 0x1.4ef86f1d89acap-57, -0x1.71dbe22d8d5d3p-58, 0x1.a6c5a3f9a8bf3p-59},
     /* [194] 1.25 <= y <= 1.375 2^-29, degree 10, 59.7 bits */
    {0x1.30b3dbfa5c24cp-31, -0x1.0e627b6443fd9p-85, 0x1.a7f214a74ff8dp-32, 0x1.8d106d8eac456p-48,
     -0x1.6ff36c26f0b66p-51, 0x1.7fef022d4e7a4p-53, -0x1.0b147e7d65d2dp-54, 0x1.b18470bffb2d8p-56,
     -0x1.83bd305fd2308p-57, 0x1.72e109bc0b7ebp-58, -0x1.75b172c1a88cbp-59, 0x1.85ffbf0c1686bp-60},
     /* [195] 1.375 <= y <= 1.5 2^-29, degree 10, 61.0 bits */
    {0x1.4b330053ce66dp-31, -0x1.f06a27a82fcc9p-85, 0x1.a7f275da42656p-32, 0x1.7cdd931ace3a8p-48,
     -0x1.44b191215495fp-51, 0x1.37b16e6e4806bp-53, -0x1.8ef5ea345e41fp-55, 0x1.29e3461f17927p-56,
     -0x1.ea3bfcfd3fa0bp-58, 0x1.af6775b787803p-59, -0x1.8fbc0b8362943p-60, 0x1.7fcb258f9a056p-61},
     /* [196] 1.5 <= y <= 1.625 2^-29, degree 10, 59.8 bits */
    {0x1.65b22aa15318ap-31, 0x1.8533ace4f35d5p-85, 0x1.a7f2d33d2bbc7p-32, 0x1.6e80744de97b7p-48, -0x1.214b6631cceaep-51,
     0x1.0123c575346fdp-53, -0x1.30c0c49520fd7p-55, 0x1.a561fc1ac78c8p-57, -0x1.410d120f02803p-58, 0x1.05988b1d78adp-59,
     -0x1.c0b9a786c0083p-61, 0x1.8ee8e5bbdc3fbp-62}, /* [197] 1.625 <= y <= 1.75 2^-29, degree 10, 58.6 bits */
    {0x1.80315aa95a627p-31, -0x1.2a28f90450744p-85, 0x1.a7f32d3ab4d6p-32, 0x1.61a698010e8e3p-48, -0x1.03e40ac83072fp-51,
     0x1.ae25230d02d49p-54, -0x1.daa26a77d0cf9p-56, 0x1.31823c539c81fp-57, -0x1.b16d845a18e44p-59,
     0x1.48ce3e76511e6p-60, -0x1.067cea23e7ea2p-61, 0x1.b280cb0e04cdfp-63},
     /* [198] 1.75 <= y <= 1.875 2^-29, degree 10, 60.9 bits */
    {0x1.9ab0903867bbcp-31, 0x1.3cb532fe44cd5p-86, 0x1.a7f3842b686b9p-32, 0x1.561077197cbd8p-48, -0x1.d64d70ed521dp-52,
     0x1.6c16aa7d22dbdp-54, -0x1.77d392c8a33eep-56, 0x1.c49a7d7fc8ea7p-58, -0x1.2c57c61a9e7cap-59,
     0x1.aa4a78282c11fp-61, -0x1.3e4974d4ac639p-62, 0x1.ecdf0364b63afp-64},
     /* [199] 1.875 <= y <= 2 2^-29, degree 10, 59.3 bits */
    {0x1.c26f6a87d2607p-31, 0x1.0c07fa8beec8bp-85, 0x1.a7f4017c2bc81p-31, 0x1.46a4193dd733ep-46, -0x1.997404da93395p-49,
     0x1.2103105146397p-50, -0x1.10018ce698b6p-51, 0x1.2aab88425ca75p-52, -0x1.696915388be1dp-53, 0x1.d3b46497767c3p-54,
     -0x1.3f849849903f5p-54, 0x1.c3355e5fb27dfp-55}, /* [200] 1 <= y <= 1.125 2^-28, degree 10, 59.3 bits */
    {0x1.f76df4bb6c544p-31, 0x1.25ade04f49b82p-87, 0x1.a7f4a0453408bp-31, 0x1.34fda25268495p-46, -0x1.5a89b79a46c9dp-49,
     0x1.b5b5c4b7fc29dp-51, -0x1.7097288755483p-52, 0x1.6a1ea97234231p-53, -0x1.881089c01cc7p-54, 0x1.c5f776df94d49p-55,
     -0x1.1535550b2c3ccp-55, 0x1.5e3c1da7698e4p-56}, /* [201] 1.125 <= y <= 1.25 2^-28, degree 10, 61.6 bits */
    {0x1.1636492127584p-30, 0x1.99ea8634ed80cp-84, 0x1.a7f536e7c43bep-31, 0x1.25ed1689c7195p-46, -0x1.2a3ba3c35876ep-49,
     0x1.54d1cf3e94c79p-51, -0x1.03aaa183de21cp-52, 0x1.cd9faf27beba6p-54, -0x1.c4329ee014e38p-55,
     0x1.d9ba59e6d60e2p-56, -0x1.0588af1096e2p-56, 0x1.2af30d4d55936p-57},
     /* [202] 1.25 <= y <= 1.375 2^-28, degree 10, 59.0 bits */
    {0x1.30b5a11556f44p-30, 0x1.e519828baa567p-84, 0x1.a7f5c687d60b6p-31, 0x1.18df2d8aacf93p-46, -0x1.04317a24f750dp-49,
     0x1.0f7dad58a3165p-51, -0x1.79b7d51a455aep-53, 0x1.328cc73263508p-54, -0x1.122da7f81dfd7p-55,
     0x1.06417e9782e11p-56, -0x1.083ed0f652fcep-57, 0x1.13c67623344b1p-58},
     /* [203] 1.375 <= y <= 1.5 2^-28, degree 10, 61.0 bits */
    {0x1.4b3501d190141p-30, 0x1.64070ca689acep-84, 0x1.a7f6500b0aee3p-31, 0x1.0d6ac373886e6p-46, -0x1.cb35a2db946c4p-50,
     0x1.b8d0ca41a00c6p-52, -0x1.1a1d8c91b3bacp-53, 0x1.a5496a5b46a61p-55, -0x1.5aa7bbb47f097p-56,
     0x1.310df6a63a9bcp-57, -0x1.1aa8f12edd2b1p-58, 0x1.0f632e39014c2p-59},
     /* [204] 1.5 <= y <= 1.625 2^-28, degree 10, 59.0 bits */
    {0x1.65b46af9fc218p-30, 0x1.e9126a521e3b5p-85, 0x1.a7f6d429db3d6p-31, 0x1.03428301bf4dep-46, -0x1.992559ffd1719p-50,
     0x1.6ba9d10df22eap-52, -0x1.aeff7dcb5f847p-54, 0x1.29f84683cdcc5p-55, -0x1.c60b67447a82ap-57,
     0x1.71f5ad9cc0c45p-58, -0x1.3d4d68b371aa1p-59, 0x1.1a139914da69bp-60},
     /* [205] 1.625 <= y <= 1.75 2^-28, degree 10, 68.9 bits */
    {0x1.8033dc3d32669p-30, 0x1.424f6a181b0e3p-84, 0x1.a7f7537b1f309p-31, 0x1.f45835158f3c3p-47, -0x1.6f8fada1e42b6p-50,
     0x1.302b6cf6b0ac3p-52, -0x1.4fa0875366fc5p-54, 0x1.b010c14456899p-56, -0x1.327c90ae5fcafp-57,
     0x1.d102c65cfe6adp-59, -0x1.733891b1c4565p-60, 0x1.333ed69d30d3ap-61},
     /* [206] 1.75 <= y <= 1.875 2^-28, degree 10, 58.5 bits */
    {0x1.9ab3555261cbdp-30, 0x1.1a17d66279cdcp-85, 0x1.a7f7ce7c0f852p-31, 0x1.e3f53bf35abep-47, -0x1.4c92acf36c51p-50,
     0x1.01758f8fcc5dbp-52, -0x1.09c1ead2ee939p-54, 0x1.400c1bf2b29d1p-56, -0x1.a8c23e5a26b3cp-58,
     0x1.2d7083db99b91p-59, -0x1.c22269e62f2e2p-61, 0x1.5c84d23cd663ap-62},
     /* [207] 1.875 <= y <= 2 2^-28, degree 10, 59.7 bits */
    {0x1.c272990df641p-30, -0x1.6cf13a54f4ad2p-85, 0x1.a7f87fc8d203dp-30, 0x1.ce2513950148dp-45, -0x1.218b5922bc525p-47,
     0x1.98bda84751d71p-49, -0x1.80afd6047a3a1p-50, 0x1.a6650c85f6156p-51, -0x1.ff1fbc081c816p-52,
     0x1.4ab972cf0470cp-52, -0x1.c3e0334850af6p-53, 0x1.3f0f011dc9515p-53},
     /* [208] 1 <= y <= 1.125 2^-27, degree 10, 60.0 bits */
    {0x1.f771b732dabedp-30, 0x1.6e07cc53a9ef7p-84, 0x1.a7f96071554c5p-30, 0x1.b52e9ccf833cdp-45, -0x1.ea1c04a206743p-48,
     0x1.35854cdae9028p-49, -0x1.04a43d1b30991p-50, 0x1.001090dcf0057p-51, -0x1.153d169961afap-52,
     0x1.4102a7292ba12p-53, -0x1.880a49a1bc521p-54, 0x1.ef511712d011ep-55},
     /* [209] 1.125 <= y <= 1.25 2^-27, degree 10, 61.1 bits */
    {0x1.16387857c1921p-29, 0x1.feea97c0196e4p-84, 0x1.a7fa3592f2c9ap-30, 0x1.9fe04826c8957p-45, -0x1.a5cafe14cb9cbp-48,
     0x1.e2034cd69b291p-50, -0x1.6f3ca3b22bd03p-51, 0x1.466d5a930da3cp-52, -0x1.3fc2bbe55e64dp-53,
     0x1.4efc02f05e5eap-54, -0x1.71df874b7fbaap-55, 0x1.a6c9878f0341cp-56},
     /* [210] 1.25 <= y <= 1.375 2^-27, degree 10, 59.1 bits */
    {0x1.30b82216fb51p-29, -0x1.c690bbeddfc81p-85, 0x1.a7fb00ca9957ep-30, 0x1.8d69c9c6f47cap-45, -0x1.6ffe87cfa49bdp-48,
     0x1.7ff6bef49d277p-50, -0x1.0b18cd41ec381p-51, 0x1.b18a6f57dba46p-53, -0x1.83c1f494337d2p-54,
     0x1.72e52ee11d57dp-55, -0x1.75b54d7346da6p-56, 0x1.860380385090ep-57},
     /* [211] 1.375 <= y <= 1.5 2^-27, degree 10, 58.2 bits */
    {0x1.4b37d843042e6p-29, -0x1.84bb696a9d38ap-85, 0x1.a7fbc35d0be77p-30, 0x1.7d366f83dd79ep-45,
     -0x1.44bbc901c4667p-48, 0x1.37b7fada5bed5p-50, -0x1.8efc9f8a6d579p-52, 0x1.29e79171f3b55p-53,
     -0x1.ea42455b14c8p-55, 0x1.af6c7c8859bd2p-56, -0x1.8fc057eacb492p-57, 0x1.7fceffb92b45ep-58},
     /* [212] 1.5 <= y <= 1.625 2^-27, degree 10, 58.6 bits */
    {0x1.65b79a59f8d54p-29, -0x1.de2fc2e9a3c04p-83, 0x1.a7fc7e4f2eecp-30, 0x1.6ed8dac277f3p-45, -0x1.2154dc0bfad51p-48,
     0x1.012962a16e051p-50, -0x1.30c617caf6387p-52, 0x1.a5684c1bc1da2p-54, -0x1.411158a53541ep-55,
     0x1.059bb5fffc292p-56, -0x1.c0beab433b746p-58, 0x1.8eed0ef4b9193p-59},
     /* [213] 1.625 <= y <= 1.75 2^-27, degree 10, 61.0 bits */
    {0x1.803767e8b5e52p-29, 0x1.280abeab5a72ap-83, 0x1.a7fd327658a53p-30, 0x1.61fe90f2cf262p-45, -0x1.03ecd961c81f4p-48,
     0x1.ae2ede754135ep-51, -0x1.daab02b4f75fbp-53, 0x1.3186fa853cc42p-54, -0x1.b1737fc4ec7f5p-56,
     0x1.48d25eb8272e3p-57, -0x1.067ff46530aefp-58, 0x1.b2857d8756585p-60},
     /* [214] 1.75 <= y <= 1.875 2^-27, degree 10, 62.3 bits */
    {0x1.9ab740883ee0ap-29, 0x1.610629133f8e3p-85, 0x1.a7fde083a273ep-30, 0x1.566809d97392bp-45, -0x1.d65deacd1eb03p-49,
     0x1.6c1f2eab7596cp-51, -0x1.77da9bf8f28adp-53, 0x1.c4a1c136ef8edp-55, -0x1.2c5c0f3d4103p-56, 0x1.aa4ffff6a4fbdp-58,
     -0x1.3e4d4484f6aaap-59, 0x1.ece485a4c98f8p-61}, /* [215] 1.875 <= y <= 2 2^-27, degree 10, 59.3 bits */
    {0x1.c277196e5a47p-29, -0x1.64fbfdf1fafe3p-85, 0x1.a7fedb66a1587p-29, 0x1.46fb1e75bc554p-43, -0x1.99830a0735fa3p-46,
     0x1.210a24960f89bp-47, -0x1.1006e20c57fe4p-48, 0x1.2ab08d6898c0ep-49, -0x1.696e7bc5026fdp-50,
     0x1.d3babf4b7ffddp-51, -0x1.3f889990e48c8p-51, 0x1.c33aa5d801a13p-52},
     /* [216] 1 <= y <= 1.125 2^-26, degree 10, 61.4 bits */
    {0x1.f77708e8c414ep-29, 0x1.cb266869f5f31p-84, 0x1.a800194f604adp-29, 0x1.3553fd268524p-43, -0x1.5a97276be038cp-46,
     0x1.b5c11a0ef6982p-48, -0x1.709ecc0a3837dp-49, 0x1.6a25189a18f44p-50, -0x1.8816bb3b28e63p-51,
     0x1.c5fdfbfd6be04p-52, -0x1.1539017d75cf6p-52, 0x1.5e4072bf3da0ep-53},
     /* [217] 1.125 <= y <= 1.25 2^-26, degree 10, 61.7 bits */
    {0x1.163b8f8a451dep-28, -0x1.ce08741ecad4bp-83, 0x1.a80146ea8d97cp-29, 0x1.2642d8126d008p-43,
     -0x1.2a47cb7837582p-46, 0x1.54db1608cef91p-48, -0x1.03b049b868eb7p-49, 0x1.cda84e8451a8cp-51,
     -0x1.c43a213f82668p-52, 0x1.d9c180f3529d4p-53, -0x1.058c53e62514cp-53, 0x1.2af6f09a39c9cp-54},
     /* [218] 1.25 <= y <= 1.375 2^-26, degree 10, 60.6 bits */
    {0x1.30bbad0701382p-28, -0x1.ba038ff2a7772p-84, 0x1.a80266802c082p-29, 0x1.193463c24f465p-43,
     -0x1.043c92d3c6a9bp-46, 0x1.0f8568e7a67edp-48, -0x1.79c07191342adp-50, 0x1.3292c526ad62bp-51,
     -0x1.12326bb85efa5p-52, 0x1.0645a36048fc3p-53, -0x1.0842ab58511b8p-54, 0x1.13ca3706a819bp-55},
     /* [219] 1.375 <= y <= 1.5 2^-26, degree 10, 59.5 bits */
    {0x1.4b3bdc1923ccfp-28, 0x1.0af468f90b696p-84, 0x1.a80379db8b4bbp-29, 0x1.0dbf79fec8669p-43, -0x1.cb4a0cf1c2128p-47,
     0x1.b8dde0f62be4p-49, -0x1.1a24410a96882p-50, 0x1.a552000e16f7cp-52, -0x1.5aae0373abd71p-53, 0x1.3112fd0306e48p-54,
     -0x1.1aad3d3a350efp-55, 0x1.0f6708152841p-56}, /* [220] 1.5 <= y <= 1.625 2^-26, degree 10, 59.8 bits */
    {0x1.65bc1c08f7b2dp-28, 0x1.aeff7fd1e62ecp-83, 0x1.a804826da6c9fp-29, 0x1.0396c3b9b987ap-43, -0x1.99384049e3c73p-47,
     0x1.6bb5098168667p-49, -0x1.af0a22cc31c04p-51, 0x1.29fe95cc43236p-52, -0x1.c613f391a95fp-54, 0x1.71fc02caa028fp-55,
     -0x1.3d526c00e3499p-56, 0x1.1a17c1f742762p-57}, /* [221] 1.625 <= y <= 1.75 2^-26, degree 10, 59.2 bits */
    {0x1.803c6c33a41ebp-28, 0x1.b6ddc97958bcap-82, 0x1.a8058164380fbp-29, 0x1.f4ffdbbf852cep-44, -0x1.6fa145a4149dfp-47,
     0x1.303526adac856p-49, -0x1.4fa91e62af1aap-51, 0x1.b01a3c89b324ep-53, -0x1.32828b78304p-54, 0x1.d10b06159ef51p-56,
     -0x1.733ea5a97bc12p-57, 0x1.334388b1d9212p-58}, /* [222] 1.75 <= y <= 1.875 2^-26, degree 10, 58.6 bits */
    {0x1.9abccc07800ap-28, -0x1.f90341359c40fp-84, 0x1.a80677b9b872cp-29, 0x1.e49c1676cf74fp-44, -0x1.4ca321d599b8p-47,
     0x1.017e123828d79p-49, -0x1.09c8f305018e5p-51, 0x1.40135ec892c89p-53, -0x1.a8cacfb2053dcp-55,
     0x1.2d760b1e081b7p-56, -0x1.c22a08939b1bep-58, 0x1.5c8a540367c87p-59},
     /* [223] 1.875 <= y <= 2 2^-26, degree 10, 59.1 bits */
    {0x1.c27d7806a9a0dp-28, 0x1.41f83a5ec36f9p-82, 0x1.a807dacff5aacp-28, 0x1.cecad35fb54ap-42, -0x1.219a5995b55c8p-44,
     0x1.98cbce2ed5248p-46, -0x1.80ba7ebf277c3p-47, 0x1.a66f158e8bd49p-48, -0x1.ff2a87e9cbe4bp-49,
     0x1.4abfccdba3323p-49, -0x1.c3e8351322e0fp-50, 0x1.3f14481cf4f03p-50},
     /* [224] 1 <= y <= 1.125 2^-25, degree 10, 59.4 bits */
    {0x1.f77e8fc291837p-28, -0x1.cd112d4585453p-85, 0x1.a8099cc60eb07p-28, 0x1.b5d3084055c2cp-42,
     -0x1.ea36db6c2ffaap-45, 0x1.35909ffc732c3p-46, -0x1.04abdf711ccafp-47, 0x1.0016ff2b2ee41p-48,
     -0x1.154347594355fp-49, 0x1.41092b92d455p-50, -0x1.8811a1c9db01fp-51, 0x1.ef59c071dc6c6p-52},
     /* [225] 1.125 <= y <= 1.25 2^-25, degree 10, 58.4 bits */
    {0x1.163fef21477efp-27, 0x1.c9062c0f005a5p-83, 0x1.a80b47ad1974dp-28, 0x1.a0838167b58b5p-42, -0x1.a5e34528132cap-45,
     0x1.e215d6a5a2746p-47, -0x1.6f47f24a264adp-48, 0x1.4675f8bf3e7f6p-49, -0x1.3fca3d57f0215p-50,
     0x1.4f03292e87875p-51, -0x1.71e6d0337475fp-52, 0x1.a6d14d655674cp-53},
     /* [226] 1.25 <= y <= 1.375 2^-25, degree 10, 59.6 bits */
    {0x1.30c0b06d450dep-27, 0x1.f11a8e13c76ecp-83, 0x1.a80cdebf1294cp-28, 0x1.8e0becc735f69p-42, -0x1.7014b147148e6p-45,
     0x1.800632ce8cbb8p-47, -0x1.0b216848f3b62p-48, 0x1.b1966988ae6d8p-50, -0x1.83cb7adc397afp-51,
     0x1.72ed777a1accbp-52, -0x1.75bd0160adde5p-53, 0x1.860b013afc0efp-54},
     /* [227] 1.375 <= y <= 1.5 2^-25, degree 10, 58.3 bits */
    {0x1.4b418a9d0328bp-27, 0x1.7ce93a26f7606p-81, 0x1.a80e6485996f8p-28, 0x1.7dd79387cca35p-42, -0x1.44d02b9396381p-45,
     0x1.37c50eb21d757p-47, -0x1.8f0a062ab20d4p-49, 0x1.29f025de5faf9p-50, -0x1.ea4ed32ea0c75p-52,
     0x1.af7688099687dp-53, -0x1.8fc8ef09742ebp-54, 0x1.7fd6b2a0cabc4p-55},
     /* [228] 1.5 <= y <= 1.625 2^-25, degree 10, 58.4 bits */
    {0x1.65c27cacab30fp-27, -0x1.9cf956c43ae33p-82, 0x1.a80fdb0a8c521p-28, 0x1.6f79137800636p-42,
     -0x1.2167bb27de112p-45, 0x1.0134988c1beeep-47, -0x1.30d0bae51744bp-49, 0x1.a574e8bcef4d4p-51,
     -0x1.4119e3c63dd24p-52, 0x1.05a20a6272333p-53, -0x1.c0c8b0b311cb2p-55, 0x1.8ef55fd08dde4p-56},
     /* [229] 1.625 <= y <= 1.75 2^-25, degree 10, 61.8 bits */
    {0x1.804385b5e7ad1p-27, 0x1.30179cffc3184p-82, 0x1.a81143f8a9f35p-28, 0x1.629def36aed8cp-42, -0x1.03fe6a826a6eap-45,
     0x1.ae424d5c683a1p-48, -0x1.dabc2da9f20e8p-50, 0x1.3190744aa7751p-51, -0x1.b17f73a7a4a13p-53,
     0x1.48da9d5f9c0dfp-54, -0x1.068607a1fa663p-55, 0x1.b28ee0a177c12p-57},
     /* [230] 1.75 <= y <= 1.875 2^-25, degree 10, 60.3 bits */
    {0x1.9ac4a4eab1f81p-27, -0x1.4521fb15a646fp-81, 0x1.a812a0b234c71p-28, 0x1.57069c47c14b6p-42,
     -0x1.d67ec757c05dbp-46, 0x1.6c302fe9790cap-48, -0x1.77e8a9b3700e3p-50, 0x1.c4b04485c0b2ap-52,
     -0x1.2c649f560d378p-53, 0x1.aa5b0d02c87dep-55, -0x1.3e54e241411d4p-56, 0x1.ecef87eaa9b5ep-58},
     /* [231] 1.875 <= y <= 2 2^-25, degree 10, 58.7 bits */
    {0x1.c2867bba0ec86p-27, 0x1.2e2ecf5595d1cp-81, 0x1.a8149765373d7p-27, 0x1.4798969f0b60bp-40, -0x1.99a0fe691c479p-43,
     0x1.211846f8c2c71p-44, -0x1.101188ade17f4p-45, 0x1.2aba94be76a39p-46, -0x1.697946048379p-47, 0x1.d3c771a284e43p-48,
     -0x1.3f909a54392bp-48, 0x1.c345329031caap-49}, /* [232] 1 <= y <= 1.125 2^-24, degree 10, 58.4 bits */
    {0x1.f78936d5816ccp-27, 0x1.08624660e65ddp-81, 0x1.a81714704b5b8p-27, 0x1.35f021872a16dp-40, -0x1.5ab1f280225cdp-43,
     0x1.b5d7ba6b7b88p-45, -0x1.70ae0d8fc7b76p-46, 0x1.6a31f2ee93d5ap-47, -0x1.88231ac42ada3p-48, 0x1.c60b02ec60d19p-49,
     -0x1.154058a81f7fcp-49, 0x1.5e491b0593d23p-50}, /* [233] 1.125 <= y <= 1.25 2^-24, degree 10, 58.6 bits */
    {0x1.16461fbd5b485p-26, -0x1.159addc7a5507p-80, 0x1.a81970ddb7f26p-27, 0x1.26ddcacb81535p-40,
     -0x1.2a600783f7ad6p-43, 0x1.54ed9acedac33p-45, -0x1.03bb95e1a29e2p-46, 0x1.cdb987ac45ed1p-48,
     -0x1.c44921a8a25a9p-49, 0x1.d9cfcb4530486p-50, -0x1.05939bc7b942cp-50, 0x1.2afeb569a1455p-51},
     /* [234] 1.25 <= y <= 1.375 2^-24, degree 10, 61.0 bits */
    {0x1.30c7c8f106894p-26, -0x1.fcc2b85a28b0fp-81, 0x1.a81bb13dc04c4p-27, 0x1.19ce40bb7991bp-40,
     -0x1.0452b1d99030ap-43, 0x1.0f94d865bebb6p-45, -0x1.79d1a3c66e181p-47, 0x1.329ebd09f3ed6p-48,
     -0x1.123bf05cfd1e5p-49, 0x1.064deaab67a3cp-50, -0x1.084a5e254f84cp-51, 0x1.13d1b70171d3cp-52},
     /* [235] 1.375 <= y <= 1.5 2^-24, degree 10, 59.5 bits */
    {0x1.4b499562ba9c5p-26, -0x1.a526969708cbp-80, 0x1.a81dd92736b76p-27, 0x1.0e585875d3bcdp-40, -0x1.cb72be372873dp-44,
     0x1.b8f8010279df9p-46, -0x1.1a31a490c4bc6p-47, 0x1.a563257c191ffp-49, -0x1.5aba8f0a8dc7bp-50,
     0x1.311d06e0d003ap-51, -0x1.1ab5d30b99af2p-52, 0x1.0f6eb9e43d9b9p-53},
     /* [236] 1.5 <= y <= 1.625 2^-24, degree 10, 59.9 bits */
    {0x1.65cb83a2ed54bp-26, -0x1.d829c36ea5c19p-80, 0x1.a81feb7c3cc27p-27, 0x1.042eb756d3e16p-40, -0x1.995deb895055p-44,
     0x1.6bcb6e94529ffp-46, -0x1.af1f63ea850a5p-48, 0x1.2a0b2fd54a5b5p-49, -0x1.c62506ae8333cp-51,
     0x1.7208a96d63227p-52, -0x1.3d5c6fdf0033dp-53, 0x1.1a201199f6a45p-54},
     /* [237] 1.625 <= y <= 1.75 2^-24, degree 10, 59.5 bits */
    {0x1.804d926bcfb98p-26, 0x1.0e64e684e8039p-80, 0x1.a821ea9869eb1p-27, 0x1.f62e0ef52b52ap-41, -0x1.6fc455b959595p-44,
     0x1.30488f8befffbp-46, -0x1.4fba451d2468dp-48, 0x1.b02d2c101b2b7p-50, -0x1.328e7d1662f4fp-51,
     0x1.d11b808740c3fp-53, -0x1.734aca2cf63a5p-54, 0x1.334cea5f9787fp-55},
     /* [238] 1.75 <= y <= 1.875 2^-24, degree 10, 58.6 bits */
    {0x1.9acfc099f4776p-26, -0x1.9aa7c3ae3b057p-81, 0x1.a823d870d0376p-27, 0x1.e5c8b2d703789p-41,
     -0x1.4cc3eceb5d01fp-44, 0x1.018f0e0883345p-46, -0x1.09d6fd3047ca5p-48, 0x1.4021deed74378p-50,
     -0x1.a8dbec8c1e04bp-52, 0x1.2d811630aa596p-53, -0x1.c2394184a461p-55, 0x1.5c955491a3cb6p-56},
     /* [239] 1.875 <= y <= 2 2^-24, degree 10, 59.7 bits */
    {0x1.c2933e851e10ap-26, -0x1.fea1147c5e3ecp-81, 0x1.a826a05e882e8p-26, 0x1.cff53c676ba46p-39, -0x1.21b83d74d082p-41,
     0x1.98e8099434caap-43, -0x1.80cfc666b408dp-44, 0x1.a6831faeb4ea6p-45, -0x1.ff401808060cbp-46,
     0x1.4acc7cd6bd372p-46, -0x1.c3f833d66c0bcp-47, 0x1.3f1ed31f1e849p-47},
     /* [240] 1 <= y <= 1.125 2^-23, degree 10, 58.3 bits */
    {0x1.f7984b79f185dp-26, 0x1.ac7f8f46054a4p-80, 0x1.a82a269cd99a1p-26, 0x1.b6facb35bb103p-39, -0x1.ea6c52b421b8cp-42,
     0x1.35a738aba3ae2p-43, -0x1.04bb1d8c8d53ap-44, 0x1.0021df1a32089p-45, -0x1.154c01638737dp-46,
     0x1.4a007ce8ebd53p-47, -0x1.8df131d4e2489p-48, -0x1.88adb0f5915a8p-46},
     /* [241] 1.125 <= y <= 1.25 2^-23, degree 10, 62.9 bits */
    {0x1.164ee32071294p-25, -0x1.4143d4a39b135p-79, 0x1.a82d7eb808fp-26, 0x1.a1a8e27554d4ap-39, -0x1.a613a02f4cbd9p-42,
     0x1.e23ad2cb04851p-44, -0x1.6f5e841deb8c4p-45, 0x1.46872da36c157p-46, -0x1.3fd93a6d8feedp-47,
     0x1.4f117099673fdp-48, -0x1.71f55d36e4f0dp-49, 0x1.a6e0d4426f2e3p-50},
     /* [242] 1.25 <= y <= 1.375 2^-23, degree 10, 59.4 bits */
    {0x1.30d1d4c093e8ep-25, 0x1.cb9aabd86d3d5p-93, 0x1.a830af248aaf4p-26, 0x1.8f2f23a831e6cp-39, -0x1.7040d3d1329dep-42,
     0x1.8025063234841p-44, -0x1.0b32955c0618ap-45, 0x1.b1ae5327111ffp-47, -0x1.83de7fc2e27b1p-48,
     0x1.72fe0291e0deep-49, -0x1.75cc63f56cc86p-50, 0x1.8619fe6cab865p-51},
     /* [243] 1.375 <= y <= 1.5 2^-23, degree 10, 58.7 bits */
    {0x1.4b54f84c9f17fp-25, -0x1.912d53eb0db9fp-79, 0x1.a833bcf6034eap-26, 0x1.7ef8cea64afa8p-39,
     -0x1.44f8c2b2b6ee2p-42, 0x1.37df2496be3a6p-44, -0x1.8f24c4f09f2b1p-46, 0x1.2a0146bb56553p-47,
     -0x1.ea67e46027f2dp-49, 0x1.af8a9761cec45p-50, -0x1.8fda172f038bap-51, 0x1.7fe6134e9b7e9p-52},
     /* [244] 1.5 <= y <= 1.625 2^-23, degree 10, 60.0 bits */
    {0x1.65d84bbca5eep-25, 0x1.64bb4833acc8p-80, 0x1.a836ac4084c6bp-26, 0x1.70987a1518f74p-39, -0x1.218d4d729f71dp-42,
     0x1.014af4a319f39p-44, -0x1.30e5f53b6e7fcp-46, 0x1.a58e15e087884p-48, -0x1.412af2ae37dfdp-49,
     0x1.05aeae2a1b44fp-50, -0x1.c0dcb43aec86fp-52, 0x1.8f05fbce70589p-53},
     /* [245] 1.625 <= y <= 1.75 2^-23, degree 10, 58.4 bits */
    {0x1.805bcd43c2d92p-25, 0x1.83d67baa9e3fap-79, 0x1.a8398059d5304p-26, 0x1.63bba2f434addp-39, -0x1.042162b29193cp-42,
     0x1.ae690f0fd6984p-45, -0x1.dade6fd90874bp-47, 0x1.31a35e73949fep-48, -0x1.b19750d3c305ep-50,
     0x1.48eb13fbf8c34p-51, -0x1.0692298502a66p-52, 0x1.b2a1a02c447fp-54},
     /* [246] 1.75 <= y <= 1.875 2^-23, degree 10, 58.9 bits */
    {0x1.9adf7b45b2273p-25, 0x1.92dc8c59d1e45p-79, 0x1.a83c3c06b80ecp-26, 0x1.5822ba48c4efbp-39, -0x1.d6c02f9f9488p-43,
     0x1.6c52191ed3de7p-45, -0x1.7804b48da9387p-47, 0x1.c4cd3c5cb50f4p-49, -0x1.2c75b7b8b047ap-50,
     0x1.aa711ddf88778p-52, -0x1.3e6417cf4fd8cp-53, 0x1.ed05846d10877p-55},
     /* [247] 1.875 <= y <= 2 2^-23, degree 10, 59.2 bits */
    {0x1.c2a5508b7c697p-25, 0x1.77cada8a3f0d3p-81, 0x1.a8402cbdbf4bfp-25, 0x1.48b282d8febf3p-37, -0x1.99dc9ac67f5a2p-40,
     0x1.213475ec0ead4p-41, -0x1.1026c8dd9a816p-42, 0x1.2ace98cd99db3p-43, -0x1.698ed049410bap-44,
     0x1.d3e0cb498f1c3p-45, -0x1.3fa09564d45fap-45, 0x1.c35a43ff441a7p-46},
     /* [248] 1 <= y <= 1.125 2^-22, degree 10, 58.3 bits */
    {0x1.f7ada6c70ced5p-25, -0x1.429e38f641caep-80, 0x1.a8452b36370acp-25, 0x1.370769a5c15ep-37, -0x1.5ae7414002cfdp-40,
     0x1.b604d6957947fp-42, -0x1.70cc7cfe4fd59p-43, 0x1.6a4b9958cab33p-44, -0x1.883bcd8cc236p-45, 0x1.c62504ef6ac23p-46,
     -0x1.154f00c778a12p-46, 0x1.5e5a64afa0127p-47}, /* [249] 1.125 <= y <= 1.25 2^-22, degree 10, 59.0 bits */
    {0x1.165b4c50e4a96p-24, -0x1.2910847d2452ap-79, 0x1.a849e8695c304p-25, 0x1.27f2b2d9e3235p-37,
     -0x1.2a903c6aca2c6p-40, 0x1.5512852f225f6p-42, -0x1.03d21f1125357p-43, 0x1.cddbe615afa9cp-45,
     -0x1.c46712f27d865p-46, 0x1.d9ec52592c8ebp-47, -0x1.05a2251dfe806p-47, 0x1.2b0e389686b3ap-48},
     /* [250] 1.25 <= y <= 1.375 2^-22, degree 10, 62.3 bits */
    {0x1.30e00f459f659p-24, 0x1.e2404568aa029p-78, 0x1.a84e6d78ab67cp-25, 0x1.1ae1005a0be3ap-37, -0x1.047eb053fb62cp-40,
     0x1.0fb39c6b19ff9p-42, -0x1.79f3f0451c3a5p-44, 0x1.32b69e740c63cp-45, -0x1.124eef69bd478p-46,
     0x1.065e711867543p-47, -0x1.0859bcb04b19p-48, 0x1.13e0b080040a9p-49},
     /* [251] 1.375 <= y <= 1.5 2^-22, degree 10, 59.8 bits */
    {0x1.4b6518fb1ca43p-24, -0x1.1fb03b645e52cp-86, 0x1.a852c192945adp-25, 0x1.0f691df79f6bap-37,
     -0x1.cbc3a7ee13cc8p-41, 0x1.b92c11e40a0d4p-43, -0x1.1a4c585685481p-44, 0x1.a5855b0bb9539p-46,
     -0x1.5ad398405977fp-47, 0x1.3131105d21cd2p-48, -0x1.1ac6f6877ff51p-49, 0x1.0f7e16a3defb9p-50},
     /* [252] 1.5 <= y <= 1.625 2^-22, degree 10, 59.2 bits */
    {0x1.65ea6691c95e6p-24, 0x1.c4554e9ce8799p-78, 0x1.a856ea7c048d3p-25, 0x1.053da9e8b78bbp-37, -0x1.99a8cec0fe729p-41,
     0x1.6bf80ef76d16p-43, -0x1.af49c691802a1p-45, 0x1.2a2453be3bb45p-46, -0x1.c6471946cb93cp-48, 0x1.7221e95d14ef8p-49,
     -0x1.3d706dc900799p-50, 0x1.1a30a9358ed22p-51}, /* [253] 1.625 <= y <= 1.75 2^-22, degree 10, 59.2 bits */
    {0x1.806ff57d92c8cp-24, 0x1.e5ed4833c859ap-79, 0x1.a85aececbc049p-25, 0x1.f848915906f9ap-38, -0x1.700a078ad5514p-41,
     0x1.306f3c05d02aep-43, -0x1.4fdc7852d30c6p-45, 0x1.b052f219c4be4p-47, -0x1.32a6522d8083ep-48,
     0x1.d13c6385689b2p-50, -0x1.736306ef153bcp-51, 0x1.335fa4d1387adp-52},
     /* [254] 1.75 <= y <= 1.875 2^-22, degree 10, 58.6 bits */
    {0x1.9af5c37731cc7p-24, -0x1.2c7b6d9f19ea6p-79, 0x1.a85ecccf5bc11p-25, 0x1.e7e00ca130cc3p-38,
     -0x1.4d0519283b22ep-41, 0x1.01b0e429d1b7dp-43, -0x1.09f2fb71eec9fp-45, 0x1.403ecb86b4a52p-47,
     -0x1.a8fe116a2d0a4p-49, 0x1.2d97200156f65p-50, -0x1.c257a395f9311p-52, 0x1.5cab4aee44b1bp-53},
     /* [255] 1.875 <= y <= 2 2^-22, degree 10, 58.7 bits */
    {0x1.c2beea36e17bbp-24, -0x1.3ccdd0ac1b181p-78, 0x1.a86462ea2fdfp-24, 0x1.d20836bd9c0e8p-36, -0x1.21f3a1199a194p-38,
     0x1.992046904c336p-40, -0x1.80fa32f3230afp-41, 0x1.a6ab17aa3f47ap-42, -0x1.ff6b1cfca5fd8p-43,
     0x1.4ae5ce144b87ep-43, -0x1.c41820191a357p-44, 0x1.3f33de6f8102p-44},
     /* [256] 1 <= y <= 1.125 2^-21, degree 10, 58.7 bits */
    {0x1.f7cbe8ea77806p-24, -0x1.0aac8f186e09ap-78, 0x1.a86b77a803a83p-24, 0x1.b908827803866p-36,
     -0x1.ead686495f94bp-39, 0x1.35d4391b37e3cp-40, -0x1.04d97d559018ap-41, 0x1.003d720a4caf9p-42,
     -0x1.15684daf44a97p-43, 0x1.413028f1fc767p-44, -0x1.883d943ad2181p-45, 0x1.ef8d96dbcf104p-46},
     /* [257] 1.125 <= y <= 1.25 2^-21, degree 10, 58.0 bits */
    {0x1.166ce22494bc2p-23, 0x1.0d8eeb0764392p-78, 0x1.a872300ba0112p-24, 0x1.a3b1de670a959p-36, -0x1.a673a66d4f4bep-39,
     0x1.e284789b23eb8p-41, -0x1.6f8b7f934dd86p-42, 0x1.46a97cf18f503p-43, -0x1.3ff71fe6c43f3p-44,
     0x1.4f2ded589cb15p-45, -0x1.7212661644bebp-46, 0x1.a6ffd0c4fd99bp-47},
     /* [258] 1.25 <= y <= 1.375 2^-21, degree 10, 58.6 bits */
    {0x1.30f438cf83b57p-23, 0x1.8a07967b95fe6p-81, 0x1.a87898ffd9133p-24, 0x1.9133d3437fb14p-36, -0x1.709872aa97428p-39,
     0x1.806265aa2ff2p-41, -0x1.0b54cfc310d1dp-42, 0x1.b1de003155103p-44, -0x1.84046e4c5b091p-45, 0x1.731f02feaa355p-46,
     -0x1.75eb164891db6p-47, 0x1.8637e78c2553fp-48}, /* [259] 1.375 <= y <= 1.5 2^-21, degree 10, 59.7 bits */
    {0x1.4b7bf3d371601p-23, 0x1.a041cddcb20c7p-77, 0x1.a87ebcad8caf9p-24, 0x1.80f98e543d654p-36, -0x1.4549530c62b65p-39,
     0x1.381311f9051fdp-41, -0x1.8f5a0f5882782p-43, 0x1.2a236c255aa5ap-44, -0x1.ea99e1923fabcp-46,
     0x1.afb29ac26235ep-47, -0x1.8ffc51bb18e3cp-48, 0x1.8004c253b2d14p-49},
     /* [260] 1.5 <= y <= 1.625 2^-21, degree 10, 58.3 bits */
    {0x1.66040f1f87e45p-23, -0x1.09e8ac37b85f6p-77, 0x1.a884a33e32bfcp-24, 0x1.729597fa0feffp-36,
     -0x1.21d7db78d35bfp-39, 0x1.017775a602b4ap-41, -0x1.31104006924b9p-43, 0x1.a5c045352b5aep-45,
     -0x1.414cf65eab8b9p-46, 0x1.05c7e3f596662p-47, -0x1.c104a11a14b4bp-49, 0x1.8f271f56fa48cp-50},
     /* [261] 1.625 <= y <= 1.75 2^-21, degree 10, 62.0 bits */
    {0x1.808c871913704p-23, 0x1.7256e327bb926p-85, 0x1.a88a535e78c25p-24, 0x1.65b56200ed3dbp-36, -0x1.0466c3068a76bp-39,
     0x1.aeb6300f4144ap-42, -0x1.db22aea2d013dp-44, 0x1.31c9118c5d8c2p-45, -0x1.b1c6e58986b4ap-47,
     0x1.490be95fea4a3p-48, -0x1.06aa5cf0bc76bp-49, 0x1.b2c7077aa9d4cp-51},
     /* [262] 1.75 <= y <= 1.875 2^-21, degree 10, 58.8 bits */
    {0x1.9b155886b4ba1p-23, -0x1.0de864c2a261cp-77, 0x1.a88fd298def31p-24, 0x1.5a19547973633p-36,
     -0x1.d741ebbf544dap-40, 0x1.6c95931b2cf08p-42, -0x1.783c8fbdf8641p-44, 0x1.c506f7c13771bp-46,
     -0x1.2c97ccc89a52p-47, 0x1.aa9d1ec44e3afp-49, -0x1.3e826dd8a7dadp-50, 0x1.ed3160c738f99p-52},
     /* [263] 1.875 <= y <= 2 2^-21, degree 10, 59.2 bits */
    {0x1.c2e3341c4c1b6p-23, 0x1.69179b90c926ep-77, 0x1.a897bfc1485f5p-23, 0x1.4aa4c2ec80266p-34, -0x1.9a52ce76460f8p-37,
     0x1.216c87901af9dp-38, -0x1.10511b344652bp-39, 0x1.2af67b67e7353p-40, -0x1.69b9c090127dep-41,
     0x1.d4135769cd3d9p-42, -0x1.3fc0748745514p-42, 0x1.c3844a559c4adp-43},
     /* [264] 1 <= y <= 1.125 2^-20, degree 10, 57.8 bits */
    {0x1.f7f6ce5460b0bp-23, -0x1.31a6a6cb91c75p-77, 0x1.a8a1cc2ee2b2ep-23, 0x1.38f46d535a59ap-34,
     -0x1.5b50eb237ad8cp-37, 0x1.b65e8f501808bp-39, -0x1.710916e51b4c8p-40, 0x1.6a7eb3df9e262p-41,
     -0x1.886d079a84b4cp-42, 0x1.c658dee25a0a4p-43, -0x1.156c3af15c7acp-43, 0x1.5e7cdf801d5adp-44},
     /* [265] 1.125 <= y <= 1.25 2^-20, degree 10, 62.3 bits */
    {0x1.1685d0dbedfa1p-22, 0x1.d5d65890cbbb6p-76, 0x1.a8ab55ea2518cp-23, 0x1.29db0177bd1cfp-34, -0x1.2aefc1533ca07p-37,
     0x1.555bed45a351fp-39, -0x1.03fefc4575f56p-40, 0x1.ce205cb5571cp-42, -0x1.c4a2be91f8f4fp-43, 0x1.da25306b6c316p-44,
     -0x1.05bf20f812ab6p-44, 0x1.2b2d280382b0dp-45}, /* [266] 1.25 <= y <= 1.375 2^-20, degree 10, 59.9 bits */
    {0x1.3110cf9090967p-22, 0x1.65069038d64e7p-77, 0x1.a8b46f39dbb93p-23, 0x1.1cc508856f6efp-34, -0x1.04d5d5034149ep-37,
     0x1.0ff0c690c54cap-39, -0x1.7a3835529d006p-41, 0x1.32e62eabd3e12p-42, -0x1.1274c954a671fp-43,
     0x1.067f610932c9fp-44, -0x1.087860b993525p-45, 0x1.13fe8c834c7eep-46},
     /* [267] 1.375 <= y <= 1.5 2^-20, degree 10, 60.7 bits */
    {0x1.4b9c5cb8c0216p-22, -0x1.74fc5b1a1a82fp-77, 0x1.a8bd267e0d5bfp-23, 0x1.11493bc967628p-34,
     -0x1.cc63e0c3b4691p-38, 0x1.b9938f68d030fp-40, -0x1.1a817c4f27b5cp-41, 0x1.a5c97b2d2c668p-43,
     -0x1.5b057956ce702p-44, 0x1.3158ff107823p-45, -0x1.1ae92097591a7p-46, 0x1.0f9cb7be4b2cfp-47},
     /* [268] 1.5 <= y <= 1.625 2^-20, degree 10, 58.6 bits */
    {0x1.6628729360c96p-22, 0x1.7ac1eaf34b35fp-76, 0x1.a8c587433a821p-23, 0x1.071a2b3f2bda5p-34, -0x1.9a3d0de3eeb6cp-38,
     0x1.6c50be9c25ee7p-40, -0x1.af9e1d3f052fdp-42, 0x1.2a5662b5ac04cp-43, -0x1.c68af9317020ep-45,
     0x1.72543a121c3b3p-46, -0x1.3d9846d06e3ep-47, 0x1.1a51bd3b30f6bp-48},
     /* [269] 1.625 <= y <= 1.75 2^-20, degree 10, 58.8 bits */
    {0x1.80b50c067e434p-22, -0x1.8230a9c4065fap-76, 0x1.a8cd9afb23c13p-23, 0x1.fbfae074f3d5ep-35,
     -0x1.7093f501a830dp-38, 0x1.30bc1399a7de5p-40, -0x1.502082e30c53fp-42, 0x1.b09e264090f29p-44,
     -0x1.32d5ca7a6a0c4p-45, 0x1.d17dea427cddp-47, -0x1.739355024f8d6p-48, 0x1.3384fa18d2684p-49},
     /* [270] 1.75 <= y <= 1.875 2^-20, degree 10, 58.8 bits */
    {0x1.9b422481dd1dfp-22, 0x1.b123c8425081cp-76, 0x1.a8d5697cfbb1p-23, 0x1.eb8c1bb63a1a1p-35, -0x1.4d860ac91b4ap-38,
     0x1.01f41c365243dp-40, -0x1.0a2aaabd273bfp-42, 0x1.40785f8ff8859p-44, -0x1.a94211ba86c38p-46,
     0x1.2dc30815c6de3p-47, -0x1.c2942fc2633f4p-49, 0x1.5cd7118f99bd3p-50},
     /* [271] 1.875 <= y <= 2 2^-20, degree 10, 58.6 bits */
    {0x1.c316ae85a2a5cp-22, 0x1.96420a1e665c4p-79, 0x1.a8e0aba0a3e74p-22, 0x1.d5ab9f6b645e6p-33, -0x1.226915c3a911bp-35,
     0x1.998ff8395efffp-37, -0x1.814e929ed1d3dp-38, 0x1.a6faa4704b0b7p-39, -0x1.ffc0c6ddd6bbdp-40,
     0x1.4b183c9d79c74p-40, -0x1.c457bb953b7aep-41, 0x1.3f5dcf2b389a3p-41},
     /* [272] 1 <= y <= 1.125 2^-19, degree 10, 57.8 bits */
    {0x1.f833aa76430f5p-22, -0x1.eb433790f6ee5p-78, 0x1.a8eef20d2b4b8p-22, 0x1.bca183a21ac9dp-33,
     -0x1.eba875fa5c4dfp-36, 0x1.362d92e229102p-37, -0x1.0515e399a33d3p-38, 0x1.007066c4fb334p-39,
     -0x1.159966f6bac23p-40, 0x1.4163e32540762p-41, -0x1.8877e72f36eacp-42, 0x1.efd26764c75dfp-43},
     /* [273] 1.125 <= y <= 1.25 2^-19, degree 10, 58.4 bits */
    {0x1.16a931ab19765p-21, -0x1.214e9e70405a7p-77, 0x1.a8fc7f766421fp-22, 0x1.a741859bcb5c2p-33,
     -0x1.a731620bfa4ecp-36, 0x1.e316a7386de3p-38, -0x1.6fe4ea709278bp-39, 0x1.46edbedd9a82cp-40,
     -0x1.4032a22adf773p-41, 0x1.4f66a729cb9f6p-42, -0x1.724c3b536f15cp-43, 0x1.a73d8cf56b6afp-44},
     /* [274] 1.25 <= y <= 1.375 2^-19, degree 10, 62.6 bits */
    {0x1.313961da1a214p-21, -0x1.9c8047883f1f2p-76, 0x1.a9096db993c36p-22, 0x1.94bafcca5ced7p-33,
     -0x1.714580997e202p-36, 0x1.80dc2e7c58a14p-38, -0x1.0b98d613ee19bp-39, 0x1.b23cd4b2db826p-41,
     -0x1.844febb76f6cp-42, 0x1.7360b75032d8ep-43, -0x1.7628388e20e0fp-44, 0x1.86737cdbd19efp-45},
     /* [275] 1.375 <= y <= 1.5 2^-19, degree 10, 59.2 bits */
    {0x1.4bca5c7eb491dp-21, -0x1.2e40e510d6c36p-77, 0x1.a915d12ebe0d5p-22, 0x1.8478f18d280e9p-33,
     -0x1.45e860bdd66c9p-36, 0x1.387a159c2ecccp-38, -0x1.8fc3f25ad4698p-40, 0x1.2a675410ac3cap-41,
     -0x1.eafd599ae166dp-43, 0x1.b002418bd62a7p-44, -0x1.90407a43917a2p-45, 0x1.8041dfb382114p-46},
     /* [276] 1.5 <= y <= 1.625 2^-19, degree 10, 58.3 bits */
    {0x1.665c197358c45p-21, -0x1.576f49825b09cp-78, 0x1.a921ba2e17862p-22, 0x1.760dcfea5bae5p-33,
     -0x1.226afdc7d7b0fp-36, 0x1.01cfb9adfde43p-38, -0x1.31644424d88d3p-40, 0x1.a6240df809349p-42,
     -0x1.4190a24423392p-43, 0x1.05fa112e243fap-44, -0x1.c1541eb73d69bp-46, 0x1.8f691e5994475p-47},
     /* [277] 1.625 <= y <= 1.75 2^-19, degree 10, 58.6 bits */
    {0x1.80ee917f08844p-21, 0x1.e714d8a1cbf7cp-76, 0x1.a92d361576dddp-22, 0x1.6926f36c8a6cfp-33, -0x1.04efa05b1cce9p-36,
     0x1.af4f1f7fd9d8fp-39, -0x1.dbaa3ac151013p-41, 0x1.321403e229d6fp-42, -0x1.b2258b455a254p-44, 0x1.494d408e8985p-45,
     -0x1.06da8a4cfcfe5p-46, 0x1.b311825f0ffb3p-48}, /* [278] 1.75 <= y <= 1.875 2^-19, degree 10, 58.5 bits */
    {0x1.9b81be2bb13e6p-21, -0x1.127905e546472p-76, 0x1.a9384ffdb8f62p-22, 0x1.5d84b25a7306ep-33,
     -0x1.d841c5704edbap-37, 0x1.6d1b571db26b4p-39, -0x1.78ab7b3a97ee4p-41, 0x1.c579b8592739ap-43,
     -0x1.2cdb9607a54ep-44, 0x1.aaf4ad78bf30bp-46, -0x1.3ebecfe662ba3p-47, 0x1.ed88b49f6151ep-49},
     /* [279] 1.875 <= y <= 2 2^-19, degree 10, 59.9 bits */
    {0x1.c35fc744beca1p-21, 0x1.252d5cd6d57cap-75, 0x1.a9485322a9289p-21, 0x1.4e078c32464f8p-31, -0x1.9b3bcc2895e9ep-34,
     0x1.21dba50f1107ap-35, -0x1.10a52075b7e05p-36, 0x1.2b45be09c15d6p-37, -0x1.6a0f2279e1e27p-38,
     0x1.d477e679f6de9p-39, -0x1.3fffe21c3b433p-39, 0x1.c3d7f2ba6915ep-40},
     /* [280] 1 <= y <= 1.125 2^-18, degree 10, 58.7 bits */
    {0x1.f88a19882adabp-21, 0x1.5e6a1d4dbf9bdp-75, 0x1.a95ca1d65ae4p-21, 0x1.3c4ce54fe6301p-31, -0x1.5c211108d6f39p-34,
     0x1.b7104b7102c5bp-36, -0x1.71815c32c913bp-37, 0x1.6ae43b78129bdp-38, -0x1.88cf04909b9p-39, 0x1.c6b89d89f67fdp-40,
     -0x1.158bba896c817p-40, 0x1.651a52beda064p-41}, /* [281] 1.125 <= y <= 1.25 2^-18, degree 10, 59.9 bits */
    {0x1.16db7269c064bp-20, 0x1.b07f2030765a2p-74, 0x1.a96fea88f4d6ap-21, 0x1.2d2a3444cf624p-31, -0x1.2babcfa888107p-34,
     0x1.55ed498db4b77p-36, -0x1.0457ff1296fap-37, 0x1.cea8564607557p-39, -0x1.c5195662d5e63p-40, 0x1.da9644a393baap-41,
     -0x1.05f8c8d97b9dbp-41, 0x1.2b6ab6ae40d0fp-42}, /* [282] 1.25 <= y <= 1.375 2^-18, degree 10, 59.4 bits */
    {0x1.317305647a527p-20, -0x1.f3d2134f0acf5p-74, 0x1.a98251d734a89p-21, 0x1.200bd12df6aap-31, -0x1.05814e12eaad1p-34,
     0x1.1069d9f0c8a1p-36, -0x1.7abf9dea329bp-38, 0x1.33449fa08fef3p-39, -0x1.12bfff43d180fp-40, 0x1.06c0dc0c25096p-41,
     -0x1.08b551392cdecp-42, 0x1.1439f41c36bedp-43}, /* [283] 1.375 <= y <= 1.5 2^-18, degree 10, 60.7 bits */
    {0x1.4c0bb88d25ee1p-20, 0x1.6e0dcdc41518cp-74, 0x1.a993f48da5419p-21, 0x1.1488509c6de14p-31, -0x1.cd9efcca2945ep-35,
     0x1.ba6059c6dd119p-37, -0x1.1aeadb719e1a7p-38, 0x1.a650b7b4ecaefp-40, -0x1.5b68900844f2fp-41,
     0x1.31a85e0aaae3cp-42, -0x1.1b2d0fbe339a9p-43, 0x1.0fd9a49872342p-44},
     /* [284] 1.5 <= y <= 1.625 2^-18, degree 10, 58.6 bits */
    {0x1.66a58059d567fp-20, -0x1.bb63fc28c340bp-74, 0x1.a9a4e9cfc15b8p-21, 0x1.0a522653cc77cp-31,
     -0x1.9b60785a1db97p-35, 0x1.6d002f0a70125p-37, -0x1.b0454ddf219eap-39, 0x1.2ab9bbee6ffd4p-40,
     -0x1.c711c876cd14fp-42, 0x1.72b8373de58f9p-43, -0x1.3de77f6c73b7bp-44, 0x1.1a938632b4472p-45},
     /* [285] 1.625 <= y <= 1.75 2^-18, degree 10, 60.6 bits */
    {0x1.8140528f84941p-20, 0x1.adfb00a3bc3a3p-74, 0x1.a9b54489f38cbp-21, 0x1.012ed58282de4p-31, -0x1.71a2f67ccdb24p-35,
     0x1.31540a194030bp-37, -0x1.50a75c333550ep-39, 0x1.b1335ea0c745cp-41, -0x1.33340e0532bbdp-42,
     0x1.d2001bb05d3d6p-44, -0x1.73f359ae16b19p-45, 0x1.33cf363c63fdep-46},
     /* [286] 1.75 <= y <= 1.875 2^-18, degree 10, 58.6 bits */
    {0x1.9bdc2607254bep-20, -0x1.a68ef006a4774p-75, 0x1.a9c514724d74dp-21, 0x1.f1e29f2b333edp-32,
     -0x1.4e8348c48ab3ap-35, 0x1.027900e3b6cbcp-37, -0x1.0a9900162f9b2p-39, 0x1.40ea98c738319p-41,
     -0x1.a9c913d788ce7p-43, 0x1.2e1a40d9fc981p-44, -0x1.c30c8520e2168p-46, 0x1.5d2e19d9e022cp-47},
     /* [287] 1.875 <= y <= 2 2^-18, degree 10, 60.5 bits */
    {0x1.c3c7b3bf5fec3p-20, -0x1.3e0a96f2fbad1p-74, 0x1.a9dbe46048fe7p-20, 0x1.dbf127366d8cap-30,
     -0x1.234f9e9583c76p-32, 0x1.9a6cb2f0e11cfp-34, -0x1.81f5b16c7956dp-35, 0x1.a79867d7af6d6p-36,
     -0x1.00356710ea66cp-36, 0x1.4b7c6552ae983p-37, -0x1.c4d61e2322c9bp-38, 0x1.3fb12c81a0047p-38},
     /* [288] 1 <= y <= 1.125 2^-17, degree 10, 59.5 bits */
    {0x1.f90503830920fp-20, -0x1.85190f9649724p-74, 0x1.a9f8d4eb7218ap-20, 0x1.c2d2a1b186c7ep-30,
     -0x1.ed442fbbc12b2p-33, 0x1.36de0e748222p-34, -0x1.058d78d9e23fbp-35, 0x1.00d56b5892724p-36,
     -0x1.15fad2711fba8p-37, 0x1.41ca963f3ff67p-38, -0x1.88ebc18710e09p-39, 0x1.f05b25d9b5f0fp-40},
     /* [289] 1.125 <= y <= 1.25 2^-17, degree 10, 58.3 bits */
    {0x1.1722ecc3f2e64p-19, 0x1.27865a20317f8p-74, 0x1.aa14523a9c9fep-20, 0x1.ad604e5d9d69bp-30, -0x1.a8a536841966cp-33,
     0x1.e4373f3edeb18p-35, -0x1.7095e1351769ep-36, 0x1.477503ef22f0cp-37, -0x1.40a8abc29c9d4p-38,
     0x1.4fd73e4ca5f36p-39, -0x1.72bf13ca8484ap-40, 0x1.a7b831ca8212dp-41},
     /* [290] 1.25 <= y <= 1.375 2^-17, degree 10, 61.6 bits */
    {0x1.31c505635f9a6p-19, 0x1.5c178f41f36dp-73, 0x1.aa2e902666612p-20, 0x1.9ac92320fb418p-30, -0x1.729869b542399p-33,
     0x1.81cc7fda3e0f3p-35, -0x1.0c1f695c96407p-36, 0x1.b2f8b2e8d1e21p-38, -0x1.84e59cb2fa92ep-39, 0x1.73e3174201d8p-40,
     -0x1.76a196f9c75acp-41, 0x1.86e9d3d013d6fp-42}, /* [291] 1.375 <= y <= 1.5 2^-17, degree 10, 59.1 bits */
    {0x1.4c68b8fc44466p-19, 0x1.f02614250de8dp-76, 0x1.aa47b777a240bp-20, 0x1.8a77df54ab126p-30, -0x1.471faa8db4695p-33,
     0x1.3945465eb9ceap-35, -0x1.909559e46558cp-37, 0x1.2aedd093310cdp-38, -0x1.ebc288ab8d496p-40,
     0x1.b0a0439361703p-41, -0x1.90c7c2313271p-42, 0x1.80bb3a0fbd379p-43},
     /* [292] 1.5 <= y <= 1.625 2^-17, degree 10, 58.6 bits */
    {0x1.670df73443ac4p-19, 0x1.809e2fe0585a5p-75, 0x1.aa5fe8f383866p-20, 0x1.7bfeb6e926814p-30, -0x1.238ac61a01229p-33,
     0x1.027dc0ed31203p-35, -0x1.320a5cc4a9c2ap-37, 0x1.a6e99dcc5cef2p-39, -0x1.4216bf4bcc372p-40,
     0x1.065d94609c185p-41, -0x1.c1f1db37637c4p-43, 0x1.8fec2295c3736p-44},
     /* [293] 1.625 <= y <= 1.75 2^-17, degree 10, 61.0 bits */
    {0x1.81b4b18b56f2fp-19, -0x1.d909015fb0f02p-74, 0x1.aa773f6766473p-20, 0x1.6f0ad96761912p-30,
     -0x1.05fb2a46ad89ap-33, 0x1.b07c89d0e7f99p-36, -0x1.dcb61d3f6b0bdp-38, 0x1.32a85bee71574p-39,
     -0x1.b2e11219933e9p-41, 0x1.49ceceb09a8f7p-42, -0x1.073a1e59f693cp-43, 0x1.b3a556359f4p-45},
     /* [294] 1.75 <= y <= 1.875 2^-17, degree 10, 58.9 bits */
    {0x1.9c5cdb085504p-19, 0x1.9f0a308e0fba7p-74, 0x1.aa8dd1143d28bp-20, 0x1.635c79ec9797p-30, -0x1.da359e576f2p-34,
     0x1.6e22e03f04093p-36, -0x1.7986a06ba57dep-38, 0x1.c65cca71a1d83p-40, -0x1.2d61dbd7f2d3cp-41,
     0x1.aba23e7715cb2p-43, -0x1.3f36946821e88p-44, 0x1.ee35ff501f33ep-46},
     /* [295] 1.875 <= y <= 2 2^-17, degree 10, 59.0 bits */
    {0x1.c45bb06114d5cp-19, 0x1.b198c160c9508p-73, 0x1.aaae62cc94af9p-19, 0x1.53ce9207fe3e2p-28, -0x1.9d029ee336509p-31,
     0x1.22b670730507dp-32, -0x1.114b0dc135c3p-33, 0x1.2be2855bb18fdp-34, -0x1.6ab833ff5dcd6p-35, 0x1.d53f2ca567cf3p-36,
     -0x1.407da6fecab5fp-36, 0x1.c47de8f1db652p-37}, /* [296] 1 <= y <= 1.125 2^-16, degree 10, 59.5 bits */
    {0x1.f9b417f912d83p-19, 0x1.c9213a9bfa575p-75, 0x1.aad7b7cc7fc0ep-19, 0x1.41ffc9a24590ap-28, -0x1.5db6fce3c0cdfp-31,
     0x1.b86e090797f09p-33, -0x1.726ebeb7e8082p-34, 0x1.6bacf2668f84p-35, -0x1.899094fb90d7fp-36, 0x1.c78c47c71a2eep-37,
     -0x1.1619a54e79504p-37, 0x1.5f49953fa0adp-38}, /* [297] 1.125 <= y <= 1.25 2^-16, degree 10, 58.1 bits */
    {0x1.1788c4369291fp-18, -0x1.2a3e4d15848bap-72, 0x1.aafefe682f68p-19, 0x1.32cb06a68d234p-28, -0x1.2d1a35441e93ep-31,
     0x1.570b25070348ap-33, -0x1.05079770d731ep-34, 0x1.cfb50bd120dbcp-36, -0x1.c603f77fd144ep-37,
     0x1.db762ce93d4fbp-38, -0x1.066b05b6c6e04p-38, 0x1.2be4be61e814fp-39},
     /* [298] 1.25 <= y <= 1.375 2^-16, degree 10, 58.9 bits */
    {0x1.3239e25ca6007p-18, 0x1.4fd4ec6a11eadp-72, 0x1.ab248014b6179p-19, 0x1.259c406332373p-28, -0x1.06cf19929a609p-31,
     0x1.1157cff391ac9p-33, -0x1.7bca9cf9da463p-35, 0x1.33ff2cfc09e9bp-36, -0x1.1354bd46dc07fp-37,
     0x1.07427888c9df4p-38, -0x1.092e055d20a2cp-39, 0x1.14afae24a01a4p-40},
     /* [299] 1.375 <= y <= 1.5 2^-16, degree 10, 59.2 bits */
    {0x1.4ced4bffb6ca5p-18, 0x1.13842159091bfp-74, 0x1.ab48769c45b3bp-19, 0x1.1a09c2f5bcb02p-28, -0x1.d003e206241b9p-32,
     0x1.bbf29f14442f7p-34, -0x1.1bba883e3610ep-35, 0x1.a75bbef254171p-37, -0x1.5c2c74adca88p-38, 0x1.32456b7abe84bp-39,
     -0x1.1bb393ace286fp-40, 0x1.105258cc3e0e7p-41}, /* [300] 1.5 <= y <= 1.625 2^-16, degree 10, 58.9 bits */
    {0x1.67a2e9ede65c8p-18, -0x1.76fd7a393641ep-72, 0x1.ab6b106efe42bp-19, 0x1.0fc5ca80938b5p-28,
     -0x1.9d96d60cfeca5p-32, 0x1.6e589e6194832p-34, -0x1.b18eac35ed918p-36, 0x1.2b7dd3536652fp-37,
     -0x1.c81c33ac0ca27p-39, 0x1.737e005345011p-40, -0x1.3e8450846fe21p-41, 0x1.1b15d1a2a297ap-42},
     /* [301] 1.625 <= y <= 1.75 2^-16, degree 10, 58.8 bits */
    {0x1.825aa79588c72p-18, -0x1.e020c08f677c6p-72, 0x1.ab8c7388b5922p-19, 0x1.0695ae8ec7483p-28,
     -0x1.73b144a65b221p-32, 0x1.327e3c1944a48p-34, -0x1.51b0e7ecece98p-36, 0x1.b259c9ef628b4p-38,
     -0x1.33ee48546eb42p-39, 0x1.d3018f64d1e02p-41, -0x1.74b15c8bbd0a7p-42, 0x1.346233bbd35f4p-43},
     /* [302] 1.75 <= y <= 1.875 2^-16, degree 10, 59.2 bits */
    {0x1.9d14728ee5b0ep-18, 0x1.ef3bb544563b9p-72, 0x1.abacbf73ae8bbp-19, 0x1.fc987b629d744p-29, -0x1.506ebd84b5356p-32,
     0x1.037da7691a7c9p-34, -0x1.0b722f17bfb71p-36, 0x1.41cbe3096410dp-38, -0x1.aad3b710ba157p-40,
     0x1.2ec6ae1c32452p-41, -0x1.c3fa9528e0cp-43, 0x1.5dda62bc8a59ap-44},
     /* [303] 1.875 <= y <= 2 2^-16, degree 10, 59.4 bits */
    {0x1.c52ed81cb6991p-18, -0x1.8a54a835b1b7ap-73, 0x1.abdb5ecabcb5fp-18, 0x1.e686125f96794p-27,
     -0x1.250e8d7a9d89fp-29, 0x1.9c1d55055b46bp-31, -0x1.833e78e5c1631p-32, 0x1.a8cf6abdf577fp-33,
     -0x1.00dd3a2341af6p-33, 0x1.4c4250898ea0bp-34, -0x1.c5d00de70f5ecp-35, 0x1.405622f8943cp-35},
     /* [304] 1 <= y <= 1.125 2^-15, degree 10, 58.5 bits */
    {0x1.faadff74045a3p-18, 0x1.816f208a582dap-72, 0x1.ac168ff997eap-18, 0x1.cd4000332654fp-27, -0x1.f06161145f7aap-30,
     0x1.3837abea79604p-31, -0x1.06789083e5765p-32, 0x1.019c70a6a482cp-33, -0x1.16bb06f8e95f7p-34,
     0x1.42956b556da51p-35, -0x1.89d0c0428fc8bp-36, 0x1.f1699c75b8c9ap-37},
     /* [305] 1.125 <= y <= 1.25 2^-15, degree 10, 59.3 bits */
    {0x1.181a2e8246ba7p-17, -0x1.f240831b5af6dp-73, 0x1.ac4ed6025d937p-18, 0x1.b7aa32efecd57p-27,
     -0x1.ab744e6a42009p-30, 0x1.e66bf78647adcp-32, -0x1.71f18cf0a4e0fp-33, 0x1.487f5cded7afp-34,
     -0x1.41916e3511703p-35, 0x1.50b5802b57b9ep-36, -0x1.73a1f9e477d9p-37, 0x1.a8aaa9b989e7ep-38},
     /* [306] 1.25 <= y <= 1.375 2^-15, degree 10, 59.4 bits */
    {0x1.32e0cd18de99fp-17, -0x1.2714c51faf485p-71, 0x1.ac84990c09a79p-18, 0x1.a4f2e0c551adcp-27,
     -0x1.75271cfbce09dp-30, 0x1.83a2670696a31p-32, -0x1.0d27a3f81e9a3p-33, 0x1.b46a6915474aap-35,
     -0x1.860ca4ac355b7p-36, 0x1.74e4560a69fe2p-37, -0x1.779145a5516bcp-38, 0x1.87d3b09338e1dp-39},
     /* [307] 1.375 <= y <= 1.5 2^-15, degree 10, 58.4 bits */
    {0x1.4daab5f65759fp-17, -0x1.e011fd245385fp-71, 0x1.acb82b0941c23p-18, 0x1.9484399e8a1bap-27,
     -0x1.49785fd14b962p-30, 0x1.3ad24d350ae61p-32, -0x1.923042ed7ec1p-34, 0x1.2bf65691ce86ep-35,
     -0x1.ed46fc809ab92p-37, 0x1.b1d7e5749c876p-38, -0x1.91d2ce0ba2968p-39, 0x1.81aaf3486723ap-40},
     /* [308] 1.5 <= y <= 1.625 2^-15, degree 10, 62.3 bits */
    {0x1.6877c82b1d844p-17, 0x1.e349c282187b1p-71, 0x1.ace9cdd5b3475p-18, 0x1.85f00354eede3p-27, -0x1.25b59144c8675p-30,
     0x1.03d19245787b7p-32, -0x1.33501be489919p-34, 0x1.a86e036c4ae0fp-36, -0x1.431ed526fca6ap-37,
     0x1.0721c32457144p-38, -0x1.c3291ba116fedp-40, 0x1.90eeda28d710ep-41},
     /* [309] 1.625 <= y <= 1.75 2^-15, degree 10, 58.5 bits */
    {0x1.8347e680f9547p-17, 0x1.253c4f4b7cb36p-71, 0x1.ad19b7512af74p-18, 0x1.78e3171c8fb17p-27, -0x1.07fe7127d48p-30,
     0x1.b2c8b9893acb4p-33, -0x1.dec335c819c04p-35, 0x1.33cbdc177b5b6p-36, -0x1.b4522cfbc7556p-38,
     0x1.4ace1dbcbc24cp-39, -0x1.07f6a5ab3098dp-40, 0x1.b4c9259c26904p-42},
     /* [310] 1.75 <= y <= 1.875 2^-15, degree 10, 59.0 bits */
    {0x1.9e1af6d36fbc1p-17, -0x1.687584621bb4ep-72, 0x1.ad481438fc2e3p-18, 0x1.6d1d63211e123p-27,
     -0x1.ddf771ae57a94p-31, 0x1.7024d4a57077ap-33, -0x1.7b33f7ee9971fp-35, 0x1.c81acae2fa17ep-37,
     -0x1.2e6a0987fbd1dp-38, 0x1.acf8276b2964ep-40, -0x1.4022bcc745863p-41, 0x1.ef8bf53556a04p-43},
     /* [311] 1.875 <= y <= 2 2^-15, degree 10, 59.4 bits */
    {0x1.c65ce20fc87b5p-17, 0x1.1a501bb6efa63p-72, 0x1.ad8b08c3b42ep-17, 0x1.5d6f4212a7d0fp-25, -0x1.a06cad1657c2ap-28,
     0x1.2460c4dc322c4p-29, -0x1.128fe5eb80481p-30, 0x1.2d1643182a6edp-31, -0x1.6c04a5e60ff04p-32,
     0x1.d6c7839eec106p-33, -0x1.417584d075f86p-33, 0x1.c5c53fd9400e6p-34},
     /* [312] 1 <= y <= 1.125 2^-14, degree 10, 57.8 bits */
    {0x1.fc139ff2cc48cp-17, -0x1.7cc78c1946493p-77, 0x1.ade01602cba12p-17, 0x1.4b79d1de1169bp-25,
     -0x1.60c1ce68607c5p-28, 0x1.bb16c867b9e79p-30, -0x1.743f11b5097b8p-31, 0x1.6d36a0aa072bdp-32,
     -0x1.8b0d2af808931p-33, 0x1.c91e354a88a7ap-34, -0x1.16fca9bbc7e2ep-34, 0x1.6055d5dad0d24p-35},
     /* [313] 1.125 <= y <= 1.25 2^-14, degree 10, 58.7 bits */
    {0x1.18ea5db07268dp-16, 0x1.4ae17099917c9p-72, 0x1.ae30fd5469a69p-17, 0x1.3c226a01ee26ep-25, -0x1.2fd821f6ccc91p-28,
     0x1.5936fca888fe4p-30, -0x1.065ec486d22e1p-31, 0x1.d1c3af9941e52p-33, -0x1.c7d0ade5c8e2p-34, 0x1.dd2e7080a9ac1p-35,
     -0x1.074be2f124b57p-35, 0x1.2cd52766b864fp-36}, /* [314] 1.25 <= y <= 1.375 2^-14, degree 10, 59.2 bits */
    {0x1.33cfdc9e371c2p-16, -0x1.12fdffdab653fp-71, 0x1.ae7e528a9289ep-17, 0x1.2ed444831d4edp-25,
     -0x1.094da8feeeb7dp-28, 0x1.1326155fa118dp-30, -0x1.7dd40258d0d94p-32, 0x1.356c8ac3d8289p-33,
     -0x1.14789eb3e92a1p-34, 0x1.08412be9dbbd2p-35, -0x1.0a1b7ac17d6cp-36, 0x1.15977d05781c1p-37},
     /* [315] 1.375 <= y <= 1.5 2^-14, degree 10, 60.1 bits */
    {0x1.4eba1766ee84p-16, 0x1.fffa737bc802ep-70, 0x1.aec889f89141dp-17, 0x1.23251ff2e45a4p-25, -0x1.d496cc7df775ap-29,
     0x1.beff63481b949p-31, -0x1.1d4fc858d1becp-32, 0x1.a96661b7b017ap-34, -0x1.5daca15e40426p-35,
     0x1.3379df6c4c028p-36, -0x1.1cbc1132b1f91p-37, 0x1.113fe5d75b4bcp-38},
     /* [316] 1.5 <= y <= 1.625 2^-14, degree 10, 59.9 bits */
    {0x1.69a8df341ae3bp-16, 0x1.a0e31f431728ap-71, 0x1.af10011e864a3p-17, 0x1.18c6cbda35abcp-25, -0x1.a1cf7b13ac914p-29,
     0x1.70f490967f81cp-31, -0x1.b410f035ed8fbp-33, 0x1.2cfd61a4c9f98p-34, -0x1.ca266381c25a4p-36,
     0x1.75023f690f7f8p-37, -0x1.3fb880196af6p-38, 0x1.1c161f6fa7ae5p-39},
     /* [317] 1.625 <= y <= 1.75 2^-14, degree 10, 59.1 bits */
    {0x1.849c0a78d9877p-16, -0x1.c2fa799e5f6dbp-70, 0x1.af55047beef9dp-17, 0x1.0f7e4aa3761c1p-25,
     -0x1.779c418267416p-29, 0x1.34c00b24588b5p-31, -0x1.53b65ea45c2f9p-33, 0x1.b49954cdff553p-35,
     -0x1.355b182b65fabp-36, 0x1.d4faac805779p-38, -0x1.76269ad0b6de3p-39, 0x1.35833780d261cp-40},
     /* [318] 1.75 <= y <= 1.875 2^-14, degree 10, 59.1 bits */
    {0x1.9f9374040e14p-16, 0x1.bfb2ba90144d4p-70, 0x1.af97d39a1ba97p-17, 0x1.071e26eaf9713p-25, -0x1.54163a0f2bdb9p-29,
     0x1.0576529ee6257p-31, -0x1.0d19221e21072p-33, 0x1.43840ac4dc3b4p-35, -0x1.acddc634bf654p-37,
     0x1.3018d0157020fp-38, -0x1.c5ce00380b0aep-40, 0x1.5f2cfce9aea24p-41},
     /* [319] 1.875 <= y <= 2 2^-14, degree 10, 59.3 bits */
    {0x1.c80e3e90e9994p-16, 0x1.35e0a58724bedp-76, 0x1.aff85b07cd2f8p-16, 0x1.f7eb3db8d94ecp-24, -0x1.285fe17a7882cp-26,
     0x1.9f621259f190dp-28, -0x1.85be28fae63bp-29, 0x1.ab2e8e20ddef9p-30, -0x1.022592ae3662dp-30, 0x1.4dc62b7c42e2p-31,
     -0x1.c7ba785533c11p-32, 0x1.419a266acebbcp-32}, /* [320] 1 <= y <= 1.125 2^-13, degree 10, 58.0 bits */
    {0x1.fe15061b71745p-16, 0x1.79c4c67db98fdp-72, 0x1.b0730d1f1fe98p-16, 0x1.de5a16f5768e5p-24, -0x1.f6492fff77235p-27,
     0x1.3ad3327c4f841p-28, -0x1.084173145358fp-29, 0x1.03208ec02bfb6p-30, -0x1.18326973c56f1p-31,
     0x1.442c4f09f2246p-32, -0x1.8c14917d014a8p-33, 0x1.e1b4d40eaa8b5p-34},
     /* [321] 1.125 <= y <= 1.25 2^-13, degree 10, 58.1 bits */
    {0x1.1a1561773016bp-15, -0x1.9214724cfc2b7p-80, 0x1.b0e7d729e40adp-16, 0x1.c8811323d42e8p-24,
     -0x1.b0c55dd6988b8p-27, 0x1.eaad47cfe5fa7p-29, -0x1.749480f4db7b9p-30, 0x1.4a864b5081221p-31,
     -0x1.435801b404c48p-32, 0x1.52685380c0a31p-33, -0x1.755e7cdeaf4e9p-34, 0x1.aa8632189a43ap-35},
     /* [322] 1.25 <= y <= 1.375 2^-13, degree 10, 58.1 bits */
    {0x1.352762daf093ap-15, -0x1.9047bbcc1dcb7p-73, 0x1.b1578b3ca91bap-16, 0x1.b58cf40935888p-24,
     -0x1.79fc092a86ffep-27, 0x1.872bbb465a76ep-29, -0x1.0f281716198eep-30, 0x1.b73a170b06fb4p-32,
     -0x1.884c5e186ee12p-33, 0x1.76db3b7ad5156p-34, -0x1.79667e6a9fa0fp-35, 0x1.899e0943174d5p-36},
     /* [323] 1.375 <= y <= 1.5 2^-13, degree 10, 58.6 bits */
    {0x1.50403b36853fap-15, 0x1.eee599f067407p-69, 0x1.b1c2ceb2bc99bp-16, 0x1.a4e6d33d1a89ep-24, -0x1.4de554ea26269p-27,
     0x1.3dce5b99deea2p-29, -0x1.954c6f3777c47p-31, 0x1.2df8d3c0e9a9p-32, -0x1.f03c6ea5a05f3p-34, 0x1.b438ae444bc2fp-35,
     -0x1.93dd3eb37646ap-36, 0x1.83807bf865d12p-37}, /* [324] 1.5 <= y <= 1.625 2^-13, degree 10, 58.7 bits */
    {0x1.6b5fa7cc99c2dp-15, 0x1.c04bf25890d14p-70, 0x1.b22a267c7dd1ep-16, 0x1.961fa12c9c628p-24, -0x1.29ca3633eae34p-27,
     0x1.065ed4225e49ep-29, -0x1.35c6b45872218p-31, 0x1.ab60d4de36769p-33, -0x1.45216658ea37dp-34,
     0x1.08a0c090fc8c1p-35, -0x1.c589a40499c31p-37, 0x1.92e947c2a1b92p-38},
     /* [325] 1.625 <= y <= 1.75 2^-13, degree 10, 58.9 bits */
    {0x1.86856d6497efdp-15, -0x1.8503bec34e096p-69, 0x1.b28dff63468ffp-16, 0x1.88e38fd66b04fp-24,
     -0x1.0bc7289707aaap-27, 0x1.b7324802f76bdp-30, -0x1.e2bad8f2c4daap-32, 0x1.3601f0447b653p-33,
     -0x1.b720dfc0c3042p-35, 0x1.4cc03606e1533p-36, -0x1.09670492c4608p-37, 0x1.b70405dcafb27p-39},
     /* [326] 1.75 <= y <= 1.875 2^-13, degree 10, 59.6 bits */
    {0x1.a1b156f8c8dd8p-15, 0x1.3c85e34c823p-69, 0x1.b2eeb3c6200d7p-16, 0x1.7cf207fc6ad42p-24, -0x1.e504f46ba31e2p-28,
     0x1.73fedd9cb1d87p-30, -0x1.7e71b8b1ed2ap-32, 0x1.cb7c46fb74dd6p-34, -0x1.306c16a21b12ep-35, 0x1.af92cac0a4ff7p-37,
     -0x1.41efe741d87adp-38, 0x1.f2289303e0dc5p-40}, /* [327] 1.875 <= y <= 2 2^-13, degree 10, 58.7 bits */
    {0x1.ca7e5161660b3p-15, -0x1.fa2f2bd06dd09p-69, 0x1.b37a8115bc415p-15, 0x1.6d077a53a36eep-22,
     -0x1.a6d1e9a1409adp-25, 0x1.27918da9af0e2p-26, -0x1.1502f7f62a423p-27, 0x1.2f6ad4c36a73ap-28,
     -0x1.6e8aeceba17a7p-29, 0x1.d9c3ce3b06a55p-30, -0x1.435927005ad4bp-30, 0x1.c844c751436b5p-31},
     /* [328] 1 <= y <= 1.125 2^-12, degree 10, 58.5 bits */
    {0x1.007c6b8a35133p-14, 0x1.a2da2f668ae9cp-68, 0x1.b42c55411847ap-15, 0x1.5ac9ba76fa5fbp-22, -0x1.6670bcc1a9a66p-25,
     0x1.c02cba3dc720ap-27, -0x1.77be16f3d46bdp-28, 0x1.7030d03c03169p-29, -0x1.8df0297f20b03p-30,
     0x1.cc2c51e0eec95p-31, -0x1.18b7285fbd34fp-31, 0x1.626168d903158p-32},
     /* [329] 1.125 <= y <= 1.25 2^-12, degree 10, 59.0 bits */
    {0x1.1bc486732992bp-14, -0x1.3a64807fa12c8p-69, 0x1.b4d5bb665bec7p-15, 0x1.4b31af1d48fb7p-22,
     -0x1.34f41e806ce5bp-25, 0x1.5d5c52cd2d9cdp-27, -0x1.08f35f4610cd8p-28, 0x1.d5be108d4c3cbp-30,
     -0x1.cb4e46ad7822ep-31, 0x1.e086461bec129p-32, -0x1.0901c2e69f6a3p-32, 0x1.2ea9f48ca4877p-33},
     /* [330] 1.25 <= y <= 1.375 2^-12, degree 10, 58.9 bits */
    {0x1.3716fc47df1fbp-14, 0x1.1fe54a43add6ap-68, 0x1.b577de9fd6c67p-15, 0x1.3da925a35ee07p-22, -0x1.0df0bf6aedf71p-25,
     0x1.1697688d92348p-27, -0x1.81be686e17e3dp-29, 0x1.382e440ba07d4p-30, -0x1.16ae2ad00920cp-31,
     0x1.0a2fcfcbe1fe8p-32, -0x1.0be975c342acfp-33, 0x1.175b203944133p-34},
     /* [331] 1.375 <= y <= 1.5 2^-12, degree 10, 58.2 bits */
    {0x1.5273607cf5cdp-14, 0x1.7dfe2ab75ae88p-68, 0x1.b613aa6ca4ffp-15, 0x1.31c4cc46da2d2p-22, -0x1.dd12a3021a8d1p-26,
     0x1.c4cdc8d91a581p-28, -0x1.2059f43b9e225p-29, 0x1.ad56ce38a9b34p-31, -0x1.6094481b3292fp-32,
     0x1.35d05bd338d88p-33, -0x1.1ebe32aa87caap-34, 0x1.130e58eddab51p-35},
     /* [332] 1.5 <= y <= 1.625 2^-12, degree 10, 58.6 bits */
    {0x1.6dd953bb4139p-14, 0x1.f1a618e95b2e9p-70, 0x1.b6a9dc2e3dc44p-15, 0x1.2735a1e38eaa6p-22, -0x1.a99f94257316cp-26,
     0x1.75ea70dbea8cfp-28, -0x1.b8e0d42e2c13ep-30, 0x1.2fe0b43d23e13p-31, -0x1.ce184221fd185p-33, 0x1.77f2e8400f52p-34,
     -0x1.420f150c99aeep-35, 0x1.1e08b1a8dac48p-36}, /* [333] 1.625 <= y <= 1.75 2^-12, degree 10, 62.9 bits */
    {0x1.89488161dd213p-14, 0x1.c10cc0d8b6a68p-72, 0x1.b73b0ee86b4fap-15, 0x1.1dc0058219186p-22, -0x1.7ed8cf4b52376p-26,
     0x1.39091fa9ca685p-28, -0x1.5795cf3f82b9p-30, 0x1.b8eda684f18dap-32, -0x1.381bfdf3fc5edp-33, 0x1.d8cd1741ef16ap-35,
     -0x1.78fafc25e87afp-36, 0x1.37b50124e7d43p-37}, /* [334] 1.75 <= y <= 1.875 2^-12, degree 10, 59.3 bits */
    {0x1.a4c09da560e55p-14, 0x1.bba34832970f3p-70, 0x1.b7c7c3699dc9p-15, 0x1.1535ff777e69p-22, -0x1.5ad2b1f7ed9b5p-26,
     0x1.0933571f46954p-28, -0x1.1042a5d13a722p-30, 0x1.46d2de21544e8p-32, -0x1.b0cda8ff11cf1p-34,
     0x1.32a7453d91c6ap-35, -0x1.c9587b7bff615p-37, 0x1.61beb3789ede9p-38},
     /* [335] 1.875 <= y <= 2 2^-12, degree 10, 59.7 bits */
    {0x1.ce04f38963445p-14, 0x1.4cb8c16c4ff7bp-73, 0x1.b8934e2bc0aa9p-14, 0x1.09d3ccf52e97cp-20, -0x1.2e791b394a428p-23,
     0x1.a591fe4b64384p-25, -0x1.8a84b372265d7p-26, 0x1.afbd1d9585a58p-27, -0x1.049eb7be004f9p-27,
     0x1.50b40742f71c7p-28, -0x1.cb708f5e73b65p-29, 0x1.440ee6aa7a467p-29},
     /* [336] 1 <= y <= 1.125 2^-11, degree 10, 58.5 bits */
    {0x1.0293d9052d385p-13, -0x1.f942b5bb91a7cp-68, 0x1.b9966d66d4366p-14, 0x1.f98cae35b4e62p-21,
     -0x1.008d2940486abp-23, 0x1.3fc0027e43009p-25, -0x1.0ba9050232b59p-26, 0x1.0609174fe2d03p-27,
     -0x1.1b06193dde7e6p-28, 0x1.47214e68fbf72p-29, -0x1.8ef65864482ap-30, 0x1.f7813717a106p-31},
     /* [337] 1.125 <= y <= 1.25 2^-11, degree 10, 58.1 bits */
    {0x1.1e35072ca9257p-13, 0x1.dab41962c0d22p-67, 0x1.ba8d7b7fc809bp-14, 0x1.e338c1dd10d89p-21, -0x1.ba7a0ecdc14ap-24,
     0x1.f2b2838edd67dp-26, -0x1.7999dbc5a3e1dp-27, 0x1.4e683b2ae359p-28, -0x1.46c2083db5e1bp-29, 0x1.55aebc84d03b8p-30,
     -0x1.78b976f76e56p-31, 0x1.ae1ec14d043fap-32}, /* [338] 1.25 <= y <= 1.375 2^-11, degree 10, 61.3 bits */
    {0x1.39e5510e363e5p-13, 0x1.a2c9b076af933p-69, 0x1.bb7a235365266p-14, 0x1.cfd5d0bb67e9bp-21, -0x1.82c6f6be7e322p-24,
     0x1.8dd2dd510aa7cp-26, -0x1.12f66796dac09p-27, 0x1.bc9a8ef60406ep-29, -0x1.8c9de104c8ae3p-30,
     0x1.7aa3b5c81d5dap-31, -0x1.7cf02c8545b88p-32, 0x1.8d14587e4e29ep-33},
     /* [339] 1.375 <= y <= 1.5 2^-11, degree 10, 59.3 bits */
    {0x1.55a41b2cfb1b2p-13, -0x1.bb9090eae3671p-68, 0x1.bc5db518f6e61p-14, 0x1.becae2bd84bbdp-21,
     -0x1.55ecda67cc9f1p-24, 0x1.436916a4f5443p-26, -0x1.9b33e156fb5bcp-28, 0x1.31cf83fc55101p-29,
     -0x1.f5e916d04e411p-31, 0x1.b8cbba34df517p-32, -0x1.97cc8c65f5294p-33, 0x1.870b7c5c93836p-34},
     /* [340] 1.5 <= y <= 1.625 2^-11, degree 10, 59.7 bits */
    {0x1.7170dce6d8511p-13, -0x1.b726b453cbbd4p-67, 0x1.bd393f49f693dp-14, 0x1.afa752ce64ca5p-21,
     -0x1.312c0acfa0a39p-24, 0x1.0b275e1252ddcp-26, -0x1.3a7216350f071p-28, 0x1.b100b4b788098p-30,
     -0x1.48fb18f350478p-31, 0x1.0b80a8d3bdc1p-32, -0x1.ca1dba14b8afcp-34, 0x1.96ba9711c3f4cp-35},
     /* [341] 1.625 <= y <= 1.75 2^-11, degree 10, 62.5 bits */
    {0x1.8d4b1ce6dfdb7p-13, -0x1.577f5cde2d3bfp-69, 0x1.be0d9f5e56705p-14, 0x1.a21615b368a5ep-21,
     -0x1.129ac71b3a18ap-24, 0x1.bf742296de1b9p-27, -0x1.ea3d795d13581p-29, 0x1.3a3875466b4e7p-30,
     -0x1.bc801051b7f0ep-32, 0x1.507c4b27a13c8p-33, -0x1.0c2bd591fae3p-34, 0x1.bb50acd615eccp-36},
     /* [342] 1.75 <= y <= 1.875 2^-11, degree 10, 61.0 bits */
    {0x1.a9326e779dcabp-13, -0x1.4cf1765b2ec13p-68, 0x1.bedb8d6bb8b37p-14, 0x1.95d5976ef0e74p-21,
     -0x1.f1b581a255f24p-25, 0x1.7b3134495cd51p-27, -0x1.84926449f2707p-29, 0x1.d1eb4fd9f8b11p-31,
     -0x1.3442a56a8ecf6p-32, 0x1.b4911db1b50ep-34, -0x1.4566713f2ce1bp-35, 0x1.f73084f6e1dc3p-37},
     /* [343] 1.875 <= y <= 2 2^-11, degree 10, 60.9 bits */
    {0x1.d3251587fa927p-13, 0x1.2ec0931ff557bp-68, 0x1.c005a954f8915p-13, 0x1.857e86f5c6552p-19, -0x1.b248674241adfp-22,
     0x1.2d84357257c13p-23, -0x1.19a23bff985bbp-24, 0x1.33d8398cf6121p-25, -0x1.735c57703dc94p-26,
     0x1.df7b4f6ede23dp-27, -0x1.46f9a6ec65e7dp-27, 0x1.cd132443c2852p-28},
     /* [344] 1 <= y <= 1.125 2^-10, degree 10, 57.9 bits */
    {0x1.059edd3e8874ap-12, 0x1.77a1e5215e784p-66, 0x1.c18186bf900efp-13, 0x1.72bf7b787540bp-19, -0x1.7093d718d8558p-22,
     0x1.c9a0f95040146p-24, -0x1.7e530252a9f24p-25, 0x1.75d5d949a4e33p-26, -0x1.936fda1097bdfp-27,
     0x1.d2034d2eae45fp-28, -0x1.1c07427c52be2p-28, 0x1.664f17e524341p-29},
     /* [345] 1.125 <= y <= 1.25 2^-10, degree 10, 58.5 bits */
    {0x1.21c25f46fc6f6p-12, -0x1.9ad6f813f1145p-68, 0x1.c2ec0e369c0e2p-13, 0x1.62b46830d3432p-19,
     -0x1.3e066965abc62p-22, 0x1.650c1709f5e39p-24, -0x1.0dcc44489ef34p-25, 0x1.dd45134158313p-27,
     -0x1.d1f172d7b65f7p-28, 0x1.e6e779d377ed8p-29, -0x1.0c47b3b364526p-29, 0x1.322d190d9dc5p-30},
     /* [346] 1.25 <= y <= 1.375 2^-10, degree 10, 58.5 bits */
    {0x1.3dfc0f61ead3cp-12, -0x1.6157416ad0711p-71, 0x1.c447a2c9ec159p-13, 0x1.54c46ca2f4b44p-19,
     -0x1.1623290c9cd58p-22, 0x1.1cf55f81bcf8cp-24, -0x1.8915749a3755p-26, 0x1.3d6339d03deb8p-27,
     -0x1.1adfc38507f86p-28, 0x1.0dde472d97138p-29, -0x1.0f5c3cc13ebfdp-30, 0x1.1abc24e4d3aa7p-31},
     /* [347] 1.375 <= y <= 1.5 2^-10, degree 10, 59.1 bits */
    {0x1.5a4b0dfecc98ap-12, 0x1.bdcf090a168ccp-67, 0x1.c59626021e8e8p-13, 0x1.488237f52c542p-19, -0x1.ec01ae23311f1p-23,
     0x1.cf8459fc4c1cep-25, -0x1.2609d5152ada9p-26, 0x1.b4c437ed3855bp-28, -0x1.6615c1d92a5cap-29, 0x1.3a4304a32423p-30,
     -0x1.229344ec77129p-31, 0x1.1682e9089039ep-32}, /* [348] 1.5 <= y <= 1.625 2^-10, degree 10, 60.0 bits */
    {0x1.76ae968f8d0a1p-12, 0x1.b1eadab53018cp-68, 0x1.c6d91b6d209fdp-13, 0x1.3d9d422bdd0aap-19, -0x1.b75216e8480fdp-23,
     0x1.7f0c489fe82a3p-25, -0x1.c1dd4ccceb48bp-27, 0x1.35506fea6efbap-28, -0x1.d58f731224837p-30, 0x1.7d88e6adfafp-31,
     -0x1.4683ce727d2ecp-32, 0x1.21c1291eb76fp-33}, /* [349] 1.625 <= y <= 1.75 2^-10, degree 10, 58.6 bits */
    {0x1.9325fa741789dp-12, 0x1.9c2d71522b52p-67, 0x1.c811c083b7641p-13, 0x1.33d8b8e3df205p-19, -0x1.8b7bf9bbddae8p-23,
     0x1.40e88f1849e37p-25, -0x1.5ecdfc284b51bp-27, 0x1.c110be373e3d8p-29, -0x1.3d501ea774d54p-30,
     0x1.e00d8af8eb3fep-32, -0x1.7e5db83ffa8ap-33, 0x1.3be4f6f6d701ep-34},
     /* [350] 1.75 <= y <= 1.875 2^-10, degree 10, 59.2 bits */
    {0x1.afb09d258956fp-12, 0x1.f5efcf20c8788p-66, 0x1.c9411d4343cf8p-13, 0x1.2b05b159f139fp-19, -0x1.668acab7980aep-23,
     0x1.100de52ec7ap-25, -0x1.162523902653bp-27, 0x1.4d081afce537dp-29, -0x1.b83bc93090a4cp-31, 0x1.377f779dcbc8ep-32,
     -0x1.d013c14c2e8bep-34, 0x1.66a44624583dap-35}, /* [351] 1.875 <= y <= 2 2^-10, degree 10, 59.7 bits */
    {0x1.daa3753a6a657p-12, -0x1.547a6b386d2eap-67, 0x1.caf89df8bff16p-12, 0x1.1f3f71e76a50fp-17,
     -0x1.39065839df316p-20, 0x1.b0e17b2de3954p-22, -0x1.93625836dd2b2p-23, 0x1.b845be1f3af98p-24,
     -0x1.09474c1ccc8edp-24, 0x1.563e71fd0acfp-25, -0x1.d27bb13ea4fb2p-26, 0x1.48bb5a931b1ecp-26},
     /* [352] 1 <= y <= 1.125 2^-9, degree 10, 58.7 bits */
    {0x1.0a12ed64d36d3p-11, -0x1.2b71a295007f3p-65, 0x1.cd293a6ef3b0bp-12, 0x1.11bb3619eb6ap-17, -0x1.09d8072eb6e7ep-20,
     0x1.48b8826e72013p-22, -0x1.11f63757befb6p-23, 0x1.0b77ab74f04f2p-24, -0x1.2055546c7faf2p-25,
     0x1.4cc8661f6f806p-26, -0x1.95636244e55cep-27, 0x1.ff22eef98db1bp-28},
     /* [353] 1.125 <= y <= 1.25 2^-9, degree 10, 60.2 bits */
    {0x1.26f65cba4a08ap-11, -0x1.84360da0c26f7p-65, 0x1.cf40d51d7c233p-12, 0x1.06280340ea70fp-17,
     -0x1.cb0a8c5f7146cp-21, 0x1.00a0de2b3434bp-22, -0x1.82de3b622e917p-24, 0x1.55a40779ea38dp-25,
     -0x1.4d289fdbad586p-26, 0x1.5bd9c0febec33p-27, -0x1.7f10fbfdbc245p-28, 0x1.b4efa6f3bf6f6p-29},
     /* [354] 1.25 <= y <= 1.375 2^-9, degree 10, 61.4 bits */
    {0x1.43fa95155a3d3p-11, 0x1.1ee42936d9386p-66, 0x1.d142dc1e6e894p-12, 0x1.f8308e27b1bp-18, -0x1.91afc3e0134fdp-21,
     0x1.99dcbbbfed014p-23, -0x1.19f7ec6c7f5d2p-24, 0x1.c6990d9b329c3p-26, -0x1.94b209d55a21ap-27,
     0x1.81c0149b77567p-28, -0x1.839cc64be70bdp-29, 0x1.93a15a20db236p-30},
     /* [355] 1.375 <= y <= 1.5 2^-9, degree 10, 61.3 bits */
    {0x1.611e53aece80cp-11, 0x1.e9a417d1e36p-65, 0x1.d33203d364a8cp-12, 0x1.e67b3a953051fp-18, -0x1.637494c4447a9p-21,
     0x1.4d857b52c12b7p-23, -0x1.a60b2a6a7482cp-25, 0x1.38ee08ee00f7fp-26, -0x1.004099f07aae2p-27,
     0x1.c160bb0c7a615p-29, -0x1.9f358403a8eabp-30, 0x1.8dbcc5a66c1ecp-31},
     /* [356] 1.5 <= y <= 1.625 2^-9, degree 10, 58.7 bits */
    {0x1.7e607c9830dd9p-11, -0x1.f063325babaf5p-65, 0x1.d51079cc20ab7p-12, 0x1.d6bc7d10c7cb2p-18,
     -0x1.3d894423b013bp-21, 0x1.13c241eb78209p-23, -0x1.42ffc84a8c06ap-25, 0x1.bb698462c01edp-27,
     -0x1.5027df82af31fp-28, 0x1.10e2d778320b1p-29, -0x1.d2b951b44857p-31, 0x1.9dedc03c562a2p-32},
     /* [357] 1.625 <= y <= 1.75 2^-9, degree 10, 59.9 bits */
    {0x1.9bc01371c7083p-11, 0x1.ef84850a5e943p-65, 0x1.d6e007020f706p-12, 0x1.c89d04820172bp-18, -0x1.1df88303d3ab9p-21,
     0x1.ce44889bb974ep-24, -0x1.f7f74e35488c6p-26, 0x1.42007e7568b5cp-27, -0x1.c67df29cd47b5p-29,
     0x1.5777c6923d9e1p-30, -0x1.115e52f0f9b24p-31, 0x1.c3694ed22e6b3p-33},
     /* [358] 1.75 <= y <= 1.875 2^-9, degree 10, 58.7 bits */
    {0x1.b93c35ea8b31fp-11, -0x1.7782cc907f047p-70, 0x1.d8a227a2d1ff4p-12, 0x1.bbd96e67ed818p-18,
     -0x1.035b7bcfeb826p-21, 0x1.8811e73775996p-24, -0x1.8fbf1131a8c61p-26, 0x1.ddc78d8d83c47p-28,
     -0x1.3b630795d1fccp-29, 0x1.bde32d9c6fa31p-31, -0x1.4be3fc6ead3e2p-32, 0x1.005329bd1f30ap-33},
     /* [359] 1.875 <= y <= 2 2^-9, degree 10, 59.2 bits */
    {0x1.e5aa353479c38p-11, 0x1.f53ddb05ca5bep-65, 0x1.db2edc99f5ee7p-11, 0x1.aacf7ed9cfd16p-16, -0x1.c518e59801b79p-19,
     0x1.381ecc3f4a303p-20, -0x1.22095afd69c42p-21, 0x1.3bfbdc9f4144dp-22, -0x1.7c48ccf74c0c6p-23,
     0x1.ea20b3c482026p-24, -0x1.4dc2163f5a0c4p-24, 0x1.d617f011a059ep-25},
     /* [360] 1 <= y <= 1.125 2^-8, degree 10, 58.3 bits */
    {0x1.10a248b2213eep-10, -0x1.26d43f124e58ep-64, 0x1.de706196d87dcp-11, 0x1.973d611185395p-16,
     -0x1.8108a16d178cbp-19, 0x1.da67edc52356p-21, -0x1.8a3e2f5464038p-22, 0x1.802d531b45bbap-23,
     -0x1.9d96f8258bcdcp-24, 0x1.dcc19fcbc3682p-25, -0x1.2233bc3e7c75bp-25, 0x1.8211a96afb506p-26},
     /* [361] 1.125 <= y <= 1.25 2^-8, degree 10, 58.7 bits */
    {0x1.2ea265e5cfb7dp-10, -0x1.565407f3a62d1p-64, 0x1.e18daeca2ea07p-11, 0x1.86788d021b84fp-16,
     -0x1.4c9816e9d9953p-19, 0x1.72a11876ad092p-21, -0x1.168b2cd612e6dp-22, 0x1.eb0439568fbbp-24,
     -0x1.de2997d60a19dp-25, 0x1.f2b7e3e6f1e28p-26, -0x1.125e8911960b9p-26, 0x1.38bbef49c0ce3p-27},
     /* [362] 1.25 <= y <= 1.375 2^-8, degree 10, 60.5 bits */
    {0x1.4cd357f97cc8dp-10, -0x1.e782456cb491bp-66, 0x1.e48bb7de32563p-11, 0x1.77e34a1ea34c8p-16, -0x1.232a06afa718p-19,
     0x1.2829e6f931c9p-21, -0x1.96481ca506065p-23, 0x1.46de244c2baccp-24, -0x1.2292cd6de99bdp-25, 0x1.14ab1ef897aep-26,
     -0x1.15c28c2dca608p-27, 0x1.210798eb8423ap-28}, /* [363] 1.375 <= y <= 1.5 2^-8, degree 10, 58.4 bits */
    {0x1.6b334b19a532p-10, 0x1.0eca713af412ap-65, 0x1.e76e6512ccd79p-11, 0x1.6b0caec4dc997p-16, -0x1.01bf69e726beap-19,
     0x1.e24c9ee8ddb65p-22, -0x1.303b13fff5ee7p-23, 0x1.c24030e4a779bp-25, -0x1.702ab4f1cebd4p-26,
     0x1.42752de7ea138p-27, -0x1.29abdf32a9f3cp-28, 0x1.1cef3b7be17e8p-29},
     /* [364] 1.5 <= y <= 1.625 2^-8, degree 10, 58.8 bits */
    {0x1.89c0a39602f86p-10, -0x1.63194badf44f3p-66, 0x1.ea38dc690f3c8p-11, 0x1.5fa17535e3ba3p-16,
     -0x1.cca54507a329dp-20, 0x1.8f004a2555e2ep-22, -0x1.d1eb76db671e6p-24, 0x1.3f28345a42e5ap-25,
     -0x1.e332715fc49fp-27, 0x1.87cdd8e99bef3p-28, -0x1.4ebf7a6664c47p-29, 0x1.28a817c9dea2bp-30},
     /* [365] 1.625 <= y <= 1.75 2^-8, degree 10, 58.6 bits */
    {0x1.a879f36047fc3p-10, -0x1.8b5747b8c3995p-65, 0x1.ecedb2dfdadd3p-11, 0x1.5562a86cae851p-16,
     -0x1.9ef5ef2186e8dp-20, 0x1.4e9d5bfee84dap-22, -0x1.6baa47cb8e1bp-24, 0x1.cfc267aef8117p-26,
     -0x1.46cba2c08d936p-27, 0x1.ed5b06ebac21dp-29, -0x1.884be9e15935ep-30, 0x1.43a5b1d70695dp-31},
     /* [366] 1.75 <= y <= 1.875 2^-8, degree 10, 59.8 bits */
    {0x1.c75df21dbdaaap-10, 0x1.520796e89c852p-64, 0x1.ef8f0eb0a2478p-11, 0x1.4c1fabe45517fp-16, -0x1.786c283f24f3ep-20,
     0x1.1bf29c528322p-22, -0x1.2099290149435p-24, 0x1.5836cb23cc4f3p-26, -0x1.c5be248bfd0cep-28, 0x1.405db7389199bp-29,
     -0x1.dc76f7ebe654fp-31, 0x1.6fb0ed633e5f3p-32}, /* [367] 1.875 <= y <= 2 2^-8, degree 10, 60.7 bits */
    {0x1.f601768173441p-10, -0x1.ba8253ea56746p-66, 0x1.f3607634f15cep-10, 0x1.3fc1e5087333dp-14,
     -0x1.48e2429acce2ep-17, 0x1.c46b0a5976f13p-19, -0x1.a311ace470a32p-20, 0x1.c796e01bf38b6p-21,
     -0x1.11b8930be1635p-21, 0x1.605b28f4faa84p-22, -0x1.df68a129c6bbp-23, 0x1.51589d5fba528p-23},
     /* [368] 1 <= y <= 1.125 2^-7, degree 10, 58.3 bits */
    {0x1.1a5e1d1f0fdd9p-9, 0x1.8d813d380a175p-64, 0x1.f8424eb506846p-10, 0x1.318ce1ea5a67bp-14, -0x1.1788a17ad6e04p-17,
     0x1.5820ee4d2fe23p-19, -0x1.1d0dc4fdafa71p-20, 0x1.152c72c97a07bp-21, -0x1.29eaa6262a9bbp-22,
     0x1.570f8d7d066c3p-23, -0x1.a12393b0a92e7p-24, 0x1.0693faee34bbbp-24},
     /* [369] 1.125 <= y <= 1.25 2^-7, degree 10, 59.9 bits */
    {0x1.3a07ecff9c4ebp-9, -0x1.a22533ae5c152p-64, 0x1.fcef90cb0caefp-10, 0x1.2560291109d6dp-14, -0x1.e2f59e7991efcp-18,
     0x1.0d110c440d0d7p-19, -0x1.931a5444b768bp-21, 0x1.62831b613b0c6p-22, -0x1.58aaf1a365b47p-23,
     0x1.6706b235e280cp-24, -0x1.8aa00a57b52dap-25, 0x1.c16b119e5258ep-26},
     /* [370] 1.25 <= y <= 1.375 2^-7, degree 10, 58.5 bits */
    {0x1.59fb1d588513fp-9, -0x1.20a523220e307p-66, 0x1.00b7b61b1f3cbp-9, 0x1.1ac9a7727713cp-14, -0x1.a6c8a31780f87p-18,
     0x1.ae54f1f8cecf8p-20, -0x1.262fefe3db5e4p-21, 0x1.d84faa68aa18p-23, -0x1.a32b6fe0c6e46p-24, 0x1.8e9764ebd1eebp-25,
     -0x1.8fbd3958a4b34p-26, 0x1.9f97693f5ec35p-27}, /* [371] 1.375 <= y <= 1.5 2^-7, degree 10, 57.9 bits */
    {0x1.7a3506d851feap-9, -0x1.f341a59b2cc1p-66, 0x1.02e3c6dfaf605p-9, 0x1.1177a3122d76ep-14, -0x1.763670884735fp-18,
     0x1.5ea2cb859bff4p-20, -0x1.b8df0686e5172p-22, 0x1.4580254a0a84bp-23, -0x1.09b5eb00812f1p-24,
     0x1.d0d3ba58faad1p-26, -0x1.aca2116045c69p-27, 0x1.99ec5c07f83a4p-28},
     /* [372] 1.5 <= y <= 1.625 2^-7, degree 10, 58.4 bits */
    {0x1.9ab353bdfb758p-9, -0x1.0cfc4cad62cddp-63, 0x1.04fe44735278cp-9, 0x1.092dcb8ba6d0cp-14, -0x1.4e52e6611a448p-18,
     0x1.22435d8245648p-20, -0x1.51cb65c6f66a8p-22, 0x1.cdba2821072d2p-24, -0x1.5cecef6a48cf6p-25,
     0x1.1a8c656b235c6p-26, -0x1.e246297e275e2p-28, 0x1.ab00eadc2cc5dp-29},
     /* [373] 1.625 <= y <= 1.75 2^-7, degree 10, 58.0 bits */
    {0x1.bb73f0a16421ap-9, 0x1.d8817688856cdp-68, 0x1.07090f86668a4p-9, 0x1.01be7ff2ecb15p-14, -0x1.2d14562e4d355p-18,
     0x1.e723b9ea8c413p-21, -0x1.07cf0c990fc68p-22, 0x1.4fa57e27216b3p-24, -0x1.d8385b06800f1p-26,
     0x1.63f6c514ea3a6p-27, -0x1.1abb724ee9c05p-28, 0x1.d213a8778c8ddp-30},
     /* [374] 1.75 <= y <= 1.875 2^-7, degree 10, 57.7 bits */
    {0x1.dc7500f46154bp-9, 0x1.1495e5121480bp-63, 0x1.0905b87b28512p-9, 0x1.f60cff63bbd4cp-15, -0x1.1104eed51ea99p-18,
     0x1.9d9c76054af21p-21, -0x1.a2ee5ba3d919p-23, 0x1.f282337de4c7cp-25, -0x1.47fe687fd682fp-26, 0x1.ce85ba0d80ccp-28,
     -0x1.578ddfd9d3418p-29, 0x1.08df41c4303b6p-30}, /* [375] 1.875 <= y <= 2 2^-7, degree 10, 59.9 bits */
    {0x1.0735e769786cfp-8, -0x1.e526a729a5aecp-62, 0x1.0be90b002dbacp-8, 0x1.e41e25b1cbf99p-13, -0x1.dcc3ca82c3546p-16,
     0x1.49c47a6f0a8a7p-17, -0x1.30633d7029c1ep-18, 0x1.4a24a7620937dp-19, -0x1.8c00f6f4f1022p-20,
     0x1.fd0dd58fbe64ep-21, -0x1.59e7395dc1517p-21, 0x1.e65594fa0a99fp-22},
     /* [376] 1 <= y <= 1.125 2^-6, degree 10, 58.3 bits */
    {0x1.28eea7ebdb219p-8, -0x1.e1ea3f24f9a3ep-62, 0x1.0f9c21e25588ap-8, 0x1.cf88701119b29p-13, -0x1.94c9d5adf1172p-16,
     0x1.f6282a14fb608p-18, -0x1.9e7777447d499p-19, 0x1.92102d23fd4cap-20, -0x1.af6125d972a61p-21,
     0x1.f00a53528d8ddp-22, -0x1.2d385904c35bbp-22, 0x1.7aab2d476a385p-23},
     /* [377] 1.125 <= y <= 1.25 2^-6, degree 10, 57.8 bits */
    {0x1.4b1b5a482386cp-8, -0x1.a63531e3301f8p-62, 0x1.132925479bfd7p-8, 0x1.bde9e81df88f5p-13, -0x1.5d3c4d3dd527bp-16,
     0x1.88f974491b6bbp-18, -0x1.254b362f29a74p-19, 0x1.0154d10f30093p-20, -0x1.f37787cea7c58p-22,
     0x1.03c2d3d01958dp-22, -0x1.1d2cda17dfbebp-23, 0x1.4471bf164cf84p-24},
     /* [378] 1.25 <= y <= 1.375 2^-6, degree 10, 58.0 bits */
    {0x1.6db7936e51db2p-8, 0x1.b52ceda675465p-65, 0x1.169554004ba16p-8, 0x1.ae9ca27ffd8dp-13, -0x1.314637d9ec031p-16,
     0x1.3a82d7190565p-18, -0x1.ac6a122ddd99cp-20, 0x1.57176630804f1p-21, -0x1.2fef394f15bdep-22, 0x1.20974f586eb63p-23,
     -0x1.211211e309eb8p-24, 0x1.2c3a03a077ad7p-25}, /* [379] 1.375 <= y <= 1.5 2^-6, degree 10, 58.0 bits */
    {0x1.90bf7d9697cc6p-8, -0x1.4dbdd8e6cd8a7p-63, 0x1.19e4d356e6a91p-8, 0x1.a129a869393dcp-13, -0x1.0dc32b6272d29p-16,
     0x1.00767a9472b85p-18, -0x1.413b5b67f0ca2p-20, 0x1.d93712920000cp-22, -0x1.8195a6ba9ade2p-23,
     0x1.50c4b4ec9c4bfp-24, -0x1.362a1c0428c73p-25, 0x1.285171358adaep-26},
     /* [380] 1.5 <= y <= 1.625 2^-6, degree 10, 57.8 bits */
    {0x1.b42fba3060f29p-8, -0x1.590098f776a5ep-63, 0x1.1d1afbca88ddcp-8, 0x1.95391dfe91a67p-13, -0x1.e1271e49101fcp-17,
     0x1.a8eb80c3b6c9bp-19, -0x1.ec90a2164372fp-21, 0x1.4fd7c85931f81p-22, -0x1.faa8247a7493fp-24,
     0x1.99aa2abd3edc5p-25, -0x1.5d308372dc354p-26, 0x1.34d8b77fd2034p-27},
     /* [381] 1.625 <= y <= 1.75 2^-6, degree 10, 58.1 bits */
    {0x1.d8054bb7f90aap-8, 0x1.79f6e71f0341p-62, 0x1.203a8cc2f907fp-8, 0x1.8a888076f1395p-13, -0x1.b07826fc4dc67p-17,
     0x1.64d032cdbce7cp-19, -0x1.80e7e2fbf8a85p-21, 0x1.e88f624cabe7fp-23, -0x1.570af450f1c48p-24,
     0x1.0233dd8465d44p-25, -0x1.99a775ce3437p-27, 0x1.514b53460d84bp-28},
     /* [382] 1.75 <= y <= 1.875 2^-6, degree 10, 58.9 bits */
    {0x1.fc3d84f4d93c8p-8, 0x1.6aff797bb61f9p-63, 0x1.2345d09059adcp-8, 0x1.80e464fb7c5afp-13, -0x1.8759819c2642cp-17,
     0x1.2f28aad79b8ep-19, -0x1.31c8b3d13830ap-21, 0x1.6b024b3190c5bp-23, -0x1.dcccd613d933ep-25, 0x1.4fad43d4ce405p-26,
     -0x1.f20b4d742e714p-28, 0x1.7f91d3c8466c9p-29}, /* [383] 1.875 <= y <= 2 2^-6, degree 10, 59.6 bits */
    {0x1.19a2cec661387p-7, 0x1.5097abe059c3dp-61, 0x1.27b4cc245d26bp-7, 0x1.740f6e39d2157p-11, -0x1.548d238e8958ep-14,
     0x1.e3e035c1c21e5p-16, -0x1.bcb0616d6d6ap-17, 0x1.e12e4deef991bp-18, -0x1.200d23ab6259cp-18, 0x1.71b9a3c4b73p-19,
     -0x1.f5d167a7fbcb2p-20, 0x1.60649a5e4a70dp-20}, /* [384] 1 <= y <= 1.125 2^-5, degree 10, 59.2 bits */
    {0x1.3ef525e7fff5fp-7, -0x1.766f8adb0ce62p-62, 0x1.2d66e05c669e3p-7, 0x1.65642bc1268e1p-11, -0x1.1fb6b73280f8cp-14,
     0x1.70ddfa390c5c3p-16, -0x1.2f06c3c11d463p-17, 0x1.25457c4ff9ccp-18, -0x1.3a125d8e8a3bap-19, 0x1.6899fa721bcf1p-20,
     -0x1.b5637be6c7ffcp-21, 0x1.12c09b93d07a7p-21}, /* [385] 1.125 <= y <= 1.25 2^-5, degree 10, 59.5 bits */
    {0x1.64fa463fc9ee1p-7, 0x1.cb1f4fe7a2aeap-61, 0x1.32e2d2b3d8723p-7, 0x1.58e68bf8e542ap-11, -0x1.edc41f9a2aeb9p-15,
     0x1.2102a7e9f9ba6p-16, -0x1.ad36865d6357ep-18, 0x1.77b6c8163ad65p-19, -0x1.6bf1f3dbc8b84p-20, 0x1.79fc045b154bp-21,
     -0x1.9e6e7306b624ep-22, 0x1.d6fb01d3d536bp-23}, /* [386] 1.25 <= y <= 1.375 2^-5, degree 10, 57.6 bits */
    {0x1.8babebf9846c6p-7, 0x1.528ab29644056p-61, 0x1.383058f8085e4p-7, 0x1.4e1d35d892f8p-11, -0x1.ad113d1e96afdp-15,
     0x1.cf27d8d21cbf2p-17, -0x1.39b3c678b823bp-18, 0x1.f54db045a1d7p-20, -0x1.bb449ecc262a8p-21, 0x1.a4408defbec92p-22,
     -0x1.a4686eba4cc2fp-23, 0x1.b42644627a42cp-24}, /* [387] 1.375 <= y <= 1.5 2^-5, degree 10, 59.5 bits */
    {0x1.b304aecf45c96p-7, -0x1.f1e3a0015a6e9p-61, 0x1.3d558d041683cp-7, 0x1.44b11677f4613p-11, -0x1.78bdf2f95788ap-15,
     0x1.7a1e4183b20a7p-17, -0x1.d6beb7830bf95p-19, 0x1.59f420840c021p-20, -0x1.195e68fc4ed2fp-21,
     0x1.eabf95edb4589p-23, -0x1.c365c578b102ep-24, 0x1.aec46d91c219ap-25},
     /* [388] 1.5 <= y <= 1.625 2^-5, degree 10, 57.9 bits */
    {0x1.daffd606a0d6p-7, -0x1.8fa2600bb84eap-61, 0x1.42575cce770b2p-7, 0x1.3c61d3cd1ea14p-11, -0x1.4dafc39602cd7p-15,
     0x1.399dc237530ep-17, -0x1.692011ad106b5p-19, 0x1.eb5c4d2ae9676p-21, -0x1.71f3efc026823p-22, 0x1.2aada1d9f7b1bp-23,
     -0x1.fc8483e42b815p-25, 0x1.c1442f86b0f9ap-26}, /* [389] 1.625 <= y <= 1.75 2^-5, degree 10, 58.9 bits */
    {0x1.01cc9bfc54c9bp-6, -0x1.e26e41885e9cfp-63, 0x1.4739d5f91a309p-7, 0x1.34feaecdcb568p-11, -0x1.29bbee947df3bp-15,
     0x1.07aba9999dceap-17, -0x1.1a58caa70f4d3p-19, 0x1.659b91af91e6cp-21, -0x1.f543a62abfdf2p-23,
     0x1.78b95003b7cfcp-24, -0x1.2a7682b32266p-25, 0x1.eaf072e6f733dp-27},
     /* [390] 1.75 <= y <= 1.875 2^-5, degree 10, 59.7 bits */
    {0x1.166690c1219ap-6, 0x1.a520c307452e4p-60, 0x1.4c005a7707d14p-7, 0x1.2e61f2d415adep-11, -0x1.0b5472da08218p-15,
     0x1.c09b260a17af3p-18, -0x1.c0d5b6bf052ap-20, 0x1.09dab061915e2p-21, -0x1.5c8c5f34dc1aap-23, 0x1.ea080815bd4b4p-25,
     -0x1.6b101ebb068c3p-26, 0x1.174d5098b4167p-27}, /* [391] 1.875 <= y <= 2 2^-5, degree 10, 63.1 bits */
    {0x1.35dacbb3769bfp-6, -0x1.dcb68f3a2a4cbp-61, 0x1.52fbd9f384254p-6, 0x1.25ab93b139d4fp-9, -0x1.cb6b62a16868ep-13,
     0x1.66b760ee87bf9p-14, -0x1.4693372aedb11p-15, 0x1.60aa689f213d7p-16, -0x1.a575770bb978cp-17,
     0x1.0e1300981a00dp-17, -0x1.6e17a029b21b7p-18, 0x1.00cbc133eed55p-18},
     /* [392] 1 <= y <= 1.125 2^-4, degree 10, 59.0 bits */
    {0x1.60cb6689c448ap-6, 0x1.2ad31bdad8377p-61, 0x1.5c00c2b5134a2p-6, 0x1.1bdcec2dcc34fp-9, -0x1.7cf9869b7dbb6p-13,
     0x1.1239901e1e2c4p-14, -0x1.bd685f74fe619p-16, 0x1.ae478d2cbcb92p-17, -0x1.cbf28a160adbep-18,
     0x1.0793d5640b97dp-18, -0x1.3f4ace672b666p-19, 0x1.aea1a6a8f4777p-20},
     /* [393] 1.125 <= y <= 1.25 2^-4, degree 10, 61.0 bits */
    {0x1.8cd800ae7764cp-6, 0x1.b6280e744fbb9p-61, 0x1.64bdf6afc4e07p-6, 0x1.13acc90fecfc7p-9, -0x1.402d73ede2321p-13,
     0x1.af0971752156ep-15, -0x1.3ba153f98d138p-16, 0x1.13d87d646d7a5p-17, -0x1.0ab55ed3bf886p-18,
     0x1.1496265b4ae3bp-19, -0x1.2edef8ab159a1p-20, 0x1.57d115fb73ab4p-21},
     /* [394] 1.25 <= y <= 1.375 2^-4, degree 10, 60.5 bits */
    {0x1.b9f8629e206bfp-6, 0x1.fe657fe039bp-60, 0x1.6d3ef098d7927p-6, 0x1.0cc1f60cb619ep-9, -0x1.0fda896f27335p-13,
     0x1.5a8c9d20b5824p-15, -0x1.cd95fcca0cb4fp-17, 0x1.7054b1f873944p-18, -0x1.45139b4d2ecbcp-19,
     0x1.33be3860ff04ep-20, -0x1.3378016a2ddbfp-21, 0x1.3ea19dcd07172p-22},
     /* [395] 1.375 <= y <= 1.5 2^-4, degree 10, 58.2 bits */
    {0x1.e8259c382c48dp-6, -0x1.ca41313e4c277p-62, 0x1.758ccd54b429fp-6, 0x1.06dc67eccf709p-9, -0x1.d143f0ef72b25p-14,
     0x1.1bf9ecc3047a5p-15, -0x1.5a71439b5468cp-17, 0x1.fcbbfa1415d69p-19, -0x1.9cf7a9f09b812p-20,
     0x1.679bc0c8f9983p-21, -0x1.4a5bbbc57cb62p-22, 0x1.3aea750e496d1p-23},
     /* [396] 1.5 <= y <= 1.625 2^-4, degree 10, 59.5 bits */
    {0x1.0bace200de2a4p-5, 0x1.5645ed41669eep-59, 0x1.7daef08a74318p-6, 0x1.01ccc4f2fcfd9p-9, -0x1.9077ad0d269d4p-14,
     0x1.d900d5277ad41p-16, -0x1.09d14c84098f4p-17, 0x1.6984faba4c2d5p-19, -0x1.0fa8a83e47493p-20,
     0x1.b5ffcb7b46526p-22, -0x1.7465128fca3b3p-23, 0x1.48a5ad4e1ddafp-24},
     /* [397] 1.625 <= y <= 1.75 2^-4, degree 10, 58.5 bits */
    {0x1.23c7e3aef7c48p-5, -0x1.4178288412606p-61, 0x1.85ab73b4b8ab1p-6, 0x1.fade58ffed271p-10, -0x1.5a2046de3a39fp-14,
     0x1.8f79050b7d93fp-16, -0x1.9fad6789b520ep-18, 0x1.0746fbf53b103p-19, -0x1.704ab82fe6e0bp-21,
     0x1.14620dea876cbp-22, -0x1.b563c9008476cp-24, 0x1.6757560aaed9ap-25},
     /* [398] 1.75 <= y <= 1.875 2^-4, degree 10, 60.9 bits */
    {0x1.3c61a33345114p-5, -0x1.1e1af7af9c339p-60, 0x1.8d8773917884cp-6, 0x1.f34fbaa30848fp-10, -0x1.2bf3ec44e3583p-14,
     0x1.5584712d29876p-16, -0x1.4a5ae22a5584bp-18, 0x1.87b1723262a3ep-20, -0x1.00395686aca2bp-21,
     0x1.67b3cf75f4e1ep-23, -0x1.0a2c1b0e96943p-24, 0x1.9916e1ab4c38dp-26},
     /* [399] 1.875 <= y <= 2 2^-4, degree 10, 60.0 bits */
    {0x1.6231d44ce0233p-5, 0x1.773a8634901d3p-61, 0x1.991dd0e557f4fp-5, 0x1.e9d03467571dp-8, -0x1.e4e5aadcdb1ccp-12,
     0x1.135e73ffb3d5dp-12, -0x1.e081353e4eab9p-14, 0x1.0407c46762862p-14, -0x1.360cf7aa85d7bp-15,
     0x1.8cc840e3b079ep-16, -0x1.0c96d62bfb253p-16, 0x1.7867028fe041ep-17},
     /* [400] 1 <= y <= 1.125 2^-3, degree 10, 64.5 bits */
    {0x1.9648b247a3dacp-5, -0x1.2a182630b1b5cp-59, 0x1.a842e5020a91p-5, 0x1.dfedc92728a9p-8, -0x1.6bbc8f7b21541p-12,
     0x1.aa7d43defb604p-13, -0x1.473f4b0339d23p-14, 0x1.3da211f48115p-15, -0x1.52aa9b7234868p-16, 0x1.83b0616cf7ecdp-17,
     -0x1.d50e7a9e96b89p-18, 0x1.26017fe09e77bp-18}, /* [401] 1.125 <= y <= 1.25 2^-3, degree 10, 58.3 bits */
    {0x1.cc3fb3831c38ep-5, -0x1.f47d339ff2648p-59, 0x1.b7235eeadafd3p-5, 0x1.d88fcba05f14dp-8, -0x1.0c82372dbfbdep-12,
     0x1.544e72a79193ap-13, -0x1.cec8720f0f4e5p-15, 0x1.97c1eb7a59b04p-16, -0x1.8914381db08a5p-17,
     0x1.97099d52301acp-18, -0x1.bd286b21c2663p-19, 0x1.f8ce2d9e14995p-20},
     /* [402] 1.25 <= y <= 1.375 2^-3, degree 10, 58.4 bits */
    {0x1.0207b796cc7dp-4, -0x1.ea7efc38a0fdep-58, 0x1.c5d137c386eefp-5, 0x1.d33345ecf207cp-8, -0x1.7f24087569bd3p-13,
     0x1.1674ed0a9bb06p-13, -0x1.514ce3751beb4p-15, 0x1.109788da0a99p-16, -0x1.df736400f539fp-18, 0x1.c5396eb12cdadp-19,
     -0x1.c43db7d2a20fp-20, 0x1.d4294e5be64bdp-21}, /* [403] 1.375 <= y <= 1.5 2^-3, degree 10, 60.1 bits */
    {0x1.1ed9407edbffbp-4, 0x1.d804e5ef3e852p-59, 0x1.d45af052b3eb9p-5, 0x1.cf7a71d78448ep-8, -0x1.ffbf8ccc04e2dp-14,
     0x1.d1a601c87899ap-14, -0x1.f80ebc0597bcep-16, 0x1.790c736d4e242p-17, -0x1.30bd32d8092ap-18, 0x1.08fcce0162e67p-19,
     -0x1.e63b022dc95f2p-21, 0x1.cf01842f746f4p-22}, /* [404] 1.5 <= y <= 1.625 2^-3, degree 10, 58.2 bits */
    {0x1.3c929532efac3p-4, 0x1.fe4f031d867c8p-58, 0x1.e2cc8464a9af8p-5, 0x1.cd203d9160f33p-8, -0x1.28ec237673cd3p-14,
     0x1.8cc318979ea52p-14, -0x1.8074c1d13d6c9p-16, 0x1.0c629561ac339p-17, -0x1.9129149223f3ep-19,
     0x1.42f6b83c2138cp-20, -0x1.12383537e3513p-21, 0x1.e37cbfe61fd1bp-23},
     /* [405] 1.625 <= y <= 1.75 2^-3, degree 10, 58.2 bits */
    {0x1.5b32867018e02p-4, -0x1.7b04ec501f72bp-58, 0x1.f1300f45d32fbp-5, 0x1.cbf0985608405p-8, -0x1.c164310ab6544p-16,
     0x1.57c681a032b9p-14, -0x1.2a4b6c953628cp-16, 0x1.87a90d4ae517cp-18, -0x1.1010c0d235022p-19, 0x1.97d85d795e023p-21,
     -0x1.42443340fa55ap-22, 0x1.087879bf7993p-23}, /* [406] 1.75 <= y <= 1.875 2^-3, degree 10, 60.9 bits */
    {0x1.7ab87abab2102p-4, -0x1.91f5a0a08198bp-58, 0x1.ff8e3e9d98cfap-5, 0x1.cbc380464f0acp-8, 0x1.8635f8c33151cp-17,
     0x1.2e5f765ad0e57p-14, -0x1.d586e0458aff5p-17, 0x1.2403ef7d51c1dp-18, -0x1.7ab5e0b1a68fbp-20,
     0x1.098f716c10b88p-21, -0x1.88719b2fe2ed9p-23, 0x1.2d3e9e717f827p-24},
     /* [407] 1.875 <= y <= 2 2^-3, degree 10, 58.6 bits */
    {0x1.abb09a3dee9ecp-4, 0x1.7e905a8ee2665p-58, 0x1.0a90e61cf9af7p-3, 0x1.cd2225bc6d40cp-6, 0x1.0118d9a1c9595p-11,
     0x1.ff89c6125c36fp-11, -0x1.4eec6f18a7615p-12, 0x1.85633bece7d67p-13, -0x1.ca72b9e71806ep-14, 0x1.2533458decep-14,
     -0x1.8c4fb945fab3bp-15, 0x1.156128e845887p-15}, /* [408] 1 <= y <= 1.125 2^-2, degree 10, 58.4 bits */
    {0x1.f02334847e206p-4, -0x1.a06df3eda5f12p-58, 0x1.1909d367eb4e4p-3, 0x1.d18d8344bd877p-6, 0x1.ea119d3f08c64p-11,
     0x1.aa5104fc35799p-11, -0x1.b79087128251fp-13, 0x1.df72537c9c969p-14, -0x1.f4beeb098fe6fp-15,
     0x1.1effd89b922f3p-15, -0x1.5a227782798b6p-16, 0x1.6c3bba90498b9p-17},
     /* [409] 1.125 <= y <= 1.25 2^-2, degree 10, 57.3 bits */
    {0x1.1c1caa5107654p-3, 0x1.bb91875f82af2p-57, 0x1.27b06d3cb851cp-3, 0x1.d87be536043ffp-6, 0x1.58142fbff3faep-10,
     0x1.71cfa443fef4fp-11, -0x1.2626dbbaa9719p-13, 0x1.374f5e86b7d13p-14, -0x1.2251e27656eefp-15,
     0x1.2d89f1f0d514dp-16, -0x1.4908ad253d3f8p-17, 0x1.74ab10571c60dp-18},
     /* [410] 1.25 <= y <= 1.375 2^-2, degree 10, 59.2 bits */
    {0x1.42006492822dp-3, 0x1.c2ff96bb34912p-58, 0x1.36975ca48833ep-3, 0x1.e1974a7a1fedap-6, 0x1.af79ee5918678p-10,
     0x1.4bdf92844d276p-11, -0x1.8b4f732f69dd5p-14, 0x1.a725afef29ff4p-15, -0x1.614737f99a46bp-16,
     0x1.5041d3b467bacp-17, -0x1.4e8bc1c6b9fbap-18, 0x1.59e6cc87a7369p-19},
     /* [411] 1.375 <= y <= 1.5 2^-2, degree 10, 57.6 bits */
    {0x1.69c5dfa7ad1fap-3, -0x1.4012da30c0c4p-57, 0x1.45cf13e000d0dp-3, 0x1.eca60e1d9b293p-6, 0x1.ff0ec21bf56d8p-10,
     0x1.3283a374ae3a7p-11, -0x1.059496bc36826p-14, 0x1.2b7c7e4348e64p-15, -0x1.bf1ab40b05cfdp-17,
     0x1.89ebba4132a83p-18, -0x1.67f4e3aad4513p-19, 0x1.565ddee0a7286p-20},
     /* [412] 1.5 <= y <= 1.625 2^-2, degree 10, 58.0 bits */
    {0x1.93782724cc2cfp-3, -0x1.6de47a3edfdbp-59, 0x1.55668957b60f6p-3, 0x1.f981b1558d393p-6, 0x1.24bc248adb671p-9,
     0x1.22090e67ac8d8p-11, -0x1.4a742b445e2a9p-15, 0x1.b80c2ec3367fcp-16, -0x1.241aefdb2cba1p-17,
     0x1.e13fc048ea69dp-19, -0x1.964342a314b3ep-20, 0x1.65cb326145b5ap-21},
     /* [413] 1.625 <= y <= 1.75 2^-2, degree 10, 58.0 bits */
    {0x1.bf24149b468a8p-3, -0x1.f0c885bc46131p-57, 0x1.656bb8648de62p-3, 0x1.0408989e2c79fp-5, 0x1.484ed07d92eacp-9,
     0x1.18113edf78decp-11, -0x1.74eaf0484cf3bp-16, 0x1.4eeb932d3f9a3p-16, -0x1.87934a8617ba4p-18,
     0x1.30d8d0bba8a73p-19, -0x1.dda8c2cfffb02p-21, 0x1.87bd54cca0389p-22},
     /* [414] 1.75 <= y <= 1.875 2^-2, degree 10, 59.5 bits */
    {0x1.ecd8364a632e7p-3, -0x1.1d6289f531ee9p-57, 0x1.75ebfdac40b2p-3, 0x1.0c22b442e4e94p-5, 0x1.6af50c1d4ca35p-9,
     0x1.130be2583835dp-11, -0x1.2c3189968c3b7p-17, 0x1.07c51e368a8b2p-16, -0x1.0bb02339da68fp-18,
     0x1.8ec6ddab7574fp-20, -0x1.22e461d5eddadp-21, 0x1.be911aa1b3e61p-23}
     /* [415] 1.875 <= y <= 2 2^-2, degree 10, 58.2 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_below_eps_zero_overlap)

/* beta/(1 - eps) at zero overlap, 1 - eps < 1/2: 9 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-59.4 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_OVERLAP_ROWS 9
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_hertz_dashpot_near_beta_zero_overlap, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.1e621cp-1, -0x1.f76211026490ep-28, 0x1.ca3692ce85fcap-3, 0x1.c928387797155p-4, 0x1.fe3de4e9a7368p-5,
     0x1.35ec3db60f7c2p-5, 0x1.948823ad2acp-6, 0x1.18d218509fd0cp-6, 0x1.9aa9df0c96501p-7, 0x1.3962e8da0ab26p-7,
     0x1.eada2b4793fefp-8, 0x1.c95fd0ba0ea7bp-8}, /* [0] 0 <= y <= 0.03125, degree 10, 60.3 bits */
    {0x1.25c62d8p-1, 0x1.be00a4c94dc37p-32, 0x1.e85c2e4281e97p-3, 0x1.fce364f2dbe4bp-4, 0x1.2a2f28d7f78f4p-4,
     0x1.7e53bed6cadep-5, 0x1.088b7256ff5e8p-5, 0x1.86afc5df6afbp-6, 0x1.30781996ac38cp-6, 0x1.efa1c9ff50d7p-7,
     0x1.a24bafb715724p-7, 0x1.6a0b4cf731a83p-7}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 63.4 bits */
    {0x1.2da9a8p-1, 0x1.09ada38e3328fp-32, 0x1.0501775226aa2p-2, 0x1.1cd003d56b6p-3, 0x1.5fa9c45d4923ap-4,
     0x1.dde3e5000a6c4p-5, 0x1.60349106a4beep-5, 0x1.15f7d64901e4fp-5, 0x1.cff45c2f50d4p-6, 0x1.94b49fdd70b95p-6,
     0x1.6e320ec59ebb4p-6, 0x1.53a950c0f72a6p-6}, /* [2] 0.09375 <= y <= 0.15625, degree 10, 60.0 bits */
    {0x1.361bc68p-1, -0x1.e1599b2a27b16p-29, 0x1.17e61002e05bep-2, 0x1.40d030c31a426p-3, 0x1.a306611f7561fp-4,
     0x1.2f3b6c08c957bp-4, 0x1.dea2e1f43334ep-5, 0x1.95f5fbdfe549dp-5, 0x1.6cc0e1927c097p-5, 0x1.56c2b8b93c6f1p-5,
     0x1.4e37c19523b29p-5, 0x1.4ddcfe795df4dp-5}, /* [3] 0.15625 <= y <= 0.21875, degree 10, 59.4 bits */
    {0x1.3f2e99p-1, -0x1.20c1ed9fd4a9ap-28, 0x1.2d418b12274fcp-2, 0x1.6bf7b9c9f9c0dp-3, 0x1.f947a75b40c66p-4,
     0x1.87ad1c7885288p-4, 0x1.4d1af2ca7f32ep-4, 0x1.318d95edfa21bp-4, 0x1.29654c2ee4599p-4, 0x1.2ed9ded2722c4p-4,
     0x1.4018d55320efbp-4, 0x1.5a583b2e93459p-4}, /* [4] 0.21875 <= y <= 0.28125, degree 10, 59.6 bits */
    {0x1.48f7c98p-1, -0x1.53f53f470356fp-29, 0x1.459636765dcffp-2, 0x1.a05f5a247151ep-3, 0x1.34f096d982d7ep-3,
     0x1.024aa0647c033p-3, 0x1.dceebcb42cd75p-4, 0x1.dca2aa5f62666p-4, 0x1.fa1edc7093c75p-4, 0x1.19315b27c5f49p-3,
     0x1.445fae3d00806p-3, 0x1.7eb46adb867f2p-3}, /* [5] 0.28125 <= y <= 0.34375, degree 10, 60.1 bits */
    {0x1.5391ab8p-1, -0x1.e26fe1049dd61p-28, 0x1.618e62ead7598p-2, 0x1.e0fea595aa02p-3, 0x1.8024b625414c7p-3,
     0x1.5d487be4d0eecp-3, 0x1.612a9d5c7c038p-3, 0x1.83e08211675eep-3, 0x1.c51ab86a69bf7p-3, 0x1.14e97e7d267bp-2,
     0x1.5f7b811e77bcep-2, 0x1.c7c9ff3d18c6ap-2}, /* [6] 0.34375 <= y <= 0.40625, degree 10, 60.5 bits */
    {0x1.5f1cbcp-1, -0x1.4a6747cf76598p-28, 0x1.820defd362f9dp-2, 0x1.1915a2c6c7742p-2, 0x1.e76de0b9b8c2ep-3,
     0x1.e6ef704d17cap-3, 0x1.107b5a7714d5bp-2, 0x1.4c4ada5032df8p-2, 0x1.af4a2e5a5c35ep-2, 0x1.24c1ff8d2a668p-1,
     0x1.9cebce3b8e8fep-1, 0x1.291c74cf31f27p+0}, /* [7] 0.40625 <= y <= 0.46875, degree 10, 62.1 bits */
    {0x1.6bc1d7p-1, -0x1.699eff90c48c7p-28, 0x1.a84e83001a76dp-2, 0x1.4d3d01e423bc8p-2, 0x1.3d1d3b4ab43e3p-2,
     0x1.6083e80eae024p-2, 0x1.ba658c1a4374fp-2, 0x1.2f4c92f191867p-1, 0x1.bab2152e04d07p-1, 0x1.51bf52ad87304p+0,
     0x1.0bee9d27f6ab6p+1, 0x1.b1039ed9d3402p+1} /* [8] 0.46875 <= y <= 0.53125, degree 10, 60.2 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_beta_zero_overlap)

/* beta at zero overlap by eps, 2^-60 <= eps < 2^-1: 472 rows of degree 10 in y = eps 2^-k, 8 to each octave k = -60 ... -2.
 * Relative error of the approximation: 2^-58.2 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_OVERLAP_FIRST 8.673617379884035e-19
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_OVERLAP_FIRST_OCTAVE (-60)
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_OVERLAP_ROWS 472
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_hertz_dashpot_beta_zero_overlap, 472, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.20c3d49855cbfp+0, -0x1.9426c947d2d9fp-54, -0x1.353276476e25p-58, 0x1.057aef97ee0cfp-88, -0x1.47e69a961d4dp-91,
     0x1.ce34624ea832ap-93, -0x1.b1e6a159b8458p-94, 0x1.daac56e98ad4p-95, -0x1.1dc6853affa1cp-95, 0x1.6f843d9e4ba3fp-96,
     -0x1.f2479fe31e3f3p-97, 0x1.5ca4e6b71efdcp-97}, /* [0] 1 <= y <= 1.125 2^-60, degree 10, 107.4 bits */
    {0x1.20c3d49855cbfp+0, -0x1.96912e3460b5bp-54, -0x1.353276466fedcp-58, 0x1.eeb00dda15e88p-89,
     -0x1.1593803e3473ap-91, 0x1.5e388240e738bp-93, -0x1.265ae774a3e4fp-94, 0x1.206121b145325p-95,
     -0x1.370ddf7c10e64p-96, 0x1.6672acef93ecep-97, -0x1.b32f2265a4589p-98, 0x1.110144a5e226dp-98},
     /* [1] 1.125 <= y <= 1.25 2^-60, degree 10, 109.5 bits */
    {0x1.20c3d49855cbfp+0, -0x1.98fb9320eca26p-54, -0x1.353276457ec5p-58, 0x1.d68d6cae1e122p-89, -0x1.ddd613d08d38ap-92,
     0x1.10cf956a165eap-93, -0x1.9f1899a132ef1p-95, 0x1.702bec238b668p-96, -0x1.67994dc107c64p-97,
     0x1.77505a850362cp-98, -0x1.9c7d819deedf2p-99, 0x1.d4ecd5862a313p-100},
     /* [2] 1.25 <= y <= 1.375 2^-60, degree 10, 109.8 bits */
    {0x1.20c3d49855cbfp+0, -0x1.9b65f80d76b84p-54, -0x1.3532764498d76p-58, 0x1.c1a2a93f02c2cp-89,
     -0x1.a0edcf7154a59p-92, 0x1.b2c2bfaaaed36p-94, -0x1.2e172720b4383p-95, 0x1.e98185e05312fp-97,
     -0x1.b4cbfb0472265p-98, 0x1.a08ed946a23a8p-99, -0x1.a22afd173f79p-100, 0x1.b27fbbb70557fp-101},
     /* [3] 1.375 <= y <= 1.5 2^-60, degree 10, 108.6 bits */
    {0x1.20c3d49855cbfp+0, -0x1.9dd05cf9ff0c4p-54, -0x1.35327643bcb55p-58, 0x1.af47a57dcce89p-89,
     -0x1.6ff093914eac8p-92, 0x1.610839c28e537p-94, -0x1.c3760ea8cdb9cp-96, 0x1.509fdd175dcp-97, -0x1.1478964df4167p-98,
     0x1.e568d23e83b02p-100, -0x1.c06c6f47c35d6p-101, 0x1.acff94848c6fap-102},
     /* [4] 1.5 <= y <= 1.625 2^-60, degree 10, 108.9 bits */
    {0x1.20c3d49855cbfp+0, -0x1.a03ac1e685b0dp-54, -0x1.35327642e9374p-58, 0x1.9f00a8952bc6cp-89,
     -0x1.47d7b1326d8a3p-92, 0x1.234a205181a6fp-94, -0x1.58f8d1551b2fbp-96, 0x1.dc75a8ef4fa62p-98,
     -0x1.6a747f85147b4p-99, 0x1.26be8f975fc33p-100, -0x1.f855271259637p-102, 0x1.bf03a94d63531p-103},
     /* [5] 1.625 <= y <= 1.75 2^-60, degree 10, 108.2 bits */
    {0x1.20c3d49855cbfp+0, -0x1.a2a526d30ab64p-54, -0x1.353276421d6bap-58, 0x1.90705b9197515p-89,
     -0x1.2688232c89c2bp-92, 0x1.e75443328a0dcp-95, -0x1.0cb475f3efcf4p-96, 0x1.5998a7ea97af3p-98,
     -0x1.e9aca55647c18p-100, 0x1.72dc052c494f3p-101, -0x1.27726ca7c27p-102, 0x1.e7d89f2a76e9dp-104},
     /* [6] 1.75 <= y <= 1.875 2^-60, degree 10, 113.4 bits */
    {0x1.20c3d49855cbfp+0, -0x1.a50f8bbf8e2b2p-54, -0x1.353276415889ep-58, 0x1.834ed3055ea39p-89,
     -0x1.0a8085f1db161p-92, 0x1.9c87503dd7359p-95, -0x1.a99e045732bdp-97, 0x1.001606a83b615p-98,
     -0x1.53822670e57a4p-100, 0x1.e13550b9a0367p-102, -0x1.66a9c009a4b1ap-103, 0x1.151cfda1dca9cp-104},
     /* [7] 1.875 <= y <= 2 2^-60, degree 10, 108.8 bits */
    {0x1.20c3d49855cbfp+0, -0x1.a8af23225087dp-54, -0x1.353276403cc38p-57, 0x1.71d3fc9cf0849p-87,
     -0x1.d00e3a7ff81bcp-90, 0x1.477f09473d7ebp-91, -0x1.341c2012e7dap-92, 0x1.521cb2e59d512p-93,
     -0x1.98cbf30291902p-94, 0x1.0839674687a89p-94, -0x1.68838f4a24f86p-95, 0x1.fc408d3f7cb6bp-96},
     /* [8] 1 <= y <= 1.125 2^-59, degree 10, 107.8 bits */
    {0x1.20c3d49855cbfp+0, -0x1.ad83ecfb4ea51p-54, -0x1.3532763ed5374p-57, 0x1.5dd2e6d7ea74ap-87, -0x1.88c26908dcd9p-90,
     0x1.f009e31027656p-92, -0x1.a198c972537fdp-93, 0x1.9a16ab36a2b26p-94, -0x1.bbba25df7aeddp-95, 0x1.00af1deb8d83p-95,
     -0x1.3927e814429fep-96, 0x1.8b28140aadc49p-97}, /* [9] 1.125 <= y <= 1.25 2^-59, degree 10, 107.4 bits */
    {0x1.20c3d49855cbfp+0, -0x1.b258b6d4474a2p-54, -0x1.3532763d80248p-57, 0x1.4cbfefe90554ep-87,
     -0x1.5204094144378p-90, 0x1.82423b91db3dfp-92, -0x1.263ab8bc786d3p-93, 0x1.05732b3e7e383p-94,
     -0x1.fffc1a7d3883dp-96, 0x1.0c03c002c0bf7p-96, -0x1.27b1bb8f85d34p-97, 0x1.51abb7fbb8c0dp-98},
     /* [10] 1.25 <= y <= 1.375 2^-59, degree 10, 109.3 bits */
    {0x1.20c3d49855cbfp+0, -0x1.b72d80ad3abb6p-54, -0x1.3532763c3af58p-57, 0x1.3df4382661c48p-87, -0x1.26e7562ab546p-90,
     0x1.33b2d4b318461p-92, -0x1.ac0853b6a52b8p-94, 0x1.5b4caac68348ap-95, -0x1.36838500df087p-96,
     0x1.28de460454311p-97, -0x1.2aef6320bd872p-98, 0x1.37be00d54b657p-99},
     /* [11] 1.375 <= y <= 1.5 2^-59, degree 10, 108.0 bits */
    {0x1.20c3d49855cbfp+0, -0x1.bc024a8629344p-54, -0x1.3532763b03a1bp-57, 0x1.30f89be876144p-87,
     -0x1.043c380cd5cf5p-90, 0x1.f39e34eaae937p-93, -0x1.3fb70ca08e8b5p-94, 0x1.dd5856abe0008p-96,
     -0x1.88ac3e3001f0dp-97, 0x1.596b1b6c0f091p-98, -0x1.3fe734ec62e54p-99, 0x1.32f5a02ef8fbbp-100},
     /* [12] 1.5 <= y <= 1.625 2^-59, degree 10, 110.4 bits */
    {0x1.20c3d49855cbfp+0, -0x1.c0d7145f12e8cp-54, -0x1.35327639d887p-57, 0x1.25757834e98cbp-87, -0x1.cfba66e449307p-91,
     0x1.9c2e5e5dbc5b8p-93, -0x1.e876521cf4015p-95, 0x1.51a5f20851e4dp-96, -0x1.013230478f986p-97,
     0x1.a300f66e60ac4p-99, -0x1.67393541ccc26p-100, 0x1.3f2fe5d0d0267p-101},
     /* [13] 1.625 <= y <= 1.75 2^-59, degree 10, 107.7 bits */
    {0x1.20c3d49855cbfp+0, -0x1.c5abde37f807p-54, -0x1.35327638b84f7p-57, 0x1.1b28b54419526p-87, -0x1.a0985fd115ae2p-91,
     0x1.58c10dd4afda1p-93, -0x1.7c6351d4193cfp-95, 0x1.e9a1b78b2b9a6p-97, -0x1.5b42721d6d305p-98,
     0x1.075f12c7df8f9p-99, -0x1.a45db38726ee2p-101, 0x1.5bc7f059ba593p-102},
     /* [14] 1.75 <= y <= 1.875 2^-59, degree 10, 107.3 bits */
    {0x1.20c3d49855cbfp+0, -0x1.ca80a810d8b84p-54, -0x1.35327637a1df3p-57, 0x1.11df6988df06ep-87,
     -0x1.78f0392b50256p-91, 0x1.23d043dd2baf4p-93, -0x1.2d35194e9f267p-95, 0x1.6ab4ce5a4a1c2p-97,
     -0x1.e14e2f4e25197p-99, 0x1.55800383177e1p-100, -0x1.fdd1fe407ec82p-102, 0x1.8a996d135a775p-103},
     /* [15] 1.875 <= y <= 2 2^-59, degree 10, 109.1 bits */
    {0x1.20c3d49855cbfp+0, -0x1.d1bfd6d621c64p-54, -0x1.35327636108c5p-56, 0x1.0582e04e44a6p-85, -0x1.482b027472725p-88,
     0x1.cf48e34396d38p-90, -0x1.b40303a6fba47p-91, 0x1.deb86273744ebp-92, -0x1.219c26477b576p-92,
     0x1.76baa722c4756p-93, -0x1.ffe53ce712b2p-94, 0x1.695829eeb34b8p-94},
     /* [16] 1 <= y <= 1.125 2^-58, degree 10, 108.3 bits */
    {0x1.20c3d49855cbfp+0, -0x1.db696a87ca45dp-54, -0x1.353276341410bp-56, 0x1.eebadcdcae314p-86,
     -0x1.15bdcf24cc1f4p-88, 0x1.5ed35278f2ac9p-90, -0x1.276c135d9fbebp-91, 0x1.2239262fbf853p-92,
     -0x1.3a32fc284b7c2p-93, 0x1.6bc4859a27256p-94, -0x1.bc3194dd88f33p-95, 0x1.188d81ee5dac1p-95},
     /* [17] 1.125 <= y <= 1.25 2^-58, degree 10, 107.2 bits */
    {0x1.20c3d49855cbfp+0, -0x1.e512fe39634cep-54, -0x1.3532763231b61p-56, 0x1.d69507d73c3eep-86,
     -0x1.de0cb9436a429p-89, 0x1.112b076ff6f93p-90, -0x1.a03f0b87d509ep-92, 0x1.71fb5bbd1380bp-93,
     -0x1.6a687d4da97d1p-94, 0x1.7ba22e2d7872dp-95, -0x1.a320c99db31f2p-96, 0x1.df05f16710e5ap-97},
     /* [18] 1.25 <= y <= 1.375 2^-58, degree 10, 108.0 bits */
    {0x1.20c3d49855cbfp+0, -0x1.eebc91eaed9d1p-54, -0x1.3532763065d46p-56, 0x1.c1a829cd4a4c8p-86,
     -0x1.a112618512bf4p-89, 0x1.b333a3fbc585p-91, -0x1.2ebe68f20791dp-92, 0x1.eb6549d0dd70fp-94,
     -0x1.b77d048e7fdc6p-95, 0x1.a45a74b8c409fp-96, -0x1.a7821ba311d29p-97, 0x1.b9f0f459e05c9p-98},
     /* [19] 1.375 <= y <= 1.5 2^-58, degree 10, 108.2 bits */
    {0x1.20c3d49855cbfp+0, -0x1.f866259c69de5p-54, -0x1.3532762ead8b6p-56, 0x1.af4bb860399c7p-86,
     -0x1.7009cad4f2169p-89, 0x1.615086b0a024ap-91, -0x1.c43c9f40cf614p-93, 0x1.51a9a0b612749p-94,
     -0x1.15d68ddd2f7d8p-95, 0x1.e8f89bf6e85bdp-97, -0x1.c50c207650acbp-98, 0x1.b2f1eff069e91p-99},
     /* [20] 1.5 <= y <= 1.625 2^-58, degree 10, 107.4 bits */
    {0x1.20c3d49855cbep+0, 0x1.fdf046b2275c2p-54, -0x1.3532762d068bcp-56, 0x1.9f03bc37bdfd2p-86, -0x1.47e986c755a8p-89,
     0x1.2379e77305304p-91, -0x1.59732bc8debadp-93, 0x1.dda6a30d50c4cp-95, -0x1.6bea170c90b1p-96, 0x1.2882f487a798cp-97,
     -0x1.fc97d240220cep-99, 0x1.c41a4ebfa8d9ap-100}, /* [21] 1.625 <= y <= 1.75 2^-58, degree 10, 107.4 bits */
    {0x1.20c3d49855cbep+0, 0x1.f446b300c58fep-54, -0x1.3532762b6ef1dp-56, 0x1.9072b8c00aad8p-86, -0x1.269507c8fcbe6p-89,
     0x1.e7952253631c1p-92, -0x1.0d0250bb25aeap-93, 0x1.5a4e4e46ac3edp-95, -0x1.eb4cd4f4f1104p-97,
     0x1.74b2feb860a1bp-98, -0x1.2984777d59cbdp-99, 0x1.ec76bb1add5dfp-101},
     /* [22] 1.75 <= y <= 1.875 2^-58, degree 10, 107.6 bits */
    {0x1.20c3d49855cbep+0, 0x1.ea9d1f4f70483p-54, -0x1.35327629e52c3p-56, 0x1.8350ab12f71bep-86, -0x1.0a8a060e709a7p-89,
     0x1.9cb4665488362p-92, -0x1.aa03e7400479ap-94, 0x1.0085ca5b380aep-95, -0x1.5472b7403e60dp-97,
     0x1.e3347b849b8a3p-99, -0x1.68c55e7d82f41p-100, 0x1.17516990f9f8ap-101},
     /* [23] 1.875 <= y <= 2 2^-58, degree 10, 109.3 bits */
    {0x1.20c3d49855cbep+0, 0x1.dc1ec1c586f1bp-54, -0x1.35327627ad9d3p-55, 0x1.71d549e40076cp-84, -0x1.d01a9fbe17dffp-87,
     0x1.479a2b27f5791p-88, -0x1.34548a4eb315dp-89, 0x1.528e60351c4ap-90, -0x1.99ac63290e5a9p-91, 0x1.0913ec5a0dea2p-91,
     -0x1.6a2cb8c6601e1p-92, 0x1.ff6e87926b9e3p-93}, /* [24] 1 <= y <= 1.125 2^-57, degree 10, 108.1 bits */
    {0x1.20c3d49855cbep+0, 0x1.c8cb9a6322c6p-54, -0x1.35327624de828p-55, 0x1.5dd3c0ad446c3p-84, -0x1.88c9c57e51411p-87,
     0x1.f02724a68f526p-89, -0x1.a1cfd63f0f15ep-90, 0x1.9a7ad49b9c19cp-91, -0x1.bc6c6d8aed3b1p-92,
     0x1.014b6a633f1eap-92, -0x1.3a39041c2f5ddp-93, 0x1.8cfe25395596dp-94},
     /* [25] 1.125 <= y <= 1.25 2^-57, degree 10, 108.5 bits */
    {0x1.20c3d49855cbep+0, 0x1.b5787300ea5c9p-54, -0x1.35327622345bap-55, 0x1.4cc083af5c184p-84, -0x1.52089c8401af6p-87,
     0x1.8252e8f100cefp-89, -0x1.26576ad867a52p-90, 0x1.05a2d04410defp-91, -0x1.004b52c66dd63p-92,
     0x1.0c7f113461218p-93, -0x1.287570f1b5167p-94, 0x1.52ddd8a16be7bp-95},
     /* [26] 1.25 <= y <= 1.375 2^-57, degree 10, 108.6 bits */
    {0x1.20c3d49855cbep+0, 0x1.a2254b9edb914p-54, -0x1.3532761fa9fcap-55, 0x1.3df49f97dbab7p-84, -0x1.26ea4a0169659p-87,
     0x1.33bcc8a0cf867p-89, -0x1.ac27ea28fbce8p-91, 0x1.5b7cf0e6835f8p-92, -0x1.36cb7b66373a9p-93,
     0x1.2947b8d4c8acfp-94, -0x1.2b88c6dd6d9e9p-95, 0x1.3899fe4fc0b36p-96},
     /* [27] 1.375 <= y <= 1.5 2^-57, degree 10, 107.9 bits */
    {0x1.20c3d49855cbep+0, 0x1.8ed2243cf4895p-54, -0x1.3532761d3b546p-55, 0x1.30f8e64ef11dfp-84, -0x1.043e2f6c8736dp-87,
     0x1.f3aa8d33d8244p-90, -0x1.3fc93e7d2cac3p-91, 0x1.dd8be544f4281p-93, -0x1.88f3665d48023p-94,
     0x1.59cb8bddb83eep-95, -0x1.4068c383850c9p-96, 0x1.33a1409187bedp-97},
     /* [28] 1.5 <= y <= 1.625 2^-57, degree 10, 110.3 bits */
    {0x1.20c3d49855cbep+0, 0x1.7b7efcdb33a47p-54, -0x1.3532761ae51e7p-55, 0x1.2575af039cf26p-84, -0x1.cfbd179af9721p-88,
     0x1.9c36475cd57bdp-90, -0x1.e88c1b7f7253fp-92, 0x1.51c2bc78f7c85p-93, -0x1.0157342d609b9p-94,
     0x1.a35e566be9fb6p-96, -0x1.67adcbacccf25p-97, 0x1.3fbf723f20534p-98},
     /* [29] 1.625 <= y <= 1.75 2^-57, degree 10, 107.3 bits */
    {0x1.20c3d49855cbep+0, 0x1.682bd57997717p-54, -0x1.35327618a4afp-55, 0x1.1b28de8514af8p-84, -0x1.a09a41ff68a87p-88,
     0x1.58c64465ef6f9p-90, -0x1.7c70cdf223c63p-92, 0x1.e9c321e248361p-94, -0x1.5b6aad01ac681p-95,
     0x1.078e8bfab7588p-96, -0x1.a4cc7c272d2b6p-98, 0x1.5c47656219a8cp-99},
     /* [30] 1.75 <= y <= 1.875 2^-57, degree 10, 108.7 bits */
    {0x1.20c3d49855cbep+0, 0x1.54d8ae181ea65p-54, -0x1.3532761677ce4p-55, 0x1.11df8934e308p-84, -0x1.78f191a272f89p-88,
     0x1.23d3c936112e5p-90, -0x1.2d3db0af71fa8p-92, 0x1.6ac8db415b45ep-94, -0x1.e17b99c840029p-96,
     0x1.55b262642572fp-97, -0x1.fe405a83e0ab4p-99, 0x1.8b109e9102ba8p-100},
     /* [31] 1.875 <= y <= 2 2^-57, degree 10, 107.6 bits */
    {0x1.20c3d49855cbep+0, 0x1.37dbf3062954ep-54, -0x1.3532761355282p-54, 0x1.0582f65a50c6ep-82, -0x1.482bd95a1bde5p-85,
     0x1.cf4cf43656f04p-87, -0x1.b40c2b73aa6fap-88, 0x1.decc0e3740554p-89, -0x1.21b09fc679801p-89,
     0x1.76e4575711084p-90, -0x1.001cc78ddb0bfp-90, 0x1.69ab9ab486287p-91},
     /* [32] 1 <= y <= 1.125 2^-56, degree 10, 110.2 bits */
    {0x1.20c3d49855cbep+0, 0x1.1135a443fed62p-54, -0x1.3532760f5c309p-54, 0x1.eebaf9b8bd4eap-83, -0x1.15be47b9bed14p-85,
     0x1.5ed567040c6b9p-87, -0x1.2770548a1df89p-88, 0x1.22416db405fe9p-89, -0x1.3a428fed2f706p-90,
     0x1.6be12435c1bf4p-91, -0x1.bc65a86060886p-92, 0x1.18bbe83f7c43ap-92},
     /* [33] 1.125 <= y <= 1.25 2^-56, degree 10, 108.2 bits */
    {0x1.20c3d49855cbep+0, 0x1.d51eab04a0383p-55, -0x1.3532760b977b2p-54, 0x1.d6951bf494d14p-83, -0x1.de0d474889908p-86,
     0x1.112c28373e373p-87, -0x1.a043479ef5d7cp-89, 0x1.7202e69e5dc44p-90, -0x1.6a7573aceee0dp-91,
     0x1.7bb7e6aa61532p-92, -0x1.a344be8f3d00dp-93, 0x1.df4042ff0026ap-94},
     /* [34] 1.25 <= y <= 1.375 2^-56, degree 10, 110.3 bits */
    {0x1.20c3d49855cbep+0, 0x1.87d20d822e30fp-55, -0x1.35327607ffb79p-54, 0x1.c1a838ab25982p-83, -0x1.a112b88ffa2dcp-86,
     0x1.b334ec8b622d3p-88, -0x1.2ec0a3b9c9fdap-89, 0x1.eb6c9ecd4e687p-91, -0x1.b788a0b3fcc07p-92,
     0x1.a46c5ad65b031p-93, -0x1.a79d4fb130267p-94, 0x1.ba1977d7feab9p-95},
     /* [35] 1.375 <= y <= 1.5 2^-56, degree 10, 111.0 bits */
    {0x1.20c3d49855cbep+0, 0x1.3a8570009d191p-55, -0x1.353276048f259p-54, 0x1.af4bc3f96df0bp-83, -0x1.700a0201202fp-86,
     0x1.61514942be6fcp-88, -0x1.c43f154ee83abp-90, 0x1.51ad63e624a4cp-91, -0x1.15dc154ede252p-92,
     0x1.e90868a74e977p-94, -0x1.c52256f45336dp-95, 0x1.b310899ed66fp-96},
     /* [36] 1.5 <= y <= 1.625 2^-56, degree 10, 111.4 bits */
    {0x1.20c3d49855cbep+0, 0x1.da71a4ffc77a6p-56, -0x1.3532760141263p-54, 0x1.9f03c5b7507e6p-83, -0x1.47e9aac5aa76bp-86,
     0x1.237a5ead28cebp-88, -0x1.597495bd0431ap-90, 0x1.ddaaae34756bfp-92, -0x1.6befa37132f27p-93,
     0x1.288a58e961547p-94, -0x1.fcab2bd2cf3f4p-96, 0x1.c4331e4ef3ca2p-97},
     /* [37] 1.625 <= y <= 1.75 2^-56, degree 10, 110.7 bits */
    {0x1.20c3d49855cbep+0, 0x1.3fd869fff3eaep-56, -0x1.353275fe11f25p-54, 0x1.9072c0dcaa18cp-83, -0x1.26951fdc966c6p-86,
     0x1.e795b8cebd063p-89, -0x1.0d0327f4b69d2p-90, 0x1.5a5091013f9c4p-92, -0x1.eb52a7b22203ap-94,
     0x1.74ba447ffbbd6p-95, -0x1.298d60442fa68p-96, 0x1.ec8c1c1ebb6b9p-98},
     /* [38] 1.75 <= y <= 1.875 2^-56, degree 10, 109.0 bits */
    {0x1.20c3d49855cbep+0, 0x1.4a7e5e0361d96p-57, -0x1.353275fafe66ep-54, 0x1.8350b23fa4ef9p-83, -0x1.0a8a1685473f3p-86,
     0x1.9cb4c7c2db094p-89, -0x1.aa04eefd6fa84p-91, 0x1.0087193ebb44cp-92, -0x1.5475e49e16f49p-94,
     0x1.e33bf4af006dbp-96, -0x1.68cdfa82bfd6cp-97, 0x1.175b1f78a74acp-98},
     /* [39] 1.875 <= y <= 2 2^-56, degree 10, 109.8 bits */
    {0x1.20c3d49855cbep+0, -0x1.0a9aa5e383ba2p-58, -0x1.353275f68f48ep-53, 0x1.71d5502bd20eep-81,
     -0x1.d01ab30d1d7e2p-84, 0x1.479a60107c6e5p-85, -0x1.34550f1060dd1p-86, 0x1.528f97de879fbp-87,
     -0x1.99af1d3c8ea6fp-88, 0x1.0916e0207031fp-88, -0x1.6a33053ee8a15p-89, 0x1.ff7b92dd3f223p-90},
     /* [40] 1 <= y <= 1.125 2^-55, degree 10, 111.4 bits */
    {0x1.20c3d49855cbep+0, -0x1.77d91f6c9a72dp-56, -0x1.353275f0f1137p-53, 0x1.5dd3c64bcf3fep-81, -0x1.88c9cf8b6bd4p-84,
     0x1.f02756afbdc7p-86, -0x1.a1d048eafa8bcp-87, 0x1.9a7bc9c016f84p-88, -0x1.bc6e601529246p-89, 0x1.014d534b770e2p-89,
     -0x1.3a3cb1686a5efp-90, 0x1.8d0505413a468p-91}, /* [41] 1.125 <= y <= 1.25 2^-55, degree 10, 109.1 bits */
    {0x1.20c3d49855cbep+0, -0x1.5685caad6dd79p-55, -0x1.353275eb9cc59p-53, 0x1.4cc088f3608f5p-81,
     -0x1.5208a21086de1p-84, 0x1.8253021a6c9d2p-86, -0x1.2657a003b54fbp-87, 0x1.05a338d860c68p-88,
     -0x1.004c15ee0916cp-89, 0x1.0c806fa43aad9p-90, -0x1.2877d8aff006ep-91, 0x1.52e1f364e6014p-92},
     /* [42] 1.25 <= y <= 1.375 2^-55, degree 10, 108.4 bits */
    {0x1.20c3d49855cbep+0, -0x1.f11f05a1f493dp-55, -0x1.353275e688077p-53, 0x1.3df4a4a8a9d77p-81,
     -0x1.26ea4d3c85e28p-84, 0x1.33bcd5f25d03cp-86, -0x1.ac281e6e52b4ep-88, 0x1.5b7d504a082f2p-89,
     -0x1.36cc2026a98b2p-90, 0x1.2948ca0fda4d3p-91, -0x1.2b8a810573cecp-92, 0x1.389cb50e3c1a9p-93},
     /* [43] 1.375 <= y <= 1.5 2^-55, degree 10, 108.3 bits */
    {0x1.20c3d49855cbep+0, -0x1.45dc2049ff8cep-54, -0x1.353275e1aab6ep-53, 0x1.30f8eb4139f96p-81,
     -0x1.043e3167225fdp-84, 0x1.f3aa9beed30ccp-87, -0x1.3fc959790057p-88, 0x1.dd8c4144b0944p-90,
     -0x1.88f3fa7d40ab4p-91, 0x1.59cc70675c1ecp-92, -0x1.406a1ab6f776fp-93, 0x1.33a334c25cc59p-94},
     /* [44] 1.5 <= y <= 1.625 2^-55, degree 10, 107.5 bits */
    {0x1.20c3d49855cbep+0, -0x1.9328bdc1d3b79p-54, -0x1.353275dcfe4bp-53, 0x1.2575b3e2c48ebp-81, -0x1.cfbd1a275c848p-85,
     0x1.9c364fd3ca206p-87, -0x1.e88c388bc1dc3p-89, 0x1.51c2eafd2f15fp-90, -0x1.01577a6aae83p-91, 0x1.a35f214dd8e3ap-93,
     -0x1.67aee8383e324p-94, 0x1.3fc0f54f2e5eep-95}, /* [45] 1.625 <= y <= 1.75 2^-55, degree 10, 108.0 bits */
    {0x1.20c3d49855cbep+0, -0x1.e0755b388252dp-54, -0x1.353275d87d6c1p-53, 0x1.1b28e357a093dp-81,
     -0x1.a09a43b91accfp-85, 0x1.58c6496efaa64p-87, -0x1.7c70de284edbcp-89, 0x1.e9c352e0e77efp-91,
     -0x1.5b6af2beb38b6p-92, 0x1.078eeac14f77bp-93, -0x1.a4cd75cb37c9bp-95, 0x1.5c48a4080e43ap-96},
     /* [46] 1.75 <= y <= 1.875 2^-55, degree 10, 107.8 bits */
    {0x1.20c3d49855cbdp+0, 0x1.d23e0751ea507p-54, -0x1.353275d423aa7p-53, 0x1.11df8dfeb147dp-81, -0x1.78f192dcef90cp-85,
     0x1.23d3cc4ddfd5cp-87, -0x1.2d3dba069a798p-89, 0x1.6ac8f5fd0d5d6p-91, -0x1.e17be1d57903bp-93,
     0x1.55b2bef44ed87p-94, -0x1.fe41408ba3f55p-96, 0x1.8b11b35ce9aecp-97},
     /* [47] 1.875 <= y <= 2 2^-55, degree 10, 108.1 bits */
    {0x1.20c3d49855cbdp+0, 0x1.5e4b1b238c3ffp-54, -0x1.353275cdde5ep-52, 0x1.0582fb1b2a016p-79, -0x1.482bda292e309p-82,
     0x1.cf4cf75da5454p-84, -0x1.b40c340ffd7b7p-85, 0x1.decc25096ba15p-86, -0x1.21b0bc4bff2cp-86, 0x1.76e49b2f0aec7p-87,
     -0x1.001d1616323ffp-87, 0x1.69ac48edaf031p-88}, /* [48] 1 <= y <= 1.125 2^-54, degree 10, 107.1 bits */
    {0x1.20c3d49855cbdp+0, 0x1.8763c07d3c85ep-55, -0x1.353275c5ec6ecp-52, 0x1.eebb032aae91fp-80, -0x1.15be4843d4e4ep-82,
     0x1.5ed56871663fep-84, -0x1.277057e1a215ap-85, 0x1.224175bb45c72p-86, -0x1.3a42a241531d4p-87,
     0x1.6be14bfceeb2ap-88, -0x1.bc65fc057f96bp-89, 0x1.18bc3c823bb6fp-89},
     /* [49] 1.125 <= y <= 1.25 2^-54, degree 10, 109.6 bits */
    {0x1.20c3d49855cbdp+0, 0x1.48c52aec735fdp-57, -0x1.353275be6303cp-52, 0x1.d695255b4b629p-80, -0x1.de0d481acea8ep-83,
     0x1.112c28f259dd8p-84, -0x1.a0434a74c2372p-86, 0x1.7202ecc76cc08p-87, -0x1.6a75809de3f51p-88,
     0x1.7bb8008be100fp-89, -0x1.a344f08c2bd4dp-90, 0x1.df409f74eb5cfp-91},
     /* [50] 1.25 <= y <= 1.375 2^-54, degree 10, 110.0 bits */
    {0x1.20c3d49855cbdp+0, -0x1.c60255ff4edefp-56, -0x1.353275b7337c9p-52, 0x1.c1a84208ea9dbp-80,
     -0x1.a112b93e87d94p-83, 0x1.b334ed64af4b1p-85, -0x1.2ec0a5091d981p-86, 0x1.eb6ca3e555c1bp-88,
     -0x1.b788aa9514972p-89, 0x1.a46c6d2d640c1p-90, -0x1.a79d7084c0acbp-91, 0x1.ba19b014e84cap-92},
     /* [51] 1.375 <= y <= 1.5 2^-54, degree 10, 108.8 bits */
    {0x1.20c3d49855cbdp+0, -0x1.0c19d059b21dep-54, -0x1.353275b052586p-52, 0x1.af4bcd4f912cap-80,
     -0x1.700a0299c20d4p-83, 0x1.615149d0bc9d6p-85, -0x1.c43f16a0fdee9p-87, 0x1.51ad662731fd2p-88,
     -0x1.15dc1956dc92ap-89, 0x1.e908769d52dd7p-91, -0x1.c5226e45c3711p-92, 0x1.b310aee422323p-93},
     /* [52] 1.5 <= y <= 1.625 2^-54, degree 10, 107.2 bits */
    {0x1.20c3d49855cbdp+0, -0x1.a6b30b303193fp-54, -0x1.353275a9b6598p-52, 0x1.9f03cf06ab40dp-80,
     -0x1.47e9ab4f43707p-83, 0x1.237a5f13a000dp-85, -0x1.59749677ab5cp-87, 0x1.ddaab055c001cp-89,
     -0x1.6befa6eeb93e5p-90, 0x1.288a5e8fcff17p-91, -0x1.fcab3d872d5fcp-93, 0x1.c43338de0a955p-94},
     /* [53] 1.625 <= y <= 1.75 2^-54, degree 10, 107.1 bits */
    {0x1.20c3d49855cbcp+0, 0x1.beb3b9fc8d469p-54, -0x1.353275a357f19p-52, 0x1.9072ca25d81dap-80, -0x1.2695205aeb0bfp-83,
     0x1.e795b96e27618p-86, -0x1.0d032865b4549p-87, 0x1.5a50921499499p-89, -0x1.eb52aae33331p-91, 0x1.74ba495390a0dp-92,
     -0x1.298d67627a185p-93, 0x1.ec8c304299a6fp-95}, /* [54] 1.75 <= y <= 1.875 2^-54, degree 10, 107.8 bits */
    {0x1.20c3d49855cbcp+0, 0x1.241a7f2c6d43cp-54, -0x1.3532759d30daap-52, 0x1.8350bb831ecd2p-80, -0x1.0a8a16fa9abb7p-83,
     0x1.9cb4c84590b91p-86, -0x1.aa04ef92b4abcp-88, 0x1.008719d3c541p-89, -0x1.5475e627eb623p-91, 0x1.e33bf90319aap-93,
     -0x1.68ce0087c463bp-94, 0x1.175b278808dffp-95}, /* [55] 1.875 <= y <= 2 2^-54, degree 10, 107.3 bits */
    {0x1.20c3d49855cbcp+0, 0x1.e1a537cf141ep-57, -0x1.35327594529e6p-51, 0x1.71d5596771adbp-78, -0x1.d01ab3e208eadp-81,
     0x1.479a6077ccdebp-82, -0x1.34550f6c58607p-83, 0x1.528f98667a9a1p-84, -0x1.99af1e5ffd4cfp-85,
     0x1.0916e18a8a789p-85, -0x1.6a3308e1e7ac5p-86, 0x1.ff7b9bdd5caffp-87},
     /* [56] 1 <= y <= 1.125 2^-53, degree 10, 108.3 bits */
    {0x1.20c3d49855cbcp+0, -0x1.f1fb9d298922ap-55, -0x1.3532758916333p-51, 0x1.5dd3cf7e021e3p-78,
     -0x1.88c9d04990bdfp-81, 0x1.f027575109ffdp-83, -0x1.a1d0495e507f2p-84, 0x1.9a7bca39d9df5p-85,
     -0x1.bc6e60d248aadp-86, 0x1.014d5409c5341p-86, -0x1.3a3cb312ee47bp-87, 0x1.8d0508f924c4ep-88},
     /* [57] 1.125 <= y <= 1.25 2^-53, degree 10, 108.3 bits */
    {0x1.20c3d49855cbbp+0, 0x1.d1cfbbe784e9ep-54, -0x1.3532757e6d971p-51, 0x1.4cc0921d1a72cp-78, -0x1.5208a2bc819bbp-81,
     0x1.8253029d85c5fp-83, -0x1.2657a054f45ccp-84, 0x1.05a3391c585aep-85, -0x1.004c163bd2e4cp-86,
     0x1.0c80701cd9e6ep-87, -0x1.2877d9933fc9bp-88, 0x1.52e1f52907ca4p-89},
     /* [58] 1.25 <= y <= 1.375 2^-53, degree 10, 108.2 bits */
    {0x1.20c3d49855cbbp+0, 0x1.393a8cdc6bdap-55, -0x1.35327574441aap-51, 0x1.3df4adcab0681p-78, -0x1.26ea4dd98dd91p-81,
     0x1.33bcd65f7f115p-83, -0x1.ac281ee7fecefp-85, 0x1.5b7d50a14b2e8p-86, -0x1.36cc2075981a7p-87,
     0x1.2948ca6d56403p-88, -0x1.2b8a819364727p-89, 0x1.389cb6031f051p-90},
     /* [59] 1.375 <= y <= 1.5 2^-53, degree 10, 107.9 bits */
    {0x1.20c3d49855cbbp+0, -0x1.312a5e02506c2p-55, -0x1.3532756a89793p-51, 0x1.30f8f45c318f3p-78,
     -0x1.043e31f79d68ep-81, 0x1.f3aa9ca797864p-84, -0x1.3fc959d75eac4p-85, 0x1.dd8c41be0ffbfp-87,
     -0x1.88f3fada77774p-88, 0x1.59cc70bf2f567p-89, -0x1.406a1b20398ddp-90, 0x1.33a3355a6016fp-91},
     /* [60] 1.5 <= y <= 1.625 2^-53, degree 10, 108.9 bits */
    {0x1.20c3d49855cbbp+0, -0x1.cdc7a466fd973p-54, -0x1.3532756130a13p-51, 0x1.2575bcf7382f7p-78,
     -0x1.cfbd1b32eedbcp-82, 0x1.9c3650724412p-84, -0x1.e88c39219887ap-86, 0x1.51c2eb55a17e9p-87,
     -0x1.01577aa73ef42p-88, 0x1.a35f21ae2363p-90, -0x1.67aee89514166p-91, 0x1.3fc0f5bca0b4bp-92},
     /* [61] 1.625 <= y <= 1.75 2^-53, degree 10, 107.2 bits */
    {0x1.20c3d49855cbap+0, 0x1.fa0bcc78b3082p-55, -0x1.353275582ee2fp-51, 0x1.1b28ec66076e2p-78, -0x1.a09a44b23ac62p-82,
     0x1.58c649f8661bep-84, -0x1.7c70dea15dd3cp-86, 0x1.e9c35365bbb8ep-88, -0x1.5b6af3121c74cp-89,
     0x1.078eeafc0c391p-90, -0x1.a4cd762a77f98p-92, 0x1.5c48a46406e0fp-93},
     /* [62] 1.75 <= y <= 1.875 2^-53, degree 10, 107.8 bits */
    {0x1.20c3d49855cbap+0, -0x1.c16478bbab657p-57, -0x1.3532754f7b5f7p-51, 0x1.11df970772aaep-78,
     -0x1.78f193c5fd548p-82, 0x1.23d3ccc62921fp-84, -0x1.2d3dba69d11b5p-86, 0x1.6ac8f662f7723p-88,
     -0x1.e17be24cac201p-90, 0x1.55b2bf410de2ap-91, -0x1.fe4140f928226p-93, 0x1.8b11b3b620937p-94},
     /* [63] 1.875 <= y <= 2 2^-53, degree 10, 112.5 bits */
    {0x1.20c3d49855cb9p+0, 0x1.f807c0facbff7p-54, -0x1.35327542f0c63p-50, 0x1.0583041c194c8p-76, -0x1.482bdafdab3fp-79,
     0x1.cf4cf825a9c77p-81, -0x1.b40c34a68d09dp-82, 0x1.decc2596bb5efp-83, -0x1.21b0bc9766458p-83,
     0x1.76e49b86b024fp-84, -0x1.001d164d29286p-84, 0x1.69ac49383eae3p-85},
     /* [64] 1 <= y <= 1.125 2^-52, degree 10, 106.7 bits */
    {0x1.20c3d49855cb9p+0, -0x1.c974a5ec2ff09p-56, -0x1.353275330ce72p-50, 0x1.eebb1519b7d3ep-77,
     -0x1.15be4901f31b5p-79, 0x1.5ed5691185b5dp-81, -0x1.2770584d8942dp-82, 0x1.22417616144f3p-83,
     -0x1.3a42a2985c8d9p-84, 0x1.6be14c57a1d75p-85, -0x1.bc65fc6a1a58bp-86, 0x1.18bc3cbcbf531p-86},
     /* [65] 1.125 <= y <= 1.25 2^-52, degree 10, 107.4 bits */
    {0x1.20c3d49855cb8p+0, 0x1.233dec2e0d398p-54, -0x1.35327523fa108p-50, 0x1.d6953739625ccp-77, -0x1.de0d4972d384ap-80,
     0x1.112c29756ad76p-81, -0x1.a0434b1498726p-83, 0x1.7202ed413f7bcp-84, -0x1.6a758107d6125p-85, 0x1.7bb800f03b9ep-86,
     -0x1.a344f0f12fe09p-87, 0x1.df409fdebad96p-88}, /* [66] 1.25 <= y <= 1.375 2^-52, degree 10, 106.3 bits */
    {0x1.20c3d49855cb8p+0, -0x1.4726fe0b6bf5cp-54, -0x1.353275159b019p-50, 0x1.c1a853d79a4eap-77,
     -0x1.a112ba78a21f8p-80, 0x1.b334ee3f32893p-82, -0x1.2ec0a582c23dp-83, 0x1.eb6ca48eafdcap-85,
     -0x1.b788ab1bc115bp-86, 0x1.a46c6da243a4fp-87, -0x1.a79d70f0ad95ap-88, 0x1.ba19b07c9e3a7p-89},
     /* [67] 1.375 <= y <= 1.5 2^-52, degree 10, 106.5 bits */
    {0x1.20c3d49855cb7p+0, 0x1.39d05f5ce3221p-56, -0x1.35327507d8b8bp-50, 0x1.af4bdf1022984p-77, -0x1.700a03babb731p-80,
     0x1.61514a89adb84p-82, -0x1.c43f175e67cfap-84, 0x1.51ad66a07e623p-85, -0x1.15dc19afa82d7p-86, 0x1.e908772b640dp-88,
     -0x1.c5226ebee30f8p-89, 0x1.b310af4fcedabp-90}, /* [68] 1.5 <= y <= 1.625 2^-52, degree 10, 107.8 bits */
    {0x1.20c3d49855cb6p+0, 0x1.e40f2dd4d508bp-54, -0x1.353274faa0ba7p-50, 0x1.9f03e0ba34b54p-77, -0x1.47e9ac5ad5232p-80,
     0x1.237a5fb22e0b3p-82, -0x1.5974970e036f8p-84, 0x1.ddaab1080411ep-86, -0x1.6befa76790fb5p-87,
     0x1.288a5ee967891p-88, -0x1.fcab3e14edc69p-90, 0x1.c433395335506p-91},
     /* [69] 1.625 <= y <= 1.75 2^-52, degree 10, 106.6 bits */
    {0x1.20c3d49855cb6p+0, -0x1.0cab782738626p-55, -0x1.353274ede3e9fp-50, 0x1.9072dbcd4817bp-77,
     -0x1.2695215408eb2p-80, 0x1.e795ba810801dp-83, -0x1.0d0328df077b7p-84, 0x1.5a50929a82f91p-86,
     -0x1.eb52ab8c35e4dp-88, 0x1.74ba49c842ea3p-89, -0x1.298d67b884715p-90, 0x1.ec8c30c762d18p-92},
     /* [70] 1.75 <= y <= 1.875 2^-52, degree 10, 106.6 bits */
    {0x1.20c3d49855cb5p+0, 0x1.0f455a1cfbaafp-54, -0x1.353274e195bb7p-50, 0x1.8350cd1f43f33p-77, -0x1.0a8a17e3a64dcp-80,
     0x1.9cb4c9361ea61p-83, -0x1.aa04f05959028p-85, 0x1.00871a3a4f0ecp-86, -0x1.5475e6a0f54eep-88,
     0x1.e33bf99f75395p-90, -0x1.68ce00f3a681bp-91, 0x1.175b27d60893fp-92},
     /* [71] 1.875 <= y <= 2 2^-52, degree 10, 106.7 bits */
    {0x1.20c3d49855cb4p+0, 0x1.6fadfb9309998p-54, -0x1.353274cfd9422p-49, 0x1.71d56af3f2c5p-75, -0x1.d01ab58b00362p-78,
     0x1.479a613fc770ap-79, -0x1.34551002e80f1p-80, 0x1.528f98f42e585p-81, -0x1.99af1ef873ca5p-82,
     0x1.0916e1e44ce2dp-82, -0x1.6a33095332ec3p-83, 0x1.ff7b9c72e843p-84},
     /* [72] 1 <= y <= 1.125 2^-51, degree 10, 106.0 bits */
    {0x1.20c3d49855cb3p+0, 0x1.35c8510201badp-55, -0x1.353274b9606acp-49, 0x1.5dd3e0f7adf54p-75, -0x1.88c9d1c5cc871p-78,
     0x1.f02758913b59ap-80, -0x1.a1d04a360250fp-81, 0x1.9a7bcaef7832p-82, -0x1.bc6e6181139bap-83, 0x1.014d5465cd626p-83,
     -0x1.3a3cb37abb1c6p-84, 0x1.8d050973bb71ep-85}, /* [73] 1.125 <= y <= 1.25 2^-51, degree 10, 106.0 bits */
    {0x1.20c3d49855cb2p+0, -0x1.cf2d51cc1ac29p-57, -0x1.353274a40f317p-49, 0x1.4cc0a385d401ap-75,
     -0x1.5208a41486ff3p-78, 0x1.825303a3a223p-80, -0x1.2657a0f4b5e51p-81, 0x1.05a339960cc89p-82,
     -0x1.004c16a5c9069p-83, 0x1.0c807081c6117p-84, -0x1.2877d9fa1ef7cp-85, 0x1.52e1f596e5ecp-86},
     /* [74] 1.25 <= y <= 1.375 2^-51, degree 10, 108.8 bits */
    {0x1.20c3d49855cb1p+0, -0x1.0eaf7ca0cb4a6p-54, -0x1.3532748fbc377p-49, 0x1.3df4bf2402a48p-75,
     -0x1.26ea4f13a904fp-78, 0x1.33bcd73a017d8p-80, -0x1.ac281fdb33814p-82, 0x1.5b7d514a76fbcp-83,
     -0x1.36cc20fc11ae8p-84, 0x1.2948cae24249p-85, -0x1.2b8a82001e4dfp-86, 0x1.389cb66d16fc5p-87},
     /* [75] 1.375 <= y <= 1.5 2^-51, degree 10, 106.3 bits */
    {0x1.20c3d49855cbp+0, -0x1.e3794eb88c695p-54, -0x1.3532747c46f37p-49, 0x1.30f905a7657bbp-75, -0x1.043e331897a7dp-78,
     0x1.f3aa9e197c3f1p-81, -0x1.3fc95a94c1412p-82, 0x1.dd8c42b075fc5p-84, -0x1.88f3fb8bbcddap-85,
     0x1.59cc714cf9e3fp-86, -0x1.406a1b99752aep-87, 0x1.33a335c709d04p-88},
     /* [76] 1.5 <= y <= 1.625 2^-51, degree 10, 105.9 bits */
    {0x1.20c3d49855caep+0, 0x1.47bcdf7bf88bap-54, -0x1.3532746995427p-49, 0x1.2575ce35641bbp-75, -0x1.cfbd1d4a138bcp-79,
     0x1.9c3651af63c47p-81, -0x1.e88c3a4e47646p-83, 0x1.51c2ec07cedf4p-84, -0x1.01577b1fe7076p-85,
     0x1.a35f2260dacb7p-87, -0x1.67aee92281f5fp-88, 0x1.3fc0f631f8f78p-89},
     /* [77] 1.625 <= y <= 1.75 2^-51, degree 10, 107.1 bits */
    {0x1.20c3d49855cadp+0, 0x1.cbcc37e7859e5p-56, -0x1.3532745791c4ep-49, 0x1.1b28fd9819d9ap-75, -0x1.a09a46a4775dcp-79,
     0x1.58c64b0b4a1p-81, -0x1.7c70df94082cap-83, 0x1.e9c354718014ap-85, -0x1.5b6af3baefc1cp-86, 0x1.078eeb7075aa9p-87,
     -0x1.a4cd76d5f6acfp-89, 0x1.5c48a4e87bf5p-90}, /* [78] 1.75 <= y <= 1.875 2^-51, degree 10, 107.2 bits */
    {0x1.20c3d49855cacp+0, -0x1.875b0d0598604p-56, -0x1.353274462abccp-49, 0x1.11dfa82e3a3e6p-75,
     -0x1.78f1959814f3cp-79, 0x1.23d3cdb6b99e2p-81, -0x1.2d3dbb307aca9p-83, 0x1.6ac8f7300a356p-85,
     -0x1.e17be33e97865p-87, 0x1.55b2bfdd1c704p-88, -0x1.fe4141d02f2e2p-90, 0x1.8b11b4517b42ap-91},
     /* [79] 1.875 <= y <= 2 2^-51, degree 10, 110.5 bits */
    {0x1.20c3d49855caap+0, 0x1.7bea0d95b5693p-56, -0x1.3532742d1588bp-48, 0x1.058315333ccedp-73, -0x1.482bdca6a2a74p-76,
     0x1.cf4cf9b5a1aeep-78, -0x1.b40c35d3b538dp-79, 0x1.decc26b22e1a3p-80, -0x1.21b0bd2fd742cp-80,
     0x1.76e49c3a048bfp-81, -0x1.001d16be29251p-81, 0x1.69ac49cd26b4p-82},
     /* [80] 1 <= y <= 1.125 2^-50, degree 10, 107.2 bits */
    {0x1.20c3d49855ca8p+0, -0x1.4a991d82f25bbp-54, -0x1.3532740d4dc87p-48, 0x1.eebb372254582p-74,
     -0x1.15be4a7e2ecdcp-76, 0x1.5ed56a51b7bf4p-78, -0x1.277059253fa94p-79, 0x1.224176cbbc8b2p-80,
     -0x1.3a42a3473173fp-81, 0x1.6be14d0fa9c5cp-82, -0x1.bc65fd39729cap-83, 0x1.18bc3d36fb449p-83},
     /* [81] 1.125 <= y <= 1.25 2^-50, degree 10, 105.9 bits */
    {0x1.20c3d49855ca5p+0, 0x1.0bd3428c3789p-54, -0x1.353273ef28191p-48, 0x1.d69559201a534p-74, -0x1.de0d4c22de153p-77,
     0x1.112c2a7b86f3bp-78, -0x1.a0434c541eecfp-80, 0x1.7202ee34b35cep-81, -0x1.6a7581dbd427ep-82,
     0x1.7bb801ba22901p-83, -0x1.a344f1bee20e9p-84, 0x1.df40a0ba29cbfp-85},
     /* [82] 1.25 <= y <= 1.375 2^-50, degree 10, 107.6 bits */
    {0x1.20c3d49855ca3p+0, -0x1.3b80b8f26351fp-55, -0x1.353273d269f91p-48, 0x1.c1a8759f83a24p-74,
     -0x1.a112bcecd85c5p-77, 0x1.b334eff436516p-79, -0x1.2ec0a675f778p-80, 0x1.eb6ca5e1113ddp-82,
     -0x1.b788ac28c8f5dp-83, 0x1.a46c6e8c36748p-84, -0x1.a79d71ca336e5p-85, 0x1.ba19b1507eef1p-86},
     /* [83] 1.375 <= y <= 1.5 2^-50, degree 10, 105.6 bits */
    {0x1.20c3d49855cap+0, 0x1.b8ac056254a29p-54, -0x1.353273b6e5652p-48, 0x1.af4c00bbcf4c6p-74, -0x1.700a05fcaff84p-77,
     0x1.61514bfb916c4p-79, -0x1.c43f18d92bbf1p-81, 0x1.51ad6792e7a06p-82, -0x1.15dc1a60f7a32p-83,
     0x1.e9087847193b7p-85, -0x1.c5226fb17cc84p-86, 0x1.b310b02936369p-87},
     /* [84] 1.5 <= y <= 1.625 2^-50, degree 10, 106.1 bits */
    {0x1.20c3d49855c9ep+0, 0x1.e30d02b2e1c54p-59, -0x1.3532739c75668p-48, 0x1.9f04024bd167ep-74, -0x1.47e9ae71f9f75p-77,
     0x1.237a60ef4cf92p-79, -0x1.5974983ab07dcp-81, 0x1.ddaab26c5f5fep-83, -0x1.6befa858e9715p-84,
     0x1.288a5f9c2f5f3p-85, -0x1.fcab3f2ff3fc7p-87, 0x1.c4333a3e0d0aap-88},
     /* [85] 1.625 <= y <= 1.75 2^-50, degree 10, 107.2 bits */
    {0x1.20c3d49855c9cp+0, -0x1.9a7b34679246p-54, -0x1.35327382fbc37p-48, 0x1.9072fd46b1c68p-74, -0x1.2695234645bafp-77,
     0x1.e795bca6ceeebp-80, -0x1.0d0329d1b02aap-81, 0x1.5a5093a645aa1p-83, -0x1.eb52acdde19cp-85, 0x1.74ba4ab124d78p-86,
     -0x1.298d686419ac3p-87, 0x1.ec8c31d07e2adp-89}, /* [86] 1.75 <= y <= 1.875 2^-50, degree 10, 105.0 bits */
    {0x1.20c3d49855c99p+0, 0x1.77e25fc71a4d4p-55, -0x1.3532736a5f647p-48, 0x1.8350ee8217ef4p-74, -0x1.0a8a19b5be311p-77,
     0x1.9cb4cb173f19bp-80, -0x1.aa04f1e6a9cdfp-82, 0x1.00871b075fa97p-83, -0x1.5475e792e0d6p-85, 0x1.e33bfad79e4b7p-87,
     -0x1.68ce01cac368cp-88, 0x1.175b28717df92p-89}, /* [87] 1.875 <= y <= 2 2^-50, degree 10, 108.5 bits */
    {0x1.20c3d49855c96p+0, -0x1.c26c384272743p-54, -0x1.35327346e66ebp-47, 0x1.71d58c377e998p-72,
     -0x1.d01ab8dcef9b7p-75, 0x1.479a62cfbf4aap-76, -0x1.345511300ecc5p-77, 0x1.528f9a0f9d92ap-78,
     -0x1.99af202951dcep-79, 0x1.0916e297a295ep-79, -0x1.6a330a353f745p-80, 0x1.ff7b9d9cddbcbp-81},
     /* [88] 1 <= y <= 1.125 2^-49, degree 10, 106.2 bits */
    {0x1.20c3d49855c91p+0, -0x1.15936b45f6d9dp-54, -0x1.35327319f4bbdp-47, 0x1.5dd402158f428p-72,
     -0x1.88c9d4be44797p-75, 0x1.f0275b119fe13p-77, -0x1.a1d04be56e35fp-78, 0x1.9a7bcc5ac4fc9p-79,
     -0x1.bc6e62deb6e11p-80, 0x1.014d551dd240cp-80, -0x1.3a3cb44a14f3p-81, 0x1.8d050a68418a2p-82},
     /* [89] 1.125 <= y <= 1.25 2^-49, degree 10, 104.3 bits */
    {0x1.20c3d49855c8cp+0, -0x1.a2ea6e355b291p-56, -0x1.353272ef5244fp-47, 0x1.4cc0c481d0bafp-72,
     -0x1.5208a6c4920c1p-75, 0x1.825305afdaee2p-77, -0x1.2657a2343c653p-78, 0x1.05a33a897f2cdp-79,
     -0x1.004c1779c3882p-80, 0x1.0c80714ba7f52p-81, -0x1.2877dac7cd14fp-82, 0x1.52e1f6725682fp-83},
     /* [90] 1.25 <= y <= 1.375 2^-49, degree 10, 104.2 bits */
    {0x1.20c3d49855c87p+0, 0x1.1078db14ae92cp-56, -0x1.353272c6ac4cdp-47, 0x1.3df4e00130b59p-72, -0x1.26ea5187dfac7p-75,
     0x1.33bcd8ef05c6cp-77, -0x1.ac2821c19ea92p-79, 0x1.5b7d529cd794ap-80, -0x1.36cc220916507p-81,
     0x1.2948cbcc2f669p-82, -0x1.2b8a82d99d6c6p-83, 0x1.389cb740f2e92p-84},
     /* [91] 1.375 <= y <= 1.5 2^-49, degree 10, 109.0 bits */
    {0x1.20c3d49855c82p+0, 0x1.e1ee1727c9dcep-55, -0x1.3532729fc1c0dp-47, 0x1.30f9266856e88p-72, -0x1.043e355a8c897p-75,
     0x1.f3aaa0fd446bap-78, -0x1.3fc95c0f85fa8p-79, 0x1.dd8c449548be4p-81, -0x1.88f3fcee59624p-82,
     0x1.59cc7268a994fp-83, -0x1.406a1c8c07287p-84, 0x1.33a336a0694acp-85},
     /* [92] 1.5 <= y <= 1.625 2^-49, degree 10, 105.6 bits */
    {0x1.20c3d49855c7dp+0, 0x1.9dcfe2c4cf184p-54, -0x1.3532727a5e5aap-47, 0x1.2575eedc4582fp-72, -0x1.cfbd21785dd84p-76,
     0x1.9c365429a229cp-78, -0x1.e88c3ca7a2d8p-80, 0x1.51c2ed6c2b089p-81, -0x1.01577c113ef4p-82, 0x1.a35f23c665ce4p-84,
     -0x1.67aeea3d806dap-85, 0x1.3fc0f71cc7877p-86}, /* [93] 1.625 <= y <= 1.75 2^-49, degree 10, 104.7 bits */
    {0x1.20c3d49855c79p+0, -0x1.b55743bf27444p-54, -0x1.35327256575b7p-47, 0x1.1b291e26c8396p-72,
     -0x1.a09a4a88f1939p-76, 0x1.58c64d3111576p-78, -0x1.7c70e1795a8b2p-80, 0x1.e9c356890744dp-82, -0x1.5b6af50c9bep-83,
     0x1.078eec5955f69p-84, -0x1.a4cd782d1a121p-86, 0x1.5c48a5f18de88p-87},
     /* [94] 1.75 <= y <= 1.875 2^-49, degree 10, 105.5 bits */
    {0x1.20c3d49855c74p+0, -0x1.087e680ca03c5p-54, -0x1.3532723389472p-47, 0x1.11dfc8a652e8p-72, -0x1.78f1993c45477p-76,
     0x1.23d3cf97da4adp-78, -0x1.2d3dbcbdcc45cp-80, 0x1.6ac8f8ca2ced5p-82, -0x1.e17be5227041ap-84,
     0x1.55b2c11544e5bp-85, -0x1.fe41437e6331cp-87, 0x1.8b11b5885d1d2p-88},
     /* [95] 1.875 <= y <= 2 2^-49, degree 10, 104.2 bits */
    {0x1.20c3d49855c6cp+0, 0x1.fac6e57d2057cp-54, -0x1.353272015ed8fp-46, 0x1.0583358c0d4c1p-70, -0x1.482bdff892921p-73,
     0x1.cf4cfcd59198dp-75, -0x1.b40c382e0361dp-76, 0x1.decc28e90e784p-77, -0x1.21b0be60b6e43p-77,
     0x1.76e49da0b1224p-78, -0x1.001d17a034b68p-78, 0x1.69ac4af717086p-79},
     /* [96] 1 <= y <= 1.125 2^-48, degree 10, 105.4 bits */
    {0x1.20c3d49855c63p+0, -0x1.570ead58ab93p-55, -0x1.353271c1cf506p-46, 0x1.eebb7788a037dp-71, -0x1.15be4d76a7415p-73,
     0x1.5ed56cd21c5cdp-75, -0x1.27705ad4abbd7p-76, 0x1.224178370a2c5p-77, -0x1.3a42a4a4d685p-78, 0x1.6be14e7fb5fp-79,
     -0x1.bc65fed827f5p-80, 0x1.18bc3e2b8064dp-80}, /* [97] 1.125 <= y <= 1.25 2^-48, degree 10, 103.9 bits */
    {0x1.20c3d49855c59p+0, 0x1.5c54e9cd03d9p-55, -0x1.3532718583e9ap-46, 0x1.d69599429cff1p-71, -0x1.de0d5182f52ccp-74,
     0x1.112c2c87bfcf5p-75, -0x1.a0434ed32be6dp-77, 0x1.7202f01b98b55p-78, -0x1.6a758383cad85p-79,
     0x1.7bb8034de929ep-80, -0x1.a344f35a418bdp-81, 0x1.df40a2710d0d4p-82},
     /* [98] 1.25 <= y <= 1.375 2^-48, degree 10, 103.5 bits */
    {0x1.20c3d49855c5p+0, -0x1.f823b82b3e129p-54, -0x1.3532714c07a1ap-46, 0x1.c1a8b58468f1bp-71, -0x1.a112c1d546a4bp-74,
     0x1.b334f35e3f0c7p-76, -0x1.2ec0a85c627e3p-77, 0x1.eb6ca885d2972p-79, -0x1.b788ae42d38bcp-80,
     0x1.a46c7060136f1p-81, -0x1.a79d737d357d6p-82, 0x1.ba19b2f83aa82p-83},
     /* [99] 1.375 <= y <= 1.5 2^-48, degree 10, 103.7 bits */
    {0x1.20c3d49855c46p+0, -0x1.3ce3bc6b024b9p-55, -0x1.35327114fe71cp-46, 0x1.af4c40683b47fp-71,
     -0x1.700a0a809aaf3p-74, 0x1.61514edf59cbdp-76, -0x1.c43f1bceb4f37p-78, 0x1.51ad6977ba31dp-79,
     -0x1.15dc1bc394899p-80, 0x1.e9087a7e7afccp-82, -0x1.c5227196a496p-83, 0x1.b310b1dbf9b6cp-84},
     /* [100] 1.5 <= y <= 1.625 2^-48, degree 10, 103.5 bits */
    {0x1.20c3d49855c3cp+0, 0x1.768004fc3b8bep-55, -0x1.353270e01e6c9p-46, 0x1.9f0441c41d4dp-71, -0x1.47e9b2a045308p-74,
     0x1.237a63698b998p-76, -0x1.59749a940bc9fp-78, 0x1.ddaab535172d8p-80, -0x1.6befaa3b994aap-81,
     0x1.288a6101bb428p-82, -0x1.fcab4165f467ep-84, 0x1.c4333c13aec93p-85},
     /* [101] 1.625 <= y <= 1.75 2^-48, degree 10, 104.8 bits */
    {0x1.20c3d49855c33p+0, -0x1.eb0e1651a04e4p-54, -0x1.353270ad2b1e7p-46, 0x1.90733c8e9791dp-71,
     -0x1.2695272ac0d5dp-74, 0x1.e795c0f25dfc2p-77, -0x1.0d032bb702798p-78, 0x1.5a5095bdcc666p-80,
     -0x1.eb52af813957dp-82, 0x1.74ba4c82e5e15p-83, -0x1.298d69bb3e831p-84, 0x1.ec8c33e2a66bp-86},
     /* [102] 1.75 <= y <= 1.875 2^-48, degree 10, 104.2 bits */
    {0x1.20c3d49855c29p+0, -0x1.22b851be2ebebp-55, -0x1.3532707bf258ap-46, 0x1.83512d9cd243bp-71,
     -0x1.0a8a1d59ef61dp-74, 0x1.9cb4ced980f36p-77, -0x1.aa04f5014ccacp-79, 0x1.00871ca1820ccp-80,
     -0x1.5475e976b8fe3p-82, 0x1.e33bfd47ef138p-84, -0x1.68ce0378f871fp-85, 0x1.175b29a861be3p-86},
     /* [103] 1.875 <= y <= 2 2^-48, degree 10, 104.5 bits */
    {0x1.20c3d49855c1ap+0, 0x1.752ec69741f2ap-54, -0x1.3532703500615p-45, 0x1.71d5cb13a8862p-69, -0x1.d01abf80d1136p-72,
     0x1.479a65efafaefp-73, -0x1.3455138a5d1ecp-74, 0x1.528f9c467d9ddp-75, -0x1.99af228b10423p-76,
     0x1.0916e3fe4eafdp-76, -0x1.6a330bf956acap-77, 0x1.ff7b9ff0c0483p-78},
     /* [104] 1 <= y <= 1.125 2^-47, degree 10, 102.9 bits */
    {0x1.20c3d49855c07p+0, 0x1.44962571fe02ep-57, -0x1.35326fdb1cebdp-45, 0x1.5dd440a664015p-69, -0x1.88c9daaf36e63p-72,
     0x1.f027601269f08p-74, -0x1.a1d04f4446d19p-75, 0x1.9a7bcf3160275p-76, -0x1.bc6e659a00291p-77,
     0x1.014d568dddb3bp-77, -0x1.3a3cb5e8c99e6p-78, 0x1.8d050c514bcc5p-79},
     /* [105] 1.125 <= y <= 1.25 2^-47, degree 10, 103.2 bits */
    {0x1.20c3d49855bf4p+0, -0x1.240927599adfcp-54, -0x1.35326f85d7ee9p-45, 0x1.4cc102cedc343p-69,
     -0x1.5208ac24aa911p-72, 0x1.825309c84d55ep-74, -0x1.2657a4b349cdap-75, 0x1.05a33c7064abbp-76,
     -0x1.004c1921b9e81p-77, 0x1.0c8072df6dcdep-78, -0x1.2877dc632b989p-79, 0x1.52e1f82938f16p-80},
     /* [106] 1.25 <= y <= 1.375 2^-47, degree 10, 103.3 bits */
    {0x1.20c3d49855bep+0, 0x1.8f5b016da1608p-54, -0x1.35326f348beecp-45, 0x1.3df51e109ec1dp-69, -0x1.26ea56704f4e4p-72,
     0x1.33bcdc590f127p-74, -0x1.ac28258e756dp-76, 0x1.5b7d5541996p-77, -0x1.36cc242320cbfp-78, 0x1.2948cda00bb3p-79,
     -0x1.2b8a848c9e6e9p-80, 0x1.389cb8e8ad7aap-81}, /* [107] 1.375 <= y <= 1.5 2^-47, degree 10, 102.3 bits */
    {0x1.20c3d49855bcdp+0, 0x1.0afcf85a6160ap-56, -0x1.35326ee6b6c73p-45, 0x1.30f9643f4b911p-69, -0x1.043e39de78897p-72,
     0x1.f3aaa6c4d6195p-75, -0x1.3fc95f050fbb5p-76, 0x1.dd8c485eeebf9p-78, -0x1.88f3ffb3936cp-79, 0x1.59cc74a00ad16p-80,
     -0x1.406a1e712df39p-81, 0x1.33a338532b8b7p-82}, /* [108] 1.5 <= y <= 1.625 2^-47, degree 10, 102.4 bits */
    {0x1.20c3d49855bbap+0, -0x1.09dc722ee5d22p-54, -0x1.35326e9befeb7p-45, 0x1.25762c7f1a06p-69, -0x1.cfbd29d4f6c17p-73,
     0x1.9c36591e20338p-75, -0x1.e88c415a5a3c4p-77, 0x1.51c2f034e38ffp-78, -0x1.01577df3ef306p-79,
     0x1.a35f26917d532p-81, -0x1.67aeec737ff36p-82, 0x1.3fc0f8f2680c4p-83},
     /* [109] 1.625 <= y <= 1.75 2^-47, degree 10, 102.4 bits */
    {0x1.20c3d49855ba6p+0, 0x1.a987efe49bab3p-54, -0x1.35326e53e1ddbp-45, 0x1.1b295b9936942p-69, -0x1.a09a5251ea289p-73,
     0x1.58c6517ca112fp-75, -0x1.7c70e543ffb77p-77, 0x1.e9c35ab815d6fp-79, -0x1.5b6af7aff46a2p-80,
     0x1.078eee2b1713dp-81, -0x1.a4cd7adb6307fp-83, 0x1.5c48a803b5048p-84},
     /* [110] 1.75 <= y <= 1.875 2^-47, degree 10, 105.1 bits */
    {0x1.20c3d49855b93p+0, 0x1.73b18eb0308c6p-56, -0x1.35326e0e45a5cp-45, 0x1.11e005eb95bdep-69, -0x1.78f1a084a9f3bp-73,
     0x1.23d3d35a1cc01p-75, -0x1.2d3dbfd86fa49p-77, 0x1.6ac8fbfe7276ep-79, -0x1.e17be8ea2208ap-81,
     0x1.55b2c3859613ap-82, -0x1.fe4146dacccfbp-84, 0x1.8b11b7f623a37p-85},
     /* [111] 1.875 <= y <= 2 2^-47, degree 10, 104.1 bits */
    {0x1.20c3d49855b76p+0, 0x1.a80cc51bb115cp-56, -0x1.35326da9f0b27p-44, 0x1.05837292bfa5fp-67, -0x1.482be69c76398p-70,
     0x1.cf4d03157374cp-72, -0x1.b40c3ce2a07d3p-73, 0x1.decc2d56cf39ep-74, -0x1.21b0c0c2766aep-74,
     0x1.76e4a06e0a3e1p-75, -0x1.001d19644c017p-75, 0x1.69ac4d4af90cfp-76},
     /* [112] 1 <= y <= 1.125 2^-46, degree 10, 101.3 bits */
    {0x1.20c3d49855b4fp+0, 0x1.d0cc7c61c2963p-54, -0x1.35326d2ad182dp-44, 0x1.eebbf0ff5a5d2p-68, -0x1.15be53679bbd3p-70,
     0x1.5ed571d2e76p-72, -0x1.27705e3384b8bp-73, 0x1.22417b0da5352p-74, -0x1.3a42a760213c8p-75, 0x1.6be1515fce48p-76,
     -0x1.bc66021592164p-77, 0x1.18bc40148aa1bp-77}, /* [113] 1.125 <= y <= 1.25 2^-46, degree 10, 102.1 bits */
    {0x1.20c3d49855b29p+0, -0x1.90d3f541d2603p-55, -0x1.35326cb23a97p-44, 0x1.d6961231c4693p-68, -0x1.de0d5c432a1cp-71,
     0x1.112c30a033085p-72, -0x1.a04353d147c36p-74, 0x1.7202f3e962765p-75, -0x1.6a7586d3b93ccp-76,
     0x1.7bb8067576e6cp-77, -0x1.a344f690fff02p-78, 0x1.df40a5ded279dp-79},
     /* [114] 1.25 <= y <= 1.375 2^-46, degree 10, 102.4 bits */
    {0x1.20c3d49855b02p+0, 0x1.3cbf926f78fedp-55, -0x1.35326c3f41e8ep-44, 0x1.c1a92df855543p-68, -0x1.a112cba6299f6p-71,
     0x1.b334fa3252dcfp-73, -0x1.2ec0ac293ae0ap-74, 0x1.eb6cadcf52a9ap-76, -0x1.b788b276ea1a1p-77,
     0x1.a46c7407cec97p-78, -0x1.a79d76e339873p-79, 0x1.ba19b647b0daep-80},
     /* [115] 1.375 <= y <= 1.5 2^-46, degree 10, 101.3 bits */
    {0x1.20c3d49855adcp+0, -0x1.fad63ab3a7641p-54, -0x1.35326bd12f6b2p-44, 0x1.af4cb86b34b74p-68,
     -0x1.700a138876484p-71, 0x1.615154a6ec158p-73, -0x1.c43f21b9cd1c6p-75, 0x1.51ad6d415c3ffp-76,
     -0x1.15dc1e88cf0b1p-77, 0x1.e9087eed410afp-79, -0x1.c5227560f50acp-80, 0x1.b310b5417fd8bp-81},
     /* [116] 1.5 <= y <= 1.625 2^-46, degree 10, 101.6 bits */
    {0x1.20c3d49855ab5p+0, -0x1.2818115fd89efp-55, -0x1.35326b676f42cp-44, 0x1.9f04b95ed6466p-68,
     -0x1.47e9bafce1ac4p-71, 0x1.237a685e09672p-73, -0x1.59749f46c954ep-75, 0x1.ddaabac68043cp-77,
     -0x1.6befae00f944p-78, 0x1.288a63ccd501fp-79, -0x1.fcab45d1f7712p-81, 0x1.c4333fbef2318p-82},
     /* [117] 1.625 <= y <= 1.75 2^-46, degree 10, 105.7 bits */
    {0x1.20c3d49855a8ep+0, 0x1.a57cba71eb72dp-55, -0x1.35326b018888ap-44, 0x1.9073b3c8840f3p-68, -0x1.26952ef3bd157p-71,
     0x1.e795c9897ad3ep-74, -0x1.0d032f81af426p-75, 0x1.5a5099ecd36c8p-77, -0x1.eb52b4c7e7b25p-79,
     0x1.74ba50266ab25p-80, -0x1.298d6c698a34p-81, 0x1.ec8c3806f8079p-83},
     /* [118] 1.75 <= y <= 1.875 2^-46, degree 10, 101.3 bits */
    {0x1.20c3d49855a68p+0, -0x1.c6770acbe13ep-54, -0x1.35326a9f16df3p-44, 0x1.8351a47c678a5p-68, -0x1.0a8a24a25db52p-71,
     0x1.9cb4d659ebdd8p-74, -0x1.aa04f6addd5d3p-76, 0x1.0087ee001033ap-77, -0x1.54b2b13a5d46bp-79,
     0x1.cdab5fdd619aap-81, -0x1.d173abfee26acp-84, 0x1.6255dccc6bef6p-78},
     /* [119] 1.875 <= y <= 2 2^-46, degree 10, 101.2 bits */
    {0x1.20c3d49855a2ep+0, -0x1.ac46cc7ea87a6p-54, -0x1.35326a1132c42p-43, 0x1.71d641761ca7fp-66,
     -0x1.d01accc8a0bc3p-69, 0x1.479a6c2fad1b1p-70, -0x1.3455183fa5e4fp-71, 0x1.528fa0b76cbdp-72, -0x1.99af275ad90ep-73,
     0x1.0916e6e0353b7p-73, -0x1.6a330fc088777p-74, 0x1.ff7ba547b0156p-75},
     /* [120] 1 <= y <= 1.125 2^-45, degree 10, 100.1 bits */
    {0x1.20c3d498559ep+0, 0x1.214f7d0761fddp-54, -0x1.3532695d6b9e2p-43, 0x1.5dd4b6722d47dp-66, -0x1.88c9e691254d2p-69,
     0x1.f0276a1406145p-71, -0x1.a1d056022b346p-72, 0x1.9a7bd4dfb78bdp-73, -0x1.bc6e6b153805fp-74,
     0x1.014d5975befc9p-74, -0x1.3a3cb93d53413p-75, 0x1.8d0510607c233p-76},
     /* [121] 1.125 <= y <= 1.25 2^-45, degree 10, 101.9 bits */
    {0x1.20c3d49855993p+0, -0x1.1198a691c123ap-58, -0x1.353268b2e168ep-43, 0x1.4cc1781312807p-66, -0x1.5208b6e4e4afp-69,
     0x1.825311f9341e6p-71, -0x1.2657a9b167158p-72, 0x1.05a3403e56c34p-73, -0x1.004c1c7278df6p-74,
     0x1.0c807609f9849p-75, -0x1.2877dfa2eff52p-76, 0x1.52e1fbae58a2fp-77},
     /* [122] 1.25 <= y <= 1.375 2^-45, degree 10, 100.5 bits */
    {0x1.20c3d49855946p+0, -0x1.4381eb60a87c8p-54, -0x1.35326810492eap-43, 0x1.3df592d999c89p-66, -0x1.26ea60413765p-69,
     0x1.33bce32d23f77p-71, -0x1.ac282d281e96bp-73, 0x1.5b7d5a8b1a16ep-74, -0x1.36cc285769165p-75, 0x1.2948d148d227p-76,
     -0x1.2b8a87f628283p-77, 0x1.389cbc417d865p-78}, /* [123] 1.375 <= y <= 1.5 2^-45, degree 10, 102.2 bits */
    {0x1.20c3d498558f8p+0, 0x1.8a1652b5db397p-54, -0x1.353267749ea55p-43, 0x1.30f9d89753687p-66, -0x1.043e42e65909cp-69,
     0x1.f3aab253ff06ep-72, -0x1.3fc964f021bc6p-73, 0x1.dd8c4ff229f77p-75, -0x1.88f4053df9a4ep-76,
     0x1.59cc790f07e5ep-77, -0x1.406a223cb7334p-78, 0x1.33a33bbc63e8p-79},
     /* [124] 1.5 <= y <= 1.625 2^-45, degree 10, 100.8 bits */
    {0x1.20c3d498558abp+0, 0x1.5ebca563c031p-56, -0x1.353266df10b3cp-43, 0x1.2576a06ee12e8p-66, -0x1.cfbd3a8e38df6p-70,
     0x1.9c36630721e6ep-72, -0x1.e88c4abfcacbap-74, 0x1.51c2f5c64c286p-75, -0x1.015781b93d36p-76, 0x1.a35f2c278e488p-78,
     -0x1.67aef0dfbbc43p-79, 0x1.3fc0fc9ef0d34p-80}, /* [125] 1.625 <= y <= 1.75 2^-45, degree 10, 101.2 bits */
    {0x1.20c3d4985585ep+0, -0x1.b56eda7787d83p-55, -0x1.3532664ef45e5p-43, 0x1.1b29cf28310c3p-66,
     -0x1.a09a61e3eaf0cp-70, 0x1.58c65a13c5b54p-72, -0x1.7c70ecd94dbb7p-74, 0x1.e9c363162e6f6p-76,
     -0x1.5b6afcf691c4bp-77, 0x1.078ef1ce7a05dp-78, -0x1.a4cd8037c461ap-80, 0x1.5c48ac2838c37p-81},
     /* [126] 1.75 <= y <= 1.875 2^-45, degree 10, 100.7 bits */
    {0x1.20c3d4985581p+0, 0x1.f2e289cf39b81p-54, -0x1.353265c3bbb4dp-43, 0x1.11e0792038d05p-66, -0x1.78f1af15824e8p-70,
     0x1.23d3dadea63adp-72, -0x1.2d3dc60dba49p-74, 0x1.6ac90266febd4p-76, -0x1.e17bf079760d4p-78, 0x1.55b2c86616c4cp-79,
     -0x1.fe414d9345e9dp-81, 0x1.8b11bcd16e4ap-82}, /* [127] 1.875 <= y <= 2 2^-45, degree 10, 100.7 bits */
    {0x1.20c3d4985579dp+0, -0x1.d8b5842222696p-54, -0x1.353264fb1177ep-42, 0x1.0583e54a413dp-64, -0x1.482bf3e44bc48p-67,
     0x1.cf4d0f953ea0bp-69, -0x1.b40c464be0fc1p-70, 0x1.decc3632579ecp-71, -0x1.21b0c585f43dcp-71,
     0x1.76e4a608ab572p-72, -0x1.001d1cec58f01p-72, 0x1.69ac51f266a2cp-73},
     /* [128] 1 <= y <= 1.125 2^-44, degree 10, 103.7 bits */
    {0x1.20c3d49855702p+0, -0x1.ebf3cd591be63p-57, -0x1.353263fcd2a64p-42, 0x1.eebcd54107232p-65,
     -0x1.15be5f49921dap-67, 0x1.5ed57bd4834a6p-69, -0x1.277064f13a76ep-70, 0x1.224180bae15a7p-71,
     -0x1.3a42acd6ba0dp-72, 0x1.6be1571fff5d3p-73, -0x1.bc66089053df8p-74, 0x1.18bc43e679872p-74},
     /* [129] 1.125 <= y <= 1.25 2^-44, degree 10, 100.0 bits */
    {0x1.20c3d49855667p+0, 0x1.5dba7fe0aefbcp-54, -0x1.3532630ba45ccp-42, 0x1.d696f5644a7f4p-65, -0x1.de0d71c3ad71ap-68,
     0x1.112c38d11e84p-69, -0x1.a0435dcd82fd7p-71, 0x1.7202fb84ffa65p-72, -0x1.6a758d739a328p-73, 0x1.7bb80cc4985ddp-74,
     -0x1.a344fcfe80bb2p-75, 0x1.df40acba4d53fp-76}, /* [130] 1.25 <= y <= 1.375 2^-44, degree 10, 101.4 bits */
    {0x1.20c3d498555cdp+0, -0x1.070aafb80fa93p-54, -0x1.35326225b28f4p-42, 0x1.c1aa10346430dp-65,
     -0x1.a112df4807d53p-68, 0x1.b33507da8402ap-70, -0x1.2ec0b3c2ebca7p-71, 0x1.eb6cb86263993p-73,
     -0x1.b788badf1b296p-74, 0x1.a46c7b574afb3p-75, -0x1.a79d7daf4c614p-76, 0x1.ba19bce6a5febp-77},
     /* [131] 1.375 <= y <= 1.5 2^-44, degree 10, 99.8 bits */
    {0x1.20c3d49855532p+0, 0x1.2863c51f8eb0dp-55, -0x1.353261498d22cp-42, 0x1.af4d99c55c919p-65, -0x1.700a25984485dp-68,
     0x1.615160361a9c2p-70, -0x1.c43f2d8ff7b0dp-72, 0x1.51ad74d4afd5ap-73, -0x1.15dc2413467eep-74,
     0x1.e90887cacf5acp-76, -0x1.c5227cf59fdd1p-77, 0x1.b310bc0c9c216p-78},
     /* [132] 1.5 <= y <= 1.625 2^-44, degree 10, 100.6 bits */
    {0x1.20c3d49855498p+0, -0x1.d08fdbae888a6p-54, -0x1.353260760c619p-42, 0x1.9f0599e87c282p-65,
     -0x1.47e9cbb6305d8p-68, 0x1.237a7247104ccp-70, -0x1.5974a8ac39113p-72, 0x1.ddaac5e96f55ap-74,
     -0x1.6befb58bbdfb2p-75, 0x1.288a696307703p-76, -0x1.fcab4eaa02d1bp-78, 0x1.c4334715882e5p-79},
     /* [133] 1.625 <= y <= 1.75 2^-44, degree 10, 103.2 bits */
    {0x1.20c3d498553fdp+0, -0x1.aa7fd61601fe9p-57, -0x1.35325faa3e7d5p-42, 0x1.907493908ffd3p-65,
     -0x1.26953e85c9c49p-68, 0x1.e795dab7cf77ap-71, -0x1.0d033716f843fp-72, 0x1.5a50a24afc21dp-74,
     -0x1.eb52bf554f632p-76, 0x1.74ba576d71366p-77, -0x1.298d71c620e48p-78, 0x1.ec8c404fa5a8fp-80},
     /* [134] 1.75 <= y <= 1.875 2^-44, degree 10, 99.8 bits */
    {0x1.20c3d49855362p+0, 0x1.65f176bc1fd16p-54, -0x1.35325ee55ababp-42, 0x1.8352838fc4227p-65, -0x1.0a8a33333b73fp-68,
     0x1.9cb4e56720f05p-71, -0x1.aa0507a12c23dp-73, 0x1.0087263e56427p-74, -0x1.5475f4cdcf9c3p-76, 0x1.e33c0be9d9d6p-78,
     -0x1.68ce0d8e3b8b5p-79, 0x1.175b30f1be387p-80}, /* [135] 1.875 <= y <= 2 2^-44, degree 10, 99.9 bits */
    {0x1.20c3d4985527ap+0, 0x1.ced6739febb23p-54, -0x1.35325dc991dd8p-41, 0x1.71d71f8f356dfp-63, -0x1.d01ae758601a4p-66,
     0x1.479a78af641f9p-67, -0x1.345521a83da13p-68, 0x1.528fa98fc6888p-69, -0x1.99af30d58e89fp-70,
     0x1.0916ec665ad1dp-70, -0x1.6a331691e5aaap-71, 0x1.ff7bade815f64p-72},
     /* [136] 1 <= y <= 1.125 2^-43, degree 10, 98.3 bits */
    {0x1.20c3d49855145p+0, 0x1.05622320a57cp-54, -0x1.35325c6202b41p-41, 0x1.5dd5935deea5bp-63, -0x1.88c9fe5527842p-66,
     0x1.f0277e1744c25p-68, -0x1.a1d0637d6a42p-69, 0x1.9a7be0390eda2p-70, -0x1.bc6e75fdc2239p-71, 0x1.014d5f2e26bd9p-71,
     -0x1.3a3cbfa108f5ep-72, 0x1.8d0517c78c489p-73}, /* [137] 1.125 <= y <= 1.25 2^-43, degree 10, 99.7 bits */
    {0x1.20c3d4985501p+0, 0x1.df9a578475eb5p-57, -0x1.35325b0ced6d3p-41, 0x1.4cc253efac33fp-63, -0x1.5208cc657c39dp-66,
     0x1.8253225b15e5ep-68, -0x1.2657b3ada664dp-69, 0x1.05a347d9cdaaep-70, -0x1.004c231186e5ap-71,
     0x1.0c807c56169c1p-72, -0x1.2877e60766e9p-73, 0x1.52e202728a3e3p-74},
     /* [138] 1.25 <= y <= 1.375 2^-43, degree 10, 98.2 bits */
    {0x1.20c3d49854edbp+0, -0x1.1aecb2e916b18p-55, -0x1.353259c7bc1d6p-41, 0x1.3df66dbfbb57cp-63, -0x1.26ea73e32898p-66,
     0x1.33bcf0d55d998p-68, -0x1.ac283c5b91406p-70, 0x1.5b7d651e2f62ap-71, -0x1.36cc30bf687eep-72,
     0x1.2948d8973d046p-73, -0x1.2b8a8ebeaa2c4p-74, 0x1.389cc2d710891p-75},
     /* [139] 1.375 <= y <= 1.5 2^-43, degree 10, 98.4 bits */
    {0x1.20c3d49854da6p+0, -0x1.56db0565b8cdap-54, -0x1.3532589066305p-41, 0x1.30fab29b8d174p-63,
     -0x1.043e54f6395cap-66, 0x1.f3aac9726842ep-69, -0x1.3fc970c659e6p-70, 0x1.dd8c5f18e2ff2p-72,
     -0x1.88f41052fb227p-73, 0x1.59cc81ec5c083p-74, -0x1.406a29d01e443p-75, 0x1.33a34283be1edp-76},
     /* [140] 1.5 <= y <= 1.625 2^-43, degree 10, 99.2 bits */
    {0x1.20c3d49854c7p+0, 0x1.dfc513110abbp-54, -0x1.3532576549739p-41, 0x1.257779a2980fbp-63, -0x1.cfbd5c00f925fp-67,
     0x1.9c3676d9380f8p-69, -0x1.e88c5d8ac09ebp-71, 0x1.51c300e942dc4p-72, -0x1.01578944181d6p-73,
     0x1.a35f3754171c8p-75, -0x1.67aef9b786f5ap-76, 0x1.3fc103f431f56p-77},
     /* [141] 1.625 <= y <= 1.75 2^-43, degree 10, 101.0 bits */
    {0x1.20c3d49854b3bp+0, 0x1.1669c1ccecbe7p-54, -0x1.353256450fefep-41, 0x1.1b2aa79a4d2b1p-63, -0x1.a09a8108265d7p-67,
     0x1.58c66b421f5bep-69, -0x1.7c70fc03f4c7dp-71, 0x1.e9c373d280254p-73, -0x1.5b6b0784118c6p-74,
     0x1.078ef915a5ee2p-75, -0x1.a4cd8af12598ap-77, 0x1.5c48b470a897fp-78},
     /* [142] 1.75 <= y <= 1.875 2^-43, degree 10, 103.0 bits */
    {0x1.20c3d49854a06p+0, 0x1.344b7626f5ca3p-56, -0x1.3532552e9dc4bp-41, 0x1.11e150dda4cecp-63, -0x1.78f1cc376aebdp-67,
     0x1.23d3e9e7c8343p-69, -0x1.2d3dd27856b4ep-71, 0x1.6ac90f382303ep-73, -0x1.e17bff9859e29p-75,
     0x1.55b2d22787a8ep-76, -0x1.fe415b055710ep-78, 0x1.8b11c688d65a3p-79},
     /* [143] 1.875 <= y <= 2 2^-43, degree 10, 99.1 bits */
    {0x1.20c3d49854836p+0, 0x1.1f18831c83011p-54, -0x1.3532539d4808p-40, 0x1.0584bc0d6859ap-61, -0x1.482c0e742c155p-64,
     0x1.cf4d2894f01e7p-66, -0x1.b40c591e6d332p-67, 0x1.decc47e96bdcbp-68, -0x1.21b0cf0cfb023p-68,
     0x1.76e4b13e2babcp-69, -0x1.001d23fce0626p-69, 0x1.69ac5b4251358p-70},
     /* [144] 1 <= y <= 1.125 2^-42, degree 10, 99.1 bits */
    {0x1.20c3d498545ccp+0, -0x1.cdf189365319cp-56, -0x1.353251a0c8b86p-40, 0x1.eebe806ca3b5cp-62,
     -0x1.15be770db0eb7p-64, 0x1.5ed58fd7d2ddcp-66, -0x1.2770726cb09ffp-67, 0x1.22418c155aca5p-68,
     -0x1.3a42b7c3e94fap-69, 0x1.6be162a069076p-70, -0x1.bc6615861d335p-71, 0x1.18bc4b8ad2334p-71},
     /* [145] 1.125 <= y <= 1.25 2^-42, degree 10, 97.6 bits */
    {0x1.20c3d49854361p+0, 0x1.f9fe30fc49562p-54, -0x1.35324fbe6a7b6p-40, 0x1.d6989e719522cp-62, -0x1.de0d9cc512b02p-65,
     0x1.112c493309fbp-66, -0x1.a04371c60d838p-68, 0x1.72030abc3e5c6p-69, -0x1.6a759ab3597f6p-70, 0x1.7bb81962d015fp-71,
     -0x1.a34509d981ed2p-72, 0x1.df40ba718439ep-73}, /* [146] 1.25 <= y <= 1.375 2^-42, degree 10, 97.4 bits */
    {0x1.20c3d498540f7p+0, 0x1.9e1decbb9c498p-56, -0x1.35324df285384p-40, 0x1.c1abb754bc0fbp-62, -0x1.a113068c1e15cp-65,
     0x1.b335232b094b8p-67, -0x1.2ec0c2f65ffcep-68, 0x1.eb6ccd888e464p-70, -0x1.b788cbaf80ee2p-71,
     0x1.a46c89f63800bp-72, -0x1.a79d8b475a9bdp-73, 0x1.ba19ca248485bp-74},
     /* [147] 1.375 <= y <= 1.5 2^-42, degree 10, 97.3 bits */
    {0x1.20c3d49853e8dp+0, -0x1.2ae12b8c94deep-54, -0x1.35324c3a38b9p-40, 0x1.af4f3f21e24eep-62, -0x1.700a49b836cf6p-65,
     0x1.6151775495264p-67, -0x1.c43f453c6eb3dp-69, 0x1.51ad83fb5d663p-70, -0x1.15dc2f283beabp-71,
     0x1.e9089985e9848p-73, -0x1.c5228c1edd80bp-74, 0x1.b310c9a2b05c9p-75},
     /* [148] 1.5 <= y <= 1.625 2^-42, degree 10, 99.0 bits */
    {0x1.20c3d49853c22p+0, 0x1.42c3a993e307cp-54, -0x1.35324a9335922p-40, 0x1.9f073da3fa034p-62, -0x1.47e9ed292031cp-65,
     0x1.237a861936739p-67, -0x1.5974bb7738866p-69, 0x1.ddaadc2f54addp-71, -0x1.6befc4a1533e3p-72,
     0x1.288a748f71f6fp-73, -0x1.fcab605a0bbdep-75, 0x1.c43355c28f36cp-76},
     /* [149] 1.625 <= y <= 1.75 2^-42, degree 10, 98.8 bits */
    {0x1.20c3d498539b8p+0, -0x1.3e2a1fb716da8p-56, -0x1.353248fb9826ap-40, 0x1.907635c8d624ap-62,
     -0x1.26955daa32d81p-65, 0x1.e795fd149fa11p-68, -0x1.0d034641a95afp-69, 0x1.5a50b3075049cp-71,
     -0x1.eb52d4702fb53p-73, 0x1.74ba65fb8c6f8p-74, -0x1.298d7c7f4f4e2p-75, 0x1.ec8c50e0e662bp-77},
     /* [150] 1.75 <= y <= 1.875 2^-42, degree 10, 98.4 bits */
    {0x1.20c3d4985374ep+0, -0x1.e1cc34c99e6cep-54, -0x1.35324771cefffp-40, 0x1.8354245ea7ef9p-62,
     -0x1.0a8a50555002cp-65, 0x1.9cb503797ebb8p-68, -0x1.aa052076773abp-70, 0x1.0087330f810e2p-71,
     -0x1.547603ecaaeffp-73, 0x1.e33c1f6c7d677p-75, -0x1.68ce1afff22d3p-76, 0x1.175b3aa8e013p-77},
     /* [151] 1.875 <= y <= 2 2^-42, degree 10, 99.8 bits */
    {0x1.20c3d498533aep+0, -0x1.e8c11678e302p-57, -0x1.3532453a3ad5ep-39, 0x1.71d8be698c755p-60, -0x1.d01b1c787425cp-63,
     0x1.479a91af2ba46p-64, -0x1.3455347ad82b3p-65, 0x1.528fbb46e84dp-66, -0x1.99af43e3a3fap-67, 0x1.0916f79bce905p-67,
     -0x1.6a3324b2b3bc8p-68, 0x1.ff7bc0873c626p-69}, /* [152] 1 <= y <= 1.125 2^-41, degree 10, 96.6 bits */
    {0x1.20c3d49852ed9p+0, 0x1.3d55cfbdcbd25p-55, -0x1.3532426b1947ap-39, 0x1.5dd72fdd903c5p-60, -0x1.88ca2dddb3878p-63,
     0x1.f027a61e086ebp-65, -0x1.a1d07e746ab5fp-66, 0x1.9a7bf6ee13df9p-67, -0x1.bc6e8bd834889p-68,
     0x1.014d6aae97018p-68, -0x1.3a3ccc96c4614p-69, 0x1.8d05270ff4fc1p-70},
     /* [153] 1.125 <= y <= 1.25 2^-41, degree 10, 97.7 bits */
    {0x1.20c3d49852a04p+0, 0x1.7a99b539f483cp-54, -0x1.35323fc0eb82fp-39, 0x1.4cc3ee50f8489p-60, -0x1.5208f7672ba9dp-63,
     0x1.8253431f0bf7cp-65, -0x1.2657c7a63fab2p-66, 0x1.05a3571117806p-67, -0x1.004c3051526a5p-68,
     0x1.0c8088f45c7a7p-69, -0x1.2877f2e27233bp-70, 0x1.52e21029b55bcp-71},
     /* [154] 1.25 <= y <= 1.375 2^-41, degree 10, 96.4 bits */
    {0x1.20c3d4985253p+0, -0x1.a94ddedfcaf17p-54, -0x1.35323d3685b09p-39, 0x1.3df806341143cp-60, -0x1.26ea9b2785692p-63,
     0x1.33bd0c25fdf9ep-65, -0x1.ac285ac29077p-67, 0x1.5b7d7a4468432p-68, -0x1.36cc418fdba03p-69, 0x1.2948e7363a49fp-70,
     -0x1.2b8a9c56cb1cfp-71, 0x1.389cd014fd1bap-72}, /* [155] 1.375 <= y <= 1.5 2^-41, degree 10, 96.6 bits */
    {0x1.20c3d4985205bp+0, -0x1.9a1b5e4e2cc7cp-55, -0x1.35323ac7d6a75p-39, 0x1.30fc494c0da64p-60,
     -0x1.043e79166f08ep-63, 0x1.f3aaf7af8d202p-66, -0x1.3fc98872e34f7p-67, 0x1.dd8c7d6651b72p-69,
     -0x1.88f4267cf4e07p-70, 0x1.59cc93a78699cp-71, -0x1.406a38f970671p-72, 0x1.33a35019e9085p-73},
     /* [156] 1.5 <= y <= 1.625 2^-41, degree 10, 98.6 bits */
    {0x1.20c3d49851b86p+0, 0x1.eb14807f9047ap-59, -0x1.353238719a022p-39, 0x1.25790eb20da53p-60, -0x1.cfbd9ee759f0fp-64,
     0x1.9c369e7daeeacp-66, -0x1.e88c8320de05ap-68, 0x1.51c3172f36b74p-69, -0x1.01579859b65f3p-70,
     0x1.a35f4dacfc943p-72, -0x1.67af0b67a396ep-73, 0x1.3fc112a150ea1p-74},
     /* [157] 1.625 <= y <= 1.75 2^-41, degree 10, 97.1 bits */
    {0x1.20c3d498516b1p+0, 0x1.d7c753154af8ep-55, -0x1.3532363123d22p-39, 0x1.1b2c3b2688157p-60, -0x1.a09abf51749d5p-64,
     0x1.58c68d9f15b38p-66, -0x1.7c711a5970a5ap-68, 0x1.e9c3954b3f115p-70, -0x1.5b6b1c9efdd3cp-71,
     0x1.078f07a3c9d77p-72, -0x1.a4cda06394c6fp-74, 0x1.5c48c501ffa55p-75},
     /* [158] 1.75 <= y <= 1.875 2^-41, degree 10, 96.2 bits */
    {0x1.20c3d498511dcp+0, 0x1.c892174b35c8dp-54, -0x1.353234043c562p-39, 0x1.11e2e3007a841p-60, -0x1.78f2067c0b995p-64,
     0x1.23d407fa4878ep-66, -0x1.2d3deb4db7ae9p-68, 0x1.6ac928da8ac74p-70, -0x1.e17c1dd621cccp-72,
     0x1.55b2e5aa355d2p-73, -0x1.fe4175e8d5d55p-75, 0x1.8b11d9f72e033p-76},
     /* [159] 1.875 <= y <= 2 2^-41, degree 10, 97.1 bits */
    {0x1.20c3d49850a9dp+0, 0x1.13d79c06a580dp-54, -0x1.353230e18c295p-38, 0x1.05864c3bad30ep-58, -0x1.482c4394b1ac3p-61,
     0x1.cf4d5a94baee8p-63, -0x1.b40c7ec3c538ep-64, 0x1.decc6b57ca6fp-65, -0x1.21b0e21b1c1eap-65, 0x1.76e4c7a91e2a3p-66,
     -0x1.001d321db5294p-66, 0x1.69ac6de183bdep-67}, /* [160] 1 <= y <= 1.125 2^-40, degree 10, 97.1 bits */
    {0x1.20c3d498500f4p+0, -0x1.32046e696a891p-54, -0x1.35322ce8874e3p-38, 0x1.eec19c13b8323p-59,
     -0x1.15bea696a7a0bp-61, 0x1.5ed5b7dec8ccdp-63, -0x1.27708d63cb8a3p-64, 0x1.2241a2ca729cep-65,
     -0x1.3a42cd9e6ac81p-66, 0x1.6be179a1560cap-67, -0x1.bc662f719ef26p-68, 0x1.18bc5ad340f4ap-68},
     /* [161] 1.125 <= y <= 1.25 2^-40, degree 10, 96.0 bits */
    {0x1.20c3d4984f74ap+0, 0x1.11369b1a41a92p-55, -0x1.35322923c4a11p-38, 0x1.d69bb5dbf4e21p-59, -0x1.de0df2c93b564p-62,
     0x1.112c69f72b06dp-63, -0x1.a04399b7690ep-65, 0x1.7203292aeccap-66, -0x1.6a75b53304b38p-67, 0x1.7bb8329f6ba73p-68,
     -0x1.a345238fa4c8fp-69, 0x1.df40d5dfe426cp-70}, /* [162] 1.25 <= y <= 1.375 2^-40, degree 10, 96.1 bits */
    {0x1.20c3d4984eda1p+0, -0x1.bc4f3e707a2b2p-54, -0x1.3532258bf3efep-38, 0x1.c1aecae52645fp-59,
     -0x1.a1135515977d2p-62, 0x1.b33559cc949ap-64, -0x1.2ec0e15d7f9e1p-65, 0x1.eb6cf7d526eaep-67,
     -0x1.b788ed5082a77p-68, 0x1.a46ca73447366p-69, -0x1.a79da677abf0dp-70, 0x1.ba19e4a068ab6p-71},
     /* [163] 1.375 <= y <= 1.5 2^-40, degree 10, 95.3 bits */
    {0x1.20c3d4984e3f7p+0, -0x1.92a233f98ca1fp-63, -0x1.3532221b54cdfp-38, 0x1.af524f2a99037p-59, -0x1.700a91f95932p-62,
     0x1.6151a591fb783p-64, -0x1.c43f7495b5c5ep-66, 0x1.51ada248e8f7cp-67, -0x1.15dc455248ac2p-68,
     0x1.e908bcfc59f31p-70, -0x1.c522aa7195ad4p-71, 0x1.b310e4cf141a9p-72},
     /* [164] 1.5 <= y <= 1.625 2^-40, degree 10, 96.7 bits */
    {0x1.20c3d4984da4dp+0, 0x1.bb287be022fd5p-54, -0x1.35321ecd48636p-38, 0x1.9f0a4a6a925f7p-59, -0x1.47ea301030529p-62,
     0x1.237aadbde75eep-64, -0x1.5974e10d80bedp-66, 0x1.ddab08bb68126p-68, -0x1.6befe2ccaa90ep-69,
     0x1.288a8ae869a9fp-70, -0x1.fcab83ba5ec18p-72, 0x1.c433731cdef86p-73},
     /* [165] 1.625 <= y <= 1.75 2^-40, degree 10, 98.8 bits */
    {0x1.20c3d4984d0a4p+0, -0x1.10fbd6e71f075p-55, -0x1.35321b9e0775ep-38, 0x1.90793f88f11c7p-59,
     -0x1.26959bf429906p-62, 0x1.e79641cef43bap-65, -0x1.0d03649748d61p-66, 0x1.5a50d48030eb6p-68,
     -0x1.eb52fea62eccfp-70, 0x1.74ba8317ecf72p-71, -0x1.298d91f1cf3f2p-72, 0x1.ec8c7203ab4cp-74},
     /* [166] 1.75 <= y <= 1.875 2^-40, degree 10, 100.0 bits */
    {0x1.20c3d4984c6fap+0, 0x1.343fd329af565p-54, -0x1.3532188a6f17ep-38, 0x1.83572b4bf0bd5p-59, -0x1.0a8a8a9a92fe1p-62,
     0x1.9cb53f9edcf87p-65, -0x1.aa0552217531dp-67, 0x1.00874cb2034b5p-68, -0x1.5476222a8f16dp-70,
     0x1.e33c4671fadbfp-72, -0x1.68ce35e386f9ep-73, 0x1.175b4e17464ep-74},
     /* [167] 1.875 <= y <= 2 2^-40, degree 10, 98.0 bits */
    {0x1.20c3d4984b87cp+0, -0x1.7f771ae96eabp-57, -0x1.3532141b3db4ep-37, 0x1.71dbc16da868bp-57, -0x1.d01b86bab3956p-60,
     0x1.479ac3af47a7p-61, -0x1.34555a205f92fp-62, 0x1.528fdeb56cd34p-63, -0x1.99af6a000adf7p-64, 0x1.09170e06d5337p-64,
     -0x1.6a3340f475756p-65, 0x1.ff7be5c5bfa48p-66}, /* [168] 1 <= y <= 1.125 2^-39, degree 10, 95.8 bits */
    {0x1.20c3d4984a529p+0, -0x1.68807cdd67458p-55, -0x1.35320e7cee96p-37, 0x1.5dda2e2c28fdap-57, -0x1.88ca8cf0c2962p-60,
     0x1.f027f62c7cfa6p-62, -0x1.a1d0b462e7eabp-63, 0x1.9a7c2458767fdp-64, -0x1.bc6eb78d63323p-65,
     0x1.014d81af9956cp-65, -0x1.3a3ce6825d04fp-66, 0x1.8d0545a0ec971p-67},
     /* [169] 1.125 <= y <= 1.25 2^-39, degree 10, 94.8 bits */
    {0x1.20c3d498491d6p+0, -0x1.373381197e461p-54, -0x1.35320928871cp-37, 0x1.4cc6e862cf1a4p-57, -0x1.52094d6c66262p-60,
     0x1.825384a7c3166p-62, -0x1.2657ef97d28c3p-63, 0x1.05a3757fe9a6fp-64, -0x1.004c4ad1192eep-65,
     0x1.0c80a23110228p-66, -0x1.28780c98ac47ep-67, 0x1.52e22b982d444p-68},
     /* [170] 1.25 <= y <= 1.375 2^-39, degree 10, 94.4 bits */
    {0x1.20c3d49847e83p+0, -0x1.b8d9cc709f5cp-54, -0x1.35320413af96cp-37, 0x1.3dfafc6be609fp-57, -0x1.26eae9b20305fp-60,
     0x1.33bd42c7eee5cp-62, -0x1.ac289791278d3p-64, 0x1.5b7da49134af2p-65, -0x1.36cc633101b96p-66,
     0x1.29490474664fep-67, -0x1.2b8ab787358cbp-68, 0x1.389cea90f8c4ap-69},
     /* [171] 1.375 <= y <= 1.5 2^-39, degree 10, 94.1 bits */
    {0x1.20c3d49846b2fp+0, 0x1.c6be09c21e4f8p-54, -0x1.3531ff3645b29p-37, 0x1.30ff3bfc23015p-57, -0x1.043ec15889b9dp-60,
     0x1.f3ab542b0c4cfp-63, -0x1.3fc9b7cc716c9p-64, 0x1.dd8cba01b5fd7p-66, -0x1.88f452d140322p-67,
     0x1.59ccb71e1b298p-68, -0x1.406a574c4549p-69, 0x1.33a36b466547dp-70},
     /* [172] 1.5 <= y <= 1.625 2^-39, degree 10, 98.6 bits */
    {0x1.20c3d498457dcp+0, 0x1.4786fe7a849e8p-54, -0x1.3531fa89c0a4p-37, 0x1.257bfe1ff9449p-57, -0x1.cfbe24b755cacp-61,
     0x1.9c36edc7af277p-63, -0x1.e88cce4de343bp-65, 0x1.51c343bb84e39p-66, -0x1.0157b68530d94p-67,
     0x1.a35f7a5f1b161p-69, -0x1.67af2ec8190afp-70, 0x1.3fc12ffbbba66p-71},
     /* [173] 1.625 <= y <= 1.75 2^-39, degree 10, 96.1 bits */
    {0x1.20c3d49844489p+0, 0x1.92eb11fe1cdfcp-55, -0x1.3531f608c88c8p-37, 0x1.1b2f278deb64p-57, -0x1.a09b3be72aecp-61,
     0x1.58c6d259f8097p-63, -0x1.7c71570510f5bp-65, 0x1.e9c3d83d5ba7dp-67, -0x1.5b6b46d52fd1cp-68,
     0x1.078f24c04a199p-69, -0x1.a4cdcb48bfad5p-71, 0x1.5c48e624e3b5ep-72},
     /* [174] 1.75 <= y <= 1.875 2^-39, degree 10, 95.6 bits */
    {0x1.20c3d49843136p+0, 0x1.31fd60fcfa0a7p-56, -0x1.3531f1aeede89p-37, 0x1.11e5cc950126bp-57, -0x1.78f27b08499cap-61,
     0x1.23d444202677bp-63, -0x1.2d3e1cf907c3cp-65, 0x1.6ac95c1fd7637p-67, -0x1.e17c5a523569p-69, 0x1.55b30cafdebefp-70,
     -0x1.fe41abb03706ap-72, 0x1.8b1200d41ff33p-73}, /* [175] 1.875 <= y <= 2 2^-39, degree 10, 96.7 bits */
    {0x1.20c3d49841439p+0, 0x1.930d156968cedp-54, -0x1.3531eb697c216p-36, 0x1.058931e6f7e76p-55, -0x1.482cadd892defp-58,
     0x1.cf4dbe95d03d9p-60, -0x1.b40cca0f55bfcp-61, 0x1.deccb2353b7aap-62, -0x1.21b10837b49a2p-62,
     0x1.76e4f47f60422p-63, -0x1.001d4e5f956bep-63, 0x1.69ac93202c657p-64},
     /* [176] 1 <= y <= 1.125 2^-38, degree 10, 93.4 bits */
    {0x1.20c3d4983ed93p+0, 0x1.3eb32b9354a23p-55, -0x1.3531e3775b50ep-36, 0x1.eec75dff2149dp-56, -0x1.15bf05ab3f16fp-58,
     0x1.5ed607edf7719p-60, -0x1.2770c352aa5b6p-61, 0x1.2241d0351b4fbp-62, -0x1.3a42f953d559p-63, 0x1.6be1a7a393f24p-64,
     -0x1.bc6663490b7a7p-65, 0x1.18bc796458fb1p-65}, /* [177] 1.125 <= y <= 1.25 2^-38, degree 10, 95.1 bits */
    {0x1.20c3d4983c6edp+0, -0x1.41eeac74e801ap-56, -0x1.3531dbedbf004p-36, 0x1.d6a16f4db659ap-56,
     -0x1.de0e9ed69617dp-59, 0x1.112cab808163ap-60, -0x1.a043e99b25f1cp-62, 0x1.72036608f3461p-63,
     -0x1.6a75ea32de45ap-64, 0x1.7bb8651914d4fp-65, -0x1.a34556fc56bf4p-66, 0x1.df410cbd113bap-67},
     /* [178] 1.25 <= y <= 1.375 2^-38, degree 10, 97.3 bits */
    {0x1.20c3d4983a047p+0, -0x1.3ca320324ce54p-54, -0x1.3531d4be06c7cp-36, 0x1.c1b47ca2c1c4dp-56,
     -0x1.a113f22d536b3p-59, 0x1.b335c7118ade7p-61, -0x1.2ec11e2c8e757p-62, 0x1.eb6d4c6f4dd19p-64,
     -0x1.b7893093335ccp-65, 0x1.a46ce1b0eee1cp-66, -0x1.a79ddcd8c5268p-67, 0x1.ba1a19989df77p-68},
     /* [179] 1.375 <= y <= 1.5 2^-38, degree 10, 94.2 bits */
    {0x1.20c3d498379ap+0, 0x1.dab940bcf9ec7p-54, -0x1.3531cddcb1cb3p-36, 0x1.af57f9d8956a1p-56, -0x1.700b22802ee85p-59,
     0x1.6152020e6d6aap-61, -0x1.c43fd34993834p-63, 0x1.51addee4b6cfdp-64, -0x1.15dc71a6d8b9fp-65,
     0x1.e90903e9e75d8p-67, -0x1.c522e7178ebebp-68, 0x1.b3111b284ee7cp-69},
     /* [180] 1.5 <= y <= 1.625 2^-38, degree 10, 93.8 bits */
    {0x1.20c3d498352fap+0, 0x1.eae9543d8da87p-55, -0x1.3531c74082589p-36, 0x1.9f0fee941c799p-56, -0x1.47eab5e2afed2p-59,
     0x1.237afd08bef7ap-61, -0x1.59752c3b24eedp-63, 0x1.ddab61d4a4f2ep-65, -0x1.6bf01f24004aep-66,
     0x1.288ab79ac994fp-67, -0x1.fcabca7ba98a8p-69, 0x1.c433add1fecc5p-70},
     /* [181] 1.625 <= y <= 1.75 2^-38, degree 10, 93.8 bits */
    {0x1.20c3d49832c54p+0, 0x1.36e7c5a688412p-58, -0x1.3531c0e1e9f92p-36, 0x1.907edda54d039p-56, -0x1.2696188c4a2a2p-59,
     0x1.e796cb463a467p-62, -0x1.0d03a1436d8efp-63, 0x1.5a511772c9faep-65, -0x1.eb5353131e79dp-67,
     0x1.74babd514569fp-68, -0x1.298dbcd7362fap-69, 0x1.ec8cb449ca3f6p-71},
     /* [182] 1.75 <= y <= 1.875 2^-38, degree 10, 93.5 bits */
    {0x1.20c3d498305aep+0, -0x1.96eced4c42149p-55, -0x1.3531babaa2d02p-36, 0x1.835cc3c276dc9p-56,
     -0x1.0a8aff29246f3p-59, 0x1.9cb5b7ebf453p-62, -0x1.aa05b578f4aecp-64, 0x1.00877ff7b2138p-65,
     -0x1.54765ea709bbep-67, 0x1.e33c947dc6f97p-69, -0x1.68ce6bab35b5ep-70, 0x1.175b74f46cbe2p-71},
     /* [183] 1.875 <= y <= 2 2^-38, degree 10, 94.8 bits */
    {0x1.20c3d4982cbb4p+0, 0x1.ebd78e3bb7925p-54, -0x1.3531b1dc1e8f3p-35, 0x1.71e152118de94p-54, -0x1.d01c5b46e03dep-57,
     0x1.479b27b189c9p-58, -0x1.3455a56ca07a5p-59, 0x1.529025936b386p-60, -0x1.99afb639c3069p-61, 0x1.09173add5fdd3p-61,
     -0x1.6a3379788acd3p-62, 0x1.ff7c304379cdap-63}, /* [184] 1 <= y <= 1.125 2^-37, degree 10, 94.1 bits */
    {0x1.20c3d49827e68p+0, 0x1.fd3945fe14575p-57, -0x1.3531a69f53f2ap-35, 0x1.5ddfb564aed73p-54, -0x1.88cb4b1e16d4ap-57,
     0x1.f028964cd434cp-59, -0x1.a1d12041af10ep-60, 0x1.9a7c7f2e86424p-61, -0x1.bc6f0ef8db1d8p-62,
     0x1.014dafb225608p-62, -0x1.3a3d1a5a1b34fp-63, 0x1.8d0582c377001p-64},
     /* [185] 1.125 <= y <= 1.25 2^-37, degree 10, 93.1 bits */
    {0x1.20c3d4982311cp+0, -0x1.61984d4bf481ap-54, -0x1.35319bf658e77p-35, 0x1.4ccc67217cfbfp-54,
     -0x1.5209f97dabbe6p-57, 0x1.825407bc20b13p-59, -0x1.26583f7c5d0edp-60, 0x1.05a3b25e75883p-61,
     -0x1.004c7fd159e7cp-62, 0x1.0c80d4ab12d91p-63, -0x1.28784005b2d1p-64, 0x1.52e26275af078p-65},
     /* [186] 1.25 <= y <= 1.375 2^-37, degree 10, 95.0 bits */
    {0x1.20c3d4981e3cfp+0, 0x1.0790233c199cep-54, -0x1.353191cc7e062p-35, 0x1.3e00737640267p-54, -0x1.26eb86cd7765cp-57,
     0x1.33bdb00e5ccf3p-59, -0x1.ac2911308b312p-61, 0x1.5b7df92c1cb77p-62, -0x1.36cca6743abe5p-63,
     0x1.29493ef179ee8p-64, -0x1.2b8aede8abc6p-65, 0x1.389d1f8983155p-66},
     /* [187] 1.375 <= y <= 1.5 2^-37, degree 10, 92.6 bits */
    {0x1.20c3d49819683p+0, -0x1.0aac686843ee6p-55, -0x1.353188117ea22p-35, 0x1.3104abf6b26dep-54,
     -0x1.043f51e2ebe42p-57, 0x1.f3ac0d2683e0ep-60, -0x1.3fca168156903p-61, 0x1.dd8d333a70f4bp-63,
     -0x1.88f4ab7b1ad26p-64, 0x1.59ccfe0c30613p-65, -0x1.406a93f2a9e76p-66, 0x1.33a3a19ffa7e1p-67},
     /* [188] 1.5 <= y <= 1.625 2^-37, degree 10, 92.7 bits */
    {0x1.20c3d49814936p+0, 0x1.f74c940918a89p-54, -0x1.35317eb8491f9p-35, 0x1.25816795ecbcbp-54, -0x1.cfbf306320433p-58,
     0x1.9c378c5fa767bp-60, -0x1.e88d64aadc57p-62, 0x1.51c39cd59c59dp-63, -0x1.0157f2dd09ff5p-64, 0x1.a35fd3c48c04fp-66,
     -0x1.67af7589e5936p-67, 0x1.3fc16ab1406ccp-68}, /* [189] 1.625 <= y <= 1.75 2^-37, degree 10, 92.6 bits */
    {0x1.20c3d4980fbeap+0, 0x1.f470d7cdb9652p-56, -0x1.353175b62dbd6p-35, 0x1.1b348af688b8fp-54, -0x1.a09c351df23aap-58,
     0x1.58c75bd34969dp-60, -0x1.7c71d05ec2d19p-62, 0x1.e9c45e23e0f4cp-64, -0x1.5b6b9b42dd6c2p-65,
     0x1.078f5efa19a37p-66, -0x1.a4ce21142fe1dp-68, 0x1.5c49286b782fbp-69},
     /* [190] 1.75 <= y <= 1.875 2^-37, degree 10, 93.3 bits */
    {0x1.20c3d4980ae9ep+0, -0x1.e873ae5300664p-55, -0x1.35316d024d712p-35, 0x1.11eb2a57a24cbp-54,
     -0x1.78f3642bb4825p-58, 0x1.23d4bc6f156eep-60, -0x1.2d3e8051b71e5p-62, 0x1.6ac9c2ac40925p-64,
     -0x1.e17cd34c43397p-66, 0x1.55b35abc4f5dp-67, -0x1.fe42174066168p-69, 0x1.8b124e8efab47p-70},
     /* [191] 1.875 <= y <= 2 2^-37, degree 10, 92.5 bits */
    {0x1.20c3d49803aabp+0, 0x1.e37b2fd7559ddp-55, -0x1.3531607729ad4p-34, 0x1.058e87d6c1619p-52, -0x1.482d826ab548ep-55,
     0x1.cf4e869d851cbp-57, -0x1.b40d60a9b74c2p-58, 0x1.decd3ff2b9a72p-59, -0x1.21b15472251d5p-59,
     0x1.76e54e2d3ab43p-60, -0x1.001d86e41d7acp-60, 0x1.69acdd9e74136p-61},
     /* [192] 1 <= y <= 1.125 2^-36, degree 10, 91.4 bits */
    {0x1.20c3d497fa013p+0, -0x1.bf2672bc00f32p-54, -0x1.3531509292fa1p-34, 0x1.eed1f7076a693p-53,
     -0x1.15bfc3de2b881p-55, 0x1.5ed6a810fd294p-57, -0x1.27712f32da587p-58, 0x1.22422b0c2e6abp-59,
     -0x1.3a4350c02badcp-60, 0x1.6be203a980e33p-61, -0x1.bc66caf9652f9p-62, 0x1.18bcb6875d668p-62},
     /* [193] 1.125 <= y <= 1.25 2^-36, degree 10, 94.0 bits */
    {0x1.20c3d497f057ap+0, -0x1.445f782753238p-56, -0x1.3531417f05d58p-34, 0x1.d6abf761cd156p-53,
     -0x1.de0ff703b2fe4p-56, 0x1.112d2e972a387p-57, -0x1.a0448966698c5p-59, 0x1.7203dfc775f8dp-60,
     -0x1.6a76543479e0cp-61, 0x1.7bb8ca0e0ed6ep-62, -0x1.a345bdd749b4dp-63, 0x1.df417a78f9d78p-64},
     /* [194] 1.25 <= y <= 1.375 2^-36, degree 10, 93.1 bits */
    {0x1.20c3d497e6ae1p+0, 0x1.3a65bdba3181bp-54, -0x1.3531331f41627p-34, 0x1.c1bef54db5697p-53, -0x1.a1152c6e452a1p-56,
     0x1.b336a1a261adfp-58, -0x1.2ec197cdacc64p-59, 0x1.eb6df5a72a3ecp-61, -0x1.b789b71b1a507p-62,
     0x1.a46d56ac3db31p-63, -0x1.a79e499caf324p-64, 0x1.ba1a838a992a5p-65},
     /* [195] 1.375 <= y <= 1.5 2^-36, degree 10, 91.2 bits */
    {0x1.20c3d497dd049p+0, -0x1.1dfd4ed2957a4p-54, -0x1.3531255c43dd3p-34, 0x1.af6264637e1e3p-53,
     -0x1.700c439e84e9fp-56, 0x1.6152bb0d638fp-58, -0x1.c44090b6297dep-60, 0x1.51ae581ef6c78p-61,
     -0x1.15dcca51b248dp-62, 0x1.e90991c786464p-64, -0x1.c52360657e13fp-65, 0x1.b31187dc6f3b3p-66},
     /* [196] 1.5 <= y <= 1.625 2^-36, degree 10, 91.1 bits */
    {0x1.20c3d497d35bp+0, 0x1.49311dbdea7acp-55, -0x1.3531182391d87p-34, 0x1.9f1a4c155cf52p-53, -0x1.47ebc197a2cc5p-56,
     0x1.237b9ba3d05a5p-58, -0x1.5975c29a6a749p-60, 0x1.ddac140b223b2p-62, -0x1.6bf097d519431p-63,
     0x1.288b11012d9cfp-64, -0x1.fcac5800a6554p-66, 0x1.c434233e1bbdfp-67},
     /* [197] 1.625 <= y <= 1.75 2^-36, degree 10, 92.9 bits */
    {0x1.20c3d497c9b18p+0, -0x1.7edda6c788335p-54, -0x1.35310b660e5eap-34, 0x1.90892f0b7590ep-53,
     -0x1.269711cbdc23dp-56, 0x1.e797de3e674a5p-59, -0x1.0d041a9f0a609p-60, 0x1.5a519d5b180ffp-62,
     -0x1.eb53fbf07ed12p-64, 0x1.74bb31c62b7c2p-65, -0x1.298e12a385649p-66, 0x1.ec8d38d834c66p-68},
     /* [198] 1.75 <= y <= 1.875 2^-36, degree 10, 93.2 bits */
    {0x1.20c3d497c007fp+0, 0x1.dada7b2058baap-56, -0x1.3530ff172daf1p-34, 0x1.836709dc3f831p-53, -0x1.0a8be85459fecp-56,
     0x1.9cb6a90a4c3dp-59, -0x1.aa07034829abcp-61, 0x1.006f95e40de55p-62, -0x1.4d7c6bfab7bd8p-64, 0x1.1a72daa0b4e45p-64,
     -0x1.c9c431ff24324p-63, -0x1.3d332f17e881dp-58}, /* [199] 1.875 <= y <= 2 2^-36, degree 10, 93.2 bits */
    {0x1.20c3d497b189ap+0, 0x1.9441c6381e768p-54, -0x1.3530ed59aa436p-33, 0x1.71eb888512dd5p-51, -0x1.d01e047b2804ap-54,
     0x1.479befbd1a378p-55, -0x1.34563c068ec9ep-56, 0x1.5290b344d2eccp-57, -0x1.99b04e7a51978p-58,
     0x1.09179431f4232p-58, -0x1.6a33e96efce4cp-59, 0x1.ff7cc24514721p-60},
     /* [200] 1 <= y <= 1.125 2^-35, degree 10, 90.4 bits */
    {0x1.20c3d4979e36ap+0, -0x1.f3c5d43b8e4acp-54, -0x1.3530d6df723c9p-33, 0x1.5de9d9002f8e3p-51,
     -0x1.88ccc793011ddp-54, 0x1.f029d69a11032p-56, -0x1.a1d1f804ffa2bp-57, 0x1.9a7d34da5abe9p-58,
     -0x1.bc6fbdbf31b13p-59, 0x1.014e0b96bb4c8p-59, -0x1.3a3d81a5d1dbcp-60, 0x1.8d05fbfec661ap-61},
     /* [201] 1.125 <= y <= 1.25 2^-35, degree 10, 96.5 bits */
    {0x1.20c3d4978ae39p+0, -0x1.24436a3c62ea4p-54, -0x1.3530c18cda765p-33, 0x1.4cd679c81ba6ap-51,
     -0x1.520b51b9031f9p-54, 0x1.82550defb0603p-56, -0x1.2658df4a8fc71p-57, 0x1.05a42c1e3216ap-58,
     -0x1.004ce9d0bce0cp-59, 0x1.0c813993f0d06p-60, -0x1.2878a6b9d5653p-61, 0x1.52e2cfcbc9324p-62},
     /* [202] 1.25 <= y <= 1.375 2^-35, degree 10, 90.1 bits */
    {0x1.20c3d49777908p+0, -0x1.7f46ed311937cp-62, -0x1.3530ad3884069p-33, 0x1.3e0a76b31572ap-51,
     -0x1.26ecc11be9af5p-54, 0x1.33be8aa49bc58p-56, -0x1.ac2a047796283p-58, 0x1.5b7ea266cea4fp-59,
     -0x1.36cd2cfd2777p-60, 0x1.2949b3e98ced5p-61, -0x1.2b8b5a9e1bf5ap-62, 0x1.389d89532405fp-63},
     /* [203] 1.375 <= y <= 1.5 2^-35, degree 10, 90.2 bits */
    {0x1.20c3d497643d7p+0, 0x1.70d11d75bfcf2p-54, -0x1.353099c1e57d5p-33, 0x1.310ea112dea3bp-51, -0x1.0440730e20979p-54,
     0x1.f3ad7f2de7b5dp-57, -0x1.3fcad3f1c6819p-58, 0x1.dd8e25b366963p-60, -0x1.88f55cd3b3f45p-61,
     0x1.59cd8beaa951dp-62, -0x1.406b0d3c82da9p-63, 0x1.33a40e44c3289p-64},
     /* [204] 1.5 <= y <= 1.625 2^-35, degree 10, 92.4 bits */
    {0x1.20c3d49750ea7p+0, -0x1.a12606dd9132p-55, -0x1.3530870edb902p-33, 0x1.258b4fa7d9b1ep-51, -0x1.cfc147e5a6691p-55,
     0x1.9c38c99e2c0bep-57, -0x1.e88e916fa7cfbp-59, 0x1.51c44f0f6e75ep-60, -0x1.01586b9059049p-61,
     0x1.a360869458b78p-63, -0x1.67b0030f9187cp-64, 0x1.3fc1e018eca62p-65},
     /* [205] 1.625 <= y <= 1.75 2^-35, degree 10, 90.1 bits */
    {0x1.20c3d4973d976p+0, 0x1.3772231ef923p-54, -0x1.3530750a06acap-33, 0x1.1b3e66eccd045p-51, -0x1.a09e27b4b9026p-55,
     0x1.58c86ed2f4ff5p-57, -0x1.7c72c31b267e9p-59, 0x1.e9c569f985e7ep-61, -0x1.5b6c442354529p-62,
     0x1.078fd3713f4f4p-63, -0x1.a4ceccafe669p-65, 0x1.5c49acfa7af84p-66},
     /* [206] 1.75 <= y <= 1.875 2^-35, degree 10, 90.4 bits */
    {0x1.20c3d4972a446p+0, -0x1.e6cede2e23afcp-56, -0x1.353063a1a8b01p-33, 0x1.11f4fb00fba16p-51,
     -0x1.78f5369a369a6p-55, 0x1.23d5ad18b1e49p-57, -0x1.2d3f470aa8df6p-59, 0x1.6aca8fcbc810dp-61,
     -0x1.e17dc547ad75ep-63, 0x1.55b3f6d9e9f77p-64, -0x1.fe42ee678fe4dp-66, 0x1.8b12ea0949153p-67},
     /* [207] 1.875 <= y <= 2 2^-35, degree 10, 90.6 bits */
    {0x1.20c3d4970d47dp+0, 0x1.7c5c2f7a08ab2p-54, -0x1.35304a8a76572p-32, 0x1.059848d90fc05p-49, -0x1.482f2bb49a0b5p-52,
     0x1.cf5016c14424cp-54, -0x1.b40e8dea6f0fcp-55, 0x1.dece5b774ad72p-56, -0x1.21b1eceba8fc6p-56,
     0x1.76e6018e33435p-57, -0x1.001df7f0a8b5ap-57, 0x1.69ad72a00b332p-58},
     /* [208] 1 <= y <= 1.125 2^-34, degree 10, 92.0 bits */
    {0x1.20c3d496e6a1dp+0, -0x1.5e81818939fbcp-56, -0x1.35302ac01203bp-32, 0x1.eee5535a09414p-50,
     -0x1.15c14067500bfp-52, 0x1.5ed7e8681f5f7p-54, -0x1.277206fc3ace4p-55, 0x1.2242e0c0c6b44p-56,
     -0x1.3a43ff9e55a47p-57, 0x1.6be2bbbab0b0ap-58, -0x1.bc679a6006c42p-59, 0x1.18bd30d125f22p-59},
     /* [209] 1.125 <= y <= 1.25 2^-34, degree 10, 90.5 bits */
    {0x1.20c3d496bffbdp+0, -0x1.33fe471e75284p-54, -0x1.35300c97c3094p-32, 0x1.d6bf31c8d05f9p-50,
     -0x1.de12a7a09101fp-53, 0x1.112e34d3187bap-54, -0x1.a045c90ae2652p-56, 0x1.7204d34d88ed2p-57,
     -0x1.6a77283ea502cp-58, 0x1.7bb993fe01b42p-59, -0x1.a3468b92ebe18p-60, 0x1.df4255f6e8dcfp-61},
     /* [210] 1.25 <= y <= 1.375 2^-34, degree 10, 95.3 bits */
    {0x1.20c3d4969955dp+0, -0x1.24da57f77267p-54, -0x1.352fefd707773p-32, 0x1.c1d210df67b6ap-50, -0x1.a117a12f6638p-53,
     0x1.b33856dd670dcp-55, -0x1.2ec28b1af5787p-56, 0x1.eb6f482405137p-58, -0x1.b78ac43421333p-59,
     0x1.a46e40aa1640dp-60, -0x1.a79f232aaf581p-61, 0x1.ba1b577445142p-62},
     /* [211] 1.375 <= y <= 1.5 2^-34, degree 10, 89.7 bits */
    {0x1.20c3d49672afdp+0, -0x1.a590eb95133ebp-57, -0x1.352fd44fdb98dp-32, 0x1.af7563b235d83p-50,
     -0x1.700e861776f1dp-53, 0x1.61542d218d22bp-55, -0x1.c4420ba12becbp-57, 0x1.51af4a9d3df94p-58,
     -0x1.15dd7badba4d9p-59, 0x1.e90aad8bea459p-61, -0x1.c52453088180ap-62, 0x1.b312614a9ec4dp-63},
     /* [212] 1.5 <= y <= 1.625 2^-34, degree 10, 90.0 bits */
    {0x1.20c3d4964c09dp+0, 0x1.9346eec33febap-54, -0x1.352fb9dd486dbp-32, 0x1.9f2d314e00fa1p-50, -0x1.47edd93b30a38p-53,
     0x1.237cd8eda9e47p-55, -0x1.5976ef6797cbcp-57, 0x1.ddad78870016ep-59, -0x1.6bf189403c261p-60,
     0x1.288bc3d3f5856p-61, -0x1.fcad73135014bp-63, 0x1.c4350e1cf89d8p-64},
     /* [213] 1.625 <= y <= 1.75 2^-34, degree 10, 90.9 bits */
    {0x1.20c3d4962563ep+0, 0x1.57469748698e6p-57, -0x1.352fa06113ea9p-32, 0x1.909bfc0b44156p-50, -0x1.2699048253be6p-53,
     0x1.e79a045202c75p-56, -0x1.0d050d62700cfp-57, 0x1.5a52a93741c35p-59, -0x1.eb554db82e3eap-61,
     0x1.74bc1ab810fabp-62, -0x1.298ebe419ea8ep-63, 0x1.ec8e41fcd84e9p-65},
     /* [214] 1.75 <= y <= 1.875 2^-34, degree 10, 89.8 bits */
    {0x1.20c3d495febdfp+0, -0x1.d46022bcab8b8p-56, -0x1.352f87c226725p-32, 0x1.8379c040c3312p-50, -0x1.0a8dbae20518p-53,
     0x1.9cb889f4497ddp-56, -0x1.aa0809ab480d1p-58, 0x1.0088b3aa41e07p-59, -0x1.5477c9a336c4bp-61,
     0x1.e33e68d8ea267p-63, -0x1.68cfae6642768p-64, 0x1.175c5e2c088a1p-65},
     /* [215] 1.875 <= y <= 2 2^-34, degree 10, 89.9 bits */
    {0x1.20c3d495c4c51p+0, -0x1.fba1d18af4a7fp-54, -0x1.352f64455fff1p-31, 0x1.71fe1f996a855p-48, -0x1.d0215748c88cp-51,
     0x1.479d7ff118774p-52, -0x1.345769539d22ep-53, 0x1.5291cedf136d5p-54, -0x1.99b17faac880cp-55,
     0x1.091847f0d04ddp-55, -0x1.6a34cc9f434dfp-56, 0x1.ff7def4756dbp-57},
     /* [216] 1 <= y <= 1.125 2^-33, degree 10, 88.3 bits */
    {0x1.20c3d49577793p+0, 0x1.2b132d7afad69p-54, -0x1.352f374e9f756p-31, 0x1.5dfc4a5fe9ef2p-48, -0x1.88cfc0db7805fp-51,
     0x1.f02c5762e81bep-53, -0x1.a1d3a7a6aa2efp-54, 0x1.9a7ea052c6bep-55, -0x1.bc711b98ffd4ep-56, 0x1.014ec3ce8fb19p-56,
     -0x1.3a3e5176487a6p-57, 0x1.8d06f1a1dd72dp-58}, /* [217] 1.125 <= y <= 1.25 2^-33, degree 10, 90.0 bits */
    {0x1.20c3d4952a2d7p+0, -0x1.e3859910a4d62p-55, -0x1.352f0ca723e4fp-31, 0x1.4ce8c939c32fap-48,
     -0x1.520e0288ff517p-51, 0x1.82571a7e2aa99p-53, -0x1.265a1ef9e57fep-54, 0x1.05a51fac0eabbp-55,
     -0x1.004dbde42d8a8p-56, 0x1.0c8203962f50dp-57, -0x1.287974a211ee9p-58, 0x1.52e3abb4f4d2fp-59},
     /* [218] 1.25 <= y <= 1.375 2^-33, degree 10, 88.3 bits */
    {0x1.20c3d494dce1bp+0, -0x1.d1997292f185ap-56, -0x1.352ee3fc2f0c1p-31, 0x1.3e1ca74d16becp-48,
     -0x1.26ef360d872dap-51, 0x1.33c03ff33e574p-53, -0x1.ac2beb23307a9p-55, 0x1.5b7ff4edd5532p-56,
     -0x1.36ce3a1e6c689p-57, 0x1.294a9df213045p-58, -0x1.2b8c344114815p-59, 0x1.389e5d6b0c7c4p-60},
     /* [219] 1.375 <= y <= 1.5 2^-33, degree 10, 88.3 bits */
    {0x1.20c3d4948f96p+0, -0x1.7a838281acee2p-54, -0x1.352ebd0cadb0fp-31, 0x1.3120b567ad9bdp-48, -0x1.0442b5b543126p-51,
     0x1.f3b06378ab67dp-54, -0x1.3fcc4eea911adp-55, 0x1.dd900abecc02bp-57, -0x1.88f6bf957a884p-58, 0x1.59cea7b77f0dp-59,
     -0x1.406bffeb1a5aep-60, 0x1.33a4e7c8ad65fp-61}, /* [220] 1.5 <= y <= 1.625 2^-33, degree 10, 88.3 bits */
    {0x1.20c3d494424a5p+0, -0x1.e20a994225357p-58, -0x1.352e97a458f2cp-31, 0x1.259d49e477169p-48, -0x1.cfc57785158p-52,
     0x1.9c3b445066cc3p-54, -0x1.e890eb20b52e7p-56, 0x1.51c5b396a16bfp-57, -0x1.01595d02203fbp-58,
     0x1.a361ec42ed20cp-60, -0x1.67b11e2a80635p-61, 0x1.3fc2cb0356073p-62},
     /* [221] 1.625 <= y <= 1.75 2^-33, degree 10, 88.3 bits */
    {0x1.20c3d493f4febp+0, -0x1.d93e812e7ccd8p-56, -0x1.352e7398716c8p-31, 0x1.1b5048ee8dfaap-48,
     -0x1.a0a20d7660152p-52, 0x1.58ca9501da86fp-54, -0x1.7c74a8b4e20c4p-56, 0x1.e9c781c38c94ep-58,
     -0x1.5b6d95f4b0b29p-59, 0x1.0790bc68f236fp-60, -0x1.a4d023f419f8p-62, 0x1.5c4ab626b5aap-63},
     /* [222] 1.75 <= y <= 1.875 2^-33, degree 10, 91.3 bits */
    {0x1.20c3d493a7b31p+0, 0x1.684d23831e246p-54, -0x1.352e50c57aa1p-31, 0x1.1206c6657f48bp-48, -0x1.78f8dc05b05b2p-52,
     0x1.23d78e96bde53p-54, -0x1.2d40d4985aa61p-56, 0x1.6acc2a234e0e5p-58, -0x1.e17fa9577046p-60, 0x1.55b52f2287a6ap-61,
     -0x1.fe449cc4b982ep-63, 0x1.8b142107f6aeep-64}, /* [223] 1.875 <= y <= 2 2^-33, degree 10, 89.3 bits */
    {0x1.20c3d49333c1cp+0, 0x1.a603798c56d8ep-57, -0x1.352e1e93c2c7bp-30, 0x1.05a9f4ea9dc1cp-46, -0x1.48327ecf620ep-49,
     0x1.cf533752d2c2ap-51, -0x1.b410e897be3b6p-52, 0x1.ded092a3d94a3p-53, -0x1.21b31def85716p-53,
     0x1.76e7686159de1p-54, -0x1.001eda129267p-54, 0x1.69ae9cabeedb1p-55},
     /* [224] 1 <= y <= 1.125 2^-32, degree 10, 91.1 bits */
    {0x1.20c3d492992acp+0, 0x1.951ea6d041a0fp-56, -0x1.352ddefa93e9cp-30, 0x1.ef08600cea55ep-47, -0x1.15c439f81cd07p-49,
     0x1.5eda695490967p-51, -0x1.2773b6afecb2cp-52, 0x1.22444c41cd03ap-53, -0x1.3a455d6f33c8fp-54,
     0x1.6be42bf09cd24p-55, -0x1.bc6939409fe3dp-56, 0x1.18be256dfbe17p-56},
     /* [225] 1.125 <= y <= 1.25 2^-32, degree 10, 88.2 bits */
    {0x1.20c3d491fe93ep+0, 0x1.4d418a17dec99p-56, -0x1.352da2a598aedp-30, 0x1.d6e1fa98f66f9p-47, -0x1.de1809c8f77f3p-50,
     0x1.1130418013e5p-51, -0x1.a0484886bc7e5p-53, 0x1.7206ba7af88b1p-54, -0x1.6a78d06d0014cp-55, 0x1.7bbb27f4ab1e5p-56,
     -0x1.a348271f77e92p-57, 0x1.df440d06eaab1p-58}, /* [226] 1.25 <= y <= 1.375 2^-32, degree 10, 88.2 bits */
    {0x1.20c3d49163fd2p+0, -0x1.88344102704a1p-56, -0x1.352d691fcc5afp-30, 0x1.c1f49bfa07bdbp-47,
     -0x1.a11c8b93f66fbp-50, 0x1.b33bc1af86fbap-52, -0x1.2ec471ddcfadbp-53, 0x1.eb71ed4dc308p-55,
     -0x1.b78cde886a152p-56, 0x1.a47014c137766p-57, -0x1.a7a0d65e85be1p-58, 0x1.ba1cff5d2abdep-59},
     /* [227] 1.375 <= y <= 1.5 2^-32, degree 10, 89.1 bits */
    {0x1.20c3d490c9667p+0, 0x1.f1420607cd049p-54, -0x1.352d320d26d07p-30, 0x1.af97b63c87243p-47, -0x1.70130be0e1f65p-50,
     0x1.6157119aa4ef7p-52, -0x1.c44501b838a3bp-54, 0x1.51b12fbd6dd42p-55, -0x1.15dede7d1aa05p-56,
     0x1.e90ce537073a1p-58, -0x1.c526386a167fep-59, 0x1.b314143e5c53cp-60},
     /* [228] 1.5 <= y <= 1.625 2^-32, degree 10, 87.5 bits */
    {0x1.20c3d4902ecffp+0, -0x1.f8be151677ee7p-55, -0x1.352cfd23b9771p-30, 0x1.9f4f4fa24ab14p-47,
     -0x1.47f2095052e12p-50, 0x1.237f53c8ec463p-52, -0x1.5979493751661p-54, 0x1.ddb041b4da70fp-56,
     -0x1.6bf36c373e6c7p-57, 0x1.288d298fc76b1p-58, -0x1.fcafa959ab8b8p-60, 0x1.c436e3f4c7697p-61},
     /* [229] 1.625 <= y <= 1.75 2^-32, degree 10, 90.1 bits */
    {0x1.20c3d48f94398p+0, -0x1.6c30e10fff8c8p-54, -0x1.352cca270fb74p-30, 0x1.90bde9e46e2afp-47,
     -0x1.269ceab4d517bp-50, 0x1.e79e50f91f995p-53, -0x1.0d06f315a90c1p-54, 0x1.5a54c11983925p-56,
     -0x1.eb57f176bc7dp-58, 0x1.74bdecb9a85dbp-59, -0x1.299015925584cp-60, 0x1.ec90546443847p-62},
     /* [230] 1.75 <= y <= 1.875 2^-32, degree 10, 87.1 bits */
    {0x1.20c3d48ef9a32p+0, 0x1.9dbc0bcc9cf85p-56, -0x1.352c98e4f9e79p-30, 0x1.839b80da42f7fp-47, -0x1.0a9160ba002cbp-50,
     0x1.9cbc4d3263b85p-53, -0x1.aa0b24f197962p-55, 0x1.008a4e14cd24ep-56, -0x1.5479adc742e32p-58,
     0x1.e340d982edbf4p-60, -0x1.68d15cd41370bp-61, 0x1.175d95360f5bap-62},
     /* [231] 1.875 <= y <= 2 2^-32, degree 10, 87.2 bits */
    {0x1.20c3d48e11c1dp+0, -0x1.8e6831f7bd828p-54, -0x1.352c51e51edbap-29, 0x1.721fa18592f04p-45,
     -0x1.d027fe4bd9c9ep-48, 0x1.47a0a0bbb960bp-49, -0x1.3459c422c4911p-50, 0x1.52940626ea758p-51,
     -0x1.99b3e1ccca50ep-52, 0x1.0919aed260dfp-52, -0x1.6a3690f4c6657p-53, 0x1.ff80437686b69p-54},
     /* [232] 1 <= y <= 1.125 2^-31, degree 10, 86.8 bits */
    {0x1.20c3d48cdc95ap+0, 0x1.51b34f50ac18dp-54, -0x1.352bf7ef46e93p-29, 0x1.5e1d80d2860d5p-45, -0x1.88d5b4bd81c9fp-48,
     0x1.f031599b95568p-50, -0x1.a1d70740ebef1p-51, 0x1.9a81777981865p-52, -0x1.bc73d75a2e5ecp-53,
     0x1.01503413a99fdp-53, -0x1.3a3ff0671a4aep-54, 0x1.8d08daee727bap-55},
     /* [233] 1.125 <= y <= 1.25 2^-31, degree 10, 89.4 bits */
    {0x1.20c3d48ba769ep+0, -0x1.e875867ce8f94p-54, -0x1.352ba2980acd4p-29, 0x1.4d09bbc0e3252p-45,
     -0x1.52136566c60f1p-48, 0x1.825b3429efc02p-50, -0x1.265c9e9d14429p-51, 0x1.05a706f32d139p-52,
     -0x1.004f6626712ecp-53, 0x1.0c83979e1ea94p-54, -0x1.287b103f0156bp-55, 0x1.52e562d5be804p-56},
     /* [234] 1.25 <= y <= 1.375 2^-31, degree 10, 87.4 bits */
    {0x1.20c3d48a723e6p+0, -0x1.3bef71a8ec555p-56, -0x1.352b5139ec4f6p-29, 0x1.3e3d5c166a9d8p-45,
     -0x1.26f4211df3b7ep-48, 0x1.33c3ab0c3c09cp-50, -0x1.ac2fb8e724a25p-52, 0x1.5b829a3cb8dcp-53,
     -0x1.36d0548d06b85p-54, 0x1.294c721e07b07p-55, -0x1.2b8de786cf772p-56, 0x1.38a005645b849p-57},
     /* [235] 1.375 <= y <= 1.5 2^-31, degree 10, 87.1 bits */
    {0x1.20c3d4893d133p+0, 0x1.30bc73125527dp-54, -0x1.352b0352c3931p-29, 0x1.31413198d7444p-45, -0x1.04473c223f89fp-48,
     0x1.f3b62ce71b726p-51, -0x1.3fcf4533d7233p-52, 0x1.dd93d5365a143p-54, -0x1.88f985583e291p-55,
     0x1.59d0df7cdac1ep-56, -0x1.406de561636bep-57, 0x1.33a69acdbd66p-58},
     /* [236] 1.5 <= y <= 1.625 2^-31, degree 10, 87.4 bits */
    {0x1.20c3d48807e85p+0, 0x1.c67c81c0adf04p-54, -0x1.352ab87a01a78p-29, 0x1.25bd91d81b133p-45, -0x1.cfcdd8e7dfd92p-49,
     0x1.9c403a74f3dbbp-51, -0x1.e8959f128b3b4p-53, 0x1.51c87cee67d46p-54, -0x1.015b40127db5dp-55,
     0x1.a364b7dcd6edcp-57, -0x1.67b35489e9077p-58, 0x1.3fc4a0ee82204p-59},
     /* [237] 1.625 <= y <= 1.75 2^-31, degree 10, 88.7 bits */
    {0x1.20c3d486d2bdcp+0, 0x1.73652ef129306p-55, -0x1.352a705a26c0dp-29, 0x1.1b70605fe6ec4p-45, -0x1.a0a9db06e9494p-49,
     0x1.58cee20b410cp-51, -0x1.7c78745fdc7a5p-53, 0x1.e9cbb1c9031e7p-55, -0x1.5b7039d7d7b47p-56, 0x1.07928e819879p-57,
     -0x1.a4d2d2b4f5db4p-59, 0x1.5c4cc8a4c3bfbp-60}, /* [238] 1.75 <= y <= 1.875 2^-31, degree 10, 86.6 bits */
    {0x1.20c3d4859d937p+0, 0x1.6547fcc5f1f4bp-54, -0x1.352a2aac39066p-29, 0x1.1226b0904c581p-45, -0x1.790028d585956p-49,
     0x1.23db522d4d838p-51, -0x1.2d43f0186087ap-53, 0x1.6acf5f2b904d8p-55, -0x1.e18371d57f405p-57,
     0x1.55b79fec616d3p-58, -0x1.fe47f9c90384fp-60, 0x1.8b168f3774f11p-61},
     /* [239] 1.875 <= y <= 2 2^-31, degree 10, 89.3 bits */
    {0x1.20c3d483cdd48p+0, 0x1.7a979a4cb0174p-56, -0x1.3529c63cdd745p-28, 0x1.05c9a05e3bab9p-43, -0x1.483926e2e824dp-46,
     0x1.cf597980f7bd3p-48, -0x1.b4159e91067fcp-49, 0x1.ded5017d146ccp-50, -0x1.21b58034e5302p-50,
     0x1.76ea364a8ed1fp-51, -0x1.00209e7e5a0fp-51, 0x1.69b0f0f69b225p-52},
     /* [240] 1 <= y <= 1.125 2^-30, degree 10, 87.2 bits */
    {0x1.20c3d48163817p+0, 0x1.5c25fa84beee5p-54, -0x1.352946fabd39ap-28, 0x1.ef471fe85ab7fp-44, -0x1.15ca2ed91c4cfp-46,
     0x1.5edf6c0d79f9p-48, -0x1.2777168e7ba18p-49, 0x1.22472399f15d7p-50, -0x1.3a48195ae694bp-51, 0x1.6be70ca3c86dcp-52,
     -0x1.bc6c774d26f06p-53, 0x1.18c00ed24e06bp-53}, /* [241] 1.125 <= y <= 1.25 2^-30, degree 10, 90.3 bits */
    {0x1.20c3d47ef92f6p+0, 0x1.3628923014c57p-56, -0x1.3528ce4128132p-28, 0x1.d72032863dd19p-44, -0x1.de22d164d3eebp-47,
     0x1.11345b994f391p-48, -0x1.a04d4836a5142p-50, 0x1.720a894e4ceb5p-51, -0x1.6a7c2127501e8p-52,
     0x1.7bbe50336c4dap-53, -0x1.a34b5e85bbc98p-54, 0x1.df477b7500a4ap-55},
     /* [242] 1.25 <= y <= 1.375 2^-30, degree 10, 89.9 bits */
    {0x1.20c3d47c8ede4p+0, -0x1.d47befa78eee4p-54, -0x1.35285b26111e2p-28, 0x1.c2325855cfaa9p-44,
     -0x1.a126637ba8d39p-47, 0x1.b342989f15b6fp-49, -0x1.2ec83ff53ecadp-50, 0x1.eb77384f59baap-52,
     -0x1.b79113ac8f354p-53, 0x1.a473bd5194a9bp-54, -0x1.a7a43d1ac343ap-55, 0x1.ba204f7c72c81p-56},
     /* [243] 1.375 <= y <= 1.5 2^-30, degree 10, 85.8 bits */
    {0x1.20c3d47a248dfp+0, 0x1.5a67adf0740c1p-56, -0x1.3527ecf1654d2p-28, 0x1.afd501533075bp-44, -0x1.701c1a6b863efp-47,
     0x1.615cdbaf37eabp-49, -0x1.c44aeed16e655p-51, 0x1.51b4fa7f0fb1cp-52, -0x1.15e1a4704ecc8p-53,
     0x1.e9115508a9ca9p-55, -0x1.c52a038f01439p-56, 0x1.b3177a77f18bp-57},
     /* [244] 1.5 <= y <= 1.625 2^-30, degree 10, 86.6 bits */
    {0x1.20c3d477ba3e8p+0, 0x1.03b013929d9f3p-55, -0x1.3527830f45116p-28, 0x1.9f8c322a183c3p-44, -0x1.47fa6c503f42bp-47,
     0x1.23844a808ccf6p-49, -0x1.597dfd97935cp-51, 0x1.ddb5d4d4e96edp-53, -0x1.6bf7329c19b9cp-54, 0x1.288ff557ddbf1p-55,
     -0x1.fcb4165c64d62p-57, 0x1.c43a9000113b8p-58}, /* [245] 1.625 <= y <= 1.75 2^-30, degree 10, 87.1 bits */
    {0x1.20c3d4754fefep+0, 0x1.4658bac5a33bep-55, -0x1.35271d06c537ap-28, 0x1.90fa6b54b237fp-44, -0x1.26a4b9d12175ap-47,
     0x1.e7a6ec1298ff6p-50, -0x1.0d0abf1c791a7p-51, 0x1.5a58f1761c7c7p-53, -0x1.eb5d399f4c7aep-55,
     0x1.74c19128f5c49p-56, -0x1.2992c47da096fp-57, 0x1.ec94799df6986p-59},
     /* [246] 1.75 <= y <= 1.875 2^-30, degree 10, 85.5 bits */
    {0x1.20c3d472e5a21p+0, -0x1.18613b8171d11p-54, -0x1.3526ba7384b07p-28, 0x1.83d7a7ab412bcp-44,
     -0x1.0a98af06068dep-47, 0x1.9cc3d54bd844p-50, -0x1.aa115c8c46782p-52, 0x1.008d8361b38ddp-53,
     -0x1.547d768dbd47cp-55, 0x1.e345bb6c22b0cp-57, -0x1.68d4ba0f1876cp-58, 0x1.1760038ab38d9p-59},
     /* [247] 1.875 <= y <= 2 2^-30, degree 10, 86.5 bits */
    {0x1.20c3d46f462ebp+0, 0x1.844fc88a088dfp-55, -0x1.35262c5d57f04p-27, 0x1.725b4ace35332p-42, -0x1.d03551421b789p-45,
     0x1.47a6e3b603718p-46, -0x1.345e7a95e435ep-47, 0x1.52987562cba8ap-48, -0x1.99b8a6b673c15p-49,
     0x1.091c7ceeae046p-49, -0x1.6a3a1a082308bp-50, 0x1.ff84ec55e5549p-51},
     /* [248] 1 <= y <= 1.125 2^-29, degree 10, 84.3 bits */
    {0x1.20c3d46a71977p+0, -0x1.8271d7360a0d7p-55, -0x1.35257853f9e55p-27, 0x1.5e5892eec6dfdp-42,
     -0x1.88e1a11fffd04p-45, 0x1.f03b6063ad466p-47, -0x1.a1ddc7b4e890dp-48, 0x1.9a8726ae4e3c8p-49,
     -0x1.bc794fa3af0eap-50, 0x1.015314fdcdd6ap-50, -0x1.3a432ead28816p-51, 0x1.8d0cadf6cb9dfp-52},
     /* [249] 1.125 <= y <= 1.25 2^-29, degree 10, 84.1 bits */
    {0x1.20c3d4659d02ep+0, 0x1.06cd3abd36e78p-54, -0x1.3524cd881b337p-27, 0x1.4d4445d068549p-42, -0x1.521e2f7b9f8b7p-45,
     0x1.826369806afc9p-47, -0x1.26619eda3718bp-48, 0x1.05aad6231f8dap-49, -0x1.0052b728ece7p-50, 0x1.0c86c01bcd17p-51,
     -0x1.287e47e0d3e53p-52, 0x1.52e8d17f811c6p-53}, /* [250] 1.25 <= y <= 1.375 2^-29, degree 10, 85.5 bits */
    {0x1.20c3d460c870fp+0, 0x1.892ceb6cafae1p-54, -0x1.35242aaeb8935p-27, 0x1.3e776a779518cp-42, -0x1.26fdfb5caf605p-45,
     0x1.33ca82f88c169p-47, -0x1.ac3755f5536a1p-49, 0x1.5b87e5c40ee84p-50, -0x1.36d48a1058a0fp-51,
     0x1.29501afa2ce45p-52, -0x1.2b914e84851dap-53, 0x1.38a355bf89c52p-54},
     /* [251] 1.375 <= y <= 1.5 2^-29, degree 10, 84.2 bits */
    {0x1.20c3d45bf3e18p+0, 0x1.5a8965a9b7761p-54, -0x1.35238ec37ca6fp-27, 0x1.317ace998402dp-42, -0x1.04504ce65c6dfp-45,
     0x1.f3c1c2cb13c6fp-48, -0x1.3fd5330117f94p-49, 0x1.dd9b6b8011a99p-51, -0x1.88ff11c097a64p-52,
     0x1.59d54fadb0995p-53, -0x1.4071b0d1f5225p-54, 0x1.33aa01470219ap-55},
     /* [252] 1.5 <= y <= 1.625 2^-29, degree 10, 86.8 bits */
    {0x1.20c3d4571f547p+0, 0x1.f8f2b698ed955p-54, -0x1.3522f8f544cf8p-27, 0x1.25f6c62fd9c25p-42, -0x1.cfdea32699dddp-46,
     0x1.9c4a296c120d6p-48, -0x1.e89f08fa37113p-50, 0x1.51ce10a51cc9bp-51, -0x1.015f06d2b1ccp-52, 0x1.a36a4fe8f65e4p-54,
     -0x1.67b7c1e7d29d6p-55, 0x1.3fc84d40e1dc5p-56}, /* [253] 1.625 <= y <= 1.75 2^-29, degree 10, 85.6 bits */
    {0x1.20c3d4524ac9bp+0, 0x1.9fa6bb41fd496p-54, -0x1.352268990d6c4p-27, 0x1.1ba9338730483p-42, -0x1.a0b97d501d5f4p-46,
     0x1.58d77e82871bdp-48, -0x1.7c800d62e00d4p-50, 0x1.e9d4136b780cdp-52, -0x1.5b7582841b836p-53,
     0x1.079633441900fp-54, -0x1.a4d830fd83177p-56, 0x1.5c50ee312f8cep-57},
     /* [254] 1.75 <= y <= 1.875 2^-29, degree 10, 84.5 bits */
    {0x1.20c3d44d76413p+0, -0x1.b481d5a01547p-55, -0x1.3521dd20df52p-27, 0x1.125f29006acc8p-42, -0x1.790ec954b740ep-46,
     0x1.23e2db815f2bap-48, -0x1.2d4a288198679p-50, 0x1.6ad5ca7d0f0bp-52, -0x1.e18b042486905p-54, 0x1.55bc824849ddfp-55,
     -0x1.fe4eb4d2050c5p-57, 0x1.8b1b6c448a6f1p-58}, /* [255] 1.875 <= y <= 2 2^-29, degree 10, 84.9 bits */
    {0x1.20c3d44637786p+0, -0x1.3893c22a461c9p-55, -0x1.35211417fdb32p-26, 0x1.06019b23da862p-40,
     -0x1.48467d8981e16p-43, 0x1.cf660194cf59ap-45, -0x1.b41f0cbc9844dp-46, 0x1.dedde0fcb87dcp-47,
     -0x1.21ba459dac12bp-47, 0x1.76efd30c2cc6bp-48, -0x1.002427e1f9d02p-48, 0x1.69b59a3966523p-49},
     /* [256] 1 <= y <= 1.125 2^-28, degree 10, 86.4 bits */
    {0x1.20c3d43c8e73cp+0, 0x1.2be04ec832f1dp-56, -0x1.3520155c0f8a1p-26, 0x1.efb5e6c54cec6p-41, -0x1.15d61eadcf51ep-43,
     0x1.5ee9749cb7ecbp-45, -0x1.277dd7f67a108p-46, 0x1.224cd37fe31bdp-47, -0x1.3a4d923d228e3p-48,
     0x1.6beccf0b62414p-49, -0x1.bc72f47396905p-50, 0x1.18c3e2302dff4p-50},
     /* [257] 1.125 <= y <= 1.25 2^-28, degree 10, 86.0 bits */
    {0x1.20c3d432e576ep+0, 0x1.402419aa47415p-54, -0x1.351f23b1c70b4p-26, 0x1.d78de8f98aca8p-41, -0x1.de386c09e5137p-44,
     0x1.113c9273e7051p-45, -0x1.a0574a299f06cp-47, 0x1.721228a5b365p-48, -0x1.6a82c3ed636d6p-49, 0x1.7bc4a1d755226p-50,
     -0x1.a351ce690d29bp-51, 0x1.df4e5968a79dep-52}, /* [258] 1.25 <= y <= 1.375 2^-28, degree 10, 83.3 bits */
    {0x1.20c3d4293c817p+0, -0x1.f849503bfc67ep-54, -0x1.351e3d44fcc17p-26, 0x1.c29f1720c9405p-41,
     -0x1.a13a1e1a44256p-44, 0x1.b3504b173a6a3p-46, -0x1.2ecfde2d2046bp-47, 0x1.eb81d0c34b80bp-49,
     -0x1.b7997fb1c16c7p-50, 0x1.a47b0fd4c14bp-51, -0x1.a7ab0bc59c98cp-52, 0x1.ba26f0d373851p-53},
     /* [259] 1.375 <= y <= 1.5 2^-28, degree 10, 85.2 bits */
    {0x1.20c3d41f9392fp+0, 0x1.a4e9428a579f4p-54, -0x1.351d60a57f45bp-26, 0x1.b040dd15827efp-41, -0x1.702e41c65c5bap-44,
     0x1.616873df27671p-46, -0x1.c456cc4bc437bp-48, 0x1.51bc91d1bc675p-49, -0x1.15e731865da58p-50,
     0x1.e91a36691b541p-52, -0x1.c5319b3ac48f4p-53, 0x1.b31e48152ff54p-54},
     /* [260] 1.5 <= y <= 1.625 2^-28, degree 10, 83.4 bits */
    {0x1.20c3d415eaab4p+0, 0x1.af3b246e9e157p-54, -0x1.351c8cab85fe3p-26, 0x1.9ff73c5655f8bp-41, -0x1.480b3c1c7905p-44,
     0x1.238e3b7fbe2f7p-46, -0x1.5987690866772p-48, 0x1.ddc0fdd4733acp-50, -0x1.6bfec110a750dp-51,
     0x1.28958e09c945bp-52, -0x1.fcbcf20c5cdcep-54, 0x1.c441e963460dep-55},
     /* [261] 1.625 <= y <= 1.75 2^-28, degree 10, 86.1 bits */
    {0x1.20c3d40c41ca1p+0, 0x1.d54a1b6c842ebp-54, -0x1.351bc06532712p-26, 0x1.9164b2dedab7p-41, -0x1.26b4616a6ed9p-44,
     0x1.e7b828a1410b4p-47, -0x1.0d1259663aae9p-48, 0x1.5a61544fc96c7p-50, -0x1.eb67cc57b9c83p-52,
     0x1.74c8db8c7a31ap-53, -0x1.2998235eb0fecp-54, 0x1.ec9cc5945b53dp-56},
     /* [262] 1.75 <= y <= 1.875 2^-28, degree 10, 83.7 bits */
    {0x1.20c3d40298ef3p+0, -0x1.02db669e54133p-55, -0x1.351afb09bb89cp-26, 0x1.84413988a27e6p-41,
     -0x1.0aa7549e52d64p-44, 0x1.9cd2eb3667f1dp-47, -0x1.aa1dcf84891a4p-49, 0x1.0093efa8347aep-50,
     -0x1.548509dff6ebcp-52, 0x1.e34f8156a0b66p-54, -0x1.68db75dcb8955p-55, 0x1.1764e11d63dccp-56},
     /* [263] 1.875 <= y <= 2 2^-28, degree 10, 84.8 bits */
    {0x1.20c3d3f41bb22p+0, 0x1.84a15f798c3fbp-56, -0x1.3519de8e9477dp-25, 0x1.72c3e0fd715fcp-39, -0x1.d050083036cd5p-42,
     0x1.47b36e99e1febp-43, -0x1.3467ea7245f4ap-44, 0x1.52a156423cddap-45, -0x1.99c232db684d1p-46,
     0x1.09221a6764c71p-46, -0x1.6a412da60fae7p-47, 0x1.ff8e3fe59376p-48},
     /* [264] 1 <= y <= 1.125 2^-27, degree 10, 86.8 bits */
    {0x1.20c3d3e0ca1f9p+0, 0x1.c6ec20f969b7ap-54, -0x1.35187613dc8efp-25, 0x1.5ebffa0025d88p-39, -0x1.88f989c5a63c9p-42,
     0x1.f04f7637d330ep-44, -0x1.a1eb4d0dc3548p-45, 0x1.9a92885242f44p-46, -0x1.bc8442ffbdf25p-47,
     0x1.0158d82a2d8c9p-47, -0x1.3a49aca1e30b6p-48, 0x1.8d1455975713cp-49},
     /* [265] 1.125 <= y <= 1.25 2^-27, degree 10, 82.6 bits */
    {0x1.20c3d3cd78a3p+0, -0x1.b4e41c19a6923p-55, -0x1.3517201542c7fp-25, 0x1.4daa9c0fa7d29p-39, -0x1.5233d291da867p-42,
     0x1.8273db390ceccp-44, -0x1.266ba2c1c8265p-45, 0x1.05b276c423608p-46, -0x1.00595af08c7e2p-47,
     0x1.0c8d12a0bd649p-48, -0x1.2884b8997fd3bp-49, 0x1.52efb049423dep-50},
     /* [266] 1.25 <= y <= 1.375 2^-27, degree 10, 82.9 bits */
    {0x1.20c3d3ba273b4p+0, -0x1.f456156c6a273p-59, -0x1.3515d9fca52dfp-25, 0x1.3edcc8ac10fa1p-39, -0x1.2711bdf50f6p-42,
     0x1.33d838e908599p-44, -0x1.ac46957be272cp-46, 0x1.5b92801391843p-47, -0x1.36dcf768e397ep-48,
     0x1.29576e8c1c1c1p-49, -0x1.2b981e19afc5p-50, 0x1.38a9f7ed3f357p-51},
     /* [267] 1.375 <= y <= 1.5 2^-27, degree 10, 84.6 bits */
    {0x1.20c3d3a6d5e77p+0, 0x1.9125516565383p-55, -0x1.3514a1c14266fp-25, 0x1.31df49682020ep-39, -0x1.04627bd31b657p-42,
     0x1.f3d8f93dbcbcap-45, -0x1.3fe112f86d62fp-46, 0x1.ddaa9ce678c2fp-48, -0x1.890a2dbba636p-49, 0x1.59de326202089p-50,
     -0x1.4079498c431fcp-51, 0x1.33b0cfc85542p-52}, /* [268] 1.5 <= y <= 1.625 2^-27, degree 10, 82.7 bits */
    {0x1.20c3d39384a6cp+0, 0x1.9b1fc196a7e09p-54, -0x1.351375c0c2389p-25, 0x1.265a6f0fba0bep-39, -0x1.d000512c29403p-43,
     0x1.9c5e10c907207p-45, -0x1.e8b1e3ef43bc7p-47, 0x1.51d93bbb73facp-48, -0x1.0166968c7257fp-49,
     0x1.a3758306fdfe4p-51, -0x1.67c09edda7bf3p-52, 0x1.3fcfa7a279e7cp-53},
     /* [269] 1.625 <= y <= 1.75 2^-27, degree 10, 82.4 bits */
    {0x1.20c3d38033788p+0, 0x1.f557983f1c7cep-57, -0x1.351254a50d35fp-25, 0x1.1c0c19705cb0fp-39, -0x1.a0d8da4d9581dp-43,
     0x1.58e8bfdb1cb71p-45, -0x1.7c8f45592cebep-47, 0x1.e9e4dc5a4c72ep-49, -0x1.5b80171113b84p-50, 0x1.079d7ed03c1ep-51,
     -0x1.a4e2f056a0265p-53, 0x1.5c593b4f6743bp-54}, /* [270] 1.75 <= y <= 1.875 2^-27, degree 10, 83.6 bits */
    {0x1.20c3d36ce25cp+0, -0x1.2e167695a2bbbp-55, -0x1.35113d5227195p-25, 0x1.12c158ebca5cbp-39, -0x1.792c21beecb09p-43,
     0x1.23f1f5b99e86ap-45, -0x1.2d569e52dc396p-47, 0x1.6ae2a59542b64p-49, -0x1.e19a2d7af416ep-51,
     0x1.55c649cb73dfdp-52, -0x1.fe5c2e79c99bap-54, 0x1.8b2528ce9955p-55},
     /* [271] 1.875 <= y <= 2 2^-27, degree 10, 82.6 bits */
    {0x1.20c3d34fe8d14p+0, 0x1.5d1e01475bed9p-55, -0x1.350faaaddbfadp-24, 0x1.0662ceed82bd6p-37, -0x1.486140f171ce3p-40,
     0x1.cf7f1ec8a6448p-42, -0x1.b431f0f072687p-43, 0x1.deefa662278bep-44, -0x1.21c3d38623443p-44, 0x1.76fb0fe558b8p-45,
     -0x1.002b3c9e1ca29p-45, 0x1.69beef2c1de5ep-46}, /* [272] 1 <= y <= 1.125 2^-26, degree 10, 81.3 bits */
    {0x1.20c3d32946fc2p+0, -0x1.00081d8078201p-54, -0x1.350dac74cd603p-24, 0x1.f075eefbf2907p-38,
     -0x1.15ee12f41e2dep-40, 0x1.5efd90a677208p-42, -0x1.278b60aa99997p-43, 0x1.22583796779bfp-44,
     -0x1.3a5887b713d36p-45, 0x1.6bf8576ffca65p-46, -0x1.bc7ff282cb30fp-47, 0x1.18cb8b01d42e8p-47},
     /* [273] 1.125 <= y <= 1.25 2^-26, degree 10, 81.9 bits */
    {0x1.20c3d302a5651p+0, -0x1.f7256fe266664p-57, -0x1.350bc8614a107p-24, 0x1.d84bce7db45b4p-38,
     -0x1.de63c8090a8eap-41, 0x1.114d097632dfbp-42, -0x1.a06b5725c07ccp-44, 0x1.72216d524d4c2p-45,
     -0x1.6a900e290fbc4p-46, 0x1.7bd14937f4068p-47, -0x1.a35eb212a68e3p-48, 0x1.df5c1936e4103p-49},
     /* [274] 1.25 <= y <= 1.375 2^-26, degree 10, 81.4 bits */
    {0x1.20c3d2dc04091p+0, 0x1.04c061366c31ap-54, -0x1.3509facacc441p-24, 0x1.c35b0b9118578p-38, -0x1.a161b7e332979p-41,
     0x1.b36bc01b704aep-43, -0x1.2edf21c9a4eb5p-44, 0x1.eb970a4f7ee18p-46, -0x1.b7aa5de82f102p-47, 0x1.a489b9c8ac0bp-48,
     -0x1.a7b8ad5fb82a4p-49, 0x1.ba34376aed0d4p-50}, /* [275] 1.375 <= y <= 1.5 2^-26, degree 10, 85.5 bits */
    {0x1.20c3d2b562e59p+0, -0x1.2adba8110c252p-54, -0x1.350840d0c3e24p-24, 0x1.b0fb09c97cf21p-38,
     -0x1.7052b326a147bp-41, 0x1.617fb24fa3ad6p-43, -0x1.c46e92ce93ba9p-45, 0x1.51cbc6de9601dp-46,
     -0x1.15f24fe7f2a6p-47, 0x1.e92bff5928f3ep-49, -0x1.c540cf7f3d7a5p-50, 0x1.b32be7774001p-51},
     /* [276] 1.5 <= y <= 1.625 2^-26, degree 10, 81.6 bits */
    {0x1.20c3d28ec1f82p+0, 0x1.dfffad7a20b52p-54, -0x1.3506982379b0bp-24, 0x1.a0afc44847407p-38, -0x1.482cfcb876e39p-41,
     0x1.23a229ec59bcep-43, -0x1.599a496008d74p-45, 0x1.ddd7598a1f489p-47, -0x1.6c0de3e32763ep-48,
     0x1.28a0c3733f672p-49, -0x1.fcceaf5ab4c72p-51, 0x1.c450a0cba2e3fp-52},
     /* [277] 1.625 <= y <= 1.75 2^-26, degree 10, 88.9 bits */
    {0x1.20c3d268213eep+0, -0x1.cba342747d335p-56, -0x1.3504fedf1059ep-24, 0x1.921bb4096f693p-38,
     -0x1.26d3d02907864p-41, 0x1.e7dab7e9081e5p-44, -0x1.0d2195d5301fbp-45, 0x1.5a7221866596ap-47,
     -0x1.eb7cfa4c92df1p-49, 0x1.74d775b887482p-50, -0x1.29a2e4d4cbba9p-51, 0x1.ecad62e3f1a58p-53},
     /* [278] 1.75 <= y <= 1.875 2^-26, degree 10, 81.6 bits */
    {0x1.20c3d24180b7ep+0, -0x1.e7d9b804d609fp-55, -0x1.35037371d9cbbp-24, 0x1.84f6cde71da4bp-38,
     -0x1.0ac4be0ab6358p-41, 0x1.9cf12b0638c78p-44, -0x1.aa36d29421eacp-46, 0x1.009da0a3d0cf4p-47,
     -0x1.53db750bfaee5p-49, 0x1.17fed1f776c08p-50, -0x1.010eb6b4eb89bp-50, -0x1.18200fce7a188p-46},
     /* [279] 1.875 <= y <= 2 2^-26, degree 10, 84.3 bits */
    {0x1.20c3d20790481p+0, 0x1.04ad0005143b2p-58, -0x1.3501396cadfbbp-23, 0x1.73777bef67d45p-36, -0x1.d085af0ced909p-39,
     0x1.47cc958bffcb6p-40, -0x1.347ad48f62f3p-41, 0x1.52b3207bdc4abp-42, -0x1.99d55358fdf03p-43, 0x1.092d59c7c05f4p-43,
     -0x1.6a4f5a16a3485p-44, 0x1.ffa0ed7ab4874p-45}, /* [280] 1 <= y <= 1.125 2^-25, degree 10, 81.5 bits */
    {0x1.20c3d1ba5054dp+0, 0x1.72bde4436c4b2p-54, -0x1.34fe67127452ep-23, 0x1.5f713422991afp-36, -0x1.89299025302dfp-39,
     0x1.f077be94f1391p-41, -0x1.a206674f5c99ep-42, 0x1.9aa956f7f3719p-43, -0x1.bc9a338ed5171p-44,
     0x1.016463456f181p-44, -0x1.3a56ad8adab76p-45, 0x1.8d23aa6562752p-46},
     /* [281] 1.125 <= y <= 1.25 2^-25, degree 10, 81.4 bits */
    {0x1.20c3d16d11117p+0, 0x1.880e05e136d5dp-55, -0x1.34fbb9b4f9a75p-23, 0x1.4e59b2254d73bp-36, -0x1.525f4a83452b6p-39,
     0x1.8294d71978455p-41, -0x1.267fb68f42374p-42, 0x1.05c1bff3f13b4p-43, -0x1.0066a8b60726dp-44,
     0x1.0c99bd1ad9a12p-45, -0x1.28919f34fa50ep-46, 0x1.52fd730d552ccp-47},
     /* [282] 1.25 <= y <= 1.375 2^-25, degree 10, 80.9 bits */
    {0x1.20c3d11fd2755p+0, 0x1.5a036668a41dbp-54, -0x1.34f92c278c277p-23, 0x1.3f89ec686553p-36, -0x1.2739721446325p-39,
     0x1.33f3b9e45cccfp-41, -0x1.ac652776b0b24p-43, 0x1.5ba7c0208e334p-44, -0x1.36edda4782fb6p-45,
     0x1.29661c39c47cbp-46, -0x1.2ba5c2eee3606p-47, 0x1.38b7417be6e1ep-48},
     /* [283] 1.375 <= y <= 1.5 2^-25, degree 10, 82.1 bits */
    {0x1.20c3d0d294791p+0, 0x1.562dbdc822757p-66, -0x1.34f6ba584e632p-23, 0x1.328aa434a7f39p-36, -0x1.04870623c6c89p-39,
     0x1.f4078b08ae5dfp-42, -0x1.3ff8e222e4a13p-43, 0x1.ddc910a1a3377p-45, -0x1.892070d791873p-46,
     0x1.59effffe17693p-47, -0x1.4088818ac894bp-48, 0x1.33be72501aa4ep-49},
     /* [284] 1.5 <= y <= 1.625 2^-25, degree 10, 81.4 bits */
    {0x1.20c3d08557162p+0, -0x1.b63d16c209198p-58, -0x1.34f4610243b63p-23, 0x1.270423f6795b4p-36,
     -0x1.d04401d02a54ep-40, 0x1.9c860019b2decp-42, -0x1.e8d7b2c7e0d1p-44, 0x1.51ef9ebd5787ap-45,
     -0x1.0175bdd330bebp-46, 0x1.a38bf3ec95858p-48, -0x1.67d260a81f99dp-49, 0x1.3fde628cb1c1cp-50},
     /* [285] 1.625 <= y <= 1.75 2^-25, degree 10, 80.7 bits */
    {0x1.20c3d0381a46cp+0, -0x1.dffdd1418f3p-56, -0x1.34f21d78fc66p-23, 0x1.1cb44679e0874p-36, -0x1.a117e50921a7ep-40,
     0x1.590b5f96213c3p-42, -0x1.7cadc9f7c4ae7p-44, 0x1.ea06820f5a16dp-46, -0x1.5b954b6f4b53dp-47,
     0x1.07ac1d0e43adbp-48, -0x1.a4f878db97ea1p-50, 0x1.5c69dcb24023cp-51},
     /* [286] 1.75 <= y <= 1.875 2^-25, degree 10, 80.2 bits */
    {0x1.20c3cfeade05cp+0, 0x1.9d01addb4f186p-56, -0x1.34efed8447fb8p-23, 0x1.1368181fb1804p-36, -0x1.79671fe389f5p-40,
     0x1.2410443cd958ap-42, -0x1.2d6f9b59e5p-44, 0x1.6afc6b6036b5bp-46, -0x1.e1b890bc7bd0fp-48, 0x1.55d9e2a92f89ap-49,
     -0x1.fe772e704e94fp-51, 0x1.8b38aa8059a43p-52}, /* [287] 1.875 <= y <= 2 2^-25, degree 10, 81.3 bits */
    {0x1.20c3cf7704a53p+0, 0x1.de76a16b677b6p-55, -0x1.34ecc64a78227p-22, 0x1.0707933b15083p-34, -0x1.48971088443d8p-37,
     0x1.cfb1861a77ea7p-39, -0x1.b457d4aecc345p-40, 0x1.df13478c2a671p-41, -0x1.21d6fa2e3792p-41, 0x1.77119553f5b76p-42,
     -0x1.00396cfc4ccd8p-42, 0x1.69d1a1a330c19p-43}, /* [288] 1 <= y <= 1.125 2^-24, degree 10, 79.3 bits */
    {0x1.20c3cedc8f443p+0, -0x1.60be19a753d6p-54, -0x1.34e8c74a2589fp-22, 0x1.f1bab24a81dccp-35, -0x1.161e3f26762cdp-37,
     0x1.5f25ee3ed6cebp-39, -0x1.27a68686aa7a9p-40, 0x1.226f0ebf1f4p-41, -0x1.3a6e7fa9e680bp-42, 0x1.6c0f74d07e744p-43,
     -0x1.bc99fbdda0354p-44, 0x1.18dae40052b3bp-44}, /* [289] 1.125 <= y <= 1.25 2^-24, degree 10, 80.5 bits */
    {0x1.20c3ce421bd53p+0, 0x1.0077d57d8e64cp-54, -0x1.34e4fc9df6137p-22, 0x1.d98c46450b801p-35, -0x1.debafeacfc4f3p-38,
     0x1.116e1762dd472p-39, -0x1.a093909e1e3d4p-41, 0x1.72400b8eb063ap-42, -0x1.6aaab30634429p-43,
     0x1.7beaa659be064p-44, -0x1.a3788711102a1p-45, 0x1.df77a692cc349p-46},
     /* [290] 1.25 <= y <= 1.375 2^-24, degree 10, 80.1 bits */
    {0x1.20c3cda7aa401p+0, -0x1.a9064e5e6e202p-56, -0x1.34e15ef401ea6p-22, 0x1.c4979b6e8179ep-35,
     -0x1.a1b162b22bfc4p-38, 0x1.b3a2e134f75c3p-40, -0x1.2efdc1d994742p-41, 0x1.ebc19b7ec97bbp-43,
     -0x1.b7cc2fe7fa464p-44, 0x1.a4a71ef6cbb7bp-45, -0x1.a7d3ff91ba25p-46, 0x1.ba4ed25e870b8p-47},
     /* [291] 1.375 <= y <= 1.5 2^-24, degree 10, 82.8 bits */
    {0x1.20c3cd0d3a6fbp+0, 0x1.b6ad4d513abc6p-54, -0x1.34dde88a73003p-22, 0x1.b23404bed60d9p-35, -0x1.709c06b59e58cp-38,
     0x1.61ae5f4ac966p-40, -0x1.c49e47c89b9f2p-42, 0x1.51ea473dfc614p-43, -0x1.16089b5d32739p-44, 0x1.e94fa6e12251p-46,
     -0x1.c55f4951a69e3p-47, 0x1.b34734d6f4cb3p-48}, /* [292] 1.5 <= y <= 1.625 2^-24, degree 10, 80.6 bits */
    {0x1.20c3cc72cc51cp+0, -0x1.475a2c7b7468cp-58, -0x1.34da94c1422a5p-22, 0x1.a1e570927872bp-35,
     -0x1.4870e91905379p-38, 0x1.23ca3139e1591p-40, -0x1.59c02abc203b5p-42, 0x1.de0432b376c33p-44,
     -0x1.6c2c3e26d6d18p-45, 0x1.28b73c58259b5p-46, -0x1.fcf23ec37a262p-48, 0x1.c46e1fe26dfe1p-49},
     /* [293] 1.625 <= y <= 1.75 2^-24, degree 10, 81.4 bits */
    {0x1.20c3cbd85fd5dp+0, 0x1.3d37e1483c2f3p-55, -0x1.34d75fd032aeap-22, 0x1.934e4ddda0119p-35, -0x1.271313cd003a7p-38,
     0x1.e82022137f87cp-41, -0x1.0d4029ce8425ap-42, 0x1.5a93d605a20ap-44, -0x1.eba773e28ae87p-46, 0x1.74f4bceb757c3p-47,
     -0x1.29b874ba09872p-48, 0x1.ecceb06a844b4p-50}, /* [294] 1.75 <= y <= 1.875 2^-24, degree 10, 79.7 bits */
    {0x1.20c3cb3df4ed5p+0, 0x1.10b823f3c16aap-55, -0x1.34d44693784ddp-22, 0x1.86268974a08b3p-35, -0x1.0afff290c4521p-38,
     0x1.9d2dee4a5f13p-41, -0x1.aa68d68316923p-43, 0x1.00ba9f889e726p-44, -0x1.54b2a66e79c1ep-46, 0x1.e38a55137ccf2p-48,
     -0x1.6903fbb2788e7p-49, 0x1.178227ad1deb2p-50}, /* [295] 1.875 <= y <= 2 2^-24, degree 10, 79.5 bits */
    {0x1.20c3ca5657688p+0, 0x1.80bde97800a17p-55, -0x1.34cfcefffba1dp-21, 0x1.74a33dfc21978p-33, -0x1.d0f1b4545495cp-36,
     0x1.47ff1dd0b9a11p-37, -0x1.34a0cc8bc8b76p-38, 0x1.52d6d24b3a909p-39, -0x1.99fbb0d845f5p-40, 0x1.0943e7fe55ca6p-40,
     -0x1.6a6bc52ac3517p-41, 0x1.ffc65f47313c1p-42}, /* [296] 1 <= y <= 1.125 2^-23, degree 10, 80.1 bits */
    {0x1.20c3c9218a74ep+0, -0x1.89dbe197dde87p-55, -0x1.34ca25a64116ep-21, 0x1.60982c4804b28p-33,
     -0x1.898a471e851bep-36, 0x1.f0c8b0b9c771p-38, -0x1.a23cd145e7f8p-39, 0x1.9ad71b8d7d608p-40, -0x1.bcc636d53a26ap-41,
     0x1.017b8a0ef2a3p-41, -0x1.3a70c0cefe738p-42, 0x1.8d42676b1c728p-43},
     /* [297] 1.125 <= y <= 1.25 2^-23, degree 10, 78.9 bits */
    {0x1.20c3c7ecc3049p+0, 0x1.75f75c9975p-57, -0x1.34c4c6582f5f7p-21, 0x1.4f7c5a7b8a283p-33, -0x1.52b6d967db8c9p-36,
     0x1.82d7219b98b5bp-38, -0x1.26a8074a0cc9cp-39, 0x1.05e06db0fd46fp-40, -0x1.008159c93be29p-41,
     0x1.0cb324f860932p-42, -0x1.28ab7e6cedb9ep-43, 0x1.53190ab61d132p-44},
     /* [298] 1.25 <= y <= 1.375 2^-23, degree 10, 80.9 bits */
    {0x1.20c3c6b800d2fp+0, 0x1.f8a95429bc487p-54, -0x1.34bfa6baa91cap-21, 0x1.40a8a8d2f4e8fp-33, -0x1.27896fba2aec9p-36,
     0x1.342b033267c6ap-38, -0x1.aca28c3990c44p-40, 0x1.5bd2679e8c45bp-41, -0x1.370fbc53d77p-42, 0x1.29838e4a06bfap-43,
     -0x1.2bc12054e7a96p-44, 0x1.38d1e6bdd4cc3p-45}, /* [299] 1.375 <= y <= 1.5 2^-23, degree 10, 82.0 bits */
    {0x1.20c3c58343a4ap+0, -0x1.f2d22b7c6e86bp-55, -0x1.34babea886afbp-21, 0x1.33a5c7f1e12d6p-33,
     -0x1.04d0a7d83f9d7p-36, 0x1.f4652b23c7e64p-39, -0x1.4028b48b48d72p-40, 0x1.de06325dd7062p-42,
     -0x1.894d1d99d2cd1p-43, 0x1.5a13b7a8be7c2p-44, -0x1.40a7084558801p-45, 0x1.33d9ca9c8fa7ap-46},
     /* [300] 1.5 <= y <= 1.625 2^-23, degree 10, 82.8 bits */
    {0x1.20c3c44e8b455p+0, 0x1.31c41f980515cp-54, -0x1.34b607969c824p-21, 0x1.281bf577fefb1p-33, -0x1.d0cc6ea12f5c2p-37,
     0x1.9cd64c88a1fd4p-39, -0x1.e923a595b69dp-41, 0x1.521c90ddd0854p-42, -0x1.019427663e4abp-43, 0x1.a3b8faa931d5p-45,
     -0x1.67f5ff948b13fp-46, 0x1.3ffbedcc9b112p-47}, /* [301] 1.625 <= y <= 1.75 2^-23, degree 10, 78.1 bits */
    {0x1.20c3c319d786ep+0, 0x1.2a6594e05ce3fp-54, -0x1.34b17c2b063b2p-21, 0x1.1dc90223504e5p-33, -0x1.a196f91765be1p-37,
     0x1.595100bce786fp-39, -0x1.7ceb19c3b9849p-41, 0x1.ea4a1198d122cp-43, -0x1.5bbfdb088cf46p-44,
     0x1.07c9724767d5ap-45, -0x1.a523abfcdf984p-47, 0x1.5c8b38563c999p-48},
     /* [302] 1.75 <= y <= 1.875 2^-23, degree 10, 79.9 bits */
    {0x1.20c3c1e5283ffp+0, -0x1.f0c27ca1cda1cp-57, -0x1.34ad17f48206ep-21, 0x1.1479f249ad8dfp-33,
     -0x1.79de0f343881ep-37, 0x1.244d38d98404cp-39, -0x1.2da1d0a174f6fp-41, 0x1.6b302c79648a2p-43,
     -0x1.e1f590614db26p-45, 0x1.5601366bec7e1p-46, -0x1.fead5a3b4250cp-48, 0x1.8b5fcbd400e44p-49},
     /* [303] 1.875 <= y <= 2 2^-23, degree 10, 83.4 bits */
    {0x1.20c3c0162964fp+0, -0x1.ebb5cc8af0f7bp-54, -0x1.34a6c321ee6b2p-20, 0x1.08156f535efdp-31, -0x1.490393846336cp-34,
     0x1.d016eb4fc535cp-36, -0x1.b4a3f919972a4p-37, 0x1.df5ad67a41767p-38, -0x1.21fd6cca58643p-38,
     0x1.773ec8b62dcc7p-39, -0x1.0055e59b02fd7p-39, 0x1.69f7244dd429p-40},
     /* [304] 1 <= y <= 1.125 2^-22, degree 10, 79.0 bits */
    {0x1.20c3bdace3f7ep+0, 0x1.81bdebf5782c8p-54, -0x1.349ebcc6015b4p-20, 0x1.f3cccb5aeddb3p-32, -0x1.167f6a2ccacf7p-34,
     0x1.5f7726e444d8p-36, -0x1.27dd179e71f1fp-37, 0x1.229cf043cb588p-38, -0x1.3a9a9c30eb65bp-39, 0x1.6c3ddaf73dd6bp-40,
     -0x1.bcce3c53a2d5ep-41, 0x1.18f9af79da3bep-41}, /* [305] 1.125 <= y <= 1.25 2^-22, degree 10, 81.8 bits */
    {0x1.20c3bb43ae2c1p+0, -0x1.2c7f5cb2a8281p-54, -0x1.34971f36dbd28p-20, 0x1.db95b539ea48p-32, -0x1.df6af456497cep-35,
     0x1.11b09dabfa685p-36, -0x1.a0e46e31b3f81p-38, 0x1.727d8f4819d2p-39, -0x1.6ae034f82cff2p-40, 0x1.7c1d9216890e6p-41,
     -0x1.a3ac603a6627dp-42, 0x1.dfaef0d9ce277p-43}, /* [306] 1.25 <= y <= 1.375 2^-22, degree 10, 78.0 bits */
    {0x1.20c3b8da873fp+0, 0x1.8a09d154e5d9dp-55, -0x1.348fdbcd37a2bp-20, 0x1.c69928c2c33d1p-32, -0x1.a2522801c48a9p-35,
     0x1.b411dab2b981ep-37, -0x1.2f3b55e808762p-38, 0x1.ec172456440b9p-40, -0x1.b8101dc0a8a2ap-41, 0x1.a4e224add6cp-42,
     -0x1.a80ad79f9e3c6p-43, 0x1.ba8437d5fb378p-44}, /* [307] 1.375 <= y <= 1.5 2^-22, degree 10, 79.2 bits */
    {0x1.20c3b6716e888p+0, -0x1.b5c2e68f28b4ep-54, -0x1.3488e7028c963p-20, 0x1.b42e5789e7c4cp-32,
     -0x1.71300821e1054p-35, 0x1.620c590863c47p-37, -0x1.c4fe38824f873p-39, 0x1.522793b85309cp-40,
     -0x1.16356482896dfp-41, 0x1.e997403eddbabp-43, -0x1.c59c7874fcfddp-44, 0x1.b37e01fc41f6ep-45},
     /* [308] 1.5 <= y <= 1.625 2^-22, degree 10, 78.0 bits */
    {0x1.20c3b4086374cp+0, 0x1.2c03030a48cf1p-54, -0x1.34823794657a5p-20, 0x1.a3d9163e63d1ep-32, -0x1.48fa096a5d502p-35,
     0x1.241acc9314e9cp-37, -0x1.5a0c5b7da0f43p-39, 0x1.de5e579737f7bp-41, -0x1.6c693910131cbp-42,
     0x1.28e45e58925a8p-43, -0x1.fd39a510e90e8p-45, 0x1.c4a95623ad8cdp-46},
     /* [309] 1.625 <= y <= 1.75 2^-22, degree 10, 78.2 bits */
    {0x1.20c3b19f6581p+0, -0x1.421d4a1139b8cp-55, -0x1.347bc5f03d193p-20, 0x1.953bbfa83cca9p-32, -0x1.2792d20fb95cep-35,
     0x1.e8abf09627ffcp-38, -0x1.0d7dace5ed94fp-39, 0x1.5ad7976999d26p-41, -0x1.ebfccc3591e1ap-43,
     0x1.752f8bd88efcep-44, -0x1.29e3c10ddc0fep-45, 0x1.ed118c882c918p-47},
     /* [310] 1.75 <= y <= 1.875 2^-22, degree 10, 79.1 bits */
    {0x1.20c3af3674381p+0, -0x1.c39896174ccb5p-54, -0x1.34758bccb76afp-20, 0x1.880e3078898e4p-32,
     -0x1.0b7783cb7e24cp-35, 0x1.9da8550a3537ap-38, -0x1.aacd9714da1abp-40, 0x1.00ee87c0ac113p-41,
     -0x1.54efd00687c14p-43, 0x1.e3d92ebac8a6fp-45, -0x1.693a47e24b0cep-46, 0x1.17a95f27f0136p-47},
     /* [311] 1.875 <= y <= 2 2^-22, degree 10, 78.2 bits */
    {0x1.20c3ab992126bp+0, -0x1.49af53ee23ac3p-54, -0x1.346c9150477bep-19, 0x1.7682dddec66f8p-30,
     -0x1.d1cbe85551fd1p-33, 0x1.4864eeb27724ep-34, -0x1.34ed3454bad21p-35, 0x1.531e9923f2fa2p-36,
     -0x1.9a48ccc2b50bap-37, 0x1.0971392f88c16p-37, -0x1.6aa4d9a365026p-38, 0x1.0008c8486e3bp-38},
     /* [312] 1 <= y <= 1.125 2^-21, degree 10, 78.6 bits */
    {0x1.20c3a6c785dap+0, -0x1.0d6d27c0a410fp-55, -0x1.34612fc73c1e7p-19, 0x1.626e1f79d5d2ap-30, -0x1.8a4db2ab5873ap-33,
     0x1.f16bd4fda6ef4p-35, -0x1.a2aa57d5709d4p-36, 0x1.9b33293361255p-37, -0x1.bd1eb13a13828p-38,
     0x1.01aa10157ada2p-38, -0x1.3aa522f60a1ccp-39, 0x1.8d8023fc07497p-40},
     /* [313] 1.125 <= y <= 1.25 2^-21, degree 10, 76.1 bits */
    {0x1.20c3a1f616e2ep+0, 0x1.047dcdd0471e5p-56, -0x1.3456629eed1dcp-19, 0x1.5149970eb157p-30, -0x1.5367cffd824fp-33,
     0x1.835cc5a8ab24fp-35, -0x1.26f931dce76f8p-36, 0x1.061e253e33b8ap-37, -0x1.00b704d1550bfp-38,
     0x1.0ce634fd8cedfp-39, -0x1.28df7a46c897ep-40, 0x1.53507809b73d3p-41},
     /* [314] 1.25 <= y <= 1.375 2^-21, degree 10, 77.7 bits */
    {0x1.20c39d24d21b1p+0, -0x1.daa2f21e12934p-54, -0x1.344c151a2af36p-19, 0x1.426df8265df65p-30,
     -0x1.282b2469eebc4p-33, 0x1.349a7ed3ba6e3p-35, -0x1.ad1e2d540981fp-37, 0x1.5c283ae0d09c4p-38,
     -0x1.3753e010ed953p-39, 0x1.29bebf791fef1p-40, -0x1.2bf81e5399a16p-41, 0x1.39076f372f6a9p-42},
     /* [315] 1.375 <= y <= 1.5 2^-21, degree 10, 79.5 bits */
    {0x1.20c39853b5a5cp+0, 0x1.13f6056d9e3b3p-54, -0x1.344236e8e796cp-19, 0x1.3563d1e0ba8bep-30, -0x1.05658979286a1p-33,
     0x1.f522010811702p-36, -0x1.4089063ecd6c9p-37, 0x1.de81392785f38p-39, -0x1.89a6f91a9f5ddp-40,
     0x1.5a5b875f24decp-41, -0x1.40e4630bc1c97p-42, 0x1.3410bcce7bceep-43},
     /* [316] 1.5 <= y <= 1.625 2^-21, degree 10, 76.4 bits */
    {0x1.20c39382bfe0ep+0, 0x1.9a8c87b781174p-54, -0x1.3438baeff86c1p-19, 0x1.29d3481688857p-30, -0x1.d1e05524ec152p-34,
     0x1.9d784a44879cdp-36, -0x1.e9bca53312fedp-38, 0x1.527708b6ee072p-39, -0x1.01d155892272fp-40,
     0x1.a413851ae01f4p-42, -0x1.683d9a40a1d8fp-43, 0x1.40374d3b5094bp-44},
     /* [317] 1.625 <= y <= 1.75 2^-21, degree 10, 76.3 bits */
    {0x1.20c38eb1ef59bp+0, -0x1.1a6245b1aab83p-55, -0x1.342f967778418p-19, 0x1.1f7a1744f6d94p-30,
     -0x1.a298040fad59cp-34, 0x1.59dd7fcf8afcap-36, -0x1.7d66a2b510803p-38, 0x1.ead214392120fp-40,
     -0x1.5c157ce31973ep-41, 0x1.08047049f6bc2p-42, -0x1.a57a85d376733p-44, 0x1.5cce442dde786p-45},
     /* [318] 1.75 <= y <= 1.875 2^-21, degree 10, 77.3 bits */
    {0x1.20c389e142c47p+0, -0x1.9d17abdf140a6p-55, -0x1.3426c09957f6ap-19, 0x1.1625338db41cap-30,
     -0x1.7aceab3e9d32cp-34, 0x1.24c83d750c336p-36, -0x1.2e06fe9c0b267p-38, 0x1.6b986a045d99cp-40,
     -0x1.e2732caa06db8p-42, 0x1.55d3f0f6edb1cp-43, -0x1.f3810e1cf0bebp-45, 0x1.c2eec3c8ab504p-45},
     /* [319] 1.875 <= y <= 2 2^-21, degree 10, 77.2 bits */
    {0x1.20c382a880c3cp+0, 0x1.c79196a33e5a1p-54, -0x1.341a031e5634dp-18, 0x1.09b89cae4d735p-28, -0x1.49df25b88a2d9p-31,
     0x1.d0e39b5dcc914p-33, -0x1.b53d73f605edfp-34, 0x1.dfeaf33db8cfbp-35, -0x1.224acef78bf47p-35,
     0x1.7799b7edf34b7p-36, -0x1.008f27a5de03cp-36, 0x1.6a428ec5d351p-37},
     /* [320] 1 <= y <= 1.125 2^-20, degree 10, 75.4 bits */
    {0x1.20c37907f1dcdp+0, 0x1.b8d3066615e93p-54, -0x1.3409dc82f74dbp-18, 0x1.f6ffad56f1ddfp-29, -0x1.1744152b289f6p-31,
     0x1.601b2b3f23b57p-33, -0x1.284b1d8c14c16p-34, 0x1.22f95d34b581ep-35, -0x1.3af36a61fd6dcp-36,
     0x1.6c9b3905f516ap-37, -0x1.bd375789a5d6cp-38, 0x1.19379cb0d0947p-38},
     /* [321] 1.125 <= y <= 1.25 2^-20, degree 10, 75.6 bits */
    {0x1.20c36f67e0cbep+0, 0x1.7dd143b892965p-54, -0x1.33fa8814ecc59p-18, 0x1.deb70d437d238p-29, -0x1.e0cf2cebeb17ap-32,
     0x1.1236fef4c424ap-33, -0x1.a187866793517p-35, 0x1.72f98291746a5p-36, -0x1.6b4bf445495b5p-37,
     0x1.7c840f5936bdfp-38, -0x1.a414b14593671p-39, 0x1.e01e25f57b763p-40},
     /* [322] 1.25 <= y <= 1.375 2^-20, degree 10, 75.3 bits */
    {0x1.20c365c84779ep+0, 0x1.dbf2f67f287fap-54, -0x1.33ebe877ad4e4p-18, 0x1.c9aa8bd161f72p-29, -0x1.a397b10001dbp-32,
     0x1.b4f216674d8d7p-34, -0x1.2fb79003b62e4p-35, 0x1.ecc38861104ccp-37, -0x1.b898ef1634f06p-38,
     0x1.a558f697b3acfp-39, -0x1.a8793535c6d53p-40, 0x1.baefa30346c8ep-41},
     /* [323] 1.375 <= y <= 1.5 2^-20, degree 10, 75.6 bits */
    {0x1.20c35c2920a04p+0, -0x1.363dcb5df5122p-54, -0x1.33dde6929a6d2p-18, 0x1.b731173bff0d1p-29,
     -0x1.725bc53a5292bp-32, 0x1.62ca4892c4d7dp-34, -0x1.c5bfd0ccf28ebp-36, 0x1.52a3262d6a3d8p-37,
     -0x1.168f9d88f4d4fp-38, 0x1.ea276af7af3a7p-40, -0x1.c6179e22480e7p-41, 0x1.b3ec45c3e14e9p-42},
     /* [324] 1.5 <= y <= 1.625 2^-20, degree 10, 77.5 bits */
    {0x1.20c3528a679dfp+0, 0x1.37b9d660919c1p-58, -0x1.33d06fd714aap-18, 0x1.a6ce5063f3576p-29, -0x1.4a0fc8cb84209p-32,
     0x1.24bdc16b78ba1p-34, -0x1.5aa6226f6443ep-36, 0x1.df141a0199be8p-38, -0x1.6ce4180dfba41p-39,
     0x1.293f42f7434b5p-40, -0x1.fdc960d65f285p-42, 0x1.c5207eeb327b4p-43},
     /* [325] 1.625 <= y <= 1.75 2^-20, degree 10, 75.2 bits */
    {0x1.20c348ec18586p+0, 0x1.9e2c615a4bc68p-55, -0x1.33c37517cc356p-18, 0x1.9824695b8f1efp-29, -0x1.289598d558896p-32,
     0x1.e9c6a452d6d6ap-35, -0x1.0df9da76ea65dp-36, 0x1.5b603c350b505p-38, -0x1.eca8cb5808e96p-40,
     0x1.75a6004a751d5p-41, -0x1.2a3aee7817a81p-42, 0x1.ed981edc61c86p-44},
     /* [326] 1.75 <= y <= 1.875 2^-20, degree 10, 78.1 bits */
    {0x1.20c33f4e2f23ap+0, -0x1.6ae431e185e0dp-54, -0x1.33b6e9bae7213p-18, 0x1.8aeb1e40eeb81p-29,
     -0x1.0c69c1cd7d4b1p-32, 0x1.9e9fe4c85c36p-35, -0x1.ab99069d70851p-37, 0x1.01573b67c7dddp-38,
     -0x1.556b187a9be01p-40, 0x1.e47808895b03p-42, -0x1.69a79f41a5bf2p-43, 0x1.17f8511ea0937p-44},
     /* [327] 1.875 <= y <= 2 2^-20, degree 10, 75.9 bits */
    {0x1.20c330e2098bbp+0, -0x1.22f2b4b1a83bep-54, -0x1.33a4d2c9f68cap-17, 0x1.794f87aa06e9ep-27,
     -0x1.d3860d05791bep-30, 0x1.4932ec383b0eep-31, -0x1.35878622aec76p-32, 0x1.53af6addda34fp-33,
     -0x1.9ae443b780541p-34, 0x1.09cc8a57366e6p-34, -0x1.6b17d1ee0f621p-35, 0x1.00547b4f15e0ap-35},
     /* [328] 1 <= y <= 1.125 2^-19, degree 10, 74.6 bits */
    {0x1.20c31da87586ap+0, 0x1.a4914f74b2048p-54, -0x1.338de38cfb1a7p-17, 0x1.65272e5cedf8bp-27, -0x1.8bd9bd2b3b334p-30,
     0x1.f2b604d1ec345p-32, -0x1.a387a2921af9ep-33, 0x1.9becf3a6c8a7ap-34, -0x1.bdd1224246978p-35,
     0x1.0207d6917e878p-35, -0x1.3b0ead19f2d74p-36, 0x1.8dfc7ab16caefp-37},
     /* [329] 1.125 <= y <= 1.25 2^-19, degree 10, 74.5 bits */
    {0x1.20c30a7046e76p+0, -0x1.5ce78eb3d9b2dp-54, -0x1.33781e3b0b2d7p-17, 0x1.53f0fd0f42999p-27,
     -0x1.54ce7de3c2edfp-30, 0x1.846b582cb736ap-32, -0x1.279d3db3a33d6p-33, 0x1.069abf0e2447ep-34,
     -0x1.0123496a4ca8fp-35, 0x1.0d4d28c70b762p-36, -0x1.29483d3e473f4p-37, 0x1.53c020ba0a8d1p-38},
     /* [330] 1.25 <= y <= 1.375 2^-19, degree 10, 75.1 bits */
    {0x1.20c2f7396c69cp+0, -0x1.8283596fea07fp-54, -0x1.3363593d9e405p-17, 0x1.45054cf644cbap-27, -0x1.2972ed1cea8bp-30,
     0x1.357c47140e9a8p-32, -0x1.ae181eec27202p-34, 0x1.5cd58d3fad34p-35, -0x1.37dd5fb985294p-36, 0x1.2a361eff80f28p-37,
     -0x1.2c66f8312bcf6p-38, 0x1.39734d90a883fp-39}, /* [331] 1.375 <= y <= 1.5 2^-19, degree 10, 76.8 bits */
    {0x1.20c2e403d7183p+0, -0x1.10515a9bb0101p-54, -0x1.334f73dd53ccfp-17, 0x1.37ec6972f6139p-27,
     -0x1.069358295ae56p-30, 0x1.f6a08ea2eca7cp-33, -0x1.414bcf1e861dcp-34, 0x1.df79bcbb838eap-36,
     -0x1.8a5c574f0880cp-37, 0x1.5aec62ae54c86p-38, -0x1.4160174f5161cp-39, 0x1.347f7a3152941p-40},
     /* [332] 1.5 <= y <= 1.625 2^-19, degree 10, 74.3 bits */
    {0x1.20c2d0cf79d28p+0, 0x1.4238a0010fe46p-61, -0x1.333c53d049c81p-17, 0x1.2c4e423f46f6ep-27, -0x1.d40fa6d2cf7bep-31,
     0x1.9ec08ca6a1b34p-33, -0x1.eaf221f58fbe2p-35, 0x1.532dd337aa892p-36, -0x1.024cd9532520bp-37,
     0x1.a4ca32aa269cep-39, -0x1.68ce00bf6cba9p-40, 0x1.40aefcde0d0a7p-41},
     /* [333] 1.625 <= y <= 1.75 2^-19, degree 10, 77.4 bits */
    {0x1.20c2bd9c48f51p+0, -0x1.613f7193d09a9p-55, -0x1.3329e3960cdb4p-17, 0x1.21e86ae200216p-27,
     -0x1.a4a11df842331p-31, 0x1.5afa460183c79p-33, -0x1.7e6095c8f7c2fp-35, 0x1.ebe4f3a750523p-37,
     -0x1.5cc267fa4045cp-38, 0x1.087b7cfd6ac93p-39, -0x1.a629b4aed174fp-41, 0x1.5d55727b89a89p-42},
     /* [334] 1.75 <= y <= 1.875 2^-19, degree 10, 76.2 bits */
    {0x1.20c2aa6a3a15cp+0, -0x1.aa7b6cbcd778p-55, -0x1.331811542085fp-17, 0x1.1887b6b4eefcp-27, -0x1.7cb6751185738p-31,
     0x1.25c1a5654a7f3p-33, -0x1.2ed3c2d340b9ep-35, 0x1.6c6b05c34b035p-37, -0x1.e36839c70b08fp-39,
     0x1.56effb228c3e9p-40, -0x1.fff604e2a8d55p-42, 0x1.8c4d132ce272dp-43},
     /* [335] 1.875 <= y <= 2 2^-19, degree 10, 75.4 bits */
    {0x1.20c28da12f36p+0, -0x1.f6a96576fe792p-54, -0x1.32fe5de953916p-16, 0x1.0c0abf9573cccp-25, -0x1.4b9c46905c4d1p-28,
     0x1.d282b9d5fb121p-30, -0x1.b67429e2fa16bp-31, 0x1.e10e59e9c493ep-32, -0x1.22e7260b91384p-32,
     0x1.78515132cfa5dp-33, -0x1.0102b30f35cf7p-33, 0x1.6adaad63fff4fp-34},
     /* [336] 1 <= y <= 1.125 2^-18, degree 10, 74.1 bits */
    {0x1.20c26743719fap+0, 0x1.613221e839ef2p-56, -0x1.32ddc7afce11dp-16, 0x1.fb7c7a1991839p-26, -0x1.18d2c0c24e0d6p-28,
     0x1.6167efd99aa78p-30, -0x1.2929f06253139p-31, 0x1.23b452c3bcaccp-32, -0x1.3ba6e59acb849p-33,
     0x1.6d57ccae31a8cp-34, -0x1.be0b83e7d793p-35, 0x1.19b490cf934acp-35},
     /* [337] 1.125 <= y <= 1.25 2^-18, degree 10, 73.3 bits */
    {0x1.20c240e9abb38p+0, 0x1.568268413e086p-54, -0x1.32bed8280a767p-16, 0x1.e3104cccd6fb2p-26, -0x1.e3a133b1a30bcp-29,
     0x1.1347bb377ba3ap-30, -0x1.a2d1f3617987bp-32, 0x1.73f4533bb0a2p-33, -0x1.6c25ca6d15c87p-34, 0x1.7d532073cca66p-35,
     -0x1.a4e7564102ae9p-36, 0x1.e0fe9b7223955p-37}, /* [338] 1.25 <= y <= 1.375 2^-18, degree 10, 74.6 bits */
    {0x1.20c21a93ac72p+0, 0x1.09c340316b464p-54, -0x1.32a154603154bp-16, 0x1.cde3740880063p-26, -0x1.a62b6dacc2369p-29,
     0x1.b6b955621041ap-31, -0x1.30b353c0244d7p-32, 0x1.ee207ad466212p-34, -0x1.b9ada0eb455bp-35, 0x1.a649186cefb51p-36,
     -0x1.a95821817cce2p-37, 0x1.bbc88242f48b8p-38}, /* [339] 1.375 <= y <= 1.5 2^-18, degree 10, 75.9 bits */
    {0x1.20c1f44149655p+0, 0x1.d4de422662616p-54, -0x1.32850df81cb4dp-16, 0x1.bb4c5590ed4ecp-26, -0x1.74bb20826501p-29,
     0x1.644c029414e33p-31, -0x1.c748490576275p-33, 0x1.539d5a9771027p-34, -0x1.174621756a16bp-35,
     0x1.eb4adb2d51935p-37, -0x1.c7106ca714d97p-38, 0x1.b4caf2d09e94ep-39},
     /* [340] 1.5 <= y <= 1.625 2^-18, degree 10, 75.4 bits */
    {0x1.20c1cdf25d4a9p+0, 0x1.9a70071732a29p-55, -0x1.3269dfab21bc9p-16, 0x1.aace2944d6835p-26, -0x1.4c42799688a5bp-29,
     0x1.2608c7b9caad1p-31, -0x1.5bddf8bd69d07p-33, 0x1.e0843985cae55p-35, -0x1.6ddcb8c6706b5p-36,
     0x1.29f70d804781dp-37, -0x1.feebd9c22b7b6p-39, 0x1.c611315062ff1p-40},
     /* [341] 1.625 <= y <= 1.75 2^-18, degree 10, 74.0 bits */
    {0x1.20c1a7a6c715cp+0, 0x1.ecd3cce6dea96p-56, -0x1.324faafd07a33p-16, 0x1.9c0aceac3d31cp-26, -0x1.2aa1bede49702p-29,
     0x1.ec050e06df137p-32, -0x1.0ef5bc22f3206p-33, 0x1.5c750e6c5d9cdp-35, -0x1.ee04ea3ef979bp-37,
     0x1.769595202a54dp-38, -0x1.2aeb26a3761bdp-39, 0x1.eea8031e45c81p-41},
     /* [342] 1.75 <= y <= 1.875 2^-18, degree 10, 73.8 bits */
    {0x1.20c1815e69342p+0, 0x1.1c8406fb582bfp-54, -0x1.3236569d1faep-16, 0x1.8eb9bfd5062dbp-26, -0x1.0e544e76fe82ap-29,
     0x1.a09704de642d6p-32, -0x1.ad35c69bb21c3p-34, 0x1.022b65392166bp-35, -0x1.5664ae00c5b1ep-37,
     0x1.e5b9645b5fbabp-39, -0x1.6a84b1657c884p-40, 0x1.1897dab55d5c1p-41},
     /* [343] 1.875 <= y <= 2 2^-18, degree 10, 73.1 bits */
    {0x1.20c147f7ac54fp+0, 0x1.29fa2bee3250dp-54, -0x1.3211ceed5598ep-15, 0x1.7cfd3a7b9c977p-24, -0x1.d70515f9514a4p-27,
     0x1.4ad5b0b8320b4p-28, -0x1.36c0bb12e72f5p-29, 0x1.54d4f959348f3p-30, -0x1.9c1f1ae44e85fp-31,
     0x1.0a85563398f09p-31, -0x1.6c0057fc807cdp-32, 0x1.00ed8199b222ap-32},
     /* [344] 1 <= y <= 1.125 2^-17, degree 10, 74.6 bits */
    {0x1.20c0fb791056ep+0, -0x1.8bff614b7223ep-56, -0x1.31e37d438cea1p-15, 0x1.68ad33e846753p-24,
     -0x1.8efb08a436ba8p-27, 0x1.f5558312c52b4p-29, -0x1.a548f4cdb5d52p-30, 0x1.9d65b7a01acadp-31,
     -0x1.bf3aa75f077b6p-32, 0x1.02c5af5117edfp-32, -0x1.3be435cb0595cp-33, 0x1.8ef7ec1b1d214p-34},
     /* [345] 1.125 <= y <= 1.25 2^-17, degree 10, 72.7 bits */
    {0x1.20c0af05bbb96p+0, -0x1.c61eade0baae6p-55, -0x1.31b78424009e3p-15, 0x1.57534a2116253p-24,
     -0x1.57a3cb12a7204p-27, 0x1.8691c58cc608ep-29, -0x1.28ea73e62d9f3p-30, 0x1.07978530ae608p-31,
     -0x1.01feb7c34229p-32, 0x1.0e1da910cb638p-33, -0x1.2a1c463d886acp-34, 0x1.54a201f199538p-35},
     /* [346] 1.25 <= y <= 1.375 2^-17, degree 10, 75.3 bits */
    {0x1.20c0629d233dcp+0, 0x1.7a2ec206f63a4p-54, -0x1.318d8fef101e2p-15, 0x1.48471eec47f8ep-24, -0x1.2c095e65cd5e4p-27,
     0x1.3747b647667bap-29, -0x1.b013fadfa3a1dp-31, 0x1.5e354940fcb03p-32, -0x1.38f424b486d73p-33,
     0x1.2b27f58792347p-34, -0x1.2d476735567aap-35, 0x1.3a4d95bfbb891p-36},
     /* [347] 1.375 <= y <= 1.5 2^-17, degree 10, 74.9 bits */
    {0x1.20c0163ece332p+0, -0x1.d8ef470b5e8b9p-56, -0x1.31655ed74cdd3p-15, 0x1.3b10740ac9a81p-24,
     -0x1.08f4ec0b7a018p-27, 0x1.f9ab2e626b13p-30, -0x1.42d7b680192fep-31, 0x1.e17239a646d45p-33,
     -0x1.8bcc2b3e6f847p-34, 0x1.5c11f116804f8p-35, -0x1.425a9fbd24a31p-36, 0x1.355fa2e5cb80dp-37},
     /* [348] 1.5 <= y <= 1.625 2^-17, degree 10, 73.1 bits */
    {0x1.20bfc9ea52a96p+0, 0x1.41b1512490a03p-54, -0x1.313ebbf9605eap-15, 0x1.2f56cf4bb3df5p-24, -0x1.d878a4219d40cp-28,
     0x1.a15cce0ea79f4p-30, -0x1.ed6759735640bp-32, 0x1.54a100df04f98p-33, -0x1.03476b75f9b91p-34,
     0x1.a63c81de2b519p-36, -0x1.69f288c1e7dd2p-37, 0x1.41a152c69da63p-38},
     /* [349] 1.625 <= y <= 1.75 2^-17, degree 10, 73.3 bits */
    {0x1.20bf7d9f52a73p+0, -0x1.7debf503f7cfcp-54, -0x1.31197c10911a8p-15, 0x1.24d770f1548a1p-24,
     -0x1.a8bc4c2028edcp-28, 0x1.5d3e1bc3a0b8fp-30, -0x1.805ce333539dp-32, 0x1.ee1343e43afe6p-34,
     -0x1.5e214bed61e83p-35, 0x1.096ce1865e539p-36, -0x1.a78cb139c44c5p-38, 0x1.5e673a4850d9dp-39},
     /* [350] 1.75 <= y <= 1.875 2^-17, degree 10, 73.1 bits */
    {0x1.20bf315d7a0f5p+0, 0x1.c3069da97b58p-55, -0x1.30f57b2d64c87p-15, 0x1.1b5ee9ae06103p-24, -0x1.808dcda27f76ap-28,
     0x1.27bd8c146e009p-30, -0x1.307446dff892dp-32, 0x1.6e16fbbbc0bccp-34, -0x1.e55f6e57560c6p-36,
     0x1.5833cfd1c0243p-37, -0x1.00d9b523fadfp-38, 0x1.8d8e687640cefp-40},
     /* [351] 1.875 <= y <= 2 2^-17, degree 10, 78.7 bits */
    {0x1.20bebf0b3b0acp+0, 0x1.97590638cfc2ep-56, -0x1.30c18f225dce2p-14, 0x1.0ec0f35ee538cp-22, -0x1.4f1cbcf2a00e6p-25,
     0x1.d5d042c648bacp-27, -0x1.b8ec632172398p-28, 0x1.e35e9851e9aep-29, -0x1.242497bba9ca3p-29, 0x1.79c5d2252f7e9p-30,
     -0x1.01ecfa105600ap-30, 0x1.6c0ef29b87778p-31}, /* [352] 1 <= y <= 1.125 2^-16, degree 10, 71.8 bits */
    {0x1.20be26bb0f39ap+0, -0x1.ff4ae4f2ca187p-58, -0x1.307fba311c3a4p-14, 0x1.004cb80367793p-22,
     -0x1.1bf493d58fd23p-25, 0x1.640de03608b16p-27, -0x1.2aef8161cf14ep-28, 0x1.2530757411d1ep-29,
     -0x1.3d137c25e39eep-30, 0x1.6ed691404f77cp-31, -0x1.bfb9e621a83c2p-32, 0x1.1ab1e3a078999p-32},
     /* [353] 1.125 <= y <= 1.25 2^-16, degree 10, 71.2 bits */
    {0x1.20bd8e8af2945p+0, -0x1.194ea26864774p-59, -0x1.30413c0d4a968p-14, 0x1.e7e5ce1da3fcep-23, -0x1.e94b675bf02ep-26,
     0x1.157373ac714a3p-27, -0x1.a572c474a728bp-29, 0x1.75f27c6e87b5fp-30, -0x1.6de0764974a54p-31,
     0x1.7ef79699cc0e1p-32, -0x1.a692c8db88f61p-33, 0x1.e2c5d5ec73617p-34},
     /* [354] 1.25 <= y <= 1.375 2^-16, degree 10, 72.5 bits */
    {0x1.20bcf67958a4ap+0, -0x1.36df146589eb4p-56, -0x1.30059debe7755p-14, 0x1.d2780b6ae94e6p-23,
     -0x1.ab56b418420dfp-26, 0x1.ba5908331734ap-28, -0x1.32b41ee37b81fp-29, 0x1.f0e67ab80f7bap-31,
     -0x1.bbe01a73697fep-32, 0x1.a830ded3f6a7fp-33, -0x1.ab1ca7960bb8p-34, 0x1.bd80812b34578p-35},
     /* [355] 1.375 <= y <= 1.5 2^-16, degree 10, 71.6 bits */
    {0x1.20bc5e84e9ac5p+0, -0x1.becbc7f131d3cp-54, -0x1.2fcc824d79e54p-14, 0x1.bfa577cb211d8p-23,
     -0x1.797ba85c6c3d7p-26, 0x1.675e181667117p-28, -0x1.ca67de1d78516p-30, 0x1.559a98aa8eef7p-31,
     -0x1.18b945b2fb76p-32, 0x1.ed9b0a33ce9fdp-34, -0x1.c909a7b5630bp-35, 0x1.b68edd998555cp-36},
     /* [356] 1.5 <= y <= 1.625 2^-16, degree 10, 74.4 bits */
    {0x1.20bbc6ac77db8p+0, 0x1.5a80b01c787a9p-55, -0x1.2f959e08006e8p-14, 0x1.aef07535fe052p-23, -0x1.50a7fa512bbbdp-26,
     0x1.28ab684177c4fp-28, -0x1.5e596bc3ba41ap-30, 0x1.e371abaa51b3dp-32, -0x1.6fd672eb0d3edp-33,
     0x1.2b6c9d9eff9aep-34, -0x1.009ceec61a2dcp-35, 0x1.c7f9d455dff7ep-37},
     /* [357] 1.625 <= y <= 1.75 2^-16, degree 10, 71.7 bits */
    {0x1.20bb2eeef7646p+0, -0x1.c6db22a73993dp-54, -0x1.2f60b39a17d35p-14, 0x1.9ffa3b064f59cp-23,
     -0x1.2eb8b31a1009ep-26, 0x1.f097b5bff816bp-29, -0x1.10f71bcf5254ep-30, 0x1.5ea8c3815061ap-32,
     -0x1.f0c935095a416p-34, 0x1.787cacf4d248fp-35, -0x1.2c51312ea0f18p-36, 0x1.f0d021a6eb595p-38},
     /* [358] 1.75 <= y <= 1.875 2^-16, degree 10, 73.5 bits */
    {0x1.20ba974b78822p+0, 0x1.b8668f0d7af5ep-54, -0x1.2f2d8fec43514p-14, 0x1.9279bca7f34c5p-23, -0x1.1226c93bc9bb5p-26,
     0x1.a4985de78644fp-29, -0x1.b07f2b04964bep-31, 0x1.03db857ca5527p-32, -0x1.585ef7af40a43p-34,
     0x1.e8b184e5aeca6p-36, -0x1.74e82bbde9824p-37, 0x1.1216c7b392b88p-45},
     /* [359] 1.875 <= y <= 2 2^-16, degree 10, 78.0 bits */
    {0x1.20b9b405296fep+0, 0x1.31360cc4a8563p-54, -0x1.2ee3d2ccd9fdfp-13, 0x1.807b98119854p-21, -0x1.ddfaa7f4244b2p-24,
     0x1.4e2b0e6342f4cp-25, -0x1.393f578bdd5ddp-26, 0x1.572b13444ce1bp-27, -0x1.9ea00eb9098f3p-28,
     0x1.0bfd4625d4a8fp-28, -0x1.6dd9128123191p-29, 0x1.02246f9e13309p-29},
     /* [360] 1 <= y <= 1.125 2^-15, degree 10, 70.6 bits */
    {0x1.20b8855080f77p+0, -0x1.2fd297a2d62f4p-54, -0x1.2e8659ed66dd2p-13, 0x1.6bdcb2edcdd53p-21,
     -0x1.9531981ee45b1p-24, 0x1.faada7bbc3fd2p-26, -0x1.a8dd4e4e5afeap-27, 0x1.a0659d91b1a4p-28,
     -0x1.c21aed0846b47p-29, 0x1.04480eb886be5p-29, -0x1.3d96851013db4p-30, 0x1.90f70dfd22147p-31},
     /* [361] 1.125 <= y <= 1.25 2^-15, degree 10, 76.1 bits */
    {0x1.20b756f6df8e3p+0, -0x1.03c35c8f1946bp-55, -0x1.2e2da4cf17f23p-13, 0x1.5a3bfa2213557p-21,
     -0x1.5d3f8955024e8p-24, 0x1.8af2fdb2a3b69p-26, -0x1.2b921f6b3bb5cp-27, 0x1.099adb47a46bep-28,
     -0x1.03bdc39a8e1f8p-29, 0x1.0fc6277cabd03p-30, -0x1.2bcbb351f30c1p-31, 0x1.566d5ac4a0a43p-32},
     /* [362] 1.25 <= y <= 1.375 2^-15, degree 10, 72.6 bits */
    {0x1.20b628f3d9836p+0, 0x1.a09b7aedf46a7p-54, -0x1.2dd90a5fe4b71p-13, 0x1.4aef995526585p-21, -0x1.312515d021861p-24,
     0x1.3aef511e419f2p-26, -0x1.b4200359108ddp-28, 0x1.61028cf3eaf9p-29, -0x1.3b2c3fc0cfb38p-30, 0x1.2d147c2bbcacap-31,
     -0x1.2f10366788546p-32, 0x1.3c09a3084e199p-33}, /* [363] 1.375 <= y <= 1.5 2^-15, degree 10, 74.7 bits */
    {0x1.20b4fb43993bfp+0, 0x1.e898e2621070cp-54, -0x1.2d8805834529fp-13, 0x1.3d7e398b70118p-21, -0x1.0da4ffe958fe5p-24,
     0x1.ffdc47989a7c9p-27, -0x1.45ff6bddadfaap-28, 0x1.e57733164dcbap-30, -0x1.8eb9f6969cac8p-31,
     0x1.5e67f87ed80a1p-32, -0x1.4458b6611d90dp-33, 0x1.3727c9e8e20ccp-34},
     /* [364] 1.5 <= y <= 1.625 2^-15, degree 10, 71.7 bits */
    {0x1.20b3cde2c0863p+0, -0x1.656699cef6408p-54, -0x1.2d3a2b2e82f04p-13, 0x1.318e887fd0636p-21,
     -0x1.e121456f908d3p-25, 0x1.a6acba696be15p-27, -0x1.f26b1c7ce22a6p-29, 0x1.5796345777532p-30,
     -0x1.05464f726707cp-31, 0x1.a92f17da04e71p-33, -0x1.6c464c3b249dp-34, 0x1.438e9b5697c22p-35},
     /* [365] 1.625 <= y <= 1.75 2^-15, degree 10, 70.3 bits */
    {0x1.20b2a0ce520fep+0, 0x1.ce041ea99ee09p-57, -0x1.2cef23c4113a9p-13, 0x1.26dd1c92a277ap-21, -0x1.b0c69ced26e51p-25,
     0x1.61d9a13cf10b8p-27, -0x1.8469f7b273bcdp-29, 0x1.f2866240c6f5p-31, -0x1.60ecdfcca706fp-32, 0x1.0b58e2e024319p-33,
     -0x1.aa5fd576a27e5p-35, 0x1.6094aa735c6ap-36}, /* [366] 1.75 <= y <= 1.875 2^-15, degree 10, 71.6 bits */
    {0x1.20b17403a06a1p+0, 0x1.88e6f8b36f9ddp-54, -0x1.2ca6a676e8033p-13, 0x1.1d35fe7846a9p-21, -0x1.880e27e814419p-25,
     0x1.2bc64dc7087bp-27, -0x1.33c6133f2100dp-29, 0x1.71803f9c132dep-31, -0x1.e961cf6776d7bp-33, 0x1.5ac7fb278aad3p-34,
     -0x1.029f782d5ac29p-35, 0x1.901cd3740e9f9p-37}, /* [367] 1.875 <= y <= 2 2^-15, degree 10, 71.5 bits */
    {0x1.20afb1589e6c4p+0, -0x1.4229a25e90128p-55, -0x1.2c3e29f9b17ccp-12, 0x1.1057b81df3ccp-19, -0x1.55ec7affc6267p-22,
     0x1.dc86650335a5dp-24, -0x1.bdf633c64a4f8p-25, 0x1.e8173f62eded8p-26, -0x1.26ac39afda5f2p-26,
     0x1.7cbd6d608ab7cp-27, -0x1.03ca7a7a755a6p-27, 0x1.6e82f78037158p-28},
     /* [368] 1 <= y <= 1.125 2^-14, degree 10, 73.8 bits */
    {0x1.20ad5961e6a2cp+0, 0x1.ca65b204bd21ep-55, -0x1.2bb9c8590afp-12, 0x1.01966bc7d117bp-19, -0x1.22041a85bbe12p-22,
     0x1.696e1d9b0bdcep-24, -0x1.2e8cb1de3bb7fp-25, 0x1.28385464ac187p-26, -0x1.3ffb7a38330b8p-27,
     0x1.71e358d132aa7p-28, -0x1.c32769d7a5b86p-29, 0x1.1cb62a7a0b5ecp-29},
     /* [369] 1.125 <= y <= 1.25 2^-14, degree 10, 70.4 bits */
    {0x1.20ab026cf2981p+0, -0x1.4fce5a318adcbp-54, -0x1.2b3c38c292ce1p-12, 0x1.e9ef4b4f72934p-20,
     -0x1.f4331b7ff4393p-23, 0x1.19da6a0747a4fp-24, -0x1.aacee25982989p-26, 0x1.7a03cc7d116cfp-27,
     -0x1.7167f5439270ap-28, 0x1.825179430009bp-29, -0x1.a9fa92be9105ep-30, 0x1.e665e6e5dd667p-31},
     /* [370] 1.25 <= y <= 1.375 2^-14, degree 10, 69.7 bits */
    {0x1.20a8ac6d1986p+0, -0x1.31605385a4e56p-57, -0x1.2ac489f586d1ap-12, 0x1.d404e2814e22ep-20, -0x1.b53d24d127089p-23,
     0x1.c1b0495e2aa28p-25, -0x1.36c99af868b6cp-26, 0x1.f68fb181b438p-28, -0x1.c05c4530c87f5p-29, 0x1.ac144d8f0ff01p-30,
     -0x1.aeb7d1be65e26p-31, 0x1.c101c529e1bf1p-32}, /* [371] 1.375 <= y <= 1.5 2^-14, degree 10, 72.3 bits */
    {0x1.20a657575f1p+0, -0x1.323cfc577edf1p-54, -0x1.2a51fdebf5b9ap-12, 0x1.c0c0b652d3555p-20, -0x1.8289fb98352dcp-23,
     0x1.6d94ab026f4ap-25, -0x1.d0c5893596547p-27, 0x1.59a9fdb50e107p-28, -0x1.1baef16c5e949p-29, 0x1.f253bebb967dap-31,
     -0x1.cd109030abc43p-32, 0x1.ba28aaea13aa4p-33}, /* [372] 1.5 <= y <= 1.625 2^-14, degree 10, 69.8 bits */
    {0x1.20a403221bd94p+0, 0x1.030a80385df57p-58, -0x1.29e3fbc740dp-12, 0x1.afa374b08a852p-20, -0x1.58fe38878211ep-23,
     0x1.2dfeda9730d2bp-25, -0x1.636818758941fp-27, 0x1.e96b364648a5dp-29, -0x1.73deed13e3243p-30,
     0x1.2e673199335dcp-31, -0x1.02f6fe87ba0e7p-32, 0x1.cbdebdeae5197p-34},
     /* [373] 1.625 <= y <= 1.75 2^-14, degree 10, 72.0 bits */
    {0x1.20a1afc4bd447p+0, 0x1.68cf7d4d1067dp-54, -0x1.297a065abe228p-12, 0x1.a04cfe3e64aa8p-20, -0x1.367049262e549p-23,
     0x1.f9d2ca7d77dbap-26, -0x1.150ca700311b7p-27, 0x1.63271a2385992p-29, -0x1.f66f4464e198fp-31,
     0x1.7c5f1bfaa9f8ap-32, -0x1.2f2c01296f0f2p-33, 0x1.f536c43f5f7c4p-35},
     /* [374] 1.75 <= y <= 1.875 2^-14, degree 10, 70.5 bits */
    {0x1.209f5d379502fp+0, 0x1.18b7e7cdf3706p-59, -0x1.2913b59a4333dp-12, 0x1.92733426fa00dp-20, -0x1.19543baa3b168p-23,
     0x1.acab92a7d2789p-26, -0x1.b73007eeaaf4fp-28, 0x1.074d42047345bp-29, -0x1.5c6d9c6ea18abp-31,
     0x1.ed7d38751a83fp-33, -0x1.6fdb268f24923p-34, 0x1.1c714199d9f1ep-35},
     /* [375] 1.875 <= y <= 2 2^-14, degree 10, 72.7 bits */
    {0x1.209be2db3fe2fp+0, 0x1.0d2d5ba363332p-54, -0x1.28805537fee0fp-11, 0x1.7ffa4467ac3dp-18, -0x1.eaf445a91754bp-21,
     0x1.54e0434c3d777p-22, -0x1.3e5281394afe1p-23, 0x1.5bef1c9800e03p-24, -0x1.a3bc8f8965921p-25,
     0x1.0efce261ab88ep-25, -0x1.719e3d6488b28p-26, 0x1.049f247a723f3p-26},
     /* [376] 1 <= y <= 1.125 2^-13, degree 10, 72.0 bits */
    {0x1.209742528a06p+0, -0x1.6e32ff9f9ba2fp-54, -0x1.27c5c97a30cccp-11, 0x1.6ac901082ef71p-18, -0x1.a0ab534ba10cdp-21,
     0x1.02b3c9bd53955p-22, -0x1.b023a4ae6acbfp-24, 0x1.a6835b51e7bffp-25, -0x1.c7f9cfe0c71e9p-26,
     0x1.075cfd9272f77p-26, -0x1.410d5ac292605p-27, 0x1.950aa14c589abp-28},
     /* [377] 1.125 <= y <= 1.25 2^-13, degree 10, 68.7 bits */
    {0x1.2092a49fe7ef2p+0, -0x1.464b14a648d3cp-54, -0x1.27150a3d97377p-11, 0x1.58a617fd68e1cp-18,
     -0x1.6782f11ce5a2ap-21, 0x1.93b754059734fp-23, -0x1.30f5fa92db6c2p-24, 0x1.0db51cbfed5a8p-25,
     -0x1.074e1703e141ep-26, 0x1.1328e35b5c5dbp-27, -0x1.2f3cb36de3bb2p-28, 0x1.5a1752f0a1cf8p-29},
     /* [378] 1.25 <= y <= 1.375 2^-13, degree 10, 70.2 bits */
    {0x1.208e099ef739cp+0, -0x1.1f1b811f29dadp-55, -0x1.266cbe0eb00a2p-11, 0x1.48e4bced3ecb1p-18, -0x1.3a688ea1123ap-21,
     0x1.423b05c097949p-23, -0x1.bc54fdd9f5153p-25, 0x1.66b789cacda08p-26, -0x1.3fb35371ab5dcp-27,
     0x1.31020745707a4p-28, -0x1.32b50e437ae14p-29, 0x1.3f9473187a043p-30},
     /* [379] 1.375 <= y <= 1.5 2^-13, degree 10, 68.9 bits */
    {0x1.2089713020bap+0, -0x1.8f00483f3ec25p-54, -0x1.25cbd4ae5979fp-11, 0x1.3b095f306c65ap-18, -0x1.1611e27d92abcp-21,
     0x1.0617e77000002p-23, -0x1.4c6374fadf33cp-25, 0x1.eda5dbf5df7a3p-27, -0x1.94b3416a79b95p-28,
     0x1.632cbbdcce47ap-29, -0x1.486a51b871608p-30, 0x1.3acb59811edcp-31},
     /* [380] 1.5 <= y <= 1.625 2^-13, degree 10, 68.4 bits */
    {0x1.2084db379e9d8p+0, 0x1.1f41b80d38ee5p-56, -0x1.253172fb119e3p-11, 0x1.2eb8f68b4710fp-18, -0x1.f08e2fb00211bp-22,
     0x1.b1386c66fe924p-24, -0x1.fc903dd89983p-26, 0x1.5d9aa3e72067p-27, -0x1.0957f72916ce9p-28, 0x1.af3327ef4a84dp-30,
     -0x1.7106c3d01c062p-31, 0x1.477e000b936abp-32}, /* [381] 1.625 <= y <= 1.75 2^-13, degree 10, 68.3 bits */
    {0x1.2080479cc4ab1p+0, 0x1.e1cf293b1ac2bp-55, -0x1.249ce56fdf19dp-11, 0x1.23aec173835e1p-18, -0x1.bef9ad8585a8dp-22,
     0x1.6af894a7b3534p-24, -0x1.8c996994c1c7dp-26, 0x1.fb9239eb4e9a6p-28, -0x1.669f4dae1ff0bp-29,
     0x1.0f44d2192a5dfp-30, -0x1.b0243b62611c7p-32, 0x1.65070b2f973bfp-33},
     /* [382] 1.75 <= y <= 1.875 2^-13, degree 10, 71.4 bits */
    {0x1.207bb64975aa8p+0, 0x1.454e624f82398p-54, -0x1.240d96c2afa8ep-11, 0x1.19b5b5a620859p-18, -0x1.95307e27cfd7bp-22,
     0x1.33bce59cb71a7p-24, -0x1.3a78e6b565df6p-26, 0x1.786e5b378fee1p-28, -0x1.f18cd168878ebp-30,
     0x1.600ab8ac28de7p-31, -0x1.063dc3b130ae7p-32, 0x1.95552cbfa9c05p-34},
     /* [383] 1.875 <= y <= 2 2^-13, degree 10, 68.7 bits */
    {0x1.2074e06773dfap+0, 0x1.57b31012b1f6ep-54, -0x1.233f68b8c863cp-10, 0x1.0c6788ec4b56ep-16, -0x1.61b2ed9896b9bp-19,
     0x1.e9b741c59299dp-21, -0x1.c81bc78e923d4p-22, 0x1.f1abffc3bb97dp-23, -0x1.2bd2bc7fdf4aap-23,
     0x1.82ca5eed6575ep-24, -0x1.0798fe3dbc91p-24, 0x1.73853d3a9d043p-25},
     /* [384] 1 <= y <= 1.125 2^-12, degree 10, 67.4 bits */
    {0x1.206bca8898908p+0, -0x1.80674dc1da2dcp-54, -0x1.223ad9308bfd3p-10, 0x1.fa4432b38dd23p-17,
     -0x1.2c51d1c186c29p-19, 0x1.73ef510e40235p-21, -0x1.35cedb6619681p-22, 0x1.2e5c5e5afaf95p-23,
     -0x1.45e4afbe69e2cp-24, 0x1.781a74ffb9229p-25, -0x1.ca2591928e1a5p-26, 0x1.20d405d418e28p-26},
     /* [385] 1.125 <= y <= 1.25 2^-12, degree 10, 67.7 bits */
    {0x1.2062bc94432b4p+0, 0x1.27fc664b0664fp-54, -0x1.214469aa2c183p-10, 0x1.e01e11fafceb8p-17, -0x1.0337f0706cebbp-19,
     0x1.2267a12117045p-21, -0x1.b58ae8a2dfcffp-23, 0x1.823e354cc11a9p-24, -0x1.7893a611fbe3ap-25,
     0x1.89247adbf719ap-26, -0x1.b0ec3251c24fcp-27, 0x1.edcbb9e3d7778p-28},
     /* [386] 1.25 <= y <= 1.375 2^-12, degree 10, 68.2 bits */
    {0x1.2059b62189378p+0, 0x1.f57de384e11dp-57, -0x1.205a29592353bp-10, 0x1.c964db64e64ffp-17, -0x1.c587969e766bfp-20,
     0x1.cfdd5ecaccf6ep-22, -0x1.3ef16e61732bfp-23, 0x1.00ff1d03a8657p-24, -0x1.c9767999df03ap-26,
     0x1.b3fddbecd3ce3p-27, -0x1.b61130b323903p-28, 0x1.c8280dbfc4f76p-29},
     /* [387] 1.375 <= y <= 1.5 2^-12, degree 10, 72.3 bits */
    {0x1.2050b6d54b20fp+0, -0x1.55c38447e0fc2p-55, -0x1.1f7a9076a245ep-10, 0x1.b5673a99b6162p-17,
     -0x1.91344894f1dfap-20, 0x1.7982116d5183dp-22, -0x1.dd7268e657d9bp-24, 0x1.61d93e9d0c1d9p-25,
     -0x1.21aed75462d05p-26, 0x1.fbed45332c993p-28, -0x1.d544474aa51cdp-29, 0x1.c180342811855p-30},
     /* [388] 1.5 <= y <= 1.625 2^-12, degree 10, 67.4 bits */
    {0x1.2047be5f670e8p+0, -0x1.7a5f192fe4b7cp-57, -0x1.1ea4637b6cc27p-10, 0x1.a3a277ddd342bp-17,
     -0x1.66482abd5e6e6p-20, 0x1.3828a9d303058p-22, -0x1.6d7240970e4f4p-24, 0x1.f570f31d89eaap-26,
     -0x1.7c095acf31002p-27, 0x1.3474530f7635ap-28, -0x1.07c07abda2d26p-29, 0x1.d3ce7ad1bdd9dp-31},
     /* [389] 1.625 <= y <= 1.75 2^-12, degree 10, 68.2 bits */
    {0x1.203ecc78a92ebp+0, 0x1.18f5d744179b8p-55, -0x1.1dd69fc570b3ep-10, 0x1.93b3ca58f0557p-17, -0x1.428c5b35fde94p-20,
     0x1.05aa9dc2439fap-22, -0x1.1d21f2f069111p-24, 0x1.6c2d87106d032p-26, -0x1.00edb31b0d209p-27,
     0x1.84416cfb769d7p-29, -0x1.34fa91bcf48b8p-30, 0x1.fe2dbb2cec76cp-32},
     /* [390] 1.75 <= y <= 1.875 2^-12, degree 10, 70.5 bits */
    {0x1.2035e0e13d7b3p+0, 0x1.721bafe22ee8p-54, -0x1.1d106e242fc4dp-10, 0x1.854ef380805b4p-17, -0x1.246b0a45f0bc4p-20,
     0x1.bbe54c6a14991p-23, -0x1.c463a75393b58p-25, 0x1.0e34d68259b48p-26, -0x1.649bdd6f123c7p-28,
     0x1.f80ed325f404dp-30, -0x1.77237d532a4fp-31, 0x1.21b3b71661a26p-32},
     /* [391] 1.875 <= y <= 2 2^-12, degree 10, 67.7 bits */
    {0x1.20288ad62bf7ap+0, -0x1.99cb2d0cffb6dp-56, -0x1.1bf3d05b5fb0fp-9, 0x1.721a725c94b72p-15, -0x1.fe8aaf5cbe24ap-18,
     0x1.6168f18f4ae23p-19, -0x1.4849e8a424129p-20, 0x1.6575d53a5b9d9p-21, -0x1.ae09e016253f4p-22,
     0x1.150f1fd250d8ap-22, -0x1.79460013a836cp-23, 0x1.09aa41f45c6b3p-23},
     /* [392] 1 <= y <= 1.125 2^-11, degree 10, 69.2 bits */
    {0x1.2016d6ecc4e07p+0, -0x1.5089f1589944fp-54, -0x1.1a8d0850fbc5cp-9, 0x1.5c0f810af542fp-15, -0x1.b178959e5b372p-18,
     0x1.0c9a6bccd6dd5p-19, -0x1.be55f84c3a1d9p-21, 0x1.b2b0bec4b0cdep-22, -0x1.d3c69baea2173p-23,
     0x1.0d972cb892a91p-23, -0x1.481345d3d7f25p-24, 0x1.9d52e403069dap-25},
     /* [393] 1.125 <= y <= 1.25 2^-11, degree 10, 69.0 bits */
    {0x1.200538c88bad3p+0, 0x1.f916af1c90af1p-55, -0x1.193aa376ba2e1p-9, 0x1.4930cbf65a72p-15, -0x1.7616a4f7fec82p-18,
     0x1.a3b4bc814d1edp-20, -0x1.3b697e4c3c982p-21, 0x1.15d7b6d9a68ecp-22, -0x1.0e72acb146413p-23,
     0x1.19fc9896c772dp-24, -0x1.3633e166f892p-25, 0x1.61868f0d8944bp-26},
     /* [394] 1.25 <= y <= 1.375 2^-11, degree 10, 67.8 bits */
    {0x1.1ff3af3aa8d0cp+0, 0x1.fc24faa62a3c8p-56, -0x1.17f9d40d334eep-9, 0x1.38cbbfaaf50b6p-15, -0x1.472c337727ba2p-18,
     0x1.4f6068bd57e3cp-20, -0x1.cc244faa5417cp-22, 0x1.71fca6c09ec72p-23, -0x1.48bfbb4f6c6f7p-24,
     0x1.38e939a918ac1p-25, -0x1.3a11f6bfbc91bp-26, 0x1.46c1f741712bcp-27},
     /* [395] 1.375 <= y <= 1.5 2^-11, degree 10, 66.5 bits */
    {0x1.1fe2393c2223p+0, 0x1.ea401af4d70c2p-54, -0x1.16c863bbd3e55p-9, 0x1.2a607e04ca7b6p-15, -0x1.21552477badf1p-18,
     0x1.111080c675267p-20, -0x1.589e6fd381b64p-22, 0x1.fdbcfa7c3671bp-24, -0x1.a09a76a9b8ba2p-25,
     0x1.6cbf78bff6492p-26, -0x1.509f4e164f5dcp-27, 0x1.422858d919365p-28},
     /* [396] 1.5 <= y <= 1.625 2^-11, degree 10, 67.7 bits */
    {0x1.1fd0d5e5c6763p+0, 0x1.08dbdee9908a3p-56, -0x1.15a48a28fa52fp-9, 0x1.1d90b582d0db2p-15, -0x1.024786b0abd7bp-18,
     0x1.c3c40ac4cc9d3p-21, -0x1.07ecceb1b2be4p-22, 0x1.6962fe65578a2p-24, -0x1.116d3fff2ea93p-25,
     0x1.bb3fd4653505ep-27, -0x1.7a9807ec2fe2ap-28, 0x1.4f717765e2956p-29},
     /* [397] 1.625 <= y <= 1.75 2^-11, degree 10, 68.4 bits */
    {0x1.1fbf846a3a9abp+0, 0x1.6f2ee08af0333p-55, -0x1.148cd11bd1663p-9, 0x1.1215145b6a5abp-15, -0x1.d0d5e20fc5a98p-19,
     0x1.7ad10506b3903p-21, -0x1.9c0e70da64e36p-23, 0x1.069aaf2cbde2dp-24, -0x1.71e79e1f38125p-26,
     0x1.171af61fda16cp-27, -0x1.bbbb5c7ba2132p-29, 0x1.6dffb6933771cp-30},
     /* [398] 1.75 <= y <= 1.875 2^-11, degree 10, 68.3 bits */
    {0x1.1fae44117b598p+0, 0x1.d63175e5b5a0bp-55, -0x1.1380011aa23bbp-9, 0x1.07b6871e06bacp-15, -0x1.a535b5e2332e1p-19,
     0x1.416783ae3fbacp-21, -0x1.470963f9e89b5p-23, 0x1.85e235b1d5d28p-25, -0x1.00d67ef5193d6p-26,
     0x1.6a877def71ccfp-28, -0x1.0d7fd68758a8ap-29, 0x1.9fd919df3c611p-31},
     /* [399] 1.875 <= y <= 2 2^-11, degree 10, 68.6 bits */
    {0x1.1f94824665d15p+0, -0x1.07f9d6ab3adabp-54, -0x1.11ff0a76e0f27p-8, 0x1.f3c5dc554be54p-14, -0x1.6f685f0bcbb5fp-16,
     0x1.fff1429e8e752p-18, -0x1.daf29052bf5c2p-19, 0x1.0212dcc226813p-19, -0x1.35f170167a679p-20,
     0x1.8eca4b01095eep-21, -0x1.0f36f16dc41a2p-21, 0x1.815b3c6b040c3p-22},
     /* [400] 1 <= y <= 1.125 2^-10, degree 10, 66.8 bits */
    {0x1.1f7260f151148p+0, -0x1.d7e9d1a1b0458p-57, -0x1.101b8eafca3eap-8, 0x1.d4109f3c706e9p-14, -0x1.3793e58881621p-16,
     0x1.8534cf44aed4dp-18, -0x1.4319b4368b62cp-19, 0x1.3a18a71b0f70cp-20, -0x1.516ec3f32d57fp-21,
     0x1.84633d273d3fep-22, -0x1.d81407552e6e4p-23, 0x1.291306c339809p-23},
     /* [401] 1.125 <= y <= 1.25 2^-10, degree 10, 65.2 bits */
    {0x1.1f507a2a83c2bp+0, 0x1.5bd671cb41298p-54, -0x1.0e55622965379p-8, 0x1.b8f449bc41f7ep-14, -0x1.0c8d2b7fb1d92p-16,
     0x1.301f8063289a2p-18, -0x1.c8edf2bfa32p-20, 0x1.91d323af22fcap-21, -0x1.867bb69e03ap-22, 0x1.968fec05f567ep-23,
     -0x1.beb352107e71ap-24, 0x1.fc909526f3fa3p-25}, /* [402] 1.25 <= y <= 1.375 2^-10, degree 10, 67.2 bits */
    {0x1.1f2eca8bc6f22p+0, 0x1.7a4f7463133bfp-54, -0x1.0ca874cdd9eebp-8, 0x1.a16e40c968f58p-14, -0x1.d51c24f9e2b34p-17,
     0x1.e60cc289ff812p-19, -0x1.4d77a5eda0c02p-20, 0x1.0bb89b0a80613p-21, -0x1.daff61ef820b6p-23,
     0x1.c37888c025079p-24, -0x1.c496b280cfc4dp-25, 0x1.d66186434b2d1p-26},
     /* [403] 1.375 <= y <= 1.5 2^-10, degree 10, 65.2 bits */
    {0x1.1f0d4f226ea04p+0, -0x1.52813f8208681p-54, -0x1.0b1191d7c3c93p-8, 0x1.8cc53d252b697p-14, -0x1.9e456299d8106p-17,
     0x1.8bb71e79016abp-19, -0x1.f3b4207e9b0d2p-21, 0x1.710fe573c430cp-22, -0x1.2d298a6a0dc26p-23,
     0x1.074deb3d6c6b6p-24, -0x1.e567b65fd6444p-26, 0x1.d00e9381c6ad2p-27},
     /* [404] 1.5 <= y <= 1.625 2^-10, degree 10, 67.5 bits */
    {0x1.1eec0557efb3ap+0, -0x1.e8bd848785a87p-57, -0x1.098e23ed162dp-8, 0x1.7a7083cb202fp-14, -0x1.7145e3396f103p-17,
     0x1.474a27d1a67f8p-19, -0x1.7ed3683c856e7p-21, 0x1.05c9fd2269773p-22, -0x1.8b8d9a38e70fcp-24,
     0x1.402b0ce194e61p-25, -0x1.11216bfb1e8bap-26, 0x1.e37c4166e7e3dp-28},
     /* [405] 1.625 <= y <= 1.75 2^-10, degree 10, 66.1 bits */
    {0x1.1ecaeae0a075ep+0, -0x1.0eb18f2305914p-54, -0x1.081c0cc89d8a9p-8, 0x1.6a08a6ba7f664p-14, -0x1.4bce207a5af1ep-17,
     0x1.126030a07dcf9p-19, -0x1.2aed0be1f47fbp-21, 0x1.7ca342fbd0028p-23, -0x1.0bb4a2320271ep-24,
     0x1.936f56f424a18p-26, -0x1.404e5746a6916p-27, 0x1.07e98e4f35601p-28},
     /* [406] 1.75 <= y <= 1.875 2^-10, degree 10, 65.6 bits */
    {0x1.1ea9fdaeb10dap+0, -0x1.e4e870b9d1147p-54, -0x1.06b98927f7aa2p-8, 0x1.5b3dc02e53b12p-14, -0x1.2c363293564cdp-17,
     0x1.d17198d23ec4dp-20, -0x1.da97fd15885b8p-22, 0x1.1aad9c319527p-23, -0x1.73f001c5cbp-25, 0x1.0625cdf1c0b56p-26,
     -0x1.8548239fdafbfp-28, 0x1.2c04572b404f9p-29}, /* [407] 1.875 <= y <= 2 2^-10, degree 10, 65.7 bits */
    {0x1.1e78eac524775p+0, -0x1.e45f262b7ef14p-55, -0x1.04bfc806f3887p-7, 0x1.478dc94648977p-12, -0x1.0543d2c58552ap-14,
     0x1.727a46cb17ff8p-16, -0x1.58b06b825bafep-17, 0x1.766afce06ed61p-18, -0x1.c12304f0418a4p-19,
     0x1.20969e9601dbfp-19, -0x1.880ab38dbad1ep-20, 0x1.1380528926597p-20},
     /* [408] 1 <= y <= 1.125 2^-9, degree 10, 64.4 bits */
    {0x1.1e380ac1f2214p+0, 0x1.fa24731b37f26p-55, -0x1.0247d13f0c23dp-7, 0x1.310a404b64542p-12, -0x1.b9c25984aa254p-15,
     0x1.1965d13a4728cp-16, -0x1.d504a1e7bb206p-18, 0x1.c7f17a5e4fcfcp-19, -0x1.e956297b1bb9p-20, 0x1.19489efb7a945p-20,
     -0x1.558038d11b5a9p-21, 0x1.ad5aa51a76872p-22}, /* [409] 1.125 <= y <= 1.25 2^-9, degree 10, 66.1 bits */
    {0x1.1df7c367294d9p+0, -0x1.12048df43ec73p-54, -0x1.fff2d3139777cp-8, 0x1.1dd9a615ab82dp-12, -0x1.7b9304b899f22p-15,
     0x1.b74a3cfea6465p-17, -0x1.4b9e411ec7844p-18, 0x1.23c25a4f32631p-19, -0x1.1b4f0be8c855bp-20,
     0x1.26a8efc2815aap-21, -0x1.43651a77dc541p-22, 0x1.6fcdc0f909012p-23},
     /* [410] 1.25 <= y <= 1.375 2^-9, degree 10, 66.6 bits */
    {0x1.1db80b14ba772p+0, 0x1.a1c901b86e9d1p-58, -0x1.fb9d63490805bp-8, 0x1.0d40497320dep-12, -0x1.4a7f052ad57a2p-15,
     0x1.5e9d23e7a71ep-17, -0x1.e3ecb1b3fdf06p-19, 0x1.84e0e63713564p-20, -0x1.58cca4577c59ap-21, 0x1.476986c7c0301p-22,
     -0x1.47e2470dba369p-23, 0x1.546f2c748b0b4p-24}, /* [411] 1.375 <= y <= 1.5 2^-9, degree 10, 65.1 bits */
    {0x1.1d78d978665ddp+0, 0x1.2a183fa2e35dcp-56, -0x1.f7861143d31f6p-8, 0x1.fd6f6c5b2b9bep-13, -0x1.22f66d3201016p-15,
     0x1.1d13d8b882fa6p-17, -0x1.6a759047a65e2p-19, 0x1.0c14935010d49p-20, -0x1.b5668b9909d88p-22,
     0x1.7e1b82e29f229p-23, -0x1.5fdf641ed5984p-24, 0x1.501353e987734p-25},
     /* [412] 1.5 <= y <= 1.625 2^-9, degree 10, 71.1 bits */
    {0x1.1d3a2749c6ff8p+0, -0x1.5668d47b7676p-54, -0x1.f3a569dc4b488p-8, 0x1.e3b973e830f79p-13, -0x1.0291314f4af6bp-15,
     0x1.d6e91576b784p-18, -0x1.158f00d1e4232p-19, 0x1.7c561fa21b54cp-21, -0x1.1f55bd63fd20fp-22, 0x1.d0d6f3acb4e38p-24,
     -0x1.8c3348336b3dep-25, 0x1.5e59b1333e54ep-26}, /* [413] 1.625 <= y <= 1.75 2^-9, degree 10, 66.3 bits */
    {0x1.1cfbee1841d8ep+0, -0x1.bfdbf6cb8ee4ep-54, -0x1.eff5536cf3062p-8, 0x1.ccc8a5683847bp-13, -0x1.cf4345e2c663dp-16,
     0x1.8a33a3481b577p-18, -0x1.b139db440eb6ap-20, 0x1.147dac421e51bp-21, -0x1.8504e5d2ff309p-23,
     0x1.24fa555552c72p-24, -0x1.d0da24e115842p-26, 0x1.7eae54d04279dp-27},
     /* [414] 1.75 <= y <= 1.875 2^-9, degree 10, 70.1 bits */
    {0x1.1cbe28253bfdap+0, 0x1.d27a86f5e58fdp-56, -0x1.ec70bc4315e92p-8, 0x1.b8292ccba0679p-13, -0x1.a1e7a97dc57a1p-16,
     0x1.4dd9eb4d65856p-18, -0x1.57b27857a8d59p-20, 0x1.9a9e976461dc1p-22, -0x1.0e48f8aefc7c9p-23,
     0x1.7cde625e31d55p-25, -0x1.1a98213c25385p-26, 0x1.b33d225eb5b3p-28},
     /* [415] 1.875 <= y <= 2 2^-9, degree 10, 65.7 bits */
    {0x1.1c624c258089ap+0, 0x1.51fb18871498fp-54, -0x1.e77240a629dc9p-7, 0x1.9cd073e15be69p-11, -0x1.6a18b51aa3a08p-13,
     0x1.091c60a0b0e0ap-14, -0x1.f2b81d28e73d7p-16, 0x1.0fdb4c180faabp-16, -0x1.466c500107c5bp-17,
     0x1.a36fff617991fp-18, -0x1.1cbe8e4663aaep-18, 0x1.8fead11bff6a9p-19},
     /* [416] 1 <= y <= 1.125 2^-8, degree 10, 64.7 bits */
    {0x1.1be93893cf013p+0, 0x1.b846e587f1418p-54, -0x1.e13f07178e468p-7, 0x1.7db2c0ab17c1ep-11, -0x1.3062ed73586cdp-13,
     0x1.916dc9bd30961p-15, -0x1.52c356912de55p-16, 0x1.4ad875a2b3ad8p-17, -0x1.639fd4d7a7d6fp-18,
     0x1.98f26bf8fbd4ep-19, -0x1.f05580077441dp-20, 0x1.37cd1b3c5612cp-20},
     /* [417] 1.125 <= y <= 1.25 2^-8, degree 10, 66.5 bits */
    {0x1.1b71a3198cb34p+0, 0x1.7ef036195941dp-54, -0x1.db7e5d1bb75b9p-7, 0x1.63531ebde7437p-11, -0x1.041a0a5a0c8e5p-13,
     0x1.384be02892cfbp-15, -0x1.de32208a0598fp-17, 0x1.a712758f96cccp-18, -0x1.9bb11a7e48e37p-19,
     0x1.ac732497a2314p-20, -0x1.d63131124e9a7p-21, 0x1.0b4527916ecadp-21},
     /* [418] 1.25 <= y <= 1.375 2^-8, degree 10, 64.8 bits */
    {0x1.1afb7140b1336p+0, 0x1.a56be2e700b9ep-54, -0x1.d61f87f62ac22p-7, 0x1.4ca29ec52baf3p-11, -0x1.c28928672134p-14,
     0x1.f0d5db8d12dd6p-16, -0x1.5c3ef981fba71p-17, 0x1.19accddf95fa3p-18, -0x1.f4d948dd8dd8ep-20,
     0x1.dc0ff90bab9f8p-21, -0x1.dcd356b9b3b95p-22, 0x1.eef4bb5ed631ap-23},
     /* [419] 1.375 <= y <= 1.5 2^-8, degree 10, 65.5 bits */
    {0x1.1a868c48b287ap+0, -0x1.c1c41d777b51p-56, -0x1.d115632913812p-7, 0x1.38df866aeba12p-11, -0x1.8a9b3d688eaeap-14,
     0x1.9299fca2eea6bp-16, -0x1.044f7e7d8382fp-17, 0x1.83ec2b91b592bp-19, -0x1.3d8284729d222p-20,
     0x1.15c07ae52c292p-21, -0x1.ffc31552d53fbp-23, 0x1.e8c09c459f36dp-24},
     /* [420] 1.5 <= y <= 1.625 2^-8, degree 10, 64.5 bits */
    {0x1.1a12e062a5d68p+0, 0x1.fa158f4a077e7p-55, -0x1.cc556446c9f86p-7, 0x1.277b3037f6e92p-11, -0x1.5cee4bf95e576p-14,
     0x1.4b65b0c3a4cf3p-16, -0x1.8dd6303a47debp-18, 0x1.12d7bec620a7p-19, -0x1.a0e18b9d6e625p-21, 0x1.51cc37f5dc69bp-22,
     -0x1.201ceee27d98dp-23, 0x1.fd99639b80249p-25}, /* [421] 1.625 <= y <= 1.75 2^-8, degree 10, 64.2 bits */
    {0x1.19a05c21474b9p+0, -0x1.2c0ebb84bc0edp-54, -0x1.c7d6f13e5b98fp-7, 0x1.1809f834a1936p-11, -0x1.3714e0edf1267p-14,
     0x1.147aa11ed2ccdp-16, -0x1.35cf13b841e5dp-18, 0x1.8f12ada12273bp-20, -0x1.19fdc946af968p-21,
     0x1.a9a747231ba0ap-23, -0x1.51ffdbc506916p-24, 0x1.1655ab6f000e5p-25},
     /* [422] 1.75 <= y <= 1.875 2^-8, degree 10, 66.0 bits */
    {0x1.192ef00c7cc8ap+0, -0x1.e075a515879b1p-54, -0x1.c392ea63bf29fp-7, 0x1.0a38efba78135p-11, -0x1.1752329c51f4cp-14,
     0x1.d2bbdfbef9888p-17, -0x1.ea7b5486d3494p-19, 0x1.27eb016271dfep-20, -0x1.8783fc979be9fp-22,
     0x1.148b6d96002a2p-23, -0x1.9ae0055250c11p-25, 0x1.3c8f6dd34005ap-26},
     /* [423] 1.875 <= y <= 2 2^-8, degree 10, 67.0 bits */
    {0x1.1886bd5d9f6a3p+0, 0x1.b4c689a99e013p-56, -0x1.bd8d99ec5a44ap-6, 0x1.f002500372327p-10, -0x1.e0cea6b7fb72ep-12,
     0x1.70cafa3c02cf9p-13, -0x1.62a67552c5caep-14, 0x1.86f62293c25fp-15, -0x1.d82a4e1f25ae2p-16, 0x1.304ae4f3d4e68p-16,
     -0x1.9dd27f5cfb3b2p-17, 0x1.22d429600e32cp-17}, /* [424] 1 <= y <= 1.125 2^-7, degree 10, 63.3 bits */
    {0x1.17a9d83a8a269p+0, -0x1.6b3823d493142p-57, -0x1.b6225aa71a2d6p-6, 0x1.c6dcd9ab49816p-10, -0x1.90c6e0fcc7139p-12,
     0x1.1566d5db8e425p-13, -0x1.df97ebeab9c45p-15, 0x1.da4c7f18ac837p-16, -0x1.00a968188a7cap-16,
     0x1.2847bd4d1db26p-17, -0x1.685f5f382e373p-18, 0x1.c55becc80b1a8p-19},
     /* [425] 1.125 <= y <= 1.25 2^-7, degree 10, 63.3 bits */
    {0x1.16d081e77d5fbp+0, -0x1.981ceae11494dp-54, -0x1.af4dfcb7de10fp-6, 0x1.a445d24c09129p-10, -0x1.53c2276a0244p-12,
     0x1.ace449ef096b8p-14, -0x1.50ee1b1df41b4p-15, 0x1.2e42828f3004ep-16, -0x1.2871c15674a46p-17,
     0x1.35ec542488d0fp-18, -0x1.550a285e82c32p-19, 0x1.845387b588b58p-20},
     /* [426] 1.25 <= y <= 1.375 2^-7, degree 10, 65.6 bits */
    {0x1.15fa74f71f12cp+0, 0x1.f0ebbf81eb0f8p-54, -0x1.a8f97164447cdp-6, 0x1.86be63d2a3a5p-10, -0x1.240fb32da7ebdp-12,
     0x1.5312b419506fep-14, -0x1.e8783a7a72498p-16, 0x1.911dc07b702b5p-17, -0x1.67c2afb091d07p-18,
     0x1.57c3b797acdbap-19, -0x1.596eb752d8ad2p-20, 0x1.6747886f4b3c4p-21},
     /* [427] 1.375 <= y <= 1.5 2^-7, degree 10, 63.6 bits */
    {0x1.1527762d7662fp+0, 0x1.3b6b95cb8699ep-54, -0x1.a312b895b9343p-6, 0x1.6d36171b51203p-10, -0x1.fc00d1d34ebd8p-13,
     0x1.112105356ddb9p-14, -0x1.6b72d077bdfe8p-16, 0x1.13412b53c214p-17, -0x1.c6f7907fc0fe1p-19, 0x1.905fe9291473fp-20,
     -0x1.723cd92aeb0fp-21, 0x1.626f9aaa5d1a7p-22}, /* [428] 1.5 <= y <= 1.625 2^-7, degree 10, 69.1 bits */
    {0x1.14575258d16eep+0, 0x1.229783451dcdfp-55, -0x1.9d8b78ea6d63dp-6, 0x1.56e53b2921f52p-10, -0x1.be34106ad9627p-13,
     0x1.bf0eeeb6d9a91p-15, -0x1.147804061d1ap-16, 0x1.84ac57bbf40fdp-18, -0x1.29e350d6a200dp-19, 0x1.e5f586f689704p-21,
     -0x1.a041667ed4bc5p-22, 0x1.7126ba98eb4c5p-23}, /* [429] 1.625 <= y <= 1.75 2^-7, degree 10, 63.9 bits */
    {0x1.1389dcbe973ccp+0, 0x1.54d259444cc8fp-55, -0x1.98580e55a86f3p-6, 0x1.4335d1b6a8b07p-10, -0x1.8b487e80d0e0cp-13,
     0x1.72e4f5089d334p-15, -0x1.aca89bc7e6ff6p-17, 0x1.192fe596be93fp-18, -0x1.91e86231cc0cbp-20,
     0x1.318954f9559b5p-21, -0x1.e78da9db38faep-23, 0x1.92c3d3e2422d7p-24},
     /* [430] 1.75 <= y <= 1.875 2^-7, degree 10, 63.4 bits */
    {0x1.12beedecdcee6p+0, -0x1.e1b21c951a4fbp-54, -0x1.936ee2ebd3af2p-6, 0x1.31b4d106730f1p-10, -0x1.60ca08660cd48p-13,
     0x1.375ee29b638fap-15, -0x1.51d23fd90a52ap-17, 0x1.9f8affb89b6b4p-19, -0x1.163bb1f440b57p-20,
     0x1.8c277d157a862p-22, -0x1.27d71487e59c6p-23, 0x1.c97c96b50e80dp-25},
     /* [431] 1.875 <= y <= 2 2^-7, degree 10, 63.4 bits */
    {0x1.1192f8ba6ad94p+0, -0x1.c0ee3a9dc3054p-56, -0x1.8c8b34429e89fp-5, 0x1.1acb0d9ad59d6p-8, -0x1.2d0f1927caf65p-10,
     0x1.e83e245386ea6p-12, -0x1.e55e2bc30c977p-13, 0x1.111064676a68ap-13, -0x1.4e23afaca9338p-14,
     0x1.b272b82a9ba4bp-15, -0x1.292e6a3d4ffc2p-15, 0x1.a36e301de2a94p-16},
     /* [432] 1 <= y <= 1.125 2^-6, degree 10, 62.8 bits */
    {0x1.100ab4dc5f3fep+0, -0x1.42344bf35637bp-55, -0x1.841eac72e504dp-5, 0x1.012963dce541dp-8, -0x1.f0aa835d53326p-11,
     0x1.6ba8a5f9ad543p-12, -0x1.4570e14415abap-13, 0x1.48fb788f52af5p-14, -0x1.693760e92eee4p-15,
     0x1.a511aa2f83dc7p-16, -0x1.01d5bef459b89p-16, 0x1.45eed9ec35bdfp-17},
     /* [433] 1.125 <= y <= 1.25 2^-6, degree 10, 62.4 bits */
    {0x1.0e8a7d23591fdp+0, -0x1.4fc063d33ff74p-54, -0x1.7c6d3139527d8p-5, 0x1.d7a8dd5f11c62p-9, -0x1.a107c0a2b2a7p-11,
     0x1.168b1feba9b1ep-12, -0x1.c598ef0fe6aa7p-14, 0x1.a07721f9f97b1p-15, -0x1.9ed986e5b365bp-16,
     0x1.b665bf4ef91cfp-17, -0x1.e61e0d479816p-18, 0x1.16499d36e2be2p-18},
     /* [434] 1.25 <= y <= 1.375 2^-6, degree 10, 62.4 bits */
    {0x1.0d11a63c80eb9p+0, -0x1.d9e672dbed5f5p-55, -0x1.7558a75e594cbp-5, 0x1.b392816c19d78p-9, -0x1.63564face865p-11,
     0x1.b49c839745103p-13, -0x1.464629478da0dp-14, 0x1.1282488df1d2ep-15, -0x1.f4a2110172125p-17,
     0x1.e3f50f8b2589dp-18, -0x1.eab71968bba8dp-19, 0x1.05535563a9e7p-19},
     /* [435] 1.375 <= y <= 1.5 2^-6, degree 10, 62.8 bits */
    {0x1.0b9f9f555e609p+0, 0x1.339f4d63225a9p-55, -0x1.6ec9c4453bae8p-5, 0x1.94a2132779d29p-9, -0x1.3286265f3dd36p-11,
     0x1.5cd40a51f4435p-13, -0x1.e1f2bd25f256fp-15, 0x1.76524ba3aefb1p-16, -0x1.3acec26d7df6bp-17,
     0x1.1880a35d4fedap-18, -0x1.05c3053f0b408p-19, 0x1.f892ee23ce12fp-21},
     /* [436] 1.5 <= y <= 1.625 2^-6, degree 10, 65.0 bits */
    {0x1.0a33ec541833bp+0, 0x1.922bc34968d21p-54, -0x1.68ae1f0d96601p-5, 0x1.79cda46d1058bp-9, -0x1.0b356b11342acp-11,
     0x1.1b47e710ae38cp-13, -0x1.6c03b9ffe1ce7p-15, 0x1.06a0513df5f1fp-16, -0x1.99fe0588f3852p-18,
     0x1.52dc1010da9a1p-19, -0x1.251a21cb61d0fp-20, 0x1.05d7e98190e47p-21},
     /* [437] 1.625 <= y <= 1.75 2^-6, degree 10, 62.1 bits */
    {0x1.08ce21a52f475p+0, -0x1.47cefda2a39fap-55, -0x1.62f6e6ebadad1p-5, 0x1.624eeae8d142cp-9, -0x1.d61dbbf55724bp-12,
     0x1.d29bd1672bf5ep-14, -0x1.18483e3b28cfdp-15, 0x1.79aff52fb86bdp-17, -0x1.1319997bb5f67p-18,
     0x1.a81c7cfac119ap-20, -0x1.55e8c91444048p-21, 0x1.1cad09f67c44ap-22},
     /* [438] 1.75 <= y <= 1.875 2^-6, degree 10, 63.3 bits */
    {0x1.076de11b9e88p+0, 0x1.b7b4900786d3p-56, -0x1.5d9800467b96dp-5, 0x1.4d8ee231ed555p-9, -0x1.a0d65e9eaf6cp-12,
     0x1.8503954f2c3e9p-14, -0x1.b6e57311a760ep-16, 0x1.156e89715ba76p-17, -0x1.7ae5dd6baeef2p-19,
     0x1.11adaea1b43e7p-20, -0x1.9d3f3fe5d9d27p-22, 0x1.4233ecf425781p-23},
     /* [439] 1.875 <= y <= 2 2^-6, degree 10, 62.1 bits */
    {0x1.05672ffb54d45p+0, 0x1.939d89dd06929p-55, -0x1.5619c451cb0aap-4, 0x1.329b214fcf073p-7, -0x1.608374badb78dp-9,
     0x1.2e081c18e84afp-10, -0x1.385e5a9ab4377p-11, 0x1.6984c99e9eea4p-12, -0x1.c38eb257b1408p-13,
     0x1.2a17880e1b02ap-13, -0x1.9ca3dcdcfc07fp-14, 0x1.25d62d906a02ep-14},
     /* [440] 1 <= y <= 1.125 2^-5, degree 10, 61.1 bits */
    {0x1.02c43d9a252b4p+0, -0x1.ab1e85936bb1ep-54, -0x1.4d006004145c2p-4, 0x1.14c0d59f4d18p-7, -0x1.1fa7bc3a58136p-9,
     0x1.bc954dadfc374p-11, -0x1.9e0e875186e24p-12, 0x1.aee28dca331b6p-13, -0x1.e362b2db1f2fap-14,
     0x1.1e5e343b994c9p-14, -0x1.632c58e6a2208p-15, 0x1.c56f50ecadadbp-16},
     /* [441] 1.125 <= y <= 1.25 2^-5, degree 10, 62.4 bits */
    {0x1.00329e3f69391p+0, -0x1.9053b2c87fd7bp-54, -0x1.44bfbdf6b72edp-4, 0x1.f852123b029d2p-8, -0x1.de772d7a61ddep-10,
     0x1.50d8090d6ae9bp-11, -0x1.1d781101758f2p-12, 0x1.0dfc3521cc1bfp-13, -0x1.12ff87c8f67b4p-14, 0x1.279ee5f7acf1p-15,
     -0x1.4c3ba03c96fc3p-16, 0x1.8071971f160d5p-17}, /* [442] 1.25 <= y <= 1.375 2^-5, degree 10, 64.3 bits */
    {0x1.fb618d79b7b0fp-1, 0x1.7f8f8048962cap-55, -0x1.3d333bf789498p-4, 0x1.cf177bce284b6p-8, -0x1.943851608cfeap-10,
     0x1.05627aaa071cp-11, -0x1.96981198451b8p-13, 0x1.608a2903070b5p-14, -0x1.48ecb7e457f2dp-15, 0x1.43af60e4f4983p-16,
     -0x1.4ca960a28f947p-17, 0x1.60124382923bap-18}, /* [443] 1.375 <= y <= 1.5 2^-5, degree 10, 64.3 bits */
    {0x1.f67ad81cf4e49p-1, 0x1.4dbf7f85e846ap-56, -0x1.363eceb7085f2p-4, 0x1.ac079a2029483p-8, -0x1.5a08cc2bd3a58p-10,
     0x1.9ddd53c3c2699p-12, -0x1.2982dea67cb9fp-13, 0x1.dc6cbadcc0042p-15, -0x1.9a2e24abf103cp-16,
     0x1.74426d481e506p-17, -0x1.6087e928dcc7bp-18, 0x1.57d0aec33e3e4p-19},
     /* [444] 1.5 <= y <= 1.625 2^-5, degree 10, 63.9 bits */
    {0x1.f1aee9b5052e8p-1, -0x1.a44f70ce5ced8p-57, -0x1.2fcc82161afa3p-4, 0x1.8dd855422d87dp-8, -0x1.2b94a7f6ae683p-10,
     0x1.4d46f75e422e8p-12, -0x1.bd860876103e6p-14, 0x1.4b706787458e4p-15, -0x1.08f49a5676c95p-16,
     0x1.be5091994cbc4p-18, -0x1.87f62dc40ed51p-19, 0x1.628225eb12f04p-20},
     /* [445] 1.625 <= y <= 1.75 2^-5, degree 10, 61.1 bits */
    {0x1.ecfbde0a1e194p-1, -0x1.9f4289f2942c4p-57, -0x1.29cad30b4829dp-4, 0x1.7395c651bb3c5p-8, -0x1.05e65ef170b7fp-10,
     0x1.1059c859af549p-12, -0x1.544154dccf927p-14, 0x1.d8d70f3011135p-16, -0x1.60d76fbb10356p-17,
     0x1.154717a6cfeebp-18, -0x1.c61f217b3b2c3p-20, 0x1.7ef915dfc2d3p-21},
     /* [446] 1.75 <= y <= 1.875 2^-5, degree 10, 61.1 bits */
    {0x1.e8600ffedd2e3p-1, -0x1.0a3d268899927p-57, -0x1.242b8fb4fcb4ep-4, 0x1.5c87bf1c43628p-8, -0x1.cdd2fd49ce9eep-11,
     0x1.c2da3be9255bep-13, -0x1.085f0aec40e61p-14, 0x1.58b29bf59c756p-16, -0x1.e26bf9212c31bp-18,
     0x1.635d87f4bb32dp-19, -0x1.10a20ba864815p-20, 0x1.aec85187f428p-22},
     /* [447] 1.875 <= y <= 2 2^-5, degree 10, 63.0 bits */
    {0x1.e19ed1cb36c28p-1, 0x1.a0664f4b0e6f4p-56, -0x1.1c5c3b8aecb74p-3, 0x1.3ec7dee367c39p-6, -0x1.83a2462d4e539p-8,
     0x1.5a98e2a0b0419p-9, -0x1.7453077231a8ep-10, 0x1.bc6728f25026bp-11, -0x1.1c7f27c3298b9p-11, 0x1.7f3b3121da97p-12,
     -0x1.0db1a4483448bp-12, 0x1.8564187976921p-13}, /* [448] 1 <= y <= 1.125 2^-4, degree 10, 60.8 bits */
    {0x1.d8e259976a412p-1, 0x1.d1ee20a7f776ep-55, -0x1.12ed5a4c5da4cp-3, 0x1.1e17ce5057bafp-6, -0x1.39a05305de741p-8,
     0x1.f84267025e302p-10, -0x1.e73ae6b09c7acp-11, 0x1.056801d4d47eep-11, -0x1.2cac3faf191cfp-12,
     0x1.6b9ffc223cbf7p-13, -0x1.cac779d9b578ap-14, 0x1.290f4f9b62859p-14},
     /* [449] 1.125 <= y <= 1.25 2^-4, degree 10, 60.2 bits */
    {0x1.d06d86fc3304ap-1, 0x1.14701cc25086ap-57, -0x1.0a6ae3e31db67p-3, 0x1.035ffe39081cfp-6, -0x1.02fa13e80e43cp-8,
     0x1.7a2cd64bf76c2p-10, -0x1.4c126d14c12fcp-11, 0x1.43ba474a440cdp-12, -0x1.521af7479cb0cp-13,
     0x1.7316e652ac69ep-14, -0x1.a8680ea13883ep-15, 0x1.f26164cdcbce2p-16},
     /* [450] 1.25 <= y <= 1.375 2^-4, degree 10, 60.4 bits */
    {0x1.c839a417aa64p-1, 0x1.d4b7f23e52bd1p-57, -0x1.02ab79be06e69p-3, 0x1.da408a21fac3ep-7, -0x1.b2f6a6283cf18p-9,
     0x1.22d544984ce1fp-10, -0x1.d416a78f8faa8p-12, 0x1.a22adf5b6fe2ep-13, -0x1.900bf53cf1d75p-14,
     0x1.92023a96d6bd2p-15, -0x1.a48fce4aee80ap-16, 0x1.c3dab4b5447c9p-17},
     /* [451] 1.375 <= y <= 1.5 2^-4, degree 10, 61.0 bits */
    {0x1.c0411b7ed8417p-1, 0x1.0a1fd02bef5bcp-55, -0x1.f71f7e1c8c352p-4, 0x1.b49e6dd305c59p-7, -0x1.727943932017cp-9,
     0x1.c8db30eb9018ap-11, -0x1.534e587aacf02p-12, 0x1.17c4c7c76c0c6p-13, -0x1.ede52164faea5p-15,
     0x1.c9c48af33a605p-16, -0x1.b95cd6261b62ep-17, 0x1.b51a002883bf3p-18},
     /* [452] 1.5 <= y <= 1.625 2^-4, degree 10, 61.7 bits */
    {0x1.b87f35035f5b2p-1, 0x1.05a1a20f22a6ep-55, -0x1.e9feb899bd736p-4, 0x1.945f21f255b15p-7, -0x1.3f5efc6bf51efp-9,
     0x1.6d537cfed716bp-11, -0x1.f7cb69b8da14bp-13, 0x1.81b8c83b982f7p-14, -0x1.3c13a7671621ep-15,
     0x1.0fe223d02e275p-16, -0x1.e64351141b1b6p-18, 0x1.beb0081d66347p-19},
     /* [453] 1.625 <= y <= 1.75 2^-4, degree 10, 61.6 bits */
    {0x1.b0efe5dccbcdbp-1, -0x1.a98e34579a77p-55, -0x1.ddce184ea2621p-4, 0x1.786d7e7698cf6p-7, -0x1.163171c1379c3p-9,
     0x1.28b0ad0138a6p-11, -0x1.7dc730c224f6p-13, 0x1.10d4d8d8b37p-14, -0x1.a14a9e8fa800bp-16, 0x1.4ee67990ac07p-17,
     -0x1.1746b1a231775p-18, 0x1.de7ed8dacf58ep-20}, /* [454] 1.75 <= y <= 1.875 2^-4, degree 10, 60.8 bits */
    {0x1.a98fadafd26e6p-1, 0x1.df6f8e821e1b7p-57, -0x1.d26e94c2ae7efp-4, 0x1.5ff9f0b979003p-7, -0x1.e90e4ab03c1e7p-10,
     0x1.e87103cc94bb4p-12, -0x1.2688ca9c60d06p-13, 0x1.8ab134fbdd7b1p-15, -0x1.1af9f13d78f6ep-16,
     0x1.ab1d318264c6ep-18, -0x1.4bc01feeb1d32p-19, -0x1.26cdc47cf4321p-20},
     /* [455] 1.875 <= y <= 2 2^-4, degree 10, 61.8 bits */
    {0x1.9ed10aff67501p-1, 0x1.02ca9ad375057p-58, -0x1.c2b12738575a7p-3, 0x1.4088353e9e775p-5, -0x1.98f6526bb4171p-7,
     0x1.74d2ddc457fabp-8, -0x1.9add21717f81ep-9, 0x1.f77501d034213p-10, -0x1.4a0db898cb448p-10, 0x1.c5f27e1bf1766p-11,
     -0x1.455dad2232ca3p-11, 0x1.dd4e208e71cep-12}, /* [456] 1 <= y <= 1.125 2^-3, degree 10, 62.2 bits */
    {0x1.91089d851f7a9p-1, 0x1.187e59a9a6513p-55, -0x1.afc5e5f1dce0cp-3, 0x1.1e1c6c4a031b6p-5, -0x1.49a839cfe0f3dp-7,
     0x1.0d1f5b033c6c6p-8, -0x1.09e7884be37a5p-9, 0x1.2471a76683274p-10, -0x1.5834e3882e6dp-11, 0x1.a8e3bb0753a46p-12,
     -0x1.10f59da8a7835p-12, 0x1.672b16d7a2b33p-13}, /* [457] 1.125 <= y <= 1.25 2^-3, degree 10, 59.6 bits */
    {0x1.83cf81d25abe8p-1, -0x1.8442157aaa021p-55, -0x1.9ecbbe834ca78p-3, 0x1.0210b11851047p-5, -0x1.0f7fc0128d98ap-7,
     0x1.913c6084582e6p-9, -0x1.671f3d5477544p-10, 0x1.6637487fa1098p-11, -0x1.7e84436ee3cc9p-12, 0x1.ac596ecbe0fc4p-13,
     -0x1.f2ca0b5026404p-14, 0x1.2990626ab2e07p-14}, /* [458] 1.25 <= y <= 1.375 2^-3, degree 10, 60.2 bits */
    {0x1.7717a0ccaafa4p-1, 0x1.d71ce233a8e25p-55, -0x1.8f6a9a3db3239p-3, 0x1.d58682908fe75p-6, -0x1.c726df938c6d7p-8,
     0x1.3322a132be03dp-9, -0x1.f6499c96bae9bp-11, 0x1.ca4b2736a8c0cp-12, -0x1.bfdaf3ae94cc8p-13, 0x1.caf6dbefdb1e9p-14,
     -0x1.e8bd890c95f18p-15, 0x1.0abd98dd878e9p-15}, /* [459] 1.375 <= y <= 1.5 2^-3, degree 10, 59.5 bits */
    {0x1.6ad547e8b503bp-1, 0x1.1f1492e54d78fp-55, -0x1.81600e97d1674p-3, 0x1.ae2bf933eef84p-6, -0x1.832afb803448ap-8,
     0x1.e0c50460dfea5p-10, -0x1.69b6e1b88526bp-11, 0x1.3009c1e314fb3p-12, -0x1.11dd1a464cd61p-13,
     0x1.02804ec2e58e8p-14, -0x1.fd27b06b5aeabp-16, 0x1.57d4d422bd03ep-16},
     /* [460] 1.5 <= y <= 1.625 2^-3, degree 10, 60.2 bits */
    {0x1.5efe98226d25ep-1, -0x1.be990dee5a5c7p-62, -0x1.7478c6319d143p-3, 0x1.8c7cb569e9993p-6, -0x1.4d76014b33b6ap-8,
     0x1.7f750cf82812dp-10, -0x1.0b0f8137e4c21p-11, 0x1.a01507d201531p-13, -0x1.5b92896f4778dp-14,
     0x1.308fc193e5c2dp-15, -0x1.150e02c260e46p-16, 0x1.0280af6ce9675p-17},
     /* [461] 1.625 <= y <= 1.75 2^-3, degree 10, 61.8 bits */
    {0x1.538b1f8ddac6dp-1, -0x1.d802cb07f06b6p-55, -0x1.688c3dcebe4p-3, 0x1.6f51f174fe41p-6, -0x1.22479253da7ap-8,
     0x1.36da6dbdb548dp-10, -0x1.92e9f4e7e61b9p-12, 0x1.2464102e5ab2fp-13, -0x1.c762118983ef4p-15,
     0x1.74124e1e89397p-16, -0x1.3b8354fe49754p-17, 0x1.12747865aad1dp-18},
     /* [462] 1.75 <= y <= 1.875 2^-3, degree 10, 61.2 bits */
    {0x1.48738eec75783p-1, 0x1.8cd276421e945p-56, -0x1.5d79e966b138fp-3, 0x1.55d00a5cd5166p-6, -0x1.fe0ebf79f3ecp-9,
     0x1.ff29f654d719p-11, -0x1.35acb0a89f21p-12, 0x1.a491e5f9861dbp-14, -0x1.32af9f63a5203p-15, 0x1.d56ec8bc0e1eep-17,
     -0x1.74cf2a2a72076p-18, 0x1.2fc4ae174963fp-19}, /* [463] 1.875 <= y <= 2 2^-3, degree 10, 62.4 bits */
    {0x1.386ec40be1e7bp-1, -0x1.a3131277da8f8p-57, -0x1.4e3ec0679723fp-2, 0x1.35070e6183a91p-4, -0x1.aa46bc9735cc8p-6,
     0x1.85dd3643d50e3p-7, -0x1.ae1f6d1d0ec28p-8, 0x1.0a48d114a08b5p-8, -0x1.6277bd63cd651p-9, 0x1.ef7d3ba6606cep-10,
     -0x1.68cf879349aa2p-10, 0x1.0c8f65245f7edp-10}, /* [464] 1 <= y <= 1.125 2^-2, degree 10, 58.5 bits */
    {0x1.241f0dab6a951p-1, -0x1.8278395ff9863p-55, -0x1.3c1792dd62c5ep-2, 0x1.112994156211dp-4, -0x1.5757f35f196d2p-6,
     0x1.1981e33bd7f5p-7, -0x1.1556c609f7127p-8, 0x1.330252824bd45p-9, -0x1.6deef679f4b17p-10, 0x1.ca651fde054f6p-11,
     -0x1.2ae6f336e3ba3p-11, 0x1.8ee22b741cd27p-12}, /* [465] 1.125 <= y <= 1.25 2^-2, degree 10, 58.2 bits */
    {0x1.10e10e3a622e9p-1, 0x1.84ac6feed0f5cp-56, -0x1.2bf623a480167p-2, 0x1.e7eea9df7f67ap-5, -0x1.1a798d36d81ecp-6,
     0x1.a44166f0b3604p-8, -0x1.75e1be1c13f07p-9, 0x1.75f72baa87d1ap-10, -0x1.9354af4573df3p-11, 0x1.c9984de62b81ap-12,
     -0x1.0e244dae370efp-12, 0x1.46ae82c92ef4fp-13}, /* [466] 1.25 <= y <= 1.375 2^-2, degree 10, 58.6 bits */
    {0x1.fd2edf192831ap-2, 0x1.dd21b7c59db04p-57, -0x1.1d7e40e0361fbp-2, 0x1.b779cff995e2p-5, -0x1.d8db9f99bf8f1p-7,
     0x1.425079747eb37p-8, -0x1.055f58c9ad5a1p-9, 0x1.dc983f21f8966p-11, -0x1.d520dee0d7c0bp-12, 0x1.e63cdcc7f7619p-13,
     -0x1.0637706695fd4p-13, 0x1.21e4d54356c93p-14}, /* [467] 1.375 <= y <= 1.5 2^-2, degree 10, 58.9 bits */
    {0x1.da53bd2d62869p-2, 0x1.bcfabb40d8c4p-57, -0x1.106a4b279b393p-2, 0x1.8ea0ea2cc7a5ap-5, -0x1.91706876d50f6p-7,
     0x1.f9a69880c0551p-9, -0x1.78bd5c3c5e6dap-10, 0x1.3b694c4129f51p-11, -0x1.1d66599471f77p-12, 0x1.10307a0f573cap-13,
     -0x1.0e29d00bb383p-14, 0x1.13129759ebfe6p-15}, /* [468] 1.5 <= y <= 1.625 2^-2, degree 10, 58.9 bits */
    {0x1.b907bae48e677p-2, 0x1.34810491c472fp-57, -0x1.0484562e9d772p-2, 0x1.6bbe44ba24149p-5, -0x1.58e3f5162f3f5p-7,
     0x1.9439364f8da9dp-9, -0x1.169c2c4a2caecp-10, 0x1.af1f6a72820cap-12, -0x1.68cccc9a2dae2p-13, 0x1.3e8e182221b89p-14,
     -0x1.24c4a76bc0d6ap-15, 0x1.1494545d626p-16}, /* [469] 1.625 <= y <= 1.75 2^-2, degree 10, 58.4 bits */
    {0x1.9927dc24cde2p-2, -0x1.9c41e944e2978p-56, -0x1.f34375db1571cp-3, 0x1.4d9ea46250fcbp-5, -0x1.2b5275b68c93fp-7,
     0x1.4866aa5f39beep-9, -0x1.a54af438bd25p-11, 0x1.2ee7112916f0fp-12, -0x1.d762c033cf4c6p-14, 0x1.82b4421df1009p-15,
     -0x1.4d2a9e1b67f0bp-16, 0x1.1324134b48aa1p-16}, /* [470] 1.75 <= y <= 1.875 2^-2, degree 10, 61.0 bits */
    {0x1.7a95ee490f6cep-2, -0x1.79a0c80a3e7b8p-60, -0x1.df40432750d5cp-3, 0x1.335cad3de81aap-5, -0x1.060ba5124e28fp-7,
     0x1.0e8913bb7af68p-9, -0x1.44ad6ab585aeep-11, 0x1.b3faab4dde6dfp-13, -0x1.3ce278b565401p-14, 0x1.e6ccf557f6332p-16,
     -0x1.858d5b5c88e6dp-17, 0x1.406792b4980edp-18} /* [471] 1.875 <= y <= 2 2^-2, degree 10, 61.2 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_beta_zero_overlap)

/* (1 - eps)/beta at zero force, beta < 1/8: 9 rows of degree 10 in y = (beta)^(1/3), nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-59.7 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_FORCE_ROWS 9
#define COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_FORCE_END 0.125
COR_ROWS(double, cor_rows_hertz_dashpot_near_loss_zero_force, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.c9ae3p+0, 0x1.10b72bf79765dp-28, -0x1.38009e80fb22cp-72, -0x1.3333333333333p-1, -0x1.474c8c0db13acp+0,
     0x1.91af7e30b42adp-41, 0x1.6e24f33f8ffccp-1, 0x1.60704271d441dp-1, -0x1.a54e341c1c64fp-3, -0x1.316b958ccccf8p-2,
     -0x1.533ee56e42d4ep-2, 0x1.2a23ae9307a87p-3}, /* [0] 0 <= y <= 0.03125, degree 10, 66.2 bits */
    {0x1.c9002ep+0, -0x1.9c5b2d09b146p-27, -0x1.70544ffa57bbfp-4, -0x1.acf7066e6b2a3p-1, -0x1.3f51e65209dc4p+0,
     0x1.0bf9fb7e8b118p-2, 0x1.e745eb8be5dd3p-1, 0x1.1e6cdb34b9b27p-1, -0x1.966a2a4e2bb29p-2, -0x1.d2f92cc84dd64p-2,
     -0x1.bf7959fc2d5d1p-3, 0x1.e7733d14d584fp-3}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 63.5 bits */
    {0x1.c6a5bb8p+0, 0x1.bf0eea0f7b8ecp-28, -0x1.abe7b4cfebb6ep-3, -0x1.1028cff5ae7bdp+0, -0x1.246a722d09e62p+0,
     0x1.2d0bd5424e607p-1, 0x1.1f519af263c15p+0, 0x1.543d73286d225p-2, -0x1.4ba3993d8ef41p-1, -0x1.0f0cd6897beadp-1,
     -0x1.b99b31358939bp-6, 0x1.80e02f6fe83aep-2}, /* [2] 0.09375 <= y <= 0.15625, degree 10, 62.4 bits */
    {0x1.c22c258p+0, 0x1.9e557719f84ap-34, -0x1.6b0fdb0d24746p-2, -0x1.42bdfb6b50d53p+0, -0x1.e67bf347bfe9bp-1,
     0x1.e77746fd5b4e9p-1, 0x1.2fc5a2335f30ep+0, -0x1.0fbef984e219fp-7, -0x1.cf026c8443d01p-1, -0x1.e280cc1983a15p-2,
     0x1.f99c3fef37d21p-3, 0x1.f755a68e8c2f9p-2}, /* [3] 0.15625 <= y <= 0.21875, degree 10, 61.5 bits */
    {0x1.bb2efbp+0, -0x1.fe0a903bbef22p-28, -0x1.0b65336567b59p-1, -0x1.69e6b51ea2931p+0, -0x1.552a685bc5cebp-1,
     0x1.507081e9d680fp+0, 0x1.1a7d086b1329dp+0, -0x1.cb9040f01daabp-2, -0x1.17229c26d94ap+0, -0x1.f1294f12e291ap-3,
     0x1.22cc0a41a7fd5p-1, 0x1.070fcf5be87d1p-1}, /* [4] 0.21875 <= y <= 0.28125, degree 10, 60.4 bits */
    {0x1.b160a3p+0, -0x1.7d2de787efafep-27, -0x1.692b84651419ep-1, -0x1.8157acdee4c3ep+0, -0x1.309a78b4a9bddp-2,
     0x1.9f8d80e9c8001p+0, 0x1.afef4bf600771p-1, -0x1.e0d6252d817abp-1, -0x1.1e0f9e6abe4cdp+0, 0x1.4ac9fb395c4a2p-3,
     0x1.b4acea331b002p-1, 0x1.74e04dbe58696p-2}, /* [5] 0.28125 <= y <= 0.34375, degree 10, 60.7 bits */
    {0x1.a492d88p+0, 0x1.0ab403e44fd36p-27, -0x1.ca72e4a0f1626p-1, -0x1.856a25f4379c2p+0, 0x1.16cd3bba7a313p-3,
     0x1.d295283820344p+0, 0x1.9d6603c63c194p-2, -0x1.64504e02cd3eap+0, -0x1.d0f3375b94ffdp-1, 0x1.601a4f83da428p-1,
     0x1.f4553c835d063p-1, -0x1.ce372bbe006c9p-10}, /* [6] 0.34375 <= y <= 0.40625, degree 10, 59.8 bits */
    {0x1.94bddc8p+0, 0x1.2f477f43c0ddcp-29, -0x1.15080ba7aa1b9p+0, -0x1.73c73c0d72a48p+0, 0x1.335bfaf4e0b0ep-1,
     0x1.dc3babce5c82bp+0, -0x1.73a317f9f9793p-3, -0x1.b1b597259c7f9p+0, -0x1.b8a28b1085707p-2, 0x1.35534e33d2cf3p+0,
     0x1.a093d82ffaae2p-1, -0x1.1490b86d07bb3p-1}, /* [7] 0.40625 <= y <= 0.46875, degree 10, 60.5 bits */
    {0x1.820507p+0, 0x1.fb22543abd2fbp-29, -0x1.413e67917919dp+0, -0x1.4c0415e71e199p+0, 0x1.0cc3a49110561p+0,
     0x1.b3b72e4c9fc49p+0, -0x1.ab14de0f24392p-1, -0x1.bc53a93b1ccbp+0, 0x1.12f64fe403965p-2, 0x1.89ea5d36f7069p+0,
     0x1.33a7c20ea05e2p-2, -0x1.1514cdab18b86p+0} /* [8] 0.46875 <= y <= 0.53125, degree 10, 59.7 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_loss_zero_force)

/* eps at zero force, 2^-3 <= beta < 8: 96 rows of degree 10 in y = beta 2^-k, 16 to each octave k = -3 ... 2.
 * Relative error of the approximation: 2^-57.3 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_FORCE_FIRST 0.125
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_FORCE_FIRST_OCTAVE (-3)
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_FORCE_OCTAVE_BITS 4
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_FORCE_ROWS 96
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_FORCE_END 8.0
COR_ROWS(double, cor_rows_hertz_dashpot_middle_eps_zero_force, 96, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9ce8949cae2fp-1, 0x1.df29dee47ccaep-55, -0x1.49b08075a2a4ap-3, 0x1.62d0169d30b63p-6, -0x1.7cb846001a001p-9,
     0x1.3138e90a775a7p-11, -0x1.ace5fc0e58f76p-13, 0x1.a6be5600dd035p-14, -0x1.e8d2b171030ffp-15,
     0x1.356e6c9750e11p-15, -0x1.a10bc4a84c146p-16, 0x1.25b4a53bbaafbp-16},
     /* [0] 1 <= y <= 1.0625 2^-3, degree 10, 64.2 bits */
    {0x1.97ccd19ab642ap-1, 0x1.7afca68a7cea4p-57, -0x1.4436ce7556cfep-3, 0x1.5a1aff19d1affp-6, -0x1.6aa13f26018a7p-9,
     0x1.1291abb0be705p-11, -0x1.66b1692728e05p-13, 0x1.4ad03a49381a6p-14, -0x1.6794d05b7a12fp-15,
     0x1.ac961be98d907p-16, -0x1.1006c06193839p-16, 0x1.690374665fd35p-17},
     /* [1] 1.0625 <= y <= 1.125 2^-3, degree 10, 61.5 bits */
    {0x1.92c6b0d20d7cep-1, 0x1.e9d0f45eea887p-55, -0x1.3edf1f14ed4d9p-3, 0x1.51cd0512bbdfcp-6, -0x1.5a4c20c00aa6cp-9,
     0x1.f194af16fc549p-12, -0x1.2f5e18a74616p-13, 0x1.069ce69d82f6ap-14, -0x1.0d2e5e7eb2f12p-15, 0x1.2f08b33a037b1p-16,
     -0x1.6b7faa40d0994p-17, 0x1.c808ad79e52fcp-18}, /* [2] 1.125 <= y <= 1.1875 2^-3, degree 10, 60.9 bits */
    {0x1.8dd5ad562b7d4p-1, -0x1.0e64bdbb0bceap-56, -0x1.39a7e9ceecf8cp-3, 0x1.49dc75c379e85p-6, -0x1.4b735f52b0045p-9,
     0x1.c5c206d4003f2p-12, -0x1.032ba83396337p-13, 0x1.a6563a3e089cdp-15, -0x1.9961589b535dap-16,
     0x1.b48d3dd1b286ap-17, -0x1.f0488b79a2804p-18, 0x1.2726c099915d5p-18},
     /* [3] 1.1875 <= y <= 1.25 2^-3, degree 10, 61.3 bits */
    {0x1.88f94813236dp-1, 0x1.dbd67d1061e77p-56, -0x1.348fc9e27ce97p-3, 0x1.424113a08375dp-6, -0x1.3ddf74fbfd96p-9,
     0x1.a0269f6b8e315p-12, -0x1.bedb9888212e6p-14, 0x1.578f423a55216p-15, -0x1.3bb92604f0881p-16,
     0x1.3fbf2f3ca6cb1p-17, -0x1.596779a84dc4cp-18, 0x1.868a27992c142p-19},
     /* [4] 1.25 <= y <= 1.3125 2^-3, degree 10, 61.4 bits */
    {0x1.8431074969cbdp-1, 0x1.88079a87b2645p-55, -0x1.2f957918214a3p-3, 0x1.3af3cce598958p-6, -0x1.316380ff6b76dp-9,
     0x1.7f990d24813cep-12, -0x1.84684e7cbeb15p-14, 0x1.1a6d005a4523bp-15, -0x1.ed3ed94c308f3p-17,
     0x1.db863f3d2fd4ep-18, -0x1.e9474c076c4e2p-19, 0x1.0790cad61c9e8p-19},
     /* [5] 1.3125 <= y <= 1.375 2^-3, degree 10, 62.0 bits */
    {0x1.7f7c761c6d9ccp-1, -0x1.e5199acb93533p-58, -0x1.2ab7cb87cc075p-3, 0x1.33ee83700acebp-6, -0x1.25dad5637e2bbp-9,
     0x1.6332a737326cp-12, -0x1.5421a9634b988p-14, 0x1.d4cd23a6592a4p-16, -0x1.85cb5e1aaa188p-17, 0x1.667dfb0154012p-18,
     -0x1.60193c049eb15p-19, 0x1.6a3c217496537p-20}, /* [6] 1.375 <= y <= 1.4375 2^-3, degree 10, 62.5 bits */
    {0x1.7adb24307c6ccp-1, -0x1.e69acda8d81ccp-57, -0x1.25f5ac24f7894p-3, 0x1.2d2be13ac2a39p-6, -0x1.1b2729a0e4f42p-9,
     0x1.4a3e5473d0f9ap-12, -0x1.2be44de0c9287p-14, 0x1.8880785fd6cafp-16, -0x1.37540269ae85cp-17,
     0x1.11ad5adce6c52p-18, -0x1.011670be7e7e1p-19, 0x1.fa1fcf1c2ef78p-21},
     /* [7] 1.4375 <= y <= 1.5 2^-3, degree 10, 61.7 bits */
    {0x1.764ca55534a12p-1, -0x1.f7cea508fec3ap-55, -0x1.214e19e52bae7p-3, 0x1.26a73638d2f96p-6, -0x1.112f41da2d5f3p-9,
     0x1.342c4add4e3b7p-12, -0x1.0a115a166f9b4p-14, 0x1.4b45556c1f5d9p-16, -0x1.f62e701dcfbe3p-18, 0x1.a6b1c4602bbap-19,
     -0x1.7c764fb4d368bp-20, 0x1.66f929165fe37p-21}, /* [8] 1.5 <= y <= 1.5625 2^-3, degree 10, 62.5 bits */
    {0x1.71d0913a60a34p-1, 0x1.ed8e7f4cbcfb2p-57, -0x1.1cc0256058f3p-3, 0x1.205c5d3c59825p-6, -0x1.07dde9b35ce91p-9,
     0x1.208932c05e8eep-12, -0x1.dad4fcd543ebdp-15, 0x1.19ab879e847a4p-16, -0x1.98aa2d34a3d4dp-18,
     0x1.49e6db959ec37p-19, -0x1.1cfdef5661ae2p-20, 0x1.022c1f1ec1009p-21},
     /* [9] 1.5625 <= y <= 1.625 2^-3, degree 10, 61.2 bits */
    {0x1.6d66832d871fp-1, 0x1.ca33932d76e52p-55, -0x1.184aeed260e2ep-3, 0x1.1a47a63c2c9fcp-6, -0x1.fe425824761c4p-10,
     0x1.0ef7a5ea56214p-12, -0x1.a9f18cf5e3f4ep-15, 0x1.e248a38cb0426p-17, -0x1.4f545c51f177ap-18,
     0x1.04029e2ab8003p-19, -0x1.afd016645556fp-21, 0x1.78274f2d4675dp-22},
     /* [10] 1.625 <= y <= 1.6875 2^-3, degree 10, 62.0 bits */
    {0x1.690e19ded30c2p-1, 0x1.154d8e549089ap-55, -0x1.13eda46ae6354p-3, 0x1.1465c4bd739b9p-6, -0x1.edd36faed321dp-10,
     0x1.fe56b45600e06p-13, -0x1.7ff5404251417p-15, 0x1.9f85b4f20ab2cp-17, -0x1.15467d1553ef3p-18,
     0x1.9d94af8bb246ep-20, -0x1.4a948d75e6424p-21, 0x1.154db4d3e942p-22},
     /* [11] 1.6875 <= y <= 1.75 2^-3, degree 10, 65.0 bits */
    {0x1.64c6f72c38e68p-1, -0x1.c93eaead39419p-55, -0x1.0fa780dcbf5b3p-3, 0x1.0eb3c1774251bp-6, -0x1.de54cc6dc4e77p-10,
     0x1.e1cafcc904051p-13, -0x1.5badbe21ff93p-15, 0x1.6820194b7719dp-17, -0x1.cdd40fb6b81f7p-19, 0x1.4bb504602293p-20,
     -0x1.ff1b7d3bf20c1p-22, 0x1.9d66f7bf75a28p-23}, /* [12] 1.75 <= y <= 1.8125 2^-3, degree 10, 62.7 bits */
    {0x1.6090bff1f2652p-1, -0x1.373d4b3acca58p-57, -0x1.0b77ca2193835p-3, 0x1.092eee805ec62p-6, -0x1.cfafb4fc85ac9p-10,
     0x1.c7e3ece336d77p-13, -0x1.3c2678f598024p-15, 0x1.39d7110241683p-17, -0x1.832d42c32feb3p-19,
     0x1.0c2273f0bdabfp-20, -0x1.8eb3f3cc015c4p-22, 0x1.3748ad1d54de8p-23},
     /* [13] 1.8125 <= y <= 1.875 2^-3, degree 10, 61.1 bits */
    {0x1.5c6b1bdf92db4p-1, -0x1.4c78c75a4cb43p-57, -0x1.075dd06890bd4p-3, 0x1.03d4dd8181dc6p-6, -0x1.c1d06a966e13bp-10,
     0x1.b04a7602d56e4p-13, -0x1.209a9d08a63f5p-15, 0x1.12eafa25ac90ap-17, -0x1.469dce667f248p-19,
     0x1.b4acf840ba815p-21, -0x1.39a92b4cd3dd2p-22, 0x1.d972c7e534ebbp-24},
     /* [14] 1.875 <= y <= 1.9375 2^-3, degree 10, 61.9 bits */
    {0x1.5855b55116de5p-1, -0x1.abdba6bcc16a2p-55, -0x1.0358ed28ff85ep-3, 0x1.fd46af0acb2c1p-7, -0x1.b4a5ad86ef32ep-10,
     0x1.9ab566e745c51p-13, -0x1.086a89f6cfa98p-15, 0x1.e3faaba832edbp-18, -0x1.152344d94403bp-19, 0x1.660596c84839p-21,
     -0x1.f16eea166a8b1p-23, 0x1.6b3cefbabf2b5p-24}, /* [15] 1.9375 <= y <= 2 2^-3, degree 10, 63.2 bits */
    {0x1.525359b0d6dcfp-1, 0x1.4400817edb62p-55, -0x1.faef959c433f2p-3, 0x1.ee4161c019adep-5, -0x1.a217794e2fc94p-7,
     0x1.7d993905380f8p-9, -0x1.d2af91e05bc5bp-11, 0x1.931105e117b38p-12, -0x1.b5a459a80d65ep-13, 0x1.0cf9c3eaa1137p-13,
     -0x1.646f3285c3a9ap-14, 0x1.f060ca14368f7p-15}, /* [16] 1 <= y <= 1.0625 2^-2, degree 10, 60.9 bits */
    {0x1.4a86186122b56p-1, 0x1.a93191660b68bp-55, -0x1.ebca7a30807c3p-3, 0x1.db32ffe86b186p-5, -0x1.8b52b64aff19dp-7,
     0x1.5bdfb328840d5p-9, -0x1.8f3ec9b1dec4cp-11, 0x1.4065af6f66ea2p-12, -0x1.44f5c36a45701p-13, 0x1.76f2c2db53a09p-14,
     -0x1.d34ee3e18043dp-15, 0x1.32568ad125eb4p-15}, /* [17] 1.0625 <= y <= 1.125 2^-2, degree 10, 61.0 bits */
    {0x1.42f440297b327p-1, 0x1.d40868b5d999ap-58, -0x1.dd39ad6601247p-3, 0x1.c929d1180d89ep-5, -0x1.7682666425e8ep-7,
     0x1.3ede1ae4d191fp-9, -0x1.593efdaee11bap-11, 0x1.027ae51a9d0fp-12, -0x1.eb428f3351989p-14, 0x1.0ad99ed9e6e8dp-14,
     -0x1.39cdda1aaa927p-15, 0x1.8496586291965p-16}, /* [18] 1.125 <= y <= 1.1875 2^-2, degree 10, 61.2 bits */
    {0x1.3b9b8fa9f3966p-1, 0x1.80e0b11cbe172p-56, -0x1.cf355f01ba59ap-3, 0x1.b810058dea328p-5, -0x1.6362b2b12f89fp-7,
     0x1.25aa63f3326ebp-9, -0x1.2d65b5369c3efp-11, 0x1.a6a0359e7239ep-13, -0x1.795213c0e7298p-14, 0x1.83015b4a5cb4dp-15,
     -0x1.aea203aa6b896p-16, 0x1.f91f5b95d3507p-17}, /* [19] 1.1875 <= y <= 1.25 2^-2, degree 10, 61.2 bits */
    {0x1.3479e376a75fap-1, 0x1.1fe278f55ecc2p-55, -0x1.c1b661690456ep-3, 0x1.a7d2ab6ab8b9cp-5, -0x1.51bc8d0734184p-7,
     0x1.0f926b3802683p-9, -0x1.0956a977adf91p-11, 0x1.5da8cb4505cd5p-13, -0x1.26063e25255e5p-14, 0x1.1d672ecde85a9p-15,
     -0x1.2d452df640081p-16, 0x1.4f9c08aaf9a55p-17}, /* [20] 1.25 <= y <= 1.3125 2^-2, degree 10, 61.2 bits */
    {0x1.2d8d33b819147p-1, 0x1.1f0d056f5a677p-55, -0x1.b4b614e496daep-3, 0x1.986128215c1bap-5, -0x1.4162b4df7f8ebp-7,
     0x1.f81902e734687p-10, -0x1.d6b11867f4dfbp-12, 0x1.246f9cad33addp-13, -0x1.d04833b721a59p-15,
     0x1.ab6e655ea7a0ap-16, -0x1.ad0266902d49p-17, 0x1.c6f018dc75d12p-18},
     /* [21] 1.3125 <= y <= 1.375 2^-2, degree 10, 61.3 bits */
    {0x1.26d39216cc8c5p-1, 0x1.1c52f301fba22p-56, -0x1.a82e56970960bp-3, 0x1.89acd089df934p-5, -0x1.322f8aa149536p-7,
     0x1.d5597bd76f46dp-10, -0x1.a4479743dc098p-12, 0x1.edfbc3b46d317p-14, -0x1.72f9fd266f0a1p-15,
     0x1.448dffff2aa48p-16, -0x1.36607b6e4a032p-17, 0x1.39fb81f272cacp-18},
     /* [22] 1.375 <= y <= 1.4375 2^-2, degree 10, 63.5 bits */
    {0x1.204b27e509a0dp-1, -0x1.a1aa1acc89b1cp-55, -0x1.9c19725423486p-3, 0x1.7ba8977b77a22p-5, -0x1.240372c4f785ep-7,
     0x1.b63af4d163f81p-10, -0x1.79834a9b25defp-12, 0x1.a4f867394a2ffp-14, -0x1.2bb087e352e7dp-15,
     0x1.f331ad0ae87d7p-17, -0x1.c7b4c5bcadd7ap-18, 0x1.b8a0b3065afeap-19},
     /* [23] 1.4375 <= y <= 1.5 2^-2, degree 10, 60.5 bits */
    {0x1.19f2347c8b6c7p-1, 0x1.0532b4c5dd856p-55, -0x1.907216bcddfc9p-3, 0x1.6e48cd3a41dcfp-5, -0x1.16c39f0efa662p-7,
     0x1.9a33e2f555e66p-10, -0x1.54eb645313186p-12, 0x1.69b214418e31bp-14, -0x1.e91be36c0202ap-16,
     0x1.846b7f0cd93dbp-17, -0x1.530df8b6a207p-18, 0x1.39e70bd899208p-19},
     /* [24] 1.5 <= y <= 1.5625 2^-2, degree 10, 62.3 bits */
    {0x1.13c70bc7ff018p-1, -0x1.692a4a6e3c6f2p-55, -0x1.85334b2aad702p-3, 0x1.6182eba4e879dp-5, -0x1.0a5921725a1eap-7,
     0x1.80d4a8d6c3955p-10, -0x1.355ca1dbb378p-12, 0x1.391ad8793df24p-14, -0x1.92db6dace0d45p-16, 0x1.31816eae1c995p-17,
     -0x1.feca8035ba6ecp-19, 0x1.c587dd17aeb02p-20}, /* [25] 1.5625 <= y <= 1.625 2^-2, degree 10, 60.7 bits */
    {0x1.0dc814f1cf707p-1, 0x1.e6d0ed5119264p-55, -0x1.7a5867108752cp-3, 0x1.554d6c2ba0d35p-5, -0x1.fd6069c7b8f1cp-8,
     0x1.69c1cfedf428p-10, -0x1.19f34f7e3124ep-12, 0x1.10e9d0d5cca13p-14, -0x1.4eafc7cddaf72p-16, 0x1.e568018b4f951p-18,
     -0x1.851fcfab4bf9dp-19, 0x1.47b50457aaea7p-20}, /* [26] 1.625 <= y <= 1.6875 2^-2, degree 10, 63.0 bits */
    {0x1.07f3c932f834p-1, 0x1.6ccfd207f4f02p-65, -0x1.6fdd0a8c89bddp-3, 0x1.499fa56158039p-5, -0x1.e76f5c7220d35p-8,
     0x1.54afb7699c433p-10, -0x1.01fb8a77131e5p-12, 0x1.dec877d06b27cp-15, -0x1.1848ee34102d4p-16,
     0x1.8535d152f662cp-18, -0x1.2ba83ac8f84d5p-19, 0x1.eb92af79151d9p-21},
     /* [27] 1.6875 <= y <= 1.75 2^-2, degree 10, 60.2 bits */
    {0x1.0248b2bd8bd1cp-1, -0x1.162e23d1cea27p-55, -0x1.65bd17f445f85p-3, 0x1.3e71ae85601c2p-5, -0x1.d2c1164629849p-8,
     0x1.415f5013f7dfcp-10, -0x1.d9cba825aa202p-13, 0x1.a66e69b75e3d1p-15, -0x1.d8f5bfa567116p-17,
     0x1.3ac923333e02bp-18, -0x1.d20669d3ef63dp-20, 0x1.701af555d3574p-21},
     /* [28] 1.75 <= y <= 1.8125 2^-2, degree 10, 60.1 bits */
    {0x1.f98ad77eb9408p-2, -0x1.7959f69d8de44p-56, -0x1.5bf4ae3114051p-3, 0x1.33bc47c9d32cp-5, -0x1.bf3b302004919p-8,
     0x1.2f9b9cb303dd5p-10, -0x1.b47d57bc5aa0fp-13, 0x1.76b9519995fd8p-15, -0x1.91d2c50274e55p-17,
     0x1.00a75fa020288p-18, -0x1.6db74df3be09cp-20, 0x1.168301efea2b9p-21},
     /* [29] 1.8125 <= y <= 1.875 2^-2, degree 10, 60.4 bits */
    {0x1.eed13af39bf94p-2, 0x1.26a003bd5024ap-56, -0x1.528023ca79611p-3, 0x1.2978c66538c83p-5, -0x1.acc64f4f8978fp-8,
     0x1.1f37c3a346b23p-10, -0x1.9350a1e87573cp-13, 0x1.4e0ff54a3361bp-15, -0x1.579bf436dd25ep-17,
     0x1.a5af9ec99757fp-19, -0x1.2177a5d0e6b8bp-20, 0x1.a98919202e25p-22},
     /* [30] 1.875 <= y <= 1.9375 2^-2, degree 10, 61.1 bits */
    {0x1.e461fed89c6a3p-2, -0x1.8a39916f6edffp-57, -0x1.495c0283526fep-3, 0x1.1fa103b4e4931p-5, -0x1.9b4dafea73cddp-8,
     0x1.100d8d0332b82p-10, -0x1.75ac2050a4b36p-13, 0x1.2b2ff71e2009ap-15, -0x1.279eadf742f1ap-17,
     0x1.5ce1a0e9068cap-19, -0x1.cded089fec43p-21, 0x1.480933f385556p-22},
     /* [31] 1.9375 <= y <= 2 2^-2, degree 10, 60.5 bits */
    {0x1.d5413e45748c2p-2, 0x1.cd4bec52a8e4fp-59, -0x1.3c3576abdfc72p-2, 0x1.119b0f8454306p-3, -0x1.82c9ad4ea61p-5,
     0x1.f6a7b6ca69951p-7, -0x1.4ec63425e2021p-8, 0x1.ff2f5e46c971ep-10, -0x1.dcd3343cb5e5fp-11, 0x1.09d15da31b60fp-11,
     -0x1.4e27c0f445febp-12, 0x1.c384f83363dd2p-13}, /* [32] 1 <= y <= 1.0625 2^-1, degree 10, 59.0 bits */
    {0x1.c203be329b0e7p-2, 0x1.33855989b27c8p-60, -0x1.2ba8fd7339f99p-2, 0x1.002fc9fb91935p-3, -0x1.64eea8d227791p-5,
     0x1.c5da44cbd84d9p-7, -0x1.23529961f01c7p-8, 0x1.a3dea7b9f328fp-10, -0x1.6c71835090e65p-11, 0x1.79e042bb74079p-12,
     -0x1.bbee01a9e7e96p-13, 0x1.196c2de200a9bp-13}, /* [33] 1.0625 <= y <= 1.125 2^-1, degree 10, 61.9 bits */
    {0x1.afc68a4aa9e99p-2, 0x1.a208483fee5ap-56, -0x1.1c2864c814c38p-2, 0x1.e032957008ebep-4, -0x1.49ed829545d3bp-5,
     0x1.9b39d234285eep-7, -0x1.fecc1890c913cp-9, 0x1.5d7251074428bp-10, -0x1.1bb84da6de4b1p-11, 0x1.128518b9a907fp-12,
     -0x1.2e402898c9c77p-13, 0x1.68a12340bfb6dp-14}, /* [34] 1.125 <= y <= 1.1875 2^-1, degree 10, 58.8 bits */
    {0x1.9e798963c95a8p-2, 0x1.bc68081a441fcp-56, -0x1.0d9f662e961ffp-2, 0x1.c26f11adffc4bp-4, -0x1.316c128f7043cp-5,
     0x1.75bc81f5523e9p-7, -0x1.c2a8bb7817cc3p-9, 0x1.262e76137f297p-10, -0x1.c108889d05532p-12, 0x1.96c8d954d8aaep-13,
     -0x1.a4d0042cd864bp-14, 0x1.d9b71b103a829p-15}, /* [35] 1.1875 <= y <= 1.25 2^-1, degree 10, 61.2 bits */
    {0x1.8e0dd763d4ad7p-2, -0x1.4a9ec88fd26fap-56, -0x1.fff737bcae5b7p-3, 0x1.a6dcb2c140c22p-4, -0x1.1b1eeb8ef0671p-5,
     0x1.5491dcd3cde68p-7, -0x1.8fc7ca67258dcp-9, 0x1.f445092dee4bcp-11, -0x1.688c4e82ea4ebp-12, 0x1.32ca4256138e7p-13,
     -0x1.2ae271d9545d5p-14, 0x1.3e29e680acc54p-15}, /* [36] 1.25 <= y <= 1.3125 2^-1, degree 10, 60.1 bits */
    {0x1.7e75a90852ffcp-2, -0x1.d861e3a73f0cp-57, -0x1.e6588ffe9cf6ep-3, 0x1.8d49a40189ba1p-4, -0x1.06c643da67d82p-5,
     0x1.3713da4920f38p-7, -0x1.6454f425768bap-9, 0x1.ad14feb7c9312p-11, -0x1.254a38a979d1cp-12, 0x1.d6461be5bf79dp-14,
     -0x1.b066cab6b2ddep-15, 0x1.b4240b9794c77p-16}, /* [37] 1.3125 <= y <= 1.375 2^-1, degree 10, 60.1 bits */
    {0x1.6fa432f1bd0b5p-2, 0x1.01338356cda94p-57, -0x1.ce44495ba0424p-3, 0x1.758997b3ed84p-4, -0x1.e8574e05617d4p-6,
     0x1.1cbc62df3f12ep-7, -0x1.3eec8fa7bcfp-9, 0x1.72d754cf3042p-11, -0x1.e2be11186eb3ep-13, 0x1.6dc4959be702p-14,
     -0x1.3e0df522c1addp-15, 0x1.30853c7bce4f9p-16}, /* [38] 1.375 <= y <= 1.4375 2^-1, degree 10, 59.9 bits */
    {0x1.618d93743a40bp-2, 0x1.2391b0d483a77p-56, -0x1.b79e760eb9085p-3, 0x1.5f74fcf91f7fep-4, -0x1.c6406c258827p-6,
     0x1.051dd03dab34bp-7, -0x1.1e7c46192d2e2p-9, 0x1.42a9b7efa3db9p-11, -0x1.91738c0cb62bap-13, 0x1.205293f40903ep-14,
     -0x1.db21f115b92c7p-16, 0x1.b06af0bd853b3p-17}, /* [39] 1.4375 <= y <= 1.5 2^-1, degree 10, 60.7 bits */
    {0x1.5426bec853d78p-2, -0x1.4fb100002945cp-56, -0x1.a24d7fdbd7083p-3, 0x1.4ae85aa63e5e4p-4, -0x1.a6f69cce29fe1p-6,
     0x1.dfbaefc1fb062p-8, -0x1.022d75c0bcd72p-9, 0x1.1a697decec6fcp-11, -0x1.50fcf16224fe6p-13, 0x1.cc26f4d5f711fp-15,
     -0x1.67f38673eac0fp-16, 0x1.3803d62ea29e9p-17}, /* [40] 1.5 <= y <= 1.5625 2^-1, degree 10, 59.6 bits */
    {0x1.47656d48b291cp-2, 0x1.4a8d4b38947afp-56, -0x1.8e39eafa464dap-3, 0x1.37c3c6c480bb6p-4, -0x1.8a32f7a2a03bfp-6,
     0x1.b95f42ebcdcb4p-8, -0x1.d2ac077ec1b7dp-10, 0x1.f0f7a57397b0ep-12, -0x1.1d43bfac74291p-13, 0x1.7355aa7b9eaa3p-15,
     -0x1.1448cddf1026fp-16, 0x1.c8b94a6eb947fp-18}, /* [41] 1.5625 <= y <= 1.625 2^-1, degree 10, 61.6 bits */
    {0x1.3b400b786636dp-2, 0x1.d69cffb8b6b0ep-56, -0x1.7b4e20cbc729bp-3, 0x1.25ea749c2330dp-4, -0x1.6fb745aee14dcp-6,
     0x1.96a8fd4d24af3p-8, -0x1.a6db096e0a44cp-10, 0x1.b74f652b55bc4p-12, -0x1.e6a0cd6fd3f85p-14, 0x1.2ec1ca061fbp-15,
     -0x1.ad4e568b7cb5dp-17, 0x1.52cb58fd932dfp-18}, /* [42] 1.625 <= y <= 1.6875 2^-1, degree 10, 59.6 bits */
    {0x1.2fadab988b929p-2, -0x1.c67d0861b60eap-57, -0x1.6976411dfbfd9p-3, 0x1.154254b556862p-4, -0x1.574caaba23c64p-6,
     0x1.772bb83b4628ep-8, -0x1.800ac05e3372cp-10, 0x1.85f72705737dcp-12, -0x1.a1e792571f30dp-14, 0x1.f25da710398f6p-16,
     -0x1.5151a082d0908p-17, 0x1.fcf5639fc8e3ap-19}, /* [43] 1.6875 <= y <= 1.75 2^-1, degree 10, 60.0 bits */
    {0x1.24a5f89d2c668p-2, 0x1.cf13ab7f4e4d3p-56, -0x1.589ff8f3ef27dp-3, 0x1.05b3c3527e909p-4, -0x1.40c28f96dfa5bp-6,
     0x1.5a8ab3864a06cp-8, -0x1.5d861080aa5f1p-10, 0x1.5b75bb0409f45p-12, -0x1.6919d6bccc24ep-14, 0x1.9dbe475410e34p-16,
     -0x1.0bd5990649d89p-17, 0x1.82c9ef81b0843p-19}, /* [44] 1.75 <= y <= 1.8125 2^-1, degree 10, 60.6 bits */
    {0x1.1a212a5879dddp-2, -0x1.9a19a3ffc4b9bp-56, -0x1.48ba5e0684fc6p-3, 0x1.ee52856780ce4p-5, -0x1.2bedbedb49ec5p-6,
     0x1.40760e236dab3p-8, -0x1.3eb754a7e970dp-10, 0x1.36a1612db77d8p-12, -0x1.39c20299ceffep-14, 0x1.5a3add711ca0fp-16,
     -0x1.ad7fac30e79aep-18, 0x1.292dbd24a865bp-19}, /* [45] 1.8125 <= y <= 1.875 2^-1, degree 10, 60.7 bits */
    {0x1.1017fab96d01ep-2, -0x1.7a961917919b2p-58, -0x1.39b5ce50b7357p-3, 0x1.d31e7e1685a4bp-5, -0x1.18a7a92633bbcp-6,
     0x1.28a894ebfa329p-8, -0x1.2321dd8857963p-10, 0x1.168ca6a5d963fp-12, -0x1.11ff556fc2073p-14, 0x1.23db048836e87p-16,
     -0x1.5b852a921fb8cp-18, 0x1.cd5f222bf5f9p-20}, /* [46] 1.875 <= y <= 1.9375 2^-1, degree 10, 59.1 bits */
    {0x1.06839bffb5be3p-2, -0x1.f735d846e38eap-60, -0x1.2b83d31a4b13cp-3, 0x1.b9a7b4f5dfc3p-5, -0x1.06cdc8c01cae4p-6,
     0x1.12e603381ed17p-8, -0x1.0a5cfb3e01ebdp-10, 0x1.f4f0c257aa6e5p-13, -0x1.e0bd8b49a46dfp-15, 0x1.ef59f929c27d3p-17,
     -0x1.1b960efb13d5bp-18, 0x1.699d791fe71d3p-20}, /* [47] 1.9375 <= y <= 2 2^-1, degree 10, 59.0 bits */
    {0x1.f1e48723b41c7p-3, -0x1.fba17b2c5c772p-58, -0x1.17a6a800af44cp-2, 0x1.9671aa0ed2dap-3, -0x1.dcddd16a5d58cp-4,
     0x1.eb4a00b2ebecap-5, -0x1.d37d92b589414p-6, 0x1.ad1e11734939cp-7, -0x1.8e0ce228398d6p-8, 0x1.87af6592ef2d9p-9,
     -0x1.a895d8f543a7fp-10, 0x1.fed174006e4a1p-11}, /* [48] 1 <= y <= 1.0625 2^0, degree 10, 59.9 bits */
    {0x1.d077b424b7816p-3, -0x1.d502bb608c406p-57, -0x1.ff2ccd4d7fea2p-3, 0x1.6c7aca3b5687bp-3, -0x1.a3c57c85847e5p-4,
     0x1.a8210a61dc741p-5, -0x1.8a9279481c9f6p-6, 0x1.5fc2a9cd85cf7p-7, -0x1.395d2247dd2fap-8, 0x1.23d3d836ab457p-9,
     -0x1.27834b0cba325p-10, 0x1.4a4ecb7dca216p-11}, /* [49] 1.0625 <= y <= 1.125 2^0, degree 10, 59.6 bits */
    {0x1.b1e4aaf6b83abp-3, 0x1.f3d1d16b9a76fp-61, -0x1.d3f988cf8bc9bp-3, 0x1.477ee213cbd4p-3, -0x1.726761ffb5bb9p-4,
     0x1.6f504a05a73b6p-5, -0x1.4e93f33864dcdp-6, 0x1.227eea4de6102p-7, -0x1.f3639c84178ap-9, 0x1.baf44cf01a51p-10,
     -0x1.a5bccd2a5e25ap-11, 0x1.b80d7bbec2ec9p-12}, /* [50] 1.125 <= y <= 1.1875 2^0, degree 10, 59.8 bits */
    {0x1.95e157595c595p-3, 0x1.cda9f20fbe93fp-57, -0x1.ad1f1d1de248bp-3, 0x1.26d30c3a61bd2p-3, -0x1.479671ce55a4cp-4,
     0x1.3f09d91afc0e5p-5, -0x1.1ce03d309bfc7p-6, 0x1.e2dd0d6cb185ap-8, -0x1.92003cad2fb0ap-9, 0x1.557bec6350608p-10,
     -0x1.3389e42040e1p-11, 0x1.2d0143ee64d1dp-12}, /* [51] 1.1875 <= y <= 1.25 2^0, degree 10, 58.9 bits */
    {0x1.7c2c497794f0fp-3, -0x1.85339f85179c4p-57, -0x1.8a1cd931f5f64p-3, 0x1.09e6193120601p-3, -0x1.225953c3a5e61p-4,
     0x1.15dbfefe9c447p-5, -0x1.e6e90bc2ccd02p-7, 0x1.93880ebb3ba97p-8, -0x1.466d310574196p-9, 0x1.0acd53ff7cf4dp-10,
     -0x1.c9126a66091cep-12, 0x1.a5a492afcac22p-13}, /* [52] 1.25 <= y <= 1.3125 2^0, degree 10, 59.4 bits */
    {0x1.648b92cf6bf58p-3, -0x1.37916a4bf2781p-59, -0x1.6a82d1da73e63p-3, 0x1.e07869d28f289p-4, -0x1.01e047918d8ap-4,
     0x1.e537ea21b6253p-6, -0x1.a183311a47151p-7, 0x1.52dfff137ef38p-8, -0x1.0b0bc36082385p-9, 0x1.a5b5c0f9c57p-11,
     -0x1.5947bb98f262ap-12, 0x1.2d997aa5a3b6dp-13}, /* [53] 1.3125 <= y <= 1.375 2^0, degree 10, 58.5 bits */
    {0x1.4ecbcdf4415dap-3, -0x1.503b955cbea72p-58, -0x1.4def70861be74p-3, 0x1.b2d6c51df58c8p-4, -0x1.cafa98cd9590ap-5,
     0x1.a8ac9f19c04ap-6, -0x1.671bf7c913bfdp-7, 0x1.1dcf6c80c3247p-8, -0x1.b7c6cabae8c31p-10, 0x1.5095e6ade469cp-11,
     -0x1.08966f293340cp-12, 0x1.b7aa2c6ac5a84p-14}, /* [54] 1.375 <= y <= 1.4375 2^0, degree 10, 61.3 bits */
    {0x1.3abf4a1b3c1a2p-3, -0x1.68a0059723816p-57, -0x1.340d67b89633p-3, 0x1.8a313ebefce3dp-4, -0x1.993bf1ad78841p-5,
     0x1.7486ab21c9a82p-6, -0x1.35c1ba668b648p-7, 0x1.e3fc8395682dcp-9, -0x1.6c2e4e9567e67p-10, 0x1.0ef3cc83c09bp-11,
     -0x1.9a97f4cf38c8p-13, 0x1.45d986c31135fp-14}, /* [55] 1.4375 <= y <= 1.5 2^0, degree 10, 58.8 bits */
    {0x1.283d54b1c29e4p-3, 0x1.ad48ab7c2c1ebp-58, -0x1.1c91fa96857cbp-3, 0x1.65eb1294cc466p-4, -0x1.6d8d30e45b35cp-5,
     0x1.477c4d993371p-6, -0x1.0be5c41b575ep-7, 0x1.9b3c44723d0f7p-9, -0x1.2f1a05882e0f1p-10, 0x1.b780f18c7fcd4p-12,
     -0x1.42133714cc752p-13, 0x1.ea34bfcdf3d04p-15}, /* [56] 1.5 <= y <= 1.5625 2^0, degree 10, 60.7 bits */
    {0x1.17219c46cceeep-3, 0x1.673d31fbbc3f5p-59, -0x1.073b88ce9262dp-3, 0x1.457cdd3c21318p-4, -0x1.471c84cc3cb91p-5,
     0x1.207bd50df6b3ap-6, -0x1.d08c19df999acp-8, 0x1.5e8d254448596p-9, -0x1.faceb0654301dp-11, 0x1.66cc7906d0f9dp-12,
     -0x1.fe211b6499a5fp-14, 0x1.759ce439f28dap-15}, /* [57] 1.5625 <= y <= 1.625 2^0, degree 10, 58.3 bits */
    {0x1.074ba8e2fe745p-3, 0x1.fd01024398762p-58, -0x1.e7a0a62aab07bp-4, 0x1.287164558018dp-4, -0x1.253761ee6216fp-5,
     0x1.fd41ffc128bb5p-7, -0x1.93b944b11c8b9p-8, 0x1.2bb7370894eacp-9, -0x1.a96e3d314ce71p-11, 0x1.269e698a3a6f3p-12,
     -0x1.9766f79a91cfap-14, 0x1.201820c6522cdp-15}, /* [58] 1.625 <= y <= 1.6875 2^0, degree 10, 59.9 bits */
    {0x1.f13ccd2a48a5p-4, -0x1.ae04f88552b24p-60, -0x1.c43add6056975p-4, 0x1.0e62e7aac3a72p-4, -0x1.074560129b623p-5,
     0x1.c2593e51544b6p-7, -0x1.5fa638ede532cp-8, 0x1.00f704655c302p-9, -0x1.6670795633096p-11, 0x1.e65943de26ccdp-13,
     -0x1.47c9821834ae5p-14, 0x1.c0ee822c8a9b1p-16}, /* [59] 1.6875 <= y <= 1.75 2^0, degree 10, 59.0 bits */
    {0x1.d5ff7f044ad3dp-4, -0x1.39d0beeb4c6b7p-62, -0x1.a3ebc0a5579e9p-4, 0x1.edf1c3f4a1e98p-5, -0x1.d9880c77991acp-6,
     0x1.8efbe2d657fdcp-7, -0x1.32f2083401e9bp-8, 0x1.b9c59c598ef8cp-10, -0x1.2f04d39065868p-11, 0x1.934bba43ca79ap-13,
     -0x1.0979c2c327414p-14, 0x1.61057cf93b469p-16}, /* [60] 1.75 <= y <= 1.8125 2^0, degree 10, 59.0 bits */
    {0x1.bcb0866f0a1a8p-4, -0x1.33076c2aee00bp-58, -0x1.8663aff57a5e2p-4, 0x1.c3cc4abdca36bp-5, -0x1.aa86aa7be1f1ap-6,
     0x1.621a9fbd295cbp-7, -0x1.0c78c78e6fabep-8, 0x1.7cad52f7e6c26p-10, -0x1.00f7956589c97p-11, 0x1.4fd5b531740a1p-13,
     -0x1.b08ed3a44b10ap-15, 0x1.17e493a6548bp-16}, /* [61] 1.8125 <= y <= 1.875 2^0, degree 10, 58.9 bits */
    {0x1.a525b2b715d54p-4, -0x1.f3913d275e625p-58, -0x1.6b5c112cf28b8p-4, 0x1.9dce86922ad62p-5, -0x1.80c5d7118debdp-6,
     0x1.3acfc6246152p-7, -0x1.d68fded642835p-9, 0x1.48cb117b6a619p-10, -0x1.b517b12f35999p-12, 0x1.18bb3eb80454fp-13,
     -0x1.6244026db461p-15, 0x1.bf193a27b46acp-17}, /* [62] 1.875 <= y <= 1.9375 2^0, degree 10, 59.3 bits */
    {0x1.8f38fc43ecb54p-4, 0x1.adb041a3b85dcp-58, -0x1.52962e4be519bp-4, 0x1.7b826634cbc6ep-5, -0x1.5b9f49da8a245p-6,
     0x1.18584cde45c8fp-7, -0x1.9d2a5f906afe4p-9, 0x1.1c9bac1977d07p-10, -0x1.74bf707711899p-12, 0x1.d6fd757334013p-14,
     -0x1.238824632dfa9p-15, 0x1.6774b6f95a986p-17}, /* [63] 1.9375 <= y <= 2 2^0, degree 10, 59.1 bits */
    {0x1.71143131ae393p-4, -0x1.247efb1bcf055p-61, -0x1.31303acbe96f1p-3, 0x1.4e1e38f770b37p-3, -0x1.2b5190afce81fp-3,
     0x1.d899bc02b4c4fp-4, -0x1.5514fef0fc191p-4, 0x1.cc38b3bd8c6ap-5, -0x1.26f0108a67d6ap-5, 0x1.6c0b92546217p-6,
     -0x1.b70c8dc59de88p-7, 0x1.06270686ed08cp-7}, /* [64] 1 <= y <= 1.0625 2^1, degree 10, 61.0 bits */
    {0x1.4d66c03db294ep-4, -0x1.001799f41bdccp-58, -0x1.0ab680a50746fp-3, 0x1.1b248647eaa5fp-3, -0x1.ecc2dcd7dc242p-4,
     0x1.7a538b5a4ac22p-4, -0x1.09bdc6a758f85p-4, 0x1.5d0a23d1efe49p-5, -0x1.b3390e46b975cp-6, 0x1.04d94251f7da8p-6,
     -0x1.3075c372ebc9p-7, 0x1.5df686229bb45p-8}, /* [65] 1.0625 <= y <= 1.125 2^1, degree 10, 57.3 bits */
    {0x1.2e28d7677a0bfp-4, -0x1.a1efcb96191a8p-61, -0x1.d41085891149p-4, 0x1.e226139cb28d6p-4, -0x1.97c34540d9cefp-4,
     0x1.30a4c0773e239p-4, -0x1.a0cc040274f3fp-5, 0x1.0aab780763a33p-5, -0x1.43dc2bd3f751fp-6, 0x1.79aa583d4da65p-7,
     -0x1.abc57e1958943p-8, 0x1.db36b7b6599a5p-9}, /* [66] 1.125 <= y <= 1.1875 2^1, degree 10, 58.1 bits */
    {0x1.12b19d0d05d6fp-4, -0x1.2311902288d49p-60, -0x1.9c4ac5d31169bp-4, 0x1.9c5a7e1411969p-4, -0x1.5321daf20ddcbp-4,
     0x1.ed5fd658596dbp-5, -0x1.48e25ebc0aae6p-5, 0x1.9a4a20e655127p-6, -0x1.e5c4e0610bacep-7, 0x1.13eca491d3a7cp-7,
     -0x1.2fecd97b63b61p-8, 0x1.4756336b52eaep-9}, /* [67] 1.1875 <= y <= 1.25 2^1, degree 10, 58.3 bits */
    {0x1.f4ea0bb7f47b1p-5, 0x1.a8788fc413e3bp-60, -0x1.6c7e40fe06416p-4, 0x1.622b344c8b8afp-4, -0x1.1b69ef4d7bccp-4,
     0x1.91a65eabbcf3cp-5, -0x1.050ad3474c36cp-5, 0x1.3dae9d6faa406p-6, -0x1.6ef8054bc881bp-7, 0x1.9692bb5893364p-8,
     -0x1.b43688448cc1dp-9, 0x1.c898471821e85p-10}, /* [68] 1.25 <= y <= 1.3125 2^1, degree 10, 58.3 bits */
    {0x1.c9fcaeb1e12cap-5, -0x1.62cbbf0600093p-59, -0x1.435b537e13fa8p-4, 0x1.316f24ec2cf5ap-4, -0x1.dbe207b2be32fp-5,
     0x1.48a604b45456dp-5, -0x1.a0b6c15001ep-6, 0x1.eefc421a7d2d3p-7, -0x1.171e14bf231e9p-7, 0x1.2ddc94505376dp-8,
     -0x1.3be0454aa6045p-9, 0x1.41f31b56c439dp-10}, /* [69] 1.3125 <= y <= 1.375 2^1, degree 10, 59.2 bits */
    {0x1.a3d7a08351a6fp-5, 0x1.3ace3dbb07492p-59, -0x1.1fd01fc743a85p-4, 0x1.086e3dfc496acp-4, -0x1.914a75df61608p-5,
     0x1.0e3ac1c9bc2bfp-5, -0x1.4e645057a91bp-6, 0x1.83e1ae68fd1a2p-7, -0x1.ab551e2514fa5p-8, 0x1.c3777e5489b56p-9,
     -0x1.cd41444d0227cp-10, 0x1.ca7877f0ab07dp-11}, /* [70] 1.375 <= y <= 1.4375 2^1, degree 10, 57.9 bits */
    {0x1.81d66884602efp-5, -0x1.c2871001b2f72p-60, -0x1.00fc10e346a02p-4, 0x1.cb90d2798424ap-5, -0x1.53d173d102e6p-5,
     0x1.be782b2cd1d0ep-6, -0x1.0db552fcd7d9ep-6, 0x1.31a6d078069c4p-7, -0x1.49200ed631fbep-8, 0x1.53e4197f48b37p-9,
     -0x1.5357b0b68df7dp-10, 0x1.49560a94ff6fbp-11}, /* [71] 1.4375 <= y <= 1.5 2^1, degree 10, 57.8 bits */
    {0x1.636e113b8adb1p-5, -0x1.78964798cbd0dp-59, -0x1.cc4c3380cf4b5p-5, 0x1.90c4f3080bbc4p-5, -0x1.20eccdd0d0bcap-5,
     0x1.727ae5fe2b69fp-6, -0x1.b5362b56c1bc9p-7, 0x1.e4489b28dcd74p-8, -0x1.fdecb15761116p-9, 0x1.0185ef97e9b1ap-9,
     -0x1.f6db652214f37p-11, 0x1.dcfda5724526p-12}, /* [72] 1.5 <= y <= 1.5625 2^1, degree 10, 60.8 bits */
    {0x1.4828b6ccddfbdp-5, -0x1.d9b4371585f08p-59, -0x1.9d6a18d41f325p-5, 0x1.5eaf1091729c2p-5, -0x1.ed35e57cdb5cep-6,
     0x1.34bf6841f4235p-6, -0x1.640aeadf975afp-7, 0x1.819f4bf76f842p-8, -0x1.8d3764791532p-9, 0x1.8898560e67e1ep-10,
     -0x1.7711fc0f7f2d3p-11, 0x1.5c04bbf619aa3p-12}, /* [73] 1.5625 <= y <= 1.625 2^1, degree 10, 59.0 bits */
    {0x1.2fa1ef9f3ca5ap-5, 0x1.d4e879492ebp-59, -0x1.74531b4f2adeep-5, 0x1.33db5351c18c4p-5, -0x1.a68837dce10ebp-6,
     0x1.025d896381349p-6, -0x1.234192496a4f3p-7, 0x1.34921c5bc3506p-8, -0x1.3710e871dea16p-9, 0x1.2cfb913f059d8p-10,
     -0x1.1985d8dd0c65p-11, 0x1.ff665b0322171p-13}, /* [74] 1.625 <= y <= 1.6875 2^1, degree 10, 58.8 bits */
    {0x1.1983e1c2ff90fp-5, -0x1.03c40569520f3p-61, -0x1.50328fa638ea4p-5, 0x1.0f1a4e7dbc03fp-5, -0x1.6b45c18f55294p-6,
     0x1.b22085067afefp-7, -0x1.de978fdb62bbfp-8, 0x1.f029f41b70f31p-9, -0x1.e9b003a9a6326p-10, 0x1.d00a7768d0ddbp-11,
     -0x1.a925e15978948p-12, 0x1.7a3823d6bc3dp-13}, /* [75] 1.6875 <= y <= 1.75 2^1, degree 10, 60.9 bits */
    {0x1.0584e1d214394p-5, 0x1.fb1d5d5a44475p-59, -0x1.30562c55e19a5p-5, 0x1.dee69e3c03aep-6, -0x1.3964a3d0529dep-6,
     0x1.6e1f17fd96e8ap-7, -0x1.8adbeae11ee9p-8, 0x1.90b725888fdc7p-9, -0x1.83545b232f39p-10, 0x1.679bbb6585276p-11,
     -0x1.42db9efc40059p-12, 0x1.19777ea8ff3b7p-13}, /* [76] 1.75 <= y <= 1.8125 2^1, degree 10, 58.4 bits */
    {0x1.e6caff82260fcp-6, -0x1.cec2bad50a71dp-60, -0x1.1427e52d83305p-5, 0x1.a8333b31642e1p-6, -0x1.0f4073892053ap-6,
     0x1.35e75a5a41999p-7, -0x1.471723f52e0f3p-8, 0x1.450bcb292f538p-9, -0x1.33d035c2f952dp-10, 0x1.1817ada134a2bp-11,
     -0x1.ed09a98fe58fep-13, 0x1.a569868351b82p-14}, /* [77] 1.8125 <= y <= 1.875 2^1, degree 10, 59.6 bits */
    {0x1.c5ddd80f35471p-6, -0x1.715a77f48443ep-64, -0x1.f651f186f5c07p-6, 0x1.78c8091bd9c06p-6, -0x1.d709f858c1abep-7,
     0x1.073f0d6235a06p-7, -0x1.10019a35a759p-8, 0x1.08c7654d98edap-9, -0x1.eb77bd5575773p-11, 0x1.b672b3bb16c0ap-12,
     -0x1.7a6eff912799ep-13, 0x1.3d40d321bf968p-14}, /* [78] 1.875 <= y <= 1.9375 2^1, degree 10, 58.7 bits */
    {0x1.a7e3482fc9238p-6, 0x1.397902d19deacp-63, -0x1.c9dbdf772a8c5p-6, 0x1.4f8c33c26c6e6p-6, -0x1.9a3b83b388b05p-7,
     0x1.c0c03453dbdb7p-8, -0x1.c617dec48e389p-9, 0x1.b120e0dccf4ecp-10, -0x1.8a11f11380cd9p-11, 0x1.58c7c902c3cb8p-12,
     -0x1.23ee9f5ad6b4ep-13, 0x1.e0435ebd63f81p-15}, /* [79] 1.9375 <= y <= 2 2^1, degree 10, 58.8 bits */
    {0x1.7fc080949e49bp-6, 0x1.1f498902c76cp-60, -0x1.9000c96f21307p-5, 0x1.1b5635f33a4eap-4, -0x1.4f3d55a057951p-4,
     0x1.63494a8f0bc7bp-4, -0x1.5ca2a7648dd2bp-4, 0x1.42bc75a48775ap-4, -0x1.1d2cd70beb1c7p-4, 0x1.e4ec740b71b85p-5,
     -0x1.8fa2b3f773a59p-5, 0x1.3fad21ff78c9dp-5}, /* [80] 1 <= y <= 1.0625 2^2, degree 10, 58.2 bits */
    {0x1.51df2bace04fep-6, 0x1.74a953c6369fbp-64, -0x1.5061c24f471b8p-5, 0x1.c80c2734b70cfp-5, -0x1.0299db8eb8de2p-4,
     0x1.070c51a56dda6p-4, -0x1.f01279f468b11p-5, 0x1.b9b8d337c6014p-5, -0x1.77c624a1a27b7p-5, 0x1.33d33c77c33e8p-5,
     -0x1.e91a19d140e51p-6, 0x1.7960c3f6538b5p-6}, /* [81] 1.0625 <= y <= 1.125 2^2, degree 10, 58.9 bits */
    {0x1.2b2646b037eb1p-6, 0x1.9e01564d8632ap-61, -0x1.1cf566d0f023bp-5, 0x1.7249116be9a2ep-5, -0x1.931595ae66879p-5,
     0x1.8a0be881348f2p-5, -0x1.65789100866cfp-5, 0x1.328711cf2f9b8p-5, -0x1.f6a650c505897p-6, 0x1.8d253e02bc23bp-6,
     -0x1.3079f09c23e0ap-6, 0x1.c5b23537d9481p-7}, /* [82] 1.125 <= y <= 1.1875 2^2, degree 10, 58.8 bits */
    {0x1.0a3cb2f619898p-6, 0x1.2471660e6c94dp-60, -0x1.e61322a73c492p-6, 0x1.2f22a1f547064p-5, -0x1.3d29fc84391adp-5,
     0x1.2a5854bed6c92p-5, -0x1.04b122e0da803p-5, 0x1.af01d25860061p-6, -0x1.54f2e2d41f3efp-6, 0x1.0415c32273297p-6,
     -0x1.813abaf2ec285p-7, 0x1.156b4f32bb037p-7}, /* [83] 1.1875 <= y <= 1.25 2^2, degree 10, 60.1 bits */
    {0x1.dc28ad0a604aap-7, -0x1.763222c098ba1p-65, -0x1.a12de00c5ccbfp-6, 0x1.f423683b6fb9ep-6, -0x1.f7962d521a40ap-6,
     0x1.c85ad8dcaed8dp-6, -0x1.80820562f6b2fp-6, 0x1.32bf7a6d7ba81p-6, -0x1.d4b0724e16528p-7, 0x1.5983b22467b4cp-7,
     -0x1.eed1af4dbc7fcp-8, 0x1.58bed7aedd233p-8}, /* [84] 1.25 <= y <= 1.3125 2^2, degree 10, 58.1 bits */
    {0x1.abafa80290fep-7, 0x1.aeefab3fd69c8p-65, -0x1.6825346f287b4p-6, 0x1.9f89e70fc3699p-6, -0x1.9322ef8b623ddp-6,
     0x1.6056806ff9b5dp-6, -0x1.1e8eb5ce5786ep-6, 0x1.b9abca38c08fdp-7, -0x1.462cea111253ap-7, 0x1.d12b5fb5d48ddp-8,
     -0x1.4258886089daep-8, 0x1.b2ecc36717af5p-9}, /* [85] 1.3125 <= y <= 1.375 2^2, degree 10, 57.8 bits */
    {0x1.81ba4f662c186p-7, 0x1.18186c137161p-61, -0x1.389a94f3393eep-6, 0x1.5b8e6e7db3cd8p-6, -0x1.453fa520385ccp-6,
     0x1.12732b40014ebp-6, -0x1.af59abac6e36bp-7, 0x1.416ce30b483b9p-7, -0x1.cb56f19101cf4p-8, 0x1.3d182eaa0d9b7p-8,
     -0x1.a9a74e599fbap-9, 0x1.1647e06a5e7f6p-9}, /* [86] 1.375 <= y <= 1.4375 2^2, degree 10, 58.0 bits */
    {0x1.5d377cd4826b9p-7, -0x1.d610c0b69d289p-61, -0x1.10b7e661d4d04p-6, 0x1.248342b783a89p-6, -0x1.085564da70c58p-6,
     0x1.af2195cd29e5ep-7, -0x1.47ad5474095f3p-7, 0x1.d89ee59934b49p-8, -0x1.4706e9526f896p-8, 0x1.b579979c8dbc5p-9,
     -0x1.1c9f01273ffc2p-9, 0x1.68eecbee3b223p-10}, /* [87] 1.4375 <= y <= 1.5 2^2, degree 10, 59.3 bits */
    {0x1.3d4a176a5c645p-7, 0x1.30b102e97c3p-61, -0x1.de1b46169d216p-7, 0x1.ef418a34414a3p-7, -0x1.b09cb8800e01dp-7,
     0x1.554a3e64c727p-7, -0x1.f635dc830918p-8, 0x1.5ed230880fbbep-8, -0x1.d68954f01e2f8p-9, 0x1.312f460c9eb7bp-9,
     -0x1.813a4b575fffep-10, 0x1.da2267bc36219p-11}, /* [88] 1.5 <= y <= 1.5625 2^2, degree 10, 59.8 bits */
    {0x1.213de10886accp-7, -0x1.39ba97132c7fap-62, -0x1.a4f4413c23d23p-7, 0x1.a590a8f210d5fp-7, -0x1.644d0bf5cfa2fp-7,
     0x1.102b2207cd719p-7, -0x1.84098d8221fb9p-8, 0x1.06c867066754cp-8, -0x1.55ddb42dc6288p-9, 0x1.ae5820a07e7bap-10,
     -0x1.07ad59f7031e5p-10, 0x1.3b33e305024adp-11}, /* [89] 1.5625 <= y <= 1.625 2^2, degree 10, 62.8 bits */
    {0x1.087eed560d4afp-7, -0x1.cd98d57b69208p-61, -0x1.742ea3880ab9p-7, 0x1.68b13ed19f724p-7, -0x1.273d334643a7p-7,
     0x1.b51e9e3fb7429p-8, -0x1.2e2997be31ce2p-8, 0x1.8d10cc65d8d2ap-9, -0x1.f56be2d13297cp-10, 0x1.327c7a89b1b1ep-10,
     -0x1.6cde7666bf503p-11, 0x1.a7eb8f29d77cap-12}, /* [90] 1.625 <= y <= 1.6875 2^2, degree 10, 59.7 bits */
    {0x1.e526240d550f1p-8, -0x1.d69c63a24fc92p-62, -0x1.4a5a5f46a592ap-7, 0x1.361c36caba54ap-7, -0x1.ec1859e460466p-8,
     0x1.615506ff103b4p-8, -0x1.da0f438f2d3adp-9, 0x1.2e6dc12e52d5fp-9, -0x1.72fd628e2d707p-10, 0x1.b8bd863e7bca2p-11,
     -0x1.fe16250bd81ffp-12, 0x1.203003fcac1ecp-12}, /* [91] 1.6875 <= y <= 1.75 2^2, degree 10, 60.1 bits */
    {0x1.be29a222a4845p-8, -0x1.09046b2a19252p-63, -0x1.264f07c3710a9p-7, 0x1.0bd80f2ebb322p-7, -0x1.9c5457271b541p-8,
     0x1.1f621ca190b54p-8, -0x1.767920c8ca4e2p-9, 0x1.d040e1bc95e8cp-10, -0x1.14cccc9aa8379p-10, 0x1.3fc9c0f82a47p-11,
     -0x1.68087a6b3a69ap-12, 0x1.8be7de2742fe5p-13}, /* [92] 1.75 <= y <= 1.8125 2^2, degree 10, 59.0 bits */
    {0x1.9b5ec02158a59p-8, -0x1.24e9f720474f8p-63, -0x1.071c5759b4df2p-7, 0x1.d0ae0b2686d6bp-8, -0x1.5b440a7c21257p-8,
     0x1.d63e1304b7c07p-9, -0x1.29c4402dfcf92p-9, 0x1.66f1db7031ffap-10, -0x1.a05a726c46cedp-11, 0x1.d413025a9fb8bp-12,
     -0x1.007b6c974b8b2p-12, 0x1.12a2db28f9344p-13}, /* [93] 1.8125 <= y <= 1.875 2^2, degree 10, 58.4 bits */
    {0x1.7c371128205a7p-8, 0x1.e401dba014999p-62, -0x1.d7fcb9cdda2p-8, 0x1.94bbf6e0e914bp-8, -0x1.25e3adf38d8c6p-8,
     0x1.82e0342551099p-9, -0x1.dc857f6be668ap-10, 0x1.17746bb455984p-10, -0x1.3b83ad507bbb7p-11, 0x1.5961904abcda2p-12,
     -0x1.70a8e825f5d6ep-13, 0x1.809e90644b2ap-14}, /* [94] 1.875 <= y <= 1.9375 2^2, degree 10, 58.5 bits */
    {0x1.603a5d88c374fp-8, -0x1.77debbcb2bb8p-64, -0x1.a8a8c472b455ap-8, 0x1.61e3587845dap-8, -0x1.f3b97a7514c36p-9,
     0x1.3ff9d78201e6dp-9, -0x1.7f91cdae56101p-10, 0x1.b603d1749dd21p-11, -0x1.e1a85192bf029p-12, 0x1.00d8cb5a66746p-12,
     -0x1.0b2ee13608b0ep-13, 0x1.0fbf048288a6cp-14} /* [95] 1.9375 <= y <= 2 2^2, degree 10, 60.5 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_middle_eps_zero_force)

/* eps at zero force, 2^1 <= ln(beta) < 7: 28 rows of degree 10 in y = ln(beta) 2^-k, 16 to each octave k = 1 ... 2.
 * Relative error of the approximation: 2^-62.2 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_TAIL_EPS_ZERO_FORCE_FIRST 2.0
#define COR_ROWS_HERTZ_DASHPOT_TAIL_EPS_ZERO_FORCE_FIRST_OCTAVE 1
#define COR_ROWS_HERTZ_DASHPOT_TAIL_EPS_ZERO_FORCE_OCTAVE_BITS 4
#define COR_ROWS_HERTZ_DASHPOT_TAIL_EPS_ZERO_FORCE_ROWS 28
#define COR_ROWS_HERTZ_DASHPOT_TAIL_EPS_ZERO_FORCE_END 7.0
COR_ROWS(double, cor_rows_hertz_dashpot_tail_eps_zero_force, 28, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.ded29c8f45e7cp-1, 0x1.dcdee255a482cp-56, 0x1.e53159163938p-3, -0x1.859ed1c3c77edp-2, 0x1.38aea9f2d3835p-2,
     -0x1.0f6a2e4349321p-5, -0x1.9e78d239236aap-3, 0x1.bb60e426484fp-3, -0x1.a5768ee85392p-5, -0x1.b4f78bef36f95p-4,
     0x1.064a52136fe5p-3, -0x1.2dddf0528220fp-5}, /* [0] 1 <= y <= 1.0625 2^1, degree 10, 62.2 bits */
    {0x1.e5ae40fc867b7p-1, -0x1.dbebfa24635a8p-56, 0x1.8b0550a08817dp-3, -0x1.4c3e79ec2c5d7p-2, 0x1.2927908aef0b2p-2,
     -0x1.59001a5f46c3ep-4, -0x1.0359fc61fadfcp-3, 0x1.7a7be65595e2ep-3, -0x1.68bca9aa7b853p-4, -0x1.5e805c43039a6p-5,
     0x1.8c3b89b7de7a2p-4, -0x1.de552e28dcb98p-5}, /* [1] 1.0625 <= y <= 1.125 2^1, degree 10, 63.0 bits */
    {0x1.eb3d516ce6325p-1, 0x1.06982dbefaceap-56, 0x1.3ebcf79e42b68p-3, -0x1.16d2fecba8681p-2, 0x1.0f668b592e214p-2,
     -0x1.d1f770f218cabp-4, -0x1.0a1fbe5e9e67bp-4, 0x1.25aa01aa66a2ep-3, -0x1.8fbc80871b3adp-4, 0x1.45bcf90394fefp-10,
     0x1.ec434929f7fc6p-5, -0x1.cb2ea5a95a912p-5}, /* [2] 1.125 <= y <= 1.1875 2^1, degree 10, 64.0 bits */
    {0x1.efb51af374118p-1, 0x1.6093e7b0efa22p-58, 0x1.fe505f3fe97aap-4, -0x1.cd9869a98e689p-3, 0x1.e0af78f720a34p-3,
     -0x1.030ccf21bf936p-3, -0x1.38b5ea2b60e5p-6, 0x1.a156af292a456p-4, -0x1.70fb279dd4391p-4, 0x1.a7d4d13f9a696p-6,
     0x1.daf9481d36e43p-6, -0x1.5c42cca23c27dp-5}, /* [3] 1.1875 <= y <= 1.25 2^1, degree 10, 62.7 bits */
    {0x1.f345972735963p-1, -0x1.001fa672aeb5bp-55, 0x1.95abe702bb6e4p-4, -0x1.7996efe4e57a3p-3, 0x1.9f51c93d30caap-3,
     -0x1.048d673dca4d1p-3, 0x1.8d8c85d378c86p-7, 0x1.0d69a7f15647dp-4, -0x1.2ff638c519eddp-4, 0x1.23a2e5b7e2526p-5,
     0x1.e23f7194626cdp-8, -0x1.b84a7d1411c0fp-6}, /* [4] 1.25 <= y <= 1.3125 2^1, degree 10, 64.8 bits */
    {0x1.f618c5dfcfccp-1, 0x1.a5cc882aebd14p-55, 0x1.40812486beb08p-4, -0x1.31bc3de6bf4dp-3, 0x1.5fbb848cd66ffp-3,
     -0x1.ec3a9353680e4p-4, 0x1.ff43ac9ec2606p-6, 0x1.315a9da65712ep-5, -0x1.cb494a231cffdp-5, 0x1.25546ffcba5f4p-5,
     -0x1.52fdad0d1bfbep-8, -0x1.c5eb928ff6279p-7}, /* [5] 1.3125 <= y <= 1.375 2^1, degree 10, 62.5 bits */
    {0x1.f8529b9121bd7p-1, -0x1.65139ccbd9645p-61, 0x1.f7b03bb420c2p-5, -0x1.eac3d2689f8f6p-4, 0x1.2503fcb3d8232p-3,
     -0x1.bd26314fd65fep-4, 0x1.505e5b40b90a1p-5, 0x1.0ea131096e35dp-6, -0x1.41556a59d3db5p-5, 0x1.fc5f72e86b355p-6,
     -0x1.6297e487ac86p-7, -0x1.411e0e1188bc6p-8}, /* [6] 1.375 <= y <= 1.4375 2^1, degree 10, 63.1 bits */
    {0x1.fa1151155707p-1, -0x1.4c90fa1bffacep-58, 0x1.89e3a0224d806p-5, -0x1.86e4e9d46e879p-4, 0x1.e1908da828c16p-4,
     -0x1.85deb69492fe4p-4, 0x1.6c0c938f9cc18p-5, 0x1.49db43af2920ap-9, -0x1.9f113a733b3acp-6, 0x1.90289174123e7p-6,
     -0x1.8bf51a31304cbp-7, 0x1.4f1dcb3db9257p-12}, /* [7] 1.4375 <= y <= 1.5 2^1, degree 10, 66.2 bits */
    {0x1.fb6debea16493p-1, -0x1.931a6694f7af6p-55, 0x1.32b7f851b3817p-5, -0x1.354b26aefe2f1p-4, 0x1.87351f97b5074p-4,
     -0x1.4d2b46d765491p-4, 0x1.654d75450eb78p-5, -0x1.926c174837db1p-8, -0x1.e4a4432424c59p-7, 0x1.248bbbf3ab8f3p-6,
     -0x1.684cf849be8abp-7, 0x1.6f03713267ae1p-9}, /* [8] 1.5 <= y <= 1.5625 2^1, degree 10, 66.6 bits */
    {0x1.fc7ce0a420b13p-1, -0x1.8466d576ad42dp-55, 0x1.dbe178b86e907p-6, -0x1.e6a49ac55439p-5, 0x1.3abe09f8645a2p-4,
     -0x1.17425001755f3p-4, 0x1.4a55248a2c04p-5, -0x1.6451ddf5fc2p-7, -0x1.dfa10805f56f3p-8, 0x1.9094a4ce3fc2bp-7,
     -0x1.24ffbaea10c98p-7, 0x1.d3099a4edec7ep-9}, /* [9] 1.5625 <= y <= 1.625 2^1, degree 10, 64.4 bits */
    {0x1.fd4ebaef2867ap-1, 0x1.57babf5a05b66p-59, 0x1.6fee99ca99f31p-6, -0x1.7ceb7a207055bp-5, 0x1.f64bfabc2369bp-5,
     -0x1.ccec244b459a6p-5, 0x1.253eb2c27c225p-5, -0x1.a70f02d94706ap-7, -0x1.3531717d952d5p-9, 0x1.004ba35f9cbp-7,
     -0x1.b94088acf99cep-8, 0x1.be123c2ce23aap-9}, /* [10] 1.625 <= y <= 1.6875 2^1, degree 10, 64.8 bits */
    {0x1.fdf0be2037146p-1, 0x1.59ebb1eb4fbdcp-55, 0x1.1b9e315eb588cp-6, -0x1.28d9c211baf51p-5, 0x1.8dff5a8f79795p-5,
     -0x1.77956125ffb53p-5, 0x1.f98c89556a3d6p-6, -0x1.b1053e554b644p-7, 0x1.6fb543eedbe23p-11, 0x1.2dbafcea54d17p-8,
     -0x1.3894f5aeb862cp-8, 0x1.74ce043ab1b41p-9}, /* [11] 1.6875 <= y <= 1.75 2^1, degree 10, 67.6 bits */
    {0x1.fe6d7718d3f4fp-1, -0x1.4f4f44d3aaf0bp-57, 0x1.b4130294902bfp-7, -0x1.ccdf63dfa71f9p-6, 0x1.3973b04332d55p-5,
     -0x1.2ed97ed5c7d2ep-5, 0x1.aa31306f20293p-6, -0x1.99623feea0afcp-7, 0x1.3c14d3498a322p-9, 0x1.387b6ae44e824p-9,
     -0x1.a305f727b3366p-9, 0x1.1ed6f728074c4p-9}, /* [12] 1.75 <= y <= 1.8125 2^1, degree 10, 65.1 bits */
    {0x1.fecd3c333a618p-1, 0x1.11e154023398fp-56, 0x1.4e6dcb14b4803p-7, -0x1.64879ba9a6901p-6, 0x1.eb268eff35816p-6,
     -0x1.e4226381b5cccp-6, 0x1.611d875ee1744p-6, -0x1.7032c43c958c3p-7, 0x1.a53c8589edfddp-9, 0x1.ea372b3464c17p-11,
     -0x1.09157071b7c8bp-9, 0x1.9f969e3aaf3aep-10}, /* [13] 1.8125 <= y <= 1.875 2^1, degree 10, 65.6 bits */
    {0x1.ff169a863f5c3p-1, -0x1.58a6475f65bd2p-55, 0x1.ffd3fcaa18d2p-8, -0x1.12f6ffb436ab3p-6, 0x1.7f0a5c1232ad2p-6,
     -0x1.801c377e4dc32p-6, 0x1.208c963c8b03bp-6, -0x1.3ffa2024ef346p-7, 0x1.c2d99ba1a04cp-9, 0x1.8593e58d10e91p-15,
     -0x1.3869d85c6a6d5p-10, 0x1.1e6f73398ab72p-10}, /* [14] 1.875 <= y <= 1.9375 2^1, degree 10, 67.0 bits */
    {0x1.ff4eb15d85d7dp-1, -0x1.39539c328d535p-56, 0x1.86e27e126a39ep-8, -0x1.a6f4eb9f57ef5p-7, 0x1.298880f83778cp-6,
     -0x1.2ed52b6c8af41p-6, 0x1.d24e87ea04f03p-7, -0x1.0f315649acbf8p-7, 0x1.b3c1c7ed73a1dp-9, -0x1.dcc2f7904f08ep-12,
     -0x1.4b1e263b83a0ap-11, 0x1.78de5b2d38321p-11}, /* [15] 1.9375 <= y <= 2 2^1, degree 10, 67.5 bits */
    {0x1.ff8ae6ad487f1p-1, -0x1.d1586bf587b35p-55, 0x1.04006cdbac5a7p-7, -0x1.1bfd4a34f684fp-5, 0x1.94be8881d36dcp-4,
     -0x1.a3caabf2ddb1dp-3, 0x1.4d048dde3e366p-2, -0x1.98ecd0b87aa6dp-2, 0x1.74d39a4a15bd9p-2, -0x1.8d6e26c1c9165p-3,
     -0x1.385f5c06e95d4p-4, 0x1.6e3a65150debep-2}, /* [16] 1 <= y <= 1.0625 2^2, degree 10, 65.0 bits */
    {0x1.ffbcf12531a7ap-1, 0x1.4a08595e6cc06p-55, 0x1.2c45565a9f546p-8, -0x1.4b81ac60fb3a3p-6, 0x1.df4c1e19b70aap-5,
     -0x1.fb47ae89b138ap-4, 0x1.9eed700b90e8ep-3, -0x1.0c2b9fcbf4921p-2, 0x1.0ef1332c65695p-2, -0x1.88d6bd86301aap-3,
     0x1.ca813a339aa94p-5, 0x1.9f9427aa68c6ep-4}, /* [17] 1.0625 <= y <= 1.125 2^2, degree 10, 65.9 bits */
    {0x1.ffd9c3a3797b7p-1, 0x1.2eafdc258fdc3p-56, 0x1.58e4ed73f28dcp-9, -0x1.803f680d83209p-7, 0x1.191733e806a47p-5,
     -0x1.2e596b6990d88p-4, 0x1.fa48371677e79p-4, -0x1.53603c9e05a95p-3, 0x1.6dd1517e384a2p-3, -0x1.32870a592d8dp-3,
     0x1.53ad18880a2b6p-4, 0x1.e05ac60d7054ep-10}, /* [18] 1.125 <= y <= 1.1875 2^2, degree 10, 66.6 bits */
    {0x1.ffea47e5dca91p-1, 0x1.5d1a8061b1c18p-58, 0x1.8a4b7e8acd142p-10, -0x1.babb09a0edd8cp-8, 0x1.471ed579f6754p-6,
     -0x1.6489cfa9be55cp-5, 0x1.3008b5e48eefbp-4, -0x1.a2d43ff255949p-4, 0x1.d7e28bd6550abp-4, -0x1.ae1f261d753e9p-4,
     0x1.29902a7f7cf44p-4, -0x1.c5fb75e84acc8p-6}, /* [19] 1.1875 <= y <= 1.25 2^2, degree 10, 69.8 bits */
    {0x1.fff3b441bea9bp-1, 0x1.917e58a4cb29cp-56, 0x1.c0ee81aa8eba9p-11, -0x1.fb8445cb7852p-9, 0x1.7a324fc203637p-7,
     -0x1.a0c4d2b953668p-6, 0x1.68b0eb04be7cp-5, -0x1.fb68342c72517p-5, 0x1.27248176f59a7p-4, -0x1.1c279ef780194p-4,
     0x1.b8ea8feced58p-5, -0x1.ed273d2eda0f7p-6}, /* [20] 1.25 <= y <= 1.3125 2^2, degree 10, 70.0 bits */
    {0x1.fff90f4913b89p-1, 0x1.da70b105ca24fp-55, 0x1.fd4d7067ffb37p-12, -0x1.219b753a545c3p-9, 0x1.b2d0c7be0b6a3p-8,
     -0x1.e3a65ebfe6e01p-7, 0x1.a7b5d0ee7f4c2p-6, -0x1.2f0ad8c19789ep-5, 0x1.692dc1bb98addp-5, -0x1.694e96f7f13f1p-5,
     0x1.2c9822f10e357p-5, -0x1.8bdcec7619a79p-6}, /* [21] 1.3125 <= y <= 1.375 2^2, degree 10, 69.8 bits */
    {0x1.fffc17d63cbf3p-1, -0x1.1bfb15f07bc42p-55, 0x1.1ff959c031dcp-12, -0x1.493dff5f95794p-10, 0x1.f18403c5bda5cp-9,
     -0x1.16eb9bfacbf6dp-7, 0x1.edbd2c62cc46ep-7, -0x1.65f6406754ad6p-6, 0x1.b2cb6a4ea11f2p-6, -0x1.bf69db4cfa819p-6,
     0x1.8618a5cce05c7p-6, -0x1.195c061a9e6e7p-6}, /* [22] 1.375 <= y <= 1.4375 2^2, degree 10, 69.6 bits */
    {0x1.fffdce578e1a2p-1, -0x1.db19883a42c1ap-55, 0x1.44ba51d47a781p-13, -0x1.75058146b24a3p-11, 0x1.1b70b7594379ap-9,
     -0x1.4007109483b34p-8, 0x1.1dbd1e539ae05p-7, -0x1.a3093f96c8bd7p-7, 0x1.026636d1fc6f4p-6, -0x1.0fbbed263c56fp-6,
     0x1.ea0ad8573d031p-7, -0x1.766dc0d2fa40fp-7}, /* [23] 1.4375 <= y <= 1.5 2^2, degree 10, 69.9 bits */
    {0x1.fffec548d93dfp-1, -0x1.cfb91c3010859p-55, 0x1.6d3b4e42c69bp-14, -0x1.a555a37b55c74p-12, 0x1.41c59b612b17p-10,
     -0x1.6d889d353647cp-9, 0x1.48d77c9fe81ap-8, -0x1.e6e285e8a2eaep-8, 0x1.3008155608d62p-7, -0x1.4546591b478a4p-7,
     0x1.2ccbb7850ea54p-7, -0x1.dea3b4b0aa7c8p-8}, /* [24] 1.5 <= y <= 1.5625 2^2, degree 10, 71.4 bits */
    {0x1.ffff5002048cbp-1, 0x1.5cad6b6094895p-56, 0x1.99d51150971bp-15, -0x1.da9aaf1940b8p-13, 0x1.6c18c0f90e3ffp-11,
     -0x1.9fdbc20db8328p-10, 0x1.7896c74947ac5p-9, -0x1.1916d29b4c7cfp-8, 0x1.62c3c29528f41p-8, -0x1.80e8c597294bbp-8,
     0x1.6b06a67d7f3a7p-8, -0x1.29751a57dba9bp-8}, /* [25] 1.5625 <= y <= 1.625 2^2, degree 10, 71.8 bits */
    {0x1.ffff9dc393d2bp-1, 0x1.4800e7467d6f7p-56, 0x1.cae80f1beb7ddp-16, -0x1.0aa5290ba21f1p-13, 0x1.9ac9db3794a45p-12,
     -0x1.d7753ebed926fp-11, 0x1.ad6d004033a8ap-10, -0x1.42d2355374829p-9, 0x1.9b1b57521e40ep-9, -0x1.c343428e24511p-9,
     0x1.b065710ce63e5p-9, -0x1.6a5e6997b2e0ep-9}, /* [26] 1.625 <= y <= 1.6875 2^2, degree 10, 72.3 bits */
    {0x1.ffffc9423a2a2p-1, -0x1.f6a8767a9cf9ep-55, 0x1.006e8b4599b08p-16, -0x1.2af23895da217p-14, 0x1.ce40ec23b2b9dp-13,
     -0x1.0a69f73736899p-11, 0x1.e7d5f46dd562cp-11, -0x1.71082c6ef23d8p-10, 0x1.d99b9f8df7554p-10,
     -0x1.06813cdbbb735p-9, 0x1.fda59d4ae1526p-10, -0x1.b2c9604b93d41p-10}
     /* [27] 1.6875 <= y <= 1.75 2^2, degree 10, 73.5 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_tail_eps_zero_force)

/* beta/(1 - eps) at zero force, 1 - eps < 1/2: 52 rows of degree 10 in y = (1 - eps)^(1/3), nodes 0 + i 0.015625, 0 <= y <= 0.804688.
 * Relative error of the approximation: 2^-58.7 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_FORCE_STEP 0.015625
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_FORCE_PER_UNIT 64.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_FORCE_ROWS 52
#define COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_hertz_dashpot_near_beta_zero_force, 52, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.1e621cp-1, -0x1.f76211026490ep-28, -0x1.ef6d62d466183p-94, 0x1.04fd15771395ap-3, 0x1.ca3692ce85fcap-3,
     0x1.8c68e174d05a7p-5, 0x1.a194ef24ebe1ep-4, 0x1.11bc62e03e857p-3, 0x1.1216c73cf35c4p-4, 0x1.1fd005dd25b3ep-4,
     0x1.b8c0b0aae1144p-4, 0x1.04b9102465f2bp-4}, /* [0] 0 <= y <= 0.0078125, degree 10, 70.5 bits */
    {0x1.1e664c8p-1, -0x1.b23216739351dp-30, 0x1.0fc745ea59d83p-8, 0x1.1a9ee86014f36p-3, 0x1.d0f020cc1113bp-3,
     0x1.d1be0a1c0ab3fp-5, 0x1.d66099ebe203dp-4, 0x1.21c7f79475dcfp-3, 0x1.3a0f7aac65806p-4, 0x1.60bba53087bp-4,
     0x1.e3acf4f7508f5p-4, 0x1.29b6c62816f83p-4}, /* [1] 0.0078125 <= y <= 0.0234375, degree 10, 66.8 bits */
    {0x1.1e73528p-1, -0x1.5598761f02a2dp-28, 0x1.1aad79b5e9d4dp-7, 0x1.309830e2d4133p-3, 0x1.d8cfd623d936cp-3,
     0x1.0fc9084739757p-4, 0x1.073344d6a12a1p-3, 0x1.343dc93537ad6p-3, 0x1.6a8b9d3f20e7bp-4, 0x1.a838639d5a6bap-4,
     0x1.0b5a5ab7a82fep-3, 0x1.65e7971fbc1ddp-4}, /* [2] 0.0234375 <= y <= 0.0390625, degree 10, 66.2 bits */
    {0x1.1e89ddp-1, 0x1.ed7371b5094b6p-28, 0x1.b88cd40573d9p-7, 0x1.46f788ead21e7p-3, 0x1.e1f8bd2dbc0c1p-3,
     0x1.3b37db5684319p-4, 0x1.25131b47d1c2cp-3, 0x1.499b237bbd552p-3, 0x1.a471a0cb6704ep-4, 0x1.f7995819bb5d4p-4,
     0x1.2a2cdb3824442p-3, 0x1.b1f3db686a88fp-4}, /* [3] 0.0390625 <= y <= 0.0546875, degree 10, 66.3 bits */
    {0x1.1eaaap-1, 0x1.897c2f7600bb9p-28, 0x1.30dc5cfdc0debp-6, 0x1.5dcd3c88b05c6p-3, 0x1.ec9035a17d5c4p-3,
     0x1.6b7bc7bf40e33p-4, 0x1.451bec8ebc545p-3, 0x1.626b2e8586534p-3, 0x1.e8d7da601be8cp-4, 0x1.2845b61de256p-3,
     0x1.4fa40100347eap-3, 0x1.0839d44e00e89p-3}, /* [4] 0.0546875 <= y <= 0.0703125, degree 10, 65.5 bits */
    {0x1.1ed652p-1, -0x1.68116f8ce538ep-29, 0x1.8b38663915e5dp-6, 0x1.752b681e13174p-3, 0x1.f8be53e039441p-3,
     0x1.a0f20a58e9058p-4, 0x1.67a7a3c334425p-3, 0x1.7f49df8eab296p-3, 0x1.1c8848f59dfafp-3, 0x1.5a91d36acf62cp-3,
     0x1.7d50c5d64d3e4p-3, 0x1.425e13863c8d2p-3}, /* [5] 0.0703125 <= y <= 0.0859375, degree 10, 69.4 bits */
    {0x1.1f0dad8p-1, -0x1.aa845b5190cfp-29, 0x1.eb7f1adc37565p-6, 0x1.8d261b66bccbfp-3, 0x1.035728c449236p-2,
     0x1.dc071d4a8cdf5p-4, 0x1.8d1fb8593a927p-3, 0x1.a0e7a07aed4cep-3, 0x1.4b5c135bf3ef8p-3, 0x1.93f90167b1e49p-3,
     0x1.b50fe70e21d33p-3, 0x1.898ad73d3985bp-3}, /* [6] 0.0859375 <= y <= 0.101562, degree 10, 65.2 bits */
    {0x1.1f51728p-1, 0x1.235219d578fdep-30, 0x1.28ed2b4b7649fp-5, 0x1.a5d3823b0db5dp-3, 0x1.0b4788c23b73bp-2,
     0x1.0e9ca77f8ba94p-3, 0x1.b5ff4d33f1a07p-3, 0x1.c80dcf51be77fp-3, 0x1.81e2f08d629aep-3, 0x1.d60cd20b399ccp-3,
     0x1.f91f73d5f25ap-3, 0x1.e07ff2f9a3cb9p-3}, /* [7] 0.101562 <= y <= 0.117188, degree 10, 66.4 bits */
    {0x1.1fa267p-1, -0x1.7da1593458247p-28, 0x1.5f3ce43842d3ap-5, 0x1.bf4c14050a69ep-3, 0x1.1449dd1cd203p-2,
     0x1.328ddb7ed8f0ep-3, 0x1.e2d5c76a63f5ap-3, 0x1.f5a44041e15bap-3, 0x1.c1501a183417ap-3, 0x1.115bfafdb4371p-2,
     0x1.261d30abe1805p-2, 0x1.25622f8096db1p-2}, /* [8] 0.117188 <= y <= 0.132812, degree 10, 64.3 bits */
    {0x1.200156p-1, 0x1.173dd2a69cfa9p-29, 0x1.98c9c633f239cp-5, 0x1.d9aacb04601a8p-3, 0x1.1e7a348e100d4p-2,
     0x1.5a2cceaf6f4acp-3, 0x1.0a24fbb7ccfc3p-2, 0x1.155bfc6be0264p-2, 0x1.058d5a450dff3p-2, 0x1.3e29163e6fa46p-2,
     0x1.58ddedc6985b5p-2, 0x1.666f3122413ep-2}, /* [9] 0.132812 <= y <= 0.148438, degree 10, 65.9 bits */
    {0x1.206f138p-1, -0x1.4f21c9707b549p-28, 0x1.d5b26a000219p-5, 0x1.f50d64a8fca3ap-3, 0x1.29f781ccc11ffp-2,
     0x1.85dd371916bd7p-3, 0x1.258efa90c511dp-2, 0x1.3441b5454c5c7p-2, 0x1.30867cc0706a1p-2, 0x1.72dceb7ead5f4p-2,
     0x1.96e6507c3b44dp-2, 0x1.b64e64a6caac1p-2}, /* [10] 0.148438 <= y <= 0.164062, degree 10, 64.3 bits */
    {0x1.20ec7ap-1, -0x1.b8a934349cf4p-28, 0x1.0b0ca80b3d8d9p-4, 0x1.08ca56403bdc6p-2, 0x1.36e4151a1f8f3p-2,
     0x1.b6132be613c32p-3, 0x1.4419eb5d05bbcp-2, 0x1.583c434ea29fdp-2, 0x1.62ab81b0a3bfbp-2, 0x1.b13a6754aacbp-2,
     0x1.e2cec1e84bee4p-2, 0x1.0c5dc5b01f7e3p-1}, /* [11] 0.164062 <= y <= 0.179688, degree 10, 63.9 bits */
    {0x1.217a6d8p-1, 0x1.e1e85a3a47b4ep-28, 0x1.2d12a3df07e4ap-4, 0x1.17b269b96c9acp-2, 0x1.456629dc677ccp-2,
     0x1.eb55dcf57b95ep-3, 0x1.6649ba191f548p-2, 0x1.82268f6e3133ep-2, 0x1.9d5321b72282ap-2, 0x1.fb6d4e54ee582p-2,
     0x1.1fecd02d913eap-1, 0x1.49432fbedc251p-1}, /* [12] 0.179688 <= y <= 0.195312, degree 10, 64.0 bits */
    {0x1.2219dep-1, -0x1.a090ca0f1cb19p-28, 0x1.5100f0f2c92fdp-4, 0x1.2752eaacef1c8p-2, 0x1.55a88be3ab481p-2,
     0x1.13216512b7d66p-2, 0x1.8cb8ba7c9cec6p-2, 0x1.b30513e7f45adp-2, 0x1.e2217cbf945bfp-2, 0x1.2a12b965a725p-1,
     0x1.59125592875f8p-1, 0x1.94f39f8aa88bcp-1}, /* [13] 0.195312 <= y <= 0.210938, degree 10, 66.8 bits */
    {0x1.22cbc4p-1, 0x1.d8628df064ae8p-29, 0x1.76eff8dbd556cp-4, 0x1.37c1f7aeff9d4p-2, 0x1.67db58c584f7dp-2,
     0x1.33c8cb8798c79p-2, 0x1.b81bfadcdb799p-2, 0x1.ec0f4df769a75p-2, 0x1.198d5b332787ap-1, 0x1.5f5cf1d5537d4p-1,
     0x1.9f74e4aa42426p-1, 0x1.f37842de90fecp-1}, /* [14] 0.210938 <= y <= 0.226562, degree 10, 64.3 bits */
    {0x1.239128p-1, -0x1.ebf8ae565d6b7p-28, 0x1.9efb0e961cbeep-4, 0x1.491814fd1ddd7p-2, 0x1.7c34e2bc5995ap-2,
     0x1.580c4f62d13a5p-2, 0x1.e9489431d7c56p-2, 0x1.175dbde4933e9p-1, 0x1.495d4c1e7382ap-1, 0x1.9fab4b79b7566p-1,
     0x1.f66a378ab8d67p-1, 0x1.3509cb7f82c66p+0}, /* [15] 0.226562 <= y <= 0.242188, degree 10, 65.0 bits */
    {0x1.246b1e8p-1, -0x1.f82a21e4a70d6p-28, 0x1.c940c020d87cfp-4, 0x1.5b707d0c1e1dfp-2, 0x1.92f2bbb4ae5f8p-2,
     0x1.806939e8542e1p-2, 0x1.109d1acd94a02p-1, 0x1.3e66a3d1d98a3p-1, 0x1.82095e5c0c28p-1, 0x1.ed9bf85017e67p-1,
     0x1.311cb736fa87bp+0, 0x1.7fd4634d6f49dp+0}, /* [16] 0.242188 <= y <= 0.257812, degree 10, 64.4 bits */
    {0x1.255acd8p-1, -0x1.c14d31a0c3744p-28, 0x1.f5e33300cb39bp-4, 0x1.6ee97eb41c629p-2, 0x1.ac5af0bf3a6a9p-2,
     0x1.ad7241d44beb3p-2, 0x1.308d9d82cd04dp-1, 0x1.6c3418f605da4p-1, 0x1.c578a1edd94e3p-1, 0x1.263e2e88def66p+0,
     0x1.74334d8e054ddp+0, 0x1.dea44260c9dc5p+0}, /* [17] 0.257812 <= y <= 0.273438, degree 10, 63.5 bits */
    {0x1.26616c8p-1, 0x1.43d068b67aebbp-29, 0x1.128446c142fb2p-3, 0x1.83a4eb79c9c1ap-2, 0x1.c8bd800e9f50dp-2,
     0x1.dfd3918a59fafp-2, 0x1.55275a905d59dp-1, 0x1.a213665bc8c7ep-1, 0x1.0b04af979442ep+0, 0x1.603e32057c9ep+0,
     0x1.c80c1546e948dp+0, 0x1.2bbc8c86b8092p+1}, /* [18] 0.273438 <= y <= 0.289062, degree 10, 63.8 bits */
    {0x1.278048p-1, 0x1.ec652bf6b3312p-30, 0x1.2b6db7779f98ep-3, 0x1.99c898fc7193cp-2, 0x1.e87616186a835p-2,
     0x1.0c2bd6bf2f0dap-1, 0x1.7f3e733aef726p-1, 0x1.e19c195584184p-1, 0x1.3b58b9af017fdp+0, 0x1.a7793761c6b76p+0,
     0x1.18a7f99031ea2p+1, 0x1.79279c70b76bep+1}, /* [19] 0.289062 <= y <= 0.304688, degree 10, 63.4 bits */
    {0x1.28b8c2p-1, 0x1.6567d76b4dde5p-28, 0x1.45c5bca8f130ap-3, 0x1.b17ef938fae2cp-2, 0x1.05f710c3bceb9p-1,
     0x1.2bf6b93016ad9p-1, 0x1.afd1704a66a56p-1, 0x1.1661660bf2a47p+0, 0x1.759440b1f3dcep+0, 0x1.ff5ae7ac7ef72p+0,
     0x1.5b0d50a81b126p+1, 0x1.dcec6788e1a6fp+1}, /* [20] 0.304688 <= y <= 0.320312, degree 10, 62.2 bits */
    {0x1.2a0c568p-1, 0x1.1bd6ee153ec5dp-29, 0x1.61a6f7f65a83bp-3, 0x1.caf7ce24f05ffp-2, 0x1.19cfa8cdae92ap-1,
     0x1.4fd7b8eedefa3p-1, 0x1.e81310230cf56p-1, 0x1.42f89d4517a96p+0, 0x1.bc0fa1ffe9cf8p+0, 0x1.3626002eb59dep+1,
     0x1.af3d1c8967098p+1, 0x1.2f2048de9161dp+2}, /* [21] 0.320312 <= y <= 0.335938, degree 10, 62.4 bits */
    {0x1.2b7c9dp-1, 0x1.3b06b92ab25d2p-29, 0x1.7f2f37101934dp-3, 0x1.e668fe2cc8b5dp-2, 0x1.300b4bcb24e8bp-1,
     0x1.787684676a7f2p-1, 0x1.14bb534a8e268p+0, 0x1.7812a7735864bp+0, 0x1.08e221b44c147p+1, 0x1.7a0207a81ebddp+1,
     0x1.0d47c31c4c84dp+2, 0x1.83768a132366fp+2}, /* [22] 0.335938 <= y <= 0.351562, degree 10, 63.6 bits */
    {0x1.2d0b4dp-1, 0x1.6d14e19a53d53p-29, 0x1.9e7fdda491609p-3, 0x1.0207c836adb37p-1, 0x1.48fbe52896122p-1,
     0x1.a69ad1f6788b6p-1, 0x1.3adfe7a5d64c7p+0, 0x1.b78cb38199d26p+0, 0x1.3d3e80b6aa40bp+1, 0x1.cefc35e368e6cp+1,
     0x1.5213fa0e5e265p+2, 0x1.f228fffdd2af6p+2}, /* [23] 0.351562 <= y <= 0.367188, degree 10, 62.7 bits */
    {0x1.2eba418p-1, -0x1.f6364154cc95bp-29, 0x1.bfbe60881b353p-3, 0x1.12186c92c13d8p-1, 0x1.650109b486435p-1,
     0x1.db3365876bec5p-1, 0x1.678b39802b217p+0, 0x1.01de386ff083ap+1, 0x1.7d8b72447645p+1, 0x1.1cfcfd75aa3eep+2,
     0x1.aacffe5432e17p+2, 0x1.4236ac9f88392p+3}, /* [24] 0.367188 <= y <= 0.382812, degree 10, 62.7 bits */
    {0x1.308b7c8p-1, -0x1.11df21f2af40ep-29, 0x1.e314d56a972c4p-3, 0x1.238df07a578e1p-1, 0x1.848aac2ce4144p-1,
     0x1.0baf6e51d2888p+0, 0x1.9c103ae758c3p+0, 0x1.2fc9491b101a4p+1, 0x1.ccec17715e30ep+1, 0x1.60ba098d005ecp+2,
     0x1.0efe277368e79p+3, 0x1.a385f034e7276p+3}, /* [25] 0.382812 <= y <= 0.398438, degree 10, 62.5 bits */
    {0x1.32812d8p-1, -0x1.573813c87d1e6p-29, 0x1.04594d96d1478p-2, 0x1.36958a1460714p-1, 0x1.a81c700cba0b5p-1,
     0x1.2e3b61a18a38bp+0, 0x1.da116db46d9fap+0, 0x1.6764375b24d0bp+1, 0x1.17b994d85f958p+2, 0x1.b703d62f351ffp+2,
     0x1.5a3c5fa9c5308p+3, 0x1.12f9ee29ae913p+4}, /* [26] 0.398438 <= y <= 0.414062, degree 10, 64.6 bits */
    {0x1.349db6p-1, -0x1.772981aae1e48p-28, 0x1.18668fee68da2p-2, 0x1.4b632567e6193p-1, 0x1.d051c448328c2p-1,
     0x1.560ecedcde7a8p+0, 0x1.11cb3472b6c07p+1, 0x1.ab0e621612376p+1, 0x1.5539c21493e66p+2, 0x1.12d066f0b66b8p+3,
     0x1.bd3d6fed427f9p+3, 0x1.6b10156ab8873p+4}, /* [27] 0.414062 <= y <= 0.429688, degree 10, 61.5 bits */
    {0x1.36e3bp-1, -0x1.531facd96623ep-30, 0x1.2dd0653b64095p-2, 0x1.62329f5ca296bp-1, 0x1.fde2fc1cb59efp-1,
     0x1.842866ac20c6dp+0, 0x1.3d93fdeac4857p+1, 0x1.fdd29b9086d8cp+1, 0x1.a2777ea8fd5d4p+2, 0x1.5a2f55ec15fb3p+3,
     0x1.203cc499d421cp+4, 0x1.e3030c0166c43p+4}, /* [28] 0.429688 <= y <= 0.445312, degree 10, 65.1 bits */
    {0x1.3955f68p-1, -0x1.810df3425cee4p-34, 0x1.44b9081a9bb4cp-2, 0x1.7b494531e9c94p-1, 0x1.18d5d66370418p+0,
     0x1.b9bfc1eb44cc8p+0, 0x1.71fa9d6723823p+1, 0x1.31cf2002acb7cp+2, 0x1.020c11207d8f9p+3, 0x1.b6ef7db7fa339p+3,
     0x1.77e5c7949cda8p+4, 0x1.43e0659d2160ep+5}, /* [29] 0.445312 <= y <= 0.460938, degree 10, 61.8 bits */
    {0x1.3bf7adp-1, 0x1.9ef3a61d6436ap-29, 0x1.5d475f75f9a7p-2, 0x1.96f7a9bc60c53p-1, 0x1.365956b35c0c4p+0,
     0x1.f854331a5f092p+0, 0x1.b1025267cd0eap+1, 0x1.70c6256f7dd13p+2, 0x1.40289749aef27p+3, 0x1.182f57306c063p+4,
     0x1.edf9bb882131fp+4, 0x1.b608ec73373a6p+5}, /* [30] 0.460938 <= y <= 0.476562, degree 10, 61.4 bits */
    {0x1.3ecc4a8p-1, 0x1.930c0fccceeb8p-30, 0x1.77a7c4472b848p-2, 0x1.b59be6c7fda53p-1, 0x1.581a1a6e9b9b6p+0,
     0x1.20e005cfe1c56p+1, 0x1.fd3aece35fce6p+1, 0x1.bf2647dc342eap+2, 0x1.8fc04f6eeb3c2p+3, 0x1.684ed2bf8e06dp+4,
     0x1.4735f9a5d62ebp+5, 0x1.2ae2ba270cb4cp+6}, /* [31] 0.476562 <= y <= 0.492188, degree 10, 61.4 bits */
    {0x1.41d7a48p-1, 0x1.368d4f3b1a823p-31, 0x1.940cef8e31ddap-2, 0x1.d7a467b6c4995p-1, 0x1.7ed75d9cb5f1fp+0,
     0x1.4c28edcf11077p+1, 0x1.2cf68c9476284p+2, 0x1.10acbc1bd23b7p+3, 0x1.f6833010d41abp+3, 0x1.d2ed2c5caca5p+4,
     0x1.b53bf348ced2cp+5, 0x1.9bc87d72028f2p+6}, /* [32] 0.492188 <= y <= 0.507812, degree 10, 61.8 bits */
    {0x1.451dfd8p-1, -0x1.283e0ab995337p-29, 0x1.b2b11a32c0df5p-2, 0x1.fd93637f69a96p-1, 0x1.ab79bf07410f9p+0,
     0x1.7f76e567f9da3p+1, 0x1.65ab4fe0a4895p+2, 0x1.4e9fff37b2ed4p+3, 0x1.3e1f8719943cdp+4, 0x1.3108c56356c3fp+5,
     0x1.26cf7e6a8a704p+6, 0x1.1e8d0f5e1066ep+7}, /* [33] 0.507812 <= y <= 0.523438, degree 10, 61.4 bits */
    {0x1.48a415p-1, -0x1.f8e82bc3e5969p-28, 0x1.d3d75b4698528p-2, 0x1.14019c37c8d8p+0, 0x1.df1debd1ffc23p+0,
     0x1.bc9d01636367ap+1, 0x1.ab7e8eb592bf1p+2, 0x1.9d5f39defe69bp+3, 0x1.95e246daaba1p+4, 0x1.92094f569ea4p+5,
     0x1.917438f1b35b3p+6, 0x1.932353e0b55d9p+7}, /* [34] 0.523438 <= y <= 0.539062, degree 10, 62.7 bits */
    {0x1.4c6f3a8p-1, -0x1.c84a54973eef2p-29, 0x1.f7cd54c429b58p-2, 0x1.2bd5f66b63323p+0, 0x1.0d9142a1c33bbp+1,
     0x1.02f697de4c246p+2, 0x1.01082dc9e6725p+3, 0x1.01223abc5fa6ap+4, 0x1.050e4c17f1ddap+5, 0x1.0b6b8507cb16p+6,
     0x1.1432ab135b9eap+7, 0x1.1ede2d2504285p+8}, /* [35] 0.539062 <= y <= 0.554688, degree 10, 61.7 bits */
    {0x1.5085658p-1, 0x1.b8ed31a8cc649p-28, 0x1.0f76a1e31b5f2p-1, 0x1.46b517712999fp+0, 0x1.309d31341c9fap+1,
     0x1.2f305b0e5ecf6p+2, 0x1.3717369e01511p+3, 0x1.425242bb5a8fap+4, 0x1.52c439471700cp+5, 0x1.6750f35227657p+6,
     0x1.804dd2b79d306p+7, 0x1.9d54be0f3124ap+8}, /* [36] 0.554688 <= y <= 0.570312, degree 10, 60.6 bits */
    {0x1.54ed518p-1, -0x1.ba9b11e548b23p-28, 0x1.24d047e6a828cp-1, 0x1.6524271d5089ap+0, 0x1.59c261e46cbaep+1,
     0x1.64e7d9d5458f9p+2, 0x1.7b2305b5acd16p+3, 0x1.9753495432cb1p+4, 0x1.bbc3191b1a6f4p+5, 0x1.e7f9b14307d0fp+6,
     0x1.0e93ec295a0fbp+8, 0x1.2dbe9ce517e75p+9}, /* [37] 0.570312 <= y <= 0.585938, degree 10, 61.3 bits */
    {0x1.59ae9cp-1, 0x1.c6fde3f263bf7p-28, 0x1.3c317ed427e99p-1, 0x1.87c4ebbeefaa5p+0, 0x1.8a56dcb5cbfaep+1,
     0x1.a69f068bfdec4p+2, 0x1.d183c08503fadp+3, 0x1.03a111a9b3cc5p+5, 0x1.259a7b580b652p+6, 0x1.4f2dcf397b49ap+7,
     0x1.81f19996ca6e5p+8, 0x1.bedddba2d34ap+9}, /* [38] 0.585938 <= y <= 0.601562, degree 10, 61.6 bits */
    {0x1.5ed1f3p-1, -0x1.4f6ac29e5be5ap-28, 0x1.55e35b7fba983p-1, 0x1.af5d5d5bffc29p+0, 0x1.c40cfb3f6a497p+1,
     0x1.f7a3a3e454ef6p+2, 0x1.2014eaf0d5876p+4, 0x1.4e1b0d9f91dd1p+5, 0x1.88c5036f3d0cbp+6, 0x1.d230fc80a7f97p+7,
     0x1.1717f5b561111p+9, 0x1.50045aa80e39dp+10}, /* [39] 0.601562 <= y <= 0.617188, degree 10, 61.2 bits */
    {0x1.6461408p-1, -0x1.85a58685b71cfp-28, 0x1.723cb46a76d77p-1, 0x1.dce1a1fbded0dp+0, 0x1.0488b1954f9c7p+2,
     0x1.2e2debf6a84fap+3, 0x1.67a6883248352p+4, 0x1.b25900e1e24ep+5, 0x1.09d4f506439c5p+7, 0x1.489423914b4f2p+8,
     0x1.99c0b89780733p+9, 0x1.00e550296b46p+11}, /* [40] 0.617188 <= y <= 0.632812, degree 10, 60.4 bits */
    {0x1.6a67ecp-1, 0x1.1616655a5d27ep-31, 0x1.91a569e32af8ep-1, 0x1.08c0adb91196p+1, 0x1.2e1a44a71e0d7p+2,
     0x1.6d5a320c72c05p+3, 0x1.c539461371f75p+4, 0x1.1d7893300d05cp+6, 0x1.6c78f5a511c31p+7, 0x1.d5f4c8c3ac918p+8,
     0x1.31ba7309b7343p+10, 0x1.8ff419aa056b3p+11}, /* [41] 0.632812 <= y <= 0.648438, degree 10, 60.6 bits */
    {0x1.70f326p-1, -0x1.94c76c2321922p-28, 0x1.b49aa5f102103p-1, 0x1.275ccac720c0ap+1, 0x1.609277cb6450dp+2,
     0x1.bd60d2205249bp+3, 0x1.207ec84ed4fafp+5, 0x1.7bca965c216c5p+6, 0x1.faba7a54e9866p+7, 0x1.5571b172f70b2p+9,
     0x1.d0633868d8e0bp+10, 0x1.3d82422c97633p+12}, /* [42] 0.648438 <= y <= 0.664062, degree 10, 60.7 bits */
    {0x1.7812458p-1, 0x1.fdd7cdb762553p-28, 0x1.dbb46c5f98d22p-1, 0x1.4b369f31d12f3p+1, 0x1.9e6103bb05995p+2,
     0x1.11eba071985b4p+4, 0x1.73630a8318f65p+5, 0x1.fff82f3ccb1fap+6, 0x1.65a94490ba1f9p+8, 0x1.f8cec79dce49ep+9,
     0x1.6798774b836adp+11, 0x1.01861faedb47p+13}, /* [43] 0.664062 <= y <= 0.679688, degree 10, 60.9 bits */
    {0x1.7fd7458p-1, 0x1.c9f37683fe0fdp-29, 0x1.03d67c623c20fp+0, 0x1.7583802e5b5c7p+1, 0x1.eac9febac1a16p+2,
     0x1.5449545918d37p+4, 0x1.e3f73a773d1fap+5, 0x1.5e18a527aa0e9p+7, 0x1.00b3dd566396p+9, 0x1.7c5224491d59ep+10,
     0x1.1c707d0194ee4p+12, 0x1.abb40d5f58023p+13}, /* [44] 0.679688 <= y <= 0.695312, degree 10, 59.9 bits */
    {0x1.88575c8p-1, -0x1.06abf929402d3p-30, 0x1.1cb5504a48514p+0, 0x1.a7d4654d7c996p+1, 0x1.251ef4b4ffcacp+3,
     0x1.ab5ed1392ecd2p+4, 0x1.3f9af0b298be6p+6, 0x1.e67f1c40cd963p+7, 0x1.7757449d80a4p+9, 0x1.2498a7468e148p+11,
     0x1.ccaa9eedc4e39p+12, 0x1.6c83bed164167p+14}, /* [45] 0.695312 <= y <= 0.710938, degree 10, 61.9 bits */
    {0x1.91abc88p-1, 0x1.a45a30a131866p-29, 0x1.3906a2a6ad1b8p+0, 0x1.e437d41db033fp+1, 0x1.616ec5d61b175p+3,
     0x1.0fa32c55503fep+5, 0x1.ac76a6f433aefp+6, 0x1.580a69877e4efp+8, 0x1.1811ac851f163p+10, 0x1.ccc8693c74dc6p+11,
     0x1.7ede38838ba79p+13, 0x1.3fbbf0c9de979p+15}, /* [46] 0.710938 <= y <= 0.726562, degree 10, 60.4 bits */
    {0x1.9bf2d9p-1, -0x1.8aefdf5e1e2f1p-28, 0x1.59807454d28fcp+0, 0x1.16b595769a5c5p+2, 0x1.aea1c2f585f96p+3,
     0x1.5dff0f6d701b7p+5, 0x1.2401a66d9f7c6p+7, 0x1.f0443fa47c36bp+8, 0x1.ab95ecb23fab7p+10, 0x1.745403989ed4ep+12,
     0x1.4791632e45052p+14, 0x1.2199513bdf617p+16}, /* [47] 0.726562 <= y <= 0.742188, degree 10, 60.3 bits */
    {0x1.a7514ep-1, 0x1.46b239feb0a44p-29, 0x1.7f0be5326aaf2p+0, 0x1.4391d9b0e977cp+2, 0x1.096fe1438274ep+4,
     0x1.c9d5b01a359bep+5, 0x1.957e06e8ca5d2p+7, 0x1.6de89da83eca5p+9, 0x1.4ed794d3f2ebep+11, 0x1.35b4fd41fdeebp+13,
     0x1.218440a4245fcp+15, 0x1.0fea0c63a18e7p+17}, /* [48] 0.742188 <= y <= 0.757812, degree 10, 61.1 bits */
    {0x1.b3f43bp-1, -0x1.4d98a5e7a96f1p-28, 0x1.aad7e9ffd372bp+0, 0x1.7b3eb2bcd2402p+2, 0x1.4b93f44053394p+4,
     0x1.309c5991484c6p+6, 0x1.1f84e8fdb962cp+8, 0x1.14996633470c2p+10, 0x1.0de295a5219a3p+12, 0x1.0a31d7fdc6d39p+14,
     0x1.0974cb465790fp+16, 0x1.09e61b2475aacp+18}, /* [49] 0.757812 <= y <= 0.773438, degree 10, 62.2 bits */
    {0x1.c21398p-1, -0x1.8b238bfb132a6p-32, 0x1.de74b08cf3a7fp+0, 0x1.c153848e3f007p+2, 0x1.a478e49158b96p+4,
     0x1.9d4b1faba59cp+6, 0x1.a19a7aad74d17p+8, 0x1.ae344ecf5a1dfp+10, 0x1.c192892bb10bcp+12, 0x1.daf862bcf126p+14,
     0x1.fb9226a4f6b36p+16, 0x1.1053fddba90efp+19}, /* [50] 0.773438 <= y <= 0.789062, degree 10, 61.8 bits */
    {0x1.d1f5e78p-1, 0x1.1a2ed26a57bacp-28, 0x1.0dfe5a9c0bba2p+1, 0x1.0d7d5751ca453p+3, 0x1.0f3d11dfc08d3p+5,
     0x1.1eb5a5df69d6dp+7, 0x1.37b65ecdd2019p+9, 0x1.59a16c67b95dcp+11, 0x1.84d406b1c278ap+13, 0x1.ba471b6cd3024p+15,
     0x1.fd2014bed371dp+17, 0x1.2622bfd8637e2p+20} /* [51] 0.789062 <= y <= 0.804688, degree 10, 58.7 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_beta_zero_force)

/* beta at zero force by eps, 2^-25 <= eps < 2^-1: 384 rows of degree 10 in y = eps 2^-k, 16 to each octave k = -25 ... -2.
 * Relative error of the approximation: 2^-58.5 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE_FIRST 2.9802322387695312e-08
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE_FIRST_OCTAVE (-25)
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE_OCTAVE_BITS 4
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE_ROWS 384
#define COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_hertz_dashpot_beta_zero_force, 384, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.f9bc7db0e87dcp+9, 0x1.7c5d594995c3p-45, -0x1.88544d1aad4b1p+8, 0x1.0a4ee875416f3p+8, -0x1.9d2e644b8bc34p+7,
     0x1.548fbcb924621p+7, -0x1.229cc988d222p+7, 0x1.fb4035589a2bp+6, -0x1.c1b7c38faf716p+6, 0x1.93621c56c0bb6p+6,
     -0x1.6dd41f4ad0b8p+6, 0x1.4d772e69a9033p+6}, /* [0] 1 <= y <= 1.0625 2^-25, degree 10, 60.7 bits */
    {0x1.edf8ded84cde7p+9, -0x1.bc020fed3e0cp-45, -0x1.694e4d886c38bp+8, 0x1.ce78a45b9445p+7, -0x1.5243c062d30b7p+7,
     0x1.06e1443d4f722p+7, -0x1.a702e9b77959cp+6, 0x1.5c13f32117017p+6, -0x1.22f6e333a6ff6p+6, 0x1.ec253eac0ed85p+5,
     -0x1.a4ba2cf293889p+5, 0x1.69978cf51a991p+5}, /* [1] 1.0625 <= y <= 1.125 2^-25, degree 10, 60.4 bits */
    {0x1.e31d0019c3d69p+9, -0x1.62a58aedf837p-45, -0x1.4e433ebcb094p+8, 0x1.94ba8734abafbp+7, -0x1.180746aac1783p+7,
     0x1.9bb7aa5c4c405p+6, -0x1.3959b06a4b4f7p+6, 0x1.e7cf6d6514224p+5, -0x1.81ba44a6d26b2p+5, 0x1.3495030ba0aa2p+5,
     -0x1.f2fd3c44722f4p+4, 0x1.95abf6faad5ccp+4}, /* [2] 1.125 <= y <= 1.1875 2^-25, degree 10, 60.8 bits */
    {0x1.d90be5c9e0554p+9, 0x1.c4a2d35501d9p-45, -0x1.368357ca66977p+8, 0x1.64b11391a66aap+7, -0x1.d445aa4eda777p+6,
     0x1.4696fb90eb72ep+6, -0x1.d7a10df6c02f8p+5, 0x1.5c47ab5c52deep+5, -0x1.0546083c5b126p+5, 0x1.8c999055d54fep+4,
     -0x1.302a4ce373d4ep+4, 0x1.d533a03e1744ep+3}, /* [3] 1.1875 <= y <= 1.25 2^-25, degree 10, 60.3 bits */
    {0x1.cfad75d526592p+9, 0x1.9f24925560fcp-45, -0x1.218428ab75a41p+8, 0x1.3c5968d013d8dp+7, -0x1.8b0cfc77b62a9p+6,
     0x1.0615196fa4328p+6, -0x1.680301802f8d9p+5, 0x1.f9c5c803440f2p+4, -0x1.68e9d848ecea8p+4, 0x1.048fd8e3e854cp+4,
     -0x1.7c1e28920bb9p+3, 0x1.16e16e9a952b8p+3}, /* [4] 1.25 <= y <= 1.3125 2^-25, degree 10, 60.0 bits */
    {0x1.c6ed7439c7711p+9, 0x1.472fe5cfbaa8ep-46, -0x1.0ed750479ce14p+8, 0x1.1a2dac72dfe9p+7, -0x1.4ffd37f1f7735p+6,
     0x1.a910b77c5ba92p+5, -0x1.165e4b48a1a1ep+5, 0x1.74e253ac41b4fp+4, -0x1.fb6b5f2b3174dp+3, 0x1.5d4b19ac20833p+3,
     -0x1.e5cdbe5b29f3dp+2, 0x1.53d749a803958p+2}, /* [5] 1.3125 <= y <= 1.375 2^-25, degree 10, 60.1 bits */
    {0x1.bebabeae11fd6p+9, 0x1.6c899a67e33ffp-46, -0x1.fc47a11829edbp+7, 0x1.fa053aae3e62cp+6, -0x1.1fde8e4339605p+6,
     0x1.5c00863485c3ep+5, -0x1.b38b3bd4fe1c4p+4, 0x1.16bf820f7564bp+4, -0x1.6a75f990cb06bp+3, 0x1.dcd65d3e8a6aep+2,
     -0x1.3cd38b474da03p+2, 0x1.a7910a209738ap+1}, /* [6] 1.375 <= y <= 1.4375 2^-25, degree 10, 61.0 bits */
    {0x1.b706b6028c4eap+9, 0x1.b6d76f117f3e7p-45, -0x1.de425ef7c838ap+7, 0x1.c7df50c1df0ccp+6, -0x1.f09c1a9d89674p+5,
     0x1.1f6651c4c3503p+5, -0x1.5863f28472981p+4, 0x1.a60fba9199735p+3, -0x1.06baddada78ebp+3, 0x1.4aed8c6b9a4fcp+2,
     -0x1.a501cc6d6d741p+1, 0x1.0d72875c3089p+1}, /* [7] 1.4375 <= y <= 1.5 2^-25, degree 10, 61.6 bits */
    {0x1.afc4c92536fbfp+9, -0x1.ba6eefd735e96p-46, -0x1.c327b6629c03cp+7, 0x1.9c7c00044e4ep+6, -0x1.af01074279ec5p+5,
     0x1.de809c7dbc1ap+4, -0x1.12fe0ccb68dabp+4, 0x1.43419fc9ce21ap+3, -0x1.8205ca49aeb8p+2, 0x1.d260dab689983p+1,
     -0x1.1c8831173f81fp+1, 0x1.5d56cc02402f6p+0}, /* [8] 1.5 <= y <= 1.5625 2^-25, degree 10, 61.4 bits */
    {0x1.a8ea193a0a37cp+9, -0x1.cd11ad5e02a29p-48, -0x1.aa94e7bf1628p+7, 0x1.76b8f08463672p+6, -0x1.78311dcbcc037p+5,
     0x1.9145735852a0cp+4, -0x1.bb211ee9393b9p+3, 0x1.f479bbb821e13p+2, -0x1.1f1b81ce525a2p+2, 0x1.4d4512beca1a6p+1,
     -0x1.86ac5b6d9af9ap+0, 0x1.ccd86ea5c0b97p-1}, /* [9] 1.5625 <= y <= 1.625 2^-25, degree 10, 61.0 bits */
    {0x1.a26d30a72a445p+9, 0x1.9fee0b402a5c1p-50, -0x1.9437783ac8568p+7, 0x1.55ad5e0b3ec44p+6, -0x1.4a12b227502dfp+5,
     0x1.52cabb1b119dcp+4, -0x1.6803abd27286bp+3, 0x1.8742c79e114dap+2, -0x1.aff800c9115a5p+1, 0x1.e2803e1d616fap+0,
     -0x1.101d79ac0e688p+0, 0x1.34e102d6a8439p-1}, /* [10] 1.625 <= y <= 1.6875 2^-25, degree 10, 62.1 bits */
    {0x1.9c45c89e97c08p+9, -0x1.a2e8c3544070fp-46, -0x1.7fca0622a56dcp+7, 0x1.389d0b07ab44fp+6, -0x1.2303c05215b88p+5,
     0x1.1fd70578576a9p+4, -0x1.26bf81bf92b43p+3, 0x1.34ae7e0c607b6p+2, -0x1.4867b46e56eep+1, 0x1.617bb96852dadp+0,
     -0x1.802fbc02856f8p-1, 0x1.a43bc14eefd49p-2}, /* [11] 1.6875 <= y <= 1.75 2^-25, degree 10, 61.6 bits */
    {0x1.966c99db0b9aep+9, -0x1.80fc90e1a4e18p-46, -0x1.6d11d22aa075dp+7, 0x1.1eee81118d4bep+6, -0x1.01bc2cbd73d7fp+5,
     0x1.ebf5189a5bba6p+3, -0x1.e616a2be8e13dp+2, 0x1.eb348341ee903p+1, -0x1.f8412d550cf5fp+0, 0x1.05dbc82f5b3ap+0,
     -0x1.129a6fb3c27c9p-1, 0x1.21d438e0cb3eap-2}, /* [12] 1.75 <= y <= 1.8125 2^-25, degree 10, 61.2 bits */
    {0x1.90db361b440c9p+9, -0x1.0f6477d4fc64ap-46, -0x1.5bdcd09404fadp+7, 0x1.0823b42718389p+6, -0x1.ca704740621e5p+4,
     0x1.a6b225862556dp+3, -0x1.937ed57181be2p+2, 0x1.89ebc461e06c6p+1, -0x1.86ad8f7d67cb4p+0, 0x1.88009674e4708p-1,
     -0x1.8d20cc083ad9bp-2, 0x1.94f055561f458p-3}, /* [13] 1.8125 <= y <= 1.875 2^-25, degree 10, 62.4 bits */
    {0x1.8b8be8812c0c4p+9, -0x1.8e39df2a89a14p-45, -0x1.4c00217545714p+7, 0x1.e7a8c8db77f5p+5, -0x1.9950607c5abdp+4,
     0x1.6d070b1e3cd43p+3, -0x1.5105a8ec87ecap+2, 0x1.3e3cbd21027e2p+1, -0x1.3144eca1b5554p+0, 0x1.2842e39f1a2ebp-1,
     -0x1.2248618d42af7p-2, 0x1.1e498727d7858p-3}, /* [14] 1.875 <= y <= 1.9375 2^-25, degree 10, 61.1 bits */
    {0x1.86799b6ae4e19p+9, 0x1.6d5524ce6784bp-45, -0x1.3d56d81215b5dp+7, 0x1.c353943f9c114p+5, -0x1.6ecad08d7fa36p+4,
     0x1.3cb8dfe410d07p+3, -0x1.1b23b97ba2718p+2, 0x1.02ded4f86ce4ep+1, -0x1.e0e070f78ea66p-1, 0x1.c3df178968d61p-2,
     -0x1.acae59534a381p-3, 0x1.995bdb4f1737p-4}, /* [15] 1.9375 <= y <= 2 2^-25, degree 10, 61.0 bits */
    {0x1.7f46b730f7ea8p+9, 0x1.ee9cb44f94005p-45, -0x1.29548980eb76cp+8, 0x1.93a5dcd950754p+7, -0x1.392202c8cee2ep+7,
     0x1.0218ecaccd1bcp+7, -0x1.b87c73d4a7b6fp+6, 0x1.806c9c2b1ebb7p+6, -0x1.54d288e2fb025p+6, 0x1.31b514d97d58ep+6,
     -0x1.153f0a3411ffbp+6, 0x1.f97074d083068p+5}, /* [16] 1 <= y <= 1.0625 2^-24, degree 10, 60.4 bits */
    {0x1.765c5516e61c9p+9, 0x1.ba5efb6f450bdp-47, -0x1.11d1a05bd3a5fp+8, 0x1.5e7cde1534d9bp+7, -0x1.005b5160962a9p+7,
     0x1.8e7397e977064p+6, -0x1.40952c37b79b6p+6, 0x1.07cb33ea0eb8cp+6, -0x1.b905043906272p+5, 0x1.74f9ff7f0ffdp+5,
     -0x1.3eda05740755ap+5, 0x1.1209168c0bc1cp+5}, /* [17] 1.0625 <= y <= 1.125 2^-24, degree 10, 60.3 bits */
    {0x1.6e21954ae671fp+9, -0x1.327fed94836f6p-47, -0x1.faa5db4cc7932p+7, 0x1.32ba1e466f456p+7, -0x1.a8719c2125794p+6,
     0x1.380604e3b4dffp+6, -0x1.daf34ab29513cp+5, 0x1.71b0ea6ffd94bp+5, -0x1.2453aea764de5p+5, 0x1.d3b91629ad9aap+4,
     -0x1.7a29c22384603p+4, 0x1.3371134b68231p+4}, /* [18] 1.125 <= y <= 1.1875 2^-24, degree 10, 61.8 bits */
    {0x1.668080bddea4p+9, -0x1.d382f590b82fdp-45, -0x1.d6a67218ff55fp+7, 0x1.0e52641b78f15p+7, -0x1.62e24c219b20ep+6,
     0x1.ef04813275f84p+5, -0x1.656d960070cecp+5, 0x1.07f266456129dp+5, -0x1.8c04462b8dbc6p+4, 0x1.2c91068e99054p+4,
     -0x1.cd073f6eda9e7p+3, 0x1.6396a06240292p+3}, /* [19] 1.1875 <= y <= 1.25 2^-24, degree 10, 61.3 bits */
    {0x1.5f66d36485d9cp+9, 0x1.91469495927ddp-46, -0x1.b6d33012a1e71p+7, 0x1.df7ef69bc988ap+6, -0x1.2b647c3a29556p+6,
     0x1.8d3e22b7a6296p+5, -0x1.10d68130d51c8p+5, 0x1.7f4dd145874e9p+4, -0x1.1185721e10f1p+4, 0x1.8af021fb9d6a6p+3,
     -0x1.20135056e3daap+3, 0x1.a6b43694d8909p+2}, /* [20] 1.25 <= y <= 1.3125 2^-24, degree 10, 60.9 bits */
    {0x1.58c5378899941p+9, 0x1.a1f1dc217d2e1p-45, -0x1.9a84c77924064p+7, 0x1.abb3df6e6ff49p+6, -0x1.fd43af62d6372p+5,
     0x1.4223a959259a9p+5, -0x1.a5ed73907ae92p+4, 0x1.1a97e3e3a6a0dp+4, -0x1.808d5288e3953p+3, 0x1.08b702a68e82ep+3,
     -0x1.702b9d507763bp+2, 0x1.018d2264d79bcp+2}, /* [21] 1.3125 <= y <= 1.375 2^-24, degree 10, 62.1 bits */
    {0x1.528eb0faafdd9p+9, -0x1.ad9c459202e93p-45, -0x1.81345520d5e36p+7, 0x1.7f7decef06d4bp+6, -0x1.b45414c683fcp+5,
     0x1.07bc7c5aa6eadp+5, -0x1.4a14a09eb8a98p+4, 0x1.a680cc7422764p+3, -0x1.12b1a81b6417ep+3, 0x1.69600b09fd627p+2,
     -0x1.e0380e48dbfecp+1, 0x1.4100e1bc7b439p+1}, /* [22] 1.375 <= y <= 1.4375 2^-24, degree 10, 60.7 bits */
    {0x1.4cb82aeccb227p+9, -0x1.c537af20e7879p-46, -0x1.6a73fe725cfa1p+7, 0x1.597c9ab114c63p+6, -0x1.785c23541195cp+5,
     0x1.b39dd4de9f69dp+4, -0x1.04ffc920b08c2p+4, 0x1.3fdcdfcd5ca18p+3, -0x1.8e3962c4a9914p+2, 0x1.f597cd13a7be8p+1,
     -0x1.3f104d79e5c7dp+1, 0x1.9867e7a273a0dp+0}, /* [23] 1.4375 <= y <= 1.5 2^-24, degree 10, 62.2 bits */
    {0x1.47381f4972ce3p+9, 0x1.e7f3057c17dcfp-47, -0x1.55e978e73085ap+7, 0x1.389ad4de0eae4p+6, -0x1.46a3d950bbd9ap+5,
     0x1.6aa316053a74cp+4, -0x1.a0cf80f23612ep+3, 0x1.e9f70d438ea44p+2, -0x1.248ceb3242ed4p+2, 0x1.6172ded667009p+1,
     -0x1.af4517bf0a35ap+0, 0x1.08bfdfd2518f9p+0}, /* [24] 1.5 <= y <= 1.5625 2^-24, degree 10, 61.4 bits */
    {0x1.4206510d2dfe2p+9, -0x1.6c54b3163331ep-45, -0x1.4349ee23e81fp+7, 0x1.1bfc91684efbfp+6, -0x1.1d19a58005e6dp+5,
     0x1.301b58a1c0c93p+4, -0x1.4fd44dd120b46p+3, 0x1.7b4a20864fdd3p+2, -0x1.b32c6e33aeb46p+1, 0x1.f92482ece5f41p+0,
     -0x1.281332d4f2f0cp+0, 0x1.5d416c0715b19p-1}, /* [25] 1.5625 <= y <= 1.625 2^-24, degree 10, 60.4 bits */
    {0x1.3d1b94fce7ee3p+9, 0x1.8cb3806bbb8c7p-46, -0x1.3256dc1cebc8fp+7, 0x1.02f168e2675cbp+6, -0x1.f44c1a5849b9ap+4,
     0x1.00c19d24f2ba5p+4, -0x1.10d702c6b9a1dp+3, 0x1.2885335a3333dp+2, -0x1.475f02b1a466bp+1, 0x1.6daad8bd54c91p+0,
     -0x1.9c730f4bd1a65p-1, 0x1.d42c47d8cd72bp-2}, /* [26] 1.625 <= y <= 1.6875 2^-24, degree 10, 61.6 bits */
    {0x1.3871a55797cd6p+9, -0x1.9735c8e13b594p-49, -0x1.22dbadf7cd35ap+7, 0x1.d9d564dc924b8p+5, -0x1.b91888c4d323p+4,
     0x1.b448a88f286c5p+3, -0x1.bec12d689508cp+2, 0x1.d3dfb6dff69b5p+1, -0x1.f1c4e3566b504p+0, 0x1.0be3e8974bcbcp+0,
     -0x1.2328aea27dee4p-1, 0x1.3e7a36c8e6cecp-2}, /* [27] 1.6875 <= y <= 1.75 2^-24, degree 10, 60.9 bits */
    {0x1.3402fe04d14efp+9, 0x1.061c73e490667p-50, -0x1.14abde0c26775p+7, 0x1.b2e84107293ebp+5, -0x1.86a744cce2592p+4,
     0x1.74d585213d08p+3, -0x1.7062dd3a8e1cep+2, 0x1.74439028040cap+1, -0x1.7e274fd76e352p+0, 0x1.8ce7410e7f633p-1,
     -0x1.a038834620c5ap-2, 0x1.b74c73718573bp-3}, /* [28] 1.75 <= y <= 1.8125 2^-24, degree 10, 62.5 bits */
    {0x1.2fcabf63c12c8p+9, -0x1.5be75d5ea2046p-46, -0x1.07a17edcd976bp+7, 0x1.905c591bb7264p+5, -0x1.5b6e7b5953a43p+4,
     0x1.4057f89c89f62p+3, -0x1.31cadb589146fp+2, 0x1.2a894b1f7c2f1p+1, -0x1.28141cf26369cp+0, 0x1.29150bf3b5bf8p-1,
     -0x1.2cf783c192687p-2, 0x1.32e2e11ce671cp-3}, /* [29] 1.8125 <= y <= 1.875 2^-24, degree 10, 61.1 bits */
    {0x1.2bc49652e9ed2p+9, -0x1.54666b551edc7p-45, -0x1.f7382473c1947p+6, 0x1.7193a9dfe5ef5p+5, -0x1.3633ba9da8ba7p+4,
     0x1.14a3a1250feb8p+3, -0x1.fed47f820b278p+1, 0x1.e25b884bc75d6p+0, -0x1.ceb3a1c20782cp-1, 0x1.c10c558dc733fp-2,
     -0x1.b7fc842f7af62p-3, 0x1.b1ee28ef57641p-4}, /* [30] 1.875 <= y <= 1.9375 2^-24, degree 10, 61.6 bits */
    {0x1.27eca85e4e7f8p+9, 0x1.405afbd9319ecp-45, -0x1.e0ff389acfb18p+6, 0x1.560aaa82156cep+5, -0x1.15fa038bf583bp+4,
     0x1.e00fa629e0ac2p+2, -0x1.ad28cc95b452cp+1, 0x1.885fcf8a531ffp+0, -0x1.6c6fbb12293a3p-1, 0x1.56745dccfc529p-2,
     -0x1.44e127bc7bf76p-3, 0x1.363c6a0282045p-4}, /* [31] 1.9375 <= y <= 2 2^-24, degree 10, 61.8 bits */
    {0x1.22780157df75bp+9, 0x1.dc54dc9cc94d5p-45, -0x1.c2ab408cdb247p+7, 0x1.31e875cf41c7fp+7, -0x1.da9eec25724afp+6,
     0x1.8733d8d051f9cp+6, -0x1.4dd37cfc4985dp+6, 0x1.2356d25a58bcdp+6, -0x1.024b8c4ad50dcp+6, 0x1.cf5da12755d31p+5,
     -0x1.a43a0da271c01p+5, 0x1.7f0d2712ad9d5p+5}, /* [32] 1 <= y <= 1.0625 2^-23, degree 10, 61.6 bits */
    {0x1.1bb647a29d5aep+9, 0x1.2e1955aa245efp-46, -0x1.9f0848fc16785p+7, 0x1.099ec47805b58p+7, -0x1.8490715c72e28p+6,
     0x1.2df848f77db74p+6, -0x1.e5e9a04394edap+5, 0x1.8fd62d6582bb4p+5, -0x1.4e3afb1b4b713p+5, 0x1.1aa9d4ac0b016p+5,
     -0x1.e349eca1a710ap+4, 0x1.9f5c34edf3274p+4}, /* [33] 1.0625 <= y <= 1.125 2^-23, degree 10, 60.6 bits */
    {0x1.1579a8ffc7b5bp+9, -0x1.be2bda91b2f13p-47, -0x1.7ff7c61d87d7ep+7, 0x1.d0e95649045f5p+6, -0x1.41ab18831e02ap+6,
     0x1.d8f076f25a775p+5, -0x1.67f1f3ef1299cp+5, 0x1.182c69a4173cfp+5, -0x1.bb15b2a26e35fp+4, 0x1.6277c0c264cc1p+4,
     -0x1.1e9815a2c0fbap+4, 0x1.d1fe98e2b3075p+3}, /* [34] 1.125 <= y <= 1.1875 2^-23, degree 10, 60.1 bits */
    {0x1.0fb17ff3aef32p+9, 0x1.5b1570e3a17dp-46, -0x1.64afcb6f5061bp+7, 0x1.99bb447cefc84p+6, -0x1.0cf3ac5d93b8cp+6,
     0x1.77273d1c6e915p+5, -0x1.0ee13f7cf5651p+5, 0x1.901197095a87p+4, -0x1.2c1fe4099979ap+4, 0x1.c792dd1909c7p+3,
     -0x1.5d64e7bd556b7p+3, 0x1.0d7c521db34e3p+3}, /* [35] 1.1875 <= y <= 1.25 2^-23, degree 10, 61.3 bits */
    {0x1.0a4ff4b6ac6e9p+9, -0x1.822ddba9e7573p-46, -0x1.4c91530811e4p+7, 0x1.6b63e32454f22p+6, -0x1.c5cb5b4498ce8p+5,
     0x1.2d0dc33397a82p+5, -0x1.9d8b867824ab8p+4, 0x1.227d79cd98669p+4, -0x1.9e94ae2544402p+3, 0x1.2b4e9d25d422ap+3,
     -0x1.b4a40996f84cap+2, 0x1.405987b87163ap+2}, /* [36] 1.25 <= y <= 1.3125 2^-23, degree 10, 65.1 bits */
    {0x1.054968265c9ccp+9, -0x1.2e78589721ba6p-45, -0x1.371d9203da734p+7, 0x1.44235f423503fp+6, -0x1.81f34c253ce3bp+5,
     0x1.e845a23f91779p+4, -0x1.3fc2e7e862329p+4, 0x1.ac54da08f9f1ap+3, -0x1.236f9d2d76adep+3, 0x1.913b97e9fd887p+2,
     -0x1.17055ff8dd713p+2, 0x1.865ff449b7d87p+1}, /* [37] 1.3125 <= y <= 1.375 2^-23, degree 10, 61.1 bits */
    {0x1.009402ffa06afp+9, -0x1.914836f802d29p-50, -0x1.23ee4ea51b92dp+7, 0x1.22a1f805a1e6ap+6, -0x1.4aacdd296801p+5,
     0x1.8fbfe259f4946p+4, -0x1.f44f07565e567p+3, 0x1.40329266e2928p+3, -0x1.a05bb76068a63p+2, 0x1.11df070db9354p+2,
     -0x1.6bf01e87c1c93p+1, 0x1.e68cdfd966e98p+0}, /* [38] 1.375 <= y <= 1.4375 2^-23, degree 10, 61.1 bits */
    {0x1.f84ebeb9d34a6p+8, 0x1.cbd3e11a4bd7ap-46, -0x1.12b047fa0e004p+7, 0x1.05d484eefb973p+6, -0x1.1d3a436b834a4p+5,
     0x1.4a22bc92af414p+4, -0x1.8b99d0ecf40cfp+3, 0x1.e4d2489a3f351p+2, -0x1.2dcc2adab2b79p+2, 0x1.7c22ede265e37p+1,
     -0x1.e39c3403bb122p+0, 0x1.358389320c793p+0}, /* [39] 1.4375 <= y <= 1.5 2^-23, degree 10, 60.9 bits */
    {0x1.eff88b0a61545p+8, -0x1.d69ce7cacbbbdp-47, -0x1.031f107891afp+7, 0x1.d9d213668cff1p+5, -0x1.ef180adac2a96p+4,
     0x1.12d3dc237c9f1p+4, -0x1.3be22733f13aep+3, 0x1.7352fae56046fp+2, -0x1.bb6c74db07af3p+1, 0x1.0bdd33eaba392p+1,
     -0x1.46d76cc11e2c6p+0, 0x1.914907028e80bp-1}, /* [40] 1.5 <= y <= 1.5625 2^-23, degree 10, 60.4 bits */
    {0x1.e818ee45e34ecp+8, -0x1.a1d1430172391p-48, -0x1.ea03e19b7f586p+6, 0x1.ae71883adfe3fp+5, -0x1.b02199ca7583p+4,
     0x1.ccf09c9bf19e2p+3, -0x1.fd05ad5c6560dp+2, 0x1.1f72a27cc9fc1p+2, -0x1.49ccc8f36d258p+1, 0x1.7ed39aa52030fp+0,
     -0x1.c0c40dafc2fe6p-1, 0x1.08afaddfc094ap-1}, /* [41] 1.5625 <= y <= 1.625 2^-23, degree 10, 61.0 bits */
    {0x1.e0a50abb7c5ebp+8, -0x1.c39e5c2c6597cp-47, -0x1.d0531360a01fcp+6, 0x1.887c07724ef0fp+5, -0x1.7b2794155a69p+4,
     0x1.852b7f22691a3p+3, -0x1.9d8c4c5983f19p+2, 0x1.c170db614ae5p+1, -0x1.f033b268fa3cep+0, 0x1.151fc43f064fdp+0,
     -0x1.389409f658776p-1, 0x1.62cf0e13120dfp-2}, /* [42] 1.625 <= y <= 1.6875 2^-23, degree 10, 62.0 bits */
    {0x1.d9935e8cb1e2ep+8, -0x1.02cb4ad9a8b6p-46, -0x1.b8dc036847f48p+6, 0x1.671955c0b1ec4p+5, -0x1.4e49cd2c1bcadp+4,
     0x1.4aa433fd9e518p+3, -0x1.5293a6b01d3b9p+2, 0x1.62950972e82f4p+1, -0x1.793d0e6159abdp+0, 0x1.960bb86625298p-1,
     -0x1.b950800b04cf7p-2, 0x1.e2b8b64464ad7p-3}, /* [43] 1.6875 <= y <= 1.75 2^-23, degree 10, 61.0 bits */
    {0x1.d2db8d6326be1p+8, -0x1.5559c59540d6ap-46, -0x1.a35b36129e8a4p+6, 0x1.49992ae6739ffp+5, -0x1.280f5f77c70d5p+4,
     0x1.1a8e33ecce6c6p+3, -0x1.172f41edf8cap+2, 0x1.1a1f9457ae42p+1, -0x1.219e48c3ee89ap+0, 0x1.2ccbe97ada3f3p-1,
     -0x1.3b6fb765466cfp-2, 0x1.4ced187d77c11p-3}, /* [44] 1.75 <= y <= 1.8125 2^-23, degree 10, 62.4 bits */
    {0x1.cc763431a2206p+8, -0x1.2eaeacfaa0929p-48, -0x1.8f972e8922d17p+6, 0x1.2f6abcaad9798p+5, -0x1.074dd45edfe01p+4,
     0x1.e58ce273d8c27p+2, -0x1.cf7ea7f8f0097p+1, 0x1.c47f1c33d738cp+0, -0x1.c0c5726a9c6e2p-1, 0x1.c24ae1f699281p-2,
     -0x1.c82e3657e36ccp-3, 0x1.d12712fb9fa9p-4}, /* [45] 1.8125 <= y <= 1.875 2^-23, degree 10, 60.9 bits */
    {0x1.c65cc4df392c5p+8, -0x1.f6b0f09a2b834p-46, -0x1.7d5eacc6ef8b5p+6, 0x1.18164abf6a239p+5, -0x1.d62dbbe2d161ep+3,
     0x1.a34e8662ff17bp+2, -0x1.83230cab37325p+1, 0x1.6d8f0a4ad840ep+0, -0x1.5ea991937ff55p-1, 0x1.5450a025d06f3p-2,
     -0x1.4d7287c82d7b6p-3, 0x1.48db9412a2287p-4}, /* [46] 1.875 <= y <= 1.9375 2^-23, degree 10, 60.8 bits */
    {0x1.c089683cd00e4p+8, -0x1.e8dbf98a8a67dp-46, -0x1.6c874673009ebp+6, 0x1.033825e8c6144p+5, -0x1.a5557fd98fb5p+3,
     0x1.6bd18552a6acap+2, -0x1.453df90c3028bp+1, 0x1.295d395e3ef67p+0, -0x1.1430f509b0448p-1, 0x1.038835b83a7b7p-2,
     -0x1.ec6ce30cfbdadp-4, 0x1.d63adae26df1p-5}, /* [47] 1.9375 <= y <= 2 2^-23, degree 10, 61.2 bits */
    {0x1.b84478ffc6a59p+8, 0x1.c5ba22df68fb4p-46, -0x1.558b482aadaf8p+7, 0x1.cfab9934a0d84p+6, -0x1.67b20bd64a5e4p+6,
     0x1.2879e7bff383ap+6, -0x1.f9fc66fd45c51p+5, 0x1.b996728bdde56p+5, -0x1.8780944285827p+5, 0x1.5f2a66d670325p+5,
     -0x1.3e78eec0739f1p+5, 0x1.224c77d97dfebp+5}, /* [48] 1 <= y <= 1.0625 2^-22, degree 10, 59.7 bits */
    {0x1.ae06b13b5d82p+8, -0x1.15b59370f0a78p-46, -0x1.3a895c056f864p+7, 0x1.929af46d38012p+6, -0x1.267a0ed977574p+6,
     0x1.c9b36f2d8de79p+5, -0x1.7040c553d9bcep+5, 0x1.2f05037b36796p+5, -0x1.fa9941f599168p+4, 0x1.ac700c3f919d2p+4,
     -0x1.6e43b3b871f8dp+4, 0x1.3ac8c1b75fe1bp+4}, /* [49] 1.0625 <= y <= 1.125 2^-22, degree 10, 60.6 bits */
    {0x1.a492a9a9fdbc1p+8, -0x1.be0e984e88514p-47, -0x1.22fe7a28710c9p+7, 0x1.60565d15f344bp+6, -0x1.e78eeec337238p+5,
     0x1.666bcf7a29c0bp+5, -0x1.10c99908b0205p+5, 0x1.a8a9e95c7c7d1p+4, -0x1.4fcba832519efp+4, 0x1.0ca2eb64488a3p+4,
     -0x1.b2653e0144798p+3, 0x1.612869ff5d5b6p+3}, /* [50] 1.125 <= y <= 1.1875 2^-22, degree 10, 61.7 bits */
    {0x1.9bcf271753b5fp+8, -0x1.7343481b6e0f3p-47, -0x1.0e519af723f6ap+7, 0x1.3684cc5659466p+6, -0x1.97a7b02727e79p+5,
     0x1.1c502a86f189fp+5, -0x1.9a93c784c3ab4p+4, 0x1.2f320acf87ebep+4, -0x1.c6e76647ffcc6p+3, 0x1.5942a78b6e472p+3,
     -0x1.08ca9368414e9p+3, 0x1.9876c26877d88p+2}, /* [51] 1.1875 <= y <= 1.25 2^-22, degree 10, 61.5 bits */
    {0x1.93a72e24db608p+8, -0x1.afe8505bfbdc1p-46, -0x1.f814742bffb8ep+6, 0x1.136608070b3ccp+6, -0x1.57e97bbd689f2p+5,
     0x1.c84ff8e322ddap+4, -0x1.39689c8a0a678p+4, 0x1.b84d04efd53efp+3, -0x1.3a318db41e48cp+3, 0x1.c5a9c342a4602p+2,
     -0x1.4ae8944bad266p+2, 0x1.e6f1cb267137dp+1}, /* [52] 1.25 <= y <= 1.3125 2^-22, degree 10, 61.4 bits */
    {0x1.8c09215bf8b24p+8, 0x1.3cc60b1aacd52p-50, -0x1.d7908089c2a28p+6, 0x1.eb4d59f8c9eddp+5, -0x1.247ef30df1c27p+5,
     0x1.720a8a3b927c8p+4, -0x1.e4aaf2fa370efp+3, 0x1.449d596a924fap+3, -0x1.b9bc073be130ap+2, 0x1.3013e1e45e70bp+2,
     -0x1.a6eab5e0a3866p+1, 0x1.27d94e3afed75p+1}, /* [53] 1.3125 <= y <= 1.375 2^-22, degree 10, 60.6 bits */
    {0x1.84e6163f38d8dp+8, -0x1.26a761883449ep-46, -0x1.ba7c6919d1d66p+6, 0x1.b8846e140fc1cp+5, -0x1.f535d75e60767p+4,
     0x1.2ef4236b079ffp+4, -0x1.7b29cb06a6caep+3, 0x1.e554324878a4ap+2, -0x1.3b8a684a200fp+2, 0x1.9f1c79219e55fp+1,
     -0x1.13d03f39eda15p+1, 0x1.70bc7a74a34bap+0}, /* [54] 1.375 <= y <= 1.4375 2^-22, degree 10, 61.3 bits */
    {0x1.7e31522bb3919p+8, -0x1.d8052fd9b1c2fp-48, -0x1.a059fd75e0d44p+6, 0x1.8cdc5cb086c0fp+5, -0x1.b05313338fbbcp+4,
     0x1.f46474e7ad0ebp+3, -0x1.2bcf3bccf85dap+3, 0x1.6f6d124fa1eafp+2, -0x1.c9708d29479d5p+1, 0x1.2016f1e35e9c7p+1,
     -0x1.6e821028455dap+0, 0x1.d522a3dbb68c5p-1}, /* [55] 1.4375 <= y <= 1.5 2^-22, degree 10, 60.8 bits */
    {0x1.77dfe48121a54p+8, -0x1.fce5c5decd9e6p-51, -0x1.88c185fa505ap+6, 0x1.6716de779e774p+5, -0x1.7736190892f11p+4,
     0x1.a08f9a6d8894ap+3, -0x1.deca391a9fae8p+2, 0x1.19694320a689ap+2, -0x1.500d6a0451018p+1, 0x1.9601917ddd5dp+0,
     -0x1.ef66322c83474p-1, 0x1.301e0fc53c6f4p-1}, /* [56] 1.5 <= y <= 1.5625 2^-22, degree 10, 65.3 bits */
    {0x1.71e8569ff5bebp+8, 0x1.0ce2c2ad4ff4ep-46, -0x1.735d0b75fc07fp+6, 0x1.46373120e9822p+5, -0x1.477e989eb5e9ap+4,
     0x1.5d53cb421ecc4p+3, -0x1.81c4507723cb4p+2, 0x1.b3b0863bfaa92p+1, -0x1.f3e226759b559p+0, 0x1.2220dd5187d53p+0,
     -0x1.5419da92b393p-1, 0x1.91307df089a54p-2}, /* [57] 1.5625 <= y <= 1.625 2^-22, degree 10, 60.8 bits */
    {0x1.6c426c671fcddp+8, -0x1.7dc9dd5ed118dp-48, -0x1.5fe4c05ed169p+6, 0x1.2972b213ca8f8p+5, -0x1.1f587fc185fb7p+4,
     0x1.26ef91e329d83p+3, -0x1.3969349f2415fp+2, 0x1.549cd3b402965p+1, -0x1.780d067337f06p+0, 0x1.a40aaca55c81ep-1,
     -0x1.d9c7bb1593372p-2, 0x1.0ce51575bd093p-2}, /* [58] 1.625 <= y <= 1.6875 2^-22, degree 10, 61.7 bits */
    {0x1.66e6f14f1c05ap+8, -0x1.5c45d29e44c6cp-49, -0x1.4e1c3e3b6e277p+6, 0x1.102581d2a8ad4p+5, -0x1.faafce049af4ap+3,
     0x1.f528b3cd55936p+2, -0x1.0097e49e6c02ap+2, 0x1.0cb9205bfdae5p+1, -0x1.1de4b768ca8dap+0, 0x1.33b9aa4aa20f5p-1,
     -0x1.4e74333143c99p-2, 0x1.6dd5a86eedbeap-3}, /* [59] 1.6875 <= y <= 1.75 2^-22, degree 10, 64.1 bits */
    {0x1.61cf8f45069eap+8, -0x1.a2ec474bd9e7ap-47, -0x1.3dd060901ece5p+6, 0x1.f3940f10355c3p+4, -0x1.c0be57e46352bp+3,
     0x1.ac4638b69bc8ep+2, -0x1.a72a39a2eaf77p+1, 0x1.ab9e85d305f17p+0, -0x1.b6fabac691a2ap-1, 0x1.c7ec2476d4e06p-2,
     -0x1.de1cbfc1a6c6bp-3, 0x1.f89f2f6da3333p-4}, /* [60] 1.75 <= y <= 1.8125 2^-22, degree 10, 60.5 bits */
    {0x1.5cf6ad225d254p+8, -0x1.2928ddaff039bp-46, -0x1.2ed5961401016p+6, 0x1.cbe5107e18533p+4, -0x1.8f183a5642225p+3,
     0x1.6ffa84d3e9ba5p+2, -0x1.5f437649c2d66p+1, 0x1.56edab00a9587p+0, -0x1.541aeba3befe9p-1, 0x1.55420db294679p-2,
     -0x1.59b864926cc39p-3, 0x1.60851626fb033p-4}, /* [61] 1.8125 <= y <= 1.875 2^-22, degree 10, 63.5 bits */
    {0x1.58575324461bap+8, 0x1.b3d39c4a19a69p-46, -0x1.21068badf7f89p+6, 0x1.a88885a32d81bp+4, -0x1.6454419a2834bp+3,
     0x1.3dc67a835e28fp+2, -0x1.256523c96b23dp+1, 0x1.150ab6ec13342p+0, -0x1.09c0a33ff7f87p-1, 0x1.01e91c36b81d1p-2,
     -0x1.f96970cc5b875p-4, 0x1.f2748ac36412cp-5}, /* [62] 1.875 <= y <= 1.9375 2^-22, degree 10, 60.7 bits */
    {0x1.53ed142741e26p+8, -0x1.047efc83f58d3p-48, -0x1.14431c45d7b28p+6, 0x1.88e7568de7707p+4, -0x1.3f4fcfd404a31p+3,
     0x1.13b917acd21eap+2, -0x1.ecf99f908c949p+0, 0x1.c2b851496173cp-1, -0x1.a2a0b7cc2575ep-2, 0x1.89608fe3bacedp-3,
     -0x1.7530512f3148cp-4, 0x1.645e2354d6da4p-5}, /* [63] 1.9375 <= y <= 2 2^-22, degree 10, 61.0 bits */
    {0x1.4da8bc1e23aafp+8, -0x1.da6607bc2e4dfp-46, -0x1.02d7debaab7f6p+7, 0x1.5f65a01d3924p+6, -0x1.109936b733085p+6,
     0x1.c15fcc886a1ffp+5, -0x1.7f774324d9071p+5, 0x1.4ea93a88ae7e3p+5, -0x1.28b40f30c1c25p+5, 0x1.0a2245fa4569fp+5,
     -0x1.e2b6cb47119dap+4, 0x1.b802bc277c146p+4}, /* [64] 1 <= y <= 1.0625 2^-21, degree 10, 59.5 bits */
    {0x1.45e5c9802906bp+8, 0x1.18a1bb04aec47p-46, -0x1.dcc02cd69a9a9p+6, 0x1.311e48cb6963ap+6, -0x1.be58059e82d1bp+5,
     0x1.5adf69a1a23cp+5, -0x1.171571ed2f02bp+5, 0x1.cb4ac34726335p+4, -0x1.7fee1f28090b3p+4, 0x1.44b1f706a1a07p+4,
     -0x1.15939f68ea257p+4, 0x1.dd1fb04695781p+3}, /* [65] 1.0625 <= y <= 1.125 2^-21, degree 10, 60.5 bits */
    {0x1.3ebbbcf8008c2p+8, -0x1.ed0848b018e73p-50, -0x1.b9111cf8986f2p+6, 0x1.0b05b47addc2bp+6, -0x1.718023b6b2429p+5,
     0x1.0fa1f58e26f82p+5, -0x1.9d7802cccb3f5p+4, 0x1.41d5c88c29662p+4, -0x1.fcf89990403a5p+3, 0x1.972d43b506dabp+3,
     -0x1.4935d82fe8435p+3, 0x1.0ba4c9aea14c8p+3}, /* [66] 1.125 <= y <= 1.1875 2^-21, degree 10, 60.4 bits */
    {0x1.3817775ae720ap+8, -0x1.247efc302f16bp-46, -0x1.99ba9aaf5a78ap+6, 0x1.d6a8c9ba1c9fep+5, -0x1.34f1f31e839ecp+5,
     0x1.aef0436ae8296p+4, -0x1.3728db408e2b4p+4, 0x1.cb8f051c21a46p+3, -0x1.58c0bb8020591p+3, 0x1.05a8963fb5491p+3,
     -0x1.915946694640fp+2, 0x1.358ecfdab2ed6p+2}, /* [67] 1.1875 <= y <= 1.25 2^-21, degree 10, 60.2 bits */
    {0x1.31e911eb0dfe2p+8, 0x1.b7b6c80a8b179p-46, -0x1.7e05fa82b1b7ap+6, 0x1.a16d51207fd9dp+5, -0x1.04a30d4b94722p+5,
     0x1.59d2089fdf8d7p+4, -0x1.db09fc9a10399p+3, 0x1.4daf93f3bcb01p+3, -0x1.dc3a87d44c22p+2, 0x1.57d054a58728dp+2,
     -0x1.f5919f851f82ep+1, 0x1.6ffc438f15a19p+1}, /* [68] 1.25 <= y <= 1.3125 2^-21, degree 10, 61.0 bits */
    {0x1.2c23331ea3cd3p+8, -0x1.f9137309f39a2p-46, -0x1.656196ec35381p+6, 0x1.745694ce4448bp+5, -0x1.bb576a13b8879p+4,
     0x1.187064bc9a9b5p+4, -0x1.6f4f4ca15b7a1p+3, 0x1.ec062bc3ac05ep+2, -0x1.4ec5b6a9cd855p+2, 0x1.cce55147a9b08p+1,
     -0x1.4082db874836dp+1, 0x1.c06c54f6c2393p+0}, /* [69] 1.3125 <= y <= 1.375 2^-21, degree 10, 60.5 bits */
    {0x1.26ba8d14e12d4p+8, 0x1.fa19d415ce5f5p-47, -0x1.4f5802bd979e7p+6, 0x1.4dd9b641aa869p+5, -0x1.7bd8cf6f6a2dbp+4,
     0x1.cb313de50e3f7p+3, -0x1.1f5a2c6ed33dep+3, 0x1.6fcf8e1cf1feap+2, -0x1.de453d26199ep+1, 0x1.3a987b68935dap+1,
     -0x1.a20e22e0533ecp+0, 0x1.17732e5975a84p+0}, /* [70] 1.375 <= y <= 1.4375 2^-21, degree 10, 62.5 bits */
    {0x1.21a57a37463f5p+8, 0x1.242c0baf9ff82p-46, -0x1.3b899bc88cb24p+6, 0x1.2cc3d3093dc9dp+5, -0x1.47a42495a359p+4,
     0x1.7b3a17fb01487p+3, -0x1.c66d3653902a1p+2, 0x1.167502c73fa77p+2, -0x1.5aacb4c060b8ep+1, 0x1.b4a995ff9c5f4p+0,
     -0x1.15c2e42e70c44p+0, 0x1.6389c94ccc5c8p-1}, /* [71] 1.4375 <= y <= 1.5 2^-21, degree 10, 60.7 bits */
    {0x1.1cdbb00ac6335p+8, 0x1.3bcd164055e8cp-46, -0x1.29a7c7a69df3ap+6, 0x1.1023b54da9fcdp+5, -0x1.1c5b809dbac08p+4,
     0x1.3bb1cb62519e6p+3, -0x1.6adaf03fc119p+2, 0x1.aa8a364cb719fp+1, -0x1.fd5c498ad007p+0, 0x1.33b1fd250d30dp+0,
     -0x1.77714c08bc9f6p-1, 0x1.ccf4bdb2d1514p-2}, /* [72] 1.5 <= y <= 1.5625 2^-21, degree 10, 63.7 bits */
    {0x1.1856028d62d92p+8, -0x1.47bc9267e2e19p-47, -0x1.19715ffe12ffp+6, 0x1.ee739da63dfcep+4, -0x1.f063bf03f455bp+3,
     0x1.08bdabbdddb0cp+3, -0x1.245b5b80bc6f2p+2, 0x1.4a30f0ee0c18ap+1, -0x1.7ad74ca6072e6p+0, 0x1.b7c0ac52cfd9ep-1,
     -0x1.01bf9c5a97067p-1, 0x1.300b7bf6d43acp-2}, /* [73] 1.5625 <= y <= 1.625 2^-21, degree 10, 61.8 bits */
    {0x1.140e3414b97eap+8, -0x1.21a237b22989fp-52, -0x1.0aaffa30e792ap+6, 0x1.c2d91bf25ff86p+4, -0x1.b3890bd2e0f3ep+3,
     0x1.bf0a253d5faddp+2, -0x1.db0ae937a3ed2p+1, 0x1.0222e356c52p+1, -0x1.1cfe5365530e6p+0, 0x1.3e550f0b79bf6p-1,
     -0x1.670ef541b28f7p-2, 0x1.97918e54f7c9dp-3}, /* [74] 1.625 <= y <= 1.6875 2^-21, degree 10, 62.8 bits */
    {0x1.0ffecebbe9645p+8, 0x1.350c416f075d4p-46, -0x1.fa6b9fbce82ecp+5, 0x1.9c7f82df425bcp+4, -0x1.7fff5441a1ae2p+3,
     0x1.7bced6132740bp+2, -0x1.84ec529fd3e72p+1, 0x1.974ef6b89f868p+0, -0x1.b1556cc6f3058p-1, 0x1.d26caec5841f1p-2,
     -0x1.faf0060bc83c1p-3, 0x1.15403be5bc2ddp-3}, /* [75] 1.6875 <= y <= 1.75 2^-21, degree 10, 64.8 bits */
    {0x1.0c2305351b6a5p+8, 0x1.e3bdca8a15263p-46, -0x1.e1b83d8905aadp+5, 0x1.7a9c539b4f0fep+4, -0x1.5415a75823046p+3,
     0x1.44925698ee53bp+2, -0x1.40b30a1ad4c22p+1, 0x1.441335d0ec9fep+0, -0x1.4caf35e65023ap-1, 0x1.5986596cfca4p-2,
     -0x1.6a5770c017277p-3, 0x1.7e6e98483cf04p-4}, /* [76] 1.75 <= y <= 1.8125 2^-21, degree 10, 63.0 bits */
    {0x1.0876995fdc626p+8, 0x1.2d92673ed450cp-47, -0x1.cb03c488ed7f1p+5, 0x1.5c893c2e079bp+4, -0x1.2e752cd850253p+3,
     0x1.16e0405c89b7p+2, -0x1.0a354f5e08c15p+1, 0x1.03e42ee5957b1p+0, -0x1.01c06f37e6fb2p-1, 0x1.02a018fd7fe35p-2,
     -0x1.0601d326b926p-3, 0x1.0b2905577435ep-4}, /* [77] 1.8125 <= y <= 1.875 2^-21, degree 10, 62.3 bits */
    {0x1.04f5c76b2d681p+8, 0x1.05b00707c5af2p-46, -0x1.b615a1e5dfee2p+5, 0x1.41bcadb057cbp+4, -0x1.0e0c273ffa0bcp+3,
     0x1.e1a86eaa5f3cdp+1, -0x1.bcb44981e95p+0, 0x1.a3ead3b0c7f09p-1, -0x1.92ce45d02826ep-2, 0x1.86eb6b1d08a14p-3,
     -0x1.7f07e27374f46p-4, 0x1.79c235a2aebc6p-5}, /* [78] 1.875 <= y <= 1.9375 2^-21, degree 10, 61.1 bits */
    {0x1.019d34947a801p+8, -0x1.260d18dcc3badp-48, -0x1.a2bd1ca225562p+5, 0x1.29c426301774cp+4, -0x1.e3fcaef40f20dp+2,
     0x1.a1eb240e8f7e4p+1, -0x1.759b0c961346ep+0, 0x1.55950a0993747p-1, -0x1.3d42c34a89658p-2, 0x1.2a1fd670a8f68p-3,
     -0x1.1ad3084bdfc72p-4, 0x1.0e138d88dd51bp-5}, /* [79] 1.9375 <= y <= 2 2^-21, degree 10, 61.7 bits */
    {0x1.f9baa8a8466dp+7, 0x1.02ea02cccc09bp-50, -0x1.8856256b51babp+6, 0x1.0a4f596c63427p+6, -0x1.9d2ed01108c8p+5,
     0x1.548ffd4dad555p+5, -0x1.229cf4fde32c4p+5, 0x1.fb40741ca7de4p+4, -0x1.c1b7f31930ebap+4, 0x1.936241995f7fcp+4,
     -0x1.6dd43d50785bcp+4, 0x1.4d77470ee1d77p+4}, /* [80] 1 <= y <= 1.0625 2^-20, degree 10, 60.1 bits */
    {0x1.edf6fb4401a3fp+7, -0x1.fa9a5d8dd16e7p-47, -0x1.6950185429296p+6, 0x1.ce79737edbfbcp+5, -0x1.52441d91893bep+5,
     0x1.06e178e4ae7bdp+5, -0x1.a7032c8953dd6p+4, 0x1.5c1420a1010fdp+4, -0x1.22f703b1c54bdp+4, 0x1.ec256eb321d83p+3,
     -0x1.a4ba516db56e8p+3, 0x1.6997a931c3a7bp+3}, /* [81] 1.0625 <= y <= 1.125 2^-20, degree 10, 60.3 bits */
    {0x1.e31b0e617b754p+7, -0x1.27b13a99058efp-49, -0x1.4e44fd1bb9a7p+6, 0x1.94bb46077d0cdp+5, -0x1.180797e35a9cep+5,
     0x1.9bb80132ed212p+4, -0x1.3959e48aa58ffp+4, 0x1.e7cfb08cefbd8p+3, -0x1.81ba7204f19ap+3, 0x1.349522c36e187p+3,
     -0x1.f2fd69d78eaf7p+2, 0x1.95ac18594c7f2p+2}, /* [82] 1.125 <= y <= 1.1875 2^-20, degree 10, 60.4 bits */
    {0x1.d909e64d19f3fp+7, 0x1.17de3fa7d65e7p-50, -0x1.36850ab0e838ap+6, 0x1.64b1c41f029bcp+5, -0x1.d44638ec9514ap+4,
     0x1.469743e77efefp+4, -0x1.d7a1605c795ep+3, 0x1.5c47ddb80539fp+3, -0x1.0546288335fc1p+3, 0x1.8c99bb27641a1p+2,
     -0x1.302a6a120284bp+2, 0x1.d533c8c925f27p+1}, /* [83] 1.1875 <= y <= 1.25 2^-20, degree 10, 60.6 bits */
    {0x1.cfab68ec3ac1dp+7, 0x1.4c05eab2544ep-50, -0x1.2185d0efc3a33p+6, 0x1.3c5a0ccb7d2fap+5, -0x1.8b0d7a7e60d42p+4,
     0x1.0615563f6cdbap+4, -0x1.68034364fff24p+3, 0x1.f9c614a1afb8cp+2, -0x1.68ea06ffec987p+2, 0x1.048ff65daac42p+2,
     -0x1.7c1e4ec8b9afep+1, 0x1.16e187dae8678p+1}, /* [84] 1.25 <= y <= 1.3125 2^-20, degree 10, 61.1 bits */
    {0x1.c6eb5a36c3912p+7, 0x1.ae5034b97bb3ap-47, -0x1.0ed8eea713c54p+6, 0x1.1a2e454a553a7p+5, -0x1.4ffda7f7b6f42p+4,
     0x1.a9111e93b9339p+3, -0x1.165e808b0084fp+3, 0x1.74e28eb931bfbp+2, -0x1.fb6ba3d441a37p+1, 0x1.5d4b42fb3a099p+1,
     -0x1.e5cdf16aa1a89p+0, 0x1.53d769d3faf37p+0}, /* [85] 1.3125 <= y <= 1.375 2^-20, degree 10, 63.7 bits */
    {0x1.beb897dd6e762p+7, 0x1.e156e2c3c8c66p-47, -0x1.fc4acb5e00202p+5, 0x1.fa065881892efp+4, -0x1.1fdef25f004ddp+4,
     0x1.5c00de3f1e057p+3, -0x1.b38b92c3579c9p+2, 0x1.16bfb01cd78dap+2, -0x1.6a762cbc0c315p+1, 0x1.dcd698149ccf3p+0,
     -0x1.3cd3ae05e108fp+0, 0x1.a79133f71c757p-1}, /* [86] 1.375 <= y <= 1.4375 2^-20, degree 10, 61.2 bits */
    {0x1.b70482abc8f7p+7, 0x1.eef1a68e3345bp-48, -0x1.de4577f147011p+5, 0x1.c7e05ccb23c69p+4, -0x1.f09cce69f7eacp+3,
     0x1.1f669d7968f8bp+3, -0x1.58643a178ac2bp+2, 0x1.a610032dedd4p+1, -0x1.06bb044d6454cp+1, 0x1.4aedb6f17989ep+0,
     -0x1.a501fc828e51p-1, 0x1.0d72a31411b1p-1}, /* [87] 1.4375 <= y <= 1.5 2^-20, degree 10, 61.0 bits */
    {0x1.afc2898b5f9dfp+7, -0x1.597de4defbfd9p-47, -0x1.c32abf1dcfa1ap+5, 0x1.9c7cfc0ad9b6cp+4, -0x1.af01a9722def2p+3,
     0x1.de811f82212acp+2, -0x1.12fe48344aeafp+2, 0x1.4341d999c478ep+1, -0x1.82060548bc624p+0, 0x1.d2611903fe28fp-1,
     -0x1.1c8852e03663dp-1, 0x1.5d56f15f37ef4p-2}, /* [88] 1.5 <= y <= 1.5625 2^-20, degree 10, 61.9 bits */
    {0x1.a8e7cd9c28a85p+7, -0x1.25eac01aada36p-48, -0x1.aa97e12f90865p+5, 0x1.76b9de121be72p+4, -0x1.7831b0b2e3f55p+3,
     0x1.9145e55f4702ep+2, -0x1.bb218245d5acep+1, 0x1.f47a189f310d4p+0, -0x1.1f1baf59e7c5fp+0, 0x1.4d4540f546bedp-1,
     -0x1.86ac8b94bd09p-2, 0x1.ccd8a1d014a28p-3}, /* [89] 1.5625 <= y <= 1.625 2^-20, degree 10, 60.7 bits */
    {0x1.a26ad940a9137p+7, 0x1.4dd726149daf3p-48, -0x1.943a633d2246fp+5, 0x1.55ae3e76e7bafp+4, -0x1.4a1337b82a9fbp+3,
     0x1.52cb1ee0859d8p+2, -0x1.6803ff7c4c951p+1, 0x1.874312e4c295dp+0, -0x1.aff847cf7d1f7p-1, 0x1.e2808376a01ffp-2,
     -0x1.101d9c700aa99p-2, 0x1.34e12662bee53p-3}, /* [90] 1.625 <= y <= 1.6875 2^-20, degree 10, 64.9 bits */
    {0x1.9c4365a79815fp+7, 0x1.4ed011dcce2eep-47, -0x1.7fcce37f6c91cp+5, 0x1.389ddf7d226fap+4, -0x1.23043a303b5f3p+3,
     0x1.1fd75d333dd9ep+2, -0x1.26bfc8a4b866ep+1, 0x1.34aebb84e71fcp+0, -0x1.4867ec52ba528p-1, 0x1.617bedff51a8dp-2,
     -0x1.802feed1cb7b8p-3, 0x1.a43bf35f453a4p-4}, /* [91] 1.6875 <= y <= 1.75 2^-20, degree 10, 62.0 bits */
    {0x1.966a2b88b0512p+7, -0x1.4fc0096285cd6p-47, -0x1.6d14a298ce615p+5, 0x1.1eef4a9876cdep+4, -0x1.01bc9c4c537cep+3,
     0x1.ebf5b398b8405p+1, -0x1.e6171b9b72274p+0, 0x1.eb34e86178b6ep-1, -0x1.f841860e0a6a3p-2, 0x1.05dbf0763531ap-2,
     -0x1.129a953fddbd8p-3, 0x1.21d45c93a5f55p-4}, /* [92] 1.75 <= y <= 1.8125 2^-20, degree 10, 60.8 bits */
    {0x1.90d8bc9ff3b6bp+7, -0x1.4ce5028725b2p-49, -0x1.5bdf94bb15cbfp+5, 0x1.082473a8508d9p+4, -0x1.ca71141d6ac7bp+2,
     0x1.a6b2af0640bd8p+1, -0x1.937f3d0936e4fp+0, 0x1.89ec181f000dp-1, -0x1.86add678b80fep-2, 0x1.8800d4b83c7dbp-3,
     -0x1.8d21041b7869bp-4, 0x1.94f088d8277afp-5}, /* [93] 1.8125 <= y <= 1.875 2^-20, degree 10, 62.3 bits */
    {0x1.8b89640ccb45p+7, -0x1.288c061a10e0ep-47, -0x1.4c02d9eeff55cp+5, 0x1.e7aa356fa3d06p+3, -0x1.99511d1fda6e8p+2,
     0x1.6d07859643a89p+1, -0x1.5106022bd2663p+0, 0x1.3e3d02e8b2ee9p-1, -0x1.314525d7f3262p-2, 0x1.2843142971351p-3,
     -0x1.22488bd58fdd7p-4, 0x1.1e49acb8b2e1dp-5}, /* [94] 1.875 <= y <= 1.9375 2^-20, degree 10, 61.9 bits */
    {0x1.86770c2b0a02cp+7, -0x1.483ea08aed379p-50, -0x1.3d59856c0f378p+5, 0x1.c354efd56e337p+3, -0x1.6ecb7eb6ad8ddp+2,
     0x1.3cb94d61066f4p+1, -0x1.1b2406bdd753ep+0, 0x1.02df0f761c08cp-1, -0x1.e0e0cdd64a97p-3, 0x1.c3df63d4c4797p-4,
     -0x1.acae99ac56429p-5, 0x1.995c12aa32747p-6}, /* [95] 1.9375 <= y <= 2 2^-20, degree 10, 61.0 bits */
    {0x1.7f441810c4c1p+7, 0x1.6256b57dc24c8p-47, -0x1.2957271d4664fp+6, 0x1.93a7214f86c37p+5, -0x1.39229e002f347p+5,
     0x1.021949d3fd1d5p+5, -0x1.b87cf15402a82p+4, 0x1.806cf6ddc0175p+4, -0x1.54d2cd9ebfc39p+4, 0x1.31b54ac024e76p+4,
     -0x1.153f35a6e86d1p+4, 0x1.f970bc2cd8f3p+3}, /* [96] 1 <= y <= 1.0625 2^-19, degree 10, 63.2 bits */
    {0x1.7659a15897255p+7, 0x1.82f141be095b2p-50, -0x1.11d42a8e8e2a1p+6, 0x1.5e7e077b3a517p+5, -0x1.005bd78d52c16p+5,
     0x1.8e742fc7a9c7fp+4, -0x1.40958cae2fb8dp+4, 0x1.07cb75a639c5ap+4, -0x1.b905622aa048ap+3, 0x1.74fa44f5ebfcbp+3,
     -0x1.3eda3a3d5827bp+3, 0x1.12093f6b72cdfp+3}, /* [97] 1.0625 <= y <= 1.125 2^-19, degree 10, 62.4 bits */
    {0x1.6e1ecd8354b7bp+7, -0x1.4719945894461p-50, -0x1.faaacc05ebccfp+5, 0x1.32bb302f56eddp+5, -0x1.a87285fb81fc7p+4,
     0x1.38068218e798dp+4, -0x1.daf3e12bbac96p+3, 0x1.71b14b7116a1bp+3, -0x1.2453f039e9c6cp+3, 0x1.d3b971e583ae3p+2,
     -0x1.7a2a041261c56p+2, 0x1.33714396a3565p+2}, /* [98] 1.125 <= y <= 1.1875 2^-19, degree 10, 60.7 bits */
    {0x1.667da5761df4p+7, 0x1.96cf2479e11a2p-49, -0x1.d6ab41e4daebbp+5, 0x1.0e5361795c075p+5, -0x1.62e3196698547p+4,
     0x1.ef0551c23969dp+3, -0x1.656e0ce87feafp+3, 0x1.07f2aeffbb4b9p+3, -0x1.8c04a374ef7c9p+2, 0x1.2c914477419c8p+2,
     -0x1.cd0793daa643cp+1, 0x1.6396db0ccb8b7p+1}, /* [99] 1.1875 <= y <= 1.25 2^-19, degree 10, 60.8 bits */
    {0x1.5f63e51b5f40bp+7, 0x1.7e6671837eaebp-48, -0x1.b6d7e15a2db83p+5, 0x1.df80cd292b751p+4, -0x1.2b6531953f462p+4,
     0x1.8d3ed203a3ee7p+3, -0x1.10d6e043b8959p+3, 0x1.7f4e3fe81f63cp+2, -0x1.1185b59d37d08p+2, 0x1.8af0773402d2cp+1,
     -0x1.2013879af2161p+1, 0x1.a6b47fa5be1bap+0}, /* [100] 1.25 <= y <= 1.3125 2^-19, degree 10, 61.7 bits */
    {0x1.58c236b3c65adp+7, 0x1.407279b67ba9bp-47, -0x1.9a895c5d5f7a3p+5, 0x1.abb595ec75adap+4, -0x1.fd44f1bbf0d19p+3,
     0x1.42243de89a5a6p+3, -0x1.a5ee0d3a1fa7cp+2, 0x1.1a98392479daep+2, -0x1.808db5b95edc9p+1, 0x1.08b73e5b9eb1cp+1,
     -0x1.702be72601d74p+0, 0x1.018d50eeae117p+0}, /* [101] 1.3125 <= y <= 1.375 2^-19, degree 10, 63.3 bits */
    {0x1.528b9e07e21cdp+7, -0x1.b56ee2a39534p-47, -0x1.8138cf86070dp+5, 0x1.7f7f86db8e2p+4, -0x1.b45534c9fba14p+3,
     0x1.07bcfb3492597p+3, -0x1.4a151e017773ep+2, 0x1.a6815168445bdp+1, -0x1.12b1f2042f28cp+1, 0x1.696060113414p+0,
     -0x1.e03872c07be29p-1, 0x1.41011e3fb03cdp-1}, /* [102] 1.375 <= y <= 1.4375 2^-19, degree 10, 60.4 bits */
    {0x1.4cb506428ddb6p+7, 0x1.bd05c54a418d2p-47, -0x1.6a78600926091p+5, 0x1.597e1b072ce62p+4, -0x1.785d25ecd3449p+3,
     0x1.b39eaefd5e0ecp+2, -0x1.050030590cc8ep+2, 0x1.3fdd4899b9b1bp+1, -0x1.8e39d25485d2cp+0, 0x1.f59847f6f5e36p-1,
     -0x1.3f1092fbfafc7p-1, 0x1.986837cdec511p-2}, /* [103] 1.4375 <= y <= 1.5 2^-19, degree 10, 62.4 bits */
    {0x1.4734e947e92c2p+7, 0x1.210d5d7a9e376p-48, -0x1.55edc333f7d3ep+5, 0x1.389c3e2d9db49p+4, -0x1.46a4c28ace326p+3,
     0x1.6aa3d2bb491ccp+2, -0x1.a0d02c46234e6p+1, 0x1.e9f7b41ea9183p+0, -0x1.248d40631a6ffp+0, 0x1.617338d98c969p-1,
     -0x1.af4579698ba14p-2, 0x1.08c015d8e459p-2}, /* [104] 1.5 <= y <= 1.5625 2^-19, degree 10, 60.6 bits */
    {0x1.42030a0eb7b2cp+7, -0x1.b8daf381e4af2p-50, -0x1.434e2284f001cp+5, 0x1.1bfde5e8b08d4p+4, -0x1.1d1a78b6f7f8bp+3,
     0x1.301bfcd8b77fp+2, -0x1.4fd4dd1154588p+1, 0x1.7b4aa692667bep+0, -0x1.b32cf1b805479p-1, 0x1.f9250870c944fp-2,
     -0x1.2813786c4fca4p-2, 0x1.5d41b60052616p-3}, /* [105] 1.5625 <= y <= 1.625 2^-19, degree 10, 61.5 bits */
    {0x1.3d183d56af578p+7, -0x1.c85947f920cbep-47, -0x1.325afbcf60504p+5, 0x1.02f2aa813c28dp+4, -0x1.f44d9a5cf0f5ap+2,
     0x1.00c22ccec0369p+2, -0x1.10d77b60b8ea3p+1, 0x1.28859ff3b91d1p+0, -0x1.475f693a0ef87p-1, 0x1.6dab3ce7cbde2p-2,
     -0x1.9c7373c55b298p-3, 0x1.d42cae9ee4384p-4}, /* [106] 1.625 <= y <= 1.6875 2^-19, degree 10, 64.4 bits */
    {0x1.386e3d5a0d9cdp+7, -0x1.c139b8fd5bab3p-47, -0x1.22dfba1bfd55ap+5, 0x1.d9d7c5b6b519ap+3, -0x1.b919e719c4aa2p+2,
     0x1.b449a52c4df91p+1, -0x1.bec1f9c5c2ae2p+0, 0x1.d3e06837afa06p-1, -0x1.f1c584b0c19fp-2, 0x1.0be4348a9361ap-2,
     -0x1.2328f80c1fa0cp-3, 0x1.3e7a7f25e6866p-4}, /* [107] 1.6875 <= y <= 1.75 2^-19, degree 10, 60.4 bits */
    {0x1.33ff85fc18af2p+7, 0x1.84f109eddf2e2p-48, -0x1.14afd7a911d3fp+5, 0x1.b2ea8274e9bcfp+3, -0x1.86a88572b37ccp+2,
     0x1.74d6643f33ed6p+1, -0x1.70638b682ebacp+0, 0x1.74442201eb873p-1, -0x1.7e27cfe4014fap-2, 0x1.8ce7b560caad4p-3,
     -0x1.a038efc30aac6p-4, 0x1.b74cdaa16c2dfp-5}, /* [108] 1.75 <= y <= 1.8125 2^-19, degree 10, 66.2 bits */
    {0x1.2fc737980ecfap+7, -0x1.6cc18f201efbcp-48, -0x1.07a566e332e91p+5, 0x1.905e7dbb8117dp+3, -0x1.5b6fa1b919db8p+2,
     0x1.4058be8530f2ap+1, -0x1.31cb709dda4bep+0, 0x1.2a89c3e2b06e6p-1, -0x1.2814836107b4ap-2, 0x1.291565d9d9a0ep-3,
     -0x1.2cf7d4c1f8595p-4, 0x1.32e32b8be29d9p-5}, /* [109] 1.8125 <= y <= 1.875 2^-19, degree 10, 61.5 bits */
    {0x1.2bc0ff08d7fcap+7, -0x1.b11315f84e9afp-48, -0x1.f73fd30d3dafdp+4, 0x1.7195b4045605ep+3, -0x1.3634c9a37f6b8p+2,
     0x1.14a45165338dep+1, -0x1.fed580acff97cp-1, 0x1.e25c518945e9ap-2, -0x1.ceb446dc78074p-3, 0x1.c10ce1b569d73p-4,
     -0x1.b7fcfe53c55e7p-5, 0x1.b1ee957eb4669p-6}, /* [110] 1.875 <= y <= 1.9375 2^-19, degree 10, 62.0 bits */
    {0x1.27e901d7270c3p+7, 0x1.942a1a481ea2ap-47, -0x1.e106c757ee34fp+4, 0x1.560c9c3ca8fa6p+3, -0x1.15fafdbc31dbfp+2,
     0x1.e010e1433b961p+0, -0x1.ad29ab2e29243p-1, 0x1.886078343d128p-2, -0x1.6c70410f1795bp-3, 0x1.5674cbef241c2p-4,
     -0x1.44e184aad7743p-5, 0x1.363cb9fc91d99p-6}, /* [111] 1.9375 <= y <= 2 2^-19, degree 10, 61.3 bits */
    {0x1.22744468e4c29p+7, 0x1.fde7c649835cdp-49, -0x1.c2b2a236b8448p+5, 0x1.31ea4652eb6fbp+5, -0x1.daa0aa01c75e4p+4,
     0x1.8734e4da4925cp+4, -0x1.4dd431be7344fp+4, 0x1.2357551927ef4p+4, -0x1.024bef70e7786p+4, 0x1.cf5e3cbe8d3a1p+3,
     -0x1.a43a8b1c96d2bp+3, 0x1.7f0d8e283ea39p+3}, /* [112] 1 <= y <= 1.0625 2^-18, degree 10, 64.0 bits */
    {0x1.1bb26d9dc08c5p+7, 0x1.c60a85b10eb73p-49, -0x1.9f0f7312744e6p+5, 0x1.09a06e1e4020ep+5, -0x1.8491f2af025bp+4,
     0x1.2df9236892179p+4, -0x1.e5eab6145c9f1p+3, 0x1.8fd6eae058109p+3, -0x1.4e3b8297d0f06p+3, 0x1.1aaa38e8cc93p+3,
     -0x1.e34a850b853ebp+2, 0x1.9f5caafdd6a3dp+2}, /* [113] 1.0625 <= y <= 1.125 2^-18, degree 10, 61.3 bits */
    {0x1.1575b2ba129cfp+7, -0x1.b13eec1579418p-47, -0x1.7ffebd271677ep+5, 0x1.d0ec66230ce57p+4, -0x1.41ac6838aeca5p+4,
     0x1.d8f1df0e551ffp+3, -0x1.67f2cc924d9fdp+3, 0x1.182cf56b2f75ep+3, -0x1.bb166fbc0feffp+2, 0x1.6278451b13eb1p+2,
     -0x1.1e9874cdce7eep+2, 0x1.d1ff245b95f9fp+1}, /* [114] 1.125 <= y <= 1.1875 2^-18, degree 10, 62.8 bits */
    {0x1.0fad6e3145275p+7, -0x1.2db4f15b5c8dbp-47, -0x1.64b6935d4f61cp+5, 0x1.99be195d6bcb2p+4, -0x1.0cf4d2f983076p+4,
     0x1.772868f7f9a69p+3, -0x1.0ee1eaa4e400fp+3, 0x1.90126896d5e0dp+2, -0x1.2c206a8613a6ap+2, 0x1.c7938fb2fcaf2p+1,
     -0x1.5d65619239c2p+1, 0x1.0d7ca6d0819e7p+1}, /* [115] 1.1875 <= y <= 1.25 2^-18, degree 10, 62.5 bits */
    {0x1.0a4bc82ceb973p+7, 0x1.d90909c30433ep-48, -0x1.4c97ef5001e1cp+5, 0x1.6b668418923f5p+4, -0x1.c5cd63baca2d4p+3,
     0x1.2d0ebf2e8b4d1p+3, -0x1.9d8c981e26a17p+2, 0x1.227e192936163p+2, -0x1.9e9570b8fcf26p+1, 0x1.2b4f180d62969p+1,
     -0x1.b4a4a913233efp+0, 0x1.4059f130b94a9p+0}, /* [116] 1.25 <= y <= 1.3125 2^-18, degree 10, 60.3 bits */
    {0x1.0545217da1529p+7, -0x1.23993cfb71368p-47, -0x1.372405b3c372ep+5, 0x1.4425d236c3dfp+4, -0x1.81f51a97974ep+3,
     0x1.e8474d42cd123p+2, -0x1.3fc3c5021c538p+2, 0x1.ac55cf963ceb1p+1, -0x1.23702c1f540ddp+1, 0x1.913c441a9e296p+0,
     -0x1.1705ca7d211fdp+0, 0x1.86607a9efe9b7p-1}, /* [117] 1.3125 <= y <= 1.375 2^-18, degree 10, 60.1 bits */
    {0x1.008fa2d4c2898p+7, 0x1.84cd30bb3a6fp-48, -0x1.23f49c73bdf97p+5, 0x1.22a441ff27306p+4, -0x1.4aae7a44bb068p+3,
     0x1.8fc14ee571b33p+2, -0x1.f45070199f8ecp+1, 0x1.403351d6ef22cp+1, -0x1.a05c8c5de0fedp+0, 0x1.11df81a3d2b35p+0,
     -0x1.6bf0af7222374p-1, 0x1.e68d8e7daa727p-2}, /* [118] 1.375 <= y <= 1.4375 2^-18, degree 10, 61.1 bits */
    {0x1.f845cc84fcb92p+6, 0x1.8df8a4e4d47c3p-49, -0x1.12b67253f4a1cp+5, 0x1.05d6aa35e9591p+4, -0x1.1d3bb642eccfap+3,
     0x1.4a23f5eed31abp+2, -0x1.8b9af9dc9f46p+1, 0x1.e4d37658ca384p+0, -0x1.2dcccb93949b9p+0, 0x1.7c239f068bf7ep-1,
     -0x1.e39cfc80acf2bp-2, 0x1.3583fcdd536bep-2}, /* [119] 1.4375 <= y <= 1.5 2^-18, degree 10, 60.0 bits */
    {0x1.efef68093aa07p+6, 0x1.eca859a02a01p-49, -0x1.0325198ab985fp+5, 0x1.d9d61bebd0421p+3, -0x1.ef1aa7a624449p+2,
     0x1.12d4eb338421fp+2, -0x1.3be31d97f6073p+1, 0x1.7353eb1201907p+0, -0x1.bb6d6a4736bf5p-1, 0x1.0bddb5a60876cp-1,
     -0x1.46d7f9961eb44p-2, 0x1.9149a2e23522ep-3}, /* [120] 1.5 <= y <= 1.5625 2^-18, degree 10, 60.6 bits */
    {0x1.e80f9b7aafb2ap+6, 0x1.a6b5b00021353p-48, -0x1.ea0fb51cb6ecp+4, 0x1.ae75551571818p+3, -0x1.b023f75ab71a7p+2,
     0x1.ccf27448320aap+1, -0x1.fd074951cb927p+0, 0x1.1f7363681c7eep+0, -0x1.49cd865cf759bp-1, 0x1.7ed45b0c2db5cp-2,
     -0x1.c0c4d65af9121p-3, 0x1.08b0189283348p-3}, /* [121] 1.5625 <= y <= 1.625 2^-18, degree 10, 60.9 bits */
    {0x1.e09b89198fff9p+6, -0x1.9337b21bee094p-48, -0x1.d05eabcc19c7ep+4, 0x1.887f9e2c086e2p+3, -0x1.7b29ba7cc4764p+2,
     0x1.852d1bb5d6c53p+1, -0x1.9d8da71eb5f2cp+0, 0x1.c17213ec8c782p-1, -0x1.f034d9b48160fp-2, 0x1.15205491ed166p-2,
     -0x1.38949acda1cap-3, 0x1.62cfa24b19b2ap-4}, /* [122] 1.625 <= y <= 1.6875 2^-18, degree 10, 64.0 bits */
    {0x1.d989aef9d4fd2p+6, 0x1.e86c4ee6ce62bp-48, -0x1.b8e763f877cc1p+4, 0x1.671cbb3198942p+3, -0x1.4e4bc335972bfp+2,
     0x1.4aa59eaa32ee9p+1, -0x1.5294cc7395278p+0, 0x1.6296089a5cbf2p-1, -0x1.793df6b223bd2p-2, 0x1.960c933c0af7fp-3,
     -0x1.b95153ac32845p-4, 0x1.e2b986f6428a1p-5}, /* [123] 1.6875 <= y <= 1.75 2^-18, degree 10, 62.3 bits */
    {0x1.d2d1b0b8cc3a3p+6, 0x1.614fad3d8649dp-48, -0x1.a36661b94a977p+4, 0x1.499c63506c5a1p+3, -0x1.28112ae41fa7ap+2,
     0x1.1a8f7433b2117p+1, -0x1.17303c4415f78p+0, 0x1.1a20662883559p-1, -0x1.219f011ae0496p-2, 0x1.2ccc9109313f8p-3,
     -0x1.3b7053bf162f3p-4, 0x1.4cedad441fa12p-5}, /* [124] 1.75 <= y <= 1.8125 2^-18, degree 10, 61.1 bits */
    {0x1.cc6c2b3df8845p+6, -0x1.3b1fbc6a5a243p-49, -0x1.8fa227f80a376p+4, 0x1.2f6dcbd042eb5p+3, -0x1.074f7a14ec5ccp+2,
     0x1.e58f1a8cf6775p+0, -0x1.cf8054fce1621p-1, 0x1.c480779a72294p-2, -0x1.c0c6994cd8516p-3, 0x1.c24be4ebb9b5dp-4,
     -0x1.c82f1fca1bd2p-5, 0x1.d127e99801d05p-6}, /* [125] 1.8125 <= y <= 1.875 2^-18, degree 10, 62.4 bits */
    {0x1.c65290661b95dp+6, 0x1.da1fe2f63af3ap-48, -0x1.7d697677298e3p+4, 0x1.181933f5b01b2p+3, -0x1.d630c448725a1p+1,
     0x1.a350803dd424dp+0, -0x1.83247e2d8d3d7p-1, 0x1.6d902bb5dfce5p-2, -0x1.5eaa7f3258b99p-3, 0x1.545169fba2bb4p-4,
     -0x1.4d7337c426b4cp-5, 0x1.48dc308e8f5b5p-6}, /* [126] 1.875 <= y <= 1.9375 2^-18, degree 10, 63.7 bits */
    {0x1.c07f08f89bep+6, -0x1.dee9b646a3145p-55, -0x1.6c91e2ab4d09fp+4, 0x1.033aec27c07dfp+3, -0x1.a5584c7455bfap+1,
     0x1.6bd34970bfde1p+0, -0x1.453f38d6c938ep-1, 0x1.295e2be77cf61p-2, -0x1.1431b5da2efc4p-3, 0x1.0388d44d4d184p-4,
     -0x1.ec6deecff9928p-6, 0x1.d63bc16c3964p-7}, /* [127] 1.9375 <= y <= 2 2^-18, degree 10, 61.0 bits */
    {0x1.b839dad56bbc5p+6, 0x1.96ce0da241f1ap-48, -0x1.5595a412d03fdp+5, 0x1.cfb0c692ab773p+4, -0x1.67b48a3a33debp+4,
     0x1.287b6843d4797p+4, -0x1.f9fe6e42bfc31p+3, 0x1.b997ea7eeadbbp+3, -0x1.8781b190f48b2p+3, 0x1.5f2b46d5a155p+3,
     -0x1.3e79a37d14f2ap+3, 0x1.224d0c65d133bp+3}, /* [128] 1 <= y <= 1.0625 2^-17, degree 10, 63.6 bits */
    {0x1.adfbc1737bb68p+6, 0x1.885c720b1fe0fp-48, -0x1.3a9368a79e7f9p+5, 0x1.929fb283ac4c3p+4, -0x1.267c3667e086ap+4,
     0x1.c9b5e1bedf05bp+3, -0x1.704254461dfb1p+3, 0x1.2f0613d593dcap+3, -0x1.fa9ac7bd2d62ep+2, 0x1.ac712ccc0b3b3p+2,
     -0x1.6e448f3524f33p+2, 0x1.3ac96bcf939d8p+2}, /* [129] 1.0625 <= y <= 1.125 2^-17, degree 10, 59.8 bits */
    {0x1.a4876aa43d311p+6, 0x1.b0012e11ae758p-48, -0x1.23083dff3fb43p+5, 0x1.605abaa43e44cp+4, -0x1.e792af9588c08p+3,
     0x1.666dd3cf1390ap+3, -0x1.10cad00df08fp+3, 0x1.a8ab7b1841125p+2, -0x1.4fccb8257fdccp+2, 0x1.0ca3a9d724bd1p+2,
     -0x1.b266500bb13e6p+1, 0x1.612932e572806p+1}, /* [130] 1.125 <= y <= 1.1875 2^-17, degree 10, 61.9 bits */
    {0x1.9bc39b02fcd88p+6, 0x1.d20e4da7f247dp-51, -0x1.0e5b1ba6d9314p+5, 0x1.3688d58247e9bp+4, -0x1.97aafb20bd231p+3,
     0x1.1c51d85ddab1ep+3, -0x1.9a95b2dae6b9bp+2, 0x1.2f3337e1a555ep+2, -0x1.c6e8e9040e136p+1, 0x1.5943a8807890fp+1,
     -0x1.08cb42c804f5ep+1, 0x1.9877b65ccd7bcp+0}, /* [131] 1.1875 <= y <= 1.25 2^-17, degree 10, 60.9 bits */
    {0x1.939b5706efc35p+6, 0x1.3bdacd877711p-48, -0x1.f826f922f3117p+4, 0x1.1369c6ec800e3p+4, -0x1.57ec642a2b8bbp+3,
     0x1.c852cb23bb3c4p+2, -0x1.396a253c1863ap+2, 0x1.b84eceb422126p+1, -0x1.3a32a52454064p+1, 0x1.c5ab92d8fdfcap+0,
     -0x1.4aea5770431b5p+0, 0x1.e59069c906efcp-1}, /* [132] 1.25 <= y <= 1.3125 2^-17, degree 10, 60.8 bits */
    {0x1.8bfd011445748p+6, 0x1.e8c3a5f7bb00bp-48, -0x1.d7a291d55ccecp+4, 0x1.eb545431b6c6fp+3, -0x1.24818858086e8p+3,
     0x1.720cee12b807ap+2, -0x1.e4ad6d6b7494cp+1, 0x1.449eba1052d7bp+1, -0x1.b9bda2210347p+0, 0x1.3014d9876c35ap+0,
     -0x1.a6ebe86b0637ep-1, 0x1.27da0f9db8eb2p-1}, /* [133] 1.3125 <= y <= 1.375 2^-17, degree 10, 61.0 bits */
    {0x1.84d9ae8c98c6bp+6, -0x1.22b4236233134p-48, -0x1.ba8e0e7d0b901p+4, 0x1.b88af31c66575p+3, -0x1.f53a7491d1915p+2,
     0x1.2ef62da474331p+2, -0x1.7b2bd085af072p+1, 0x1.e556580a74dd9p+0, -0x1.3b8b9a5a3ed74p+0, 0x1.9f1dd9aa2f6ecp-1,
     -0x1.13d10fb671beep-1, 0x1.70bd75d34205dp-2}, /* [134] 1.375 <= y <= 1.4375 2^-17, degree 10, 61.4 bits */
    {0x1.7e24a4afaa191p+6, -0x1.40935f88f9eb2p-49, -0x1.a06b3ddf0f302p+4, 0x1.8ce278cdb20a7p+3, -0x1.b05737523829p+2,
     0x1.f467f685d867dp+1, -0x1.2bd0e5a8a6c8ap+1, 0x1.6f6ec37eb86fcp+0, -0x1.c9725afce0f84p-1, 0x1.2017f08df40a8p-1,
     -0x1.6e83308b7b838p-2, 0x1.d523f0c6feaadp-3}, /* [135] 1.4375 <= y <= 1.5 2^-17, degree 10, 63.7 bits */
    {0x1.77d2f2c2ee38ap+6, 0x1.d42803b98921ap-51, -0x1.88d267a1b671ap+4, 0x1.671c9c34d4e48p+3, -0x1.7739d4c4dc56p+2,
     0x1.a092a2bbbbfd3p+1, -0x1.deccfbb4e6c92p+0, 0x1.196a9bdc20a4fp+0, -0x1.500eca8f50dd6p-1, 0x1.96030671ddaf4p-2,
     -0x1.ef67c7428a779p-3, 0x1.301ef00d49022p-3}, /* [136] 1.5 <= y <= 1.5625 2^-17, degree 10, 61.5 bits */
    {0x1.71db220f383b4p+6, -0x1.822994411971ep-50, -0x1.736d93f6ee845p+4, 0x1.463c999c24fa5p+3, -0x1.4781f9d1b8bc6p+2,
     0x1.5d566e8cec268p+1, -0x1.81c69f11c41c3p+0, 0x1.b3b2aff2d407bp-1, -0x1.f3e4468a0a60cp-2, 0x1.2221f1d53e36ap-2,
     -0x1.541afb2054a15p-3, 0x1.9131b0f0c59fdp-4}, /* [137] 1.5625 <= y <= 1.625 2^-17, degree 10, 64.6 bits */
    {0x1.6c34f65e213fbp+6, 0x1.748a2781222a8p-48, -0x1.5ff4f4cc8e662p+4, 0x1.2977cd3afb963p+3, -0x1.1f5b91fd99a44p+2,
     0x1.26f1e0766349p+1, -0x1.396b25ae94fcp+0, 0x1.549e942865996p-1, -0x1.780eae7e42cfap-2, 0x1.a40c4b6a38272p-3,
     -0x1.d9c95b91e8b21p-4, 0x1.0ce5eaa93b905p-4}, /* [138] 1.625 <= y <= 1.6875 2^-17, degree 10, 62.7 bits */
    {0x1.66d93b14cb296p+6, -0x1.d1b6e0592c6cep-49, -0x1.4e2c233286c96p+4, 0x1.102a5694d3349p+3, -0x1.fab568080549ap+1,
     0x1.f52cc1e7e2cb7p+0, -0x1.009989a0d60ecp+0, 0x1.0cba8e68950bdp-1, -0x1.1de604f627b23p-2, 0x1.33bae4b24b1bp-3,
     -0x1.4e756369f1d48p-4, 0x1.6dd6d4947acb4p-5}, /* [139] 1.6875 <= y <= 1.75 2^-17, degree 10, 61.9 bits */
    {0x1.61c19a0eb4756p+6, -0x1.ab6f409a290fp-51, -0x1.3ddffa451d0f6p+4, 0x1.f39d37fa2be9ep+2, -0x1.c0c377f095a3ep+1,
     0x1.ac49cd4d8db67p+0, -0x1.a72d070fd56b2p-1, 0x1.aba0dfbdbd38dp-2, -0x1.b6fccc08baf4ap-3, 0x1.c7ee05da97ed6p-4,
     -0x1.de1e813487dbbp-5, 0x1.f8a0db4f149ffp-6}, /* [140] 1.75 <= y <= 1.8125 2^-17, degree 10, 60.4 bits */
    {0x1.5ce87a1543974p+6, 0x1.3e19e98fbaa8cp-50, -0x1.2ee4e85fce734p+4, 0x1.cbedc38fdf73cp+2, -0x1.8f1cee776d22ap+1,
     0x1.6ffdb19a1fe17p+0, -0x1.5f45dcefb4b82p-1, 0x1.56ef9d3c65493p-2, -0x1.541c92e5dcd26p-3, 0x1.554381a3210e8p-4,
     -0x1.59b9b40f02221p-5, 0x1.60864ab86e77cp-6}, /* [141] 1.8125 <= y <= 1.875 2^-17, degree 10, 60.6 bits */
    {0x1.5848e356e0cbfp+6, -0x1.39ef851d1b5d3p-48, -0x1.21159a186dbdcp+4, 0x1.a890cc66bf4d5p+2, -0x1.645895d8c8d08p+1,
     0x1.3dc94e1e56f02p+0, -0x1.256735194c374p-1, 0x1.150c55efba0c6p-2, -0x1.09c1f8444aefdp-3, 0x1.01ea3e1170294p-4,
     -0x1.f96b6a8b5d83fp-6, 0x1.f2764cb066e5bp-7}, /* [142] 1.875 <= y <= 1.9375 2^-17, degree 10, 60.5 bits */
    {0x1.53de68a27fe33p+6, 0x1.7dfad5f6f35c7p-50, -0x1.1451ea0eca51cp+4, 0x1.88ef39811ff65p+2, -0x1.3f53ce8c80cb4p+1,
     0x1.13bb9e4f16e96p+0, -0x1.ecfd339cb8a45p-2, 0x1.c2bb08c2b7f66p-3, -0x1.a2a2e125f6394p-4, 0x1.8962574e33402p-5,
     -0x1.7531d1e1ab0f8p-6, 0x1.645f6eb6328c8p-7}, /* [143] 1.9375 <= y <= 2 2^-17, degree 10, 62.0 bits */
    {0x1.4d99b8dc09db2p+6, -0x1.068fd70b86154p-49, -0x1.02e6511e650c6p+5, 0x1.5f6cfb523fb15p+4, -0x1.109cc595897bfp+4,
     0x1.c164182c459e5p+3, -0x1.7f7a2ab6494adp+3, 0x1.4eab557080868p+3, -0x1.28b5a88086cccp+3, 0x1.0a23878cdebd1p+3,
     -0x1.e2b8d2830b925p+2, 0x1.b80467201c544p+2}, /* [144] 1 <= y <= 1.0625 2^-16, degree 10, 61.4 bits */
    {0x1.45d6547407187p+6, 0x1.126063ceb58c4p-48, -0x1.dcdc306176978p+4, 0x1.312505401b8cep+4, -0x1.be5e2b1025176p+3,
     0x1.5ae2e94cd7d51p+3, -0x1.1717ad09572fp+3, 0x1.cb4dcfe0ec55ep+2, -0x1.7ff04e3439861p+2, 0x1.44b3952a461b8p+2,
     -0x1.1594da9c731bfp+2, 0x1.dd21990f068f4p+1}, /* [145] 1.0625 <= y <= 1.125 2^-16, degree 10, 60.6 bits */
    {0x1.3eabd980f1251p+6, 0x1.8f736f668b157p-49, -0x1.b92c51c2616cdp+4, 0x1.0b0be74434066p+4, -0x1.71857dc8537a3p+3,
     0x1.0fa4d76fc0625p+3, -0x1.9d7b7d0b1ad5fp+2, 0x1.41d8081c96656p+2, -0x1.fcfba5779b0b1p+1, 0x1.972f6641f2e17p+1,
     -0x1.493761a38d2e6p+1, 0x1.0ba5ea44239b9p+1}, /* [146] 1.125 <= y <= 1.1875 2^-16, degree 10, 61.8 bits */
    {0x1.3807289307ac6p+6, -0x1.942ae17f2b575p-51, -0x1.99d510cefc4ebp+4, 0x1.d6b43eae7c008p+3, -0x1.34f6a4cc23f34p+3,
     0x1.aef50fa42f96dp+2, -0x1.372b9a41c4ba9p+2, 0x1.cb9263968c7b3p+1, -0x1.58c2e5e975444p+1, 0x1.05aa06df4a837p+1,
     -0x1.915b3de19e136p+0, 0x1.35902e356a4bdp+0}, /* [147] 1.1875 <= y <= 1.25 2^-16, degree 10, 62.2 bits */
    {0x1.31d85ab03551cp+6, -0x1.56af7daf43b3fp-48, -0x1.7e1fc0141696ap+4, 0x1.a177f259428e9p+3, -0x1.04a732314fa1cp+3,
     0x1.59d6103dc3ae7p+2, -0x1.db0e6010d822ep+1, 0x1.4db2238c33601p+1, -0x1.dc3da99de58edp+0, 0x1.57d24fc536dep+0,
     -0x1.f5943252a6844p-1, 0x1.6ffdf7a888649p-1}, /* [148] 1.25 <= y <= 1.3125 2^-16, degree 10, 65.6 bits */
    {0x1.2c121619a136p+6, -0x1.0675e9ac824f6p-50, -0x1.657ab8638d65p+4, 0x1.74607a8c60894p+3, -0x1.bb5ec6690de0cp+2,
     0x1.1873ce6eb971ap+2, -0x1.6f52d7f506a61p+1, 0x1.ec0a1d87ce334p+0, -0x1.4ec80372cace5p+0, 0x1.cce8177a45e79p-1,
     -0x1.4084935b0b9f5p-1, 0x1.c06e80317de18p-2}, /* [149] 1.3125 <= y <= 1.375 2^-16, degree 10, 61.5 bits */
    {0x1.26a90cbf91885p+6, -0x1.37006e5b99159p-48, -0x1.4f708b29d3461p+4, 0x1.4de2f50e21674p+3, -0x1.7bdf61e847169p+2,
     0x1.cb3710fdca74dp+1, -0x1.1f5d1058a2716p+1, 0x1.6fd2a106f727dp+0, -0x1.de48aa19b383ap-1, 0x1.3a9a74d2085c9p-1,
     -0x1.a210790879ccp-2, 0x1.17749721e07bdp-2}, /* [150] 1.375 <= y <= 1.4375 2^-16, degree 10, 61.5 bits */
    {0x1.219398e1b9f47p+6, -0x1.8eb33ecb04615p-51, -0x1.3ba19508ff848p+4, 0x1.2ccc7c68e759bp+3, -0x1.47aa0a373bd27p+2,
     0x1.7b3f192955ee5p+1, -0x1.c671f7d74d90cp+0, 0x1.16776eb3817e9p+0, -0x1.5aaf4a3eda91fp-1, 0x1.b4ac70101dbb7p-2,
     -0x1.15c481ccda4d9p-2, 0x1.638ba709bec9bp-3}, /* [151] 1.4375 <= y <= 1.5 2^-16, degree 10, 61.0 bits */
    {0x1.1cc96fdfa5533p+6, 0x1.6bf51f43296afp-50, -0x1.29bf3a96b4698p+4, 0x1.102bd84d2af02p+3, -0x1.1c60d1464e8f3p+2,
     0x1.3bb61f2b2fcc5p+1, -0x1.6adee21d31958p+0, 0x1.aa8e10c879501p-1, -0x1.fd603b4524bc7p-2, 0x1.33b4139feaebep-2,
     -0x1.777390eb5e83cp-3, 0x1.ccf7414498a6cp-4}, /* [152] 1.5 <= y <= 1.5625 2^-16, degree 10, 60.7 bits */
    {0x1.18436595b28ffp+6, 0x1.2577d7a5749ddp-48, -0x1.1988549941fdbp+4, 0x1.ee82f0ea1e81bp+2, -0x1.f06d5df853fe9p+1,
     0x1.08c16f2c900f2p+1, -0x1.245ea769c2e66p+0, 0x1.4a34090719e26p-1, -0x1.7ada57a88f51bp-2, 0x1.b7c3c4b99ac56p-3,
     -0x1.01c13a0f2430dp-3, 0x1.300d345a1d0adp-4}, /* [153] 1.5625 <= y <= 1.625 2^-16, degree 10, 60.3 bits */
    {0x1.13fb3c3b1e8bdp+6, 0x1.f1b2fae19f97ap-51, -0x1.0ac677b0767e4p+4, 0x1.c2e7931b5714bp+2, -0x1.b391c97c443dcp+1,
     0x1.bf10ba063ce13p+0, -0x1.db10756e3b832p-1, 0x1.022564bd73df2p-1, -0x1.1d00b26d55095p-2, 0x1.3e57613c820fbp-3,
     -0x1.67114a471bfc6p-4, 0x1.9793f1e517cdbp-5}, /* [154] 1.625 <= y <= 1.6875 2^-16, degree 10, 63.6 bits */
    {0x1.0feb7dcf7d971p+6, 0x1.125877b1eb0f5p-49, -0x1.fa97b9a4bca0cp+3, 0x1.9c8d31b513f9ap+2, -0x1.80074c71e557fp+1,
     0x1.7bd49e853eec1p+0, -0x1.84f1055050a79p-1, 0x1.97530d9c89eecp-2, -0x1.b1592796df2fep-3, 0x1.d270337081ccbp-4,
     -0x1.faf36e15f2957p-5, 0x1.1541ea4efd91dp-5}, /* [155] 1.6875 <= y <= 1.75 2^-16, degree 10, 61.5 bits */
    {0x1.0c0f5cebe7c89p+6, 0x1.4aaa9822e75c7p-48, -0x1.e1e38250c99c7p+3, 0x1.7aa94b7eff771p+2, -0x1.541cf19d13bfcp+1,
     0x1.4497717eccc88p+0, -0x1.40b70aa48d4cp-1, 0x1.4416926558053p-2, -0x1.4cb22b4927ed9p-3, 0x1.59890ad2af296p-4,
     -0x1.6a59f4cf373f6p-5, 0x1.7e70fdc41325ap-6}, /* [156] 1.75 <= y <= 1.8125 2^-16, degree 10, 64.1 bits */
    {0x1.08629b5906401p+6, 0x1.a77aa3d149bb3p-48, -0x1.cb2e3f2289556p+3, 0x1.5c958c7698593p+2, -0x1.2e7bdd4196ba1p+1,
     0x1.16e4c70428152p+0, -0x1.0a38bcf946eb9p-1, 0x1.03e6f71d326p-2, -0x1.01c2ccd04d654p-3, 0x1.02a22d8ecb4cep-4,
     -0x1.0603b3d39da52p-5, 0x1.0b2abfb0861bcp-6}, /* [157] 1.8125 <= y <= 1.875 2^-16, degree 10, 63.2 bits */
    {0x1.04e17530e2122p+6, 0x1.4cd96c464ceb9p-48, -0x1.b63f5c5c1698ap+3, 0x1.41c863f6f8f63p+2, -0x1.0e124efbfd1aep+1,
     0x1.e1b07d5cdca29p-1, -0x1.bcba30c43da8p-2, 0x1.a3ef76014caddp-3, -0x1.92d21581245e9p-4, 0x1.86eea90c1caa2p-5,
     -0x1.7f0ab6f511d66p-6, 0x1.79c4ba8778133p-7}, /* [158] 1.875 <= y <= 1.9375 2^-16, degree 10, 61.9 bits */
    {0x1.01888f9da30a1p+6, -0x1.68f353f4a5959p-51, -0x1.a2e620326988fp+3, 0x1.29cf4e8f2e6p+2, -0x1.e4080aa68def9p+0,
     0x1.a1f2570217eb5p-1, -0x1.75a02815b081bp-2, 0x1.5598ebe0cad19p-3, -0x1.3d45dac4c1f6p-4, 0x1.2a226254ccc26p-5,
     -0x1.1ad52f4fb39e4p-6, 0x1.0e1568717554dp-7}, /* [159] 1.9375 <= y <= 2 2^-16, degree 10, 61.1 bits */
    {0x1.f9906bb5f3025p+5, 0x1.ee4b57aa6d902p-49, -0x1.887e266aba6aep+4, 0x1.0a59c0db495c3p+4, -0x1.9d38ed04b14f1p+3,
     0x1.54961beb0c75bp+3, -0x1.22a11a0b119fcp+3, 0x1.fb4677f39e19ap+2, -0x1.c1bc85bc59f08p+2, 0x1.9365da012000ap+2,
     -0x1.6dd724deca479p+2, 0x1.4d79aad4886e1p+2}, /* [160] 1 <= y <= 1.0625 2^-15, degree 10, 60.9 bits */
    {0x1.edcb83566e631p+5, -0x1.91ad13ddd5115p-51, -0x1.6976dad722bfdp+4, 0x1.ce8c7f39cc69cp+3, -0x1.524cd8d82457ep+3,
     0x1.06e6747dab5f3p+3, -0x1.a70989f0251fdp+2, 0x1.5c187b83a737ap+2, -0x1.22fa22e70fe0fp+2, 0x1.ec2a0fb622c31p+1,
     -0x1.a4bdd7edceb7bp+1, 0x1.699a65572dfa9p+1}, /* [161] 1.0625 <= y <= 1.125 2^-15, degree 10, 61.0 bits */
    {0x1.e2ee650104ba3p+5, 0x1.b8fab8434dd8fp-49, -0x1.4e6a9b640c6b4p+4, 0x1.94cccaac51e37p+3, -0x1.180f3190c5538p+3,
     0x1.9bc03648f9956p+2, -0x1.395eda1c227b1p+2, 0x1.e7d61c29bee3dp+1, -0x1.81becca639d62p+1, 0x1.3498307f1edfep+1,
     -0x1.f301d0180b894p+0, 0x1.95af52e29b6ddp+0}, /* [162] 1.125 <= y <= 1.1875 2^-15, degree 10, 60.4 bits */
    {0x1.d8dc143e203c8p+5, -0x1.c13cdd50d84bcp-51, -0x1.36a99b9809fa1p+4, 0x1.64c1f31c92228p+3, -0x1.d4538cdd84da7p+2,
     0x1.469e1806e3ed8p+2, -0x1.d7a934e13b504p+1, 0x1.5c4cacd91e03ep+1, -0x1.054940a8da737p+1, 0x1.8c9dd95dd5e95p+0,
     -0x1.302d3a7a03a0fp+0, 0x1.d537b3fd5949ap-1}, /* [163] 1.1875 <= y <= 1.25 2^-15, degree 10, 59.8 bits */
    {0x1.cf7c7647f277bp+5, 0x1.b05ef7d1602edp-49, -0x1.21a9687d6cdccp+4, 0x1.3c690f3eb225ep+3, -0x1.8b193dbf5e2ep+2,
     0x1.061b121c0aa03p+2, -0x1.680984a66450dp+1, 0x1.f9cd63c587b1cp+0, -0x1.68ee804e437bcp+0, 0x1.0492cb56726e9p+0,
     -0x1.7c21fd39498d9p-1, 0x1.16e3f811c1b73p-1}, /* [164] 1.25 <= y <= 1.3125 2^-15, degree 10, 59.9 bits */
    {0x1.c6bb4e7fd5bb2p+5, 0x1.db9efab31ec3fp-49, -0x1.0efb9e87fb711p+4, 0x1.1a3c3db5d7f9cp+3, -0x1.50081963e8284p+2,
     0x1.a91ad431bcefp+1, -0x1.16638d65a07f8p+1, 0x1.74e82f58a960fp+0, -0x1.fb723581114eep-1, 0x1.5d4f3a0505d07p-1,
     -0x1.e5d2db7f6755fp-2, 0x1.53da8460c9058p-2}, /* [165] 1.3125 <= y <= 1.375 2^-15, degree 10, 61.0 bits */
    {0x1.be877a1147e39p+5, -0x1.a89bdc1755c5dp-50, -0x1.fc8e7b2736d49p+3, 0x1.fa206fb52ed4dp+2, -0x1.1fe844b09dfb1p+2,
     0x1.5c0926b6abb79p+1, -0x1.b393ced559296p+0, 0x1.16c41284eb6cp+0, -0x1.6a7b10cd69268p-1, 0x1.dcdc3c7369ee2p-2,
     -0x1.3cd7055062ee5p-2, 0x1.a7953c51f59bdp-3}, /* [166] 1.375 <= y <= 1.4375 2^-15, degree 10, 62.2 bits */
    {0x1.b6d259513fe66p+5, 0x1.71192284f6cdcp-49, -0x1.de8793c3294b4p+3, 0x1.c7f8cc2f2cbd2p+2, -0x1.f0ad87869dc43p+1,
     0x1.1f6dbaf1c076fp+1, -0x1.586b000f31d91p+0, 0x1.a616eb2e89da8p-1, -0x1.06beb3fbd7c8p-1, 0x1.4af2053043c4ep-2,
     -0x1.a50a8e3fa191ap-3, 0x1.0c9c124e7ea39p-3}, /* [167] 1.4375 <= y <= 1.5 2^-15, degree 10, 60.7 bits */
    {0x1.af8f5abf30f7ep+5, 0x1.264ab98255da2p-50, -0x1.c36b6016832b6p+3, 0x1.9c93ee6a0c697p+2, -0x1.af10bb04a6fc9p+1,
     0x1.de8d6c9bdb3cdp+0, -0x1.1303e6187b155p+0, 0x1.4347580163828p-1, -0x1.820ba6466dc2p-2, 0x1.d2670fca1d6b6p-3,
     -0x1.1c8b911dd6c62p-3, 0x1.5d5a89c088463p-4}, /* [168] 1.5 <= y <= 1.5625 2^-15, degree 10, 61.7 bits */
    {0x1.a8b39f1bb1372p+5, 0x1.55d3fc69328d2p-50, -0x1.aad71df078d9cp+3, 0x1.76cf786869fdap+2, -0x1.783f53177ce06p+1,
     0x1.91509772dbb7bp+0, -0x1.bb2ae4e9459ddp-1, 0x1.f482eaab80eeep-2, -0x1.1f2006d854553p-2, 0x1.4d49ac7e8d267p-3,
     -0x1.86b129eed015p-4, 0x1.ccdd8d2d1164p-5}, /* [169] 1.5625 <= y <= 1.625 2^-15, degree 10, 62.8 bits */
    {0x1.a235b07329af3p+5, 0x1.32ebb6222c7e3p-49, -0x1.9478503fb5d69p+3, 0x1.55c2a0eb1d8a1p+2, -0x1.4a1f9a022a735p+1,
     0x1.52d47862ebe1bp+0, -0x1.680be4ba2802cp-1, 0x1.874a36f4904cfp-2, -0x1.afff0bae25b4cp-3, 0x1.e287241d0ca4ap-4,
     -0x1.1020f16690fd4p-4, 0x1.34e490a6ce3e9p-5}, /* [170] 1.625 <= y <= 1.6875 2^-15, degree 10, 60.8 bits */
    {0x1.9c0d47a64380dp+5, 0x1.6c68f6d8b859bp-49, -0x1.8009935c0b1f5p+3, 0x1.38b126293096dp+2, -0x1.230f83f781d75p+1,
     0x1.1fdf93ed16cd4p+0, -0x1.26c677eeeba5cp-1, 0x1.34b48f1553119p-2, -0x1.486d3e18c3803p-3, 0x1.6180f3a07c727p-4,
     -0x1.8034cc76cbd57p-5, 0x1.a440c1bd759fdp-6}, /* [171] 1.6875 <= y <= 1.75 2^-15, degree 10, 60.9 bits */
    {0x1.96331d25b5119p+5, 0x1.087bccab75682p-49, -0x1.6d502642518f1p+3, 0x1.1f018e2b7bed6p+2, -0x1.01c6ef14a6264p+1,
     0x1.ec043338e78e6p-1, -0x1.e6227e97818ddp-2, 0x1.eb3e7c1e750b9p-3, -0x1.f849f608bd6c3p-4, 0x1.05dfc8555f69cp-4,
     -0x1.129e2d1213c2bp-5, 0x1.21d7c9444d7ebp-6}, /* [172] 1.75 <= y <= 1.8125 2^-15, degree 10, 61.1 bits */
    {0x1.90a0c26caa9e3p+5, 0x1.6b4ccae573dc5p-49, -0x1.5c19fbb139f13p+3, 0x1.0835c9eabacbbp+2, -0x1.ca8404c411962p+0,
     0x1.a6bf88ea659e3p-1, -0x1.9388fd763625ep-2, 0x1.89f404c8f62b8p-3, -0x1.86b4953bc05adp-4, 0x1.8806c48b92b34p-5,
     -0x1.8d2660d380ee3p-6, 0x1.94f578e25e2d1p-7}, /* [173] 1.8125 <= y <= 1.875 2^-15, degree 10, 61.2 bits */
    {0x1.8b50825f2bcd2p+5, -0x1.8b4c034ff452p-50, -0x1.4c3c32694e4eap+3, 0x1.e7cb2defcfea9p+1, -0x1.996289bc3461cp+0,
     0x1.6d12f5616bbf1p-1, -0x1.510e67316d8b2p-2, 0x1.3e439c1f3bed3p-3, -0x1.314a949a9a9a5p-4, 0x1.2847b42b9bf96p-5,
     -0x1.224c962e4e679p-6, 0x1.1e4d45fa79007p-7}, /* [174] 1.875 <= y <= 1.9375 2^-15, degree 10, 61.2 bits */
    {0x1.863d47227fbc9p+5, -0x1.a1f33f62ef57ap-50, -0x1.3d91dc7e9e719p+3, 0x1.c37456acb6b76p+1, -0x1.6edb9159a5df5p+0,
     0x1.3cc384b8da786p-1, -0x1.1b2b49a6d492cp-2, 0x1.02e4965817c48p-3, -0x1.e0e99dcab419cp-5, 0x1.c3e6a78592d75p-6,
     -0x1.acb4beba10218p-7, 0x1.99615f4ab36e3p-8}, /* [175] 1.9375 <= y <= 2 2^-15, degree 10, 61.2 bits */
    {0x1.7f09054dea2b8p+5, 0x1.7ac866d4995c5p-49, -0x1.298e12690eb28p+4, 0x1.93c466317569cp+3, -0x1.3930ec5edfbb9p+3,
     0x1.0221f859664a5p+3, -0x1.b888b987d8774p+2, 0x1.80758677c6224p+2, -0x1.54d951860433fp+2, 0x1.31ba6b4459935p+2,
     -0x1.15435ac114eccp+2, 0x1.f9778f590a87bp+1}, /* [176] 1 <= y <= 1.0625 2^-14, degree 10, 61.4 bits */
    {0x1.761cde557264cp+5, 0x1.9ac706afaedcep-49, -0x1.120955f9ec7edp+4, 0x1.5e98ce5029fd6p+3, -0x1.0068304399351p+3,
     0x1.8e8251b4a7f7fp+2, -0x1.409e97c0e5be8p+2, 0x1.07d1a7e0fd4c6p+2, -0x1.b90e46cd6fb2dp+1, 0x1.7500de43bcbf4p+1,
     -0x1.3edf41c274fd7p+1, 0x1.120d26e470b66p+1}, /* [177] 1.0625 <= y <= 1.125 2^-14, degree 10, 61.0 bits */
    {0x1.6de067a6da4c9p+5, 0x1.16021f0468c7dp-50, -0x1.fb11ed5d70bfep+3, 0x1.32d3ce2023c05p+3, -0x1.a888022d9b19ep+2,
     0x1.3812249c174bbp+2, -0x1.db01f78e5e3cp+1, 0x1.71ba6d2850a88p+1, -0x1.245a234bd6f77p+1, 0x1.d3c226057d4a4p+0,
     -0x1.7a304a50aa552p+0, 0x1.3375df23634eep+0}, /* [178] 1.125 <= y <= 1.1875 2^-14, degree 10, 60.6 bits */
    {0x1.663da912300a5p+5, -0x1.b619e8adf5feap-49, -0x1.d70f6e550c2b1p+3, 0x1.0e6a1c99d31d8p+3, -0x1.62f5ee181bce3p+2,
     0x1.ef18ac4d80c81p+1, -0x1.65792b0515b7ep+1, 0x1.07f9857be61ep+1, -0x1.8c0d72926423ep+0, 0x1.2c97226652492p+0,
     -0x1.cd0f9a207499bp-1, 0x1.639c725192f11p-1}, /* [179] 1.1875 <= y <= 1.25 2^-14, degree 10, 61.7 bits */
    {0x1.5f225d8ffa408p+5, 0x1.c5ed39564b4e5p-52, -0x1.b739517cfa894p+3, 0x1.dfaaf24f957dbp+2, -0x1.2b75ce8e1c71cp+2,
     0x1.8d4f10d35cc75p+1, -0x1.10dfc11436b0ap+1, 0x1.7f58a3959c6ffp+0, -0x1.118c13634e311p+0, 0x1.8af8885901e63p-1,
     -0x1.2018c6f085c1bp-1, 0x1.a6bb744bd0572p-2}, /* [180] 1.25 <= y <= 1.3125 2^-14, degree 10, 61.4 bits */
    {0x1.587f2e8c3c5f2p+5, -0x1.0210bf3e59805p-50, -0x1.9ae8421fefa7cp+3, 0x1.abdccbbf5e1bfp+2, -0x1.fd626eac57694p+1,
     0x1.4231fdefb567cp+1, -0x1.a5fc623e24f29p+0, 0x1.1aa0384682873p+0, -0x1.80970e143a4bdp-1, 0x1.08bce3ace76dfp-1,
     -0x1.7032e7ea3ebadp-2, 0x1.0191bdea1039p-2}, /* [181] 1.3125 <= y <= 1.375 2^-14, degree 10, 62.1 bits */
    {0x1.52471f136060bp+5, -0x1.1da85a05b4486p-49, -0x1.81955735b5a73p+3, 0x1.7fa4201740b3bp+2, -0x1.b46f84af5447ep+1,
     0x1.07c8b52c9140ep+1, -0x1.4a20cc63512cfp+0, 0x1.a68dc66663842p-1, -0x1.12b8e6ba5a0b1p-1, 0x1.6968682c0be85p-2,
     -0x1.e041f7b56a2eap-3, 0x1.4106ddf558378p-3}, /* [182] 1.375 <= y <= 1.4375 2^-14, degree 10, 61.2 bits */
    {0x1.4c6f19a8daee5p+5, -0x1.845bdde0556c4p-53, -0x1.6ad2b12c6b28p+3, 0x1.59a05e364c7e3p+2, -0x1.7874be110f173p+1,
     0x1.b3b2d2c451aeap+0, -0x1.0509cb58de791p+0, 0x1.3fe71793e563cp-1, -0x1.8e444f6ec15cep-2, 0x1.f5a3e095254ccp-3,
     -0x1.3f172754c714dp-3, 0x1.986fd3b707fc9p-4}, /* [183] 1.4375 <= y <= 1.5 2^-14, degree 10, 65.4 bits */
    {0x1.46ed979b1360fp+5, 0x1.60034696e9a4dp-49, -0x1.5646013b1029ap+3, 0x1.38bc67e05babcp+2, -0x1.46ba0357f73dep+1,
     0x1.6ab53a4592267p+0, -0x1.a0e0196510772p-1, 0x1.ea074ddf81d59p-2, -0x1.249540bbc298bp-2, 0x1.617bb52cc5eecp-3,
     -0x1.af4eb5d85f51ap-4, 0x1.08c5354e0b997p-4}, /* [184] 1.5 <= y <= 1.5625 2^-14, degree 10, 62.3 bits */
    {0x1.41ba5b5a42701p+5, 0x1.d4ee6f4820611p-49, -0x1.43a46d5b0700cp+3, 0x1.1c1c2a72fae92p+2, -0x1.1d2db214dc79p+1,
     0x1.302b1dbc82c35p+0, -0x1.4fe22a7ad8587p-1, 0x1.7b572bd555125p-2, -0x1.b33948e3203a5p-3, 0x1.f9319b9f522ecp-4,
     -0x1.281a0ba325619p-4, 0x1.5d48b812f231p-5}, /* [185] 1.5625 <= y <= 1.625 2^-14, degree 10, 61.0 bits */
    {0x1.3cce392caf705p+5, -0x1.2c842bde4a05p-49, -0x1.32af7052d5e51p+3, 0x1.030f375d432e5p+2, -0x1.f47083ac8fe6cp+0,
     0x1.00cf6561e7b5ep+0, -0x1.10e2ab77ed547p-1, 0x1.288fc236d5f5dp-2, -0x1.476905dd7edeap-3, 0x1.6db4a9ce61ddap-4,
     -0x1.9c7cefcf493b3p-5, 0x1.d43669031936p-6}, /* [186] 1.625 <= y <= 1.6875 2^-14, degree 10, 60.3 bits */
    {0x1.3822eade8dc4ap+5, -0x1.009e5e272e112p-49, -0x1.23327282cd60fp+3, 0x1.da0dbf8bc066p+1, -0x1.b939b7326e0bcp+0,
     0x1.b460de58b5ceap-1, -0x1.bed4ea54ad195p-2, 0x1.d3f0f0a84e83ap-3, -0x1.f1d4a1693b0cbp-4, 0x1.0beb587fb50a7p-4,
     -0x1.232fe49588e6cp-5, 0x1.3e815728e4106p-6}, /* [187] 1.6875 <= y <= 1.75 2^-14, degree 10, 60.6 bits */
    {0x1.33b2ebef0d71ep+5, -0x1.2399ddcd86605p-49, -0x1.1500ebd53ba92p+3, 0x1.b31da23183d92p+1, -0x1.86c59b4973f07p+0,
     0x1.74eae1ee507f5p-1, -0x1.7073abdfecee3p-2, 0x1.7451b7b46928ap-3, -0x1.7e33cb6466142p-4, 0x1.8cf2a295c0ff6p-5,
     -0x1.a04328ff78bdep-6, 0x1.b7569ae2391ecp-7}, /* [188] 1.75 <= y <= 1.8125 2^-14, degree 10, 60.8 bits */
    {0x1.2f795c5e13c93p+5, -0x1.f143b90fcc2f5p-49, -0x1.07f4ecaa230dcp+3, 0x1.908f00f2399b2p+1, -0x1.5b8a4e24cf48fp+0,
     0x1.406ae6f998976p-1, -0x1.31d93f70a82e5p-2, 0x1.2a9500d0d0894p-3, -0x1.281e171c7bfa3p-4, 0x1.291dd5df9f5ebp-5,
     -0x1.2cff754ea1b89p-6, 0x1.32ea32c66c012p-7}, /* [189] 1.8125 <= y <= 1.875 2^-14, degree 10, 60.7 bits */
    {0x1.2b71e8b2e55e3p+5, -0x1.f1aa4ef0a3005p-50, -0x1.f7dbe9dbef84dp+2, 0x1.71c3d143a3ca4p+1, -0x1.364d51d84237bp+0,
     0x1.14b47931e29a7p-1, -0x1.feed4517fbbcbp-3, 0x1.e26f078f9fcafp-4, -0x1.cec3b35950804p-5, 0x1.c11a068421fdbp-6,
     -0x1.b8087c3d8a1b8p-7, 0x1.b1f8d39c19359p-8}, /* [190] 1.875 <= y <= 1.9375 2^-14, degree 10, 61.3 bits */
    {0x1.2798b6296610ap+5, 0x1.90116c61bcbb8p-51, -0x1.e1a00e3b2fcbap+2, 0x1.5638840d8274ep+1, -0x1.16119d46d9e7cp+0,
     0x1.e02dbc559d82p-2, -0x1.ad3e390713d58p-3, 0x1.88702375b195bp-4, -0x1.6c7cc2d2476afp-5, 0x1.567f1de9a5eecp-6,
     -0x1.44ea414a59519p-7, 0x1.36444442b1d1bp-8}, /* [191] 1.9375 <= y <= 2 2^-14, degree 10, 61.3 bits */
    {0x1.222232ee00e5ap+5, 0x1.0d399cdcec301p-51, -0x1.c347f015a92a8p+3, 0x1.32132dd395b4ep+3, -0x1.dac8ebe0a3d63p+2,
     0x1.874d682d565b9p+2, -0x1.4de4dd2eb248cp+2, 0x1.236376c536c42p+2, -0x1.02552de68df6p+2, 0x1.cf6ccced0dcc9p+1,
     -0x1.a44653b063138p+1, 0x1.7f17436fad9e1p+1}, /* [192] 1 <= y <= 1.0625 2^-13, degree 10, 62.9 bits */
    {0x1.1b5e10d7addecp+5, -0x1.ce5ef87b7c19ep-49, -0x1.9f9fdd7b38becp+3, 0x1.09c5d41bb7156p+3, -0x1.84b4ac6d40eb4p+2,
     0x1.2e0d14bc0eb95p+2, -0x1.e6044a398e5edp+1, 0x1.8fe878b35bbc6p+1, -0x1.4e481f7ea5611p+1, 0x1.1ab3973cdf333p+1,
     -0x1.e358cff9b3742p+0, 0x1.9f67c5673d334p+0}, /* [193] 1.0625 <= y <= 1.125 2^-13, degree 10, 62.8 bits */
    {0x1.151f1d60ce61fp+5, -0x1.e299a360a3544p-49, -0x1.808aac8707d0bp+3, 0x1.d1311f6fd4adap+2, -0x1.41ca9b5b9142p+2,
     0x1.d912b17da391dp+1, -0x1.6806b6d041675p+1, 0x1.1839e38d21ca2p+1, -0x1.bb2803e43a871p+0, 0x1.62849f481f23bp+0,
     -0x1.1ea15e5c8686dp+0, 0x1.d20c3dc3237d4p-1}, /* [194] 1.125 <= y <= 1.1875 2^-13, degree 10, 61.6 bits */
    {0x1.0f54b1773e7d5p+5, -0x1.c792c87150ae2p-49, -0x1.653e627fbebcap+3, 0x1.99fd85ad4ac87p+2, -0x1.0d0f47dc8d1c2p+2,
     0x1.7743b27da4d36p+1, -0x1.0ef1a08d44fecp+1, 0x1.9025c4087835ap+0, -0x1.2c2ce699c924bp+0, 0x1.c7a4355d68b16p-1,
     -0x1.5d70c68eb6e4p-1, 0x1.0d8498ac16f33p-1}, /* [195] 1.1875 <= y <= 1.25 2^-13, degree 10, 60.3 bits */
    {0x1.09f0f3f0a0dcep+5, 0x1.d144fea4f37d5p-52, -0x1.4d1bedbaf507ep+3, 0x1.6ba147b64d2a3p+2, -0x1.c5fc0cee2bb2cp+1,
     0x1.2d25a470272c4p+1, -0x1.9da5ad433bc79p+0, 0x1.228ccc7845e27p+0, -0x1.9ea77ac6469d2p-1, 0x1.2b5a88f7f08b3p-1,
     -0x1.b4b38ed358a4fp-2, 0x1.4063d2bd21adp-2}, /* [196] 1.25 <= y <= 1.3125 2^-13, degree 10, 60.0 bits */
    {0x1.04e84472d78a6p+5, 0x1.c76f0876b73f5p-49, -0x1.37a4798471b61p+3, 0x1.445c76f0757dep+2, -0x1.821e7f48a287fp+1,
     0x1.e86e0b661b079p+0, -0x1.3fd801fe31b02p+0, 0x1.ac6c6ecbc577dp-1, -0x1.237d68737c9c5p-1, 0x1.914c467dd084bp-2,
     -0x1.170fba8f1c271p-2, 0x1.866d0ca3178e3p-3}, /* [197] 1.3125 <= y <= 1.375 2^-13, degree 10, 60.0 bits */
    {0x1.0030caa714b76p+5, 0x1.c7d6580603389p-50, -0x1.2471c3da88cp+3, 0x1.22d73c6446a18p+2, -0x1.4ad365bdb9b35p+1,
     0x1.8fe2562fe24dbp+0, -0x1.f4716a8fe06d4p-1, 0x1.4044ef16d6e9cp-1, -0x1.a0703ee1139ep-2, 0x1.11eae3eebb26dp-2,
     -0x1.6bfe30a689cd8p-3, 0x1.e69de1653e9bep-4}, /* [198] 1.375 <= y <= 1.4375 2^-13, degree 10, 60.3 bits */
    {0x1.f7843f652d942p+4, 0x1.d9b3bf08e96bbp-51, -0x1.133084c6b6959p+3, 0x1.06065d9e8b8cfp+2, -0x1.1d5cce151645fp+1,
     0x1.4a40502742d0bp+0, -0x1.8bb615cc50c05p-1, 0x1.e4ef31297b312p-2, -0x1.2ddba42d9fe85p-2, 0x1.7c340d7788f59p-3,
     -0x1.e3afa62947962p-4, 0x1.358ec9a219fa3p-4}, /* [199] 1.4375 <= y <= 1.5 2^-13, degree 10, 63.4 bits */
    {0x1.ef2a16023870fp+4, 0x1.0f2bb5329c1fcp-50, -0x1.039c48be25dc5p+3, 0x1.da2f9f49a2fd4p+1, -0x1.ef564018bc8d5p+0,
     0x1.12ed6973b90c1p+0, -0x1.3bf995140272ep-1, 0x1.7369f6bbd5212p-2, -0x1.bb840f328a837p-3, 0x1.0be9bae4e3907p-3,
     -0x1.46e51206a659fp-4, 0x1.91582cb8b8626p-5}, /* [200] 1.5 <= y <= 1.5625 2^-13, degree 10, 60.9 bits */
    {0x1.e7469af06265fp+4, -0x1.96c1698f6c029p-50, -0x1.eaf8a685af895p+2, 0x1.aec9884829b13p+1, -0x1.b059da0d1a036p+0,
     0x1.cd1d052d4fc1dp-1, -0x1.fd2cce2605f88p-2, 0x1.1f85137cdfaa6p-2, -0x1.49defb63e0b5bp-3, 0x1.7ee629fbbf3b4p-4,
     -0x1.c0d77a368945fp-5, 0x1.08ba09a55d056p-5}, /* [201] 1.5625 <= y <= 1.625 2^-13, degree 10, 66.1 bits */
    {0x1.dfceef1b6ddf9p+4, 0x1.79e67377f117bp-52, -0x1.d1428122b8948p+2, 0x1.88cf0128c8f18p+1, -0x1.7b5aa3a03923bp+0,
     0x1.85524b898ab1ap-1, -0x1.9dad32b5d62e6p-2, 0x1.c18eb3a6a4c5dp-3, -0x1.f05009867b5e3p-4, 0x1.152dacc1d84e7p-4,
     -0x1.38a20b9e582d7p-5, 0x1.62dd6e466a5f7p-6}, /* [202] 1.625 <= y <= 1.6875 2^-13, degree 10, 62.0 bits */
    {0x1.d8b98f62f0a9fp+4, -0x1.8984d7c929045p-50, -0x1.b9c666ae2f29ep+2, 0x1.6767bdbd9f67ep+1, -0x1.4e7850fb49204p+0,
     0x1.4ac64504ad7b5p-1, -0x1.52af7dec75dffp-2, 0x1.62ad60619122dp-3, -0x1.7953547da5b83p-4, 0x1.9620c9f15cb07p-5,
     -0x1.b964f231efd69p-6, 0x1.e2ccef4dfe9f8p-7}, /* [203] 1.6875 <= y <= 1.75 2^-13, degree 10, 62.5 bits */
    {0x1.d1fe1e4bd3788p+4, 0x1.0fcd9a398be5bp-51, -0x1.a440d4b376aadp+2, 0x1.49e3678a9f3a1p+1, -0x1.2839e3211932dp+0,
     0x1.1aac40d8a790ap-1, -0x1.1746f52d7cb3fp-2, 0x1.1a3392fa21228p-3, -0x1.21aff0f6bef7bp-4, 0x1.2cdc074d744f1p-5,
     -0x1.3b7eced6e3acfp-6, 0x1.4cfb7fda668cdp-7}, /* [204] 1.75 <= y <= 1.8125 2^-13, degree 10, 61.8 bits */
    {0x1.cb9537bdc6f7fp+4, -0x1.622c73e88d47bp-52, -0x1.907848593dbdfp+2, 0x1.2fb12842924d6p+1, -0x1.0774ceaffbf1ep+0,
     0x1.e5c2211b6afd3p-2, -0x1.cfa73b272dddep-3, 0x1.c4a02f1a39455p-4, -0x1.c0e1aa7fe72fap-5, 0x1.c263c4a017349p-6,
     -0x1.c844b9b783d92p-7, 0x1.d13bd570be433p-8}, /* [205] 1.8125 <= y <= 1.875 2^-13, degree 10, 61.1 bits */
    {0x1.c5784cab66469p+4, 0x1.04d6b91c7961p-50, -0x1.7e3b7c4a78034p+2, 0x1.18593547b82b5p+1, -0x1.d6756930351b1p-1,
     0x1.a37de2c278e11p-2, -0x1.8345f6390aee5p-3, 0x1.6daa915ab8b22p-4, -0x1.5ec04983ef1bcp-5, 0x1.546401259280bp-6,
     -0x1.4d837cc85d746p-7, 0x1.48eab3dce66dp-8}, /* [206] 1.875 <= y <= 1.9375 2^-13, degree 10, 64.4 bits */
    {0x1.bfa185052298dp+4, 0x1.7ec3bc791fe3p-50, -0x1.6d600176dc25ep+2, 0x1.0377d6860fa28p+1, -0x1.a59794c57572p-1,
     0x1.6bfbce88f33b4p-2, -0x1.455c2890aed5fp-3, 0x1.29744573d6da6p-4, -0x1.144360202b63p-5, 0x1.03976c3b3b4f5p-6,
     -0x1.ec86aa62e45aap-8, 0x1.d6511e4725c6fp-9}, /* [207] 1.9375 <= y <= 2 2^-13, degree 10, 61.2 bits */
    {0x1.b75792e3679a2p+4, 0x1.3475a206089efp-50, -0x1.565e403d7a0b9p+3, 0x1.d02236a785621p+2, -0x1.67ecd16bf6fb4p+2,
     0x1.289dd084396f5p+2, -0x1.fa2d592505856p+1, 0x1.b9ba1fdec7a9ap+1, -0x1.879bcc259c057p+1, 0x1.5f3fdcf0e15e5p+1,
     -0x1.3e8a4fdabf157p+1, 0x1.225acbed6b6fbp+1}, /* [208] 1 <= y <= 1.0625 2^-12, degree 10, 59.9 bits */
    {0x1.ad1350234b04ap+4, 0x1.d80db874e691p-51, -0x1.3b553e26591dcp+3, 0x1.930755f7cac42p+2, -0x1.26acba65ef827p+2,
     0x1.c9edd607c616dp+1, -0x1.70664eb185e11p+1, 0x1.2f1ed0b1dcf43p+1, -0x1.fabe61a4f573dp+0, 0x1.ac8ba658a4787p+0,
     -0x1.6e58c64ebbe87p+0, 0x1.3ad923729b04p+0}, /* [209] 1.0625 <= y <= 1.125 2^-12, degree 10, 59.9 bits */
    {0x1.a39903d59d438p+4, 0x1.590be7b0ab587p-52, -0x1.23c3deb835d91p+3, 0x1.60b9e2a5dba48p+2, -0x1.e7e7059f550dfp+1,
     0x1.669bd94c17fa2p+1, -0x1.10e6cfa875f41p+1, 0x1.a8cfe86803667p+0, -0x1.4fe5847cc478dp+0, 0x1.0cb51c0ebe7b2p+0,
     -0x1.b27f8367f94e8p-1, 0x1.613bbc05b7cc3p-1}, /* [210] 1.125 <= y <= 1.1875 2^-12, degree 10, 59.8 bits */
    {0x1.9acf6e55746dp+4, 0x1.752eb6722d88dp-51, -0x1.0f1106614413ap+3, 0x1.36e097447b31ep+2, -0x1.97f4d2985fbc1p+1,
     0x1.1c78164385f57p+1, -0x1.9ac1da70c8b99p+0, 0x1.2f4e791a17d8bp+0, -0x1.c70c1ea7e6159p-1, 0x1.595b293a65abcp-1,
     -0x1.08db5d3e6673fp-1, 0x1.988e30174f604p-2}, /* [211] 1.1875 <= y <= 1.25 2^-12, degree 10, 60.1 bits */
    {0x1.92a19064f2d6ap+4, -0x1.77bf068261c64p-51, -0x1.f988408fb9f1fp+2, 0x1.13bb08afb96d8p+2, -0x1.582d790650234p+1,
     0x1.c892efdb70067p+0, -0x1.398d60925d284p+0, 0x1.b8782fb2c335bp-1, -0x1.3a4c12834aafp-1, 0x1.c5cbddea6cb9bp-2,
     -0x1.4aff63439b6f8p-2, 0x1.e5ac5b3a6a177p-3}, /* [212] 1.25 <= y <= 1.3125 2^-12, degree 10, 61.0 bits */
    {0x1.8afdc926bcd15p+4, -0x1.237aa6b7ec3bap-52, -0x1.d8fa0ed0ea278p+2, 0x1.ebeb59cdbe116p+1, -0x1.24bb3ca8c2bf4p+1,
     0x1.72432cd5b9a0fp+0, -0x1.e4e641f471d41p-1, 0x1.44be8d5cc48f7p-1, -0x1.b9e2ee7f9e245p-2, 0x1.302b6f62c6d26p-2,
     -0x1.a707fa0d66c76p-3, 0x1.27ebd43bc7d06p-3}, /* [213] 1.3125 <= y <= 1.375 2^-12, degree 10, 66.1 bits */
    {0x1.83d52b1bb5451p+4, -0x1.af72e7cd18669p-52, -0x1.bbdc6e6b7beddp+2, 0x1.b917c135e3717p+1, -0x1.f5a156f8d2c36p+0,
     0x1.2f2466ee61cdap+0, -0x1.7b5a191fe131cp-1, 0x1.e587e2b186a3fp-2, -0x1.3ba758aa9da47p-2, 0x1.9f3df57e5bcfep-3,
     -0x1.13e4206768008p-3, 0x1.70d486aa0a875p-4}, /* [214] 1.375 <= y <= 1.4375 2^-12, degree 10, 64.1 bits */
    {0x1.7d1af8f4bace6p+4, 0x1.831a4004d8312p-50, -0x1.a1b11b4df026cp+2, 0x1.8d662576991acp+1, -0x1.b0b3643bdf8e3p+0,
     0x1.f4b749afe1d9cp-1, -0x1.2bf6eda71ee4bp-1, 0x1.6f95bec2e058fp-2, -0x1.c99c295a0eeefp-3, 0x1.202f1ab1900afp-3,
     -0x1.6e9d8721ca7c1p-4, 0x1.d542738b4737fp-5}, /* [215] 1.4375 <= y <= 1.5 2^-12, degree 10, 61.3 bits */
    {0x1.76c43fae13c99p+4, -0x1.50949e03f2cdfp-50, -0x1.8a104d0402cbfp+2, 0x1.679815f923857p+1, -0x1.778cc9effd5fcp+0,
     0x1.a0d72262d7bdfp-1, -0x1.df0bfeea21ecdp-2, 0x1.198996a371185p-2, -0x1.502ea9b122498p-3, 0x1.9624e800f683p-4,
     -0x1.ef8cbaa160a4ep-5, 0x1.303377b2b013ep-5}, /* [216] 1.5 <= y <= 1.5625 2^-12, degree 10, 64.2 bits */
    {0x1.70c786832cadfp+4, -0x1.307d83b5a971bp-51, -0x1.74a3fde3d6ecp+2, 0x1.46b0ae6f38521p+1, -0x1.47ccf366004dp+0,
     0x1.5d91edb5cf537p-1, -0x1.81fb375d64c87p-2, 0x1.b3e461a968961p-3, -0x1.f4156691c14bdp-4, 0x1.223b08b072f13p-4,
     -0x1.5435453f46362p-5, 0x1.914dc29afef26p-6}, /* [217] 1.5625 <= y <= 1.625 2^-12, degree 10, 62.0 bits */
    {0x1.6b1c8f63d2128p+4, 0x1.df1eb1f2be909p-50, -0x1.612453db5b388p+2, 0x1.29e52ff7a7808p+1, -0x1.1f9f97cbf83dcp+0,
     0x1.2725d58e6863ap-1, -0x1.39975a1febf41p-2, 0x1.54c6c64f0e469p-3, -0x1.7834ebe853f51p-4, 0x1.a431e22eb9afap-5,
     -0x1.d9ef4251c5b81p-6, 0x1.0cf96338d27fdp-6}, /* [218] 1.625 <= y <= 1.6875 2^-12, degree 10, 61.5 bits */
    {0x1.65bc24082779cp+4, -0x1.93dc91cfd3bf8p-50, -0x1.4f54dd8796bb5p+2, 0x1.1091a365debadp+1, -0x1.fb314774be9a7p-1,
     0x1.f587f57a43452p-2, -0x1.00beee139b28ap-2, 0x1.0cdb53407baabp-3, -0x1.1e04101eb6e29p-4, 0x1.33d75a91f6359p-5,
     -0x1.4e910ad336541p-6, 0x1.6df2363759af1p-7}, /* [219] 1.6875 <= y <= 1.75 2^-12, degree 10, 61.3 bits */
    {0x1.609fecc5caa5fp+4, -0x1.b40911ed4053cp-51, -0x1.3f026cdf6707fp+2, 0x1.f460b7dacd5aep+0, -0x1.c134a22139c99p-1,
     0x1.ac9a37be61c75p-2, -0x1.a76caa4c4378p-3, 0x1.abd6b1577c4e4p-4, -0x1.b72c69b15a21dp-5, 0x1.c8198cd8658dep-6,
     -0x1.de4750be7359ap-7, 0x1.f8c7d96d2135cp-8}, /* [220] 1.75 <= y <= 1.8125 2^-12, degree 10, 62.4 bits */
    {0x1.5bc24f02937b7p+4, -0x1.bf6d2ed9b3067p-51, -0x1.30016832df272p+2, 0x1.cca71b536ce98p+0, -0x1.8f84a26ce748cp-1,
     0x1.7044e80b461fbp-2, -0x1.5f7c50feffa74p-3, 0x1.571c1c2526e95p-4, -0x1.54429c3314a5dp-5, 0x1.556519bc5fdc8p-6,
     -0x1.59d82241859b2p-7, 0x1.60a261ee1cd6cp-8}, /* [221] 1.8125 <= y <= 1.875 2^-12, degree 10, 63.8 bits */
    {0x1.571e51a79ce2p+4, -0x1.50e37b28940d2p-50, -0x1.222c74fc45b76p+2, 0x1.a940d204179ep+0, -0x1.64b7e47e1e19p-1,
     0x1.3e089f6e4c864p-2, -0x1.25960b3da4fedp-3, 0x1.15315b5cb166bp-4, -0x1.09e094ee80672p-5, 0x1.0204650bfb1fap-6,
     -0x1.f9993e25798b2p-8, 0x1.f29f37b2fd9cap-9}, /* [222] 1.875 <= y <= 1.9375 2^-12, degree 10, 60.7 bits */
    {0x1.52af865956aacp+4, 0x1.cd760653a4382p-50, -0x1.1563678d0bd67p+2, 0x1.8996ab31b4185p+0, -0x1.3faba29690915p-1,
     0x1.13f4210be89bbp-2, -0x1.ed4e29bd01c7fp-4, 0x1.c2f9011de53f2p-5, -0x1.a2d47fad7798bp-6, 0x1.898b637d072ebp-7,
     -0x1.7554a494dec53p-8, 0x1.647d8a38e271p-9}, /* [223] 1.9375 <= y <= 2 2^-12, degree 10, 60.7 bits */
    {0x1.4c64849e055c4p+4, 0x1.a775411c9ecf7p-53, -0x1.03f03c87165c1p+3, 0x1.6008c7c9ea196p+2, -0x1.10ead57c1a0fp+2,
     0x1.c1c4045b84b2ap+1, -0x1.7fbbc584ad511p+1, 0x1.4edb4657fae5fp+1, -0x1.28da4dde7da1dp+1, 0x1.0a4078497dd9cp+1,
     -0x1.e2e7c16435d31p+0, 0x1.b82b23e365b5dp+0}, /* [224] 1 <= y <= 1.0625 2^-11, degree 10, 59.4 bits */
    {0x1.4498f6a11b68p+4, 0x1.9729f9a1b441cp-54, -0x1.dedd6c7190f69p+2, 0x1.31b33b51b6c0bp+2, -0x1.bee4a894df2cfp+1,
     0x1.5b30db4f6397fp+1, -0x1.1749f43948f7bp+1, 0x1.cb931c14bd54bp+0, -0x1.802241f0fd5f4p+0, 0x1.44d8c82145fd7p+0,
     -0x1.15b149e503f3dp+0, 0x1.dd4e0f9dac71p-1}, /* [225] 1.0625 <= y <= 1.125 2^-11, degree 10, 60.4 bits */
    {0x1.3d669947ac3f7p+4, 0x1.3ba7659f7d226p-50, -0x1.bb1c8785d4fedp+2, 0x1.0b8e5ca5958e5p+2, -0x1.71fa4d7214f0ep+1,
     0x1.0fe4e8fad0cbap+1, -0x1.9dc9b25e64274p+0, 0x1.420b06851313p+0, -0x1.fd41330ca5135p-1, 0x1.976066de3c971p-1,
     -0x1.495ad0aab1d11p-1, 0x1.0bc000fbdd538p-1}, /* [226] 1.125 <= y <= 1.1875 2^-11, degree 10, 60.3 bits */
    {0x1.36ba473e2508p+4, -0x1.3e6c485ce4d65p-51, -0x1.9bb59f78c5affp+2, 0x1.d7a4abe2e8f18p+1, -0x1.355cd977300afp+1,
     0x1.af5f79173f55p+0, -0x1.37693cb3ed7dp+0, 0x1.cbdea81cf6c0fp-1, -0x1.58f4403953dc4p-1, 0x1.05cb04b17b734p-1,
     -0x1.918881799628ep-2, 0x1.35afcceee262fp-2}, /* [227] 1.1875 <= y <= 1.25 2^-11, degree 10, 60.8 bits */
    {0x1.3084146853fe9p+4, -0x1.8b6b27a2b4db4p-51, -0x1.7ff1dadca399cp+2, 0x1.a25662b5dcf53p+1, -0x1.0501379981869p+1,
     0x1.5a2f41240df21p+0, -0x1.db70ae6d4d5bfp-1, 0x1.4dec0170bc34cp-1, -0x1.dc84e92676d11p-2, 0x1.57ff9f2833b0ep-2,
     -0x1.f5cf53fc8d213p-3, 0x1.7025434c4869ep-3}, /* [228] 1.25 <= y <= 1.3125 2^-11, degree 10, 60.9 bits */
    {0x1.2ab6a2860216bp+4, 0x1.8654a8482e078p-52, -0x1.673f6dd6370c3p+2, 0x1.752f06e9cc5e3p+1, -0x1.bbfe4ea70e7cfp+0,
     0x1.18bf3102926c6p+0, -0x1.6fa216a135d92p-1, 0x1.ec6315df9128ap-2, -0x1.4efc3ec60d116p-2, 0x1.cd27713198c51p-3,
     -0x1.40abfd77bd266p-3, 0x1.c0a0740e10a8ap-4}, /* [229] 1.3125 <= y <= 1.375 2^-11, degree 10, 60.5 bits */
    {0x1.25469f8cbb131p+4, -0x1.1faf75805be6bp-52, -0x1.5128caf632b39p+2, 0x1.4ea3630a57504p+1, -0x1.7c6d839bea1aep+0,
     0x1.cbb778c14881ep-1, -0x1.1f9d91f1aa588p-1, 0x1.7017d85b45e3cp-2, -0x1.de96551d7fed3p-3, 0x1.3ac777f2c4e2bp-3,
     -0x1.a245fe671cccp-4, 0x1.1795002f72764p-4}, /* [230] 1.375 <= y <= 1.4375 2^-11, degree 10, 60.9 bits */
    {0x1.202a623333dd6p+4, 0x1.4d61780f6c7cep-50, -0x1.3d4e34b26636p+2, 0x1.2d804e3f5f335p+1, -0x1.48294d1a470c3p+0,
     0x1.7bad37f4a83edp-1, -0x1.c6dbed2548dfcp-2, 0x1.16addeba7126bp-2, -0x1.5ae9c881219efp-3, 0x1.b4ed5bc7b04fp-4,
     -0x1.15e97623c97ep-4, 0x1.63b681f0b7b1ep-5}, /* [231] 1.4375 <= y <= 1.5 2^-11, degree 10, 60.2 bits */
    {0x1.1b599cb0c8d9p+4, 0x1.db3213618aefap-50, -0x1.2b60f943c9e23p+2, 0x1.10d45926dca41p+1, -0x1.1cd349249d69ap+0,
     0x1.3c152a034329ep-1, -0x1.6b369f0436e11p-2, 0x1.aae48daefdbc9p-3, -0x1.fdb961855e167p-4, 0x1.33e388f6eeab5p-4,
     -0x1.77a763feb3a72p-5, 0x1.cd30e7c9e9126p-6}, /* [232] 1.5 <= y <= 1.5625 2^-11, degree 10, 60.2 bits */
    {0x1.16cd200ca826fp+4, -0x1.247ba593cb7b5p-50, -0x1.1b1fde34bd4cp+2, 0x1.efbf8c2a00decp+0, -0x1.f13c281aaef33p-1,
     0x1.0913f1fba12b1p-1, -0x1.24a7da6216a4bp-2, 0x1.4a795f7cfc32bp-3, -0x1.7b1f050234792p-4, 0x1.b80a072a2dd68p-5,
     -0x1.01e615bf38273p-5, 0x1.303499d4b77dfp-6}, /* [233] 1.5625 <= y <= 1.625 2^-11, degree 10, 62.1 bits */
    {0x1.127eabf07772cp+4, 0x1.62b8fb8589942p-50, -0x1.0c54677fc04cap+2, 0x1.c411b7fd12337p+0, -0x1.b44d4c5c80277p-1,
     0x1.bfa0c474d9d7ep-2, -0x1.db8b72d40178ap-3, 0x1.025d748259bd4p-3, -0x1.1d3622b035c2bp-4, 0x1.3e8bfddd77a58p-5,
     -0x1.674668ada8bc4p-6, 0x1.97ca9530f0756p-7}, /* [234] 1.625 <= y <= 1.6875 2^-11, degree 10, 64.1 bits */
    {0x1.0e68c80c57395p+4, 0x1.dd60bd583d708p-53, -0x1.fda17f3c335fbp+1, 0x1.9da6912a8b0bep+0, -0x1.80b1f0d7aca6p-1,
     0x1.7c52fa4c639a9p-2, -0x1.855902ef549c3p-3, 0x1.97ae6c263df87p-4, -0x1.b1ad17713f49dp-5, 0x1.d2bfd77ea2332p-6,
     -0x1.fb40eaa9bdf6p-7, 0x1.156851e670167p-7}, /* [235] 1.6875 <= y <= 1.75 2^-11, degree 10, 61.3 bits */
    {0x1.0a86a4e0246a2p+4, -0x1.76db7685a8748p-52, -0x1.e4dc2e18cd0dfp+1, 0x1.7bb361471ef7ap+0, -0x1.54b8c0ec868f4p-1,
     0x1.4506ce9e56669p-2, -0x1.410f7e9b55dbep-3, 0x1.446192cfa9cc6p-4, -0x1.4cf4a8e5c6375p-5, 0x1.59c5ebf7fb63bp-6,
     -0x1.6a931cd386ca3p-7, 0x1.7ea7a9d86f544p-8}, /* [236] 1.75 <= y <= 1.8125 2^-11, degree 10, 61.4 bits */
    {0x1.06d4024ada63fp+4, 0x1.8ede3d815788dp-50, -0x1.ce16bb0967af5p+1, 0x1.5d91a73595048p+0, -0x1.2f0a92e202bccp-1,
     0x1.17475a154d706p-2, -0x1.0a8464f579547p-3, 0x1.0424f35869f45p-4, -0x1.01f7e5028bbe5p-5, 0x1.02d125e608c12p-6,
     -0x1.062e4e848a012p-7, 0x1.0b521f5295088p-8}, /* [237] 1.8125 <= y <= 1.875 2^-11, degree 10, 67.9 bits */
    {0x1.034d1aa6baac9p+4, -0x1.9911f1747c2b9p-50, -0x1.b9187ea1951afp+1, 0x1.42b7abda68527p+0, -0x1.0e95661e09209p-1,
     0x1.e25fb461d6a05p-3, -0x1.bd3c49051bfc2p-4, 0x1.a456915d08d73p-5, -0x1.932783f726757p-6, 0x1.8737c407f197cp-7,
     -0x1.7f4ada737881dp-8, 0x1.79fe1049529b3p-9}, /* [238] 1.875 <= y <= 1.9375 2^-11, degree 10, 62.1 bits */
    {0x1.ffdd230673985p+3, -0x1.351fa312cea6p-51, -0x1.a5b0ada1ec344p+1, 0x1.2ab2caca61903p+0, -0x1.e4f987dd9629ep-2,
     0x1.a28ea6b8161d8p-3, -0x1.76108d9b83ea7p-4, 0x1.55ef2f814f513p-5, -0x1.3d8b11a41f4c8p-6, 0x1.2a5bbc9e7213ap-7,
     -0x1.1b05e84bcd2ffp-8, 0x1.0e3f94fee12f7p-9}, /* [239] 1.9375 <= y <= 2 2^-11, degree 10, 63.0 bits */
    {0x1.f64bee9fe720dp+3, 0x1.926dbb546e68cp-51, -0x1.8b34240d5d9c6p+2, 0x1.0b2d3c0034bc7p+2, -0x1.9e0f68d88d33ep+1,
     0x1.551ab0716e74dp+1, -0x1.22fc2077b6af2p+1, 0x1.fbcbde218361ap+0, -0x1.c222b4caa2ab9p+0, 0x1.93b6af5198137p+0,
     -0x1.6e18c7ae9b38fp+0, 0x1.4dafe7d7a5408p+0}, /* [240] 1 <= y <= 1.0625 2^-10, degree 10, 60.1 bits */
    {0x1.ea71bcd6b9803p+3, -0x1.4a4b4f5945b95p-52, -0x1.6c139b140d415p+2, 0x1.d00e248ca2335p+1, -0x1.530570e38ebcbp+1,
     0x1.075219dca0714p+1, -0x1.a794f4a0bd312p+0, 0x1.5c78d43566013p+0, -0x1.233fbc01b14c6p+0, 0x1.ec91e5dc47f84p-1,
     -0x1.a50d55e1d9aeap-1, 0x1.69d8564b17569p-1}, /* [241] 1.0625 <= y <= 1.125 2^-10, degree 10, 59.9 bits */
    {0x1.df8016203b138p+3, 0x1.25867ab2e3a5ep-51, -0x1.50f04960df807p+2, 0x1.962e30737fc83p+1, -0x1.18af618fa8baap+1,
     0x1.9c7109b475dcfp+0, -0x1.39cb352cd24b4p+0, 0x1.e863d0030796ep-1, -0x1.821fa59b0a408p-1, 0x1.34dc8a51a1873p-1,
     -0x1.f364ce07d2c3cp-2, 0x1.95f84c2e793f6p-2}, /* [242] 1.125 <= y <= 1.1875 2^-10, degree 10, 61.8 bits */
    {0x1.d559eddb6c02dp+3, 0x1.c2b9762168311p-51, -0x1.391a18f44fe21p+2, 0x1.660742772209ep+1, -0x1.d56ba12d7f17bp+0,
     0x1.4730d47849bd2p+0, -0x1.d853e066d510dp-1, 0x1.5cb6932c8d8cap-1, -0x1.058dee6da61d9p-1, 0x1.8cf9d51c3d2c4p-2,
     -0x1.306c6bcc89989p-2, 0x1.d59019f7321acp-3}, /* [243] 1.1875 <= y <= 1.25 2^-10, degree 10, 60.6 bits */
    {0x1.cbe71b2fbd51fp+3, 0x1.2dbc9fed1ee1bp-51, -0x1.24065a2d6c6d5p+2, 0x1.3d95bbb411b8ep+1, -0x1.8c0fba82eb10ap+0,
     0x1.0695f8b7d9f93p+0, -0x1.6891895c63c02p-1, 0x1.fa6dfd8375fcp-2, -0x1.69519784f08b4p-2, 0x1.04d1ec79fc0aep-2,
     -0x1.7c747f82d46c2p-3, 0x1.171ade6cccf37p-3}, /* [244] 1.25 <= y <= 1.3125 2^-10, degree 10, 61.9 bits */
    {0x1.c31355271e0d9p+3, 0x1.e23ba843ee9a1p-51, -0x1.114676f136c3bp+2, 0x1.1b532b09a9b9fp+1, -0x1.50e2559702d95p+0,
     0x1.a9ea7019f66e8p-1, -0x1.16d1209daea91p-1, 0x1.756392c5d7483p-2, -0x1.fc0369daed82ep-3, 0x1.5da771ad56801p-3,
     -0x1.e640cb6c8dc04p-4, 0x1.5420457706f73p-4}, /* [245] 1.3125 <= y <= 1.375 2^-10, degree 10, 64.4 bits */
    {0x1.bacd6e08b2cd1p+3, -0x1.eb36ef8791b13p-57, -0x1.0081449996d3p+2, 0x1.fc27ad60fcca2p+0, -0x1.20aa8d0e8605dp+0,
     0x1.5cb9d840da8a1p-1, -0x1.b44616c508e6fp-2, 0x1.17240281d2e11p-2, -0x1.6ae6f73fddf4fp-3, 0x1.dd59887178506p-4,
     -0x1.3d21a022755bep-4, 0x1.a7efb5584732ep-5}, /* [246] 1.375 <= y <= 1.4375 2^-10, degree 10, 60.0 bits */
    {0x1.b306bc7e548cbp+3, 0x1.3c4bc8155177ep-51, -0x1.e2dc46c0f2802p+1, 0x1.c9dd93d9a1b1dp+0, -0x1.f2092ecdc822dp-1,
     0x1.200529c7b53f3p-1, -0x1.58fd55d6fd3b4p-2, 0x1.a6adbdee7ea5fp-3, -0x1.070fec8f20e8p-3, 0x1.4b4c19c647c44p-4,
     -0x1.a56d9495ec43cp-5, 0x1.0db117d0d4d6p-5}, /* [247] 1.4375 <= y <= 1.5 2^-10, degree 10, 64.9 bits */
    {0x1.abb2a666cc8bp+3, -0x1.cd73c715f63a4p-51, -0x1.c7a2c2383beb2p+1, 0x1.9e59cee2ff17ap+0, -0x1.b04935c289bf9p-1,
     0x1.df92a79d7bc8cp-2, -0x1.137d000a08849p-2, 0x1.43bf16e0704fep-3, -0x1.82875f321ae9bp-4, 0x1.d2eb097d518f3p-5,
     -0x1.1cd3bcfebd50bp-5, 0x1.5daaede35301cp-6}, /* [248] 1.5 <= y <= 1.5625 2^-10, degree 10, 62.1 bits */
    {0x1.a4c644c64962cp+3, 0x1.53417cb3e575p-51, -0x1.aef30485d49bbp+1, 0x1.78798322d2719p+0, -0x1.7959608d10b6dp-1,
     0x1.92333d0719aaep-2, -0x1.bbf4d91f215bbp-3, 0x1.f542d1231231bp-4, -0x1.1f7f4a499cc68p-4, 0x1.4dab519bb7ec7p-5,
     -0x1.8717c679dedf5p-6, 0x1.cd4b6062307e3p-7}, /* [249] 1.5625 <= y <= 1.625 2^-10, degree 10, 61.4 bits */
    {0x1.9e381ab19a672p+3, 0x1.cd98b323ad546p-53, -0x1.987a62db47561p+1, 0x1.57537f4033cc2p+0, -0x1.4b1f2f3826581p-1,
     0x1.539a2e7cb5efep-2, -0x1.68b576769c461p-3, 0x1.87e54ad43f9d5p-4, -0x1.b09339ad4fda6p-5, 0x1.e3194f9dc454ep-6,
     -0x1.106ad9b5030a5p-6, 0x1.3530b07735a94p-7}, /* [250] 1.625 <= y <= 1.6875 2^-10, degree 10, 61.5 bits */
    {0x1.97ffdabc7fd92p+3, -0x1.fcd504e38fecap-52, -0x1.83f351c7bee06p+1, 0x1.3a2b2a5e87642p+0, -0x1.23f7f35061e19p-1,
     0x1.208ceaa4604ddp-2, -0x1.2755c4348c512p-3, 0x1.3532de6b25d49p-4, -0x1.48e18fe97b5fp-5, 0x1.61ef88b25d9a8p-6,
     -0x1.80a090734ccbfp-7, 0x1.a4abba1a49773p-8}, /* [251] 1.6875 <= y <= 1.75 2^-10, degree 10, 60.8 bits */
    {0x1.9216379fa1c5p+3, 0x1.ee9b858ed94d5p-51, -0x1.7122ed7ed606dp+1, 0x1.2066c1326ecb7p+0, -0x1.029b070bc7afep-1,
     0x1.ed35901d30055p-3, -0x1.e7162438095c6p-4, 0x1.ec0dc009be02fp-5, -0x1.f902296734105p-6, 0x1.0634470a25fa8p-6,
     -0x1.12eda23383b8fp-7, 0x1.2223e5512756dp-8}, /* [252] 1.75 <= y <= 1.8125 2^-10, degree 10, 60.9 bits */
    {0x1.8c74bda095ef9p+3, -0x1.a3cc792a563a4p-52, -0x1.5fd70a2eb9bf5p+1, 0x1.0987f69139dd6p+0, -0x1.cc084b527cbb1p-2,
     0x1.a7cdad8c5a23dp-3, -0x1.945948154cde4p-4, 0x1.8a9f3b79a1fb2p-5, -0x1.87479b257bfcdp-6, 0x1.888917979bea8p-7,
     -0x1.8d9cc8ebec5b3p-8, 0x1.95630da97c4cfp-9}, /* [253] 1.8125 <= y <= 1.875 2^-10, degree 10, 61.4 bits */
    {0x1.8715b2e0b1d7ep+3, -0x1.7b3738e1f3cc6p-51, -0x1.4fe4ab9ddbae1p+1, 0x1.ea4ca62b450d7p-1, -0x1.9ac6fae454183p-2,
     0x1.6e02ea526043dp-3, -0x1.51c165daee575p-4, 0x1.3ed1f16602c7p-5, -0x1.31c0cfe8d2271p-6, 0x1.28ad14e2b17cfp-7,
     -0x1.22a5adbf076dp-8, 0x1.1e9d0709e35c7p-9}, /* [254] 1.875 <= y <= 1.9375 2^-10, degree 10, 62.9 bits */
    {0x1.81f3fd2828b3cp+3, -0x1.acb6db278e71ap-51, -0x1.4126cbf714009p+1, 0x1.c5d5bec0ae6cbp-1, -0x1.7023ae1af741cp-2,
     0x1.3d9978f17c377p-3, -0x1.1bc5db48148b7p-4, 0x1.035b9db30a25cp-5, -0x1.e1a91c5c4f509p-7, 0x1.c485a7cc84e9cp-8,
     -0x1.ad3c0c7a73768p-9, 0x1.99d6a869aa4aep-10}, /* [255] 1.9375 <= y <= 2 2^-10, degree 10, 61.5 bits */
    {0x1.7aaa9150119ddp+3, -0x1.520d69904d719p-52, -0x1.2d077b05a8422p+2, 0x1.95fa55a9a9366p+1, -0x1.3a5415e9e3cf6p+1,
     0x1.02d74ccc80467p+1, -0x1.b982e760590c9p+0, 0x1.812d7841a21fdp+0, -0x1.556695e13c7a2p+0, 0x1.322a66a52c107p+0,
     -0x1.159e7068a4e1cp+0, 0x1.fa0e505140f5bp-1}, /* [256] 1 <= y <= 1.0625 2^-9, degree 10, 60.0 bits */
    {0x1.71a3282d639d9p+3, -0x1.de45a26a75c04p-52, -0x1.1560fedb2991fp+2, 0x1.609c1cd74c2d6p+1, -0x1.01627d920be7fp+1,
     0x1.8fa87a781aee4p+0, -0x1.415e022293b07p+0, 0x1.08566524fb17dp+0, -0x1.b9ce8ecd19d73p-1, 0x1.75909b8ce0087p-1,
     -0x1.3f4d7d24bc2ecp-1, 0x1.12632c42c28b6p-1}, /* [257] 1.0625 <= y <= 1.125 2^-9, degree 10, 61.0 bits */
    {0x1.694c7145844f2p+3, -0x1.6c22a2dedd0b5p-53, -0x1.00c1d09c5fb95p+2, 0x1.34ab6879c3ef3p+1, -0x1.aa39f30f22188p+0,
     0x1.390382ff6380dp+0, -0x1.dc2b3e8577fafp-1, 0x1.727d7e846e6f7p-1, -0x1.24dfd1134213ep-1, 0x1.d47f3e5f2fd18p-2,
     -0x1.7ab97752af156p-2, 0x1.33db252e11952p-2}, /* [258] 1.125 <= y <= 1.1875 2^-9, degree 10, 61.0 bits */
    {0x1.61905e812fad9p+3, -0x1.801ec1728d0a8p-51, -0x1.dd489d04da7e6p+1, 0x1.101bb0b877679p+1, -0x1.6470e461407d1p+0,
     0x1.f0a8e464a7866p-1, -0x1.666316a9fc476p-1, 0x1.088b301e013d7p-1, -0x1.8ccae6c411db9p-2, 0x1.2d16482958c85p-2,
     -0x1.cdbe9e5f6ee88p-3, 0x1.64170bcd5b76cp-3}, /* [259] 1.1875 <= y <= 1.25 2^-9, degree 10, 61.3 bits */
    {0x1.5a5c97cb7816dp+3, -0x1.5fbf278fd95b2p-51, -0x1.bd3e6e2e3d57fp+1, 0x1.e2cb77f76a26ap+0, -0x1.2cc2fa752693cp+0,
     0x1.8e9df930db426p-1, -0x1.119a07432620bp-1, 0x1.803560ff0976ep-2, -0x1.1214a69c0e2fbp-2, 0x1.8ba6f07b9ba98p-3,
     -0x1.208af598a483ap-3, 0x1.a753a3982680fp-4}, /* [260] 1.25 <= y <= 1.3125 2^-9, degree 10, 63.3 bits */
    {0x1.53a1b5df8d3a9p+3, 0x1.a9de63b1d6e45p-51, -0x1.a0bd3628fb07cp+1, 0x1.aec28ec04499cp+0, -0x1.ffafd1f0c9837p-1,
     0x1.434c9da4453ep-1, -0x1.a7284458646b9p-2, 0x1.1b49b012bbacbp-2, -0x1.815f0c82f9f8fp-3, 0x1.0936aacdbb418p-3,
     -0x1.70caf2f5b8fc3p-4, 0x1.01f25d1c60371p-4}, /* [261] 1.3125 <= y <= 1.375 2^-9, degree 10, 60.8 bits */
    {0x1.4d52ad12a30cdp+3, 0x1.315b0b922de9p-53, -0x1.873d9822fa38cp+1, 0x1.8255c529cd734p+0, -0x1.b67bb7f78f542p-1,
     0x1.08b90af742d24p-1, -0x1.4b1491b2f7d69p-2, 0x1.a7951e159b0d3p-3, -0x1.134d6a34906bap-3, 0x1.6a15426a202f2p-4,
     -0x1.e1103296fd30fp-5, 0x1.41841d0e23aa3p-5}, /* [262] 1.375 <= y <= 1.4375 2^-9, degree 10, 61.0 bits */
    {0x1.47645adb67052p+3, -0x1.71fa6d34c16dfp-51, -0x1.7051527c0e147p+1, 0x1.5c238b3b26d69p+0, -0x1.7a495141a64afp-1,
     0x1.b54e7064d4153p-2, -0x1.05d1bc246e62fp-2, 0x1.40b5f2e2edd88p-3, -0x1.8f23be38379d6p-4, 0x1.f69ce6adc1d29p-5,
     -0x1.3fa5652776fa8p-5, 0x1.991543903f8a6p-6}, /* [263] 1.4375 <= y <= 1.5 2^-9, degree 10, 60.3 bits */
    {0x1.41cd2ce5ea6bdp+3, 0x1.d36607632ca5ep-55, -0x1.5b9dc2c4293aap+1, 0x1.3b15f2b9d0403p+0, -0x1.485ecd81bff12p-1,
     0x1.6c17f9e1c1617p-2, -0x1.a22ac930b7ff5p-3, 0x1.eb4f8c9e05c25p-4, -0x1.253f531d77e6ep-4, 0x1.62318ceb569aap-5,
     -0x1.b015fac15706ap-6, 0x1.09345f5007c62p-6}, /* [264] 1.5 <= y <= 1.5625 2^-9, degree 10, 61.7 bits */
    {0x1.3c84db364be85p+3, 0x1.cb4f05249f041p-53, -0x1.48d7c71bcd46bp+1, 0x1.1e503dc892c28p+0, -0x1.1ea92e7b09c03p-1,
     0x1.315ea9a49fde1p-2, -0x1.50f5b499d859cp-3, 0x1.7c5e041dc55e5p-4, -0x1.b43f06a309f42p-5, 0x1.fa3e87df7a7d3p-6,
     -0x1.28a79faad4d8ep-6, 0x1.5de0806ec5442p-7}, /* [265] 1.5625 <= y <= 1.625 2^-9, degree 10, 60.7 bits */
    {0x1.378430b1fd96dp+3, -0x1.0caff9129cd1ep-51, -0x1.37c09c32524cdp+1, 0x1.05216fc077e56p+0, -0x1.f71fad4ef6dcap-2,
     0x1.01db7a24f179ap-2, -0x1.11c9ddadfb1fbp-3, 0x1.29640838d5a56p-4, -0x1.483477516ab1ep-5, 0x1.6e7dd4a0f8229p-6,
     -0x1.9d48c5cb5bf31p-7, 0x1.d508b67dc1675p-8}, /* [266] 1.625 <= y <= 1.6875 2^-9, degree 10, 61.1 bits */
    {0x1.32c4deabfe04ap+3, 0x1.26480b8109852p-52, -0x1.28237470e5a89p+1, 0x1.ddf4c6075cf09p-1, -0x1.bbaa20994e60cp-2,
     0x1.b6369779fb968p-3, -0x1.c05b68670e753p-4, 0x1.d54a841cefb5ap-5, -0x1.f313d8525a21cp-6, 0x1.0c83734e3df33p-6,
     -0x1.23c46befd86c8p-7, 0x1.3f15060a74dcbp-8}, /* [267] 1.6875 <= y <= 1.75 2^-9, degree 10, 61.7 bits */
    {0x1.2e4158f41fbbcp+3, 0x1.1c1c4edc97b8ap-52, -0x1.19d3989b27531p+1, 0x1.b6ccc216b662fp-1, -0x1.88feea62c69f5p-2,
     0x1.768854ea1e306p-3, -0x1.71bf6dade2bep-4, 0x1.756d13ef5a565p-5, -0x1.7f306655781c8p-6, 0x1.8ddaf3cb61c1cp-7,
     -0x1.a11e126b00146p-8, 0x1.b828a74c999b1p-9}, /* [268] 1.75 <= y <= 1.8125 2^-9, degree 10, 61.8 bits */
    {0x1.29f4b88bb2925p+3, -0x1.09f1959ddab44p-51, -0x1.0caaefaafd51p+1, 0x1.940b14ae0e0ccp-1, -0x1.5d93020cff5dap-2,
     0x1.41d868f9d3967p-3, -0x1.32f4aed69d189p-4, 0x1.2b7eefe074b7cp-5, -0x1.28e7995c882f4p-6, 0x1.29d0e70801137p-7,
     -0x1.2da27c2b26f6ap-8, 0x1.338156159757cp-9}, /* [269] 1.8125 <= y <= 1.875 2^-9, degree 10, 61.2 bits */
    {0x1.25daa396f6055p+3, 0x1.158a914a9a0a5p-51, -0x1.0088d50957a3p+1, 0x1.7511231357f63p-1, -0x1.382af72f93c76p-2,
     0x1.15f8eada37bbcp-3, -0x1.006a0d6ff6d3ap-4, 0x1.e3f3c051e58f7p-6, -0x1.d0079e5533251p-7, 0x1.c230780eaf588p-8,
     -0x1.b8fdb1ae54667p-9, 0x1.b2d4b8690189ep-10}, /* [270] 1.875 <= y <= 1.9375 2^-9, degree 10, 60.2 bits */
    {0x1.21ef3978479e9p+3, 0x1.3e143f583f904p-51, -0x1.eaa255b744066p+0, 0x1.595ae2b2f689p-1, -0x1.17c8f7e995083p-2,
     0x1.e26febea33b92p-4, -0x1.aee25e0de1161p-5, 0x1.89b507aebb8cep-6, -0x1.6d82f039efc4p-7, 0x1.57595c8ed3e62p-8,
     -0x1.45a45cfc6663p-9, 0x1.36e5e0b244472p-10}, /* [271] 1.9375 <= y <= 2 2^-9, degree 10, 64.7 bits */
    {0x1.1c5e1d6c7239cp+3, 0x1.b5e04fee59285p-51, -0x1.cc01c6dc29b45p+1, 0x1.34fb5ee2bd174p+1, -0x1.ddd3d2e292bccp+0,
     0x1.8936f402d81e6p+0, -0x1.4f3893846d7f4p+0, 0x1.245e4bd9a4ca9p+0, -0x1.031670561bae7p+0, 0x1.d09ffc2bc5692p-1,
     -0x1.a540b88ef6b6bp-1, 0x1.7fe6d99a2e826p-1}, /* [272] 1 <= y <= 1.0625 2^-8, degree 10, 60.2 bits */
    {0x1.1577c82c22ef2p+3, -0x1.9723b189c130bp-51, -0x1.a801046d9c8b8p+1, 0x1.0c6a58df8283cp+1, -0x1.8751548781365p+0,
     0x1.2f99a9c740c73p+0, -0x1.e80b8840ca48bp-1, 0x1.915219c16db38p-1, -0x1.4f4ee87f083a5p-1, 0x1.1b788d83f7f7dp-1,
     -0x1.e48790ec1b219p-2, 0x1.a0547681aa6b3p-2}, /* [273] 1.0625 <= y <= 1.125 2^-8, degree 10, 65.0 bits */
    {0x1.0f17f430fba3dp+3, 0x1.dd0c68a559899p-51, -0x1.889afeb3531d3p+1, 0x1.d6057ca34997ap+0, -0x1.440d7119bd287p+0,
     0x1.db9cbb58c39cbp-1, -0x1.6999794d8371cp-1, 0x1.19435562a2642p-1, -0x1.bc950d587c0f5p-2, 0x1.63877ef48517fp-2,
     -0x1.1f5d94a2c9572p-2, 0x1.d322aa716a13dp-3}, /* [274] 1.125 <= y <= 1.1875 2^-8, degree 10, 62.3 bits */
    {0x1.092ddd2bd347dp+3, 0x1.7948b75b97506p-51, -0x1.6d04ac5892be6p+1, 0x1.9e6c8263a080bp+0, -0x1.0f081feaa78e7p+0,
     0x1.795dfeb055e94p-1, -0x1.102e368866478p-1, 0x1.91b1d08731ap-2, -0x1.2d2f54b06d499p-2, 0x1.c900088dc67a4p-3,
     -0x1.5e60b4139337ap-3, 0x1.0e2cfc735beadp-3}, /* [275] 1.1875 <= y <= 1.25 2^-8, degree 10, 62.8 bits */
    {0x1.03ab908c2d178p+3, -0x1.0500ff7456ebbp-51, -0x1.549e1ce1b851p+1, 0x1.6fb78d5c9bbddp+0, -0x1.c972a0de61e4ap-1,
     0x1.2ee797890602dp-1, -0x1.9f9d5d11c5998p-2, 0x1.23b89814d38e9p-2, -0x1.a01bbe204a122p-3, 0x1.2c48e251284e3p-3,
     -0x1.b5ec596ede1e6p-4, 0x1.4135540e2457dp-4}, /* [276] 1.25 <= y <= 1.3125 2^-8, degree 10, 60.1 bits */
    {0x1.fd0aaf7e2bep+2, 0x1.786edeaf8cf3ap-54, -0x1.3ee7c24deec51p+1, 0x1.48249a0852476p+0, -0x1.852dbd773f28fp-1,
     0x1.eb64a2c2f7caep-2, -0x1.416d0c91537c4p-2, 0x1.ae385459e44c4p-3, -0x1.248dbb8b23c78p-3, 0x1.9298d9b8ccca6p-4,
     -0x1.17dfd3a6dd186p-4, 0x1.87760e9d1294cp-5}, /* [277] 1.3125 <= y <= 1.375 2^-8, degree 10, 62.8 bits */
    {0x1.f3628db88632cp+2, -0x1.9d0db64ab5117p-52, -0x1.2b7abf1f4175bp+1, 0x1.265a2774f3f9fp+0, -0x1.4d8b33434615cp-1,
     0x1.9266bed9d4e79p-2, -0x1.f70349cf4c932p-3, 0x1.41a9f0758a0fap-3, -0x1.a2045b0c4e234p-4, 0x1.12d6bb1ee770fp-4,
     -0x1.6d183c4d3c44ep-5, 0x1.e7f524d874a0ep-6}, /* [278] 1.375 <= y <= 1.4375 2^-8, degree 10, 60.1 bits */
    {0x1.ea4dcb6796143p+2, 0x1.ca9442ee63ebep-52, -0x1.1a0347d6cfe7dp+1, 0x1.094ba32007c3cp+0, -0x1.1fca12295d8fap-1,
     0x1.4c6795948e3adp-2, -0x1.8dd12b2d94788p-3, 0x1.e71f90347e70bp-4, -0x1.2f0b6044c77a9p-4, 0x1.7d878e94f86a9p-5,
     -0x1.e5346ce10ad49p-6, 0x1.367154f18a0acp-6}, /* [279] 1.4375 <= y <= 1.5 2^-8, degree 10, 61.5 bits */
    {0x1.e1bdd88467a13p+2, 0x1.6c735508a5d23p-52, -0x1.0a3c78d130abep+1, 0x1.e04bd308d4173p-1, -0x1.f3b0d907e2ffp-2,
     0x1.14c80db9ccd2fp-2, -0x1.3db6fb0e2d896p-3, 0x1.7526319c2e5dbp-4, -0x1.bd52153988bfap-5, 0x1.0ce174c1caa8ap-5,
     -0x1.47f5321334628p-6, 0x1.9288696dd1d0bp-7}, /* [280] 1.5 <= y <= 1.5625 2^-8, degree 10, 62.2 bits */
    {0x1.d9a61b3aaa812p+2, -0x1.b5466f2a89305p-52, -0x1.f7da6ac498c4cp+0, 0x1.b4828b22796e7p-1, -0x1.b445f9948102bp-2,
     0x1.d05334dbdacc9p-3, -0x1.00093281f8227p-3, 0x1.20e881389b19fp-4, -0x1.4b423c1a07ee6p-5, 0x1.80544010cc34ep-6,
     -0x1.c259e349194a2p-7, 0x1.09899932b5e4bp-7}, /* [281] 1.5625 <= y <= 1.625 2^-8, degree 10, 61.0 bits */
    {0x1.d1fb9ba1f392dp+2, 0x1.e96e48298adfbp-54, -0x1.ddcb8d79da743p+0, 0x1.8e2e7ae4a03dfp-1, -0x1.7ee6d1de9c63dp-2,
     0x1.881e4ee44f853p-3, -0x1.a01ae88301334p-4, 0x1.c3cc54c294e65p-5, -0x1.f277dfd088fdep-6, 0x1.163f541fe950bp-6,
     -0x1.39b8050a9a8a1p-7, 0x1.63fcd3aec50a5p-8}, /* [282] 1.625 <= y <= 1.6875 2^-8, degree 10, 61.2 bits */
    {0x1.cab4c030ec196p+2, 0x1.750d18067394ep-53, -0x1.c5fc0ee7f1c0dp+0, 0x1.6c76169a7c559p-1, -0x1.51b0bbf1a982dp-2,
     0x1.4d38fd07b1f17p-3, -0x1.54bc17439ef65p-4, 0x1.647ff09f13f38p-5, -0x1.7b03f1c66241p-6, 0x1.97be53141c187p-7,
     -0x1.baf9c6e659cd9p-8, 0x1.e46051470c122p-9}, /* [283] 1.6875 <= y <= 1.75 2^-8, degree 10, 62.6 bits */
    {0x1.c3c9171eaea78p+2, -0x1.99365b2cd63ep-54, -0x1.b027eeb88a1fp+0, 0x1.4ea7fb1cc3afap-1, -0x1.2b28d13702c7ep-2,
     0x1.1cd366ea84e54p-3, -0x1.1904497d7d41bp-4, 0x1.1bb1d95ea5a02p-5, -0x1.230609c20ea1bp-6, 0x1.2e179eb9726dp-7,
     -0x1.3ca8f26108ecep-8, 0x1.4e1a2edfa787cp-9}, /* [284] 1.75 <= y <= 1.8125 2^-8, degree 10, 62.9 bits */
    {0x1.bd3129dcdecbp+2, -0x1.3927e69dc20a8p-54, -0x1.9c153ba5628a2p+0, 0x1.34326eca0c68bp-1, -0x1.0a22f866bad37p-2,
     0x1.e98fc51e4e1p-4, -0x1.d29f8e8b5ba17p-5, 0x1.c716e7c1e2febp-6, -0x1.c3031483f9271p-7, 0x1.c449f386c3e84p-8,
     -0x1.ca007faebdcf6p-9, 0x1.d2d823e76f322p-10}, /* [285] 1.8125 <= y <= 1.875 2^-8, degree 10, 63.3 bits */
    {0x1.b6e65886ceaacp+2, -0x1.56f997b144486p-52, -0x1.89924f0a160c4p+0, 0x1.1c9ce58aae5b3p-1, -0x1.db5f16d71079fp-3,
     0x1.a6dd69b61e375p-4, -0x1.85d26e9a5c15bp-5, 0x1.6fb636dcdb088p-6, -0x1.60765a81caa36p-7, 0x1.55ddc2095282ap-8,
     -0x1.4ed104e8a516cp-9, 0x1.4a167596868a1p-10}, /* [286] 1.875 <= y <= 1.9375 2^-8, degree 10, 64.1 bits */
    {0x1.b0e2bba3ec9b4p+2, 0x1.081261e5377dfp-52, -0x1.787463b846244p+0, 0x1.078301ba80022p-1, -0x1.aa1b627f8bd8fp-3,
     0x1.6efc9cb7b4a7bp-4, -0x1.478ed233971c1p-5, 0x1.2b299f321f85fp-6, -0x1.15a5b4e2425cp-7, 0x1.04bf5176629d4p-8,
     -0x1.ee80a4c01317cp-10, 0x1.d80978f8060b2p-11}, /* [287] 1.9375 <= y <= 2 2^-8, degree 10, 61.0 bits */
    {0x1.a8576af531aep+2, -0x1.0f6495a1ad6f7p-55, -0x1.61153ec71fcfbp+1, 0x1.d79f9a313130bp+0, -0x1.6bebfd414c12fp+0,
     0x1.2b27f9f682a44p+0, -0x1.fdba3bfb48effp-1, 0x1.bc5cbcf18c788p-1, -0x1.89a5aa2f34f66p-1, 0x1.60dff48c3e855p-1,
     -0x1.3fde632a8bcb4p-1, 0x1.23755e7ff809cp-1}, /* [288] 1 <= y <= 1.0625 2^-7, degree 10, 60.8 bits */
    {0x1.9dbf4038bc084p+2, 0x1.7325bd0ad4fc5p-52, -0x1.459a182832c18p+1, 0x1.99d314bdbc4aap+0, -0x1.2a1997b314bc2p+0,
     0x1.ce099bd220324p-1, -0x1.731beccde5feep-1, 0x1.310477fc4edbdp-1, -0x1.fd83197e33426p-2, 0x1.aea0984aa0cd3p-2,
     -0x1.6ff37dc516f11p-2, 0x1.3c1af9698b8eep-2}, /* [289] 1.0625 <= y <= 1.125 2^-7, degree 10, 60.5 bits */
    {0x1.93f472d5834eep+2, -0x1.134ef5ec78813p-53, -0x1.2da0e19511f29p+1, 0x1.66ecbfdcdff19p+0, -0x1.edd2b4efd3cdp-1,
     0x1.69f88e5a4a8b6p-1, -0x1.130017caab5ddp-1, 0x1.ab97f56867625p-2, -0x1.51d12a420d27ap-2, 0x1.0e12f09ded08dp-2,
     -0x1.b47d9b935a592p-3, 0x1.62b5e9c9ada1ep-3}, /* [290] 1.125 <= y <= 1.1875 2^-7, degree 10, 60.8 bits */
    {0x1.8add7685f1734p+2, -0x1.7a1071d1939eap-55, -0x1.188f18e2ae575p+1, 0x1.3c8ed41a7b3efp+0, -0x1.9d1cb3cd5a3d7p-1,
     0x1.1f3fd39c715dbp-1, -0x1.9e0d64b2d9edfp-2, 0x1.316103e5d6217p-2, -0x1.c9c3700b00d67p-3, 0x1.5b30ac921edb3p-3,
     -0x1.0a2025546130fp-3, 0x1.9a57291efabc8p-4}, /* [291] 1.1875 <= y <= 1.25 2^-7, degree 10, 60.1 bits */
    {0x1.82650996a39ccp+2, -0x1.5880ff7c95351p-52, -0x1.05eb026073864p+1, 0x1.18f5632cbc5ddp+0, -0x1.5cb2af43d9a0bp-1,
     0x1.cd3728849d6a4p-2, -0x1.3c2b8f510acc1p-2, 0x1.bb9a6f5a98504p-3, -0x1.3c404dd5feefdp-3, 0x1.c84ea6c42a06fp-4,
     -0x1.4ca662bad7355p-4, 0x1.e7e2989bffb0ep-5}, /* [292] 1.25 <= y <= 1.3125 2^-7, degree 10, 59.6 bits */
    {0x1.7a79511b9926p+2, 0x1.434883388a88ap-52, -0x1.eaa708620a92ap+0, 0x1.f5943afc3e27dp-1, -0x1.28b81817252ecp-1,
     0x1.762b7d87091d2p-2, -0x1.e91acb7bc5758p-3, 0x1.47252ee99d8c9p-3, -0x1.bcbe030789c48p-4, 0x1.31eb6a94f493dp-4,
     -0x1.a93a3a320e298p-5, 0x1.2952b73918ba7p-5}, /* [293] 1.3125 <= y <= 1.375 2^-7, degree 10, 61.9 bits */
    {0x1.730b2c893956bp+2, -0x1.4315dd23893ebp-52, -0x1.ccf4993307a8ap+0, 0x1.c20c528b08ff4p-1, -0x1.fcb497beb403bp-2,
     0x1.327510a83d368p-2, -0x1.7ec3526e2ff97p-3, 0x1.e94110cb0ea57p-4, -0x1.3dc535a0f019ep-4, 0x1.a1b8adac68404p-5,
     -0x1.1560c8450eb55p-5, 0x1.72a4f58eb4853p-6}, /* [294] 1.375 <= y <= 1.4375 2^-7, degree 10, 62.0 bits */
    {0x1.6c0db1696ef0ep+2, 0x1.d44cea7ec6457p-52, -0x1.b23f1872729cbp+0, 0x1.95ba58ebdec4dp-1, -0x1.b7027051d15c8p-2,
     0x1.fa61800ede58fp-3, -0x1.2ec1a7f6c44a6p-3, 0x1.728103984f81cp-4, -0x1.ccc9df4872639p-5, 0x1.21f78395133bfp-5,
     -0x1.70a9bd46d900fp-6, 0x1.d7a6ecc3f4f8p-7}, /* [295] 1.4375 <= y <= 1.5 2^-7, degree 10, 60.7 bits */
    {0x1.6575c49190159p+2, 0x1.68d1e5045a32ep-52, -0x1.9a1d96966a5e7p+0, 0x1.6f5cf52a292f1p-1, -0x1.7d33a8829eb9p-2,
     0x1.a5b6435ae7c08p-3, -0x1.e3a7b70361a02p-4, 0x1.1bd95bf2af154p-4, -0x1.5298eecb59cacp-5, 0x1.98be54fb88868p-6,
     -0x1.f269e8cb9aecfp-7, 0x1.31ce5e2f8cb38p-7}, /* [296] 1.5 <= y <= 1.5625 2^-7, degree 10, 62.9 bits */
    {0x1.5f39c95b41f7dp+2, -0x1.c02a96a513502p-53, -0x1.8439111461825p+0, 0x1.4df4df6e98d5dp-1, -0x1.4ce2c43ebbfap-2,
     0x1.61c8d37dc54dap-3, -0x1.85d0452b55845p-4, 0x1.b7965e817e2c9p-5, -0x1.f7cb440e34987p-6, 0x1.24264279e4bbep-6,
     -0x1.563d5bd01640ep-7, 0x1.937df16308e3fp-8}, /* [297] 1.5625 <= y <= 1.625 2^-7, degree 10, 61.3 bits */
    {0x1.595161803d5aap+2, 0x1.644933c7c3c1fp-52, -0x1.7048d3c9469e7p+0, 0x1.30b55e67d204cp-1, -0x1.243794762bcc2p-2,
     0x1.2ad058bfd4173p-3, -0x1.3cccf370d3391p-4, 0x1.57c1631886e1bp-5, -0x1.7b15f8c39d5dcp-6, 0x1.a70f9e742599bp-7,
     -0x1.dcdae49219115p-8, 0x1.0e7ce40bc9d3p-8}, /* [298] 1.625 <= y <= 1.6875 2^-7, degree 10, 60.5 bits */
    {0x1.53b539af38eb2p+2, 0x1.a5b52a61bf436p-56, -0x1.5e0fb03003804p+0, 0x1.16f8d468d091fp-1, -0x1.01c2e4d4e4f5fp-2,
     0x1.fbf1183002b14p-4, -0x1.03737c143abd8p-4, 0x1.0f470013b4bcdp-5, -0x1.204558ce594d4p-6, 0x1.3601443e0096ap-7,
     -0x1.50b0ff7efff2dp-8, 0x1.7011a9c520482p-9}, /* [299] 1.6875 <= y <= 1.75 2^-7, degree 10, 61.0 bits */
    {0x1.4e5edff715c3ap+2, -0x1.435c17064dfbbp-53, -0x1.4d59d3555422fp+0, 0x1.003831c2f9ee6p-1, -0x1.c8c8ce8957432p-3,
     0x1.b23bebe0cc84bp-4, -0x1.ac034dc6081d3p-5, 0x1.afcd3081b0657p-6, -0x1.babc976277db1p-7, 0x1.cb66457b5b4d7p-8,
     -0x1.e167db01ab878p-9, 0x1.fbcbb380abd5p-10}, /* [300] 1.75 <= y <= 1.8125 2^-7, degree 10, 60.8 bits */
    {0x1.4948a1e0a339fp+2, 0x1.703ac6c338011p-57, -0x1.3dfb130711a57p+0, 0x1.d808fd31501f7p-2, -0x1.966f79d877c79p-3,
     0x1.753d03473a14bp-4, -0x1.636617353c351p-5, 0x1.5a60425a06a22p-6, -0x1.571921d41d9bdp-7, 0x1.57ef39aa5d31dp-8,
     -0x1.5c2b73943a2cap-9, 0x1.62ccfdce9e677p-10}, /* [301] 1.8125 <= y <= 1.875 2^-7, degree 10, 62.2 bits */
    {0x1.446d709674613p+2, -0x1.abc562fcfd3b3p-52, -0x1.2fcd9589abc1ep+0, 0x1.b403d8886ca61p-2, -0x1.6b0d043cd6025p-3,
     0x1.426fb7292afa3p-4, -0x1.28f0e56478f3cp-5, 0x1.17e6ef6a9f176p-6, -0x1.0c279d441bdb9p-7, 0x1.03fd1ddc0d2f6p-8,
     -0x1.fd176765a4764p-10, 0x1.f5c50a04f065ep-11}, /* [302] 1.875 <= y <= 1.9375 2^-7, degree 10, 60.4 bits */
    {0x1.3fc8c9dd049f4p+2, -0x1.5720f8a226ad7p-53, -0x1.22b0beb81877ep+0, 0x1.93c810b9db577p-2, -0x1.457bdae68d675p-3,
     0x1.17de9866c31fp-4, -0x1.f31610c0b51d1p-6, 0x1.c77e8c05e2d7dp-7, -0x1.a682e3bafb6bdp-8, 0x1.8ca176030b638p-9,
     -0x1.77fa5c4e9d3cfp-10, 0x1.66ccff079e25ap-11}, /* [303] 1.9375 <= y <= 2 2^-7, degree 10, 60.3 bits */
    {0x1.392f5d863f82cp+2, -0x1.4c6bd374a4d3p-56, -0x1.10c7f7f2a1ce9p+1, 0x1.697563ce64305p+0, -0x1.160e3b9b5c5fdp+0,
     0x1.c86119ba82892p-1, -0x1.84656c5711311p-1, 0x1.5256e43eb66p-1, -0x1.2b8f7366d058ep-1, 0x1.0c6b54d0edf0cp-1,
     -0x1.e675c17ae8ca5p-2, 0x1.bb2165ba04df6p-2}, /* [304] 1 <= y <= 1.0625 2^-6, degree 10, 59.3 bits */
    {0x1.30ff59121b7e1p+2, -0x1.0f75d805575d9p-56, -0x1.f76df161b4cbcp+0, 0x1.3a3baee107798p+0, -0x1.c7aecd33534aap-1,
     0x1.6087c968a712fp-1, -0x1.1ad7503ffcfd4p-1, 0x1.d094c1a1c34edp-2, -0x1.83ce1d5bca74dp-2, 0x1.479e68afb2d0ap-2,
     -0x1.17d604b3743b7p-2, 0x1.e0ac493fc193ep-3}, /* [305] 1.0625 <= y <= 1.125 2^-6, degree 10, 61.7 bits */
    {0x1.296ccad196016p+2, -0x1.286d5dc61abe9p-53, -0x1.d2a88acc906b5p+0, 0x1.1352d707a2e39p+0, -0x1.798f56d4a94cap-1,
     0x1.14418beed1fb1p-1, -0x1.a348270f224fcp-2, 0x1.45b51b2edfca1p-2, -0x1.012b9dde6f5b4p-2, 0x1.9b02ae45a1a06p-3,
     -0x1.4c036007d2a2bp-3, 0x1.0dba08bd657dcp-3}, /* [306] 1.125 <= y <= 1.1875 2^-6, degree 10, 60.2 bits */
    {0x1.22642b35c7b64p+2, 0x1.f93ab07140e93p-53, -0x1.b253edf750b78p+0, 0x1.e5da3d1a2f4f2p-1, -0x1.3bf4119e634ebp-1,
     0x1.b6931720ee2f3p-2, -0x1.3bb78df82aed6p-2, 0x1.d152749f2ab0bp-3, -0x1.5c8ba256ab6afp-3, 0x1.083a6dfee036cp-3,
     -0x1.94e9fe7d669dp-4, 0x1.38127b0cc8543p-4}, /* [307] 1.1875 <= y <= 1.25 2^-6, degree 10, 62.5 bits */
    {0x1.1bd53918c88fdp+2, 0x1.e3ca41b9f5d1cp-58, -0x1.95b645058bbb9p+0, 0x1.af63ef1b3994ep-1, -0x1.0ac5ecd264893p-1,
     0x1.602fabbd367dcp-2, -0x1.e2458cc7ee591p-3, 0x1.5209c8fc89116p-3, -0x1.e1adf00cc1df4p-4, 0x1.5b53f73151ae4p-4,
     -0x1.fa351bf410e65p-5, 0x1.7319513311785p-5}, /* [308] 1.25 <= y <= 1.3125 2^-6, degree 10, 64.7 bits */
    {0x1.15b24c12b12c6p+2, 0x1.739d24bbcfa74p-52, -0x1.7c3b4a57c342ap+0, 0x1.8138aff38dd6ep-1, -0x1.c6275e964b6d7p-2,
     0x1.1dca9bfff111p-2, -0x1.751ca4f0da5ecp-3, 0x1.f2af7e9d7e815p-4, -0x1.52c04824f5cfdp-4, 0x1.d1c9fada83c8bp-5,
     -0x1.4397424aa8a7p-5, 0x1.c45d544d10a91p-6}, /* [309] 1.3125 <= y <= 1.375 2^-6, degree 10, 60.4 bits */
    {0x1.0fefd10186f31p+2, 0x1.733da2b29acp-52, -0x1.656b5e44c8ea9p+0, 0x1.59c784e93a0b3p-1, -0x1.856d44bbceacp-2,
     0x1.d4436ca5363c6p-3, -0x1.240d9dcc65e9cp-3, 0x1.74f86cc48dedep-4, -0x1.e42988c65e2abp-5, 0x1.3e0efe76101c5p-5,
     -0x1.a6389e1bd3088p-6, 0x1.19ff6ddb9b5ecp-6}, /* [310] 1.375 <= y <= 1.4375 2^-6, degree 10, 60.7 bits */
    {0x1.0a83e5217a907p+2, 0x1.4bb9e7ced5026p-53, -0x1.50e503fe3698fp+0, 0x1.37d89f24bca9p-1, -0x1.502c50d2ec27bp-2,
     0x1.82f7e5ba812aep-3, -0x1.ce1d0d05b95e6p-4, 0x1.1a7f70a53690ep-4, -0x1.5f180c17d9168p-5, 0x1.b9a3442dfe4fdp-6,
     -0x1.18a088a60a342p-6, 0x1.66e52644fafb3p-7}, /* [311] 1.4375 <= y <= 1.5 2^-6, degree 10, 60.2 bits */
    {0x1.056607a18d28dp+2, 0x1.25e23ca520289p-52, -0x1.3e580d9cf2565p+0, 0x1.1a76c7762c619p-1, -0x1.23fdf9c6c4ccep-2,
     0x1.42582bfae9617p-3, -0x1.71313e5fcc41ap-4, 0x1.b0eee1db12b49p-5, -0x1.0208e7b39dae3p-5, 0x1.3751970528527p-6,
     -0x1.7b7273008d6f1p-7, 0x1.d174c824036b2p-8}, /* [312] 1.5 <= y <= 1.5625 2^-6, degree 10, 62.3 bits */
    {0x1.008edbffc6371p+2, 0x1.1154554f6b4c2p-54, -0x1.2d81fb6238865p+0, 0x1.00df262d8ad32p-1, -0x1.fe1ce5193d8d7p-3,
     0x1.0e7cd1da70f17p-3, -0x1.299f11acb50bap-4, 0x1.4f4bce8d2f888p-5, -0x1.7ffd600412ba8p-6, 0x1.bd18f1053c008p-7,
     -0x1.0496295a4e561p-7, 0x1.331c1859cb43ap-8}, /* [313] 1.5625 <= y <= 1.625 2^-6, degree 10, 60.0 bits */
    {0x1.f7eff2292d653p+1, -0x1.cf74c52b2598p-54, -0x1.1e2b392ae0cb7p+0, 0x1.d4eae31dd3d2cp-2, -0x1.bfeb37f41990cp-3,
     0x1.c906ed5421f44p-4, -0x1.e3d9f8ad638d8p-5, 0x1.063f686a6bbbdp-5, -0x1.20fc23b126e24p-6, 0x1.425205737ecc7p-7,
     -0x1.6b227a319e491p-8, 0x1.9bce24328d35p-9}, /* [314] 1.625 <= y <= 1.6875 2^-6, degree 10, 60.7 bits */
    {0x1.ef3783a439272p+1, 0x1.6b794dc19a0d1p-54, -0x1.1024fed0ee8ffp+0, 0x1.ad76684b87624p-2, -0x1.8b36b4be63b09p-3,
     0x1.84880bd63b2eep-4, -0x1.8c57581c8d7e9p-5, 0x1.9dfbda1703eeap-6, -0x1.b7949f20cb011p-7, 0x1.d870d4eac1ba1p-8,
     -0x1.006e9a7d79f92p-8, 0x1.183825351e185p-9}, /* [315] 1.6875 <= y <= 1.75 2^-6, degree 10, 60.1 bits */
    {0x1.e6ea8b085250cp+1, -0x1.43bfa6dbb30b9p-53, -0x1.0347a989fcf51p+0, 0x1.8a928f731e877p-2, -0x1.5e476eafee785p-3,
     0x1.4c3a3f7ced929p-4, -0x1.46fbfacfd4efbp-5, 0x1.4988c8ee9d5d2p-6, -0x1.519d9053ce8f9p-7, 0x1.5e1bb8eb2a0a8p-8,
     -0x1.6eb2f13dbdc37p-9, 0x1.82a504b62be56p-10}, /* [316] 1.75 <= y <= 1.8125 2^-6, degree 10, 61.3 bits */
    {0x1.df004bd913bb6p+1, 0x1.f625deb68f026p-54, -0x1.eee2e0538fa13p-1, 0x1.6b95d06c85882p-2, -0x1.37c0dd5ceda55p-3,
     0x1.1d9ff66787a2dp-4, -0x1.0f9036d3eb9a9p-5, 0x1.08630bf661da9p-6, -0x1.05ad0044751e4p-7, 0x1.06266aceba70ep-8,
     -0x1.093eb2a289c37p-9, 0x1.0e2f4fda62e84p-10}, /* [317] 1.8125 <= y <= 1.875 2^-6, degree 10, 61.6 bits */
    {0x1.d77103fc12408p+1, 0x1.43d000bc09e76p-55, -0x1.d90ab8d2a383p-1, 0x1.4ff3e1e89a3efp-2, -0x1.168c98aa34083p-3,
     0x1.ed9b21d8aed17p-5, -0x1.c5e0d4184bc3dp-6, 0x1.ab5e71fedddacp-7, -0x1.991941d4d29acp-8, 0x1.8c6350b9cb038p-9,
     -0x1.83e3df06de1bp-10, 0x1.7e265da0168cap-11}, /* [318] 1.875 <= y <= 1.9375 2^-6, degree 10, 61.8 bits */
    {0x1.d035c887bb7e4p+1, -0x1.b066ea3fd4338p-53, -0x1.c4d4f239c5631p-1, 0x1.3737ed6dad8a4p-2, -0x1.f3950ddd7fba6p-4,
     0x1.ac89316e71bb3p-5, -0x1.7d80b2e6b7f84p-6, 0x1.5bcb8eb4f167bp-7, -0x1.4257ac4ff4497p-8, 0x1.2e66a65bd54b5p-9,
     -0x1.1e812d660f35cp-10, 0x1.114c0c960d89ep-11}, /* [319] 1.9375 <= y <= 2 2^-6, degree 10, 61.1 bits */
    {0x1.c5ed28142e0ddp+1, -0x1.977c87ea84fa3p-53, -0x1.a937bf8af6992p+0, 0x1.16bb582b5db8dp+0, -0x1.aaf2e66d40c7p-1,
     0x1.5d844b6f784d2p-1, -0x1.28f983e9fdd0dp-1, 0x1.0267dbaecc363p-1, -0x1.c92f61fe930fap-2, 0x1.9962414c4831cp-2,
     -0x1.72c3e72d1748cp-2, 0x1.5197299e3653dp-2}, /* [320] 1 <= y <= 1.0625 2^-5, degree 10, 60.1 bits */
    {0x1.b9286ef2b727p+1, 0x1.b6f980a3115d7p-53, -0x1.88b7c94207515p+0, 0x1.e4eeafe1e0c58p-1, -0x1.5e053d5b2dd47p-1,
     0x1.0e19225b3c82p-1, -0x1.b0b08f1923eeep-2, 0x1.62f04a16dca9dp-2, -0x1.2804f1c5e5f94p-2, 0x1.f3cefd761a6a4p-3,
     -0x1.aaac1f1d2b5adp-3, 0x1.6e46f06c7aeb3p-3}, /* [321] 1.0625 <= y <= 1.125 2^-5, degree 10, 60.2 bits */
    {0x1.ad56b48ebd188p+1, 0x1.2335e09f62e76p-53, -0x1.6c56207a62951p+0, 0x1.a924c4933db92p-1, -0x1.222738d61eacep-1,
     0x1.a77df3de9fa8fp-2, -0x1.40d2c793ed2a9p-2, 0x1.f1d6a9aa51214p-3, -0x1.88b869f66eaaap-3, 0x1.399914b3a86a9p-3,
     -0x1.fa5a444ca4b84p-4, 0x1.9b2997cffa8cbp-4}, /* [322] 1.125 <= y <= 1.1875 2^-5, degree 10, 60.0 bits */
    {0x1.a259f6aaebc2ap+1, -0x1.8b86a9ff9af7p-53, -0x1.535e121db08ddp+0, 0x1.775673fe46d64p-1, -0x1.e5d8e4d02bb3bp-2,
     0x1.504ba04174b77p-2, -0x1.e353780fbd8f9p-3, 0x1.63bae4d9ab1f6p-3, -0x1.0a3455f75e248p-3, 0x1.9350414026cfap-4,
     -0x1.34d75cd687dbp-4, 0x1.dbd1ca7f59ec1p-5}, /* [323] 1.1875 <= y <= 1.25 2^-5, degree 10, 61.4 bits */
    {0x1.981938409241p+1, -0x1.91acd366d9251p-53, -0x1.3d412713c4757p+0, 0x1.4d746036392c5p-1, -0x1.9a6932a228de2p-2,
     0x1.0e28c6039dfaep-2, -0x1.714710e72c27p-3, 0x1.0280d25596561p-3, -0x1.6ffd341c7ce17p-4, 0x1.0925417ef4a57p-4,
     -0x1.823146c64d363p-5, 0x1.1af87c0a5b237p-5}, /* [324] 1.25 <= y <= 1.3125 2^-5, degree 10, 60.6 bits */
    {0x1.8e7f77b0e6125p+1, 0x1.0d87dbcf50c3dp-57, -0x1.298da8b177d69p+0, 0x1.29eedb1eaa5ccp-1, -0x1.5d7f8eb23bf69p-2,
     0x1.b69fe4e27ed18p-3, -0x1.1dca1758200b6p-3, 0x1.7d77a9d52f29ep-4, -0x1.02ddde8adcf6ep-4, 0x1.63aa913218fdep-5,
     -0x1.eddbc4acac388p-6, 0x1.590366f580ca6p-6}, /* [325] 1.3125 <= y <= 1.375 2^-5, degree 10, 59.6 bits */
    {0x1.857ae57aa8728p+1, -0x1.dcab0770f70e5p-54, -0x1.17e7cfc4e0f81p+0, 0x1.0b92d11720fc7p-1, -0x1.2bd19625e51eep-2,
     0x1.67792802f14f2p-3, -0x1.bf8ce2f9d8796p-4, 0x1.1d62e55c0bbp-4, -0x1.72160ad607667p-5, 0x1.e5d846b64d02fp-6,
     -0x1.424449c28d5ecp-6, 0x1.ae3ea564df058p-7}, /* [326] 1.375 <= y <= 1.4375 2^-5, degree 10, 59.8 bits */
    {0x1.7cfc49adf92cap+1, -0x1.ce7d754aa6828p-53, -0x1.0804c993d531ap+0, 0x1.e2e2c81e2a156p-2, -0x1.02ee118965615p-2,
     0x1.292c991e31443p-3, -0x1.6231226b816c9p-4, 0x1.b0719246a752p-5, -0x1.0c7100e6f5245p-5, 0x1.5163c4e0df31cp-6,
     -0x1.ac7b69429e8cp-7, 0x1.11d74ebba7aap-7}, /* [327] 1.4375 <= y <= 1.5 2^-5, degree 10, 61.1 bits */
    {0x1.74f68bc66d694p+1, 0x1.8bd913fed4959p-53, -0x1.f34e0ca2f5931p-1, 0x1.b59d53ee8c69p-2, -0x1.c1fd7088b7833p-3,
     0x1.ef4514fb2f2c2p-4, -0x1.1b0fa2ccdbd94p-4, 0x1.4b754694a8b7cp-5, -0x1.8aae7973a9628p-6, 0x1.dbc725902ea98p-7,
     -0x1.21bf7564de72dp-7, 0x1.6338c17977102p-8}, /* [328] 1.5 <= y <= 1.5625 2^-5, degree 10, 63.8 bits */
    {0x1.6d5e54328dfbep+1, 0x1.cddea9fb51005p-53, -0x1.d936e4c7973ebp-1, 0x1.8e2a8d3839b1ap-2, -0x1.893ae3b9edfe6p-3,
     0x1.9fbd817f23e6bp-4, -0x1.c884375eec144p-5, 0x1.00c722304ef56p-5, -0x1.25be67b583819p-6, 0x1.5431829311deep-7,
     -0x1.8e0eaae3f52bfp-8, 0x1.d4d93d466601p-9}, /* [329] 1.5625 <= y <= 1.625 2^-5, degree 10, 63.5 bits */
    {0x1.6629c145dd974p+1, 0x1.81485b3148c75p-53, -0x1.c16eb3152dbfbp-1, 0x1.6b9ac445c553fp-2, -0x1.596cfe6fd2f4cp-3,
     0x1.5f58f27f19704p-4, -0x1.7332f704947c1p-5, 0x1.91c80da748566p-6, -0x1.ba3eb549546a7p-7, 0x1.ecd208c60b2f6p-8,
     -0x1.15695303c0771p-8, 0x1.3a67655d47f36p-9}, /* [330] 1.625 <= y <= 1.6875 2^-5, degree 10, 61.5 bits */
    {0x1.5f502b0616d99p+1, 0x1.594b1ab76bc43p-55, -0x1.abad8d412b234p-1, 0x1.4d2bf931fcf75p-2, -0x1.30e6ac7e22926p-3,
     0x1.2acaa83b307a7p-4, -0x1.30278d780f49ep-5, 0x1.3d361dd2f2de2p-6, -0x1.506fbfd3791b6p-7, 0x1.6941ec8e19c96p-8,
     -0x1.87e0b2d836b46p-9, 0x1.abf773777dbf2p-10}, /* [331] 1.6875 <= y <= 1.75 2^-5, degree 10, 60.8 bits */
    {0x1.58c9f2763d60fp+1, 0x1.d0610dfc6101fp-55, -0x1.97b67fd2522b4p-1, 0x1.323fe2190e65dp-2, -0x1.0e56e43f0ed06p-3,
     0x1.ff27afac80f72p-5, -0x1.f601d730a3c6cp-6, 0x1.f923bb75c5ae9p-7, -0x1.02759ad3dfc78p-7, 0x1.0bc64009543cep-8,
     -0x1.184073f92d9c9p-9, 0x1.274f6479c324dp-10}, /* [332] 1.75 <= y <= 1.8125 2^-5, degree 10, 61.0 bits */
    {0x1.529059dc1afcdp+1, 0x1.b387b3cf4b92ap-53, -0x1.855591d3087afp-1, 0x1.1a546103d7b94p-2, -0x1.e1651c7a849bcp-4,
     0x1.b798f81983d4dp-5, -0x1.a10ad2ac10a08p-6, 0x1.9561bb26873d1p-7, -0x1.90be8266346a3p-8, 0x1.91172bcf9cfb6p-9,
     -0x1.9583549ec04d5p-10, 0x1.9ccd0e0caed87p-11}, /* [333] 1.8125 <= y <= 1.875 2^-5, degree 10, 62.0 bits */
    {0x1.4c9d641a2cdbbp+1, -0x1.10e46234ce78cp-53, -0x1.745e32285f9e5p-1, 0x1.04fdc21e298b6p-2, -0x1.ae4883ffbecc3p-4,
     0x1.7bf85da6dfc67p-5, -0x1.5c9ca550660c7p-6, 0x1.47b97db6af7f1p-7, -0x1.3954d83f4263dp-8, 0x1.2f4daa48ca92ap-9,
     -0x1.289169eb12402p-10, 0x1.23fd1213df60ep-11}, /* [334] 1.875 <= y <= 1.9375 2^-5, degree 10, 60.5 bits */
    {0x1.46ebb9ab193cep+1, 0x1.478285b11845dp-55, -0x1.64a9f5f3f9f06p-1, 0x1.e3c4970f81c44p-3, -0x1.8200589e43f05p-4,
     0x1.49fc17ca1d908p-5, -0x1.251abf706effp-6, 0x1.0ac58c5f0f22cp-7, -0x1.ede213759d20dp-9, 0x1.cedfd2a92e553p-10,
     -0x1.b631025a4702fp-11, 0x1.a1b69caa54a2dp-12}, /* [335] 1.9375 <= y <= 2 2^-5, degree 10, 60.5 bits */
    {0x1.3ed1533b62e6cp+1, -0x1.51d47b5189afep-53, -0x1.4f31e4ec32c0fp+0, 0x1.b18d9e54f9161p-1, -0x1.4a0f16eb253aep-1,
     0x1.0d435b017b954p-1, -0x1.c8837acd52e54p-2, 0x1.8c8fbb3687acdp-2, -0x1.5e5cb781b02bbp-2, 0x1.3969e2823ad5bp-2,
     -0x1.1b9d4f7f952adp-2, 0x1.020faaa239ec4p-2}, /* [336] 1 <= y <= 1.0625 2^-4, degree 10, 59.8 bits */
    {0x1.34bf3f2e05008p+1, 0x1.1560af5bee43fp-53, -0x1.35e890f50fdc9p+0, 0x1.79767d5822954p-1, -0x1.0ec6f18b651fp-1,
     0x1.a069605907a69p-2, -0x1.4cbf391d40c79p-2, 0x1.107c2e6ef159ep-2, -0x1.c5e8a6be34ca4p-3, 0x1.7ecc5331437f1p-3,
     -0x1.468178d17e6a2p-3, 0x1.1817440e22879p-3}, /* [337] 1.0625 <= y <= 1.125 2^-4, degree 10, 60.2 bits */
    {0x1.2b6a4ebdfa4a1p+1, 0x1.5185e1e5c8504p-56, -0x1.1fced4cdd5343p+0, 0x1.4b31e0ebf66d8p-1, -0x1.c13b032e08b4fp-2,
     0x1.46a42af55444fp-2, -0x1.edb260961024bp-3, 0x1.7e5ea0b18f268p-3, -0x1.2d397f2b8982cp-3, 0x1.e08e4f08b7904p-4,
     -0x1.83a01f1d0b629p-4, 0x1.3a867b9ac9082p-4}, /* [338] 1.125 <= y <= 1.1875 2^-4, degree 10, 59.9 bits */
    {0x1.22bb49175a3cdp+1, 0x1.768bbe2c26f3ep-54, -0x1.0c595c5b31d11p+0, 0x1.24a05e78fe97fp-1, -0x1.785a89bacfddcp-2,
     0x1.0388b60c53b4ap-2, -0x1.74120c9bad426p-3, 0x1.11590c7319a3cp-3, -0x1.988a9c6b90bedp-4, 0x1.35239654248bcp-4,
     -0x1.d9064e23da219p-5, 0x1.6c1c709b9fd47p-5}, /* [339] 1.1875 <= y <= 1.25 2^-4, degree 10, 59.4 bits */
    {0x1.1a9ed4a462b12p+1, 0x1.1ae17860b2d69p-54, -0x1.f6347c6874674p-1, 0x1.042c1ae22bcb2p-1, -0x1.3e1ed92d45e18p-2,
     0x1.a1380f6f9d2e3p-3, -0x1.1c6a5602ec7a7p-3, 0x1.8d7418af4a5d9p-4, -0x1.1a7dce0144d83p-4, 0x1.969f795d3eab9p-5,
     -0x1.27dab4fe7d2b9p-5, 0x1.b1388ac4d9cbdp-6}, /* [340] 1.25 <= y <= 1.3125 2^-4, degree 10, 62.5 bits */
    {0x1.1304aa7ec226ap+1, -0x1.f459d12f7b0afp-53, -0x1.d773659f8d814p-1, 0x1.d142af01eecbdp-2, -0x1.0f12b7ecb1832p-2,
     0x1.52e07134fd802p-3, -0x1.b870724f15ccbp-4, 0x1.2562ac0068c2fp-4, -0x1.8d9ae5f8e8188p-5, 0x1.10d30892e6cb5p-5,
     -0x1.7a77c290a8446p-6, 0x1.0830c09367bd8p-6}, /* [341] 1.3125 <= y <= 1.375 2^-4, degree 10, 62.5 bits */
    {0x1.0bdefb734ef3ep+1, -0x1.483b0d68df08bp-53, -0x1.bbe1aee7b8482p-1, 0x1.a2270ac663ed5p-2, -0x1.d15cdf072930dp-3,
     0x1.15df1e4678879p-3, -0x1.59079d965c446p-4, 0x1.b72afa8e0e9bep-5, -0x1.1c540d9904176p-5, 0x1.74d188619e68ep-6,
     -0x1.ee1b6f043f618p-7, 0x1.498fe41083304p-7}, /* [342] 1.375 <= y <= 1.4375 2^-4, degree 10, 60.8 bits */
    {0x1.0521f8f430509p+1, 0x1.8ebfb4abf637bp-53, -0x1.a30bb3c14777dp-1, 0x1.7995153e293cdp-2, -0x1.92221e6c8d9cep-3,
     0x1.cbaa57d06d9f1p-4, -0x1.112ece25222cfp-4, 0x1.4cdf9d6be474fp-5, -0x1.9ca243a560801p-6, 0x1.02fe2ed585172p-6,
     -0x1.489714f0a498cp-7, 0x1.a3a692aa8d402p-8}, /* [343] 1.4375 <= y <= 1.5 2^-4, degree 10, 62.3 bits */
    {0x1.fd86f0fee37e6p+0, -0x1.12088132d8e37p-57, -0x1.8c9241f7deacep-1, 0x1.566b0290b6d25p-2, -0x1.5da159ed235cbp-3,
     0x1.7f3b21354b2e2p-4, -0x1.b4d6903ddaa87p-5, 0x1.fe7d4a695d244p-6, -0x1.2f74e74c15916p-6, 0x1.6d5a83deaea5ep-7,
     -0x1.bc8b7cadd6221p-8, 0x1.104430df865a9p-8}, /* [344] 1.5 <= y <= 1.5625 2^-4, degree 10, 60.9 bits */
    {0x1.f175558e0c7f8p+0, 0x1.a8b8b2ef5768dp-55, -0x1.782653c07576fp-1, 0x1.37c260f2ad9ccp-2, -0x1.31b32ea082376p-3,
     0x1.41d9abf63df25p-4, -0x1.606b0dd8d90d9p-5, 0x1.8ba18ecf9c57dp-6, -0x1.c3ddb9e8b8a69p-7, 0x1.0553d6554410ap-7,
     -0x1.317547be95da3p-8, 0x1.6777b74031ebcp-9}, /* [345] 1.5625 <= y <= 1.625 2^-4, degree 10, 61.9 bits */
    {0x1.e5ffc39545797p+0, -0x1.4ab2ee61af00ep-54, -0x1.6585cef4e92b7p-1, 0x1.1ce233f1c2afdp-2, -0x1.0caed9c9df62ep-3,
     0x1.1021621b0147bp-4, -0x1.1eade1c7abbd1p-5, 0x1.35a519a5452f5p-6, -0x1.5446d3cac91bbp-7, 0x1.7ab3315e789c1p-8,
     -0x1.a9e424852e5d1p-9, 0x1.e240e87a4c9f9p-10}, /* [346] 1.625 <= y <= 1.6875 2^-4, degree 10, 60.4 bits */
    {0x1.db18c4c453b73p+0, -0x1.7e7dc8896c351p-57, -0x1.547903e74642fp-1, 0x1.0534b0f8bf65dp-2, -0x1.da937ee3e0c3ep-4,
     0x1.cf10d90809d16p-5, -0x1.d5ffd657d6508p-6, 0x1.e92043876d17bp-7, -0x1.02f4fd4b9bb03p-7, 0x1.15b1ee515f538p-8,
     -0x1.2ce7e846fdd78p-9, 0x1.4851913ca701p-10}, /* [347] 1.6875 <= y <= 1.75 2^-4, degree 10, 60.4 bits */
    {0x1.d0b47d4492924p+0, -0x1.4b46afd46dc34p-55, -0x1.44d0ba917c02ap-1, 0x1.e07f258ded6dep-3, -0x1.a5002971b8f5cp-4,
     0x1.8c466c5c963f7p-5, -0x1.84072a868e386p-6, 0x1.85996c334607bp-7, -0x1.8e03ca3490c3p-8, 0x1.9bce485db940fp-9,
     -0x1.ae84c404559bbp-10, 0x1.c53b3a62bd731p-11}, /* [348] 1.75 <= y <= 1.8125 2^-4, degree 10, 61.7 bits */
    {0x1.c6c86e58b3b06p+0, 0x1.c43e4472e1436p-57, -0x1.3664aac89be6cp-1, 0x1.bb3c985810b2cp-3, -0x1.7707c9909b5afp-4,
     0x1.54f41d4dc6772p-5, -0x1.427c39dd87081p-6, 0x1.38c6880795d78p-7, -0x1.34ab6a4252a53p-8, 0x1.3483b173b97abp-9,
     -0x1.3790d0ee5bd9dp-10, 0x1.3cddd165f5898p-11}, /* [349] 1.8125 <= y <= 1.875 2^-4, degree 10, 60.2 bits */
    {0x1.bd4b43e710f68p+0, 0x1.040a2c70ee33ep-57, -0x1.291245bf880a6p-1, 0x1.99fb32fcbf158p-3, -0x1.4f612071c7bbp-4,
     0x1.26d632debe306p-5, -0x1.0dad8b8c61e96p-6, 0x1.f9e6ebb069d1ep-8, -0x1.e2d8505fea817p-9, 0x1.d2be2eb2bba84p-10,
     -0x1.c7db4c6d83e8p-11, 0x1.c0632af0b308cp-12}, /* [350] 1.875 <= y <= 1.9375 2^-4, degree 10, 63.5 bits */
    {0x1.b434aab38551cp+0, -0x1.bae9a708db40ep-61, -0x1.1cbbbdef74f8cp-1, 0x1.7c302b4f08c01p-3, -0x1.2d02fd9cfd195p-4,
     0x1.00296a2561dcdp-5, -0x1.c5a7ba78e1d06p-7, 0x1.9bf55319919afp-8, -0x1.7caa2ac5eabc9p-9, 0x1.6442e7df344ddp-10,
     -0x1.50df3d26fa9fcp-11, 0x1.40d0e41f64d98p-12}, /* [351] 1.9375 <= y <= 2 2^-4, degree 10, 63.5 bits */
    {0x1.a742fa57e2f3cp+0, 0x1.498edec2b40ccp-55, -0x1.0bda9ef1e5e81p+0, 0x1.55041626cfafcp-1, -0x1.01923355df3cap-1,
     0x1.a250a7a11b8efp-2, -0x1.617d665ebc22cp-2, 0x1.325a94b62e259p-2, -0x1.0e2d4c4bf3d76p-2, 0x1.e2ac121bf8e75p-3,
     -0x1.b44285939863ep-3, 0x1.8c8eb9b200818p-3}, /* [352] 1 <= y <= 1.0625 2^-3, degree 10, 59.5 bits */
    {0x1.9728293908aa2p+0, -0x1.23053182ab091p-58, -0x1.efe86565661edp-1, 0x1.29397bf53e0ebp-1, -0x1.a702171ea18bap-2,
     0x1.43b9a335a88e8p-2, -0x1.01d89bcee5261p-2, 0x1.a54a9ac49f277p-3, -0x1.5e3f70b90cfdap-3, 0x1.26f062b46b581p-3,
     -0x1.f68453ea226adp-4, 0x1.aea35101d9c92p-4}, /* [353] 1.0625 <= y <= 1.125 2^-3, degree 10, 61.8 bits */
    {0x1.883733dc91d21p+0, 0x1.1f87220c75c51p-55, -0x1.cd15a135b2592p-1, 0x1.0511a37a96515p-1, -0x1.5f34e93132412p-2,
     0x1.fc46aa4741e3dp-3, -0x1.7ed7949645755p-3, 0x1.27c9d6749667fp-3, -0x1.d126e23f7bde5p-4, 0x1.727924e5dee63p-4,
     -0x1.2a746241febbbp-4, 0x1.e3d468c996985p-5}, /* [354] 1.125 <= y <= 1.1875 2^-3, degree 10, 60.8 bits */
    {0x1.7a4bcf7f61053p+0, -0x1.0991028aaa84cp-58, -0x1.ae643c0d2a6ap-1, 0x1.cdcea72909ccbp-2, -0x1.267c245e8ac4cp-2,
     0x1.9429c9c4128d6p-3, -0x1.20ba33157664ap-3, 0x1.a72d7fa0b1dddp-4, -0x1.3b9fcebf5766fp-4, 0x1.dcea0bc31e671p-5,
     -0x1.6c66a5aead2fbp-5, 0x1.18319d8b8f1ddp-5}, /* [355] 1.1875 <= y <= 1.25 2^-3, degree 10, 62.9 bits */
    {0x1.6d47b7b53abe5p+0, 0x1.5b6e23a8f9b27p-54, -0x1.93291f4d30189p-1, 0x1.9aff750379f7cp-2, -0x1.f240ade95d964p-3,
     0x1.451a3b22b6c71p-3, -0x1.b9b67ea63048ep-4, 0x1.33d8d4e3a5b35p-4, -0x1.b4bd407f35bb5p-5, 0x1.39d2cfec37097p-5,
     -0x1.c810d62140777p-6, 0x1.4d89e5203acecp-6}, /* [356] 1.25 <= y <= 1.3125 2^-3, degree 10, 60.0 bits */
    {0x1.61117112b3bf6p+0, -0x1.5c2f954d1c3c7p-55, -0x1.7adb8d3558a5ap-1, 0x1.6fd7edb7129f2p-2, -0x1.a8e8347d9d41fp-3,
     0x1.083f8d765861fp-3, -0x1.563d13bb242adp-4, 0x1.c6c245b6d6f83p-5, -0x1.3387388af73e4p-5, 0x1.a55847aff0fd1p-6,
     -0x1.23dace4997e3dp-6, 0x1.96ff28366aff2p-7}, /* [357] 1.3125 <= y <= 1.375 2^-3, degree 10, 59.7 bits */
    {0x1.5593589364fccp+0, 0x1.80bb4395cf35p-54, -0x1.650d044650fd3p-1, 0x1.4ae892db267b1p-2, -0x1.6d033b96e09ccp-3,
     0x1.b1a9107c778c6p-4, -0x1.0c45ff88bbf67p-4, 0x1.5490b36abdc35p-5, -0x1.b8123c53e26abp-6, 0x1.20094e0116711p-6,
     -0x1.7d37757e31a5cp-7, 0x1.fbf0c977b4895p-8}, /* [358] 1.375 <= y <= 1.4375 2^-3, degree 10, 62.0 bits */
    {0x1.4abaeaa7f7ec7p+0, 0x1.45ed1aa88bb24p-54, -0x1.516350491e64p-1, 0x1.2b1334423c941p-2, -0x1.3ba818f7967ep-3,
     0x1.66ef161490dfbp-4, -0x1.a915a747fcb15p-5, 0x1.0249040f36503p-5, -0x1.3f802433f1236p-6, 0x1.9064e1936e98p-7,
     -0x1.fb4655c7a1d1ep-8, 0x1.438ae48fbc724p-8}, /* [359] 1.4375 <= y <= 1.5 2^-3, degree 10, 60.3 bits */
    {0x1.40783344b9916p+0, -0x1.cc273a2920e63p-55, -0x1.3f9422aaf733ap-1, 0x1.0f766e3bd7cd1p-2, -0x1.12a558ab171dap-3,
     0x1.2b72e3147501bp-4, -0x1.54138c4293e26p-5, 0x1.8c53378ec70d6p-6, -0x1.d62d6da7b2cafp-7, 0x1.1a8d3f096f5f8p-7,
     -0x1.574d91d0f2742p-8, 0x1.a402d20160575p-9}, /* [360] 1.5 <= y <= 1.5625 2^-3, degree 10, 60.6 bits */
    {0x1.36bd5c935c8a5p+0, -0x1.56f288aad20edp-56, -0x1.2f61c20512933p-1, 0x1.eebdd3d4aef25p-3, -0x1.e09e14616147cp-4,
     0x1.f74d0ce834dd6p-5, -0x1.1284bd38db32ep-5, 0x1.33527984af83fp-6, -0x1.5e3dea6f44093p-7, 0x1.94661336dc29cp-8,
     -0x1.d80028b86b612p-9, 0x1.1562fcb2cf36fp-9}, /* [361] 1.5625 <= y <= 1.625 2^-3, degree 10, 59.4 bits */
    {0x1.2d7e54d5633b3p+0, -0x1.548a095c4217p-56, -0x1.209883ce2c028p-1, 0x1.c4793592e7ce3p-3, -0x1.a6b6a92145162p-4,
     0x1.a9d1ea43cdf82p-5, -0x1.bee142b440f7ap-6, 0x1.e150ff0dfc32ep-7, -0x1.07e19ccdda82bp-7, 0x1.25275da71d29cp-8,
     -0x1.49321d68e145cp-9, 0x1.744b59065bf91p-10}, /* [362] 1.625 <= y <= 1.6875 2^-3, degree 10, 59.5 bits */
    {0x1.24b0860974d94p+0, 0x1.146d1c5ca7919p-54, -0x1.130cda7653c31p-1, 0x1.9f359589d545ep-3, -0x1.7592afe81aa29p-4,
     0x1.6a84c46aa534dp-5, -0x1.6e87369244bbbp-6, 0x1.7c5a116bd0947p-7, -0x1.91d5b5005cc72p-8, 0x1.ae213bca4db49p-9,
     -0x1.d16113e40965cp-10, 0x1.fb20e4108649cp-11}, /* [363] 1.6875 <= y <= 1.75 2^-3, degree 10, 61.4 bits */
    {0x1.1c4a9b51284a4p+0, -0x1.1dab885ef30b7p-54, -0x1.0699d1d8ae64ep-1, 0x1.7e344e6ff2e7p-3, -0x1.4b9e3d8e604d7p-4,
     0x1.366b02bdf77eap-5, -0x1.2ec52a617d913p-6, 0x1.2f1d3104d2f68p-7, -0x1.34f501cbb209cp-8, 0x1.3f12dd62bd985p-9,
     -0x1.4d0fe28239d42p-10, 0x1.5e2de3b00a1bfp-11}, /* [364] 1.75 <= y <= 1.8125 2^-3, degree 10, 59.8 bits */
    {0x1.14445117e598p+0, -0x1.5fe05900df98bp-54, -0x1.f63fbd514f22ep-2, 0x1.60d881ccb2158p-3, -0x1.2798f02412c1dp-4,
     0x1.0b3d8ce48ba1ap-5, -0x1.f787740373384p-7, 0x1.e6eecec52e91ap-8, -0x1.df6eb87ef13cbp-9, 0x1.de4be9adaffc2p-10,
     -0x1.e246cbaf97813p-11, 0x1.e9d63561f9a0ap-12}, /* [365] 1.8125 <= y <= 1.875 2^-3, degree 10, 60.2 bits */
    {0x1.0c964db6bdad9p+0, -0x1.eb3650f7b23f4p-54, -0x1.e107d9e84cedp-2, 0x1.46a0372198258p-3, -0x1.08829097e3e32p-4,
     0x1.ce7492d1afad5p-6, -0x1.a54c615a373c4p-7, 0x1.89fdceafdd36fp-8, -0x1.7727f71c4c243p-9, 0x1.69f56b185e4ap-10,
     -0x1.60f5965d932a8p-11, 0x1.5ab678f8ddd53p-12}, /* [366] 1.875 <= y <= 1.9375 2^-3, degree 10, 60.0 bits */
    {0x1.053a00da17707p+0, 0x1.d8ea9ed5f252p-58, -0x1.cd5d3e2921c2dp-2, 0x1.2f1f0d4f42e0bp-3, -0x1.db194cecc521ep-5,
     0x1.9205637308819p-6, -0x1.628a39a207515p-7, 0x1.40fbe8e4ddd3p-8, -0x1.27e62fb4b9a72p-9, 0x1.14660db38f85p-10,
     -0x1.04f037002ddcap-11, 0x1.f0548f8d0abdbp-13}, /* [367] 1.9375 <= y <= 2 2^-3, degree 10, 61.4 bits */
    {0x1.f5781de083c3ep-1, -0x1.1feb59ee0e5ffp-55, -0x1.b26f09d3873b7p-1, 0x1.1031bf7211a82p-1, -0x1.96e5448d93ffdp-2,
     0x1.48865d800518fp-2, -0x1.1477d575a0052p-2, 0x1.ddbd2deac4797p-3, -0x1.a44edcf4e513cp-3, 0x1.76b50b41ccfdap-3,
     -0x1.521fa34b827abp-3, 0x1.32ed92dc399bep-3}, /* [368] 1 <= y <= 1.0625 2^-2, degree 10, 59.8 bits */
    {0x1.db5543e93fc8fp-1, 0x1.ae6b7943c4394p-55, -0x1.92a4a215c08d3p-1, 0x1.db2bdba7a1231p-2, -0x1.4e802424a8e12p-2,
     0x1.fd057927e7ce5p-3, -0x1.93b8c38eff02fp-3, 0x1.48c9d75fa1836p-3, -0x1.10ab7eedd3478p-3, 0x1.ca4e0737100fap-4,
     -0x1.85c6e064d1b02p-4, 0x1.4d8d1e08ce6cfp-4}, /* [369] 1.0625 <= y <= 1.125 2^-2, degree 10, 59.6 bits */
    {0x1.c30e94f537d5ep-1, -0x1.814c9c5f39a64p-56, -0x1.76c9afd017becp-1, 0x1.a1f5b643568bep-2, -0x1.1605c3065e6b9p-2,
     0x1.900442ed578bbp-3, -0x1.2bff8b93f357cp-3, 0x1.ce1768f4b4abep-4, -0x1.6a6c5bf3e70aep-4, 0x1.20108125a6043p-4,
     -0x1.cf56859904ee4p-5, 0x1.7704b1529588bp-5}, /* [370] 1.125 <= y <= 1.1875 2^-2, degree 10, 59.4 bits */
    {0x1.ac6aa42d62bd5p-1, -0x1.d605dd05afbdfp-55, -0x1.5e33bf4ea6dp-1, 0x1.722d43f19b608p-2, -0x1.d2b893d2b1ddep-3,
     0x1.3e65cae49fb65p-3, -0x1.c4e84ad9bc873p-4, 0x1.4ad57229a7p-4, -0x1.ec3b3a4aa55ffp-5, 0x1.731c3e99b5e3p-5,
     -0x1.1b1023dee245ep-5, 0x1.b2a8b7872294p-6}, /* [371] 1.1875 <= y <= 1.25 2^-2, degree 10, 60.3 bits */
    {0x1.9739802f488dbp-1, -0x1.97b890683aa26p-55, -0x1.485c1b7d42457p-1, 0x1.49e4efd16c25bp-2, -0x1.8b388928df417p-3,
     0x1.005ceaec078fbp-3, -0x1.5abeab29ac101p-4, 0x1.e1bce4cc69675p-5, -0x1.54d271869ea6bp-5, 0x1.e8c3419d5a2p-6,
     -0x1.628414663e631p-6, 0x1.02e12d6f64496p-6}, /* [372] 1.25 <= y <= 1.3125 2^-2, degree 10, 59.0 bits */
    {0x1.8352c18bcb793p-1, 0x1.0cee663a01246p-55, -0x1.34d6ff12f0d63p-1, 0x1.27a5de6b7d8aep-2, -0x1.515b5abc1ebf8p-3,
     0x1.a125649611196p-4, -0x1.0ce21d98970a2p-4, 0x1.641a559143fb2p-5, -0x1.e0566349a47e5p-6, 0x1.48586dbf92d65p-6,
     -0x1.c60c068867f17p-7, 0x1.3c19b381cf315p-7}, /* [373] 1.3125 <= y <= 1.375 2^-2, degree 10, 60.3 bits */
    {0x1.7094113caae1fp-1, -0x1.71e6e0c72cc97p-55, -0x1.234d3c9e043e3p-1, 0x1.0a4f7916c222ep-2, -0x1.220f7f176d962p-3,
     0x1.569ba37af638ep-4, -0x1.a5e29b1053b62p-5, 0x1.0ae40d2f53576p-5, -0x1.57ee304c2b2acp-6, 0x1.c13bed0e6558cp-7,
     -0x1.28bb38c92429dp-7, 0x1.8ac061a33979ap-8}, /* [374] 1.375 <= y <= 1.4375 2^-2, degree 10, 59.5 bits */
    {0x1.5ee0062ef47d3p-1, 0x1.2efa7c2a12b19p-56, -0x1.137799ac27788p-1, 0x1.e201a52ffbe77p-3, -0x1.f619bc22ef057p-4,
     0x1.1bd41d5915f4bp-4, -0x1.4e80ef18733b8p-5, 0x1.952116bf8bfe4p-6, -0x1.f3c0de9bb150cp-7, 0x1.38729e07e564ep-7,
     -0x1.8b1b5032f43d2p-8, 0x1.f733330dcbaa3p-9}, /* [375] 1.4375 <= y <= 1.5 2^-2, degree 10, 58.5 bits */
    {0x1.4e1d43023945ap-1, 0x1.eab63a7150effp-56, -0x1.051b5b858425bp-1, 0x1.b6114466f5329p-3, -0x1.b536a8837224p-4,
     0x1.da010a2e3c8c8p-5, -0x1.0bcf87302fe3dp-5, 0x1.370e70e9f3522p-6, -0x1.6ff8760fdfd66p-7, 0x1.b94545251f022p-8,
     -0x1.0b8f49c9b98a2p-8, 0x1.46d0a319cd876p-9}, /* [376] 1.5 <= y <= 1.5625 2^-2, degree 10, 62.8 bits */
    {0x1.3e35c3cb4a9d2p-1, 0x1.fda297973083bp-55, -0x1.f00f5c1f37d4fp-2, 0x1.8fb37838a6108p-3, -0x1.7ed64ee903837p-4,
     0x1.8eb1fe1dd1a8fp-5, -0x1.b0adc4905bccdp-6, 0x1.e2c1f76249d1ap-7, -0x1.1249c07ce0c57p-7, 0x1.3bfc69ffa44c4p-8,
     -0x1.70163755209f9p-9, 0x1.afedf91f109b1p-10}, /* [377] 1.5625 <= y <= 1.625 2^-2, degree 10, 61.9 bits */
    {0x1.2f165035d30cdp-1, -0x1.1ff56243a8df3p-55, -0x1.d827518e93d1dp-2, 0x1.6e054d5a8a0bp-3, -0x1.50f2c1bad7acdp-4,
     0x1.519d50c0f00fdp-5, -0x1.606a028b02073p-6, 0x1.7a4fb32afb628p-7, -0x1.9d937363dc73bp-8, 0x1.ca6a66da8537ap-9,
     -0x1.00df8cd3bdb3dp-9, 0x1.220641ef4953fp-10}, /* [378] 1.625 <= y <= 1.6875 2^-2, degree 10, 59.4 bits */
    {0x1.20ae098688ed2p-1, 0x1.7206710eb88e4p-56, -0x1.c2398fbd6611ep-2, 0x1.504ec1560a09dp-3, -0x1.29f85d456e041p-4,
     0x1.1fadb32e00298p-5, -0x1.213c87700bbep-6, 0x1.2b2b04652049ep-7, -0x1.3b166efe87d61p-8, 0x1.50841197e23abp-9,
     -0x1.6b589fa0476bp-10, 0x1.8b4980efd93e3p-11}, /* [379] 1.6875 <= y <= 1.75 2^-2, degree 10, 59.3 bits */
    {0x1.12ee0e36fc323p-1, 0x1.17a2596225039p-59, -0x1.ae0b7782fb96dp-2, 0x1.35f97082baf4cp-3, -0x1.08a98db2afcdcp-4,
     0x1.ed1ac5ce46fe5p-6, -0x1.de23ce1b287a5p-7, 0x1.dd2c8ac4899ebp-8, -0x1.e4ce090bfd731p-9, 0x1.f3922e97d7208p-10,
     -0x1.042ed35a52864p-10, 0x1.111ab787b3abfp-11}, /* [380] 1.75 <= y <= 1.8125 2^-2, degree 10, 59.1 bits */
    {0x1.05c92e78d3d7ep-1, 0x1.2aa7f9257d563p-56, -0x1.9b6af33d6663dp-2, 0x1.1e89880cd373p-3, -0x1.d8147da3d98f9p-5,
     0x1.a8e61497e4ecfp-6, -0x1.8dd11fbf843cp-7, 0x1.7f8d49164cd69p-8, -0x1.785ce718db21bp-9, 0x1.76aa9280d5d3p-10,
     -0x1.78f219eb0264dp-11, 0x1.7e3c9dd915644p-12}, /* [381] 1.8125 <= y <= 1.875 2^-2, degree 10, 59.5 bits */
    {0x1.f2675c2625b9fp-2, 0x1.5f6af9b5aae91p-56, -0x1.8a2cfad09d6bfp-2, 0x1.099860ee722eap-3, -0x1.a6a167f66555ep-5,
     0x1.6ffadf2b2b2cbp-6, -0x1.4d0584333a129p-7, 0x1.3692b42fd43eap-8, -0x1.26a7a902c3c5ap-9, 0x1.1bb71a048f8b4p-10,
     -0x1.140216443c8eep-11, 0x1.0eb4981c3672dp-12}, /* [382] 1.875 <= y <= 1.9375 2^-2, degree 10, 61.5 bits */
    {0x1.da4621c4a4e95p-2, 0x1.77dc4dec1dcbdp-58, -0x1.7a2c63a3ca9c5p-2, 0x1.eda0ab8954a78p-4, -0x1.7bb479d0ef154p-5,
     0x1.4032af7b83759p-6, -0x1.1860d0d6550bcp-7, 0x1.fa6ffd2ed427ap-9, -0x1.d105bcbc831e5p-10, 0x1.b196987baff1ep-11,
     -0x1.9847ef8a3d0c5p-12, 0x1.83c06fa6e01f6p-13} /* [383] 1.9375 <= y <= 2 2^-2, degree 10, 60.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_beta_zero_force)

/* duration at zero overlap, beta < 1/8: 3 rows of degree 10 in y = beta, nodes 0 + i 0.0625, 0 <= y <= 0.15625.
 * Relative error of the approximation: 2^-62.0 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_OVERLAP_ROWS 3
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_OVERLAP_END 0.125
COR_ROWS(double, cor_rows_hertz_dashpot_near_duration_zero_overlap, 3, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be991a8f0b41p+1, 0x1.5d0edcf4822dfp-54, 0x1.2691b13f85e7ap-1, 0x1.d7e55f62903b6p-2, 0x1.23a0b0993273p-2,
     0x1.70aa151098db9p-3, 0x1.0e0de6b74c39cp-3, 0x1.86a09386326c5p-4, 0x1.24ce766484d4bp-4, 0x1.c28937c291db1p-5,
     0x1.5bfea1dcdb7c4p-5, 0x1.3a30fcefc1e94p-5}, /* [0] 0 <= y <= 0.03125, degree 10, 62.8 bits */
    {0x1.a0c13480ba59cp+1, 0x1.7966e0c44904bp-53, 0x1.45dde7cfe6111p-1, 0x1.09a0014b168f3p-1, 0x1.578121845bab2p-2,
     0x1.d1e21e05e1781p-3, 0x1.6508713a1b8abp-3, 0x1.11ba66886d344p-3, 0x1.b2c0f6b3702d1p-4, 0x1.61612fcb631d4p-4,
     0x1.23cb54377e449p-4, 0x1.e823780a3c56p-5}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 62.0 bits */
    {0x1.a61de1b7babdap+1, 0x1.e08448b8f987cp-53, 0x1.6934215551dcap-1, 0x1.2ccb07e960e55p-1, 0x1.9971cf1b75fedp-2,
     0x1.29c7b4656eb1bp-2, 0x1.e03da7ab5094bp-3, 0x1.87958463b6dc1p-3, 0x1.4a5d9d3a666dap-3, 0x1.1cf29b6562c4dp-3,
     0x1.f42cfc1b11b92p-4, 0x1.bc694b277e95ap-4} /* [2] 0.09375 <= y <= 0.15625, degree 10, 63.0 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_duration_zero_overlap)

/* duration at zero overlap, 2^-3 <= beta < 0.627988: 19 rows of degree 10 in y = beta 2^-k, 8 to each octave k = -3 ... -1.
 * Relative error of the approximation: 2^-57.5 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_OVERLAP_FIRST 0.125
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_OVERLAP_FIRST_OCTAVE (-3)
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_OVERLAP_ROWS 19
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_OVERLAP_END 0.6279881355201693
COR_ROWS(double, cor_rows_hertz_dashpot_middle_duration_zero_overlap, 19, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.a6d3aa2f36752p+1, -0x1.f9964fecb1879p-56, 0x1.6df0f8e21c1a2p-4, 0x1.31a578949af16p-7, 0x1.a2e60d5bba389p-11,
     0x1.335783539713ep-14, 0x1.f3070b1006e04p-18, 0x1.9a25e93afcf8ap-21, 0x1.5cbc96f832d8bp-24, 0x1.2f296dad7e8c9p-27,
     0x1.0bafa584d0af5p-30, 0x1.ea88477f671d4p-37}, /* [0] 1 <= y <= 1.125 2^-3, degree 10, 63.6 bits */
    {0x1.a8466efc14a06p+1, -0x1.0045b17fd987dp-53, 0x1.77a6065d4fa4dp-4, 0x1.3bb1bb50f88b8p-7, 0x1.b6bb91817f422p-11,
     0x1.479c2bbfc62a7p-14, 0x1.0daab5da6b335p-17, 0x1.c273c024d6f37p-21, 0x1.8517e195bd4dap-24, 0x1.5788085f6890fp-27,
     0x1.343049fd28797p-30, 0x1.17ef6a843f0bfp-33}, /* [1] 1.125 <= y <= 1.25 2^-3, degree 10, 62.7 bits */
    {0x1.a9c311a8b7e36p+1, -0x1.114c24e420ac2p-57, 0x1.81ad5c4876274p-4, 0x1.4638e5d14ee0bp-7, 0x1.cbe260432b96bp-11,
     0x1.5d877eadaa397p-14, 0x1.23d12d4c2d53ap-17, 0x1.ef75bf46210dep-21, 0x1.b2e064fc84d44p-24, 0x1.861cdd18bc334p-27,
     0x1.63a883ffb1085p-30, 0x1.48c902af1d609p-33}, /* [2] 1.25 <= y <= 1.375 2^-3, degree 10, 63.0 bits */
    {0x1.ab49e673ef6fap+1, 0x1.168476fab1586p-54, 0x1.8c0af2591e4bbp-4, 0x1.514331a66ee66p-7, 0x1.e2762ff970b39p-11,
     0x1.7543babba15edp-14, 0x1.3c331a6c5ca38p-17, 0x1.10e79fa270fe5p-20, 0x1.e6ec40dfe8476p-24, 0x1.bbef2e573c226p-27,
     0x1.9b6966866c21ep-30, 0x1.82944bebcacdbp-33}, /* [3] 1.375 <= y <= 1.5 2^-3, degree 10, 63.4 bits */
    {0x1.acdb45b60961ep+1, 0x1.7250cdc348ba7p-56, 0x1.96c304c02f444p-4, 0x1.5cd986e0ac366p-7, 0x1.fa95822b7ab42p-11,
     0x1.8f00228c23991p-14, 0x1.5714e8422d7aep-17, 0x1.2d1e7f945a2bfp-20, 0x1.111b74f01240dp-23, 0x1.fa44ff4e77ea1p-27,
     0x1.dd0ec9c6df6eep-30, 0x1.c7bed0fdd91e2p-33}, /* [4] 1.5 <= y <= 1.625 2^-3, degree 10, 63.2 bits */
    {0x1.ae778c281f16ep+1, -0x1.5a2789684c36p-54, 0x1.a1da19e388719p-4, 0x1.69058dce62b1ep-7, 0x1.0a30fc9b915fp-10,
     0x1.aaf1ae1219f6bp-14, 0x1.74c48921b7543p-17, 0x1.4cccce751088ep-20, 0x1.32f43bde57dd7p-23, 0x1.21524bd480a3bp-26,
     0x1.1548e50c63e74p-29, 0x1.0da79f480058dp-32}, /* [5] 1.625 <= y <= 1.75 2^-3, degree 10, 64.0 bits */
    {0x1.b01f1b3164ddfp+1, -0x1.e7277f793bee4p-57, 0x1.ad5508adf8f7ap-4, 0x1.75d1c2df5a8f5p-7, 0x1.18005cf42edb2p-10,
     0x1.c953d7efd08c5p-14, 0x1.959afc43504a4p-17, 0x1.707177fc4e34dp-20, 0x1.59af49e38a3b3p-23, 0x1.4b624a4517e92p-26,
     0x1.4290b400777fp-29, 0x1.5fbee9a593dffp-31}, /* [6] 1.75 <= y <= 1.875 2^-3, degree 10, 62.9 bits */
    {0x1.b1d2593b1c57fp+1, -0x1.43fa46aa1fc88p-53, 0x1.b938ff87e344bp-4, 0x1.83498cfa369e5p-7, 0x1.26cd6d740decbp-10,
     0x1.ea698bf0db412p-14, 0x1.b9fe19d10f78fp-17, 0x1.98a03a4210295p-20, 0x1.861b8a6466312p-23, 0x1.7c99c2c2aa1ccp-26,
     0x1.79a68ce9eb229p-29, 0x1.7c0e7002928fap-32}, /* [7] 1.875 <= y <= 2 2^-3, degree 10, 62.8 bits */
    {0x1.b4760bbcbc3ccp+1, -0x1.c869e01b31016p-55, 0x1.cbe022cf390d6p-3, 0x1.98da6a6bb3eb2p-5, 0x1.3f0f2a949aedp-7,
     0x1.10e1358f3ba09p-9, 0x1.f83ec5f5685fap-12, 0x1.deea66a703dc2p-14, 0x1.d590986fb13b9p-16, 0x1.d685a843f09dep-18,
     0x1.dfd251dd489ap-20, 0x1.efc9eb68ff564p-22}, /* [8] 1 <= y <= 1.125 2^-2, degree 10, 62.6 bits */
    {0x1.b827fd94967f3p+1, 0x1.d67e85de0d18p-53, 0x1.e665ed9260abfp-3, 0x1.b871c5381db18p-5, 0x1.63c926a954652p-7,
     0x1.3c0c8ae9e16d4p-9, 0x1.2e44c72b214bcp-11, 0x1.29eadc2f6bb1dp-13, 0x1.2f05a6c80ee26p-15, 0x1.3b05ad53f80f3p-17,
     0x1.4d5b47239d48cp-19, 0x1.65695a89e5f44p-21}, /* [9] 1.125 <= y <= 1.25 2^-2, degree 10, 61.8 bits */
    {0x1.bc110787d0902p+1, -0x1.2efb010dbbb3ap-54, 0x1.0181119e71badp-2, 0x1.dbbf7551c4b64p-5, 0x1.8e6fabc7122b7p-7,
     0x1.6ffd0f57f1c2cp-9, 0x1.6cec7b628c925p-11, 0x1.75bfa3f553741p-13, 0x1.8aedf0d802148p-15, 0x1.aa939d00026adp-17,
     0x1.d515816d8c076p-19, 0x1.054d24ad22226p-20}, /* [10] 1.25 <= y <= 1.375 2^-2, degree 10, 61.5 bits */
    {0x1.c03594ec89a93p+1, -0x1.5402f8736b54ep-54, 0x1.10fa7269b183dp-2, 0x1.01afed6b600b2p-4, 0x1.c03d93f02ee24p-7,
     0x1.aeef530c88a5bp-9, 0x1.bbe3e9e58a62ap-11, 0x1.d91e55fe317b2p-13, 0x1.041558f99dc23p-14, 0x1.2454ee5ddb5b8p-16,
     0x1.4e9142a034ddbp-18, 0x1.83e9b749bcf2cp-20}, /* [11] 1.375 <= y <= 1.5 2^-2, degree 10, 60.9 bits */
    {0x1.c49a9bc7cb94p+1, 0x1.849fe8d5338d6p-53, 0x1.21c48c541abfp-2, 0x1.180843b73402ep-4, 0x1.fabfda454f227p-7,
     0x1.fbd20a0411727p-9, 0x1.102d3746261afp-10, 0x1.2e632190dfe89p-12, 0x1.5a7f95ed7baffp-14, 0x1.964121f39086ep-16,
     0x1.dcfcf9431c0dap-18, -0x1.8f574fe8fbacbp-23}, /* [12] 1.5 <= y <= 1.625 2^-2, degree 10, 63.7 bits */
    {0x1.c945b49746bf1p+1, 0x1.ce0330ae1df31p-53, 0x1.340b608a68542p-2, 0x1.315c8d6ff5874p-4, 0x1.1ff7e346026b6p-6,
     0x1.2d44372f4c33dp-8, 0x1.50bc9a4d46263p-10, 0x1.86a6d0e05bd34p-12, 0x1.d362e789c1efdp-14, 0x1.1de21fb7d29d2p-15,
     0x1.63cb0bb04ae64p-17, 0x1.e2f8f17d2edaap-19}, /* [13] 1.625 <= y <= 1.75 2^-2, degree 10, 62.5 bits */
    {0x1.ce3d37647e327p+1, 0x1.204e7f3404dfcp-54, 0x1.4802fb71ef1bap-2, 0x1.4e3b823c9f534p-4, 0x1.492b8c8efed2dp-6,
     0x1.6824eefef8e75p-8, 0x1.a4a395bdc7129p-10, 0x1.fe8cbbfe4a5bep-12, 0x1.3f870f3cfc48p-13, 0x1.99082da21bf4ep-15,
     0x1.0ab4adef5362cp-16, 0x1.60268721b9b97p-18}, /* [14] 1.75 <= y <= 1.875 2^-2, degree 10, 62.9 bits */
    {0x1.d3885f9c9123fp+1, 0x1.3f4d93bc23dc9p-54, 0x1.5de95f1ea0285p-2, 0x1.6f56a5ebe4f3dp-4, 0x1.7aa15e998f0a1p-6,
     0x1.b216e09b59b78p-8, 0x1.09815033ec57fp-9, 0x1.51e0800892f44p-11, 0x1.bb6c5227fcd79p-13, 0x1.299b93ea4f179p-14,
     0x1.97028450153fbp-16, 0x1.19dc516db8b87p-17}, /* [15] 1.875 <= y <= 2 2^-2, degree 10, 61.2 bits */
    {0x1.dc286ef35d428p+1, 0x1.a9718528e949cp-56, 0x1.8309c0423d0dbp-1, 0x1.aae81c49dc03bp-2, 0x1.d93f94c663697p-3,
     0x1.243bf1d4f22dep-3, 0x1.80fe8e3c01d4dp-4, 0x1.082e30100abbp-4, 0x1.75eaa0515c098p-5, 0x1.0eb249ecc5ce3p-5,
     0x1.9114fc7b4b1e5p-6, 0x1.2ba8610dbba8cp-6}, /* [16] 1 <= y <= 1.125 2^-1, degree 10, 60.4 bits */
    {0x1.e926398fd7a1bp+1, 0x1.a126f50a1c16cp-56, 0x1.be95645747b02p-1, 0x1.09bf5c1d31487p-1, 0x1.47c493d1f4bfp-2,
     0x1.c346ecbf19ed5p-3, 0x1.4b84f1aef3dfep-3, 0x1.fc248179b2b4dp-4, 0x1.91b16fd571e4dp-4, 0x1.44e4741bc3881p-4,
     0x1.0d4a1eef70de8p-4, 0x1.c198fdab460c2p-5}, /* [17] 1.125 <= y <= 1.25 2^-1, degree 10, 59.4 bits */
    {0x1.f83b11777eb3bp+1, 0x1.56e50cc19a89bp-54, 0x1.04d95f20158bbp+0, 0x1.53ab58482d1cbp-1, 0x1.d878b4e3e9db4p-2,
     0x1.6f93743c28542p-2, 0x1.3175a0a6d2989p-2, 0x1.091d20aac4a75p-2, 0x1.dac424c31cb87p-3, 0x1.b3002aaa89493p-3,
     0x1.994322c7282d6p-3, 0x1.830d6b10e5228p-3} /* [18] 1.25 <= y <= 1.375 2^-1, degree 10, 57.5 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_middle_duration_zero_overlap)

/* duration at zero overlap, 2^-53 <= beta_c - beta < 2^-1: 416 rows of degree 10 in y = (beta_c - beta) 2^-k, 8 to each octave k = -53 ... -2.
 * Relative error of the approximation: 2^-58.8 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_BELOW_DURATION_ZERO_OVERLAP_FIRST 1.1102230246251565e-16
#define COR_ROWS_HERTZ_DASHPOT_BELOW_DURATION_ZERO_OVERLAP_FIRST_OCTAVE (-53)
#define COR_ROWS_HERTZ_DASHPOT_BELOW_DURATION_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_BELOW_DURATION_ZERO_OVERLAP_ROWS 416
#define COR_ROWS_HERTZ_DASHPOT_BELOW_DURATION_ZERO_OVERLAP_END 0.5000000000004547
COR_ROWS(double, cor_rows_hertz_dashpot_below_duration_zero_overlap, 416, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.2505178eb5fdp+5, -0x1.dc70048032c49p-50, -0x1.ab3485d3d8ba3p-1, 0x1.92135096f3d1p-2, -0x1.f890b562e8c4ep-3,
     0x1.6429e96da07b1p-3, -0x1.0c2b9aed0c1d8p-3, 0x1.a4a8cae4f2133p-4, -0x1.535988a729281p-4, 0x1.1776da59979e4p-4,
     -0x1.d6ef1850dfa75p-5, 0x1.8ef60b5e17a5dp-5}, /* [0] 1 <= y <= 1.125 2^-53, degree 10, 62.9 bits */
    {0x1.243b25f803aabp+5, -0x1.03e2290b7bffp-49, -0x1.7e3c77c2d02c1p-1, 0x1.41e213d960f2ap-2, -0x1.6969a178472c9p-3,
     0x1.c8856d9e22584p-4, -0x1.338d16c9eeabdp-4, 0x1.afa694c4159a6p-5, -0x1.379067932c141p-5, 0x1.cb2596b2ac8dfp-6,
     -0x1.59a5c60651209p-6, 0x1.05fdf1e20204fp-6}, /* [1] 1.125 <= y <= 1.25 2^-53, degree 10, 64.1 bits */
    {0x1.23856f414e6b8p+5, 0x1.a4e728b246048p-51, -0x1.59d52f6ba2f2dp-1, 0x1.077ddad966318p-2, -0x1.0bac8d04a64fdp-3,
     0x1.31e9c5b70cff8p-4, -0x1.74ec37d0b4729p-5, 0x1.d98d7bb38741ep-6, -0x1.3541b49154133p-6, 0x1.9c5792282f142p-7,
     -0x1.188f3e6b99749p-7, 0x1.80ccea46ccff4p-8}, /* [2] 1.25 <= y <= 1.375 2^-53, degree 10, 63.3 bits */
    {0x1.22e043a4afe17p+5, -0x1.8eb5678e349fap-49, -0x1.3bc2a5bf413d6p-1, 0x1.b75198737f463p-3, -0x1.977bea1a11d77p-4,
     0x1.a933638e30c69p-5, -0x1.d9445426a4359p-6, 0x1.125b8d886c0f2p-6, -0x1.472ec0136cf6bp-7, 0x1.8e4f26657a00bp-8,
     -0x1.ee81d5825bd1ep-9, 0x1.35a06d4789e89p-9}, /* [3] 1.375 <= y <= 1.5 2^-53, degree 10, 63.4 bits */
    {0x1.2248dfefaed46p+5, -0x1.feb285e070706p-50, -0x1.227fe02e4ccc1p-1, 0x1.73d6e14ca0a68p-3, -0x1.3d4d8d0299b3ap-4,
     0x1.309c5e63558cdp-5, -0x1.37ebe5ca0d539p-6, 0x1.4cb75b80588c5p-7, -0x1.6d093369dd4d2p-8, 0x1.98d7164ab39a9p-9,
     -0x1.d2b25e4499f82p-10, 0x1.0cd568ae84a1ap-10}, /* [4] 1.5 <= y <= 1.625 2^-53, degree 10, 66.4 bits */
    {0x1.21bd24810db1ep+5, -0x1.12e1a369c1ddfp-49, -0x1.0cfb24eb95347p-1, 0x1.3ecad63c25ed1p-3, -0x1.f7c545d3d49fep-5,
     0x1.bfcbcc4204c6bp-6, -0x1.a893b830f0118p-7, 0x1.a355d8abeb425p-8, -0x1.a9fd869280c59p-9, 0x1.b9c487ecd9e59p-10,
     -0x1.d2b600ff211b6p-11, 0x1.f1d9d432cb2e2p-12}, /* [5] 1.625 <= y <= 1.75 2^-53, degree 10, 64.1 bits */
    {0x1.213b666ee1e7dp+5, 0x1.d5d7d5d52cd31p-50, -0x1.f4dc79bc33f71p-2, 0x1.145654a64aac2p-3, -0x1.9690ab8f5598dp-5,
     0x1.5077ba17ba894p-6, -0x1.29050e340ec44p-7, 0x1.111f21a66fedep-8, -0x1.0252478f6798p-9, 0x1.f2d3d68d18ebap-11,
     -0x1.ea76e07dd4286p-12, 0x1.e71a9266c0afbp-13}, /* [6] 1.75 <= y <= 1.875 2^-53, degree 10, 68.2 bits */
    {0x1.20c25055829e8p+5, -0x1.a5ce10ad988ep-51, -0x1.d48c2fd61799dp-2, 0x1.e3a97b6508d56p-4, -0x1.4cd7bab69e0cp-5,
     0x1.01af46358fa24p-6, -0x1.a99866bc51254p-8, 0x1.6e1a7ee68d799p-9, -0x1.43ecd90d3c93p-10, 0x1.2493db6f6e152p-11,
     -0x1.0d07ea357deeep-12, 0x1.f3e581be4c275p-14}, /* [7] 1.875 <= y <= 2 2^-53, degree 10, 64.7 bits */
    {0x1.201a994956df1p+5, -0x1.22a0ff0382734p-51, -0x1.ab3485fe7a27bp-1, 0x1.921350ab038bdp-2, -0x1.f890b575ca659p-3,
     0x1.6429e978bbca9p-3, -0x1.0c2b9af45d5afp-3, 0x1.a4a8caef46a61p-4, -0x1.535988aeccc84p-4, 0x1.1776da5f6f186p-4,
     -0x1.d6ef185a187ebp-5, 0x1.8ef60b6578ac9p-5}, /* [8] 1 <= y <= 1.125 2^-52, degree 10, 61.9 bits */
    {0x1.1f50a7b28fd3cp+5, -0x1.be01082822dcp-49, -0x1.7e3c77eb233ddp-1, 0x1.41e213ea5b809p-2, -0x1.6969a186936e3p-3,
     0x1.c8856dad2f3fp-4, -0x1.338d16d2cddaep-4, 0x1.afa694cf4a77ap-5, -0x1.3790679a96422p-5, 0x1.cb2596bcd20fep-6,
     -0x1.59a5c60d79415p-6, 0x1.05fdf1e721a23p-6}, /* [9] 1.125 <= y <= 1.25 2^-52, degree 10, 62.9 bits */
    {0x1.1e9af0fbc6ec2p+5, 0x1.152331f8a63e9p-49, -0x1.59d52f91fe258p-1, 0x1.077ddae802d6ep-2, -0x1.0bac8d0fc853ep-3,
     0x1.31e9c5c1a74c8p-4, -0x1.74ec37dc03b3ap-5, 0x1.d98d7bc0741e9p-6, -0x1.3541b49910e11p-6, 0x1.9c579231c3807p-7,
     -0x1.188f3e71b50ebp-7, 0x1.80ccea4eb67b6p-8}, /* [10] 1.25 <= y <= 1.375 2^-52, degree 10, 63.2 bits */
    {0x1.1df5c55f15a41p+5, 0x1.b5c4986ce7072p-49, -0x1.3bc2a5e3e7cefp-1, 0x1.b751988cfe46dp-3, -0x1.977bea2bce5d7p-4,
     0x1.a933639d9d0e8p-5, -0x1.d9445435a97dep-6, 0x1.125b8d90424b2p-6, -0x1.472ec01bfe1b1p-7, 0x1.8e4f266f2934cp-8,
     -0x1.ee81d58da0443p-9, 0x1.35a06d4e33ab2p-9}, /* [11] 1.375 <= y <= 1.5 2^-52, degree 10, 65.2 bits */
    {0x1.1d5e61aa02a58p+5, 0x1.d6ff90f590714p-49, -0x1.227fe051743dap-1, 0x1.73d6e163204afp-3, -0x1.3d4d8d10ffdf7p-4,
     0x1.309c5e6eda7cap-5, -0x1.37ebe5d45f92fp-6, 0x1.4cb75b8a411bp-7, -0x1.6d093373d458bp-8, 0x1.98d7165510b0bp-9,
     -0x1.d2b25e4fb0435p-10, 0x1.0cd568b48ccbep-10}, /* [12] 1.5 <= y <= 1.625 2^-52, degree 10, 65.2 bits */
    {0x1.1cd2a63b5045ep+5, -0x1.100d7cd1ebaacp-51, -0x1.0cfb250d68ec7p-1, 0x1.3ecad650319c2p-3, -0x1.f7c545eb969ecp-5,
     0x1.bfcbcc539df54p-6, -0x1.a893b83f89b36p-7, 0x1.a355d8b8e5995p-8, -0x1.a9fd869e9695ap-9, 0x1.b9c487f87d1f9p-10,
     -0x1.d2b6010aa6faep-11, 0x1.f1d9d43e671fdp-12}, /* [13] 1.625 <= y <= 1.75 2^-52, degree 10, 63.6 bits */
    {0x1.1c50e82913df5p+5, 0x1.6d2d0cb126c99p-50, -0x1.f4dc79fd7b834p-2, 0x1.145654b84cc0dp-3, -0x1.9690aba334952p-5,
     0x1.5077ba256ecd6p-6, -0x1.29050e3ea4998p-7, 0x1.111f21af328cbp-8, -0x1.02524796ffee8p-9, 0x1.f2d3d69ab751ap-11,
     -0x1.ea76e08a610dap-12, 0x1.e71a9272865aap-13}, /* [14] 1.75 <= y <= 1.875 2^-52, degree 10, 65.2 bits */
    {0x1.1bd7d20fa489cp+5, 0x1.15a4c509f1a89p-51, -0x1.d48c30153b144p-2, 0x1.e3a97b859f457p-4, -0x1.4cd7bac76fd23p-5,
     0x1.01af4640698d8p-6, -0x1.a99866cbffafcp-8, 0x1.6e1a7ef2b181bp-9, -0x1.43ecd917155fp-10, 0x1.2493db77b04c9p-11,
     -0x1.0d07ea3c9c181p-12, 0x1.f3e581cac9ee8p-14}, /* [15] 1.875 <= y <= 2 2^-52, degree 10, 64.6 bits */
    {0x1.1b301b0361a8fp+5, 0x1.c45472276a269p-49, -0x1.ab34863ac4131p-1, 0x1.921350c762909p-2, -0x1.f890b5907e2ddp-3,
     0x1.6429e98870d6ep-3, -0x1.0c2b9afeb6843p-3, 0x1.a4a8cafde2a42p-4, -0x1.535988b99a746p-4, 0x1.1776da67b204ep-4,
     -0x1.d6ef1867233a9p-5, 0x1.8ef60b6fe8292p-5}, /* [16] 1 <= y <= 1.125 2^-51, degree 10, 62.4 bits */
    {0x1.1a66296c7d4f3p+5, 0x1.0faaf3f9ba984p-50, -0x1.7e3c78242a449p-1, 0x1.41e214025e757p-2, -0x1.6969a19acbd09p-3,
     0x1.c8856dc278126p-4, -0x1.338d16df59cb6p-4, 0x1.afa694df23a75p-5, -0x1.379067a512b0ap-5, 0x1.cb2596cb2b7e1p-6,
     -0x1.59a5c61798468p-6, 0x1.05fdf1ee60894p-6}, /* [17] 1.125 <= y <= 1.25 2^-51, degree 10, 63.9 bits */
    {0x1.19b072b5989abp+5, 0x1.0a28e355d0379p-49, -0x1.59d52fc83c973p-1, 0x1.077ddafcace95p-2, -0x1.0bac8d1f86dbep-3,
     0x1.31e9c5d0a5e66p-4, -0x1.74ec37ec0235ap-5, 0x1.d98d7bd2bb8e8p-6, -0x1.3541b4a40228dp-6, 0x1.9c57923f4fc08p-7,
     -0x1.188f3e7a58531p-7, 0x1.80ccea59e6f34p-8}, /* [18] 1.25 <= y <= 1.375 2^-51, degree 10, 63.8 bits */
    {0x1.190b4718ccd15p+5, -0x1.83df21b1cc48ep-53, -0x1.3bc2a617bcc3fp-1, 0x1.b75198b10cda2p-3, -0x1.977bea44e3a28p-4,
     0x1.a93363b36cc5p-5, -0x1.d944544ae78aep-6, 0x1.125b8d9b57899p-6, -0x1.472ec0281bad5p-7, 0x1.8e4f267cdb544p-8,
     -0x1.ee81d59d8f7d7p-9, 0x1.35a06d579ffa3p-9}, /* [19] 1.375 <= y <= 1.5 2^-51, degree 10, 65.3 bits */
    {0x1.1873e363a0729p+5, -0x1.8ee421727a01p-50, -0x1.227fe0832b60ap-1, 0x1.73d6e182f1a84p-3, -0x1.3d4d8d255ce7ep-4,
     0x1.309c5e7f24e9dp-5, -0x1.37ebe5e2f846bp-6, 0x1.4cb75b984456fp-7, -0x1.6d093381ec11ap-8, 0x1.98d71663b8b88p-9,
     -0x1.d2b25e5f5e377p-10, 0x1.0cd568bd14937p-10}, /* [20] 1.5 <= y <= 1.625 2^-51, degree 10, 66.3 bits */
    {0x1.17e827f4d5b1cp+5, -0x1.1d517694285c4p-51, -0x1.0cfb253d3f9dfp-1, 0x1.3ecad66c8ae82p-3, -0x1.f7c5460d2fdc5p-5,
     0x1.bfcbcc6c813f5p-6, -0x1.a893b8542f82ep-7, 0x1.a355d8cb4018dp-8, -0x1.a9fd86afade58p-9, 0x1.b9c48808f262dp-10,
     -0x1.d2b6011af2bafp-11, 0x1.f1d9d44ed2167p-12}, /* [21] 1.625 <= y <= 1.75 2^-51, degree 10, 63.2 bits */
    {0x1.176669e281cd4p+5, -0x1.23edecb2c656fp-49, -0x1.f4dc7a59cd368p-2, 0x1.145654d1c4645p-3, -0x1.9690abbf4eaaap-5,
     0x1.5077ba38d03d5p-6, -0x1.29050e4d9ce1dp-7, 0x1.111f21bb9618p-8, -0x1.025247a1bda4p-9, 0x1.f2d3d6adf9d4cp-11,
     -0x1.ea76e09c20c5fp-12, 0x1.e71a92832c52fp-13}, /* [22] 1.75 <= y <= 1.875 2^-51, degree 10, 65.4 bits */
    {0x1.16ed53c8fbc5cp+5, -0x1.6ec496ea9e9abp-50, -0x1.d48c306e85b14p-2, 0x1.e3a97bb3b542ap-4, -0x1.4cd7badf391b1p-5,
     0x1.01af464fc21fap-6, -0x1.a99866e22d1adp-8, 0x1.6e1a7f03dced5p-9, -0x1.43ecd9250250fp-10, 0x1.2493db835e40cp-11,
     -0x1.0d07ea46ad04dp-12, 0x1.f3e581dc7445ep-14}, /* [23] 1.875 <= y <= 2 2^-51, degree 10, 65.2 bits */
    {0x1.16459cbc982eep+5, 0x1.ebb38e5af1a24p-50, -0x1.ab34869006ef6p-1, 0x1.921350ef82062p-2, -0x1.f890b5b6416f4p-3,
     0x1.6429e99ea775ep-3, -0x1.0c2b9b0d58ffp-3, 0x1.a4a8cb128bcap-4, -0x1.535988c8e1b4cp-4, 0x1.1776da7360f91p-4,
     -0x1.d6ef187994e95p-5, 0x1.8ef60b7eaa368p-5}, /* [24] 1 <= y <= 1.125 2^-50, degree 10, 62.6 bits */
    {0x1.157bab258a631p+5, 0x1.a4292f03c224p-50, -0x1.7e3c7874d0696p-1, 0x1.41e2142453916p-2, -0x1.6969a1b76453ep-3,
     0x1.c8856de091dffp-4, -0x1.338d16f118299p-4, 0x1.afa694f58d61cp-5, -0x1.379067b3e70cbp-5, 0x1.cb2596df7681fp-6,
     -0x1.59a5c625e888p-6, 0x1.05fdf1f89fc3bp-6}, /* [25] 1.125 <= y <= 1.25 2^-50, degree 10, 63.9 bits */
    {0x1.14c5f46e7e5dcp+5, -0x1.d0c4727f2a45ap-55, -0x1.59d53014f2fdbp-1, 0x1.077ddb19e634p-2, -0x1.0bac8d35cae4p-3,
     0x1.31e9c5e5da806p-4, -0x1.74ec3802a0b7dp-5, 0x1.d98d7bec9547ep-6, -0x1.3541b4b37bc49p-6, 0x1.9c57925278992p-7,
     -0x1.188f3e868f873p-7, 0x1.80ccea69b9eb8p-8}, /* [26] 1.25 <= y <= 1.375 2^-50, degree 10, 64.9 bits */
    {0x1.1420c8d18d187p+5, -0x1.00daa423fca9fp-52, -0x1.3bc2a66109e84p-1, 0x1.b75198e40adb7p-3, -0x1.977bea685cae8p-4,
     0x1.a93363d24555p-5, -0x1.d9445468f21b9p-6, 0x1.125b8dab04019p-6, -0x1.472ec0393df61p-7, 0x1.8e4f269039bc6p-8,
     -0x1.ee81d5b418622p-9, 0x1.35a06d64f37f5p-9}, /* [27] 1.375 <= y <= 1.5 2^-50, degree 10, 63.6 bits */
    {0x1.1389651c3cd6bp+5, -0x1.d2fef8b2ef21bp-49, -0x1.227fe0c97a45p-1, 0x1.73d6e1aff0f13p-3, -0x1.3d4d8d42293f8p-4,
     0x1.309c5e962ec98p-5, -0x1.37ebe5f79cc56p-6, 0x1.4cb75bac15746p-7, -0x1.6d093395da28bp-8, 0x1.98d7167872e4ap-9,
     -0x1.d2b25e758acddp-10, 0x1.0cd568c924e8p-10}, /* [28] 1.5 <= y <= 1.625 2^-50, degree 10, 65.9 bits */
    {0x1.12fda9ad4f9b9p+5, -0x1.8921227aacaf9p-49, -0x1.0cfb2580e70f2p-1, 0x1.3ecad694a2464p-3, -0x1.f7c5463cb3da1p-5,
     0x1.bfcbcc8fb39c7p-6, -0x1.a893b87162c6ap-7, 0x1.a355d8e534c6ep-8, -0x1.a9fd86c7d985ap-9, 0x1.b9c4882038d6ep-10,
     -0x1.d2b60131fe79dp-11, 0x1.f1d9d46609f9bp-12}, /* [29] 1.625 <= y <= 1.75 2^-50, degree 10, 63.5 bits */
    {0x1.127beb9ada7ep+5, -0x1.2699bdeab584dp-50, -0x1.f4dc7adc5c516p-2, 0x1.145654f5c88dcp-3, -0x1.9690abe70ca35p-5,
     0x1.5077ba5438c58p-6, -0x1.29050e62c88c5p-7, 0x1.111f21cd1b55bp-8, -0x1.025247b0ee51p-9, 0x1.f2d3d6c936a0cp-11,
     -0x1.ea76e0b53a906p-12, 0x1.e71a929ab7a8dp-13}, /* [30] 1.75 <= y <= 1.875 2^-50, degree 10, 64.7 bits */
    {0x1.1202d581345ep+5, 0x1.7895c8306194fp-49, -0x1.d48c30eccca8bp-2, 0x1.e3a97bf4e223p-4, -0x1.4cd7bb00dca79p-5,
     0x1.01af466575f62p-6, -0x1.a99867018a2fcp-8, 0x1.6e1a7f1c24fd9p-9, -0x1.43ecd938b3e9p-10, 0x1.2493db93e2afap-11,
     -0x1.0d07ea54e9573p-12, 0x1.f3e581f56fd45p-14}, /* [31] 1.875 <= y <= 2 2^-50, degree 10, 64.2 bits */
    {0x1.115b1e74a2847p+5, 0x1.a7b1933786024p-49, -0x1.ab3487089ac87p-1, 0x1.92135128400fbp-2, -0x1.f890b5eba8ffcp-3,
     0x1.6429e9be118eap-3, -0x1.0c2b9b220b519p-3, 0x1.a4a8cb2fc3c61p-4, -0x1.535988de7d0dp-4, 0x1.1776da83e6d21p-4,
     -0x1.d6ef1893aa611p-5, 0x1.8ef60b93892fap-5}, /* [32] 1 <= y <= 1.125 2^-49, degree 10, 62.4 bits */
    {0x1.10912cdd5a1bcp+5, 0x1.a8222b1e43538p-49, -0x1.7e3c78e6de794p-1, 0x1.41e21454597b2p-2, -0x1.6969a1dfd518bp-3,
     0x1.c8856e0b2386ap-4, -0x1.338d170a300a8p-4, 0x1.afa695153fc13p-5, -0x1.379067c8dfe9bp-5, 0x1.cb2596fc295e6p-6,
     -0x1.59a5c63a26926p-6, 0x1.05fdf2071d91dp-6}, /* [33] 1.125 <= y <= 1.25 2^-49, degree 10, 63.5 bits */
    {0x1.0fdb7626167cap+5, -0x1.ffa46fc2370dfp-53, -0x1.59d530816fe38p-1, 0x1.077ddb433a59p-2, -0x1.0bac8d5547f3fp-3,
     0x1.31e9c603d7b42p-4, -0x1.74ec38229dbbdp-5, 0x1.d98d7c112427ep-6, -0x1.3541b4c95e54p-6, 0x1.9c57926d91193p-7,
     -0x1.188f3e97d60ffp-7, 0x1.80ccea801adb3p-8}, /* [34] 1.25 <= y <= 1.375 2^-49, degree 10, 63.9 bits */
    {0x1.0f364a88f034ap+5, -0x1.76842c3bf3f71p-54, -0x1.3bc2a6c8b3d4ap-1, 0x1.b751992c28023p-3, -0x1.977bea9a8738cp-4,
     0x1.a93363fde4c21p-5, -0x1.d94454936e35ap-6, 0x1.125b8dc12e7e7p-6, -0x1.472ec051791a9p-7, 0x1.8e4f26ab9dfb6p-8,
     -0x1.ee81d5d3f6d4ap-9, 0x1.35a06d77cc1d7p-9}, /* [35] 1.375 <= y <= 1.5 2^-49, degree 10, 67.2 bits */
    {0x1.0e9ee6d36d327p+5, 0x1.500f32f61c7e7p-51, -0x1.227fe12ce88d6p-1, 0x1.73d6e1ef93abep-3, -0x1.3d4d8d6ae3509p-4,
     0x1.309c5eb6c3a3fp-5, -0x1.37ebe614ce2cep-6, 0x1.4cb75bc81bec4p-7, -0x1.6d0933b2099a9p-8, 0x1.98d71695c2f45p-9,
     -0x1.d2b25e94e6b6p-10, 0x1.0cd568da34771p-10}, /* [36] 1.5 <= y <= 1.625 2^-49, degree 10, 64.5 bits */
    {0x1.0e132b644f35p+5, 0x1.87e189a0df846p-49, -0x1.0cfb25e094747p-1, 0x1.3ecad6cd54de5p-3, -0x1.f7c5467fe6555p-5,
     0x1.bfcbccc17a309p-6, -0x1.a893b89aae659p-7, 0x1.a355d909e9c5fp-8, -0x1.a9fd86ea08257p-9, 0x1.b9c48841235d7p-10,
     -0x1.d2b6015295f9fp-11, 0x1.f1d9d486dfe6fp-12}, /* [37] 1.625 <= y <= 1.75 2^-49, degree 10, 64.5 bits */
    {0x1.0d916d51ab1b9p+5, -0x1.7cb2b8d74988p-49, -0x1.f4dc7b94ffbcap-2, 0x1.14565528b7d4ep-3, -0x1.9690ac1f40ce8p-5,
     0x1.5077ba7afba57p-6, -0x1.29050e80b91d1p-7, 0x1.111f21e5e26c5p-8, -0x1.025247c669bcp-9, 0x1.f2d3d6efbba6fp-11,
     -0x1.ea76e0d8ba012p-12, 0x1.e71a92bc03996p-13}, /* [38] 1.75 <= y <= 1.875 2^-49, degree 10, 64.1 bits */
    {0x1.0d185737d797bp+5, 0x1.fedb99a1ce39cp-49, -0x1.d48c319f61e76p-2, 0x1.e3a97c510e1d9p-4, -0x1.4cd7bb306f396p-5,
     0x1.01af4684271a6p-6, -0x1.a998672de506p-8, 0x1.6e1a7f3e7bd4fp-9, -0x1.43ecd9548dccfp-10, 0x1.2493dbab3e98p-11,
     -0x1.0d07ea690b30bp-12, 0x1.f3e58218c4832p-14}, /* [39] 1.875 <= y <= 2 2^-49, degree 10, 69.9 bits */
    {0x1.0c70a02b04521p+5, -0x1.e6a950c70cdb5p-49, -0x1.ab3487b32085dp-1, 0x1.921351787efb2p-2, -0x1.f890b6372f82dp-3,
     0x1.6429e9ea7eccap-3, -0x1.0c2b9b3f50474p-3, 0x1.a4a8cb591611dp-4, -0x1.535988fd0b8dcp-4, 0x1.1776da9b44ba7p-4,
     -0x1.d6ef18b88dbeap-5, 0x1.8ef60bb10d4a7p-5}, /* [40] 1 <= y <= 1.125 2^-48, degree 10, 62.1 bits */
    {0x1.0ba6ae9369054p+5, -0x1.2c6290771724ep-51, -0x1.7e3c79882ac79p-1, 0x1.41e2149843b33p-2, -0x1.6969a219061f6p-3,
     0x1.c8856e475721ep-4, -0x1.338d172dacc7p-4, 0x1.afa6954213361p-5, -0x1.379067e688a1fp-5, 0x1.cb259724bf662p-6,
     -0x1.59a5c656c7156p-6, 0x1.05fdf21b9c06bp-6}, /* [41] 1.125 <= y <= 1.25 2^-48, degree 10, 63.5 bits */
    {0x1.0af0f7dbd6c47p+5, -0x1.6029546be1926p-49, -0x1.59d5311adcb53p-1, 0x1.077ddb7dacee9p-2, -0x1.0bac8d81d0045p-3,
     0x1.31e9c62e40e84p-4, -0x1.74ec384fdac03p-5, 0x1.d98d7c44d79a9p-6, -0x1.3541b4e8518b8p-6, 0x1.9c579293e2ca9p-7,
     -0x1.188f3eb044786p-7, 0x1.80ccea9fc0cbbp-8}, /* [42] 1.25 <= y <= 1.375 2^-48, degree 10, 63.7 bits */
    {0x1.0a4bcc3e65849p+5, 0x1.91ff638d6d3e9p-52, -0x1.3bc2a75b4e21ep-1, 0x1.b751999224052p-3, -0x1.977beae17950ep-4,
     0x1.a933643b95e22p-5, -0x1.d94454cf83571p-6, 0x1.125b8de0876e8p-6, -0x1.472ec073bdac2p-7, 0x1.8e4f26d25acbap-8,
     -0x1.ee81d601089ep-9, 0x1.35a06d927327bp-9}, /* [43] 1.375 <= y <= 1.5 2^-48, degree 10, 64.6 bits */
    {0x1.09b468889abc5p+5, 0x1.f6348645785ep-49, -0x1.227fe1b9865acp-1, 0x1.73d6e249923e1p-3, -0x1.3d4d8da47bffep-4,
     0x1.309c5ee4d7636p-5, -0x1.37ebe63e172a5p-6, 0x1.4cb75befbe273p-7, -0x1.6d0933d9e5c8cp-8, 0x1.98d716bf374cbp-9,
     -0x1.d2b25ec13fe2ep-10, 0x1.0cd568f255204p-10}, /* [44] 1.5 <= y <= 1.625 2^-48, degree 10, 64.7 bits */
    {0x1.0928ad1937ca5p+5, -0x1.d648008dc7f6fp-49, -0x1.0cfb2667e35b8p-1, 0x1.3ecad71d839adp-3, -0x1.f7c546deee51p-5,
     0x1.bfcbcd07deeafp-6, -0x1.a893b8d514ed3p-7, 0x1.a355d93dd322p-8, -0x1.a9fd871a5f65cp-9, 0x1.b9c4886fb0459p-10,
     -0x1.d2b60180ad77dp-11, 0x1.f1d9d4b54fad9p-12}, /* [45] 1.625 <= y <= 1.75 2^-48, degree 10, 64.0 bits */
    {0x1.08a6ef06513ecp+5, -0x1.c95ba1c739b55p-49, -0x1.f4dc7c9a1dfb8p-2, 0x1.14565570c027fp-3, -0x1.9690ac6ebccp-5,
     0x1.5077bab1ccb5ep-6, -0x1.29050eab10722p-7, 0x1.111f2208ece7bp-8, -0x1.025247e4cb16p-9, 0x1.f2d3d726353f1p-11,
     -0x1.ea76e10aed961p-12, 0x1.e71a92eb1a453p-13}, /* [46] 1.75 <= y <= 1.875 2^-48, degree 10, 64.5 bits */
    {0x1.082dd8ec3d89fp+5, 0x1.77f1be13e3159p-51, -0x1.d48c329befdf5p-2, 0x1.e3a97cd367debp-4, -0x1.4cd7bb73b6529p-5,
     0x1.01af46af8ec77p-6, -0x1.a998676c9f3p-8, 0x1.6e1a7f6f0bf58p-9, -0x1.43ecd97bf0fd1p-10, 0x1.2493dbcc4775dp-11,
     -0x1.0d07ea8583d58p-12, 0x1.f3e5824abba01p-14}, /* [47] 1.875 <= y <= 2 2^-48, degree 10, 64.5 bits */
    {0x1.078621df0dbedp+5, 0x1.415d29119cd4bp-50, -0x1.ab3488a448411p-1, 0x1.921351e9fb0eap-2, -0x1.f890b6a1fea4p-3,
     0x1.6429ea2952fe3p-3, -0x1.0c2b9b68b4ec7p-3, 0x1.a4a8cb93860a1p-4, -0x1.53598928423e5p-4, 0x1.1776dabc506c8p-4,
     -0x1.d6ef18ecb8ae2p-5, 0x1.8ef60bdacb3cbp-5}, /* [48] 1 <= y <= 1.125 2^-47, degree 10, 61.8 bits */
    {0x1.06bc3046fd384p+5, 0x1.61544318fbf22p-49, -0x1.7e3c7a6c46f07p-1, 0x1.41e214f84f871p-2, -0x1.6969a269e7a93p-3,
     0x1.c8856e9c7a6f8p-4, -0x1.338d175fdc89p-4, 0x1.afa6958177f52p-5, -0x1.379068107a5cp-5, 0x1.cb25975e251fp-6,
     -0x1.59a5c67f432a2p-6, 0x1.05fdf23897a2fp-6}, /* [49] 1.125 <= y <= 1.25 2^-47, degree 10, 63.0 bits */
    {0x1.0606798efbc3cp+5, 0x1.4cce3a6a10cep-49, -0x1.59d531f3d689dp-1, 0x1.077ddbd05538ep-2, -0x1.0bac8dc0ca246p-3,
     0x1.31e9c66a3b4fep-4, -0x1.74ec388fd4c85p-5, 0x1.d98d7c8df55aap-6, -0x1.3541b51416aa8p-6, 0x1.9c5792ca13cadp-7,
     -0x1.188f3ed2d189ep-7, 0x1.80cceacc82ab2p-8}, /* [50] 1.25 <= y <= 1.375 2^-47, degree 10, 65.1 bits */
    {0x1.05614df1207e9p+5, -0x1.e72f5d8215033p-49, -0x1.3bc2a82aa203bp-1, 0x1.b7519a225e534p-3, -0x1.977beb45ce659p-4,
     0x1.a9336492d4bc6p-5, -0x1.d94455247b8b5p-6, 0x1.125b8e0cdc685p-6, -0x1.472ec0a433f53p-7, 0x1.8e4f27092349bp-8,
     -0x1.ee81d640c5831p-9, 0x1.35a06db824641p-9}, /* [51] 1.375 <= y <= 1.5 2^-47, degree 10, 63.2 bits */
    {0x1.04c9ea3af0358p+5, -0x1.1d7bc6ba2c62p-49, -0x1.227fe28062f47p-1, 0x1.73d6e2c8d7b4p-3, -0x1.3d4d8df5f0223p-4,
     0x1.309c5f2601185p-5, -0x1.37ebe67879f98p-6, 0x1.4cb75c27cb17p-7, -0x1.6d09341244acap-8, 0x1.98d716f9d76c1p-9,
     -0x1.d2b25efff7b36p-10, 0x1.0cd56914743e6p-10}, /* [52] 1.5 <= y <= 1.625 2^-47, degree 10, 65.7 bits */
    {0x1.043e2ecb2bbedp+5, -0x1.a2e94da01df52p-52, -0x1.0cfb27273e2fp-1, 0x1.3ecad78ee8cb8p-3, -0x1.f7c547655347fp-5,
     0x1.bfcbcd6b6c138p-6, -0x1.a893b927ac2b4p-7, 0x1.a355d9873d204p-8, -0x1.a9fd875ebca56p-9, 0x1.b9c488b18552cp-10,
     -0x1.d2b601c1dc783p-11, 0x1.f1d9d4f6fb883p-12}, /* [53] 1.625 <= y <= 1.75 2^-47, degree 10, 65.3 bits */
    {0x1.03bc70b7e73b6p+5, -0x1.39a7745e9b8b7p-49, -0x1.f4dc7e0b64e3cp-2, 0x1.145655d69eb6cp-3, -0x1.9690acdf2516ap-5,
     0x1.5077baff5275fp-6, -0x1.29050ee6f193bp-7, 0x1.111f223a7b151p-8, -0x1.0252480fc1ec1p-9, 0x1.f2d3d7733f4b9p-11,
     -0x1.ea76e151ec77ap-12, 0x1.e71a932db2266p-13}, /* [54] 1.75 <= y <= 1.875 2^-47, degree 10, 65.0 bits */
    {0x1.03435a9d78beep+5, -0x1.4f703c2fec60cp-49, -0x1.d48c34011a6e8p-2, 0x1.e3a97d8bbfd4cp-4, -0x1.4cd7bbd2db767p-5,
     0x1.01af46ecf1101p-6, -0x1.a99867c554dcap-8, 0x1.6e1a7fb3b9a45p-9, -0x1.43ecd9b3a4c51p-10, 0x1.2493dbfaff469p-11,
     -0x1.0d07eaadc7888p-12, 0x1.f3e5829164fdcp-14}, /* [55] 1.875 <= y <= 2 2^-47, degree 10, 64.9 bits */
    {0x1.029ba38fc61b7p+5, 0x1.20e85a5a4a2bp-49, -0x1.ab3489f953cd9p-1, 0x1.9213528a78e64p-2, -0x1.f890b7390baabp-3,
     0x1.6429ea822d7a8p-3, -0x1.0c2b9ba33ed7ep-3, 0x1.a4a8cbe62aa1cp-4, -0x1.535989655f3fep-4, 0x1.1776daeb0c3d6p-4,
     -0x1.d6ef19367f695p-5, 0x1.8ef60c15d3727p-5}, /* [56] 1 <= y <= 1.125 2^-46, degree 10, 62.6 bits */
    {0x1.01d1b1f70fccbp+5, -0x1.1c3e142d37fb9p-49, -0x1.7e3c7baedf9eap-1, 0x1.41e2158023f7fp-2, -0x1.6969a2dc49b7p-3,
     0x1.c8856f14e1a64p-4, -0x1.338d17a6d6023p-4, 0x1.afa695db1edfp-5, -0x1.3790684bcbcc8p-5, 0x1.cb2597af512ecp-6,
     -0x1.59a5c6b884305p-6, 0x1.05fdf261948cdp-6}, /* [57] 1.125 <= y <= 1.25 2^-46, degree 10, 63.8 bits */
    {0x1.011bfb3e7114dp+5, -0x1.fbe3532cb0f38p-49, -0x1.59d53326b03ebp-1, 0x1.077ddc453a64bp-2, -0x1.0bac8e19da456p-3,
     0x1.31e9c6bf0db86p-4, -0x1.74ec38ea4ed14p-5, 0x1.d98d7cf55c405p-6, -0x1.3541b551fd19bp-6, 0x1.9c579316b72dbp-7,
     -0x1.188f3f03ae5acp-7, 0x1.80cceb0bce8c4p-8}, /* [58] 1.25 <= y <= 1.375 2^-46, degree 10, 65.2 bits */
    {0x1.0076cf9fffdfdp+5, -0x1.8904d04130eap-51, -0x1.3bc2a94fd6af9p-1, 0x1.b7519aee565a5p-3, -0x1.977bebd3b2967p-4,
     0x1.a933650e36fcfp-5, -0x1.d944559ca5ce9p-6, 0x1.125b8e4b8e48ap-6, -0x1.472ec0e8bd187p-7, 0x1.8e4f27569cea6p-8,
     -0x1.ee81d69ae9161p-9, 0x1.35a06ded7278bp-9}, /* [59] 1.375 <= y <= 1.5 2^-46, degree 10, 65.9 bits */
    {0x1.ffbed7d280155p+4, -0x1.f8c783f24ce04p-50, -0x1.227fe3999ea09p-1, 0x1.73d6e37cd4d96p-3, -0x1.3d4d8e6921816p-4,
     0x1.309c5f8228978p-5, -0x1.37ebe6cb0bf49p-6, 0x1.4cb75c770f8d2p-7, -0x1.6d093461fd092p-8, 0x1.98d7174cc01dp-9,
     -0x1.d2b25f58aa0d3p-10, 0x1.0cd56944b590ep-10}, /* [60] 1.5 <= y <= 1.625 2^-46, degree 10, 63.7 bits */
    {0x1.fea760f1e3555p+4, -0x1.f11162c01c3b7p-52, -0x1.0cfb2835dc0e8p-1, 0x1.3ecad82f46459p-3, -0x1.f7c5482363401p-5,
     0x1.bfcbcdf83588cp-6, -0x1.a893b99c793adp-7, 0x1.a355d9ef0fd8bp-8, -0x1.a9fd87bf6b265p-9, 0x1.b9c4890e9f234p-10,
     -0x1.d2b6021e0b742p-11, 0x1.f1d9d553db15ap-12}, /* [61] 1.625 <= y <= 1.75 2^-46, degree 10, 63.0 bits */
    {0x1.fda3e4ca5086p+4, 0x1.6ed4c6b3669a2p-50, -0x1.f4dc8015a184p-2, 0x1.14565666af5dcp-3, -0x1.9690ad7e1cfa6p-5,
     0x1.5077bb6cf4973p-6, -0x1.29050f3ba03e1p-7, 0x1.111f2280900cp-8, -0x1.0252484c84a04p-9, 0x1.f2d3d7e0327c1p-11,
     -0x1.ea76e1b653a1ap-12, 0x1.e71a938bdf7e3p-13}, /* [62] 1.75 <= y <= 1.875 2^-46, degree 10, 64.7 bits */
    {0x1.fcb1b89472c92p+4, -0x1.68d39e3ee330dp-52, -0x1.d48c35fa3680cp-2, 0x1.e3a97e907358bp-4, -0x1.4cd7bc5969a96p-5,
     0x1.01af4743c06aap-6, -0x1.a9986842c9311p-8, 0x1.6e1a8014d9e5bp-9, -0x1.43ecda026b258p-10, 0x1.2493dc3d11026p-11,
     -0x1.0d07eae6b8d25p-12, 0x1.f3e582f55337dp-14}, /* [63] 1.875 <= y <= 2 2^-46, degree 10, 64.4 bits */
    {0x1.fb624a779b6c8p+4, -0x1.45259459d5175p-50, -0x1.ab348bdba3664p-1, 0x1.9213536d710efp-2, -0x1.f890b80ea9ee1p-3,
     0x1.6429eaffd5de2p-3, -0x1.0c2b9bf608229p-3, 0x1.a4a8cc5b0a92ap-4, -0x1.535989bbcca14p-4, 0x1.1776db2d23a19p-4,
     -0x1.d6ef199ed5489p-5, 0x1.8ef60c694f571p-5}, /* [64] 1 <= y <= 1.125 2^-45, degree 10, 62.5 bits */
    {0x1.f9ce674459e7cp+4, -0x1.b0cc3cd6085d9p-50, -0x1.7e3c7d7718125p-1, 0x1.41e216403ba12p-2, -0x1.6969a37e0ccb6p-3,
     0x1.c8856fbf28422p-4, -0x1.338d180b35866p-4, 0x1.afa69659e85d8p-5, -0x1.3790689faf41p-5, 0x1.cb2598221ca0dp-6,
     -0x1.59a5c7097c5ap-6, 0x1.05fdf29b8bc57p-6}, /* [65] 1.125 <= y <= 1.25 2^-45, degree 10, 63.2 bits */
    {0x1.f862f9d15fa92p+4, 0x1.7bc417897af75p-54, -0x1.59d534d8a409dp-1, 0x1.077ddcea8afa9p-2, -0x1.0bac8e97ce863p-3,
     0x1.31e9c73702882p-4, -0x1.74ec396a42e1fp-5, 0x1.d98d7d8797c0fp-6, -0x1.3541b5a98757ep-6, 0x1.9c579383192e7p-7,
     -0x1.188f3f48c87dfp-7, 0x1.80cceb65524b5p-8}, /* [66] 1.25 <= y <= 1.375 2^-45, degree 10, 64.4 bits */
    {0x1.f718a292d5298p+4, -0x1.f58cef2410342p-53, -0x1.3bc2aaee7e94dp-1, 0x1.b7519c0ecaf8ep-3, -0x1.977bec9c5cc0ep-4,
     0x1.a93365bcb4b23p-5, -0x1.d94456469637ap-6, 0x1.125b8ea4383c9p-6, -0x1.472ec149a9aaep-7, 0x1.8e4f27c42de6dp-8,
     -0x1.ee81d71a62e07p-9, 0x1.35a06e38d4f19p-9}, /* [67] 1.375 <= y <= 1.5 2^-45, degree 10, 64.1 bits */
    {0x1.f5e9db23bf7bcp+4, -0x1.c2b5749d63bc2p-50, -0x1.227fe52757f58p-1, 0x1.73d6e47b5fc77p-3, -0x1.3d4d8f0c09c6ep-4,
     0x1.309c60047c02p-5, -0x1.37ebe73fd1936p-6, 0x1.4cb75ce7296d3p-7, -0x1.6d0934d2bad15p-8, 0x1.98d717c2005c2p-9,
     -0x1.d2b25fd619ae8p-10, 0x1.0cd56988f3cd5p-10}, /* [68] 1.5 <= y <= 1.625 2^-45, degree 10, 64.0 bits */
    {0x1.f4d264419ca93p+4, -0x1.cde479eabc8aap-50, -0x1.0cfb29b491d6ep-1, 0x1.3ecad91210a8ep-3, -0x1.f7c549302d2f8p-5,
     0x1.bfcbcebf4fdadp-6, -0x1.a893ba41a7b79p-7, 0x1.a355da81e3d5bp-8, -0x1.a9fd884825a61p-9, 0x1.b9c48992493ep-10,
     -0x1.d2b602a069753p-11, 0x1.f1d9d5d732cb4p-12}, /* [69] 1.625 <= y <= 1.75 2^-45, degree 10, 63.8 bits */
    {0x1.f3cee81891fa3p+4, -0x1.0398c525a1e28p-51, -0x1.f4dc82f82f972p-2, 0x1.145657326c7d4p-3, -0x1.9690ae5eeda9p-5,
     0x1.5077bc0800181p-6, -0x1.29050fb36281bp-7, 0x1.111f22e3ac672p-8, -0x1.025248a2724cbp-9, 0x1.f2d3d87a46959p-11,
     -0x1.ea76e24451654p-12, 0x1.e71a94110f40fp-13}, /* [70] 1.75 <= y <= 1.875 2^-45, degree 10, 67.2 bits */
    {0x1.f2dcbbe1491e4p+4, 0x1.c7ae4e0eb52ap-52, -0x1.d48c38c48be18p-2, 0x1.e3a9800123483p-4, -0x1.4cd7bd17b3f25p-5,
     0x1.01af47be84fc7p-6, -0x1.a99868f4348bp-8, 0x1.6e1a809e3543fp-9, -0x1.43ecda71d2b5fp-10, 0x1.2493dc9a80a43p-11,
     -0x1.0d07eb3740388p-12, 0x1.f3e58382a5f38p-14}, /* [71] 1.875 <= y <= 2 2^-45, degree 10, 65.1 bits */
    {0x1.f18d4dc266605p+4, -0x1.5d15509715f3ep-53, -0x1.ab348e85bac13p-1, 0x1.921354ae6cc14p-2, -0x1.f890b93cc3fd6p-3,
     0x1.6429ebb18ad79p-3, -0x1.0c2b9c6b1bfap-3, 0x1.a4a8cd0053c2ap-4, -0x1.53598a3606a4ep-4, 0x1.1776db8a9b43cp-4,
     -0x1.d6ef1a3262bf7p-5, 0x1.8ef60cdf5fc3p-5}, /* [72] 1 <= y <= 1.125 2^-44, degree 10, 62.2 bits */
    {0x1.eff96a8c8dba6p+4, -0x1.04cefc08fa225p-50, -0x1.7e3c7ffc49b06p-1, 0x1.41e2174fe485bp-2, -0x1.6969a462d0e89p-3,
     0x1.c88570aff6b11p-4, -0x1.338d189928797p-4, 0x1.afa6970d36321p-5, -0x1.3790691652227p-5, 0x1.cb2598c474c0ep-6,
     -0x1.59a5c77bfe66cp-6, 0x1.05fdf2ed85998p-6}, /* [73] 1.125 <= y <= 1.25 2^-44, degree 10, 63.7 bits */
    {0x1.ee8dfd171e6dfp+4, 0x1.3793d0d292a6fp-50, -0x1.59d5373e57b4ep-1, 0x1.077dddd45554bp-2, -0x1.0bac8f49eec99p-3,
     0x1.31e9c7e0a75a1p-4, -0x1.74ec3a1f36f4dp-5, 0x1.d98d7e56658d2p-6, -0x1.3541b6255436bp-6, 0x1.9c57941c5ff4cp-7,
     -0x1.188f3faa822p-7, 0x1.80ccebe3ea0dfp-8}, /* [74] 1.25 <= y <= 1.375 2^-44, degree 10, 65.1 bits */
    {0x1.ed43a5d63c2f2p+4, -0x1.9c11faee319c3p-53, -0x1.3bc2ad38e82dap-1, 0x1.b7519da6bb0b9p-3, -0x1.977bedb82524dp-4,
     0x1.a93366b37934dp-5, -0x1.d9445736eabf6p-6, 0x1.125b8f219bfdbp-6, -0x1.472ec1d2bbf1fp-7, 0x1.8e4f285f2128dp-8,
     -0x1.ee81d7ceaa071p-9, 0x1.35a06ea3711b2p-9}, /* [75] 1.375 <= y <= 1.5 2^-44, degree 10, 63.2 bits */
    {0x1.ec14de64e850ap+4, 0x1.0164bb7c0ccd7p-51, -0x1.227fe759cf8e7p-1, 0x1.73d6e5e35a168p-3, -0x1.3d4d8ff26c87p-4,
     0x1.309c60bccb018p-5, -0x1.37ebe7e4f58a7p-6, 0x1.4cb75d85b25a3p-7, -0x1.6d0935722b8bp-8, 0x1.98d71867d1be9p-9,
     -0x1.d2b260877e62dp-10, 0x1.0cd569e97672ap-10}, /* [76] 1.5 <= y <= 1.625 2^-44, degree 10, 65.5 bits */
    {0x1.eafd67809dd89p+4, -0x1.749f929ba7541p-52, -0x1.0cfb2bd1cdd64p-1, 0x1.3ecada52cba0fp-3, -0x1.f7c54aac4d22fp-5,
     0x1.bfcbcfd8e2c71p-6, -0x1.a893bb2b41d81p-7, 0x1.a355db518947ap-8, -0x1.a9fd890982a8dp-9, 0x1.b9c48a4c7cdfcp-10,
     -0x1.d2b60358c76ddp-11, 0x1.f1d9d690f1e6cp-12}, /* [77] 1.625 <= y <= 1.75 2^-44, degree 10, 63.6 bits */
    {0x1.e9f9eb557f989p+4, 0x1.860a68fe12ee6p-51, -0x1.f4dc870ca9581p-2, 0x1.145658528dcefp-3, -0x1.9690af9cdd733p-5,
     0x1.5077bce3445c2p-6, -0x1.2905105cbfd78p-7, 0x1.111f236fd655bp-8, -0x1.0252491bf7b59p-9, 0x1.f2d3d9542cf78p-11,
     -0x1.ea76e30d1fba1p-12, 0x1.e71a94cd69f15p-13}, /* [78] 1.75 <= y <= 1.875 2^-44, degree 10, 65.4 bits */
    {0x1.e907bf1c3534ap+4, -0x1.8ca2a79197e0bp-50, -0x1.d48c3cb6c4861p-2, 0x1.e3a9820a8a571p-4, -0x1.4cd7be24d05abp-5,
     0x1.01af486c23b2cp-6, -0x1.a99869ef1d358p-8, 0x1.6e1a816075c7bp-9, -0x1.43ecdb0f5f779p-10, 0x1.2493dd1ea41c7p-11,
     -0x1.0d07eba922ccap-12, 0x1.f3e5844a82688p-14}, /* [79] 1.875 <= y <= 2 2^-44, degree 10, 64.3 bits */
    {0x1.e7b850fa6e4aap+4, -0x1.b459c6f02adacp-50, -0x1.ab34924a5a72p-1, 0x1.921356745d18ep-2, -0x1.f890bae800882p-3,
     0x1.6429ecacdba0cp-3, -0x1.0c2b9d10ae906p-3, 0x1.a4a8cdea13a5ap-4, -0x1.53598ae2e1688p-4, 0x1.1776dc0eca0ccp-4,
     -0x1.d6ef1b030e7eep-5, 0x1.8ef60d86578cep-5}, /* [80] 1 <= y <= 1.125 2^-43, degree 10, 61.7 bits */
    {0x1.e6246dc0ebd5cp+4, 0x1.cd28845371651p-50, -0x1.7e3c838cbb166p-1, 0x1.41e218d013ddbp-2, -0x1.6969a5a657149p-3,
     0x1.c885720483ea1p-4, -0x1.338d1961e77d4p-4, 0x1.afa6980ad0fb1p-5, -0x1.379069be26549p-5, 0x1.cb259998474c1p-6,
     -0x1.59a5c8136f1b1p-6, 0x1.05fdfa7ab6599p-6}, /* [81] 1.125 <= y <= 1.25 2^-43, degree 10, 62.9 bits */
    {0x1.e4b9004802eb4p+4, -0x1.f04f5303eae3ep-52, -0x1.59d53aa23fc92p-1, 0x1.077ddf1ef685ap-2, -0x1.0bac9045d74dcp-3,
     0x1.31e9c8d090fb9p-4, -0x1.74ec3b1f1f18p-5, 0x1.d98d7f7adc905p-6, -0x1.3541b6d468b41p-6, 0x1.9c5794f523f75p-7,
     -0x1.188f4034b6671p-7, 0x1.80ccec96f18cep-8}, /* [82] 1.25 <= y <= 1.375 2^-43, degree 10, 64.0 bits */
    {0x1.e36ea903d0809p+4, -0x1.9b3ed5482109p-52, -0x1.3bc2b07638759p-1, 0x1.b7519fe7a4522p-3, -0x1.977bef49797e1p-4,
     0x1.a933681074a25p-5, -0x1.d944588acb941p-6, 0x1.125b8fd2efe6dp-6, -0x1.472ec2949518p-7, 0x1.8e4f293a4322dp-8,
     -0x1.ee81d8cd9d9d3p-9, 0x1.35a06f3a360dbp-9}, /* [83] 1.375 <= y <= 1.5 2^-43, degree 10, 64.5 bits */
    {0x1.e23fe18f509abp+4, 0x1.9c57de62fa6cdp-52, -0x1.227fea7542b52p-1, 0x1.73d6e7e06ffb3p-3, -0x1.3d4d91383d15bp-4,
     0x1.309c61c171d8ep-5, -0x1.37ebe8ce80c9dp-6, 0x1.4cb75e65e61bcp-7, -0x1.6d093653a71cdp-8, 0x1.98d71952523e4p-9,
     -0x1.d2b261825da6dp-10, 0x1.0cd56a71f2ec3p-10}, /* [84] 1.5 <= y <= 1.625 2^-43, degree 10, 63.6 bits */
    {0x1.e1286aa7f9fcfp+4, 0x1.557581673aa7ep-50, -0x1.0cfb2ecf39e36p-1, 0x1.3ecadc18606f9p-3, -0x1.f7c54cc5e1081p-5,
     0x1.bfcbd167176efp-6, -0x1.a893bc759ed44p-7, 0x1.a355dc773143cp-8, -0x1.a9fd8a1af7aap-9, 0x1.b9c48b53d116ep-10,
     -0x1.d2b6045d83716p-11, 0x1.f1d9d797a1535p-12}, /* [85] 1.625 <= y <= 1.75 2^-43, degree 10, 64.0 bits */
    {0x1.e024ee79ebfd2p+4, -0x1.ccdfe40aec771p-50, -0x1.f4dc8cd1c676p-2, 0x1.145659ea08155p-3, -0x1.9690b15e7ed5ep-5,
     0x1.5077be195b60fp-6, -0x1.2905114c4460bp-7, 0x1.111f24360f0d8p-8, -0x1.025249c7d30fap-9, 0x1.f2d3da88552c6p-11,
     -0x1.ea76e4291b42fp-12, 0x1.e71a95d7c9784p-13}, /* [86] 1.75 <= y <= 1.875 2^-43, degree 10, 65.4 bits */
    {0x1.df32c23dcb5aap+4, -0x1.89d74b4ed5c45p-50, -0x1.d48c424b703e4p-2, 0x1.e3a984ebea44p-4, -0x1.4cd7bfa164f14p-5,
     0x1.01af4961acd8ep-6, -0x1.a9986b51f3ec6p-8, 0x1.6e1a82732c865p-9, -0x1.43ecdbee2e9ap-10, 0x1.2493ddd983614p-11,
     -0x1.0d07ec4a319a1p-12, 0x1.f3e5856527e19p-14}, /* [87] 1.875 <= y <= 2 2^-43, degree 10, 65.3 bits */
    {0x1.dde35417edad4p+4, 0x1.84fd0b763702bp-51, -0x1.ab34979e8a1d7p-1, 0x1.921358f6548a4p-2, -0x1.f890bd4434aeap-3,
     0x1.6429ee1045977p-3, -0x1.0c2b9dfad6416p-3, 0x1.a4a8cf34a6085p-4, -0x1.53598bd755718p-4, 0x1.1776dcc9b9525p-4,
     -0x1.d6ef1c2a296e7p-5, 0x1.8ef60e7278663p-5}, /* [88] 1 <= y <= 1.125 2^-42, degree 10, 62.2 bits */
    {0x1.dc4f70d93cf52p+4, -0x1.c82da723ce9f5p-50, -0x1.7e3c88971f469p-1, 0x1.41e21aef65b22p-2, -0x1.6969a76fdf555p-3,
     0x1.c88573e620cebp-4, -0x1.338d1a7dcd6c1p-4, 0x1.afa6997164dcap-5, -0x1.37906aab5ed1p-5, 0x1.cb259aeebbe89p-6,
     -0x1.59a5c902f2d5ep-6, 0x1.05fdf40567b45p-6}, /* [89] 1.125 <= y <= 1.25 2^-42, degree 10, 63.6 bits */
    {0x1.dae4035b69eep+4, -0x1.3a9924e6a061ep-61, -0x1.59d53f6da811fp-1, 0x1.077de0f28b441p-2, -0x1.0bac91aa17d9bp-3,
     0x1.31e9ca23daa36p-4, -0x1.74ec3c8907415p-5, 0x1.d98d8118782c6p-6, -0x1.3541b7cc0273dp-6, 0x1.9c579627b1866p-7,
     -0x1.188f40f829acap-7, 0x1.80cced942113fp-8}, /* [90] 1.25 <= y <= 1.375 2^-42, degree 10, 65.3 bits */
    {0x1.d999ac128803fp+4, 0x1.67616c62d46d5p-50, -0x1.3bc2b50b0c98bp-1, 0x1.b751a317848a4p-3, -0x1.977bf1810a4e8p-4,
     0x1.a93369fdfdadap-5, -0x1.d9445a6b74a89p-6, 0x1.125b90cdb76b5p-6, -0x1.472ec3a6b9a86p-7, 0x1.8e4f2a7029a94p-8,
     -0x1.ee81da362bed2p-9, 0x1.35a0700f6e623p-9}, /* [91] 1.375 <= y <= 1.5 2^-42, degree 10, 66.4 bits */
    {0x1.d86ae4998bbbcp+4, -0x1.93d2e89586ae4p-50, -0x1.227feeda32d76p-1, 0x1.73d6eab064aa9p-3, -0x1.3d4d9305029d5p-4,
     0x1.309c63320fdcap-5, -0x1.37ebea18c8bbap-6, 0x1.4cb75fa2f7f8ep-7, -0x1.6d0937928892fp-8, 0x1.98d71a9df505ep-9,
     -0x1.d2b262e527123p-10, 0x1.0cd56b32f8383p-10}, /* [92] 1.5 <= y <= 1.625 2^-42, degree 10, 64.1 bits */
    {0x1.d7536dade5d2p+4, 0x1.c08a6e084654p-50, -0x1.0cfb3309b2d18p-1, 0x1.3ecade99d66f9p-3, -0x1.f7c54fbe20fb8p-5,
     0x1.bfcbd39a3d4efp-6, -0x1.a893be48d31a9p-7, 0x1.a355de167c2bdp-8, -0x1.a9fd8b9db1b31p-9, 0x1.b9c48cc8385d9p-10,
     -0x1.d2b605ce3f658p-11, 0x1.f1d9d90b1f8d1p-12}, /* [93] 1.625 <= y <= 1.75 2^-42, degree 10, 65.7 bits */
    {0x1.d64ff17bb0af4p+4, -0x1.6e8a01e7eb3dbp-50, -0x1.f4dc94fabbd49p-2, 0x1.14565c2a4ac79p-3, -0x1.9690b3da5e752p-5,
     0x1.5077bfcfe3ef1p-6, -0x1.2905129eff104p-7, 0x1.111f254e62ed8p-8, -0x1.02524abadde3cp-9, 0x1.f2d3dc3c21f41p-11,
     -0x1.ea76e5bab7efep-12, 0x1.e71a97507edbep-13}, /* [94] 1.75 <= y <= 1.875 2^-42, degree 10, 69.4 bits */
    {0x1.d55dc53b8cfbbp+4, 0x1.a861fa58ea424p-51, -0x1.d48c4a2fe3624p-2, 0x1.e3a988feb87d6p-4, -0x1.4cd7c1bb9dcb8p-5,
     0x1.01af4abcea4a7p-6, -0x1.a9986d47c5478p-8, 0x1.6e1a83f7ad91fp-9, -0x1.43ecdd2948205p-10, 0x1.2493dee1ca541p-11,
     -0x1.0d07ed2df6c42p-12, 0x1.f3e586f4e0cebp-14}, /* [95] 1.875 <= y <= 2 2^-42, degree 10, 65.5 bits */
    {0x1.d40e570fe6f4ep+4, -0x1.862ef28a36442p-51, -0x1.ab349f27cb579p-1, 0x1.92135c823552dp-2, -0x1.f890c09aadd4p-3,
     0x1.6429f006e7313p-3, -0x1.0c2b9f45fb724p-3, 0x1.a4a8d10825d3ap-4, -0x1.53598d310afc5p-4, 0x1.1776ddd216e6ep-4,
     -0x1.d6ef1dcb80f1p-5, 0x1.8ef60fc067fcbp-5}, /* [96] 1 <= y <= 1.125 2^-41, degree 10, 62.3 bits */
    {0x1.d27a73c9e29d2p+4, -0x1.49f7c9474a2cfp-52, -0x1.7e3c8fb803e81p-1, 0x1.41e21defc478bp-2, -0x1.6969a9f6ebb9fp-3,
     0x1.c885768f3b4e3p-4, -0x1.338d1c0f4b851p-4, 0x1.afa69b6c8adfcp-5, -0x1.37906bfaeca85p-5, 0x1.cb259cb9e9b7bp-6,
     -0x1.59a5ca46d3812p-6, 0x1.05fdf4ed4499dp-6}, /* [97] 1.125 <= y <= 1.25 2^-41, degree 10, 63.5 bits */
    {0x1.d10f06451c57fp+4, -0x1.34d6d508be8cbp-51, -0x1.59d546357a0d3p-1, 0x1.077de387cdba7p-2, -0x1.0bac93a1e8ec8p-3,
     0x1.31e9cc03adee5p-4, -0x1.74ec3e88d78efp-5, 0x1.d98d8361663a2p-6, -0x1.3541b92a2b728p-6, 0x1.9c5797d939902p-7,
     -0x1.188f420c923d8p-7, 0x1.80cceefa30154p-8}, /* [98] 1.25 <= y <= 1.375 2^-41, degree 10, 63.5 bits */
    {0x1.cfc4aef59a146p+4, -0x1.25ac8d7fba408p-51, -0x1.3bc2bb85aef8dp-1, 0x1.b751a799573cbp-3, -0x1.977bf4a3b3125p-4,
     0x1.a9336cb7f494ap-5, -0x1.d9445d13365cp-6, 0x1.125b92305f424p-6, -0x1.472ec52a6bf93p-7, 0x1.8e4f2c266da23p-8,
     -0x1.ee81dc34131eap-9, 0x1.35a0713cf84a5p-9}, /* [99] 1.375 <= y <= 1.5 2^-41, degree 10, 63.1 bits */
    {0x1.ce95e77645bb9p+4, 0x1.b4deb27044376p-51, -0x1.227ff5111af2ep-1, 0x1.73d6eeaa90965p-3, -0x1.3d4d9590a3c96p-4,
     0x1.309c653b5d94dp-5, -0x1.37ebebebdf419p-6, 0x1.4cb761635f822p-7, -0x1.6d0939557fbc3p-8, 0x1.98d71c72f60a9p-9,
     -0x1.d2b264dae59f9p-10, 0x1.0cd56c43f12e3p-10}, /* [100] 1.5 <= y <= 1.625 2^-41, degree 10, 67.4 bits */
    {0x1.cd7e70848784cp+4, 0x1.0c2c53caedd09p-51, -0x1.0cfb39048cb7bp-1, 0x1.3ecae225002cbp-3, -0x1.f7c553f148defp-5,
     0x1.bfcbd6b6a6ad9p-6, -0x1.a893c0dd8d1d8p-7, 0x1.a355e061cc2c6p-8, -0x1.a9fd8dc09bbc9p-9, 0x1.b9c48ed6e0d2p-10,
     -0x1.d2b607d7b7728p-11, 0x1.f1d9db187e6bcp-12}, /* [101] 1.625 <= y <= 1.75 2^-41, degree 10, 64.2 bits */
    {0x1.cc7af44c72e07p+4, -0x1.efa85cfbde71ap-50, -0x1.f4dca084f9a4ap-2, 0x1.14565f593f72p-3, -0x1.9690b75da1505p-5,
     0x1.5077c23c1204ap-6, -0x1.2905147e082aap-7, 0x1.111f26dad463p-8, -0x1.02524c12949c8p-9, 0x1.f2d3dea472657p-11,
     -0x1.ea76e7f2af083p-12, 0x1.e71a99653def9p-13}, /* [102] 1.75 <= y <= 1.875 2^-41, degree 10, 65.5 bits */
    {0x1.cb88c806a2ae1p+4, -0x1.a4f755d7687d5p-51, -0x1.d48c55593e634p-2, 0x1.e3a98ec1788eep-4, -0x1.4cd7c4b4c70bcp-5,
     0x1.01af4ca7fca08p-6, -0x1.a998700d72c17p-8, 0x1.6e1a861d1b179p-9, -0x1.43ecdee6e66b5p-10, 0x1.2493e05788e29p-11,
     -0x1.0d07ee701462dp-12, 0x1.f3e5892a2bc72p-14}, /* [103] 1.875 <= y <= 2 2^-41, degree 10, 64.1 bits */
    {0x1.ca3959d2cf1dep+4, -0x1.20064060138b9p-53, -0x1.ab34a9d02e3ap-1, 0x1.9213618624681p-2, -0x1.f890c5531640cp-3,
     0x1.6429f2cdbb2d7p-3, -0x1.0c2ba11a4adccp-3, 0x1.a4a8d39d4aa39p-4, -0x1.53598f19f3156p-4, 0x1.1776df47f5771p-4,
     -0x1.d6ef2019b6d7ap-5, 0x1.8ef61198a9b4dp-5}, /* [104] 1 <= y <= 1.125 2^-40, degree 10, 62.4 bits */
    {0x1.c8a576826e3bfp+4, -0x1.ef9b9086cbf54p-50, -0x1.7e3c99cccfce1p-1, 0x1.41e2222e684eep-2, -0x1.6969ad89fc54ep-3,
     0x1.c8857a527529fp-4, -0x1.338d1e4717618p-4, 0x1.afa69e39c2441p-5, -0x1.37906dd578391p-5, 0x1.cb259f434a45dp-6,
     -0x1.59a5cc10dbbd4p-6, 0x1.05fdf6352bf02p-6}, /* [105] 1.125 <= y <= 1.25 2^-40, degree 10, 63.3 bits */
    {0x1.c73a08f3d3ba1p+4, 0x1.31e7f3d3bee5p-50, -0x1.59d54fcc4e1f1p-1, 0x1.077de72ef7605p-2, -0x1.0bac966a6a192p-3,
     0x1.31e9ceaa414ddp-4, -0x1.74ec415ca7f02p-5, 0x1.d98d869c9d80fp-6, -0x1.3541bb195efap-6, 0x1.9c579a3e54b74p-7,
     -0x1.188f439378cep-7, 0x1.80ccf0f48f29cp-8}, /* [106] 1.25 <= y <= 1.375 2^-40, degree 10, 66.0 bits */
    {0x1.c5efb19af2745p+4, 0x1.b4300ae42acf3p-52, -0x1.3bc2c4af5aba7p-1, 0x1.b751adf917f7bp-3, -0x1.977bf912d4d5fp-4,
     0x1.a933709306c36p-5, -0x1.d94460d488992p-6, 0x1.125b9425ee54bp-6, -0x1.472ec74eb5233p-7, 0x1.8e4f2e923ab8bp-8,
     -0x1.ee81df052fc8ep-9, 0x1.35a072e768f92p-9}, /* [107] 1.375 <= y <= 1.5 2^-40, degree 10, 63.9 bits */
    {0x1.c4c0ea12a5535p+4, 0x1.50fbf985eb7e3p-57, -0x1.227ffddafeae4p-1, 0x1.73d6f44a7a39ep-3, -0x1.3d4d992a2ef5fp-4,
     0x1.309c681c99af1p-5, -0x1.37ebee806f339p-6, 0x1.4cb763dd8348bp-7, -0x1.6d093bd342b3bp-8, 0x1.98d71f0a3ba4bp-9,
     -0x1.d2b267a078811p-10, 0x1.0cd56dc5fbcbbp-10}, /* [108] 1.5 <= y <= 1.625 2^-40, degree 10, 64.0 bits */
    {0x1.c3a9731848812p+4, -0x1.6f782a99acc4bp-51, -0x1.0cfb41798206bp-1, 0x1.3ecae727ec6c7p-3, -0x1.f7c559e1c8f81p-5,
     0x1.bfcbdb1cf28b6p-6, -0x1.a893c483f5bf5p-7, 0x1.a355e3a0620d6p-8, -0x1.a9fd90c60fdcep-9, 0x1.b9c491bfaf6cp-10,
     -0x1.d2b60ab92f666p-11, 0x1.f1d9ddff7aea6p-12}, /* [109] 1.625 <= y <= 1.75 2^-40, degree 10, 66.4 bits */
    {0x1.c2a5f6d7e5937p+4, 0x1.0c2000a60fa82p-51, -0x1.f4dcb0d6eb3f9p-2, 0x1.145663d9c511cp-3, -0x1.9690bc5560ba9p-5,
     0x1.5077c5a92339p-6, -0x1.290517237d99bp-7, 0x1.111f290b7c2ecp-8, -0x1.02524df8aa4dfp-9, 0x1.f2d3e20c0c043p-11,
     -0x1.ea76eb15e86f3p-12, 0x1.e71a9c56a8c27p-13}, /* [110] 1.75 <= y <= 1.875 2^-40, degree 10, 63.9 bits */
    {0x1.c1b3ca8a0f3bap+4, -0x1.a2eae06a956c8p-50, -0x1.d48c65222b81ep-2, 0x1.e3a996e715709p-4, -0x1.4cd7c8e938e67p-5,
     0x1.01af4f5e77976p-6, -0x1.a99873f915901p-8, 0x1.6e1a89261d3fbp-9, -0x1.43ece15d19845p-10, 0x1.2493e26816d1cp-11,
     -0x1.0d07f0379ebecp-12, 0x1.f3e58c499dae3p-14}, /* [111] 1.875 <= y <= 2 2^-40, degree 10, 64.4 bits */
    {0x1.c0645c4aaaf35p+4, -0x1.f80225b01f65fp-56, -0x1.ab34b8e2b77aep-1, 0x1.9213689de65e6p-2, -0x1.f890cc0008cbp-3,
     0x1.6429f6bafe7eep-3, -0x1.0c2ba3b0954f7p-3, 0x1.a4a8d7444a4f6p-4, -0x1.535991cd5e395p-4, 0x1.1776e158b0aa2p-4,
     -0x1.d6ef235c65eb8p-5, 0x1.8ef6143488ed1p-5}, /* [112] 1 <= y <= 1.125 2^-39, degree 10, 62.5 bits */
    {0x1.bed078eba2cb7p+4, -0x1.83feb99c3807ep-50, -0x1.7e3ca80e9fd1dp-1, 0x1.41e2282f26369p-2, -0x1.6969b2981550fp-3,
     0x1.c8857fa4aa53cp-4, -0x1.338d216a13a91p-4, 0x1.afa6a2300e62ap-5, -0x1.3790707493f66p-5, 0x1.cb25a2d9a5f67p-6,
     -0x1.59a5ce989d1fep-6, 0x1.05fdf804e5c34p-6}, /* [113] 1.125 <= y <= 1.25 2^-39, degree 10, 62.9 bits */
    {0x1.bd650b4f21c6bp+4, -0x1.53ef00f791112p-50, -0x1.59d55d5bf8cb8p-1, 0x1.077dec597c9efp-2, -0x1.0bac9a5a0c686p-3,
     0x1.31e9d269e8036p-4, -0x1.74ec455c48a85p-5, 0x1.d98d8b2e79b9dp-6, -0x1.3541bdd5b1077p-6, 0x1.9c579da164dd1p-7,
     -0x1.188f45bc49fabp-7, 0x1.80ccf3c0ad39bp-8}, /* [114] 1.25 <= y <= 1.375 2^-39, degree 10, 63.4 bits */
    {0x1.bc1ab3e8ffc73p+4, -0x1.1a0d06ea16891p-50, -0x1.3bc2d1a4a626fp-1, 0x1.b751b6fcbdf23p-3, -0x1.977bff5826a3p-4,
     0x1.a9337606f4c1bp-5, -0x1.d94466240c285p-6, 0x1.125b96eb3e152p-6, -0x1.472eca5619d77p-7, 0x1.8e4f31fec2bdep-8,
     -0x1.ee81e300fe41p-9, 0x1.35a075427cd51p-9}, /* [115] 1.375 <= y <= 1.5 2^-39, degree 10, 64.6 bits */
    {0x1.baebec54027e6p+4, 0x1.621cbbdd8df51p-50, -0x1.22800a48d5887p-1, 0x1.73d6fc3ed29afp-3, -0x1.3d4d9e417188cp-4,
     0x1.309c6c2f3544fp-5, -0x1.37ebf2269c5c5p-6, 0x1.4cb7675e5273ep-7, -0x1.6d093f59311ccp-8, 0x1.98d722b43dc3bp-9,
     -0x1.d2b26b8bf5b16p-10, 0x1.0cd56fe7edc2ap-10}, /* [116] 1.5 <= y <= 1.625 2^-39, degree 10, 63.6 bits */
    {0x1.b9d4754d750b5p+4, 0x1.92e568dffb6d9p-50, -0x1.0cfb4d6f3c6ep-1, 0x1.3ecaee3e40661p-3, -0x1.f7c562481923ap-5,
     0x1.bfcbe155c5845p-6, -0x1.a893c9ad69efbp-7, 0x1.a355e837022ffp-8, -0x1.a9fd950be40c5p-9, 0x1.b9c495dd006e2p-10,
     -0x1.d2b60ecc1f97cp-11, 0x1.f1d9e21a38bdep-12}, /* [117] 1.625 <= y <= 1.75 2^-39, degree 10, 63.6 bits */
    {0x1.b8d0f9015314p+4, -0x1.81fef8bae7d04p-50, -0x1.f4dcc7eb74064p-2, 0x1.14566a37aedd3p-3, -0x1.9690c35be6c83p-5,
     0x1.5077ca817f945p-6, -0x1.29051ae18fee5p-7, 0x1.111f2c245f312p-8, -0x1.025250a817d1ep-9, 0x1.f2d3e6dcad058p-11,
     -0x1.ea76ef85d6ba3p-12, 0x1.e71aa08027011p-13}, /* [118] 1.75 <= y <= 1.875 2^-39, degree 10, 66.0 bits */
    {0x1.b7decca823b7fp+4, -0x1.e09f28c8185e4p-50, -0x1.d48c7b74ee9c1p-2, 0x1.e3a9a26c96716p-4, -0x1.4cd7cedb8bb34p-5,
     0x1.01af53349c6afp-6, -0x1.a998798470b4dp-8, 0x1.6e1a8d70f86c9p-9, -0x1.43ece4d856333p-10, 0x1.2493e5539401fp-11,
     -0x1.0d07f2bbda0b9p-12, 0x1.f3e590b433b87p-14}, /* [119] 1.875 <= y <= 2 2^-39, degree 10, 66.2 bits */
    {0x1.b68f5e5864532p+4, 0x1.9e5f5af7c025p-50, -0x1.ab34ce338a442p-1, 0x1.921372a5c5535p-2, -0x1.f890d570da237p-3,
     0x1.6429fc48a6b33p-3, -0x1.0c2ba75934461p-3, 0x1.a4a8dc6e9419ap-4, -0x1.5359959f2e87fp-4, 0x1.1776e4446ddeap-4,
     -0x1.d6ef27f8d1d65p-5, 0x1.8ef617e50c739p-5}, /* [120] 1 <= y <= 1.125 2^-38, degree 10, 62.1 bits */
    {0x1.b4fb7ae4a309dp+4, 0x1.9cccb40823917p-50, -0x1.7e3cbc38448a3p-1, 0x1.41e230ac6e97fp-2, -0x1.6969b9be36ec8p-3,
     0x1.c885872b1e60fp-4, -0x1.338d25d9ab8d4p-4, 0x1.afa6a7ca7d5bcp-5, -0x1.37907429ab351p-5, 0x1.cb25a7ec6737ap-6,
     -0x1.59a5d22cadb05p-6, 0x1.05fdfa94b4804p-6}, /* [121] 1.125 <= y <= 1.25 2^-38, degree 10, 62.3 bits */
    {0x1.b3900d34797efp+4, 0x1.ed8b1d5b6da11p-53, -0x1.59d57089adc64p-1, 0x1.077df3a7d08e7p-2, -0x1.0bac9feb0f14dp-3,
     0x1.31e9d7b70f01dp-4, -0x1.74ec4b03e9a4ap-5, 0x1.d98d91a4e8826p-6, -0x1.3541c1b418368p-6, 0x1.9c57a26b9b4ffp-7,
     -0x1.188f48ca17318p-7, 0x1.80ccf7b56b7d5p-8}, /* [122] 1.25 <= y <= 1.375 2^-38, degree 10, 64.7 bits */
    {0x1.b245b5bb996e4p+4, -0x1.8c0266d8c14f8p-52, -0x1.3bc2e3f80a6d8p-1, 0x1.b751c3bc40935p-3, -0x1.977c08366ab4ep-4,
     0x1.a9337dbd197fap-5, -0x1.d9446da6b0f32p-6, 0x1.125b9ad65c5f6p-6, -0x1.472ece9eac508p-7, 0x1.8e4f36d65d11bp-8,
     -0x1.ee81e8a337bfap-9, 0x1.35a078975e4a3p-9}, /* [123] 1.375 <= y <= 1.5 2^-38, degree 10, 66.9 bits */
    {0x1.b116ee14aa885p+4, -0x1.4fcc8c5f91a47p-53, -0x1.22801bdca9b0ap-1, 0x1.73d7077ea6f54p-3, -0x1.3d4da57488576p-4,
     0x1.309c71f1adc4bp-5, -0x1.37ebf74fbc7a1p-6, 0x1.4cb76c529a324p-7, -0x1.6d094454b738dp-8, 0x1.98d727e2c9232p-9,
     -0x1.d2b271171b9f8p-10, 0x1.0cd572ec0313cp-10}, /* [124] 1.5 <= y <= 1.625 2^-38, degree 10, 63.0 bits */
    {0x1.afff76fcdfd1dp+4, 0x1.e9c5f044141fap-51, -0x1.0cfb5e5933acfp-1, 0x1.3ecaf84419e45p-3, -0x1.f7c56e291a1f5p-5,
     0x1.bfcbea225db74p-6, -0x1.a893d0fa3b882p-7, 0x1.a355eeb42e34fp-8, -0x1.a9fd9b16cc859p-9, 0x1.b9c49bae9dd49p-10,
     -0x1.d2b6148f0faep-11, 0x1.f1d9e7e831e73p-12}, /* [125] 1.625 <= y <= 1.75 2^-38, degree 10, 63.1 bits */
    {0x1.aefbfaa0213b4p+4, -0x1.02b535b37bfd1p-50, -0x1.f4dce88f705f3p-2, 0x1.14567338bb0ap-3, -0x1.9690cd4b664b2p-5,
     0x1.5077d15ba25d5p-6, -0x1.2905202c7b0c4p-7, 0x1.111f3085aef79p-8, -0x1.025254744359cp-9, 0x1.f2d3edabe0804p-11,
     -0x1.ea76f5cc49bccp-12, 0x1.e71aa662fcd54p-13}, /* [126] 1.75 <= y <= 1.875 2^-38, degree 10, 67.7 bits */
    {0x1.ae09ce36e587ap+4, 0x1.7e33594a0d646p-50, -0x1.d48c9b06e1dfep-2, 0x1.e3a9b2b7d1f0bp-4, -0x1.4cd7d74470017p-5,
     0x1.01af58a192a78p-6, -0x1.a998815bb6b3ap-8, 0x1.6e1a9382fdp-9, -0x1.43ece9c4bc96cp-10, 0x1.2493e974b006bp-11,
     -0x1.0d07f64aeee23p-12, 0x1.f3e596f317b9ap-14}, /* [127] 1.875 <= y <= 2 2^-38, degree 10, 64.6 bits */
    {0x1.acba5fd0049ffp+4, 0x1.687e78e3de90ap-50, -0x1.ab34ec58b5a4ap-1, 0x1.921380d54ad49p-2, -0x1.f890e2cac035dp-3,
     0x1.642a04232dcd9p-3, -0x1.0c2bac85c96fp-3, 0x1.a4a8e3bc93c5ep-4, -0x1.53599b060508cp-4, 0x1.1776e865e46dp-4,
     -0x1.d6ef2e7e30393p-5, 0x1.8ef61d1ccb10ap-5}, /* [128] 1 <= y <= 1.125 2^-37, degree 10, 61.7 bits */
    {0x1.ab267c3ef4b2p+4, 0x1.b5f44eb843c2ep-52, -0x1.7e3cd8bbfd40ap-1, 0x1.41e23cadebd15p-2, -0x1.6969c3da69afep-3,
     0x1.c88591cf895fcp-4, -0x1.338d2c1fa472fp-4, 0x1.afa6afb715f9fp-5, -0x1.37907967e2eap-5, 0x1.cb25af191ee2bp-6,
     -0x1.59a5d73c30a63p-6, 0x1.05fdfe3428473p-6}, /* [129] 1.125 <= y <= 1.25 2^-37, degree 10, 63.9 bits */
    {0x1.a9bb0e72fe08bp+4, -0x1.17059a3bced73p-50, -0x1.59d58ba91ba31p-1, 0x1.077dfdfcdc535p-2, -0x1.0baca7ca5459cp-3,
     0x1.31e9df365cebbp-4, -0x1.74ec53032b88ep-5, 0x1.d98d9ac8a169ep-6, -0x1.3541c72cbc918p-6, 0x1.9c57a931bbe4dp-7,
     -0x1.188f4d1bb9b66p-7, 0x1.80ccfd4da7d25p-8}, /* [130] 1.25 <= y <= 1.375 2^-37, degree 10, 63.3 bits */
    {0x1.a870b6df9c6c1p+4, 0x1.0f9a22be4e8f9p-52, -0x1.3bc2fde2b9a34p-1, 0x1.b751d5c38ede7p-3, -0x1.977c14c10f647p-4,
     0x1.a93388a4f63d6p-5, -0x1.d9447845b8b29p-6, 0x1.125ba060fc2b1p-6, -0x1.472ed4ad76035p-7, 0x1.8e4f3daf6d699p-8,
     -0x1.ee81f09ad503fp-9, 0x1.35a07d4d8630cp-9}, /* [131] 1.375 <= y <= 1.5 2^-37, degree 10, 62.6 bits */
    {0x1.a741ef1f4d1e5p+4, -0x1.6ffc4262c1c8fp-52, -0x1.228034b86f9ep-1, 0x1.73d7176759ddcp-3, -0x1.3d4dafa30e67cp-4,
     0x1.309c7a16e586ap-5, -0x1.37ebfe9c173efp-6, 0x1.4cb7735438eb2p-7, -0x1.6d094b609464fp-8, 0x1.98d72f36cdb79p-9,
     -0x1.d2b278ee16567p-10, 0x1.0cd5772fe72dep-10}, /* [132] 1.5 <= y <= 1.625 2^-37, degree 10, 65.4 bits */
    {0x1.a62a77ef210dfp+4, 0x1.1d8c6a6dcfb22p-51, -0x1.0cfb7644c0937p-1, 0x1.3ecb0670c3d53p-3, -0x1.f7c57ef5bc091p-5,
     0x1.bfcbf6940497cp-6, -0x1.a893db4d24927p-7, 0x1.a355f7e16f003p-8, -0x1.a9fda3a27555fp-9, 0x1.b9c4a3e9403dcp-10,
     -0x1.d2b61cb4f06ep-11, 0x1.f1d9f01dade69p-12}, /* [133] 1.625 <= y <= 1.75 2^-37, degree 10, 63.7 bits */
    {0x1.a526fb7ae44bfp+4, -0x1.03b45f4160906p-53, -0x1.f4dd16b8b1dedp-2, 0x1.14567ff4907b4p-3, -0x1.9690db5873c37p-5,
     0x1.5077db0c5bd47p-6, -0x1.290527a8a034fp-7, 0x1.111f36b7755a1p-8, -0x1.025259d31eabap-9, 0x1.f2d3f74d22fd3p-11,
     -0x1.ea76feac26bbfp-12, 0x1.e71aaeb5f9af6p-13}, /* [134] 1.75 <= y <= 1.875 2^-37, degree 10, 63.8 bits */
    {0x1.a434cefaf678p+4, -0x1.63d6d9c51ea78p-51, -0x1.d48cc7ac97cd1p-2, 0x1.e3a9c9c2d769fp-4, -0x1.4cd7e32916cc9p-5,
     0x1.01af604ddcec3p-6, -0x1.a9988c726dc07p-8, 0x1.6e1a9c18b3e02p-9, -0x1.43ecf0bb36579p-10, 0x1.2493ef4baab3cp-11,
     -0x1.0d07fb5365b9ap-12, 0x1.f3e59fc84434p-14}, /* [135] 1.875 <= y <= 2 2^-37, degree 10, 65.5 bits */
    {0x1.a2e560735f33bp+4, -0x1.9a20345442ebep-54, -0x1.ab3516fa8aa0ap-1, 0x1.921394e50be7ap-2, -0x1.f890f5ac64e29p-3,
     0x1.642a0f3e7f251p-3, -0x1.0c2bb3d707e34p-3, 0x1.a4a8ee112803cp-4, -0x1.5359a2a9a617bp-4, 0x1.1776ee3d5f265p-4,
     -0x1.d6ef37b708852p-5, 0x1.8ef6247dd276dp-5}, /* [136] 1 <= y <= 1.125 2^-36, degree 10, 62.2 bits */
    {0x1.a1517cb8dcd3bp+4, -0x1.38f5346ec1e8ep-52, -0x1.7e3d010f75bb4p-1, 0x1.41e24da87f684p-2, -0x1.6969d226ae7d9p-3,
     0x1.c885a0dc72d07p-4, -0x1.338d34fed4e83p-4, 0x1.afa6baebf4ae8p-5, -0x1.379080d211dc5p-5, 0x1.cb25b93ea1f89p-6,
     -0x1.59a5de6452284p-6, 0x1.05fe0353c602bp-6}, /* [137] 1.125 <= y <= 1.25 2^-36, degree 10, 62.9 bits */
    {0x1.9fe60ec594ef3p+4, -0x1.d0d1055434897p-52, -0x1.59d5b204b44c4p-1, 0x1.077e0c9986c17p-2, -0x1.0bacb2ec5aff6p-3,
     0x1.31e9e9d0abe61p-4, -0x1.74ec5e526e695p-5, 0x1.d98da7b57fe68p-6, -0x1.3541cee98b6fap-6, 0x1.9c57b2c6295d1p-7,
     -0x1.188f5337547b2p-7, 0x1.80cd053724c3dp-8}, /* [138] 1.25 <= y <= 1.375 2^-36, degree 10, 64.1 bits */
    {0x1.9e9bb70cb701ap+4, 0x1.7bf41a23dbac3p-53, -0x1.3bc32289b095fp-1, 0x1.b751ef4298cd1p-3, -0x1.977c267d99b32p-4,
     0x1.a9339811413b3p-5, -0x1.d944874b038a8p-6, 0x1.125ba8373955p-6, -0x1.472edd3e9b89fp-7, 0x1.8e4f475ea2ac1p-8,
     -0x1.ee81fbdf48a95p-9, 0x1.35a083f74978bp-9}, /* [139] 1.375 <= y <= 1.5 2^-36, degree 10, 65.5 bits */
    {0x1.9d6cef28844b5p+4, -0x1.415fa576b7faap-50, -0x1.228057e0460c3p-1, 0x1.73d72de706dfp-3, -0x1.3d4dbe093ddabp-4,
     0x1.309c859bd7b2bp-5, -0x1.37ec08ee58615p-6, 0x1.4cb77d3cc92cdp-7, -0x1.6d095557a1512p-8, 0x1.98d73993e5235p-9,
     -0x1.d2b2840462df6p-10, 0x1.0cd57d3812286p-10}, /* [140] 1.5 <= y <= 1.625 2^-36, degree 10, 62.9 bits */
    {0x1.9c5577d5dd862p+4, -0x1.8df8f12ec6613p-50, -0x1.0cfb9818dcedp-1, 0x1.3ecb1a7c7accbp-3, -0x1.f7c596b7c125ap-5,
     0x1.bfcc082d36dadp-6, -0x1.a893e9e6c916cp-7, 0x1.a35604dbc8165p-8, -0x1.a9fdafb8472b8p-9, 0x1.b9c4af8c7bd47p-10,
     -0x1.d2b6283ad154fp-11, 0x1.f1d9fbb9a0eap-12}, /* [141] 1.625 <= y <= 1.75 2^-36, degree 10, 63.5 bits */
    {0x1.9b51fb406757ep+4, 0x1.b3dceac6614adp-51, -0x1.f4dd580105cd2p-2, 0x1.145691f6ac89bp-3, -0x1.9690ef3775835p-5,
     0x1.5077e8c0a2e7bp-6, -0x1.2905323e776fcp-7, 0x1.111f3f7a15a28p-8, -0x1.0252616b764f2p-9, 0x1.f2d404eb8ae75p-11,
     -0x1.ea770b390d938p-12, 0x1.e71aba7ba6118p-13}, /* [142] 1.75 <= y <= 1.875 2^-36, degree 10, 63.7 bits */
    {0x1.9a5fcea060a76p+4, 0x1.ba4a3f76cd381p-50, -0x1.d48d06d0d91e6p-2, 0x1.e3a9ea595557ap-4, -0x1.4cd7f3fae1cbbp-5,
     0x1.01af6b27caa0ap-6, -0x1.a9989c20fb44bp-8, 0x1.6e1aa83cbe13dp-9, -0x1.43ecfa9403e4ep-10, 0x1.2493f78de356bp-11,
     -0x1.0d0802718fe24p-12, 0x1.f3e5ac460d022p-14}, /* [143] 1.875 <= y <= 2 2^-36, degree 10, 64.6 bits */
    {0x1.99105fea86196p+4, 0x1.d97bdc44b686fp-52, -0x1.ab3553453b8c8p-1, 0x1.9213b1441d3ccp-2, -0x1.f891106034ffp-3,
     0x1.642a1ef38f37cp-3, -0x1.0c2bbe303342fp-3, 0x1.a4a8fcad28afp-4, -0x1.5359ad7753fd1p-4, 0x1.1776f6804ce3cp-4,
     -0x1.d6ef44c1c6379p-5, 0x1.8ef62eed50631p-5}, /* [144] 1 <= y <= 1.125 2^-35, degree 10, 62.3 bits */
    {0x1.977c7bf566165p+4, -0x1.b6c41dbb05f06p-55, -0x1.7e3d3a174093ap-1, 0x1.41e265ab7f833p-2, -0x1.6969e65f17316p-3,
     0x1.c885b6254b7acp-4, -0x1.338d418ac80d8p-4, 0x1.afa6cac5276f5p-5, -0x1.37908b4e822fdp-5, 0x1.cb25c7981275dp-6,
     -0x1.59a5e88358d61p-6, 0x1.05fe0a92ae137p-6}, /* [145] 1.125 <= y <= 1.25 2^-35, degree 10, 62.3 bits */
    {0x1.96110dca839bep+4, -0x1.848fab9172463p-50, -0x1.59d5e843e8c55p-1, 0x1.077e2143a3696p-2, -0x1.0bacc2aae822dp-3,
     0x1.31e9f8cf49b4fp-4, -0x1.74ec6e50f4018p-5, 0x1.d98db9fcf38c8p-6, -0x1.3541d9dad526p-6, 0x1.9c57c0526babdp-7,
     -0x1.188f5bda9a332p-7, 0x1.80cd10679e422p-8}, /* [146] 1.25 <= y <= 1.375 2^-35, degree 10, 65.8 bits */
    {0x1.94c6b5dca23e1p+4, -0x1.dc62b99223ddep-51, -0x1.3bc3565f67249p-1, 0x1.b75213513ebbcp-3, -0x1.977c3f92e767ep-4,
     0x1.a933ade0fdbaap-5, -0x1.d9449c89158dcp-6, 0x1.125bb34c7a173p-6, -0x1.472ee95c30188p-7, 0x1.8e4f5510c491ep-8,
     -0x1.ee820bce84826p-9, 0x1.35a08d639a012p-9}, /* [147] 1.375 <= y <= 1.5 2^-35, degree 10, 62.9 bits */
    {0x1.9397edc5ae603p+4, 0x1.58b4414cc2b05p-50, -0x1.22808998297a9p-1, 0x1.73d74db875491p-3, -0x1.3d4dd2664da6bp-4,
     0x1.309c95e6498fcp-5, -0x1.37ec17870fb8cp-6, 0x1.4cb78b4008288p-7, -0x1.6d09636f5d119p-8, 0x1.98d7483befa6p-9,
     -0x1.d2b293b259a66p-10, 0x1.0cd585bfdb0d7p-10}, /* [148] 1.5 <= y <= 1.625 2^-35, degree 10, 63.8 bits */
    {0x1.92807642448ffp+4, 0x1.ed6accc5251cfp-52, -0x1.0cfbc7f04dc94p-1, 0x1.3ecb36d5d6a49p-3, -0x1.f7c5b8510b439p-5,
     0x1.bfcc211088563p-6, -0x1.a893fe8c9dd22p-7, 0x1.a35617364bc51p-8, -0x1.a9fdc0cf9a924p-9, 0x1.b9c4c001c23a5p-10,
     -0x1.d2b638869449bp-11, 0x1.f1da0c249a4a5p-12}, /* [149] 1.625 <= y <= 1.75 2^-35, degree 10, 62.8 bits */
    {0x1.917cf97dd1b41p+4, 0x1.2b08ae905c34cp-50, -0x1.f4ddb45435f54p-2, 0x1.1456ab6e5ed5cp-3, -0x1.96910b5195e7ep-5,
     0x1.5077fc2218d81p-6, -0x1.29054136c3bf2p-7, 0x1.111f4bdda3debp-8, -0x1.02526c292e1a9p-9, 0x1.f2d4182e11ca9p-11,
     -0x1.ea771cf8c936bp-12, 0x1.e71acb21a1395p-13}, /* [150] 1.75 <= y <= 1.875 2^-35, degree 10, 64.3 bits */
    {0x1.908accb0666c8p+4, 0x1.49a2afc162811p-50, -0x1.d48d601cf13c5p-2, 0x1.e3aa186f6e283p-4, -0x1.4cd80bc434279p-5,
     0x1.01af7a8061a0ap-6, -0x1.a998b24e6c6b7p-8, 0x1.6e1ab9682ded8p-9, -0x1.43ed0880f8f2dp-10, 0x1.2494033bd9e3bp-11,
     -0x1.0d080c827e87dp-12, 0x1.f3e5bdf0678e8p-14}, /* [151] 1.875 <= y <= 2 2^-35, degree 10, 63.7 bits */
    {0x1.8f3b5db91ea49p+4, -0x1.08911291d34eep-50, -0x1.ab35a889908a3p-1, 0x1.9213d963ac07bp-2, -0x1.f89136238647ap-3,
     0x1.642a352a35a2cp-3, -0x1.0c2bccd2b2474p-3, 0x1.a4a9115653d01p-4, -0x1.5359bcbe97e27p-4, 0x1.1777022f4397ep-4,
     -0x1.d6ef573378a8cp-5, 0x1.8ef63daf6093ep-5}, /* [152] 1 <= y <= 1.125 2^-34, degree 10, 61.3 bits */
    {0x1.8da7797119132p+4, -0x1.81b2900a695d7p-51, -0x1.7e3d8abedb104p-1, 0x1.41e287a0b2011p-2, -0x1.696a02f7a726cp-3,
     0x1.c885d43f23b57p-4, -0x1.338d53492babfp-4, 0x1.afa6e12ee7e15p-5, -0x1.37909a22e1e7ap-5, 0x1.cb25dbe31aefep-6,
     -0x1.59a5f6d39d5e9p-6, 0x1.05fe14d1ea9p-6}, /* [153] 1.125 <= y <= 1.25 2^-34, degree 10, 64.0 bits */
    {0x1.8c3c0af793798p+4, -0x1.903955d557c5bp-50, -0x1.59d634fbc246ep-1, 0x1.077e3e7d0281ep-2, -0x1.0bacd8eefaa13p-3,
     0x1.31ea0e03eb9ffp-4, -0x1.74ec84ef7d61cp-5, 0x1.d98dd3d6b433cp-6, -0x1.3541e95474e3p-6, 0x1.9c57d37b48e63p-7,
     -0x1.188f6811d1191p-7, 0x1.80cd203a99ce1p-8}, /* [154] 1.25 <= y <= 1.375 2^-34, degree 10, 63.0 bits */
    {0x1.8af1b2beb8d23p+4, 0x1.8382a5c53a221p-50, -0x1.3bc39fadfc002p-1, 0x1.b752464f6549bp-3, -0x1.977c630c04b08p-4,
     0x1.a933ccb999be4p-5, -0x1.d944ba93b0467p-6, 0x1.125bc2f8f6c0cp-6, -0x1.472efa7e7d77dp-7, 0x1.8e4f686f3182bp-8,
     -0x1.ee8222576e6ep-9, 0x1.35a09ab722076p-9}, /* [155] 1.375 <= y <= 1.5 2^-34, degree 10, 63.2 bits */
    {0x1.89c2ea5ffd7cdp+4, 0x1.de3f076ebd732p-51, -0x1.2280cfe87c2e8p-1, 0x1.73d77ab7e07d6p-3, -0x1.3d4def32b3e2ep-4,
     0x1.309cacf0329ap-5, -0x1.37ec2c2b9598cp-6, 0x1.4cb79f112bbfdp-7, -0x1.6d09775d79ba5p-8, 0x1.98d75cf621312p-9,
     -0x1.d2b2a9def56a7p-10, 0x1.0cd591d03263fp-10}, /* [156] 1.5 <= y <= 1.625 2^-34, degree 10, 64.2 bits */
    {0x1.88ab72979d9d9p+4, 0x1.43e1e5536ccp-50, -0x1.0cfc0b992b4b3p-1, 0x1.3ecb5eed547f4p-3, -0x1.f7c5e7d522119p-5,
     0x1.bfcc4442f450fp-6, -0x1.a8941bbfec28p-7, 0x1.a356312b0221cp-8, -0x1.a9fdd8fb41c93p-9, 0x1.b9c4d7483c8eap-10,
     -0x1.d2b64f9259013p-11, 0x1.f1da235c83143p-12}, /* [157] 1.625 <= y <= 1.75 2^-34, degree 10, 65.6 bits */
    {0x1.87a7f590b745p+4, -0x1.fdb78ead9f852p-52, -0x1.f4de36e62584p-2, 0x1.1456cf72a5c52p-3, -0x1.9691330fa44f8p-5,
     0x1.5078178aad02fp-6, -0x1.290556627630bp-7, 0x1.111f5d62e75dcp-8, -0x1.02527b59dfb0fp-9, 0x1.f2d4336ae571ap-11,
     -0x1.ea7736129a2f8p-12, 0x1.e71ae2acfce4ap-13}, /* [158] 1.75 <= y <= 1.875 2^-34, degree 10, 65.8 bits */
    {0x1.86b5c88319a0fp+4, 0x1.3805fe6135fe9p-50, -0x1.d48dde66b9c66p-2, 0x1.e3aa599c85bf3p-4, -0x1.4cd82d67d3b11p-5,
     0x1.01af903441f68p-6, -0x1.a998d1ab8d8e1p-8, 0x1.6e1ad1b04687fp-9, -0x1.43ed1c3297261p-10, 0x1.249413c04d8f4p-11,
     -0x1.0d081abed4c6bp-12, 0x1.f3e5d6ebfc59fp-14}, /* [159] 1.875 <= y <= 2 2^-34, degree 10, 63.6 bits */
    {0x1.8566592f4a521p+4, 0x1.eb2db22587a5p-53, -0x1.ab36212035ce3p-1, 0x1.92141221e7fafp-2, -0x1.f8916b8b365e9p-3,
     0x1.642a54945d3fcp-3, -0x1.0c2be1850d3e2p-3, 0x1.a4a92e8e5a715p-4, -0x1.5359d259f73bep-4, 0x1.177712b52195bp-4,
     -0x1.d6ef7148f7c04p-5, 0x1.8ef6528e5f356p-5}, /* [160] 1 <= y <= 1.125 2^-33, degree 10, 61.4 bits */
    {0x1.83d274720838ap+4, -0x1.c4b0f08269bd9p-50, -0x1.7e3dfccfb1305p-1, 0x1.41e2b7a6c8d67p-2, -0x1.696a2b6885439p-3,
     0x1.c885fed0dee39p-4, -0x1.338d6c6110182p-4, 0x1.afa700e657dfbp-5, -0x1.3790af2c53ca6p-5, 0x1.cb25ece216db2p-6,
     -0x1.59a5fde083a71p-6, 0x1.0602dd97a8d6cp-6}, /* [161] 1.125 <= y <= 1.25 2^-33, degree 10, 64.0 bits */
    {0x1.826705894c34p+4, -0x1.8e7f1ad106c4bp-50, -0x1.59d6a17b68f7fp-1, 0x1.077e67d150499p-2, -0x1.0bacf86c1f4e1p-3,
     0x1.31ea2c012f2a2p-4, -0x1.74eca4ec8fd19p-5, 0x1.d98df865a2e05p-6, -0x1.3541ff370c599p-6, 0x1.9c57ee93d2322p-7,
     -0x1.188f79585f67ep-7, 0x1.80cd369b907d2p-8}, /* [162] 1.25 <= y <= 1.375 2^-33, degree 10, 64.7 bits */
    {0x1.811cace6696fbp+4, 0x1.10780221814eep-50, -0x1.3bc4075aa46aap-1, 0x1.b7528e6cd6877p-3, -0x1.977c9536b1704p-4,
     0x1.a933f8591eccap-5, -0x1.d944e50fde5efp-6, 0x1.125bd9237cf17p-6, -0x1.472f12b9ab3c8p-7, 0x1.8e4f83d37a313p-8,
     -0x1.ee824235eb814p-9, 0x1.35a0ad8fc62c2p-9}, /* [163] 1.375 <= y <= 1.5 2^-33, degree 10, 63.4 bits */
    {0x1.7fede4222a912p+4, 0x1.4316747ae2092p-50, -0x1.228133597c1b2p-1, 0x1.73d7ba5adfb43p-3, -0x1.3d4e17ece2276p-4,
     0x1.309ccd851fb87p-5, -0x1.37ec495d0b7e3p-6, 0x1.4cb7bb17afdf4p-7, -0x1.6d09938cf6dd4p-8, 0x1.98d77a463ba24p-9,
     -0x1.d2b2c93ae86a9p-10, 0x1.0cd5a2dfc7019p-10}, /* [164] 1.5 <= y <= 1.625 2^-33, degree 10, 63.9 bits */
    {0x1.7ed66bf84363cp+4, -0x1.036a09b7dd9c9p-51, -0x1.0cfc6b4944027p-1, 0x1.3ecb97a02c058p-3, -0x1.f7c62b07cf76ap-5,
     0x1.bfcc7609a630fp-6, -0x1.a894450ba0393p-7, 0x1.a35655e011e01p-8, -0x1.a9fdfb29efaedp-9, 0x1.b9c4f832cfaa4p-10,
     -0x1.d2b67029e4c3bp-11, 0x1.f1da44327b695p-12}, /* [165] 1.625 <= y <= 1.75 2^-33, degree 10, 63.1 bits */
    {0x1.7dd2ee936279dp+4, 0x1.94fe0e7023d3p-51, -0x1.f4deef8eeffadp-2, 0x1.1457026228018p-3, -0x1.96916b43fae8p-5,
     0x1.50783e4da4ec6p-6, -0x1.2905745316c71p-7, 0x1.111f762a09b29p-8, -0x1.025290d553e67p-9, 0x1.f2d459effade2p-11,
     -0x1.ea775992180b5p-12, 0x1.e71b03f8f9088p-13}, /* [166] 1.75 <= y <= 1.875 2^-33, degree 10, 63.7 bits */
    {0x1.7ce0c12afa738p+4, -0x1.d83475b35c019p-50, -0x1.d48e910150937p-2, 0x1.e3aab5c8eed5ap-4, -0x1.4cd85cfa8b7efp-5,
     0x1.01afaee579d08p-6, -0x1.a998fe067c0f9p-8, 0x1.6e1af4072ea13p-9, -0x1.43ed380c87732p-10, 0x1.24942b1c3f747p-11,
     -0x1.0d082ee0b5ed1p-12, 0x1.f3e5fa40b7d36p-14}, /* [167] 1.875 <= y <= 2 2^-33, degree 10, 67.1 bits */
    {0x1.7b9151544ee5ap+4, 0x1.9103435ab572dp-51, -0x1.ab36cbab41647p-1, 0x1.9214626138212p-2, -0x1.f891b711f8ab9p-3,
     0x1.642a8101b904ep-3, -0x1.0c2bfeca13b5dp-3, 0x1.a4a957e0bb48ep-4, -0x1.5359f0e88624p-4, 0x1.17772a1314037p-4,
     -0x1.d6ef962c64078p-5, 0x1.8ef670128528cp-5}, /* [168] 1 <= y <= 1.125 2^-32, degree 10, 61.9 bits */
    {0x1.79fd6bf13f50ep+4, 0x1.c86fa0d7be2b8p-52, -0x1.7e3e9e2141ca8p-1, 0x1.41e2fb915b0fcp-2, -0x1.696a6499be946p-3,
     0x1.c8863b04a597p-4, -0x1.338d8fdde96aap-4, 0x1.afa72db4e07bfp-5, -0x1.3790ccc48cf2p-5, 0x1.cb26212c1ab3cp-6,
     -0x1.59a627b23ce51p-6, 0x1.05fe37ce39cc8p-6}, /* [169] 1.125 <= y <= 1.25 2^-32, degree 10, 63.1 bits */
    {0x1.7891fc6b3ab5p+4, 0x1.46c885671d5cfp-51, -0x1.59d73aed723b9p-1, 0x1.077ea2443768dp-2, -0x1.0bad24f459164p-3,
     0x1.31ea566a82d84p-4, -0x1.74ecd229b10dbp-5, 0x1.d98e2c1932e1ep-6, -0x1.35421e2a53cd8p-6, 0x1.9c5814e595b3ap-7,
     -0x1.188f91c6d27fcp-7, 0x1.80cd56418dd79p-8}, /* [170] 1.25 <= y <= 1.375 2^-32, degree 10, 62.7 bits */
    {0x1.7747a332630a1p+4, -0x1.25567deaf7f8p-50, -0x1.3bc499fa1f7f4p-1, 0x1.b752f4696e611p-3, -0x1.977cdc290ead5p-4,
     0x1.a934360a6ef2cp-5, -0x1.d945212527f2ep-6, 0x1.125bf87c7f9a8p-6, -0x1.472f34fe4f3f8p-7, 0x1.8e4faa905db6ep-8,
     -0x1.ee826f47c9bc4p-9, 0x1.35a0c836dbebbp-9}, /* [171] 1.375 <= y <= 1.5 2^-32, degree 10, 66.6 bits */
    {0x1.7618d9de92ed5p+4, -0x1.67343161f237dp-51, -0x1.2281bffc6e65dp-1, 0x1.73d81459fadfap-3, -0x1.3d4e5185cbf82p-4,
     0x1.309cfb9904955p-5, -0x1.37ec72a625ab2p-6, 0x1.4cb7e2ba035cep-7, -0x1.6d09bb693b6ebp-8, 0x1.98d7a3baa981ep-9,
     -0x1.d2b2f5942aae5p-10, 0x1.0cd5bb007b23cp-10}, /* [172] 1.5 <= y <= 1.625 2^-32, degree 10, 63.0 bits */
    {0x1.7501612abd572p+4, 0x1.37e4b4f432c1ep-50, -0x1.0cfcf29d47c6bp-1, 0x1.3ecbe7cf67657p-3, -0x1.f7c68a102f63cp-5,
     0x1.bfccbc6e9bf85p-6, -0x1.a8947f725219bp-7, 0x1.a35689c98f5bp-8, -0x1.a9fe2b814c4bcp-9, 0x1.b9c526bfd0ed1p-10,
     -0x1.d2b69e4179d34p-11, 0x1.f1da72a257fa9p-12}, /* [173] 1.625 <= y <= 1.75 2^-32, degree 10, 62.7 bits */
    {0x1.73fde340f32cfp+4, 0x1.d01bee950e643p-50, -0x1.f4dff4b758ebbp-2, 0x1.14574a6af1269p-3, -0x1.9691bac04354ep-5,
     0x1.5078751ee552fp-6, -0x1.29059eaa8b992p-7, 0x1.111f99349c699p-8, -0x1.0252af36c0506p-9, 0x1.f2d49069b176bp-11,
     -0x1.ea778bc5c7215p-12, 0x1.e71b330fbbf4fp-13}, /* [174] 1.75 <= y <= 1.875 2^-32, degree 10, 63.5 bits */
    {0x1.730bb558242a9p+4, -0x1.2e74bc3c94d7cp-53, -0x1.d48f8d996450fp-2, 0x1.e3ab38238ce99p-4, -0x1.4cd8a041f0bd4p-5,
     0x1.01afda4d4e2fep-6, -0x1.a9993cc0d6bcbp-8, 0x1.6e1b249770a1ep-9, -0x1.43ed5f6fd03c1p-10, 0x1.24944c2530621p-11,
     -0x1.0d084b596a20ap-12, 0x1.f3e62c37ee249p-14}, /* [175] 1.875 <= y <= 2 2^-32, degree 10, 64.3 bits */
    {0x1.71bc44c86630bp+4, -0x1.76029deabe83ap-51, -0x1.ab37bcdd04a92p-1, 0x1.9214d3de1523fp-2, -0x1.f89221e1984f3p-3,
     0x1.642abfd6261cap-3, -0x1.0c2c282eda816p-3, 0x1.a4a99250ddb5ep-4, -0x1.535a1c1f5311bp-4, 0x1.17774b1eda0aap-4,
     -0x1.d6efca577100fp-5, 0x1.8ef699d08d8f3p-5}, /* [176] 1 <= y <= 1.125 2^-31, degree 10, 61.2 bits */
    {0x1.70285e7ad9193p+4, 0x1.3ba17dd271fe6p-51, -0x1.7e3f82475ad48p-1, 0x1.41e35b9de3316p-2, -0x1.696ab57bad98ep-3,
     0x1.c8869028486e5p-4, -0x1.338dc20dd66dbp-4, 0x1.afa76d19cfe89p-5, -0x1.3790f6b664271p-5, 0x1.cb265a91f8539p-6,
     -0x1.59a6502e69d0bp-6, 0x1.05fe54c9e653ep-6}, /* [177] 1.125 <= y <= 1.25 2^-31, degree 10, 63.9 bits */
    {0x1.6ebcee1663401p+4, -0x1.d41edf24ef34dp-50, -0x1.59d813f121a74p-1, 0x1.077ef4ed24d0ep-2, -0x1.0bad63eecc05ep-3,
     0x1.31ea9265299c3p-4, -0x1.74ed1223f2e44p-5, 0x1.d98e75372da0bp-6, -0x1.354249ef92ae3p-6, 0x1.9c584b16ba64bp-7,
     -0x1.188fb453f9b56p-7, 0x1.80cd830387bb9p-8}, /* [178] 1.25 <= y <= 1.375 2^-31, degree 10, 64.5 bits */
    {0x1.6d72940976fep+4, -0x1.7150830525f07p-50, -0x1.3bc56957c8982p-1, 0x1.b75384a4e650dp-3, -0x1.977d407ead827p-4,
     0x1.a9348d49a94c5p-5, -0x1.d945761dac683p-6, 0x1.125c24d19ea73p-6, -0x1.472f6574bd515p-7, 0x1.8e4fe159025b8p-8,
     -0x1.ee82af04d8aap-9, 0x1.35a0ede82f9b3p-9}, /* [179] 1.375 <= y <= 1.5 2^-31, degree 10, 63.2 bits */
    {0x1.6c43c9ea9b7b3p+4, -0x1.ca1d58ce80f6dp-50, -0x1.228286e2bd8dep-1, 0x1.73d893a082cbap-3, -0x1.3d4ea2fa63303p-4,
     0x1.309d3cc30461dp-5, -0x1.37ecad092e4f2p-6, 0x1.4cb81ac724398p-7, -0x1.6d09f3c84c341p-8, 0x1.98d7de5af3f66p-9,
     -0x1.d2b3344c26252p-10, 0x1.0cd5dd1faf495p-10}, /* [180] 1.5 <= y <= 1.625 2^-31, degree 10, 62.7 bits */
    {0x1.6b2c5073b2fd9p+4, 0x1.3051920d5efafp-53, -0x1.0cfdb201c03fbp-1, 0x1.3ecc593595c05p-3, -0x1.f7c71075eecd3p-5,
     0x1.bfcd1ffc3b5aap-6, -0x1.a894d209e4a4cp-7, 0x1.a356d333d059fp-8, -0x1.a9fe6fdec4748p-9, 0x1.b9c5689510582p-10,
     -0x1.d2b6df70a898ep-11, 0x1.f1dab44e5e9f3p-12}, /* [181] 1.625 <= y <= 1.75 2^-31, degree 10, 62.9 bits */
    {0x1.6a28d1cdef6d9p+4, 0x1.8b55b70000bd6p-51, -0x1.f4e166116c947p-2, 0x1.1457b04a6c254p-3, -0x1.96922b2947be5p-5,
     0x1.5078c2a505465p-6, -0x1.2905da8beca36p-7, 0x1.111fcac2f8846p-8, -0x1.0252da2dbb357p-9, 0x1.f2d4dd73fae3ep-11,
     -0x1.ea77d2c4dd20fp-12, 0x1.e71b75a7cb67fp-13}, /* [182] 1.75 <= y <= 1.875 2^-31, degree 10, 63.6 bits */
    {0x1.6936a32f876adp+4, -0x1.84237297a6489p-50, -0x1.d490f2d702529p-2, 0x1.e3abf07d3cd5cp-4, -0x1.4cd8ff67acadp-5,
     0x1.01b017afe54a3p-6, -0x1.a9999576e48e6p-8, 0x1.6e1b6945626b5p-9, -0x1.43ed9723c99abp-10, 0x1.24947add27595p-11,
     -0x1.0d08739d3bd8bp-12, 0x1.f3e672e17e8b8p-14}, /* [183] 1.875 <= y <= 2 2^-31, degree 10, 64.0 bits */
    {0x1.67e7319a0aa64p+4, 0x1.43b2e59083853p-50, -0x1.ab3911fb78654p-1, 0x1.9215745d7f9dp-2, -0x1.f892b8ef9bd08p-3,
     0x1.642b18b119609p-3, -0x1.0c2c62b9092b7p-3, 0x1.a4a9e4f5c9b93p-4, -0x1.535a593c8d57p-4, 0x1.177779dad2fcep-4,
     -0x1.d6f0141e6723cp-5, 0x1.8ef6d4d8efbc6p-5}, /* [184] 1 <= y <= 1.125 2^-30, degree 10, 61.3 bits */
    {0x1.66534a00da47dp+4, 0x1.78e4d05d36339p-51, -0x1.7e40c4f2c0b45p-1, 0x1.41e3e373bc869p-2, -0x1.696b27de85d43p-3,
     0x1.c887089029b22p-4, -0x1.338e0907a5c1cp-4, 0x1.afa7c6c11a827p-5, -0x1.379132080ed3cp-5, 0x1.cb26abbe51901p-6,
     -0x1.59a6896fa05a6p-6, 0x1.05fe7dc6f0cep-6}, /* [185] 1.125 <= y <= 1.25 2^-30, degree 10, 63.2 bits */
    {0x1.64e7d861cb067p+4, -0x1.32c08c78a5f6p-50, -0x1.59d946dd635a9p-1, 0x1.077f69d396b61p-2, -0x1.0badbcff92bf2p-3,
     0x1.31eae7381056dp-4, -0x1.74ed6c9e6f4f1p-5, 0x1.d98edc9e88898p-6, -0x1.354287d641afep-6, 0x1.9c5897ba66399p-7,
     -0x1.188fe530f5f7ep-7, 0x1.80cdc24f9dbf6p-8}, /* [186] 1.25 <= y <= 1.375 2^-30, degree 10, 63.3 bits */
    {0x1.639d7d28ecd1cp+4, -0x1.e07cf2f04fc77p-50, -0x1.3bc68e9eda633p-1, 0x1.b754509f40d87p-3, -0x1.977dce63f2a28p-4,
     0x1.a93508acaa0f2p-5, -0x1.d945ee4890189p-6, 0x1.125c6383c9547p-6, -0x1.472fa9fe2a7cap-7, 0x1.8e502ed2f038fp-8,
     -0x1.ee830928bf6a5p-9, 0x1.35a1233672cf3p-9}, /* [187] 1.375 <= y <= 1.5 2^-30, degree 10, 63.6 bits */
    {0x1.626eb1eae6cp+4, -0x1.27c0eb6f7fe22p-50, -0x1.2283a030abdc7p-1, 0x1.73d9479fcc0c4p-3, -0x1.3d4f162cac2b3p-4,
     0x1.309d98eb19389p-5, -0x1.37ecff9b9c5ap-6, 0x1.4cb86a0bfc70bp-7, -0x1.6d0a4381025dp-8, 0x1.98d83143faf5cp-9,
     -0x1.d2b38cfed5ea4p-10, 0x1.0cd60d612dc57p-10}, /* [188] 1.5 <= y <= 1.625 2^-30, degree 10, 62.7 bits */
    {0x1.61573760196f8p+4, 0x1.9063bf7e0d847p-50, -0x1.0cfec0b1c0f9fp-1, 0x1.3eccf9950b0a6p-3, -0x1.f7c7ce8777dddp-5,
     0x1.bfcdacc69e2a2p-6, -0x1.a89546d79d349p-7, 0x1.a3573b070e52dp-8, -0x1.a9fed08db66a4p-9, 0x1.b9c5c5af454f2p-10,
     -0x1.d2b73ba0015abp-11, 0x1.f1db112e440cbp-12}, /* [189] 1.625 <= y <= 1.75 2^-30, degree 10, 62.7 bits */
    {0x1.6053b7b07b6d9p+4, 0x1.477b17fb84fcbp-50, -0x1.f4e3707212286p-2, 0x1.1458405ceb699p-3, -0x1.9692ca228701ap-5,
     0x1.50793047e6511p-6, -0x1.29062f3b16007p-7, 0x1.112010d84cd32p-8, -0x1.025316f0b8fc6p-9, 0x1.f2d54a67a53ebp-11,
     -0x1.ea78372c6fe9p-12, 0x1.e71bd3d57fbb9p-13}, /* [190] 1.75 <= y <= 1.875 2^-30, degree 10, 64.7 bits */
    {0x1.5f6188113d901p+4, 0x1.8081e9162602cp-50, -0x1.d492ec16e0da7p-2, 0x1.e3acf534345a7p-4, -0x1.4cd985f70fcbp-5,
     0x1.01b06e7fdcd2cp-6, -0x1.a99a12ebfb83p-8, 0x1.6e1bca6629985p-9, -0x1.43ede5ea8cb3bp-10, 0x1.2494bcef2f8dp-11,
     -0x1.0d08ac8ec3173p-12, 0x1.f3e6d6d01e23p-14}, /* [191] 1.875 <= y <= 2 2^-30, degree 10, 66.5 bits */
    {0x1.5e12150990395p+4, -0x1.b81d2cc81677p-50, -0x1.ab3af46e8e4f2p-1, 0x1.92165758cddbdp-2, -0x1.f8938e8fd8da9p-3,
     0x1.642b965a6aff6p-3, -0x1.0c2cb582da35fp-3, 0x1.a4aa59d663393p-4, -0x1.535aafaa601abp-4, 0x1.1777bbf28736dp-4,
     -0x1.d6f07c74bc3c2p-5, 0x1.8ef728552d155p-5}, /* [192] 1 <= y <= 1.125 2^-29, degree 10, 62.1 bits */
    {0x1.5c7e2b9b555e5p+4, 0x1.f9cb646b76af3p-50, -0x1.7e428d4e5263ep-1, 0x1.41e4a38e3670dp-2, -0x1.696bc9a32f01cp-3,
     0x1.c887b2d81a78ep-4, -0x1.338e6d67d63c5p-4, 0x1.afa8458b5a6f7p-5, -0x1.379185ebf7a2dp-5, 0x1.cb271e8a5692bp-6,
     -0x1.59a6da682ab9bp-6, 0x1.05feb7be6a902p-6}, /* [193] 1.125 <= y <= 1.25 2^-29, degree 10, 62.7 bits */
    {0x1.5b12b83f5458ap+4, -0x1.c9b69c235feep-50, -0x1.59daf8f3f6d26p-1, 0x1.07800f26b8b72p-2, -0x1.0bae3af51ee7ap-3,
     0x1.31eb5f2ddc95bp-4, -0x1.74edec9366d94p-5, 0x1.d98f6edaf3bcap-6, -0x1.3542df60ff811p-6, 0x1.9c59041cf8d2dp-7,
     -0x1.18902a4b6fefap-7, 0x1.80ce1bd3c69ffp-8}, /* [194] 1.25 <= y <= 1.375 2^-29, degree 10, 63.2 bits */
    {0x1.59c85b5e3dd4fp+4, -0x1.2cc62dfa60c67p-50, -0x1.3bc82d693a248p-1, 0x1.b7557118862adp-3, -0x1.977e9710458a3p-4,
     0x1.a935b72bdfa76p-5, -0x1.d946983a3a0d8p-6, 0x1.125cbc2e521e6p-6, -0x1.47300aeb50dadp-7, 0x1.8e509c6486f79p-8,
     -0x1.ee8388a3315abp-9, 0x1.35a16e9948faep-9}, /* [195] 1.375 <= y <= 1.5 2^-29, degree 10, 62.3 bits */
    {0x1.58998e8a11fbap+4, -0x1.101561f486cbap-52, -0x1.22852e0c33ee5p-1, 0x1.73da462f01846p-3, -0x1.3d4fb916c5417p-4,
     0x1.309e1b3faf053p-5, -0x1.37ed746220ff8p-6, 0x1.4cb8da26a09d5p-7, -0x1.6d0ab43f7debep-8, 0x1.98d8a684e649ep-9,
     -0x1.d2b40a6f231b3p-10, 0x1.0cd6519fc23cap-10}, /* [196] 1.5 <= y <= 1.625 2^-29, degree 10, 62.4 bits */
    {0x1.5782127910034p+4, 0x1.1d7946e9f8cd7p-50, -0x1.0d003f897aa1ep-1, 0x1.3ecddc6364a38p-3, -0x1.f7c8db548906dp-5,
     0x1.bfce73e2cb65bp-6, -0x1.a895ec076be21p-7, 0x1.a357cddc16525p-8, -0x1.a9ff5949182edp-9, 0x1.b9c6495a28fe1p-10,
     -0x1.d2b7bdfebc129p-11, 0x1.f1db9486a9b06p-12}, /* [197] 1.625 <= y <= 1.75 2^-29, degree 10, 65.3 bits */
    {0x1.567e9151707c8p+4, 0x1.de4fad36e30dcp-51, -0x1.f4e653438d888p-2, 0x1.14590c1dbb2c6p-3, -0x1.9693aaf5ec938p-5,
     0x1.5079cb54e6aa6p-6, -0x1.2906a6fe5782p-7, 0x1.112073f562c76p-8, -0x1.02536cdef8aa9p-9, 0x1.f2d5e47cb2678p-11,
     -0x1.ea78c52b05154p-12, 0x1.e71c5905fb7c6p-13}, /* [198] 1.75 <= y <= 1.875 2^-29, degree 10, 66.1 bits */
    {0x1.558c6046f202bp+4, 0x1.2374ba6de8f2fp-50, -0x1.d495b6af37a7ep-2, 0x1.e3ae65eb0a921p-4, -0x1.4cda4443b8db5p-5,
     0x1.01b0e945a893bp-6, -0x1.a99ac458da538p-8, 0x1.6e1c53c2937dep-9, -0x1.43ee5552e27c7p-10, 0x1.24951a5f6a2a3p-11,
     -0x1.0d08fd16a4339p-12, 0x1.f3e76423a4cf8p-14}, /* [199] 1.875 <= y <= 2 2^-29, degree 10, 64.0 bits */
    {0x1.543ceb33b160cp+4, -0x1.7543e25835358p-52, -0x1.ab3d9ec84140bp-1, 0x1.9217985acaeaap-2, -0x1.f894bcaddb43bp-3,
     0x1.642c4811405a6p-3, -0x1.0c2d2a97be6b5p-3, 0x1.a4aaff20e4858p-4, -0x1.535b29e546725p-4, 0x1.1778196ac9707p-4,
     -0x1.d6f110031ecacp-5, 0x1.8ef79e664a856p-5}, /* [200] 1 <= y <= 1.125 2^-28, degree 10, 62.0 bits */
    {0x1.52a8ff2e135dp+4, 0x1.d29292af7b454p-50, -0x1.7e4512c18a1dap-1, 0x1.41e5b33cbc18fp-2, -0x1.696cae6a75a72p-3,
     0x1.c888a3a9331f7p-4, -0x1.338efb5c21c5cp-4, 0x1.afa8f8dab1c33p-5, -0x1.3791fc8fc1c1bp-5, 0x1.cb27c0e39c8d9p-6,
     -0x1.59a74ceaf8db5p-6, 0x1.05ff09b8c0ea9p-6}, /* [201] 1.125 <= y <= 1.25 2^-28, degree 10, 64.0 bits */
    {0x1.513d895cc3468p+4, -0x1.7e43168116f8fp-57, -0x1.59dd5ee89046bp-1, 0x1.0780f8f62a97bp-2, -0x1.0baeed17f8d64p-3,
     0x1.31ec08d4a76b7p-4, -0x1.74eea189475e7p-5, 0x1.d9903daa94efdp-6, -0x1.35435b2edd9f2p-6, 0x1.9c599d64e2e5dp-7,
     -0x1.18908c05bf8b2p-7, 0x1.80ce9a6c5cd6ap-8}, /* [202] 1.25 <= y <= 1.375 2^-28, degree 10, 62.2 bits */
    {0x1.4ff32a23acef2p+4, 0x1.1499a0a7c59f7p-56, -0x1.3bca781325bp-1, 0x1.b7570911e58fdp-3, -0x1.977fb2dcfa1e5p-4,
     0x1.a936adf362e22p-5, -0x1.d947889143738p-6, 0x1.125d39933cd39p-6, -0x1.473093febfa09p-7, 0x1.8e513758fd975p-8,
     -0x1.ee843ceba6ff7p-9, 0x1.35a1d9362cf98p-9}, /* [203] 1.375 <= y <= 1.5 2^-28, degree 10, 62.9 bits */
    {0x1.4ec45b1110545p+4, -0x1.021b4fe104716p-57, -0x1.228760c390ed9p-1, 0x1.73dbae31debcbp-3, -0x1.3d509f7d2c61ap-4,
     0x1.309ed3910508fp-5, -0x1.37ee1987e3c53p-6, 0x1.4cb978b115ea1p-7, -0x1.6d0b53b19e3edp-8, 0x1.98d94c57a1186p-9,
     -0x1.d2b4bbd52f25bp-10, 0x1.0cd6b2231789fp-10}, /* [204] 1.5 <= y <= 1.625 2^-28, degree 10, 62.8 bits */
    {0x1.4dacdcd829575p+4, -0x1.241a48d1237e3p-51, -0x1.0d025d04ba698p-1, 0x1.3ecf1d26487b6p-3, -0x1.f7ca577abf97ep-5,
     0x1.bfcf8d796dd6ap-6, -0x1.a896d5a4301f4p-7, 0x1.a3589d839e3b1p-8, -0x1.aa001aa7def7p-9, 0x1.b9c7038f5c962p-10,
     -0x1.d2b8765e27e85p-11, 0x1.f1dc4e472539fp-12}, /* [205] 1.625 <= y <= 1.75 2^-28, degree 10, 62.6 bits */
    {0x1.4ca9599cb9cd6p+4, -0x1.4899ae8e973b3p-50, -0x1.f4ea683adaacp-2, 0x1.145a2c466cc2p-3, -0x1.9694e8eb24624p-5,
     0x1.507aa69c298dbp-6, -0x1.2907505da9093p-7, 0x1.11210020c6d98p-8, -0x1.0253e66587fa3p-9, 0x1.f2d6be64fbb03p-11,
     -0x1.ea798dfafcf73p-12, 0x1.e71d15621dd25p-13}, /* [206] 1.75 <= y <= 1.875 2^-28, degree 10, 63.6 bits */
    {0x1.4bb7269074ba1p+4, 0x1.c4732a359eaefp-52, -0x1.d499a964843ap-2, 0x1.e3b06f5fe567cp-4, -0x1.4cdb5164e1486p-5,
     0x1.01b196e6d2a9ap-6, -0x1.a99bbf448e81ep-8, 0x1.6e1d16052e70bp-9, -0x1.43eef2e12ebcap-10, 0x1.24959e8413e8dp-11,
     -0x1.0d096efa2e045p-12, 0x1.f3e82c01afb4p-14}, /* [207] 1.875 <= y <= 2 2^-28, degree 10, 64.1 bits */
    {0x1.4a67ae98ab045p+4, -0x1.c55d8d5c4c8d4p-50, -0x1.ab4163e35e0afp-1, 0x1.92195e57b6bc4p-2, -0x1.f89667f24bd0ep-3,
     0x1.642d4365c11f2p-3, -0x1.0c2dd02c6e33bp-3, 0x1.a4abe8e36a002p-4, -0x1.535bd6c1cf897p-4, 0x1.17789d9ad2881p-4,
     -0x1.d6f1e0b0b5841p-5, 0x1.8ef8455f775cp-5}, /* [208] 1 <= y <= 1.125 2^-27, degree 10, 61.3 bits */
    {0x1.48d3bee8c377dp+4, 0x1.b5057ea0b8df6p-51, -0x1.7e48a3acdf90cp-1, 0x1.41e733775511bp-2, -0x1.696df1f6f4197p-3,
     0x1.c889f83bc0bc1p-4, -0x1.338fc41ddc693p-4, 0x1.afa9f670b5c8cp-5, -0x1.3792a4587cdfep-5, 0x1.cb28a67ccd894p-6,
     -0x1.59a7eedccfae7p-6, 0x1.05ff7da83735ep-6}, /* [209] 1.125 <= y <= 1.25 2^-27, degree 10, 64.0 bits */
    {0x1.4768459d5bfddp+4, 0x1.f557de725c496p-50, -0x1.59e0c3493d8b8p-1, 0x1.078243a189fb2p-2, -0x1.0bafe905a9e3p-3,
     0x1.31ecf8c23a863p-4, -0x1.74efa17505b5bp-5, 0x1.d991622541ff7p-6, -0x1.35440a45596a5p-6, 0x1.9c5a762b2cdd3p-7,
     -0x1.1891163b61a03p-7, 0x1.80cf4d7582ed2p-8}, /* [210] 1.25 <= y <= 1.375 2^-27, degree 10, 62.7 bits */
    {0x1.461de313a1d17p+4, -0x1.e63ebd3d17e0ep-50, -0x1.3bcdb5dacf6fap-1, 0x1.b7594a0dc35f7p-3, -0x1.97814439f42d3p-4,
     0x1.a9380af4d143bp-5, -0x1.d948dc771b3eep-6, 0x1.125deae9790bep-6, -0x1.473155da352bep-7, 0x1.8e52127d60cfap-8,
     -0x1.ee853be1db193p-9, 0x1.35a26ffc94766p-9}, /* [211] 1.375 <= y <= 1.5 2^-27, degree 10, 64.5 bits */
    {0x1.44ef10d48705cp+4, 0x1.7a500908f99ebp-51, -0x1.228a7cacfc3f8p-1, 0x1.73ddab58ddacep-3, -0x1.3d51e55508872p-4,
     0x1.309fd83c89206p-5, -0x1.37ef0316ba51bp-6, 0x1.4cba58e7e7e91p-7, -0x1.6d0c352ffd4b5p-8, 0x1.98da36dad14eep-9,
     -0x1.d2b5b6b72277dp-10, 0x1.0cd73aa0f11adp-10}, /* [212] 1.5 <= y <= 1.625 2^-27, degree 10, 64.7 bits */
    {0x1.43d78f8f04a0ap+4, 0x1.318aa6f175364p-50, -0x1.0d055ae604df9p-1, 0x1.3ed0e2caecd6ep-3, -0x1.f7cc711b2a277p-5,
     0x1.bfd11bb581a5ep-6, -0x1.a898200673872p-7, 0x1.a359c32fc607cp-8, -0x1.aa012c2068201p-9, 0x1.b9c80ae6b7332p-10,
     -0x1.d2b97b1d11ea6p-11, 0x1.f1dd54f951ce1p-12}, /* [213] 1.625 <= y <= 1.75 2^-27, degree 10, 62.7 bits */
    {0x1.42d409636073fp+4, 0x1.f852df7665c5fp-52, -0x1.f4f02e408a8f2p-2, 0x1.145bc3cf7111fp-3, -0x1.9696aa9761854p-5,
     0x1.507bdcb92b9cfp-6, -0x1.29083fe629826p-7, 0x1.1121c65c6993ap-8, -0x1.025492432ec92p-9, 0x1.f2d7f290ff0dcp-11,
     -0x1.ea7aa9f9cbde9p-12, 0x1.e71e1fc4889fap-13}, /* [214] 1.75 <= y <= 1.875 2^-27, degree 10, 63.9 bits */
    {0x1.41e1d38069055p+4, -0x1.a9a908b754cddp-51, -0x1.d49f3ef7062ep-2, 0x1.e3b350db66eap-4, -0x1.4cdcce02f7486p-5,
     0x1.01b28c74e0005p-6, -0x1.a99d22215874ep-8, 0x1.6e1e28c01b4abp-9, -0x1.43efd1b366535p-10, 0x1.24965965bbc0dp-11,
     -0x1.0d0a100ae6d7bp-12, 0x1.f3e946aa54644p-14}, /* [215] 1.875 <= y <= 2 2^-27, degree 10, 63.9 bits */
    {0x1.409257712fd29p+4, 0x1.9085634265d05p-50, -0x1.ab46b8f75b6aap-1, 0x1.921be0684d1e8p-2, -0x1.f898c4363cb37p-3,
     0x1.642ea6d7268f7p-3, -0x1.0c2eba5851dccp-3, 0x1.a4ad337b11607p-4, -0x1.535ccb39633c2p-4, 0x1.1779588c98305p-4,
     -0x1.d6f307cf53991p-5, 0x1.8ef931831673ap-5}, /* [216] 1 <= y <= 1.125 2^-26, degree 10, 61.1 bits */
    {0x1.3efe6292221f6p+4, -0x1.fb39698aa15c4p-56, -0x1.7e4daef26905ap-1, 0x1.41e952dfa86ep-2, -0x1.696fbb8bd8d52p-3,
     0x1.c88bd9e349a97p-4, -0x1.3390e00926a24p-4, 0x1.afab5d126c90ap-5, -0x1.379391a1e3ffcp-5, 0x1.cb29eb31a7489p-6,
     -0x1.59a8d3e3f004ep-6, 0x1.0600219de96b2p-6}, /* [217] 1.125 <= y <= 1.25 2^-26, degree 10, 63.5 bits */
    {0x1.3d92e45bbe185p+4, -0x1.edf80bfc52f29p-51, -0x1.59e58f90333d6p-1, 0x1.0784174aa2634p-2, -0x1.0bb14d508e966p-3,
     0x1.31ee4c13c50a9p-4, -0x1.74f10b6464f98p-5, 0x1.d992ffc831733p-6, -0x1.354501e315d5bp-6, 0x1.9c5ba8bd4a688p-7,
     -0x1.1891d9b15d0ep-7, 0x1.80d04aa857edbp-8}, /* [218] 1.25 <= y <= 1.375 2^-26, degree 10, 62.3 bits */
    {0x1.3c487d21a72p+4, 0x1.18f8edfd42199p-50, -0x1.3bd24b8b3160ep-1, 0x1.b75c7a1324805p-3, -0x1.97837bdc04bc4p-4,
     0x1.a939f889dd817p-5, -0x1.d94abd2a355fap-6, 0x1.125ee5b5a3919p-6, -0x1.47326803642bfp-7, 0x1.8e534868b95d2p-8,
     -0x1.ee86a47566abdp-9, 0x1.35a34537d2a8fp-9}, /* [219] 1.375 <= y <= 1.5 2^-26, degree 10, 63.1 bits */
    {0x1.3b19a6654ed77p+4, -0x1.85ad1ad176659p-50, -0x1.228ee27723391p-1, 0x1.73e07b6fbc4fap-3, -0x1.3d53b22929c3dp-4,
     0x1.30a148e3e5a83p-5, -0x1.37f04d65da0ep-6, 0x1.4cbb95ffe58f8p-7, -0x1.6d0d74170d9aap-8, 0x1.98db8282f9d9cp-9,
     -0x1.d2b71985ec42p-10, 0x1.0cd7fba8fce57p-10}, /* [220] 1.5 <= y <= 1.625 2^-26, degree 10, 66.2 bits */
    {0x1.3a0220cfa781ap+4, -0x1.83404b19f7107p-51, -0x1.0d099636e995ap-1, 0x1.3ed364609336bp-3, -0x1.f7cf69742611bp-5,
     0x1.bfd34eea386c4p-6, -0x1.a899f345479fp-7, 0x1.a35b6283051cap-8, -0x1.aa02aee180ac8p-9, 0x1.b9c97f5444a96p-10,
     -0x1.d2baebded289dp-11, 0x1.f1dec87d0b4f1p-12}, /* [221] 1.625 <= y <= 1.75 2^-26, degree 10, 63.6 bits */
    {0x1.38fe967c09655p+4, -0x1.4c8312abc7944p-51, -0x1.f4f858e205425p-2, 0x1.145e042f9a55cp-3, -0x1.9699268cb39cap-5,
     0x1.507d934db3737p-6, -0x1.290992a8c71c9p-7, 0x1.1122deb61f1bfp-8, -0x1.025585529c1fep-9, 0x1.f2d9a66563712p-11,
     -0x1.ea7c3b9d04877p-12, 0x1.e71f987fb3b3fp-13}, /* [222] 1.75 <= y <= 1.875 2^-26, degree 10, 63.4 bits */
    {0x1.380c5c952bc71p+4, -0x1.4547f0e02c7ecp-51, -0x1.d4a72512b6981p-2, 0x1.e3b763e0c008ap-4, -0x1.4cdee84ece83bp-5,
     0x1.01b3e7bc1f46ep-6, -0x1.a99f17fed8ddcp-8, 0x1.6e1fad4982f08p-9, -0x1.43f10cd3169f3p-10, 0x1.249761b1744c2p-11,
     -0x1.0d0af3d3e78c9p-12, 0x1.f3ead66998a6ap-14}, /* [223] 1.875 <= y <= 2 2^-26, degree 10, 65.8 bits */
    {0x1.36bcdabc5c8c5p+4, 0x1.874eb58d48df5p-53, -0x1.ab4e43dc33287p-1, 0x1.921f6c7b56f34p-2, -0x1.f89c1acef3926p-3,
     0x1.64309d879cadp-3, -0x1.0c300585e77dp-3, 0x1.a4af0705656aep-4, -0x1.535e24f603262p-4, 0x1.177a60ef2c984p-4,
     -0x1.d6f4a92e32b71p-5, 0x1.8efa7f78385f4p-5}, /* [224] 1 <= y <= 1.125 2^-25, degree 10, 61.2 bits */
    {0x1.3528de880eadap+4, 0x1.d1b29d2d4094ap-53, -0x1.7e54d174b7e2fp-1, 0x1.41ec536b6487cp-2, -0x1.697242b182a0bp-3,
     0x1.c88e831312d1ep-4, -0x1.3392719201a2ep-4, 0x1.afad584484497p-5, -0x1.3794e136ffaf2p-5, 0x1.cb2bb668a4746p-6,
     -0x1.59aa17caa596dp-6, 0x1.0601097ee0ddp-6}, /* [225] 1.125 <= y <= 1.25 2^-25, degree 10, 63.9 bits */
    {0x1.33bd595cd1984p+4, 0x1.01052ea4905cap-50, -0x1.59ec58fa8405fp-1, 0x1.0786acb5c4e01p-2, -0x1.0bb3453650ab9p-3,
     0x1.31f02bf6d3ecep-4, -0x1.74f30b431d4dbp-5, 0x1.d99548c4e4f2fp-6, -0x1.354660140d6dap-6, 0x1.9c5d5a4e70bf8p-7,
     -0x1.1892ee1f596e9p-7, 0x1.80d1b0bdf501dp-8}, /* [226] 1.25 <= y <= 1.375 2^-25, degree 10, 62.4 bits */
    {0x1.3272eb80cb3bfp+4, 0x1.40bcd1e6613f3p-52, -0x1.3bd8c7c10befep-1, 0x1.b760fc301a33fp-3, -0x1.97869ea744bafp-4,
     0x1.a93cb298c4387p-5, -0x1.d94d64fff2781p-6, 0x1.12604866c5bdep-6, -0x1.4733ebbef1bbep-7, 0x1.8e54feb655fd3p-8,
     -0x1.ee88a2670f033p-9, 0x1.35a472c78dd34p-9}, /* [227] 1.375 <= y <= 1.5 2^-25, degree 10, 64.6 bits */
    {0x1.31440e6ad12c2p+4, 0x1.513d480dc88d5p-51, -0x1.22951aee45d36p-1, 0x1.73e475dff87e2p-3, -0x1.3d563de78577p-4,
     0x1.30a352444d8afp-5, -0x1.37f2208abaad6p-6, 0x1.4cbd5673aeff9p-7, -0x1.6d0f37196a7ap-8, 0x1.98dd578ebfa56p-9,
     -0x1.d2b90f4f35db7p-10, 0x1.0cd90ca7722e1p-10}, /* [228] 1.5 <= y <= 1.625 2^-25, degree 10, 64.2 bits */
    {0x1.302c82bb4fc51p+4, -0x1.6c54791ca8405p-54, -0x1.0d0f929bbb6d8p-1, 0x1.3ed6efc98fabbp-3, -0x1.f7d39cce14372p-5,
     0x1.bfd66b7141b24p-6, -0x1.a89c8814645c4p-7, 0x1.a35dade3b250ep-8, -0x1.aa04d1d9a8403p-9, 0x1.b9cb8e0945d8dp-10,
     -0x1.d2bcf56277f2dp-11, 0x1.f1e0d5e6e8dd9p-12}, /* [229] 1.625 <= y <= 1.75 2^-25, degree 10, 62.5 bits */
    {0x1.2f28f286a71dep+4, 0x1.4a8d8de433f2dp-50, -0x1.f503e62e0c4a7p-2, 0x1.1461335f25eb8p-3, -0x1.969ca9faeec8ep-5,
     0x1.507fff93b9ec2p-6, -0x1.290b71c1bc243p-7, 0x1.11246b333eaep-8, -0x1.0256dd1286b23p-9, 0x1.f2dc0ec50d13ap-11,
     -0x1.ea7e73a13387cp-12, 0x1.e721ad4a55a02p-13}, /* [230] 1.75 <= y <= 1.875 2^-25, degree 10, 63.3 bits */
    {0x1.2e36b2f1c55c2p+4, 0x1.736ff9f23f9a3p-52, -0x1.d4b25174d0972p-2, 0x1.e3bd270ef8359p-4, -0x1.4ce1e19e03a0cp-5,
     0x1.01b5d2e20eabcp-6, -0x1.a9a1ddc49b454p-8, 0x1.6e21d2c7bf2a6p-9, -0x1.43f2ca7db4ba4p-10, 0x1.2498d7798d9edp-11,
     -0x1.0d0c35f932fe3p-12, 0x1.f3ed0bc13e69fp-14}, /* [231] 1.875 <= y <= 2 2^-25, degree 10, 63.2 bits */
    {0x1.2ce728e92b388p+4, 0x1.9ea053396f922p-51, -0x1.ab58ef3c5363cp-1, 0x1.922470ced750dp-2, -0x1.f8a0d3767a93dp-3,
     0x1.643364794e5bep-3, -0x1.0c31d9e619c98p-3, 0x1.a4b19c3f450d8p-4, -0x1.53600dec4538ep-4, 0x1.177bd6d7bbd59p-4,
     -0x1.d6f6f772d180bp-5, 0x1.8efc57c506886p-5}, /* [232] 1 <= y <= 1.125 2^-24, degree 10, 61.9 bits */
    {0x1.2b5322555bee2p+4, 0x1.eb306a3e5c17dp-50, -0x1.7e5ee931fdebbp-1, 0x1.41f092690fdbap-2, -0x1.6975d5f4a09e5p-3,
     0x1.c89246777d03cp-4, -0x1.3394a9735fffcp-4, 0x1.afb025940faa1p-5, -0x1.3796bbd117fbdp-5, 0x1.cb2e3fdb8d5c8p-6,
     -0x1.59abe1def57d5p-6, 0x1.0602516e5a995p-6}, /* [233] 1.125 <= y <= 1.25 2^-24, degree 10, 62.3 bits */
    {0x1.29e79352f643bp+4, 0x1.01e78056d576dp-51, -0x1.59f5f2b549004p-1, 0x1.078a5430ae50ep-2, -0x1.0bb60de0d5883p-3,
     0x1.31f2d2a9b795dp-4, -0x1.74f5df3050fcp-5, 0x1.d998841974a88p-6, -0x1.35484f57854edp-6, 0x1.9c5fbf7bcf9e7p-7,
     -0x1.18947510c023ap-7, 0x1.80d3ab2a4026ap-8}, /* [234] 1.25 <= y <= 1.375 2^-24, degree 10, 64.8 bits */
    {0x1.289d1c150beddp+4, 0x1.798788e731ebbp-50, -0x1.3be1f449ccd6ep-1, 0x1.b7675c85349ap-3, -0x1.978b0e0df5ce4p-4,
     0x1.a9408ddaec4d4p-5, -0x1.d951267a3ea41p-6, 0x1.12623e086cf79p-6, -0x1.4736101a93831p-7, 0x1.8e576a96b254cp-8,
     -0x1.ee8b7398a5481p-9, 0x1.35a61d43e1fd6p-9}, /* [235] 1.375 <= y <= 1.5 2^-24, degree 10, 63.0 bits */
    {0x1.276e360371295p+4, -0x1.c5397771836b2p-50, -0x1.229de7a61c4dap-1, 0x1.73ea165217b9ep-3, -0x1.3d59d7ad07ec2p-4,
     0x1.30a633a5c2897p-5, -0x1.37f4b5375ee6ap-6, 0x1.4cbfd0aff36f4p-7, -0x1.6d11b4f2c72d6p-8, 0x1.98dfeee9da28cp-9,
     -0x1.d2bbd4f78e1f5p-10, 0x1.0cda8ebd0d788p-10}, /* [236] 1.5 <= y <= 1.625 2^-24, degree 10, 62.4 bits */
    {0x1.2656a1b2846d5p+4, 0x1.aca10466c8402p-58, -0x1.0d180a5cf0ebap-1, 0x1.3edbf3342a75bp-3, -0x1.f7d98db232013p-5,
     0x1.bfdad1f86cddp-6, -0x1.a8a02ea734eap-7, 0x1.a360ec9ae938ep-8, -0x1.aa07d76a01f25p-9, 0x1.b9ce76f0f71b8p-10,
     -0x1.d2bfd6f19a9c2p-11, 0x1.f1e3bcf963707p-12}, /* [237] 1.625 <= y <= 1.75 2^-24, degree 10, 64.8 bits */
    {0x1.2553092cca693p+4, 0x1.5b4f1d289379dp-51, -0x1.f5143da837c6cp-2, 0x1.1465b45a65ff7p-3, -0x1.96a1a21109f98p-5,
     0x1.50836cd4c992p-6, -0x1.290e1756dcdp-7, 0x1.11269bf25c332p-8, -0x1.0258c33a99ffbp-9, 0x1.f2df767d19aefp-11,
     -0x1.ea8196f4c5a42p-12, 0x1.e7249ecc4315dp-13}, /* [238] 1.75 <= y <= 1.875 2^-24, degree 10, 64.3 bits */
    {0x1.2460c18f027a2p+4, -0x1.9d6cb35f83aabp-50, -0x1.d4c21fdc4827fp-2, 0x1.e3c54d87e5ef9p-4, -0x1.4ce6165bba9cap-5,
     0x1.01b8898432ac7p-6, -0x1.a9a5c997f4d97p-8, 0x1.6e24dbeb50e2cp-9, -0x1.43f540c971681p-10, 0x1.249ae81a90b43p-11,
     -0x1.0d0dfd92e706ep-12, 0x1.f3f02b4c7e327p-14}, /* [239] 1.875 <= y <= 2 2^-24, degree 10, 64.8 bits */
    {0x1.23112bf19bf6ep+4, -0x1.9884cc03dc95bp-50, -0x1.ab68072c3caa4p-1, 0x1.922b895965e1ep-2, -0x1.f8a780e72207dp-3,
     0x1.643751f801ed8p-3, -0x1.0c34705217f18p-3, 0x1.a4b543690b773p-4, -0x1.5362c173b849ep-4, 0x1.177de7a6eb1bcp-4,
     -0x1.d6fa3a3f53106p-5, 0x1.8efef3ba68f51p-5}, /* [240] 1 <= y <= 1.125 2^-23, degree 10, 61.2 bits */
    {0x1.217d16b12c27bp+4, -0x1.1fd5d1704bdc5p-53, -0x1.7e6d3050f6116p-1, 0x1.41f693da67db2p-2, -0x1.697ae4728f389p-3,
     0x1.c8979901b398ep-4, -0x1.3397cc9a9ef36p-4, 0x1.afb41c20f1bc5p-5, -0x1.37995b19714d4p-5, 0x1.cb31b0fe265f2p-6,
     -0x1.59ae5d4838bbfp-6, 0x1.0613041c9e66cp-6}, /* [241] 1.125 <= y <= 1.25 2^-23, degree 10, 63.1 bits */
    {0x1.201179c2ff742p+4, 0x1.15170db4231c6p-54, -0x1.5a03879996f11p-1, 0x1.078f7f583d8f4p-2, -0x1.0bb9fdd5c4a55p-3,
     0x1.31f6928f6b57bp-4, -0x1.74f9df0aa637cp-5, 0x1.d99d1630380d5p-6, -0x1.354b0bc96ff9ap-6, 0x1.9c6322b061191p-7,
     -0x1.18969df7970c9p-7, 0x1.80d67762bacf7p-8}, /* [242] 1.25 <= y <= 1.375 2^-23, degree 10, 62.0 bits */
    {0x1.1ec6f53f2b96ep+4, 0x1.7e01f74ece4b1p-50, -0x1.3beeeebb79ed9p-1, 0x1.b7706153867e2p-3, -0x1.979153e980fe4p-4,
     0x1.a9460228cd736p-5, -0x1.d956764de065cp-6, 0x1.1265037d523d1p-6, -0x1.473917a4330fbp-7, 0x1.8e5ad7453f03dp-8,
     -0x1.ee8f6f90f11c5p-9, 0x1.35a8786f0639cp-9}, /* [243] 1.375 <= y <= 1.5 2^-23, degree 10, 62.7 bits */
    {0x1.1d9802784bce1p+4, 0x1.f5f6c244f8ec6p-51, -0x1.22aa5a9174ff7p-1, 0x1.73f20bbb0dd9fp-3, -0x1.3d5eef642d25ep-4,
     0x1.30aa468c00ecbp-5, -0x1.37f85b9de3855p-6, 0x1.4cc351b013e4ap-7, -0x1.6d153b0df5271p-8, 0x1.98e39916f5183p-9,
     -0x1.d2bfc09fa7656p-10, 0x1.0cdcb0c4fddbp-10}, /* [244] 1.5 <= y <= 1.625 2^-23, degree 10, 63.0 bits */
    {0x1.1c8061f1b203ep+4, 0x1.b1c7196086b3ep-50, -0x1.0d24051b7376ep-1, 0x1.3ee30a847c7dap-3, -0x1.f7e1f4ca3a1f7p-5,
     0x1.bfe10b41eb7c7p-6, -0x1.a8a5586fb5d2cp-7, 0x1.a365837dae86bp-8, -0x1.aa0c1d769d2e6p-9, 0x1.b9d2947421eb1p-10,
     -0x1.d2c3ea102495fp-11, 0x1.f1e7d7e32a61ap-12}, /* [245] 1.625 <= y <= 1.75 2^-23, degree 10, 62.6 bits */
    {0x1.1b7cbda7f1e5ep+4, -0x1.8c655f7f4779dp-50, -0x1.f52b5c1ac7a24p-2, 0x1.146c132f18247p-3, -0x1.96a8a94451b2ap-5,
     0x1.50884590c9dc1p-6, -0x1.2911d5a88a9adp-7, 0x1.1129b503fb809p-8, -0x1.025b72ccdcf58p-9, 0x1.f2e4475aef533p-11,
     -0x1.ea86071760f3p-12, 0x1.e728c878b1f45p-13}, /* [246] 1.75 <= y <= 1.875 2^-23, degree 10, 65.3 bits */
    {0x1.1a8a6aac3806bp+4, -0x1.a744f3b4fc463p-53, -0x1.d4d87c6cc7191p-2, 0x1.e3d0d4c0521bdp-4, -0x1.4cec09461c21ep-5,
     0x1.01bc5ff751c3dp-6, -0x1.a9ab55541fd6bp-8, 0x1.6e29270947314p-9, -0x1.43f8bc37610f8p-10, 0x1.249dd3bde3ee4p-11,
     -0x1.0d1081ece093ep-12, 0x1.f3f4961534374p-14}, /* [247] 1.875 <= y <= 2 2^-23, degree 10, 63.4 bits */
    {0x1.193ac4ac69f82p+4, 0x1.cf2d3c885f313p-50, -0x1.ab7d61a519695p-1, 0x1.923592c8e7feap-2, -0x1.f8b0f2b47707p-3,
     0x1.643ce016e348ep-3, -0x1.0c3819341a353p-3, 0x1.a4ba6e06fe3d3p-4, -0x1.5366937c9d43dp-4, 0x1.1780d38c12cccp-4,
     -0x1.d6fed6e61227bp-5, 0x1.8f02a46a3ec72p-5}, /* [248] 1 <= y <= 1.125 2^-22, degree 10, 61.4 bits */
    {0x1.17a69aa94ac62p+4, -0x1.56670819106e3p-53, -0x1.7e81636c6dbbbp-1, 0x1.41ff1289114c3p-2, -0x1.69820b5ddc01p-3,
     0x1.c89f201fc084dp-4, -0x1.339c3c8877033p-4, 0x1.afb9b6dff161ep-5, -0x1.379d105b2f5cfp-5, 0x1.cb36e9668ad6p-6,
     -0x1.59b1fdf952697p-6, 0x1.0606b127b6e55p-6}, /* [249] 1.125 <= y <= 1.25 2^-22, degree 10, 63.7 bits */
    {0x1.163aea0936d1ep+4, 0x1.176938b0cfd6bp-50, -0x1.5a16be9abd97fp-1, 0x1.0796cef03e9c8p-2, -0x1.0bbf8f7d848dfp-3,
     0x1.31fbe0344b575p-4, -0x1.74ff871ec77b1p-5, 0x1.d9a38d14025cp-6, -0x1.354eea704fc0cp-6, 0x1.9c67ed2fa10c9p-7,
     -0x1.1899abf01ca28p-7, 0x1.80da6c55cd4c9p-8}, /* [250] 1.25 <= y <= 1.375 2^-22, degree 10, 62.9 bits */
    {0x1.14f052be1938dp+4, -0x1.7fb251b730545p-51, -0x1.3c014b453c10dp-1, 0x1.b77d2325c6967p-3, -0x1.979a3340c2b2dp-4,
     0x1.a94db90d268fep-5, -0x1.d95df992b1df1p-6, 0x1.1268eee5d961ap-6, -0x1.473d6080771d6p-7, 0x1.8e5faf2c96731p-8,
     -0x1.ee95121e0ba77p-9, 0x1.35abcd7f05fcdp-9}, /* [251] 1.375 <= y <= 1.5 2^-22, degree 10, 62.1 bits */
    {0x1.13c14dfc88c47p+4, -0x1.10655a1d580bap-51, -0x1.22bbf767a51e4p-1, 0x1.73fd4daf8fc85p-3, -0x1.3d662363ddb7ap-4,
     0x1.30b00999af95cp-5, -0x1.37fd8530a2689p-6, 0x1.4cc84659ab704p-7, -0x1.6d1a36ed8c87cp-8, 0x1.98e8c7f83f7p-9,
     -0x1.d2c54c1b5b47p-10, 0x1.0cdfb5063bcc6p-10}, /* [252] 1.5 <= y <= 1.625 2^-22, degree 10, 62.8 bits */
    {0x1.12a99c2fba175p+4, -0x1.286d61aee166bp-50, -0x1.0d34f7f40395fp-1, 0x1.3eed1255b4b48p-3, -0x1.f7edd75a78797p-5,
     0x1.bfe9d8c6f1bdep-6, -0x1.a8aca5e9cd0d7p-7, 0x1.a36c012ee0942p-8, -0x1.aa1228cfdb186p-9, 0x1.b9d86675ca078p-10,
     -0x1.d2c9ad5cde68p-11, 0x1.f1eda6342e5d2p-12}, /* [253] 1.625 <= y <= 1.75 2^-22, degree 10, 62.3 bits */
    {0x1.11a5e74088ca1p+4, 0x1.e357f9cea4357p-53, -0x1.f54c119d06819p-2, 0x1.147516102629bp-3, -0x1.96b29a1ddf1fap-5,
     0x1.508f2072ae6dap-6, -0x1.291721124045cp-7, 0x1.112e16b0ea387p-8, -0x1.025f3f41d60cep-9, 0x1.f2eb1707ff2dap-11,
     -0x1.ea8c4df2f45f4p-12, 0x1.e72eabaad95edp-13}, /* [254] 1.75 <= y <= 1.875 2^-22, degree 10, 63.8 bits */
    {0x1.10b3842fc2c6dp+4, 0x1.125b2d7cf055p-52, -0x1.d4f81fad4506p-2, 0x1.e3e12368e27ecp-4, -0x1.4cf4735934a4cp-5,
     0x1.01c1cd89fe44bp-6, -0x1.a9b32d5c013bcp-8, 0x1.6e2f399353b9p-9, -0x1.43fda90034b3p-10, 0x1.24a1f526222bbp-11,
     -0x1.0d14113f07182p-12, 0x1.f3fad55e7dfebp-14}, /* [255] 1.875 <= y <= 2 2^-22, degree 10, 65.4 bits */
    {0x1.0f63c70195c03p+4, -0x1.8b8e1d2746806p-52, -0x1.ab9b97cf3ad36p-1, 0x1.9243c56dd6f29p-2, -0x1.f8be4e91de86ap-3,
     0x1.6444bb8b1a2bdp-3, -0x1.0c3d464f3c3cdp-3, 0x1.a4c1bcaed9b41p-4, -0x1.536bfac436042p-4, 0x1.1784f55279e1ap-4,
     -0x1.d7055cba0a9bcp-5, 0x1.8f07dc816cd6bp-5}, /* [256] 1 <= y <= 1.125 2^-21, degree 10, 61.2 bits */
    {0x1.0dcf7f9f03449p+4, 0x1.9e2fc8de6482bp-52, -0x1.7e9df7c570579p-1, 0x1.420b16d14a0cep-2, -0x1.698c292378979p-3,
     0x1.c8a9c5de5c79ap-4, -0x1.33a2832d0e996p-4, 0x1.afc1a4396a106p-5, -0x1.37a24f06ecc4bp-5, 0x1.cb3e16b0cf251p-6,
     -0x1.59b70ddcc0e23p-6, 0x1.060a50dc81065p-6}, /* [257] 1.125 <= y <= 1.25 2^-21, degree 10, 63.3 bits */
    {0x1.0c63b3215bc4ap+4, 0x1.969fe91b9b725p-52, -0x1.5a31ee53f07fap-1, 0x1.07a12682ad9dbp-2, -0x1.0bc7700c7b7d3p-3,
     0x1.3203607db11cep-4, -0x1.75078746bd4a2p-5, 0x1.d9acb1b6b9fc5p-6, -0x1.35546393f2a8fp-6, 0x1.9c6eb3e1b4c31p-7,
     -0x1.189dfde92fca5p-7, 0x1.80e004fbae4a3p-8}, /* [258] 1.25 <= y <= 1.375 2^-21, degree 10, 64.6 bits */
    {0x1.0b1901448e1d3p+4, -0x1.49367e6452cacp-50, -0x1.3c1b45f29516p-1, 0x1.b78f2f10867a7p-3, -0x1.97a6c00b07925p-4,
     0x1.a958a268aa125p-5, -0x1.d96899da2d4c6p-6, 0x1.126e7a19fcfc6p-6, -0x1.47436fdda1007p-7, 0x1.8e6688d6d7b96p-8,
     -0x1.ee9d0a626942bp-9, 0x1.35b08403f1accp-9}, /* [259] 1.375 <= y <= 1.5 2^-21, degree 10, 63.4 bits */
    {0x1.09e9e312bb8e6p+4, 0x1.6ef2ecad339cfp-50, -0x1.22d4e2e4f9dcp-1, 0x1.740d3aa021d48p-3, -0x1.3d7053bb00f9ap-4,
     0x1.30b82ffb74bd7p-5, -0x1.3804d2706d4c8p-6, 0x1.4ccf48bbe8889p-7, -0x1.6d21437d8892dp-8, 0x1.98f01ca887034p-9,
     -0x1.d2cd23c17d1a6p-10, 0x1.0ce3f9421fe92p-10}, /* [260] 1.5 <= y <= 1.625 2^-21, degree 10, 65.3 bits */
    {0x1.08d218d4fca6bp+4, 0x1.929a736069d6fp-50, -0x1.0d4cf2f70d53bp-1, 0x1.3efb42ec9333fp-3, -0x1.f7fea719aea78p-5,
     0x1.bff64c46e4762p-6, -0x1.a8b6fa23798eap-7, 0x1.a3752f79c5163p-8, -0x1.aa1ab55a02603p-9, 0x1.b9e0a1e08ccf5p-10,
     -0x1.d2d1d3f6c13ep-11, 0x1.f1f5dc5fc26cap-12}, /* [261] 1.625 <= y <= 1.75 2^-21, degree 10, 62.5 bits */
    {0x1.07ce4c5848729p+4, -0x1.447ce7b0f75b8p-50, -0x1.f57a5951a2e19p-2, 0x1.1481d58cef22ap-3, -0x1.96c0a9de554d1p-5,
     0x1.5098d2a9e1383p-6, -0x1.291e9e3451cffp-7, 0x1.113449316ea38p-8, -0x1.02649eafe8a56p-9, 0x1.f2f4b93d72414p-11,
     -0x1.ea952ea0eb0a4p-12, 0x1.e736ff6036ad2p-13}, /* [262] 1.75 <= y <= 1.875 2^-21, degree 10, 66.4 bits */
    {0x1.06dbd28645186p+4, -0x1.068af7b8e575cp-51, -0x1.d524e365431b5p-2, 0x1.e3f83543da0a8p-4, -0x1.4d005a5c99aa2p-5,
     0x1.01c97b0cbb2e7p-6, -0x1.a9be459663ecdp-8, 0x1.6e37d054e1231p-9, -0x1.4404a03ea71bp-10, 0x1.24a7ccb9209e3p-11,
     -0x1.0d191a3064cdap-12, 0x1.f403ab5561ca5p-14}, /* [263] 1.875 <= y <= 2 2^-21, degree 10, 64.1 bits */
    {0x1.058bf48b75828p+4, -0x1.bcc79036c8f43p-50, -0x1.abc65709c168ep-1, 0x1.9257db6962e81p-2, -0x1.f8d1342384e99p-3,
     0x1.644fd8b607945p-3, -0x1.0c44989952ffbp-3, 0x1.a4cc12931bef7p-4, -0x1.53739f473d491p-4, 0x1.178acd6cc00edp-4,
     -0x1.d70e967d4f09ap-5, 0x1.8f0f3e39d0e0ap-5}, /* [264] 1 <= y <= 1.125 2^-20, degree 10, 61.4 bits */
    {0x1.03f783996b614p+4, -0x1.b9f8be4273f64p-51, -0x1.7ec667e713bf6p-1, 0x1.421c16f6c7792p-2, -0x1.699a788c8ebb5p-3,
     0x1.c8b8d56e12fb8p-4, -0x1.33ab63b47cb19p-4, 0x1.afccda9967affp-5, -0x1.37a9ba1db44f1p-5, 0x1.cb483d58d1458p-6,
     -0x1.59be36bf08c4ap-6, 0x1.060f70fc27066p-6}, /* [265] 1.125 <= y <= 1.25 2^-20, degree 10, 62.9 bits */
    {0x1.028b8fae35bp+4, 0x1.b4412aea1350ep-50, -0x1.5a5865ec554d1p-1, 0x1.07afc836966fbp-2, -0x1.0bd294a550e86p-3,
     0x1.320dfcc2e6d9bp-4, -0x1.7512d8552b8d3p-5, 0x1.d9b9a0684e7b7p-6, -0x1.355c21611c6acp-6, 0x1.9c784971e201dp-7,
     -0x1.18a41a30e86c1p-7, 0x1.80e7ef4b88d79p-8}, /* [266] 1.25 <= y <= 1.375 2^-20, degree 10, 61.9 bits */
    {0x1.0140b839657d5p+4, -0x1.46211c2787911p-50, -0x1.3c40084f55566p-1, 0x1.b7a8b74c16d7dp-3, -0x1.97b880de6c3eap-4,
     0x1.a96811b00a077p-5, -0x1.d977a1a3a5ecbp-6, 0x1.1276517f7d08p-6, -0x1.474c0229c3da9p-7, 0x1.8e70393f9d24p-8,
     -0x1.eea85023efb1dp-9, 0x1.35b72e8118b41p-9}, /* [267] 1.375 <= y <= 1.5 2^-20, degree 10, 65.3 bits */
    {0x1.001176090c0cep+4, 0x1.b092b7d409eeap-53, -0x1.22f825942f789p-1, 0x1.7423c2c18bcf3p-3, -0x1.3d7ebd8ac7b6dp-4,
     0x1.30c3b740b7a7ep-5, -0x1.380f267afc367p-6, 0x1.4cd932d2b841ap-7, -0x1.6d2b3befadbb5p-8, 0x1.98fa7b16fd065p-9,
     -0x1.d2d83b648547bp-10, 0x1.0cea021c84463p-10}, /* [268] 1.5 <= y <= 1.625 2^-20, degree 10, 62.2 bits */
    {0x1.fdf3126c02db9p+3, 0x1.9803776fbf145p-54, -0x1.0d6ee16a1204bp-1, 0x1.3f0f5676cd868p-3, -0x1.f8166f562cab5p-5,
     0x1.c007e929c3ccp-6, -0x1.a8c596685058dp-7, 0x1.a3822be661da1p-8, -0x1.aa26ccedffea7p-9, 0x1.b9ec46ac67ccep-10,
     -0x1.d2dd5b498d676p-11, 0x1.f20179b198655p-12}, /* [269] 1.625 <= y <= 1.75 2^-20, degree 10, 64.5 bits */
    {0x1.fbeb36cb8eea6p+3, 0x1.1524f6d6e91ebp-52, -0x1.f5bbd561624bcp-2, 0x1.1493def15d795p-3, -0x1.96d48e4332dd6p-5,
     0x1.50a689eb2642bp-6, -0x1.29293604a34b7p-7, 0x1.113d0d457f104p-8, -0x1.026c382cb3e49p-9, 0x1.f302598abe40fp-11,
     -0x1.eaa1bd2941871p-12, 0x1.e742c67d4131cp-13}, /* [270] 1.75 <= y <= 1.875 2^-20, degree 10, 65.3 bits */
    {0x1.fa0602c2853bcp+3, -0x1.ed9ac633b2a9p-53, -0x1.d5643a8113a31p-2, 0x1.e418d960a7f2ap-4, -0x1.4d1130de3933ep-5,
     0x1.01d4576a4e3c4p-6, -0x1.a9cdf7296dc37p-8, 0x1.6e43f673b95e2p-9, -0x1.440e7a951c13p-10, 0x1.24b010220d231p-11,
     -0x1.0d20394f5695p-12, 0x1.f4102ab298d6fp-14}, /* [271] 1.875 <= y <= 2 2^-20, degree 10, 64.6 bits */
    {0x1.f765e9faf8772p+3, -0x1.bac9f5a5109fcp-51, -0x1.ac02d35d3a6f3p-1, 0x1.927446e43989cp-2, -0x1.f8ebefc923cfbp-3,
     0x1.645f917797942p-3, -0x1.0c4ef3db24b7fp-3, 0x1.a4dab132e1b39p-4, -0x1.537e6eb87fe65p-4, 0x1.179311993648ap-4,
     -0x1.d71ba3106bfcep-5, 0x1.8f19af1958ce5p-5}, /* [272] 1 <= y <= 1.125 2^-19, degree 10, 60.9 bits */
    {0x1.f43c9279d759ep+3, 0x1.acacd29f33175p-51, -0x1.7eff9fdd170c9p-1, 0x1.4234251001e93p-2, -0x1.69aeb73a1d1aep-3,
     0x1.c8ce2390c4a12p-4, -0x1.33b7f25478fd7p-4, 0x1.afdcb6cd9cd05p-5, -0x1.37b4385d14468p-5, 0x1.cb5699126cbd6p-6,
     -0x1.59c85746cec77p-6, 0x1.0616b0e7c3064p-6}, /* [273] 1.125 <= y <= 1.25 2^-19, degree 10, 62.1 bits */
    {0x1.f1643b0f40f0ap+3, -0x1.6215fc9cd5f89p-52, -0x1.5a8ed3fa6a0f9p-1, 0x1.07c47c5c2a99ep-2, -0x1.0be25853aaf39p-3,
     0x1.321cff4b3be7fp-4, -0x1.7522da705513cp-5, 0x1.d9cbeb80bb9a4p-6, -0x1.356714a6b5657p-6, 0x1.9c85d7f8da35ep-7,
     -0x1.18acbed01c536p-7, 0x1.80f3216a5c62ep-8}, /* [274] 1.25 <= y <= 1.375 2^-19, degree 10, 62.8 bits */
    {0x1.eece21c24425p+3, -0x1.5c318d4106eb4p-56, -0x1.3c740bacdbc6dp-1, 0x1.b7ccd84250ba1p-3, -0x1.97d19eb8d7b75p-4,
     0x1.a97de7623e3b1p-5, -0x1.d98ce4b0b2881p-6, 0x1.1281690ffe1e5p-6, -0x1.4758220ab1dacp-7, 0x1.8e7dedc7b57e6p-8,
     -0x1.eeb841fab2c58p-9, 0x1.35c09c44ed358p-9}, /* [275] 1.375 <= y <= 1.5 2^-19, degree 10, 62.2 bits */
    {0x1.ec6f37851124ep+3, -0x1.13292b4c51fc5p-53, -0x1.232a0a05b0f91p-1, 0x1.7443a506c3dfep-3, -0x1.3d9321d675dd9p-4,
     0x1.30d406564c1abp-5, -0x1.381dc2c38809bp-6, 0x1.4ce7391d8c9cdp-7, -0x1.6d395674d0007p-8, 0x1.990925cea0554p-9,
     -0x1.d2e7ec076586cp-10, 0x1.0cf28b43cd8d1p-10}, /* [276] 1.5 <= y <= 1.625 2^-19, degree 10, 62.1 bits */
    {0x1.ea3efc00d013bp+3, 0x1.adfc4b92e9f24p-51, -0x1.0d9ee465e251dp-1, 0x1.3f2bbf67fedf6p-3, -0x1.f83815069fa82p-5,
     0x1.c020d3d87055ap-6, -0x1.a8da417b33286p-7, 0x1.a3948a8f57f08p-8, -0x1.aa37e7c455051p-9, 0x1.b9fcbf1230f07p-10,
     -0x1.d2eda9ef4d2f4p-11, 0x1.f211e767b7b57p-12}, /* [277] 1.625 <= y <= 1.75 2^-19, degree 10, 62.3 bits */
    {0x1.e836c210de47ap+3, -0x1.8e1fcaadd7339p-51, -0x1.f6187dc68185ap-2, 0x1.14ad6523fc1d5p-3, -0x1.96f0b3224ffa2p-5,
     0x1.50b9f1522234p-6, -0x1.293832413335dp-7, 0x1.114973ba04936p-8, -0x1.0276f82de1c98p-9, 0x1.f3159fdaf7068p-11,
     -0x1.eab38026b9af1p-12, 0x1.e7536f58c0efep-13}, /* [278] 1.75 <= y <= 1.875 2^-19, degree 10, 63.0 bits */
    {0x1.e65132ea544f5p+3, -0x1.3029dce23602cp-52, -0x1.d5bdda0d8792ep-2, 0x1.e4470a97b3e8bp-4, -0x1.4d290397174c3p-5,
     0x1.01e3b4de3c2fep-6, -0x1.a9e42aa298b8fp-8, 0x1.6e55260afb5e7p-9, -0x1.441c6a9ab31aep-10, 0x1.24bbc07841769p-11,
     -0x1.0d2a4c26db8dep-12, 0x1.f421d834de96cp-14}, /* [279] 1.875 <= y <= 2 2^-19, degree 10, 64.5 bits */
    {0x1.e3b096ccfe1e9p+3, 0x1.487a73c7356acp-51, -0x1.ac5868b988ce7p-1, 0x1.929c7f284521p-2, -0x1.f911c2b9d2ee4p-3,
     0x1.6475cf7c92946p-3, -0x1.0c5d9a84e1bcp-3, 0x1.a4ef5f99c36d9p-4, -0x1.538db9819ad2fp-4, 0x1.179ec30c5b81ep-4,
     -0x1.d72e186c4e7a8p-5, 0x1.8f2873ebc25b5p-5}, /* [280] 1 <= y <= 1.125 2^-18, degree 10, 61.6 bits */
    {0x1.e08698e1aac88p+3, -0x1.5e977ce2cc1ebp-52, -0x1.7f509593b74d2p-1, 0x1.42563058fa296p-2, -0x1.69cb5c4a12512p-3,
     0x1.c8ec47f6728f8p-4, -0x1.33c9b60eddf0dp-4, 0x1.aff3268df1ae6p-5, -0x1.37c31058954dap-5, 0x1.cb6ae8e01cb5dp-6,
     -0x1.59d6ab1ad1fa1p-6, 0x1.0620dbe5f1d9fp-6}, /* [281] 1.125 <= y <= 1.25 2^-18, degree 10, 62.0 bits */
    {0x1.ddada39748ca2p+3, 0x1.6bef065464962p-52, -0x1.5adbd7504dda8p-1, 0x1.07e1c9b3048b3p-2, -0x1.0bf8a6a0549b6p-3,
     0x1.32323bbd1cdd7p-4, -0x1.75398020cb591p-5, 0x1.d9e5cc873b168p-6, -0x1.3576923c5b5dp-6, 0x1.9c99055d6b02cp-7,
     -0x1.18b8f8b8dc959p-7, 0x1.8102f7af46d42p-8}, /* [282] 1.25 <= y <= 1.375 2^-18, degree 10, 62.1 bits */
    {0x1.db16f3c32bbe5p+3, 0x1.42bdcb23bb9d3p-53, -0x1.3cbda35bfd2b7p-1, 0x1.b7fffad827272p-3, -0x1.97f528e14c843p-4,
     0x1.a99ccbe1a5988p-5, -0x1.d9aaf93ba8b2ap-6, 0x1.12911a29b4bf8p-6, -0x1.476948ee93f6cp-7, 0x1.8e9150feddd9ep-8,
     -0x1.eeced01837744p-9, 0x1.35cdf2b25d66cp-9}, /* [283] 1.375 <= y <= 1.5 2^-18, degree 10, 62.6 bits */
    {0x1.d8b779670bb9ep+3, -0x1.ad22de8b8bee7p-52, -0x1.2370a143e1c49p-1, 0x1.7470c5f0c5f9cp-3, -0x1.3daffca801ca5p-4,
     0x1.30eb198051653p-5, -0x1.38326e677fd5dp-6, 0x1.4cfb10558233cp-7, -0x1.6d4d4a216f789p-8, 0x1.991de557e9d05p-9,
     -0x1.d2fe1df8fec42p-10, 0x1.0cfe9e56c5d7dp-10}, /* [284] 1.5 <= y <= 1.625 2^-18, degree 10, 63.5 bits */
    {0x1.d686b36adfc76p+3, 0x1.a5c4a1e58d9d9p-51, -0x1.0de2d22b7dcdfp-1, 0x1.3f53f5e3efe19p-3, -0x1.f867b1d419b47p-5,
     0x1.c04414f43fb4p-6, -0x1.a8f77f3f4df0fp-7, 0x1.a3ae878b997fep-8, -0x1.aa501a6dc5431p-9, 0x1.ba140bc846396p-10,
     -0x1.d304bb76f8763p-11, 0x1.f22924c7a00e5p-12}, /* [285] 1.625 <= y <= 1.75 2^-18, degree 10, 62.0 bits */
    {0x1.d47df40c084b2p+3, -0x1.e6aff3ecb458bp-54, -0x1.f69b95c9d554bp-2, 0x1.14d18640e6299p-3, -0x1.9718869a92142p-5,
     0x1.50d565bfa2d4ap-6, -0x1.294d65cf187e9p-7, 0x1.115afec6bb63fp-8, -0x1.02862d6fcd118p-9, 0x1.f330e43d8404cp-11,
     -0x1.eacca0784d94ep-12, 0x1.e76b00728b244p-13}, /* [286] 1.75 <= y <= 1.875 2^-18, degree 10, 63.1 bits */
    {0x1.d297e3fc74a05p+3, -0x1.3b795544c82f7p-52, -0x1.d63ca66dcdaaap-2, 0x1.e4886d99e73d3p-4, -0x1.4d4ab9f210563p-5,
     0x1.01f97271134f1p-6, -0x1.aa0393cbd2e1p-8, 0x1.6e6d766d77442p-9, -0x1.443022569ddb4p-10, 0x1.24cc49a8ce79ep-11,
     -0x1.0d388c4d01eaep-12, 0x1.f43ada1638b02p-14}, /* [287] 1.875 <= y <= 2 2^-18, degree 10, 62.9 bits */
    {0x1.cff68e0fd9565p+3, 0x1.77ac3be6ebd3fp-51, -0x1.acd17d23f214fp-1, 0x1.92d56e81758e1p-2, -0x1.f947498a70e9bp-3,
     0x1.64954855c2ab7p-3, -0x1.0c72552f99d42p-3, 0x1.a50ca2117398bp-4, -0x1.53a35be76071ap-4, 0x1.17af4de098ba8p-4,
     -0x1.d748353a9f26cp-5, 0x1.8f3d586c36414p-5}, /* [288] 1 <= y <= 1.125 2^-17, degree 10, 60.9 bits */
    {0x1.cccba4b5d478bp+3, 0x1.432aa0aa5ac3cp-56, -0x1.7fc31e61f5c0cp-1, 0x1.42866254af60ep-2, -0x1.69f3e60ee71ffp-3,
     0x1.c916eebc1b922p-4, -0x1.33e2d8a07fe6dp-4, 0x1.b012e4f1d0668p-5, -0x1.37d8107238703p-5, 0x1.cb87a4ac600fbp-6,
     -0x1.59eaee9b956ddp-6, 0x1.062f740762eb3p-6}, /* [289] 1.125 <= y <= 1.25 2^-17, degree 10, 62.0 bits */
    {0x1.c9f1d013f98dbp+3, -0x1.f35074530faaap-51, -0x1.5b48c9b855552p-1, 0x1.080b45ac989b7p-2, -0x1.0c183823dbb54p-3,
     0x1.3250489348fa2p-4, -0x1.75598b76cbf83p-5, 0x1.da0a69f7d7e74p-6, -0x1.358c7cbab8aafp-6, 0x1.9cb426f0112ccp-7,
     -0x1.18ca44a7cd44dp-7, 0x1.81195f34f178ap-8}, /* [290] 1.25 <= y <= 1.375 2^-17, degree 10, 62.4 bits */
    {0x1.c75a4b4eee64cp+3, -0x1.19d76d60ce076p-51, -0x1.3d25be09bebccp-1, 0x1.b84860a8044b4p-3, -0x1.9827757f52b74p-4,
     0x1.a9c8831889feep-5, -0x1.d9d5893af8ad7p-6, 0x1.12a74de398ca8p-6, -0x1.47818d437d2abp-7, 0x1.8eacbed63705fp-8,
     -0x1.eeeeb8f680acdp-9, 0x1.35e0d11e15819p-9}, /* [291] 1.375 <= y <= 1.5 2^-17, degree 10, 62.3 bits */
    {0x1.c4fa051416b98p+3, 0x1.b30df80c0cd43p-55, -0x1.23d47bf35d79p-1, 0x1.74b0ab742522cp-3, -0x1.3dd8d38c8622ep-4,
     0x1.310bc0de9032dp-5, -0x1.384fae0e4a81dp-6, 0x1.4d1722f9a84edp-7, -0x1.6d6984b7257b7p-8, 0x1.993b401b3a029p-9,
     -0x1.d31d849164369p-10, 0x1.0d0fb35f8fa53p-10}, /* [292] 1.5 <= y <= 1.625 2^-17, degree 10, 61.9 bits */
    {0x1.c2c87b39fbfdfp+3, 0x1.3bc47aa4b573p-51, -0x1.0e42e7f4662a1p-1, 0x1.3f8ce643e328fp-3, -0x1.f8ab15b5b4992p-5,
     0x1.c075f8ea43c13p-6, -0x1.a920dfcdd0f54p-7, 0x1.a3d34d1aeb0bp-8, -0x1.aa7257169283fp-9, 0x1.ba3502caf305cp-10,
     -0x1.d3255e81b148p-11, 0x1.f24a05a7e5c59p-12}, /* [293] 1.625 <= y <= 1.75 2^-17, degree 10, 62.3 bits */
    {0x1.c0beff1e6244dp+3, -0x1.1a5fa737e0ee7p-51, -0x1.f7550289f7c4dp-2, 0x1.1504af0065deep-3, -0x1.9750e59201958p-5,
     0x1.50fc405365e05p-6, -0x1.296b6619632f5p-7, 0x1.1173d172b7782p-8, -0x1.029bb1fe48e72p-9, 0x1.f3577866d76dfp-11,
     -0x1.eaf02cef54e5dp-12, 0x1.e78c57e427acep-13}, /* [294] 1.75 <= y <= 1.875 2^-17, degree 10, 64.2 bits */
    {0x1.bed838b99384bp+3, -0x1.1d2d3c0aa0c2ep-51, -0x1.d6effe0fc0d4dp-2, 0x1.e4e50503dae5ap-4, -0x1.4d7a71f319f86p-5,
     0x1.021836fac6f5fp-6, -0x1.aa3006b5c5dc6p-8, 0x1.6e8fdddc6a46bp-9, -0x1.444c087990705p-10, 0x1.24e3af0e19341p-11,
     -0x1.0d4cb5c9215d7p-12, 0x1.f45e3b633456fp-14}, /* [295] 1.875 <= y <= 2 2^-17, degree 10, 64.1 bits */
    {0x1.bc35dc0033a6p+3, -0x1.197ccf974b26fp-56, -0x1.ad7cbba8d72dep-1, 0x1.93260f43a209dp-2, -0x1.f9930e3f428a3p-3,
     0x1.64c1d2f69a415p-3, -0x1.0c8faac6bae6ap-3, 0x1.a53609438d5dcp-4, -0x1.53c1f878aa43p-4, 0x1.17c6b5b89c0d3p-4,
     -0x1.d76d273bbd4b5p-5, 0x1.8f5ae78eebcf9p-5}, /* [296] 1 <= y <= 1.125 2^-16, degree 10, 61.5 bits */
    {0x1.b909a5affecap+3, 0x1.ccab26d0c990dp-52, -0x1.806517ea01f29p-1, 0x1.42caa3f5a6c8ep-2, -0x1.6a2d48d424358p-3,
     0x1.c9534c684aedcp-4, -0x1.34066aaa914d5p-4, 0x1.b03fd05b18584p-5, -0x1.37f5c7970e392p-5, 0x1.cbb04cf0713a8p-6,
     -0x1.5a079b203172cp-6, 0x1.0643fa947214ep-6}, /* [297] 1.125 <= y <= 1.25 2^-16, degree 10, 61.9 bits */
    {0x1.b62e95378a284p+3, -0x1.6e4fac362ea4p-51, -0x1.5be2d96221208p-1, 0x1.0846073ba16c5p-2, -0x1.0c44e8e3ac88bp-3,
     0x1.327ad0e9adbfcp-4, -0x1.7586e50389837p-5, 0x1.da3e3a725d225p-6, -0x1.35ab7fc34cd45p-6, 0x1.9cda8ab8ebb94p-7,
     -0x1.18e2bdd4eb8f9p-7, 0x1.8139124878987p-8}, /* [298] 1.25 <= y <= 1.375 2^-16, degree 10, 64.4 bits */
    {0x1.b395e356f827dp+3, -0x1.7d5a07c67ebb3p-51, -0x1.3db8f1c2b3c55p-1, 0x1.b8aeecb11ff18p-3, -0x1.986eab5f1c1a4p-4,
     0x1.aa066395eeb93p-5, -0x1.da11c5ff39c78p-6, 0x1.12c6b93cf8de5p-6, -0x1.47a3e4267f5bfp-7, 0x1.8ed38ec839e59p-8,
     -0x1.ef1bdf8829a4cp-9, 0x1.35fb83bb4cc7bp-9}, /* [299] 1.375 <= y <= 1.5 2^-16, degree 10, 62.1 bits */
    {0x1.b1347cd9debccp+3, 0x1.14e38d5ce23cfp-51, -0x1.2461aa8c2ee07p-1, 0x1.750b2e5c7531p-3, -0x1.3e12a58f09b6bp-4,
     0x1.3139f979f42a2p-5, -0x1.3879136cdccedp-6, 0x1.4d3edd767c4bdp-7, -0x1.6d917719afcd1p-8, 0x1.9964c9c9a5769p-9,
     -0x1.d349f30e55495p-10, 0x1.0d27def44d487p-10}, /* [300] 1.5 <= y <= 1.625 2^-16, degree 10, 62.7 bits */
    {0x1.af01de13ab5b6p+3, 0x1.b81e2808ab17ep-52, -0x1.0ecabfb32f85fp-1, 0x1.3fdd8f63b21ffp-3, -0x1.f90a7fea38886p-5,
     0x1.c0bc9820e0fcap-6, -0x1.a95b700818c3cp-7, 0x1.a4075777b57a2p-8, -0x1.aaa2ca5016cc3p-9, 0x1.ba63a896a1581p-10,
     -0x1.d3538d02a37d5p-11, 0x1.f2788b442b9ap-12}, /* [301] 1.625 <= y <= 1.75 2^-16, degree 10, 61.8 bits */
    {0x1.acf757258a2d4p+3, 0x1.e57f0992ad168p-55, -0x1.f85b23b83ddbdp-2, 0x1.154d2924b935bp-3, -0x1.97a0b6988c0c2p-5,
     0x1.5133409047e2p-6, -0x1.2995dcbf47a6bp-7, 0x1.1196f301da42p-8, -0x1.02ba258e93536p-9, 0x1.f38e102b66c63p-11,
     -0x1.eb227a7bc6817p-12, 0x1.e7bb85806fd64p-13}, /* [302] 1.75 <= y <= 1.875 2^-16, degree 10, 63.0 bits */
    {0x1.ab0f8f00eaba3p+3, -0x1.0a3a96c59966bp-53, -0x1.d7ed8136f533ep-2, 0x1.e568337c549cdp-4, -0x1.4dbe0374d069dp-5,
     0x1.0243c54126b55p-6, -0x1.aa6ef0d168528p-8, 0x1.6ec08f0a7d332p-9, -0x1.44738410b80acp-10, 0x1.2504cad5325f3p-11,
     -0x1.0d693da6a488cp-12, 0x1.f4904ba8b0f06p-14}, /* [303] 1.875 <= y <= 2 2^-16, degree 10, 63.9 bits */
    {0x1.a86bbed0839a8p+3, -0x1.c34806699ee32p-51, -0x1.ae6ec58e19c25p-1, 0x1.93984cfc21e98p-2, -0x1.f9fe58f8f8cdp-3,
     0x1.6500e19fde903p-3, -0x1.0cb93088444dep-3, 0x1.a570a2dc9c931p-4, -0x1.53ed4b2f14432p-4, 0x1.17e7d537c43a8p-4,
     -0x1.d7a16f594979p-5, 0x1.8f84bb7ed6161p-5}, /* [304] 1 <= y <= 1.125 2^-15, degree 10, 61.4 bits */
    {0x1.a53db1ec38262p+3, -0x1.3d21e9e41a749p-53, -0x1.8149ff602534cp-1, 0x1.432b5cb572cb5p-2, -0x1.6a7e8d31be422p-3,
     0x1.c9a8c36365c26p-4, -0x1.3438c4d410f53p-4, 0x1.b07f64ce8b4cbp-5, -0x1.381fd60d43f07p-5, 0x1.cbe9d6ff4bc1ep-6,
     -0x1.5a302f2291f2ep-6, 0x1.066106532ccfp-6}, /* [305] 1.125 <= y <= 1.25 2^-15, degree 10, 63.0 bits */
    {0x1.a260e3235aa1fp+3, 0x1.d337a9b94d039p-51, -0x1.5cbc89fbac094p-1, 0x1.08994bb047589p-2, -0x1.0c8433d2f4517p-3,
     0x1.32b7093c6864cp-4, -0x1.75c717d4a8821p-5, 0x1.da87920007a15p-6, -0x1.35d764631a48bp-6, 0x1.9d10dfc479e8ap-7,
     -0x1.1905605bd8dc8p-7, 0x1.8165ee56af43dp-8}, /* [306] 1.25 <= y <= 1.375 2^-15, degree 10, 63.3 bits */
    {0x1.9fc687d29d6e9p+3, -0x1.320021dd79d17p-52, -0x1.3e88e9c814f96p-1, 0x1.b94043ac6fb45p-3, -0x1.98d3870b4d694p-4,
     0x1.aa5e009dee74cp-5, -0x1.da670d11ea5dcp-6, 0x1.12f332de10f67p-6, -0x1.47d47eeaa6945p-7, 0x1.8f0a7d62c09a3p-8,
     -0x1.ef5bc5d5a8c05p-9, 0x1.36214c086228cp-9}, /* [307] 1.375 <= y <= 1.5 2^-15, degree 10, 65.9 bits */
    {0x1.9d638a1b3707cp+3, -0x1.2fe0720d1739ep-52, -0x1.25291a3d7b4aap-1, 0x1.758b794ae86a1p-3, -0x1.3e648b7f7bf0dp-4,
     0x1.317b6c75b7635p-5, -0x1.38b3aeb218dcdp-6, 0x1.4d771aaf0777fp-7, -0x1.6dca02347c569p-8, 0x1.999f94683ec16p-9,
     -0x1.d388d554a4159p-10, 0x1.0d4a13d4d8b9cp-10}, /* [308] 1.5 <= y <= 1.625 2^-15, degree 10, 64.2 bits */
    {0x1.9b2f642c49e78p+3, -0x1.41969c27971b9p-51, -0x1.0f8a9de8cedcap-1, 0x1.404fe64d3711dp-3, -0x1.f991a7d5976f2p-5,
     0x1.c12099893a27p-6, -0x1.a9ae5a3830c97p-7, 0x1.a4510324b103cp-8, -0x1.aae75f4150131p-9, 0x1.baa5af34ebcedp-10,
     -0x1.d394e9d9faf93p-11, 0x1.f2ba629f81a79p-12}, /* [309] 1.625 <= y <= 1.75 2^-15, degree 10, 62.4 bits */
    {0x1.9923646690e08p+3, -0x1.a62a9147b14cap-51, -0x1.f9cd544459dp-2, 0x1.15b3e86a1571bp-3, -0x1.9811c7c604476p-5,
     0x1.518124102a8ddp-6, -0x1.29d1fc298a6b5p-7, 0x1.11c8af1b6eaabp-8, -0x1.02e540a5ea2cp-9, 0x1.f3db564d895bep-11,
     -0x1.eb69ad15c8d9dp-12, 0x1.e7fe4b148c907p-13}, /* [310] 1.75 <= y <= 1.875 2^-15, degree 10, 67.3 bits */
    {0x1.973a304723964p+3, -0x1.964bb8dbb01cbp-52, -0x1.d9537a4542e9ap-2, 0x1.e6222f4544badp-4, -0x1.4e1dbc399179bp-5,
     0x1.0281743bdfe03p-6, -0x1.aac805d58ac4dp-8, 0x1.6f057e7d3755dp-9, -0x1.44ab686b4f43ap-10, 0x1.2533a84d4a8cbp-11,
     -0x1.0d919faa18a3cp-12, 0x1.f4d72723a6f2ap-14}, /* [311] 1.875 <= y <= 2 2^-15, degree 10, 65.5 bits */
    {0x1.9494539c77cf1p+3, 0x1.5010dea30231fp-51, -0x1.afc47a11fb1cep-1, 0x1.943a48d1186b6p-2, -0x1.fa965b25b0a02p-3,
     0x1.655a30422b3adp-3, -0x1.0cf3fc48981f7p-3, 0x1.a5c39a442a565p-4, -0x1.542a9ff5891bbp-4, 0x1.1816b8741b8dap-4,
     -0x1.d7eb702f4a91ep-5, 0x1.8fbfef812f631p-5}, /* [312] 1 <= y <= 1.125 2^-14, degree 10, 61.1 bits */
    {0x1.9163ae733e23cp+3, 0x1.abea241c4a9bep-51, -0x1.828d13f02d615p-1, 0x1.43b4860b1eaa2p-2, -0x1.6af1b33339769p-3,
     0x1.ca21d0c8d444bp-4, -0x1.3480129713528p-4, 0x1.b0d96a9949014p-5, -0x1.385b60aa3d7a6p-5, 0x1.cc3b4b61499b9p-6,
     -0x1.5a699fcc2b848p-6, 0x1.068a235e2eb6ap-6}, /* [313] 1.125 <= y <= 1.25 2^-14, degree 10, 62.0 bits */
    {0x1.8e8469ce3882p+3, -0x1.761a0f68d64d9p-52, -0x1.5defb71b1df84p-1, 0x1.090f6488f42ecp-2, -0x1.0cdde4204ed4dp-3,
     0x1.330c56945600ep-4, -0x1.762202b65130ap-5, 0x1.daef6bd5c71cp-6, -0x1.3615897dc318dp-6, 0x1.9d5dcae19c77p-7,
     -0x1.193667e3823e8p-7, 0x1.81a56e58de203p-8}, /* [314] 1.25 <= y <= 1.375 2^-14, degree 10, 63.4 bits */
    {0x1.8be7b63cf6cf5p+3, -0x1.8bf381913613ap-52, -0x1.3fae4d2cc7841p-1, 0x1.ba0e6c3f19248p-3, -0x1.996275ed6b308p-4,
     0x1.aada1dceeb289p-5, -0x1.dadfd407bf064p-6, 0x1.13322d9ca0031p-6, -0x1.4819509cafdeap-7, 0x1.8f5842d73cbf8p-8,
     -0x1.efb63bd19b8bep-9, 0x1.3656c80739e32p-9}, /* [315] 1.375 <= y <= 1.5 2^-14, degree 10, 62.3 bits */
    {0x1.89827a19b1b6cp+3, -0x1.f577aaa5d063bp-57, -0x1.26426313c171dp-1, 0x1.76417902441fap-3, -0x1.3ed89e4e8ce1dp-4,
     0x1.31d8255f0ef9ep-5, -0x1.3906b0d4a0e01p-6, 0x1.4dc6bf1e1875bp-7, -0x1.6e1a127d8248cp-8, 0x1.99f2d1a322d53p-9,
     -0x1.d3e1dc2c182e8p-10, 0x1.0d7a80766b00bp-10}, /* [316] 1.5 <= y <= 1.625 2^-14, degree 10, 62.7 bits */
    {0x1.874c2c8a7dec6p+3, 0x1.bfc0434c9224ap-52, -0x1.10992a0a5415cp-1, 0x1.40f21f3bd1c44p-3, -0x1.fa5139e18b66fp-5,
     0x1.c1ae49a22a399p-6, -0x1.aa23cc027375fp-7, 0x1.a4b9586517686p-8, -0x1.ab487c7de2f2fp-9, 0x1.bb032b9be0024p-10,
     -0x1.d3f174099b195p-11, 0x1.f31798bfc240dp-12}, /* [317] 1.625 <= y <= 1.75 2^-14, degree 10, 61.8 bits */
    {0x1.853e19747d9b6p+3, -0x1.b76e8d1243bc4p-54, -0x1.fbd73421ea45p-2, 0x1.1645b2d7cd955p-3, -0x1.98b20deea8bap-5,
     0x1.51ef8026ff6a4p-6, -0x1.2a27267ffb54fp-7, 0x1.120f1f51561e5p-8, -0x1.03224b6c90b97p-9, 0x1.f448c0fb45fb5p-11,
     -0x1.ebce7b22da66ap-12, 0x1.e85cd35adf0f6p-13}, /* [318] 1.75 <= y <= 1.875 2^-14, degree 10, 67.2 bits */
    {0x1.8352e44500eap+3, 0x1.99077d608cfe1p-52, -0x1.db4c043b54113p-2, 0x1.e72a1bbd3087p-4, -0x1.4ea56e9fd6a13p-5,
     0x1.02d8dbb0219d5p-6, -0x1.ab4637712ba1ap-8, 0x1.6f6721651aa1bp-9, -0x1.44fa8f56f8deep-10, 0x1.257604e7ea213p-11,
     -0x1.0dcacd3f9e527p-12, 0x1.f53b7912282f5p-14}, /* [319] 1.875 <= y <= 2 2^-14, degree 10, 64.0 bits */
    {0x1.80aa2481fbddep+3, 0x1.2eba666c7f337p-51, -0x1.b1a5edd5f9cfap-1, 0x1.95202f0eb3165p-2, -0x1.fb6dde73c7039p-3,
     0x1.65d8beebc5097p-3, -0x1.0d47483bb32d4p-3, 0x1.a6391eaf3e7fbp-4, -0x1.54817c29c4b2ap-4, 0x1.18591e35e7f04p-4,
     -0x1.d854399b1bdb6p-5, 0x1.9013c2857635fp-5}, /* [320] 1 <= y <= 1.125 2^-13, degree 10, 60.6 bits */
    {0x1.7d75d79c3a649p+3, -0x1.2d4f7a0ff3c72p-51, -0x1.84541811d854dp-1, 0x1.44773a7e55541p-2, -0x1.6b94f9cd69e0cp-3,
     0x1.cacd60bd4127p-4, -0x1.34e519574b7cap-4, 0x1.b158f08cfa01p-5, -0x1.38afb65ffe5d7p-5, 0x1.ccae77f3f996ep-6,
     -0x1.5aba6a6c834aep-6, 0x1.06d81b5328f7ap-6}, /* [321] 1.125 <= y <= 1.25 2^-13, degree 10, 61.7 bits */
    {0x1.7a931c12edf6bp+3, 0x1.7835e035c482ep-52, -0x1.5fa0273939f6cp-1, 0x1.09b7103ad6bf2p-2, -0x1.0d5d1501a1e95p-3,
     0x1.33853ef1a07cp-4, -0x1.76a2d69b319d1p-5, 0x1.db828b7dd90bep-6, -0x1.366d903479c4dp-6, 0x1.9dcabb6844341p-7,
     -0x1.197bd6ee30a77p-7, 0x1.81ff59bf2cf8dp-8}, /* [322] 1.25 <= y <= 1.375 2^-13, degree 10, 62.4 bits */
    {0x1.77f31ba6b106ap+3, 0x1.cf1ba1af959d2p-51, -0x1.414b297e97cb7p-1, 0x1.bb332ac4b169cp-3, -0x1.9a2d2f116524ap-4,
     0x1.ab8a0dbf84196p-5, -0x1.db8afb28925d8p-6, 0x1.138b682c0f55ap-6, -0x1.487acd4256777p-7, 0x1.8fc66a761a479p-8,
     -0x1.f0365961850afp-9, 0x1.36a285c66011bp-9}, /* [323] 1.375 <= y <= 1.5 2^-13, degree 10, 62.3 bits */
    {0x1.758ab75655cc3p+3, -0x1.ce712b92563a4p-53, -0x1.27ce0f21d3703p-1, 0x1.7743f3034cbc2p-3, -0x1.3f7d43dc0cf39p-4,
     0x1.325b98b0c787dp-5, -0x1.397c54c83193bp-6, 0x1.4e37976728ecap-7, -0x1.6e8b7ed1b26e5p-8, 0x1.9a68b9c9df02ap-9,
     -0x1.d45ff3ac8a863p-10, 0x1.0dbf14c6486eap-10}, /* [324] 1.5 <= y <= 1.625 2^-13, degree 10, 62.0 bits */
    {0x1.735161f9c895p+3, 0x1.f10ec9239290dp-51, -0x1.12159614a275fp-1, 0x1.41d88b737326bp-3, -0x1.fb60fe1b7b155p-5,
     0x1.c2772c74d9918p-6, -0x1.aaca40f79c5bcp-7, 0x1.a54d2f4c241ddp-8, -0x1.abd212c5278cdp-9, 0x1.bb87997b03ef4p-10,
     -0x1.d47487366173p-11, 0x1.f39b9c7d639aap-12}, /* [325] 1.625 <= y <= 1.75 2^-13, degree 10, 62.5 bits */
    {0x1.714063f08d3e5p+3, -0x1.cc0043596d9eap-53, -0x1.feb4bebfbe1cfp-2, 0x1.1714cf4f22b37p-3, -0x1.9995726047c08p-5,
     0x1.528bfb9e486fep-6, -0x1.2a9fddcddfb16p-7, 0x1.1272f09fc76a2p-8, -0x1.0378c81d68ac7p-9, 0x1.f4e3c24e6deb2p-11,
     -0x1.ec5d453ed251dp-12, 0x1.e8e2b7c66ab27p-13}, /* [326] 1.75 <= y <= 1.875 2^-13, degree 10, 62.6 bits */
    {0x1.6f525dbb326b4p+3, 0x1.a12c3cbe7a1f7p-51, -0x1.de10ededa8501p-2, 0x1.e8a116b86c9aap-4, -0x1.4f65f97068414p-5,
     0x1.0354cd241c823p-6, -0x1.abf919bbfa048p-8, 0x1.6ff17fcd0d494p-9, -0x1.456ab67195de1p-10, 0x1.25d4092718495p-11,
     -0x1.0e1bcc618362fp-12, 0x1.f5c991dc2f135p-14}, /* [327] 1.875 <= y <= 2 2^-13, degree 10, 62.6 bits */
    {0x1.6ca58fc4bc488p+3, 0x1.717f70b8e9908p-52, -0x1.b44a099ce5367p-1, 0x1.9666e21c12352p-2, -0x1.fc9fb50ed9bf2p-3,
     0x1.668c3b3e11f3p-3, -0x1.0dbd5ecee0ca3p-3, 0x1.a6dfade0c98d1p-4, -0x1.54fc91fc32f57p-4, 0x1.18b7315af6cadp-4,
     -0x1.d8e8ac77518fap-5, 0x1.908a7ff77907ap-5}, /* [328] 1 <= y <= 1.125 2^-12, degree 10, 60.9 bits */
    {0x1.696c21439c0fbp+3, -0x1.a1c67fa962f6bp-52, -0x1.86d2a194f38d9p-1, 0x1.458bfa7964efep-2, -0x1.6c7cb9abd1761p-3,
     0x1.cbc0ba1c49fdcp-4, -0x1.3574575107d4dp-4, 0x1.b20db390874cp-5, -0x1.392739c987323p-5, 0x1.cd521bd41b1b8p-6,
     -0x1.5b2e34b127bb4p-6, 0x1.0716d32b48d2fp-6}, /* [329] 1.125 <= y <= 1.25 2^-12, degree 10, 61.8 bits */
    {0x1.6684898c21045p+3, -0x1.19960cfeba94ep-51, -0x1.61fe9842f903p-1, 0x1.0aa570429e588p-2, -0x1.0e11a4eecb778p-3,
     0x1.3430c4ea47927p-4, -0x1.7759858cc53a5p-5, 0x1.dc531d2bcf77ep-6, -0x1.36ea53c822289p-6, 0x1.9e651cd34c089p-7,
     -0x1.19de39035a51dp-7, 0x1.827ebf381a219p-8}, /* [330] 1.25 <= y <= 1.375 2^-12, degree 10, 61.9 bits */
    {0x1.63dfe8b4cd58ep+3, 0x1.a242fcbc203e9p-52, -0x1.438dc49f20451p-1, 0x1.bcd370e7a2dd3p-3, -0x1.9b4d04de418ecp-4,
     0x1.ac83ad5aac49fp-5, -0x1.dc7db63f6e199p-6, 0x1.1409ea3d37aafp-6, -0x1.4904fd029bffep-7, 0x1.9062885cfd2c1p-8,
     -0x1.f0ebe55f14c9fp-9, 0x1.370dd70bcff01p-9}, /* [331] 1.375 <= y <= 1.5 2^-12, degree 10, 61.7 bits */
    {0x1.61731821737c6p+3, 0x1.5061d546afab4p-52, -0x1.29f8389fcecbdp-1, 0x1.78b390a047248p-3, -0x1.406712bb7d59ap-4,
     0x1.33161ffa04027p-5, -0x1.3a2330554c3cep-6, 0x1.4ed7993535c29p-7, -0x1.6f2c494b2a349p-8, 0x1.9b0fd7f6f8cdbp-9,
     -0x1.d512a543d7661p-10, 0x1.0e20422cb4c29p-10}, /* [332] 1.5 <= y <= 1.625 2^-12, degree 10, 62.2 bits */
    {0x1.5f35848d0040ep+3, -0x1.cedcd71a804f4p-54, -0x1.142a0ea3649d2p-1, 0x1.432051c6eebbap-3, -0x1.fce2f9285ffd4p-5,
     0x1.c394441c0964ap-6, -0x1.abb6605cbeb7ep-7, 0x1.a61ed50e1df1cp-8, -0x1.ac9523019b54dp-9, 0x1.bc435106a3b2ep-10,
     -0x1.d52e4c5a445fp-11, 0x1.f456b0c99c888p-12}, /* [333] 1.625 <= y <= 1.75 2^-12, degree 10, 62.5 bits */
    {0x1.5d20715687f5dp+3, 0x1.59125fdc17aa7p-53, -0x1.015b6c48f7d4ap-1, 0x1.183b79446a07cp-3, -0x1.9ad8730021d16p-5,
     0x1.536a15a47f7f9p-6, -0x1.2b4b1f4de4617p-7, 0x1.1300807f484d3p-8, -0x1.03f368a9afb5fp-9, 0x1.f5bf7ea23d6f2p-11,
     -0x1.ed27a897a333fp-12, 0x1.e9a078af5e415p-13}, /* [334] 1.75 <= y <= 1.875 2^-12, degree 10, 61.9 bits */
    {0x1.5b2e7ad71957ap+3, 0x1.5032d08c873a3p-51, -0x1.e1effcd20c1d5p-2, 0x1.eab6abcde3984p-4, -0x1.5077828bda0aep-5,
     0x1.0404bd17b3428p-6, -0x1.acf6e7003e947p-8, 0x1.70b5c09488f01p-9, -0x1.4609be4d9b779p-10, 0x1.265952f52f387p-11,
     -0x1.0e8e9c37dbb06p-12, 0x1.f692f6f2905cep-14}, /* [335] 1.875 <= y <= 2 2^-12, degree 10, 62.4 bits */
    {0x1.587c021b44dd7p+3, 0x1.bc01e1996c2p-51, -0x1.b7fa694284989p-1, 0x1.9837de68dda7p-2, -0x1.fe5247a32b95bp-3,
     0x1.678b0d5a397bap-3, -0x1.0e64f03afdddfp-3, 0x1.a7cbf234bda89p-4, -0x1.55ab1fa463d9p-4, 0x1.193c94076aa6cp-4,
     -0x1.d9bb1ea14b158p-5, 0x1.9132cea7e1375p-5}, /* [336] 1 <= y <= 1.125 2^-11, degree 10, 61.2 bits */
    {0x1.553b69d021feap+3, -0x1.cc048d5fb407fp-51, -0x1.8a4d85d70c3a1p-1, 0x1.4715fb3e9d0d8p-2, -0x1.6dc61a1384b6fp-3,
     0x1.cd1a49443bf2dp-4, -0x1.363fa38e51ba2p-4, 0x1.b30e2807a38cp-5, -0x1.39d0be0fd44e3p-5, 0x1.ce39e7041dabfp-6,
     -0x1.5bd1993903e77p-6, 0x1.078bbceb90977p-6}, /* [337] 1.125 <= y <= 1.25 2^-11, degree 10, 62.2 bits */
    {0x1.524d0b25ba891p+3, -0x1.e9499b0953355p-59, -0x1.654bc96b5f55bp-1, 0x1.0bf8e51ed6f44p-2, -0x1.0f1253dfcdf35p-3,
     0x1.35246185a2986p-4, -0x1.785cd72171225p-5, 0x1.dd7b10964df2fp-6, -0x1.379b4ff2840f5p-6, 0x1.9f400ff5d5a56p-7,
     -0x1.1a69bab77642cp-7, 0x1.83335e1a772b8p-8}, /* [338] 1.25 <= y <= 1.375 2^-11, degree 10, 61.9 bits */
    {0x1.4fa1f875e3138p+3, 0x1.c3f0f65e14673p-51, -0x1.46b350fc2d1bap-1, 0x1.bf245f9b468a2p-3, -0x1.9ce6490937955p-4,
     0x1.ade646d8ecd2cp-5, -0x1.ddd652882c4e3p-6, 0x1.14bd73537fe9ap-6, -0x1.49c90a3ce2131p-7, 0x1.913ff8e41833bp-8,
     -0x1.f1ed5bb3d4104p-9, 0x1.37a6028702d91p-9}, /* [339] 1.375 <= y <= 1.5 2^-11, degree 10, 62.2 bits */
    {0x1.4d2f00545c2b1p+3, 0x1.89856806aea48p-53, -0x1.2cfaf2c3db599p-1, 0x1.7abf4df6e1e17p-3, -0x1.41b395f0de367p-4,
     0x1.341f2404f8f95p-5, -0x1.3b101db55ae4bp-6, 0x1.4fbab49a649f1p-7, -0x1.70106fc743d13p-8, 0x1.9bfcea4cfa50ap-9,
     -0x1.d61016f89bbcep-10, 0x1.0eaa10929d35cp-10}, /* [340] 1.5 <= y <= 1.625 2^-11, degree 10, 61.8 bits */
    {0x1.4aeb86caa3b98p+3, 0x1.aa06cd102298cp-54, -0x1.170de0bef9e2fp-1, 0x1.44f364c27736fp-3, -0x1.ff0800d2dcec5p-5,
     0x1.c5296293533f1p-6, -0x1.ad05b429af793p-7, 0x1.a7486f80c691bp-8, -0x1.ada9f35707b05p-9, 0x1.bd4da3c680b1dp-10,
     -0x1.d635ce8fe8aep-11, 0x1.f5600337c4771p-12}, /* [341] 1.625 <= y <= 1.75 2^-11, degree 10, 62.0 bits */
    {0x1.48d0c81aaa3b4p+3, 0x1.b9026f363dbd4p-51, -0x1.04239131b48c7p-1, 0x1.19df72290892cp-3, -0x1.9ca3fad53bceap-5,
     0x1.54a5bdf2606e2p-6, -0x1.2c3e5cf5f3565p-7, 0x1.13c97aee5462ap-8, -0x1.04a172dbb3255p-9, 0x1.f6f7472a87b21p-11,
     -0x1.ee46c4ba259b2p-12, 0x1.eaad9cb3b9f44p-13}, /* [342] 1.75 <= y <= 1.875 2^-11, degree 10, 62.1 bits */
    {0x1.46d95ab49e1c1p+3, -0x1.15368773bf9ep-51, -0x1.e74e539a4f5ddp-2, 0x1.edaf4cfc95c2ep-4, -0x1.51fcbb5227365p-5,
     0x1.04fed2b436c43p-6, -0x1.ae5f6f0b99792p-8, 0x1.71cc68ee19d47p-9, -0x1.46eb797027adbp-10, 0x1.27167778b4393p-11,
     -0x1.0f317fdfaef21p-12, 0x1.f7b0a4beb29e5p-14}, /* [343] 1.875 <= y <= 2 2^-11, degree 10, 63.0 bits */
    {0x1.441f078634ca2p+3, -0x1.79f16054720ecp-51, -0x1.bd163140232bbp-1, 0x1.9acee0de2f28p-2, -0x1.005e6609408e4p-2,
     0x1.68f55769c6a89p-3, -0x1.0f530486be3a5p-3, 0x1.a91b7a06713cdp-4, -0x1.56a2ed56996bep-4, 0x1.19f9e308e53d8p-4,
     -0x1.dae5bb2bbb193p-5, 0x1.9221953ac4786p-5}, /* [344] 1 <= y <= 1.125 2^-10, degree 10, 60.7 bits */
    {0x1.40d4860a17fbp+3, 0x1.d9a8c7af5a93fp-51, -0x1.8f1d08c171f0dp-1, 0x1.4947f2c51d283p-2, -0x1.6f9b09f2f268fp-3,
     0x1.cf05b6641e291p-4, -0x1.37608d143be3cp-4, 0x1.b47a6f6afa6e2p-5, -0x1.3ac17199c8241p-5, 0x1.cf82f07ca2a21p-6,
     -0x1.5cb97c248d525p-6, 0x1.0831a10601602p-6}, /* [345] 1.125 <= y <= 1.25 2^-10, degree 10, 61.9 bits */
    {0x1.3ddccb282aecap+3, -0x1.48b39b153a31ap-53, -0x1.69da1ba931ad5p-1, 0x1.0ddd31585441ep-2, -0x1.107fdfc005a62p-3,
     0x1.367ee96ac7b35p-4, -0x1.79cd727c4e851p-5, 0x1.df1f87cae307bp-6, -0x1.3896aa504ff5p-6, 0x1.a076ebf2abfc5p-7,
     -0x1.1b2fbfeb24e7bp-7, 0x1.8433b204e395fp-8}, /* [346] 1.25 <= y <= 1.375 2^-10, degree 10, 62.2 bits */
    {0x1.3b28d5aae7f11p+3, -0x1.fc02b9c873a8ep-54, -0x1.4b09125674c55p-1, 0x1.c27281d07d5b9p-3, -0x1.9f2d4815a15fcp-4,
     0x1.afdecd6d18013p-5, -0x1.dfc044f3b2342p-6, 0x1.15bc92086d4fap-6, -0x1.4adf854ff77cap-7, 0x1.927a6b3884434p-8,
     -0x1.f35addb402cdap-9, 0x1.387dfe76c0bc9p-9}, /* [347] 1.375 <= y <= 1.5 2^-10, degree 10, 62.2 bits */
    {0x1.38ad64bf8d12bp+3, -0x1.e8012c8da83eap-51, -0x1.311f01d8ce343p-1, 0x1.7daadc933cb2dp-3, -0x1.438d5d6870de9p-4,
     0x1.35984a1a6974fp-5, -0x1.3c61083b6d544p-6, 0x1.50fd7bb2940cfp-7, -0x1.715491026c5e4p-8, 0x1.9d4d9cdd63fa6p-9,
     -0x1.d777f2734a8dbp-10, 0x1.0f6db0836616dp-10}, /* [348] 1.5 <= y <= 1.625 2^-10, degree 10, 61.3 bits */
    {0x1.3661d00d217c6p+3, -0x1.b5a5998f1c66p-51, -0x1.1b05d1827cdebp-1, 0x1.478e33ac7d5dbp-3, -0x1.010b3c2d708e4p-4,
     0x1.c76a09bca253cp-6, -0x1.aee2a31ca1d9fp-7, 0x1.a8ef7adc25b6fp-8, -0x1.af33476fb371cp-9, 0x1.bec7f040284c4p-10,
     -0x1.d7ac0200b0023p-11, 0x1.f6d8b487c81bfp-12}, /* [349] 1.625 <= y <= 1.75 2^-10, degree 10, 61.3 bits */
    {0x1.343f49b277153p+3, -0x1.b566be992a032p-52, -0x1.07f3fe04d04dfp-1, 0x1.1c371e3eff199p-3, -0x1.9f330a250d82p-5,
     0x1.566724bf3e428p-6, -0x1.2d98628ddcc98p-7, 0x1.14e738093bacfp-8, -0x1.0598c84112573p-9, 0x1.f8b236e2f9139p-11,
     -0x1.efde8a6305a2p-12, 0x1.ec2bc6a92dcbfp-13}, /* [350] 1.75 <= y <= 1.875 2^-10, degree 10, 61.6 bits */
    {0x1.32405fb365225p+3, 0x1.4a25f5113d1b7p-52, -0x1.eea7d9568e5e6p-2, 0x1.f1ed91fedcbcap-4, -0x1.5427af0172d45p-5,
     0x1.0662efa6d8ef1p-6, -0x1.b0606545cbad4p-8, 0x1.7358a6b351e53p-9, -0x1.482c50b30d3abp-10, 0x1.282335d288f6ep-11,
     -0x1.1018e03245969p-12, 0x1.f9465761c45edp-14}, /* [351] 1.875 <= y <= 2 2^-10, degree 10, 62.2 bits */
    {0x1.2f7b4f298ab2ep+3, 0x1.0de96a3f06fe3p-56, -0x1.c410a6e9512e7p-1, 0x1.9e81f0f7da3c8p-2, -0x1.021778749e5c1p-2,
     0x1.6af95eec06cp-3, -0x1.10a5d6b23a4eap-3, 0x1.aaf8b27c47b78p-4, -0x1.580336fad8f9fp-4, 0x1.1b06eb665b34fp-4,
     -0x1.dc8df90b3fc6dp-5, 0x1.9374bb87f520bp-5}, /* [352] 1 <= y <= 1.125 2^-9, degree 10, 60.8 bits */
    {0x1.2c2348b71ae0ap+3, -0x1.921a4455a4539p-54, -0x1.95aa88c441da6p-1, 0x1.4c6ae04b7c0dp-2, -0x1.723817cce05c1p-3,
     0x1.d1c1ea242a9b6p-4, -0x1.38fbd73cf22f9p-4, 0x1.b680b0d55c9a9p-5, -0x1.3c17b998a9bbbp-5, 0x1.d156a9281aa7ep-6,
     -0x1.5e0301c9e48ddp-6, 0x1.091d4ef3e59a5p-6}, /* [353] 1.125 <= y <= 1.25 2^-9, degree 10, 62.0 bits */
    {0x1.291ed24a4e4eep+3, 0x1.4b2ec0da546p-51, -0x1.700a74c62469dp-1, 0x1.109149ce361d9p-2, -0x1.128997682014fp-3,
     0x1.386cd0e75c7dfp-4, -0x1.7bda56bfaa67dp-5, 0x1.e175e1717f66fp-6, -0x1.39fc2e8674c1fp-6, 0x1.a230e81974b16p-7,
     -0x1.1c4935659b084p-7, 0x1.859fef1ad4c3cp-8}, /* [354] 1.25 <= y <= 1.375 2^-9, degree 10, 62.2 bits */
    {0x1.265ecec4599c7p+3, 0x1.5cbe783e7a339p-51, -0x1.50e89383cf92ap-1, 0x1.c72be412bb966p-3, -0x1.a26d9b88d634dp-4,
     0x1.b2ae1aa18a2bbp-5, -0x1.e27a229f12b65p-6, 0x1.1727b697c6a1p-6, -0x1.4c6bb711f1b6cp-7, 0x1.94399a37f24cdp-8,
     -0x1.f5627e754a576p-9, 0x1.39b0f74191222p-9}, /* [355] 1.375 <= y <= 1.5 2^-9, degree 10, 62.7 bits */
    {0x1.23d7e756da2f1p+3, -0x1.088e7d5315a34p-52, -0x1.36b779c80e6fep-1, 0x1.81d77dac52ec2p-3, -0x1.4631f5aa94e1ep-4,
     0x1.37b2232a4e4dp-5, -0x1.3e410c081989ap-6, 0x1.52c90a1d1d991p-7, -0x1.7321ceac05461p-8, 0x1.9f2c8a243a5a8p-9,
     -0x1.d977a4a586037p-10, 0x1.1083c7161e042p-10}, /* [356] 1.5 <= y <= 1.625 2^-9, degree 10, 62.8 bits */
    {0x1.218161f9e1fc7p+3, 0x1.22b7b2d0b608ep-52, -0x1.205f37692ab04p-1, 0x1.4b47800d631bap-3, -0x1.033a18fb61763p-4,
     0x1.caa09bf8931b8p-6, -0x1.b18a4d4618219p-7, 0x1.ab49ed006286dp-8, -0x1.b1631b952be59p-9, 0x1.c0e2257a48233p-10,
     -0x1.d9c03326b6428p-11, 0x1.f8f048db52a4ep-12}, /* [357] 1.625 <= y <= 1.75 2^-9, degree 10, 61.7 bits */
    {0x1.1f546251c6025p+3, 0x1.cad8e599403c2p-51, -0x1.0d14e5242fb7ep-1, 0x1.1f9080dd08747p-3, -0x1.a2db009701bd2p-5,
     0x1.58e85a41e4de9p-6, -0x1.2f859a7cd52b8p-7, 0x1.167e37cc885p-8, -0x1.06f8e2933f618p-9, 0x1.fb28806facaffp-11,
     -0x1.f22294fe40801p-12, 0x1.ee4b3a4e7b96fp-13}, /* [358] 1.75 <= y <= 1.875 2^-9, degree 10, 62.3 bits */
    {0x1.1d4b6a59c319ap+3, 0x1.f738d3cd7a79fp-52, -0x1.f883ab95c8db5p-2, 0x1.f7fec22e9f429p-4, -0x1.5740cbae99175p-5,
     0x1.085f2881de965p-6, -0x1.b33bba743ae2dp-8, 0x1.758d296f64386p-9, -0x1.49f5265981a06p-10, 0x1.29a1b1d250a8cp-11,
     -0x1.11620e958c4d7p-12, 0x1.fb875aa756ac9p-14}, /* [359] 1.875 <= y <= 2 2^-9, degree 10, 66.2 bits */
    {0x1.1a77f85ae4cbdp+3, -0x1.ccbac54f2d7d7p-54, -0x1.cd648b9f97acdp-1, 0x1.a3cc266fafce5p-2, -0x1.048e08ed63418p-2,
     0x1.6dda0e36dab14p-3, -0x1.12890bcd79f37p-3, 0x1.ada0c5a23d622p-4, -0x1.59f8f62cbf227p-4, 0x1.1c85e9f9894dep-4,
     -0x1.dee9b1238ec6dp-5, 0x1.9557352f50184p-5}, /* [360] 1 <= y <= 1.125 2^-8, degree 10, 60.7 bits */
    {0x1.170dea35bf156p+3, 0x1.149387d622826p-52, -0x1.9e629ffdc02f5p-1, 0x1.50e6fcec1c02fp-2, -0x1.75f4f4cbaff54p-3,
     0x1.d5a9ecde74043p-4, -0x1.3b469f37438ddp-4, 0x1.b96382f541701p-5, -0x1.3dff62b8d7aebp-5, 0x1.d3ee919d01181p-6,
     -0x1.5fd7f10862fb4p-6, 0x1.0b4800fd9c58bp-6}, /* [361] 1.125 <= y <= 1.25 2^-8, degree 10, 61.6 bits */
    {0x1.13f88c18d97ep+3, -0x1.5e3fddfbd532fp-55, -0x1.783d59f429553p-1, 0x1.146edd2f9f477p-2, -0x1.1573fecf0e2a5p-3,
     0x1.3b2e74b7e1cddp-4, -0x1.7ec775103129cp-5, 0x1.e4cb29b1a06bap-6, -0x1.3bf9b5560180dp-6, 0x1.a4a6819c84c5fp-7,
     -0x1.1dd9fa5208af1p-7, 0x1.87a6654e471b6p-8}, /* [362] 1.25 <= y <= 1.375 2^-8, degree 10, 62.4 bits */
    {0x1.112898f8e3a34p+3, -0x1.ec9ec24715796p-51, -0x1.58a7e28e1fcaep-1, 0x1.cdece9dc3da67p-3, -0x1.a714c17abaf06p-4,
     0x1.b6b21d86388f4p-5, -0x1.e65e71f3eaae4p-6, 0x1.192dbc96f9845p-6, -0x1.4ea088032d53ap-7, 0x1.96b6c9519dcadp-8,
     -0x1.f8469759757cep-9, 0x1.3b6606b7a2dd3p-9}, /* [363] 1.375 <= y <= 1.5 2^-8, degree 10, 61.0 bits */
    {0x1.0e929a931ebbfp+3, 0x1.ec6c7da5775b7p-51, -0x1.3e113bb523f63p-1, 0x1.87cf0d21d3309p-3, -0x1.49fa81a85b183p-4,
     0x1.3ab30ef7901a6p-5, -0x1.40ee8ccd65be5p-6, 0x1.5558c99d47facp-7, -0x1.75b3894de5a73p-8, 0x1.a1d7227e5c0bdp-9,
     -0x1.dc50a0d56717cp-10, 0x1.120fcf8afeef2p-10}, /* [364] 1.5 <= y <= 1.625 2^-8, degree 10, 61.2 bits */
    {0x1.0c2dbd903f86ep+3, -0x1.7dcb8e8aeb80ep-51, -0x1.275ed3529882ap-1, 0x1.5099f1ab5ab85p-3, -0x1.065a4ecf08032p-4,
     0x1.cf38eb1a62dbbp-6, -0x1.b55533012ca3dp-7, 0x1.aea5ccf6e187ep-8, -0x1.b481a1c6d9e35p-9, 0x1.c3e16cb2d087ep-10,
     -0x1.dcb691144b592p-11, 0x1.fbeb31cae2d69p-12}, /* [365] 1.625 <= y <= 1.75 2^-8, degree 10, 61.8 bits */
    {0x1.09f310da2b297p+3, 0x1.25686f0f3dba3p-53, -0x1.13c3c531a7519p-1, 0x1.24599934d4225p-3, -0x1.a8177629db4e9p-5,
     0x1.5c7d8db1c3f6ap-6, -0x1.32465a3c4e21p-7, 0x1.18c347dbf39ap-8, -0x1.08ef3d4865ebap-9, 0x1.feab4376f73cp-11,
     -0x1.f55d52a28d0a8p-12, 0x1.f151859f0015ap-13}, /* [366] 1.75 <= y <= 1.875 2^-8, degree 10, 61.9 bits */
    {0x1.07dd0530b27b1p+3, 0x1.8c391062981dp-52, -0x1.02a7db9586f9ep-1, 0x1.0054c19aea741p-3, -0x1.5bb0e4955baf6p-5,
     0x1.0b3650622cef2p-6, -0x1.b750fa56df632p-8, 0x1.78b34c3848485p-9, -0x1.4c8114d1517cdp-10, 0x1.2bc33953278c8p-11,
     -0x1.1337587a359bdp-12, 0x1.febda34c09f7ap-14}, /* [367] 1.875 <= y <= 2 2^-8, degree 10, 63.1 bits */
    {0x1.04f6f610ab9ccp+3, -0x1.c4ab8e6b9a1e5p-51, -0x1.d96e747290de5p-1, 0x1.ab59d6ba024c2p-2, -0x1.081585d820a24p-2,
     0x1.71f874fefe697p-3, -0x1.153be8d8ee7c2p-3, 0x1.b16c45890b035p-4, -0x1.5cc539675f99bp-4, 0x1.1ea8588f55674p-4,
     -0x1.e246a1acb3033p-5, 0x1.9806f8cc89dd2p-5}, /* [368] 1 <= y <= 1.125 2^-7, degree 10, 59.9 bits */
    {0x1.0175b8a5b53c3p+3, -0x1.026db3f9e73bfp-55, -0x1.a98e2156dd5abp-1, 0x1.574d55a99ec68p-2, -0x1.7b505b8436a2fp-3,
     0x1.db41cf581cf6dp-4, -0x1.3e8dee17d9e69p-4, 0x1.bd835e5908c39p-5, -0x1.40b7d2f0278dep-5, 0x1.d7a7646c56a66p-6,
     -0x1.6275429f2cba5p-6, 0x1.0c4af076166e1p-6}, /* [369] 1.125 <= y <= 1.25 2^-7, degree 10, 62.3 bits */
    {0x1.fc958c82754c3p+2, 0x1.c12dc64ec898dp-53, -0x1.82aada67ba52p-1, 0x1.19f1f7c015f5p-2, -0x1.19a1fe5a20f8fp-3,
     0x1.3f21351e20bd4p-4, -0x1.82f761eceb4d4p-5, 0x1.e98f147f7c18dp-6, -0x1.3ed1a66998bd5p-6, 0x1.a82976cee34efp-7,
     -0x1.2015ebd9cffd1p-7, 0x1.8a89fcb927094p-8}, /* [370] 1.25 <= y <= 1.375 2^-7, degree 10, 61.9 bits */
    {0x1.f6cd413c6d85ep+2, -0x1.c4dbb0aebef74p-53, -0x1.6270a048e7a37p-1, 0x1.d78c85b274ddep-3, -0x1.adc0973ef8206p-4,
     0x1.bc731a0f8bebbp-5, -0x1.ebf0957ed4f68p-6, 0x1.1c129b0be287fp-6, -0x1.51c7beae56cf8p-7, 0x1.9a44e1f2f413dp-8,
     -0x1.fc6724d50718dp-9, 0x1.3dd5b2b4593e2p-9}, /* [371] 1.375 <= y <= 1.5 2^-7, degree 10, 61.2 bits */
    {0x1.f17b48c3708f7p+2, -0x1.13c7e59b3bd28p-53, -0x1.4749563f90a9bp-1, 0x1.904dcab98409dp-3, -0x1.4f6757c8f7ef2p-4,
     0x1.3f011ef2d4abbp-5, -0x1.44c41c0239015p-6, 0x1.5902ef92c154p-7, -0x1.795fd79ba597dp-8, 0x1.a5a666c00bd1ap-9,
     -0x1.e061a3af448eap-10, 0x1.14451b9f3cfc7p-10}, /* [372] 1.5 <= y <= 1.625 2^-7, degree 10, 62.4 bits */
    {0x1.ec8db3d41466bp+2, 0x1.964eafd4cf5cep-52, -0x1.3016a474b2cbbp-1, 0x1.582be88ba55e2p-3, -0x1.0ad5d84937ceep-4,
     0x1.d5cf4c2adbaap-6, -0x1.bac3d1b99b24p-7, 0x1.b3745b8796bbdp-8, -0x1.b8f7913ed0257p-9, 0x1.c82a02483373cp-10,
     -0x1.e0f1d9bd927eep-11, 0x1.00163d6f622ecp-11}, /* [373] 1.625 <= y <= 1.75 2^-7, degree 10, 64.4 bits */
    {0x1.e7f664cf6c7d9p+2, -0x1.d3c76d80b4999p-54, -0x1.1c08cd2c1a6b6p-1, 0x1.2b26983726765p-3, -0x1.af99cf422e1p-5,
     0x1.61a0c34b481f9p-6, -0x1.36380a2c8a511p-7, 0x1.1c03114dfedafp-8, -0x1.0bbdd691e4829p-9, 0x1.01d80f7f68c45p-10,
     -0x1.f9fa991eff74ap-12, 0x1.f5a35b96b46fp-13}, /* [374] 1.75 <= y <= 1.875 2^-7, degree 10, 61.1 bits */
    {0x1.e3aa0bc88b84p+2, 0x1.356115eaadcc6p-53, -0x1.0a8567d40cb9ep-1, 0x1.067bcd0450c36p-3, -0x1.620e2b93cffdap-5,
     0x1.0f49370513b65p-6, -0x1.bd2ade49236b9p-8, 0x1.7d35941a2ca4cp-9, -0x1.5025e45face6cp-10, 0x1.2ecf4f6942a7bp-11,
     -0x1.15d60dfdcbf99p-12, 0x1.01aa2797104c4p-13}, /* [375] 1.875 <= y <= 2 2^-7, degree 10, 61.6 bits */
    {0x1.ddb062f4ae5cp+2, 0x1.d93ed85444e21p-52, -0x1.e8161fb5e877p-1, 0x1.b60f1fb2cc828p-2, -0x1.0d2525805dce9p-2,
     0x1.77e11401cc8b2p-3, -0x1.191a47ab32edp-3, 0x1.b6dbd5c04d599p-4, -0x1.60c675e8c74f4p-4, 0x1.21b60299ebd02p-4,
     -0x1.e71587ed131d1p-5, 0x1.9bddd2758b94cp-5}, /* [376] 1 <= y <= 1.125 2^-6, degree 10, 60.1 bits */
    {0x1.d675d102594a6p+2, -0x1.cb8b6a7fca3bfp-53, -0x1.b6fad2ebdfb93p-1, 0x1.605b1f2219913p-2, -0x1.82fea8a5539b6p-3,
     0x1.e3487ee63820cp-4, -0x1.4341904f94f6ep-4, 0x1.c36c6b3f2894ap-5, -0x1.449d20b08449dp-5, 0x1.dcf7ebbe67a4p-6,
     -0x1.66326c9447ep-6, 0x1.0ef6b48774d5ep-6}, /* [377] 1.125 <= y <= 1.25 2^-6, degree 10, 60.6 bits */
    {0x1.cfec600b03957p+2, 0x1.239b4ddc25d52p-52, -0x1.8f0b070220fabp-1, 0x1.21b9f9478b07ep-2, -0x1.1f9fc14c596d2p-3,
     0x1.44cbdc8de3decp-4, -0x1.88f91bae8221dp-5, 0x1.f063e1f059598p-6, -0x1.42e47ab2dba94p-6, 0x1.ad3080f6c004ap-7,
     -0x1.234854ae63471p-7, 0x1.8eabc93dd00c4p-8}, /* [378] 1.25 <= y <= 1.375 2^-6, degree 10, 60.9 bits */
    {0x1.c9f46f70222eep+2, -0x1.79da1a111be57p-52, -0x1.6de876fe97f11p-1, 0x1.e51a96e3cf33ep-3, -0x1.b74fd354ec7cfp-4,
     0x1.c4b56f25865e9p-5, -0x1.f3ef01612ce75p-6, 0x1.2039064915eb5p-6, -0x1.564c8c58bfc76p-7, 0x1.9f5c585e63079p-8,
     -0x1.0127c6783d8ap-8, 0x1.415207bf31eefp-9}, /* [379] 1.375 <= y <= 1.5 2^-6, degree 10, 61.1 bits */
    {0x1.c476373942f91p+2, 0x1.3775becd9718p-52, -0x1.51f5acfc95e54p-1, 0x1.9c3e014aa9f15p-3, -0x1.572caaef14efbp-4,
     0x1.452f2426fd705p-5, -0x1.4a44e886afe32p-6, 0x1.5e44a63833314p-7, -0x1.7ea3cf2c5d1d7p-8, 0x1.ab1baad4dc69fp-9,
     -0x1.e6344d69b9e3p-10, 0x1.176e3159dbad6p-10}, /* [380] 1.5 <= y <= 1.625 2^-6, degree 10, 63.0 bits */
    {0x1.bf5f60267bf42p+2, -0x1.51740989c9435p-52, -0x1.3a0ee6db8e3b7p-1, 0x1.62c90ba252777p-3, -0x1.1140c6e8374fep-4,
     0x1.df442acc4de33p-6, -0x1.c2901aa106bebp-7, 0x1.ba59f7240dc2dp-8, -0x1.bf5d0d1166f84p-9, 0x1.ce4d9069ca598p-10,
     -0x1.e701871117e26p-11, 0x1.032201c903a1cp-11}, /* [381] 1.625 <= y <= 1.75 2^-6, degree 10, 62.2 bits */
    {0x1.baa17776a826dp+2, -0x1.66f11e60cfd7bp-53, -0x1.25604f9ddddbep-1, 0x1.34a9cd2c3855ap-3, -0x1.ba589ce3e84a2p-5,
     0x1.6900c3e5777c2p-6, -0x1.3be1b3ad4c90ap-7, 0x1.20acc990ffda4p-8, -0x1.0fc48b6558a8ep-9, 0x1.05710131d09b4p-10,
     -0x1.004b8f9905777p-11, 0x1.fbd30bf7689fp-13}, /* [382] 1.75 <= y <= 1.875 2^-6, degree 10, 62.3 bits */
    {0x1.b630e67e6e4b6p+2, 0x1.c88939fb8bdap-53, -0x1.134c56bb78e6cp-1, 0x1.0f119a327688ap-3, -0x1.6b2846dad7edep-5,
     0x1.152239ef79a71p-6, -0x1.c591b9d23286p-8, 0x1.83ae719b32f95p-9, -0x1.556029b48475bp-10, 0x1.332de03f2e80ep-11,
     -0x1.19974c11085dp-12, 0x1.04f3844cbd815p-13}, /* [383] 1.875 <= y <= 2 2^-6, degree 10, 62.3 bits */
    {0x1.b004e136a5423p+2, -0x1.59bb90a361212p-53, -0x1.f8245889edcd6p-1, 0x1.c4f255b65845cp-2, -0x1.1460593851561p-2,
     0x1.805c014ba364p-3, -0x1.1ea88d8789384p-3, 0x1.bea9caa9184b6p-4, -0x1.6685c95669b77p-4, 0x1.261739171071cp-4,
     -0x1.edfa410d34361p-5, 0x1.a15e47571fbf8p-5}, /* [384] 1 <= y <= 1.125 2^-5, degree 10, 59.8 bits */
    {0x1.a88d99409b85cp+2, 0x1.ecb98940c59cp-52, -0x1.c5542f49edb24p-1, 0x1.6ce19fecaa602p-2, -0x1.8df4420d2dc97p-3,
     0x1.eecc78fbaf3d7p-4, -0x1.4a023bb7898dep-4, 0x1.cbe9592315364p-5, -0x1.4a34db8c6a672p-5, 0x1.e498386467d96p-6,
     -0x1.6b8f474d2751ep-6, 0x1.12caf437497b3p-6}, /* [385] 1.125 <= y <= 1.25 2^-5, degree 10, 61.2 bits */
    {0x1.a1cdbb507fc69p+2, -0x1.df060ee9b1066p-52, -0x1.9bf1d0cc44546p-1, 0x1.2c6ff89bdbd94p-2, -0x1.2828e1e2d19a2p-3,
     0x1.4cec5295edf95p-4, -0x1.9199921e09309p-5, 0x1.fa33d14263629p-6, -0x1.48bdf9920d414p-6, 0x1.b467f59754e3ap-7,
     -0x1.27de995a8fb11p-7, 0x1.9498e656ae866p-8}, /* [386] 1.25 <= y <= 1.375 2^-5, degree 10, 60.8 bits */
    {0x1.9ba4bcd1acbdp+2, 0x1.b1cd6ec52d176p-52, -0x1.79903be20d85p-1, 0x1.f7aaf0ce1518bp-3, -0x1.c4e8b391d9055p-4,
     0x1.d08c273e14ec1p-5, -0x1.ff69c76d3fbcp-6, 0x1.262f37c850237p-6, -0x1.5cca106adc44ap-7, 0x1.a6abe3ee1d054p-8,
     -0x1.0565215a4f5dep-8, 0x1.4652430e2cf3dp-9}, /* [387] 1.375 <= y <= 1.5 2^-5, degree 10, 61.0 bits */
    {0x1.95fa1dc603418p+2, 0x1.9ed26541e2c64p-56, -0x1.5c87715b6926bp-1, 0x1.ac8230053381bp-3, -0x1.6235599061c13p-4,
     0x1.4e097c09edaabp-5, -0x1.522bb222f537cp-6, 0x1.65d1e4d773f7cp-7, -0x1.8634343cddda3p-8, 0x1.b2f25ab73c546p-9,
     -0x1.ee9061d7ed223p-10, 0x1.1bf755889d2d7p-10}, /* [388] 1.5 <= y <= 1.625 2^-5, degree 10, 61.8 bits */
    {0x1.90baf3229bd98p+2, -0x1.eec9c8e9d149fp-55, -0x1.43abec78d15d7p-1, 0x1.712c2f93442dap-3, -0x1.1a5962af656b4p-4,
     0x1.eccde5aa7751fp-6, -0x1.cdc1c892bc9e5p-7, 0x1.c44269f2d6c63p-8, -0x1.c88d9cb3ed8bdp-9, 0x1.d71ef97d110bdp-10,
     -0x1.efb5b766d7959p-11, 0x1.07815d5bfcd91p-11}, /* [389] 1.625 <= y <= 1.75 2^-5, degree 10, 60.9 bits */
    {0x1.8bd8515d996bp+2, -0x1.cebc8a330dd02p-53, -0x1.2e23fc696a82cp-1, 0x1.417db64bf3ce2p-3, -0x1.c98c195aaab8p-5,
     0x1.738da849aac69p-6, -0x1.440220860a3e6p-7, 0x1.275f94198c1b6p-8, -0x1.158d756e3ca4ap-9, 0x1.0a9c0f454531dp-10,
     -0x1.050b050d86e2ep-11, 0x1.025a7a161ab0dp-12}, /* [390] 1.75 <= y <= 1.875 2^-5, degree 10, 61.3 bits */
    {0x1.87463d9cec69p+2, 0x1.b0ad58446429dp-53, -0x1.1b4d8c5565f2p-1, 0x1.1a95fae6b1064p-3, -0x1.780228cc7654ap-5,
     0x1.1d7e1676ac381p-6, -0x1.d19f70c4976eep-8, 0x1.8cfa52220a6ddp-9, -0x1.5ce30c695e8a7p-10, 0x1.39750529ca8d6p-11,
     -0x1.1efc1fe500c1cp-12, 0x1.09abcee29681cp-13}, /* [391] 1.875 <= y <= 2 2^-5, degree 10, 61.8 bits */
    {0x1.80ed4569c0455p+2, 0x1.bef9d769056bcp-53, -0x1.03130833bb4dap+0, 0x1.d8c33052be66dp-2, -0x1.1e8e15bafa237p-2,
     0x1.8c772ed12d90dp-3, -0x1.269fd80f507fdp-3, 0x1.c9defc42093b9p-4, -0x1.6ec7d257cca25p-4, 0x1.2c625912d45a2p-4,
     -0x1.f7e1c3811b0aep-5, 0x1.a94579c6b80dep-5}, /* [392] 1 <= y <= 1.125 2^-4, degree 10, 58.8 bits */
    {0x1.79429ef56963bp+2, -0x1.5dfe064b5a6c9p-52, -0x1.d11360cb554fcp-1, 0x1.7d61034a79839p-2, -0x1.9d5093040f23cp-3,
     0x1.ff350cc4a8b9dp-4, -0x1.53ae9efd24332p-4, 0x1.d8188caef4374p-5, -0x1.523dbf312ec78p-5, 0x1.ef8d30f09941ep-6,
     -0x1.7343c03c86aaep-6, 0x1.1880eec31200fp-6}, /* [393] 1.125 <= y <= 1.25 2^-4, degree 10, 60.3 bits */
    {0x1.7257aa793e95cp+2, -0x1.2f67fb04a7c1dp-53, -0x1.a5cb69156337ep-1, 0x1.3a65b06e86a53p-2, -0x1.3411ecf287c48p-3,
     0x1.587abac339ee9p-4, -0x1.9df20444b80c5p-5, 0x1.0423e26dffdf1p-5, -0x1.5124da2df82fdp-6, 0x1.bec6ad8ca4bc7p-7,
     -0x1.2e762d92e1e94p-7, 0x1.9d1d14097ae4fp-8}, /* [394] 1.25 <= y <= 1.375 2^-4, degree 10, 63.6 bits */
    {0x1.6c0a96188e533p+2, 0x1.8def91a2d18aep-52, -0x1.81cc2d96d4debp-1, 0x1.07cddc7cba6b7p-2, -0x1.d7cb632d45572p-4,
     0x1.e1586dd258812p-5, -0x1.07e941741195bp-5, 0x1.2ebb86e8aecbbp-6, -0x1.661bc38e60d7cp-7, 0x1.b12ce2d379eafp-8,
     -0x1.0b7ceffd8807cp-8, 0x1.4d82357fc4853p-9}, /* [395] 1.375 <= y <= 1.5 2^-4, degree 10, 60.7 bits */
    {0x1.6641e1946f8afp+2, -0x1.178d235d5d78ep-55, -0x1.635eb719a8a0ap-1, 0x1.c143e98ab4c92p-3, -0x1.7175fa19b7ea7p-4,
     0x1.5a91c8205957dp-5, -0x1.5d737ae45d8e1p-6, 0x1.70a3ddb36fec2p-7, -0x1.910f7ac0ed092p-8, 0x1.be34f25129542p-9,
     -0x1.fa93c94055eep-10, 0x1.227c2e84af1fcp-10}, /* [396] 1.5 <= y <= 1.625 2^-4, degree 10, 60.7 bits */
    {0x1.60e9d50bbe8e4p+2, -0x1.0c05643752ca3p-52, -0x1.494c80d57c282p-1, 0x1.8356851a49a3cp-3, -0x1.26dc8fba8aafcp-4,
     0x1.ffec3b2b6a427p-6, -0x1.ddb7665d953f9p-7, 0x1.d271c62d73ca8p-8, -0x1.d5bc9d33cd601p-9, 0x1.e3c8e035a8057p-10,
     -0x1.fc375948a22a6p-11, 0x1.0dca20066b941p-11}, /* [397] 1.625 <= y <= 1.75 2^-4, degree 10, 60.9 bits */
    {0x1.5bf2de5c667eep+2, -0x1.80795b8a72c97p-52, -0x1.32b39100097aap-1, 0x1.51843400b78f3p-3, -0x1.de5a5fe376653p-5,
     0x1.826a499d8e85dp-6, -0x1.4f93f770810f8p-7, 0x1.30f477d2ea117p-8, -0x1.1dd8da590fc99p-9, 0x1.1207822f76954p-10,
     -0x1.0bdd2dc11d93ap-11, 0x1.08bc693ae723p-12}, /* [398] 1.75 <= y <= 1.875 2^-4, degree 10, 60.6 bits */
    {0x1.5750792d98c22p+2, 0x1.61eae911f1b72p-55, -0x1.1eeb73998638cp-1, 0x1.28d25d1b6301ep-3, -0x1.898209af2e198p-5,
     0x1.293c8f99e96bbp-6, -0x1.e2c1e0ae42f37p-8, 0x1.9a4365d108e6cp-9, -0x1.67a686329cbfcp-10, 0x1.427775d745f2cp-11,
     -0x1.26bb69e338abcp-12, 0x1.1074100671e64p-13}, /* [399] 1.875 <= y <= 2 2^-4, degree 10, 63.2 bits */
    {0x1.50e596f576a1fp+2, -0x1.71f5f93412b2fp-53, -0x1.057685bfa3a77p+0, 0x1.f0de3e6ea1213p-2, -0x1.2c4e953ffc21ap-2,
     0x1.9d67ca09408ccp-3, -0x1.31ebdb4188735p-3, 0x1.d9dd2a19b2251p-4, -0x1.7a9a3911e4759p-4, 0x1.3568ffea7bd71p-4,
     -0x1.030d03b5350ap-4, 0x1.b49ffe4b1b5fcp-5}, /* [400] 1 <= y <= 1.125 2^-3, degree 10, 59.7 bits */
    {0x1.492d75267d7b3p+2, -0x1.b565edb674c52p-53, -0x1.d321d11721ad6p-1, 0x1.91063c4bb7e38p-2, -0x1.b1d863a90075fp-3,
     0x1.0b04bbac5f787p-3, -0x1.615a9e3cdf849p-4, 0x1.e971ba3089bfp-5, -0x1.5db9fccf7c97ap-5, 0x1.ff4140146f4e4p-6,
     -0x1.7e528a1f2b0d5p-6, 0x1.2031e5730ad59p-6}, /* [401] 1.125 <= y <= 1.25 2^-3, degree 10, 60.0 bits */
    {0x1.423ee367df25ap+2, 0x1.e78de20e76573p-53, -0x1.a59d917268a7ep-1, 0x1.4aab2824a9f2fp-2, -0x1.43d039ae76608p-3,
     0x1.68766b706964bp-4, -0x1.af54c54d0331ep-5, 0x1.0e237e1063decp-5, -0x1.5d226b5324ecep-6, 0x1.cd9dc9c505029p-7,
     -0x1.37e966d0327f2p-7, 0x1.a955e33e8db75p-8}, /* [402] 1.25 <= y <= 1.375 2^-3, degree 10, 62.6 bits */
    {0x1.3bf65c887d4fp+2, 0x1.3819b2c3f24f3p-52, -0x1.7fc132ff6cc02p-1, 0x1.1575bda7c32a2p-2, -0x1.f079b2670b5d2p-4,
     0x1.f86f4543c7d7ap-5, -0x1.136bf3b833037p-5, 0x1.3ad80b119125p-6, -0x1.7362681bb1599p-7, 0x1.c0301d65c6092p-8,
     -0x1.1436e53f8862fp-8, 0x1.57d0ec293b6d9p-9}, /* [403] 1.375 <= y <= 1.5 2^-3, degree 10, 60.8 bits */
    {0x1.36390f420e217p+2, -0x1.8dac8503993b2p-52, -0x1.5fc118518f4d8p-1, 0x1.d8706e32d7effp-3, -0x1.8529c4a7e5cbdp-4,
     0x1.6baf74805d747p-5, -0x1.6d36e3a4addb8p-6, 0x1.7fee0b26e1a36p-7, -0x1.a07f4a26cf853p-8, 0x1.ce47217f2692ep-9,
     -0x1.05e1e6baf744dp-9, 0x1.2bd3a5771ec4fp-10}, /* [404] 1.5 <= y <= 1.625 2^-3, degree 10, 62.8 bits */
    {0x1.30f239637874cp+2, 0x1.e96c8d1c7194dp-53, -0x1.4457a87a11c9ap-1, 0x1.972efe64e5872p-3, -0x1.36d55db968c88p-4,
     0x1.0cee39148a7f2p-5, -0x1.f3ed44fa55c8cp-7, 0x1.e66ed1a326c04p-8, -0x1.e871d734aec06p-9, 0x1.f5d4fa62a46a5p-10,
     -0x1.070b63cb778e1p-10, 0x1.16c97cbc1e4f2p-11}, /* [405] 1.625 <= y <= 1.75 2^-3, degree 10, 62.8 bits */
    {0x1.2c1172bd17215p+2, 0x1.c33400431ea12p-55, -0x1.2c97a143c2257p-1, 0x1.62a57107e9d47p-3, -0x1.f897618044dafp-5,
     0x1.9671028ce5ba3p-6, -0x1.5f9c6ebfc6255p-7, 0x1.3e6ad7ad6c40cp-8, -0x1.2997a9008e566p-9, 0x1.1c962bd25aab8p-10,
     -0x1.1599933a3af9fp-11, 0x1.11dd9c7de1123p-12}, /* [406] 1.75 <= y <= 1.875 2^-3, degree 10, 60.8 bits */
    {0x1.278988690929fp+2, 0x1.f79674f47b4e4p-52, -0x1.17cff03d3f273p-1, 0x1.37b5514d9c43ap-3, -0x1.9f4e56d566424p-5,
     0x1.38f37ece64ad4p-6, -0x1.fa65fc5ef18d3p-8, 0x1.acdf970c79d98p-9, -0x1.76dbcdf491a0bp-10, 0x1.4f43c26bb6976p-11,
     -0x1.31c6a295e2477p-12, 0x1.1a251c905363p-13}, /* [407] 1.875 <= y <= 2 2^-3, degree 10, 61.6 bits */
    {0x1.214d362d8072dp+2, -0x1.777733cde60bap-52, -0x1.fa2ef0c5aab22p-1, 0x1.04a032d8e7cf8p-1, -0x1.3d1da92577cf4p-2,
     0x1.b3d3ff8ff489ep-3, -0x1.4167108ccc24ap-3, 0x1.f02946adee28p-4, -0x1.8b3f8bb29f04fp-4, 0x1.4232a54f80eccp-4,
     -0x1.0d2a60dfbdea5p-4, 0x1.c4d299807682cp-5}, /* [408] 1 <= y <= 1.125 2^-2, degree 10, 59.9 bits */
    {0x1.19dda92d6cd2bp+2, -0x1.e5f239a35181dp-52, -0x1.bfb22d47c861cp-1, 0x1.a405b981ff881p-2, -0x1.ca4bf984a2cf5p-3,
     0x1.19e6f1058289ep-3, -0x1.73e9f7ff310ddp-4, 0x1.00bc734feb47ep-4, -0x1.6dd1e5048c1cep-5, 0x1.0ab605b0ea79ap-5,
     -0x1.8e00566ae38b3p-6, 0x1.2ae7a5ba71ebfp-6}, /* [409] 1.125 <= y <= 1.25 2^-2, degree 10, 59.9 bits */
    {0x1.13413af6b85afp+2, -0x1.932d153b01bcfp-53, -0x1.901090d19580ap-1, 0x1.59b2e5a0f7982p-2, -0x1.5611910e9487ep-3,
     0x1.7cfa2aa8f0b25p-4, -0x1.c6b3af45f658dp-5, 0x1.1be4297b5b10bp-5, -0x1.6dd982c803a26p-6, 0x1.e27ae026e12a1p-7,
     -0x1.454612c8496ddp-7, 0x1.baafa7eec58ffp-8}, /* [410] 1.25 <= y <= 1.375 2^-2, degree 10, 60.2 bits */
    {0x1.0d5265cdb3d08p+2, 0x1.3f5e535f18593p-52, -0x1.6885492651516p-1, 0x1.217f2ac23235p-2, -0x1.0628a3e85b31dp-3,
     0x1.0acb23a4063eap-4, -0x1.22bcddc8a86ddp-5, 0x1.4b61fddf6a1ccp-6, -0x1.85cadb9114affp-7, 0x1.d534b5f307b3cp-8,
     -0x1.208311d99723bp-8, 0x1.6668ba8a5db8cp-9}, /* [411] 1.375 <= y <= 1.5 2^-2, degree 10, 61.4 bits */
    {0x1.07f4d6463f321p+2, -0x1.552b667f8d6c6p-53, -0x1.472a662cffff6p-1, 0x1.ebe86557b8806p-3, -0x1.9ac516f59f63bp-4,
     0x1.80edacc7b6d56p-5, -0x1.81f84113c21e6p-6, 0x1.94a70e8fb92d5p-7, -0x1.b5c8302c249ecp-8, 0x1.e4ae00ba6b571p-9,
     -0x1.11f361600a93p-9, 0x1.3903ac9dbacc1p-10}, /* [412] 1.5 <= y <= 1.625 2^-2, degree 10, 60.8 bits */
    {0x1.0312a1792f3fbp+2, 0x1.b45415eb9a6e1p-53, -0x1.2aa7685da3319p-1, 0x1.a70d6fbb585bbp-3, -0x1.47d96a18afcbcp-4,
     0x1.1cbdc1ed758ccp-5, -0x1.086d9aba4573ep-6, 0x1.00a81fbe64f03p-7, -0x1.010b9ca3ccf9cp-8, 0x1.076ff8bc3e52dp-9,
     -0x1.138c50df2278fp-10, 0x1.23735c6c0f696p-11}, /* [413] 1.625 <= y <= 1.75 2^-2, degree 10, 60.8 bits */
    {0x1.fd34eeefd5978p+1, 0x1.55a39cda3b11dp-53, -0x1.120128019efb8p-1, 0x1.6fa9acf134da5p-3, -0x1.09dd4c72be46bp-4,
     0x1.ae66fc1d5c6dcp-6, -0x1.7443a41a37d08p-7, 0x1.50604a801f43cp-8, -0x1.3998f5d352d28p-9, 0x1.2b2ae69f7c6d4p-10,
     -0x1.232bb048480eep-11, 0x1.1eacd0f1f1e86p-12}, /* [414] 1.75 <= y <= 1.875 2^-2, degree 10, 60.5 bits */
    {0x1.f4fcdbb1e7769p+1, 0x1.01bd7a0045fbcp-55, -0x1.f8f84d058ccc1p-2, 0x1.42702a9f63656p-3, -0x1.b52e265a8715p-5,
     0x1.4b63322f1f33ep-6, -0x1.0c41302fcda55p-7, 0x1.c57e35adcec11p-9, -0x1.8b74662ca1dc7p-10, 0x1.60dae80d44df4p-11,
     -0x1.411c0a6ea9303p-12, 0x1.27b2dbc4d64a8p-13} /* [415] 1.875 <= y <= 2 2^-2, degree 10, 62.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_below_duration_zero_overlap)

/* duration at zero force, beta < 1/8: 5 rows of degree 10 in y = (beta)^(1/3), nodes 0 + i 0.125, 0 <= y <= 0.5625.
 * Relative error of the approximation: 2^-58.5 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_FORCE_STEP 0.125
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_FORCE_PER_UNIT 8.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_FORCE_ROWS 5
#define COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_FORCE_END 0.125
COR_ROWS(double, cor_rows_hertz_dashpot_near_duration_zero_force, 5, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be991a8f0b41p+1, 0x1.5d0edcf4822dfp-54, 0x1.25a616bd51b91p-62, -0x1.0000000000004p+0, 0x1.2691b13f86d4cp-1,
     -0x1.7cd7e7e794664p-34, -0x1.311eca68370edp-1, 0x1.d7e53ac018313p-2, -0x1.d37486674b8f8p-7, -0x1.2367d6062670dp-2,
     0x1.2a49da12d1c48p-2, -0x1.1c56b678ed261p-4}, /* [0] 0 <= y <= 0.0625, degree 10, 62.9 bits */
    {0x1.9a0dd9e059ed4p+1, 0x1.5fa3eba5ad15dp-54, -0x1.ca16885341feap-3, -0x1.96a6514fbb6f6p-1, 0x1.ffb0aacef8726p-2,
     -0x1.13b0f08119c06p-2, -0x1.1c650e7a37dd2p-2, 0x1.7883a0dd8dc7p-2, -0x1.3b8c5e4d9feafp-3, -0x1.3c7fe7b270c7cp-6,
     0x1.4f317d643505ap-3, -0x1.06b3d8b0621bbp-3}, /* [1] 0.0625 <= y <= 0.1875, degree 10, 61.5 bits */
    {0x1.95009e3426ebp+1, -0x1.369e33526b93cp-55, -0x1.9ad1d3e532226p-2, -0x1.45c4df2626524p-1, 0x1.56c79cdb52675p-2,
     -0x1.77c656c4c1d15p-2, -0x1.9e305d877ee05p-5, 0x1.f591e9069151cp-3, -0x1.c292e6e3a5c6p-4, 0x1.4c306b897bf79p-4,
     0x1.88dd8d3f1040bp-6, -0x1.6f3932eff506fp-4}, /* [2] 0.1875 <= y <= 0.3125, degree 10, 59.1 bits */
    {0x1.8d62097142f46p+1, -0x1.1c0130c9e8de6p-53, -0x1.184bc899d6002p-1, -0x1.1730b38f1ac08p-1, 0x1.378fff4e83f76p-3,
     -0x1.639ca5a62c048p-2, 0x1.b21ff8d49a7cep-4, 0x1.788079b1a4107p-3, -0x1.18d391756b749p-5, 0x1.b7b63f301953dp-5,
     -0x1.0bdcfc44040dfp-4, -0x1.cb2258872b886p-5}, /* [3] 0.3125 <= y <= 0.4375, degree 10, 59.5 bits */
    {0x1.838f90a6325bap+1, 0x1.9b730f6636da3p-54, -0x1.5bbf9c8c875efp-1, -0x1.0941449840b8ep-1, 0x1.07335cab878b8p-9,
     -0x1.ead6b3b43e6a9p-3, 0x1.e37f55194d5ddp-3, 0x1.4ff4f13fefc2p-3, -0x1.d3b4865e51237p-6, -0x1.9e1d9e9372408p-5,
     -0x1.baeacb7d78126p-4, -0x1.02152be83c744p-9} /* [4] 0.4375 <= y <= 0.5625, degree 10, 58.5 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_duration_zero_force)

/* duration at zero force, 2^-3 <= beta < 8: 48 rows of degree 10 in y = beta 2^-k, 8 to each octave k = -3 ... 2.
 * Relative error of the approximation: 2^-59.2 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_FORCE_FIRST 0.125
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_FORCE_FIRST_OCTAVE (-3)
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_FORCE_ROWS 48
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_FORCE_END 8.0
COR_ROWS(double, cor_rows_hertz_dashpot_middle_duration_zero_force, 48, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.82aaa206dbbeep+1, -0x1.5a752ab82a557p-53, -0x1.c43b92354b4fcp-4, 0x1.5dff9da72299cp-6, -0x1.4187ebc05b4fep-7,
     0x1.6dcca4651c7f7p-8, -0x1.d1fe9bfacb657p-9, 0x1.3f67ac54995c4p-9, -0x1.cc8611b8f6d06p-10, 0x1.5867fed56bd9ep-10,
     -0x1.0a7965665908bp-10, 0x1.a2f39ef11a17p-11}, /* [0] 1 <= y <= 1.125 2^-3, degree 10, 62.4 bits */
    {0x1.80f0c04554dd6p+1, 0x1.c8fcc2ecb2fb9p-53, -0x1.b0144b3e71c3cp-4, 0x1.2946e9871a44ap-6, -0x1.eb2f549cd4b42p-8,
     0x1.f5fa4d5fb423ep-9, -0x1.1e8f36d5236a1p-9, 0x1.5fccbebdeb42bp-10, -0x1.c61b771542c99p-11, 0x1.2ffc3065f3da1p-11,
     -0x1.a47ea512d358ap-12, 0x1.27d07ebb71c3p-12}, /* [1] 1.125 <= y <= 1.25 2^-3, degree 10, 63.1 bits */
    {0x1.7f4982b85bee5p+1, -0x1.b28b3c19df92dp-53, -0x1.9ed3709b10b3ep-4, 0x1.007bd3d7245a5p-6, -0x1.8111e564cd09fp-8,
     0x1.6577a9e06669ep-9, -0x1.71e12b82f0e5ep-10, 0x1.9b3664058d48ep-11, -0x1.e086b9aa2eacep-12, 0x1.232779a56cbabp-12,
     -0x1.6c2c82c479216p-13, 0x1.cfaeb4f9015a7p-14}, /* [2] 1.25 <= y <= 1.375 2^-3, degree 10, 66.4 bits */
    {0x1.7db2582149c32p+1, -0x1.53d1dcf705673p-57, -0x1.8fd7d421678fap-4, 0x1.c053c94deb8fep-7, -0x1.345f54bc98e41p-8,
     0x1.0669dcf6f726fp-9, -0x1.f0aacc8bbcd98p-11, 0x1.f89a83058e1ap-12, -0x1.0d59007a77e8dp-12, 0x1.2a23381ddf701p-13,
     -0x1.545b13d89a1f1p-14, 0x1.8bc1943777927p-15}, /* [3] 1.375 <= y <= 1.5 2^-3, degree 10, 63.9 bits */
    {0x1.7c293863bcb69p+1, 0x1.c45968d1aa202p-53, -0x1.82ad373111e13p-4, 0x1.8c1ab41a5d6b1p-7, -0x1.f6bbeee8e4a4p-9,
     0x1.8b257180617c7p-10, -0x1.589dbd89f8042p-11, 0x1.42660cde7d569p-12, -0x1.3cd3a078b0429p-13,
     0x1.42c41074be5fep-14, -0x1.52eb89807b377p-15, 0x1.6aa32523c9efdp-16},
     /* [4] 1.5 <= y <= 1.625 2^-3, degree 10, 64.3 bits */
    {0x1.7aac7fad74ebfp+1, -0x1.7ab73c85577e7p-54, -0x1.76fd582687241p-4, 0x1.613787180a449p-7, -0x1.9ffd08dc1dc1ep-9,
     0x1.2ff1f9c4e2072p-10, -0x1.ebbb79fb877e8p-12, 0x1.aa5462bedd373p-13, -0x1.84257c62b5a63p-14,
     0x1.6e4727ac13d81p-15, -0x1.6414d10b5bc5dp-16, 0x1.60da77b2c76f7p-17},
     /* [5] 1.625 <= y <= 1.75 2^-3, degree 10, 63.4 bits */
    {0x1.793ad5768550cp+1, -0x1.8204e07cdcf61p-57, -0x1.6c86ab8d0036fp-4, 0x1.3d8097903e0dep-7, -0x1.5ca8fc2df23c8p-9,
     0x1.dc3d7da2af44p-11, -0x1.674c60c6d9ad7p-12, 0x1.2248191e80e9p-13, -0x1.ec63980245c53p-15, 0x1.b0c6141b7b1e6p-16,
     -0x1.87b2b70e98c55p-17, 0x1.69767885b745ep-18}, /* [6] 1.75 <= y <= 1.875 2^-3, degree 10, 64.2 bits */
    {0x1.77d31aff13753p+1, -0x1.65405e0409857p-53, -0x1.63165f18a0a87p-4, 0x1.1f66ed83706cfp-7, -0x1.277fd4a7e3bf2p-9,
     0x1.7b12fb336445ep-11, -0x1.0c0441c6e40eap-12, 0x1.957be9f2a632bp-14, -0x1.41e444323b852p-15,
     0x1.08c51ed8dc1dap-16, -0x1.c05f3280a205dp-18, 0x1.83253f9d4f92ep-19},
     /* [7] 1.875 <= y <= 2 2^-3, degree 10, 63.0 bits */
    {0x1.75c81e6d1c441p+1, 0x1.1766dd4d91274p-55, -0x1.568469201a671p-3, 0x1.f4b1357dcf4eep-6, -0x1.d572b754e6c16p-7,
     0x1.14278977bd8b8p-7, -0x1.6503d4dcd0a0cp-8, 0x1.ed1f2d62851b8p-9, -0x1.65362ce9aa298p-9, 0x1.0c0d6c26d8f15p-9,
     -0x1.9fda826411aa3p-10, 0x1.478a583a1cbf9p-10}, /* [8] 1 <= y <= 1.125 2^-2, degree 10, 61.6 bits */
    {0x1.7329e064e5bcbp+1, -0x1.8c4bcdd39824p-53, -0x1.481f9972def5p-3, 0x1.a8128fb75c45fp-6, -0x1.631c30c8cad58p-7,
     0x1.78b3c3c44ce7ep-8, -0x1.b561e201a438fp-9, 0x1.0ebf4c5071a24p-9, -0x1.5f584718c1321p-10, 0x1.d827fbc69379dp-11,
     -0x1.477afd1438f16p-11, 0x1.cdc10f0a2c785p-12}, /* [9] 1.125 <= y <= 1.25 2^-2, degree 10, 62.3 bits */
    {0x1.70a63b32fa49cp+1, -0x1.117dba52ed285p-55, -0x1.3bd3c33617142p-3, 0x1.6d5c9d13c5e27p-6, -0x1.13b4d969701e6p-7,
     0x1.0a9db91822587p-8, -0x1.192e70b023492p-9, 0x1.3b86cbffd900dp-10, -0x1.72db6517d8546p-11, 0x1.c340e18fc4131p-12,
     -0x1.1b14bcd260961p-12, 0x1.6948b4d09797ep-13}, /* [10] 1.25 <= y <= 1.375 2^-2, degree 10, 64.0 bits */
    {0x1.6e397c889072dp+1, 0x1.30ee269cc829dp-54, -0x1.3128404f86455p-3, 0x1.3f4b6c9f05e72p-6, -0x1.b558038a39efp-8,
     0x1.84f9e30d703e7p-9, -0x1.7817203358e53p-10, 0x1.820aa9818cc43p-11, -0x1.9eb94ce26f125p-12, 0x1.cd177e4336ef2p-13,
     -0x1.0811f8c224aaap-13, 0x1.33d79dc68bf8dp-14}, /* [11] 1.375 <= y <= 1.5 2^-2, degree 10, 62.1 bits */
    {0x1.6be0bec8de76p+1, 0x1.85ce9c0924fcep-54, -0x1.27c69862f279ep-3, 0x1.1a6ee8f7e03a5p-6, -0x1.611ae6aabf354p-8,
     0x1.22f5b8d7e8f1dp-9, -0x1.03ec649834c3dp-10, 0x1.ebd967992ab5p-12, -0x1.e6a3334297afp-13, 0x1.f2208d72e7e52p-14,
     -0x1.06778f4e27fa7p-14, 0x1.199ca6ab41959p-15}, /* [12] 1.5 <= y <= 1.625 2^-2, degree 10, 62.4 bits */
    {0x1.6999b11720f4fp+1, -0x1.a1e4d51ec5feep-53, -0x1.1f6f0b36fbba7p-3, 0x1.f8e557e7a5904p-7, -0x1.216f775129029p-8,
     0x1.bc9aa5114a3e8p-10, -0x1.7166297ea3764p-11, 0x1.44416dfd682bap-12, -0x1.295efb3ea3964p-13,
     0x1.1a0c6cc15facap-14, -0x1.133f8537301b3p-15, 0x1.118f445562732p-16},
     /* [13] 1.625 <= y <= 1.75 2^-2, degree 10, 62.7 bits */
    {0x1.67627187a2b77p+1, 0x1.d81fe7b7b8128p-54, -0x1.17f17989c5661p-3, 0x1.c76b9c9d04a26p-7, -0x1.e0b610c63fce7p-9,
     0x1.59e5863296236p-10, -0x1.0ccf5cc353a1ep-11, 0x1.b847ed5a797c2p-13, -0x1.7855029efc4fep-14,
     0x1.4c8fe50be7b1fp-15, -0x1.2e39c2cfdd866p-16, 0x1.17c621228a8e4p-17},
     /* [14] 1.75 <= y <= 1.875 2^-2, degree 10, 64.1 bits */
    {0x1.653972c012a62p+1, -0x1.e946a9d2a091dp-53, -0x1.1128d4c9c2fdp-3, 0x1.9e1a3adb914bbp-7, -0x1.93c13d6cfe48ep-9,
     0x1.11587486424eap-10, -0x1.8f5bb5522cbcbp-12, 0x1.329da7c231021p-13, -0x1.eae06f473b6dep-15,
     0x1.9615e452a4731p-16, -0x1.595335e21c326p-17, 0x1.2b2b7cc15aca7p-18},
     /* [15] 1.875 <= y <= 2 2^-2, degree 10, 63.4 bits */
    {0x1.6213e6f708084p+1, 0x1.81d10b1a748d3p-53, -0x1.0811459323c08p-2, 0x1.6bca1ca5e24d3p-5, -0x1.3c919b7c58c45p-6,
     0x1.89cbcf69750b3p-7, -0x1.084274c5d371p-7, 0x1.734354cbcaffp-8, -0x1.0f69a9e3bcce4p-8, 0x1.99de28e11e614p-9,
     -0x1.3f6d03c56b904p-9, 0x1.f90214dbb3e53p-10}, /* [16] 1 <= y <= 1.125 2^-1, degree 10, 61.1 bits */
    {0x1.5e0938a7aa993p+1, -0x1.4ba831d8b16c3p-55, -0x1.fb1435c46c5f4p-3, 0x1.3885d3b214a35p-5, -0x1.d7491ce308c0ep-7,
     0x1.085a8de3b2608p-7, -0x1.40c8cdc8c9ec3p-8, 0x1.954aca171b402p-9, -0x1.09b90862d141ep-9, 0x1.678902cb3ad55p-10,
     -0x1.f54d5ebe91dc5p-11, 0x1.62d5f35a52877p-11}, /* [17] 1.125 <= y <= 1.25 2^-1, degree 10, 61.3 bits */
    {0x1.5a25bc511916dp+1, -0x1.ce071f061a8d4p-54, -0x1.e8cf20a57b246p-3, 0x1.11d5e76b619b3p-5, -0x1.68b638107ef4dp-7,
     0x1.6ff512019fa53p-8, -0x1.9861e998aebc3p-9, 0x1.d57bacbb614a2p-10, -0x1.17333afef2b91p-10, 0x1.564531788cae2p-11,
     -0x1.afd214794df04p-12, 0x1.14c160fe57e49p-12}, /* [18] 1.25 <= y <= 1.375 2^-1, degree 10, 62.2 bits */
    {0x1.566491d448e99p+1, 0x1.667a726c5300ap-53, -0x1.d8ab218111742p-3, 0x1.e7c30ee593a6bp-6, -0x1.1aa5e57d143d2p-7,
     0x1.07b710574cbfap-8, -0x1.0e327ad6162e4p-9, 0x1.1d678e0e8c88cp-10, -0x1.36cef95f149f1p-11, 0x1.5c628ccbca31fp-12,
     -0x1.916f2c4f1530ep-13, 0x1.d62b223804a3p-14}, /* [19] 1.375 <= y <= 1.5 2^-1, degree 10, 62.8 bits */
    {0x1.52c1f415c4779p+1, -0x1.7052eb9783ea8p-57, -0x1.ca31c2fa003d2p-3, 0x1.b858a2b6d8038p-6, -0x1.c40f152143383p-8,
     0x1.835984b88c2c3p-9, -0x1.7125b87ae2603p-10, 0x1.693a23dab02a2p-11, -0x1.6b0b2881ee898p-12, 0x1.76f12bff6d6b6p-13,
     -0x1.8da577d979556p-14, 0x1.acc97e06fe3bcp-15}, /* [20] 1.5 <= y <= 1.625 2^-1, degree 10, 61.7 bits */
    {0x1.4f3ae8078d2eep+1, 0x1.3e5073e5acb85p-53, -0x1.bd0d3fb0c3b23p-3, 0x1.9217a35a9edd1p-6, -0x1.700d9d651e955p-8,
     0x1.22698a53c3777p-9, -0x1.03035a445eb05p-10, 0x1.d8ec8f5796223p-12, -0x1.b9a598bc799c9p-13, 0x1.a7039c90c8648p-14,
     -0x1.9f9f875cbf621p-15, 0x1.9f451d8a90ea1p-16}, /* [21] 1.625 <= y <= 1.75 2^-1, degree 10, 62.0 bits */
    {0x1.4bcd068e42379p+1, 0x1.436da67d74467p-54, -0x1.b0fe0be60998cp-3, 0x1.72b30f7164da8p-6, -0x1.3085537ccc5c7p-8,
     0x1.bb48dceb5c59bp-10, -0x1.73d549d35dc6ap-11, 0x1.3ea19c229beeap-12, -0x1.16235ac533bap-13, 0x1.f0ef91a21fe4dp-15,
     -0x1.c6de755dc0fep-16, 0x1.a76ebbc0d6087p-17}, /* [22] 1.75 <= y <= 1.875 2^-1, degree 10, 61.4 bits */
    {0x1.487657381035ep+1, -0x1.317bfabcdedccp-53, -0x1.a5d425739aa6fp-3, 0x1.5889b984382bp-6, -0x1.ff536091a128ap-9,
     0x1.579ed488f7b1dp-10, -0x1.1027ef338c392p-11, 0x1.b821d9c7efbfdp-13, -0x1.6903ecb5599f8p-14,
     0x1.2e4a112ca9be1p-15, -0x1.03092e9da777dp-16, 0x1.c3756b23e08f2p-18},
     /* [23] 1.875 <= y <= 2 2^-1, degree 10, 67.6 bits */
    {0x1.439c496696163p+1, -0x1.c537b740d8f76p-55, -0x1.9674d3abde6e6p-2, 0x1.389cca70318a6p-4, -0x1.9331db253d7adp-6,
     0x1.e122b37b519b7p-7, -0x1.5f94fae57c275p-7, 0x1.06cbe52a47c88p-7, -0x1.8c16bb68c4934p-8, 0x1.2f6da4cc07a5ap-8,
     -0x1.dcfed8d2b5f98p-9, 0x1.7b6a6ab1e66dfp-9}, /* [24] 1 <= y <= 1.125 2^0, degree 10, 61.6 bits */
    {0x1.3d68120e67969p+1, 0x1.71b45ba7d373ap-53, -0x1.83fe706939d1bp-2, 0x1.17b2faf66c68p-4, -0x1.31fa8492a65ffp-6,
     0x1.37a7554f29b0ap-7, -0x1.9bd19a788c347p-8, 0x1.18c398fda1c0bp-8, -0x1.7f37faa13c1f1p-9, 0x1.0829886fa661ap-9,
     -0x1.74053b36a43aep-10, 0x1.091d0702a94f1p-10}, /* [25] 1.125 <= y <= 1.25 2^0, degree 10, 61.2 bits */
    {0x1.3779eeb097614p+1, -0x1.da885b270828fp-53, -0x1.7357150e498bp-2, 0x1.fc70e6e49c8fep-5, -0x1.e389f8b9d75c8p-7,
     0x1.a492eb0d999c2p-8, -0x1.f82ad9edfca2bp-9, 0x1.3d0b0b8d77cffp-9, -0x1.8d11a68bb1ea1p-10, 0x1.f2dec417dec2fp-11,
     -0x1.3e8aec28edc0ap-11, 0x1.9b5c996952646p-12}, /* [26] 1.25 <= y <= 1.375 2^0, degree 10, 61.9 bits */
    {0x1.31cb73e0b294cp+1, 0x1.2a40d1d41dc03p-54, -0x1.641cdcdc73088p-2, 0x1.d37cdeedd8e1cp-5, -0x1.8b5eb2f505bbcp-7,
     0x1.2652126df60bfp-8, -0x1.3ffc6ccd1bc9p-9, 0x1.7631e4a721509p-10, -0x1.b2b2a7c608ee8p-11, 0x1.f72074336989cp-12,
     -0x1.2654b70749d94p-12, 0x1.5ba675ee3f039p-13}, /* [27] 1.375 <= y <= 1.5 2^0, degree 10, 63.1 bits */
    {0x1.2c577b294f663p+1, -0x1.0c5d7361f7cd5p-54, -0x1.560cbeaa468fdp-2, 0x1.b184e7d478fe6p-5, -0x1.4cab87dab9c18p-7,
     0x1.aa0571674cbep-9, -0x1.a2d9787e92f38p-10, 0x1.c9d505d90730cp-11, -0x1.f1b74e2fef7ccp-12, 0x1.0bd615d682aacp-12,
     -0x1.21ad40011d3b7p-13, 0x1.3b7d9aa70b56fp-14}, /* [28] 1.5 <= y <= 1.625 2^0, degree 10, 60.6 bits */
    {0x1.2719c06d71cb4p+1, 0x1.f6fc14d8c4c17p-53, -0x1.48f7289bf7c06p-2, 0x1.9498885019ba3p-5, -0x1.1e99a6dfce838p-7,
     0x1.3e36baebc6457p-9, -0x1.19a4c5a524f8fp-10, 0x1.20924c06352bdp-11, -0x1.27ab2cf3d2608p-12, 0x1.2a4f6993ade5fp-13,
     -0x1.2c9a9316e8061p-14, 0x1.300ab01fa080fp-15}, /* [29] 1.625 <= y <= 1.75 2^0, degree 10, 61.2 bits */
    {0x1.220ea2bd61f96p+1, -0x1.f5f3f8f73d34p-53, -0x1.3cb936d5d53d2p-2, 0x1.7b6f51b0e2e4cp-5, -0x1.f7620a6ce8d11p-8,
     0x1.e9bc8691de17ap-10, -0x1.843b88e204099p-11, 0x1.75175b51931eep-12, -0x1.6a49b4a126d0ap-13,
     0x1.5910585adcf3ep-14, -0x1.46429c9cdae9cp-15, 0x1.346dab2ba511bp-16},
     /* [30] 1.75 <= y <= 1.875 2^0, degree 10, 60.9 bits */
    {0x1.1d32faa454249p+1, -0x1.c8e60abeb27b8p-56, -0x1.313883c56e902p-2, 0x1.652a36702915ap-5, -0x1.c0ed0e1bf997ep-8,
     0x1.83830633adb5p-10, -0x1.11e2474363e9ap-11, 0x1.ed0d5a191b919p-13, -0x1.c79df30b79d4bp-14, 0x1.9c2034e4d0764p-15,
     -0x1.6fee7bd34f2e2p-16, 0x1.46ff47b810a2fp-17}, /* [31] 1.875 <= y <= 2 2^0, degree 10, 61.3 bits */
    {0x1.163c75191bf6p+1, -0x1.4791f1f7ec05ep-56, -0x1.212e7a40618f5p-1, 0x1.47e7669ca8a72p-3, -0x1.828b010e841d2p-5,
     0x1.1e06f5c2b9f88p-6, -0x1.528fb47f3f39bp-7, 0x1.1284cec69f221p-7, -0x1.d93584b01148dp-8, 0x1.8fd0f9c0d1cfep-8,
     -0x1.4c898d77335bap-8, 0x1.10163e70bd31fp-8}, /* [32] 1 <= y <= 1.125 2^1, degree 10, 61.0 bits */
    {0x1.0d8217646eca7p+1, 0x1.99171fd8bd377p-56, -0x1.0dc18527f4295p-1, 0x1.26a89c5631a28p-3, -0x1.46031075900f2p-5,
     0x1.9b7e744be19fep-7, -0x1.814d9c1784fa4p-8, 0x1.0af888360d2a5p-8, -0x1.a4391a4320bbap-9, 0x1.4855756834529p-9,
     -0x1.f548f3623dc73p-10, 0x1.7550a33dd5b01p-10}, /* [33] 1.125 <= y <= 1.25 2^1, degree 10, 60.4 bits */
    {0x1.055b41b11f04ep+1, 0x1.3184da308238p-53, -0x1.f87ef83379f09p-2, 0x1.0a4c3ad7e0704p-3, -0x1.18fda984f0465p-5,
     0x1.3c62e770804aap-7, -0x1.de93337c442f4p-9, 0x1.14e0ca86a0f8fp-9, -0x1.8b3f6907df6bap-10, 0x1.200fef79da5c4p-10,
     -0x1.9999885341083p-11, 0x1.1a062f62ce0b6p-11}, /* [34] 1.25 <= y <= 1.375 2^1, degree 10, 60.1 bits */
    {0x1.fb737394f990ep+0, 0x1.4d898a67bc82cp-54, -0x1.d8c83ac171f55p-2, 0x1.e35a7d16ba28p-4, -0x1.eb1077a4a2297p-6,
     0x1.fdf82cba0a97fp-8, -0x1.42ad86d1d198cp-9, 0x1.328b2a9efecb6p-10, -0x1.86a29a137eda2p-11, 0x1.0a2c022a968acp-11,
     -0x1.642be0a7eacefp-12, 0x1.cb4b635835702p-13}, /* [35] 1.375 <= y <= 1.5 2^1, degree 10, 60.3 bits */
    {0x1.ed2250ebda6fep+0, -0x1.fbe49d80ae161p-54, -0x1.bbf3ac0dafea5p-2, 0x1.b81f8585a3856p-4, -0x1.b0f6b7927a06dp-6,
     0x1.a83fed5d9135ap-8, -0x1.d35332a3ff2d1p-10, 0x1.6b9d83496d06bp-11, -0x1.949e9c27493cdp-12, 0x1.00a4661a426d6p-12,
     -0x1.45428d9bd2957p-13, 0x1.8cbac833922c7p-14}, /* [36] 1.5 <= y <= 1.625 2^1, degree 10, 61.8 bits */
    {0x1.dfad732455eacp+0, -0x1.524256005ba11p-54, -0x1.a1a9b4e632c02p-2, 0x1.91e2af775a77ap-4, -0x1.8019abe7d9b34p-6,
     0x1.6864d3c32228fp-8, -0x1.6638f123f3d6fp-10, 0x1.cf3aae6a6fe8ap-12, -0x1.b7f154cee3213p-13, 0x1.00d9ddc4186e7p-13,
     -0x1.3506aae9b0d62p-14, 0x1.673345a540e0ep-15}, /* [37] 1.625 <= y <= 1.75 2^1, degree 10, 63.4 bits */
    {0x1.d301b3cfb184dp+0, -0x1.3c77512871651p-58, -0x1.89a0c4e5fe8d6p-2, 0x1.6fe2738831ea3p-4, -0x1.564af982a6bd9p-6,
     0x1.366357086cabap-8, -0x1.1e6a7d72f59eap-10, 0x1.3c4a09cfea70ep-12, -0x1.f86df29178a7cp-14, 0x1.0a4e87f3fd509p-14,
     -0x1.2f7fd80af81cfp-15, 0x1.51dbbc1352777p-16}, /* [38] 1.75 <= y <= 1.875 2^1, degree 10, 60.1 bits */
    {0x1.c70e0c8b26c64p+0, -0x1.205309bbd9871p-56, -0x1.7399f8cda0105p-2, 0x1.5187b6547c069p-4, -0x1.321d1380f39cbp-6,
     0x1.0dcaf9fbbd966p-8, -0x1.d7c82b5df0c1ap-11, 0x1.cb9c4ae0d45cap-13, -0x1.32a1e85a15fb9p-14, 0x1.1e5e0c8ca8354p-15,
     -0x1.32e477be18287p-16, 0x1.47f3150f242f6p-17}, /* [39] 1.875 <= y <= 2 2^1, degree 10, 59.8 bits */
    {0x1.b658f0f7edf63p+0, -0x1.1f090d4fcad82p-56, -0x1.55debe7681b8dp-1, 0x1.29cfe70a27ac8p-2, -0x1.04485e657c264p-3,
     0x1.ba46dd75568b5p-5, -0x1.6d719cdd1c922p-6, 0x1.3807ac6976088p-7, -0x1.46af51e7b0571p-8, 0x1.e7ee616d04ce4p-9,
     -0x1.d3f2857e48f26p-9, 0x1.d4f5aac3a43a9p-9}, /* [40] 1 <= y <= 1.125 2^2, degree 10, 59.9 bits */
    {0x1.a21562bc3408ap+0, 0x1.f5e4df1c186e9p-54, -0x1.337dacfb11953p-1, 0x1.fb8eb6dc4cc8ep-3, -0x1.a6e66bfd75ff6p-4,
     0x1.57ff106e1af9bp-5, -0x1.0dfa9e6765372p-6, 0x1.a040777196f3p-8, -0x1.5995d2066bf77p-9, 0x1.74cd8ff69d252p-10,
     -0x1.1c01269fd2b5p-10, 0x1.fdca3b579ece3p-11}, /* [41] 1.125 <= y <= 1.25 2^2, degree 10, 61.4 bits */
    {0x1.8fcebc0743799p+0, 0x1.326b0ce314678p-55, -0x1.1616996c516d6p-1, 0x1.b3b621ac47ac3p-3, -0x1.5a83acd339107p-4,
     0x1.0e8452317a96ap-5, -0x1.97ffa4c6bbfb7p-7, 0x1.28da6075605d1p-8, -0x1.b0360899c961bp-10, 0x1.64ae00ef0cacfp-11,
     -0x1.92479cf29b92ap-12, 0x1.2f52823d77563p-12}, /* [42] 1.25 <= y <= 1.375 2^2, degree 10, 59.2 bits */
    {0x1.7f3cda8d1857ep+0, 0x1.0b7e330dacc85p-57, -0x1.f9861fb629d2ep-2, 0x1.789d38d99dc7fp-3, -0x1.1e2eb8b849d24p-4,
     0x1.ad404264d8603p-6, -0x1.384aad3630036p-7, 0x1.b4fced8398b25p-9, -0x1.2881053750fa9p-10, 0x1.9dd2d6d76444dp-12,
     -0x1.5c420b9e2c07cp-13, 0x1.961b006aa08e4p-14}, /* [43] 1.375 <= y <= 1.5 2^2, degree 10, 61.1 bits */
    {0x1.70246d595b2f2p+0, -0x1.1d3d0dbc5c694p-55, -0x1.cd9a426e3b757p-2, 0x1.47a0aa6109d95p-3, -0x1.dc422215585d5p-5,
     0x1.574bef7610c4p-6, -0x1.e27fa129928c7p-8, 0x1.46e129d70fb3fp-9, -0x1.a97516c6303a7p-11, 0x1.0f4f3e8c75bb4p-12,
     -0x1.726b4e5dfb977p-14, 0x1.418d3a36d42e8p-15}, /* [44] 1.5 <= y <= 1.625 2^2, degree 10, 62.3 bits */
    {0x1.62544cc7d113cp+0, 0x1.27972710da69p-54, -0x1.a747e4b5cedb8p-2, 0x1.1eb97e903aef3p-3, -0x1.8f1d03166c171p-5,
     0x1.14a4288f88f36p-6, -0x1.77acd50d2b3d7p-8, 0x1.edf2d4bd1eb2ap-10, -0x1.37e2b2403afffp-11, 0x1.7aefa9182cb15p-13,
     -0x1.cb5ea7501b7a7p-15, 0x1.37cca4f5a66eep-16}, /* [45] 1.625 <= y <= 1.75 2^2, degree 10, 61.6 bits */
    {0x1.55a37044c18e7p+0, 0x1.4a258465a5f53p-54, -0x1.85a68b5989b3ep-2, 0x1.f8aada663c97cp-4, -0x1.50ba0950f839ep-5,
     0x1.c11e0cfed151ep-7, -0x1.26a8946f6ffc1p-8, 0x1.78179719d9c04p-10, -0x1.ce99865a8f8b9p-12, 0x1.10a3cb2dbb1fcp-13,
     -0x1.36e4a85ec653dp-15, 0x1.69d3fdabd17eep-17}, /* [46] 1.75 <= y <= 1.875 2^2, degree 10, 64.0 bits */
    {0x1.49ef59a57c69fp+0, -0x1.f258b7542ee73p-57, -0x1.67fa42541ff2fp-2, 0x1.be747823601e9p-4, -0x1.1de981decad42p-5,
     0x1.6f229663e4ef5p-7, -0x1.d188214ba1de1p-9, 0x1.2059351ed9f47p-10, -0x1.59bf4fb2bee83p-12, 0x1.8e0dec0cf21cdp-14,
     -0x1.b70cbdff96082p-16, 0x1.d7b09c80f33d1p-18} /* [47] 1.875 <= y <= 2 2^2, degree 10, 60.8 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_middle_duration_zero_force)

/* duration at zero force, 2^1 <= ln(beta) < 7: 14 rows of degree 10 in y = ln(beta) 2^-k, 8 to each octave k = 1 ... 2.
 * Relative error of the approximation: 2^-57.7 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_TAIL_DURATION_ZERO_FORCE_FIRST 2.0
#define COR_ROWS_HERTZ_DASHPOT_TAIL_DURATION_ZERO_FORCE_FIRST_OCTAVE 1
#define COR_ROWS_HERTZ_DASHPOT_TAIL_DURATION_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_TAIL_DURATION_ZERO_FORCE_ROWS 14
#define COR_ROWS_HERTZ_DASHPOT_TAIL_DURATION_ZERO_FORCE_END 7.0
COR_ROWS(double, cor_rows_hertz_dashpot_tail_duration_zero_force, 14, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.4b522aa1355bp+3, -0x1.f1025300819cp-53, 0x1.2fbb7eaf54ed3p+3, 0x1.c418fad3b7f72p-1, -0x1.c217d3c882d9ep-1,
     0x1.dd5aba4a7cbc7p-2, 0x1.01cd62cd14b27p-8, -0x1.ab44dbedc5d3dp-3, 0x1.1821e744569b6p-3, 0x1.8a201b14d64cfp-7,
     -0x1.36a9fcc7951e8p-4, 0x1.5ddf706d34d21p-5}, /* [0] 1 <= y <= 1.125 2^1, degree 10, 57.9 bits */
    {0x1.71ad7d5ce0e71p+3, -0x1.55d92bbe8d5ap-51, 0x1.3597e80a01b19p+3, 0x1.3161babedc97fp-1, -0x1.4e03b8bde81f6p-1,
     0x1.b752ef57ae405p-2, -0x1.bbbd9f037b0c4p-4, -0x1.807d228b33fcfp-4, 0x1.dd024c4c55ad2p-4, -0x1.5c8563f49fadcp-5,
     -0x1.75ba5423e6254p-6, 0x1.279f109fb8c7ap-5}, /* [1] 1.125 <= y <= 1.25 2^1, degree 10, 57.9 bits */
    {0x1.98a336c5ae457p+3, 0x1.5e84666f61073p-54, 0x1.397d2e205f45cp+3, 0x1.8efdf29806c48p-2, -0x1.d4843453692f3p-2,
     0x1.62ce5d261af9ap-2, -0x1.2a3dd1654a31p-3, -0x1.9f6627c5c817cp-7, 0x1.17d68f66ce16ap-4, -0x1.888b488d30419p-5,
     0x1.0e3d2f36f1a13p-7, 0x1.c7e40d77c0eabp-7}, /* [2] 1.25 <= y <= 1.375 2^1, degree 10, 59.0 bits */
    {0x1.bffe124284826p+3, 0x1.e77b5fe269d5ep-52, 0x1.3c002f2079fb4p+3, 0x1.fb4840842871fp-3, -0x1.3a6737d3276d6p-2,
     0x1.068c99e31cdc3p-2, -0x1.19d644448afe4p-3, 0x1.cb73d7a78efa1p-6, 0x1.c0156099e6d6ep-6, -0x1.0bb30948591adp-5,
     0x1.01f9b552dc882p-6, -0x1.e308ca06c336ep-16}, /* [3] 1.375 <= y <= 1.5 2^1, degree 10, 57.7 bits */
    {0x1.e7995dc4cab7fp+3, 0x1.419c71650b5e7p-51, 0x1.3d94a5383908dp+3, 0x1.3b715bc8fb804p-3, -0x1.97ad2164e7fc1p-3,
     0x1.6d37f61666c7cp-3, -0x1.c5751f31ed884p-4, 0x1.494856e9986a7p-5, 0x1.9e663f744293ap-9, -0x1.0c61d63580dafp-6,
     0x1.92f277032c309p-7, -0x1.197e330a30087p-8}, /* [4] 1.5 <= y <= 1.625 2^1, degree 10, 60.0 bits */
    {0x1.07ae67590de4bp+4, 0x1.dc3393912f68ep-51, 0x1.3e8e03f2c58a7p+3, 0x1.815aecbb414f6p-4, -0x1.0145abe0193fdp-3,
     0x1.e58831ef3f6efp-4, -0x1.4ba77f84842cfp-4, 0x1.33ec3d38a1e01p-5, -0x1.e05fba73ae169p-8, -0x1.704f277810374p-8,
     0x1.c695c8074e853p-8, -0x1.fd2ad744c3b1dp-9}, /* [5] 1.625 <= y <= 1.75 2^1, degree 10, 59.9 bits */
    {0x1.1b9c67a4ef0bap+4, -0x1.51de0181d0d5ep-50, 0x1.3f25492d5518cp+3, 0x1.cff821bfb7f43p-5, -0x1.3ddf71db34e08p-4,
     0x1.37fbe9619711ep-4, -0x1.c796c65f4ed78p-5, 0x1.e613d30f33c61p-6, -0x1.43b7e6c292b8p-7, -0x1.c21e8c24a4e37p-13,
     0x1.8ad158f6e5e8dp-9, -0x1.37c80cf3e47b5p-9}, /* [6] 1.75 <= y <= 1.875 2^1, degree 10, 60.6 bits */
    {0x1.2f91cf0d94c7ep+4, -0x1.7a73b2ae50ef5p-50, 0x1.3f7fd6aacc877p+3, 0x1.140074aa1102bp-5, -0x1.822432b6372e6p-5,
     0x1.86b48252296a6p-5, -0x1.2b6f8aed6d5eep-5, 0x1.5d3809c35c01dp-6, -0x1.23086eb57760ap-7, 0x1.d9fc2bd4ebfaep-10,
     0x1.c11f9b1382659p-11, -0x1.2eac98f6b3f3p-10}, /* [7] 1.875 <= y <= 2 2^1, degree 10, 59.8 bits */
    {0x1.4d899534cd10dp+4, 0x1.6fa2b5f8d3f42p-51, 0x1.3fc749511a8b5p+4, 0x1.f1810139e18c5p-5, -0x1.649a0615e3bcbp-3,
     0x1.756114572f492p-2, -0x1.2d3a1c9656c55p-1, 0x1.7e8742078c923p-1, -0x1.79d0ff62d3ab9p-1, 0x1.0a7aac4c6dd1ap-1,
     -0x1.2e4949aece038p-3, -0x1.eb32019c015bp-3}, /* [8] 1 <= y <= 1.125 2^2, degree 10, 57.9 bits */
    {0x1.758549f224fcfp+4, -0x1.7b0a633c477cep-50, 0x1.3fed41bcecd58p+4, 0x1.4ef1de9a81723p-6, -0x1.ebb8836e17daep-5,
     0x1.09c423d512c36p-3, -0x1.c07b7137ba6ffp-3, 0x1.30a5585111889p-2, -0x1.50dc4d6c4cbbap-2, 0x1.2b05ea0e89f6bp-2,
     -0x1.8c2df2424647ep-3, 0x1.0e0eb528470c6p-4}, /* [9] 1.125 <= y <= 1.25 2^2, degree 10, 58.6 bits */
    {0x1.9d83e16eee443p+4, -0x1.a14e3e3a6b948p-54, 0x1.3ff9ea44af3d8p+4, 0x1.b9099e17b8103p-8, -0x1.496799dddf345p-6,
     0x1.6c1a09a03b32p-5, -0x1.3c74fae9b6e5cp-4, 0x1.c00e0cac7229ep-4, -0x1.076538b796086p-3, 0x1.0295824be8f8p-3,
     -0x1.a338ac28773e4p-4, 0x1.06e3e855027f3p-4}, /* [10] 1.25 <= y <= 1.375 2^2, degree 10, 57.7 bits */
    {0x1.c5836d1640c2ep+4, 0x1.a3ce7a75da4b9p-50, 0x1.3ffe0d4467ed5p+4, 0x1.1d7d7f1516352p-9, -0x1.b01ef59f03844p-8,
     0x1.e58825681b6d9p-7, -0x1.aeea219c0511dp-6, 0x1.3995da48116cep-5, -0x1.7ef93e6f6ab8ep-5, 0x1.8d82c223b097cp-5,
     -0x1.6112041d466edp-5, 0x1.06390dd51b57fp-5}, /* [11] 1.375 <= y <= 1.5 2^2, degree 10, 58.8 bits */
    {0x1.ed8348030ab0bp+4, -0x1.d3f40f1bdd71p-52, 0x1.3fff62166dcbcp+4, 0x1.6cbc20451a22dp-11, -0x1.16e84392d7337p-9,
     0x1.3d56075be6a97p-8, -0x1.1e09c2b4700eep-7, 0x1.a89154c70381ap-7, -0x1.0a0010b3b763ap-6, 0x1.1defc575e35afp-6,
     -0x1.0b6d80da3cc96p-6, 0x1.ae34ffc63d99bp-7}, /* [12] 1.5 <= y <= 1.625 2^2, degree 10, 60.8 bits */
    {0x1.0ac19e28ae372p+5, -0x1.71bc865dcb258p-49, 0x1.3fffce7402ffbp+4, 0x1.cd08f17c30894p-13, -0x1.6380541f496dep-11,
     0x1.988228b20049cp-10, -0x1.74a3e5e31be56p-9, 0x1.18a4aeee336ddp-8, -0x1.6635fb11732acp-8, 0x1.8a64d318ff732p-8,
     -0x1.7d3c1dc72464bp-8, 0x1.411cccf9ce9ddp-8} /* [13] 1.625 <= y <= 1.75 2^2, degree 10, 66.2 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_tail_duration_zero_force)

/* largest overlap, beta < 1/8: 3 rows of degree 10 in y = beta, nodes 0 + i 0.0625, 0 <= y <= 0.15625.
 * Relative error of the approximation: 2^-59.5 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_MAX_OVERLAP_STEP 0.0625
#define COR_ROWS_HERTZ_DASHPOT_NEAR_MAX_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_MAX_OVERLAP_ROWS 3
#define COR_ROWS_HERTZ_DASHPOT_NEAR_MAX_OVERLAP_END 0.125
COR_ROWS(double, cor_rows_hertz_dashpot_near_max_overlap, 3, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.17e693ae45eacp+0, -0x1.0143224fb2702p-54, -0x1.90540d86ae39fp-1, 0x1.c4a7a68f9598ap-2, -0x1.ac6de4c49be3p-3,
     0x1.59237b03eb6e4p-4, -0x1.d524bbf42158dp-6, 0x1.013c7297684f9p-7, -0x1.86022029db863p-10, 0x1.1e9e44a865a4dp-15,
     0x1.ee3510b0a4e87p-14, -0x1.cb51d1da5ba87p-15}, /* [0] 0 <= y <= 0.03125, degree 10, 60.9 bits */
    {0x1.0bd1d96ed5b9fp+0, -0x1.816236452000ep-56, -0x1.7540643ea52bep-1, 0x1.9e71317c0604bp-2, -0x1.838034e88fba8p-3,
     0x1.3651a683040d4p-4, -0x1.a6e66e8039843p-6, 0x1.d834fa82ed99bp-8, -0x1.7d9a00f90cc84p-10, 0x1.7dd9413dc659ep-14,
     0x1.65827fe2a9993p-14, -0x1.90e436ee85c14p-15}, /* [1] 0.03125 <= y <= 0.09375, degree 10, 59.5 bits */
    {0x1.008c7e9608d26p+0, 0x1.651d1bc90c85cp-56, -0x1.5c727f7869ea6p-1, 0x1.7bde8eba08fbp-2, -0x1.5eb495b3a26f9p-3,
     0x1.16f5693a4b2b4p-4, -0x1.7c9074b69db9fp-6, 0x1.af3a09f4c28dfp-8, -0x1.6ee0961e90745p-10, 0x1.12e9103b6d95ap-13,
     0x1.e2f51e954f529p-15, -0x1.901127b3a3cc5p-15} /* [2] 0.09375 <= y <= 0.15625, degree 10, 60.8 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_max_overlap)

/* largest overlap, 2^-3 <= beta < 8: 48 rows of degree 10 in y = beta 2^-k, 8 to each octave k = -3 ... 2.
 * Relative error of the approximation: 2^-57.3 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_MAX_OVERLAP_FIRST 0.125
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_MAX_OVERLAP_FIRST_OCTAVE (-3)
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_MAX_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_MAX_OVERLAP_ROWS 48
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_MAX_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_hertz_dashpot_middle_max_overlap, 48, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.fe630d2f0188bp-1, 0x1.007210d44b289p-56, -0x1.597eda209631fp-4, 0x1.77c8f350e0817p-8, -0x1.5a60267b21d41p-12,
     0x1.13444aed6f19cp-16, -0x1.778a48ea0f5abp-21, 0x1.aa39c59d1fe61p-26, -0x1.6cafe3be6d956p-31, 0x1.0ba498112b1ap-37,
     -0x1.b8f924328841cp-40, 0x1.cb43f96df73f9p-35}, /* [0] 1 <= y <= 1.125 2^-3, degree 10, 62.2 bits */
    {0x1.f908ba8a511c7p-1, -0x1.667a98439922p-55, -0x1.53afd0a6f5181p-4, 0x1.6fc44686d6b26p-8, -0x1.51e318bbdc1fcp-12,
     0x1.0c075f2e2be68p-16, -0x1.6daab9831d287p-21, 0x1.a050acce1bf41p-26, -0x1.68259eb433761p-31,
     0x1.2aa7a76f16354p-37, 0x1.a370fd809fcf4p-42, 0x1.b92b9daaa20cbp-45},
     /* [1] 1.125 <= y <= 1.25 2^-3, degree 10, 61.1 bits */
    {0x1.f3c5646d0b5d7p-1, -0x1.19ae3a272b169p-56, -0x1.4e0074e9eb925p-4, 0x1.67f1dbe1cbdf3p-8, -0x1.499f2e6e866a2p-12,
     0x1.04fb3d34d30a4p-16, -0x1.64063f7c46d5p-21, 0x1.96883dc326981p-26, -0x1.635ea2a06c201p-31, 0x1.38846edf2120cp-37,
     0x1.728ec8bd98c11p-42, -0x1.a3f10c13549e6p-45}, /* [2] 1.25 <= y <= 1.375 2^-3, degree 10, 61.3 bits */
    {0x1.ee988daec2f02p-1, -0x1.6e5bc1d9a0f01p-57, -0x1.487000887ef87p-4, 0x1.60506116cb594p-8, -0x1.4192e5dd72ed9p-12,
     0x1.fc3d7f104d8e1p-17, -0x1.5a9c12461affdp-21, 0x1.8ce1f9308b479p-26, -0x1.5e63aa87ce1bap-31,
     0x1.44bd12e7a35adp-37, 0x1.45c6aad3930e1p-42, -0x1.554157fdce805p-45},
     /* [3] 1.375 <= y <= 1.5 2^-3, degree 10, 61.5 bits */
    {0x1.e981bc361402ap-1, -0x1.9235c8ad516e1p-59, -0x1.42fdb258f0806p-4, 0x1.58de8cc9bed57p-8, -0x1.39bcc66ed8107p-12,
     0x1.eee1895eebd57p-17, -0x1.516b60c948b7fp-21, 0x1.835f35939232cp-26, -0x1.593ac0f7051e1p-31,
     0x1.4f804dd4dfba6p-37, 0x1.1c9386bdeab75p-42, -0x1.4d279d9e27c6cp-45},
     /* [4] 1.5 <= y <= 1.625 2^-3, degree 10, 60.9 bits */
    {0x1.e48078e40e431p-1, 0x1.d1857af5a1ab1p-57, -0x1.3da8ce456e91ep-4, 0x1.519b1e57286bbp-8, -0x1.321b6084280d2p-12,
     0x1.e1e05eb58b479p-17, -0x1.487352638280ep-21, 0x1.7a01208087af7p-26, -0x1.53e98f732f9b9p-31,
     0x1.58dc84903654ep-37, 0x1.dc23ed23c29fcp-43, -0x1.7496ff6f4bae2p-45},
     /* [5] 1.625 <= y <= 1.75 2^-3, degree 10, 61.9 bits */
    {0x1.df944f802a606p-1, 0x1.e6cd767efc9ep-57, -0x1.38709d299da59p-4, 0x1.4a84dd9ea425p-8, -0x1.2aad4d583ab03p-12,
     0x1.d537cd0c5d3fep-17, -0x1.3fb307d61eb23p-21, 0x1.70c8be4f83192p-26, -0x1.4e74a4b5718e4p-31,
     0x1.7ac8e4cc42042p-37, -0x1.7ca6df67ce1d7p-42, -0x1.5643708d4e55ap-34},
     /* [6] 1.75 <= y <= 1.875 2^-3, degree 10, 61.1 bits */
    {0x1.dabccea4c7bddp-1, -0x1.f2ed12c705833p-55, -0x1.33546cb0f5839p-4, 0x1.439a9ace37bbfp-8, -0x1.23712edc6e716p-12,
     0x1.c8e5ab31693ecp-17, -0x1.37299c2534504p-21, 0x1.67b6f9c739859p-26, -0x1.48e36ac545992p-31,
     0x1.67d214c488631p-37, 0x1.6810e2686117p-43, 0x1.fbdcd3dd2fb42p-48},
     /* [7] 1.875 <= y <= 2 2^-3, degree 10, 65.4 bits */
    {0x1.d39f580d0fe64p-1, -0x1.7db5411d9e857p-55, -0x1.2bdd2a93c4c6ep-3, 0x1.398b2df234198p-6, -0x1.18f1c33d28565p-9,
     0x1.b707e63ad90e8p-13, -0x1.2ac05bad7293cp-16, 0x1.5a6649e392397p-20, -0x1.405a6f3a5881bp-24,
     0x1.7012a06e23a83p-29, 0x1.0aa868c109727p-34, -0x1.7c37519d51085p-36},
     /* [8] 1 <= y <= 1.125 2^-2, degree 10, 60.1 bits */
    {0x1.ca671557b60cp-1, 0x1.105b09e61aa76p-56, -0x1.2244a5d7af6d8p-3, 0x1.2cb0b9dbfeb7ap-6, -0x1.0b9534978c487p-9,
     0x1.a0508890087fbp-13, -0x1.1aeb69f37486fp-16, 0x1.493278121210cp-20, -0x1.34b9ac9d18c13p-24,
     0x1.777b0b01e204bp-29, 0x1.3b61977e06b1ep-35, -0x1.43c1e536009bep-36},
     /* [9] 1.125 <= y <= 1.25 2^-2, degree 10, 60.1 bits */
    {0x1.c17a021188d5fp-1, -0x1.5fe402babb523p-57, -0x1.19107e960dbedp-3, 0x1.20726d9e22ed2p-6, -0x1.fdd30742e82c6p-10,
     0x1.8acdd70a33c6cp-13, -0x1.0be10fa427f4cp-16, 0x1.38a2cadc4be58p-20, -0x1.28ec3cc162fcep-24,
     0x1.7b53e23f56af9p-29, 0x1.fd28d3b783345p-37, -0x1.16dccbcd57dd3p-36},
     /* [10] 1.25 <= y <= 1.375 2^-2, degree 10, 59.8 bits */
    {0x1.b8d50e7c7261p-1, 0x1.b975634532296p-55, -0x1.103bf4214e639p-3, 0x1.14c837b9d9632p-6, -0x1.e5ca92f660a8dp-10,
     0x1.76704b18c6be3p-13, -0x1.fb331ec151d19p-17, 0x1.28b8f5bd3ec01p-20, -0x1.1d0c9ba40e9cbp-24,
     0x1.7c1b6d5c47eabp-29, -0x1.109fd6b19b301p-38, -0x1.dcdf8757c793cp-37},
     /* [11] 1.375 <= y <= 1.5 2^-2, degree 10, 60.4 bits */
    {0x1.b0754fe23d847p-1, -0x1.e80cf7cf8147dp-55, -0x1.07c2849c3c34dp-3, 0x1.09aa74a34de87p-6, -0x1.ceff321971617p-10,
     0x1.6328f98ae78d1p-13, -0x1.e01a3f4a2a8aep-17, 0x1.1975542c96012p-20, -0x1.113181c5f5b85p-24,
     0x1.7a444554a049ep-29, -0x1.575ea5c783984p-36, -0x1.a17ebb8e078b6p-37},
     /* [12] 1.5 <= y <= 1.625 2^-2, degree 10, 59.8 bits */
    {0x1.a857feab9505ep-1, -0x1.b28a76c27a55ap-57, -0x1.ff3fd341dc95ep-4, 0x1.fe23d252dfb45p-7, -0x1.b95ff45100debp-10,
     0x1.50e992e920edfp-13, -0x1.c667f36db6782p-17, 0x1.0ad71bbece9aep-20, -0x1.056e42472fac7p-24,
     0x1.7633a6ab191f6p-29, -0x1.2010107c87b9dp-35, -0x1.8ee8cd7ce1e56p-39},
     /* [13] 1.625 <= y <= 1.75 2^-2, degree 10, 61.3 bits */
    {0x1.a07a74911ab6cp-1, -0x1.3b48cb996ec1dp-56, -0x1.efa02a272013ep-4, 0x1.e9ef7a303eea8p-7, -0x1.a4dcc95fd5f5ap-10,
     0x1.3fa462bb2437cp-13, -0x1.ae0cccaf2a163p-17, 0x1.f9b9129bd4975p-21, -0x1.f3a640522636fp-25,
     0x1.704b37053d106p-29, -0x1.7eddb577e42bbp-35, -0x1.164d4125fb66ep-37},
     /* [14] 1.75 <= y <= 1.875 2^-2, degree 10, 61.7 bits */
    {0x1.98da2ae53f02ep-1, 0x1.beca2926d57dp-55, -0x1.e09e5c3e5e28p-4, 0x1.d6aaec28e7165p-7, -0x1.91667782a69d4p-10,
     0x1.2f4c4de40066fp-13, -0x1.96f990ec7246cp-17, 0x1.df0612f428d33p-21, -0x1.dcdb49af5a02ap-25,
     0x1.68d888d57b95ep-29, -0x1.cdaac166b2c2p-35, -0x1.c55fa42f1fa15p-38},
     /* [15] 1.875 <= y <= 2 2^-2, degree 10, 61.0 bits */
    {0x1.8dd757fe2b597p-1, -0x1.38a03b8fb5214p-55, -0x1.cb33c49002a99p-3, 0x1.bb6b0e29c5224p-5, -0x1.760dbb7a31dd2p-7,
     0x1.18698954ed377p-9, -0x1.76a2f100a5ab4p-12, 0x1.b94715345692dp-15, -0x1.bba36c9577cadp-18, 0x1.5b69f9fbeb96p-21,
     -0x1.13ca9c1ccb9e3p-25, -0x1.401db409fcb2dp-28}, /* [16] 1 <= y <= 1.125 2^-1, degree 10, 59.9 bits */
    {0x1.7fe9b9ac61083p-1, -0x1.52680994703b6p-56, -0x1.b08d13f232da8p-3, 0x1.99f025b6b461ap-5, -0x1.54c4102a82ff7p-7,
     0x1.f9676a6d0dc5ap-10, -0x1.4f77d3e11061bp-12, 0x1.8b1566ef4989fp-15, -0x1.917d1bf1bad78p-18,
     0x1.4687fd40f2463p-21, -0x1.3a48ebd22af4p-25, -0x1.6602654fda933p-29},
     /* [17] 1.125 <= y <= 1.25 2^-1, degree 10, 60.4 bits */
    {0x1.72c93306ff0b9p-1, -0x1.20300f46828efp-58, -0x1.97e5f24d0fca6p-3, 0x1.7b6c11a72a67ap-5, -0x1.36c1ec09d384ep-7,
     0x1.c7c6b78498226p-10, -0x1.2c6b3997960f9p-12, 0x1.615a00f55405cp-15, -0x1.6a1697296c94ap-18, 0x1.2fa6c504d32cp-21,
     -0x1.4d9341c494766p-25, -0x1.248be1650accfp-30}, /* [18] 1.25 <= y <= 1.375 2^-1, degree 10, 62.1 bits */
    {0x1.66667ee99ef66p-1, 0x1.53be70d72889p-55, -0x1.811151756472ep-3, 0x1.5f944d5db2bp-5, -0x1.1baf9a0b2653bp-7,
     0x1.9b54623698102p-10, -0x1.0d15be97a841ep-12, 0x1.3bc5260258581p-15, -0x1.459c236ca22cap-18, 0x1.17f18fcfb5cbp-21,
     -0x1.52a25fbff0b87p-25, 0x1.f903087261d76p-35}, /* [19] 1.375 <= y <= 1.5 2^-1, degree 10, 59.8 bits */
    {0x1.5ab3aeaaab8b4p-1, 0x1.bab8b5fd26ec2p-55, -0x1.6be68c247d086p-3, 0x1.46261bbb45e65p-5, -0x1.033eb08839eebp-7,
     0x1.73836267bc372p-10, -0x1.e22f47f92734ap-13, 0x1.1a041b7345a63p-15, -0x1.2419d33ca5a1ap-18,
     0x1.00433add0c8bfp-21, -0x1.4d716074f92b4p-25, 0x1.dbe36c62db2a1p-31},
     /* [20] 1.5 <= y <= 1.625 2^-1, degree 10, 59.8 bits */
    {0x1.4fa408b40011dp-1, 0x1.bdf9035c7524dp-55, -0x1.5840f03bc2465p-3, 0x1.2ee5b36c656bap-5, -0x1.da5243d6215d2p-8,
     0x1.4fd50a4f60b86p-10, -0x1.b031e2612b0d6p-13, 0x1.f7885855baf04p-16, -0x1.058483abf1464p-18,
     0x1.d26d9ba2e8cbfp-22, -0x1.4122f65566417p-25, 0x1.7fe3a0fb9752bp-30},
     /* [21] 1.625 <= y <= 1.75 2^-1, degree 10, 62.2 bits */
    {0x1.452bea9653159p-1, 0x1.37d9f78de0192p-56, -0x1.45ff5594da766p-3, 0x1.199d80bdb1f8dp-5, -0x1.b260c175086eep-8,
     0x1.2fd7d0fa6998p-10, -0x1.8392b07a5311bp-13, 0x1.c1699637112ap-16, -0x1.d381e5f47a2ccp-19, 0x1.a66a993bbcae4p-22,
     -0x1.30285b808ba59p-25, 0x1.dda95acb2cafap-30}, /* [22] 1.75 <= y <= 1.875 2^-1, degree 10, 59.8 bits */
    {0x1.3b40ae384385fp-1, -0x1.bfd0b2f43c4d6p-57, -0x1.3503c0145a9cp-3, 0x1.061d7b28c2976p-5, -0x1.8e392d911da36p-8,
     0x1.132624ada092p-10, -0x1.5bbfdee33c9abp-13, 0x1.91120ca021f67p-16, -0x1.a1527fca73351p-19, 0x1.7d02c9d56d596p-22,
     -0x1.1c5ac8c39ff9p-25, 0x1.093a9d2c69a58p-29}, /* [23] 1.875 <= y <= 2 2^-1, degree 10, 60.9 bits */
    {0x1.2d52dc11c3c73p-1, 0x1.f2721bb6adbe9p-57, -0x1.1db2ff774968ap-2, 0x1.d7af802f1b21fp-4, -0x1.5e41609e523b7p-5,
     0x1.db0b0b6a6d1b6p-7, -0x1.27e61ecfd262ep-8, 0x1.522a34592e669p-10, -0x1.5f4c12393901cp-12, 0x1.4463052c22696p-14,
     -0x1.f88d8bf91904dp-17, 0x1.15afc6895c11fp-19}, /* [24] 1 <= y <= 1.125 2^0, degree 10, 58.3 bits */
    {0x1.1c59041b7c0a9p-1, 0x1.e4715a0f68f56p-55, -0x1.02291b6efd231p-2, 0x1.9b3ca3ec253a4p-4, -0x1.28438d17d7199p-5,
     0x1.87c5de7d9636p-7, -0x1.de582f0f01a45p-9, 0x1.0d91cfc84cf48p-10, -0x1.169044a6067a2p-12, 0x1.037c1063154a4p-14,
     -0x1.a348c7996d727p-17, 0x1.07e3bb61ace63p-19}, /* [25] 1.125 <= y <= 1.25 2^0, degree 10, 58.5 bits */
    {0x1.0cfb2cef845fcp-1, 0x1.53e05d236b6f5p-55, -0x1.d434b1e058d31p-3, 0x1.68005432a2e74p-4, -0x1.f74df86fc09d2p-6,
     0x1.445e007af2b54p-7, -0x1.83d7c53780976p-9, 0x1.ae6f6b10711c5p-11, -0x1.b92eab01e8462p-13, 0x1.9c3ec10e6c34p-15,
     -0x1.555b6481f2decp-17, 0x1.d2804a5d77a9fp-20}, /* [26] 1.25 <= y <= 1.375 2^0, degree 10, 59.1 bits */
    {0x1.fe0bf0f934cdp-2, -0x1.d090df5712bb6p-57, -0x1.aa00e1e9dc88fp-3, 0x1.3c64896fe58dep-4, -0x1.ad4a5fbd2e46fp-6,
     0x1.0da0833a9edacp-7, -0x1.3b84ca7e52ee2p-9, 0x1.585e8c120227ap-11, -0x1.5d4c3e69a088cp-13, 0x1.45fca08b89161p-15,
     -0x1.1208ba158cc09p-17, 0x1.8acd07feb021fp-20}, /* [27] 1.375 <= y <= 1.5 2^0, degree 10, 58.9 bits */
    {0x1.e49b5f1cefe61p-2, -0x1.9283bc1ef1399p-57, -0x1.84d8071081d3bp-3, 0x1.171f8f5e1a17ap-4, -0x1.6fa5ecee1b019p-6,
     0x1.c209e90db2872p-8, -0x1.0196514de18f1p-9, 0x1.1435bc753a40bp-11, -0x1.14be22ba15c1cp-13, 0x1.0115e4a460977p-15,
     -0x1.b3c10851fc1f4p-18, 0x1.44e9987541a6p-20}, /* [28] 1.5 <= y <= 1.625 2^0, degree 10, 62.1 bits */
    {0x1.cd59eda9793d3p-2, -0x1.2a5407c350909p-56, -0x1.6400a2e8205c7p-3, 0x1.ee498126a5ff5p-5, -0x1.3c1ad3444ec3p-6,
     0x1.79138d051107bp-8, -0x1.a61e21597814ep-10, 0x1.bc5995684aa26p-12, -0x1.b720bceed5dabp-14, 0x1.94fa408ed9de7p-16,
     -0x1.583621a291f28p-18, 0x1.066a4d6efd75bp-20}, /* [29] 1.625 <= y <= 1.75 2^0, degree 10, 59.7 bits */
    {0x1.b807827887996p-2, -0x1.34c290a897b8ap-57, -0x1.46df9f9f843fbp-3, 0x1.b730ddf494fc4p-5, -0x1.10d5d4f8a4d98p-6,
     0x1.3d2faf25a1e5bp-8, -0x1.5b27ad1d929ecp-10, 0x1.668850f2e19f7p-12, -0x1.5d12512b69ca6p-14, 0x1.3ee9b43e975bbp-16,
     -0x1.0ec334273d58ep-18, 0x1.a276c50095a67p-21}, /* [30] 1.75 <= y <= 1.875 2^0, degree 10, 59.9 bits */
    {0x1.a46ce6ea3d207p-2, -0x1.1d75b7f3b85a4p-56, -0x1.2cf2d0604890ep-3, 0x1.878c9b8b41785p-5, -0x1.d8bd2e0be6951p-7,
     0x1.0bd7bb80235c6p-8, -0x1.1e93285c96adbp-10, 0x1.223d4fc2335d7p-12, -0x1.1622c804463d3p-14, 0x1.f69addfdd9385p-17,
     -0x1.a8ecbf10b6003p-19, 0x1.4abbfce95b7b3p-21}, /* [31] 1.875 <= y <= 2 2^0, degree 10, 59.2 bits */
    {0x1.89d6f658ac89cp-2, -0x1.9676ac4c9efddp-57, -0x1.0b263b31e1e34p-2, 0x1.4b94f0b79f547p-3, -0x1.7fc8a8fdbb9dfp-4,
     0x1.a2a37b807f1c6p-5, -0x1.b0e6428faeaf6p-6, 0x1.a982fd0c20d69p-7, -0x1.8da6e98809483p-8, 0x1.607dd2420628cp-9,
     -0x1.271f352be427ep-10, 0x1.cc5a09a43006cp-12}, /* [32] 1 <= y <= 1.125 2^1, degree 10, 60.9 bits */
    {0x1.6adc720cdd7abp-2, 0x1.3904c2e9fcc48p-56, -0x1.cba45abcb50dcp-3, 0x1.0c779ee20fdbap-3, -0x1.2626cb73cc03ep-4,
     0x1.313c57d9b2b8bp-5, -0x1.2da61cab09639p-6, 0x1.1cb7e412ad20cp-7, -0x1.00de5441b9c5ep-8, 0x1.ba799d495e7c5p-10,
     -0x1.6b05c8434a54ep-11, 0x1.18ec1365975b9p-12}, /* [33] 1.125 <= y <= 1.25 2^1, degree 10, 58.7 bits */
    {0x1.501895a44cc7dp-2, -0x1.c4dcfe8b4391p-56, -0x1.8eddbdcb32d4cp-3, 0x1.b7955e9c668afp-4, -0x1.c8b938da593cep-5,
     0x1.c3594ac43d59cp-6, -0x1.aa7ca0d45d0cap-7, 0x1.8274529d8e9fcp-8, -0x1.502fa44c4d501p-9, 0x1.18a2953e7b4ebp-10,
     -0x1.c12ec5cc78941p-12, 0x1.561898a349096p-13}, /* [34] 1.25 <= y <= 1.375 2^1, degree 10, 59.3 bits */
    {0x1.38c76db2a5ab4p-2, -0x1.a87c8bd39419p-58, -0x1.5cdc337f82ab9p-3, 0x1.6b9136375c818p-4, -0x1.66d31838fa5b5p-5,
     0x1.521e19fe95104p-6, -0x1.31b363508b014p-7, 0x1.09f711a109631p-8, -0x1.bdeea93373a61p-10, 0x1.683a38b3da06dp-11,
     -0x1.186200631c5cp-12, 0x1.a224159875ebep-14}, /* [35] 1.375 <= y <= 1.5 2^1, degree 10, 59.2 bits */
    {0x1.24500e7ef873ap-2, -0x1.f40e107256f21p-61, -0x1.334f99026f3f1p-3, 0x1.2f85c98980f45p-4, -0x1.1d0c4f3f737bep-5,
     0x1.00710948470c7p-6, -0x1.bc133679b08cap-8, 0x1.7319d0643f73fp-9, -0x1.2bc1d1bcecb44p-10, 0x1.d43ea93839adbp-12,
     -0x1.61cc1e447df95p-13, 0x1.016b9e2349caep-14}, /* [36] 1.5 <= y <= 1.625 2^1, degree 10, 59.8 bits */
    {0x1.1239bd34753fp-2, 0x1.282461d0b27e3p-56, -0x1.1079fcf96feffp-3, 0x1.ff2b0300ab26dp-5, -0x1.c98ef836415a1p-6,
     0x1.8985d48bbb405p-7, -0x1.469ca5c2ac177p-8, 0x1.0650f99106839p-9, -0x1.985f1ba0e41f3p-11, 0x1.34424677b4f43p-12,
     -0x1.c3af40917cd4bp-14, 0x1.3ff957b749342p-15}, /* [37] 1.625 <= y <= 1.75 2^1, degree 10, 58.3 bits */
    {0x1.02242179b2ac1p-2, 0x1.2e9044137338cp-61, -0x1.e60ee9032d6a5p-4, 0x1.b1db98358afcdp-5, -0x1.72c1ae2e91d22p-6,
     0x1.313be18ba8ab5p-7, -0x1.e62b606e49d27p-9, 0x1.7787016e73d94p-10, -0x1.19c83a1a2b032p-11, 0x1.9b1af9898bf87p-13,
     -0x1.23dbd4c355565p-14, 0x1.9208d29d2f6d1p-16}, /* [38] 1.75 <= y <= 1.875 2^1, degree 10, 59.0 bits */
    {0x1.e783269e6353p-3, 0x1.5c64fadadbf1dp-57, -0x1.b3e3e8bb1120dp-4, 0x1.72f1137337c7p-5, -0x1.2f18cc4c000cfp-6,
     0x1.de56be06a0271p-8, -0x1.6de8c06144cb2p-9, 0x1.1008f77b4b30ep-10, -0x1.89bd7d8fae481p-12, 0x1.159ba6b9c8d97p-13,
     -0x1.7dd8b6a6dd608p-15, 0x1.fef6c80ce9383p-17}, /* [39] 1.875 <= y <= 2 2^1, degree 10, 59.5 bits */
    {0x1.c1ace19ed68ffp-3, -0x1.19158256aa169p-57, -0x1.759b801535d69p-3, 0x1.28f1cb9895526p-3, -0x1.c6f98127b5f0cp-4,
     0x1.51ad5b9ee83e7p-4, -0x1.e74a0d01c2a2p-5, 0x1.569df57453ec7p-5, -0x1.d638552e36e81p-6, 0x1.3b378a149f6efp-6,
     -0x1.9ea044f833329p-7, 0x1.095d917e7e516p-7}, /* [40] 1 <= y <= 1.125 2^2, degree 10, 57.3 bits */
    {0x1.973527e82f555p-3, -0x1.472ea8d36ce38p-57, -0x1.34d9a4a18908dp-3, 0x1.c2bb51c7c1d49p-4, -0x1.3e65ffee62947p-4,
     0x1.b55ef86283389p-5, -0x1.24f75572ddb48p-5, 0x1.7f95f76c39d96p-6, -0x1.eb9485b3a62a4p-7, 0x1.349b254bfe09bp-7,
     -0x1.7d269d915cd48p-8, 0x1.cbd8ca107499dp-9}, /* [41] 1.125 <= y <= 1.25 2^2, degree 10, 59.7 bits */
    {0x1.73d61e9096b43p-3, -0x1.8e1da7a6f0d98p-57, -0x1.0332c4321c35bp-3, 0x1.5d49e316d06aap-4, -0x1.c953d34af96d8p-5,
     0x1.23f9599b5dc6ap-5, -0x1.6c8cba9eabf9ep-6, 0x1.bdefb5fccd89bp-7, -0x1.0b956803fedbdp-7, 0x1.3b599a4ecbf88p-8,
     -0x1.6e507a6a4776bp-9, 0x1.a0e3a0620359p-10}, /* [42] 1.25 <= y <= 1.375 2^2, degree 10, 58.7 bits */
    {0x1.55f56a9373978p-3, -0x1.9973fb459cea4p-58, -0x1.b8c1214a2dd2ap-4, 0x1.13a16f365b3f5p-4, -0x1.4ffa179792c98p-5,
     0x1.90683fb3a0beep-6, -0x1.d3a83dff66281p-7, 0x1.0c1bdfe390d0ap-7, -0x1.2e2df918e9934p-8, 0x1.4f16aede5bf8ep-9,
     -0x1.6ed64ef73a126p-10, 0x1.8a6142aa8ffa8p-11}, /* [43] 1.375 <= y <= 1.5 2^2, degree 10, 59.4 bits */
    {0x1.3c69865f8cc4cp-3, 0x1.597cf819c05eep-58, -0x1.7b013ef1a314bp-4, 0x1.b9fa91163ff7cp-5, -0x1.f7a14cb701cc8p-6,
     0x1.1927ed87d55abp-6, -0x1.343a4607f0242p-7, 0x1.4c4d812d04635p-8, -0x1.60bb08555f1c7p-9, 0x1.70f59363673d4p-10,
     -0x1.7d7fa57dd86a3p-11, 0x1.841f6c50a9b28p-12}, /* [44] 1.5 <= y <= 1.625 2^2, degree 10, 59.0 bits */
    {0x1.26560124887fdp-3, 0x1.a6a67f4f89371p-58, -0x1.49275fbd1c366p-4, 0x1.675c86ac1e2b8p-5, -0x1.803a62fdeb484p-6,
     0x1.9349eff8da22ep-7, -0x1.a04e5441e2de1p-8, 0x1.a73e76b3154fp-9, -0x1.a83eff12e3d8p-10, 0x1.a39d2bf4dbfbbp-11,
     -0x1.9ab334c89edebp-12, 0x1.8c24f18f240efp-13}, /* [45] 1.625 <= y <= 1.75 2^2, degree 10, 58.7 bits */
    {0x1.13145edc83aa6p-3, -0x1.0d9d36e9ad764p-57, -0x1.205f393a388e3p-4, 0x1.27d7e929aa09cp-5, -0x1.29cea7f4ddb16p-6,
     0x1.26c55ebed296bp-7, -0x1.1f5b37e5289a7p-8, 0x1.143ef4d77e591p-9, -0x1.0624a68c579p-10, 0x1.eb7c806662e05p-12,
     -0x1.c856bc0238b99p-13, 0x1.a21ea8fd6a4dbp-14}, /* [46] 1.75 <= y <= 1.875 2^2, degree 10, 58.0 bits */
    {0x1.0224bc1bfaaf9p-3, 0x1.584487f89177p-57, -0x1.fd3a653aad0acp-5, 0x1.ec8a43085b9a3p-6, -0x1.d43ca3741719fp-7,
     0x1.b64fd660f8b96p-8, -0x1.9499f3a18f17cp-9, 0x1.70b872e6f7c6cp-10, -0x1.4c095962e731dp-11, 0x1.27aabf25d44f2p-12,
     -0x1.04f7ac917113bp-13, 0x1.c721367d13b7ap-15} /* [47] 1.875 <= y <= 2 2^2, degree 10, 59.0 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_middle_max_overlap)

/* largest overlap, 2^1 <= ln(beta) < 7: 28 rows of degree 10 in y = ln(beta) 2^-k, 16 to each octave k = 1 ... 2.
 * Relative error of the approximation: 2^-63.1 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_TAIL_MAX_OVERLAP_FIRST 2.0
#define COR_ROWS_HERTZ_DASHPOT_TAIL_MAX_OVERLAP_FIRST_OCTAVE 1
#define COR_ROWS_HERTZ_DASHPOT_TAIL_MAX_OVERLAP_OCTAVE_BITS 4
#define COR_ROWS_HERTZ_DASHPOT_TAIL_MAX_OVERLAP_ROWS 28
#define COR_ROWS_HERTZ_DASHPOT_TAIL_MAX_OVERLAP_END 7.0
COR_ROWS(double, cor_rows_hertz_dashpot_tail_max_overlap, 28, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.f47a795a3305ep-1, -0x1.352553b502fdfp-58, 0x1.5b2beb2e165aap-4, -0x1.294f014c66d4bp-3, 0x1.1c4cebc826db4p-3,
     -0x1.fbe4f31271d2p-5, -0x1.608902d2357a9p-6, 0x1.b384259fe94b7p-5, -0x1.02be2a08e16d9p-5, -0x1.03dd9ac65655ep-8,
     0x1.49114c2e4f16dp-6, -0x1.ac1132b14b055p-7}, /* [0] 1 <= y <= 1.0625 2^1, degree 10, 64.0 bits */
    {0x1.f6eace4f8ba13p-1, 0x1.654b6c629d29p-55, 0x1.17411131d9303p-4, -0x1.ee1fd6f42ecebp-4, 0x1.f6aa45d273062p-4,
     -0x1.0dd7e3b00b7c1p-4, -0x1.129ed8bc75425p-8, 0x1.41cb52c628262p-5, -0x1.fdf65fe658752p-6, 0x1.4ab76b02599dap-8,
     0x1.8b5b785bbb92dp-7, -0x1.8d0293b3a7bf1p-7}, /* [1] 1.0625 <= y <= 1.125 2^1, degree 10, 64.4 bits */
    {0x1.f8df58016ccdap-1, 0x1.5f6ea496950bp-55, 0x1.be3b047fbe4d6p-5, -0x1.9634ea9de2584p-4, 0x1.b340b1a8bbac2p-4,
     -0x1.0ad76776f9b1ep-4, 0x1.08a4c11119f2cp-7, 0x1.b0f6d7727477ap-6, -0x1.be5aa9bd95045p-6, 0x1.42d27a00a78e5p-7,
     0x1.5e62c19ac309bp-8, -0x1.2dcc91b524fd2p-7}, /* [2] 1.125 <= y <= 1.1875 2^1, degree 10, 63.7 bits */
    {0x1.fa6e11dde61e6p-1, -0x1.14b9fa14d005ep-56, 0x1.625d785a3158cp-5, -0x1.4abf5f1f5abd8p-4, 0x1.724e44a01db7bp-4,
     -0x1.f623b8ce1a765p-5, 0x1.0468be3e57565p-6, 0x1.00aec3108d548p-6, -0x1.6560a444640a1p-6, 0x1.7684090c25691p-7,
     0x1.4b7793f161764p-11, -0x1.82c2fbe2d500bp-8}, /* [3] 1.1875 <= y <= 1.25 2^1, degree 10, 63.1 bits */
    {0x1.fba9dd2e3718fp-1, -0x1.af8f452d12cf8p-55, 0x1.17e0a3b297945p-5, -0x1.0b071aa1d5689p-4, 0x1.365976f7c1536p-4,
     -0x1.c75b809c391d1p-5, 0x1.49e85604cdc17p-6, 0x1.e2f85c931b077p-8, -0x1.08c8bb921891bp-6, 0x1.65c30bca8936dp-7,
     -0x1.17d3d3da674ap-9, -0x1.92c8337bfcaa5p-9}, /* [4] 1.25 <= y <= 1.3125 2^1, degree 10, 63.4 bits */
    {0x1.fca2add40696fp-1, 0x1.eb2c9a3a5f107p-55, 0x1.b7ecd5d324ebap-6, -0x1.abeecfa4caf76p-5, 0x1.00c41394e5195p-4,
     -0x1.914f64d812d4fp-5, 0x1.63d5400a631cbp-6, 0x1.79b82a13f5178p-10, -0x1.6af70c5621db4p-7, 0x1.30dc93984239ep-7,
     -0x1.bb094c2d49e19p-9, -0x1.133e487fea07cp-10}, /* [5] 1.3125 <= y <= 1.375 2^1, degree 10, 63.9 bits */
    {0x1.fd65ce77781eap-1, -0x1.0e37ca4a6383bp-58, 0x1.5838a27aec469p-6, -0x1.549daffa5eb6ep-5, 0x1.a42ad2e6ce599p-5,
     -0x1.59b78c85d0038p-5, 0x1.5fc5d62db32e1p-6, -0x1.425e4398ff6f9p-9, -0x1.c595563dd85aap-8, 0x1.de4acd6b7525cp-8,
     -0x1.d999542a8b3bbp-9, 0x1.860904458ea7bp-13}, /* [6] 1.375 <= y <= 1.4375 2^1, degree 10, 65.1 bits */
    {0x1.fdfe302b7b869p-1, -0x1.5bcfe0224f3eap-55, 0x1.0c4428882fdbbp-6, -0x1.0d837a4265657p-5, 0x1.547ba4c3e605ap-5,
     -0x1.245b7071e4e71p-5, 0x1.48e1c673eeea9p-6, -0x1.3819d94d013c8p-8, -0x1.ee0fb58053e54p-9, 0x1.5e07f21e09c4ep-8,
     -0x1.ad769c9b165b1p-9, 0x1.a7473207b28e7p-11}, /* [7] 1.4375 <= y <= 1.5 2^1, degree 10, 64.2 bits */
    {0x1.fe74bcdfeda52p-1, -0x1.748673396cd78p-55, 0x1.a0a49f7802d5bp-7, -0x1.a8442d3851db6p-6, 0x1.119cc543a109dp-5,
     -0x1.e6f379f5dceeep-6, 0x1.27a727efab5b4p-6, -0x1.821d48e8e6599p-8, -0x1.9217b40ecbed9p-10, 0x1.df4267f4abdbp-9,
     -0x1.60965740cc87ap-9, 0x1.0ab3a6f0915b2p-10}, /* [8] 1.5 <= y <= 1.5625 2^1, degree 10, 65.2 bits */
    {0x1.fed0a6dc4fe9ap-1, -0x1.85390e9150bcfp-55, 0x1.427eb6a73fceep-7, -0x1.4c60125e57793p-6, 0x1.b48dde92e1a3ap-6,
     -0x1.905f105d6f6dep-6, 0x1.0221ad9ee6875p-6, -0x1.9748cb0e37801p-8, -0x1.c47b8ad5ca113p-15, 0x1.307c3b69ebe97p-9,
     -0x1.0d44b154ed492p-9, 0x1.035520096f8fp-10}, /* [9] 1.5625 <= y <= 1.625 2^1, degree 10, 65.6 bits */
    {0x1.ff17b1cb4081ap-1, -0x1.5a9b0453ef02dp-55, 0x1.f1c73d92ea252p-8, -0x1.034c529199ff7p-6, 0x1.5a0c80393262cp-6,
     -0x1.45a45daca04fdp-6, 0x1.b8abd80c68bfdp-7, -0x1.8abcb07cc6ccbp-8, 0x1.bbfdf7f7c95afp-11, 0x1.5dc92734d876p-10,
     -0x1.833076c6a8807p-10, 0x1.bc1f754d3dd0dp-11}, /* [10] 1.625 <= y <= 1.6875 2^1, degree 10, 66.0 bits */
    {0x1.ff4e739498911p-1, 0x1.9fd305dbb16c7p-55, 0x1.7f24aa4bbfab3p-8, -0x1.930fa5c5fdcffp-7, 0x1.10c593a65f171p-6,
     -0x1.066e26c562173p-6, 0x1.717212c34d86p-7, -0x1.6ab49c1601163p-8, 0x1.5ca229c27f578p-10, 0x1.50d757ceb215cp-11,
     -0x1.06e2c91716019p-10, 0x1.5e979df9f5104p-11}, /* [11] 1.6875 <= y <= 1.75 2^1, degree 10, 67.5 bits */
    {0x1.ff788c7435dbp-1, -0x1.e5824cd8baae3p-55, 0x1.26317e853d1c1p-8, -0x1.383635fdc829ap-7, 0x1.abe60c90d5a5p-7,
     -0x1.a3a4cd90c34d9p-7, 0x1.313e2e1e4f6cdp-7, -0x1.412eb7dd142d3p-8, 0x1.90b17f9c676dep-10, 0x1.85e8608204a7cp-13,
     -0x1.4f5925739079ap-11, 0x1.047007d4d22e7p-11}, /* [12] 1.75 <= y <= 1.8125 2^1, degree 10, 69.3 bits */
    {0x1.ff98d67ff8407p-1, 0x1.61c630836372ap-56, 0x1.c2c9f35131c94p-9, -0x1.e236a074798ebp-8, 0x1.4e2771b83c25ap-7,
     -0x1.4d3b9ab6f35fp-7, 0x1.f25a68ff543ccp-8, -0x1.14c8feefcaac3p-8, 0x1.950537a3edc5bp-10, -0x1.8f8da35e08f37p-14,
     -0x1.8ab34bef42ffcp-12, 0x1.6f8b8da00a83ap-12}, /* [13] 1.8125 <= y <= 1.875 2^1, degree 10, 66.9 bits */
    {0x1.ffb18d4308c1bp-1, 0x1.a64743ebcfe7bp-55, 0x1.58ab96610e29ep-9, -0x1.735edc51f0e3ap-8, 0x1.03ee2ec9611ddp-7,
     -0x1.070bd0f233238p-7, 0x1.92bcbe6919495p-8, -0x1.d33631a8cfa59p-9, 0x1.7d20913cb7424p-10, -0x1.0899bdc8b7b8cp-12,
     -0x1.98b7b2d1393a7p-13, 0x1.ede2b46099137p-13}, /* [14] 1.875 <= y <= 1.9375 2^1, degree 10, 67.5 bits */
    {0x1.ffc46e4ea2c56p-1, -0x1.ad83b1d92ca15p-55, 0x1.070b0efcc317p-9, -0x1.1d4b978bb1b8cp-8, 0x1.92fa9be4b9667p-8,
     -0x1.9d212d27c2574p-8, 0x1.42b43a7784bc8p-8, -0x1.83e3c61f0e6e4p-9, 0x1.568219d0d3d43p-10, -0x1.55a311a34212bp-12,
     -0x1.3e0e1e1a8eccap-14, 0x1.3a9cd89c64c2dp-13}, /* [15] 1.9375 <= y <= 2 2^1, degree 10, 67.3 bits */
    {0x1.ffd8ae506ba9cp-1, 0x1.cdbd76fe509bap-55, 0x1.5da2f32ff782ap-9, -0x1.7e97e9b83682ep-7, 0x1.1171cc2968fa9p-5,
     -0x1.1d148e52b29dep-4, 0x1.c8cb1ca188b06p-4, -0x1.1e6c372b9bbcap-3, 0x1.136f9da37c394p-3, -0x1.677d6332f6254p-4,
     0x1.6b633c0a5668ap-7, 0x1.1875f12f2311p-4}, /* [16] 1 <= y <= 1.0625 2^2, degree 10, 66.9 bits */
    {0x1.ffe97f3d4e9ddp-1, -0x1.9f269d7bdb08p-56, 0x1.93704191ac464p-10, -0x1.be032dedd5492p-8, 0x1.43187ebcb897ep-6,
     -0x1.5721b0f6380acp-5, 0x1.1a650383a53d9p-4, -0x1.718021685b85dp-4, 0x1.7fb70482b2a63p-4, -0x1.2cb653e9db56p-4,
     0x1.144ee3f12a2aep-5, 0x1.90606ca4cd528p-7}, /* [17] 1.0625 <= y <= 1.125 2^2, degree 10, 67.6 bits */
    {0x1.fff32cdc98927p-1, -0x1.c101c9d35e79dp-56, 0x1.cf16147d77701p-11, -0x1.023c1665427d4p-8, 0x1.7a641c546d3dcp-7,
     -0x1.97f9140f21412p-6, 0x1.56f10cb7babf9p-5, -0x1.cf2dc3a03a21cp-5, 0x1.faf12ce87693ap-5, -0x1.b8bfc1746c3eep-5,
     0x1.149d5aed6e2d3p-5, -0x1.0d4748547eb6bp-7}, /* [18] 1.125 <= y <= 1.1875 2^2, degree 10, 69.3 bits */
    {0x1.fff8b7d1dad85p-1, -0x1.d14080537e305p-55, 0x1.08917e3e6c438p-11, -0x1.2951e322cc28ap-9, 0x1.b7dfb69a6c2a6p-8,
     -0x1.e040d262e664ap-7, 0x1.9aa4f1fa30ee2p-6, -0x1.1c2dca4de8b16p-5, 0x1.43113fde09361p-5, -0x1.2c44799b3b68dp-5,
     0x1.b5adc2407da4p-6, -0x1.a2f22c49446f6p-7}, /* [19] 1.1875 <= y <= 1.25 2^2, degree 10, 69.6 bits */
    {0x1.fffbe0fda4f69p-1, -0x1.686771809d294p-55, 0x1.2d192dffbd125p-12, -0x1.54a16807f6d28p-10, 0x1.fc23e53175feep-9,
     -0x1.185874a21e178p-7, 0x1.e630379139da8p-7, -0x1.570cfd5072135p-6, 0x1.9151090c88862p-6, -0x1.86ad8d6fdb9p-6,
     0x1.36ff3489ccc0fp-6, -0x1.77ab7623e3f6fp-7}, /* [20] 1.25 <= y <= 1.3125 2^2, degree 10, 70.5 bits */
    {0x1.fffdacafba216p-1, -0x1.6c50b2ef29f0cp-55, 0x1.5576b1aa66ac1p-13, -0x1.849192c28392ap-11, 0x1.23ebb23beafd1p-9,
     -0x1.4509aeea7fa3bp-8, 0x1.1d2acaeaa906bp-7, -0x1.98cf023fe91ddp-7, 0x1.e904a8364c545p-7, -0x1.ec7a41c6a1b2ap-7,
     0x1.9f7f351cb9e33p-7, -0x1.1b36f038a2f92p-7}, /* [21] 1.3125 <= y <= 1.375 2^2, degree 10, 70.8 bits */
    {0x1.fffeb0f8094a8p-1, 0x1.d4c0630388816p-59, 0x1.8206180d9b8efp-14, -0x1.b9927a2d16013p-12, 0x1.4dd800d7d5de2p-10,
     -0x1.76a280e5d0b97p-9, 0x1.4bf58066c001bp-8, -0x1.e21f9105c703cp-8, 0x1.258aa822f2121p-7, -0x1.2f5bdac007797p-7,
     0x1.0aac53ad600ebp-7, -0x1.87975fc6cea14p-8}, /* [22] 1.375 <= y <= 1.4375 2^2, degree 10, 71.1 bits */
    {0x1.ffff43e6e2e75p-1, 0x1.c58251ebae45cp-56, 0x1.b32b860b964f5p-15, -0x1.f41e1cf52d34ep-13, 0x1.7c39dfe01e3f4p-11,
     -0x1.ad9b535153e32p-10, 0x1.7fed34ad27ff7p-9, -0x1.19ddbd3c5e6a3p-8, 0x1.5c434b7e52609p-8, -0x1.6f4ce40f1e8ffp-8,
     0x1.4ce3c2347814fp-8, -0x1.00f907e34bf9bp-8}, /* [23] 1.4375 <= y <= 1.5 2^2, degree 10, 72.4 bits */
    {0x1.ffff969ff05ap-1, 0x1.3ea61e8b02959p-56, 0x1.e953e50591cccp-16, -0x1.1a5c9abd20fdap-13, 0x1.af7d143696883p-12,
     -0x1.ea774ff82f1ecp-11, 0x1.b9917e33eb038p-10, -0x1.4738a231b5aeep-9, 0x1.993b1086a60eep-9, -0x1.b6bbf148bdae1p-9,
     0x1.971911985fd91p-9, -0x1.45e25d7ba96f8p-9}, /* [24] 1.5 <= y <= 1.5625 2^2, degree 10, 72.7 bits */
    {0x1.ffffc5159cebdp-1, -0x1.d35176dd35a11p-55, 0x1.127ad036bada4p-16, -0x1.3dfa10e23fff6p-14, 0x1.e816e1e7b8f26p-13,
     -0x1.16e2a0b1a3bc9p-11, 0x1.f96d5d5d1056fp-11, -0x1.79911ed5227b9p-10, 0x1.dd0e3a75b5facp-10,
     -0x1.0333039b20073p-9, 0x1.ea183bd91afbep-10, -0x1.932b8c8e1c6e3p-10},
     /* [25] 1.5625 <= y <= 1.625 2^2, degree 10, 73.7 bits */
    {0x1.ffffdf1ebb86p-1, -0x1.921d617933442p-55, 0x1.3348b99596dp-17, -0x1.6535efd63f2a7p-15, 0x1.13436cebbd3f1p-13,
     -0x1.3c1046337b218p-12, 0x1.200c14f30e93ep-11, -0x1.b161f265cddc5p-11, 0x1.1433a5564ab5fp-10,
     -0x1.2f8d074d34bep-10, 0x1.235fca9cb7016p-10, -0x1.e9b52e625014bp-11},
     /* [26] 1.625 <= y <= 1.6875 2^2, degree 10, 74.3 bits */
    {0x1.ffffedae4cae7p-1, 0x1.2bcb9d27563f5p-58, 0x1.5759a2ed9d7fbp-18, -0x1.90658f088a3dcp-16, 0x1.35abdcaf40b19p-14,
     -0x1.651920db14d0ap-13, 0x1.471b4e2958a53p-12, -0x1.ef30c6075a872p-12, 0x1.3e0007570b1d2p-11,
     -0x1.60dce8f6c489p-11, 0x1.57017a028471dp-11, -0x1.2536b52ea8b2bp-11}
     /* [27] 1.6875 <= y <= 1.75 2^2, degree 10, 75.0 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_tail_max_overlap)

/* time of the largest overlap, beta < 1/8: 3 rows of degree 10 in y = beta, nodes 0 + i 0.0625, 0 <= y <= 0.15625.
 * Relative error of the approximation: 2^-61.5 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_NEAR_TIME_OF_MAX_OVERLAP_FIRST 0.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_TIME_OF_MAX_OVERLAP_STEP 0.0625
#define COR_ROWS_HERTZ_DASHPOT_NEAR_TIME_OF_MAX_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_HERTZ_DASHPOT_NEAR_TIME_OF_MAX_OVERLAP_ROWS 3
#define COR_ROWS_HERTZ_DASHPOT_NEAR_TIME_OF_MAX_OVERLAP_END 0.125
COR_ROWS(double, cor_rows_hertz_dashpot_near_time_of_max_overlap, 3, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be991a8f0b41p+0, 0x1.5d0edcf22af24p-55, -0x1.1ff64bc052021p-2, 0x1.ba80f9a49f225p-6, 0x1.2001594f47561p-7,
     -0x1.7eb461e38388fp-8, 0x1.a92fc52ee4da5p-10, -0x1.7486034e984a7p-14, -0x1.33019b52dcc8p-13, 0x1.4ce6838d1d5c3p-14,
     -0x1.485123c6436adp-16, -0x1.069a05020c518p-21}, /* [0] 0 <= y <= 0.03125, degree 10, 64.8 bits */
    {0x1.9770c505eb1f2p+0, 0x1.d5a227feb4385p-54, -0x1.1c67c01cd9eb4p-2, 0x1.d3538e78de2a9p-6, 0x1.e4740cf37901p-8,
     -0x1.5de79083f84fep-8, 0x1.9d95075066147p-10, -0x1.2f37270d79bf9p-13, -0x1.cb23157d57a98p-14,
     0x1.1ea4122114e64p-14, -0x1.468e9739dd09ep-16, 0x1.00edc8cb37864p-20},
     /* [1] 0.03125 <= y <= 0.09375, degree 10, 61.5 bits */
    {0x1.930690437745bp+0, -0x1.f6545a255b311p-54, -0x1.18abb971ead27p-2, 0x1.e80c25c9596e9p-6, 0x1.90f7596866f9fp-8,
     -0x1.3e348fb7fe662p-8, 0x1.8d40091e74185p-10, -0x1.84ce1d0238b7fp-13, -0x1.47246a19787edp-14,
     0x1.e383b9e5ecafdp-15, -0x1.3075f9c9068dap-16, 0x1.cbbee505520d5p-18}
     /* [2] 0.09375 <= y <= 0.15625, degree 10, 63.4 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_near_time_of_max_overlap)

/* time of the largest overlap, 2^-3 <= beta < 8: 48 rows of degree 10 in y = beta 2^-k, 8 to each octave k = -3 ... 2.
 * Relative error of the approximation: 2^-58.6 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_TIME_OF_MAX_OVERLAP_FIRST 0.125
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_TIME_OF_MAX_OVERLAP_FIRST_OCTAVE (-3)
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_TIME_OF_MAX_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_TIME_OF_MAX_OVERLAP_ROWS 48
#define COR_ROWS_HERTZ_DASHPOT_MIDDLE_TIME_OF_MAX_OVERLAP_END 8.0
COR_ROWS(double, cor_rows_hertz_dashpot_middle_time_of_max_overlap, 48, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.927a58f3f490cp+0, -0x1.1efeb00057376p-55, -0x1.18316bd8b600fp-5, 0x1.ea5e2b537b9p-12, 0x1.871531c7e766bp-17,
     -0x1.3a564e2a7b20bp-20, 0x1.8af238c4c9db6p-25, -0x1.8d8ba8a300f3ap-31, -0x1.38658735f2dfep-35,
     0x1.eb10d0026324bp-39, 0x1.2c43065d5276ap-39, -0x1.62bfe3459a06p-36},
     /* [0] 1 <= y <= 1.125 2^-3, degree 10, 69.6 bits */
    {0x1.9162a280332ffp+0, -0x1.8f0c01099d291p-54, -0x1.173b1c54ce1bdp-5, 0x1.eed630585cf42p-12, 0x1.73ad43f8c31afp-17,
     -0x1.32ab625545758p-20, 0x1.8630c5e1ad258p-25, -0x1.9dd2e4fd5ee05p-31, -0x1.1b58742009d7cp-35,
     0x1.c243c4e8f18b5p-39, -0x1.a982d70c07dc4p-44, 0x1.74878dc4f2d9p-43},
     /* [1] 1.125 <= y <= 1.25 2^-3, degree 10, 62.7 bits */
    {0x1.904be37524a2ep+0, 0x1.c944ad459f5f8p-56, -0x1.16429f3dc2696p-5, 0x1.f314b4d9d4027p-12, 0x1.60bf4431815eep-17,
     -0x1.2b18b3ee2f852p-20, 0x1.8140d2126aac4p-25, -0x1.ac8f60fc44b3bp-31, -0x1.ff9af95f19e98p-36,
     0x1.ae68a8a2d0c19p-39, -0x1.200b5d11a68c4p-43, -0x1.eacee33687cf2p-45},
     /* [2] 1.25 <= y <= 1.375 2^-3, degree 10, 65.6 bits */
    {0x1.8f361df21a4fbp+0, -0x1.2a27a13e4d775p-57, -0x1.154810f8c3f27p-5, 0x1.f71b24551fbe2p-12, 0x1.4e49a79410bffp-17,
     -0x1.239f201736c1cp-20, 0x1.7c26e20d5ddfep-25, -0x1.b9d3685a95436p-31, -0x1.cb1e238e4cfb4p-36,
     0x1.99c3cfbf4ec2ep-39, -0x1.24c64dede7992p-43, -0x1.42c3b82df73cp-46},
     /* [3] 1.375 <= y <= 1.5 2^-3, degree 10, 64.1 bits */
    {0x1.8e2153fa5ae71p+0, 0x1.781b81cf6f3f7p-55, -0x1.144b8d3670a52p-5, 0x1.faeae592dc602p-12, 0x1.3c4ad62223e6cp-17,
     -0x1.1c3f6de33ef11p-20, 0x1.76e7441bdb7c6p-25, -0x1.c5b0f2e0dbcb2p-31, -0x1.992a79e726acep-36,
     0x1.85aac5464dfa5p-39, -0x1.233a9d865ac17p-43, -0x1.4ab5eaedbacb6p-47},
     /* [4] 1.5 <= y <= 1.625 2^-3, degree 10, 63.5 bits */
    {0x1.8d0d8775d5c74p+0, 0x1.9a1b67a95543ep-55, -0x1.134d2ef537272p-5, 0x1.fe855a81ab974p-12, 0x1.2ac12c15b0c0ep-17,
     -0x1.14fa4f63541fap-20, 0x1.7186114f81c6ap-25, -0x1.d0398582173c1p-31, -0x1.69b038865cadep-36,
     0x1.71982b36fbdf5p-39, -0x1.2cc37f59b014bp-43, 0x1.f6ab88fc59a2bp-44},
     /* [5] 1.625 <= y <= 1.75 2^-3, degree 10, 63.6 bits */
    {0x1.8bfaba31d3f1ep+0, -0x1.6da3d1d2bf88ap-54, -0x1.124d1083cc55dp-5, 0x1.00f5f00a669d6p-11, 0x1.19aafb28cea92p-17,
     -0x1.0dd062ad61124p-20, 0x1.6c072edfdd617p-25, -0x1.d980c7319d2aep-31, -0x1.3d176d4e3a8afp-36,
     0x1.18e2d519eaa9cp-37, 0x1.64a87f9247685p-39, -0x1.39b29356123e8p-31},
     /* [6] 1.75 <= y <= 1.875 2^-3, degree 10, 63.0 bits */
    {0x1.8ae8ede1a6844p+0, -0x1.b5ea91e5b9505p-54, -0x1.114b4b83b0881p-5, 0x1.028fe7133b943p-11, 0x1.09068bcd5cd14p-17,
     -0x1.06c232dcd6f31p-20, 0x1.666e4f43f432dp-25, -0x1.e18fa08d67998p-31, -0x1.11e2f04d51056p-36,
     0x1.4c66fd15ee738p-39, -0x1.d0d9dc9208f08p-44, 0x1.ef2e72629956ep-47},
     /* [7] 1.875 <= y <= 2 2^-3, degree 10, 62.9 bits */
    {0x1.895020acbad7p+0, -0x1.819986d1ca226p-54, -0x1.0fc5c225ffae7p-4, 0x1.04c8dd4505804p-9, 0x1.e1c2b4e75ea5bp-15,
     -0x1.f8c3e310cdb29p-17, 0x1.5ddfe3a4c181p-20, -0x1.eb8cc82fc70a4p-25, -0x1.ac0bcda3fa8d6p-30,
     0x1.3212276686c0cp-31, -0x1.ecb78b47188cfp-35, 0x1.e97dbf7339f64p-40},
     /* [8] 1 <= y <= 1.125 2^-2, degree 10, 63.5 bits */
    {0x1.8732a08c5175dp+0, -0x1.5b45e965789afp-56, -0x1.0db97ce70788fp-4, 0x1.076d07d42067p-9, 0x1.a45abcb490e55p-15,
     -0x1.dde26fe93471cp-17, 0x1.523b8b4487fbp-20, -0x1.f53d62b767d52p-25, -0x1.1b7dcb7337112p-30,
     0x1.1089a5525d628p-31, -0x1.cc9d7ade48239p-35, 0x1.ac1ebfadff318p-39},
     /* [9] 1.125 <= y <= 1.25 2^-2, degree 10, 64.7 bits */
    {0x1.85193e0228c0ep+0, -0x1.2f6fca2ba4982p-54, -0x1.0ba849c47507p-4, 0x1.09b79442a81b5p-9, 0x1.6a404fa8a8c2bp-15,
     -0x1.c3ebcc425d7bep-17, 0x1.46687795e3b59p-20, -0x1.fb33704593f1fp-25, -0x1.3640f542fcd82p-31,
     0x1.e2996a6c5ff77p-32, -0x1.ac10dd3225c69p-35, 0x1.9fa165c923c83p-39},
     /* [10] 1.25 <= y <= 1.375 2^-2, degree 10, 63.2 bits */
    {0x1.8304023a11dbp+0, -0x1.3be5aa51c8287p-54, -0x1.0992d714f2c85p-4, 0x1.0bad60c417b6ap-9, 0x1.3355e275f7706p-15,
     -0x1.aae2c7b80226dp-17, 0x1.3a7bbbe622833p-20, -0x1.fddc4795830a1p-25, -0x1.4e81705b0ac7cp-33,
     0x1.a8a98a5a22caap-32, -0x1.8c04c1eb7f42dp-35, 0x1.90d0778ceb13cp-39},
     /* [11] 1.375 <= y <= 1.5 2^-2, degree 10, 62.7 bits */
    {0x1.80f2f50ccf599p+0, -0x1.61e4642ad5308p-54, -0x1.0779c99f3bf71p-4, 0x1.0d531f0446401p-9, 0x1.fefb524e308a7p-16,
     -0x1.92c8a565088f3p-17, 0x1.2e87f3530cc0ep-20, -0x1.fd9d50301f6d7p-25, 0x1.cc9ab2c4921a2p-33,
     0x1.732d2b1611949p-32, -0x1.6d243edaab2ep-35, 0x1.a0bc7bfa6283p-39},
     /* [12] 1.5 <= y <= 1.625 2^-2, degree 10, 62.9 bits */
    {0x1.7ee61d12dbdf8p+0, -0x1.f75d9d6db6fa7p-54, -0x1.055dbcf374865p-4, 0x1.0ead53ea137ccp-9, 0x1.9d338b5928557p-16,
     -0x1.7b9d4b6d71fb7p-17, 0x1.229d7008c702ep-20, -0x1.fad425c358e68p-25, 0x1.204827cf3a54dp-31,
     0x1.422a1073d4897p-32, -0x1.54fcfebb2ba26p-35, -0x1.431af0b267bd4p-38},
     /* [13] 1.625 <= y <= 1.75 2^-2, degree 10, 65.6 bits */
    {0x1.7cdd7fb67dba5p+0, -0x1.672bec897583bp-54, -0x1.033f43c4b92bep-4, 0x1.0fc0579b91a91p-9, 0x1.4118e167e0627p-16,
     -0x1.655f6ee144eap-17, 0x1.16ca6970c81bp-20, -0x1.f5d6cccfcba58p-25, 0x1.b5e30da88cfdep-31, 0x1.1513cace13fdbp-32,
     -0x1.3143cb40692d4p-35, 0x1.6754ed8e758d3p-39}, /* [14] 1.75 <= y <= 1.875 2^-2, degree 10, 61.9 bits */
    {0x1.7ad92145278fp+0, 0x1.ab14c0c27180ap-56, -0x1.011ee8426c744p-4, 0x1.109055bb71289p-9, 0x1.d4e074ee18863p-17,
     -0x1.500cbc11ec786p-17, 0x1.0b1b28e6eeb09p-20, -0x1.eef3fc99db298p-25, 0x1.1b02b8e15db74p-30,
     0x1.d838599b48369p-33, -0x1.15951d0b111d2p-35, 0x1.593d93bd726fep-39},
     /* [15] 1.875 <= y <= 2 2^-2, degree 10, 62.4 bits */
    {0x1.77da906d50409p+0, -0x1.3ff1ea9a31d07p-54, -0x1.fbd7e1cae1c29p-4, 0x1.11535b995045cp-7, 0x1.c8a601291e45ap-15,
     -0x1.31c25eb5e0e38p-13, 0x1.f3dbdfa945b54p-16, -0x1.e1ac9491b662bp-19, 0x1.691894af01566p-23,
     0x1.6b6ac8b82d445p-25, -0x1.ddade8c8a7597p-27, 0x1.3bf508a3199d3p-29},
     /* [16] 1 <= y <= 1.125 2^-1, degree 10, 61.7 bits */
    {0x1.73eb6c7834dafp+0, 0x1.969db1956d137p-57, -0x1.f34bc220ff54dp-4, 0x1.1190b6a06738ap-7, -0x1.d3ed7d85e13d7p-17,
     -0x1.0c723af62d7f8p-13, 0x1.c7b2c6950fe9fp-16, -0x1.cbbbaad5a2b2fp-19, 0x1.b44791cc4ff62p-23,
     0x1.e4c448ba2e2e2p-26, -0x1.8143804329289p-27, 0x1.137293735b81ap-29},
     /* [17] 1.125 <= y <= 1.25 2^-1, degree 10, 61.5 bits */
    {0x1.700d6081f4861p+0, -0x1.04dd682898cd4p-54, -0x1.eac0ef9b80a09p-4, 0x1.1104861e995f3p-7, -0x1.35b0b00fb1a8p-14,
     -0x1.d4ff243048b62p-14, 0x1.9dc35442070fdp-16, -0x1.b27359e2ff02bp-19, 0x1.e44e2aa7d02c2p-23,
     0x1.2320af1392001p-26, -0x1.317081043646ap-27, 0x1.d781a2e431b79p-30},
     /* [18] 1.25 <= y <= 1.375 2^-1, degree 10, 64.8 bits */
    {0x1.6c4063e97b62p+0, 0x1.090cabd60a25ep-56, -0x1.e23d4f0fad48ap-4, 0x1.0fc84307b3a69p-7, -0x1.084625ffcc5a4p-13,
     -0x1.9776630e01e7dp-14, 0x1.764d2e87523e7p-16, -0x1.9727843ac3e3bp-19, 0x1.fec9f3f21c8dap-23,
     0x1.15e6b0875d691p-27, -0x1.db48902be8851p-28, 0x1.9cee0dae500e6p-30},
     /* [19] 1.375 <= y <= 1.5 2^-1, degree 10, 65.7 bits */
    {0x1.688463095e157p+0, 0x1.bd8fd171ede7fp-54, -0x1.d9c6032dbec61p-4, 0x1.0df303d5fb73ap-7, -0x1.6712c215a1f7cp-13,
     -0x1.5fe4297a31bc7p-14, 0x1.51739d5b30d79p-16, -0x1.7ae3686703c7cp-19, 0x1.04401f613e45dp-22,
     0x1.5bdff8f5fd20ep-30, -0x1.69fb1bca8a0a8p-28, 0x1.49da0bd67229cp-30},
     /* [20] 1.5 <= y <= 1.625 2^-1, degree 10, 67.1 bits */
    {0x1.64d940a97465cp+0, -0x1.1e737baaecf5fp-54, -0x1.d15f7efd8182ep-4, 0x1.0b99a2ae36265p-7, -0x1.b8aea1307ec4fp-13,
     -0x1.2ddeb842ba01bp-14, 0x1.2f43cfa2276e6p-16, -0x1.5e7505c73adcbp-19, 0x1.02b76404ea831p-22,
     -0x1.09d3265237616p-28, -0x1.0c88ee2f8dfe6p-28, 0x1.0dc9aa593896dp-30},
     /* [21] 1.625 <= y <= 1.75 2^-1, degree 10, 63.8 bits */
    {0x1.613ed74cb055dp+0, -0x1.5b1f63240b084p-58, -0x1.c90d97234a1bcp-4, 0x1.08cee4ef2d975p-7, -0x1.fe6fa4960ac02p-13,
     -0x1.00fba1ca18a2fp-14, 0x1.0fba1a7e64d2ep-16, -0x1.4277798a334b7p-19, 0x1.f8e04f934cc17p-23,
     -0x1.05c6d2c2738efp-27, -0x1.8112ae98457e6p-29, 0x1.b3c546e36d3c3p-31},
     /* [22] 1.75 <= y <= 1.875 2^-1, degree 10, 62.1 bits */
    {0x1.5db4fa5da9402p+0, -0x1.750a1fb9c7cbfp-57, -0x1.c0d391e6a7df9p-4, 0x1.05a3a308948c1p-7, -0x1.1cc89d7e4667fp-12,
     -0x1.b1a4252864e24p-15, 0x1.e58c9ba4f7f6ap-17, -0x1.275c2f9e664c9p-19, 0x1.e58284afff8c3p-23,
     -0x1.603c5ac5de276p-27, -0x1.071f48a5b220dp-29, 0x1.5b21dd9b6d9ddp-31},
     /* [23] 1.875 <= y <= 2 2^-1, degree 10, 63.4 bits */
    {0x1.5884c61bd96a1p+0, 0x1.d2355a84e095bp-55, -0x1.b4af4619b8d4bp-3, 0x1.004e4ec608e44p-5, -0x1.4065afd33b0ffp-9,
     -0x1.49254a5e47413p-11, 0x1.97f1af5824ffdp-12, -0x1.01025d43b5fc5p-13, 0x1.c0452b5c53f1bp-16,
     -0x1.b0a241d803b5bp-19, -0x1.fbdcc2b5449c1p-22, 0x1.e073d65b615fdp-22},
     /* [24] 1 <= y <= 1.125 2^0, degree 10, 65.1 bits */
    {0x1.51d1c0529ebabp+0, 0x1.c4a5fa56c5934p-54, -0x1.a4e8c9b612a2bp-3, 0x1.f0bf0c55f13a6p-6, -0x1.622bc9672b56cp-9,
     -0x1.af96b1a920b5bp-12, 0x1.40608885efbbcp-12, -0x1.a61ca07a7de84p-14, 0x1.874a5f48d9789p-16,
     -0x1.d43676a0cf5bep-19, -0x1.5c703ba7f657cp-25, 0x1.140f4672798d2p-22},
     /* [25] 1.125 <= y <= 1.25 2^0, degree 10, 61.8 bits */
    {0x1.4b5ccf0874b8p+0, 0x1.c15b0b393291bp-55, -0x1.95a6b974fcb99p-3, 0x1.df9ab1d86e541p-6, -0x1.7760be17b93bep-9,
     -0x1.fcf41d6b2fc8p-13, 0x1.f1b658db61d2p-13, -0x1.56e57fb43d87bp-14, 0x1.4d432bc594f88p-16, -0x1.c649679a361d1p-19,
     0x1.a8038580a6928p-23, 0x1.1d7c28211efa2p-23}, /* [26] 1.25 <= y <= 1.375 2^0, degree 10, 61.0 bits */
    {0x1.4523cf14e3693p+0, -0x1.419d856b11435p-57, -0x1.86f11f923c9fcp-3, 0x1.cdb4f81b05f8bp-6, -0x1.82d1bdec2dd97p-9,
     -0x1.d6ad4027a1948p-14, 0x1.7e088be5c46dp-13, -0x1.140b990339b04p-14, 0x1.16c7d4fd4d36ep-16,
     -0x1.9e95bfd8d45bbp-19, 0x1.4e342479a92bap-22, 0x1.dce5df34822a4p-25},
     /* [27] 1.375 <= y <= 1.5 2^0, degree 10, 62.6 bits */
    {0x1.3f2484d2d65c3p+0, 0x1.a08bda27aea95p-54, -0x1.78cc5886de711p-3, 0x1.bb74f7968acf9p-6, -0x1.86c309fb4dea4p-9,
     -0x1.aa47cc0d25baap-17, 0x1.214359b72898dp-13, -0x1.b90328744e7bcp-15, 0x1.cc20bfaa31ce9p-17,
     -0x1.6befe91f7a3b7p-19, 0x1.773dcdf4eaa0dp-22, 0x1.51acff3e1bbb3p-27},
     /* [28] 1.5 <= y <= 1.625 2^0, degree 10, 60.9 bits */
    {0x1.395ca9135e45bp+0, 0x1.d5aea8c51e442p-55, -0x1.6b39ed538b64ep-3, 0x1.a9295b511c381p-6, -0x1.8506264ed4901p-9,
     0x1.045b1082476a4p-14, 0x1.aed200d35615p-14, -0x1.5dd3f292834d4p-15, 0x1.77c3000fd1c08p-17, -0x1.37218541df3bdp-19,
     0x1.71d1d293e9613p-22, -0x1.05a483c98eea3p-26}, /* [29] 1.625 <= y <= 1.75 2^0, degree 10, 60.8 bits */
    {0x1.33c9f3001fb94p+0, -0x1.00e03ee6c3151p-54, -0x1.5e3942b19dee2p-3, 0x1.970d479fee432p-6, -0x1.7f0dc7c62be0bp-9,
     0x1.ebac53dfbeb23p-14, 0x1.3a07037e51762p-14, -0x1.13abd7d00cb08p-15, 0x1.3054fe4cfd446p-17,
     -0x1.050260a713c2cp-19, 0x1.5424b1351569fp-22, -0x1.d5e0129a8129bp-26},
     /* [30] 1.75 <= y <= 1.875 2^0, degree 10, 60.7 bits */
    {0x1.2e6a1f8a97676p+0, 0x1.f7739ba60d04bp-58, -0x1.51c824a166deep-3, 0x1.854c615b2496bp-6, -0x1.75ff2282aa0fdp-9,
     0x1.490cf301070e7p-13, 0x1.bc8fcf976bdcbp-15, -0x1.af9faf73f61b5p-16, 0x1.e9aa288e5a731p-18,
     -0x1.afdf38a3e0845p-20, 0x1.2bdf0c0eab368p-22, -0x1.104f506939a3dp-25},
     /* [31] 1.875 <= y <= 2 2^0, degree 10, 60.5 bits */
    {0x1.26b4f54e54a9bp+0, 0x1.b024236d1999ap-55, -0x1.402404fd33916p-2, 0x1.6b980d5cccd61p-4, -0x1.64893f061b9dcp-6,
     0x1.980c45be206ecp-9, 0x1.e4a8aecb28098p-11, -0x1.27113fd1f3985p-10, 0x1.5dbd11ea85826p-11, -0x1.3ee6cbabaaf5p-12,
     0x1.d84afbbe73083p-14, -0x1.070e99302f02ep-15}, /* [32] 1 <= y <= 1.125 2^1, degree 10, 65.5 bits */
    {0x1.1d0bff3faa2c7p+0, -0x1.2bfd9bdb8e41p-64, -0x1.2a6f4be0f18ddp-2, 0x1.4b6c3f4787807p-4, -0x1.494d33662e16cp-6,
     0x1.c68c044d75ccdp-9, 0x1.1a2329efeae12p-12, -0x1.5900c8c4fa1ecp-11, 0x1.b79eed8160c26p-12, -0x1.9f825b9b7df1ap-13,
     0x1.447380e4b13b1p-14, -0x1.9d2f05f0c904dp-16}, /* [33] 1.125 <= y <= 1.25 2^1, degree 10, 62.0 bits */
    {0x1.1408dba3b9a63p+0, -0x1.d053f764775a9p-54, -0x1.16a858fa31e86p-2, 0x1.2de52a1020e16p-4, -0x1.2c923924b796bp-6,
     0x1.cbb91d20e598p-9, -0x1.be23aa32b71fep-14, -0x1.802cee455e289p-12, 0x1.0fdde6c6cb241p-12, -0x1.09cb94da19b68p-13,
     0x1.ad2d54df10f41p-15, -0x1.24bbdfe74491ep-16}, /* [34] 1.25 <= y <= 1.375 2^1, degree 10, 59.1 bits */
    {0x1.0b9cc74c50f51p+0, -0x1.9e04f38f4336fp-56, -0x1.04a451e7ba2a2p-2, 0x1.130cd2e52c1a7p-4, -0x1.104ff116265e7p-6,
     0x1.b9d1483bdfb2bp-9, -0x1.437aaa1fbaae9p-12, -0x1.8905bc4d1bb56p-13, 0x1.4a6de90094ac6p-13,
     -0x1.4fcb51c85715ap-14, 0x1.15a756e04e1d9p-15, -0x1.89c73ff38fb11p-17},
     /* [35] 1.375 <= y <= 1.5 2^1, degree 10, 59.4 bits */
    {0x1.03ba54f540c25p+0, -0x1.207155fb210a2p-54, -0x1.e871e971c38fbp-3, 0x1.f593812b28c19p-5, -0x1.eb2d408c77f9bp-7,
     0x1.9c0954e7ff8eap-9, -0x1.a8daec74904dp-12, -0x1.4e4681530b91cp-14, 0x1.88a83b3e25943p-14, -0x1.a3faf30649f2bp-15,
     0x1.6276520529b65p-16, -0x1.01545011a57bbp-17}, /* [36] 1.5 <= y <= 1.625 2^1, degree 10, 63.5 bits */
    {0x1.f8aac278db0e9p-1, -0x1.bb9bfc792a5f6p-55, -0x1.ca7c770cbe273p-3, 0x1.c9e039650081ap-5, -0x1.b9d3395562692p-7,
     0x1.792204155a392p-9, -0x1.cc70bc3efc516p-12, -0x1.163f9342c0ddfp-16, 0x1.c35d645bfa39bp-15,
     -0x1.04121865af38bp-15, 0x1.c0a07a5b58338p-17, -0x1.4ac978683e6eep-18},
     /* [37] 1.625 <= y <= 1.75 2^1, degree 10, 62.2 bits */
    {0x1.eac5fa4709361p-1, 0x1.c6a690e1c0951p-55, -0x1.af1e50fdb8e0ap-3, 0x1.a29812e24ee27p-5, -0x1.8cf082c9663ffp-7,
     0x1.5512052c4f4c5p-9, -0x1.ca21ce0e65d1fp-12, 0x1.3cf47b732cfb5p-16, 0x1.eb3f0aef28a96p-16, -0x1.3e5d736c51437p-16,
     0x1.1a24e10853fa2p-17, -0x1.a51c94b8e7875p-19}, /* [38] 1.75 <= y <= 1.875 2^1, degree 10, 61.4 bits */
    {0x1.ddb2a8c221226p-1, -0x1.3c08b64c943fp-55, -0x1.961422a767bdp-3, 0x1.7f4f6a88fa905p-5, -0x1.6482e28c26103p-7,
     0x1.32153cc768035p-9, -0x1.b32118edc8746p-12, 0x1.3a147d3906c39p-15, 0x1.e232eca8bef5p-17, -0x1.7f9459e69516dp-17,
     0x1.60f4c0d87040ep-18, -0x1.0a84a6663db08p-19}, /* [39] 1.875 <= y <= 2 2^1, degree 10, 63.6 bits */
    {0x1.cb784b083b3e2p-1, -0x1.1197fdf985c65p-55, -0x1.745f560176a84p-2, 0x1.50fe403df7cd7p-3, -0x1.2fb92e49520b9p-4,
     0x1.0200877acf4d1p-5, -0x1.7f833bdc7ea35p-7, 0x1.8e84f62e71b15p-9, 0x1.54de7025a1097p-12, -0x1.55b9b73e9f7b5p-10,
     0x1.5a68db41c277cp-10, -0x1.0b797e3a5e044p-10}, /* [40] 1 <= y <= 1.125 2^2, degree 10, 58.7 bits */
    {0x1.b5714ebe49b5dp-1, 0x1.eca3f68608692p-55, -0x1.4d91d283b0f82p-2, 0x1.1da594262ab02p-3, -0x1.ec72387a4f37cp-5,
     0x1.97e6e8d16b409p-6, -0x1.34dcdc813bda6p-7, 0x1.7f971187369f2p-9, -0x1.c39ad77ca9d55p-12, -0x1.7a5096e85b408p-12,
     0x1.01454a4035c0fp-11, -0x1.a4d2c4747739dp-12}, /* [41] 1.125 <= y <= 1.25 2^2, degree 10, 58.8 bits */
    {0x1.a1a73642f8a2cp-1, 0x1.e87bc2dce090cp-55, -0x1.2c8faf81b69b2p-2, 0x1.e7cf079b523fep-4, -0x1.91a21a3e5772p-5,
     0x1.42102928b93bbp-6, -0x1.e4ea945a03a5bp-8, 0x1.41c0b56d462bbp-9, -0x1.3671954982f14p-11, -0x1.6d6b9d7934404p-16,
     0x1.5c6db0f5d3f35p-13, -0x1.44dd324f5c3b6p-13}, /* [42] 1.25 <= y <= 1.375 2^2, degree 10, 58.6 bits */
    {0x1.8fc62f80460ccp-1, -0x1.99fdd5722d5e7p-56, -0x1.104731351b518p-2, 0x1.a37e81a9a4394p-4, -0x1.49d8249487fc4p-5,
     0x1.fe1f0e182e40ap-7, -0x1.78e1cc56d334dp-8, 0x1.fe8ffb780fc97p-10, -0x1.2047b46e79498p-11, 0x1.5eeaf5b98ceadp-14,
     0x1.66f8cdd235516p-15, -0x1.dfd07854db11cp-15}, /* [43] 1.375 <= y <= 1.5 2^2, degree 10, 59.1 bits */
    {0x1.7f89a6ce7dd86p-1, -0x1.75667ce3bfd52p-56, -0x1.efbfd704db9edp-3, 0x1.6b31affb60ff6p-4, -0x1.10daa6c06cf99p-5,
     0x1.961f6f47f0c4fp-7, -0x1.24509266e01cfp-8, 0x1.8b3ab19caed34p-10, -0x1.dacbf3ee0685bp-12, 0x1.ad76a3b969beep-14,
     -0x1.239645895c69cp-20, -0x1.3d33a39ac10c7p-16}, /* [44] 1.5 <= y <= 1.625 2^2, degree 10, 59.8 bits */
    {0x1.70b91b3f5218ep-1, -0x1.a86014c5fbadp-56, -0x1.c55c2459cc9dcp-3, 0x1.3c7534f919c87p-4, -0x1.c6b112b8c5ff9p-6,
     0x1.45655a660cbf1p-7, -0x1.c671fef02df71p-9, 0x1.2edb595816695p-10, -0x1.739f85eef53c9p-12, 0x1.81f33bac279a6p-14,
     -0x1.db5808426158dp-17, -0x1.25a648a9aa48p-18}, /* [45] 1.625 <= y <= 1.75 2^2, degree 10, 61.5 bits */
    {0x1.6325a7e39b971p-1, 0x1.5055cced2c5e9p-55, -0x1.a050f78ec180cp-3, 0x1.1561fec7857bap-4, -0x1.7d86bcf5a579p-6,
     0x1.06847269927ccp-7, -0x1.62db90f0636bap-9, 0x1.ceeedd1c4e103p-11, -0x1.1c2beac691141p-12, 0x1.387109faff00fp-14,
     -0x1.0a55e12d6e465p-16, 0x1.80849f89ad2ebp-21}, /* [46] 1.75 <= y <= 1.875 2^2, degree 10, 60.6 bits */
    {0x1.56a81a02d733p-1, 0x1.d0dec93571d4bp-56, -0x1.7fc1d81164248p-3, 0x1.e8f95f13e9802p-5, -0x1.424c72c1641cdp-6,
     0x1.aa91cfdf82861p-8, -0x1.16b5505a64bd2p-9, 0x1.625be2822c8a3p-11, -0x1.ae413ebcfcda2p-13, 0x1.e3127dd4fd0bfp-15,
     -0x1.d1534e2e025bap-17, 0x1.1fed00aee46bep-19} /* [47] 1.875 <= y <= 2 2^2, degree 10, 60.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_middle_time_of_max_overlap)

/* time of the largest overlap, 2^1 <= ln(beta) < 7: 14 rows of degree 10 in y = ln(beta) 2^-k, 8 to each octave k = 1 ... 2.
 * Relative error of the approximation: 2^-57.4 at most, sampled at 25 places of each row. */
#define COR_ROWS_HERTZ_DASHPOT_TAIL_TIME_OF_MAX_OVERLAP_FIRST 2.0
#define COR_ROWS_HERTZ_DASHPOT_TAIL_TIME_OF_MAX_OVERLAP_FIRST_OCTAVE 1
#define COR_ROWS_HERTZ_DASHPOT_TAIL_TIME_OF_MAX_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_HERTZ_DASHPOT_TAIL_TIME_OF_MAX_OVERLAP_ROWS 14
#define COR_ROWS_HERTZ_DASHPOT_TAIL_TIME_OF_MAX_OVERLAP_END 7.0
COR_ROWS(double, cor_rows_hertz_dashpot_tail_time_of_max_overlap, 14, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.57badd2c8b48ap+2, -0x1.bc26f86af249p-54, 0x1.31cb76eda6744p+2, 0x1.8ef27ea24c4bap-2, -0x1.960df38c97b38p-2,
     0x1.cb24c35b60256p-3, -0x1.30ba1719671f6p-6, -0x1.4b9a2b38bd748p-4, 0x1.0042bab11f1bep-4, -0x1.113794dc3437bp-8,
     -0x1.b18105f5c4e31p-6, 0x1.375fc6bca9693p-6}, /* [0] 1 <= y <= 1.125 2^1, degree 10, 57.7 bits */
    {0x1.7e4c3a3f324dfp+2, -0x1.fc9d3e1f411c6p-52, 0x1.36f2d239b2bc1p+2, 0x1.0b9053f40879bp-2, -0x1.28f33f6f069eap-2,
     0x1.94e9a7d75b43fp-3, -0x1.ead127b1a48c3p-5, -0x1.016d275245d5bp-5, 0x1.87c8b9deb1fa6p-5, -0x1.5d0f689d6b976p-6,
     -0x1.610e1eeda186dp-8, 0x1.ac0baa8017748p-7}, /* [1] 1.125 <= y <= 1.25 2^1, degree 10, 58.5 bits */
    {0x1.a564f3615a97ep+2, -0x1.6a41ceb9318fp-54, 0x1.3a5a65d159355p+2, 0x1.5bcd1d63be58ep-3, -0x1.9c5ec65b6e20ep-3,
     0x1.3f10ec1a49bcap-3, -0x1.1f85300079e01p-4, 0x1.a3db05d686f32p-11, 0x1.aa7ece2bf96a5p-6, -0x1.4cf94f151b5d6p-6,
     0x1.50a965afb39ffp-8, 0x1.1285b0e4678e9p-8}, /* [2] 1.25 <= y <= 1.375 2^1, degree 10, 57.9 bits */
    {0x1.ccd5dedfbf8c8p+2, 0x1.fb25f3ce671ffp-54, 0x1.3c89e961d9262p+2, 0x1.b89b1d6974bf4p-4, -0x1.12d8efe78c34bp-3,
     0x1.d128c0a7859e8p-4, -0x1.026dac33028ecp-4, 0x1.00ff302d86693p-6, 0x1.2eb0bfa2d1de2p-7, -0x1.a8cc7c4e83165p-7,
     0x1.c20eff1b4b8f3p-8, -0x1.61d12cbd68b38p-11}, /* [3] 1.375 <= y <= 1.5 2^1, degree 10, 58.3 bits */
    {0x1.f47ec6d508788p+2, -0x1.3a194dd1363d7p-52, 0x1.3de8c645d51e8p+2, 0x1.114933744b748p-4, -0x1.62be5a2055037p-4,
     0x1.407be42fb8435p-4, -0x1.9599a4292c7c9p-5, 0x1.3a114d32dbb78p-6, -0x1.1adeebc0c2e98p-13, -0x1.92f1748e0370fp-8,
     0x1.462e01a1f7f97p-8, -0x1.f9b538e76caaap-10}, /* [4] 1.5 <= y <= 1.625 2^1, degree 10, 58.2 bits */
    {0x1.0e253c65781bcp+3, 0x1.d8bb388f3b058p-53, 0x1.3ec0a0c5f713ep+2, 0x1.4d40b21b7e371p-5, -0x1.be53d2447f27fp-5,
     0x1.a77afbaa597f5p-5, -0x1.24903ff6ea29bp-5, 0x1.17d3c4ba4790fp-6, -0x1.01a42827abe78p-8, -0x1.ebac67589c12ep-10,
     0x1.61b7920f00dbcp-9, -0x1.a0d29e1f9069p-10}, /* [5] 1.625 <= y <= 1.75 2^1, degree 10, 58.3 bits */
    {0x1.2215b49b321acp+3, 0x1.79756f2768c5dp-51, 0x1.3f435cfc09e9ep+2, 0x1.90b70eb091f4p-6, -0x1.1321462a28565p-5,
     0x1.0f080b1463c19p-5, -0x1.8e94c1234cb74p-6, 0x1.b01424cf8fd51p-7, -0x1.2f2a931c45e97p-8, 0x1.8f7e67cdb12c7p-13,
     0x1.25a5195eeb47bp-10, -0x1.ed5b82b175c95p-11}, /* [6] 1.75 <= y <= 1.875 2^1, degree 10, 61.7 bits */
    {0x1.360c91c42da48p+3, -0x1.0b7277917c71ap-52, 0x1.3f9188d002a31p+2, 0x1.dc49ecf15fe2ap-7, -0x1.4db47dab6befap-6,
     0x1.5283e5bab0375p-6, -0x1.049f8b44d0f01p-6, 0x1.32c92447cac4dp-7, -0x1.05d38e13a7712p-8, 0x1.df427ead6f3f8p-11,
     0x1.221e461f9d947p-12, -0x1.d2eee40002ac5p-12}, /* [7] 1.875 <= y <= 2 2^1, degree 10, 58.3 bits */
    {0x1.54057b4a31396p+3, 0x1.1aa5181fbb91dp-51, 0x1.3fcf27110aedep+3, 0x1.acd266d94cf3dp-6, -0x1.33b243130c3e9p-4,
     0x1.42aed6fafdb54p-3, -0x1.04ff075afeba7p-2, 0x1.4cf8bc4e6072fp-2, -0x1.4c0b041da3783p-2, 0x1.e0c152d9d1ef8p-3,
     -0x1.439c52c9dae41p-4, -0x1.57abce0e432a7p-4}, /* [8] 1 <= y <= 1.125 2^2, degree 10, 57.4 bits */
    {0x1.7c01c8c8b9f5ep+3, -0x1.8c98a02e57b2ep-51, 0x1.3fefde1c9aef7p+3, 0x1.20703d655dc33p-7, -0x1.a7bc2f05a1111p-6,
     0x1.ca78cdb0ba722p-5, -0x1.835dfe936e3c3p-4, 0x1.07b33f2a38cb4p-3, -0x1.24af089f7ff56p-3, 0x1.05c6ecd025912p-3,
     -0x1.61cc035e8287bp-4, 0x1.0982e81c08c9ep-5}, /* [9] 1.125 <= y <= 1.25 2^2, degree 10, 57.5 bits */
    {0x1.a400928e741c7p+3, -0x1.5c9e963e813ep-52, 0x1.3ffac3ed41452p+3, 0x1.7b8f10cd27632p-9, -0x1.1b9fc0564f8aep-7,
     0x1.39b1cd8595b2p-6, -0x1.10e015992c3f9p-5, 0x1.82d0321ba2acfp-5, -0x1.c79f3dca85b9bp-5, 0x1.c0aea0d4d1a27p-5,
     -0x1.6def0a91bb72bp-5, 0x1.d1970de8ebaf1p-6}, /* [10] 1.25 <= y <= 1.375 2^2, degree 10, 57.8 bits */
    {0x1.cc002e7bc43d8p+3, -0x1.da4111172944p-51, 0x1.3ffe531edde7cp+3, 0x1.eb27ebc0be0aap-11, -0x1.73d84e59f9a55p-9,
     0x1.a1fe8f819e646p-8, -0x1.7330298eb8d32p-7, 0x1.0e53cfe67c94dp-6, -0x1.4a7e9d270a20bp-6, 0x1.5794f967c6919p-6,
     -0x1.31f98c005626fp-6, 0x1.c8a82ee370612p-7}, /* [11] 1.375 <= y <= 1.5 2^2, degree 10, 58.1 bits */
    {0x1.f4000e9afc30bp+3, -0x1.b385df32e7c4ep-52, 0x1.3fff783f51ae2p+3, 0x1.39a0cdc77b0e7p-12, -0x1.dfca99cc8927ap-11,
     0x1.110b325fb110fp-9, -0x1.ec700305c28d9p-9, 0x1.6da8cd3f9ba54p-8, -0x1.ca818e8307036p-8, 0x1.ed57202fd6d4p-8,
     -0x1.ce0ee11092f8dp-8, 0x1.747670588c0d5p-8}, /* [12] 1.5 <= y <= 1.625 2^2, degree 10, 59.3 bits */
    {0x1.0e000246d75ebp+4, -0x1.cecaa64f86e38p-50, 0x1.3fffd56abd03p+3, 0x1.8c50fbf2c2ab9p-14, -0x1.31ab240554422p-12,
     0x1.5f5787b7c9959p-11, -0x1.409936f0240a1p-10, 0x1.e317bd7ce1267p-10, -0x1.34765244a0f45p-9, 0x1.53d6c97e81298p-9,
     -0x1.48ca548cc124ep-9, 0x1.154772554d161p-9} /* [13] 1.625 <= y <= 1.75 2^2, degree 10, 58.8 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_hertz_dashpot_tail_time_of_max_overlap)

/* Beyond the rows in ln(beta): a_0, a_0', a_1, a_1', a_2, ..., a_8 of a power of beta times
 * a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3), u = ln(beta),
 * through enclosed collisions; of eps at zero overlap v_f as two doubles: proved. */
COR_INLINE const double *cor_rows_hertz_dashpot_far_eps_zero_force(int i)
{
    static const double row[1][11] = {
    {0x1p+0, 0x1.f80ba2c85b7b2p-66, -0x1.8e6843c105ecfp-69, 0x1.5ec9d9d9c727ap-125, 0x1.01d723e6d0e7dp+2,
     -0x1.dfffffff737f8p+2, -0x1.ff5390e6ce66p-36, 0x1.0e64cd202c0bep+5, -0x1.359f1adedcdf3p+6, 0x1.2b89ce3208bbp+5,
     0x1.83ba177b4c3fdp-9} /* eps_zero_force */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_hertz_dashpot_far_duration_zero_force(int i)
{
    static const double row[1][11] = {
    {-0x1.9f323ecbf984cp-2, 0x1.a9f119ff3252ap-59, 0x1.4p+2, -0x1.3430f66e8520bp-71, -0x1.4cd054905c178p+3,
     0x1.180000000681dp+4, -0x1.7c13a4e1a89a3p-38, -0x1.2a0103b5b6403p+6, 0x1.ee3bc2bfa51d7p+6, -0x1.5e245ec4b8b08p+4,
     0x1.e891f94600294p-12} /* duration_zero_force */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_hertz_dashpot_far_max_overlap(int i)
{
    static const double row[1][11] = {
    {0x1p+0, -0x1.d896b328079d8p-73, 0x1.770d2228cc3edp-76, 0x1.4932e2a632281p-132, 0x1.47c67abb15a4dp+0,
     -0x1.4000000001ab5p+1, 0x1.8b472c625a40bp-43, 0x1.067aae883259ep+3, -0x1.00d298db5b1b6p+4, 0x1.2c00a863ccceep+2,
     -0x1.008aeed59fc3dp-18} /* max_overlap */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_hertz_dashpot_far_time_of_max_overlap(int i)
{
    static const double row[1][11] = {
    {-0x1.061376e0723c8p-75, 0x1.c8bbc35f8d6d8p-129, 0x1.4p+1, 0x1.ab82d2c1212a6p-79, -0x1.15d4dc0c459eap+2,
     0x1.e0000000000fap+2, -0x1.5ddd3d7a3cbbcp-47, -0x1.bc44bae5f81c9p+4, 0x1.616d68dd44c82p+5, -0x1.2c04974b00b27p+2,
     0x1.b71ec53d783b6p-17} /* time_of_max_overlap */
    };
    return row[i];
}

/* What runtime/core/law_eval.h needs of each quantity */

COR_INLINE_LAW struct cor_inline_law_quantity cor_law_hertz_dashpot_eps_zero_overlap(void)
{
    struct cor_inline_law_quantity x = cor_inline_law_quantity_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_loss_zero_overlap, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_OVERLAP), 1, COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_OVERLAP_END);
    x.middle = cor_inline_law_octaves(cor_rows_hertz_dashpot_middle_eps_zero_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_OVERLAP), COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_OVERLAP_END);
    x.below = cor_inline_law_octaves(cor_rows_hertz_dashpot_below_eps_zero_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_BELOW_EPS_ZERO_OVERLAP), COR_ROWS_HERTZ_DASHPOT_BELOW_EPS_ZERO_OVERLAP_END);
    x.threshold.hi = 1.1279881355201693;
    x.threshold.lo = -8.3184086291107819e-17;
    return x;
}

COR_INLINE_LAW struct cor_inline_law_inverse cor_law_hertz_dashpot_inverse_eps_zero_overlap(void)
{
    struct cor_inline_law_inverse x = cor_inline_law_inverse_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_beta_zero_overlap, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_OVERLAP), 1, COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_OVERLAP_END);
    x.rows = cor_inline_law_octaves(cor_rows_hertz_dashpot_beta_zero_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_OVERLAP), COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_OVERLAP_END);
    return x;
}

COR_INLINE_LAW struct cor_inline_law_quantity cor_law_hertz_dashpot_eps_zero_force(void)
{
    struct cor_inline_law_quantity x = cor_inline_law_quantity_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_loss_zero_force, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_FORCE), 3, COR_ROWS_HERTZ_DASHPOT_NEAR_LOSS_ZERO_FORCE_END);
    x.middle = cor_inline_law_octaves(cor_rows_hertz_dashpot_middle_eps_zero_force, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_FORCE), COR_ROWS_HERTZ_DASHPOT_MIDDLE_EPS_ZERO_FORCE_END);
    x.tail = cor_inline_law_octaves(cor_rows_hertz_dashpot_tail_eps_zero_force, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_TAIL_EPS_ZERO_FORCE), COR_ROWS_HERTZ_DASHPOT_TAIL_EPS_ZERO_FORCE_END);
    x.far = cor_rows_hertz_dashpot_far_eps_zero_force;
    x.far_kind = 1;
    x.power.num = -5;
    x.power.den = 2;
    x.far_power.num = -5;
    x.far_power.den = 2;
    x.mu.num = 5;
    x.mu.den = 2;
    return x;
}

COR_INLINE_LAW struct cor_inline_law_inverse cor_law_hertz_dashpot_inverse_eps_zero_force(void)
{
    struct cor_inline_law_inverse x = cor_inline_law_inverse_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_beta_zero_force, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_FORCE), 3, COR_ROWS_HERTZ_DASHPOT_NEAR_BETA_ZERO_FORCE_END);
    x.rows = cor_inline_law_octaves(cor_rows_hertz_dashpot_beta_zero_force, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE), COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE_END);
    return x;
}

COR_INLINE_LAW struct cor_inline_law_quantity cor_law_hertz_dashpot_duration_zero_overlap(void)
{
    struct cor_inline_law_quantity x = cor_inline_law_quantity_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_duration_zero_overlap, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_OVERLAP), 1, COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_OVERLAP_END);
    x.middle = cor_inline_law_octaves(cor_rows_hertz_dashpot_middle_duration_zero_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_OVERLAP), COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_OVERLAP_END);
    x.below = cor_inline_law_octaves(cor_rows_hertz_dashpot_below_duration_zero_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_BELOW_DURATION_ZERO_OVERLAP), COR_ROWS_HERTZ_DASHPOT_BELOW_DURATION_ZERO_OVERLAP_END);
    x.threshold.hi = 1.1279881355201693;
    x.threshold.lo = -8.3184086291107819e-17;
    x.beyond = cor_inline_infinity();
    return x;
}

COR_INLINE_LAW struct cor_inline_law_quantity cor_law_hertz_dashpot_duration_zero_force(void)
{
    struct cor_inline_law_quantity x = cor_inline_law_quantity_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_duration_zero_force, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_FORCE), 3, COR_ROWS_HERTZ_DASHPOT_NEAR_DURATION_ZERO_FORCE_END);
    x.middle = cor_inline_law_octaves(cor_rows_hertz_dashpot_middle_duration_zero_force, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_FORCE), COR_ROWS_HERTZ_DASHPOT_MIDDLE_DURATION_ZERO_FORCE_END);
    x.tail = cor_inline_law_octaves(cor_rows_hertz_dashpot_tail_duration_zero_force, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_TAIL_DURATION_ZERO_FORCE), COR_ROWS_HERTZ_DASHPOT_TAIL_DURATION_ZERO_FORCE_END);
    x.far = cor_rows_hertz_dashpot_far_duration_zero_force;
    x.far_kind = 1;
    x.power.num = -1;
    x.power.den = 1;
    x.far_power.num = -1;
    x.far_power.den = 1;
    x.mu.num = 5;
    x.mu.den = 2;
    return x;
}

COR_INLINE_LAW struct cor_inline_law_quantity cor_law_hertz_dashpot_max_overlap(void)
{
    struct cor_inline_law_quantity x = cor_inline_law_quantity_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_max_overlap, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_MAX_OVERLAP), 1, COR_ROWS_HERTZ_DASHPOT_NEAR_MAX_OVERLAP_END);
    x.middle = cor_inline_law_octaves(cor_rows_hertz_dashpot_middle_max_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_MIDDLE_MAX_OVERLAP), COR_ROWS_HERTZ_DASHPOT_MIDDLE_MAX_OVERLAP_END);
    x.tail = cor_inline_law_octaves(cor_rows_hertz_dashpot_tail_max_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_TAIL_MAX_OVERLAP), COR_ROWS_HERTZ_DASHPOT_TAIL_MAX_OVERLAP_END);
    x.far = cor_rows_hertz_dashpot_far_max_overlap;
    x.far_kind = 1;
    x.power.num = -1;
    x.power.den = 1;
    x.far_power.num = -1;
    x.far_power.den = 1;
    x.mu.num = 5;
    x.mu.den = 2;
    return x;
}

COR_INLINE_LAW struct cor_inline_law_quantity cor_law_hertz_dashpot_time_of_max_overlap(void)
{
    struct cor_inline_law_quantity x = cor_inline_law_quantity_of();
    x.near = cor_inline_law_grid(cor_rows_hertz_dashpot_near_time_of_max_overlap, COR_INLINE_GRID(COR_ROWS_HERTZ_DASHPOT_NEAR_TIME_OF_MAX_OVERLAP), 1, COR_ROWS_HERTZ_DASHPOT_NEAR_TIME_OF_MAX_OVERLAP_END);
    x.middle = cor_inline_law_octaves(cor_rows_hertz_dashpot_middle_time_of_max_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_MIDDLE_TIME_OF_MAX_OVERLAP), COR_ROWS_HERTZ_DASHPOT_MIDDLE_TIME_OF_MAX_OVERLAP_END);
    x.tail = cor_inline_law_octaves(cor_rows_hertz_dashpot_tail_time_of_max_overlap, COR_INLINE_OCTAVES(COR_ROWS_HERTZ_DASHPOT_TAIL_TIME_OF_MAX_OVERLAP), COR_ROWS_HERTZ_DASHPOT_TAIL_TIME_OF_MAX_OVERLAP_END);
    x.far = cor_rows_hertz_dashpot_far_time_of_max_overlap;
    x.far_kind = 1;
    x.power.num = -1;
    x.power.den = 1;
    x.far_power.num = -1;
    x.far_power.den = 1;
    x.mu.num = 5;
    x.mu.den = 2;
    return x;
}

COR_INLINE double cor_inline_hertz_dashpot_eps_zero_overlap(double beta)
{
    return cor_inline_law_eps(cor_law_hertz_dashpot_eps_zero_overlap(), beta);
}

COR_INLINE double cor_inline_hertz_dashpot_loss_zero_overlap(double beta)
{
    return cor_inline_law_loss(cor_law_hertz_dashpot_eps_zero_overlap(), beta);
}

COR_INLINE double cor_inline_hertz_dashpot_beta_zero_overlap(double eps)
{
    return cor_inline_law_beta(cor_law_hertz_dashpot_eps_zero_overlap(), cor_law_hertz_dashpot_inverse_eps_zero_overlap(), eps);
}

COR_INLINE double cor_inline_hertz_dashpot_beta_of_loss_zero_overlap(double loss)
{
    return cor_inline_law_beta_of_loss(cor_law_hertz_dashpot_eps_zero_overlap(), cor_law_hertz_dashpot_inverse_eps_zero_overlap(), loss);
}

COR_INLINE double cor_inline_hertz_dashpot_duration_zero_overlap(double beta)
{
    return cor_inline_law_value(cor_law_hertz_dashpot_duration_zero_overlap(), beta);
}

COR_INLINE double cor_inline_hertz_dashpot_eps_zero_force(double beta)
{
    return cor_inline_law_eps(cor_law_hertz_dashpot_eps_zero_force(), beta);
}

COR_INLINE double cor_inline_hertz_dashpot_loss_zero_force(double beta)
{
    return cor_inline_law_loss(cor_law_hertz_dashpot_eps_zero_force(), beta);
}

COR_INLINE double cor_inline_hertz_dashpot_beta_zero_force(double eps)
{
    return cor_inline_law_beta(cor_law_hertz_dashpot_eps_zero_force(), cor_law_hertz_dashpot_inverse_eps_zero_force(), eps);
}

COR_INLINE double cor_inline_hertz_dashpot_beta_of_loss_zero_force(double loss)
{
    return cor_inline_law_beta_of_loss(cor_law_hertz_dashpot_eps_zero_force(), cor_law_hertz_dashpot_inverse_eps_zero_force(), loss);
}

COR_INLINE double cor_inline_hertz_dashpot_duration_zero_force(double beta)
{
    return cor_inline_law_value(cor_law_hertz_dashpot_duration_zero_force(), beta);
}

COR_INLINE double cor_inline_hertz_dashpot_max_overlap(double beta)
{
    return cor_inline_law_value(cor_law_hertz_dashpot_max_overlap(), beta);
}

COR_INLINE double cor_inline_hertz_dashpot_time_of_max_overlap(double beta)
{
    return cor_inline_law_value(cor_law_hertz_dashpot_time_of_max_overlap(), beta);
}

#endif
