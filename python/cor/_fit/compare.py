# SPDX-License-Identifier: MIT
"""Fits several models to the same data, ranks them by AIC, judges them, and names outliers.

A curve is judged by its p value. With given errors p is the tail of chi^2 with n - k degrees of freedom. Without
given errors, and in the robust fit (with psi(z) instead of z), p is the tail of Fisher's F. The data form m = n/3
groups of neighbours in speed, with m between k + 1 and 12. F is

    [sum over groups n_j mean_j^2/(m - k)]/[sum (z_i - mean_j)^2/(n - m)]
"""

import math
from dataclasses import dataclass, field, replace
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .data import Data, Floats, Ints
from .intervals import covariance_of, find_intervals, minimise_with_noise
from .likelihood import HUBER, LEAST_RESIDUAL, MANY, Field, Problem, Reduced, Sample, scipy
from .models import POWER_LAW, Curve, Model

SIGNIFICANCE = 0.01  # a curve with a smaller p value does not fit
REACH = 67  # this number of bounces after a time suffices to estimate its error
MAX_OUTLIERS = 8
NO_SCATTER = 1e-12  # smaller residuals of eps are rounding, not errors
NEAR = 2.0  # models whose AIC differs by less are equally good


@dataclass
class Estimate:
    """The fit of one curve."""

    problem: Problem
    theta: Floats
    minimum: float  # Q
    scale: float  # s, for times and heights times (det W/det B)^(1/(2 n)) (module likelihood); nan if errors are given
    intervals: Any = None  # [coordinate, level, side], infinite beyond the range of theta
    determined: Tuple[bool, ...] = ()  # False: the minimum is flat
    rms: float = math.nan
    chi2: float = math.nan
    p_value: float = math.nan
    p_of_chi2: bool = False
    sigma: Tuple[float, float] = (math.nan, math.nan)  # sigma of a time or height, and sigma of the scatter of eps
    aic: float = math.nan

    @property
    def fits(self) -> bool:
        return not self.p_value < SIGNIFICANCE

    @property
    def parameters(self) -> int:
        return self.problem.parameters


class Setup(NamedTuple):
    """The settings of all fits of a call."""

    field: Field
    free: Tuple[str, ...]
    robust: bool


def estimate(
    curve: Curve, sample: Sample, setup: Setup, whole: bool = True, near: Optional[Estimate] = None
) -> Optional[Estimate]:
    """Fit a curve; None with too few points. whole: also intervals and p value. near: a fit of nearly the same data"""
    parameters = len(curve.kinds) + len(setup.free)
    if sample.size <= parameters:
        return None
    p = Problem(curve, sample, setup.field, setup.free, setup.robust)
    if sample.size > MANY and not setup.free and not setup.robust:
        p = Reduced(curve, sample, setup.field, None if sample.is_points else _pilot(sample, setup))
    if near and p.scatters and near.problem.robust == p.robust:
        p.scale, p.log_ratio = near.problem.scale, near.problem.log_ratio
        theta = minimise_with_noise(p, finite_theta(near))
    else:
        theta = minimise_with_noise(p)
    scale = p.scale if setup.robust and not sample.has_sigma else math.nan
    if whole:
        theta, minimum, intervals = find_intervals(p, theta)
        e = Estimate(p, theta, minimum, scale, intervals)
    else:
        e = Estimate(p, theta, p.objective(theta), scale)
    if not sample.has_sigma and not setup.robust:
        e.scale = math.sqrt(e.minimum / p.freedom)
    if whole:
        _set_limits(e)
    _judge(e)
    return e


