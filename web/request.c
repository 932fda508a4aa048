/* SPDX-License-Identifier: MIT */
/* Reads options as text into a request. Ranges and sentences are the same as in corgen. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "web/web.h"

struct web_request web_now;
struct web_wrong web_wrong;

__attribute__((format(printf, 2, 3))) static int refuse(const char *option, const char *format, ...)
{
    va_list arguments;
    snprintf(web_wrong.option, sizeof web_wrong.option, "%s", option);
    va_start(arguments, format);
    vsnprintf(web_wrong.text, sizeof web_wrong.text, format, arguments);
    va_end(arguments);
    return 0;
}

/* ---- numbers ---- */

/* Reads the text from `from` to `to`. Returns 0 if it is not a decimal number in the range of the option. */
static int is_number(double *value, const char *from, const char *to, const struct cor_scene_option *option)
{
    char *end;
    while (from < to && *from == ' ')
        from++;
    while (to > from && to[-1] == ' ')
        to--;
    /* strtod would also accept hexadecimal numbers, inf and nan */
    if (from == to || strspn(from, "0123456789.eE+-") < (size_t)(to - from))
        return 0;
    *value = strtod(from, &end);
    return end == to && cor_option_allows(option, *value);
}

static int read_number(double *value, const char *text, const struct cor_scene_option *option)
{
    return is_number(value, text, text + strlen(text), option) ||
           refuse(option->name, "--%s: '%s' is not %s; write it as 0.1 or 1.5e-3", option->name, text, option->allowed);
}

static int read_viscosity(double eta[2], const char *text, const struct cor_scene_option *option)
{
    const char *const comma = strchr(text, ',');
    if (comma && is_number(&eta[0], text, comma, option) && is_number(&eta[1], comma + 1, text + strlen(text), option))
        return 1;
    return refuse(
        option->name,
        "--%s: '%s' is not two numbers, 0 or more, with a comma between them: ETA1,ETA2 in Pa s, for example 1e3,2e3",
        option->name, text);
}

static int read_speeds(struct web_request *r, const char *option, const char *text)
{
    r->speeds = 0;
    for (const char *from = text;; from++) {
        const char *const to = from + strcspn(from, ",");
        if (r->speeds == WEB_SPEEDS ||
            !is_number(&r->speed_m_s[r->speeds++], from, to, &cor_scene_options[COR_SCENE_AT]))
            return refuse(option,
                          "--%s: '%.*s' is not a finite number above 0 in m/s; allowed: up to %d numbers with commas, "
                          "for example 0.1,1,10",
                          option, (int)(to - from), from, WEB_SPEEDS);
        from = to;
        if (*from == '\0')
            return 1;
    }
}

/* ---- words ---- */

/* Returns the index of a word in a list that ends with NULL; -1 and a refusal if it is absent. */
static int find_word(const char *option, const char *noun, const char *text, const char *const *words)
{
    char allowed[300] = "";
    for (int i = 0; words[i]; i++) {
        if (strcmp(text, words[i]) == 0)
            return i;
        snprintf(allowed + strlen(allowed), sizeof allowed - strlen(allowed), "%s%s", i > 0 ? ", " : "", words[i]);
    }
    refuse(option, "--%s: '%s' is not %s; allowed: %s", option, text, noun, allowed);
    return -1;
}

static int read_law(struct web_request *r, const char *text)
{
    const char *words[COR_LAW_PLATE + 2] = {NULL};
    for (int law = 0; law <= COR_LAW_PLATE; law++)
        words[law] = cor_law_name((enum cor_law)law);
    const int law = find_word("law", "a law", text, words);
    r->law = (enum cor_law)(law < 0 ? 0 : law);
    return law >= 0;
}

static int read_adhesion(struct web_request *r, const char *text)
{
    r->scene.adhesion_model =
        1 + find_word("adhesion-model", "a model of adhesion", text, (const char *const[]){"dmt", "jkr", NULL});
    return r->scene.adhesion_model != COR_ADHESION_NONE;
}

static int read_end(struct web_request *r, const char *text)
{
    const int end = find_word("end", "an end of contact", text,
                              (const char *const[]){"zero-overlap", "zero-force", "surface", NULL});
    r->at_surface = end == 2;
    r->scene.end = end == 0 ? COR_END_ZERO_OVERLAP : COR_END_ZERO_FORCE;
    return end >= 0;
}

static int read_simulator(struct web_request *r, const char *text)
{
    char why[COR_SIMULATOR_REASON];
    const struct cor_simulator_request unknown = {.simulator = text};
    r->simulator = cor_simulator_named(text);
    if (r->simulator)
        return 1;
    cor_simulator_lines(why, sizeof why, &unknown);
    return refuse("for", "%s", why);
}

/* ---- options ---- */

