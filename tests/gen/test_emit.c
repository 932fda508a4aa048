/* SPDX-License-Identifier: MIT */
/* Tests the output of emit_c: a compiler reads every double back to the bit, and gives no warnings. */
#define _XOPEN_SOURCE 700
#include "support/console.h" /* must precede cmocka.h, which defines a macro fail */

#include <unistd.h>

#include "ball.h"

#include "enclosure/collision.h"
#include "support/digits.h"
#include "support/emit_c.h"
#include "support/output.h"
#include "tables/files.h"

enum { PREC = 256, BITS = 192, PATH = 512 };

static char directory[PATH];

static int make_directory(void **state)
{
    (void)state;
    const char *parent = getenv("TMPDIR");
    snprintf(directory, sizeof directory, "%s/cor-emit-XXXXXX", parent ? parent : "/tmp");
    return mkdtemp(directory) ? 0 : -1;
}

static int remove_directory(void **state)
{
    (void)state;
    static const char *const made[] = {"header.h", "main.c", "main"};
    char path[PATH + 16];
    for (size_t i = 0; i < sizeof made / sizeof *made; i++) {
        snprintf(path, sizeof path, "%s/%s", directory, made[i]);
        unlink(path);
    }
    return rmdir(directory);
}

static FILE *create(const char *name)
{
    char path[PATH + 16];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    return file;
}

static struct emit header_of(const char *banner)
{
    struct emit e;
    emit_open(&e, create("header.h"), "HEADER_H", banner);
    return e;
}

static void header_end(struct emit *e)
{
    emit_close(e);
    assert_int_equal(fclose(e->file), 0);
}

/* Closes main.c, compiles and runs it. Returns its output. */
static FILE *compile_and_run(FILE *source)
{
    char command[4 * PATH];
    const char *cc = getenv("CC");
    assert_int_equal(fclose(source), 0);
    snprintf(command, sizeof command,
             "%s -std=c99 -Wall -Wextra -Wpedantic -Wconversion $(cmake/werror '%s') -I. -o '%s/main' '%s/main.c' -lm",
             cc ? cc : "cc", cc ? cc : "cc", directory, directory);
    assert_int_equal(system(command), 0);
    snprintf(command, sizeof command, "'%s/main'", directory);
    FILE *output = popen(command, "r");
    assert_non_null(output);
    return output;
}

static double read_double(FILE *output)
{
    char text[64];
    assert_int_equal(fscanf(output, "%63s", text), 1);
    return strtod(text, NULL);
}

/* Doubles of every kind: exact, irrational, huge, tiny, subnormal, negative. The numbers of a grid are macros whose
 * prefix is the name of the table in capitals. */
