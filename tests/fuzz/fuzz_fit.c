/* SPDX-License-Identifier: MIT */
/* corgen fit: the input is a csv file. What the reader accepts is fitted, by a curve that the length of the input
 * chooses. */
#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit/likelihood.h"
#include "support/console.h"

enum { FEW = 40 };

static void require_point(const struct fit_data *data, size_t i)
{
    REQUIRE(data->point[i].speed_m_s > 0 && isfinite(data->point[i].speed_m_s), "speed %a", data->point[i].speed_m_s);
    const double beyond = data->has_sigma ? FIT_MAX_BEYOND * data->point[i].sigma * (1 + 1e-9)
                          : data->bounce  ? FIT_MAX_FLIGHT_RATIO * (1 + 1e-9) - 1
                                          : 0;
    REQUIRE(data->point[i].eps >= -beyond && data->point[i].eps <= 1 + beyond, "eps %a", data->point[i].eps);
    REQUIRE(!data->has_sigma || (data->point[i].sigma > 0 && isfinite(data->point[i].sigma)), "sigma %a",
            data->point[i].sigma);
    REQUIRE(i == 0 || data->point[i - 1].speed_m_s <= data->point[i].speed_m_s, "speed %a is not sorted",
            data->point[i].speed_m_s);
}

static void require_estimate(const struct fit_estimate *e)
{
    REQUIRE(e->rms >= 0 && isfinite(e->rms), "rms %a", e->rms);
    REQUIRE(isnan(e->p_value) || (e->p_value >= 0 && e->p_value <= 1), "p %a", e->p_value);
    for (int j = 0; j < e->parameters; j++)
        for (int level = 0; level < LEVELS; level++)
            REQUIRE(e->interval[j][level].low <= e->theta[j] && e->theta[j] <= e->interval[j][level].high,
                    "curve %d: %a, %a, %a", (int)e->curve, e->interval[j][level].low, e->theta[j],
                    e->interval[j][level].high);
}

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    FILE *const shown = stderr, *const file = fmemopen((void *)(uintptr_t)input, size, "r");
    if (!file) /* where no text of size 0 can be opened */
        return 0;
    stderr = fopen("/dev/null", "w");
    struct fit_data data;
    const int status = fit_data_parse(&data, file, "input", &FIT_FORM_DEFAULT);
    fclose(stderr);
    stderr = shown;
    fclose(file);
    REQUIRE(status == STATUS_OK || status == STATUS_USAGE, "status %d", status);
    if (status != STATUS_OK)
        return 0;
    for (size_t i = 0; i < data.points; i++)
        require_point(&data, i);
    if (data.points <= FEW) {
        struct fit_estimate e;
        fit_estimate_curve(&e, (enum fit_curve)(size % FIT_CURVES), &data, size & 1);
        if (e.fitted)
            require_estimate(&e);
    }
    fit_data_clear(&data);
    return 0;
}
