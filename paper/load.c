/* SPDX-License-Identifier: MIT */
/* Fig. 10: load against compression, without the dynamic curves. The contact law (57) with its three data, and disks
 * relaxed against a wall of finite hardness alpha. */
#include <math.h>

#include "cor/disk.h"
#include "relaxed_disk.h"
#include "report.h"

static const double nu = 0.33;
static const double paper_alpha = 500, hard_alpha = 2000, hardest_alpha = 20000;
enum { PAPER_MODES = 1300 };

/* Logarithmic from the first to the second, where it goes on in steps up to the last */
static const double from = 1e-3, steps_from = 0.01, up_to = 0.3, step = 0.0025;
enum { LOG_POINTS = 31 };

static double compression_at(int i)
{
    return i < LOG_POINTS ? log_point(from, steps_from, i, LOG_POINTS) : steps_from + (i - LOG_POINTS + 1) * step;
}

struct curve {
    const char *column;
    struct relaxed_disk *disk, *coarse; /* the second with half the points */
    double coarse_error;                /* largest relative difference of both */
};

static double load_of(struct curve *curve, double compression)
{
    struct relaxed_state fine, coarse;
    if (!relaxed_disk_press(curve->disk, compression, &fine) ||
        !relaxed_disk_press(curve->coarse, compression, &coarse))
        return NAN;
    curve->coarse_error = fmax(curve->coarse_error, fabs(coarse.load / fine.load - 1));
    return fine.load;
}

static double law(double compression, enum cor_disk_datum datum)
{
    return cor_disk_load(compression, nu, datum);
}

enum { PAPER, ALL, HARD, HARDEST, CURVES };

static int write_curves(FILE *csv, struct curve curve[CURVES], char verdict[VERDICT_SIZE])
{
    fputs("compression,law_centre_of_mass,law_diameter,law_printed,law_leading_log", csv);
    for (int k = 0; k < CURVES; k++)
        fprintf(csv, ",%s", curve[k].column);
    fputs("\n", csv);
    for (int i = 0; compression_at(i) < up_to + step / 2; i++) {
        const double delta = compression_at(i);
        fprintf(csv, "%.6g", delta);
        write_cell(csv, law(delta, COR_DISK_DATUM_CENTRE_OF_MASS));
        write_cell(csv, law(delta, COR_DISK_DATUM_DIAMETER));
        write_cell(csv, law(delta, COR_DISK_DATUM_PRINTED));
        write_cell(csv, cor_disk_load_leading_log(delta));
        for (int k = 0; k < CURVES; k++) {
            const double load = load_of(&curve[k], delta);
            if (isnan(load)) {
                fprintf(stderr, "cor_paper: no relaxed disk at a compression of %g\n", delta);
                return 0;
            }
            write_cell(csv, load);
        }
        fputs("\n", csv);
    }

    const double small = 0.03, large = 0.2;
    double ratio_small[CURVES], ratio_large[CURVES];
    for (int k = 0; k < CURVES; k++) {
        ratio_small[k] = load_of(&curve[k], small) / law(small, COR_DISK_DATUM_CENTRE_OF_MASS);
        ratio_large[k] = load_of(&curve[k], large) / law(large, COR_DISK_DATUM_CENTRE_OF_MASS);
    }
    double coarse = 0;
    for (int k = 0; k < CURVES; k++)
        coarse = fmax(coarse, curve[k].coarse_error);
    const double limit = law(small, COR_DISK_DATUM_CENTRE_OF_MASS);
    snprintf(verdict, VERDICT_SIZE,
             "Agrees: the relaxed disk (alpha = %g, %d modes: P = %.6f at delta = 0.05, %.6f at 0.2) and the "
             "contact law differ at large delta. At small delta the relaxed disk does not follow the printed law: "
             "x_0 in (41) is the centre of mass. P tends to the law with that datum as the wall hardens. At delta = "
             "%g the ratio of both is %.4f for alpha = %g (%d modes), %.4f for %g and %.4f for %g (all modes). A "
             "soft wall pushes before it is touched. There the printed law, (57), is %.1f %% below that limit, the "
             "law of the diameter %.1f %%. At delta = %g the hardest wall carries %.3f of the law, which assumes a "
             "small contact. Halving the number of points changes no load by more than the fraction %.0e.",
             paper_alpha, PAPER_MODES, load_of(&curve[PAPER], 0.05), load_of(&curve[PAPER], 0.2), small,
             ratio_small[PAPER], paper_alpha, PAPER_MODES, ratio_small[HARD], hard_alpha, ratio_small[HARDEST],
             hardest_alpha, 100 * (1 - law(small, COR_DISK_DATUM_PRINTED) / limit),
             100 * (1 - law(small, COR_DISK_DATUM_DIAMETER) / limit), large, ratio_large[HARDEST], coarse);
    return 1;
}

static int write_load(FILE *csv, char verdict[VERDICT_SIZE])
{
    const struct cor_disk_modes *modes = &cor_disk_modes_nu033;
    struct curve curve[CURVES] = {
        {"relaxed_1300_modes_alpha_500", relaxed_disk_of_modes(modes, PAPER_MODES, paper_alpha, 192),
         relaxed_disk_of_modes(modes, PAPER_MODES, paper_alpha, 96), 0},
        {"relaxed_all_modes_alpha_500", relaxed_disk_of_all_modes(nu, paper_alpha, 192),
         relaxed_disk_of_all_modes(nu, paper_alpha, 96), 0},
        {"relaxed_all_modes_alpha_2000", relaxed_disk_of_all_modes(nu, hard_alpha, 320),
         relaxed_disk_of_all_modes(nu, hard_alpha, 160), 0},
        {"relaxed_all_modes_alpha_20000", relaxed_disk_of_all_modes(nu, hardest_alpha, 512),
         relaxed_disk_of_all_modes(nu, hardest_alpha, 256), 0},
    };
    int made = 1;
    for (int k = 0; k < CURVES; k++)
        made = made && curve[k].disk != NULL && curve[k].coarse != NULL;
    if (!made)
        fprintf(stderr, "cor_paper: out of memory\n");
    made = made && write_curves(csv, curve, verdict);
    for (int k = 0; k < CURVES; k++) {
        relaxed_disk_free(curve[k].disk);
        relaxed_disk_free(curve[k].coarse);
    }
    return made;
}

const struct figure load_figure = {"load", "Fig. 10", "load against compression: contact law and relaxed disk",
                                   write_load};
