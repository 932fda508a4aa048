# SPDX-License-Identifier: MIT
"""Implements cor.fit and its result: parameters, verdict, predictions, commands."""

import math
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from .._evaluate import number
from .compare import (
    NO_SCATTER,
    SIGNIFICANCE,
    Comparison,
    Estimate,
    Outlier,
    Setup,
    compare,
    find_outliers,
    finite_theta,
)
from .data import GRAVITY_M_S2, Data, DataError, Floats, Form, Points, Times
from .intervals import LEVELS, covariance_of, profile, quantile, unit_of
from .likelihood import HUBER, MANY, Field, Sample, scipy
from .models import BODIES, Bodies, Model, Parameter, choose

SEPARATORS = {None: None, "comma": ",", "semicolon": ";", "tab": "\t", ",": ",", ";": ";", "\t": "\t"}
COLUMNS = ("value", "low_68", "high_68", "low_95", "high_95", "rms", "chi2", "aic")
Progress = Callable[[str, int, int], None]


@dataclass
class Group:
    """The fits of one ball, or of all data."""

    name: str  # "": all
    sample: Sample
    comparison: Comparison
    outliers: List[Outlier]
    without_outliers: Optional[Comparison] = None


def _p_text(e: Estimate) -> str:
    if math.isnan(e.p_value):
        return "p unknown"
    return f"p = {e.p_value:.2g}" if e.p_value >= 1e-300 else "p < 1e-300"


def _judgement(e: Estimate) -> str:
    return "too few" if math.isnan(e.p_value) else "fits" if e.fits else "does not fit"


