/* SPDX-License-Identifier: MIT */
/* corgen collide: one collision in proved digits. */
#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "enclosure/collision.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/formula.h"
#include "support/local.h"

/* The columns of the table. name: for dimensionless arguments and for SI units; NULL: no such column. Under a constant
 * force, the columns of the surface replace the columns of zero force. */
enum { BETA, FORCE_MAX = 9, STICKING, COLUMNS = STICKING + 2 };
static const struct {
    const char *name[2], *meaning;
    int end; /* end of contact of the column; OPTIONS_NOT_GIVEN: any */
} column[COLUMNS] = {
    {{"beta", "beta"}, "damping, the one parameter", OPTIONS_NOT_GIVEN},
    {{"x_max", "max_overlap_m"}, "largest overlap", OPTIONS_NOT_GIVEN},
    {{"t_max", "time_of_max_overlap_s"}, "time of the largest overlap", OPTIONS_NOT_GIVEN},
    {{"eps_zero_overlap", "eps_zero_overlap"},
     "coefficient of restitution, contact ends at zero overlap",
     COR_END_ZERO_OVERLAP},
    {{"t_zero_overlap", "duration_s_zero_overlap"}, "duration of that contact", COR_END_ZERO_OVERLAP},
    {{"eps_zero_force", "eps_zero_force"},
     "coefficient of restitution, contact ends at zero force",
     COR_END_ZERO_FORCE},
    {{"t_zero_force", "duration_s_zero_force"}, "duration of that contact", COR_END_ZERO_FORCE},
    {{"eps_surface", "eps_surface"}, "restitution at the surface, contact ends at zero force", END_SURFACE},
    {{"t_surface", "duration_s_surface"}, "time until the bodies return to the surface", END_SURFACE},
    {{NULL, "max_force_n"}, "largest force between the bodies", OPTIONS_NOT_GIVEN},
    /* --threshold */
    {{"sticking_force_zero_overlap", NULL}, "force above which the overlap never vanishes again", COR_END_ZERO_OVERLAP},
    {{"sticking_force_surface", NULL}, "force above which the bodies never reach the surface again", END_SURFACE}};

#define BETA_MAX 1e6

static bool in_si(const struct collide_arguments *o)
{
    return o->stiffness.text != NULL;
}

/* A force of 0 counts as no force. */
static bool is_pressed(const struct collide_arguments *o)
{
    return o->threshold || (o->force.text && !fmpq_is_zero(o->force.value));
}

/* True if column i is printed. Columns of an end that is not requested are not computed. Under a constant force the
 * largest force is omitted, because the contact force may have several maxima. */
static bool is_printed(int i, const struct collide_arguments *o)
{
    const int end = column[i].end;
    return column[i].name[in_si(o)] && (i == BETA || (i >= STICKING) == o->threshold) &&
           !(i == FORCE_MAX && is_pressed(o)) && end != (is_pressed(o) ? COR_END_ZERO_FORCE : END_SURFACE) &&
           (end == OPTIONS_NOT_GIVEN || o->end == OPTIONS_NOT_GIVEN || o->end == end);
}

/* Returns beta as a number that every format accepts. A decimal stays as given, with at least one digit before and
 * after its point. A ratio is rounded to the digits of the table, or to one more if it is halfway between two such
 * numbers. */
static char *beta_text(const struct collide_arguments *o, const arb_t beta)
{
    const char *given = o->beta.text;
    if (o->beta.forms & DECIMAL_RATIO) {
        char *const rounded = digits_of_ball(beta, o->digits);
        return rounded ? rounded : digits_of_ball(beta, o->digits + 1);
    }
    while (given[0] == '0' && given[1] >= '0' && given[1] <= '9')
        given++;
    const size_t whole = strspn(given, "0123456789"), point = given[whole] == '.';
    const size_t digits = strspn(given + whole + point, "0123456789");
    const char *const exponent = given + whole + point + digits;
    const size_t size = strlen(given) + 2;
    char *const text = xmalloc(size);
    snprintf(text, size, "%.*s%s%.*s%s", whole ? (int)whole : 1, whole ? given : "0", digits ? "." : "", (int)digits,
             given + whole + point, exponent);
    return text;
}

