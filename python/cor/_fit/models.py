# SPDX-License-Identifier: MIT
"""The models of restitution that a fit compares.

Several models are one curve eps(speed) with different parameters. A thin plate has the eps of a viscoelastic sphere at
zero overlap, and eps is constant for the linear and Tsuji's law. A curve is fitted once, in internal coordinates theta;
a model converts them to its parameters.
"""

import inspect
import math
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from .. import law
from .._contact import Contact
from .._cor import ffi, lib
from .._evaluate import address
from .data import Floats

Range = Callable[[float, float], Tuple[float, float]]  # ln(least), ln(largest speed) -> range of a coordinate
BODY = ("young", "poisson", "radius", "density", "mass")
BODIES = (*BODY, *(f"{name}_2" for name in BODY))


@dataclass(frozen=True)
class Curve:
    """eps as a function of the coordinates theta and of ln(speed/(m/s)); both may be arrays of one shape.

    kinds, one for each coordinate: "log", a logarithm whose ends of range mean 0 or infinity; "unit", from 0 to 1;
    "free", any number. start: the method that finds starts for the search of the minimum."""

    name: str
    eps: Callable[[Any, Floats], Any]
    kinds: Tuple[str, ...]
    ranges: Tuple[Range, ...]
    start: str  # "lines", "scan", "grid" or "given"
    dry: Optional["Curve"] = None  # the curve without adhesion or liquid
    given: Tuple[float, ...] = ()  # start values of a user's function


# ---- curves of one coordinate ----


def _law(name: str, end: str, q: float) -> Curve:
    """Return the curve eps(beta), beta = exp(theta_0) (speed/(m/s))^q. At the ends eps is 1 or 0 within 1e-8."""
    number, at_end = law.laws().index(name), law.ends().index(end)

    def eps(theta: Any, x: Floats) -> Any:
        beta = np.exp(theta[0] + q * x)
        result = np.empty_like(beta)
        lib.cor_law_array(number, at_end, lib.COR_EPS, address(beta), address(result, True), beta.size)
        return result

    def range_of(least: float, most: float) -> Tuple[float, float]:
        return math.log(1e-9) - max(q * least, q * most), math.log(1e9) - min(q * least, q * most)

    return Curve(f"{name} {end}", eps, ("log",), (range_of,), "scan")


_unit_yield = ffi.new("struct cor_scene_contact *")
_unit_yield[0] = Contact(
    young=1e9, poisson=0.3, radius=1e-3, density=1e3, law="elastic-plastic", yield_stress=1e6
)._one()
_unit_yield.yield_speed_m_s = 1


def _plastic_eps(theta: Any, x: Floats) -> Any:
    """Return eps of spheres that yield above the speed exp(theta_0)."""
    ratio = np.exp(x - theta[0])
    result = np.empty_like(ratio)
    status = lib.cor_loop_impacts(_unit_yield, address(ratio), address(result, True), ratio.size, 0)
    return result if status == lib.COR_OK else np.full_like(ratio, math.nan)


def _walton_braun_eps(theta: Any, x: Floats) -> Any:
    return 1 / np.sqrt(1 + np.exp(x - theta[0]))


def _speed(down: float, up: float) -> Range:
    """Return the range of the logarithm of a speed."""
    return lambda least, most: (least + math.log(down), most + math.log(up))


def _within(low: float, high: float) -> Range:
    return lambda least, most: (low, high)


_unit = _within(0.0, 1.0)

# ---- curves of two coordinates ----


def _adhesive(dry: Curve) -> Curve:
    """Return the curve with work of separation lost at the rebound: (eps^2 - (v_s/v)^2)^(1/2), v_s = exp(theta_1)."""

    def eps(theta: Any, x: Floats) -> Any:
        inside, ratio = dry.eps(theta, x), np.exp(theta[1] - x)
        return np.sqrt(np.maximum((inside - ratio) * (inside + ratio), 0))

    return Curve(f"adhesive {dry.name}", eps, (*dry.kinds, "log"), (*dry.ranges, _speed(1e-6, 1)), "grid", dry)


