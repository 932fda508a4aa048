/* SPDX-License-Identifier: MIT */
/* The table of collisions with a rigid wall, written again, and some of them once more. */
#include "support/flint.h"

#include "check.h"
#include "generated/disk_limits.h"
#include "tables/limits.h"

enum { CELLS = sizeof cor_disk_limit_cell / sizeof *cor_disk_limit_cell, MOST_BYTES = 1 << 22 };

/* The table in memory, written: the bytes of the file, also where its sides are joined anew. */
TEST(test_file)
{
    static char text[MOST_BYTES];
    struct cor_disk_limit_cell cell[CELLS];
    FILE *file = fopen("generated/" DISK_LIMITS_FILE, "rb");
    assert_non_null(file);
    const size_t size = fread(text, 1, sizeof text, file);
    fclose(file);
    memcpy(cell, cor_disk_limit_cell, sizeof cell);
    for (int i = 0; i < CELLS; i++)
        cell[i].joined = 0;
    for (int anew = 0; anew < 2; anew++) {
        char *written = NULL;
        size_t written_size = 0;
        assert_true(disk_limits_known(anew ? cell : NULL));
        file = open_memstream(&written, &written_size);
        assert_int_equal(disk_limits_write(file), 0);
        fclose(file);
        assert_int_equal(written_size, size);
        assert_memory_equal(written, text, size);
        free(written);
    }
}

/* A sample tells numbers of a collision from others, 1e-6 apart in 1 - eps^2. */
TEST(test_samples)
{
    struct cor_disk_limit_cell cell[CELLS];
    memcpy(cell, cor_disk_limit_cell, sizeof cell);
    for (size_t seed = 0; seed < points(1); seed++)
        assert_int_equal(disk_limits_check_sample(seed), 0);
    for (int i = 0; i < CELLS; i++)
        for (int k = 0; k < COR_DISK_LIMIT_POINTS; k++)
            cell[i].value[k] += 10;
    assert_true(disk_limits_known(cell));
    assert_int_equal(disk_limits_check_sample(1), 1);
    disk_limits_clear();
}

RUN_TESTS(test_file, test_samples)
