# SPDX-License-Identifier: MIT
"""cor audit: the restitution that the input of a simulator really gives."""

import argparse
import os
import re
from dataclasses import replace
from importlib import import_module
from typing import Dict, List, Optional, Tuple

from .._command import STATUS_OK, STATUS_USAGE, Parser, UsageError, add_common, message, numbers, positive
from .._command import printable, progress, read_text, table, write_output
from .._cor import lib
from . import physics
from .deck import COLUMNS, MAX_BYTES, NAN, DeckError, Options, Row

STATUS_NOT_AS_ASKED, STATUS_NOT_JUDGED = 3, 4

EPILOG = f"""\
FILE: scripts of LAMMPS and LIGGGHTS, Python of YADE, materials of Kratos (json), input of MFiX, MuJoCo (xml), Gazebo
(SDF) and Lethe (prm), commands of PFC, C++ for MercuryDPM.
Only --run executes a file.

Columns: {','.join(COLUMNS)}.

Exit status: 2 for wrong usage, an unreadable file, or a file without a contact that can be judged; otherwise 3 if a
contact does not give the requested eps; otherwise 4 if a contact could not be judged; otherwise 0.

Example: cor audit in.chute --radius 5e-3 --density 2500 --speed 0.1,1
"""


def _by_type(text: str) -> Tuple[str, float]:
    name, _, value = text.rpartition("=")
    return name, positive(value)


def _angle(text: str) -> float:
    value = 0.0 if re.fullmatch(r"0+(\.0*)?", text) else positive(text)
    if value >= 90:
        raise argparse.ArgumentTypeError(f"'{text}' is not an angle from 0 to below 90 degrees")
    return value


def add_arguments(parser: Parser) -> None:
    """Adds the options of cor audit."""
    add = parser.add_argument
    parser.usage, parser.epilog = "cor audit FILE... [OPTION]...", EPILOG
    add("files", nargs="+", metavar="FILE", help="inputs of simulators, or - for standard input")
    add("--speed", type=numbers, metavar="LIST", default=[], help="impact speeds, m/s, such as 0.1,1 or 0.01:10:log:7")
    for name, unit in (("radius", "m"), ("density", "kg/m^3")):
        add(f"--{name}", type=_by_type, action="append", default=[], metavar="[TYPE=]NUMBER",
            help=f"{name} of the spheres of one type or of all, {unit}, if the file does not contain it")  # fmt: skip
    add("--time-step", type=positive, metavar="DT", default=NAN, help="time step, s (default: the file's)")
    add("--angle", type=_angle, metavar="DEGREES", default=NAN,
        help="impact angle, degrees, 0 to below 90; fills tangential_restitution (-u'/u) for LAMMPS, LIGGGHTS, YADE "
        "and MercuryDPM; for other tangential forces the column is empty, and the advice states why")  # fmt: skip
    add("--tolerance", type=positive, metavar="T", default=0.01,
        help="largest relative error of eps, and largest scatter, that count as asked (default 0.01)")  # fmt: skip
    add("--for", dest="simulator", metavar="SIMULATOR", default="", help="simulator, if the file does not show it")
    add("--simulator-version", metavar="V", default="", help="version of the simulator, such as '29 Sep 2021' or 3.8.1")
    add("-var", "--var", nargs="+", action="append", default=[], metavar=("NAME", "VALUE"),
        help="variable of the script and its values, as for lmp; after the files")  # fmt: skip
    add("--run", metavar="PROGRAM", help="program that runs the file, to measure eps; executes the file")
    add("--keep", action="store_true", help="keep the temporary folder of --run, and print its name")
    add_common(parser)


def _includes(first: str, name: str, of: str) -> Optional[Tuple[str, str]]:
    """Returns text and path of an included file. Searches the folder of the file `of`, then of the first file."""
    for folder in (os.path.dirname(of), os.path.dirname(first)):
        path = os.path.join(folder, name)
        try:
            if name != "-":
                return read_text(path, MAX_BYTES), path
        except (OSError, ValueError):
            continue
    return None


def _options(given: argparse.Namespace, path: str) -> Options:
    if given.simulator and given.simulator not in physics.SIMULATORS:
        raise UsageError(f"--for: '{given.simulator}' is not a simulator; allowed: {', '.join(physics.SIMULATORS)}")
    version = given.simulator_version
    if version and lib.cor_simulator_version(version.encode("utf-8", "replace")) == 0:
        raise UsageError(f"--simulator-version: '{version}' is not a version such as '29 Sep 2021' or 3.8.1")
    if any(len(words) < 2 for words in given.var):
        raise UsageError("-var needs a name and at least one value, for example -var e 0.7")
    variables: Dict[str, Tuple[str, ...]] = {words[0]: tuple(words[1:]) for words in given.var}
    return Options(
        given.simulator, version, tuple(given.speed), dict(given.radius), dict(given.density),
        time_step=given.time_step, tolerance=given.tolerance, variables=variables, angle=given.angle,
        include=lambda name, of: _includes(path, name, of), progress=progress,
    )  # fmt: skip


def _texts(rows: List[Row]) -> str:
    """Returns the text of all rows. Contacts that differ only in line and pair have one text, which names the first."""
    alike: Dict[str, List[Row]] = {}
    for row in rows:
        key = _text(replace(row, line=0, pair="")) if row.model else f"{row.file}:{row.line}: {row.advice}"
        alike.setdefault(key, []).append(row)
    made = ""
    for first, *others in alike.values():
        names = [first.pair] + [r.pair + f" (line {r.line})" * (r.line != first.line) for r in others]
        names = list(dict.fromkeys(names))
        more = f" and {len(names) - 3} more" if len(names) > 3 else ""
        made += _text(replace(first, pair="; ".join(names[:3]) + more))
    return made


