/* SPDX-License-Identifier: MIT */
/* Times of Tsuji's damping, x'' + sqrt(5) zeta x^(1/4) x' + x^(3/2) = 0, for every damping ratio zeta, in the
 * sphere's unit: rows of short polynomials around the nodes of uniform grids, and what follows at large
 * zeta. Evaluated by runtime/law/tsuji.c. Source: docs/laws.md; form: docs/header-format.md.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check
 *
 * The rows interpolate polynomials through samples by two Gauss rules of 56 points, which agree with enclosures by
 * adaptive quadrature to 1e-20 at two places of each block of rows. Errors of the rows stand above each table and
 * beside each row (sampled); errors of evaluation: include/cor/law.h (sampled). */
#ifndef COR_GENERATED_TSUJI_TABLES_H
#define COR_GENERATED_TSUJI_TABLES_H
#include "runtime/core/rows.h"

/* time of the largest overlap: 49 rows of degree 10 in y = ln(1 + zeta), nodes 0.125 + i 0.25, y < 12.25.
 * Relative error of the approximation: 2^-56.7 at most, sampled at 25 places of each row. */
#define COR_ROWS_TSUJI_TIME_OF_MAX_OVERLAP_FIRST 0.125
#define COR_ROWS_TSUJI_TIME_OF_MAX_OVERLAP_STEP 0.25
#define COR_ROWS_TSUJI_TIME_OF_MAX_OVERLAP_PER_UNIT 4.0
#define COR_ROWS_TSUJI_TIME_OF_MAX_OVERLAP_ROWS 49
#define COR_ROWS_TSUJI_TIME_OF_MAX_OVERLAP_END 12.25
COR_ROWS(double, cor_rows_tsuji_time_of_max_overlap, 49, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.878358e2d21f7p+0, -0x1.36415239e5cdp-55, -0x1.41ce2e3146e92p-1, 0x1.2a608726f271ep-4, 0x1.32ccc07d4681ep-7,
     -0x1.e88c4dccf08d6p-9, 0x1.7197d861a413p-12, 0x1.1c92c52e423f4p-15, -0x1.f86de5c752f4p-17, 0x1.27648972f5b2ep-19,
     -0x1.669fede048e61p-24, -0x1.4ab6729250fc4p-25}, /* [0] 0 <= y <= 0.25, 60.0 bits */
    {0x1.607c9ba9d29fcp+0, -0x1.35dd1531da223p-56, -0x1.2e5fa81c9001dp-1, 0x1.41a59acfcd79cp-4, 0x1.8054a531e6fc7p-8,
     -0x1.aba180424a0b9p-9, 0x1.943a75a1ecee3p-12, 0x1.7c2a834af0761p-17, -0x1.6d155f702ceeap-17, 0x1.02b47a1dc2fb4p-19,
     -0x1.4087d0288d166p-23, -0x1.0ae70081ca343p-26}, /* [1] 0.25 <= y <= 0.5, 58.4 bits */
    {0x1.3bf77e1cf5c5bp+0, 0x1.2d693f718fa3p-56, -0x1.19ceea82ad4ebp-1, 0x1.4ee650f06c7d2p-4, 0x1.74e4acfaf3c3dp-9,
     -0x1.6bca921c98c6ap-9, 0x1.98c339935fc51p-12, -0x1.30ecc223b9f72p-18, -0x1.ef73712bd8874p-18,
     0x1.a39c7cd92ac84p-20, -0x1.68bab3bee79a4p-23, -0x1.69723f5c5989ap-31}, /* [2] 0.5 <= y <= 0.75, 58.4 bits */
    {0x1.1a0ec15e14b52p+0, 0x1.6fa96cd057b07p-54, -0x1.04b0590d0c624p-1, 0x1.539fbe71f7a32p-4, 0x1.45d4c5d38e379p-12,
     -0x1.2cf4d36277f9cp-9, 0x1.88cd93e117ab1p-12, -0x1.f58eb8808ac58p-17, -0x1.36cba913ab77dp-18,
     0x1.400b58e06d7e2p-20, -0x1.53583d4efab71p-23, 0x1.0863f9e124d37p-27}, /* [3] 0.75 <= y <= 1, 58.8 bits */
    {0x1.f5982e102696dp-1, 0x1.6067cb5b82af5p-55, -0x1.df012e4b0a5d3p-2, 0x1.51499d2a47d0ep-4, -0x1.cc7423be60fcep-10,
     -0x1.e36b31861d5ffp-10, 0x1.6beeed4b529ap-12, -0x1.631bca3f29354p-16, -0x1.5b0c69b822961p-19,
     0x1.cf106b4ea7b82p-21, -0x1.1eaab560a064cp-23, 0x1.83c3cb27e85f2p-27}, /* [4] 1 <= y <= 1.25, 63.4 bits */
    {0x1.bc561c150e582p-1, -0x1.eefa46da27f12p-57, -0x1.b54ac8cc88c38p-2, 0x1.4946a3a5574a9p-4, -0x1.bc694fc12ed32p-9,
     -0x1.77345146579f7p-10, 0x1.47cf07fdef0cfp-12, -0x1.987b88c1bfae4p-16, -0x1.31d5fda4a02a9p-20,
     0x1.3f60cc9da5eb5p-21, -0x1.bf9dd01a7e0b7p-24, 0x1.93206520b65e9p-27}, /* [5] 1.25 <= y <= 1.5, 59.3 bits */
    {0x1.8837ad0e4346cp-1, -0x1.9727cb7f05a9ep-55, -0x1.8cde7f07a8c92p-2, 0x1.3cdb1174f7ddcp-4, -0x1.2fb56696d9db4p-8,
     -0x1.16df25ca146d4p-10, 0x1.2070c402ca31dp-12, -0x1.aa9a61902de11p-16, -0x1.5ce55b732c59ap-23,
     0x1.a564db566e814p-22, -0x1.47ddc8c37ccc3p-24, 0x1.643284de911dep-27}, /* [6] 1.5 <= y <= 1.75, 57.6 bits */
    {0x1.590b93039a13cp-1, 0x1.19badc77e6c57p-56, -0x1.6636f44ca793dp-2, 0x1.2d27c36375d6fp-4, -0x1.6aae223fa3238p-8,
     -0x1.85f60d716a6bcp-11, 0x1.f1179fe317454p-13, -0x1.a564d2b5c1725p-16, 0x1.f7d4b3f53e6d1p-22,
     0x1.0a4505978d3b3p-22, -0x1.c7b7bfe66fa9fp-25, 0x1.198e8d8baaba7p-27}, /* [7] 1.75 <= y <= 2, 60.6 bits */
    {0x1.2e9354a22f77ep-1, 0x1.0bcabf536f44cp-58, -0x1.41ad014c3076ap-2, 0x1.1b286f0a80f4dp-4, -0x1.9239d3f4bc77p-8,
     -0x1.ed98ce2367e0ap-12, 0x1.a3c6df9793b8p-13, -0x1.9165c4bcb54f9p-16, 0x1.cdcdcf2a3cec5p-21, 0x1.412e69c9f9718p-23,
     -0x1.308a77d0f5ea1p-25, 0x1.96007d47f77b2p-28}, /* [8] 2 <= y <= 2.25, 57.2 bits */
    {0x1.08873c326bf59p-1, 0x1.2751b83014dfcp-55, -0x1.1f7c581eb9524p-2, 0x1.07b3f80533bb2p-4, -0x1.a95bd4fdaa3bbp-8,
     -0x1.fc72a0394006dp-13, 0x1.5b1f8a7cbd51cp-13, -0x1.7474bffc48395p-16, 0x1.24828c68cd3f6p-20,
     0x1.6af94b02b389fp-24, -0x1.8f82e8458b693p-26, 0x1.0d7b18e58facdp-28}, /* [9] 2.25 <= y <= 2.5, 57.4 bits */
    {0x1.cd33676ea3765p-2, 0x1.d79067f9ce862p-57, -0x1.ff900d12e244bp-3, 0x1.e6fc37f15cd76p-5, -0x1.b2e99efdcd523p-8,
     -0x1.d397e7110d86bp-15, 0x1.186b880ce43ep-13, -0x1.5271971421161p-16, 0x1.459d8ff7f005cp-20, 0x1.6686c9e21f7f1p-25,
     -0x1.0929029e2560ep-26, 0x1.4cab386069698p-29}, /* [10] 2.5 <= y <= 2.75, 57.8 bits */
    {0x1.90f4297582d79p-2, -0x1.d4d19457b1b3fp-60, -0x1.c53d692a27939p-3, 0x1.be33de81eb173p-5, -0x1.b17da7d5eb88bp-8,
     0x1.86c0e131d16acp-14, 0x1.b8b999f667498p-14, -0x1.2de9d96b24fdap-16, 0x1.53c91ff537abbp-20, 0x1.b8023537502f3p-27,
     -0x1.708391c037138p-27, 0x1.87ea9660a243ap-30}, /* [11] 2.75 <= y <= 3, 57.6 bits */
    {0x1.5badeb3792d9cp-2, -0x1.3d41c5a0c6493p-60, -0x1.8ffd16bc6023cp-3, 0x1.95f9a15251dcp-5, -0x1.a7704401123e5p-8,
     0x1.b4e7e2b28a099p-13, 0x1.4e807f2ca61e3p-14, -0x1.0897789cbd3fep-16, 0x1.54d20c7722c4p-20, -0x1.100480ccb4221p-27,
     -0x1.1110ee1b2afe4p-27, 0x1.d73129b263655p-31}, /* [12] 3 <= y <= 3.25, 59.8 bits */
    {0x1.2cc0003498058p-2, 0x1.d84b48346a0f9p-56, -0x1.5fb17264f4448p-3, 0x1.6f0331c603818p-5, -0x1.96d48c005ab42p-8,
     0x1.3434c6d039f85p-12, 0x1.e4732801dcfcp-15, -0x1.c76c0007ec8b3p-17, 0x1.4c29608a0b26bp-20, -0x1.96e66e19dbfb1p-26,
     -0x1.a921072694a33p-28, 0x1.44b6076ddf991p-31}, /* [13] 3.25 <= y <= 3.5, 57.7 bits */
    {0x1.038ebba13a7afp-2, -0x1.eafeff95685bp-56, -0x1.34291c584d4dbp-3, 0x1.49d7bb4d08d44p-5, -0x1.817807fdd02dbp-8,
     0x1.7342d25c61557p-12, 0x1.47179ca813863p-15, -0x1.8068bcedeb1p-17, 0x1.3bfde86fe5551p-20, -0x1.35afd4c95bd9ep-25,
     -0x1.4cffb9d535d47p-28, 0x1.13f7f50517136p-31}, /* [14] 3.5 <= y <= 3.75, 57.1 bits */
    {0x1.bf0b1e78b679dp-3, -0x1.e051d24d3bf23p-57, -0x1.0d24616aaa7e1p-3, 0x1.26d65807904c2p-5, -0x1.68e463575dc5fp-8,
     0x1.9bc57380aed02p-12, 0x1.873b4b3677577p-16, -0x1.3d9a465c4b565p-17, 0x1.25f5a42c4615ap-20,
     -0x1.8761314e84508p-25, -0x1.f073989dc3991p-29, 0x1.0e1510dde9f89p-31}, /* [15] 3.75 <= y <= 4, 58.2 bits */
    {0x1.80311395cea4bp-3, 0x1.2f6f21fa2bb5bp-57, -0x1.d4b3b1c7e711cp-4, 0x1.063c49188f581p-5, -0x1.4e62af231ddd2p-8,
     0x1.b1a55db2cde47p-12, 0x1.60e4c9633b638p-17, -0x1.001eb684a99a5p-17, 0x1.0b907a647a519p-20,
     -0x1.c14b8c54ba2d4p-25, -0x1.471d6af038f1cp-29, 0x1.0ee5513615e15p-31}, /* [16] 4 <= y <= 4.25, 57.9 bits */
    {0x1.498a9c20eb99bp-3, -0x1.6a8827cb8dc29p-59, -0x1.96f481a3ba009p-4, 0x1.d055a334a74d3p-6, -0x1.32ffd9c4405fap-8,
     0x1.b87bd100f114ep-12, 0x1.6148701ba77d6p-22, -0x1.91817f77e41b4p-18, 0x1.dc95d3448ec83p-21,
     -0x1.e37cd7c000eebp-25, -0x1.40c8de863f8bcp-30, 0x1.03ed0242f24a3p-31}, /* [17] 4.25 <= y <= 4.5, 57.5 bits */
    {0x1.1a2733503cb31p-3, 0x1.300513869b45bp-59, -0x1.60674c5675713p-4, 0x1.995936050ac96p-6, -0x1.17920ba82215bp-8,
     0x1.b386b924fc63bp-12, -0x1.f953227451754p-18, -0x1.2ff0aedff5314p-18, 0x1.9f34af80aefb6p-21,
     -0x1.eef48daf9615ap-25, -0x1.7440e46da3d54p-35, 0x1.cffbba4e56387p-32}, /* [18] 4.5 <= y <= 4.75, 57.4 bits */
    {0x1.e255c5249ef61p-4, 0x1.067bb3c99f24bp-59, -0x1.3067d18e78396p-4, 0x1.67752245331bep-6, -0x1.f97d368b1153cp-9,
     0x1.a5a1a1b42321ap-12, -0x1.c03f26968e65ep-17, -0x1.b7b95d525e5a2p-19, 0x1.61b192bcc0f07p-21,
     -0x1.e621aa6f750a3p-25, 0x1.fa7f3c6b335f2p-31, 0x1.7bf445c5d4297p-32}, /* [19] 4.75 <= y <= 5, 57.6 bits */
    {0x1.9b9c179024d0bp-4, -0x1.16e7ac07d762fp-62, -0x1.065559e316226p-4, 0x1.3a8056582302ap-6, -0x1.c60098fa5e59dp-9,
     0x1.914346c1112fp-12, -0x1.24e2ee34444b7p-16, -0x1.2a13bf1d0364ep-19, 0x1.265e0bf95f1ffp-21,
     -0x1.cca9e1aa1718cp-25, 0x1.cc1771c19bbdcp-30, 0x1.1893a22fe115ep-32}, /* [20] 5 <= y <= 5.25, 57.1 bits */
    {0x1.5eb98eea578d5p-4, 0x1.c1be17e5e15e2p-62, -0x1.c32b351f4d9aap-5, 0x1.123e3c036147bp-6, -0x1.955b2a4b06094p-9,
     0x1.787f4426605a6p-12, -0x1.51798586d9567p-16, -0x1.6b22129232d83p-20, 0x1.de152d59519f8p-22,
     -0x1.a6df13ad7a604p-25, 0x1.2dcde64a1eca6p-29, 0x1.66c15477238ebp-33}, /* [21] 5.25 <= y <= 5.5, 57.8 bits */
    {0x1.2a6be8f5aef21p-4, 0x1.45d2f3019c561p-59, -0x1.832d7e7cd9847p-5, 0x1.dcc9e914504c3p-7, -0x1.67fd54d55dd65p-9,
     0x1.5d0b28bf66222p-12, -0x1.6a6afc80df3a3p-16, -0x1.609542ea0603ep-21, 0x1.79f51c7bc4e01p-22,
     -0x1.792a2f1d3ff3ep-25, 0x1.571b354075938p-29, 0x1.5c6b3aae1d2a7p-34}, /* [22] 5.5 <= y <= 5.75, 57.6 bits */
    {0x1.fb28494b10616p-5, -0x1.8091ece2a4f63p-60, -0x1.4ba17c37ade91p-5, 0x1.9d44f6866d7bbp-7, -0x1.3e264f2dd85cbp-9,
     0x1.40460fe0646e6p-12, -0x1.73d15db017e86p-16, -0x1.eaad3000e6bbfp-24, 0x1.21d26b572c9b1p-22,
     -0x1.47935a00ef5d7p-25, 0x1.65e575959e51fp-29, 0x1.4efd56a413f64p-37}, /* [23] 5.75 <= y <= 6, 58.0 bits */
    {0x1.ae67e96f6225p-5, 0x1.72595aad082a9p-60, -0x1.1b8c301465454p-5, 0x1.65418a790823ep-7, -0x1.17ee5a098eb7p-9,
     0x1.2341dda2af53ap-12, -0x1.71499fab23754p-16, 0x1.3c87fa01774fcp-22, 0x1.ac6c1510d0863p-23,
     -0x1.157644d914678p-25, 0x1.5f985a02f5b6p-29, -0x1.7d8426428dd68p-35}, /* [24] 6 <= y <= 6.25, 58.0 bits */
    {0x1.6cd623029884ap-5, -0x1.d02d7624f21dep-61, -0x1.e4108e971a682p-6, 0x1.3411f2da81a7fp-7, -0x1.ea9f8eef3cbdap-10,
     0x1.06cd4ceee881ap-12, -0x1.65eddcc03bc32p-16, 0x1.3d221516b495ep-21, 0x1.2dd6b751cf35cp-23,
     -0x1.cac2cc7b28da9p-26, 0x1.4a0448293b547p-29, -0x1.5e15f32e65d7bp-34}, /* [25] 6.25 <= y <= 6.5, 59.5 bits */
    {0x1.34e907895e423p-5, 0x1.a27c0e40c0079p-60, -0x1.9c8bf8ad713c3p-6, 0x1.090bbee8c9eaep-7, -0x1.ac5d7924703cp-10,
     0x1.d6fc402b19cfbp-13, -0x1.54574dd67ce49p-16, 0x1.a9c1048a02fdfp-21, 0x1.8ccfed054d8cp-24, -0x1.722d795c632e3p-26,
     0x1.2a996ca09e619p-29, -0x1.bc6e41464ad52p-34}, /* [26] 6.5 <= y <= 6.75, 57.5 bits */
    {0x1.0547f8350ba15p-5, 0x1.127f249ff48e4p-62, -0x1.5f14e61dedd1bp-6, 0x1.c7168d500c666p-8, -0x1.74bf6453957cep-10,
     0x1.a375db6df55f3p-13, -0x1.3ea5eec7d1691p-16, 0x1.edcc457e40a18p-21, 0x1.cfc316f70faf3p-25,
     -0x1.2344b714340cep-26, 0x1.05f5230aacd53p-29, -0x1.e5fdcfeecb6b3p-34}, /* [27] 6.75 <= y <= 7, 59.4 bits */
    {0x1.b98d147eaec0ep-6, 0x1.f5a4dc7c80838p-63, -0x1.2a5d6c5456afp-6, 0x1.85ec2de3930ccp-8, -0x1.43598e3626181p-10,
     0x1.738859d84236p-13, -0x1.268bd1177085fp-16, 0x1.08f19359016abp-20, 0x1.9f1514be2ed77p-26, -0x1.bdf059013f934p-27,
     0x1.bf661777f3058p-30, -0x1.e7f3ebe4bb8e3p-34}, /* [28] 7 <= y <= 7.25, 58.2 bits */
    {0x1.74bf68a8271f6p-6, 0x1.bd8a1a0aeeb28p-60, -0x1.fa79d84d791ddp-7, 0x1.4d78f093db81bp-8, -0x1.17b40088c8bd3p-10,
     0x1.4778911d60c88p-13, -0x1.0d5a6bb498d8p-16, 0x1.0ebef47288659p-20, 0x1.c84452d9aa958p-30, -0x1.4ab0b06ef1b5cp-27,
     0x1.74db37d738d8ap-30, -0x1.ce9e06dcbe248p-34}, /* [29] 7.25 <= y <= 7.5, 61.9 bits */
    {0x1.3a62a2bfcd9b1p-6, -0x1.5c0d2240f73bap-62, -0x1.ad5a8ab975e5ep-7, 0x1.1cb481c0089eap-8, -0x1.e2a25c6a17ba2p-11,
     0x1.1f5d3f995c7e2p-13, -0x1.e8212595aee15p-17, 0x1.0b75a7f31b519p-20, -0x1.fa208c7ec09f4p-27,
     -0x1.d76d53183d5f4p-28, 0x1.2fb5f73cf4f08p-30, -0x1.a46881cba04b8p-34}, /* [30] 7.5 <= y <= 7.75, 57.5 bits */
    {0x1.08effee01ed66p-6, 0x1.aad18ade64e24p-61, -0x1.6b8fcfbe5042ep-7, 0x1.e55c6efe47e49p-9, -0x1.9f65e654b2407p-11,
     0x1.f655c4a59eaaep-14, -0x1.b6d03fc38cc5ep-17, 0x1.01af977f32608p-20, -0x1.c1102296abf19p-26,
     -0x1.3e5d4cc4d0946p-28, 0x1.e3dc29d4066d4p-31, -0x1.7182ff46da7p-34}, /* [31] 7.75 <= y <= 8, 57.2 bits */
    {0x1.be2d73d180a4fp-7, 0x1.e06ded373e0b5p-62, -0x1.3385c162c1f2ap-7, 0x1.9d19a2df4e9c2p-9, -0x1.64bc75d545a9fp-11,
     0x1.b57af43e79dd3p-14, -0x1.87c54c1ae9d91p-17, 0x1.e70b901cc134fp-21, -0x1.206b6763857edp-25,
     -0x1.8b856ed750e1ap-29, 0x1.78c070c120c6ep-31, -0x1.3bed91c5888a3p-34}, /* [32] 8 <= y <= 8.25, 57.0 bits */
    {0x1.776a8dd90872ep-7, -0x1.c180ff3540e46p-62, -0x1.03dbf1766e86ep-7, 0x1.5f1b4958bdab5p-9, -0x1.31bb1a5076e4bp-11,
     0x1.7bc0dc9375523p-14, -0x1.5ba9a51795fd7p-17, 0x1.c53f6b1792765p-21, -0x1.45b9eafc1b013p-25,
     -0x1.a3bc8d57d20c1p-30, 0x1.1e40b87234cb3p-31, -0x1.07bf24245dc8ap-34}, /* [33] 8.25 <= y <= 8.5, 56.8 bits */
    {0x1.3ba67211619e7p-7, -0x1.4f91ec1cd7d56p-64, -0x1.b6bfd32e8e511p-8, 0x1.2a06c6a673494p-9, -0x1.0585728c7af95p-11,
     0x1.48a98b7e1f7b6p-14, -0x1.32e09d432a19ap-17, 0x1.a08734e991bd8p-21, -0x1.56d1d6b8acd6p-25, -0x1.1a87974d8632p-31,
     0x1.a6fc32867b93dp-32, -0x1.af0663a8b73d8p-35}, /* [34] 8.5 <= y <= 8.75, 58.0 bits */
    {0x1.0937aff55dbedp-7, 0x1.91474a52434a4p-63, -0x1.721003c7c5b4cp-8, 0x1.f952944e0f18p-10, -0x1.be9f488ad1169p-12,
     0x1.1babe6cc707c8p-14, -0x1.0d9839f0c245p-17, 0x1.7accb97615bb8p-21, -0x1.58f6ef1216439p-25, 0x1.ea571c68c5f91p-33,
     0x1.2dfe9be0709fp-32, -0x1.5932b72956799p-35}, /* [35] 8.75 <= y <= 9, 59.7 bits */
    {0x1.bd654f2f29391p-8, 0x1.e8df9ec617e32p-63, -0x1.37dd34a4367cap-8, 0x1.abe936adb00e5p-10, -0x1.7cbe9015da6b1p-12,
     0x1.e875c477c799fp-15, -0x1.d7ae15cafc32ap-18, 0x1.5574a57acd2b1p-21, -0x1.506c99be950bfp-25,
     0x1.960407c3d43f1p-31, 0x1.9c02b30e07a58p-33, -0x1.0f16240e8e6afp-35}, /* [36] 9 <= y <= 9.25, 60.9 bits */
    {0x1.75c22b55914d6p-8, 0x1.030ac4beff3ebp-62, -0x1.069b78a781e33p-8, 0x1.69f79c49c5051p-10, -0x1.44171d740cb36p-12,
     0x1.a395827cf8e9fp-15, -0x1.9b0ec45fbe011p-18, 0x1.3178dfcf816cp-21, -0x1.40955275a153p-25, 0x1.28e8daa9670edp-30,
     0x1.06ae89055834p-33, -0x1.a14903c6056cap-36}, /* [37] 9.25 <= y <= 9.5, 57.0 bits */
    {0x1.397553e5d3a19p-8, 0x1.fab3eb8081c6fp-63, -0x1.b9ec971951368p-9, 0x1.31dffcbadd5aep-10, -0x1.1379b1986af9bp-12,
     0x1.67a98e78e1dafp-15, -0x1.65007bcb0fae7p-18, 0x1.0f7f565a925b9p-21, -0x1.2c138f7ffaee7p-25,
     0x1.61fc0f47cf559p-30, 0x1.29d4b290cf9a5p-34, -0x1.3a403eea0695fp-36}, /* [38] 9.5 <= y <= 9.75, 57.3 bits */
    {0x1.06bd1c11b127fp-8, -0x1.dae31a2f947b4p-62, -0x1.7392eb3fb5437p-9, 0x1.023a50eda2511p-10, -0x1.d3afb0c31d547p-13,
     0x1.33b357a622978p-15, -0x1.35187322f3e39p-18, 0x1.dfda7a074f8fbp-22, -0x1.14e98937c1f46p-25,
     0x1.7f4de7f1fa8e6p-30, 0x1.00e0911a483c4p-35, -0x1.cda89934ff0edp-37}, /* [39] 9.75 <= y <= 10, 58.2 bits */
    {0x1.b8370d04a71dfp-9, -0x1.72c1ba8f3b492p-63, -0x1.383567f733808p-9, 0x1.b39cba776b45dp-11, -0x1.8c83ae282422dp-13,
     0x1.06c6369caa14ap-15, -0x1.0addb4d5d0892p-18, 0x1.a5ede9fcdcf5bp-22, -0x1.f92cc52501c9p-26, 0x1.8837f040b59fap-30,
     0x1.6e314d46511c6p-40, -0x1.48ea79a10c50ep-37}, /* [40] 10 <= y <= 10.25, 56.7 bits */
    {0x1.7098ff9162967p-9, -0x1.f0be055aff9dfp-64, -0x1.062831f52e243p-9, 0x1.6f1c4c8a92e2bp-11, -0x1.4fc8a5ad6c9bap-13,
     0x1.c011fc6d872a5p-16, -0x1.cba20ad4f2484p-19, 0x1.7159e3c097de6p-22, -0x1.c85fe116fd30dp-26,
     0x1.82941e596dbf7p-30, -0x1.40a52be5a600bp-36, -0x1.c22a48e970206p-38}, /* [41] 10.25 <= y <= 10.5, 59.6 bits */
    {0x1.347ad63bd6676p-9, 0x1.7405284b07565p-69, -0x1.b7fc5b6402545p-10, 0x1.3521b4426ebdep-11, -0x1.1c0badd4c96c8p-13,
     0x1.7d6cfab8f9ea3p-16, -0x1.8ae53f9d72374p-19, 0x1.420bff1e905d3p-22, -0x1.98f1c19588fd6p-26,
     0x1.72f6eafc76cdep-30, -0x1.12ef7bb9faf1fp-35, -0x1.22815eca7b016p-38}, /* [42] 10.5 <= y <= 10.75, 60.2 bits */
    {0x1.020bb17e6bbf9p-9, 0x1.57f2c2978d367p-63, -0x1.710096e3bd15fp-10, 0x1.041c6229dc66cp-11, -0x1.e0115df02a424p-14,
     0x1.443a7e0295a5bp-16, -0x1.528c77116be92p-19, 0x1.17ce9c3f2455cp-22, -0x1.6be6a6b89253dp-26,
     0x1.5ce6579126d1fp-30, -0x1.59fc677a8a34fp-35, -0x1.53fe4673b6e8ap-39}, /* [43] 10.75 <= y <= 11, 57.2 bits */
    {0x1.af8503a858deap-10, 0x1.d28699debacdbp-65, -0x1.354bd893e2261p-10, 0x1.b56911c981936p-12,
     -0x1.954b155fed99cp-14, 0x1.133d89d204907p-16, -0x1.21ab7d2196aa4p-19, 0x1.e4aa8e62b6eabp-23,
     -0x1.41e0588f82d4fp-26, 0x1.430babdeb6dbdp-30, -0x1.8078893caa4cep-35, -0x1.43a1030349d48p-40},
     /* [44] 11 <= y <= 11.25, 57.4 bits */
    {0x1.68a688b347ca1p-10, 0x1.1f34c24ce747ap-65, -0x1.031c86376a403p-10, 0x1.6f875c4f5b984p-12,
     -0x1.55db006692a03p-14, 0x1.d2b9af7f36bf8p-17, -0x1.eecbada644be4p-20, 0x1.a28c2a2a5f9a2p-23,
     -0x1.1b36f56909c9cp-26, 0x1.275ef109f48edp-30, -0x1.8f26bb60bde7ap-35, -0x1.0a81d06b3f752p-42},
     /* [45] 11.25 <= y <= 11.5, 57.3 bits */
    {0x1.2d4b952a20a5p-10, 0x1.3c999b0e28fd3p-64, -0x1.b1ea57a4d40fap-11, 0x1.349c2382409dap-12, -0x1.2019bd64cf776p-14,
     0x1.8b4072c8204fcp-17, -0x1.a5e133023ea28p-20, 0x1.688126102b0e4p-23, -0x1.f019701b29fdcp-27,
     0x1.0b4bfc366197ep-30, -0x1.8ce7ba16e5077p-35, 0x1.c3ddfb6c69b11p-42}, /* [46] 11.5 <= y <= 11.75, 57.3 bits */
    {0x1.f737624ef26a6p-11, -0x1.f85759d4b1764p-66, -0x1.6b2516d3be8cep-11, 0x1.02f9b6340a175p-12,
     -0x1.e5343c37d912dp-15, 0x1.4e5b9031f3824p-17, -0x1.67264ab13f0ep-20, 0x1.35c591214ad3p-23, -0x1.b0bb000cae725p-27,
     0x1.dfa2ae765976fp-31, -0x1.7f0db44a12e42p-35, 0x1.d246652c7fd24p-41}, /* [47] 11.75 <= y <= 12, 57.4 bits */
    {0x1.a411aaf52cd34p-11, 0x1.1c46b451128a2p-68, -0x1.2fc614a62c24ep-11, 0x1.b263f17b7799bp-13,
     -0x1.9843e2be70f65p-15, 0x1.1a8e10bfce2cap-17, -0x1.314e29da6f111p-20, 0x1.099973c623164p-23,
     -0x1.7815af0bc4da4p-27, 0x1.ab33333c5d71fp-31, -0x1.69a6a2e04e2c9p-35, 0x1.3467a9de19b8ap-40}
     /* [48] 12 <= y <= 12.25, 58.5 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tsuji_time_of_max_overlap)

/* duration at zero force, weak damping: 21 rows of degree 10 in y = zeta^(1/5), nodes 0.03125 + i 0.0625, y < 1.3125.
 * Relative error of the approximation: 2^-58.0 at most, sampled at 25 places of each row. */
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_WEAK_FIRST 0.03125
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_WEAK_STEP 0.0625
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_WEAK_PER_UNIT 16.0
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_WEAK_ROWS 21
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_WEAK_END 1.3125
COR_ROWS(double, cor_rows_tsuji_duration_zero_force_weak, 21, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be982aef5bfbp+1, 0x1.45b1d9015f7a1p-55, -0x1.dd39bf6c5dff9p-13, -0x1.6364495d92f13p-7, -0x1.d31daace6c7e2p-3,
     -0x1.bee5a6fee7394p+0, 0x1.02c73db9e9f99p+0, -0x1.6a4ed73775dc5p-9, -0x1.2b3da3340dd15p-5, -0x1.149fdc5935f82p-2,
     -0x1.732fcd1c27138p-1, 0x1.81b6d131d22b8p+0}, /* [0] 0 <= y <= 0.0625, 71.1 bits */
    {0x1.9be4fd812b23ep+1, 0x1.0ba8dafb78871p-53, -0x1.819a3378ed6bdp-8, -0x1.7913fc880f887p-4, -0x1.40094828dd48ap-1,
     -0x1.6e3dd82e4c3c1p+0, 0x1.00893aca50e42p+0, -0x1.ddf26f319e12cp-5, -0x1.d626d83ca78acp-3, -0x1.a8aeed4981599p-2,
     0x1.a185cf80b6e84p-3, 0x1.70a977765e569p+0}, /* [1] 0.0625 <= y <= 0.125, 67.4 bits */
    {0x1.9bc778c6678ap+1, 0x1.cf491c37d17eep-56, -0x1.aa9912103018fp-6, -0x1.ec439f5eeb749p-3, -0x1.e35594087f792p-1,
     -0x1.1f8dd1524c50fp+0, 0x1.e9b31bf8c696dp-1, -0x1.9051036764f4bp-3, -0x1.787258a6cdc39p-2, -0x1.f2115bab6d7d7p-5,
     0x1.0437db32d71fap+0, 0x1.184d172a66726p+0}, /* [2] 0.125 <= y <= 0.1875, 65.2 bits */
    {0x1.9b6b4bd7ce274p+1, 0x1.8b08ea7dbec14p-56, -0x1.173a3ace4b554p-4, -0x1.c400b8510b6a5p-2, -0x1.304902a7a8afep+0,
     -0x1.ad83684d654efp-1, 0x1.b56dc31ffc343p-1, -0x1.5b18ce3438ee2p-2, -0x1.d1de76b4119a5p-3, 0x1.5470749bc81e9p-1,
     0x1.793ed9d6c5401p+0, 0x1.2240c26e485bep-2}, /* [3] 0.1875 <= y <= 0.25, 63.5 bits */
    {0x1.9a9d47a350a7bp+1, 0x1.76df0e45084a2p-55, -0x1.1ab0888bcb1a6p-3, -0x1.5d2605260cc12p-1, -0x1.5ddfe7e163447p+0,
     -0x1.2f868c3eff9cfp-1, 0x1.70ea1dac27d3dp-1, -0x1.57547276b6f5dp-2, 0x1.400ca290c5c98p-2, 0x1.79e5bc55d3a13p+0,
     0x1.43948061ca86fp+0, -0x1.0907baea2a6adp+0}, /* [4] 0.25 <= y <= 0.3125, 62.6 bits */
    {0x1.992018549dc1ep+1, 0x1.58791b1fe90bcp-53, -0x1.eb2426df8ea1cp-3, -0x1.e699760fa9654p-1, -0x1.7cf6f4cf68ab6p+0,
     -0x1.881b750140aacp-2, 0x1.4916df20faa44p-1, -0x1.f916cd2cbe08fp-7, 0x1.2fd20ab24eeb7p+0, 0x1.e921aaf231eb1p+0,
     0x1.54cb3c586008ap-4, -0x1.679fad8368281p+1}, /* [5] 0.3125 <= y <= 0.375, 62.5 bits */
    {0x1.96af3a41f9ebbp+1, -0x1.74afed2148c79p-53, -0x1.816911484adfdp-2, -0x1.3c9ed23aa5606p+0, -0x1.8edffe35a07cap+0,
     -0x1.5dcfa5960980fp-3, 0x1.850d65615826bp-1, 0x1.68a2855f25305p-1, 0x1.076c18a2be3a7p+1, 0x1.59f3bdf77143ep+0,
     -0x1.2504f0e411db7p+1, -0x1.2f9c52a0c1304p+2}, /* [6] 0.375 <= y <= 0.4375, 62.1 bits */
    {0x1.93019258cd366p+1, 0x1.ba97605ea0a32p-54, -0x1.19431ba7f5f57p-1, -0x1.87e8355cf1159p+0, -0x1.9107f556381cp+0,
     0x1.034f4830b9be1p-3, 0x1.34a9511823634p+0, 0x1.b087ad36a9378p+0, 0x1.21b5644518341p+1, -0x1.af3ad66b406b8p-1,
     -0x1.652f1e999e9bfp+2, -0x1.546af297dd45dp+2}, /* [7] 0.4375 <= y <= 0.5, 62.2 bits */
    {0x1.8dcc2453d7594p+1, 0x1.eaecf3d113d19p-56, -0x1.8485b25a8a1bcp-1, -0x1.d17a22b28c50bp+0, -0x1.7a77ead96ebep+0,
     0x1.3d7e4c6ff9504p-1, 0x1.00316008c846ep+1, 0x1.3a8c18ecc45e6p+1, 0x1.d5ecdc83319aap-1, -0x1.30c9c098b388ap+2,
     -0x1.f631356884698p+2, -0x1.554e93093b1bp-1}, /* [8] 0.5 <= y <= 0.5625, 61.7 bits */
    {0x1.86c5dd5ba991p+1, 0x1.088f3d87e0f34p-55, -0x1.00aee3df49bcp+0, -0x1.09a936272fcdap+1, -0x1.3ba50477e51eap+0,
     0x1.64319c3caa271p+0, 0x1.758b0082a8edcp+1, 0x1.172775fa25465p+1, -0x1.41c6e473922b3p+1, -0x1.1561300af7571p+3,
     -0x1.25225e4ba67cep+2, 0x1.8b1c177bc7795p+3}, /* [9] 0.5625 <= y <= 0.625, 59.7 bits */
    {0x1.7dadaa4e79e29p+1, -0x1.86501cdea528fp-59, -0x1.4663c15325b09p+0, -0x1.221c6b34d238fp+1, -0x1.864e968e5dbdep-1,
     0x1.3334091334119p+1, 0x1.b3fb3387810e3p+1, 0x1.66bf761405c38p-4, -0x1.c1881eb58a1cap+2, -0x1.06ac822afa1e7p+3,
     0x1.ebcd86bd8f37fp+2, 0x1.928e143ef9d22p+4}, /* [10] 0.625 <= y <= 0.6875, 59.3 bits */
    {0x1.7253a4e1425a6p+1, 0x1.36094b1aae492p-53, -0x1.9089dcb5bf7ep+0, -0x1.2c28c0f48ef0cp+1, -0x1.0e1dabb53ba8dp-5,
     0x1.b3755c4e01c3dp+1, 0x1.62bd6f45d1538p+1, -0x1.d28269f2fb0dcp+1, -0x1.2a02569855e4bp+3, 0x1.b5d9ad1824514p-2,
     0x1.5df81abcd94cep+4, 0x1.d643387fb8a9p+3}, /* [11] 0.6875 <= y <= 0.75, 60.0 bits */
    {0x1.64a4b13851858p+1, 0x1.86e872904213cp-53, -0x1.dac767b51e351p+0, -0x1.22023324f653dp+1, 0x1.ce6ab5f5d494cp-1,
     0x1.fd3508ddb4aaap+1, 0x1.61d90b9290a83p-1, -0x1.cc796eb39d80fp+2, -0x1.745e1d0e6b625p+2, 0x1.ac3a8c896466cp+3,
     0x1.3e59edd2922a8p+4, -0x1.71b8b8d517f71p+4}, /* [12] 0.75 <= y <= 0.8125, 58.9 bits */
    {0x1.54b5ac6e8d8dbp+1, -0x1.3ee1afe911042p-55, -0x1.0fc98cb34dcfp+1, -0x1.0067a2b844badp+1, 0x1.e323b1c852108p+0,
     0x1.de9e3a2f0aaa1p+1, -0x1.22892e5e8117cp+1, -0x1.fda014cbb3de3p+2, 0x1.6135367608a3fp+1, 0x1.2ab86782a536cp+4,
     -0x1.ca610c202d5b3p+1, -0x1.668c365521e7bp+5}, /* [13] 0.8125 <= y <= 0.875, 58.7 bits */
    {0x1.42c98db7cc02fp+1, -0x1.2b2731d292907p-54, -0x1.2c9140a1b96dap+1, -0x1.91a62c455a3a7p+0, 0x1.5935b66c9baeep+1,
     0x1.4d8ca7956cd1ap+1, -0x1.32a93e7fee79cp+2, -0x1.3b207a549602fp+2, 0x1.4bde036187b94p+3, 0x1.3614c9eaf2971p+3,
     -0x1.93c2d4ae71632p+4, -0x1.184694ac8d1f7p+4}, /* [14] 0.875 <= y <= 0.9375, 58.1 bits */
    {0x1.2f4e5f0b318e8p+1, 0x1.cfa666206ae6p-53, -0x1.41595fcb7a56cp+1, -0x1.03c9821924e4cp+0, 0x1.9251f22a744a3p+1,
     0x1.d4de35ad4f2b7p-1, -0x1.6d2fb4ba6454bp+2, 0x1.0033016f45f56p-3, 0x1.6eada7aa87262p+3, -0x1.450d712e8fc71p+2,
     -0x1.6b615da9363f6p+4, 0x1.6b759b705fc9p+4}, /* [15] 0.9375 <= y <= 1, 58.8 bits */
    {0x1.1ad05166a188ap+1, -0x1.ec21c2b21bbcbp-53, -0x1.4ccfcb97cbec9p+1, -0x1.abb3d9cb7524p-2, 0x1.93e865ffcb8fep+1,
     -0x1.8a39f182b56b2p-1, -0x1.34de400838673p+2, 0x1.0ce927e308046p+2, 0x1.a1984016299f6p+2, -0x1.9baef0716908ap+3,
     -0x1.099960dbf35d6p+2, 0x1.e4a7cce503ebdp+4}, /* [16] 1 <= y <= 1.0625, 59.6 bits */
    {0x1.05e695d58b3bap+1, 0x1.d283bb9e8f637p-55, -0x1.4ee6b8d62e7b7p+1, 0x1.296c07bd37af6p-3, 0x1.661f1bce4dc97p+1,
     -0x1.fd73c9293ce87p+0, -0x1.72341f8b9e284p+1, 0x1.69cdabbfe6a5cp+2, 0x1.2ee1ec8b6071fp-2, -0x1.58250c452e488p+3,
     0x1.311fa7388c065p+3, 0x1.777f3836f103dp+3}, /* [17] 1.0625 <= y <= 1.125, 58.0 bits */
    {0x1.e2401fdc4965ep+0, -0x1.f9dfad1fab559p-54, -0x1.48a75f0fdb20fp+1, 0x1.3c1b9a7d09ccfp-1, 0x1.1b772c4e25762p+1,
     -0x1.49003e4772012p+1, -0x1.bfc83c9d9fc3ep-1, 0x1.34fd67becfb51p+2, -0x1.c4282f6a7007ep+1, -0x1.1b3c6b684ccb1p+2,
     0x1.63b262c976cbcp+3, -0x1.31b5651476e5p+2}, /* [18] 1.125 <= y <= 1.1875, 58.7 bits */
    {0x1.b9ea15460827fp+0, -0x1.9a39579dee877p-54, -0x1.3bc7b20acfdd2p+1, 0x1.f14be1fa46abap-1, 0x1.8f309f17efccdp+0,
     -0x1.4c14c269660d8p+1, 0x1.360e4719fc486p-1, 0x1.80d62b5ebb51ep+1, -0x1.17f1d988f771ep+2, 0x1.2e330118b672p-1,
     0x1.914b5e3eaf3dep+2, -0x1.1d1d9fe0a884ep+3}, /* [19] 1.1875 <= y <= 1.25, 59.5 bits */
    {0x1.93802c432ca76p+0, 0x1.1e4366666df33p-59, -0x1.2a378a6ac9eaap+1, 0x1.347672a42c5c2p+0, 0x1.e4c2c43a9c8e7p-1,
     -0x1.21ee179749684p+1, 0x1.646a786da1aadp+0, 0x1.4227d6969d6cep+0, -0x1.b907cac1611bdp+1, 0x1.55b0754c8d0b7p+1,
     0x1.774162729bd8bp+0, -0x1.7b2378e3d6c99p+2} /* [20] 1.25 <= y <= 1.3125, 58.4 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tsuji_duration_zero_force_weak)

/* duration at zero force: 43 rows of degree 10 in y = ln(1 + zeta), nodes 1.625 + i 0.25, y < 12.25.
 * Relative error of the approximation: 2^-56.7 at most, sampled at 25 places of each row. */
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_FIRST 1.625
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_STEP 0.25
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_PER_UNIT 4.0
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_ROWS 43
#define COR_ROWS_TSUJI_DURATION_ZERO_FORCE_END 12.25
COR_ROWS(double, cor_rows_tsuji_duration_zero_force, 43, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.7a38155f05ae3p+0, 0x1.1575c4e1b39d8p-57, -0x1.7711308abadc8p-1, 0x1.1fb22794b7c3fp-3, -0x1.134458ffd024p-7,
     -0x1.f0f9f5b38a91dp-13, -0x1.e223cbaff3cf9p-11, 0x1.84c363fd5219bp-11, -0x1.98976b4c4798bp-12,
     0x1.932866fb64d4bp-13, -0x1.9a93409b05608p-14, 0x1.a88836a5f628dp-15}, /* [0] 1.5 <= y <= 1.75, 57.4 bits */
    {0x1.4d8c9d8fb3522p+0, 0x1.887545f8cc3cdp-55, -0x1.53ed2c4e6004cp-1, 0x1.1264350a35c01p-3, -0x1.27ba9cc8f6aefp-7,
     -0x1.c3c152e03a067p-11, -0x1.8afeb4d07a19ep-13, 0x1.3b320a6f9fd76p-12, -0x1.44ad539ed52bdp-13,
     0x1.19bde0bd0bed8p-14, -0x1.ed1a4ecf7f56bp-16, 0x1.b8897290e4de6p-17}, /* [1] 1.75 <= y <= 2, 57.8 bits */
    {0x1.252a482382d0bp+0, 0x1.8797844a839c7p-55, -0x1.3285c8e3d60f5p-1, 0x1.03d667266cb2ap-3, -0x1.455543887c768p-7,
     -0x1.cfc9b838c0ce4p-11, 0x1.be5264f137faap-14, 0x1.ec9fba62aad94p-14, -0x1.1ba9d572ddec6p-14,
     0x1.c3bec7bcbd1f5p-16, -0x1.5a56ff46223bdp-17, 0x1.0f01cc12828d2p-18}, /* [2] 2 <= y <= 2.25, 58.1 bits */
    {0x1.00d6d95b5dd1fp+0, -0x1.638ffac8a9f29p-55, -0x1.1305e1bf0376fp-1, 0x1.e7e856f1686d7p-4, -0x1.5f32d6ffb0f18p-7,
     -0x1.606bae305231ep-11, 0x1.bf0a621cf31cep-13, 0x1.294d990d767cp-15, -0x1.040a7e881fd08p-15, 0x1.91c0398906eaap-17,
     -0x1.13c51b5012b78p-18, 0x1.7deb3a6081b51p-20}, /* [3] 2.25 <= y <= 2.5, 56.9 bits */
    {0x1.c0a5c6e4307adp-1, -0x1.fd30a51b6935ap-56, -0x1.eb27661c2e81fp-2, 0x1.c617c56bfddddp-4, -0x1.709dbf534755cp-7,
     -0x1.9567b23321f14p-12, 0x1.eb945bf6ca9ccp-13, -0x1.2e7eaca75e61p-19, -0x1.da3d34c1b5364p-17,
     0x1.80ef58967fab6p-18, -0x1.e658ca3e65cfbp-20, 0x1.2d2c730856fd8p-21}, /* [4] 2.5 <= y <= 2.75, 62.4 bits */
    {0x1.86b5d4c57812bp-1, 0x1.e6336c4de8678p-55, -0x1.b4927ec55e281p-2, 0x1.a316f47d973f9p-4, -0x1.788fce041e9c9p-7,
     -0x1.ac32ded3b906p-14, 0x1.c6804c56fb0f9p-13, -0x1.3d93a3d62843cp-16, -0x1.89b3b5758911fp-18,
     0x1.8266a3d8b012cp-19, -0x1.d19552343bcacp-21, 0x1.0541168a7b7e8p-22}, /* [5] 2.75 <= y <= 3, 58.1 bits */
    {0x1.53522366e56abp-1, 0x1.f307f45d33f6cp-55, -0x1.82651014d3424p-2, 0x1.7fc3913877c39p-4, -0x1.77af1d0948c99p-7,
     0x1.3788b1b7573eep-13, 0x1.7f4efc400effap-13, -0x1.a574883f3f43fp-16, -0x1.c1bea148229b6p-20,
     0x1.8a68e43d1c24ep-20, -0x1.db1ab772654a6p-22, 0x1.eb67c33dab08p-24}, /* [6] 3 <= y <= 3.25, 57.8 bits */
    {0x1.25eda6d550ccp-1, -0x1.7c292e756e69p-55, -0x1.549ccffd22acdp-2, 0x1.5ce1f06ac4308p-4, -0x1.6f55e02697253p-7,
     0x1.720c9f6bf798fp-12, 0x1.2df79c357af61p-13, -0x1.b3da8ba723a67p-16, 0x1.e46b0345aa015p-22, 0x1.89db0c0e54433p-21,
     -0x1.fbe7d624e3861p-23, 0x1.ee867d21dbd55p-25}, /* [7] 3.25 <= y <= 3.5, 61.2 bits */
    {0x1.fbfa1c3793decp-2, 0x1.0af6fc8f9ffa7p-56, -0x1.2b2117f7032c3p-2, 0x1.3b12aa918eb01p-4, -0x1.6115d93c8a58p-7,
     0x1.0ad749ee4c184p-11, 0x1.bd3b452cd5f79p-14, -0x1.95912f2d7a833p-16, 0x1.8d379d1da0f36p-20, 0x1.6721b88aadd96p-22,
     -0x1.178bde3e3673p-23, 0x1.072603c614c31p-25}, /* [8] 3.5 <= y <= 3.75, 58.5 bits */
    {0x1.b5f28a25c117ep-2, 0x1.39682d56d711ep-56, -0x1.05c78ae1477e3p-2, 0x1.1ad0b07429ee8p-4, -0x1.4e7964c07b6d5p-7,
     0x1.44fdbbba54fd3p-11, 0x1.2e4721f84bbdbp-14, -0x1.62c9864a3318cp-16, 0x1.ffa88d6f844dcp-20, 0x1.e6d6649625437p-24,
     -0x1.36d5b5def23e1p-24, 0x1.25280ce928fb3p-26}, /* [9] 3.75 <= y <= 4, 57.1 bits */
    {0x1.78c2c1e3f5f31p-2, -0x1.d3b9fcb0cd92dp-58, -0x1.c8b1593b8587cp-3, 0x1.f8e734453a1e9p-5, -0x1.38e4e59599902p-7,
     0x1.6a62ecfae184ap-11, 0x1.680465b03cefbp-15, -0x1.28e073c4e3dcfp-16, 0x1.0c311e122824cp-19,
     -0x1.36e7a026a554ap-27, -0x1.544a444b6ba28p-25, 0x1.52bc62cace713p-27}, /* [10] 4 <= y <= 4.25, 58.6 bits */
    {0x1.43780041bb56p-2, -0x1.2d8df09a7e79p-56, -0x1.8d281828f30c9p-3, 0x1.c067d7103b9afp-5, -0x1.2189cf15c0cbap-7,
     0x1.7e62704d8234cp-11, 0x1.3e4c2147a0978p-16, -0x1.de729cf905c25p-17, 0x1.000100d94963ep-19,
     -0x1.40786b45981c7p-24, -0x1.5f2c786553897p-26, 0x1.920f7312f10d4p-28}, /* [11] 4.25 <= y <= 4.5, 63.0 bits */
    {0x1.15305be68b567p-2, -0x1.d40bd6875b175p-56, -0x1.5867ad99494ebp-3, 0x1.8c601f8a25dbap-5, -0x1.09636acbc7f9bp-7,
     0x1.845832a8d236bp-11, 0x1.c3e38ca5ed5d5p-27, -0x1.73947fe240862p-17, 0x1.ce3aee973d2aep-20,
     -0x1.c99bbd8d2ba4dp-24, -0x1.34494d75882a1p-27, 0x1.e43cb9808a125p-29}, /* [12] 4.5 <= y <= 4.75, 58.5 bits */
    {0x1.da3778098663ap-3, 0x1.86542b591a554p-57, -0x1.29df96ae9b536p-3, 0x1.5ce2b71e11325p-5, -0x1.e271e1bd69e78p-8,
     0x1.7f6355b04e084p-11, -0x1.e457e61c0b27dp-17, -0x1.1507a0d0ca40cp-17, 0x1.91317c5a74789p-20,
     -0x1.fbea3576dd5dep-24, -0x1.1b93dbefdde19p-29, 0x1.22bd18f34ed5p-29}, /* [13] 4.75 <= y <= 5, 58.2 bits */
    {0x1.94f84c3aee7ebp-3, 0x1.744c988a42201p-57, -0x1.00ff206760eabp-3, 0x1.31e17066efd6fp-5, -0x1.b344c9f93515ep-8,
     0x1.724818db31b55p-11, -0x1.a2c750826f913p-16, -0x1.8880484a87ed6p-18, 0x1.516780eb2cad7p-20,
     -0x1.fa22e38b2fe5p-24, 0x1.1851f6a215fe5p-29, 0x1.52af33ca08aa2p-30}, /* [14] 5 <= y <= 5.25, 57.4 bits */
    {0x1.594b101d801ffp-3, -0x1.0d66deacdfd22p-57, -0x1.ba71f5917236p-4, 0x1.0b359124e8aaap-5, -0x1.861d66d9d593ap-8,
     0x1.5f6458f963115p-11, -0x1.0dffa42ae0384p-15, -0x1.027c3d2ed1357p-18, 0x1.13e9de7d2bcefp-20,
     -0x1.da01163a0d26ep-24, 0x1.2b73d500bf5fbp-28, 0x1.6c21880b27353p-31}, /* [15] 5.25 <= y <= 5.5, 57.8 bits */
    {0x1.25fa3f112e4ccp-3, -0x1.d50ae4b369abp-57, -0x1.7c0bab4b4925ep-4, 0x1.d14dd79427c7p-6, -0x1.5b944af1d7679p-8,
     0x1.48af2fc5246d1p-11, -0x1.33f04bea9c45p-15, -0x1.2ca2dbb9b0c1ap-19, 0x1.b7285ce20c06dp-21,
     -0x1.a98036e245dcdp-24, 0x1.7b010a4609843p-28, 0x1.3e7cbe22a721fp-32}, /* [16] 5.5 <= y <= 5.75, 57.7 bits */
    {0x1.f3e26d37bb616p-4, -0x1.31407d7f3d551p-59, -0x1.45cc5af2edbeap-4, 0x1.93e38cb03af96p-6, -0x1.340946270d908p-8,
     0x1.2fbf10aacaa15p-11, -0x1.47d22e8154711p-15, -0x1.058d735582461p-20, 0x1.53abeb74e8c06p-21,
     -0x1.71c139c60d79dp-24, 0x1.966da14a6b942p-28, 0x1.9e7b179c14359p-35}, /* [17] 5.75 <= y <= 6, 58.9 bits */
    {0x1.a874378dfec61p-4, 0x1.83122d0bfed31p-58, -0x1.16c6db717f037p-4, 0x1.5d9740527c65fp-6, -0x1.0faee6be029d1p-8,
     0x1.15d36b7286ae7p-11, -0x1.4db90a96eaa27p-15, -0x1.58ed3d5e3e555p-27, 0x1.fcc432f892ce9p-22,
     -0x1.38b3b686aba9p-24, 0x1.9050d572004ccp-28, -0x1.d274827da18fbp-34}, /* [18] 6 <= y <= 6.25, 58.5 bits */
    {0x1.67f7133406857p-4, -0x1.88da15706fba9p-58, -0x1.dc422c20d50c3p-5, 0x1.2dcde624671c4p-6, -0x1.dd2950e49efap-9,
     0x1.f7bfce1892dcep-12, -0x1.4924949c0d472p-15, 0x1.776d59de4bde4p-21, 0x1.6e39b418f56d6p-22,
     -0x1.0217db3e02cf8p-24, 0x1.7595b38f5735fp-28, -0x1.b020267f91255p-33}, /* [19] 6.25 <= y <= 6.5, 58.2 bits */
    {0x1.30ec4da2243fcp-4, -0x1.f16b3e85217ebp-58, -0x1.9628cf7f0d8c3p-5, 0x1.03ec227c54c5ap-6, -0x1.a15f682be6c89p-9,
     0x1.c52fe81e304dbp-12, -0x1.3d01f431b15bep-15, 0x1.4193f918312c4p-20, 0x1.f3c7a83ec8a86p-23,
     -0x1.a04c05f778e8cp-25, 0x1.4f5484dc3c686p-28, -0x1.0af5ec16f9dp-32}, /* [20] 6.5 <= y <= 6.75, 58.6 bits */
    {0x1.020473ac0d54ep-4, 0x1.e727179e3457cp-61, -0x1.59dac765ad1d9p-5, 0x1.beb50927821e6p-7, -0x1.6bc464ddbd76ap-9,
     0x1.94f3d89501fa2p-12, -0x1.2bb5180e5c214p-15, 0x1.99cdae0bd479cp-20, 0x1.3a35a9b31d957p-23,
     -0x1.480619a8b312bp-25, 0x1.23e9d271dd14p-28, -0x1.1c4193a709bf9p-32}, /* [21] 6.75 <= y <= 7, 59.7 bits */
    {0x1.b4352fead59f6p-5, -0x1.45d04846d47d4p-60, -0x1.261646a95679dp-5, 0x1.7f11037b74a19p-7, -0x1.3c0291de0a7dcp-9,
     0x1.67b28dc59b7c2p-12, -0x1.17267464f041fp-15, 0x1.ce09a339a2545p-20, 0x1.535cec8569904p-24,
     -0x1.f854c25183594p-26, 0x1.ef566c48edc57p-29, -0x1.17262e85a6cedp-32}, /* [22] 7 <= y <= 7.25, 57.6 bits */
    {0x1.705f9fd7062fap-5, -0x1.b3ef40b5b08e3p-59, -0x1.f3791e262c25dp-6, 0x1.47dcdd6e3bad4p-7, -0x1.11b3c4486556p-9,
     0x1.3dcf44052b9e6p-12, -0x1.00d2c7ed03395p-15, 0x1.e694609109956p-20, 0x1.e00870c062e8dp-26,
     -0x1.790d9b7276128p-26, 0x1.9ad183d1d8ec3p-29, -0x1.0408dae0a608fp-32}, /* [23] 7.25 <= y <= 7.5, 58.7 bits */
    {0x1.36cdee6546353p-5, -0x1.fbc4ffcfc8664p-59, -0x1.a79f20307d7bcp-6, 0x1.181d5a7f189f8p-7, -0x1.d8d1a3d720ec1p-10,
     0x1.17791601949e6p-12, -0x1.d3b68c8c5313bp-16, 0x1.ea65bb4f5d98ap-20, -0x1.4bf409d070e8ap-27,
     -0x1.10939083ef543p-26, 0x1.4da122c794a53p-29, -0x1.d231d93482149p-33}, /* [24] 7.5 <= y <= 7.75, 57.6 bits */
    {0x1.060186265f68p-5, -0x1.f14ba3d8ffa95p-60, -0x1.66de9d631db5ap-6, 0x1.ddd8f2b7ea40bp-8, -0x1.975e7b8887c09p-10,
     0x1.e97021f8182adp-13, -0x1.a62a2ffc97e21p-16, 0x1.df371fd7bcad8p-20, -0x1.37f603584a57dp-25,
     -0x1.7920a3a12fbcep-27, 0x1.097c0f7d9128ep-29, -0x1.95820e3998a92p-33}, /* [25] 7.75 <= y <= 8, 58.7 bits */
    {0x1.b960aa14bc5f9p-6, 0x1.ff9ce231a7abap-62, -0x1.2fae710662a63p-6, 0x1.96f3531f89f89p-8, -0x1.5e2acf67cb62bp-10,
     0x1.aaefeb13c44f8p-13, -0x1.7a2f1981e946fp-16, 0x1.c9a3d5d9041ecp-20, -0x1.d20e31ba8c36bp-25,
     -0x1.e979cd87bc17fp-28, 0x1.9de408ac03935p-30, -0x1.580a6c6d5693dp-33}, /* [26] 8 <= y <= 8.25, 57.5 bits */
    {0x1.737c8f1a2527cp-6, -0x1.898e463d84319p-63, -0x1.00b6f72eb2911p-6, 0x1.5a12acb182216p-8, -0x1.2c5b0c9695ec3p-10,
     0x1.7321c0ffa23edp-13, -0x1.509155e4d746fp-16, 0x1.ad4dbccdaa531p-20, -0x1.18decdc5d179fp-24,
     -0x1.1d37602beddd3p-28, 0x1.3b9d70416a453p-30, -0x1.1da8ca636c54dp-33}, /* [27] 8.25 <= y <= 8.5, 58.9 bits */
    {0x1.386ed6e2bbefbp-6, 0x1.6692a49d45e44p-60, -0x1.b199d296768b2p-7, 0x1.25e7f57ca3c3ep-8, -0x1.011f52d74527ap-10,
     0x1.419c40a62aad5p-13, -0x1.29cffe7cfe7dbp-16, 0x1.8d02ba9fc84dp-20, -0x1.326d02c13cecbp-24,
     -0x1.067d66d596193p-29, 0x1.d594f5ddff01fp-31, -0x1.d1395d0757aacp-34}, /* [28] 8.5 <= y <= 8.75, 57.7 bits */
    {0x1.0695658eb7ae3p-6, -0x1.3077c329ef80fp-61, -0x1.6dd90047864c1p-7, 0x1.f293a027d36a8p-9, -0x1.b76bef3ad480ap-11,
     0x1.15e6f97e30605p-13, -0x1.062f6708f0ce4p-16, 0x1.6ae06d8480e9bp-20, -0x1.3b632cd8639adp-24,
     -0x1.2406bcf6e27adp-32, 0x1.531d51333f064p-31, -0x1.73f809b692a6ep-34}, /* [29] 8.75 <= y <= 9, 58.0 bits */
    {0x1.b915361950a9dp-7, -0x1.784f7c4d92fa7p-67, -0x1.3469d50addbd4p-7, 0x1.a66379c9a6ac9p-9, -0x1.76d9c3d7a559cp-11,
     0x1.df04cd9252dfp-14, -0x1.cb902d9a551a5p-17, 0x1.4874b3590976cp-20, -0x1.385a6896674a7p-24, 0x1.efa5deb05b43p-31,
     0x1.d76262f1d83c5p-32, -0x1.2421d97a5457p-34}, /* [30] 9 <= y <= 9.25, 58.1 bits */
    {0x1.723a3a3f2e041p-7, -0x1.d36d037e969adp-61, -0x1.03c841d64c09p-7, 0x1.6572400d7021ep-9, -0x1.3f441403619e8p-11,
     0x1.9bdb99112a8a5p-14, -0x1.9125c53b9016p-17, 0x1.26da522caf7e4p-20, -0x1.2cf86ad54ac7ep-24, 0x1.d197ac07ae58ap-30,
     0x1.365786abd2f41p-32, -0x1.c288e491d47a6p-35}, /* [31] 9.25 <= y <= 9.5, 56.7 bits */
    {0x1.369140fabcb9p-7, 0x1.0125a4fe9163fp-63, -0x1.b54c64f7baedep-8, 0x1.2e2c7dcd19b81p-9, -0x1.0f86b302b4444p-11,
     0x1.6156c7256b9fp-14, -0x1.5ce50ffc8934bp-17, 0x1.06d18d25418e5p-20, -0x1.1c149f992a612p-24, 0x1.2deaf52e31fa5p-29,
     0x1.7699f06645c71p-33, -0x1.54a51aa12fb42p-35}, /* [32] 9.5 <= y <= 9.75, 58.7 bits */
    {0x1.045f3206abcb4p-7, -0x1.08c7d27a613dbp-61, -0x1.6fc96818d3084p-8, 0x1.fe653c16c522fp-10, -0x1.cd387102f918dp-12,
     0x1.2e8661fd95191p-14, -0x1.2e765491f23cep-17, 0x1.d1a9871dd5e26p-21, -0x1.07db2c4c929c9p-24,
     0x1.54f4314e37602p-29, 0x1.7ce6962166dcdp-34, -0x1.f7c2753561c46p-36}, /* [33] 9.75 <= y <= 10, 57.4 bits */
    {0x1.b456e60abaa32p-8, -0x1.f602723a6680cp-65, -0x1.351ba7167ce4ep-8, 0x1.aea69bfbf30c1p-10, -0x1.87389d6e6c604p-12,
     0x1.0289acacb22e7p-14, -0x1.05701afad4c9bp-17, 0x1.9a52d239055bbp-21, -0x1.e3d91b979a29bp-25,
     0x1.65b9f1bd99885p-29, 0x1.bf80c8554d97fp-36, -0x1.6aa36d20eca5bp-36}, /* [34] 10 <= y <= 10.25, 60.0 bits */
    {0x1.6d6cb2cfcbd8cp-8, -0x1.3d8d28e8d395bp-62, -0x1.039e55c8f1345p-8, 0x1.6b0c734c2f1adp-10, -0x1.4b734d4013f78p-12,
     0x1.b922693d3a4cap-15, -0x1.c2bf865360b2fp-18, 0x1.67db7f56313abp-21, -0x1.b6f27f248d09ep-25,
     0x1.6674e802a021dp-29, -0x1.3b4a01d43878ep-36, -0x1.f8650487638e7p-37}, /* [35] 10.25 <= y <= 10.5, 57.8 bits */
    {0x1.31e1c920d560cp-8, 0x1.556a70d08b603p-63, -0x1.b3d43fd382892p-9, 0x1.31ce5f27b501ap-10, -0x1.187f7af0a0d4ep-12,
     0x1.77bf76aca92c9p-15, -0x1.839f9bba34f86p-18, 0x1.3a4787b63924p-21, -0x1.8ab2a2c4a1c32p-25, 0x1.5c043e33894b2p-29,
     -0x1.a15d5d241f9dap-35, -0x1.4e40cf395685fp-37}, /* [36] 10.5 <= y <= 10.75, 59.2 bits */
    {0x1.ffd66546a9145p-9, -0x1.17c26006428abp-65, -0x1.6d99614fd878ap-9, 0x1.016362efb6f27p-10, -0x1.da424c697196cp-13,
     0x1.3f949555e4006p-15, -0x1.4c98a71e72c57p-18, 0x1.1173789c817b4p-21, -0x1.60403694bf6d2p-25,
     0x1.4a292fd9f7c64p-29, -0x1.240cd4c40f697p-34, -0x1.9ac69284c1119p-38}, /* [37] 10.75 <= y <= 11, 57.1 bits */
    {0x1.ac096d425dba2p-9, 0x1.8352593090202p-64, -0x1.328290c62d1c1p-9, 0x1.b0f3c8725303cp-11, -0x1.90899ef17001dp-13,
     0x1.0f6f67ed60f2cp-15, -0x1.1ccc2229f0c97p-18, 0x1.da434e4a41484p-22, -0x1.3858d3a43e92ep-25,
     0x1.33bc3a463c3cfp-29, -0x1.5482d74921aa3p-34, -0x1.b66bb5fb7c83ap-39}, /* [38] 11 <= y <= 11.25, 58.7 bits */
    {0x1.65cc90d74e281p-9, 0x1.4e6bf1da5ab33p-64, -0x1.00d48b042ee1ap-9, 0x1.6be0f76df9514p-11, -0x1.51f641c34f7efp-13,
     0x1.cc7eafd234e41p-16, -0x1.e6d17c13f8b9cp-19, 0x1.9a0866d9c58f7p-22, -0x1.136b1f16fc853p-25,
     0x1.1adb34a5074a9p-29, -0x1.6b49e99850d7fp-34, -0x1.3fc6f443f0cfap-40}, /* [39] 11.25 <= y <= 11.5, 58.1 bits */
    {0x1.2af5efbc996b5p-9, -0x1.622bb84327042p-68, -0x1.ae2e19930a6bap-10, 0x1.319f211f8ad44p-11,
     -0x1.1ce9b16d5b99ep-13, 0x1.8626a42b0bebbp-16, -0x1.9f5962d2a9c1dp-19, 0x1.6188f8c6b1cp-22, -0x1.e35737f0ba364p-26,
     0x1.0110597eb674bp-29, -0x1.6fa05311b4162p-34, 0x1.289efba1ccd5ap-42}, /* [40] 11.5 <= y <= 11.75, 57.3 bits */
    {0x1.f364c34e35988p-10, 0x1.638b389d41c0cp-64, -0x1.68162fd4cba56p-10, 0x1.0087614cb2a44p-11,
     -0x1.dffc0399c4e08p-14, 0x1.4a2e807cab20ep-16, -0x1.61cda687d1ec6p-19, 0x1.30111a174600ep-22,
     -0x1.a64a0dec9660fp-26, 0x1.cee57127d01d6p-30, -0x1.6722a27162d31p-34, 0x1.569cd4383fd97p-40},
     /* [41] 11.75 <= y <= 12, 58.5 bits */
    {0x1.a0f0710c637b9p-10, 0x1.6bb0ddbb4cb84p-68, -0x1.2d4518a2022f2p-10, 0x1.ae625b0ee0e32p-12,
     -0x1.93fde549ba5ecp-14, 0x1.1722d1cae08c3p-16, -0x1.2cedb19b57d27p-19, 0x1.04ede9dc7b58bp-22,
     -0x1.6f8a08bbeedb4p-26, 0x1.9d8181bcff3d5p-30, -0x1.561a415a88cap-34, 0x1.01f9e453f313p-39}
     /* [42] 12 <= y <= 12.25, 56.7 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tsuji_duration_zero_force)

/* duration with the limited damper, weak damping: 42 rows of degree 10 in y = zeta^(1/5), nodes 0.015625 + i 0.03125, y < 1.3125.
 * Relative error of the approximation: 2^-58.8 at most, sampled at 25 places of each row. */
