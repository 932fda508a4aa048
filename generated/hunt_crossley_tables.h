/* SPDX-License-Identifier: MIT */
/* Times of Hunt and Crossley's law F = K x^a (1 + d x') with a = 1 and 3/2, for every beta = d g >= 0, in units of
 * (m/K)^(1/(a+1)) g^((1-a)/(a+1)): rows of short polynomials around the nodes of uniform grids in ln(1 + beta), and
 * what follows at large beta. Evaluated by runtime/law/hunt_crossley_times.c. Source: docs/laws.md; form:
 * docs/header-format.md.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check
 *
 * The rows interpolate polynomials through samples by two Gauss rules of 56 points, which agree with enclosures by
 * adaptive quadrature to 1e-20 at two places of each block of rows. Errors of the rows stand above each table and
 * beside each row (sampled); errors of evaluation: include/cor/law.h (sampled). */
#ifndef COR_GENERATED_HUNT_CROSSLEY_TABLES_H
#define COR_GENERATED_HUNT_CROSSLEY_TABLES_H
#include "runtime/core/rows.h"

/* time of the largest overlap, a = 1: 70 rows of degree 10 in y = ln(1 + beta), nodes 0.1875 + i 0.375, y < 26.25.
 * Relative error of the approximation: 2^-56.7 at most, sampled at 25 places of each row. */
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_1_FIRST 0.1875
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_1_STEP 0.375
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_1_PER_UNIT 2.6666666666666665
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_1_ROWS 70
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_1_END 26.25
COR_ROWS(double, cor_rows_crossley_time_of_max_overlap_1, 70, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.8237a8b53e1b4p+0, 0x1.81ca76b39444dp-56, -0x1.513ee33f4251ep-2, 0x1.7548e7dcad7ecp-7, 0x1.59dad4e0f8dddp-9,
     -0x1.3c44768b3011p-14, -0x1.557a951b9999bp-15, 0x1.f1c4be52fbc75p-21, 0x1.7b9f0033a8466p-21,
     -0x1.5b378e93d0809p-26, -0x1.c9c4128246c52p-27, 0x1.2a54e66077b63p-31}, /* [0] 0 <= y <= 0.375, 58.3 bits */
    {0x1.630bc066ddff3p+0, -0x1.d6bc0ebc98bfap-54, -0x1.476093037907fp-2, 0x1.d3c7e33807e5cp-7, 0x1.43b7a780a2c65p-9,
     -0x1.37728a3a4e4e2p-13, -0x1.333b14cf0c5eep-15, 0x1.635f86c19e19cp-19, 0x1.398663b7f7e6ap-21,
     -0x1.0045ec3038ad6p-24, -0x1.44fc653dc9a4bp-27, 0x1.8b27db452a5f9p-30}, /* [1] 0.375 <= y <= 0.75, 58.5 bits */
    {0x1.44e6963c1c37ep+0, 0x1.ffcdb28a6a79ap-54, -0x1.3b61e1640815ap-2, 0x1.150ed96d314f3p-6, 0x1.202f1bb5c0853p-9,
     -0x1.b9adb7fe4e4a1p-13, -0x1.e8e22a990eb1bp-16, 0x1.0668d58e1e9bfp-18, 0x1.89f9ff6d4ec5fp-22,
     -0x1.5e4e7dffdf82dp-24, -0x1.c967d5c68fca5p-29, 0x1.d8717af3b6982p-30}, /* [2] 0.75 <= y <= 1.125, 60.6 bits */
    {0x1.27f891632032ep+0, -0x1.9e6e6f0df6b07p-55, -0x1.2d7e6207b740fp-2, 0x1.3a70c435a5babp-6, 0x1.e3f32ab1a3932p-10,
     -0x1.0ce45e0a0adebp-12, -0x1.4739d533e9186p-16, 0x1.30f9d83f6ababp-18, 0x1.f233f958915edp-24,
     -0x1.61a745001f137p-24, 0x1.69fb1f620a46ap-29, 0x1.79ef65ece38d9p-30}, /* [3] 1.125 <= y <= 1.5, 57.6 bits */
    {0x1.0c6ba1aaa5501p+0, -0x1.d94fc2b8b60fcp-54, -0x1.1e039008b89e7p-2, 0x1.58c6eaaf658d2p-6, 0x1.7931aedfa0e94p-10,
     -0x1.29142bb77d1eep-12, -0x1.33b7c9dc8d379p-17, 0x1.30c985658b0dap-18, -0x1.d82370153f292p-24,
     -0x1.1bc205802269fp-24, 0x1.c1cd8d2191711p-28, 0x1.786c83805ae43p-31}, /* [4] 1.5 <= y <= 1.875, 58.0 bits */
    {0x1.e4c3ac4f622abp-1, -0x1.129105e1f6726p-55, -0x1.0d4af61b5a9eap-2, 0x1.6f530b1566e78p-6, 0x1.07a3473732bfcp-10,
     -0x1.315d93569eca5p-12, 0x1.24fdc24752006p-21, 0x1.0e10979892d75p-18, -0x1.23c588fed2c2dp-22,
     -0x1.612a0079b579cp-25, 0x1.0b6f33df16a5cp-27, 0x1.7356a33508daep-40}, /* [5] 1.875 <= y <= 2.25, 59.4 bits */
    {0x1.b3e90e67f7fcdp-1, 0x1.e28a0dd7babe5p-56, -0x1.f767c7c1404e3p-3, 0x1.7ddbf07a712bap-6, 0x1.2cc5c1772248ep-11,
     -0x1.27f8309e59d6dp-12, 0x1.23c7de4bef79cp-17, 0x1.ab3d1c7b07fa6p-19, -0x1.7ebc198394e9dp-22,
     -0x1.110fb8f71eb9ap-26, 0x1.d7bfbbc3213cap-28, -0x1.e66862e9f0b7bp-32}, /* [6] 2.25 <= y <= 2.625, 60.9 bits */
    {0x1.8668295f7c746p-1, 0x1.82decf397c3a2p-57, -0x1.d33af77e215c2p-3, 0x1.849ef3a1b3393p-6, 0x1.5b56c42808c23p-13,
     -0x1.1089ed65fee1fp-12, 0x1.efc0353b6e253p-17, 0x1.291085075b4abp-19, -0x1.8fff9e2839642p-22,
     0x1.1453e91bb36eep-28, 0x1.4c3d0a65788fap-28, -0x1.480a34198d8aap-31}, /* [7] 2.625 <= y <= 3, 58.7 bits */
    {0x1.5c50517661111p-1, -0x1.9f9c2a3396a8p-56, -0x1.aec35cb943143p-3, 0x1.8437d6524ba9p-6, -0x1.a658589522d36p-13,
     -0x1.de9cc2db4a08cp-13, 0x1.3959b7b675b16p-16, 0x1.54f6da80ca52ap-20, -0x1.6ccea7e90c887p-22,
     0x1.1d1c81481745dp-26, 0x1.6cfe1ac82e33cp-29, -0x1.2918fc9a36f4ep-31}, /* [8] 3 <= y <= 3.375, 58.4 bits */
    {0x1.35a0c88d17222p-1, -0x1.85ebbb35fce46p-55, -0x1.8aa2eaa1feb7ep-3, 0x1.7d8493d23c10dp-6, -0x1.0eb66fc82dd86p-11,
     -0x1.90d073dec7dddp-13, 0x1.5961deac91b5cp-16, 0x1.e6bafd331a962p-22, -0x1.2c5e6061c502bp-22,
     0x1.813ade4589849p-26, 0x1.ee979fddc79edp-31, -0x1.abd78d7c99e73p-32}, /* [9] 3.375 <= y <= 3.75, 58.2 bits */
    {0x1.124aac624b8a3p-1, -0x1.b7185a65fa488p-56, -0x1.6764c18734ddp-3, 0x1.7189b649686bfp-6, -0x1.95af9a2c298d2p-11,
     -0x1.3ee05cab94916p-13, 0x1.5dc56f97c2fb4p-16, -0x1.988544497b459p-23, -0x1.c343860aaf73dp-23,
     0x1.90ceb9e70cb69p-26, -0x1.1a1ad1d277eefp-32, -0x1.fca62fe8aa92bp-33}, /* [10] 3.75 <= y <= 4.125, 58.3 bits */
    {0x1.e466787d77c72p-2, -0x1.ae3fcca6b06d6p-56, -0x1.457abc5650dfp-3, 0x1.615a2e3e3d4d2p-6, -0x1.fe11f90d432abp-11,
     -0x1.dcf933f552244p-14, 0x1.4d5146e722e51p-16, -0x1.5e068ee16f4bp-21, -0x1.3277282757b39p-23, 0x1.6d715a33b7f3p-26,
     -0x1.e4d9524d486fbp-31, -0x1.e1c3889d18a21p-34}, /* [11] 4.125 <= y <= 4.5, 58.1 bits */
    {0x1.aa6c7ff2babfep-2, -0x1.50b3e1317c07bp-58, -0x1.253d07bd1905cp-3, 0x1.4e0425e89eea5p-6, -0x1.24a1a28187a11p-10,
     -0x1.477bed4c3e183p-14, 0x1.2ea6572fe3633p-16, -0x1.fc7b67afa4afbp-21, -0x1.686d45c1e41d2p-24,
     0x1.318134b11f13fp-26, -0x1.37857f0d74bb5p-30, -0x1.1207f07bc5fc2p-35}, /* [12] 4.5 <= y <= 4.875, 60.0 bits */
    {0x1.7650ca7be5ca8p-2, 0x1.4fe75b3c3362cp-61, -0x1.06eb45897c50fp-3, 0x1.388324180fa9p-6, -0x1.3cf54df37b60cp-10,
     -0x1.85184a39faa22p-15, 0x1.0792825c64efp-16, -0x1.27f311fdc9e57p-20, -0x1.38e722927306p-25, 0x1.dc6aa6be51726p-27,
     -0x1.3e74b43cc7ae8p-30, 0x1.ce05255e52286p-37}, /* [13] 4.875 <= y <= 5.25, 57.4 bits */
    {0x1.47b2e7a1a4ed2p-2, 0x1.7029c14102326p-58, -0x1.d55d80ff48fd9p-4, 0x1.21b719cd398f9p-6, -0x1.49b734be2fdb5p-10,
     -0x1.43d51aef581f6p-16, 0x1.b993d239ad6bcp-17, -0x1.3451bc92ecd7bp-20, -0x1.3a18157e2e0bdp-31,
     0x1.5acadd6302bbfp-27, -0x1.23f99e979c355p-30, 0x1.386dc4ed22575p-35}, /* [14] 5.25 <= y <= 5.625, 57.7 bits */
    {0x1.1e2c8912abf4p-2, -0x1.b70ca8649a54ep-56, -0x1.a13a86a8ca743p-4, 0x1.0a5f97a3745cap-6, -0x1.4cc55225cea55p-10,
     0x1.8d9813396329bp-19, 0x1.63b83c24de49dp-17, -0x1.2b465a8dd654dp-20, 0x1.a62bf423c20dep-26, 0x1.d05f2df7fd1cdp-28,
     -0x1.f32dcaa462a08p-31, 0x1.8d3d9f85c38ecp-35}, /* [15] 5.625 <= y <= 6, 57.5 bits */
    {0x1.f2a9c040e8821p-3, 0x1.6769751b2568dp-57, -0x1.71787343c5fecp-4, 0x1.e6348fdde6a17p-7, -0x1.4800421d34a32p-10,
     0x1.58a2a6f4a6e4ep-16, 0x1.129487974b818p-17, -0x1.13d86298f8614p-20, 0x1.5c3ecd786f02ep-25, 0x1.11f0deba0438cp-28,
     -0x1.92ca5d2005d7fp-31, 0x1.a11a5ffb3ee9fp-35}, /* [16] 6 <= y <= 6.375, 57.4 bits */
    {0x1.b186c72b1129dp-3, 0x1.3b0c1aadcc9ccp-58, -0x1.4607adeccd345p-4, 0x1.b8c79dd7fbc43p-7, -0x1.3d2ef058836d7p-10,
     0x1.1b8330872ae2fp-15, 0x1.92b49115ac8c6p-18, -0x1.e7c447b5e6e0cp-21, 0x1.a5acc17090094p-25, 0x1.f1c90e233ada1p-30,
     -0x1.32c41253af464p-31, 0x1.8d2520ea8fcd9p-35}, /* [17] 6.375 <= y <= 6.75, 57.5 bits */
    {0x1.78240316f736ap-3, -0x1.95595cc6f9831p-60, -0x1.1ec427f21983cp-4, 0x1.8d34945196facp-7, -0x1.2dec77c8abe1ep-10,
     0x1.6a98de9c2ccf9p-15, 0x1.13854cd7e66d1p-18, -0x1.9ffc5003743bap-21, 0x1.be798b37ba22dp-25, 0x1.c0e020bfcc61dp-33,
     -0x1.b52b218f9e3f2p-32, 0x1.60311cc3d4df2p-35}, /* [18] 6.75 <= y <= 7.125, 56.9 bits */
    {0x1.45bd907ef80b2p-3, -0x1.b6008a25fdbap-57, -0x1.f6f58b1fb7594p-5, 0x1.640191add9fd7p-7, -0x1.1b9e476b453d5p-10,
     0x1.9e441b4c43f9p-15, 0x1.519bd82bd235ep-19, -0x1.5729c28084009p-21, 0x1.b48a60f1b64d9p-25, -0x1.ed686790862d7p-31,
     -0x1.1d8a78144545fp-32, 0x1.2541bdbabefcbp-35}, /* [19] 7.125 <= y <= 7.5, 60.8 bits */
    {0x1.199a2aa37399p-3, 0x1.c8e6a59c9037ep-62, -0x1.b7dc269fdb09p-5, 0x1.3d86735462fa9p-7, -0x1.07709d6613bb7p-10,
     0x1.bb4b36aa7969bp-15, 0x1.4893871db4c3bp-20, -0x1.11fc9036b81f2p-21, 0x1.93d6f8811a988p-25,
     -0x1.b1ad75567acffp-30, -0x1.45f71a8ca8bcap-33, 0x1.cb11d94c60e65p-36}, /* [20] 7.5 <= y <= 7.875, 58.0 bits */
    {0x1.e61973e5e3425p-4, -0x1.7540a8186f45bp-58, -0x1.7fb47756ab7dap-5, 0x1.19f4d931c1ad2p-7, -0x1.e4af1d93824e7p-11,
     0x1.c6397b7746b12p-15, 0x1.c22e2f57bc9a4p-23, -0x1.a6ba594516923p-22, 0x1.66107e99e2a77p-25,
     -0x1.08e4c60a81a74p-29, -0x1.17cc8c3881bddp-34, 0x1.50962d1b8fdf2p-36}, /* [21] 7.875 <= y <= 8.25, 58.0 bits */
    {0x1.a2ea6c71cbd42p-4, 0x1.0c9537d765b1ep-58, -0x1.4df07ff0b8f82p-5, 0x1.f2bf93ae758c9p-8, -0x1.ba26209ef1124p-11,
     0x1.c32d92c04ce46p-15, -0x1.2c0eeb9e7e567p-21, -0x1.399be893a367dp-22, 0x1.3296bffc25c69p-25,
     -0x1.178d113600cc8p-29, -0x1.02373e4fff8f1p-38, 0x1.c9bf240ab8cb5p-37}, /* [22] 8.25 <= y <= 8.625, 58.7 bits */
    {0x1.6881fdac359d1p-4, -0x1.680c5e85ddba5p-58, -0x1.220103d057d19p-5, 0x1.b78545376fffap-8, -0x1.90697c9a7f02bp-11,
     0x1.b5bf871cd6dbbp-15, -0x1.2bbfd37223784p-20, -0x1.bb253d82e7a51p-23, 0x1.fd4e3a0ce1fc5p-26,
     -0x1.0f6c33651de6ep-29, 0x1.37337360ce946p-35, 0x1.19e8988d1cb6dp-37}, /* [23] 8.625 <= y <= 9, 57.0 bits */
    {0x1.35d5905585e56p-4, 0x1.31419de5fa63ap-61, -0x1.f6b2c346e9256p-6, 0x1.820e4e0924a4p-8, -0x1.684cdbbc8a377p-11,
     0x1.a0f83dba58924p-15, -0x1.926be398ec48ap-20, -0x1.2453bc433b41ap-23, 0x1.9b5d58cdb0a5ap-26,
     -0x1.f26349252b18ap-30, 0x1.fd77fb357b413p-35, 0x1.279510b94a3eep-38}, /* [24] 9 <= y <= 9.375, 57.7 bits */
    {0x1.09f472e40d5acp-4, 0x1.904abbfe2eef7p-59, -0x1.b2e4c30a56604p-6, 0x1.5215409a87fa1p-8, -0x1.4261aec691ce9p-11,
     0x1.8754ee29c429p-15, -0x1.d30dbe5cad652p-20, -0x1.583107b42f964p-24, 0x1.435591bc2460cp-26,
     -0x1.b70465a4f3774p-30, 0x1.2c365891e68cbp-34, 0x1.a10c2228ba77dp-40}, /* [25] 9.375 <= y <= 9.75, 57.4 bits */
    {0x1.c80d487c2515dp-5, 0x1.b2e11e88afb82p-63, -0x1.779846d25388ep-6, 0x1.2744248c370cfp-8, -0x1.1f03cce11047dp-11,
     0x1.6ad2193fad303p-15, -0x1.f5c187ab12dap-20, -0x1.3b63b78582d51p-25, 0x1.ee20f887e92f2p-27,
     -0x1.763d9a9923672p-30, 0x1.34afa6ec17e68p-34, -0x1.6784bf232db87p-42}, /* [26] 9.75 <= y <= 10.125, 60.9 bits */
    {0x1.8696a6c0b6df6p-5, -0x1.5acacc5cc4f2p-62, -0x1.43deb08ccbe35p-6, 0x1.013b2f1c15fb1p-8, -0x1.fcc9abfe96656p-12,
     0x1.4cfa88c103bc4p-15, -0x1.00c8379c1abfep-19, -0x1.141feceb7634cp-28, 0x1.6ddcfd1dd1c9fp-27,
     -0x1.36611fde15393p-30, 0x1.25a2b4898c8bfp-34, -0x1.8b4bc8fa72845p-40}, /* [27] 10.125 <= y <= 10.5, 58.3 bits */
    {0x1.4e2e64843e345p-5, 0x1.b4eee467947c3p-59, -0x1.16dbd8b66a831p-6, 0x1.bf2bf87627346p-9, -0x1.c12c2d65db014p-12,
     0x1.2ef7d98c61ef4p-15, -0x1.fc66be6be738ep-20, 0x1.53c0ea32e6d54p-26, 0x1.04be69152a8ddp-27,
     -0x1.f685bad53fda5p-31, 0x1.0940146f26b2ep-34, -0x1.14b4c214cfcbbp-39}, /* [28] 10.5 <= y <= 10.875, 59.6 bits */
    {0x1.1da567183cbdp-5, -0x1.71d40dab342ap-61, -0x1.df8d0f9e64d29p-7, 0x1.83deff3f6ffa5p-9, -0x1.8b21bbf2f8308p-12,
     0x1.11a2e48e1da29p-15, -0x1.eb20604e33301p-20, 0x1.384bba53b730ep-25, 0x1.612383faa5be4p-28,
     -0x1.8dc5463b5bd06p-31, 0x1.cd85ab80375edp-35, -0x1.313c96350da4ap-39}, /* [29] 10.875 <= y <= 11.25, 58.7 bits */
    {0x1.e7e113d1c3ae3p-6, 0x1.340435bc714c6p-63, -0x1.9bd09a10a3bfcp-7, 0x1.4fc9c9dd7246dp-9, -0x1.5a7aab0830febp-12,
     0x1.eb260194e2231p-16, -0x1.d1a2512df65b9p-20, 0x1.959dbb2b7c235p-25, 0x1.ba9085cf81a5bp-29,
     -0x1.33fc16cf1c23dp-31, 0x1.85f25abab677fp-35, -0x1.2d76885415f5dp-39}, /* [30] 11.25 <= y <= 11.625, 57.2 bits */
    {0x1.a04a4d0c1cf0dp-6, -0x1.9e648641529a9p-64, -0x1.6139c0e60cabfp-7, 0x1.222f24a3ba1c5p-9, -0x1.2eeffee46c5a6p-12,
     0x1.b65726ac60561p-16, -0x1.b2fa1fc59085p-20, 0x1.cce329845d979p-25, 0x1.e12b6a7b191a5p-30, -0x1.d20f8ee4c532ap-32,
     0x1.41ae2a73380bcp-35, -0x1.16dbf4d3256aep-39}, /* [31] 11.625 <= y <= 12, 57.2 bits */
    {0x1.62eb846ec1789p-6, 0x1.ddc7b8f7bbae5p-60, -0x1.2ea26bb4140a7p-7, 0x1.f4b9ecd0f74fbp-10, -0x1.082c0a88bdc54p-12,
     0x1.854f6e13c0d95p-16, -0x1.917eec485c71dp-20, 0x1.e757fb2b3f435p-25, 0x1.664f626db9e6p-31, -0x1.57a726ceeb513p-32,
     0x1.03f6aed5d7ca8p-35, -0x1.eda9f7e3c374p-40}, /* [32] 12 <= y <= 12.375, 56.8 bits */
    {0x1.2e5dda42cc5cbp-6, 0x1.c4e92a1219028p-60, -0x1.0304bae8f1bb6p-7, 0x1.af5ba9e9cc9b4p-10, -0x1.cba218652b504p-13,
     0x1.5847f9646d033p-16, -0x1.6ef10ef1bc97fp-20, 0x1.ec883eb280eb1p-25, -0x1.43434f27c006cp-33,
     -0x1.eb41049ee6a96p-33, 0x1.9c7359dba5521p-36, -0x1.a727f6b230a5cp-40}, /* [33] 12.375 <= y <= 12.75, 58.0 bits */
    {0x1.0168b4613f50ep-6, -0x1.283096b11d37fp-67, -0x1.baf1236d1f817p-8, 0x1.731394a372c39p-10, -0x1.8efc422319d6ap-13,
     0x1.2f4cca22f5e07p-16, -0x1.4c96d2120fb34p-20, 0x1.e2806c5a9e924p-25, -0x1.850852e1ad53ep-31,
     -0x1.510d90db57e8cp-33, 0x1.4178c044a9beep-36, -0x1.61d3aac8b4a1ep-40}, /* [34] 12.75 <= y <= 13.125, 57.6 bits */
    {0x1.b5f8cd5991f66p-7, -0x1.8e8a7e20a0a49p-63, -0x1.7a62143a23c0ep-8, 0x1.3ecd01c838f0dp-10, -0x1.59a5c1b3f6af4p-13,
     0x1.0a498d958c41cp-16, -0x1.2b5588239626bp-20, 0x1.ce0356f7e229fp-25, -0x1.2992eb5c7cc03p-30,
     -0x1.b3c2e74862087p-34, 0x1.ec51b2e096f7ep-37, -0x1.21f548801d7b1p-40}, /* [35] 13.125 <= y <= 13.5, 58.9 bits */
    {0x1.745aabb97614cp-7, 0x1.211be7a517e4fp-61, -0x1.42f3d72d83355p-8, 0x1.118e03552198fp-10, -0x1.2ae3cf72cef99p-13,
     0x1.d227624aabae3p-17, -0x1.0bc6d4784b8b9p-20, 0x1.b2bf9def54d9bp-25, -0x1.6983c8425c1d2p-30,
     -0x1.fdbfe4c88908dp-35, 0x1.71ebf7d7ec521p-37, -0x1.d32e6297fcaaap-41}, /* [36] 13.5 <= y <= 13.875, 59.1 bits */
    {0x1.3c5f24c5c33f5p-7, 0x1.454b892b49b47p-63, -0x1.136a6b547da02p-8, 0x1.d4ec9af99fc0ap-11, -0x1.02051527b9adep-13,
     0x1.96e45ed95c824p-17, -0x1.dc94a3e60920ep-21, 0x1.938126f542679p-25, -0x1.8c0b2a03a7013p-30,
     -0x1.e13bfe0453afap-36, 0x1.100c389101c2bp-37, -0x1.72afc51fafb0ap-41}, /* [37] 13.875 <= y <= 14.25, 58.6 bits */
    {0x1.0ca5cd0d22228p-7, -0x1.91e76ed88fd1cp-62, -0x1.d56327fe1298fp-9, 0x1.917b722c86843p-11, -0x1.bcc79d10b976ep-14,
     0x1.6246fc08d8869p-17, -0x1.a627e139ec25dp-21, 0x1.725cee58413bep-25, -0x1.98ecfa6c1d59fp-30,
     -0x1.684905d2a6a28p-38, 0x1.85d6bf31c8ec9p-38, -0x1.21fbd107774f4p-41}, /* [38] 14.25 <= y <= 14.625, 57.3 bits */
    {0x1.c7fd443b9836dp-8, -0x1.8f3bf8bc7cc82p-62, -0x1.8fb0f4f0d0efp-9, 0x1.57651761044efp-11, -0x1.7ecde57f9b251p-14,
     0x1.33c3f0c72b118p-17, -0x1.746eeca2ce70ep-21, 0x1.50d69fcd7ca48p-25, -0x1.9648ac655a6e1p-30,
     0x1.73e7326c6dfaep-37, 0x1.0df72d1cd20b1p-38, -0x1.bf6e80c14b2d4p-42}, /* [39] 14.625 <= y <= 15, 57.8 bits */
    {0x1.82c7932f175b8p-8, -0x1.b29e35fc4b05cp-65, -0x1.541b4a9620eb8p-9, 0x1.256f46926de14p-11, -0x1.49054fcc1f8efp-14,
     0x1.0ace2e4c4edf9p-17, -0x1.4763240ba4736p-21, 0x1.300017eb11c09p-25, -0x1.88e0f93784b3p-30, 0x1.751955c211fe5p-36,
     0x1.643a0d3fecea9p-39, -0x1.543e227c036fbp-42}, /* [40] 15 <= y <= 15.375, 57.0 bits */
    {0x1.47e81329f7795p-8, 0x1.28ae1ff1bba18p-62, -0x1.2136907016b23p-9, 0x1.f50a6e031110ap-12, -0x1.1a70674a79c1cp-14,
     0x1.cdb6d91b70e65p-18, -0x1.1eddd6774abfap-21, 0x1.10934d6c25c77p-25, -0x1.745c358069d3bp-30,
     0x1.eca042fa3bbddp-36, 0x1.b31c930aeed2ap-40, -0x1.fd5d3680e3ae6p-43}, /* [41] 15.375 <= y <= 15.75, 57.0 bits */
    {0x1.15dbd38ccdf7bp-8, -0x1.9ddd8ce09c279p-63, -0x1.eb8fb2423f153p-10, 0x1.ab67ef126fcadp-12,
     -0x1.e45643bed5084p-15, 0x1.8ece8448f15d1p-18, -0x1.f54631d349964p-22, 0x1.e60e99c220f0fp-26,
     -0x1.5b7c0d5540136p-30, 0x1.18c10bfc9e422p-35, 0x1.ca80212b88d1dp-41, -0x1.7660763d8c1b7p-43},
     /* [42] 15.75 <= y <= 16.125, 59.4 bits */
    {0x1.d6adb396827b8p-9, -0x1.5bcbc447d6498p-63, -0x1.a17dbcd62101fp-10, 0x1.6c4de3e5b824cp-12,
     -0x1.9ed32592f53eap-15, 0x1.57ea40d87a17fp-18, -0x1.b4d3ebd9a39ap-22, 0x1.af41fa8897b23p-26,
     -0x1.404c9c9f2a5c1p-30, 0x1.289244d3cb164p-35, 0x1.3de405aab36bfp-42, -0x1.0d13a5e15ac78p-43},
     /* [43] 16.125 <= y <= 16.5, 59.9 bits */
    {0x1.8e794b5b7857fp-9, -0x1.2e4e6f0fc101bp-64, -0x1.62613f95ae9f1p-10, 0x1.364945b013b8cp-12,
     -0x1.62eca62726e71p-15, 0x1.2822f5ad194ccp-18, -0x1.7bc505d9061c1p-22, 0x1.7d00baf271683p-26,
     -0x1.244b7a687e686p-30, 0x1.2afe186c96efbp-35, -0x1.ac942250ef3d3p-44, -0x1.77ae5c3eec883p-44},
     /* [44] 16.5 <= y <= 16.875, 57.2 bits */
    {0x1.513352d3e75d6p-9, 0x1.2920ca774b9dp-65, -0x1.2ca5320a3da78p-10, 0x1.08171bf50e1aap-12, -0x1.2f61843e5d17ep-15,
     0x1.fd494618164edp-19, -0x1.49749ddb0cad9p-22, 0x1.4f55b57efb23dp-26, -0x1.08879afc1da6cp-30,
     0x1.240d6c744dbbbp-35, -0x1.8e9dc1cc17dbep-42, -0x1.f78e2fdbf2176p-45}, /* [45] 16.875 <= y <= 17.25, 56.8 bits */
    {0x1.1d3b345836b0dp-9, -0x1.4ad74ba2ea818p-64, -0x1.fdda13967042ap-11, 0x1.c13dcb4ad774ep-13,
     -0x1.03166ec2260ffp-15, 0x1.b55d2bfe3ccd7p-19, -0x1.1d3f120ff8d99p-22, 0x1.2626984904dcp-26,
     -0x1.db760c5e30c32p-31, 0x1.16d449eca80fp-35, -0x1.266a404c44b7dp-41, -0x1.3cf2e88ca7127p-45},
     /* [46] 17.25 <= y <= 17.625, 59.3 bits */
    {0x1.e259ffa94a2f7p-10, 0x1.6b41d8edb4c91p-69, -0x1.b01a802af5febp-11, 0x1.7ddb085358f43p-13,
     -0x1.ba24dcb2ce2dcp-16, 0x1.7725fb20ca98dp-19, -0x1.ed0cab40053bfp-23, 0x1.01401478e6b13p-26,
     -0x1.a8beb597df8a7p-31, 0x1.05a4604104172p-35, -0x1.5fa6c78c7eaf6p-41, -0x1.64e75a9c1c81p-46},
     /* [47] 17.625 <= y <= 18, 57.3 bits */
    {0x1.97b1b68bbe62p-10, -0x1.0fa06294b66e6p-64, -0x1.6e097ea3e7f4cp-11, 0x1.44614b4d0e676p-13,
     -0x1.78f6db64a59d5p-16, 0x1.416c2b1aa8f7p-19, -0x1.a9698de512b99p-23, 0x1.c0be1b02ce207p-27,
     -0x1.797c07ef332f5p-31, 0x1.e46d123cd38b5p-36, -0x1.7d0111a56602cp-41, -0x1.35c29d74f84e6p-47},
     /* [48] 18 <= y <= 18.375, 57.7 bits */
    {0x1.5877358711e34p-10, -0x1.14c239e02ff51p-65, -0x1.35ee4258ebf3fp-11, 0x1.136551e3b7957p-13,
     -0x1.4125e143b9bbap-16, 0x1.131a1b943d91dp-19, -0x1.6e7dcf13ade2dp-23, 0x1.866ed806fe4b4p-27,
     -0x1.4df9d49d2fd87p-31, 0x1.bb98fcd95a9c1p-36, -0x1.8638b1ba49395p-41, -0x1.581168508ffe3p-51},
     /* [49] 18.375 <= y <= 18.75, 59.2 bits */
    {0x1.22f0b62d9d14fp-10, 0x1.2b30bce378447p-64, -0x1.064f4e28a0016p-11, 0x1.d35bcf8579a08p-14,
     -0x1.116607cc24cecp-16, 0x1.d6732b76dd4bp-20, -0x1.3b48817d2c95dp-23, 0x1.52f232f43d08ap-27,
     -0x1.26509b3238f3dp-31, 0x1.9297e7f235b7dp-36, -0x1.8142b4892da59p-41, 0x1.64555a8988edep-48},
     /* [50] 18.75 <= y <= 19.125, 58.8 bits */
    {0x1.eb4bf77dd005ap-11, -0x1.71ae808dc817fp-70, -0x1.bbd361ef81383p-12, 0x1.8c5ace4f3271dp-14,
     -0x1.d12daab52294ap-17, 0x1.91e256071d1b1p-20, -0x1.0edf5fa056319p-23, 0x1.25a71f807d89ap-27,
     -0x1.0274b06f8df84p-31, 0x1.6aa8611917036p-36, -0x1.72a83a942c29ap-41, 0x1.36c29d245385cp-47},
     /* [51] 19.125 <= y <= 19.5, 58.6 bits */
    {0x1.9eada80d42eecp-11, 0x1.68b8efc2e1f83p-65, -0x1.7752cf2da6592p-12, 0x1.4ff7f773b7d41p-14,
     -0x1.8b7c2e8c081b3p-17, 0x1.57031ee819932p-20, -0x1.d0dd190e79259p-24, 0x1.fbe1473ae3e9ep-28,
     -0x1.c4839111e2bfcp-32, 0x1.449e447782037p-36, -0x1.5dd3b4bd3a129p-41, 0x1.8927d9c40ac03p-47},
     /* [52] 19.5 <= y <= 19.875, 60.6 bits */
    {0x1.5de5da394566ap-11, 0x1.24696fe99f173p-65, -0x1.3d45829b83804p-12, 0x1.1ca52bac31ccp-14, -0x1.500673828943fp-17,
     0x1.2486092016663p-20, -0x1.8e6f83564685bp-24, 0x1.b67244e3f9e69p-28, -0x1.8b0751a515ef7p-32,
     0x1.20fd8da6e9f0fp-36, -0x1.454f59476874fp-41, 0x1.b6819c707bceep-47}, /* [53] 19.875 <= y <= 20.25, 57.3 bits */
    {0x1.2725a50d2399fp-11, 0x1.e47e82e2316ebp-66, -0x1.0c194f380c5d9p-12, 0x1.e219f394f6fd2p-15,
     -0x1.1d5631fc4be11p-17, 0x1.f28b8b814dc02p-21, -0x1.55223b4b8aac8p-24, 0x1.79e8d5bf51626p-28,
     -0x1.57f93edad934cp-32, 0x1.000f3e88581e1p-36, -0x1.2af73dda2daddp-41, 0x1.c8fccaab36aa8p-47},
     /* [54] 20.25 <= y <= 20.625, 57.2 bits */
    {0x1.f1c7a74ef9d3p-12, 0x1.72b2e3c199a94p-66, -0x1.c4eeb3b54371ep-13, 0x1.9815c09654b87p-15, -0x1.e45113bd20837p-18,
     0x1.a8852ba7b2eb2p-21, -0x1.23c7744296e7fp-24, 0x1.4541b88933bd7p-28, -0x1.2ad480632974bp-32,
     0x1.c3e31797108b8p-37, -0x1.102140bdea24bp-41, 0x1.c8690d625eee7p-47}, /* [55] 20.625 <= y <= 21, 60.9 bits */
    {0x1.a3a52f3a6bbfdp-12, 0x1.c0af04e00a033p-67, -0x1.7e77241e413e7p-13, 0x1.5949194ad72c4p-15,
     -0x1.9acebf038306ep-18, 0x1.693c09eb4d52dp-21, -0x1.f2a894d207b33p-25, 0x1.178fc2f5e39f8p-28,
     -0x1.031198741a498p-32, 0x1.8d4890972ac1bp-37, -0x1.eb7941b801239p-42, 0x1.bab86fdee9b1ap-47},
     /* [56] 21 <= y <= 21.375, 57.2 bits */
    {0x1.61ad6f57a56dp-12, -0x1.2822a386fcf47p-67, -0x1.42dab31cdc093p-13, 0x1.2407f70d26174p-15,
     -0x1.5c46f9f290efbp-18, 0x1.332e0193c5e95p-21, -0x1.a9bb49b933e58p-25, 0x1.dff7ccfab9c2cp-29,
     -0x1.c056516e8157cp-33, 0x1.5c24b37e1544dp-37, -0x1.b8d5b4ee246f8p-42, 0x1.a466450ac63a2p-47},
     /* [57] 21.375 <= y <= 21.75, 57.0 bits */
    {0x1.2a000b931272cp-12, 0x1.05ba950b5cb0cp-66, -0x1.107265549402dp-13, 0x1.edc97e5f245edp-16, -0x1.271ecc6d439bp-18,
     0x1.050c9afa58326p-21, -0x1.6b2a4713b5cc7p-25, 0x1.9b891dabddd4ap-29, -0x1.834256dcfa0ep-33, 0x1.3031b4178a736p-37,
     -0x1.892635bceb4c6p-42, 0x1.88c995972561p-47}, /* [58] 21.75 <= y <= 22.125, 57.4 bits */
    {0x1.f60bba782a05p-13, -0x1.1fa797bd9ddccp-68, -0x1.cbad4aea88908p-14, 0x1.a14edb7b0a9a8p-16,
     -0x1.f3eb3b2ac339ap-19, 0x1.bb6d52ecc2a8bp-22, -0x1.358c5818711bep-25, 0x1.60792533ad8a6p-29,
     -0x1.4df6076e60ed4p-33, 0x1.0918d0396a07bp-37, -0x1.5ce2c344b5dddp-42, 0x1.6a56ca67fdd18p-47},
     /* [59] 22.125 <= y <= 22.5, 59.7 bits */
    {0x1.a6cbea5107e6dp-13, -0x1.760809074fe66p-67, -0x1.83abe7779f3b9p-14, 0x1.608be4b00563bp-16,
     -0x1.a73a82cde605ep-19, 0x1.78652ac1363efp-22, -0x1.07a643cb919f2p-25, 0x1.2d93c07161d6ap-29,
     -0x1.1f9163ba38d17p-33, 0x1.ccf442004c0bfp-38, -0x1.34446504d5b82p-42, 0x1.4ad3b7e8abaa6p-47},
     /* [60] 22.5 <= y <= 22.875, 57.7 bits */
    {0x1.63f87861d172dp-13, -0x1.3ec0063310101p-73, -0x1.46d9d4c62fa68p-14, 0x1.29bb313511c64p-16,
     -0x1.662612575a5dbp-19, 0x1.3f528e2bd7f1fp-22, -0x1.c0cb4522c2cp-26, 0x1.01c80c657a3d7p-29, -0x1.ee8d9ce78eff1p-34,
     0x1.8fe481de0126fp-38, -0x1.0f572035c9731p-42, 0x1.2b80aacb16765p-47}, /* [61] 22.875 <= y <= 23.25, 58.9 bits */
    {0x1.2ba2ed2e99bd5p-13, 0x1.3865be3f6a9dcp-67, -0x1.137ed047e6ca5p-14, 0x1.f6b566ced0ca5p-17,
     -0x1.2ef37375d6d49p-19, 0x1.0ec34d4ddec5dp-22, -0x1.7db83fc842148p-26, 0x1.b84ab41b084dcp-30,
     -0x1.a8b69d41466f4p-34, 0x1.5a3c92c0a7e24p-38, -0x1.dc0f4dbba71p-43, 0x1.0d38a1927c9f8p-47},
     /* [62] 23.25 <= y <= 23.625, 60.6 bits */
    {0x1.f851dc80a3cfdp-14, -0x1.0c92e190b84edp-71, -0x1.d04adfcd3cf18p-15, 0x1.a843e32127d23p-17,
     -0x1.002899b1219cbp-19, 0x1.caf28d904e937p-23, -0x1.447653ac3b93dp-26, 0x1.77b04aa7f5259p-30,
     -0x1.6c4c63d4545b3p-34, 0x1.2b3d1b599a5cap-38, -0x1.a05b5bb11124cp-43, 0x1.e114f2e78bbecp-48},
     /* [63] 23.625 <= y <= 24, 59.3 bits */
    {0x1.a851572351a5ep-14, 0x1.f31ac0413825cp-68, -0x1.87224a2858638p-15, 0x1.65f33d31af8e9p-17,
     -0x1.b10595b442c33p-20, 0x1.84c6d9fe9e361p-23, -0x1.13a018a107fcdp-26, 0x1.404e4994dea7ap-30,
     -0x1.3820874f1d6fbp-34, 0x1.0230c81a7c2e5p-38, -0x1.6b274dd2e6671p-43, 0x1.ab98ffb71d45ap-48},
     /* [64] 24 <= y <= 24.375, 58.6 bits */
    {0x1.64ee10e3b16e1p-14, 0x1.ea882d61ec426p-69, -0x1.496b6bec16617p-15, 0x1.2de8c6f705f0cp-17,
     -0x1.6ddd82b6d8daap-20, 0x1.492f5194a1279p-23, -0x1.d401cdfd3504ep-27, 0x1.10e100c94785ep-30,
     -0x1.0b257ff29efc1p-34, 0x1.bcdce9ae07aep-39, -0x1.3bf8e9e76b95dp-43, 0x1.7a5725ef93ca6p-48},
     /* [65] 24.375 <= y <= 24.75, 57.7 bits */
    {0x1.2c2e7da70255dp-14, -0x1.d0db586fef7dp-68, -0x1.155feefcd2f9cp-15, 0x1.fd22c0a8455a3p-18,
     -0x1.3503c23f917fep-20, 0x1.169b041eddbf6p-23, -0x1.8d1d3d118a778p-27, 0x1.d09cdf5fd4e41p-31,
     -0x1.c8d88013ebbc1p-35, 0x1.7eb49cebafd51p-39, -0x1.124f2207108f5p-43, 0x1.4d6d82494b362p-48},
     /* [66] 24.75 <= y <= 25.125, 56.7 bits */
    {0x1.f8cf1511eea51p-15, -0x1.19969018f5f16p-72, -0x1.d2fe6a0fe6c93p-16, 0x1.ad2dbf0fa1c28p-18,
     -0x1.04e8b80d90318p-20, 0x1.d765e18981af9p-24, -0x1.50c8428a38db6p-27, 0x1.8b42f4afcd71ep-31,
     -0x1.864351c581ac4p-35, 0x1.48cc6d3957a1fp-39, -0x1.db4ff67e76585p-44, 0x1.24d04e9dbc0d1p-48},
     /* [67] 25.125 <= y <= 25.5, 57.7 bits */
    {0x1.a8611f3435c58p-15, 0x1.a66e32b3e7004p-69, -0x1.890790f48ed5p-16, 0x1.69ae02b5f10e3p-18, -0x1.b8709b4dada13p-21,
     0x1.8ea3ddb3d3202p-24, -0x1.1d78e69423c47p-27, 0x1.500b145c253b1p-31, -0x1.4d17f4bedb439p-35,
     0x1.1a234385ab43ap-39, -0x1.9b0946c75b7efp-44, 0x1.00574eec29743p-48}, /* [68] 25.5 <= y <= 25.875, 57.2 bits */
    {0x1.64b22b6b2505bp-15, 0x1.aa8c00bbeb3fap-69, -0x1.4ab4c011c0ab6p-16, 0x1.30b754b8f832ep-18,
     -0x1.73a28c828cc9ap-21, 0x1.50fb52bfa7276p-24, -0x1.e3b9c1b1d8b54p-28, 0x1.1d8532be6a0e2p-31,
     -0x1.1c10a3fd8dc98p-35, 0x1.e3a469872b2ep-40, -0x1.62d8512a831bbp-44, 0x1.bf8fc48a29c18p-49}
     /* [69] 25.875 <= y <= 26.25, 57.6 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_time_of_max_overlap_1)

/* time of the largest overlap, a = 3/2: 70 rows of degree 10 in y = ln(1 + beta), nodes 0.1875 + i 0.375, y < 26.25.
 * Relative error of the approximation: 2^-56.9 at most, sampled at 25 places of each row. */
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_3_2_FIRST 0.1875
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_3_2_STEP 0.375
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_3_2_PER_UNIT 2.6666666666666665
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_3_2_ROWS 70
#define COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_3_2_END 26.25
COR_ROWS(double, cor_rows_crossley_time_of_max_overlap_3_2, 70, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.8f968bbf9a4f6p+0, -0x1.cd99c801cfa7ep-57, -0x1.066b0d2c6bb93p-2, 0x1.7f9ee56c81a1bp-9, 0x1.c0c2469d74e5fp-10,
     0x1.8293a8ac7488p-17, -0x1.62e9e77cbd833p-16, -0x1.be84762344adp-24, 0x1.5ce7c465635c1p-22, -0x1.628f4c7f18c9p-28,
     -0x1.978521c7897b5p-28, 0x1.0bf1a22e1432cp-32}, /* [0] 0 <= y <= 0.375, 59.2 bits */
    {0x1.771d6770316bap+0, -0x1.d4d560354b187p-56, -0x1.036e360b1a3dap-2, 0x1.3dee55bf926e7p-8, 0x1.bd851dfedbc9p-10,
     -0x1.d20070cb0f228p-16, -0x1.573b8a027e3bcp-16, 0x1.79d82ed5dbd54p-21, 0x1.2e71d89dd5df9p-22,
     -0x1.8601943bfaedcp-26, -0x1.2073e665ca86p-28, 0x1.60c86c5045213p-31}, /* [1] 0.375 <= y <= 0.75, 58.8 bits */
    {0x1.5efd9bcb5e639p+0, 0x1.d096333d48686p-54, -0x1.fdf50aba5b537p-3, 0x1.b901ca3d37291p-8, 0x1.ab4ca0a65fcd3p-10,
     -0x1.0d214cc77e752p-14, -0x1.2ffd2a2882919p-16, 0x1.672c93b186ffap-20, 0x1.a6608a701224ep-23,
     -0x1.167aa5d5a544dp-25, -0x1.9946097d3b3a1p-30, 0x1.9c59f6994be0ap-31}, /* [2] 0.75 <= y <= 1.125, 59.5 bits */
    {0x1.4759ae3382932p+0, -0x1.2cb7c8ea0131cp-54, -0x1.f23e77f42d6c1p-3, 0x1.1684ecddcb392p-7, 0x1.8bca7cba93991p-10,
     -0x1.8e74dd1c5aee5p-14, -0x1.eac2dfdc8ca4ep-17, 0x1.ce8c1c1f4df07p-20, 0x1.9e627799e4014p-24,
     -0x1.1aeebc2923a5bp-25, 0x1.2394e25163826p-30, 0x1.3a019e44757c9p-31}, /* [3] 1.125 <= y <= 1.5, 59.5 bits */
    {0x1.30522c8073b04p+0, -0x1.3d8b9be752ee9p-55, -0x1.e3ed832d58c85p-3, 0x1.4b50b284ce476p-7, 0x1.6188cf89f42c4p-10,
     -0x1.f1ac246a0b804p-14, -0x1.624057cc71335p-17, 0x1.f18e71dac20bp-20, 0x1.aa3379256986fp-28,
     -0x1.c52041abdfcf8p-26, 0x1.667e8c986a548p-29, 0x1.0d52341fc0f15p-32}, /* [4] 1.5 <= y <= 1.875, 58.8 bits */
    {0x1.1a04b9a2440ccp+0, -0x1.b24e55e1173cp-54, -0x1.d3490fb743dbep-3, 0x1.799603d69caebp-7, 0x1.2f7f20b8c4b24p-10,
     -0x1.1a32a0a0b5d7ep-13, -0x1.b02a0218e4ffep-18, 0x1.dd5b9c42b35a7p-20, -0x1.f7d53a5cb6111p-25,
     -0x1.1ea1b4700403p-26, 0x1.930847875d8fbp-29, -0x1.ee165397bb7d3p-35}, /* [5] 1.875 <= y <= 2.25, 60.1 bits */
    {0x1.048b5206a4c2cp+0, -0x1.5467d9af5ceb6p-55, -0x1.c0a520f455a8dp-3, 0x1.a073536c813c3p-7, 0x1.f161409f65c05p-11,
     -0x1.2bec4f3dcd77p-13, -0x1.6433f31914c66p-19, 0x1.a5c61ebf914edp-20, -0x1.960507f6bc402p-24,
     -0x1.03f54b23ab8cp-27, 0x1.4433feb3cee4fp-29, -0x1.eca92e9839fb6p-33}, /* [6] 2.25 <= y <= 2.625, 62.1 bits */
    {0x1.dff799135edf9p-1, 0x1.2a6110cba9358p-55, -0x1.ac5dcf118ab78p-3, 0x1.bf6ff726c336cp-7, 0x1.7fc90323fb4a4p-11,
     -0x1.2fcaa8b054b65p-13, 0x1.3a37e92a1fe58p-21, 0x1.5db4e12551e42p-20, -0x1.cab1f436461fbp-24,
     -0x1.37dc46b782b3cp-30, 0x1.8b3bac2691cb2p-30, -0x1.0ef603cce7c4p-32}, /* [7] 2.625 <= y <= 3, 58.8 bits */
    {0x1.b8cf2c0f7c944p-1, 0x1.e310a468d98d7p-57, -0x1.96d29c99ca7bfp-3, 0x1.d6707e45f407p-7, 0x1.0ef9f4635e2cap-11,
     -0x1.28243306dcb27p-13, 0x1.ad9d5eb7dfcf7p-19, 0x1.12b285d889e7p-20, -0x1.c06ce33630d48p-24, 0x1.37eb08c846d4ap-29,
     0x1.584d4fcecb27bp-31, -0x1.85ba97af52deep-33}, /* [8] 3 <= y <= 3.375, 58.9 bits */
    {0x1.93b74263a8736p-1, -0x1.3c50da5e4ca36p-56, -0x1.806272d21b8ebp-3, 0x1.e5a72988dfcdfp-7, 0x1.459fa8cd595e4p-12,
     -0x1.176cb7eb95e31p-13, 0x1.5d2ac1b4d49b5p-18, 0x1.982f136da0509p-21, -0x1.99caa6a9169d6p-24,
     0x1.da72b4776e338p-29, 0x1.2c44f19a73c26p-33, -0x1.75c156ab2ad8ap-34}, /* [9] 3.375 <= y <= 3.75, 59.5 bits */
    {0x1.70c104181ac65p-1, -0x1.a6b09ee23e4ddp-56, -0x1.69686015a6c8cp-3, 0x1.ed8380bbf1c45p-7, 0x1.f20068714a9ebp-14,
     -0x1.ffec44c010eacp-14, 0x1.bdc1f3cad8ec5p-18, 0x1.192f86f188e09p-21, -0x1.6c26215964a28p-24,
     0x1.e5b02ad6cd1efp-29, -0x1.721e1df485614p-35, -0x1.1e33481c1ca9ep-36}, /* [10] 3.75 <= y <= 4.125, 58.0 bits */
    {0x1.4ff557dcaa9e2p-1, -0x1.b7e205ca2ce7bp-57, -0x1.52391772a61c7p-3, 0x1.eea2b6f97e593p-7, -0x1.c94189c7d1423p-15,
     -0x1.c7b01cbca2d43p-14, 0x1.fcbaf89e20f1ep-18, 0x1.5219cc1ad7ab4p-22, -0x1.3fb4ee2698e76p-24,
     0x1.cf3f073fef14fp-29, -0x1.2e526785254dfp-35, 0x1.f75c69a980963p-37}, /* [11] 4.125 <= y <= 4.5, 60.7 bits */
    {0x1.3155928f6b073p-1, -0x1.b0ab8502c9958p-57, -0x1.3b2122f30c5f5p-3, 0x1.e9c18d21014f2p-7, -0x1.b121de6fec0cep-13,
     -0x1.89d78e62932e1p-14, 0x1.0f180c1bb315ap-17, 0x1.1ce6a95f20a99p-23, -0x1.149662c8d57edp-24,
     0x1.cd89b33ebf817p-29, 0x1.df1dcb049621cp-36, 0x1.064234263995bp-36}, /* [12] 4.5 <= y <= 4.875, 57.6 bits */
    {0x1.14dc4a6a18e5cp-1, -0x1.93bd31f0f73e1p-55, -0x1.2463b57dfc84bp-3, 0x1.dfafd5ed198f1p-7, -0x1.603dfd44ef58cp-12,
     -0x1.499c092af1f01p-14, 0x1.13108beeddf6p-17, -0x1.8acc3df3503acp-26, -0x1.d0c859777ce52p-25,
     0x1.e3e8211295c01p-29, 0x1.092ee9165ce69p-34, 0x1.ee4cb98a10cacp-40}, /* [13] 4.875 <= y <= 5.25, 58.4 bits */
    {0x1.f4fc7f93ff31dp-2, -0x1.db9e9ebd7e444p-56, -0x1.0e3a08e38cebdp-3, 0x1.d1459400bc2dbp-7, -0x1.cfd2303660dfdp-12,
     -0x1.09be24cb22a3bp-14, 0x1.0c52703bbbb19p-17, -0x1.44069ad62aeb5p-23, -0x1.73848dcc7c695p-25,
     0x1.fd5a4a8e1d172p-29, 0x1.638d63478b6c8p-35, -0x1.98f805307d4c4p-37}, /* [14] 5.25 <= y <= 5.625, 57.3 bits */
    {0x1.c4569ea81cd9dp-2, 0x1.c4a7bded05c5dp-56, -0x1.f1a669e02ebcep-4, 0x1.bf59b159d69ccp-7, -0x1.13f09aa3b7d5ep-11,
     -0x1.99017b6c324a4p-15, 0x1.fa0778e50e1dcp-18, -0x1.0c1d9dd645222p-22, -0x1.13014bf5912f3p-25,
     0x1.01c2123b2ecc6p-28, -0x1.4438c2e50e992p-36, -0x1.4522b415ab01ap-36}, /* [15] 5.625 <= y <= 6, 59.3 bits */
    {0x1.979ec609fd799p-2, 0x1.4234bffeaa62p-56, -0x1.c8a8d80cf86dp-4, 0x1.aaba5f534bdf5p-7, -0x1.34dfa62c36c99p-11,
     -0x1.2746a602d1df6p-15, 0x1.ceb7f7394fd28p-18, -0x1.56aa406e500bp-22, -0x1.6857d667fd763p-26,
     0x1.ea8de3a6298cbp-29, -0x1.86d69c14678adp-34, -0x1.3d191d94d7e0dp-36}, /* [16] 6 <= y <= 6.375, 58.6 bits */
    {0x1.6ea6b3368ceb7p-2, 0x1.85828b1451614p-56, -0x1.a1b311d5d0874p-4, 0x1.942730b15562bp-7, -0x1.4ba7cdf3c9cebp-11,
     -0x1.8183c03f8b839p-16, 0x1.9b109acd04ff7p-18, -0x1.83317c4af30dbp-22, -0x1.73ee2c99ecb83p-27,
     0x1.b2e967d9a738fp-29, -0x1.443a56cd2dda1p-33, -0x1.bdedbc334957ap-37}, /* [17] 6.375 <= y <= 6.75, 61.7 bits */
    {0x1.493bbb70e9951p-2, 0x1.4114fba3426bbp-57, -0x1.7cebb1be99b8ap-4, 0x1.7c4cf089de2aep-7, -0x1.5969bd8c0855p-11,
     -0x1.9bb50e58f112cp-17, 0x1.631252caeea61p-18, -0x1.9513aebc38011p-22, -0x1.272f7b0097de4p-29,
     0x1.6575803779406p-29, -0x1.8fa1b53605e73p-33, -0x1.86bd2c70328a2p-38}, /* [18] 6.75 <= y <= 7.125, 60.0 bits */
    {0x1.2728501366d94p-2, 0x1.cfc69a6fd7001p-57, -0x1.5a6a1b3f163d4p-4, 0x1.63c3203ccedbap-7, -0x1.5f5ecf239724ap-11,
     -0x1.a630a1d1fe956p-19, 0x1.2a2a9de7b68fp-18, -0x1.91049fb3bbfddp-22, 0x1.43a8d02ea1a4p-28, 0x1.0e40f6da0f4b4p-29,
     -0x1.a1a1fc6f7edafp-33, 0x1.0ae836d1f7a02p-40}, /* [19] 7.125 <= y <= 7.5, 59.7 bits */
    {0x1.083553416dcep-2, 0x1.cb84b013c5d1dp-56, -0x1.3a3888d5e6909p-4, 0x1.4b0aeda5cf922p-7, -0x1.5ec5d409e1043p-11,
     0x1.27da4e4c357dfp-18, 0x1.e62135a0768b7p-19, -0x1.7c53079ac6764p-22, 0x1.4bf579301a3ecp-27, 0x1.70dfa28ddf46fp-30,
     -0x1.8537c2e1fa446p-33, 0x1.89780019b7d72p-38}, /* [20] 7.5 <= y <= 7.875, 58.1 bits */
    {0x1.d856752fb113p-3, -0x1.5c5f9a3caea6bp-57, -0x1.1c5623e421e01p-4, 0x1.328f604acf9c9p-7, -0x1.58d3d2da13d77p-11,
     0x1.5f627cc29440dp-17, 0x1.7f77931754a96p-19, -0x1.5c3beea8fcfdcp-22, 0x1.b8dfbef913ed8p-27, 0x1.b034fbe7df0c8p-31,
     -0x1.4b54f480ed5f4p-33, 0x1.1d71eaeece712p-37}, /* [21] 7.875 <= y <= 8.25, 58.0 bits */
    {0x1.a5a60066f6ecep-3, 0x1.e2c12a2e495d3p-57, -0x1.00b90c99e0b76p-4, 0x1.1aa6738fcc507p-7, -0x1.4ea8f17cbd16cp-11,
     0x1.fd01b2c94862cp-17, 0x1.22e01480c1fd6p-19, -0x1.356c9df239938p-22, 0x1.f187608c9f3c4p-27, 0x1.6c3f80eff57a4p-32,
     -0x1.046934a020a9ap-33, 0x1.36d25324afc56p-37}, /* [22] 8.25 <= y <= 8.625, 57.6 bits */
    {0x1.77edc8f5f8cbep-3, -0x1.b3b472db1b475p-59, -0x1.cea07e6aa625p-5, 0x1.0392d4851e03bp-7, -0x1.41494b149bdcp-11,
     0x1.38eee7423a6a5p-16, 0x1.a35dad3554f7ep-20, -0x1.0bbc19fa3dfe1p-22, 0x1.007e6b26d6d1p-26, -0x1.cb28083e0ba5bp-37,
     -0x1.7a2953a82212cp-34, 0x1.244fb44ed5267p-37}, /* [23] 8.625 <= y <= 9, 59.9 bits */
    {0x1.4ec60915421e9p-3, -0x1.553ed0f515b18p-58, -0x1.a00a94d255952p-5, 0x1.db0c02c055c2fp-8, -0x1.3199243471986p-11,
     0x1.61b6d1d81ef22p-16, 0x1.1889613976ab2p-20, -0x1.c429d33dbf129p-23, 0x1.f2700f263a115p-27,
     -0x1.16170ac2efb4bp-32, -0x1.f53b9313b175p-35, 0x1.f27ba262dd72ep-38}, /* [24] 9 <= y <= 9.375, 59.2 bits */
    {0x1.29cb93fd56031p-3, -0x1.6f342c73021fbp-60, -0x1.757ba0d24f204p-5, 0x1.b145284ce34ccp-8, -0x1.205bcb1422769p-11,
     0x1.7b94a2b720bbfp-16, 0x1.4942a0aa0f36fp-21, -0x1.75021d5dca5b7p-23, 0x1.cfebd7c74c49p-27, -0x1.bb893bede9927p-32,
     -0x1.23e05a39133dap-35, 0x1.89a939d65557bp-38}, /* [25] 9.375 <= y <= 9.75, 57.8 bits */
    {0x1.08a07278ea05bp-3, -0x1.05738787c8386p-60, -0x1.4eb9a13aa897dp-5, 0x1.89fd1dd1e869p-8, -0x1.0e346d716b7b6p-11,
     0x1.89226cf976c44p-16, 0x1.185799ac71f9p-22, -0x1.2c934797c5f96p-23, 0x1.a1b54314b65fcp-27, -0x1.098d29bc80d64p-31,
     -0x1.07c6de2d8545ap-36, 0x1.225e0034f06bap-38}, /* [26] 9.75 <= y <= 10.125, 57.8 bits */
    {0x1.d5d88d8170028p-4, -0x1.4ce504f8e69ebp-62, -0x1.2b87769b2e58ap-5, 0x1.654b1878859c2p-8, -0x1.f7507e0e8dddcp-12,
     0x1.8cc2637a01f2p-16, -0x1.4d2166a0004c4p-26, -0x1.d879979e25e4dp-24, 0x1.6e23375e3d563p-27,
     -0x1.1885ca0f01d2cp-31, -0x1.19fec395f4504p-39, 0x1.8f952a79aae91p-39}, /* [27] 10.125 <= y <= 10.5, 57.7 bits */
    {0x1.a0b902e81ab01p-4, 0x1.bf9fe0955022dp-58, -0x1.0ba6a5a66e21p-5, 0x1.433582829ab9p-8, -0x1.d242cf56f4959p-12,
     0x1.88930b60a0619p-16, -0x1.fcd55ffd22bb8p-23, -0x1.68f4dcdcf7a0ep-24, 0x1.39c06c275b39p-27,
     -0x1.139a5f66604f4p-31, 0x1.d139f761a6f19p-38, 0x1.fa00476591706p-40}, /* [28] 10.5 <= y <= 10.875, 62.3 bits */
    {0x1.7148e166f859dp-4, 0x1.c1fbe3eb4543p-58, -0x1.ddb17ccd3e4bbp-6, 0x1.23b58e35d927dp-8, -0x1.ade49ec9a3d39p-12,
     0x1.7e6af688526bcp-16, -0x1.ae1198ae5aa55p-22, -0x1.0a5465cfce6e8p-24, 0x1.0792ba01c2baap-27,
     -0x1.020992d82bd55p-31, 0x1.9f03fe69d9913p-37, 0x1.1b6ed5b3718bcp-40}, /* [29] 10.875 <= y <= 11.25, 59.3 bits */
    {0x1.46fa62cdbe8f9p-4, 0x1.acefe5a3a0716p-61, -0x1.a9c0e69fa602fp-6, 0x1.06ba5017f7457p-8, -0x1.8ab1f8838646dp-12,
     0x1.6fd9ba2687422p-16, -0x1.16814e69f9f9p-21, -0x1.771588b761a87p-25, 0x1.b2dc202b341e9p-28,
     -0x1.d2af84a515efep-32, 0x1.fc3ef4a7e53ccp-37, 0x1.ef6051e29051ep-42}, /* [30] 11.25 <= y <= 11.625, 58.5 bits */
    {0x1.214b135402224p-4, -0x1.5938a244e7932p-60, -0x1.7b04d6fbae18ap-6, 0x1.d856c3b1342e3p-9, -0x1.69049da5ac199p-12,
     0x1.5e2c40de6084p-16, -0x1.41df2c0c7badfp-21, -0x1.ec60e0b4de12bp-26, 0x1.608771b29eebep-28,
     -0x1.9af91e4e18236p-32, 0x1.0d9dd2eb13fbap-36, 0x1.fc1be24e86be3p-45}, /* [31] 11.625 <= y <= 12, 58.3 bits */
    {0x1.ff86c93f38257p-5, 0x1.c34c37203f3b6p-59, -0x1.510bb6025b90dp-6, 0x1.a7d629ff6c237p-9, -0x1.4919fc206d93cp-12,
     0x1.4a7307af33ba6p-16, -0x1.5cee502818233p-21, -0x1.1d2621ce8c927p-26, 0x1.18ccafa7a8595p-28,
     -0x1.625244dec17c3p-32, 0x1.08afddbe19b9ep-36, -0x1.a291bc9acd99cp-43}, /* [32] 12 <= y <= 12.375, 57.5 bits */
    {0x1.c3ec51c046421p-5, -0x1.0a4588106d383p-60, -0x1.2b69d691758b1p-6, 0x1.7bb07f83b47d3p-9, -0x1.2b18848bf9545p-12,
     0x1.35893b16733d7p-16, -0x1.6afe37b930b5bp-21, -0x1.e62cc3e3daed7p-28, 0x1.b7007c878a9b6p-29,
     -0x1.2c24c375acadfp-32, 0x1.eebea9e14210bp-37, -0x1.6dade4a7213f9p-42}, /* [33] 12.375 <= y <= 12.75, 57.7 bits */
    {0x1.8efffc3b63da6p-5, -0x1.65fe5718aea39p-62, -0x1.09b9f94ebd9f5p-6, 0x1.539f5fc42c94ep-9, -0x1.0f145228b30b1p-12,
     0x1.201bfe4ece4e4p-16, -0x1.6ee3a4b6c9ed8p-21, 0x1.455bf7546cc16p-32, 0x1.4fee9d7ca628cp-29,
     -0x1.f4d0612fb9584p-33, 0x1.bed974fa109f8p-37, -0x1.b8d2cef3863a6p-42}, /* [34] 12.75 <= y <= 13.125, 57.2 bits */
    {0x1.600d608915ba7p-5, -0x1.c15955a4c7c3bp-60, -0x1.d73b234552aa9p-7, 0x1.2f5a9fb2f4b7cp-9, -0x1.ea264df3705cfp-13,
     0x1.0ab1685eae138p-16, -0x1.6b004647dc14ap-21, 0x1.935ff8a6da53bp-28, 0x1.f509e7e6f74ffp-30,
     -0x1.9c22264a2eeafp-33, 0x1.8989f2dfa188bp-37, -0x1.cdf84bad8c61ap-42}, /* [35] 13.125 <= y <= 13.5, 60.3 bits */
    {0x1.36712e326c832p-5, -0x1.453e91f4f928fp-59, -0x1.a179b430e8b48p-7, 0x1.0e9a140b97a1p-9, -0x1.ba1f8cd97df6bp-13,
     0x1.eb5de6682a072p-17, -0x1.614d9d75d5f09p-21, 0x1.5660fb3fa7e91p-27, 0x1.69576414d6bf6p-30,
     -0x1.4ecea38b1e728p-33, 0x1.53e5cd8b46035p-37, -0x1.c1431b2d57401p-42}, /* [36] 13.5 <= y <= 13.875, 60.6 bits */
    {0x1.1197e82efd076p-5, 0x1.4085d7bd25108p-60, -0x1.718d86f3956e1p-7, 0x1.e22dd2d921b6bp-10, -0x1.8df97b5269c6fp-13,
     0x1.c2be766726e5bp-17, -0x1.53694052c23cep-21, 0x1.b9c26f66ad42ap-27, 0x1.f1187c94e96bp-31, -0x1.0c8c809c68435p-33,
     0x1.21018273051a7p-37, -0x1.a0fce836eca62p-42}, /* [37] 13.875 <= y <= 14.25, 57.5 bits */
    {0x1.e1f94d189b3afp-6, 0x1.59fb2c9a37528p-62, -0x1.46e1901dd7173p-7, 0x1.ad19432119facp-10, -0x1.658d5541a09a1p-13,
     0x1.9bee090633c13p-17, -0x1.42a1442ca90a3p-21, 0x1.fbfd8f961c6cbp-27, 0x1.3d490744acd5cp-31,
     -0x1.a928a3bd401d6p-34, 0x1.e518711293582p-38, -0x1.76e3e824e85b6p-42}, /* [38] 14.25 <= y <= 14.625, 59.2 bits */
    {0x1.a84fc4f129c96p-6, 0x1.756e9af5afee9p-61, -0x1.20ed55700585cp-7, 0x1.7d738d34cae14p-10, -0x1.40ac2681be289p-13,
     0x1.773313ae270a1p-17, -0x1.300010c1e54bfp-21, 0x1.11fc0eec05325p-26, 0x1.5fd24f7f0496dp-32,
     -0x1.4bbdab9a1d6e9p-34, 0x1.928c117ca6a01p-38, -0x1.4956ff61bd95p-42}, /* [39] 14.625 <= y <= 15, 59.3 bits */
    {0x1.755c9fba28601p-6, -0x1.ca1fa3bc7c0c7p-62, -0x1.fe68a06ab0503p-8, 0x1.52c0c6029bbacp-10, -0x1.1f21bab2542e1p-13,
     0x1.54b8420c8f8bdp-17, -0x1.1c57334d247f7p-21, 0x1.1bba30dd090b1p-26, 0x1.09c6d31776811p-33,
     -0x1.fd36ff8e581f5p-35, 0x1.4aac630e01806p-38, -0x1.1c4bd6724c94dp-42}, /* [40] 15 <= y <= 15.375, 59.9 bits */
    {0x1.485f8d50a2c4ep-6, 0x1.b397c218b1a55p-60, -0x1.c28a7b7247ad9p-8, 0x1.2c8c94dabc38dp-10, -0x1.00b6ecd7632eap-13,
     0x1.34928c117ca77p-17, -0x1.0849014c6065p-21, 0x1.1d9a104b55548p-26, -0x1.0cd7098cf1427p-35,
     -0x1.7f1496f989a73p-35, 0x1.0d0f7d8a445cdp-38, -0x1.e41ab648e27b6p-43}, /* [41] 15.375 <= y <= 15.75, 59.2 bits */
    {0x1.20ac7a27d6b6ap-6, -0x1.fed05706b03a3p-60, -0x1.8d72cb5553518p-8, 0x1.0a6a7b9d8175ap-10, -0x1.ca66e3c3a0f31p-14,
     0x1.16c63d5e550a8p-17, -0x1.e8a1ff2185bc1p-22, 0x1.198db349cc4cep-26, -0x1.3ad4f28cdee7fp-33,
     -0x1.18e91d493554fp-35, 0x1.b1cb52a096e96p-39, -0x1.97923a3fa8be4p-43}, /* [42] 15.75 <= y <= 16.125, 57.5 bits */
    {0x1.fb534e2e82f81p-7, -0x1.b994bdb856ebap-66, -0x1.5e67b9035257ap-8, 0x1.d7ebccc4de275p-11, -0x1.98be6b8ab8aa7p-14,
     0x1.f6962558f1999p-18, -0x1.c19630d259591p-22, 0x1.1128a2c0f00d5p-26, -0x1.ed9e4a0fe745bp-33,
     -0x1.8dd9ab607ccd2p-36, 0x1.5a5f637d363b5p-39, -0x1.53e95fe2a337ep-43}, /* [43] 16.125 <= y <= 16.5, 61.8 bits */
    {0x1.bd9bc96d70fcdp-7, -0x1.c21e1dd8348cp-61, -0x1.34c18d072a304p-8, 0x1.a1a42109b622p-11, -0x1.6c06bed3eb21ep-14,
     0x1.c41f1f3f2b524p-18, -0x1.9bf3704a59f0ep-22, 0x1.05aec90505856p-26, -0x1.34b67d766dc45p-32,
     -0x1.0b8ee4ff7333bp-36, 0x1.11c276fe9d48cp-39, -0x1.1928843f29e84p-43}, /* [44] 16.5 <= y <= 16.875, 58.1 bits */
    {0x1.873de3a6ff7fap-7, 0x1.53292d8fbc78cp-62, -0x1.0fe93db71e9b2p-8, 0x1.715394c147076p-11, -0x1.43d6195ef97a9p-14,
     0x1.95f758b13866p-18, -0x1.7815da346fd59p-22, 0x1.f0433ab3d7b28p-27, -0x1.5ce222a79d63fp-32,
     -0x1.4a4375af12582p-37, 0x1.abd57bcc11134p-40, -0x1.cda9a6e81b44ap-44}, /* [45] 16.875 <= y <= 17.25, 58.9 bits */
    {0x1.575ff7f728751p-7, -0x1.236235d86eeb5p-68, -0x1.deae150f1dce4p-9, 0x1.465e51a12cb2fp-11, -0x1.1fc7a9ea9cd82p-14,
     0x1.6be5ed20f31d5p-18, -0x1.5639544050643p-22, 0x1.d2972f831d916p-27, -0x1.7410df06cbedcp-32,
     -0x1.565b188929a62p-38, 0x1.49e8540dfed0ap-40, -0x1.785e612af2522p-44}, /* [46] 17.25 <= y <= 17.625, 60.0 bits */
    {0x1.2d40816f2bcc2p-7, -0x1.482bacc741362p-61, -0x1.a5224ff094499p-9, 0x1.20364b4a222a6p-11, -0x1.fef8789eb8ed2p-15,
     0x1.45ac7ccda77b9p-18, -0x1.3680938ec20c9p-22, 0x1.b394060659efp-27, -0x1.7e24e09c6b22dp-32,
     -0x1.8b4cf569db758p-40, 0x1.f4ad818e95075p-41, -0x1.30b8914bf2a76p-44}, /* [47] 17.625 <= y <= 18, 60.4 bits */
    {0x1.08339b8f0d8d8p-7, -0x1.00454554b8044p-62, -0x1.7254fcc049e06p-9, 0x1.fcb4daff99e19p-12, -0x1.c53538eadb4d4p-15,
     0x1.2309c74465d49p-18, -0x1.18fadce62095ep-22, 0x1.942aa1b9395fcp-27, -0x1.7e4623c12cc05p-32,
     0x1.510b143693b65p-40, 0x1.7444e073dc123p-41, -0x1.e9f4543abf05dp-45}, /* [48] 18 <= y <= 18.375, 58.7 bits */
    {0x1.cf417a300c50dp-8, 0x1.491166cd2e9efp-64, -0x1.4582f9d2b90c6p-9, 0x1.c0ab80fcd1b0cp-12, -0x1.919f84bc335ccp-15,
     0x1.03bba9f531fe8p-18, -0x1.fb5162ef868fdp-23, 0x1.751034940afeep-27, -0x1.7700c3c224ef5p-32,
     0x1.b57c2929f5701p-39, 0x1.0d671c77005c6p-41, -0x1.86f40490a7609p-45}, /* [49] 18.375 <= y <= 18.75, 62.5 bits */
    {0x1.960152bbdbcc2p-8, -0x1.6c8cdb452e2d1p-63, -0x1.1dfe02ae356acp-9, 0x1.8b7d1463b83bcp-12, -0x1.639da8e22559ap-15,
     0x1.cf0140eacb25bp-19, -0x1.c8ff29f725c8ap-23, 0x1.56c9edb8f3246p-27, -0x1.6a5f41a0680f3p-32,
     0x1.3a6eb7f11e0b5p-38, 0x1.7747b4d58fb56p-42, -0x1.3565554691fep-45}, /* [50] 18.75 <= y <= 19.125, 57.8 bits */
    {0x1.63b7285e05799p-8, -0x1.77f0299d58a4dp-63, -0x1.f655527b738f4p-10, 0x1.5c6ae2cc0774cp-12,
     -0x1.3aa21567fb9b9p-15, 0x1.9c31be4471186p-19, -0x1.9ada27ed6b379p-23, 0x1.39b6a88b0c371p-27,
     -0x1.5a010433df094p-32, 0x1.7b6a812f78527p-38, 0x1.ecde3c280d668p-43, -0x1.e5231fa6ac67ep-46},
     /* [51] 19.125 <= y <= 19.5, 58.4 bits */
    {0x1.378ee8e390d93p-8, 0x1.25a0f1dd7b96dp-63, -0x1.b8fcefdbfbce1p-10, 0x1.32c94d5fb9714p-12, -0x1.162af6eb481b3p-15,
     0x1.6e8e393c24a6p-19, -0x1.70b256e3f6367p-23, 0x1.1e16e7cb8f239p-27, -0x1.472d6e1267115p-32, 0x1.a451ba52acdc5p-38,
     0x1.23dd5da291e4ep-43, -0x1.78311416c97ddp-46}, /* [52] 19.5 <= y <= 19.875, 59.9 bits */
    {0x1.10cd036437af9p-8, -0x1.7b7b9a9e2e784p-63, -0x1.82fc76bc4e483p-10, 0x1.0dfe2b789dde2p-12,
     -0x1.eb8360dc5a97ap-16, 0x1.45a236146cd8fp-19, -0x1.4a505cb5cba24p-23, 0x1.04136051b4736p-27,
     -0x1.32e3ee89fbce5p-32, 0x1.ba8b4ed3b98a7p-38, 0x1.11e8286dd76c5p-44, -0x1.1fda373502f5cp-46},
     /* [53] 19.875 <= y <= 20.25, 59.7 bits */
    {0x1.dd9763f029a6ap-9, -0x1.b9c788d35086bp-63, -0x1.5378e3c4757f1p-10, 0x1.dafe835e79f41p-13,
     -0x1.b1f480b5e2601p-16, 0x1.20fffda7a457ap-19, -0x1.277880a9983e4p-23, 0x1.d7849d3ab212cp-28,
     -0x1.1de97249ebd3p-32, 0x1.c278c61fe061ep-38, 0x1.3519c99d2717cp-47, -0x1.b139ce95fcb61p-47},
     /* [54] 20.25 <= y <= 20.625, 61.3 bits */
    {0x1.a1f11642f57edp-9, 0x1.c03658a41762ap-63, -0x1.29afbd9d2c8d8p-10, 0x1.a1a19f568d04dp-13, -0x1.7ee5322a0539ep-16,
     0x1.0040fcbbd85c2p-19, -0x1.07ecf3bc22d36p-23, 0x1.aa5794f96e4fbp-28, -0x1.08d39246430eep-32,
     0x1.bfa2b45722e1ap-38, -0x1.115ac9a020936p-45, -0x1.3f00406f8d821p-47}, /* [55] 20.625 <= y <= 21, 57.0 bits */
    {0x1.6da4a8d32a908p-9, -0x1.cec07aea41f03p-64, -0x1.04f47eb24d267p-10, 0x1.6f086bf8d73a4p-13,
     -0x1.51a3e7150319ep-16, 0x1.c60bcec163c14p-20, -0x1.d6df195d0de2bp-24, 0x1.809a89299b8d2p-28,
     -0x1.e823ad4d024d8p-33, 0x1.b4de6a90c8e4dp-38, -0x1.08130f2158367p-44, -0x1.c80b3202eb0fap-48},
     /* [56] 21 <= y <= 21.375, 56.9 bits */
    {0x1.3fce2034a7542p-9, 0x1.67298912b593cp-65, -0x1.c95c7b21a22p-11, 0x1.426d68ee4cbb2p-13, -0x1.2990415b3a978p-16,
     0x1.91ed5e3c1bb81p-20, -0x1.a386268936949p-24, 0x1.5a38a5ee85764p-28, -0x1.bfeab3b1730a7p-33,
     0x1.a46db89b40be6p-38, -0x1.6170004f5650dp-44, -0x1.382ec05f6d0ddp-48}, /* [57] 21.375 <= y <= 21.75, 58.9 bits */
    {0x1.17a480dc610b9p-9, -0x1.e6cc573fc1d6p-64, -0x1.90ab1e90cf22ep-11, 0x1.1b2081ef3f429p-13, -0x1.0619bafd6564dp-16,
     0x1.6384af9ab95ep-20, -0x1.755862a2d819cp-24, 0x1.3711d8324c936p-28, -0x1.996e1c5318e77p-33, 0x1.90198b22eaf3ap-38,
     -0x1.9cd99a9f7e5a5p-44, -0x1.8ed48ad5a7f4fp-49}, /* [58] 21.75 <= y <= 22.125, 57.5 bits */
    {0x1.e8ed6bf03a7abp-10, -0x1.9dd995d8e6bcfp-65, -0x1.5ee53e92c2e56p-11, 0x1.f109d7eedd9b8p-14,
     -0x1.cd7cb145d8a02p-17, 0x1.3a3d691f843fp-20, -0x1.4be4384abe623p-24, 0x1.16fe54db58bb2p-28,
     -0x1.74f9be2a02733p-33, 0x1.794821ca49525p-38, -0x1.c0e57d6c1b623p-44, -0x1.bfae94bbfd4f3p-50},
     /* [59] 22.125 <= y <= 22.5, 60.0 bits */
    {0x1.ab519e422bdbdp-10, 0x1.6e6c090af6c87p-64, -0x1.3336f0b526822p-11, 0x1.b41e60d01bfa4p-14,
     -0x1.9612d4b4f532cp-17, 0x1.159028b3b8b5dp-20, -0x1.26be0b20d07b5p-24, 0x1.f3a2ba3fb2d12p-29,
     -0x1.52bbbe54f4e91p-33, 0x1.610f859c56e75p-38, -0x1.d2eadfb8b3a82p-44, -0x1.6705a79f52236p-51},
     /* [60] 22.5 <= y <= 22.875, 57.1 bits */
    {0x1.756318359dd32p-10, 0x1.85e811f91a90bp-65, -0x1.0ce4f4e4d672dp-11, 0x1.7e86c7cf67185p-14,
     -0x1.6524ba248fde6p-17, 0x1.ea038fc6de113p-21, -0x1.0580c1b3ffa6ap-24, 0x1.beb6c8d1af4dap-29,
     -0x1.32cb57e39536ep-33, 0x1.4844d42228b44p-38, -0x1.d739ab7891a84p-44, 0x1.6c5b10be21c7ep-54},
     /* [61] 22.875 <= y <= 23.25, 58.4 bits */
    {0x1.46305d283c95dp-10, 0x1.6fa5eefd90d3dp-65, -0x1.d693e5da79d42p-12, 0x1.4f670d10715f5p-14,
     -0x1.39f73ca17dcbdp-17, 0x1.b04527b094a2ep-21, -0x1.cf9c16e9d7fdfp-25, 0x1.8ed76beb9159bp-29,
     -0x1.152e5584a0eap-33, 0x1.2f88dfdcbe19p-38, -0x1.d148c00ff720bp-44, 0x1.588a199982231p-51},
     /* [62] 23.25 <= y <= 23.625, 61.4 bits */
    {0x1.1ce515342b95cp-10, -0x1.e7f814e39efaep-66, -0x1.9ba8048cd1347p-12, 0x1.25fc1522cf5c6p-14,
     -0x1.13e325ec0bb81p-17, 0x1.7d1b009cf24aap-21, -0x1.9a9ce5ca0101cp-25, 0x1.63a3665d692f1p-29,
     -0x1.f3baef8905f88p-34, 0x1.175294ca63056p-38, -0x1.c3dca2c097deap-44, 0x1.17bafb6b2d339p-50},
     /* [63] 23.625 <= y <= 24, 57.8 bits */
    {0x1.f18d3c69668a6p-11, 0x1.733ff446c5294p-65, -0x1.6804ea672f715p-12, 0x1.0198fe7be02c2p-14,
     -0x1.e4a684f26dbe9p-18, 0x1.4fceb5944c57p-21, -0x1.6b6292180d4cap-25, 0x1.3cbb7e549e6dfp-29,
     -0x1.c18ff1e03d355p-34, 0x1.ffeefeab5c1bep-39, -0x1.b127bfaa02f44p-44, 0x1.61f1d5d0704dbp-50},
     /* [64] 24 <= y <= 24.375, 57.5 bits */
    {0x1.b26201d0d10fbp-11, 0x1.a3d688e4d713fp-66, -0x1.3ac7c16b36d5cp-12, 0x1.c34972e2342d7p-15,
     -0x1.a9853706c3f78p-18, 0x1.27bc03e9be361p-21, -0x1.4158e93f7291p-25, 0x1.19c3d07d8b2b3p-29,
     -0x1.93acaf0e22c13p-34, 0x1.d3658b5d0b49bp-39, -0x1.9ae539bd03bbp-44, 0x1.9213bcafba46cp-50},
     /* [65] 24.375 <= y <= 24.75, 61.4 bits */
    {0x1.7b287eb571148p-11, -0x1.1740d8c064bebp-69, -0x1.1328b6a97e53dp-12, 0x1.8b2fbad40a977p-15,
     -0x1.7575ac3747039p-18, 0x1.044f47e64488ep-21, -0x1.1bf85a4717ef8p-25, 0x1.f4c9758cdc5a1p-30,
     -0x1.69d912846fddp-34, 0x1.a955ae1d63e6ep-39, -0x1.826f25a2492c3p-44, 0x1.adf22e1fdd927p-50},
     /* [66] 24.75 <= y <= 25.125, 62.3 bits */
    {0x1.4ae3e5a49fb58p-11, 0x1.5cf5567e495aep-66, -0x1.e0efb50a8790ep-13, 0x1.59f56c5f7b53dp-15,
     -0x1.47a56b7699122p-18, 0x1.ca081694d9b22p-22, -0x1.f58aa21910b2ap-26, 0x1.bc96ea70d506fp-30,
     -0x1.43d765c70bcbap-34, 0x1.81ec1352711dfp-39, -0x1.68d0ec3594a86p-44, 0x1.ba4200394dd9cp-50},
     /* [67] 25.125 <= y <= 25.5, 62.4 bits */
    {0x1.20b660fcde067p-11, -0x1.421583d20148ep-66, -0x1.a434b330a7d4p-13, 0x1.2ec708f74eaep-15, -0x1.1f598111418c7p-18,
     0x1.92c75063a76f3p-22, -0x1.ba9f0157c5918p-26, 0x1.8a54d6480f4adp-30, -0x1.2166f847359b9p-34,
     0x1.5d3cada441374p-39, -0x1.4ed675420bb4fp-44, 0x1.bacd8017cdebap-50}, /* [68] 25.5 <= y <= 25.875, 60.1 bits */
    {0x1.f7bab40fd41fbp-12, -0x1.54c1c1453a8abp-66, -0x1.6f100a15b1b67p-13, 0x1.08e9da5700a9p-15,
     -0x1.f7d80d476d62fp-19, 0x1.620803aba4d7dp-22, -0x1.866249eb61173p-26, 0x1.5d72c6c627d97p-30,
     -0x1.024625f910423p-34, 0x1.3b48ba3916adcp-39, -0x1.3518a2ae1461cp-44, 0x1.b29e3b9079165p-50}
     /* [69] 25.875 <= y <= 26.25, 59.6 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_time_of_max_overlap_3_2)

/* duration, a = 1: 36 rows of degree 10 in y = ln(1 + beta), nodes 0.0625 + i 0.125, y < 4.5.
 * Relative error of the approximation: 2^-58.4 at most, sampled at 25 places of each row. */
