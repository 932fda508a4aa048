/* SPDX-License-Identifier: MIT */
/* The contact of a request of corgen contact or corgen sample: cor/scene.h, where laws without functions are enclosed,
 * some milliseconds for each speed */
#ifndef COR_GEN_CONTACT_CONTACT_H
#define COR_GEN_CONTACT_CONTACT_H

#include "embed/own_law.h"
#include "embed/request.h"
#include "support/output.h"

extern const char *const contact_equivalent_names[]; /* words of --equivalent; ends with NULL */

/* One contact, or one for each end at which a restitution may have been measured */
struct contacts {
    struct cor_scene scene;
    int count;
    struct cor_scene_contact contact[COR_SCENE_ENDS];
    struct cor_scene_contact hertz; /* replaced by an equivalent linear spring; stiffness 0: by none */
    double at_m_s;                  /* the speed at which both are equivalent */
};

/* Returns STATUS_OK, STATUS_USAGE after a message that says what is missing or contradictory, or STATUS_FAILED. */
int contacts_of_request(struct contacts *contacts, const struct embed_request *request);
/* The same for other commands, which refuse a contact that adheres as in JKR, whose ends are others */
int contacts_without_jkr(struct contacts *contacts, const struct embed_request *request);

/* The law of a contact, its yield speed and its liquid as text: "x'' + beta x^(1/2) x' + x^(3/2) = 0" */
enum { CONTACT_LAW_TEXT = 256 };
const char *contact_law_text(char text[CONTACT_LAW_TEXT], const struct cor_scene_contact *contact);

/* Warns on stderr where the spheres of a law without yield would yield at this impact speed. */
void contact_warn_yield(const struct contacts *contacts, double speed_m_s);

/* The exit status of a function of cor/scene.h for such a contact */
int contact_status(int status);

cor_scene_solver contact_enclosed;

/* The lines of --for SIMULATOR that call a header of a law of one's own, for these speeds, malloc'ed. NULL after a
 * message if the simulator calls no function of the speed. */
char *contact_own_lines(const struct own_law *law, const struct embed_request *request, const char *simulator,
                        const double *speed_m_s, size_t speeds);

/* ---- contact_rows.c: the tables of corgen contact, the numbers of a contact and a row for each impact speed ---- */

/* Digits of a number in csv and json, and in text. The error is below COR_SCENE_MAX_ERROR. */
enum { CONTACT_DIGITS = 12, CONTACT_DIGITS_TEXT = 6 };

/* quantity,value,unit; two values, value_zero_overlap and value_zero_force, if the contact has one for each end at
 * which eps may have been measured. Quantities that are not known have no row. With friction, not NaN, of two spheres,
 * or a sphere and a wall: kappa, u'/u without slip, and the angle up to which they stick when they touch, in
 * degrees. Spheres have Rayleigh's time step and, if they adhere, Tabor's number. `tangential`, not NaN: the spring and
 * the dashpot of a linear contact with this tangential restitution. */
void contact_summary(struct table *table, const struct contacts *contacts, double friction, double tangential,
                     int digits);

/* Prints the meaning of Rayleigh's time step, where rows have another one, of Tabor's number, and of an
 * equivalent spring. */
void contact_print_ranges(FILE *file, const struct contacts *contacts, bool rows);

/* A row for each contact and speed of the request, with its time step, in the columns of corgen contact. The last one,
 * measured_end, is there only where there are two contacts. Errors of the step have two columns, or, where the end of
 * contact is not given and matters, two for each end. An equivalent spring has three columns of Hertz's contact, which
 * has the same eps at the speed --at and the end of the row (not given: zero overlap). A correction needs one end.
 * Returns STATUS_OK or STATUS_FAILED. */
int contact_rows(struct table *table, const struct contacts *contacts, const struct cor_simulator_request *request,
                 int digits);

/* An end of a contact as text: "zero overlap", "zero force", "the surface" */
const char *contact_end_text(const struct cor_scene_contact *contact, int end);

/* The end of a row: the end of the contact, or COR_BOTH_ENDS */
int contact_end(const struct contacts *contacts, int contact);

/* ---- lines for the input of a simulator that realise a contact (cor/scene.h) ---- */

/* The word that asks for the list of simulators instead of a name, or of the models of one instead of its version */
#define CONTACT_SIMULATOR_LIST "list"

extern const char *const contact_simulator_names[]; /* of cor_simulators, then the word for the list; ends with NULL */

/* The text of corgen contact --for HOST, malloc'ed; of a list where a word asks for it. NULL after a message if the
 * simulator cannot realise this contact, or there is no such simulator. A list takes no contacts. */
char *contact_simulator_text(const struct cor_simulator_request *request);

/* The same for all contacts of the materials of a csv file, and of another one with measured pairs, or NULL. The
 * request has a scene for law and end. */
char *contact_materials_text(struct cor_simulator_request request, const char *materials, const char *pairs);

#endif
