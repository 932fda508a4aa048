# SPDX-License-Identifier: MIT
"""Reads keyword formats: Kratos (json), MFiX, Lethe, PFC, MercuryDPM (C++)."""

import ast
import contextlib
import itertools
import json
import math
import re
import warnings
from dataclasses import replace
from typing import Any, Dict, Iterator, List, Set, Tuple

from .deck import (
    NAN, NO_FRICTION, ROLLS, Body, Contact, Deck, DeckError, Options, Remark, Repair, Spring, Tangential, Units,
    by_restitution, share,
)  # fmt: skip
from .yade import Script, number_of

Slot = Tuple[int, int]
MAX_TEXT, MAX_MIXED = 1 << 20, 1000  # largest size; most pairs of species of MercuryDPM without an own line


def arithmetic(text: str) -> float:
    """Returns the value of an expression of numbers and functions; NaN for other text. Exponents may use e or d."""
    text = re.sub(r"(?<=[\d.])[dD](?=[-+\d])", "e", text.strip())
    try:
        return float(text)
    except ValueError:
        pass
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return number_of(Script().value(ast.parse(text.replace("^", "**"), mode="eval").body))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return NAN


class Source:
    """A text with its lines and their repairs."""

    def __init__(self, text: str, name: str) -> None:
        if len(text) > MAX_TEXT:
            raise DeckError(f"cor reads texts of this kind up to {MAX_TEXT} characters; this one has {len(text)}")
        self.text, self.name = text, name
        self.starts = [0] + [m.end() for m in re.finditer("\n", text)]
        self.repairs: Dict[int, Repair] = {}

    def line(self, at: int) -> int:
        """Returns the line number of a position, from 1."""
        low, high = 0, len(self.starts)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.starts[middle] <= at else (low, middle)
        return low + 1

    def place(self, contact: Contact, start: int, end: int) -> None:
        """Sets line, repair and slot of a contact whose number is at [start, end)."""
        contact.line = self.line(start)
        first = self.starts[contact.line - 1]
        stop = self.text.find("\n", end)
        whole = self.text[first : stop if stop >= 0 else len(self.text)]
        last = contact.line + whole.count("\n")
        contact.repair = self.repairs.setdefault(first, Repair(self.name, contact.line, last, whole))
        contact.slots = ((start - first, end - first),)


# ---- Kratos ----


class _Number(float):
    """A number with its place in the text."""

    place: Slot


_KRATOS: Dict[Any, Tuple[str, str, Spring]] = {
    "DEM_D_Hertz_viscous_Coulomb": ("KRATOS_HERTZ", "KRATOS_HERTZ_GAMMA", Spring.MATERIAL),
    "DEM_D_Linear_viscous_Coulomb": ("KRATOS_LINEAR", "KRATOS_LINEAR_GAMMA", Spring.NONE),
}


def read_kratos(text: str, name: str, options: Options) -> Deck:
    """Reads the materials of Kratos; the order of keys has no meaning."""
    source, deck = Source(text, name), Deck(name, "kratos")
    tokens = re.compile(r'"(?:[^"\\\n]|\\.)*"|-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?|//[^\n]*|/\*.*?(?:\*/|\Z)', re.S)
    plain = tokens.sub(lambda m: re.sub(r"[^\n]", " ", m[0]) if m[0][0] == "/" else m[0], text)
    places = (m.span() for m in tokens.finditer(plain) if m[0][0] != '"')

    def number(digits: str) -> _Number:
        made = _Number(float(digits))
        made.place = next(places)
        return made

    try:
        root = json.loads(plain, parse_float=number, parse_int=number, parse_constant=lambda word: math.nan)
    except RecursionError:
        raise DeckError("this JSON is nested too deeply") from None
    except (ValueError, StopIteration) as error:
        raise DeckError(f"this is not JSON: {error}") from None
    root = root if isinstance(root, dict) else {}
    bodies: Dict[Any, Body] = {}
    entries = []
    for material in (m for m in root.get("materials", ()) if isinstance(m, dict)):
        values = _variables(material)
        label = str(material.get("material_name", material.get("material_id", len(bodies) + 1)))
        numbers = [number_of(values.get(k)) for k in ("PARTICLE_DENSITY", "YOUNG_MODULUS", "POISSON_RATIO")]
        bodies[label] = Body(label, density=numbers[0], young=numbers[1], poisson=numbers[2])
        bodies.setdefault(material.get("material_id"), bodies[label])
        entries.append(([label, label], values))
    for relation in (r for r in root.get("material_relations", ()) if isinstance(r, dict)):
        names = relation.get("material_names_list", relation.get("material_ids_list"))
        if isinstance(names, list) and len(names) == 2:
            entries.append((names, _variables(relation)))
    for names, values in entries:
        for key in ("COEFFICIENT_OF_RESTITUTION", "DAMPING_GAMMA"):
            if key in values:
                deck.contacts.append(_kratos_contact(source, [bodies.get(n, Body(str(n))) for n in names], values, key))
    return deck


