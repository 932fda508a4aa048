/* SPDX-License-Identifier: MIT */
/* The table of collisions with a rigid wall, whole and harmed, and some of them once more. */
#include "support/flint.h"

#include "check.h"
#include "tables/limits.h"

enum { MOST_BYTES = 1 << 22 };

static char *file_text(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = malloc(MOST_BYTES);
    assert_non_null(text);
    *size = fread(text, 1, MOST_BYTES - 1, file);
    text[*size] = '\0';
    fclose(file);
    return text;
}

static const char path[] = "generated/" DISK_LIMITS_FILE;

/* Read and written again: the same bytes. */
TEST(test_file)
{
    size_t size, written_size = 0;
    char *text = file_text(path, &size), *written = NULL;
    assert_int_equal(disk_limits_read(text, size, path), 0);
    assert_true(disk_limits_known());
    FILE *file = open_memstream(&written, &written_size);
    assert_int_equal(disk_limits_write(file), 0);
    fclose(file);
    assert_int_equal(written_size, size);
    assert_memory_equal(written, text, size);
    free(written);
    /* bytes of the head, of the nodes, and of the last cells */
    const size_t nodes = (size_t)(strstr(text, "cor_disk_limit_node[") - text);
    for (size_t i = 0; i < size; i += i < nodes ? 40 : i < nodes + 60 ? 3 : i + 50 < size ? size - 45 - i : 3) {
        const char good = text[i];
        text[i] = good == 'x' ? 'y' : 'x';
        assert_int_equal(disk_limits_read(text, size, path), 1);
        assert_false(disk_limits_known());
        text[i] = good;
    }
    assert_int_equal(disk_limits_read(text, size - 1, path), 1);
    assert_int_equal(disk_limits_read(text, size / 2, path), 1);
    assert_int_equal(disk_limits_read("", 0, path), 1);
    /* a node that is another's */
    char *const first = strchr(text + nodes, '{') + 6;
    const char good = *first;
    *first = good == '1' ? '2' : '1';
    assert_int_equal(disk_limits_read(text, size, path), 1);
    *first = good;
    /* another side that is joined: the first cell has one bit less or more */
    char *const joined = strchr(strstr(text, "cor_disk_limit_cell["), ',') + 2;
    *joined ^= 1;
    assert_int_equal(disk_limits_read(text, size, path), 1);
    *joined ^= 1;
    text[nodes] = '\0';
    assert_int_equal(disk_limits_read(text, size, path), 1);
    free(text);
}

/* A tree that is divided more often than any that corgen writes is refused, and not followed (a sanitizer sees it). */
TEST(test_too_deep)
{
    enum { ROOTS = 100, DIVISIONS = 20, NODES = ROOTS + 4 * DIVISIONS, CELLS = NODES - DIVISIONS };
    char *text = NULL;
    size_t size = 0;
    FILE *const file = open_memstream(&text, &size);
    assert_non_null(file);
    fprintf(file,
            "Evaluated by runtime/disk/limits.c.\n *\n * 1\n * Written by:  corgen tables --all, in 1\n"
            "cor_disk_limit_node[%d] = {",
            NODES);
    for (int i = 0, cell = 0, quarter = ROOTS; i < NODES; i++) { /* the first of all, and of every four, is divided */
        const bool divided = quarter < NODES && i == (quarter == ROOTS ? 0 : quarter - 4);
        fprintf(file, "%d, ", divided ? -quarter : cell);
        quarter += divided ? 4 : 0;
        cell += !divided;
    }
    fprintf(file, "};\ncor_disk_limit_cell[%d] = {\n", CELLS);
    for (int i = 0; i < CELLS; i++)
        fprintf(file, "{1, 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},\n");
    fprintf(file, "};\n");
    fclose(file);
    assert_int_equal(disk_limits_read(text, size, path), 1);
    assert_false(disk_limits_known());
    free(text);
}

/* Adds to the second digit from the end of the values of every cell what is 1e-6 or more in 1 - eps^2. */
static int shift_values(char *text)
{
    int cells = 0;
    for (char *at = strstr(text, "cor_disk_limit_cell["); (at = strstr(at, "    {")) != NULL; cells++) {
        char *const end = strstr(at, "}}");
        for (char *value = strchr(at + 5, '{'); value < end; value++)
            if (value[1] == ',' || value[1] == '}') /* its last digit */
                value[-1] = value[-1] == '9' ? '8' : (char)(value[-1] + 1);
        at = end;
    }
    return cells;
}

/* A sample tells numbers of a collision from others. */
TEST(test_samples)
{
    size_t size;
    char *text = file_text(path, &size);
    for (size_t seed = 0; seed < points(1); seed++) {
        assert_int_equal(disk_limits_read(text, size, path), 0);
        assert_int_equal(disk_limits_check_sample(seed), 0);
    }
    assert_true(shift_values(text) > 100);
    assert_int_equal(disk_limits_read(text, size, path), 0);
    assert_int_equal(disk_limits_check_sample(1), 1);
    free(text);
    disk_limits_clear();
}

RUN_TESTS(test_file, test_too_deep, test_samples)
