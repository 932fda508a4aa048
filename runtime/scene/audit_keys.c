/* SPDX-License-Identifier: MIT */
/* Inputs of keywords with values: YADE's Python, Kratos' JSON, MFiX' namelist, MuJoCo's XML */
#include <math.h>
#include <string.h>

#include "runtime/scene/audit.h"
#include "runtime/scene/exponents.h"

/* ---- keywords ---- */

/* The text behind `word` where it stands as a name of its own, from `at` on; NULL: nowhere */
static const char *behind(const char *at, const char *word)
{
    const size_t size = strlen(word);
    for (const char *found = at; (found = strstr(found, word)) != NULL; found++)
        if ((found == at || !audit_is_of_name(found[-1]) || found[-1] == '.') && !audit_is_of_name(found[size]))
            return found + size;
    return NULL;
}

/* The value of `key` in "key = value, ..." or "key": value; NULL: the key is not there. A closing bracket ends it. */
static const char *value_of(const char *text, const char *key, size_t *size)
{
    for (const char *at = text; (at = behind(at, key)) != NULL;) {
        const char *value = at;
        int depth = 0;
        while (audit_is_space(*value) || *value == '"')
            value++;
        if ((*value != '=' && *value != ':') || value[1] == '=')
            continue;
        for (value++; audit_is_space(*value); value++)
            ;
        const char quote = *value == '"' || *value == '\'' ? *value++ : '\0', *end = value;
        for (; *end; end++) {
            depth += (strchr("([{", *end) != NULL) - (strchr(")]}", *end) != NULL);
            if (quote ? *end == quote : depth < 0 || (depth == 0 && *end == ','))
                break;
        }
        while (end > value && audit_is_space(end[-1]))
            end--;
        *size = (size_t)(end - value);
        return value;
    }
    return NULL;
}

static int has(const char *text, const char *key)
{
    size_t size;
    return value_of(text, key, &size) != NULL;
}

static int has_value(const char *text, const char *key, const char *value)
{
    size_t size = 0;
    const char *const found = value_of(text, key, &size);
    return found && size == strlen(value) && strncmp(found, value, size) == 0;
}

static const char *kept_value(struct audit *a, const char *text, const char *key)
{
    size_t size = 0;
    const char *const found = value_of(text, key, &size);
    return found ? audit_keep(a, found, size) : "";
}

/* The number of `key`, or `otherwise` where the key is not there; NaN after a remark: it is no number. */
static double number_of(struct audit *a, const char *text, const char *key, double otherwise)
{
    size_t size = 0;
    const char *const found = value_of(text, key, &size);
    if (!found)
        return otherwise;
    const double value = audit_value_of(a, found, size);
    if (isnan(value))
        audit_remark(a, "this is no number that can be read:", key);
    return value;
}

/* A contact of the present line; the number that it asks for stands at `value` in `text`. */
static struct audit_contact *add(struct audit *a, const char *text, const char *value, size_t size)
{
    int words = 0;
    char *const copy = a->instead;
    size_t used = 0;
    for (const char *at = text + strspn(text, " \t\n"); *at && used + 3 < sizeof a->instead; at++) {
        if (at == value || (value && at == value + size))
            copy[used++] = ' ';
        copy[used] = audit_is_space(*at) ? ' ' : *at;
        if (value && at < value && copy[used] != ' ' && (used == 0 || copy[used - 1] == ' '))
            words++;
        used++;
    }
    copy[used] = '\0';
    struct audit_contact *const contact = audit_add(a, copy);
    contact->word[0] = value ? words : -1;
    if (value)
        contact->number = audit_value_of(a, value, size);
    return contact;
}

/* The type of this name, a new one if there is none yet */
static int type_of(struct audit *a, const char *name)
{
    for (int i = 0; i < a->types; i++)
        if (audit_is(a->type[i].name, name))
            return i;
    if (a->types == AUDIT_TYPES) {
        audit_remark(a, "more materials than can be read:", name);
        return AUDIT_TYPES - 1;
    }
    a->type[a->types].name = name;
    return a->types++;
}

