/* SPDX-License-Identifier: MIT */
#include "runtime/sphere/array.h"

#include "cor/sphere.h"
#include "runtime/number/environment.h"
#include "runtime/sphere/eval.h"

/* ---- tables ---- */

#define ROWS(quantity, table)                                                                                          \
    [COR_SPHERE_##quantity] = {table, cor_sphere_##quantity, cor_sphere_##quantity##f, COR_FLOAT_EXCEPTION_##quantity}
#define GRID(quantity, NAME, kind, value, least, near_end)                                                             \
    ROWS(quantity, COR_ROW_TABLE_OF_GRID(cor_rows_##quantity, COR_ROWS_##NAME, kind, value, least, near_end))
#define SUM(quantity, NAME) GRID(quantity, NAME, COR_ROW_GRID, COR_ROW_SUM, 0, 0)
#define LOSS(quantity, NAME) GRID(quantity, NAME, COR_ROW_GRID, COR_ROW_PRODUCT, COR_INLINE_2_M900, 0)
#define INVERSE(quantity, NAME, kind)                                                                                  \
    ROWS(quantity, COR_ROW_TABLE_OF_INVERSE(kind, cor_rows_near_##quantity, COR_ROWS_NEAR_##NAME, cor_rows_##quantity, \
                                            COR_ROWS_##NAME))
/* The least node whose rows have s = beta - node^2 */
#define FIRST_S(NAME) (COR_ROWS_##NAME##_PLAIN_ROWS * COR_ROWS_##NAME##_STEP)

const struct cor_sphere_rows cor_sphere_rows[COR_SPHERE_COUNT] = {
    SUM(eps_zero_overlap, EPS_ZERO_OVERLAP),
    GRID(eps_zero_force, EPS_ZERO_FORCE, COR_ROW_ROOT_S, COR_ROW_SUM, 0, FIRST_S(EPS_ZERO_FORCE)),
    LOSS(loss_zero_overlap, LOSS_ZERO_OVERLAP),
    GRID(loss_zero_force, LOSS_ZERO_FORCE, COR_ROW_ROOT_S, COR_ROW_PRODUCT, COR_INLINE_2_M900,
         FIRST_S(LOSS_ZERO_FORCE)),
    INVERSE(beta_zero_overlap, BETA_ZERO_OVERLAP, COR_ROW_INVERSE),
    INVERSE(beta_zero_force, BETA_ZERO_FORCE, COR_ROW_INVERSE_ROOT),
    SUM(duration_zero_overlap, DURATION_ZERO_OVERLAP),
    GRID(duration_zero_force, DURATION_ZERO_FORCE, COR_ROW_ROOT, COR_ROW_SUM, 0, 0),
    SUM(max_overlap, MAX_OVERLAP),
    SUM(time_of_max_overlap, TIME_OF_MAX_OVERLAP),
    SUM(eps_approach_only, EPS_APPROACH_ONLY),
    LOSS(loss_approach_only, LOSS_APPROACH_ONLY),
    INVERSE(beta_approach_only, BETA_APPROACH_ONLY, COR_ROW_INVERSE),
    SUM(duration_approach_only, DURATION_APPROACH_ONLY),
};

#define POWER(end, END) COR_ROW_TABLE_OF_OCTAVES(cor_rows_power_eps_##end, COR_ROWS_POWER_EPS_##END, COR_ROW_SUM)
static const struct cor_row_table power_eps_zero_overlap = POWER(zero_overlap, ZERO_OVERLAP),
                                  power_eps_zero_force = POWER(zero_force, ZERO_FORCE),
                                  every_beta = {.kind = COR_ROW_NONE, .end = INFINITY};

#define TABLE(quantity) &cor_sphere_rows[COR_SPHERE_##quantity].table
#define CONTACT(function, kind, table, beyond, far)                                                                    \
    [COR_CONTACT_##function] = {kind, table, beyond, far, cor_contact_##function, NULL}
#define DISSIPATION(end)                                                                                               \
    [COR_CONTACT_dissipation_time_s_##                                                                                 \
        end] = {CONTACT_DISSIPATION, TABLE(beta_##end), NULL, NULL, NULL, cor_contact_dissipation_time_s_##end}
const struct cor_contact_function cor_contact_functions[COR_CONTACT_COUNT] = {
    CONTACT(eps_zero_overlap, CONTACT_EPS, &power_eps_zero_overlap, TABLE(eps_zero_overlap),
            cor_inline_eps_overlap_far_root),
    CONTACT(eps_zero_force, CONTACT_EPS, &power_eps_zero_force, TABLE(eps_zero_force), NULL),
    CONTACT(beta, CONTACT_BETA, &every_beta, NULL, NULL),
    CONTACT(duration_s_zero_overlap, CONTACT_DURATION, TABLE(duration_zero_overlap), NULL, NULL),
    CONTACT(duration_s_zero_force, CONTACT_DURATION, TABLE(duration_zero_force), NULL, NULL),
    CONTACT(max_overlap_m, CONTACT_OVERLAP, TABLE(max_overlap), NULL, NULL),
    DISSIPATION(zero_overlap),
    DISSIPATION(zero_force),
};

/* ---- array functions ---- */

/* The loops compute both sides of a condition and select one. The unused side may raise exceptions, which the
 * environment hides. */
static void sphere(enum cor_sphere_number number, const double *x, double *y, size_t n)
{
    const struct cor_row_call call = {&cor_sphere_rows[number].table, cor_sphere_rows[number].one, NULL, NULL, NULL, 0};
    const struct cor_environment caller = cor_environment_enter();
    cor_row_loops(cor_widest_set())->doubles(&call, x, y, n);
    cor_environment_leave(&caller);
}

static void spheref(enum cor_sphere_number number, const float *x, float *y, size_t n)
{
    const struct cor_sphere_rows *const rows = &cor_sphere_rows[number];
    const struct cor_environment caller = cor_environment_enter();
    cor_row_loops(cor_widest_set())->floats(&rows->table, rows->onef, rows->exception.x, x, y, n);
    cor_environment_leave(&caller);
}

static void contact_array(enum cor_contact_number number, const struct cor_sphere_contact *contact, const double *speed,
                          const double *eps, double *y, size_t n)
{
    const struct cor_environment caller = cor_environment_enter();
    cor_contact_loops(cor_widest_set())->run(&cor_contact_functions[number], contact, speed, eps, y, n);
    cor_environment_leave(&caller);
}

#define SPHERE_ARRAYS(quantity)                                                                                        \
    void cor_sphere_##quantity##_array(const double *x, double *y, size_t n)                                           \
    {                                                                                                                  \
        sphere(COR_SPHERE_##quantity, x, y, n);                                                                        \
    }                                                                                                                  \
    void cor_sphere_##quantity##_arrayf(const float *x, float *y, size_t n)                                            \
    {                                                                                                                  \
        spheref(COR_SPHERE_##quantity, x, y, n);                                                                       \
    }
#define CONTACT_ARRAY(quantity)                                                                                        \
    void cor_contact_##quantity##_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *y,  \
                                        size_t n)                                                                      \
    {                                                                                                                  \
        contact_array(COR_CONTACT_##quantity, contact, speed_m_s, NULL, y, n);                                         \
    }
#define DISSIPATION_ARRAY(quantity)                                                                                    \
    void cor_contact_##quantity##_array(const struct cor_sphere_contact *contact, const double *speed_m_s,             \
                                        const double *eps, double *y, size_t n)                                        \
    {                                                                                                                  \
        contact_array(COR_CONTACT_##quantity, contact, speed_m_s, eps, y, n);                                          \
    }
COR_SPHERE_QUANTITIES(SPHERE_ARRAYS)
COR_CONTACT_QUANTITIES(CONTACT_ARRAY)
COR_DISSIPATION_QUANTITIES(DISSIPATION_ARRAY)
