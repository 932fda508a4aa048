# SPDX-License-Identifier: MIT
"""Implements cor audit --run: measures the restitution of each contact of the audit with the user's own program."""

import importlib.util
import json
import math
import os
import re
import shlex
import shutil
import signal
import sys
import tempfile
import time
from typing import Any, Callable, Dict, List, Tuple

from .._command import UsageError, message, progress
from . import measure_lammps
from .collision import Failed
from .deck import Contact, Options, Row
from .process import ALL_S, Process, copy_folder_of

SLOW = 0.01  # impact speed times duration, divided by the radius, if eps is the same at every speed
TOLERANCE = 2e-3  # allowed |measured eps - computed eps|, before allowances for the error of the step


def measure(path: str, options: Options, rows: List[Row], program: str, keep: bool) -> None:
    """Executes the deck with the program. Fills the columns measured and measured_small_step of the rows."""
    todo = [row for row in rows if row.contact is not None and "clump" not in row.contact.unknown]
    if not todo:
        message(f"{path}: --run has no contact to measure")
        return
    simulator = rows[0].simulator
    of = MEASURES.get(simulator)
    if path == "-":
        raise UsageError("--run needs a file, not standard input")
    if of is None:
        message(f"{path}: --run measures inputs of {', '.join(MEASURES)}, not of {simulator}")
        return
    words = shlex.split(program)
    if not words or simulator != "mujoco" and not shutil.which(words[0]):
        raise UsageError(f"--run: no program {program!r}; give its name or path, for example --run {COMMON[simulator]}")
    message(f"{path}: --run executes this file, in a copy of its folder, by {program}")
    for name in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(name, lambda *_: sys.exit(130))
    whole = os.path.realpath(tempfile.mkdtemp(prefix="cor-audit-"))
    try:
        of(words, copy_folder_of(path, whole), path, options, todo)
    except Failed as error:
        message(f"{path}: {program}: {error}")
    finally:
        if keep:
            message(f"{path}: {whole} contains the files of the run")
        else:
            shutil.rmtree(whole, ignore_errors=True)


def speed_of(row: Row, contact: Contact) -> float:
    """Returns the impact speed in the deck's units or, if eps does not depend on it, a speed of small overlap."""
    units, free = contact.units, 0.1
    if math.isnan(row.speed_m_s) and 0 < row.duration_s < math.inf and contact.bodies[0].radius[row.size] > 0:
        free = SLOW * contact.bodies[0].radius[row.size] * units.length_m / row.duration_s
    speed = free if math.isnan(row.speed_m_s) else row.speed_m_s
    return speed * units.time_s / units.length_m


def sizes_of(row: Row, contact: Contact) -> Tuple[List[float], List[float]]:
    """Returns radii and masses of the two bodies. Unknown values are NaN, or follow from 1 cm and 2500 kg/m^3 if eps is
    known without them."""
    lj, units, known = contact.units.name == "lj", contact.units, not math.isnan(row.realised)
    radii, masses = [], []
    for body in contact.bodies:
        radius, density = body.radius[row.size], body.density
        if known and math.isnan(radius):
            radius = 0.5 if lj else 0.01 / units.length_m
        if known and math.isnan(density):
            density = 1.0 if lj else 2500 * units.length_m**3 / units.mass_kg
        radii.append(radius)
        masses.append(body.mass[row.size] if body.mass else 4 * math.pi / 3 * radius**3 * density)
    return radii, masses


def enter(row: Row, eps: float, eps_small_step: float, version: str) -> None:
    """Fills in the measured eps, and reports a difference between the measured and the computed eps."""
    bodies = row.contact.bodies if row.contact else ()
    assumed = any(math.isnan(b.radius[0]) and not b.wall for b in bodies) and not math.isnan(row.realised)
    row.measured, row.measured_small_step = math.nan if assumed else eps, eps_small_step
    if math.isnan(row.measured):
        why = "the radius is not in the text" if assumed else "a body would pass through its partner"
        row.advice += f" eps at the deck's step is not measured: {why}."
    bias = 0.0 if math.isnan(row.step_bias) else row.step_bias
    if math.isnan(row.realised):
        row.judged = True
        row.as_asked = None if math.isnan(row.asked) else abs(eps_small_step - row.asked) <= 0.01 * row.asked
        row.advice = f"{row.advice} Measured by {version}.".strip()
    elif abs(eps_small_step - row.realised) > TOLERANCE + abs(bias) / 10:
        row.advice += f" {version} realises {eps_small_step:.6g} with a small step, where cor computes "
        row.advice += f"{row.realised:.6g}."
    elif not math.isnan(row.step_bias) and abs(eps - row.realised - bias) > TOLERANCE + 4 * row.step_scatter:
        row.advice += f" With the deck's step {version} realises {eps:.6g}, where cor computes "
        row.advice += f"{row.realised + bias:.6g}."
    row.advice = row.advice.strip()


def refuse(row: Row, reason: str) -> None:
    row.advice = f"{row.advice} Not measured: {reason}.".strip()


# ---- LAMMPS and LIGGGHTS ----


