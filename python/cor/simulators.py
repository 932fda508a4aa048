# SPDX-License-Identifier: MIT
"""Computes contacts in simulators: lines for inputs, the realised restitution, the audit of an input, and the error of
a time step. The functions correspond to cor/scene.h, corgen contact and cor audit.

An argument `contact` is a cor.Contact. It can also be a cor.Body, a pair of them or None; keywords of cor.Contact then
describe the rest of the contact.
"""

import math
import os
import re
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ._contact import Contact, option_number, raise_text
from ._cor import ffi, lib
from ._evaluate import like, number, one_of, string
from .contact import Body, sphere_mass_kg

_Bodies = Union[Contact, Body, Tuple[Body, Body], None]
_INTEGRATORS = [string(lib.cor_integrator_names[i]) for i in range(lib.COR_INTEGRATORS)]
_VERLET = _INTEGRATORS[lib.COR_VERLET_HALF_STEP]


def _contact(contact: _Bodies, scene: "dict[str, Any]") -> Contact:
    if not isinstance(contact, Contact):
        return Contact(*(() if contact is None else (contact,) if isinstance(contact, Body) else contact), **scene)
    if scene:
        raise TypeError(f"{', '.join(scene)}: a cor.Contact already has them; give bodies and keywords instead")
    return contact


def _positive(**given: Optional[float]) -> None:
    for name, value in given.items():
        if value is not None and not 0 < number(name, value) < math.inf:
            raise ValueError(f"{name}: {value} is not above 0 and finite")


def _speeds(speeds: ArrayLike) -> Tuple[Any, Any]:
    array = np.array(speeds, np.float64, ndmin=1).ravel()
    wrong = array[~((array > 0) & np.isfinite(array))]
    if wrong.size:
        raise ValueError(f"speeds: {wrong[0]} is not above 0 and finite")
    return array, ffi.from_buffer("double[]", array)


def _text(argument: str, value: object) -> bytes:
    if "\0" in str(value):
        raise ValueError(f"{argument}: {value!r} has a null character")
    return str(value).encode()


def _version(version: Optional[str]) -> Any:
    if version is not None and lib.cor_simulator_version(_text("version", version)) == 0:
        raise ValueError(f"version: {version!r} is not a version such as '29 Sep 2021' or '3.8.1'")
    return ffi.NULL if version is None else ffi.new("char[]", version.encode())


_IDS = ffi.typeof("enum cor_simulator_model_id").elements
_SIMULATORS = [lib.cor_simulators[i] for i in range(lib.cor_simulator_count)]


def names() -> List[str]:
    """Returns the names of the simulators that lines() supports."""
    return [string(s.name) for s in _SIMULATORS if s.comment != ffi.NULL]


def models(simulator: str) -> Dict[str, str]:
    """Returns the contact models of a simulator: their names, keyed by id."""
    found = [s for s in _SIMULATORS if string(s.name) == str(simulator).lower()]
    known = found[0] if found else lib.cor_simulator_named(_text("simulator", simulator))
    if known == ffi.NULL:
        raise ValueError(f"simulator: {simulator!r}; allowed: {', '.join(string(s.name) for s in _SIMULATORS)}")
    rows = [known.models[k] for k in range(known.model_count)]
    return {_IDS[m.id][len("COR_") :].lower(): string(m.model) for m in rows}


def realised(simulator: str, model: str, e: ArrayLike) -> Any:
    """Returns the restitution that a simulator's model gives for the input e in the limit of small time steps
    (cor_simulator_realised). NaN if the model has no input e, or refuses this value. model: an id of
    models(simulator), with or without the name of the simulator."""
    allowed = models(simulator)
    asked, prefix = (re.sub("[- ]", "_", str(name).lower()) for name in (model, simulator))
    found = asked if asked in allowed else f"{prefix}_{asked}"
    if found not in allowed:
        raise ValueError(f"model: {model!r} is not a model of {simulator}; allowed: {', '.join(allowed)}")
    row, given = lib.cor_simulator_model(getattr(lib, f"COR_{found.upper()}")), np.asarray(e, np.float64)
    result = np.array([lib.cor_simulator_realised(row, x) for x in given.ravel()]).reshape(given.shape)
    return like([e], result[()])


