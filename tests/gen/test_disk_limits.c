/* SPDX-License-Identifier: MIT */
/* The file of disk collisions, whole and harmed, and its rows collided again. */
#include "support/flint.h"

#include "check.h"
#include "tables/limits.h"

static char *file_text(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = malloc(1 << 20);
    assert_non_null(text);
    *size = fread(text, 1, (1 << 20) - 1, file);
    text[*size] = '\0';
    fclose(file);
    return text;
}

static const char path[] = "generated/" DISK_LIMITS_ROWS_FILE;

static void test_file(void **state)
{
    (void)state;
    size_t size, written_size = 0;
    char *text = file_text(path, &size), *written = NULL;
    assert_int_equal(disk_limits_read(text, size, path), 0);
    assert_true(disk_limits_known());
    FILE *file = open_memstream(&written, &written_size);
    assert_int_equal(disk_limits_rows_write(file, NULL), 0);
    fclose(file);
    assert_int_equal(written_size, size);
    assert_memory_equal(written, text, size);
    free(written);
    /* bytes of the head, of the first rows, and of the last */
    const size_t value = (size_t)(strstr(text, "\n-0.200,") - text);
    for (size_t i = 0; i < size; i += i < value ? 40 : i < value + 60 ? 3 : i + 50 < size ? size - 45 - i : 3) {
        const char good = text[i];
        text[i] = good == 'x' ? 'y' : 'x';
        assert_int_equal(disk_limits_read(text, size, path), 1);
        assert_false(disk_limits_known());
        text[i] = good;
    }
    assert_int_equal(disk_limits_read(text, size - 1, path), 1);
    assert_int_equal(disk_limits_read(text, size / 2, path), 1);
    assert_int_equal(disk_limits_read("", 0, path), 1);
    text[value] = '\0';
    assert_int_equal(disk_limits_read(text, size, path), 1);
    free(text);
}

/* A header cannot be made of collisions that follow no law; and a sample tells numbers that are no collision's. */
static void test_other_numbers(void **state)
{
    (void)state;
    size_t size, header_size = 0;
    char *text = file_text(path, &size), *header = NULL;
    int rows = 0;
    for (char *end = strstr(text, "\nnu,") + 1; (end = strchr(end + 1, '\n')) != NULL && end[1] != '\0'; rows++) {
        char *const place = strchr(end + 1, '\n') - 3; /* the sixth of eight */
        *place = *place == '9' ? '8' : (char)(*place + 1);
    }
    assert_true(rows > 1000);
    assert_int_equal(disk_limits_read(text, size, path), 0);
    assert_int_equal(disk_limits_check_sample(1), 1);
    char *const first = strchr(strstr(text, "\n-0.200,") + 1, '\n') - 7; /* the second */
    *first = *first == '9' ? '8' : (char)(*first + 1);
    assert_int_equal(disk_limits_read(text, size, path), 0);
    FILE *file = open_memstream(&header, &header_size);
    assert_int_equal(disk_limits_header_write(file, NULL), 1);
    fclose(file);
    free(header);
    free(text);
    disk_limits_clear();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_file),
        cmocka_unit_test(test_other_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
