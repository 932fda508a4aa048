/* SPDX-License-Identifier: MIT */
/* cor computes the coefficient of restitution eps of a collision, the rebound speed divided by the impact speed. This
 * header includes the headers of the library libcor, which needs only libm. If COR_WITH_DISK is defined, it also
 * includes the header of libcor_disk:
 *
 *     I have                                              I want                                     header
 *     materials or one measured eps, and a speed, SI      eps, duration, overlap; A; g*              contact.h
 *     beta, the dimensionless damping                     eps of viscoelastic spheres, its inverse   sphere.h
 *     the damping of a simulator's law                    eps, the damping for an eps, durations     law.h
 *     an elastic disk                                     modes, contact law, energy, collisions     disk.h
 *     a status                                            its sentence                               status.h
 *
 * Another library, libcor_scene, has the header scene.h, which computes a contact as a simulator does.
 *
 *     struct cor_body glass = {70e9, 0.22, 0.4e-6, 5e-3, cor_sphere_mass_kg(5e-3, 2500)};
 *     struct cor_sphere_contact contact;
 *     if (cor_sphere_contact_init(&contact, &glass, &glass) == COR_OK)
 *         printf("%g\n", cor_contact_eps_zero_force(&contact, 0.1));
 *
 * Unless its header states otherwise, every function has these properties:
 *
 * Threads, memory: no function has state, so several threads may call it at once. None allocates memory. Each header
 * bounds the stack.
 * Floating-point environment: no function raises FE_INVALID, FE_DIVBYZERO or FE_OVERFLOW or sets errno, whatever its
 * argument, so that programs may trap these exceptions. FE_UNDERFLOW and FE_INEXACT may be raised. All functions assume
 * rounding to nearest; nothing is guaranteed in other rounding modes. If the processor flushes subnormal numbers to
 * zero, results change by a relative 1e-9 at most (floats: 1.2e-7).
 * Arrays: a function whose name ends in _array sets y[i] to the bits of function(x[i]) for i < n. If n is 0, the
 * pointers may be NULL. x and y may be the same array, but must not overlap otherwise.
 * Bits: the same input gives the same bits on every processor. The library chooses an instruction set at run time; the
 * choice does not change a result. If a function calls exp, log, sin or atan of the C library, another C library may
 * change the last place. Rayleigh's energy and collisions of disks may change more, but far less than their error
 * estimates (docs/evidence.md#platforms has the list).
 * tests/unit/test_environment.c and test_stack.c assert these properties for every function. */
#ifndef COR_COR_H
#define COR_COR_H

#define COR_VERSION_MAJOR 1
#define COR_VERSION_MINOR 0
#define COR_VERSION_PATCH 0
#define COR_VERSION_STRING "1.0.0"

#include "contact.h"
#ifdef COR_WITH_DISK /* define it before this header is included, and link libcor_disk */
#include "disk.h"
#endif
#include "law.h"
#include "sphere.h"
#include "status.h"

#endif
