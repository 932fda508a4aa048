/* SPDX-License-Identifier: MIT */
/* The tables of corgen contact: the numbers of a contact, and a row for each impact speed. */
#ifndef COR_GEN_CONTACT_CONTACT_ROWS_H
#define COR_GEN_CONTACT_CONTACT_ROWS_H

#include <stddef.h>

#include "contact/contact.h"
#include "support/output.h"

/* Digits of a number in csv and json, and in text. The error is below COR_SCENE_MAX_ERROR. */
enum { CONTACT_DIGITS = 12, CONTACT_DIGITS_TEXT = 6 };

/* quantity,value,unit; two values, value_zero_overlap and value_zero_force, if the contact has one for each end at
 * which eps may have been measured. Quantities that are not known have no row. */
void contact_summary(struct table *table, const struct contacts *contacts, int digits);

/* Adds rows of two spheres, or a sphere and a wall: kappa, u'/u without slip, and the angle up to which they stick when
 * they touch, in degrees. */
void contact_oblique(struct table *table, const struct contacts *contacts, double friction, int digits);

/* A row for each contact and speed of the request, with its time step, in the columns of corgen contact. The last one,
 * measured_end, is there only where there are two contacts. Errors of the step have two columns, or, where the end of
 * contact is not given and matters, two for each end. A correction needs one end. Returns STATUS_OK or STATUS_FAILED.
 */
int contact_rows(struct table *table, const struct contacts *contacts, const struct cor_simulator_request *request,
                 int digits);

/* The end of a row: that of the contact, or COR_BOTH_ENDS */
int contact_end(const struct contacts *contacts, int contact);

/* ---- contact_simulator.c: lines for the input of a simulator that realise a contact (cor/scene.h) ---- */

/* The word that asks for the list of simulators instead of a name, or of the models of one instead of its version */
#define CONTACT_SIMULATOR_LIST "list"

extern const char *const contact_simulator_names[]; /* of cor_simulators, then the word for the list; ends with NULL */

/* The text of corgen contact --for HOST, malloc'ed; of a list where a word asks for it. NULL after a message if the
 * simulator cannot realise this contact, or there is no such simulator. A list takes no contacts. */
char *contact_simulator_text(const struct cor_simulator_request *request);
bool contact_simulator_is_list(const char *simulator, const char *version);

#endif
