/* SPDX-License-Identifier: MIT */
/* The contacts of LAMMPS: pair styles granular and gran/..., walls */
#include <math.h>
#include <string.h>

#include "runtime/scene/audit.h"

/* The rows of cor_simulator_models; a model without a row for limit_damping is the one without it, but for its end. */
static const char *model_of(int hertz, const char *damping, int *limited)
{
    static const struct {
        int hertz;
        const char *damping, *model, *with_limit;
    } models[] = {
        {0, "velocity", "granular hooke, damping velocity", "granular hooke, damping velocity, limit_damping"},
        {0, "mass_velocity", "granular hooke, damping mass_velocity; gran/hooke",
         "granular hooke, damping mass_velocity, limit_damping"},
        {0, "viscoelastic", "granular hooke, damping viscoelastic (the default)", NULL},
        {0, "tsuji", "granular hooke, damping tsuji, releases to July 2026", NULL},
        {1, "viscoelastic", "granular hertz, damping viscoelastic (the default); gran/hertz/history",
         "granular hertz, damping viscoelastic, limit_damping"},
        {1, "velocity", "granular hertz, damping velocity", NULL},
        {1, "mass_velocity", "granular hertz, damping mass_velocity", NULL},
        {1, "tsuji", "granular hertz, damping tsuji, releases to July 2026",
         "granular hertz, damping tsuji, limit_damping, releases to July 2026"},
        {0, "coeff_restitution", "granular hertz or hooke, damping coeff_restitution",
         "granular hertz or hooke, damping coeff_restitution, limit_damping"},
        {1, "coeff_restitution", "granular hertz or hooke, damping coeff_restitution",
         "granular hertz or hooke, damping coeff_restitution, limit_damping"}};
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        if (models[i].hertz != hertz || !audit_is(models[i].damping, damping))
            continue;
        if (!*limited || !models[i].with_limit)
            return models[i].model;
        *limited = 0;
        return models[i].with_limit;
    }
    return NULL;
}

/* The normal force and its damping, of which the first word is w->word[at]: hertz K_N ETA tangential ... */
static struct audit_contact *read_granular(struct audit *a, const struct audit_words *w, int at)
{
    static const struct {
        const char *name;
        int hertz, material;
        const char *fault;
    } forces[] = {
        {"hooke", 0, 0, NULL},
        {"hertz", 1, 0, NULL},
        {"hertz/material", 1, 1, NULL},
        {"dmt", 1, 1,
         "The pull of DMT adhesion makes eps depend on the speed; without it the damping alone would count."},
        {"jkr", 1, 1,
         "LAMMPS parts bodies at the largest pull of JKR's force: they stick below 0.703 of the speed of JKR's theory, "
         "and lose half its energy. The damping takes more."}};
    const char *const name = audit_word(w, at);
    size_t force = 0;
    while (force < sizeof forces / sizeof *forces && !audit_is(forces[force].name, name))
        force++;
    if (force == sizeof forces / sizeof *forces) {
        audit_remark(a, "cor does not know the normal force", name);
        return NULL;
    }
    const int key = audit_find(w, at, "damping");
    const char *const damping = key < 0 ? "viscoelastic" : audit_word(w, key + 1);
    int limited = audit_find(w, at, "limit_damping") >= 0;
    const double stiffness = audit_number_at(w, at + 1), number = audit_number_at(w, at + 2),
                 poisson = audit_number_at(w, at + 3);
    const int none = audit_is(damping, "none");
    const char *const model = model_of(forces[force].hertz, none ? "velocity" : damping, &limited);
    if (!model) {
        audit_remark(a, "cor does not know damping", damping);
        return NULL;
    }
    if (isnan(stiffness) || isnan(number) || (forces[force].material && isnan(poisson))) {
        audit_remark(a, "the numbers of the normal force are missing or no numbers", NULL);
        return NULL;
    }
    struct audit_contact *const contact = audit_add(a, audit_joined(a, w, 0));
    contact->model = model;
    contact->limited = limited;
    contact->number = none ? 0 : number;
    contact->word[0] = at + 2;
    contact->spring = forces[force].hertz ? AUDIT_HERTZ : AUDIT_HOOKE;
    contact->stiffness = forces[force].material ? 2.0 / 3 * stiffness / (1 - poisson * poisson) : stiffness;
    contact->harmonic = forces[force].material;
    contact->fault = forces[force].fault ? forces[force].fault
                     : key < 0           ? "Without the word damping LAMMPS takes viscoelastic."
                                         : NULL;
    contact->unknown = forces[force].fault != NULL;
    return contact;
}

