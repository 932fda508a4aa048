#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The figures of Gerl and Zippelius, Phys. Rev. E 59, 2361 (1999). Each function returns the rows of
docs/paper/NAME.csv, which NAME.gp, if it exists, draws as docs/paper/NAME.svg. It also returns a paragraph on where
the figure agrees with the paper, where not, and why. paper/run starts this program and documents its options."""
import math
import sys
import textwrap
from math import cos, nan, sin, sqrt

from dynamics import (CSV_HEAD, FEW, LARGE, OTHER_WALLS, PAPER_SPEEDS, RIGID_LINE_TOLERANCE, SIZES, SLOW_SPEEDS,
                      TOLERANCE, WALLS, find, hard_wall, key_of, limit_of, log_point, make_table, read_table, row_of,
                      size_line, table, wall_line)
from library import DATUM, MATERIALS, ROOT, RelaxedDisk, constant, cor, jn

NU = 0.33
DISK = MATERIALS[NU]
CENTRE_OF_MASS = DATUM["centre_of_mass"]
FIGURES = []


def figure(paper, subject):
    def add(function):
        FIGURES.append((paper, function.__name__, subject, function))
        return function

    return add


def cells(*values):
    """Returns csv cells with six digits, each after a comma; NaN gives an empty cell."""
    return "".join("," if math.isnan(value) else ",%.6g" % value for value in values)


def known(values):
    return [value for value in values if not math.isnan(value)]


def watch(n_modes, alpha, speed, visit):
    out, _, average, after = DISK.collision(n_modes, alpha, speed, 1e-9, visit)
    return out, average, after


@figure("Data", "collisions of the full dynamics")
def collisions():
    off = sum(not collision.converged for collision in table.values())
    reached = f"{off} of them, mostly chaotic, do not reach it" if off else "All reach it"
    return [CSV_HEAD] + [row_of(*item) for item in table.items()], (
        f"{len(table)} collisions, each with the tolerance {TOLERANCE:g} on eps. {reached}. They have at most "
        f"{SIZES[-1]} modes, like the tables in the library.")


@figure("Fig. 1", "eps against speed")
def restitution():
    """Draws eps from the two extrapolations of section 4."""
    rows, eps, worst, apart, last = ["nu,speed,eps,eps_low,eps_high,one_minus_eps2,uncertainty"], {}, 0, 0, {}
    for nu in MATERIALS:
        for v in PAPER_SPEEDS:
            loss, uncertainty = limit_of(nu, v)
            eps[nu, v] = sqrt(1 - loss)
            low, high = sqrt(1 - loss - uncertainty), sqrt(1 - loss + uncertainty)
            rows.append("%g,%g" % (nu, v) + cells(eps[nu, v], low, high) + ",%.5f,%.5f" % (loss, uncertainty))
            worst = max(worst, uncertainty / (2 * eps[nu, v]))
            wall = hard_wall(nu, v)
            apart = max(apart, abs(loss - wall.one_minus_eps2) / (uncertainty + wall.error_estimate))
        rows += ["", ""] if nu == NU else []
    best = max(PAPER_SPEEDS, key=lambda v: eps[NU, v])
    least = PAPER_SPEEDS[0]
    return rows, (
        f"Agrees: eps falls as v grows, and is smaller for nu = 0.9. Here eps(0.1) = {eps[NU, 0.1]:.3f} at nu = 0.33 "
        f"and {eps[0.9, 0.1]:.3f} at 0.9, eps(0.3) = {eps[NU, 0.3]:.3f} and {eps[0.9, 0.3]:.3f}. Their uncertainty is "
        f"the largest change if the extrapolation uses fewer or other modes and walls. It is at most {worst:.4f}, less "
        f"than the size of the points. The line is the computed limit, all modes at a rigid wall: "
        f"{hard_wall(NU, 0.1).eps:.5f} and {hard_wall(0.9, 0.1).eps:.5f} at v = 0.1, {hard_wall(NU, 0.3).eps:.5f} and "
        f"{hard_wall(0.9, 0.3).eps:.5f} at 0.3. The points differ from it by at most {apart:.1f} times the sum of both "
        f"uncertainties. Does not agree: the text gives about 0.65 at nu = 0.9, v = 0.3, and a steady rise to one as v "
        f"falls. Here eps at nu = 0.33 is {eps[NU, best]:.4f} at v = {best:g} but {eps[NU, least]:.4f} at {least:g}.")


# ---- the modes ----


class Shape:
    """Displacements of a free mode, (19): u_r(r) cos(n phi), u_phi(r) sin(n phi). The boundary conditions
    (22), (23) give the ratio A : B; the larger of C and S at the rim gives the scale. u_r and u_phi are as in (27),
    but with kappa and kappa' as in (19)."""

    def __init__(self, mode):
        self.mode, self.a, self.b = mode, 1, 0
        self.kappa = mode.omega * sqrt(1 - NU * NU), mode.omega * sqrt(2 * (1 + NU))
        if mode.n > 0:
            # (22)/(1 - nu) and (23)/2 have the form p A + q B = 0. The one with the larger coefficients is used,
            # because it is more accurate.
            n, diagonal = mode.n, mode.omega * mode.omega * (1 + NU) - mode.n * mode.n
            (a, a_slope), (b, b_slope) = self.bessel(1)
            pairs = (-(a_slope + diagonal * a), n * (b_slope - b)), (-n * (a_slope - a), b_slope + diagonal * b)
            p, self.a = max(pairs, key=lambda pair: abs(pair[0]) + abs(pair[1]))
            self.b = -p
        u_r, u_phi = self.displacement(1)
        scale = mode.c / u_r if abs(mode.c) >= abs(mode.s) else mode.s / u_phi
        self.a, self.b = self.a * scale, self.b * scale

    def bessel(self, r):
        """Returns J_n and z times its derivative, for both arguments z."""
        n = self.mode.n
        for z in (kappa * r for kappa in self.kappa):
            j = jn(n, z)
            yield j, -z * jn(1, z) if n == 0 else z * jn(n - 1, z) - n * j

    def displacement(self, r):
        """Returns u_r and u_phi, 0 < r <= 1."""
        n, ((a, a_slope), (b, b_slope)) = self.mode.n, self.bessel(r)
        return (self.a * a_slope + n * self.b * b) / r, -(n * self.a * a + self.b * b_slope) / r

    def norm(self):
        """Returns int (u_r^2 + u_phi^2) r dr, (26), by Simpson's rule. It should be 1, or 1/2 for n = 0. The sum omits
        r = 0, where the integrand is 0."""
        steps = 2000
        terms = ((1 if i == steps else 4 if i % 2 else 2) * math.hypot(*self.displacement(i / steps))**2 * i / steps
                 for i in range(1, steps + 1))
        return sum(terms) / (3 * steps)


