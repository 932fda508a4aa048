/* SPDX-License-Identifier: MIT */
/* corgen tables --check over many directories, of which the costly files are computed once: check_tables DIRECTORY...
 * prints red or green for each. What depends on a directory's own disk_limits.h is made for each. Exit status 1 if
 * any is red. */
#include "tables/directory.c"

int main(int argc, char **argv)
{
    struct content c[CONTENTS] = {{NULL, NULL, 0}};
    const struct tables_request request = {.check = true};
    int n = 0, status = STATUS_OK, reds = 0;
    for (; n < FILES && !files[n].limits && status == STATUS_OK; n++)
        status = generated_make(&c[n], &files[n]);
    for (int i = 1; i < argc && status == STATUS_OK; i++) {
        bool known = false;
        int m = n, verdict = know_limits(&known, &request, argv[i]);
        for (; m < FILES && known && verdict == STATUS_OK; m++)
            verdict = generated_make(&c[m], &files[m]);
        if (verdict == STATUS_OK)
            verdict = manifest_make(&c[m], c, m);
        if (verdict == STATUS_OK)
            verdict = check_all(c, m + 1, argv[i]);
        printf("%s %s\n", verdict == STATUS_OK ? "green" : "red", argv[i]);
        fflush(stdout);
        reds += verdict != STATUS_OK;
        for (int k = n; k <= m && k < CONTENTS; k++) {
            free(c[k].text);
            c[k].text = NULL;
        }
        disk_limits_clear();
    }
    for (int i = 0; i < n; i++)
        free(c[i].text);
    sphere_tables_clear();
    disk_tables_clear();
    return status != STATUS_OK || reds > 0;
}
