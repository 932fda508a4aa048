/* SPDX-License-Identifier: MIT */
#include "series/row_sums.h"

#include "support/console.h"
#include "support/local.h"
#include "support/parallel.h"

#include <float.h>
#include <math.h>

enum {
    /* Row k of the trajectory is about 2^(-ROW_BITS k). Divided by this factor, rows have similar size. */
    ROW_BITS = 2,
    /* The radii of a row grow about as 2^(COLUMN_BITS j) and are stored without it, so that doubles do not
     * underflow. */
    COLUMN_BITS = 1,
    /* Number of outputs per task of the error bound. The partition does not depend on the number of threads. */
    ERROR_BLOCK = 64,
    WORD_BITS = 62,
    /* exponent of a row that is zero, far below every other exponent */
    ZERO_EXPONENT = -100000000
};

/* The transforms of the rows modulo one prime p = 1 mod 2^depth */
struct row_prime {
    ulong p;
    ulong *root, *shoup; /* powers of a root of unity of order 2^depth, and their precomputed quotients */
    ulong *factor[2];    /* the transforms of X_i and P_i, 2^depth numbers for each row */
    slong known;
    ulong *sum; /* sum for the current row, `length` numbers */
};

/* Upper bounds of one row: size[j] 2^(size_exponent + COLUMN_BITS j) >= |f_j|; `radius` likewise bounds its error. */
struct row_bound {
    double *size, *radius;
    slong size_exponent, radius_exponent;
};

static ulong power_mod(ulong x, ulong e, ulong p)
{
    return n_powmod2_ui_preinv(x, e, p, n_preinvert_limb(p));
}

/* Returns an element of order 2^depth, a power of a quadratic non-residue. */
static ulong root_of_unity(ulong p, int depth)
{
    ulong g = 2;
    while (power_mod(g, (p - 1) / 2, p) != p - 1)
        g++;
    return power_mod(g, (p - 1) >> depth, p);
}

static ulong *words_new(slong count)
{
    return flint_calloc((size_t)count, sizeof(ulong));
}

static void row_prime_init(struct row_prime *m, ulong p, const struct row_sums *s)
{
    const slong half = WORD(1) << (s->depth - 1);
    const ulong root = root_of_unity(p, s->depth);
    *m = (struct row_prime){.p = p, .known = 1, .root = words_new(half), .shoup = words_new(half)};
    ulong x = 1;
    for (slong j = 0; j < half; j++) {
        m->root[j] = x;
        m->shoup[j] = n_mulmod_precomp_shoup(x, p);
        x = n_mulmod2(x, root, p);
    }
    for (int f = 0; f < 2; f++)
        m->factor[f] = words_new(s->rows << s->depth);
    m->sum = words_new(WORD(1) << s->depth);
}

static void row_prime_clear(const struct row_prime *m)
{
    ulong *const words[] = {m->root, m->shoup, m->factor[0], m->factor[1], m->sum};
    for (int i = 0; i < 5; i++)
        flint_free(words[i]);
}

/* Computes the discrete Fourier transform modulo p. The results are in bit-reversed order. */
static void transform_row(ulong *f, const struct row_prime *m, int depth)
{
    const slong n = WORD(1) << depth;
    for (slong half = n / 2, step = 1; half > 0; half /= 2, step *= 2)
        for (slong start = 0; start < n; start += 2 * half)
            for (slong j = 0; j < half; j++) {
                ulong *x = f + start + j, *y = x + half;
                const ulong sum = n_addmod(*x, *y, m->p), difference = n_submod(*x, *y, m->p);
                *x = sum;
                *y = n_mulmod_shoup(m->root[j * step], difference, m->shoup[j * step], m->p);
            }
}

