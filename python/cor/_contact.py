# SPDX-License-Identifier: MIT
"""A contact in SI units, computed by cor/scene.h as in corgen contact."""

import math
import re
import warnings
from fractions import Fraction
from typing import Any, Dict, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._cor import ffi, lib
from ._evaluate import Array, CorWarning, address, caller, in_parts, like, ma, number, one_of, string
from .contact import Body

_NUMBERS = [string(option.name).replace("-", "_") for option in lib.cor_scene_options]
_LAWS = [string(lib.cor_law_name(law)) for law in range(lib.COR_LAW_ELASTIC_PLASTIC + 1)]
_ADHESION = ("none", "dmt", "jkr")
_DAMPINGS = "g_star beta zeta restitution damping_coefficient dissipation_time viscosity duration".split()


def raise_text(text: Any) -> None:
    """Raises an error with a sentence of C. Names of corgen's options are replaced by their names in Python."""
    raise ValueError(re.sub(r"--([a-z][a-z0-9-]*)", lambda name: name[1].replace("-", "_"), string(text)))


def option_number(name: str, value: Any, label: str = "") -> float:
    """Returns a number in the range of the argument with this name. The error names the label, or the argument."""
    option = ffi.addressof(lib.cor_scene_options, _NUMBERS.index(name))
    made = float(number(label or name, value))
    if not lib.cor_option_allows(option, made):
        raise ValueError(f"{label or name}: {value} is not {string(option.allowed)}")
    return made


def _exponents(elastic: Any, damping: Any) -> Tuple[int, int, int]:
    """Returns a, b and their common denominator."""
    made = []
    for name, value in {"elastic": elastic, "damping": damping}.items():
        try:
            made.append(Fraction(str(value)))
        except (ValueError, ZeroDivisionError):
            made.append(Fraction(-1))
        if not 0 <= made[-1] <= 24 or made[-1].numerator > 64 or made[-1].denominator > 16:
            raise ValueError(f"{name}: {value!r} is not a number from 0 to 24, such as '3/2' or 0.5, of at most 64/16")
    a, b = made
    whole = a.denominator * b.denominator // math.gcd(a.denominator, b.denominator)
    return int(a * whole), int(b * whole), whole


def _spring_of_engine(law: Optional[str], erp: Any, cfm: Any, time_step: Any) -> Dict[str, float]:
    """Returns K = ERP/(h CFM) and C = (1 - ERP)/CFM, computed from exact decimals, as in corgen."""
    given = {"erp": erp, "cfm": cfm, "time_step": time_step}
    values = [float(number(name, x)) for name, x in given.items() if x is not None]
    if law not in (None, "linear") or len(values) < 3 or not all(0 < x < math.inf for x in values) or values[0] > 1:
        raise ValueError("erp, cfm, time_step: give all three, above 0, with erp up to 1; only the law linear has them")
    e, c, h = (Fraction(repr(x)) for x in values)
    damping = {"zeta": 0.0} if e == 1 else {"damping_coefficient": float((1 - e) / c)}
    return {"stiffness": float(e / (h * c)), **damping}