static void between(struct audit *a, struct audit_contact *contact, int i, int j)
{
    audit_between(contact, i, j);
    contact->pair = audit_kept(a, "$-$", a->type[i].name, a->type[j].name);
}

/* ---- YADE ---- */

/* The arguments of the next call of `name` from *at on, in a->split, and its line; *at is behind them. */
static const char *arguments(struct audit *a, const char **at, const char *name, long first_line)
{
    for (const char *found = *at; (found = behind(found, name)) != NULL;) {
        const char *const from = found + strspn(found, " \t\r\n\f\v"), *end = from;
        int depth = 0;
        if (*from != '(')
            continue;
        for (; *end; end++) {
            depth += (*end == '(') - (*end == ')');
            if (depth == 0)
                break;
        }
        a->split[0] = '\0';
        audit_append(a->split, (size_t)(end - from), "$", from + 1);
        *at = *end ? end + 1 : end;
        a->line = first_line;
        for (const char *c = a->raw; c < found; c++)
            a->line += *c == '\n';
        return a->split;
    }
    return NULL;
}

/* name(arguments), with the value of `key` as its number */
static struct audit_contact *add_call(struct audit *a, const char *name, const char *text, const char *key)
{
    char call[AUDIT_LINE] = "";
    size_t size = 0;
    audit_append(call, sizeof call, "$($)", name, text);
    const char *value = value_of(call, key, &size);
    if (value && audit_starts(value, "MatchMaker")) {
        size_t inner = 0;
        const char *const single = value_of(value, "val", &inner);
        if (single && single < value + size) {
            value = single;
            size = inner;
        }
    }
    struct audit_contact *const contact = add(a, call, value, size);
    if (value && isnan(contact->number))
        audit_unknown(contact, "Its number could not be read.");
    return contact;
}

/* ViscElMat(...) and FrictMat(...); without a number those of YADE's classes: young 1e9, poisson 0.25, density 1000 */
static void read_yade_material(struct audit *a, const char *name, const char *text)
{
    const char *const label = kept_value(a, text, "label");
    const int type = type_of(a, *label ? label : audit_kept(a, "material %", (double)(a->types + 1)));
    a->type[type].density = number_of(a, text, "density", 1000);
    if (audit_is(name, "FrictMat")) {
        a->type[type].young = number_of(a, text, "young", 1e9);
        a->type[type].poisson = number_of(a, text, "poisson", 0.25);
        return;
    }
    const int by_time = has(text, "tc"), by_spring = has(text, "kn");
    struct audit_contact *const contact = add_call(a, name, text, by_spring ? "cn" : "en");
    between(a, contact, type, type);
    contact->model = by_spring ? "ViscElMat, kn and cn" : "ViscElMat, tc and en";
    contact->spring = by_spring ? AUDIT_HOOKE : AUDIT_CONTACT_TIME;
    contact->stiffness = by_spring ? number_of(a, text, "kn", 0) / 2 : number_of(a, text, "tc", 0);
    if (by_spring == by_time)
        audit_unknown(contact, by_time ? "The material has tc and kn." : "YADE solves for young and en by itself.");
    else if (isnan(contact->number))
        audit_unknown(contact, "The number of its damping is missing, or could not be read.");
    else if (by_time && !contact->fault)
        contact->fault = "At a wall or facet YADE halves kn and cn, and eps is larger.";
}

/* en=MatchMaker(matches=((0, 1, 0.5), ...)): a contact for each pair of YADE's numbers of materials. Returns 0 if there
 * are none. */