#define COR_ROWS_CROSSLEY_DURATION_1_FIRST 0.0625
#define COR_ROWS_CROSSLEY_DURATION_1_STEP 0.125
#define COR_ROWS_CROSSLEY_DURATION_1_PER_UNIT 8.0
#define COR_ROWS_CROSSLEY_DURATION_1_ROWS 36
#define COR_ROWS_CROSSLEY_DURATION_1_END 4.5
COR_ROWS(double, cor_rows_crossley_duration_1, 36, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9230d18b62d8cp+1, -0x1.7ea900f5a99b4p-53, 0x1.14a91140ca523p-6, 0x1.1d7147c52f2e8p-3, 0x1.7f967bcc05672p-5,
     0x1.b2db984bb4f4bp-7, 0x1.b0d01130c67e4p-9, 0x1.2476fe7fcc809p-11, -0x1.588d4827ac13cp-15, -0x1.7afe4d5f24b5cp-14,
     -0x1.a087213c5ee87p-15, -0x1.3b22ed9de4125p-16}, /* [0] 0 <= y <= 0.125, 64.5 bits */
    {0x1.92c0735941678p+1, -0x1.78cec39ee2294p-53, 0x1.baa2f61bf70ebp-5, 0x1.44168a4285f33p-3, 0x1.ba58911ffe326p-5,
     0x1.fa9e9bb34893cp-7, 0x1.e45e2f5fb926fp-9, 0x1.f02c5e8d5a6a4p-12, -0x1.583e174a6342ap-13, -0x1.51ac68baa7055p-13,
     -0x1.452bc5aa849c8p-14, -0x1.b0c7ccaae7f77p-16}, /* [1] 0.125 <= y <= 0.25, 65.4 bits */
    {0x1.93f25fc7caccfp+1, 0x1.2cf6b8cf967e3p-55, 0x1.8a3e4c100c568p-4, 0x1.70ad7519f3386p-3, 0x1.fe8a809b519edp-5,
     0x1.24bbe120973f2p-6, 0x1.04969e2a899bdp-8, 0x1.00eada78cc2fep-12, -0x1.8960874e2a198p-12, -0x1.18b998e3911e9p-12,
     -0x1.daf83a64e72fcp-14, -0x1.ff8a13245d7c3p-16}, /* [2] 0.25 <= y <= 0.375, 64.4 bits */
    {0x1.95dcec23cb8cp+1, -0x1.0a34828d73981p-55, 0x1.2791e1c9339d6p-3, 0x1.a421b061a2455p-3, 0x1.266e5c9fca17p-4,
     0x1.4de39728eabc1p-6, 0x1.0666c13cd5347p-8, -0x1.ce709e5644f39p-13, -0x1.762a7ae349129p-11, -0x1.b46272589e159p-12,
     -0x1.3941ae3a416cdp-13, -0x1.998c4146d0635p-16}, /* [3] 0.375 <= y <= 0.5, 62.8 bits */
    {0x1.9899dccd2ab8ap+1, 0x1.cbb239dbb74c7p-53, 0x1.97d6e4c08fa1ep-3, 0x1.df685c7c54d9dp-3, 0x1.52aa971db4b5cp-4,
     0x1.751df0ceb1607p-6, 0x1.d1d7aac4ebbb5p-9, -0x1.13eed203dd2c2p-10, -0x1.3f61204cacfb9p-10, -0x1.3860884b95edbp-11,
     -0x1.5449df912755ap-13, 0x1.6ac7336cd8a0dp-17}, /* [4] 0.5 <= y <= 0.625, 62.1 bits */
    {0x1.9c46dedade4d2p+1, -0x1.d28fff7f7a2c2p-54, 0x1.0c0035536e292p-2, 0x1.11b4d0348b5e9p-2, 0x1.835d7be2848dap-4,
     0x1.93ed74e954ac4p-6, 0x1.2ccb4cd89cba2p-9, -0x1.3b31b0cde6755p-9, -0x1.f1cb1a50459c2p-10, -0x1.8b0ee73039916p-11,
     -0x1.959248d94dcedp-14, 0x1.c36e67950ba8dp-14}, /* [5] 0.625 <= y <= 0.75, 63.3 bits */
    {0x1.a105fa8c8c2bap+1, -0x1.c2c51a5ed964ap-60, 0x1.552a9a5bf9d7bp-2, 0x1.386c91cbe566ep-2, 0x1.b6de4545bf6f4p-4,
     0x1.9fd9c52468d14p-6, -0x1.c551a53c44afcp-13, -0x1.20ad553fcaaacp-8, -0x1.5e517a54fe835p-9, -0x1.8865df004e022p-11,
     0x1.3a60aa63a0d1dp-13, 0x1.415c8bae06fccp-12}, /* [6] 0.75 <= y <= 0.875, 61.2 bits */
    {0x1.a6fdea7e1b271p+1, -0x1.d60777a845127p-55, 0x1.a89e080859c74p-2, 0x1.63fb610036677p-2, 0x1.e9e86f41f64abp-4,
     0x1.89888b7fd0e86p-6, -0x1.2509766e9f3b6p-8, -0x1.cc97ed64b08a6p-8, -0x1.a9f119bcb905ep-9, -0x1.3a325d2644591p-12,
     0x1.77b4a8ad49186p-11, 0x1.416f23ce68693p-11}, /* [7] 0.875 <= y <= 1, 61.0 bits */
    {0x1.ae5a37bf943b1p+1, -0x1.5fedcceef3939p-54, 0x1.03c5001023b6cp-1, 0x1.94194750605fdp-2, 0x1.0b7fd512a840bp-3,
     0x1.3d16ad820c436p-6, -0x1.625e009f0e82bp-7, -0x1.42c9b6b24a982p-7, -0x1.8740bd66208c1p-9, 0x1.0874449239651p-10,
     0x1.b5cf7a0f68d58p-10, 0x1.cc6f655c71edap-11}, /* [8] 1 <= y <= 1.125, 61.8 bits */
    {0x1.b74aecece7376p+1, 0x1.7a5aa9a4d4e4dp-57, 0x1.397c7fe58cbaap-1, 0x1.c7db969e55216p-2, 0x1.1b056d62b5271p-3,
     0x1.4b280700c381ep-7, -0x1.378407da6f3ccp-6, -0x1.7f73c7c9faaeap-7, -0x1.b3bd9921f9a8ap-11, 0x1.ca376605ade7p-9,
     0x1.61378b97d1ab4p-9, 0x1.403cbb0ba74b1p-11}, /* [9] 1.125 <= y <= 1.25, 59.8 bits */
    {0x1.c203a657053f8p+1, -0x1.9b640eb50cd3ep-54, 0x1.75d009529fa9ep-1, 0x1.fd785c838dbfp-2, 0x1.1e5951b8c018dp-3,
     -0x1.275286d24718ap-8, -0x1.c4189faeac9cep-6, -0x1.55f62a2c54907p-7, 0x1.17748ef7a83b8p-8, 0x1.b686419ea9b7fp-8,
     0x1.58b1d3dbaf388p-9, -0x1.050bcb1ed9e16p-10}, /* [10] 1.25 <= y <= 1.375, 61.3 bits */
    {0x1.ceb9c4ff38d2ap+1, -0x1.5e4d71492e6d6p-54, 0x1.b8d0ddeb26d58p-1, 0x1.1911fd53d66d4p-1, 0x1.102b5396a8eedp-3,
     -0x1.85aa8bcc7f856p-6, -0x1.1021d61cb4551p-5, -0x1.c08097da75ecep-9, 0x1.8ad4e59eee91ap-7, 0x1.101e4532e90aep-7,
     -0x1.e2338924a04afp-12, -0x1.0c51b87c5f0a2p-8}, /* [11] 1.375 <= y <= 1.5, 60.2 bits */
    {0x1.dda1a6017d189p+1, -0x1.153f2b321fd5bp-56, 0x1.0114155d01b2ep+0, 0x1.311c3e6d4ff98p-1, 0x1.da4cf5e7622b1p-4,
     -0x1.6b9e753054027p-5, -0x1.fb747ee60db93p-6, 0x1.5623fea36e87bp-7, 0x1.36d892574a35ap-6, 0x1.17519c41b9a2bp-8,
     -0x1.d6d705d8e98a1p-8, -0x1.8d243c9440fd2p-8}, /* [12] 1.5 <= y <= 1.625, 59.6 bits */
    {0x1.eeeb0a5d84897p+1, 0x1.7f39181cdf24ap-56, 0x1.28824b70cecedp+0, 0x1.44edc7ad10e84p-1, 0x1.6ded54e378e94p-4,
     -0x1.eb31f8f834bf9p-5, -0x1.11e0ad6c7de37p-6, 0x1.c1738d813e8b1p-6, 0x1.24e276ee890fp-6, -0x1.ef61d9ab66176p-8,
     -0x1.a46eaf3603473p-7, -0x1.9430f94ecad48p-10}, /* [13] 1.625 <= y <= 1.75, 61.0 bits */
    {0x1.015eab37b61fcp+2, -0x1.5be2d62c7f596p-53, 0x1.5212c89bd52abp+0, 0x1.5317da5407c69p-1, 0x1.dabfeda69c65cp-5,
     -0x1.01c88666bc085p-4, 0x1.168fb779136b9p-7, 0x1.34a0ba5963ef1p-5, 0x1.b007807cb736dp-9, -0x1.53506f06fc079p-6,
     -0x1.06568b4118735p-7, 0x1.3ceee34799feep-7}, /* [14] 1.75 <= y <= 1.875, 60.5 bits */
    {0x1.0c9a6968b9d96p+2, -0x1.71d750b55a656p-52, 0x1.7d08b4bc4d7f8p+0, 0x1.5b5ad1f2f49ap-1, 0x1.dfa80df6cd26ep-6,
     -0x1.90f110733e1e1p-5, 0x1.221820ba07b57p-5, 0x1.f81d0f3c2ec9ap-6, -0x1.3997a3474b66fp-6, -0x1.5710e11f6e838p-6,
     0x1.1f3ee73500a59p-7, 0x1.e18bce8d00f8dp-7}, /* [15] 1.875 <= y <= 2, 60.7 bits */
    {0x1.19311f28d44cep+2, -0x1.2f74fd738453bp-53, 0x1.a8b8195c9ecc7p+0, 0x1.5f07ec9bc95b9p-1, 0x1.73b58e2e4043dp-7,
     -0x1.5bad66f290a7ap-6, 0x1.9c0199ff04aa3p-5, 0x1.ca1ec1d4fc597p-8, -0x1.07026950271e8p-5, -0x1.56f5ef8bc020fp-9,
     0x1.57f7676808141p-6, 0x1.2bf392fb50559p-9}, /* [16] 2 <= y <= 2.125, 59.0 bits */
    {0x1.2726b198ccefcp+2, -0x1.09ab7e13e440ap-55, 0x1.d4b51fab684eep+0, 0x1.60b226c402acp-1, 0x1.1991a30a9f62bp-7,
     0x1.3d9d89599b819p-7, 0x1.73947048ceec7p-5, -0x1.34f1949e0fe86p-6, -0x1.7f580e67fc8d9p-6, 0x1.2df89ea7ef3ep-6,
     0x1.a07bf0d493f33p-7, -0x1.cb36ab1c6d40ep-7}, /* [17] 2.125 <= y <= 2.25, 59.2 bits */
    {0x1.367d09713e2eep+2, -0x1.da2799ad60903p-52, 0x1.00770f392e31fp+1, 0x1.6338fe88ebfc9p-1, 0x1.418843020e7a7p-6,
     0x1.0937c6ab42066p-5, 0x1.a7378c81f6502p-6, -0x1.eacbf3ac8678ep-6, -0x1.702b57da3a996p-10, 0x1.663a56599eb8fp-6,
     -0x1.a32311ca11b47p-8, -0x1.af4a8a881798p-7}, /* [18] 2.25 <= y <= 2.375, 58.4 bits */
    {0x1.4736dba389c97p+2, 0x1.1ae1ac2f218d4p-52, 0x1.16d1e87f08ba8p+1, 0x1.68bf560e23398p-1, 0x1.3d09d11c1028ap-5,
     0x1.55f406d624796p-5, 0x1.485062d527d3bp-8, -0x1.7ca336d8804e9p-6, 0x1.d9b4217542b28p-7, 0x1.102f21802afebp-7,
     -0x1.ddf1da2a3d52dp-7, 0x1.173faea94650ap-11}, /* [19] 2.375 <= y <= 2.5, 60.0 bits */
    {0x1.5959c1eba412bp+2, -0x1.a81a9514bfb31p-52, 0x1.2da4126505c93p+1, 0x1.723177b82011p-1, 0x1.e8156ee2e9655p-5,
     0x1.4bcee2b610f0ap-5, -0x1.d77b32afb3aeap-8, -0x1.2db32a7ce7526p-7, 0x1.f59c7c2ec4895p-7, -0x1.5903693678cbp-8,
     -0x1.fe780ae47a3ddp-8, 0x1.110f822e5dd45p-7}, /* [20] 2.5 <= y <= 2.625, 65.1 bits */
    {0x1.6cef2c531a1b5p+2, -0x1.ddddd19fe191fp-53, 0x1.452cb7c7d0cc9p+1, 0x1.7f7e0b0a31276p-1, 0x1.4168383491097p-4,
     0x1.1cf0d721ba7d3p-5, -0x1.420be4760cb75p-7, 0x1.0e26fdc8622dep-10, 0x1.f0c48f718c4aap-8, -0x1.13f2b30adeeacp-7,
     0x1.78c69dbfe8acdp-10, 0x1.52ba4e81df0c3p-8}, /* [21] 2.625 <= y <= 2.75, 58.4 bits */
    {0x1.82045c0930073p+2, 0x1.490aa82c9c88ep-52, 0x1.5da5a575e0396p+1, 0x1.902232b6a25b6p-1, 0x1.82b9fed3c41f4p-4,
     0x1.df7b021b44061p-6, -0x1.e5bb3e1334229p-8, 0x1.21e6557691dacp-8, 0x1.ba5cca4952988p-11, -0x1.29f44631a9429p-8,
     0x1.130a67100b51fp-8, -0x1.82dd35764e4a3p-12}, /* [22] 2.75 <= y <= 2.875, 59.7 bits */
    {0x1.98a9ea05047b6p+2, 0x1.a3f78e569e13cp-57, 0x1.77400742e89bcp+1, 0x1.a399b15fc2972p-1, 0x1.baa10351ff1d4p-4,
     0x1.a47f7d5563791p-6, -0x1.12b427bbcf62p-8, 0x1.f3e54654b166p-9, -0x1.a0fb54ed60819p-10, -0x1.717a366530954p-11,
     0x1.2a72d3f722bebp-9, -0x1.0639ece92bcbp-9}, /* [23] 2.875 <= y <= 3, 58.9 bits */
    {0x1.b0f346614e94bp+2, 0x1.461695c7c9122p-54, 0x1.92260b48f44cdp+1, 0x1.b98b932a4b6b3p-1, 0x1.ed0f8a37ca4c7p-4,
     0x1.865c2d9be0391p-6, -0x1.eb814f298b5cfp-10, 0x1.395486112b07ap-9, -0x1.7b0b4347ace9fp-10, 0x1.468e3a99b1b84p-11,
     0x1.51f43e39bf6dbp-12, -0x1.fe5424de5e2ccp-11}, /* [24] 3 <= y <= 3.125, 58.9 bits */
    {0x1.caf65f2ff1de7p+2, -0x1.bc603bfc959dfp-52, 0x1.ae7db3eb7e98bp+1, 0x1.d1c94f01b20ep-1, 0x1.0e7f0081682dp-3,
     0x1.7ae789b6363c2p-6, -0x1.fc3d1036db17fp-12, 0x1.71f7fa3442adfp-10, -0x1.a7afe07239dd6p-11, 0x1.1fc75946c23ep-11,
     -0x1.0af3514be50ecp-12, -0x1.5bb77701e948p-14}, /* [25] 3.125 <= y <= 3.25, 60.8 bits */
    {0x1.e6cb70b629c2p+2, -0x1.8472f83e3300fp-53, 0x1.cc6b10c4574cp+1, 0x1.ec40c4eb4cc63p-1, 0x1.261f7f7d16ccbp-3,
     0x1.7a97b9bf52afdp-6, 0x1.7a1e80345ff31p-12, 0x1.d8b99de134ff7p-11, -0x1.a6aab1503e7edp-12, 0x1.20d15f59da37p-12,
     -0x1.920e41adac3b2p-13, 0x1.b8ff6621c7f2dp-14}, /* [26] 3.25 <= y <= 3.375, 59.7 bits */
    {0x1.0246792dd8128p+3, -0x1.a9adae4263e84p-51, 0x1.ec11a4105865fp+1, 0x1.04787f005f61bp+0, 0x1.3df7662b21243p-3,
     0x1.815cceb2f2f3fp-6, 0x1.e75fcb6757a14p-11, 0x1.51354f26e6ba8p-11, -0x1.bd4a2309f5927p-13, 0x1.096e9b126b4dp-13,
     -0x1.5eceaeaa8b303p-14, 0x1.f927d1c63ac3dp-15}, /* [27] 3.375 <= y <= 3.5, 59.6 bits */
    {0x1.122bca980d0ffp+3, 0x1.1c4e1ca65d046p-51, 0x1.06ca9eb36640cp+2, 0x1.13f1f0a421b42p+0, 0x1.5665ac7b85ea8p-3,
     0x1.8d24f8c1962dap-6, 0x1.62f03df173e07p-10, 0x1.0706a4865f564p-11, -0x1.fcb137a3257fdp-14, 0x1.0e5f2bdba049bp-14,
     -0x1.2684ac447e468p-15, 0x1.7c5539c547768p-16}, /* [28] 3.5 <= y <= 3.625, 58.5 bits */
    {0x1.232526c744d86p+3, 0x1.9269d625454b3p-52, 0x1.188d45766089dp+2, 0x1.24957be3af4f2p+0, 0x1.6fb0afb4a6e4cp-3,
     0x1.9cd0e109efe8p-6, 0x1.bcbf108f46e29p-10, 0x1.b757fe0e12c33p-12, -0x1.2f1a8f7296d9fp-14, 0x1.35af19cdbc7f2p-15,
     -0x1.1ab54aa9f5473p-16, 0x1.2d52c44403a04p-17}, /* [29] 3.625 <= y <= 3.75, 58.5 bits */
    {0x1.3543324126543p+3, -0x1.a020a0256662fp-52, 0x1.2b63c2186f1cp+2, 0x1.366ed76a68968p+0, 0x1.8a11031fe1245p-3,
     0x1.afb9e8cf30396p-6, 0x1.04ec4ed8e3bf9p-9, 0x1.837f713faabbap-12, -0x1.694094c4874cbp-15, 0x1.80781889d75ccp-16,
     -0x1.310bb8dc31eafp-17, 0x1.188e423373f5fp-18}, /* [30] 3.75 <= y <= 3.875, 60.3 bits */
    {0x1.4897c78f94a55p+3, 0x1.5a2bc63175161p-51, 0x1.3f61dfdcd0deep+2, 0x1.498c2bddcbdbfp+0, 0x1.a5b71a5ccae67p-3,
     0x1.c57ccfcfa95a9p-6, 0x1.27b1d0e33ab8dp-9, 0x1.65228db79572ap-12, -0x1.99aef1511cdedp-16, 0x1.fa136b7d2eda4p-17,
     -0x1.621316afe0c9cp-18, 0x1.24aa8b3dc7db7p-19}, /* [31] 3.875 <= y <= 4, 58.7 bits */
    {0x1.5d36056313215p+3, -0x1.a961fb3872899p-51, 0x1.549c5e0d74837p+2, 0x1.5dfdc7d4faea9p+0, 0x1.c2ce97673fdffp-3,
     0x1.dddf84e52f64p-6, 0x1.4852a040d78cap-9, 0x1.54d8fda426325p-12, -0x1.8ddc10b87ef76p-17, 0x1.5dca07d36f45cp-17,
     -0x1.af93a0ad50b6ap-19, 0x1.4873d9b047ce3p-20}, /* [32] 4 <= y <= 4.125, 58.9 bits */
    {0x1.73325eddb3eb4p+3, 0x1.923dcc9de53ffp-51, 0x1.6b2910d56b198p+2, 0x1.73d5f36adb586p+0, 0x1.e180604070413p-3,
     0x1.f8c2d188b505bp-6, 0x1.67e7a769bc59ap-9, 0x1.4e41fa3f78a45p-12, -0x1.90ec4e8ffc7dap-19, 0x1.f9c0e18f6409fp-18,
     -0x1.1065f9e5f9ea1p-19, 0x1.84d1c5a04ba54p-21}, /* [33] 4.125 <= y <= 4.25, 60.1 bits */
    {0x1.8aa2add93b0adp+3, -0x1.a8bdb1fc9accep-51, 0x1.831f00037ea4cp+2, 0x1.8b28d8508c0c4p+0, 0x1.00fa01d204d09p-2,
     0x1.0b0cf7db92cep-5, 0x1.8736b080dd6cbp-9, 0x1.4ea934a2d22b6p-12, 0x1.ddc092e42138ep-19, 0x1.7de11c73a893ap-18,
     -0x1.608c62f3e6b1dp-20, 0x1.e028c6b108419p-22}, /* [34] 4.25 <= y <= 4.375, 59.4 bits */
    {0x1.a39e47100072ep+3, 0x1.50b1887fd0a96p-51, 0x1.9c9684c4c6df2p+2, 0x1.a40c77e7157fcp+0, 0x1.122859b8b83f8p-2,
     0x1.1af2ae627f0c9p-5, 0x1.a6d16145c494fp-9, 0x1.545568bf3b63ap-12, 0x1.20c32ceab728p-17, 0x1.2d0bfe02579b2p-18,
     -0x1.cfb02d5eec3b4p-21, 0x1.331e76b13bbb1p-22} /* [35] 4.375 <= y <= 4.5, 58.8 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_duration_1)

/* duration, a = 3/2: 36 rows of degree 10 in y = ln(1 + beta), nodes 0.0625 + i 0.125, y < 4.5.
 * Relative error of the approximation: 2^-58.0 at most, sampled at 25 places of each row. */
