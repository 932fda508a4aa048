/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* mkstemp, P_tmpdir */
#include "public_calls.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "runtime/disk/mode_file.h"

/* ---- arguments ---- */

uint64_t random_bits_next(struct bit_source *source)
{
    return random_bits(&((struct random_bits *)source)->random);
}

static uint64_t bits(struct bit_source *source)
{
    return source->next(source);
}

size_t draw_below(struct bit_source *source, size_t n)
{
    return (size_t)(bits(source) % n);
}

static double uniform(struct bit_source *source, double low, double high)
{
    return low + (high - low) * ((double)(bits(source) >> 11) * 0x1p-53);
}

/* Draws without exp and log, so that the bits do not depend on the C library. */
double draw_size(struct bit_source *source, double low, double high)
{
    int first, last;
    frexp(low, &first);
    frexp(high, &last);
    const int exponent = first + (int)draw_below(source, (size_t)(last - first) + 1);
    return fmin(fmax(ldexp(uniform(source, 0.5, 1), exponent), low), high);
}

/* Returns the double with these bits. Replaces any NaN by a quiet one, because a signalling NaN raises FE_INVALID. */
static double of_bits(uint64_t x)
{
    double value;
    memcpy(&value, &x, sizeof value);
    return isnan(value) ? (double)NAN : value;
}

static double special(struct bit_source *source)
{
    NUMBERS(values, 0, -0.0, 1, -1, NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, DBL_MIN, -DBL_MIN, 0x1p-1074,
            -0x1p-1074, 0x1.fffffffffffffp-1, 0x1.0000000000001p+0, 0.5, 1.5, 2, 7, 8, 16, 100, FLT_MAX, FLT_MIN,
            0x1p-149, 2e-309, 1e-310, 1e-300, 1e300, 1e154, 1e155, 1e15, 1e40, 0x1p-60, 0.39, 0.67, 1.3, 2.157, 3, 10.9,
            11, COR_HERTZ_DASHPOT_BETA_C);
    return values[draw_below(source, sizeof values / sizeof *values)];
}

static double any_number(struct bit_source *source)
{
    double x;
    switch (draw_below(source, 20)) {
    case 0:
    case 1:
        return special(source);
    case 2: /* subnormal */
        return of_bits(bits(source) >> (12 + draw_below(source, 52)));
    case 3:
        return of_bits(bits(source));
    case 4:
        return of_bits(bits(source) & UINT64_C(0x7fffffffffffffff));
    case 5:
        return uniform(source, -1, 0);
    case 6: /* numbers up to 1, most of them just below 1 */
        x = uniform(source, 0, 1);
        return 1 - ldexp(x, -(int)draw_below(source, 60));
    case 7:
    case 8:
        return draw_size(source, 1e-30, 1e30);
    case 9:
    case 10:
    case 11:
    case 12:
        return draw_size(source, 1e-4, 100);
    default:
        return uniform(source, 0, 1);
    }
}

static double positive(struct bit_source *source, double low, double high)
{
    switch (draw_below(source, 8)) {
    case 0:
        return any_number(source);
    case 1:
        return of_bits(bits(source) & UINT64_C(0x7fffffffffffffff));
    case 2:
        return draw_size(source, 1e-300, 1e300);
    default:
        return draw_size(source, low, high);
    }
}

static double ratio(struct bit_source *source, double most)
{
    return draw_below(source, 8) == 0 ? any_number(source) : uniform(source, -1, most);
}

static float narrow(double x)
{
    if (isnan(x))
        return NAN;
    if (fabs(x) > (double)FLT_MAX && fabs(x) <= DBL_MAX)
        return x > 0 ? FLT_MAX : -FLT_MAX;
    return (float)x;
}

static struct cor_body body(struct bit_source *source)
{
    struct cor_body drawn;
    drawn.young_modulus_pa = positive(source, 1e6, 1e12);
    drawn.poisson_ratio = ratio(source, 0.5);
    drawn.dissipation_time_s = positive(source, 1e-9, 1e-2);
    drawn.radius_m = positive(source, 1e-6, 1);
    drawn.mass_kg = positive(source, 1e-9, 10);
    if (draw_below(source, 5) == 0)
        drawn.radius_m = drawn.mass_kg = INFINITY;
    return drawn;
}

static int subnormal_number(double x)
{
    return x != 0 && fabs(x) < 2 * DBL_MIN;
}

