/* SPDX-License-Identifier: MIT */
/* Published formulas that simulators use, for comparisons with exact functions */
#ifndef COR_RUNTIME_SCENE_SIMULATORS_H
#define COR_RUNTIME_SCENE_SIMULATORS_H

/* Thornton, Cummins and Cleary, Powder Technol. 233, 30 (2013): damping 2 gamma sqrt(m k_tangent), fitted to zero
 * force */
double cor_thornton_gamma(double e);
/* The polynomial of Tsuji, Tanaka and Ishida, Powder Technol. 71, 239 (1992), in the form of LAMMPS */
double cor_tsuji_alpha(double e);
/* beta as a function of e: Flores et al. (2011) */
double cor_flores_beta(double e);

#endif
