/* SPDX-License-Identifier: MIT */
#include "approximation/published.h"

#include <stddef.h>

/* The printed numbers y_2 and y_3 are wrong, while (61) is right. (62) also lacks a factor 1/6, which has no effect
 * because x_0''' vanishes at the turning point. C_3, C_4, a_3, a_4 and Table I inherit the error of y_2 and y_3.
 *
 * Table I prints 2.5839, 3.5839 and 2.9839 where the printed a_k give 2.58401, 3.58401 and 2.98401:
 * d_0 is near zero, so the last printed digit of a_3 is worth 2.4e-4 there. */
const struct published published[] = {
    {PUBLISHED_Y, 0, "(59)", "1.093362", "1.09336207394", true},
    {PUBLISHED_Y, 1, "(60)", "-0.504455", "-0.50445489427", true},
    {PUBLISHED_Y, 2, "(61)", "0.260542", "0.28404301890", false},
    {PUBLISHED_Y, 3, "(62)", "-0.136769", "-0.17022077850", false},
    {PUBLISHED_C, 1, "(67)", "-1.153449", "-1.15344885810", true},
    {PUBLISHED_C, 2, "(67)", "0.798267", "0.79826656094", true},
    {PUBLISHED_C, 3, "(34), (67)", "-0.483582", "-0.52288256809", false},
    {PUBLISHED_C, 4, "(34), (67)", "0.285279", "0.34874267526", false},
    {PUBLISHED_A, 1, "(32)", "1", "1", true},
    {PUBLISHED_A, 2, "(32)", "3/5", "3/5", true},
    {PUBLISHED_A, 3, "(33), (70)", "0.315119", "0.3407290271", false},
    {PUBLISHED_A, 4, "(33), (71)", "0.161167", "0.1970206380", false},
    {PUBLISHED_D, 1, "Table I", "2.5839", NULL, false},
    {PUBLISHED_D, 2, "Table I", "3.5839", NULL, false},
    {PUBLISHED_D, 3, "Table I", "2.9839", NULL, false},
    {PUBLISHED_D, 4, "Table I", "1.1487", NULL, false},
    {PUBLISHED_D, 5, "Table I", "0.3265", NULL, false},
    {PUBLISHED_D, 0, NULL, NULL, NULL, false},
};

const char *published_value(enum published_quantity quantity, int index)
{
    for (const struct published *row = published; row->printed; row++)
        if (row->quantity == quantity && row->index == index)
            return row->printed;
    return NULL;
}
