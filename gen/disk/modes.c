/* SPDX-License-Identifier: MIT */
#include "disk/modes.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cor/status.h"
#include "runtime/disk/mode_source.h"
#include "support/console.h"
#include "support/decimal.h"
#include "support/digits.h"
#include "support/local.h"
#include "support/parallel.h"

/* GUARD_BITS: bits that the recurrences, C and S usually lose. A mode that loses more is computed again. */
enum {
    GUARD_BITS = 24,
    NEWTON_MAX = 12,
    NEWTON_FIRST_BITS = 100,
    NEWTON_SLACK = 16,
    WIDENINGS = 3,
    WIDE = 2,
    EXPONENT_MAX = 1000
};

void disk_mode_init(struct disk_mode *mode)
{
    *mode = (struct disk_mode){0};
    FOR_ALL(arb, init, mode->omega, mode->c, mode->s);
}

void disk_mode_clear(struct disk_mode *mode)
{
    FOR_ALL(arb, clear, mode->omega, mode->c, mode->s);
}

void disk_modes_init(struct disk_modes *modes)
{
    *modes = (struct disk_modes){0};
}

void disk_modes_clear(struct disk_modes *modes)
{
    for (slong i = 0; i < modes->count; i++)
        disk_mode_clear(&modes->mode[i]);
    free(modes->mode);
    disk_modes_init(modes);
}

/* ---- one mode, in interval (ball) arithmetic ---- */

/* Applies Newton's method from the middle of w, then proves the result. Returns false if the method does not lead to
 * root (n, l). */
static bool polish_root(arb_t w, const struct disk *wide, slong n, slong l, slong bits)
{
    struct disk disk = *wide;
    LOCAL(arb, step, low, high);
    bool proved = false;

    const slong full = bits + GUARD_BITS;
    slong prec = full < NEWTON_FIRST_BITS ? full : NEWTON_FIRST_BITS;
    disk.prec = prec;
    for (int i = 0; i < NEWTON_MAX; i++) {
        mag_zero(arb_radref(w));
        if (!disk_newton(step, &disk, n, w))
            break;
        arb_submul(w, w, step, prec);
        mag_zero(arb_radref(w));
        const bool exact = arf_cmpabs_2exp_si(arb_midref(step), -full) < 0;
        const slong gained = exact ? full : -arf_abs_bound_lt_2exp_si(arb_midref(step));
        if (gained < NEWTON_SLACK || !arb_is_positive(w))
            break;
        if (prec == full && 2 * gained >= full + NEWTON_SLACK) {
            /* the error of w is about the radius of `step`; the bracket extends at least four radii to either side */
            slong narrow =
                (slong)fmin((double)(bits + GUARD_BITS / 2 - 2), -2 - mag_get_d_log2_approx(arb_radref(step)));
            for (int wider = 0; wider < WIDENINGS && !proved; wider++, narrow -= GUARD_BITS / 4) {
                arb_mul_2exp_si(step, w, -narrow);
                arb_sub(low, w, step, full);
                arb_add(high, w, step, full);
                proved = arb_is_positive(low) && disk_count(&disk, n, low) == l && disk_count(&disk, n, high) == l + 1;
            }
            if (proved)
                arb_union(w, low, high, 2 * full);
            break;
        }
        if (prec < full) {
            const slong reached = 4 * gained + 2 * NEWTON_SLACK;
            disk.prec = prec = reached < full && reached > prec ? reached : full;
        }
    }
    return proved;
}

/* Bisects by the count of roots until Newton's method converges. Bisection itself always converges. An undecided count
 * raises the number of bits. Returns false if `limit` bits do not separate root (n, l) from its neighbour. */
static bool bisect_by_count(arb_t w, const struct disk *wide, slong n, slong l, slong bits, slong limit)
{
    struct disk disk = *wide;
    LOCAL(arf, low, high, middle);
    LOCAL(arb, x);
    struct precision p = precision_doubling(bits < limit / 4 ? 64 : bits, limit);
    disk.prec = p.bits;
    bool found = false, enclosed = false, enough = p.bits <= limit;

    /* every root has w >= n (n - 1)/10, which is above `low`; `high` grows by factors of four */
    arf_set_si(low, n * (n - 1));
    arf_div_ui(low, low, 11, 30, ARF_RND_DOWN);
    arf_set_si(high, n * (n - 1) + 1);
    slong steps = 0;
    while (!found && enough && arf_cmpabs_2exp_si(high, EXPONENT_MAX) < 0) {
        if (enclosed) {
            arf_add(middle, low, high, ARF_PREC_EXACT, ARF_RND_DOWN);
            arf_mul_2exp_si(middle, middle, -1);
            arf_set_round(middle, middle, p.bits, ARF_RND_DOWN);
        } else {
            arf_set(middle, high);
        }
        arb_set_arf(x, middle);
        slong count = arf_cmp(middle, low) > 0 ? disk_count(&disk, n, x) : DISK_UNDECIDED;
        if (count == DISK_UNDECIDED) {
            enough = precision_raise(&p);
            disk.prec = p.bits;
        } else if (count <= l) {
            arf_set(low, middle);
            if (!enclosed)
                arf_mul_2exp_si(high, high, 2);
        } else {
            arf_set(high, middle);
            enclosed = true;
        }
        /* A failed attempt of Newton's method is expensive, so attempts are rare. */
        if (enclosed && ++steps % 8 == 0) {
            arb_set_interval_arf(w, low, high, p.bits);
            found = polish_root(w, wide, n, l, bits);
        }
    }
    return found;
}

