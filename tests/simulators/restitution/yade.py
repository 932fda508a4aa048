# SPDX-License-Identifier: MIT
# Head-on collisions in YADE with the text of corgen contact --for yade: of two spheres, or of one with a wall.
#     yade -x -n -j1 yade.py RUN [RUN]...        or RUNs on lines of standard input; "done" ends each answer
# Each RUN is a dict of Python. paste: the file of the text. duration: s. n: numbers of steps. Optional are wall, speed,
# g, side (tangential speed divided by speed), radius, and material, the numbers of the two materials; collide has their
# defaults. If g is given, eps is for the speed at which the ball returns to the wall. The script prints for each n,
# with duration/(n + 1/2) as the time step,
#     eps PASTE N VALUE CHANGE
# CHANGE of the velocity after the contact must be 0. SI units. The text may define before_step, commands for each step,
# and may use `step`. Without arguments the script first prints whether this YADE has vn.
import ast
import atexit
import os
import shutil
import sys

# YADE leaves an empty folder behind
atexit.register(shutil.rmtree, os.path.dirname(O.tmpFilename()), ignore_errors=True)


def collide(text, step, steps, wall=0, speed=1, g=0, side=0, radius=None, material=(0, 1)):
    O.reset()
    names = {**start, "step": step, "before_step": []}
    exec(text, names)
    globals().update(names)
    materials = [names[name] for name in sorted(names) if name.startswith("cor_material")]
    # the numbers of ViscElMat are valid for two equal bodies
    equal = isinstance(materials[0], ViscElMat) and not wall
    mass = () if radius else (0.0032, 0.0032) if equal else (0.002, 0.008)
    radius = radius or ((0.008, 0.008) if equal else (0.005, 0.02))
    for added in materials if len(O.materials) == 0 else []:
        O.materials.append(added)
    first, second = [materials[i % len(materials)] for i in material]
    O.bodies.append(sphere((0, 0, radius[0]), radius[0], material=first))
    O.bodies.append(
        utils.wall(0, axis=2, material=second) if wall else sphere((0, 0, -radius[1]), radius[1], material=second))
    for body, m in zip(O.bodies, mass[:1] if wall else mass):
        body.state.mass = m
        body.state.inertia = (0.4 * m * body.shape.radius**2, ) * 3 if side else body.state.inertia
    O.bodies[0].state.vel = (side * speed, 0, -speed + g * step / 2)
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()])] + [
        PyRunner(command=command, iterPeriod=1) for command in before_step
    ] + [cor_contact, NewtonIntegrator(damping=0, gravity=(0, 0, -g))]
    O.dt = step
    values = []
    for length in (int(1.3 * steps), int(0.1 * steps)):
        O.run(length, True)
        up = O.bodies[0].state.vel[2] - O.bodies[1].state.vel[2] - g * step / 2  # velocity half a step earlier
        height = O.bodies[0].state.pos[2] - radius[0]
        values.append(((up**2 + 2 * g * height)**0.5 if g else up) / speed)
    if side:  # u'/u of the contact point
        ends = [body.state.vel[0] - sign * getattr(body.shape, "radius", 0) * body.state.angVel[1]
                for body, sign in zip(O.bodies, (1, -1))]
        print("side %s %d %.12g" % (paste, count, (ends[0] - ends[1]) / (side * speed)))
    return values


start = dict(globals())
if len(sys.argv) == 1:
    print("vn", "yes" if hasattr(Ip2_FrictMat_FrictMat_MindlinPhys, "vn") else "no")
    print("done", flush=True)
for argument in sys.argv[1:] or sys.stdin:
    given = ast.literal_eval(argument)
    paste, duration, counts = (given.pop(name) for name in ("paste", "duration", "n"))
    for count in counts:
        before, after = collide(open(paste).read(), duration / (count + 0.5), count, **given)
        print("eps %s %d %.17g %.3g" % (paste, count, after, after - before))
    print("done", flush=True)
