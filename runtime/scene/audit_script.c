/* SPDX-License-Identifier: MIT */
/* Scripts of LAMMPS and LIGGGHTS: variables, included files, bodies, time step and speeds */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "runtime/scene/audit.h"

/* ---- words ---- */

/* The value of a variable as LAMMPS writes it into a line; NULL if it has none */
static const char *variable_text(struct audit *a, const char *name, size_t size, char number[32])
{
    const struct audit_variable *const variable = audit_variable_named(a, name, size);
    if (!variable)
        return NULL;
    if (!variable->formula)
        return variable->text;
    const double value = audit_value(a, variable->text);
    number[0] = '\0';
    audit_append(number, 32, "@", value);
    return isnan(value) ? NULL : number;
}

/* The text that $x, ${name} or $(expression) at `*at` stands for, and *at after it */
static const char *substitute(struct audit *a, const char **at, char number[32])
{
    const char *start = *at + 1, *end = start;
    char inner[256] = "";
    if (*start != '{' && *start != '(') {
        *at = start + (*start != '\0');
        return variable_text(a, start, 1, number);
    }
    int depth = 0;
    do {
        depth += (*end == '(') + (*end == '{') - (*end == ')') - (*end == '}');
        end++;
    } while (depth > 0 && *end);
    *at = end;
    const size_t size = depth == 0 ? (size_t)(end - start) - 2 : 0;
    if (*start == '{')
        return variable_text(a, start + 1, size, number);
    if (size >= sizeof inner)
        return NULL;
    memcpy(inner, start + 1, size);
    char *const colon = strchr(inner, ':'); /* a format follows */
    if (colon)
        *colon = '\0';
    const double value = audit_value(a, inner);
    number[0] = '\0';
    audit_append(number, 32, "@", value);
    return isnan(value) ? NULL : number;
}

