/* SPDX-License-Identifier: MIT */
/* Tests mode files: a file is read as it was written, and a damaged file is refused at the damaged line.
 * tests/gen/test_disk_modes.c proves the tables of the library. */
#define _XOPEN_SOURCE 700 /* mkstemp, P_tmpdir */

#include "check.h"

#include <unistd.h>

#include <cor/disk.h>
#include <cor/status.h>

enum { CAPACITY = 1800, LINE_MAX_LENGTH = 256, MODES_OF_FILE = 40, FIRST_MODE_LINE = 5 };

static char path[] = P_tmpdir "/cor-disk-modes-XXXXXX";

/* ---- tables ---- */

/* Every mode of both tables obeys the normalisation (26). */
TEST(tables)
{
    const struct cor_disk_modes *const table[] = {&cor_disk_modes_nu033, &cor_disk_modes_nu090};
    for (int k = 0; k < 2; k++) {
        assert_true(same_bits(table[k]->nu, k == 0 ? 0.33 : 0.9) && table[k]->count == CAPACITY);
        for (const struct cor_disk_mode *m = table[k]->mode; m < table[k]->mode + CAPACITY; m++) {
            const double radial = m->c + m->n * m->s, square = m->omega * m->omega;
            const double norm = (m->n > 0 ? 1 : 2) * (square * (m->c * m->c + m->s * m->s) - radial * radial);
            check(fabs(norm - 2 * square) < 1e-12 * square * (2 + m->s * m->s), "(%d,%d)", m->n, m->l);
        }
    }
}

/* ---- files ---- */

/* The current file */
static struct {
    char bytes[(CAPACITY + 10) * LINE_MAX_LENGTH];
    size_t length;
    uint32_t check;
} text;

static uint32_t hash(uint32_t check, const char *bytes, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        check ^= (unsigned char)bytes[i];
        check *= 16777619u;
    }
    return check;
}

/* Adds a line and its check. */
static void add_line(const char *format, ...) __attribute__((format(printf, 1, 2)));
static void add_line(const char *format, ...)
{
    char *const line = text.bytes + text.length;
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(line, LINE_MAX_LENGTH - 12, format, arguments);
    va_end(arguments);
    line[n++] = ' ';
    text.check = hash(text.check, line, (size_t)n);
    n += snprintf(line + n, 12, "%08lx\n", (unsigned long)text.check);
    text.check = hash(text.check, line + n - 9, 9);
    text.length += (size_t)n;
}

static void add_mode(const struct cor_disk_mode *m)
{
    add_line("mode %d %d %a %a %a", m->n, m->l, m->omega, m->c, m->s);
}

/* Begins a file of `count` modes with its first `lines` lines. */
static void start(int lines, size_t count)
{
    text.length = 0;
    text.check = 2166136261u;
    if (lines > 0)
        add_line("cor-disk-modes 1");
    if (lines > 1)
        add_line("source a test");
    if (lines > 2)
        add_line("poisson %a 0.33", 0.33);
    if (lines > 3)
        add_line("modes %zu", count);
}

/* Writes a file that states one number of modes and contains another. */
static void write_modes(size_t promised, const struct cor_disk_mode *mode, size_t count)
{
    start(4, promised);
    for (size_t i = 0; i < count; i++)
        add_mode(&mode[i]);
    add_line("end");
}

