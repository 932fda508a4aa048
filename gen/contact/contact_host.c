/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* open_memstream */
#include "contact/contact_host.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"

enum { TEXT_DIGITS = 12, REASON = 600 };

/* ---- the hosts ---- */

static const struct cor_simulator_model *const first_row = cor_simulator_models;
#define last_row (cor_simulator_models + cor_simulator_model_count)

/* Names of --for that differ from those of the table */
static const char *host_name(const char *name)
{
    return strcmp(name, "esys") == 0 ? "esys-particle" : name;
}

static bool row_is_of(const struct cor_simulator_model *row, const char *host)
{
    return row->lines && strcmp(row->simulator, host_name(host)) == 0;
}

/* The first row with lines of this row's host */
static bool row_is_first(const struct cor_simulator_model *row)
{
    for (const struct cor_simulator_model *other = first_row; other < row; other++)
        if (row_is_of(other, row->simulator))
            return false;
    return row->lines != NULL;
}

static const char *option_name(const char *host)
{
    return strcmp(host, "esys-particle") == 0 ? "esys" : host;
}

void contact_host_list(FILE *file)
{
    for (const struct cor_simulator_model *first = first_row; first < last_row; first++) {
        if (!row_is_first(first))
            continue;
        fprintf(file, "%s\n", option_name(first->simulator));
        for (const struct cor_simulator_model *row = first; row < last_row; row++)
            if (row_is_of(row, first->simulator))
                fprintf(file, "    %s (%s, ends at %s; %s)\n", row->model, cor_law_names[row->law],
                        cor_end_names[row->end], row->version);
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
    const struct embed_request *request;
    const struct contacts *contacts;
    struct cor_simulator_wish wish; /* eps to realise at that speed, or at every speed */
};

static bool host_has_law(const char *host, const struct cor_scene_contact *contact)
{
    for (const struct cor_simulator_model *row = first_row; row < last_row; row++)
        if (row_is_of(row, host) && cor_simulator_has_law(row, contact))
            return true;
    return false;
}

/* The number of the row's lines, or NaN with the reason */
static double number_for_row(char reason[REASON], const struct asked *asked, const struct cor_simulator_model *row,
                             bool same_law)
{
    enum cor_simulator_status status;
    double least, most;
    const double number = cor_simulator_number(row, &asked->wish, same_law, &status);
    if (status == COR_SIMULATOR_NO_CLOSED_FORM) {
        snprintf(reason, REASON,
                 "its end, %s, has no closed form of the damping: give --damping-coefficient C, or "
                 "--end with --restitution",
                 cor_end_names[row->end]);
    } else if (status == COR_SIMULATOR_NO_SCALES) {
        snprintf(reason, REASON, "it needs %s: give bodies, or --stiffness and --effective-mass",
                 isnan(asked->contacts->contact->mass_kg) ? "mass and stiffness" : "the effective radius");
    } else if (isnan(number)) {
        const double wished = cor_law_eps(row->law, row->end, cor_simulator_damping(row, &asked->wish, same_law));
        cor_simulator_reach(row, &least, &most);
        snprintf(reason, REASON, "no e realises %.6g, the e of this model reach %.6g to %.6g%s", wished, least, most,
                 status == COR_SIMULATOR_TOO_SMALL && row->end == COR_END_ZERO_FORCE
                     ? " (its formula is that of zero overlap, and its force ends at zero, so e^-2 = 0.1353 is the "
                       "limit for every e'); set its damping coefficient instead, by --stiffness and "
                       "--effective-mass, or wish a larger e"
                     : "");
    }
    return number;
}

/* ---- lines ---- */

/* The command that writes a header for this contact: g* holds every law whose eps depends on the speed. */
static void print_embed(FILE *file, const struct asked *asked)
{
    const struct embed_request *const request = asked->request;
    fputs("corgen embed", file);
    if (request->elastic || request->damping)
        fprintf(file, " --elastic %s --damping %s", request->elastic ? request->elastic : "3/2",
                request->damping ? request->damping : "1/2");
    else if (request->law != COR_LAW_VISCOELASTIC && request->law != COR_LAW_PLATE)
        fprintf(file, " --law %s", cor_law_names[request->law]);
    fprintf(file,
            " --g-star %.15g --speed-min 1e-3 --speed-max 100 --tolerance 1e-6 --end %s --name cor_eps --output "
            "cor_eps.h",
            cor_scene_damping(asked->contacts->contact, COR_SCENE_G_STAR),
            request->end == END_ZERO_FORCE ? "zero-force" : "zero-overlap");
}

/* Writes the text of a word in braces; false if its number is not known. */
static bool print_word(FILE *file, const char *word, const struct asked *asked, double number)
{
    const bool hooke = law_is_linear(&asked->contacts->law) && asked->contacts->law.bd == 0;
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
    const double value = cor_simulator_word(word, &asked->wish, number);
    fprintf(file, "%.*g", TEXT_DIGITS, value);
    return !isnan(value);
}

/* The lines of a template with its words replaced, malloc'ed; NULL if a number is not known. Braces of the host's
 * language hold a line break, and those of a template do not. */
static char *lines_of(const char *template, const struct asked *asked, double number)
{
    char *text = NULL;
    size_t size;
    bool known = true;
    FILE *const file = open_memstream(&text, &size);
    while (*template) {
        const char *const close = strchr(template, '}');
        const size_t length = close ? (size_t)(close - template) : 0;
        char word[16];
        if (*template == '{' && length > 1 && length <= sizeof word && !memchr(template, '\n', length)) {
            snprintf(word, sizeof word, "%.*s", (int)length - 1, template + 1);
            known = print_word(file, word, asked, number) && known;
            template = close + 1;
        } else {
            fputc(*template ++, file);
        }
    }
    fclose(file);
    if (known)
        return text;
    free(text);
    return NULL;
}

/* A line of comment in the host's language */
static void print_comment(FILE *file, const struct cor_simulator_model *row, const char *text)
{
    const int open = (int)strcspn(row->lines, "|");
    fprintf(file, "%.*s %s%s\n", open, row->lines, text, strncmp(row->lines, "<!--", 4) == 0 ? " -->" : "");
}

/* What the host would realise if its user gave it eps as e */
static void print_own_maps(FILE *file, const char *host, const struct asked *asked,
                           const struct cor_simulator_model *comment)
{
    char text[REASON];
    if (isnan(asked->wish.eps))
        return;
    for (const struct cor_simulator_model *row = first_row; row < last_row; row++) {
        const double realised = cor_simulator_realised(row, asked->wish.eps);
        if (strcmp(row->simulator, host_name(host)) != 0 || !row->damping_of_e || cor_simulator_has_function(row))
            continue;
        if (isnan(realised))
            snprintf(text, sizeof text, "own map: %s (%s) refuses e = %.6g", row->model, row->version, asked->wish.eps);
        else
            snprintf(text, sizeof text, "own map: %s (%s), given e = %.6g, realises %.6g", row->model, row->version,
                     asked->wish.eps, realised);
        print_comment(file, comment, text);
    }
}

static void print_row(FILE *file, const struct cor_simulator_model *row, const struct asked *asked, bool same_law,
                      double number, const char *lines)
{
    char text[REASON];
    snprintf(text, sizeof text, "%s: %s; made for %s; the contact ends at %s", row->simulator, row->model, row->version,
             cor_end_names[row->end]);
    print_comment(file, row, text);
    if (!same_law || (row->law == COR_LAW_IMPULSE && !cor_simulator_has_function(row)) ||
        law_is_linear(&asked->contacts->law))
        snprintf(text, sizeof text, "eps = %.6g%s",
                 cor_law_eps(row->law, row->end, cor_simulator_damping(row, &asked->wish, same_law)),
                 same_law ? " at every speed" : "");
    else
        snprintf(text, sizeof text, "eps depends on the impact speed as that of the contact does");
    if (!same_law)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 ", at %.6g m/s alone: the host does not have this law", asked->wish.speed_m_s);
    print_comment(file, row, text);
    print_comment(file, row, row->advice);
    const double eps = cor_law_eps(row->law, row->end, cor_simulator_damping(row, &asked->wish, same_law));
    if (row->damping_of_e && !cor_simulator_has_function(row) && !(fabs(number - eps) < 1e-7)) {
        snprintf(text, sizeof text, "e' = %.6g is given; e = %.6g would realise %.6g", number, eps,
                 cor_simulator_realised(row, eps));
        print_comment(file, row, text);
    }
    fputs(strchr(lines, '|') + 1, file);
    fputs("\n", file);
}