class Result:
    """Fits of restitution, made by cor.fit.

    groups: the fits of each ball by its name; "" is the fit of all data. parameters: a record array with a row for each
    parameter of each model, the least AIC first. Its columns are group, model, end, parameter, value, low_68, high_68,
    low_95, high_95, rms, chi2, aic. A value is nan if it is not determined, because the minimum is flat.
    pandas.DataFrame(result.parameters) is a table.
    """

    def __init__(self, data: Data, setup: Setup, bodies: Bodies, groups: Dict[str, Group]) -> None:
        self.data, self.setup, self.groups, self._bodies = data, setup, groups, bodies
        self._regions: Dict[Tuple[str, int], Any] = {}

    def __repr__(self) -> str:
        return f"<cor.fit of {self.data.name}: {' '.join(self.verdict(name) for name in self.groups)}>"

    # ---- parameters ----

    def _parameters(self, model: Model) -> List[Parameter]:
        made, field = model.parameters(self._bodies), self.setup.field
        for name in self.setup.free:
            if name == "gravity":
                made.append(Parameter("gravity_m_s2", lambda theta: field.gravity * np.exp(theta)))
            elif math.isnan(field.to_coefficient):
                made.append(Parameter("terminal_speed_m_s", lambda kappa: 1 / np.sqrt(kappa)))
            else:
                made.append(Parameter("drag_coefficient", lambda kappa: kappa * field.to_coefficient))
        return made

    def parameters_of(self, model: Model, e: Estimate) -> List[Tuple[str, List[float]]]:
        """Return name, value and intervals (low and high of 68 %, of 95 %) of each parameter."""
        rows = []
        for j, parameter in enumerate(self._parameters(model)):
            unit = e.problem.fastest2 if e.problem.kinds[j] == "positive" else 1.0
            numbers = [parameter.value(e.theta[j] / unit)]
            for level in (0, 1):
                numbers += sorted(parameter.value(end / unit) for end in e.intervals[j, level])
            rows.append((parameter.name, numbers if e.determined[j] else [math.nan] * 5))
        return rows

    @property
    def parameters(self) -> Any:
        rows = [
            (group.name, model.name, model.end, name, *numbers, e.rms, e.chi2, e.aic)
            for group in self.groups.values()
            for model, e in group.comparison.fits
            for name, numbers in self.parameters_of(model, e)
        ]
        texts = [(name, object) for name in ("group", "model", "end", "parameter")]
        return np.array(rows, [*texts, *((name, np.float64) for name in COLUMNS)]).view(np.recarray)

    def find(self, model: Optional[str] = None, end: Optional[str] = None, group: str = "") -> Tuple[Model, Estimate]:
        """Return a model and its fit. Default: the model in the verdict or, if none fits, the least AIC."""
        if group not in self.groups:
            raise ValueError(f"group: {group!r}; allowed: {', '.join(map(repr, self.groups))}")
        fits = self.groups[group].comparison.fits
        if model is None:
            return self.groups[group].comparison.best() or fits[0]
        name, _, last = model.partition(" ")
        end = (end or last).replace("_", "-")
        found = [fit for fit in fits if fit[0].name == name and end in ("", fit[0].end)]
        if not found:
            known = ", ".join(fit[0].title for fit in fits)
            raise ValueError(f"model: {model!r} is not among the fitted models; allowed: {known}")
        return found[0]

    # ---- sentences ----

    def verdict(self, group: str = "") -> str:
        c = self.groups[group].comparison
        judged = [(model, e) for model, e in c.fits if not math.isnan(e.p_value)]
        best, least = c.best(), c.fits[0][0].title
        if not judged:
            return f"The points are too few to judge any of these models. Of them, {least} has the least AIC."
        if not best:
            limit = ", among the models that these points are enough to judge" if len(judged) < len(c.fits) else ""
            return f"None of these models fits the data{limit}."
        contacts = [fit for fit in judged if fit[0].is_contact]
        if contacts and not any(e.fits for _, e in contacts):
            named = f"The model {best[0].title}".replace("The model power-law", "The power law")
            return f"None of these laws of contact fits the data. {named} fits, but it is not a law of contact."
        first = next(fit for fit in judged if fit[1].fits)
        if best[1] is not first[1]:
            return (
                f"The simplest model that the data do not reject is {best[0].title}; "
                f"{first[0].title} has the least AIC, but by less than 2."
            )
        return f"Of the models that fit, {best[0].title} has the least AIC."

    def _data_remark(self, group: Group) -> str:
        flights = group.comparison.fits[0][1].problem.at(finite_theta(group.comparison.fits[0][1]))
        source = {"Points": "", "Times": " from times of bounces"}.get(type(self.data.record).__name__, " from heights")
        numbers = "times" if isinstance(self.data.record, Times) else "heights"
        if group.sample.has_sigma:
            errors = "weights 1/eps_sigma^2" if group.sample.is_points else "the given errors of the heights"
        elif group.sample.is_points:
            errors = "no eps_sigma: all weights are equal, and sigma follows from the scatter"
        else:
            errors = f"the scatter gives the errors of the {numbers}"
        if not group.sample.has_sigma and min(e.rms for _, e in group.comparison.fits) < NO_SCATTER:
            column = {"Points": "eps_sigma", "Times": ""}.get(type(self.data.record).__name__, "h1_sigma_cm")
            errors = "without scatter nothing can be judged" + (
                f"; give a column of errors, {column}" if column else ""
            )
        return (
            f"{group.sample.size} points{source}: {flights.speed.min():.4g} to {flights.speed.max():.4g} m/s, "
            f"eps {flights.eps.min():.4g} to {flights.eps.max():.4g}; {errors}."
        )

    def _air_remark(self) -> str:
        field = self.setup.field
        if field.kappa == 0 or isinstance(self.data.record, Points):
            return ""
        known = "" if math.isnan(field.to_coefficient) else f", C_d = {field.kappa * field.to_coefficient:.3g}"
        return f"Air: terminal speed {field.kappa**-0.5:.4g} m/s{known}; eps excludes the losses in flight."

    def _outlier_remarks(self, group: Group) -> List[str]:
        word = self.data.row_word.capitalize()
        quantity = {"Times": ("time", "late", "early"), "Apexes": ("height", "high", "low")}
        name, above, below = quantity.get(type(self.data.record).__name__, ("eps", "high", "low"))
        made = [
            f"{word} {o.line} is an outlier: its {name} is {abs(o.distance):.1f} sigma too "
            f"{above if o.distance > 0 else below}."
            for o in group.outliers
        ]
        if group.without_outliers and group.without_outliers.fits:
            model, e = group.without_outliers.fits[0]
            values = ", ".join(
                f"{name} = {n[0]:.6g} (95 %: {n[3]:.6g} to {n[4]:.6g})" for name, n in self.parameters_of(model, e)
            )
            which = "it" if len(group.outliers) == 1 else f"these {word.lower()}s"
            end = "" if self.setup.robust else " --robust gives outliers little weight."
            made.append(
                f"Without {which} {model.title} has the least AIC ({_judgement(e)}, {_p_text(e)}): {values}.{end}"
            )
        return made

    def remarks(self, group: str = "") -> List[str]:
        """Return a description of the data and a verdict on each model, as lines for a reader."""
        mine = self.groups[group]
        fits, lines = mine.comparison.fits, [self._data_remark(mine)]
        if self.data.unused:
            lines.append(f"Columns that are not read: {', '.join(self.data.unused)}.")
        lines += [*self.data.remarks, *filter(None, [self._air_remark()])]
        if mine.sample.size > MANY:
            lines.append(f"More than {MANY} bounces: lines are not searched for outliers.")
        if self.setup.robust:
            lines.append(f"Robust: Huber's function, linear beyond {HUBER} sigma.")
        if mine.comparison.too_many_parameters:
            count = mine.comparison.too_many_parameters
            verb = " is" if count == 1 else "s are"
            lines.append(f"{count} model{verb} left out: more points than parameters are needed.")
        model, e = fits[0]
        if mine.sample.scatters:
            name, unit = ("time", "s") if mine.sample.is_times else ("height", "m")
            lines.append(
                f"sigma is {e.sigma[0]:.2g} {unit} for a {name}, and {e.sigma[1]:.2g} for eps at a bounce, "
                f"from the residuals of {model.title}."
            )
        flat = [m.title for m, other in fits if not all(other.determined)]
        if flat:
            lines.append(f"Not determined, because the minimum is flat: parameters of {', '.join(flat)}.")
        lines += self._outlier_remarks(mine)
        kind = "a chi2" if e.p_of_chi2 else "means of neighbouring residuals"
        lines.append(
            f"p: probability of {kind} this large if the model is right; below {SIGNIFICANCE} it does not fit."
        )
        named: Dict[str, List[str]] = {}
        for m, _ in fits:
            named.setdefault(m.curve.name, []).append(m.title)
        for curve, titles in named.items():
            of = next(other for m, other in fits if m.curve.name == curve)
            lines.append(f"  {_judgement(of):<12} {_p_text(of):<13} {', '.join(titles)}")
        return [*lines, self.verdict(group)]

    # ---- predictions ----

    def _region(self, model: Model, e: Estimate, group: str) -> List[List[Floats]]:
        """For each level, return boundary points of a region of theta. Its projections are the intervals of theta."""
        key = (group, id(e))
        if key in self._regions:
            return list(self._regions[key])
        p, theta, count = e.problem, finite_theta(e), len(model.curve.kinds)
        state = p.scale, p.log_ratio
        covariance = covariance_of(p, theta)[:count, :count]
        values, axes = np.linalg.eigh((covariance + covariance.T) / 2)
        directions = [*(axes * np.sqrt(np.maximum(values, 0))).T]
        if count > 1:  # directions in which eps at one of these speeds changes most
            least, most = (math.log(end) for end in (p.at(theta).speed.min(), p.at(theta).speed.max()))
            speeds, steps = np.linspace(least - 1, most + 1, 12), 1e-3 * np.sqrt(np.diag(covariance))
            shifts = [h * way for h, way in zip(steps, np.eye(count))]
            curve = model.curve.eps(theta[:count], speeds)
            slopes = np.array([(model.curve.eps(theta[:count] + d, speeds) - curve) / d.max() for d in shifts])
            most_changing = covariance @ slopes / np.sqrt(np.einsum("ji,jk,ki->i", slopes, covariance, slopes))
            directions += [way for way in most_changing.T if np.all(np.isfinite(way))]
        directions += [-way for way in directions]
        unit = unit_of(p, theta, e.minimum)
        regions: List[List[Floats]] = []
        for level in LEVELS:
            target, made = quantile(p, level) * math.sqrt(unit), []
            for direction in directions if target > 0 else []:

                def height(step: float) -> float:
                    p.scale, p.log_ratio = state
                    place = theta.copy()
                    place[:count] = np.clip(theta[:count] + step * direction, p.low[:count], p.high[:count])
                    q = profile(p, place, range(count))[0]
                    return min(math.sqrt(max(q - e.minimum, 0)), 1e150) - target

                step = 1.1 * target
                while height(step) < 0 and step < 64 * target:
                    step *= 2
                step = scipy("optimize").brentq(height, 0, step, xtol=1e-4 * step) if height(step) > 0 else step
                made.append(np.clip(theta[:count] + step * direction, p.low[:count], p.high[:count]))
            regions.append(made)
        p.scale, p.log_ratio = state
        self._regions[key] = regions
        return regions

    def predict(
        self, speed_m_s: Any, model: Optional[str] = None, *, end: Optional[str] = None, group: str = ""
    ) -> Any:
        """Return eps at impact speeds, m/s, with its intervals: a record array with the fields speed_m_s, eps, low_68,
        high_68, low_95, high_95. The intervals include the uncertainty of all parameters. model: as in find."""
        chosen, e = self.find(model, end, group)
        speed = np.asarray(speed_m_s, np.float64)
        if not np.all((speed > 0) & np.isfinite(speed)):
            raise ValueError("speed_m_s: a speed is not above 0 and finite")
        names = ("speed_m_s", "eps", "low_68", "high_68", "low_95", "high_95")
        made = np.zeros(speed.shape, [(name, np.float64) for name in names])
        x = np.log(np.atleast_1d(speed)).ravel()
        with np.errstate(all="ignore"):
            eps = chosen.curve.eps(finite_theta(e), x)
            made["speed_m_s"], made["eps"] = speed, eps.reshape(speed.shape)
            for name, places in zip(("68", "95"), self._region(chosen, e, group)):
                all_eps = np.array([eps, *(chosen.curve.eps(place, x) for place in places)])
                made[f"low_{name}"] = all_eps.min(axis=0).reshape(speed.shape)
                made[f"high_{name}"] = all_eps.max(axis=0).reshape(speed.shape)
        return made.view(np.recarray)[()]

    # ---- commands and pictures ----

    def command(self, model: Optional[str] = None, *, end: Optional[str] = None, group: str = "") -> Optional[str]:
        """Return the corgen embed command that writes eps of the fit as a header; None if no such command exists.

        Its fitted numbers have 6 digits, which changes eps by at most 2e-6; further digits depend on the machine."""
        chosen, e = self.find(model, end, group)
        p = e.problem
        if not all(e.determined) or not np.all(np.isfinite(e.theta)):
            return None
        given = self._bodies.given
        known = self._bodies.known and all(map(math.isfinite, given.values()))
        value, second = ([numbers[0] for _, numbers in self.parameters_of(chosen, e)] + [0.0])[:2]
        at_1 = math.exp(min(e.theta[0], 700.0))
        words = {
            "viscoelastic": f"--dissipation-time {value:.6g}" if known else f"--g-star {value:.6g}",
            "linear": f"--law linear --zeta {value:.6g}",
            "tsuji": f"--law tsuji --zeta {value:.6g}",
            "hunt-crossley": f"--law hunt-crossley --beta {at_1:.6g} --at 1",
            "hertz-dashpot": f"--law hertz-dashpot --beta {at_1:.6g} --at 1",
            "power-law": f"--law power-law --coefficient {value:.6g} --exponent {-second:.6g}",  # min(1, A v^-B)
            "exponential": f"--law exponential --eps-inf {value:.6g} --decay-speed {second:.6g}",
        }
        if chosen.name == "plate":
            star = next(m for m in choose("viscoelastic", "zero-overlap"))
            words["plate"] = f"--g-star {star.plain[0].value(e.theta[0]):.6g}"
        if chosen.name == "elastic-plastic":
            eps = float(chosen.curve.eps(e.theta, np.log([2 * at_1]))[0])
            words["elastic-plastic"] = f"--law elastic-plastic --restitution {eps:.6g} --at {2 * at_1:.6g}"
        if chosen.name not in words:
            return None
        line = ["corgen embed", words[chosen.name]]
        if chosen.name == "viscoelastic" and known:
            used = [name for name in given if not (self._bodies.wall and name in ("radius_2", "density_2", "mass_2"))]
            line += [f"--{name.replace('_', '-')} {given[name]:.10g}" for name in used]
            line += ["--wall"] if self._bodies.wall else []
        line += [f"--end {chosen.end}"] if chosen.end != "both" else []
        speed = p.at(finite_theta(e)).speed
        low, high = speed.min(), max(speed.max(), 1.001 * speed.min())
        if chosen.name == "power-law" and second > 0:  # the range ends where the rising eps is 1
            high = min(high, 0.999 * math.exp(min(-e.theta[0] / second, 700.0)))
        return " ".join([*line, f"--speed-min {low:.6g} --speed-max {high:.6g} --tolerance 1e-6"])

    def plot(self, file: Optional[str] = None, *, group: str = "", all: bool = False) -> Any:
        """Return a figure of Matplotlib: data with errors, the best model and its band, and residuals. all: also
        draw the other models. file: also write the figure, as .pdf, .png or .svg."""
        from .plot import draw, format_of, save

        form = format_of(str(file)) if file is not None else ""
        figure = draw(self, group, all)
        if file is not None:
            save(figure, file, form)
        return figure


