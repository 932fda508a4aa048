/* SPDX-License-Identifier: MIT */
/* eps and beta or zeta of eps for the linear dashpot, Tsuji's damping and Hunt and Crossley's law: rows of short
 * polynomials around the nodes of uniform grids and by octaves. Evaluated by runtime/law/closed_form.h. Source:
 * docs/laws.md; form: docs/internals.md.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check
 *
 * The rows interpolate enclosures to 200 bits. Errors of the rows are above each table (sampled); errors of
 * evaluation: include/cor/law.h (sampled). */
#ifndef COR_GENERATED_CLOSED_FORM_TABLES_H
#define COR_GENERATED_CLOSED_FORM_TABLES_H
#include "runtime/table/rows.h"

/* linear and Tsuji, zero overlap: (1 - eps)/zeta: 5 rows of degree 10 in y = zeta, nodes 0 + i 0.0625, 0 <= y <= 0.28125.
 * Relative error of the approximation: 2^-58.1 at most, sampled at 25 places of each row. Bits of the rows:
 * 58.1 58.2 58.2 58.6 60.1 */
#define COR_ROWS_RATIO_LOSS_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_RATIO_LOSS_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_RATIO_LOSS_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_RATIO_LOSS_ZERO_OVERLAP_ROWS 5
#define COR_ROWS_RATIO_LOSS_ZERO_OVERLAP_END 0.25
COR_ROWS(double, cor_rows_ratio_loss_zero_overlap, 5, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.921fb58p+1,-0x1.dde973dcb3b3ap-26,-0x1.3bd3cc9be45dep+2,0x1.af43bbb36c998p+2,-0x1.1fcade8eccf73p+3,
    0x1.6f5ac565eba4ep+3,-0x1.cc664fba08b18p+3,0x1.1a558601d72dcp+4,-0x1.55a0d0c6397c1p+4,0x1.97c8a9071aab5p+4,
    -0x1.dc6b803718696p+4,0x1.d85d2dc9fb365p+4},{0x1.6dc123p+1,-0x1.474b78d9dc634p-28,-0x1.0c02dfe55db3bp+2,
    0x1.528c370c18dbcp+2,-0x1.a7036e7e5bcd3p+2,0x1.f6fdbffb8984p+2,-0x1.272847aa21d09p+3,0x1.52522de603032p+3,
    -0x1.7f71f7d0b05a1p+3,0x1.acb5d38ae9815p+3,-0x1.dc4c7a86b16bbp+3,0x1.0576068fae955p+4},{0x1.4eb4a8p+1,
    0x1.a80475e3cba1cp-27,-0x1.cc66823e20f42p+1,0x1.0db89fa81ead6p+2,-0x1.3d6392a49f663p+2,0x1.606ce0cf3af09p+2,
    -0x1.855d320ec1473p+2,0x1.a2545bf3524a1p+2,-0x1.be1bc3b068f56p+2,0x1.d4930c894490dp+2,-0x1.e97d9a134c97ep+2,
    0x1.f9a304c29aa29p+2},{0x1.33e498p+1,0x1.05246a60fff88p-30,-0x1.8fc68be939357p+1,0x1.b3371fc6784afp+1,
    -0x1.e5547ac6cd84cp+1,0x1.f7cad0e7e5f49p+1,-0x1.0782662b6ab71p+2,0x1.09cf1754c3eb7p+2,-0x1.0bf47876a9592p+2,
    0x1.0931edeb62cd8p+2,-0x1.05438ce210a9bp+2,0x1.fe5933f374ddbp+1},{0x1.1c7eeap+1,-0x1.5d7d1b807f00ep-27,
    -0x1.5e9b4418888f3p+1,0x1.62d9434ae88b5p+1,-0x1.79a2129ac33dap+1,0x1.6e2dc3059239p+1,-0x1.6d43a3824f0c1p+1,
    0x1.59ea7c410796bp+1,-0x1.4b436b9507f41p+1,0x1.35fa10a4729fap+1,-0x1.1fd3dea529168p+1,0x1.0cdb0bbe0e718p+1}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_loss_zero_overlap)

/* linear and Tsuji, zero overlap: eps: 24 rows of degree 10 in y = zeta 2^-k, 16 rows in each octave k = -2 ... -1.
 * Relative error of the approximation: 2^-56.2 at most, sampled at 25 places of each row. Bits of the rows:
 * 60.3 63.3 63.9 58.7 60.4 59.4 58.9 58.3 59.5 58.7 60.5 59.4 59.6 58.9 58.6 59.4 57.5 58.0 57.9 57.1 61.3 56.7 56.3
 * 56.2 */
#define COR_ROWS_RATIO_EPS_ZERO_OVERLAP_FIRST 0.25
#define COR_ROWS_RATIO_EPS_ZERO_OVERLAP_FIRST_OCTAVE (-2)
#define COR_ROWS_RATIO_EPS_ZERO_OVERLAP_OCTAVE_BITS 4
#define COR_ROWS_RATIO_EPS_ZERO_OVERLAP_ROWS 24
#define COR_ROWS_RATIO_EPS_ZERO_OVERLAP_END 0.75
COR_ROWS(double, cor_rows_ratio_eps_zero_overlap, 24, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.bad526ada2f12p-2,-0x1.ffe46f1d08936p-56,-0x1.81992de43ffc4p-2,0x1.ffc998159c07fp-4,-0x1.f754a02515a34p-6,
    0x1.139a3cf4b3938p-7,-0x1.06200d76d0dcbp-9,0x1.08d23e2b566aap-11,-0x1.ef802fe9ae937p-14,0x1.db395e9174229p-16,
    -0x1.bb5a448369796p-18,0x1.960824a0e3d38p-20},{0x1.a339975d549a2p-2,0x1.dadaa47d95de9p-56,-0x1.71f723d98e62ap-2,
    0x1.e8fb540a90c7p-4,-0x1.d61eea8883103p-6,0x1.000fc87f86e84p-7,-0x1.dd09de7c4361cp-10,0x1.de8f00cc7a6aep-12,
    -0x1.b7d0b8e8ae6b6p-14,0x1.a11d380183906p-16,-0x1.80cb30d179901p-18,0x1.591f8707e3969p-20},{0x1.8c9295b8f7682p-2,
    -0x1.9f58191dab8cdp-57,-0x1.6305780ab39cbp-2,0x1.d3ad5fc6bb481p-4,-0x1.b73df994e7e1fp-6,0x1.dc8cd8759515ap-8,
    -0x1.b257a0f5fcd15p-10,0x1.b12fa227ef94fp-12,-0x1.86e7e6b42f8d3p-14,0x1.6e9a4471b5f0cp-16,-0x1.4f0a9d05b79bbp-18,
    0x1.25025d86eda7bp-20},{0x1.76d579a9bcfabp-2,-0x1.b0d4524d41129p-56,-0x1.54b894723319dp-2,0x1.bfc507edd67c8p-4,
    -0x1.9a7c611ba835bp-6,0x1.bc2721d692aaep-8,-0x1.8ba8ce30c2dap-10,0x1.88d54080971f5p-12,-0x1.5be567f4e2398p-14,
    0x1.428aa2c988eeap-16,-0x1.24db11713c13dp-18,0x1.f00813bb73165p-21},{0x1.61f84e0076fbep-2,-0x1.2f0eb4092da25p-57,
    -0x1.4705aef3e5813p-2,0x1.ad29fb7bb96a8p-4,-0x1.7fa9bad0e3c59p-6,0x1.9ea2ab8dc2cb1p-8,-0x1.688c56121691dp-10,
    0x1.64e55b3ddf19p-12,-0x1.360b0db68af1ep-14,0x1.1bf0981471f9ep-16,-0x1.013d7589a22c2p-18,0x1.a15fc15730fbp-21},
    {0x1.4df1c44ab6b1cp-2,0x1.75e2983632d16p-57,-0x1.39e2b73230f68p-2,0x1.9bc612e1096f5p-4,-0x1.669a18c3497bcp-6,
    0x1.83bbfead01ab7p-8,-0x1.489eb8587440fp-10,0x1.44d896a48af21p-12,-0x1.14b84ce5394c5p-14,0x1.f3dcaf76ac43ep-17,
    -0x1.c6d3567d92803p-19,0x1.5b703c8f42122p-21},{0x1.3ab929bce955ep-2,0x1.83850e8c6fabfp-57,-0x1.2d464610eb0c1p-2,
    0x1.8b851d5a27dbfp-4,-0x1.4f2588cfd7504p-6,0x1.6b36f0a6de485p-8,-0x1.2b885e691fb9ap-10,0x1.2837b1664a616p-12,
    -0x1.eecd70307c7afp-15,0x1.b77d4dde8c836p-17,-0x1.959381348ff8p-19,0x1.1bcb4c2b59f4ep-21},{0x1.28465d1814b5ep-2,
    -0x1.05cd2ca4599adp-58,-0x1.21278eb71f4a9p-2,0x1.7c54b3c14b867p-4,-0x1.3927a700d0ccbp-6,0x1.54ddc3482b78dp-8,
    -0x1.10fc39dd47783p-10,0x1.0e98d054b2bfdp-12,-0x1.bb4eb80ded19p-15,0x1.815bfeb059695p-17,-0x1.6def5d581e726p-19,
    0x1.c01d97139127cp-22},{0x1.1691c57496285p-2,-0x1.5839d0e92072cp-57,-0x1.157e50e690196p-2,0x1.6e2410337043dp-4,
    -0x1.247f3d1d63d12p-6,0x1.40805ddabc206p-8,-0x1.f16d41bdf448cp-11,0x1.ef3a102b5a6e8p-13,-0x1.8e41e920c5c2bp-15,
    0x1.5027a601f13e8p-17,-0x1.4f7b9b9c99ad1p-19,0x1.4b8028c3fa175p-22},{0x1.059449ddb0158p-2,-0x1.f04fa0dc50f36p-56,
    -0x1.0a42cc84bc7efp-2,0x1.60e3e9f2ac635p-4,-0x1.110dedfcf2528p-6,0x1.2df39acfcc106p-8,-0x1.c4f8c7432f051p-11,
    0x1.c5dc1a51fb06cp-13,-0x1.671df905d736bp-15,0x1.229713c53051ep-17,-0x1.3a34c3d36b0b3p-19,0x1.a883166c1ec4ep-23},
    {0x1.ea8e9357a355dp-3,-0x1.dd4ba52ee326ep-57,-0x1.fedb6c6b4197cp-3,0x1.548654ffe681cp-4,-0x1.fd6fd6f12c2abp-7,
    0x1.1d10a59848672p-8,-0x1.9c3431055802fp-11,0x1.a077e325722a3p-13,-0x1.458350af6d29ep-15,0x1.eeb2fa2d73f74p-18,
    -0x1.2e8dd8b644d65p-19,0x1.4fc4d674afb59p-24},{0x1.cb492b1ac1045p-3,0x1.abc716f65d4a8p-58,-0x1.e9f059d8cb748p-3,
    0x1.48fea4f20a09bp-4,-0x1.dac76c340ca87p-7,0x1.0db4646a556f1p-8,-0x1.76c73d993d6d5p-11,0x1.7e75a9a4d03c8p-13,
    -0x1.293dda627135fp-15,0x1.9a08811b067e4p-18,-0x1.2d88ab8890181p-19,-0x1.eb18bb2a71eaap-25},{0x1.ad4cd25ed644dp-3,
    -0x1.7d09b78fbcd16p-57,-0x1.d5b760b3b5696p-3,0x1.3e415299c9045p-4,-0x1.b9f3cbd736274p-7,0x1.ff7dd33202c8ep-9,
    -0x1.5467b5b324df5p-11,0x1.5f40cc07e5f46p-13,-0x1.124996d184823p-15,0x1.43f8c572c080bp-18,-0x1.38db1b7f60eedp-19,
    -0x1.d3dec0e604b8ep-23},{0x1.908ecaf2238d5p-3,-0x1.4a152b4c762a1p-57,-0x1.c22430480d41ep-3,0x1.3443e406a2199p-4,
    -0x1.9ac9f82a75c94p-7,0x1.e625cf97e9f88p-9,-0x1.34d96359267e4p-11,0x1.424220ea59e5cp-13,-0x1.00da629bec336p-15,
    0x1.d16685ed16c5dp-19,-0x1.532608ff6627bp-19,-0x1.bf332fc9ca31p-22},{0x1.7505169b47195p-3,0x1.d70e4bf8e56e2p-57,
    -0x1.af2b17aad3bf1p-3,0x1.2afcd683ff89dp-4,-0x1.7d227a83875efp-7,0x1.cf2a4785950bbp-9,-0x1.17ee9c9ed660ap-11,
    0x1.26d93f48e245fp-13,-0x1.eacfcbc9ec845p-16,0x1.0700ad43550aep-19,-0x1.8044fe70feb36p-19,-0x1.67b78d3870cefp-21},
    {0x1.5aa66d94d44fcp-3,0x1.d3d4d21942929p-57,-0x1.9cc0f6ebb4831p-3,0x1.22638a235c984p-4,-0x1.60d92a4a8e6a4p-7,
    0x1.ba57ba9a0f2bep-9,-0x1.fb13031bb610ap-12,0x1.0c542e1e9b8a8p-13,-0x1.e17e3010b2f7fp-16,0x1.cb354a6bdbfb5p-23,
    -0x1.c5c0cb7bd504dp-19,-0x1.0cedeb4ceb25ap-20},{0x1.353682153c389p-3,-0x1.d6700944fc28ap-60,-0x1.8216c105779fap-2,
    0x1.16b27dad43685p-2,-0x1.38b470fdd223cp-4,0x1.9ebbc78e1e87bp-5,-0x1.b52ff761b7d19p-7,0x1.c8d36da58aa6fp-8,
    -0x1.f2a940511af65p-9,-0x1.a278b47f01a3p-11,-0x1.3745e35f5fb11p-9,-0x1.cea2d77bf206p-10},{0x1.0717af53e9c62p-3,
    -0x1.f1d659161f22dp-57,-0x1.601e44845791ep-2,0x1.0938f11f13ba9p-2,-0x1.06ddf3c204068p-4,0x1.7fa5f7c3dc306p-5,
    -0x1.6a4811ce8aa5ep-7,0x1.5268d1b38e49dp-8,-0x1.2d615c91c49d2p-8,-0x1.4b036b48feae2p-9,-0x1.033280395272dp-8,
    -0x1.c6cca0a4d3acp-9},{0x1.ba3d007e57568p-4,-0x1.7a4a9405b470cp-58,-0x1.3fb0866996788p-2,0x1.fbfef72733c44p-3,
    -0x1.b12cb7d5d86ccp-5,0x1.6579b1c5315b7p-5,-0x1.389a0a998fef4p-7,0x1.6ca0185045468p-9,-0x1.ac6d4e90004c8p-8,
    -0x1.696e6a709bf77p-8,-0x1.cd32290bb1e3ep-8,-0x1.ba8818d7e18ddp-8},{0x1.6e3c03c1c6515p-4,0x1.1bcc47d251222p-58,
    -0x1.20880be713054p-2,0x1.e9bd2193393bbp-3,-0x1.5ac7551fa486ap-5,0x1.4de00797f6e9bp-5,-0x1.2af6872d30936p-7,
    -0x1.bdc3cd5f95f82p-11,-0x1.58a3ec027fabep-7,-0x1.674aebf9dbc09p-7,-0x1.abd6597bb0a18p-7,-0x1.b1f67e92dcf47p-7},
    {0x1.29e34964387a7p-4,0x1.0afd5f50fd726p-58,-0x1.026404e92a944p-2,0x1.db64b2e5fd196p-3,-0x1.0a5098d5da393p-5,
    0x1.354397404c548p-5,-0x1.5788291b2a037p-7,-0x1.c8956210a6dcp-8,-0x1.2bbe758c98f53p-6,-0x1.5c1f097d5f3ccp-6,
    -0x1.98c77c68366a2p-6,-0x1.af5afdb5709cep-6},{0x1.d9f2adb83088dp-5,0x1.028e6f060a758p-59,-0x1.ca104d81067a3p-3,
    0x1.d0aa595a9722ap-3,-0x1.81720e9aaf6d6p-6,0x1.159662078969dp-5,-0x1.e9a36a229ed76p-7,-0x1.2551292d29a07p-6,
    -0x1.1124917a615a6p-5,-0x1.511ad14d3385cp-5,-0x1.8f639c2a85df1p-5,-0x1.b184336d46027p-5},{0x1.6ea6457792217p-5,
    0x1.bb3bba529bfecp-60,-0x1.907adc83d8cfbp-3,0x1.c92c646f3a63bp-3,-0x1.01fabd0d661cep-6,0x1.c7fc8996f0e77p-6,
    -0x1.9a9c1d49b5ecbp-6,-0x1.38cda320583f9p-5,-0x1.0078c99984b8dp-4,-0x1.493c1b49a8045p-4,-0x1.8baf313d11635p-4,
    -0x1.b235234547998p-4},{0x1.11a505e03021dp-5,0x1.5341b8989f0cbp-59,-0x1.57a8efe8db0e2p-3,0x1.c4511bfcd8721p-3,
    -0x1.47686d80bf037p-7,0x1.18a0b7b2469abp-6,-0x1.7770188dd3ad3p-5,-0x1.3a4f804f59926p-4,-0x1.ebbb783a7270bp-4,
    -0x1.43cc389c0bb2fp-3,-0x1.86167ed3183aap-3,-0x1.9e3878b68bb21p-3}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_eps_zero_overlap)

/* linear and Tsuji, zero overlap: zeta/(1 - eps), 1 - eps < 1/2: 9 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-59.1 at most, sampled at 25 places of each row. Bits of the rows:
 * 59.8 60.8 61.0 59.9 63.2 59.9 61.8 59.2 59.1 */
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_OVERLAP_FIRST 0.0
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_OVERLAP_STEP 0.0625
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_OVERLAP_PER_UNIT 16.0
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_OVERLAP_ROWS 9
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_ratio_near_zeta_zero_overlap, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.45f307p-2,-0x1.1b1bbead603d9p-29,0x1.45f306dc9c883p-3,0x1.708c46ce64024p-4,0x1.c5bec6b1f2f58p-5,
    0x1.2c60e4a14cd17p-5,0x1.a801e9f92707cp-6,0x1.3c30eb33365b1p-6,0x1.ed8ff2b7e9726p-7,0x1.8fad1bd6a96a2p-7,
    0x1.4a181fd991561p-7,0x1.457488d8d00d1p-7},{0x1.508275p-2,-0x1.4581537ac16fep-30,0x1.5e63f9258268ap-3,
    0x1.9ee284f57b149p-4,0x1.0cfb80eed1a08p-4,0x1.7910aaa5c106cp-5,0x1.1af4c6ee7a8dep-5,0x1.c1f072e8bf3bap-6,
    0x1.76f40b589d846p-6,0x1.44466a822169bp-6,0x1.213e810e41018p-6,0x1.074eed89729e2p-6},{0x1.5be1b28p-2,
    0x1.cdfb641c13426p-29,0x1.79fea3e7dd72bp-3,0x1.d61c677ae36dfp-4,0x1.423effa5272fap-4,0x1.e0770bf6097dp-5,
    0x1.813a6de335692p-5,0x1.482a812eb05c3p-5,0x1.2566cb2a5901cp-5,0x1.10556c84e4ac5p-5,0x1.04c1b32592a22p-5,
    0x1.fd50bc8a606e5p-6},{0x1.682c77p-2,0x1.5d32974741615p-29,0x1.9963d2c2baf64p-3,0x1.0c56365df361ep-3,
    0x1.86b739b8445c8p-4,0x1.37747ded16f1ap-4,0x1.0c53521b481c1p-4,0x1.ec978b0f5fd6dp-5,0x1.db15f605ce96p-5,
    0x1.dbc6a15c5131ep-5,0x1.eb91a29c776fap-5,0x1.02d279b26effbp-4},{0x1.75842ep-2,0x1.38ef2b9396f22p-31,
    0x1.bd626b72d38fbp-3,0x1.34f97c9523787p-3,0x1.e0678c819f0a2p-4,0x1.9c0e1b6ba3fd6p-4,0x1.7ff77aa18b8b1p-4,
    0x1.7e3c1180975cdp-4,0x1.902c598f2e4c7p-4,0x1.b301df9282bc2p-4,0x1.e7e9b33e65d3dp-4,0x1.16a268f9ab61ep-3},
    {0x1.8411adp-2,0x1.5c20d164d8844p-29,0x1.e709c5a043ccbp-3,0x1.675bacec85e5fp-3,0x1.2c42f1c3934e1p-3,
    0x1.17322182ef61fp-3,0x1.1b957825ef0cbp-3,0x1.347cefe2c9c15p-3,0x1.61222ba68ffe3p-3,0x1.a39f591c80609p-3,
    0x1.0147224273defp-2,0x1.40ea2d085e743p-2},{0x1.9407a08p-2,-0x1.d8e2910040b95p-30,0x1.0be2ec6197c46p-2,
    0x1.a6f8ba27fe3e7p-3,0x1.7edbae9f74658p-3,0x1.856d7d9f037ap-3,0x1.b32313405d11bp-3,0x1.04eed0430906ep-2,
    0x1.4964424bd127ep-2,0x1.af6d8b4019c8ep-2,0x1.23a0e896db5a5p-1,0x1.90895246ec1f4p-1},{0x1.a5a614p-2,
    -0x1.8dc05885fb474p-29,0x1.28c61adb01c98p-2,0x1.f914d036f47fap-3,0x1.f42a517057a6ap-3,0x1.19598db5796f7p-2,
    0x1.5dae61fc6b4bcp-2,0x1.d348c108ebb75p-2,0x1.4894e5c42c025p-1,0x1.df20b03993ee2p-1,0x1.68bbdfb2a72abp+0,
    0x1.137e2e002b0e7p+1},{0x1.b93fd28p-2,-0x1.4703bb9f02bcdp-30,0x1.4b93956ef81ccp-2,0x1.33003cfa1bc5p-2,
    0x1.50c58a8fea5ccp-2,0x1.a8d94d2cd18b2p-2,0x1.29a8e8c7922dcp-1,0x1.c0f3c02ab9f74p-1,0x1.641b66f19a578p+0,
    0x1.249f8ee77cb57p+1,0x1.f10fb11fed779p+1,0x1.ab63717d69306p+2}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_near_zeta_zero_overlap)

/* linear and Tsuji, zero overlap: zeta by eps, 2^-6 <= eps < 2^-1: 40 rows of degree 10 in y = eps 2^-k, 8 rows in each octave k = -6 ... -2.
 * Relative error of the approximation: 2^-58.7 at most, sampled at 25 places of each row. Bits of the rows:
 * 62.1 62.0 61.7 62.3 64.7 61.6 61.6 61.9 60.7 62.3 64.2 62.0 62.2 62.6 65.7 60.5 61.2 60.2 62.1 61.1 62.7 61.0 60.8
 * 65.6 61.2 59.4 59.8 59.4 60.8 60.7 59.7 61.0 59.4 58.7 59.8 60.8 59.3 58.9 60.3 63.1 */
#define COR_ROWS_RATIO_ZETA_ZERO_OVERLAP_FIRST 0.015625
#define COR_ROWS_RATIO_ZETA_ZERO_OVERLAP_FIRST_OCTAVE (-6)
#define COR_ROWS_RATIO_ZETA_ZERO_OVERLAP_OCTAVE_BITS 3
#define COR_ROWS_RATIO_ZETA_ZERO_OVERLAP_ROWS 40
#define COR_ROWS_RATIO_ZETA_ZERO_OVERLAP_END 0.5
COR_ROWS(double, cor_rows_ratio_zeta_zero_overlap, 40, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.96588aeb0941ep-1,0x1.468f55cc60212p-56,-0x1.14519af69ec66p-4,0x1.184f41c793696p-6,-0x1.18341767d134ap-7,
    0x1.5aa93212b55d3p-8,-0x1.db7d239f9eb6ep-9,0x1.5affb35618d9ep-9,-0x1.0802e936c02aap-9,0x1.9df84c6a3f077p-10,
    -0x1.4e2bfdbab998dp-10,0x1.10ca48ea3ddaep-10},{0x1.922845eca0dbap-1,0x1.21e1979cac3f4p-55,-0x1.0449cf6c1efeap-4,
    0x1.d5c04d4ed1e63p-7,-0x1.a26bcb7b6a31cp-8,0x1.ce69e7db28fe3p-9,-0x1.1b763f1d7c0c3p-9,0x1.71e742400bd92p-10,
    -0x1.f756394e6a00cp-11,0x1.60e8c1df78a84p-11,-0x1.fce7b61f1a5a6p-12,0x1.738e35a0eea08p-12},{0x1.8e32f3224b052p-1,
    0x1.dfaf23405c2f3p-55,-0x1.ed767992dc85dp-5,0x1.90e6f9096973dp-7,-0x1.41d26d04eb3cbp-8,0x1.414af55b8f22ep-9,
    -0x1.640fec5dbdae1p-10,0x1.a41b7af479809p-11,-0x1.0277a06ba338p-11,0x1.47c81505694dcp-12,-0x1.ab155aaab6b04p-13,
    0x1.1a05c1b0cb51dp-13},{0x1.8a6fe5954af63p-1,0x1.3a579a1ccfcfbp-56,-0x1.d625ce24df41ap-5,0x1.5b4ef47374ac5p-7,
    -0x1.fb33b8eb0d02p-9,0x1.cdaa2113eac0dp-10,-0x1.d2bb285cbf9ccp-11,0x1.f67b63a4fb957p-12,-0x1.1a208557c4c31p-12,
    0x1.468aebe96fa06p-13,-0x1.840eee126a116p-14,0x1.d3cac6e75a0d6p-15},{0x1.86d85ee10c295p-1,-0x1.75acb02af1e96p-58,
    -0x1.c1d286e4bdc1ap-5,0x1.30a6a5f28e6bp-7,-0x1.97d58231bdb8fp-9,0x1.550c0450ad9d9p-10,-0x1.3cf2d3b8509adp-11,
    0x1.39be9b5806e43p-12,-0x1.43fb35ff1ac79p-13,0x1.58db9587ab1bcp-14,-0x1.78b55fbeb5712p-15,0x1.a1a91d7a7a89cp-16},
    {0x1.83670265fd84ep-1,-0x1.7b6b9487989b1p-57,-0x1.afe61cbb8c62p-5,0x1.0e0f27b86cc68p-7,-0x1.4d93d39c3edd9p-9,
    0x1.01f18936ed46bp-10,-0x1.bb94496ff0d37p-12,0x1.96589354e36c7p-13,-0x1.845b1bdf8d783p-14,0x1.7ea00e6b080cp-15,
    -0x1.82b84d049b84ap-16,0x1.8ce4d64bf1779p-17},{0x1.801777fbbd478p-1,-0x1.822bf18aa10e2p-57,-0x1.9ff03d7429476p-5,
    0x1.e31e9ebb58302p-8,-0x1.14db87fce668dp-9,0x1.8e204d2d817c4p-11,-0x1.3e7b7869b95cep-12,0x1.0f7cd51107eap-13,
    -0x1.e2f3c9ea5c5c2p-15,0x1.badd191ef19eap-16,-0x1.a078d2a37586ep-17,0x1.8dd9e61ce2427p-18},{0x1.7ce62bf4ee016p-1,
    0x1.33fd2385c5e54p-55,-0x1.919b373b8312ap-5,0x1.b383b08091b3dp-8,-0x1.d16aaed130c3p-10,0x1.38a889e1f3ab8p-11,
    -0x1.d39fdb9bdeeabp-13,0x1.74b891aa72a76p-14,-0x1.3602ffb76973ap-15,0x1.09dacf77b4a02p-16,-0x1.d381edff632ap-18,
    0x1.a1b183610e05cp-19},{0x1.784e87fddb4edp-1,0x1.60b40c3e585b9p-58,-0x1.7e9b6a2f3abe4p-4,0x1.7971728c4f033p-6,
    -0x1.6e050da105399p-7,0x1.bf90f1bc029aep-8,-0x1.30dcd3d4ee415p-8,0x1.bacae42558cfep-9,-0x1.4f9c9e6ff32bcp-9,
    0x1.064c4166aa9dbp-9,-0x1.a657998e7529ep-10,0x1.57fa562648402p-10},{0x1.7280a00d23de8p-1,0x1.aad8af7aaf6e9p-56,
    -0x1.68f6c743c624ep-4,0x1.3dfe9ec288912p-6,-0x1.123db18c08a43p-7,0x1.2b57a69a1ab8cp-8,-0x1.6c6a83af64669p-9,
    0x1.d92a6b7969808p-10,-0x1.40ab8f3dbcad6p-10,0x1.c03c60a204668p-11,-0x1.424e930c8629ap-11,0x1.d58b19f078db8p-12},
    {0x1.6d02831133478p-1,0x1.926a1feed896bp-55,-0x1.56900d3881abep-4,0x1.10cc20749cb9cp-6,-0x1.a742bb67e4e18p-8,
    0x1.a10f9f2ee52e3p-9,-0x1.cad4793807cf8p-10,0x1.0d4aa507eea6dp-10,-0x1.4a0a3eaf745bbp-11,0x1.a1305a119337ep-12,
    -0x1.0f09df247ee46p-12,0x1.651ca278638f9p-13},{0x1.67c8cd830f662p-1,-0x1.2001f95a54502p-56,-0x1.46a8bb72f615ep-4,
    0x1.daffd5c0e85bap-7,-0x1.4e99f92d50d37p-8,0x1.2c5f021c95bc6p-9,-0x1.2d616e295312fp-10,0x1.42c2b03d731b8p-11,
    -0x1.68f79076d9b44p-12,0x1.a069b5c9220e5p-13,-0x1.ed78ea2375a43p-14,0x1.28b7ed0c17332p-14},{0x1.62ca9da41092fp-1,
    0x1.fef2b30c461dcp-55,-0x1.38ba470ed9e8fp-4,0x1.a2a20d6b7b067p-7,-0x1.0de0cdb4484e1p-8,0x1.bcd18ed42a709p-10,
    -0x1.9a2ade71c3ce9p-11,0x1.93d5f1f6d6472p-12,-0x1.9f49049f773afp-13,0x1.b88ec9c884abep-14,-0x1.dfe0f30fde581p-15,
    0x1.095ff80f6002dp-15},{0x1.5e00dded3125cp-1,0x1.7a5ad6b504e8cp-56,-0x1.2c62a76fdd647p-4,0x1.74c908858c738p-7,
    -0x1.bacd68e01cccp-9,0x1.512c886b4f94ep-10,-0x1.1f9459e5a5ae6p-11,0x1.05fd38b158133p-12,-0x1.f2aac36b5ee37p-14,
    0x1.e9a0b955c84d6p-15,-0x1.ed709abb42be7p-16,0x1.f92b66fb18dc6p-17},{0x1.5965cc7a9a213p-1,0x1.0eb254b3eaec5p-55,
    -0x1.21588b0f7b7bdp-4,0x1.4ee6839bd1991p-7,-0x1.70959d91321ebp-9,0x1.04c2b22ab028ap-10,-0x1.9db7ab0c7f2cap-12,
    0x1.5eae8be5b2a3cp-13,-0x1.3693392cdde86p-14,0x1.1bce11bdf7e3ep-15,-0x1.0a1c76652f721p-16,0x1.fb26f50f10ea8p-18},
    {0x1.54f4a82fa0144p-1,0x1.e0883882cd0f9p-56,-0x1.1763e288fe53bp-4,0x1.2f2ae497d218cp-7,-0x1.36b1ccd3d98b6p-9,
    0x1.9a6703b177a8cp-11,-0x1.3043a8c93955cp-12,0x1.e23b4f068282dp-14,-0x1.8f578f62e253ap-15,0x1.55407760c222dp-16,
    -0x1.2b282e2c82976p-17,0x1.0a9a355de677ap-18},{0x1.4e9104f95f84fp-1,-0x1.6031a1c292b5p-55,-0x1.0a201b68d5cd8p-3,
    0x1.0852abc3ec49cp-5,-0x1.eabc2429393b4p-7,0x1.269c6d6618d31p-7,-0x1.8db8525b8e5a9p-8,0x1.1f1ba874df6abp-8,
    -0x1.b1447f9963873p-9,0x1.5165caf59a6f7p-9,-0x1.0ecdd8e5b9b23p-9,0x1.b7f95d438319cp-10},{0x1.467e874432127p-1,
    -0x1.a6e12fd183a44p-55,-0x1.f5d3570bf50b6p-4,0x1.c0bbacee69b4bp-6,-0x1.71b1a5af11fe8p-7,0x1.8b91ea1b7ffaep-8,
    -0x1.dce8344d89952p-9,0x1.33aeb00c990a7p-9,-0x1.9f19bc4075f45p-10,0x1.2109636a46c38p-10,-0x1.9e5e799b8f811p-11,
    0x1.2d08050dcadccp-11},{0x1.3edc9bf9b57f5p-1,-0x1.1913d89bc94f8p-55,-0x1.dbc4f3ae56b15p-4,0x1.83a5f67d319f7p-6,
    -0x1.1ed099f873cd5p-7,0x1.148fdbab45288p-8,-0x1.2d1e9f2cc525ep-9,0x1.5f27dd477221ep-10,-0x1.ac4d30899c2a7p-11,
    0x1.0da9a88d62723p-11,-0x1.5d447fd5cbadcp-12,0x1.caefd7921a203p-13},{0x1.379bdfa920d5dp-1,0x1.44a96ba8e2162p-55,
    -0x1.c518ef8686f5bp-4,0x1.53b09c42f6e93p-6,-0x1.c7d9bd48f975fp-8,0x1.8fc2bf661c1p-9,-0x1.8cb00d3568a84p-10,
    0x1.a5ef202ee30a8p-11,-0x1.d588c0eef0734p-12,0x1.0dc35d17ed847p-12,-0x1.3ea35cc24b9d5p-13,0x1.7e1fd4314b8f5p-14},
    {0x1.30b041acf68b9p-1,-0x1.9fd3fd2d95f33p-55,-0x1.b11c982963912p-4,0x1.2d32c711d29cep-6,-0x1.719210a06e673p-8,
    0x1.2903cdf6c6ebp-9,-0x1.0ea9c079b3e7ep-10,0x1.08963d044120dp-11,-0x1.0eb0cda736f22p-12,0x1.1e00f13e2f33ep-13,
    -0x1.367cd0c0f397fp-14,0x1.566e0f6e3fc68p-15},{0x1.2a1015a441276p-1,0x1.6fffb07faf07p-55,-0x1.9f4d444676bd3p-4,
    0x1.0dbaa9069cea1p-6,-0x1.30ba787d66a9ep-8,0x1.c3ca2dfb44bb1p-10,-0x1.7c8558b751244p-11,0x1.58142cf5de34p-12,
    -0x1.45b84b80871fp-13,0x1.3e7d348b8f53p-14,-0x1.3fdec92c6d2e4p-15,0x1.46871eff31d1dp-16},{0x1.23b3749805894p-1,
    0x1.c30f8e11ed0dap-55,-0x1.8f48e5fbc9371p-4,0x1.e7301f48a5dd5p-7,-0x1.fdda0f29dedbdp-9,0x1.5e8f658fe018bp-10,
    -0x1.126654a8a39dfp-11,0x1.cd8f7123e07c6p-13,-0x1.9688194ea8e5ap-14,0x1.71e8aae22cbb6p-15,-0x1.59a2361c49796p-16,
    0x1.4861b598c185cp-17},{0x1.1d93cf87216ep-1,-0x1.e7d18a0972daap-55,-0x1.80c443a1a1d0fp-4,0x1.bb2fe2f0f0d8cp-7,
    -0x1.afe7328ca98afp-9,0x1.14c6398a9800ap-10,-0x1.9498f5ff46ce9p-12,0x1.3e03c9a9cb53ap-13,-0x1.05dc4e149afabp-14,
    0x1.bd953788e2135p-16,-0x1.8538d5add4c12p-17,0x1.59d2cd2ec55e2p-18},{0x1.14cad8d4eb6fp-1,-0x1.f500662e75029p-56,
    -0x1.6d4f8b515f59ap-3,0x1.84ff84ced0c66p-5,-0x1.579618a064c4p-6,0x1.8f5111d270efp-7,-0x1.096243d054ccdp-7,
    0x1.7bd0f49b3721cp-8,-0x1.1ce1a152d6d16p-8,0x1.b9ad0549fbb07p-9,-0x1.612e96648306p-9,0x1.1e04f28b25155p-9},
    {0x1.09bc9a3a10272p-1,0x1.e4e71fc5bbf92p-55,-0x1.56d5b88b3110ap-3,0x1.4ccae1f42c77cp-5,-0x1.054ebfe3677aep-6,
    0x1.0dd2aa732d9e4p-7,-0x1.3fb5407abfe07p-8,0x1.9898d54c22acbp-9,-0x1.11df7bbac2247p-9,0x1.7b938938f07cep-10,
    -0x1.0f07c812af7c9p-10,0x1.88884a3f4b43ap-11},{0x1.feaa918e9e839p-2,0x1.4f534f89046e3p-58,-0x1.43721faf7e669p-3,
    0x1.216ca93ce1a0ep-5,-0x1.99344c792f66ep-7,0x1.7bbf1a891adcp-8,-0x1.9594aac034d5fp-9,0x1.d40c72921f375p-10,
    -0x1.1b8018e7402d1p-10,0x1.6331c8bcc068ep-11,-0x1.ca3152dff474p-12,0x1.2c07736b52855p-12},{0x1.eafe1a1d52a44p-2,
    -0x1.9adf3918db4edp-60,-0x1.3278530adc856p-3,0x1.fe214ccd7a4d9p-6,-0x1.48181fb74b526p-7,0x1.143e9dcfca1acp-8,
    -0x1.0c5e186a58ccp-9,0x1.1a33649bd8b87p-10,-0x1.37c208da7fa7fp-11,0x1.6455d0f55455ep-12,-0x1.a320788e48f3ep-13,
    0x1.f4e5eb61153f8p-14},{0x1.d8513dff89426p-2,-0x1.0922497fa032p-58,-0x1.236d4dcb974ffp-3,0x1.c67d97308bfc6p-6,
    -0x1.0c49a12b705f4p-7,0x1.9d2c88682d3c1p-9,-0x1.6fe26d0914cb8p-10,0x1.632acfa9fea99p-11,-0x1.6889ee93d0f1bp-12,
    0x1.7acfd5129196ep-13,-0x1.9970e25857103p-14,0x1.c1f250535c371p-15},{0x1.c6880851a4193p-2,-0x1.222c090dee799p-56,
    -0x1.15f68553a945fp-3,0x1.989de606694a9p-6,-0x1.be1799fcba227p-8,0x1.3c4cebe7fdf25p-9,-0x1.03c854b770db5p-10,
    0x1.cf7906d650a51p-12,-0x1.b31887ceba5b7p-13,0x1.a6f057c49722ap-14,-0x1.a6d5fa13555b2p-15,0x1.ae08f7677893ap-16},
    {0x1.b58b70e421536p-2,0x1.8dcdf76fc7a99p-59,-0x1.09cf94c835327p-3,0x1.7235adb680543p-6,-0x1.7823a02675413p-8,
    0x1.ee14dfe9d827cp-10,-0x1.78640523d868dp-11,0x1.37edfc3e8a975p-12,-0x1.104b780e3017bp-13,0x1.ec76397bd4016p-15,
    -0x1.c9f4e3fb5971cp-16,0x1.b16cfc773695p-17},{0x1.a5483237326d1p-2,-0x1.75ba842ad8bbap-56,-0x1.fd8756454ae85p-4,
    0x1.51a0e50990e15p-6,-0x1.410914572067cp-8,0x1.88a5d9c5ecda7p-10,-0x1.16c7a3cd6fce6p-11,0x1.af50d1b15b0f3p-13,
    -0x1.5fc54a1bf3b57p-14,0x1.2955059bf34ddp-15,-0x1.026f7cd085a3bp-16,0x1.c96921da718c3p-18},{0x1.8e1bc235a39c8p-2,
    -0x1.b326631834748p-58,-0x1.dfd7c2382981dp-3,0x1.29243c6fef0e8p-4,-0x1.0219585c31459p-5,0x1.1e0789a0365b3p-6,
    -0x1.704d2f11a97cap-7,0x1.02e6ecce011b4p-7,-0x1.8048a131c9aecp-8,0x1.27c86714589dbp-8,-0x1.d68594a909d4ep-9,
    0x1.7b725c2201024p-9},{0x1.71385195bb73ep-2,0x1.794e44fd4168bp-56,-0x1.bd788715290ddp-3,0x1.fd50a3f106ca4p-5,
    -0x1.8d9c6fae9f902p-6,0x1.878f0dbf3d6a2p-7,-0x1.bff6ffcd44a7fp-8,0x1.1878f16924af3p-8,-0x1.7376fded4f6aep-9,
    0x1.fec3013e962f9p-10,-0x1.6a95f83706fb1p-10,0x1.0561cde6eb1efp-10},{0x1.5653bb5dc9ae3p-2,-0x1.190f63039b716p-57,
    -0x1.9fcaf597fe47ap-3,0x1.baf6225a03661p-5,-0x1.3ad4629a91dcbp-6,0x1.1707a16dcb3cep-7,-0x1.1eef4cb20202p-8,
    0x1.4395a933e1b07p-9,-0x1.82a51a2a78202p-10,0x1.e024b27d8a424p-11,-0x1.33b9783005917p-11,0x1.910befe4004p-12},
    {0x1.3d2b33954c4c7p-2,0x1.a564c798c70e2p-57,-0x1.85d3869763b2p-3,0x1.85d65201d0269p-5,-0x1.fdc4b0ca2cca8p-7,
    0x1.9aef0ed1dbb7ep-8,-0x1.7f828dfbca3adp-9,0x1.8911b43033505p-10,-0x1.ab901614cb701p-11,0x1.e3e189d396eep-12,
    -0x1.1a9996ebab635p-12,0x1.4ff7ee50e5492p-13},{0x1.2589505bd43fap-2,-0x1.dd0382832a7ffp-57,-0x1.6edc8348cd0cfp-3,
    0x1.5a6f596f81be5p-5,-0x1.a44d2eb52fa2dp-7,0x1.36ebe71818f2cp-8,-0x1.09823cfd2c965p-9,0x1.f270e8601862ap-11,
    -0x1.f149ffd717f03p-12,0x1.02610c8257f25p-12,-0x1.15259dac756cfp-13,0x1.2ed845407c9c8p-14},{0x1.0f42786edd43p-2,
    -0x1.95e53f86a2561p-56,-0x1.5a5e8ef10376bp-3,0x1.36609f0eaa00cp-5,-0x1.5fd88d9936b5ap-7,0x1.e1593e8a6a766p-9,
    -0x1.7ac3a72ccb5f6p-10,0x1.47bd4afe55357p-11,-0x1.2dd209592f60bp-12,0x1.21d06ef2bd1d5p-13,-0x1.1f53d2d0528c6p-14,
    0x1.226f56c523209p-15},{0x1.f464f392f9452p-3,0x1.36d77143aa99fp-59,-0x1.47f23af4e88ep-3,0x1.17ff9a682a326p-5,
    -0x1.2a59338d6719cp-7,0x1.7be33bbc8c274p-9,-0x1.1525af634aecfp-10,0x1.bca6deb741401p-12,-0x1.7c0c77b67ab8cp-13,
    0x1.530be826e9e5cp-14,-0x1.3868959136859p-15,0x1.25b820f84689ep-16},{0x1.cc75b3de24fb3p-3,0x1.fb7c98aa500c3p-59,
    -0x1.3746c8832837bp-3,0x1.fc319871d404dp-6,-0x1.ff8f016efe2ccp-8,0x1.30d8a7bdebc69p-9,-0x1.9ea05998f0adbp-11,
    0x1.35e6579ed51e9p-12,-0x1.ee0331c4086ap-14,0x1.9b62a710bbf64p-15,-0x1.61fd7db767117p-16,0x1.37060d81f4328p-17}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_zeta_zero_overlap)