def _wet(dry: Curve) -> Curve:
    """Return the curve with a speed s = exp(theta_1) lost to a liquid on each way: (eps(v - s) (v - s) - s)/v."""

    def eps(theta: Any, x: Floats) -> Any:
        ratio = np.exp(theta[1] - x)
        left = np.where(ratio < 1, 1 - ratio, 1)
        inside = dry.eps(theta, x + np.log(left))
        return np.where(ratio < 1, np.maximum(inside * left - ratio, 0), 0)

    return Curve(f"wet {dry.name}", eps, (*dry.kinds, "log"), (*dry.ranges, _speed(1e-12, 1)), "grid", dry)


CONSTANT = Curve("constant", lambda theta, x: theta[0] + 0 * x, ("unit",), (_unit,), "lines")
POWER_LAW = Curve(
    "power-law",
    lambda theta, x: np.exp(np.minimum(theta[0] + theta[1] * x, 0)),
    ("free", "free"),
    (_within(-1e4, 1e4), _within(-100, 100)),
    "lines",
)
SPHERE_ZERO_OVERLAP = _law("viscoelastic", "zero-overlap", 0.2)
SPHERE_ZERO_FORCE = _law("viscoelastic", "zero-force", 0.2)
PLASTIC = Curve("elastic-plastic", _plastic_eps, ("log",), (_speed(1e-36, 1),), "scan")
WALTON_BRAUN = Curve("walton-braun", _walton_braun_eps, ("log",), (_speed(1e-18, 1e9),), "scan")
EXPONENTIAL = Curve(
    "exponential",
    lambda theta, x: theta[0] + (1 - theta[0]) * np.exp(-np.exp(x - theta[1])),
    ("unit", "log"),
    (_unit, _speed(0.02, 1e9)),
    "grid",
    CONSTANT,
)
STOKES = Curve(
    "stokes",
    lambda theta, x: theta[0] * np.maximum(1 - np.exp(theta[1] - x), 0),
    ("unit", "log"),
    (_unit, _speed(1e-12, 1)),
    "grid",
    CONSTANT,
)


def function_curve(function: Callable[..., Any]) -> Curve:
    """Return the curve of a user's function eps(speed, a=0.9, b=0.1). Its defaults are the start."""
    parameters = list(inspect.signature(function).parameters.values())[1:]
    if not parameters or any(p.kind not in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) for p in parameters):
        raise ValueError(
            "function: it needs the speed and one or more parameters, for example def eps(speed, a=0.9, b=0.1)"
        )
    start = tuple(1.0 if p.default is p.empty else float(p.default) for p in parameters)

    def eps(theta: Any, x: Floats) -> Any:
        result = np.broadcast_to(np.asarray(function(np.exp(x), *theta), np.float64), x.shape)
        return np.where(np.isfinite(result), result, math.nan)

    n, everywhere = len(start), (_within(-1e30, 1e30),)
    return Curve(f"function {function.__name__}", eps, ("free",) * n, everywhere * n, "given", given=start)


# ---- bodies ----


