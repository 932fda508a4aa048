/* SPDX-License-Identifier: MIT */
/* corgen contact --for: lines for the input of a simulator that realise a contact (cor/scene.h) */
#ifndef COR_GEN_CONTACT_CONTACT_SIMULATOR_H
#define COR_GEN_CONTACT_CONTACT_SIMULATOR_H

#include "contact/contact_rows.h"

/* The word that asks for the list of simulators instead of a name, or of the models of one instead of its version */
#define CONTACT_SIMULATOR_LIST "list"

extern const char *const contact_simulator_names[]; /* of cor_simulators, then the word for the list; ends with NULL */

/* The text of corgen contact --for HOST, malloc'ed; of a list where a word asks for it. NULL after a message if the
 * simulator cannot realise this contact, or there is no such simulator. A list takes no contacts. `version` NULL: any;
 * an integrator of `step` below 0: that of the simulator */
char *contact_simulator_text(const char *simulator, const char *version, const struct contacts *contacts,
                             const double *speed_m_s, size_t speeds, const struct contact_step *step);
bool contact_simulator_is_list(const char *simulator, const char *version);

#endif
