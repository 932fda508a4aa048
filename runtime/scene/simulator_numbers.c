/* SPDX-License-Identifier: MIT */
/* The numbers by which a model of a simulator realises a contact */
#include <math.h>
#include <string.h>

#include "cor/scene.h"
#include "runtime/scene/exponents.h"

/* A row of Tsuji's law whose e serves a linear spring, too */
static int has_hooke(const struct cor_simulator_model *model)
{
    return model->damping_of_e && strstr(model->model, "ooke") != NULL;
}

int cor_simulator_has_function(const struct cor_simulator_model *model)
{
    return model->lines && strstr(model->lines, "{embed}") != NULL;
}

int cor_simulator_has_law(const struct cor_simulator_model *model, const struct cor_scene_contact *contact)
{
    const struct cor_exponents *const law = &contact->law;
    const int linear = cor_law_is(law, 2, 0);
    if (contact->plastic)
        return model->law == COR_LAW_IMPULSE && cor_simulator_has_function(model);
    switch (model->law) {
    case COR_LAW_LINEAR:
        return linear;
    case COR_LAW_TSUJI:
        return (cor_law_is_hertz(law) && cor_law_is_constant(law)) || (linear && has_hooke(model));
    case COR_LAW_LINEAR_ROOT:
        return cor_law_is(law, 2, 1);
    case COR_LAW_HERTZ_DASHPOT:
        return cor_law_is(law, 3, 0);
    case COR_LAW_VISCOELASTIC:
        return cor_law_is(law, 3, 1) && cor_scene_has_end(contact, (int)model->end);
    case COR_LAW_HUNT_CROSSLEY:
        return cor_law_is_hunt_crossley(law);
    case COR_LAW_IMPULSE:
        return cor_law_is_constant(law) != cor_simulator_has_function(model);
    default:
        return 0;
    }
}

/* A law with a closed form, and the spring of the contact */
int cor_simulator_has_one_eps(const struct cor_simulator_model *model, const struct cor_scene_contact *contact)
{
    switch (model->law) {
    case COR_LAW_IMPULSE:
        return !cor_simulator_has_function(model);
    case COR_LAW_HUNT_CROSSLEY:
        return 1;
    case COR_LAW_TSUJI:
        return model->damping_of_e || cor_law_is_hertz(&contact->law);
    default:
        return model->law == COR_LAW_LINEAR && cor_law_is(&contact->law, 2, 0);
    }
}

/* The speed at which numbers are converted. Where the model has the contact's law, any speed gives the same lines. */
static double speed_of(const struct cor_simulator_wish *wish)
{
    return isnan(wish->speed_m_s) ? 1 : wish->speed_m_s;
}

static double exact_damping(const struct cor_simulator_model *model, const struct cor_simulator_wish *wish,
                            int same_law)
{
    const struct cor_scene_contact *contact = wish->contacts;
    const int constant = cor_law_is_constant(&contact->law);
    /* eps was given, and no end at which it was measured: the simulator is to realise it at its own end. */
    const int own_end = cor_scene_given(wish->scene, COR_SCENE_RESTITUTION) && wish->scene->end == COR_BOTH_ENDS;
    if (!same_law || model->law == COR_LAW_IMPULSE || (constant && own_end))
        return cor_law_damping(model->law, model->end, wish->eps);
    if (wish->count > 1) {
        if (model->end != COR_END_ZERO_OVERLAP && model->end != COR_END_ZERO_FORCE)
            return NAN;
        contact = &wish->contacts[model->end];
    }
    return constant ? contact->damping : cor_scene_beta(contact, speed_of(wish));
}

double cor_simulator_damping(const struct cor_simulator_model *model, const struct cor_simulator_wish *wish,
                             int same_law)
{
    const double damping = exact_damping(model, wish, same_law);
    return wish->steps > 0 ? cor_simulator_step_damping(model, wish, same_law, damping) : damping;
}

double cor_simulator_number(const struct cor_simulator_model *model, const struct cor_simulator_wish *wish,
                            int same_law, enum cor_simulator_status *status)
{
    const double damping = cor_simulator_damping(model, wish, same_law);
    *status = COR_SIMULATOR_OK;
    if (cor_simulator_has_function(model))
        return 1; /* its lines have no number */
    if (isnan(damping)) {
        *status = COR_SIMULATOR_NO_CLOSED_FORM;
        return NAN;
    }
    if (!model->number_of_damping)
        return cor_simulator_e(model, cor_law_eps(model->law, model->end, damping), status);
    const double number = model->number_of_damping(damping, wish->contacts, speed_of(wish));
    if (isnan(number))
        *status = COR_SIMULATOR_NO_SCALES;
    return number;
}

/* zeta and natural frequency fix MuJoCo's time constant; contact time and e' those of YADE. Simbody's stiffness s of
 * each of two bodies is K = (4/3) sqrt(R) s/2^(3/2). */
double cor_simulator_word(const char *word, const struct cor_simulator_wish *wish, double number)
{
    static const double pi = 3.14159265358979323846;
    const double k = wish->contacts->stiffness, m = wish->contacts->mass_kg, radius = wish->contacts->radius_m;
    const double l = log(number);
    const struct {
        const char *word;
        double value;
    } words[] = {{"n", number},
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
                 {"simbody", sqrt(4.5) * k / sqrt(radius)},
                 {"young", wish->scene->number[COR_SCENE_YOUNG]},
                 {"poisson", wish->scene->number[COR_SCENE_POISSON]},
                 {"young2", wish->scene->number[COR_SCENE_YOUNG_2]},
                 {"poisson2", wish->scene->number[COR_SCENE_POISSON_2]},
                 {"0", 0}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i].word, word) == 0)
            return words[i].value;
    return NAN;
}
