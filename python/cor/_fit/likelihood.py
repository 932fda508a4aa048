# SPDX-License-Identifier: MIT
"""The residuals of a curve, whitened by the covariance of the measured times or heights.

Bounce k is between the flights k and k + 1. It has the impact speed v_k, the rebound speed u_(k+1) and eps_k =
u_(k+1)/v_k, so the residual is r_k = eps_k - eps(v_k). The fit minimises Q, the sum of squares of z. For a point, z_k =
r_k/sigma_k. For times T of flights and c_k = v_k (dT/du)_(k+1), to first order in the errors e of the bounces' times

    c_k r_k = e_(k+2) - (1 + a_k) e_(k+1) + a_k e_k + c_k h_k,   a_k = (dT/du)_(k+1) (dv/dT)_k (eps + d eps/d ln v)(v_k)

with the scatter h_k of eps. If v_1 follows from the height of the drop, the first bounce has the error of a flight,
e_2 - e_1. For heights the errors are e_(k+1) - a_k e_k, with dh/du instead of dT/du. The covariance is s^2 W, W =
B + lambda diag(c^2), with a band matrix B. Then z = L^-1 (c r) (det W/det B)^(1/(2 n)) for W = L L^T. With this factor,
the lambda of the least Q has the greatest restricted likelihood.
"""

import math
from copy import copy
from functools import lru_cache, partial
from importlib import import_module
from typing import Any, Callable, Dict, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .data import Apexes, Data, Floats, Heights, Ints, Points, Times
from .models import Curve

HUBER = 1.345
LEAST_RESIDUAL = float(np.finfo(float).eps)  # smaller residuals are raised to this value, so that AIC is finite
SLOPE_STEP = 1e-4  # in ln v
STEEPEST = 5.0  # bound on |eps + d eps/d ln v| in a_k; first order fails where eps drops to 0
LOG_RATIO = (math.log(1e-10), math.log(1e8))  # range of ln(lambda times the mean square of c)
MANY = 20000  # with more bounces, class Reduced is used and no outliers are sought


@lru_cache(maxsize=None)
def scipy(name: str) -> Any:
    """Return a module of SciPy, imported at its first use."""
    try:
        return import_module(f"scipy.{name}")
    except ImportError:
        raise ImportError("cor.fit needs SciPy: pip install scipy, or on Debian apt install python3-scipy") from None


# ---- flight with drag ----


def launch_of_duration(time: Floats, gravity: float, kappa: float) -> Floats:
    """Return a flight's launch speed u: g T sqrt(kappa) = atan(s) + asinh(s), s = u sqrt(kappa), kappa = 1/w^2."""
    tau = math.sqrt(kappa) * gravity * time
    if kappa == 0 or not np.any(tau > 1e-150):
        return gravity * time / 2
    s = np.maximum(tau / 2, np.sinh(np.maximum(tau - math.pi / 2, 0)))  # starts below the root of a concave function
    for _ in range(60):
        step = (tau - np.arctan(s) - np.arcsinh(s)) / (1 / (1 + s * s) + 1 / np.sqrt(1 + s * s))
        s = s + step
        if np.all(np.abs(step) <= 4e-15 * np.abs(s)):
            break
    return np.asarray(s / math.sqrt(kappa))


def duration_slope(launch: Floats, gravity: float, kappa: float) -> Any:
    """Return dT/du."""
    square = 1 + kappa * launch * launch
    return np.asarray((1 / square + 1 / np.sqrt(square)) / gravity)


def impact_of_launch(launch: Floats, kappa: float) -> Floats:
    return np.asarray(launch / np.sqrt(1 + kappa * launch * launch))


def _speed_of_height(sign: int, height: Floats, gravity: float, kappa: float) -> Any:
    power = 2 * gravity * kappa * height
    if kappa == 0 or not np.any(power > 1e-290):
        return np.sqrt(2 * gravity * height)
    return np.asarray(np.sqrt(sign * np.expm1(sign * power) / kappa))


impact_of_drop = partial(_speed_of_height, -1)  # the speed after a fall from a height
launch_of_height = partial(_speed_of_height, 1)  # the launch speed of a ball that rises to a height


