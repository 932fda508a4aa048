# SPDX-License-Identifier: MIT
"""Computes the audit's rows from the contacts of a deck. libcor_scene computes laws, ends, maps and step errors."""

import contextlib
import math
from importlib import import_module
from typing import Any, Callable, Dict, List, Optional, Set, Tuple

from .._cor import ffi, lib
from .._evaluate import string
from .deck import MAX_CONTACTS, NAN, Body, Contact, Deck, DeckError, Options, Repair, Row, Spring

# Simulators with a reader: its module and function, and the patterns that identify its inputs
SIMULATORS = {
    "liggghts": ("lammps", "read_liggghts", ("property/global", "particletemplate/", "pair_style gran model")),
    "lammps": ("lammps", "read_lammps", ("pair_style", "wall/gran")),
    "yade": ("yade", "read", ("O.engines", "Ip2_", "ViscElMat(", "O.materials")),
    "mujoco": ("xml", "read_mujoco", ("<mujoco",)),
    "mfix": ("text", "read_mfix", ("DES_EN_", "des_en_", "Des_En_")),
    "gazebo": ("xml", "read_gazebo", ("<sdf",)),
    "lethe": ("text", "read_lethe", ("restitution coefficient particles", "subsection lagrangian physical")),
    "pfc": ("text", "read_pfc", ("dp_nratio", "contact cmat", "cmat default")),
    "mercurydpm": ("text", "read_mercurydpm", ("speciesHandler", "AndRestitutionCoeff", "Mercury3D", "Mdouble")),
    "kratos": ("text", "read_kratos", ('"COEFFICIENT_OF_RESTITUTION"', '"DAMPING_GAMMA"', '"material_relations"')),
}
# Models that other versions of the simulator have in place of a model
_OTHER = {
    "LAMMPS_HERTZ_TSUJI": "LAMMPS_HERTZ_TSUJI_2026",
    "LAMMPS_HOOKE_TSUJI": "LAMMPS_HOOKE_TSUJI_2026",
    "YADE_EN": "YADE_EN_UNTIL_2023",
}
_COHESIVE = 600  # largest number of contacts with cohesion that are integrated for a deck
_PHASES, _PHASES_LEAST, _STEPS_OF_PHASES = 128, 16, 2**20  # of cor_scene_step_error: most, least phases; most steps
_STEPS_IN_ALL = 2e8  # largest number of steps for a deck; they take some seconds
_STEPS_OF_SEARCH, _LEAST_SEARCHED = 2e7, 1e-4  # of cor_scene_step_for: steps of a call, least tolerance
_LINEAR = (Spring.HOOKE, Spring.CHARACTERISTIC, Spring.CONTACT_TIME, Spring.PER_MASS)
_SIZES = (", least", ", largest")
_NEVER = 1e5  # m/s, Gazebo's default threshold; no impact is faster


def model_of(name: str) -> Any:
    """Returns the model of cor_simulators with this id, which is given without COR_."""
    return lib.cor_simulator_model(getattr(lib, f"COR_{name}"))


def integrator_of(simulator: str) -> int:
    """Returns the enum cor_integrator of a simulator."""
    for i in range(lib.cor_simulator_count):
        if string(lib.cor_simulators[i].name) == simulator:
            return int(lib.cor_simulators[i].integrator)
    return int(lib.COR_NO_INTEGRATOR)


def _inverse_mass(body: Body, size: int) -> float:
    if body.wall or body.held:
        return 0.0
    mass = body.mass[size] if body.mass else 4 * math.pi / 3 * body.radius[size] ** 3 * body.density
    return 1 / mass if mass > 0 else NAN


def _over(numerator: float, denominator: float) -> float:
    return numerator / denominator if denominator != 0 else NAN


def scene_of(contact: Contact, size: int = 0) -> Any:
    """Returns a struct cor_scene_contact with mass, stiffness and radius of a contact, in the deck's units."""
    bodies = contact.bodies
    scene = ffi.new("struct cor_scene_contact *")
    mass = _over(1, sum(_inverse_mass(b, size) for b in bodies))
    radius = _over(1, sum(0 if b.wall and math.isnan(b.radius[size]) else _over(1, b.radius[size]) for b in bodies))
    modulus = _over(1, sum(_over(1 - b.poisson**2, b.young) for b in bodies))
    stiffness, root = contact.stiffness, math.sqrt(radius) if radius > 0 else NAN
    if contact.spring is Spring.HERTZ:
        stiffness *= root
    elif contact.spring is Spring.MATERIAL:
        stiffness = 4 / 3 * modulus * root
    elif contact.spring is Spring.CHARACTERISTIC:
        elastic = 16 / 15 * root * modulus
        ratio = _over(mass * contact.spring_speed**2, elastic)
        stiffness = elastic * ratio**0.2 if ratio >= 0 else NAN
    elif contact.spring is Spring.CONTACT_TIME:
        mass = 1.0 if math.isnan(mass) else mass
        e = math.log(contact.number) if 0 < contact.number < math.inf else NAN
        stiffness = mass * (math.pi**2 + e**2) / contact.stiffness**2 if contact.stiffness > 1e-48 else NAN
        stiffness *= contact.zeta_factor**2
    elif contact.spring is Spring.PER_MASS:
        mass = 1.0
    elif contact.spring is Spring.NONE:
        stiffness = NAN
    scene.mass_kg, scene.radius_m, scene.stiffness, scene.damping = mass, radius, stiffness, NAN
    return scene


