/* SPDX-License-Identifier: MIT */
/* All adjustable constants of the collision integrator, and the origin of each value:
 *   derived  it follows from a formula;
 *   fitted   it is the cheapest value with which all bounds hold in 10^4 random scenes, as
 *                COR_TEST_LONG=1 COR_TEST_MULTIPLIER=834 build/gcc/tests/test_disk_collision_error
 *            shows, or the command in the comment of the constant;
 *   chosen it costs time or memory, never accuracy: the error estimate follows from the actual runs. */
#ifndef COR_RUNTIME_DISK_COLLISION_TUNING_H
#define COR_RUNTIME_DISK_COLLISION_TUNING_H

enum {
    COR_COLLISION_LEVELS = 6, /* runs that one extrapolation uses. Chosen: more runs increase round-off */
    COR_COLLISION_RUNS = 12, /* runs with the same angles. Chosen: the last one takes 45 times the steps of the first */
};

/* Largest omega_max h. Derived: below pi/2, no sum of two frequencies resonates with the kicks. */
#define COR_TUNING_MAX_TURN 1.0
/* Largest alpha v h, by which the pressure's exponent rises in a step at first contact (chosen). */
#define COR_TUNING_MAX_RISE 0.8
/* Largest h^2 alpha a, where a is the rim's acceleration. If it is exceeded, the run is repeated with a smaller step.
 * Above 12 the softened pressure of (15.1) is negative (derived); 3 is a quarter of that (chosen). */
#define COR_TUNING_MAX_STIFFNESS 3.0
/* Runs with a larger tolerance start with the largest allowed step. Runs with a smaller tolerance start with a smaller
 * step, so that four or five runs suffice (chosen). */
#define COR_TUNING_EASY_TOLERANCE 1e-8
/* Largest number of times that the first step is cut; 12 cuts divide it by 2^6 (chosen). */
#define COR_TUNING_MAX_CUTS 12

/* Smallest number of angles in the quadrant (chosen). */
#define COR_TUNING_LEAST_PHI 16.0
/* The first run has alpha^(2/3) (PHI_PER_DIGIT digits - PHI_OFFSET) (v/0.1)^p + PHI_PER_N n_max angles. digits is
 * -log10 of the tolerance. p is PHI_SLOW below v = 0.1 and PHI_FAST above. alpha^(-2/3) is the width of the contact's
 * edge. Fitted: this number suffices in most collisions. */
#define COR_TUNING_PHI_PER_DIGIT 0.2
#define COR_TUNING_PHI_OFFSET 0.05
#define COR_TUNING_PHI_SLOW 0.25
#define COR_TUNING_PHI_FAST 0.6
/* Derived: for a number phi of angles the harmonic 4 phi - n aliases n; see cor_collision_quadrature_error. */
#define COR_TUNING_PHI_PER_N 0.25
/* Largest number of angles, divided by the number in the first run at COR_DISK_COLLISION_MAX_SPEED (chosen). */
#define COR_TUNING_PHI_LIMIT 2.5

/* Steps between two scans of all angles. Steps between scans evaluate the window only (chosen). */
#define COR_TUNING_SCAN_INTERVAL 8
/* Between full scans, only angles whose pressure exceeds this fraction of the peak are evaluated. Chosen: during the
 * contact no pressure grows by 10^12 relative to the peak between two scans. */
#define COR_TUNING_WINDOW_EDGE 1e-26
/* If a scan finds more than this fraction of the load at an angle outside the window, the run is repeated with full
 * scans. Derived: 100 such angles equal the round-off of a load. */
#define COR_TUNING_WINDOW_MISSED 1e-14

/* At the first and the last moment, the wall's energy relative to the disk's is COR_TUNING_WALL_LEFT times the smaller
 * of the tolerance and COR_TUNING_WALL_TOLERANCE (chosen; COR_TUNING_WALL_IN_EPS states the effect). */
#define COR_TUNING_WALL_LEFT 1e-6
#define COR_TUNING_WALL_TOLERANCE 1e-4
/* Loads of the wall below this fraction of the load at the first and the last moment are neglected (chosen). */
#define COR_TUNING_NO_LOAD 1e-3
/* Load at which a contact begins and ends, relative to the largest load (derived: the definition in cor/disk.h). */
#define COR_TUNING_CONTACT_LOAD 1e-3

