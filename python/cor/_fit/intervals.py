# SPDX-License-Identifier: MIT
"""Finds the least Q of a curve, and profile-likelihood intervals of its coordinates.

In the interval of a coordinate, the least Q over the others exceeds the minimum by at most a threshold. The
threshold is z^2 if errors are given, otherwise t^2 s^2, with Student's t of n - k degrees of freedom. In the robust
fit it is multiplied by Huber's factor [sum psi^2/(n - k)]/[sum psi'/n]. The search for an end of the 95 %
interval starts at the end of the 68 % interval, so the 95 % interval contains the 68 % interval.
"""

import math
from typing import Any, Callable, Iterable, List, Optional, Sequence, Tuple

import numpy as np

from .data import Floats
from .likelihood import HUBER, Problem, scipy
from .models import CONSTANT

LEVELS = (0.6826894921370859, 0.95)
DRAG_STARTS = (0.0, 0.01, 0.1)


class _Lower(Exception):
    """A profile found a lower minimum at theta."""

    def __init__(self, theta: Floats) -> None:
        self.theta = theta


# ---- the minimum ----


def least_squares(p: Problem, theta: Floats, free: Sequence[int]) -> Tuple[Floats, float]:
    """Minimise Q over the free coordinates from theta by MINPACK's Levenberg-Marquardt method. A coordinate that leaves
    its range is fixed at the end of the range."""
    theta, free = theta.copy(), list(free)
    while free:

        def residuals(part: Floats) -> Any:
            theta[free] = part
            made = p.residuals(theta)
            return made if np.isfinite(made @ made) else np.full(p.size, 1e150)

        theta[free] = scipy("optimize").leastsq(
            residuals, theta[free], ftol=1e-14, xtol=1e-14, maxfev=200 * (len(free) + 1), full_output=True
        )[0]
        for j in free:
            theta[j] = abs(theta[j]) if p.kinds[j] == "positive" else theta[j]
        outside = [j for j in free if not p.low[j] <= theta[j] <= p.high[j]]
        theta = np.minimum(np.maximum(np.where(np.isfinite(theta), theta, p.low), p.low), p.high)
        free = [j for j in free if j not in outside] if outside else []
    return theta, p.objective(theta)


def _best(p: Problem, starts: Iterable[Any]) -> Tuple[Floats, float]:
    """Return the best of the starts and of the minima that follow from them."""
    best, least = np.clip(np.zeros(p.parameters), p.low, p.high), math.inf
    for start in starts:
        at = np.asarray(start, np.float64)
        for theta, q in ((at, p.objective(at)), least_squares(p, at, range(p.parameters))):
            if q < least:
                best, least = theta, q
    return best, least


