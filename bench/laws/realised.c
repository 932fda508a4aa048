/* SPDX-License-Identifier: MIT */
/* What each simulator realises where a user asks for a restitution coefficient e, against what was asked, and the number to give
 * it instead: the table of gen/hosts as csv. Models with the same curve stand in one group, for the figure.
 *     cor_realised > realised.csv */
#include <math.h>
#include <stdio.h>

#include "hosts/hosts.h"

static const double table[] = {0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99};

static void print_number(double x)
{
    if (isnan(x))
        printf(",");
    else
        printf(",%.6f", x);
}

static void print_row(const struct host_model *m, const char *kind, double e)
{
    enum host_cure_status status;
    printf("%s,\"%s: %s\",%s,%g", kind, m->host, m->model, host_end_name(m->end), e);
    print_number(host_realised(m, e));
    print_number(host_cure(m, e, &status));
    printf("\n");
}

int main(void)
{
    printf("kind,model,end,asked,realised,cure\n");
    for (size_t i = 0; i < host_model_count; i++) {
        if (!host_models[i].damping_of_e)
            continue;
        for (size_t k = 0; k < sizeof table / sizeof *table; k++)
            print_row(&host_models[i], "table", table[k]);
        for (int k = 1; k < 100; k++)
            print_row(&host_models[i], "curve", k / 100.0);
    }
    return 0;
}