def _is_moderate(*values: float) -> bool:
    """True if all values are unknown, 0, or from 1e-48 to 1e48, so that no formula leaves the range of doubles."""
    return all(math.isnan(x) or x == 0 or 1e-48 <= x <= 1e48 for x in values)


def _rebound(change: Callable[[float, float], float], v: float, h: float, most: float = math.inf) -> float:
    """Returns the rebound speed of an impact at the speed v: 0 if the bodies stick, NaN if the overlap exceeds `most`.
    Uses Runge-Kutta steps of h. change: returns the acceleration at an overlap and its velocity."""
    x = 0.0
    for _ in range(100000):
        a1 = change(x, v)
        a2 = change(x + h / 2 * v, v + h / 2 * a1)
        a3 = change(x + h / 2 * (v + h / 2 * a1), v + h / 2 * a2)
        a4 = change(x + h * (v + h / 2 * a2), v + h * a3)
        y, w = x + h * (v + h / 6 * (a1 + a2 + a3)), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
        if y <= 0:
            return -(v + (w - v) * x / (x - y))
        if w > 0 > v or y > most:  # the bodies turn inward again, or pass each other
            return 0.0 if y <= most else NAN
        x, v = y, w
    return 0.0


def _damped_pull(zeta: float, d: float) -> float:
    """Returns eps at zero overlap of a linear dashpot, with each force against the motion multiplied by 1 + d, and each
    force along the motion by 1 - d. On the way out the force changes its sign."""

    def change(x: float, v: float) -> float:
        force = x + 2 * zeta * v
        return -force * (1 + math.copysign(d, force * v))

    return _rebound(change, 1.0, 1e-3 / max(1.0, zeta))