static int read_matches(struct audit *a, const char *name, const char *text)
{
    char call[AUDIT_LINE] = "";
    size_t size = 0, inner = 0;
    int found = 0;
    audit_append(call, sizeof call, "$($)", name, text);
    const char *const en = value_of(call, "en", &size), *const matches = en ? value_of(en, "matches", &inner) : NULL;
    if (!matches || matches > en + size)
        return 0;
    for (const char *at = matches; at < matches + inner; at += strcspn(at, "(") + (strchr(at, '(') != NULL)) {
        const char *const second = at + strcspn(at, ",()"), *const third =
                                                                second + 1 + strcspn(second + (*second != 0), ",()");
        if (*second != ',' || *third != ',')
            continue;
        const double i = audit_value_of(a, at, (size_t)(second - at)),
                     j = audit_value_of(a, second + 1, (size_t)(third - second) - 1);
        struct audit_contact *const contact = add(a, call, third + 1, strcspn(third + 1, ",()"));
        contact->pair = audit_kept(a, "%-%", i, j);
        contact->model = "Mindlin, en (2023 and later)";
        if (isnan(contact->number) || isnan(i) || isnan(j))
            audit_unknown(contact, "Its numbers could not be read.");
        found = 1;
    }
    return found;
}

static void read_mindlin(struct audit *a, const char *name, const char *text)
{
    if (read_matches(a, name, text))
        return;
    const int en = has(text, "en"), betan = has(text, "betan");
    struct audit_contact *const contact = add_call(a, name, text, en ? "en" : "betan");
    contact->model = en ? "Mindlin, en (2023 and later)" : "Mindlin, betan";
    contact->spring = AUDIT_MATERIAL;
    if (!en && !betan)
        contact->number = 0;
    if (en && betan)
        audit_unknown(contact, "It has en and betan.");
    else if (has(text, "vn"))
        audit_unknown(contact, "Its en holds at vn: the viscoelastic sphere of YADE 2025, which is not read.");
    else if (has(text, "gamma"))
        audit_unknown(contact, "The adhesion changes eps.");
}

/* The assignment of a name at the margin: what is indented may not happen. */
static void read_assignment(struct audit *a)
{
    static const char *const elsewhere[] = {"en", "betan", "tc", "kn", "cn", "damping"};
    char *const line = a->raw + strspn(a->raw, " \t");
    size_t size = 0;
    while (audit_is_of_name(line[size]))
        size++;
    const char *value = line + size + strspn(line + size, " \t");
    if (size == 0 || *value != '=' || value[1] == '=')
        return;
    const char *const name = audit_keep(a, line, size), *const dot = strrchr(name, '.');
    const double number = line == a->raw ? audit_value(a, value + 1) : (double)NAN;
    if (audit_is(name, "O.dt") || audit_is(name, "o.dt")) {
        audit_set_time_step(a, number);
        if (isnan(number))
            audit_note(a, "the time step is no number that can be read; give --time-step", NULL);
    }
    for (size_t i = 0; dot && i < sizeof elsewhere / sizeof *elsewhere; i++)
        if (audit_is(dot + 1, elsewhere[i]))
            audit_remark(a, "a number that is set outside of its constructor is not read:", name);
    struct audit_variable *const known = audit_variable_named(a, name, strlen(name));
    if (!isnan(number))
        audit_set_variable(a, name, audit_print(a, "@", number), 0);
    else if (known)
        *known = a->variable[--a->variables];
}

static void read_sphere(struct audit *a, const char *text, double radius[2])
{
    size_t size = 0;
    const char *value = value_of(text, "radius", &size), *at = text;
    int depth = 0;
    if (!value) { /* behind the centre */
        for (; *at && !(*at == ',' && depth == 0); at++)
            depth += (strchr("([{", *at) != NULL) - (strchr(")]}", *at) != NULL);
        value = *at ? at + 1 : at;
        size = strcspn(value, ",");
    }
    const double r = audit_value_of(a, value, size);
    if (isnan(r))
        audit_note(a, "the radius of a sphere is not read", NULL);
    radius[0] = radius[0] < r ? radius[0] : r;
    radius[1] = radius[1] > r ? radius[1] : r;
}

/* A contact of two bodies of FrictMat, for each pair of these materials: those that have a modulus */
static void add_pairs(struct audit *a, int n)
{
    const struct audit_contact contact = a->contact[n];
    int pairs = 0;
    for (int i = 0; i < a->types; i++)
        for (int j = i; j < a->types; j++) {
            if (isnan(a->type[i].young) || isnan(a->type[j].young))
                continue;
            struct audit_contact *const now = pairs++ == 0 ? &a->contact[n] : audit_add(a, "");
            *now = contact;
            between(a, now, i, j);
        }
}

