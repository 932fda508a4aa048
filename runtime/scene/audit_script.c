/* SPDX-License-Identifier: MIT */
/* Scripts of LAMMPS and LIGGGHTS: variables, included files, bodies, time step, speeds and contacts. Words are counted
 * from 0; one that is not there is "", its number NaN. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "runtime/scene/audit.h"

/* ---- words ---- */

/* A value as LAMMPS writes it into a line; NULL: NaN */
static const char *number_text(struct audit *a, double value)
{
    return isnan(value) ? NULL : audit_print(a, "@", value);
}

static const char *variable_text(struct audit *a, const char *name, size_t size)
{
    const struct audit_variable *const variable = audit_variable_named(a, name, size);
    return variable && variable->formula ? number_text(a, audit_value(a, variable->text))
           : variable                    ? variable->text
                                         : NULL;
}

/* The text that $x, ${name} or $(expression) at `*at` stands for, and *at after it; NULL: there is none */
static const char *substitute(struct audit *a, const char **at)
{
    const char *const start = *at + 1, *end = start;
    if (*start != '{' && *start != '(') {
        *at = start + (*start != '\0');
        return variable_text(a, start, 1);
    }
    int depth = 0;
    do {
        depth += (*end == '(') + (*end == '{') - (*end == ')') - (*end == '}');
        end++;
    } while (depth > 0 && *end);
    *at = end;
    const size_t size = depth == 0 ? (size_t)(end - start) - 2 : 0, format = strcspn(start + 1, ":");
    return *start == '{' ? variable_text(a, start + 1, size)
                         : number_text(a, audit_value_of(a, start + 1, format < size ? format : size));
}

/* Puts the values of variables into a line. Returns 0 after a remark if one has none. */
static int expand(struct audit *a, char *out, size_t size, const char *line)
{
    size_t used = 0;
    char quote = '\0';
    while (*line) {
        if (*line == '"' || *line == '\'')
            quote = quote == *line ? '\0' : quote ? quote : *line;
        if (*line == '$' && !quote) {
            const char *const start = line, *text = substitute(a, &line);
            if (!text) {
                const size_t length = (size_t)(line - start);
                audit_remark(a, "no value is known here of", audit_keep(a, start, length < 63 ? length : 63));
                return 0;
            }
            for (; *text && used + 1 < size; text++)
                out[used++] = *text;
        } else {
            if (used + 1 < size)
                out[used++] = *line;
            line++;
        }
    }
    out[used] = '\0';
    return 1;
}

/* Splits the line into words; quotes hold one together. */
static void split(struct audit *a)
{
    char *at = a->split, *to = a->split;
    a->words = 0;
    while (a->words < AUDIT_WORDS) {
        at += strspn(at, " \t\r\f\v");
        if (!*at)
            break;
        a->word[a->words++] = to;
        const char quote = *at == '"' || *at == '\'' ? *at++ : '\0';
        while (*at && (quote ? *at != quote : !strchr(" \t\r\f\v", *at)))
            *to++ = *at++;
        at += *at != '\0';
        *to++ = '\0';
    }
}

/* The words from `first` on with one blank between them */
static const char *joined(struct audit *a, int first)
{
    a->instead[0] = '\0';
    for (int i = first; i < a->words; i++)
        audit_append(a->instead, sizeof a->instead, i > first ? " $" : "$", a->word[i]);
    return a->instead;
}

static const char *word(const struct audit *a, int i)
{
    return i >= 0 && i < a->words ? a->word[i] : "";
}

static int is_word(const struct audit *a, int i, const char *text)
{
    return audit_is(word(a, i), text);
}

/* Where a word is from `from` on; -1: not there */
static int find(const struct audit *a, int from, const char *text)
{
    for (int i = from; i < a->words; i++)
        if (is_word(a, i, text))
            return i;
    return -1;
}

static double number_at(const struct audit *a, int i)
{
    return audit_number(word(a, i));
}

/* The type, from 0, that a word is; -1: none */
static int type_at(const struct audit *a, int i)
{
    const double type = number_at(a, i);
    return type >= 1 && type <= (double)AUDIT_TYPES ? (int)type - 1 : -1;
}

