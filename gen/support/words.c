/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* open_memstream */
#include "support/words.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"

enum { LETTERS_FOR_A_SLIP = 3, SLIPS_MOST = 3 };

static size_t least(size_t x, size_t y)
{
    return x < y ? x : y;
}

size_t slips_between(const char *a, const char *b)
{
    size_t slips[WORD_MOST + 1][WORD_MOST + 1]; /* between the first letters of both */
    const size_t m = strlen(a), n = strlen(b);
    for (size_t i = 0; i <= m; i++)
        for (size_t j = 0; j <= n; j++) {
            slips[i][j] = i > 0 ? i : j;
            if (i == 0 || j == 0)
                continue;
            const int x = tolower((unsigned char)a[i - 1]), y = tolower((unsigned char)b[j - 1]);
            slips[i][j] = least(slips[i - 1][j - 1] + (x != y), 1 + least(slips[i - 1][j], slips[i][j - 1]));
            if (i > 1 && j > 1 && x == tolower((unsigned char)b[j - 2]) && y == tolower((unsigned char)a[i - 2]))
                slips[i][j] = least(slips[i][j], slips[i - 2][j - 2] + 1);
        }
    return slips[m][n];
}

/* NULL: none is near */
static const char *nearest_word(const char *word, const char *const *words)
{
    const char *nearest = NULL;
    size_t fewest = SLIPS_MOST + 1;
    for (; strlen(word) <= WORD_MOST && *words; words++) {
        const size_t letters = least(strlen(word), strlen(*words));
        const size_t slips = strlen(*words) <= WORD_MOST ? slips_between(word, *words) : fewest;
        if (slips < fewest && slips * LETTERS_FOR_A_SLIP <= letters) {
            nearest = *words;
            fewest = slips;
        }
    }
    return nearest;
}

int refuse_word(const char *word, const char *const *words, const char *dashes, const char *format, ...)
{
    char *text = NULL;
    size_t size;
    FILE *const file = open_memstream(&text, &size);
    const char *const meant = nearest_word(word, words);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(file, format, arguments);
    va_end(arguments);
    if (meant)
        fprintf(file, " (did you mean %s%s?)", dashes, meant);
    for (const char *before = "; allowed: "; *words; words++, before = ", ")
        fprintf(file, "%s%s%s", before, dashes, *words);
    fclose(file);
    const int status = usage_error("%s", text);
    free(text);
    return status;
}
