/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* open_memstream */
#include "contact/contact_host.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "hosts/hosts.h"
#include "support/console.h"

enum { TEXT_DIGITS = 12, REASON = 600 };

/* ---- the hosts ---- */

/* Names of --for that differ from those of the table */
static const char *host_name(const char *name)
{
    return strcmp(name, "esys") == 0 ? "esys-particle" : name;
}

static bool row_is_of(const struct host_model *row, const char *host)
{
    return row->paste && strcmp(row->host, host_name(host)) == 0;
}

/* The first row with lines of this row's host */
static bool row_is_first(const struct host_model *row)
{
    for (const struct host_model *other = host_models; other < row; other++)
        if (row_is_of(other, row->host))
            return false;
    return row->paste != NULL;
}

static const char *option_name(const char *host)
{
    return strcmp(host, "esys-particle") == 0 ? "esys" : host;
}

void contact_host_list(FILE *file)
{
    for (const struct host_model *first = host_models; first < host_models + host_model_count; first++) {
        if (!row_is_first(first))
            continue;
        fprintf(file, "%s\n", option_name(first->host));
        for (const struct host_model *row = first; row < host_models + host_model_count; row++)
            if (row_is_of(row, first->host))
                fprintf(file, "    %s (%s, ends at %s; %s)\n", row->model, host_law_name(row->law),
                        host_end_name(row->end), row->version);
    }
}

const char *const contact_host_names[] = {
    "lammps", "liggghts", "yade",   "mercurydpm", "chrono", "mfix",    "openfoam",        "esys",
    "drake",  "simbody",  "mujoco", "modelica",   "bullet", "rebound", CONTACT_HOST_LIST, NULL};

int contact_host_check(const char *host)
{
    char names[256] = "";
    for (const char *const *name = contact_host_names; *name; name++) {
        if (strcmp(*name, host) == 0)
            return STATUS_OK;
        const size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "", *name);
    }
    return usage_error("--for: '%s' is not a simulator that corgen knows; allowed: %s", host, names);
}

/* ---- what a contact asks of a row ---- */

struct asked {
    const struct contact_request *request;
    const struct contact_models *models;
    const struct contact_model *model; /* the first */
    double speed_m_s;                  /* one impact speed; NaN: none */
    double eps;                        /* eps to realise at that speed, or at every speed; NaN: depends on the end */
};

static bool law_is(const struct contact_model *model, double a, double b)
{
    return (double)model->law.a.num == a * (double)model->law.a.den &&
           (double)model->law.b.num == b * (double)model->law.b.den;
}

/* A row of Tsuji's law whose e serves a linear spring, too */
static bool row_has_hooke(const struct host_model *row)
{
    return row->damping_of_e && strstr(row->model, "ooke") != NULL;
}

static bool row_has_speed(const struct host_model *row)
{
    return row->paste && strstr(row->paste, "{embed}") != NULL;
}

/* Whether the lines of this row realise the law of the contact at every speed */
static bool row_has_law(const struct host_model *row, const struct contact_model *model)
{
    const bool linear = law_is(model, 1, 0);
    switch (row->law) {
    case HOST_LINEAR:
        return linear;
    case HOST_TSUJI:
        return law_is(model, 1.5, 0.25) || (linear && row_has_hooke(row));
    case HOST_LINEAR_ROOT:
        return law_is(model, 1, 0.5);
    case HOST_HERTZ_DASHPOT:
        return law_is(model, 1.5, 0);
    case HOST_SPHERE:
        return law_is_sphere(&model->law) && (!model->plate || row->end == HOST_ZERO_OVERLAP);
    case HOST_HUNT_CROSSLEY:
        return law_is_hunt_crossley(&model->law);
    case HOST_IMPULSE:
        return contact_model_is_constant(model) != row_has_speed(row);
    default:
        return false;
    }
}

static bool host_has_law(const char *host, const struct contact_model *model)
{
    for (const struct host_model *row = host_models; row < host_models + host_model_count; row++)
        if (row_is_of(row, host) && row_has_law(row, model))
            return true;
    return false;
}

/* A row that can realise one eps: a law with a closed form, and the spring of the contact */
static bool row_has_one_eps(const struct host_model *row, const struct contact_model *model)
{
    const bool hertz = model->law.a.num * 2 == model->law.a.den * 3;
    if (row->law == HOST_IMPULSE)
        return !row_has_speed(row);
    if (row->law == HOST_HUNT_CROSSLEY || (row->law == HOST_TSUJI && row->damping_of_e))
        return true;
    return (row->law == HOST_TSUJI && hertz) || (row->law == HOST_LINEAR && law_is(model, 1, 0));
}