static void without_subnormal(double *x)
{
    if (subnormal_number(*x))
        *x = 0;
}

/* Replaces subnormal numbers in a struct of doubles. */
static void without_subnormals(void *numbers, size_t size)
{
    double x;
    for (unsigned char *at = numbers; at < (unsigned char *)numbers + size; at += sizeof x) {
        memcpy(&x, at, sizeof x);
        without_subnormal(&x);
        memcpy(at, &x, sizeof x);
    }
}

/* Returns a contact as the init functions set it. by_hand: any numbers that are not subnormal */
static struct cor_sphere_contact contact(struct bit_source *source, int by_hand)
{
    struct cor_sphere_contact drawn;
    /* one draw per statement, because compilers choose the order within a statement */
    struct cor_body ordinary[2] = {{0}}, wild[2];
    for (int i = 0; i < 2; i++) {
        ordinary[i].young_modulus_pa = draw_size(source, 1e6, 1e12);
        ordinary[i].poisson_ratio = uniform(source, -0.9, 0.5);
        ordinary[i].dissipation_time_s = i == 0 ? draw_size(source, 1e-9, 1e-2) : 0;
        ordinary[i].radius_m = i == 0 ? draw_size(source, 1e-6, 1) : INFINITY;
        ordinary[i].mass_kg = i == 0 ? draw_size(source, 1e-9, 10) : INFINITY;
        wild[i] = body(source);
    }
    const size_t way = draw_below(source, 4);
    if (by_hand && way == 0) {
        drawn.effective_mass_kg = any_number(source);
        drawn.effective_radius_m = any_number(source);
        drawn.elastic_constant_n_m15 = any_number(source);
        drawn.dissipation_time_s = any_number(source);
        /* the lower half of such a number may be subnormal */
        drawn.beta_per_root = draw_below(source, 4) ? draw_size(source, 1e-307, 1e-303) : any_number(source);
        drawn.scale = any_number(source);
        drawn.beta5_per_speed = any_number(source);
        without_subnormals(&drawn, sizeof drawn);
    } else if (way == 1) {
        cor_sphere_contact_init_g_star(&drawn, any_number(source));
    } else {
        cor_sphere_contact_init(&drawn, way == 2 ? &wild[0] : &ordinary[0], way == 2 ? &wild[1] : &ordinary[1]);
    }
    return drawn;
}

static double within(struct bit_source *source, double drawn, double limit)
{
    return limit > 0 && draw_below(source, 3) > 0 ? limit * uniform(source, 0, 1) : drawn;
}

static void disk_draw(struct arguments *a, struct bit_source *source, size_t i)
{
    a->datum[i] = (enum cor_disk_datum)draw_below(source, 3);
    a->nu[i] = ratio(source, 1);
    a->poisson_ratio[i] = ratio(source, 0.5);
    a->speed[i] = within(source, a->speed[i], cor_disk_speed_limit(a->nu[i], a->datum[i]));
    a->load[i] = within(source, a->load[i], cor_disk_load_limit(a->nu[i], a->datum[i]));
    a->energy[i] = within(source, a->energy[i], cor_disk_energy_limit(a->nu[i], a->datum[i]));
    a->compression[i] = within(source, a->compression[i], cor_disk_compression_limit(a->nu[i], a->datum[i]));
    a->modes[i] = draw_below(source, 2) ? cor_disk_modes_nu033 : cor_disk_modes_nu090;
    if (draw_below(source, 4) == 0)
        a->modes[i] = (struct cor_disk_modes){
            a->nu[i], draw_below(source, 2) ? PUBLIC_MODES : 1 + draw_below(source, PUBLIC_MODES), a->harmed};
    a->n_modes[i] = 1 + draw_below(source, 12);
    a->disk_collision_options[i].alpha =
        draw_below(source, 4) ? draw_size(source, 40, draw_below(source, 4) ? 500 : 1e5) : any_number(source);
    a->disk_collision_options[i].tolerance = draw_below(source, 4) ? draw_size(source, 1e-4, 1) : any_number(source);
    a->disk_collision_options[i].phi_points = draw_below(source, 4) ? 0 : 1 + draw_below(source, 50);
    a->disk_collision_options[i].max_steps = 1500;
    a->disk_hard_wall_options[i].tolerance = draw_below(source, 4) ? draw_size(source, 1e-2, 1) : any_number(source);
    a->disk_hard_wall_options[i].max_steps = 100 * draw_below(source, 100); /* 0: the default */
    a->tolerance[i] = draw_below(source, 4) ? draw_size(source, 1e-6, 1) : any_number(source);
}