/* linear and Tsuji, zero force: (1 - eps)/zeta: 5 rows of degree 10 in y = zeta, nodes 0 + i 0.0625, 0 <= y <= 0.28125.
 * Relative error of the approximation: 2^-57.9 at most, sampled at 25 places of each row. Bits of the rows:
 * 57.9 58.4 58.1 58.4 60.5 */
#define COR_ROWS_RATIO_LOSS_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_RATIO_LOSS_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_RATIO_LOSS_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_RATIO_LOSS_ZERO_FORCE_ROWS 5
#define COR_ROWS_RATIO_LOSS_ZERO_FORCE_END 0.25
COR_ROWS(double, cor_rows_ratio_loss_zero_force, 5, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.921fb58p+1,-0x1.dde973dcb3b3ap-26,-0x1.bbd3cc9be45dep+2,0x1.a0b1b87bd7b57p+3,-0x1.6324aaeaadc92p+4,
    0x1.1b6e3b5f0d6e2p+5,-0x1.af1fcb864bc94p+5,0x1.3bf03d345147dp+6,-0x1.c180a1cd3c472p+6,0x1.37d633dfb9245p+7,
    -0x1.a1e287526e7bcp+7,0x1.cf4bee820358p+7},{0x1.60869c8p+1,-0x1.df6b723df7197p-26,-0x1.6252e23c8b93ap+2,
    0x1.3264134e7ad31p+3,-0x1.e38fd8d78aba7p+3,0x1.6666bafd2c9d9p+4,-0x1.fb49623b512b2p+4,0x1.5a677fc36b2cap+5,
    -0x1.cbb9a6bf4fd1p+5,0x1.29f342c7a352bp+6,-0x1.7c0d90371cdbdp+6,0x1.dacbef6b35c98p+6},{0x1.389736p+1,
    -0x1.e162f4eb5428cp-27,-0x1.1fccc44d3c17bp+2,0x1.cca8fdaa23406p+2,-0x1.521882699d0b8p+3,0x1.d372a3bf8b903p+3,
    -0x1.3520851f2fa64p+4,0x1.8b03e174bc172p+4,-0x1.eafc58c714543p+4,0x1.2a4043f011aa5p+5,-0x1.64a14e23e771bp+5,
    0x1.a20e5ed9c4431p+5},{0x1.17e928p+1,-0x1.ebde2c21e2444p-27,-0x1.daa10b8072febp+1,0x1.6117cc70d45f7p+2,
    -0x1.e3fce3d087affp+2,0x1.3943f7ca0470dp+3,-0x1.849d6bdd89a5dp+3,0x1.d257b1151dc6ep+3,-0x1.106b7dfcb155dp+4,
    0x1.3750b28bc3711p+4,-0x1.5e383bad0616ep+4,0x1.82931a284e6b8p+4},{0x1.f992a38p+0,0x1.866d6a2c67b49p-27,
    -0x1.8c9599a1bb5bbp+1,0x1.1353598880a7cp+2,-0x1.61aeee9e212bdp+2,0x1.ae2a235ffb951p+2,-0x1.f631353635a04p+2,
    0x1.1be5adda65809p+3,-0x1.38c7b8847f614p+3,0x1.514b49810e40ep+3,-0x1.66244ff1a6bcfp+3,0x1.75699863b809bp+3}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_loss_zero_force)

/* linear and Tsuji, zero force: eps: 32 rows of degree 10 in y = zeta 2^-k, 8 rows in each octave k = -2 ... 1.
 * Relative error of the approximation: 2^-54.2 at most, sampled at 25 places of each row. Bits of the rows:
 * 60.3 59.3 58.9 59.2 59.6 58.9 58.5 58.6 58.7 61.9 57.8 58.5 57.4 60.6 58.6 63.6 57.5 58.3 57.4 58.4 57.4 58.0 59.0
 * 59.2 54.2 55.3 56.1 57.0 57.0 57.2 57.3 60.4 */
#define COR_ROWS_RATIO_EPS_ZERO_FORCE_FIRST 0.25
#define COR_ROWS_RATIO_EPS_ZERO_FORCE_FIRST_OCTAVE (-2)
#define COR_ROWS_RATIO_EPS_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_RATIO_EPS_ZERO_FORCE_ROWS 32
#define COR_ROWS_RATIO_EPS_ZERO_FORCE_END 4.0
COR_ROWS(double, cor_rows_ratio_eps_zero_force, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.f3b77850ab602p-2,-0x1.d95e096385c5cp-56,-0x1.23a1847ee939p-2,0x1.e4320eedf45bbp-4,-0x1.5879cf57a2705p-5,
    0x1.bf3869ec3733bp-7,-0x1.10dbe4616ca92p-8,0x1.3e379b4c90adep-10,-0x1.666adfda73767p-12,0x1.88a3081f853c5p-14,
    -0x1.a4b656e5908f1p-16,0x1.b9f7240f37f85p-18},{0x1.d112c994f555fp-2,0x1.208a22bff822cp-57,-0x1.07486d7f96178p-2,
    0x1.a8880da9a1698p-4,-0x1.25896a7d89759p-5,0x1.728ef89029cf2p-7,-0x1.b7d705a7c17fap-9,0x1.f31bcfce006aap-11,
    -0x1.118e1752ef3f2p-12,0x1.23b435e6ffb85p-14,-0x1.3049e72202e6ep-16,0x1.37408a9f13dap-18},{0x1.b1c09e007693p-2,
    -0x1.d40cc066e58c6p-58,-0x1.dcc432f869393p-3,0x1.7594b9dfa78b2p-4,-0x1.f67331358b757p-6,0x1.3498d8989bd1cp-7,
    -0x1.648c792953ca1p-9,0x1.89f030486e2c5p-11,-0x1.a48b84e6e9774p-13,0x1.b4cfa47ebfc35p-15,-0x1.bbe34e40a3f6dp-17,
    0x1.ba6446bc7f8b4p-19},{0x1.955ad0db2717bp-2,0x1.704274e2a509ap-57,-0x1.b0de6154ecceap-3,0x1.49e2c36b9915cp-4,
    -0x1.afcf730df0ff2p-6,0x1.023c3b8007e7p-7,-0x1.229d095a30db6p-9,0x1.38d571752218ep-11,-0x1.457245b16c635p-13,
    0x1.4978d548eb12fp-15,-0x1.465e305f42e07p-17,0x1.3d1dc644e2a2dp-19},{0x1.7b89cbc734478p-2,-0x1.5818a3a8cb2bbp-56,
    -0x1.8a0ad5b0516eep-3,0x1.2442cdbe66e3bp-4,-0x1.7490fd9f58b1fp-6,0x1.b22a548006895p-8,-0x1.dc35d80b702p-10,
    0x1.f3bfdcf7af521p-12,-0x1.faf2be7441775p-14,0x1.f48551fff4707p-16,-0x1.e3980b0c2452fp-18,0x1.ca61b16f05f1cp-20},
    {0x1.640225a270287p-2,-0x1.13192ecc763f1p-56,-0x1.67975125f066bp-3,0x1.03bd01cd0903bp-4,-0x1.42a84445f1e99p-6,
    0x1.6e91784c6a916p-8,-0x1.881a6700467a5p-10,0x1.91634862ab053p-12,-0x1.8d421a32b1f01p-14,0x1.7ebcb17b1ec14p-16,
    -0x1.68e46fd469b13p-18,0x1.4de43c32cd61ep-20},{0x1.4e82b0fc3aa32p-2,0x1.da02ec8848c8fp-56,-0x1.48edb03761a7ap-3,
    0x1.cf0bb85c25604p-5,-0x1.186edca52d78ap-6,0x1.36c8223d0af32p-8,-0x1.44606e72d0125p-10,0x1.44175cca5c189p-12,
    -0x1.391f5ad0a3c3dp-14,0x1.268b2e319f98fp-16,-0x1.0f32193c0f29ep-18,0x1.ea11aa1876725p-21},{0x1.3ad2e39afe83ap-2,
    0x1.769cfdfdbfd6bp-56,-0x1.2d8ef1e07060ap-3,0x1.9deadf4762ebdp-5,-0x1.e92167bcff582p-7,0x1.088792f1a5912p-8,
    -0x1.0d8ef8bf1a21ap-10,0x1.07004084c2725p-12,-0x1.f05df34a32a32p-15,0x1.c81d76821fe8ap-17,-0x1.9a4a346bec9bep-19,
    0x1.6a394b7621f1ap-21},{0x1.2046996721c05p-2,-0x1.d7455749cc89bp-56,-0x1.09c5b11c88c7ep-2,0x1.5f96c7b2494cdp-3,
    -0x1.90c5cb73a3cb1p-4,0x1.a264dc5ac2694p-5,-0x1.9bae9a60e52f4p-6,0x1.83fb5d2815311p-7,-0x1.61beabf48874ap-8,
    0x1.3a23c355dd6f7p-9,-0x1.117d3d33710e7p-10,0x1.d2d33c8c9705bp-12},{0x1.019e0c4b7ef2bp-2,0x1.540755b6bb3e5p-58,
    -0x1.c44824a8f3659p-3,0x1.1d53cd22721b9p-3,-0x1.3688d0ff396e1p-4,0x1.35c2659a43c24p-5,-0x1.2362ce0edb55fp-6,
    0x1.06a5a931be59cp-7,-0x1.ca3b883b94ed1p-9,0x1.857222acfc4dfp-10,-0x1.4483a45fb66b7p-11,0x1.092e33f0cfcc5p-12},
    {0x1.cedf53173fe55p-3,0x1.f9479402ccd13p-58,-0x1.83aa2dc302475p-3,0x1.d369c30dbcd6ap-4,-0x1.e69d3f49b976ep-5,
    0x1.d0a560c66d033p-6,-0x1.a29dc15d8b7ffp-7,0x1.698818a232138p-8,-0x1.2e459e974ff9fp-9,0x1.ec93c28129391p-11,
    -0x1.898a4854759b4p-12,0x1.346ff750e95b3p-13},{0x1.a1d77ce337e5fp-3,0x1.d81407c61de34p-57,-0x1.4e845118038b8p-3,
    0x1.821e4069440dfp-4,-0x1.813058486fb4fp-5,0x1.60ab97affd463p-6,-0x1.30d06dfd1ee58p-7,0x1.f9488903c7f15p-9,
    -0x1.9590b125b72b2p-10,0x1.3d50f350a5daap-11,-0x1.e6edfb5e4c5dep-13,0x1.6e9c2cffd7012p-14},{0x1.7adda65440d9bp-3,
    0x1.789024dc5a35cp-57,-0x1.227189c28aafp-3,0x1.417886f635e5cp-4,-0x1.33cb7cc8a14f4p-5,0x1.0ea469b310004p-6,
    -0x1.c18137d4b999ap-8,0x1.6619c1a589b72p-9,-0x1.145997a0088p-10,0x1.9fde17b7b5f1dp-12,-0x1.32e2f1c2bd684p-13,
    0x1.bc9387afa7fb7p-15},{0x1.58edef409db13p-3,-0x1.31a89e8f27007p-62,-0x1.fb3cace76daeap-4,0x1.0d9794cb9d0f6p-4,
    -0x1.f0375069091f2p-6,0x1.a3a3e9d438d7cp-7,-0x1.4f5042c51e0c1p-8,0x1.011efb4dd9598p-9,-0x1.7e158e879888bp-11,
    0x1.14dc7728b93c4p-12,-0x1.898c34c7777ccp-14,0x1.129e98d1fc95ep-15},{0x1.3b37dfcb5001ep-3,-0x1.2c1a81f1a077fp-57,
    -0x1.bd44b5c85c174p-4,0x1.c7373439b8a16p-5,-0x1.933e6a270b444p-6,0x1.486cc6fedab45p-7,-0x1.f9b0f5ff31277p-9,
    0x1.75bb7b4daf0f5p-10,-0x1.0bb47b13bd987p-11,0x1.7619f13d4e1ebp-13,-0x1.0069a5be475f5p-14,0x1.592fc7244d47cp-16},
    {0x1.2112d10e7aa02p-3,0x1.f7437df2439acp-58,-0x1.88ca1cf175602p-4,0x1.82ba52b0ff959p-5,-0x1.4a2b315974a6fp-6,
    0x1.034f0cf02b1fep-7,-0x1.812be41c0d457p-9,0x1.12b2559c177a4p-10,-0x1.7bd9d9e5a99dp-12,0x1.003c95aa54e6ep-13,
    -0x1.53266302b4f63p-15,0x1.b8ef830aac6e4p-17},{0x1.feca4f174264cp-4,0x1.289b7b8fc2b0ap-59,-0x1.4832a59351c42p-3,
    0x1.3219f103d2bbp-3,-0x1.efa5de9b8adfep-4,0x1.716dc113305a8p-4,-0x1.04880ef6b7b4cp-4,0x1.610657554583ep-5,
    -0x1.cfe93f759171p-6,0x1.297bec91f8055p-6,-0x1.7763f4a06b6dfp-7,0x1.d0215957ff4a4p-8},{0x1.b56bd8dd1bcdp-4,
    0x1.54779813fff4dp-58,-0x1.05fd8de93a385p-3,0x1.c8759ce4c202bp-4,-0x1.599fbeb1936bdp-4,0x1.e24cf78b8fe6fp-5,
    -0x1.3e9f85eef3446p-5,0x1.94a8ea5550b59p-6,-0x1.f2a1de9d43105p-7,0x1.2befadf63724cp-7,-0x1.62fc9ab7d942fp-8,
    0x1.9bf31e92ff71ap-9},{0x1.7a6f673a14744p-4,-0x1.ee3f7483889b2p-61,-0x1.a85c53f0672c5p-4,0x1.5aae4f9448cf5p-4,
    -0x1.ecedcdbc51bb7p-5,0x1.4330c817d5a27p-5,-0x1.91873f10c4171p-6,0x1.dfc00f64d334ap-7,-0x1.16303573a9c3fp-7,
    0x1.3b15a06ad7314p-8,-0x1.5f10155e56f4fp-9,0x1.7fc2f1f2b440dp-10},{0x1.4a5cb943c49dbp-4,0x1.29fac0fde9b8p-59,
    -0x1.5c17e9503bd57p-4,0x1.0ba51bda7d444p-4,-0x1.668d242af24d5p-5,0x1.bb555ee2ea0b3p-6,-0x1.03d4491f8afffp-6,
    0x1.2508b200e1addp-7,-0x1.40e5aa7badf21p-8,0x1.574eb4b59754ep-9,-0x1.6949348c7ac92p-10,0x1.753a3d1503a77p-11},
    {0x1.22b5213d5733ap-4,-0x1.7bb1b4369e8fbp-58,-0x1.20cafc25a5902p-4,0x1.a3525badc5a67p-5,-0x1.0977008cbfdf4p-5,
    0x1.367386d61519fp-6,-0x1.585e5951f42bp-7,0x1.6fb09a4810781p-8,-0x1.7d563e434ae2cp-9,0x1.827bb7bc758bcp-10,
    -0x1.814c07f2c5abp-11,0x1.793eb1bd03f15p-12},{0x1.01a491cb7c103p-4,-0x1.4bdf991e7580ep-59,-0x1.e4156898c81d6p-5,
    0x1.4ccc2bcf0f032p-5,-0x1.8f62ff4ee85bfp-6,0x1.bafc56dd5d0fp-7,-0x1.d247c66cf30fap-8,0x1.d89cb2cd80802p-9,
    -0x1.d172dbd9fcc5ap-10,0x1.c012fa513d4e9p-11,-0x1.a84ca8039063p-12,0x1.8ac4d6818545cp-13},{0x1.cb9c4cc763c61p-5,
    0x1.eda6489e63288p-63,-0x1.99721d9dd6fd8p-5,0x1.0b4194ef07fd4p-5,-0x1.30c5f62cd144p-6,0x1.416b92d3b88ffp-7,
    -0x1.41d5ac7babc2bp-8,0x1.366c16d7ac97p-9,-0x1.23035d89a552cp-10,0x1.0abe0fbc75f4ep-11,-0x1.e1029ce867018p-13,
    0x1.aa48f62c144ccp-14},{0x1.9c5397b79b9c6p-5,-0x1.6163f84962ab6p-59,-0x1.5d315ed4bc16p-5,0x1.b1d94880a35dcp-6,
    -0x1.d73b9fe0a15eap-7,0x1.d99d71e135a94p-8,-0x1.c4222be40b09p-9,0x1.9fed65aa1cb98p-10,-0x1.73fd27984ae07p-11,
    0x1.455c1028f6af2p-12,-0x1.17f05f9ee1c32p-13,0x1.d9a5eeaa88622p-15},{0x1.61c50ae161fd5p-5,0x1.4bc0088c60e9dp-59,
    -0x1.16de54f9cd382p-4,0x1.42feed150a67dp-4,-0x1.47663e9665cfep-4,0x1.33516f22dccdp-4,-0x1.1229aabd5fcbp-4,
    0x1.d799b8ba29cb5p-5,-0x1.8a7d1c31a3655p-5,0x1.42d24f3b3cbd2p-5,-0x1.05125fa6ce9f8p-5,0x1.9d73d565141c2p-6},
    {0x1.2500930c05647p-5,0x1.11c241d9aea37p-62,-0x1.a6b92c40a3048p-5,0x1.c0dc06dde2cdcp-5,-0x1.a1a06cd18ac9cp-5,
    0x1.682895576e55ep-5,-0x1.27677c64997a5p-5,0x1.d371f8a80887p-6,-0x1.67ddfb60aadeap-6,0x1.0f22ec148e5bp-6,
    -0x1.93881fa909c38p-7,0x1.26615afbcca31p-7},{0x1.ece0ecdc66141p-6,-0x1.20e0cad0fe39ep-62,-0x1.4797d655e9426p-5,
    0x1.40ff8e70c7502p-5,-0x1.13e8a72e9ff77p-5,0x1.b7fbb5a8341b2p-6,-0x1.4ddc6e597d0f7p-6,0x1.e8fe951006c3dp-7,
    -0x1.5c97feeeb6c9dp-7,0x1.e692c41ecae1fp-8,-0x1.4f40fa0a0c46bp-8,0x1.c559cfd3197d8p-9},{0x1.a4082733386d9p-6,
    0x1.16071afc9b83bp-60,-0x1.02bdd8f518e95p-5,0x1.d69687d14395fp-6,-0x1.77bf154597e79p-6,0x1.1681d4bc82541p-6,
    -0x1.8921c6cd3e266p-7,0x1.0be807519dedcp-7,-0x1.63921b477e88p-8,0x1.ce272ae39e6aap-9,-0x1.286ad87ebf90fp-9,
    0x1.756f9f7b4d1f6p-10},{0x1.6a072971735bp-6,0x1.20aae680ef65dp-60,-0x1.9f7db572ddba2p-6,0x1.6064a530009b8p-6,
    -0x1.06a52caa5d3f2p-6,0x1.6baafadb79d5ap-7,-0x1.dfb80fa724547p-8,0x1.319f76ef48076p-8,-0x1.7b56da53de7d6p-9,
    0x1.cd38178287a5p-10,-0x1.14a839728b4cap-10,0x1.4631204c6a1a6p-11},{0x1.3b2031f6c3a92p-6,0x1.31ea9ce4118aep-61,
    -0x1.526ad11c5d0dbp-6,0x1.0cdba3fe0992dp-6,-0x1.77afe8f99d4bdp-7,0x1.e7e9248a453d1p-8,-0x1.2df890fb36e4ap-8,
    0x1.692e3a4657909p-9,-0x1.a4f265aef9231p-10,0x1.e0b42172edb3fp-11,-0x1.0ec5ff55e4dc2p-11,0x1.2bfa30ecf6129p-12},
    {0x1.14af6d963d122p-6,-0x1.530ee2322a76ap-62,-0x1.1723b7360e146p-6,0x1.a10e169d5b56cp-7,-0x1.122d4f58f8d93p-7,
    0x1.4f38af01ba7acp-8,-0x1.86cb854f5b265p-9,0x1.b85d939c7fa96p-10,-0x1.e3a8f55012aa3p-11,0x1.044e579b9a693p-11,
    -0x1.1461d81a8d561p-12,0x1.20b8fa64318b7p-13},{0x1.e99ad251cf1b9p-7,-0x1.2aef67823aa72p-65,-0x1.d1aaf4458c147p-7,
    0x1.483a50f184452p-7,-0x1.977092772892bp-8,0x1.d68741a7d2a5fp-9,-0x1.0326dbd8123bfp-9,0x1.14035a6c7873ap-10,
    -0x1.1e99985292701p-11,0x1.23b77b8f75459p-12,-0x1.24db95e353215p-13,0x1.2164c47df0266p-14}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_eps_zero_force)

/* linear and Tsuji, zero force: zeta/(1 - eps), 1 - eps < 1/2: 9 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-54.9 at most, sampled at 25 places of each row. Bits of the rows:
 * 60.1 61.3 59.6 61.9 59.2 58.3 58.6 56.6 54.9 */
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_FORCE_FIRST 0.0
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_FORCE_STEP 0.0625
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_FORCE_PER_UNIT 16.0
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_FORCE_ROWS 9
#define COR_ROWS_RATIO_NEAR_ZETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_ratio_near_zeta_zero_force, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.45f307p-2,-0x1.1b1bbead603d9p-29,0x1.ca0d3636cb442p-3,0x1.71ea513ff7d56p-3,0x1.3d6c4fd6bbe8fp-3,
    0x1.19cd3c4ebf59cp-3,0x1.ff5a17ae74955p-4,0x1.d6fef8196305ep-4,0x1.b6a6d00da9ec2p-4,0x1.9c29c5e13613bp-4,
    0x1.817488c9fe719p-4,0x1.aeb716253a1b6p-4},{0x1.5506e68p-2,-0x1.600413e89bc87p-32,0x1.fc4e95bc0bd6cp-3,
    0x1.b4b840813a994p-3,0x1.8f23d407f5419p-3,0x1.799e8974be78dp-3,0x1.6d386652e038cp-3,0x1.66a97a692cd6ap-3,
    0x1.642f1b44dae2dp-3,0x1.64c2b670bf18ap-3,0x1.68aa07e55d8c7p-3,0x1.6dafa7bfa932ep-3},{0x1.65d0f98p-2,
    -0x1.04126f1bb5725p-29,0x1.1bfc9200be973p-2,0x1.04b1fa4df93dcp-2,0x1.fdc6131fefba1p-3,0x1.021e94e0f3cdap-2,
    0x1.0b4d792f78f7cp-2,0x1.191fb337caba1p-2,0x1.2b059b4f07257p-2,0x1.40d130a5be7ap-2,0x1.5b8def599948dp-2,
    0x1.7981c0b8c6a46p-2},{0x1.78a6768p-2,0x1.5829342b2c99bp-29,0x1.3fd5acd665b16p-2,0x1.3b427bbfeeaefp-2,
    0x1.4b68dfad426eap-2,0x1.69117ef6c0f6p-2,0x1.9268b4779da8ap-2,0x1.c78ee5afe363fp-2,0x1.04d41e0d725e6p-1,
    0x1.2d49e5657a878p-1,0x1.5f9956c3b45adp-1,0x1.9b36e6f87c9e2p-1},{0x1.8df54e8p-2,0x1.271e50c57598ap-29,
    0x1.6b8311b9fd863p-2,0x1.82f5b6d74b281p-2,0x1.b7ef58da17feap-2,0x1.035b0199e257p-1,0x1.38eca65251dd1p-1,
    0x1.7f97f3224308p-1,0x1.dbb0c13df69ccp-1,0x1.298ef4542529bp+0,0x1.78540b709404cp+0,0x1.dcbe6b4fd1e7cp+0},
    {0x1.a64e258p-2,0x1.950ea380151bp-37,0x1.a198b9a154eeap-2,0x1.e35468b188f4bp-2,0x1.2b316aa7a3f7ap-1,
    0x1.806cb4c257e68p-1,0x1.f9a36293f3ddfp-1,0x1.51ece0a4125ddp+0,0x1.c8fe8b90927a9p+0,0x1.37c55354b5a15p+1,
    0x1.ae632d42d6b74p+1,0x1.295a8faf1170dp+2},{0x1.c273b18p-2,0x1.601f5ce78d6b2p-33,0x1.e5dc983748698p-2,
    0x1.342eed5a81d8bp-1,0x1.a2ea4d83ab173p-1,0x1.27b5b0160cd0bp+0,0x1.ab89ffd6bfd7dp+0,0x1.3a266351e2716p+1,
    0x1.d32962d7df9c9p+1,0x1.5e7d01f05035fp+2,0x1.0a523096921ddp+3,0x1.94bec55a16378p+3},{0x1.e3734a8p-2,
    0x1.b6a07f916ea77p-29,0x1.1f03875e448e3p-1,0x1.93025f2fc565p-1,0x1.2fbd62f16e0f5p+0,0x1.dbe9cea9e87c2p+0,
    0x1.7dfc6e52b5dcp+1,0x1.37b5fc2e73adbp+2,0x1.016dac608f50ap+3,0x1.ad152028b467p+3,0x1.6aaf3330aadap+4,
    0x1.322de6b7a4df6p+5},{0x1.0566fap-1,0x1.955010496f3f9p-30,0x1.5992372be6934p-1,0x1.0fcef7fe99e5ep+0,
    0x1.cbf74d06eedep+0,0x1.94e845eba5bc5p+1,0x1.6d58738953154p+2,0x1.4f3b70abeeb39p+3,0x1.3759aaa3ed9f9p+4,
    0x1.23d7cad2fd399p+5,0x1.15fc81f5a1527p+6,0x1.07faf38e0acb1p+7}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_near_zeta_zero_force)

/* linear and Tsuji, zero force: zeta by eps, 2^-6 <= eps < 2^-1: 40 rows of degree 10 in y = eps 2^-k, 8 rows in each octave k = -6 ... -2.
 * Relative error of the approximation: 2^-55.4 at most, sampled at 25 places of each row. Bits of the rows:
 * 56.3 57.5 59.1 59.3 60.3 61.1 59.9 59.5 56.0 58.2 58.4 59.1 60.6 59.3 59.1 58.8 56.2 58.2 58.6 61.0 58.6 63.2 60.0
 * 59.5 56.3 57.5 59.3 59.6 58.8 59.6 58.6 58.4 55.4 57.3 57.2 58.1 58.2 58.2 60.1 60.8 */
