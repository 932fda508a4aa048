/* SPDX-License-Identifier: MIT */
/* Tests tasks on several threads: each runs once. Also tests tasks within tasks and ordered results. */
#include "support/console.h" /* must precede cmocka.h, which defines a macro fail */

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
    if (i % 10 == 0) /* runs on this thread itself; otherwise the threads would wait for each other */
        parallel_for(inner_task, party, INNER, "inner");
    atomic_fetch_sub(&party->at_once, 1);
}

/* If no thread can start, because memory for its stack is missing, the caller does all tasks. This test comes first,
 * because stacks are reused. */
TEST(test_without_threads)
{
    struct party party = {.inner = 0};
    struct rlimit before = {0, 0}, little;
    unsigned long pages = 0;
    FILE *const statm = fopen("/proc/self/statm", "r");
    if (!statm || fscanf(statm, "%lu", &pages) != 1 || pages > 1 << 24 ||
        getrlimit(RLIMIT_AS, &before) != 0) { /* the shadow memory of a sanitizer */
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

enum { ROWS = 40000, FAILURE = 7 };

static struct crowd {
    slong value[ROWS], next, stop_at; /* the next task to hand back, and the task to stop at */
    slong slow, long_from;            /* a task that takes 300 ms, and the first that takes 10 ms */
    atomic_int begun;                 /* tasks of 10 ms that began */
    int ticks;
} crowd;

static void crowd_work(void *context, slong i)
{
    struct crowd *const c = context;
    if (parallel_threads() > 1 && (i % 997 == 0 || i == c->slow))
        nanosleep(&(struct timespec){0, i == c->slow ? 300000000 : 3000000}, NULL);
    if (i >= c->long_from) {
        c->begun++;
        nanosleep(&(struct timespec){0, 10000000}, NULL);
    }
    c->value[i] = i * i;
}

static int crowd_finish(void *context, slong i)
{
    struct crowd *const c = context;
    check(i == c->next && c->value[i] == i * i, "task %ld", (long)i);
    c->next++;
    return i == c->stop_at ? FAILURE : 0;
}

static void crowd_tick(void *context)
{
    ((struct crowd *)context)->ticks++;
}

/* Every task runs once and in order, with any number of threads, up to the task that stops them */
TEST(test_in_order)
{
    for (int threads = 1; threads <= 3; threads++) {
        static const struct {
            slong count, stop_at, slow, long_from, handed_back;
        } runs[] = {{0, ROWS, ROWS, ROWS, 0},
                    {5, ROWS, ROWS, ROWS, 5},
                    {ROWS, ROWS, 100, ROWS, ROWS},
                    {ROWS, 1234, 100, ROWS, 1235},
                    {ROWS, 999, ROWS, 1000, 1000}}; /* no waiting task starts after the stop */
        parallel_use(threads);
        for (size_t k = 0; k < COUNT_OF(runs); k++) {
            crowd = (struct crowd){.stop_at = runs[k].stop_at, .slow = runs[k].slow, .long_from = runs[k].long_from};
            assert_int_equal(parallel_in_order(crowd_work, crowd_finish, crowd_tick, &crowd, runs[k].count),
                             runs[k].stop_at < ROWS ? FAILURE : 0);
            assert_int_equal(crowd.next, runs[k].handed_back);
            check(crowd.begun < 30 * threads, "%d tasks of %d threads began", crowd.begun, threads);
            check(crowd.ticks > 0 || runs[k].count < ROWS || runs[k].slow == ROWS, "no tick of %d threads", threads);
        }
    }
    parallel_use(0);
}
