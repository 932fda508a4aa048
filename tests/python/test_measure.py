# SPDX-License-Identifier: MIT
"""Tests cor audit --run: the decks of tests/audit in their programs, and the lines that the audit offers.

A few decks are run by default, and all of them if COR_TEST_LONG is set. LMP, LIGGGHTS and YADE name the programs.
    python3 tests/python/test_measure.py     runs all decks, and writes the measured values to tests/audit/judged.csv
"""

import csv
import importlib.util
import io
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from functools import partial
from pathlib import Path

import pytest
from test_audit import DECKS, JUDGED, number, options_of, run

from cor._audit import command, measure, physics, process
from cor._command import Parser

LONG = bool(os.environ.get("COR_TEST_LONG"))
PROGRAMS = {"lmp": ("LMP", "lmp"), "lig": ("LIGGGHTS", "liggghts"), "py": ("YADE", "yade"), "xml": ("", "mujoco")}
PROGRAMS = {kind: os.environ.get(name, program) for kind, (name, program) in PROGRAMS.items()}
FEW = "lammps-freeze.lmp liggghts-two-kinds.lig yade-cohesive.py".split()
RUNNABLE = [deck for deck in DECKS if deck.suffix[1:] in PROGRAMS]


def program_of(deck):
    """Returns the program that runs a deck. Skips the test without it."""
    program = PROGRAMS[deck.suffix[1:]]
    if not (importlib.util.find_spec("mujoco") if program == "mujoco" else shutil.which(program)):
        pytest.skip(f"no program {program}")
    return program


def measured(deck, options, program):
    status, out, messages = run("audit", deck, *options, "--run", program, "--format", "csv")
    return [row for row in csv.DictReader(io.StringIO(out)) if row["model"]], messages


@pytest.mark.parametrize("deck", [d for d in RUNNABLE if LONG or d.name in FEW], ids=lambda deck: deck.name)
def test_measured(deck):
    """If a program can run the deck, its eps agrees with cor's."""
    rows, messages = measured(deck, options_of(deck), program_of(deck))
    assert "executes this file" in messages
    for row in rows:
        assert "where cor computes" not in row["advice"], row
        assert row["measured_small_step"] or "Not measured" in row["advice"] or "clump" in row["advice"], row
    if deck.name in FEW:
        assert rows and all(row["measured_small_step"] for row in rows)
    if deck.name == "yade-cohesive.py":  # cor does not have its law: an elastic spring, and NewtonIntegrator's damping
        assert abs(number(rows[0]["measured_small_step"]) - math.sqrt(0.9 / 1.1)) < 1e-5


def rows_of(deck, options):
    """Returns the rows of the audit with the offered lines."""
    parser = Parser()
    command.add_arguments(parser)
    return physics.audit_text(
        deck.read_text(), str(deck), command._options(parser.parse_args([str(deck), *options]), str(deck))
    )


@pytest.mark.parametrize("deck", DECKS, ids=lambda deck: deck.name)
def test_paste_back(deck, tmp_path):
    """With an offered line in its place, the audit computes the requested e, and a long test measures it."""
    options = options_of(deck)
    try:
        found = [row for row in rows_of(deck, options) if row.instead]
    except ValueError:
        return
    for row in found:
        shutil.copytree(deck.parent, tmp_path, dirs_exist_ok=True)
        path = tmp_path / os.path.relpath(row.instead_file, deck.parent)
        lines = path.read_text().split("\n")
        lines[row.instead_line - 1 : row.instead_last] = [row.instead]
        path.write_text("\n".join(lines))
        key = row.pair, row.speed_m_s, row.contact.runs
        pasted = [
            r
            for r in rows_of(tmp_path / deck.name, options)
            if r.contact and str(key) == str((r.pair, r.speed_m_s, r.contact.runs))
        ]
        assert any(abs(r.realised - row.asked) <= 0.01 * row.asked for r in pasted), row
        if LONG and deck in RUNNABLE:
            again, _ = measured(tmp_path / deck.name, options, program_of(deck))
            values = [number(r["measured_small_step"]) for r in again if r["pair"] == row.pair]
            assert all(math.isnan(v) for v in values) or any(
                abs(v - row.asked) < 0.011 * row.asked + 1e-3 for v in values
            ), again


