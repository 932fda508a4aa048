/* SPDX-License-Identifier: MIT */
/* Writes the bits of the results of every public function. `bits FILE DRAWS` calls each function with DRAWS times 150
 * arguments, and writes a line "FUNCTION BITS" for each result, in hexadecimal. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/unit/public_calls.h"

int main(int argc, char **argv)
{
    static struct arguments a;
    FILE *const file = argc == 3 ? fopen(argv[1], "wb") : NULL;
    if (file == NULL)
        return 2;
    for (size_t f = 0; f < public_function_count; f++) {
        /* each function starts with the same seed, so no arguments depend on other functions */
        struct random_bits random = {{random_bits_next}, random_seeded(36)};
        struct results r = {NULL, 0, 0};
        for (int draw = atoi(argv[2]); draw > 0; draw--) {
            arguments_draw(&a, &random.source, PUBLIC_COUNT, 1);
            public_functions[f].call(&a, &r);
        }
        for (size_t i = 0; i < r.count; i++) {
            uint64_t bits = UINT64_C(0x7ff8000000000000); /* all NaN count as equal */
            if (!isnan(r.value[i]))
                memcpy(&bits, &r.value[i], sizeof bits);
            fprintf(file, "%s %08lx%08lx\n", public_functions[f].name, (unsigned long)(bits >> 32),
                    (unsigned long)(bits & UINT32_MAX));
        }
        results_clear(&r);
    }
    return fclose(file) != 0;
}
