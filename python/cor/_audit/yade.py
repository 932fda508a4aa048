# SPDX-License-Identifier: MIT
"""Reads YADE's Python from its syntax tree. Does not execute the script; interprets statements of constants."""

import ast
import math
import operator
import re
import warnings
from dataclasses import dataclass, field, replace
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from .._cor import lib

from .deck import (
    NAN, ROLLS, Body, Contact, Deck, DeckError, Options, Remark, Repair, Spring, Tangential, by_restitution, share,
)  # fmt: skip

MAX_TEXT, MAX_STEPS, MAX_ITEMS, MAX_CALLS = 1 << 22, 300000, 20000, 30
UNKNOWN: Any = object()  # a value that is not a constant
_OPERATORS: Dict[Any, Callable[..., Any]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv, ast.Mod: operator.mod, ast.Pow: operator.pow,
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge, ast.Eq: operator.eq,
    ast.NotEq: operator.ne, ast.USub: operator.neg, ast.UAdd: operator.pos, ast.Not: operator.not_,
}  # fmt: skip
_MATH = {n: getattr(math, n) for n in "sqrt exp log log10 sin cos tan asin acos atan atan2 ceil floor radians".split()}
_MATH.update(pow=math.pow, float=float, int=int, abs=abs, min=min, max=max, len=len, degrees=math.degrees)
_MATH.update(toHP1=float, Real=float, radiansHP1=math.radians)  # functions of yade.math, which also accept "0.3"
_MATERIAL = {"young": 1e9, "poisson": 0.25, "density": 1000.0}  # defaults of YADE's classes
_LOSSES: Tuple[str, ...] = ("DragEngine", "LinearDragEngine", "HydroForceEngine", "FlowEngine", "TwoPhaseFlowEngine")
_LOSSES += ("ViscousForceEngine", "SPHEngine", "FluidDomain", "OpenFoamCoupling")
_FACETS = re.compile("facet[A-Z]\\w*|gtsSurface2Facets|stl|gmsh|unv|ele|iges")
_LAWS = "Basic Mindlin HertzWithLinearShear MindlinDeresiewitz CundallStrack CohesionMoment Cpm ElPerfPl".split()
_LAWS.append("JointedCohesiveFrictionalPM")
_NUMBERS = {"en", "betan", "tc", "kn", "cn", "damping"}
_MATERIALS = "FrictMat FrictMatCDM FrictViscoMat ViscElMat ViscElCapMat LudingMat CohFrictMat JCFpmMat CpmMat WireMat"
_FRICTIONAL = {  # functors of linear springs without dashpots, and the numbers of a material that bonds two spheres
    "Ip2_FrictMat_FrictMat_FrictPhys": ("FrictPhys, CundallStrack", ()),
    "Ip2_CohFrictMat_CohFrictMat_CohFrictPhys": ("CohFrictPhys, CohesionMoment", ("normalCohesion", "shearCohesion")),
    "Ip2_FrictMat_CpmMat_FrictPhys": ("FrictPhys, CundallStrack", ()),
    "Ip2_JCFpmMat_JCFpmMat_JCFpmPhys": ("JCFpmPhys", ("tensileStrength", "cohesion")),
}


@dataclass(eq=False)
class Thing:
    """A YADE object, represented by the call that makes it: keywords with their values and places in the text."""

    name: str
    line: int
    values: Dict[str, Any] = field(default_factory=dict)
    nodes: Dict[str, ast.AST] = field(default_factory=dict)
    arguments: List[Any] = field(default_factory=list)

    def number(self, key: str, otherwise: float = NAN) -> float:
        """Returns a keyword's number; NaN if it is not a constant."""
        value = self.values.get(key, otherwise)
        return float(value) if isinstance(value, (int, float)) else NAN


@dataclass
class Spheres:
    """Bodies of one kind: sphere, facet, wall or box."""

    kind: str
    material: Optional[Thing]
    radius: Tuple[float, float] = (NAN, NAN)
    fixed: bool = False
    count: float = math.inf
    clump: bool = False
    mass: float = 0.0  # mass of a box
    axis: Optional[int] = None
    mask: int = 1


class Return(Exception):
    """Raised at the end of a function, or by break or continue of a loop."""


