/* SPDX-License-Identifier: MIT */
/* Makes the contact of a request of corgen contact or corgen sample (cor/scene.h). A collision of a law without
 * functions is enclosed, which takes some milliseconds for each speed. */
#ifndef COR_GEN_CONTACT_CONTACT_H
#define COR_GEN_CONTACT_CONTACT_H

#include "embed/own_law.h"
#include "embed/request.h"
#include "support/output.h"

extern const char *const contact_equivalent_names[]; /* words of --equivalent; ends with NULL */

/* One contact, or one contact for each end if the end at which a restitution was measured is not given */
struct contacts {
    struct cor_scene scene;
    int count;
    struct cor_scene_contact contact[COR_SCENE_ENDS];
    struct cor_scene_contact hertz; /* the Hertz contact that an equivalent spring replaces; stiffness 0: none */
    double at_m_s;                  /* the speed at which spring and hertz are equivalent */
};

/* Returns STATUS_OK, STATUS_USAGE after a message about a missing or contradictory number, or STATUS_FAILED. */
int contacts_of_request(struct contacts *contacts, const struct embed_request *request);
/* Like contacts_of_request, for commands that refuse JKR adhesion because its ends of contact are different. */
int contacts_without_jkr(struct contacts *contacts, const struct embed_request *request);

/* Returns the law of a contact, its yield speed and its liquid as text: "x'' + beta x^(1/2) x' + x^(3/2) = 0" */
enum { CONTACT_LAW_TEXT = 256 };
const char *contact_law_text(char text[CONTACT_LAW_TEXT], const struct cor_scene_contact *contact);

/* Warns on stderr if the overlap at this impact speed exceeds the radius, or if spheres of a law without yield would
 * yield. */
void contact_warn(const struct contacts *contacts, double speed_m_s);

/* Converts the status of a function of cor/scene.h, called for such a contact, to an exit status. */
int contact_status(int status);

cor_scene_solver contact_enclosed;

/* Returns the malloc'ed lines of --for SIMULATOR that call the header of an own law, for these speeds. NULL after a
 * message if the simulator cannot call a function eps(speed). */
char *contact_own_lines(const struct own_law *law, const struct embed_request *request, const char *simulator,
                        const double *speed_m_s, size_t speeds);

/* ---- contact_rows.c: the tables of corgen contact: the numbers of a contact, and a row for each speed ---- */

/* Digits of a number in csv and json, and in text. The error is below COR_SCENE_MAX_ERROR. */
enum { CONTACT_DIGITS = 12, CONTACT_DIGITS_TEXT = 6 };

/* Fills a table with the columns quantity,value,unit. For two contacts, one for each end at which eps may have been
 * measured, the columns are value_zero_overlap and value_zero_force. Unknown quantities have no row. Spheres have
 * Rayleigh's time step and, if they adhere, Tabor's number. friction: if not NaN, adds kappa, the ratio u'/u without
 * slip, and the largest angle in degrees at which spheres, or a sphere and a wall, stick when they touch. tangential:
 * if not NaN, adds the spring and the dashpot of a linear contact with this tangential restitution */
void contact_summary(struct table *table, const struct contacts *contacts, double friction, double tangential,
                     int digits);

/* Prints the meaning of Tabor's number and of an equivalent spring. Also prints the meaning of Rayleigh's time step if
 * the rows use a different time step. */
void contact_print_ranges(FILE *file, const struct contacts *contacts, bool rows);

/* Adds a row for each contact and speed of the request, with its time step, in the columns of corgen contact. Two
 * contacts also have the column measured_end. The errors of the step fill two columns, or two for each end if
 * contact_end() is COR_BOTH_ENDS; a corrected damping needs a single end. An equivalent spring adds three columns for
 * the Hertz contact with the same eps at the speed --at. Returns STATUS_OK or STATUS_FAILED. */
int contact_rows(struct table *table, const struct contacts *contacts, const struct cor_simulator_request *request,
                 int digits);

/* Returns an end of a contact as text: "zero overlap", "zero force", "the surface" */
const char *contact_end_text(const struct cor_scene_contact *contact, int end);

/* Returns the end for the row of a contact, or COR_BOTH_ENDS. contact: its index */
int contact_end(const struct contacts *contacts, int contact);

/* ---- lines for the input of a simulator, for a contact (cor/scene.h) ---- */

/* The word that requests a list. In place of a name it requests all simulators, in place of a version all models. */
#define CONTACT_SIMULATOR_LIST "list"

extern const char *const contact_simulator_names[]; /* names of cor_simulators, the word for the list, NULL */

/* Returns the malloc'ed text of corgen contact --for SIMULATOR. If a list is requested, returns the list, which needs
 * no contacts. NULL after a message if the simulator is unknown or cannot reproduce this contact. */
char *contact_simulator_text(const struct cor_simulator_request *request);

/* Returns the malloc'ed lines for all contacts of the materials in a csv file. pairs: a csv file with measured pairs,
 * or NULL. The scene of the request supplies law and end. */
char *contact_materials_text(struct cor_simulator_request request, const char *materials, const char *pairs);

#endif
