# SPDX-License-Identifier: MIT
"""Computes the collisions of docs/paper/collisions.csv by the full dynamics, and the paper's two extrapolations from
them (section 4). Also computes the exact limit: a disk with all its modes at a rigid wall."""
import collections
import concurrent.futures
import ctypes
import functools
import math
import os
import random
import statistics
import sys
import time

from library import MATERIALS, ROOT, constant, cor, judge

COLLISIONS = ROOT / "docs" / "paper" / "collisions.csv"
CSV_HEAD = "nu,modes,alpha,speed,converged,one_minus_eps2,contact_time,max_compression"
TOLERANCE = 1e-8  # absolute error allowed in eps
# Values of alpha v, the rate at which the wall's force grows on impact; a hard wall needs a rate above omega of the
# modes. WALLS: used in all extrapolations. OTHER_WALLS: used in none
WALLS, OTHER_WALLS = (25, 50, 100), (10, 15, 200)
# Numbers of modes N. PAPER_SPEEDS use all, SLOW_SPEEDS use LARGE. limit_of extrapolates from LARGE, the paper from FEW
SIZES = (300, 400, 600, 940, 1300, 1800)
FEW, LARGE = SIZES[:4], SIZES[3:]
# Tolerances of 1 - eps^2 at the rigid wall: for numbers in texts, and for lines in pictures
RIGID_TOLERANCE, RIGID_LINE_TOLERANCE = 2e-5, 1e-4


def rounded(x):
    """Rounds a number to the digits of the csv file."""
    return float("%.5g" % x)


def log_point(a, b, i, n):
    """Returns number i of n points from a to b, with equal steps in the logarithm."""
    return a * (b / a)**(i / (n - 1))


PAPER_SPEEDS = [rounded(v) for v in [0.005, 0.01] + [0.02 * i for i in range(1, 16)]]
SLOW_SPEEDS = [rounded(log_point(1e-3, 0.1, i, 28)) for i in range(28)]  # for oscillation

Key = collections.namedtuple("Key", "nu modes alpha speed")
Collision = collections.namedtuple("Collision", "converged one_minus_eps2 contact_time max_compression")
table = {}  # Key -> Collision; converged is false for a chaotic collision


def key_of(nu, modes, rate, speed):
    return Key(nu, modes, rounded(rate / speed), speed)


def find(nu, modes, rate, speed):
    """Returns a collision, or None if its alpha is out of the range of cor_disk_collision."""
    return table.get(key_of(nu, modes, rate, speed))


def planned():
    keys = []
    for v in PAPER_SPEEDS:
        keys += [key_of(nu, n, rate, v) for n in SIZES for rate in WALLS for nu in MATERIALS]
        keys += [key_of(0.33, FEW[-1], rate, v) for rate in OTHER_WALLS]
    for v in SLOW_SPEEDS:
        keys += [key_of(0.33, n, rate, v) for n in LARGE for rate in WALLS]
        keys.append(key_of(0.33, FEW[-1], OTHER_WALLS[-1], v))
    least, most = constant("COR_DISK_COLLISION_MIN_ALPHA"), constant("COR_DISK_COLLISION_MAX_ALPHA")
    return [key for key in dict.fromkeys(keys) if least <= key.alpha <= most]


