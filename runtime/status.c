/* SPDX-License-Identifier: MIT */
#include "cor/status.h"

const char *cor_status_text(int status)
{
    switch (status) {
    case COR_OK:
        return "No error.";
    case COR_ERROR_NULL:
        return "A pointer argument is NULL.";
    case COR_ERROR_YOUNG_MODULUS:
        return "Young's modulus of each body must be positive, in Pa (infinite for a rigid body).";
    case COR_ERROR_POISSON_RATIO:
        return "Poisson's ratio of each body must be greater than -1 and at most 1/2.";
    case COR_ERROR_DISSIPATION_TIME:
        return "The dissipation time of each body must be zero or positive and finite, in s.";
    case COR_ERROR_RADIUS:
        return "The radius of each body must be positive, in m (infinite for a wall).";
    case COR_ERROR_MASS:
        return "The mass of each body must be positive, in kg (infinite for a wall).";
    case COR_ERROR_BOTH_FLAT:
        return "Both radii are infinite: two walls do not collide as spheres.";
    case COR_ERROR_BOTH_FIXED:
        return "Both masses are infinite: at least one body must be free to move.";
    case COR_ERROR_BOTH_RIGID:
        return "Both Young's moduli are infinite: at least one body must be deformable.";
    case COR_ERROR_G_STAR:
        return "The characteristic speed g* must be positive, in m/s (infinite for no "
               "dissipation).";
    case COR_ERROR_RANGE:
        return "A property of the contact is too large or too small for a double.";
    default:
        return "This number is not a status of cor.";
    }
}
