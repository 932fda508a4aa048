/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "cor/law.h"
#include "runtime/core/laws.h"

static const char *const laws[COR_LAWS] = {COR_CONTACT_LAWS(COR_LAW_NAME)
                                               COR_SIMULATOR_LAWS(COR_LAW_NAME)[COR_LAW_IMPULSE] = "impulse"};
static const char *const ends[COR_ENDS] = {"zero-overlap", "zero-force", "limited", "approach-only", "instant"};
static const char *const quantities[COR_QUANTITIES] = {
    "eps", "loss", "damping-of-eps", "damping-of-loss", "duration", "max-overlap", "time-of-max-overlap"};

const char *cor_law_name(enum cor_law law)
{
    return (unsigned)law < COR_LAWS ? laws[law] : NULL;
}

const char *cor_end_name(enum cor_end end)
{
    return (unsigned)end < COR_ENDS ? ends[end] : NULL;
}

const char *cor_quantity_name(enum cor_quantity quantity)
{
    return (unsigned)quantity < COR_QUANTITIES ? quantities[quantity] : NULL;
}
