/* SPDX-License-Identifier: MIT */
#include "runtime/sphere/array.h"

#include "cor/sphere.h"
#include "generated/sphere_float_tables.h"
#include "runtime/number/environment.h"
#include "runtime/sphere/eval.h"

/* ---- tables ---- */

#define GRID(quantity, NAME, kind, value, least, near_end)                                                             \
    COR_ROW_TABLE_OF_GRID(cor_rows_##quantity, COR_ROWS_##NAME, kind, value, least, near_end)
#define INVERSE(quantity, NAME, kind)                                                                                  \
    COR_ROW_TABLE_OF_INVERSE(kind, cor_rows_near_##quantity, COR_ROWS_NEAR_##NAME, cor_rows_##quantity, COR_ROWS_##NAME)
/* First node whose row has s = beta - node^2 (COR_ROW_ROOT_S) */
#define FIRST_S(NAME) (COR_ROWS_##NAME##_PLAIN_ROWS * COR_ROWS_##NAME##_STEP)

static const struct cor_row_table
    eps_zero_overlap = GRID(eps_zero_overlap, EPS_ZERO_OVERLAP, COR_ROW_GRID, COR_ROW_SUM, 0, 0),
    eps_zero_force = GRID(eps_zero_force, EPS_ZERO_FORCE, COR_ROW_ROOT_S, COR_ROW_SUM, 0, FIRST_S(EPS_ZERO_FORCE)),
    loss_zero_overlap = GRID(loss_zero_overlap, LOSS_ZERO_OVERLAP, COR_ROW_GRID, COR_ROW_PRODUCT, COR_INLINE_2_M900, 0),
    loss_zero_force = GRID(loss_zero_force, LOSS_ZERO_FORCE, COR_ROW_ROOT_S, COR_ROW_PRODUCT, COR_INLINE_2_M900,
                           FIRST_S(LOSS_ZERO_FORCE)),
    beta_zero_overlap = INVERSE(beta_zero_overlap, BETA_ZERO_OVERLAP, COR_ROW_INVERSE),
    beta_zero_force = INVERSE(beta_zero_force, BETA_ZERO_FORCE, COR_ROW_INVERSE_ROOT),
    duration_zero_overlap = GRID(duration_zero_overlap, DURATION_ZERO_OVERLAP, COR_ROW_GRID, COR_ROW_SUM, 0, 0),
    duration_zero_force = GRID(duration_zero_force, DURATION_ZERO_FORCE, COR_ROW_ROOT, COR_ROW_SUM, 0, 0),
    max_overlap = GRID(max_overlap, MAX_OVERLAP, COR_ROW_GRID, COR_ROW_SUM, 0, 0),
    time_of_max_overlap = GRID(time_of_max_overlap, TIME_OF_MAX_OVERLAP, COR_ROW_GRID, COR_ROW_SUM, 0, 0);

#define POWER(end, END) COR_ROW_TABLE_OF_OCTAVES(cor_rows_power_eps_##end, COR_ROWS_POWER_EPS_##END, COR_ROW_SUM)
static const struct cor_row_table power_eps_zero_overlap = POWER(zero_overlap, ZERO_OVERLAP),
                                  power_eps_zero_force = POWER(zero_force, ZERO_FORCE),
                                  every_beta = {.kind = COR_ROW_NONE, .end = INFINITY};

/* ---- array functions of sphere.h ---- */

void cor_sphere_eps_zero_overlap_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&eps_zero_overlap, cor_sphere_eps_zero_overlap, beta, y, n);
}

void cor_sphere_eps_zero_force_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&eps_zero_force, cor_sphere_eps_zero_force, beta, y, n);
}

void cor_sphere_loss_zero_overlap_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&loss_zero_overlap, cor_sphere_loss_zero_overlap, beta, y, n);
}

void cor_sphere_loss_zero_force_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&loss_zero_force, cor_sphere_loss_zero_force, beta, y, n);
}

void cor_sphere_beta_zero_overlap_array(const double *eps, double *y, size_t n)
{
    cor_row_array(&beta_zero_overlap, cor_sphere_beta_zero_overlap, eps, y, n);
}

void cor_sphere_beta_zero_force_array(const double *eps, double *y, size_t n)
{
    cor_row_array(&beta_zero_force, cor_sphere_beta_zero_force, eps, y, n);
}

void cor_sphere_duration_zero_overlap_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&duration_zero_overlap, cor_sphere_duration_zero_overlap, beta, y, n);
}

void cor_sphere_duration_zero_force_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&duration_zero_force, cor_sphere_duration_zero_force, beta, y, n);
}

void cor_sphere_max_overlap_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&max_overlap, cor_sphere_max_overlap, beta, y, n);
}

void cor_sphere_time_of_max_overlap_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&time_of_max_overlap, cor_sphere_time_of_max_overlap, beta, y, n);
}

/* ---- in float arithmetic ---- */