def _text(row: Row) -> str:
    lines = [f"{row.file}:{row.line}: "]
    if not row.model:
        return printable(lines[0] + row.advice) + "\n"
    lines[0] += f"{row.simulator} {row.model}, {row.pair}"
    lines[0] += "" if row.speed_m_s != row.speed_m_s else f", {row.speed_m_s:.6g} m/s"
    number = "" if row.asked != row.asked else f"asked e = {row.asked:.6g}, "
    number += "eps is not known" if row.realised != row.realised else f"eps = {row.realised:.6g} at {row.end}"
    number += {True: ": as asked", False: ": NOT AS ASKED", None: ""}[row.as_asked]
    number += "" if row.judged else ": NOT JUDGED"
    if row.damping == row.damping:
        number += f"; {row.law}, {'zeta' if row.law in ('linear', 'tsuji') else 'beta'} = {row.damping:.6g}"
    if row.duration_s == row.duration_s:
        number += f"; contact {row.duration_s:.3g} s"
        number += "" if row.time_step_s != row.time_step_s else f" = {row.duration_s / row.time_step_s:.4g} steps"
    if row.step_bias == row.step_bias:
        number += f"; the time step adds {row.step_bias:.2g} to the mean eps, with scatter {row.step_scatter:.2g}"
    if row.realised_surface == row.realised_surface:
        number += f"; under gravity {row.realised_surface:.6g}"
    if row.tangential_restitution == row.tangential_restitution:
        number += f"; tangential restitution {row.tangential_restitution:.6g}"
    if row.measured == row.measured or row.measured_small_step == row.measured_small_step:
        number += "; measured " + (f"{row.measured:.6g}, " if row.measured == row.measured else "")
        number += f"with a hundredth of the step {row.measured_small_step:.6g}"
    lines += [number] + [row.advice] * bool(row.advice)
    lines += [f"write: {row.instead.expandtabs()}"] if row.instead else []
    return "\n    ".join(printable(line) for line in lines) + "\n"


def _columns(row: Row) -> List[object]:
    values = [getattr(row, name) for name in COLUMNS]
    if row.instead:
        values[COLUMNS.index("advice")] = f"{row.advice} Write: {row.instead.expandtabs()}".strip()
    return values


def status_of(rows: List[Row]) -> int:
    """Returns the exit status of one file from its rows."""
    contacts = [row for row in rows if row.model]
    if not any(row.judged or row.end for row in contacts):  # if the version lacks the model, unjudged rows have an end
        return STATUS_USAGE
    if any(row.as_asked is False for row in contacts):
        return STATUS_NOT_AS_ASKED
    return STATUS_OK if all(row.judged for row in rows) else STATUS_NOT_JUDGED


def run(given: argparse.Namespace) -> int:
    """Audits all files. An error in one file does not stop the others."""
    rows: List[Row] = []
    statuses = []
    for path in given.files:
        options = _options(given, path)
        name = "standard input" if path == "-" else path
        try:
            progress(f"reading: {name}")
            text = read_text(path, MAX_BYTES)
            found = physics.audit_text(text, name, options)
            if given.run is not None:
                import_module("cor._audit.measure").measure(path, options, found, given.run, given.keep)
        except OSError as error:
            message(f"cannot read {name}: {error.strerror or error}")
            statuses.append(STATUS_USAGE)
        except (DeckError, ValueError) as error:
            message(f"{name}: {error}")
            statuses.append(STATUS_USAGE)
        else:
            rows += found
            statuses.append(status_of(found))
            if statuses[-1] == STATUS_USAGE:
                places: Dict[str, Dict[str, None]] = {}  # advice -> its lines
                for row in found:
                    places.setdefault(row.advice, {})[str(row.line)] = None
                texts = {text: ", ".join(list(at)[:5]) + ", ..." * (len(at) > 5) for text, at in places.items() if text}
                reasons = "; ".join(f"line {lines}: {text}" for text, lines in texts.items())
                what = options.simulator or physics.simulator_of(text)
                why = f": {reasons}" if reasons else f": it looks like an input of {what}, but sets no contact itself"
                message(f"{name}: no contact can be judged{why}")
    if given.format != "text":
        write_output(given.output, table(COLUMNS, [_columns(row) for row in rows], given.format))
    else:
        contacts = [row for row in rows if row.model]
        asked = [row for row in contacts if row.judged and row.as_asked is not None]
        good, unknown = sum(row.as_asked is True for row in asked), sum(not row.judged for row in contacts)
        end = f"{len(contacts)} contact{'s' * (len(contacts) != 1)}: {good} as asked "
        end += f"within {100 * given.tolerance:.3g} %, {len(asked) - good} not, "
        end += f"{len(contacts) - len(asked) - unknown} without e"
        end += f", {unknown} not judged" if unknown else ""
        lines = sum(not row.model for row in rows)
        end += f"; {lines} remark{'s' * (lines != 1)}" if lines else ""
        write_output(given.output, _texts(rows) + ("\n" if rows else "") + end + "\n")
    order = (STATUS_USAGE, STATUS_NOT_AS_ASKED, STATUS_NOT_JUDGED, STATUS_OK)
    return min(statuses, key=order.index)