class Contact:
    """A contact of two bodies in SI units, with all numbers that corgen contact computes.

    bodies: one cor.Body for two equal bodies; two, of which the second may be a wall (infinite radius and mass); or
    none if keywords describe the bodies. Keywords are the options of corgen contact, with _ for each hyphen and numbers
    in SI units. A keyword for damping replaces the dissipation times of the bodies.

        bodies      young, poisson, radius, density or mass; young_2, ...; wall=True; plate_thickness
        a spring    effective_mass with stiffness or duration; or bodies with law="linear", a speed `at` and
                    equivalent ("energy" or "duration"): the spring that matches Hertz's contact at this speed
        an engine   erp, cfm and time_step with effective_mass: the linear spring of implicit steps, as in ODE
        damping     dissipation_time, viscosity and bulk_viscosity, g_star, restitution and at, damping_coefficient,
                    beta and at, or zeta
        law         a name of cor.law.laws(), "plate" or "elastic-plastic"; or the exponents elastic and damping of
                    x'' + beta x^damping x' + x^elastic = 0, such as "3/2"
        effects     gravity; adhesion and adhesion_model ("dmt", "jkr"); yield_stress; viscosity_liquid, gap_outer,
                    gap_inner
        end         the end of contact at which restitution or duration was measured and eps is computed:
                    "zero_overlap" or "zero_force" ("surface" under a constant force); with JKR "tail", "largest_pull"

    Error bounds (cor/scene.h): COR_SCENE_MAX_ERROR; with a constant force COR_SCENE_PRESSED_ERROR, with JKR
    COR_JKR_EPS2_MAX_ERROR. Without a constant force, exponents must belong to a named law or be equal. For other
    exponents a ValueError refers to corgen contact, which can compute them.
    """

    def __init__(
        self,
        *bodies: Body,
        law: Optional[str] = None,
        elastic: Any = None,
        damping: Any = None,
        end: Optional[str] = None,
        wall: bool = False,
        adhesion_model: str = "none",
        equivalent: str = "none",
        erp: Optional[float] = None,
        cfm: Optional[float] = None,
        time_step: Optional[float] = None,
        **numbers: float,
    ) -> None:
        self._options = {"law": law, "elastic": elastic, "damping": damping, "end": end, "wall": wall}
        self._options.update(adhesion_model=adhesion_model, equivalent=equivalent, **numbers)
        self._options.update(erp=erp, cfm=cfm, time_step=time_step)
        if erp is not None or cfm is not None or time_step is not None:
            spring = _spring_of_engine(law, erp, cfm, time_step)
            if spring.keys() & numbers.keys():
                names = ", ".join(spring)
                raise ValueError(f"erp, cfm, time_step: they already determine {names}; leave out {names}")
            law, numbers = "linear", {**spring, **numbers}
        self._bodies = bodies
        self._scene = scene = ffi.new("struct cor_scene *")
        scene.number = [math.nan] * lib.COR_SCENE_NUMBERS
        index = one_of("law", law or "viscoelastic", _LAWS)
        scene.law = lib.cor_law_exponents[index]
        self._law = _LAWS[index]
        if elastic is not None or damping is not None:
            if law is not None:
                raise ValueError("law: give law, or elastic and damping, but not both")
            exponents = "3/2" if elastic is None else elastic, "1/2" if damping is None else damping
            scene.law.elastic, scene.law.damping, scene.law.denominator = _exponents(*exponents)
            self._law = "with elastic = {} and damping = {}".format(*exponents)
        scene.plate, scene.plastic = index == lib.COR_LAW_PLATE, index == lib.COR_LAW_ELASTIC_PLASTIC
        scene.adhesion_model = one_of("adhesion_model", adhesion_model, _ADHESION)
        scene.wall = bool(wall)
        self._fill_bodies(any(name in numbers for name in _DAMPINGS))
        for name, value in numbers.items():
            if name not in _NUMBERS:
                raise TypeError(f"{name!r} is not an argument; allowed: {', '.join(_NUMBERS)}")
            scene.number[_NUMBERS.index(name)] = option_number(name, value)
        pressed = "gravity" in numbers or scene.adhesion_model == lib.COR_ADHESION_DMT
        jkr = scene.adhesion_model == lib.COR_ADHESION_JKR
        self.ends = ("tail", "largest_pull") if jkr else ("zero_overlap", "surface" if pressed else "zero_force")
        scene.end = lib.COR_BOTH_ENDS if end is None else self._end(end)
        self._contacts = ffi.new("struct cor_scene_contact[]", lib.COR_SCENE_ENDS)
        count, fault = ffi.new("int *"), ffi.new("struct cor_scene_fault *")
        kind = one_of("equivalent", equivalent, ("none", "energy", "duration"))
        if kind:
            self._scene, hertz = ffi.new("struct cor_scene *"), ffi.new("struct cor_scene_contact *")
            if lib.cor_scene_equivalent(self._scene, hertz, fault, scene, kind) != lib.COR_OK:
                self._raise(fault)
            scene = self._scene
        if lib.cor_scene_contacts(self._contacts, count, fault, scene) != lib.COR_OK:
            self._raise(fault)
        self._count = int(count[0])

    @classmethod
    def from_restitution(cls, body_1: Body, body_2: Body, eps: float, speed_m_s: float, end: str) -> "Contact":
        """Returns the contact of two bodies whose restitution is eps at an impact speed, m/s, and an end of contact.
        The dissipation times of the bodies are ignored."""
        return cls(body_1, body_2, restitution=eps, at=speed_m_s, end=end)

    def __repr__(self) -> str:
        given = {name: value for name, value in self._options.items() if value not in (None, False, "none")}
        plain = {name: value.item() if isinstance(value, np.generic) else value for name, value in given.items()}
        words = [repr(body) for body in self._bodies] + [f"{name}={value!r}" for name, value in plain.items()]
        return f"Contact({', '.join(words)})"

    def __reduce__(self) -> Tuple[Any, ...]:
        return _made, (self._bodies, self._options)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Contact) and self.__reduce__() == other.__reduce__()

    def __hash__(self) -> int:
        return hash(repr(self))

    def _fill_bodies(self, damped: bool) -> None:
        if len(self._bodies) > 2:
            raise ValueError(f"contact: {len(self._bodies)} bodies; allowed: one or two")
        for k, body in enumerate(self._bodies):
            if getattr(body, "_struct", "") != "cor_body":
                raise TypeError(f"contact: {type(body).__name__} is not a cor.Body")
            wall = math.isinf(body.radius_m) and math.isinf(body.mass_kg)
            if wall and k == 0:
                raise ValueError("contact: the second body may be a wall, not the first")
            values = {"YOUNG": body.young_modulus_pa, "POISSON": body.poisson_ratio}
            values.update({} if wall else {"RADIUS": body.radius_m, "MASS": body.mass_kg})
            values.update({} if damped else {"DISSIPATION_TIME": body.dissipation_time_s})
            self._scene.wall |= wall
            for name, value in values.items():
                self._scene.number[getattr(lib, f"COR_SCENE_{name}") + (lib.COR_SCENE_BODY if k else 0)] = value

    def _end(self, end: Optional[str] = None) -> int:
        """Returns the index of an end. The default is the end that was given for the contact."""
        if end is None and (self._scene.end >= 0 or not lib.cor_scene_ends_differ(self._contacts)):
            return max(int(self._scene.end), 0)
        name = re.sub("[- ]", "_", str(end))
        if name not in self.ends:
            wrong = "is missing" if end is None else f"{end!r} is not an end of this contact"
            raise ValueError(f"end: {wrong}; allowed: {', '.join(self.ends)}")
        return self.ends.index(name)

    def _raise(self, fault: Any) -> None:
        if fault.fault == lib.COR_FAULT_SOLVER:
            raise ValueError(
                f"elastic, damping: the law {self._law} has no functions here; use corgen contact --elastic A "
                f"--damping B (allowed: {', '.join(_LAWS)}, equal exponents; under gravity or dmt adhesion any law)"
            )
        text = ffi.new("char[]", lib.COR_SCENE_FAULT_TEXT)
        lib.cor_scene_fault_text(text, len(text), fault, self._law.encode(), ffi.NULL)
        raise_text(text)

    def _one(self) -> Any:
        """Returns the contact in C. Raises ValueError if there are two, because eps was measured at an unknown end."""
        if self._count > 1:
            raise ValueError(f"end: the end of the measured contact is missing; allowed: {', '.join(self.ends)}")
        return self._contacts[0]

    @property
    def quantities(self) -> Dict[str, float]:
        """The quantities of the contact that do not depend on the speed, with the names and units of corgen contact."""
        contact, found = self._one(), {}
        for known in lib.cor_scene_quantities:
            value = lib.cor_scene_quantity(ffi.addressof(contact), known.number)
            name = string(known.name).replace("zero_overlap", self.ends[0]).replace("zero_force", self.ends[1])
            found.update({} if math.isnan(value) else {name: value})
        step, adhesion = lib.cor_scene_rayleigh_step_s(self._scene), self._scene.number[lib.COR_SCENE_ADHESION]
        tabor = lib.cor_scene_tabor_number(ffi.addressof(contact), adhesion, 3e-10)  # COR_TABOR_DISTANCE_M
        more = {"rayleigh_time_step": step, "tabor_number": tabor}
        return {**found, **{name: value for name, value in more.items() if not math.isnan(value)}}

    def _rows(self, speed_m_s: ArrayLike, end: int) -> Tuple[Array, Array]:
        """Returns the speeds and a row of results for each: eps at one end or, with COR_BOTH_ENDS, all results."""
        contact = self._one()
        speeds = np.array(speed_m_s, np.float64, order="C")
        wrong = speeds[~((speeds > 0) & np.isfinite(speeds)) & ~ma.getmaskarray(speed_m_s)]
        if wrong.size:
            raise ValueError(f"speed_m_s: {wrong[0]} is not above 0 and finite")
        columns = lib.COR_IMPACT_COLUMNS if end == lib.COR_BOTH_ENDS else 1
        rows = np.full((*speeds.shape, columns), math.nan)

        def run(first: int, count: int) -> None:
            at = address(speeds) + first, address(rows, True) + first * columns
            status = lib.cor_loop_impacts(ffi.addressof(contact), *at, count, end)
            if status != lib.COR_OK:
                self._raise(ffi.new("struct cor_scene_fault *", {"fault": status}))

        in_parts(speeds.size, run)
        onset = contact.yield_speed_m_s + contact.liquid_speed_m_s
        if contact.yield_speed_m_s > 0 and not contact.plastic and (speeds > onset).any():
            text = f"the bodies yield above {onset:.4g} m/s; this law does not describe yield; use elastic-plastic"
            warnings.warn(text, CorWarning, caller())
        return speeds, rows

    def eps(self, speed_m_s: ArrayLike, end: Optional[str] = None) -> Any:
        """Returns the restitution coefficient at impact speeds, m/s. end: by default the contact's argument `end`."""
        result = self._rows(speed_m_s, self._end(end))[1][..., 0]
        narrow = np.asarray(speed_m_s).dtype.kind == "f" and np.asarray(speed_m_s).itemsize < 8
        return like([speed_m_s], result.astype(np.float32 if narrow else np.float64, copy=False)[()])

    def eps_zero_overlap(self, speed_m_s: ArrayLike) -> Any:
        """Returns eps(speed_m_s, "zero_overlap")."""
        return self.eps(speed_m_s, "zero_overlap")

    def eps_zero_force(self, speed_m_s: ArrayLike) -> Any:
        """Returns eps(speed_m_s, "zero_force")."""
        return self.eps(speed_m_s, "zero_force")

    def impacts(self, speed_m_s: ArrayLike, steps: float = 50) -> Any:
        """Returns a record for each impact speed, m/s, with the columns of corgen contact.

        time_step_s is the shortest of all durations, divided by `steps`. contact_radius_m and max_pressure_pa follow
        Hertz; they are NaN without bodies and with JKR. Durations are infinite if the bodies never part, and NaN
        without mass and stiffness."""
        if not 1 <= number("steps", steps) < math.inf:
            raise ValueError(f"steps: {steps} is not a finite number, 1 or more")
        speeds, rows = self._rows(speed_m_s, lib.COR_BOTH_ENDS)
        low, high = self.ends
        names = ["beta", f"eps_{low}", f"eps_{high}", f"duration_s_{low}", f"duration_s_{high}", "max_overlap_m"]
        names += ["max_force_n", "contact_radius_m", "max_pressure_pa"]
        table = np.zeros(speeds.shape, [(name, np.float64) for name in ("speed_m_s", *names, "time_step_s")])
        table["speed_m_s"] = speeds
        for k, name in enumerate(names):
            table[name] = rows[..., k]
        known = rows[..., 3:5][np.isfinite(rows[..., 3:5])]
        table["time_step_s"] = known.min() / steps if known.size else math.nan
        mask = ma.getmaskarray(speed_m_s)
        return ma.array(table, mask=mask) if mask.any() else table.view(np.recarray)[()]

    def oblique(
        self,
        angle_degrees: ArrayLike,
        speed_m_s: ArrayLike,
        friction: float,
        tangential: str = "displacement",
        tangential_stiffness: Optional[float] = None,
        tangential_damping: Optional[float] = None,
        end: Optional[str] = None,
    ) -> Any:
        """Returns a record for each oblique impact, with the columns of corgen contact --friction --angle.

        angle_degrees: between the normal and the velocity of the contact point. speed_m_s: this velocity's normal part.
        tangential: a model of corgen contact --tangential, such as "mindlin_rescale", or the name of a simulator.
        tangential_stiffness: N/m^(1+p), where the stiffness is proportional to overlap^p; by default Mindlin's.
        tangential_damping: tangential damper divided by normal damper; default: 0, for a model without a spring 1.
        COR_OBLIQUE_ERROR bounds the error of tangential_restitution, which is NaN if the bodies stay together.
        """
        contact = self._one()
        models = [string(model.name) for model in lib.cor_tangential_models]
        simulator = lib.cor_simulator_named(tangential.encode())
        linear = contact.law.elastic == contact.law.denominator
        suits = [linear == bool(model.constant_stiffness) for model in lib.cor_tangential_models]
        has = [k for k in range(len(models)) if simulator and simulator.tangential >> k & 1]
        found = [k for k, name in enumerate(models) if name == tangential] or [k for k in has if suits[k]] or has
        if not found:
            allowed = ", ".join(models)
            raise ValueError(
                f"tangential: {tangential!r} is not a tangential model; allowed: {allowed}, or the name of a simulator"
            )
        viscous = lib.cor_tangential_models[found[0]].memory == lib.COR_REMEMBERS_NOTHING
        if (
            tangential_stiffness is None
            and not viscous
            and (math.isnan(contact.radius_m) or lib.cor_tangential_models[found[0]].constant_stiffness)
        ):
            raise ValueError(f"tangential_stiffness of {models[found[0]]} is missing; give it in N/m^(1+p)")
        one, two = (lib.cor_scene_body(self._scene, k) for k in (1, 2))
        kappa = lib.cor_tangential_kappa(
            one.young_modulus_pa, one.poisson_ratio, two.young_modulus_pa, two.poisson_ratio
        )
        spring = 0 if viscous else contact.stiffness / 3.5 * kappa
        spring = spring if tangential_stiffness is None else number("tangential_stiffness", tangential_stiffness)
        ratio = (
            (1 if viscous else 0) if tangential_damping is None else number("tangential_damping", tangential_damping)
        )
        damper = ratio * lib.cor_scene_damping(ffi.addressof(contact), lib.COR_SCENE_DAMPING_COEFFICIENT)
        angles, speeds = np.broadcast_arrays(np.asarray(angle_degrees, float), np.asarray(speed_m_s, float))
        names = ("speed_m_s", "angle_degrees", "tangential_speed_m_s", "tangential_restitution")
        kinds = [(name, np.float64) for name in (*names, "rebound_angle_degrees", "spin_rad_s")] + [("regime", "U5")]
        table, scaled, made = np.zeros(angles.shape, kinds), ffi.new("struct cor_tangential *"), self._end(end)
        impact, mu = ffi.new("struct cor_oblique_impact *"), number("friction", friction)
        spin = 5 / 7 * contact.mass_kg / one.mass_kg / one.radius_m
        for at, angle in np.ndenumerate(angles):
            if not 0 <= angle < 90:
                raise ValueError(f"angle_degrees: {angle} is not an angle from 0 to below 90 degrees")
            speed, u = float(speeds[at]), math.tan(math.radians(angle)) * float(speeds[at])
            if not 0 < speed < math.inf:
                raise ValueError(f"speed_m_s: {speed} is not above 0 and finite")
            if lib.cor_scene_tangential_scaled(
                scaled, ffi.addressof(contact), found[0], spring, damper, speed
            ) or lib.cor_scene_oblique(
                impact, ffi.addressof(contact), scaled, mu, speed, math.tan(math.radians(angle)), made
            ):
                raise ValueError(f"oblique: {speed} m/s, {angle} degrees or friction {mu} is out of range")
            regime = ("rest", "stick", "slip", "both")[impact.regime]
            rebound = math.degrees(math.atan(impact.rebound_tangent))
            table[at] = (speed, angle, u, -impact.restitution, rebound, u * (1 - impact.restitution) * spin, regime)
        return table.view(np.recarray)[()]


def _made(bodies: Tuple[Body, ...], options: Dict[str, Any]) -> Contact:
    return Contact(*bodies, **options)
