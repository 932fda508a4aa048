/* SPDX-License-Identifier: MIT */
/* One table of the contact models of simulators (hosts); docs/laws.md explains it. For each model it holds the damping
 * law, the end of contact, the restitution that the model realises for the e that a user sets, and the number to set
 * for a desired restitution.
 *
 * A model's damping is the parameter of its law in law.h and sphere.h: zeta of the linear dashpot and of Tsuji's
 * damping, beta of the others. These functions need no table of the runtime. */
#ifndef COR_GEN_HOSTS_HOSTS_H
#define COR_GEN_HOSTS_HOSTS_H

#include <stddef.h>

/* Force K x^a + C x^b x': (1, 0), (3/2, 1/4), (1, 1/2), (3/2, 0), (3/2, 1/2), b = a */
enum host_law {
    HOST_LINEAR,
    HOST_TSUJI,
    HOST_LINEAR_ROOT,
    HOST_HERTZ_DASHPOT,
    HOST_SPHERE,
    HOST_HUNT_CROSSLEY,
    HOST_IMPULSE, /* no force: the host sets the rebound speed to e times the impact speed */
    HOST_LAWS
};

enum host_end { HOST_ZERO_OVERLAP, HOST_ZERO_FORCE, HOST_LIMITED, HOST_APPROACH_ONLY, HOST_INSTANT, HOST_ENDS };

/* Two bodies in contact, in SI units */
struct host_scene {
    double mass_kg;   /* effective mass */
    double stiffness; /* K of the elastic force K x^a, N/m^a */
    double radius_m;  /* effective radius */
    double speed_m_s; /* impact speed */
};

typedef double host_map(double x);
typedef double host_scene_map(double x, const struct host_scene *scene);

struct host_model {
    const char *host;      /* "lammps" */
    const char *model;     /* its name in the host's input or documentation */
    const char *parameter; /* the number that the user sets, with its unit; "e" for a restitution coefficient */
    enum host_law law;
    enum host_end end;

    /* The damping that the host computes from e, for least <= e <= most; NULL if the user does not set e. */
    host_map *damping_of_e;
    double least, most;

    /* The number that the user sets from the damping, and back; NULL if the user sets e. */
    host_scene_map *number_of_damping, *damping_of_number;

    const char *file;   /* the host's file that computes it */
    const char *known;  /* "run", "source" or "documentation" */
    const char *advice; /* a sentence for the user */

    /* The version of the host that was run or read, and lines for its input; NULL: none. `paste` starts with the
     * opening of a comment in the language of the host and a bar. Words in braces are numbers (contact_host.c). */
    const char *version, *paste;
};

extern const struct host_model host_models[];
extern const size_t host_model_count;

const char *host_law_name(enum host_law law);
const char *host_end_name(enum host_end end);

/* The restitution of a law for an end of contact, and its inverse, for the laws with closed forms: linear, Tsuji, Hunt
 * and Crossley, an impulse. NaN for the other laws. */
double host_eps(enum host_law law, enum host_end end, double damping);
double host_damping(enum host_law law, enum host_end end, double eps);

/* The restitution that the model realises if a user sets e; NaN if the model has no e or refuses this one. */
double host_realised(const struct host_model *model, double e);

/* The e' that a user must set so that the model realises `wished` */
enum host_cure_status {
    HOST_CURE_OK,
    HOST_CURE_NOT_ASKED, /* the model has no e, or its law has no closed form */
    HOST_CURE_TOO_SMALL, /* the model's smallest e realises more than `wished` */
    HOST_CURE_TOO_LARGE  /* the model's largest e realises less than `wished` */
};
double host_cure(const struct host_model *model, double wished, enum host_cure_status *status);

/* The smallest and the largest restitution that the model can realise by its e */
void host_reach(const struct host_model *model, double *least, double *most);

/* ---- published formulas ---- */

/* Thornton, Cummins and Cleary, Powder Technol. 233, 30 (2013): damping 2 gamma sqrt(m k_tangent), fitted to zero
 * force */
double host_thornton_gamma(double e);
/* The polynomial of Tsuji, Tanaka and Ishida, Powder Technol. 71, 239 (1992), in the form of LAMMPS */
double host_tsuji_alpha(double e);
/* d g as a function of e: Hunt and Crossley (1975); Lankarani and Nikravesh (1990); Gonthier et al. (2004); Herbert and
 * McWhannell (1977); Hu and Guo (2015); Flores et al. (2011) */
double host_crossley_hunt(double e);
double host_crossley_lankarani(double e);
double host_crossley_gonthier(double e);
double host_crossley_herbert(double e);
double host_crossley_hu(double e);
double host_crossley_flores(double e);

/* Drake's hunt_crossley_dissipation of a pair of bodies with stiffnesses k1, k2 and dissipations d1, d2:
 * (k2 d1 + k1 d2)/(k1 + k2), that of the softer body if the other is rigid */
double host_drake_pair_dissipation(double k1, double d1, double k2, double d2);

#endif