def _variables(entry: Dict[str, Any]) -> Dict[str, Any]:
    inner = entry.get("Variables", {})
    return {**entry, **inner} if isinstance(inner, dict) else entry


def _kratos_contact(source: Source, bodies: List[Body], values: Dict[str, Any], key: str) -> Contact:
    c = Contact(source.name, 1, "kratos", (bodies[0], bodies[1]), number=number_of(values[key]), style=key)
    if isinstance(values[key], _Number):
        source.place(c, *values[key].place)
    law = values.get("DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME")
    if law in _KRATOS:
        by_e, by_gamma, c.spring = _KRATOS[law]
        c.model, c.style = by_gamma if key == "DAMPING_GAMMA" else by_e, ""
    else:
        c.unknown = f"cor does not support the contact law {law}." if law else "The contact law of the pair is missing."
    if math.isnan(c.number):
        c.unknown = c.unknown or f"{key} is not a number."
    return c


# ---- MFiX ----


def _namelist(text: str) -> Iterator[Tuple[str, int, List[Tuple[str, int, int]]]]:
    """Yields each keyword in upper case, its first index, and its values with their places. Lists may span lines."""
    comment = re.compile(r"""('[^'\n]*'|"[^"\n]*")|[!#][^\n]*""")
    word = re.compile(r"""(?:\d+\*)?(?:'[^'\n]*'|"[^"\n]*"|@\([^\n]*?\)(?=[\s,]|$)|[^\s,]+)""")
    text = comment.sub(lambda m: m[1] or " " * len(m[0]), text)
    keys = list(re.finditer(r"\b([A-Za-z_]\w*)[ \t]*(\([^)\n]{0,99}\))?[ \t]*=(?!=)", text))
    stops = [key.start() for key in keys[1:]] + [len(text)]
    for key, stop in zip(keys, stops):
        index = re.match(r"\(\s*(\d+)", key[2] or "(1")
        values = []
        for m in word.finditer(text, key.end(), stop):
            times, star, value = m[0].partition("*") if re.match(r"\d+\*", m[0]) else ("1", "", m[0])
            span = (m.start(), m.end()) if not star else (-1, -1)
            values += [(value, *span)] * min(int(times), 5000)
        yield key[1].upper(), int(index[1]) if index else 1, values


def _mfix_number(value: str) -> float:
    return arithmetic(value[1:] if value.startswith("@") else value)


