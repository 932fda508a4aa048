/* SPDX-License-Identifier: MIT */
/* The mode tables of the library, and the reader of mode files. */
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cor/disk.h"
#include "cor/status.h"
#include "generated/disk_modes_nu033.h"
#include "generated/disk_modes_nu090.h"
#include "runtime/disk/mode_file.h"

const struct cor_disk_modes cor_disk_modes_nu033 = COR_DISK_MODES_NU033;
const struct cor_disk_modes cor_disk_modes_nu090 = COR_DISK_MODES_NU090;

enum {
    LINE_MAX_LENGTH = 256,
    CHECK_DIGITS = 8,
    FRACTION_DIGITS = 13,
    LOWEST_EXPONENT = -1022,
    HIGHEST_EXPONENT = 1023
};

/* Bound on the residual of (26) if all numbers of a mode are rounded to doubles */
static const double normalisation_error = 1e-12;

struct lines {
    FILE *file;
    size_t number; /* number of the line in the file, from 1 */
    uint32_t check;
    char text[LINE_MAX_LENGTH];
    const char *at; /* the unread rest of the line, without its check */
};

static int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* Reads the next line. Returns COR_OK, or a status if the line cannot be read or its check is wrong. */
static int next_line(struct lines *in)
{
    in->number++;
    if (!fgets(in->text, sizeof in->text, in->file))
        return ferror(in->file) ? COR_ERROR_FILE : COR_ERROR_FILE_DAMAGED;
    const size_t length = strlen(in->text);
    if (length < CHECK_DIGITS + 2 || in->text[length - 1] != '\n')
        return COR_ERROR_FILE_DAMAGED;
    char *const check = in->text + length - 1 - CHECK_DIGITS;
    in->check = cor_mode_file_check(in->check, in->text, (size_t)(check - in->text));
    uint32_t written = 0;
    for (int i = 0; i < CHECK_DIGITS; i++) {
        const int digit = hex_digit(check[i]);
        if (digit < 0)
            return COR_ERROR_FILE_DAMAGED;
        written = written << 4 | (uint32_t)digit;
    }
    if (written != in->check || check[-1] != ' ')
        return COR_ERROR_FILE_DAMAGED;
    in->check = cor_mode_file_check(in->check, check, CHECK_DIGITS + 1);
    check[-1] = '\0';
    in->at = in->text;
    return COR_OK;
}

/* Reads the next line, which must begin with `word`, and skips the word. */
static int next_line_of(struct lines *in, const char *word)
{
    const int status = next_line(in);
    const size_t length = strlen(word);
    if (status != COR_OK)
        return status;
    if (strncmp(in->at, word, length) != 0 || (in->at[length] != ' ' && in->at[length] != '\0'))
        return COR_ERROR_FILE_DAMAGED;
    in->at += length;
    return COR_OK;
}

/* Read a number after one space. These functions do not call strtod, whose decimal point depends on the locale. */

static int read_whole(struct lines *in, size_t most, size_t *value)
{
    const char *c = in->at;
    size_t x = 0;
    if (*c++ != ' ' || *c < '0' || *c > '9')
        return 0;
    for (; *c >= '0' && *c <= '9'; c++) {
        if (x > (most - (size_t)(*c - '0')) / 10)
            return 0;
        x = 10 * x + (size_t)(*c - '0');
    }
    in->at = c;
    *value = x;
    return 1;
}

/* Reads a double in the form of C's %a: 0x0p+0, or a normal number [-]0x1[.h...]p(+|-)d... */
static int read_double(struct lines *in, double *value)
{
    const char *c = in->at;
    if (*c++ != ' ')
        return 0;
    const int negative = *c == '-';
    c += negative;
    if (strncmp(c, "0x", 2) != 0 || (c[2] != '0' && c[2] != '1'))
        return 0;
    const uint64_t leading = (uint64_t)(c[2] - '0');
    c += 3;
    uint64_t digits = 0;
    int count = 0;
    if (*c == '.')
        for (c++; hex_digit(*c) >= 0; c++, count++) {
            if (count == FRACTION_DIGITS)
                return 0;
            digits = digits << 4 | (uint64_t)hex_digit(*c);
        }
    if (*c++ != 'p' || (*c != '+' && *c != '-'))
        return 0;
    const int below = *c++ == '-';
    int exponent = 0;
    if (*c < '0' || *c > '9')
        return 0;
    for (; *c >= '0' && *c <= '9'; c++)
        if ((exponent = 10 * exponent + (*c - '0')) > HIGHEST_EXPONENT)
            return 0;
    if (below)
        exponent = -exponent;
    const uint64_t fraction = digits << 4 * (FRACTION_DIGITS - count);
    if (leading ? exponent < LOWEST_EXPONENT : fraction != 0 || exponent != 0)
        return 0;
    const uint64_t biased = leading ? (uint64_t)(exponent - LOWEST_EXPONENT + 1) : 0;
    const uint64_t bits = (uint64_t)negative << 63 | biased << 52 | fraction;
    memcpy(value, &bits, sizeof *value);
    in->at = c;
    return 1;
}

