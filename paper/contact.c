/* SPDX-License-Identifier: MIT */
/* Fig. 11: contact time and largest compression against impact speed, from the contact law; contact.gp adds those of
 * collisions.csv. */
#include <math.h>

#include "collisions.h"
#include "cor/disk.h"
#include "report.h"
#include "rigid.h"

static const double pi = 3.14159265358979323846;
static const double nu = 0.33;

static const enum cor_disk_datum datum[] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                            COR_DISK_DATUM_PRINTED};
enum { DATA = sizeof datum / sizeof *datum, POINTS = 121 };

/* All three for the law as printed */
static double rebound_ratio(double speed)
{
    return cor_disk_contact_time(speed, nu, COR_DISK_DATUM_PRINTED) * speed /
           (pi * cor_disk_max_compression(speed, nu, COR_DISK_DATUM_PRINTED));
}

static double time_off(double speed)
{
    return cor_disk_contact_time_leading_log(speed) / cor_disk_contact_time(speed, nu, COR_DISK_DATUM_PRINTED) - 1;
}

static double compression_off(double speed)
{
    return cor_disk_max_compression_leading_log(speed) / cor_disk_max_compression(speed, nu, COR_DISK_DATUM_PRINTED) -
           1;
}

static int write_contact(FILE *csv, char verdict[VERDICT_SIZE])
{
    fputs(
        "speed,contact_time_centre_of_mass,contact_time_diameter,contact_time_printed,contact_time_leading_log,"
        "max_compression_centre_of_mass,max_compression_diameter,max_compression_printed,max_compression_leading_log\n",
        csv);
    const double slowest = 1e-6, fastest = cor_disk_speed_limit(nu, COR_DISK_DATUM_DIAMETER);
    for (int i = 0; i < POINTS; i++) {
        const double v = i < POINTS - 1 ? log_point(slowest, fastest, i, POINTS) : fastest;
        fprintf(csv, "%.6g", v);
        for (int d = 0; d < DATA; d++)
            write_cell(csv, cor_disk_contact_time(v, nu, datum[d]));
        write_cell(csv, cor_disk_contact_time_leading_log(v));
        for (int d = 0; d < DATA; d++)
            write_cell(csv, cor_disk_max_compression(v, nu, datum[d]));
        write_cell(csv, cor_disk_max_compression_leading_log(v));
        fputs("\n", csv);
    }
    const double slow = 1e-4, fast = 0.1, rate = wall[WALLS - 1];
    const int modes = size[SIZES - 1];
    const struct collision *const dynamic[] = {collision_find(nu, modes, rate, 0.01),
                                               collision_find(nu, modes, rate, 0.1),
                                               collision_find(nu, modes, rate, 0.3)};
    snprintf(verdict, VERDICT_SIZE,
             "Agrees: the contact time grows like the root of a logarithm as v falls. tau v/(pi delta_max) tends to "
             "1 slowly (%.4f at v = 1e-2, %.4f at 1e-4, %.4f at 1e-8). (61) is good, because the terms that it "
             "leaves out, b and half the logarithm of its logarithm, nearly cancel at the speeds drawn. Against the "
             "law as printed its tau is off by %+.1f %% at v = %g and by %+.1f %% at %g, its delta_max by %+.1f %% "
             "and %+.1f %%. With the centre of mass as datum tau(%g) = %.4f instead of the printed law's %.4f; with "
             "the diameter it is %.4f. The law ends at v = %.4f, %.4f and %.4f. The full dynamics has %d modes and "
             "alpha = %g/v; its contact lasts while the load is above a thousandth of its largest. It agrees with "
             "the law for the centre of mass: tau(%g) = %.2f, law %.2f, and delta_max %.1f %% below the law's. It "
             "departs from the law where that ends: tau(%g) = %.2f, law %.2f, and goes on to %.2f at v = %g. The "
             "black line is all modes at a rigid wall: tau(%g) = %.4f, tau(%g) = %.4f, delta_max(%g) = %.5f.",
             rebound_ratio(1e-2), rebound_ratio(1e-4), rebound_ratio(1e-8), 100 * time_off(slow), slow,
             100 * time_off(fast), fast, 100 * compression_off(slow), 100 * compression_off(fast), slow,
             cor_disk_contact_time(slow, nu, COR_DISK_DATUM_CENTRE_OF_MASS),
             cor_disk_contact_time(slow, nu, COR_DISK_DATUM_PRINTED),
             cor_disk_contact_time(slow, nu, COR_DISK_DATUM_DIAMETER),
             cor_disk_speed_limit(nu, COR_DISK_DATUM_CENTRE_OF_MASS), cor_disk_speed_limit(nu, COR_DISK_DATUM_PRINTED),
             cor_disk_speed_limit(nu, COR_DISK_DATUM_DIAMETER), modes, rate, 0.01, dynamic[0]->contact_time,
             cor_disk_contact_time(0.01, nu, COR_DISK_DATUM_CENTRE_OF_MASS),
             100 *
                 (1 - dynamic[0]->max_compression / cor_disk_max_compression(0.01, nu, COR_DISK_DATUM_CENTRE_OF_MASS)),
             0.1, dynamic[1]->contact_time, cor_disk_contact_time(0.1, nu, COR_DISK_DATUM_CENTRE_OF_MASS),
             dynamic[2]->contact_time, 0.3, 0.01, rigid_wall(nu, 0.01, RIGID_TOLERANCE).contact_time, 0.1,
             rigid_wall(nu, paper_speed(6), RIGID_TOLERANCE).contact_time, 0.1,
             rigid_wall(nu, paper_speed(6), RIGID_TOLERANCE).max_compression);
    return 1;
}

const struct figure contact_figure = {"contact", "Fig. 11", "contact time and largest compression against speed",
                                      write_contact};
