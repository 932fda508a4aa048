/* SPDX-License-Identifier: MIT */
/* Restitution coefficient of viscoelastic spheres, x'' + beta sqrt(x) x' + x^(3/2) = 0,
 * for 0 <= beta <= 2 (COR_SPHERE_PADE_BETA_MAX), as Pade approximants in z:
 *     eps = P(z)/Q(z),    1 - eps = beta L(z)/Q(z),    L = (Q - P)/beta,
 * z = beta where the contact ends with zero overlap, z = sqrt(beta) where it ends with zero force.
 * Arrays hold ascending powers of z; q[0] = 1. Source: docs/derivation.md, 4, 5 and 7.
 *
 * Written by:  corgen tables
 * Checked by:  corgen tables --check
 *
 * Each double is the one nearest to the exact coefficient, which stands beside it: proved. The
 * errors of approximation (sampled) and of evaluation (proved) stand above each. */
#ifndef COR_GENERATED_SPHERE_PADE_H
#define COR_GENERATED_SPHERE_PADE_H

/* Every bound below holds for 0 <= beta <= this. */
#define COR_SPHERE_PADE_BETA_MAX 2.0

/* eps at zero overlap, z = beta, [12/20].
 * poles on beta > 0: none (proved: 20 of 20 roots of the denominator isolated)
 * zeros on beta > 0: none (proved: 12 of 12 roots of the numerator isolated)
 * pole-zero pair at beta = -1.3954062 (distance 7.4e-03), away from the positive axis: harmless
 * Relative error of the approximation, coefficients rounded: sampled at 264 values of beta up to 2
 * (256 steps, and powers of 2 near 0):
 *   eps  5.3e-11, worst at beta = 2
 *   loss 5.6e-12, worst at beta = 2
 * Relative error of the evaluation in double, Horner's rule: proved by interval arithmetic over
 * 0 <= beta <= 2:
 *   eps  1.1e-13, loss 4.7e-14 */
