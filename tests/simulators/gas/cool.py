#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A gas of viscoelastic spheres cools in LAMMPS with the line of corgen contact --for lammps. Its temperature is
compared with kinetic theory for cor's eps(g) (theory.c).

    tests/simulators/gas/cool.py             500 spheres, for the tests; CORGEN and LMP name the programs
    tests/simulators/gas/cool.py --lattice 50x50x40:20 [--ranks 2] [--results FOLDER] [--write]
                                             100,000 spheres and, for the statistical error, eight gases of 2000.
                                             FOLDER stores each gas; a stored gas is not simulated again
--lattice LATTICE[:STAGES[:STEPS]]: the shortest contact has STEPS time steps, with the damping of the lines. By
default it has 12 steps, and the damping is corrected for them.
--write renews docs/gas/ and the numbers of docs/at-scale.md from the results.
"""
import argparse
import collections
import itertools
import math
import os
import re
import shutil
import statistics
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
sys.dont_write_bytecode = True
from common import CORGEN, LMP, ROOT, first_row, numbers_of, renew, run, skip, summary, verdict  # noqa: E402

PAGE = os.path.join(ROOT, "docs", "at-scale.md")
PICTURES = os.path.join(ROOT, "docs", "gas")

# Spheres of silicone rubber, 10 mm; eps = 0.85 at 0.1 m/s if contact ends at zero overlap
YOUNG, POISSON, RADIUS, DENSITY = "1e6", "0.49", "5e-3", "1100"
SPHERES = ["--young", YOUNG, "--poisson", POISSON, "--radius", RADIUS, "--density", DENSITY, "--end", "zero-overlap"]
RESTITUTION = ["--restitution", "0.85", "--at", "0.1"]
FRACTION = "0.03"  # of volume
SPEED = 0.1  # initial sqrt(T/m)
COARSE = 12  # time steps in the shortest contact, at 4 sqrt(2 T/m)
STAGES = 20  # in each stage, 1 + t/t_1 grows by the factor 1.1; t_1 is `unit` of in.gas
SHORT_STAGES = 12

# The gases whose scatter gives the statistical error, and the scatter of their ln T, multiplied by sqrt(N)
SCATTER_LATTICE, SCATTER_SEEDS = "20x10x10", range(101, 109)
SCATTER = 0.45
ALLOWED = 4.5  # standard errors
ENDS_APART = 100000  # spheres that suffice to distinguish the two ends of contact
# Allowed change of 1 - eps^2 by the time step. With corrected damping the scatter of eps adds 2e-5 of the loss.
STEP_ALLOWED, UNCORRECTED_ALLOWED = 2e-4, 4e-3

State = collections.namedtuple("State", "time steps temperature kurtosis shear density")
Cost = collections.namedtuple("Cost", "ranks processor_ns")
Theory = collections.namedtuple("Theory", "time temperature a2 collisions slope contact")

def output_of(command, **options):
    done = run(command, **options)
    if done.returncode:
        sys.exit("cool.py: %s\n%s" % (" ".join(command), (done.stdout + done.stderr)[-2000:]))
    return done.stdout


def count_of(lattice):
    return math.prod(int(n) for n in lattice.split("x"))


# ---- corgen ----


def contact(*options):
    return output_of([CORGEN, "contact"] + SPHERES + list(options))


def dissipation_time(*restitution):
    return "%.17g" % numbers_of(*SPHERES, *restitution)["dissipation_time"]


def contact_at(time, speed, *options):
    """Returns {column: value} at an impact speed, m/s."""
    return first_row("contact", *SPHERES, "--dissipation-time", time, "--speed", speed, *options)


def lammps_lines(time):
    """Returns corgen's lines, in which the lines for contacts that end at zero overlap are active."""
    return contact("--dissipation-time", time, "--for", "lammps")


def impact_of(temperature):
    """Returns the impact speed at which collisions of the gas lose most energy."""
    return "%.6g" % (2.5 * math.sqrt(temperature))


# ---- LAMMPS ----


