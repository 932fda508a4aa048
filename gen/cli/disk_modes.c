/* SPDX-License-Identifier: MIT */
/* corgen disk-modes: the lowest free modes of an elastic disk in proved digits. */
#include "cli/options.h"
#include "disk/modes.h"
#include "support/console.h"
#include "support/digits.h"

/* What one mode takes: three numbers, their texts, and its place in the table. */
static double bytes_needed(double digits)
{
    return 600 + 3 * (digits + digits * 3.33 / 8);
}

int command_disk_modes(const struct options *o)
{
    static const char *const column[] = {"n", "l", "omega", "C", "S"};
    const double needed = (double)o->count * bytes_needed((double)o->digits), memory = console_memory();
    if (memory > 0 && needed > memory)
        return fail("%ld modes to %ld digits need about %.3g GB of memory, and this machine has %.3g GB",
                    (long)o->count, (long)o->digits, needed / 1e9, memory / 1e9);
    struct output out;
    if (output_open(&out, o->output) != STATUS_OK)
        return STATUS_FAILED;

    disk_modes_use_all_processors();
    fmpq_t nu;
    fmpq_init(nu);
    options_fraction(nu, o->real[OPTIONS_POISSON]);
    struct disk_modes modes;
    disk_modes_init(&modes);
    const int status = disk_modes_solve(&modes, nu, o->count, o->digits);
    fmpq_clear(nu);
    if (status != STATUS_OK) {
        output_discard(&out);
        return status;
    }

    profile_step("printing");
    struct table table;
    table_init(&table, column, sizeof column / sizeof *column);
    for (slong i = 0; i < modes.count; i++) {
        const struct disk_mode *mode = &modes.mode[i];
        table_add_integer(&table, mode->n);
        table_add_integer(&table, mode->l);
        table_add(&table, digits_of_ball(mode->omega, o->digits));
        table_add(&table, digits_of_ball(mode->c, o->digits));
        table_add(&table, digits_of_ball(mode->s, o->digits));
    }
    disk_modes_clear(&modes);
    table_print(&table, o->format, out.file);
    table_clear(&table);
    return output_commit(&out);
}
