/* SPDX-License-Identifier: MIT */
/* The tables of corgen contact: the numbers of a contact, and a row for each impact speed. */
#ifndef COR_GEN_CONTACT_CONTACT_ROWS_H
#define COR_GEN_CONTACT_CONTACT_ROWS_H

#include <stddef.h>

#include "contact/contact.h"
#include "support/output.h"

/* Digits of a number in csv and json, and in text. The error is below COR_SCENE_MAX_ERROR. */
enum { CONTACT_DIGITS = 12, CONTACT_DIGITS_TEXT = 6 };
char *contact_number_text(double x, int digits); /* malloc'ed */

/* quantity,value,unit; two values, value_zero_overlap and value_zero_force, if the contact has one for each end at
 * which eps may have been measured. Quantities that are not known have no row. */
void contact_summary(struct table *table, const struct contacts *contacts, int digits);

/* A row for each contact and speed, in the columns of corgen contact; the last column, measured_end, only where
 * there are two contacts. time_step_s is the shortest duration of all rows over `steps`. Returns STATUS_OK or
 * STATUS_FAILED. */
int contact_rows(struct table *table, const struct contacts *contacts, const double *speed_m_s, size_t speeds,
                 double steps, int digits);

#endif