# Columns of numbers, each with the argument of cor.Contact that has the same range
_MATERIAL = {"young_pa": "young", "poisson": "poisson", "density_kg_m3": "density", "radius_m": "radius", "wall": ""}
_MATERIAL.update(radius_max_m="radius", dissipation_time_s="dissipation_time")
_PAIR = {"restitution": "restitution", "at_m_s": "at", "friction": "zeta"}


def _row(argument: str, row: Mapping[str, Any], texts: Tuple[str, ...], numbers: Dict[str, str]) -> Dict[str, Any]:
    """Returns the cells of a row of materials or pairs. Numbers that are not given are NaN."""
    cells: Dict[str, Any] = {**dict.fromkeys(texts, ""), **dict.fromkeys(numbers, math.nan)}
    for column, given in row.items():
        if column not in cells:
            raise ValueError(f"{argument}: the column {column!r} is unknown; allowed: {', '.join(cells)}")
        if given is None or given == "":
            continue
        try:
            cells[column] = float(given) if column in numbers else str(given)
        except ValueError as error:
            raise ValueError(f"{argument}: {column}: {error}") from None
        if numbers.get(column) and not math.isnan(cells[column]):
            option_number(numbers[column], cells[column], f"{argument}: {column}")
    return cells


def _many(request: Any, materials: Sequence[Mapping[str, Any]], pairs: Sequence[Mapping[str, Any]]) -> List[Any]:
    """Puts several materials into a request. Returns objects that must live as long as the request."""
    rows = [_row("materials", row, ("name", "made_of"), _MATERIAL) for row in materials]
    names = [row["name"] for row in rows]
    texts = [ffi.new("char[]", _text("materials", text)) for text in names + [row["made_of"] for row in rows]]
    made, measured = ffi.new("struct cor_material[]", len(rows) + 1), []
    for k, row in enumerate(rows):
        if row["wall"] not in (0, 1) and not math.isnan(row["wall"]):
            raise ValueError(f"materials: {row['name']}: wall is not 0, 1 or empty")
        wall = row["wall"] == 1
        radius = math.inf if wall and math.isnan(row["radius_m"]) else row["radius_m"]
        mass = math.inf if wall else float(sphere_mass_kg(radius, row["density_kg_m3"]))
        body = (row["young_pa"], row["poisson"], row["dissipation_time_s"], radius, mass)
        source = texts[len(rows) + k] if row["made_of"] else ffi.NULL
        made[k] = (texts[k], body, row["radius_max_m"], source)
    for row in [_row("pairs", row, ("a", "b", "end"), _PAIR) for row in pairs]:
        if row["a"] not in names or row["b"] not in names:
            raise ValueError(f"pairs: {row['a']}, {row['b']}: a and b must be two names of materials")
        end = one_of("pairs: end", row["end"], ("zero_overlap", "zero_force")) if row["end"] else lib.COR_BOTH_ENDS
        numbers = row["restitution"], row["at_m_s"], end, row["friction"]
        measured.append((names.index(row["a"]), names.index(row["b"]), *numbers))
    request.material_count, request.pair_count = len(rows), len(measured)
    of_pairs = ffi.new("struct cor_material_pair[]", measured or 1)
    memory = ffi.new("struct cor_material_contact[]", len(rows) ** 2 + 1)
    request.materials, request.pairs, request.memory = made, of_pairs, memory
    return [made, texts, of_pairs, memory]