def drawing(point, circles, radii, angles, steps, stride):
    """Returns circles, the rim and radii of a distorted disk as rows name,x,y, one for each point. point(r, phi): the
    displaced point. An empty row ends each curve, for gnuplot."""
    rows = []
    for i in range(1, circles + 1):
        rows += ["%s,%.4f,%.4f" % ("circle" if i < circles else "rim", *point(i / circles, 2 * math.pi * k / angles))
                 for k in range(0, angles + 1, 2 if i < circles else 1)] + [""]
    for i in range(radii):
        rows += ["radius,%.4f,%.4f" % point(k / steps, 2 * math.pi * i / radii)
                 for k in range(0, steps + 1, stride)] + [""]
    return rows


def displaced(x, r, phi, u_r, u_phi):
    return x + (r + u_r) * cos(phi) - u_phi * sin(phi), (r + u_r) * sin(phi) + u_phi * cos(phi)


def headed(head, rows):
    return [row and head + row for row in rows]


@figure("Fig. 2", "three simple modes: circles and radii, distorted")
def shapes():
    """C and S of the mode table come from another route, a closed form in omega, so the displacements and the
    integral (26) must agree."""
    rows, lowest = ["n,l,omega,line,x,y"], [next(m for m in DISK.modes if (m.n, m.l) == (n, 0)) for n in (2, 1, 0)]
    for mode in lowest:
        shape = Shape(mode)
        u_r, u_phi = shape.displacement(1)
        worst = max(abs(u_r - mode.c), abs(u_phi - mode.s), abs(shape.norm() - (1 if mode.n > 0 else 0.5)))
        if not worst <= 1e-9:
            sys.exit("paper: the displacements are not those of C and S of the mode table by %.2g" % worst)
        # the largest displacement is 0.22 R
        scale = 0.22 / max(abs(u) for i in range(1, 101) for u in shape.displacement(i / 100))

        def point(r, phi):
            u_r, u_phi = shape.displacement(max(r, 1e-6))
            return displaced(0, r, phi, u_r * (scale * cos(mode.n * phi)), u_phi * (scale * sin(mode.n * phi)))

        rows += headed("%d,%d,%.5f," % mode[:3], drawing(point, 5, 24, 72, 6, 1)) + [""]
    omega = [mode.omega for mode in lowest]
    return rows, (
        f"Agrees with the text (the caption names no modes). The three lowest modes are the quadrupole (n, l) = (2, 0) "
        f"at omega = {omega[0]:.6f}, (1, 0) at {omega[1]:.6f} and (0, 0) at {omega[2]:.6f}. The centre of (1, 0) moves "
        f"against the rim. (19) gives the displacements; (27), which repeats it, exchanges kappa and kappa' in u_phi. "
        f"Normalised by (26), u_r and u_phi at the rim equal C and S of the mode table to better than 1e-9.")


@figure("Fig. 3", "frequencies of the free modes, radial and tangential")
def spectrum():
    """Modes are radial if |C| > |S|, else tangential. The rows omit high modes; the text counts all 1800."""

    def radial(mode):
        return abs(mode.c) > abs(mode.s)

    rows = ["n,l,omega,C,S,motion"] + [
        "%d,%d,%.6f,%.5f,%.5f,%s" % (mode + ("radial" if radial(mode) else "tangential",))
        for mode in DISK.modes if mode.omega < 32 and mode.n <= 40]
    others = [mode for mode in DISK.modes if mode.n > 0]
    ratio = [abs(mode.c / mode.s) for mode in others if mode.l >= 20 * mode.n]
    of_n = {}
    for mode in others:
        of_n.setdefault(mode.n, []).append(mode)
    distance, mode = min((b.omega / a.omega - 1, a) for row in of_n.values() for a, b in zip(row, row[1:]))
    return rows, (
        f"Agrees with the text: smooth rows for small l, an irregular mixture for l >> n, more tangential modes than "
        f"radial ones. The lowest {DISK.count} modes at nu = {NU} reach omega = {DISK.omega[-1]:.3f} and n = "
        f"{max(of_n)}. {DISK.count - len(others)} of them have n = 0; {sum(map(radial, others))} of the others move "
        f"the rim more radially (|C| > |S|), {len(others) - sum(map(radial, others))} more tangentially. For "
        f"{sum(x > 10 or x < 0.1 for x in ratio)} of the {len(ratio)} with l >= 20 n, |C/S| is above 10 or below 1/10. "
        f"The closest frequencies of one n are l = {mode.l} and {mode.l + 1} of n = {mode.n}: their "
        f"relative difference is {distance:.1e}.")


