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
    if (!relaxed_disk_press(curve->disk, compression, &fine) || !relaxed_disk_press(curve->coarse, compression, &coarse))
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
                fprintf(stderr, "cor_report: no relaxed disk at a compression of %g\n", delta);
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
    snprintf(verdict, VERDICT_SIZE,
             "The relaxed disk of the paper, alpha = %g and %d modes, carries P = %.6f at delta = 0.05 and %.6f at 0.2. It agrees "
             "with the text that it and the contact law part at large delta; but which law it meets at small delta the print "
             "hides: x_0 in (41) is the centre of mass, and with that datum P of the relaxed disk over P of the law at delta = "
             "%g is %.4f with all modes and alpha = %g, %.4f with %g, against %.4f with the paper's %d modes and alpha = %g, "
             "whose soft wall is felt before it is touched. The law as printed, (57), lies %.1f %% below the law of the centre "
             "of mass there, the diameter's %.1f %%. At delta = %g the hardest wall carries %.3f of the law, which takes the "
             "contact for small. The dynamic curves are not drawn here. The loads are exact to %.0e: halving the points changes "
             "them by no more.",
             paper_alpha, PAPER_MODES, load_of(&curve[PAPER], 0.05), load_of(&curve[PAPER], 0.2), small,
             ratio_small[HARDEST], hardest_alpha, ratio_small[HARD], hard_alpha, ratio_small[PAPER], PAPER_MODES,
             paper_alpha,
             100 * (1 - law(small, COR_DISK_DATUM_PRINTED) / law(small, COR_DISK_DATUM_CENTRE_OF_MASS)),
             100 * (1 - law(small, COR_DISK_DATUM_DIAMETER) / law(small, COR_DISK_DATUM_CENTRE_OF_MASS)), large,
             ratio_large[HARDEST], coarse);
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
        {"relaxed_all_modes_alpha_20000", relaxed_disk_of_all_modes(nu, hardest_alpha, 768),
         relaxed_disk_of_all_modes(nu, hardest_alpha, 384), 0},
    };
    int made = 1;
    for (int k = 0; k < CURVES; k++)
        made = made && curve[k].disk != NULL && curve[k].coarse != NULL;
    if (!made)
        fprintf(stderr, "cor_report: out of memory\n");
    made = made && write_curves(csv, curve, verdict);
    for (int k = 0; k < CURVES; k++) {
        relaxed_disk_free(curve[k].disk);
        relaxed_disk_free(curve[k].coarse);
    }
    return made;
}

const struct figure load_figure = {"load", "Fig. 10", "load against compression: contact law and relaxed disk", write_load};
