/* SPDX-License-Identifier: MIT */
/* corgen embed: one header for one scene. */
#include <stdlib.h>

#include "embed/choose.h"
#include "embed/header.h"
#include "support/console.h"

static int write_header(const struct options *o, const struct embed_scene *s, const struct embed_form *form)
{
    const enum embed_family chosen = embed_choose(form, o->use);
    if (chosen == FAMILIES) {
        char *why = embed_failures(form);
        const int status = fail("no form meets the tolerance %s (%s)", o->real[OPTIONS_TOLERANCE], why);
        free(why);
        return status;
    }
    struct output out;
    if (output_open(&out, o->output))
        return STATUS_FAILED;
    embed_header_write(out.file, o, s, form, chosen);
    return output_commit(&out);
}

int command_embed(const struct options *o)
{
    struct embed_scene scene;
    struct embed_form form[FAMILIES] = {{0}};
    profile_step("collisions");
    int status = embed_scene_init(&scene, o);
    if (status == STATUS_OK)
        status = embed_search(form, &scene);
    if (status == STATUS_OK)
        status = write_header(o, &scene, form);
    profile_step(NULL);
    for (int i = 0; i < FAMILIES; i++)
        embed_form_clear(&form[i]);
    embed_scene_clear(&scene);
    return status;
}