/* Computes 2^depth times the inverse of transform_row(). The inverse of root k > 0 is minus root n/2 - k. */
static void transform_back(ulong *f, const struct row_prime *m, int depth)
{
    const slong n = WORD(1) << depth;
    for (slong half = 1, step = n / 2; half < n; half *= 2, step /= 2)
        for (slong start = 0; start < n; start += 2 * half)
            for (slong j = 0; j < half; j++) {
                ulong *x = f + start + j, *y = x + half;
                const slong k = j > 0 ? n / 2 - j * step : 0;
                const ulong product = n_mulmod_shoup(m->root[k], *y, m->shoup[k], m->p);
                const ulong sum = n_addmod(*x, product, m->p), difference = n_submod(*x, product, m->p);
                *x = j > 0 ? difference : sum;
                *y = j > 0 ? sum : difference;
            }
}

slong row_sums_weight(struct ratio p, slong i, slong k)
{
    return (p.num + p.den) * i - p.den * k;
}

/* Transforms the stored rows that are not yet transformed modulo this prime. */
static void row_prime_catch_up(struct row_prime *m, const struct row_sums *s)
{
    for (; m->known < s->known; m->known++)
        for (int f = 0; f < 2; f++) {
            ulong *row = m->factor[f] + (m->known << s->depth);
            for (slong j = 0; j < s->length; j++)
                row[j] = fmpz_fdiv_ui(s->integer[f] + m->known * s->length + j, m->p);
            transform_row(row, m, s->depth);
        }
}

/* Computes the sum for row k modulo the prime. A block of points stays in the cache while i runs over the rows. The
 * weighted factor has at most WORD_BITS bits, and the sum of the products of all rows fits in two words. */
static void row_prime_sum(struct row_prime *m, const struct row_sums *s, slong k)
{
    enum { POINTS = 256 };
    const slong n = WORD(1) << s->depth;
    const ulong inverse = n_preinvert_limb(m->p);
    for (slong start = 0; start < n; start += POINTS) {
        const slong count = FLINT_MIN(POINTS, n - start);
        ulong high[POINTS] = {0}, low[POINTS] = {0};
        for (slong i = 1; i < k; i++) {
            const slong weight = row_sums_weight(s->p, i, k);
            const ulong *x = m->factor[0] + (i << s->depth) + start;
            const ulong *y = m->factor[1] + ((k - i) << s->depth) + start;
            for (slong j = 0; j < count; j++) {
                const ulong weighted = weight >= 0 ? (ulong)weight * x[j] : (ulong)-weight * (m->p - x[j]);
                ulong product_high, product_low;
                umul_ppmm(product_high, product_low, weighted, y[j]);
                add_ssaaaa(high[j], low[j], high[j], low[j], product_high, product_low);
            }
        }
        for (slong j = 0; j < count; j++)
            m->sum[start + j] = n_ll_mod_preinv(high[j], low[j], m->p, inverse);
    }
    transform_back(m->sum, m, s->depth);
    const ulong scale = n_invmod((ulong)n, m->p), scale_shoup = n_mulmod_precomp_shoup(scale, m->p);
    for (slong j = 0; j < s->length; j++)
        m->sum[j] = n_mulmod_shoup(scale, m->sum[j], scale_shoup, m->p);
}

void row_sums_init(struct row_sums *s, struct ratio p, slong rows, slong length, slong prec)
{
    *s = (struct row_sums){.p = p, .rows = rows, .length = length, .prec = prec, .known = 1};
    s->depth = FLINT_MAX(1, (int)FLINT_CLOG2((ulong)(2 * length - 1)));
    s->weight_bits = (int)FLINT_BIT_COUNT((ulong)((p.num + 2 * p.den) * rows));
    for (int f = 0; f < 2; f++) {
        s->integer[f] = _fmpz_vec_init(rows * length);
        s->bound[f] = flint_calloc((size_t)rows, sizeof *s->bound[f]);
    }
    s->error = flint_calloc((size_t)length, sizeof(double));
}

void row_sums_clear(struct row_sums *s)
{
    for (slong i = 0; i < s->primes; i++)
        row_prime_clear(s->mod + i);
    flint_free(s->mod);
    for (int f = 0; f < 2; f++) {
        _fmpz_vec_clear(s->integer[f], s->rows * s->length);
        for (slong i = 1; i < s->known; i++) {
            flint_free(s->bound[f][i].size);
            flint_free(s->bound[f][i].radius);
        }
        flint_free(s->bound[f]);
    }
    flint_free(s->error);
}

