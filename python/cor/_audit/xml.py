# SPDX-License-Identifier: MIT
"""Reads XML: models of MuJoCo, worlds of Gazebo (SDF)."""

import math
import re
import xml.etree.ElementTree as ET
from typing import Any, Dict, List, Optional, Set, Tuple
from xml.parsers import expat

from .deck import NAN, Body, Contact, Deck, DeckError, Options, Remark, Spring, Tangential

MAX_DEPTH, MAX_ELEMENTS, MAX_INCLUDES, MAX_GEOMS, MAX_PAIRS = 100, 100000, 100, 2000, 5000


def parse(text: str, name: str) -> ET.Element:
    """Returns the tree of a text. Each element has the attributes .line and .file. Entities are refused."""
    parser = expat.ParserCreate()
    root = ET.Element("")
    stack, count = [root], [0]

    def start(tag: str, attributes: Dict[str, str]) -> None:
        made = ET.SubElement(stack[-1], tag.rpartition(":")[2], attributes)
        made.set(" line", str(parser.CurrentLineNumber))
        made.set(" file", name)
        stack.append(made)
        count[0] += 1
        if len(stack) > MAX_DEPTH or count[0] > MAX_ELEMENTS:
            raise DeckError(f"{name}: more than {MAX_DEPTH} nested elements, or {MAX_ELEMENTS} in all")

    def refuse(*words: Any) -> None:
        raise DeckError(f"{name}: line {parser.CurrentLineNumber}: XML entities are not supported; write their text")

    def characters(data: str) -> None:
        stack[-1].text = (stack[-1].text or "") + data

    parser.StartElementHandler, parser.EntityDeclHandler = start, refuse
    parser.EndElementHandler = lambda tag: stack.pop()
    parser.CharacterDataHandler, parser.buffer_text = characters, True
    try:
        parser.Parse(text.encode("utf-8", "replace"), True)
    except expat.ExpatError as error:
        raise DeckError(f"{name}: this is not XML: {error}") from None
    return root


def _numbers(text: Optional[str]) -> List[float]:
    made = []
    for word in (text or "").split():
        try:
            made.append(float(word))
        except ValueError:
            made.append(NAN)
    return made


# ---- MuJoCo ----


class _Geom:
    """A geom: its attributes after the defaults have been applied."""

    def __init__(self, element: ET.Element, values: Dict[str, str], body: int, suffix: str = "") -> None:
        self.line, self.file, self.body = int(element.get(" line", 0)), element.get(" file", ""), body
        self.values, self.type, self.suffix = values, values.get("type", "sphere"), suffix
        self.name = (values.get("name") or f"geom of line {self.line}") + suffix

    def number(self, key: str, otherwise: float) -> float:
        found = _numbers(self.values.get(key))
        return found[0] if found else otherwise

    def vector(self, key: str, start: List[float]) -> List[float]:
        found = _numbers(self.values.get(key))[: len(start)]
        return found + start[len(found) :]


