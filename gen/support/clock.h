/* SPDX-License-Identifier: MIT */
/* The clocks of corgen. */
#ifndef COR_GEN_SUPPORT_CLOCK_H
#define COR_GEN_SUPPORT_CLOCK_H

/* Seconds of a clock that only goes forward; differences count. */
double clock_seconds(void);

/* Seconds of processor time that this process has used, all threads together. */
double clock_processor_seconds(void);

#endif