@figure("Fig. 5", "shape of the disk in time")
def sequence():
    """Displacements are (37), at the rim (39), with the amplitudes of the full dynamics. From the last
    step to the time of a picture the disk moves freely, so the wall's force is neglected for less than a step."""
    modes, alpha, speed, frames, steps = 940, 500, 0.2, 10, 12  # one frame per unit of time
    film, closest = [None] * frames, (-2, nan)

    def expose(moment, q, q_dot):
        nonlocal closest
        closest = max(closest, (moment.position, moment.time))
        for i in range(frames):
            if moment.time <= i:
                film[i] = moment.time, moment.position, moment.velocity, q[:], q_dot[:]

    out = watch(modes, alpha, speed, expose)[0]
    # u_r and u_phi of each mode at each radius
    shape = list(map(Shape, DISK.modes[:modes]))
    ring = [[one.displacement(i / steps if i else 1e-6) for one in shape] for i in range(steps + 1)]
    n_max = max(one.mode.n for one in shape)
    rows, extent = ["time,line,x,y"], []
    for frame, (time, position, velocity, q, q_dot) in enumerate(film):
        left = frame - time
        position += velocity * left
        amplitude = [a * cos(omega * left) + b / omega * sin(omega * left) for omega, a, b in zip(DISK.omega, q, q_dot)]
        # sums over l of Q u_r and Q u_phi, for each radius and n
        sums = [([0.0] * (n_max + 1), [0.0] * (n_max + 1)) for _ in ring]
        for (radial, tangential), displacements in zip(sums, ring):
            for one, a, (u_r, u_phi) in zip(shape, amplitude, displacements):
                radial[one.mode.n] += a * u_r
                tangential[one.mode.n] += a * u_phi
        rim = []

        def point(r, phi):
            radial, tangential = sums[round(r * steps)]
            u_r = sum(u * cos(n * phi) for n, u in enumerate(radial))
            u_phi = sum(u * sin(n * phi) for n, u in enumerate(tangential))
            rim.append(displaced(position, r, phi, u_r, u_phi))
            return rim[-1]

        rows += headed("%g," % frame, drawing(point, 4, 16, 96, steps, 2)) + [""] * (frame < frames - 1)
        x, y = zip(*rim)
        extent.append((max(x) - min(x), 2 * max(y)))
    after = [breadth for frame, (breadth, _) in enumerate(extent) if frame > out.contact_time + 1]
    return rows, (
        f"Agrees: the oscillations after the collision are visible. The picture has v = {speed}, nu = 0.33, alpha = "
        f"{alpha} and {modes} modes, and is true to scale; the caption gives only v. The disk is closest at "
        f"t = {closest[1]:.2f}, with delta = {out.max_compression:.4f}; at t = 3 it is {extent[3][0]:.2f} wide and "
        f"{extent[3][1]:.2f} high. The contact lasts {out.contact_time:.2f}; in the pictures after it the width is "
        f"{min(after):.2f} to {max(after):.2f}.")


def energy_of(omega, q, q_dot, speed):
    """Returns the energy of a mode as a fraction of (pi/2) v^2."""
    return (omega * q * (omega * q) + q_dot * q_dot) / (speed * speed)


@figure("Fig. 6", "energy of the modes at closest approach")
def energies():
    speed, closest = 0.1, (-2, )

    def keep(moment, q, q_dot):
        nonlocal closest
        if moment.position > closest[0]:
            closest = moment.position, moment.time, q[:], q_dot[:]

    watch(1600, 500, speed, keep)
    energy = {(mode.n, mode.l): energy_of(mode.omega, q, q_dot, speed)
              for mode, q, q_dot in zip(DISK.modes, closest[2], closest[3])}
    rows = ["n,l,energy"] + ["%d,%d,%.3e" % (n, l, e) for (n, l), e in energy.items() if n <= 20 and l <= 20]
    return rows, (
        f"Agrees: the quadrupole dominates, with {100 * energy[2, 0]:.1f} % of (pi/2) v^2 at closest approach, t = "
        f"{closest[1]:.2f}. All modes hold {100 * sum(energy.values()):.1f} %, those with l = 0 "
        f"{100 * sum(e for (n, l), e in energy.items() if l == 0):.1f} %, those with n = 0 "
        f"{100 * sum(e for (n, l), e in energy.items() if n == 0):.1f} %. The caption's (n = 0, l = 2) means n = 2, l "
        f"= 0: the mode that it names has {100 * energy[0, 2]:.2f} %. The caption gives neither v nor alpha nor the "
        f"number of modes; the values of Table 1 are used here.")


PRINTED = {  # Table 1: average energy, and energy after the collision
    (2, 0): (0.1594843, 0.0513636), (3, 0): (0.0480930, 0.0234695), (0, 0): (0.0231257, 0.0089346),
    (4, 0): (0.0220028, 0.0038760), (0, 1): (0.0128242, 0.0003144), (5, 0): (0.0114396, 0.0027244),
    (1, 1): (0.0110218, 0.0002610), (1, 0): (0.0066413, 0.0002548), (6, 0): (0.0059540, 0.0021365),
    (0, 2): (0.0048560, 0.0000279)}


