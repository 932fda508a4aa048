# SPDX-License-Identifier: MIT
"""Tests cor.fit against synthetic data, flights by an integrator, dense matrices, and profile likelihoods on a grid.

COR_TEST_LONG=1 draws more data.
"""

import math
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import cor

stats = pytest.importorskip("scipy.stats")
integrate = pytest.importorskip("scipy.integrate")
from cor._fit import compare, intervals, likelihood, models, result as results  # noqa: E402
from cor._fit.data import Apexes, Data, DataError, Heights, Points, Times  # noqa: E402

DATA = Path(__file__).parents[2] / "docs" / "data"
CORGEN = os.environ.get("CORGEN", "build/corgen")
LONG = bool(os.environ.get("COR_TEST_LONG"))
G = 9.80665
BALL_SIZE = {"mass": 0.0027, "diameter": 0.04}
BALL = {**BALL_SIZE, "drag_coefficient": 0.47}
FIELD = likelihood.Field(G, 0.0, math.nan)
# theta of each curve, with eps from 0.4 to 0.95 at 0.1 to 10 m/s
TRUTH = {
    "viscoelastic zero-overlap": (-1.2,),
    "viscoelastic zero-force": (-1.0,),
    "constant": (0.7,),
    "hunt-crossley zero-overlap": (-2.3,),
    "hertz-dashpot zero-overlap": (-1.5,),
    "hertz-dashpot zero-force": (-1.3,),
    "power-law": (-0.4, -0.1),
    "elastic-plastic": (-1.2,),
    "adhesive constant": (0.7, -3.0),
    "adhesive viscoelastic zero-overlap": (-1.2, -3.0),
    "adhesive viscoelastic zero-force": (-1.0, -3.0),
    "wet constant": (0.8, -3.9),
    "wet viscoelastic zero-overlap": (-1.2, -3.9),
    "wet viscoelastic zero-force": (-1.0, -3.9),
    "exponential": (0.5, 0.7),
    "stokes": (0.8, -3.2),
    "walton-braun": (1.0,),
}
CURVES = {model.curve.name: model.curve for model in models.MODELS}


def ints(*values):
    return np.array(values, np.int64)


@pytest.fixture(autouse=True)
def quick(request, monkeypatch):
    """Omits the search for outliers, which takes most of the time of a fit."""
    if not LONG and "outliers" not in request.node.name:
        monkeypatch.setattr(results, "find_outliers", lambda *_: [])


def points(speed, eps, sigma=None):
    n = len(speed)
    return Data("points", Points(np.array(speed), np.array(eps), sigma, np.arange(n) + 2, np.zeros(n, np.int64)))


def times(drops, heights=None):
    counts = [len(drop) for drop in drops]
    height = np.full(len(drops), math.nan) if heights is None else np.array(heights)
    record = Times(np.concatenate(drops), np.arange(sum(counts)) + 2, np.cumsum([0, *counts]), height,
                   np.zeros(len(drops), np.int64))  # fmt: skip
    return Data("times", record)


def draw_points(name, random, n=15, sigma=0.015, given=False):
    x = np.linspace(math.log(0.1), math.log(10), n)
    each = sigma * random.uniform(0.5, 2, n) if given else np.full(n, sigma)
    eps = CURVES[name].eps(TRUTH[name], x) + each * random.standard_normal(n)
    return points(np.exp(x), eps, each if given else None)


def draw_times(name, random, drops=6, bounces=8, error=2e-4, scatter=0.0):
    made = []
    for _ in range(drops):
        time, flight, drop = 1.0, random.uniform(0.6, 1), []
        for _ in range(bounces):
            drop.append(time + error * random.standard_normal())
            eps = float(CURVES[name].eps(TRUTH[name], np.log([G * flight / 2]))[0])
            time += flight
            flight *= eps + scatter * random.standard_normal()
        made.append(np.array(drop))
    return times(made)


def problem(name, data, robust=False):
    return likelihood.Problem(CURVES[name], likelihood.Sample(data), FIELD, (), robust)


def by_name(result, name):
    return {row.parameter: row for row in result.parameters if f"{row.model} {row.end}".startswith(name)}


# ---- flight ----


def fly(launch, kappa, gravity=G, height=0.0):
    """Returns duration, impact speed and greatest height of a flight, by an integrator."""

    def rates(_t, y):
        return [y[1], -gravity * (1 + kappa * y[1] * abs(y[1]))]

    landing, top = (lambda _t, y: y[0]), (lambda _t, y: y[1])
    landing.terminal, landing.direction, top.direction = True, -1, -1
    start = [height + (1e-300 if launch else 0), launch]
    run = integrate.solve_ivp(rates, (0, 99), start, events=[landing, top], rtol=1e-12, atol=1e-14, max_step=0.05)
    rise = run.y_events[1][0][0] if len(run.y_events[1]) else height
    return run.t_events[0][-1], -run.y_events[0][-1][1], rise