/* An end of a range of types, from 0 */
static int range_end(const char *word)
{
    return (int)fmax(fmin(strtod(word, NULL), 1e9), 0) - 1;
}

/* "3", "*", "2*", "*4" and "2*4" as types from 0 */
static int range_of(const char *word, int *first, int *last)
{
    const char *const star = strchr(word, '*');
    if (!star) {
        const double type = audit_number(word);
        *first = *last = (int)(type >= 1 && type <= (double)AUDIT_TYPES ? type - 1 : -1);
        return *first >= 0;
    }
    *first = star > word ? range_end(word) : 0;
    *last = star[1] ? range_end(star + 1) : AUDIT_TYPES - 1;
    return *first >= 0 && *first < AUDIT_TYPES && *last >= *first;
}

/* ---- units ---- */

static void read_units(struct audit *a)
{
    const char *const style = word(a, 1);
    static const struct {
        const char *name;
        double length, mass, time, step; /* in SI; the step of LAMMPS if none is set, in the units */
    } units[] = {{"si", 1, 1, 1, 1e-8},
                 {"cgs", 1e-2, 1e-3, 1, 1e-8},
                 {"micro", 1e-6, 1e-15, 1e-6, 2},
                 {"nano", 1e-9, 1e-21, 1e-9, 4.5e-4},
                 {"lj", 1, 1, 1, 0.005}};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (audit_is(style, units[i].name)) {
            a->length = units[i].length;
            a->mass = units[i].mass;
            a->time = units[i].time;
            audit_set_time_step(a, units[i].step * a->time);
            return;
        }
    audit_remark(a, "granular contacts have no consistent numbers in units", style);
}

/* ---- bodies ---- */

static void set_body(struct audit *a, int first, int last, const double radius[2], double density)
{
    for (int i = first; i <= last && i < AUDIT_TYPES; i++) {
        struct audit_type *const type = &a->type[i];
        if (radius[0] > 0 && radius[1] >= radius[0]) {
            type->radius[0] = radius[0];
            type->radius[1] = radius[1];
        }
        if (density > 0)
            type->density = density;
        if (i >= a->types && last < AUDIT_TYPES - 1)
            a->types = i + 1;
    }
}

/* A text under two names: the types of a group, the type of a mesh. It is kept as a variable, whose name no script can
 * use. NULL: there is none. */
static const char *kept_text(struct audit *a, const char *what, const char *name)
{
    const char *const variable = audit_print(a, "$ $", what, name);
    const struct audit_variable *const found = audit_variable_named(a, variable, strlen(variable));
    return found ? found->text : NULL;
}

static void keep_text(struct audit *a, const char *what, const char *name, const char *text)
{
    audit_set_variable(a, audit_print(a, "$ $", what, name), text, 0);
}

/* group NAME type N */
static void read_group(struct audit *a)
{
    if (is_word(a, 2, "type") && a->words == 4)
        keep_text(a, "group", word(a, 1), word(a, 3));
}

/* set type N diameter D density RHO; set group all ... */
static void read_set(struct audit *a)
{
    const int diameter = find(a, 3, "diameter");
    int density = find(a, 3, "density"), first, last;
    if (density < 0)
        density = find(a, 3, "density/disc");
    if (diameter < 0 && density < 0)
        return;
    const double size = diameter < 0 ? (double)NAN : number_at(a, diameter + 1) / 2, radius[2] = {size, size};
    const double rho = density < 0 ? (double)NAN : number_at(a, density + 1);
    if ((diameter >= 0 && isnan(size)) || (density >= 0 && isnan(rho))) {
        audit_remark(a, "the diameter or density is no number", NULL);
        return;
    }
    const char *const name = word(a, 2), *const types = kept_text(a, "group", name);
    if (is_word(a, 1, "type") ? range_of(name, &first, &last)
                              : is_word(a, 1, "group") && types && range_of(types, &first, &last))
        set_body(a, first, last, radius, rho);
    else if (is_word(a, 1, "atom") || audit_is(name, "all"))
        set_body(a, 0, AUDIT_TYPES - 1, radius, rho);
    else
        audit_remark(a, "the types of this group are not known:", name);
}

