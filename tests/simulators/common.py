# SPDX-License-Identifier: MIT
"""What the scripts here share: the programs, verdicts and their counts, and pages whose marked part is renewed."""
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CORGEN = os.environ.get("CORGEN", os.path.join(ROOT, "build", "corgen"))
LMP = os.environ.get("LMP", "lmp")
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
    return subprocess.run(command, capture_output=True, text=True, check=False, **options)


def renew(page, name, program, text):
    """Puts the text between the lines that mark it in a page."""
    begin, end = "<!-- %s: tests/simulators/%s --write -->\n" % (name, program), "<!-- end of %s -->\n" % name
    with open(page, encoding="utf-8") as file:
        head, rest = file.read().split(begin)
    with open(page, "w", encoding="utf-8") as file:
        file.write(head + begin + text + end + rest.split(end)[1])