@pytest.mark.parametrize("launch, kappa", [(2.0, 0.012), (5.0, 0.3), (0.3, 1e-4), (3.0, 0.0)])
def test_flights_agree_with_an_integrator(launch, kappa):
    duration, impact, height = fly(launch, kappa)
    one = np.array([duration])
    assert likelihood.launch_of_duration(one, G, kappa)[0] == pytest.approx(launch, rel=1e-9)
    assert likelihood.impact_of_launch(np.array([launch]), kappa)[0] == pytest.approx(impact, rel=1e-9)
    assert likelihood.launch_of_height(np.array([height]), G, kappa)[0] == pytest.approx(launch, rel=1e-9)
    dropped = fly(0.0, kappa, height=height)[1]
    assert likelihood.impact_of_drop(np.array([height]), G, kappa)[0] == pytest.approx(dropped, rel=1e-9)
    slope = (fly(launch * 1.001, kappa)[0] - fly(launch * 0.999, kappa)[0]) / (0.002 * launch)
    assert likelihood.duration_slope(np.array([launch]), G, kappa)[0] == pytest.approx(slope, rel=1e-5)


def bouncing(height, kappa, gravity, eps=0.955, bounces=9):
    """Returns times of the bounces after a drop, and the heights of all apexes."""
    speed, time, at, apexes = fly(0.0, kappa, gravity, height)[1], 0.0, [], [height]
    for _ in range(bounces):
        at.append(time)
        duration, impact, apex = fly(eps * speed, kappa, gravity)
        time, speed = time + duration, impact
        apexes.append(apex)
    return np.array(at), np.array(apexes)


@pytest.fixture(scope="module")
def table_tennis():
    """Returns drops of a ball of eps = 0.955 in air, with buoyancy."""
    volume, area = math.pi / 6 * 0.04**3, math.pi / 4 * 0.04**2
    gravity = G * (1 - 1.204 * volume / 0.0027)
    kappa = 1.204 * 0.47 * area / (2 * 0.0027 * gravity)
    return [bouncing(height, kappa, gravity) for height in (0.1, 0.6)]


def test_drag_is_no_property_of_the_ball(table_tennis):
    random = np.random.default_rng(1)
    drops = [at + 1e-4 * random.standard_normal(at.size) for at, _ in table_tennis]
    without = cor.fit(times(drops), law="constant,power-law")
    assert without.find()[0].name == "power-law"
    assert by_name(without, "power-law")["exponent"].value == pytest.approx(-0.039, abs=0.012)
    for data in (times(drops), times(drops, [0.1, 0.6])):
        with_drag = cor.fit(data, law="constant,power-law", **BALL)
        row = by_name(with_drag, "constant")["eps"]
        assert with_drag.find()[0].name == "constant" and row.low_95 < 0.955 < row.high_95
        assert row.high_95 - row.low_95 < 2e-3
    free = cor.fit(times(drops), law="constant", fit_drag=True, **BALL_SIZE)
    row = by_name(free, "constant")["drag_coefficient"]
    assert row.low_95 < 0.47 < row.high_95 and row.high_95 - row.low_95 < 0.1
    # the size of the ball has no effect without drag
    sized, bare = (cor.fit(times(drops, [0.1, 0.6]), law="constant", **size) for size in (BALL_SIZE, {}))
    assert sized.parameters.value[0] == bare.parameters.value[0]
    # the terminal speed instead of mass and diameter gives the same eps
    lighter = G * (1 - 1.204 * math.pi / 6 * 0.04**3 / 0.0027)
    speed = math.sqrt(2 * 0.0027 * lighter / (1.204 * 0.47 * math.pi / 4)) / 0.04
    same = cor.fit(times(drops), law="constant", terminal_speed=speed, gravity=lighter).find()[1].theta[0]
    assert same == pytest.approx(by_name(cor.fit(times(drops), law="constant", **BALL), "constant")["eps"].value)


def test_heights_in_air(table_tennis):
    random = np.random.default_rng(2)
    heights = [apexes + 2e-4 * random.standard_normal(apexes.size) for _, apexes in table_tennis]
    counts, none = [h.size for h in heights], np.zeros(2, np.int64)
    line = np.arange(sum(counts)) + 2
    chain = Apexes(np.concatenate(heights), None, line, np.cumsum([0, *counts]), none)
    known = Apexes(chain.height_m, np.full(line.size, 2e-4), line, chain.start, none)
    drop, rebound = (np.concatenate([h[part] for h in heights]) for part in (slice(None, -1, 2), slice(1, None, 2)))
    each = np.arange(drop.size)
    pairs = Heights(drop, rebound, None, np.full(drop.size, 3e-4), each + 2, 0 * each)
    for record in (chain, known, pairs) if LONG else (chain, pairs):
        result = cor.fit(Data("heights", record), law="constant,power-law", **BALL)
        row = by_name(result, "constant")["eps"]
        assert result.find()[0].name == "constant" and row.value == pytest.approx(0.955, abs=2e-3)
        assert row.low_95 - 1e-3 < 0.955 < row.high_95 + 1e-3
        assert not cor.fit(Data("heights", record), law="constant").find()[1].fits


def test_gravity_follows_from_a_drop_height():
    drops = [bouncing(height, 0.0, 3.71, 0.8, 5)[0] for height in (0.5, 1.0)]
    random = np.random.default_rng(3)
    noisy = [at + 1e-4 * random.standard_normal(at.size) for at in drops]
    row = by_name(cor.fit(times(noisy, [0.5, 1.0]), law="constant", fit_gravity=True), "constant")["gravity_m_s2"]
    assert row.low_95 < 3.71 < row.high_95 and row.high_95 - row.low_95 < 0.1
    assert math.isnan(
        by_name(cor.fit(times(noisy), law="constant", fit_gravity=True), "constant")["gravity_m_s2"].value
    )


