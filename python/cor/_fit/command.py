# SPDX-License-Identifier: MIT
"""Implements cor fit, which fits models of restitution to measured bounces."""

import argparse
import io
import math
import os
import re
from typing import Any, Dict, List, Sequence

from .._command import STATUS_OK, Failure, Parser, UsageError, add_common, message, positive, progress
from .._command import table, write_output
from .data import DataError
from .models import BODIES, MODELS
from .records import UNIT_NAMES
from .result import COLUMNS, Result, fit

HELP = """\
Fits models of restitution to measured bounces, ranks them by Akaike's information criterion (AIC; the least is best),
and prints which models fit. DATA is a csv file, or - for standard input. A row names the columns with their units.
Lines above it, lines that begin with # and other columns are not read.

  speed_m_s,eps[,eps_sigma]       impact speed, restitution and its standard deviation
  speed_m_s,speed_out_m_s         speeds before and after impact
  h0_cm,h1_cm[,h1_sigma_cm]       heights before and after impact; only h1_cm with --drop-height
  h_cm                            heights of successive apexes, beginning with the drop height or with --drop-height
  t_s[,h0_cm]                     times of bounces; the drop height gives the first impact speed
  interval_ms                     times between bounces
  time_s,height_m                 a track, in which cor finds the bounces
  run                             name of the drop; all drops are fitted together
  ball                            name of the ball; each ball is fitted separately, and all together
"""
MORE = """\
Columns of csv and json: model,end,parameter,value,low_68,high_68,low_95,high_95,rms,chi2,aic; if the data have the
column ball, it is the first one. Empty values are not determined. The intervals are profile likelihoods, and 68 means
68.27 %. rms is of the residuals; chi2 needs given errors. A model with p below 0.01 does not fit. With csv and json
the remarks go to standard error.

Example: cor fit measured.csv --law viscoelastic,constant --plot measured.svg
"""
BODY_HELP = {
    "young": "Young's modulus of the ball, Pa",
    "poisson": "Poisson's ratio of the ball, above -1 and up to 0.5",
    "radius": "radius of the ball, m",
    "density": "density of the ball, kg/m^3",
    "mass": "mass of the ball, kg",
}


def _positive_or_infinite(text: str) -> float:
    return math.inf if text == "inf" else positive(text)


def add_arguments(parser: Parser) -> None:
    parser.description, parser.epilog, parser.usage = HELP, MORE, "cor fit DATA [OPTION]..."
    parser.add_argument("data", metavar="DATA", nargs="?", help=argparse.SUPPRESS)
    parser.add_argument("--data", metavar="DATA", dest="data_option", help="file with the data, instead of DATA")

    def add(group: Any, name: str, metavar: str, help: str, kind: Any = positive) -> None:
        group.add_argument(name, metavar=metavar, type=kind, help=help)

    group = parser.add_argument_group("reading")
    add(group, "--unit", "U", f"units if the names have none, such as cm,ms; allowed: {', '.join(UNIT_NAMES)}", str)
    add(group, "--drop-height", "H", "height at which every drop begins, m")
    add(
        group,
        "--separator",
        "S",
        "separator of columns, comma, semicolon or tab (default: the most frequent in the row of names)",
        str,
    )
    group.add_argument("--decimal-comma", action="store_true", help="read numbers with a decimal comma")
    group = parser.add_argument_group("models")
    names = ", ".join(dict.fromkeys(model.name for model in MODELS))
    group.add_argument(
        "--law", metavar="NAMES", default="all", help=f"models to fit, all or several of {names} (default all)"
    )
    group.add_argument("--end", metavar="E", help="end of contact, zero-overlap or zero-force (default both)")
    group.add_argument("--robust", action="store_true", help="use Huber's function, which gives outliers little weight")
    group = parser.add_argument_group("gravity and air, for times and heights")
    add(group, "--gravity", "G", "gravity, m/s^2 (default 9.80665)")
    group.add_argument("--fit-gravity", action="store_true", help="fit gravity; needs times and drop heights")
    add(
        group,
        "--drag-coefficient",
        "CD",
        "drag coefficient of the ball in air, about 0.4 to 0.5; needs --mass and --diameter",
    )
    add(group, "--diameter", "D", "diameter of the ball, m (default: twice --radius)")
    add(group, "--air-density", "RHO", "density of air, kg/m^3 (default 1.204)")
    add(group, "--terminal-speed", "W", "terminal speed of the ball, m/s, instead of --drag-coefficient")
    group.add_argument("--fit-drag", action="store_true", help="fit the drag")
    group = parser.add_argument_group("bodies, SI units; with them the results are material parameters instead of g*")
    for name in BODIES:
        kind = float if "poisson" in name else _positive_or_infinite if name == "young_2" else positive
        text = "the same of the second body (default: as the first)" + ("; inf: rigid" if name == "young_2" else "")
        add(group, f"--{name.replace('_', '-')}", "X", text if name.endswith("_2") else BODY_HELP[name], kind)
    group.add_argument("--wall", action="store_true", help="use a flat and fixed second body")
    add(group, "--viscosity-liquid", "ETA", "viscosity of the liquid, Pa s, for the Stokes number of the model stokes")
    group = parser.add_argument_group("output")
    group.add_argument("--plot", metavar="FILE", help="picture of data, fit and residuals, .pdf, .png or .svg")
    group.add_argument("--all", action="store_true", help="draw all models, not only the best")
    add_common(parser)