enum {
    COR_SPHERE_PADE_ZERO_OVERLAP_P = 13,
    COR_SPHERE_PADE_ZERO_OVERLAP_Q = 21,
    COR_SPHERE_PADE_ZERO_OVERLAP_L = 20
};
#define COR_SPHERE_PADE_ZERO_OVERLAP_EPS_APPROXIMATION_REL 5.3e-11
#define COR_SPHERE_PADE_ZERO_OVERLAP_LOSS_APPROXIMATION_REL 5.6e-12
#define COR_SPHERE_PADE_ZERO_OVERLAP_EPS_EVALUATION_REL 1.1e-13
#define COR_SPHERE_PADE_ZERO_OVERLAP_LOSS_EVALUATION_REL 4.7e-14
#define COR_SPHERE_PADE_ZERO_OVERLAP_EPS_MAX_REL 5.3e-11
#define COR_SPHERE_PADE_ZERO_OVERLAP_LOSS_MAX_REL 5.6e-12
static const double cor_sphere_pade_zero_overlap_p[] = {
    0x1p+0, /* [0] 1 */
    0x1.d143d27819168p+0, /* [1] 1.817441133805084873739983 */
    0x1.d4b1f42433799p-2, /* [2] 0.4577100894065267340559279 */
    -0x1.89c67dc7beb3ep-1, /* [3] -0.7690924936608564880016608 */
    -0x1.2009cbc0628b8p-2, /* [4] -0.2812873684093903994209990 */
    0x1.78faafcae6a08p-3, /* [5] 0.1840718969150005874421877 */
    0x1.bc0896526f951p-5, /* [6] 0.05420331344383789616447317 */
    -0x1.e0f3dab300c22p-6, /* [7] -0.02935501439425192817564946 */
    -0x1.fc185f0959185p-9, /* [8] -0.003876458741318868881683281 */
    0x1.645549eff3d8ep-9, /* [9] 0.002718606257964223832628247 */
    -0x1.7e51f4fa6c823p-15, /* [10] -0.00004557611278545338931464732 */
    -0x1.9f7cd88ed497bp-14, /* [11] -0.00009905998215956570840395584 */
    0x1.6b9627bc2f933p-17, /* [12] 0.00001083572339443932742400653 */
};
static const double cor_sphere_pade_zero_overlap_q[] = {
    0x1p+0, /* [0] 1 */
    0x1.7c461f8d9ce75p+1, /* [1] 2.970889991900373672870550 */
    0x1.8b0908b71cda3p+1, /* [2] 3.086213197145939130228676 */
    0x1.e2500e3b9c289p-1, /* [3] 0.9420170257345300030342680 */
    -0x1.d08b2490b6321p-2, /* [4] -0.4536557877850545010614245 */
    -0x1.1f28a302868b1p-2, /* [5] -0.2804284544269064787467181 */
    0x1.7076af5eba949p-5, /* [6] 0.04497846843681203158331950 */
    0x1.4ac1dd0d3d06fp-5, /* [7] 0.04037564443743312701440145 */
    -0x1.885c42e0972fep-9, /* [8] -0.002993472255452877440148119 */
    -0x1.6a1e392022e6bp-9, /* [9] -0.002762741540271387237646726 */
    0x1.1cb0e3e69a9c6p-12, /* [10] 0.0002715024733449779856129148 */
    0x1.6e6270dc3dbd3p-14, /* [11] 0.00008735288014692583048647222 */
    -0x1.49ab331a41aacp-17, /* [12] -9.824894324339993705402261e-6 */
    0x1.ea48fc3558c7ap-25, /* [13] 5.707669751655317129874042e-8 */
    0x1.4cc81158d40dp-25, /* [14] 3.874086713115623454910549e-8 */
    0x1.1b42a05538431p-28, /* [15] 4.121979276325791382909494e-9 */
    0x1.6eb19bd9aab07p-30, /* [16] 1.334024216107552270416232e-9 */
    0x1.21a47eb3f16c7p-33, /* [17] 1.317141861058481018805344e-10 */
    0x1.3053b76bc3525p-35, /* [18] 3.459797625641524999308148e-11 */
    0x1.3127199e2ca31p-39, /* [19] 2.168240589012194822751732e-12 */
    0x1.1ea9236b47ffbp-41, /* [20] 5.092116891739765512151361e-13 */
};
static const double cor_sphere_pade_zero_overlap_l[] = {
    0x1.27486ca320b83p+0, /* [0] 1.153448858095288799130567 */
    0x1.5072ca32966bp+1, /* [1] 2.628503107739412396172749 */
    0x1.b60b4601ad6e3p+0, /* [2] 1.711109519395386491035929 */
    -0x1.6102b1a0a74d2p-3, /* [3] -0.1723684193756641016404255 */
    -0x1.dba5fae7f9db5p-2, /* [4] -0.4645003513419070661889058 */
    -0x1.2e479bced4022p-7, /* [5] -0.009224845007025864581153672 */
    0x1.1d9de5335eb4p-4, /* [6] 0.06973065883168505519005091 */
    0x1.cef070a307a1ap-11, /* [7] 0.0008829864858659914415351616 */
    -0x1.6739c1880b5fdp-8, /* [8] -0.005481347798235611070274973 */
    0x1.4c7b2285e82cbp-12, /* [9] 0.0003170785861304313749275621 */
    0x1.86efa4b5892a7p-13, /* [10] 0.0001864128623064915388904281 */
    -0x1.5aa0ad6b389fp-16, /* [11] -0.00002066061771877932112940879 */
    0x1.ea48fc3558c7ap-25, /* [12] 5.707669751655317129874042e-8 */
    0x1.4cc81158d40dp-25, /* [13] 3.874086713115623454910549e-8 */
    0x1.1b42a05538431p-28, /* [14] 4.121979276325791382909494e-9 */
    0x1.6eb19bd9aab07p-30, /* [15] 1.334024216107552270416232e-9 */
    0x1.21a47eb3f16c7p-33, /* [16] 1.317141861058481018805344e-10 */
    0x1.3053b76bc3525p-35, /* [17] 3.459797625641524999308148e-11 */
    0x1.3127199e2ca31p-39, /* [18] 2.168240589012194822751732e-12 */
    0x1.1ea9236b47ffbp-41, /* [19] 5.092116891739765512151361e-13 */
};

/* eps at zero force, z = sqrt(beta), [15/19].
 * poles on beta > 0: none (proved: 19 of 19 roots of the denominator isolated)
 * zeros on beta > 0: none (proved: 15 of 15 roots of the numerator isolated)
 * pole-zero pairs closer than 1/100 of their distance from 0: none
 * Relative error of the approximation, coefficients rounded: sampled at 264 values of beta up to 2
 * (256 steps, and powers of 2 near 0):
 *   eps  4.5e-11, worst at beta = 2
 *   loss 1.2e-11, worst at beta = 2
 * Relative error of the evaluation in double, Horner's rule: proved by interval arithmetic over
 * 0 <= beta <= 2:
 *   eps  1.2e-14, loss 1.3e-14 */