# ---- the likelihood by other routes ----


def trajectory_q(name, theta, data, ratio):
    """Computes Q and its determinants by dense matrices of the trajectory. The first time and flight of each drop
    and the scatter of eps change all later times."""
    total, logs, n, record = 0.0, 0.0, 0, data.record
    for first, end in zip(record.start, record.start[1:]):
        t = record.time_s[first:end]
        m, flights = t.size, np.diff(t)
        r, by_flight, by_scatter = np.zeros(m), np.zeros(m), np.zeros((m, m))
        by_flight[1], error, grown, move = 1, 0.0, 1.0, np.zeros(m)
        for i in range(2, m):

            def following(flight):
                return flight * float(CURVES[name].eps(theta, np.log([G * flight / 2]))[0])

            T, h = flights[i - 2], 1e-4 * flights[i - 2]
            slope = (8 * (following(T + h) - following(T - h)) - following(T + 2 * h) + following(T - 2 * h)) / (12 * h)
            error = slope * error + flights[i - 1] - following(T)
            grown, move = grown * slope, move * slope
            move[i] = T
            r[i], by_flight[i], by_scatter[i] = r[i - 1] + error, by_flight[i - 1] + grown, by_scatter[i - 1] + move
        x = np.stack([np.ones(m), by_flight], axis=1)
        for lam, sign in ((ratio, 1), (0.0, -1)):
            c = np.eye(m) + lam * by_scatter @ by_scatter.T
            inverse = np.linalg.inv(c)
            inner = x.T @ inverse @ x
            logs += sign * (np.linalg.slogdet(c)[1] + np.linalg.slogdet(inner)[1])
            if sign > 0:
                total += r @ (inverse - inverse @ x @ np.linalg.solve(inner, x.T @ inverse)) @ r
        n += m - 2
    return total * math.exp(logs / n)


@pytest.mark.parametrize("name", ["viscoelastic zero-force", "power-law"])
def test_times_agree_with_dense_matrices(name):
    random = np.random.default_rng(4)
    data = draw_times(name, random, drops=4, scatter=1e-3)
    p = problem(name, data)
    for _ in range(3):
        theta = np.array(TRUTH[name]) + random.uniform(-0.03, 0.03, p.parameters)
        p.log_ratio = random.uniform(-8, 8)
        expected = trajectory_q(name, theta, data, math.exp(p.log_ratio) / p.mean_square)
        assert p.objective(theta) == pytest.approx(expected, rel=1e-6)
    theta, minimum, ends = intervals.find_intervals(p, intervals.minimise_with_noise(p))
    scan = [trajectory_q(name, theta, data, math.exp(u) / p.mean_square) for u in np.linspace(-23, 18, 83)]
    assert minimum <= min(scan) * (1 + 1e-6)


@pytest.mark.parametrize("given", [False, True])
@pytest.mark.parametrize("name", TRUTH)
def test_a_grid_has_the_same_minimum_and_intervals(name, given):
    data = draw_points(name, np.random.default_rng(5), n=18, sigma=0.01, given=given)
    record, p = data.record, problem(name, data)
    theta, minimum, ends = intervals.find_intervals(p, intervals.minimise_with_noise(p))
    k, sigma = theta.size, 1 if record.sigma is None else record.sigma
    width = ends[:, 1, 1] - ends[:, 1, 0]
    grid = [np.linspace(t - w, t + w, 201) for t, w in zip(theta, width)]
    if k == 1:
        grid[0] = np.concatenate((grid[0], ends[0].ravel()))
    mesh = np.meshgrid(*grid, indexing="ij")
    x = np.log(record.speed_m_s)
    eps = CURVES[name].eps([m[..., None] for m in mesh], x)
    squares = (((record.eps - eps) / sigma) ** 2).sum(axis=-1)
    assert np.nanmin(squares) >= minimum * (1 - 1e-9)
    unit = 1 if given else minimum / (18 - k)
    for level, probability in enumerate((stats.norm.cdf(1) - stats.norm.cdf(-1), 0.95)):
        quantile = stats.norm.ppf((1 + probability) / 2) if given else stats.t.ppf((1 + probability) / 2, 18 - k)
        for j in range(k):
            profile = np.nanmin(squares, axis=1 - j) if k == 2 else squares
            for end in ends[j, level]:
                excess = (np.interp(end, grid[j][:201], profile[:201]) - minimum) / (quantile**2 * unit)
                assert excess == pytest.approx(1, abs=0.01), (j, level, end)