def _text_table(rows: Sequence[Sequence[str]]) -> str:
    """Return columns side by side. In a column with negative numbers, the other texts begin with a blank."""
    columns = []
    for column in zip(*rows):
        signed = any(text.startswith("-") for text in column)
        texts = [" " * (signed and not text.startswith("-")) + text for text in column]
        columns.append([text.ljust(max(map(len, texts)) + 2) for text in texts])
    return "".join("".join(row).rstrip() + "\n" for row in zip(*columns))


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.6g}"


def report(result: Result) -> str:
    """Return the tables and remarks of all groups as text."""
    parts: List[str] = []
    for name in result.groups:
        rows = [["model", "end", "parameter", *COLUMNS]]
        for r in result.parameters[result.parameters.group == name]:
            value = "not determined" if math.isnan(r.value) else _number(r.value)
            rows.append([r.model, r.end, r.parameter, value, *(_number(r[c]) for c in COLUMNS[1:])])
        title = f"Ball {name}:\n" if name else "All balls together:\n" if len(result.groups) > 1 else ""
        remarks = [*result.remarks(name)]
        command = result.command(group=name) if result.groups[name].comparison.best() else None
        remarks += [f"To use it: {command}"] if command else []
        parts.append(title + _text_table(rows) + "\n" + "".join(line + "\n" for line in remarks))
    return "\n".join(parts)


def _option_of(text: str, options: argparse.Namespace) -> str:
    """Return a message about arguments of cor.fit as a message about the options."""
    names = "|".join(name for name in vars(options) if name in (*BODIES, "wall") or "_" in name)
    arguments = rf"^(?:{'|'.join(vars(options))})(?=:)|(?<![\w./-])(?:{names})(?![\w./-])"
    return re.sub(arguments, lambda name: f"--{name[0].replace('_', '-')}", text)


def run(options: argparse.Namespace) -> int:
    given = {k: v for k, v in vars(options).items() if v is not None}
    data = [given[k] for k in ("data", "data_option") if k in given]
    if len(data) != 1:
        raise UsageError("cor fit needs one DATA, for example cor fit DATA.csv; see cor fit --help")
    files = [os.path.realpath(path) for path in (*data, options.output, options.plot) if path and path != "-"]
    if len(set(files)) < len(files):
        raise UsageError("DATA, --output and --plot name the same file; give different files")
    ours = ("subcommand", "data", "data_option", "plot", "all", "format", "output", "profile")
    arguments: Dict[str, Any] = {k: v for k, v in given.items() if k not in ours}

    def tell(step: str, done: int, total: int) -> None:
        progress(f"{step}: {done} of {total}" if total else step)

    try:
        form = ""
        if options.plot:
            from .plot import draw, format_of, save

            form = format_of(options.plot)
        result = fit(data[0], progress=tell, **arguments)
        picture = io.BytesIO()
        if options.plot:
            progress("drawing")
            save(draw(result, every=options.all), picture, form)
    except ImportError as error:
        raise Failure(str(error)) from None
    except OSError as error:
        raise UsageError(f"cannot read {data[0]}: {error.strerror or error}") from None
    except (TypeError, ValueError) as error:
        text = str(error)
        raise UsageError(text if isinstance(error, DataError) else _option_of(text, options)) from None
    if options.format == "text":
        output = report(result)
    else:
        rows = [list(r)[not result.data.balls :] for r in result.parameters]
        columns = ["ball", "model", "end", "parameter", *COLUMNS][not result.data.balls :]
        output = table(columns, rows, options.format)
    if options.plot:
        write_output(options.plot, picture.getvalue())
    write_output(options.output, output)
    if options.format != "text":
        for name in result.groups:
            for line in result.remarks(name):
                message(f"{name}: {line}" if name else line)
    return STATUS_OK