def read_mfix(text: str, name: str, options: Options) -> Deck:
    """Reads an mfix.dat, a namelist."""
    source, deck = Source(text, name), Deck(name, "mfix")
    given: Dict[str, Dict[int, Tuple[str, int, int]]] = {}
    for key, first, values in _namelist(text):
        given.setdefault(key, {}).update(dict(zip(itertools.count(first), values)))

    def number(key: str, index: int = 1, otherwise: float = NAN) -> float:
        return _mfix_number(given[key][index][0]) if index in given.get(key, {}) else otherwise

    def word(key: str, index: int = 1) -> str:
        return given.get(key, {}).get(index, ("", 0, 0))[0].strip("'\"").upper()

    hertz, cohesion = word("DES_COLL_MODEL").startswith("HERTZ"), word("USE_COHESION").strip(".")[:1] == "T"
    unit = (1e-2, 1e-3) if word("UNITS") == "CGS" else (1.0, 1.0)
    total = int(min(number("MMAX", 1, 1), 100)) if number("MMAX", 1, 1) >= 1 else 1
    models = {m: word("SOLIDS_MODEL", m) or "DEM" for m in range(1, total + 1)}
    strange = sorted(set(models.values()) - {"DEM", "CGP", "TFM", "PIC"})
    phases = [m for m, model in models.items() if model in ("DEM", "CGP") and not strange]
    if strange:
        text = f"cor does not support the solids model {' and '.join(strange)}"
        deck.remarks.append(Remark(name, 1, text))
    elif len(phases) < total:
        deck.remarks.append(Remark(name, 1, "phases of the two-fluid model and of PIC have no contacts", False))
    bodies = []
    for m in phases:
        held, size = word("DES_RIGID_MOTION", m).strip(".")[:1] == "T", number("D_P0", m) / 2
        elastic = number("E_YOUNG", m), number("V_POISSON", m)
        bodies.append(Body(str(m), (size, size), number("RO_S0", m), None, *elastic, held=held))
    wall = Body("wall", young=number("EW_YOUNG"), poisson=number("VW_POISSON"), wall=True)
    pairs = [(a, b) for i, a in enumerate(bodies) for b in bodies[i:]]
    pairs += [(a, wall) for a in bodies]
    inputs = [("DES_EN_INPUT", k + 1) for k in range(len(pairs) - len(bodies))]
    inputs += [("DES_EN_WALL_INPUT", k + 1) for k in range(len(bodies))]
    gravity = math.sqrt(sum(number(f"GRAVITY_{x}", 1, 0) ** 2 for x in "XYZ"))
    gravity = gravity or number("GRAVITY", 1, 9.80665 / unit[0])
    adams = word("DES_INTG_METHOD").startswith("ADAMS")
    for (a, b), (key, index) in zip(pairs, inputs):
        if index not in given.get(key, {}):
            if key in given:
                deck.remarks.append(Remark(name, 1, f"{key}({index}) of phases {a.name} and {b.name} is missing"))
            continue
        c = Contact(name, 1, "mfix", (a, b), "MFIX_HERTZIAN" if hertz else "MFIX_LSD", number=number(key, index))
        c.spring = Spring.MATERIAL if hertz else Spring.HOOKE
        c.stiffness, c.gravity = number("KN_W" if b.wall else "KN"), gravity if b.wall else NAN
        c.units = Units("si", unit[0], unit[1], 1.0)
        c.integrator = -1 if adams else None
        _, start, end = given[key][index]
        if start >= 0:
            source.place(c, start, end)
        else:
            c.line = next((source.line(m.start()) for m in re.finditer(key, text, re.I)), 1)
        if cohesion:
            c.unknown = "The cohesion changes eps."
        elif not hertz and word("DES_COLL_MODEL") not in ("", "LSD"):
            c.unknown = f"cor does not support DES_COLL_MODEL = {word('DES_COLL_MODEL')}."
        elif math.isnan(c.number):
            c.unknown = f"{key}({index}) could not be read."
        masses = [x.radius[0] ** 3 * x.density for x in (a, b)]
        if a.held != b.held and not b.wall:
            c.zeta_factor = math.sqrt(masses[a.held is False] / sum(masses))
            c.bodies = (b, a) if a.held else (a, b)
            c.notes.append("One phase has a prescribed motion, but its mass counts in the damping.")
            c.unknown = c.unknown or ("The masses are not in the text." if math.isnan(c.zeta_factor) else "")
        if not (a.held and (b.held or b.wall)):
            deck.contacts.append(c)
    if not hertz:
        with contextlib.suppress(ArithmeticError):
            _set_mfix_step(deck, number("KN"), number("DTSOLID_FACTOR", 1, 50.0))
    for m in sorted(given.get("DES_EN_INPUT", ()))[len(pairs) - len(bodies) :] if phases else []:
        deck.remarks.append(Remark(name, 1, f"DES_EN_INPUT({m}) belongs to no pair of phases", False))
    return deck


def _set_mfix_step(deck: Deck, stiffness: float, factor: float) -> None:
    """Sets MFiX's time step: 1/50, or another fraction, of the shortest contact of particles with linear springs."""
    shortest = math.inf
    for c in deck.contacts:
        if not c.bodies[1].wall and not c.unknown:
            inverse = sum(
                3 / (4 * math.pi * b.radius[0] ** 3 * b.density) if b.radius[0] * b.density > 0 else NAN
                for b in c.bodies
            )
            e = math.log(c.number) if c.number > 0 else NAN
            ratio = (math.pi**2 + e * e) / (inverse * stiffness) if inverse * stiffness > 0 else NAN
            duration = math.sqrt(ratio)
            shortest = duration if math.isnan(duration) or duration < shortest else shortest
    for c in deck.contacts:
        c.time_step = shortest / factor if shortest < math.inf and factor > 0 else NAN


