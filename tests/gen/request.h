/* SPDX-License-Identifier: MIT */
/* Requests to corgen embed and corgen plan, made from lists of numbers: GIVEN({COR_SCENE_RADIUS, "5e-3"}, ...). */
#ifndef COR_TESTS_GEN_REQUEST_H
#define COR_TESTS_GEN_REQUEST_H

#include "embed/request.h"

struct given {
    int number;
    const char *value;
};
#define GIVEN(...) ((const struct given[]){__VA_ARGS__, {-1, NULL}})

static inline void request_give(struct embed_request *request, const struct given *given)
{
    for (; given->number >= 0; given++)
        decimal_set(&request->number[given->number], given->value);
}

static inline struct embed_request request_of(const char *min, const char *max, const char *tolerance, int end,
                                              const struct given *given)
{
    struct embed_request request = {.end = end};
    request_give(&request, GIVEN({EMBED_SPEED_MIN, min}, {EMBED_SPEED_MAX, max}, {EMBED_TOLERANCE, tolerance}));
    request_give(&request, given);
    return request;
}

static inline void request_clear(struct embed_request *request)
{
    for (int i = 0; i < EMBED_NUMBERS; i++)
        decimal_clear(&request->number[i]);
}

#endif
