/* SPDX-License-Identifier: MIT */
/* Writes the table of collisions with a rigid wall again, and computes some of the collisions again. */
#include "tables/limits.c" /* defines the cells; must precede cmocka.h, which defines a macro fail */

#include "check.h"

enum { PIECES = sizeof cor_disk_limit_piece / sizeof *cor_disk_limit_piece, MOST_BYTES = 1 << 22 };

/* Writing the table in memory again gives the bytes of the file. corgen contains only collisions, not the pieces. */
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

/* A sample of collisions accepts the stored table and detects a change of 1e-6 in 1 - eps^2. */
TEST(test_samples)
{
    leave_to_turn(1, 2);
    static struct cor_disk_limit_piece piece[PIECES];
    memcpy(piece, cor_disk_limit_piece, sizeof piece);
    for (size_t seed = 0; seed < points(6); seed++)
        assert_int_equal(disk_limits_check_sample(seed), 0);
    for (int i = 0; i < PIECES; i++)
        piece[i].coefficient[0] += 10;
    assert_true(disk_limits_known(piece));
    assert_int_equal(disk_limits_check_sample(1), 1);
}

/* The 16 values of the cell come from a polynomial of degree 3. At most one of the 9 collisions between them is off, by
 * 200 units. Uncertainty: sqrt((1.5 200)^2 + (largest estimate)^2) + 1. */
TEST(test_uncertainty)
{
    struct cell cell = {.x = ROOT_SIDE, .nu = 2 * ROOT_SIDE, .depth = 1};
    for (int off = -1; off < 9; off++) {
        struct scenes scenes = {0};
        int between = 0;
        for (int j = 0; j <= SIXTHS; j++)
            for (int i = j % 2; i <= SIXTHS; i += 2) {
                const int32_t value = 1000 + i * i * i - 20 * i * j + 3 * i * j * j * j;
                const bool wrong = j % 2 && between++ == off;
                add_scene(&scenes, (struct scene){cell.x + i * sixth_of(&cell), cell.nu + j * sixth_of(&cell),
                                                  value + (wrong ? 200 : 0), wrong ? 400 : 100});
            }
        fill_cell(&cell, &scenes);
        assert_int_equal(cell.uncertainty, off < 0 ? 101 : 501);
        assert_int_equal(cell.value[POINTS - 1], 1000 + 216 - 720 + 3 * 1296);
        free(scenes.scene);
    }
}