# ---- the call ----


def fit(
    source: Any,
    *,
    law: Any = "all",
    end: Optional[str] = None,
    robust: bool = False,
    gravity: float = GRAVITY_M_S2,
    fit_gravity: bool = False,
    drag_coefficient: Optional[float] = None,
    terminal_speed: Optional[float] = None,
    fit_drag: bool = False,
    diameter: Optional[float] = None,
    air_density: float = 1.204,
    unit: Optional[str] = None,
    separator: Optional[str] = None,
    decimal_comma: bool = False,
    drop_height: Optional[float] = None,
    wall: bool = False,
    viscosity_liquid: Optional[float] = None,
    progress: Optional[Progress] = None,
    **bodies: float,
) -> Result:
    """Fit models of restitution to measured bounces, rank them by AIC and judge them. Units are SI. Needs SciPy.

    source: a path, an open file, a data frame, or a mapping of arrays with the columns of cor fit (docs/fit.md).
    unit, separator, decimal_comma, drop_height: how to read the source; see the options of cor fit.
    law: "all", names such as "viscoelastic,power-law", or a list of names and functions eps(speed, a=0.9, b=0.1), whose
    defaults are the start of the search. end: "zero-overlap" or "zero-force"; default: both. robust: True limits the
    influence of outliers by Huber's function. fit_gravity: True also fits gravity, from drops of known height.
    Drag of the air: drag_coefficient with mass and diameter, or terminal_speed, or fit_drag=True.
    wall, young, poisson, radius, density, mass, young_2, ...: the bodies, for parameters such as the dissipation time.
    viscosity_liquid: of the model "stokes". progress: a function; its arguments are a name, the steps done, all steps.
    """
    from .records import read

    given = {name: float(value) for name, value in bodies.items()}
    made = Bodies(given, wall, viscosity_liquid)
    models = choose(law, end)
    if separator not in SEPARATORS:
        raise ValueError(f"separator: {separator!r} is not a separator; allowed: comma, semicolon, tab")
    numbers = dict(gravity=gravity, mass=given.get("mass"), diameter=diameter, drop_height=drop_height)
    air = dict(drag_coefficient=drag_coefficient, terminal_speed=terminal_speed, air_density=air_density)
    for name, value in dict(**numbers, **air, viscosity_liquid=viscosity_liquid).items():
        if value is not None and not 0 < number(name, value) < math.inf:
            raise ValueError(f"{name}: {value} is not above 0 and finite")
    ball = given if diameter is None else {**given, "diameter": diameter}
    drag = {"drag_coefficient": drag_coefficient, "terminal_speed": terminal_speed, "fit_drag": fit_drag}
    field, tell = Field.of(gravity, ball, air_density, **drag), progress or (lambda *_: None)
    form = Form(unit=unit, separator=SEPARATORS[separator], decimal_comma=decimal_comma, drop_height_m=drop_height)
    data = source if isinstance(source, Data) else read(source, form, lambda step: tell(step, 0, 0))
    free = tuple(name for name, chosen in (("drag", fit_drag), ("gravity", fit_gravity)) if chosen)
    if free and isinstance(data.record, Points):
        raise ValueError(f"fit_{free[0]}: {data.name} contains speeds; allowed: only for times of bounces, or heights")
    setup = Setup(field, free, robust)
    groups: Dict[str, Group] = {}
    with np.errstate(all="ignore"):
        for name in ("", *data.balls):
            mine = data.of_ball(data.balls.index(name)) if name else data
            sample = Sample(mine)
            comparison = compare(sample, models, setup, tell)
            if not comparison.fits and not name:
                least = min(len(model.curve.kinds) for model in models) + len(free) + 1
                count = f"{data.name} has {sample.size} point{'s' * (sample.size != 1)} of speed and eps"
                if sample.size == 1:
                    one = sample.flights(field.gravity, field.kappa)
                    count += f" (eps = {one.eps[0]:.6g} at {one.speed[0]:.4g} m/s)"
                raise DataError(f"{count}; allowed: {least} or more for these models; add bounces")
            if not comparison.fits:
                continue
            group = Group(name, sample, comparison, find_outliers(mine, sample, models, setup, tell))
            if group.outliers:
                rest = Sample(mine, [o.line for o in group.outliers])
                group.without_outliers = compare(rest, models, setup, tell)
            groups[name] = group
    return Result(data, setup, made, groups)


__all__ = ["BODIES", "Group", "Result", "fit"]
