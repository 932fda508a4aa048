/* SPDX-License-Identifier: MIT */
#include "disk/modes_rounded.h"

#include <stdlib.h>

#include "disk/modes.h"
#include "support/console.h"
#include "support/decimal.h"
#include "support/digits.h"
#include "support/local.h"

enum { MODE_DIGITS = 17 /* digits_to_double needs no more */ };

static int round_all(struct cor_disk_mode *mode, const struct disk_modes *exact)
{
    for (slong i = 0; i < exact->count; i++) {
        const struct disk_mode *const m = &exact->mode[i];
        mode[i] = (struct cor_disk_mode){(int)m->n, (int)m->l, 0, 0, 0};
        if (!digits_to_double(&mode[i].omega, m->omega) || !digits_to_double(&mode[i].c, m->c) ||
            !(arb_is_zero(m->s) || digits_to_double(&mode[i].s, m->s)))
            return fail("mode %ld is too near to the middle of two doubles", (long)i);
    }
    return STATUS_OK;
}

int disk_modes_rounded(struct cor_disk_modes *modes, const fmpq_t nu, slong count)
{
    LOCAL_INIT(disk_modes, exact, (&exact));
    int status = disk_modes_solve(&exact, nu, count, MODE_DIGITS);
    if (status == STATUS_OK) {
        struct cor_disk_mode *const mode = xmalloc((size_t)count * sizeof *mode);
        *modes = (struct cor_disk_modes){decimal_nearest(nu), (size_t)count, mode};
        status = round_all(mode, &exact);
        if (status != STATUS_OK)
            free(mode);
    }
    return status;
}
