/* SPDX-License-Identifier: MIT */
#include "report.h"

#include "support/table.h"

void report_open(struct report *report, const char *directory)
{
    static const char heading[] = "scene,curve,setting,instructions,end,form,ns,ns_dependent,max_relative_error";
    report->csv[FROM_SPEED] = table_open(directory, "spheres_speed.csv", heading);
    report->csv[FROM_BETA] = table_open(directory, "spheres_beta.csv", heading);
}

void report_close(struct report *report)
{
    table_close(report->csv[FROM_SPEED]);
    table_close(report->csv[FROM_BETA]);
}

void report_row(struct report *report, const struct scene *scene, const struct result *result)
{
    static const char *const end[] = {[ZERO_OVERLAP] = "overlap", [ZERO_FORCE] = "force"};
    const struct method *const m = result->method;
    FILE *const files[2] = {report->csv[m->input], stdout};
    for (int i = 0; i < 2; i++) {
        fprintf(files[i], "%s,%s,%s,%s,%s,%s", scene->name, m->curve, m->setting,
                m->instructions ? m->instructions : "", m->end == NO_END ? "" : end[m->end], result->form);
        table_number(files[i], "%.4g", result->ns);
        table_number(files[i], "%.4g", result->ns_chained);
        /* an eps that is none somewhere in the scene is an error of nan; a copy has no error */
        fprintf(files[i], m->end == NO_END || result->form[0] == 'l' ? ",\n" : ",%.2e\n", result->error);
    }
}