void audit_yade(struct audit *a)
{
    static const struct {
        const char *name;
        void (*read)(struct audit *a, const char *name, const char *text);
    } calls[] = {{"ViscElMat", read_yade_material},
                 {"FrictMat", read_yade_material},
                 {"Ip2_FrictMat_FrictMat_MindlinPhys", read_mindlin}};
    double radius[2] = {(double)NAN, (double)NAN};
    const char *damped = NULL;
    while (audit_next_line(a, AUDIT_PYTHON)) {
        const long line = a->line;
        read_assignment(a);
        for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
            for (const char *at = a->raw, *text; (text = arguments(a, &at, calls[i].name, line)) != NULL;)
                calls[i].read(a, calls[i].name, text);
        for (const char *at = a->raw, *text; (text = arguments(a, &at, "sphere", line)) != NULL;)
            read_sphere(a, text, radius);
        for (const char *at = a->raw, *text; (text = arguments(a, &at, "NewtonIntegrator", line)) != NULL;)
            if (number_of(a, text, "damping", 0.2) != 0)
                damped = "NewtonIntegrator damps all motions (by 0.2 where nothing is said), and eps is smaller than "
                         "that of the contact: set damping=0.";
    }
    if (a->types == 0)
        a->types = 1;
    for (int i = 0; i < a->types; i++)
        memcpy(a->type[i].radius, radius, sizeof radius);
    for (int i = 0; damped && i < a->contacts; i++)
        audit_unknown(&a->contact[i], damped);
    for (int n = a->contacts - 1; n >= 0; n--)
        if (a->contact[n].spring == AUDIT_MATERIAL)
            add_pairs(a, n);
}

/* ---- Kratos ---- */

void audit_kratos(struct audit *a)
{
    static const struct {
        const char *law, *by_e, *by_gamma;
    } laws[] = {
        {"DEM_D_Hertz_viscous_Coulomb", "DEM Hertz, COEFFICIENT_OF_RESTITUTION", "DEM Hertz, DAMPING_GAMMA"},
        {"DEM_D_Linear_viscous_Coulomb", "DEM linear, COEFFICIENT_OF_RESTITUTION", "DEM linear, DAMPING_GAMMA"}};
    static const char *const numbers[] = {"COEFFICIENT_OF_RESTITUTION", "DAMPING_GAMMA"};
    int type = -1, pair[2] = {-1, -1}, law = -1, open = -1;
    while (audit_next_part(a, "{},", "")) {
        const char *const line = a->raw;
        size_t size = 0;
        const char *value = value_of(line, "material_name", &size);
        if (value) {
            type = type_of(a, audit_keep(a, value, size));
            pair[0] = pair[1] = type;
            law = open = -1;
        }
        if ((value = value_of(line, "material_names_list", &size)) != NULL) {
            char name[2][128] = {"", ""};
            int k = 0, quoted = 0;
            for (const char *at = value; k < 2 && at < value + size; at++) {
                char letter[2] = {*at, '\0'};
                if (*at != '"')
                    audit_append(name[k], quoted ? sizeof name[k] : 0, "$", letter);
                else
                    k += quoted && name[k][0], quoted = !quoted;
            }
            for (k = 0; k < 2; k++)
                pair[k] = type_of(a, audit_keep(a, name[k], strlen(name[k])));
            type = law = open = -1;
        }
        if (type >= 0) {
            struct audit_type *const t = &a->type[type];
            t->density = number_of(a, line, "PARTICLE_DENSITY", t->density);
            t->young = number_of(a, line, "YOUNG_MODULUS", t->young);
            t->poisson = number_of(a, line, "POISSON_RATIO", t->poisson);
        }
        if (value_of(line, "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME", &size)) {
            for (law = 0; law < 2 && !has_value(line, "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME", laws[law].law);)
                law++;
            if (law == 2)
                audit_remark(a, "cor does not know the contact law",
                             kept_value(a, line, "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME"));
        }
        for (int gamma = 0; gamma < 2; gamma++)
            if ((value = value_of(line, numbers[gamma], &size)) != NULL && pair[0] >= 0) {
                struct audit_contact *const contact = add(a, line, value, size);
                between(a, contact, pair[0], pair[1]);
                contact->model = numbers[gamma];
                audit_unknown(contact, "The contact law of these materials is not read.");
                open = a->contacts - 1;
            }
        if (open >= 0 && law >= 0 && law < 2) {
            struct audit_contact *const contact = &a->contact[open];
            contact->model = contact->model == numbers[1] ? laws[law].by_gamma : laws[law].by_e;
            contact->spring = law == 0 ? AUDIT_MATERIAL : AUDIT_NO_SPRING;
            contact->unknown = isnan(contact->number);
            contact->fault = contact->unknown ? "Its number could not be read." : NULL;
            open = -1;
        }
    }
}

