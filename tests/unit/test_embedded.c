/* SPDX-License-Identifier: MIT */
/* generated/cor_sphere.h gives the bits of the library, from this unit and from another one in any language. */
#include "check.h"

#include <cor/cor.h>

#include "cor_sphere.h"
#include "embedded.h"

/* Returns eps at beta^5 = x from a contact with beta_per_root 1. If x > 0 is not a valid speed, uses the header. */
static double contact_eps(int end, double x)
{
    struct cor_sphere_contact c;
    memset(&c, 0, sizeof c);
    c.beta_per_root = c.beta5_per_speed = 1;
    if (x > 0 && !(x >= COR_SI_LEAST && x < COR_SI_MOST))
        return end ? cor_inline_eps_zero_force_root(x) : cor_inline_eps_zero_overlap_root(x);
    return end ? cor_contact_eps_zero_force(&c, x) : cor_contact_eps_zero_overlap(&c, x);
}

static double eps_zero_overlap_root(double x)
{
    return contact_eps(0, x);
}

static double eps_zero_force_root(double x)
{
    return contact_eps(1, x);
}

#define cor_sphere_eps_zero_overlap_root eps_zero_overlap_root
#define cor_sphere_eps_zero_force_root eps_zero_force_root

static const struct {
    const char *name;
    double (*library)(double), (*here)(double);
} functions[EMBEDDED_FUNCTIONS] = {
#define EMBEDDED_ROW(quantity) {#quantity, cor_sphere_##quantity, cor_inline_##quantity},
    EMBEDDED_LIST(EMBEDDED_ROW)
#undef EMBEDDED_ROW
};

/* The difference that COR_EMBEDDED_ULP allows between both units, in units of the last place, if the other unit was
 * compiled with other flags. Special values, and results at special arguments, are equal for all flags. */
static double allowed;

static int is_close(double library, double other)
{
    if (same_number(library, other))
        return 1;
    if (allowed > 0 && library == 0 && other == 0) /* -fno-signed-zeros permits this */
        return 1;
    return isfinite(library) && isfinite(other) && library != 0 && ulp_error(other, (long double)library) <= allowed;
}

static void compare(double x)
{
    for (int k = 0; k < EMBEDDED_FUNCTIONS; k++) {
        const double library = functions[k].library(x), other = embedded_functions[k].value(x);
        check(same_number(library, functions[k].here(x)), "%s(%a)", functions[k].name, x);
        check(is_close(library, other), "%s(%a), the other unit: %a for %a", functions[k].name, x, other, library);
    }
}

TEST(the_same_bits)
{
    for (int k = 0; k < EMBEDDED_FUNCTIONS; k++)
        assert_string_equal(functions[k].name, embedded_functions[k].name);
    const char *const text = getenv("COR_EMBEDDED_ULP");
    allowed = text ? strtod(text, NULL) : 0;
    for (size_t i = 0; i < points(20000); i++) {
        compare(random_uniform(&draw, 0, 1));
        compare(random_uniform(&draw, 0, 20));
        compare(random_log(&draw, 1e-10, 1e10));
        compare(random_log(&draw, 5e-324, DBL_MAX));
    }
    NUMBERS(special, 0.0, -0.0, 1, 7, 8, 16, 0.25, 16807, 1048576, 0x1p-40, 256, 1024, INFINITY, NAN, -INFINITY, -1,
            DBL_MIN, DBL_MAX, 4.9406564584124654e-324, 0x1p-900, 0x1p100, 0x1p250);
    for (size_t i = 0; i < COUNT_OF(special); i++) {
        compare(special[i]);
        compare(nextafter(special[i], 0));
        compare(nextafter(special[i], INFINITY));
    }
    for (int i = 0; i < 512; i++) {
        compare((i + 0.5) / 32);
        compare((i + 0.5) / 32 * ((i + 0.5) / 32));
        compare(exp(i / 16.0));
    }
    /* both ends of every cell of tables by octaves, where the highest coefficients count most */
    const int cells = 1 << COR_ROWS_POWER_EPS_ZERO_OVERLAP_OCTAVE_BITS;
    for (int octave = -60; octave < 20; octave++)
        for (int cell = 0; cell < cells; cell++) {
            compare(ldexp(1 + (cell + 0.02) / cells, octave));
            compare(ldexp(1 + (cell + 0.98) / cells, octave));
        }
}