# ---- Lethe ----


def read_lethe(text: str, name: str, options: Options) -> Deck:
    """Reads a parameter file of Lethe: subsections of `set key = value`."""
    source, deck = Source(text, name), Deck(name, "lethe")
    values: Dict[Tuple[str, str], Tuple[str, int, int]] = {}
    inside: List[str] = []
    for m in re.finditer(r"^[ \t]*(subsection|end|set)\b([^#\n]*)", text, re.M | re.I):
        if m[1].lower() == "subsection":
            inside.append(" ".join(m[2].split()).lower())
        elif m[1].lower() == "end":
            del inside[-1:]
        else:
            key, _, value = m[2].partition("=")
            value, at = value.strip(), m.end() - len(value.lstrip())
            values[inside[-1] if inside else "", " ".join(key.split()).lower()] = value, at, at + len(value)

    def found(section: str, key: str) -> Tuple[str, int, int]:
        return values.get((section, key), ("", 0, 0))

    types = sorted({s for s, _ in values if s.startswith("particle type")}, key=lambda s: (len(s), s))
    wall = "lagrangian physical properties"
    bodies = []
    for k, section in enumerate(types):
        size = arithmetic(found(section, "diameter")[0] or found(section, "average diameter")[0]) / 2
        keys = ("density particles", "young modulus particles", "poisson ratio particles")
        density, young, poisson = (arithmetic(found(section, key)[0]) for key in keys)
        body = Body(str(k), (size, size), density, None, young, poisson)
        bodies.append((section, body, found(section, "restitution coefficient particles")))
    young, poisson = (arithmetic(found(wall, f"{key} wall")[0]) for key in ("young modulus", "poisson ratio"))
    body = Body("wall", young=young, poisson=poisson, wall=True)
    floor = wall, body, found(wall, "restitution coefficient wall")
    pairs = [(a, b) for i, a in enumerate(bodies) for b in bodies[i:]] + [(a, floor) for a in bodies]
    forces = {k: v[0] for (_, k), v in values.items() if k.endswith("contact force method")}
    parts = [found(wall, k)[0] or "0" for k in ("gx", "gy", "gz")]
    g = [arithmetic(v) for v in (found(wall, "g")[0].split(",") if found(wall, "g")[0] else parts)]
    for a, b in pairs:
        one, two = arithmetic(a[2][0]), arithmetic(b[2][0])
        c = Contact(name, source.line(b[2][1]), "lethe", (a[1], b[1]), "LETHE_RESTITUTION")
        c.number = one if a is b else 2 * one * two / (one + two) if one + two > 0 else NAN  # the harmonic mean
        method = f"particle {'wall' if b[1].wall else 'particle'} contact force method"
        force = forces.get(method, "hertz_mindlin_limit_overlap")
        force = re.sub("^p[pw]_", "", force)  # names before 2022
        c.spring = Spring.NONE if force in ("linear", "nonlinear") else Spring.MATERIAL
        c.gravity = math.sqrt(sum(x * x for x in g)) if b[1].wall else NAN
        c.time_step = arithmetic(found("simulation control", "time step")[0])
        c.notes += [] if a is b else ["Lethe's e is the harmonic mean of both numbers."]
        if a is b and a[2][2]:
            source.place(c, a[2][1], a[2][2])
        if force not in ("linear", "nonlinear", "hertz", "hertz_mindlin_limit_force", "hertz_mindlin_limit_overlap"):
            c.unknown = f"cor does not support the contact force {force}."
        elif math.isnan(c.number):
            c.unknown = "The restitution coefficient of a partner is missing, or not a number."
        deck.contacts.append(c)
    return deck


# ---- PFC ----


