/* SPDX-License-Identifier: MIT */
/* corgen embed writes one header for one scene. */
#include <stdlib.h>

#include "cli/commands.h"
#include "cli/scene_options.h"
#include "embed/form.h"
#include "support/console.h"

static int run_embed(const void *arguments)
{
    const struct embed_arguments *const o = arguments;
    struct embed_scene scene;
    struct embed_form form[FAMILIES] = {{0}};
    struct embed_proof proof;
    struct contacts contacts = {.count = 0};
    struct output out;
    int status = embed_request_check(&o->scene);
    const bool own = o->scene.law >= EMBED_LAW_POWER;
    if (status == STATUS_OK && !own)
        status = contacts_without_jkr(&contacts, &o->scene);
    if (status == STATUS_OK && !own && contacts.contact[0].force_n > 0 && law_is_linear(&contacts.scene.law) &&
        contacts.contact[0].damping > 0)
        status = usage_error("headers with --gravity or --adhesion are not possible for the laws linear and tsuji; use "
                             "corgen sample, which writes a table");
    if (status != STATUS_OK)
        return status;
    if (!own)
        contact_warn(&contacts, embed_number(&o->scene, EMBED_SPEED_MAX));
    profile_step("collisions, series");
    status = embed_scene_init(&scene, &o->scene, &contacts.contact[0]);
    if (status == STATUS_OK)
        embed_search(form, &scene);
    const enum embed_family chosen = embed_choose(form, o->scene.purpose);
    if (status == STATUS_OK && chosen == FAMILIES) {
        char *const why = embed_failures(&scene, form);
        status = fail("no form meets the tolerance %s (%s); give a larger --tolerance or a narrower range of speeds",
                      o->scene.number[EMBED_TOLERANCE].text, why);
        free(why);
    }
    profile_step("proof");
    if (status == STATUS_OK)
        status = embed_prove(&proof, &form[chosen], &scene);
    if (status == STATUS_OK)
        status = output_open(&out, o->common.output);
    if (status == STATUS_OK) {
        embed_header_write(out.file, &o->scene, &scene, form, chosen, &proof);
        status = output_commit(&out);
    }
    profile_step(NULL);
    for (int i = 0; i < FAMILIES; i++)
        embed_form_clear(&form[i]);
    embed_scene_clear(&scene);
    return status;
}

static const char help[] =
    "Usage: corgen embed --speed-min G --speed-max G --tolerance T BODIES DISSIPATION [OPTION]...\n\n"
    "Writes a self-contained header (C99, C++11, CUDA and HIP) with one function from the impact speed\n"
    "to eps: the cheapest form that meets the tolerance between the two speeds. With --gravity or\n"
    "--adhesion eps is 0 up to the sticking speed.\n\n"
    "  --speed-min G, --speed-max G   range of speeds, m/s; other speeds give the value of the nearer end\n"
    "  --tolerance T    largest relative error of eps, 1e-15 (float: 4e-7) to 0.1\n" HELP_END_PRESSED
    "  --type T         type of the numbers, double or float (default double)\n"
    "  --for USE        purpose to optimise for, scalar (single calls), array (vectorised loops), balanced (both)\n"
    "                   or rebound (scalar, with NAME_callback for REBOUND) (default balanced)\n"
    "  --name NAME      name of the function and of the include guard (default cor_scene_eps)\n" HELP_CONTACT
    "\n" HELP_COMMON "\n"
    "Example: corgen embed --g-star 20 --speed-min 0.01 --speed-max 10 --tolerance 1e-6 --output cor_scene_eps.h\n";

#define ARGUMENTS struct embed_arguments
static const struct option_rule options[] = {
    SCENE_RANGE,
    SCENE_OPTIONS(NULL, NULL, ""),
    SCENE_PURPOSE(NULL),
    OPTION("type", WORD, scene.type, .range.words = embed_type_names, .why = "a type"),
    OPTION_PLAIN("name", C_NAME, scene.name),
    OPTION_COMMON,
};

SUBCOMMAND(embed, "embed", "a C header with eps of the impact speed for one scene", .common.format = FORMAT_TEXT);
