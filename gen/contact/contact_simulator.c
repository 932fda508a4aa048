/* SPDX-License-Identifier: MIT */
#include "contact/contact.h"

#include <stdlib.h>
#include <string.h>

#include "support/console.h"

/* For the completion of shells; tests/gen/test_contact.c compares it with cor_simulators. */
const char *const contact_simulator_names[] = {
    "lammps",  "liggghts", "yade",          "mercurydpm", "chrono",
    "mfix",    "openfoam", "esys-particle", "mujoco",     "drake",
    "simbody", "bullet",   "rebound",       "modelica",   CONTACT_SIMULATOR_LIST,
    NULL};

bool contact_simulator_is_list(const char *simulator, const char *version)
{
    return strcmp(simulator, CONTACT_SIMULATOR_LIST) == 0 || (version && strcmp(version, CONTACT_SIMULATOR_LIST) == 0);
}

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
