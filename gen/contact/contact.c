/* SPDX-License-Identifier: MIT */
#include "contact/contact.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"

/* ---- enclosed collisions ---- */

enum { CONTACT_BITS = 64 };
#define ENCLOSED_BETA_MAX 1e12 /* beyond, the bits and the seconds of an enclosure grow without use */

int contact_enclosed(struct cor_scaled_impact *impact, const struct cor_exponents *law, double beta, int end)
{
    if (!(beta <= ENCLOSED_BETA_MAX))
        return -usage_error(
            "beta is %g at an impact; allowed for x'' + beta x^(%ld/%ld) x' + x^(%ld/%ld) = 0: up to %g", beta,
            (long)law_damping(law).num, (long)law_damping(law).den, (long)law_elastic(law).num,
            (long)law_elastic(law).den, ENCLOSED_BETA_MAX);
    LOCAL_INIT(collision, c, (&c));
    LOCAL(arb, x, force);
    arb_set_d(x, beta);
    const int status = collision_solve_pressed(&c, x, force, law, end, CONTACT_BITS);
    *impact = (struct cor_scaled_impact){{ball_middle(c.eps_zero_overlap), ball_middle(c.eps_zero_force)},
                                         {ball_middle(c.t_zero_overlap), ball_middle(c.t_zero_force)},
                                         ball_middle(c.x_max)};
    return status == 0 ? STATUS_OK : -STATUS_FAILED;
}

int contact_status(int status)
{
    if (status == COR_FAULT_PRESSED)
        return fail("the damping of an impact is too strong to be integrated under gravity or adhesion");
    return status < 0 ? -status : status == COR_FAULT_NONE ? STATUS_OK : STATUS_FAILED;
}

/* ---- a request ---- */

int contacts_of_request(struct contacts *contacts, const struct embed_request *request)
{
    char text[COR_SCENE_FAULT_TEXT];
    struct cor_scene_fault fault;
    struct own_law own; /* not of this contact; its options are refused */
    int status = own_law_init(&own, request);
    if (status == STATUS_OK)
        status = embed_request_scene(&contacts->scene, request);
    if (status != STATUS_OK)
        return status;
    contacts->scene.solver = contact_enclosed;
    status = cor_scene_contacts(contacts->contact, &contacts->count, &fault, &contacts->scene);
    if (status <= 0)
        return status == COR_FAULT_NONE ? STATUS_OK : STATUS_FAILED;
    if (fault.fault == COR_FAULT_NO_DAMPING)
        return fail("no damping found for which eps is %g", embed_number(request, COR_SCENE_RESTITUTION));
    if (fault.fault == COR_FAULT_VISCOSITY)
        return usage_error("--%s: '%s' is not two numbers, 0 or more, with a comma between them: ETA1,ETA2 in Pa s, as "
                           "1e3,2e3",
                           cor_scene_options[fault.number].name,
                           request->viscosity[fault.number == COR_SCENE_VISCOSITY_2]);
    cor_scene_fault_text(text, sizeof text, &fault, law_equation(&contacts->scene.law).text, NULL);
    return usage_error("%s", text);
}

int contacts_without_jkr(struct contacts *contacts, const struct embed_request *request)
{
    const int status = contacts_of_request(contacts, request);
    return status == STATUS_OK && contacts->contact[0].adhesion_j_m2 > 0
               ? usage_error("--adhesion-model jkr: corgen contact has its numbers, at any list of speeds; allowed "
                             "here: dmt")
               : status;
}

const char *contact_law_text(char text[CONTACT_LAW_TEXT], const struct cor_scene_contact *contact)
{
    int length = contact->plastic ? snprintf(text, CONTACT_LAW_TEXT, "elastic-plastic spheres, v_y = %.6g m/s",
                                             contact->yield_speed_m_s)
                                  : snprintf(text, CONTACT_LAW_TEXT, "%s", law_equation(&contact->law).text);
    if (contact->liquid_speed_m_s > 0)
        snprintf(text + length, (size_t)(CONTACT_LAW_TEXT - length),
                 ", in a liquid that takes %.6g m/s on the way in and on the way out", contact->liquid_speed_m_s);
    return text;
}

