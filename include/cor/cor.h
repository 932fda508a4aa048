/* SPDX-License-Identifier: MIT */
/* cor computes coefficients of restitution of colliding viscoelastic bodies. This header includes all others. */
#ifndef COR_COR_H
#define COR_COR_H

#define COR_VERSION_MAJOR 0
#define COR_VERSION_MINOR 1
#define COR_VERSION_PATCH 0
#define COR_VERSION_STRING "0.1.0"

#include "contact.h"
#include "disk.h"
#include "law.h"
#include "sphere.h"
#include "status.h"

#endif