/* Computes, in SI units, beta and the factor from times of the scaled collision to seconds. */
static void set_scales(arb_t beta, arb_t time_unit, const struct collide_arguments *o, slong prec)
{
    const fmpq *const K = o->stiffness.value, *const C = o->damping_coefficient.value,
                      *const m = o->effective_mass.value, *const g = o->speed.value;
    const struct ratio a = law_elastic(&o->law.exponents), b = law_damping(&o->law.exponents),
                       q = law_speed_exponent(&o->law.exponents);
    LET(time_unit, prec, "(m/K)^(1/(a + 1))*g^((1 - a)/(a + 1))", m, K, a, g);
    LET(beta, prec, "(C/m)*(m/K)^((b + 1)/(a + 1))*g^q", C, m, K, a, b, g, q);
}

/* Fills the table, which has one row. */
static int fill_table(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits)
{
    const struct collide_arguments *const o = arguments;
    char header[COLUMNS * 32] = "";
    for (int i = 0; i < COLUMNS; i++)
        if (is_printed(i, o))
            snprintf(header + strlen(header), sizeof header - strlen(header), i ? ",%s" : "%s",
                     column[i].name[in_si(o)]);
    const fmpq *const F = o->force.value, *const m = o->effective_mass.value, *const g = o->speed.value;
    profile_step("collision");
    table_init(table, header, "dddddddd");
    int at = o->end;
    contact_end_given(&at, is_pressed(o));
    LOCAL(arb, beta, time_unit, force, pressing);
    LOCAL_VECTOR(sticking, 2);
    LOCAL_INIT(collision, collision, (&collision));
    /* beta is rounded with extra bits, so that this rounding never decides the accuracy of the result */
    if (in_si(o))
        set_scales(beta, time_unit, o, 3 * bits + 256);
    else
        arb_set_fmpq(beta, o->beta.value, 3 * bits + 256);
    if (o->force.text) /* in SI units the scaled force is F T/(m g), T = time_unit */
        LET(pressing, 3 * bits + 256, in_si(o) ? "F*time_unit/(m*g)" : "F", F, time_unit, m, g);
    int status =
        o->threshold ? STATUS_OK : collision_solve_pressed(&collision, beta, pressing, &o->law.exponents, at, bits);
    for (int end = 0; end < 2 && o->threshold && status == STATUS_OK; end++)
        if (is_printed(STICKING + end, o))
            status = collision_sticking_force(sticking + end, beta, &o->law.exponents, end, bits);
    if (status == STATUS_OK && in_si(o)) {
        const slong prec = 3 * bits + 256;
        arb_ptr const time[] = {collision.t_max, collision.t_zero_overlap, collision.t_zero_force};
        for (int i = 0; i < 3; i++)
            arb_mul(time[i], time[i], time_unit, prec);
        LET(collision.x_max, prec, "collision.x_max*time_unit*g", collision.x_max, time_unit, g);
        status = is_pressed(o) ? STATUS_OK : collision_force_max(force, beta, &o->law.exponents, bits);
        LET(force, prec, "force*m*g/time_unit", force, m, g, time_unit);
    }
    profile_step("digits");
    const arb_struct *const value[COLUMNS] = {beta,
                                              collision.x_max,
                                              collision.t_max,
                                              collision.eps_zero_overlap,
                                              collision.t_zero_overlap,
                                              collision.eps_zero_force,
                                              collision.t_zero_force,
                                              collision.eps_zero_force,
                                              collision.t_zero_force,
                                              force,
                                              sticking,
                                              sticking + 1};
    for (int i = BETA; i < COLUMNS && status == STATUS_OK && !*undecided; i++) {
        if (!is_printed(i, o))
            continue;
        char *text = i == BETA && !in_si(o) ? beta_text(o, beta) : digits_of_ball(value[i], o->digits);
        if (text)
            table_add(table, text);
        else
            snprintf(undecided, PROVED_TABLE_NAME, "%s", column[i].name[in_si(o)]);
    }
    return status;
}

static void print_text(FILE *file, const struct table *table, const void *arguments)
{
    const struct collide_arguments *const o = arguments;
    const int width = o->threshold ? 27 : in_si(o) ? 23 : 16;
    for (int i = 0, k = 0; i < COLUMNS; i++)
        if (is_printed(i, o)) {
            fprintf(file, "%-*s  %s  (%s)\n", width, table->column[k], table->cell[k], column[i].meaning);
            k++;
        }
}