/* Ratio of error to movement after two runs, which give no ratio of movements (fitted). */
#define COR_TUNING_TWO_RUNS 2.0
/* Lower bounds on the assumed ratio of successive movements, after three runs and later (fitted). */
#define COR_TUNING_THIRD_RATIO 0.4
#define COR_TUNING_LATER_RATIO 0.25
/* Lower bound on a movement, relative to the one before it (fitted). */
#define COR_TUNING_LEAST_MOVEMENT 0.01
/* NO_CONVERGENCE: above this ratio the runs do not converge. Derived: the geometric series then doubles its first term.
 * SCATTER: the error of such runs divided by the larger of the last two movements (fitted). */
#define COR_TUNING_NO_CONVERGENCE 0.5
#define COR_TUNING_SCATTER 4.0
/* If alpha v is at least this number, the wall counts as hard: runs may agree by chance (docs/theory-disks.md, 15;
 * fitted). */
#define COR_TUNING_HARD 24.0
/* At a hard wall the error after two runs is at least HARD_TWO_RUNS times the movement. Later it is at least
 * HARD_MOVEMENT times the last movement less round-off, and HARD_BEFORE times the previous movement (fitted). */
#define COR_TUNING_HARD_TWO_RUNS 20.0
#define COR_TUNING_HARD_MOVEMENT 1.5
#define COR_TUNING_HARD_BEFORE 0.02

/* Allowed error of the quadrature relative to the peak load, in units of the tolerance. Chosen: larger errors would
 * make more collisions repeat with more angles. */
#define COR_TUNING_QUADRATURE_ALLOWED 1.0
/* Error of eps divided by the error of the quadrature: the measured amplification, or COR_TUNING_BOUND_AMPLIFIES times
 * the bound on it, but at least COR_TUNING_QUADRATURE_IN_EPS. Fitted: the bound is 10^2 to 10^4 times the amplification
 * in calm collisions, and not much larger than it near chaos. */
#define COR_TUNING_QUADRATURE_IN_EPS 0.1
#define COR_TUNING_BOUND_AMPLIFIES 1e-3
/* Error of eps divided by the change of eps if the angles are shifted by half the distance of neighbours. Derived: 1/2
 * to first order. Fitted: 1.7 occurred where the change is too large for first order. */
#define COR_TUNING_ANGLES_IN_EPS 3.0
/* If more than this fraction of the tolerance may be due to the angles, a run with shifted angles measures it. Chosen:
 * a tenth allows for errors of the estimate. */
#define COR_TUNING_ANGLES_SHARE 0.1
/* If the measured fraction is larger than this, more angles are used. Chosen: a third allows for movements that are
 * small by chance. */
#define COR_TUNING_ANGLES_WANTED 0.3
/* Smallest growth of the number of angles if they are too few (chosen). */
#define COR_TUNING_LEAST_GROWTH 0.25

/* Relative change of v that measures the amplification of errors. Derived: the change is 2^13 ulp, so round-off is
 * negligible, and a collision that amplifies by 10^9 still responds linearly. */
#define COR_TUNING_PERTURBATION 0x1p-40
/* Two runs differ by at least this number times the amplification times the square of the first run's stiffness.
 * Fitted: 1e-3 in calm collisions, 1e-6 near chaos. */
#define COR_TUNING_LEAST_SENSITIVITY 1e-7
/* Factors in the error of eps due to round-off (cor_collision_other_errors). The random walk grows like sqrt(steps).
 * The steady drift grows like the steps, because a rounded rotation repeats its error in every step (fitted). */
#define COR_TUNING_RANDOM_WALK 3.0
#define COR_TUNING_STEADY_DRIFT 0.5
/* Error of eps divided by the neglected energy of the wall and by 1 + amplification (fitted). */
#define COR_TUNING_WALL_IN_EPS 4.0

/* The call gives up after COR_TUNING_PATIENCE runs if the last movement exceeds COR_TUNING_HOPELESS times the movement
 * COR_TUNING_RUNS_BEFORE runs earlier. Chosen: a run that converges reduces the movement at least fourfold. */
#define COR_TUNING_PATIENCE 9
#define COR_TUNING_RUNS_BEFORE 4
#define COR_TUNING_HOPELESS 0.25
/* Largest number of multiplications of a call, counted by cor_motion_work, unless the options give a number of steps.
 * Chosen: at 0.05 to 0.06 ns each with AVX-512 and 0.1 ns without, the call takes 5 to 10 s. */
#define COR_TUNING_WORK 1e11

#endif