/* ---- the text ---- */

/* The one speed, and eps there, at which a host without the law of the contact is to agree */
static int find_speed(struct asked *asked, const char *host, const double *speed_m_s, size_t speeds, bool has_law)
{
    const struct contacts *const contacts = asked->contacts;
    const struct cor_scene *const scene = &contacts->scene;
    const bool constant = law_is_linear(&contacts->law);
    const double at = scene->number[COR_SCENE_AT], speed = speeds == 1 ? speed_m_s[0] : at;
    asked->wish = (struct cor_simulator_wish){scene, contacts->contact, contacts->count, speed, (double)NAN, 0};
    if (!has_law && isnan(speed))
        return usage_error("%s does not have the law %s; its lines hold at one impact speed: give it by --speed G, as "
                           "--speed 1",
                           host, law_equation(&contacts->law).text);
    if (cor_scene_given(scene, COR_SCENE_RESTITUTION) && (constant || speed == at)) {
        asked->wish.eps = scene->number[COR_SCENE_RESTITUTION];
        return STATUS_OK;
    }
    if (scene->end == COR_BOTH_ENDS && cor_scene_ends_differ(contacts->contact))
        return has_law || constant ? STATUS_OK
                                   : usage_error("eps of this contact at zero overlap differs from that at zero force; "
                                                 "give the one that %s is to realise: --end zero-overlap or zero-force",
                                                 host);
    if (isnan(speed) && !constant)
        return STATUS_OK;
    return contact_status(cor_scene_eps(&asked->wish.eps, contacts->contact, isnan(speed) ? 1 : speed,
                                        scene->end == END_ZERO_FORCE ? END_ZERO_FORCE : END_ZERO_OVERLAP));
}

/* Prints all rows that realise the contact. Returns their number; `refusal` becomes the reason of the first that does
 * not. */
static int print_rows(FILE *file, char refusal[REASON], const char *host, const struct asked *asked, bool has_law)
{
    const struct cor_simulator_model *comment = NULL;
    int printed = 0;
    refusal[0] = '\0';
    for (const struct cor_simulator_model *row = first_row; row < last_row; row++) {
        char reason[REASON] = "";
        if (!row_is_of(row, host) ||
            !(has_law ? cor_simulator_has_law : cor_simulator_has_one_eps)(row, asked->contacts->contact))
            continue;
        const double number = number_for_row(reason, asked, row, has_law);
        char *const lines = isnan(number) ? NULL : lines_of(row->lines, asked, number);
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

char *contact_host_text(const char *host, const struct embed_request *request, const struct contacts *contacts,
                        const double *speed_m_s, size_t speeds)
{
    struct asked asked = {.request = request, .contacts = contacts};
    const bool has_law = host_has_law(host, contacts->contact);
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
                    law_equation(&contacts->law).text);
    free(text);
    return NULL;
}
