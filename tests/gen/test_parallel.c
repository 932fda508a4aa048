/* SPDX-License-Identifier: MIT */
/* Tasks on several threads: each once, never more at a time than there are threads, and tasks within tasks. */
#include "support/console.h" /* before cmocka, which has a macro fail */

#include <stdatomic.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "support/parallel.h"

enum { TASKS = 400, INNER = 7 };

struct party {
    atomic_int runs[TASKS], inner;
    atomic_int at_once, most_at_once;
};

static void enter(struct party *party)
{
    const int now = atomic_fetch_add(&party->at_once, 1) + 1;
    int most = atomic_load(&party->most_at_once);
    while (now > most && !atomic_compare_exchange_weak(&party->most_at_once, &most, now))
        continue;
    const struct timespec nap = {0, 100000};
    nanosleep(&nap, NULL);
}

static void inner_task(void *context, slong i)
{
    struct party *const party = context;
    check(i >= 0 && i < INNER, "%ld", (long)i);
    atomic_fetch_add(&party->inner, 1);
}

static void outer_task(void *context, slong i)
{
    struct party *const party = context;
    enter(party);
    atomic_fetch_add(&party->runs[i], 1);
    if (i % 10 == 0) /* done by this thread itself, or the threads would wait for one another */
        parallel_for(inner_task, party, INNER, "inner");
    atomic_fetch_sub(&party->at_once, 1);
}

TEST(test_tasks)
{
    for (int threads = 1; threads <= 5; threads++) {
        static struct party party;
        memset(&party, 0, sizeof party);
        parallel_use(threads);
        assert_int_equal(parallel_threads(), threads);
        parallel_for(outer_task, &party, TASKS, "outer");
        parallel_for(outer_task, &party, 0, "none");
        for (int i = 0; i < TASKS; i++)
            assert_int_equal(party.runs[i], 1);
        assert_int_equal(party.inner, TASKS / 10 * INNER);
        check(party.most_at_once <= threads && (threads == 1 || party.most_at_once > 1), "%d at once of %d threads",
              party.most_at_once, threads);
    }
    parallel_use(0);
    assert_in_range(parallel_threads(), 1, PARALLEL_MAX_THREADS);
}

/* Where no thread can be had, for want of memory for its stack, the caller does all tasks. The first test, because
 * stacks are used again. */
TEST(test_without_threads)
{
    struct party party = {.inner = 0};
    struct rlimit before = {0, 0}, little;
    unsigned long pages = 0;
    FILE *const statm = fopen("/proc/self/statm", "r");
    if (!statm || fscanf(statm, "%lu", &pages) != 1 || pages > 1 << 24 ||
        getrlimit(RLIMIT_AS, &before) != 0) { /* a sanitizer's shadow */
        if (statm)
            fclose(statm);
        skip();
    }
    fclose(statm);
    little = before;
    little.rlim_cur = (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE) + (1 << 20);
    parallel_use(4);
    alarm(20);
    assert_int_equal(setrlimit(RLIMIT_AS, &little), 0);
    parallel_for(outer_task, &party, TASKS, "tasks");
    assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
    alarm(0);
    for (int i = 0; i < TASKS; i++)
        assert_int_equal(atomic_load(&party.runs[i]), 1);
    assert_int_equal(atomic_load(&party.most_at_once), 1);
}

RUN_TESTS(test_without_threads, test_tasks)
