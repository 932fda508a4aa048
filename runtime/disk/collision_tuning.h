/* SPDX-License-Identifier: MIT */
/* Every constant of the integrator of collisions that could have another value, and where its value comes from:
 *   derived  it follows from a formula;
 *   fitted   it is the cheapest value with which no promise is broken in 10^4 random scenes, as
 *                COR_TEST_MULTIPLIER=500 build/gcc/tests/test_disk_collision_random
 *            shows, or by the command that stands there;
 *   chosen   it costs time or memory, never accuracy: the error is estimated from what was done. */
#ifndef COR_RUNTIME_DISK_COLLISION_TUNING_H
#define COR_RUNTIME_DISK_COLLISION_TUNING_H

enum {
    COR_COLLISION_LEVELS = 6, /* runs that one extrapolation uses. Chosen: with more, round-off grows */
    COR_COLLISION_RUNS = 12, /* runs with the same angles. Chosen: the last one takes 45 times the steps of the first */
    COR_COLLISION_ALIGNMENT = 64 /* of arrays. Derived: bytes of the widest vector */
};

struct cor_collision_tuning {
    /* the step h */
    double max_turn, max_rise, max_stiffness, easy_tolerance;
    int max_cuts;
    /* the angles */
    double least_phi, phi_per_digit, phi_offset, phi_slow, phi_fast, phi_per_n, phi_limit;
    /* the window of angles near the contact */
    int scan_interval;
    double window_edge, window_missed;
    /* the wall where there is no contact */
    double wall_left, wall_tolerance, no_load, contact_load;
    /* error by the step */
    double two_runs, third_ratio, later_ratio, least_movement, no_convergence, scatter;
    /* error by the angles */
    double angles_allowed, angles_in_eps, calm;
    /* error by round-off and by the wall's energy */
    double perturbation, least_sensitivity, random_walk, steady_drift, wall_in_eps;
    /* when to give up */
    int patience, runs_before;
    double hopeless, work;
};

static const struct cor_collision_tuning cor_tuning = {
    /* omega_max h, at most. Derived: below pi/2, no two frequencies add up to one that resonates with the kicks. */
    .max_turn = 1,
    /* alpha v h, at most: the pressure's exponent rises by this in a step at first contact. Chosen. */
    .max_rise = 0.8,
    /* h^2 alpha a, a the rim's acceleration, at most: else the run is repeated with a smaller step. Derived: above 12 the
     * softened pressure of (15.1) is negative. Chosen: 4 times below. */
    .max_stiffness = 3,
    /* Larger tolerances start with the largest step allowed, smaller ones with less, so that four or five runs suffice.
     * Chosen. */
    .easy_tolerance = 1e-8,
    /* times that the first step may be cut. Chosen: 2^6 */
    .max_cuts = 12,

    /* Angles of the quadrant, at least. Chosen. */
    .least_phi = 16,
    /* Angles for each digit of the tolerance, over alpha^(2/3): the pressure falls off over alpha^(-2/3) at the contact's
     * edge. Fitted, so that mostly the first choice serves; as the offset and the powers of v/0.1 below and above 1. */
    .phi_per_digit = 0.2,
    .phi_offset = 0.05,
    .phi_slow = 0.25,
    .phi_fast = 0.6,
    /* Angles for each wave of a mode. Derived: products of two waves of n_max need n_max/2 angles; half is for the
     * pressure, see angles_error. */
    .phi_per_n = 0.25,
    /* Angles that are tried at most, over the first choice. Chosen. */
    .phi_limit = 2.5,

    /* Steps between two scans of all angles; in between, the window is evaluated. Chosen. */
    .scan_interval = 8,
    /* The window ends where the pressure is below this part of the peak. Chosen: between two scans no pressure grows by
     * 10^12 relative to the peak while there is a load. */
    .window_edge = 1e-26,
    /* If a scan finds more than this part of the load at an angle outside the window, the run is repeated with scans at
     * every step. Derived: 100 such angles are the round-off of a load. */
    .window_missed = 1e-14,

    /* Energy of the wall at the first and the last moment, over that of the disk and over the tolerance or
     * wall_tolerance, whichever is smaller. Chosen: see wall_in_eps. */
    .wall_left = 1e-6,
    .wall_tolerance = 1e-4,
    /* The wall's force is left out below this part of the load at those moments. Chosen. */
    .no_load = 1e-3,
    /* Load that begins and ends a contact, over the largest. Derived: cor/disk.h defines it so. */
    .contact_load = 1e-3,

    /* Error over movement after two runs, which show no ratio of movements. Fitted. */
    .two_runs = 2,
    /* Ratio of successive movements that is believed at least, after three runs and later. Fitted. */
    .third_ratio = 0.4,
    .later_ratio = 0.25,
    /* A movement counts as this part of the one before it at least. Fitted. */
    .least_movement = 0.01,
    /* Ratio from which on the runs do not converge, and the error over the larger of the last two movements then.
     * Derived: the sum of a geometric series doubles its first term; fitted. */
    .no_convergence = 0.5,
    .scatter = 4,

    /* Error of the quadrature relative to the peak load, over the tolerance, at most. Fitted. */
    .angles_allowed = 1,
    /* Error of eps over that of the quadrature. Fitted: the largest of 10^4 scenes is 0.02. */
    .angles_in_eps = 0.1,
    /* A run that moves eps by more amplifies the quadrature's error. Fitted: the first runs of a calm collision move it by
     * 1e-5 to 1e-4. */
    .calm = 1e-4,

    /* Relative change of v that measures the amplification of errors. Derived: 2^13 ulp, so round-off is nothing beside
     * it, and a collision that amplifies by 10^9 still responds in proportion. */
    .perturbation = 0x1p-40,
    /* Two runs differ by this at least, over the amplification and the square of max_stiffness of the first of them.
     * Fitted: 1e-3 in calm collisions, 1e-6 near chaos. */
    .least_sensitivity = 1e-7,
    /* Error of eps by round-off, in 2^-53: over amplification and sqrt(steps), and over amplification, amplitudes and steps,
     * for a rotation that is rounded turns all steps by the same error. Fitted. */
    .random_walk = 3,
    .steady_drift = 0.5,
    /* Error of eps over the wall's energy left out and the amplification. Fitted. */
    .wall_in_eps = 4,

    /* Give up after so many runs if the last movement exceeds that part of the one so many runs before: each run would do
     * better by 4 at least. Chosen. */
    .patience = 9,
    .runs_before = 4,
    .hopeless = 0.25,
    /* Multiplications of a call, at most, unless the options give a number of steps, counted by cor_motion_work. Chosen: at
     * 0.05 to 0.06 ns with AVX-512 and 0.1 ns without, this is 5 to 10 s. */
    .work = 1e11,
};

#endif
