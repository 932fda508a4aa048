/* SPDX-License-Identifier: MIT */
/* Mode tables out of fuzzed bytes: cut, with some entries of raw bits, or all. */
#ifndef COR_FUZZ_TABLE_H
#define COR_FUZZ_TABLE_H

#include "cor/disk.h"
#include "fuzz.h"

struct fuzz_table {
    struct cor_disk_modes modes;
    struct cor_disk_mode *mode; /* of exactly modes.count elements */
    int sound;                  /* as the library has it, but for being cut */
};

static inline void fuzz_table_take(struct fuzz_table *table, struct input *in, size_t most)
{
    enum { CORRUPTED_MAX = 6 };
    const uint8_t how = take_byte(in);
    const struct cor_disk_modes *from = how & 1 ? &cor_disk_modes_nu090 : &cor_disk_modes_nu033;
    const size_t count = take_up_to(in, most < from->count ? most : from->count);
    const size_t first = how & 2 ? take_up_to(in, from->count - count) : 0;
    table->modes = *from;
    table->modes.count = count;
    table->modes.mode = table->mode = exactly(count * sizeof *table->mode);
    if (count > 0)
        memcpy(table->mode, from->mode + first, count * sizeof *table->mode);
    table->sound = first == 0;
    if (how & 4 && count > 0) {
        table->sound = 0;
        for (size_t i = take_byte(in) % CORRUPTED_MAX + 1; i > 0; i--) {
            struct cor_disk_mode *mode = &table->mode[take_up_to(in, count - 1)];
            switch (take_byte(in) % 8) {
            case 0:
                mode->n = take_int(in);
                break;
            case 1:
                mode->n = take_byte(in);
                break;
            case 2:
                mode->omega = take_double(in);
                break;
            case 3:
                mode->c = take_double(in);
                break;
            case 4:
                mode->s = take_double(in);
                break;
            case 5:
                table->mode[take_up_to(in, count - 1)] = *mode;
                break;
            default: /* in order, whatever it is */
                mode->n = (int)(take_byte(in) % 200);
                mode->c = take_double(in);
                mode->s = take_double(in);
            }
        }
    }
    if (how & 8) {
        table->sound = 0;
        table->modes.nu = take_double(in);
    }
}

static inline void fuzz_table_clear(struct fuzz_table *table)
{
    free(table->mode);
}

#endif