def compute(keys):
    """Computes these collisions on every core, with progress on a terminal."""

    def collide(key):
        out, converged, _, _ = MATERIALS[key.nu].collision(key.modes, key.alpha, key.speed, TOLERANCE)
        return Collision(converged, out.one_minus_eps2, out.contact_time, out.max_compression)

    start, computed = time.monotonic(), {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done, (key, collision) in enumerate(zip(keys, pool.map(collide, keys)), 1):
            computed[key] = collision
            if sys.stderr.isatty():
                left = (time.monotonic() - start) / done * (len(keys) - done)
                print("\rcollisions: %d of %d, %.0f s left   " % (done, len(keys), left), end="", file=sys.stderr)
    return computed


def row_of(key, collision):
    return "%g,%d,%.5g,%.5g,%d,%.6f,%.3f,%.5g" % (key + collision)


def read_row(row):
    nu, modes, *number = map(float, row.split(","))
    return Key(nu, int(modes), *number[:2]), Collision(*number[2:])


def make_table():
    # Figures use exactly the numbers in the file.
    table.update(read_row(row_of(key, collision)) for key, collision in compute(planned()).items())


def agree(old, new):
    """True if two results for a collision agree up to tolerance and rounding. Limits are wider for chaotic collisions,
    which did not converge, and for contact times, because the load oscillates as the contact ends."""
    off = abs(old.one_minus_eps2 - new.one_minus_eps2)
    if not old.converged and not new.converged:
        return off <= 5e-3
    return (old.converged == new.converged and off <= 2 * TOLERANCE + 1e-6 and
            abs(old.contact_time - new.contact_time) <= 2e-3 and
            abs(old.max_compression / new.max_compression - 1) <= 1e-4)


def read_table(sample):
    """Reads collisions.csv, whose rows must be the planned ones. Computes `sample` random rows again (seed: COR_SEED),
    or all if None. Returns True if they agree."""
    head, *rows = COLLISIONS.read_text(encoding="ascii").splitlines()
    table.update(map(read_row, rows))
    if [head, *table] != [CSV_HEAD, *planned()] or rows != [row_of(*item) for item in table.items()]:
        sys.exit("paper: %s is not what is computed; paper/run computes it again" % COLLISIONS)
    seed = int(os.environ.get("COR_SEED", "19990101"))
    again = compute(random.Random(seed).sample(list(table), sample) if sample else list(table))
    wrong = [row_of(key, collision) for key, collision in again.items() if not agree(table[key], collision)]
    for row in wrong:
        print("paper: %s should have %s" % (COLLISIONS, row), file=sys.stderr)
    return not wrong


# ---- extrapolations ----

Line = collections.namedtuple("Line", "slope at_zero")
Limit = collections.namedtuple("Limit", "one_minus_eps2 uncertainty")


def fit_line(x, y):
    return Line(*statistics.linear_regression(x, y))


def wall_line(nu, modes, speed, walls=WALLS):
    """Fits 1 - eps^2 = slope/alpha + at_zero at fixed N. Here and below, a missing collision gives NaN."""
    keys = [key_of(nu, modes, rate, speed) for rate in walls]
    if not all(key in table for key in keys):
        return Line(math.nan, math.nan)
    return fit_line([1 / key.alpha for key in keys], [table[key].one_minus_eps2 for key in keys])


def size_line(nu, speed, sizes, walls=WALLS):
    """Fits the values wall_line(...).at_zero by slope/sqrt(N) + at_zero."""
    return fit_line([1 / math.sqrt(n) for n in sizes], [wall_line(nu, n, speed, walls).at_zero for n in sizes])


def limit_of(nu, speed):
    """Returns the limit extrapolated from N = 940 and above. uncertainty: the largest change of the limit if the
    first N, last N, first wall or last wall is omitted, or if the paper's N = 300 to 940 are used."""
    best = size_line(nu, speed, LARGE).at_zero
    other = [size_line(nu, speed, LARGE[:-1]), size_line(nu, speed, LARGE[1:]), size_line(nu, speed, LARGE, WALLS[:-1]),
             size_line(nu, speed, LARGE, WALLS[1:]), size_line(nu, speed, FEW)]
    return Limit(best, max(abs(line.at_zero - best) for line in other if not math.isnan(line.at_zero)))


@functools.lru_cache(maxsize=None)
def hard_wall(nu, speed, tolerance=RIGID_TOLERANCE):
    """Computes a collision with all modes at a rigid wall."""
    out, options = cor.struct.disk_hard_wall(), cor.struct.disk_hard_wall_options(tolerance, ctypes.c_size_t(-1).value)
    judge(cor.disk_hard_wall_nu(nu, ctypes.byref(options), speed, ctypes.byref(out)), "rigid wall, v = %g" % speed,
          "COR_TOLERANCE_NOT_REACHED")
    return out