def _pfc_lines(text: str, name: str, options: Options, called: Set[str]) -> Iterator[Tuple[str, int, str]]:
    """Yields file, number and text of each line without comments. The lines of a called file replace the call."""
    for number, line in enumerate(re.sub(r";[^\n]*", "", Source(text, name).text).split("\n"), 1):
        call = re.match(r"""\s*(?:program\s+)?call\s+['"]?([^'"\s]+)""", line, re.I)
        found = options.include(call[1], name) if call and call[1] not in called else None
        if call and found:
            called.add(call[1])
            yield from _pfc_lines(*found, options, called)
        yield name, number, line


def read_pfc(text: str, name: str, options: Options) -> Deck:
    """Reads PFC commands: contact models of the contact model assignment table, their dashpots, local damping."""
    deck, lines = Deck(name, "pfc"), list(itertools.islice(_pfc_lines(text, name, options, set()), 100000))
    plain = "\n".join(line for _, _, line in lines)
    constants = {m[1].lower(): m[2] for m in re.finditer(r"\[\s*(\w+)\s*=\s*([^\]\n]{1,999})\]", plain)}
    every = ["ball-ball"] + ["ball-facet"] * bool(re.search(r"^\s*wall\b", plain, re.M | re.I))
    tables: Dict[str, Dict[str, str]] = {}
    places: Dict[str, Tuple[str, int]] = {}
    damp, gravity, whole = 0.0, NAN, ""
    for file, number, line in lines:
        whole += " " + re.sub(r"(\.\.\.|&)\s*$", "", line)
        if re.search(r"(\.\.\.|&)\s*$", line):
            continue
        words = [w.strip("[]'\"") for w in whole.lower().replace(",", " ").split()]
        words = [constants.get(w.lstrip("@"), w) for w in words]
        whole = ""
        numbers = {w: arithmetic(v) for w, v in zip(words, words[1:])}
        if words[:1] == ["ball"] and "damp" in words:
            damp = numbers.get("damp", damp)
        if "gravity" in words:
            found = [arithmetic(w) for w in words[words.index("gravity") + 1 :]]
            gravity = math.sqrt(sum(g * g for g in found if not math.isnan(g))) if found else gravity
        if "cmat" not in words and words[:2] not in (["contact", "property"], ["contact", "model"]):
            continue
        kind = words[words.index("type") + 1] if "type" in words[:-1] else ""
        kind = "ball-facet" if "wall" in kind or "facet" in kind else kind
        for kind in [kind] if kind else every:
            table = tables.setdefault(kind, {})
            if "model" in words[:-1]:
                table["model"] = words[words.index("model") + 1]
            table.update({k: str(v) for k, v in numbers.items() if k in ("kn", "dp_nratio", "dp_mode")})
            places[kind] = file, number
    for kind, table in tables.items():
        wall, model = kind == "ball-facet", table.get("model", "")
        b = Body("facet" if wall else "ball", wall=wall)
        c = Contact(*places[kind], "pfc", (Body("ball"), b), "PFC_LINEAR", pair=kind, global_damping=damp)
        c.number, c.spring = float(table.get("dp_nratio", 0)), Spring.HOOKE
        c.stiffness = float(table.get("kn", NAN))
        c.gravity = gravity if wall else NAN
        if table.get("dp_mode") in ("1.0", "3.0"):
            c.limited, c.style = True, "linear, dp_nratio, without tension"
        if math.isnan(c.number) or math.isnan(damp):
            c.unknown = "dp_nratio or damp is not a number."
        elif model and model not in ("linear", "linearcbond", "linearpbond", "rrlinear"):
            c.style, c.unknown = model, f"cor does not support the dashpot of the model {model}."
        elif "bond" in model:
            c.notes.append("eps holds for contacts whose bond is broken or absent.")
        deck.contacts.append(c)
    return deck


# ---- MercuryDPM ----

_SETTERS = {  # setter: model; indices of the arguments e, stiffness, and mass of one particle
    "setStiffnessAndRestitutionCoefficient": ("MERCURYDPM_LINEAR", 1, 0, 2),
    "setCollisionTimeAndRestitutionCoefficient": ("MERCURYDPM_LINEAR", 1, 0, 2),
    "setCollisionTimeAndNormalAndTangentialRestitutionCoefficient": ("MERCURYDPM_LINEAR", 1, 0, 3),
    "setRestitutionCoefficient": ("MERCURYDPM_LINEAR", 0, None, 1),
    "setEffectiveElasticModulusAndRestitutionCoefficient": ("MERCURYDPM_HERTZIAN", 1, None, None),
}


