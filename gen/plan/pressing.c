/* SPDX-License-Identifier: MIT */
#include "plan/pressing.h"

#include <math.h>
#include <stdlib.h>

#include "support/console.h"

enum { SCAN = 200, BISECTIONS = 30 };

struct scan {
    const struct cor_scene_contact *pressed;
    struct cor_scene_contact free;
    int end;
    double tolerance;
};

/* Whether the force changes eps by less than the tolerance; a collision that cannot be solved counts as changed. */
static bool may_go(const struct scan *s, double speed)
{
    double with, without;
    return cor_scene_eps(&with, s->pressed, speed, s->end) == COR_FAULT_NONE &&
           cor_scene_eps(&without, &s->free, speed, s->end) == COR_FAULT_NONE &&
           fabs(with / without - 1) <= s->tolerance;
}

char *plan_pressing_remark(const struct cor_scene_contact *contact, int end, double speed_min, double speed_max,
                           double tolerance)
{
    struct scan s = {contact, *contact, end, tolerance};
    const double ratio = pow(speed_min / speed_max, 1.0 / (double)SCAN);
    const double sticking = cor_scene_sticking_speed(contact, end);
    char *where;
    int k = 0;
    s.free.force_n = 0;
    while (k <= SCAN && may_go(&s, speed_max * pow(ratio, k)))
        k++;
    if (k == 0) {
        where = xprintf("at no speed of this range up to its end");
    } else if (k > SCAN) {
        where = xprintf("at every speed of this range");
    } else {
        double low = speed_max * pow(ratio, k), high = low / ratio;
        for (int i = 0; i < BISECTIONS; i++) {
            const double middle = sqrt(low * high);
            *(may_go(&s, middle) ? &high : &low) = middle;
        }
        where = xprintf("from %.4g m/s up", high);
    }
    char *text = xprintf("The constant force of %.4g N may be left out %s: eps then changes by less than %g.\n"
                         "With it the bodies stick up to %.4g m/s. The models leave it out.\n",
                         contact->force_n, where, tolerance, sticking);
    free(where);
    return text;
}