/* Copies a table of the library and damages the copy: changes numbers of some modes, or copies a mode over another. */
static void harm_modes(struct cor_disk_mode *mode, struct bit_source *source)
{
    memcpy(mode, cor_disk_modes_nu033.mode, PUBLIC_MODES * sizeof *mode);
    for (size_t harms = draw_below(source, 5); harms > 0; harms--) {
        struct cor_disk_mode *const harmed = &mode[draw_below(source, draw_below(source, 2) ? 12 : PUBLIC_MODES)];
        const size_t what = draw_below(source, 6);
        const double number = any_number(source);
        if (what < 2)
            harmed->n = what == 0 ? (int)draw_below(source, 200) : (int)(uint32_t)bits(source);
        else if (what < 5)
            *(what == 2 ? &harmed->omega : what == 3 ? &harmed->c : &harmed->s) = number;
        else
            mode[draw_below(source, PUBLIC_MODES)] = *harmed;
    }
}

void arguments_draw(struct arguments *a, struct bit_source *source, size_t n, int subnormal)
{
    a->n = n;
    harm_modes(a->harmed, source);
    for (size_t i = 0; i < n; i++) {
#define NUMBER(name) a->name[i] = any_number(source);
#include "public_functions.inc"
        a->elastic_exponent[i] =
            draw_below(source, 2) ? 1.5 - 0.5 * (double)draw_below(source, 2) : a->elastic_exponent[i];
        a->contact[i] = contact(source, i > 0); /* array functions use the first contact for all elements */
        a->body_1[i] = body(source);
        a->body_2[i] = body(source);
        a->sphere[i] = body(source);
        a->plate[i].young_modulus_pa = positive(source, 1e6, 1e12);
        a->plate[i].poisson_ratio = ratio(source, 0.5);
        a->plate[i].density_kg_m3 = positive(source, 1, 1e5);
        a->plate[i].thickness_m = positive(source, 1e-5, 1);
        a->half_space[i].young_modulus_pa = positive(source, 1e6, 1e12);
        a->half_space[i].poisson_ratio = ratio(source, 0.5);
        a->half_space[i].density_kg_m3 = positive(source, 1, 1e5);
        a->depth[i] = (int)draw_below(source, 50) - 1;
        a->status[i] = (int)draw_below(source, 60) - 10;
        disk_draw(a, source, i);
#define NUMBER(name) a->name##f[i] = narrow(a->name[i]);
#include "public_functions.inc"
    }
    if (!subnormal)
        arguments_flush(a);
}

