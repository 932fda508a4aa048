# SPDX-License-Identifier: MIT
"""Defines the data that the parts of the audit share: a deck, which a reader returns, and a row of the report.

Numbers of a deck are in the deck's own units, which must be consistent. Units converts them. Unknown numbers are NaN.
"""

import math
from dataclasses import dataclass, field
from enum import Enum, auto
from typing import Callable, Dict, List, NamedTuple, Optional, Tuple

NAN = math.nan
ROLLS = "rolling or twisting friction also acts"
MAX_BYTES = 1 << 26  # largest size of a file
MAX_CONTACTS = 20000


class DeckError(ValueError):
    """An input that cannot be read at all. The text names the file, the error and the allowed input."""


@dataclass(frozen=True)
class Units:
    """The units of a deck in SI. With the name "lj" they are unknown, and rows are in the deck's own units."""

    name: str = "si"
    length_m: float = 1.0
    mass_kg: float = 1.0
    time_s: float = 1.0


class Spring(Enum):
    """The kinds of stiffness of a contact."""

    NONE = auto()
    HOOKE = auto()  # stiffness: K, N/m
    HERTZ = auto()  # stiffness: K/sqrt(R), Pa
    MATERIAL = auto()  # Hertz, from Young's modulus and Poisson's ratio of both bodies
    CHARACTERISTIC = auto()  # linear; LIGGGHTS: from the materials and the characteristic speed spring_speed
    CONTACT_TIME = auto()  # linear; `stiffness` is not K but the duration of a contact that ends at zero overlap
    PER_MASS = auto()  # linear; stiffness: K/m


@dataclass(frozen=True)
class Body:
    """A body of a contact: a sphere of one type or material, or a wall.

    name: the type, label or geometry, as in column `pair`. radius: least and largest. mass: least and largest, if
    density and radius do not give it (set mass, rigid bodies). wall: infinite radius and mass. held: a sphere of
    infinite mass (frozen, fixed). type: the simulator's number of the type; 0: no type. lever: 0 for a sphere;
    otherwise the result of clump(), NaN if unknown."""

    name: str
    radius: Tuple[float, float] = (NAN, NAN)
    density: float = NAN
    mass: Optional[Tuple[float, float]] = None
    young: float = NAN
    poisson: float = NAN
    wall: bool = False
    held: bool = False
    type: int = 0
    lever: Tuple[float, float] = (0.0, 0.0)


@dataclass(eq=False)
class Repair:
    """Lines `line` to `last_line` of a file, to be replaced by one text. Contacts whose numbers are in the same lines
    share one object, so that one new text repairs all of them."""

    file: str
    line: int
    last_line: int
    text: str


class Tangential(NamedTuple):
    """A tangential force. model: a name in cor_tangential_models, or the reason why cor has no model. stiffness:
    divided by the stiffness of the normal spring, or in N/m if it is constant and the normal spring is a Hertz spring.
    damper: divided by the normal damper."""

    model: str = ""
    stiffness: float = NAN
    damper: float = NAN
    friction: float = NAN


NO_FRICTION = Tangential("viscous", 0.0, 0.0, 0.0)


@dataclass
class Contact:
    """One contact of two bodies, as found by a reader.

    model: the id of a model of cor_simulators without COR_, such as "LAMMPS_HOOKE_VELOCITY". If it is "", cor does not
    support the model, and `unknown` is the reason. style: the deck's name of the model; reports prefer it to the name
    in cor_simulators. number: the model's input, which is e or a damping number. limited: the contact ends at zero
    force. zeta_factor: factor of the damping that the model computes from e. slots: parts
    [start, end) of repair.text that contain e. gravity: acceleration that presses a sphere against a wall.
    global_damping: the fraction by which YADE increases forces against the motion and decreases forces along it.
    losses: sentences about losses outside contacts. cohesion: LIGGGHTS's sjkr or sjkr2, and its energy density. notes:
    sentences for the advice. unknown: reason why eps is not computed. refused: the error
    with which the simulator stops."""

    file: str
    line: int
    simulator: str
    bodies: Tuple[Body, Body]
    model: str = ""
    style: str = ""
    pair: str = ""  # "": the pair is named after the bodies
    number: float = NAN
    spring: Spring = Spring.NONE
    stiffness: float = NAN
    spring_speed: float = NAN
    limited: bool = False
    zeta_factor: float = 1.0
    solimp: Optional[Tuple[float, ...]] = None  # MuJoCo: dmin, dmax, width, midpoint, power
    softness: float = 1.0  # MuJoCo: an argument of cor_mujoco_eps
    cohesion: Tuple[str, float] = "", 0.0
    bond: float = 0.0  # Pa; the pull that breaks a bond is this times the square of the smaller radius
    luding: Optional[Tuple[float, ...]] = None  # k1, kp, kc, G0 and PhiF of a pair
    unknown: str = ""
    refused: str = ""
    notes: List[str] = field(default_factory=list)
    losses: List[str] = field(default_factory=list)
    repair: Optional[Repair] = None
    slots: Tuple[Tuple[int, int], ...] = ()
    gravity: float = NAN
    global_damping: float = 0.0
    threshold: float = 0.0  # m/s; up to this speed eps is 0
    speeds: Tuple[float, ...] = ()
    time_step: float = NAN
    integrator: Optional[int] = None  # enum cor_integrator; None: the simulator's own
    units: Units = Units()
    runs: Tuple[int, ...] = ()  # the runs of a script with this contact, from 1; empty: a deck without runs
    tangential: Tangential = Tangential()