/* Returns new y with y[j] 2^(exponent + COLUMN_BITS j) >= m[j]. The largest is near 1, each is 0 or >= DBL_MIN. */
static double *bounds_of(slong *exponent, mag_ptr m, slong length)
{
    double *const y = flint_calloc((size_t)length, sizeof *y);
    *exponent = ZERO_EXPONENT;
    for (slong j = 0; j < length; j++) {
        mag_mul_2exp_si(m + j, m + j, -COLUMN_BITS * j);
        if (!mag_is_zero(m + j))
            *exponent = FLINT_MAX(*exponent, fmpz_get_si(MAG_EXPREF(m + j)));
    }
    for (slong j = 0; j < length; j++) {
        mag_mul_2exp_si(m + j, m + j, -*exponent);
        y[j] = mag_is_zero(m + j) ? 0 : fmax(mag_get_d(m + j), DBL_MIN);
    }
    return y;
}

/* Cuts the midpoints of row k to integers. Bounds the row, and the sum of its radii and the cut digits. */
static void row_store(struct row_sums *s, int f, const arb_poly_struct *row, slong k)
{
    fmpz *integer = s->integer[f] + k * s->length;
    mag_ptr size = _mag_vec_init(s->length), radius = _mag_vec_init(s->length);
    LOCAL(arf, scaled);
    for (slong j = 0; j < FLINT_MIN(s->length, row->length); j++) {
        arf_mul_2exp_si(scaled, arb_midref(row->coeffs + j), s->prec + ROW_BITS * k);
        arf_get_fmpz(integer + j, scaled, ARF_RND_DOWN);
        arb_get_mag(size + j, row->coeffs + j);
        mag_set_ui_2exp_si(radius + j, 1, -s->prec - ROW_BITS * k);
        mag_add(radius + j, radius + j, arb_radref(row->coeffs + j));
    }
    struct row_bound *const b = s->bound[f] + k;
    b->size = bounds_of(&b->size_exponent, size, s->length);
    b->radius = bounds_of(&b->radius_exponent, radius, s->length);
    _mag_vec_clear(size, s->length);
    _mag_vec_clear(radius, s->length);
}

/* Adds primes until their product is larger than twice the absolute value of the sum for row k. */
static void primes_grow(struct row_sums *s, slong k)
{
    slong bits = 0;
    for (slong i = 1; i < k; i++)
        bits = FLINT_MAX(bits, FLINT_ABS(_fmpz_vec_max_bits(s->integer[0] + i * s->length, s->length)) +
                                   FLINT_ABS(_fmpz_vec_max_bits(s->integer[1] + (k - i) * s->length, s->length)));
    bits += 2 + s->weight_bits + (slong)FLINT_BIT_COUNT((ulong)k) + (slong)FLINT_BIT_COUNT((ulong)s->length);
    /* p < 2^prime_bits: a weight times a residue fits in WORD_BITS bits, and k of their products fit in 128. */
    const int prime_bits = WORD_BITS - s->weight_bits;
    while (s->primes * (prime_bits - 1) < bits) {
        s->mod = flint_realloc(s->mod, (size_t)(s->primes + 1) * sizeof *s->mod);
        ulong p = s->primes > 0 ? s->mod[s->primes - 1].p : (UWORD(1) << prime_bits) + 1;
        do
            p -= UWORD(1) << s->depth;
        while (!n_is_prime(p));
        row_prime_init(s->mod + s->primes++, p, s);
    }
}

/* Bounds the error of outputs start..end-1 of the sum in units of 2^(s->exponent + COLUMN_BITS j). With the integers
 * x~, p~: |x p - x~ p~| <= |x - x~| |p| + |x~| |p - p~|, and |x~| is at most the bound of |x|. */
