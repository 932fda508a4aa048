/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include "support/console.h"
#include "support/digits.h"

static int fill_until_decided(struct table *table, const struct proved_table *proved)
{
    struct precision precision = precision_start(proved->digits);
    char undecided[PROVED_TABLE_NAME];
    do {
        table_clear(table);
        undecided[0] = '\0';
        if (proved->fill(table, undecided, proved->arguments, precision.bits) != STATUS_OK)
            return STATUS_FAILED;
        if (undecided[0] == '\0')
            return STATUS_OK;
    } while (precision_raise(&precision));
    return precision_spent(&precision, undecided, proved->digits);
}

int proved_table_write(const struct proved_table *proved, const struct option_common *common)
{
    struct output out;
    if (output_open(&out, common->output) != STATUS_OK)
        return STATUS_FAILED;
    const enum output_format format = (enum output_format)common->format;
    struct table table = {0};
    int status = fill_until_decided(&table, proved);
    profile_step("printing");
    table.json_strings = common->json_strings;
    if (status == STATUS_OK && (format == FORMAT_TEXT || format == FORMAT_LATEX) && proved->print_text)
        proved->print_text(out.file, &table, proved->arguments);
    else if (status == STATUS_OK)
        table_print(&table, format, out.file);
    table_clear(&table);
    return output_finish(&out, status);
}