class Script:
    """The state of a script up to the present statement."""

    def __init__(self) -> None:
        self.names: Dict[str, Any] = {"O": Thing("O", 0), "Omega": Thing("Omega", 0), "pi": math.pi}
        self.names["math"] = self.names["numpy"] = self.names["np"] = Thing("math", 0, {"pi": math.pi})
        self.materials: List[Thing] = []
        self.bodies: List[Spheres] = []
        self.things: List[Thing] = []
        self.params: Dict[str, Any] = {}
        self.remarks: Dict[Tuple[int, str], bool] = {}
        self.time_step: Any = None
        self.steps = self.depth = self.unsure = 0
        self.is_run = False
        self.called: set[str] = set()
        self.makers: Dict[str, Any] = {}  # the materials that functions return

    def note(self, line: int, text: str, matters: bool = False) -> None:
        self.remarks.setdefault((line, text), matters)

    # ---- values ----

    def value(self, node: Optional[ast.AST]) -> Any:
        """Returns the value of an expression, or UNKNOWN."""
        self.steps += 1
        if node is None or self.steps > MAX_STEPS:
            return None if node is None else UNKNOWN
        method = getattr(self, "value_" + type(node).__name__, None)
        if method is None:
            for child in ast.iter_child_nodes(node):
                self.value(child)
            return UNKNOWN
        try:
            return method(node)
        except (ArithmeticError, TypeError, ValueError, LookupError, AttributeError, RecursionError):
            return UNKNOWN

    def value_Constant(self, node: ast.Constant) -> Any:
        return float(node.value) if isinstance(node.value, int) and abs(node.value) > 2**53 else node.value

    def value_Name(self, node: ast.Name) -> Any:
        return {"True": True, "False": False}.get(node.id, self.names.get(node.id, UNKNOWN))

    def sequence(self, elements: Sequence[ast.AST]) -> List[Any]:
        made: List[Any] = []
        for e in elements:
            value = self.value(e.value if isinstance(e, ast.Starred) else e)
            made += list(value) if isinstance(e, ast.Starred) and isinstance(value, (list, tuple)) else [value]
        return made

    def value_Tuple(self, node: ast.Tuple) -> Any:
        return tuple(self.sequence(node.elts))

    def value_List(self, node: ast.List) -> Any:
        return self.sequence(node.elts)

    def value_Lambda(self, node: ast.Lambda) -> Any:
        return UNKNOWN if node.args.args else self.value(node.body)  # for YADE, a function that makes a material

    def value_Dict(self, node: ast.Dict) -> Any:
        pairs = zip(node.keys, node.values)
        return {self.value(k): Placed(self.value(v), v) for k, v in pairs if k is not None}

    def value_UnaryOp(self, node: ast.UnaryOp) -> Any:
        return self.operate(node.op, self.value(node.operand))

    def value_BinOp(self, node: ast.BinOp) -> Any:
        return self.operate(node.op, self.value(node.left), self.value(node.right))

    def operate(self, op: Any, *values: Any) -> Any:
        if any(v is UNKNOWN or isinstance(v, Thing) for v in values) or type(op) not in _OPERATORS:
            return UNKNOWN
        if any(isinstance(v, (str, list, tuple)) for v in values) and not isinstance(op, (ast.Eq, ast.NotEq)):
            if not isinstance(op, ast.Add) or sum(len(v) for v in values) > MAX_ITEMS:
                return UNKNOWN
        if isinstance(op, ast.Pow):
            values = tuple(map(float, values))
        result = _OPERATORS[type(op)](*values)
        if isinstance(result, complex):
            return UNKNOWN
        return float(result) if isinstance(result, int) and abs(result) > 2**53 else result

    def value_Compare(self, node: ast.Compare) -> Any:
        left, right = self.value(node.left), self.value(node.comparators[0])
        if len(node.ops) == 1 and isinstance(node.ops[0], (ast.In, ast.NotIn)) and UNKNOWN not in (left, right):
            return (left in right) == isinstance(node.ops[0], ast.In)
        return self.operate(node.ops[0], left, right) if len(node.ops) == 1 else UNKNOWN

    def value_BoolOp(self, node: ast.BoolOp) -> Any:
        values = [self.value(v) for v in node.values]
        if UNKNOWN in values:
            return UNKNOWN
        return all(values) if isinstance(node.op, ast.And) else any(values)

    def value_IfExp(self, node: ast.IfExp) -> Any:
        test = self.value(node.test)
        return UNKNOWN if test is UNKNOWN else self.value(node.body if test else node.orelse)

    def value_Subscript(self, node: ast.Subscript) -> Any:
        of, index = self.value(node.value), node.slice
        if isinstance(of, Thing) and of.name == "O.materials":
            return self.material(self.value(index)) or UNKNOWN
        found = of[self.value(index)] if isinstance(of, (list, tuple, dict, str)) else UNKNOWN
        return found.value if isinstance(found, Placed) else found

    def items(self, node: ast.AST) -> Any:
        """Returns the elements of a loop; for a SpherePack (centre, radius) of its smallest and largest sphere."""
        of = self.value(node)
        is_pack = isinstance(of, Thing) and of.name == "SpherePack"
        return [(UNKNOWN, r) for r in of.values.get("radius", (NAN, NAN))] if is_pack else of

    def value_ListComp(self, node: ast.ListComp) -> Any:
        made: List[Any] = []
        items = self.items(node.generators[0].iter)
        if len(node.generators) > 1 or not isinstance(items, (list, tuple, range)):
            self.unsure += 1
            self.value(node.elt)
            self.unsure -= 1
            return UNKNOWN
        for item in list(items)[:MAX_ITEMS]:
            self.assign(node.generators[0].target, item, None)
            if all(self.value(test) is not False for test in node.generators[0].ifs):
                made.append(self.value(node.elt))
        return made

    value_GeneratorExp = value_ListComp

    def value_Attribute(self, node: ast.Attribute) -> Any:
        of = self.value(node.value)
        if not isinstance(of, Thing):
            return UNKNOWN
        if of.name in ("O", "Omega"):
            return of.values.get(node.attr, self.time_step if node.attr == "dt" else Thing(f"O.{node.attr}", 0))
        if of.name == "table":
            return self.params.get(node.attr, UNKNOWN)
        return of.values.get(node.attr, _MATERIAL.get(node.attr, UNKNOWN) if of.name.endswith("Mat") else UNKNOWN)

    # ---- calls ----

    def value_Call(self, node: ast.Call) -> Any:
        function = node.func
        name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
        of = self.value(function.value) if isinstance(function, ast.Attribute) else None
        thing = Thing(name, node.lineno, arguments=self.sequence(node.args))
        for keyword in node.keywords:
            value = self.value(keyword.value)
            if keyword.arg is not None:
                thing.values[keyword.arg], thing.nodes[keyword.arg] = value, keyword.value
            elif isinstance(value, dict):
                for key, placed in value.items():
                    thing.values[key], thing.nodes[key] = placed.value, placed.node
            else:
                self.note(node.lineno, f"the keywords of {name} are not constants", True)
        if isinstance(self.names.get(name), ast.FunctionDef) and of is None:
            return self.call(self.names[name], thing)
        self.is_run |= name in ("run", "step") and of is self.names["O"]
        if name in ("reset", "resetThisScene") and of is self.names["O"]:
            self.bodies, self.materials, self.things = [], [], []
        if isinstance(of, Thing) and of.name in ("O.materials", "O.bodies", "O.engines", "SpherePack"):
            return self.method(of, thing)
        if name == "toSimulation" and isinstance(of, list):
            self.bodies += [b for b in of if isinstance(b, Spheres)]
        elif name == "toSimulation":
            material = self.material(thing.values.get("material", -1))
            self.bodies.append(Spheres("sphere", material, (NAN, NAN), fixed=thing.values.get("fixed") is True))
            self.note(node.lineno, "the radii of a packing are not read")
        # a body counts even if it is not certain that this line runs
        is_body = any(isinstance(x, Spheres) for x in thing.arguments)
        if isinstance(of, list) and name in ("append", "extend", "insert") and (is_body or not self.unsure):
            of.extend(thing.arguments[-1] if name == "extend" else thing.arguments[-1:])
            return None
        if name in _MATH and (of is None or isinstance(of, Thing)):
            return UNKNOWN if UNKNOWN in thing.arguments else _MATH[name](*thing.arguments)
        if name in ("enumerate", "zip") and all(isinstance(x, (list, tuple, range)) for x in thing.arguments):
            return list({"enumerate": enumerate, "zip": zip}[name](*thing.arguments))
        if name in ("range", "xrange"):
            items = range(*map(int, thing.arguments))
            return items if len(items) <= MAX_ITEMS else UNKNOWN
        if name in ("Vector3", "list", "tuple"):
            return tuple(thing.arguments) if name == "Vector3" else list(thing.arguments[0] if thing.arguments else ())
        if name == "dict":
            return {k: Placed(v, thing.nodes[k]) for k, v in thing.values.items()}
        if name == "readParamsFromTable":
            self.params.update({k: v for k, v in thing.values.items() if k not in ("unknownOk", "noTableOk")})
            return None
        made = self.make(thing)
        mask = thing.values.get("mask", 1)
        for body in (made if isinstance(made, list) else [made]) if isinstance(mask, int) else []:
            if isinstance(body, Spheres):
                body.mask = mask
        return made

    def make(self, thing: Thing) -> Any:
        """Returns a YADE object: a material, engine, body, packing or time step."""
        name, a = thing.name, thing.arguments
        if name == "Omega":
            return self.names["O"]
        if name == "PWaveTimeStep":
            spheres = [b for b in self.bodies if b.kind == "sphere"]
            steps = [b.radius[0] * math.sqrt(density_of(b.material) / young_of(b.material)) for b in spheres]
            return min(steps) if steps and not any(map(math.isnan, steps)) else UNKNOWN
        if name == "SpherePWaveTimeStep" and len(a) == 3:
            return a[0] * math.sqrt(a[1] / a[2])
        get = thing.values.get
        if name in ("sphere", "facet", "wall", "box"):
            radius = number_of(get("radius", a[1] if len(a) > 1 else UNKNOWN)) if name == "sphere" else NAN
            if name == "sphere" and math.isnan(radius):
                self.note(thing.line, "the radius of a sphere is not read")
            fixed = get("fixed", name in ("facet", "wall"))
            body = Spheres(name, None, (radius, radius), bool(fixed is True or get("dynamic") is False), 1)
            if name == "box":
                half = get("extents", a[1] if len(a) > 1 else UNKNOWN)
                body.mass = 8 * half[0] * half[1] * half[2] if isinstance(half, (tuple, list)) else NAN
            axis = get("axis", a[1] if len(a) > 1 else None)
            body.axis = axis if name == "wall" and axis in (0, 1, 2) else None
            body.material = self.material(get("material", -1))
            return body
        if name == "aabbWalls":
            return [Spheres("box", self.material(get("material", -1)), fixed=True, mass=NAN)]
        if _FACETS.fullmatch(name):
            return [Spheres("facet", self.material(get("material", -1)), fixed=True)]
        if name == "filterSpherePack" and len(a) > 1 and isinstance(a[1], Thing):
            if get("returnSpherePack") is True:
                return a[1]
            made = Spheres("sphere", self.material(get("material", -1)), a[1].values.get("radius", (NAN, NAN)))
            made.clump = "clump" in a[1].values
            return [made]
        if re.fullmatch("regular(Hexa|Ortho)|random(Dense|Peri)Pack|text(Ext)?|textClumps", name):
            mean, fuzz = number_of(get("radius", a[1] if len(a) > 1 else UNKNOWN)), number_of(get("rRelFuzz", 0.0))
            material = self.material(get("material", -1))
            return [Spheres("sphere", material, (mean * (1 - fuzz), mean * (1 + fuzz)), clump="Clump" in name)]
        if re.fullmatch("(Box|Circular|Sphere)sFactory|BoxFactory|CircularFactory|SpheresFactory", name):
            sizes = thing.number("rMin"), thing.number("rMax")
            self.bodies.append(Spheres("sphere", self.material(get("materialId", get("material", -1))), sizes))
        self.things.append(thing)
        label = get("label")
        if isinstance(label, str) and not name.endswith("Mat"):
            self.names[label] = thing
        return thing

    def method(self, of: Thing, call: Thing) -> Any:
        name, a = call.name, call.arguments
        if of.name == "SpherePack":
            if name == "makeCloud":
                mean, fuzz = call.number("rMean"), call.number("rRelFuzz", 0.0)
                sizes = call.values.get("psdSizes", UNKNOWN)
                of.values["radius"] = mean * (1 - fuzz), mean * (1 + fuzz)
                if isinstance(sizes, (list, tuple)) and UNKNOWN not in sizes:
                    of.values["radius"] = min(sizes) / 2, max(sizes) / 2
            elif name == "makeClumpCloud":
                of.values["clump"] = True
            elif name == "add" and len(a) > 1:
                of.values["radius"] = number_of(a[1]), number_of(a[1])
            elif name == "toSimulation":
                radius = of.values.get("radius", (NAN, NAN))
                material, is_clump = self.material(call.values.get("material", -1)), "clump" in of.values
                self.bodies.append(Spheres("sphere", material, radius, clump=is_clump))
            return UNKNOWN
        if name == "replaceByClumps":
            self.note(call.line, "spheres are replaced by clumps, which rebound with their own mass and shape", True)
        if not a or name not in ("append", "appendClumped", "insert"):
            return UNKNOWN
        items = list(a[-1]) if isinstance(a[-1], (list, tuple)) else [a[-1]]
        if of.name == "O.materials":
            first = len(self.materials)
            self.materials += [m for m in items if isinstance(m, Thing)]
            numbers = tuple(range(first, len(self.materials)))
            return numbers if isinstance(a[-1], (list, tuple)) else numbers[0] if numbers else UNKNOWN
        for item in items if of.name == "O.bodies" else []:
            if isinstance(item, Spheres):
                item.clump = item.clump or name == "appendClumped"
                item.count = math.inf if self.unsure else item.count
                self.bodies.append(item)
            elif isinstance(item, Thing) and not item.name.startswith("O."):
                self.note(call.line, f"cor does not read the body {item.name}, nor judge its contacts", True)
            elif item is UNKNOWN:
                self.note(call.line, "some bodies are not constants: their sizes are not read")
        return UNKNOWN

    def material(self, given: Any) -> Optional[Thing]:
        """Returns a material by its number, label or object."""
        if isinstance(given, ast.FunctionDef):  # YADE calls it for each body
            given = self.makers.setdefault(given.name, self.call(given, Thing(given.name, given.lineno)))
        if isinstance(given, Thing):
            return given
        if isinstance(given, str):
            return next((m for m in self.materials if m.values.get("label") == given), None)
        if isinstance(given, int) and -len(self.materials) <= given < len(self.materials):
            return self.materials[given]
        return None

    # ---- statements ----

    def call(self, function: ast.FunctionDef, given: Thing) -> Any:
        if self.depth >= MAX_CALLS:
            return UNKNOWN
        self.called.add(function.name)
        outer = dict(self.names)
        names = [a.arg for a in function.args.args]
        defaults = function.args.defaults
        self.names.update({n: self.value(d) for n, d in zip(names[len(names) - len(defaults) :], defaults)})
        self.names.update(zip(names, given.arguments))
        rest = {k: v for k, v in given.values.items() if k not in names}
        self.names.update({k: v for k, v in given.values.items() if k in names})
        if function.args.kwarg:
            self.names[function.args.kwarg.arg] = {k: Placed(v, given.nodes[k]) for k, v in rest.items()}
        self.depth += 1
        result: Any = None
        try:
            self.run(function.body)
        except Return as end:
            result = end.args[0] if end.args else None
        self.depth -= 1
        kept = {n for node in ast.walk(function) if isinstance(node, ast.Global) for n in node.names}
        self.names = {**outer, **{n: self.names[n] for n in kept if n in self.names}}
        return result

    def run(self, body: Sequence[ast.stmt]) -> None:
        for statement in body:
            self.steps += 1
            if self.steps > MAX_STEPS:
                self.note(statement.lineno, "the script takes more steps than cor follows; the rest is not read", True)
                raise Return
            if isinstance(statement, ast.Assign):
                value = self.value(statement.value)
                for target in statement.targets:
                    self.assign(target, value, statement.value)
            elif isinstance(statement, ast.AnnAssign) and statement.value is not None:
                self.assign(statement.target, self.value(statement.value), statement.value)
            elif isinstance(statement, ast.AugAssign):
                load = ast.parse(ast.unparse(statement.target), mode="eval").body
                old, new = self.value(load), self.value(statement.value)
                self.assign(statement.target, self.operate(statement.op, old, new), None)
            elif isinstance(statement, ast.Expr):
                self.value(statement.value)
            elif isinstance(statement, ast.FunctionDef):
                self.names[statement.name] = statement
            elif isinstance(statement, ast.If):
                self.branch(statement)
            elif isinstance(statement, (ast.For, ast.While)):
                self.loop(statement)
            elif isinstance(statement, (ast.Return, ast.Break, ast.Continue)):
                raise Return(*([self.value(statement.value)] if isinstance(statement, ast.Return) else []))
            elif isinstance(statement, (ast.With, ast.Try)):
                self.run(statement.body)
            elif isinstance(statement, ast.ImportFrom) and statement.module == "yade.params.table":
                self.names.update(self.params)
            elif isinstance(statement, ast.ImportFrom) and statement.module == "yade.params":
                self.names["table"] = Thing("table", 0)
            elif isinstance(statement, (ast.Import, ast.ImportFrom)):
                for alias in statement.names:
                    self.names.setdefault(alias.asname or alias.name, Thing(alias.name, 0, {"pi": math.pi}))

    def branch(self, statement: ast.If) -> None:
        test = self.value(statement.test)
        if test is not UNKNOWN:
            self.run(statement.body if test else statement.orelse)
            return
        before = dict(self.names)
        self.unsure += 1
        ends = []
        for body in (statement.body, statement.orelse):
            self.names = dict(before)
            try:
                self.run(body)
            except Return:
                pass
            ends.append(self.names)
        self.unsure -= 1
        self.names = {n: ends[0][n] if n in ends[0] and n in ends[1] and ends[0][n] is ends[1][n] else UNKNOWN
                      for n in {**ends[0], **ends[1]}}  # fmt: skip

    def loop(self, statement: Any) -> None:
        items: Any = range(1000) if isinstance(statement, ast.While) else self.items(statement.iter)
        certain = isinstance(items, (list, tuple, range)) and len(items) <= MAX_ITEMS
        for item in items if certain else [UNKNOWN]:
            if not certain or self.steps > MAX_STEPS // 2:  # one round with unknown values represents the others
                certain, item = False, UNKNOWN
                self.unsure += 1
                self.forget(statement)
            if isinstance(statement, ast.For):
                self.assign(statement.target, item, None)
            elif self.value(statement.test) in (UNKNOWN, False):
                break
            try:
                self.run(statement.body)
            except Return as end:
                if end.args or self.steps > MAX_STEPS:
                    raise
                break
            if not certain:
                break
        if not certain:
            self.unsure -= 1
            self.forget(statement)

    def forget(self, statement: ast.stmt) -> None:
        """Sets the names that a statement assigns to UNKNOWN."""
        for node in ast.walk(statement):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                self.names[node.id] = UNKNOWN

    def assign(self, target: ast.AST, value: Any, node: Optional[ast.AST]) -> None:
        if isinstance(target, ast.Name):
            self.names[target.id] = value
        elif isinstance(target, (ast.Tuple, ast.List)):
            known = isinstance(value, (list, tuple, range)) and len(value) == len(target.elts)
            for k, part in enumerate(target.elts):
                self.assign(part, value[k] if known else UNKNOWN, None)
        elif isinstance(target, ast.Attribute):
            of = self.value(target.value)
            if isinstance(of, Thing) and of.name in ("O", "Omega"):
                of.values[target.attr] = value
                if target.attr == "dt":
                    self.time_step = value
                    if value is UNKNOWN:
                        self.note(target.lineno, "the time step cannot be read as a number; give --time-step")
            elif isinstance(of, Thing):
                old = of.values.get(target.attr, value)
                if self.is_run and target.attr in _NUMBERS and old != value:
                    self.note(target.lineno, f"{of.name} changes {target.attr} here; cor uses only the last value")
                of.values[target.attr] = UNKNOWN if self.unsure else value
                if node is not None:
                    of.nodes[target.attr] = node
            elif target.attr in _NUMBERS:
                text = f"a number that is set outside of its constructor is not read: {target.attr}"
                self.note(target.lineno, text, True)