/* ---- MFiX ---- */

/* The elements of KEY(2) = 0.9, KEY(1:3) = 3*0.9 and KEY = 0.9 0.8, and where their values stand */
struct elements {
    int first;
    const char *at;
};

static double next_element(struct audit *a, struct elements *e, const char **value, size_t *size)
{
    while (audit_is_space(*e->at) || *e->at == ',')
        e->at++;
    *value = e->at;
    *size = strcspn(e->at, ", \t");
    e->at += *size;
    return audit_value_of(a, *value, *size);
}

/* Whether the line sets `key`, in upper or lower case */
static int elements_of(struct audit *a, const char *key, struct elements *e)
{
    const char *at = a->raw + strspn(a->raw, " \t");
    for (; *key; key++, at++)
        if ((*at >= 'a' && *at <= 'z' ? *at - 'a' + 'A' : *at) != *key)
            return 0;
    at += strspn(at, " \t");
    e->first = 1;
    if (*at == '(') {
        const double index = audit_value_of(a, at + 1, strcspn(at + 1, ":,)"));
        e->first = index >= 1 && index <= 1000 ? (int)index : 0;
        at += strcspn(at, ")");
        at += *at == ')';
        at += strspn(at, " \t");
    }
    e->at = at + 1;
    return *at == '=';
}

/* MFiX takes a 50th, or another fraction, of the shortest contact of two particles with linear springs. */
static void set_mfix_step(struct audit *a, double stiffness, double factor)
{
    double shortest = INFINITY;
    for (const struct audit_contact *c = a->contact; c < a->contact + a->contacts; c++) {
        if (c->wall || c->unknown)
            continue;
        double inverse = 0;
        for (int k = 0; k < 2; k++) {
            const struct audit_type *const t = &a->type[c->first[k]];
            inverse += 3 / (4 * COR_PI * pow(t->radius[0], 3) * t->density);
        }
        const double l = log(c->number), duration = sqrt((COR_PI * COR_PI + l * l) / (inverse * stiffness));
        if (duration < shortest || isnan(duration)) /* NaN stays: what is not known may be the shortest */
            shortest = duration;
    }
    if (shortest < INFINITY)
        audit_set_time_step(a, shortest / factor);
}