static void put_file(const char *bytes, size_t length)
{
    remove(path); /* some file systems wait for the disk when a file is truncated and written again */
    FILE *const file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

static struct cor_disk_mode room[CAPACITY];

/* Checks that the file is refused and that *modes does not change. */
static void refused(const char *bytes, size_t length, int expected, size_t expected_line, const char *what)
{
    struct cor_disk_modes modes = {7, 7, NULL};
    size_t line = 77;
    put_file(bytes, length);
    const int status = cor_disk_modes_read(path, room, CAPACITY, &modes, &line);
    check(status == expected && line == expected_line, "%s: status %d, line %zu, not %d, %zu", what, status, line,
          expected, expected_line);
    assert_true(modes.nu == 7 && modes.count == 7 && modes.mode == NULL);
}

static void text_refused(size_t expected_line, const char *what)
{
    refused(text.bytes, text.length, COR_ERROR_FILE_DAMAGED, expected_line, what);
}

static size_t line_at(size_t at)
{
    size_t line = 1;
    for (size_t i = 0; i < at; i++)
        line += text.bytes[i] == '\n';
    return line;
}

TEST(reads_what_was_written)
{
    for (size_t count = 1; count <= CAPACITY; count = count == 1 ? CAPACITY : count + 1) {
        struct cor_disk_modes modes = {0, 0, NULL};
        size_t line = 77;
        write_modes(count, cor_disk_modes_nu033.mode, count);
        put_file(text.bytes, text.length);
        /* reads the number of modes first, then all modes */
        assert_int_equal(cor_disk_modes_read(path, NULL, 0, &modes, NULL), COR_ERROR_CAPACITY);
        assert_int_equal(modes.count, count);
        assert_int_equal(cor_disk_modes_read(path, room, count - 1, &modes, &line), COR_ERROR_CAPACITY);
        assert_int_equal(line, 0);
        assert_int_equal(cor_disk_modes_read(path, room, count, &modes, &line), COR_OK);
        assert_true(modes.mode == room && modes.count == count && same_bits(modes.nu, 0.33) && line == 0);
        for (size_t i = 0; i < count; i++) {
            const struct cor_disk_mode *const a = &room[i], *const b = &cor_disk_modes_nu033.mode[i];
            assert_true(a->n == b->n && a->l == b->l && same_bits(a->omega, b->omega) && same_bits(a->c, b->c) &&
                        same_bits(a->s, b->s));
        }
    }
}

/* A file with one changed byte, with an early end, or with something after its end is refused. */
TEST(harmed_bytes)
{
    const size_t lines = FIRST_MODE_LINE + MODES_OF_FILE;
    write_modes(MODES_OF_FILE, cor_disk_modes_nu033.mode, MODES_OF_FILE);
    const size_t second_line = (size_t)(strchr(text.bytes, '\n') - text.bytes) + 1;
    for (size_t k = 0; k < points(2000); k++) {
        const size_t at = second_line + random_below(&draw, text.length - second_line);
        text.bytes[at] ^= (char)(1 + random_below(&draw, 255));
        text_refused(line_at(at), "one byte");
        write_modes(MODES_OF_FILE, cor_disk_modes_nu033.mode, MODES_OF_FILE);
    }
    for (size_t length = second_line; length < text.length; length += length < 400 ? 1 : 61)
        refused(text.bytes, length, COR_ERROR_FILE_DAMAGED, line_at(length), "truncated");
    refused(text.bytes, text.length - 1, COR_ERROR_FILE_DAMAGED, lines, "no last line end");
    text.bytes[text.length++] = '\n';
    text_refused(lines + 1, "one byte more");
}

TEST(first_line)
{
    static const char *const others[] = {"",
                                         "\n",
                                         "cor-disk-modes",
                                         "cor-disk-modez 1 00000000\n",
                                         "cor-disk-modes_1 00000000\n",
                                         "cor-disk-modes 2 00000000\n",
                                         "#!/bin/sh\n",
                                         "cor-disk-modes 11 00000000\n",
                                         "n,l,omega,C,S\n"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        refused(others[i], strlen(others[i]), COR_ERROR_FILE_VERSION, 1, others[i]);
    start(0, 0);
    add_line("cor-disk-modes 2");
    refused(text.bytes, text.length, COR_ERROR_FILE_VERSION, 1, "version 2 in good order");
    static const char damaged[] = "cor-disk-modes 1 00000000\n";
    refused(damaged, strlen(damaged), COR_ERROR_FILE_DAMAGED, 1, "version 1 with a wrong check");
}

/* Lines that the program never writes, but with correct checks, are refused. */
TEST(harmed_lines)
{
    static const struct {
        int after; /* number of good lines before the harmed one */
        const char *line[14];
    } harmed[] = {
        {0, {"cor-disk-modes 1 x"}},
        {2,
         {"poisson 0x1p+0 1", "poisson -0x1p+0 -1", "poisson 0x1.8p+1 3", "poisson 0.33 0.33", "poisson 0x1.5p-2",
          "poisson nan 0", "poisson 0x1p+1024 0", "poisson  0x1p-2 0", "poisson 0x2p-3 0", "poisson 0x1.p-2",
          "poisson 0x1p-1023 0", "poisson 0x1.00000000000001p-2 0.25", "poisson 0x0p+1 0"}},
        {3,
         {"modes 0", "modes -1", "modes 18446744073709551616", "modes 18446744073709551617", "modes 1 ", "modes 1x",
          "modes 0x1", "modes "}},
        {4,
         {"mode 2 0 0x1p+0 0x1p+0 0x1p+0", "mode 2 0 0x1p+0", "modes 2 0", "2 0", "mode 0 0 0x1p+1 0x1p+0 0x0p+0",
          "mode 0 0 -0x1p+1 0x1p+0 0x0p+0", "mode -2 0 0x1p+0 0x1", "mode 2147483648 0",
          "mode 0 0 0x0p+0 0x0p+0 0x0p+0",
          /* lines that resemble a mode line: wrong S for n = 0, trailing space, wrong word */
          "mode 0 0 0x1p+1 0x1.279a74590331cp+0 0x1p+0", "mode 0 0 0x1p+1 0x1.279a74590331cp+0 0x0p+0 ",
          "modes 0 0 0x1p+1 0x1.279a74590331cp+0 0x0p+0", " 0 0 0x1p+1 0x1.279a74590331cp+0 0x0p+0"}}};
    const struct cor_disk_mode *const m = cor_disk_modes_nu033.mode;
    for (size_t i = 0; i < COUNT_OF(harmed); i++)
        for (size_t k = 0; harmed[i].line[k] != NULL; k++) {
            start(harmed[i].after, 1);
            add_line("%s", harmed[i].line[k]);
            add_line("end");
            text_refused((size_t)harmed[i].after + 1, harmed[i].line[k]);
        }
    start(4, 1);
    add_mode(m);
    add_line("end x");
    text_refused(FIRST_MODE_LINE + 1, "after the end");
    struct cor_disk_mode high = {COR_DISK_MODES_MAX_N, 0, 3, 1.5, 0}; /* obeys (26) for any n */
    struct cor_disk_modes read;
    write_modes(1, &high, 1);
    put_file(text.bytes, text.length);
    assert_int_equal(cor_disk_modes_read(path, room, CAPACITY, &read, NULL), COR_OK);
    assert_int_equal(read.mode[0].n, COR_DISK_MODES_MAX_N);
    high.n++;
    write_modes(1, &high, 1);
    text_refused(FIRST_MODE_LINE, "n is too large");
    const struct {
        const char *what;
        size_t promised, count;
        struct cor_disk_mode mode[2];
    } lists[] = {{"out of order", 2, 2, {m[1], m[0]}},
                 {"twice", 2, 2, {m[0], m[0]}},
                 {"too many", 1, 2, {m[0], m[1]}},
                 {"too few", 2, 1, {m[0]}}};
    for (size_t i = 0; i < COUNT_OF(lists); i++) {
        write_modes(lists[i].promised, lists[i].mode, lists[i].count);
        text_refused(FIRST_MODE_LINE + 1, lists[i].what);
    }
    EACH (wrong, 1 + 1e-10, -1, 0) /* a number that violates (26) */
        for (int k = 0; k < 3; k++) {
            struct cor_disk_mode harmed_mode = m[k];
            harmed_mode.c *= *wrong;
            write_modes(1, &harmed_mode, 1);
            if (*wrong != -1 || harmed_mode.n > 0) /* the sign is free for n = 0 */
                text_refused(FIRST_MODE_LINE, "C is wrong");
        }
}

TEST(no_file)
{
    struct cor_disk_modes modes = {7, 7, NULL};
    size_t line = 77;
    assert_int_equal(cor_disk_modes_read("no such directory/no such file", room, CAPACITY, &modes, &line),
                     COR_ERROR_FILE);
    assert_int_equal(line, 0);
    assert_int_equal(cor_disk_modes_read(".", room, CAPACITY, &modes, &line), COR_ERROR_FILE);
    assert_int_equal(cor_disk_modes_read(NULL, room, CAPACITY, &modes, &line), COR_ERROR_NULL);
    assert_int_equal(cor_disk_modes_read(path, room, CAPACITY, NULL, &line), COR_ERROR_NULL);
    assert_int_equal(cor_disk_modes_read(path, NULL, 1, &modes, &line), COR_ERROR_NULL);
    assert_true(modes.nu == 7 && modes.count == 7 && modes.mode == NULL);
}

static int lowest_descriptor(void)
{
    const int descriptor = dup(STDIN_FILENO);
    close(descriptor);
    return descriptor;
}

static int first_descriptor;

/* No file remains open after the tests above, most of which end in a refusal. */
TEST(files_are_closed)
{
    assert_int_equal(lowest_descriptor(), first_descriptor);
}

static int begin(void **none)
{
    (void)none;
    const int descriptor = mkstemp(path);
    if (descriptor < 0 || close(descriptor))
        return 1;
    first_descriptor = lowest_descriptor();
    return 0;
}

static int end(void **none)
{
    (void)none;
    return remove(path);
}

GROUP(begin, end)
