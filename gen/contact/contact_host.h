/* SPDX-License-Identifier: MIT */
/* Lines for the input of a simulator (a host) that realise a contact */
#ifndef COR_GEN_CONTACT_CONTACT_HOST_H
#define COR_GEN_CONTACT_CONTACT_HOST_H

#include <stdio.h>

#include "contact/contact.h"

/* The word that asks for the list instead of a host */
#define CONTACT_HOST_LIST "list"

extern const char *const contact_host_names[]; /* as in the list, then the word for it; ends with NULL */

/* The hosts, and the contact models of each for which there are lines */
void contact_host_list(FILE *file);

/* Returns STATUS_OK for one of the names, or STATUS_USAGE after a message that lists them. */
int contact_host_check(const char *host);

/* The text of corgen contact --for HOST, malloc'ed; NULL after a message if the host cannot realise this contact. Where
 * the host has the contact's law, the lines hold at every speed. Otherwise they need one impact speed and hold there.
 */
char *contact_host_text(const char *host, const struct embed_request *request, const struct contacts *contacts,
                        const double *speed_m_s, size_t speeds);

#endif