#define COR_ROWS_TSUJI_DURATION_LIMITED_WEAK_FIRST 0.015625
#define COR_ROWS_TSUJI_DURATION_LIMITED_WEAK_STEP 0.03125
#define COR_ROWS_TSUJI_DURATION_LIMITED_WEAK_PER_UNIT 32.0
#define COR_ROWS_TSUJI_DURATION_LIMITED_WEAK_ROWS 42
#define COR_ROWS_TSUJI_DURATION_LIMITED_WEAK_END 1.3125
COR_ROWS(double, cor_rows_tsuji_duration_limited_weak, 42, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9be990b74b654p+1, -0x1.2dd291c34b68fp-54, -0x1.e247cdc50edffp-16, -0x1.6872567b5bbc4p-9, -0x1.dd39be87071d2p-4,
     -0x1.d31da14c30bf6p+0, 0x1.02cf553b5d885p+0, -0x1.8efe5c3d6dcafp-12, -0x1.552abeb7fb99cp-7, -0x1.5383083e62011p-3,
     -0x1.295fc4328e776p+0, 0x1.c41de6a66efb7p-3}, /* [0] 0 <= y <= 0.03125, 74.9 bits */
    {0x1.9be9467b31329p+1, 0x1.32a44192074cbp-53, -0x1.8e64e3cfbad36p-11, -0x1.8a2114dc2c2f3p-6, -0x1.56c1667904e32p-2,
     -0x1.aaaf5632936dbp+0, 0x1.02a10ed9f32b4p+0, -0x1.4bc2b361d5b85p-7, -0x1.785b5773ff66fp-4, -0x1.ee555145a9acp-2,
     -0x1.1792c1b4244ccp+0, 0x1.d05deb23cade1p-3}, /* [1] 0.03125 <= y <= 0.0625, 71.7 bits */
    {0x1.9be7577301e7p+1, -0x1.77e9df90e4406p-53, -0x1.c33bb04656408p-9, -0x1.09ce2c663caep-4, -0x1.1100b7a1400d7p-1,
     -0x1.8258b35e6c9f5p+0, 0x1.016a99d83c57fp+0, -0x1.7a496aaadf63cp-5, -0x1.001db876913efp-2, -0x1.8f21a6499a03cp-1,
     -0x1.0429a733a9cep+0, 0x1.13183e832bcp-2}, /* [2] 0.0625 <= y <= 0.09375, 69.4 bits */
    {0x1.9be1290c65bbep+1, -0x1.bf3727dfb473p-53, -0x1.2ec7647c890b3p-7, -0x1.f98622c45e645p-4, -0x1.6c94c799fd97p-1,
     -0x1.5a618a2cf2d5dp+0, 0x1.fb07b01c78075p-1, -0x1.fefdc8c218b74p-4, -0x1.eb2c237e23341p-2, -0x1.0d54325fd439bp+0,
     -0x1.d3d628633fbfdp-1, 0x1.a5662fa84052fp-2}, /* [3] 0.09375 <= y <= 0.125, 67.8 bits */
    {0x1.9bd2fee6a50fcp+1, 0x1.93bd503343e95p-54, -0x1.3a943e0212304p-6, -0x1.951a17ef87154p-3, -0x1.be45e85d97f1fp-1,
     -0x1.336319da533acp+0, 0x1.e90acc546c8f4p-1, -0x1.0af44e6229df5p-2, -0x1.8bcf1aaea9907p-1, -0x1.497846b9f2357p+0,
     -0x1.79928a947a261p-1, 0x1.865ba3673d839p-1}, /* [4] 0.125 <= y <= 0.15625, 67.4 bits */
    {0x1.9bb818b8e70c4p+1, -0x1.962ec900dd0d4p-53, -0x1.18a5ddaab7eeep-5, -0x1.25232d7ecff02p-2, -0x1.03384d550888p+0,
     -0x1.0e64716e0218bp+0, 0x1.c6bad2ba3a6a4p-1, -0x1.ddea532eab445p-2, -0x1.1e114d9eb25b4p+0, -0x1.73cf93373a415p+0,
     -0x1.98660a26723aep-2, 0x1.7b845e4d47cefp+0}, /* [5] 0.15625 <= y <= 0.1875, 66.2 bits */
    {0x1.9b8acf702aa71p+1, -0x1.5c2176093d6dbp-54, -0x1.c48a6f5b7ad3ep-5, -0x1.8c6989819fb36p-2, -0x1.22e1b8018e4ep+0,
     -0x1.d9e517db73967p-1, 0x1.8ce7228556f96p-1, -0x1.80cc2243dcfd7p-1, -0x1.7cfa9ef7f793p+0, -0x1.7bb977a10e876p+0,
     0x1.02f21b3ceae43p-2, 0x1.68705a74925f4p+1}, /* [6] 0.1875 <= y <= 0.21875, 65.8 bits */
    {0x1.9b44b0bcaa55cp+1, 0x1.17a35b9eedd43p-56, -0x1.5374ee77baf0dp-4, -0x1.fed0ec3e25956p-2, -0x1.3eb162f1a072bp+0,
     -0x1.a26117e7588dcp-1, 0x1.33db5628c494ep-1, -0x1.1dcb07d8e5d7p+0, -0x1.d690df56d9179p+0, -0x1.4285bda4d8d21p+0,
     0x1.773ef8ca1a349p+0, 0x1.4a143320e3fe3p+2}, /* [7] 0.21875 <= y <= 0.25, 64.7 bits */
    {0x1.9ade97e2e4f58p+1, 0x1.43b7a2f530632p-53, -0x1.e27f49ad03e12p-4, -0x1.3d877caf30d32p-1, -0x1.57877062fb632p+0,
     -0x1.7bb1c591b1157p-1, 0x1.68c954090a908p-2, -0x1.8c4aada68c8e3p+0, -0x1.0a36fda16d47ep+1, -0x1.24afe07899edep-1,
     0x1.d3564da77f6a8p+1, 0x1.25d7e8a9221dbp+3}, /* [8] 0.25 <= y <= 0.28125, 66.1 bits */
    {0x1.9a50c235c9c7ep+1, -0x1.12861c5d8d2a6p-56, -0x1.48dd6c5bd2609p-3, -0x1.801f67a1b0a7fp-1, -0x1.6ea391e90fc2ap+0,
     -0x1.6c445b68a216ap-1, 0x1.36ad22b94ee69p-6, -0x1.00ebff6292556p+1, -0x1.072463d189449p+1, 0x1.e2bfefd71e709p-1,
     0x1.dfe40def382c3p+2, 0x1.007073bba70c6p+4}, /* [9] 0.28125 <= y <= 0.3125, 65.0 bits */
    {0x1.9992dd31911e4p+1, 0x1.e291ba72702dcp-53, -0x1.b1aaca074df21p-3, -0x1.c703a4deb343ap-1, -0x1.85b058a091decp+0,
     -0x1.7ae145f73fb07p-1, -0x1.966e678cc4006p-2, -0x1.3444fc30849a5p+1, -0x1.7d4fb947dff5p+0, 0x1.f2cfaf1b82204p+1,
     0x1.c4639a11fecf3p+3, 0x1.b5a25ecf58b3dp+4}, /* [10] 0.3125 <= y <= 0.34375, 64.0 bits */
    {0x1.989c0bd814332p+1, 0x1.87ff8caa519b2p-54, -0x1.165f353bd2c19p-2, -0x1.0930c386f27c5p+0, -0x1.9ebf88545fbfap+0,
     -0x1.ad58ab97bfbc5p-1, -0x1.bdaa24b782a1fp-1, -0x1.4aed4a9f90febp+1, 0x1.85594e2095bb9p-4, 0x1.29847c8a3a7c6p+3,
     0x1.93b0c17dd601p+4, 0x1.656bc3a3eca95p+5}, /* [11] 0.34375 <= y <= 0.375, 62.6 bits */
    {0x1.9762e0d8a21bap+1, -0x1.79a4185a6c08cp-54, -0x1.5da3af9e404b4p-2, -0x1.31688a676f29cp+0, -0x1.bc28347c8357dp+0,
     -0x1.02f9701b1e28ap+0, -0x1.557edee32558dp+0, -0x1.1e3450901520fp+1, 0x1.be7a0bf11ea5bp+1, 0x1.2a89385ba1c0ap+4,
     0x1.54696e16f015p+5, 0x1.0955589c61ec7p+6}, /* [12] 0.375 <= y <= 0.40625, 63.9 bits */
    {0x1.95dd4b7e203d4p+1, -0x1.55430d8e0a7dcp-54, -0x1.af546ddf75df2p-2, -0x1.5cad5e719cc55p+0, -0x1.e02ca869556fap+0,
     -0x1.3f66a56db7f19p+0, -0x1.a4e7a5bed731fp+0, -0x1.adee109346d55p-1, 0x1.3d0b100571004p+3, 0x1.0e5b5297940a3p+5,
     0x1.07272a68e1fb8p+6, 0x1.3982fbe69ef2p+6}, /* [13] 0.40625 <= y <= 0.4375, 64.6 bits */
    {0x1.940076d25da3ap+1, 0x1.6f7d53ada085ep-53, -0x1.062525cc3a235p-1, -0x1.8bb1dbcdd8509p+0, -0x1.061eceb5636e2p+1,
     -0x1.80f665ceaa262p+0, -0x1.883d594e19ee2p+0, 0x1.37be4e057f54ap+1, 0x1.4f12f131a802p+4, 0x1.bba1536133d88p+5,
     0x1.5769ad1419a1cp+6, 0x1.101029b755186p+5}, /* [14] 0.4375 <= y <= 0.46875, 64.1 bits */
    {0x1.91c09daa36a6p+1, 0x1.c14b01aa90dfp-54, -0x1.3ac6ae9819645p-1, -0x1.bf347ac0a6af6p+0, -0x1.1fcda2da9a87cp+1,
     -0x1.ae5bf63aa1faep+0, -0x1.14e9bb441d3abp-1, 0x1.1829a7c96aff5p+3, 0x1.2ea37785fc351p+5, 0x1.3be6dd11802dbp+6,
     0x1.171d7d6b491c3p+6, -0x1.63cfd88d1eb78p+7}, /* [15] 0.46875 <= y <= 0.5, 61.8 bits */
    {0x1.8f10dca0f41cfp+1, -0x1.4c011b949546p-54, -0x1.7627a5b085f82p-1, -0x1.f7b17e4a36472p+0, -0x1.3a8380b9bf56ep+1,
     -0x1.9769688c6a1c9p+0, 0x1.02523128794a8p+1, 0x1.35181b7e4f809p+4, 0x1.d81828f6a2b57p+5, 0x1.51dd170c3a937p+6,
     -0x1.ec23be9ae71e5p+5, -0x1.6e6fc4e851033p+9}, /* [16] 0.5 <= y <= 0.53125, 62.2 bits */
    {0x1.8be3160f2244p+1, 0x1.d4a187eeaf179p-56, -0x1.b8e512375dbbap-1, -0x1.1a681e2a48ec6p+1, -0x1.4fad01cc84a86p+1,
     -0x1.d986d54d43e4bp-1, 0x1.beca99d480423p+2, 0x1.119e707497941p+5, 0x1.2a358aa202c3bp+6, 0x1.69d57f2d7a016p+4,
     -0x1.af15865534098p+8, -0x1.a1f00e4bcd501p+10}, /* [17] 0.53125 <= y <= 0.5625, 62.2 bits */
    {0x1.88280d2ae8d01p+1, 0x1.8a92b07245831p-54, -0x1.01bbd93984a2ep+0, -0x1.3a3a88fef9377p+1, -0x1.52c1be75ca621p+1,
     0x1.7e04734872aa4p-1, 0x1.dcae589336394p+3, 0x1.8d40c47026625p+5, 0x1.d15aa4bb00193p+5, -0x1.7022ee417150bp+7,
     -0x1.0b90bc40c721p+10, -0x1.1327284e73c32p+11}, /* [18] 0.5625 <= y <= 0.59375, 61.2 bits */
    {0x1.83cff3b839a6fp+1, 0x1.89ce3cb13e233p-54, -0x1.2af412bcb91fep+0, -0x1.58c034ed3f429p+1, -0x1.301f1808f1ecp+1,
     0x1.ec594621194c6p+1, 0x1.8f0e3e2e5a27bp+4, 0x1.b191524fa71f2p+5, -0x1.0538981ccbde1p+5, -0x1.1a279a3772b63p+9,
     -0x1.77bdb9054376bp+10, 0x1.8a9644b87e508p+7}, /* [19] 0.59375 <= y <= 0.625, 61.2 bits */
    {0x1.7ecbb88cd1333p+1, -0x1.88df46980e4b8p-56, -0x1.57ad1a8722cfcp+0, -0x1.714efcba3d26ap+1, -0x1.9ee2803c1f01p+0,
     0x1.0eb30f46ae46cp+3, 0x1.0a5d719a94f47p+5, 0x1.c05315fa7feb4p+4, -0x1.b946d9720cbb7p+7, -0x1.bc10f0b709dap+9,
     -0x1.75b9fd8d78028p+8, 0x1.e593876f1bcbfp+12}, /* [20] 0.625 <= y <= 0.65625, 60.4 bits */
    {0x1.790f5da9377ddp+1, 0x1.5779ffed1c68ep-54, -0x1.86bfd721c9d42p+0, -0x1.7d149a2b2d517p+1, -0x1.d6a95b958de67p-3,
     0x1.b8e227189dbbp+3, 0x1.043c815f4c217p+5, -0x1.5cf3ee9617d2ep+5, -0x1.a4047f8afdfb4p+8, -0x1.0b3fe8d9894bfp+9,
     0x1.94475e7b5078ep+11, 0x1.aae9059ba888dp+13}, /* [21] 0.65625 <= y <= 0.6875, 62.0 bits */
    {0x1.72955439188a6p+1, -0x1.c0290fd9b211ep-53, -0x1.b616d9c13da76p+0, -0x1.745962ed49fa5p+1, 0x1.c4d183ef5266ap+0,
     0x1.1c07762d99efep+4, 0x1.e9f1423ecd7cdp+3, -0x1.168343f22a7dbp+7, -0x1.8aada065605a9p+8, 0x1.b744395913ba4p+9,
     0x1.7b7e865be145p+12, 0x1.5ef8410812171p+8}, /* [22] 0.6875 <= y <= 0.71875, 60.4 bits */
    {0x1.6b6237f561672p+1, -0x1.514dd2917a892p-53, -0x1.e2bd6513069e8p+0, -0x1.517e859f14206p+1, 0x1.02a11b8064b1cp+2,
     0x1.1c37b8134c46bp+4, -0x1.0b040bbdc7fd5p+4, -0x1.75ce01d59cc87p+7, 0x1.05955e8ca17e1p+4, 0x1.148da12e19d34p+11,
     0x1.de95093c9690dp+10, -0x1.924914cbdf31ep+14}, /* [23] 0.71875 <= y <= 0.75, 59.9 bits */
    {0x1.638775c382343p+1, -0x1.b4e6f6993c557p-53, -0x1.04af49e8412d1p+1, -0x1.14a9f131993cfp+1, 0x1.7f4822cf76106p+2,
     0x1.92ba467eef78ep+3, -0x1.7cbc80d18bdbp+5, -0x1.edd762996dffap+6, 0x1.0b4e3b922c8dbp+9, 0x1.7c9d09526308dp+10,
     -0x1.978b56e261abcp+12, -0x1.3dbd5212c7b9ap+14}, /* [24] 0.75 <= y <= 0.78125, 59.5 bits */
    {0x1.5b23260e34cc3p+1, -0x1.40204ba87348cp-53, -0x1.1390aea5c5364p+1, -0x1.8acba7513928ap+0, 0x1.c2aa0291bfdep+2,
     0x1.fe20cd92ef135p+1, -0x1.d09ec74b8f21bp+5, 0x1.f00fb9a0b0badp+3, 0x1.4015e2e4ff797p+9, -0x1.67e97403076b8p+9,
     -0x1.cef6a02318da4p+12, 0x1.cecb192e320bap+13}, /* [25] 0.78125 <= y <= 0.8125, 59.8 bits */
    {0x1.525c636e6d438p+1, 0x1.8bd7c74fe403cp-53, -0x1.1d3bf68cf622fp+1, -0x1.c067f0aa17a6ap-1, 0x1.c01c916a6cc2fp+2,
     -0x1.100d596bf761cp+2, -0x1.60357bd4fcccp+5, 0x1.e2a559ace47bbp+6, 0x1.10b4316ece6d8p+8, -0x1.d43ac56c6da33p+10,
     -0x1.317d94b9f62dep+8, 0x1.70cfb20c6c842p+14}, /* [26] 0.8125 <= y <= 0.84375, 59.7 bits */
    {0x1.495d51a8a57a4p+1, 0x1.5c585aed1172dp-53, -0x1.21b48d0e8e2fbp+1, -0x1.0603cae672185p-2, 0x1.87b024ab63614p+2,
     -0x1.262d086e016dep+3, -0x1.2e2bb758da1bp+4, 0x1.08fa1c125749cp+7, -0x1.0b7adce5d37b3p+7, -0x1.230354f5d7538p+10,
     0x1.076042a772014p+12, 0x1.eaf880aa750a5p+11}, /* [27] 0.84375 <= y <= 0.875, 58.8 bits */
    {0x1.404d4e9d171e3p+1, 0x1.638c3fe83981ap-54, -0x1.219c080ab1677p+1, 0x1.0a493e18c2a3fp-2, 0x1.37209fbc91bb4p+2,
     -0x1.4d0a474d558ecp+3, 0x1.bd9107571159ap+0, 0x1.4967d4b61caep+6, -0x1.15233e20258ep+8, -0x1.4eabef046ceaap+5,
     0x1.8192a17b5b86fp+11, -0x1.02aa40ce20b91p+13}, /* [28] 0.875 <= y <= 0.90625, 60.1 bits */
    {0x1.374d4ae97ca03p+1, -0x1.09bf95ebf38cdp-53, -0x1.1dddb3cdf64d8p+1, 0x1.500da7df39a85p-1, 0x1.cf2da0b113211p+1,
     -0x1.26facdd9a8c6ep+3, 0x1.7776acae973c7p+3, 0x1.ac97b552ba059p+4, -0x1.a47e5e53f0ac1p+7, 0x1.c8cd2df16a78ep+8,
     0x1.223ed8a79cd97p+9, -0x1.8c713b525d398p+12}, /* [29] 0.90625 <= y <= 0.9375, 59.5 bits */
    {0x1.2e76b5da5fa74p+1, -0x1.d168cadfb2fa7p-53, -0x1.17650761a9b83p+1, 0x1.e40f2bad1d613p-1, 0x1.4ba670db6788bp+1,
     -0x1.cbde186682f97p+2, 0x1.a812f8a0cf56fp+3, -0x1.93ee52a27edb2p+2, -0x1.79cc50d370c5p+6, 0x1.9e28bc6b7d06fp+8,
     -0x1.3252c23b68b8dp+9, -0x1.81d395c29aeb2p+10}, /* [30] 0.9375 <= y <= 0.96875, 59.6 bits */
    {0x1.25dc2fa18ff73p+1, -0x1.a08dcbfc4c627p-55, -0x1.0ef6c786847dp+1, 0x1.266f815ae7378p+0, 0x1.d0de1fb9efe95p+0,
     -0x1.521c3de576c28p+2, 0x1.58416e1753bcbp+3, -0x1.169b5b1acaa2ap+4, -0x1.ee3b59ed7048ep+3, 0x1.afeaf319a40dep+7,
     -0x1.5087fe4c91869p+9, 0x1.5d083710d5c87p+9}, /* [31] 0.96875 <= y <= 1, 59.4 bits */
    {0x1.1d8af07d3952ep+1, 0x1.44b9099a38b7cp-54, -0x1.052886380ca56p+1, 0x1.4ade31ab10e04p+0, 0x1.3fef284470215p+0,
     -0x1.ee47c4b28c88ep+1, 0x1.de1cd186a463p+2, -0x1.072a1837973dcp+4, 0x1.1f9a6d19fa1d2p+4, 0x1.04ce284d79235p+6,
     -0x1.82e128043ae3fp+8, 0x1.d5093632a6eddp+9}, /* [32] 1 <= y <= 1.03125, 59.2 bits */
    {0x1.158c2adacc74p+1, -0x1.b791bdeefd688p-55, -0x1.f4cff3fb5695fp+0, 0x1.639896c5cb601p+0, 0x1.a94a3705d7a01p-1,
     -0x1.74dbbb3dbea1fp+1, 0x1.34eb4e5ea386ep+2, -0x1.71842d2565d12p+3, 0x1.7d8b4cd368143p+4, -0x1.bb479b23cc031p+2,
     -0x1.2568c105746c2p+7, 0x1.1f83b0bad8705p+9}, /* [33] 1.03125 <= y <= 1.0625, 62.2 bits */
    {0x1.0de61c9462bd5p+1, -0x1.4d42a19e89f0fp-53, -0x1.de0cda6402a9bp+0, 0x1.7380297949e1dp+0, 0x1.03c87f9b5aa5fp-1,
     -0x1.26d41a8541855p+1, 0x1.9007513714b39p+1, -0x1.b2dbd272ab5d3p+2, 0x1.2becc69b5d665p+4, -0x1.c18af05632008p+4,
     -0x1.63a22084f97aap+4, 0x1.eb3fbe7a9d44ep+7}, /* [34] 1.0625 <= y <= 1.09375, 60.2 bits */
    {0x1.069cc9628a702p+1, 0x1.f8179bf843032p-59, -0x1.c684f24bb1138p+0, 0x1.7c71edde240f8p+0, 0x1.f8ab984dfc95ep-3,
     -0x1.e57e3441508afp+0, 0x1.17e159ee49f9bp+1, -0x1.bd37bac96c424p+1, 0x1.74c9c57ca9152p+3, -0x1.a986d0d455274p+4,
     0x1.6f6d15981d03fp+4, 0x1.08b0fa4a1ce08p+6}, /* [35] 1.09375 <= y <= 1.125, 60.2 bits */
    {0x1.ff64e88c84449p+0, -0x1.2179850db3f6ep-54, -0x1.ae9d099f26259p+0, 0x1.7fac9ae764c51p+0, 0x1.da299c2560fefp-6,
     -0x1.9851718069416p+0, 0x1.bb229f32c1e36p+0, -0x1.96ac6ce78d00cp+0, 0x1.7deaf7341b748p+2, -0x1.28b44e3690a55p+4,
     0x1.e46dd9f73d31cp+4, -0x1.b2094d05cb932p+2}, /* [36] 1.125 <= y <= 1.15625, 64.7 bits */
    {0x1.f24fe18a5eadfp+0, -0x1.724f2538d3b78p-59, -0x1.96a8edb301abcp+0, 0x1.7e1b48dcb9a4ap+0, -0x1.3c107360e3ff2p-3,
     -0x1.57b12683fd6fap+0, 0x1.87027bbab124ap+0, -0x1.6e24b39b98c75p-1, 0x1.2c2a78fafb5d8p+1, -0x1.5760b3ba6cb16p+3,
     0x1.8356751d602e3p+4, -0x1.a9a33457f851ep+4}, /* [37] 1.15625 <= y <= 1.1875, 60.4 bits */
    {0x1.e5f9bd30b48d9p+0, -0x1.9e600d6429ca3p-54, -0x1.7eef1ff5ebe73p+0, 0x1.788182af275cdp+0, -0x1.3afcd3b875b86p-2,
     -0x1.1ccc7671efcfcp+0, 0x1.6cfe489cf2189p+0, -0x1.c177fa2f7eca2p-2, 0x1.a7db193502f7fp-2, -0x1.477caefbcfc31p+2,
     0x1.f90c2e89d0bbdp+3, -0x1.981758f302e67p+4}, /* [38] 1.1875 <= y <= 1.21875, 65.7 bits */
    {0x1.da5fb5fb45fap+0, -0x1.1ae1315e56c41p-54, -0x1.67aa8cd103a89p+0, 0x1.6f907fead9545p+0, -0x1.bb65abc3af945p-2,
     -0x1.cabfe89aefbcap-1, 0x1.584c05bb44b2bp+0, -0x1.cf99f80b880fcp-2, -0x1.9812742d63532p-2, -0x1.b54710c8d14a9p+0,
     0x1.1b1f2659a16c5p+3, -0x1.29578e5a5e15dp+4}, /* [39] 1.21875 <= y <= 1.25, 62.3 bits */
    {0x1.cf7d5a562ba1ap+0, -0x1.35c31a573abe2p-58, -0x1.510b68b2b2b4p+0, 0x1.63ee82744fb1ap+0, -0x1.107797bc056a8p-1,
     -0x1.62d03e0723368p-1, 0x1.3ff6eea2b7a5ep+0, -0x1.2281d2267a72ap-1, -0x1.271517340c8ccp-1, 0x1.0de42fbd8e9f8p-4,
     0x1.09ca8cb97763p+2, -0x1.75b272a6d6a38p+3}, /* [40] 1.25 <= y <= 1.28125, 60.6 bits */
    {0x1.c54cdfc0bda54p+0, 0x1.aa7c05cf6a8e7p-54, -0x1.3b37d66bd4f36p+0, 0x1.56373c51aca63p+0, -0x1.36c1a951ca0e7p-1,
     -0x1.0362d3820679bp-1, 0x1.21d6e9253de6bp+0, -0x1.5dc62a11b00e5p-1, -0x1.ce87af11cd84fp-2, 0x1.9a3662a5bc9c9p-1,
     0x1.5d77265aafe12p+0, -0x1.9ea146b49d1e5p+2} /* [41] 1.28125 <= y <= 1.3125, 61.2 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tsuji_duration_limited_weak)

/* duration with the limited damper: 43 rows of degree 10 in y = ln(1 + zeta), nodes 1.625 + i 0.25, y < 12.25.
 * Relative error of the approximation: 2^-56.4 at most, sampled at 25 places of each row. */
