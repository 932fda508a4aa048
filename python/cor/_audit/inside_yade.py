# SPDX-License-Identifier: MIT
"""Runs collisions in the user's own YADE, which executes this file. The file executes the user's script. At each O.run
it uses materials, Ip2, Law2, time step and damping of the script for a scene of two bodies without gravity.

    yade -x -n -j1 inside_yade.py FILE    FILE contains the collisions as json
"""

import builtins
import importlib
import json
import os
import subprocess
import sys
from typing import Any, Dict, List, Tuple
from unittest.mock import MagicMock

with open(sys.argv[1], encoding="utf-8") as given:
    head, *todo = json.load(given)
sys.path.insert(0, head["here"])
collision: Any = importlib.import_module("collision")

MOST_RUNS = 20
main: Dict[str, Any] = dict(vars(sys.modules["__main__"]))  # the names that YADE defines for a script
omega: Any = main["O"]


def say(**found: object) -> None:
    print("cor " + json.dumps(found), flush=True)


class Stand:
    """Replaces Omega for the user's script. It neither steps nor writes."""

    runs = 0

    def __getattr__(self, name: str) -> Any:
        if name in ("run", "step"):
            return self.at_run
        if name in ("save", "saveTmp", "wait", "pause", "exitNoBacktrace", "stopAtIter", "stopAtTime"):
            return lambda *given, **named: None
        return getattr(omega, name)

    def __setattr__(self, name: str, value: object) -> None:
        setattr(omega, name, value)

    def at_run(self, *given: object, **named: object) -> None:
        Stand.runs += 1
        collide_all()
        if Stand.runs == MOST_RUNS or all(c["done"] for c in todo):
            raise SystemExit


def no_program(*given: Any, **named: object) -> int:
    say(left_out=f"a program: {given[0] if given else ''}"[:80])
    return 0


def open_to_read(file: Any, mode: str = "r", *given: Any, **named: Any) -> Any:
    if set(mode) & set("wax+"):
        say(left_out=f"writing {file}"[:80])
        file = os.devnull
    return opened(file, mode, *given, **named)


# ---- the collisions ----


def body_of(c: Dict[str, Any], i: int) -> Any:
    """Returns a body of the script's scene with the shape and material of the collision, or None."""
    kinds = [b for b in omega.bodies if b and b.shape and b.mat and b.mat.id == c["materials"][i]]
    spheres = [b for b in kinds if type(b.shape).__name__ == "Sphere"]
    near = [b for b in spheres if abs(b.shape.radius - c["radii"][i]) < 1e-6 * b.shape.radius]
    return (near or spheres or [None])[0]


def collide_all() -> None:
    """Measures each collision whose materials interact in this run."""
    loops = [e for e in omega.engines if type(e).__name__ == "InteractionLoop"]
    newtons = [e for e in omega.engines if type(e).__name__ == "NewtonIntegrator"]
    own = {b.mat.label: b.mat for b in omega.bodies if b and b.mat and b.mat.id < 0}  # materials made by functions
    materials, dt = [*omega.materials, *own.values()], omega.dt
    if not loops or not newtons or not materials:
        return
    for c in todo:
        if c["done"] or c["runs"] and Stand.runs and Stand.runs not in c["runs"]:
            continue
        try:
            c["materials"] = [material_of(materials, name, number) for name, number in c["names"]]
        except collision.Failed as error:  # a later run may have the material
            c["late"] = str(error)
            continue
        c["done"] = True
        say(start=c["number"])
        try:
            bodies = [body_of(c, i) for i in range(2)]
            radii = [bodies[i].shape.radius if bodies[i] else c["radii"][i] for i in range(2)]
            radii[1] = 0 if c["wall"] else radii[1]
            if not radii[0] > 0:
                raise collision.Failed("the deck has no sphere of this material; give --radius")

            def collide(step: float, phase: float) -> Tuple[float, int]:
                return collide_two(c, materials, radii, loops[0], newtons[0].damping, step, phase)

            omega.switchScene()
            try:
                eps = collision.measured(collide, dt, radii[0] / c["speed"] / 2)
            finally:
                omega.resetThisScene()
                omega.switchScene()
            say(number=c["number"], eps=eps[0], eps_small_step=eps[1])
        except (collision.Failed, RuntimeError) as error:
            say(number=c["number"], reason=str(error))