/* Encloses the mode from an approximation to its omega, which is ignored if it is not positive. */
static bool enclose_mode(struct disk_mode *mode, const struct disk *wide, const arb_t omega, slong bits, slong limit)
{
    LOCAL(arb, w);
    bool done = false;
    if (arb_is_positive(omega)) {
        arb_mul(w, omega, omega, bits + GUARD_BITS);
        done = polish_root(w, wide, mode->n, mode->l, bits);
    }
    done = done || bisect_by_count(w, wide, mode->n, mode->l, bits, limit);
    if (done) {
        struct disk disk = *wide;
        disk.prec = bits + GUARD_BITS;
        arb_sqrt(mode->omega, w, disk.prec);
        done = disk_amplitudes(mode->c, mode->s, &disk, mode->n, w);
    }
    return done;
}

int disk_mode_solve(struct disk_mode *mode, const fmpq_t nu, slong n, slong l, double omega, slong bits)
{
    mode->n = n;
    mode->l = l;
    LOCAL(arb, start);
    arb_set_d(start, omega);
    LOCAL_INIT(disk, wide, (&wide, nu, WIDE * (4 * bits + 1024)));
    const bool done = enclose_mode(mode, &wide, start, bits, 4 * bits + 1024);
    return done ? STATUS_OK
                : fail("cannot separate the mode n = %ld, l = %ld from its neighbour with %ld bits", (long)n, (long)l,
                       (long)(4 * bits + 1024));
}

/* ---- all modes ---- */

struct work {
    const struct disk *disk; /* 1 + nu and 1 - nu with more bits than any step needs */
    slong digits;
    struct disk_mode *mode;
    slong *which; /* the modes to compute */
    struct precision precision;
    atomic_bool failed;
    slong *below;
    const arb_struct *w;
};

/* Finds candidates for the lowest modes in doubles: the first `count`, the next one, and all modes that doubles do not
 * separate from it. If doubles cannot compute them, *found is 0, and disk_modes_solve fails. */
static struct cor_disk_mode *find_candidates(slong *found, const struct disk *disk, slong count)
{
    const struct cor_mode_material material = {disk->e_double, disk->s_double};
    struct cor_disk_mode *list;
    size_t all;
    if (cor_mode_find(&material, cor_mode_set(cor_widest_set()), cor_mode_upper_end(&material, (size_t)count), &list,
                      &all) != COR_OK)
        all = 0;
    for (*found = count + 1 < (slong)all ? count + 1 : (slong)all; *found < (slong)all; ++*found) {
        if (list[*found].omega > list[count].omega * (1 + 1e-9))
            break;
    }
    return list;
}

/* ---- the proved modes in interval (ball) arithmetic ---- */

static bool number_is_decided(const arb_t x, slong digits)
{
    double rounded;
    if (!digits_to_double(&rounded, x))
        return false;
    char *text = digits_of_ball(x, digits);
    free(text);
    return text != NULL;
}

static void enclose_one(void *pointer, slong i)
{
    struct work *const work = pointer;
    struct disk_mode *const mode = &work->mode[work->which[i]];
    struct precision p = work->precision;
    LOCAL(arb, start);
    arb_set(start, mode->omega);
    bool decided = false;
    do {
        decided = enclose_mode(mode, work->disk, start, p.bits, p.limit) &&
                  number_is_decided(mode->omega, work->digits) && number_is_decided(mode->c, work->digits) &&
                  number_is_decided(mode->s, work->digits);
    } while (!decided && precision_raise(&p));
    if (!decided && !atomic_exchange(&work->failed, true)) {
        char what[96];
        snprintf(what, sizeof what, "mode n = %ld, l = %ld", (long)mode->n, (long)mode->l);
        precision_spent(&p, what, work->digits);
    }
}

static int by_omega(const void *a, const void *b)
{
    const struct disk_mode *x = a, *y = b;
    return arf_cmp(arb_midref(x->omega), arb_midref(y->omega));
}

static void count_order(void *pointer, slong i)
{
    const struct work *work = pointer;
    const slong n = i;
    struct precision p = precision_doubling(64, 2 * precision_start(work->digits).limit);
    do {
        struct disk disk = *work->disk;
        disk.prec = p.bits;
        work->below[n] = disk_count(&disk, n, work->w);
    } while (work->below[n] == DISK_UNDECIDED && precision_raise(&p));
}

/* Returns the number of modes, of any n, below the midpoint between the omegas of mode[count - 1] and mode[count].
 * Returns DISK_UNDECIDED if a count is undecided. */