@pytest.mark.parametrize("kind", ["times", "drop height", "apexes"])
def test_an_error_of_a_number_moves_its_bounces(kind):
    """Exact data with drag: an error of one time or height changes c r of each bounce by this error's coefficient."""
    kappa, theta = 0.03, np.array([-0.1, -0.05])
    speed, time, at, apexes = likelihood.impact_of_drop(np.array([1.0]), G, kappa), 0.0, [], [1.0]
    for _ in range(5):
        at.append(time)
        launch = np.exp(theta[0] + theta[1] * np.log(speed)) * speed
        speed = likelihood.impact_of_launch(launch, kappa)
        time += float((np.arctan(launch * kappa**0.5) + np.arcsinh(launch * kappa**0.5))[0]) / (G * kappa**0.5)
        apexes.append(float(np.log1p(kappa * launch**2)[0]) / (2 * G * kappa))
    if kind == "apexes":
        none = np.zeros(1, np.int64)
        data = Data("heights", Apexes(np.array(apexes), None, np.arange(6), np.array([0, 6]), none))
    else:
        data = times([np.array(at)], [1.0] if kind == "drop height" else None)
    numbers = data.record.height_m if kind == "apexes" else data.record.time_s

    def parts():
        sample = likelihood.Sample(data)
        p = likelihood.Problem(CURVES["power-law"], sample, likelihood.Field(G, kappa, math.nan), (), False)
        return sample, p.parts(theta)

    sample, (residual, _, a) = parts()
    assert np.abs(residual).max() < 1e-12
    for k in range(numbers.size):
        numbers[k] += 1e-6
        moved = parts()[1][0] / 1e-6
        numbers[k] -= 1e-6
        middle = -a if kind == "apexes" else -(1 + a)
        expected = (sample.first == k) * a + (sample.middle == k) * middle + (sample.last == k)
        assert moved == pytest.approx(expected, abs=1e-4), k


def test_given_errors_of_heights_by_dense_matrices():
    random, none = np.random.default_rng(18), np.zeros(1, np.int64)
    heights = 0.81 ** np.arange(6) + 1e-3 * random.standard_normal(6)
    sigma = random.uniform(1e-3, 2e-3, 6)
    chain = Apexes(heights, sigma, np.arange(6), np.array([0, 6]), none)
    pairs = Heights(heights[:3], heights[3:], sigma[:3], sigma[3:], np.arange(3), np.zeros(3, np.int64))
    for record, middle, last in (
        (chain, ints(0, 1, 2, 3, 4), ints(1, 2, 3, 4, 5)),
        (pairs, ints(0, 1, 2), ints(3, 4, 5)),
    ):
        p, eps = problem("constant", Data("heights", record)), 0.88
        errors = np.zeros((middle.size, 6))  # errors of sqrt(2 g h_1) - eps sqrt(2 g h_0)
        errors[range(middle.size), last] = np.sqrt(G / 2 / heights[last])
        errors[range(middle.size), middle] = -eps * np.sqrt(G / 2 / heights[middle])
        residual = np.sqrt(2 * G * heights[last]) - eps * np.sqrt(2 * G * heights[middle])
        expected = residual @ np.linalg.solve(errors @ np.diag(sigma**2) @ errors.T, residual)
        assert p.objective(np.array([eps])) == pytest.approx(expected, rel=1e-9)


def test_curves_by_other_routes():
    v, s, e = np.array([0.3, 1.0, 4.0]), 0.1, 0.8
    x, log_s, theta = np.log(v), math.log(0.1), -1.1
    sphere = {end: cor.Contact(beta=math.exp(theta), at=1.0, end=end).eps for end in ("zero_overlap", "zero_force")}
    expected = {
        "adhesive constant": (e, np.sqrt(e**2 - (s / v) ** 2)),
        "wet constant": (e, (e * (v - s) - s) / v),
        "exponential": (e, e + (1 - e) * np.exp(-v / s)),
        "stokes": (e, e - e * s / v),
        "walton-braun": (log_s, (1 + v / s) ** -0.5),
        "power-law": (log_s, np.minimum(1, s * v**log_s)),
        "elastic-plastic": (log_s, cor.Contact(law="elastic-plastic", young=1e9, poisson=0.3, radius=1.0, density=1e3,
                                               restitution=0.5, at=1.0).eps(v * _yield(0.5) / s)),
    }  # fmt: skip
    for end, eps in sphere.items():
        name = f"viscoelastic {end.replace('_', '-')}"
        expected[name] = (theta, eps(v))
        expected[f"adhesive {name}"] = (theta, np.sqrt(eps(v) ** 2 - (s / v) ** 2))
        expected[f"wet {name}"] = (theta, (eps(v - s) * (v - s) - s) / v)
    for name, (first, eps) in expected.items():
        assert CURVES[name].eps((first, log_s), x) == pytest.approx(eps, rel=1e-9), name
        assert np.all(np.asarray(CURVES[name].eps((first, log_s), x - 9)) >= 0), name


def _yield(eps):
    """Returns the yield speed of elastic-plastic spheres with eps at 1 m/s, by the formula of Thornton."""
    brentq = pytest.importorskip("scipy.optimize").brentq

    def eps4(r):
        t = r * math.sqrt(5 / (6 - r * r))
        return 108 * t / ((t + 2) * (t * t + 5) ** 2)

    return brentq(lambda r: eps4(r) - eps**4, 1e-6, 1)


# value, low and high of 95 %, AIC and p, from another implementation, corgen fit
STORED = [
    ("golf_ball_marble_heights", "viscoelastic zero-overlap", "g_star_m_s", 205461, 195593, 215918, 14.7784, 0.0051),
    ("ice_bridges_1984_formula", "power-law", "exponent", -0.234, -0.234012, -0.233988, -595.433, 0.25),
    ("golf_ball_marble", "constant", "eps", 0.89565, 0.894174, 0.89712, -1511.11, 0.99),
    ("golf_ball_marble", "viscoelastic zero-force", "g_star_m_s", 156930, 143681, 171527, -1479.93, 0.0024),
    ("tennis_ball_stoneware", "adhesive-viscoelastic zero-overlap", "adhesion_speed_m_s", 0.292475, 0.25206, 0.327753,
     -851.655, 0.16),
    ("ping_pong_ball_parquet", "power-law", "exponent", -0.0302693, -0.0340022, -0.0265135, -2333.65, 6.4e-5),
]  # fmt: skip


