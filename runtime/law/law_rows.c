/* SPDX-License-Identifier: MIT */
/* The rows of the tables of laws, which all sources of the library share */
#define COR_ROWS_DEFINE
#include "generated/closed_form_tables.h"
#include "generated/hertz_dashpot_tables.h"
#include "generated/hunt_crossley_tables.h"
#include "generated/tsuji_tables.h"
