/* SPDX-License-Identifier: MIT */
/* What an operation costs in a loop, ns: where the weights in gen/embed/form.c come from (docs/embed.md, "Costs").
 * CMakeLists.txt builds it for REAL = double and float, with INTEGER of its size, once for numbers one after the other
 * and once with VECTORS and the flags of loops that become vectors.
 *
 * A cost is the time of a loop with many such operations less that of a loop with half as many, by the difference in
 * number, and without the operations that come with it. The least of many turns, as in bench.c. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "methods.h"
#include "support/timing.h"

#ifdef VECTORS
#define BETWEEN ((void)0)
#else
#define BETWEEN ONE_BY_ONE
#endif

enum { N = 2048, ROWS = 16, COLUMNS = 16 };

/* Not static: what is done with them might matter to somebody. */
extern REAL in[N], out[N], table[ROWS][COLUMNS];
extern INTEGER limit[COLUMNS];
REAL in[N], out[N], table[ROWS][COLUMNS];
INTEGER limit[COLUMNS];

#define TWO(S, K) S(K) S((K) + 1)
#define FOUR(S, K) TWO(S, K) TWO(S, (K) + 2)
#define EIGHT(S, K) FOUR(S, K) FOUR(S, (K) + 4)
#define SIXTEEN(S, K) EIGHT(S, K) EIGHT(S, (K) + 8)

/* y out of x, and z; and u, the bits of x, which BITS makes y of */
#define LOOP(NAME, BODY, END)                                                                                          \
    static void NAME(void *closure)                                                                                    \
    {                                                                                                                  \
        (void)closure;                                                                                                 \
        for (int i = 0; i < N; i++) {                                                                                  \
            const REAL x = in[i];                                                                                      \
            BETWEEN;                                                                                                   \
            INTEGER u;                                                                                                 \
            REAL y = x, z = x;                                                                                         \
            memcpy(&u, &x, sizeof u);                                                                                  \
            (void)z;                                                                                                   \
            BODY END out[i] = y;                                                                                       \
        }                                                                                                              \
    }
#define PAIR(NAME, LESS, MORE, STEP, END) LOOP(NAME##_less, LESS(STEP, 0), END) LOOP(NAME##_more, MORE(STEP, 0), END)
#define NOTHING
#define BITS memcpy(&y, &u, sizeof y);

/* two at a time, as numerator and denominator are */
#define MUL_ADD(K) y = (REAL)(0.5 + 0.125 * (K)) + x * y, z = (REAL)(0.75 - 0.125 * (K)) + x * z;
#define MUL(K) y *= x;
#define ADD(K) y += x;
#define DIV(K) y = x / y;
#define SQRT(K) y = sizeof y == sizeof(float) ? (REAL)sqrtf((float)y) : (REAL)sqrt((double)y);
#define BIT(K) u = limit[K] - (u >> 1);
#define LOAD(K) y += table[u & (ROWS - 1)][K];
#define CONVERT(K) y = x + (REAL)(int)y;
#define COMPARE(K) u = (K) % 2 ? (u > limit[K] ? u : limit[K]) : (u < limit[K] ? u : limit[K]);

PAIR(mul_add, FOUR, EIGHT, MUL_ADD, y += z;)
PAIR(mul, FOUR, EIGHT, MUL, NOTHING)
PAIR(add, FOUR, EIGHT, ADD, NOTHING)
PAIR(div, TWO, FOUR, DIV, NOTHING)
PAIR(root, TWO, FOUR, SQRT, NOTHING)
PAIR(bit, EIGHT, SIXTEEN, BIT, BITS)
PAIR(load, FOUR, EIGHT, LOAD, NOTHING)
PAIR(convert, FOUR, EIGHT, CONVERT, NOTHING)
PAIR(compare, FOUR, EIGHT, COMPARE, BITS)

/* `more` has `steps` more than `less`; each is `parts` operations, and additions besides */
static const struct {
    const char *name;
    void (*less)(void *), (*more)(void *);
    int steps, parts, additions;
} operations[] = {
    {"mul+add", mul_add_less, mul_add_more, 4, 2, 0},
    {"mul", mul_less, mul_more, 4, 1, 0},
    {"add", add_less, add_more, 4, 1, 0},
    {"div", div_less, div_more, 2, 1, 0},
    {"sqrt", root_less, root_more, 2, 1, 0},
    {"bits", bit_less, bit_more, 8, 2, 0},
    {"load", load_less, load_more, 4, 1, 1},
    {"convert", convert_less, convert_more, 4, 2, 1},
    {"compare", compare_less, compare_more, 4, 1, 0},
};
enum { OPERATIONS = sizeof operations / sizeof *operations, ADDITION = 2 };

int main(void)
{
    struct job jobs[2 * OPERATIONS];
    for (int i = 0; i < N; i++)
        in[i] = (REAL)(0.5 + 1.0 * i / N);
    for (int i = 0; i < ROWS * COLUMNS; i++)
        table[i / COLUMNS][i % COLUMNS] = (REAL)i;
    for (int i = 0; i < COLUMNS; i++)
        memcpy(&limit[i], &in[64 * i], sizeof limit[i]);
    for (int i = 0; i < OPERATIONS; i++) {
        jobs[2 * i] = (struct job){operations[i].less, NULL, N, 0};
        jobs[2 * i + 1] = (struct job){operations[i].more, NULL, N, 0};
    }
    timing_measure(jobs, 2 * (size_t)OPERATIONS, (struct timing){.sample_ns = 2e5, .rounds = 200, .slow_share = 1});
    double cost[OPERATIONS];
    for (int i = 0; i < OPERATIONS; i++)
        cost[i] = (jobs[2 * i + 1].best_ns - jobs[2 * i].best_ns) / operations[i].steps;
    for (int i = 0; i < OPERATIONS; i++) {
        const double own = (cost[i] - operations[i].additions * cost[ADDITION]) / operations[i].parts;
        printf("%s %.2f%s", operations[i].name, fmax(own, 0), i + 1 < OPERATIONS ? ", " : "\n");
    }
    return 0;
}