def _pilot(sample: Sample, setup: Setup) -> Tuple[Problem, Floats]:
    """Fit the power law, as an approximation of any curve, to at most 2000 of the bounces."""
    if sample.pilot is None:
        drop = np.cumsum(sample.begins) - 1
        chosen = drop % max(1, sample.size // 1000) == 0
        p = Problem(POWER_LAW, sample.part(chosen & (np.cumsum(chosen) <= 2000)), setup.field, (), False)
        sample.pilot = p, minimise_with_noise(p)
    made: Tuple[Problem, Floats] = sample.pilot
    return made


def _set_limits(e: Estimate) -> None:
    """If a logarithm is at an end of its range, set it and the interval's end there to -inf or inf. A coordinate whose
    68 % interval is the whole range is not determined."""
    p = e.problem
    determined = []
    for j, kind in enumerate(p.kinds):
        low, high = (p.low[j], p.high[j]) if kind == "unit" else (-math.inf, math.inf)
        low = 0.0 if kind == "positive" else low
        determined.append(not (e.intervals[j, 0, 0] <= low and e.intervals[j, 0, 1] >= high))
        if kind == "log":
            for end, infinity in ((p.low[j], -math.inf), (p.high[j], math.inf)):
                if abs(e.theta[j] - end) < 1e-6:
                    e.theta[j] = infinity
                    near = np.abs(e.intervals[j] - end) < 1e-6
                    e.intervals[j] = np.where(near, infinity, e.intervals[j])
                    e.intervals[j, :, 0 if infinity < 0 else 1] = infinity
    if not all(determined) and len(determined) > 1:  # coordinates tied to an undetermined one are undetermined
        covariance = covariance_of(p, finite_theta(e))
        size = np.sqrt(np.diag(covariance))
        tied = np.abs(covariance / np.outer(size, size)) > 1 - 1e-6
        determined = [bool(own and not np.any(tied[j] & ~np.array(determined))) for j, own in enumerate(determined)]
    e.determined = tuple(determined)


def finite_theta(e: Estimate) -> Floats:
    return np.clip(e.theta, e.problem.low, e.problem.high)


def groups_p_value(r: Floats, parameters: int) -> float:
    n = r.size
    if n < 2 * (parameters + 1):
        return math.nan
    groups = max(min(n // 3, 12), parameters + 1)
    parts = [r[j * n // groups : (j + 1) * n // groups] for j in range(groups)]
    between = sum(part.size * part.mean() ** 2 for part in parts)
    within = sum(((part - part.mean()) ** 2).sum() for part in parts)
    if not within > n * NO_SCATTER**2:
        return math.nan
    ratio = between / (groups - parameters) / (within / (n - groups))
    return float(scipy("special").fdtrc(groups - parameters, n - groups, ratio))


def _judge(e: Estimate) -> None:
    p, sample = e.problem, e.problem.sample
    theta = finite_theta(e)
    r = p.eps_residual(theta)
    e.rms = math.sqrt(r @ r / p.size)
    if sample.has_sigma:
        plain = Problem(p.curve, sample, p.field, p.free, False)
        e.chi2 = plain.objective(theta)
        e.p_of_chi2 = not p.robust
    if sample.scatters:
        e.sigma = p.time_sigma(theta, e.scale)
    if e.p_of_chi2:
        e.p_value = float(scipy("special").chdtrc(p.freedom, e.chi2))
        return
    z = p.z(theta)
    z = np.clip(z, -HUBER, HUBER) if p.robust else z
    e.p_value = groups_p_value(z[p.at(theta).order], p.parameters)


# ---- ranks ----


@dataclass
class Comparison:
    """The fits of the models, the least AIC first. Fits with equal AIC are in the order of the models."""

    fits: List[Tuple[Model, Estimate]] = field(default_factory=list)
    too_many_parameters: int = 0  # models omitted because the points are too few

    def best(self) -> Optional[Tuple[Model, Estimate]]:
        """Of the models that fit, return the simplest one whose AIC is within NEAR of the least."""
        fitting = [fit for fit in self.fits if not math.isnan(fit[1].p_value) and fit[1].fits]
        near = [fit for fit in fitting if fit[1].aic < fitting[0][1].aic + NEAR]
        return min(near, key=lambda fit: fit[1].parameters) if near else None


def compare(
    sample: Sample, models: Sequence[Model], setup: Setup, progress: Callable[[str, int, int], None], whole: bool = True
) -> Comparison:
    estimates: Dict[str, Optional[Estimate]] = {}
    for i, model in enumerate(models):
        if model.curve.name not in estimates:
            progress("fitting", i, len(models))
            estimates[model.curve.name] = estimate(model.curve, sample, setup, whole)
    made = [e for e in estimates.values() if e]
    for e in made:
        p, n = e.problem, sample.size
        if not sample.has_sigma and not setup.robust:
            scale = max(e.scale * math.sqrt(p.freedom / n), LEAST_RESIDUAL)
            e.aic = 2 * n * math.log(scale) + 2 * (p.parameters + 1)
            continue
        state = p.scale, p.log_ratio
        if not sample.has_sigma:
            best = min(made, key=lambda other: other.scale).problem
            p.scale, p.log_ratio = best.scale, best.log_ratio
        e.aic = p.objective(finite_theta(e)) + 2 * p.parameters
        p.scale, p.log_ratio = state
    found = [(model, estimates[model.curve.name]) for model in models]
    fits = [(model, e) for model, e in found if e]
    fits.sort(key=lambda fit: fit[1].aic)
    return Comparison(fits, len(found) - len(fits))


# ---- outliers ----


class Outlier(NamedTuple):
    line: int
    distance: float  # in sigma of the errors without outliers; positive if eps is too large or a time is late


def distances(e: Estimate) -> Tuple[Ints, Floats]:
    """Return the lines and their distances from the curve in standard deviations. The distance of a point is
    (eps - eps(v))/s. The error of a time or a height is estimated from the bounces that it affects. Its distance is
    this estimate divided by the standard deviation of the estimate."""
    p, sample, n = e.problem, e.problem.sample, e.problem.size
    theta = finite_theta(e)
    if not sample.is_chain:
        return sample.lines[:, 2], p.z(theta) / (1 if sample.has_sigma or p.robust else e.scale)
    y, weight, a = p.parts(theta)
    ratio = [math.exp(p.log_ratio) / p.mean_square if sample.scatters else 0.0]
    z = p.whiten((y, weight, a), ratio)[1][0]
    direct = np.stack([a, -(1 + a) if sample.is_times else -a, np.ones(n)])
    numbers = np.stack([sample.first, sample.middle, sample.last])
    drop, start = np.cumsum(sample.begins) - 1, np.flatnonzero(sample.begins)
    place = np.where(numbers < 0, -1, numbers - np.where(numbers[0] < 0, numbers[1], numbers[0])[start][drop])
    known, at = np.unique(numbers, return_index=True)
    known, at = known[known >= 0], at[known >= 0]
    groups = int(place.max()) // REACH + 1  # groups in a drop: bounces REACH apart do not affect each other
    found = np.empty(known.size)
    for colour in range(min(REACH, int(place.max()) + 1)):
        use = (place >= 0) & (place % REACH == colour)
        w = p.whiten((np.where(use, direct, 0).sum(axis=0), weight, a), ratio)[1][0]
        after = place[2] >= colour
        group = (drop * groups + (place[2] - colour) // REACH)[after]
        product, square = (np.bincount(group, part[after]) for part in (w * z, w * w))
        mine = use.ravel()[at]
        group = drop[at[mine] % n] * groups + (place.ravel()[at[mine]] - colour) // REACH
        found[mine] = product[group] / np.sqrt(square[group])
    return sample.record.line[known], found / (1 if sample.has_sigma else e.sigma[0])


def _distance_of(e: Estimate, line: int) -> float:
    lines, found = distances(e)
    mine = found[lines == line]
    return float(mine[np.argmax(np.abs(mine))]) if mine.size else 0.0  # 0: each bounce needs another omitted line


def _squares(e: Estimate) -> float:
    return e.chi2 if e.problem.sample.has_sigma else e.scale**2 * e.problem.freedom


def find_outliers(data: Data, sample: Sample, models: Sequence[Model], setup: Setup, progress: Any) -> List[Outlier]:
    """Return the lines that are too far from the curve of the robust fit with the least AIC.

    The farthest line is removed while n normal errors would reach its distance with a probability below 1/20, up to
    MAX_OUTLIERS lines and a fourth of the points. The probability of a removed line is the tail of Student's t, or of
    the normal distribution if errors are given, times the number of lines. While it is SIGNIFICANCE or more for some
    removed lines, the nearest of them is restored. Errors that are too small for the other points are first scaled to
    chi^2 = n - k."""
    if sample.size > MANY:
        return []
    special = scipy("special")
    robust, plain = setup._replace(robust=True), setup._replace(robust=False)
    ranked = compare(sample, models, robust, progress, False).fits
    if not ranked:
        return []
    curve = ranked[0][0].curve
    left_out: List[Outlier] = []

    def rest(*, put_back: int = -1) -> Sample:
        return Sample(data, [o.line for o in left_out if o.line != put_back])

    e: Optional[Estimate] = None
    while len(left_out) < MAX_OUTLIERS:
        here = rest()
        e = estimate(curve, here, robust, False, e)
        if e is None:
            break
        lines, found = distances(e)
        if np.isnan(found).all():  # a user's function returned only nan
            break
        k = int(np.nanargmax(np.abs(found)))
        if here.size * special.erfc(abs(found[k]) / math.sqrt(2)) > 0.05:
            break
        left_out.append(Outlier(int(lines[k]), float(found[k])))
        if rest().size < 3 * sample.size // 4:  # too many points are removed: restore the last line
            left_out.pop()
            break
    count = sample.numbers
    while left_out:
        progress("outliers", 0, 0)
        e = estimate(curve, rest(), plain, False, e)
        if e is None or (not sample.has_sigma and e.scale < NO_SCATTER):
            return []
        spread = max(math.sqrt(e.chi2 / e.problem.freedom), 1.0) if sample.has_sigma else 1.0
        insignificant = []
        for i, outlier in enumerate(left_out):
            f = estimate(curve, rest(put_back=outlier.line), plain, False, e)
            assert f is not None
            distance = _distance_of(replace(e, problem=_on(e.problem, f.problem.sample)), outlier.line)
            if sample.is_chain:  # use the smaller distance: from e, fitted without these bounces, or from f
                other = _distance_of(f, outlier.line)
                other *= math.sqrt((f.problem.freedom - 1) / max(f.problem.freedom - other**2, 1e-9))
                distance = other if abs(other) < abs(distance) else distance
            else:
                change = math.sqrt(max(_squares(f) - _squares(e), 0)) / (1 if sample.has_sigma else e.scale)
                distance = math.copysign(change, distance)
            left_out[i] = outlier._replace(distance=distance)
            t = abs(distance / spread)
            normal = sample.has_sigma and not spread > 1
            tail = special.erfc(t / math.sqrt(2)) if normal else special.fdtrc(1, e.problem.freedom, t * t)
            if count * tail >= SIGNIFICANCE:
                insignificant.append(left_out[i])
        if not insignificant:
            break
        left_out.remove(min(insignificant, key=lambda o: abs(o.distance)))
    return sorted(left_out)


def _on(p: Problem, sample: Sample) -> Problem:
    """Return the same problem, with its curve and noise, for other bounces."""
    made = Problem(p.curve, sample, p.field, p.free, p.robust)
    made.scale, made.log_ratio = p.scale, p.log_ratio + math.log(made.mean_square / p.mean_square)
    return made