static int run_collide(const void *arguments)
{
    const struct collide_arguments *const o = arguments;
    if (!in_si(o) && !o->beta.text)
        return usage_error("corgen collide needs --beta, for example --beta 0.1, or a collision in SI units, for "
                           "example --stiffness 1e5 --effective-mass 1e-3 --damping-coefficient 5 --speed 1");
    if (in_si(o)) {
        LOCAL(arb, beta, time_unit);
        set_scales(beta, time_unit, o, 64);
        if (arf_cmp_d(arb_midref(beta), BETA_MAX) > 0)
            return usage_error("beta of this collision is %.3g; allowed: up to %g", ball_middle(beta), BETA_MAX);
    }
    if (o->threshold && fmpq_is_zero(o->beta.value))
        return usage_error(
            "--threshold needs --beta above 0, because without damping no force holds the bodies together");
    int end = o->end;
    if (contact_end_given(&end, is_pressed(o)) != STATUS_OK)
        return STATUS_USAGE;
    const struct proved_table table = {o->digits, o, fill_table, print_text};
    return proved_table_write(&table, &o->common);
}

static const char help[] =
    "Usage: corgen collide --beta B [OPTION]...\n\n"
    "Solves x'' + beta sqrt(x) x' + x^(3/2) = 0, x(0) = 0, x'(0) = 1 and prints the largest\n"
    "overlap, its time, and eps and duration at both ends of contact.\n\n"
    "  --beta B         dissipation parameter, 0 to 1e6, such as 0.1, 1.5e-3 or 2/3\n"
    "  --stiffness K --effective-mass M --damping-coefficient C --speed G\n"
    "                   a collision in SI units instead of --beta: the force K x^(3/2) + C sqrt(x) x'\n"
    "                   between bodies with M = m_1 m_2/(m_1 + m_2), at the impact speed G, m/s; adds\n"
    "                   the largest force\n"
    "  --force F        constant force that presses the bodies together, 0 or more, in units of m g/T, or\n"
    "                   in N in SI units; bodies that stay together have eps 0 and t inf, proved\n"
    "  --threshold      print the force above which the bodies stay together, in units of m g/T\n"
    "  --end E          the only end to compute, zero-overlap or zero-force, or under a force\n"
    "                   zero-overlap or surface (default: both ends)\n" HELP_DIGITS
    "  --format F       output format, text, csv or json (default text)\n" HELP_JSON_STRINGS HELP_LAW HELP_COMMON "\n"
    "Columns: beta,x_max,t_max,eps_zero_overlap,t_zero_overlap,eps_zero_force,t_zero_force;\n"
    "with --end, only the columns of this end. In SI units beta,max_overlap_m,time_of_max_overlap_s,\n"
    "eps_zero_overlap,duration_s_zero_overlap,eps_zero_force,duration_s_zero_force,max_force_n.\n"
    "Under a force, eps_surface,t_surface (duration_s_surface) replace the columns of zero force, and\n"
    "max_force_n is absent. The surface is the place of first contact: the bodies part where the contact\n"
    "force vanishes, and fly to the surface. With --threshold the columns are\n"
    "beta,sticking_force_zero_overlap,sticking_force_surface.\n\n"
    "Example: corgen collide --beta 0.1 --digits 30\n";

static const struct option_numbers beta_numbers = {.range = {"0", "1e6", true, true, false, "a number from 0 to 1e6"},
                                                   .forms = DECIMAL_RATIO};

#define ARGUMENTS struct collide_arguments
#define SI(NAME, FIELD, NUMBERS, NEEDS)                                                                                \
    OPTION(NAME, REAL, FIELD, .range.number = (NUMBERS), .excludes = "beta", .needs = (NEEDS))
static const struct option_rule options[] = {
    OPTION("beta", REAL, beta, .range.number = &beta_numbers),
    SI("stiffness", stiffness, &option_positive, "effective-mass"),
    SI("effective-mass", effective_mass, &option_positive, "damping-coefficient"),
    SI("damping-coefficient", damping_coefficient, &option_not_negative, "speed"),
    SI("speed", speed, &option_positive, "stiffness"),
    OPTION("force", REAL, force, .range.number = &option_not_negative),
    OPTION("threshold", FLAG, threshold, .excludes = "force stiffness", .needs = "beta"),
    OPTION_DIGITS,
    OPTION_END_OF(end, contact_end_options_pressed),
    OPTION_FORMAT(option_formats),
    OPTION_JSON_STRINGS,
    OPTION_LAW,
    OPTION_COMMON,
};

SUBCOMMAND(collide, "collide", "one collision to any number of digits", .digits = OPTIONS_DEFAULT_DIGITS,
           .end = OPTIONS_NOT_GIVEN);