class Field(NamedTuple):
    """Gravity minus buoyancy, and kappa = 1/w^2 for the terminal speed w. to_coefficient: C_d/kappa, nan if unknown."""

    gravity: float
    kappa: float
    to_coefficient: float

    @classmethod
    def of(cls, gravity: float, ball: Dict[str, float], air_density: float, **drag: Any) -> "Field":
        """ball: known mass, density, radius, diameter. drag: drag_coefficient, terminal_speed, fit_drag"""
        given = [name for name, value in drag.items() if value is not None and value is not False]
        if len(given) > 1:
            raise ValueError(f"{given[1]} and {given[0]} exclude each other; give one of them")
        diameter = ball.get("diameter", 2 * ball.get("radius", math.nan))
        volume, to_coefficient = math.pi / 6 * diameter**3, math.nan
        mass = ball.get("mass", ball.get("density", math.nan) * volume)
        if not math.isnan(mass * diameter):
            gravity *= 1 - air_density * volume / mass if given else 1
            if not gravity > 0:
                raise ValueError("mass: the ball is lighter than the air that it displaces; give a larger mass")
            to_coefficient = 2 * mass * gravity / (air_density * math.pi / 4 * diameter**2)
        elif given == ["drag_coefficient"]:
            missing = "mass" if math.isnan(mass) else "diameter"
            raise ValueError(f"drag_coefficient needs {missing}; give {missing}, or give terminal_speed instead")
        kappa = drag["drag_coefficient"] / to_coefficient if given == ["drag_coefficient"] else 0.0
        return cls(gravity, drag["terminal_speed"] ** -2 if given == ["terminal_speed"] else kappa, to_coefficient)


# ---- bounces ----


class Flights(NamedTuple):
    """The bounces at one gravity and drag, in the order of the file."""

    speed: Floats
    log_speed: Floats
    eps: Floats
    weight: Floats  # c
    gain: Floats  # a/(eps + d eps/d ln v)
    order: Ints  # order of the speeds; equal speeds in the order of the file


