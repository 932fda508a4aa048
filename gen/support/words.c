/* SPDX-License-Identifier: MIT */

#include <ctype.h>
#include <stdarg.h>
#include <stdbool.h>
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

/* ---- names of C ---- */

/* clang-format off */
static const char keywords[] =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class"
    " compl concept const const_cast consteval constexpr constinit continue co_await co_return co_yield decltype"
    " default delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline int"
    " long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register"
    " reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct switch"
    " template this thread_local throw true try typedef typeid typename typeof typeof_unqual union unsigned using"
    " virtual void volatile wchar_t while xor xor_eq ";

/* Names of real functions, which may end in f, l, f32, f64x, ... */
static const char real_functions[] =
    " acos acosh acospi asin asinh asinpi atan atan2 atan2pi atanh atanpi cabs cacos cacosh canonicalize carg casin"
    " casinh catan catanh cbrt ccos ccosh ceil cexp cimag clog clog10 compoundn conj copysign cos cosh cospi cpow"
    " cproj creal csin csinh csqrt ctan ctanh dadd ddiv dfma dmul drem dsqrt dsub erf erfc exp exp10 exp10m1 exp2"
    " exp2m1 expm1 fabs fadd fdim fdiv ffma finite floor fma fmax fmaximum fmaximum_mag fmaximum_mag_num fmaximum_num"
    " fmin fminimum fminimum_mag fminimum_mag_num fminimum_num fmod fmul frexp fromfp fromfpx fsqrt fsub gamma"
    " getpayload hypot ilogb isinf isnan j0 j1 jn ldexp lgamma lgamma_r llogb llrint llround log log10 log10p1 log1p"
    " log2 log2p1 logb logp1 lrint lround modf nan nearbyint nextafter nextdown nexttoward nextup pow pow10 pown powr"
    " remainder remquo rint rootn round roundeven rsqrt scalb scalbln scalbn setpayload setpayloadsig significand sin"
    " sincos sinh sinpi sqrt tan tanh tanpi tgamma trunc ufromfp ufromfpx y0 y1 yn ";

static const char library[] =
    " abort abs aligned_alloc alloca asctime assert at_quick_exit atexit atof atoi atol atoll basename bcmp bcopy"
    " be16toh be32toh be64toh bsearch btowc bzero calloc clearerr clock ctime dcgettext dgettext difftime div errno"
    " execl execle execlp execv execve execvp exit explicit_bzero fclose feclearexcept fegetenv fegetexceptflag"
    " fegetround feholdexcept feof feraiseexcept ferror fesetenv fesetexceptflag fesetround fetestexcept feupdateenv"
    " fflush ffs ffsl ffsll fgetc fgetpos fgets fgetwc fgetws fopen fork fpclassify fprintf fprintf_unlocked fputc"
    " fputc_unlocked fputs fputs_unlocked fputwc fputws fread free free_aligned_sized free_sized freopen fscanf fseek"
    " fsetpos ftell fwide fwprintf fwrite fwrite_unlocked fwscanf getc getchar getenv gets gettext getwc getwchar"
    " gmtime htobe16 htobe32 htobe64 htole16 htole32 htole64 i386 imaxabs imaxdiv index kill_dependency labs ldiv"
    " le16toh le32toh le64toh linux llabs lldiv localeconv localtime longjmp main malloc math_errhandling matherr"
    " mblen mbrlen mbrtowc mbsinit mbsrtowcs mbstowcs mbtowc mktime ngettext offsetof perror posix_memalign printf"
    " printf_unlocked putc putc_unlocked putchar putchar_unlocked puts puts_unlocked putwc putwchar qsort quick_exit"
    " raise rand rawmemchr realloc remove rename rewind rindex scanf setbuf setjmp setlocale setvbuf sigabbrev_np"
    " sigdescr_np signal signbit signgam snprintf sprintf srand sscanf stderr stdin stdout stpcpy stpncpy"
    " strerrordesc_np strerrorname_np strfmon swab swprintf swscanf system time timespec_get timespec_getres tmpfile"
    " tmpnam ungetc ungetwc unix va_arg va_copy va_end va_start vfprintf vfscanf vfwprintf vfwscanf vprintf vscanf"
    " vsnprintf vsprintf vsscanf vswprintf vswscanf vwprintf vwscanf wctob wctomb wctrans wctype wmemchr wmemcmp"
    " wmemcpy wmemmove wmemset wprintf wscanf ";
/* clang-format on */

static const char lower[] = "abcdefghijklmnopqrstuvwxyz";

static bool listed(const char *list, const char *name, size_t length)
{
    for (const char *at = list; (at = strchr(at, ' ')) != NULL && at[1]; at++)
        if (strncmp(at + 1, name, length) == 0 && at[1 + length] == ' ')
            return true;
    return false;
}

/* A real function of any type: sqrt, sqrtf, sqrtl, sqrtf64x */
static bool is_real_function(const char *name)
{
    static const char *const suffix[] = {"", "f", "l", "f_r", "l_r", "f16", "f32", "f64", "f128", "f32x", "f64x"};
    const size_t length = strlen(name);
    for (size_t i = 0; i < sizeof suffix / sizeof *suffix; i++) {
        const size_t cut = strlen(suffix[i]);
        if (length > cut && strcmp(name + length - cut, suffix[i]) == 0 && listed(real_functions, name, length - cut))
            return true;
    }
    return false;
}

/* The prefix and a small letter, without _: names that C keeps for its library, such as isalpha, total and strlen. GNU
 * has strtok_r and strcoll_l. */
static bool has_library_prefix(const char *name)
{
    static const char *const prefix[] = {"is", "to", "str", "mem", "wcs"};
    const char *const mark = strchr(name, '_');
    const bool plain = !mark || strcmp(mark, "_l") == 0 || strcmp(mark, "_r") == 0;
    for (size_t i = 0; i < sizeof prefix / sizeof *prefix; i++) {
        const size_t n = strlen(prefix[i]);
        if (plain && strncmp(name, prefix[i], n) == 0 && name[n] && strchr(lower, name[n]))
            return true;
    }
    return false;
}

const char *c_name_taken(const char *name)
{
    const size_t length = strlen(name);
    if (*name == '_' || strstr(name, "__"))
        return "reserved by C or C++ for its underscores";
    if (listed(keywords, name, length))
        return "a keyword of C or C++";
    if (strcmp(name, "posix") == 0 || (strncmp(name, "std", 3) == 0 && !name[3 + strspn(name + 3, "0123456789")]))
        return "a namespace of C++";
    if (!name[strcspn(name, lower)] || strncmp(name, "M_", 2) == 0)
        return "a name of macros, without small letters";
    if (length > 2 && strcmp(name + length - 2, "_t") == 0)
        return "reserved for types, which end in _t";
    if (strncmp(name, "f32", 3) == 0 || strncmp(name, "f64", 3) == 0 || has_library_prefix(name) ||
        listed(library, name, length) || is_real_function(name))
        return "a name of the library of C";
    return NULL;
}