def read_mercurydpm(text: str, name: str, options: Options) -> Deck:
    """Reads MercuryDPM's C++: setters of species with literal numbers."""
    source, deck = Source(text, name), Deck(name, "mercurydpm")
    plain = re.sub(r"//[^\n]*|/\*.*?(?:\*/|\Z)", lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.S)
    plain = _with_names(plain)
    mixed = re.compile(r"(?<![\w.>-])[\w.>-]*getMixedObject\(\s*[&*]?(\w+)\s*,\s*[&*]?(\w+)\s*\)")
    plain = mixed.sub(lambda m: f"{m[1]}__{m[2]}".ljust(len(m[0])), plain)
    alias = dict(re.findall(r"\b(\w+)\s*=\s*(\w+__\w+)\s*;", plain))
    constants = {
        m[1]: m[2] for m in re.finditer(r"\b(?:double|Mdouble|auto|int)\s+(\w+)\s*=\s*([^;{}]{1,999});", plain)
    }
    step = re.search(r"\bsetTimeStep\(([^;]{0,999})\);", plain)
    walls = "wallHandler" in plain or "InfiniteWall" in plain
    for m in re.finditer(r"\b(\w+)\s*(?:->|\.)\s*(set\w+)\(([^;]{0,999})\)\s*;", plain):
        if m[2] == "setDissipation":
            bodies = (False, True) if walls else (False,)
            deck.contacts += [_mercury_dashpot(source, m, plain, constants, step, wall) for wall in bodies]
        if m[2] not in _SETTERS:
            continue
        model, k, stiffness, mass = _SETTERS[m[2]]
        at, words = m.start(3), m[3].split(",")
        values = [arithmetic(constants.get(w.strip(), w)) for w in words]
        for wall in (False, True) if walls else (False,):
            given = values[mass : mass + 2] if mass is not None else []
            half, other = ((given[k], given[k]) if given else None for k in (0, -1))
            b = Body("wall", mass=other, wall=True) if wall else Body(m[1], mass=other)
            c = Contact(name, source.line(at), "mercurydpm", (Body(m[1], mass=half), b), model)
            c.number = values[k] if k < len(values) else NAN
            time = m[2].startswith("setCollisionTime")
            c.spring = Spring.NONE if stiffness is None else Spring.CONTACT_TIME if time else Spring.HOOKE
            c.stiffness = NAN if stiffness is None else values[stiffness]
            c.time_step = arithmetic(constants.get(step[1].strip(), step[1])) if step else NAN
            if mass is not None:
                c.zeta_factor = math.sqrt(0.5) if wall else 1.0
                c.notes.append("This e holds only for particles of the mass that the setter receives.")
            start = at + sum(len(w) + 1 for w in words[:k])
            if k < len(words):
                source.place(c, start + len(words[k]) - len(words[k].lstrip()), start + len(words[k].rstrip()))
            if math.isnan(c.number):
                c.unknown = f"{m[2]} is called without a literal number."
            both = [*values, NAN, NAN, NAN][1:3] if "Tangential" in m[2] else []
            c.tangential = _mercury_tangential(c, m[1], plain, constants, both)
            deck.contacts.append(c)
    for m in re.finditer(r"\)\s*(?:->|\.)\s*(set\w+)\(", plain):
        if m[1] in _SETTERS:
            deck.remarks.append(Remark(name, source.line(m.start()), f"the species of this {m[1]} is not read"))
    _mercury_species(deck, plain, alias, constants)
    if not deck.contacts:
        deck.remarks.append(Remark(name, 1, "the text calls no setter of a restitution coefficient that cor supports"))
    return deck


def _with_names(plain: str) -> str:
    """Replaces speciesHandler.getObject(N) by the name of the species, which was added as number N from 0."""
    handler = r"(?<![\w.>-])[\w.>-]*speciesHandler\s*(?:\.|->)\s*"
    added = re.findall(rf"(?:\b(\w+)\s*=\s*)?{handler}(?:copyAndAdd|add)Object\(\s*[&*]?(\w+)", plain)
    names = [(name if re.search(rf"\b{name}\s*(->|\.)", plain) else "") or of for name, of in added]

    def named(m: "re.Match[str]") -> str:
        name = names[int(m[1])] if int(m[1]) < len(names) else ""
        return str(name.ljust(len(m[0])) if 0 < len(name) <= len(m[0]) else m[0])

    return re.sub(rf"{handler}getObject\(\s*(\d{{1,4}})\s*\)", named, plain)