class _Model:
    SOLREF, SOLIMP = [0.02, 1.0], [0.9, 0.95, 0.001, 0.5, 2.0]
    NUMBERS = "solref solimp solmix priority condim contype conaffinity size mass density friction".split()

    def __init__(self, name: str, options: Options) -> None:
        self.deck, self.options = Deck(name, "mujoco"), options
        self.classes: Dict[str, Dict[str, Dict[str, str]]] = {"main": {}}
        self.geoms: List[_Geom] = []
        self.parent, self.weld, self.body_names = [0], [0], ["world"]
        self.pairs: List[ET.Element] = []
        self.excluded: Set[Tuple[str, ...]] = set()
        self.option: Dict[str, str] = {}
        self.flag: Dict[str, str] = {}
        self.included = 0

    def include(self, element: ET.Element, depth: int = 0) -> None:
        """Replaces includes by the elements of the included files."""
        made: List[ET.Element] = []
        for child in element:
            if child.tag != "include":
                self.include(child, depth)
                made.append(child)
                continue
            of, name = child.get(" file", ""), child.get("file", "")
            found = self.options.include(name, of) if name else None
            self.included += 1
            if found is None or depth > 15 or self.included > MAX_INCLUDES:
                why = "cannot include" if found is None else "too many includes; does a file include itself?"
                self.remark(child, f"{why} {name}")
                continue
            root = parse(*found)
            self.include(root, depth + 1)
            made += list(root[0]) if len(root) else []
        element[:] = made

    def remark(self, element: ET.Element, text: str, matters: bool = True) -> None:
        self.deck.remarks.append(Remark(element.get(" file", ""), int(element.get(" line", 0)), text, matters))

    def read_defaults(self, element: ET.Element, outer: Dict[str, Dict[str, str]], top: bool) -> None:
        values = {tag: dict(attributes) for tag, attributes in outer.items()}
        for child in element:
            if child.tag in ("geom", "pair"):
                values.setdefault(child.tag, {}).update(child.attrib)
        name = element.get("class", "main") if not top else "main"
        self.classes.setdefault(name, {}).update(values)
        for child in element:
            if child.tag == "default":
                self.read_defaults(child, self.classes[name], False)

    def read_body(self, element: ET.Element, body: int, child_class: str, suffix: str = "") -> None:
        """Reads the geoms of a body. Reads two copies of a replicate or composite, which represent all of them."""
        for child in element:
            inner = child.get("childclass", child_class)
            copies = [suffix]
            if (
                len(suffix) < 8
                and child.tag in ("replicate", "composite")
                and set(child.get("count", "1").split()) - {"1"}
            ):
                copies = [suffix + "0", suffix + "1"]
            if child.tag == "geom":
                values = dict(self.classes.get(child.get("class", child_class), self.classes["main"]).get("geom", {}))
                values.update(child.attrib)
                self.geoms.append(_Geom(child, values, body, suffix))
            elif child.tag == "flexcomp" and child.get("rigid") == "true":
                values = {k: v for c in child if c.tag == "contact" for k, v in c.attrib.items()}
                self.geoms.append(_Geom(child, {**values, "type": "flex", "name": child.get("name", "")}, body, suffix))
            elif child.tag in ("body", "frame", "replicate", "composite"):
                for copy in copies:
                    now = body
                    if child.tag in ("body", "composite"):
                        moves = child.tag == "composite" or any(c.tag in ("joint", "freejoint") for c in child)
                        now = len(self.parent)
                        self.parent.append(body)
                        self.weld.append(now if moves else self.weld[body])
                        self.body_names.append(child.get("name", "") + suffix)
                    self.read_body(child, now, inner, copy)
            elif child.tag == "flexcomp":
                name = child.get("name", "")
                text = f"contacts of the flexcomp {name} are not judged: its elasticity also sets how it rebounds"
                self.remark(child, text)
            elif child.tag == "attach":
                self.remark(child, "the geoms of attach are not read")

    def read(self, text: str) -> Deck:
        root = parse(text, self.deck.file)
        self.include(root)
        sections = [s for top in root for s in top]
        for section in sections:
            if section.tag == "default":
                self.read_defaults(section, self.classes["main"], section.get("class", "main") == "main")
            elif section.tag == "option":
                self.option.update(section.attrib)
                for flag in section:
                    self.flag.update(flag.attrib)
        for section in sections:
            if section.tag == "worldbody":
                self.read_body(section, 0, section.get("childclass", "main"))
        for child in (c for s in sections if s.tag == "contact" for c in s):
            if child.tag == "pair":
                self.pairs.append(child)
            elif child.tag == "exclude":
                self.excluded.add(tuple(sorted((child.get("body1", ""), child.get("body2", "")))))
        if self.flag.get("contact") == "disable" or self.flag.get("constraint") == "disable":
            raise DeckError("contacts are disabled in this model")
        self.add_pairs()
        if not self.deck.contacts:
            why = "".join(f"; line {r.line}: {r.text}" for r in self.deck.remarks)
            raise DeckError(f"no two geoms of this model can meet{why}")
        return self.deck

    def add_pairs(self) -> None:
        """Adds the possible contacts: explicit pairs, and pairs that pass MuJoCo's filters."""
        named = {g.name: g for g in self.geoms}
        explicit = set()
        for pair in self.pairs:
            first, second = (named.get(pair.get(key, "")) for key in ("geom1", "geom2"))
            if first is None or second is None:
                self.remark(pair, "a geom of this pair is not in the model")
                continue
            values = dict(self.classes.get(pair.get("class", "main"), {}).get("pair", {}))
            values.update(pair.attrib)
            explicit.add(frozenset((first.name, second.name)))
            self.contact(first, second, _Geom(pair, values, 0))
        if len(self.geoms) > MAX_GEOMS:
            raise DeckError(f"the model has {len(self.geoms)} geoms; cor reads up to {MAX_GEOMS}")
        for i, one in enumerate(self.geoms):
            for two in self.geoms[i + 1 :]:
                if len(self.deck.contacts) >= MAX_PAIRS:
                    text = f"more than {MAX_PAIRS} contacts; the rest is not judged"
                    self.deck.remarks.append(Remark(self.deck.file, 1, text))
                    return
                if self.can_meet(one, two) and frozenset((one.name, two.name)) not in explicit:
                    self.contact(one, two, None)

    def can_meet(self, one: _Geom, two: _Geom) -> bool:
        masks = [[g.number(key, 1) for key in ("contype", "conaffinity")] for g in (one, two)]
        types = [[int(x if 0 <= x < 2**31 else 1) for x in pair] for pair in masks]
        if not (types[0][0] & types[1][1] or types[1][0] & types[0][1]):
            return False
        if "1" in one.suffix + two.suffix and not "" < one.suffix < two.suffix:
            return False  # the contact of the first copies represents it
        if {one.type, two.type} <= {"plane", "hfield"}:
            return False
        welds = self.weld[one.body], self.weld[two.body]
        if welds[0] == welds[1]:
            return False
        names = tuple(sorted((self.body_names[one.body], self.body_names[two.body])))
        if names in self.excluded:
            return False
        parents = [self.weld[self.parent[w]] for w in welds]
        related = (parents[0] == welds[1] and welds[1] != 0) or (parents[1] == welds[0] and welds[0] != 0)
        return not related or self.flag.get("filterparent") == "disable"

    def contact(self, one: _Geom, two: _Geom, pair: Optional[_Geom]) -> None:
        """Adds a contact with the parameters that MuJoCo mixes from both geoms, or the parameters of a pair."""
        at = pair or max(one, two, key=lambda g: g.line)
        priority = one.number("priority", 0) - two.number("priority", 0)
        mixes = [g.number("solmix", 1) for g in (one, two)]
        total = sum(m for m in mixes if m >= 1e-15)
        share = mixes[0] / total if min(mixes) >= 1e-15 else 0.5 if max(mixes) < 1e-15 else float(mixes[0] >= 1e-15)
        share = 1.0 if priority > 0 else 0.0 if priority < 0 else share
        refs = [g.vector("solref", self.SOLREF) for g in (one, two)]
        imps = [g.vector("solimp", self.SOLIMP) for g in (one, two)]
        if share in (0.0, 1.0) or (refs[0][0] > 0 and refs[1][0] > 0):
            ref = [share * a + (1 - share) * b for a, b in zip(*refs)]
        else:
            ref = list(map(min, *refs))
        imp = [share * a + (1 - share) * b for a, b in zip(*imps)]
        both = [[g.number(key, start) for g in (one, two)] for key, start in (("condim", 3), ("friction", 1))]
        condim, friction = (max(x) if priority == 0 else x[priority < 0] for x in both)
        if pair is not None:
            ref, imp, condim = pair.vector("solref", ref), pair.vector("solimp", imp), pair.number("condim", condim)
            friction = pair.number("friction", friction)
        read = [g for g in (one, two, pair) if g]
        if self.flag.get("override") == "enable":
            whole = _Geom(ET.Element(""), {key[2:]: value for key, value in self.option.items() if key[:2] == "o_"}, 0)
            ref, imp = whole.vector("solref", self.SOLREF), whole.vector("solimp", self.SOLIMP)
            friction = whole.number("friction", 1)
            read.append(whole)
        bodies = [Body(g.name, wall=self.weld[g.body] == 0) for g in (one, two)]
        bodies.sort(key=lambda b: b.wall)
        c = Contact(at.file, at.line, "mujoco", (bodies[0], bodies[1]), pair=f"{one.name}-{two.name}")
        c.tangential = Tangential("MuJoCo has no parameter for it; MuJoCo's friction is a constraint that only damps")
        self.set_model(c, ref, imp, condim, max(friction, 1e-5))
        wrong = {k: None for k in self.NUMBERS for g in read if any(map(math.isnan, _numbers(g.values.get(k))))}
        if wrong:
            c.unknown = f"MuJoCo does not load this model: {', '.join(wrong)} must be numbers."
        self.deck.contacts.append(c)

    def set_model(self, c: Contact, ref: List[float], imp: List[float], condim: float, friction: float) -> None:
        step = _numbers(self.option.get("timestep", "0.002"))
        c.time_step = step[0] if step else NAN
        c.integrator = -1 if self.option.get("integrator") == "RK4" else None
        gravity = _numbers(self.option.get("gravity", "0 0 -9.81"))
        c.gravity = math.sqrt(sum(g * g for g in gravity)) if c.bodies[1].wall else NAN
        if (ref[0] > 0) != (ref[1] > 0) and ref[0] > 0:
            c.notes.append("MuJoCo replaces a solref of mixed signs by 0.02 1.")
            ref = self.SOLREF
        c.spring = Spring.PER_MASS
        if ref[0] > 0:
            chosen = self.options.time_step
            least = 2 * (c.time_step if math.isnan(chosen) else chosen)
            if ref[0] < least and self.flag.get("refsafe") != "disable":
                c.notes.append("MuJoCo raises timeconst to two time steps.")
                ref = [least, ref[1]]
            c.model, c.number = "MUJOCO_TIME_CONSTANT", ref[1]
            c.stiffness = (1 / (ref[0] * ref[1])) ** 2 if 1e-24 < ref[0] * ref[1] < 1e24 else NAN
        else:
            c.model, c.number, c.stiffness = "MUJOCO_STIFFNESS", -ref[1], -ref[0]
        low, high, middle = (min(max(d, 1e-4), 0.9999) for d in (*imp[:2], imp[3]))
        c.solimp = low, high, max(imp[2], 1e-15), middle, imp[4]
        impratio = next(iter(_numbers(self.option.get("impratio"))), 1.0)
        if condim > 1 and self.option.get("cone") != "elliptic" and impratio > 0:
            c.softness = friction**2 * (1 + friction**2) / impratio / (condim - 1)
        if c.softness != 1:
            c.notes.append("The friction changes eps, because MuJoCo's cones of friction are pyramidal here.")
        if c.solimp[0] == c.solimp[1]:  # constant impedance: a linear spring and dashpot
            scale = 1 / (c.solimp[0] + c.softness * (1 - c.solimp[0]))
            c.solimp = (c.solimp[0] * scale,) * 2 + c.solimp[2:]
            c.stiffness, c.softness = c.stiffness * scale, 1.0
            c.number *= scale if c.model == "MUJOCO_STIFFNESS" else math.sqrt(scale)
        else:
            text = "dmin and dmax of solimp differ: stiffness and damping depend on the overlap, and eps on the speed."
            c.notes.append(text)
        if any(map(math.isnan, imp)) or imp[4] < 1:
            c.unknown = "The solimp of this contact could not be read."
        elif not (0 <= c.number < 1e24 and 1e-48 < c.stiffness < 1e48):
            c.unknown = "The solref of this contact is not a pair of numbers, or a number is out of range."