void audit_mfix(struct audit *a)
{
    enum { DIAMETER, PHASES = 9, NUMBERS };
    static const char *const keys[NUMBERS] = {"D_P0",       "RO_S0", "E_YOUNG", "V_POISSON",      "EW_YOUNG",
                                              "VW_POISSON", "KN",    "KN_W",    "DTSOLID_FACTOR", "MMAX"};
    double stiffness[2] = {(double)NAN, (double)NAN};
    struct audit_type wall = {"wall", {(double)NAN, (double)NAN}, (double)NAN, (double)NAN, (double)NAN};
    double factor = 50, phase_count;
    int hertz = 0, phases = 1;
    const char *fault = NULL, *value;
    size_t size;
    struct elements e;
    while (audit_next_line(a, AUDIT_NAMELIST)) {
        for (int k = 0; k < NUMBERS; k++) {
            if (!elements_of(a, keys[k], &e))
                continue;
            for (int i = e.first - 1; *e.at; i++) {
                const double number = next_element(a, &e, &value, &size);
                if (isnan(number) || i < 0 || i >= AUDIT_TYPES) {
                    if (size > 0)
                        audit_remark(a, "this is no number that can be read:", keys[k]);
                    break;
                }
                struct audit_type *const t = &a->type[i];
                double *const numbers[NUMBERS] = {&t->radius[0], &t->density,   &t->young,     &t->poisson,
                                                  &wall.young,   &wall.poisson, &stiffness[0], &stiffness[1],
                                                  &factor,       &phase_count};
                *numbers[k] = number;
                if (k == DIAMETER)
                    t->radius[0] = t->radius[1] = number / 2;
                else if (k == PHASES)
                    phases = number >= 1 && number < AUDIT_TYPES ? (int)number : phases;
            }
        }
        for (int of_wall = 0; of_wall < 2; of_wall++) {
            if (!elements_of(a, of_wall ? "DES_EN_WALL_INPUT" : "DES_EN_INPUT", &e))
                continue;
            for (int i = e.first; *e.at; i++) {
                int times = 1;
                next_element(a, &e, &value, &size);
                const char *const star = memchr(value, '*', size);
                if (size == 0)
                    break;
                if (star) {
                    const double repeated = audit_value_of(a, value, (size_t)(star - value));
                    times = repeated >= 1 && repeated <= AUDIT_TYPES ? (int)repeated : 1;
                    size -= (size_t)(star + 1 - value);
                    value = star + 1;
                }
                for (; times > 0; times--, i += times > 0) {
                    struct audit_contact *const contact = add(a, a->raw, value, size);
                    contact->wall = of_wall;
                    contact->word[0] = star ? -1 : contact->word[0];
                    contact->first[0] = i; /* of the elements, until the phases are known */
                }
            }
        }
        if (elements_of(a, "DES_COLL_MODEL", &e))
            hertz = strstr(e.at, "HERTZ") || strstr(e.at, "hertz");
        if (elements_of(a, "DES_INTG_METHOD", &e) && (strstr(e.at, "ADAMS") || strstr(e.at, "adams")))
            a->integrator = COR_NO_INTEGRATOR;
        if (elements_of(a, "UNITS", &e) && (strstr(e.at, "cgs") || strstr(e.at, "CGS"))) {
            a->length = 1e-2;
            a->mass = 1e-3;
        }
        if (elements_of(a, "USE_COHESION", &e) && (strstr(e.at, ".T") || strstr(e.at, ".t")))
            fault = "The cohesion changes eps.";
    }
    /* the elements of DES_EN_INPUT are the upper triangle of the phases, row by row */
    a->types = phases + 1;
    a->type[phases] = wall;
    for (int n = 0; n < a->contacts; n++) {
        struct audit_contact *const contact = &a->contact[n];
        int i = 0, j = contact->first[0] - 1;
        if (contact->wall) {
            i = j;
            j = phases;
        } else {
            for (; i < phases && j >= phases; i++)
                j -= phases - i - 1;
        }
        contact->model = hertz ? "DEM, HERTZIAN" : "DEM, LSD";
        contact->spring = hertz ? AUDIT_MATERIAL : AUDIT_HOOKE;
        contact->stiffness = stiffness[contact->wall];
        if (i < 0 || i >= phases || j < 0) {
            contact->first[0] = 0;
            audit_unknown(contact, "The phases that this element stands for could not be made out.");
            continue;
        }
        contact->first[0] = contact->last[0] = i;
        contact->first[1] = contact->last[1] = j;
        if (fault)
            audit_unknown(contact, fault);
        else if (isnan(contact->number))
            audit_unknown(contact, "Its number could not be read.");
    }
    if (!hertz)
        set_mfix_step(a, stiffness[0], factor);
}

/* ---- MuJoCo ---- */

/* solref and solimp of a geom, or of a class of defaults */
struct softness {
    const char *name;
    double solref[2], solimp[5];
    double touches[2]; /* contype, conaffinity */
    double condim;
};