@dataclass(frozen=True)
class Placed:
    """A dictionary's value with its place in the text."""

    value: Any
    node: ast.AST


def number_of(value: Any) -> float:
    """Returns the value as a float; NaN if it is not a number."""
    return float(value) if isinstance(value, (int, float)) else NAN


def in_series(values: List[float]) -> float:
    """Returns the stiffness of two springs in series."""
    return values[0] * values[1] / sum(values) if sum(values) > 0 else NAN


def _pair(values: List[float]) -> float:
    """Returns a parameter of ViscElPhys from both materials in series. A material whose parameter is 0 is omitted."""
    inverse = sum(1 / v for v in values if v != 0)
    return 1 / inverse if inverse else 0.0


def young_of(material: Optional[Thing]) -> float:
    """Returns Young's modulus of a material."""
    return material.number("young", 1e9) if material else 1e7


def density_of(material: Optional[Thing]) -> float:
    """Returns the density of a material."""
    return material.number("density", 1000.0) if material else 1000.0


def parse(text: str, script: Script) -> ast.Module:
    """Returns the syntax tree. Lines that are not Python 3, such as print of Python 2, are omitted."""
    lines = text.expandtabs(8).split("\n")
    warnings.simplefilter("ignore", SyntaxWarning)
    for _ in range(80):
        try:
            return ast.parse("\n".join(lines))
        except SyntaxError as error:
            k = (error.lineno or 1) - 1
            if k >= len(lines) or lines[k].strip() in ("", "pass"):
                raise DeckError(f"line {k + 1}: this is not Python: {error.msg}") from None
            old_print = re.match(r"(\s*)print\s+(.*?)\s*$", lines[k])
            if old_print:
                lines[k] = f"{old_print[1]}print({old_print[2]})"
                continue
            if not re.match(r"\s*(print|exec)\b", lines[k]):
                script.note(k + 1, f"this line is not Python 3, and cor does not read it: {error.msg}", True)
            lines[k] = re.match(r"\s*", lines[k])[0] + "pass"  # type: ignore[index]
        except (RecursionError, MemoryError, ValueError) as error:
            raise DeckError(f"this Python cannot be read: {type(error).__name__}") from None
    raise DeckError("more than 40 lines are not Python 3")