/* LAMMPS makes atoms of diameter 1 and density 1. */
static void read_create_atoms(struct audit *a)
{
    static const double radius[2] = {0.5, 0.5};
    const int type = type_at(a, 1);
    if (audit_is(a->simulator, "lammps") && type >= 0 && isnan(a->type[type].radius[0]))
        set_body(a, type, type, radius, isnan(a->type[type].density) ? 1 : (double)NAN);
}

static void read_pour(struct audit *a)
{
    const int type = type_at(a, 5);
    const int diameter = find(a, 6, "diam"), density = find(a, 6, "dens"), speed = find(a, 6, "vel");
    double radius[2] = {0.5, 0.5};
    if (type < 0)
        return;
    if (diameter >= 0) {
        const char *const how = word(a, diameter + 1);
        const double first = number_at(a, diameter + 2);
        radius[0] = first / 2;
        radius[1] = audit_is(how, "range") ? number_at(a, diameter + 3) / 2 : radius[0];
        if (audit_is(how, "poly")) { /* so many pairs of a size and its share */
            radius[0] = INFINITY;
            radius[1] = 0;
            for (int i = 0; i < first && diameter + 3 + 2 * i < a->words; i++) {
                const double size = number_at(a, diameter + 3 + 2 * i) / 2;
                radius[0] = size < radius[0] ? size : radius[0];
                radius[1] = size > radius[1] ? size : radius[1];
            }
        }
        if (!(radius[0] > 0 && radius[1] >= radius[0]))
            audit_remark(a, "diam is not read:", how);
    }
    const double least = density < 0 ? 1 : number_at(a, density + 1),
                 most = density < 0 ? 1 : number_at(a, density + 2);
    if (least != most)
        audit_remark(a, "a range of densities is not read", NULL);
    set_body(a, type, type, radius, least == most ? least : (double)NAN);
    if (speed >= 0)
        audit_add_speed(a, fabs(number_at(a, speed + 5)) * a->length / a->time);
}

/* LIGGGHTS: fix ID all particletemplate/sphere SEED atom_type 1 density constant 2500 radius constant 0.005 */
static void read_template(struct audit *a)
{
    const int type = type_at(a, find(a, 4, "atom_type") + 1), kind = type < 0 ? 0 : type;
    const int density = find(a, 4, "density"), at = find(a, 4, "radius");
    const struct audit_type *const now = &a->type[kind];
    const double least = number_at(a, at + 2), most = is_word(a, at + 1, "uniform") ? number_at(a, at + 3) : least;
    if (at < 0 || !(is_word(a, at + 1, "constant") || is_word(a, at + 1, "uniform")) || isnan(least + most))
        audit_remark(a, "the radius of the template is not read", NULL);
    else {
        const double radius[2] = {fmin(least, now->radius[0]), fmax(most, now->radius[1])};
        set_body(a, kind, kind, radius, (double)NAN);
    }
    if (density >= 0 && is_word(a, density + 1, "constant"))
        a->type[kind].density = number_at(a, density + 2);
}

static void read_velocity(struct audit *a, int set)
{
    double square = 0;
    for (int i = 0; i < 3; i++) {
        const double part = number_at(a, set + 1 + i);
        square += isnan(part) ? 0 : part * part;
    }
    audit_add_speed(a, sqrt(square) * a->length / a->time);
}

/* ---- contacts of LAMMPS: pair styles granular and gran/..., walls ---- */

/* A contact of the present line, whose words begin at a->word[at], between all types; NULL after a remark on the
 * damping. A model without a row for limit_damping is the one without it, but for its end. */
static struct audit_contact *add_granular(struct audit *a, int at, int hertz, const char *damping, double number,
                                          double stiffness)
{
    enum { EITHER = 2 };
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
        {EITHER, "coeff_restitution", "granular hertz or hooke, damping coeff_restitution",
         "granular hertz or hooke, damping coeff_restitution, limit_damping"}};
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        if ((models[i].hertz != hertz && models[i].hertz != EITHER) || !audit_is(models[i].damping, damping))
            continue;
        struct audit_contact *const contact = audit_add(a, joined(a, 0));
        const int limited = find(a, at, "limit_damping") >= 0, has_row = limited && models[i].with_limit;
        contact->model = has_row ? models[i].with_limit : models[i].model;
        contact->limited = limited && !has_row;
        contact->number = number;
        contact->spring = hertz ? AUDIT_HERTZ : AUDIT_HOOKE;
        contact->stiffness = stiffness;
        contact->last[0] = contact->last[1] = AUDIT_TYPES - 1;
        return contact;
    }
    audit_remark(a, "cor does not know damping", damping);
    return NULL;
}