static void error_block(struct row_sums *s, slong start, slong end)
{
    for (slong n = start; n < end; n++)
        s->error[n] = 0;
    for (slong i = 1; i < s->row; i++) {
        const struct row_bound *x = s->bound[0] + i, *y = s->bound[1] + s->row - i;
        const double weight = (double)FLINT_ABS(row_sums_weight(s->p, i, s->row));
        const double x_scale = ldexp(weight, (int)(x->radius_exponent + y->size_exponent - s->exponent));
        const double y_scale = ldexp(weight, (int)(x->size_exponent + y->radius_exponent - s->exponent));
        for (slong j = 0; j < end; j++) {
            const double x_radius = x_scale * x->radius[j], x_size = y_scale * x->size[j];
            for (slong n = FLINT_MAX(start, j); n < end; n++)
                s->error[n] += x_radius * y->size[n - j] + x_size * y->radius[n - j];
        }
    }
    /* the factor exceeds the rounding errors of this sum, and 2^-900 exceeds its underflows */
    for (slong n = start; n < end; n++)
        s->error[n] = s->error[n] * (1 + 1e-6) + 0x1p-900;
}

static void sum_part(void *context, slong task)
{
    struct row_sums *const s = context;
    if (task < s->primes) {
        row_prime_catch_up(s->mod + task, s);
        row_prime_sum(s->mod + task, s, s->row);
    } else {
        const slong start = (task - s->primes) * ERROR_BLOCK;
        error_block(s, start, FLINT_MIN(start + ERROR_BLOCK, s->length));
    }
}

/* Builds the balls of the sum from its residues and its error bound. */
static void sum_collect(arb_poly_struct *sum, const struct row_sums *s)
{
    ulong *residue = words_new(2 * s->primes), *prime = residue + s->primes;
    fmpz_comb_t comb;
    fmpz_comb_temp_t temp;
    LOCAL(fmpz, value);
    LOCAL(mag, error);
    for (slong i = 0; i < s->primes; i++)
        prime[i] = s->mod[i].p;
    fmpz_comb_init(comb, prime, s->primes);
    fmpz_comb_temp_init(temp, comb);
    arb_poly_fit_length(sum, s->length);
    for (slong j = 0; j < s->length; j++) {
        for (slong i = 0; i < s->primes; i++)
            residue[i] = s->mod[i].sum[j];
        fmpz_multi_CRT_ui(value, residue, comb, temp, 1);
        arb_set_round_fmpz(sum->coeffs + j, value, s->prec);
        arb_mul_2exp_si(sum->coeffs + j, sum->coeffs + j, -2 * s->prec - ROW_BITS * s->row);
        mag_set_d(error, s->error[j]);
        mag_mul_2exp_si(error, error, s->exponent + COLUMN_BITS * j);
        arb_add_error_mag(sum->coeffs + j, error);
    }
    _arb_poly_set_length(sum, s->length);
    _arb_poly_normalise(sum);
    fmpz_comb_temp_clear(temp);
    fmpz_comb_clear(comb);
    flint_free(residue);
}

void row_sums_next(arb_poly_struct *sum, struct row_sums *s, const arb_poly_struct *x, const arb_poly_struct *power,
                   slong k)
{
    for (; s->known < k; s->known++) {
        row_store(s, 0, x + s->known, s->known);
        row_store(s, 1, power + s->known, s->known);
    }
    arb_poly_zero(sum);
    if (k < 2)
        return;
    primes_grow(s, k);
    s->row = k;
    s->exponent = WORD_MIN; /* the largest exponent of the products; it prevents overflow of their sum */
    for (slong i = 1; i < k; i++) {
        const struct row_bound *x = s->bound[0] + i, *y = s->bound[1] + k - i;
        s->exponent = FLINT_MAX(s->exponent, x->radius_exponent + y->size_exponent);
        s->exponent = FLINT_MAX(s->exponent, x->size_exponent + y->radius_exponent);
    }
    const slong blocks = (s->length + ERROR_BLOCK - 1) / ERROR_BLOCK;
    progress_enter("trajectory rows", s->rows);
    progress_at(k);
    parallel_for(sum_part, s, s->primes + blocks, "trajectory rows");
    progress_leave();
    sum_collect(sum, s);
}