TEST(test_doubles)
{
    enum { COUNT = 9 };
    arb_ptr x = _arb_vec_init(COUNT);
    double expected[COUNT];
    static const char *const numbers[COUNT - 1] = {"1",         "-3/4",      "pi",        "-pi",
                                                   "2^1000*pi", "pi/2^1000", "pi/2^1060", "sqrt(2)"};
    for (int i = 0; i < COUNT; i++) {
        if (i < COUNT - 1)
            LET(x + i, PREC, numbers[i], i);
        assert_true(digits_to_double(&expected[i], x + i));
    }

    const double real[] = {0, 7, 1048576, -2, 0.0625, 0x1p-40, 1.0 / 3, 1e300};
    enum { REALS = sizeof real / sizeof *real };
    struct emit e = header_of("A banner\n\nthat tries to end early: */ int oops;\n");
    for (int i = 0; i < REALS; i++) {
        char what[16];
        snprintf(what, sizeof what, "REAL_%d", i);
        emit_geometry_real(&e, "a_table1", what, real[i]);
    }
    emit_geometry_integer(&e, "a_table1", "ROWS", 65);
    emit_geometry_integer(&e, "a_table1", "OCTAVE", -40);
    emit_comment(&e, "%d*/%d", 1, 2);
    assert_int_equal(emit_doubles(&e, "value", x, COUNT), 0);
    emit_lines(&e, "enum { ONE = $d, $S = $d };\n#define BOUND $s\n", 1, "length", COUNT, emit_bound(5.21e-11).text);
    header_end(&e);
    FILE *const file = create("main.c");
    fprintf(file, "#include <stdio.h>\n#include \"header.h\"\n#include \"header.h\"\n"
                  "int main(void)\n{\n"
                  "    printf(\"%%d %%d %%d %%d %%.17g\\n\", (int)(sizeof value / sizeof *value), LENGTH,\n"
                  "           2 * A_TABLE1_ROWS, 3 -A_TABLE1_OCTAVE, BOUND);\n"
                  "    for (int i = 0; i < LENGTH; i++)\n        printf(\"%%a\\n\", value[i]);\n");
    for (int i = 0; i < REALS; i++)
        fprintf(file, "    printf(\"%%a\\n\", 0.5 * A_TABLE1_REAL_%d);\n", i);
    fprintf(file, "    return ONE - 1;\n}\n");
    FILE *output = compile_and_run(file);
    int size, count, twice_rows, octaves;
    double bound;
    assert_int_equal(fscanf(output, "%d %d %d %d %lf", &size, &count, &twice_rows, &octaves, &bound), 5);
    assert_true(size == COUNT && count == COUNT && twice_rows == 130 && octaves == 43);
    assert_true(bound == 5.3e-11);
    for (int i = 0; i < COUNT; i++)
        assert_true(read_double(output) == expected[i]);
    for (int i = 0; i < REALS; i++)
        assert_true(read_double(output) == 0.5 * real[i]);
    assert_int_equal(pclose(output), 0);
    _arb_vec_clear(x, COUNT);
}

/* Hexadecimal and decimal rows inside a function give the same doubles. The csv digits of hexadecimal rows and of
 * structs read back to the same doubles. */