@dataclass(frozen=True)
class Remark:
    """A sentence about a line without a contact. matters: True if the line hides contacts that cannot be judged."""

    file: str
    line: int
    text: str
    matters: bool = True


@dataclass
class Deck:
    """The result of a reader for one input. A reader is a function of the text, its name and the options."""

    file: str
    simulator: str
    contacts: List[Contact] = field(default_factory=list)
    remarks: List[Remark] = field(default_factory=list)


def share(part: float, whole: float) -> float:
    """Returns part/whole; 0 if part is 0, and NaN for other divisions by 0."""
    return part / whole if part and whole else part and NAN


def by_restitution(model: str, e: float, e_t: float, friction: float) -> Tangential:
    """Returns the spring and damper that YADE and MercuryDPM compute from e and the tangential restitution e_t."""
    normal, along = (math.log(x) if x > 0 else NAN for x in (e, e_t))
    spring = 2 / 7 * (math.pi**2 + along**2) / (math.pi**2 + normal**2)
    return Tangential(model, spring, 2 / 7 * share(along, normal), friction)


@dataclass(frozen=True)
class Options:
    """The options of cor audit, SI. radii and densities: keyed by the name of a type or material; "" is for all others.
    include(name, of): text and name (for messages) of a file that the file `of` includes; None if it does not exist.
    variables: -var NAME VALUE..., as the simulator accepts them."""

    simulator: str = ""
    version: str = ""
    speeds: Tuple[float, ...] = ()
    radii: Dict[str, float] = field(default_factory=dict)
    densities: Dict[str, float] = field(default_factory=dict)
    time_step: float = NAN
    tolerance: float = 0.01
    variables: Dict[str, Tuple[str, ...]] = field(default_factory=dict)
    include: Callable[[str, str], Optional[Tuple[str, str]]] = lambda name, of: None
    progress: Callable[[str], None] = lambda step: None
    angle: float = NAN  # angle of oblique impacts, degrees


COLUMNS = (
    "file,line,simulator,model,pair,asked,end,speed_m_s,realised,step_bias,step_scatter,advice,realised_surface,"
    "measured,measured_small_step,tangential_restitution,units"
).split(",")


@dataclass
class Row:
    """One contact at one speed, or, with an empty model, a remark on a line. COLUMNS are the columns of csv and json.
    as_asked: True if eps agrees with the requested e; None if no e was requested or eps is unknown. judged: False
    makes the exit status 4. size: 0 if the bodies have their least radius and mass, 1 if they have the largest."""

    file: str
    line: int
    simulator: str
    model: str = ""
    pair: str = ""
    asked: float = NAN
    end: str = ""
    speed_m_s: float = NAN
    realised: float = NAN
    step_bias: float = NAN
    step_scatter: float = NAN
    advice: str = ""
    realised_surface: float = NAN
    measured: float = NAN
    measured_small_step: float = NAN
    tangential_restitution: float = NAN
    units: str = "si"
    law: str = ""
    damping: float = NAN  # zeta if eps does not depend on the speed, otherwise beta
    duration_s: float = NAN
    time_step_s: float = NAN
    as_asked: Optional[bool] = None
    judged: bool = True
    instead: str = ""  # lines that realise e and replace lines instead_line to instead_last of instead_file
    instead_file: str = ""
    instead_line: int = 0
    instead_last: int = 0
    contact: Optional[Contact] = None
    size: int = 0
