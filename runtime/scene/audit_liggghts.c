/* SPDX-License-Identifier: MIT */
/* The contacts of LIGGGHTS: models of pair_style gran and of walls, whose numbers are properties of the types */
#include <math.h>
#include <string.h>

#include "runtime/scene/audit.h"

/* fix ID all property/global NAME peratomtype|peratomtypepair N|scalar|vector VALUE... */
void audit_liggghts_property(struct audit *a, const struct audit_words *w)
{
    const int pairs = audit_is(audit_word(w, 5), "peratomtypepair"), first = pairs ? 7 : 6;
    if (a->properties == AUDIT_PROPERTIES) {
        audit_remark(a, "more properties than can be read:", audit_word(w, 4));
        return;
    }
    const char *const name = audit_word(w, 4);
    static const char *const known[] = {"youngsModulus", "poissonsRatio",         "coefficientRestitution", "kn",
                                        "gamman",        "characteristicVelocity"};
    size_t k = 0;
    while (k < sizeof known / sizeof *known && !audit_is(known[k], name))
        k++;
    if (k == sizeof known / sizeof *known)
        return;
    struct audit_property *const p = &a->property[a->properties++];
    p->name = known[k];
    p->file = a->text.name;
    p->line = a->line;
    p->text = audit_keep_line(a, w);
    p->word = first;
    p->types = w->count - first;
    if (pairs)
        p->types = audit_number_at(w, 6) >= 1 && audit_number_at(w, 6) <= AUDIT_TYPES ? (int)audit_number_at(w, 6) : 0;
    p->count = 0;
    for (int i = first; i < w->count && p->count < AUDIT_VALUES; i++) {
        p->value[p->count] = audit_number_at(w, i);
        if (isnan(p->value[p->count++]))
            audit_remark(a, "this value of a property is no number:", audit_word(w, i));
    }
    if (pairs && (p->types < 1 || p->types * p->types != p->count)) {
        audit_remark(a, "the property needs a value for each pair of types:", name);
        a->properties--;
    }
}

/* The models by LIGGGHTS' names, and their rows of cor_simulator_models; the second row is that of limitForce. */
static const struct model {
    const char *name, *rows[2];
    int stiff, hertz; /* by kn and gamman; Hertz's force */
} models[] = {{"hertz",
               {"hertz or hooke, coefficientRestitution", "hertz or hooke, coefficientRestitution, limitForce on"},
               0,
               1},
              {"hooke",
               {"hertz or hooke, coefficientRestitution", "hertz or hooke, coefficientRestitution, limitForce on"},
               0,
               0},
              {"hertz/stiffness", {"hertz/stiffness, gamman", "hertz/stiffness, gamman, limitForce on"}, 1, 1},
              {"hooke/stiffness", {"hooke/stiffness, gamman", "hooke/stiffness, gamman, limitForce on"}, 1, 0}};

static const struct model *model_named(const char *name)
{
    for (size_t k = 0; k < sizeof models / sizeof *models; k++)
        if (audit_is(models[k].name, name))
            return &models[k];
    return NULL;
}

static int is_on(const struct audit_words *w, int at, const char *switched)
{
    const int found = audit_find(w, at, switched);
    return found >= 0 && !audit_is(audit_word(w, found + 1), "off");
}

/* model hertz tangential history limitForce on: the words from the model's name on, kept for the end. `type` counts
 * from 0 and is that of a wall; -1: two spheres meet. */
static void keep_model(struct audit *a, const struct audit_words *w, int at, int type)
{
    const struct model *const model = model_named(audit_word(w, at));
    if (!model) {
        audit_remark(a, "cor does not know the contact model", audit_word(w, at));
        return;
    }
    struct audit_contact *const contact = audit_add(a, "");
    contact->model = model->name; /* until audit_liggghts_pairs */
    contact->limited = is_on(w, at, "limitForce");
    contact->wall = type >= 0;
    contact->last[0] = AUDIT_TYPES - 1;
    contact->first[1] = type >= 0 ? type : 0;
    contact->last[1] = type >= 0 ? type : AUDIT_TYPES - 1;
    if (is_on(w, at, "cohesion"))
        contact->fault = "The cohesion changes eps.";
    else if (is_on(w, at, "viscous"))
        contact->fault = "With viscous on the Stokes number of each impact sets the damping.";
    else if (is_on(w, at, "absolute_damping"))
        contact->fault = "With absolute_damping on gamman is replaced by gamman_abs, which is not read.";
    contact->unknown = contact->fault != NULL;
}

void audit_liggghts_pair(struct audit *a, const struct audit_words *w)
{
    if (!audit_is(audit_word(w, 0), "pair_style"))
        return;
    if (audit_is(audit_word(w, 1), "gran") && audit_is(audit_word(w, 2), "model"))
        keep_model(a, w, 3, -1);
    else
        audit_remark(a, "this is no granular contact that cor knows:", audit_word(w, 1));
}