/* Puts the values of variables into a line. Returns 0 after a remark if one has none. */
static int expand(struct audit *a, char *out, size_t size, const char *line)
{
    size_t used = 0;
    char quote = '\0';
    while (*line) {
        char number[32];
        if (*line == '"' || *line == '\'')
            quote = quote == *line ? '\0' : quote ? quote : *line;
        if (*line == '$' && !quote) {
            const char *const start = line, *text = substitute(a, &line, number);
            if (!text) {
                char name[64] = "";
                memcpy(name, start, (size_t)(line - start) < sizeof name ? (size_t)(line - start) : sizeof name - 1);
                audit_remark(a, "no value is known here of", name);
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
static void split(struct audit_words *w)
{
    char *at = w->line, *to = w->line;
    w->count = 0;
    while (w->count < AUDIT_WORDS) {
        at += strspn(at, " \t\r\f\v");
        if (!*at)
            break;
        w->word[w->count++] = to;
        const char quote = *at == '"' || *at == '\'' ? *at++ : '\0';
        while (*at && (quote ? *at != quote : !strchr(" \t\r\f\v", *at)))
            *to++ = *at++;
        at += *at != '\0';
        *to++ = '\0';
    }
}

/* The words from `first` on with one blank between them */
const char *audit_joined(struct audit *a, const struct audit_words *w, int first)
{
    a->instead[0] = '\0';
    for (int i = first; i < w->count; i++)
        audit_append(a->instead, sizeof a->instead, i > first ? " $" : "$", w->word[i]);
    return a->instead;
}

const char *audit_keep_line(struct audit *a, const struct audit_words *w)
{
    const char *const text = audit_joined(a, w, 0);
    return audit_keep(a, text, strlen(text));
}

const char *audit_word(const struct audit_words *w, int i)
{
    return i >= 0 && i < w->count ? w->word[i] : "";
}

int audit_find(const struct audit_words *w, int from, const char *word)
{
    for (int i = from; i < w->count; i++)
        if (audit_is(w->word[i], word))
            return i;
    return -1;
}

double audit_number_at(const struct audit_words *w, int i)
{
    return i >= 0 && i < w->count ? audit_number(w->word[i]) : (double)NAN;
}

/* "3", "*", "2*", "*4" and "2*4" as types from 0 */
int audit_range(const char *word, int *first, int *last)
{
    const char *const star = strchr(word, '*');
    const double low = audit_number(word);
    *first = 0;
    *last = AUDIT_TYPES - 1;
    if (!star) {
        *first = *last = (int)(low >= 1 && low <= (double)AUDIT_TYPES ? low - 1 : 0);
        return low >= 1 && low <= (double)AUDIT_TYPES;
    }
    if (star > word)
        *first = atoi(word) - 1;
    if (star[1])
        *last = atoi(star + 1) - 1;
    return *first >= 0 && *first < AUDIT_TYPES && *last >= *first;
}

/* ---- units ---- */

static void set_units(struct audit *a, const char *style)
{
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
            if (isnan(a->options->time_step_s))
                a->time_step = units[i].step * a->time;
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

static void set_radius(struct audit *a, int type, double least, double largest)
{
    const double radius[2] = {least, largest};
    set_body(a, type, type, radius, (double)NAN);
}

/* group NAME type N: kept as a variable, whose name no script can use */
static const char *group_variable(struct audit *a, const char *name)
{
    a->pair[0] = '\0';
    audit_append(a->pair, sizeof a->pair, "group $", name);
    return a->pair;
}

static const char *group_types(struct audit *a, const char *name)
{
    const char *const variable = group_variable(a, name);
    const struct audit_variable *const types = audit_variable_named(a, variable, strlen(variable));
    return types ? types->text : NULL;
}

static void read_group(struct audit *a, const struct audit_words *w)
{
    if (audit_is(audit_word(w, 2), "type") && w->count == 4)
        audit_set_variable(a, group_variable(a, audit_word(w, 1)), audit_word(w, 3), 0);
}

/* set type N diameter D density RHO; set group all ... */
static void read_set(struct audit *a, const struct audit_words *w)
{
    const int diameter = audit_find(w, 3, "diameter");
    int density = audit_find(w, 3, "density"), first, last;
    if (density < 0)
        density = audit_find(w, 3, "density/disc");
    if (diameter < 0 && density < 0)
        return;
    double radius[2] = {audit_number_at(w, diameter + 1) / 2, 0};
    radius[1] = radius[0] = diameter < 0 ? (double)NAN : radius[0];
    const double rho = density < 0 ? (double)NAN : audit_number_at(w, density + 1);
    if ((diameter >= 0 && isnan(radius[0])) || (density >= 0 && isnan(rho))) {
        audit_remark(a, "the diameter or density is no number", NULL);
        return;
    }
    const char *const name = audit_word(w, 2), *const types = group_types(a, name);
    if (audit_is(audit_word(w, 1), "type") && audit_range(name, &first, &last))
        set_body(a, first, last, radius, rho);
    else if (audit_is(audit_word(w, 1), "group") && types && audit_range(types, &first, &last))
        set_body(a, first, last, radius, rho);
    else if (audit_is(audit_word(w, 1), "atom") || audit_is(name, "all"))
        set_body(a, 0, AUDIT_TYPES - 1, radius, rho);
    else
        audit_remark(a, "the types of this group are not known:", name);
}

/* LAMMPS makes atoms of diameter 1 and density 1. */
static void read_create_atoms(struct audit *a, const struct audit_words *w)
{
    static const double radius[2] = {0.5, 0.5};
    const double type = audit_number_at(w, 1);
    if (audit_is(a->simulator, "lammps") && type >= 1 && type <= (double)AUDIT_TYPES &&
        isnan(a->type[(int)type - 1].radius[0]))
        set_body(a, (int)type - 1, (int)type - 1, radius, isnan(a->type[(int)type - 1].density) ? 1 : (double)NAN);
}

static void read_pour(struct audit *a, const struct audit_words *w)
{
    const double type = audit_number_at(w, 5), kind = type - 1;
    const int diameter = audit_find(w, 6, "diam"), density = audit_find(w, 6, "dens"), speed = audit_find(w, 6, "vel");
    double radius[2] = {0.5, 0.5};
    if (!(type >= 1 && type <= (double)AUDIT_TYPES))
        return;
    if (diameter >= 0) {
        const char *const how = audit_word(w, diameter + 1);
        const int range = audit_is(how, "range"), poly = audit_is(how, "poly");
        radius[0] = radius[1] = audit_number_at(w, diameter + 2) / 2;
        if (range)
            radius[1] = audit_number_at(w, diameter + 3) / 2;
        if (poly) {
            const double sizes = audit_number_at(w, diameter + 2);
            radius[0] = INFINITY;
            radius[1] = 0;
            for (int i = 0; i < sizes && diameter + 3 + 2 * i < w->count; i++) {
                const double size = audit_number_at(w, diameter + 3 + 2 * i) / 2;
                radius[0] = size < radius[0] ? size : radius[0];
                radius[1] = size > radius[1] ? size : radius[1];
            }
        }
        if (!(radius[0] > 0 && radius[1] >= radius[0]))
            audit_remark(a, "diam is not read:", how);
    }
    const double least = density < 0 ? 1 : audit_number_at(w, density + 1),
                 most = density < 0 ? 1 : audit_number_at(w, density + 2);
    if (least != most)
        audit_remark(a, "a range of densities is not read", NULL);
    set_body(a, (int)kind, (int)kind, radius, least == most ? least : (double)NAN);
    if (speed >= 0)
        audit_add_speed(a, fabs(audit_number_at(w, speed + 5)) * a->length / a->time);
}

/* LIGGGHTS: fix ID all particletemplate/sphere SEED atom_type 1 density constant 2500 radius constant 0.005 */
static void read_template(struct audit *a, const struct audit_words *w)
{
    const double type = audit_number_at(w, audit_find(w, 4, "atom_type") + 1);
    const int kind = (int)(type >= 1 && type <= (double)AUDIT_TYPES ? type - 1 : 0);
    const int density = audit_find(w, 4, "density"), radius = audit_find(w, 4, "radius");
    const char *const how = audit_word(w, radius + 1);
    double least = audit_number_at(w, radius + 2);
    double largest = audit_is(how, "uniform") ? audit_number_at(w, radius + 3) : least;
    if (radius < 0 || !(audit_is(how, "constant") || audit_is(how, "uniform")) || isnan(least + largest))
        audit_remark(a, "the radius of the template is not read", NULL);
    else {
        const struct audit_type *const now = &a->type[kind];
        if (now->radius[0] < least)
            least = now->radius[0];
        if (now->radius[1] > largest)
            largest = now->radius[1];
        set_radius(a, kind, least, largest);
    }
    if (density >= 0 && audit_is(audit_word(w, density + 1), "constant"))
        a->type[kind].density = audit_number_at(w, density + 2);
}

static void read_velocity(struct audit *a, const struct audit_words *w, int set)
{
    double square = 0;
    for (int i = 0; i < 3; i++) {
        const double part = audit_number_at(w, set + 1 + i);
        square += isnan(part) ? 0 : part * part;
    }
    audit_add_speed(a, sqrt(square) * a->length / a->time);
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

static void read_variable(struct audit *a, const struct audit_words *w)
{
    const char *const name = audit_word(w, 1), *const style = audit_word(w, 2), *const value = audit_word(w, 3);
    const int formula = audit_is(style, "equal");
    struct audit_variable *const known = audit_variable_named(a, name, strlen(name));
    if (audit_is(style, "delete")) {
        if (known)
            *known = a->variable[--a->variables];
    } else if (audit_is(style, "loop")) {
        if (!known)
            audit_set_variable(a, name, w->count > 4 && !audit_is(audit_word(w, 4), "pad") ? value : "1", 0);
    } else if (audit_is(style, "index") || audit_is(style, "world") || audit_is(style, "universe") ||
               audit_is(style, "string") || audit_is(style, "getenv") || audit_is(style, "internal") || formula) {
        if (audit_is(style, "getenv") || w->count < 4)
            return;
        if (!known || formula || audit_is(style, "string")) /* LAMMPS keeps the first of the others */
            audit_set_variable(a, name, formula ? audit_joined(a, w, 3) : value, formula);
    }
}

static void execute(struct audit *a, const char *text);
static void read_lines(struct audit *a, void *context);

/* if CONDITION then COMMAND ... elif CONDITION COMMAND ... else COMMAND ... */
static void read_if(struct audit *a, const struct audit_words *w)
{
    char branch[AUDIT_ADVICE] = "";
    int taken = 0;
    for (int i = 1; i < w->count && !taken; i++) {
        const int first = i == 1 || audit_is(w->word[i], "elif"), last = audit_is(w->word[i], "else");
        if (!first && !last)
            continue;
        i += i > 1 && first;
        char condition[256] = "";
        const double value = last                                                       ? 1
                             : expand(a, condition, sizeof condition, audit_word(w, i)) ? audit_value(a, condition)
                                                                                        : (double)NAN;
        if (isnan(value)) {
            audit_remark(a, "the condition is not read, and neither branch is:", audit_word(w, i));
            return;
        }
        if (value == 0)
            continue;
        taken = 1;
        /* the words of w are overwritten by the first command that is executed */
        for (i += 1; i < w->count && !audit_is(w->word[i], "elif") && !audit_is(w->word[i], "else"); i++)
            if (!audit_is(w->word[i], "then"))
                audit_append(branch, sizeof branch, "$\n", w->word[i]);
    }
    for (char *at = branch, *end; (end = strchr(at, '\n')) != NULL; at = end + 1) {
        *end = '\0';
        if (a->depth++ < AUDIT_INCLUDES)
            execute(a, at);
        a->depth--;
    }
}

/* The pairs that no line names of its own */
static void end_of_system(struct audit *a)
{
    if (audit_is(a->simulator, "lammps"))
        audit_lammps_mix(a);
    else
        audit_liggghts_pairs(a);
}

static void clear_system(struct audit *a, const struct audit_words *w)
{
    (void)w;
    end_of_system(a);
    audit_flush(a);
    for (int i = 0; i < AUDIT_TYPES; i++) {
        struct audit_type *const type = &a->type[i];
        type->radius[0] = type->radius[1] = type->density = type->young = type->poisson = (double)NAN;
    }
    a->types = a->properties = a->speeds = 0;
}

static void read_fix(struct audit *a, const struct audit_words *w)
{
    const char *const style = audit_word(w, 3);
    const int lammps = audit_is(a->simulator, "lammps");
    if (audit_starts(style, "wall/gran"))
        (lammps ? audit_lammps_wall : audit_liggghts_wall)(a, w);
    else if (!lammps && audit_starts(style, "mesh/surface"))
        audit_liggghts_mesh(a, w);
    else if (audit_is(style, "property/global"))
        audit_liggghts_property(a, w);
    else if (audit_is(style, "pour"))
        read_pour(a, w);
    else if (audit_starts(style, "particletemplate/sphere"))
        read_template(a, w);
    else if (audit_starts(style, "insert/") && audit_find(w, 4, "vel") > 0 &&
             audit_is(audit_word(w, audit_find(w, 4, "vel") + 1), "constant"))
        read_velocity(a, w, audit_find(w, 4, "vel") + 1);
}

static void read_units(struct audit *a, const struct audit_words *w)
{
    set_units(a, audit_word(w, 1));
}

static void read_include(struct audit *a, const struct audit_words *w)
{
    char name[AUDIT_ADVICE] = ""; /* the words will be those of the included file */
    audit_append(name, sizeof name, "$", audit_word(w, 1));
    audit_include(a, name, read_lines, NULL);
}

static void read_timestep(struct audit *a, const struct audit_words *w)
{
    const double step = audit_number_at(w, 1);
    if (!(step > 0))
        audit_remark(a, "timestep is no number above 0:", audit_word(w, 1));
    else if (isnan(a->options->time_step_s))
        a->time_step = step * a->time;
}

static void read_create_box(struct audit *a, const struct audit_words *w)
{
    const double types = audit_number_at(w, 1);
    if (types >= 1 && types <= (double)AUDIT_TYPES)
        a->types = (int)types;
}

static void read_velocities(struct audit *a, const struct audit_words *w)
{
    if (audit_is(audit_word(w, 2), "set"))
        read_velocity(a, w, 2);
}

static void read_pair(struct audit *a, const struct audit_words *w)
{
    (audit_is(a->simulator, "lammps") ? audit_lammps_pair : audit_liggghts_pair)(a, w);
}

static const struct command {
    const char *name;
    void (*read)(struct audit *a, const struct audit_words *w);
    int expanded_later; /* by the branch that is taken */
} commands[] = {{"units", read_units, 0},           {"variable", read_variable, 0},
                {"include", read_include, 0},       {"if", read_if, 1},
                {"clear", clear_system, 0},         {"timestep", read_timestep, 0},
                {"create_box", read_create_box, 0}, {"set", read_set, 0},
                {"group", read_group, 0},           {"create_atoms", read_create_atoms, 0},
                {"velocity", read_velocities, 0},   {"fix", read_fix, 0},
                {"pair_style", read_pair, 0},       {"pair_coeff", read_pair, 0}};

/* Other commands do not matter to a contact, and neither do their variables. */
static void execute(struct audit *a, const char *text)
{
    struct audit_words *const w = &a->words;
    const char *const start = text + strspn(text, " \t");
    const size_t size = strcspn(start, " \t\r");
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        if (strlen(commands[i].name) != size || strncmp(start, commands[i].name, size) != 0)
            continue;
        w->line[0] = '\0';
        if (commands[i].expanded_later)
            audit_append(w->line, sizeof w->line, "$", text);
        else if (!expand(a, w->line, sizeof w->line, text))
            return;
        split(w);
        commands[i].read(a, w);
        return;
    }
}

static void read_lines(struct audit *a, void *context)
{
    (void)context;
    while (audit_next_line(a, AUDIT_SCRIPT))
        execute(a, a->raw);
}

void audit_script(struct audit *a)
{
    set_units(a, "lj");
    read_lines(a, NULL);
    end_of_system(a);
}