/* eps was given, and no end at which it was measured: the host is to realise it at its own end. */
static bool eps_is_wished(const struct asked *asked)
{
    return asked->request->number[CONTACT_RESTITUTION].text && asked->request->end == CONTACT_BOTH_ENDS;
}

/* The speed at which numbers are converted. Where the row has the contact's law, any speed gives the same lines. */
static double speed_of(const struct asked *asked)
{
    return isnan(asked->speed_m_s) ? 1 : asked->speed_m_s;
}

/* The row's damping for the contact; NaN if there is none */
static double damping_for_row(const struct asked *asked, const struct host_model *row, bool same_law)
{
    const struct contact_model *model = asked->model;
    const bool constant = contact_model_is_constant(model);
    if (!same_law || row->law == HOST_IMPULSE || (constant && eps_is_wished(asked)))
        return host_damping(row->law, row->end, asked->eps);
    if (asked->models->count > 1) {
        if (row->end != HOST_ZERO_OVERLAP && row->end != HOST_ZERO_FORCE)
            return (double)NAN;
        model = &asked->models->model[row->end == HOST_ZERO_FORCE ? END_ZERO_FORCE : END_ZERO_OVERLAP];
    }
    return constant ? model->damping : contact_model_beta(model, speed_of(asked));
}

static struct host_scene scene_of(const struct asked *asked)
{
    const struct contact_model *const model = asked->model;
    return (struct host_scene){model->mass_kg, model->stiffness, model->radius_m, speed_of(asked)};
}

/* The number of the row's lines, or NaN with the reason */
static double number_for_row(char reason[REASON], const struct asked *asked, const struct host_model *row,
                             bool same_law)
{
    const struct host_scene scene = scene_of(asked);
    const double damping = damping_for_row(asked, row, same_law);
    enum host_cure_status status;
    double least, most;
    if (row_has_speed(row))
        return 1; /* its lines have no number */
    if (isnan(damping)) {
        snprintf(reason, REASON,
                 "its end, %s, has no closed form of the damping: give --damping-coefficient C, or "
                 "--end with --restitution",
                 host_end_name(row->end));
        return (double)NAN;
    }
    if (row->number_of_damping) {
        const double number = row->number_of_damping(damping, &scene);
        if (isnan(number))
            snprintf(reason, REASON, "it needs %s: give bodies, or --stiffness and --effective-mass",
                     isnan(scene.mass_kg) ? "mass and stiffness" : "the effective radius");
        return number;
    }
    const double wished = host_eps(row->law, row->end, damping), cure = host_cure(row, wished, &status);
    if (!isnan(cure))
        return cure;
    host_reach(row, &least, &most);
    snprintf(
        reason, REASON, "no e realises %.6g, the e of this model reach %.6g to %.6g%s", wished, least, most,
        status == HOST_CURE_TOO_SMALL && row->end == HOST_ZERO_FORCE
            ? " (its formula is that of zero overlap, and its force ends at zero, so e^-2 = 0.1353 is the limit for "
              "every e'); set its damping coefficient instead, by --stiffness and --effective-mass, or wish a larger e"
            : "");
    return (double)NAN;
}

/* ---- lines ---- */

/* zeta and natural frequency fix MuJoCo's time constant; contact time and e' those of YADE. */
static double word_value(const char *word, const struct asked *asked, double number)
{
    static const double pi = 3.14159265358979323846;
    const struct contact_request *const r = asked->request;
    const double k = asked->model->stiffness, m = asked->model->mass_kg, radius = asked->model->radius_m;
    const double l = log(number);
    const struct {
        const char *word;
        double value;
    } words[] = {
        {"n", number},
        {"n/2", number / 2},
        {"root", sqrt(number)},
        {"K", k},
        {"2K", 2 * k},
        {"K/m", k / m},
        {"K/R", k / radius},
        {"R", radius},
        {"kn", k / sqrt(radius)},
        {"E", 0.75 * k / sqrt(radius)},
        {"2m", 2 * m},
        {"tc", sqrt(m / k * (pi * pi + l * l))},
        {"timeconst", sqrt(m / k) / number},
        {"young", embed_given(&r->scene, EMBED_YOUNG) ? embed_number(&r->scene, EMBED_YOUNG) : (double)NAN},
        {"poisson", embed_given(&r->scene, EMBED_POISSON) ? embed_number(&r->scene, EMBED_POISSON) : (double)NAN}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i].word, word) == 0)
            return words[i].value;
    return (double)NAN;
}