def _kinds_of(plain: str) -> Dict[str, str]:
    """Returns the class of each species, by its name."""
    kinds = {name: kind for kind, name in re.findall(r"\b([A-Z]\w*Species)\b\s*[*&]?\s*(\w+)\s*[;({=,)]", plain)}
    kinds.update(re.findall(r"\b(\w+)\s*=[^;=]*?\b([A-Z]\w*Species)\b", plain))
    for name, of in re.findall(r"\b(\w+)\s*=\s*[\w.>-]*copyAndAddObject\(\s*[&*]?(\w+)\s*\)", plain):
        kinds.setdefault(name, kinds.get(of, ""))
    return kinds


def _mercury_species(deck: Deck, plain: str, alias: Dict[str, str], constants: Dict[str, str]) -> None:
    """Names the bodies of mixed species, and removes contacts that no particles or walls can have. Refuses
    species with other forces, and species whose class is not known."""
    plain = re.sub(r"#include[^\n]*", "", plain)
    kinds, names = _kinds_of(plain), set(re.findall(r"\b[A-Z]\w*Species\b", plain))
    known = re.compile("(Linear|Hertzian)Viscoelastic(Normal|Sliding|Friction|Mindlin|Rolling|Torsion|Mixed)*Species")
    others = sorted(name for name in names if not known.fullmatch(name)) or [""]

    def bodies_of(words: str) -> Set[str]:
        named = re.findall(rf"\b(?=\w*(?:{words}))\w+\s*[*&]?\s*\b(\w+)\s*[;({{=,]", plain)
        return {*named, *re.findall(rf"\b(\w+)\s*=[^;=]*\b\w*(?:{words})", plain)}

    walls, particles = bodies_of("Wall|wallHandler|Screw|Coil"), bodies_of("Particle|particleHandler")
    has = re.findall(r"\b(\w+)\s*(?:->|\.)\s*setSpecies\(\s*[&*]?(\w+)\s*\)", plain)
    if len(has) < len(re.findall(r"(?:->|\.)\s*setSpecies\(", plain)):
        has = []  # a species whose bodies are not known
    of_walls, of_particles = ({s for body, s in has if body not in x} for x in (particles - walls, walls - particles))

    calls = re.findall(r"\b(\w+)\s*(?:->|\.)\s*set(Radius|Density)\(([^;]{0,999})\)\s*;", plain)

    def mass_of(species: str) -> float:
        own = {species, *(b for b, s in has if s == species)}
        radii, densities = ({t for of, k, t in calls if k == key and of in own} for key in ("Radius", "Density"))
        if len(radii) != 1 or len(densities) != 1 or re.search(r"InsertionBoundary|PSD|Mercury2D|Dimensions\(2", plain):
            return NAN
        radius, density = (arithmetic(constants.get(t.strip(), t)) for t in (*radii, *densities))
        return 4 / 3 * math.pi * radius**3 * density

    kept, pairs = [], set()
    for c in deck.contacts:
        wall, own = c.bodies[1].wall, alias.get(c.bodies[0].name, c.bodies[0].name)
        one, is_mixed, two = own.partition("__")
        two = two or one
        kind = next((kinds[s] for s in (one, two) if kinds.get(s)), others[0])
        if (kind or not names) and not known.fullmatch(kind):
            c.unknown = f"cor does not support the species {kind}." if kind else "The class of the species is not read."
        elif kind.startswith("Hertzian") and c.model != "MERCURYDPM_HERTZIAN":
            c.unknown = "cor does not support this setter of a Hertzian species."
        ball = two if wall and one not in of_particles and two in of_particles else one
        if is_mixed:
            c.bodies = replace(c.bodies[0], name=ball), replace(c.bodies[1], name="wall" if wall else two)
        meant = [b.mass[0] for b in c.bodies if b.mass]
        c.bodies = c.bodies[0], replace(c.bodies[1], mass=None) if wall else c.bodies[1]
        masses = [mass_of(ball), math.inf if wall else mass_of(two)]
        if len(meant) == 2 and not any(map(math.isnan, masses)):
            mass, moving = meant[0] * meant[1] / sum(meant), 1 / sum(1 / x for x in masses)
            c.zeta_factor = math.sqrt(mass / moving)
            c.bodies = replace(c.bodies[0], mass=(masses[0],) * 2), replace(c.bodies[1], mass=(masses[1],) * 2)
            c.notes = [f"The setter receives an effective mass of {mass:.6g}, but {moving:.6g} moves."]
            c.notes = c.notes if abs(mass / moving - 1) > 1e-6 else []
        elif len(meant) == 2 and wall and is_mixed:
            c.unknown = c.unknown or "The mass of the particle at the wall is not read, and the damping depends on it."
        pairs |= {(one, two), (two, one)}
        seen = of_walls if wall else of_particles
        if not (of_particles and seen) or any(p in of_particles and q in seen for p, q in ((one, two), (two, one))):
            kept.append(c)
    deck.contacts = kept
    for p, q in sorted((p, q) for p in of_particles for q in of_particles | of_walls)[:MAX_MIXED]:
        if (p, q) not in pairs and p in kinds and q in kinds and not (q in of_particles and q < p):
            text = f"the contact of {p} and {q} has means of both species, which cor does not compute"
            deck.remarks.append(Remark(deck.file, 1, text))


