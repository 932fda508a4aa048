/* SPDX-License-Identifier: MIT */
/* corgen plan recommends a model of collisions for a scene, and prints its cost and the effects that it neglects. */
#include "plan/plan.h"
#include "cli/commands.h"
#include "cli/scene_options.h"
#include "support/console.h"

/* Removes the constant force from a request. If the restitution was measured under the force, the contact's damping
 * replaces the restitution; `damping` owns the new number. */
static void remove_force(struct embed_request *request, struct decimal *damping, const struct contacts *pressed)
{
    const struct cor_scene_contact *const contact = &pressed->contact[0];
    const bool constant = cor_scene_speed_exponent(contact) == 0;
    char text[DECIMAL_TEXT];
    request->number[COR_SCENE_GRAVITY].text = request->number[COR_SCENE_ADHESION].text = NULL;
    request->adhesion_model = COR_ADHESION_NONE;
    request->end = pressed->scene.end;
    if (!(contact->force_n > 0 && contact->damping > 0 && embed_given(request, COR_SCENE_RESTITUTION)))
        return;
    decimal_set(damping, decimal_text(text, constant ? contact->damping
                                                     : cor_scene_beta(contact, embed_number(request, COR_SCENE_AT))));
    request->number[COR_SCENE_RESTITUTION].text = NULL;
    request->number[constant ? COR_SCENE_ZETA : COR_SCENE_BETA] = *damping;
    if (constant && !embed_given(request, COR_SCENE_DURATION))
        request->number[COR_SCENE_AT].text = NULL;
}

static int plan_of_spheres(struct plan *plan, const struct plan_arguments *o)
{
    /* without the constant force, because the formulas have none */
    struct embed_request scene = o->scene;
    struct contacts contacts, pressed;
    struct decimal damping = {0};
    static const struct cor_scene_contact none;
    if (scene.law >= EMBED_LAW_POWER)
        return plan_spheres(plan, &scene, &none, &o->scene, &none, o->points);
    int status = contacts_without_jkr(&pressed, &scene);
    if (status == STATUS_OK)
        remove_force(&scene, &damping, &pressed);
    if (status == STATUS_OK)
        status = contacts_of_request(&contacts, &scene);
    if (status == STATUS_OK && (contacts.contact[0].plastic || contacts.contact[0].liquid_speed_m_s > 0))
        status = usage_error("corgen plan has models only of dry contacts that do not yield; for --law elastic-plastic "
                             "and --viscosity-liquid use corgen contact, sample or embed");
    if (status == STATUS_OK) {
        contact_warn(&contacts, embed_number(&scene, EMBED_SPEED_MAX));
        status = plan_spheres(plan, &scene, contacts.contact, &o->scene, pressed.contact, o->points);
    }
    decimal_clear(&damping);
    return status;
}

static const struct option_rule sphere_poisson = {
    .name = "poisson", .kind = OPTION_REAL, .scene = &cor_scene_options[COR_SCENE_POISSON]};

static int run_plan(const void *arguments)
{
    const struct plan_arguments *const o = arguments;
    const struct decimal *const poisson = &o->scene.number[COR_SCENE_POISSON];
    struct plan plan = {.chosen = -1};
    struct output out;
    int status = STATUS_OK;
    if (o->disks && !poisson->text)
        return usage_error("corgen plan --disks needs --poisson, for example --poisson 0.33; see corgen plan --help");
    if (poisson->text && !o->disks) {
        const struct option_numbers numbers = options_numbers(&sphere_poisson);
        status = options_check_real(sphere_poisson.name, &numbers, poisson);
    } else if (poisson->text) {
        status = options_disk_poisson(poisson);
    }
    if (status == STATUS_OK)
        status = o->disks ? plan_disks(&plan, &o->scene, o->quantity, o->points) : plan_of_spheres(&plan, o);
    if (status == STATUS_OK)
        status = output_open(&out, o->common.output);
    if (status == STATUS_OK) {
        plan_print(&plan, (enum output_format)o->common.format, out.file);
        status = output_commit(&out);
    }
    if (status == STATUS_OK && plan.chosen < 0)
        status = fail("no model meets the tolerance %s; give a larger --tolerance or a narrower range of speeds",
                      o->scene.number[EMBED_TOLERANCE].text);
    plan_clear(&plan);
    return status;
}

static const char help[] =
    "Usage: corgen plan --speed-min G --speed-max G --tolerance T BODIES DISSIPATION [OPTION]...\n"
    "       corgen plan --disks --speed-min V --speed-max V --tolerance T --poisson NU [OPTION]...\n\n"
    "Compares models of eps with proved values over a range of speeds, and prints the cheapest model\n"
    "that meets the tolerance, with the command or call to use.\n\n"
    "Spheres and other laws: speeds in m/s; T is the relative error of eps, 1e-15 to below 1.\n" HELP_END_PRESSED
    "  --for USE        purpose whose time is compared, scalar (single calls), array (loops) or balanced (both)\n"
    "                   (default balanced)\n" HELP_CONTACT "\n"
    "Disks that collide with a rigid wall, with all their modes: speeds in sqrt(E/rho), 0.001 to 0.5.\n"
    "  --disks          use disks instead of spheres; disks lose energy to their vibrations\n"
    "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, such as 0.33 or 1/3\n"
    "  --quantity Q     quantity to compare: eps (T is its error), or contact-time or compression, the\n"
    "                   largest compression (T is the relative error) (default eps)\n\n"
    "  --points N       number of speeds at which models are compared, 2 to 1000 (default 33, disks 9)\n"
    "  --format F       output format, text, csv or json (default text)\n" HELP_COMMON "\n"
    "Columns of csv and json: model,beta (speed of disks),value,error,cost,uncertainty,verdict;\n"
    "a row for each model at each point; cost in ns; uncertainty of the exact value;\n"
    "verdict: chosen, meets, misses, outside (no value at some speed), shown (never chosen).\n"
    "Exit status 1 if no model meets the tolerance.\n\n"
    "Example: corgen plan --speed-min 0.01 --speed-max 1 --g-star 20 --end zero-force --tolerance 1e-4 --points 9\n";

#define ARGUMENTS struct plan_arguments
static const struct option_rule options[] = {
    SCENE_RANGE,
    SCENE_OPTIONS(&option_disk_poisson, NULL, "disks"),
    SCENE_PURPOSE("disks"),
    OPTION_PLAIN("disks", FLAG, disks),
    OPTION("quantity", WORD, quantity, .range.words = plan_quantity_names, .why = "a quantity", .needs = "disks"),
    OPTION("points", WHOLE, points, .range.whole = {PLAN_MIN_POINTS, PLAN_MAX_POINTS},
           .why = "each point needs several collisions"),
    OPTION_FORMAT(option_formats),
    OPTION_COMMON,
};

SUBCOMMAND(plan, "plan", "which model a scene needs, what it costs and leaves out", .common.format = FORMAT_TEXT);