/* The normal force and its damping, of which the first word is a->word[at]: hertz K_N ETA tangential ... */
static struct audit_contact *read_granular(struct audit *a, int at)
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
    const char *const name = word(a, at);
    size_t force = 0;
    while (force < sizeof forces / sizeof *forces && !audit_is(forces[force].name, name))
        force++;
    if (force == sizeof forces / sizeof *forces) {
        audit_remark(a, "cor does not know the normal force", name);
        return NULL;
    }
    const int key = find(a, at, "damping"), material = forces[force].material;
    const char *const damping = key < 0 ? "viscoelastic" : word(a, key + 1);
    const double stiffness = number_at(a, at + 1), number = number_at(a, at + 2), poisson = number_at(a, at + 3);
    if (isnan(stiffness) || isnan(number) || (material && isnan(poisson))) {
        audit_remark(a, "the numbers of the normal force are missing or no numbers", NULL);
        return NULL;
    }
    const int none = audit_is(damping, "none");
    struct audit_contact *const contact =
        add_granular(a, at, forces[force].hertz, none ? "velocity" : damping, none ? 0 : number,
                     material ? 2.0 / 3 * stiffness / (1 - poisson * poisson) : stiffness);
    if (!contact)
        return NULL;
    contact->word[0] = at + 2;
    contact->harmonic = material;
    contact->fault = forces[force].fault ? forces[force].fault
                     : key < 0           ? "Without the word damping LAMMPS takes viscoelastic."
                                         : NULL;
    contact->unknown = forces[force].fault != NULL;
    return contact;
}

/* hooke, hooke/history or hertz/history, and K_n K_t gamma_n gamma_t mu damp from a->word[at] on */
static struct audit_contact *read_old(struct audit *a, const char *style, int at)
{
    const int hertz = audit_starts(style, "hertz");
    const double stiffness = number_at(a, at), number = number_at(a, at + 2);
    if (!isnan(stiffness) && !isnan(number))
        return add_granular(a, at, hertz, hertz ? "viscoelastic" : "mass_velocity", number, stiffness);
    audit_remark(a, "K_n and gamma_n are missing or no numbers", NULL);
    return NULL;
}

static void keep_model(struct audit *a, int at, int type);

static void read_pair_style(struct audit *a)
{
    int known = 0;
    for (int i = 1; i < a->words && audit_is(a->simulator, "lammps"); i++) {
        const int old = audit_starts(a->word[i], "gran/hooke") || audit_starts(a->word[i], "gran/hertz");
        if (old)
            read_old(a, a->word[i] + strlen("gran/"), i + 1);
        known = known || old || is_word(a, i, "granular");
    }
    if (audit_is(a->simulator, "lammps"))
        known = known || is_word(a, 1, "none") || is_word(a, 1, "zero");
    else if (is_word(a, 1, "gran") && is_word(a, 2, "model")) {
        keep_model(a, 3, -1);
        known = 1;
    }
    if (!known)
        audit_remark(a, "this is no granular contact that cor knows:", word(a, 1));
}

static void read_pair_coeff(struct audit *a)
{
    const int hybrid = is_word(a, 3, "granular");
    int first[2], last[2];
    if (a->words < 4 + hybrid || audit_starts(word(a, 3), "gran/") || !audit_is(a->simulator, "lammps"))
        return; /* all is said by pair_style */
    if (!range_of(word(a, 1), &first[0], &last[0]) || !range_of(word(a, 2), &first[1], &last[1])) {
        audit_remark(a, "the types are no numbers", NULL);
        return;
    }
    struct audit_contact *const contact = read_granular(a, 3 + hybrid);
    if (contact) {
        memcpy(contact->first, first, sizeof first);
        memcpy(contact->last, last, sizeof last);
    }
}