def lines(
    simulator: str,
    contact: _Bodies = None,
    *,
    materials: Optional[Sequence[Mapping[str, Any]]] = None,
    pairs: Sequence[Mapping[str, Any]] = (),
    friction: float = 0.0,
    speeds: ArrayLike = (),
    version: Optional[str] = None,
    time_step: Optional[float] = None,
    steps: Optional[float] = None,
    step_tolerance: Optional[float] = None,
    step_corrected: bool = False,
    **scene: Any,
) -> str:
    """Returns the input lines with which a simulator realises a contact, as printed by corgen contact --for. Raises
    ValueError if the simulator cannot realise it. speeds: impact speeds, m/s, at which the lines state eps.

    materials: in place of a contact, rows with the columns of corgen contact --materials, for example from
    csv.DictReader. pairs: rows of measured pairs. friction: the coefficient of all other pairs. With materials, speeds
    are required, and the other keywords are law, elastic, damping and end."""
    request = ffi.new("struct cor_simulator_request *")
    if materials is None and friction:
        raise TypeError("friction: allowed only with materials; give materials, or leave out friction")
    if materials is None:
        made = _contact(contact, scene)
    elif contact is not None or set(scene) - {"law", "elastic", "damping", "end"} or not np.size(speeds):
        raise TypeError("materials: give only speeds, law, elastic, damping and end, and no contact")
    else:
        made = Contact(restitution=0.5, at=1.0, **scene)  # supplies law and end; its numbers are reset
        made._scene.number = [math.nan] * lib.COR_SCENE_NUMBERS
        kept = _many(request, materials, pairs)  # noqa: F841
    _positive(time_step=time_step, steps=steps, step_tolerance=step_tolerance)
    name, array, values = ffi.new("char[]", _text("simulator", simulator)), *_speeds(speeds)
    version_text = _version(version)
    request.simulator, request.version = name, version_text
    request.scene, request.contacts, request.count = made._scene, made._contacts, made._count
    request.speed_m_s, request.speeds = values, array.size
    request.time_step_s, request.steps = time_step or 0, steps or 0
    request.step_tolerance, request.step_corrected = step_tolerance or 0, step_corrected
    request.friction = float(number("friction", friction))
    if not 0 <= request.friction < math.inf:
        raise ValueError(f"friction: {friction} is not a finite number, 0 or more")
    request.step_errors = time_step is not None or steps is not None
    request.integrator = lib.COR_NO_INTEGRATOR
    text = ffi.new("char[]", lib.COR_SIMULATOR_REASON)
    length = lib.cor_simulator_lines(text, len(text), request)
    if length < 0:
        raise_text(text)
    text = ffi.new("char[]", length + 1)
    lib.cor_simulator_lines(text, len(text), request)
    return string(text)


_STEP_ERROR = [name for name, _ in ffi.typeof("struct cor_step_error").fields]


def step_error(
    contact: _Bodies,
    speed: ArrayLike,
    steps: Optional[ArrayLike] = None,
    *,
    integrator: Optional[str] = None,
    **scene: Any,
) -> Any:
    """Returns the error of eps that a time step causes, as a record or an array of records (cor_scene_step_error). Its
    fields are the mean of the error over all phases of the first step (bias), the standard deviation (scatter), least
    and most. They are NaN if the motion leaves the range of doubles, or needs too many steps.

    speed: m/s. steps: time steps in the duration of a contact without damping at this speed. With erp and cfm the
    default follows from time_step. integrator: by default implicit-euler with erp and cfm, otherwise
    verlet-half-step."""
    made = _contact(contact, scene)
    own = made._options["time_step"]
    method = one_of("integrator", integrator or ("implicit-euler" if own else _VERLET), _INTEGRATORS)
    if steps is None and not own:
        raise TypeError("steps: a number is needed, except for a contact of erp and cfm")
    if steps is None:
        steps = lib.cor_scene_elastic_duration_s(made._contacts, 1.0) / own
    at, count = np.broadcast_arrays(np.asarray(speed, np.float64), np.asarray(steps, np.float64))
    for argument, given in (("speed", at), ("steps", count)):
        if not (np.all(given > 0) and np.all(np.isfinite(given))):
            raise ValueError(f"{argument}: it is not above 0 and finite")
    one = ffi.new("struct cor_step_error *")
    rows = []
    for g, n in zip(at.ravel(), count.ravel()):
        status = lib.cor_scene_step_error(one, ffi.addressof(made._one()), g, made._end(), n, method)
        rows.append(tuple(getattr(one, field) if status == 0 else math.nan for field in _STEP_ERROR))
    table = np.array(rows, [(field, np.float64) for field in _STEP_ERROR]).reshape(at.shape)
    return table.view(np.recarray)[()]


