/* SPDX-License-Identifier: MIT */
/* Fig. 1: eps against speed for both materials, from the two extrapolations of section 4. */
#include <math.h>

#include "collisions.h"
#include "limit.h"
#include "report.h"
#include "rigid.h"

static const double nu[] = {0.33, 0.9};

static double eps_of(const struct limit *limit)
{
    return sqrt(1 - limit->one_minus_eps2);
}

static double eps_uncertainty(const struct limit *limit)
{
    return limit->uncertainty / (2 * eps_of(limit));
}

static double eps_at(int m, int i)
{
    return rigid_wall(nu[m], paper_speed(i), RIGID_TOLERANCE).eps;
}

/* The largest distance of the points from the limit itself, in units of what both are uncertain by */
static double distance_from_limit(struct limit limit[2][PAPER_SPEEDS])
{
    double worst = 0;
    for (int m = 0; m < 2; m++)
        for (int i = 0; i < PAPER_SPEEDS; i++) {
            const struct cor_disk_hard_wall out = rigid_wall(nu[m], paper_speed(i), RIGID_TOLERANCE);
            const double off = limit[m][i].one_minus_eps2 - out.one_minus_eps2;
            worst = fmax(worst, fabs(off) / (limit[m][i].uncertainty + out.error_estimate));
        }
    return worst;
}

static int write_restitution(FILE *csv, char verdict[VERDICT_SIZE])
{
    static struct limit limit[2][PAPER_SPEEDS];
    double worst = 0;
    fputs("nu,speed,eps,eps_low,eps_high,one_minus_eps2,uncertainty\n", csv);
    for (int m = 0; m < 2; m++) {
        for (int i = 0; i < PAPER_SPEEDS; i++) {
            struct limit *const l = &limit[m][i];
            *l = limit_of(nu[m], paper_speed(i));
            fprintf(csv, "%g,%g", nu[m], paper_speed(i));
            write_cell(csv, eps_of(l));
            write_cell(csv, sqrt(1 - l->one_minus_eps2 - l->uncertainty));
            write_cell(csv, sqrt(1 - l->one_minus_eps2 + l->uncertainty));
            fprintf(csv, ",%.5f,%.5f\n", l->one_minus_eps2, l->uncertainty);
            worst = fmax(worst, eps_uncertainty(l));
        }
        fputs(m == 0 ? "\n\n" : "", csv);
    }
    const int at_01 = 6, last = PAPER_SPEEDS - 1;
    const double apart = distance_from_limit(limit);
    int best = 0;
    for (int i = 0; i < PAPER_SPEEDS; i++)
        if (limit[0][i].one_minus_eps2 < limit[0][best].one_minus_eps2)
            best = i;
    snprintf(verdict, VERDICT_SIZE,
             "Agrees: eps falls as v grows, and is smaller for nu = 0.9. Here eps(%g) = %.3f at nu = 0.33 and %.3f at "
             "0.9, eps(%g) = %.3f and %.3f. These values are uncertain by at most %.4f, narrower than the points: the "
             "largest change when fewer or other modes and walls are extrapolated. The line is the limit itself, all "
             "modes at a rigid wall: %.5f and %.5f at v = 0.1, %.5f and %.5f at 0.3. The points are within %.1f times "
             "both uncertainties together. Does not agree: at nu = 0.9, v = 0.3 the text says about 0.65. Nor does eps "
             "simply tend to one as v falls: at nu = 0.33 it is %.4f at v = %g but %.4f at %g (last figure).",
             paper_speed(at_01), eps_of(&limit[0][at_01]), eps_of(&limit[1][at_01]), paper_speed(last),
             eps_of(&limit[0][last]), eps_of(&limit[1][last]), worst, eps_at(0, at_01), eps_at(1, at_01),
             eps_at(0, last), eps_at(1, last), apart, eps_of(&limit[0][best]), paper_speed(best), eps_of(&limit[0][0]),
             paper_speed(0));
    return 1;
}

const struct figure restitution_figure = {"restitution", "Fig. 1", "eps against speed", write_restitution};
