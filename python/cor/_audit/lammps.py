# SPDX-License-Identifier: MIT
"""Reads contacts of LAMMPS and LIGGGHTS: the state of a script's system, and its contacts at each run.

Atoms are stored as cohorts. A cohort is all atoms that one command created; it is divided if a command changes a part.
A script without atoms has one cohort of unknown size for each type."""

import copy
import math
import re
from dataclasses import dataclass, replace
from itertools import chain
from typing import Any, Dict, FrozenSet, Iterator, List, Optional, Sequence, Tuple

from .._cor import lib
from .clump import MOST, clump, superquadric

from .deck import (
    MAX_CONTACTS, NAN, NO_FRICTION, ROLLS, Body, Contact, Deck, Options, Remark, Repair, Spring, Tangential, Units,
    share,
)  # fmt: skip
from .script import SIGNS, OutOfBounds, Script, System, Unknown, Words, is_known, number

MAX_COHORTS, MAX_TYPES, MAX_LINES, MANY = 1000, 200, 20000, 1 << 30
# For each `units`: length, mass and time in SI, and the default time step in these units
UNITS = {
    "si": (1.0, 1.0, 1.0, 1e-8),
    "cgs": (1e-2, 1e-3, 1.0, 1e-8),
    "micro": (1e-6, 1e-15, 1e-6, 2.0),
    "nano": (1e-9, 1e-21, 1e-9, 4.5e-4),
    "lj": (1.0, 1.0, 1.0, 0.005),
}
_ACCELERATED = re.compile(r"/(omp|opt|gpu|intel|kk(/device|/host)?)$")
_INTEGRATES = re.compile(r"(nve|nvt|npt|nph|rigid|multisphere|poems|brownian|nvk|bd)(/|$)")
# Styles of fixes that move atoms by the force and the mass. Other styles with such a prefix may change eps.
_MOVES = re.compile(
    r"nve(/(sphere|limit|noforce|asphere|asphere/noforce|superquadric|nonspherical|body|line|tri|bpm/sphere))?|"
    r"n(vt|pt|ph)(/(sphere|asphere|body|sllod|uef))?|rigid(/n(ve|vt|pt|ph))?(/small)?|multisphere(/advanced)?|poems|"
    r"brownian(/a?sphere)?|nvk|bd(/a?sphere)?"
)
_LOSSES = re.compile(
    r"(viscous|langevin|temp|press|drag|nvt|npt|nph|gld|ttm|lb|srd|couple/cfd|deform)(/.*)?$|nve/limit$|addforce$"
)
_KNOWN_FIXES = re.compile(
    "(?!gravity/|freeze/)"
    "(adapt|addforce|addtorque|ave|balance|box|check|concentration|contact|controller|couple|cfd|deform|deposit|"
    "drag|dt|dummy|enforce2d|evaporate|external|freeze|gld|gravity|halt|heat|indent|insert|langevin|lb|lineforce|"
    "massflow|mesh|momentum|move|multisphere|neigh|nph|npt|nve|nvt|particle|planeforce|poems|pour|press|print|"
    "property|propel|recenter|region|remove|restrain|rigid|scalar|set|spring|srd|store|temp|thermal|transport|ttm|"
    "vector|viscous|volume|wall|bd|brownian)"
    "(/.*|force|template.*|distribution.*|tracker.*)?$"
)
_NORMAL = {"hooke": 2, "hertz": 2, "hertz/material": 3, "dmt": 4, "jkr": 4}  # number of coefficients
_BY_MASS = ("HOOKE_MASS_VELOCITY", "HOOKE_VISCOELASTIC", "HERTZ_VISCOELASTIC", "HERTZ_MASS_VELOCITY")
_BY_ROOT = ("HOOKE_TSUJI", "HERTZ_TSUJI", "COEFF_RESTITUTION")  # damping is proportional to the root of the mass
_KNOWN = _BY_MASS + _BY_ROOT + ("HOOKE_VELOCITY", "HERTZ_VELOCITY")
_MIXES_SINCE = 20221103  # earlier, LAMMPS uses damping velocity for every mixed pair
_MODELS = ("hertz", "hooke", "hertz/stiffness", "hooke/stiffness")  # models of LIGGGHTS
_OLD_MODEL = re.compile(r"gran/(hertz|hooke)(/history|/incremental)?(/energy)?(/stiffness)?")  # before version 3
# _TANGENTIAL: tangential models whose stiffness follows the contact radius. _OLD: old pair style -> tangential model
_TANGENTIAL = ("mindlin", "mindlin/force", "mindlin_rescale", "mindlin_rescale/force")
_OLD = {"hooke": "linear_nohistory", "hooke/history": "linear_history", "hertz/history": "mindlin"}
_MIXED = "LAMMPS mixes the tangential forces of two types"
_STILL = "a fix without /sphere moves the particles, or they are discs"


@dataclass
class Cohort:
    """Atoms of one type. radius and mass: least and largest. kind: created by a command, read from a file, "unread"
    (the file is absent), or assumed. count and id: 0 if unknown. at: lower and upper x, y and z, and within: the
    region, both until the atoms move. is_rest: the part of divided atoms that was not chosen, which may contain no
    atom. body: "", or the kind of body to which each atom belongs; mass and lever belong to this body, too.
    shape: half sides and powers of a superquadric."""

    type: int
    radius: Tuple[float, float] = (NAN, NAN)
    mass: Tuple[float, float] = (NAN, NAN)
    density: float = NAN
    kind: str = "made"
    count: int = 0
    id: int = 0
    at: Tuple[float, ...] = ()
    within: Optional[Words] = None
    is_rest: bool = False
    groups: FrozenSet[str] = frozenset(("all",))
    body: str = ""
    lever: Tuple[float, float] = (0.0, 0.0)
    shape: Tuple[float, ...] = ()

    @classmethod
    def of(cls, type: float, radius: Sequence[float], density: Sequence[float], **more: Any) -> "Cohort":
        mass = _sphere(radius[0], density[0]), _sphere(radius[-1], density[-1])
        return cls(int(type), (radius[0], radius[-1]), mass, density[0] if density[0] == density[-1] else NAN, **more)


@dataclass
class Coefficient:
    """A line that defines a normal force: a pair style, a pair_coeff line, or a wall.

    at: index of a word, which is the model (granular) or K_n (gran). style: such as "hooke/history" or "granular".
    first and last: the range of both types. part: the part of a hybrid style."""

    words: Words
    at: int
    style: str
    first: Tuple[int, int] = (1, 1)
    last: Tuple[int, int] = (MANY, MANY)
    part: int = 0

    def covers(self, i: int, j: int) -> bool:
        return self.first[0] <= i <= self.last[0] and self.first[1] <= j <= self.last[1]

    def model(self) -> Tuple[str, str]:
        return self.words[self.at], self.words.after("damping", self.at)


@dataclass
class Moving:
    """The atoms of a type that move in the same way. held: "freeze", "fixed" or "". rigid: the fix of their body."""

    body: Body
    cohorts: List[Cohort]
    held: str
    rigid: str


def _span(word: str) -> Tuple[int, int]:
    """Returns the range of types of "3", "*", "2*", "*4", "2*4" or "2:4"."""
    found = re.fullmatch(r"(\d*)([*:]?)(\d*)", word)
    if not found or not word:
        number(word)
        raise Unknown(f"types {word}")
    first = int(found[1] or 1)
    return first, (int(found[3] or MANY) if found[2] else first)


def _sphere(radius: float, density: float) -> float:
    return 4 * math.pi / 3 * radius**3 * density


def _rows(text: str, width: int) -> List[List[float]]:
    """Returns the numbers of a text in rows; no row if the text has another form."""
    try:
        numbers = [float(word) for word in text.split()]
    except ValueError:
        return []
    whole = len(numbers) % width == 0
    return [numbers[i : i + width] for i in range(0, len(numbers), width)] if whole else []


def _same(x: Any, y: Any) -> bool:
    return repr(x) == repr(y)


