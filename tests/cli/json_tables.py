# SPDX-License-Identifier: MIT
"""Compares every table that corgen writes as json with the same table as csv.

    tests/cli/json_tables.py CORGEN      COR_SEED repeats a run

Numbers are numbers with all their digits, texts are texts, and null represents nan, inf and empty cells of csv.
With --json-strings the columns that can exceed a double are texts."""
import csv
import decimal
import io
import json
import os
import random
import subprocess
import sys

MISSING = {"", "nan", "-nan", "inf", "-inf"}


def cases(draw):
    """Returns (command line, columns of text, True if --json-strings is allowed)."""
    beta = [f"{draw.uniform(0, 20):.6g}", f"{draw.randint(0, 40)}/{draw.randint(1, 30)}", f".{draw.randint(1, 999)}",
            f"00{draw.randint(0, 9)}.", f"{draw.randint(1, 9)}E-{draw.randint(1, 400)}"]
    speed = f"{draw.uniform(1e-3, 10):.5g}"
    digits = str(draw.randint(1, 24))
    bodies = "--young 7e10 --poisson 0.22 --radius 5e-3 --density 2500"
    for b in beta:
        yield f"collide --beta {b} --digits {digits}", "", True
    yield f"collide --beta {draw.uniform(2.1, 9):.3g} --elastic 1 --damping 0", "", True
    yield f"trajectory --order {draw.randint(0, 3)} --terms {draw.randint(8, 14)}", "", True
    yield f"series --order {draw.randint(0, 8)} --digits {digits}", "", True
    yield f"series --order {draw.randint(0, 8)} --digits {digits} --end zero-force", "", True
    yield f"series --order {draw.randint(0, 4)} --end zero-force --exact", "G T", True
    yield f"pade --numerator 2 --denominator 3 --digits {digits}", "polynomial", True
    yield f"disk-modes --poisson -{draw.randint(1, 9)}/10 --count 4 --digits {digits}", "", True
    yield f"disk-collide --speed 0.1,1e-9 --poisson 0.33 --alpha 50 --modes {draw.randint(1, 9)}", "status", False
    yield "disk-collide --hard-wall --speed 0.05 --poisson 0.3 --tolerance 1e-2", "status", False
    yield f"contact --beta {draw.uniform(0, 2)} --at 1 --speed {speed}", "", False
    yield f"contact --beta {draw.uniform(0, 2)} --at 1", "quantity unit", False
    yield "contact --elastic 1 --damping 0 --zeta 0.3", "quantity unit", False
    yield f"contact --law linear --zeta {draw.uniform(1, 3)} --stiffness 1e5 --effective-mass 1 --speed 1", "", False
    yield f"contact {bodies} --restitution 0.9 --at 1 --speed {speed}", "measured_end", False
    yield f"contact {bodies} --restitution 0.9 --at 1", "quantity unit", False
    yield f"contact {bodies} --dissipation-time 1e140 --speed {speed}", "", False
    yield f"sample --g-star {draw.uniform(0.1, 9)} --speed-min 0.01 --speed-max 1 --tolerance 1e-2", "", False
    yield "plan --law hunt-crossley --g-star 20 --speed-min 0.5 --speed-max 1 --tolerance 1e-2 --points 2", "model verdict", False
    disks = "--disks --poisson 0.2 --speed-min 0.01 --speed-max 0.02 --tolerance 0.01 --points 2"
    yield f"plan {disks}", "model verdict", False


def printed(corgen, line, *options):
    run = subprocess.run([corgen, *line.split(), *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert run.returncode in (0, 1, 3) and run.stdout, (line, run.returncode, run.stderr)
    return run.stdout


def refuse(name):
    raise AssertionError(f"{name} is not json")


def rows_of(text):
    rows = json.loads(text, parse_float=decimal.Decimal, parse_int=decimal.Decimal, parse_constant=refuse)
    assert isinstance(rows, list) and rows and all(isinstance(row, dict) for row in rows)
    return rows


def compare(corgen, line, texts, strings):
    table = list(csv.DictReader(io.StringIO(printed(corgen, line, "--format", "csv"))))
    rows = rows_of(printed(corgen, line, "--format", "json"))
    assert len(rows) == len(table)
    for row, cells in zip(rows, table):
        assert list(row) == list(cells), (list(row), list(cells))
        for name, cell in cells.items():
            if cell in MISSING:
                assert row[name] is None, (name, cell, row[name])
            elif name in texts.split():
                assert row[name] == cell, (name, cell, row[name])
            else:
                assert isinstance(row[name], decimal.Decimal) and row[name] == decimal.Decimal(cell), (name, cell)
    if not strings:
        return
    kinds = set()
    for row, number in zip(rows_of(printed(corgen, line, "--format", "json", "--json-strings")), rows):
        kinds.add(tuple(type(x).__name__ for x in row.values() if x is not None))
        same = {name: x if x is None or name in texts.split() else decimal.Decimal(x) for name, x in row.items()}
        assert same == number
    assert any("str" in kind for kind in kinds), "no column is a text"


def main():
    corgen = sys.argv[1]
    seed = int(os.environ.get("COR_SEED") or random.randrange(10**6))
    print(f"seed: COR_SEED={seed}")
    decimal.getcontext().prec = 1000
    done = set()
    for line, texts, strings in cases(random.Random(seed)):
        done.add(line.split()[0])
        try:
            compare(corgen, line, texts, strings)
        except (AssertionError, ValueError, decimal.InvalidOperation) as error:
            sys.exit(f"corgen {line}: {type(error).__name__} {error}")
    overview = subprocess.run([corgen, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
    for command in {words[0] for words in map(str.split, overview.splitlines()) if words} - done:
        shown = subprocess.run([corgen, command, "--help"], capture_output=True, text=True)
        if shown.returncode == 0 and "--format F" in shown.stdout:
            sys.exit(f"corgen {command} has formats and no case here")


main()
