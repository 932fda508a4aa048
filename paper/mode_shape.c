/* SPDX-License-Identifier: MIT */
#include "mode_shape.h"

#include <math.h>

/* J_n, and its derivative times z */
struct bessel {
    double j, slope;
};

static struct bessel bessel_at(int n, double z)
{
    const double j = jn(n, z);
    return (struct bessel){j, n == 0 ? -z * j1(z) : z * jn(n - 1, z) - n * j};
}

void mode_displacement(const struct mode_shape *shape, double r, double *u_r, double *u_phi)
{
    const struct bessel a = bessel_at(shape->n, shape->kappa * r), b = bessel_at(shape->n, shape->kappa_prime * r);
    *u_r = (shape->a * a.slope + shape->n * shape->b * b.j) / r;
    *u_phi = -(shape->n * shape->a * a.j + shape->b * b.slope) / r;
}

struct mode_shape mode_shape_of(const struct cor_disk_mode *mode, double nu)
{
    const int n = mode->n;
    struct mode_shape shape = {.n = n,
                               .l = mode->l,
                               .omega = mode->omega,
                               .kappa = mode->omega * sqrt(1 - nu * nu),
                               .kappa_prime = mode->omega * sqrt(2 * (1 + nu)),
                               .a = 1};
    if (n > 0) {
        /* (22)/(1 - nu) and (23)/2: p A + q B = 0, of which that with the larger coefficients says more */
        const double diagonal = mode->omega * mode->omega * (1 + nu) - n * n;
        const struct bessel a = bessel_at(n, shape.kappa), b = bessel_at(n, shape.kappa_prime);
        double p = -(a.slope + diagonal * a.j), q = n * (b.slope - b.j);
        const double p23 = -n * (a.slope - a.j), q23 = b.slope + diagonal * b.j;
        if (fabs(p23) + fabs(q23) > fabs(p) + fabs(q)) {
            p = p23;
            q = q23;
        }
        shape.a = q;
        shape.b = -p;
    }
    double u_r, u_phi;
    mode_displacement(&shape, 1, &u_r, &u_phi);
    const double scale = fabs(mode->c) >= fabs(mode->s) ? mode->c / u_r : mode->s / u_phi;
    shape.a *= scale;
    shape.b *= scale;
    return shape;
}