@pytest.mark.parametrize("file, title, parameter, value, low, high, aic, p", STORED)
def test_stored_data(file, title, parameter, value, low, high, aic, p):
    name, _, end = title.partition(" ")
    result = cor.fit(DATA / f"{file}.csv", law=name, end=end or None)
    row = by_name(result, title)[parameter]
    assert [float(f"{x:.6g}") for x in (row.value, row.low_95, row.high_95, row.aic)] == [value, low, high, aic]
    assert float(f"{result.find(title)[1].p_value:.2g}") == p


def test_points_behind_the_drag_of_the_stored_times():
    """p values of the bounces of a table tennis ball as independent points, with drag and without buoyancy."""
    record = cor.fit(DATA / "ping_pong_ball_parquet.csv", law="constant").data
    sample = likelihood.Sample(record)
    flights = sample.flights(G, 0.4 * 1.204 * math.pi / 4 * 0.04**2 / (2 * 0.0027 * G))
    result = cor.fit(points(flights.speed, flights.eps), law="power-law,viscoelastic,constant")
    assert [round(result.find(name)[1].p_value, 3) for name in ("power-law", "constant")] == [0.067, 0.003]
    assert result.find("viscoelastic", "zero-force")[1].p_value == pytest.approx(0.1, abs=0.01)


def test_many_bounces_are_reduced(monkeypatch):
    data = draw_times("power-law", np.random.default_rng(6), drops=60, scatter=2e-3)
    whole = cor.fit(data, law="power-law").parameters
    monkeypatch.setattr(compare, "MANY", 100)
    reduced = cor.fit(data, law="power-law").parameters
    for a, b in zip(whole, reduced):
        width = a.high_68 - a.low_68
        assert b.parameter == a.parameter and b.value == pytest.approx(a.value, abs=0.1 * width)
        assert b.high_68 - b.low_68 == pytest.approx(width, rel=0.1) and b.rms == pytest.approx(a.rms, rel=1e-4)
        assert b.aic == pytest.approx(a.aic, abs=3)


# ---- how often intervals contain the truth ----


def is_likely(n, k, low, high):
    """True if k hits in n draws are plausible for a probability from low to high."""
    return stats.binom.cdf(k, n, low) > 1e-6 and stats.binom.sf(k - 1, n, high) > 1e-6


@pytest.mark.parametrize("kind", ["points", "sigma", "times", "robust"])
def test_intervals_hold_the_truth(kind):
    draws = {"points": 200, "sigma": 200, "times": 40, "robust": 60}[kind] if LONG else 2
    names = [*TRUTH] if kind != "times" else [name for name in TRUTH if len(TRUTH[name]) == 1]
    held, rejected, total = np.zeros(2), 0, 0
    random = np.random.default_rng(7)
    for name in names[:: 1 if LONG or kind != "times" else 4]:
        here = np.zeros(2)
        for _ in range(draws):
            if kind == "times":
                data = draw_times(name, random)
            else:
                data = draw_points(name, random, 12 if kind != "robust" else 40, given=kind == "sigma")
            p = problem(name, data, kind == "robust")
            setup = compare.Setup(FIELD, (), kind == "robust")
            e = compare.estimate(CURVES[name], p.sample, setup)
            truth = np.array(TRUTH[name])[:, None]
            here += ((e.intervals[..., 0] <= truth) & (truth <= e.intervals[..., 1])).sum(axis=0)
            rejected += not e.fits
            assert np.all(e.intervals[:, 1, 0] <= e.intervals[:, 0, 0]) and not np.isnan(e.intervals).any()
            assert np.all(e.intervals[:, 0, 1] <= e.intervals[:, 1, 1])
        count = draws * truth.size
        total, held = total + count, held + here
        print(kind, name, here / count)
        assert is_likely(count, here[1], 0.92, 0.99 if kind == "times" else 0.98), name
    print(kind, held / total, "rejected", rejected, "of", draws * len(names))
    assert is_likely(total, held[0], 0.66, 0.78 if kind in ("times", "robust") else 0.71)
    assert is_likely(total, held[1], 0.93, 0.98) and is_likely(total, rejected, 0, 0.03)


# ---- the result ----


def test_the_simplest_model_is_named():
    random = np.random.default_rng(8)
    named = []
    for _ in range(10):
        result = cor.fit(draw_points("constant", random, n=20), law="constant,power-law,stokes")
        named.append(result.find()[0].name)
    assert named.count("constant") >= 7  # an AIC that is lower by 2 is rare


def test_a_flat_minimum_is_not_determined():
    result = cor.fit(points([2.0] * 8, 0.7 + 0.01 * np.random.default_rng(9).standard_normal(8)), law="power-law")
    for row in result.parameters:
        assert math.isnan(row.value) and math.isnan(row.low_68), row
    assert any("Not determined" in line for line in result.remarks()) and result.command("power-law") is None
    exact = cor.fit(times([np.cumsum([0, *0.8 ** np.arange(6)])]), law="constant")
    assert exact.find()[1].theta[0] == pytest.approx(0.8) and "nan" not in " ".join(exact.remarks())
    assert math.isfinite(cor.fit({"speed_m_s": [1, 2, 3], "eps": [0.5] * 3}, law="constant").find()[1].aic)
    assert math.isnan(compare.groups_p_value(np.array([1.0, -1.0, 0.5]), 1))  # one of two groups has one point