static void read_lammps_wall(struct audit *a)
{
    const char *const style = word(a, 4);
    struct audit_contact *contact = NULL;
    if (audit_is(style, "granular"))
        contact = read_granular(a, 5);
    else if (audit_starts(style, "hooke") || audit_starts(style, "hertz"))
        contact = read_old(a, style, 5);
    else
        audit_remark(a, "cor does not know the wall", style);
    if (contact) {
        contact->wall = 1;
        contact->last[1] = 0;
    }
}

static const struct audit_contact *pair_contact(const struct audit *a, int i, int j)
{
    for (const struct audit_contact *c = a->contact + a->contacts; c-- > a->contact;)
        if (!c->wall && audit_covers(c, i, j))
            return c;
    return NULL;
}

/* Types without a line of their own: LAMMPS mixes the lines of i and i and of j and j: e and eta by their geometric
 * mean. */
static void mix_pairs(struct audit *a)
{
    for (int i = 0; i < a->types; i++)
        for (int j = i + 1; j < a->types; j++) {
            const struct audit_contact *const one = pair_contact(a, i, i), *const two = pair_contact(a, j, j);
            if (!one || !two || pair_contact(a, i, j) || !one->model || one->model != two->model ||
                one->harmonic != two->harmonic)
                continue;
            const struct audit_contact first = *one, second = *two;
            struct audit_contact *const mixed = audit_add(a, "");
            *mixed = second;
            mixed->text = "";
            mixed->word[0] = -1;
            audit_between(mixed, i, j);
            mixed->number = sqrt(first.number * second.number);
            mixed->stiffness = first.harmonic ? 2 / (1 / first.stiffness + 1 / second.stiffness)
                                              : sqrt(first.stiffness * second.stiffness);
            mixed->fault = "No line for this pair: LAMMPS takes the geometric mean of both types.";
        }
}

/* ---- contacts of LIGGGHTS: models of pair_style gran and of walls, whose numbers are properties of the types ---- */

/* fix ID all property/global NAME peratomtype|peratomtypepair N|scalar|vector VALUE... */
static void read_property(struct audit *a)
{
    static const char *const known[] = {"youngsModulus", "poissonsRatio",         "coefficientRestitution", "kn",
                                        "gamman",        "characteristicVelocity"};
    const int pairs = is_word(a, 5, "peratomtypepair"), first = pairs ? 7 : 6;
    size_t k = 0;
    if (a->properties == AUDIT_PROPERTIES) {
        audit_remark(a, "more properties than can be read:", word(a, 4));
        return;
    }
    while (k < sizeof known / sizeof *known && !is_word(a, 4, known[k]))
        k++;
    if (k == sizeof known / sizeof *known)
        return;
    struct audit_property *const p = &a->property[a->properties++];
    *p = (struct audit_property){.name = known[k], .file = a->text.name, .line = a->line, .word = first};
    p->text = audit_kept(a, "$", joined(a, 0));
    p->types = pairs ? type_at(a, 6) + 1 : a->words - first;
    for (int i = first; i < a->words && p->count < AUDIT_VALUES; i++) {
        p->value[p->count] = number_at(a, i);
        if (isnan(p->value[p->count++]))
            audit_remark(a, "this value of a property is no number:", word(a, i));
    }
    if (pairs && (p->types < 1 || p->types * p->types != p->count)) {
        audit_remark(a, "the property needs a value for each pair of types:", p->name);
        a->properties--;
    }
}

/* The models by LIGGGHTS' names, and their rows of cor_simulators; the second row is that of limitForce. */
#define ROWS(name) name, name ", limitForce on"
static const struct contact_model {
    const char *name, *rows[2];
    int stiff, hertz; /* by kn and gamman; Hertz's force */
} contact_models[] = {{"hertz", {ROWS("hertz or hooke, coefficientRestitution")}, 0, 1},
                      {"hooke", {ROWS("hertz or hooke, coefficientRestitution")}, 0, 0},
                      {"hertz/stiffness", {ROWS("hertz/stiffness, gamman")}, 1, 1},
                      {"hooke/stiffness", {ROWS("hooke/stiffness, gamman")}, 1, 0}};

static const struct contact_model *contact_model(const char *name)
{
    for (size_t k = 0; k < sizeof contact_models / sizeof *contact_models; k++)
        if (audit_is(contact_models[k].name, name))
            return &contact_models[k];
    return NULL;
}

