/* SPDX-License-Identifier: MIT */
/* eps and duration of a contact as functions of x = speed or x = ln(speed), quick for every law: laws that take an
 * enclosed collision for each speed are interpolated between Chebyshev points. */
#ifndef COR_GEN_CONTACT_SAMPLE_FUNCTION_H
#define COR_GEN_CONTACT_SAMPLE_FUNCTION_H

#include <stddef.h>

#include "contact/contact.h"

enum { SAMPLE_QUANTITIES = 2 }; /* eps and duration */

/* The request of corgen sample */
struct sample_request {
    const struct cor_scene_contact *contact;
    const struct law *law; /* for the title of the table */
    enum contact_end end;
    double speed_min, speed_max; /* m/s */
    double tolerance;            /* relative error, SAMPLE_FINEST to SAMPLE_COARSEST */
    bool log;                    /* interpolation in the logarithm of the speed */
    bool cubic;                  /* cubic Hermite interpolation of values and slopes; otherwise linear */
    bool duration;               /* the duration, too, within the same tolerance */
};

struct sample_piece; /* of the interpolation in ln(speed) */

struct sample_function {
    const struct cor_scene_contact *contact;
    enum contact_end end;
    bool log;
    int quantities; /* 1: eps; 2: eps and duration */
    struct sample_piece *piece;
    size_t pieces;
};

/* The function without the interpolation: slow for some laws, and NaN where a collision fails */
void sample_function_direct(struct sample_function *f, const struct sample_request *request);

/* Returns STATUS_OK, or STATUS_FAILED after a message. In both cases sample_function_clear frees the memory. */
int sample_function_init(struct sample_function *f, const struct sample_request *request);
void sample_function_clear(struct sample_function *f);

double sample_function_place(const struct sample_function *f, double speed_m_s); /* x */
double sample_function_speed(const struct sample_function *f, double x);
double sample_function_at_speed(const struct sample_function *f, int quantity, double speed_m_s);
double sample_function_value(const struct sample_function *f, int quantity, double x);
/* d value/dx at a speed, by a central difference of order 6 in ln(speed); relative error below 1e-12 */
double sample_function_slope(const struct sample_function *f, int quantity, double speed_m_s);

#endif
