/* SPDX-License-Identifier: MIT */
/* generated/closed_form_tables.h: eps and its inverse of the laws for which eps has a closed form. */
#ifndef COR_GEN_TABLES_CLOSED_FORMS_H
#define COR_GEN_TABLES_CLOSED_FORMS_H

#include <stdio.h>

int closed_form_tables_write(FILE *file);

#endif
