/* SPDX-License-Identifier: MIT */
/* The subcommands of corgen, one file each, and the arguments of each. */
#ifndef COR_GEN_CLI_COMMANDS_H
#define COR_GEN_CLI_COMMANDS_H

#include "approximation/pade.h"
#include "cli/options.h"
#include "embed/request.h"
#include "plan/plan.h"
#include "sweep/sweep.h"
#include "tables/files.h"

struct trajectory_arguments {
    struct option_common common;
    slong order, terms;
    struct option_law law;
};

struct series_arguments {
    struct option_common common;
    slong order, digits;
    enum cor_end end;
    bool exact;
    struct option_law law;
};

struct pade_arguments {
    struct option_common common;
    struct pade_request request; /* without `kind` and `law`; a degree that is not given is OPTIONS_NOT_GIVEN */
    slong digits;
    bool two_point, as_published, force;
    const char *header; /* file of the C header, or NULL */
    struct option_law law;
};

struct collide_arguments {
    struct option_common common;
    struct decimal beta, stiffness, effective_mass, damping_coefficient, speed; /* either `beta` or the other four */
    struct decimal force;                                                       /* text NULL: no force */
    bool threshold;
    int end; /* enum cor_end; OPTIONS_NOT_GIVEN: both */
    slong digits;
    struct option_law law;
};

struct law_arguments {
    struct option_common common;
    struct option_law law;
    const char *name;
};

struct disk_modes_arguments {
    struct option_common common;
    struct decimal poisson;
    slong count, digits;
};

struct disk_collide_arguments {
    struct option_common common;
    struct sweep_request request; /* `tolerance`, `format` and `output` are not set */
    struct decimal tolerance;
    const char *part; /* "I/N"; NULL: not given */
    slong join;       /* 0: not given */
};

struct embed_arguments {
    struct option_common common;
    struct embed_request scene;
};

struct plan_arguments {
    struct option_common common;
    struct embed_request scene; /* for disks: the range of speeds, the tolerance and Poisson's ratio only */
    slong points;               /* 0 if not given */
    bool disks;
    enum plan_quantity quantity;
};

struct contact_arguments {
    struct option_common common;
    struct embed_request scene;
    struct values speed, angle, tangential_speed;
    struct decimal steps, time_step, step_tolerance, friction, tangential, tangential_stiffness, tangential_damping;
    struct decimal erp, cfm;
    int integrator; /* enum cor_integrator; OPTIONS_NOT_GIVEN: the integrator of the simulator */
    bool step_corrected, walton;
    const char *simulator, *plot, *model; /* NULL: not given */
    const char *version;                  /* version of the simulator; NULL: any */
    const char *materials, *pairs;        /* files of several materials; NULL: two bodies */
};

struct sample_arguments {
    struct option_common common;
    struct embed_request scene;
    bool log, cubic, duration;
};

struct tables_arguments {
    struct option_common common;
    struct tables_request request; /* `directory` is not set */
};

extern const struct subcommand command_trajectory, command_series, command_pade, command_collide, command_disk_modes,
    command_disk_collide, command_embed, command_law, command_plan, command_tables, command_contact, command_sample;

#endif