#define COR_ROWS_RATIO_ZETA_ZERO_FORCE_FIRST 0.015625
#define COR_ROWS_RATIO_ZETA_ZERO_FORCE_FIRST_OCTAVE (-6)
#define COR_ROWS_RATIO_ZETA_ZERO_FORCE_OCTAVE_BITS 3
#define COR_ROWS_RATIO_ZETA_ZERO_FORCE_ROWS 40
#define COR_ROWS_RATIO_ZETA_ZERO_FORCE_END 0.5
COR_ROWS(double, cor_rows_ratio_zeta_zero_force, 40, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.d459fd5c0d8dcp+1,-0x1.141683e5b784ap-57,-0x1.e195ef3144e5ap+0,0x1.4fa9a166dd69ap+0,-0x1.06017a1dbecf6p+0,
    0x1.ae6e8e092d21ep-1,-0x1.6c02da850696p-1,0x1.39b2504096ec6p-1,-0x1.11ec1b993b4fp-1,0x1.e3156f2984ac4p-2,
    -0x1.b094a55d22205p-2,0x1.82a4fad53b468p-2},{0x1.b8a486b3af272p+1,0x1.5fb542c0a69a8p-53,-0x1.987785207e61ep+0,
    0x1.fd0f6381ffb2fp-1,-0x1.6367de70bf7d2p-1,0x1.0527bf620b64dp-1,-0x1.8b2a577a8053ap-2,0x1.30ab87823c8ecp-2,
    -0x1.dc0b0809e1c72p-3,0x1.77904187dd92p-3,-0x1.2c6a0b302e5f3p-3,0x1.e0791437d616ap-4},{0x1.a0f16b4a730c4p+1,
    -0x1.64f0693445bb9p-53,-0x1.60408b0837673p+0,0x1.8ce5d0b122709p-1,-0x1.f5412354b43cdp-2,0x1.4d2f8c1afb0d6p-2,
    -0x1.c8164d4fa2bcfp-3,0x1.3e1f7c9465044p-3,-0x1.c1b23c24286f4p-4,0x1.40f90b94882aap-4,-0x1.d009e7e55641ep-5,
    0x1.4fba5f0d46b13p-5},{0x1.8c5d5a45ff3bbp+1,-0x1.576508ac78cafp-54,-0x1.33ed1ce77c0f7p+0,0x1.3c900ae81bbc3p-1,
    -0x1.6ceb81537496ap-2,0x1.badd27b1ed4b6p-3,-0x1.14b89abeceec7p-3,0x1.606e6f685d509p-4,-0x1.c6d8718f0704ep-5,
    0x1.28673237030cbp-5,-0x1.86e75169b80a7p-6,0x1.023650964895ap-6},{0x1.7a45e49cb82f7p+1,-0x1.21a90d6e1b6a9p-53,
    -0x1.103d0468f14dcp+0,0x1.01504312ba3adp-1,-0x1.10cf81e8ae74fp-2,0x1.308ae2420462ep-3,-0x1.5e18eeba884a5p-4,
    0x1.9a2def330a1fdp-5,-0x1.e6feeb0f103dcp-6,0x1.23f3a123409e8p-6,-0x1.61fb8a1e5950dp-7,0x1.ae3835f28e8a9p-8},
    {0x1.6a3373c84d868p+1,0x1.c38dbb9ada1e7p-54,-0x1.e5ff218633fe6p-1,0x1.a90f204a688d6p-2,-0x1.a128e67c7d519p-3,
    0x1.af1dc7a50664p-4,-0x1.cad7eb0e1f914p-5,0x1.f1ba4cdbd3535p-6,-0x1.11913aa7b0c1cp-6,0x1.2fb19d48a53a6p-7,
    -0x1.54c1164dec56cp-8,0x1.7f738504f96cfp-9},{0x1.5bcbc326119c2p+1,-0x1.232e6749d444bp-53,-0x1.b55d3a2c972e6p-1,
    0x1.63edf98cae524p-2,-0x1.4523054eb27cdp-3,0x1.38cabf9171838p-4,-0x1.35ead735c27edp-5,0x1.38f8f3ccc7b9fp-6,
    -0x1.404b6c61d11e6p-7,0x1.4b07b43a7c5e7p-8,-0x1.59a7931ee4b0ap-9,0x1.6a20c422a6124p-10},{0x1.4ec93a826757ep+1,
    0x1.a2de6f46b3757p-54,-0x1.8c6651bbbb237p-1,0x1.2d9b49dfd9da5p-2,-0x1.01abf5c63832bp-3,0x1.cfb88609f5979p-5,
    -0x1.adc5df0ba39a8p-6,0x1.95faac745a1d1p-7,-0x1.84a69d730a394p-8,0x1.77bf074b428bap-9,-0x1.6ee58a6b34c04p-10,
    0x1.67925f2305697p-11},{0x1.3d6eac49ecd9bp+1,0x1.8a26253470ccap-53,-0x1.59f40ee025924p+0,0x1.df9a75728643bp-1,
    -0x1.75729a320ba0ep-1,0x1.3252499ef7169p-1,-0x1.02cf0d585db18p-1,0x1.bdc5056048f95p-2,-0x1.850cd7a308992p-2,
    0x1.56ec0ac40fc4dp-2,-0x1.32f8644afffe4p-2,0x1.124c6e47ac302p-2},{0x1.2984abef65c3ep+1,0x1.999b931587c27p-53,
    -0x1.25b2ebb99da9ap+0,0x1.6bee4b5bed9e5p-1,-0x1.fadc7d97a0892p-2,0x1.73e350c5da8dap-2,-0x1.19143874ff1dap-2,
    0x1.b11bbc6d7dae8p-3,-0x1.522d9c6c46ef4p-3,0x1.0aaed701ecb69p-3,-0x1.aa7d6d4eda6ebp-4,0x1.54f54e3d92aaep-4},
    {0x1.18786563630bfp+1,0x1.5502acd8ca88ap-53,-0x1.fafee9093943bp-1,0x1.1bee2a5c42e7cp-1,-0x1.659f9a1c7603fp-2,
    0x1.daadcb9fa619fp-3,-0x1.448b56795ccap-3,0x1.c465e79eac1c5p-4,-0x1.3f916b2c9b6d1p-4,0x1.c7fa4495e4868p-5,
    -0x1.497c5335680bfp-5,0x1.dc9cdf1e9f7a9p-6},{0x1.09a7b7a7a5737p+1,-0x1.9c392a3457b9ap-53,-0x1.bb8eb8e27ef21p-1,
    0x1.c533961860d3p-2,-0x1.047cd91684a33p-2,0x1.3b9b189fb8dccp-3,-0x1.89f95f74e0299p-4,0x1.f55d0fc5d6f8dp-5,
    -0x1.4354b4675f977p-5,0x1.a532b4b179dafp-6,-0x1.15a21b88768c1p-6,0x1.6ea99fb5eaba1p-7},{0x1.f93d715317cap+0,
    0x1.821a78a0578d4p-55,-0x1.887371bbbaef6p-1,0x1.709858312575bp-2,-0x1.85aa8b58aa541p-3,0x1.b23f0230f481cp-4,
    -0x1.f2a0d0e323266p-5,0x1.23db295cfaaa3p-5,-0x1.5a4acb1a237b1p-6,0x1.9efda6793c308p-7,-0x1.f6f4799b0d95dp-8,
    0x1.3188756aaf92p-8},{0x1.e2100d1b3d899p+0,-0x1.dc0d62d6a90d4p-54,-0x1.5e8dca4866009p-1,0x1.309d2d00de357p-2,
    -0x1.2a0fef413c02bp-3,0x1.337d0063e3fa8p-4,-0x1.46df7ab05b242p-5,0x1.6243d93c1a466p-6,-0x1.852bf57aeaeecp-7,
    0x1.afccf74f49ee2p-8,-0x1.e448be3170449p-9,0x1.106284e747077p-9},{0x1.cd464cff515dfp+0,0x1.2bdbef6c31b39p-58,
    -0x1.3bb15c95f6423p-1,0x1.fe6b81fbf4b97p-3,-0x1.d0d4e599c469ep-4,0x1.be5d37e0707dcp-5,-0x1.b9b6da16cda38p-6,
    0x1.bdaa7876718c8p-7,-0x1.c7c6da9d203bfp-8,0x1.d6cb4699ef6cep-9,-0x1.eb5f069493046p-10,0x1.014c4fbf4d3a2p-10},
    {0x1.ba7cb8821c4efp+0,0x1.bca90ee2bc3ep-54,-0x1.1e501aae59eabp-1,0x1.b0bdaa40ec09dp-3,-0x1.708a1a8454302p-4,
    0x1.4aff33169f6f1p-5,-0x1.325f84ee47b9cp-6,0x1.212412d583152p-7,-0x1.1499dd861ccfdp-8,0x1.0b43a37fd96edp-9,
    -0x1.04d8eac52eaefp-10,0x1.ff147cd71e455p-12},{0x1.a1682fd9a176dp+0,0x1.7e967e163ec4dp-54,-0x1.f4386412b0b15p-1,
    0x1.5851303be19acp-1,-0x1.0b3b0abc020a8p-1,0x1.b58843f65d44cp-2,-0x1.712c90a36a8e3p-2,0x1.3d9eac9974f19p-2,
    -0x1.14ff58a88b821p-2,0x1.e8045366c5079p-3,-0x1.b4a2da0de204ep-3,0x1.8600ed1539bfdp-3},{0x1.8498aca7d9f96p+0,
    0x1.d5b3ec2747b77p-55,-0x1.a92868c27bff4p-1,0x1.05839472ddb6dp-1,-0x1.6afb383d47962p-2,0x1.09c61277978dfp-2,
    -0x1.912ff1feb4f1bp-3,0x1.34c561d282f22p-3,-0x1.e1cd8cbc499d1p-4,0x1.7bb3a7c538f0ap-4,-0x1.2f74fa070862cp-4,
    0x1.e4fc8e301cc92p-5},{0x1.6be79974b81f7p+0,-0x1.865246598892p-55,-0x1.6f5bb90c7f427p-1,0x1.9867d44e5fd35p-2,
    -0x1.004b71442c5b6p-2,0x1.53741e2e1de82p-3,-0x1.cf7ec0fff130bp-4,0x1.42b1b91e13bf2p-4,-0x1.c7831ab47f8c3p-5,
    0x1.44c1dd0996abfp-5,-0x1.d512be7d0811p-6,0x1.531be802352c1p-6},{0x1.566cade4b0352p+0,0x1.3bf57924b268ep-57,
    -0x1.41b72d3ad713cp-1,0x1.4634e5af9acb3p-2,-0x1.759f155b27e76p-3,0x1.c3ab98879900dp-4,-0x1.197b19f562eb1p-4,
    0x1.65cd50bb8ecdcp-5,-0x1.cd1758be6ff56p-6,0x1.2c1e08194ae0cp-6,-0x1.8b6a50a9fc109p-7,0x1.04fb0126bf8e2p-7},
    {0x1.4381b917df21p+0,-0x1.875a385e8da4ep-56,-0x1.1cea8c65a56eep-1,0x1.0982e7d31e1cap-2,-0x1.17a2c4fcaef74p-3,
    0x1.36e921459ea87p-4,-0x1.6470c02514116p-5,0x1.a0c5ad8f97124p-6,-0x1.ee0e7f28a0316p-7,0x1.27d16bdfeed09p-7,
    -0x1.664dddb83f5eap-8,0x1.b31a0c6cecd26p-9},{0x1.32ac3b332846ap+0,0x1.a6e671af20ee3p-54,-0x1.fd73879a8747p-2,
    0x1.b72a629ee5809p-3,-0x1.ac106b6771b17p-4,0x1.b88e08271c6c5p-5,-0x1.d38f98dd402b2p-6,0x1.fa207f3bf638fp-7,
    -0x1.15bc631e6f8c6p-7,0x1.33ec9f02fefbap-8,-0x1.592235ff9afc6p-9,0x1.8408f4bd4ac5cp-10},{0x1.238fa23ba3db7p+0,
    -0x1.1e83f340e7924p-54,-0x1.cb2cbb1b77dedp-2,0x1.70317591edf7dp-3,-0x1.4dfc2ff355f4ep-4,0x1.3fef6c28635f7p-5,
    -0x1.3c11761abda94p-6,0x1.3e7ef85846dd7p-7,-0x1.45675c5d55579p-8,0x1.4fdc74133f6a4p-9,-0x1.5e4fe74c47cbap-10,
    0x1.6eab50cfd4cbap-11},{0x1.15e47be8edcadp+0,-0x1.39394a9e7a9bbp-59,-0x1.a0c6424f15305p-2,0x1.385d5e719c023p-3,
    -0x1.08f33344a452ep-4,0x1.dabb7824e1b78p-6,-0x1.b6a77070096ebp-7,0x1.9d728c902383fp-8,-0x1.8b1e583d68ba6p-9,
    0x1.7d78aaca3f5f3p-10,-0x1.740fcc1ee6c5ap-11,0x1.6c4910ca432f8p-12},{0x1.03a0d132d5ad9p+0,0x1.9840c33494d46p-54,
    -0x1.6c7c7de94a83fp-1,0x1.f18a750c55a31p-2,-0x1.808c3ef0f834cp-2,0x1.39feacb1c22abp-2,-0x1.08761bff31761p-2,
    0x1.c673149c70481p-3,-0x1.8be9687014e85p-3,0x1.5c7722cdb3451p-3,-0x1.378e524af50b7p-3,0x1.161e0e9c06e3fp-3},
    {0x1.dd3de59feff05p-1,0x1.b1cf7a86b5befp-56,-0x1.3639130a0b927p-1,0x1.7a5425d007bdbp-2,-0x1.056eda73045cfp-2,
    0x1.7dd06b749904bp-3,-0x1.1fa292b9f56dp-3,0x1.ba218ed1566cap-4,-0x1.5891a4d2bd515p-4,0x1.0f4ed6b0ea91ap-4,
    -0x1.b1558b71f038ap-5,0x1.5a0ffe18c352dp-5},{0x1.b92f83db6ad62p-1,-0x1.b9fad604b977bp-57,-0x1.0c646479c7baap-1,
    0x1.27bc654f8ea1ap-2,-0x1.71897f05771d5p-3,0x1.e814ecfca819bp-4,-0x1.4c918cf0b8e32p-4,0x1.ce67a03131f58p-5,
    -0x1.45fd2477170f1p-5,0x1.d06521fee02ebp-6,-0x1.4f1ecf25fc304p-6,0x1.e439117b773a9p-7},{0x1.99c7c29058048p-1,
    -0x1.3f54bcf6e93fep-55,-0x1.d6a6649f3e4a7p-2,0x1.d8e737d2b576fp-3,-0x1.0d9787d1807eep-3,0x1.44fa5c37b0935p-4,
    -0x1.943ce122d5d6cp-5,0x1.008872e139404p-5,-0x1.4a31d7c8d3ef5p-6,0x1.ad6c02dca0198p-7,-0x1.1aa901c99a35bp-7,
    0x1.74ddba4de058ep-8},{0x1.7e16ebb021d64p-1,-0x1.906cb421699a8p-55,-0x1.a146f844ff813p-2,0x1.8146d97f4e242p-3,
    -0x1.93e3a531f180ap-4,0x1.bfbe43aac1118p-5,-0x1.001fb890663fcp-5,0x1.2b022383612e2p-6,-0x1.6204e26e16d02p-7,
    0x1.a7840dc510a7p-8,-0x1.0045cd449e9e6p-8,0x1.36fb1a30c668p-9},{0x1.656c26b221f73p-1,-0x1.6c66c0e4445a5p-56,
    -0x1.75730b453ee9p-2,0x1.3eea35d9b1666p-3,-0x1.35617074dbc2dp-4,0x1.3d7395df41a29p-5,-0x1.5031f58a48611p-6,
    0x1.6b575acc3d982p-7,-0x1.8e4278c8f8eeap-8,0x1.b917a06c66d87p-9,-0x1.edf71f0ccafddp-10,0x1.157ae9b283b6dp-10},
    {0x1.4f41b3e12677p-1,-0x1.8209aff1e3595p-59,-0x1.50ec9ec64fbcdp-2,0x1.0b99f2b85d496p-3,-0x1.e3229f006eb0ap-5,
    0x1.cd63e89591d38p-6,-0x1.c6d239980fb47p-7,0x1.c98f430df3da1p-8,-0x1.d2dfe30ce02cdp-9,0x1.e15dc245f1088p-10,
    -0x1.f5a151356aa3p-11,0x1.0653fd481c448p-11},{0x1.3b304424f6f59p-1,0x1.a23d40dd438c9p-56,-0x1.32188915514b2p-2,
    0x1.c66a16e4a45fap-4,-0x1.7f8bbdfd8128bp-5,0x1.568a120201987p-6,-0x1.3bcda14363fbfp-7,0x1.29276febe627ep-8,
    -0x1.1b99f71cdc784p-9,0x1.1181e054ce457p-10,-0x1.0a843bb462b4ep-11,0x1.04be55a94296ep-12},{0x1.2057d915a2673p-1,
    0x1.4dc90862809d1p-55,-0x1.0c0aaa222f6ap-1,0x1.6a4f371fe4933p-2,-0x1.169f3f308a79bp-2,0x1.c58b4645856fp-3,
    -0x1.7d1f0f3e21a27p-3,0x1.46e388e284f6dp-3,-0x1.1c6390e9931dfp-3,0x1.f40ca8095a9d8p-4,-0x1.bea7e4cf19cc7p-4,
    0x1.8e6563187dd99p-4},{0x1.016be47b17241p-1,-0x1.3ecf013543568p-59,-0x1.c90032c02eeb6p-2,0x1.13e21d2da5ac2p-2,
    -0x1.7b51377a7b015p-3,0x1.141276e79352ap-3,-0x1.9ef72809e045ep-4,0x1.3e59dafc0edf1p-4,-0x1.ef7e1eee4ed15p-5,
    0x1.85aefd47fc5cbp-5,-0x1.36e43df3997a7p-5,0x1.f023de133ddefp-6},{0x1.cdb059ff93dcfp-2,0x1.9c0c6cb6a14ap-58,
    -0x1.8bf491fb9c397p-2,0x1.afdd5ae6450dep-3,-0x1.0c656f72d76c1p-3,0x1.614a194490ba1p-4,-0x1.e045db351407bp-5,
    0x1.4d43a7cebd90dp-5,-0x1.d531f79ae2d84p-6,0x1.4dcb320a7fb8cp-6,-0x1.e14068376f21cp-7,0x1.5b61844c05182p-7},
    {0x1.9f537fc3a7c2ap-2,0x1.61b6c645784b7p-56,-0x1.5ba39f98bd3d8p-2,0x1.59b3f55b019bbp-3,-0x1.8809638d6af9ap-4,
    0x1.d6eebfe324508p-5,-0x1.24294e0a9491bp-5,0x1.721b03cdb759dp-6,-0x1.dba64fba98c05p-7,0x1.34e7869205a0dp-7,
    -0x1.963a9cfc93fc5p-8,0x1.0bb11a470a39dp-8},{0x1.7664dcbc6f66p-2,0x1.199945cd988e3p-56,-0x1.3499ed3e44f16p-2,
    0x1.19f5906393f62p-3,-0x1.25f6aff74d7a5p-4,0x1.44b9419dfaabp-5,-0x1.728da7c2b0e58p-6,0x1.afbf4015505a4p-7,
    -0x1.fe600d4be6fb8p-8,0x1.30e339c7b6a69p-8,-0x1.70931a8719e2p-9,0x1.bed69ecc03226p-10},{0x1.51e329a45dec8p-2,
    -0x1.f676fe76f5772p-56,-0x1.148298a971368p-2,0x1.d345f310b931cp-4,-0x1.c2c906df8b99bp-5,0x1.ccdeddda83552p-6,
    -0x1.e6ce400a4be88p-7,0x1.068712eb25da7p-7,-0x1.1f4b551988a6fp-8,0x1.3dc5216c1bfbdp-9,-0x1.6375bc8ec297fp-10,
    0x1.8ef7de2728799p-11},{0x1.310ba04f433a7p-2,-0x1.c4f1431709c68p-56,-0x1.f37a61ff5ee0dp-3,0x1.88794b8909d5p-4,
    -0x1.604bbdcd58af3p-5,0x1.4f33995d49b0cp-6,-0x1.498c78762153fp-7,0x1.4ada58aaf2ab1p-8,-0x1.5108776b37c66p-9,
    0x1.5b05b94ece454p-10,-0x1.6936cb8697f8ap-11,0x1.796c17ab4060dp-12},{0x1.1347aa90db07ep-2,-0x1.0f459caf536a1p-56,
    -0x1.c63e4b234fee7p-3,0x1.4d8a213696f4ap-4,-0x1.17ea84ee7dd5p-5,0x1.f21c44d08a517p-7,-0x1.c9fcc043af6c7p-8,
    0x1.ae0a9f127c7p-9,-0x1.99bd5794a23eap-10,0x1.8a9b9672e83c8p-11,-0x1.8011a8a710e28p-12,0x1.775ee76214b69p-13}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_zeta_zero_force)

/* linear and Tsuji, damped approach: (1 - eps)/zeta: 9 rows of degree 10 in y = zeta, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-58.3 at most, sampled at 25 places of each row. Bits of the rows:
 * 58.9 58.8 59.8 59.7 58.3 60.1 59.2 60.1 61.5 */
#define COR_ROWS_RATIO_LOSS_APPROACH_ONLY_FIRST 0.0
#define COR_ROWS_RATIO_LOSS_APPROACH_ONLY_STEP 0.0625
#define COR_ROWS_RATIO_LOSS_APPROACH_ONLY_PER_UNIT 16.0
#define COR_ROWS_RATIO_LOSS_APPROACH_ONLY_ROWS 9
#define COR_ROWS_RATIO_LOSS_APPROACH_ONLY_END 0.5
COR_ROWS(double, cor_rows_ratio_loss_approach_only, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.921fb58p+0,-0x1.dde973dcb3b3ap-27,-0x1.1de9e64df22efp+1,0x1.8046bb8bc9167p+1,-0x1.f1a1600170525p+1,
    0x1.39b48ec8b4ed8p+2,-0x1.838954ef1c69p+2,0x1.d70fb31cbbe2fp+2,-0x1.1a875b2dd5316p+3,0x1.4f02a0a867f8p+3,
    -0x1.8519342868d2fp+3,0x1.8018b12b8ea1fp+3},{0x1.71295e8p+0,0x1.c7cec45fc377ap-29,-0x1.e64dee84d0508p+0,
    0x1.2ffa7312b4c95p+1,-0x1.6efe2e00b3353p+1,0x1.b00262b65534p+1,-0x1.f2cae08b3e1a2p+1,0x1.1b8b4ae693c8cp+2,
    -0x1.3e514a4afdbadp+2,0x1.6196e7cf06947p+2,-0x1.865ca8f073f1ap+2,0x1.aa57c99e05453p+2},{0x1.54f9ba8p+0,
    0x1.584303ffeeb82p-28,-0x1.a223387f3cf93p+0,0x1.e862af7d962b6p+0,-0x1.1402edae101e2p+1,0x1.30988cdae3eb1p+1,
    -0x1.4a01515b030cbp+1,0x1.604f41216cf51p+1,-0x1.7398ddbf72e4ep+1,0x1.83fa2e5e1904cp+1,-0x1.929aa7c61d23ap+1,
    0x1.9d920792a72c5p+1},{0x1.3c9fa4p+0,-0x1.ab416d9cf90e3p-28,-0x1.6b029695ad0dap+0,0x1.8db2037ee230fp+0,
    -0x1.a66cda7b14685p+0,0x1.b69db1c00f1d2p+0,-0x1.bf805acf4f7bep+0,0x1.c22f671ca7996p+0,-0x1.bfa941c9e5a02p+0,
    0x1.b8d3764be9d0ep+0,-0x1.af76a1f8384d2p+0,0x1.a246a6004989fp+0},{0x1.276462p+0,-0x1.6ebc7a23a45e2p-33,
    -0x1.3dda156837795p+0,0x1.47c5de6510c78p+0,-0x1.484565930f821p+0,0x1.41bf9e2d0597p+0,-0x1.361d5b646c031p+0,
    0x1.26e645d309a9ap+0,-0x1.15532b96e630cp+0,0x1.025c0e838aaa5p+0,-0x1.de7f2d8452e26p-1,0x1.b7191144b7c7p-1},
    {0x1.14bb318p+0,0x1.28f68c61e753bp-27,-0x1.186f60fd2ee23p+0,0x1.11117c83181cp+0,-0x1.02a4ae46cad49p+0,
    0x1.dffe76cfd645bp-1,-0x1.b64fc9b8d6fa3p-1,0x1.8b1bdf5af18dcp-1,-0x1.605f3614a1534p-1,0x1.376d7f309ab9ep-1,
    -0x1.119d1e9f1d78fp-1,0x1.dca665fdaa53bp-2},{0x1.043606p+0,-0x1.89ce18ae0cf33p-27,-0x1.f23a43c5fb772p-1,
    0x1.cb68b48c20872p-1,-0x1.9ca7380d2cd82p-1,0x1.6b76ce5d50751p-1,-0x1.3b44456f0ae76p-1,0x1.0e16833f03521p-1,
    -0x1.ca0622a4241b3p-2,0x1.80fe5873180eap-2,-0x1.41b9642b44037p-2,0x1.0aa6023c64e63p-2},{0x1.eafb5e8p-1,
    -0x1.ac0a3e9a12aa1p-29,-0x1.bd4e0e1e1e6abp-1,0x1.85d7d2aca02afp-1,-0x1.4ce571c6023c3p-1,0x1.16ffea9c6c9b5p-1,
    -0x1.ccd5d1e2b05efp-2,0x1.7813d40ce1c4ap-2,-0x1.2fe0aa232bd9fp-2,0x1.e6f606b96eef7p-3,-0x1.83f1749372aep-3,
    0x1.32a329f39582cp-3},{0x1.d098908p-1,-0x1.a6baff3d528e9p-28,-0x1.903841a3f8349p-1,0x1.4d7113b258b28p-1,
    -0x1.0f4dd145f19f6p-1,0x1.b1aa84744683dp-2,-0x1.55be53796fef9p-2,0x1.0a3b630975bfbp-2,-0x1.9adc1ab5f4714p-3,
    0x1.3a75b606920afp-3,-0x1.dea707acd2991p-4,0x1.698dae9bf66a3p-4}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_loss_approach_only)

/* linear and Tsuji, damped approach: eps: 24 rows of degree 10 in y = zeta 2^-k, 8 rows in each octave k = -1 ... 1.
 * Relative error of the approximation: 2^-57.0 at most, sampled at 25 places of each row. Bits of the rows:
 * 59.4 60.6 61.3 59.6 59.2 59.5 59.5 59.4 58.5 59.1 58.5 58.8 58.7 60.1 59.8 59.4 57.0 57.5 58.7 60.8 58.3 59.9 60.2
 * 63.3 */
#define COR_ROWS_RATIO_EPS_APPROACH_ONLY_FIRST 0.5
#define COR_ROWS_RATIO_EPS_APPROACH_ONLY_FIRST_OCTAVE (-1)
#define COR_ROWS_RATIO_EPS_APPROACH_ONLY_OCTAVE_BITS 3
#define COR_ROWS_RATIO_EPS_APPROACH_ONLY_ROWS 24
#define COR_ROWS_RATIO_EPS_APPROACH_ONLY_END 4.0
COR_ROWS(double, cor_rows_ratio_eps_approach_only, 24, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.0fa8b2a65652cp-1,0x1.943ed4f4390c5p-55,-0x1.f4e7b8c5a5855p-3,0x1.afbe6647958b2p-4,-0x1.654d45ac6cbcp-5,
    0x1.1f9a5213186abp-6,-0x1.c5a628ec1a953p-8,0x1.602e13d7e54e7p-9,-0x1.0df82340fa205p-10,0x1.999b1619b8561p-12,
    -0x1.346f353097c6p-13,0x1.cc651779ed7b6p-15},{0x1.00ceb2b3b47eep-1,0x1.fe0a1494012f2p-55,-0x1.c2dc1cd03a03bp-3,
    0x1.72f96df52b3dp-4,-0x1.2577f8e67edd2p-5,0x1.c3f876e294e1fp-7,-0x1.5532b70fbf6fcp-8,0x1.fb49db9ba2689p-10,
    -0x1.747cd9c397b79p-11,0x1.0ebc8e3073f7cp-12,-0x1.86af1f581163ep-14,0x1.177881bb83af5p-15},{0x1.e6d11d54b3212p-2,
    0x1.b07ab8376112ap-56,-0x1.97b7ffc8ee066p-3,0x1.40db33f09d03p-4,-0x1.e6207be6782abp-6,0x1.66c018131a0c5p-7,
    -0x1.03ae3ebc2a54p-8,0x1.7257c6f8282bap-10,-0x1.04eaf03eccf24p-11,0x1.6c023d7aec94bp-13,-0x1.f82aa13abe959p-15,
    0x1.5a3de85fc4384p-16},{0x1.ce87f3237da1p-2,-0x1.4725a65da047cp-56,-0x1.724b5a2ffd50ep-3,0x1.17305e0a84379p-4,
    -0x1.95be787c1bcfdp-6,0x1.1f6ce976e8a41p-7,-0x1.8f9eddc5ed7cbp-9,0x1.11c4ef5a7b42bp-10,-0x1.72b663e005755p-12,
    0x1.f11f885ccc29ap-14,-0x1.4af1ddc5e97a5p-15,0x1.b512a67a8536cp-17},{0x1.b86e49a467572p-2,-0x1.fabd8e9c7119bp-57,
    -0x1.51a3d997df4d2p-3,0x1.e8944365eb1e8p-5,-0x1.55121c699a656p-6,0x1.d08cdaf874221p-8,-0x1.369c126de1315p-9,
    0x1.99780bda89067p-11,-0x1.0ace99dc43a99p-12,0x1.58679d2d1c01p-14,-0x1.b971f898861b4p-16,0x1.18b0b98402faap-17},
    {0x1.a43e1d15ad961p-2,-0x1.6a7d0381d14a5p-58,-0x1.34fe99af0e4e6p-3,0x1.adb7204dfbe03p-5,-0x1.209a285441dbp-6,
    0x1.7a6d3b98639d3p-8,-0x1.e7659ccb5e344p-10,0x1.35855d06debcp-11,-0x1.84b85bae162e2p-13,0x1.e3a7f08959d7cp-15,
    -0x1.2acd410435088p-16,0x1.6e5f4ba0656cbp-18},{0x1.91bc652b5f3a5p-2,-0x1.c3703bb3c6a49p-56,-0x1.1bbd8ad307a2ep-3,
    0x1.7bc1a4a4ac40fp-5,-0x1.eb690bc7ad04dp-7,0x1.3691a250ad202p-8,-0x1.81c0114733128p-10,0x1.d8a2d35b5dee4p-12,
    -0x1.1e5f6d637cdebp-13,0x1.57e056c768533p-15,-0x1.9a19e30a403ap-17,0x1.e56e156b6a788p-19},{0x1.80b70a69b0932p-2,
    0x1.589b3c2930abfp-57,-0x1.055f7cb3c906fp-3,0x1.511a83e215f3p-5,-0x1.a4c2ebf3d8bdbp-7,0x1.00a669029d521p-8,
    -0x1.33cb05f6c6683p-10,0x1.6c3b85d94ceecp-12,-0x1.aa654f7cfa3bfp-14,0x1.eeb9247edc24fp-16,-0x1.1d101748dd857p-17,
    0x1.461e41cd68c87p-19},{0x1.699c57cb92db1p-2,-0x1.044b5539f8932p-56,-0x1.d0b0ee3fae5e3p-3,0x1.1c1db7aacf1d2p-3,
    -0x1.50acf5cbfa7fap-4,0x1.86430cb042bf8p-5,-0x1.bcf94b14c1a2dp-6,0x1.f4d7505990621p-7,-0x1.16ed545fe41ecp-7,
    0x1.33fe41d7f4b96p-8,-0x1.52925f10b53cbp-9,0x1.70c33f8e1e283p-10},{0x1.4ea2474798465p-2,0x1.bd33458213719p-57,
    -0x1.90da72f2fcc26p-3,0x1.ca4ef4cf9ccc2p-4,-0x1.fca10a808cdbbp-5,0x1.145f3eb6afe27p-5,-0x1.27a3abf7f61a9p-6,
    0x1.385a8a99b8b7ep-7,-0x1.46b5dbe341ee5p-8,0x1.52e1f39a5dc33p-9,-0x1.5dea7b5f4d3abp-10,0x1.662fb9e8582aep-11},
    {0x1.37412b10f313dp-2,-0x1.7a12177aa8c01p-57,-0x1.5d06fa9bfac19p-3,0x1.769532a2dd171p-4,-0x1.86ce359ffe65p-5,
    0x1.8fa360e0c335bp-6,-0x1.92895b28a4fd1p-7,0x1.90a7e1e9e3119p-8,-0x1.8af105a83d0c3p-9,0x1.822f0cb0a725cp-10,
    -0x1.77e5611af4718p-11,0x1.6ae60acf3d452p-12},{0x1.22d05baaac56p-2,0x1.6152515f2993cp-57,-0x1.326c2697f5e41p-3,
    0x1.35c661a76c35ap-4,-0x1.30db11b59e793p-5,0x1.265179bc09884p-6,-0x1.180d147379f44p-7,0x1.07708b7d46fb2p-8,
    -0x1.eb05d84aed582p-10,0x1.c60f44fa9e70ep-11,-0x1.a1f52e48e00d9p-12,0x1.7dc0ea20a867dp-13},{0x1.10cd67bb508d5p-2,
    0x1.285f9a2c26ac7p-56,-0x1.0f0172fce2511p-3,0x1.02e2737e1e0c1p-4,-0x1.e2193de9d5532p-6,0x1.b8b84c22fa814p-7,
    -0x1.8d501dc2809fcp-8,0x1.623fc69b050a4p-9,-0x1.39053a0c81cb4p-10,0x1.12846d6d93472p-11,-0x1.df4d5ee1dbb25p-13,
    0x1.9f5a3bcaad972p-14},{0x1.00d1f2ce903ecp-2,-0x1.0d2e4ca102c11p-56,-0x1.e289ac876dc83p-4,0x1.b4cf6e0ab68efp-5,
    -0x1.81dcd0139a1b6p-6,0x1.4ee894fab89f2p-7,-0x1.1ecef697e3197p-8,0x1.e607d786bba26p-10,-0x1.983fb0ab41629p-11,
    0x1.546d6d0709bfap-12,-0x1.1a958d2109f48p-13,0x1.d1d9fe8f65addp-15},{0x1.e5193a583c71p-3,0x1.fdc9665d6c54fp-58,
    -0x1.b026df3ee042ap-4,0x1.73a97bef9590fp-5,-0x1.3840bb474c37cp-6,0x1.01f1295648822p-7,-0x1.a4ae81778ddc7p-9,
    0x1.538a09e72b503p-10,-0x1.0fbff2b175267p-11,0x1.afeea4f25c374p-13,-0x1.55b883e5c4602p-14,0x1.0c8a03d2373bfp-15},
    {0x1.cb77e741ecc3fp-3,-0x1.42984daf97113p-57,-0x1.851dd536c9d1ep-4,0x1.3eaed491c8fbep-5,-0x1.fe71ae10c07fp-7,
    0x1.9234a106bd4eap-8,-0x1.38fe03348d0bcp-9,0x1.e25141080773p-11,-0x1.709ad83e39fd9p-12,0x1.17c811a86a9fcp-13,
    -0x1.a6d47d7363658p-15,0x1.3d74eaf62f26ep-16},{0x1.a9980376421bcp-3,0x1.76cb20e20333cp-58,-0x1.4f7c5b4dada71p-3,
    0x1.00581d5519493p-3,-0x1.7f9952023491bp-4,0x1.1aa396b650c01p-4,-0x1.9b9a7cb99aed9p-5,0x1.28e24adeb2978p-5,
    -0x1.a8f3fa7f50635p-6,0x1.2e274e6ec67c6p-6,-0x1.ad593a3b0be8ep-7,0x1.2e17e8e61a9e8p-7},{0x1.83520a84bafaep-3,
    -0x1.04a3400e0297fp-57,-0x1.17664a17d817dp-3,0x1.87cca681ca023p-4,-0x1.0d6e6a5dab016p-4,0x1.6d4ea4e27e744p-5,
    -0x1.e9d94bac86572p-6,0x1.4584b8896233p-6,-0x1.ad77d8176d7bfp-7,0x1.198fe29490a9dp-7,-0x1.70bf6a43f6bcdp-8,
    0x1.deb9e2036b7b2p-9},{0x1.6336c31e1ba44p-3,-0x1.01089fe7cc84dp-58,-0x1.d8301335cee76p-4,0x1.31c2fa0b7c8fbp-4,
    -0x1.84ee562c2d0f2p-5,0x1.e82b19877a88fp-6,-0x1.2f32905c7c21fp-6,0x1.757c5c5a6b8ddp-7,-0x1.c8e33c8e62372p-8,
    0x1.15d3633b4316fp-8,-0x1.516092e088087p-9,0x1.9673c1e7ae88dp-10},{0x1.47ea340969f06p-3,0x1.b74d25c5a4cacp-63,
    -0x1.93fe82dcca368p-4,0x1.e5e7a289649b2p-5,-0x1.1f5d1718a5683p-5,0x1.4fac538be1698p-6,-0x1.8449fb589a8f4p-7,
    0x1.bd9c93847287p-8,-0x1.fc0bb6a441987p-9,0x1.2001e52c46b7bp-9,-0x1.45fab49e1a5ffp-10,0x1.6e48870ed6e49p-11},
    {0x1.306eb9ea970bfp-3,-0x1.e5e6a50745542p-58,-0x1.5d63dd4dd7834p-4,0x1.882ae78a945bbp-5,-0x1.b15c735390a11p-6,
    0x1.d94b4a9e56b34p-7,-0x1.0014515dce668p-7,0x1.1309b553a67b8p-8,-0x1.258fb2450c06p-9,0x1.37ad5e45d1cf3p-10,
    -0x1.4a4afcf7f403ep-11,0x1.5bae23e23a3a3p-12},{0x1.1c074c8279896p-3,-0x1.3706fdf000655p-57,-0x1.31058453837e1p-4,
    0x1.40deb3a2f849ep-5,-0x1.4ca423e4c8ad8p-6,0x1.550d97d8abcd1p-7,-0x1.5aa36a0f97d17p-8,0x1.5dd123fb6406p-9,
    -0x1.5eeed4cd1e64bp-10,0x1.5e473670e6e0dp-11,-0x1.5ceeecf3de28p-12,0x1.596fea2462024p-13},{0x1.0a24495b33335p-3,
    -0x1.a594d5419c12ap-57,-0x1.0c80a1dc59fefp-4,0x1.09b86e752e4a5p-5,-0x1.03617444211ccp-6,0x1.f52061a092371p-8,
    -0x1.e019d3cb64b67p-9,0x1.c8dad72b21c59p-10,-0x1.b047125013c09p-11,0x1.970d59d27f0b4p-12,-0x1.7e83189ab7fc6p-13,
    0x1.655f2d0589ad4p-14},{0x1.f4ad5bf75849cp-4,-0x1.26b296b1c9ac3p-58,-0x1.dc32e8feb1162p-5,0x1.bcd7ba507a4c5p-6,
    -0x1.9a36bd7a3549cp-7,0x1.769021eed20dfp-8,-0x1.5354fa62ca89ep-9,0x1.3170394f8abc1p-10,-0x1.117225fb24f74p-11,
    0x1.e759c33879736p-13,-0x1.b1611ed3c66fbp-14,0x1.7f4be1a5903dep-15}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_eps_approach_only)

