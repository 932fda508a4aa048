/* SPDX-License-Identifier: MIT */
/* Where pieces of the library meet: the accuracy test looks at every double near these beta. */
#ifndef COR_TESTS_ACCURACY_BOUNDARIES_H
#define COR_TESTS_ACCURACY_BOUNDARIES_H

/* Cells of width 1/16 around i/16, in beta at zero overlap and in sqrt(beta) at zero force; their edges and middles
 * up to these numbers of cells. */
enum { CELLS_IN_BETA = 16 * 16, CELLS_IN_ROOT = 16 * 16 };

/* Edges of regions, ends of the number formats, and where results leave them. Powers of two come on top. */
static const double region_boundaries[] = {
    0x1p-1074, 0x1p-1022, 0x1p-149, 0x1p-126, 7.0, 0x1.fffffep+127, 0x1.fffffffffffffp+1023, 1.39e62, 1.01e65, 7.6e304,
};

#endif