@figure("Table 1", "the ten most important modes")
def ranking():
    """The ten modes with the largest average energy during the contact, next to the printed ones. The
    quadrupole's average is also computed from the steps by the trapezoidal rule, as a rough check."""
    speed, steps = 0.1, []

    def record(moment, q, q_dot):
        steps.append((moment.time, moment.load, energy_of(DISK.omega[0], q[0], q_dot[0], speed)))

    out, average, after = watch(1600, 500, speed, record)
    least = 1e-3 * max(load for _, load, _ in steps)
    pairs = [(b[0] - a[0], (a[2] + b[2]) / 2) for a, b in zip(steps, steps[1:]) if min(a[1], b[1]) >= least]
    rough = sum(step * energy for step, energy in pairs) / sum(step for step, _ in pairs)
    if not abs(rough / average[0] - 1) < 0.01:
        sys.exit("paper: the quadrupole's average energy is %g, but that of its steps %g" % (average[0], rough))
    entries = sorted(zip(average, after, DISK.modes), key=lambda entry: -entry[0])
    rank = {(mode.n, mode.l): (i, a, b) for i, (a, b, mode) in enumerate(entries, 1)}
    here = [(i, *mode, *PRINTED[mode], *rank[mode]) for i, mode in enumerate(PRINTED, 1)]
    times = [row[6] / row[3] for row in here if row[1] > 0]
    times_after = [row[7] / row[4] for row in here]
    n_0 = [100 * sum(mode.n == 0 for _, _, mode in entries[:of]) / of for of in (100, 300)]
    return ["printed_rank,n,l,printed_average,printed_after,rank,average,after"] + [
        "%d,%d,%d,%.7f,%.7f,%d,%.4f,%.5f" % row for row in here
    ], (f"Agrees: the quadrupole leads, then (3, 0), and {sum(row[5] <= 10 for row in here)} of the ten modes are "
        f"among the first ten here. For n > 0 the averages are {min(times):.2f} to {max(times):.2f} times the printed "
        f"ones. Not reproduced: (0, 1) and (0, 2), which hold a third of the printed energy here. The energies after "
        f"the collision differ, too: they are {min(times_after):.2f} to {max(times_after):.2f} times the printed ones. "
        f"Their sum over the ten modes is {sum(row[7] for row in here):.4f}, and {sum(row[4] for row in here):.4f} in "
        f"print, of 1 - eps^2 = {out.one_minus_eps2:.4f} here. \"75 % of the most significant modes have n = 0\" "
        f"is not reproduced: {n_0[0]:.0f} % of the first 100 do, and {n_0[1]:.0f} % of the first 300.\n\n" +
        "\n".join("| %d, %d | %d | %.7f | %.7f | %d | %.4f | %.5f |" % (n, l, i, *rest) for i, n, l, *rest in here))


# ---- extrapolations ----


@figure("Fig. 7", "extrapolation to the hard wall")
def wall_limit():
    """1 - eps^2 against 1/alpha, with 940 modes"""
    rows, modes, ends, off = ["speed,modes,limit,slope,all_modes"], FEW[-1], [], {"line": [], "soft": [], "hard": []}
    for v in PAPER_SPEEDS:
        line, limit = wall_line(NU, modes, v), hard_wall(NU, v).one_minus_eps2
        rows.append("%g,%d,%.6f,%.5g,%.5f" % (v, modes, line.at_zero, line.slope, limit))
        ends.append(100 * (line.at_zero / limit - 1))
        for rate in WALLS + OTHER_WALLS:
            collision = find(NU, modes, rate, v)
            if collision is not None:
                on_line = line.at_zero + line.slope / key_of(NU, modes, rate, v).alpha
                error = abs(collision.one_minus_eps2 - on_line) / line.at_zero
                off["line" if rate in WALLS else "soft" if rate < WALLS[0] else "hard"].append(100 * error)
    return rows, (
        f"Agrees: 1 - eps^2 grows with alpha and is a straight line in 1/alpha for alpha v of 25 and above. The lines "
        f"are fits from 25 to 100, where no point is off by more than {max(off['line']):.2f} % of the limit. Softer "
        f"walls, down to alpha v = 10, are off by up to {max(off['soft']):.1f} %. At alpha v = 200 points are off by "
        f"up to {max(off['hard']):.1f} %: such a wall needs more than {modes} modes. The paper does not state its walls. "
        f"Dots are the limit of all modes at a rigid wall. The lines end between {min(ends):+.1f} % and "
        f"{max(ends):+.1f} % from it.")


@figure("Fig. 8", "extrapolation to all modes")
def mode_limit():
    """1 - eps^2 of the hard wall against 1/sqrt(N)"""
    head = ["speed"] + ["modes_%d" % n for n in SIZES] + ["limit_300_to_940", "slope_300_to_940", "limit_940_to_1800",
                                                          "slope_940_to_1800", "uncertainty", "all_modes"]
    rows, apart, few_off, many_off, steps, slopes = [",".join(head)], 0, 0, 0, [], {}
    for v in PAPER_SPEEDS:
        few, many, limit = size_line(NU, v, FEW), size_line(NU, v, LARGE), hard_wall(NU, v).one_minus_eps2
        lines = [wall_line(NU, n, v).at_zero for n in SIZES]
        rows.append("%g" % v + "".join(",%.6f" % at_zero for at_zero in lines) + ",%.6f,%.5g,%.6f,%.5g,%.6f,%.5f" %
                    (few.at_zero, few.slope, many.at_zero, many.slope, limit_of(NU, v).uncertainty, limit))
        few_off = max(few_off, abs(few.at_zero - limit))
        many_off = max(many_off, abs(many.at_zero - limit))
        apart = max(apart, abs(few.at_zero - many.at_zero))
        steps += [fewer < more for fewer, more in zip(lines, lines[1:]) if v >= 0.02]
        slopes[v] = few.slope / many.slope
    slowest = [wall_line(NU, n, PAPER_SPEEDS[0]).at_zero for n in (300, 600, 1800)]
    return rows, (
        f"Agrees: at v = 0.02 and above, more modes bring eps closer to one, except in {sum(steps)} of {len(steps)} "
        f"steps from one N to the next. 1 - eps^2 is about a straight line in 1/sqrt(N), and a faster collision "
        f"needs more modes to reach the line. From N = 300 to 940 the slope is {slopes[0.02]:.2f} of the slope from N "
        f"= 940 to 1800 at v = 0.02, and {slopes[0.3]:.2f} of it at 0.3. Hence the limits extrapolated from the "
        f"paper's four N and from N = 940 to 1800 differ by up to {apart:.4f}. From the computed limit of all modes "
        f"(dots) they differ by up to {few_off:.4f} and {many_off:.4f}. Does not agree at the smallest speed, v = "
        f"0.005: 1 - eps^2 is {slowest[0]:.4f} for N = 300, {slowest[1]:.4f} for 600 and {slowest[2]:.4f} for 1800. A "
        f"disk of few modes is too stiff where the contact is small.")