/* linear and Tsuji, damped approach: zeta/(1 - eps), 1 - eps < 1/2: 17 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.03125, 0 <= y <= 0.515625.
 * Relative error of the approximation: 2^-59.0 at most, sampled at 25 places of each row. Bits of the rows:
 * 59.8 59.7 61.1 59.7 59.7 61.3 59.5 62.7 60.8 60.6 60.6 60.7 62.2 59.0 61.2 59.1 59.6 */
#define COR_ROWS_RATIO_NEAR_ZETA_APPROACH_ONLY_FIRST 0.0
#define COR_ROWS_RATIO_NEAR_ZETA_APPROACH_ONLY_STEP 0.03125
#define COR_ROWS_RATIO_NEAR_ZETA_APPROACH_ONLY_PER_UNIT 32.0
#define COR_ROWS_RATIO_NEAR_ZETA_APPROACH_ONLY_ROWS 17
#define COR_ROWS_RATIO_NEAR_ZETA_APPROACH_ONLY_END 0.5
COR_ROWS(double, cor_rows_ratio_near_zeta_approach_only, 17, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.45f307p-1,-0x1.1b1bbead603d9p-28,0x1.2713b2c87dp-1,0x1.19c76c492466bp-1,0x1.12759928baffp-1,
    0x1.0de6dd9fee29p-1,0x1.0ad7523afd1ecp-1,0x1.08ad2d42037cfp-1,0x1.071613f92b3c1p-1,0x1.05e59f9369b06p-1,
    0x1.043cc56fdfec5p-1,0x1.197145001faeap-1},{0x1.4f744c8p-1,0x1.0a199ce07a6b6p-28,0x1.3986c79201da7p-1,
    0x1.352d2927edd72p-1,0x1.36f947c4e9631p-1,0x1.3bc5b9663dd3ep-1,0x1.42582099bd412p-1,0x1.4a1cc47d824bfp-1,
    0x1.52c5c8fc6d019p-1,0x1.5c26fdc1cb4a7p-1,0x1.6661661792103p-1,0x1.70efee6ef4daap-1},{0x1.5990508p-1,
    -0x1.3baf0a3b0bd82p-32,0x1.4dcd1c0876ee7p-1,0x1.5448a359fe5e8p-1,0x1.61ce7cd383e51p-1,0x1.735c5cbd058e2p-1,
    0x1.87d42a2a9876bp-1,0x1.9ebc78778946ap-1,0x1.b7e1a8ae57b2dp-1,0x1.d332a57f39a2dp-1,0x1.f10974623b4d9p-1,
    0x1.0864f069e9db5p+0},{0x1.6456a7p-1,0x1.200191e458385p-28,0x1.64271b7f1ff97p-1,0x1.77c13ddd2e3f3p-1,
    0x1.9452604af2551p-1,0x1.b7298b2b79b4bp-1,0x1.df79a417036b2p-1,0x1.068fb2568290ep+0,0x1.2022959dae7adp+0,
    0x1.3ca0c72ab1f5bp+0,0x1.5c86bc1a6528bp+0,0x1.7f9de153819e9p+0},{0x1.6fd9158p-1,-0x1.07d28dda2fa34p-28,
    0x1.7ce0c2b0802dp-1,0x1.a0632fc7e4b49p-1,0x1.d03d844e3b3a7p-1,0x1.05376ee01a5cdp+0,0x1.27767f682575bp+0,
    0x1.4f3976b1a3f8ep+0,0x1.7d159cb8868bcp+0,0x1.b1ca6ea31c49fp+0,0x1.eea27ba5ccfddp+0,0x1.19f8365fa5d0bp+1},
    {0x1.7c2bf68p-1,0x1.4c53576eb0c28p-29,0x1.98543823740eep-1,0x1.cf295a5c08203p-1,0x1.0be02cf911039p+0,
    0x1.38bb294d2f163p+0,0x1.6ef01c9d6027p+0,0x1.afd66828e84c1p+0,0x1.fd3140a55de38p+0,0x1.2c96a43104c5dp+1,
    0x1.6382aa6dec335p+1,0x1.a460e1a38ee9dp+1},{0x1.8966bbp-1,-0x1.f3e0ebd0012cbp-28,0x1.b6ed19a8a089fp-1,
    0x1.02a51fb53032fp+0,0x1.36d5035f909a9p+0,0x1.78fa4dae97fddp+0,0x1.cb782c9a3d673p+0,0x1.18d53e329fbd2p+1,
    0x1.57f0ce69cace1p+1,0x1.a5c1d023db165p+1,0x1.030d7c66b202dp+2,0x1.3e22e266b0a68p+2},{0x1.97a4828p-1,
    -0x1.04cf9c3a4ff21p-29,0x1.d92cb9bba80a2p-1,0x1.2224a128e4851p+0,0x1.6acefec5c9bc2p+0,0x1.c9cae629b8294p+0,
    0x1.223b83e9371b8p+1,0x1.71117db4cd9aap+1,0x1.d62d1c52628d9p+1,0x1.2bdb0297591e2p+2,0x1.7f2b4cd4681a5p+2,
    0x1.e96f9b401512dp+2},{0x1.a704e18p-1,-0x1.00339060bf2d8p-28,0x1.ffaf9dfc09ed2p-1,0x1.4706ef6cdd37ap+0,
    0x1.aa2f6f1e15876p+0,0x1.18325b240226dp+1,0x1.72332c37ec41ep+1,0x1.ea7ead245a477p+1,0x1.458465dffe3e8p+2,
    0x1.b0915f1e90763p+2,0x1.1ff4abed36bd1p+3,0x1.7f2f0b551f9fdp+3},{0x1.b7acd38p-1,0x1.6456f9ac8a04fp-29,
    0x1.159a582250532p+0,0x1.7281a11ceb7a6p+0,0x1.f81c376b3ba2bp+0,0x1.59fbb29f5807fp+1,0x1.dd25eeb5dd6ebp+1,
    0x1.49ecfb7511d36p+2,0x1.c90b2345f6a6dp+2,0x1.3cedea9ca5a63p+3,0x1.b86658e431b22p+3,0x1.31cb55d6be9f1p+4},
    {0x1.c9c7f48p-1,0x1.f153e11ff336ap-28,0x1.2e53619a08b86p+0,0x1.a621ec1f503d6p+0,0x1.2c65eec3961efp+1,
    0x1.af458049caf2ap+1,0x1.3701cea2e678cp+2,0x1.c1c2f95ff4a03p+2,0x1.45c0e4acfa834p+3,0x1.d86401f2fd6a2p+3,
    0x1.57373876a98abp+4,0x1.f258f243201fp+4},{0x1.dd8a1p-1,-0x1.a651829e4ddd1p-29,0x1.4a94a89e24b3cp+0,
    0x1.e3eb124f72ac4p+0,0x1.68fa34cfdbba7p+1,0x1.0f955b684885ap+2,0x1.9a7e787c402adp+2,0x1.3708f4d7ce759p+3,
    0x1.d81b90a7b0fb3p+3,0x1.66ac8084eaccep+4,0x1.1113469e91a72p+5,0x1.9f6e491caacabp+5},{0x1.f331268p-1,
    -0x1.7b5bbfd1111f1p-28,0x1.6b14e3b97519fp+0,0x1.1740c2ff45c7dp+1,0x1.b5b7de64d6de8p+1,0x1.59f2dc240f97fp+2,
    0x1.129e5e4127443p+3,0x1.b517283fe2575p+3,0x1.5c61ccd0bf731p+4,0x1.15f4f9afd0705p+5,0x1.bc87dbf615883p+5,
    0x1.63144492be75cp+6},{0x1.05840c8p+0,0x1.eff7ea6281a5ep-30,0x1.90bba84f0b874p+0,0x1.44b48b7061fbap+1,
    0x1.0c0ce8f2b2cf4p+2,0x1.be394b813ade4p+2,0x1.74ffc2e22c69ap+3,0x1.388c7ffcaae3fp+4,0x1.0648f5d84227fp+5,
    0x1.b8a1d2c8f35b7p+5,0x1.730139d625a3ap+6,0x1.37faf3d790aecp+7},{0x1.12b51ap+0,0x1.6002a3b53840cp-27,
    0x1.bcb20a8ba8085p+0,0x1.7cb014165c6d4p+1,0x1.4bf3f963f4333p+2,0x1.23ccd7a687f0ep+3,0x1.0190a49587837p+4,
    0x1.c7c1bfb714b84p+4,0x1.93ccb8d64de74p+5,0x1.66179d5c818a3p+6,0x1.3e5d57812c013p+7,0x1.1a9e6e5cc4b48p+8},
    {0x1.2163fc8p+0,0x1.5c3456a42e4afp-28,0x1.f07a3f5cda9b9p+0,0x1.c274128ec8557p+1,0x1.a031f4983c4f9p+2,
    0x1.83943759ff5dp+3,0x1.6a5f62719b327p+4,0x1.5390a71e06b3fp+5,0x1.3e9f68bdd072p+6,0x1.2b3ad1afc6ca8p+7,
    0x1.19c931fce8c67p+8,0x1.08e3ffac3b5c6p+9},{0x1.31d6d8p+0,-0x1.3daf010584453p-30,0x1.1708ec920594dp+1,
    0x1.0d458832a60cap+2,0x1.088b9e72af18ap+3,0x1.05e5f209970b2p+4,0x1.04464fe489cd1p+5,0x1.0336d1e769e35p+6,
    0x1.027cd3181b812p+7,0x1.01f8d4d1455b2p+8,0x1.023955524fd37p+9,0x1.01f0c9d6876p+10}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_near_zeta_approach_only)

/* linear and Tsuji, damped approach: zeta by eps, 2^-3 <= eps < 2^-1: 16 rows of degree 10 in y = eps 2^-k, 8 rows in each octave k = -3 ... -2.
 * Relative error of the approximation: 2^-53.6 at most, sampled at 25 places of each row. Bits of the rows:
 * 53.7 55.6 56.5 57.2 58.1 58.2 60.0 61.1 53.6 55.3 57.2 58.0 58.8 57.6 58.6 58.3 */
#define COR_ROWS_RATIO_ZETA_APPROACH_ONLY_FIRST 0.125
#define COR_ROWS_RATIO_ZETA_APPROACH_ONLY_FIRST_OCTAVE (-3)
#define COR_ROWS_RATIO_ZETA_APPROACH_ONLY_OCTAVE_BITS 3
#define COR_ROWS_RATIO_ZETA_APPROACH_ONLY_ROWS 16
#define COR_ROWS_RATIO_ZETA_APPROACH_ONLY_END 0.5
COR_ROWS(double, cor_rows_ratio_zeta_approach_only, 16, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.c510a9e3e99c1p+1,-0x1.6ecda750e097ep-54,-0x1.d3c039eaa65e8p+1,0x1.afa4ef61a6dd8p+1,-0x1.93df8686459bp+1,
    0x1.7b39bd5a8795ep+1,-0x1.64856c4ccfa8bp+1,0x1.4f59713beef89p+1,-0x1.3b8116e70b9dfp+1,0x1.28e13950c74ecp+1,
    -0x1.19d009c3de97dp+1,0x1.093558ee8514ep+1},{0x1.90a27c35bd2bcp+1,-0x1.f20b64f0d4f72p-54,-0x1.78309d027730bp+1,
    0x1.35d59835dcac8p+1,-0x1.0321e8c1f3605p+1,0x1.b33654576a031p+0,-0x1.6dffa0bd8dfd8p+0,0x1.33fba84723025p+0,
    -0x1.033cb479e72a5p+0,0x1.b47d685dffdefp-1,-0x1.7210a9f674a9fp-1,0x1.3798091208cp-1},{0x1.65fe7c8a208aep+1,
    0x1.1e2ce5a394ca8p-53,-0x1.35605a073ef35p+1,0x1.cbf45085201fap+0,-0x1.5bb5777b890a5p+0,0x1.080df939efe24p+0,
    -0x1.91b8cce8612b9p-1,0x1.31cdbb9da26f9p-1,-0x1.d1bc681d2d083p-2,0x1.62ba431afecd6p-2,-0x1.0fbf7f20ed411p-2,
    0x1.9e06fd856cad4p-3},{0x1.429af5936203fp+1,0x1.1072673a41e67p-53,-0x1.031c2baf99878p+1,0x1.5ee3ac1e7548ep+0,
    -0x1.e3e95b0ec82a5p-1,0x1.4f5ec183e6152p-1,-0x1.d1ba31be644dep-2,0x1.43a5aa5eead66p-2,-0x1.c201ac53c8501p-3,
    0x1.38ec3a9d5a981p-3,-0x1.b551d3ab2324bp-4,0x1.302a3e76c9a0cp-4},{0x1.24bd8ca4edf35p+1,-0x1.8574c89d67c66p-53,
    -0x1.b8a876dbb4244p+0,0x1.11ddc9dc6721ep+0,-0x1.5b222131a28bcp-1,0x1.ba716faeb26adp-2,-0x1.1a8dfa3d1fa82p-2,
    0x1.693bcb2262752p-3,-0x1.ce09dceb6ffddp-4,0x1.2790cf86a56c5p-4,-0x1.7bb8e4f12f164p-5,0x1.e5efa79c83858p-6},
    {0x1.0b2e90002018p+1,-0x1.27d840e354551p-54,-0x1.7b8abbfe5855cp+0,0x1.b3d5d0508b65bp-1,-0x1.ff03632b11f59p-2,
    0x1.2d62866127268p-2,-0x1.6453ba2b57515p-3,0x1.a5bb1fc98ba2cp-4,-0x1.f368105aab376p-5,0x1.27c8923d717b2p-5,
    -0x1.5fa256d12217bp-6,0x1.a0a4ada35d21cp-7},{0x1.ea17f64c89545p+0,-0x1.a80ab8942219fp-57,-0x1.4a832301332b7p+0,
    0x1.609526793bbbep-1,-0x1.8084581ce7a77p-2,0x1.a610e581e95fep-3,-0x1.d0755090f0b5ap-4,0x1.ffb4e8afcf228p-5,
    -0x1.1a0cb1d457d71p-5,0x1.3708849510298p-6,-0x1.5815ffb1ff62ap-7,0x1.7b913f0d132e2p-8},{0x1.c35bc17ee539ep+0,
    0x1.88b3d3e1265afp-54,-0x1.2290e7b3d0e78p+0,0x1.2159c7b711642p-1,-0x1.26ea7cecd7adfp-2,0x1.2ead0aea1cf89p-3,
    -0x1.377ec0bbfa559p-4,0x1.40fb8bcaea7fdp-5,-0x1.4afa84de345ap-6,0x1.556a1523acee7p-7,-0x1.612d18b40f8d3p-8,
    0x1.6c71cc7474eb1p-9},{0x1.91852a19c3d72p+0,-0x1.691edf54439b7p-59,-0x1.e665ed0fdda69p+0,0x1.b841668acf628p+0,
    -0x1.988c7db5e632ap+0,0x1.7e02216cfa6d5p+0,-0x1.66498d2e0ded2p+0,0x1.5086e8d28664fp+0,-0x1.3c523d4d70f06p+0,
    0x1.2977290ad1a3dp+0,-0x1.1a3f2517be78ep+0,0x1.098927684d2b4p+0},{0x1.5ae28aab5ab39p+0,0x1.2d3c97ef5d9fep-54,
    -0x1.88e23da0327dp+0,0x1.3cec236499c98p+0,-0x1.06a71c47ed684p+0,0x1.b7070f3e56a3p-1,-0x1.7031d99c74d8cp-1,
    0x1.354e8df3fa565p-1,-0x1.0410b3acfd09cp-1,0x1.b58ee73f1cc68p-2,-0x1.72c686f93e136p-2,0x1.38131cfeab39ep-2},
    {0x1.2e430af9e8d8fp+0,0x1.afe5cea71ca69p-55,-0x1.4473161a088b4p+0,0x1.d7cf34f7f5a8fp-1,-0x1.6123b788d378fp-1,
    0x1.0ac248acabf5bp-1,-0x1.9492dd841ab74p-2,0x1.335fc0ad2b176p-2,-0x1.d386dcb312fdep-3,0x1.63c7542d0ea6dp-3,
    -0x1.1061eb97bade3p-3,0x1.9ece7f2a5ebe4p-4},{0x1.09139b069be46p+0,0x1.887dfabcdb3bdp-54,-0x1.10d1a114ab3cfp+0,
    0x1.68efaa27751e4p-1,-0x1.ec75aaab7bbc7p-2,0x1.534fa9ba7c127p-2,-0x1.d5909b3872d9ep-3,0x1.45981047a6b45p-3,
    -0x1.c40c4dc13220fp-4,0x1.3a05d578c6297p-4,-0x1.b6895ef0ba7f3p-5,0x1.30d97edab90ccp-5},{0x1.d325317491affp-1,
    0x1.6ae1c941b7f4ep-57,-0x1.d1c0026c41a06p-1,0x1.1a7a62d121f7dp-1,-0x1.61fa02db45ca3p-2,0x1.c05254abf64fdp-3,
    -0x1.1d3706d3a1c83p-3,0x1.6bbce04dc79a9p-4,-0x1.d07882b0e2eb8p-5,0x1.28c71f1bb4e8ep-5,-0x1.7cf5e982b8784p-6,
    0x1.e738d90e5d0eep-7},{0x1.9d0519663e089p-1,-0x1.fee4c0477d97ep-55,-0x1.92a171dc222d2p-1,0x1.c2be7c2dceb35p-2,
    -0x1.0510e70b7622ap-2,0x1.31db703433ca7p-3,-0x1.681c58cba71fep-4,0x1.a90df78127f9fp-5,-0x1.f66a1d72d7fa1p-6,
    0x1.292dc0b1dad9cp-6,-0x1.60f57bf354531p-7,0x1.a1ebd3da3e686p-8},{0x1.6df9977f4006cp-1,0x1.c6bfdcfa1d02p-55,
    -0x1.5fdc05aebe125p-1,0x1.6d996adafb366p-2,-0x1.89aa6c086a56fp-3,0x1.acfd4329c518fp-4,-0x1.d5f58baa9c693p-5,
    0x1.021e7ee6662f5p-5,-0x1.1bf8677a50be4p-6,0x1.38b350d1717f9p-7,-0x1.5990b58bfdf42p-8,0x1.7ce679497d75p-9},
    {0x1.44ab375380192p-1,0x1.a3b128052876ep-55,-0x1.366312e0ee2d3p-1,0x1.2ccd41af4ec1ep-2,-0x1.2e874d50a83aap-3,
    0x1.341dbc42cc25fp-4,-0x1.3b92424b3d714p-5,0x1.44252dcf2b3abp-6,-0x1.4d803c7364d51p-7,0x1.5778e29f7055bp-8,
    -0x1.62e3feddeac5ep-9,0x1.6de4ee8a46e81p-10}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_zeta_approach_only)

/* linear and Tsuji, limited damper: (1 - eps)/zeta: 5 rows of degree 10 in y = zeta, nodes 0 + i 0.0625, 0 <= y <= 0.28125.
 * Relative error of the approximation: 2^-53.6 at most, sampled at 25 places of each row. Bits of the rows:
 * 58.0 53.6 56.5 55.1 58.2 */
#define COR_ROWS_RATIO_LOSS_LIMITED_FIRST 0.0
#define COR_ROWS_RATIO_LOSS_LIMITED_STEP 0.0625
#define COR_ROWS_RATIO_LOSS_LIMITED_PER_UNIT 16.0
#define COR_ROWS_RATIO_LOSS_LIMITED_ROWS 5
#define COR_ROWS_RATIO_LOSS_LIMITED_END 0.25
COR_ROWS(double, cor_rows_ratio_loss_limited, 5, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.921fb58p+1,-0x1.dde973dcb3b3ap-26,-0x1.1de9e64df22efp+3,0x1.34e0c98efc8f1p+4,-0x1.f663e68df537cp+4,
    0x1.767dd813abcb6p+5,-0x1.5bf363ca53c3dp+6,0x1.3683b391e2033p+7,-0x1.268a01bf9b63bp+7,0x1.e2faccc97ad6fp+5,
    -0x1.11266e6c73269p+9,0x1.a0fc9964a4396p+10},{0x1.536609p+1,0x1.7d3c267576885p-27,-0x1.b66246cba4abp+2,
    0x1.cab7784b230fap+3,-0x1.669ef9ce045e5p+4,0x1.b7c6bb3882bfep+4,-0x1.456abc7f3a13p+5,0x1.6db884b6f7a2ap+6,
    -0x1.26c690b6f2447p+7,0x1.23de6e65d5779p+4,0x1.02bc141339e84p+8,0x1.db009be6c9f74p+8},{0x1.231df08p+1,
    0x1.bace5398e6b59p-27,-0x1.52f7593520784p+2,0x1.563f70b10cfe7p+3,-0x1.0c2d9800a375fp+4,0x1.2ed116c1a6a2cp+4,
    -0x1.1af493b2e07cfp+4,0x1.1594ffc61de7fp+5,-0x1.91a53c2f00825p+6,0x1.2bdcee18d4bc8p+7,0x1.4902e83f08fecp+6,
    -0x1.434386f9bb9c8p+9},{0x1.fb35c8p+0,-0x1.baee2658fdf2bp-30,-0x1.08de4612c8aa4p+2,0x1.fd623d97d38c2p+2,
    -0x1.9316720d54618p+3,0x1.d7957f06b7f41p+3,-0x1.5b150eb9b255ep+3,0x1.bf04819172e45p+2,-0x1.e2470b69306f9p+4,
    0x1.ada5d468d672fp+6,-0x1.4a4d6d39f5391p+7,-0x1.2b3cb6dc82819p+6},{0x1.c03849p+0,-0x1.912b41e1e4c11p-27,
    -0x1.a38b949578e0ap+1,0x1.7ab5d911328bp+2,-0x1.2a0445772050dp+3,0x1.7300d76808cadp+3,-0x1.319d2e02e4026p+3,
    0x1.17c9b44595394p+1,0x1.317046b492f3bp+0,0x1.8b04b557b0729p+4,-0x1.971e4306b2a2fp+6,0x1.5ee1e7582bcf5p+7}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_loss_limited)

/* linear and Tsuji, limited damper: eps: 48 rows of degree 10 in y = zeta 2^-k, 8 rows in each octave k = -2 ... 3.
 * Relative error of the approximation: 2^-54.6 at most, sampled at 25 places of each row. Bits of the rows:
 * 59.5 59.9 60.8 59.1 59.2 58.8 59.9 61.1 58.5 58.7 59.3 58.3 59.5 63.9 60.1 59.1 57.4 58.4 59.4 59.1 59.8 61.8 59.9
 * 59.2 56.3 58.4 58.1 60.0 59.0 59.5 58.5 59.1 55.4 56.6 58.6 58.1 59.2 58.9 61.8 59.0 54.6 56.0 57.3 58.5 57.6 58.9
 * 60.1 59.5 */