/* True if the numbers obey (26) in closed form, as the numbers of every mode do. */
static int is_mode(const struct cor_disk_mode *m)
{
    const double most = 1e30; /* no mode has such numbers */
    if (!(isgreater(m->omega, 0) && isless(m->omega, most) && isless(fabs(m->c), most) && isless(fabs(m->s), most)))
        return 0;
    const double square = m->omega * m->omega;
    if (m->n == 0)
        return m->s == 0 &&
               fabs(m->c * m->c * (square - 1) - square) <= normalisation_error * square * (1 + m->c * m->c);
    const double c = fabs(m->c), s = m->n * fabs(m->s), radial = m->c + m->n * m->s;
    const double off = square * (m->c * m->c + m->s * m->s - 2) - radial * radial;
    return fabs(off) <= normalisation_error * (square * (m->c * m->c + m->s * m->s + 2) + (c + s) * (c + s));
}

static int read_mode(struct lines *in, struct cor_disk_mode *mode)
{
    const int status = next_line_of(in, "mode");
    if (status != COR_OK)
        return status;
    size_t n, l;
    if (!read_whole(in, COR_DISK_MODES_MAX_N, &n) || !read_whole(in, INT_MAX, &l) || !read_double(in, &mode->omega) ||
        !read_double(in, &mode->c) || !read_double(in, &mode->s) || *in->at != '\0')
        return COR_ERROR_FILE_DAMAGED;
    mode->n = (int)n;
    mode->l = (int)l;
    return is_mode(mode) ? COR_OK : COR_ERROR_FILE_DAMAGED;
}

static int read_header(struct lines *in, struct cor_disk_modes *found)
{
    int status = next_line(in);
    /* the first line distinguishes a file of another kind or version from a damaged file */
    const size_t name = sizeof COR_MODE_FILE_NAME - 1, version = sizeof COR_MODE_FILE_VERSION - 1;
    if (status == COR_ERROR_FILE)
        return status;
    if (strncmp(in->text, COR_MODE_FILE_NAME " ", name + 1) != 0 ||
        strncmp(in->text + name + 1, COR_MODE_FILE_VERSION, version) != 0 || in->text[name + 1 + version] > ' ')
        return COR_ERROR_FILE_VERSION;
    if (status != COR_OK || in->text[name + 1 + version] != '\0')
        return COR_ERROR_FILE_DAMAGED;
    if ((status = next_line_of(in, "source")) != COR_OK || (status = next_line_of(in, "poisson")) != COR_OK)
        return status;
    if (!read_double(in, &found->nu) || !(fabs(found->nu) < 1) || *in->at != ' ')
        return COR_ERROR_FILE_DAMAGED;
    if ((status = next_line_of(in, "modes")) != COR_OK)
        return status;
    return read_whole(in, SIZE_MAX, &found->count) && found->count > 0 && *in->at == '\0' ? COR_OK
                                                                                          : COR_ERROR_FILE_DAMAGED;
}

static int read_all(struct lines *in, struct cor_disk_mode *mode, size_t capacity, struct cor_disk_modes *modes)
{
    struct cor_disk_modes found = {0, 0, mode};
    int status = read_header(in, &found);
    if (status != COR_OK)
        return status;
    if (found.count > capacity) {
        modes->count = found.count;
        return COR_ERROR_CAPACITY;
    }
    for (size_t i = 0; i < found.count; i++) {
        if ((status = read_mode(in, &mode[i])) != COR_OK)
            return status;
        if (i > 0 && !(mode[i].omega > mode[i - 1].omega))
            return COR_ERROR_FILE_DAMAGED;
    }
    if ((status = next_line_of(in, "end")) != COR_OK)
        return status;
    if (*in->at != '\0')
        return COR_ERROR_FILE_DAMAGED;
    in->number++;
    if (fgetc(in->file) != EOF)
        return COR_ERROR_FILE_DAMAGED;
    if (ferror(in->file))
        return COR_ERROR_FILE;
    *modes = found;
    return COR_OK;
}

int cor_disk_modes_read(const char *path, struct cor_disk_mode *mode, size_t capacity, struct cor_disk_modes *modes,
                        size_t *line)
{
    if (line)
        *line = 0;
    if (!path || !modes || (!mode && capacity > 0))
        return COR_ERROR_NULL;
    const int error = errno;
    struct lines in = {fopen(path, "rb"), 0, COR_MODE_FILE_CHECK_START, "", NULL};
    errno = error;
    if (!in.file)
        return COR_ERROR_FILE;
    const int status = read_all(&in, mode, capacity, modes);
    if (line && (status == COR_ERROR_FILE_DAMAGED || status == COR_ERROR_FILE_VERSION))
        *line = in.number;
    fclose(in.file);
    errno = error;
    return status;
}
