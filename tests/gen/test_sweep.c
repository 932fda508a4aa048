/* SPDX-License-Identifier: MIT */
/* Tests sweeps: lists, rows, and the journal, which must survive every interruption. */
#define _DEFAULT_SOURCE /* mkdtemp, truncate */
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/console.h" /* must precede cmocka.h, which defines a macro fail */

#include "check.h"

#include "cor/status.h"
#include "support/output.h"
#include "sweep/sweep.h"

/* ---- lists ---- */

static const struct values_rule any = {
    "any", {"-1000", "1000", true, true, true, "a number from -1000 to 1000"}, false};
static const struct values_rule whole = {
    "whole", {"1", "1000", true, true, true, "a whole number from 1 to 1000"}, true};

static void assert_list(const struct values_rule *rule, const char *list, const char *expected)
{
    struct values values;
    check(values_parse(&values, rule, list) == STATUS_OK, "%s", list);
    char seen[1000] = "", text[DECIMAL_TEXT];
    for (size_t i = 0; i < values.count; i++)
        snprintf(seen + strlen(seen), sizeof seen - strlen(seen), "%s%s", i ? " " : "",
                 decimal_text(text, values.nearest[i]));
    assert_string_equal(seen, expected);
    values_clear(&values);
}

static void assert_exact(const struct values *values, size_t i, const char *expected)
{
    char *const exact = fmpq_get_str(NULL, 10, values->exact + i);
    assert_string_equal(exact, expected);
    flint_free(exact);
}

TEST(test_lists)
{
    assert_list(&any, "0.1", "0.1");
    assert_list(&any, "-1e2,1/3,5e-324,.5", "-100 0.3333333333333333 4.94065645841247e-324 0.5");
    assert_list(&any, "0.1:0.3:+0.1", "0.1 0.2 0.3"); /* computed exactly: three times the double 0.1 is above 0.3 */
    assert_list(&any, "0.1:0.35:+0.1", "0.1 0.2 0.3");
    assert_list(&any, "1:-1:-2/3", "1 0.3333333333333333 -0.3333333333333333 -1");
    assert_list(&any, "2:2:+1", "2");
    assert_list(&any, "0:1:lin:4", "0 0.3333333333333333 0.6666666666666666 1");
    assert_list(&any, "1:-1:lin:3", "1 0 -1");
    assert_list(&any, "0.001:1:log:4", "0.001 0.01 0.1 1");
    assert_list(&any, "8:1:log:3", "8 2.8284271247461903 1");
    assert_list(&any, "3,1:4:+1,3,2", "3 1 2 4"); /* each value once, at its first place */
    assert_list(&whole, "1:10:log:5", "1 2 3 6 10");
    assert_list(&whole, "1:4:lin:9", "1 2 3 4"); /* halves round up: 1 1.375 1.75 2.125 2.5 2.875 3.25 3.625 4 */
    assert_list(&whole, "100:900:+400,2e2", "100 500 900 200");

    struct values values;
    assert_int_equal(values_parse(&values, &any, "1:1000:lin:3,1/7"), STATUS_OK);
    assert_exact(&values, 1, "1001/2");
    assert_exact(&values, 3, "1/7");
    assert_true(values.least == 1.0 / 7 && values.largest == 1000);
    values_clear(&values);
    /* if two exact numbers round to one double, the list contains only the first */
    assert_int_equal(values_parse(&values, &any, "1/3,0.33333333333333333,2,33333333333333333e-17"), STATUS_OK);
    assert_int_equal(values.count, 2);
    assert_exact(&values, 0, "1/3");
    values_clear(&values);
}

TEST(test_longest_list)
{
    static const struct values_rule many = {"many", {"1", "1e7", true, true, true, "a number from 1 to 1e7"}, true};
    struct values values;
    char text[64];
    snprintf(text, sizeof text, "1:%d:+1", VALUES_MAX);
    assert_int_equal(values_parse(&values, &many, text), STATUS_OK);
    assert_int_equal(values.count, VALUES_MAX);
    assert_true(values.largest == VALUES_MAX);
    values_clear(&values);
    snprintf(text, sizeof text, "1:%d:+1", VALUES_MAX + 1);
    assert_int_equal(values_parse(&values, &many, text), STATUS_USAGE);
}

static void assert_wrong(const struct values_rule *rule, const char *const *list)
{
    struct values values;
    for (; *list; list++) {
        check(values_parse(&values, rule, *list) == STATUS_USAGE, "%s", *list);
        assert_int_equal(values.count, 0);
    }
}
#define WRONG(rule, ...) assert_wrong(rule, (const char *const[]){__VA_ARGS__, NULL})

