/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include "support/console.h"
#include "support/digits.h"

int proved_table_write(const struct proved_table *proved, const struct option_common *common)
{
    const enum output_format format = (enum output_format)common->format;
    struct precision precision = precision_start(proved->digits);
    char undecided[PROVED_TABLE_NAME] = "";
    struct table table = {0};
    struct output out;
    if (output_open(&out, common->output) != STATUS_OK)
        return STATUS_FAILED;
    int status;
    do {
        table_clear(&table);
        undecided[0] = '\0';
        status = proved->fill(&table, undecided, proved->arguments, precision.bits);
    } while (status == STATUS_OK && *undecided && precision_raise(&precision));
    if (status == STATUS_OK && *undecided)
        status = precision_spent(&precision, undecided, proved->digits);
    profile_step("printing");
    table.json_strings = common->json_strings;
    if (status == STATUS_OK && (format == FORMAT_TEXT || format == FORMAT_LATEX) && proved->print_text)
        proved->print_text(out.file, &table, proved->arguments);
    else if (status == STATUS_OK)
        table_print(&table, format, out.file);
    table_clear(&table);
    return output_finish(&out, status);
}
