/* SPDX-License-Identifier: MIT */

#include <ctype.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"

enum { LETTERS_FOR_A_SLIP = 3, SLIPS_MOST = 3 };

static size_t smaller_of(size_t x, size_t y)
{
    return x < y ? x : y;
}

size_t slips_between(const char *a, const char *b)
{
    size_t slips[WORD_MOST + 1][WORD_MOST + 1]; /* [i][j]: distance of i letters of a to j of b */
    const size_t m = strlen(a), n = strlen(b);
    for (size_t i = 0; i <= m; i++)
        for (size_t j = 0; j <= n; j++) {
            slips[i][j] = i > 0 ? i : j;
            if (i == 0 || j == 0)
                continue;
            const int x = tolower((unsigned char)a[i - 1]), y = tolower((unsigned char)b[j - 1]);
            slips[i][j] = smaller_of(slips[i - 1][j - 1] + (x != y), 1 + smaller_of(slips[i - 1][j], slips[i][j - 1]));
            if (i > 1 && j > 1 && x == tolower((unsigned char)b[j - 2]) && y == tolower((unsigned char)a[i - 2]))
                slips[i][j] = smaller_of(slips[i][j], slips[i - 2][j - 2] + 1);
        }
    return slips[m][n];
}

/* Returns the most similar word, or NULL if none is similar. */
static const char *nearest_word(const char *word, const char *const *words)
{
    const char *nearest = NULL;
    size_t fewest = SLIPS_MOST + 1;
    for (; strlen(word) <= WORD_MOST && *words; words++) {
        const size_t letters = smaller_of(strlen(word), strlen(*words));
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

/* ---- names of C ---- */

/* clang-format off */
static const char reserved[] =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class"
    " compl concept const const_cast consteval constexpr constinit continue co_await co_return co_yield decltype"
    " default delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline int"
    " long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register"
    " reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast std struct switch"
    " template this thread_local throw true try typedef typeid typename typeof typeof_unqual union unsigned using"
    " virtual void volatile wchar_t while xor xor_eq ";
/* clang-format on */

bool c_name_is_reserved(const char *name)
{
    const size_t length = strlen(name);
    for (const char *at = reserved; (at = strchr(at, ' ')) != NULL && at[1]; at++)
        if (strncmp(at + 1, name, length) == 0 && at[1 + length] == ' ')
            return true;
    return false;
}