# ---- contact law ----


@figure("Fig. 10", "load against compression: contact law and relaxed disk")
def load():
    """The contact law (57) for each enum cor_disk_datum, and disks at rest against a wall of finite hardness alpha"""
    compressions = ([log_point(1e-3, 0.01, i, 31) for i in range(31)] +
                    [0.01 + i * 0.0025 for i in range(1, 117)])  # up to 0.3
    curves = {name: [RelaxedDisk(modes, alpha, points), RelaxedDisk(modes, alpha, points // 2)]
              for name, modes, alpha, points in (
                  ("relaxed_1300_modes_alpha_500", 1300, 500, 192), ("relaxed_all_modes_alpha_500", None, 500, 192),
                  ("relaxed_all_modes_alpha_2000", None, 2000, 320),
                  ("relaxed_all_modes_alpha_20000", None, 20000, 512))}
    coarse_error = 0

    def relaxed(delta):
        nonlocal coarse_error
        loads = [(fine.load(delta), coarse.load(delta)) for fine, coarse in curves.values()]
        coarse_error = max([coarse_error] + [abs(coarse / fine - 1) for fine, coarse in loads])
        return [fine for fine, _ in loads]

    def law(delta):
        return [cor.disk_load(delta, NU, DATUM[name]) for name in ("centre_of_mass", "diameter", "printed")]

    rows = ["compression,law_centre_of_mass,law_diameter,law_printed,law_leading_log," + ",".join(curves)]
    rows += ["%.6g" % delta + cells(*law(delta), cor.disk_load_leading_log(delta), *relaxed(delta))
             for delta in compressions]
    small, large = 0.03, 0.2
    at_small, at_large, (limit, diameter, printed) = relaxed(small), relaxed(large), law(small)
    return rows, (
        f"Agrees: the relaxed disk (alpha = 500, 1300 modes: P = {relaxed(0.05)[0]:.6f} at delta = 0.05, "
        f"{at_large[0]:.6f} at 0.2) and the contact law differ at large delta. At small delta the relaxed disk does "
        f"not follow the printed law, because x_0 in (41) is the centre of mass. As the wall hardens, P tends to the "
        f"law with this datum. At delta = {small} the ratio of P to this law is {at_small[0] / limit:.4f} for alpha = "
        f"500 (1300 modes), {at_small[2] / limit:.4f} for 2000 and {at_small[3] / limit:.4f} for 20000 (all modes). A "
        f"soft wall pushes before it is touched. At this delta the printed law, (57), is "
        f"{100 * (1 - printed / limit):.1f} % below the law with the centre of mass, and the law of the diameter "
        f"{100 * (1 - diameter / limit):.1f} %. At delta = {large} the load at the hardest wall is "
        f"{at_large[3] / law(large)[0]:.3f} of the law, which assumes a small contact. With half the number of "
        f"points no load changes by more than a relative {coarse_error:.0e}.")


@figure("Fig. 10", "load against compression in a collision")
def load_dynamic():
    modes, alpha, rows, said, way_out = 1300, 500, ["speed,time,compression,load"], [], []
    relaxed = RelaxedDisk(modes, alpha, 192)
    for speed in 0.1, 0.04:
        trace = []
        out = watch(modes, alpha, speed, lambda m, q, q_dot: trace.append((m.time, m.position + 1, m.load)))[0]
        least = 1e-3 * max(row[2] for row in trace)
        touching = [i for i, row in enumerate(trace) if row[2] >= least]
        stride = 1 + (touching[-1] - touching[0]) // 400
        rows += ["%g,%.4f,%.5f,%.5f" % (speed, *row) for row in trace[touching[0]:touching[-1] + 1:stride]]
        rows += ["", ""] if speed == 0.1 else []
        # loads during compression and during release, at half the largest compression
        half = out.max_compression / 2
        way_in, out_again = [a[2] + (b[2] - a[2]) * (a[1] - half) / (a[1] - b[1]) for a, b in zip(trace, trace[1:])
                             if (a[1] < half) != (b[1] < half)][:2]
        said.append("%.4f against %.4f%%s at v = %g (delta = %.4f), a ratio of %.2f" %
                    (way_in, relaxed.load(half), speed, half, way_in / relaxed.load(half)))
        way_out.append("%.4f" % out_again)
    return rows, (
        f"In a collision (below; alpha = {alpha}, {modes} modes) the loads are higher, as in the paper, and closer to "
        f"the relaxed disk at the smaller speed. At half the largest delta, on the way in, the load is "
        f"{said[0] % ' of the relaxed disk'}. It is {said[1] % ''}. On the way out it is {' and '.join(way_out)}. At "
        f"larger delta the load at v = 0.1 falls below the load of the relaxed disk and oscillates with fast modes.")


@figure("Fig. 11", "contact time and largest compression against speed")
def contact():
    """From the contact law; contact.gp adds the values of collisions.csv."""

    def tau(v, datum="printed"):
        return cor.disk_contact_time(v, NU, DATUM[datum])

    def delta(v, datum="printed"):
        return cor.disk_max_compression(v, NU, DATUM[datum])

    def ratio(v):
        return tau(v) * v / (math.pi * delta(v))

    data = ("centre_of_mass", "diameter", "printed")
    rows = ["speed," + ",".join(quantity + name for quantity in ("contact_time_", "max_compression_")
                                for name in data + ("leading_log", ))]
    ends = {name: cor.disk_speed_limit(NU, DATUM[name]) for name in data}
    for v in [log_point(1e-6, ends["diameter"], i, 121) for i in range(120)] + [ends["diameter"]]:
        rows.append("%.6g" % v + cells(*(tau(v, name) for name in data), cor.disk_contact_time_leading_log(v),
                                       *(delta(v, name) for name in data), cor.disk_max_compression_leading_log(v)))
    tau_off = [100 * (cor.disk_contact_time_leading_log(v) / tau(v) - 1) for v in (1e-4, 0.1)]
    delta_off = [100 * (cor.disk_max_compression_leading_log(v) / delta(v) - 1) for v in (1e-4, 0.1)]
    centre, dynamic = "centre_of_mass", {v: find(NU, SIZES[-1], WALLS[-1], v) for v in (0.01, 0.1, 0.3)}
    return rows, (
        f"Agrees: the contact time grows like the root of a logarithm as v falls. tau v/(pi delta_max) tends to 1 "
        f"slowly ({ratio(1e-2):.4f} at v = 1e-2, {ratio(1e-4):.4f} at 1e-4, {ratio(1e-8):.4f} at 1e-8). (61) is good, "
        f"because the terms that it leaves out, b and half the logarithm of its logarithm, nearly cancel at the speeds "
        f"drawn. Compared with the printed law, tau of (61) is off by {tau_off[0]:+.1f} % at v = 0.0001 and by "
        f"{tau_off[1]:+.1f} % at 0.1, its delta_max by {delta_off[0]:+.1f} % and {delta_off[1]:+.1f} %. With the "
        f"centre of mass as datum tau(0.0001) = {tau(1e-4, centre):.4f} instead of the printed law's {tau(1e-4):.4f}; "
        f"with the diameter it is {tau(1e-4, 'diameter'):.4f}. The law ends at v = {ends[centre]:.4f} "
        f"(centre of mass), {ends['printed']:.4f} (printed) and {ends['diameter']:.4f} (diameter). The full dynamics "
        f"has {SIZES[-1]} modes and alpha = {WALLS[-1]}/v. Its contact lasts while the load is above a thousandth of "
        f"the largest load. The full dynamics agrees with the law "
        f"for the centre of mass: tau(0.01) = {dynamic[0.01].contact_time:.2f}, law {tau(0.01, centre):.2f}, and "
        f"delta_max {100 * (1 - dynamic[0.01].max_compression / delta(0.01, centre)):.1f} % below the law's. It "
        f"departs from the law near the end of the law: tau(0.1) = {dynamic[0.1].contact_time:.2f}, law "
        f"{tau(0.1, centre):.2f}, and tau(0.3) = {dynamic[0.3].contact_time:.2f}. The black line is all "
        f"modes at a rigid wall: tau(0.01) = {hard_wall(NU, 0.01).contact_time:.4f}, tau(0.1) = "
        f"{hard_wall(NU, 0.1).contact_time:.4f}, delta_max(0.1) = {hard_wall(NU, 0.1).max_compression:.5f}.")


# ---- energy in the modes ----


@figure("Fig. 12", "energy left in the modes against speed")
def rayleigh():
    """The fraction of the impact's energy that Rayleigh's argument leaves in the modes"""
    series = [(nu, name) for nu in MATERIALS for name in ("centre_of_mass", "diameter", "printed")]
    speeds, ends = [log_point(1e-6, 0.1, i, 121) for i in range(121)], constant("COR_DISK_RAYLEIGH_MAX_SPEED")
    whole, quadrupole, rows = {key: [] for key in series}, {key: [] for key in series}, []
    largest_tail = 0
    for v in speeds:
        row = "%.6g" % v
        for key in series:
            result = MATERIALS[key[0]].rayleigh(DATUM[key[1]], v)
            fraction, tail, of_quadrupole = (result[0].fraction, result[0].tail, result[1][0]) if result else [nan] * 3
            row += cells(fraction, fraction + tail, of_quadrupole)
            whole[key].append(fraction + tail)
            quadrupole[key].append(of_quadrupole)
            largest_tail = max([largest_tail] + known([(fraction + tail) / fraction - 1]))
        rows.append(row)
    beyond = max(known(w for values in whole.values() for v, w in zip(speeds, values) if v > ends))

    def maximum(key):
        """Returns the index of the highest maximum inside the range of the theory."""
        values = whole[key]
        return max((i for i in range(1, len(speeds) - 1)
                    if speeds[i + 1] <= ends and values[i - 1] < values[i] >= values[i + 1]), key=lambda i: values[i])

    maxima = {nu: ", ".join("%.4f at v = %.1e" % (whole[key][maximum(key)], speeds[maximum(key)])
                            for key in series if key[0] == nu) for nu in MATERIALS}
    top = maximum(series[0])
    # at v = 0.01 and 0.1
    theory = {nu: (whole[nu, "centre_of_mass"][96], whole[nu, "centre_of_mass"][-1]) for nu in MATERIALS}
    wall = {nu: [hard_wall(nu, v).one_minus_eps2 for v in (0.01, 0.1)] for nu in MATERIALS}
    head = ["nu_%.2f_%s_%s" % (*key, what) for key in series for what in ("1800_modes", "all_modes", "quadrupole")]
    return [",".join(["speed"] + head)] + rows, (
        f"Agrees: the size, and the quadrupole as the mode with the largest energy, "
        f"{100 * quadrupole[series[0]][top] / whole[series[0]][top]:.0f} % at the maximum, though not in the dips. "
        f"Does not agree: the place of the maximum, near v = 1e-2 in print. The quadrupole's energy follows "
        f"cos^2(omega tau/2), so the fraction oscillates as tau grows with -ln v. For the centre of mass, the diameter "
        f"and the printed datum the largest values at nu = 0.33 are {maxima[NU]}. At nu = 0.9 they are {maxima[0.9]}. "
        f"The constant b only shifts the curve along ln v. After the maximum come a dip and then a rise, not a fall. "
        f"Beyond v = {ends}, shaded, perturbation theory fails: it gives up to {beyond:.2f} times the energy of "
        f"the impact. The modes above the lowest 1800 add at most {largest_tail:.2g} of the fraction, too little to be "
        f"seen. The full dynamics, all modes at a rigid wall, agrees in size with the print, but its dip is shallow "
        f"and its rise less steep. At nu = 0.33 it gives {wall[NU][0]:.4f} at v = 0.01 and {wall[NU][1]:.4f} at 0.1; "
        f"Rayleigh, with the centre of mass, has {theory[NU][0]:.4f} and {theory[NU][1]:.2f}. At nu = 0.9 it gives "
        f"{wall[0.9][0]:.4f} and {wall[0.9][1]:.4f}; Rayleigh has {theory[0.9][0]:.4f} and {theory[0.9][1]:.2f}.")


def of_all_modes(speed):
    """Returns Rayleigh's energy of all modes, with the datum centre of mass."""
    out = DISK.rayleigh(CENTRE_OF_MASS, speed)[0]
    return out.fraction + out.tail


@figure("Beyond the paper", "1 - eps^2 at small speed")
def oscillation():
    """Not in the paper: energy left in the modes at small speed, from the full dynamics, against Rayleigh's curve"""
    limits = [limit_of(NU, v) for v in SLOW_SPEEDS]
    uncertain = [limit.uncertainty / limit.one_minus_eps2 for limit in limits]
    # at this speed and above, every limit has an uncertainty of at most 6 %
    first = max(i + 1 for i in range(len(limits)) if not uncertain[i] <= 0.06)
    dynamic = [wall_line(NU, SIZES[-1], v).at_zero for v in SLOW_SPEEDS]
    theory = [of_all_modes(v) for v in SLOW_SPEEDS]
    rows = ["speed,one_minus_eps2,low,high,modes_940,modes_1300,modes_1800,rayleigh"]
    for i, (v, (loss, uncertainty)) in enumerate(zip(SLOW_SPEEDS, limits)):
        loss = nan if i < first else loss
        rows.append("%g" % v + cells(loss, loss - uncertainty, loss + uncertainty,
                                     *(wall_line(NU, n, v).at_zero for n in LARGE), theory[i]))

    def fall(values):
        """Returns the highest inner maximum and its speed. Also returns the fall to the lowest inner minimum, in
        percent of the maximum, and the speed of this minimum."""
        inside = range(1, len(values) - 1)
        top = max((i for i in inside if values[i - 1] <= values[i] > values[i + 1]), key=lambda i: values[i])
        bottom = min((i for i in inside if values[i - 1] >= values[i] < values[i + 1]), key=lambda i: values[i])
        return values[top], SLOW_SPEEDS[top], 100 * (1 - values[bottom] / values[top]), SLOW_SPEEDS[bottom]

    return rows, (
        "In the full dynamics, too, 1 - eps^2 does not fall steadily with v. At nu = 0.33, with %d modes and a hard "
        "wall, it falls from a maximum of %.4f at v = %.2g by %.0f %% to a minimum at v = %.2g. Then it rises again. "
        "Rayleigh's curve, with the centre of mass, falls from %.4f at v = %.2g by %.0f %% to v = %.2g. Its "
        "maximum is nearly as high, but at half the speed, and its minimum is much deeper. Extrapolations are drawn at "
        "v = %.2g and above, where their uncertainty is at most %.0f %%. At smaller speeds the contact is too narrow for "
        "1800 modes, and the points of N = 940, 1300 and 1800 do not yet form a line. The black line is the computed "
        "limit, all modes at a rigid wall: %.5f at v = 0.0023, %.5f at 0.015." %
        (SIZES[-1], *fall(dynamic), *fall(theory), SLOW_SPEEDS[first], 100 * max(uncertain[first:]),
         hard_wall(NU, 0.0023).one_minus_eps2, hard_wall(NU, 0.015).one_minus_eps2))


@figure("Beyond the paper", "the limit of the paper's figures")
def rigid_wall():
    """Writes the limit that other figures draw, and the distance of the extrapolations from it."""
    rows = ["nu,speed,one_minus_eps2,uncertainty,eps,contact_time,max_compression"]
    for nu in MATERIALS:
        for v in [log_point(1e-6, 0.3, i, 56) for i in range(55)] + [0.3]:
            wall = hard_wall(nu, v, RIGID_LINE_TOLERANCE)
            rows.append("%g,%.6g,%.5f,%.5f,%.5f,%.4f,%.5g" % (nu, v, wall.one_minus_eps2, wall.error_estimate, wall.eps,
                                                              wall.contact_time, wall.max_compression))
        rows += ["", ""] if nu == NU else []

    def miss(nu, speeds, limit=limit_of):
        """Returns the largest distance of the extrapolations from the limit, its speed, and its percentage of the
        limit. Also returns how many distances exceed the sum of both uncertainties, and the number of
        distances."""
        walls = [hard_wall(nu, v) for v in speeds]
        limits = [limit(nu, v) for v in speeds]
        off = [one.one_minus_eps2 - wall.one_minus_eps2 for one, wall in zip(limits, walls)]
        beyond = sum(abs(x) > one.uncertainty + wall.error_estimate for x, one, wall in zip(off, limits, walls))
        worst = max(range(len(off)), key=lambda i: abs(off[i]))
        return off[worst], speeds[worst], 100 * off[worst] / walls[worst].one_minus_eps2, beyond, len(off)

    few = miss(NU, PAPER_SPEEDS, lambda nu, v: limit_of(nu, v)._replace(one_minus_eps2=size_line(nu, v, FEW).at_zero))
    estimate = max(hard_wall(nu, v).error_estimate for nu in MATERIALS for v in PAPER_SPEEDS)
    return rows, (
        "cor_disk_hard_wall computes the limit, all modes at a rigid wall, to %.0e in 1 - eps^2 at the paper's "
        "speeds. At nu = 0.33 the extrapolation from the paper's N = 300 to 940 is off by up to %+.1e, at v = %g "
        "(%+.1f %%). The extrapolation from N = 940 to 1800 is off by up to %+.1e, at v = %g (%+.1f %%), and by more "
        "than both uncertainties together at %d of %d points. At nu = 0.9 this extrapolation is off by up to %+.1e, "
        "at v = %g (%+.1f %%), and by more than both uncertainties at %d of %d. At the small speeds of the "
        "oscillation it is off by up to %+.1e, at v = %.2g (%+.0f %%)." %
        (estimate, *few[:3], *miss(NU, PAPER_SPEEDS), *miss(0.9, PAPER_SPEEDS), *miss(NU, SLOW_SPEEDS)[:3]))


@figure("Beyond the paper", "how Rayleigh's theory is approached")
def approach():
    """Not in the paper. The speeds extend down to v = 1e-300. The phases of the modes vary like sqrt(ln(1/v))."""
    rows, last, points = ["power,one_minus_eps2,rayleigh,ratio"], 300.0, 64
    ends = [10, 30, 100, last]  # ranges of -log10(v) for which the text states the differences
    difference, whole = [0.0] * len(ends), [0.0] * len(ends)
    for i in range(points):
        root = sqrt(3) + (sqrt(last) - sqrt(3)) * i / (points - 1)
        power = root * root if i < points - 1 else last
        loss, theory = hard_wall(NU, 10**-power).one_minus_eps2, of_all_modes(10**-power)
        rows.append("%.4f,%.4g,%.4g,%.3f" % (power, loss, theory, loss / theory))
        k = next(k for k, end in enumerate(ends) if power <= end)
        # loss and theory decrease like 1/power^2, apart from their oscillation
        difference[k] += (power * power * (loss - theory))**2
        whole[k] += (power * power * theory)**2
    part = [100 * sqrt(a / b) for a, b in zip(difference, whole)]
    return rows, (
        f"In Rayleigh's theory vibrations do not act back on the load. Collisions approach it slowly, about like "
        f"1/sqrt(ln(1/v)). Its energy and the energy of all modes at a rigid wall (nu = 0.33, centre of mass) differ "
        f"by {part[0]:.0f} %, root mean square, from v = 1e-3 to 1e-10. Down to 1e-30 they differ by {part[1]:.0f} %, "
        f"down to 1e-100 by {part[2]:.0f} %, and down to 1e-300 by {part[3]:.0f} %.")


def main(check, every):
    folder = ROOT / "docs" / "paper"
    good = read_table(None if every else 60) if check else make_table()
    made = [(paper, name, subject, *function()) for paper, name, subject, function in FIGURES]
    for _, name, _, rows, _ in made:
        path, text = folder / (name + ".csv"), "\n".join(rows) + "\n"
        if not check:
            path.write_text(text, encoding="ascii")
        elif path.read_text(encoding="ascii") != text:
            print("paper/run would write another %s" % path.relative_to(ROOT), file=sys.stderr)
            good = False
    if not check:
        print("%-16s %-13s %s" % ("paper", "file", "shows"))
        for paper, name, subject, _, _ in made:
            print("%-16s %-13s %s" % (paper, name, subject))
        for paper, _, _, _, said in made:
            print("\n" + "\n".join(textwrap.fill(line, 120) for line in (paper + ": " + said).split("\n")))
        return 0
    page = " ".join((ROOT / "docs" / "paper-figures.md").read_text(encoding="utf-8").split())
    for line in [line for _, _, _, _, said in made for line in said.split("\n") if line not in page]:
        print("docs/paper-figures.md does not say: " + line, file=sys.stderr)
        good = False
    return 0 if good else 1


sys.exit(main("--check" in sys.argv, "--all" in sys.argv))
