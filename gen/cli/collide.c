/* SPDX-License-Identifier: MIT */
/* corgen collide: one collision in proved digits. */
#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "cli/proved_table.h"
#include "enclosure/collision.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

static const char *const column[] = {"beta",           "x_max",          "t_max",       "eps_zero_overlap",
                                     "t_zero_overlap", "eps_zero_force", "t_zero_force"};
enum { T_MAX = 2, EPS_ZERO_FORCE_COLUMN = 5, COLUMNS = sizeof column / sizeof *column };

static const char *const meaning[COLUMNS] = {
    "damping, the one parameter",  "largest overlap",
    "time of the largest overlap", "coefficient of restitution, contact ends at zero overlap",
    "duration of that contact",    "coefficient of restitution, contact ends at zero force",
    "duration of that contact"};

struct problem {
    const struct decimal *beta;
    struct law law;
    slong digits;
    int end; /* OPTIONS_NOT_GIVEN: both */
};

/* Whether column i is printed: those of an end that is not asked for are not even computed. */
static bool is_printed(int i, int end)
{
    return i <= T_MAX || end == OPTIONS_NOT_GIVEN || (i >= EPS_ZERO_FORCE_COLUMN) == (end == END_ZERO_FORCE);
}

static int problem_solve(struct collision *c, const arb_t beta, const struct problem *problem, slong bits)
{
    if (problem->end == OPTIONS_NOT_GIVEN || arb_is_zero(beta))
        return collision_solve(c, beta, &problem->law, bits);
    return (problem->end == END_ZERO_FORCE ? collision_solve_force : collision_solve_overlap)(c, beta, &problem->law,
                                                                                              bits);
}

/* beta as a number of every format: a decimal as given, with a digit before its point and one behind; a ratio rounded
 * to the digits of the table, or to one more where it lies in the middle of two. */
static char *beta_text(const struct problem *problem, const arb_t beta)
{
    const char *given = problem->beta->text;
    if (problem->beta->forms & DECIMAL_RATIO) {
        char *const rounded = digits_of_ball(beta, problem->digits);
        return rounded ? rounded : digits_of_ball(beta, problem->digits + 1);
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

/* Fills the table, which has one row. */
static int fill_table(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits)
{
    const struct problem *const problem = arguments;
    profile_step("collision");
    static const char *printed[COLUMNS];
    int columns = 0;
    for (int i = 0; i < COLUMNS; i++)
        if (is_printed(i, problem->end))
            printed[columns++] = column[i];
    table_init(table, printed, columns);
    table->kinds = "ddddddd";
    LOCAL(arb, beta);
    /* beta is rounded with extra bits, so that this rounding never decides the accuracy of the result */
    arb_set_fmpq(beta, problem->beta->value, 3 * bits + 256);
    struct collision collision;
    collision_init(&collision);
    const int status = problem_solve(&collision, beta, problem, bits);
    profile_step("digits");
    const arb_struct *const value[COLUMNS] = {NULL,
                                              collision.x_max,
                                              collision.t_max,
                                              collision.eps_zero_overlap,
                                              collision.t_zero_overlap,
                                              collision.eps_zero_force,
                                              collision.t_zero_force};
    table_add(table, beta_text(problem, beta));
    for (int i = 1; i < COLUMNS && status == STATUS_OK && !*undecided; i++) {
        if (!is_printed(i, problem->end))
            continue;
        char *text = digits_of_ball(value[i], problem->digits);
        if (text)
            table_add(table, text);
        else
            snprintf(undecided, PROVED_TABLE_NAME, "%s", column[i]);
    }
    collision_clear(&collision);
    return status;
}

static void print_text(FILE *file, const struct table *table)
{
    for (int k = 0; k < table->columns; k++)
        for (int i = 0; i < COLUMNS; i++)
            if (table->column[k] == column[i])
                fprintf(file, "%-16s  %s  (%s)\n", column[i], table->cell[k], meaning[i]);
}

static int run_collide(const void *arguments)
{
    const struct collide_arguments *const o = arguments;
    struct problem problem = {.beta = &o->beta, .digits = o->digits, .end = o->end};
    const int wrong = options_law(&problem.law, &o->law);
    if (wrong)
        return wrong;
    const struct proved_table table = {o->digits, &problem, fill_table, print_text};
    return proved_table_write(&table, &o->common);
}

static const char help[] =
    "Usage: corgen collide --beta B [OPTION]...\n\n"
    "Solves x'' + beta sqrt(x) x' + x^(3/2) = 0, x(0) = 0, x'(0) = 1 and prints the largest\n"
    "overlap, its time, and restitution and duration at both ends of contact.\n\n"
    "  --beta B         dissipation parameter, from 0 to 1e6, such as 0.1, 1.5e-3 or 2/3\n"
    "  --end E          compute only zero-overlap or zero-force, without waiting for the other end\n"
    "                   (default: both)\n" HELP_DIGITS
    "  --format F       text (default), csv or json\n" HELP_JSON_STRINGS HELP_LAW HELP_COMMON
    "\nColumns: beta,x_max,t_max,eps_zero_overlap,t_zero_overlap,eps_zero_force,t_zero_force;\n"
    "with --end, without the columns of the other end.\n"
    "\nExample: corgen collide --beta 0.1 --digits 30\n";

static const struct option_numbers beta_numbers = {.range = {"0", "1e6", true, true, false, "a number from 0 to 1e6"},
                                                   .forms = DECIMAL_RATIO};

#define AT(FIELD) offsetof(struct collide_arguments, FIELD)
static const struct option_rule options[] = {
    {.name = "beta", .kind = OPTION_REAL, .offset = AT(beta), .range.number = &beta_numbers, .required = true},
    OPTION_DIGITS(struct collide_arguments),
    OPTION_END(struct collide_arguments, end),
    OPTION_FORMAT(struct collide_arguments, option_formats),
    OPTION_JSON_STRINGS(struct collide_arguments),
    OPTION_LAW(struct collide_arguments),
    OPTION_COMMON(struct collide_arguments),
    {.name = NULL},
};

static const struct collide_arguments defaults = {.digits = OPTIONS_DEFAULT_DIGITS, .end = OPTIONS_NOT_GIVEN};

const struct subcommand command_collide = {.name = "collide",
                                           .summary = "one collision to any number of digits",
                                           .help = help,
                                           .options = options,
                                           .size = sizeof defaults,
                                           .defaults = &defaults,
                                           .run = run_collide};