static int is_on(const struct audit *a, int at, const char *switched)
{
    const int found = find(a, at, switched);
    return found >= 0 && !is_word(a, found + 1, "off");
}

/* model hertz tangential history limitForce on: the words from the model's name on, kept for the end. `type` counts
 * from 0 and is that of a wall; -1: two spheres meet. */
static void keep_model(struct audit *a, int at, int type)
{
    const struct contact_model *const model = contact_model(word(a, at));
    if (!model) {
        audit_remark(a, "cor does not know the contact model", word(a, at));
        return;
    }
    struct audit_contact *const contact = audit_add(a, "");
    contact->model = model->name; /* until make_pairs */
    contact->limited = is_on(a, at, "limitForce");
    contact->wall = type >= 0;
    contact->last[0] = AUDIT_TYPES - 1;
    contact->first[1] = type >= 0 ? type : 0;
    contact->last[1] = type >= 0 ? type : AUDIT_TYPES - 1;
    if (is_on(a, at, "cohesion"))
        contact->fault = "The cohesion changes eps.";
    else if (is_on(a, at, "viscous"))
        contact->fault = "With viscous on the Stokes number of each impact sets the damping.";
    else if (is_on(a, at, "absolute_damping"))
        contact->fault = "With absolute_damping on gamman is replaced by gamman_abs, which is not read.";
    contact->unknown = contact->fault != NULL;
}

/* fix ID GROUP wall/gran model hertz ... primitive type 1 zplane 0, or ... mesh n_meshes 2 meshes ID ID */
static void read_liggghts_wall(struct audit *a)
{
    const int primitive = find(a, 4, "primitive"), meshes = find(a, 4, "meshes");
    if (!is_word(a, 4, "model") || (primitive < 0 && meshes < 0)) {
        audit_remark(a, "cor does not know the wall", word(a, 4));
        return;
    }
    const double count = primitive < 0 ? number_at(a, find(a, 4, "n_meshes") + 1) : 1;
    for (int i = 1; i <= count && (primitive >= 0 || meshes + i < a->words); i++) {
        const char *type = word(a, find(a, 4, "type") + 1);
        int first, last;
        if (primitive < 0) {
            const char *const of_mesh = kept_text(a, "mesh", word(a, meshes + i));
            type = of_mesh ? of_mesh : word(a, meshes + i);
        }
        if (range_of(type, &first, &last) && first == last)
            keep_model(a, 5, first);
        else
            audit_remark(a, "the type of the wall is not read:", type);
    }
}

static const struct audit_property *property(const struct audit *a, const char *name)
{
    for (int i = a->properties - 1; i >= 0; i--)
        if (audit_is(a->property[i].name, name))
            return &a->property[i];
    return NULL;
}

static double property_value(const struct audit_property *p, int i)
{
    return p && i < p->count ? p->value[i] : (double)NAN;
}

/* One pair of types by the matrices of the properties */
static void add_pair(struct audit *a, const struct audit_contact *style, int i, int j)
{
    const struct contact_model *const model = contact_model(style->model);
    const struct audit_property *const number = property(a, model->stiff ? "gamman" : "coefficientRestitution"),
                                       *const kn = property(a, "kn");
    struct audit_contact *const contact = audit_add(a, "");
    *contact = *style;
    contact->model = model->rows[style->limited];
    contact->limited = 0; /* the row says it */
    audit_between(contact, i, j);
    if (!number || i >= number->types || j >= number->types) {
        audit_unknown(contact, model->stiff ? "gamman of these types could not be read."
                                            : "coefficientRestitution of these types could not be read.");
        return;
    }
    contact->file = number->file;
    contact->line = number->line;
    contact->text = number->text;
    contact->number = property_value(number, i * number->types + j);
    if (!model->stiff) {
        contact->word[0] = number->word + i * number->types + j;
        contact->word[1] = number->word + j * number->types + i;
        contact->spring = model->hertz ? AUDIT_MATERIAL : AUDIT_CHARACTERISTIC;
        contact->speed = property_value(property(a, "characteristicVelocity"), 0);
    } else {
        contact->spring = model->hertz ? AUDIT_HERTZ : AUDIT_HOOKE;
        contact->stiffness = kn && i < kn->types && j < kn->types ? property_value(kn, i * kn->types + j) : (double)NAN;
    }
}

