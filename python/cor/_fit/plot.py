# SPDX-License-Identifier: MIT
"""Draws a fit: data, the best curve with its band, and residuals. Needs Matplotlib 3.6 or later."""

from importlib import import_module
from os.path import basename
from typing import Any, Dict, List

import numpy as np

from .compare import Estimate, finite_theta
from .data import Floats

FORMATS = {"pdf": {"CreationDate": None}, "png": {}, "svg": {"Date": None}}  # metadata without dates
COLOURS = "#2a6fb0 #c8442d #3c8a4e #8055a3 #b5812a #4fa3a5 #8a8a8a #d06fa0".split()
STYLES = ("-", "--", "-.", ":")


def _module(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError:
        packages = "on Debian: apt install python3-matplotlib; pip install matplotlib"
        raise ImportError(f"a picture needs Matplotlib; {packages}") from None


def format_of(path: str) -> str:
    """Return pdf, png or svg. Raise ValueError for other names."""
    form = path.rpartition(".")[2].lower()
    if form not in FORMATS:
        raise ValueError(f"plot: '{path}' is not the name of a picture; allowed: FILE.pdf, FILE.png or FILE.svg")
    return form


def _errors(e: Estimate) -> Any:
    """Return the standard deviations of eps, None if only the scatter of the points is known."""
    p, theta = e.problem, finite_theta(e)
    if p.sample.has_sigma:
        return p.spread(p.at(theta))
    if p.sample.is_points:
        return None
    _, weight, a = p.parts(theta)
    numbers = 1 + (1 + a) ** 2 + a * a if p.sample.is_times else 1 + a * a
    return np.sqrt(numbers * (e.sigma[0] / weight) ** 2 + e.sigma[1] ** 2)


def _limits(values: Floats, pad: float) -> Any:
    low, high = float(values.min()), float(values.max())
    room = pad * (high - low) or 0.02
    return low - room, high + room


def draw(result: Any, group: str = "", every: bool = False) -> Any:
    """Return a Matplotlib figure. every: also draw the other models"""
    model, best = result.find(group=group)
    flights, errors = best.problem.at(finite_theta(best)), _errors(best)
    order = np.argsort(flights.speed)
    speed, eps = flights.speed[order], flights.eps[order]
    errors = None if errors is None else errors[order]
    is_log = speed[-1] > 4 * speed[0]
    low, high = (speed[0], speed[-1]) if speed[-1] > speed[0] else (0.9 * speed[0], 1.1 * speed[0])
    x = np.geomspace(low, high, 200) if is_log else np.linspace(low, high, 200)
    figure = _module("matplotlib.figure").Figure((9.0 if every else 6.4, 5.6), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": (3, 1)})
    marks = {"fmt": "o", "ms": 3.5, "mfc": "white", "color": "#333333", "elinewidth": 0.7, "clip_on": False}
    residual = eps - model.curve.eps(finite_theta(best), np.log(speed))
    for axes, y in ((upper, eps), (lower, residual)):
        for bar in axes.errorbar(speed, y, errors, label="measured", zorder=2, **marks)[2]:
            bar.set_clip_on(True)
    band = result.predict(x, model.name, end=None if model.end == "both" else model.end, group=group)
    upper.fill_between(x, band.low_95, band.high_95, color=COLOURS[0], alpha=0.25, lw=0, label="95 % of the curve")
    curves: Dict[str, List[Any]] = {}
    for other, e in result.groups[group].comparison.fits:
        curves.setdefault(other.curve.name, []).append((other, e))
    mine = curves.pop(model.curve.name)
    for i, fits in enumerate([mine, *(curves.values() if every else [])]):
        names = [m.title for m, _ in fits] if len(fits) < 3 else list(dict.fromkeys(m.name for m, _ in fits))
        style = {"color": COLOURS[i % len(COLOURS)], "ls": STYLES[i // len(COLOURS) % len(STYLES)]}
        y = fits[0][0].curve.eps(finite_theta(fits[0][1]), np.log(x))
        upper.plot(x, y, label=", ".join(names), zorder=4 if i == 0 else 3, lw=2 if i == 0 else 1.2, **style)
    lower.axhline(0, color=COLOURS[0])
    if is_log:
        upper.set_xscale("log")
        ticks = _module("matplotlib.ticker")
        lower.xaxis.set_major_locator(ticks.LogLocator(subs=(1, 2, 5)))
        lower.xaxis.set_major_formatter(ticks.FormatStrFormatter("%g"))
        lower.xaxis.set_minor_formatter(ticks.NullFormatter())
    upper.set_xlim(low, high)
    upper.set_ylim(_limits(eps, 0.08))
    lower.set_ylim(_limits(np.append(residual, 0), 0.08))
    lower.set_xlabel("impact speed (m/s)")
    upper.set_ylabel("coefficient of restitution")
    lower.set_ylabel("measured - curve")
    title = f"restitution of {basename(result.data.name)}{', ' if group else ''}{group}, fitted by {model.title}"
    upper.set_title("".join(c if c.isprintable() else "?" for c in title).replace("$", r"\$"), fontsize=10)
    outside = {"loc": "upper left", "bbox_to_anchor": (1.01, 1)} if every else {"loc": "best"}
    handles, labels = upper.get_legend_handles_labels()
    upper.legend(handles[-1:] + handles[:-1], labels[-1:] + labels[:-1], fontsize=8, frameon=False, **outside)
    return figure


def save(figure: Any, file: Any, form: str) -> None:
    """Write a figure with reproducible bytes."""
    with _module("matplotlib").rc_context({"svg.hashsalt": "cor", "svg.fonttype": "none", "pdf.fonttype": 42}):
        figure.savefig(file, format=form, dpi=200, metadata=FORMATS[form])
