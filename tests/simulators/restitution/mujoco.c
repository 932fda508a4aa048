/* SPDX-License-Identifier: MIT */
/* Collides a sphere with a plane in MuJoCo, with the text of corgen contact --for mujoco.
 *     mujoco PASTE MASS DURATION N [N]...
 * prints for each N, with DURATION/(N + 1/2) s as the time step,
 *     eps N VALUE CHANGE
 * CHANGE, the change of the velocity after the contact, must be 0. */
#include <mujoco/mujoco.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { XML = 8000, PASTE = 5000, MESSAGE = 300 };

static mjModel *model_with(const char *paste, const char *mass, double step)
{
    char xml[XML], message[MESSAGE] = "";
    snprintf(xml, sizeof xml,
             "<mujoco>%s<option timestep='%.17g' gravity='0 0 0' tolerance='1e-15'/><worldbody>"
             "<geom type='plane' size='1 1 1'/><body pos='0 0 0.01'><freejoint/>"
             "<geom type='sphere' size='0.01' mass='%s'/></body></worldbody></mujoco>",
             paste, step, mass);
    mjVFS files;
    mj_defaultVFS(&files);
    if (mj_makeEmptyFileVFS(&files, "contact.xml", (int)strlen(xml)) != 0)
        return NULL;
    memcpy(files.filedata[0], xml, strlen(xml));
    mjModel *const model = mj_loadXML("contact.xml", &files, message, sizeof message);
    mj_deleteVFS(&files);
    if (!model)
        fprintf(stderr, "mujoco: %s\n", message);
    return model;
}

/* Runs the collision and prints its line */
static int collide(const char *paste, const char *mass, double duration, int n)
{
    mjModel *const model = model_with(paste, mass, duration / (n + 0.5));
    if (!model)
        return 1;
    mjData *const data = mj_makeData(model);
    data->qvel[2] = -1;
    for (int k = 0; k < 1.3 * n; k++)
        mj_step(model, data);
    const double before = data->qvel[2];
    for (int k = 0; k < 0.1 * n; k++)
        mj_step(model, data);
    printf("eps %d %.17g %.3g\n", n, data->qvel[2], data->qvel[2] - before);
    mj_deleteData(data);
    mj_deleteModel(model);
    return 0;
}

int main(int argc, char **argv)
{
    char paste[PASTE] = "";
    FILE *const file = argc > 4 ? fopen(argv[1], "r") : NULL;
    if (!file) {
        fputs("usage: mujoco PASTE MASS DURATION N [N]...\n", stderr);
        return 2;
    }
    paste[fread(paste, 1, sizeof paste - 1, file)] = '\0';
    fclose(file);
    int status = 0;
    for (int i = 4; i < argc; i++)
        status |= collide(paste, argv[2], strtod(argv[3], NULL), atoi(argv[i]));
    return status;
}
