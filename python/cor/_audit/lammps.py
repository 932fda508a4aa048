# SPDX-License-Identifier: MIT
"""Contacts of LAMMPS and LIGGGHTS: the state of a script's system, and its contacts at each run.

Atoms are kept as cohorts: all atoms that one command made, divided where a later command changes a part of them.
A script without atoms has one cohort of unknown size for each type."""

import copy
import math
import re
from dataclasses import dataclass, replace
from typing import Any, Dict, FrozenSet, Iterable, Iterator, List, Optional, Sequence, Set, Tuple

from .deck import MAX_CONTACTS, NAN, Body, Contact, Deck, Options, Repair, Spring, Units
from .script import SIGNS, Script, System, Unknown, Words, is_known, number

MAX_COHORTS = 256
# Units of length, mass and time in SI, and the time step that a script does not set, in these units
UNITS = {
    "si": (1.0, 1.0, 1.0, 1e-8),
    "cgs": (1e-2, 1e-3, 1.0, 1e-8),
    "micro": (1e-6, 1e-15, 1e-6, 2.0),
    "nano": (1e-9, 1e-21, 1e-9, 4.5e-4),
    "lj": (1.0, 1.0, 1.0, 0.005),
}
_ACCELERATED = re.compile(r"/(omp|opt|gpu|intel|kk(/device|/host)?)$")
_INTEGRATES = re.compile(r"(nve|nvt|npt|nph|rigid|multisphere|poems|brownian|nvk|bd)(/|$)")
_LOSSES = {
    "viscous": "a drag on each particle",
    "viscous/sphere": "a torque on each particle",
    "langevin": "a drag and random kicks",
    "drag": "a pull to a point",
    "nve/limit": "a limit of the distance per step",
}
_LOSSY = re.compile(r"(temp|press)/|(nvt|npt|nph|gld|ttm|lb|srd|couple/cfd|dt/reset)(/|$)")
_NORMAL = {"hooke": 2, "hertz": 2, "hertz/material": 3, "dmt": 4, "jkr": 4}
_FAULTS = {
    "dmt": "The pull of DMT adhesion makes eps depend on the speed; without it the damping alone would count.",
    "jkr": "LAMMPS parts bodies at the largest pull of JKR's force: they stick below 0.703 of the speed of JKR's "
    "theory, and lose half its energy. The damping takes more.",
}
_HAS_LIMIT = {"HOOKE_VELOCITY", "HOOKE_MASS_VELOCITY", "HERTZ_VISCOELASTIC", "HERTZ_TSUJI", "COEFF_RESTITUTION"}
_BY_MASS = {"HOOKE_MASS_VELOCITY", "HOOKE_VISCOELASTIC", "HERTZ_VISCOELASTIC", "HERTZ_MASS_VELOCITY"}
_BY_ROOT = {"HOOKE_TSUJI", "HERTZ_TSUJI", "COEFF_RESTITUTION"}  # damping grows with the root of the mass
_MODELS = {"hertz": True, "hooke": False, "hertz/stiffness": True, "hooke/stiffness": False}  # LIGGGHTS; Hertz's force
_PRIMITIVE = re.compile(r"[xyz](plane|cylinder)$|cylinder|region$")


@dataclass
class Cohort:
    """Atoms of one type. radius and mass: least and largest. kind: made by a command, read from a file, or assumed.
    count: 0 if unknown. held: why no force moves them. body: the rigid body, and its mass or NaN."""

    type: int
    radius: Tuple[float, float] = (NAN, NAN)
    mass: Tuple[float, float] = (NAN, NAN)
    density: float = NAN
    kind: str = "made"
    count: int = 0
    id: int = 0
    at: Tuple[float, ...] = ()
    groups: FrozenSet[str] = frozenset(("all",))


@dataclass
class Coefficient:
    """The normal force of a pair style, of a line pair_coeff, or of a wall.

    at: the index of the model (granular) or of K_n (gran) in words. style: as "hooke/history" or "granular"."""

    words: Words
    at: int
    style: str
    first: Tuple[int, int] = (1, 1)
    last: Tuple[int, int] = (1 << 30, 1 << 30)
    part: int = 0  # of a hybrid style


def _span(word: str, most: int) -> Tuple[int, int]:
    """The types of "3", "*", "2*", "*4", "2*4" and "2:4"."""
    if not is_known(word):
        number(word)
    found = re.fullmatch(r"(\d*)([*:]?)(\d*)", word)
    if not found or not word:
        raise Unknown(f"types {word}")
    first = int(found[1] or 1)
    return first, (int(found[3] or most) if found[2] else first)


def _sphere(radius: float, density: float) -> float:
    return 4 * math.pi / 3 * radius**3 * density


def _same(x: Any, y: Any) -> bool:
    return repr(x) == repr(y)