class Sample:
    """The bounces of a record. without: omitted lines. Bounces that need such a line are omitted, too."""

    def __init__(self, data: Data, without: Sequence[int] = ()) -> None:
        record = data.record
        self.record = record
        self.is_points, self.is_times = isinstance(record, Points), isinstance(record, Times)
        first, middle, last, begins = self._bounces(record)
        lines = record.line
        self.lines = np.stack([np.where(i >= 0, lines[i], -1) for i in (first, middle, last)], axis=1)
        self.begins, self.first, self.middle, self.last = begins, first, middle, last
        self._keep(~np.isin(self.lines, list(without)).any(axis=1))

    def part(self, kept: Any) -> "Sample":
        """Return a copy with the bounces that a mask selects."""
        made = copy(self)
        made._keep(kept)
        return made

    def _keep(self, kept: Any) -> None:
        """Keep only the bounces that a mask selects. A new drop begins after each omitted bounce."""
        left_out = np.cumsum(~kept)[kept]
        begins = self.begins[kept]
        if begins.size:
            begins |= np.diff(left_out, prepend=0) > 0
        self.begins, self.lines = begins, self.lines[kept]
        self.first, self.middle, self.last = self.first[kept], self.middle[kept], self.last[kept]
        self.size = int(kept.sum())
        self.second = np.append(~begins[1:], False)  # bounce k + 1 shares a number with bounce k
        self.third = np.append(self.second[:-1] & self.second[1:], False)
        self.variance = self._variance()
        self.has_sigma = self.variance is not None
        self.is_chain = self.is_times or isinstance(self.record, Apexes)
        used = np.stack([self.first, self.middle, self.last])
        self.numbers = self.size if not self.is_chain else np.unique(used[used >= 0]).size  # possible outliers
        self.scatters = not self.is_points and not self.has_sigma
        self._cached: Dict[Tuple[float, float], Flights] = {}
        self.reduced: Any = None
        self.pilot: Any = None

    def _bounces(self, record: Any) -> Tuple[Ints, Ints, Ints, Any]:
        """For each bounce, return the indices of three measured numbers (-1: none), and True if it begins a drop."""
        if isinstance(record, (Points, Heights)):
            last = np.arange(record.line.size)
            middle = last if isinstance(record, Heights) else np.full(last.size, -1)
            return np.full(last.size, -1), middle, last, np.ones(last.size, bool)
        place = np.arange(record.line.size) - np.repeat(record.start[:-1], np.diff(record.start))
        if isinstance(record, Apexes):
            last = np.flatnonzero(place >= 1)
            return np.full(last.size, -1), last - 1, last, place[last] == 1
        dropped = np.repeat(np.isfinite(record.height_m), np.diff(record.start))
        last = np.flatnonzero((place >= 2) | ((place == 1) & dropped))
        first = np.where(place[last] >= 2, last - 2, -1)
        return first, last - 1, last, (place[last] == 1) | ((place[last] == 2) & ~dropped[last])

    def _variance(self) -> Optional[Tuple[Floats, Floats]]:
        """Return the variances of the measured numbers `last` and `middle` of each bounce, if they are given."""
        record = self.record
        if isinstance(record, Points):
            given: Tuple[Any, Any] = record.sigma, None
        elif isinstance(record, Heights):
            given = record.rebound_sigma_m, record.drop_sigma_m
        else:
            sigma = record.sigma_m if isinstance(record, Apexes) else None
            given = sigma, sigma
        if given[0] is None and given[1] is None:
            return None
        none = np.zeros(self.size)
        return tuple(none if s is None else s[i] ** 2 for s, i in zip(given, (self.last, self.middle)))  # type: ignore

    def flights(self, gravity: float, kappa: float) -> Flights:
        key = (gravity, kappa)
        if key not in self._cached:
            if len(self._cached) > 8:
                self._cached.clear()
            speed, eps, weight, gain = self._flights(gravity, kappa)
            order = np.argsort(speed, kind="stable")
            self._cached[key] = Flights(speed, np.log(speed), eps, weight, gain, order)
        return self._cached[key]

    def _flights(self, gravity: float, kappa: float) -> Tuple[Any, Any, Any, Any]:
        """Return speeds, eps, c and gains."""
        record, first, middle, last = self.record, self.first, self.middle, self.last
        if isinstance(record, Points):
            one = np.ones(self.size)
            return record.speed_m_s[last], record.eps[last], one, 0 * one
        if isinstance(record, Times):
            launch = launch_of_duration(record.time_s[last] - record.time_s[middle], gravity, kappa)
            before = launch_of_duration(record.time_s[middle] - record.time_s[first], gravity, kappa)
            speed, gain = impact_of_launch(before, kappa), duration_slope(launch, gravity, kappa)
            weight = gain * speed
            with np.errstate(all="ignore"):
                gain = gain * (speed / before) ** 3 / duration_slope(before, gravity, kappa)
            released = first < 0
            if released.any():
                height = record.height_m[np.searchsorted(record.start, last[released], side="right") - 1]
                speed[released] = impact_of_drop(height, gravity, kappa)
                weight[released] = duration_slope(launch[released], gravity, kappa) * speed[released]
                gain[released] = 0
            return speed, launch / speed, weight, gain
        heights = (record.drop_m, record.rebound_m) if isinstance(record, Heights) else (record.height_m,) * 2
        drop, rebound = heights[0][middle], heights[1][last]
        speed, launch = impact_of_drop(drop, gravity, kappa), launch_of_height(rebound, gravity, kappa)
        rise = launch * np.exp(-2 * gravity * kappa * rebound) / gravity  # dh/du
        gain = rise * gravity * np.exp(-2 * gravity * kappa * drop) / speed
        return speed, launch / speed, rise * speed, gain


# ---- one curve and its data ----