def test_predictions_carry_the_uncertainty():
    data = draw_points("power-law", np.random.default_rng(10), n=30)
    result = cor.fit(data, law="power-law,viscoelastic,constant")
    row = by_name(result, "constant")["eps"]
    assert tuple(result.predict(2.0, "constant"))[1:] == pytest.approx((row.value, *list(row)[5:9]), rel=1e-4)
    p = problem("power-law", data)
    theta, speed = result.find("power-law")[1].theta, np.array([0.05, 1.0, 20.0])
    eps = np.exp(theta[0] + theta[1] * np.log(speed))
    gradient = eps[:, None] * np.stack([np.ones(3), np.log(speed)], axis=1)
    x = np.log(data.record.speed_m_s)
    jacobian = np.exp(theta[0] + theta[1] * x)[:, None] * np.stack([np.ones(30), x], axis=1)
    covariance = np.linalg.inv(jacobian.T @ jacobian) * p.objective(theta) / 28
    half = np.sqrt(np.einsum("ij,jk,ik->i", gradient, covariance, gradient)) * stats.t.ppf(0.975, 28)
    made = result.predict(speed, "power-law")
    assert made.eps == pytest.approx(eps) and (made.high_95 - made.low_95) / 2 == pytest.approx(half, rel=0.03)
    star = by_name(result, "viscoelastic zero-force")["g_star_m_s"]
    made = result.predict(3.0, "viscoelastic zero-force")
    ends = [cor.Contact(g_star=g, end="zero_force").eps(3.0) for g in (star.low_68, star.high_68)]
    assert [made.low_68, made.high_68] == pytest.approx(sorted(ends), rel=1e-5)