/* The command that writes a header for this contact: g* holds every law whose eps depends on the speed. */
static void print_embed(FILE *file, const struct asked *asked)
{
    const struct embed_request *const scene = &asked->request->scene;
    const int law = asked->model->plate ? EMBED_VISCOELASTIC : asked->request->law;
    fputs("corgen embed", file);
    if (scene->elastic || scene->damping)
        fprintf(file, " --elastic %s --damping %s", scene->elastic ? scene->elastic : "3/2",
                scene->damping ? scene->damping : "1/2");
    else if (law != EMBED_VISCOELASTIC)
        fprintf(file, " --law %s", embed_law_names[law]);
    fprintf(file,
            " --g-star %.15g --speed-min 1e-3 --speed-max 100 --tolerance 1e-6 --end %s --name cor_eps --output "
            "cor_eps.h",
            contact_model_g_star_m_s(asked->model),
            asked->request->end == END_ZERO_FORCE ? "zero-force" : "zero-overlap");
}

/* Writes the text of a word in braces; false if its number is not known. */
static bool print_word(FILE *file, const char *word, const struct asked *asked, double number)
{
    const bool hooke = law_is(asked->model, 1, 0);
    if (strcmp(word, "embed") == 0)
        return print_embed(file, asked), true;
    if (strcmp(word, "model") == 0)
        return fputs(hooke ? "hooke" : "hertz", file), true;
    if (strcmp(word, "Model") == 0)
        return fputs(hooke ? "Hooke" : "Hertz", file), true;
    if (strcmp(word, "spring") == 0) {
        fputs(hooke ? "hooke " : "hertz ", file);
        word = hooke ? "K" : "kn";
    }
    const double value = word_value(word, asked, number);
    fprintf(file, "%.*g", TEXT_DIGITS, value);
    return !isnan(value);
}

/* The lines of a template with its words replaced, malloc'ed; NULL if a number is not known. Braces of the host's
 * language hold a line break, and those of a template do not. */
static char *lines_of(const char *paste, const struct asked *asked, double number)
{
    char *text = NULL;
    size_t size;
    bool known = true;
    FILE *const file = open_memstream(&text, &size);
    while (*paste) {
        const char *const close = strchr(paste, '}');
        const size_t length = close ? (size_t)(close - paste) : 0;
        char word[16];
        if (*paste == '{' && length > 1 && length <= sizeof word && !memchr(paste, '\n', length)) {
            snprintf(word, sizeof word, "%.*s", (int)length - 1, paste + 1);
            known = print_word(file, word, asked, number) && known;
            paste = close + 1;
        } else {
            fputc(*paste++, file);
        }
    }
    fclose(file);
    if (known)
        return text;
    free(text);
    return NULL;
}

/* A line of comment in the host's language */
static void print_comment(FILE *file, const struct host_model *row, const char *text)
{
    const int open = (int)strcspn(row->paste, "|");
    fprintf(file, "%.*s %s%s\n", open, row->paste, text, strncmp(row->paste, "<!--", 4) == 0 ? " -->" : "");
}

/* What the host would realise if its user gave it eps as e */
static void print_own_maps(FILE *file, const char *host, const struct asked *asked, const struct host_model *comment)
{
    char text[REASON];
    if (isnan(asked->eps))
        return;
    for (const struct host_model *row = host_models; row < host_models + host_model_count; row++) {
        const double realised = host_realised(row, asked->eps);
        if (strcmp(row->host, host_name(host)) != 0 || !row->damping_of_e || row_has_speed(row))
            continue;
        if (isnan(realised))
            snprintf(text, sizeof text, "own map: %s (%s) refuses e = %.6g", row->model, row->version, asked->eps);
        else
            snprintf(text, sizeof text, "own map: %s (%s), given e = %.6g, realises %.6g", row->model, row->version,
                     asked->eps, realised);
        print_comment(file, comment, text);
    }
}

static void print_row(FILE *file, const struct host_model *row, const struct asked *asked, bool same_law, double number,
                      const char *lines)
{
    char text[REASON];
    snprintf(text, sizeof text, "%s: %s; made for %s; the contact ends at %s", row->host, row->model, row->version,
             host_end_name(row->end));
    print_comment(file, row, text);
    if (!same_law || (row->law == HOST_IMPULSE && !row_has_speed(row)) || contact_model_is_constant(asked->model))
        snprintf(text, sizeof text, "eps = %.6g%s", host_eps(row->law, row->end, damping_for_row(asked, row, same_law)),
                 same_law ? " at every speed" : "");
    else
        snprintf(text, sizeof text, "eps depends on the impact speed as that of the contact does");
    if (!same_law)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 ", at %.6g m/s alone: the host does not have this law", asked->speed_m_s);
    print_comment(file, row, text);
    print_comment(file, row, row->advice);
    const double eps = host_eps(row->law, row->end, damping_for_row(asked, row, same_law));
    if (row->damping_of_e && !row_has_speed(row) && !(fabs(number - eps) < 1e-7)) {
        snprintf(text, sizeof text, "e' = %.6g is given; e = %.6g would realise %.6g", number, eps,
                 host_realised(row, eps));
        print_comment(file, row, text);
    }
    fputs(strchr(lines, '|') + 1, file);
    fputs("\n", file);
}