class Problem:
    """The residuals z of a curve. theta: the coordinates of the curve, then drag and gravity if they are free."""

    def __init__(self, curve: Curve, sample: Sample, field: Field, free: Sequence[str], robust: bool) -> None:
        self.curve, self.sample, self.field, self.free, self.robust = curve, sample, field, tuple(free), robust
        flights = sample.flights(field.gravity, field.kappa)
        self.fastest2 = math.exp(2 * flights.log_speed.max())
        least, most = float(flights.log_speed.min()), float(flights.log_speed.max())
        extra = {"drag": ("positive", (0.0, 100.0)), "gravity": ("log", (math.log(1e-3), math.log(1e3)))}
        ranges = [*(of(least, most) for of in curve.ranges), *(extra[name][1] for name in self.free)]
        self.low, self.high = (np.array(side, np.float64) for side in zip(*ranges))
        self.kinds = (*curve.kinds, *(extra[name][0] for name in self.free))
        self.size, self.parameters = sample.size, len(self.kinds)
        self.freedom = self.size - self.parameters
        self.scatters = sample.scatters  # True: lambda is free
        self.scale, self.log_ratio = 1.0, LOG_RATIO[0]
        self.plain = False  # True for starts: no covariance, and no Huber's function
        self.mean_square = float(np.mean(flights.weight**2))

    def like(self, curve: Curve) -> "Problem":
        """Return the problem of another curve with the same noise."""
        made = Problem(curve, self.sample, self.field, self.free, self.robust)
        made.plain, made.scale, made.log_ratio = self.plain, self.scale, self.log_ratio
        return made

    def at(self, theta: Floats) -> Flights:
        gravity, kappa = self.field.gravity, self.field.kappa
        for name, value in zip(self.free, theta[len(self.curve.kinds) :]):
            if name == "drag":
                kappa = abs(value) / self.fastest2
            else:
                gravity *= math.exp(min(max(value, -20.0), 20.0))
        return self.sample.flights(gravity, kappa)

    def eps_residual(self, theta: Floats) -> Any:
        flights = self.at(theta)
        return flights.eps - self.curve.eps(theta, flights.log_speed)

    def parts(self, theta: Floats) -> Tuple[Floats, Floats, Floats]:
        """Return c r, c and a."""
        flights, n = self.at(theta), self.size
        x = flights.log_speed
        eps = self.curve.eps(theta, np.concatenate((x, x + SLOPE_STEP, x - SLOPE_STEP)))
        above, below = eps[n : 2 * n], eps[2 * n :]
        slope = np.minimum(np.maximum((above + below) / 2 + (above - below) / (2 * SLOPE_STEP), -STEEPEST), STEEPEST)
        return flights.weight * (flights.eps - eps[:n]), flights.weight, flights.gain * slope

    def factor(self, weight: Floats, a: Floats, ratios: Sequence[float]) -> Tuple[Any, Any]:
        """For each lambda, return L, as blocks of one matrix, and ln det W; nan if W is not positive definite."""
        n, sample = self.size, self.sample
        band: Any = np.zeros((len(ratios), n, 3))
        if sample.is_times:
            own = 1 + (1 + a) ** 2 + a * a
            band[:, :-1, 1] = sample.second[:-1] * (-a[1:] * (1 + a[:-1]) - (1 + a[1:]))
            band[:, :-2, 2] = sample.third[:-2] * a[2:]
        else:
            last, middle = sample.variance or (np.ones(n), 1.0)
            own = last + a * a * middle
            band[:, :-1, 1] = sample.second[:-1] * (-a[1:] * last[:-1])
        band[:, :, 0] = own + np.multiply.outer(ratios, weight * weight)
        factor, wrong = scipy("linalg.lapack").dpbtrf(band.reshape(-1, 3).T, lower=1, overwrite_ab=1)
        if wrong:
            factor[:] = math.nan
        return factor, 2 * np.log(factor[0]).reshape(-1, n).sum(axis=1)

    def whiten(self, parts: Tuple[Floats, Floats, Floats], ratios: Sequence[float]) -> Tuple[Floats, Floats]:
        """Return ln det W and L^-1 (c r) for each lambda."""
        y, weight, a = parts
        factor, determinant = self.factor(weight, a, ratios)
        z = scipy("linalg.blas").dtbsv(2, factor, np.concatenate([y] * len(ratios)), lower=1)
        return determinant, z.reshape(-1, self.size)

    def z_at(self, parts: Tuple[Floats, Floats, Floats], log_ratios: Any) -> Floats:
        """Return z with the factor of the determinants. log_ratios: values of ln(lambda times the mean square of c)"""
        if not self.sample.scatters:
            return self.whiten(parts, [0.0])[1]
        determinant, z = self.whiten(parts, [0.0, *(math.exp(u) / self.mean_square for u in log_ratios)])
        return np.asarray(z[1:] * np.exp((determinant[1:] - determinant[0]) / (2 * self.size))[:, None])

    def time_sigma(self, theta: Floats, scale: float) -> Tuple[float, float]:
        """Return two standard deviations: s, of a measured time or height, and the scatter of eps."""
        ratio = math.exp(self.log_ratio) / self.mean_square
        determinant, _ = self.whiten(self.parts(theta), [0.0, ratio])
        sigma = scale / math.exp((determinant[1] - determinant[0]) / (2 * self.size))
        return sigma, sigma * math.sqrt(ratio)

    def spread(self, flights: Flights) -> Any:
        """Return the standard deviations of eps, without correlations; 1 if they are not given."""
        variance = self.sample.variance
        return 1.0 if variance is None else np.sqrt(variance[0] + variance[1]) / flights.weight

    def z(self, theta: Floats) -> Any:
        """Return the residuals divided by their standard deviations, or by `scale`."""
        if self.plain or self.sample.is_points:
            return self.eps_residual(theta) / (self.spread(self.at(theta)) * self.scale)
        z = self.z_at(self.parts(theta), [self.log_ratio])[0]
        return z if self.sample.has_sigma else z / self.scale

    def residuals(self, theta: Floats) -> Any:
        """Return z. In the robust fit, return sign(z) sqrt(rho(z)); Huber's rho is linear beyond HUBER."""
        z = self.z(theta)
        if not self.robust or self.plain:
            return z
        size = np.abs(z)
        return np.where(size <= HUBER, z, np.copysign(np.sqrt(HUBER * np.maximum(2 * size - HUBER, 0)), z))

    def objective(self, theta: Floats) -> float:
        residuals = self.residuals(theta)
        q = float(residuals @ residuals)
        return q if math.isfinite(q) else math.inf

    def scale_of(self, z: Floats) -> Any:
        """Return sqrt(sum z^2/(n - k)), or sqrt(n/(n - k)) median |z|/0.6745 in the robust fit, for each row of z."""
        if self.robust:
            found = np.median(np.abs(z), axis=-1) / 0.67448975019608171 * math.sqrt(self.size / self.freedom)
        else:
            found = np.sqrt(np.einsum("...i,...i", z, z) / self.freedom)
        found = np.maximum(found, LEAST_RESIDUAL)
        return np.where(np.isnan(found), math.inf, found)

    def set_noise(self, theta: Floats) -> None:
        """Set the least scale and its lambda. Errors of times and scatter of bounces may both explain the data, so each
        local minimum of a scan is refined. In the robust fit, the scale is a median. A median has many minima by
        chance, so only the lowest one is refined."""
        parts = self.parts(theta)
        if not self.scatters:
            self.scale = float(self.scale_of(parts[0]))
            return
        low, high = LOG_RATIO
        places = np.linspace(low, high, 15 if self.robust else 43)
        step = places[1] - places[0]

        def scales(at: Any) -> Any:
            return self.scale_of(self.z_at(parts, at))

        heights = scales(places)
        padded = np.pad(heights, 1, constant_values=math.inf)
        local = np.flatnonzero((padded[1:-1] < padded[:-2]) & (padded[1:-1] <= padded[2:]))
        if self.robust:
            local = local[heights[local] <= heights.min()]
        best, least = low, math.inf
        for i in local:
            u, height = _local_minimum(scales, places[i] - step, places[i] + step, 1 if self.robust else 8)
            if height < least:
                best, least = u, height
        self.log_ratio, self.scale = best, least