/* A type from 0, after a remark -1 */
static int type_of(struct audit *a, const char *word)
{
    int first, last;
    if (audit_range(word, &first, &last) && first == last)
        return first;
    audit_remark(a, "the type of the wall is not read:", word);
    return -1;
}

/* The type of a mesh is in its own fix; it is kept as a variable, whose name no script can use. */
static const char *mesh_variable(struct audit *a, const char *id)
{
    a->pair[0] = '\0';
    audit_append(a->pair, sizeof a->pair, "mesh $", id);
    return a->pair;
}

void audit_liggghts_mesh(struct audit *a, const struct audit_words *w)
{
    audit_set_variable(a, mesh_variable(a, audit_word(w, 1)), audit_word(w, audit_find(w, 4, "type") + 1), 0);
}

/* fix ID GROUP wall/gran model hertz ... primitive type 1 zplane 0, or ... mesh n_meshes 2 meshes ID ID */
void audit_liggghts_wall(struct audit *a, const struct audit_words *w)
{
    const int primitive = audit_find(w, 4, "primitive"), meshes = audit_find(w, 4, "meshes");
    if (!audit_is(audit_word(w, 4), "model") || (primitive < 0 && meshes < 0)) {
        audit_remark(a, "cor does not know the wall", audit_word(w, 4));
        return;
    }
    const double count = primitive < 0 ? audit_number_at(w, audit_find(w, 4, "n_meshes") + 1) : 1;
    for (int i = 1; i <= count && (primitive >= 0 || meshes + i < w->count); i++) {
        const char *type = audit_word(w, audit_find(w, 4, "type") + 1);
        if (primitive < 0) {
            const char *const name = mesh_variable(a, audit_word(w, meshes + i));
            const struct audit_variable *const mesh = audit_variable_named(a, name, strlen(name));
            type = mesh ? mesh->text : audit_word(w, meshes + i);
        }
        const int kind = type_of(a, type);
        if (kind >= 0)
            keep_model(a, w, 5, kind);
    }
}

static const struct audit_property *property(const struct audit *a, const char *name)
{
    for (int i = a->properties - 1; i >= 0; i--)
        if (audit_is(a->property[i].name, name))
            return &a->property[i];
    return NULL;
}

static double value_of(const struct audit_property *p, int i)
{
    return p && i < p->count ? p->value[i] : (double)NAN;
}

/* One pair of types by the matrices of the properties */
static void add_pair(struct audit *a, const struct audit_contact *style, int i, int j)
{
    const struct model *const model = model_named(style->model);
    const struct audit_property *const number = property(a, model->stiff ? "gamman" : "coefficientRestitution"),
                                       *const kn = property(a, "kn");
    struct audit_contact *const contact = audit_add(a, "");
    const char *const text = contact->text;
    *contact = *style;
    contact->text = text;
    contact->model = model->rows[style->limited];
    contact->limited = 0; /* the row says it */
    contact->first[0] = contact->last[0] = i;
    contact->first[1] = contact->last[1] = j;
    if (!number || i >= number->types || j >= number->types) {
        contact->unknown = 1;
        contact->fault = model->stiff ? "gamman of these types could not be read."
                                      : "coefficientRestitution of these types could not be read.";
        return;
    }
    contact->file = number->file;
    contact->line = number->line;
    contact->text = number->text;
    contact->number = value_of(number, i * number->types + j);
    if (!model->stiff) {
        contact->word[0] = number->word + i * number->types + j;
        contact->word[1] = number->word + j * number->types + i;
        contact->spring = model->hertz ? AUDIT_MATERIAL : AUDIT_CHARACTERISTIC;
        contact->speed = value_of(property(a, "characteristicVelocity"), 0);
    } else {
        contact->spring = model->hertz ? AUDIT_HERTZ : AUDIT_HOOKE;
        contact->stiffness = kn && i < kn->types && j < kn->types ? value_of(kn, i * kn->types + j) : (double)NAN;
    }
}

/* Replaces each model by its pairs of types. */
void audit_liggghts_pairs(struct audit *a)
{
    const struct audit_property *const young = property(a, "youngsModulus"), *const poisson =
                                                                                 property(a, "poissonsRatio");
    const struct audit_property *const e = property(a, "coefficientRestitution"), *const kn = property(a, "gamman");
    enum { MOST_STYLES = AUDIT_CONTACTS / 2 };
    const int styles = a->contacts < MOST_STYLES ? a->contacts : MOST_STYLES;
    int types = a->types, bodies = 0;
    if (styles < a->contacts)
        audit_remark(a, "more contact models than can be read", NULL);
    a->contacts = styles;
    if (types == 0)
        types = e ? e->types : kn ? kn->types : 1;
    for (int i = 0; i < types && i < AUDIT_TYPES; i++) {
        a->type[i].young = value_of(young, i);
        a->type[i].poisson = value_of(poisson, i);
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