/* ---- the text ---- */

/* The one speed, and eps there, at which a host without the law of the contact is to agree */
static int find_speed(struct asked *asked, const char *host, const double *speed_m_s, size_t speeds, bool has_law)
{
    const struct contact_request *const r = asked->request;
    const bool measured = r->number[CONTACT_RESTITUTION].text != NULL;
    const bool constant = contact_model_is_constant(asked->model);
    const double at = embed_given(&r->scene, EMBED_AT) ? embed_number(&r->scene, EMBED_AT) : (double)NAN;
    asked->speed_m_s = speeds == 1 ? speed_m_s[0] : at;
    asked->eps = (double)NAN;
    if (!has_law && isnan(asked->speed_m_s))
        return usage_error("%s does not have the law %s; its lines hold at one impact speed: give it by --speed G, as "
                           "--speed 1",
                           host, law_equation(&asked->model->law).text);
    if (measured && (constant || asked->speed_m_s == at)) {
        asked->eps = decimal_value(&r->number[CONTACT_RESTITUTION]);
        return STATUS_OK;
    }
    const bool differ = contact_model_ends_differ(asked->model);
    if (r->end == CONTACT_BOTH_ENDS && differ)
        return has_law || constant ? STATUS_OK
                                   : usage_error("eps of this contact at zero overlap differs from that at zero force; "
                                                 "give the one that %s is to realise: --end zero-overlap or zero-force",
                                                 host);
    if (isnan(asked->speed_m_s) && !constant)
        return STATUS_OK;
    return contact_model_eps(&asked->eps, asked->model, speed_of(asked),
                             r->end == END_ZERO_FORCE ? END_ZERO_FORCE : END_ZERO_OVERLAP);
}

/* Prints all rows that realise the contact. Returns their number; `refusal` becomes the reason of the first that does
 * not. */
static int print_rows(FILE *file, char refusal[REASON], const char *host, const struct asked *asked, bool has_law)
{
    const struct host_model *comment = NULL;
    int printed = 0;
    refusal[0] = '\0';
    for (const struct host_model *row = host_models; row < host_models + host_model_count; row++) {
        char reason[REASON] = "";
        if (!row_is_of(row, host) || !(has_law ? row_has_law : row_has_one_eps)(row, asked->model))
            continue;
        const double number = number_for_row(reason, asked, row, has_law);
        char *const lines = isnan(number) ? NULL : lines_of(row->paste, asked, number);
        if (lines) {
            print_row(file, row, asked, has_law, number, lines);
            comment = row;
            printed++;
        } else if (!*refusal) {
            snprintf(refusal, REASON, "%s, %s: %s", host, row->model,
                     *reason ? reason
                             : "it needs numbers that are not given: bodies, or --stiffness and --effective-mass");
        }
        free(lines);
    }
    if (comment && *refusal) {
        char text[2 * REASON];
        snprintf(text, sizeof text, "left out: %s", refusal);
        print_comment(file, comment, text);
    }
    if (comment)
        print_own_maps(file, host, asked, comment);
    return printed;
}

char *contact_host_text(const char *host, const struct contact_request *request, const struct contact_models *models,
                        const double *speed_m_s, size_t speeds)
{
    struct asked asked = {.request = request, .models = models, .model = &models->model[0]};
    const bool has_law = host_has_law(host, asked.model);
    char refusal[REASON];
    char *text = NULL;
    size_t size;
    if (find_speed(&asked, host, speed_m_s, speeds, has_law) != STATUS_OK)
        return NULL;
    FILE *const file = open_memstream(&text, &size);
    const int printed = print_rows(file, refusal, host, &asked, has_law);
    fclose(file);
    if (printed > 0)
        return text;
    if (*refusal)
        usage_error("%s", refusal);
    else
        usage_error("%s has no model for the law %s; corgen contact --for list names the laws of every model", host,
                    law_equation(&asked.model->law).text);
    free(text);
    return NULL;
}