TEST(test_wrong_lists)
{
    WRONG(&any, "", ",", "1,", ",1", "1,,2", "1001", "-1000.1", "x", "1 ", "+1", "1:2", "1:2:3", "1:2:+0", "1:2:-1",
          "2:1:+1", "1:2:+-1", "1:2:lin:1", "1:2:lin:", "1:2:lin:x", "1:2:lin:1.5", "1:2:log:-3", "0:1:log:3",
          "-1:1:log:3", "1:2:geo:3", "1:2:lin:3:", ":::", "1:1001:lin:3", "1e1000", "1/0", "1:2:lin:9999999", "2:1:+-1",
          "2:1:--1");
    WRONG(&whole, "0", "1.5", "1/3", "1001", "1:10:+0.5");
    /* numbers inside the range whose doubles are outside */
    WRONG(&sweep_poisson, "0.99999999999999999");
    WRONG(&sweep_speed, "1e-400");
}

/* ---- rows ---- */

static struct sweep sweep_of(const char *speed, const char *poisson, const char *alpha, const char *modes)
{
    struct sweep sweep = {.tolerance = 1e-8};
    assert_int_equal(values_parse(&sweep.speed, &sweep_speed, speed), STATUS_OK);
    assert_int_equal(values_parse(&sweep.poisson, &sweep_poisson, poisson), STATUS_OK);
    assert_int_equal(values_parse(&sweep.alpha, &sweep_alpha, alpha), STATUS_OK);
    assert_int_equal(values_parse(&sweep.modes, &sweep_modes, modes), STATUS_OK);
    return sweep;
}

static void sweep_clear(struct sweep *sweep)
{
    values_clear(&sweep->speed);
    values_clear(&sweep->poisson);
    values_clear(&sweep->alpha);
    values_clear(&sweep->modes);
}

TEST(test_product)
{
    struct sweep sweep = sweep_of("0.2,0.1,0.3", "0.9,-1/3", "500,100", "940,10,3600,1");
    assert_int_equal(sweep_count(&sweep), STATUS_OK);
    assert_int_equal(sweep.rows, 48);
    assert_int_equal(sweep_rows_of_material(&sweep), 24);
    const double speed[] = {0.2, 0.1, 0.3}, nu[] = {0.9, -1.0 / 3}, alpha[] = {500, 100};
    const size_t modes[] = {940, 10, 3600, 1};
    for (size_t i = 0; i < sweep.rows; i++) {
        struct sweep_row row;
        sweep_row(&row, &sweep, i);
        assert_true(row.speed == speed[i % 3] && row.nu == nu[i / 24] && row.alpha == alpha[i / 12 % 2] &&
                    row.modes == modes[i / 3 % 4]);
    }

    /* the tolerance determines the number of digits */
    static const double tolerance[] = {1e-6, 1.1e-6, 9e-6, 1e-5};
    FILE *const none = tmpfile();
    assert_non_null(none);
    for (int i = 0; i < 4; i++) {
        struct sweep_printer printer;
        sweep.tolerance = tolerance[i];
        sweep_print_start(&printer, &sweep, FORMAT_CSV, none);
        assert_int_equal(printer.digits[4], i < 3 ? 6 : 5);
        sweep_print_end(&printer);
    }
    fclose(none);
    sweep_clear(&sweep);
    for (size_t more = 0; more < 2; more++) {
        sweep = (struct sweep){.hard_wall = true, .speed.count = SWEEP_MAX_ROWS + more, .poisson.count = 1};
        assert_int_equal(sweep_count(&sweep), more ? STATUS_USAGE : STATUS_OK);
    }
    sweep = sweep_of("0.1:0.2:lin:100000", "0.1:0.2:lin:10", "50:60:lin:500", "1:3:+1");
    assert_int_equal(sweep_count(&sweep), STATUS_USAGE); /* 1.5e9 */
    sweep_clear(&sweep);
}

static void assert_line(const struct sweep *sweep, const struct sweep_result *result, const char *expected)
{
    char line[SWEEP_LINE];
    sweep_line(line, sweep, result);
    assert_string_equal(line, expected);
}