class Finding(NamedTuple):
    """One contact at one speed as an audit finds it, or, if model is "", a remark on a line."""

    file: str
    line: int
    simulator: str
    model: str
    pair: str
    asked: float  # NaN: the text gives a damping number
    end: str  # "": unknown
    speed_m_s: float  # NaN: every speed
    realised: float
    duration_s: float
    time_step_s: float
    step_bias: float
    step_scatter: float
    as_asked: Optional[bool]  # None: no e was requested, or eps is unknown
    advice: str
    instead: str


def audit(
    text: Union[str, "os.PathLike[str]"],
    *,
    simulator: Optional[str] = None,
    version: Optional[str] = None,
    speeds: ArrayLike = (),
    radius: Optional[float] = None,
    density: Optional[float] = None,
    time_step: Optional[float] = None,
    tolerance: float = 0.01,
    include: Optional[Callable[[str, str], Optional[str]]] = None,
) -> List[Finding]:
    """Computes the restitution that each contact in a simulator's input really gives, like the command cor audit. text:
    the input as a str, or its path as a pathlib.Path. include(name, of): returns the text of the file `name` that the
    file `of` includes, or None. Raises ValueError for an input without contacts."""
    from ._audit import physics
    from ._audit.deck import MAX_BYTES, DeckError, Options
    from ._command import read_text

    _positive(radius=radius, density=density, time_step=time_step, tolerance=tolerance)
    name = os.fspath(text) if isinstance(text, os.PathLike) else "text"
    if isinstance(text, os.PathLike):
        text = read_text(name, MAX_BYTES)
    if not isinstance(text, str):
        raise TypeError(f"text: a str or a path is needed, not {type(text).__name__}")
    if "\0" in text:
        raise ValueError("text: it contains a zero byte")
    if simulator is not None:
        simulator = sorted(physics.SIMULATORS)[one_of("simulator", simulator, sorted(physics.SIMULATORS))]
    _version(version)

    failed: List[Exception] = []

    def included(name: str, of: str) -> Optional[Tuple[str, str]]:
        try:
            found = None if include is None else include(name, of)
            if found is not None and not isinstance(found, str):
                raise TypeError(f"include: a str is needed, not {type(found).__name__}")
        except Exception as error:
            failed.append(error)
            raise
        return None if found is None else (found, name)

    numbers = {"radii": {"": radius}, "densities": {"": density}}
    given: Dict[str, Any] = {key: {k: v for k, v in value.items() if v} for key, value in numbers.items()}
    options = Options(
        simulator or "", version or "", tuple(map(float, _speeds(speeds)[0])), given["radii"], given["densities"],
        time_step=time_step or math.nan, tolerance=tolerance, include=included,
    )  # fmt: skip
    try:
        rows = physics.audit_text(text, name, options)
    except DeckError:
        if failed:
            raise failed[0] from None
        raise
    if not any(row.model for row in rows):
        why = "; ".join(f"line {row.line}: {row.advice}" for row in rows)
        raise ValueError(f"text: found no contact{'; ' if why else ''}{why}")
    return [Finding(*(getattr(row, name) for name in Finding._fields)) for row in rows]


__all__ = ["Finding", "audit", "lines", "models", "names", "realised", "step_error"]


def __dir__() -> List[str]:
    return __all__
