/* SPDX-License-Identifier: MIT */
/* Names that a function of a C header cannot have. */
#ifndef COR_GEN_SUPPORT_C_NAMES_H
#define COR_GEN_SUPPORT_C_NAMES_H

/* What an identifier is already, "a keyword of C or C++", in C99 to C23, in C++11 to C++23, or in the headers math.h,
 * stdint.h and string.h with the extensions of GNU; NULL if it is free. Functions of the other headers of C count, too,
 * because compilers know them without their headers. */
const char *c_name_taken(const char *name);

#endif