def read_mujoco(text: str, name: str, options: Options) -> Deck:
    """Reads a MuJoCo model."""
    return _Model(name, options).read(text)


# ---- Gazebo ----


def read_gazebo(text: str, name: str, options: Options) -> Deck:
    """Reads a Gazebo world or model. Elements `collision` of different models form pairs, unless both are static."""
    deck = Deck(name, "gazebo")
    root = parse(text, name)
    found: List[Tuple[str, bool, int, float, float, int]] = []
    step = next(iter(_numbers(root.findtext(".//physics/max_step_size"))), NAN)
    engines = {physics.get("type", "ode") for physics in root.iter("physics")} - {"ode"}
    for model in root.iter("model"):
        static = (model.findtext("static") or "").strip().lower() in ("true", "1")
        for collision in model.iter("collision"):
            bounce = collision.find("surface/bounce")
            e = next(iter(_numbers(bounce.findtext("restitution_coefficient"))), 0.0) if bounce is not None else 0.0
            least = next(iter(_numbers(bounce.findtext("threshold"))), 1e5) if bounce is not None else 1e5
            line = int((collision if bounce is None else bounce).get(" line", 0))
            given = collision.findtext("surface/contact/collide_bitmask") or ""
            mask = re.fullmatch(r"\s*(0x[0-9a-fA-F]+|\d+)\s*", given)
            bits = int(mask[1], 0 if "x" in mask[1] else 10) if mask else 0xFFFF
            found.append((f"{model.get('name', '')}/{collision.get('name', '')}", static, line, e, least, bits))
    for i, one in enumerate(found):
        for two in found[i + 1 :]:
            apart = one[1] and two[1] or not one[5] & two[5] or one[0].split("/")[0] == two[0].split("/")[0]
            if apart or len(deck.contacts) >= MAX_PAIRS:
                continue
            a, b = sorted((Body(x[0], wall=x[1]) for x in (one, two)), key=lambda body: body.wall)
            c = Contact(name, max(one[2], two[2]), "gazebo", (a, b), "GAZEBO_BOUNCE", pair=f"{one[0]}-{two[0]}")
            c.number, c.threshold, c.time_step = min(one[3], two[3]), min(one[4], two[4]), step
            if engines:
                c.unknown = f"cor supports only contacts of ODE, not of the physics {', '.join(sorted(engines))}."
            c.number += 0 * (one[3] + two[3])  # NaN if one of the two is NaN
            deck.contacts.append(c)
    for one in found if not deck.contacts else []:  # a model without a world
        a, b = Body(one[0]), Body("any")
        c = Contact(name, one[2], "gazebo", (a, b), "GAZEBO_BOUNCE", number=one[3], threshold=one[4], time_step=step)
        c.notes.append("If the other body has a smaller e or threshold, the simulator uses that one.")
        deck.contacts.append(c)
    for c in deck.contacts:
        if math.isnan(c.number + c.threshold):
            c.unknown = c.unknown or "Its restitution_coefficient or threshold is not a number."
    return deck
