# SPDX-License-Identifier: MIT
"""Provides programs, verdicts and their counts, and the renewal of marked parts of pages, for the scripts here."""
import csv
import io
import os
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CORGEN = os.environ.get("CORGEN", os.path.join(ROOT, "build", "corgen"))
LMP = os.environ.get("LMP", "lmp")
LIGGGHTS = os.environ.get("LIGGGHTS", "liggghts")
YADE = os.environ.get("YADE", "yade")
counts = {"passed": 0, "failed": 0, "skipped": 0}


def verdict(good, text):
    counts["passed" if good else "failed"] += 1
    print("%s  %s" % ("ok  " if good else "FAIL", text), flush=True)


def skip(name, why):
    counts["skipped"] += 1
    print("skip  %s: %s" % (name, why), flush=True)


def summary():
    """Prints the last line; returns the exit status."""
    print(", ".join("%d %s" % (counts[what], what) for what in counts if counts[what] or what != "skipped"))
    return counts["failed"] != 0


def run(command, **options):
    if "input" not in options:
        options["stdin"] = subprocess.DEVNULL
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=False, **options)


def output_of(command, **options):
    """Returns the output of the program, or prints where it fails."""
    done = run(command, **options)
    return done.stdout + (done.stderr if done.returncode else "")


def script(program, name, **variables):
    """Returns the command by which LAMMPS or LIGGGHTS runs a script of this folder with variables."""
    command = [program, "-log", "none", "-in", os.path.join(HERE, name), "-var", "here", HERE]
    for variable, value in variables.items():
        values = value if isinstance(value, list) else [value]
        command += ["-var", variable, *("%.17g" % v if isinstance(v, float) else str(v) for v in values)]
    return command


def first_row(*options):
    """Returns the first row of corgen's csv, by column."""
    return next(csv.DictReader(io.StringIO(output_of([CORGEN, *options, "--format", "csv"]))))


def numbers_of(*options):
    """Returns {quantity: value} of corgen contact without a speed."""
    rows = csv.DictReader(io.StringIO(output_of([CORGEN, "contact", *options, "--format", "csv"])))
    return {row["quantity"]: float(row["value"]) for row in rows if row["value"]}


def extrapolated(power, values):
    """Extrapolates to step 0 from the steps 4 h, 2 h and h. Simulators use the velocity of half a step earlier, which
    causes an error of order h. Damping proportional to x^b adds an error of order h^power, power = 1 + b."""
    first = [2 * fine - coarse for coarse, fine in zip(values, values[1:])]
    return (2**power * first[1] - first[0]) / (2**power - 1)


def renew(page, name, program, text):
    """Puts the text between the lines that mark it in a page."""
    begin, end = "<!-- %s: tests/simulators/%s --write -->\n" % (name, program), "<!-- end of %s -->\n" % name
    with open(page, encoding="utf-8") as file:
        head, rest = file.read().split(begin)
    with open(page, "w", encoding="utf-8") as file:
        file.write(head + begin + text + end + rest.split(end)[1])
