/* SPDX-License-Identifier: MIT */
/* The dissipation time of a Kelvin-Voigt solid. */
#include <math.h>

#include "cor/contact.h"
#include "runtime/number/si_range.h"

double cor_dissipation_time_viscous_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa, double poisson_ratio)
{
    const double nu = poisson_ratio;
    if (!(eta1_pa_s == 0 || cor_si_in_range(eta1_pa_s)) || !(eta2_pa_s == 0 || cor_si_in_range(eta2_pa_s)) ||
        !cor_si_in_range(young_modulus_pa) || !(isgreater(nu, -1) && islessequal(nu, 0.5)))
        return NAN;
    /* powers of two are handled separately, so that only the result can be out of range */
    int eta_exponent = 0, young_exponent;
    const double most = eta1_pa_s > eta2_pa_s ? eta1_pa_s : eta2_pa_s, young = frexp(young_modulus_pa, &young_exponent);
    if (most == 0)
        return 0;
    frexp(most, &eta_exponent);
    const double eta1 = cor_inline_scaled(eta1_pa_s, -eta_exponent), eta2 = cor_inline_scaled(eta2_pa_s, -eta_exponent);
    const double volume = 1 - 2 * nu; /* exact where it is small */
    const double viscosity = 2.0 / 3 * (1 - nu * (1 - nu)) * eta1 + volume * volume * eta2;
    const double time = (1 + nu) / (1 - nu) * viscosity / young;
    return time == 0 ? 0 : cor_si_scaled(time, eta_exponent - young_exponent);
}