class Granular(System):
    """The system of a LAMMPS or LIGGGHTS script."""

    def __init__(self, deck: Deck, script: Script, options: Options):
        self.deck, self.script, self.options = deck, script, options
        self.is_liggghts = deck.simulator == "liggghts"
        self.version = lib.cor_simulator_version(options.version.encode()) if options.version else 0
        self.seen: Dict[str, Contact] = {}
        self.repairs: Dict[Tuple[str, int, str], Repair] = {}
        self.runs = [0]  # number of runs; one list for all worlds
        self.courses: List[FrozenSet[str]] = []  # keys of the contacts of each ended world; one list for all worlds
        self.found: List[str] = []  # keys of this world's contacts
        self.restart()

    def restart(self) -> None:
        """Begins an empty system, as `clear` does."""
        self.units, self.time_step, self.fault = Units("lj"), UNITS["lj"][3], ""
        self.dimension, self.types, self.step, self.atom_style, self.is_scaled = 3, 0, 0, "", False
        self.cohorts: List[Cohort] = []
        self.group_names: Dict[str, bool] = {"all": True}
        self.groups_known = True
        self.groups_of_types: Dict[Any, Any] = {("all", ""): lambda c: True}  # groups that depend only on types
        self.regions: Dict[str, Words] = {}
        self.molecules: Dict[str, List[Cohort]] = {}
        self.box: Optional[Words] = None
        self.fixes: Dict[str, Words] = {}
        self.style: List[Coefficient] = []
        self.hybrid = ""
        self.other_style: Optional[Words] = None
        self.coefficients: Dict[Any, Coefficient] = {}
        self.excluded: List[List[str]] = []
        self.speeds: List[float] = []
        self.sized: Optional[Words] = None  # the last line that sets diameters
        self.velocities: Dict[str, Tuple[float, ...]] = {}  # by group
        self.created = 0  # atoms; -1: unknown
        self.is_run, self.is_changed, self.has_unread_atoms = False, True, False
        self.still: Optional[Words] = None  # the last run, if no fix moves atoms in it
        self.last: List[Contact] = []  # contacts of the last snapshot

    def copy(self) -> "Granular":
        other = copy.copy(self)
        for name, value in self.__dict__.items():
            if isinstance(value, (list, dict)) and name not in ("seen", "repairs", "runs", "courses"):
                setattr(other, name, copy.copy(value))
        other.cohorts = [replace(c) for c in self.cohorts]
        return other

    def count(self) -> int:
        return len(self.seen)

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
        raise Unknown(f"{name}, which has a value only during a run")

    def is_defined(self, category: str, name: str) -> bool:
        known: Dict[str, Any] = {"fix": self.fixes, "group": self.group_names, "region": self.regions}
        if category not in known:
            raise Unknown(f"is_defined({category},{name})")
        return name in known[category]

    # ---- commands ----

    def on_units(self, words: Words) -> None:
        if words[1] not in UNITS:
            self.fault = f"Numbers in units {words[1]} are not consistent; cor reads units {', '.join(UNITS)}."
            return
        length, mass, time, self.time_step = UNITS[words[1]]
        self.units = Units(words[1], length, mass, time)

    def on_timestep(self, words: Words) -> None:
        self.time_step = NAN
        step = words.number(1)
        if step <= 0:
            raise Unknown(f"timestep {words[1]}, which is not above 0")
        self.time_step = step

    def on_dimension(self, words: Words) -> None:
        self.dimension = int(words.number(1))

    def on_atom_style(self, words: Words) -> None:
        self.atom_style = " ".join(words[1:])

    def on_region(self, words: Words) -> None:
        self.regions.pop(words[1], None)
        if words[2] != "delete":
            is_known_size = not self.is_scaled or words.after("units", 4) == "box"
            self.hold_line(self.regions, words[1], words if is_known_size else Words(words.line, []))

    def on_lattice(self, words: Words) -> None:
        self.is_scaled = words[1] != "none"

    def on_change_box(self, words: Words) -> None:
        self.box = None

    def on_create_box(self, words: Words) -> None:
        self.set_types(int(words.number(1)), "assumed")
        self.box = self.regions.get(words[2])

    def set_types(self, count: int, kind: str) -> None:
        if count > MAX_TYPES:
            raise OutOfBounds(f"The script has {count} types; cor reads {MAX_TYPES} at most.")
        self.types = max(self.types, count)
        self.cohorts += [Cohort(i + 1, kind=kind) for i in range(self.types)]

    def on_read_data(self, words: Words) -> None:
        """Reads the types of a data file, and the sizes and densities of its atoms if they are spheres."""
        self.created, self.box = -1, None
        self.groups_known &= words[0] == "read_data" and words.find("group", 2) < 0
        found = self.options.include(words[1], words.line.file) if is_known(words[1]) else None
        text = found[0] if found and words[0] == "read_data" else ""
        if found is None and words[0] == "read_data" and is_known(words[1]):
            self.script.remark(words.line, f"The file {words[1]} cannot be read.", False)
        types = re.search(r"^\s*(\d+)\s+atom types", text, re.M)
        atoms = re.search(r"^Atoms\b.*$", text, re.M)
        sizes: Dict[int, List[float]] = {}
        if atoms and (self.atom_style in ("sphere", "granular") or "sphere" in atoms[0]):
            for row in re.finditer(r"\n\s*\d+ +(\d+) +([\d.eE+-]+) +([\d.eE+-]+) .*|\n\s*[A-Z]", text[atoms.end() :]):
                self.script.tick()
                if row[1] is None:
                    break
                radius, density = number(row[2]) / 2, number(row[3])
                s = sizes.setdefault(int(row[1]), [radius, radius, density, density])
                s[:] = min(s[0], radius), max(s[1], radius), min(s[2], density), max(s[3], density)
        if sizes:
            self.set_types(int(types[1]) if types else 0, "file")
            self.cohorts = [c for c in self.cohorts if c.kind != "file"]
            self.cohorts += [Cohort.of(type, s[:2], s[2:], kind="file") for type, s in sizes.items()]
        else:
            self.set_types(int(types[1]) if types else 0, "file" if types else "unread")
            self.has_unread_atoms |= not types

    on_read_restart = on_read_dump = on_read_data

    def on_create_atoms(self, words: Words) -> None:
        is_single = words[2] == "single"
        self.created = self.created + 1 if is_single and self.created >= 0 else -1
        if words.find("mol") > 0:
            self.set_types(0, "file")
            return
        made = Cohort.of(words.number(1), [0.5], [1.0], count=int(is_single), id=max(self.created, 0))
        if is_single:
            made.at = tuple(words.value(3 + i // 2) for i in range(6)) if not self.is_scaled else ()
        else:
            made.within = self.regions.get(words[{"region": 3, "random": 5}.get(words[2], 0)], self.box)
            made.at = self.ends(made.within) if "out" not in (made.within or ()) else ()
        if self.atom_style.startswith("superquadric"):
            made.body, made.shape = "superquadric", (NAN, NAN, NAN, 2.0, 2.0)
        self.set_density(made, 1.0)
        last = self.cohorts[-1] if self.cohorts else made
        if len(self.cohorts) < MAX_COHORTS:
            self.cohorts.append(made)
        elif _same(*(replace(c, count=0, id=0, at=(), within=None) for c in (last, made))):
            last.count, last.id, last.at, last.within = last.count + 1, 0, (), None
        else:
            raise OutOfBounds(f"The script makes more than {MAX_COHORTS} kinds of atoms; the rest is not read.")

    def divide(self, inside: Any) -> List[Cohort]:
        """Divides the cohorts that are partly inside. Returns the cohorts inside. inside: a function of a cohort that
        returns True, False or None (partly)."""
        chosen = []
        for cohort in list(self.cohorts):
            here = inside(cohort)
            if here is None and len(self.cohorts) < MAX_COHORTS:
                self.cohorts.append(replace(cohort, count=0, id=0, is_rest=True))
            if here is not False:
                chosen.append(cohort)
        return chosen

    def ends(self, region: Optional[Words]) -> Tuple[float, ...]:
        """Returns lower and upper x, y and z of a block; () if they are unknown."""
        if region is None or region[2] != "block" or "rotate" in region or "move" in region:
            return ()
        far = ({"INF": math.inf, "EDGE": math.inf}.get(word, NAN) for word in region[3:9])
        ends = tuple(region.value(3 + i) if math.isnan(x) else x * (-1) ** (i + 1) for i, x in enumerate(far))
        return () if any(map(math.isnan, ends)) else ends

    def in_region(self, cohort: Cohort, name: str) -> Optional[bool]:
        region = self.regions.get(name)
        if region is not None and (region is cohort.within or region is self.box):
            return True
        inner, outer = cohort.at, self.ends(region)
        if region is None or not inner or not outer or any(map(math.isnan, inner)):
            return None
        axes = [(*inner[i : i + 2], *outer[i : i + 2]) for i in (0, 2, 4)]
        is_inside = all(low <= a and b <= high for a, b, low, high in axes)
        is_apart = any(b < low or high < a for a, b, low, high in axes)
        return is_inside == ("out" not in region) if is_inside or is_apart else None

    def selected(self, how: str, what: Sequence[str]) -> Any:
        """Returns a function of a cohort: None if only a part of it is in the types, ids, group or region, otherwise
        True or False."""
        if how in ("type", "id") and len(what) > 1 and re.match("[<>=!]", what[0]):
            x, y = number(what[1]), number(what[-1])
            sign: Any = SIGNS.get(what[0], lambda of, low: bool(low <= of <= y))
            return lambda c: bool(sign(c.type if how == "type" else c.id, x)) if how == "type" or c.id else None
        if how in ("type", "id", "atom"):
            spans = [_span(word) for word in what]
            if (1, MANY) in spans:
                return lambda c: True
            if how == "type":
                return lambda c: any(a <= c.type <= b for a, b in spans)
            return lambda c: any(a <= c.id <= b for a, b in spans) if c.id else None
        if how in ("group", "union"):
            return lambda c: any(g in c.groups for g in what)
        if how == "subtract":
            return lambda c: what[0] in c.groups and not any(g in c.groups for g in what[1:])
        if how == "intersect":
            return lambda c: all(g in c.groups for g in what)
        if how == "dynamic":
            return lambda c: None if what[0] in c.groups else False
        return lambda c: self.in_region(c, what[0]) if how == "region" else None

    def unread(self, type: int) -> Cohort:
        """Returns atoms of a type that are not in the text. Their groups are known if types define these."""
        made = Cohort(type, kind="unread")
        for (name, _), inside in self.groups_of_types.items():
            made.groups |= {name} if inside(made) else set()
        return made

    def is_sure(self, group: str) -> bool:
        """True if only the types of atoms define a group."""
        return any(name == group for name, _ in self.groups_of_types)

    def may_have(self, group: str, c: Cohort) -> bool:
        """True if a cohort is in a group, or if the text does not contain this."""
        is_unknown = group not in self.group_names or (c.kind == "unread" and not self.is_sure(group))
        return group in c.groups or is_unknown

    def on_group(self, words: Words) -> None:
        name, how, what = words[1], words[2], words[3:]
        is_sure = how == "type" or (how in ("union", "subtract", "intersect") and all(map(self.is_sure, what)))
        is_sure &= name not in self.group_names or self.is_sure(name)
        if not is_sure:
            self.groups_of_types = {key: x for key, x in self.groups_of_types.items() if key[0] != name}
        if how == "dynamic":
            self.group_names.pop(name, None)  # the atoms of the group are unknown
            self.groups_known = False
        else:
            self.hold_line(self.group_names, name, True)
        if how in ("delete", "clear"):
            for cohort in self.cohorts:
                cohort.groups -= {name}
            return
        inside = self.selected(how, what) if what else None
        if is_sure and what:
            self.hold_line(self.groups_of_types, (name, words.expanded), inside)
        for cohort in self.divide(inside) if what else ():
            cohort.groups |= {name}

    def on_set(self, words: Words) -> bool:
        wanted = "diameter density density/disc mass type type/fraction type/ratio type/subset".split()
        wanted += ["shape", "blockiness", "roundness"]
        keys = [i for i in range(3, len(words) - 1) if words[i] in wanted]
        if self.has_unread_atoms and keys and words[1] in ("type", "group"):  # all atoms of a type of a restart file
            types = [int(words.value(2))] if words[1] == "type" and words[2].isdigit() else []
            types = list(range(1, 1 + self.count_types())) if words[1:3] == ["group", "all"] else types
            held = {c.type for c in self.cohorts if c.kind == "unread"}
            self.cohorts += [self.unread(i) for i in types if i not in held]
        chosen = self.divide(self.selected(words[1], [words[2]])) if keys else []
        self.sized = words if "diameter" in words else self.sized
        for i in keys if chosen else []:
            value, key = words.value(i + 1), words[i]
            if key.startswith("type/"):
                ids = [id(c) for c in chosen]
                chosen = self.divide(lambda c: None if id(c) in ids else False)
            for cohort in chosen:
                if key.startswith("type"):
                    cohort.type = int(value) if value >= 1 else cohort.type
                elif key in wanted[-3:]:
                    if cohort.shape and key == "shape":
                        cohort.shape = (*(words.value(i + k) for k in (1, 2, 3)), *cohort.shape[3:])
                    elif cohort.shape:
                        cohort.shape = (*cohort.shape[:3], value, words.value(i + 2))
                    self.set_density(cohort, cohort.density)
                elif key == "mass":
                    cohort.mass, cohort.density = (value, value), NAN
                elif key == "diameter":
                    cohort.radius, cohort.is_rest = (value / 2, value / 2), False
                    if cohort.kind == "assumed" or (self.is_liggghts and cohort.density > 0):
                        self.set_density(cohort, cohort.density)
                    else:
                        cohort.density = NAN  # LAMMPS keeps the mass
                else:
                    self.set_density(cohort, value, key == "density/disc")
        return bool(keys)

    def set_density(self, cohort: Cohort, density: float, is_disc: bool = False) -> None:
        if cohort.shape:
            volume, radius, cohort.lever = superquadric(*cohort.shape)
            cohort.radius, cohort.mass, cohort.density = (radius, radius), (volume * density, volume * density), density
            return
        is_disc = is_disc or (self.is_liggghts and self.dimension == 2)
        least, largest = (math.pi * r**2 * density if is_disc else _sphere(r, density) for r in cohort.radius)
        cohort.mass, cohort.density = (least, largest), NAN if is_disc else density

    def on_delete_atoms(self, words: Words) -> None:
        if words[1] in ("group", "region"):
            inside = self.selected(words[1], [words[2]])
            self.cohorts = [c for c in self.cohorts if c.kind == "assumed" or inside(c) is not True]
        self.created = -1

    def on_velocity(self, words: Words) -> None:
        if words[2] == "set" and len(self.velocities) < 8:
            values = [0.0 if w == "NULL" else words.value(3 + i) for i, w in enumerate(words[3:6])]
            self.velocities[words[1]] = tuple(0.0 if math.isnan(x) else x for x in values)

    def speeds_of(self, is_wall: bool) -> Tuple[float, ...]:
        """Returns the speeds of insertions and groups. Groups have speeds relative to each other, unless is_wall is
        true."""
        moving = list(self.velocities.values())
        relative = [math.dist(a, b) for i, a in enumerate(moving) for b in moving[:i]]
        speeds = relative if relative and not is_wall else [math.hypot(*v) for v in moving]
        return tuple(dict.fromkeys([*self.speeds, *(v for v in speeds if 0 < v < math.inf)]))[:8]

    def add_speed(self, words: Words, at: int, count: int = 3) -> None:
        speed = math.hypot(*(x for x in (words.value(at + i) for i in range(count)) if not math.isnan(x)))
        if 0 < speed < math.inf and speed not in self.speeds and len(self.speeds) < 8:
            self.speeds.append(speed)

    def on_fix(self, words: Words) -> None:
        style = _ACCELERATED.sub("", words[3])
        self.fixes.pop(words[1], None)
        self.hold_line(self.fixes, words[1], words)
        groups = frozenset(("all", words[2]))
        if self.types and self.groups_known and is_known(words[2]) and words[2] not in self.group_names:
            text = f"The group {words[2]} does not exist here: the program stops with an error."
            self.script.remark(words.line, text)
        if style in ("pour", "pour/legacy", "deposit"):
            self.pour(words, style != "deposit", groups)
            self.created = -1
        elif style.startswith(("insert/", "pour/")):
            if words.after("vel", 4) == "constant":
                self.add_speed(words, words.find("vel", 4) + 2)
            distribution = self.fixes.get(words.after("distributiontemplate", 4))
            named = [self.fixes[n] for n in (distribution or [])[6::2] if n in self.fixes]
            groups |= {distribution[2]} if distribution else set()
            self.cohorts += [c for f in named or self.templates() for c in self.of_template(f, groups)]
            self.created = -1

    def on_unfix(self, words: Words) -> None:
        self.fixes.pop(words[1], None)

    def pour(self, words: Words, is_pour: bool, groups: FrozenSet[str]) -> None:
        type = int(words.number(5))
        if "mol" in words[6:] or "rigid" in words[6:]:
            name = words.after("mol", 6)
            free = {} if "rigid" in words else {"body": "", "mass": (NAN, NAN), "lever": (0.0, 0.0)}
            made = [replace(c, type=c.type + type, groups=groups, **free) for c in self.molecules.get(name, ())]
            self.cohorts += made or [Cohort(type or 1, groups=groups, body=f"molecule {name}", lever=(NAN, NAN))]
            return
        at, sizes = words.find("diam", 6), [1.0]
        if is_pour and at > 0:
            count = words.value(at + 2) if words[at + 1] == "poly" else NAN
            sizes = [words.value(at + 3 + 2 * i) for i in range(int(count) if 1 <= count <= MAX_TYPES else 0)]
            first = self.first_of(words, "diam")
            sizes = sizes or [words.value(first), words.value(first + (words[at + 1] != "one"))]
        at = self.first_of(words, "dens") if is_pour else 0
        density = [words.value(at), words.value(at + 1)] if at > 0 else [1.0]
        self.cohorts.append(Cohort.of(type, [min(sizes) / 2, max(sizes) / 2], density, groups=groups))
        if is_pour and words.find("vel", 6) > 0:
            self.add_speed(words, self.first_of(words, "vel") + (4 if self.dimension == 3 else 3), 1)

    def first_of(self, words: Words, key: str) -> int:
        """Returns the index of the first number after a keyword of fix pour, or 0. LIGGGHTS has a word in between."""
        at = words.find(key, 6)
        return at + 1 + math.isnan(words.value(at + 1)) if at > 0 else 0

    def templates(self) -> List[Words]:
        return [f for f in self.fixes.values() if f[3].startswith("particletemplate/")]

    def of_template(self, words: Words, groups: FrozenSet[str]) -> List[Cohort]:
        """Reads a template: particletemplate/sphere SEED atom_type 1 density constant 2500 radius constant 0.005."""
        type = words.value(words.find("atom_type", 4) + 1) if words.find("atom_type", 4) > 0 else 1.0
        limits = []
        for i in (words.find("radius", 4), words.find("density", 4)):
            count = {"constant": 1, "uniform": 2}.get(words[i + 1], 0) if i > 0 else 0
            limits.append([words.value(i + 2 + k) for k in range(count)] or [NAN])
        made = Cohort.of(type, *limits, groups=groups | {words[2]}) if type >= 1 else None
        if made and words[3] != "particletemplate/sphere":
            made.body, made.radius, made.mass, made.lever = f"body {words[1]}", (NAN, NAN), (NAN, NAN), (NAN, NAN)
            self.shape_template(made, words, limits[1])
        return [made] if made else []

    def shape_template(self, made: Cohort, words: Words, density: List[float]) -> None:
        """Reads the size of the body of a template: spheres X Y Z R ..., or shape constant A B C."""
        volume, at = NAN, words.find("spheres", 4) + 1
        if words[3] in ("particletemplate/multisphere", "particletemplate/multiplespheres") and at > 0:
            count, scale = words.value(words.find("nspheres", 4) + 1), 1.0
            text = " ".join(words[at : at + (4 * int(count) if 0 < count <= MOST else 0)])
            if words[at] == "file":
                found = self.options.include(words[at + 1], words.line.file)
                text, scale = re.sub("#.*", "", found[0] if found else ""), words.value(at + 3)
            spheres = _rows(text, 4)
            volume, made.lever = clump(tuple(tuple(scale * x for x in row) for row in spheres))
            radii = [scale * row[3] for row in spheres] or [NAN]
            made.radius = min(radii), max(radii)
            if words[3].endswith("multiplespheres"):  # free spheres
                made.body, made.lever = "", (0.0, 0.0)
                made.mass = _sphere(min(radii), density[0]), _sphere(max(radii), density[-1])
                return
            if words.find("mass", at) > 0:
                made.mass, made.lever = (words.value(words.find("mass", at) + 1),) * 2, (NAN, NAN)
                return
        elif words[3] == "particletemplate/superquadric":
            sides, powers, half = (words.find(key, 4) for key in ("shape", "blockiness", "size"))
            shape = [words.value(sides + k) for k in (2, 3, 4)] if sides > 0 else [words.value(half + 2) / 2] * 3
            shape += [words.value(powers + k) for k in (2, 3)] if powers > 0 else [2.0, 2.0]
            is_constant = all(words[k + 1] == "constant" for k in (sides, powers, half) if k > 0) and sides + half > 0
            volume, radius, made.lever = superquadric(*(shape if is_constant else [NAN] * 5))
            made.radius = radius, radius
        made.mass = volume * density[0], volume * density[-1]

    def on_molecule(self, words: Words) -> None:
        """Reads a molecule of LAMMPS: a rigid body of spheres, which fix pour inserts."""
        found = self.options.include(words[2], words.line.file) if is_known(words[2]) else None
        text = re.sub("#.*", "", found[0] if found else "")
        columns: Dict[str, List[List[float]]] = {}
        for part in re.finditer(r"^[ \t]*(Coords|Types|Diameters|Masses)\s*\n((?:\s*\d.*\n?)+)", text, re.M):
            columns[part[1]] = [row[1:] for row in sorted(_rows(part[2], 4 if part[1] == "Coords" else 2))]
        spheres = [[*at, size / 2] for at, (size,) in zip(columns.get("Coords", ()), columns.get("Diameters", ()))]
        masses = [mass for mass, in columns.get("Masses", ())] or [_sphere(s[3], 1.0) for s in spheres]
        types = [int(type) for type, in columns.get("Types", ())] or [0] * len(spheres)
        self.molecules[words[1]] = []
        if len(spheres) == len(masses) == len(types) > 0:
            has_inertia = re.search(r"\d\s+inertia\b", text)
            lever = (NAN, NAN) if has_inertia else clump(tuple(tuple(s) for s in spheres), tuple(masses))[1]
            given = re.search(r"([\d.eE+-]+)\s+mass\b", text)
            mass = number(given[1]) if given else sum(masses)
            for type in sorted(set(types)):
                radii = [s[3] for s, of in zip(spheres, types) if of == type]
                made = Cohort(type, (min(radii), max(radii)), (mass, mass), body=f"molecule {words[1]}", lever=lever)
                self.molecules[words[1]].append(made)

    def on_neigh_modify(self, words: Words) -> None:
        for i in (i for i, word in enumerate(words) if word == "exclude"):
            self.excluded = [] if words[i + 1] == "none" else self.excluded[-99:] + [words[i + 1 : i + 4]]

    def on_pair_style(self, words: Words) -> None:
        name = _ACCELERATED.sub("", words[1])
        self.coefficients, self.style = {}, []
        self.hybrid = name if name.startswith("hybrid") else ""
        for i in range(2, len(words)) if self.hybrid else [1]:
            style = _ACCELERATED.sub("", words[i])
            if re.match(r"gran(ular|/|$)", style):
                is_model = style == "gran" and words[i + 1] == "model"
                at = i + 1 if not self.is_liggghts else i + 2 if is_model else i
                self.style.append(Coefficient(words, at, style.replace("gran/", "", 1), part=len(self.style)))
        self.other_style = words if not self.style and name not in ("none", "zero") else None

    def on_pair_coeff(self, words: Words) -> None:
        if self.is_liggghts or len(words) < 3:
            return
        (a, b), (c, d) = _span(words[1]), _span(words[2])
        if a == b and c == d and c < a:
            a, b, c, d = c, d, a, b
        at, of = 3, self.style[0] if self.style else Coefficient(words, 3, "")
        if self.hybrid:
            style = _ACCELERATED.sub("", words[3]).replace("gran/", "", 1)
            same = [s for s in self.style if s.style == style]
            numbered = len(same) > 1 and words[4].isdigit()
            at, k = (5, int(words[4]) - 1) if numbered else (4, 0)
            of = same[k] if k < len(same) else Coefficient(words, at, "", part=-1)
        if of.style == "granular":
            of = replace(of, words=words, at=at)
        key = a, b, c, d, of.part
        self.coefficients.pop(key, None)
        self.hold_line(self.coefficients, key, replace(of, first=(a, c), last=(b, d)))

    def hold_line(self, lines: Dict[Any, Any], key: Any, line: Any) -> None:
        if len(lines) >= MAX_LINES:
            raise OutOfBounds(f"The script has more than {MAX_LINES} lines of one kind; the rest is not read.")
        lines[key] = line

    def on_clear(self, words: Words) -> None:
        self.end_system()
        self.restart()

    def end_system(self) -> None:
        if not self.is_run:
            if self.snapshot(0) and self.still:
                text = "No fix moves atoms in this run: the contacts are judged as if all atoms moved."
                self.script.remark(self.still.line, text, False)

    def on_run(self, words: Words) -> bool:
        self.runs[0] += 1
        has_atoms = self.has_unread_atoms or any(c.kind != "assumed" for c in self.cohorts)
        self.still = words if has_atoms and not self.moved() and words[0] == "run" else None
        if self.is_changed and not self.still:
            self.last = self.snapshot(self.runs[0])
        for contact in () if self.is_changed or self.still else self.last:
            contact.runs = (*contact.runs[:999], self.runs[0])
        self.is_changed = False
        self.is_run |= self.still is None
        self.on_displace_atoms(words)
        steps = words.value(1) if words[0] == "run" else NAN
        is_known_step = self.step >= 0 and 0 <= steps < math.inf
        self.step = -1 if not is_known_step else int(steps) + (0 if "upto" in words else self.step)
        return False

    on_minimize = on_run

    def on_displace_atoms(self, words: Words) -> None:
        for c in self.cohorts if words[1] != "0" else ():
            c.at, c.within = (), None

    def on_reset_timestep(self, words: Words) -> None:
        self.step = -1
        self.step = int(words.number(1))

    def finish(self) -> None:
        self.end_system()
        self.courses.append(frozenset(self.found))

    # ---- bodies ----

    def has(self, style: str) -> List[Words]:
        return [f for f in self.fixes.values() if re.fullmatch(style, _ACCELERATED.sub("", f[3]))]

    def moved(self) -> List[Words]:
        """Returns the fixes that move atoms."""
        return [f for f in self.fixes.values() if _INTEGRATES.match(f[3]) and f[3] != "nve/noforce"]

    def hold(self, c: Cohort) -> str:
        """Returns the reason why no force moves a cohort: "freeze", "fixed", or "" if forces move it."""
        if any(f[2] in c.groups for f in self.has("freeze")):
            return "freeze"
        moved = self.moved()
        is_moved = not moved or any(self.may_have(f[2], c) for f in moved)
        return "" if is_moved and not any(f[2] in c.groups for f in self.has("nve/noforce|move")) else "fixed"

    def rigid(self, c: Cohort) -> Tuple[str, float, Tuple[float, float]]:
        """Returns the fix or template that makes a cohort part of a body, and the body's mass and lever."""
        if c.body:
            return c.body, c.mass[0] if c.mass[0] == c.mass[1] else NAN, c.lever
        for f in self.has("rigid.*|multisphere.*"):
            if f[2] in c.groups:
                members = [x for x in self.cohorts if f[2] in x.groups and x.kind != "assumed"]
                is_single = f[4] == "single" and members and all(x.count > 0 for x in members)
                whole = sum(x.mass[0] * x.count for x in members) if is_single else NAN
                turns = not re.search(r"\storque\s+\S+\s+off\s+off\s+off\b", f.expanded)
                return f"fix {f[1]}", whole, (NAN, NAN) if turns else (0.0, 0.0)
        return "", NAN, (0.0, 0.0)

    def count_types(self) -> int:
        """Returns the number of types. If no command states it, counts the types of the contacts."""
        properties = [f for f in self.fixes.values() if f[3].startswith("property/global") and self.is_matrix(f)]
        sizes = [f.value(6) for f in properties]
        ends = [x for c in self.coefficients.values() for x in (*c.first, *c.last)]
        ends += [
            int(x) for _, text in self.groups_of_types for x in re.findall(r"\b\d+\b", text.partition(" type ")[2])
        ]
        return self.types or max(
            [1, *(x for x in ends if x <= MAX_TYPES), *(int(x) for x in sizes if 1 <= x <= MAX_TYPES)]
        )

    def moving(self) -> Dict[int, List[Moving]]:
        """Returns, for each type, one body for each way in which its atoms are held or joined."""
        made = [c for c in self.cohorts if c.kind != "assumed"]
        if self.is_liggghts and not any(c.kind == "made" for c in made):
            made += [c for t in self.templates() for c in self.of_template(t, frozenset(("all",)))]
        rest = [c for c in made if c.is_rest and c.radius == (0.5, 0.5)]
        if self.sized and len(rest) < len(made):
            made = [c for c in made if not any(c is r for r in rest)]
            text = "This line may leave atoms with the default diameter 1: their contacts are not judged."
            self.script.remark(self.sized.line, text) if rest else None
        classes: Dict[int, Dict[Tuple[Any, ...], List[Cohort]]] = {}
        if self.has_unread_atoms or not (made or self.cohorts):
            known = {c.type for c in self.cohorts if c.kind == "unread"}
            made += [self.unread(i + 1) for i in range(self.count_types()) if i + 1 not in known]
        for c in made or self.cohorts:
            classes.setdefault(c.type, {}).setdefault((self.hold(c), *self.rigid(c)), []).append(c)
        found: Dict[int, List[Moving]] = {}
        for type in sorted(classes):
            for (held, rigid, whole, lever), members in classes[type].items():
                unknown = any(math.isnan(c.radius[0]) for c in members)
                radius = (NAN,) if unknown else [c.radius[0] for c in members] + [c.radius[1] for c in members]
                masses = [c.mass[0] for c in members] + [c.mass[1] for c in members]
                density = members[0].density if all(_same(c.density, members[0].density) for c in members) else NAN
                mass: Optional[Tuple[float, float]] = (whole, whole) if rigid else (min(masses), max(masses))
                if not rigid and (not math.isnan(density) or any(map(math.isnan, masses))):
                    mass = None
                is_named = len(classes[type]) > 1 or held == "fixed"
                name = f"{type} {held or rigid if is_named else ''}".strip()
                body = Body(name, (min(radius), max(radius)), density, mass, held=bool(held), type=type, lever=lever)
                found.setdefault(type, []).append(Moving(self.with_material(body), members, held, rigid))
        return found

    def property(self, name: str) -> Optional[Words]:
        named = [f for f in self.fixes.values() if f[3].startswith("property/global") and f[4] == name]
        return named[-1] if named else None

    def is_matrix(self, words: Words) -> bool:
        return words[5] in ("peratomtypepair", "atomtypepair", "matrix")

    def with_material(self, body: Body) -> Body:
        values = []
        for words in (self.property("youngsModulus"), self.property("poissonsRatio")):
            values.append(words.value(5 + body.type) if words and 0 < body.type < len(words) - 5 else NAN)
        return replace(body, young=values[0], poisson=values[1])

    # ---- contacts ----

    def snapshot(self, run: int) -> List[Contact]:
        """Adds the contacts of the present state to the deck, and returns them."""
        self.script.tick()
        moving = self.moving()
        losses = [f for f in self.fixes.values() if _LOSSES.match(_ACCELERATED.sub("", f[3]))]
        sentences = [f"fix {f[1]} ({f[3]}) changes energy outside contacts." for f in losses]
        strange = [f for f in self.fixes.values() if not _KNOWN_FIXES.match(_ACCELERATED.sub("", f[3]))]
        sentences += [f"cor does not know fix {f[1]} ({f[3]}): eps does not include its effect." for f in strange]
        adapted = self.has(r"adapt(/fep)?|dt/reset")
        sentences += [f"fix {f[1]} ({f[3]}) changes numbers of the contact during a run." for f in adapted]
        fault = self.fault or ("A fix adapt changes the pair style." if any("pair" in f for f in adapted) else "")
        for f in self.fixes.values():
            style = _ACCELERATED.sub("", f[3])
            if _INTEGRATES.match(style) and not _MOVES.fullmatch(style):
                fault = fault or f"cor does not support the motion of fix {f[1]} ({f[3]})."
        if self.other_style is not None and not self.style:
            text = f"pair_style {self.other_style[1]}: cor supports granular, gran/hooke(/history), gran/hertz/history"
            self.script.remark(self.other_style.line, text + ", LIGGGHTS' gran model, and hybrid with these.")
        moved = self.moved()
        is_turned = all(_ACCELERATED.sub("", f[3]).endswith("/sphere") and "disc" not in f for f in moved)
        everyone = [m for bodies in moving.values() for m in bodies]
        cohorts = [c for m in everyone for c in m.cohorts]
        for f in moved + self.has("freeze|nve/noforce|move") if self.style else []:
            is_certain = self.types and self.groups_known and f[2] not in self.group_names  # a remark of on_fix
            if not is_certain and any(self.may_have(f[2], c) and f[2] not in c.groups for c in cohorts):
                text = f"The atoms of the group {f[2]} are not in the text: contacts with other atoms are not judged."
                self.script.remark(f.line, text)
        if self.style and everyone and all(m.held for m in everyone):
            text = "No atom moves here: all are frozen, or no fix integrates a group that contains them."
            self.script.remark(self.style[0].words.line, text, False)
        found = []
        for contact in chain(self.pair_contacts(moving) if self.style else (), self.wall_contacts(moving)):
            self.script.tick()
            contact.unknown = contact.unknown or fault
            contact.tangential = contact.tangential if is_turned else Tangential(_STILL)
            contact.losses, contact.style = sentences, "" if contact.model else contact.style
            contact.speeds = self.speeds_of(contact.bodies[1].wall)
            contact.time_step, contact.units = self.time_step, self.units
            key = repr(sorted((k, v) for k, v in contact.__dict__.items() if k not in ("runs", "repair")))
            if key not in self.seen and len(self.deck.contacts) > MAX_CONTACTS:
                break
            if key not in self.seen:
                self.deck.contacts.append(contact)
            self.found.append(key)
            held = self.seen.setdefault(key, contact)
            held.runs = (*held.runs[:999], run) if run else held.runs
            found.append(held)
        return found

    def is_excluded(self, one: Moving, two: Moving) -> bool:
        def apart(a: Cohort, b: Cohort) -> bool:
            for how, x, y in (e for e in self.excluded if len(e) == 3):
                i, j = (a.groups, b.groups) if how == "group" else (frozenset([str(a.type)]), frozenset([str(b.type)]))
                if how in ("group", "type") and ((x in i and y in j) or (x in j and y in i)):
                    return True
            return False

        return bool(self.excluded) and all(apart(a, b) for a in one.cohorts for b in two.cohorts)

    def are_alike(self, bodies: Sequence[Moving]) -> bool:
        """True if one row suffices for all types: the bodies differ only in name, and no option is for one type."""
        plain = [replace(m.body, name="", type=0) for m in bodies]
        types = self.count_types()
        is_whole = types == len(bodies) and (types > 1 or self.types == 0)
        by_type = (set(self.options.radii) | set(self.options.densities)) - {""}
        is_plain = not (self.is_liggghts or by_type or self.excluded or any(m.held or m.rigid for m in bodies))
        return is_whole and is_plain and all(_same(plain[0], b) for b in plain)

    def pair_contacts(self, moving: Dict[int, List[Moving]]) -> Iterator[Contact]:
        """Yields the contacts of pairs. If one line defines all types and they are alike, yields only *-*."""
        everyone = [m for bodies in moving.values() for m in bodies]
        pairs = [(i, j, *self.resolve(i, j)) for i in sorted(moving) for j in sorted(moving) if i <= j]
        first = pairs[0][2]
        if first and self.are_alike(everyone) and all(own is first and not other for _, _, own, other in pairs):
            any_body = replace(everyone[0].body, name="*")
            contact = self.between(first, None, any_body, any_body)
            contact.unknown = contact.unknown or self.added(pairs[0][0], pairs[0][1])
            yield contact
            return
        for i, j, own, other in pairs:
            for m, one in enumerate(moving[i] if own else ()):
                for two in moving[j][m if i == j else 0 :]:
                    is_one_body = one.rigid.startswith("fix") and not math.isnan((one.body.mass or (NAN,))[0])
                    is_same_body = is_one_body and one.rigid == two.rigid
                    if own and not (one.held and two.held) and not is_same_body and not self.is_excluded(one, two):
                        contact = self.between(own, other, one.body, two.body)
                        contact.unknown = contact.unknown or self.added(i, j)
                        if "fixed" in (one.held, two.held) and contact.model and not contact.unknown:
                            self.fix_one(contact)
                        yield contact

    def added(self, i: int, j: int) -> str:
        """Returns a sentence if hybrid/overlay adds another force to a pair."""
        parts = {c.part for c in self.coefficients.values() if c.covers(i, j)}
        several = self.hybrid == "hybrid/overlay" and len(parts) > 1
        return "hybrid/overlay adds up several forces, which cor does not judge." if several else ""

    def resolve(self, i: int, j: int) -> Tuple[Optional[Coefficient], Optional[Coefficient]]:
        """Returns the coefficients of a pair; if no line has this pair, the two coefficients that LAMMPS mixes."""
        if self.is_liggghts or (not self.coefficients and self.style[0].style != "granular"):
            return (self.style[0] if not self.hybrid else None), None
        used = [c for c in self.coefficients.values() if c.part >= 0 or self.hybrid != "hybrid/overlay"]
        own, one, two = (next((c for c in reversed(used) if c.covers(*p)), None) for p in ((i, j), (i, i), (j, j)))
        if own is None and one and two and (one.style, one.part) == (two.style, two.part):
            if one is two or one.model() == two.model():
                return one, (two if one is not two else None)
            text = f"The types {i} and {j} have different models, which LAMMPS does not mix."
            self.script.remark(two.words.line, text, False)
        elif own is None:
            self.script.remark(self.style[0].words.line, f"The types {i} and {j} have no line pair_coeff.")
        elif own.part < 0:
            self.script.remark(own.words.line, f"The types {i} and {j} have no granular contact.", False)
        return (own if own and own.part >= 0 else None), None

    def between(self, own: Coefficient, other: Optional[Coefficient], one: Body, two: Body) -> Contact:
        """Returns the contact of two bodies from their coefficients, or from two coefficients that LAMMPS mixes."""
        if self.is_liggghts:
            return self.matrix(own.words, own.at, one, two)
        contact = self.granular(own, one, two)
        if other is not None:
            second = self.granular(other, one, two)
            x, y = contact.stiffness, second.stiffness
            is_material = _NORMAL.get(own.model()[0], 0) > 2
            contact.stiffness = 2 / (1 / x + 1 / y) if is_material and x > 0 and y > 0 else math.sqrt(abs(x * y))
            contact.number, contact.tangential = math.sqrt(abs(contact.number * second.number)), Tangential(_MIXED)
            contact.repair, contact.slots, contact.line, contact.file = None, (), second.line, second.file
            contact.unknown = contact.unknown or second.unknown
            if contact.cohesion[0]:
                contact.unknown = contact.unknown or "cor does not mix the adhesion of two types."
            contact.notes = ["No line for this pair: LAMMPS uses the geometric mean of both types."]
            is_same = contact.model.endswith(("E_VELOCITY", "Z_VELOCITY", "RESTITUTION", "RESTITUTION_LIMIT"))
            if not is_same and self.version < _MIXES_SINCE and not contact.unknown:
                contact.unknown = (
                    "LAMMPS before 3 Nov 2022 uses damping velocity for such a pair, with this mean as eta:"
                )
                contact.unknown += " write a line for the pair, or give --simulator-version."
        return contact

    def fix_one(self, contact: Contact) -> None:
        """Corrects the damping if a body is neither integrated nor frozen. Its mass counts, but it does not move."""
        masses = [b.mass[0] if b.mass else _sphere(b.radius[0], b.density) for b in contact.bodies]
        share = masses[contact.bodies[0].held is False] / sum(masses)
        name = contact.model.split("_", 1)[1].replace("_LIMIT", "")
        if name in _BY_ROOT or name == "RESTITUTION":
            contact.zeta_factor = math.sqrt(share)
        elif name not in ("HOOKE_VELOCITY", "HERTZ_VELOCITY"):
            contact.number *= share
        contact.notes.append("One body is not frozen, but no fix integrates it: the damping includes its mass.")
        if math.isnan(share):
            contact.unknown = contact.unknown or "The masses are not in the text."

    def new(self, words: Words, one: Body, two: Body, style: str, unknown: str = "") -> Contact:
        line = words.line
        return Contact(line.file, line.line, self.deck.simulator, (one, two), style=style, unknown=unknown)

    def set_slots(self, contact: Contact, words: Words, indices: Sequence[int]) -> None:
        line = words.line
        if not line.nested:
            text, contact.slots = words.slots(indices)
            repair = Repair(line.file, line.line, line.last_line, text)
            contact.repair = self.repairs.setdefault((line.file, line.line, text), repair)

    def granular(self, of: Coefficient, one: Body, two: Body) -> Contact:
        """Returns the contact that the words of a LAMMPS pair style, pair_coeff or wall define."""
        contact = self.new(of.words, one, two, f"{of.words[3 if of.words[0] == 'fix' else 0]} {of.style}")
        try:
            self.read_granular(contact, of, of.words, of.at)
        except Unknown as reason:
            contact.model, contact.unknown = "", f"The contact depends on an unknown value: {reason}.".replace(
                "\1", " "
            )
        return contact

    def read_granular(self, contact: Contact, of: Coefficient, words: Words, at: int) -> None:
        force, damping = of.style.split("/")[0] if of.style in _OLD else of.style, "mass_velocity"
        if of.style == "granular":
            force, damping = of.model()
            if not is_known(force + damping):
                number(force + damping)
            if not damping:
                contact.notes.append("Without the keyword damping, LAMMPS uses damping viscoelastic.")
            self.set_slots(contact, words, [at + 2] if _NORMAL.get(force) and len(words) > at + 2 else [])
            contact.stiffness, contact.number = words.value(at + 1), words.value(at + 2)
        elif force == "hertz":
            damping = "viscoelastic"
        name = f"{'HOOKE' if force == 'hooke' else 'HERTZ'}_{(damping or 'viscoelastic').upper()}"
        name = "COEFF_RESTITUTION" if damping == "coeff_restitution" else name.replace("_NONE", "_VELOCITY")
        if force not in _NORMAL or name not in _KNOWN:
            what = f"the normal force {force}" if force not in _NORMAL else f"damping {damping} of {force}"
            contact.style, contact.unknown = f"{of.style} {force}", f"cor does not support {what}."
            return
        contact.stiffness = words.number(at + (of.style == "granular"))
        contact.number = words.number(at + 2) if damping != "none" else 0.0
        if _NORMAL[force] > 2:
            poisson = words.number(at + 3)
            contact.stiffness *= 2 / 3 / (1 - poisson**2) if abs(poisson) < 1 else NAN
        is_limited = words.find("limit_damping", at) > 0
        has_row = hasattr(lib, f"COR_LAMMPS_{name}_LIMIT")
        contact.model = f"LAMMPS_{name}" + ("_LIMIT" if is_limited and has_row else "")
        contact.limited = is_limited and not has_row
        if force in ("dmt", "jkr"):
            contact.cohesion = force, 2 * words.number(at + 4)  # the work of adhesion is twice LAMMPS's number
            contact.slots = ()
            contact.unknown = "cor does not support limit_damping with adhesion." if is_limited else ""
            end = "; LAMMPS separates the bodies at the largest pull" if force == "jkr" else ""
            contact.notes.append(f"eps includes the adhesion{end}.")
        contact.spring = Spring.HOOKE if force == "hooke" else Spring.HERTZ
        if of.style == "granular" and any(words.after(w, at) not in ("", "none") for w in ("rolling", "twisting")):
            contact.tangential = Tangential(ROLLS)
        elif of.style == "granular":
            self.read_tangential(contact, words, at)
        elif of.style in _OLD:
            normal, damper = words.value(at + 2), words.value(at + 3) if words[at + 3] != "NULL" else NAN
            ratio = 0.5 if words[at + 3] == "NULL" else share(damper, normal)
            ratio = 0.0 if words.value(at + 5) == 0 else ratio
            spring = 2 / 7 if words[at + 1] == "NULL" else share(words.value(at + 1), contact.stiffness)
            contact.tangential = Tangential(_OLD[of.style], spring, ratio, words.value(at + 4))

    def read_tangential(self, contact: Contact, words: Words, at: int) -> None:
        """Sets the tangential force. For mindlin the stiffness NULL means 8 G*, computed from hertz/material."""
        name, k = words.after("tangential", at), words.find("tangential", at) + 2
        if name in ("", "none"):
            contact.tangential = NO_FRICTION
        elif name == "linear_nohistory":
            contact.tangential = Tangential(name, 0.0, words.value(k), words.value(k + 1))
        elif name == "linear_history" or (name in _TANGENTIAL and contact.spring is Spring.HERTZ):
            stiffness, poisson = words.value(k), words.value(at + 3)
            if words[k] == "NULL" and name in _TANGENTIAL and _NORMAL[words[at]] > 2:
                stiffness = 2 * words.value(at + 1) / (2 - poisson) / (1 + poisson)
            if name in _TANGENTIAL or contact.spring is Spring.HOOKE:
                stiffness = share(stiffness, contact.stiffness)
            contact.tangential = Tangential(name, stiffness, words.value(k + 1), words.value(k + 2))
        else:
            contact.tangential = Tangential(f"cor has no model of the tangential force {name} with this normal force")

    def matrix(self, words: Words, at: int, one: Body, two: Body) -> Contact:
        """Returns the contact of two LIGGGHTS types from the properties. words[at]: the name of the model."""
        model = words[at]
        contact = self.new(words, one, two, f"gran model {model}")
        old = _OLD_MODEL.fullmatch(model.replace("wall/", ""))
        model = old[1] + (old[4] or "") if old else model
        if model == "hertz/break":
            model, contact.notes = "hertz", ["Fragments that overlap after a break have smaller forces."]
        if model not in _MODELS:
            contact.unknown = f"cor does not support the contact model {model}; it knows {', '.join(_MODELS)}."
            return contact
        is_on = {name for name in words[at:] if words.find(name, at) > 0 and words.after(name, at) != "off"}
        is_stiff, is_hertz = model.endswith("/stiffness"), model.startswith("hertz")
        kind = f"{'HERTZ' if is_hertz else 'HOOKE'}_GAMMAN" if is_stiff else "RESTITUTION"
        contact.model = f"LIGGGHTS_{kind}" + ("_LIMIT" if "limitForce" in is_on else "")
        name = "gamman" if is_stiff else "coefficientRestitution"
        if is_stiff and "absolute_damping" in is_on:
            contact.unknown = "With 'absolute_damping on', LIGGGHTS uses gamman_abs, which cor does not read."
            return contact
        found, i, j = self.property(name), one.type - 1, two.type - 1
        types = found.value(6) if found and self.is_matrix(found) else 0
        if found is None or not max(i, j) < types <= MAX_TYPES or len(found) != 7 + types * types:
            contact.unknown = f"{name} of these types could not be read: it needs a value for each pair of types."
            return contact
        contact.file, contact.line = found.line.file, found.line.line
        places = sorted({int(7 + i * types + j), int(7 + j * types + i)})
        contact.number = found.value(places[0])
        if not is_stiff:
            self.set_slots(contact, found, places)
            speed = self.property("characteristicVelocity")
            contact.spring = Spring.MATERIAL if is_hertz else Spring.CHARACTERISTIC
            contact.spring_speed = speed.value(6) if speed else NAN
            kappa = lib.cor_tangential_kappa(one.young, one.poisson, two.young, two.poisson)  # 21 G*/E*
            spring = 2 / 7 * kappa if is_hertz else 2 / 7 if "ktToKnUser" in is_on else 1.0
            ratio = math.sqrt(4 * kappa / 21) if is_hertz else 1.0
        else:
            kn = self.property("kn")
            contact.stiffness = kn.value(places[0]) if kn and kn.value(6) == types else NAN
            contact.spring = Spring.HERTZ if is_hertz else Spring.HOOKE
            kt, gammat = (w.value(places[0]) if w else NAN for w in map(self.property, ("kt", "gammat")))
            spring, ratio = share(kt, contact.stiffness), share(gammat, contact.number)
        slides, friction = words.after("tangential", at) or "off", self.property("coefficientFriction")
        if slides == "off":
            contact.tangential = NO_FRICTION
        elif slides not in ("history", "no_history"):
            contact.tangential = Tangential(f"cor has no model of the tangential force {slides}")
        else:
            ratio = 0.0 if words.after("tangential_damping", at) == "off" else ratio
            mu = friction.value(places[0]) if friction else NAN
            contact.tangential = Tangential(slides.replace("no_history", "viscous"), spring, ratio, mu)
        if words.after("rolling_friction", at) not in ("", "off"):
            contact.tangential = Tangential(ROLLS)
        reasons = {
            "cohesion": "The cohesion changes eps.",
            "viscous": "With 'viscous on', the Stokes number of each impact sets the damping.",
        }
        if math.isnan(contact.number):
            contact.unknown = f"The contact depends on an unknown value: {name}."
        elif not is_stiff and not 0.05 < contact.number <= 1:
            contact.refused = "LIGGGHTS stops with an error: e must be above 0.05 and at most 1."
        cohesion = words.after("cohesion", at)
        if old and words[at + 2][-1:] in tuple("13579"):
            is_on, cohesion = is_on | {"cohesion"}, "sjkr"
        density = self.property("cohesionEnergyDensity")
        pull = density.value(places[0]) if density and density.value(6) == types else NAN
        if pull == 0:
            is_on -= {"cohesion"}
        elif cohesion in ("sjkr", "sjkr2") and not math.isnan(pull) and not is_stiff:
            contact.cohesion = cohesion, pull
            contact.tangential, contact.slots = Tangential("cor has no model of the tangential force with cohesion"), ()
            is_on -= {"cohesion"} if "limitForce" not in is_on else set()
        if cohesion in ("sjkr", "sjkr2") and density is None:
            reasons["cohesion"] = "The cohesion changes eps, and its number cohesionEnergyDensity is missing."
        contact.unknown = next((reasons[r] for r in reasons if r in is_on), contact.unknown)
        return contact

    # ---- walls ----

    def wall_contacts(self, moving: Dict[int, List[Moving]]) -> Iterator[Contact]:
        """Yields the contacts of each wall with the types of its group. If there are several walls, they have names."""
        read = self.walls_of_liggghts if self.is_liggghts else self.walls_of_lammps
        walls = [wall for fix in self.has("wall/gran.*") for wall in read(fix)]
        known = re.compile(r"wall/gran(/region)?|wall/" + _OLD_MODEL.pattern)
        for of, type, name, unknown in walls:
            words, found = of.words, []
            if not known.fullmatch(_ACCELERATED.sub("", words[3])):
                unknown = f"cor does not support the wall {words[3]}."
            wall = self.with_material(Body(f"wall {name}" if len(walls) > 1 else "wall", wall=True, type=type))
            for m in (m for bodies in moving.values() for m in bodies if not m.held):
                if not any(self.may_have(words[2], c) for c in m.cohorts):
                    continue
                made = self.new(words, m.body, wall, f"{words[3]} {words[4]}", unknown)
                made = made if unknown else self.between(of, None, m.body, wall)
                if made.cohesion[0] == "jkr":
                    made.unknown = made.unknown or "At a wall JKR of LAMMPS 29 Sep 2021 gives no finite velocity."
                made.gravity = self.pressing(words)
                found.append((m, made))
            if found and self.are_alike([m for m, _ in found]):
                found[0][1].bodies = replace(found[0][1].bodies[0], name="*"), wall
                found = found[:1]
            yield from (contact for _, contact in found)

    def walls_of_lammps(self, words: Words) -> List[Tuple[Coefficient, int, str, str]]:
        style, unknown, at = _ACCELERATED.sub("", words[4]), "", 5
        if re.match(r"[\d.]", style):  # before 2017 a wall has no style: it has the force of the pair style
            style, at = self.style[0].style if self.style else "", 4
            if style in ("", "granular"):
                unknown = "This form from before 2017 uses the force of a pair style gran/..., which is absent."
            elif self.version > 20170000:
                unknown = f"LAMMPS {self.options.version} does not have this form from before 2017."
        elif style != "granular" and not style.startswith(("hooke", "hertz")):
            unknown = f"cor does not support the wall {style}."
        return [(Coefficient(words, at, style), 0, words[1], unknown)]

    def walls_of_liggghts(self, words: Words) -> List[Tuple[Coefficient, int, str, str]]:
        at, meshes, is_primitive = 5, words.find("meshes", 4), words.find("primitive", 4) > 0
        plane = next((i for i, word in enumerate(words) if re.fullmatch("[xyz](plane|cylinder)", word)), 0)
        is_old, old_mesh = _OLD_MODEL.fullmatch(words[3].replace("wall/", "")), words.find("mesh/gran", 4)
        at = 3 if is_old else at
        if is_old and old_mesh > 0:
            count = words.value(old_mesh + 1)
            names = words[old_mesh + 2 : old_mesh + 2 + (int(count) if 1 <= count < MAX_TYPES else 1)]
            types = [(f"{words[1]} {n}", self.fixes[n].value(5) if n in self.fixes else NAN) for n in names]
        elif is_old and plane and not is_primitive:
            types = [(words[1], words.value(plane + (3 if words[plane].endswith("plane") else 2)))]
        elif (words[4] != "model" and not is_old) or (not is_primitive and meshes < 0):
            return [(Coefficient(words, at, "model"), 0, words[1], f"cor does not support the wall {words[4]}.")]
        else:
            count = words.value(words.find("n_meshes", 4) + 1)
            names = words[meshes + 1 : meshes + 1 + (int(count) if 1 <= count < MAX_TYPES else 1)]
            sources = [(f"{words[1]} {name}", self.fixes.get(name)) for name in names]
            sources = [(words[1], words)] if is_primitive else sources
            types = [(n, f.value(f.find("type", 4) + 1) if f and f.find("type", 4) > 0 else NAN) for n, f in sources]
        walls = []
        for name, type in types:
            unknown = "" if 1 <= type <= MAX_TYPES else f"The type of the wall {name} is not known."
            walls.append((Coefficient(words, at, "model"), 0 if unknown else int(type), name, unknown))
        return walls

    def pressing(self, words: Words) -> float:
        """Returns the acceleration of gravity toward a wall; NaN without gravity."""
        total = [0.0, 0.0, 0.0]
        for f in self.has("gravity"):
            x, y, z = (f.value(6 + k) for k in range(3))
            a, b = math.radians(x), math.radians(y)
            up = 1 if self.dimension == 2 else 2
            direction = [x, y, z]
            if f[5] == "chute":
                direction = [math.sin(a), 0.0, 0.0]
                direction[up] = -math.cos(a)
            elif f[5] == "spherical" and self.dimension == 2:
                direction = [math.sin(b), math.cos(b), 0.0]
            elif f[5] == "spherical":
                direction = [math.sin(b) * math.cos(a), math.sin(b) * math.sin(a), math.cos(b)]
            length = math.sqrt(sum(v * v for v in direction))
            total = [t + (f.value(4) * v / length if length > 0 else NAN) for t, v in zip(total, direction)]
        plane = next((i for i, word in enumerate(words) if re.fullmatch("[xyz]plane", word)), 0)
        size = math.sqrt(sum(v * v for v in total))
        if plane:
            along = total["xyz".index(words[plane][0])]
            size = along if abs(along) > 1e-9 * size else 0.0
            if not self.is_liggghts and words[plane + 1 if size < 0 else plane + 2] == "NULL":
                size = 0.0  # gravity points to the side that has no wall
        return abs(size) or NAN


def _read(simulator: str, text: str, name: str, options: Options) -> Deck:
    deck = Deck(name, simulator)
    script = Script(options)
    system = Granular(deck, script, options)
    script.run(text, name, system)
    for (file, line), reason in script.split.items() if len(set(system.courses)) > 1 else ():
        text = f"if: the condition depends on an unknown value: {reason}; the contacts of both branches are listed."
        deck.remarks.append(Remark(file, line, text, False))
    deck.remarks += script.remarks.values()
    return deck


def read_lammps(text: str, name: str, options: Options) -> Deck:
    """Reads a LAMMPS script."""
    return _read("lammps", text, name, options)


def read_liggghts(text: str, name: str, options: Options) -> Deck:
    """Reads a LIGGGHTS script."""
    return _read("liggghts", text, name, options)