@pytest.mark.parametrize(
    "bodies", [{}, dict(young=1e7, poisson=0.3, radius=0.01, mass=0.005, wall=True, density_2=2e3)]
)
def test_commands_give_the_fit(bodies):
    random = np.random.default_rng(11)
    result = cor.fit(draw_points("viscoelastic zero-force", random, n=12), **bodies)
    seen = 0
    for model, _ in result.groups[""].comparison.fits:
        command = result.command(model.title)
        if command is None:
            assert model.name in "constant stokes walton-braun-variable".split() or (
                model.name.startswith(("wet", "adhesive", "walton"))
            )
            continue
        words = command.replace("corgen embed", f"{CORGEN} contact").split()
        words = words[: words.index("--speed-min")] + ["--speed", "0.5,2", "--format", "csv"]
        words = [w for i, w in enumerate(words) if w != "--end" and words[i - 1] != "--end"]
        if "restitution" in command:
            words += ["--end", "zero-overlap"]
        rows = subprocess.run(words, stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout.split()
        head = rows[0].split(",")
        column = (
            1 if head[1] == "eps" else head.index("eps_zero_force" if model.end == "zero-force" else "eps_zero_overlap")
        )
        made = [float(row.split(",")[column]) for row in rows[1:]]
        assert made == pytest.approx(result.predict([0.5, 2.0], model.title).eps, rel=2e-6), command
        seen += 1
    assert seen >= 12
    speed = np.linspace(1, 3, 12)  # eps is 1 only at a speed above all doubles
    rising = cor.fit(points(speed, 0.8 * speed**1e-4 + 1e-6 * np.sin(9 * speed)), law="power-law").command()
    assert rising.endswith("--speed-min 1 --speed-max 3 --tolerance 1e-6")
    assert subprocess.run([CORGEN, *result.command("viscoelastic").split()[1:]], stdout=subprocess.PIPE).returncode == 0


def test_parameters_of_materials():
    """A contact of cor with the fitted parameter of the bodies has eps of the fit."""
    bodies = dict(young=7e10, poisson=0.24, radius=0.005, mass=1.3e-3)
    data = draw_points("viscoelastic zero-force", np.random.default_rng(12), n=10)
    result = cor.fit(data, wall=True, density_2=2500.0, viscosity_liquid=1e-3, **bodies)
    time = by_name(result, "viscoelastic zero-overlap")["dissipation_time_s"].value
    ball, wall = cor.Body(7e10, 0.24, time, 0.005, 1.3e-3), cor.Body(7e10, 0.24, time, np.inf, np.inf)
    contacts = {
        "viscoelastic zero-overlap": cor.Contact(ball, wall),
        "plate": cor.Contact(law="plate", plate_thickness=by_name(result, "plate")["plate_thickness_m"].value,
                             density_2=2500.0, **bodies),
        "hertz-dashpot zero-overlap": cor.Contact(ball, wall, law="hertz-dashpot", damping_coefficient=by_name(
            result, "hertz-dashpot zero-overlap")["damping_coefficient_n_s_m"].value),
        "elastic-plastic": cor.Contact(law="elastic-plastic", wall=True, yield_stress=by_name(
            result, "elastic-plastic")["yield_stress_pa"].value, **bodies),
    }  # fmt: skip
    for title, contact in contacts.items():
        end = None if title == "elastic-plastic" else "zero_overlap"
        assert contact.eps(1.5, end) == pytest.approx(result.predict(1.5, title).eps, rel=1e-9), title
    rigid = cor.fit(data, law="viscoelastic", end="zero-overlap", wall=True, young_2=math.inf, **bodies)
    time = rigid.parameters.value[0]
    contact = cor.Contact(cor.Body(7e10, 0.24, time, 0.005, 1.3e-3), cor.Body(np.inf, 0.24, time, np.inf, np.inf))
    assert contact.eps(1.5, "zero_overlap") == pytest.approx(rigid.predict(1.5).eps, rel=1e-9)
    bodies.update(wall=True, viscosity_liquid=1e-3)
    result = cor.fit(draw_points("stokes", np.random.default_rng(12)), law="stokes,constant,walton-braun", **bodies)
    row, theta = by_name(result, "stokes")["critical_stokes_number"], result.find("stokes")[1].theta
    assert row.value == pytest.approx(1.3e-3 * math.exp(theta[1]) / (6 * math.pi * 1e-3 * 0.005**2))
    assert by_name(result, "walton-braun both")["stiffness_ratio"].value == result.find("constant")[1].theta[0] ** 2


def test_a_function_of_the_user():
    def line(speed, a=1.0, slope=0.0):
        return a - slope * speed

    speed = np.linspace(0.5, 3, 12)
    result = cor.fit(points(speed, 0.9 - 0.05 * speed + 1e-3 * np.sin(9 * speed)), law=[line, "constant"])
    row = by_name(result, "line")["slope"]
    assert result.find()[0].name == "line" and row.value == pytest.approx(0.05, abs=1e-3)
    slope, _ = np.polyfit(speed, 0.9 - 0.05 * speed + 1e-3 * np.sin(9 * speed), 1)
    assert row.value == pytest.approx(-slope, rel=1e-6) and result.command("line") is None

    def parabola(speed, a=0.9, b=0.05, c=0.0):
        return a - b * speed + c * speed**2

    eps = 0.9 - 0.08 * speed + 0.006 * speed**2 + 4e-3 * np.random.default_rng(15).standard_normal(12)
    columns, at = np.stack([np.ones(12), speed, speed**2], axis=1), np.array([1.0, 4.0, 16.0])
    squares = np.linalg.lstsq(columns, eps, rcond=None)[1][0]
    half = stats.t.ppf(0.975, 9) * math.sqrt(squares / 9 * (at @ np.linalg.inv(columns.T @ columns) @ at))
    made = cor.fit(points(speed, eps), law=parabola).predict(4.0)
    assert (made.high_95 - made.low_95) / 2 == pytest.approx(half, rel=0.02)


def test_balls_are_fitted_together_and_alone():
    random = np.random.default_rng(13)
    eps = np.concatenate([0.7 + 0.01 * random.standard_normal(10), 0.8 + 0.01 * random.standard_normal(10)])
    record = Points(np.linspace(1, 2, 20), eps, None, np.arange(20) + 2, np.repeat([0, 1], 10))
    rows = cor.fit(Data("two balls", record, ("a", "b")), law="constant").parameters
    assert list(rows.group) == ["", "a", "b"]
    assert rows.value == pytest.approx([eps.mean(), eps[:10].mean(), eps[10:].mean()])


@pytest.mark.parametrize("kind", ["points", "times"])
def test_outliers_are_named(kind):
    random = np.random.default_rng(14)
    clean, found = 0, 0
    for draw in range(8 if kind == "points" else 1):
        data = draw_points("constant", random, n=25) if kind == "points" else draw_times("constant", random, drops=8)
        values = data.record.eps if kind == "points" else data.record.time_s
        clean += bool(cor.fit(data, law="constant").groups[""].outliers)
        values[9] += 0.2 if kind == "points" else 4e-3
        named = [o for o in cor.fit(data, law="constant").groups[""].outliers if o.line == 11]
        found += len(named) == 1 and named[0].distance > 4
    assert clean <= 1 and found >= draw


def test_a_function_without_numbers_has_no_outliers_and_is_not_determined():
    def broken(speed, a=1.0):
        return speed * math.nan

    assert math.isnan(cor.fit(points([1.0, 2.0, 3.0], [0.8, 0.8, 0.7]), law=broken).parameters.value[0])
    for robust in (False, True):
        found = cor.fit({"speed_m_s": [1.0, 2.0, 3.0], "eps": [0.8, 0.8, 0.7]}, law=broken, robust=robust)
        assert math.isnan(found.parameters.value[0])


def mean_of(eps, sigma, bend):
    """Returns Huber's mean and the sum of the weights. bend: in sigma; infinity gives the weighted mean."""
    mean, weight = np.median(eps), 1 / sigma**2
    for _ in range(200):
        part = weight * np.minimum(1, bend * sigma / np.maximum(np.abs(eps - mean), 1e-300))
        mean = (part @ eps) / part.sum()
    return mean, part.sum()


def outliers_of_constant(eps, sigma):
    """Applies the rule of find_outliers for a constant with given errors, in closed forms."""
    n, out = eps.size, np.zeros(eps.size, bool)
    while out.sum() < 8 and (~out).sum() - 1 >= 3 * n // 4:
        z = np.where(out, 0, np.abs(eps - mean_of(eps[~out], sigma[~out], 1.345)[0]) / sigma)
        if (~out).sum() * 2 * stats.norm.sf(z.max()) > 0.05:
            break
        out[np.argmax(z)] = True
    while out.any():
        mean, weight = mean_of(eps[~out], sigma[~out], math.inf)
        spread = max((((eps - mean) / sigma)[~out] ** 2).sum() / ((~out).sum() - 1), 1)
        distance = (eps - mean) / np.sqrt(sigma**2 + 1 / weight)
        tail = (
            stats.f.sf(distance**2 / spread, 1, (~out).sum() - 1) if spread > 1 else 2 * stats.norm.sf(abs(distance))
        )
        back = out & (n * tail >= 0.01)
        if not back.any():
            break
        out[np.argmin(np.where(back, np.abs(distance), math.inf))] = False
    return [(k + 2, pytest.approx(distance[k], abs=1e-5)) for k in np.flatnonzero(out)]


def test_outliers_follow_closed_forms():
    random, lengths = np.random.default_rng(16), set()
    for draw in range(40):
        data = draw_points("constant", random, n=random.integers(8, 28), sigma=0.01, given=True)
        record, bad = data.record, random.uniform(size=data.record.eps.size) < 0.2
        record.eps[bad] += (random.uniform(-6, 6, bad.size) * record.sigma)[bad]
        record.sigma[:] *= 0.7 if draw % 2 else 1
        named = cor.fit(data, law="constant").groups[""].outliers
        assert [(o.line, o.distance) for o in named] == outliers_of_constant(record.eps, record.sigma)
        lengths.add(len(named))
    assert {0, 1, 2} <= lengths


def test_robust_intervals_of_a_constant():
    data = draw_points("constant", np.random.default_rng(17), n=30, given=True)
    eps, sigma = data.record.eps, data.record.sigma
    eps[[3, 9]] += 12 * sigma[[3, 9]]
    e = cor.fit(data, law="constant", robust=True).find()[1]
    assert e.theta[0] == pytest.approx(mean_of(eps, sigma, 1.345)[0], rel=1e-9)

    def q(theta):
        z = np.abs(eps - theta) / sigma
        return np.where(z < 1.345, z**2, 1.345 * (2 * z - 1.345)).sum()

    z = np.abs(eps - e.theta[0]) / sigma
    factor = (np.minimum(z, 1.345) ** 2).sum() / 29 / (np.mean(z <= 1.345))
    for end in e.intervals[0, 1]:
        assert q(end) - q(e.theta[0]) == pytest.approx(stats.norm.ppf(0.975) ** 2 * factor, rel=1e-6)


def test_a_loss_that_explains_nothing_is_zero():
    p = problem("wet constant", points([1.0, 2.0, 3.0, 4.0], [0.72, 0.71, 0.71, 0.7]))
    theta, minimum, found = intervals.find_intervals(p, np.array([0.71, p.low[1] + 0.5]))
    assert theta[1] == p.low[1] and found[1, 0, 0] == -math.inf and math.isfinite(found[1, 0, 1])


def test_outliers_need_scatter():
    """Rounded heights may have no scatter, or too little; outliers are then not judged."""
    for h0, h1 in ([100, 100, 50, 50], [64, 64, 32, 32]), ([100, 80, 60, 40], [64, 51.2, 38.4, 25.6]):
        exact = cor.fit({"h0_cm": h0, "h1_cm": h1}, law="constant")
        assert "without scatter" in " ".join(exact.remarks()) and "too few to judge any" in exact.verdict()
    data = {"h0_cm": [150, 120, 90, 60], "h1_cm": [110.9, 88.8, 66.6, 44.4]}
    assert not cor.fit(data, law="constant").groups[""].outliers


POSITIVE = "gravity drag_coefficient terminal_speed diameter air_density drop_height viscosity_liquid".split()


@pytest.mark.parametrize(
    "error, words, options",
    [
        (ValueError, "law: 'viscous' is not a model; allowed: all, viscoelastic", dict(law="viscous")),
        (ValueError, "law: 3 is not a model", dict(law=3)),
        (ValueError, r"law: \[\] names no model", dict(law=[])),
        (ValueError, "separator: 'space' is not a separator; allowed: comma", dict(separator="space")),
        *[(ValueError, f"{name}: 0 is not above 0", {name: 0}) for name in POSITIVE],
        (ValueError, "fit_drag: points contains speeds", dict(fit_drag=True)),
        (ValueError, "drag_coefficient needs diameter", dict(drag_coefficient=0.4, mass=1.0)),
        (ValueError, "terminal_speed and drag_coefficient exclude", dict(drag_coefficient=0.4, terminal_speed=9.0)),
        (ValueError, "poisson is missing: a contact of bodies needs young", dict(young=1e9)),
        (ValueError, "lighter than the air", dict(fit_drag=True, mass=1e-5, diameter=0.1)),
        (TypeError, "'colour' is not an argument", dict(colour=3)),
        (DataError, r"has 1 point of speed and eps \(eps = 0.8 at 1 m/s\); allowed: 2 or more", {}),
    ],
)
def test_wrong_options(error, words, options):
    with pytest.raises(error, match=words):
        cor.fit(points([1.0, 2.0], [0.8, 0.7]) if options else points([1.0], [0.8]), **options)