static void read_numbers(struct audit *a, const char *tag, const char *key, double *number, int count)
{
    size_t size = 0;
    const char *at = value_of(tag, key, &size), *const end = at ? at + size : NULL;
    for (int i = 0; at && at < end && i < count; i++) {
        while (at < end && audit_is_space(*at))
            at++;
        const size_t length = strcspn(at, " \t\n\"'");
        if (length == 0)
            break;
        number[i] = audit_value_of(a, at, length);
        at += length;
    }
}

static void soften(struct audit *a, struct softness *s, const char *tag)
{
    read_numbers(a, tag, "solref", s->solref, 2);
    read_numbers(a, tag, "solimp", s->solimp, 5);
    read_numbers(a, tag, "condim", &s->condim, 1);
    read_numbers(a, tag, "contype", &s->touches[0], 1);
    read_numbers(a, tag, "conaffinity", &s->touches[1], 1);
}

static void add_geom(struct audit *a, const struct softness *s, const char *pair)
{
    const int direct = s->solref[0] <= 0;
    const double number = direct ? -s->solref[1] : s->solref[1];
    const double rate = 1 / (s->solref[0] * s->solref[1]), stiffness = direct ? -s->solref[0] : rate * rate;
    for (int i = 0; i < a->contacts; i++)
        if (a->contact[i].number == number && a->contact[i].stiffness == stiffness && !strchr(pair, '-') &&
            a->contact[i].condim == (int)s->condim &&
            (a->contact[i].impedance[2] > 0
                 ? a->contact[i].impedance[0] == s->solimp[0] && a->contact[i].impedance[1] == s->solimp[1] &&
                       a->contact[i].impedance[2] == s->solimp[2]
                 : s->solimp[0] == s->solimp[1]))
            return; /* the same as before */
    struct audit_contact *const contact = add(a, a->raw, NULL, 0);
    contact->pair = audit_kept(a, strchr(pair, '-') ? "$" : "$-$", pair, pair);
    contact->model =
        direct ? "solref (-stiffness, -damping), dmin = dmax" : "solref (timeconst, dampratio), dmin = dmax";
    contact->number = number;
    contact->spring = AUDIT_PER_MASS;
    contact->stiffness = stiffness;
    contact->condim = s->condim >= 1 && s->condim <= 6 ? (int)s->condim : 3;
    if (s->solimp[0] != s->solimp[1]) {
        memcpy(contact->impedance, s->solimp, sizeof contact->impedance);
        contact->fault = "solimp's dmin and dmax differ (0.9 and 0.95 where nothing is said): stiffness and damping "
                         "depend on the overlap, and eps on the speed.";
    }
    if (!(s->solimp[0] > 0 && s->solimp[1] > 0 && s->solimp[0] <= 1 && s->solimp[1] <= 1 && s->solimp[2] > 0))
        audit_unknown(contact, "Its solimp could not be read.");
    else if (contact->fault && (s->solimp[3] != 0.5 || s->solimp[4] != 2))
        audit_unknown(contact, "cor reads solimp with the midpoint 0.5 and the power 2 alone.");
    else if (isnan(number) || isnan(stiffness) || number < 0)
        audit_unknown(contact, "Its solref could not be read.");
}

struct model_file {
    struct softness class[AUDIT_PROPERTIES], child[AUDIT_DEPTH];
    int classes, parent[AUDIT_DEPTH], defaults, bodies;
    int elliptic; /* cones of friction; pyramids are the default */
};

static const struct softness *class_named(const struct model_file *m, const char *name,
                                          const struct softness *otherwise)
{
    for (int i = 0; *name && i < m->classes; i++)
        if (audit_is(m->class[i].name, name))
            return &m->class[i];
    return otherwise;
}