TEST(test_rows)
{
    enum { ROWS = 3, COLUMNS = 5 };
    arb_ptr x = _arb_vec_init(ROWS * COLUMNS);
    double expected[ROWS * COLUMNS];
    for (slong i = 0; i < ROWS * COLUMNS; i++) {
        const slong power = i == 0 ? -40 : i % 4 == 3 ? -1060 : 40 * (i - 7); /* includes subnormal numbers */
        LET(x + i, PREC, "(-1)^i*sqrt(2*i + 1)*2^power", i, power);
        assert_true(digits_to_double(&expected[i], x + i));
    }
    char *text;
    size_t size;
    FILE *digits = open_memstream(&text, &size);
    assert_non_null(digits);
    emit_digits(digits);
    struct emit e = header_of("rows");
    emit_comment(&e, "what the structs below are");
    fprintf(e.file, "struct pair { int i, k; double a, b, c, d, e; };\n");
    for (int decimal = 0; decimal < 2; decimal++) {
        e.decimal = decimal;
        emit_structs_open(&e, "pair", decimal ? "decimal" : "hexadecimal", ROWS);
        for (slong i = 0; i < ROWS; i++)
            assert_int_equal(emit_struct(&e, (const slong[]){i, -i}, 2, x + i * COLUMNS, COLUMNS), 0);
        emit_structs_close(&e);
        emit_rows_open(&e, "double", decimal ? "decimals" : "hexadecimals", ROWS, COLUMNS);
        for (slong i = 0; i < ROWS; i++)
            assert_int_equal(emit_row(&e, x + i * COLUMNS, COLUMNS), 0);
        emit_rows_close(&e);
    }
    emit_digits(NULL);
    header_end(&e);
    assert_int_equal(fclose(digits), 0);
    const char *line = strchr(text, '\n') + 1;
    assert_int_equal(strncmp(text, "table,row,column,value,digits\n", (size_t)(line - text)), 0);
    for (int form = 0; form < 2; form++)
        for (long i = 0; i < ROWS * COLUMNS; i++, line = strchr(line, '\n') + 1) {
            char table[32], value[64], decimal[64];
            long row, column;
            assert_int_equal(sscanf(line, "%31[a-z],%ld,%ld,%63[^,],%63s", table, &row, &column, value, decimal), 5);
            assert_string_equal(table, form ? "hexadecimals" : "hexadecimal");
            assert_int_equal(row * COLUMNS + column, i + (form ? 0 : 2)); /* a struct begins with two integers */
            assert_true(strtod(value, NULL) == expected[i]);
            if (i == 0) /* 2^-40 is written as a fraction */
                assert_string_equal(decimal, "1/1099511627776");
            else
                assert_true(strtod(decimal, NULL) == expected[i]);
        }
    assert_string_equal(line, "");
    free(text);

    FILE *const file = create("main.c");
    fprintf(file,
            "#include \"runtime/table/rows.h\"\n#include <stdio.h>\n#include \"header.h\"\n"
            "int main(void)\n{\n"
            "    for (int i = 0; i < %d; i++)\n        for (int k = 0; k < %d; k++)\n"
            "            if (hexadecimal[i].i != i || decimal[i].k != -i ||\n"
            "                (&hexadecimal[i].a)[k] != (&decimal[i].a)[k] || (&decimal[i].a)[k] != decimals(i)[k])\n"
            "                return 1;\n"
            "            else\n"
            "                printf(\"%%a %%a\\n\", hexadecimals(i)[k], decimals(i)[k]);\n"
            "    return 0;\n}\n",
            ROWS, COLUMNS);
    FILE *output = compile_and_run(file);
    for (int i = 0; i < 2 * ROWS * COLUMNS; i++)
        assert_true(read_double(output) == expected[i / 2]);
    assert_int_equal(pclose(output), 0);

    /* a number whose ball is too wide ends the row with an error */
    mag_set_ui_2exp_si(arb_radref(x + 1), 1, 300);
    e = header_of("rows");
    emit_rows_open(&e, "double", "rows", 1, COLUMNS);
    assert_int_equal(emit_doubles(&e, "value", x, COLUMNS), 1);
    for (int decimal = 0; decimal < 2; decimal++) {
        e.decimal = decimal;
        assert_int_equal(emit_row(&e, x, COLUMNS), 1);
    }
    assert_int_equal(fclose(e.file), 0);
    _arb_vec_clear(x, ROWS * COLUMNS);
}

/* emit_lines with float, and with double */
TEST(test_types)
{
    static const char *const expected[] = {"double sqrt(1.0) 64 0.3333333333333333 4599676419421066581",
                                           "float sqrtf(1.0f) 32 0.33333333f 1051372203"};
    for (int single = 0; single < 2; single++) {
        char *text = NULL;
        size_t size;
        struct emit e = {.file = open_memstream(&text, &size), .single = single};
        emit_lines(&e, "$T sqrt$F(1.0$F) $B $x $b", 1.0 / 3, 1.0 / 3);
        assert_int_equal(fclose(e.file), 0);
        assert_string_equal(text, expected[single]);
        free(text);
    }
}

TEST(test_bound)
{
    assert_string_equal(emit_bound(1.0).text, "1.0e+00");
    assert_string_equal(emit_bound(1.01e-10).text, "1.1e-10");
    assert_string_equal(emit_bound(9.91e-13).text, "1.0e-12");
    assert_string_equal(emit_bound(0).text, "0.0e+00");
    double x = 1e-16;
    for (int i = 0; i < 1000; i++, x *= 1.0371) {
        const double up = strtod(emit_bound(x).text, NULL);
        assert_true(up >= x && up <= 1.1 * x);
    }
}

/* Compiles the functions of a header and compares them with collisions at random beta. eps and loss must keep the
 * stated bounds, the loss also near beta = 0. */