#define COR_ROWS_RATIO_EPS_LIMITED_FIRST 0.25
#define COR_ROWS_RATIO_EPS_LIMITED_FIRST_OCTAVE (-2)
#define COR_ROWS_RATIO_EPS_LIMITED_OCTAVE_BITS 3
#define COR_ROWS_RATIO_EPS_LIMITED_ROWS 48
#define COR_ROWS_RATIO_EPS_LIMITED_END 16.0
COR_ROWS(double, cor_rows_ratio_eps_limited, 48, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.18a814f349ba5p-1,-0x1.a6274bae41a18p-55,-0x1.c16afbb73ba24p-3,0x1.a3a0ec4b6101dp-4,-0x1.9ae094c2e6f29p-5,
    0x1.6e966f8047694p-6,-0x1.0c0b912b5f8f5p-7,0x1.15d9a30098afdp-9,-0x1.b002925839dbp-13,-0x1.aebd07f0057c2p-14,
    0x1.e208ab29dc6dep-16,0x1.fbb5c55844bfp-16},{0x1.0b6265b67c264p-1,-0x1.b59286afdfca6p-59,-0x1.9170e33b1c924p-3,
    0x1.5e8ecd6e5308ep-4,-0x1.4909ce044282ep-5,0x1.22b4d272ce9a4p-6,-0x1.b4fdf7d57b0fp-8,0x1.f2389f2560595p-10,
    -0x1.2d796c7e4e1efp-12,-0x1.e164805adfe81p-15,0x1.7a04966eaa577p-15,-0x1.a0c21a353c602p-23},{0x1.fef8d0f0dce92p-2,
    0x1.4b0d87b85a82ep-56,-0x1.69359096dae4dp-3,0x1.272bbdccdb322p-4,-0x1.084f317413c35p-5,0x1.cac7482de876fp-7,
    -0x1.5e14763ed818cp-8,0x1.ab96cabe08426p-10,-0x1.500280a746cd7p-12,-0x1.554982f2e2afap-17,0x1.3207537a45bb3p-15,
    -0x1.7445b71014b21p-17},{0x1.e97cf98d69632p-2,0x1.1b163a214138ep-58,-0x1.4732f1cc4d545p-3,0x1.f52bc05c0dc5ap-5,
    -0x1.aa99a2221cb3ap-6,0x1.692fb112c3108p-7,-0x1.14cd8fcbd2707p-8,0x1.625560726c0dp-10,-0x1.480808783241p-12,
    0x1.7ab36cb251f2p-16,0x1.6b05c47d84cc4p-16,-0x1.855dcb1053b77p-17},{0x1.d5f7b7cb396b3p-2,-0x1.25c329798de22p-56,
    -0x1.2a358a2936c8p-3,0x1.ad0306fa1d53p-5,-0x1.5a4b4e3af57adp-6,0x1.1c616bab294d7p-7,-0x1.b1c92a007906ap-9,
    0x1.1df23f6d03dedp-10,-0x1.264c69dcf2afep-12,0x1.4a63d0f53592p-15,0x1.2d0c151f7e263p-17,-0x1.1a777db9e1136p-17},
    {0x1.c42096007cfp-2,-0x1.91d949fb03832p-58,-0x1.114b42ea6ae51p-3,0x1.723fa45412df5p-5,-0x1.1b02edfa58f5ap-6,
    0x1.c0bf0bdec4c0ap-8,-0x1.5208b07ee2235p-9,0x1.c4bbe7f56601ap-11,-0x1.f322a55b64feap-13,0x1.744eb5bbf51a2p-15,
    0x1.745b7eeb1d3b5p-21,-0x1.4a284c316544bp-18},{0x1.b3bc94aae0abbp-2,-0x1.d58225e8d5319p-56,-0x1.f76aa67ffda66p-4,
    0x1.420e0489fe63ep-5,-0x1.d1ffe715cef77p-7,0x1.635b946f07cacp-8,-0x1.06bf7a8ab2056p-9,0x1.61ab8aebfb82p-11,
    -0x1.975229cc85be8p-13,0x1.6355a391f23bap-15,-0x1.f1554cdcdcf3bp-19,-0x1.337cc48543b8p-19},{0x1.a49b536019b08p-2,
    -0x1.27cf964a33d94p-61,-0x1.d1b9eb66e10dap-4,0x1.1a3aeb9b0ffd2p-5,-0x1.829cc4f5589f2p-7,0x1.1ac964a1d5335p-8,
    -0x1.9865457fce01dp-10,0x1.11e9ee2baab0ap-11,-0x1.43c3f09fed3a7p-13,0x1.36656aaa3c0f2p-15,-0x1.6e26f12ca3f5bp-18,
    -0x1.6223deebf5503p-21},{0x1.8ff10a79ab492p-2,-0x1.d1073c6c3c81ep-59,-0x1.a179c4b6963ddp-3,0x1.d51a4bd5ad7d2p-4,
    -0x1.287613703665ap-4,0x1.95fab08f9f9p-5,-0x1.18d8a8ba62a5fp-5,0x1.7248341d7dabp-6,-0x1.bcafa58d00ca2p-7,
    0x1.cd343d37c704fp-8,-0x1.6e703c8e8ad6p-9,0x1.d329bc251d7d3p-12},{0x1.778c64d7b08a5p-2,0x1.632af5bd2d9c8p-56,
    -0x1.6d12351434281p-3,0x1.76860ebdcb2a8p-4,-0x1.ab7108bd472acp-5,0x1.0b24c5eacafa6p-5,-0x1.59ab4f4d9bcaap-6,
    0x1.b63c257941f13p-7,-0x1.0545d0d90dfbbp-7,0x1.1a7c88280e1fdp-8,-0x1.06574e4c9785ap-9,0x1.6a13f19809be4p-11},
    {0x1.6218fec8132cbp-2,-0x1.958b47c8c4f39p-57,-0x1.42ca86798787cp-3,0x1.3164f27754e16p-4,-0x1.3d192463780bcp-5,
    0x1.69c25b72a5d4ap-6,-0x1.b2ca988656p-7,0x1.05c75a42a23cap-7,-0x1.2fb2c8251cd2dp-8,0x1.495c0008e32eep-9,
    -0x1.4386ce5664169p-10,0x1.0e9e2ebddc3c6p-11},{0x1.4f0b3a3e62719p-2,0x1.f42d842de2675p-56,-0x1.20028c0841ac1p-3,
    0x1.faedbc13db0cp-5,-0x1.e2c1a7043372ap-6,0x1.f8033197e4e0cp-7,-0x1.1865f70078e6ap-7,0x1.3e353a3d556dp-8,
    -0x1.62ab442f5bb1p-9,0x1.7997a0f5c7162p-10,-0x1.776803ca001c8p-11,0x1.50594d259bcf3p-12},{0x1.3dfa5df3576e7p-2,
    -0x1.fdfad3d4023bbp-56,-0x1.02edde077dfdcp-3,0x1.aafcf424fce83p-5,-0x1.77e4d80ec36fp-6,0x1.68b77672a099cp-7,
    -0x1.734bf602341fap-8,0x1.8b3fe272748b7p-9,-0x1.a3d5c368471d1p-10,0x1.b11f8bca00d5cp-11,-0x1.a9d1bb304cac5p-12,
    0x1.84fdf0bc2be8cp-13},{0x1.2e95e8e0da623p-2,-0x1.dc97c5449c8f6p-57,-0x1.d49055291a72cp-4,0x1.6c237687f79c4p-5,
    -0x1.2a7ddd5c8abadp-6,0x1.08ac95cf1331bp-7,-0x1.f8a808fd00d18p-9,0x1.f6af98cf03f18p-10,-0x1.fa3d112311f21p-11,
    0x1.f5f21c4fbc0ffp-12,-0x1.e1683a33ab44p-13,0x1.b56d962c8803fp-14},{0x1.209ea0edcebd1p-2,0x1.78987f5282f65p-57,
    -0x1.aa4dcaa432532p-4,0x1.39cfbb6e287c7p-5,-0x1.e2268ffb394abp-7,0x1.8d414f85e6d81p-8,-0x1.5fa46f0b6bb89p-9,
    0x1.4780ea4a6d31cp-10,-0x1.37b4fdca62bd5p-11,0x1.27778dc78b628p-12,-0x1.12208fc3d2f0cp-13,0x1.e89d0f4008239p-15},
    {0x1.13e1effb2daeap-2,0x1.644336a0b4973p-56,-0x1.85b89a9502412p-4,0x1.10ded93b56dfep-5,-0x1.8b202e0acbee2p-7,
    0x1.302db6f038f1p-8,-0x1.f5a9a31630e75p-10,0x1.b512591d2b425p-11,-0x1.887750a48db77p-12,0x1.626e5f46d37a1p-13,
    -0x1.3c616a56385aep-14,0x1.1233b63c1da03p-15},{0x1.02bcd2b306fecp-2,0x1.17a2ec85f11c5p-56,-0x1.574f5674caab6p-3,
    0x1.c0cfec437d66bp-4,-0x1.2bf8478d349cdp-4,0x1.a52b51ce13b31p-5,-0x1.3a87e7385daf4p-5,0x1.f150951457d8cp-6,
    -0x1.98d59165bacfap-6,0x1.5611da736a385p-6,-0x1.1fc3b2da5057bp-6,0x1.d9a2985bc0688p-7},{0x1.ddcc61dfcf35ep-3,
    -0x1.b895157789acap-57,-0x1.25808d74f365bp-3,0x1.61645eff58694p-4,-0x1.ae481d29882d3p-5,0x1.0f58da6038ef3p-5,
    -0x1.6814f95f6023ap-6,0x1.f858e1a605fb9p-7,-0x1.7167e346419e6p-7,0x1.1673eabb921abp-7,-0x1.ab2d9274d5155p-8,
    0x1.45126ebfae50ap-8},{0x1.bbad3a8247fb4p-3,-0x1.f8bcc4de3d5a4p-58,-0x1.fbc7d1102d783p-4,0x1.1be149873708dp-4,
    -0x1.3e7fdad3056ccp-5,0x1.6e25aff6c4c01p-6,-0x1.b6229912e4f9bp-7,0x1.12efbcf0286d4p-7,-0x1.690a8aecf1051p-8,
    0x1.eafaa0f42f6f9p-9,-0x1.569df67612f4cp-9,0x1.dfaa5b93f031ep-10},{0x1.9e035988914c2p-3,-0x1.198fe7f9cb1c3p-57,
    -0x1.bb9f0fe85dddcp-4,0x1.cf9283e7b0a3bp-5,-0x1.e376968cc3e87p-6,0x1.002f541503e13p-6,-0x1.17f7f0f8a6724p-7,
    0x1.3e8288fdd0ef5p-8,-0x1.7a0ae7dce85eap-9,0x1.d1b5495a1952ap-10,-0x1.27f2d7e7bde69p-10,0x1.7c8af975fbd1fp-11},
    {0x1.83fca3555739cp-3,-0x1.4daeaf3c84152p-58,-0x1.86e11f537d135p-4,0x1.7fb25914b8026p-5,-0x1.767e030ae8c0ap-6,
    0x1.711fc5539c032p-7,-0x1.744b070648d2cp-8,0x1.840aa872e946ap-9,-0x1.a4011cc95c15p-10,0x1.d783b83ec5d66p-11,
    -0x1.11bbd71331b1bp-11,0x1.438337c2c4113p-12},{0x1.6cf8371f9aa8ap-3,0x1.1743b0c516a5dp-57,-0x1.5af8c4ddd821ep-4,
    0x1.414d8ccae0151p-5,-0x1.270f8e74bbc3bp-6,0x1.10602e790d336p-7,-0x1.ff650a8a936b9p-9,0x1.ece314bb42cbfp-10,
    -0x1.eab92a684b9dbp-11,0x1.f97a39734a25dp-12,-0x1.0d4dddbdca507p-12,0x1.2535e6a2ffe03p-13},{0x1.587888b2afa4ap-3,
    -0x1.c63fef8b349a1p-58,-0x1.3604d23633ecap-4,0x1.0fca5badd54d1p-5,-0x1.d7bdaafeb2398p-7,0x1.9a1c04eff1f19p-8,
    -0x1.68d058b3dba88p-9,0x1.441790d3669e7p-10,-0x1.2b29110d90fap-11,0x1.1cb5f9bbfa95bp-12,-0x1.17e551d84c584p-13,
    0x1.19b17aa08cc7fp-14},{0x1.461a0a5e5a9c3p-3,0x1.8be015bb43fe8p-57,-0x1.169f2cd944f73p-4,0x1.cfeddecb06462p-6,
    -0x1.7ddf05f5ac86fp-7,0x1.3a0ff5061427ap-8,-0x1.04675b7d608ebp-9,0x1.b6d2d59efbc19p-11,-0x1.7a2d84fe392f2p-12,
    0x1.4ebc95567dfcfp-13,-0x1.31517ec8d6553p-14,0x1.1d32ac009390ap-15},{0x1.2ddfa4f03d98cp-3,-0x1.01e207d56015cp-57,
    -0x1.df61e8532d42ap-4,0x1.732c2762c1ec8p-4,-0x1.1bd1f4b5860a2p-4,0x1.b08298ba2f15cp-5,-0x1.4ad7fbd7cd002p-5,
    0x1.ff90cd4c0d3fdp-6,-0x1.9217ebf91b8a2p-6,0x1.42cce1fc2656bp-6,-0x1.0b45f483fe7dfp-6,0x1.c250569ba0899p-7},
    {0x1.128f156a0e04bp-3,0x1.8f5feaff3e7b2p-57,-0x1.8e62843c204e7p-4,0x1.1a31c9a97223ep-4,-0x1.8a912cc5bb92ep-5,
    0x1.12434fbe17777p-5,-0x1.7d6017e81ae1ep-6,0x1.0aa76dd242c0ap-6,-0x1.78d3e11a6a0fap-7,0x1.0e3d453e641e7p-7,
    -0x1.8ce2fc2cb8359p-8,0x1.27c3a8d00d0d5p-8},{0x1.f75fdfe315f17p-4,-0x1.77ad61e7b2ea2p-59,-0x1.501e2be00f8bcp-4,
    0x1.b6d932bd51644p-5,-0x1.1ab9d968a3dd2p-5,0x1.69c3aa603e1eep-6,-0x1.cdf7f5f59cc97p-7,0x1.27a778be0a678p-7,
    -0x1.7cd6fa67db5fp-8,0x1.ef86b38f3f04bp-9,-0x1.4822dd850c57bp-9,0x1.b78e891779931p-10},{0x1.d0885a73ff3e3p-4,
    -0x1.b4085fade686p-58,-0x1.1f3ef51ca4f1fp-4,0x1.5bc57713fda96p-5,-0x1.9f9b21b8a419ep-6,0x1.eceab7cc174cp-7,
    -0x1.234f1ee0e843p-7,0x1.586274330cd3fp-8,-0x1.988c8412ab83fp-9,0x1.e7de218a05c0ap-10,-0x1.27228b582daacp-10,
    0x1.680c149dbbd77p-11},{0x1.af27a95e80d6ep-4,0x1.65e3d7c05fecep-60,-0x1.f068a0a95fae1p-5,0x1.181e4a89d236ap-5,
    -0x1.3829677579093p-6,0x1.59241d9ef9811p-7,-0x1.7bfa19b883cb3p-8,0x1.a1cf5e39b47d7p-9,-0x1.cc19dd6829247p-10,
    0x1.fcbff07608d59p-11,-0x1.1bfe776be3f52p-11,0x1.3edf2e282f03cp-12},{0x1.922cdc92daaa8p-4,0x1.b005ed37221c5p-59,
    -0x1.b1132a1ff4b3ap-5,0x1.c9ac6bb6ccb29p-6,-0x1.ddccfb42f058bp-7,0x1.eedc52a1e0049p-8,-0x1.fe13ed086292fp-9,
    0x1.064ea8c134082p-9,-0x1.0dd1b77192cb9p-10,0x1.16302c268eabep-11,-0x1.20d84f59612dfp-12,0x1.2d042c314e10dp-13},
    {0x1.78c94a74df75bp-4,0x1.3ad5eedadf18dp-59,-0x1.7d048bed0b51fp-5,0x1.7a8c8b32adf59p-6,-0x1.73b5c2330af82p-7,
    0x1.6a1f01ae062e7p-8,-0x1.5efcab2aca6b2p-9,0x1.533d39c2fd9bcp-10,-0x1.479dd22b3ddd9p-11,0x1.3cb7f06b9485p-12,
    -0x1.33c0cc6f9a1bfp-13,0x1.2bafe8a3ba5fep-14},{0x1.625da8544334cp-4,0x1.3d19e9bf5c882p-59,-0x1.51b9f826575e3p-5,
    0x1.3c8e25a1734b4p-6,-0x1.2564a6aef1007p-7,0x1.0dd2011646b67p-8,-0x1.edaf7c83c47c1p-10,0x1.c2305920bf02dp-11,
    -0x1.99ea5f032eee7p-12,0x1.75490e7df7622p-13,-0x1.552d150942929p-14,0x1.38253d070518ap-15},{0x1.45437fb43dc22p-4,
    -0x1.0b7e96204e02bp-58,-0x1.1d4e30ab2d436p-4,0x1.eceead0105be4p-5,-0x1.a55de0f8cd6d8p-5,0x1.65807e993470cp-5,
    -0x1.2db63829d697fp-5,0x1.fb6f2d9f2af1p-6,-0x1.a9ccdf09b5974p-6,0x1.65029ab732eedp-6,-0x1.2d887e31f3889p-6,
    0x1.faa39d3f5e6e4p-7},{0x1.25145a827752cp-4,-0x1.5124d25b5dp-62,-0x1.d0a9cca5f1242p-5,0x1.6b5a30465b4f5p-5,
    -0x1.19673c1b37d6dp-5,0x1.b0cf0a81b1c8dp-6,-0x1.4b1c34872927fp-6,0x1.f8b5a4025b67ap-7,-0x1.7faa94abf8561p-7,
    0x1.23348cbda12dcp-7,-0x1.bc4a17d444004p-8,0x1.511ef087d14e2p-8},{0x1.0aa0445eef15bp-4,-0x1.478a15fb5687ap-59,
    -0x1.8181b20bbf66fp-5,0x1.1349bbd545b51p-5,-0x1.85b3b89405f08p-6,0x1.1204d231cd96ep-6,-0x1.7f6d96e43c4b9p-7,
    0x1.0b3fa23f95c3fp-7,-0x1.73816baf4778dp-8,0x1.01b8fd7fc6f58p-8,-0x1.66d83f6506c1ap-9,0x1.f1151c544cbf8p-10},
    {0x1.e903ec4b7a409p-5,0x1.e85c01e42a912p-59,-0x1.44da915684b97p-5,0x1.aad192e0f04ccp-6,-0x1.161fddf54628p-6,
    0x1.683c65a6dd7cp-7,-0x1.d05e9ac47c407p-8,0x1.2a324d7a5989p-8,-0x1.7de307d51146fp-9,0x1.e808fd4921f9dp-10,
    -0x1.38a007faef5e8p-10,0x1.8e941044e424dp-11},{0x1.c37deac99eb0bp-5,-0x1.de777d8b9b9f9p-59,-0x1.15618aa72d07ep-5,
    0x1.5162cea2c84acp-6,-0x1.974ef723d6589p-7,0x1.e8e620e025732p-8,-0x1.2417d5f6cda4fp-8,0x1.5bc680825186dp-9,
    -0x1.9ce7075813824p-10,0x1.e92731c0df7dbp-11,-0x1.224118f9d39e4p-11,0x1.56e4b4d86a7bcp-12},{0x1.a3452308647d7p-5,
    -0x1.fbbb41205b1e8p-59,-0x1.df16ba3535335p-6,0x1.0f312e5b086f2p-6,-0x1.30e6b9e626ccbp-7,0x1.54f5dfaa4c079p-8,
    -0x1.7ba82c457f403p-9,0x1.a54b6de0cfa28p-10,-0x1.d2349a0dd235ap-11,0x1.01620f7dfea68p-11,-0x1.1c8aa8a5a13a1p-12,
    0x1.3939a5af679efp-13},{0x1.874e7a7557acdp-5,0x1.eed439a0a8cadp-61,-0x1.a1d30c445b53ap-6,0x1.ba59c9bc7e0adp-7,
    -0x1.d15124e3372dcp-8,0x1.e7040a1d93d5fp-9,-0x1.fbab6e8f7f445p-10,0x1.07bb34f2f737p-10,-0x1.11471cff7f189p-11,
    0x1.1a8d17396278fp-12,-0x1.24619ea2cf4a7p-13,0x1.2d5931c5a84bap-14},{0x1.6ed057a133d38p-5,0x1.e28ec2dadea4fp-59,
    -0x1.6f8b37f029cddp-6,0x1.6d63b38f24369p-7,-0x1.69152f7d392bap-8,0x1.632523c18e1b4p-9,-0x1.5bf8deb1ab797p-10,
    0x1.53e036f983d4ap-11,-0x1.4b1b72e95c764p-12,0x1.41dfb3555092dp-13,-0x1.39100c5bc1e87p-14,0x1.2f5bdd0c1f377p-15},
    {0x1.4f4baedf6f8c3p-5,-0x1.3b6b5afdf8597p-60,-0x1.33812b8440fbap-5,0x1.180b86c2ed083p-5,-0x1.fb5523b97d618p-6,
    0x1.c99217921fb82p-6,-0x1.9b3d5352fd7eep-6,0x1.7085651cb81ddp-6,-0x1.496cf1bae66dp-6,0x1.25e0c784c7338p-6,
    -0x1.07bf50d3f90b1p-6,0x1.d512d2574912ep-7},{0x1.2cc9bd0398ee9p-5,0x1.c6497d650eb93p-59,-0x1.efa2a94723e34p-6,
    0x1.95df176136e8cp-6,-0x1.4acb09735dcd8p-6,0x1.0c92ab82d6ed9p-6,-0x1.b2bbe07f63dbbp-7,0x1.5ee9dc737b244p-7,
    -0x1.1a9cac037536fp-7,0x1.c656cedc0dd28p-8,-0x1.6ee73f31d9de2p-8,0x1.2604c87abfde9p-8},{0x1.10b03cfff81d1p-5,
    -0x1.65455b18506b4p-59,-0x1.97cfd42fa6a47p-6,0x1.2f51ece8e51c8p-6,-0x1.c14f886d7ea04p-7,0x1.4ba53da1974d7p-7,
    -0x1.e830ce0e477a8p-8,0x1.6671c984a3ceep-8,-0x1.06a1cc192b1ecp-8,0x1.802c9c8f4d766p-9,-0x1.1a0216d22bb7ap-9,
    0x1.9b508517a5c34p-10},{0x1.f2bcf0e2e2b51p-6,0x1.975b6c8c6e9bcp-60,-0x1.5559e9694984dp-6,0x1.d10dddef8e8c7p-7,
    -0x1.3b9ad3ec1a825p-7,0x1.ab0b309294984p-8,-0x1.202a9668f0f98p-8,0x1.840b3ddb07b6bp-9,-0x1.04c477a914b2ep-9,
    0x1.5de464c0ce375p-10,-0x1.d6d931a8d7e4ap-11,0x1.3b04ca37cdd8ep-11},{0x1.cb6b1003d7713p-6,-0x1.7b5faf14d47a3p-60,
    -0x1.21dcba59995ap-6,0x1.6c393f273c22bp-7,-0x1.c81dbbee70713p-8,0x1.1ccc4685abd4ap-8,-0x1.62d0113f9f87ep-9,
    0x1.b92400a6015f1p-10,-0x1.11bff227d0d56p-10,0x1.5339bf32fdc05p-11,-0x1.a55b55def7019p-12,0x1.0464d4758e095p-12},
    {0x1.a9d308621191dp-6,0x1.26b73589c833fp-61,-0x1.f2586497acb4ap-7,0x1.2280571e88f81p-7,-0x1.51a61800c922fp-8,
    0x1.8772b5a0fe8a9p-9,-0x1.c4d5c34969145p-10,0x1.056ee58bc4e81p-10,-0x1.2d5e4292aa48ap-11,0x1.5ae71c4931aa2p-12,
    -0x1.901797d4e6e5cp-13,0x1.cb6cbc077de0dp-14},{0x1.8ccb281df9247p-6,0x1.c7867023aa1d4p-60,-0x1.b0eec0acfefc2p-7,
    0x1.d6bd5d41bbc8fp-8,-0x1.fe6c0f9a93b26p-9,0x1.14143a2bb278p-9,-0x1.2a0e9756bafa7p-10,0x1.413a03f478d6fp-11,
    -0x1.59ab51aa1834ap-12,0x1.737897ddc0a69p-13,-0x1.8fd71041d18d8p-14,0x1.acb4600cfc728p-15},{0x1.737517f009865p-6,
    0x1.653e3e51cac94p-60,-0x1.7b93144ae7ea3p-7,0x1.82a7df06ddb16p-8,-0x1.88dd50a2fceb9p-9,0x1.8e50ec3a37b8bp-10,
    -0x1.93193060598e2p-11,0x1.974825f16282fp-12,-0x1.9aec8f5920e4dp-13,0x1.9e13a8f6a6918p-14,-0x1.a1d022c7d7a78p-15,
    0x1.a41d48e6e551fp-16}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_eps_limited)

/* linear and Tsuji, limited damper: zeta/(1 - eps), 1 - eps < 1/2: 17 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.03125, 0 <= y <= 0.515625.
 * Relative error of the approximation: 2^-58.4 at most, sampled at 25 places of each row. Bits of the rows:
 * 59.7 60.4 62.4 60.0 64.2 62.4 60.8 60.4 59.7 60.2 58.9 62.6 59.5 59.4 58.6 59.5 58.4 */
#define COR_ROWS_RATIO_NEAR_ZETA_LIMITED_FIRST 0.0
#define COR_ROWS_RATIO_NEAR_ZETA_LIMITED_STEP 0.03125
#define COR_ROWS_RATIO_NEAR_ZETA_LIMITED_PER_UNIT 32.0
#define COR_ROWS_RATIO_NEAR_ZETA_LIMITED_ROWS 17
#define COR_ROWS_RATIO_NEAR_ZETA_LIMITED_END 0.5
COR_ROWS(double, cor_rows_ratio_near_zeta_limited, 17, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.45f307p-2,-0x1.1b1bbead603d9p-29,0x1.2713b2c87dp-2,0x1.4b513e0af5ed2p-2,0x1.8b9d127a397ep-2,
    0x1.d8265515b6779p-2,0x1.10ed4e66e447cp-1,0x1.2ae428baf76f1p-1,0x1.2e4e185d889b1p-1,0x1.0e892c7827a6dp-1,
    0x1.828b0ee210388p-2,0x1.c7bf906a22c0cp-4},{0x1.4f81ae8p-2,0x1.97f9fea1acc92p-30,0x1.3d00ef83a68e6p-2,
    0x1.7359208617af8p-2,0x1.cc594eb74a205p-2,0x1.1b708f9e4729dp-1,0x1.4fa7995649d4cp-1,0x1.74ec9e4e8fbcfp-1,
    0x1.78ed36f0a5077p-1,0x1.470d94aa277ccp-1,0x1.9bacedeae5407p-2,0x1.28b3aca247afdp-6},{0x1.59ca4ap-2,
    -0x1.2f13764276954p-29,0x1.55a2566b676c1p-2,0x1.a20b1f129ebfap-2,0x1.0d1f7ea2241e8p-1,0x1.55c6114347177p-1,
    0x1.9de43d9d4b64dp-1,0x1.d0d8973537738p-1,0x1.d1e1104602e44p-1,0x1.7ff4b203c6078p-1,0x1.808483a35625ap-2,
    -0x1.b37576eadaa37p-3},{0x1.64e44p-2,0x1.c6e55c7e00d1fp-29,0x1.716d21f8492fdp-2,0x1.d8c693d28fb7dp-2,
    0x1.3c2fc34c616b2p-1,0x1.9dc70820b83bap-1,0x1.ff485b344b64bp-1,0x1.20dc40be66fbap+0,0x1.1c09bfdcc39aep+0,
    0x1.aea4cf66426f2p-1,0x1.00005bc7968ddp-2,-0x1.405c106f77bc9p-1},{0x1.70eb018p-2,-0x1.12d5147fbfc92p-31,
    0x1.90eefce21c8dfp-2,0x1.0c9e9613f4943p-1,0x1.7546286129111p-1,0x1.f6c396aa6ff59p-1,0x1.3c00805f97858p+0,
    0x1.65021da4fea01p+0,0x1.536853af773c9p+0,0x1.c05a23083e772p-1,-0x1.458d8d1dcae45p-5,-0x1.443e6ea686876p+0},
    {0x1.7dfedfp-2,0x1.4cb727661042ap-29,0x1.b4d3c16f4ca7ap-2,0x1.32c36951fa6d3p-1,0x1.bac02c1121cd7p-1,
    0x1.325d43aeaccb1p+0,0x1.8647e011a79cep+0,0x1.b5490e5063ceep+0,0x1.89bc569c164dbp+0,0x1.986cc52d70026p-1,
    -0x1.1ea9c2d437926p-1,-0x1.092d441dc9d42p+1},{0x1.8c46198p-2,0x1.533e1ccee82bep-29,0x1.ddec978cbcb1cp-2,
    0x1.601cd55bf8805p-1,0x1.07c3385e856fcp+0,0x1.762f4d3b1d1ebp+0,0x1.e0ac8c2cfae34p+0,0x1.08425dba2087fp+1,
    0x1.b5a557a90be5p+0,0x1.13fce66f3cf9ap-1,-0x1.4fc66e43eedddp+0,-0x1.50d8de3738ee2p+1},{0x1.9bee2c8p-2,
    -0x1.2d7f2c45e062cp-29,0x1.069c5a152a42ep-1,0x1.96431c16bd8bp-1,0x1.3b9130b308f4ep+0,0x1.c981e09216275p+0,
    0x1.2677ea4c89f57p+1,0x1.398425ee23ae9p+1,0x1.c9eae059e12bep+0,0x1.e26dc4dea0bdep-5,-0x1.06ae9af1be47dp+1,
    -0x1.ae1f89552ea37p+0},{0x1.ad2d67p-2,0x1.ad07b56e5aa87p-29,0x1.21f7fce9e6168p-1,0x1.d72b9d8d44935p-1,
    0x1.7ae7a635d6f83p+0,0x1.1799d5b3828eap+1,0x1.65eda3a32bc5fp+1,0x1.6b1b0ba2b78ep+1,0x1.ba671a17ffa5bp+0,
    -0x1.13cb5ec687dfap-1,-0x1.e57b7cee647a8p+0,0x1.e79da2ea9a0fdp+1},{0x1.c044e58p-2,0x1.18ba333ca1009p-29,
    0x1.41c7d644a60a3p-1,0x1.129cfbb23ac5fp+0,0x1.c840eebf0a05dp+0,0x1.5513b79b6abcdp+1,0x1.ae67b2f34396ap+1,
    0x1.9922822ce6d2dp+1,0x1.8cfa6956e24d6p+0,-0x1.7610038c28de5p-1,0x1.68dd23c4369bcp+0,0x1.3b9ec2b30e516p+4},
    {0x1.d582f38p-2,0x1.ec96fc2194666p-34,0x1.66f4a71cc47ecp-1,0x1.41a89c9034578p+0,0x1.133888803d7a8p+1,
    0x1.9e872ba385d6cp+1,0x1.ff12a51c76b94p+1,0x1.c316e460a2f8ap+1,0x1.837ff3f1fcb8dp+0,0x1.e3247e143e48p-1,
    0x1.8e0a1e5fe1d89p+3,0x1.b61f31020164fp+5},{0x1.ed45f18p-2,0x1.1dba72b831fe7p-30,0x1.9299c981cc548p-1,
    0x1.7a7204f08d2d4p+0,0x1.4c4f57151c72cp+1,0x1.f536a11dd74b4p+1,0x1.2c0a9703cadf8p+2,0x1.f67f21191ad56p+1,
    0x1.375a11943c26cp+1,0x1.e749957a0b359p+2,0x1.32fc1b915a862p+5,0x1.cd83410d4f4d2p+6},{0x1.03ffe48p-1,
    0x1.80aa1fa557124p-28,0x1.c60ea53c1f496p-1,0x1.bf02184671c1bp+0,0x1.912414776c9dcp+1,0x1.2d60cd78f318cp+2,
    0x1.5f8802edd7581p+2,0x1.32921853bd4c6p+2,0x1.8af585242143ep+2,0x1.889c7b325d665p+4,0x1.58b621fe05f2dp+6,
    0x1.7c3a6d2a003d3p+7},{0x1.131d008p-1,-0x1.153fae3ebc5b8p-28,0x1.01789cec4f2cap+0,0x1.08dde32083cf5p+1,
    0x1.e3c2135162bc1p+1,0x1.695876a375983p+2,0x1.a48e22f5ed269p+2,0x1.c49fed451e59ap+2,0x1.01516ec374455p+4,
    0x1.cf6a921b6d6fp+5,0x1.32c6d2bc23cf3p+7,0x1.c6382b200c134p+7},{0x1.244d418p-1,0x1.b630ece4c73d3p-29,
    0x1.25994c673fe4fp+0,0x1.3ab987bcf64c4p+1,0x1.2378cb77a1babp+2,0x1.b312f84605bc2p+2,0x1.0b139a0069ea9p+3,
    0x1.9393cf6a3c55dp+3,0x1.260f8dce7e494p+5,0x1.b9beaf6fa7a16p+6,0x1.af1d444d89774p+7,0x1.2606f1c22b2dp+7},
    {0x1.37f4aap-1,-0x1.c4dc0841557bcp-28,0x1.509410228ffdfp+0,0x1.76d3a16a2e4a3p+1,0x1.5fa8127d5f943p+2,
    0x1.0ab2d2fb5a5f2p+3,0x1.75c486bb47296p+3,0x1.83f95b091be35p+4,0x1.215c48d3f88c7p+6,0x1.5e3bcf7b05e13p+7,
    0x1.d568c85cf98c5p+7,-0x1.5b8446b259c7fp+4},{0x1.4e8bdp-1,0x1.14b0027961e7p-28,0x1.83d42106fa54p+0,
    0x1.bf85253117c57p+1,0x1.aac0bfb936348p+2,0x1.53573fde1a05fp+3,0x1.2099e998981b2p+4,0x1.6ba5bec2c8f22p+5,
    0x1.f0f8ec6ed4c3p+6,0x1.df6d4e4b2033cp+7,0x1.cd1fd5c71243dp+7,0x1.7fc1f9cabb982p+6}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_near_zeta_limited)

/* linear and Tsuji, limited damper: zeta by eps, 2^-5 <= eps < 2^-1: 32 rows of degree 10 in y = eps 2^-k, 8 rows in each octave k = -5 ... -2.
 * Relative error of the approximation: 2^-53.5 at most, sampled at 25 places of each row. Bits of the rows:
 * 54.0 55.5 57.3 59.0 57.7 59.1 59.5 59.4 54.0 55.4 57.1 57.9 57.8 58.2 59.0 60.1 53.6 55.6 57.1 57.4 58.2 57.3 61.0
 * 58.9 53.5 55.4 56.9 56.5 58.8 56.8 57.6 57.6 */
#define COR_ROWS_RATIO_ZETA_LIMITED_FIRST 0.03125
#define COR_ROWS_RATIO_ZETA_LIMITED_FIRST_OCTAVE (-5)
#define COR_ROWS_RATIO_ZETA_LIMITED_OCTAVE_BITS 3
#define COR_ROWS_RATIO_ZETA_LIMITED_ROWS 32
#define COR_ROWS_RATIO_ZETA_LIMITED_END 0.5
COR_ROWS(double, cor_rows_ratio_zeta_limited, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.50ddd2229a045p+3,0x1.0d27963005403p-53,-0x1.43060007f711fp+3,0x1.2e681020b3e99p+3,-0x1.1c4a0e39febcap+3,
    0x1.0b781d702681ep+3,-0x1.f765279b24a26p+2,0x1.d9bf6cce9c526p+2,-0x1.bdd96a28f12cdp+2,0x1.a39c93c1c52f1p+2,
    -0x1.8e5e1adb9662bp+2,0x1.76edf94068496p+2},{0x1.2cb78273e719ep+3,-0x1.722aa52261c76p-53,-0x1.02ed699199a31p+3,
    0x1.b16714d028305p+2,-0x1.6c75c5c95708fp+2,0x1.32c6a7655cc4cp+2,-0x1.0249ee556aee3p+2,0x1.b2f8aea841c61p+1,
    -0x1.6e4409dcc41f3p+1,0x1.346c8ba1d84c6p+1,-0x1.0587e3603f512p+1,0x1.b8775517e3bep+0},{0x1.0f6a327df22fbp+3,
    0x1.7df86eea12c2bp-51,-0x1.a878a9318f99fp+2,0x1.4123a7facefb2p+2,-0x1.e88b1215662fap+1,0x1.74059521abde6p+1,
    -0x1.1b6137eb081c8p+1,0x1.afc4401685b73p+0,-0x1.48f087d9af4edp+0,0x1.f5387e958a8dfp-1,-0x1.800c924b88d2p-1,
    0x1.249a722e3b579p-1},{0x1.ee5a59201f315p+2,0x1.ca545a6b7d12p-52,-0x1.6256b5b27e71bp+2,0x1.e91d3e72657aap+1,
    -0x1.53987c894a244p+1,0x1.d82d89ca464eep+0,-0x1.48617e9299073p+0,0x1.c8d05ca2e4ec3p-1,-0x1.3dc17e95782a8p-1,
    0x1.ba12c07d015cp-2,-0x1.34fab33162eb6p-2,0x1.addfdc0de3485p-3},{0x1.c593a06f25ee6p+2,-0x1.ced1797efe0a7p-53,
    -0x1.2c53c3a7be228p+2,0x1.7d10a2a976f52p+1,-0x1.e6ae2bbb60a9fp+0,0x1.373e1f12af0bcp+0,-0x1.8e42d1388e95dp-1,
    0x1.fdb09ffbf308cp-2,-0x1.462b44e563f9bp-2,0x1.a178cfea2036dp-3,-0x1.0c3e9df6df566p-3,0x1.575804ea19677p-4},
    {0x1.a2caf44192b7fp+2,-0x1.2e92b84e876a2p-53,-0x1.01d84bccc25ep+2,0x1.2eaac044e5caap+1,-0x1.65d01b65a5436p+0,
    0x1.a7b5d4c17915cp-1,-0x1.f5fc3fb6c9d51p-2,0x1.296a5ec9cc9cep-2,-0x1.6073c42c5767dp-3,0x1.a1b14bd278142p-4,
    -0x1.f0b95412607b8p-5,0x1.26587c147942p-5},{0x1.84c39b44d911cp+2,-0x1.1483f3a5c656ap-55,-0x1.bfa6ee86dbe39p+1,
    0x1.e8cfa24a6f465p+0,-0x1.0ced1055a9acep+0,0x1.2874d22cead8bp-1,-0x1.46fb7508d1894p-2,0x1.68ba555676e62p-3,
    -0x1.8dfe20d80df7ep-4,0x1.b7212d982b8e2p-5,-0x1.e5f9d6f242ac4p-6,0x1.0c1d6869672dap-6},{0x1.6a928909cb3dep+2,
    0x1.1f454520ef37ap-52,-0x1.885219a9b8b84p+1,0x1.906a050480d81p+0,-0x1.9c077dea63016p-1,0x1.a8da85fd8650cp-2,
    -0x1.b6579a3f5b369p-3,0x1.c45e15d4939afp-4,-0x1.d2e4165241742p-5,0x1.e1e8863412177p-6,-0x1.f2b89d6fa2a35p-7,
    0x1.0164ca3ca8e0dp-7},{0x1.490084ba77691p+2,-0x1.48395d1e98e4p-53,-0x1.46dbc52e50a9cp+2,0x1.2fc8e6e3f590ep+2,
    -0x1.1cdf51684de18p+2,0x1.0bc50a3759871p+2,-0x1.f7bd95b1ab606p+1,0x1.d9f6e6cde8217p+1,-0x1.bdfe85e835fdcp+1,
    0x1.a3b6a0e849a9ep+1,-0x1.8e713179af412p+1,0x1.76fc4ba4dc44bp+1},{0x1.2464b99d3448dp+2,-0x1.2048afa14a35dp-56,
    -0x1.06716af59bbbap+2,0x1.b3c5b0c1e6ab3p+1,-0x1.6d5f4cf4dcf79p+1,0x1.3334152a223d5p+1,-0x1.0282924762ce5p+1,
    0x1.b33876ef07ee8p+0,-0x1.6e6a411201685p+0,0x1.34848db1348ebp+0,-0x1.05979b2cb1941p+0,0x1.b88c6d53db9b1p-1},
    {0x1.06ab6f87578e3p+2,-0x1.f5c43121c5692p-53,-0x1.aef32ccadf60ap+1,0x1.4333f3625c62bp+1,-0x1.ea00324de4536p+0,
    0x1.74a6556da4b7bp+0,-0x1.1bacfce352d62p+0,0x1.b011b6b89047ep-1,-0x1.491a95ee0c416p-1,0x1.f568522ad669ap-2,
    -0x1.8028e0444ade9p-2,0x1.24aba01857617p-2},{0x1.dc156b6416528p+1,-0x1.a08870b7b9fa7p-53,-0x1.68554f725993ap+1,
    0x1.ecbfa1837dff6p+0,-0x1.54c7b95b48f68p+0,0x1.d91ff85099aa5p-1,-0x1.48ca7ee6ec247p-1,0x1.c932bce20fb3cp-2,
    -0x1.3df2590b429d9p-2,0x1.ba45829f33df8p-3,-0x1.35161d1001973p-3,0x1.adfe3cc9a57d2p-4},{0x1.b295dc0a2e6c3p+1,
    0x1.ba74c9b3b76b3p-53,-0x1.31e4bae588447p+1,0x1.804bbacfc2086p+0,-0x1.e8a21aac6fecdp-1,0x1.37f8fab13ce92p-1,
    -0x1.8ed8a932ccfabp-2,0x1.fe3246e40d188p-3,-0x1.4666a14eca6fcp-3,0x1.a1b199b669b9p-4,-0x1.0c5ad3f8a3d81p-4,
    0x1.5774c725b3404p-5},{0x1.8f214b6f337abp+1,0x1.f9f81c853b833p-54,-0x1.070763e40d898p+1,0x1.319030ac60e76p+0,
    -0x1.67712ae4ec044p-1,0x1.a8db47034277ap-2,-0x1.f6d773f97f039p-3,0x1.29c28444ee805p-3,-0x1.60beaf6ccd844p-4,
    0x1.a1f3b9796ae3dp-5,-0x1.f0f671780707cp-6,0x1.2675545ae6f17p-6},{0x1.7079a85f3c4e2p+1,-0x1.16e60480bf8p-55,
    -0x1.c954fe52f5866p+0,0x1.ee0adfddf386p-1,-0x1.0e4c89c1a28d7p-1,0x1.295ef1a2b9d32p-2,-0x1.479f3c70509b8p-3,
    0x1.69356d69ea2ffp-4,-0x1.8e5fcd8414c02p-5,0x1.b771e658f362dp-6,-0x1.e63f00bbe18d2p-7,0x1.0c3bce26b471fp-7},
    {0x1.55b2c6368377cp+1,-0x1.9f1b9af3f3f84p-54,-0x1.91608f9ab2096p+0,0x1.952baf4cbec87p-1,-0x1.9e5d11897e66ap-2,
    0x1.aa55520872dfep-3,-0x1.b750e5775067ep-4,0x1.c50dfafbb70c5p-5,-0x1.d3670e73c2e4ap-6,0x1.e24de64209c66p-7,
    -0x1.f309e8eed586bp-8,0x1.0186394d843bcp-8},{0x1.3351a3994026ap+1,0x1.0b0b5b8f855b8p-53,-0x1.4f1484110f9e1p+1,
    0x1.33f49b163cdeap+1,-0x1.1eba2cc1f463bp+1,0x1.0cdee0142adep+1,-0x1.f912a5f09a12fp+0,0x1.dad34c4e46d81p+0,
    -0x1.be94f2e5dedf1p+0,0x1.a420fc5d3d768p+0,-0x1.8ebf5e002ae9dp+0,0x1.7736f8b12caa1p+0},{0x1.0dbe926472b74p+1,
    -0x1.e1f8d72db7156p-53,-0x1.0db37bfffce57p+1,0x1.bae7dbf6d85e2p+0,-0x1.7028fc8476c64p+0,0x1.34bd853ce1fecp+0,
    -0x1.035a12d98e528p+0,0x1.b4327e8b8d37fp-1,-0x1.6f04520e63bd4p-1,0x1.34e63face45eep-1,-0x1.05d7e88a5f467p-1,
    0x1.b8e2e94fb1625p-2},{0x1.de554734a5872p+0,-0x1.84d13b9a695d8p-54,-0x1.bbcd63649b474p+0,0x1.496b9385dd435p+0,
    -0x1.ee44e033960ccp-1,0x1.76dd5aa5fc22dp-1,-0x1.1cca05719b355p-1,0x1.b13c571228969p-2,-0x1.49c31795361c4p-2,
    0x1.f62a17fbf3636p-3,-0x1.809c5cd5371dep-3,0x1.24f20d2c84db8p-3},{0x1.ab906ab87a9afp+0,0x1.b0bf9acd5ea77p-55,
    -0x1.73b92c5ef637cp+0,0x1.f7c53744f081dp-1,-0x1.58183e16484d1p-1,0x1.dc65a66cad9a3p-2,-0x1.4a52d22ac0f02p-2,
    0x1.caa611981ea97p-3,-0x1.3eb4cfba53247p-3,0x1.bb123b28f2a43p-4,-0x1.35856debf8d67p-4,0x1.ae7ab0ceb618bp-5},
    {0x1.80b9a328c63ebp+0,0x1.6f64936355cf2p-54,-0x1.3bfa42005dce4p+0,0x1.8a36ddd6fed52p-1,-0x1.edd719ced3c16p-2,
    0x1.3a6f1a978b6cp-2,-0x1.9108ec0a56a12p-3,0x1.00075dc824d53p-3,-0x1.475121eff87ccp-4,0x1.a296037ced78fp-5,
    -0x1.0ccc7666f6a21p-5,0x1.57ea7a3792d2dp-6},{0x1.5c159aa40cf7ap+0,-0x1.0b991529266c7p-54,-0x1.0fedff20af65fp+0,
    0x1.3a9c646b80a3cp-1,-0x1.6b92acfa32ef9p-2,0x1.ac9a0f78e7c7ap-3,-0x1.fa14a14cced92p-4,0x1.2afbc3c4bcd53p-4,
    -0x1.61e366372dcefp-5,0x1.a2ffa974249c9p-6,-0x1.f1e96e9162ccfp-7,0x1.26eb22df8cc8ep-7},{0x1.3c62bf7e482ddp+0,
    0x1.4b1e772ce793cp-54,-0x1.d8f63030a83a3p-1,0x1.febfdf5882baap-2,-0x1.119bf7a8d7046p-2,0x1.2c3ad5bc15e8p-3,
    -0x1.4a1b01366bdap-4,0x1.6ad9cb315df4p-5,-0x1.8fd5b453135fap-6,0x1.b8bc326070e5ap-7,-0x1.e74cc20ce92d5p-8,
    0x1.0cb71cff8cf89p-8},{0x1.20b21ab4dde24p+0,0x1.3c44ee2b7d57p-54,-0x1.9efda7d814ebfp-1,0x1.a4c2473d2848bp-2,
    -0x1.a3bbe9989d96p-3,0x1.aeab43ee5e6cap-4,-0x1.bb426618fbc88p-5,0x1.c74e289058c2bp-6,-0x1.d547dad4ae01ap-7,
    0x1.e3faa64ae412ap-8,-0x1.f43fed5a3f484p-9,0x1.020ad5534f405p-9},{0x1.fa5885a3cdd96p-1,0x1.74f5940de68ccp-59,
    -0x1.59e655706274fp+0,0x1.423b573618ec9p+0,-0x1.22c9297ad5147p+0,0x1.0f9bc7c9a4fa3p+0,-0x1.fefc8e85f1868p-1,
    0x1.dd8c02adb10a1p-1,-0x1.c06d13e8c8249p-1,0x1.a60d6fa1a3dabp-1,-0x1.8fe9eb379eacbp-1,0x1.780454f6b8515p-1},
    {0x1.acec623100817p-1,-0x1.65161057532a1p-55,-0x1.151fb5fd00133p+0,0x1.d4d23c90cb86p-1,-0x1.765eaa9cc8314p-1,
    0x1.370f90dec9314p-1,-0x1.07a65e322135ep-1,0x1.b7c75c5b0edbdp-2,-0x1.6fe463084ed66p-2,0x1.36dd0388969d7p-2,
    -0x1.07266fe7a12e5p-2,0x1.b9719c7fca2abp-3},{0x1.6e4e21c101504p-1,0x1.4770b1f03a367p-55,-0x1.c472622f4e2dcp-1,
    0x1.6125a80492fd2p-1,-0x1.f993606950e6ep-2,0x1.76f1004044034p-2,-0x1.22cf61bfed233p-2,0x1.b82d02a1ea7edp-3,
    -0x1.48fa39195713dp-3,0x1.f886055af367ep-4,-0x1.8558db8f46f4bp-4,0x1.252de313b6065p-4},{0x1.3ad0b52613185p-1,
    -0x1.069be7ecea2d1p-61,-0x1.76b44504952acp-1,0x1.117180808824fp-1,-0x1.642a0960c7542p-2,0x1.d6b73f07c540bp-3,
    -0x1.50d860fc54d56p-3,0x1.da2dd2bf3b7dbp-4,-0x1.3d531313a2749p-4,0x1.b606102179996p-5,-0x1.3cad5af821da8p-5,
    0x1.b5d122f09ce38p-6},{0x1.0feda8232d2a7p-1,-0x1.269d5e0bbe372p-56,-0x1.39dd4e53f8f6p-1,0x1.b07d2d96d2c9p-2,
    -0x1.04c423efd05b1p-2,0x1.328427488aa3dp-3,-0x1.9258deb196e85p-4,0x1.0f3012b68e362p-4,-0x1.4c91eb2c3e194p-5,
    0x1.8f1bd15427a84p-6,-0x1.0e082ab54eb1dp-6,0x1.70772682e013p-7},{0x1.d7ac6a07fbc7ep-2,0x1.132b1db5e49bcp-59,
    -0x1.095f419c7e137p-1,0x1.5b543dae18e2p-2,-0x1.8b0bb5c3bcb51p-3,0x1.9f3cc89493ecep-4,-0x1.e8ba630586845p-5,
    0x1.40a653e1a2e0ep-5,-0x1.7dcea4378eb21p-6,0x1.8948f97e35b63p-7,-0x1.c2de4faff1338p-8,0x1.4216ccf4a0e78p-8},
    {0x1.9a6533c074ce8p-2,-0x1.c0b3aadbe4b01p-56,-0x1.c46d78e39293ap-2,0x1.19edfbfec1e73p-2,-0x1.3390d6074886ap-3,
    0x1.264eb8e7c6a16p-4,-0x1.2d95e1805f40cp-5,0x1.7a4f8241e7caep-6,-0x1.d222752163ebbp-7,0x1.c3a544c95cfefp-8,
    -0x1.7ab23c1b6c4b5p-9,0x1.dee4e125a88cep-10},{0x1.65f6abaf53639p-2,0x1.e1516356d4191p-56,-0x1.849efb7d7273dp-2,
    0x1.cd00478259516p-3,-0x1.e84c3968f340cp-4,0x1.b5602927e93c8p-5,-0x1.80d276abc4bc8p-6,0x1.b28b360643d63p-7,
    -0x1.1ab44a3ef49eap-7,0x1.29a937453e73cp-8,-0x1.9eac0df8ed505p-10,0x1.03f7888272466p-11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_ratio_zeta_limited)