class Gas:
    """A folder with the input of LAMMPS and its results"""

    def __init__(self, folder):
        self.folder = folder
        self.time = dissipation_time(*RESTITUTION)
        pair = re.search(r"^pair_coeff \* \* hertz \S+ (\S+) ", lammps_lines(self.time), re.M)
        self.damping = pair[1]
        for name, time in ("pair", self.time), ("elastic", "0"):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as out:
                out.write(lammps_lines(time).replace(" %s " % self.damping, " ${eta} "))
        self.duration = contact_at(self.time, "1")["duration_s_zero_overlap"]

    def lammps(self, script, ranks, **variables):
        """Returns the text that LAMMPS prints."""
        variables = dict(pair="pair", duration=self.duration, radius=RADIUS, density=DENSITY, **variables)
        command = [LMP, "-log", "none", "-in", os.path.join(HERE, script)]
        for name, value in variables.items():
            command += ["-var", name, str(value)]
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), "--bind-to", "none"] + command
        # Open MPI needs the first two settings for root; with the third a waiting rank yields to other programs
        mpi = dict.fromkeys(
            ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_mpi_yield_when_idle"), "1")
        return output_of(command, cwd=self.folder, env=dict(os.environ, **mpi))

    def step(self, temperature, steps):
        """Returns the time step at this T/m."""
        return float(self.duration) * (4 * math.sqrt(2 * temperature))**-0.2 / steps

    def factor(self, temperature, steps):
        """Returns the factor of the damping for this time step."""
        if steps != COARSE:
            return 1
        row = contact_at(self.time, impact_of(temperature), "--time-step", "%.12g" % self.step(temperature, steps),
                         "--step-corrected")
        return float(row["damping_correction"])

    def gas(self, lattice, ranks, steps, **variables):
        """Runs the gas. Its script varies the damping with T, because 1 minus the factor is nearly a power of T."""
        first, last = SPEED**2, SPEED**2 / 25
        correction = 1 - self.factor(first, steps)
        power = math.log(correction / (1 - self.factor(last, steps))) / math.log(first / last) if correction else 0
        variables.update(zip(("nx", "ny", "nz"), lattice.split("x")))
        return self.lammps("in.gas", ranks, elastic="elastic", fraction=FRACTION, speed=SPEED, per_contact=steps,
                           damping=self.damping, correction=correction, power=power, **variables)

    def pairs(self, impact, step, eta, centre=0):
        """Returns means of 1 - eps^2, eps and (eps - centre)^2 over places of first touch."""
        text = self.lammps("in.pairs", 1, impact=impact, dt=step, eta=eta, centre=centre)
        return [float(x) for x in re.search(r"^loss \S+ (\S+) (\S+) (\S+)$", text, re.M).groups()]

    def step_error(self, state, steps):
        """Returns the relative error of 1 - eps^2 of contacts with the gas's time step and damping in this state."""
        impact = impact_of(state.temperature)
        loss = self.pairs(impact, self.step(state.temperature, steps),
                          float(self.damping) * self.factor(state.temperature, steps))[0]
        eps = float(contact_at(self.time, impact)["eps_zero_overlap"])
        return loss / (1 - eps * eps) - 1

    def cooled(self, lattice, seed, stages, ranks, steps=COARSE):
        """Returns the states of a gas at the ends of the stages."""
        name = os.path.join(self.folder, "gas.%s.%d.%d" % (lattice, seed, steps))
        if not os.path.exists(name):
            part = name + ".part"
            if os.path.exists(part):
                os.remove(part)
            text = self.gas(lattice, ranks, steps, seed=seed, stages=stages, out=os.path.basename(part))
            if set(re.findall(r"Dangerous builds = (\d+)", text)) != {"0"}:
                sys.exit("cool.py: LAMMPS may have missed contacts: dangerous builds")
            with open(name + ".log", "w", encoding="utf-8") as out:
                out.write(text)
            os.rename(part, name)
        with open(name, encoding="utf-8") as rows:
            states = [State(*map(float, row.split()[1:])) for row in rows]
        if len(states) < stages + 1:
            sys.exit("cool.py: %s has %d stages, not %d; remove it" % (name, len(states) - 1, stages))
        return states[:stages + 1]


def cost_of(text):
    """Returns the ranks in an output of LAMMPS, and the processor time of all steps in nanoseconds per sphere and
    step."""
    loop = r"Loop time of (\S+) on (\d+) procs for (\d+) steps with (\d+) atoms\s+([\d.]+)% CPU use"
    loops = [[float(x) for x in row] for row in re.findall(loop, text) if int(row[2]) > 0]
    _, ranks, _, spheres, _ = loops[0]
    processor_s = ranks * sum(seconds * share / 100 for seconds, _, _, _, share in loops)
    return Cost(ranks, 1e9 * processor_s / (spheres * sum(row[2] for row in loops)))


# ---- theory ----


class Predictor:
    """theory.c, compiled"""

    def __init__(self, work, time):
        self.program, self.time = os.path.join(work, "theory"), time
        library = os.path.join(os.path.dirname(CORGEN), "libcor.a")
        output_of(["cc", "-O2", "-I", os.path.join(ROOT, "include"), "-o", self.program,
                   os.path.join(HERE, "theory.c"), library, "-lgsl", "-lgslcblas", "-lm"])

    def __call__(self, states, model="zero_overlap", factor=1.0, loss=1.0):
        """Returns theory at the times of the states, starting at the first temperature. `factor` multiplies A, and
        `loss` multiplies 1 - eps^2."""
        command = [self.program, model, "%.17g" % loss, YOUNG, POISSON, RADIUS, DENSITY,
                   "%.17g" % (float(self.time) * factor), FRACTION, "%.17g" % states[0].temperature]
        text = output_of(command, input="\n".join("%.17g" % state.time for state in states))
        return [Theory(*map(float, row.split())) for row in text.splitlines()]


def deviations(states, theory):
    """Returns ln(T/theory) at the ends of the stages."""
    return [math.log(s.temperature / t.temperature) for s, t in zip(states, theory)][1:]


def largest(values):
    return max(abs(value) for value in values)


def root_mean_square(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


def slope(states, unit, temperatures):
    """Returns d ln T/d ln(t + unit) over the last half of the stages, by least squares."""
    half = len(states) // 2
    return statistics.linear_regression([math.log(s.time + unit) for s in states[half:]],
                                        [math.log(value) for value in temperatures[half:]]).slope


# ---- verdicts ----


def judge(spheres, states, predictor, scatter):
    """scatter: standard deviation of ln T times sqrt(spheres)"""
    error = scatter / math.sqrt(spheres)
    d = deviations(states, predictor(states))
    fall = states[0].temperature / states[-1].temperature
    verdict(largest(d) <= ALLOWED * error,
            "%d spheres, T falls by %.1f: ln(T/theory) at most %.2f %%, %.1f standard errors of %.2f %%; at the end "
            "%.2f %%" % (spheres, fall, 100 * largest(d), largest(d) / error, 100 * error, 100 * d[-1]))
    for factor in 0.77, 1.3:
        wrong = largest(deviations(states, predictor(states, factor=factor)))
        verdict(wrong > 2 * ALLOWED * error, "theory with A wrong by %+.0f %% is seen: %.1f %%, %.0f standard errors" %
                (100 * (factor - 1), 100 * wrong, wrong / error))
    return error


def judge_limit(predictor, states):
    late = predictor([states[0], states[0]._replace(time=1e14)])[-1]
    verdict(abs(late.slope + 5 / 3) < 1e-3, "theory: d ln T/d ln t tends to -5/3, %.5f after 1e14 s" % late.slope)


def judge_steps(gas):
    """For one time step, compares corgen's bias, scatter and correction of eps with 40 pairs in LAMMPS."""
    time, impact = dissipation_time("--restitution", "0.5", "--at", "0.1"), "0.1"
    step = "%.12g" % (gas.step(SPEED**2 / 16, COARSE))
    row = contact_at(time, impact, "--time-step", step, "--step-corrected")
    eta = float(gas.damping) * float(time) / float(gas.time)
    _, mean, square = gas.pairs(impact, step, eta, centre=0.5)
    bias, scatter = mean - 0.5, math.sqrt(square - (mean - 0.5)**2)
    stated = float(row["step_bias"]), float(row["step_scatter"])
    verdict(abs(bias - stated[0]) < 0.1 * stated[1] and abs(scatter / stated[1] - 1) < 0.1 and abs(bias) > 4e-3,
            "e = 0.5, %.2f us a step: eps off by %+.5f, scatter %.5f; corgen says %+.5f, %.5f" %
            (1e6 * float(step), bias, scatter, *stated))
    mean = gas.pairs(impact, step, eta * float(row["damping_correction"]))[1]
    verdict(abs(mean - 0.5) < 0.1 * stated[1], "with the corrected damping: %+.5f" % (mean - 0.5))


def small_gas(work):
    gas = Gas(work)
    states = gas.cooled("10x10x5", 1, SHORT_STAGES, 1)
    predictor = Predictor(work, gas.time)
    judge(500, states, predictor, SCATTER)
    judge_limit(predictor, states)
    judge_steps(gas)


Result = collections.namedtuple(
    "Result", "lattice steps spheres states theory zero_force rigid error slopes slope_error gases step_errors stepped")


def scatter_of(rows):
    """Returns the root mean square over the columns of the standard deviation within each."""
    return root_mean_square([statistics.stdev(column) for column in zip(*rows)])


def slope_difference(states, predictor):
    """Returns (slope of the gas, slope of the theory)."""
    step = 1e-4
    first, second = predictor([states[0], states[0]._replace(time=step)])
    unit = step / math.log(first.temperature / second.temperature)  # T/|dT/dt| at time 0
    return [slope(states, unit, [row.temperature for row in rows]) for rows in (states, predictor(states))]


def large_gas(folder, work, lattice, stages, steps, ranks):
    gas = Gas(folder)
    predictor = Predictor(work, gas.time)
    spheres, small = count_of(lattice), count_of(SCATTER_LATTICE)
    gases = [gas.cooled(SCATTER_LATTICE, seed, STAGES, 1) for seed in SCATTER_SEEDS]
    states = gas.cooled(lattice, 1, stages, ranks, steps)
    scatter = math.sqrt(small) * scatter_of([deviations(g, predictor(g)) for g in gases])
    mean = root_mean_square([sum(row) / len(row) for row in zip(*[deviations(g, predictor(g)) for g in gases])])
    print("      %d gases of %d spheres: the scatter of ln T is %.3f/sqrt(N), their mean deviates by %.2f %%" %
          (len(gases), small, scatter, 100 * mean))
    error = judge(spheres, states, predictor, scatter)
    judge_limit(predictor, states)
    step_errors = [gas.step_error(state, steps) for state in (states[0], states[-1])]
    verdict(largest(step_errors) < (STEP_ALLOWED if steps == COARSE else UNCORRECTED_ALLOWED),
            "the time step changes 1 - eps^2 of contacts by %+.2f %% at first, %+.2f %% at last" %
            tuple(100 * x for x in step_errors))
    wrong = {model: predictor(states, model) for model in ("zero_force", "rigid")}
    stepped = predictor(states, loss=1 + sum(step_errors) / 2)
    off = largest(deviations(states, stepped))
    print("      theory with this loss: ln(T/theory) at most %.2f %%, %.1f standard errors" % (100 * off, off / error))
    other = largest(deviations(states, wrong["zero_force"]))
    text = "theory with the other end of contact: %.2f %%, %.1f standard errors" % (100 * other, other / error)
    if spheres >= ENDS_APART:
        verdict(other > ALLOWED * error, text)
    else:
        print("      " + text)
    slopes = slope_difference(states, predictor)
    off = [gas_slope - theory_slope for gas_slope, theory_slope in (slope_difference(g, predictor) for g in gases)]
    slope_error = scatter_of([[x] for x in off]) * math.sqrt(small / spheres)
    verdict(abs(slopes[0] - slopes[1]) <= ALLOWED * slope_error,
            "d ln T/d ln(t + t_0) of the last half: %.4f, theory %.4f, standard error %.4f" % (*slopes, slope_error))
    return Result(lattice, steps, spheres, states, predictor(states), wrong["zero_force"], wrong["rigid"], error,
                  slopes, slope_error, len(gases), step_errors, stepped)


def processor_min(result, log, stage):
    return log.processor_ns * result.spheres * result.states[stage].steps / 6e10


# ---- docs/ ----


def write_csv(result):
    os.makedirs(PICTURES, exist_ok=True)
    name = "cooling_%d%s.csv" % (result.spheres, "" if result.steps == COARSE else "_%d" % result.steps)
    with open(os.path.join(PICTURES, name), "w", encoding="utf-8") as out:
        out.write("time_s,t_over_m_m2_s2,theory,theory_zero_force,theory_rigid,standard_error,a2,theory_a2,"
                  "theory_slope,collisions,contacts,shear,density\n")
        for s, t, force, rigid in zip(result.states, result.theory, result.zero_force, result.rigid):
            out.write("%.6g,%.6g,%.6g,%.6g,%.6g,%.3g,%.3g,%.3g,%.4f,%.4g,%.3g,%.3g,%.3g\n" %
                      (s.time, s.temperature, t.temperature, force.temperature, rigid.temperature, result.error,
                       0.6 * s.kurtosis - 1, t.a2, t.slope, t.collisions, t.contact, s.shear, s.density))


def column(result, log):
    """Returns {row of the table: its text for a gas}."""
    s, error = result.states, result.error
    d = deviations(s, result.theory)
    rows = {
        "T falls by the factor": "%.1f" % (s[0].temperature / s[-1].temperature),
        "collisions of a sphere": "%.0f" % result.theory[-1].collisions,
        "standard error of ln T": "%.2f %%" % (100 * error),
        "largest ln(T/theory)": "%.2f %%, %.1f standard errors" % (100 * largest(d), largest(d) / error),
        "root mean square of ln(T/theory); last value": "%.2f %%; %+.2f %%" % (100 * root_mean_square(d), 100 * d[-1]),
        "slope d ln T/d ln(t + t_0), last half of the points": "%.4f ± %.4f" % (
            result.slopes[0], result.slope_error),
        "slope of the theory, last half; last point": "%.4f; %.4f" % (result.slopes[1], result.theory[-1].slope),
        "a_2, last half; theory": "%.4f; %.4f" % tuple(
            sum(values[len(values) // 2:]) / (len(values) - len(values) // 2)
            for values in ([0.6 * state.kurtosis - 1 for state in s], [t.a2 for t in result.theory])),
        "change of 1 - eps^2 by the time step, at first; at last": "%+.2f %%; %+.2f %%" % tuple(
            100 * x for x in result.step_errors),
    }
    others = {"this change in the theory": result.stepped, "zero force instead of zero overlap": result.zero_force,
              "no overlaps in the theory": result.rigid}
    for name, theory in others.items():
        wrong = largest(deviations(s, theory))
        rows["largest ln(T/theory) with " + name] = "%.2f %%, %.1f standard errors" % (
            100 * wrong, wrong / error)
    rows.update({
        "energy of the longest shear waves, part of all energy": "%.2f %%" % (100 * s[-1].shear * 4 / result.spheres),
        "time steps; minutes of a processor": "%d; %.1f" % (s[-1].steps, processor_min(result, log, -1)),
    })
    return rows


def numbers(results, logs):
    """Returns the table of docs/at-scale.md."""
    columns = [column(result, log) for result, log in zip(results, logs)]
    table = "| spheres | %s |\n|---|%s\n" % (" | ".join("%d" % r.spheres for r in results), "---|" * len(results))
    columns = [{"time steps in the shortest contact": "%d, %s" % (r.steps, "corrected" if r.steps == COARSE else
                                                                  "not corrected"), **c}
               for r, c in zip(results, columns)]
    for name in columns[0]:
        table += "| %s | %s |\n" % (name, " | ".join(c[name] for c in columns))
    return table


def comparisons(results, logs):
    """Returns a sentence for each lattice that has gases with two time steps. The sentence compares these gases at
    the ends of their common stages."""
    text = ""
    for (fine, fine_log), (coarse, log) in itertools.permutations(zip(results, logs), 2):
        if coarse.lattice != fine.lattice or coarse.steps >= fine.steps:
            continue
        differences = [a - b for a, b in zip(deviations(coarse.states, coarse.theory),
                                             deviations(fine.states, fine.theory))]
        error, stages = math.sqrt(2) * coarse.error, len(differences)
        minutes = processor_min(coarse, log, stages), processor_min(fine, fine_log, stages)
        said = ("%d spheres: ln T with %d corrected steps and with %d steps differs by at most %.2f %% in %d stages, "
                "%.1f\nstandard errors of the difference. The root mean square is %.2f %%. The stages took %.1f and "
                "%.1f minutes of a\nprocessor, a factor of **%.2f**.\n" %
                (fine.spheres, coarse.steps, fine.steps, 100 * largest(differences), stages,
                 largest(differences) / error, 100 * root_mean_square(differences), *minutes, minutes[1] / minutes[0]))
        verdict(largest(differences) <= ALLOWED * error, " ".join(said.split()))
        text += "\n" + said
    return text


def write(results, logs, sentences):
    for result in results:
        write_csv(result)
    renew(PAGE, "cooled", "gas/cool.py", numbers(results, logs) + sentences)
    output_of(["gnuplot", os.path.join(HERE, "cooling.gp")], cwd=ROOT)
    print("written: docs/at-scale.md and docs/gas/")


def missing():
    if not shutil.which(LMP):
        return "no program lmp; Debian calls its package lammps"
    if not shutil.which("cc") or run(["cc", "-E", "-"], input="#include <gsl/gsl_odeiv2.h>\n").returncode:
        return "no gsl/gsl_odeiv2.h; Debian calls its package libgsl-dev"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lattice", action="append", default=[], metavar="LATTICE[:STAGES[:STEPS]]",
                        help="spheres along the three axes, as 50x50x40; 1 + t/t_1 grows by 1.1 in each of 20 stages")
    parser.add_argument("--ranks", type=int, default=2, help="of MPI, 2 if not given")
    parser.add_argument("--results", help="folder that keeps each gas")
    parser.add_argument("--write", action="store_true", help="renew docs/at-scale.md; needs --lattice")
    options = parser.parse_args()
    wanted = re.compile(r"([1-9]\d*x[1-9]\d*x[1-9]\d*)(?::(\d+)(?::(\d+))?)?")
    gases = [wanted.fullmatch(lattice) for lattice in options.lattice]
    if not all(gases) or any(int(gas[2] or STAGES) < 4 or int(gas[3] or COARSE) < 8 for gas in gases):
        parser.error("--lattice takes three numbers, as 50x50x40, at least 4 stages, as 50x50x40:20, and at least 8 "
                     "time steps, as 50x50x40:12:50")
    if options.ranks < 1:
        parser.error("--ranks takes a number from 1")
    if options.write and not gases:
        parser.error("--write needs --lattice")
    if not os.access(CORGEN, os.X_OK):
        sys.exit("cool.py: no program %s; build it, or name it by CORGEN" % CORGEN)
    why = missing()
    if why:
        skip("a gas that cools", why)
        return summary()
    with tempfile.TemporaryDirectory() as work:
        os.environ["HOME"] = work  # Open MPI may write there
        folder = os.path.abspath(options.results or work)
        os.makedirs(folder, exist_ok=True)
        results = [large_gas(folder, work, gas[1], int(gas[2] or STAGES), int(gas[3] or COARSE), options.ranks)
                   for gas in gases]
        logs = []
        for result in results:
            name = "gas.%s.1.%d.log" % (result.lattice, result.steps)
            with open(os.path.join(folder, name), encoding="utf-8") as log:
                logs.append(cost_of(log.read()))
        sentences = comparisons(results, logs)
        if options.write:
            write(results, logs, sentences)
        if not gases:
            small_gas(work)
    return summary()


if __name__ == "__main__":
    sys.exit(main())
