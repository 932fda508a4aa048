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
    case COR_ERROR_DISK_POISSON_RATIO:
        return "Poisson's ratio of a disk must be between -1 and 1.";
    case COR_ERROR_DATUM:
        return "The datum must be one of enum cor_disk_datum.";
    case COR_ERROR_SPEED:
        return "The impact speed must be zero or positive, and at most cor_disk_speed_limit().";
    case COR_ERROR_MODES:
        return "The table must contain at least the requested number of modes (one or more), sorted by frequency.";
    case COR_ERROR_TOLERANCE:
        return "The tolerance must be between 0 and 1.";
    case COR_ERROR_FILE:
        return "The file cannot be opened or read.";
    case COR_ERROR_FILE_VERSION:
        return "The file is not a mode file of the version that this library reads.";
    case COR_ERROR_FILE_DAMAGED:
        return "The mode file was changed after corgen wrote it, or is incomplete.";
    case COR_ERROR_CAPACITY:
        return "The array is too small for the modes in the file.";
    case COR_BEYOND_THEORY:
        return "The collision is too violent for perturbation theory; the result is stored, but may be wrong.";
    case COR_TOLERANCE_NOT_REACHED:
        return "The tolerance cannot be met with this table or these steps; the best result is stored.";
    case COR_WALL_NOT_TOUCHED:
        return "The disk does not move towards the wall; there is no collision.";
    case COR_CONTACT_NOT_ENDED:
        return "The contact needs more steps than the allowed number.";
    case COR_ERROR_ALPHA:
        return "The hardness alpha of the wall must be from 40 to 1e5.";
    case COR_ERROR_PHI_POINTS:
        return "There are more angles than COR_DISK_COLLISION_MAX_PHI_POINTS.";
    case COR_ERROR_WORKSPACE:
        return "The workspace is smaller than cor_disk_collision_workspace() bytes.";
    case COR_ERROR_MEMORY:
        return "The workspace could not be allocated.";
    case COR_ERROR_DENSITY:
        return "The density must be positive and finite.";
    case COR_ERROR_THICKNESS:
        return "The thickness must be positive and finite.";
    default:
        return "This number is not a status of cor.";
    }
}