/* Hunt and Crossley: (1 - eps)/beta: 9 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 1.0625.
 * Relative error of the approximation: 2^-57.0 at most, sampled at 25 places of each row. Bits of the rows:
 * 58.6 57.0 58.0 58.0 59.1 61.4 59.2 59.1 60.6 */
#define COR_ROWS_CROSSLEY_LOSS_FIRST 0.0
#define COR_ROWS_CROSSLEY_LOSS_STEP 0.125
#define COR_ROWS_CROSSLEY_LOSS_PER_UNIT 8.0
#define COR_ROWS_CROSSLEY_LOSS_ROWS 9
#define COR_ROWS_CROSSLEY_LOSS_END 1.0
COR_ROWS(double, cor_rows_crossley_loss, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.5555558p-1,-0x1.5555555555555p-28,-0x1.c71c71c71c71cp-2,0x1.4dbf86a314db8p-2,-0x1.06f3fd78ba2fap-2,
    0x1.b1706c5aa337ep-3,-0x1.7053b3176ee71p-3,0x1.4009bf84c0d6cp-3,-0x1.1acda6422fc13p-3,0x1.f9a22d9c06f7ap-4,
    -0x1.bd9fa4c43a125p-4,0x1.3c157f4728e24p-4},{0x1.3b437p-1,-0x1.d80c98a6f6048p-29,-0x1.7e8177cf77db5p-2,
    0x1.f8bca4cac323p-3,-0x1.64487cd9bdeddp-3,0x1.067fc1f6768b4p-3,-0x1.8e3eaf07ee732p-4,0x1.3498ad957230cp-4,
    -0x1.e6154652c622dp-5,0x1.83c33e359d92ep-5,-0x1.3a97dc940a01p-5,0x1.ff89bbf6ecdc4p-6},{0x1.252b4bp-1,
    0x1.8e911c0449091p-28,-0x1.46d8f4efb7eeap-2,0x1.8858e3af40c3fp-3,-0x1.f60712c85097cp-4,0x1.4e9bab626be3fp-4,
    -0x1.caa735f3895f9p-5,0x1.40d58a2f12ab8p-5,-0x1.c7ee3aab2af1p-6,0x1.47fd893b9ff77p-6,-0x1.df2fd0c9b0767p-7,
    0x1.5f1d679b993bbp-7},{0x1.12291dp-1,-0x1.6bb5303a6e3f9p-28,-0x1.1b18d65c23001p-2,0x1.37ec64803b91cp-3,
    -0x1.6d23eaa8e8aep-4,0x1.bc9342fbcfc02p-5,-0x1.15fbffdde07c4p-5,0x1.628b6164ad972p-6,-0x1.cb123a7cee405p-7,
    0x1.2cc9a129af455p-7,-0x1.8fc1989d4f2aap-8,0x1.0aa2de27867d1p-8},{0x1.019a46p-1,-0x1.328e9918c6cfap-30,
    -0x1.effaf33ef6851p-3,0x1.f955de8644f64p-4,-0x1.10af54361f266p-4,0x1.31a7ab61b0527p-5,-0x1.5f8c00cd71cfbp-6,
    0x1.9c139affee1e6p-7,-0x1.ea239be62a71bp-8,0x1.26e60ab08093dp-8,-0x1.678d00597879bp-9,0x1.b838241994533p-10},
    {0x1.e60e57p-2,0x1.3d1e483141a64p-31,-0x1.b6a81ea9b059cp-3,0x1.9fdc452d575bep-4,-0x1.a0731ec8ab6eap-5,
    0x1.b09d3f09736edp-6,-0x1.ccb56a1e82d98p-7,0x1.f3b5c35e7829ep-8,-0x1.12df75961e4fdp-8,0x1.31d30943b55f1p-9,
    -0x1.587c3d93f4f7ep-10,0x1.85cb275250ab2p-11},{0x1.cc2b4p-2,-0x1.3f9c1203481ebp-29,-0x1.872a1a24517d5p-3,
    0x1.5ae520f573402p-4,-0x1.441ddafa7dc9ep-5,0x1.39cdfdbb18243p-6,-0x1.3734f4b8ff1ccp-7,0x1.3a28c53b338dcp-8,
    -0x1.41880f20faacap-9,0x1.4cb46fc71793ap-10,-0x1.5c4ee2550c1a4p-11,0x1.6e622f36178a1p-12},{0x1.b50069p-2,
    -0x1.3ef2163abec99p-32,-0x1.5f51028062478p-3,0x1.24c8beb23ee2dp-4,-0x1.00718b784c32p-5,0x1.d10fa81b41741p-7,
    -0x1.afa09e6bed42fp-8,0x1.978d0a88e0365p-9,-0x1.85ff57fdd3dep-10,0x1.7934dc95859edp-11,-0x1.70e89937a1e22p-12,
    0x1.6a935ec4f776fp-13},{0x1.a020f68p-2,-0x1.df7e55f518057p-29,-0x1.3d830cfb595efp-3,0x1.f3558a4a14742p-5,
    -0x1.9bae9b81a8b26p-6,0x1.5f167bd5c807fp-7,-0x1.3242a189b4e22p-8,0x1.0fa7b9f91d7f3p-9,-0x1.e83bd7e54f7efp-11,
    0x1.bb55218d4fceep-12,-0x1.96db0b5f25632p-13,0x1.7744a8c2bf43bp-14}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_loss)

/* Hunt and Crossley: eps: 48 rows of degree 10 in y = beta 2^-k, 8 rows in each octave k = 0 ... 5.
 * Relative error of the approximation: 2^-53.9 at most, sampled at 25 places of each row. Bits of the rows:
 * 60.9 59.4 59.3 60.2 59.1 58.8 59.1 59.9 59.5 62.1 62.0 58.5 65.5 58.3 62.1 59.0 57.3 59.2 57.5 60.5 62.6 59.3 58.6
 * 58.4 56.5 58.0 57.2 60.1 59.8 59.0 61.2 58.6 54.3 55.8 57.4 57.9 58.3 60.2 58.4 58.6 53.9 55.9 56.4 58.4 59.1 58.3
 * 58.1 58.2 */
#define COR_ROWS_CROSSLEY_EPS_FIRST 1.0
#define COR_ROWS_CROSSLEY_EPS_FIRST_OCTAVE 0
#define COR_ROWS_CROSSLEY_EPS_OCTAVE_BITS 3
#define COR_ROWS_CROSSLEY_EPS_ROWS 48
#define COR_ROWS_CROSSLEY_EPS_END 64.0
COR_ROWS(double, cor_rows_crossley_eps, 48, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.2813967d0bdbcp-1,0x1.ad5fb4afae85ep-57,-0x1.eb7e23bf5369p-3,0x1.672ad6e7299a2p-4,-0x1.09cf4db50af9ep-5,
    0x1.9f1ae2bb65bf8p-7,-0x1.51b5eeb55bf19p-8,0x1.1a2186da9d5e2p-9,-0x1.e084065f7435ap-11,0x1.9f517e12087a1p-12,
    -0x1.6beb18a6914fp-13,0x1.4155a60f15dfap-14},{0x1.19634f12f0b41p-1,0x1.2380c6b6fd9aap-56,-0x1.c1856de7c0843p-3,
    0x1.39cf710f03d3cp-4,-0x1.b7c68d9a23a0fp-6,0x1.444019628a0a5p-7,-0x1.f230d2bdf86ccp-9,0x1.88ed656aba166p-10,
    -0x1.3bcdceaf506e2p-11,0x1.0190d6da397ap-12,-0x1.a9c932ccdb3dfp-14,0x1.62af068eaac76p-15},{0x1.0bed799c6d2b7p-1,
    0x1.aea2d185fbd54p-57,-0x1.9cb8ed881b11cp-3,0x1.14191ce932196p-4,-0x1.6f8fdb485723fp-6,0x1.00b238c7e39d2p-7,
    -0x1.7598e17afe7e3p-9,0x1.171575b00f62fp-10,-0x1.a8c50dfe75145p-12,0x1.47f701512dad2p-13,-0x1.008d409b67ed5p-14,
    0x1.948acc83f88d4p-16},{0x1.ff187bc3bb5cfp-2,0x1.322169a9e10f3p-57,-0x1.7c3ec5a21d6b5p-3,0x1.e8de5873585c1p-5,
    -0x1.360e5579e880ep-6,0x1.9b578858ad77ap-8,-0x1.1c5853e90a1e6p-9,0x1.9388144ef0d6bp-11,-0x1.239d1bfeab298p-12,
    0x1.ab8900b586ep-14,-0x1.3d718239d5431p-15,0x1.db2573cc1f4cap-17},{0x1.e83fb0b7eb7bap-2,0x1.7055d95a46249p-57,
    -0x1.5f69919917e27p-3,0x1.b33a627e2e25fp-5,-0x1.07bc4c4ee1a3bp-6,0x1.4d2a6de209ab2p-8,-0x1.b6a4a0fffc9bp-10,
    0x1.286cc5e1a00ap-11,-0x1.97e57c766e588p-13,0x1.1ca03f2ab929bp-14,-0x1.923e4e571a6a9p-16,0x1.1e80b92fb6ba8p-17},
    {0x1.d31ac6ee0f90fp-2,-0x1.37395f9dc7f4ep-56,-0x1.45adb828939f4p-3,0x1.856e221acc995p-5,-0x1.c412f7d86f5dp-7,
    0x1.1082d7e3fe471p-8,-0x1.567206a22d1c1p-10,0x1.b9d2d37637f8fp-12,-0x1.221b003881d4bp-13,0x1.824c830ffb6b4p-15,
    -0x1.0464c92bab1cfp-16,0x1.61dd6d9887918p-18},{0x1.bf7bd3bf0cef1p-2,0x1.184ae4d53d20fp-56,-0x1.2e99a838c6965p-3,
    0x1.5e0b70e94cb98p-5,-0x1.8621b59820a23p-7,0x1.c1cef774b34d4p-9,-0x1.0e4c13e3bfe5dp-10,0x1.4d9ea2888eef1p-12,
    -0x1.a3030d3447812p-14,0x1.0ac0340291108p-15,-0x1.57cc2180b9e09p-17,0x1.beaa0b622e8adp-19},{0x1.ad3b5c9e75fe7p-2,
    0x1.1b9da2a18a434p-56,-0x1.19d01d7028befp-3,0x1.3bf3135922434p-5,-0x1.52cdcc9bad077p-7,0x1.764930dea8d5ap-9,
    -0x1.af008c5634cbp-11,0x1.fde74f7c5d503p-13,-0x1.32d9d9b7e911cp-14,0x1.764e530d27806p-16,-0x1.ce1a07d1e0ffap-18,
    0x1.1f8c539eaac8fp-19},{0x1.94224e34a23f9p-2,-0x1.b54ba723015eep-58,-0x1.fc9028f470c9dp-3,0x1.10d4776b06f69p-3,
    -0x1.1523e1cff72a6p-4,0x1.2017a52bbbca7p-5,-0x1.381821713fbc9p-6,0x1.5ba1bea336e78p-7,-0x1.89cfec92d03a9p-8,
    0x1.c3f8f9ffdc811p-9,-0x1.0717b588728b6p-9,0x1.340169f726fcfp-10},{0x1.765a6bcd91bccp-2,0x1.9e156672ad569p-56,
    -0x1.be5516b17ca8cp-3,0x1.c5db855a8d329p-4,-0x1.af9949eb7fbp-5,0x1.9ffca994548bp-6,-0x1.a17909f3d993p-7,
    0x1.af6a932734b9dp-8,-0x1.c558e4e6f8f95p-9,0x1.e2525adb9a417p-10,-0x1.04150796bbffap-10,0x1.1a2ce0c4cabfbp-11},
    {0x1.5c2183cd27b37p-2,-0x1.21d762cbdfd03p-57,-0x1.8a4803d3fee94p-3,0x1.7dc0ec9887d6dp-4,-0x1.560592e14a82p-5,
    0x1.3363f0c7d735fp-6,-0x1.1f29cbe05b6f3p-7,0x1.14c24b22be2e5p-8,-0x1.0f4a586f42b8cp-9,0x1.0d092a8504f8ap-10,
    -0x1.0e4149c64039ap-11,0x1.1136b662c63fp-12},{0x1.44e6869971159p-2,0x1.c6e4fca37aafcp-56,-0x1.5e4a58f2decc2p-3,
    0x1.442fad1f1a218p-4,-0x1.132c0074061a1p-5,0x1.cf9dc29fa91cep-7,-0x1.94d431e3de1fcp-8,0x1.6d768d0594f8dp-9,
    -0x1.4fd044c10702bp-10,0x1.37ebc5b4028c2p-11,-0x1.253d42440ae01p-12,0x1.15868e0df24afp-13},{0x1.3035b9cc6ada8p-2,
    -0x1.2c220a8d68c5ap-57,-0x1.38c7a77277d1cp-3,0x1.1591ac7669554p-4,-0x1.c0a20449ebabcp-6,0x1.63f3e75fd783ep-7,
    -0x1.2390c546e42bbp-8,0x1.eee3487f8bbbap-10,-0x1.ac17f1ba35f2ap-11,0x1.760ed76564c1ap-12,-0x1.4a7796a9cd28fp-13,
    0x1.25faf44cf3385p-14},{0x1.1db175446610dp-2,-0x1.534bc7b0cf44ap-56,-0x1.188c93b2ef225p-3,0x1.deb3eee2a1ffp-5,
    -0x1.71ee4b43d3a0ap-6,0x1.15b097f27ed77p-7,-0x1.ac1f0e19759bbp-9,0x1.5694da355039ep-10,-0x1.1803d59553043p-11,
    0x1.ce2554a466ccbp-13,-0x1.811c71c5f3119p-14,0x1.4327b44d83758p-15},{0x1.0d0cfb079a22fp-2,-0x1.c4f03d023f91bp-57,
    -0x1.f956f9f48d8d7p-4,0x1.9f5cf8131cedbp-5,-0x1.341a50be68fdep-6,0x1.b77f6b3cc7695p-8,-0x1.3fcc5ddde6444p-9,
    0x1.e3bce23666f1dp-11,-0x1.76c900be1d276p-12,0x1.25267e52d4692p-13,-0x1.ce65d53e4dddfp-15,0x1.6f1fae1b7aafbp-16},
    {0x1.fc1173f79f41p-3,-0x1.9fb20c870363fp-60,-0x1.c8d3ae895a577p-4,0x1.6a6139e7ebcdp-5,-0x1.02de16b151decp-6,
    0x1.6046779d7bc34p-8,-0x1.e555a99422b66p-10,0x1.5ba0894d06c28p-11,-0x1.ffebe6e6b5c4dp-13,0x1.7ccbd8107ec4p-14,
    -0x1.1d241d09b0419p-15,0x1.ad961c5a7d414p-17},{0x1.d439a13e9ed9dp-3,-0x1.61785f6503e33p-59,-0x1.8b2b4b48f0b4fp-3,
    0x1.29f42f19b9d6cp-3,-0x1.9468218a4a93ep-4,0x1.0234a7865136ap-4,-0x1.4976e61c6c4c8p-5,0x1.b44ff0b82bacep-6,
    -0x1.2abe6fb6cbeebp-6,0x1.9e753d38e3f0ep-7,-0x1.21cf5e7d71dc8p-7,0x1.956e6bcc37d2fp-8},{0x1.a71e6802e3a82p-3,
    -0x1.ca743f6d411d7p-57,-0x1.493de5ea192aep-3,0x1.d199e0142b7bfp-4,-0x1.2957a6b226baap-4,0x1.60f1c0f502694p-5,
    -0x1.9ad2f61f607cap-6,0x1.ec781925adb75p-7,-0x1.3366e19e4c316p-7,0x1.87ba3d940bf98p-8,-0x1.f66d403a69b53p-9,
    0x1.4113ea6594fdep-9},{0x1.8154ad51e57dap-3,-0x1.0bc6766bf81dep-57,-0x1.1560f8a349165p-3,0x1.70d6d28138cc4p-4,
    -0x1.be14b97f775dfp-5,0x1.f1ca1a99d4e7bp-6,-0x1.0b86d75fd6335p-6,0x1.24220b201d0ebp-7,-0x1.4d425faa84987p-8,
    0x1.88537ee6d2e2bp-9,-0x1.d261467c1233cp-10,0x1.1322f37210a3ap-10},{0x1.61561e40bad0fp-3,0x1.c0ff38a34257ap-58,
    -0x1.d81b25e6c3139p-4,0x1.27ae6351823b8p-4,-0x1.53ffe05e64e51p-5,0x1.67dce89f50133p-6,-0x1.6974f353ce2edp-7,
    0x1.6a70628840399p-8,-0x1.7a4e32bee6795p-9,0x1.9c1876be6da02p-10,-0x1.c98351e07bef5p-11,0x1.f7c3ef5fad075p-12},
    {0x1.45fbede0b27a4p-3,0x1.42ad141dd2865p-57,-0x1.9580bfcf7d94dp-4,0x1.df1e461813a8bp-5,-0x1.0690c9dc5e77dp-5,
    0x1.094d8103dad05p-6,-0x1.f76bf9faf4125p-8,0x1.d416ea79ad94p-9,-0x1.c01fc1b426b02p-10,0x1.c305fa9bc018bp-11,
    -0x1.d529a60e3db93p-12,0x1.e6b7dd7fbda91p-13},{0x1.2e6422ee960abp-3,-0x1.9d566f8e0e486p-57,-0x1.5f48e6092262dp-4,
    0x1.87f647aa0acc7p-5,-0x1.9a13949a1050dp-6,0x1.8d50adea9b72ep-7,-0x1.67470868a669cp-8,0x1.392166d0f45f3p-9,
    -0x1.145ce3690feb6p-10,0x1.0061da9e41797p-11,-0x1.f30b739c0d7d3p-13,0x1.eaa2985d61908p-14},{0x1.19df61a16f02cp-3,
    -0x1.1c3ef63faec4dp-57,-0x1.32bb99b36335dp-4,0x1.4392fbb8fe33cp-5,-0x1.43635824a4187p-6,0x1.2d460e721fb64p-7,
    -0x1.0571c87d8efbep-8,0x1.afb2b552f594ap-10,-0x1.621ae899067fdp-11,0x1.2e9589c1ee362p-12,-0x1.123614e17bca2p-13,
    0x1.ff4985ab2f79dp-15},{0x1.07e42288b9266p-3,0x1.a686d7699fe5bp-59,-0x1.0dcce198badfdp-4,0x1.0d68653358f99p-5,
    -0x1.0150c36d9a373p-6,0x1.cdb4eedabc4eep-8,-0x1.8262396707af3p-9,0x1.30fc037796106p-10,-0x1.d5baedc5fc2e7p-12,
    0x1.72ca6e9079ef5p-13,-0x1.3728aa641b7f4p-14,0x1.11d76fc6e62a7p-15},{0x1.e18a19247e1f4p-4,-0x1.8ef7f536f8da2p-58,
    -0x1.c2c1e232c815p-4,0x1.9f8f849d6fb15p-4,-0x1.72fdfeeba3414p-4,0x1.3ae6eb7d067fp-4,-0x1.f5d6fa153734bp-5,
    0x1.7732c5c7cc12dp-5,-0x1.0c0919fd1c274p-5,0x1.7cfaf5d0d8363p-6,-0x1.1ce95cfb8da72p-6,0x1.c529e2d646e29p-7},
    {0x1.af087f9646777p-4,0x1.5d84eecb1cc77p-58,-0x1.6a128e849918p-4,0x1.2dab88872a9cp-4,-0x1.ecd7d759f3776p-5,
    0x1.848e9ab642f2bp-5,-0x1.232f2842533f7p-5,0x1.9aee3bb75488ap-6,-0x1.1190bdb2811c3p-6,0x1.5e96a03f42a12p-7,
    -0x1.c537cb987ac82p-8,0x1.341a206d8998cp-8},{0x1.860cbeebfb643p-4,0x1.fb2d85da99eefp-58,-0x1.28d9490a877efp-4,
    0x1.c1efedf1d5fcdp-5,-0x1.51123fb83394dp-5,0x1.ed5c547ea50cp-6,-0x1.5bb9e04dd54d1p-6,0x1.d2088a800cc23p-7,
    -0x1.26cfc12620c3ep-7,0x1.616fbdf22f3e8p-8,-0x1.9bb245711197cp-9,0x1.e3a681189ee09p-10},{0x1.642846290ee6cp-4,
    -0x1.a77d7d2da9334p-59,-0x1.ef476af719dd6p-5,0x1.57a6569e6c59ep-5,-0x1.d9d0cfb1f6ab7p-6,0x1.41e724ad72fdfp-6,
    -0x1.aa156ad46df78p-7,0x1.0f31b46715acep-7,-0x1.486009d2f8015p-8,0x1.7826aca36fce1p-9,-0x1.9acdf3084d552p-10,
    0x1.b340c2be96019p-11},{0x1.47ac87047a7cbp-4,0x1.8c298bf96d75dp-59,-0x1.a355317fff075p-5,0x1.0c0ad5908a826p-5,
    -0x1.557bded4a8ccbp-6,0x1.af454c6abf70ep-7,-0x1.0baa9bb722166p-7,0x1.42f5ecfcd3dbap-8,-0x1.766793b0c0062p-9,
    0x1.9d119977acab9p-10,-0x1.b0de62883fa64p-11,0x1.af577f9f22d9fp-12},{0x1.2f67ba6fff5dbp-4,0x1.1b631ed994337p-62,
    -0x1.678eeb83ea3a6p-5,0x1.a9e5f746858c1p-6,-0x1.f79124347ec91p-7,0x1.28374f3b7473ep-7,-0x1.58b7cbaff44aep-8,
    0x1.8964952f75ffbp-9,-0x1.b3a5ec7f5e09ap-10,0x1.cf3beb4eec1e4p-11,-0x1.d5f902f0bd505p-12,0x1.c35751cc161a9p-13},
    {0x1.1a7b60d4248c5p-4,-0x1.9b9fd1dc529f7p-58,-0x1.37b12aa55fbffp-5,0x1.57d8725502bdap-6,-0x1.7af7ed2134111p-7,
    0x1.a086b2154eb06p-8,-0x1.c6ce4a9714471p-9,0x1.ea40144b089ddp-10,-0x1.029d294d1b5e9p-10,0x1.0869e8b053f71p-11,
    -0x1.03fad705fb77bp-12,0x1.e5cfed891ce39p-14},{0x1.0841fd02fd884p-4,0x1.56a2a5be4163bp-59,-0x1.10c719d25b5fap-5,
    0x1.198b2598785cp-6,-0x1.22759899df2a9p-7,0x1.2b369d23adbdbp-8,-0x1.330d82eba587cp-9,0x1.388b5425dc295p-10,
    -0x1.397f7bd1daf3cp-11,0x1.3346311b8b9fbp-12,-0x1.241d2b3e7c88p-13,0x1.09d8a2756404cp-14},{0x1.e1e1d9398f6fcp-5,
    -0x1.6bd3a452afd76p-59,-0x1.c588c217c843cp-5,0x1.aad737feeb1f7p-5,-0x1.91a842d37c43p-5,0x1.79bff315668f8p-5,
    -0x1.62b20f05adc41p-5,0x1.4bc766a77c9f3p-5,-0x1.33f4d6c04f283p-5,0x1.1a061d7e6e35dp-5,-0x1.fd7a3f2dbf1a3p-6,
    0x1.bb688428c8ed4p-6},{0x1.af286a9fe9af7p-5,-0x1.8cc61b209b627p-62,-0x1.6b147dfa8f32ep-5,0x1.31bfe3e697f5dp-5,
    -0x1.017687cd82d32p-5,0x1.b18b54689a1eap-6,-0x1.6cdb6096d02dep-6,0x1.32ab0aa3b2f96p-6,-0x1.01032bee3ab9dp-6,
    0x1.ac51d138bd024p-7,-0x1.6384b93b24cbfp-7,0x1.2072cd032adf7p-7},{0x1.8618615dee73cp-5,0x1.ba9d9e22329cdp-62,
    -0x1.293723377d584p-5,0x1.c4e629883460dp-6,-0x1.591029b1b6e3cp-6,0x1.06e50133d9582p-6,-0x1.90895c46ce345p-7,
    0x1.310228f66ed8ep-7,-0x1.d01306bcbed11p-8,0x1.60484a3630883p-8,-0x1.0bb6f57fb339dp-8,0x1.9183df4c5d333p-9},
    {0x1.642c858b48145p-5,-0x1.9478b5b920cb8p-59,-0x1.ef8bda8b0e228p-6,0x1.58ba5048d5efcp-6,-0x1.df9ed8fea5633p-7,
    0x1.4da56725bd75ap-7,-0x1.d02f77b2036bp-8,0x1.42ddd193ec1a1p-8,-0x1.c101de0c394bdp-9,0x1.37fc7d07d6a7dp-9,
    -0x1.b2dd26e2f71fap-10,0x1.2ca8b106e513bp-10},{0x1.47ae147a26546p-5,-0x1.5b77d9d6e2049p-59,-0x1.a36e2e9a5c943p-6,
    0x1.0c6f794fd25efp-6,-0x1.5798e64eec291p-7,0x1.b7cdbedd6fbeap-8,-0x1.1978cee846a69p-8,0x1.684584d003722p-9,
    -0x1.cd173f43e0827p-10,0x1.26fed35cb0a88p-10,-0x1.7ac10157c7eaap-11,0x1.e3bfb2055c4f9p-12},{0x1.2f684bd9f9bbfp-5,
    -0x1.5cf6f14d31d98p-59,-0x1.67980e08c827dp-6,0x1.aa2f78bf1c27ep-7,-0x1.f91bcf99a695ep-8,0x1.2b52d2a0ff211p-8,
    -0x1.62c0cd7871beep-9,0x1.a471d917ceb62p-10,-0x1.f249ac19b0467p-11,0x1.2740c7ce8efbdp-11,-0x1.5f08ad651a77cp-12,
    0x1.9fbe0719c4708p-13},{0x1.1a7b9611a4517p-5,0x1.25d834d66d846p-59,-0x1.37b482480556ap-6,0x1.57f351f0d67p-7,
    -0x1.7b88138a9030ep-8,0x1.a2cb1c6c2753ap-9,-0x1.ce1dde53b79b5p-10,0x1.fdebc02682197p-11,-0x1.19552d778661p-11,
    0x1.366d9d5c23ca7p-12,-0x1.5788f2ff18653p-13,0x1.7afd588fea9a7p-14},{0x1.0842108420928p-5,0x1.4011cb7992835p-60,
    -0x1.10c8531cfa972p-6,0x1.1994faf3c2cc9p-7,-0x1.22aa4d55d3f4dp-8,0x1.2c0aa2246d1cdp-9,-0x1.35b863ab95226p-10,
    0x1.3fb60bccfbc92p-11,-0x1.4a05e4ffc67e7p-12,0x1.54aaaf72c4cffp-13,-0x1.6090c44b16c97p-14,0x1.6bea536f4f20fp-15},
    {0x1.e1e1e1e1e1d63p-6,0x1.474a854b3cb0fp-63,-0x1.c5894d10d3226p-6,0x1.aadb93d3837d6p-6,-0x1.91bf9a2f7f556p-6,
    0x1.7a1dbe43eac25p-6,-0x1.63dfc2b9f6b38p-6,0x1.4ef0b66924f4cp-6,-0x1.3b3ac256bf6bdp-6,0x1.28afb757f71dcp-6,
    -0x1.19ab843916b23p-6,0x1.0919404865d37p-6},{0x1.af286bca1af25p-6,0x1.41cc26acb78d4p-66,-0x1.6b1490aa319d2p-6,
    0x1.31c079d2b01c9p-6,-0x1.0179a9f4bf979p-6,0x1.b1a47c8e7a8a9p-7,-0x1.6d2c336393a7p-7,0x1.3383898efffa1p-7,
    -0x1.02f4625215f15p-7,0x1.b42253a66e7ddp-8,-0x1.71d4f80bf4a0fp-8,0x1.376fecb3a9aadp-8},{0x1.8618618618618p-6,
    0x1.462e642be76e8p-60,-0x1.293725bb804a3p-6,0x1.c4e651e0c3798p-7,-0x1.5911016e47c97p-7,0x1.06e8629d294bfp-7,
    -0x1.909f1069f362ep-8,0x1.313c3d443a743p-8,-0x1.d11d7e713b77p-9,0x1.625f9d3f8a785p-9,-0x1.0f89c6451822p-9,
    0x1.9dc5bf75cbd6ep-10},{0x1.642c8590b2164p-6,0x1.61d65f8a58eeep-61,-0x1.ef8bdb389ebadp-7,0x1.58ba55b815608p-7,
    -0x1.df9f13165df01p-8,0x1.4da6500f8f377p-8,-0x1.d0354e28ae57cp-9,0x1.42ed6e0607142p-9,-0x1.c1496f08e644ap-10,
    0x1.388c20b7e2985p-10,-0x1.b4e9cfe20bea1p-11,0x1.2ff09094195fep-11},{0x1.47ae147ae147bp-6,-0x1.eb9afe5fd6d04p-62,
    -0x1.a36e2eb1c432dp-7,0x1.0c6f7a0b5ed8dp-7,-0x1.5798ee2307d0dp-8,0x1.b7cdfd9d7aa48p-9,-0x1.1979982209eb1p-9,
    0x1.6849b87d7d3a6p-10,-0x1.cd2a7fa8b7c53p-11,0x1.2725706bf7022p-11,-0x1.7b4dee0918355p-12,0x1.e582785cdad59p-13},
    {0x1.2f684bda12f68p-6,0x1.2f68323fb019ep-60,-0x1.67980e0bf08c8p-7,0x1.aa2f78f1b4cc7p-8,-0x1.f91bd1b62adc4p-9,
    0x1.2b52db169e23bp-9,-0x1.62c103b5125afp-10,0x1.a472fae991027p-11,-0x1.f24edb61bd6f1p-12,0x1.274b2cabb27f9p-12,
    -0x1.5f2e96bba0a91p-13,0x1.a037376311e74p-14},{0x1.1a7b9611a7b96p-6,0x1.1a7b943210f34p-62,-0x1.37b4824872745p-7,
    0x1.57f351f7aa6eap-8,-0x1.7b8813d37df37p-9,0x1.a2cb1eb467ab8p-10,-0x1.ce1decf49756fp-11,0x1.fdec0e4bafd2bp-12,
    -0x1.1955e059195cfp-12,0x1.36706a50a93b2p-13,-0x1.579328e0d3b2cp-14,0x1.7b1df82434b82p-15},{0x1.0842108421084p-6,
    0x1.0842107fbde9ap-61,-0x1.10c8531d0952ep-7,0x1.1994faf4aec92p-8,-0x1.22aa4d5fac05cp-9,0x1.2c0aa27346378p-10,
    -0x1.35b865a4de836p-11,0x1.3fb616579b5e5p-12,-0x1.4a06153f5913dp-13,0x1.54ab70c5853f8p-14,-0x1.609384df1eaffp-15,
    0x1.6bf31dcd875abp-16}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_eps)

