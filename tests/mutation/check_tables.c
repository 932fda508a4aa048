/* SPDX-License-Identifier: MIT */
/* corgen tables --check over many directories, of which all files are computed once: check_tables DIRECTORY... prints
 * red or green for each. Exit status 1 if any is red. */
#include "tables/directory.c"

int main(int argc, char **argv)
{
    struct content c[CONTENTS] = {{NULL, NULL, 0}};
    const struct tables_request request = {.check = true};
    int n = 0, reds = 0;
    const int status = make_generated(c, &n, &request, DEFAULT_DIRECTORY);
    for (int i = 1; i < argc && status == STATUS_OK; i++) {
        const int verdict = check_all(c, n, argv[i]);
        printf("%s %s\n", verdict == STATUS_OK ? "green" : "red", argv[i]);
        fflush(stdout);
        reds += verdict != STATUS_OK;
    }
    for (int i = 0; i < n; i++)
        free(c[i].text);
    sphere_tables_clear();
    return status != STATUS_OK || reds > 0;
}