#define COR_ROWS_TSUJI_DURATION_LIMITED_FIRST 1.625
#define COR_ROWS_TSUJI_DURATION_LIMITED_STEP 0.25
#define COR_ROWS_TSUJI_DURATION_LIMITED_PER_UNIT 4.0
#define COR_ROWS_TSUJI_DURATION_LIMITED_ROWS 43
#define COR_ROWS_TSUJI_DURATION_LIMITED_END 12.25
COR_ROWS(double, cor_rows_tsuji_duration_limited, 43, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.bccee74d49dfap+0, 0x1.230a6647c980bp-54, -0x1.875b21c3a11e9p-2, 0x1.1cb0f1cb4f181p-3, -0x1.3ba00ec6b1953p-5,
     0x1.a21c32eb6d406p-7, -0x1.81f782241872cp-8, 0x1.8d6b8352a6797p-9, -0x1.95c631ea542bdp-10, 0x1.93400148f4e4cp-11,
     -0x1.84d886f5e410cp-12, 0x1.5e36dc9ba816ap-13}, /* [0] 1.5 <= y <= 1.75, 56.4 bits */
    {0x1.a66e11cfe4575p+0, 0x1.6e22078f24254p-55, -0x1.46ddb1fa2c55fp-2, 0x1.d3780c0297d45p-4, -0x1.d5dcec488302dp-6,
     0x1.efde143c7d2f2p-8, -0x1.75266446144b5p-9, 0x1.53d11d65c59cp-10, -0x1.39aaf61884664p-11, 0x1.1c7c0ad3aaac3p-12,
     -0x1.fe81119406ed2p-14, 0x1.bba33fc0f1e19p-15}, /* [1] 1.75 <= y <= 2, 58.5 bits */
    {0x1.93b816e934607p+0, 0x1.acbcc9cd93ad5p-56, -0x1.11812237f5936p-2, 0x1.856fdec83358p-4, -0x1.718b272e45c42p-6,
     0x1.44e3b12ce7ab7p-8, -0x1.88f2f25072ea7p-10, 0x1.3abdbf5a0138ep-11, -0x1.081085629184p-12, 0x1.b3f1e93442197p-14,
     -0x1.65996c24dacbfp-15, 0x1.203024680cb27p-16}, /* [2] 2 <= y <= 2.25, 58.7 bits */
    {0x1.840f8a8031e94p+0, -0x1.fb83d1f1c4eb4p-55, -0x1.c9bad2d8f1d98p-3, 0x1.46eda62bf4f03p-4, -0x1.2d149eff5c0cep-6,
     0x1.cf0aef68c3837p-9, -0x1.c07873d41cb98p-11, 0x1.37cca38899cb5p-12, -0x1.df6fe7efe8065p-14, 0x1.6abbf18da0122p-15,
     -0x1.0fd207fecababp-16, 0x1.92b9219d4c458p-18}, /* [3] 2.25 <= y <= 2.5, 61.0 bits */
    {0x1.76f6aae3c79edp+0, 0x1.80088a9ce3d5ap-54, -0x1.7ea2127485087p-3, 0x1.136ada144b16fp-4, -0x1.f5516c1ac3efbp-7,
     0x1.6090e337bea1cp-9, -0x1.14f15bb0c35e7p-11, 0x1.46f11fb7ffa2bp-13, -0x1.cf18e636d196ep-15, 0x1.44c26ae1e33fp-16,
     -0x1.bf106126ad1d5p-18, 0x1.3066d665e52bep-19}, /* [4] 2.5 <= y <= 2.75, 61.5 bits */
    {0x1.6c0602d5e88cfp+0, -0x1.4208c569479a4p-54, -0x1.3f542598da592p-3, 0x1.d07dc6a5925dcp-5, -0x1.a69d66f1618ccp-7,
     0x1.19d234d33a2ecp-9, -0x1.71d0bd5af8c4cp-12, 0x1.68c660c410a1bp-14, -0x1.d5bce31057e25p-16, 0x1.3551a7347b163p-17,
     -0x1.8a9f2e04dc199p-19, 0x1.ef8d1cb54b6d1p-21}, /* [5] 2.75 <= y <= 3, 59.6 bits */
    {0x1.62e6f3167e53bp+0, 0x1.c8d59adeb2b7fp-54, -0x1.09f52f2e92d8ep-3, 0x1.87711b9534701p-5, -0x1.669cc738a7a76p-7,
     0x1.d1c7098a923dap-10, -0x1.09e792c4178b7p-12, 0x1.a2fdeaed3563bp-15, -0x1.ee977dac0873fp-17,
     0x1.35ba08e56ffdap-18, -0x1.72949ea2355bcp-20, 0x1.af68c817ee42dp-22}, /* [6] 3 <= y <= 3.25, 63.6 bits */
    {0x1.5b503dbf89444p+0, 0x1.e9bd118668973p-55, -0x1.ba063b8b45d95p-4, 0x1.495b835b05f8bp-5, -0x1.31217d173c4dfp-7,
     0x1.8922b674a6676p-10, -0x1.98073f1c1aadbp-13, 0x1.0194fbbba7e75p-15, -0x1.0bd4a2f617902p-17, 0x1.422d66056466p-19,
     -0x1.6edbd223a2cafp-21, 0x1.8ee9dcc0a5f48p-23}, /* [7] 3.25 <= y <= 3.5, 61.1 bits */
    {0x1.5503a8be00a36p+0, -0x1.75026da350fabp-54, -0x1.6e77aa1a792f3p-4, 0x1.14845906a4c9dp-5, -0x1.03b0e2ce002d3p-7,
     0x1.4fef8075d6c84p-10, -0x1.499e8084fe524p-13, 0x1.528003917db8dp-16, -0x1.28c693837a39ep-18,
     0x1.58022b483e772p-20, -0x1.7b32957e8f32cp-22, 0x1.853b6f43ec928p-24}, /* [8] 3.5 <= y <= 3.75, 62.9 bits */
    {0x1.4fcc4037ba13ap+0, -0x1.272b8a35996f3p-55, -0x1.2f1bd7793d5bcp-4, 0x1.cf23951c9c913p-6, -0x1.b9754a3274cc3p-8,
     0x1.20d6b3a745d43p-10, -0x1.144b04c991209p-13, 0x1.df3dd30ed434cp-17, -0x1.50964839f6757p-19,
     0x1.749bc917c433ap-21, -0x1.95038736fea1ap-23, 0x1.8e1cc368e7d47p-25}, /* [9] 3.75 <= y <= 4, 63.4 bits */
    {0x1.4b7cfa0566e5ap+0, 0x1.caf68b292d476p-54, -0x1.f43c58b9c1964p-5, 0x1.82cf98016e119p-6, -0x1.765f5f804e1dp-8,
     0x1.f1b9b2fbf1dep-11, -0x1.da54fa0ea3109p-14, 0x1.6d939adad1bd6p-17, -0x1.8a3e9071a417fp-20, 0x1.94aec295fdf1ap-22,
     -0x1.b9e6049382d4p-24, 0x1.a7b2dec3f1817p-26}, /* [10] 4 <= y <= 4.25, 64.0 bits */
    {0x1.47ef9824671a2p+0, -0x1.c0e051731b114p-55, -0x1.9bd6c159c07cfp-5, 0x1.422b559365ba5p-6, -0x1.3c93ecb7d6667p-8,
     0x1.ac97d3040211cp-11, -0x1.9cad5a97ce0e9p-14, 0x1.298c2ce753489p-17, -0x1.e6674fb27e67dp-21,
     0x1.b3edc2ae2219cp-23, -0x1.e63bf41a4dc22p-25, 0x1.d1158ebbe6e04p-27}, /* [11] 4.25 <= y <= 4.5, 62.8 bits */
    {0x1.4503b726c55c4p+0, -0x1.0553e4113e4c9p-54, -0x1.52502a20e1095p-5, 0x1.0b9700e51d4fdp-6, -0x1.0adc0eba7b4afp-8,
     0x1.703ca4aa288fdp-11, -0x1.693bc4e2fc307p-14, 0x1.fc390e9524c12p-18, -0x1.44da5801ee778p-21,
     0x1.cd8dbe56057a8p-24, -0x1.09d39e6367e3cp-25, 0x1.047d1bcffda91p-27}, /* [12] 4.5 <= y <= 4.75, 64.1 bits */
    {0x1.429dfdc8a4bf3p+0, 0x1.a6aa348046889p-57, -0x1.1552f2e10292p-5, 0x1.bb4fa5290f232p-7, -0x1.c06a4f5a07b14p-9,
     0x1.3b5b4a6815689p-11, -0x1.3c94b177240e4p-14, 0x1.bf6f47a6a1f7fp-18, -0x1.e04205b15f663p-22,
     0x1.dea4fce555ab4p-25, -0x1.1b9f569a62e1ap-26, 0x1.260b605b4355p-28}, /* [13] 4.75 <= y <= 5, 63.0 bits */
    {0x1.40a767389e5b2p+0, 0x1.6e389bb78f033p-55, -0x1.c5bcd26ee8d1fp-6, 0x1.6e401f8c1e92p-7, -0x1.777e70963978bp-9,
     0x1.0d0bf79fb016p-11, -0x1.14ebecdad92b4p-14, 0x1.9035bcfca90b6p-18, -0x1.88e6ed52a389fp-22, 0x1.ec6d42505e0a3p-26,
     -0x1.1fd1bc5830391p-27, 0x1.4976389c784cfp-29}, /* [14] 5 <= y <= 5.25, 62.8 bits */
    {0x1.3f0ca3fffb8c1p+0, -0x1.198453f9d6d8dp-55, -0x1.72787ef284228p-6, 0x1.2dd3072d6f1b3p-7, -0x1.39672783b22c6p-9,
     0x1.c93722dde9d49p-12, -0x1.e2a6f77f5b1ecp-15, 0x1.67fbe1d43c663p-18, -0x1.5b5b9ec49fd2bp-22,
     0x1.091f2e612122dp-26, -0x1.09becc32e5b69p-28, 0x1.675a7461d850bp-30}, /* [15] 5.25 <= y <= 5.5, 62.9 bits */
    {0x1.3dbd8ebb48d8dp+0, -0x1.18f301fd07d58p-56, -0x1.2dee6fc35c73p-6, 0x1.f045000af9cadp-8, -0x1.04c01a7e38295p-9,
     0x1.82e484cf78b34p-12, -0x1.a29e02218aba6p-15, 0x1.4387298e34581p-18, -0x1.4146ac3a11d26p-22,
     0x1.4f20d02d8c832p-27, -0x1.91a54ce248dcep-30, 0x1.729dc28f9704ap-31}, /* [16] 5.5 <= y <= 5.75, 62.3 bits */
    {0x1.3cacb27d44ac3p+0, -0x1.878abda80569fp-54, -0x1.eb4b2002c88d8p-7, 0x1.971022fe2a5aep-8, -0x1.b091c5a64b504p-10,
     0x1.460dcfcb16ea2p-12, -0x1.692ee887c51ccp-15, 0x1.217021f5d556fp-18, -0x1.2eb43f188f581p-22,
     0x1.1258ed69f1ba6p-27, -0x1.2b51514170db7p-32, 0x1.55cbf1355e638p-32}, /* [17] 5.75 <= y <= 6, 63.4 bits */
    {0x1.3bcee10e6604p+0, 0x1.e71a6fb00b77ep-55, -0x1.8f0e53a97f29p-7, 0x1.4d2c66f05e30cp-8, -0x1.65c457ecae245p-10,
     0x1.11b3120b4894ap-12, -0x1.35f59eba0ac0ep-15, 0x1.014219f40728bp-18, -0x1.1db3b582b8e3ep-22,
     0x1.1411c108c3dd5p-27, 0x1.f41a7f501ef54p-33, 0x1.e023a8f240fbep-34}, /* [18] 6 <= y <= 6.25, 63.2 bits */
    {0x1.3b1ad76ad1fefp+0, 0x1.11bfc01428a4p-62, -0x1.43a2d8fb72fc9p-7, 0x1.102499a3ce4d1p-8, -0x1.271764305e5eep-10,
     0x1.c9c5e5919091ap-13, -0x1.0897ced1ead55p-15, 0x1.c5f4b0eabdac7p-19, -0x1.0bbd0e489ba95p-22,
     0x1.2c5743dd6ead9p-27, 0x1.853e9187abf92p-32, 0x1.2703982238688p-38}, /* [19] 6.25 <= y <= 6.5, 64.8 bits */
    {0x1.3a88eefde8eaap+0, -0x1.c0efee6d51cc8p-54, -0x1.0616cec23ca4cp-7, 0x1.bbbc2d234e607p-9, -0x1.e589e347d9d8cp-11,
     0x1.7d74e34c2bdd5p-13, -0x1.c16dc52ad023ap-16, 0x1.8d80b3123562fp-19, -0x1.f043bb494005bp-23,
     0x1.4646be06aa9b2p-27, 0x1.4527d2931403ap-32, -0x1.8163a5c9abed3p-35}, /* [20] 6.5 <= y <= 6.75, 63.9 bits */
    {0x1.3a12da3156944p+0, 0x1.57fa8a32433a8p-55, -0x1.a7e991677e304p-8, 0x1.691c48092d709p-9, -0x1.8e7bc2a099cadp-11,
     0x1.3ccbef6407e44p-13, -0x1.7bd812646930fp-16, 0x1.598041b8edf66p-19, -0x1.c63fc8adbfd3p-23, 0x1.583a81f579338p-27,
     0x1.63e8457a1211cp-33, -0x1.055681ff5a6cap-34}, /* [21] 6.75 <= y <= 7, 64.9 bits */
    {0x1.39b36afb6a1e1p+0, 0x1.464180b5eeefap-56, -0x1.56622bf5a5563p-8, 0x1.25601296af231p-9, -0x1.464bd5cdfecd4p-11,
     0x1.06452d933b758p-13, -0x1.3f927fb41f0d6p-16, 0x1.2a314aa15deb8p-19, -0x1.9aae07f5d0839p-23,
     0x1.5ef4263e46aafp-27, 0x1.c6d776e85f758p-37, -0x1.fc1fa07c7f394p-35}, /* [22] 7 <= y <= 7.25, 64.8 bits */
    {0x1.3966622fa308ep+0, 0x1.5930407a0efb4p-54, -0x1.1432d3112102ep-8, 0x1.dbefb1d760b9cp-10, -0x1.0a9ea6ad12014p-11,
     0x1.b0fbb8b06ab52p-14, -0x1.0bb8f02d7fd1ap-16, 0x1.ff56d75bcd9b9p-20, -0x1.6ef91a804db9ap-23,
     0x1.5aa25d060e58fp-27, -0x1.08870239c5711p-33, -0x1.a63ebcc2a398dp-35}, /* [23] 7.25 <= y <= 7.5, 66.3 bits */
    {0x1.3928466d47789p+0, 0x1.aeab7ac42aa3dp-55, -0x1.bd1ac370b10c3p-9, 0x1.817a0893494f5p-10, -0x1.b2d9ed3607b7dp-12,
     0x1.646e0cb5c70a7p-14, -0x1.beccfb83ed5a6p-17, 0x1.b3c022ac2a553p-20, -0x1.446828d3deeb8p-23,
     0x1.4d13bab632db7p-27, -0x1.ee6b34c649425p-33, -0x1.3804353230b13p-35}, /* [24] 7.5 <= y <= 7.75, 65.3 bits */
    {0x1.38f641a208bbcp+0, -0x1.2080ab48fb834p-57, -0x1.6643904f0ae0ep-9, 0x1.37c64e4f66f1ep-10, -0x1.61f5a6166856ap-12,
     0x1.24aa31f58555cp-14, -0x1.7378411eafec8p-17, 0x1.7140f8128341p-20, -0x1.1bfd52d47caadp-23, 0x1.38a913253dea2p-27,
     -0x1.47777571eb23ep-32, -0x1.966aba21f357cp-36}, /* [25] 7.75 <= y <= 8, 66.7 bits */
    {0x1.38ce043170d9ep+0, 0x1.9e18edaef42cdp-54, -0x1.2012678b2173ep-9, 0x1.f7aac3da9f078p-11, -0x1.1f9dc74132695p-12,
     0x1.df7a2b6d4e419p-15, -0x1.33cbed8e8e38fp-17, 0x1.374bd0d7fb5bap-20, -0x1.ecdb57fae9897p-24,
     0x1.1fc0fa84029bdp-27, -0x1.77b6a943604ccp-32, -0x1.b1d5be484dce3p-37}, /* [26] 8 <= y <= 8.25, 66.8 bits */
    {0x1.38adacec3fefdp+0, -0x1.d6d426b0274e8p-57, -0x1.ced15ae8853ddp-10, 0x1.9654e67fc9bd9p-11,
     -0x1.d2a899d30b9e6p-13, 0x1.87e739526c942p-15, -0x1.fc7bf788619b6p-18, 0x1.05338ac7d2b8fp-20,
     -0x1.a84d672ff25d7p-24, 0x1.046e5e9f02bap-27, -0x1.8d3e057f67989p-32, -0x1.04702850d8819p-38},
     /* [27] 8.25 <= y <= 8.5, 68.6 bits */
    {0x1.3893b51c50926p+0, -0x1.c0708e0eb2b7dp-54, -0x1.7371b095d60c5p-10, 0x1.476d31696a0dp-11, -0x1.7a00ff7d56796p-13,
     0x1.3fab32e925ba4p-15, -0x1.a2cd5a8ef135fp-18, 0x1.b473b95204411p-21, -0x1.6ab3d42f9cce3p-24,
     0x1.d0b833891bea4p-28, -0x1.8e143b89699d7p-32, 0x1.8264256761c19p-39}, /* [28] 8.5 <= y <= 8.75, 67.1 bits */
    {0x1.387ee0018854p+0, 0x1.aea16c704a509p-58, -0x1.29da733875d37p-10, 0x1.078e4f4730d5p-11, -0x1.31c1d260f27bap-13,
     0x1.044081bae42c7p-15, -0x1.58053b96c21a7p-18, 0x1.6b3601b314d79p-21, -0x1.34146675bae4fp-24,
     0x1.9994060563aa7p-28, -0x1.7ff64ebc8f539p-32, 0x1.fc96edebbebd1p-38}, /* [29] 8.75 <= y <= 9, 68.0 bits */
    {0x1.386e2d326aa29p+0, -0x1.041007b0578a8p-54, -0x1.dd4b80455076bp-11, 0x1.a7da343740d2ap-12,
     -0x1.edfac685773d3p-14, 0x1.a701cbd1ef0d4p-16, -0x1.19e5d9958b14ap-18, 0x1.2d2cf4ba347cap-21,
     -0x1.043154121dae3p-24, 0x1.652e4e485dc64p-28, -0x1.67dae0f994c18p-32, 0x1.625f8b1b22058p-37},
     /* [30] 9 <= y <= 9.25, 67.8 bits */
    {0x1.3860cd66e650ep+0, -0x1.c8a6d956c2fbbp-54, -0x1.7e1fe87b1a3e7p-11, 0x1.547d89f2ae677p-12,
     -0x1.8e89aa5863e75p-14, 0x1.57346cfc5e2fap-16, -0x1.ccf00b9e25e3ep-19, 0x1.f1d4de4efcd18p-22,
     -0x1.b53f124bedd1ap-25, 0x1.34a33fb4e57dcp-28, -0x1.49c739d660c9dp-32, 0x1.9919b965b6331p-37},
     /* [31] 9.25 <= y <= 9.5, 67.3 bits */
    {0x1.38561945d7cf8p+0, 0x1.fb047f7633e45p-58, -0x1.31b4cc08932p-11, 0x1.1145eebef6f4dp-12, -0x1.4128e3e8f1181p-14,
     0x1.1607588dc2a58p-16, -0x1.780d9eb3a1afp-19, 0x1.9a35fbd11f22ep-22, -0x1.6db1821b79915p-25, 0x1.088f4d4d83beep-28,
     -0x1.28d21adcb6838p-32, 0x1.ade0fe29c707ap-37}, /* [32] 9.5 <= y <= 9.75, 68.8 bits */
    {0x1.384d89dd82b94p+0, 0x1.877e802e7d7aep-55, -0x1.e8cc9f9b7d203p-12, 0x1.b64567ca0cb3bp-13, -0x1.02852888d7b37p-14,
     0x1.c1cfca8c152adp-17, -0x1.32341af58394p-19, 0x1.51146fd3a831p-22, -0x1.3092ec2869ff4p-25, 0x1.c25e244fa69c6p-29,
     -0x1.073da1d28917cp-32, 0x1.aa7fbd111ee7ap-37}, /* [33] 9.75 <= y <= 10, 71.8 bits */
    {0x1.3846b27d0ddep+0, -0x1.10b3edc2b1032p-55, -0x1.86841759f003bp-12, 0x1.5f2875f029488p-13, -0x1.9fc3c3dde3fb3p-15,
     0x1.6b607dfd28569p-17, -0x1.f1c16e46dd573p-20, 0x1.1448ecc355998p-22, -0x1.f96c5d843ab1fp-26,
     0x1.7cf59d7bc7e9fp-29, -0x1.cd34c3702903cp-33, 0x1.96eac9bd195cp-37}, /* [34] 10 <= y <= 10.25, 70.5 bits */
    {0x1.38413bb0f9ad2p+0, 0x1.9c5cd566776dcp-54, -0x1.37cc34bf17144p-12, 0x1.19243f79ede2fp-13, -0x1.4e001027dbd62p-15,
     0x1.252e7f4e30bfcp-17, -0x1.93e3c956fe247p-20, 0x1.c3daae894b33ep-23, -0x1.a1ec8155e9123p-26,
     0x1.40799b6ae7fccp-29, -0x1.8fd7799fb923p-33, 0x1.795274f97764bp-37}, /* [35] 10.25 <= y <= 10.5, 69.1 bits */
    {0x1.383cdf2ec4804p+0, -0x1.95281fa1d94e3p-59, -0x1.f1983f072d16ap-13, 0x1.c1d6f08b501f7p-14,
     -0x1.0c118f3e66bbfp-15, 0x1.d888be9e784f8p-18, -0x1.4736a5968853dp-20, 0x1.70b3d53937993p-23,
     -0x1.587ecdf03d2c9p-26, 0x1.0c45af98a9be6p-29, -0x1.57929f1e93c31p-33, 0x1.5657cd216614p-37},
     /* [36] 10.5 <= y <= 10.75, 73.3 bits */
    {0x1.38396484a8361p+0, -0x1.22d027f533ebbp-54, -0x1.8cd353afef99fp-13, 0x1.67a16cf288f76p-14,
     -0x1.adedf550dca16p-16, 0x1.7c616345a40d6p-18, -0x1.08b5482ab0e9ep-20, 0x1.2c4191c3e326ep-23,
     -0x1.1b293b2e4d6c8p-26, 0x1.bf2d1eb05925bp-30, -0x1.24f721a847a7fp-33, 0x1.314f37d8314c3p-37},
     /* [37] 10.75 <= y <= 11, 69.4 bits */
    {0x1.38369e69be352p+0, -0x1.4574dfabe22efp-55, -0x1.3c4a45c18a099p-13, 0x1.1f5217f68491bp-14,
     -0x1.587a571c41c99p-16, 0x1.31e12c2be5ebcp-18, -0x1.abb4401997012p-21, 0x1.e822bb96a9682p-24,
     -0x1.d048cf251b716p-27, 0x1.7339d8c6cb9e5p-30, -0x1.f04ca7ce27e06p-34, 0x1.0c8387c94be3p-37},
     /* [38] 11 <= y <= 11.25, 69.4 bits */
    {0x1.383468910dd58p+0, -0x1.802863b7d94e2p-54, -0x1.f7ef5e9a1d31fp-14, 0x1.cacf464a2a45p-15, -0x1.13cba6fce4bd9p-16,
     0x1.eb755a78bc63bp-19, -0x1.591833322779fp-21, 0x1.8c1d4269b7d18p-24, -0x1.7bb9bb7a35398p-27,
     0x1.3314e96a5103fp-30, -0x1.a1ed20bcc8f17p-34, 0x1.d2e5b6120ae5ep-38}, /* [39] 11.25 <= y <= 11.5, 70.7 bits */
    {0x1.3832a5e73dec4p+0, 0x1.27f881e39bc8p-56, -0x1.914049a0c60cp-14, 0x1.6e1b1b02b31f3p-15, -0x1.b949cf801c8a3p-17,
     0x1.8a7317681151bp-19, -0x1.161c21f8b6c03p-21, 0x1.40eee7046e0b4p-24, -0x1.35e361f686d6bp-27,
     0x1.fa693b8cc2839p-31, -0x1.5e1e113c2ab08p-34, 0x1.9204f3ece0d9fp-38}, /* [40] 11.5 <= y <= 11.75, 71.5 bits */
    {0x1.38313f26f9af5p+0, 0x1.9accf013839fdp-54, -0x1.3f566d0ed94cp-14, 0x1.23f729c1310f6p-15, -0x1.60cbb9e7d2da8p-17,
     0x1.3c502820d862bp-19, -0x1.bfc1571f4e0c7p-22, 0x1.03a3bbaccaa89p-24, -0x1.f8c5b10c440fcp-28,
     0x1.a058da0cf0228p-31, -0x1.23f8739f9ff2ep-34, 0x1.575241a2e0f41p-38}, /* [41] 11.75 <= y <= 12, 70.2 bits */
    {0x1.383021b3b467cp+0, -0x1.94bcfe9eca636p-54, -0x1.fc0f43525c34ap-15, 0x1.d16c6d56c15a8p-16,
     -0x1.19dc7875fb6f5p-17, 0x1.fae42092061a4p-20, -0x1.68108066a987p-22, 0x1.a38799253f424p-25,
     -0x1.9a5832e914456p-28, 0x1.55649b05c3a4p-31, -0x1.e4f9f217df4e6p-35, 0x1.23209e78d5013p-38}
     /* [42] 12 <= y <= 12.25, 71.3 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tsuji_duration_limited)

/* V of the duration at zero overlap: 160 rows of degree 10 in y = zeta/(10 sqrt(1 - zeta^2)), nodes 0.03125 + i 0.0625, y < 10.
 * Relative error of the approximation: 2^-57.1 at most, sampled at 25 places of each row. */
