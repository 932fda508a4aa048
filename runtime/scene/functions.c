/* SPDX-License-Identifier: MIT */
/* The public functions of scene.h: those of runtime/scene/inside.h, in the default floating-point environment */
#include <fenv.h>

#include "cor/scene.h"
#include "runtime/number/environment.h"

/* On x86-64 printf rounds as the x87 unit does, which cor_environment_enter leaves alone. */
#define FUNCTION(type, name, parameters, arguments)                                                                    \
    type cor_inside_##name parameters;                                                                                 \
    type cor_##name parameters                                                                                         \
    {                                                                                                                  \
        type(*const volatile inside) parameters = cor_inside_##name;                                                   \
        const struct cor_environment caller = cor_environment_enter();                                                 \
        const int direction = fegetround();                                                                            \
        if (direction != FE_TONEAREST)                                                                                 \
            fesetround(FE_TONEAREST);                                                                                  \
        type const volatile result = inside arguments;                                                                 \
        if (direction != FE_TONEAREST)                                                                                 \
            fesetround(direction);                                                                                     \
        cor_environment_leave(&caller);                                                                                \
        return result;                                                                                                 \
    }
#define PROCEDURE(name, parameters, arguments)                                                                         \
    void cor_inside_##name parameters;                                                                                 \
    COR_RUN_IN_ENVIRONMENT(cor_##name, cor_inside_##name, parameters, arguments)
#include "generated/scene_functions.inc"