/* hooke, hooke/history or hertz/history, and K_n K_t gamma_n gamma_t mu damp from w->word[at] on */
static struct audit_contact *read_old(struct audit *a, const struct audit_words *w, const char *style, int at)
{
    const int hertz = audit_starts(style, "hertz");
    int limited = audit_find(w, at, "limit_damping") >= 0;
    const double stiffness = audit_number_at(w, at), number = audit_number_at(w, at + 2);
    if (isnan(stiffness) || isnan(number)) {
        audit_remark(a, "K_n and gamma_n are missing or no numbers", NULL);
        return NULL;
    }
    struct audit_contact *const contact = audit_add(a, audit_joined(a, w, 0));
    contact->model = model_of(hertz, hertz ? "viscoelastic" : "mass_velocity", &limited);
    contact->limited = limited;
    contact->number = number;
    contact->spring = hertz ? AUDIT_HERTZ : AUDIT_HOOKE;
    contact->stiffness = stiffness;
    return contact;
}

static void all_types(struct audit_contact *contact)
{
    for (int k = 0; contact && k < 2; k++) {
        contact->first[k] = 0;
        contact->last[k] = AUDIT_TYPES - 1;
    }
}

static void read_pair_style(struct audit *a, const struct audit_words *w)
{
    int known = 0;
    for (int i = 1; i < w->count; i++) {
        const char *const style = w->word[i];
        if (audit_is(style, "granular")) {
            known = 1;
        } else if (audit_starts(style, "gran/hooke") || audit_starts(style, "gran/hertz")) {
            all_types(read_old(a, w, style + strlen("gran/"), i + 1));
            known = 1;
        }
    }
    if (!known && !audit_is(audit_word(w, 1), "none") && !audit_is(audit_word(w, 1), "zero"))
        audit_remark(a, "this is no granular contact that cor knows:", audit_word(w, 1));
}

static void read_pair_coeff(struct audit *a, const struct audit_words *w)
{
    const int hybrid = audit_is(audit_word(w, 3), "granular");
    int first[2], last[2];
    if (w->count < 4 + hybrid || audit_starts(audit_word(w, 3), "gran/"))
        return; /* all is said by pair_style */
    if (!audit_range(audit_word(w, 1), &first[0], &last[0]) || !audit_range(audit_word(w, 2), &first[1], &last[1])) {
        audit_remark(a, "the types are no numbers", NULL);
        return;
    }
    struct audit_contact *const contact = read_granular(a, w, 3 + hybrid);
    for (int k = 0; contact && k < 2; k++) {
        contact->first[k] = first[k];
        contact->last[k] = last[k];
    }
}

void audit_lammps_pair(struct audit *a, const struct audit_words *w)
{
    if (audit_is(audit_word(w, 0), "pair_style"))
        read_pair_style(a, w);
    else
        read_pair_coeff(a, w);
}

void audit_lammps_wall(struct audit *a, const struct audit_words *w)
{
    const char *const style = audit_word(w, 4);
    struct audit_contact *contact = NULL;
    if (audit_is(style, "granular"))
        contact = read_granular(a, w, 5);
    else if (audit_starts(style, "hooke") || audit_starts(style, "hertz"))
        contact = read_old(a, w, style, 5);
    else
        audit_remark(a, "cor does not know the wall", style);
    all_types(contact);
    if (contact) {
        contact->wall = 1;
        contact->last[1] = 0;
    }
}

/* ---- types without a line of their own ---- */

static const struct audit_contact *pair_contact(const struct audit *a, int i, int j)
{
    for (int n = a->contacts - 1; n >= 0; n--) {
        const struct audit_contact *const c = &a->contact[n];
        if (!c->wall && ((c->first[0] <= i && i <= c->last[0] && c->first[1] <= j && j <= c->last[1]) ||
                         (c->first[0] <= j && j <= c->last[0] && c->first[1] <= i && i <= c->last[1])))
            return c;
    }
    return NULL;
}

/* LAMMPS mixes the lines of i and i and of j and j: e and eta by their geometric mean. */
void audit_lammps_mix(struct audit *a)
{
    for (int i = 0; i < a->types; i++)
        for (int j = i + 1; j < a->types; j++) {
            const struct audit_contact *const one = pair_contact(a, i, i), *const two = pair_contact(a, j, j);
            if (!one || !two || pair_contact(a, i, j) || !one->model || one->model != two->model)
                continue;
            const struct audit_contact first = *one, second = *two;
            struct audit_contact *const mixed = audit_add(a, "");
            const char *const text = mixed->text;
            *mixed = second;
            mixed->text = text;
            mixed->word[0] = -1;
            mixed->first[0] = mixed->last[0] = i;
            mixed->first[1] = mixed->last[1] = j;
            mixed->number = sqrt(first.number * second.number);
            mixed->stiffness = first.harmonic ? 2 / (1 / first.stiffness + 1 / second.stiffness)
                                              : sqrt(first.stiffness * second.stiffness);
            mixed->fault = "No line for this pair: LAMMPS takes the geometric mean of both types.";
        }
}