def by_script(words: List[str], folder: str, path: str, options: Options, rows: List[Row]) -> None:
    todo = []
    for row in rows:
        contact = row.contact
        assert contact is not None
        bodies, (radii, masses) = contact.bodies, sizes_of(row, contact)
        wall = bodies[1].name.split() + [str(contact.line)] if bodies[1].wall else []
        kinds = bodies[0].type or 1, bodies[1].type or 1
        todo.append(
            measure_lammps.Collision(
                kinds, wall, (2 * radii[0], 2 * radii[1]), (masses[0], masses[1]), (bodies[0].held, bodies[1].held),
                speed_of(row, contact), contact.runs,
            )
        )  # fmt: skip
    end = time.monotonic() + ALL_S
    version, left_out, reason = measure_lammps.measure(words, folder, path, end, options.variables, todo)
    version = version if version.startswith("LIGGGHTS") else f"LAMMPS {version}"
    message(f"{path}: measured by {version}")
    for command, found in left_out.items():
        lines = list(dict.fromkeys(found))
        message(f"{path}: {command} left out (line {', '.join(map(str, lines[:9]))}{', ...' if lines[9:] else ''})")
    if reason:
        message(f"{path}: the script ended: {reason}")
    for row, c in zip(rows, todo):
        if math.isnan(c.eps_small_step):
            refuse(row, c.reason or reason or "the script ends before its first run")
        else:
            enter(row, c.eps, c.eps_small_step, version)


# ---- YADE and MuJoCo: a file that runs inside them ----


def name_of(text: str) -> Tuple[str, str, int]:
    """Parses the name of a body: "facet", "wall", "box" or "", its material's label, and index in O.materials or -1."""
    found = re.fullmatch(r"(?:(facet|wall|box) of )?(.*?)(?:, fixed)?", text, re.S)
    assert found is not None
    number = re.fullmatch(r"(material )?(\d+)", found[2])
    return found[1] or "", found[2], int(number[2]) - bool(number[1]) if number else -1


def inside(command: List[str], folder: str, path: str, options: Options, rows: List[Row]) -> None:
    """Runs a Python file inside a program. The file reads the collisions as json and prints a line of json for each."""
    here = os.path.dirname(os.path.abspath(__file__))
    spec = os.path.join(folder, "cor-collisions.json")
    todo: List[Dict[str, Any]] = [{"here": here, "script": os.path.basename(path)}]
    for number, row in enumerate(rows):
        contact = row.contact
        assert contact is not None
        radii, masses = sizes_of(row, contact)
        todo.append(
            {
                "number": number,
                "names": [name_of(body.name)[1:] for body in contact.bodies],
                "radii": [0 if math.isnan(x) else x for x in radii],
                "masses": [x if b.mass and math.isfinite(x) else 0 for x, b in zip(masses, contact.bodies)],
                "held": [body.held for body in contact.bodies],
                "wall": name_of(contact.bodies[1].name)[0],
                "speed": speed_of(row, contact),
                "runs": contact.runs,
                "done": False,
            }
        )
    end, reason, version = time.monotonic() + ALL_S, "", command[0]
    head, pending, left_out = todo[0], todo[1:], {}
    program = [*command, os.path.join(here, f"inside_{rows[0].simulator}.py"), spec]
    while pending:
        with open(spec, "w", encoding="utf-8") as out:
            json.dump([head, *pending], out)
        process, at = Process(program, folder, end), None
        try:
            while True:
                said = json.loads(process.read_until("cor {")[-1][4:])
                version, at = said.get("version", version), said.get("start", at)
                left_out.update({said["left_out"]: 0} if "left_out" in said else {})
                if "end" in said:
                    reason, pending = said["reason"], []
                    break
                if "number" in said:
                    pending = [c for c in pending if c["number"] != said["number"]]
                    row = rows[said["number"]]
                    progress(f"measured: {row.pair}")
                    if "eps" in said:
                        enter(row, said["eps"], said["eps_small_step"], version)
                    else:
                        refuse(row, said["reason"])
        except Failed as error:
            if at is None or not any(c["number"] == at for c in pending):
                reason, pending = str(error), []
            else:  # the program ended during this collision
                refuse(rows[at], str(error))
                pending = [c for c in pending if c["number"] != at]
        finally:
            process.close()
    if reason:
        message(f"{path}: the script ended: {reason}")
    message(f"{path}: measured by {version}")
    for text in left_out:
        message(f"{path}: left out: {text}")
    for row in rows:
        if math.isnan(row.measured_small_step) and "Not measured" not in row.advice:
            refuse(row, reason or "this contact occurs in no run")


def by_yade(words: List[str], folder: str, path: str, options: Options, rows: List[Row]) -> None:
    inside([*words, "-x", "-n", "-j1"], folder, path, options, rows)


def by_mujoco(words: List[str], folder: str, path: str, options: Options, rows: List[Row]) -> None:
    if importlib.util.find_spec("mujoco") is None:
        raise UsageError("--run mujoco: this Python has no module mujoco")
    inside([sys.executable], folder, path, options, rows)


MEASURES: Dict[str, Callable[[List[str], str, str, Options, List[Row]], None]] = {
    "lammps": by_script,
    "liggghts": by_script,
    "yade": by_yade,
    "mujoco": by_mujoco,
}
COMMON = {"lammps": "lmp", "liggghts": "liggghts", "yade": "yade", "mujoco": "mujoco"}