def material_of(materials: List[Any], name: str, number: int) -> int:
    labels = [i for i, m in enumerate(materials) if m.label and m.label == name]
    if not labels and (number >= len(materials) or (number < 0 and name != "default material")):
        raise collision.Failed(f"no {name} exists at this run")
    return labels[-1] if labels else number % len(materials)


def collide_two(
    c: Dict[str, Any], materials: List[Any], radii: List[float], loop: Any, damping: float, dt: float, phase: float
) -> Tuple[float, int]:
    """Computes one collision. Returns eps and the number of steps until the bodies have parted."""
    omega.resetThisScene()
    for m in materials:
        omega.materials.append(m)
    functors = [main[f"Bo1_{name}_Aabb"]() for name in ("Sphere", "Facet", "Wall", "Box")]
    omega.engines = [
        main["ForceResetter"](),
        main["InsertionSortCollider"](functors),
        loop,
        main["NewtonIntegrator"](damping=damping, gravity=(0, 0, 0)),
    ]
    omega.dt = dt
    for _ in range(11):  # contacts of the first steps may be bonds
        omega.step()
    first, second = c["materials"]
    r, speed, wall = radii[0], c["speed"], c["wall"]
    gap = speed * dt * (1 + phase) + 1e-9 * r
    place = {"fixed": c["held"][0], "material": first}
    omega.bodies.append(main["sphere"]((0, 0, r + gap), r, **place))
    if wall == "facet":
        corners = [(-99 * r, -99 * r, 0), (99 * r, -99 * r, 0), (0, 99 * r, 0)]
        omega.bodies.append(main["facet"](corners, material=second))
    elif wall == "box":
        omega.bodies.append(main["box"]((0, 0, -r), (9 * r, 9 * r, r), fixed=True, material=second))
    elif wall:
        omega.bodies.append(main["utils"].wall(0, axis=2, material=second))
    else:
        omega.bodies.append(main["sphere"]((0, 0, -radii[1]), radii[1], fixed=c["held"][1], material=second))
    for body, mass in zip(omega.bodies, c["masses"]):
        if mass > 0:
            body.state.mass = mass
    one, other = [body.state for body in omega.bodies]
    held = c["held"][0], c["held"][1] or wall
    share = [0.0 if still else 1 / body.mass for body, still in zip((one, other), held)]
    one.vel, other.vel = [(0, 0, way * speed * x / sum(share)) for way, x in zip((-1, 1), share)]

    def advance(steps: int) -> Tuple[float, float]:
        for _ in range(steps):
            omega.step()
        return one.vel[2] - other.vel[2], one.pos[2] - (0 if wall else other.pos[2])

    eps, steps = collision.eps_of(advance, speed, r + radii[1])
    return float(eps), int(steps)


script, opened = head["script"], builtins.open
with open(script, encoding="utf-8") as given:
    text = given.read()
sys.argv = [script]
sys.path.insert(0, os.getcwd())
stand = Stand()
say(version=f"YADE {main['yade'].config.version}")
names = {**main, "O": stand, "Omega": lambda: stand, "__file__": script}
for module in [builtins, *sys.modules.values()]:
    if getattr(module, "__name__", "").startswith(("builtins", "yade")):
        for name, value in ("O", stand), ("Omega", lambda: stand):
            if name in vars(module):
                setattr(module, name, value)
sys.modules["yade.qt"] = MagicMock()  # so that no window of YADE opens
setattr(builtins, "open", open_to_read)
setattr(os, "system", no_program)
for name in "Popen", "run", "call", "check_call", "check_output":
    setattr(subprocess, name, no_program)
reason = ""
try:
    exec(compile(text, script, "exec"), names)
except SystemExit:
    pass
except Exception as error:
    reason = f"{type(error).__name__}: {error}"
if not reason:
    collide_all()
for late in (c for c in todo if not c["done"] and "late" in c):
    say(number=late["number"], reason=late["late"])
say(end=True, reason=reason)