static void read_tag(struct audit *a, struct model_file *m)
{
    const char *const tag = a->raw, *const attributes = tag + strcspn(tag, " \t\n/>");
    const size_t size = (size_t)(attributes - tag), length = strlen(tag);
    const int closed = length > 0 && tag[length - 1] == '/';
    char name[32] = "";
    memcpy(name, tag, size < sizeof name ? size : 0);
    if (audit_is(name, "") && audit_starts(tag, "/default") && m->defaults > 0) {
        m->defaults--;
    } else if (audit_starts(tag, "/body") && m->bodies > 0) {
        m->bodies--;
    } else if (audit_is(name, "default") && m->classes < AUDIT_PROPERTIES && m->defaults < AUDIT_DEPTH) {
        const int from = m->defaults > 0 ? m->parent[m->defaults - 1] : 0;
        const char *const class = kept_value(a, attributes, "class");
        const int now = m->defaults == 0 ? 0 : m->classes++;
        m->class[now] = m->class[from];
        m->class[now].name = *class ? class : "main";
        if (!closed)
            m->parent[m->defaults++] = now;
    } else if (audit_is(name, "body") && m->bodies + 1 < AUDIT_DEPTH && !closed) {
        m->child[m->bodies + 1] = *class_named(m, kept_value(a, attributes, "childclass"),
                                               m->bodies > 0 ? &m->child[m->bodies] : &m->class[0]);
        m->bodies++;
    } else if (audit_is(name, "geom") && m->defaults > 0) {
        soften(a, &m->class[m->parent[m->defaults - 1]], attributes);
    } else if (audit_is(name, "geom")) {
        struct softness s =
            *class_named(m, kept_value(a, attributes, "class"), m->bodies > 0 ? &m->child[m->bodies] : &m->class[0]);
        const char *const own = kept_value(a, attributes, "name");
        soften(a, &s, attributes);
        if (s.touches[0] != 0 || s.touches[1] != 0)
            add_geom(a, &s, *own && !strchr(own, '-') ? own : "geom");
    } else if (audit_is(name, "pair")) {
        struct softness s = m->class[0];
        soften(a, &s, attributes);
        add_geom(a, &s, audit_kept(a, "$-$", kept_value(a, attributes, "geom1"), kept_value(a, attributes, "geom2")));
    } else if (audit_is(name, "option")) {
        audit_set_time_step(a, number_of(a, attributes, "timestep", a->time_step));
        m->elliptic = m->elliptic || has_value(attributes, "cone", "elliptic");
        if (has_value(attributes, "integrator", "RK4"))
            a->integrator = COR_NO_INTEGRATOR;
    } else if (audit_is(name, "flag") && has_value(attributes, "override", "enable")) {
        audit_remark(a, "the override of contacts by o_solref is not read", NULL);
    }
}

static void read_model(struct audit *a, void *model)
{
    struct model_file *const m = model;
    while (audit_next_part(a, ">", "<")) {
        size_t size = 0;
        const char *const file = audit_starts(a->raw, "include") ? value_of(a->raw, "file", &size) : NULL;
        if (file)
            audit_include(a, audit_keep(a, file, size), read_model, m);
        else
            read_tag(a, m);
    }
}

/* A solref of (timeconst, dampratio) is at least two time steps, which the flag refsafe turns off. */
void audit_mujoco(struct audit *a)
{
    struct model_file m;
    memset(&m, 0, sizeof m);
    const struct softness start = {"main", {0.02, 1}, {0.9, 0.95, 0.001, 0.5, 2}, {1, 1}, 3};
    m.class[0] = start;
    m.classes = 1;
    audit_set_time_step(a, 0.002);
    read_model(a, &m);
    for (int i = 0; i < a->contacts; i++) {
        struct audit_contact *const contact = &a->contact[i];
        if (contact->condim > 3 && !m.elliptic)
            audit_unknown(contact, "With condim 4 or 6 pyramidal cones of friction change eps: use elliptic ones.");
        const double frequency = sqrt(contact->stiffness), least = 1 / (2 * a->time_step * contact->number);
        if (strstr(contact->model, "timeconst") && !contact->unknown && frequency > least) {
            contact->stiffness = least * least;
            contact->fault = "MuJoCo raises timeconst to two time steps.";
        }
    }
}