#define COR_ROWS_TSUJI_OVERLAP_FACTOR_FIRST 0.03125
#define COR_ROWS_TSUJI_OVERLAP_FACTOR_STEP 0.0625
#define COR_ROWS_TSUJI_OVERLAP_FACTOR_PER_UNIT 16.0
#define COR_ROWS_TSUJI_OVERLAP_FACTOR_ROWS 160
#define COR_ROWS_TSUJI_OVERLAP_FACTOR_END 10.0
COR_ROWS(double, cor_rows_tsuji_overlap_factor, 160, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.761896edd95d9p+1, 0x1.72ec9e77e3085p-53, -0x1.1a95fc333cffp+3, 0x1.2f23f872d78aap+4, -0x1.eab076906d62ap+4,
     0x1.3d43dea7a5139p+5, -0x1.5504ca91c2584p+5, 0x1.3966b614cc468p+5, -0x1.f6ec8a9d51c97p+4, 0x1.660332a3826dp+4,
     -0x1.ca57850d6a3fdp+3, 0x1.0a1e5ce685669p+3}, /* [0] 0 <= y <= 0.0625, 59.2 bits */
    {0x1.380971482f431p+1, -0x1.8832b950b3912p-54, -0x1.b2518aded5922p+2, 0x1.c0f42bb19adc3p+3, -0x1.63e38b0017039p+4,
     0x1.c62de3ae0ccc9p+4, -0x1.e3c1ea18a7471p+4, 0x1.b9a199c67fefdp+4, -0x1.608e6516a892fp+4, 0x1.f3f139151b861p+3,
     -0x1.3efdcff2be1c4p+3, 0x1.716fec3bae9ffp+2}, /* [1] 0.0625 <= y <= 0.125, 58.3 bits */
    {0x1.081e6b880bccep+1, 0x1.46e8982fb49f3p-54, -0x1.512055f7d2938p+2, 0x1.4e9ca353a7167p+3, -0x1.03429581820d6p+4,
     0x1.461e45d48f9d2p+4, -0x1.57ef30adc47e9p+4, 0x1.37bc460cc55acp+4, -0x1.ef04426fd25dbp+3, 0x1.5d7c55d37aa94p+3,
     -0x1.bc74a4e687fb1p+2, 0x1.00a5fbf67757cp+2}, /* [2] 0.125 <= y <= 0.1875, 59.8 bits */
    {0x1.c579809b2e3ep+0, -0x1.836d771689524p-54, -0x1.087352b84d0e1p+2, 0x1.f6429c84ccfb3p+2, -0x1.7b888cdfb06f9p+3,
     0x1.d5ed634908913p+3, -0x1.ea4b3024647f3p+3, 0x1.b8f46e69d0e67p+3, -0x1.5c0ff4e0815f3p+3, 0x1.e93c2ec0bd524p+2,
     -0x1.35f507f14a3bep+2, 0x1.64e6b0f201d42p+1}, /* [3] 0.1875 <= y <= 0.25, 57.1 bits */
    {0x1.8a85b97f3636fp+0, 0x1.bdad6b01ea189p-54, -0x1.a36e54352a8f3p+1, 0x1.7bc1f83efb13p+2, -0x1.173960bbbcce8p+3,
     0x1.53d138f3bf846p+3, -0x1.5e6bba1a1dea5p+3, 0x1.3885d79d4b76fp+3, -0x1.ea4778c9e10abp+2, 0x1.56e4631350851p+2,
     -0x1.b0cc128d74d89p+1, 0x1.f0c638d9c19b1p+0}, /* [4] 0.25 <= y <= 0.3125, 59.5 bits */
    {0x1.5b8552cbddc38p+0, -0x1.75b52da0494dfp-55, -0x1.505a5a9eaec3cp+1, 0x1.21667bdc3567cp+2, -0x1.9d1bdc0d93a69p+2,
     0x1.ed65ccca154e2p+2, -0x1.f65e0c119c4ebp+2, 0x1.bbfcfee73e7c2p+2, -0x1.59e977a986c5fp+2, 0x1.e154ef0cec99bp+1,
     -0x1.2e83540393991p+1, 0x1.5a11de88af06p+0}, /* [5] 0.3125 <= y <= 0.375, 58.5 bits */
    {0x1.359f990d3d4b6p+0, -0x1.08dae424fb91bp-55, -0x1.10cb149c9a0b9p+1, 0x1.bcc002f907695p+1, -0x1.336348d880e4ep+2,
     0x1.67b4f8f6c9be9p+2, -0x1.693a5f895f9dep+2, 0x1.3c22137db51ap+2, -0x1.e9070606e5fdep+1, 0x1.5257a8bce2ec5p+1,
     -0x1.a76b243461612p+0, 0x1.e2a9ec6161af5p-1}, /* [6] 0.375 <= y <= 0.4375, 60.5 bits */
    {0x1.16b826e8a484bp+0, -0x1.8f469b92e1745p-54, -0x1.bf8192c2d496cp+0, 0x1.58b667bafb28ep+1, -0x1.cc4ccd4907a34p+1,
     0x1.076d0a8cd3ad9p+2, -0x1.049cd95a95991p+2, 0x1.c358336b54942p+1, -0x1.5a5e8fc33ca78p+1, 0x1.dc6c90e75a6e9p+0,
     -0x1.28b5eaea3ed3fp+0, 0x1.50f370050b755p-1}, /* [7] 0.4375 <= y <= 0.5, 58.1 bits */
    {0x1.fa77a1b8ce124p-1, 0x1.cae84e06ec9d5p-55, -0x1.73297465106d5p+0, 0x1.0d941e09ad77p+1, -0x1.5aeaa236810ap+1,
     0x1.83b15e6db7f0ap+1, -0x1.7964b85fae0fap+1, 0x1.4312d7e519a6ep+1, -0x1.ebb375ad8492p+0, 0x1.50000ae1ef589p+0,
     -0x1.a06a6b1147a22p-1, 0x1.d6fe91980d995p-2}, /* [8] 0.5 <= y <= 0.5625, 58.6 bits */
    {0x1.cff7be396c8b4p-1, 0x1.6b77a5b43c823p-59, -0x1.3731ec72b8f84p+0, 0x1.a9884b9f13cebp+0, -0x1.0747d382125dep+1,
     0x1.1ec11dd3d7f94p+1, -0x1.124c4d7779f78p+1, 0x1.cfdce16a00bf9p+0, -0x1.5dcc81fdd72d7p+0, 0x1.dac9c09ab78c9p-1,
     -0x1.24a2c39d54bf7p-1, 0x1.49944a438ab5ep-2}, /* [9] 0.5625 <= y <= 0.625, 58.4 bits */
    {0x1.ac26f934a0552p-1, -0x1.5c01e24e744acp-55, -0x1.07a7438c02a23p+0, 0x1.530105e4229c2p+0, -0x1.9285fbce0bed5p+0,
     0x1.aa7ff772afaffp+0, -0x1.905bdbad7f8bdp+0, 0x1.4e09d1c784ab9p+0, -0x1.f2e6f03588f44p-1, 0x1.5018a5de94a3cp-1,
     -0x1.9bf02d460004fp-2, 0x1.cdd6444aa8c16p-3}, /* [10] 0.625 <= y <= 0.6875, 59.1 bits */
    {0x1.8da8e7820ad39p-1, 0x1.681ea16c99abfp-55, -0x1.c336df9c8a368p-1, 0x1.109f09c029782p+0, -0x1.3607f70513b63p+0,
     0x1.3eff1f7081cbap+0, -0x1.2571c85ddf119p+0, 0x1.e2b107692b0cap-1, -0x1.64b277eea1302p-1, 0x1.dccec13794f36p-2,
     -0x1.226a9e6067ac5p-2, 0x1.440582c914c4ep-3}, /* [11] 0.6875 <= y <= 0.75, 61.4 bits */
    {0x1.737251ba3339ap-1, 0x1.3e392426f2f4p-56, -0x1.85be9824edc47p-1, 0x1.ba9acb2ce9387p-1, -0x1.e14f9404db236p-1,
     0x1.e010336417808p-1, -0x1.b024203e27c2bp-1, 0x1.5dfa6a9e69f68p-1, -0x1.ff730393a3727p-2, 0x1.52f2c5a3c3175p-2,
     -0x1.9a33be9fdf014p-3, 0x1.c74fd5a792caap-4}, /* [12] 0.75 <= y <= 0.8125, 58.8 bits */
    {0x1.5cb4b46664743p-1, 0x1.bd54c707e28b6p-56, -0x1.539f1d920d52dp-1, 0x1.6aa16dc1438b2p-1, -0x1.78983ca51de1dp-1,
     0x1.6b828c501ab28p-1, -0x1.3fbe69ec5b71cp-1, 0x1.fd682381f84bbp-2, -0x1.6fbd055266741p-2, 0x1.e301a58a853d5p-3,
     -0x1.223bc55bbcd41p-3, 0x1.406217f401de4p-4}, /* [13] 0.8125 <= y <= 0.875, 59.2 bits */
    {0x1.48cf32f18aca8p-1, 0x1.c383175ac0f8ep-55, -0x1.2a5fbbee7502bp-1, 0x1.2bd0227ba23dp-1, -0x1.290e3c141932ap-1,
     0x1.15104a5ab896dp-1, -0x1.db95beff129f7p-2, 0x1.743380c9ed5e7p-2, -0x1.0939f737bf89bp-2, 0x1.58fcb6abd2c2fp-3,
     -0x1.9b8208425709cp-4, 0x1.c3999e00a5bcp-5}, /* [14] 0.875 <= y <= 0.9375, 62.5 bits */
    {0x1.37437d571d526p-1, 0x1.42880ba029aa6p-55, -0x1.082000e444a02p-1, 0x1.f422f93d1bb49p-2, -0x1.d878f369491bep-2,
     0x1.a938cbc0c24d2p-2, -0x1.6397c855cf034p-2, 0x1.11177360a1f54p-2, -0x1.7fd6574647319p-3, 0x1.ee17a145f07e8p-4,
     -0x1.2455c7b9d34ecp-4, 0x1.3ed1409e05cc8p-5}, /* [15] 0.9375 <= y <= 1, 60.5 bits */
    {0x1.27ad95004bd7ep-1, 0x1.b81da78936637p-57, -0x1.d6e14fda746d9p-2, 0x1.a4b472e2d1f3ep-2, -0x1.7ad1f4a788ae1p-2,
     0x1.48959109f9574p-2, -0x1.0b5e94cbcabf8p-2, 0x1.92849b62ca63ep-3, -0x1.16b5ea0471ddbp-3, 0x1.62cb2eb7980cep-4,
     -0x1.a043af844bfe5p-5, 0x1.c2f546e607bb6p-6}, /* [16] 1 <= y <= 1.0625, 59.9 bits */
    {0x1.19bdaa7b8956p-1, -0x1.2a7e9c3961d81p-55, -0x1.a66e02fcbf752p-2, 0x1.64c4988b2205ap-2, -0x1.323496973ae0ep-2,
     0x1.ff71970cb670bp-3, -0x1.946b612e9e222p-3, 0x1.2a05571300718p-3, -0x1.963d1bbfd75cfp-4, 0x1.ff04b4b23d6e8p-5,
     -0x1.290e8d83d1e6fp-5, 0x1.3f8987ccac746p-6}, /* [17] 1.0625 <= y <= 1.125, 62.2 bits */
    {0x1.0d3384dd601c9p-1, 0x1.9d3bccc095c9ap-58, -0x1.7d2fdd4fee863p-2, 0x1.30e2ec0e0053dp-2, -0x1.f2fe8fcef7482p-3,
     0x1.90eacb813e801p-3, -0x1.33b5f2f430bd8p-3, 0x1.bb742ca14654fp-4, -0x1.2934b07bb2281p-4, 0x1.71265f02c17adp-5,
     -0x1.a9057a678d13ap-6, 0x1.c5bce543190bfp-7}, /* [18] 1.125 <= y <= 1.1875, 59.8 bits */
    {0x1.01db0b0fb5e24p-1, -0x1.770c55eaf4037p-56, -0x1.59d0b9f2602a5p-2, 0x1.0673c85a3e9e3p-2, -0x1.99c6ee89090e2p-3,
     0x1.3c92756be3a2cp-3, -0x1.d72c9be62014cp-4, 0x1.4b9b3c2a03ae7p-4, -0x1.b4a52b1e45747p-5, 0x1.0b88c236d6ec9p-5,
     -0x1.30d94996d0698p-6, 0x1.42d4fd915d812p-7}, /* [19] 1.1875 <= y <= 1.25, 59.1 bits */
    {0x1.ef13474d51cd6p-2, 0x1.f84bbe245d761p-56, -0x1.3b43884d6ae75p-2, 0x1.c6f3a38f22fdcp-3, -0x1.5314fdaf7dd39p-3,
     0x1.f799d96e94ddbp-4, -0x1.6b0a201813763p-4, 0x1.f28f5dc66f36cp-5, -0x1.421f8eb675a0fp-5, 0x1.851c3c884653dp-6,
     -0x1.b683d28a3adecp-7, 0x1.cc69ddadc78fdp-8}, /* [20] 1.25 <= y <= 1.3125, 59.4 bits */
    {0x1.dc386868883ap-2, -0x1.0643b2810eb5dp-56, -0x1.20b3236f826a2p-2, 0x1.8cdbf75e752aep-3, -0x1.1aa78942038b6p-3,
     0x1.937a90a906282p-4, -0x1.198a5ad93a87fp-4, 0x1.78d6163b7160ep-5, -0x1.dd66792450aedp-6, 0x1.1bfd010aadd0dp-6,
     -0x1.3c50079973c67p-7, 0x1.4916e3541883bp-8}, /* [21] 1.3125 <= y <= 1.375, 60.6 bits */
    {0x1.caeb2f96be7fbp-2, 0x1.ac82e000b7713p-56, -0x1.097576a9aecd2p-2, 0x1.5c443c9eed901p-3, -0x1.da93b53f0ff3fp-4,
     0x1.4596c89402997p-4, -0x1.b78ca757de85p-5, 0x1.1e7030eb05704p-5, -0x1.63699f393dda5p-6, 0x1.a01a40dc8ce3ap-7,
     -0x1.c9baa7d240062p-8, 0x1.d79e3e3a85be6p-9}, /* [22] 1.375 <= y <= 1.4375, 60.2 bits */
    {0x1.bafade14ae124p-2, 0x1.d33bd74d89e1bp-59, -0x1.ea039c361068p-3, 0x1.3356748f40871p-3, -0x1.911c350897923p-4,
     0x1.08981d5f9a76bp-4, -0x1.5964c08a75597p-5, 0x1.b5f87eb54c1b2p-6, -0x1.09e08978c9c8p-6, 0x1.320c62361267cp-7,
     -0x1.4c40e61837124p-8, 0x1.52d3634bc54fp-9}, /* [23] 1.4375 <= y <= 1.5, 59.7 bits */
    {0x1.ac3e678a0dcb1p-2, -0x1.f94a4cc9b95f1p-56, -0x1.c5d30105c24bap-3, 0x1.10a2abc4b474ap-3, -0x1.5534ded63cd6bp-4,
     0x1.b1066e3ff300bp-5, -0x1.113545a8a0f39p-5, 0x1.50cfaba1d5585p-6, -0x1.8fc9db20a01a8p-7, 0x1.c411f51120a3ep-8,
     -0x1.e3fb80a876c41p-9, 0x1.e8317f7606275p-10}, /* [24] 1.5 <= y <= 1.5625, 61.0 bits */
    {0x1.9e930016f5e21p-2, 0x1.583fda40fcb54p-56, -0x1.a5a4b0d57de08p-3, 0x1.e60dd0d0459a3p-4, -0x1.24075172eff7bp-4,
     0x1.64b7cd1a6b709p-5, -0x1.b312ddc44c076p-6, 0x1.04920b6f34414p-6, -0x1.2e20301474dccp-7, 0x1.4f52611cdfe97p-8,
     -0x1.61c085434578ap-9, 0x1.60ba1e848ebf5p-10}, /* [25] 1.5625 <= y <= 1.625, 61.8 bits */
    {0x1.91daf8dad6215p-2, -0x1.5ad0a230d8123p-57, -0x1.88e49779e7332p-3, 0x1.b33a3fc4a74b1p-4, -0x1.f6c6fa8360d46p-5,
     0x1.27c4b8de4e7dfp-5, -0x1.5caf7ab343611p-6, 0x1.959e68b056e45p-7, -0x1.cb102565368dep-8, 0x1.f3ad2e04e0d85p-9,
     -0x1.038629f23f56fp-9, 0x1.ff420362b690bp-11}, /* [26] 1.625 <= y <= 1.6875, 60.4 bits */
    {0x1.85fcd8c928a3p-2, -0x1.37f08563d65a4p-57, -0x1.6f185d3a8f10ep-3, 0x1.875b3f8c1e374p-4, -0x1.b32de861939a7p-5,
     0x1.ed89d3fd322ffp-6, -0x1.194046ad42bc1p-6, 0x1.3da0c870c71b8p-7, -0x1.5ea6939a8abd9p-8, 0x1.7604f1b16fd78p-9,
     -0x1.7e43e3e178e9dp-10, 0x1.73b4b2e3c1e62p-11}, /* [27] 1.6875 <= y <= 1.75, 60.3 bits */
    {0x1.7ae2a41c5b998p-2, -0x1.96955e6445249p-58, -0x1.57da4801c04f3p-3, 0x1.6149867a0a939p-4, -0x1.7a9d5d0d6f633p-5,
     0x1.9e404668612aep-6, -0x1.c894f926de132p-7, 0x1.f47b4fc0f7e72p-8, -0x1.0d51712515e8bp-8, 0x1.194ca2ae22c88p-9,
     -0x1.1aa97c85ebdbcp-10, 0x1.0f269df35967cp-11}, /* [28] 1.75 <= y <= 1.8125, 59.5 bits */
    {0x1.7079480a7ca31p-2, 0x1.40f8d30fc7fedp-56, -0x1.42d53ca79cd43p-3, 0x1.40163a8f6a83dp-4, -0x1.4b00f4ed6ad2p-5,
     0x1.5db39e529433p-6, -0x1.74e3f274349e3p-7, 0x1.8cb1359973916p-8, -0x1.a003011240041p-9, 0x1.a93482313f601p-10,
     -0x1.a3c4ea378447ap-11, 0x1.8cfad799ade7ep-12}, /* [29] 1.8125 <= y <= 1.875, 61.5 bits */
    {0x1.66b022d8c2092p-2, -0x1.c88dcfbe30302p-57, -0x1.2fc19c2673329p-3, 0x1.22fef2c0a04b7p-4, -0x1.22b420e5fd0f7p-5,
     0x1.28d4ba0ae88ebp-6, -0x1.325cef936acd9p-7, 0x1.3c50cd3b4d13p-8, -0x1.431cec7a4b714p-9, 0x1.42fa1cff14aacp-10,
     -0x1.39095fcefb5ddp-11, 0x1.23a89bc60ec54p-12}, /* [30] 1.875 <= y <= 1.9375, 64.9 bits */
    {0x1.5d78a244e40d9p-2, 0x1.a7416f237f13dp-56, -0x1.1e62c9977ca24p-3, 0x1.09647b5279109p-4, -0x1.0068a661a1d14p-5,
     0x1.fa8a8a9efda28p-7, -0x1.fa53d5ffa79dp-8, 0x1.fb7020085b85ep-9, -0x1.f8c154f118c64p-10, 0x1.ed292d8cefb27p-11,
     -0x1.d4f668fd039c5p-12, 0x1.ae2e64e8c35cp-13}, /* [31] 1.9375 <= y <= 2, 60.3 bits */
    {0x1.54c5f39f47a6ap-2, -0x1.18946c850b7cep-57, -0x1.0e8532739108dp-3, 0x1.e587608ad811dp-5, -0x1.c626a006c0d5ap-6,
     0x1.b25a504b699c7p-7, -0x1.a4bea6de162e6p-8, 0x1.996321627e81cp-9, -0x1.8c7b2d75fa747p-10, 0x1.7a7614b846164p-11,
     -0x1.60e2309a77239p-12, 0x1.3e7dc600e56fdp-13}, /* [32] 2 <= y <= 2.0625, 60.3 bits */
    {0x1.4c8cc1fdda01bp-2, -0x1.2aaf9b658758dp-56, -0x1.fff977dd511p-4, 0x1.bd5fda4716352p-5, -0x1.93ba76c6ca9adp-6,
     0x1.7635752827024p-7, -0x1.5f82481428277p-8, 0x1.4c2956b2ca0b6p-9, -0x1.392e98c6076e9p-10, 0x1.23f5b5d6f53a9p-11,
     -0x1.0ac74d7f287e2p-12, 0x1.d982a84c07acfp-14}, /* [33] 2.0625 <= y <= 2.125, 61.5 bits */
    {0x1.44c2ffbb873e5p-2, 0x1.12d1ec1b64dedp-56, -0x1.e546fe7bac40ep-4, 0x1.999d643019a55p-5, -0x1.683135d81a8f8p-6,
     0x1.43d5d0c8b44c9p-7, -0x1.272ec5e4c8dd8p-8, 0x1.0eff530a73f7cp-9, -0x1.f18527913ac0dp-11, 0x1.c4d50642f2521p-12,
     -0x1.954a3bf6c743cp-13, 0x1.6175b115295a2p-14}, /* [34] 2.125 <= y <= 2.1875, 61.3 bits */
    {0x1.3d5fb913da6ddp-2, 0x1.2e92c6727947dp-56, -0x1.ccb1879e801a5p-4, 0x1.79a86c708e445p-5, -0x1.4270212ea3299p-6,
     0x1.196e690537c41p-7, -0x1.f2377af2b01b7p-9, 0x1.bc929b12a5d54p-10, -0x1.8d5948cf69b85p-11, 0x1.6106fe0815a3bp-12,
     -0x1.3559541a39943p-13, 0x1.08f9f8d5a6f7dp-14}, /* [35] 2.1875 <= y <= 2.25, 62.0 bits */
    {0x1.365aee21aa271p-2, 0x1.1f82d7f55833ap-56, -0x1.b60054cff0f9dp-4, 0x1.5d01615025965p-5, -0x1.218ffe0243fa1p-6,
     0x1.eb2065d89e408p-8, -0x1.a670a63f08f96p-9, 0x1.6e902ed5c3bdfp-10, -0x1.3f0ee333a132ep-11, 0x1.14ab6c99ca564p-12,
     -0x1.da8d4e903ff2cp-14, 0x1.8f078881770ffp-15}, /* [36] 2.25 <= y <= 2.3125, 60.5 bits */
    {0x1.2fad72e3aec35p-2, -0x1.395dcf02319f5p-56, -0x1.a101fe24872c4p-4, 0x1.433c5ee8dbd5p-5, -0x1.04d2af9dcaf7fp-6,
     0x1.ae2aad00d14bbp-8, -0x1.67ce8eac6c0b9p-9, 0x1.2fc3a46b04fe3p-10, -0x1.018c10050ced6p-11, 0x1.b3ed22ed21e19p-13,
     -0x1.6dc96edf78d28p-14, 0x1.2dcb491bdbd1dp-15}, /* [37] 2.3125 <= y <= 2.375, 61.0 bits */
    {0x1.2950d43122f2dp-2, 0x1.1fb09e286253dp-56, -0x1.8d8b540d4865ap-4, 0x1.2bfdb9abf3dbep-5, -0x1.d73633e14fe96p-7,
     0x1.7a22a686f8734p-8, -0x1.33c7fc11d24bfp-9, 0x1.f9e4308a3b93bp-11, -0x1.a1ef4218a8061p-12, 0x1.59354d872919ap-13,
     -0x1.1b591a09c93d3p-14, 0x1.ca94d5f57b06ap-16}, /* [38] 2.375 <= y <= 2.4375, 63.7 bits */
    {0x1.233f40c0118e2p-2, -0x1.cba368224a3dap-56, -0x1.7b7672e25171bp-4, 0x1.16f735d764eb1p-5, -0x1.aacd8422fbc66p-7,
     0x1.4d89a0fd81e9bp-8, -0x1.085c4d39ef491p-9, 0x1.a73993051b554p-11, -0x1.54ce0484886b2p-12, 0x1.12c491af1a7d3p-13,
     -0x1.b9279d626f7f7p-15, 0x1.5e03f94d73d92p-16}, /* [39] 2.4375 <= y <= 2.5, 60.2 bits */
    {0x1.1d73758a6a88dp-2, 0x1.885dbe30d3f38p-57, -0x1.6aa1fe89f402p-4, 0x1.03e5c713798b2p-5, -0x1.83918c8b33a78p-7,
     0x1.272867b631b08p-8, -0x1.c7e9487b308d2p-10, 0x1.63a7b184d372p-11, -0x1.1743b2bf78f5p-12, 0x1.b79a6ee0e7359p-14,
     -0x1.591f57e2016f3p-15, 0x1.0c64b5a1d1373p-16}, /* [40] 2.5 <= y <= 2.5625, 61.5 bits */
    {0x1.17e8ad012f7e5p-2, -0x1.23a5ec352f7e1p-58, -0x1.5af07ea6bb08fp-4, 0x1.e51f77a3b6ba4p-6, -0x1.60cbbfef6226cp-7,
     0x1.0600a6a32b9f4p-8, -0x1.8a98e007a7cc8p-10, 0x1.2c28d33548fe4p-11, -0x1.cbd5e51c85c48p-13, 0x1.6165c53d29766p-14,
     -0x1.0f5204a7368e8p-15, 0x1.9d88c5b73e96ap-17}, /* [41] 2.5625 <= y <= 2.625, 60.3 bits */
    {0x1.129a90981a74cp-2, 0x1.b1b39891b24f7p-58, -0x1.4c47d547edd69p-4, 0x1.c5867cc80a54dp-6, -0x1.41e26927c7d0bp-7,
     0x1.d2830a14b5627p-9, -0x1.56bef6d83fd6ep-10, 0x1.fcbcb9633ec6p-12, -0x1.7c4f910a3d04ap-13, 0x1.1d7796661edeap-14,
     -0x1.acac8c1a8eeefp-16, 0x1.401308073061bp-17}, /* [42] 2.625 <= y <= 2.6875, 60.1 bits */
    {0x1.0d852c49a916ep-2, 0x1.4dbaad4fe3275p-57, -0x1.3e90cb503d1b5p-4, 0x1.a8aa353274217p-6, -0x1.2653904d146c2p-7,
     0x1.a07d6d931612cp-9, -0x1.2ab84a13a1524p-10, 0x1.b0d4c7ea05b2p-12, -0x1.3bed17820b0cp-13, 0x1.cf5bb4417614ap-15,
     -0x1.54444af5fae46p-16, 0x1.f1caa4fcfaf0ep-18}, /* [43] 2.6875 <= y <= 2.75, 60.7 bits */
    {0x1.08a4e3c4ac453p-2, 0x1.9f6847cb21acfp-58, -0x1.31b6aeba36bd1p-4, 0x1.8e3f74d7b13dfp-6, -0x1.0db0de269ee2ap-7,
     0x1.74d2e63074e18p-9, -0x1.053177f84710fp-10, 0x1.71a52166962ebp-12, -0x1.078e9854d2f1p-13, 0x1.79c5d7c1cfb18p-15,
     -0x1.0f5dc8f9d4a18p-16, 0x1.84e529fb1ecafp-18}, /* [44] 2.75 <= y <= 2.8125, 60.1 bits */
    {0x1.03f669024eecap-2, -0x1.6be2a6a04fc66p-56, -0x1.25a6ffa1be2c4p-4, 0x1.76049e44f8e2p-6, -0x1.ef3890924e88ep-8,
     0x1.4e95c5ab2737fp-9, -0x1.ca2d013f7f45p-11, 0x1.3cd3e0a46b7dap-12, -0x1.b9899bdc4be51p-14, 0x1.355d42c6b3259p-15,
     -0x1.b2d6a69802016p-17, 0x1.3139ae4a5ed2dp-18}, /* [45] 2.8125 <= y <= 2.875, 63.1 bits */
    {0x1.feed681d5f8e3p-3, -0x1.cbf0f17a6d441p-57, -0x1.1a5129910ae83p-4, 0x1.5fc03cffef76fp-6, -0x1.c78ab8d7c757fp-8,
     0x1.2cff6566db2edp-9, -0x1.930bd7b164864p-11, 0x1.108003552b87fp-12, -0x1.734f9aee2a84dp-14, 0x1.fcde8e67ff341p-16,
     -0x1.5df8b6dfab9f1p-17, 0x1.e14e137e9a465p-19}, /* [46] 2.875 <= y <= 2.9375, 62.5 bits */
    {0x1.f645f7ae6d0ap-3, 0x1.a54b108616cd6p-57, -0x1.0fa64707a9c45p-4, 0x1.4b3fdaaadb5a9p-6, -0x1.a3ce154a7591ep-8,
     0x1.0f6912880c1d8p-9, -0x1.638d7405bd90bp-11, 0x1.d64ebdf35bfd2p-13, -0x1.396fbed6bc7d1p-14, 0x1.a442d6bbe81a3p-16,
     -0x1.1ae9ec286c302p-17, 0x1.7d31882f9348dp-19}, /* [47] 2.9375 <= y <= 3, 60.1 bits */
    {0x1.edf15fb25912ap-3, 0x1.7ffa7241588a9p-59, -0x1.0598ed919b433p-4, 0x1.3857044307adbp-6, -0x1.838baa8e4e4b9p-8,
     0x1.ea8cbf25f15b2p-10, -0x1.3a80f67fc9e28p-11, 0x1.972512d9166d2p-13, -0x1.098bbe4cc2c2fp-14,
     0x1.5c7b1133437ffp-16, -0x1.cb618da4e0f18p-18, 0x1.2f3ee391542aep-19}, /* [48] 3 <= y <= 3.0625, 60.3 bits */
    {0x1.e5eae52254821p-3, 0x1.8bacb72f793c4p-58, -0x1.f83a02226e97ap-5, 0x1.26de76ea52f0dp-6, -0x1.665ca4f6a8146p-8,
     0x1.bc411f889f8a6p-10, -0x1.16ea2036c1c56p-11, 0x1.618a8e741899cp-13, -0x1.c384f2873288ap-15,
     0x1.2215c62fb3442p-16, -0x1.7685fb8aa23cbp-18, 0x1.e49394939cccep-20}, /* [49] 3.0625 <= y <= 3.125, 61.5 bits */
    {0x1.de2e2921bfdbdp-3, -0x1.1135bd34eb3b9p-58, -0x1.e64f1a3821d38p-5, 0x1.16b36d559de96p-6, -0x1.4be7dfd9ba56ap-8,
     0x1.9325c2d807ed8p-10, -0x1.efeed25d58cd9p-12, 0x1.33e4daf310f29p-13, -0x1.8128e6f97476cp-15,
     0x1.e4c37dcaca399p-17, -0x1.32957a3c85575p-18, 0x1.84d233d0fc71p-20}, /* [50] 3.125 <= y <= 3.1875, 60.9 bits */
    {0x1.d6b72049b1aap-3, -0x1.f223b5c708391p-57, -0x1.d55d46f9a5862p-5, 0x1.07b70849f1b45p-6, -0x1.33dfd818732d9p-8,
     0x1.6e8f1331e80d4p-10, -0x1.b9f433aabe5ccp-12, 0x1.0ce4d161eb5bep-13, -0x1.499d634133505p-15,
     0x1.96837d0f41ea1p-17, -0x1.f7eb757e2e389p-19, 0x1.394a049816e09p-20}, /* [51] 3.1875 <= y <= 3.25, 63.0 bits */
    {0x1.cf820aee78c07p-3, 0x1.529e16a06a624p-57, -0x1.c5527e28d1cd1p-5, 0x1.f39b9b3ad6a2ap-7, -0x1.1e00f6032f9f7p-8,
     0x1.4dea7abd5d98dp-10, -0x1.8abff07f28efap-12, 0x1.d6ef32f53bd8p-14, -0x1.1af4d82771796p-15, 0x1.5615d25bf38ccp-17,
     -0x1.9fb890baf325p-19, 0x1.faea291e17996p-21}, /* [52] 3.25 <= y <= 3.3125, 62.4 bits */
    {0x1.c88b6e3ec6e34p-3, -0x1.5bb4c2622a09ap-57, -0x1.b61e54eb5e0f9p-5, 0x1.d9be740cadd52p-7, -0x1.0a101eba8fccp-8,
     0x1.30ba59584345fp-10, -0x1.615c661f6e36cp-12, 0x1.9d75dd83c901dp-14, -0x1.e741bb3d43049p-16,
     0x1.20d655e28e8a6p-17, -0x1.583abc5fbb85cp-19, 0x1.9bbaf833d6989p-21}, /* [53] 3.3125 <= y <= 3.375, 61.5 bits */
    {0x1.c1d00e20e767ap-3, -0x1.6564ba8db79a1p-57, -0x1.a7b1d363834c3p-5, 0x1.c1aac55bf7535p-7, -0x1.efb30093a19d2p-9,
     0x1.1692b1316b4e5p-10, -0x1.3cfa8eb91be6bp-12, 0x1.6be7ad359d4dfp-14, -0x1.a4bd1e1f92addp-16,
     0x1.e9568d7e5ca6dp-18, -0x1.1e0db61d7e3f7p-19, 0x1.4fb56dcf578e8p-21}, /* [54] 3.375 <= y <= 3.4375, 61.5 bits */
    {0x1.bb4ce7b659314p-3, -0x1.157fbf12454cdp-57, -0x1.99ff4dc253a76p-5, 0x1.ab39480cbac12p-7, -0x1.ce5f1c5d52c83p-9,
     0x1.fe2cce9f2118dp-11, -0x1.1ceb5b81edf58p-12, 0x1.410e7acc11ea4p-14, -0x1.6c4e6960da6c3p-16,
     0x1.9fce6ed8bbfbdp-18, -0x1.dd10f03c3daf8p-20, 0x1.12bfd80c4a584p-21}, /* [55] 3.4375 <= y <= 3.5, 62.1 bits */
    {0x1.b4ff2c7176799p-3, 0x1.c56bfe722f678p-59, -0x1.8cfa4210a7f41p-5, 0x1.9646b7a33a771p-7, -0x1.afd44bedd1557p-9,
     0x1.d3e9f862737f4p-11, -0x1.009a4c33d1d16p-12, 0x1.1be82189c6163p-14, -0x1.3c487833bdf22p-16,
     0x1.6263b8dd828dbp-18, -0x1.8f25577c480f6p-20, 0x1.c35ac0494ea93p-22}, /* [56] 3.5 <= y <= 3.5625, 60.9 bits */
    {0x1.aee43daba3199p-3, -0x1.f34c178536784p-59, -0x1.80973a09ad1a4p-5, 0x1.82b359481dd78p-7, -0x1.93cbaa5534e59p-9,
     0x1.add14c9d3a1cdp-11, -0x1.cf1208d53768bp-13, 0x1.f73a1563be50ap-15, -0x1.134b7ef3daf07p-16, 0x1.2eec2ef4d724p-18,
     -0x1.4f08754fb1c42p-20, 0x1.740c29d86cb82p-22}, /* [57] 3.5625 <= y <= 3.625, 60.9 bits */
    {0x1.a8f9a8acda428p-3, -0x1.8e49245a451ap-59, -0x1.74cbb07b287fdp-5, 0x1.706292e78f202p-7, -0x1.7a0675f06b112p-9,
     0x1.8b69795ec6254p-11, -0x1.a29759d260fbcp-13, 0x1.bef1232ce283cp-15, -0x1.e06c222d500e1p-17,
     0x1.03a804669bd0cp-18, -0x1.1a18fbddfe086p-20, 0x1.33b96d8cfde1dp-22}, /* [58] 3.625 <= y <= 3.6875, 64.2 bits */
    {0x1.a33d231779324p-3, 0x1.dc6082625517dp-58, -0x1.698df9b46c161p-5, 0x1.5f3a9009640d2p-7, -0x1.624d0230a003fp-9,
     0x1.6c48c6812f19ap-11, -0x1.7b0bf2898e2e8p-13, 0x1.8dc5bbed0697ap-15, -0x1.a4327c1040c0bp-17,
     0x1.be58265c36f6fp-19, -0x1.dc7cb9852eb0fp-21, 0x1.febb1467db71ep-23}, /* [59] 3.6875 <= y <= 3.75, 62.6 bits */
    {0x1.9dac87acdc97cp-3, 0x1.700f1b365342ep-59, -0x1.5ed52e9e692f6p-5, 0x1.4f23f26360cb6p-7, -0x1.4c6dd0595be9bp-9,
     0x1.5012dab08ee3cp-11, -0x1.57d16538d4b5fp-13, 0x1.62b7d00502424p-15, -0x1.705e30dcc0bb6p-17,
     0x1.80a194e31e71fp-19, -0x1.9396c7d75e659p-21, 0x1.a930daed4b531p-23}, /* [60] 3.75 <= y <= 3.8125, 61.8 bits */
    {0x1.9845d360de78bp-3, 0x1.4ab35067d8a32p-57, -0x1.54991a25f82e3p-5, 0x1.40098c782f208p-7, -0x1.383cc90aef809p-9,
     0x1.3676da09f42f6p-11, -0x1.385f5cc59dc34p-13, 0x1.3ceed3f3d5e73p-15, -0x1.43a645a6fa8b2p-17,
     0x1.4c4983ba6b5f2p-19, -0x1.56ceedf236826p-21, 0x1.6313f6f6ce434p-23}, /* [61] 3.8125 <= y <= 3.875, 62.7 bits */
    {0x1.930722b384b41p-3, 0x1.06b518b7cc7e2p-57, -0x1.4ad228adc0302p-5, 0x1.31d824d90d417p-7, -0x1.2592917e01f71p-9,
     0x1.1f2dcf0d63e49p-11, -0x1.1c403a8293eb4p-13, 0x1.1bb320524900ep-15, -0x1.1cf8758e10044p-17,
     0x1.1fc440d1abfa2p-19, -0x1.23f9cf2f0b228p-21, 0x1.296b47a2232eep-23}, /* [62] 3.875 <= y <= 3.9375, 63.6 bits */
    {0x1.8deeaf494527ep-3, -0x1.92007d6d9e156p-57, -0x1.417959479329dp-5, 0x1.247e40d822ce6p-7, -0x1.144bf83222a0cp-9,
     0x1.09f9516b4422fp-11, -0x1.030e441764eeep-13, 0x1.fcd10801fa48fp-16, -0x1.f6deca0202985p-18,
     0x1.f398d8d33aab9p-20, -0x1.f2aca7a8971c3p-22, 0x1.f3b2c35d464d8p-24}, /* [63] 3.9375 <= y <= 4, 61.0 bits */
    {0x1.88facdbb3311dp-3, 0x1.f13d59e5cc131p-58, -0x1.3888307de3ac7p-5, 0x1.17ebf5a7f2e9fp-7, -0x1.0449758611176p-9,
     0x1.ed44c0ec25e68p-12, -0x1.d8e28f6b75b5ep-14, 0x1.c9139aece8233p-16, -0x1.bc956a9ec70cp-18, 0x1.b2ab3978e0292p-20,
     -0x1.aaf025e6c326fp-22, 0x1.a4f5d68913f84p-24}, /* [64] 4 <= y <= 4.0625, 62.4 bits */
    {0x1.8429eb99374ep-3, 0x1.f2b15a705488p-58, -0x1.2ff8ac7d75d2fp-5, 0x1.0c12bf0b3a9d4p-7, -0x1.eadd7a89a4edbp-10,
     0x1.c9f0d1a51213ep-12, -0x1.b0394372fe21bp-14, 0x1.9b4a386547cd3p-16, -0x1.89d12dd1d7015p-18,
     0x1.7b0367650fe81p-20, -0x1.6e6cb8e81f2a5p-22, 0x1.63995613e0afep-24}, /* [65] 4.0625 <= y <= 4.125, 62.2 bits */
    {0x1.7f7a8d9927795p-3, -0x1.2f8a668360b24p-57, -0x1.27c53a75cc72p-5, 0x1.00e55ad91109bp-7, -0x1.cf44bd59b2a45p-10,
     0x1.a9a0dcf213061p-12, -0x1.8b9b2587294ep-14, 0x1.72b1a9b2bdd6cp-16, -0x1.5d811b38ceaeap-18, 0x1.4b30a776fcd55p-20,
     -0x1.3b3db274af071p-22, 0x1.2d2e7d00daad4p-24}, /* [66] 4.125 <= y <= 4.1875, 61.3 bits */
    {0x1.7aeb4dee2ad01p-3, -0x1.0e44cc2928cbp-57, -0x1.1fe8ad0c4491dp-5, 0x1.ecaf5168ddf1dp-8, -0x1.b59ae1b6e5d06p-10,
     0x1.8c08aa9ac3df5p-12, -0x1.6a93b109feef9p-14, 0x1.4ea233d6af9p-16, -0x1.36be54bf48c4fp-18, 0x1.2200035c5472ep-20,
     -0x1.0fd5eabd86444p-22, 0x1.ff7e46b5ca742p-25}, /* [67] 4.1875 <= y <= 4.25, 61.1 bits */
    {0x1.767adac4624a9p-3, -0x1.216ea4b8c4635p-57, -0x1.185e33c2796ebp-5, 0x1.d8bd1ada87504p-8, -0x1.9db693b497caap-10,
     0x1.70e48716e50c9p-12, -0x1.4cbcfbef6a13p-14, 0x1.2e8b61f4fc3b2p-16, -0x1.14c51590e924p-18, 0x1.fce26b21042f9p-21,
     -0x1.d5dde21c01a15p-23, 0x1.b369a0700b439p-25}, /* [68] 4.25 <= y <= 4.3125, 62.6 bits */
    {0x1.7227f4dd3ede5p-3, -0x1.12e7e549f4c23p-57, -0x1.112153348a323p-5, 0x1.c5dfb329522dfp-8, -0x1.87727da4bc755p-10,
     0x1.57f83426efcedp-12, -0x1.31bdb396d6f2ap-14, 0x1.11f081c4e712fp-16, -0x1.eddde0e5d3c2p-19, 0x1.bf5b64e4a81f2p-21,
     -0x1.96f74bd45bd19p-23, 0x1.738af9daf1e98p-25}, /* [69] 4.3125 <= y <= 4.375, 64.1 bits */
    {0x1.6df16e49575b4p-3, -0x1.36b4b234571d7p-58, -0x1.0a2dde174a6abp-5, 0x1.b40465bc7895dp-8, -0x1.72acd8430c9a4p-10,
     0x1.410dfe9057a0fp-12, -0x1.194766e342c73p-14, 0x1.f0cb65147f297p-17, -0x1.b95c21f5fee63p-19,
     0x1.8a02c2818aa61p-21, -0x1.613b09f763c5cp-23, 0x1.3dc8c9f1cbb63p-25}, /* [70] 4.375 <= y <= 4.4375, 61.5 bits */
    {0x1.69d6293ce9257p-3, -0x1.a9b0130d48fd6p-57, -0x1.037feee15cca5p-5, 0x1.a319ffed27e85p-8, -0x1.5f470880d070ap-10,
     0x1.2bf5f375903fcp-12, -0x1.031511125e5eep-14, 0x1.c31ada0a75666p-17, -0x1.8b129e7a869dfp-19,
     0x1.5ba95df626333p-21, -0x1.33381a83b8a3bp-23, 0x1.106c0d7fa303bp-25}, /* [71] 4.4375 <= y <= 4.5, 62.4 bits */
    {0x1.65d516fc7dcf1p-3, -0x1.0ea638c0de15dp-58, -0x1.fa27c4198e2fcp-6, 0x1.9310ad0562c5fp-8, -0x1.4d25491dc43d2p-10,
     0x1.188530a57b225p-12, -0x1.ddd3b5fbe7041p-15, 0x1.9a2cdf0e921a8p-17, -0x1.6231de3d74c1fp-19,
     0x1.334f6e57cb965p-21, -0x1.0bbbad7ec5cfdp-23, 0x1.d41950fc57bp-26}, /* [72] 4.5 <= y <= 4.5625, 62.3 bits */
    {0x1.61ed36df74d18p-3, 0x1.3b5579ba192f2p-57, -0x1.edcca1c18b81ap-6, 0x1.83d9d60cd4c5ep-8, -0x1.3c2e5e7ec4d3cp-10,
     0x1.06954bfa3cc79p-12, -0x1.b920146de9511p-15, 0x1.7573fa57f46b8p-17, -0x1.3e07d81e25103p-19,
     0x1.101c9957539dfp-21, -0x1.d38bf4594446ap-24, 0x1.9306b7e4e3736p-26}, /* [73] 4.5625 <= y <= 4.625, 63.2 bits */
    {0x1.5e1d95666d997p-3, -0x1.61854a287e4ap-57, -0x1.e1e8196b23ef2p-6, 0x1.756804f0ea741p-8, -0x1.2c4b536c68477p-10,
     0x1.ec079cf7b110bp-13, -0x1.97b02db6fb808p-15, 0x1.5474c4905d912p-17, -0x1.1dfb6fe3abb54p-19,
     0x1.e2b2de281296dp-22, -0x1.990269523518ap-24, 0x1.5bb8cefe1c902p-26}, /* [74] 4.625 <= y <= 4.6875, 62.4 bits */
    {0x1.5a654b63c3e29p-3, 0x1.f6364fbe6bdfap-59, -0x1.d674354af30d7p-6, 0x1.67aecaa45b042p-8, -0x1.1d673d94304ebp-10,
     0x1.cd6380fa354cp-13, -0x1.792fc470eac38p-15, 0x1.36c3653c80738p-17, -0x1.0188b1979fb73p-19, 0x1.acd41736703d7p-22,
     -0x1.66746af9a724cp-24, 0x1.2c9d1417ef9b6p-26}, /* [75] 4.6875 <= y <= 4.75, 62.0 bits */
    {0x1.56c37d347fe87p-3, -0x1.6689353165a2dp-58, -0x1.cb6b5f4039464p-6, 0x1.5aa2a7df13aacp-8, -0x1.0f6f08d01c5bdp-10,
     0x1.b10688abf415cp-13, -0x1.5d5412822e17ap-15, 0x1.1c016fd39fa33p-17, -0x1.d07b527d60443p-20,
     0x1.7d934ebaa357dp-22, -0x1.3ab4fc5f2186fp-24, 0x1.046613fb388ffp-26}, /* [76] 4.75 <= y <= 4.8125, 62.1 bits */
    {0x1.53375a0846044p-3, 0x1.fec9e6fdb7737p-58, -0x1.c0c859abd786bp-6, 0x1.4e38f83270522p-8, -0x1.0251485b4235fp-10,
     0x1.96be7b7301f3dp-13, -0x1.43da9d692bdf1p-15, 0x1.03dc11f33f678p-17, -0x1.a36f77d6b5f3ap-20,
     0x1.540dd50e606ccp-22, -0x1.14c6ac51ead0bp-24, 0x1.c3fdf2ea3d325p-27}, /* [77] 4.8125 <= y <= 4.875, 64.0 bits */
    {0x1.4fc01b36f6a41p-3, -0x1.fc4c923a1fb55p-60, -0x1.b68638e638d85p-6, 0x1.4267df2f26c77p-8, -0x1.ebfc1a6f7e61p-11,
     0x1.7e5e07e31739p-13, -0x1.2c8832e8b0a89p-15, 0x1.dc150b90a7d0bp-18, -0x1.7b42d8339de43p-20, 0x1.2f81bf98324e6p-22,
     -0x1.e7a726d8b5295p-25, 0x1.8901d16dbba9fp-27}, /* [78] 4.875 <= y <= 4.9375, 61.5 bits */
    {0x1.4c5d03a2d0aaep-3, -0x1.f960157304252p-57, -0x1.aca05d448b0bp-6, 0x1.3726376279dfp-8, -0x1.d4cd82473f218p-11,
     0x1.67bc3b1592545p-13, -0x1.1728083516463p-15, 0x1.b4997beea05f4p-18, -0x1.5760ee83ba285p-20,
     0x1.0f48d3e3b6da8p-22, -0x1.ae4d80f944bccp-25, 0x1.5656556392e5ep-27}, /* [79] 4.9375 <= y <= 5, 61.5 bits */
    {0x1.490d5f2605c97p-3, 0x1.d86d01633e5e3p-58, -0x1.a3126d9f5de3ap-6, 0x1.2c6b82f7619dbp-8, -0x1.befc0b1feca3ep-11,
     0x1.52b40862ee4c1p-13, -0x1.038af6ac7cacbp-15, 0x1.90d4842f89a1fp-18, -0x1.37487b8d593c3p-20,
     0x1.e5a893a442857p-23, -0x1.7c4d9c22d5299p-25, 0x1.2aba674d6267dp-27}, /* [80] 5 <= y <= 5.0625, 63.8 bits */
    {0x1.45d0820acaa5fp-3, -0x1.a79e49a2123bbp-57, -0x1.99d8524e41a53p-6, 0x1.222fddce7cdcp-8, -0x1.aa6f2c3fc127fp-11,
     0x1.3f23df59ebf3p-13, -0x1.e30da3d07d33ap-16, 0x1.706268a3e3b7cp-18, -0x1.1a88d215554fdp-20, 0x1.b3527e810102cp-23,
     -0x1.50a2d2b1ec791p-25, 0x1.051f6e733d20dp-27}, /* [81] 5.0625 <= y <= 5.125, 62.2 bits */
    {0x1.42a5c88d041bap-3, -0x1.8a275d0e831bp-57, -0x1.90ee308d51456p-6, 0x1.186bf0e4fa633p-8, -0x1.97105c8a208d2p-11,
     0x1.2ced4e1dfc9cdp-13, -0x1.c1eba732c475p-16, 0x1.52eaf3c839ea9p-18, -0x1.00bf8b1ff5207p-20, 0x1.86bb7c705fba8p-23,
     -0x1.2a6f3d227c279p-25, 0x1.c944afb49222p-28}, /* [82] 5.125 <= y <= 5.1875, 61.7 bits */
    {0x1.3f8c9664c7d3ep-3, -0x1.ec76d1f5ff46dp-58, -0x1.88506642c01a2p-6, 0x1.0f18e6e750499p-8, -0x1.84cae33a3f3eap-11,
     0x1.1bf4ae9817cc4p-13, -0x1.a36c3455901d9p-16, 0x1.382002add1ddcp-18, -0x1.d32d232bb3e52p-21,
     0x1.5f2c795bfb741p-23, -0x1.08f58d5d1b88bp-25, 0x1.91083d6095b1cp-28}, /* [83] 5.1875 <= y <= 5.25, 61.3 bits */
    {0x1.3c845658f9392p-3, -0x1.3caf4a2dad673p-57, -0x1.7ffb861b8b78fp-6, 0x1.063061d0a8f93p-8, -0x1.738bad7d60f92p-11,
     0x1.0c20dd1ceebdfp-13, -0x1.87526f2dba332p-16, 0x1.1fbc43fa7ac44p-18, -0x1.a984eee0ddf5dp-21,
     0x1.3c070271822b3p-23, -0x1.d727e67f5e25cp-26, 0x1.6045037eead3cp-28}, /* [84] 5.25 <= y <= 5.3125, 62.0 bits */
    {0x1.398c79d95c969p-3, 0x1.1fdbc498496adp-60, -0x1.77ec53f75afc7p-6, 0x1.fb58e2f6f596p-9, -0x1.6341285f001efp-11,
     0x1.fab5eeb5f4057p-14, -0x1.6d679c7eb0f8bp-16, 0x1.0982221afb68bp-18, -0x1.840211cd6cf0ap-21,
     0x1.1cc1b7875613dp-23, -0x1.a37fb21b473eap-26, 0x1.35eb19bd435d1p-28}, /* [85] 5.3125 <= y <= 5.375, 62.2 bits */
    {0x1.36a4789f894d9p-3, -0x1.cf51961c10d18p-58, -0x1.701fc19c69c94p-6, 0x1.eb0f1615b6abdp-9, -0x1.53db1e8ab95cdp-11,
     0x1.df1c4516e7a87p-14, -0x1.557a73ce45554p-16, 0x1.ea75a4d5574f3p-19, -0x1.623027fc9f73bp-21,
     0x1.00e548f907ee3p-23, -0x1.7604ab37228b1p-26, 0x1.1112b580945adp-28}, /* [86] 5.375 <= y <= 5.4375, 64.0 bits */
    {0x1.33cbd05631989p-3, -0x1.4d4fdf524d899p-59, -0x1.6892ebad0b794p-6, 0x1.db79022db3816p-9, -0x1.454a9977093ecp-11,
     0x1.c54eb00815b72p-14, -0x1.3f5e8666e852dp-16, 0x1.c56b081201eabp-19, -0x1.43a8b8f2f3e45p-21,
     0x1.d013d583a5d68p-24, -0x1.4dea6184f0d71p-26, 0x1.e1edff855f596p-29}, /* [87] 5.4375 <= y <= 5.5, 62.0 bits */
    {0x1.3102044642882p-3, 0x1.13805b5b2e3cap-58, -0x1.614316d90332fp-6, 0x1.cc8cf911212efp-9, -0x1.3781c599186e1p-11,
     0x1.ad2a6ec9b889bp-14, -0x1.2aebb8a7309f3p-16, 0x1.a38d53c789126p-19, -0x1.28116ad228c3dp-21,
     0x1.a3aa53f59beadp-24, -0x1.2a80c69e38723p-26, 0x1.a9e125cf71938p-29}, /* [88] 5.5 <= y <= 5.5625, 64.2 bits */
    {0x1.2e469d0969e3ap-3, 0x1.98f920b231f95p-57, -0x1.5a2dad4575521p-6, 0x1.be41ec297619ep-9, -0x1.2a73d94d48c3ap-11,
     0x1.968fbb6fa5a18p-14, -0x1.17fdcb408bef2p-16, 0x1.848eb8528e093p-19, -0x1.0f1a757d1fce3p-21,
     0x1.7bf029f7cadb3p-24, -0x1.0b2ff9ae466a1p-26, 0x1.78e17c94a82cbp-29}, /* [89] 5.5625 <= y <= 5.625, 62.0 bits */
    {0x1.2b9928419982fp-3, -0x1.bb39bca7ecb2fp-58, -0x1.53503c26be13p-6, 0x1.b08f608ae98abp-9, -0x1.1e14fe2a2f36ep-11,
     0x1.816181d90ac35p-14, -0x1.0673f25b322d8p-16, 0x1.68299bcdc5b3fp-19, -0x1.f0fa987e44182p-22,
     0x1.585b5216947b3p-24, -0x1.dee9754669a57p-27, 0x1.4dfaa9587f306p-29}, /* [90] 5.625 <= y <= 5.6875, 62.9 bits */
    {0x1.28f9385528aa6p-3, -0x1.fa89006f6268dp-59, -0x1.4ca87187ebc97p-6, 0x1.a36d640add1f6p-9, -0x1.125a3c7c59b67p-11,
     0x1.6d851e5d45216p-14, -0x1.ec60f1ba4cfadp-17, 0x1.4e1fa824518b8p-19, -0x1.c7f6ebf03aa03p-22,
     0x1.3872f5694b0cbp-24, -0x1.adbadf99001d8p-27, 0x1.285c3fd3bcaap-29}, /* [91] 5.6875 <= y <= 5.75, 65.4 bits */
    {0x1.2666642f3c0cap-3, 0x1.52e646c6fcb73p-58, -0x1.46341a3c02ef5p-6, 0x1.96d48340a9d3ep-9, -0x1.073968b0d90cdp-11,
     0x1.5ae2234aa5bbdp-14, -0x1.ce30dc9e8716cp-17, 0x1.3638f743ff775p-19, -0x1.a2bb1a1d009a7p-22,
     0x1.1bcd1f6ce6d69p-24, -0x1.820f31493387p-27, 0x1.0753a20d162ap-29}, /* [92] 5.75 <= y <= 5.8125, 64.9 bits */
    {0x1.23e0470424699p-3, -0x1.e2d1209bb36eap-58, -0x1.3ff11ff58f38cp-6, 0x1.8abdc05ad9f48p-9, -0x1.f95224f658ec6p-12,
     0x1.4962247041991p-14, -0x1.b226bc1f41c33p-17, 0x1.20435967fa7dep-19, -0x1.80e4c2e1dfe65p-22,
     0x1.020cc5dee23ffp-24, -0x1.5b3b59f2fa2cdp-27, 0x1.d48dd117d16a6p-30}, /* [93] 5.8125 <= y <= 5.875, 62.3 bits */
    {0x1.216680196a67p-3, -0x1.ea1d61daee55dp-57, -0x1.39dd87815812fp-6, 0x1.7f228ab51e371p-9, -0x1.e540eb11fe6abp-12,
     0x1.38f088046ede6p-14, -0x1.98161d5ad8a4cp-17, 0x1.0c11b207c383bp-19, -0x1.621c6fa31210dp-22,
     0x1.d5c02f88f677dp-25, -0x1.38aa90af72ep-27, 0x1.a163f88ff7e77p-30}, /* [94] 5.875 <= y <= 5.9375, 62.3 bits */
    {0x1.1ef8b29144479p-3, -0x1.a92c56657dcc3p-57, -0x1.33f76f21599fep-6, 0x1.73fcb71d4fa1p-9, -0x1.d22ed73688c1fp-12,
     0x1.297a5c4ed394fp-14, -0x1.7fd690e184a4cp-17, 0x1.f2f6d0e679d88p-20, -0x1.461443fd92815p-22,
     0x1.abfe1201dbcf9p-25, -0x1.19db3b8dd7c91p-27, 0x1.744865877145cp-30}, /* [95] 5.9375 <= y <= 6, 61.5 bits */
    {0x1.1c968539379cbp-3, -0x1.6574836b1142cp-60, -0x1.2e3d0d0566548p-6, 0x1.694678b799cd6p-9, -0x1.c00cbfc174afcp-12,
     0x1.1aee318f6570dp-14, -0x1.694344643080bp-17, 0x1.d0b7d31d8b9a9p-20, -0x1.2c86d9b7154a7p-22,
     0x1.8654233558adap-25, -0x1.fcb897a430abap-28, 0x1.4c6def3b44daap-30}, /* [96] 6 <= y <= 6.0625, 61.4 bits */
    {0x1.1a3fa25bae0bdp-3, -0x1.1d9bbce2c443p-57, -0x1.28acaddf11b18p-6, 0x1.5efa5a73807d8p-9, -0x1.aecc86e3a5038p-12,
     0x1.0d3bf7abcf0ep-14, -0x1.543aa782759e6p-17, 0x1.b12470f998223p-20, -0x1.153641f75b08fp-22, 0x1.6452311eb7ee1p-25,
     -0x1.cb95f8cdcd18dp-28, 0x1.29355f73e4e4ep-30}, /* [97] 6.0625 <= y <= 6.125, 62.4 bits */
    {0x1.17f3b79448c6p-3, 0x1.8e59c4b017e7cp-57, -0x1.2344b38ebae0dp-6, 0x1.55133904de383p-9, -0x1.9e6105a2ea089p-12,
     0x1.0054df3ab3b88p-14, -0x1.409e1a68ce34bp-17, 0x1.9401189eae4aep-20, -0x1.ffd64d6a96246p-23,
     0x1.459509a84a501p-25, -0x1.9fa1c3f02c118p-28, 0x1.0a06358742886p-30}, /* [98] 6.125 <= y <= 6.1875, 62.0 bits */
    {0x1.15b275a6c2731p-3, -0x1.b17729e04d609p-58, -0x1.1e0393e7bef67p-6, 0x1.4b8c3d553d4e1p-9, -0x1.8ebdf8b2547fep-12,
     0x1.e8567b210ee7ep-15, -0x1.2e51a51a625a9p-17, 0x1.7917f23be396cp-20, -0x1.d8e80ffd56dadp-23,
     0x1.29c4dbeab8bddp-25, -0x1.7844900f8704cp-28, 0x1.dcc39b022f01bp-31}, /* [99] 6.1875 <= y <= 6.25, 61.5 bits */
    {0x1.137b905833128p-3, 0x1.69fa6083f7467p-58, -0x1.18e7d78a06c11p-6, 0x1.4260d7630d88ep-9, -0x1.7fd7eef3d4f64p-12,
     0x1.d164e6f8c6e93p-15, -0x1.1d3bb66676107p-17, 0x1.60384629704f2p-20, -0x1.b54922c2bf5d6p-23,
     0x1.1093d1104637ep-25, -0x1.54f9872ff4335p-28, 0x1.abb30eecc25ffp-31}, /* [100] 6.25 <= y <= 6.3125, 64.6 bits */
    {0x1.114ebe4a8cc78p-3, 0x1.4d694b5944133p-57, -0x1.13f018cf4c011p-6, 0x1.398cb9853b12cp-9, -0x1.71a4397a7531fp-12,
     0x1.bbbdacd939299p-15, -0x1.0d44e9a939018p-17, 0x1.4935f4834a595p-20, -0x1.94aa0888508abp-23,
     0x1.f379a8e8a7ca4p-26, -0x1.354bf7487cd5bp-28, 0x1.8016a5b3b44cep-31}, /* [101] 6.3125 <= y <= 6.375, 61.9 bits */
    {0x1.0f2bb8da2ba54p-3, -0x1.ba440186c8322p-57, -0x1.0f1b02ca95f11p-6, 0x1.310bd40a924fap-9, -0x1.6418dce8b9fcbp-12,
     0x1.a74b37762dd01p-15, -0x1.fcafa5267f631p-18, 0x1.33e8fc1d71eb4p-20, -0x1.76c368e042482p-23,
     0x1.ca05087fab035p-26, -0x1.18d53b72e33bfp-28, 0x1.5950a5b7dfb4bp-31}, /* [102] 6.375 <= y <= 6.4375, 61.7 bits */
    {0x1.0d123bfd55726p-3, -0x1.a0747442d69dp-59, -0x1.0a6750588db97p-6, 0x1.28da512d2b811p-9, -0x1.572c840a80f6ep-12,
     0x1.93f98bd10cc6ap-15, -0x1.e0c19c95b104dp-18, 0x1.202d0ef67f23bp-20, -0x1.5b5528dc846bcp-23,
     0x1.a45c8b33628f3p-26, -0x1.fe75d8080b0fp-29, 0x1.36c567c2cd6b7p-31}, /* [103] 6.4375 <= y <= 6.5, 62.6 bits */
    {0x1.0b02062588fa9p-3, -0x1.46abd80a2c45bp-58, -0x1.05d3cb3f68ff5p-6, 0x1.20f49152d2d8cp-9, -0x1.4ad6738d0762p-12,
     0x1.81b6272844497p-15, -0x1.c69bb29e7c9bfp-18, 0x1.0de1328a7a6d6p-20, -0x1.42259f5ef1173p-23,
     0x1.821eeccd5b85cp-26, -0x1.d05a9c90b2731p-29, 0x1.17f822c5ebb6ep-31}, /* [104] 6.5 <= y <= 6.5625, 61.4 bits */
    {0x1.08fad8227eec2p-3, -0x1.c186f32bbcd85p-61, -0x1.015f4b5d439cep-6, 0x1.195727940877cp-9, -0x1.3f0e7ebac0e93p-12,
     0x1.706fe005c634ep-15, -0x1.ae1cd32f9819fp-18, 0x1.f9ced53a12a13p-21, -0x1.2b00e17abf7dp-23, 0x1.62f573503b0bep-26,
     -0x1.a6cbfadba94c3p-29, 0x1.f8f2a65d0c7ccp-32}, /* [105] 6.5625 <= y <= 6.625, 61.9 bits */
    {0x1.06fc7506c076ep-3, 0x1.8cf3d8128e142p-58, -0x1.fa116bc7b3db7p-7, 0x1.11fed683c9cffp-9, -0x1.33ccfd234bc41p-12,
     0x1.6016ca1ca102ap-15, -0x1.972698f24e013p-18, 0x1.da48da7f9330cp-21, -0x1.15b823dd2a27p-23, 0x1.4692b48206f24p-26,
     -0x1.814d7d45d7d01p-29, 0x1.c7ce718129ecfp-32}, /* [106] 6.625 <= y <= 6.6875, 63.7 bits */
    {0x1.0506a20db9e66p-3, 0x1.1fad43a715003p-58, -0x1.f19df941568bp-7, 0x1.0ae88d32dcd94p-9, -0x1.290ac11a2c027p-12,
     0x1.509c1cae64ea5p-15, -0x1.819d0fd04e7ddp-18, 0x1.bcfebe02a2fcp-21, -0x1.02212e9ba6485p-23, 0x1.2cb182bec13dep-26,
     -0x1.5f70ff5864bfap-29, 0x1.9bd179ba760c7p-32}, /* [107] 6.6875 <= y <= 6.75, 62.5 bits */
    {0x1.03192683314eep-3, 0x1.06ba721a3fb0dp-58, -0x1.e9623aa14094dp-7, 0x1.04116469cf1e6p-9, -0x1.1ec10ef91305bp-12,
     0x1.41f21b38ae621p-15, -0x1.6d667d7cbc261p-18, 0x1.a1c32ca73eeb7p-21, -0x1.e02bc23fd0cb9p-24,
     0x1.1513fb718c566p-26, -0x1.40d4d9c43b6b2p-29, 0x1.7475029fc6ec2p-32}, /* [108] 6.75 <= y <= 6.8125, 62.5 bits */
    {0x1.0133cbac0b1a2p-3, 0x1.f3bb325f093cdp-57, -0x1.e15c41fcc690ap-7, 0x1.faed382a908e2p-10, -0x1.14e9951459be8p-12,
     0x1.340c0031f586dp-15, -0x1.5a6b2f5d62938p-18, 0x1.886ccaad14196p-21, -0x1.bee7886c27d8bp-24,
     0x1.ff0567730de47p-27, -0x1.2522842e89ecfp-29, 0x1.512fde350a083p-32}, /* [109] 6.8125 <= y <= 6.875, 65.3 bits */
    {0x1.feacb9608fa7ep-4, 0x1.ac6b2e5e808efp-61, -0x1.d98a36d552912p-7, 0x1.ee2b31c1657a2p-10, -0x1.0b7e645202cd2p-12,
     0x1.26dde9a2c1b9dp-15, -0x1.48954d4399b9bp-18, 0x1.70d5d29940933p-21, -0x1.a037510b29c79p-24,
     0x1.d797fc48c696dp-27, -0x1.0c0d0fecaca45p-29, 0x1.3185136927bb7p-32}, /* [110] 6.875 <= y <= 6.9375, 62.0 bits */
    {0x1.fb014d0c5011ep-4, 0x1.e08b6ee4e6a4p-59, -0x1.d1ea54fb73f48p-7, 0x1.e1d7c3f72cdadp-10, -0x1.0279e9551af51p-12,
     0x1.1a5cc76db24aep-15, -0x1.37d0b074aa2ffp-18, 0x1.5adbbe2ed3d56p-21, -0x1.83e29fe753badp-24,
     0x1.b3868db4c6b19p-27, -0x1.eaa03f4c0b3bep-30, 0x1.15131136c17f9p-32}, /* [111] 6.9375 <= y <= 7, 62.7 bits */
    {0x1.f764efbcc8c21p-4, -0x1.212ac8b22f09ep-58, -0x1.ca7aeb8324c4fp-7, 0x1.d5ee3e0ca50bcp-10, -0x1.f3adcc614f1cbp-13,
     0x1.0e7e4b1d8578fp-15, -0x1.280abe8fdf879p-18, 0x1.465ef857224b5p-21, -0x1.69b6414458d5cp-24,
     0x1.92810713c9fa1p-27, -0x1.c15db2c647bd3p-30, 0x1.f6ff892650f1ap-33}, /* [112] 7 <= y <= 7.0625, 62.5 bits */
    {0x1.f3d74222d2b09p-4, -0x1.f2220c060c1e6p-58, -0x1.c33a5bc816075p-7, 0x1.ca6a2c4658799p-10, -0x1.e320d92d106cdp-13,
     0x1.0338d91478d3p-15, -0x1.193247ed171c4p-18, 0x1.334296fd2fa68p-21, -0x1.5183c0cccc98bp-24, 0x1.743f685df202fp-27,
     -0x1.9be60acc01251p-30, 0x1.c8f84e3c0c9fp-33}, /* [113] 7.0625 <= y <= 7.125, 62.1 bits */
    {0x1.f057e81b0e3b5p-4, 0x1.918d4cbcc05fdp-58, -0x1.bc271880eb97ep-7, 0x1.bf475451d603p-10, -0x1.d343b0ef8ded8p-13,
     0x1.f106f5f83240bp-16, -0x1.0b376919bb7a4p-18, 0x1.216c1bfd4e1a3p-21, -0x1.3b20ef72146b5p-24,
     0x1.5880e59feda7bp-27, -0x1.79d88e910c8eap-30, 0x1.9f7fd89be10c8p-33}, /* [114] 7.125 <= y <= 7.1875, 63.3 bits */
    {0x1.ece6888c0e55p-4, 0x1.3c642664b649p-58, -0x1.b53fa4e0657f4p-7, 0x1.b481b1e8ed2e2p-10, -0x1.c40d961997b0ep-13,
     0x1.dcaba6afd4e8ap-16, -0x1.fc16de47dddc9p-19, 0x1.10c33c642b7f7p-21, -0x1.266776805b52ep-24,
     0x1.3f0b205f2ea96p-27, -0x1.5adee922d538cp-30, 0x1.7a1b5cd5aaaf4p-33}, /* [115] 7.1875 <= y <= 7.25, 62.0 bits */
    {0x1.e982cd46343bcp-4, -0x1.2fab190404e38p-58, -0x1.ae8293c38824dp-7, 0x1.aa1573ae4459ep-10, -0x1.b5764c79930a8p-13,
     0x1.c95024408e645p-16, -0x1.e3417cd8aa0fcp-19, 0x1.0131ad4f5eb5dp-21, -0x1.1334765ff6c77p-24,
     0x1.27a9780821345p-27, -0x1.3eabeb9b3293p-30, 0x1.585cb3b57d032p-33}, /* [116] 7.25 <= y <= 7.3125, 62.2 bits */
    {0x1.e62c62e5229a5p-4, 0x1.5f0e54e1753c2p-59, -0x1.a7ee86ebe6a4dp-7, 0x1.9ffef83f0241cp-10, -0x1.a77610b905b82p-13,
     0x1.b6e5d49af282ap-16, -0x1.cbd5777d2e55cp-19, 0x1.e545ebab1edd7p-22, -0x1.01682fad17defp-24,
     0x1.122c6e4b67c64p-27, -0x1.24fa8e3ab79d4p-30, 0x1.39e210ae0864p-33}, /* [117] 7.3125 <= y <= 7.375, 64.0 bits */
    {0x1.e2e2f8b2b09e3p-4, 0x1.b9727f7dba4d9p-58, -0x1.a1822e4542f2p-7, 0x1.963acb759e4ebp-10, -0x1.9a05907a7f4a1p-13,
     0x1.a55f107ad9e54p-16, -0x1.b5bb6eef16ba7p-19, 0x1.ca088adbc9944p-22, -0x1.e1cb6af27590cp-25,
     0x1.fcd23a5446fe5p-28, -0x1.0d8cffae407fdp-30, 0x1.1e53e52aad83dp-33}, /* [118] 7.375 <= y <= 7.4375, 62.0 bits */
    {0x1.dfa6408b47162p-4, 0x1.474b230f49ec6p-58, -0x1.9b3c4735c676fp-7, 0x1.8cc5a3da3d3d1p-10, -0x1.8d1de30ad5fb7p-13,
     0x1.94af11c0f2b52p-16, -0x1.a0ddb50bd388cp-19, 0x1.b0889cbbb0091p-22, -0x1.c3254f5b303c6p-25,
     0x1.d87179140c81fp-28, -0x1.f057ae1749a8p-31, 0x1.055c50c911e26p-33}, /* [119] 7.4375 <= y <= 7.5, 64.6 bits */
    {0x1.dc75eec3931a8p-4, -0x1.528e4e9a1824cp-59, -0x1.951b9bf823bc3p-7, 0x1.839c603d4a55dp-10, -0x1.80b88299d50a7p-13,
     0x1.84c9e3373ad54p-16, -0x1.8d282a2fa96d2p-19, 0x1.98a6478439537p-22, -0x1.a6ade94baa8d9p-25,
     0x1.b6f069e790d0fp-28, -0x1.c94ac3ab2751fp-31, 0x1.dd9f1fe457be5p-34}, /* [120] 7.5 <= y <= 7.5625, 63.3 bits */
    {0x1.d951ba0f7b11ep-4, 0x1.700771cce243ep-58, -0x1.8f1f02fefe4f5p-7, 0x1.7abc057941917p-10, -0x1.74cf45ef86e32p-13,
     0x1.75a451a0847c6p-16, -0x1.7a881d986b6b3p-19, 0x1.824435a684b0dp-22, -0x1.8c39426c3b294p-25,
     0x1.980f7f2f56ee1p-28, -0x1.a599ed7d7ccabp-31, 0x1.b4b3eca98a3cep-34}, /* [121] 7.5625 <= y <= 7.625, 64.3 bits */
    {0x1.d6395b6a441ebp-4, 0x1.032589ab20396p-58, -0x1.89455e6101d47p-7, 0x1.7221bc58dd1cp-10, -0x1.695c5a94380cep-13,
     0x1.6733ddf62eee1p-16, -0x1.68ec308652b75p-19, 0x1.6d475e228432ap-22, -0x1.739f2cce74f96p-25,
     0x1.7b951e95ecae7p-28, -0x1.84f4fa3c7cc54p-31, 0x1.8f94db03ba784p-34}, /* [122] 7.625 <= y <= 7.6875, 62.5 bits */
    {0x1.d32c8dffd724dp-4, 0x1.4a5536036c79ap-61, -0x1.838d9b4d1bf2p-7, 0x1.69cacf9f11629p-10, -0x1.5e5a3f622b662p-13,
     0x1.596eb0b9f6425p-16, -0x1.58443bd8ea2bfp-19, 0x1.5996d214e02a9p-22, -0x1.5cbae8939f2cap-25,
     0x1.614d0832b7df4p-28, -0x1.6713b8b4b9e4ep-31, 0x1.6de0f2db76a1p-34}, /* [123] 7.6875 <= y <= 7.75, 62.0 bits */
    {0x1.d02b0f1715a66p-4, -0x1.21bf369a80e5dp-59, -0x1.7df6b18656adap-7, 0x1.61b4aa2e76a3ep-10, -0x1.53c3bf78bf2cap-13,
     0x1.4c4b8e442f7cfp-16, -0x1.488137ecb2e89p-19, 0x1.471b8ef50b7e2p-22, -0x1.476ad2a5bb395p-25,
     0x1.4907cd423d911p-28, -0x1.4bb52c15e8054p-31, 0x1.4f430e00f0c56p-34}, /* [124] 7.75 <= y <= 7.8125, 63.3 bits */
    {0x1.cd349dfd2fb1p-4, -0x1.cb6bef93dc523p-58, -0x1.787fa2e6d9f83p-7, 0x1.59dcd54dee591p-10, -0x1.4993ed8976b1ap-13,
     0x1.3fc1cbf8f95f1p-16, -0x1.399526841e023p-19, 0x1.35c0550b72649p-22, -0x1.33901b8a4ae84p-25,
     0x1.329a5591a41cfp-28, -0x1.329ec138c3212p-31, 0x1.33870bbea6bffp-34}, /* [125] 7.8125 <= y <= 7.875, 64.8 bits */
    {0x1.ca48fbf1ecff7p-4, -0x1.e8292a294e778p-58, -0x1.73277ae9a3928p-7, 0x1.5240f7087e215p-10, -0x1.3fc61f780047ap-13,
     0x1.33c94650e5282p-16, -0x1.2b72fe8bc977dp-19, 0x1.257181b488cdp-22, -0x1.210e857146be9p-25, 0x1.1ddd736334ad4p-28,
     -0x1.1b9bb0c62fa88p-31, 0x1.1a0d499c2518dp-34}, /* [126] 7.875 <= y <= 7.9375, 63.8 bits */
    {0x1.c767ec14dc4d5p-4, -0x1.f0108b680e72bp-60, -0x1.6ded4e3a8c3fcp-7, 0x1.4aded0a6818a3p-10, -0x1.3655ea46e39cep-13,
     0x1.285a57a362f84p-16, -0x1.1e0e998eaf9bap-19, 0x1.161ced10e74e1p-22, -0x1.0fcc28bcc4e89p-25,
     0x1.0aad7e9f9e844p-28, -0x1.067c4877349afp-31, 0x1.0302b891fb5a1p-34}, /* [127] 7.9375 <= y <= 8, 62.1 bits */
    {0x1.c49133535ca54p-4, 0x1.42966e3439d16p-58, -0x1.68d03a4c3869ap-7, 0x1.43b43d3e7868p-10, -0x1.2d3f1e4b0bccap-13,
     0x1.1d6dcfa2d907fp-16, -0x1.115ca2b338504p-19, 0x1.07b1caccb2e01p-22, -0x1.ff627ca568878p-26,
     0x1.f1d4010c23622p-29, -0x1.e62aea8d4d5bbp-32, 0x1.dbfacb673bbf9p-35}, /* [128] 8 <= y <= 8.0625, 64.2 bits */
    {0x1.c1c49857752edp-4, -0x1.88d64ae966e4ap-60, -0x1.63cf64f399015p-7, 0x1.3cbf305bd8c7ep-10, -0x1.247dc3a0db50fp-13,
     0x1.12fceb7bc02f9p-16, -0x1.0552871de9639p-19, 0x1.f4411b632ad37p-23, -0x1.e14fde3d4bd88p-26,
     0x1.d0eac65253d2ep-29, -0x1.c2809065852a2p-32, 0x1.b5a2b834227cap-35}, /* [129] 8.0625 <= y <= 8.125, 62.7 bits */
    {0x1.bf01e37770b1ap-4, -0x1.34ced7c166d0bp-62, -0x1.5ee9fc08a78c5p-7, 0x1.35fdb4ba6a1c3p-10, -0x1.1c0e16dde7d9ap-13,
     0x1.09014e896f7b3p-16, -0x1.f3cccf33b7625p-20, 0x1.dab59b7cec3c2p-23, -0x1.c538507471536p-26,
     0x1.b269571254fd7p-29, -0x1.a1b30bb299756p-32, 0x1.92a4a1049790ap-35}, /* [130] 8.125 <= y <= 8.1875, 61.9 bits */
    {0x1.bc48dea632a84p-4, 0x1.0b9052ea6a24cp-59, -0x1.5a1f350c0dff1p-7, 0x1.2f6deb14cb585p-10, -0x1.13ec85fae1eb6p-13,
     0x1.fee9f728deffep-17, -0x1.de1e16d451c1fp-20, 0x1.c2a6610e7fd9cp-23, -0x1.aaf6e683a4fadp-26,
     0x1.961e7467aeb8cp-29, -0x1.8382916a665c3p-32, 0x1.72c450b3ecedep-35}, /* [131] 8.1875 <= y <= 8.25, 67.2 bits */
    {0x1.b99955643c556p-4, -0x1.82d5ae3be71aap-59, -0x1.556e4cd170495p-7, 0x1.290e0904df7f7p-10, -0x1.0c15ad71890c8p-13,
     0x1.eca49d1e805f4p-17, -0x1.c987a85486d86p-20, 0x1.abfaa74aa0f48p-23, -0x1.9269a4d1ee132p-26,
     0x1.7bdd2602484d8p-29, -0x1.67b544884f0a1p-32, 0x1.5573d2b503eb8p-35}, /* [132] 8.25 <= y <= 8.3125, 61.9 bits */
    {0x1.b6f314b158de4p-4, 0x1.79afcbb75c75p-58, -0x1.50d6872e125d5p-7, 0x1.22dc57f4f3e2bp-10, -0x1.0486558ae1fdbp-13,
     0x1.db27ed8ee7d8bp-17, -0x1.b5f9654b41cd9p-20, 0x1.969b720d9a359p-23, -0x1.7b713fd9ac316p-26,
     0x1.637c5173fb651p-29, -0x1.4e16c1e2c44p-32, 0x1.3ac5197b77782p-35}, /* [133] 8.3125 <= y <= 8.375, 61.8 bits */
    {0x1.b455eafee7f35p-4, -0x1.d15a83c164dd4p-61, -0x1.4c572eab99fe4p-7, 0x1.1cd73420891f4p-10, -0x1.fa76dfb463aa8p-14,
     0x1.ca69e303c699p-17, -0x1.a3643922aa34p-20, 0x1.827369e03182bp-23, -0x1.65f0e11e1f608p-26, 0x1.4cd661214ee8ep-29,
     -0x1.36776944c54b3p-32, 0x1.2252f2faf8d62p-35}, /* [134] 8.375 <= y <= 8.4375, 64.5 bits */
    {0x1.b1c1a822bf0b7p-4, -0x1.6957b7b08dd4fp-62, -0x1.47ef943eafd82p-7, 0x1.16fd0ba3bc03cp-10, -0x1.ec6429c30ef83p-14,
     0x1.ba6109f311594p-17, -0x1.91ba0628744f1p-20, 0x1.6f6ebb0e5284dp-23, -0x1.51cdf1955da58p-26,
     0x1.37c8ef8bc7ce1p-29, -0x1.20ac0264f33afp-32, 0x1.0bf09591937acp-35}, /* [135] 8.4375 <= y <= 8.5, 63.8 bits */
    {0x1.af361d4a99adfp-4, -0x1.cb377a574a9bp-59, -0x1.439f0f014747dp-7, 0x1.114c5d985e07ep-10, -0x1.decf03b9bb485p-14,
     0x1.ab04777296e88p-17, -0x1.80ed941819909p-20, 0x1.5d7af788e393ep-23, -0x1.3eefe8fd6c9d9p-26,
     0x1.24347d4cf8a8ap-29, -0x1.0c8d440958767p-32, 0x1.eedb41cde1636p-36}, /* [136] 8.5 <= y <= 8.5625, 62.2 bits */
    {0x1.acb31cf011b23p-4, 0x1.e0a0a7147582fp-62, -0x1.3f64fbf057d8cp-7, 0x1.0bc3b93fde0fep-10, -0x1.d1b22d6234cbbp-14,
     0x1.9c4bc09355695p-17, -0x1.70f27fff02548p-20, 0x1.4c86fb51627c4p-23, -0x1.2d4021a0698p-26, 0x1.11fc2e18a7d6ep-29,
     -0x1.f3eee2253f312p-33, 0x1.c8e1b137679e2p-36}, /* [137] 8.5625 <= y <= 8.625, 62.3 bits */
    {0x1.aa387acd18c49p-4, 0x1.0bd71966a5d4fp-60, -0x1.3b40bdacd6db6p-7, 0x1.0661bd3931f18p-10, -0x1.c508a7f8cf965p-14,
     0x1.8e2ef2579e674p-17, -0x1.61bd2d5d93865p-20, 0x1.3c82d3344ce29p-23, -0x1.1ca9b018f8426p-26,
     0x1.010589a2eb1dbp-29, -0x1.d1940df778bacp-33, 0x1.a6b7309e9a3ep-36}, /* [138] 8.625 <= y <= 8.6875, 61.8 bits */
    {0x1.a7c60bd0ecdedp-4, -0x1.e92b5e1f15eb3p-58, -0x1.3731bc3fc2982p-7, 0x1.012516c1ffb75p-10, -0x1.b8cdb28b24334p-14,
     0x1.80a68a382f10bp-17, -0x1.5342b86ab3babp-20, 0x1.2d5fa59d0973cp-23, -0x1.0d193eb43abf4p-26,
     0x1.e2709264e331bp-30, -0x1.b1ceabdbe71bap-33, 0x1.87094d03fc521p-36}, /* [139] 8.6875 <= y <= 8.75, 63.1 bits */
    {0x1.a55ba61581bdp-4, -0x1.8f4d8fc86a8c4p-58, -0x1.333764e1138b2p-7, 0x1.f8190204a60aep-11, -0x1.acfcc6908c315p-14,
     0x1.73ab6f2d5e0abp-17, -0x1.4578e961bafc2p-20, 0x1.1f0f9d5342358p-23, -0x1.fcf9d82e319d2p-27,
     0x1.c4fc43083c823p-30, -0x1.9468e1798094dp-33, 0x1.69ef0e69b8af9p-36}, /* [140] 8.75 <= y <= 8.8125, 62.1 bits */
    {0x1.a2f920d559ac8p-4, -0x1.429fc8611266dp-58, -0x1.2f5129c16acb1p-7, 0x1.ee2d88c46ed2fp-11, -0x1.a19194b8666fep-14,
     0x1.6736eb3265ec5p-17, -0x1.385628c4e5c1ap-20, 0x1.1185d5f620b29p-23, -0x1.e18859b200ccbp-27,
     0x1.a985300c19802p-30, -0x1.79315ec8b7905p-33, 0x1.4f2e12795a80cp-36}, /* [141] 8.8125 <= y <= 8.875, 62.5 bits */
    {0x1.a09e5461c860dp-4, -0x1.8db6bd4696a2dp-59, -0x1.2b7e81d65741ep-7, 0x1.e4856bd137a22p-11, -0x1.968801ea776cp-14,
     0x1.5b42a539a49ep-17, -0x1.2bd17480544dap-20, 0x1.04b64a0e17578p-23, -0x1.c7bf5f947d754p-27, 0x1.8fe5b3700ab5ep-30,
     -0x1.5ffb3353e9836p-33, 0x1.3692231e4a60dp-36}, /* [142] 8.875 <= y <= 8.9375, 62.1 bits */
    {0x1.9e4b1a199ac58p-4, -0x1.5e18e07c81ad7p-61, -0x1.27bee8a90db97p-7, 0x1.db1e6d45dbfa9p-11, -0x1.8bdc24760003bp-14,
     0x1.4fc89b89668e2p-17, -0x1.1fe255db61518p-20, 0x1.f12b85232199ap-24, -0x1.af82894da28b1p-27,
     0x1.77fb2d2883ea8p-30, -0x1.489d5cb2d1dc2p-33, 0x1.1faf431fc9505p-36}, /* [143] 8.9375 <= y <= 9, 61.8 bits */
    {0x1.9bff4c601f098p-4, 0x1.aa713cad5129ap-62, -0x1.2411de2771ed8p-7, 0x1.d1f66629cd2b1p-11, -0x1.818a416c65ab7p-14,
     0x1.44c31e7982aaap-17, -0x1.1480d827b1f91p-20, 0x1.da338f7877f0cp-24, -0x1.98b789f6a3bb2p-27,
     0x1.61a5bcf2d009bp-30, -0x1.32f24037977b4p-33, 0x1.0b41624d107fdp-36}, /* [144] 9 <= y <= 9.0625, 64.6 bits */
    {0x1.99bac6948861ep-4, 0x1.3ae379abab19fp-58, -0x1.2076e67750df8p-7, 0x1.c90b45600f265p-11, -0x1.778eca248266fp-14,
     0x1.3a2ccb8aaae5ep-17, -0x1.09a5801ed2a6ep-20, 0x1.c47126374cp-24, -0x1.8345fe0ecb095p-27, 0x1.4cc80d70b2073p-30,
     -0x1.1ed78a5794581p-33, 0x1.efbb84c9d858p-37}, /* [145] 9.0625 <= y <= 9.125, 64.2 bits */
    {0x1.977d6509aa3fdp-4, -0x1.4225a791c4dd3p-59, -0x1.1ced89cbae929p-7, 0x1.c05b0ea4ae4f2p-11, -0x1.6de659e3e9681p-14,
     0x1.300088d0e6275p-17, -0x1.fe9287c10505cp-21, 0x1.afd2056d375e5p-24, -0x1.6f1744dde1e5fp-27,
     0x1.394713613c47bp-30, -0x1.0c2dfa5d9f49ep-33, 0x1.cc48c6579053dp-37}, /* [146] 9.125 <= y <= 9.1875, 62.1 bits */
    {0x1.954704fe06eefp-4, 0x1.ccfd8ca709a69p-58, -0x1.1975543c0b1afp-7, 0x1.b7e3d997d2193p-11, -0x1.648db3ab9f78cp-14,
     0x1.263980ab2d29dp-17, -0x1.eacb0709ffd08p-21, 0x1.9c451a6e49bfcp-24, -0x1.5c165d202c166p-27,
     0x1.2709e22e7eeb2p-30, -0x1.f5b18c2c71b0dp-34, 0x1.ab994433aa5bp-37}, /* [147] 9.1875 <= y <= 9.25, 62.8 bits */
    {0x1.931784942dc9p-4, -0x1.62a8da425d9fbp-59, -0x1.160dd59d84988p-7, 0x1.afa3d0d59ed6p-11, -0x1.5b81c025f4994p-14,
     0x1.1cd31dc29d1c8p-17, -0x1.d7e8046f779e8p-21, 0x1.89ba6e026f366p-24, -0x1.4a2fc4ad4af49p-27,
     0x1.15f97c20d482ap-30, -0x1.d57b3270e3f83p-34, 0x1.8d6aec55e3b84p-37}, /* [148] 9.25 <= y <= 9.3125, 61.6 bits */
    {0x1.90eec2cb655c9p-4, 0x1.4dec5705d6cb4p-59, -0x1.12b6a15dbd3f3p-7, 0x1.a799311a26715p-11, -0x1.52bf8bb356e48p-14,
     0x1.13c9074c21e1bp-17, -0x1.c5ddbf9faa69cp-21, 0x1.78231044616c3p-24, -0x1.39515ad6a00e8p-27,
     0x1.0600a9470d0e3p-30, -0x1.b7888b4d82f34p-34, 0x1.7170ab0bf15fdp-37}, /* [149] 9.3125 <= y <= 9.375, 63.1 bits */
    {0x1.8ecc9f789e184p-4, -0x1.25ab1da815e47p-58, -0x1.0f6f4e5f6e061p-7, 0x1.9fc24870b45c6p-11, -0x1.4a4444941e207p-14,
     0x1.0b171d87df77ep-17, -0x1.b4a125b9436c8p-21, 0x1.6771060de22bdp-24, -0x1.296a453d18aaap-27,
     0x1.ee17a22ac6959p-31, -0x1.9badd3daef11ep-34, 0x1.57f1520106959p-37}, /* [150] 9.375 <= y <= 9.4375, 62.7 bits */
    {0x1.8cb0fb3faa358p-4, -0x1.9ec26915fde09p-59, -0x1.0c3776d88ff07p-7, 0x1.981d756dcc787p-11, -0x1.420d392d73a95p-14,
     0x1.02b97679ff452p-17, -0x1.a427c63ab081dp-21, 0x1.579737d038913p-24, -0x1.1a6ad6ea34002p-27,
     0x1.d211b4420c255p-31, -0x1.81c189415e77bp-34, 0x1.40089176319ap-37}, /* [151] 9.4375 <= y <= 9.5, 62.3 bits */
    {0x1.8a9bb78cb7cc5p-4, -0x1.41c9b5ce09b7dp-58, -0x1.090eb832072a6p-7, 0x1.90a926733f981p-11, -0x1.3a17d6679be68p-14,
     0x1.f558b5b1b6d81p-18, -0x1.9467c8b75fbecp-21, 0x1.488961bae3f3ep-24, -0x1.0c44796fc8c4ep-27,
     0x1.b7ce0f920c0aep-31, -0x1.699f14e9f1cp-34, 0x1.2a0e8f744154dp-37}, /* [152] 9.5 <= y <= 9.5625, 62.7 bits */
    {0x1.888cb68e0a1edp-4, 0x1.add6d38921647p-58, -0x1.05f4b2e8bc61cp-7, 0x1.8963d8fdc22fep-11, -0x1.3261a62405699p-14,
     0x1.e5d88659a1664p-18, -0x1.8557e343e1ee5p-21, 0x1.3a3c051510924p-24, -0x1.fdd32fda29c3p-28, 0x1.9f2dc0551ff67p-31,
     -0x1.5323faa22ea63p-34, 0x1.15b427e6be38bp-37}, /* [153] 9.5625 <= y <= 9.625, 62.9 bits */
    {0x1.8683db2def53ep-4, 0x1.7ab4ef1293b67p-58, -0x1.02e90a7011e3fp-7, 0x1.824c18fb7b20dp-11, -0x1.2ae84dc99e6d8p-14,
     0x1.d6ebaa3c8ef23p-18, -0x1.76ef518b28fb8p-21, 0x1.2ca45ab0d58a4p-24, -0x1.e49b1787bec6dp-28,
     0x1.881421bb14cf5p-31, -0x1.3e30be2b56ff9p-34, 0x1.02dd1b49d99aap-37}, /* [154] 9.625 <= y <= 9.6875, 61.7 bits */
    {0x1.8481090ceff9dp-4, -0x1.e32c8927726c1p-58, -0x1.ffd6ca2b46249p-8, 0x1.7b60802b09308p-11, -0x1.23a98ce60bdebp-14,
     0x1.c88bc1dd8c8cep-18, -0x1.6925cc8038016p-21, 0x1.1fb84661644a5p-24, -0x1.ccc915bc1803ep-28,
     0x1.7266aef149368p-31, -0x1.2aa85d2f3af37p-34, 0x1.e2e9271ee2be1p-38}, /* [155] 9.6875 <= y <= 9.75, 64.1 bits */
    {0x1.8284247c35cddp-4, 0x1.83e67f3001855p-58, -0x1.f9f6d7cc7b758p-8, 0x1.749fb58285d7ep-11, -0x1.1ca33be275888p-14,
     0x1.bab2be343a8e7p-18, -0x1.5bf382a0a08e7p-21, 0x1.136e4b5f54f5fp-24, -0x1.b6472ebd4dbcp-28, 0x1.5e0cd6dd1332cp-31,
     -0x1.187069e7f446cp-34, 0x1.c302465ac68d8p-38}, /* [156] 9.75 <= y <= 9.8125, 64.1 bits */
    {0x1.808d127827646p-4, -0x1.4c78512d3fc1bp-58, -0x1.f43195280b99dp-8, 0x1.6e086c9e1394ap-11, -0x1.15d34acab1a75p-14,
     0x1.ad5adc39e39f9p-18, -0x1.4f5110bd17c3p-21, 0x1.07bd8188009b7p-24, -0x1.a100e1422037ep-28, 0x1.4aefd7bd03affp-31,
     -0x1.076fe18037debp-34, 0x1.a46caf0fdf8c9p-38}, /* [157] 9.8125 <= y <= 9.875, 64.3 bits */
    {0x1.7e9bb8a3366bp-4, 0x1.ec4b676a67026p-58, -0x1.ee865ebb6980fp-8, 0x1.679965358cee8p-11, -0x1.0f37c025af167p-14,
     0x1.a07ea0bc48ddcp-18, -0x1.43377b3e488cfp-21, 0x1.f93b16cd113e6p-25, -0x1.8ce30acb7cfc7p-28,
     0x1.38fa93b14a9b1p-31, -0x1.ef2109ddb8c12p-35, 0x1.88bd64243e3c1p-38}, /* [158] 9.875 <= y <= 9.9375, 63.0 bits */
    {0x1.7caffd40de5c8p-4, 0x1.181de4f0865f5p-59, -0x1.e8f495edcda24p-8, 0x1.61516a98efe97p-11, -0x1.08ceb7de10bc5p-14,
     0x1.9418d47176b57p-18, -0x1.37a027dcd01fp-21, 0x1.e40d19ed201ep-25, -0x1.79dbce3285d69p-28, 0x1.281977a9933d8p-31,
     -0x1.d17a641aa4a5ap-35, 0x1.6eaa1c8b3506fp-38} /* [159] 9.9375 <= y <= 10, 63.1 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_tsuji_overlap_factor)

/* ln(1 + zeta) >= 12.25, with u = ln(zeta), mu = 1/zeta^2: t zeta^(4/5) = a_0 + a_0' + (a_1 + a_1') u
 * + mu (a_2 + a_3 u + a_4 u^2); with the limited damper and mu = 1/zeta: t = a_0 + a_0' + (a_1 + a_1') mu
 * + a_2 mu u + mu^3 (a_3 + a_4 u + a_5 u^2). Through enclosed values with u = 13, 13.75, ... */