class Granular(System):
    """The system of a script of LAMMPS, or of LIGGGHTS."""

    def __init__(self, deck: Deck, script: Script, options: Options):
        self.deck, self.script, self.options = deck, script, options
        self.is_liggghts = deck.simulator == "liggghts"
        self.seen: Dict[str, Contact] = {}
        self.repairs: Dict[Tuple[str, int, str], Repair] = {}
        self.runs: List[Tuple[str, int]] = []
        self.found: Set[str] = set()  # of this world
        self.restart()

    def restart(self) -> None:
        """Begins an empty system, as `clear` does."""
        self.units, self.time_step = Units("lj", 1, 1, 1), UNITS["lj"][3]
        self.dimension, self.types, self.step = 2 + 1, 0, 0
        self.cohorts: List[Cohort] = []
        self.group_names: Set[str] = {"all"}
        self.regions: Dict[str, Words] = {}
        self.box: Optional[Words] = None
        self.fixes: Dict[str, Words] = {}
        self.style: List[Coefficient] = []
        self.hybrid = ""
        self.other_style: Optional[Words] = None
        self.coefficients: List[Coefficient] = []
        self.excluded: List[Tuple[str, str, str]] = []
        self.speeds: List[float] = []
        self.created = 0  # atoms; -1: unknown
        self.is_changed = self.is_run = False

    def copy(self) -> "Granular":
        other = copy.copy(self)
        for name, value in self.__dict__.items():
            if isinstance(value, (list, dict, set)) and name not in ("seen", "repairs", "runs"):
                setattr(other, name, copy.copy(value))
        other.cohorts = [replace(c) for c in self.cohorts]
        other.found = set()
        return other

    def keyword(self, name: str) -> float:
        if name == "step" and self.step >= 0:
            return float(self.step)
        if name == "dt":
            return self.time_step
        found = re.fullmatch(r"([xyz])(lo|hi)|l([xyz])", name)
        if found and self.box and self.box[2] == "block":
            i = "xyz".index(found[1] or found[3])
            ends = self.box.number(3 + 2 * i), self.box.number(4 + 2 * i)
            return ends[1] - ends[0] if found[3] else ends[found[2] == "hi"]
        raise Unknown(f"{name}, which only a run gives")

    def is_defined(self, category: str, name: str) -> bool:
        known: Dict[str, Iterable[str]] = {"fix": self.fixes, "group": self.group_names, "region": self.regions}
        if category not in known:
            raise Unknown(f"is_defined({category},{name})")
        return name in known[category]

    # ---- commands ----

    def on_units(self, words: Words) -> None:
        if words[1] not in UNITS:
            raise Unknown(f"units {words[1]}; granular contacts have consistent numbers in {', '.join(UNITS)}")
        length, mass, time, step = UNITS[words[1]]
        self.units, self.time_step = Units(words[1], length, mass, time), step

    def on_timestep(self, words: Words) -> None:
        self.time_step = NAN
        self.time_step = words.number(1)

    def on_dimension(self, words: Words) -> None:
        self.dimension = int(words.number(1))

    def on_region(self, words: Words) -> None:
        self.regions[words[1]] = words

    def on_lattice(self, words: Words) -> None:
        self.box = None if words[1] != "none" else self.box
        self.regions = {} if words[1] != "none" else self.regions

    def on_box_change(self, words: Words) -> None:
        self.box = None

    on_change_box = on_displace_box = on_box_change

    def on_create_box(self, words: Words) -> None:
        self.set_types(int(words.number(1)))
        self.box = self.regions.get(words[2])

    def set_types(self, count: int, kind: str = "assumed") -> None:
        self.types = max(self.types, min(count, 1000))
        self.cohorts += [Cohort(type=i + 1, kind=kind) for i in range(self.types)]

    def on_read_data(self, words: Words) -> None:
        """Reads the types of a data file, and the sizes and densities of its atoms if they are spheres."""
        self.created, self.box = -1, None
        found = self.options.include(words[1], words.line.file) if is_known(words[1]) else None
        text = found[0] if found and words[0] == "read_data" else ""
        types = re.search(r"^\s*(\d+)\s+atom types", text, re.M)
        self.set_types(int(types[1]) if types else 0, "file")
        atoms = re.search(r"^Atoms\b.*$", text, re.M)
        sizes: Dict[int, List[float]] = {}
        if atoms and (self.atom_style in ("sphere", "granular") or "sphere" in atoms[0]):
            for row in re.finditer(r"\n\s*\d+ +(\d+) +([\d.eE+-]+) +([\d.eE+-]+) .*|\n\s*[A-Z]", text[atoms.end() :]):
                self.script.tick()
                if row[1] is None:
                    break
                type, radius, density = int(row[1]), float(row[2]) / 2, float(row[3])
                s = sizes.setdefault(type, [radius, radius, density, density])
                s[:] = min(s[0], radius), max(s[1], radius), min(s[2], density), max(s[3], density)
        if sizes:
            self.cohorts = [c for c in self.cohorts if c.kind != "file"]
        for type, (least, largest, light, heavy) in sizes.items():
            mass = _sphere(least, light), _sphere(largest, heavy)
            density = light if light == heavy else NAN
            self.cohorts.append(Cohort(type, (least, largest), mass, density, "file"))

    on_read_restart = on_read_data
    atom_style = ""

    def on_atom_style(self, words: Words) -> None:
        self.atom_style = words[1]

    def on_create_atoms(self, words: Words) -> None:
        count = 1 if words[2] == "single" else 0
        at = tuple(words.value(i) for i in (3, 4, 5)) if count else ()
        if words.find("mol") > 0:
            self.created = -1
            self.set_types(0, "file")
            return
        self.created = self.created + 1 if count and self.created >= 0 else -1
        mass = self.volume(0.5)
        self.cohorts.append(
            Cohort(int(words.number(1)), (0.5, 0.5), (mass, mass), 1.0, "made", count, max(self.created, 0), at)
        )

    def volume(self, radius: float) -> float:
        return math.pi * radius**2 if self.is_liggghts and self.dimension == 2 else _sphere(radius, 1)

    def divide(self, inside: Any) -> List[Cohort]:
        """Divides the cohorts of which only a part is inside; returns those inside. inside: a function of a cohort that
        returns True, False or None (a part)."""
        chosen = []
        for cohort in list(self.cohorts):
            here = inside(cohort)
            if here is None and len(self.cohorts) < MAX_COHORTS:
                self.cohorts.append(replace(cohort, count=0, id=0))
            if here is not False:
                chosen.append(cohort)
        return chosen

    def in_region(self, cohort: Cohort, name: str) -> Optional[bool]:
        region = self.regions.get(name)
        if not cohort.at or region is None or region[2] != "block" or region.find("rotate") > 0:
            return None
        inside = region.find("out") < 0
        for i in range(3):
            for k in (0, 1):
                bound = -math.inf if region[3 + 2 * i + k] in ("INF", "EDGE") and not k else math.inf
                bound = region.value(3 + 2 * i + k) if region[3 + 2 * i + k] not in ("INF", "EDGE") else bound
                if math.isnan(bound) or math.isnan(cohort.at[i]):
                    return None
                if (cohort.at[i] < bound) if k == 0 else (cohort.at[i] > bound):
                    return not inside
        return inside

    def selected(self, how: str, what: Sequence[str]) -> Any:
        """A function of a cohort: whether it is in the types, ids, group or region."""
        if how == "type" and what[0] in ("<", ">", "<=", ">=", "==", "!=", "<>"):
            x, y = number(what[1]), number(what[2]) if len(what) > 2 else 0
            sign = SIGNS.get(what[0])
            return lambda c: bool(sign(c.type, x)) if sign else x <= c.type <= y
        if how in ("type", "id", "atom"):
            spans = [_span(word, 1 << 30) for word in what]
            if how == "type":
                return lambda c: any(a <= c.type <= b for a, b in spans)
            return lambda c: any(a <= c.id <= b for a, b in spans) if c.id else None
        if how == "group":
            return lambda c: any(g in c.groups for g in what)
        if how == "region":
            return lambda c: self.in_region(c, what[0])
        return lambda c: None

    def on_group(self, words: Words) -> None:
        name, how, what = words[1], words[2], words[3:]
        self.group_names.add(name)
        if how in ("delete", "clear"):
            chosen: List[Cohort] = []
            for cohort in self.cohorts:
                cohort.groups -= {name}
        elif how == "subtract":
            chosen = [c for c in self.cohorts if what[0] in c.groups and not any(g in c.groups for g in what[1:])]
        elif how == "intersect":
            chosen = [c for c in self.cohorts if all(g in c.groups for g in what)]
        elif how in ("empty", "static"):
            chosen = []
        elif how == "dynamic":
            chosen = self.divide(lambda c: what[0] in c.groups)
        else:
            chosen = self.divide(self.selected("group" if how == "union" else how, what))
        for cohort in chosen:
            cohort.groups |= {name}

    def on_set(self, words: Words) -> None:
        wanted = ("diameter", "density", "density/disc", "mass", "type", "type/fraction", "type/ratio", "type/subset")
        keys = [i for i in range(3, len(words) - 1) if words[i] in wanted]
        if not keys:
            return
        chosen = self.divide(self.selected(words[1], [words[2]]))
        for i in keys:
            value = words.value(i + 1)
            if words[i].startswith("type/"):
                chosen = self.divide(lambda c: None if any(c is x for x in chosen) else False)
            for cohort in chosen:
                radius = cohort.radius
                if words[i].startswith("type"):
                    cohort.type = int(value) if value >= 1 else cohort.type
                elif words[i] == "mass":
                    cohort.mass, cohort.density = (value, value), NAN
                elif words[i] == "diameter":
                    cohort.radius = value / 2, value / 2
                    if cohort.kind == "assumed" or (self.is_liggghts and cohort.density > 0):
                        self.set_density(cohort, cohort.density)  # its mass is not known before
                    else:
                        cohort.density = cohort.density if _same(radius, cohort.radius) else NAN
                else:
                    self.set_density(cohort, value, words[i] == "density/disc")

    def set_density(self, cohort: Cohort, density: float, disc: bool = False) -> None:
        disc = disc or (self.is_liggghts and self.dimension == 2)
        r = cohort.radius
        cohort.density = NAN if disc else density
        cohort.mass = tuple((math.pi * x * x if disc else _sphere(x, 1)) * density for x in r)  # type: ignore

    def on_delete_atoms(self, words: Words) -> None:
        if words[1] in ("group", "region"):
            inside = self.selected(words[1], [words[2]])
            self.cohorts = [c for c in self.cohorts if c.kind == "assumed" or inside(c) is not True]
        self.created = -1

    def on_velocity(self, words: Words) -> None:
        if words[2] == "set":
            self.add_speed(words, 3)

    def add_speed(self, words: Words, at: int) -> None:
        parts = [words.value(at + i) for i in range(3)]
        speed = math.sqrt(sum(x * x for x in parts if not math.isnan(x)))
        if speed > 0 and speed not in self.speeds and len(self.speeds) < 8:
            self.speeds.append(speed)

    def on_fix(self, words: Words) -> None:
        style = _ACCELERATED.sub("", words[3])
        self.fixes.pop(words[1], None)
        self.fixes[words[1]] = words
        if style in ("pour", "deposit"):
            self.pour(words, style == "pour")
        elif style.startswith("insert/"):
            self.insert(words)

    def on_unfix(self, words: Words) -> None:
        self.fixes.pop(words[1], None)

    def pour(self, words: Words, is_pour: bool) -> None:
        type = int(words.number(5))
        groups = frozenset(("all", words[2]))
        if "mol" in words or "rigid" in words:
            self.cohorts.append(Cohort(type or 1, groups=groups | {"\0rigid"}))
            return
        radius, density, at = (0.5, 0.5), (1.0, 1.0), words.find("diam") if is_pour else -1
        if at > 0:
            how, first = words[at + 1], words.value(at + 2)
            sizes = [first]
            if how == "range":
                sizes.append(words.value(at + 3))
            elif how == "poly" and first >= 1:
                sizes = [words.value(at + 3 + 2 * i) for i in range(min(int(first), 1000))]
            radius = min(sizes) / 2, max(sizes) / 2
        if is_pour and words.find("dens") > 0:
            density = words.value(words.find("dens") + 1), words.value(words.find("dens") + 2)
        mass = _sphere(radius[0], density[0]), _sphere(radius[1], density[1])
        self.cohorts.append(Cohort(type, radius, mass, density[0] if density[0] == density[1] else NAN, groups=groups))
        self.created = -1
        if is_pour and words.find("vel") > 0:
            vertical = 5 if self.dimension == 3 else 4
            self.add_speed(words, words.find("vel") + vertical)

    def insert(self, words: Words) -> None:
        at = words.find("vel")
        if words[at + 1] == "constant":
            self.add_speed(words, at + 2)
        distribution = self.fixes.get(words.after("distributiontemplate"))
        names = distribution[6::2] if distribution else []
        made = [f for f in (self.fixes[n] for n in names if n in self.fixes)] or self.templates()
        for template in made:
            self.cohorts += self.of_template(template, frozenset(("all", words[2])))
        self.created = -1

    def templates(self) -> List[Words]:
        return [f for f in self.fixes.values() if f[3].startswith("particletemplate/")]

    def of_template(self, words: Words, groups: FrozenSet[str]) -> List[Cohort]:
        """The cohort of a particletemplate/sphere SEED atom_type 1 density constant 2500 radius constant 0.005"""
        type = words.value(words.find("atom_type") + 1) if "atom_type" in words else 1.0
        if words[3] != "particletemplate/sphere":
            return [Cohort(int(type), groups=groups | {"\0multisphere"})] if type >= 1 else []
        limits = []
        for key in ("radius", "density"):
            i = words.find(key)
            least, most = words.value(i + 2), words.value(i + 3)
            limits.append(
                {"constant": (least, least), "uniform": (least, most)}.get(words[i + 1] if i > 0 else "", (NAN, NAN))
            )
        (least, most), (light, heavy) = limits
        density = light if light == heavy else NAN
        return [Cohort(int(type), (least, most), (_sphere(least, light), _sphere(most, heavy)), density, groups=groups)]

    def on_neigh_modify(self, words: Words) -> None:
        for i in range(1, len(words)):
            if words[i] == "exclude":
                if words[i + 1] == "none":
                    self.excluded = []
                elif words[i + 1] in ("group", "type"):
                    self.excluded.append((words[i + 1], words[i + 2], words[i + 3]))

    def on_pair_style(self, words: Words) -> None:
        name = _ACCELERATED.sub("", words[1])
        self.coefficients, self.style, self.other_style = [], [], None
        self.hybrid = name if name.startswith("hybrid") else ""
        styles = [i for i in range(1, len(words)) if re.match(r"gran(ular|/|$)", words[i])]
        for i in styles if self.hybrid else [1] if styles[:1] == [1] else []:
            style = _ACCELERATED.sub("", words[i])
            at = i + 2 if self.is_liggghts and words[i + 1] == "model" else i + 1
            self.style.append(Coefficient(words, at, style.replace("gran/", "", 1), part=len(self.style)))
        others = [w for w in words[2:] if re.match(r"[a-z]+(/[a-z]+)*$", w) and not w.startswith("gran")]
        others = [w for w in others if w not in ("limit_damping", "model", "tangential", "history")]
        if (not self.style and name not in ("none", "zero", "")) or (self.hybrid == "hybrid/overlay" and others):
            self.other_style = words

    def on_pair_coeff(self, words: Words) -> None:
        if self.is_liggghts or len(words) < 3:
            return
        (a, b), (c, d) = _span(words[1], 1 << 30), _span(words[2], 1 << 30)
        if c == d and a == b and c < a:
            a, b, c, d = c, d, a, b
        at, style = 3, self.style[0].style if self.style else ""
        part = 0
        if self.hybrid:
            style = _ACCELERATED.sub("", words[3]).replace("gran/", "", 1)
            at = 4
            same = [s for s in self.style if s.style == style]
            k = 0
            if len(same) > 1 and words[4].isdigit():
                k, at = int(words[4]) - 1, 5
            part = same[k].part if k < len(same) else -1
        of = Coefficient(words, at, style, (a, c), (b, d), part)
        if style != "granular" and part >= 0 and self.style:
            of = replace(self.style[part], first=(a, c), last=(b, d), part=part)
        self.coefficients.append(of)

    def on_clear(self, words: Words) -> None:
        self.finish()
        self.restart()

    def on_run(self, words: Words) -> None:
        self.runs.append((words.line.file, words.line.line))
        self.snapshot(len(self.runs))
        self.is_run = True
        steps = words.value(1) if words[0] == "run" else NAN
        known = self.step >= 0 and steps == steps
        self.step = -1 if not known else int(steps) if "upto" in words else self.step + int(steps)

    on_minimize = on_run

    def on_reset_timestep(self, words: Words) -> None:
        self.step = -1
        self.step = int(words.number(1))

    def finish(self) -> None:
        if not self.is_run:
            self.snapshot(0)

    # ---- contacts ----

    def has(self, style: str) -> List[Words]:
        return [f for f in self.fixes.values() if re.fullmatch(style, _ACCELERATED.sub("", f[3]))]

    def hold(self, c: Cohort) -> str:
        """Returns why no force moves a cohort: "freeze", "fixed", or ""."""
        if any(f[2] in c.groups for f in self.has("freeze")):
            return "freeze"
        if any(f[2] in c.groups for f in self.has("nve/noforce|move")):
            return "fixed"
        integrators = [f for f in self.fixes.values() if _INTEGRATES.match(f[3])]
        if integrators and not any(f[2] in c.groups or f[2] not in self.group_names for f in integrators):
            return "fixed"
        return ""

    def rigid(self, c: Cohort) -> Tuple[str, float]:
        """Returns the fix that makes a cohort part of a rigid body, and the mass of the body if it is known."""
        if "\0multisphere" in c.groups or any(f[2] in c.groups for f in self.has("multisphere.*")):
            return "multisphere", NAN
        if "\0rigid" in c.groups:
            return "rigid", NAN
        for f in self.has("rigid.*"):
            if f[2] in c.groups:
                members = [x for x in self.cohorts if f[2] in x.groups and x.kind != "assumed"]
                single = f[4] == "single" and members and all(x.count == 1 for x in members)
                return f[1], sum(x.mass[0] for x in members) if single else NAN
        return "", NAN

    def bodies(self) -> Dict[int, List[Tuple[Body, List[Cohort], str, str]]]:
        """The bodies of each type, which differ in how they move; their cohorts, what holds them, their rigid body."""
        made = [c for c in self.cohorts if c.kind != "assumed"]
        if self.is_liggghts and not any(c.kind == "made" for c in made):
            made += [c for t in self.templates() for c in self.of_template(t, frozenset(("all",)))]
        cohorts = made or self.cohorts or [Cohort(i + 1, kind="assumed") for i in range(max(self.types, 1))]
        classes: Dict[int, Dict[Tuple[str, str, float], List[Cohort]]] = {}
        for c in cohorts:
            classes.setdefault(c.type, {}).setdefault((self.hold(c), *self.rigid(c)), []).append(c)
        found: Dict[int, List[Tuple[Body, List[Cohort], str, str]]] = {}
        for type in sorted(classes):
            for (held, rigid, whole), members in classes[type].items():
                radius = min(c.radius[0] for c in members), max(c.radius[1] for c in members)
                radius = (NAN, NAN) if any(math.isnan(c.radius[0]) for c in members) else radius
                mass = min(c.mass[0] for c in members), max(c.mass[1] for c in members)
                density = members[0].density if all(_same(c.density, members[0].density) for c in members) else NAN
                several = len(classes[type]) > 1
                name = f"{type}{' ' + (held or rigid or 'free') if several else ''}"
                known: Optional[Tuple[float, float]] = mass
                if rigid:
                    known = whole, whole
                elif not math.isnan(density) or any(math.isnan(c.mass[0]) for c in members):
                    known = None
                body = Body(name, radius, density, known, self.material("youngsModulus", type),
                            self.material("poissonsRatio", type), held=bool(held), type=type)  # fmt: skip
                found.setdefault(type, []).append((body, members, held, rigid))
        return found

    def material(self, name: str, type: int) -> float:
        words = self.property(name)
        return words.value(5 + type) if words and 5 + type < len(words) else NAN

    def property(self, name: str) -> Optional[Words]:
        return next(
            (f for f in reversed(list(self.fixes.values())) if f[3].startswith("property/global") and f[4] == name),
            None,
        )

    def snapshot(self, run: int) -> None:
        """Adds the contacts of this moment to the deck."""
        self.script.tick()
        all_bodies = self.bodies()
        types = sorted(all_bodies)
        losses = [
            f"fix {f[1]} ({f[3]}) takes energy outside contacts" + (f": {_LOSSES[f[3]]}." if f[3] in _LOSSES else ".")
            for f in self.fixes.values()
            if f[3] in _LOSSES or _LOSSY.match(f[3])
        ]
        self.run_number = run
        contacts: List[Contact] = []
        if self.other_style is not None:
            text = f"pair_style {self.other_style[1]}: cor knows granular, gran/hooke(/history), gran/hertz/history"
            text += (
                ", LIGGGHTS' gran model, and hybrid with these."
                if not self.style
                else ", and no other force with them."
            )
            self.script.remark(self.other_style.line, text)
        if self.style:
            contacts += self.pair_contacts(all_bodies, types)
        contacts += self.wall_contacts(all_bodies)
        for contact in contacts:
            contact.losses = losses
            self.keep(contact, run)

    def keep(self, contact: Contact, run: int) -> None:
        contact.style = "" if contact.model else contact.style
        contact.speeds, contact.time_step, contact.units = tuple(self.speeds), self.time_step, self.units
        shown = {k: v for k, v in contact.__dict__.items() if k not in ("runs", "repair")}
        key = repr(sorted(shown.items()))
        self.found.add(key)
        if key in self.seen:
            if run and len(self.seen[key].runs) < 1000:
                self.seen[key].runs += (run,)
        elif len(self.deck.contacts) < MAX_CONTACTS + 1:
            contact.runs = (run,) if run else ()
            self.seen[key] = contact
            self.deck.contacts.append(contact)

    def is_excluded(self, one: Sequence[Cohort], two: Sequence[Cohort]) -> bool:
        def both(a: Cohort, b: Cohort) -> bool:
            for how, x, y in self.excluded:
                i, j = (a.groups, b.groups) if how == "group" else ({str(a.type)}, {str(b.type)})
                if (x in i and y in j) or (x in j and y in i):
                    return True
            return False

        return bool(self.excluded) and all(both(a, b) for a in one for b in two)

    def pair_contacts(self, all_bodies: Any, types: List[int]) -> Iterator[Contact]:
        """The contacts of pairs. Pairs of one line whose bodies are alike are one contact, with * in its name."""
        lines: Dict[int, List[Tuple[int, int, Optional[Coefficient], Optional[Coefficient]]]] = {}
        for n, i in enumerate(types):
            for j in types[n:]:
                own, other = self.resolve(i, j)
                lines.setdefault(id(own) if own and not other else -i * 4096 - j, []).append((i, j, own, other))
        bodies = [b for i in types for b in all_bodies[i]]
        plain = [replace(b[0], name="", type=0) for b in bodies]
        alike = all(_same(plain[0], b) for b in plain) and not bodies[0][3] and not bodies[0][2]
        alike = alike and self.has_one_size() and not self.excluded
        whole = self.types == 0 or self.types == len(types) > 1
        for pairs in lines.values():
            own = pairs[0][2]
            if alike and whole and own and not pairs[0][3] and not self.is_liggghts and len(lines) == 1:
                body = replace(all_bodies[types[0]][0][0], name="*")
                yield self.between(own, None, body, body, "", "")
                continue
            for i, j, own, other in pairs:
                if own is None:
                    continue
                for m, (one, cohorts, held, rigid) in enumerate(all_bodies[i]):
                    for two, partners, holds, fix in all_bodies[j][m if i == j else 0 :]:
                        impossible = (held and holds) or (
                            rigid and rigid == fix and not math.isnan((one.mass or (NAN,))[0])
                        )
                        if not impossible and not self.is_excluded(cohorts, partners):
                            reason = rigid if rigid and one.mass and math.isnan(one.mass[0]) else ""
                            reason = fix if fix and two.mass and math.isnan(two.mass[0]) else reason
                            fixed = "fixed" if "fixed" in (held, holds) else ""
                            yield self.between(own, other, one, two, reason, fixed)

    def model_of(self, of: Coefficient) -> Tuple[str, str]:
        return of.words[of.at], of.words.after("damping", of.at)

    def has_one_size(self) -> bool:
        """True if no option gives a size or density to one type."""
        return not (set(self.options.radii) | set(self.options.densities)) - {""}

    def covers(self, of: Coefficient, i: int, j: int) -> bool:
        return of.first[0] <= i <= of.last[0] and of.first[1] <= j <= of.last[1]

    def resolve(self, i: int, j: int) -> Tuple[Optional[Coefficient], Optional[Coefficient]]:
        """The coefficients of a pair; or, where no line has this pair, the two that LAMMPS mixes."""
        if self.is_liggghts or (not self.coefficients and self.style[0].style != "granular"):
            return (self.style[0] if not self.hybrid else None), None

        def line(a: int, b: int) -> Optional[Coefficient]:
            return next((c for c in reversed(self.coefficients) if self.covers(c, a, b)), None)

        own = line(i, j)
        if own is None:
            one, two = line(i, i), line(j, j)
            if one is not None and two is not None and one.style == two.style and one.part == two.part:
                if one is two or self.model_of(one) == self.model_of(two):
                    return one, (two if one is not two else None)
                text = (
                    f"The types {i} and {j} have different models, which LAMMPS does not mix: it needs a line for them."
                )
                self.script.remark(two.words.line, text, False)
                return None, None
            self.script.remark(self.style[0].words.line, f"The types {i} and {j} have no line pair_coeff.")
        return (None, None) if own and own.part < 0 else (own, None)

    def between(
        self, own: Coefficient, other: Optional[Coefficient], one: Body, two: Body, rigid: str, fixed: str
    ) -> Contact:
        """The contact of two bodies. rigid: the fix whose body has an unknown mass; fixed: one is not integrated."""
        contact = self.matrix(own.words, own.at, one, two) if self.is_liggghts else self.granular(own, one, two)
        if other is not None:
            self.mix(contact, self.granular(other, one, two))
        if rigid and not contact.unknown:
            what = "LIGGGHTS' multisphere" if rigid == "multisphere" else f"fix {rigid}"
            contact.unknown = (
                f"The particles are parts of rigid bodies ({what}), whose mass acts and is not known here."
            )
        elif fixed and contact.model and not contact.unknown:
            self.fix_one(contact)
        return contact

    def fix_one(self, contact: Contact) -> None:
        """One body is not integrated but not frozen either: it damps with the mass of both, and moves as if held."""
        masses = [b.mass[0] if b.mass else _sphere(b.radius[0], b.density) for b in contact.bodies]
        free = masses[1] if contact.bodies[0].held else masses[0]
        share = masses[0] * masses[1] / sum(masses) / free if not contact.bodies[1].wall else 1.0
        name = contact.model.replace("LAMMPS_", "").replace("LIGGGHTS_", "").replace("_LIMIT", "")
        if contact.bodies[1].wall:
            return
        if name in _BY_ROOT or name == "RESTITUTION":
            contact.zeta_factor = math.sqrt(share)
        elif name != "HOOKE_VELOCITY" and name != "HERTZ_VELOCITY":
            contact.number *= share
        contact.notes.append(
            "One body is not moved by its forces, but not frozen either: its mass counts in the damping."
        )

    def new(self, words: Words, one: Body, two: Body, style: str) -> Contact:
        line = words.line
        return Contact(line.file, line.line, self.deck.simulator, (one, two), style=style)

    def set_slots(self, contact: Contact, words: Words, indices: Sequence[int]) -> None:
        if words.line.nested:
            return
        text, contact.slots = words.slots(indices)
        line = words.line
        key = line.file, line.line, text
        contact.repair = self.repairs.setdefault(key, Repair(line.file, line.line, line.last_line, text))

    # -- LAMMPS --

    def granular(self, of: Coefficient, one: Body, two: Body) -> Contact:
        """The contact by the words of a pair style, a pair_coeff or a wall."""
        words, at = of.words, of.at
        contact = self.new(words, one, two, f"{words[0] if words[0] != 'fix' else words[3]} {of.style}")
        try:
            self.read_granular(contact, of, words, at)
        except Unknown as reason:
            contact.model, contact.unknown = "", f"No value is known here of {str(reason)}.".replace("\1", " ")
        return contact

    def read_granular(self, contact: Contact, of: Coefficient, words: Words, at: int) -> None:
        poisson = NAN
        if of.style == "granular":
            force, damping = words[at], words.after("damping", at)
            if force not in _NORMAL:
                if not is_known(force):
                    number(force)
                contact.style, contact.unknown = f"granular {force}", f"cor does not know the normal force {force}."
                return
            stiffness, value = words.number(at + 1), words.number(at + 2)
            if _NORMAL[force] > 2:
                poisson = words.number(at + 3)
                stiffness *= 2 / 3 / (1 - poisson**2) if abs(poisson) < 1 else NAN
            if not damping:
                contact.notes.append("Without the word damping LAMMPS takes viscoelastic.")
                damping = "viscoelastic"
            if damping == "none":
                damping, value = "velocity", 0.0
            contact.unknown = _FAULTS.get(force, "")
            self.set_slots(contact, words, [at + 2])
        else:
            force = "hooke" if of.style.startswith("hooke") else "hertz" if of.style.startswith("hertz") else of.style
            damping = "viscoelastic" if force == "hertz" else "mass_velocity"
            stiffness, value = words.number(at), words.number(at + 2)
        name = f"{'HOOKE' if force == 'hooke' else 'HERTZ'}_{damping.upper()}"
        name = "COEFF_RESTITUTION" if damping == "coeff_restitution" else name
        if name not in _BY_MASS | _BY_ROOT | {"HOOKE_VELOCITY", "HERTZ_VELOCITY"} or force not in _NORMAL:
            contact.style = f"{of.style} {force}, damping {damping}"
            contact.unknown = f"cor does not know damping {damping} of {force}."
            return
        limited = words.find("limit_damping", at) > 0
        contact.model = f"LAMMPS_{name}" + ("_LIMIT" if limited and name in _HAS_LIMIT else "")
        contact.limited = limited and name not in _HAS_LIMIT
        contact.number, contact.stiffness = value, stiffness
        contact.spring = Spring.HOOKE if force == "hooke" else Spring.HERTZ
        contact.is_harmonic = not math.isnan(poisson)  # type: ignore

    def mix(self, contact: Contact, other: Contact) -> None:
        """Sets the numbers that LAMMPS mixes from the lines of both types."""
        contact.repair, contact.slots, contact.line, contact.file = None, (), other.line, other.file
        contact.number = math.sqrt(contact.number * other.number)
        x, y = contact.stiffness, other.stiffness
        contact.stiffness = 2 / (1 / x + 1 / y) if contact.__dict__.get("is_harmonic") else math.sqrt(x * y)
        contact.notes = ["No line for this pair: LAMMPS takes the geometric mean of both types."]

    # -- LIGGGHTS --

    def matrix(self, words: Words, at: int, one: Body, two: Body) -> Contact:
        """The contact of two types by the properties; words[at] is the name of the model."""
        model = words[at]
        contact = self.new(words, one, two, f"gran model {model}")
        if model not in _MODELS:
            contact.unknown = f"cor does not know the contact model {model}; it knows {', '.join(_MODELS)}."
            return contact

        def is_on(name: str) -> bool:
            return words.find(name, at) > 0 and words.after(name, at) != "off"

        stiff = model.endswith("/stiffness")
        kind = ("HERTZ_GAMMAN" if _MODELS[model] else "HOOKE_GAMMAN") if stiff else "RESTITUTION"
        contact.model = f"LIGGGHTS_{kind}" + ("_LIMIT" if is_on("limitForce") else "")
        name = "gamman" if stiff else "coefficientRestitution"
        found = self.property(name)
        i, j = one.type - 1, two.type - 1
        types = int(found.value(6)) if found and found.value(6) >= 1 and found[5] == "peratomtypepair" else 0
        if found is None or max(i, j) >= types or len(found) != 7 + types * types:
            contact.unknown = f"{name} of these types could not be read: a value for each pair of types is needed."
            return contact
        contact.file, contact.line = found.line.file, found.line.line
        places = sorted({7 + i * types + j, 7 + j * types + i})
        contact.number = found.value(places[0])
        if math.isnan(contact.number):
            contact.unknown = f"No value is known here of {name}."
        elif not stiff:
            self.set_slots(contact, found, places)
            speed = self.property("characteristicVelocity")
            contact.spring = Spring.MATERIAL if _MODELS[model] else Spring.CHARACTERISTIC
            contact.spring_speed = speed.value(6) if speed else NAN
            if contact.number <= 0.05:
                contact.unknown = "LIGGGHTS refuses e of 0.05 and less."
        else:
            kn = self.property("kn")
            contact.stiffness = kn.value(7 + i * types + j) if kn and kn.value(6) == types else NAN
            contact.spring = Spring.HERTZ if _MODELS[model] else Spring.HOOKE
        if is_on("cohesion"):
            contact.unknown = "The cohesion changes eps."
        elif is_on("viscous"):
            contact.unknown = "With viscous on the Stokes number of each impact sets the damping."
        elif is_on("absolute_damping"):
            contact.unknown = "With absolute_damping on gamman is replaced by gamman_abs, which is not read."
        return contact

    # -- walls --

    def wall_contacts(self, all_bodies: Any) -> Iterator[Contact]:
        """The contacts with walls, for the types of each wall's group."""
        walls = [
            w
            for f in self.has("wall/gran.*")
            for w in (self.mesh_walls(f) if self.is_liggghts else self.lammps_walls(f))
        ]
        for words, of, type, name, unknown in walls:
            wall = Body(f"wall {name}" if len(walls) > 1 else "wall", wall=True, type=type)
            if self.is_liggghts:
                wall = replace(
                    wall, young=self.material("youngsModulus", type), poisson=self.material("poissonsRatio", type)
                )
            found = []
            for i in sorted(all_bodies):
                for body, cohorts, held, rigid in all_bodies[i]:
                    known = words[2] in self.group_names
                    if held or (known and not any(words[2] in c.groups for c in cohorts)):
                        continue
                    reason = rigid if rigid and body.mass and math.isnan(body.mass[0]) else ""
                    contact = (
                        self.new(words, body, wall, f"{words[3]} {words[4]}")
                        if unknown
                        else self.between(of, None, body, wall, reason, "")
                    )
                    contact.unknown = contact.unknown or unknown
                    contact.gravity = self.pressing(words)
                    found.append(contact)
            plain = [replace(c.bodies[0], name="", type=0) for c in found]
            whole = self.types == 0 or self.types == len(found) > 1
            if (
                not self.is_liggghts
                and whole
                and found
                and self.has_one_size()
                and all(_same(b, plain[0]) for b in plain)
            ):
                found[0].bodies = replace(found[0].bodies[0], name="*"), wall
                found = found[:1]
            yield from found

    def lammps_walls(self, words: Words) -> List[Any]:
        style = _ACCELERATED.sub("", words[4])
        unknown = ""
        of = Coefficient(words, 5, style)
        if words[4][:1].isdigit() or words[4][:1] == ".":  # before 2017: the pair style gives the force
            old = self.style[0].style if self.style else ""
            of = Coefficient(words, 4, old)
            if old == "granular" or not old:
                unknown = "This form of before 2017 has the force of a pair style gran/..., which is absent."
        elif style != "granular" and not re.match("hooke|hertz", style):
            unknown = f"cor does not know the wall {style}."
        return [(words, of, 0, words[1], unknown)]

    def mesh_walls(self, words: Words) -> List[Any]:
        primitive, meshes = words.find("primitive"), words.find("meshes")
        of, walls = Coefficient(words, 5, "model"), []
        if words[4] != "model" or (primitive < 0 and meshes < 0):
            return [(words, of, 0, words[1], f"cor does not know the wall {words[4]}.")]
        count = words.value(words.find("n_meshes") + 1) if primitive < 0 else 1
        for k in range(1, int(count) + 1 if 1 <= count < 10000 else 2):
            mesh = self.fixes.get(words[meshes + k]) if primitive < 0 else words
            type = mesh.value(mesh.find("type") + 1) if mesh else NAN
            name = words[1] + (f" {words[meshes + k]}" if primitive < 0 else "")
            unknown = "" if type >= 1 else f"The type of the wall {name} is not known."
            walls.append((words, of, int(type) if type >= 1 else 0, name, unknown))
        return walls

    def pressing(self, words: Words) -> float:
        """Returns the acceleration that gravity has toward a wall; NaN without."""
        vector = [0.0, 0.0, 0.0]
        for f in self.has("gravity"):
            size, how = f.value(4), f[5]
            x, y, z = (f.value(6 + k) for k in range(3))
            if how == "vector":
                length = math.sqrt(x * x + y * y + z * z)
                part = [size * v / length for v in (x, y, z)] if length > 0 else [NAN] * 3
            elif how == "chute":
                part = [size * math.sin(math.radians(x)), 0.0, -size * math.cos(math.radians(x))]
            elif how == "spherical":
                across = size * math.sin(math.radians(y))
                part = [
                    across * math.cos(math.radians(x)),
                    across * math.sin(math.radians(x)),
                    size * math.cos(math.radians(y)),
                ]
            else:
                part = [NAN] * 3
            if how == "chute" and self.dimension == 2:
                part = [part[0], part[2], 0.0]
            vector = [a + b for a, b in zip(vector, part)]
        plane = next((i for i in range(4, len(words)) if re.fullmatch("[xyz]plane", words[i])), 0)
        if not plane:
            return math.sqrt(sum(v * v for v in vector)) or NAN
        g = vector["xyz".index(words[plane][0])]
        if not self.is_liggghts:
            g = -g if (words[plane + 1] != "NULL" and g < 0) else g if (words[plane + 2] != "NULL" and g > 0) else NAN
        return abs(g) or NAN


def _read(simulator: str, text: str, name: str, options: Options) -> Deck:
    deck = Deck(name, simulator)
    script = Script(options)
    system = Granular(deck, script, options)
    script.run(text, name, system)
    deck.remarks += script.remarks.values()
    deck.facts["runs"] = tuple(system.runs)
    return deck


def read_lammps(text: str, name: str, options: Options) -> Deck:
    """Reads a script of LAMMPS."""
    return _read("lammps", text, name, options)


def read_liggghts(text: str, name: str, options: Options) -> Deck:
    """Reads a script of LIGGGHTS."""
    return _read("liggghts", text, name, options)
