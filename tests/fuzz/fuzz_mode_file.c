/* SPDX-License-Identifier: MIT */
/* Calls cor_disk_modes_read on arbitrary bytes. Reads an accepted file again by strtod and strtoul. In three of four
 * cases the mutator corrects the checksums at the ends of the lines. */
#define _GNU_SOURCE /* memfd_create */
#include <sys/mman.h>
#include <unistd.h>

#include "../unit/random.h"
#include "cor/disk.h"
#include "cor/status.h"
#include "fuzz.h"
#include "runtime/disk/mode_file.h"

enum { CAPACITY = 64, CHECK = 8, PATH_MAX_LENGTH = 64 };

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed);

/* Corrects the checksums of a file. */
static void mend_checks(char *file, size_t size)
{
    uint32_t check = COR_MODE_FILE_CHECK_START;
    for (size_t at = 0; at < size;) {
        const char *const newline = memchr(file + at, '\n', size - at);
        if (!newline)
            return;
        const size_t end = (size_t)(newline - file);
        if (end - at >= CHECK) {
            char text[CHECK + 1];
            check = cor_mode_file_check(check, file + at, end - CHECK - at);
            snprintf(text, sizeof text, "%08x", (unsigned)check);
            memcpy(file + end - CHECK, text, CHECK);
            check = cor_mode_file_check(check, file + end - CHECK, CHECK + 1);
        } else {
            check = cor_mode_file_check(check, file + at, end + 1 - at);
        }
        at = end + 1;
    }
}

/* Changes up to four characters, or lets libFuzzer mutate. Usually corrects the checksums afterwards. The first byte of
 * the input is not part of the file: it selects the capacity. */
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed)
{
    static const char letters[] = "0123456789abcdef.p+-x ";
    struct random_state random = random_seeded(seed);
    const int mends = random_below(&random, 4) != 0;
    if (random_below(&random, 3) == 0 && size > 1) {
        for (size_t changes = random_below(&random, 4) + 1; changes > 0; changes--)
            data[1 + random_below(&random, size - 1)] = (uint8_t)letters[random_below(&random, sizeof letters - 1)];
    } else {
        size = LLVMFuzzerMutate(data, size, max_size);
    }
    if (mends && size > 1)
        mend_checks((char *)data + 1, size - 1);
    return size;
}

static int read_bytes(const uint8_t *bytes, size_t size, struct cor_disk_mode *mode, size_t capacity,
                      struct cor_disk_modes *modes, size_t *line)
{
    static int file = -1;
    if (file < 0)
        file = memfd_create("modes", 0);
    REQUIRE(file >= 0 && ftruncate(file, 0) == 0 && pwrite(file, bytes, size, 0) == (ssize_t)size, "no memory file");
    char path[PATH_MAX_LENGTH];
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    return cor_disk_modes_read(path, mode, capacity, modes, line);
}

static void check_row(const char *text, const struct cor_disk_mode *mode)
{
    char *at;
    REQUIRE(strncmp(text, "mode ", 5) == 0, "row '%s'", text);
    REQUIRE(strtol(text + 5, &at, 10) == mode->n && strtol(at, &at, 10) == mode->l, "row '%s': %d, %d", text, mode->n,
            mode->l);
    const double omega = strtod(at, &at), c = strtod(at, &at), s = strtod(at, &at);
    REQUIRE(same_number(omega, mode->omega) && same_number(c, mode->c) && same_number(s, mode->s), "row '%s': %a %a %a",
            text, mode->omega, mode->c, mode->s);
    REQUIRE(strlen(at) == CHECK + 1 && *at == ' ', "row '%s'", text);
}

/* Reads the file by strtod and strtoul, line by line; no locale is set here. */
static void check_by_another_route(const uint8_t *bytes, size_t size, const struct cor_disk_modes *modes)
{
    char *const text = exactly(size + 1);
    memcpy(text, bytes, size);
    text[size] = '\0';
    REQUIRE(size > 0 && text[size - 1] == '\n', "accepted without an end");
    uint32_t check = COR_MODE_FILE_CHECK_START;
    size_t lines = 0, rows = 0;
    for (char *line = text, *next; *line; line = next, lines++) {
        next = strchr(line, '\n');
        REQUIRE(next && next - line > CHECK, "line %zu", lines + 1);
        *next = '\0';
        check = cor_mode_file_check(check, line, (size_t)(next - line) - CHECK);
        REQUIRE(strtoul(next - CHECK, NULL, 16) == check, "line %zu: check", lines + 1);
        *next = '\n';
        check = cor_mode_file_check(check, next - CHECK, CHECK + 1);
        *next++ = '\0';
        if (lines == 0)
            REQUIRE(strncmp(line, "cor-disk-modes 1 ", 17) == 0, "'%s'", line);
        if (lines == 2)
            REQUIRE(strncmp(line, "poisson ", 8) == 0 && same_number(strtod(line + 8, NULL), modes->nu), "'%s'", line);
        if (lines == 3)
            REQUIRE(strncmp(line, "modes ", 6) == 0 && strtoull(line + 6, NULL, 10) == modes->count, "'%s'", line);
        if (lines >= 4 && rows < modes->count) {
            check_row(line, &modes->mode[rows]);
            REQUIRE(rows == 0 || modes->mode[rows].omega > modes->mode[rows - 1].omega, "row %zu", rows);
            rows++;
        }
    }
    REQUIRE(lines == modes->count + 5 && rows == modes->count, "%zu lines, %zu modes", lines, modes->count);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    const size_t capacity = *data % (CAPACITY + 1);
    data++;
    size--;
    struct cor_disk_mode *const mode = exactly(capacity * sizeof *mode);
    const struct cor_disk_modes before = {0.125, 77, NULL};
    struct cor_disk_modes modes = before;
    size_t line = SIZE_MAX, lines = 0;
    for (size_t i = 0; i < size; i++)
        lines += data[i] == '\n';
    const int status = read_bytes(data, size, capacity > 0 ? mode : NULL, capacity, &modes, &line);
    switch (status) {
    case COR_OK:
        REQUIRE(line == 0 && modes.mode == mode && modes.count > 0 && modes.count <= capacity, "%zu modes",
                modes.count);
        check_by_another_route(data, size, &modes);
        break;
    case COR_ERROR_CAPACITY:
        REQUIRE(line == 0 && modes.count > capacity && modes.nu == before.nu && !modes.mode, "%zu modes for %zu",
                modes.count, capacity);
        break;
    default:
        REQUIRE(status == COR_ERROR_FILE_VERSION || status == COR_ERROR_FILE_DAMAGED, "status %d", status);
        REQUIRE(line >= 1 && (line <= lines + 1 || line <= size / 255 + lines + 1), "line %zu of %zu", line, lines);
        REQUIRE(modes.nu == before.nu && modes.count == before.count && !modes.mode, "status %d", status);
    }
    free(mode);
    return 0;
}
