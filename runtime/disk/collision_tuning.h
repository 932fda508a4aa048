/* SPDX-License-Identifier: MIT */
/* All constants of the collision integrator whose values are not fixed, and the origin of each value:
 *   derived  it follows from a formula;
 *   fitted   it is the cheapest value with which no promise is broken in 10^4 random scenes, as
 *                COR_TEST_LONG=1 COR_TEST_MULTIPLIER=834 build/gcc/tests/test_disk_collision_error
 *            shows, or by the command that stands there;
 *   chosen it costs time or memory, never accuracy: the error estimate follows from the actual runs. */
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
    /* error due to the step */
    double two_runs, third_ratio, later_ratio, least_movement, no_convergence, scatter;
    double hard, hard_two_runs, hard_movement, hard_before;
    /* error due to the angles */
    double quadrature_allowed, quadrature_in_eps, bound_amplifies, angles_in_eps, angles_share, angles_wanted,
        least_growth;
    /* error due to round-off and to the wall's energy */
    double perturbation, least_sensitivity, random_walk, steady_drift, wall_in_eps;
    /* when to give up */
    int patience, runs_before;
    double hopeless, work;
};

static const struct cor_collision_tuning cor_tuning = {
    /* Largest omega_max h. Derived: below pi/2, no sum of two frequencies resonates with the kicks. */
    .max_turn = 1,
    /* Largest alpha v h, by which the pressure's exponent rises in a step at first contact. Chosen. */
    .max_rise = 0.8,
    /* Largest h^2 alpha a, where a is the rim's acceleration. Beyond it the run is repeated with a smaller step.
     * Derived: above 12 the softened pressure of (15.1) is negative. Chosen: a quarter of that. */
    .max_stiffness = 3,
    /* Runs with a larger tolerance start with the largest allowed step, runs with a smaller one with a smaller step, so
     * that four or five runs suffice. Chosen. */
    .easy_tolerance = 1e-8,
    /* Largest number of cuts of the first step, 2^6 in all. Chosen. */
    .max_cuts = 12,

    /* Smallest number of angles of the quadrant. Chosen. */
    .least_phi = 16,
    /* Angles for each digit of the tolerance, over alpha^(2/3): the pressure falls off over alpha^(-2/3) at the
     * contact's edge. Fitted so that the first choice mostly suffices, as are the offset and the powers of v/0.1 below
     * and above 1. */
    .phi_per_digit = 0.2,
    .phi_offset = 0.05,
    .phi_slow = 0.25,
    .phi_fast = 0.6,
    /* Angles for each wave of a mode. Derived: products of two waves of n_max need n_max/2 angles, and the angles for
     * the pressure count as half of them; see cor_collision_angles_error. */
    .phi_per_n = 0.25,
    /* Largest number of angles over the first choice. Chosen. */
    .phi_limit = 2.5,

    /* Steps between two scans of all angles. Steps between scans evaluate the window only. Chosen. */
    .scan_interval = 8,
    /* Between full scans, only angles whose pressure exceeds this times the peak are evaluated. Chosen: between two
     * scans no pressure grows by 10^12 relative to the peak during the contact. */
    .window_edge = 1e-26,
    /* If a scan finds more than this part of the load at an angle outside the window, the run is repeated with full
     * scans. Derived: 100 such angles equal the round-off of a load. */
    .window_missed = 1e-14,

    /* Energy of the wall at the first and the last moment, relative to that of the disk, over the smaller of the
     * tolerance and wall_tolerance. Chosen: see wall_in_eps. */
    .wall_left = 1e-6,
    .wall_tolerance = 1e-4,
    /* The wall's force is neglected below this part of the load at those moments. Chosen. */
    .no_load = 1e-3,
    /* Load that begins and ends a contact, relative to the largest load. Derived: from the definition in cor/disk.h. */
    .contact_load = 1e-3,

    /* Error over movement after two runs, which give no ratio of movements. Fitted. */
    .two_runs = 2,
    /* Lower bounds on the assumed ratio of successive movements, after three runs and later. Fitted. */
    .third_ratio = 0.4,
    .later_ratio = 0.25,
    /* Lower bound on a movement, relative to the one before it. Fitted. */
    .least_movement = 0.01,
    /* Above this ratio the runs do not converge. Derived: the geometric series then doubles its first term. The second
     * number is the error of such runs over the larger of the last two movements. Fitted. */
    .no_convergence = 0.5,
    .scatter = 4,
    /* Smallest alpha v of a hard wall, at which runs may agree by chance; docs/theory-disks.md, 15. Fitted. */
    .hard = 24,
    /* At a hard wall, lower bounds on the error: over the movement after two runs, over the last movement less
     * round-off, and over the movement before. Fitted. */
    .hard_two_runs = 20,
    .hard_movement = 1.5,
    .hard_before = 0.02,

    /* Allowed error of the quadrature relative to the peak load, in units of the tolerance. Chosen: with larger errors
     * more collisions would have to be repeated with more angles. */
    .quadrature_allowed = 1,
    /* Error of eps over that of the quadrature: at least quadrature_in_eps, at most the measured amplification or
     * bound_amplifies times the bound on it. Fitted: the bound is 10^2 to 10^4 times the amplification in calm
     * collisions, and not much more than it near chaos. */
    .quadrature_in_eps = 0.1,
    .bound_amplifies = 1e-3,
    /* Error of eps over the movement by angles that are shifted by half their distance. Derived: half, to first order.
     * Fitted: 1.7 was met where the movement is too large for first order. */
    .angles_in_eps = 3,
    /* If more than this part of the tolerance may be due to the angles, a run with shifted angles measures it. Chosen:
     * 10 allows for errors of the estimate. */
    .angles_share = 0.1,
    /* If the measured part is larger than this, more angles are taken. Chosen: a third allows for a movement that is
     * small by chance. */
    .angles_wanted = 0.3,
    /* Growth of the number of angles if they are too few. Chosen. */
    .least_growth = 0.25,

    /* Relative change of v that measures the amplification of errors. Derived: the change is 2^13 ulp, so round-off is
     * negligible beside it, and a collision that amplifies by 10^9 still responds linearly. */
    .perturbation = 0x1p-40,
    /* Lower bound on the difference of two runs over the amplification and the square of the first run's stiffness.
     * Fitted: 1e-3 in calm collisions, 1e-6 near chaos. */
    .least_sensitivity = 1e-7,
    /* Error of eps due to round-off, in 2^-53. random_walk: over amplification and sqrt(steps). steady_drift: over
     * amplification, amplitudes and steps, because a rounded rotation repeats the same error in every step. Fitted. */
    .random_walk = 3,
    .steady_drift = 0.5,
    /* Error of eps over the neglected energy of the wall and the amplification. Fitted. */
    .wall_in_eps = 4,

    /* Give up after `patience` runs if the last movement exceeds `hopeless` times the movement `runs_before` runs
     * earlier. Chosen: each run of a converging sequence reduces the movement at least fourfold. */
    .patience = 9,
    .runs_before = 4,
    .hopeless = 0.25,
    /* Largest number of multiplications of a call, counted by cor_motion_work, unless the options give a number of
     * steps. Chosen: at 0.05 to 0.06 ns each with AVX-512 and 0.1 ns without, the call takes 5 to 10 s. */
    .work = 1e11,
};

#endif