static int read_option(struct web_request *r, const char *name, const char *value)
{
    const struct {
        const char *name;
        double *value;
        int like; /* the number of a scene that has the same range */
    } own[] = {{"steps", &r->steps, COR_SCENE_AT},
               {"speed-min", &r->speed_min_m_s, COR_SCENE_AT},
               {"speed-max", &r->speed_max_m_s, COR_SCENE_AT},
               {"tolerance", &r->tolerance, COR_SCENE_RESTITUTION}};
    r->steps_given = r->steps_given || strcmp(name, "steps") == 0;
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (strcmp(name, own[i].name) == 0) {
            struct cor_scene_option option = cor_scene_options[own[i].like];
            option.name = own[i].name;
            return read_number(own[i].value, value, &option) &&
                   (r->steps >= 1 || refuse("steps", "--steps: '%s' is not a number, 1 or more", value));
        }
    if (strcmp(name, "speed") == 0)
        return read_speeds(r, name, value);
    if (strcmp(name, "law") == 0)
        return read_law(r, value);
    if (strcmp(name, "end") == 0)
        return read_end(r, value);
    if (strcmp(name, "for") == 0)
        return read_simulator(r, value);
    if (strcmp(name, "simulator-version") == 0)
        return snprintf(r->version, WEB_VALUE, "%s", value) > 0;
    if (strcmp(name, "adhesion-model") == 0)
        return read_adhesion(r, value);
    if (strcmp(name, "wall") == 0)
        return r->scene.wall = 1;
    for (int number = 0; number < COR_SCENE_NUMBERS; number++) {
        const struct cor_scene_option *const option = &cor_scene_options[number];
        if (strcmp(name, option->name) != 0 || strncmp(name, "bulk", 4) == 0)
            continue;
        if (number == COR_SCENE_VISCOSITY || number == COR_SCENE_VISCOSITY_2)
            return read_viscosity(&r->scene.number[number], value, option);
        return read_number(&r->scene.number[number], value, option);
    }
    return refuse(name, "'%s' is not an option; allowed: the options of corgen contact, for example young", name);
}

/* Returns the option at which the page shows a fault: the wrong or the missing option. */
static const char *option_of(const struct cor_scene_fault *fault)
{
    static const char *const options[] = {
        [COR_FAULT_MATERIAL] = "young",     [COR_FAULT_NO_SPEED] = "at",       [COR_FAULT_SPEED_ALONE] = "at",
        [COR_FAULT_NO_WAY] = "restitution", [COR_FAULT_RANGE] = "restitution", [COR_FAULT_NO_DAMPING] = "restitution",
        [COR_FAULT_WALL] = "wall",          [COR_FAULT_PLATE_END] = "end",     [COR_FAULT_SOLVER] = "law",
        [COR_FAULT_NOT_HERTZ] = "law"};
    const size_t i = (size_t)fault->fault;
    return i < sizeof options / sizeof *options && options[i] ? options[i] : cor_scene_options[fault->number].name;
}

static int make_contact(struct web_request *r)
{
    char why[COR_SCENE_FAULT_TEXT];
    struct cor_scene_fault fault = {0, 0, 0, 0};
    r->scene.law = cor_law_exponents[r->law];
    r->scene.plate = r->law == COR_LAW_PLATE;
    if (cor_scene_contacts(r->contact, &r->count, &fault, &r->scene) != COR_FAULT_NONE) {
        cor_scene_fault_text(why, sizeof why, &fault, cor_law_name(r->law), NULL);
        return refuse(option_of(&fault), "%s", why);
    }
    if (r->scene.end == COR_END_ZERO_FORCE && r->at_surface != (r->contact[0].force_n > 0))
        return refuse("end", r->at_surface
                                 ? "--end surface needs a constant force; without a force write --end zero-force"
                                 : "--end zero-force does not apply under a constant force; write --end surface");
    return r->speed_min_m_s < r->speed_max_m_s ||
           refuse("speed-max", "--speed-min %g is not below --speed-max %g", r->speed_min_m_s, r->speed_max_m_s);
}

/* Reads options, lines NAME=VALUE. Returns the number of contacts; 0, with web_now unchanged, for a wrong option. */
WEB_EXPORT(web_read) int web_read(const char *options)
{
    static struct web_request r;
    r = (struct web_request){.steps = 50, .tolerance = 1e-6, .speed_min_m_s = 1e-3, .speed_max_m_s = 10};
    r.scene.end = COR_BOTH_ENDS;
    for (int i = 0; i < COR_SCENE_NUMBERS; i++)
        r.scene.number[i] = NAN;
    for (const char *line = options; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        char name[WEB_NAME], value[WEB_VALUE];
        const size_t length = strcspn(line, "\n"), to = strcspn(line, "=\n");
        snprintf(name, sizeof name, "%.*s", (int)to, line);
        if (length > to && to < sizeof name && length - to - 1 < sizeof value) {
            snprintf(value, sizeof value, "%.*s", (int)(length - to - 1), line + to + 1);
            if (*value && !read_option(&r, name, value))
                return 0;
        } else if (length > 0) {
            return refuse(name, "an option is NAME=VALUE; this value has more than %d characters", WEB_VALUE - 1);
        }
    }
    if (!make_contact(&r))
        return 0;
    web_now = r;
    return r.count;
}

/* Returns the wrong option (part 0), or the reason (part 1). */
WEB_EXPORT(web_why) const char *web_why(int part)
{
    return part == 0 ? web_wrong.option : web_wrong.text;
}
