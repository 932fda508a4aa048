/* SPDX-License-Identifier: MIT */
#include "support/precision.h"

#include "support/console.h"
#include "support/digits.h"

enum { FIRST_STEP = 32 };

struct precision precision_start(slong digits)
{
    const slong bits = digits_to_bits(digits);
    return (struct precision){.bits = bits, .step = FIRST_STEP, .limit = 3 * bits + 512};
}

struct precision precision_doubling(slong bits, int attempts)
{
    /* the step doubles, too: bits + bits, + 2 bits, + 4 bits, ... */
    return (struct precision){.bits = bits, .step = bits, .limit = bits << (attempts - 1)};
}

struct precision precision_doubling_to(slong bits, slong limit)
{
    int attempts = 1;
    while (bits << attempts <= limit)
        attempts++;
    return precision_doubling(bits, attempts);
}

bool precision_raise(struct precision *p)
{
    if (p->bits >= p->limit)
        return false;
    p->bits += p->step;
    p->step *= 2;
    return true;
}

int precision_spent(const struct precision *p, const char *what, slong digits)
{
    return fail("%s: %ld bits do not decide its %ld digits: the number is zero, or halfway between two numbers of that "
                "many digits; then another --digits helps",
                what, (long)p->bits, (long)digits);
}