static void check_pade_header(const struct pade_request *r, slong beta_max, struct random_state *random)
{
    enum { PLACES = 24 };
    struct references references;
    double beta[PLACES];
    LOCAL(pade, f);
    LOCAL(pade_analysis, a);
    LOCAL(collision, collision);
    LOCAL(arb, x);
    assert_int_equal(pade_compute(f, a, r, BITS), 0);
    assert_int_equal(references_init(&references, &law_sphere, beta_max, 16, 2), 0);
    const struct pade_header h = {
        .name = "cor_test", .title = "test", .end = r->end, .beta_max = beta_max, .references = &references};
    struct emit e = header_of("Pade");
    emit_lines(&e, "#include <math.h>\n");
    assert_int_equal(pade_emit(&e, &h, f, a), 0);
    header_end(&e);
    FILE *const file = create("main.c");
    fprintf(file, "#include <stdio.h>\n#include \"header.h\"\nint main(void)\n{\n    static const double beta[] = {-1");
    for (int i = 0; i < PLACES; i++) {
        beta[i] = i % 4 == 0 ? random_log(random, 1e-12, 0.1) : random_log(random, 0.1, (double)beta_max);
        beta[i] = i == 1 ? fmin(2.5, (double)beta_max) : beta[i]; /* beta at which a two-point approximant is worst */
        fprintf(file, ", %a", beta[i]);
    }
    fprintf(file, "};\n    printf(\"%%g %%.17g %%.17g %%.17g %%.17g\\n\", COR_TEST_BETA_MAX, COR_TEST_EPS_MAX_REL,\n"
                  "           COR_TEST_LOSS_MAX_REL, COR_TEST_EPS_EVALUATION_REL, COR_TEST_LOSS_EVALUATION_REL);\n"
                  "    for (unsigned i = 0; i < sizeof beta / sizeof *beta; i++)\n"
                  "        printf(\"%%.17g %%.17g\\n\", cor_test_eps(beta[i]), cor_test_loss(beta[i]));\n"
                  "    return 0;\n}\n");
    FILE *output = compile_and_run(file);
    double limit, eps_bound, loss_bound, eps_rounding, loss_rounding, eps, loss;
    assert_int_equal(
        fscanf(output, "%lf %lf %lf %lf %lf", &limit, &eps_bound, &loss_bound, &eps_rounding, &loss_rounding), 5);
    assert_true(limit == (double)beta_max && eps_rounding < 1e-13 && loss_rounding < 1e-13);
    assert_int_equal(fscanf(output, "%lf %lf", &eps, &loss), 2);
    assert_true(isnan(eps) && isnan(loss));
    for (int i = 0; i < PLACES; i++) {
        arb_set_d(x, beta[i]);
        assert_int_equal(collision_solve(collision, x, &law_sphere, 128), 0);
        arb_set(x, r->end == COR_END_ZERO_FORCE ? collision->eps_zero_force : collision->eps_zero_overlap);
        const double exact = middle(x);
        LET(x, 128, "1 - x", x);
        const double exact_loss = middle(x);
        assert_int_equal(fscanf(output, "%lf %lf", &eps, &loss), 2);
        /* between the samples the error may be a tenth larger than at the samples */
        check(fabs(eps / exact - 1) <= 1.1 * eps_bound, "eps at beta = %.17g: %.17g, not %.17g", beta[i], eps, exact);
        check(fabs(loss / exact_loss - 1) <= 1.1 * loss_bound, "loss at beta = %.17g: %.17g, not %.17g", beta[i], loss,
              exact_loss);
        check(fabs(eps + loss - 1) <= eps_rounding + loss_rounding + 1e-15, "beta = %.17g", beta[i]);
    }
    assert_int_equal(pclose(output), 0);
    references_clear(&references);
}