class Bodies:
    """The bodies of the contact, if given, and the viscosity of a liquid between them."""

    def __init__(self, given: Dict[str, float], wall: bool = False, viscosity_liquid: Optional[float] = None) -> None:
        unknown = [name for name in given if name not in BODIES]
        if unknown:
            raise TypeError(f"{unknown[0]!r} is not an argument; allowed: {', '.join(BODIES)}")
        self.known = wall or any(name != "mass" for name in given)
        self.given, self.wall, self.viscosity = given, wall, viscosity_liquid
        if self.known:
            self.contact()

    def contact(self, **options: Any) -> Contact:
        """Return the contact of the bodies with the options, or with a dissipation time of 1 s."""
        left_out = "wall" if "plate_thickness" in options else "density_2" if self.wall else ""
        given: Dict[str, Any] = {name: min(value, 1e100) for name, value in self.given.items()}  # inf: rigid
        given = {name: value for name, value in {**given, "wall": self.wall}.items() if name != left_out}
        return Contact(**given, **(options or {"dissipation_time": 1.0}), end="zero_overlap")

    def quantity(self, name: str, **options: Any) -> float:
        return float(self.contact(**options).quantities[name])

    def has_plate(self) -> bool:
        dense = "density_2" in self.given or "density" in self.given
        return self.wall and dense and math.isfinite(self.given.get("young_2", 0.0))

    def stokes_at_1_m_s(self) -> float:
        """Return St = m v/(6 pi eta R^2) at 1 m/s, with the effective mass and radius."""
        mass, radius = self.quantity("effective_mass"), self.quantity("effective_radius")
        return mass / (6 * math.pi * (self.viscosity or 1.0) * radius**2)


# ---- models ----


@dataclass(frozen=True)
class Parameter:
    """A monotonic function of one coordinate."""

    name: str
    of_theta: Callable[[Any], Any]

    def value(self, theta: float) -> float:
        with np.errstate(all="ignore"):
            return float(self.of_theta(np.float64(theta)))


def _power(name: str, unit: float = 1.0, power: float = 1.0) -> Parameter:
    """Return the parameter (exp(theta)/unit)^power."""
    return Parameter(name, lambda theta: (np.exp(theta) / unit) ** power)


def _plain(name: str) -> Parameter:
    return Parameter(name, lambda theta: theta)


def _zeta(end: str) -> Parameter:
    return Parameter("zeta", lambda theta: law.value("linear", end, "damping-of-eps", theta))


def _g_star() -> Parameter:
    return _power("g_star_m_s", float(Contact(g_star=1.0, end="zero_overlap").quantities["beta_factor"]), -5)


WithBodies = Callable[[Bodies], Optional[Parameter]]


@dataclass(frozen=True)
class Model:
    """A curve with the parameters of a law. If bodies are known, with_bodies may return a new plain[replaced]."""

    name: str
    end: str  # "zero-overlap", "zero-force" or "both"
    curve: Curve
    plain: Tuple[Parameter, ...]
    with_bodies: Optional[WithBodies] = None
    replaced: int = 0
    is_contact: bool = True  # False: a formula without a law of contact

    @property
    def title(self) -> str:
        return self.name if self.end == "both" else f"{self.name} {self.end}"

    def parameters(self, bodies: Bodies) -> List[Parameter]:
        made = list(self.plain)
        known = self.with_bodies(bodies) if self.with_bodies and bodies.known else None
        if known:
            made[self.replaced] = known
        return made


