# SPDX-License-Identifier: MIT
"""Provides the contacts of contacts.csv for tests of C, Python and the page: options of corgen contact, and its answer.

    python3 tests/reference/contacts.py     renews the answers by CORGEN

contacts: 2 if a restitution is given without --end. line: the first line for the simulator of --for except comments,
or the refusal. page: the page has fields for these options.
"""

import csv
import os
import subprocess
from pathlib import Path

FILE = Path(__file__).with_suffix(".csv")
NUMBERS = "beta eps_zero_overlap eps_zero_force duration_s_zero_overlap duration_s_zero_force".split()
NUMBERS += ["max_overlap_m", "max_force_n"]


def rows():
    """Returns the rows, each with its options as a dictionary."""
    found = list(csv.DictReader(FILE.open()))
    for row in found:
        words, row["options"] = row["contact"].split(), {}
        for name, value in zip(words, words[1:] + ["--"]):
            if name.startswith("--"):
                row["options"][name[2:]] = None if value.startswith("--") else value
    return found


def answer(row):
    """Returns the cells that corgen gives for a row."""
    program = [os.environ.get("CORGEN", "build/gcc/corgen"), "contact"]

    def run(without, *more):
        words = [w for k, v in row["options"].items() if k not in without for w in (f"--{k}", v) if w is not None]
        return subprocess.run([*program, *words, *more], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    cells = {name: "" for name in ("contacts", *NUMBERS, "line")}
    if "speed" in row["options"]:
        table = list(csv.DictReader(run(["for", "steps"], "--format", "csv").stdout.splitlines()))
        first = row["options"]["speed"].split(",")[0]
        cells["contacts"] = str(sum(float(r["speed_m_s"]) == float(first) for r in table))
        cells.update(
            {
                name: table[0].get(name.replace("zero_force", end), table[0].get(name, ""))
                for name in NUMBERS
                for end in ["surface" if "eps_surface" in table[0] else "zero_force"]
            }
        )
    if "for" in row["options"]:
        done = run([])
        lines = [t for t in done.stdout.splitlines() if t and not t.startswith(("#", "//", "!", "<!--", "%"))]
        cells["line"] = lines[0] if lines else done.stderr.partition(": ")[2].strip()
    return cells


if __name__ == "__main__":
    written = [{"contact": r["contact"], "page": r["page"], **answer(r)} for r in rows()]
    with FILE.open("w", newline="") as file:
        table = csv.DictWriter(file, ["contact", "page", "contacts", *NUMBERS, "line"], lineterminator="\n")
        table.writeheader()
        table.writerows(written)
