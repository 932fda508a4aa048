/* SPDX-License-Identifier: MIT */
/* Words of a command line that are not known, and names that a function of a C header cannot have */
#ifndef COR_GEN_SUPPORT_WORDS_H
#define COR_GEN_SUPPORT_WORDS_H

#include <stddef.h>

/* The number of letters that are left out, put in, exchanged, or swapped with their neighbour, between two words of at
 * most WORD_MOST letters; capitals count as small letters. */
enum { WORD_MOST = 63 };
size_t slips_between(const char *a, const char *b);

/* A usage error about a word that is none of `words`, a list that ends with NULL: the message, the word that was meant,
 * if few slips of the keyboard lead from it to the given one, and all words, each behind `dashes`. Returns
 * STATUS_USAGE. */
int refuse_word(const char *word, const char *const *words, const char *dashes, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* What an identifier is already, "a keyword of C or C++", in C99 to C23, in C++11 to C++23, or in the headers math.h,
 * stdint.h and string.h with the extensions of GNU; NULL if it is free. Functions of the other headers of C count, too,
 * because compilers know them without their headers. */
const char *c_name_taken(const char *name);

#endif
