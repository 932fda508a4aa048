/* SPDX-License-Identifier: MIT */
/* Load and contact time of a disk from rows of generated/disk_law_tables.h, whose argument is q of
 * runtime/disk/quasistatic.c. quasistatic.c computes them next to the limit (q < 1/4) and for tiny arguments
 * (q >= 128). */
#define COR_ROWS_DEFINE
#include "generated/disk_law_tables.h"
#include "runtime/disk/quasistatic.h"
#include "runtime/table/row.h"

/* True if q has a row. Both tables have the same cells. */
static int has_row(double q)
{
    return cor_inline_between(q, COR_ROWS_DISK_LOAD_FACTOR_FIRST, COR_ROWS_DISK_LOAD_FACTOR_END);
}

/* Returns the place of q + rest. The code scales rest by 2^-k, where 2^k <= q < 2^(k+1). */
static struct cor_inline_place place_of(double q, double rest, struct cor_inline_octaves grid,
                                        const double *(*rows)(int))
{
    struct cor_inline_place place = cor_inline_octaves_place(grid, q, rows);
    const uint64_t exponent = cor_inline_bits(q) & UINT64_C(0x7ff0000000000000);
    place.s = place.t += rest * cor_inline_from_bits((UINT64_C(2046) << 52) - exponent);
    return place;
}

double cor_disk_load(double compression, double nu, enum cor_disk_datum datum)
{
    if (isgreater(compression, 0)) {
        const struct cor_inline_pair log = cor_disk_compression_depth(compression, nu, datum);
        if (has_row(log.hi))
            return cor_inline_row_product(
                place_of(log.hi, log.lo, COR_INLINE_OCTAVES(COR_ROWS_DISK_LOAD_FACTOR), cor_rows_disk_load_factor),
                compression);
    }
    return cor_disk_load_by_pairs(compression, nu, datum);
}

double cor_disk_contact_time(double speed, double nu, enum cor_disk_datum datum)
{
    if (isgreater(speed, 0)) {
        const struct cor_inline_pair log = cor_disk_speed_depth(speed, nu, datum);
        if (has_row(2 * log.hi))
            return cor_inline_row_value(place_of(2 * log.hi, 2 * log.lo, COR_INLINE_OCTAVES(COR_ROWS_DISK_CONTACT_TIME),
                                                 cor_rows_disk_contact_time));
    }
    return cor_disk_contact_time_by_quadrature(speed, nu, datum);
}

void cor_disk_load_array(const double *compression, double nu, enum cor_disk_datum datum, double *load, size_t n)
{
    for (size_t i = 0; i < n; i++)
        load[i] = cor_disk_load(compression[i], nu, datum);
}

void cor_disk_contact_time_array(const double *speed, double nu, enum cor_disk_datum datum, double *contact_time,
                                 size_t n)
{
    for (size_t i = 0; i < n; i++)
        contact_time[i] = cor_disk_contact_time(speed[i], nu, datum);
}