/* Replaces each model by its pairs of types. */
static void make_pairs(struct audit *a)
{
    enum { MOST_STYLES = AUDIT_CONTACTS / 2 };
    const struct audit_property *const young = property(a, "youngsModulus"), *const poisson =
                                                                                 property(a, "poissonsRatio");
    const struct audit_property *const e = property(a, "coefficientRestitution"), *const kn = property(a, "gamman");
    const int styles = a->contacts < MOST_STYLES ? a->contacts : MOST_STYLES;
    const int types = a->types > 0 ? a->types : e ? e->types : kn ? kn->types : 1;
    int bodies = 0;
    if (styles < a->contacts)
        audit_remark(a, "more contact models than can be read", NULL);
    a->contacts = styles;
    for (int i = 0; i < types && i < AUDIT_TYPES; i++) {
        a->type[i].young = property_value(young, i);
        a->type[i].poisson = property_value(poisson, i);
        bodies += !isnan(a->type[i].radius[0]);
    }
    a->types = types;
    for (int n = 0; n < styles; n++) {
        const struct audit_contact style = a->contact[n];
        const int last = style.wall ? style.last[1] : types - 1;
        for (int i = 0; i < types; i++)
            for (int j = style.wall ? style.first[1] : i; j <= last; j++)
                if (bodies == 0 || !(isnan(a->type[i].radius[0]) || (!style.wall && isnan(a->type[j].radius[0]))))
                    add_pair(a, &style, i, j); /* types without bodies are those of walls */
    }
    memmove(a->contact, a->contact + styles, (size_t)(a->contacts - styles) * sizeof *a->contact);
    a->contacts -= styles;
}

/* ---- commands ---- */

void audit_include(struct audit *a, const char *name, void (*read)(struct audit *a, void *context), void *context)
{
    struct cor_audit_text text;
    if (a->depth >= AUDIT_INCLUDES || a->includes >= AUDIT_INCLUDES_IN_ALL) {
        audit_remark(a, "too many includes; does a file include itself?", name);
        return;
    }
    if (!a->options->open || a->options->open(a->options->context, &text, name, a->text.name) != 0) {
        audit_remark(a, "cannot include", name);
        return;
    }
    const struct cor_audit_text outer = a->text;
    const size_t at = a->at;
    const long line = a->line, next_line = a->next_line;
    a->depth++;
    a->includes++;
    a->text = text;
    a->at = 0;
    a->next_line = 1;
    read(a, context);
    a->depth--;
    a->text = outer;
    a->at = at;
    a->line = line;
    a->next_line = next_line;
}

static void read_variable(struct audit *a)
{
    const char *const name = word(a, 1), *const style = word(a, 2), *const value = word(a, 3);
    const int formula = audit_is(style, "equal");
    struct audit_variable *const known = audit_variable_named(a, name, strlen(name));
    if (audit_is(style, "delete")) {
        if (known)
            *known = a->variable[--a->variables];
    } else if (audit_is(style, "loop")) {
        if (!known)
            audit_set_variable(a, name, a->words > 4 && !is_word(a, 4, "pad") ? value : "1", 0);
    } else if (a->words >= 4 && (audit_is(style, "index") || audit_is(style, "world") || audit_is(style, "universe") ||
                                 audit_is(style, "string") || audit_is(style, "internal") || formula)) {
        if (!known || formula || audit_is(style, "string")) /* LAMMPS keeps the first of the others */
            audit_set_variable(a, name, formula ? joined(a, 3) : value, formula);
    }
}

static void execute(struct audit *a, const char *text);

static void read_lines(struct audit *a, void *context)
{
    (void)context;
    while (audit_next_line(a, AUDIT_SCRIPT))
        execute(a, a->raw);
}