/* Hunt and Crossley: beta/(1 - eps), 1 - eps < 1/2: 9 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.0625, 0 <= y <= 0.53125.
 * Relative error of the approximation: 2^-53.5 at most, sampled at 25 places of each row. Bits of the rows:
 * 64.1 59.4 59.6 58.7 58.0 58.0 57.4 55.5 53.5 */
#define COR_ROWS_CROSSLEY_NEAR_BETA_FIRST 0.0
#define COR_ROWS_CROSSLEY_NEAR_BETA_STEP 0.0625
#define COR_ROWS_CROSSLEY_NEAR_BETA_PER_UNIT 16.0
#define COR_ROWS_CROSSLEY_NEAR_BETA_ROWS 9
#define COR_ROWS_CROSSLEY_NEAR_BETA_END 0.5
COR_ROWS(double, cor_rows_crossley_near_beta, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.8p+0,0x0p+0,0x1.8p+0,0x1.599999999999ap+0,0x1.33333333332fep+0,0x1.1593bfa265db3p+0,0x1.00bb3ee2d447fp+0,
    0x1.e598720205a35p-1,0x1.d3d13a72f828cp-1,0x1.c96d85af633cdp-1,0x1.be7279ab07bfbp-1,0x1.078c87dceb2cep+0},
    {0x1.996df38p+0,-0x1.1612d2a78026fp-28,0x1.af179751bb526p+0,0x1.9a64a6d9d42e9p+0,0x1.83f25f306032cp+0,
    0x1.764e2ae8a78bdp+0,0x1.7296e4cebd1dap+0,0x1.779acc305518bp+0,0x1.83e6ed9fb918ap+0,0x1.9651993a2905cp+0,
    0x1.af3f3d21379adp+0,0x1.cbdbe09824ab2p+0},{0x1.b6139f8p+0,0x1.cd67a5b7fa3a4p-27,0x1.e7556c1894b33p+0,
    0x1.ece7bbc5163edp+0,0x1.f21082fad6a76p+0,0x1.01f6f3a4a5051p+1,0x1.12e2687fe0ee8p+1,0x1.2c2561f7b864cp+1,
    0x1.4df4cca5a81ccp+1,0x1.78b9ddfdd9c01p+1,0x1.ae8ba39628882p+1,0x1.eddc1a2faf271p+1},{0x1.d69728p+0,
    0x1.d280338ab41adp-29,0x1.15aaa132819efp+1,0x1.2bf07b3c7dde6p+1,0x1.45ed7115c93e5p+1,0x1.6cc46ac4b173cp+1,
    0x1.a4f2268ea76dcp+1,0x1.f220868780e03p+1,0x1.2c44394b7a1a5p+2,0x1.6eca82127f7e8p+2,0x1.c5d9746273067p+2,
    0x1.1976a9fe68c2ep+3},{0x1.fbd02dp+0,0x1.b11160e74c84cp-27,0x1.3f5eaf8c4b39bp+1,0x1.72c14f6e114a9p+1,
    0x1.b45c19be99727p+1,0x1.09c5153772de9p+2,0x1.4e8b4b196471cp+2,0x1.affb60339de16p+2,0x1.1bfd69db27cb8p+3,
    0x1.7a0611ac7e032p+3,0x1.fd996a43a9b2fp+3,0x1.57c9d238c3b11p+4},{0x1.136e498p+1,0x1.6ee36c32e78f3p-26,
    0x1.73674811e4b1bp+1,0x1.d2e32b1a10efcp+1,0x1.2c26353d7c84fp+2,0x1.916dce3b48dbep+2,0x1.15e725c61d923p+3,
    0x1.8aac03ec9f2b6p+3,0x1.1d1c5b21aeb46p+4,0x1.a0915b51d8561p+4,0x1.34212a39d6f5bp+5,0x1.c760a3187d0a5p+5},
    {0x1.2ca095p+1,0x1.edb9a2073e3fcp-26,0x1.b5ad954d6a633p+1,0x1.2cb19ae8edd08p+2,0x1.aac8b7c7cded2p+2,
    0x1.3c9ee5d365f06p+3,0x1.e6f3be9d67855p+3,0x1.7fd52468993aap+4,0x1.3361415a3cae3p+5,0x1.f12473ac41ebfp+5,
    0x1.96fec63a75aeap+6,0x1.4c108fbe630b7p+7},{0x1.4a8fa48p+1,-0x1.37df555badffap-27,0x1.062138e5d3968p+2,
    0x1.8e57e675b113cp+2,0x1.3c1952bc336ep+3,0x1.076f852e835bdp+4,0x1.c753364837bddp+4,0x1.92c6598f29bbbp+5,
    0x1.694aa87536363p+6,0x1.46aa288ea99d6p+7,0x1.2afb9ba0d2d5cp+8,0x1.0fe15d21b5917p+9},{0x1.6ec8bdp+1,
    0x1.5dd12200fbfe9p-26,0x1.40853d754ba52p+2,0x1.1172e9fa8ceddp+3,0x1.ed22979ffc2cfp+3,0x1.d4c44e3395742p+4,
    0x1.cdb5bcd3be02dp+5,0x1.d061c3711d08fp+6,0x1.d86823e9028c3p+7,0x1.e345e6d861463p+8,0x1.f481ae026dd61p+9,
    0x1.007374497e5cp+11}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_near_beta)

/* Hunt and Crossley: beta by eps, 2^-6 <= eps < 2^-1: 40 rows of degree 10 in y = eps 2^-k, 8 rows in each octave k = -6 ... -2.
 * Relative error of the approximation: 2^-53.8 at most, sampled at 25 places of each row. Bits of the rows:
 * 54.0 55.6 56.4 57.6 59.8 58.5 58.2 61.3 53.9 55.7 57.5 59.0 58.8 58.4 59.4 58.7 53.9 55.8 57.0 58.3 59.5 58.1 59.3
 * 58.1 53.8 55.7 56.6 58.5 59.1 58.5 59.0 60.3 53.8 55.5 56.3 57.4 59.1 59.9 57.8 59.0 */
#define COR_ROWS_CROSSLEY_BETA_FIRST 0.015625
#define COR_ROWS_CROSSLEY_BETA_FIRST_OCTAVE (-6)
#define COR_ROWS_CROSSLEY_BETA_OCTAVE_BITS 3
#define COR_ROWS_CROSSLEY_BETA_ROWS 40
#define COR_ROWS_CROSSLEY_BETA_END 0.5
COR_ROWS(double, cor_rows_crossley_beta, 40, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.e1e1e1e1e1e1ep+5,0x1.e1e1e1870f646p-51,-0x1.c5894d10d498ep+5,0x1.aadb93d39aea3p+5,-0x1.91bf9a30796fbp+5,
    0x1.7a1dbe4bbd964p+5,-0x1.63dfc2ec1880cp+5,0x1.4ef0b774cbc47p+5,-0x1.3b3ac719ec57cp+5,0x1.28afca72c05c5p+5,
    -0x1.19abcef214ecp+5,0x1.091a2c2f1ddf6p+5},{0x1.af286bca1af28p+5,0x1.af284371e304ep-49,-0x1.6b1490aa31a3fp+5,
    0x1.31c079d2b08a1p+5,-0x1.0179a9f4c4281p+5,0x1.b1a47c8ec3a1cp+4,-0x1.6d2c336567e5fp+4,0x1.33838998c347fp+4,
    -0x1.02f4627e8b73dp+4,0x1.b422550b05ca5p+3,-0x1.71d4fd7e19dfdp+3,0x1.376ffde36e5f9p+3},{0x1.8618618618618p+5,
    0x1.8602790631f3p-49,-0x1.293725bb804a5p+5,0x1.c4e651e0c37d7p+4,-0x1.5911016e47f43p+4,0x1.06e8629d2aa12p+4,
    -0x1.909f106a04825p+3,0x1.313c3d449597ap+3,-0x1.d11d7e747b305p+2,0x1.625f9d4c8ba17p+2,-0x1.0f89c677fbb59p+2,
    0x1.9dc5c0b6aea85p+1},{0x1.642c8590b2164p+5,0x1.5a3ff489cdbcbp-50,-0x1.ef8bdb389ebadp+4,0x1.58ba55b815605p+4,
    -0x1.df9f13165df62p+3,0x1.4da6500f8f279p+3,-0x1.d0354e28b003cp+2,0x1.42ed6e0606914p+2,-0x1.c1496f091af2ep+1,
    0x1.388c20b8288afp+1,-0x1.b4e9cfe684a4bp+0,0x1.2ff0909ebb3dbp+0},{0x1.47ae147ae147bp+5,-0x1.0f19c456531aep-49,
    -0x1.a36e2eb1c4334p+4,0x1.0c6f7a0b5ed38p+4,-0x1.5798ee2308202p+3,0x1.b7cdfd9d7768ep+2,-0x1.197998221681cp+2,
    0x1.6849b87d3235bp+1,-0x1.cd2a7faa1727cp+0,0x1.272570697c795p+0,-0x1.7b4dee1053be5p-1,0x1.e582784ed238ep-2},
    {0x1.2f684bda12f66p+5,-0x1.2678dc51a3575p-49,-0x1.67980e0bf0936p+4,0x1.aa2f78f1b4423p+3,-0x1.f91bd1b631a38p+2,
    0x1.2b52db16806fbp+2,-0x1.62c103b5d2721p+1,0x1.a472fae5e1a92p+0,-0x1.f24edb6fa34edp-1,0x1.274b2c97ab3a1p-1,
    -0x1.5f2e96e6ad796p-2,0x1.a0373723c9753p-3},{0x1.1a7b9611a7b77p+5,0x1.86bfca8782b71p-49,-0x1.37b4824872badp+4,
    0x1.57f351f7a5ad1p+3,-0x1.7b8813d3b0f26p+2,0x1.a2cb1eb2eccbap+1,-0x1.ce1decfca08c8p+0,0x1.fdec0e2afb132p-1,
    -0x1.1955e08b40ea5p-1,0x1.367069dea47ddp-2,-0x1.5793299693fc4p-3,0x1.7b1df77b03333p-4},{0x1.0842108420f7ep+5,
    -0x1.b21d93144af1fp-49,-0x1.10c8531d0b61p+4,0x1.1994faf490062p+3,-0x1.22aa4d60c850dp+2,0x1.2c0aa26c37d57p+1,
    -0x1.35b865c54babfp+0,0x1.3fb615e98cd74p-1,-0x1.4a061652799dep-2,0x1.54ab6edc20ddap-3,-0x1.60938708c9783p-4,
    0x1.6bf31ce8c1277p-5},{0x1.e1e1e1e1dfe95p+4,-0x1.2870cbf551739p-52,-0x1.c5894d1108d1p+4,0x1.aadb93d11a018p+4,
    -0x1.91bf9a4343f49p+4,0x1.7a1dbdebfcf6p+4,-0x1.63dfc446da515p+4,0x1.4ef0b3ed6a8f6p+4,-0x1.3b3acd9385d5ep+4,
    0x1.28afc2c446b1cp+4,-0x1.19abd2f750e34p+4,0x1.091a2f09ea4ffp+4},{0x1.af286bc9f53abp+4,0x1.25ec44c8280ddp-50,
    -0x1.6b1490ad4b2b6p+4,0x1.31c079b4cb465p+4,-0x1.0179aaa2b4a5fp+4,0x1.b1a4774a1b83ep+3,-0x1.6d2c41840141cp+3,
    0x1.33836f97aae75p+3,-0x1.02f481366e59ep+3,0x1.b4223280f4927p+2,-0x1.71d4ef63275c9p+2,0x1.37701e276f7f6p+2},
    {0x1.8618618484e49p+4,-0x1.8357a0c9450b9p-50,-0x1.293725d66cbfp+4,0x1.c4e6503fa283cp+3,-0x1.591108ef400bfp+3,
    0x1.06e84c123a6c4p+3,-0x1.909f6aeae14acp+2,0x1.313bc8527a01ap+2,-0x1.d11e200574a37p+1,0x1.625fa1d59721cp+1,
    -0x1.0f8967eae2d32p+1,0x1.9dc5faa2c7342p+0},{0x1.642c8585b5043p+4,-0x1.eba475b41634ep-52,-0x1.ef8bdc6f08bd9p+3,
    0x1.58ba4e0a00562p+3,-0x1.df9f4c048343cp+2,0x1.4da5c9b54fa62p+2,-0x1.d036e40c2fd87p+1,0x1.42ec09167befp+1,
    -0x1.c14a39096ddc2p+0,0x1.388d0676c2b3ep+0,-0x1.b4e87929e8796p-1,0x1.2fefeb95be69cp-1},{0x1.47ae14437947fp+4,
    -0x1.16fd795780aa5p-60,-0x1.a36e33d3ab7bap+3,0x1.0c6f5f121df0ap+3,-0x1.5799913eea80dp+2,0x1.b7cb9aec6b70fp+1,
    -0x1.197c4c0911722p+1,0x1.6846b96067b2p+0,-0x1.cd29b84a6f5a7p-1,0x1.272821c392193p-1,-0x1.7b4d9c89fb7abp-2,
    0x1.e57e21d0435b5p-3},{0x1.2f684b00b8732p+4,0x1.cfaa218a14cf3p-50,-0x1.67981f2a940a4p+3,0x1.aa2ee1c556694p+2,
    -0x1.f91ec3a5e0d91p+1,0x1.2b4e7465f5f3cp+1,-0x1.62c864dc16f84p+0,0x1.a46ed192ead55p-1,-0x1.f24838bf699f3p-2,
    0x1.274f7f9f7d397p-2,-0x1.5f32a4393370cp-3,0x1.a031ae2df79f5p-4},{0x1.1a7b935656b01p+4,-0x1.0f9fe0e5b1058p-51,
    -0x1.37b4b1a24ecfep+3,0x1.57f1eefaf036fp+2,-0x1.7b8dd512d509fp+1,0x1.a2bd58f4e6d14p+0,-0x1.ce2e84346c4bcp-1,
    0x1.fdeb0a0c50cabp-2,-0x1.194c4ee8a5772p-2,0x1.36732a75fdbcbp-3,-0x1.579ed244087b5p-4,0x1.7b1d93adb1c24p-5},
    {0x1.0842090552881p+4,-0x1.f829a5cdf2552p-50,-0x1.10c8c3de78cf4p+3,0x1.199226c5530a3p+2,-0x1.22b424934bbafp+1,
    0x1.2bf7c8d6daa65p+0,-0x1.35c7c4bddb905p-1,0x1.3fbd92ef5941ep-2,-0x1.49f360aaea3bdp-3,0x1.54a4a982003b2p-4,
    -0x1.60a63c6aac5a7p-5,0x1.6c00d73467e02p-6},{0x1.e1e1ac11bf541p+3,0x1.97f4d32230dep-51,-0x1.c58be5a25d74ep+3,
    0x1.aace2a6b12a98p+3,-0x1.91e3c859cefc9p+3,0x1.79ec950dd7e72p+3,-0x1.63f01c7b346p+3,0x1.4f12d0b9aab29p+3,
    -0x1.3b284337130cap+3,0x1.288f63d1b2143p+3,-0x1.19b28a807a94fp+3,0x1.0939ac86d6b63p+3},{0x1.af279800c32d9p+3,
    -0x1.c53bf604abf57p-51,-0x1.6b1c9b7cdf591p+3,0x1.31a0b3994ad5dp+3,-0x1.01b78b8921ba2p+3,0x1.b13f2138e84b3p+2,
    -0x1.6d14aa07cc313p+2,0x1.33cc6a54e78dep+2,-0x1.030b5feb62126p+2,0x1.b3c65a3d3a5f3p+1,-0x1.718dd117f114bp+1,
    0x1.378b79855e9adp+1},{0x1.8615eb4e15431p+3,-0x1.6f51a09e5cee3p-51,-0x1.294a68c14ce1bp+3,0x1.c46f90d29058ap+2,
    -0x1.59b92f5cabffap+2,0x1.06a09b27e016fp+2,-0x1.901982bf4d009p+1,0x1.3189db96563eap+1,-0x1.d1dd30e0b9c08p+0,
    0x1.624be4441a6eep+0,-0x1.0f0dcbecb5a2bp+0,0x1.9d4ce1720e8c6p-1},{0x1.64268d73021d1p+3,-0x1.f00abbdc7e157p-51,
    -0x1.efd86ce219907p+2,0x1.57ff3322a4b2ep+2,-0x1.e120217343d16p+1,0x1.4d75e8c3107cp+1,-0x1.cef3830bc9396p+0,
    0x1.42e94a76a7effp+0,-0x1.c283d592005fp-1,0x1.391d74967d651p-1,-0x1.b4482792e3187p-2,0x1.2efc0cc90b466p-2},
    {0x1.47a1ac69c4019p+3,-0x1.5294d1ed735afp-51,-0x1.a3f2a6e694ef5p+2,0x1.0b6b6b47d1d06p+2,-0x1.5919bbc9aab8dp+1,
    0x1.b82bf07e32716p+0,-0x1.1865bb43b7e58p+0,0x1.677580f736948p-1,-0x1.ce53e05f4c02cp-2,0x1.28702d53a345ep-2,
    -0x1.7bc3fda0a55cfp-3,0x1.e3da2a585de07p-4},{0x1.2f51650bb8874p+3,0x1.65ad816c09e78p-53,-0x1.68664b96b2773p+2,
    0x1.a79df09789af4p+1,-0x1.fbc7fe28f0d39p+0,0x1.2c409af92a369p+0,-0x1.615866c5adeacp-1,0x1.a2490c0370649p-2,
    -0x1.f272eebc5cd2cp-3,0x1.28fc7c860ff85p-3,-0x1.61131e1a5762fp-4,0x1.a0131c8019213p-5},{0x1.1a551123c122bp+3,
    -0x1.c54ee0ece0156p-51,-0x1.38dc720c0d482p+2,0x1.54ee286e9b475p+1,-0x1.7da6918da6ef7p+0,0x1.a54817418d875p-1,
    -0x1.ccde11f5340d4p-2,0x1.fa0f04ef39c79p-3,-0x1.184d0ff930e8p-3,0x1.37d411dc9e24p-4,-0x1.5aa071085dbb2p-5,
    0x1.7d324f892c46cp-6},{0x1.0805e815d8ca4p+3,-0x1.71dd3c223a88fp-55,-0x1.12569f70c2ff8p+2,0x1.163998994d36fp+1,
    -0x1.2421927265e96p+0,0x1.2eb6b8675f98bp-1,-0x1.35b8ff73f953ep-2,0x1.3cf21552a839fp-3,-0x1.474bb357e149dp-4,
    0x1.54ca1ed910882p-5,-0x1.63edc6580f3acp-6,0x1.7020fafe4b26cp-7},{0x1.e10f43fe75f49p+2,0x1.9959843483784p-52,
    -0x1.c9f78088e884cp+2,0x1.a3986dd20fe0fp+2,-0x1.92c0cca786d27p+2,0x1.7ee2011b4051ap+2,-0x1.6605ed5d6a4ffp+2,
    0x1.4cb51c5a2eb03p+2,-0x1.36fd22fe37052p+2,0x1.2604d68fd7fb8p+2,-0x1.1aa26b95bf28ap+2,0x1.0cf63678d831cp+2},
    {0x1.adaac1ce8df35p+2,-0x1.f195a6c080907p-54,-0x1.7156d3763e5bap+2,0x1.2a830f69cf242p+2,-0x1.007cf12b17f78p+2,
    0x1.b7ede51b3c418p+1,-0x1.72a1adf6e07eep+1,0x1.341f7ecc45b5cp+1,-0x1.ff3ca7b3262a2p+0,0x1.abbce81d31ed4p+0,
    -0x1.6d25c411fd559p+0,0x1.385dfc2d429cap+0},{0x1.83b624d878965p+2,0x1.0294dd52c3b85p-52,-0x1.313775537c9a5p+2,
    0x1.b7a5a1ae09e51p+1,-0x1.54c1771c8d59dp+1,0x1.0a17468dde5cfp+1,-0x1.9935787d8c43dp+0,0x1.35632c3383015p+0,
    -0x1.cf6529518cdc4p-1,0x1.5b62b111c2974p-1,-0x1.08a25740d8a77p-1,0x1.968b2e0abdd0cp-2},{0x1.60b0e6e18eaeep+2,
    -0x1.a76cd4fa02d41p-54,-0x1.0151e6347d1ap+2,0x1.4d50609bda5e6p+1,-0x1.d4fe7964e2dd5p+0,0x1.4fa2026b7bb48p+0,
    -0x1.db2b8c12554cfp-1,0x1.4aa1785c9f8eep-1,-0x1.c5b11a156c126p-2,0x1.355392a75c0ep-2,-0x1.a92cd1c504a91p-3,
    0x1.262b3928bb9c2p-3},{0x1.42eb7c4e3359ap+2,-0x1.04df17c3a09a1p-55,-0x1.b91fa307f447cp+1,0x1.030f6f49250e9p+1,
    -0x1.4cb1dc458b904p+0,0x1.b68e840d9070bp-1,-0x1.1f7c28af3de01p-1,0x1.732c487f495c3p-2,-0x1.d7c1549f2ad9ap-3,
    0x1.2876e4d1d3da8p-3,-0x1.74ac634baf4aep-4,0x1.d4ec658f7413cp-5},{0x1.2939355e13e83p+2,0x1.7de5948cc6521p-53,
    -0x1.7f61236563a71p+1,0x1.9b6a610eefb3cp+0,-0x1.e4acfc45c955fp-1,0x1.276c11464e1f5p-1,-0x1.683d05b77b11ap-2,
    0x1.b1e53fdf7881ep-3,-0x1.0155834e9073bp-3,0x1.2d23b009448f6p-4,-0x1.5e81879cda19ep-5,0x1.95e963d555d95p-6},
    {0x1.12c267b162447p+2,0x1.408b41deaf5b2p-53,-0x1.511b0f1e8e81ep+1,0x1.4ccec0a2084fap+0,-0x1.695cdd53f7ee6p-1,
    0x1.98e237812a75dp-2,-0x1.d15e4daeb7b8p-3,0x1.06810939984a3p-3,-0x1.241aa7fba6cbbp-4,0x1.4087263672176p-5,
    -0x1.5cb98123b53d3p-6,0x1.77d4d9e2795e2p-7},{0x1.fdd0dad2dfafdp+1,0x1.8f45bc37c47a8p-53,-0x1.2b5f75dad65b6p+1,
    0x1.119bce51d989dp+0,-0x1.1309a7a62ee75p-1,0x1.21d5f9bb9ec5ep-2,-0x1.34d3857effb9p-3,0x1.475ba3cdae694p-4,
    -0x1.570381947bdbbp-5,0x1.62ad128a2664dp-6,-0x1.6b21f62fe5c81p-7,0x1.6f5cd706b0ab9p-8},{0x1.ca1495bf1d351p+1,
    0x1.9b7473e2ec8a6p-53,-0x1.fcf2f1d3b6a3dp+1,0x1.a2a775d165058p+1,-0x1.79cc6ad304092p+1,0x1.67f17a42b389cp+1,
    -0x1.5d2d3f5097b51p+1,0x1.52c035ca4b39cp+1,-0x1.460a9e3976a77p+1,0x1.3657d2c5627bcp+1,-0x1.266073e3c8557p+1,
    0x1.11d570ebeb42ap+1},{0x1.9057ff78faf8p+1,-0x1.aee89e3936464p-53,-0x1.a38df9a3be5afp+1,0x1.30f702f91b24bp+1,
    -0x1.e2fa6bb5e4025p+0,0x1.965bcb49c7047p+0,-0x1.5ed3de13cc663p+0,0x1.30cdc5fc12fbdp+0,-0x1.07fc68e89cc62p+0,
    0x1.c5cd0ecb59749p-1,-0x1.84f881a1794b6p-1,0x1.47b215bae3457p-1},{0x1.603cd420412d1p+1,0x1.2a0f6f2cd6f7cp-53,
    -0x1.613c359358fa3p+1,0x1.cd067afd387bdp+0,-0x1.44a18f3489f16p+0,0x1.e775f8ee1cabap-1,-0x1.79d821e0c8ffap-1,
    0x1.284f47b51c372p-1,-0x1.d1432a75422cep-2,0x1.6bbd45b9c9a0dp-2,-0x1.1c03a9f4b0b38p-2,0x1.b542f7381e13p-3},
    {0x1.376523c8f79d2p+1,-0x1.72e0acd05d7cbp-53,-0x1.2e5ddc0f41295p+1,0x1.66ecd628d7283p+0,-0x1.c6b64cb1c165p-1,
    0x1.337e7224f57cdp-1,-0x1.af5f28c479702p-2,0x1.33806bbf9274dp-2,-0x1.b886f527823fbp-3,0x1.3b2e350a7758cp-3,
    -0x1.c32ddf78b7a78p-4,0x1.3f51b8f31d534p-4},{0x1.1432d61d9f374p+1,-0x1.b767db6537dabp-54,-0x1.0649dd23358dfp+1,
    0x1.1e395edc47404p+0,-0x1.497b87a486be1p-1,0x1.94b625297f843p-2,-0x1.02b601b9bc01ap-2,0x1.5168944e8bf01p-3,
    -0x1.bb988feababbep-4,0x1.24093ea7f247ep-4,-0x1.814511d78ddc1p-5,0x1.f7ee3338d04bdp-6},{0x1.eaff96c7e2c88p+0,
    0x1.394b9ce789378p-54,-0x1.cc06551d68717p+0,0x1.d19d1042fc362p-1,-0x1.eb478e3420859p-2,0x1.140fcf1fd3ec1p-2,
    -0x1.43b431ecfd453p-3,0x1.8467c7f6ca3ecp-4,-0x1.d71a6f79cdd3cp-5,0x1.1ecbf7098bc4dp-5,-0x1.5e5ea9a7959b1p-6,
    0x1.a95ea6625a092p-7},{0x1.b4e8a24951ba9p+0,-0x1.866e39f505749p-54,-0x1.97161b4759567p+0,0x1.8104e3d711b4cp-1,
    -0x1.773176866477fp-2,0x1.8459a730136cap-3,-0x1.a4099cc9b4fcbp-4,0x1.d213f8ac1c97p-5,-0x1.06055025ae486p-5,
    0x1.28565902065f2p-6,-0x1.50b5b1882861ap-7,0x1.7cf7412a85ee5p-8},{0x1.84dbda1258387p+0,0x1.f3e03810846f7p-54,
    -0x1.6b018f70a926bp+0,0x1.42d80c4b6c9a1p-1,-0x1.247d270817823p-2,0x1.187b12dcfff59p-3,-0x1.1945bd034a75fp-4,
    0x1.21f80cc95cf44p-5,-0x1.2f8a610348932p-6,0x1.4030bd354b137p-7,-0x1.53b807d942c9ap-8,0x1.678ac3ec14562p-9}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_beta)

/* Hunt and Crossley, damped approach: (1 - eps)/beta: 9 rows of degree 10 in y = beta, nodes 0 + i 0.125, 0 <= y <= 1.0625.
 * Relative error of the approximation: 2^-57.7 at most, sampled at 25 places of each row. Bits of the rows:
 * 60.5 57.7 58.0 58.9 60.6 60.1 59.7 58.9 59.9 */
#define COR_ROWS_CROSSLEY_LOSS_APPROACH_ONLY_FIRST 0.0
#define COR_ROWS_CROSSLEY_LOSS_APPROACH_ONLY_STEP 0.125
#define COR_ROWS_CROSSLEY_LOSS_APPROACH_ONLY_PER_UNIT 8.0
#define COR_ROWS_CROSSLEY_LOSS_APPROACH_ONLY_ROWS 9
#define COR_ROWS_CROSSLEY_LOSS_APPROACH_ONLY_END 1.0
COR_ROWS(double, cor_rows_crossley_loss_approach_only, 9, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.5555558p-2,-0x1.5555555555555p-29,-0x1.8e38e38e38e39p-3,0x1.14dbf86a314d7p-3,-0x1.a4a9670836559p-4,
    0x1.514139ffa07e5p-4,-0x1.185bef8429d5dp-4,0x1.de6d1edcadf72p-5,-0x1.a04808f3c045ep-5,0x1.6f34ad5182526p-5,
    -0x1.3ff9e4f0bd738p-5,0x1.c21e16a895803p-6},{0x1.3e6bbp-2,0x1.9e6838c3c5f07p-29,-0x1.51b37170394bbp-3,
    0x1.a6df3e03b8c27p-4,-0x1.2001811a7cf79p-4,0x1.9cf4da008945fp-5,-0x1.327ff32ab38acp-5,0x1.d2807203e7f5dp-6,
    -0x1.69cb04b99ee74p-6,0x1.1cc7c5d1351ebp-6,-0x1.c89c043d1f056p-7,0x1.6f57f6ac3653p-7},{0x1.2ad64cp-2,
    0x1.9ad065247218fp-30,-0x1.22de95aba9bc6p-3,0x1.4b9c20e06a046p-4,-0x1.99a59e3a4d681p-5,0x1.09c1a48d83f76p-5,
    -0x1.647c9a2e5589ap-6,0x1.e9dc38326a99bp-7,-0x1.56c645a97d3efp-7,0x1.e6a57194ebdbfp-8,-0x1.5f4ad1cd4b23ap-8,
    0x1.fd6af997f1c86p-9},{0x1.19dc4fp-2,-0x1.59eacc2a52fcp-34,-0x1.fb7f8235477f1p-4,0x1.09b7aa3c48ca3p-4,
    -0x1.2c79e516727fdp-5,0x1.642f88e8e142fp-6,-0x1.b3faf36c85fbcp-7,0x1.111c6faa24723p-7,-0x1.5c47b68ca2acbp-8,
    0x1.c25f29cba3fe2p-9,-0x1.27c239ecefdap-9,0x1.866a87d39b57cp-10},{0x1.0af88ep-2,-0x1.d4efefe089853p-30,
    -0x1.bf79ec4227d63p-4,0x1.b18c6fbeeab16p-5,-0x1.c43e9c21b891bp-6,0x1.edaa5a663b353p-7,-0x1.15e9b8741f497p-7,
    0x1.400a321555cfcp-8,-0x1.76efba2c7e707p-9,0x1.bd3d92ea7afffp-10,-0x1.0c3ee567d8a59p-10,0x1.45005c987ababp-11},
    {0x1.fb9093p-3,-0x1.b96cb1ca0e56ep-30,-0x1.8e23ad8833ef4p-4,0x1.67194e3c421a2p-5,-0x1.5bc5c3e2b8506p-6,
    0x1.5fe76d5a2db02p-7,-0x1.6eeadb065f994p-8,0x1.870718792bbfbp-9,-0x1.a7bc824cc51p-10,0x1.d146d9e2d6ad8p-11,
    -0x1.02fcf260f94d2p-11,0x1.21ffb236aa2aep-12},{0x1.e400ff8p-3,-0x1.b5a562bbbc90dp-30,-0x1.65027de2f98c5p-4,
    0x1.2d533f430bec6p-5,-0x1.106c7893cb878p-6,0x1.00f988056af87p-7,-0x1.f319c9ab6f556p-9,0x1.ef1667f5ad912p-10,
    -0x1.f3269ec666858p-11,0x1.fdc252037db05p-12,-0x1.07baae48e0302p-12,0x1.12883346b72bcp-13},{0x1.cece16p-3,
    0x1.6385861132006p-30,-0x1.424da64acdecep-4,0x1.ff6c3a38ac3dep-6,-0x1.b1ae371264d7ep-7,0x1.7f36379de3164p-8,
    -0x1.5c5047c894b42p-9,0x1.4334e84099e3p-10,-0x1.30b25f7dd753cp-11,0x1.22dfbe8fbb679p-12,-0x1.192daf7a568dfp-13,
    0x1.117c6c365744cp-14},{0x1.bb9c1ap-3,-0x1.dd0670197e568p-30,-0x1.24b4af480a364p-4,0x1.b64ea0bb4c61p-6,
    -0x1.5e0dccdbbe579p-7,0x1.22fa687c59669p-8,-0x1.f13805c42b325p-10,0x1.b17712a29bd9cp-11,-0x1.7fc581c5bb8b1p-12,
    0x1.57f76f77d8d7ep-13,-0x1.3805366a09a9p-14,0x1.1cd1a7429b857p-15}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_loss_approach_only)

/* Hunt and Crossley, damped approach: eps: 32 rows of degree 10 in y = beta 2^-k, 8 rows in each octave k = 0 ... 3.
 * Relative error of the approximation: 2^-58.5 at most, sampled at 25 places of each row. Bits of the rows:
 * 59.8 59.9 61.5 61.1 62.6 65.2 61.4 62.8 61.2 60.3 62.0 63.6 61.4 60.5 60.9 60.4 60.3 60.7 60.9 61.2 62.4 62.4 59.9
 * 61.3 58.5 59.6 60.3 60.0 61.6 60.0 60.2 60.0 */
