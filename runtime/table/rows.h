/* SPDX-License-Identifier: MIT */
/* Linkage of the tables of rows in generated/. With COR_ROWS_SHARED, as in the library, only sources that define
 * COR_ROWS_DEFINE contain them. Otherwise every unit that includes them has a copy.
 *
 * COR_ROWS(type, name, rows, columns) declares the array of the rows name(i). If COR_ROWS_HERE is defined, an
 * initializer follows. */
#ifndef COR_RUNTIME_ROWS_H
#define COR_RUNTIME_ROWS_H

#include "runtime/number/inline.h"

#if defined(__GNUC__) && !defined(_WIN32)
#define COR_ROWS_HIDDEN __attribute__((visibility("hidden")))
#else
#define COR_ROWS_HIDDEN
#endif

#define COR_ROWS_DECLARED(type, name, rows, columns) extern COR_ROWS_HIDDEN const type name##_row[rows][columns]
#if !defined(COR_ROWS_SHARED)
#define COR_ROWS(type, name, rows, columns) static const type name##_row[rows][columns]
#define COR_ROWS_HERE
#elif defined(COR_ROWS_DEFINE)
#define COR_ROWS(type, name, rows, columns)                                                                            \
    COR_ROWS_DECLARED(type, name, rows, columns);                                                                      \
    const type name##_row[rows][columns]
#define COR_ROWS_HERE
#else
#define COR_ROWS(type, name, rows, columns) COR_ROWS_DECLARED(type, name, rows, columns)
#endif

/* Row i, 0 <= i < rows */
#define COR_ROWS_FUNCTION(type, name)                                                                                  \
    COR_INLINE const type *name(int i)                                                                                 \
    {                                                                                                                  \
        return name##_row[i];                                                                                          \
    }

#endif
