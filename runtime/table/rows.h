/* SPDX-License-Identifier: MIT */
/* Placement of the rows of generated/. The library is compiled with COR_ROWS_SHARED and contains them once, in the
 * sources with COR_ROWS_DEFINE. Without COR_ROWS_SHARED every unit that includes them has a copy.
 *
 * COR_ROWS(type, name, rows, columns) begins the definition of the rows of name(i), or is the whole declaration. */
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