enum {
    COR_SPHERE_PADE_ZERO_FORCE_P = 16,
    COR_SPHERE_PADE_ZERO_FORCE_Q = 20,
    COR_SPHERE_PADE_ZERO_FORCE_L = 18
};
#define COR_SPHERE_PADE_ZERO_FORCE_EPS_APPROXIMATION_REL 4.5e-11
#define COR_SPHERE_PADE_ZERO_FORCE_LOSS_APPROXIMATION_REL 1.2e-11
#define COR_SPHERE_PADE_ZERO_FORCE_EPS_EVALUATION_REL 1.2e-14
#define COR_SPHERE_PADE_ZERO_FORCE_LOSS_EVALUATION_REL 1.3e-14
#define COR_SPHERE_PADE_ZERO_FORCE_EPS_MAX_REL 4.5e-11
#define COR_SPHERE_PADE_ZERO_FORCE_LOSS_MAX_REL 1.2e-11
static const double cor_sphere_pade_zero_force_p[] = {
    0x1p+0, /* [0] 1 */
    0x1.6093fcaf724a8p+1, /* [1] 2.754516206423961246262900 */
    0x1.8552c21631aa7p+2, /* [2] 6.083176156686625444891106 */
    0x1.3f6066333b7d3p+3, /* [3] 9.980517482817879295566536 */
    0x1.b5f07a6d5d125p+3, /* [4] 13.68560525283880636380768 */
    0x1.f76d54c737b3bp+3, /* [5] 15.73209608945545827723407 */
    0x1.f44d3302bd4fcp+3, /* [6] 15.63442373786028066352477 */
    0x1.ad36a6354b753p+3, /* [7] 13.41292105111248249374683 */
    0x1.3ee33fa18241bp+3, /* [8] 9.965240302512076599580386 */
    0x1.990e864e0ba66p+2, /* [9] 6.391511512962642602698046 */
    0x1.becebb822df8cp+1, /* [10] 3.490683973850485329218112 */
    0x1.9868eed5b83e7p+0, /* [11] 1.595351149728452489174894 */
    0x1.2e0f3b09f64b8p-1, /* [12] 0.5899599504147294900523537 */
    0x1.56354013a6c56p-3, /* [13] 0.1670937543866297158479268 */
    0x1.0a804808eb4cbp-5, /* [14] 0.03253187245659601788999994 */
    0x1.a2d30a61a4706p-9, /* [15] 0.003195376412642117454577263 */
};
static const double cor_sphere_pade_zero_force_q[] = {
    0x1p+0, /* [0] 1 */
    0x1.6093fcaf724a8p+1, /* [1] 2.754516206423961246262900 */
    0x1.cf24dd3ef9d88p+2, /* [2] 7.236625014781914244021674 */
    0x1.a50bf80e51793p+3, /* [3] 13.15771105572256420040056 */
    0x1.53c02a8580b83p+4, /* [4] 21.23441555165801236879495 */
    0x1.c717e99fda775p+4, /* [5] 28.44333803599098043425905 */
    0x1.111c506ab3d5bp+5, /* [6] 34.13882525788604438873464 */
    0x1.1d83e2d022c1bp+5, /* [7] 35.68939745527333315651678 */
    0x1.0cb6ba3059433p+5, /* [8] 33.58922231457145191849296 */
    0x1.bfecdf09ba266p+4, /* [9] 27.99532989310900803274057 */
    0x1.4f2a78a709977p+4, /* [10] 20.94786896943102443283504 */
    0x1.bbe589552ef27p+3, /* [11] 13.87176958691959631172783 */
    0x1.04efe006127e6p+3, /* [12] 8.154281627521367783395556 */
    0x1.0b375786b42c1p+2, /* [13] 4.175252801462818944219142 */
    0x1.d84eb159c1289p+0, /* [14] 1.844950756466604218345647 */
    0x1.5cf9471811e2dp-1, /* [15] 0.6815893380052721178159091 */
    0x1.9f93f12d68749p-3, /* [16] 0.2029188959104948488097384 */
    0x1.6ce8bd306f94cp-5, /* [17] 0.04454457236305362111677162 */
    0x1.951a83ba334e1p-8, /* [18] 0.006181389961239265505415417 */
    0x1.0341fa62b4e18p-13, /* [19] 0.0001236237177041222793671349 */
};
static const double cor_sphere_pade_zero_force_l[] = {
    0x1.27486ca320b83p+0, /* [0] 1.153448858095288799130567 */
    0x1.96ae476c57f01p+1, /* [1] 3.177193572904684904834024 */
    0x1.e31fb53b48bc1p+2, /* [2] 7.548810298819206004987265 */
    0x1.96c27e787d3afp+3, /* [3] 12.71124194653552215702498 */
    0x1.2812075409037p+4, /* [4] 18.50440152002576372520987 */
    0x1.646c72859fc8dp+4, /* [5] 22.27647640416085066276995 */
    0x1.79fbd48ff1659p+4, /* [6] 23.62398201205937531891257 */
    0x1.59a93d76373ccp+4, /* [7] 21.60381838014636543004253 */
    0x1.1750a136c3d86p+4, /* [8] 17.45718499558053910361693 */
    0x1.88d86b7a77eaap+3, /* [9] 12.27641843719114382255293 */
    0x1.e41dd8aae6335p+2, /* [10] 7.564321677106638293343202 */
    0x1.0085ad8616f5ep+2, /* [11] 4.008159047076189228371215 */
    0x1.cffaaf1979ce3p+0, /* [12] 1.812418884010008200455647 */
    0x1.5b56740db03e6p-1, /* [13] 0.6783939615926300003613319 */
    0x1.9f93f12d68749p-3, /* [14] 0.2029188959104948488097384 */
    0x1.6ce8bd306f94cp-5, /* [15] 0.04454457236305362111677162 */
    0x1.951a83ba334e1p-8, /* [16] 0.006181389961239265505415417 */
    0x1.0341fa62b4e18p-13, /* [17] 0.0001236237177041222793671349 */
};

#endif