def _mercury_tangential(c: Contact, of: str, plain: str, constants: Dict[str, str], both: List[float]) -> Tangential:
    """Returns the tangential force of the species `of`. both: e and the tangential restitution, if they are given."""
    species = rf"\b{of}\s*(?:->|\.)\s*"
    set_ = re.findall(rf"{species}setSliding(\w+)\(([^;]{{0,999}})\)\s*;", plain)
    found = {key: constants.get(text.strip(), text) for key, text in set_}
    if re.search(rf"{species}set(Rolling|Torsion)\w+\(", plain):
        return Tangential(ROLLS)
    if c.spring is not Spring.HOOKE and c.spring is not Spring.CONTACT_TIME:
        return Tangential("cor has no model of MercuryDPM's tangential force with this normal force")
    if "FrictionCoefficient" not in found:
        return NO_FRICTION
    name, friction, ratios = "sliding-friction", arithmetic(found["FrictionCoefficient"]), []
    if both:
        return by_restitution(name, both[0], both[1], friction)
    normal = c.stiffness if c.spring is Spring.HOOKE else NAN, c.number if c.style else NAN
    for key, whole in zip(("Stiffness", "Dissipation"), normal):
        part, count = re.subn(rf"{species}get{key}\(\)", "1", found.get(key, "0"))
        ratios.append(share(arithmetic(part), 1.0 if count else whole))
    return Tangential(name, ratios[0], ratios[1], friction)


def _mercury_dashpot(
    source: Source, m: "re.Match[str]", plain: str, constants: Dict[str, str], step: Any, wall: bool
) -> Contact:
    """Returns the contact of a species with linear spring and dashpot, for the first radius in the text (2D: discs)."""

    def given(setter: str, of: str = r"\w+") -> float:
        found = re.search(rf"\b{of}\s*(?:->|\.)\s*{setter}\(([^;]{{0,999}})\)\s*;", plain)
        return arithmetic(constants.get(found[1].strip(), found[1])) if found else NAN

    radius, density, disc = given("setRadius"), given("setDensity", m[1]), None
    if re.search(r"public Mercury2D\b|set(Particle)?Dimensions\(2\)", plain):
        disc, density = (math.pi * radius**2 * density,) * 2, NAN
    b = Body(m[1], (radius, radius), density, disc)
    bodies = b, Body("wall", wall=True) if wall else b
    c = Contact(source.name, source.line(m.start()), "mercurydpm", bodies, "LAMMPS_HOOKE_VELOCITY", spring=Spring.HOOKE)
    c.style, c.number = "LinearViscoelastic, setDissipation", given(m[2], m[1])
    c.stiffness = given("setStiffness", m[1])
    c.time_step = arithmetic(constants.get(step[1].strip(), step[1])) if step else NAN
    if math.isnan(c.stiffness) or math.isnan(c.number):
        c.unknown = "The stiffness or dissipation of this species is not a literal number."
    c.tangential = _mercury_tangential(c, m[1], plain, constants, [])
    return c
