/* SPDX-License-Identifier: MIT */
#include "methods.h"

#include <stdio.h>
#include <stdlib.h>

#if !(defined __GNUC__ && (defined __AVX__ || defined __SSE2__))
volatile float methods_zero = 0;
#endif

void methods_add(struct methods *methods, const struct method *method)
{
    if (methods->n == METHODS_MAX) {
        fprintf(stderr, "bench: more methods than methods.h has rows for\n");
        exit(1);
    }
    methods->row[methods->n++] = *method;
}