HEAD = "processors 2 2 1\nunits si\natom_style sphere\nboundary f f f\ncomm_modify vel yes\n"
HEAD += "region b block -1 1 -1 1 -1 1\ncreate_box 1 b\n"
HEAD += (
    "create_atoms 1 single 0 0 0\nset type 1 diameter 0.01 density 2500\npair_style gran/hooke 1e4 NULL 50 NULL 0 0\n"
)
HEAD += "pair_coeff * *\ntimestep 1e-6\n"


def test_left_out(tmp_path):
    """Commands that execute others or write files are named and not executed, in every notation."""
    program, bad = program_of(Path("x.lmp")), tmp_path / "bad"
    deck = tmp_path / "deck.lmp"
    text = (
        f'{HEAD}shell touch {bad}\nvariable c string "shell touch {bad}"\n${{c}}\nif "1 > 0" then "shell touch {bad}"\n'
    )
    text += f'dump 1 all atom 1 {bad}\nfix p all print 1 "x" file {bad}\nwrite_data {bad}\nprint "x" file {bad}\n'
    text += f'python f here """\nshell touch {bad}\n"""\nfix r all ave/time 1 1 1 c_thermo_temp file {bad}\nrun 10\n'
    deck.write_text(text)
    rows, messages = measured(deck, ["--speed", "1"], program)
    assert abs(number(rows[0]["measured_small_step"]) - number(rows[0]["realised"])) < 1e-3
    assert "measured by LAMMPS" in messages
    assert not bad.exists() and sorted(os.listdir(tmp_path)) == ["deck.lmp"]
    for name in "shell", "dump", "write_data", "python", "fix print", "fix ave/time":
        assert f": {name} left out" in messages, name