/* Digits end with the second digit of the error, and the error is rounded up. */
TEST(test_digits)
{
    enum { EPS = 4, ERROR = 10 };
    const struct sweep soft = {.hard_wall = false}, hard = {.hard_wall = true}, rayleigh = {.rayleigh = true};
    struct sweep_result result = {
        {0.2, 0.33, 4000, 100, 0.88708388558330694, 0.2130821795, 5.5432109, 0.27474726, -1.2345e-3, 99, 0.0601},
        COR_TOLERANCE_NOT_REACHED};
    assert_line(&soft, &result, "0.2,0.33,4000,100,0.887,0.213,5.54,0.275,-0.0012,99,0.061,tolerance_not_reached");
    result.value[ERROR] = 1;
    assert_line(&soft, &result, "0.2,0.33,4000,100,0.9,0.2,6,0.3,-0.0012,99,1,tolerance_not_reached");
    assert_line(&hard,
                &(struct sweep_result){{0.2, 0.33, 0.2130821795, 0.8870838855, 5.5432109, 0.27474726, 9.91e-6},
                                       COR_TOLERANCE_NOT_REACHED},
                "0.2,0.33,0.2130822,0.8870839,5.543211,0.2747473,1e-05,tolerance_not_reached");
    assert_line(&rayleigh, &(struct sweep_result){{1e-3, 0.33, 100, 0.36, 0.0036, 0.79774683, 7.25, 2e-6}, COR_OK},
                "0.001,0.33,100,0.36,0.0036,0.7977468,7.25,2e-06,ok");

    for (size_t i = 0; i < points(10000); i++) {
        const double eps = random_uniform(&draw, 0, 1), error = random_log(&draw, 1e-17, 1);
        char line[SWEEP_LINE];
        result.value[EPS] = eps;
        result.value[ERROR] = error;
        sweep_line(line, &soft, &result);
        double printed, printed_error;
        assert_int_equal(sscanf(line, "%*[^,],%*[^,],%*[^,],%*[^,],%lf,%*[^,],%*[^,],%*[^,],%*[^,],%*[^,],%lf",
                                &printed, &printed_error),
                         2);
        check(fabs(printed - eps) <= 0.05 * error + 0x1p-53 && printed_error >= error && printed_error <= 1.1 * error,
              "%a +- %a: %s", eps, error, line);
        char longest[DECIMAL_TEXT], *const cell = strstr(line, ",100,") + 5;
        check((double)strcspn(cell, ",") <= fmin(4 - log10(error), (double)strlen(decimal_text(longest, eps))),
              "%g: %s", error, line);
    }
}

/* ---- the journal ---- */

static const char title[] = "corgen disk-collide, unfinished: --speed 0.1";
static const char *const line[] = {"1,2,3", "", "a longer line, with 12345678 at its end,12345678", "4,5"};
enum { LINES = COUNT_OF(line) };

enum { MOST = 1 << 12 };
static char file[64], part[64], *whole_file; /* FILE, FILE.part, and the bytes of a complete FILE */
static size_t whole_size;

static void part_write(const char *bytes, size_t size)
{
    FILE *const stream = fopen(part, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, size, stream), size);
    assert_int_equal(fclose(stream), 0);
}

static void assert_part(const char *bytes, size_t size, const char *after, size_t at)
{
    size_t there;
    char *const read = read_file(part, SIZE_MAX, &there);
    check(read && there == size && memcmp(read, bytes, size) == 0, "%s %zu", after, at);
    free(read);
}

static void count_line(void *context, const char *text)
{
    size_t *n = context;
    assert_true(*n < LINES);
    assert_string_equal(text, line[(*n)++]);
}

static int start(struct journal *journal)
{
    return journal_open(journal, file, title, LINES);
}

/* Continues from the present file to the end. Returns the number of lines found, or -1 if the file was refused. */
static int go_on(void)
{
    struct journal journal;
    if (start(&journal) != STATUS_OK)
        return -1;
    const uint64_t found = journal.lines;
    assert_true(found <= LINES);
    if (found > 0)
        assert_string_equal(journal.last, line[found - 1]);
    for (uint64_t i = found; i < LINES; i++)
        assert_int_equal(journal_add(&journal, line[i]), STATUS_OK);
    size_t n = 0;
    assert_int_equal(journal_read(&journal, count_line, &n), STATUS_OK);
    assert_int_equal(n, LINES);
    journal_close(&journal, false);
    return (int)found;
}

/* Continues from these bytes and checks that the final bytes are right. */
static int go_on_from(const char *bytes, size_t size, const char *what, size_t at)
{
    part_write(bytes, size);
    const int found = go_on();
    if (found >= 0)
        assert_part(whole_file, whole_size, what, at);
    return found;
}

static int start_all(void **state)
{
    (void)state;
    console_start();
    static char directory[] = "/tmp/cor-sweep-XXXXXX";
    assert_non_null(mkdtemp(directory));
    snprintf(file, sizeof file, "%s/x", directory);
    snprintf(part, sizeof part, "%s/x.part", directory);
    assert_int_equal(go_on(), 0);
    whole_file = read_file(part, MOST, &whole_size);
    assert_non_null(whole_file);
    assert_int_equal(go_on(), LINES);
    return 0;
}