/* if CONDITION then COMMAND ... elif CONDITION COMMAND ... else COMMAND ... */
static void read_if(struct audit *a)
{
    char branch[AUDIT_ADVICE] = "";
    int taken = 0;
    for (int i = 1; i < a->words && !taken; i++) {
        const int first = i == 1 || is_word(a, i, "elif"), last = is_word(a, i, "else");
        if (!first && !last)
            continue;
        i += i > 1 && first;
        char condition[256] = "";
        const double value = last                                                 ? 1
                             : expand(a, condition, sizeof condition, word(a, i)) ? audit_value(a, condition)
                                                                                  : (double)NAN;
        if (isnan(value)) {
            audit_remark(a, "the condition is not read, and neither branch is:", word(a, i));
            return;
        }
        if (value == 0)
            continue;
        taken = 1;
        /* the words are overwritten by the first command that is executed */
        for (i += 1; i < a->words && !is_word(a, i, "elif") && !is_word(a, i, "else"); i++)
            if (!is_word(a, i, "then"))
                audit_append(branch, sizeof branch, "$\n", a->word[i]);
    }
    for (char *at = branch, *end; (end = strchr(at, '\n')) != NULL; at = end + 1) {
        *end = '\0';
        if (a->depth++ < AUDIT_INCLUDES)
            execute(a, at);
        a->depth--;
    }
}

/* The pairs that no line names */
static void end_of_system(struct audit *a)
{
    (audit_is(a->simulator, "lammps") ? mix_pairs : make_pairs)(a);
}

static void clear_system(struct audit *a)
{
    end_of_system(a);
    audit_flush(a);
    audit_clear_types(a);
    a->types = a->properties = a->speeds = 0;
}

static void read_fix(struct audit *a)
{
    const char *const style = word(a, 3);
    const int lammps = audit_is(a->simulator, "lammps"), speed = find(a, 4, "vel");
    if (audit_starts(style, "wall/gran"))
        (lammps ? read_lammps_wall : read_liggghts_wall)(a);
    else if (!lammps && audit_starts(style, "mesh/surface"))
        keep_text(a, "mesh", word(a, 1), word(a, find(a, 4, "type") + 1));
    else if (audit_is(style, "property/global"))
        read_property(a);
    else if (audit_is(style, "pour"))
        read_pour(a);
    else if (audit_starts(style, "particletemplate/sphere"))
        read_template(a);
    else if (audit_starts(style, "insert/") && speed > 0 && is_word(a, speed + 1, "constant"))
        read_velocity(a, speed + 1);
}

static void read_include(struct audit *a)
{
    const char *const name = word(a, 1); /* kept, for the words will be those of the included file */
    audit_include(a, audit_keep(a, name, strlen(name)), read_lines, NULL);
}

static void read_timestep(struct audit *a)
{
    const double step = number_at(a, 1);
    if (!(step > 0))
        audit_remark(a, "timestep is no number above 0:", word(a, 1));
    else
        audit_set_time_step(a, step * a->time);
}

static void read_create_box(struct audit *a)
{
    const int types = type_at(a, 1) + 1;
    a->types = types > 0 ? types : a->types;
}

static void read_velocities(struct audit *a)
{
    if (is_word(a, 2, "set"))
        read_velocity(a, 2);
}

static const struct command {
    const char *name;
    void (*read)(struct audit *a);
    int expanded_later; /* by the branch that is taken */
} commands[] = {{"units", read_units, 0},           {"variable", read_variable, 0},
                {"include", read_include, 0},       {"if", read_if, 1},
                {"clear", clear_system, 0},         {"timestep", read_timestep, 0},
                {"create_box", read_create_box, 0}, {"set", read_set, 0},
                {"group", read_group, 0},           {"create_atoms", read_create_atoms, 0},
                {"velocity", read_velocities, 0},   {"fix", read_fix, 0},
                {"pair_style", read_pair_style, 0}, {"pair_coeff", read_pair_coeff, 0}};

/* Other commands do not matter to a contact, and neither do their variables. */
static void execute(struct audit *a, const char *text)
{
    const char *const start = text + strspn(text, " \t");
    const size_t size = strcspn(start, " \t\r");
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        if (strlen(commands[i].name) != size || strncmp(start, commands[i].name, size) != 0)
            continue;
        a->split[0] = '\0';
        if (commands[i].expanded_later)
            audit_append(a->split, sizeof a->split, "$", text);
        else if (!expand(a, a->split, sizeof a->split, text))
            return;
        split(a);
        commands[i].read(a);
        return;
    }
}

void audit_script(struct audit *a)
{
    execute(a, "units lj");
    read_lines(a, NULL);
    end_of_system(a);
}