class _Audit:
    def __init__(self, deck: Deck, options: Options) -> None:
        self.deck, self.options = deck, options
        self.version = lib.cor_simulator_version(options.version.encode()) if options.version else 0
        self.integrator = integrator_of(deck.simulator)
        self.steps_left, self.cohesive_left = _STEPS_IN_ALL, _COHESIVE
        self.errors: Dict[Tuple[Any, ...], Tuple[float, float]] = {}
        self.needed: Dict[Tuple[Any, ...], float] = {}

    # ---- one contact at one speed ----

    def solve(self, row: Row, contact: Contact, model: Any, scene: Any, speed: float, ratio: float = 1) -> int:
        """Sets end, law, damping, eps and duration, in the deck's units. Returns the end. ratio: the mass that sets the
        damping divided by the mass that moves."""
        end = lib.COR_END_ZERO_FORCE if contact.limited else model.end
        linear = contact.spring in _LINEAR
        law = lib.COR_LAW_LINEAR if model.law == lib.COR_LAW_TSUJI and linear else model.law
        scene.law = lib.cor_law_exponents[law] if law < lib.COR_LAW_IMPULSE else scene.law
        constant = law >= lib.COR_LAW_IMPULSE or lib.cor_scene_speed_exponent(scene) == 0
        row.end, row.law = string(lib.cor_end_names[end]), string(lib.cor_law_name(model.law))
        if not model.damping_of_e:
            number = contact.number  # 0: no damping, even if mass and stiffness are unknown
            damping = model.damping_of_number(model, number, scene, speed) if number != 0 else 0.0
        elif model.least <= contact.number <= model.most:
            damping = model.damping_of_e(contact.number) * contact.zeta_factor
        else:
            return int(end)
        if damping != 0 and ratio != 1:
            exponents = scene.law.damping + scene.law.denominator, scene.law.elastic + scene.law.denominator
            damping *= ratio ** (1 - exponents[0] / exponents[1])
            scene.mass_kg /= ratio
        row.damping = damping
        if not 0 <= damping < math.inf or (math.isnan(speed) and not constant and damping != 0):
            return int(end)
        if contact.solimp is not None and contact.solimp[0] != contact.solimp[1]:
            row.damping = NAN  # damping depends on the overlap
            if not math.isnan(speed):
                row.realised = self.mujoco(contact, scene, damping, speed, 0.0)
            return int(end)
        if contact.cohesion[0] == "jkr":
            end, scene.adhesion_j_m2 = lib.COR_JKR_LARGEST_PULL, contact.cohesion[1]
            row.end = "the largest pull"
        elif contact.cohesion[0] == "dmt":
            scene.force_n = 2 * math.pi * contact.cohesion[1] * scene.radius_m
        if contact.cohesion[0] and math.isnan(speed):
            return int(end)
        at = 1.0 if math.isnan(speed) else speed
        scene.damping = damping if constant else damping * at ** -lib.cor_scene_speed_exponent(scene)
        if end >= lib.COR_SCENE_ENDS:
            never = contact.number == 0 or contact.threshold >= _NEVER  # eps is 0 at any speed
            row.realised = 0.0 if never or speed <= contact.threshold else lib.cor_law_eps(model.law, end, damping)
            if contact.threshold > 0:
                row.realised = NAN if math.isnan(speed) and not never else row.realised
                row.advice += f" eps is 0 up to the threshold, {contact.threshold:.6g} m/s."
            return int(end)
        impact, eps = ffi.new("struct cor_scene_impact *"), ffi.new("double *")
        if lib.cor_scene_needs_solver(scene) and not contact.cohesion[0]:
            # libcor integrates only under a force: set a negligible one
            scene.force_n = 1e-13 * scene.mass_kg * at / lib.cor_scene_elastic_duration_s(scene, at)
        if lib.cor_scene_impact(impact, scene, at) == lib.COR_OK:
            row.realised = impact.eps[end]
            row.duration_s = NAN if math.isnan(speed) and not linear else impact.duration_s[end]
        elif lib.cor_scene_eps(eps, scene, at, end) == lib.COR_OK:
            row.realised = eps[0]
        if contact.luding is not None:
            row.end, row.damping = string(lib.cor_end_names[lib.COR_END_ZERO_OVERLAP]), NAN
            row.realised = row.duration_s = NAN
            with contextlib.suppress(ArithmeticError):
                row.realised = self.luding(contact, scene.mass_kg, speed, row.size)
        elif contact.bond != 0:
            d, radii = contact.global_damping, [b.radius[row.size] for b in contact.bodies]
            row.realised = row.duration_s = NAN
            with contextlib.suppress(ArithmeticError):
                softness = sum(1 / (2 * b.young * r) for b, r in zip(contact.bodies, radii))
                loss = (contact.bond * min(radii) ** 2) ** 2 * softness / scene.mass_kg / speed**2
                square = (1 - d) / (1 + d) - (1 + d) * loss
                row.realised = math.sqrt(max(square, 0.0)) if square == square else NAN
            row.advice += " eps includes the pull that breaks the bond, and the damping of all forces."
        elif contact.global_damping != 0:
            self.damp(row, contact, law, end, damping)
        if contact.cohesion[0].startswith("sjkr"):
            row.realised = row.duration_s = NAN
            with contextlib.suppress(ArithmeticError):
                row.realised = self.cohesive(contact, scene, speed, row.size)
            row.advice += " eps includes the cohesion."
        return int(end)

    def cohesive(
        self, contact: Contact, scene: Any, speed: float, size: int, step: float = 0, phase: float = 0
    ) -> float:
        """Returns eps with a pull that is proportional to the area of contact, or 0 if the bodies stick. Integrates by
        Runge-Kutta steps; the error of eps is below 5e-5, compared with closed forms and smaller steps. step: the time
        step, 0 for none. phase: the part of a step before the contact."""
        ri, rj = (b.radius[size] for b in contact.bodies)
        wall, exact = contact.bodies[1].wall, contact.cohesion[0] == "sjkr"
        damper = lib.cor_scene_damping(scene, lib.COR_SCENE_DAMPING_COEFFICIENT)
        numbers = (scene.stiffness, damper, contact.cohesion[1], ri, 0.0 if wall else rj, scene.mass_kg, speed)
        key = (exact, scene.law.elastic, scene.law.damping, *numbers)
        if any(map(math.isnan, numbers)):
            return NAN
        power, damped = (n / scene.law.denominator for n in (scene.law.elastic, scene.law.damping))

        def area(x: float) -> float:
            if wall:
                return x * (2 * ri - x * exact)
            if exact:
                return x * (2 * (ri + rj) - x) * (2 * ri - x) * (2 * rj - x) / (ri + rj - x) ** 2 / 4
            return 4 * x * ri * rj / (ri + rj)

        def force(x: float, v: float) -> float:
            x = max(x, 0.0)
            pull = math.pi * contact.cohesion[1] * area(x)
            return float((pull - scene.stiffness * x**power - damper * x**damped * v) / scene.mass_kg)

        self.cohesive_left -= key not in self.needed
        if self.cohesive_left < 0 and key not in self.needed:
            return NAN
        if step > 0:  # the steps of LIGGGHTS, whose damping has the velocity of the last half step
            x, v, pull = -phase * step * speed, speed, 0.0
            for _ in range(100000):
                v += step / 2 * pull
                y = x + step * v
                pull = force(y, v) if y > 0 else 0.0
                v += step / 2 * pull
                if y <= 0 < x or y <= 0 > v or y > ri or v + step * pull > 0 > v:
                    return -v / speed if y <= 0 else 0.0 if y <= ri else NAN
                x = y
            return NAN
        if key not in self.needed:
            h = lib.cor_scene_elastic_duration_s(scene, speed) / 1000
            self.needed[key] = _rebound(force, speed, h, ri) / speed
        return self.needed[key]

    def luding(self, contact: Contact, mass: float, speed: float, size: int) -> float:
        """Returns eps of YADE's Law2_ScGeom_LudingPhys_Basic, step by step as in YADE; 0 if the bodies stick."""
        k1, kp, kc, viscosity, depth = contact.luding or (NAN,) * 5
        one, two = (b.radius[size] for b in contact.bodies)
        most_free = 0.0 if contact.bodies[1].wall else depth * 2 * one * two / (one + two)
        limit = kp / (kp - k1) * most_free
        key = ("luding", k1, kp, kc, viscosity, limit, mass, speed, contact.global_damping)
        if any(math.isnan(n) for n in key[1:]):
            return NAN
        self.cohesive_left -= key not in self.needed
        if key not in self.needed and self.cohesive_left >= 0:
            h, x, v, most, free, eps = math.pi * math.sqrt(mass / kp) / 5000, 0.0, speed, 0.0, 0.0, NAN
            h = min(h, mass / viscosity / 100) if viscosity > 0 else h
            for _ in range(200000):
                k2 = kp if most >= limit else k1 + (kp - k1) * most / limit
                if x > most:
                    most, free = x, min((1 - k1 / k2) * x, most_free)
                force = k2 * (x - free)
                if force >= k1 * x and x < limit:
                    force = k1 * x
                elif force <= -kc * x:
                    force, most = -kc * x, x * (k2 + kc) / (k2 - k1)
                force += viscosity * v
                w = v - h * force / mass * (1 + math.copysign(contact.global_damping, force * v))
                x += h * w
                if x <= 0 or w > 0 > v:  # they part, or turn inward again and stick
                    eps = max(-w, 0.0) / speed if x <= 0 else 0.0
                    break
                v = w
            self.needed[key] = eps
        return self.needed.get(key, NAN)

    def damp(self, row: Row, contact: Contact, law: int, end: int, zeta: float) -> None:
        """Sets eps if all forces against the motion are multiplied by 1 + d, and all forces along it by 1 - d. Approach
        and rebound then belong to two different collisions with the same largest overlap."""
        d, q = contact.global_damping, lib.COR_MAX_OVERLAP
        ratio = NAN
        if 0 <= d < 1 and law in (lib.COR_LAW_LINEAR, lib.COR_LAW_TSUJI):
            way_in, way_out = zeta * math.sqrt(1 + d), zeta * math.sqrt(1 - d)
            overlaps = [lib.cor_law_value(law, lib.COR_END_ZERO_FORCE, q, z) for z in (way_in, way_out)]
            power = 1 if law == lib.COR_LAW_LINEAR else 1.25
            ratio = (overlaps[0] / overlaps[1]) ** power * math.sqrt((1 - d) / (1 + d))
            ratio *= lib.cor_law_eps(law, end, way_out)
            if end == lib.COR_END_ZERO_OVERLAP and zeta > 0 < d and law == lib.COR_LAW_LINEAR:
                ratio = _damped_pull(zeta, d)
        without, row.realised, row.duration_s = row.realised, ratio, NAN
        row.advice += f" The damping of all forces, {d:.6g}, changes eps from {without:.6g}: set it to 0. This eps "
        row.advice += "holds for a fixed partner, and for two bodies of opposite momenta."

    def add_surface(self, row: Row, contact: Contact, scene: Any, speed: float, end: int) -> None:
        """Sets eps at the surface, if gravity presses the sphere against a wall."""
        gravity, d = contact.gravity, contact.global_damping
        is_known = gravity > 0 and speed > 0 and math.isfinite(row.realised)
        if not is_known or contact.cohesion[0] or not any(b.wall for b in contact.bodies):
            return
        if d != 0:
            # YADE changes the sum of spring force and weight, whose potential has its minimum inside the contact
            a = scene.law.elastic / scene.law.denominator
            lowest = 2 * a / (a + 1) * gravity * (scene.mass_kg * gravity / scene.stiffness) ** (1 / a) / speed**2
            square = (1 - d) / (1 + d) * (1 + (1 - d) * lowest) - (1 + d) * lowest
            if row.damping == 0 and not math.isnan(square):
                self.say_surface(row, math.sqrt(max(square, 0.0)))
            return
        if contact.solimp is not None:
            model = model_of(contact.model)
            zeta = model.damping_of_number(model, contact.number, scene, speed)
            self.say_surface(row, self.mujoco(contact, scene, zeta, speed, gravity))
            return
        if end >= lib.COR_SCENE_ENDS:
            return
        pressed, eps = ffi.new("struct cor_scene_contact *", scene[0]), ffi.new("double *")
        pressed.force_n = scene.mass_kg * gravity
        if lib.cor_scene_eps(eps, pressed, speed, end) == lib.COR_OK:
            self.say_surface(row, eps[0])

    def mujoco(self, contact: Contact, scene: Any, zeta: float, speed: float, gravity: float) -> float:
        key = (contact.solimp, contact.softness, math.sqrt(scene.stiffness), zeta, speed, gravity)
        if key not in self.needed:
            self.needed[key] = float(lib.cor_mujoco_eps(*key))
        return self.needed[key]

    def say_surface(self, row: Row, surface: float) -> None:
        row.realised_surface = surface
        if abs(surface - row.realised) > self.options.tolerance * row.realised:
            row.advice += f" With gravity, eps of a bounce on this wall is {surface:.6g}, not {row.realised:.6g}."

    # ---- the time step ----

    def step_error(self, scene: Any, at: float, end: int, steps: float, integrator: int, cost: float) -> Any:
        key = (scene.stiffness, scene.mass_kg, scene.damping, scene.law.elastic, scene.law.damping, at, end, steps)
        if key not in self.errors:
            error = ffi.new("struct cor_step_error *")
            call = error, scene, at, end, steps, integrator
            if cost > self.steps_left or lib.cor_scene_step_error(*call) != lib.COR_OK:
                return None
            self.steps_left -= cost
            self.options.progress("errors of time steps")
            self.errors[key] = error.bias, error.scatter
        return self.errors[key]

    def add_step(self, row: Row, contact: Contact, scene: Any, speed: float, end: int) -> bool:
        """Adds the error of the time step. True if eps stays within the tolerance of e, or of eps without a step."""
        step = self.options.time_step / contact.units.time_s
        step = contact.time_step if math.isnan(step) else step
        row.time_step_s = step * contact.units.time_s
        integrator = self.integrator if contact.integrator is None else contact.integrator
        at = 1.0 if math.isnan(speed) else speed
        steps = lib.cor_scene_elastic_duration_s(scene, at) / step if step > 0 else NAN
        wished = row.realised if math.isnan(row.asked) else row.asked
        allowed = self.options.tolerance * wished
        if contact.cohesion[0].startswith("sjkr") and 2 < steps < 500 and row.realised > 0:
            phases = [self.cohesive(contact, scene, speed, row.size, step, (k + 0.5) / 16) for k in range(16)]
            row.step_bias = sum(phases) / 16 - row.realised
            row.step_scatter = math.sqrt(sum((x - row.realised - row.step_bias) ** 2 for x in phases) / 16)
            if max(abs(row.step_bias), row.step_scatter) > allowed:
                row.advice += f" The time step changes the mean eps to {row.realised + row.step_bias:.6g}."
            return max(abs(row.step_bias + row.realised - wished), row.step_scatter) <= allowed
        knows = scene.mass_kg * scene.stiffness > 0 and contact.global_damping == 0
        if math.isnan(speed) and math.isnan(row.duration_s) and step > 0 and knows:
            row.advice += " The error of the time step is not included: give --speed."
        if integrator == lib.COR_NO_INTEGRATOR or not 0 < row.duration_s < math.inf or not step > 0:
            return True
        elastic = lib.cor_scene_elastic_duration_s(scene, at)
        steps, collision = elastic / step, row.duration_s / step
        if steps < 2:
            row.advice += " The contact lasts less than two time steps, so eps depends on chance."
            return False
        cost = max(_PHASES_LEAST * collision, min(_PHASES * collision, _STEPS_OF_PHASES))
        error = self.step_error(scene, at, end, steps, integrator, cost)
        if error is None:
            return True
        row.step_bias, row.step_scatter = error
        if abs(row.realised + row.step_bias - wished) <= allowed and row.step_scatter <= allowed:
            return True
        if abs(row.step_bias) <= allowed and row.step_scatter <= allowed:
            return False  # eps differs from e for another reason than the step
        row.advice += f" The time step changes the mean eps to {row.realised + row.step_bias:.6g}, "
        row.advice += f"with the standard deviation {row.step_scatter:.6g}."
        key = (scene.stiffness, scene.mass_kg, scene.damping, scene.law.elastic, scene.law.damping, at, end, allowed)
        if key not in self.needed and allowed >= _LEAST_SEARCHED and self.steps_left >= _STEPS_OF_SEARCH:
            self.steps_left -= _STEPS_OF_SEARCH
            least = ffi.new("double *")
            found = lib.cor_scene_step_for(least, scene, at, end, allowed, integrator) == lib.COR_OK
            self.needed[key] = elastic / least[0] * contact.units.time_s if found else NAN
        if self.needed.get(key, NAN) > 0:
            row.advice += f" A time step of {self.needed[key]:.6g} or less keeps both errors below {allowed:.6g}."
        return False

    # ---- rows ----

    def advise_missing(self, row: Row, scene: Any, speed: float) -> None:
        instant = bool(row.contact and row.contact.threshold)
        scales = not (scene.mass_kg > 0 and scene.stiffness > 0) and not instant
        bodies = row.contact.bodies if row.contact else ()
        if scales and any(b.mass and math.isnan(b.mass[row.size]) for b in bodies):
            row.advice += " The mass of the rigid body is not in the text."
        elif scales and math.isnan(scene.radius_m):
            row.advice += " The radius is not in the text: give --radius."
        elif scales and math.isnan(scene.mass_kg):
            row.advice += " The density is not in the text: give --density."
        elif scales:
            row.advice += " The stiffness could not be read."
        elif math.isnan(speed):
            row.advice += " eps depends on the impact speed: give --speed."
        elif row.contact and row.contact.cohesion[0].startswith("sjkr"):
            most = f" cor integrates at most {_COHESIVE} contacts with cohesion of a deck."
            row.advice += most if self.cohesive_left < 0 else " The cohesion exceeds the spring force."
        else:
            row.advice += " This law has no function in libcor."

    def row(self, contact: Contact, size: int, label: str, speed_m_s: float) -> Row:
        """Returns the row of one contact at one speed."""
        units, names = contact.units, [b.name for b in contact.bodies]
        row = Row(contact.file, contact.line, contact.simulator, contact.style, contact=contact, size=size)
        row.pair = (contact.pair or "-".join(names)) + label
        row.speed_m_s, row.units = speed_m_s, "lj" if units.name == "lj" else "si"
        row.judged = False
        if not contact.model:
            row.advice = contact.unknown
            return row
        model, other = model_of(contact.model), _OTHER.get(contact.model)
        if other and not self.has_version(model):
            model, other = model_of(other), None
        name = string(model.model)
        depends = contact.solimp is not None and contact.solimp[0] != contact.solimp[1]
        row.model = name.replace("dmin = dmax", "dmin < dmax") if depends else name
        row.model += ", limit_damping" if contact.limited else ""
        row.model = contact.style or row.model
        row.asked = contact.number if model.damping_of_e else NAN
        row.advice = " ".join(contact.notes + ([contact.unknown] if contact.unknown else []))
        speed = speed_m_s * units.time_s / units.length_m
        try:
            scene = scene_of(contact, size)
        except ArithmeticError:
            row.advice += " A number of this contact is out of range."
            return row
        numbers = scene.mass_kg, scene.stiffness, scene.radius_m, speed, contact.number, contact.cohesion[1]
        if not self.has_version(model):
            row.advice += f" {self.deck.simulator} {self.options.version} does not have this model."
            row.end = string(lib.cor_end_names[model.end])
        elif not _is_moderate(*numbers):
            row.advice += " A number of this contact is negative, or out of the range from 1e-48 to 1e48."
        elif contact.refused:
            row.advice = f"{row.advice} {contact.refused}"
            row.judged, row.as_asked = True, False
        elif not contact.unknown:
            self.judge(row, contact, model, scene, speed)
            if other and self.version == 0 and model.damping_of_e and contact.zeta_factor and not contact.cohesion[0]:
                row.advice += f" In the model '{string(model_of(other).model)}' this e realises "
                row.advice += f"{lib.cor_simulator_realised(model_of(other), contact.number):.6g}."
        row.advice = " ".join([row.advice] + contact.losses).strip()
        row.duration_s *= units.time_s
        return row

    def has_version(self, model: Any) -> bool:
        since, until = model.since, model.until
        return bool(self.version == 0 or (self.version >= since and (until == 0 or self.version <= until)))

    def judge(self, row: Row, contact: Contact, model: Any, scene: Any, speed: float) -> None:
        least = self.off_centre(row, contact, model, scene, speed)
        end = self.solve(row, contact, model, scene, speed)
        refused = model.damping_of_e and not model.least <= contact.number <= model.most
        if math.isnan(row.realised) and not refused:
            self.advise_missing(row, scene, speed)
        elif model.damping_of_e:
            row.judged = True
            row.as_asked = abs(row.realised - row.asked) <= self.options.tolerance * row.asked
            if refused:
                row.advice += f" {contact.simulator} accepts e from {model.least:.6g} to {model.most:.6g}."
            elif not row.as_asked:
                row.advice += f" e = {contact.number:.6g} realises {row.realised:.6g}."
            row.as_asked = self.add_step(row, contact, scene, speed, end) and row.as_asked
            row.as_asked &= least is None or bool(abs(least - row.asked) <= self.options.tolerance * row.asked)
        else:
            row.judged = True
            self.add_step(row, contact, scene, speed, end)
            depends = lib.cor_scene_speed_exponent(scene) != 0 and contact.spring is not Spring.PER_MASS
            if depends and not math.isnan(speed) and scene.stiffness > 0:
                row.advice += " " + string(model.advice)
        if row.judged and least is not None and row.damping != 0:
            row.advice += " This eps holds for impacts through the centre of mass. Impacts off the centre return less"
            row.advice += "." if math.isnan(least) else f", down to about {least:.3g}."
        self.add_surface(row, contact, scene, speed, end)
        self.add_oblique(row, contact, scene, speed, end)

    def off_centre(self, row: Row, contact: Contact, model: Any, scene: Any, speed: float) -> Optional[float]:
        """Returns the smallest eps of bodies that are not spheres and touch at one point. Such bodies also turn, so
        that less mass moves than the mass that sets the damping. NaN if the shape is unknown; None for spheres."""
        shares = [(_inverse_mass(b, row.size), b.lever[contact.bodies[1].wall]) for b in contact.bodies]
        if all(lever == 0 for _, lever in shares):
            return None
        ratio = 1 + _over(sum(m * lever for m, lever in shares), sum(m for m, _ in shares))
        ratio = 1 + shares[0][1] if contact.bodies[1].wall else ratio
        probe, copied = Row("", 0, "", size=row.size), ffi.new("struct cor_scene_contact *", scene[0])
        self.solve(probe, contact, model, copied, speed, ratio)
        return probe.realised

    def add_oblique(self, row: Row, contact: Contact, scene: Any, speed: float, end: int) -> None:
        """Sets -u'/u at the angle of the options, or adds the reason why it is not known."""
        if math.isnan(self.options.angle):
            return
        name, stiffness, ratio, friction = contact.tangential
        found = [k for k, model in enumerate(lib.cor_tangential_models) if string(model.name) == name]
        reason = "" if found else name or "cor has no model of this tangential force"
        if found and contact.global_damping != 0:
            reason = "YADE's damping of all forces also acts along the surface"
        elif contact.cohesion[0]:
            reason = "cor has no tangential force with cohesion"
        elif found and math.isnan(speed):
            reason = "it depends on the speed, so give --speed"
        elif found and math.isnan(stiffness + ratio + friction):
            reason = "the stiffness, damping or friction of the tangential force is not known"
        if reason:
            row.advice += f" No tangential restitution: {reason}."
            return
        model, tangent = lib.cor_tangential_models[found[0]], math.tan(math.radians(self.options.angle))
        stiffness *= 1 if model.constant_stiffness and contact.spring not in _LINEAR else scene.stiffness
        damper = ratio * lib.cor_scene_damping(scene, lib.COR_SCENE_DAMPING_COEFFICIENT)
        scaled, impact = ffi.new("struct cor_tangential *"), ffi.new("struct cor_oblique_impact *")
        if (
            lib.cor_scene_tangential_scaled(scaled, scene, found[0], stiffness, damper, speed) == lib.COR_OK
            and lib.cor_scene_oblique(impact, scene, scaled, friction, speed, tangent, end) == lib.COR_OK
        ):
            row.tangential_restitution = -impact.restitution
            needed = impact.time_step_s * contact.units.time_s
            if needed < (math.inf if math.isnan(row.time_step_s) else row.time_step_s):
                row.advice += " The tangential damper exceeds the friction at the first touch: the tangential "
                row.advice += f"restitution needs a time step of about {needed:.2g} s or less."
        else:
            row.advice += " No tangential restitution: mass, stiffness or another number is unknown or out of range."

    def rows_of(self, contact: Contact) -> List[Row]:
        """Returns the rows of one contact: one for each size and speed."""
        options, units = self.options, contact.units
        bodies = tuple(self.completed(b, units) for b in contact.bodies)
        contact.bodies = bodies[0], bodies[1]
        one_size = all(_same(*b.radius) and (b.mass is None or _same(*b.mass)) for b in bodies)
        own = dict.fromkeys(v * units.length_m / units.time_s for v in contact.speeds)
        speeds = options.speeds or tuple(own) or (NAN,)
        return [
            self.row(contact, size, "" if one_size else _SIZES[size], speed)
            for size in range(1 if one_size else 2)
            for speed in speeds
        ]

    def given(self, values: Dict[str, float], body: Body) -> float:
        """Returns the option for a body by its name or type number, otherwise the option for all bodies."""
        return values.get(body.name, values.get(str(body.type), values.get("", NAN)))

    def completed(self, body: Body, units: Any) -> Body:
        """Returns the body, with radius and density from the options if the deck does not contain them."""
        if body.wall:
            return body
        made = dict(body.__dict__)
        radius = self.given(self.options.radii, body) / units.length_m
        density = self.given(self.options.densities, body)
        if math.isnan(body.radius[0]):
            made["radius"] = radius, radius
        if math.isnan(body.density):
            made["density"] = density * units.length_m**3 / units.mass_kg
        return Body(**made)

    # ---- lines to write instead ----

    def wanted(self, contact: Contact, row: Row) -> float:
        """Returns the e to write so that the contact realises the requested e; NaN if no such e exists."""
        model = model_of(contact.model)
        if row.as_asked or abs(row.realised - row.asked) <= self.options.tolerance * row.asked:
            return contact.number
        changed = ffi.new("struct cor_simulator_model *", model[0])
        if contact.limited:
            changed.end = lib.COR_END_ZERO_FORCE
        wished = contact.number
        if contact.zeta_factor == 0:
            return NAN
        if contact.zeta_factor != 1:
            damping = lib.cor_law_damping(changed.law, changed.end, wished) / contact.zeta_factor
            wished = lib.cor_law_eps(changed.law, changed.end, damping)
        return float(lib.cor_simulator_e(changed, wished, ffi.new("enum cor_simulator_status *")))

    def repair(self, rows: List[Row]) -> None:
        """Adds the replacement lines: one text for all contacts whose numbers are in the same lines."""
        groups: Dict[int, List[Tuple[Row, Contact, float]]] = {}
        for row in rows:
            contact = row.contact
            if contact is None or not row.judged or math.isnan(row.asked) or contact.refused:
                continue
            e = self.wanted(contact, row)
            wrong = not abs(row.realised - row.asked) <= self.options.tolerance * row.asked
            if contact.global_damping != 0 or contact.cohesion[0] or row.realised == 0 < contact.threshold:
                continue
            if wrong and math.isnan(e):
                row.advice = f"{row.advice} No e gives the requested eps here.".strip()
            elif wrong and (contact.repair is None or not contact.slots):
                row.advice = f"{row.advice} This contact needs e = {e:.6g}.".strip()
            elif contact.repair is not None and contact.slots and not math.isnan(e):
                groups.setdefault(id(contact.repair), []).append((row, contact, e))
        for group in groups.values():
            self.write(group)

    def write(self, group: List[Tuple[Row, Contact, float]]) -> None:
        wanted: Dict[Tuple[int, int], Set[str]] = {}
        for _, contact, e in group:
            for slot in contact.slots:
                wanted.setdefault(slot, set()).add(f"{e:.6g}")
        repair: Optional[Repair] = group[0][1].repair
        assert repair is not None
        text = repair.text
        for start, end in sorted(wanted, reverse=True):
            text = text[:start] + sorted(wanted[start, end])[0] + text[end:]
        for row, contact, e in group:
            if abs(row.realised - row.asked) <= self.options.tolerance * row.asked:
                continue
            if any(len(values) > 1 for values in wanted.values()):
                row.advice += f" This contact needs e = {e:.6g}, but contacts that share this number need another e."
                continue
            row.instead, row.instead_file = text, repair.file
            row.instead_line, row.instead_last = repair.line, repair.last_line