/* Journals that are cut or damaged at any byte, or too long */
TEST(test_journal_damaged)
{
    int last = 0;
    for (size_t cut = 0; cut <= whole_size; cut++) { /* all lines before the cut are reused */
        const int found = go_on_from(whole_file, cut, "cut at", cut);
        check(found >= last && found <= last + 1, "%d after %d at %zu", found, last, cut);
        last = found;
    }
    assert_int_equal(last, LINES);
    char bytes[MOST];
    memcpy(bytes, whole_file, whole_size);
    const size_t more = (size_t)snprintf(bytes + whole_size, 100, "and\nmore");
    assert_int_equal(go_on_from(bytes, whole_size + more, "longer by", more), LINES);
    for (size_t at = strlen(title) + 1; at < whole_size; at++) { /* zeros, as after a power failure */
        memcpy(bytes, whole_file, whole_size);
        memset(bytes + at, 0, whole_size - at);
        const int found = go_on_from(bytes, whole_size, "damaged at", at);
        check(found >= 0 && found < LINES, "%zu: %d", at, found);
    }
    /* one valid row too many */
    struct journal journal;
    assert_int_equal(journal_open(&journal, file, title, UINT64_MAX), STATUS_OK);
    assert_int_equal(journal_add(&journal, "one line more, and a good one"), STATUS_OK);
    journal_close(&journal, false);
    assert_int_equal(go_on(), LINES);
    assert_part(whole_file, whole_size, "a row more", 0);
    static const char foreign[][8] = {"x", "x\n", "c\0mine", "z\n1,2\n"}; /* refused, and not changed */
    for (size_t i = 0; i < COUNT_OF(foreign); i++) {
        assert_int_equal(go_on_from(foreign[i], sizeof foreign[i], "foreign", i), -1);
        assert_part(foreign[i], sizeof foreign[i], "foreign", i);
    }
}

/* Writes the title and the n rows with these numbers, without their last `cut` bytes. Returns the size. */
static size_t put_rows(char bytes[MOST], const size_t *row, size_t n, size_t cut)
{
    size_t size = (size_t)sprintf(bytes, "%s\n", title);
    for (size_t i = 0; i < n; i++) {
        const char *at = strchr(whole_file, '\n') + 1;
        for (size_t k = 0; k < row[i]; k++)
            at = strchr(at, '\n') + 1;
        size += (size_t)sprintf(bytes + size, "%.*s\n", (int)(strcspn(at, "\n") - cut), at);
    }
    return size;
}

/* Any row except the right next one is refused, and so is a changed byte or a missing check. */
TEST(test_journal_changed)
{
    char bytes[MOST];
    for (size_t i = 0; i < points(300); i++) {
        const size_t at = strlen(title) + 1 + random_below(&draw, whole_size - strlen(title) - 1);
        size_t row = 0;
        for (size_t k = strlen(title) + 1; k < at; k++)
            row += whole_file[k] == '\n';
        memcpy(bytes, whole_file, whole_size);
        bytes[at] = (char)(bytes[at] ^ (char)(1 + random_below(&draw, 255)));
        check(go_on_from(bytes, whole_size, "changed at", at) == (int)row, "%zu: %d", at, (int)bytes[at]);
    }
    for (size_t i = 0; i < points(100); i++) {
        size_t row[LINES], n = 1 + random_below(&draw, LINES), kept = 0;
        for (size_t k = 0; k < n; k++)
            row[k] = random_below(&draw, LINES);
        while (kept < n && row[kept] == kept)
            kept++;
        check(go_on_from(bytes, put_rows(bytes, row, n, 0), "rows", n) == (int)kept, "%zu of %zu", kept, n);
        assert_int_equal(go_on_from(bytes, put_rows(bytes, row, n, strlen(",12345678")), "no checks", n), 0);
    }
}

