/* SPDX-License-Identifier: MIT */
/* corgen embed writes one header for one scene. */
#include <stdlib.h>

#include "cli/commands.h"
#include "cli/scene_options.h"
#include "embed/choose.h"
#include "embed/header.h"
#include "support/console.h"

static int write_header(const struct embed_arguments *o, const struct embed_scene *s, const struct embed_form *form)
{
    const enum embed_family chosen = embed_choose(form, o->scene.purpose);
    if (chosen == FAMILIES) {
        char *why = embed_failures(s, form);
        const int status = fail("no form meets the tolerance %s (%s)", o->scene.number[EMBED_TOLERANCE].text, why);
        free(why);
        return status;
    }
    struct output out;
    if (output_open(&out, o->common.output))
        return STATUS_FAILED;
    embed_header_write(out.file, &o->scene, s, form, chosen);
    return output_commit(&out);
}

static int run_embed(const void *arguments)
{
    const struct embed_arguments *const o = arguments;
    struct embed_scene scene;
    struct embed_form form[FAMILIES] = {{0}};
    struct embed_series series;
    struct law law;
    int status = embed_request_check(&o->scene);
    if (status == STATUS_OK)
        status = embed_request_law(&law, &o->scene);
    if (status != STATUS_OK)
        return status;
    profile_step("collisions, series");
    embed_series_begin(&series, &law, o->scene.end);
    status = embed_scene_init(&scene, &o->scene);
    const int series_status = embed_series_end(&series);
    if (status == STATUS_OK)
        status = series_status;
    if (status == STATUS_OK) {
        embed_search(form, &scene, &series);
        status = write_header(o, &scene, form);
    }
    profile_step(NULL);
    for (int i = 0; i < FAMILIES; i++)
        embed_form_clear(&form[i]);
    embed_scene_clear(&scene);
    embed_series_clear(&series);
    return status;
}

static const char help[] =
    "Usage: corgen embed --speed-min G --speed-max G --tolerance T CONTACT [OPTION]...\n\n"
    "Writes a self-contained header, C99, C++11, CUDA and HIP, with one function from the impact\n"
    "speed in m/s to eps: the cheapest form that meets the tolerance between the two speeds.\n\n"
    "  --speed-min G, --speed-max G   the range of speeds, m/s; outside, the nearer end's value\n"
    "  --tolerance T    relative error of eps allowed, 1e-15 (float: 4e-7) to 0.1\n" HELP_END
    "  --type T         double (default) or float\n"
    "  --for USE        scalar: calls one at a time; array: loops that become vectors; balanced\n"
    "                   (default): both\n"
    "  --name NAME      of the function (default cor_scene_eps); the include guard follows it\n" HELP_SCENE_LAW
    "\nCONTACT is the characteristic speed\n"
    "  --g-star G       m/s, from eps = 1 - (speed/g*)^q + ..., beta ~ speed^q, q = 1/5 for spheres\n"
    "or beta at one speed\n"
    "  --beta BETA --at G\n"
    "or the force K x^a + C x^b x', SI units, with the effective mass m_1 m_2/(m_1 + m_2):\n"
    "  --stiffness K --damping-coefficient C --effective-mass M\n"
    "or the materials of two viscoelastic spheres, the second like the first where not given:\n"
    "  --young Y, --poisson NU      Pa, -\n"
    "  --radius R                   m\n"
    "  --density D or --mass M      kg/m^3, kg\n"
    "  --dissipation-time A         s\n"
    "  --young-2, --poisson-2, --radius-2, --density-2, --mass-2, --dissipation-time-2\n"
    "  --wall           the second is flat and held fast\n\n" HELP_COMMON
    "\nExample: corgen embed --speed-min 0.1 --speed-max 10 --g-star 0.2 --tolerance 1e-6\n";

#define AT(FIELD) offsetof(struct embed_arguments, FIELD)
static const struct option_rule options[] = {
    SCENE_OPTIONS(struct embed_arguments, &option_sphere_poisson, ""),
    {.name = "type", .kind = OPTION_WORD, .offset = AT(scene.type), .range.words = embed_type_names, .why = "a type"},
    {.name = "name", .kind = OPTION_C_NAME, .offset = AT(scene.name)},
    OPTION_COMMON(struct embed_arguments),
    {.name = NULL},
};

static const struct embed_arguments defaults = {0};

const struct subcommand command_embed = {.name = "embed",
                                         .summary = "a C header with eps of the impact speed for one scene",
                                         .help = help,
                                         .options = options,
                                         .size = sizeof defaults,
                                         .defaults = &defaults,
                                         .run = run_embed};