#define COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY_FIRST 1.0
#define COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY_FIRST_OCTAVE 0
#define COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY_OCTAVE_BITS 3
#define COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY_ROWS 32
#define COR_ROWS_CROSSLEY_EPS_APPROACH_ONLY_END 16.0
COR_ROWS(double, cor_rows_crossley_eps_approach_only, 32, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.8c8a562162329p-1,0x1.a7aa0c8c3cca1p-55,-0x1.1e2f53913baa5p-3,0x1.56b9a6dad6581p-5,-0x1.de82d33b09617p-7,
    0x1.68e887a1fc926p-8,-0x1.1d5e9440c6cbcp-9,0x1.d1f65f5d5f5d7p-11,-0x1.855a32661b78dp-12,0x1.4b1ff2ac82958p-13,
    -0x1.1e128e94dbcfep-14,0x1.f2f1dd2cc2741p-16},{0x1.83eaf7e6ea0f6p-1,0x1.4de480a742d14p-55,-0x1.0a155cd9592b7p-3,
    0x1.2dc54b27a680cp-5,-0x1.8e63aeca63b1ap-7,0x1.1be11560bdd99p-8,-0x1.a7e8de210c627p-10,0x1.46b1511b3cb8ep-11,
    -0x1.019f10e40dd2cp-12,0x1.9d76972da39ccp-14,-0x1.50f07a7a32218p-15,0x1.153001cd0446cp-16},{0x1.7be2c3733b2a9p-1,
    -0x1.9e80d15ffe58cp-55,-0x1.f0a61e9e1c19p-4,0x1.0b81d3810fbd3p-5,-0x1.4ef71342b2bf8p-7,0x1.c46e00a90cc31p-9,
    -0x1.3fffe08395e31p-10,0x1.d315f214ccae5p-12,-0x1.5cbbde733653ep-13,0x1.08e9d06e79074p-14,-0x1.989b1b6f5fb55p-16,
    0x1.3e235f58e53e9p-17},{0x1.746088944eda6p-1,0x1.186838a652e4p-58,-0x1.d1118b271474bp-4,0x1.dd2509684c5dp-6,
    -0x1.1c226ef94b484p-7,0x1.6cc112bc41bdcp-9,-0x1.ea2f301affd46p-11,0x1.53c3cd1b315bbp-12,-0x1.e1bea0a1a39dfp-14,
    0x1.5b6ecd1c6cc4cp-15,-0x1.fca105c1bd09ep-17,0x1.77e4f7a58f66p-18},{0x1.6d55c4a52613p-1,0x1.7f04b5986bba4p-59,
    -0x1.b4d3c55e9a294p-4,0x1.abdcf003b3624p-6,-0x1.e5e285a237006p-8,0x1.292c6b5da3ad3p-9,-0x1.7c61429fa60c7p-11,
    0x1.f61a7ae7bb9f3p-13,-0x1.52e08caa006a5p-14,0x1.d144b6ffab0d1p-16,-0x1.44196732db40cp-17,0x1.c7e4d6645c9e6p-19},
    {0x1.66b61d2743c0bp-1,-0x1.ff3418973e3a2p-55,-0x1.9b70b0016180dp-4,0x1.819342680e309p-6,-0x1.a2733eee58ea1p-8,
    0x1.e8db0f69b137fp-10,-0x1.2aaffd922d4bep-11,0x1.784d46a02f6d6p-13,-0x1.e4b48a1fffbeep-15,0x1.3d79e40e4d30ep-16,
    -0x1.a5ea06d5dbf0bp-18,0x1.1b12e3da5794ep-19},{0x1.6076f91373cadp-1,-0x1.79c94cadcc06ap-55,-0x1.8482bdb311206p-4,
    0x1.5d09ad76b7029p-6,-0x1.6abf7aa701444p-8,0x1.95957122d55b5p-10,-0x1.da28a629d29d5p-12,0x1.1dae4e83620efp-13,
    -0x1.5fe51ff0b54b4p-15,0x1.b8c4880ddfa7dp-17,-0x1.17fd2921ce1e6p-18,0x1.672bb9a3a0d5dp-20},{0x1.5a8f30cd497a4p-1,
    -0x1.360f154d67f41p-57,-0x1.6fb61390662ffp-4,0x1.3d450b2bc089ep-6,-0x1.3c5a9435deff8p-8,0x1.532b4fd4e6bd4p-10,
    -0x1.7c145c20fd2f5p-12,0x1.b6e8699197dc4p-14,-0x1.03020aa14ae78p-15,0x1.36cefc006dc73p-17,-0x1.7a3b8d77e4739p-19,
    0x1.d0c21eaf3af95p-21},{0x1.52462f0d25ca3p-1,-0x1.a7295be4fe86cp-55,-0x1.53ebe268b488cp-3,0x1.14e4562ab79f3p-4,
    -0x1.0449804ec5a41p-5,0x1.06e0859e50798p-6,-0x1.155da6fd2bcd2p-7,0x1.2d791b08dd04bp-8,-0x1.4ed18722bf9ffp-9,
    0x1.7a02c53bbb361p-10,-0x1.b1c37d981297ap-11,0x1.f55b47b234ef1p-12},{0x1.48299b2b3f098p-1,0x1.56388e6d2e0abp-56,
    -0x1.341f7e42883aep-3,0x1.d3451e6d67c3dp-5,-0x1.982e987e6c1dep-6,0x1.7eb8dda636569p-7,-0x1.76ac34c51ff4ap-8,
    0x1.79b1105e79115p-9,-0x1.84eb8751ef372p-10,0x1.970662d7867f3p-11,-0x1.b0ac378706285p-12,0x1.cf6deffa9ce1cp-13},
    {0x1.3ef769f2a2c38p-1,-0x1.a346d8cd9f9a2p-55,-0x1.192301f492215p-3,0x1.8eded7561a019p-5,-0x1.457b1aa486dffp-6,
    0x1.1cd5060bd1349p-7,-0x1.041ba2310b77dp-8,0x1.e8fe2109cda47p-10,-0x1.d565f19fa468ap-11,0x1.c9db630b88582p-12,
    -0x1.c562264635bd6p-13,0x1.c479103c61a2ap-14},{0x1.368d370ae700dp-1,-0x1.7ef79ba7c7f8ap-56,-0x1.01fc11f39733dp-3,
    0x1.57ef65cf1d06cp-5,-0x1.075a87fc86bcap-6,0x1.b02d745f22a68p-8,-0x1.71dc91f67c098p-9,0x1.45b3d2f40fcb6p-10,
    -0x1.24d46194079ffp-11,0x1.0b788e34807fap-12,-0x1.efd0d222da5abp-14,0x1.cf3d16171c5eap-15},{0x1.2ecf68331ff15p-1,
    -0x1.3620b336cf71ap-57,-0x1.dbdda46e88ba9p-4,0x1.2b3437f5bf537p-5,-0x1.afa9db9c6daebp-7,0x1.4d6fb3acdfa7bp-8,
    -0x1.0c8358c7e66a8p-9,0x1.bcd9f5dc8ff7cp-11,-0x1.7823361d1630fp-12,0x1.430ce0152dc6fp-13,-0x1.196f583a776b4p-14,
    0x1.ee5d2a3f81dcfp-16},{0x1.27a7870b046cp-1,-0x1.0b164fd017e8cp-55,-0x1.b8d76642e4a17p-4,0x1.0656c275a0939p-5,
    -0x1.65ccb3bd0f614p-7,0x1.051bd9ca4d3f2p-8,-0x1.8d21a97c1a7c9p-10,0x1.36916a0f1712dp-11,-0x1.efb5f704fa532p-13,
    0x1.91c858d42d67ep-14,-0x1.4a363349fa1e8p-15,0x1.11a24f5434b19p-16},{0x1.210312b205847p-1,-0x1.3952bed78a7cep-56,
    -0x1.9a06726d063eap-4,0x1.cf4230b6c7704p-6,-0x1.2b94f5ce5ff5ap-7,0x1.9e63c896852c8p-9,-0x1.2a8a70b4bdeabp-10,
    0x1.ba3b3596e2476p-12,-0x1.4e3182877115cp-13,0x1.0072ffc8cdf13p-14,-0x1.8ef987b2248c5p-16,0x1.38f23a817325cp-17},
    {0x1.1ad2a2cd6125ep-1,0x1.ca78b5d14ce4fp-62,-0x1.7ebb2a1d44ff5p-4,0x1.9b9a3605f96a6p-6,-0x1.fa3b330025c4cp-8,
    0x1.4cbff619dd9d3p-9,-0x1.c78065cc7825cp-11,0x1.406fdf9a5f313p-12,-0x1.cbea19e0a27b4p-14,0x1.4f19a8b86adb9p-15,
    -0x1.eee11cad8ea86p-17,0x1.707e40281d6d6p-18},{0x1.1247b99a3944p-1,-0x1.d1eb0efcf0dcap-55,-0x1.5b39ffef3a10bp-3,
    0x1.5c55741cb977ap-4,-0x1.8f1b634d9b2c7p-5,0x1.e866d9a2dcc18p-6,-0x1.370594fb6634cp-6,0x1.96ffa4831e368p-7,
    -0x1.0f950d8e3e57ap-7,0x1.6fead04eaf24bp-8,-0x1.fabe35a647064p-9,0x1.5eb3d1e1d2c2ep-9},{0x1.08107db479a85p-1,
    0x1.154bf282cec55p-57,-0x1.33ed99ec721cdp-3,0x1.1b98a4b9347aap-4,-0x1.29d751485a3e2p-5,0x1.4dc92cb516d22p-6,
    -0x1.8516a58e7a82ap-7,0x1.d1ce6160bf4a9p-8,-0x1.1c45bfe0e3848p-8,0x1.6020ba73f827ap-9,-0x1.bb0815b246267p-10,
    0x1.1840af95242fdp-10},{0x1.fdec542265fb6p-2,-0x1.8d5f2e2234cb1p-57,-0x1.13ab920a0888fp-3,0x1.d570ea70b5a8ep-5,
    -0x1.c72d89f897ebcp-6,0x1.d6942e9b037a9p-7,-0x1.f9c4bccaa59bap-8,0x1.17087747c6cddp-8,-0x1.39d06d36f09cfp-9,
    0x1.661924bf64b9fp-10,-0x1.9ebb113a45a66p-11,0x1.e3367c2b637edp-12},{0x1.ed8ef68b58e0bp-2,-0x1.f8915cc2e21fbp-57,
    -0x1.f19209c7c799ep-4,0x1.8a01819ab3fd8p-5,-0x1.62dd9289b8bb7p-6,0x1.5489ec3afd66fp-7,-0x1.5392a394abfd8p-8,
    0x1.5b82cf2c9dbe2p-9,-0x1.6a647cde5cb29p-10,0x1.7f5ed24190582p-11,-0x1.9b5bc959ea51fp-12,0x1.bc334667b45e5p-13},
    {0x1.debcf05cd6a03p-2,0x1.0ed737c88a1cp-57,-0x1.c42b78939f5d8p-4,0x1.4eb19da5523dap-5,-0x1.1979370eb8b6ap-6,
    0x1.f81b09acf86e7p-8,-0x1.d4df72ea7d7dcp-9,0x1.bf6e81430da01p-10,-0x1.b2fc7eae5aaaep-11,0x1.aceb9ff47733cp-12,
    -0x1.acc2d2a152ec4p-13,0x1.af714ad34dab8p-14},{0x1.d13a98ba0d171p-2,-0x1.eacbd5c1463bcp-57,-0x1.9d66f2fb131eap-4,
    0x1.1f4cc2997670ap-5,-0x1.c543381f5c40dp-7,0x1.7c7e87da9245bp-8,-0x1.4ba2510c91994p-9,0x1.2879c218fb9d3p-10,
    -0x1.0df6f163f6a78p-11,0x1.f2952d5c7f4e6p-13,-0x1.d289593ce58ap-14,0x1.b787fd3ea437fp-15},{0x1.c4d84caddae61p-2,
    -0x1.0e3091ff4f51cp-56,-0x1.7bf8b8a07358ep-4,0x1.f1c8b29407de4p-6,-0x1.71c71bd165da7p-7,0x1.242a0a67e338bp-8,
    -0x1.df2f9b2b73561p-10,0x1.92f58e67efa77p-11,-0x1.5915641ca31f4p-12,0x1.2ba4ed8752863p-13,-0x1.078e865fb8c96p-14,
    0x1.d2de6ff467fb7p-16},{0x1.b96f777500743p-2,0x1.2fe4a8bae99f1p-56,-0x1.5ee4864cbb20bp-4,0x1.b2c195c48a962p-6,
    -0x1.3132605a68fb1p-7,0x1.c7893feb6d651p-9,-0x1.60be0085b7698p-10,0x1.18073e475c38fp-11,-0x1.c4b257c73ac56p-13,
    0x1.72f90c51f4ef9p-14,-0x1.33d6dbcbc3f99p-15,0x1.0143d7495fc26p-16},{0x1.a9e242afcd405p-2,0x1.47dcdd1d5db12p-60,
    -0x1.39d0545ed77f2p-3,0x1.679fca1674da7p-4,-0x1.d28009cbb654ep-5,0x1.41751766cb999p-5,-0x1.cb78af63b4dfep-6,
    0x1.508a75a181d03p-6,-0x1.f5d8a5389afe9p-7,0x1.7b470e5574afep-7,-0x1.236c370812a3ep-7,0x1.c1202b5222b29p-8},
    {0x1.9792037df7b0ep-2,0x1.6d778d9df8fc8p-56,-0x1.11c34c1ed0c54p-3,0x1.1d40abbc0ea4fp-4,-0x1.50066756a1c0bp-5,
    0x1.a43aee1643c0ap-6,-0x1.10632a5a37538p-6,0x1.69c502985573fp-7,-0x1.e8f837a0d8544p-8,0x1.4ee13bbd37531p-8,
    -0x1.d1c53bbc8d8e3p-9,0x1.452219d45b716p-9},{0x1.877f93cb15e61p-2,-0x1.86df855db1fe6p-56,-0x1.e357d011f691ep-4,
    0x1.cdd486aae6ad7p-5,-0x1.f258fe468813ep-6,0x1.1d434ddc9a365p-6,-0x1.5262b555cda9bp-7,0x1.9b1b87428c8c9p-8,
    -0x1.fc28a731cbfc3p-9,0x1.3e3650176616cp-9,-0x1.944ba058758a4p-10,0x1.01f89938d03aep-10},{0x1.793d3660b2b95p-2,
    0x1.cd454f0f188d3p-56,-0x1.aef1c598c7fecp-4,0x1.7c4778e7854edp-5,-0x1.7a9eaf4d4333fp-6,0x1.8fb7473162452p-7,
    -0x1.b51338b9e9627p-8,0x1.e958872a83517p-9,-0x1.16a58831468a7p-9,0x1.417a4778a2a11p-10,-0x1.77f9573e6d388p-11,
    0x1.b9df66413c051p-12},{0x1.6c78b2125d354p-2,-0x1.d40d6e7c5aed9p-60,-0x1.837ca4aacdcb4p-4,0x1.3db0e8b812afdp-5,
    -0x1.25a4348660b38p-6,0x1.1fa5a877c18bfp-7,-0x1.23c00bc3896afp-8,0x1.2ee82dea61d34p-9,-0x1.3fd712441460cp-10,
    0x1.5612de770023p-11,-0x1.72a449d4a8cd3p-12,0x1.93b8f43328288p-13},{0x1.60f2ff82a8111p-2,0x1.471e31ecedab4p-60,
    -0x1.5ef4d41057dcfp-4,0x1.0cb9e7064db7fp-5,-0x1.cf9a489c1d577p-7,0x1.a7a1dad2f1693p-8,-0x1.90b094104e024p-9,
    0x1.83dcba79ddfaap-10,-0x1.7dc44e2972872p-11,0x1.7c8f394b591dcp-12,-0x1.80218aa99267bp-13,0x1.85e6db617d41fp-14},
    {0x1.567adb6d940c4p-2,0x1.603a23017d6efp-56,-0x1.3fe3b04083b83p-4,0x1.cb8f2891bc58bp-6,-0x1.73a354ef5460cp-7,
    0x1.3e3ee545e61b4p-8,-0x1.1a0225828d68p-9,0x1.ff6462daf29fbp-11,-0x1.d7696c3d4304dp-12,0x1.b80b711b802b5p-13,
    -0x1.9fc35293e4e2fp-14,0x1.8b1ab77c659ebp-15},{0x1.4ce91e8c83072p-2,0x1.657f861fdb2dep-58,-0x1.2532fef37dad6p-4,
    0x1.8cb39d1ede337p-6,-0x1.2df588b4a8c46p-7,0x1.e698d5ac7ae12p-9,-0x1.959c7d13e2d23p-10,0x1.59e2f9cab4cedp-11,
    -0x1.2bd5805697483p-12,0x1.072a5ecb51b9bp-13,-0x1.d36b9d3250039p-15,0x1.a1973cb9a2473p-16}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_eps_approach_only)

/* Hunt and Crossley, damped approach: beta/(1 - eps), 1 - eps < 1/2: 17 rows of degree 10 in y = 1 - eps, nodes 0 + i 0.03125, 0 <= y <= 0.515625.
 * Relative error of the approximation: 2^-58.0 at most, sampled at 25 places of each row. Bits of the rows:
 * 65.9 63.6 59.1 63.8 60.2 58.0 58.3 58.4 65.8 58.4 59.5 61.9 58.7 58.1 58.3 58.7 60.5 */
#define COR_ROWS_CROSSLEY_NEAR_BETA_APPROACH_ONLY_FIRST 0.0
#define COR_ROWS_CROSSLEY_NEAR_BETA_APPROACH_ONLY_STEP 0.03125
#define COR_ROWS_CROSSLEY_NEAR_BETA_APPROACH_ONLY_PER_UNIT 32.0
#define COR_ROWS_CROSSLEY_NEAR_BETA_APPROACH_ONLY_ROWS 17
#define COR_ROWS_CROSSLEY_NEAR_BETA_APPROACH_ONLY_END 0.5
COR_ROWS(double, cor_rows_crossley_near_beta_approach_only, 17, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.8p+1,0x0p+0,0x1.5p+2,0x1.db33333333333p+2,0x1.3119999999999p+3,0x1.738efe898255fp+3,0x1.b55efe8947759p+3,
    0x1.f6c0a664f0d13p+3,0x1.1beb115799e87p+4,0x1.3c5ff93c346ebp+4,0x1.5b90d4c0b0ad9p+4,0x1.9ee9c157cd9d4p+4},
    {0x1.95f783p+1,-0x1.544e3c5e144efp-26,0x1.6f95302ec06d9p+2,0x1.0c8571aa33d73p+3,0x1.6424981bc8095p+3,
    0x1.bfe9f35e71b9ap+3,0x1.103a0addc2be3p+4,0x1.431c2bb710cb2p+4,0x1.78cd850d6baeep+4,0x1.b17b8fdd9f6fap+4,
    0x1.edb34ae466153p+4,0x1.1673efca5bd7ep+5},{0x1.ae08f1p+1,-0x1.5f1a66a44e889p-26,0x1.935978012e2b1p+2,
    0x1.30b5c636ad98p+3,0x1.a1dec6355179bp+3,0x1.0fa8a6a955d07p+4,0x1.555781b01d44bp+4,0x1.a2c624b69e12bp+4,
    0x1.f8c4b79d5c98ep+4,0x1.2c1721c95082ap+5,0x1.6140c39dd2ee7p+5,0x1.9bd32f034b9ebp+5},{0x1.c87cda8p+1,
    -0x1.ea36949c9bc4fp-28,0x1.bc06b33b73193p+2,0x1.5b4a352ebdd1dp+3,0x1.ecffae9cff613p+3,0x1.4bb5ba7552f3bp+4,
    0x1.af54ae96c6884p+4,0x1.11cbc29d9196fp+5,0x1.557c854dc552ep+5,0x1.a4206a4554d74p+5,0x1.ffbb748c656efp+5,
    0x1.34a02ecdf44bap+6},{0x1.e5a8a48p+1,0x1.b392695721ce4p-26,0x1.ea7f262bfd89ap+2,0x1.8dacf1bf982f6p+3,
    0x1.2488a970bb1ebp+4,0x1.97ea969950b9cp+4,0x1.12ca27f4d651ep+5,0x1.696dd9681645bp+5,0x1.d301945cc1afcp+5,
    0x1.2999f3fdae207p+6,0x1.77884501743b3p+6,0x1.d5387702394d8p+6},{0x1.02f8b08p+2,0x1.fd3624d190881p-25,
    0x1.0fec171d6eea2p+3,0x1.c9a9ccb8482bp+3,0x1.5d5d66dfc7e47p+4,0x1.f975c2c4913d7p+4,0x1.613ff58b78c9ep+5,
    0x1.e1fd8d16fd617p+5,0x1.4302e9e1f6e25p+6,0x1.ab060fabc163bp+6,0x1.1779a12fc2014p+7,0x1.6a31254fa8e8p+7},
    {0x1.14e7b6p+2,0x1.23173e10035d6p-25,0x1.2eb428afe4216p+3,0x1.08c6ca722c419p+4,0x1.a414cf939b533p+4,
    0x1.3bbcbb42e7d13p+5,0x1.ca7a1f7644561p+5,0x1.44ebb0b7a6336p+6,0x1.c45f256e36e77p+6,0x1.36976b1776cfp+7,
    0x1.a64cc6d38dda8p+7,0x1.1c378b983f4edp+8},{0x1.28e9858p+2,-0x1.3edbf2eff4d8bp-29,0x1.526cf5fbe4ff4p+3,
    0x1.3428a857d873ap+4,0x1.fcd40cbd31e22p+4,0x1.8df315a96643cp+5,0x1.2c9c4a16b35b5p+6,0x1.bb468282b47ecp+6,
    0x1.4102143721b3dp+7,0x1.ca89b13ce7c9bp+7,0x1.444aaaf7de2b6p+8,0x1.c60c71f827feep+8},{0x1.3f5535p+2,
    -0x1.e0b830db2b627p-28,0x1.7c2222e1f1cbp+3,0x1.68eb41e4122bbp+4,0x1.369dcc28e3d13p+5,0x1.fa619ff5ffc9fp+5,
    0x1.8ea0f6070f5bcp+6,0x1.3241f9d2f93d2p+7,0x1.ce2e4bdd808f4p+7,0x1.57eed6191d743p+8,0x1.fae769383cc4bp+8,
    0x1.71b6eb1355caep+9},{0x1.5894b68p+2,0x1.79cbcf419d7e2p-27,0x1.ad26d20bda47dp+3,0x1.a99e29ed0a123p+4,
    0x1.7e839d6d5a30dp+5,0x1.458944845f06cp+6,0x1.0b867c06ab193p+7,0x1.ad17a338cf557p+7,0x1.51f3dca558aadp+8,
    0x1.067c93f6a91c8p+9,0x1.93d0b2509ba24p+9,0x1.3362c236f20fep+10},{0x1.752a01p+2,0x1.9d0ba21ea48a1p-25,
    0x1.e72d136bf2323p+3,0x1.f9acc25f794c6p+4,0x1.db7e672f13ca2p+5,0x1.a74e6041a0ed9p+6,0x1.6bd98ea5c8663p+7,
    0x1.312b6b1191a98p+8,0x1.f6b3e26d9cb6fp+8,0x1.984c0e0cc4acfp+9,0x1.48747f7a1cf9cp+10,0x1.056ed8f7cfc0ap+11},
    {0x1.95b5f68p+2,-0x1.f1bd8268bd072p-26,0x1.163347c099b4dp+4,0x1.2edb7ba0f4438p+5,0x1.2a95ab696a959p+6,
    0x1.16a3875c8bd37p+7,0x1.f60c45a74d699p+7,0x1.b94bc72350afbp+8,0x1.7ce5561aae35p+9,0x1.442df9444f0cfp+10,
    0x1.114e26ec26a7ep+11,0x1.c7dfe707854dp+11},{0x1.bb01b78p+2,-0x1.62e9f00357fe7p-34,0x1.3fd96080f4d1ap+4,
    0x1.6e0a3f785f335p+5,0x1.7b3d0b52f83efp+6,0x1.73d4afb3a7468p+7,0x1.5fe5f16778ffbp+8,0x1.44e7fa6f5701p+9,
    0x1.268ceb024007p+10,0x1.074b692ac15b6p+11,0x1.d254e6edc9726p+11,0x1.9871abfde99f4p+12},{0x1.e60b76p+2,
    0x1.d403f2eff9575p-28,0x1.7270b6acd25b3p+4,0x1.becd489c0bf0fp+5,0x1.e7b38647ffa18p+6,0x1.f7aa557002c4ep+7,
    0x1.f6007fefba17ep+8,0x1.e8156038df427p+9,0x1.d1ebace4f7cc6p+10,0x1.b68465a78aabbp+11,0x1.98f3888cec952p+12,
    0x1.791c27df7ab5fp+13},{0x1.0c0c28p+3,0x1.b1b765a2e0a37p-30,0x1.b089f79b14cd6p+4,0x1.13b2f05a17ebfp+6,
    0x1.3df13fa53733cp+7,0x1.5ad25d929edb4p+8,0x1.6d11313d3c712p+9,0x1.76d1114f8faf6p+10,0x1.79cc95f1911e3p+11,
    0x1.776f8af825c95p+12,0x1.71bf2e3324b9ap+13,0x1.67f833143b0a4p+14},{0x1.2966d2p+3,-0x1.5f0006c4e5a81p-25,
    0x1.fda7366370215p+4,0x1.586d57e8711d7p+6,0x1.a4f655d5ea2f9p+7,0x1.e68bb3dbad2bap+8,0x1.0f46e73108b1fp+10,
    0x1.27075054762ebp+11,0x1.3af9b486ee5bcp+12,0x1.4b82860332186p+13,0x1.59dea3cd8c9cdp+14,0x1.6499dd069b8cp+15},
    {0x1.4c2ad48p+3,0x1.22d0c0978a2cdp-24,0x1.2f5554c71006dp+5,0x1.b43c03a0b2f53p+6,0x1.1b8644a4cf00bp+8,
    0x1.5c6cf92b8c0e1p+9,0x1.9d0afce51dfd2p+10,0x1.dd7cd28258d76p+11,0x1.0ee8d95bacd4p+13,0x1.2f09d22a8cf5ap+14,
    0x1.501e41d36a7eap+15,0x1.7047912e0c20ep+16}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_near_beta_approach_only)

/* Hunt and Crossley, damped approach: beta by eps, 2^-2 <= eps < 2^-1: 16 rows of degree 10 in y = eps 2^-k, 16 rows in each octave k = -2 ... -2.
 * Relative error of the approximation: 2^-57.4 at most, sampled at 25 places of each row. Bits of the rows:
 * 58.6 60.6 57.4 58.5 58.6 57.9 61.4 59.0 57.4 58.2 60.2 59.7 59.4 58.9 60.2 59.1 */
#define COR_ROWS_CROSSLEY_BETA_APPROACH_ONLY_FIRST 0.25
#define COR_ROWS_CROSSLEY_BETA_APPROACH_ONLY_FIRST_OCTAVE (-2)
#define COR_ROWS_CROSSLEY_BETA_APPROACH_ONLY_OCTAVE_BITS 4
#define COR_ROWS_CROSSLEY_BETA_APPROACH_ONLY_ROWS 16
#define COR_ROWS_CROSSLEY_BETA_APPROACH_ONLY_END 0.5
COR_ROWS(double, cor_rows_crossley_beta_approach_only, 16, 12)
#ifdef COR_ROWS_HERE
= {
    {0x1.a4eab9ea04e0ap+4,-0x1.ad304995722p-50,-0x1.c679516f50f78p+5,0x1.4fe06726476b3p+6,-0x1.b485eaf415773p+6,
    0x1.092602d10ad39p+7,-0x1.34e316b20c6bdp+7,0x1.5dad096b059e5p+7,-0x1.83ad240014cfap+7,0x1.a708bb6a80017p+7,
    -0x1.c923d3baaf1a6p+7,0x1.e7a988c3fdd84p+7},{0x1.70f5a8d4763aep+4,-0x1.19d0c5a07d6a9p-51,-0x1.7bc971b371ec3p+5,
    0x1.09184d2288ec9p+6,-0x1.4509f7f437fa2p+6,0x1.7466671f66858p+6,-0x1.9919094cc56e3p+6,0x1.b4b0f7a35d907p+6,
    -0x1.c8818a7d60665p+6,0x1.d5b1342aca86p+6,-0x1.de6bc7a346c73p+6,0x1.e1360a4b46e06p+6},{0x1.45550b0f792fap+4,
    -0x1.f66135c453976p-51,-0x1.407631bd610dcp+5,0x1.a7f12833a79d2p+5,-0x1.ec04119632ea1p+5,0x1.0ab17d7b36bep+6,
    -0x1.152dcea0134f3p+6,0x1.17e7ce1ce6353p+6,-0x1.14ce0313f24dfp+6,0x1.0d6a578518397p+6,-0x1.03873635e0db8p+6,
    0x1.eddfa9105e472p+5},{0x1.205c903ee81b1p+4,0x1.6597f6c83cadep-51,-0x1.10c0d03018292p+5,0x1.56f46ac6ce7edp+5,
    -0x1.79dc128518f58p+5,0x1.84bd5790bb1efp+5,-0x1.7f5d3d9306ab3p+5,0x1.6f50cc50cd275p+5,-0x1.58a36dcd2ff97p+5,
    0x1.3e3f9a91cc65cp+5,-0x1.22caa5619babdp+5,0x1.0680236115adcp+5},{0x1.00c5ffd110cecp+4,0x1.2bc5ef3c19066p-51,
    -0x1.d3eb474786cf7p+4,0x1.185bdee726854p+5,-0x1.260658a0b0357p+5,0x1.1fd2e7f3d17f8p+5,-0x1.0e0ab807a1bcp+5,
    0x1.ec47617e95bf6p+4,-0x1.b761d99998251p+4,0x1.81f602153d252p+4,-0x1.4f67d22be7a54p+4,0x1.2002e2b3e0548p+4},
    {0x1.cb2ac40c15b74p+3,0x1.f8b3a588884eep-51,-0x1.94326b4bc1696p+4,0x1.cebc70fe9a8fbp+4,-0x1.cf0bebf8e9b33p+4,
    0x1.b0563b8851061p+4,-0x1.82d38625afb23p+4,0x1.50389536d3965p+4,-0x1.1e275054ab172p+4,0x1.df5cbe81cb0dbp+3,
    -0x1.8d24f817151dfp+3,0x1.452c1a1e01c12p+3},{0x1.9c0b40d795f61p+3,0x1.e80ba7f29288cp-52,-0x1.5f6302cf3224bp+4,
    0x1.812cca423889dp+4,-0x1.70926eb4d561p+4,0x1.48f167f77c151p+4,-0x1.194918801a6b2p+4,0x1.d34a8efe6020ap+3,
    -0x1.7c0e23903986ap+3,0x1.3032bc46c4c6p+3,-0x1.e19791105d78dp+2,0x1.78ccd5196b5a2p+2},{0x1.72f5983ab5f1bp+3,
    -0x1.6a83bd3ab0354p-51,-0x1.33421032b29b9p+4,0x1.4323f72a8e27dp+4,-0x1.2846ec8fa5e04p+4,0x1.fa8377afdfddbp+3,
    -0x1.9ec66bc93f73bp+3,0x1.49e6e6a01cd29p+3,-0x1.00ea1fe9fb807p+3,0x1.89c9f0fc9dfc2p+2,-0x1.2a6c18e060c0bp+2,
    0x1.bf1d490621bc6p+1},{0x1.4ef07716c7fcap+3,-0x1.68adbb1a307d1p-52,-0x1.0e1ae80d53b3ep+4,0x1.110da3054194bp+4,
    -0x1.e0a4f77d1e5b2p+3,0x1.8a3993c5bedfdp+3,-0x1.35b4ece786c04p+3,0x1.d89c6ea2b1373p+2,-0x1.610dc0eea1a2ap+2,
    0x1.038ad97b4ad32p+2,-0x1.794a427472111p+1,0x1.0f1c3d7482b9ep+1},{0x1.2f32a2cbb71a9p+3,-0x1.6aefc0a5ffd81p-52,
    -0x1.dd37805c1dcddp+3,0x1.d0851e52b9605p+3,-0x1.891ebb50f0ccdp+3,0x1.35e841e531dedp+3,-0x1.d3edf520d023cp+2,
    0x1.571180a6b44b2p+2,-0x1.ec7ff2cece055p+1,0x1.5bdf9c186c0cfp+1,-0x1.e5d580a06be18p+0,0x1.4f6cf6c880752p+0},
    {0x1.131845e58f3ap+3,0x1.417d9d333b008p-51,-0x1.a779136749d7bp+3,0x1.8d8a06cd361dfp+3,-0x1.44019d6c02b5cp+3,
    0x1.ebc196475f94bp+2,-0x1.6550cceab420ep+2,0x1.f83b1f59c895bp+1,-0x1.5c4cb2c645b28p+1,0x1.d97eaee22979fp+0,
    -0x1.3e2519a85dba1p+0,0x1.a6bc912876c7ap-1},{0x1.f435d3965862ap+2,0x1.f3514ef2eee28p-52,-0x1.7959af7cd7a75p+3,
    0x1.56244b848e9b1p+3,-0x1.0cf190ef7d774p+3,0x1.897f32e0cdd92p+2,-0x1.1394a3faf3b94p+2,0x1.76cb98ca3df31p+1,
    -0x1.f2fe9afc570d9p+0,0x1.46dcc09238619p+0,-0x1.a7410d73dfd57p-1,0x1.0efb9b466d2b2p-1},{0x1.c796c10579984p+2,
    0x1.238aefa323ebap-52,-0x1.518d5a4a508e1p+3,0x1.28028f5a25978p+3,-0x1.c16ce4e936036p+2,0x1.3d5fa556a6be6p+2,
    -0x1.ad08841581e6dp+1,0x1.198c06089fbaep+1,-0x1.69b92f004fcd1p+0,0x1.c94934ae3097dp-1,-0x1.1dac57300c666p-1,
    0x1.60f8f7e5c7abep-2},{0x1.9f9a348b4c961p+2,-0x1.8012ecc5d5272p-52,-0x1.2f097ed61515ap+3,0x1.015956ee5407cp+3,
    -0x1.79d1cec0884b3p+2,0x1.01deb2f1aaa88p+2,-0x1.50da905262e87p+1,0x1.ab2e7bfd6f2e3p+0,-0x1.0922c8d4001e2p+0,
    0x1.43d68b6def787p-1,-0x1.86e393cda150cp-2,0x1.d29e15fcf4654p-3},{0x1.7ba5120027181p+2,0x1.0c452cc47154ep-52,
    -0x1.10f664c15cf9cp+3,0x1.c1833a24faaf2p+2,-0x1.3f71722c0d58fp+2,0x1.a5efb0a8a27c5p+1,-0x1.0a9cc44a3cc38p+1,
    0x1.4710935d80f51p+0,-0x1.88b7bc1595519p-1,0x1.cff7d7c2d734ep-2,-0x1.0ed502d5cc5a7p-2,0x1.38b61cc1c14e1p-3},
    {0x1.5b349c7cbe945p+2,0x1.da3a51375b79cp-52,-0x1.ed4875c699fe1p+2,0x1.8a40ffe8e656ep+2,-0x1.0f88acab04c44p+2,
    0x1.5b6bcba4ec67ap+1,-0x1.a937ed17be0d2p+0,0x1.f92552b5af273p-1,-0x1.25ac08eb0e2fdp-1,0x1.4ff588553f381p-2,
    -0x1.7bc3cc13f659bp-3,0x1.a8950cd9e4afep-4}
}
#endif
;
COR_ROWS_FUNCTION(double, cor_rows_crossley_beta_approach_only)

#endif