#define COR_ROWS_CROSSLEY_DURATION_3_2_FIRST 0.0625
#define COR_ROWS_CROSSLEY_DURATION_3_2_STEP 0.125
#define COR_ROWS_CROSSLEY_DURATION_3_2_PER_UNIT 8.0
#define COR_ROWS_CROSSLEY_DURATION_3_2_ROWS 36
#define COR_ROWS_CROSSLEY_DURATION_3_2_END 4.5
COR_ROWS(double, cor_rows_crossley_duration_3_2, 36, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.9db7b5aea1917p+1, 0x1.6335136d95c22p-59, 0x1.e5695507a422bp-3, 0x1.7c89cd2ec57cp-3, 0x1.0ba346e200979p-4,
     0x1.4773d335ed567p-6, 0x1.5c3cd2cacfe2dp-8, 0x1.0cac8a18decfcp-10, 0x1.98f9812f82126p-17, -0x1.dc8283b06d4cep-14,
     -0x1.27c1b09516c0ap-14, -0x1.df77496cfce8p-16}, /* [0] 0 <= y <= 0.125, 62.3 bits */
    {0x1.a1e603ac33dc2p+1, -0x1.67e7225215821p-54, 0x1.25937c5a4ae4cp-2, 0x1.b2c726765ea77p-3, 0x1.3822359ef3088p-4,
     0x1.81c6f83fd23e7p-6, 0x1.8de782c42ce56p-8, 0x1.fdfdb65c7a99p-11, -0x1.3743b1cb97946p-13, -0x1.c45c4dd136e93p-13,
     -0x1.dcd40d94e79b4p-14, -0x1.55040220a60a7p-15}, /* [1] 0.125 <= y <= 0.25, 61.5 bits */
    {0x1.a6ee15bea1264p+1, -0x1.2e2188476e785p-53, 0x1.5fc6fdaafdd43p-2, 0x1.f212df946be44p-3, 0x1.6c63ed6e7ac21p-4,
     0x1.c373627fdf895p-6, 0x1.b8ba47e775342p-8, 0x1.7d7f4a7d2a2bcp-11, -0x1.cb86a85c2dcf2p-12, -0x1.88fbefc0448c7p-12,
     -0x1.6769e0fb9b602p-13, -0x1.a8f2dc034453fp-15}, /* [2] 0.25 <= y <= 0.375, 61.5 bits */
    {0x1.acefa22984a39p+1, 0x1.00d3403e39351p-53, 0x1.a28922c8bcadep-2, 0x1.1dfb06c3f7395p-2, 0x1.a93950b8b63a7p-4,
     0x1.05402c66ab133p-5, 0x1.d002ed3e78ec6p-8, 0x1.397abdbb8c312p-13, -0x1.e31a3040bcbb1p-11, -0x1.3c771784534b5p-11,
     -0x1.ebf02afd529bp-13, -0x1.8576c5f3d8002p-15}, /* [3] 0.375 <= y <= 0.5, 61.0 bits */
    {0x1.b40fac3d8da5fp+1, 0x1.474fb938d2202p-54, 0x1.ef47248060eeep-2, 0x1.490c5f9562942p-2, 0x1.ef0e1732ba0ecp-4,
     0x1.292e2d55b73f5p-5, 0x1.beb8ff6c930a9p-8, -0x1.f81925958170ap-11, -0x1.b4d3b2d260d3fp-10, -0x1.d44fb08e24c3ap-11,
     -0x1.1b51c42cda2afp-12, -0x1.c1b64ac509e6bp-23}, /* [4] 0.5 <= y <= 0.625, 61.3 bits */
    {0x1.bc7957384762ap+1, 0x1.d0036428bbeddp-53, 0x1.23d1e8c9eba7fp-1, 0x1.7b12e811194c1p-2, 0x1.1ebf37f7c174ep-3,
     0x1.492af91a2b6b3p-5, 0x1.64b06f47f3f73p-8, -0x1.760d5693ec63cp-9, -0x1.62b068f8e64bdp-9, -0x1.337da7f21d35ep-10,
     -0x1.9bca523763bf1p-13, 0x1.23f1aa1a88157p-13}, /* [5] 0.625 <= y <= 0.75, 61.9 bits */
    {0x1.c65eb98180603p+1, -0x1.bf7b8cb745043p-53, 0x1.56ba73a4cbb1ap-1, 0x1.b4cae6ed7887fp-2, 0x1.495acdc288fecp-3,
     0x1.5ddec61c23fb5p-5, 0x1.2b05b7ff1c995p-9, -0x1.79561f279a707p-8, -0x1.0272e8cc0a9dfp-8, -0x1.44c94c3a20b7p-10,
     0x1.31e7b3d9ad179p-13, 0x1.cd6356837e568p-12}, /* [6] 0.75 <= y <= 0.875, 62.0 bits */
    {0x1.d1f99542639dbp+1, 0x1.cbe7f8bac37adp-54, 0x1.915bd326092ddp-1, 0x1.f6aafece430c5p-2, 0x1.7548e214d25aap-3,
     0x1.5c1f350b40cfp-5, -0x1.c5427069c6832p-9, -0x1.3dd96b2cf64e2p-7, -0x1.45f246ac7217ap-8, -0x1.5c6e75b2ea775p-11,
     0x1.01e1480aac8b8p-10, 0x1.e4ef7833534cp-11}, /* [7] 0.875 <= y <= 1, 60.4 bits */
    {0x1.df8bc9729853p+1, 0x1.ff0738a2574b9p-55, 0x1.d4bbc3c9b8629p-1, 0x1.2050947f22903p-1, 0x1.9ed428945b06p-3,
     0x1.34f3a216cf8a9p-5, -0x1.9650d5b849c7cp-7, -0x1.cef9ef08485b7p-7, -0x1.3d2171107f20ap-8, 0x1.3d6bc2b574b33p-10,
     0x1.41c209933ef39p-9, 0x1.6aa786b35d03ap-10}, /* [8] 1 <= y <= 1.125, 63.5 bits */
    {0x1.ef5f385e70263p+1, 0x1.4db6e1bf2a9p-53, 0x1.10e85680c2c9p+0, 0x1.48dcfd185d721p-1, 0x1.c04552d0bc8efp-3,
     0x1.afc45c4bb49bfp-6, -0x1.8f3470ea47c42p-6, -0x1.1c6760d1550bp-6, -0x1.f7081497df162p-10, 0x1.4463812d3f845p-8,
     0x1.0e5a9db02a97ap-8, 0x1.165625ece668cp-10}, /* [9] 1.125 <= y <= 1.25, 59.1 bits */
    {0x1.00e2660d36ef1p+2, 0x1.9cf8090de728cp-54, 0x1.3cafb36cd1e78p+0, 0x1.73e085d87d9e3p-1, 0x1.d20ea062f5ca9p-3,
     0x1.cc76285ff5ff2p-8, -0x1.31e21855c694ap-5, -0x1.08ad96df1bc1p-6, 0x1.69522ff44c4f9p-8, 0x1.45fbb8fa8bc4ep-7,
     0x1.151e9fa089058p-8, -0x1.5fd73f2f4c444p-10}, /* [10] 1.25 <= y <= 1.375, 59.4 bits */
    {0x1.0b891e51ae0aap+2, -0x1.562c6d02cef4dp-55, 0x1.6de747d388937p+0, 0x1.9f817fcc3b604p-1, 0x1.cc2510d7557c9p-3,
     -0x1.4011bf02ca021p-6, -0x1.7c75aab315017p-5, -0x1.a2e3ec26b2dep-8, 0x1.1b49735c75cd6p-6, 0x1.a22f8c5c0d9c6p-7,
     -0x1.4d55ada34a185p-12, -0x1.95d215615cd2fp-8}, /* [11] 1.375 <= y <= 1.5, 62.8 bits */
    {0x1.17cf2fe0fc082p+2, -0x1.10fd1b0964507p-52, 0x1.a47bec9ccc4fdp+0, 0x1.c93c96a825587p-1, 0x1.a91d19b3ba2f3p-3,
     -0x1.8eadd8cd48d26p-5, -0x1.6a55499cc7ceap-5, 0x1.c7ae318c53419p-7, 0x1.cd5c850b92a0fp-6, 0x1.caf20687759fap-8,
     -0x1.5e18b318e8d94p-7, -0x1.368a68ce3b737p-7}, /* [12] 1.5 <= y <= 1.625, 59.2 bits */
    {0x1.25de1ace48282p+2, 0x1.ad78e7e4163eep-53, 0x1.e004ee1292cadp+0, 0x1.ee592e154db64p-1, 0x1.6abf31011988ep-3,
     -0x1.230ae636918dbp-4, -0x1.8c65a2d272426p-6, 0x1.42b1720f92972p-5, 0x1.bba2cf864a7e9p-6, -0x1.6601e87f02636p-7,
     -0x1.426d18569c086p-6, -0x1.5b778c321af7dp-9}, /* [13] 1.625 <= y <= 1.75, 59.9 bits */
    {0x1.35dacea58095bp+2, -0x1.4bb89b4c305cfp-53, 0x1.0fe53302ff1b4p+1, 0x1.066483110de2ep+0, 0x1.1dd162e4097ddp-3,
     -0x1.34a905c0885c2p-4, 0x1.974c9e082ca32p-7, 0x1.c33a79dcbb01p-5, 0x1.5d3884933d1a1p-8, -0x1.ffd2424b4e37ep-6,
     -0x1.980583461332ap-7, 0x1.e84ffeefb7176p-7}, /* [14] 1.75 <= y <= 1.875, 58.9 bits */
    {0x1.47e3b2ed9ab0ap+2, -0x1.d806c7a51ddb8p-53, 0x1.3175a9e7b1092p+1, 0x1.121875d329d0ep+0, 0x1.b20776028482cp-4,
     -0x1.c198751d77643p-5, 0x1.a884a94c93957p-5, 0x1.7021419618e7p-5, -0x1.d4dead1006c8p-6, -0x1.034cc35701e55p-5,
     0x1.bc2e5af9c649p-7, 0x1.75c178a95401ap-6}, /* [15] 1.875 <= y <= 2, 62.3 bits */
    {0x1.5c1059275d84bp+2, -0x1.7949b7d17e36fp-52, 0x1.544fbefd96457p+1, 0x1.1b3f266f5e122p+0, 0x1.68c919aef9c4ap-4,
     -0x1.d783b40797bdbp-7, 0x1.2c0c4ec7d4eaap-4, 0x1.323a2d3d05e58p-7, -0x1.88b0c145da6c3p-5, -0x1.b49e2baad5a51p-9,
     0x1.08f5bac93c63p-5, 0x1.a242d7c6fabf1p-9}, /* [16] 2 <= y <= 2.125, 58.5 bits */
    {0x1.72736081e6d6ep+2, 0x1.3f764bf3b552cp-53, 0x1.783e31f49b56p+1, 0x1.23b9765a47f64p+0, 0x1.7a090091a94dap-4,
     0x1.f1aa1b019109dp-6, 0x1.0ae2740af97b6p-4, -0x1.d8c285748bdeep-6, -0x1.15f0d1c3f82a9p-5, 0x1.d6efa5ebdf9b3p-6,
     0x1.358640310dfaap-6, -0x1.6bbc8ac3a217ap-6}, /* [17] 2.125 <= y <= 2.25, 58.5 bits */
    {0x1.8b1e1815a967cp+2, -0x1.0750e8df77f82p-52, 0x1.9d4d531069a37p+1, 0x1.2d9b913093c9fp+0, 0x1.dc5c379dd8874p-4,
     0x1.00404f6aef1dbp-4, 0x1.265068bb2f908p-5, -0x1.692d5298b94b1p-5, -0x1.a2d759cb09127p-13, 0x1.0dfa5a1e71efap-5,
     -0x1.652f56e7d1d78p-7, -0x1.497057c4435bdp-6}, /* [18] 2.25 <= y <= 2.375, 61.1 bits */
    {0x1.a6248586f52bcp+2, 0x1.0743786a5d391p-55, 0x1.c3c498ef3d575p+1, 0x1.3a69b79f0be3fp+0, 0x1.3650a2816c8dcp-3,
     0x1.33eb55b23b52bp-4, 0x1.84a47341bbadbp-8, -0x1.0a1d566142f7ep-5, 0x1.7906c691653d8p-6, 0x1.6fe3c0ac39ae7p-7,
     -0x1.74aed6c573607p-6, 0x1.ca0adf40f8e73p-10}, /* [19] 2.375 <= y <= 2.5, 60.5 bits */
    {0x1.c3a05f547d4ccp+2, 0x1.5409c9716cb4dp-54, 0x1.ec0ddb505e2f5p+1, 0x1.4ac430b9ace12p+0, 0x1.83056b66de5e4p-3,
     0x1.2acc83c59a558p-4, -0x1.52321de2b7f8dp-7, -0x1.659fa09631cafp-7, 0x1.75d1df5bf0704p-6, -0x1.3279c8202ff5ep-7,
     -0x1.6fb3761352ca2p-7, 0x1.b7be2055fe843p-7}, /* [20] 2.5 <= y <= 2.625, 58.9 bits */
    {0x1.e3b2568f271dcp+2, -0x1.bd66bddab21bp-53, 0x1.0b4d6e4918441p+2, 0x1.5e99b1f5c6cf8p+0, 0x1.c9e7e5793b464p-3,
     0x1.0b803e5ee3938p-4, -0x1.92942cc7cd053p-7, 0x1.f12b0dd2e4683p-9, 0x1.4e0effbb3d294p-7, -0x1.ae43be69eee94p-7,
     0x1.9f7f0d55704bbp-9, 0x1.f796d4ba3337cp-8}, /* [21] 2.625 <= y <= 2.75, 58.0 bits */
    {0x1.03410385a2037p+3, -0x1.9f00882dd65c2p-55, 0x1.21eae153f8547p+2, 0x1.759357a697605p+0, 0x1.04a4eb001e0d2p-2,
     0x1.e36535803a815p-5, -0x1.e40f3153d2ab3p-8, 0x1.fe995938ba2f4p-8, 0x1.ab98d2e28c9cdp-14, -0x1.a346090248a7dp-8,
     0x1.bda9b0afcffa5p-8, -0x1.2ca769c628853p-10}, /* [22] 2.75 <= y <= 2.875, 58.8 bits */
    {0x1.161eaba77e3a4p+3, 0x1.9cbea24a964ddp-52, 0x1.3a0f002a9934p+2, 0x1.8f65bb80311b6p+0, 0x1.21fa65a829b93p-2,
     0x1.cbe6d567a2f82p-5, -0x1.07f6226372eedp-9, 0x1.8f865858b93a6p-8, -0x1.8639a81d86b41p-9, -0x1.dc41def0b2e36p-12,
     0x1.afcf5948603fep-9, -0x1.b40338e897d88p-9}, /* [23] 2.875 <= y <= 3, 60.5 bits */
    {0x1.2a8bf31aa56abp+3, -0x1.5a57488460e18p-51, 0x1.53e601538fe17p+2, 0x1.abece4c918be5p+0, 0x1.3e9e1e3c8804bp-2,
     0x1.cba5c8a807c49p-5, 0x1.a5c6b36719961p-10, 0x1.e1b3c85599cbdp-9, -0x1.2a93beacb6653p-9, 0x1.4c795a4f6331fp-10,
     0x1.b7ee935e6b35ap-13, -0x1.7380d752ab07p-10}, /* [24] 3 <= y <= 3.125, 62.5 bits */
    {0x1.40a560f670d19p+3, -0x1.7a352437f22bep-54, 0x1.6f9affa14672dp+2, 0x1.cb274ec264e39p+0, 0x1.5bbb7acb6d3e5p-2,
     0x1.d9d79c356c3bdp-5, 0x1.ec10bbd325a01p-9, 0x1.226fdac5e5e08p-9, -0x1.26363c59349dcp-10, 0x1.de77afb15d783p-11,
     -0x1.14667974c8c5fp-11, -0x1.7855017a68c52p-18}, /* [25] 3.125 <= y <= 3.25, 58.7 bits */
    {0x1.588a31651495fp+3, -0x1.e0c3e1bce37cp-51, 0x1.8d59bd5787181p+2, 0x1.ed298fb3d9719p+0, 0x1.7a07446e59c8bp-2,
     0x1.f0cd0d50372ccp-5, 0x1.5052ff383d0bdp-8, 0x1.9688ac086dfe1p-10, -0x1.f9cd85c396c9cp-12, 0x1.ad7af8286588ep-12,
     -0x1.51eaacb3d5915p-12, 0x1.bc07d102bd402p-13}, /* [26] 3.25 <= y <= 3.375, 59.7 bits */
    {0x1.725c69836ec42p+3, 0x1.73e6461d685c9p-51, 0x1.ad4fba655cb8cp+2, 0x1.090ae222fc43fp+1, 0x1.99f53eb1101f2p-2,
     0x1.06ea86f0b896ep-4, 0x1.949018e5f6139p-8, 0x1.4b9fb1436a28bp-10, -0x1.b7f22b79c5018p-13, 0x1.6a66f771b2941p-13,
     -0x1.04de642123b01p-13, 0x1.a6ad89b052028p-14}, /* [27] 3.375 <= y <= 3.5, 58.8 bits */
    {0x1.8e40f925e2015p+3, -0x1.29351d9e7f46ep-51, 0x1.cface67b9349ep+2, 0x1.1d0baa4053987p+1, 0x1.bbdbf70f159f4p-2,
     0x1.17e2afe569abfp-4, 0x1.cf436db2b456dp-8, 0x1.2b1c9fa0431c6p-10, -0x1.71b1c848b4b8cp-14, 0x1.62c3024ce16b2p-14,
     -0x1.8c94f523909dcp-15, 0x1.1a421d062a2a7p-15}, /* [28] 3.5 <= y <= 3.625, 58.6 bits */
    {0x1.ac5fe61a2fb67p+3, 0x1.473cfd457b753p-51, 0x1.f4a424e1cda9ap+2, 0x1.32b08ca769f18p+1, 0x1.e0055c908e46bp-2,
     0x1.2b0ec54b44dbep-4, 0x1.02fd13cb47548p-7, 0x1.1ef0ac6bce9fp-10, -0x1.90ca0101c2307p-16, 0x1.985ee8337e75cp-15,
     -0x1.63b541fa1dee9p-16, 0x1.9b460b51dcf19p-17}, /* [29] 3.625 <= y <= 3.75, 63.3 bits */
    {0x1.cce47eeffa22p+3, 0x1.57efc9cc44fb1p-52, 0x1.0e35de20490b1p+3, 0x1.4a16488d5334ep+1, 0x1.035b0f3927597p-1,
     0x1.4056a1f4bed8fp-4, 0x1.1dc9c9041c29cp-7, 0x1.1e463b1fe3557p-10, 0x1.ff86cc50992dbp-17, 0x1.082c203f62f97p-15,
     -0x1.6be88a3db0e1p-17, 0x1.6d7d8e3acce7dp-18}, /* [30] 3.75 <= y <= 3.875, 58.8 bits */
    {0x1.effd9471014e8p+3, 0x1.f5f4db65dbbf8p-51, 0x1.239edf0e76afep+3, 0x1.635cc98d23fecp+1, 0x1.1818b4e72c24ep-1,
     0x1.57b8659a6c70ap-4, 0x1.38e4bec6a166dp-7, 0x1.24fb34bfe23dap-10, 0x1.5e0806a8d6472p-15, 0x1.777be00591d1p-16,
     -0x1.8ed2f1a17fdaep-18, 0x1.727913a9674dcp-19}, /* [31] 3.875 <= y <= 4, 58.5 bits */
    {0x1.0aeedcbbe83a4p+4, 0x1.80e992ec18e13p-51, 0x1.3aac35f0ee4c2p+3, 0x1.7ea723da89567p+1, 0x1.2e5d9050570fap-1,
     0x1.71404ecca4bdbp-4, 0x1.54e2507c040d3p-7, 0x1.30e5a2bfe013cp-10, 0x1.013af69e7eec6p-14, 0x1.22493d88abf11p-16,
     -0x1.c2c920fa2f065p-19, 0x1.97eee722c46fap-20}, /* [32] 4 <= y <= 4.125, 62.9 bits */
    {0x1.1f5dc48d961fdp+4, -0x1.de64d35d63f3cp-50, 0x1.537f4e70fca67p+3, 0x1.9c1ba61be8493p+1, 0x1.464ca9b69c3e4p-1,
     0x1.8d0485f83f982p-4, 0x1.722fbfde2346cp-7, 0x1.40d2a3a88e5acp-10, 0x1.4332d3cb0686dp-14, 0x1.e4116a89db44ap-17,
     -0x1.fc3c94eb788e4p-20, 0x1.de4644a698773p-21}, /* [33] 4.125 <= y <= 4.25, 58.1 bits */
    {0x1.3568f9a872703p+4, -0x1.d7eba2e78853dp-53, 0x1.6e3c13c948374p+3, 0x1.bbe3fa5e3ad5ep+1, 0x1.600aaaf233b22p-1,
     0x1.ab22ccd5f8452p-4, 0x1.912465b99e76ap-7, 0x1.5414f279a51b2p-10, 0x1.7c060e411f5adp-14, 0x1.aea400bafe68bp-17,
     -0x1.0fcb2c3f034f7p-20, 0x1.27ebebf7b2924p-21}, /* [34] 4.25 <= y <= 4.375, 58.7 bits */
    {0x1.4d304824aedbp+4, -0x1.a3d0f40d11c8bp-52, 0x1.8b0927d247dedp+3, 0x1.de2d528e9c0a6p+1, 0x1.7bbe4d9c2e96bp-1,
     0x1.cbbf30f8131bdp-4, 0x1.b20b4c990368p-7, 0x1.6a4cb283e7807p-10, 0x1.aff4830f81ea7p-14, 0x1.93c144bf5d5cp-17,
     -0x1.e810ab591b592p-22, 0x1.814775cd8344cp-22} /* [35] 4.375 <= y <= 4.5, 58.7 bits */
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_duration_3_2)