void contact_warn_yield(const struct contacts *contacts, double speed_m_s)
{
    const struct cor_scene_contact *const c = &contacts->contact[0];
    const double speed = speed_m_s - c->liquid_speed_m_s;
    if (c->plastic || !(c->yield_speed_m_s > 0) || !(speed > c->yield_speed_m_s))
        return;
    fail("warning: at %g m/s the largest Hertzian pressure would be %.4g Pa, above 1.6 times the yield "
         "stress, %.4g Pa. The bodies yield from %.4g m/s on, and this law does not describe them there; "
         "--law elastic-plastic does.",
         speed_m_s, cor_scene_pressure(c, cor_scene_elastic_overlap(c, speed)),
         cor_scene_pressure(c, cor_scene_elastic_overlap(c, c->yield_speed_m_s)),
         c->yield_speed_m_s + c->liquid_speed_m_s);
}

/* ---- lines of simulators ---- */

/* For the completion of shells; tests/gen/test_contact.c compares it with cor_simulators. */
const char *const contact_simulator_names[] = {
    "lammps",  "liggghts", "yade",          "mercurydpm", "chrono",
    "mfix",    "openfoam", "esys-particle", "mujoco",     "drake",
    "simbody", "bullet",   "rebound",       "modelica",   CONTACT_SIMULATOR_LIST,
    NULL};

static long write_text(char *text, size_t size, const struct cor_simulator_request *request)
{
    return request->contacts ? cor_simulator_lines(text, size, request)
                             : cor_simulator_list(text, size, cor_simulator_named(request->simulator));
}

char *contact_simulator_text(const struct cor_simulator_request *request)
{
    char reason[COR_SIMULATOR_REASON];
    if (strcmp(request->simulator, CONTACT_SIMULATOR_LIST) != 0 && !cor_simulator_named(request->simulator)) {
        cor_simulator_lines(reason, sizeof reason, request);
        usage_error("--for: %s, " CONTACT_SIMULATOR_LIST, reason);
        return NULL;
    }
    const long length = write_text(reason, sizeof reason, request);
    if (length < 0)
        return usage_error("%s", reason), NULL;
    char *const text = xmalloc((size_t)length + 1);
    write_text(text, (size_t)length + 1, request);
    return text;
}

char *contact_own_lines(const struct own_law *law, const struct embed_request *request, const char *simulator,
                        const double *speed_m_s, size_t speeds)
{
    static const char word[] = "{embed}";
    const struct cor_simulator *const known = cor_simulator_named(simulator);
    const struct cor_simulator_model *model = NULL;
    double least = speed_m_s[0], largest = least;
    char min[DECIMAL_TEXT], max[DECIMAL_TEXT];
    for (int k = 0; k < known->model_count; k++)
        if (known->models[k].has_function && known->models[k].law == COR_LAW_IMPULSE)
            model = &known->models[k];
    if (!model)
        return usage_error("--for %s: %s computes eps of a spring and a dashpot, and --law %s has neither; allowed: "
                           "rebound or bullet, which call a function of the speed",
                           simulator, known->title, embed_law_names[law->law]),
               NULL;
    char *text = NULL, *const options = embed_options(request, INT_MAX);
    size_t size;
    FILE *const file = open_memstream(&text, &size);
    fprintf(file, "%s%s, %s%s\n", known->comment, known->title, model->model, known->comment_end);
    for (size_t i = 0; i < speeds; i++) {
        least = fmin(least, speed_m_s[i]);
        largest = fmax(largest, speed_m_s[i]);
        fprintf(file, "%srealises eps = %.6g at %g m/s%s\n", known->comment, own_law_value(law, speed_m_s[i]),
                speed_m_s[i], known->comment_end);
    }
    const double margin = least < largest || law->rows > 0 ? 1 : 10;
    const char *const at = strstr(model->lines, word);
    fprintf(file,
            "%.*scorgen embed --speed-min %s --speed-max %s --tolerance 1e-6%s --name cor_eps --output cor_eps.h%s"
            "%sOutside these speeds cor_eps returns the value at the nearer end of their range.%s\n",
            (int)(at - model->lines), model->lines, decimal_text(min, least / margin),
            decimal_text(max, largest * margin), options, at + strlen(word), known->comment, known->comment_end);
    fclose(file);
    free(options);
    return text;
}
