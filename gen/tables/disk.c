/* SPDX-License-Identifier: MIT */
#include "tables/files.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "runtime/disk/mode_file.h"
#include "support/console.h"
#include "support/digits.h"
#include "support/local.h"

enum {
    TABLE_DIGITS = 25 /* digits in the comments */,
    LINE_LENGTH = 512,
    NU_NAME = 128,
    LEAST_NU_DIGITS = 3,
    VALUES = 3,
    CHECK_LENGTH = 9 /* including the end of the line */
};

/* Writes nu as part of a name: 033 for 0.33, 090 for 0.9, m050 for -0.5, 1_3 for 1/3. */
static void nu_name(char name[NU_NAME], const char *poisson)
{
    size_t n = 0, digits = 0;
    for (const char *c = poisson; *c && n + LEAST_NU_DIGITS + 1 < NU_NAME; c++) {
        if (*c == '-' || *c == '/')
            name[n++] = *c == '-' ? 'm' : '_';
        else if (isalnum((unsigned char)*c))
            name[n++] = (char)tolower((unsigned char)*c);
        digits += isdigit((unsigned char)*c) != 0;
    }
    if (!strpbrk(poisson, "eE/"))
        for (; digits < LEAST_NU_DIGITS; digits++)
            name[n++] = '0';
    name[n] = '\0';
}

const char *disk_table_name(char name[DISK_TABLE_NAME], const struct disk_table *table, const char *extension)
{
    char nu[NU_NAME];
    nu_name(nu, table->poisson.text);
    snprintf(name, DISK_TABLE_NAME, "disk_modes_nu%s.%s", nu, extension);
    return name;
}

/* Writes the command that reproduces the file. */
static void command_text(char text[LINE_LENGTH], const struct disk_table *table)
{
    if (table->embed)
        snprintf(text, LINE_LENGTH, "corgen tables --poisson %s --modes %ld", table->poisson.text, (long)table->count);
    else
        snprintf(text, LINE_LENGTH, "corgen tables");
}

int disk_table_solve(struct disk_table *table)
{
    return disk_modes_solve(&table->modes, table->poisson.value, table->count, TABLE_DIGITS);
}

static const char banner_format[] =
    "The %ld lowest free modes of an elastic disk, Poisson's ratio nu = %s in plane stress, E = rho = R = 1:\n"
    "{n, l, omega, C, S} by increasing omega, as struct cor_disk_mode of cor/disk.h, without gaps (proved).\n"
    "\n"
    "    static const struct cor_disk_modes modes = COR_DISK_MODES_NU%s;\n"
    "\n"
    "omega: frequency, a root of (25) of Gerl and Zippelius (1999); C = u_r(1), S = u_phi(1): (28), normalised by "
    "(26);\n"
    "docs/theory-disks.md, 11. Each double is the one nearest to the exact value (proved)%s.\n"
    "\n"
    "Written by:  %s\n"
    "Checked by:  %s --check\n";

int disk_header_write(FILE *file, const struct disk_table *table)
{
    char nu[NU_NAME] = "", upper[NU_NAME] = "", guard[NU_NAME + 32], name[NU_NAME + 32], command[LINE_LENGTH];
    char banner[sizeof banner_format + 4 * LINE_LENGTH];
    nu_name(nu, table->poisson.text);
    nu_name(upper, table->poisson.text);
    for (char *c = upper; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    snprintf(guard, sizeof guard, "COR_DISK_MODES_NU%s_H", upper);
    snprintf(name, sizeof name, "cor_disk_mode_rows_nu%s", nu);
    command_text(command, table);
    snprintf(banner, sizeof banner, banner_format, (long)table->count, table->poisson.text, upper,
             table->embed ? ", in 17 digits" : "; corgen tables --digits prints 25 digits", command, command);
    struct emit e;
    emit_open(&e, file, guard, banner);
    e.decimal = table->embed;
    fprintf(file, "\n#include %s\n\n", table->embed ? "<cor/disk.h>" : "\"cor/disk.h\"");
    emit_structs_open(&e, "cor_disk_mode", name, table->count);
    LOCAL_VECTOR(value, VALUES);
    int status = STATUS_OK;
    for (slong i = 0; i < table->count && status == STATUS_OK; i++) {
        const struct disk_mode *const m = &table->modes.mode[i];
        progress("rows of the header", i, table->count);
        arb_set(value, m->omega);
        arb_set(value + 1, m->c);
        arb_set(value + 2, m->s);
        status = emit_struct(&e, (const slong[]){m->n, m->l}, 2, value, VALUES);
    }
    progress_end();
    emit_structs_close(&e);
    fprintf(file, "\n#define COR_DISK_MODES_NU%s {%.17g, %ld, %s}\n", upper, decimal_value(&table->poisson),
            (long)table->count, name);
    emit_close(&e);
    return status;
}

/* ---- the file to load, docs/disks.md ---- */

struct lines {
    FILE *file;
    uint32_t check;
};

/* Writes a line that ends with the checksum of all text up to it. The format must end with a space. */
__attribute__((format(printf, 2, 3))) static void put_line(struct lines *out, const char *format, ...)
{
    char text[LINE_LENGTH];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    out->check = cor_mode_file_check(out->check, text, strlen(text));
    char check[CHECK_LENGTH + 1];
    snprintf(check, sizeof check, "%08" PRIx32 "\n", out->check);
    out->check = cor_mode_file_check(out->check, check, CHECK_LENGTH);
    fprintf(out->file, "%s%s", text, check);
}

int disk_file_write(FILE *file, const struct disk_table *table)
{
    char command[LINE_LENGTH];
    command_text(command, table);
    struct lines out = {file, COR_MODE_FILE_CHECK_START};
    put_line(&out, COR_MODE_FILE_NAME " " COR_MODE_FILE_VERSION " ");
    put_line(&out, "source %s ", command);
    put_line(&out, "poisson %a %s ", decimal_value(&table->poisson), table->poisson.text);
    put_line(&out, "modes %ld ", (long)table->count);
    int status = STATUS_OK;
    for (slong i = 0; i < table->count && status == STATUS_OK; i++) {
        const struct disk_mode *const m = &table->modes.mode[i];
        double omega = 0, c = 0, s = 0;
        progress("rows of the mode file", i, table->count);
        if (!digits_to_double(&omega, m->omega) || !digits_to_double(&c, m->c) || !digits_to_double(&s, m->s))
            status = fail("cannot round mode %ld: its enclosure is too wide", (long)i);
        put_line(&out, "mode %ld %ld %a %a %a ", (long)m->n, (long)m->l, omega, c, s);
    }
    progress_end();
    put_line(&out, "end ");
    return status;
}
