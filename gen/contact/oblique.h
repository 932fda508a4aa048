/* SPDX-License-Identifier: MIT */
/* Computes the rows of corgen contact --friction MU --angle LIST: oblique impacts with friction. */
#ifndef COR_GEN_CONTACT_OBLIQUE_H
#define COR_GEN_CONTACT_OBLIQUE_H

#include "contact/contact.h"

/* model: a name of cor_tangential_models or of a simulator; NULL: displacement. given: angles in degrees, or tangential
 * speeds. stiffness, damping_ratio, restitution: NaN if not given; stiffness is then Mindlin's. damping_ratio:
 * tangential damper divided by normal damper. walton: each speed has only one row, with Walton's numbers. remark: a
 * sentence about the rows, set by contact_oblique, or "" */
struct oblique_request {
    const char *model;
    double friction, stiffness, damping_ratio, restitution;
    const double *given, *speed_m_s;
    size_t count, speeds;
    bool angles, walton;
    char remark[200];
};

/* Adds a row for each speed and angle, and for each end if the end matters and is not given. Returns STATUS_OK, or
 * another status after a message. */
int contact_oblique(struct table *table, const struct contacts *contacts, struct oblique_request *request, int digits);

/* Sets the fields that the lines of a simulator need. Returns STATUS_OK, or STATUS_USAGE after a message. */
int contact_oblique_lines(struct cor_simulator_request *lines, const struct contacts *contacts,
                          const struct oblique_request *request);

#endif