void arguments_flush(struct arguments *a)
{
    for (size_t i = 0; i < a->n; i++) {
#define NUMBER(name)                                                                                                   \
    without_subnormal(&a->name[i]);                                                                                    \
    if (a->name##f[i] < 2 * FLT_MIN && a->name##f[i] > -2 * FLT_MIN)                                                   \
        a->name##f[i] = 0;
#include "public_functions.inc"
    }
    /* all fields from contact to half_space are structs of doubles */
    without_subnormals(a->contact, offsetof(struct arguments, modes) - offsetof(struct arguments, contact));
}

/* ---- results ---- */

void results_put(struct results *r, double value)
{
    if (r->count == r->capacity) {
        r->capacity = 2 * r->capacity + 64;
        r->value = realloc(r->value, r->capacity * sizeof *r->value);
        if (r->value == NULL)
            abort();
    }
    r->value[r->count++] = value;
}

void results_clear(struct results *r)
{
    free(r->value);
    r->value = NULL;
    r->count = r->capacity = 0;
}

/* Appends the first n numbers of a struct that begins with doubles. */
static void put_numbers(struct results *r, const void *numbers, size_t n)
{
    double x;
    for (size_t i = 0; i < n; i++) {
        memcpy(&x, (const char *)numbers + i * sizeof x, sizeof x);
        results_put(r, x);
    }
}

int public_is_part(const struct public_function *function, size_t j, size_t n)
{
    const char *const name = function->name;
    if (strncmp(name, "cor_law_", strlen("cor_law_")) == 0)
        return n > 0 && j / n % (COR_QUANTITIES + 1) <= COR_LOSS;
    return strstr(name, "_eps") != NULL || (strstr(name, "_loss") != NULL && strstr(name, "_of_loss") == NULL);
}

/* ---- the calls of one kind ---- */

#define SCALAR(function, type, given)                                                                                  \
    static void call_##function(const struct arguments *a, struct results *r)                                          \
    {                                                                                                                  \
        for (size_t i = 0; i < a->n; i++)                                                                              \
            results_put(r, (double)function given);                                                                    \
    }
#define FLOATS(function, given) CALL_OF_ARRAY(function, float, given)
#define ARRAY(function, given, element)                                                                                \
    CALL_OF_ARRAY(function, double, given)                                                                             \
    static void elements_##function(const struct arguments *a, struct results *r)                                      \
    {                                                                                                                  \
        for (size_t i = 0; i < a->n; i++)                                                                              \
            results_put(r, element);                                                                                   \
    }
#define CALL_OF_ARRAY(function, type, given)                                                                           \
    static void call_##function(const struct arguments *a, struct results *r)                                          \
    {                                                                                                                  \
        type y[PUBLIC_COUNT + 1];                                                                                      \
        const size_t n = a->n;                                                                                         \
        y[n] = 7;                                                                                                      \
        function given;                                                                                                \
        if (!(y[n] > 6 && y[n] < 8)) /* the function wrote too far */                                                  \
            abort();                                                                                                   \
        for (size_t i = 0; i < n; i++)                                                                                 \
            results_put(r, (double)y[i]);                                                                              \
    }
#define INIT(function, type, given)                                                                                    \
    static void call_##function(const struct arguments *a, struct results *r)                                          \
    {                                                                                                                  \
        for (size_t i = 0; i < a->n; i++) {                                                                            \
            struct type out;                                                                                           \
            results_put(r, function given);                                                                            \
            put_numbers(r, &out, sizeof out / sizeof(double));                                                         \
        }                                                                                                              \
    }
#include "public_functions.inc"

/* ---- functions of other kinds ---- */

/* Appends the values (kind 0), the arrays (1) or the floats (2) for a->n numbers. Covers every combination of law, end
 * and quantity, and some that do not exist. */
static void put_laws(const struct arguments *a, struct results *r, int kind)
{
    double y[PUBLIC_COUNT] = {0};
    float yf[PUBLIC_COUNT] = {0};
    for (int c = 0; c < 7 * (COR_END_APPROACH_ONLY + 2) * (COR_QUANTITIES + 1); c++) {
        const enum cor_law law = (enum cor_law)(c / (COR_QUANTITIES + 1) / (COR_END_APPROACH_ONLY + 2) - 1);
        const enum cor_end end = (enum cor_end)(c / (COR_QUANTITIES + 1) % (COR_END_APPROACH_ONLY + 2));
        const enum cor_quantity quantity = (enum cor_quantity)(c % (COR_QUANTITIES + 1));
        const int is_inverse = quantity == COR_DAMPING_OF_EPS || quantity == COR_DAMPING_OF_LOSS;
        const double *const in = is_inverse ? a->eps : a->beta;
        if (kind == 1)
            cor_law_array(law, end, quantity, in, y, a->n);
        if (kind == 2)
            cor_law_arrayf(law, end, quantity, is_inverse ? a->epsf : a->betaf, yf, a->n);
        for (size_t i = 0; i < a->n; i++)
            results_put(r, kind == 0 ? cor_law_value(law, end, quantity, in[i]) : kind == 1 ? y[i] : (double)yf[i]);
    }
}

static void call_cor_law_function(const struct arguments *a, struct results *r)
{
    const struct cor_law_function *const f = cor_law_function(COR_LAW_TSUJI, COR_END_LIMITED, COR_EPS);
    for (size_t i = 0; i < a->n; i++)
        results_put(r, f->value(a->beta[i]));
}

#define CALL_OF_LAWS(function, kind)                                                                                   \
    static void call_##function(const struct arguments *a, struct results *r)                                          \
    {                                                                                                                  \
        put_laws(a, r, kind);                                                                                          \
    }
CALL_OF_LAWS(cor_law_value, 0)
CALL_OF_LAWS(cor_law_array, 1)
CALL_OF_LAWS(cor_law_arrayf, 2)

#define CALL_OF_NAME(function, type)                                                                                   \
    static void call_##function(const struct arguments *a, struct results *r)                                          \
    {                                                                                                                  \
        const char *const name = function((enum type)a->status[0]);                                                    \
        results_put(r, name ? (double)strlen(name) : 0);                                                               \
    }
CALL_OF_NAME(cor_law_name, cor_law)
CALL_OF_NAME(cor_end_name, cor_end)
CALL_OF_NAME(cor_quantity_name, cor_quantity)

static void call_cor_status_text(const struct arguments *a, struct results *r)
{
    for (size_t i = 0; i < a->n; i++)
        results_put(r, (double)strlen(cor_status_text(a->status[i])));
}

#ifdef WITHOUT_FILES /* mkstemp belongs to POSIX (tests/platforms) */
static void call_cor_disk_modes_read(const struct arguments *a, struct results *r)
{
    (void)a;
    (void)r;
}
#else
static void put_line(FILE *file, uint32_t *check, const char *text)
{
    char end[12];
    *check = cor_mode_file_check(*check, text, strlen(text));
    *check = cor_mode_file_check(*check, " ", 1);
    snprintf(end, sizeof end, "%08lx\n", (unsigned long)*check);
    fprintf(file, "%s %s", text, end);
    *check = cor_mode_file_check(*check, end, strlen(end));
}

/* Reads a file of two modes. The second may be chosen so that its check overflows. */
static void read_file(const char *second, struct results *r)
{
    char path[] = P_tmpdir "/cor-public-calls-XXXXXX";
    struct cor_disk_mode mode[2];
    struct cor_disk_modes modes = {0, 0, NULL};
    uint32_t check = COR_MODE_FILE_CHECK_START;
    size_t line;
    const int descriptor = mkstemp(path);
    FILE *const file = descriptor >= 0 ? fdopen(descriptor, "wb") : NULL;
    if (file == NULL)
        abort();
    const char *const lines[] = {"cor-disk-modes 1",
                                 "source a test",
                                 "poisson 0x1p-2 0.25",
                                 "modes 2",
                                 "mode 2 0 0x1.7b9618adbae28p+0 0x1.6625d55b3cb8fp+0 -0x1.b2c5f17ab1872p-2",
                                 second,
                                 "end"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        put_line(file, &check, lines[i]);
    fclose(file);
    results_put(r, cor_disk_modes_read(path, mode, 2, &modes, &line));
    results_put(r, (double)line);
    results_put(r, cor_disk_modes_read(path, NULL, 0, &modes, NULL));
    results_put(r, (double)modes.count);
    remove(path);
    results_put(r, cor_disk_modes_read(path, mode, 2, &modes, &line)); /* file does not exist */
}

static void call_cor_disk_modes_read(const struct arguments *a, struct results *r)
{
    (void)a;
    read_file("mode 2147483647 0 0x1p+1023 0x1p+1023 0x1p+1023", r);
    read_file("mode 0 0 0x1.5p+1 0x1p+1023 0x0p+0", r);
    read_file("mode 1 0 0x1p-1022 0x1p-1022 0x1p-1022", r);
}
#endif

static void call_cor_disk_modes_compute(const struct arguments *a, struct results *r)
{
    struct cor_disk_mode mode[32];
    struct cor_disk_modes modes = {0, 0, NULL};
    memset(mode, 0, sizeof mode);
    results_put(r, cor_disk_modes_compute(a->nu[0], 32, mode, &modes));
    results_put(r, modes.nu);
    results_put(r, mode[31].omega);
    results_put(r, mode[31].c);
    results_put(r, mode[31].s);
}

static void call_cor_disk_rayleigh(const struct arguments *a, struct results *r)
{
    struct cor_disk_rayleigh out = {0, 0, 0, 0};
    double fraction[12] = {0};
    results_put(r, cor_disk_rayleigh(&a->modes[0], a->n_modes[0], a->datum[0], a->speed[0], &out, fraction));
    put_numbers(r, &out, 4);
    results_put(r, fraction[0]);
}

static void call_cor_disk_rayleigh_array(const struct arguments *a, struct results *r)
{
    static struct cor_disk_rayleigh out[PUBLIC_COUNT];
    static double fraction[12 * PUBLIC_COUNT];
    int status[PUBLIC_COUNT];
    const size_t n = a->n_modes[0] % 4 == 0 || a->n < 10 ? a->n : 10; /* a call with many speeds is slow */
    memset(out, 0, sizeof out);
    results_put(r,
                cor_disk_rayleigh_array(&a->modes[0], a->n_modes[0], a->datum[0], a->speed, n, out, fraction, status));
    for (size_t i = 0; i < n; i++)
        put_numbers(r, &out[i], 4);
}

static void call_cor_disk_rayleigh_tolerance(const struct arguments *a, struct results *r)
{
    struct cor_disk_rayleigh out = {0, 0, 0, 0};
    size_t modes = 0;
    results_put(r, cor_disk_rayleigh_tolerance(&a->modes[0], a->datum[0], a->speed[0], a->tolerance[0], &out, &modes));
    put_numbers(r, &out, 4);
    results_put(r, (double)modes);
}

/* A static workspace, so that only the library allocates memory */
static unsigned char workspace[1 << 22];

/* Calls the functions of a soft or a rigid wall: one collision without an observer, and one with an observer */
#define COLLISIONS(wall, moment_of_wall, n_modes, numbers, last)                                                       \
    static void put_##wall(struct results *r, const struct cor_disk_##wall *out)                                       \
    {                                                                                                                  \
        put_numbers(r, out, numbers);                                                                                  \
        results_put(r, (double)out->last);                                                                             \
    }                                                                                                                  \
    static void call_cor_disk_##wall(const struct arguments *a, struct results *r)                                     \
    {                                                                                                                  \
        struct cor_disk_##wall out;                                                                                    \
        memset(&out, 0, sizeof out);                                                                                   \
        results_put(r, cor_disk_##wall(&a->modes[0], n_modes, &a->disk_##wall##_options[0], a->speed[0], &out));       \
        put_##wall(r, &out);                                                                                           \
    }                                                                                                                  \
    static void observe_##wall(void *context, const struct moment_of_wall *moment)                                     \
    {                                                                                                                  \
        *(double *)context += moment->load;                                                                            \
    }                                                                                                                  \
    static void call_cor_disk_##wall##_in(const struct arguments *a, struct results *r)                                \
    {                                                                                                                  \
        static double after[PUBLIC_MODES], average[PUBLIC_MODES], q[PUBLIC_MODES], q_dot[PUBLIC_MODES];                \
        double load = 0;                                                                                               \
        const struct cor_disk_##wall##_detail detail = {after, average, observe_##wall, &load, q, q_dot};              \
        struct cor_disk_##wall out;                                                                                    \
        memset(&out, 0, sizeof out);                                                                                   \
        results_put(r, cor_disk_##wall##_in(workspace, sizeof workspace, &a->modes[0], n_modes,                        \
                                            &a->disk_##wall##_options[0], a->speed[0], &out, &detail));                \
        put_##wall(r, &out);                                                                                           \
        results_put(r, load);                                                                                          \
    }
COLLISIONS(collision, cor_disk_moment, a->n_modes[0], 4, steps)
COLLISIONS(hard_wall, cor_disk_hard_wall_moment, PUBLIC_MODES, 5, omega_levels)

static void call_cor_disk_collision_array(const struct arguments *a, struct results *r)
{
    enum { SPEEDS = 3 };
    struct cor_disk_collision out[SPEEDS];
    int status[SPEEDS];
    const size_t n = a->n < SPEEDS ? a->n : SPEEDS;
    memset(out, 0, sizeof out);
    results_put(r, cor_disk_collision_array(&a->modes[0], a->n_modes[0], &a->disk_collision_options[0], a->speed, n,
                                            out, status));
    for (size_t i = 0; i < n; i++)
        put_collision(r, &out[i]);
}

static void call_cor_disk_hard_wall_nu(const struct arguments *a, struct results *r)
{
    if (a->n_modes[0] % 4 != 0) /* each call computes its modes, which is slow */
        return;
    const struct cor_disk_hard_wall_options options = {fmax(a->disk_hard_wall_options[0].tolerance, 1e-2), 0};
    struct cor_disk_hard_wall out;
    memset(&out, 0, sizeof out);
    results_put(r, cor_disk_hard_wall_nu(a->nu[0], &options, a->speed[0], &out));
    put_hard_wall(r, &out);
}

/* ---- all of them ---- */

#define SCALAR(function, type, given) {#function, call_##function, NULL, PUBLIC_##type},
#define ARRAY(function, given, element) {#function, call_##function, elements_##function, PUBLIC_double},
#define FLOATS(function, given) {#function, call_##function, NULL, PUBLIC_float},
#define INIT(function, type, given) {#function, call_##function, NULL, PUBLIC_several},
#define OTHER(function) {#function, call_##function, NULL, PUBLIC_several},
const struct public_function public_functions[] = {
#include "public_functions.inc"
};
const size_t public_function_count = sizeof public_functions / sizeof *public_functions;
