/* SPDX-License-Identifier: MIT */
/* The dissipation time of a Kelvin-Voigt solid. */
#include <float.h>
#include <math.h>

#include "cor/contact.h"
#include "runtime/number/environment.h"

static double dissipation_time(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa, double poisson_ratio)
{
    const double nu = poisson_ratio;
    if (!(eta1_pa_s >= 0 && eta1_pa_s <= DBL_MAX && eta2_pa_s >= 0 && eta2_pa_s <= DBL_MAX && young_modulus_pa > 0 &&
          young_modulus_pa <= DBL_MAX && nu > -1 && nu <= 0.5))
        return NAN;
    /* powers of two are kept apart, so that only the result can overflow or underflow */
    int eta_exponent = 0, young_exponent;
    const double most = eta1_pa_s > eta2_pa_s ? eta1_pa_s : eta2_pa_s, young = frexp(young_modulus_pa, &young_exponent);
    if (most == 0)
        return 0;
    frexp(most, &eta_exponent);
    const double eta1 = ldexp(eta1_pa_s, -eta_exponent), eta2 = ldexp(eta2_pa_s, -eta_exponent);
    const double volume = 1 - 2 * nu; /* exact where it is small */
    const double viscosity = 2.0 / 3 * (1 - nu * (1 - nu)) * eta1 + volume * volume * eta2;
    const int exponent = eta_exponent - young_exponent;
    const double time = (1 + nu) / (1 - nu) * viscosity / young;
    return exponent > 1000 && time * ldexp(1, exponent - 1030) >= ldexp(1, -6) ? INFINITY : ldexp(time, exponent);
}

COR_IN_ENVIRONMENT(double, cor_dissipation_time_viscous_s, dissipation_time,
                   (double eta1_pa_s, double eta2_pa_s, double young_modulus_pa, double poisson_ratio),
                   (eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio))