def _same(x: float, y: float) -> bool:
    return x == y or (math.isnan(x) and math.isnan(y))


def rows_of(deck: Deck, options: Options) -> List[Row]:
    """Returns all rows of a deck: the contacts in their order, and the remarks in the order of lines."""
    audit = _Audit(deck, options)
    rows: List[Row] = [
        Row(r.file, r.line, deck.simulator, advice=r.text, judged=not r.matters) for r in dict.fromkeys(deck.remarks)
    ]
    for contact in deck.contacts[:MAX_CONTACTS]:
        rows += audit.rows_of(contact)
    if len(deck.contacts) > MAX_CONTACTS:
        text = f"the deck has {len(deck.contacts)} contacts; only {MAX_CONTACTS} are judged"
        rows.append(Row(deck.file, 0, deck.simulator, advice=text, judged=False))
    audit.repair(rows)
    return rows


def simulator_of(text: str) -> str:
    """Identifies the simulator of a text by its patterns. Raises DeckError if no pattern matches."""
    for name, (_, _, signs) in SIMULATORS.items():
        if any(sign in text for sign in signs):
            return name
    raise DeckError(f"no simulator is recognised; name it by --for; allowed: {', '.join(sorted(SIMULATORS))}")


def audit_text(text: str, name: str, options: Options) -> List[Row]:
    """Reads an input and returns its rows."""
    simulator = options.simulator or simulator_of(text)
    module, function, _ = SIMULATORS[simulator]
    try:
        deck = getattr(import_module(f"cor._audit.{module}"), function)(text, name, options)
    except (ArithmeticError, LookupError, TypeError, AttributeError, RecursionError, MemoryError) as error:
        raise DeckError(f"this input cannot be read: {type(error).__name__}: {error}") from error
    options.progress("judging contacts")
    return rows_of(deck, options)