/* s = ln(1 + beta) >= 26.25: the time of the largest overlap is beta^(2k-1) ((a+1) (1+beta))^-k
 * (s + K + K' + (k_0 + k_1 s + k_2 s^2)/(1 + beta)), k = a/(a+1): columns K, K', k_0, k_1, k_2. K exact, k_j through
 * three enclosed values. */
COR_INLINE const double *cor_rows_crossley_far_time_of_max_overlap_1(int i)
{
    static const double row[1][5] = {
    {0x1.62e42fefa39efp+0, 0x1.abc9e3b39803fp-55, 0x1.3a726ebf1de42p+0, -0x1.e267f49dae196p-27, 0x1.00000003cd4e6p-2}
     /* a = 1 */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_crossley_far_time_of_max_overlap_3_2(int i)
{
    static const double row[1][5] = {
    {0x1.fbf27ddffb61p+0, 0x1.8da1972e97723p-55, 0x1.e468676c0183cp+0, -0x1.34c8e50763727p-26, 0x1.3333333811369p-2}
     /* a = 3/2 */
    };
    return row[i];
}

/* s >= 4.5: the rebound takes beta^(2k-1) (a+1)^-k ((a+1) U^(1-k) + U^-k (c_1/U + ... + c_11/U^11)),
 * U = 1 + beta - ln(1 + beta). Exact coefficients. */
COR_INLINE const double *cor_rows_crossley_far_rebound_1(int i)
{
    static const double row[1][11] = {
    {0x1p-1, 0x1.ep-1, 0x1.1b55555555555p+1, 0x1.ca671c71c71c7p+2, 0x1.ec33444444444p+4, 0x1.4afb98c3b2a19p+7,
     0x1.0a41bcc9894d8p+10, 0x1.f0f57866f16ecp+12, 0x1.07712aebffacbp+16, 0x1.388356a048ba6p+19, 0x1.99f71b6c5477cp+22}
     /* a = 1 */
    };
    return row[i];
}
COR_INLINE const double *cor_rows_crossley_far_rebound_3_2(int i)
{
    static const double row[1][11] = {
    {0x1.3333333333333p-1, 0x1.3333333333333p+0, 0x1.792c5f92c5f93p+1, 0x1.39d495182a993p+3, 0x1.5874f95f8b394p+5,
     0x1.d7afdae5bd4e6p+7, 0x1.8148695cc5b2ep+10, 0x1.6c5a3ec6b96bep+13, 0x1.86d6573fd0c9fp+16, 0x1.d484b412761fep+19,
     0x1.363c66b5a46b6p+23} /* a = 3/2 */
    };
    return row[i];
}

#endif