KNOTS = 32


class Reduced(Problem):
    """Very many bounces, with lambda fixed. Cubic polynomials between KNOTS speeds interpolate eps, and z is linear in
    eps. Therefore Q is a sum of KNOTS squares plus a constant. lambda and the slopes of the covariance come from a
    `pilot`, a fit of a part of the bounces."""

    def __init__(self, curve: Curve, sample: Sample, field: Field, pilot: Optional[Tuple["Problem", Floats]]) -> None:
        super().__init__(curve, sample, field, (), False)
        self.scatters, self.pilot = False, pilot
        if pilot:
            self.log_ratio = pilot[0].log_ratio + math.log(self.mean_square / pilot[0].mean_square)
        if sample.reduced is None:
            sample.reduced = self._reduce(pilot)
        self.whitened, self.knots, self.rows, self.right, self.constant, self.determinant = sample.reduced

    def _reduce(self, pilot: Optional[Tuple["Problem", Floats]]) -> Any:
        flights = self.sample.flights(self.field.gravity, self.field.kappa)
        determinant, factor = 1.0, None
        if pilot:
            full = Problem(pilot[0].curve, self.sample, self.field, (), False)
            _, weight, a = full.parts(pilot[1])
            ratio = math.exp(self.log_ratio) / self.mean_square if self.sample.scatters else 0.0
            (none,), (factor, (some,)) = full.factor(weight, a, [0.0])[1], full.factor(weight, a, [ratio])
            determinant = math.exp((some - none) / (2 * self.size)) if self.sample.scatters else 1.0
        spread = self.spread(flights)

        def whitened(eps: Floats) -> Any:
            if factor is None:
                return eps / spread
            return determinant * scipy("linalg.blas").dtbsv(2, factor, flights.weight * eps, lower=1)

        x = flights.log_speed
        low, high = float(x.min()), float(x.max())
        step = (high - low) / (KNOTS - 1) or 1.0
        knots = low + step * np.arange(KNOTS)
        cell = np.clip(((x - low) / step).astype(int), 1, KNOTS - 3) - 1  # index of the first of four knots
        t, rows = (x - knots[cell]) / step, np.zeros((KNOTS, self.size))
        shapes = [(1 - t) * (2 - t) * (3 - t) / 6, t * (2 - t) * (3 - t) / 2, t * (t - 1) * (3 - t) / 2]
        shapes.append(t * (t - 1) * (t - 2) / 6)
        for i, shape in enumerate(shapes):
            rows[cell + i, np.arange(self.size)] = shape
        for knot in range(KNOTS):
            rows[knot] = whitened(rows[knot])
        z = whitened(flights.eps)
        values, vectors = np.linalg.eigh(rows @ rows.T)
        use = values > 1e-13 * values.max()
        root = np.sqrt(values[use])
        right = vectors[:, use].T @ (rows @ z) / root
        return whitened, knots, root[:, None] * vectors[:, use].T, right, float(z @ z - right @ right), determinant

    def like(self, curve: Curve) -> Problem:
        return Reduced(curve, self.sample, self.field, self.pilot)

    def residuals(self, theta: Floats) -> Any:
        return self.right - self.rows @ self.curve.eps(theta, self.knots)

    def objective(self, theta: Floats) -> float:
        return float(super().objective(theta) + self.constant)

    def z(self, theta: Floats) -> Any:
        return self.whitened(self.eps_residual(theta))

    def time_sigma(self, theta: Floats, scale: float) -> Tuple[float, float]:
        sigma = scale / self.determinant
        return sigma, sigma * math.sqrt(math.exp(self.log_ratio) / self.mean_square)


def _local_minimum(f: Callable[[Sequence[float]], Floats], low: float, high: float, places: int) -> Tuple[float, float]:
    """Return place and value of a local minimum. places: points per evaluation; 1: golden sections."""
    golden = 0.6180339887498949
    if places == 1:
        at = low + (1 - golden) * (high - low)
        height = float(f([at])[0])
        for _ in range(24):
            at_next = low + golden * (high - low)
            next_height = float(f([at_next])[0])
            if next_height < height:
                low, at, height = at, at_next, next_height
            else:
                low, high = at_next, low
        return at, height
    while True:
        grid = np.linspace(low, high, places + 2)[1:-1]
        values = f(list(grid))
        k = int(np.argmin(values))
        if high - low < 1e-6:
            return float(grid[k]), float(values[k])
        low, high = grid[k] - (grid[1] - grid[0]), grid[k] + (grid[1] - grid[0])
