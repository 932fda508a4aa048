/* SPDX-License-Identifier: MIT */
/* corgen audit: any text, by the reader that the first byte chooses, or by the one that the text shows. Every include
 * is the text itself. */
#include "fuzz.h"

#include "cor/audit.h"

static struct cor_audit_memory memory;
static struct cor_audit_text whole;

static int open_itself(void *context, struct cor_audit_text *included, const char *name, const char *from)
{
    (void)context;
    (void)name;
    (void)from;
    *included = whole;
    return 0;
}

static void require_finding(void *context, const struct cor_audit_finding *f)
{
    int *const findings = context;
    ++*findings;
    REQUIRE(f->line >= 0 && f->file && f->simulator && f->pair && f->advice && f->instead, "line %ld", f->line);
    REQUIRE(f->model || (*f->advice && isnan(f->realised)), "line %ld", f->line);
    REQUIRE(isnan(f->realised) || (f->realised >= 0 && f->realised <= 1), "eps %a", f->realised);
    REQUIRE(isnan(f->realised) || (!(f->damping < 0) && f->end >= 0 && f->end < COR_ENDS), "damping %a", f->damping);
    REQUIRE(isnan(f->duration_s) || f->duration_s >= 0, "duration %a", f->duration_s);
    REQUIRE(isnan(f->step_scatter) || (f->step_scatter >= 0 && fabs(f->step_bias) < 1e300), "scatter %a",
            f->step_scatter);
    REQUIRE(f->as_asked >= -1 && f->as_asked <= 1, "as asked %d", f->as_asked);
}

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    static const double speed = 0.5;
    size_t simulators = 0;
    int findings = 0;
    if (size == 0)
        return 0;
    while (cor_audit_simulators[simulators])
        simulators++;
    const size_t choice = input[0] % (simulators + 1);
    whole = (struct cor_audit_text){"input", (const char *)input + 1, size - 1};
    const struct cor_audit_options options = {.simulator = cor_audit_simulators[choice], /* NULL: the last */
                                              .speed_m_s = &speed,
                                              .speeds = size % 2,
                                              .radius_m = size % 3 ? 0.01 : (double)NAN,
                                              .density_kg_m3 = 2500,
                                              .time_step_s = (double)NAN,
                                              .tolerance = 1e-5, /* no search for a time step, which takes long */
                                              .open = open_itself,
                                              .report = require_finding,
                                              .context = &findings};
    const int status = cor_audit(&memory, &whole, &options);
    REQUIRE(status >= COR_AUDIT_AS_ASKED && status <= COR_AUDIT_UNKNOWN, "status %d", status);
    REQUIRE(status != COR_AUDIT_AS_ASKED || findings > 0, "no finding");
    return 0;
}