def _coarse(p: Problem, most: int, extra: Sequence[float]) -> Tuple[Floats, Callable[..., Any]]:
    """Return ln v of at most `most` bounces, and their Q(*theta) without covariance. theta: numbers or columns"""
    curves = len(p.curve.kinds)
    flights = p.at(np.array([*([0.0] * curves), *extra]))
    order = flights.order[:: max(1, -(-p.size // most))]
    x, eps, spread = flights.log_speed[order], flights.eps[order], p.spread(flights) * np.ones(p.size)
    spread = spread[order] * (p.scale if p.sample.is_points else 1)
    robust = p.robust and not p.plain and not p.scatters

    def q(*theta: Any) -> Any:
        z = np.abs(eps - p.curve.eps(theta, x)) / spread
        square = np.where(z <= HUBER, z * z, HUBER * (2 * z - HUBER)) if robust else z * z
        return np.where(np.isfinite(square), square, math.inf).sum(axis=-1)

    return x, q


def _starts(p: Problem, extra: Sequence[float]) -> List[List[float]]:
    curve, low, high = p.curve, p.low, p.high
    if curve.start == "given":
        return [list(curve.given)]
    if curve.start == "lines":
        return _lines(p, extra)
    if curve.start == "scan":
        _, q = _coarse(p, 1000, extra)
        at = np.linspace(low[0], high[0], 401)
        value = q(at[:, None])
        padded = np.concatenate(([math.inf], value, [math.inf]))
        lowest = np.flatnonzero((value <= padded[:-2]) & (value <= padded[2:]) & (value < math.inf))
        return [[at[i]] for i in lowest[np.argsort(value[lowest], kind="stable")][:3]]
    assert curve.dry is not None
    first = float(minimise(p.like(curve.dry))[0][0])
    if curve.kinds[0] == "log":
        low0, high0 = max(low[0], first - 4), min(high[0], first + 0.5)
    else:
        low0, high0 = low[0], high[0]
    _, q = _coarse(p, 250, extra)
    rows, columns = np.linspace(low0, high0, 61), np.linspace(low[1], high[1], 76)[:75]
    values = np.array([q(rows[:, None], column) for column in columns])
    found = []
    for part in range(3):
        k, i = np.unravel_index(int(np.argmin(values[25 * part : 25 * part + 25])), (25, 61))
        found.append([rows[i], columns[25 * part + k]])
    return [*found, [first, low[1]]]


def _lines(p: Problem, extra: Sequence[float]) -> List[List[float]]:
    """Return starts. For a constant: the weighted mean. For others: a line through ln eps in ln v, and the mean."""
    flights = p.at(np.array([*([0.0] * len(p.curve.kinds)), *extra]))
    eps, weight = flights.eps, (p.spread(flights) * np.ones(p.size)) ** -2
    if p.curve is CONSTANT:
        return [[float(np.clip((weight @ eps) / weight.sum(), 0, 1))]]
    use = eps > 0
    if not use.any():
        return [[-1.0, 0.0]]
    x, y, w = flights.log_speed[use], np.log(eps[use]), weight[use] * eps[use] ** 2
    total, sx, sy = w.sum(), w @ x, w @ y
    spread = total * (w @ (x * x)) - sx * sx
    slope = (total * (w @ (x * y)) - sx * sy) / spread if spread > 1e-12 * total * (w @ (x * x)) else 0.0
    return [[(sy - slope * sx) / total, slope], [sy / total, 0.0]]


def minimise(p: Problem) -> Tuple[Floats, float]:
    """Return the minimum at the present scale and lambda."""
    drags = DRAG_STARTS if "drag" in p.free else (0.0,)
    extras = [[drag if name == "drag" else 0.0 for name in p.free] for drag in drags]
    return _best(p, ([*start, *extra] for extra in extras for start in _starts(p, extra)))


def settle(p: Problem, theta: Floats) -> Floats:
    """Update theta and the noise in turn until the scale is constant."""
    for _ in range(40):
        before = p.scale
        if not p.robust:
            p.scale = 1.0
        theta, _ = _best(p, [theta])
        p.set_noise(theta)
        if abs(p.scale - before) <= (1e-9 if p.robust else 1e-13) * p.scale:
            break
    return theta


def minimise_with_noise(p: Problem, near: Optional[Floats] = None) -> Floats:
    """Return the minimum over theta and, for unknown errors, over lambda. Set the scale (1 unless robust) and lambda.
    near: theta of a fit to data that differ by a few bounces; p has the scale and lambda of that fit."""
    if near is not None:
        theta = settle(p, near)
        p.scale = p.scale if p.robust else 1.0
        return theta
    p.plain = True
    theta, _ = minimise(p)
    p.plain = False
    if not p.robust and (p.sample.is_points or not (p.scatters or p.sample.has_sigma)):
        return theta  # z is unchanged
    if p.sample.has_sigma:
        return minimise(p)[0]
    p.set_noise(theta)
    first, theta = theta, settle(p, theta)
    best = (p.scale, p.log_ratio, theta)
    if p.scatters and not p.robust:
        starts = [(first, -80.0), (first, math.log(1e8))]  # first: no scatter; second: no errors of times
        if p.curve.dry:
            dry = p.like(p.curve.dry)
            without = minimise_with_noise(dry)
            starts.append((np.array([without[0], p.low[1], *without[1:]]), dry.log_ratio))
        for start, log_ratio in starts:
            p.log_ratio = log_ratio
            theta = settle(p, start)
            if p.scale < best[0]:
                best = (p.scale, p.log_ratio, theta)
    p.scale, p.log_ratio, theta = best
    if not p.robust:
        p.scale = 1.0
    again, q = minimise(p)
    return again if q < p.objective(theta) else theta


# ---- intervals ----


def whole_q(p: Problem, theta: Floats) -> float:
    """Return the least Q over lambda, and set lambda."""
    if not p.scatters or p.robust:
        return p.objective(theta)
    p.set_noise(theta)
    q, p.scale = p.scale**2 * p.freedom, 1.0
    return q


def profile(p: Problem, theta: Floats, held: Sequence[int]) -> Tuple[float, Floats]:
    """Return the least Q with the held coordinates fixed at their values in theta, and the theta that has this Q."""
    free = [j for j in range(p.parameters) if j not in held]
    q = math.inf
    while True:
        before = q
        if free:
            theta, q = least_squares(p, theta, free)
        q = whole_q(p, theta)
        if not free or not p.scatters or p.robust or not q < before * (1 - 1e-9):
            return q, theta


def covariance_of(p: Problem, theta: Floats) -> Any:
    """Return the covariance of the coordinates if z has the standard deviation 1. It is large along a flat valley."""
    base = p.residuals(theta)
    step = 1e-6 * np.maximum(np.abs(theta), 1)
    step = np.where(theta + step > p.high, -step, step)
    jacobian = np.stack([(p.residuals(theta + h * e) - base) / h for h, e in zip(step, np.eye(theta.size))], axis=1)
    size = np.sqrt((jacobian**2).sum(axis=0))
    if not np.all(np.isfinite(size) & (size > 0)):
        return np.eye(theta.size)
    return np.linalg.inv((jacobian / size).T @ (jacobian / size) + 1e-13 * np.eye(theta.size)) / np.outer(size, size)


def interval_ends(
    p: Problem, theta: Floats, j: int, sign: int, minimum: float, targets: Sequence[float], covariance: Any
) -> List[float]:
    """Return the ends of the intervals of coordinate j on one side. At an end, the square root of the profile's excess
    over the minimum, which is nearly linear, reaches a target."""
    ways, width = covariance[j] / covariance[j, j], math.sqrt(covariance[j, j])
    limit = p.high[j] if sign > 0 else p.low[j]
    inside, others = theta.copy(), _other_starts(p, theta, j)

    def height(x: float) -> float:
        nonlocal inside
        starts = [inside.copy(), inside + ways * (x - inside[j]), *others(x)]
        for start in starts:
            start[j] = x
            np.clip(start, p.low, p.high, out=start)
        starts[:2] = [min(starts[:2], key=p.objective)] if theta.size > 1 else starts[:1]
        q, place = min((profile(p, start, [j]) for start in starts), key=lambda found: found[0])
        if q < minimum * (1 - 1e-8):
            raise _Lower(place)
        high = min(math.sqrt(max(q - minimum, 0)), 1e150)
        inside = place if high <= targets[-1] else inside
        return high

    near, near_height = float(theta[j]), 0.0
    ends: List[float] = []
    step = 1.1 * targets[0] * width
    if not 0 < step < abs(limit - near):
        step = abs(limit - near) / 8
    for target in targets:
        far, far_height = near, near_height
        while far_height < target:
            near, near_height = far, far_height
            if near == limit or step == 0:
                bounded = p.kinds[j] == "unit" or (p.kinds[j] == "positive" and sign < 0)
                return [*ends, *([limit if bounded else math.copysign(math.inf, sign)] * (2 - len(ends)))]
            far = min(near + step, limit) if sign > 0 else max(near - step, limit)
            far_height = height(far)
            step *= 2
        small = 1e-9 * abs(far - theta[j])
        end = far
        if far_height > target * (1 + 1e-9):
            known = {near: near_height - target, far: far_height - target}
            end = scipy("optimize").brentq(
                lambda x: known[x] if x in known else height(x) - target, near, far, xtol=small, rtol=1e-14
            )
        ends.append(float(end))
        near, near_height = end, target
        step = 1.1 * (targets[1] - target) * abs(end - theta[j]) / target
    return ends


def _other_starts(p: Problem, theta: Floats, j: int) -> Callable[[float], List[Floats]]:
    """Return a function that finds a start of the other coordinate by a scan, because its minimum may jump."""
    if p.curve.start != "grid" or p.parameters != 2 or p.scatters:
        return lambda x: []
    _, q = _coarse(p, 250, [])
    other = 1 - j
    log = p.kinds[other] == "log"
    low, high = (max(p.low[other], theta[other] - 4), min(p.high[other], theta[other] + 4)) if log else (0.0, 1.0)
    grid = np.linspace(low, high, 81)

    def starts(x: float) -> List[Floats]:
        values = q(*((x, grid[:, None]) if j == 0 else (grid[:, None], x)))
        return [np.full(2, grid[int(np.argmin(values))])]

    return starts


def unit_of(p: Problem, theta: Floats, minimum: float) -> float:
    """Return the factor of the squared quantile in the threshold of Q: 1, s^2, or Huber's factor."""
    if not p.robust:
        return 1.0 if p.sample.has_sigma else minimum / p.freedom
    root = np.abs(p.residuals(theta))
    psi2 = np.minimum(root, HUBER) ** 2
    return float(psi2.sum() / p.freedom / (max(int((root <= HUBER).sum()), 1) / p.size))


def quantile(p: Problem, level: float) -> float:
    upper, special = (1 + level) / 2, scipy("special")
    return float(special.ndtri(upper) if p.sample.has_sigma else special.stdtrit(p.freedom, upper))


def find_intervals(p: Problem, theta: Floats) -> Tuple[Floats, float, Any]:
    """Return the minimum, its Q and an array of intervals: [coordinate, level, side]; infinite beyond a range."""
    for _ in range(5):
        minimum = whole_q(p, theta)
        state = (p.scale, p.log_ratio)
        unit = unit_of(p, theta, minimum)
        found = np.repeat(theta, 4).reshape(-1, 2, 2)
        targets = [quantile(p, level) * math.sqrt(unit) for level in LEVELS]
        if not math.isfinite(minimum):
            found[..., 0], found[..., 1] = -math.inf, math.inf
            break
        covariance = covariance_of(p, theta)
        try:
            for j in range(p.parameters) if targets[0] > 0 else ():
                for side, sign in enumerate((-1, 1)):
                    p.scale, p.log_ratio = state
                    found[j, :, side] = interval_ends(p, theta, j, sign, minimum, targets, covariance)
            theta = _level_ends(p, theta, minimum, unit, found)
        except _Lower as lower:
            theta = lower.theta
            continue
        break
    p.scale, p.log_ratio = state
    return theta, minimum, found


def _level_ends(p: Problem, theta: Floats, minimum: float, unit: float, found: Any) -> Floats:
    """Move the minimum to the end of a range, where a parameter is 0 or infinite, if Q is flat up to that end."""
    for j, side in zip(*np.nonzero(np.isinf(found[:, 0]))):
        if p.kinds[j] == "log" and np.isfinite(found[j, 0, 1 - side]):
            place = theta.copy()
            place[j] = (p.low, p.high)[side][j]
            q, place = profile(p, place, [j])
            theta = place if q - minimum <= 1e-6 * unit else theta
    return theta