static void float_array(struct float_table table, double (*one)(double x), const float *x, float *y, size_t n)
{
#ifdef COR_WITHOUT_LOOPS
    (void)table;
    for (size_t i = 0; i < n; i++)
        y[i] = (float)one((double)x[i]);
#else
    const struct cor_environment caller = cor_environment_enter();
    cor_row_loops(cor_array_set())->floats(&table, one, x, y, n);
    cor_environment_leave(&caller);
#endif
}

void cor_sphere_eps_zero_overlap_arrayf(const float *beta, float *y, size_t n)
{
    const struct float_table table = FLOAT_TABLE(eps_zero_overlap, EPS_ZERO_OVERLAP, 0);
    float_array(table, cor_sphere_eps_zero_overlap, beta, y, n);
}

void cor_sphere_eps_zero_force_arrayf(const float *beta, float *y, size_t n)
{
    const struct float_table table = FLOAT_TABLE(eps_zero_force, EPS_ZERO_FORCE, 0);
    float_array(table, cor_sphere_eps_zero_force, beta, y, n);
}

void cor_sphere_loss_zero_overlap_arrayf(const float *beta, float *y, size_t n)
{
    const struct float_table table = FLOAT_TABLE(loss_zero_overlap, LOSS_ZERO_OVERLAP, 1);
    float_array(table, cor_sphere_loss_zero_overlap, beta, y, n);
}

void cor_sphere_loss_zero_force_arrayf(const float *beta, float *y, size_t n)
{
    const struct float_table table = FLOAT_TABLE(loss_zero_force, LOSS_ZERO_FORCE, 1);
    float_array(table, cor_sphere_loss_zero_force, beta, y, n);
}

/* ---- array functions of contact.h ---- */

static void contact_array(const struct cor_contact_function *function, const struct cor_sphere_contact *contact,
                          const double *speed, const double *eps, double *y, size_t n)
{
    const struct cor_environment caller = cor_environment_enter();
    cor_contact_loops(cor_array_set())->run(function, contact, speed, eps, y, n);
    cor_environment_leave(&caller);
}

void cor_contact_eps_zero_overlap_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *y,
                                        size_t n)
{
    static const struct cor_contact_function function = {CONTACT_EPS,
                                                         &power_eps_zero_overlap,
                                                         &eps_zero_overlap,
                                                         cor_inline_eps_overlap_far_root,
                                                         cor_contact_eps_zero_overlap,
                                                         NULL};
    contact_array(&function, contact, speed_m_s, NULL, y, n);
}

void cor_contact_eps_zero_force_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *y,
                                      size_t n)
{
    static const struct cor_contact_function function = {CONTACT_EPS, &power_eps_zero_force,      &eps_zero_force,
                                                         NULL,        cor_contact_eps_zero_force, NULL};
    contact_array(&function, contact, speed_m_s, NULL, y, n);
}

void cor_contact_beta_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *y, size_t n)
{
    static const struct cor_contact_function function = {CONTACT_BETA, &every_beta, NULL, NULL, cor_contact_beta, NULL};
    contact_array(&function, contact, speed_m_s, NULL, y, n);
}

void cor_contact_duration_s_zero_overlap_array(const struct cor_sphere_contact *contact, const double *speed_m_s,
                                               double *y, size_t n)
{
    static const struct cor_contact_function function = {
        CONTACT_DURATION, &duration_zero_overlap, NULL, NULL, cor_contact_duration_s_zero_overlap, NULL};
    contact_array(&function, contact, speed_m_s, NULL, y, n);
}

void cor_contact_duration_s_zero_force_array(const struct cor_sphere_contact *contact, const double *speed_m_s,
                                             double *y, size_t n)
{
    static const struct cor_contact_function function = {
        CONTACT_DURATION, &duration_zero_force, NULL, NULL, cor_contact_duration_s_zero_force, NULL};
    contact_array(&function, contact, speed_m_s, NULL, y, n);
}

void cor_contact_max_overlap_m_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *y,
                                     size_t n)
{
    static const struct cor_contact_function function = {CONTACT_OVERLAP,           &max_overlap, NULL, NULL,
                                                         cor_contact_max_overlap_m, NULL};
    contact_array(&function, contact, speed_m_s, NULL, y, n);
}

void cor_contact_dissipation_time_s_zero_overlap_array(const struct cor_sphere_contact *contact,
                                                       const double *speed_m_s, const double *eps, double *y, size_t n)
{
    static const struct cor_contact_function function = {
        CONTACT_DISSIPATION, &beta_zero_overlap, NULL, NULL, NULL, cor_contact_dissipation_time_s_zero_overlap};
    contact_array(&function, contact, speed_m_s, eps, y, n);
}

void cor_contact_dissipation_time_s_zero_force_array(const struct cor_sphere_contact *contact, const double *speed_m_s,
                                                     const double *eps, double *y, size_t n)
{
    static const struct cor_contact_function function = {
        CONTACT_DISSIPATION, &beta_zero_force, NULL, NULL, NULL, cor_contact_dissipation_time_s_zero_force};
    contact_array(&function, contact, speed_m_s, eps, y, n);
}