COR_INLINE const double *cor_rows_tsuji_far_time_of_max_overlap(int i)
{
    static const double row[1][7] = {
    {0x1.c853617a50da5p-1, -0x1.c1834bea584dp-58, 0x1.0137987dd704cp+0, -0x1.252652dc51fc4p-57, 0x1.c549744651756p-4,
     0x1.e2dcfb90b2d9cp-2, 0x1.9b8c273953cc8p-5} /* time of the largest overlap */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_tsuji_far_duration_zero_force(int i)
{
    static const double row[1][7] = {
    {0x1.9673c40310478p+0, -0x1.a26b18a26a0ddp-54, 0x1.0137987dd704cp+1, -0x1.252640c6a1698p-56, 0x1.e279bb4b8c33bp-3,
     0x1.1516e7f4c4eaap+0, 0x1.9b8c273a7cbfdp-3} /* duration at zero force */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_tsuji_far_duration_limited(int i)
{
    static const double row[1][8] = {
    {0x1.382bd44e55509p+0, 0x1.84083e86edd4ap-54, 0x1.7b0db250b03cp-1, -0x1.d0c95fe4f3841p-55, 0x1.dffbf5563f514p-1,
     0x1.9275d14022726p-4, 0x1.efcc00980be78p-2, 0x1.7ffcc44f4378p-5} /* duration with the limited damper */
    };
    return row[i];
}

/* y >= 10: V = y^(-4/5) (v_0 + v_0' + v_1/y^2 + ... + v_7/y^14), through values at y = 10 ... 52; relative error below 2^-57, sampled. */
COR_INLINE const double *cor_rows_tsuji_far_overlap_factor(int i)
{
    static const double row[1][9] = {
    {0x1.2b75ba3a9818bp-1, -0x1.262580b352028p-56, 0x1.cbf869d2d523ep-8, 0x1.e968915d40f28p-11, 0x1.d0fc125a649ccp-12,
     0x1.e3ef79395e756p-12, 0x1.b5cdb3ab9745p-11, 0x1.2f02848720b77p-9, 0x1.4e0c54d3d5a72p-7}
     /* V of the duration at zero overlap */
    };
    return row[i];
}

#endif