static slong count_all(const struct disk_modes *modes, slong count, const struct disk *wide, slong digits)
{
    LOCAL(arf, low, high);
    LOCAL(arb, w);
    const slong prec = 2 * arb_bits(modes->mode[count].omega) + 64;
    arb_get_ubound_arf(low, modes->mode[count - 1].omega, prec);
    arb_get_lbound_arf(high, modes->mode[count].omega, prec);
    arf_add(low, low, high, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_mul_2exp_si(low, low, -1);
    arb_set_arf(w, low);
    const slong orders = cor_mode_orders(arf_get_d(high, ARF_RND_UP));
    arb_mul(w, w, w, ARF_PREC_EXACT);

    struct work work = {.disk = wide, .w = w, .digits = digits, .below = xmalloc((size_t)orders * sizeof *work.below)};
    parallel_for(count_order, &work, orders, "counting modes, n");
    slong total = 0;
    for (slong n = 0; n < orders && total >= 0; n++)
        total = work.below[n] == DISK_UNDECIDED ? DISK_UNDECIDED : total + work.below[n];
    free(work.below);
    return total;
}

/* Encloses every mode. Modes that overlap are enclosed again with more bits, until omega increases from each mode to
 * the next. */
static int enclose_all(struct disk_modes *modes, const struct disk *wide, slong digits)
{
    const size_t count = (size_t)modes->count;
    struct disk_mode *const mode = modes->mode;
    struct work work = {.disk = wide,
                        .digits = digits,
                        .mode = mode,
                        .which = xmalloc(count * sizeof *work.which),
                        .precision = precision_start(digits)};
    slong todo = modes->count;
    for (slong i = 0; i < todo; i++)
        work.which[i] = i;
    while (todo > 0 && !work.failed) {
        parallel_for(enclose_one, &work, todo, "enclosing modes");
        qsort(mode, count, sizeof *mode, by_omega);
        todo = 0;
        for (slong i = 1; i < modes->count; i++) {
            if (arb_lt(mode[i - 1].omega, mode[i].omega))
                continue;
            if (todo == 0 || work.which[todo - 1] != i - 1)
                work.which[todo++] = i - 1;
            work.which[todo++] = i;
        }
        if (todo > 0 && !work.failed && !precision_raise(&work.precision)) {
            fail("cannot order the modes n = %ld and n = %ld near omega = %.17g with %ld bits",
                 (long)mode[work.which[0]].n, (long)mode[work.which[1]].n, ball_middle(mode[work.which[0]].omega),
                 (long)work.precision.bits);
            work.failed = true;
        }
    }
    free(work.which);
    return work.failed ? STATUS_FAILED : STATUS_OK;
}

int disk_modes_solve(struct disk_modes *modes, const fmpq_t nu, slong count, slong digits)
{
    disk_modes_clear(modes);
    LOCAL_INIT(disk, wide, (&wide, nu, WIDE * precision_start(digits).limit));
    profile_step("finding modes");
    slong found;
    struct cor_disk_mode *list = find_candidates(&found, &wide, count);

    modes->mode = xmalloc((size_t)found * sizeof *modes->mode);
    modes->count = found;
    for (slong i = 0; i < found; i++) {
        disk_mode_init(&modes->mode[i]);
        modes->mode[i].n = list[i].n;
        modes->mode[i].l = list[i].l;
        arb_set_d(modes->mode[i].omega, list[i].omega);
    }
    free(list);

    profile_step("enclosing modes");
    int status = enclose_all(modes, &wide, digits);
    if (status == STATUS_OK) {
        profile_step("counting modes");
        const slong total = found > count ? count_all(modes, count, &wide, digits) : DISK_UNDECIDED;
        if (total != count)
            status = fail("the %ld lowest modes are incomplete: there are %ld modes in their range", (long)count,
                          (long)total);
    }
    progress_end();
    profile_step(NULL);
    while (status == STATUS_OK && modes->count > count)
        disk_mode_clear(&modes->mode[--modes->count]);
    if (status != STATUS_OK)
        disk_modes_clear(modes);
    return status;
}

/* ---- doubles ---- */

enum { MODE_DIGITS = 17 /* digits_to_double needs no more digits */ };

int disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count)
{
    LOCAL_INIT(disk_modes, exact, (&exact));
    if (disk_modes_solve(&exact, nu, count, MODE_DIGITS) != STATUS_OK)
        return STATUS_FAILED;
    struct cor_disk_mode *const mode = xmalloc((size_t)count * sizeof *mode);
    *modes = (struct cor_disk_modes){decimal_nearest(nu), (size_t)count, mode};
    for (slong i = 0; i < count; i++) {
        const struct disk_mode *const m = &exact.mode[i];
        mode[i] = (struct cor_disk_mode){(int)m->n, (int)m->l, 0, 0, 0};
        digits_to_double(&mode[i].omega, m->omega); /* cannot fail: number_is_decided has tested it */
        digits_to_double(&mode[i].c, m->c);
        digits_to_double(&mode[i].s, m->s);
    }
    return STATUS_OK;
}