TEST(test_pade_header)
{
    static const struct {
        struct pade_request request;
        slong beta_max;
    } row[] = {{{.numerator = 4, .denominator = 6, .end = COR_END_ZERO_FORCE}, 2},
               {{.numerator = 3, .denominator = 6, .end = COR_END_ZERO_OVERLAP}, 2},
               {{.kind = PADE_TWO_POINT, .numerator = 4, .denominator = 9, .end = COR_END_ZERO_OVERLAP}, 1000}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct pade_request request = row[i].request;
        request.law = law_sphere;
        if (row[i].beta_max > PADE_NEAR && !in_turn(1, 3))
            continue;
        check_pade_header(&request, row[i].beta_max, &draw);
    }
}

/* Cells in json by the kind of their column: numbers with all digits, texts, or null */
TEST(test_json_cells)
{
    static const char *const cells[] = {"-1",  "1e300", "-1.25E-07", "", "inf", "-inf", "9007199254740993",
                                        "nan", "1",     "4/15",      ""};
    for (int strings = 0; strings < 2; strings++) {
        struct table table;
        char *text = NULL, expected[256];
        size_t size;
        FILE *file = open_memstream(&text, &size);
        table_init(&table, "a,b,c,d,e,f,g,h,i,j,k", "nnnnnnddttt");
        table.json_strings = strings;
        for (size_t i = 0; i < sizeof cells / sizeof *cells; i++)
            table_add_text(&table, cells[i]);
        table_print(&table, FORMAT_JSON, file);
        table_clear(&table);
        assert_int_equal(fclose(file), 0);
        snprintf(expected, sizeof expected,
                 "[\n  {\"a\": -1, \"b\": 1e300, \"c\": -1.25E-07, \"d\": null, \"e\": null, \"f\": null, \"g\": "
                 "%s9007199254740993%s, \"h\": null, \"i\": \"1\", \"j\": \"4/15\", \"k\": null}\n]\n",
                 strings ? "\"" : "", strings ? "\"" : "");
        assert_string_equal(text, expected);
        free(text);
    }
}

/* eps(1/2) at zero overlap from corgen collide --beta 0.5, which encloses the motion and uses no series */
#define EPS_AT_HALF 0.57382462866494898355

/* For every two-point Padé approximant with a numerator of degree up to 20, all coefficients can be rounded. The error
 * of eps(1/2) falls with the degree. From degree 15 onward they have a pole far above 1/2. */
TEST(test_two_point_rounded)
{
    enum { MOST = 20, TWO_POINT_PREC = 300 };
    leave_to_turn(2, 3);
    LOCAL(arb_poly, series);
    LOCAL(arb, limit, half, p, q, l);
    LOCAL(pade, f);
    slong root;
    double before = 1;
    assert_int_equal(series_eps(series, &root, COR_END_ZERO_OVERLAP, MOST + 4, &law_sphere, TWO_POINT_PREC), 0);
    assert_int_equal(collision_h_star(limit, TWO_POINT_PREC), 0);
    arb_pow_ui(limit, limit, 5, TWO_POINT_PREC);
    arb_set_d(half, 0.5);
    for (slong m = 0; m <= MOST; m++) {
        LOCAL_INIT(pade_rounded, r, (&r));
        assert_true(pade_two_point_of_series(f, series, limit, m, TWO_POINT_PREC));
        assert_int_equal(pade_round(&r, f), 0);
        arb_poly_evaluate(p, r.p_double, half, TWO_POINT_PREC);
        arb_poly_evaluate(q, r.q_double, half, TWO_POINT_PREC);
        arb_poly_evaluate(l, r.l_double, half, TWO_POINT_PREC);
        const double eps = middle(p) / middle(q), loss = 0.5 * middle(l) / middle(q);
        const double error = fabs(eps / EPS_AT_HALF - 1);
        assert_true(fabs(eps + loss - 1) < 1e-14);
        assert_true(error < 1e-13 || error < before);
        before = error;
    }
}

GROUP(make_directory, remove_directory)
