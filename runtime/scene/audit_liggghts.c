/* SPDX-License-Identifier: MIT */
/* The contacts of LIGGGHTS: models of pair_style gran and of walls, whose numbers are properties of the types */
#include <math.h>
#include <string.h>

#include "runtime/scene/audit.h"

/* fix ID all property/global NAME peratomtype|peratomtypepair N|scalar|vector VALUE... */
void audit_liggghts_property(struct audit *a, const struct audit_words *w)
{
    const int pairs = audit_is(audit_word(w, 5), "peratomtypepair"), first = pairs ? 7 : 6;
    if (a->properties == AUDIT_PROPERTIES) { /* the oldest is the least likely to matter */
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
    p->types = pairs ? (int)audit_number_at(w, 6) : w->count - first;
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

/* gran model hertz tangential history limitForce on: the words from the model's name on, kept for the end */
static void keep_model(struct audit *a, const struct audit_words *w, int at, int wall)
{
    static const char *const models[] = {"hertz", "hooke", "hertz/stiffness", "hooke/stiffness"};
    size_t k = 0;
    while (k < sizeof models / sizeof *models && !audit_is(models[k], audit_word(w, at)))
        k++;
    if (k == sizeof models / sizeof *models) {
        audit_remark(a, "cor does not know the contact model", audit_word(w, at));
        return;
    }
    struct audit_contact *const contact = audit_add(a, "");
    const int limit = audit_find(w, at, "limitForce"), cohesion = audit_find(w, at, "cohesion");
    const int type = audit_find(w, at, "type");
    contact->model = models[k]; /* of LIGGGHTS, until audit_liggghts_pairs */
    contact->limited = limit >= 0 && audit_is(audit_word(w, limit + 1), "on");
    contact->wall = wall;
    contact->last[0] = AUDIT_TYPES - 1;
    contact->last[1] = wall ? 0 : AUDIT_TYPES - 1;
    if (wall && audit_number_at(w, type + 1) >= 1 && audit_number_at(w, type + 1) <= AUDIT_TYPES)
        contact->first[1] = contact->last[1] = (int)audit_number_at(w, type + 1) - 1;
    if (cohesion >= 0 && !audit_is(audit_word(w, cohesion + 1), "off"))
        contact->fault = "The cohesion changes eps; the number is that without it.";
}

void audit_liggghts_pair(struct audit *a, const struct audit_words *w)
{
    if (!audit_is(audit_word(w, 0), "pair_style"))
        return;
    if (audit_is(audit_word(w, 1), "gran") && audit_is(audit_word(w, 2), "model"))
        keep_model(a, w, 3, 0);
    else if (audit_starts(audit_word(w, 1), "gran/hertz"))
        keep_model(a, w, -1, 0);
    else
        audit_remark(a, "this is no granular contact that cor knows:", audit_word(w, 1));
}

/* fix ID GROUP wall/gran model hertz ...; of a mesh each mesh has its type */
void audit_liggghts_wall(struct audit *a, const struct audit_words *w)
{
    if (audit_is(audit_word(w, 4), "model"))
        keep_model(a, w, 5, 1);
    else
        audit_remark(a, "cor does not know the wall", audit_word(w, 4));
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
    static const char *const models[][2] = {{"hertz", "hertz or hooke, coefficientRestitution"},
                                            {"hooke", "hertz or hooke, coefficientRestitution"},
                                            {"hertz/stiffness", "hertz/stiffness, gamman"},
                                            {"hooke/stiffness", "hooke/stiffness, gamman"}};
    const int stiff = strchr(style->model, '/') != NULL, hertz = audit_starts(style->model, "hertz");
    const struct audit_property *const number = property(a, stiff ? "gamman" : "coefficientRestitution"),
                                       *const speed = property(a, "characteristicVelocity"),
                                       *const kn = property(a, "kn");
    struct audit_contact *const contact = audit_add(a, "");
    const struct audit_contact fresh = *contact;
    *contact = *style;
    contact->text = fresh.text;
    for (size_t k = 0; k < sizeof models / sizeof *models; k++)
        if (audit_is(models[k][0], style->model))
            contact->model = models[k][1];
    contact->first[0] = contact->last[0] = i;
    contact->first[1] = contact->last[1] = j;
    if (!number || i >= number->types || j >= number->types) {
        contact->unknown = 1;
        contact->fault = stiff ? "gamman of these types could not be read."
                               : "coefficientRestitution of these types "
                                 "could not be read.";
        return;
    }
    contact->file = number->file;
    contact->line = number->line;
    contact->text = number->text;
    contact->number = value_of(number, i * number->types + j);
    if (!stiff) {
        contact->word[0] = number->word + i * number->types + j;
        contact->word[1] = number->word + j * number->types + i;
        contact->spring = hertz ? AUDIT_MATERIAL : AUDIT_CHARACTERISTIC;
        contact->speed = value_of(speed, 0);
    } else {
        contact->spring = hertz ? AUDIT_HERTZ : AUDIT_HOOKE;
        contact->stiffness = kn ? value_of(kn, i * kn->types + j) : (double)NAN;
    }
}

/* Replaces each model by its pairs of types. */
void audit_liggghts_pairs(struct audit *a)
{
    const struct audit_property *const young = property(a, "youngsModulus"), *const poisson =
                                                                                 property(a, "poissonsRatio");
    const struct audit_property *const e = property(a, "coefficientRestitution"), *const kn = property(a, "gamman");
    const int styles = a->contacts;
    int types = a->types;
    if (types == 0)
        types = e ? e->types : kn ? kn->types : 1;
    for (int i = 0; i < types && i < AUDIT_TYPES; i++) {
        a->type[i].young = value_of(young, i);
        a->type[i].poisson = value_of(poisson, i);
    }
    a->types = types;
    for (int n = 0; n < styles; n++) {
        const struct audit_contact style = a->contact[n];
        const int last = style.wall ? style.last[1] : types - 1;
        for (int i = 0; i < types; i++)
            for (int j = style.wall ? style.first[1] : i; j <= last; j++)
                add_pair(a, &style, i, j);
    }
    memmove(a->contact, a->contact + styles, (size_t)(a->contacts - styles) * sizeof *a->contact);
    a->contacts -= styles;
}