/* Other processes change or lock the journal, and the disk is full for a while. */
TEST(test_journal_shared)
{
    struct journal journal;
    /* for a while the disk is full in the middle of a line; the next run completes the line */
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct rlimit limit = {whole_size - 20, before.rlim_max};
    assert_int_equal(unlink(part), 0);
    assert_int_equal(start(&journal), STATUS_OK);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
    int full = STATUS_OK;
    for (int i = 0; i < LINES && full == STATUS_OK; i++)
        full = journal_add(&journal, line[i]);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_int_equal(full, STATUS_FAILED);
    journal_close(&journal, false);
    assert_int_equal(go_on(), LINES - 2);
    assert_part(whole_file, whole_size, "full disk", 0);

    /* another program changes and truncates the file between the last row and the table */
    size_t rows = 0;
    assert_int_equal(start(&journal), STATUS_OK);
    whole_file[whole_size - strlen("5,12345678\n")]++;
    part_write(whole_file, whole_size);
    whole_file[whole_size - strlen("5,12345678\n")]--;
    assert_int_equal(journal_read(&journal, count_line, &rows), STATUS_FAILED);
    assert_int_equal(rows, LINES - 1);
    journal_close(&journal, false);
    rows = 0;
    assert_int_equal(go_on(), LINES - 1);
    assert_int_equal(start(&journal), STATUS_OK);
    assert_int_equal(truncate(part, (off_t)(whole_size - strlen("4,5,12345678\n"))), 0); /* a removed line */
    assert_int_equal(journal_read(&journal, count_line, &rows), STATUS_FAILED);
    journal_close(&journal, true);

    /* locked by another process */
    assert_int_equal(start(&journal), STATUS_OK);
    fflush(NULL);
    const pid_t child = fork();
    struct journal mine;
    if (child == 0)
        _exit(start(&mine) == STATUS_FAILED ? 42 : 1);
    int status;
    assert_true(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 42);
    journal_close(&journal, true);
    assert_int_equal(access(part, F_OK), -1);
    *strrchr(file, '/') = '\0';
    assert_int_equal(rmdir(file), 0);
}

/* ---- rigid walls ---- */

/* Collisions that use all levels of the first table, or one level more, or whose budget ends earlier */
TEST(test_hard_wall)
{
    enum { FIRST_LEVELS = 8 };
    for (int i = 0; i < 3; i++) {
        const double tolerance = 1e-5, speed = i == 0 ? 0.1 : 0.3;
        struct hard_wall_tables tables = {0};
        struct cor_disk_hard_wall out;
        hard_wall_tables_set(&tables, 0.33);
        assert_int_equal(hard_wall_collide(&out, &tables, tolerance, i < 2 ? 0 : 1000, speed),
                         i < 2 ? COR_OK : COR_TOLERANCE_NOT_REACHED);
        check(i == 2 ? out.omega_levels < FIRST_LEVELS : out.omega_levels == FIRST_LEVELS + (size_t)i, "%zu levels",
              out.omega_levels);
        assert_true(tables.table[0].count > 100 && (tables.table[1].mode != NULL) == (i == 1));
        check(fabs(out.one_minus_eps2 - cor_disk_one_minus_eps2(speed, 0.33)) <=
                  out.error_estimate + cor_disk_one_minus_eps2_uncertainty(speed, 0.33),
              "1 - eps^2 at v = %g: %.9f", speed, out.one_minus_eps2);
        hard_wall_tables_clear(&tables);
    }
}

/* ---- Rayleigh's energy ---- */

/* A row uses only its number of modes, although the library's table has more. */
TEST(test_rayleigh)
{
    struct sweep sweep = sweep_of("1e-3,0.05,0.4", "0.33", "100", "100");
    const struct cor_disk_modes cut = {0.33, 100, cor_disk_modes_nu033.mode};
    static const int status[] = {COR_OK, COR_BEYOND_THEORY, COR_ERROR_SPEED};
    sweep.rayleigh = true;
    for (uint64_t i = 0; i < 3; i++) {
        struct cor_disk_rayleigh r = {NAN, NAN, NAN, NAN};
        struct sweep_result of_whole, of_cut;
        cor_disk_rayleigh(&cut, 100, COR_DISK_DATUM_CENTRE_OF_MASS, sweep.speed.nearest[i], &r, NULL);
        sweep_collide(&of_whole, &sweep, i, &cor_disk_modes_nu033, NULL);
        sweep_collide(&of_cut, &sweep, i, &cut, NULL);
        assert_true(of_whole.status == status[i] && of_cut.status == status[i]);
        assert_memory_equal(of_whole.value, of_cut.value, sizeof of_cut.value);
        const double expected[] = {sweep.speed.nearest[i], 0.33, 100, r.fraction, r.tail};
        const double left = r.fraction + r.tail, eps = of_cut.value[5], after[] = {r.contact_time, r.error_estimate};
        assert_true(left <= 1 ? fabs(eps * eps - (1 - left)) < 1e-15 : isnan(eps));
        assert_memory_equal(of_cut.value, expected, sizeof expected);
        assert_memory_equal(of_cut.value + 6, after, sizeof after);
    }
    sweep_clear(&sweep);
}

GROUP(start_all, NULL)