class _Reader:
    def __init__(self, text: str, name: str, options: Options) -> None:
        self.text, self.name, self.options = text, name, options
        self.script = Script()
        self.deck = Deck(name, "yade")
        self.lines = text.expandtabs(8).split("\n")
        self.repairs: Dict[Tuple[int, int], Repair] = {}
        self.mixed: set[int] = set()  # materials whose numbers also affect contacts with other materials
        self.owners: List[Tuple[Contact, set[int]]] = []

    def read(self) -> Deck:
        if len(self.text) > MAX_TEXT:
            raise DeckError(f"cor reads scripts of Python up to {MAX_TEXT} characters; this one has {len(self.text)}")
        tree = parse(self.text, self.script)
        self.options.progress("following the script")
        try:
            self.script.run(tree.body)
        except Return:
            pass
        except RecursionError:
            raise DeckError("the script is nested too deeply") from None
        self.look_into_functions(tree)
        self.engines(tree)
        self.contacts()
        remarks = [Remark(self.name, line, text, matters) for (line, text), matters in self.script.remarks.items()]
        self.deck.remarks = sorted(remarks, key=lambda remark: remark.line)
        return self.deck

    def look_into_functions(self, tree: ast.Module) -> None:
        for node in ast.walk(tree):
            if isinstance(node, ast.Set) and isinstance(node.elts[0], ast.Set):  # {{WORD}}
                self.script.note(node.lineno, f"the template word {ast.unparse(node)} has no value here", True)
        functions = [f for f in ast.walk(tree) if isinstance(f, ast.FunctionDef)]
        for function in functions:
            for node in ast.walk(function) if function.name not in self.script.called else []:
                if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and node.attr in _NUMBERS:
                    text = f"the function {function.name} sets {node.attr}; cor does not read calls by YADE"
                    self.script.note(node.lineno, text, True)

    def engines(self, tree: ast.Module) -> None:
        things = self.script.things
        self.newton = next((t for t in reversed(things) if t.name == "NewtonIntegrator"), None)
        self.damping = self.newton.number("damping", 0.2) if self.newton else 0.0
        gravity = self.newton.values.get("gravity", ()) if self.newton else ()
        for thing in things:
            gravity = thing.values.get("gravity", gravity) if thing.name == "GravityEngine" else gravity
        known = isinstance(gravity, (tuple, list)) and len(gravity) == 3
        self.gravity = [number_of(g) for g in gravity] if known else [NAN] * 3
        self.losses = [f"{t.name} takes energy outside contacts." for t in things if t.name in _LOSSES]
        if any(getattr(node, "attr", "") in ("addF", "setPermF") for node in ast.walk(tree)):
            self.losses.append("The script adds forces by addF or setPermF, which eps does not include.")
        self.functors = [t for t in things if t.name.startswith("Ip2_")]
        self.step = number_of(self.script.time_step) if not any("TimeStepper" in t.name for t in things) else NAN

    # ---- pairs ----

    def contacts(self) -> None:
        """Adds the contacts of all bodies that can meet, or of all materials if the script has no spheres."""
        script, kinds = self.script, ("sphere", "facet", "wall", "box")
        loose = [t for t in script.things if t.name.endswith("Mat") and t not in script.materials]
        script.materials += loose
        for k, material in enumerate(script.materials):
            material.values.setdefault("label", f"material {k + 1}")
        merged: Dict[Tuple[Any, ...], Spheres] = {}
        for body in script.bodies:
            held = body.fixed and body.kind == "sphere"
            pull = str(self.gravity if body.axis is None else [abs(self.gravity[body.axis])])
            key = body.kind, id(body.material), held, body.clump, pull, str(body.mass), body.mask
            old = merged.setdefault(key, body)
            if old is not body:
                low, high = zip(old.radius, body.radius)
                nan = any(map(math.isnan, low + high))
                old.radius = (NAN, NAN) if nan else (min(low), max(high))
                old.count += body.count
        found = sorted(merged.values(), key=lambda b: kinds.index(b.kind))
        if not any(b.kind == "sphere" for b in found):
            if not script.materials and re.search(r"\bbodies\.(append|insert)", self.text):
                found.append(Spheres("sphere", None, clump="appendClumped" in self.text))
            elif self.functors and not script.materials:  # the bodies are in another file
                unread = {"label": "material of another file", "young": NAN, "poisson": NAN, "density": NAN}
                script.materials.append(Thing(self.functors[0].name.split("_")[1], self.functors[0].line, unread))
            of_walls = [b.material for b in found] if len(script.materials) > 1 else []
            found = [Spheres("sphere", m) for m in script.materials if m not in of_walls] + found
        count = sum(b.count for b in found if b.kind == "sphere")
        lonely = count == 1 and any(b.kind != "sphere" for b in found)
        spheres = [b for b in found if b.kind == "sphere"]
        for i, one in enumerate(spheres):
            partners = [] if lonely else spheres[i:]
            for two in partners + [two for two in found if two.kind != "sphere"]:
                moves = not (one.fixed and (two.fixed or two.kind != "sphere"))
                meets_itself = one.count > 1 or count == 1 or not one.fixed
                if moves and (one is not two or meets_itself) and one.mask & two.mask:
                    self.contact(one, two)
                elif moves and not one.mask & two.mask:
                    script.note(1, "Bodies whose masks have no common bit do not interact.")
        for c, materials in self.owners:
            if self.mixed & materials:
                c.slots = ()  # other contacts share the number, so no new one is proposed
        for functor in self.functors:
            self.strange_matches(functor)

    def can_meet(self, one: Spheres, two: Spheres) -> bool:
        """False, with a remark, if the script has Bo1 or Ig2 functors, but not the ones that this contact needs."""
        words, kinds = [t.name.split("_") for t in self.script.things], [one.kind.capitalize(), two.kind.capitalize()]
        pairs, bounds = ([w[1:3] for w in words if w[0] == name] for name in ("Ig2", "Bo1"))
        lost = {f"Bo1_{kind}_Aabb" for kind in kinds if bounds and kind not in [w[0] for w in bounds]}
        if pairs and kinds not in pairs and kinds[::-1] not in pairs:
            lost.add(f"Ig2_{kinds[1]}_{kinds[0]}_ScGeom")
        if lost:
            text = f"a {one.kind} and a {two.kind} do not interact: the script has no {' and no '.join(sorted(lost))}"
            self.script.note(self.functors[-1].line if self.functors else 1, text)
        return not lost

    def body(self, b: Spheres, partner: Spheres) -> Body:
        material = b.material
        label = str(material.values.get("label", material.name)) if material else "default material"
        label += ", clump" if b.clump else ""
        name = label if b.kind == "sphere" else f"{b.kind} of {label}"
        get = self.options.radii.get
        of = b if b.kind == "sphere" else partner
        radii = [get(label, get("", NAN)) if math.isnan(r) else r for r in of.radius]
        times = 2 if b.kind == "facet" else 1
        return Body(
            name + (", fixed" if b.fixed and b.kind == "sphere" else ""), (times * radii[0], times * radii[1]),
            density_of(material), None, young_of(material), material.number("poisson", 0.25) if material else 0.3,
            b.kind != "sphere", b.fixed and b.kind == "sphere",
        )  # fmt: skip

    def contact(self, one: Spheres, two: Spheres) -> None:
        if not self.can_meet(one, two):
            return
        wall = two.kind != "sphere"
        line = one.material.line if one.material else 0
        bodies = self.body(one, two), self.body(two, one)
        bodies = bodies[::-1] if one.fixed else bodies
        c = Contact(self.name, line, "yade", bodies, losses=list(self.losses), time_step=self.step)
        if wall:
            pull = [abs(g) for g in self.gravity]
            c.gravity = pull[two.axis] if two.axis is not None else math.sqrt(sum(g * g for g in pull))
        self.set_model(c, one, two)
        self.owners.append((c, {id(one.material), id(two.material)}))
        if (one.clump or two.clump) and c.number == c.bond == 0 and c.luding is None:  # elastic at each mass
            c.notes.append("The contact has no damping: eps holds for impacts through the centres of the clumps.")
            first, second = c.bodies
            second = second if second.wall else replace(second, mass=(NAN, NAN))
            c.bodies = replace(first, mass=(NAN, NAN)), second
        elif one.clump or two.clump:
            c.unknown = c.unknown or "A clump rebounds with its own mass and shape, not with the sphere's."
        if math.isnan(self.damping):
            c.unknown = c.unknown or "The damping of NewtonIntegrator cannot be read as a number."
        c.global_damping = 0.0 if math.isnan(self.damping) else self.damping
        self.deck.contacts.append(c)

    def set_model(self, c: Contact, one: Spheres, two: Spheres) -> None:
        """Sets model, number and spring from the materials' classes and the script's functors."""
        a, b = one.material, two.material
        names = [m.name if m else "FrictMat" for m in (a, b)]

        def fits(functor: Thing, pair: List[str]) -> bool:
            return all(n in (of, "FrictMat") for n, of in zip(functor.name.split("_")[1:3], pair))

        suits = [t for t in self.functors if fits(t, names) or fits(t, names[::-1])]
        exact = [t for t in suits if t.name.split("_")[1:3] in (names, names[::-1])]
        functor = (exact or suits or [None])[-1]  # type: ignore[list-item]
        if functor is not None and not a:
            c.line = functor.line
        if functor is not None and functor not in exact and not set(names) <= set(_MATERIALS.split()):
            c.style = "-".join(names)
            c.unknown = f"cor does not know the materials {' and '.join(dict.fromkeys(names))}."
        elif names == ["ViscElMat"] * 2 and (functor is None or functor.name.endswith("_ViscElPhys")) and a and b:
            self.set_viscoelastic(c, one, two, functor)
        elif functor is not None and functor.name == "Ip2_FrictMat_FrictMat_MindlinPhys":
            self.set_mindlin(c, functor, a, b)
        elif functor is not None and functor.name in _FRICTIONAL:
            c.model, c.number, c.spring, c.line = "YADE_KN_CN", 0.0, Spring.HOOKE, functor.line
            c.style, strengths = _FRICTIONAL[functor.name]
            c.stiffness, shear = self.springs(c)
            if not strengths:
                c.tangential = Tangential("cundall-strack", shear, 0.0, self.friction(functor, a, b))
            self.set_bonds(c, functor, strengths, a, b)
        elif functor is not None and functor.name == "Ip2_LudingMat_LudingMat_LudingPhys" and a and b:
            numbers = [_pair([m.number(key) for m in (a, b)]) * 2 for key in ("k1", "kp", "kc", "G0", "PhiF")]
            c.model, c.number, c.spring, c.style = "YADE_KN_CN", 0.0, Spring.HOOKE, "LudingPhys"
            c.stiffness, c.luding = numbers[0], tuple(numbers)
            c.notes.append("eps includes plastic overlap, adhesion and all damping, but no error of the time step.")
            if numbers[0] >= numbers[1]:
                c.refused = "YADE stops with an error: k1 must be below kp."
            elif not all(n >= 0 for n in numbers):
                c.unknown = "k1, kp, kc, G0 or PhiF of its material is negative, or not a constant."
        elif functor is not None and functor.name == "Ip2_CpmMat_CpmMat_CpmPhys":
            self.set_concrete(c, functor, a, b)
        elif functor is None:
            c.style = "-".join(names)
            c.unknown = f"The script has no Ip2 functor for {' and '.join(dict.fromkeys(names))}."
        else:
            c.style = functor.name
            c.unknown = f"cor does not support the contact of {' and '.join(dict.fromkeys(names))} by {functor.name}."
        laws = [t.name for t in self.script.things if t.name.startswith("Law2_")]
        physics = functor.name.rpartition("_")[2] if functor is not None and laws and c.model else ""
        laws = [law for law in laws if f"_{physics}_" in law]
        if physics and not laws:
            c.unknown = c.unknown or f"The script has no Law2 functor for {physics}."
        elif physics and laws[-1].rpartition("_")[2] not in _LAWS:
            c.unknown = c.unknown or f"cor does not support the law {laws[-1]}."
        elif physics == "MindlinPhys" and not laws[-1].endswith("_Mindlin"):
            c.notes.append(f"{laws[-1]} ignores the damping.")
            c.zeta_factor, c.number = 0.0, 0.0 if c.model == "YADE_BETAN" else c.number
            c.tangential = Tangential(f"cor has no model of {laws[-1]}")

    def set_bonds(self, c: Contact, functor: Thing, strengths: Sequence[str], *materials: Optional[Thing]) -> None:
        """Refuses contacts with a bond that can pull. Bonds that form only in the first steps are noted."""
        numbers = [[m.number(key, -1) if m else -1 for m in materials] for key in strengths]  # YADE takes the least one
        strong = any(key in functor.values for key in strengths) or any(0 not in n or min(n) < 0 for n in numbers)
        if strong and all(m and m.values.get("isCohesive") is not False for m in materials):
            new, now = (functor.values.get(f"setCohesion{when}", False) for when in ("OnNewContacts", "Now"))
            first = functor.values.get("cohesiveTresholdIteration", 1)
            cohesion = [m.number("normalCohesion") if m else NAN for m in materials]
            c.bond = min(cohesion) + 0 * sum(cohesion)  # NaN if one is
            fragile = all(m and m.values.get("fragile", True) is True for m in materials)
            if new is True and fragile and "normalCohesion" in strengths and "normalCohesion" not in functor.values:
                c.notes.append("eps holds for contacts that begin without a bond; each of them makes a bond.")
                c.unknown = "" if c.bond >= 0 else "normalCohesion of a material is negative or not a constant."
            elif new is not False or not isinstance(first, (int, float)) or not 0 <= first <= 10:
                c.unknown = "The cohesion changes eps."
            elif now is not False or "cohesion" in strengths:
                c.notes.append("eps holds for contacts whose bond is broken or absent.")
            c.bond = c.bond if new is True else 0.0

    def set_concrete(self, c: Contact, functor: Thing, a: Optional[Thing], b: Optional[Thing]) -> None:
        """Sets the spring of CpmPhys without a bond. Bonds of only the first steps do not act later."""
        c.model, c.number, c.spring, c.style, c.line = "YADE_KN_CN", 0.0, Spring.HOOKE, "CpmPhys", functor.line
        radii = [body.radius[0] for body in c.bodies]
        length = radii[0] if c.bodies[1].wall else sum(radii)
        c.stiffness = math.pi * min(self.radii(c)) ** 2 * sum(body.young for body in c.bodies) / 2 / length
        law = next((t for t in reversed(self.script.things) if t.name == "Law2_ScGeom_CpmPhys_Cpm"), None)
        soft = law is not None and not law.number("epsSoft", 1.0) >= 0
        c.notes.append("eps holds for contacts whose bond is broken or absent.")
        if not 0 <= functor.number("cohesiveThresholdIter", 10) <= 10:
            c.unknown = "The cohesion changes eps."
        elif soft or "E" in functor.values or any(m is None or m.number("isoPrestress", 0.0) != 0 for m in (a, b)):
            c.unknown = "cor does not support epsSoft, isoPrestress, or E of the functor."

    def set_mindlin(self, c: Contact, functor: Thing, a: Optional[Thing], b: Optional[Thing]) -> None:
        c.line, c.spring, c.number = functor.line, Spring.MATERIAL, 0.0
        key = next((name for name in ("en", "es") if name in functor.values), "betan")
        c.model = "YADE_BETAN" if key == "betan" else "YADE_EN"
        if key in functor.values:
            self.set_number(c, functor, key, a, b)
        if "en" in functor.values and "betan" in functor.values:
            c.unknown = "The functor has both en and betan; cor supports one of them."
        elif "vn" in functor.values:
            c.model = "YADE_EN_VN"
            c.unknown = "" if functor.number("vn") == 1 else "The en holds at the speed vn; cor supports only vn = 1."
        elif "gamma" in functor.values:
            c.unknown = "The adhesion changes eps."
        one, two = c.bodies
        spring = 2 / 7 * lib.cor_tangential_kappa(one.young, one.poisson, two.young, two.poisson)
        name, numbers, shear = "hertz-mindlin", [c.number, c.number], "betas" if key == "betan" else "es"
        if shear in functor.values:
            numbers[0] = number_of(self.value_of(functor, shear, a, b)[0])
        if key != "betan":
            numbers = [lib.cor_simulator_model(lib.COR_YADE_EN).damping_of_e(e) for e in numbers]
        ratio = 1.0 if "vn" in functor.values else share(*numbers) * math.sqrt(spring / 1.5)
        if 0 < lib.cor_simulator_version(self.options.version.encode()) < 20230200:
            name = "before 2023.02 YADE had another tangential force"
        elif any(given in functor.values for given in ("krot", "ktwist", "eta")):
            name = ROLLS
        c.tangential = Tangential(name, spring, ratio, self.friction(functor, a, b))

    def set_number(self, c: Contact, thing: Thing, key: str, a: Optional[Thing], b: Optional[Thing]) -> None:
        """Sets number and place of a contact from a keyword."""
        value, node = self.value_of(thing, key, a, b)
        c.number = number_of(value)
        if math.isnan(c.number):
            known = isinstance(thing.values[key], Thing)
            c.unknown = "MatchMaker has no value for this pair; val counts only with algo='val'." if known else ""
            c.unknown = c.unknown or f"{key} of {thing.name} cannot be read as a number."
        elif node is not None and hasattr(node, "lineno"):
            self.place(c, node)

    def value_of(self, thing: Thing, key: str, a: Optional[Thing], b: Optional[Thing]) -> Tuple[Any, Any]:
        """Returns value and node of a keyword, which may be a MatchMaker."""
        value, node = thing.values[key], thing.nodes.get(key)
        return self.match(value, a, b) if isinstance(value, Thing) and value.name == "MatchMaker" else (value, node)

    def friction(self, functor: Optional[Thing], a: Optional[Thing], b: Optional[Thing]) -> float:
        """Returns the coefficient of friction, from the functor's angle or from the smaller angle of both materials."""
        if functor is not None and "frictAngle" in functor.values:
            return math.tan(number_of(self.value_of(functor, "frictAngle", a, b)[0]))
        angles = [m.number("frictionAngle", 0.5) if m else 0.5 for m in (a, b)]
        return math.tan(min(angles) + 0 * sum(angles))  # NaN if one is

    def springs(self, c: Contact) -> Tuple[float, float]:
        """Returns the normal stiffness from Young's moduli, and the ratio of the tangential stiffness to it."""
        single = [2 * body.young * r for body, r in zip(c.bodies, self.radii(c))]
        shear = [k * body.poisson for k, body in zip(single, c.bodies)]
        return in_series(single), share(in_series(shear), in_series(single))

    def match(self, maker: Thing, a: Optional[Thing], b: Optional[Thing]) -> Tuple[Any, Optional[ast.AST]]:
        known = self.script.materials
        ids = [[known.index(m), m.values.get("label")] if m in known else [] for m in (a, b)]
        for (i, j, value), node in self.matches(maker):
            if (i in ids[0] and j in ids[1]) or (i in ids[1] and j in ids[0]):
                return value, node
        if maker.arguments and isinstance(maker.arguments[0], (int, float)):
            return maker.arguments[0], None
        if maker.values.get("algo") != "val":  # YADE stops at the first such contact
            return UNKNOWN, None
        return maker.values.get("val", UNKNOWN), maker.nodes.get("val")

    def matches(self, maker: Thing) -> List[Tuple[Tuple[Any, Any, Any], Optional[ast.AST]]]:
        listed = maker.values.get("matches", maker.arguments[0] if maker.arguments else ())
        node = maker.nodes.get("matches")
        if not isinstance(listed, (list, tuple)):
            return []
        made = []
        for k, match in enumerate(listed):
            elements = getattr(node, "elts", None)
            inner = getattr(elements[k], "elts", None) if elements and len(elements) == len(listed) else None
            if isinstance(match, (list, tuple)) and len(match) == 3:
                made.append(((match[0], match[1], match[2]), inner[2] if inner else None))
        return made

    def strange_matches(self, functor: Thing) -> None:
        """Adds the pairs of a MatchMaker whose materials are not in the text. Bodies are named by material numbers."""
        maker = functor.values.get("en")
        if not (isinstance(maker, Thing) and maker.name == "MatchMaker" and functor.name.endswith("MindlinPhys")):
            return
        count = len(self.script.materials)
        for (i, j, value), node in self.matches(maker):
            if not all(isinstance(n, int) for n in (i, j)) or (i < count and j < count):
                continue
            c = Contact(self.name, functor.line, "yade", (Body(str(i)), Body(str(j))), "YADE_EN")
            c.number, c.global_damping = number_of(value), self.damping
            if node is not None:
                self.place(c, node)
            self.deck.contacts.append(c)

    def set_viscoelastic(self, c: Contact, one: Spheres, two: Spheres, functor: Optional[Thing]) -> None:
        a, b = one.material, two.material
        assert a is not None and b is not None
        c.line = a.line
        own = functor.values if functor else {}
        given = [set(own) | set(m.values) for m in (a, b)]
        by_time = all({"tc", "en"} <= g for g in given)
        by_young = not by_time and all("en" in g and "kn" not in g for g in given)
        keys = ("en", "tc") if by_time else ("en",) if by_young else ("cn", "kn")
        c.model = "YADE_TC_EN" if by_time else "YADE_YOUNG_EN" if by_young else "YADE_KN_CN"
        if by_time and "kn" in a.values:
            c.unknown = "The material has both tc and kn; cor supports one of them."
        numbers = []
        for key in keys:
            values = [m.number(key) for m in (a, b)]
            if key in own and functor is not None:
                self.set_number(c, functor, key, a, b)
                numbers.append(c.number)
            elif by_time:
                numbers.append(sum(values) / 2)
            else:
                numbers.append(_pair(values))
        c.number = numbers[0] if by_time or keys[0] in own else 2 * numbers[0]
        c.spring = Spring.CONTACT_TIME if by_time else Spring.HOOKE
        c.stiffness, shear = self.springs(c) if by_young else (numbers[1], NAN)
        c.tangential = self.viscoelastic(c, (a, b), functor, numbers, shear)
        if any(math.isnan(n) for n in numbers):
            lost = sorted({k for m in (a, b) for k in keys if k not in own and math.isnan(m.number(k))})
            has = [k for k in lost if k in a.values or k in b.values]
            state = f"{' and '.join(has)} is not a constant" if has else f"{' and '.join(lost)} is missing"
            c.unknown = f"Its material is incomplete: {state}." if lost else "Its damping could not be read."
        elif keys[0] not in own and a.nodes.get(keys[0]) is b.nodes.get(keys[0]) is not None:
            self.place(c, a.nodes[keys[0]])
        elif keys[0] not in own and a is not b:
            self.mixed |= {id(a), id(b)}
        if by_time or by_young:
            self.set_mass(c, one, two)

    def viscoelastic(
        self, c: Contact, both: Tuple[Thing, Thing], functor: Optional[Thing], numbers: List[float], shear: float
    ) -> Tangential:
        """Returns the tangential force of ViscElPhys. numbers: en and tc, or cn and kn."""
        own, key = functor.values if functor else {}, "et" if c.spring is Spring.CONTACT_TIME else "ks"
        ratio, friction = 0.0, self.friction(functor, *both)
        if any(m.number("mR", 0.0) != 0 for m in both):
            return Tangential(ROLLS)
        if key == "et":
            e_t = sum(m.number(key) for m in both) / 2
            e_t = number_of(self.value_of(functor, key, *both)[0]) if functor and key in own else e_t
            return by_restitution("viscel", numbers[0], e_t, friction)
        if len(numbers) == 2:
            shear, damper = (_pair([m.number(k) for m in both]) for k in ("ks", "cs"))
            shear, ratio = share(shear, numbers[1]), share(damper, numbers[0])
        return Tangential("viscel", shear, ratio, friction)

    def radii(self, c: Contact) -> List[float]:
        """Returns radii for YADE's stiffnesses. A facet has twice the radius of the sphere, a wall the same radius."""
        return [b.radius[0] for b in c.bodies]

    def set_mass(self, c: Contact, one: Spheres, two: Spheres) -> None:
        """Sets zeta_factor for tc and en: YADE's damping uses m m'/(m + m') with m' of any partner, walls included."""
        if two.kind == "sphere" and not (one.fixed or two.fixed):
            return
        if two.kind in ("wall", "facet"):
            c.zeta_factor = math.sqrt(0.5)
            c.notes.append("At a wall or facet YADE halves kn and cn.")
            return
        masses = [4 * math.pi / 3 * x.radius[0] ** 3 * density_of(x.material) for x in (one, two)]
        if two.kind == "box":
            masses[1] = two.mass * density_of(two.material) or masses[0]
        moving = masses[1] if one.fixed else masses[0] if two.fixed else masses[0] * masses[1] / (masses[0] + masses[1])
        c.zeta_factor = math.sqrt(masses[0] * masses[1] / (masses[0] + masses[1]) / moving)
        if math.isnan(c.zeta_factor):
            c.zeta_factor = 1.0
            c.unknown = c.unknown or "YADE's damping depends on the mass of the fixed body, which could not be read."
        else:
            c.notes.append("YADE computes kn and cn with the mass of the fixed body, which does not move.")

    def place(self, c: Contact, node: Any) -> None:
        """Sets repair and slot of a contact whose number is at a node."""
        key = node.lineno, node.end_lineno
        lines = self.lines[key[0] - 1 : key[1]]
        repair = self.repairs.setdefault(key, Repair(self.name, *key, "\n".join(lines)))

        def at(line: int, column: int) -> int:
            before = sum(len(s) + 1 for s in lines[: line - key[0]])
            coded = lines[line - key[0]].encode("utf-8", "surrogateescape")[:column]
            return before + len(coded.decode("utf-8", "ignore"))

        c.repair = repair
        c.slots = ((at(node.lineno, node.col_offset), at(node.end_lineno, node.end_col_offset)),)


def read(text: str, name: str, options: Options) -> Deck:
    """Reads a YADE script."""
    return _Reader(text, name, options).read()