def _models() -> List[Model]:
    ends = {"zero-overlap": SPHERE_ZERO_OVERLAP, "zero-force": SPHERE_ZERO_FORCE}
    g_star, adhesion, liquid = _g_star(), _power("adhesion_speed_m_s"), _power("liquid_speed_m_s")
    dry, zener = _plain("eps_dry"), _power("zener_lambda_at_1_m_s", 1.5)
    # Laws with the parameter 1, or 1e6 for the yield stress Y. The yield speed is proportional to Y^(5/2).
    plate = {"law": "plate", "plate_thickness": 1.0}
    dashpot = {"law": "hertz-dashpot", "damping_coefficient": 1.0}
    plastic = {"law": "elastic-plastic", "yield_stress": 1e6}
    of_bodies: Dict[str, WithBodies] = {
        "time": lambda b: _power("dissipation_time_s", b.quantity("beta_factor")),
        "plate": lambda b: (
            _power("plate_thickness_m", b.quantity("beta_factor", **plate), -0.5) if b.has_plate() else None
        ),
        "dashpot": lambda b: _power("damping_coefficient_n_s_m", b.quantity("beta_factor", **dashpot)),
        "stress": lambda b: _power("yield_stress_pa", b.quantity("yield_speed", **plastic) / 1e15, 0.4),
        "stokes": lambda b: _power("critical_stokes_number", 1 / b.stokes_at_1_m_s()) if b.viscosity else None,
    }
    time = of_bodies["time"]
    ratio = Parameter("stiffness_ratio", lambda theta: theta * theta)
    made = [Model("viscoelastic", end, curve, (g_star,), time) for end, curve in ends.items()]
    made.append(Model("plate", "zero-overlap", SPHERE_ZERO_OVERLAP, (zener,), of_bodies["plate"]))
    made.append(Model("constant", "both", CONSTANT, (_plain("eps"),)))
    made += [Model(name, end, CONSTANT, (_zeta(end),)) for name in ("linear", "tsuji") for end in ends]
    crossley = _law("hunt-crossley", "zero-overlap", 1)
    made.append(Model("hunt-crossley", "both", crossley, (_power("dissipation_s_m"),)))
    for end in ends:
        curve = _law("hertz-dashpot", end, -0.2)
        made.append(Model("hertz-dashpot", end, curve, (_power("beta_at_1_m_s"),), of_bodies["dashpot"]))
    at_1 = _power("eps_at_1_m_s")
    made.append(Model("power-law", "both", POWER_LAW, (at_1, _plain("exponent")), is_contact=False))
    made.append(Model("elastic-plastic", "both", PLASTIC, (_power("yield_speed_m_s"),), of_bodies["stress"]))
    for name, loss, speed in (("adhesive", _adhesive, adhesion), ("wet", _wet, liquid)):
        made.append(Model(name, "both", loss(CONSTANT), (dry, speed)))
        made += [Model(f"{name}-viscoelastic", end, loss(of), (g_star, speed), time) for end, of in ends.items()]
    decay = (_plain("eps_inf"), _power("decay_speed_m_s"))
    made.append(Model("exponential", "both", EXPONENTIAL, decay, is_contact=False))
    made.append(Model("stokes", "both", STOKES, (dry, _power("critical_speed_m_s")), of_bodies["stokes"], 1))
    made.append(Model("walton-braun", "both", CONSTANT, (ratio,)))
    made.append(Model("walton-braun-variable", "both", WALTON_BRAUN, (_power("hardening_speed_m_s"),)))
    return made


MODELS = _models()


def function_model(function: Callable[..., Any]) -> Model:
    names = list(inspect.signature(function).parameters)[1:]
    return Model(function.__name__, "both", function_curve(function), tuple(map(_plain, names)), is_contact=False)


def choose(names: Any, end: Optional[str]) -> List[Model]:
    """Return the models with this end. names: "viscoelastic,power-law", a list, or "all"; a function is a model, too"""
    allowed = list(dict.fromkeys(model.name for model in MODELS))
    chosen = names.split(",") if isinstance(names, str) else names if isinstance(names, (list, tuple)) else [names]
    for name in chosen:
        if not callable(name) and name not in ("all", *allowed):
            raise ValueError(
                f"law: {name!r} is not a model; allowed: all, {', '.join(allowed)}, or several, such as "
                "viscoelastic,power-law"
            )
    if end not in (None, "zero-overlap", "zero-force"):
        raise ValueError(f"end: {end!r} is not an end of contact; allowed: zero-overlap, zero-force")
    made = [m for m in MODELS if ("all" in chosen or m.name in chosen) and (end is None or m.end in (end, "both"))]
    made += [function_model(name) for name in chosen if callable(name)]
    if not made:
        raise ValueError(
            f"law: {names!r} names no model; allowed: all, or names of models"
            if not chosen
            else f"end: no model of law {names} ends at {end}; allowed: another end or model"
        )
    return made
