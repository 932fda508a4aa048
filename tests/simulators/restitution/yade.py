# SPDX-License-Identifier: MIT
# Head-on collisions in YADE with the text of corgen contact --for yade: of two spheres, or of one with a wall.
#     yade -x -n -j1 yade.py PASTE WALL DURATION N,N,N [PASTE WALL DURATION N,N,N]...
# prints for each N, with DURATION/(N + 1/2) as the time step in s,
#     eps PASTE N VALUE CHANGE
# CHANGE of the velocity after the contact must be 0. SI units; the bodies are those of run. WALL is 0 or 1. With
# WALL:GRAVITY:RADIUS:I:RADIUS:J the bodies are of the materials I and J, 0 or 1, whose density they have. With a gravity
# the speed is that of a ball that flies back to the wall.
import atexit
import os
import shutil
import sys

# YADE leaves an empty folder behind
atexit.register(shutil.rmtree, os.path.dirname(O.tmpFilename()), ignore_errors=True)


def collide(text, wall, step, steps, bodies):
    O.reset()
    exec(text, globals())
    materials = [cor_material, globals().get("cor_material_2", cor_material)]
    # the numbers of ViscElMat hold for two equal bodies
    equal = isinstance(cor_material, ViscElMat) and not wall
    radius, mass = ((0.008, 0.008), (0.0032, 0.0032)) if equal else ((0.005, 0.02), (0.002, 0.008))
    gravity = float(bodies.pop(0)) if bodies else 0
    if bodies:
        radius, mass = [float(r) for r in bodies[::2]], ()
    for material in materials:
        O.materials.append(material)
    first, second = [materials[int(i)] for i in bodies[1::2]] or (materials[0], materials[0 if wall else 1])
    O.bodies.append(sphere((0, 0, radius[0]), radius[0], material=first))
    O.bodies.append(
        utils.wall(0, axis=2, material=second) if wall else sphere((0, 0, -radius[1]), radius[1], material=second))
    for body, m in zip(O.bodies, mass[:1] if wall else mass):
        body.state.mass = m
    O.bodies[0].state.vel = (0, 0, -1 + gravity * step / 2)
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]), cor_contact,
        NewtonIntegrator(damping=0, gravity=(0, 0, -gravity))
    ]
    O.dt = step
    speeds = []
    for length in (int(1.3 * steps), int(0.1 * steps)):
        O.run(length, True)
        speed = O.bodies[0].state.vel[2] - O.bodies[1].state.vel[2] - gravity * step / 2 # of half a step before
        height = O.bodies[0].state.pos[2] - radius[0]
        speeds.append((speed**2 + 2 * gravity * height)**0.5 if gravity else speed)
    return speeds


arguments = sys.argv[1:]
while arguments:
    paste, wall, duration, counts = arguments[:4]
    arguments = arguments[4:]
    wall, *bodies = wall.split(":")
    for count in counts.split(","):
        step = float(duration) / (int(count) + 0.5)
        before, after = collide(open(paste).read(), wall == "1", step, int(count), bodies[:])
        print("eps %s %s %.17g %.3g" % (paste, count, after, after - before))
