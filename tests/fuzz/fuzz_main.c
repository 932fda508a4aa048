/* SPDX-License-Identifier: MIT */
/* A fuzz target without libFuzzer, for any compiler: every input of a corpus, and copies of them with a few random
 * changes.
 *
 *     fuzz_TARGET CORPUS COPIES LAST
 *
 * CORPUS: a text with one input per line, as tests/fuzz/run packs them, after a first line that is ignored. COPIES:
 * number of copies of each. LAST: a file with the current input, which remains if the input ends the program.
 * COR_SEED=<number> repeats a run. */
#define _XOPEN_SOURCE 700
#include <fcntl.h>
#include <unistd.h>

#include "../unit/random.h"
#include "fuzz.h"

enum { LINE_MAX_LENGTH = 1 << 16, INPUT_MAX = 4096, CHANGES_MAX = 4, SECONDS_MAX = 20 };

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);
__attribute__((weak)) size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed);
__attribute__((weak)) int LLVMFuzzerInitialize(int *argc, char ***argv);

static struct random_state state;

static size_t any_below(size_t n)
{
    return random_below(&state, n);
}

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size)
{
    for (size_t changes = any_below(CHANGES_MAX) + 1; changes > 0 && size > 0; changes--) {
        const size_t at = any_below(size);
        switch (any_below(5)) {
        case 0:
            data[at] ^= (uint8_t)(1 << any_below(8));
            break;
        case 1:
            data[at] = (uint8_t)any_below(256);
            break;
        case 2: /* copies another byte of the input */
            data[at] = data[any_below(size)];
            break;
        case 3:
            memmove(data + at, data + at + 1, --size - at);
            break;
        default:
            if (size < max_size) {
                memmove(data + at + 1, data + at, size++ - at);
                data[at] = (uint8_t)any_below(256);
            }
        }
    }
    return size;
}

static int file = -1;

static void run(const uint8_t *input, size_t size)
{
    /* the copy has exactly this size, like inputs of libFuzzer */
    uint8_t *const copy = exactly(size);
    memcpy(copy, input, size);
    if (pwrite(file, input, size, 0) != (ssize_t)size || ftruncate(file, (off_t)size) != 0)
        abort();
    alarm(SECONDS_MAX);
    LLVMFuzzerTestOneInput(copy, size);
    alarm(0);
    free(copy);
}

/* Converts the escapes \n, \\ and \xHH, with two hexadecimal digits H, to bytes. Returns the size. */
static size_t unpack(const char *line, uint8_t *input)
{
    size_t size = 0;
    for (; *line && *line != '\n' && size < INPUT_MAX; size++) {
        unsigned byte = (uint8_t)*line++;
        if (byte == '\\') {
            if (sscanf(line, "x%2x", &byte) == 1)
                line += 2;
            else
                byte = *line == 'n' ? '\n' : '\\';
            line++;
        }
        input[size] = (uint8_t)byte;
    }
    return size;
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fprintf(stderr, "usage: %s CORPUS COPIES LAST\n", argv[0]);
        return 2;
    }
    const char *const seed = getenv("COR_SEED");
    state = random_seeded(seed ? strtoull(seed, NULL, 0) : 19990101);
    const unsigned long copies = strtoul(argv[2], NULL, 10);
    FILE *const corpus = fopen(argv[1], "r");
    file = open(argv[3], O_RDWR | O_CREAT | O_TRUNC, 0666);
    if (!corpus || file < 0) {
        fprintf(stderr, "%s: cannot open %s and %s\n", argv[0], argv[1], argv[3]);
        return 2;
    }
    if (LLVMFuzzerInitialize)
        LLVMFuzzerInitialize(&argc, &argv);
    static char line[LINE_MAX_LENGTH];
    static uint8_t input[INPUT_MAX], changed[INPUT_MAX];
    size_t inputs = 0;
    fgets(line, sizeof line, corpus); /* the licence */
    for (; fgets(line, sizeof line, corpus); inputs++) {
        const size_t size = unpack(line, input);
        run(input, size);
        for (unsigned long i = 0; i < copies; i++) {
            memcpy(changed, input, size);
            const size_t now = LLVMFuzzerCustomMutator
                                   ? LLVMFuzzerCustomMutator(changed, size, INPUT_MAX, (unsigned)any_below(1u << 30))
                                   : LLVMFuzzerMutate(changed, size, INPUT_MAX);
            run(changed, now);
        }
    }
    fclose(corpus);
    close(file);
    printf("%zu inputs, %lu copies of each\n", inputs, copies);
    return inputs > 0 ? 0 : 1;
}
