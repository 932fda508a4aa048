/* SPDX-License-Identifier: MIT */
/* Fig. 1: eps against speed for both materials, from the two extrapolations of section 4. */
#include <math.h>

#include "collisions.h"
#include "cor/disk.h"
#include "limit.h"
#include "report.h"

static const double nu[] = {0.33, 0.9};

static double eps_of(const struct limit *limit)
{
    return sqrt(1 - limit->one_minus_eps2);
}

static double eps_uncertainty(const struct limit *limit)
{
    return limit->uncertainty / (2 * eps_of(limit));
}

/* The curve of cor_disk_eps, as a block for each nu; its largest difference from the points, in units of the sum of both
 * uncertainties, is worth knowing. */
enum { CURVE_POINTS = 81 };
static double write_curves(FILE *csv, struct limit limit[2][PAPER_SPEEDS])
{
    double worst = 0;
    for (int m = 0; m < 2; m++) {
        fputs("\n\n", csv);
        for (int i = 0; i < CURVE_POINTS; i++) {
            const double v = i == CURVE_POINTS - 1
                                 ? COR_DISK_EPS_MAX_SPEED
                                 : log_point(COR_DISK_EPS_MIN_SPEED, COR_DISK_EPS_MAX_SPEED, i, CURVE_POINTS);
            const double eps = cor_disk_eps(v, nu[m]), uncertainty = cor_disk_eps_uncertainty(v, nu[m]);
            fprintf(csv, "%g,%.6g", nu[m], v);
            write_cell(csv, eps);
            write_cell(csv, eps - uncertainty);
            write_cell(csv, eps + uncertainty);
            fprintf(csv, ",%.5f,%.5f\n", cor_disk_one_minus_eps2(v, nu[m]),
                    cor_disk_one_minus_eps2_uncertainty(v, nu[m]));
        }
        for (int i = 0; i < PAPER_SPEEDS; i++) {
            const double v = paper_speed(i), off = limit[m][i].one_minus_eps2 - cor_disk_one_minus_eps2(v, nu[m]);
            worst = fmax(worst, fabs(off) / (limit[m][i].uncertainty + cor_disk_one_minus_eps2_uncertainty(v, nu[m])));
        }
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
    const double apart = write_curves(csv, limit);
    int best = 0;
    for (int i = 0; i < PAPER_SPEEDS; i++)
        if (limit[0][i].one_minus_eps2 < limit[0][best].one_minus_eps2)
            best = i;
    snprintf(verdict, VERDICT_SIZE,
             "Agrees: eps falls as v grows, and is smaller for nu = 0.9. Here eps(%g) = %.3f at nu = 0.33 and %.3f at "
             "0.9, eps(%g) = %.3f and %.3f; uncertain by at most %.4f, narrower than the points, which is the largest "
             "change when fewer or other modes and walls are extrapolated. The line is cor_disk_eps, from limits with "
             "more modes: %.3f and %.3f at v = 0.1, %.3f and %.3f at 0.3; the points "
             "are within %.1f times of what both are uncertain by. Does not agree: at nu = 0.9, v = 0.3 the "
             "text says about 0.65. And eps does not simply tend to one as v falls: at nu = 0.33 it is %.4f at v = %g "
             "but %.4f at %g, as the last figure shows.",
             paper_speed(at_01), eps_of(&limit[0][at_01]), eps_of(&limit[1][at_01]), paper_speed(last),
             eps_of(&limit[0][last]), eps_of(&limit[1][last]), worst, cor_disk_eps(0.1, nu[0]),
             cor_disk_eps(0.1, nu[1]), cor_disk_eps(0.3, nu[0]), cor_disk_eps(0.3, nu[1]), apart,
             eps_of(&limit[0][best]), paper_speed(best), eps_of(&limit[0][0]), paper_speed(0));
    return 1;
}

const struct figure restitution_figure = {"restitution", "Fig. 1", "eps against speed", write_restitution};
