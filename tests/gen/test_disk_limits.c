/* SPDX-License-Identifier: MIT */
/* The table of collisions with a rigid wall, written again, and some of them once more. */
#include "support/flint.h"

#include "check.h"
#include "generated/disk_limits.h"
#include "tables/limits.h"

enum { PIECES = sizeof cor_disk_limit_piece / sizeof *cor_disk_limit_piece, MOST_BYTES = 1 << 22 };

/* The table in memory, written: the bytes of the file, of which corgen keeps the collisions, not the pieces. */
TEST(test_file)
{
    static char text[MOST_BYTES];
    FILE *file = fopen("generated/" DISK_LIMITS_FILE, "rb");
    assert_non_null(file);
    const size_t size = fread(text, 1, sizeof text, file);
    fclose(file);
    char *written = NULL;
    size_t written_size = 0;
    assert_true(disk_limits_known(NULL));
    file = open_memstream(&written, &written_size);
    assert_int_equal(disk_limits_write(file), 0);
    fclose(file);
    assert_int_equal(written_size, size);
    assert_memory_equal(written, text, size);
    free(written);
}

/* A sample tells numbers of a collision from others, 1e-6 apart in 1 - eps^2. */
TEST(test_samples)
{
    static struct cor_disk_limit_piece piece[PIECES];
    memcpy(piece, cor_disk_limit_piece, sizeof piece);
    for (size_t seed = 0; seed < points(6); seed++)
        assert_int_equal(disk_limits_check_sample(seed), 0);
    for (int i = 0; i < PIECES; i++)
        piece[i].coefficient[0] += 10;
    assert_true(disk_limits_known(piece));
    assert_int_equal(disk_limits_check_sample(1), 1);
    disk_limits_clear();
}

RUN_TESTS(test_file, test_samples)