def test_kept_and_late(tmp_path, monkeypatch):
    """Only --keep keeps the folder of a run. A program that does not answer is ended. Without a contact nothing
    runs."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "tmp"))
    os.mkdir(tmp_path / "tmp")
    deck, program, late = tmp_path / "deck.lmp", program_of(Path("x.lmp")), str(tmp_path / "late")
    deck.write_text(HEAD + "run 1\n")
    assert "files of the run" not in measured(deck, ["--speed", "1"], program)[1] and not os.listdir(tmp_path / "tmp")
    _, messages = measured(deck, ["--speed", "1", "--keep"], program)
    (folder,) = (tmp_path / "tmp").iterdir()
    assert f": {folder} contains the files of the run" in messages
    assert "create_atoms 1 single" in (folder / "1/2/3/cor-sent").read_text()
    Path(late).write_text("#!/bin/sh\nexec sleep 100\n")
    os.chmod(late, 0o755)
    limits = {"RUN_S": (process, "no answer within 0 s"), "ALL_S": (measure, "the runs took 10 minutes")}
    for name, (module, reason) in limits.items():
        with monkeypatch.context() as limit:
            limit.setattr(module, name, 0.2)
            (row,), messages = measured(deck, ["--speed", "1"], late)
        assert f"{late}: {reason}" in messages and not row["measured"] and row["realised"], (row, messages)
    deck.write_text("pair_style none\nrun 1\n")
    rows, messages = measured(deck, [], late)
    assert not rows and "--run has no contact to measure" in messages and "sets no contact itself" in messages


def test_overdamped(tmp_path):
    """A contact of infinite duration is measured, too."""
    deck = tmp_path / "deck.lmp"
    deck.write_text(HEAD.replace("NULL 50", "NULL 1e5") + "run 1\n")
    (row,), _ = measured(deck, [], program_of(deck))
    assert row["realised"] == "0" and number(row["measured"]) == 0, row


def test_late_material(tmp_path):
    """YADE: a material that the script makes after a run is measured at a later run, or at the end of the script."""
    deck, run_ = tmp_path / "deck.py", "O.dt=1e-5\nO.run(1,True)\n"
    loop = "InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],[Ip2_ViscElMat_ViscElMat_ViscElPhys()],"
    engines = f"O.engines=[{loop}[Law2_ScGeom_ViscElPhys_Basic()]),NewtonIntegrator(damping=0)]\n"
    kinds = [f"O.materials.append(ViscElMat(tc=1e-3,en={e},et=1,density=2500))\n" for e in (0.5, 0.3)]
    for end in (run_, ""):
        deck.write_text(engines + kinds[0] + run_ + kinds[1] + end)
        rows, _ = measured(deck, ["--radius", "0.01", "--speed", "1"], program_of(deck))
        assert len(rows) == 3 and all(row["measured_small_step"] for row in rows), rows


def test_difference(tmp_path):
    """If cor assumes another version, the advice states the difference between the program's eps and cor's."""
    deck = tmp_path / "deck.lmp"
    model = "pair_style granular\npair_coeff * * hooke 1e4 0.5 tangential linear_nohistory 0 0 damping tsuji\n"
    deck.write_text(re.sub(r"pair_style.*\n.*\n", model, HEAD))
    options = ["--speed", "1", "--simulator-version"]
    for version, differs in ("29 Sep 2021", False), ("1 Aug 2026", True):
        (row,), _ = measured(deck, [*options, version], program_of(deck))
        assert ("where cor computes" in row["advice"]) == differs, row


def processes_in(folder):
    """Returns the processes whose working directory is in the folder."""
    found = []
    for link in Path("/proc").glob("[0-9]*/cwd"):
        with suppress(FileNotFoundError, PermissionError, ProcessLookupError):
            found += [link] if os.readlink(link).startswith(str(folder)) else []
    return found


@pytest.mark.parametrize("kind", ["lmp", "py"])
def test_interrupt(kind, tmp_path):
    """Ctrl-C ends the program, and removes the temporary folder."""
    deck, folder = tmp_path / f"deck.{kind}", tmp_path / "tmp"
    program, forever = program_of(deck), {
        "lmp": HEAD.replace("1e-6", "1e-12"),
        "py": "O.engines=[]\nwhile True: pass\n",
    }
    folder.mkdir()
    deck.write_text(forever[kind] if kind == "lmp" else "m=ViscElMat(tc=1e-3,en=0.5,et=1)\n" + forever[kind])
    words = [sys.executable, "-m", "cor", "audit", str(deck), "--run", program, "--speed", "1", "--radius", "0.01"]
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # in the background SIGINT is ignored
    env = {**os.environ, "TMPDIR": str(folder)}
    with subprocess.Popen(words, env=env, stderr=subprocess.PIPE, preexec_fn=heard) as process:
        while not os.listdir(folder) and process.poll() is None:
            time.sleep(0.05)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        assert process.wait(60) == 130
    assert os.listdir(folder) == []
    end = time.monotonic() + 60
    while (left := processes_in(tmp_path)) and time.monotonic() < end:  # MPI's daemon ends after its program
        time.sleep(0.1)
    assert not left


if __name__ == "__main__":
    with open(JUDGED, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    known = {tuple(row[:3]) for row in rows}
    for deck in RUNNABLE:
        try:
            found, _ = measured(deck, options_of(deck), program_of(deck))
        except pytest.skip.Exception:
            continue
        for row in found:
            key = deck.name, row["pair"], row["speed_m_s"]
            if row["measured_small_step"] and row["realised"] and key not in known:
                known.add(key)
                judge = f"{program_of(deck)}, --run"
                rows.append([*key, f"{number(row['measured_small_step']):.6g}", "1e-3", judge])
    with open(JUDGED, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)
