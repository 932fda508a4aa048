# SPDX-License-Identifier: MIT
"""Runs collisions in the user's own MuJoCo, with the file's options and the compiled numbers of two geoms.

    python3 inside_mujoco.py FILE    FILE contains the collisions as json
"""

import importlib
import json
import sys
from typing import Any, Dict, List, Tuple

with open(sys.argv[1], encoding="utf-8") as given:
    head, *todo = json.load(given)
sys.path.insert(0, head["here"])
collision: Any = importlib.import_module("collision")
mujoco: Any = importlib.import_module("mujoco")
RADIUS = 0.01
OPTIONS = (
    "integrator cone solver iterations tolerance impratio disableflags enableflags o_solref o_solimp o_margin".split()
)


def say(**found: object) -> None:
    print("cor " + json.dumps(found), flush=True)


def words(values: Any) -> str:
    return " ".join(f"{float(x):.17g}" for x in values)


def model_of(pair: List[int], dt: float) -> Any:
    """Returns a model of two spheres, or of one above a plane. Its numbers come from two geoms or their pair."""
    bodies = ""
    for k, geom in enumerate(pair):
        body = model.body_weldid[model.geom_bodyid[geom]]
        numbers = f'name="g{k}" solref="{words(model.geom_solref[geom])}" solimp="{words(model.geom_solimp[geom])}" '
        numbers += f'condim="{model.geom_condim[geom]}" friction="{words(model.geom_friction[geom])}" '
        numbers += f'priority="{model.geom_priority[geom]}" solmix="{float(model.geom_solmix[geom]):.17g}" '
        if body == 0:
            bodies += f'<geom type="plane" size="1 1 1" {numbers}/>'
            continue
        mass = float(model.body_mass[body]) or 1.0
        bodies += f'<body><freejoint/><geom type="sphere" size="{RADIUS}" mass="{mass:.17g}" {numbers}/></body>'
    explicit = ""
    for i in range(model.npair):
        if sorted(pair) == sorted((int(model.pair_geom1[i]), int(model.pair_geom2[i]))):
            explicit = f'<contact><pair geom1="g0" geom2="g1" solref="{words(model.pair_solref[i])}" '
            explicit += f'solimp="{words(model.pair_solimp[i])}" condim="{model.pair_dim[i]}"/></contact>'
    made = mujoco.MjModel.from_xml_string(f"<mujoco><worldbody>{bodies}</worldbody>{explicit}</mujoco>")
    for name in OPTIONS:
        if isinstance(getattr(model.opt, name, None), (int, float)):
            setattr(made.opt, name, getattr(model.opt, name))
        elif hasattr(model.opt, name):
            getattr(made.opt, name)[:] = getattr(model.opt, name)
    made.opt.gravity[:] = 0
    made.opt.timestep = dt
    return made


def collide(c: Dict[str, Any], pair: List[int], dt: float, phase: float) -> Tuple[float, int]:
    """Computes one collision. Returns eps and the number of steps until the bodies have parted."""
    made = model_of(pair, dt)
    data, two = mujoco.MjData(made), made.nq > 7
    touch = RADIUS * (2 if two else 1)
    data.qpos[2] = touch + c["speed"] * dt * (1 + phase) + 1e-9
    data.qvel[2] = -c["speed"]

    def advance(steps: int) -> Tuple[float, float]:
        for _ in range(steps):
            mujoco.mj_step(made, data)
        other = (data.qvel[8], data.qpos[9]) if two else (0.0, 0.0)
        return float(data.qvel[2] - other[0]), float(data.qpos[2] - other[1])

    eps, steps = collision.eps_of(advance, c["speed"], touch)
    return float(eps), int(steps)


model = mujoco.MjModel.from_xml_path(head["script"])
say(version=f"MuJoCo {mujoco.__version__}")
for c in todo:
    say(start=c["number"])
    pair = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, name) for name, _ in c["names"]]
    try:
        if min(pair) < 0:
            raise collision.Failed("give its geoms names")
        static = [bool(model.body_weldid[model.geom_bodyid[geom]] == 0) for geom in pair]
        pair.sort(key=lambda geom: static[pair.index(geom)] if len(set(pair)) == 2 else 0)
        dt = float(model.opt.timestep)
        eps = collision.measured(lambda step, phase: collide(c, pair, step, phase), dt, RADIUS / c["speed"] / 2)
        say(number=c["number"], eps=eps[0], eps_small_step=eps[1])
    except (collision.Failed, ValueError) as error:
        say(number=c["number"], reason=str(error))
say(end=True, reason="")
